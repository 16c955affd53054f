//! What comes and goes with the pointer: what is pointed at, tried, and can be dragged.

use glam::{DVec2, DVec3};

use super::View;
use crate::camera::{Camera, Convention, Operation};

/// What comes and goes with the pointer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overlays {
    /// What is pointed at, marked in all three pictures.
    pub probe: Option<Probe>,
    /// The operation that is being tried, shown in the world.
    pub ghost: Option<Ghost>,
    /// The handle under the pointer, drawn stronger, in the world.
    pub hot: Option<Handle>,
    /// What is selected can be moved by these, in the world.
    pub arrows: Option<Arrows>,
    /// Without legends: the picture is painted on something.
    pub bare: bool,
}

impl Overlays {
    /// Those that a picture shows.
    #[must_use]
    pub fn seen_in(&self, view: View) -> Self {
        match view {
            View::World => self.clone(),
            View::Canonical | View::Image => Self { ghost: None, hot: None, arrows: None, ..self.clone() },
        }
    }
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

/// Where the arrows stand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrows {
    /// Where they begin (world).
    pub origin: DVec3,
    /// Where they point (world), unit vectors; they need not be at right angles.
    pub axes: [DVec3; 3],
    /// The one under the pointer, drawn stronger.
    pub hot: Option<usize>,
}
