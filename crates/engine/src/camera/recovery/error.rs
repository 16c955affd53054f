//! The reasons why a matrix isn't that of a camera.

use glam::DVec4;

use crate::camera::{CameraError, Ndc};

/// The lines of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines {
    /// From left to right.
    Rows,
    /// From top to bottom.
    Columns,
}

impl Lines {
    const fn plural(self) -> &'static str {
        match self {
            Self::Rows => "rows",
            Self::Columns => "columns",
        }
    }

    const fn singular(self) -> &'static str {
        match self {
            Self::Rows => "row",
            Self::Columns => "column",
        }
    }
}

/// The reason why a matrix isn't that of a camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RecoveryError {
    /// An entry isn't a finite number.
    #[error("entry {row},{column} is {value}, which isn't a finite number")]
    NotFinite {
        /// NaN or an infinity.
        value: f64,
        /// From 1.
        row: usize,
        /// From 1.
        column: usize,
    },
    /// The last row fits neither projection.
    #[error("the last row is {0}; a camera's is 0 0 0 1 (view, parallel) or, with its factor taken out, −n and n·c (perspective: 0 0 −1 0)", row(*.last))]
    LastRow {
        /// The last row of the matrix.
        last: DVec4,
    },
    /// Axes that must be perpendicular aren't.
    #[error("{} {a} and {b} are not perpendicular (the cosine between them is {cosine:.2e}): a shear, which no camera has", .lines.plural())]
    Shear {
        /// The lines that hold the axes.
        lines: Lines,
        /// From 1.
        a: usize,
        /// From 1.
        b: usize,
        /// The cosine of the angle.
        cosine: f64,
    },
    /// A row that must have the length 1 has another length.
    #[error("row {row} has length {length}; the rows of a view matrix are unit vectors")]
    Length {
        /// From 1.
        row: usize,
        /// The length of that row.
        length: f64,
    },
    /// An entry that must be zero isn't.
    #[error("entry {row},{column} is {value}; in a projection matrix it is 0")]
    NotZero {
        /// From 1.
        row: usize,
        /// From 1.
        column: usize,
        /// The value of the entry.
        value: f64,
    },
    /// The image is mirrored.
    #[error("it mirrors: left and right, or up and down, are exchanged, which no camera does")]
    Mirrored,
    /// A line is zero.
    #[error("{} {at} is zero: the matrix is singular", .lines.singular())]
    Singular {
        /// Rows or columns.
        lines: Lines,
        /// From 1.
        at: usize,
    },
    /// **u** and **v** have no length.
    #[error("{} {a} and {b} are zero: u and v have no length, as in a look-at whose VUP lies along the view; the matrix is singular", .lines.plural())]
    ViewUpAlongView {
        /// Rows or columns.
        lines: Lines,
        /// From 1.
        a: usize,
        /// From 1.
        b: usize,
    },
    /// The determinant is zero, but no line is.
    #[error("the determinant is 0: the matrix is singular, so points that differ would have the same image and depth")]
    Determinant,
    /// The numbers of K are no pixels.
    #[error(
        "as K [R | t], f would be {focal_length:.4} and the principal point ({x:.4}, {y:.4}): no pixels of an image"
    )]
    NoPixels {
        /// `f_x`
        focal_length: f64,
        /// `c_x`
        x: f64,
        /// `c_y`
        y: f64,
    },
    /// Nine numbers are neither K nor a look-at.
    #[error(
        "nine numbers are K, whose rows are f_x s c_x, 0 f_y c_y and 0 0 1, or C, PF and VUP; these are a rotation, whose t is missing"
    )]
    RotationAlone,
    /// The last column of K must be followed by 1, and the entries below its diagonal are 0.
    #[error("entry {row},{column} is {value}; in K it is {expected}")]
    NotIntrinsics {
        /// From 1.
        row: usize,
        /// From 1.
        column: usize,
        /// The value of the entry.
        value: f64,
        /// 0 or 1.
        expected: f64,
    },
    /// The axes have another hand than those of the reading.
    #[error("the axes are {}-handed there, which those of {} aren't", if *.left { "left" } else { "right" }, .title)]
    Hand {
        /// The hand of the matrix.
        left: bool,
        /// The programs of the reading.
        title: &'static str,
    },
    /// Seven numbers without a unit quaternion.
    #[error(
        "seven numbers are a quaternion and t, or t and a quaternion; neither the first nor the last four have length 1"
    )]
    Quaternion,
    /// Pixels that are parallelograms.
    #[error("K has a skew of {skew:.4} (f_x is {focal_length:.4}): its pixels are parallelograms, which no window has")]
    Skew {
        /// The second entry of K.
        skew: f64,
        /// `f_x`
        focal_length: f64,
    },
    /// The third row of K \[R | t\] holds no axis.
    #[error("the row of the depth is 0 0 0 w: an affine camera, whose centre is at infinity")]
    Affine,
    /// Near and far come out impossible in the convention.
    #[error("near and far would be {near} and {far}, which must be 0 < near < far (in parallel projection near < far){}", .fits.map_or_else(String::new, |ndc| format!("; read as {} it is a camera", ndc.name())))]
    Depths {
        /// F
        near: f64,
        /// B
        far: f64,
        /// A convention in which it would be a camera.
        fits: Option<Ndc>,
    },
    /// A matrix from disparities to points.
    #[error("it takes a pixel and its disparity to a point (Q of stereoRectify), which no camera does; paste P1 or P2")]
    Disparity,
    /// A part of a text that can't be read.
    #[error(transparent)]
    Unread(#[from] MatrixTextError),
    /// The result isn't a camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
}

fn row(v: DVec4) -> String {
    format!("{} {} {} {}", v.x, v.y, v.z, v.w)
}

/// The reason why a text holds no camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MatrixTextError {
    /// Another count of numbers, none of them with a known name.
    #[error(
        "{0} numbers, and no name says what they are; without names it reads 16 numbers (a matrix), 12 (K [R | t], or R and t), 9 (K, or C, PF and VUP) or 7 (a quaternion and t); the guide “Cameras of other programs” lists the files and names that it reads"
    )]
    Count(usize),
    /// Numbers that the program left out when it printed them.
    #[error("“...” stands for numbers that were left out; print all of them")]
    Elided,
    /// A file of a known format without a camera.
    #[error("no camera in it; {0} has none of the keys of a camera")]
    NoCamera(&'static str),
    /// Matrices of LaTeX.
    #[error("LaTeX with several matrices can't be read; paste the numbers of M_v, or of M_p, alone")]
    Latex,
    /// Names that are known, but that give no camera together.
    #[error(
        "{} can't be read as a camera: a pose needs a position and its directions, R and t, or a quaternion and t; the guide “Cameras of other programs” lists the names that it reads", crate::sanitize::escaped(.0)
    )]
    Incomplete(String),
    /// A matrix of another kind.
    #[error("{} is no matrix of a camera by its name; paste K, R and t, or a view or projection matrix", crate::sanitize::escaped(.0))]
    NotCamera(String),
    /// A number that no lens has.
    #[error("{} is {value}; allowed: {allowed}", crate::sanitize::escaped(.name))]
    Range {
        /// As it stands in the text.
        name: String,
        /// Its value.
        value: f64,
        /// The allowed range, in symbols.
        allowed: &'static str,
    },
    /// A file that isn't text.
    #[error("it is neither text nor GLB")]
    NotText,
}
