//! The hover: its target, its preview, and its handles, which depend on the pointer alone. No file contains it.

use glam::{DMat4, DVec2, DVec3};

use crate::camera::{Camera, Convention, ImageSize, Operation, Projection};
use crate::figure::{Measured, ShownProbe, TriangleStep};
use crate::scene::transform::Trs;
use crate::views::View;

/// The part of the pictures of a frame that depends on the pointer alone.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hover {
    /// The target under the pointer, marked in all three pictures if nothing is pinned.
    pub probe: Option<Probe>,
    /// The operation that the user is trying, shown in the world.
    pub ghost: Option<Ghost>,
    /// The handle under the pointer, drawn stronger, in the world.
    pub hovered: Option<Handle>,
    /// The gizmo that moves, turns or scales the selection, in the world.
    pub gizmo: Option<TransformGizmo>,
    /// The target in a panel. These lengths, angles and coordinates are shown in the world.
    pub measured: Vec<Measured>,
    /// The object whose parts the pointer is on.
    pub object: Option<ObjectTransform>,
}

impl Hover {
    /// The part of it that a picture shows.
    #[must_use]
    pub fn seen_in(&self, view: View) -> Self {
        match view {
            View::World => self.clone(),
            View::Canonical | View::Image => Self { probe: self.probe, ..Self::default() },
        }
    }
}

/// The transform of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectTransform {
    /// The transform of its parent.
    pub world_from_parent: DMat4,
    /// The transform of the object itself, in its parent.
    pub trs: Trs,
}

/// A triangle followed step by step, as the pictures show it. Points are in world space.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleOverlay {
    /// The highlighted step.
    pub step: TriangleStep,
    /// Its corners, a, b, c.
    pub corners: [DVec3; 3],
    /// True for corners outside a plane.
    pub outside: [bool; 3],
    /// The rest of it after clipping, with the names of its corners.
    pub left: Vec<(char, DVec3)>,
    /// Rows of pixels of the image, m × n, that it covers: j, the first i and the one after the last.
    pub rows: Vec<[u32; 3]>,
    /// The pixel whose depth is tested.
    pub pixel: Option<[u32; 2]>,
}

/// The places where the shadow maps of an image are wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum ShadowTruth {
    /// Compared with rays.
    Found {
        /// Runs of wrong pixels of the image, m × n: row, the first column, and the one after the last.
        rows: Vec<[u32; 3]>,
        /// Number of pixels compared with rays, on faces turned to a light that casts shadows.
        of: usize,
    },
    /// The image has too many pixels for that, or the scene too many triangles.
    TooMuch,
}

impl ShadowTruth {
    /// Number of wrong pixels.
    pub fn wrong(&self) -> usize {
        match self {
            Self::Found { rows, .. } => rows.iter().map(|[_, first, after]| (after - first) as usize).sum(),
            Self::TooMuch => 0,
        }
    }
}

/// A value for each pixel of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct CostMap {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Row by row. A pixel with 0 isn't tinted. Empty if there's no exact image.
    pub values: Vec<f32>,
    /// The share of fills that are painted over, 0 … 1, and the same from front to back if a depth buffer sorts faces.
    pub painted_over: (f64, Option<f64>),
}

impl CostMap {
    /// The greatest of them.
    pub(in crate::views) fn greatest(&self) -> f32 {
        self.values.iter().copied().fold(0.0, f32::max)
    }
}

/// A projector of one camera, as another camera of the figure sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projector {
    /// Its origin, and its end in the back plane or beyond the point, world.
    pub ends: [DVec3; 2],
    /// The projection it belongs to. In perspective its origin is C.
    pub projection: Projection,
    /// The marked point on it.
    pub point: Option<DVec3>,
}

/// The target of the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Probe {
    /// A point of the world, such as a vertex.
    Point(DVec3),
    /// A point (x_p, y_p) of the view window, such as the centre of a pixel. Its ray is shown.
    Window(DVec2),
}

impl Probe {
    /// The probe of a figure for a camera with an image of this size.
    pub fn of(shown: ShownProbe, camera: &Camera, image: ImageSize) -> Self {
        match shown {
            ShownProbe::World(p) => Self::Point(p),
            ShownProbe::Window(p) => Self::Window(p),
            ShownProbe::Pixel([i, j]) => {
                let center = DVec2::new(i as f64, j as f64) + 0.5;
                Self::Window(image.window_from_image(&camera.window(), center))
            }
        }
    }
}

/// An operation and the camera before it. The camera after it is the one of the [`Request`](crate::views::Request).
#[derive(Clone, Debug, PartialEq)]
pub struct Ghost {
    /// The camera before.
    pub before: Camera,
    /// The operation that leads to the camera after it.
    pub operation: Operation,
    /// The sign rule of rotations.
    pub convention: Convention,
}

impl Ghost {
    /// The operations that led to a camera, in order, each with the camera before it and the one after it. The signs
    /// are those of the notes. The list starts after the last operation before which no camera is possible.
    pub fn leading_to(camera: &Camera, operations: &[Operation]) -> Vec<(Self, Camera)> {
        let convention = Convention::RightHand;
        let mut after = camera.clone();
        let mut led = Vec::with_capacity(operations.len());
        for &operation in operations.iter().rev() {
            let Ok(before) = operation.inverse().apply(&after, convention) else { break };
            led.push((Self { before: before.clone(), operation, convention }, std::mem::replace(&mut after, before)));
        }
        led.reverse();
        led
    }
}

/// A handle for dragging in the world.
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

/// The mode of a [`TransformGizmo`]. The letters are those of the fields.
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

/// The placement of the gizmo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransformGizmo {
    /// Translation, rotation or scale.
    pub does: Transforming,
    /// Its middle (world).
    pub origin: DVec3,
    /// Its axes (world), unit vectors, which may not be at right angles.
    pub axes: [DVec3; 3],
    /// The part under the pointer, drawn stronger.
    pub hovered: Option<GizmoPart>,
}

/// A part of a [`TransformGizmo`] for dragging.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GizmoPart {
    /// The part of an axis: 0 is x.
    Axis(usize),
    /// The middle.
    Middle,
}
