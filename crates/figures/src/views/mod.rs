//! A figure → the scene that each of the three pictures shows, and its observer.
//!
//! There is one engine. The image is the scene seen by the figure's camera, the world is the scene with the camera's
//! own gear seen by a second camera (the observer), and the canonical volume is the scene after clipping and
//! projection, seen by a third. All three go through [`Pipeline::frame`](crate::pipeline::Pipeline::frame).
//!
//! | picture | space of its scene | observer |
//! | --- | --- | --- |
//! | `image` | world | the figure's camera |
//! | `world` | world | [`Observer`] |
//! | `canonical` | ndc, shown as (x_n, y_n, −z_n), which is right-handed; in other conventions as deep as they are | [`Observer`] |

mod arrangement;
mod canonical;
mod compared;
mod image;
pub mod observer;
mod other_camera;
pub mod palette;
mod picture;
mod pixels;
mod request;
mod screen;
mod shot;
mod timed_pipeline;
mod world;

/// Words in the pictures: labels and their layout, captions, the legend.
mod words {
    pub(super) mod author_labels;
    pub(super) mod caption_strip;
    pub(super) mod coverage_grid;
    pub(super) mod label_layout;
    pub(super) mod label_names;
    pub(super) mod label_obstacles;
    pub(super) mod labels;
    pub(super) mod legend;
    pub(super) mod note_place;
    pub(super) mod values;
}

/// Picking, hovering and dragging in the pictures.
mod interact {
    pub(super) mod cameras;
    pub mod handles;
    pub(super) mod hits;
    pub(super) mod hover;
    pub mod named_points;
    pub mod pick;
    pub mod transform_gizmo;
}

/// The inner work of the pipeline in the pictures: probes, stages, triangles, texels.
mod reveal {
    pub(super) mod operation_path;
    pub(super) mod probe;
    pub(super) mod revealed_scene;
    pub(super) mod stage_overlay;
    pub(super) mod texel;
    pub(super) mod triangle_overlay;
}

use std::sync::Arc;

use crate::appearance::Texture;
use crate::figure::{Figure, Observer, WorldPart};
pub use crate::figure::{View, Views};
use crate::pipeline::Frame;
use crate::progress::Progress;
use crate::scene::{self, MeshFiles, ReadFile, Scene, SceneError};
pub use arrangement::{Arrangement, aspect_shown, best_arrangement, share_of_first, used_area};
pub use compared::{Side, overlay};
pub use image::depth;
pub use image::light_view::{ShadowAt, shadows_at};
pub use interact::cameras::camera_at;
pub use interact::hover::{
    CostMap, Ghost, GizmoPart, Handle, Hover, ObjectTransform, Probe, Projector, ShadowTruth, TransformGizmo,
    Transforming, TriangleOverlay,
};
pub use interact::{handles, named_points, pick, transform_gizmo};
pub use observer::ObserverOf;
use observer::Viewpoint;
pub use other_camera::OtherCamera;
pub use palette::Palette;
pub use picture::{MAX_PICTURES, Picture, observer_in};
pub use pixels::{PixelRect, Size, image_frame};
pub use request::{Finish, Normalizing, Request, SharedScene};
pub use reveal::texel::{TexelAt, texel_at};
pub use shot::{Compared, Look, Shot};
pub use timed_pipeline::TimedPipeline;
pub use words::author_labels::LabelPlace;
pub use words::caption_strip::{Captions, caption_height};
pub use words::label_names::unknown_labels;
pub use words::labels::Labels;
#[cfg(test)]
pub(crate) use words::labels::unlabelled;
pub use words::note_place::note_place;
pub use words::values::caption;

/// Draws a picture, and reports. `on_window` is the image that the view window of the world shows,
/// [`Request::image_on_window`] as pixels. Without it the window is plain.
pub fn frame(request: &Request, on_window: Option<&Arc<Texture>>, pipeline: &mut TimedPipeline) -> Frame {
    let mut frame = match request.view {
        View::World => world::frame_of(request, on_window, pipeline),
        View::Canonical => canonical::normalizing::frame_of(request, pipeline),
        View::Image => image::frame_of(request, pipeline),
    };
    if request.finish.transparent {
        frame.drawing.background.a = 0;
    }
    if let Some(factor) = request.finish.stroke_factor {
        frame.drawing.strokes.iter_mut().for_each(|stroke| stroke.style.width *= factor);
    }
    frame
}

/// The scene of a figure in the colours of its theme. `progress` follows the reading of its meshes.
///
/// # Errors
/// [`SceneError`] names the object and its fault.
pub fn scene_of(figure: &Figure, read_file: &mut ReadFile<'_>, progress: &Progress) -> Result<Scene, SceneError> {
    let mut files = MeshFiles::watched(progress);
    files.show_photograph(figure.photograph.as_ref().map(|photograph| photograph.file.as_str()));
    scene::build_with(&figure.scene, &figure.style, read_file, &mut files)
}

/// Gives pictures of one kind and one size a common observer, so that only things that moved differ between them. It's
/// the observer of another figure, or else those of their figures, if these have some, or one that has everything in
/// the picture.
pub fn with_observer(requests: Vec<Request>, other: Option<&ObserverOf>) -> Vec<Request> {
    if let Some(other) = other {
        let seen = |own: Request| {
            let observer = other.observer(&own);
            own.seen_by(observer)
        };
        return requests.into_iter().map(seen).collect();
    }
    let has_own = |request: &Request| request.observer.is_some() || request.shot.look.world.section;
    if requests.iter().any(has_own) {
        return requests;
    }
    let observer = match requests.first().map(|request| request.view) {
        Some(View::World) => world::world_framing::common(&requests),
        Some(View::Canonical) => canonical::common(&requests),
        Some(View::Image) | None => None,
    };
    requests.into_iter().map(|request| request.seen_by(observer)).collect()
}

impl Request {
    /// The observer of the picture; `None` for the image.
    pub fn seen_from(&self) -> Option<Observer> {
        match self.view {
            View::World => Some(world::world_framing::seen_from(self)),
            View::Canonical => self.observer.or_else(|| self.observer_from(Viewpoint::Iso)),
            View::Image => None,
        }
    }

    /// The observer that looks from a side and has everything of interest in the picture; `None` for the image.
    pub fn observer_from(&self, viewpoint: Viewpoint) -> Option<Observer> {
        match self.view {
            View::World => Some(world::world_framing::observer(self, viewpoint)),
            View::Canonical => Some(canonical::observer(self, viewpoint)),
            View::Image => None,
        }
    }

    /// True if an observer has everything of interest in its picture. The image has none.
    pub fn holds(&self, observer: &Observer) -> bool {
        match self.view {
            View::World => world::world_framing::holds(self, observer),
            View::Canonical => canonical::holds(self, observer),
            View::Image => true,
        }
    }

    /// The same picture for a page or a file. If its observer was turned in a picture of another shape, it goes back
    /// until everything of interest is in the picture. A close look, which leaves most outside anyway, goes back as far
    /// as the picture is narrower than those beside one another in a window.
    pub fn gone_back(self) -> Self {
        /// At this many times the distance, it would be another picture.
        const CLOSE: f64 = 2.0;
        /// Width over height of a picture beside another one in a window.
        const BESIDE: f64 = 1.1;
        let Some(given) = self.observer.filter(|_| self.normalizing().is_none()) else { return self };
        let shows_volume = self.view != View::World || self.shot.look.world.parts.has(WorldPart::Volume);
        let fitted = self
            .fitted(&given)
            .filter(|fitted| shows_volume && !self.holds(&given) && fitted.distance < CLOSE * given.distance);
        let size = self.each_side().first().map_or(self.size, |side| side.size);
        let narrower = (BESIDE / size.aspect()).max(1.0);
        let gone = fitted.unwrap_or(Observer { distance: narrower * given.distance, ..given });
        self.seen_by(Some(gone))
    }

    /// The observer that looks in the same direction as `observer` and has everything of interest in the picture;
    /// `None` for the image.
    pub fn fitted(&self, observer: &Observer) -> Option<Observer> {
        match self.view {
            View::World => Some(world::world_framing::framing(self, *observer)),
            View::Canonical => Some(canonical::framing(self, *observer)),
            View::Image => None,
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;
    use crate::camera::Camera;
    use crate::views::unlabelled;

    #[test]
    fn an_observer_goes_back_if_the_volume_is_cut_and_a_close_look_stays() {
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        let scene = SharedScene::new(Scene::default());
        let of = |width, observer| {
            let size = Size { width, height: 400, scale: 1.0 };
            let request = Request::of(&figure, View::World, &camera, &scene, unlabelled(), size);
            request.seen_by(observer)
        };
        let wide = of(900, None).observer_from(Viewpoint::Iso).unwrap();
        assert_eq!(of(900, Some(wide)).gone_back().observer, Some(wide), "it has everything in the picture");
        let narrow = of(300, Some(wide));
        let gone = narrow.clone().gone_back().observer.unwrap();
        assert!(!narrow.holds(&wide) && narrow.holds(&gone));
        assert_eq!((gone.azimuth, gone.elevation), (wide.azimuth, wide.elevation));
        let close = Observer { distance: 0.1 * wide.distance, ..wide };
        assert_eq!(of(900, Some(close)).gone_back().observer, Some(close));
        let gone = of(300, Some(close)).gone_back().observer.unwrap();
        assert_eq!(gone.target, close.target);
        assert!((gone.distance / close.distance - 1.1 / 0.75).abs() < 1e-9, "as much across as beside another picture");
        assert_eq!(of(300, None).gone_back(), of(300, None));
    }
}
