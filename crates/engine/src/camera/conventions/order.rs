//! The orders in which programs write the numbers of a matrix.

crate::worded! {
    /// The order in which the numbers of a matrix were written.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Order {
        /// Row after row.
        Rows = "rows",
        /// Column after column, or for row vectors.
        Columns = "columns",
        /// Nine numbers of R by rows, then the three of t.
        RotationThenTranslation = "rotation-translation",
        /// A quaternion w x y z, then t: COLMAP.
        WxyzThenT = "wxyz-t",
        /// A quaternion x y z w, then t.
        XyzwThenT = "xyzw-t",
        /// t, then a quaternion x y z w: TUM, glTF.
        TThenXyzw = "t-xyzw",
        /// t, then a quaternion w x y z.
        TThenWxyz = "t-wxyz",
    }
    /// The name in the output of the command line.
    pub fn name
}
