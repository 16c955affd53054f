//! A figure → the scene that each of the three pictures shows, and its observer.
//!
//! There is one engine: the image is the scene seen by the figure's camera, the world is the scene with the camera's
//! own gear seen by a second camera (the observer), and the canonical volume is the scene after clipping and
//! projection, seen by a third. All three go through [`Pipeline::frame`](crate::pipeline::Pipeline::frame).
//!
//! | picture | space of its scene | observer |
//! | --- | --- | --- |
//! | `image` | world | the figure's camera |
//! | `world` | world | [`Observer`] |
//! | `canonical` | ndc, shown as (x_n, y_n, −z_n), which is right-handed; in other conventions as deep as they are | [`Observer`] |

mod arrangement;
mod camera_gizmo;
mod canonical;
mod canonical_box;
mod components;
mod coverage_grid;
pub mod depth;
mod dimensions;
mod framing;
mod ghost;
mod gizmos;
pub mod handles;
mod hits;
mod hover;
mod image;
mod label_layout;
mod labels;
mod legend;
pub mod named_points;
mod normalizing;
mod object_parts;
pub mod observer;
mod offscreen_arrows;
pub mod palette;
mod partial_paint;
pub mod pick;
mod pixels;
mod probe;
mod request;
mod revealed_scene;
mod screen;
mod section;
mod shot;
mod stage_overlay;
mod timed_pipeline;
pub mod transform_gizmo;
mod transform_preview;
mod triangle_overlay;
mod vanishing;
mod volume;
mod world;
mod world_framing;

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::appearance::Texture;
use crate::figure::{Figure, Observer};
pub use crate::figure::{View, Views};
use crate::pipeline::Frame;
use crate::progress::Progress;
use crate::scene::{self, MeshFiles, ReadFile, Scene, SceneError};
pub use arrangement::{Arrangement, aspect_shown, used_area};
pub use hover::{
    Ghost, GizmoPart, Handle, Hover, ObjectTransform, Probe, TransformGizmo, Transforming, TriangleOverlay,
};
pub use labels::Labels;
use observer::Viewpoint;
pub use palette::Palette;
pub use pixels::{PixelRect, Size, image_frame};
pub use request::{Finish, Normalizing, Request, SharedScene, observer_in};
pub use shot::{Look, Shot};
pub use timed_pipeline::TimedPipeline;

/// Draws a picture, and reports. `on_window` is the image that the view window of the world shows:
/// [`Request::image_on_window`] as pixels; without it the window is plain.
#[must_use]
pub fn frame(request: &Request, on_window: Option<&Arc<Texture>>, pipeline: &mut TimedPipeline) -> Frame {
    let mut frame = match request.view {
        View::World => world::frame_of(request, on_window, pipeline),
        View::Canonical => normalizing::frame_of(request, pipeline),
        View::Image => image::frame_of(request, pipeline),
    };
    if request.finish.transparent {
        frame.drawing.background.a = 0;
    }
    if let Some(factor) = request.finish.stroke_factor {
        frame.drawing.strokes.iter_mut().for_each(|stroke| stroke.style.width *= factor);
    }
    if let Some(too_much) = frame.too_much.take() {
        let of_scene: BTreeSet<&str> = request.scene.objects.iter().map(|object| object.name.as_str()).collect();
        frame.too_much = too_much.about(|name| of_scene.contains(name));
    }
    frame
}

/// The scene of a figure in the colours of its theme, with the hidden edges of its style; `progress` follows the
/// reading of its meshes.
///
/// # Errors
/// [`SceneError`] names the object and its fault.
pub fn scene_of(figure: &Figure, read_file: &mut ReadFile<'_>, progress: &Progress) -> Result<Scene, SceneError> {
    scene::build_with(&figure.scene, &figure.style, read_file, &mut MeshFiles::watched(progress))
}

impl Request {
    /// The observer of the picture; `None` for the image.
    #[must_use]
    pub fn seen_from(&self) -> Option<Observer> {
        match self.view {
            View::World => Some(world_framing::seen_from(self)),
            View::Canonical => self.observer().or_else(|| self.observer_from(Viewpoint::Iso)),
            View::Image => None,
        }
    }

    /// The observer that looks from a side and has everything of interest in the picture; `None` for the image.
    #[must_use]
    pub fn observer_from(&self, viewpoint: Viewpoint) -> Option<Observer> {
        match self.view {
            View::World => Some(world_framing::observer(self, viewpoint)),
            View::Canonical => Some(canonical::observer(self, viewpoint)),
            View::Image => None,
        }
    }

    /// As [`fitted`](Self::fitted), but moved aside where the world would be seen (nearly) along DOP, u, v or n: for an
    /// observer that nobody has turned.
    #[must_use]
    pub fn kept_clear(&self, observer: &Observer) -> Option<Observer> {
        match self.view {
            View::World => Some(world_framing::kept_clear(self, observer)),
            View::Canonical | View::Image => self.fitted(observer),
        }
    }

    /// The observer that looks in the same direction as `observer` and has everything of interest in the picture;
    /// `None` for the image.
    #[must_use]
    pub fn fitted(&self, observer: &Observer) -> Option<Observer> {
        match self.view {
            View::World => Some(world_framing::fit(self, observer)),
            View::Canonical => Some(canonical::fit(self, observer)),
            View::Image => None,
        }
    }
}
