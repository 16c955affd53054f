//! What comes and goes with the pointer: what is pointed at, tried, and can be dragged.

use std::collections::BTreeSet;
use std::sync::Arc;

use glam::{DMat4, DVec2, DVec3};

use super::View;
use crate::camera::{Camera, Convention, Operation};
use crate::geometry::Ray;
use crate::scene::transform::Trs;

/// What comes and goes with the pointer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlays {
    /// What is pointed at, marked in all three pictures.
    pub probe: Option<Probe>,
    /// The operation that is being tried, shown in the world.
    pub ghost: Option<Ghost>,
    /// The camera that an answer describes, shown in the world.
    pub answered: Option<Camera>,
    /// The handle under the pointer, drawn stronger, in the world.
    pub hot: Option<Handle>,
    /// By this what is selected can be moved, turned or scaled, in the world.
    pub gizmo: Option<TransformGizmo>,
    /// What is pointed at in a panel: these lengths, angles and coordinates are shown in the world.
    pub measured: Vec<Measured>,
    /// The object of which parts may be pointed at.
    pub object: Option<ObjectTransform>,
    /// Objects where transforms would put them, in the world; their axes are numbered in this order.
    pub placed: Vec<Placed>,
    /// A triangle that is followed step by step, in all three pictures.
    pub stepped: Option<Arc<Stepped>>,
    /// Without texts and legends: the picture is painted on something.
    pub bare: bool,
    /// Without ground: what is behind the picture shows through.
    pub transparent: bool,
    /// What the widths of strokes are multiplied by; `None`: they are in proportion to the letters.
    pub stroke_factor: Option<f32>,
}

impl Overlays {
    /// Those that a picture shows.
    #[must_use]
    pub fn seen_in(&self, view: View) -> Self {
        match view {
            View::World => self.clone(),
            View::Canonical | View::Image => {
                let base = self.clone();
                let base = Self { measured: Vec::new(), object: None, placed: Vec::new(), ..base };
                Self { ghost: None, answered: None, hot: None, gizmo: None, ..base }
            }
        }
    }
}

/// A length or an angle of the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measure {
    /// F
    Near,
    /// B
    Far,
    /// D
    Distance,
    /// W
    Width,
    /// H
    Height,
    /// θ/2
    HalfAngle,
}

impl Measure {
    /// All.
    pub const ALL: [Self; 6] = [Self::Near, Self::Far, Self::Distance, Self::Width, Self::Height, Self::HalfAngle];
}

/// What a parameter, or the entry of a matrix, measures in the world. Axes are 0 … 2: of the camera **u**, **v**, **n**.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measured {
    /// A length or an angle.
    Dimension(Measure),
    /// A component of an axis of the camera along one of the world: `u_x`.
    Axis(usize, usize),
    /// −**u** · **c**: where the world's origin is along an axis of the camera, seen from C.
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

/// The transform of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectTransform {
    /// What its parent does to it.
    pub world_from_parent: DMat4,
    /// Its own.
    pub trs: Trs,
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

/// A triangle that is followed step by step. Points are of the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Stepped {
    /// Which step lights up.
    pub step: TriangleStep,
    /// Its corners, a, b, c.
    pub corners: [DVec3; 3],
    /// Those of them that are outside of a plane.
    pub outside: [bool; 3],
    /// What clipping leaves of it, with the names of its corners.
    pub left: Vec<(char, DVec3)>,
    /// Rows of pixels of the image, m × n, that it covers: j, the first i and the one after the last.
    pub rows: Vec<[u32; 3]>,
    /// The pixel of which the depth is tested.
    pub pixel: Option<[u32; 2]>,
}

/// A step of a triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TriangleStep {
    /// Object → world → view.
    #[default]
    View,
    /// Is it seen from its front?
    Facing,
    /// View → clip, with outcodes.
    Outcodes,
    /// The planes cut.
    Cuts,
    /// ÷ w.
    Divide,
    /// NDC → pixels.
    Viewport,
    /// The pixels that it covers.
    Pixels,
    /// The depth at one of them.
    Depth,
}

impl TriangleStep {
    /// All, in order.
    pub const ALL: [Self; 8] =
        [Self::View, Self::Facing, Self::Outcodes, Self::Cuts, Self::Divide, Self::Viewport, Self::Pixels, Self::Depth];
}

/// What is pointed at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Probe {
    /// A point of the world, such as a vertex.
    Point(DVec3),
    /// A point (x_p, y_p) of the view window, such as the centre of a pixel: its ray is shown.
    Window(DVec2),
}

/// An operation and the camera before it; the camera after it is the one of the [`Request`](super::Request).
#[derive(Clone, Debug, PartialEq)]
pub struct Ghost {
    /// The camera before.
    pub before: Camera,
    /// What is done to it.
    pub operation: Operation,
    /// The sign rule of rotations.
    pub convention: Convention,
}

/// Objects where a list of transforms puts them.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The names of the objects; without any, a cube is shown.
    pub objects: BTreeSet<String>,
    /// What takes them there from where they are in the world.
    pub change: DMat4,
    /// The matrix that the list leads to, in the world: its columns are the axes.
    pub world_from_frame: DMat4,
    /// About what they have turned last.
    pub axis: Option<Ray>,
    /// By another list, on purpose.
    pub wrong: bool,
}

/// Something that can be dragged in the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handle {
    /// C
    Position,
    /// PF
    FocalPoint,
    /// The tip of VUP.
    ViewUp,
    /// The front face.
    Near,
    /// The back face.
    Far,
}

/// What a [`TransformGizmo`] does; the letters are those of the fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Transforming {
    /// Three arrows move (T).
    #[default]
    Move,
    /// Three rings turn (R).
    Turn,
    /// Three bars scale (S), and their middle scales in all directions.
    Scale,
}

/// Where the gizmo stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransformGizmo {
    /// What it does.
    pub does: Transforming,
    /// Its middle (world).
    pub origin: DVec3,
    /// Its axes (world), unit vectors; they need not be at right angles.
    pub axes: [DVec3; 3],
    /// The part under the pointer, drawn stronger.
    pub hot: Option<GizmoPart>,
}

/// What can be taken of a [`TransformGizmo`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GizmoPart {
    /// That of an axis: 0 is x.
    Axis(usize),
    /// The middle.
    Middle,
}
