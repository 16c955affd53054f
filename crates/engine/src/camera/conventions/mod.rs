//! The one table of conventions: handedness, axes of camera and world, NDC, orders and units of programs.
//!
//! Reading, writing, the window, `--axes`, `--ndc` and the table of the guide take their rows from here. Each row is
//! data. A new program is a row of [`Program::ALL`], and new axes are a row of [`Axes::ALL`].

mod axes;
mod ndc;
mod programs;
mod range;

pub use axes::{Axes, Toward, WorldUp};
pub use ndc::{Api, InfiniteParallel, Ndc};
pub use programs::{AngleUnit, Program};
pub use range::NdcRange;

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
