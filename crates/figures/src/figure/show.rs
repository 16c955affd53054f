//! The explanations that pictures show: the `[show]` section of a figure.

use std::collections::BTreeSet;

use glam::{DMat4, DVec2, DVec3};

use super::View;
use crate::camera::{Decomposition, Ndc, Operation, Parameters};
use crate::geometry::Ray;
use crate::stage::Stage;

/// The `[show]` section: explanations chosen or pinned in the pictures. The default shows none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Show {
    /// A stage: its input and its output.
    pub stage: Option<Stage>,
    /// The picture that shows the stage, and in whose pipeline it is. The others show the parts that belong to it.
    pub stage_of: StagePicture,
    /// Only the first share (0 … 1) of the image's triangles is painted, in the order of painting; `None` means all,
    /// with everything else.
    pub painted: Option<f64>,
    /// The canonical picture on its way from the world.
    pub step: Option<ShownStep>,
    /// A triangle on its way through the pipeline, in all pictures.
    pub triangle: Option<ShownTriangle>,
    /// Lengths, angles and coordinates that light up in the world.
    pub measure: Vec<Measured>,
    /// The object whose translation, rotation and scale are measured.
    pub measure_of: Option<String>,
    /// A point or a ray that's marked in all pictures.
    pub probe: Option<ShownProbe>,
    /// Objects at the places that lists of transforms would give them, in the world. Their axes are numbered in this
    /// order.
    pub moved: Vec<TransformPreview>,
    /// The convention of NDC of the canonical volume; `None` means that of the notes, or of the window that shows it.
    pub ndc: Option<Ndc>,
    /// A second camera, such as the one that a wrong answer describes, in the world.
    pub answer: Option<Parameters>,
    /// The operations that led to the figure's camera, in order, at most [`MOST_OPERATIONS`](Self::MOST_OPERATIONS).
    /// Each is drawn with the camera before it.
    pub operations: Vec<Operation>,
}

impl Show {
    /// The most operations that a figure shows.
    pub const MOST_OPERATIONS: usize = 8;

    /// Follows an object, or its parts, to another name.
    pub fn rename_object(&mut self, from: &str, to: &str) {
        let renamed = |name: &str| match name.strip_prefix(from) {
            Some("") => Some(to.to_owned()),
            Some(part) if part.starts_with('/') => Some(format!("{to}{part}")),
            _ => None,
        };
        if let Some(triangle) = &mut self.triangle
            && let Some(name) = renamed(&triangle.object)
        {
            triangle.object = name;
        }
        if self.measure_of.as_deref() == Some(from) {
            self.measure_of = Some(to.to_owned());
        }
        for preview in &mut self.moved {
            if preview.objects.remove(from) {
                preview.objects.insert(to.to_owned());
            }
        }
    }
}

/// The picture of a stage: the image by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct StagePicture(pub View);

impl Default for StagePicture {
    fn default() -> Self {
        Self(View::Image)
    }
}

/// The progress of the canonical picture through the steps of a decomposition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShownStep {
    /// The source of the steps.
    pub way: Decomposition,
    /// Number of steps applied, whole or between. 0 is the world, and `None`, or more than there are, means all.
    pub at: Option<f64>,
}

/// A triangle followed step by step.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShownTriangle {
    /// The name of its object.
    pub object: String,
    /// Its index in the mesh, from 0.
    pub index: u32,
    /// The step that lights up.
    pub step: TriangleStep,
    /// The pixel (i, j) of the image whose depth is tested, (0, 0) at the top left; `None` means one in its middle.
    pub pixel: Option<[u32; 2]>,
}

crate::listed! {
    /// A step of a triangle.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum TriangleStep {
        /// Object → world → view.
        #[default]
        View = "view",
        /// Is its front visible?
        Facing = "facing",
        /// View → clip, with outcodes.
        Outcodes = "outcodes",
        /// The planes cut.
        Cuts = "cuts",
        /// ÷ w.
        Divide = "divide",
        /// NDC → pixels.
        Viewport = "viewport",
        /// The pixels that it covers.
        Pixels = "pixels",
        /// The depth at one of them.
        Depth = "depth",
    }
    /// Its name in a figure file.
    pub fn name
}

impl TriangleStep {
    /// True if it concerns the pixels that the triangle covers.
    pub const fn needs_pixels(self) -> bool {
        matches!(self, Self::Pixels | Self::Depth)
    }
}

/// The target of the probe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShownProbe {
    /// A point of the world.
    World(DVec3),
    /// A point (x_p, y_p) of the view window, whose ray is shown.
    Window(DVec2),
    /// The centre of a pixel (i, j), whose ray is shown.
    Pixel([i64; 2]),
}

crate::listed! {
    /// A length or an angle of the camera.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Measure {
        /// F
        Near = "F",
        /// B
        Far = "B",
        /// D
        Distance = "D",
        /// W
        Width = "W",
        /// H
        Height = "H",
        /// W/2
        HalfWidth = "W/2",
        /// H/2
        HalfHeight = "H/2",
        /// θ
        Angle = "θ",
        /// θ/2
        HalfAngle = "θ/2",
    }
    /// Its symbol in the notes.
    pub fn symbol
}

impl Measure {
    /// True if its line is one of those of `[world] dimensions`. The others are there for an author.
    pub const fn is_among_dimensions(self) -> bool {
        !matches!(self, Self::HalfWidth | Self::HalfHeight | Self::Angle)
    }
}

/// The measure of a parameter, or of the entry of a matrix, in the world. Axes are 0 … 2, for the camera **u**, **v**,
/// **n**.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measured {
    /// A length or an angle.
    Dimension(Measure),
    /// A component of an axis of the camera along one of the world: `u_x`.
    Axis(usize, usize),
    /// −**u** · **c**: the position of the world's origin along an axis of the camera, seen from C.
    OriginAlong(usize),
    /// A coordinate of C.
    Position(usize),
    /// A coordinate of PF.
    FocalPoint(usize),
    /// A component of VUP.
    ViewUp(usize),
    /// l, r, b, t: a side of the window, from the foot of DOP.
    Side(WindowSide),
    /// A coordinate of an object's translation, along an axis of its parent.
    Translate(usize),
    /// An object's rotation about an axis.
    Rotate(usize),
    /// An object's scale along one of its own axes.
    Scale(usize),
}

impl Measured {
    /// True if it measures an object instead of the camera.
    pub const fn is_of_object(self) -> bool {
        matches!(self, Self::Translate(_) | Self::Rotate(_) | Self::Scale(_))
    }
}

/// A side of the view window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WindowSide {
    /// l
    Left,
    /// r
    Right,
    /// b
    Bottom,
    /// t
    Top,
}

/// Objects at the place that a list of transforms gives them.
#[derive(Clone, Debug, PartialEq)]
pub struct TransformPreview {
    /// The names of the objects. Without any, a cube is shown.
    pub objects: BTreeSet<String>,
    /// The map from their place in the world to the shown one.
    pub change: DMat4,
    /// The matrix that the list leads to, in the world. Its columns are the axes.
    pub world_from_frame: DMat4,
    /// The axis of their last turn.
    pub axis: Option<Ray>,
    /// True for another list, wrong on purpose.
    pub wrong: bool,
}
