//! A figure → the scene that each of the three pictures shows, and its observer.
//!
//! There is one engine: the image is the scene seen by the figure's camera, the world is the scene with the camera's own gear
//! seen by a second camera (the observer), and the canonical volume is the scene after clipping and projection, seen by a
//! third. All three go through [`Pipeline::frame`].
//!
//! | picture | space of its scene | observer |
//! | --- | --- | --- |
//! | `image` | world | the figure's camera |
//! | `world` | world | [`Observer`](crate::figure::Observer) |
//! | `canonical` | ndc, shown as (x_n, y_n, −z_n), which is right-handed | [`Observer`](crate::figure::Observer) |

pub mod arrows;
mod canonical;
mod content;
pub mod depth;
mod ghost;
mod gizmos;
pub mod handles;
pub mod image;
mod legend;
pub mod observer;
pub mod palette;
pub mod pick;
mod placing;
mod probe;
mod request;
mod reveal;
mod screen;
mod view;
mod world;

use std::sync::Arc;
use std::time::Duration;

use glam::{DVec2, DVec3};

use crate::appearance::{Rgba, Style, Texture};
use crate::camera::{Camera, Convention, Operation};
use crate::figure::Figure;
use crate::pipeline::{Frame, Options, Pipeline, Target};
use crate::scene::{self, ReadFile, Scene, SceneError};
pub use arrows::Arrows;
pub use handles::Handle;
pub use palette::Palette;
pub use request::{Look, Overlays, Request, SharedScene, observer_in};
pub use view::{View, Views};

/// The size of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Pixels for one unit of stroke width or type size: 1 on a plain screen, 2 where pixels are small or in a large export.
    pub scale: f32,
}

impl Size {
    /// Width / height; 1 for an empty picture.
    #[must_use]
    pub fn aspect(&self) -> f64 {
        if self.width == 0 || self.height == 0 { 1.0 } else { f64::from(self.width) / f64::from(self.height) }
    }

    /// Letters and strokes grow a little with the picture, so that a large one is not full of threads and a small one not
    /// full of letters.
    fn target(self, background: Rgba) -> Target {
        #[expect(clippy::cast_precision_loss, reason = "pixels")]
        let (width, height) = (self.width as f32, self.height as f32);
        let side = height.min(0.8 * width) / self.scale.max(0.1);
        let growth = (side / 480.0).powf(0.4).clamp(0.8, 1.6);
        Target { width: self.width, height: self.height, scale: self.scale * growth, background }
    }
}

/// The few words in the pictures; symbols (C, PF, u, v, n …) are the same in every language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Labels {
    /// The view window.
    pub window: &'static str,
    /// The front face of the volume.
    pub near: &'static str,
    /// The back face of the volume.
    pub far: &'static str,
    /// The camera before an operation.
    pub before: &'static str,
    /// Heading of a picture of Z.
    pub depth_stored: &'static str,
    /// Heading of a picture of distances.
    pub depth_linear: &'static str,
    /// Where a picture of depths has none.
    pub nothing: &'static str,
    /// Parts outside the view volume.
    pub outside: &'static str,
    /// Vertices that clipping makes.
    pub cuts: &'static str,
    /// Faces that are culled because they turn their back.
    pub back_faces: &'static str,
    /// Objects that are culled because they are outside.
    pub dropped: &'static str,
    /// Before the planes outside of which an object is.
    pub outside_of: &'static str,
    /// The planes: left, right, bottom, top, near, far.
    pub planes: [&'static str; 6],
    /// The divide comes before clipping.
    pub divided_first: &'static str,
    /// What comes of it, where anything is behind the eye.
    pub wrong: &'static str,
    /// What comes of it otherwise.
    pub no_difference: &'static str,
}

/// What is pointed at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Probe {
    /// A point of the world, such as a vertex.
    Point(DVec3),
    /// A point (x_p, y_p) of the view window, such as the centre of a pixel: its ray is shown.
    Window(DVec2),
}

/// An operation and the camera before it; the camera after it is the one of the [`Request`].
#[derive(Clone, Debug, PartialEq)]
pub struct Ghost {
    /// The camera before.
    pub before: Camera,
    /// What is done to it.
    pub operation: Operation,
    /// The sign rule of rotations.
    pub convention: Convention,
}

/// What draws: the pipeline, with buffers that serve one picture after the other, and a clock for who wants to know how long
/// each stage takes.
#[derive(Clone, Debug, Default)]
pub struct Engine {
    /// The stages.
    pub pipeline: Pipeline,
    /// The time since any moment that stays the same. Without it nothing is timed.
    pub clock: Option<fn() -> Duration>,
}

impl Engine {
    /// Sends what a picture shows through the pipeline.
    fn frame(&mut self, request: &Request, scene: &Scene, camera: &Camera, target: Target, style: &Style) -> Frame {
        let options = Options { force_all_stages: request.force_all_stages, clock: self.clock };
        self.pipeline.frame(scene, camera, target, style, options)
    }
}

/// Draws a picture, and tells what was done. `on_window` is the image that the view window of the world shows:
/// [`Request::image_on_window`] as pixels; without it the window is plain.
#[must_use]
pub fn frame(request: &Request, on_window: Option<&Arc<Texture>>, engine: &mut Engine) -> Frame {
    match request.view {
        View::World => world::frame_of(request, on_window, engine),
        View::Canonical => canonical::frame_of(request, engine),
        View::Image => image::frame_of(request, engine),
    }
}

/// The scene of a figure in the colours of its theme, with hidden edges as its style wants them.
///
/// # Errors
/// [`SceneError`] names the object and what is wrong with it.
pub fn scene_of(figure: &Figure, read_file: &mut ReadFile<'_>) -> Result<Scene, SceneError> {
    scene::build(&figure.scene, &figure.style, read_file)
}
