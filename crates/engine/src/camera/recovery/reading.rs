//! How a matrix of another program is read: what it does, and in whose axes.

use crate::camera::{ImageSize, Ndc};

/// The kind of a pasted matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixKind {
    /// M_v, from the world to the camera.
    View,
    /// The inverse of M_v: `matrix_world` of Blender, a node of glTF, `matrixWorld` of three.js.
    CameraToWorld,
    /// M_p
    Projection,
    /// M_p M_v
    ViewProjection,
    /// K \[R | t\] of computer vision, from the world to pixels; it may be padded to four rows.
    Pinhole,
}

impl MatrixKind {
    /// All, in the order in which they are listed.
    pub const ALL: [Self; 5] = [Self::View, Self::CameraToWorld, Self::Projection, Self::ViewProjection, Self::Pinhole];

    /// The name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::View => "view",
            Self::CameraToWorld => "camera-to-world",
            Self::Projection => "projection",
            Self::ViewProjection => "view-projection",
            Self::Pinhole => "pinhole",
        }
    }

    /// Whether it is written in axes of the camera that programs choose differently.
    #[must_use]
    pub const fn has_camera_axes(self) -> bool {
        matches!(self, Self::View | Self::CameraToWorld)
    }

    /// Whether it holds C and the axes of the camera, and so is written in axes of a world.
    #[must_use]
    pub const fn has_pose(self) -> bool {
        !matches!(self, Self::Projection)
    }
}

/// Whose axes the camera and the world have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Axes {
    /// OpenGL, glTF, three.js, and `[0]`: x to the right, y up, z towards the viewer; y is up in the world.
    #[default]
    OpenGl,
    /// Blender: the camera as in OpenGL; z is up in the world.
    Blender,
    /// `OpenCV`: x to the right, y down, z into the scene; the world is taken as it is.
    OpenCv,
}

impl Axes {
    /// All, in the order in which they are listed.
    pub const ALL: [Self; 3] = [Self::OpenGl, Self::Blender, Self::OpenCv];

    /// The name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::OpenGl => "opengl",
            Self::Blender => "blender",
            Self::OpenCv => "opencv",
        }
    }
}

/// How a matrix is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// The kind of the matrix.
    pub kind: MatrixKind,
    /// Whose axes: those of the camera where the kind has some, and those of the world.
    pub axes: Axes,
    /// The convention of its NDC; counts for M_p and M_p M_v.
    pub ndc: Ndc,
    /// The image that its pixels are of; counts for K \[R | t\].
    pub image: ImageSize,
}

impl Reading {
    /// A kind in the axes and the NDC of `[0]`.
    #[must_use]
    pub fn of(kind: MatrixKind) -> Self {
        Self { kind, axes: Axes::default(), ndc: Ndc::default(), image: ImageSize::default() }
    }
}
