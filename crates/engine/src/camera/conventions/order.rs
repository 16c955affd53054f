//! The orders in which programs write the numbers of a matrix.

/// The order in which the numbers of a matrix were written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// Row after row.
    Rows,
    /// Column after column, or for row vectors.
    Columns,
    /// Nine numbers of R by rows, then the three of t.
    RotationThenTranslation,
    /// A quaternion w x y z, then t: COLMAP.
    WxyzThenT,
    /// A quaternion x y z w, then t.
    XyzwThenT,
    /// t, then a quaternion x y z w: TUM, glTF.
    TThenXyzw,
    /// t, then a quaternion w x y z.
    TThenWxyz,
}

impl Order {
    /// The name in the output of the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rows => "rows",
            Self::Columns => "columns",
            Self::RotationThenTranslation => "rotation-translation",
            Self::WxyzThenT => "wxyz-t",
            Self::XyzwThenT => "xyzw-t",
            Self::TThenXyzw => "t-xyzw",
            Self::TThenWxyz => "t-wxyz",
        }
    }
}
