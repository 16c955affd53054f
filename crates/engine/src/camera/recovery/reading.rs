//! The reading of a matrix of another program: its task, its axes and its normalised device coordinates.

use crate::camera::{Axes, ImageSize, NdcRange};

crate::listed! {
    /// The kind of a pasted matrix.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum MatrixKind {
        /// M_v, from the world to the camera.
        View = "view",
        /// The inverse of M_v: `matrix_world` of Blender, a node of glTF, `matrixWorld` of three.js.
        CameraToWorld = "camera-to-world",
        /// M_p
        Projection = "projection",
        /// M_p M_v
        ViewProjection = "view-projection",
        /// K \[R | t\] of computer vision, from the world to pixels. It may be padded to four rows.
        Pinhole = "pinhole",
        /// K alone: focal lengths and principal point in pixels.
        Intrinsics = "intrinsics",
        /// Three points and vectors: C, PF and VUP.
        LookAt = "look-at",
    }
    /// The name on the command line.
    pub fn name
}

impl MatrixKind {
    /// True if it's written in axes of the camera that programs choose differently.
    pub const fn has_camera_axes(self) -> bool {
        matches!(self, Self::View | Self::CameraToWorld)
    }

    /// True if it holds C and the axes of the camera, and so is written in axes of a world.
    pub const fn has_pose(self) -> bool {
        !matches!(self, Self::Projection | Self::Intrinsics)
    }

    /// True if it leads to normalised device coordinates.
    pub const fn has_ndc(self) -> bool {
        matches!(self, Self::Projection | Self::ViewProjection)
    }

    /// True if it holds pixels.
    pub const fn has_pixels(self) -> bool {
        matches!(self, Self::Pinhole | Self::Intrinsics)
    }
}

/// How a matrix is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The kind of the matrix.
    pub kind: MatrixKind,
    /// The program's axes: those of the camera if the kind has some, and those of the world.
    pub axes: Axes,
    /// Its NDC. Counts for M_p and M_p M_v.
    pub ndc: NdcRange,
    /// The image that its pixels are of. Counts for K.
    pub image: ImageSize,
}

impl Reading {
    /// A kind in the axes and the NDC of `[0]`.
    pub fn of(kind: MatrixKind) -> Self {
        Self { kind, axes: Axes::default(), ndc: NdcRange::default(), image: ImageSize::default() }
    }

    /// The hand of the axes in which it is written: of the world, or of the camera in M_p.
    pub fn is_left_handed(&self) -> bool {
        if self.kind == MatrixKind::Projection {
            let [down, forward] = self.axes.signs();
            down * forward < 0.0
        } else {
            self.axes.left_handed
        }
    }
}

/// The part of a reading that is stated. `None` means it is recognised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stated {
    /// The kind of the matrix.
    pub kind: Option<MatrixKind>,
    /// The program whose axes it's in.
    pub axes: Option<Axes>,
    /// It's written by columns, or for row vectors. If `kind` is open too, `false` leaves it open.
    pub by_columns: bool,
    /// The NDC that a projection leads to; `None` leaves them open.
    pub ndc: Option<NdcRange>,
    /// The image that its pixels are of.
    pub image: ImageSize,
}
