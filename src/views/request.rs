//! Everything that a picture depends on, as one value: equal requests give equal pixels.

use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use super::pixels::image_frame;
use super::{Labels, Overlays, Size, View};
use crate::appearance::Style;
use crate::camera::{Camera, Decomposition, ImageSize, Ndc, Viewport};
use crate::figure::{Figure, NamedPoint, Observer, Observers, Reveal, WorldLook};
use crate::geometry::Aabb;
use crate::pipeline::{Output, Stage};
use crate::scene::Scene;

/// A picture to be made. "Has anything changed?" is `==`, which costs nothing that grows with the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Which picture.
    pub view: View,
    /// How everything looks.
    pub look: Look,
    /// The camera that the picture is about.
    pub camera: Camera,
    /// What it looks at.
    pub scene: SharedScene,
    /// The points that are followed.
    pub points: Arc<[NamedPoint]>,
    /// From where a three-dimensional picture is seen; `None`: from a corner, with everything in the picture. The image is
    /// seen by the camera alone.
    pub observer: Option<Observer>,
    /// Whose NDC the canonical volume and the numbers are in.
    pub ndc: Ndc,
    /// The canonical picture on its way from the world, step by step; `None`: arrived.
    pub normalizing: Option<Normalizing>,
    /// Only the first share (0 … 1) of the image's triangles are painted, in the order of painting; `None`: all, with everything else.
    pub begun: Option<f64>,
    /// What goes into this stage and what comes out is shown in the picture, where it runs.
    pub stage: Option<Stage>,
    /// What comes and goes with the pointer.
    pub overlays: Overlays,
    /// The words in the picture.
    pub labels: &'static Labels,
    /// Size of the picture.
    pub size: Size,
    /// Run every stage of the pipeline, needed or not. The picture is the same.
    pub force_all_stages: bool,
    /// What the drawing is for; pixels are made of drawings for pixels.
    pub output: Output,
}

impl Request {
    /// A picture of a figure, with nothing pointed at. The camera is the figure's, or what operations have made of it; the
    /// scene is [`scene_of`](super::scene_of) the figure.
    #[must_use]
    pub fn of(
        figure: &Figure,
        view: View,
        camera: &Camera,
        scene: &SharedScene,
        labels: &'static Labels,
        size: Size,
    ) -> Self {
        Self {
            view,
            look: Look::of(figure),
            camera: camera.clone(),
            scene: scene.clone(),
            points: figure.points.as_slice().into(),
            observer: observer_in(&figure.observers, view),
            ndc: Ndc::default(),
            normalizing: None,
            begun: None,
            stage: None,
            overlays: Overlays::default(),
            labels,
            size,
            force_all_stages: false,
            output: Output::Pixels,
        }
    }

    /// The image, without margins and legends, for the view window in the world: half as large as the picture, within reason, and
    /// with the aspect of the window, in which it is undistorted.
    #[must_use]
    pub fn image_on_window(&self) -> Self {
        let side = (self.size.width.max(self.size.height) / 2).clamp(256, 1024);
        let frame = image_frame(Size { width: side, height: side, scale: 1.0 }, self.camera.window().aspect());
        Self {
            view: View::Image,
            look: Look { undistorted: true, ..self.look },
            // They are drawn in the world.
            points: Arc::default(),
            observer: None,
            stage: None,
            overlays: Overlays { bare: true, stroke_factor: self.overlays.stroke_factor, ..Overlays::default() },
            size: Size { width: frame.width, height: frame.height, scale: 1.0 },
            // Also in a vector picture it is a texture.
            output: Output::Pixels,
            ..self.clone()
        }
    }
}

/// How far the scene has come on the way of a decomposition: whole numbers are whole steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normalizing {
    /// Whose steps.
    pub decomposition: Decomposition,
    /// 0: the world; from the number of steps on: the canonical volume.
    pub time: f64,
}

/// What a figure says about the observer of a picture.
#[must_use]
pub fn observer_in(observers: &Observers, view: View) -> Option<Observer> {
    match view {
        View::World => observers.world,
        View::Canonical => observers.canonical,
        View::Image => None,
    }
}

/// What a picture depends on besides camera, scene and observer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// `[image]`
    pub image: ImageSize,
    /// `[image] undistorted`
    pub undistorted: bool,
    /// `[viewport]`: the figure's, or the whole image.
    pub viewport: Viewport,
    /// `[style]`
    pub style: Style,
    /// `[reveal]`
    pub reveal: Reveal,
    /// `[world]`
    pub world: WorldLook,
}

impl Look {
    /// As a figure wants it.
    #[must_use]
    pub fn of(figure: &Figure) -> Self {
        let Figure { image, undistorted, viewport, style, reveal, world, .. } = *figure;
        Self { image, undistorted, viewport: viewport.unwrap_or_else(|| Viewport::whole(image)), style, reveal, world }
    }
}

impl Look {
    /// Width / height of the image as it is shown: m / n, whatever the window, or that of the window.
    #[must_use]
    pub fn image_aspect(&self, camera: &Camera) -> f64 {
        if self.undistorted { camera.window().aspect() } else { self.image.aspect() }
    }
}

/// A scene that requests share. Two are equal where they are the same one, not where they look alike: scenes have millions of
/// vertices, and whoever keeps one makes another only when something in it has changed.
#[derive(Clone, Debug, Default)]
pub struct SharedScene(Arc<SceneWithBounds>);

#[derive(Debug, Default)]
struct SceneWithBounds {
    scene: Scene,
    /// The box around the scene: with a million vertices it takes a while to find.
    bounds: OnceLock<Option<Aabb>>,
}

impl SharedScene {
    /// Shares a scene.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        Self(Arc::new(SceneWithBounds { scene, bounds: OnceLock::new() }))
    }

    /// Another scene, which is this one with marks in it: pictures frame it as they frame this one.
    #[must_use]
    pub fn marked(&self, scene: Scene) -> Self {
        Self(Arc::new(SceneWithBounds { scene, bounds: OnceLock::from(self.bounds()) }))
    }

    /// The box around the scene; `None` for an empty one.
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        *self.0.bounds.get_or_init(|| self.0.scene.bounds())
    }
}

impl Deref for SharedScene {
    type Target = Scene;

    fn deref(&self) -> &Scene {
        &self.0.scene
    }
}

impl PartialEq for SharedScene {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::i18n::{Lang, pictures};
    use crate::scene::PointMark;
    use crate::views::{Handle, Probe, TransformGizmo, Transforming};
    use glam::{DVec2, DVec3};

    fn request() -> Request {
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        let size = Size { width: 400, height: 300, scale: 1.0 };
        let scene = SharedScene::new(Scene::default());
        Request::of(&figure, View::World, &camera, &scene, pictures::labels(Lang::En), size)
    }

    #[test]
    fn a_scene_is_equal_to_itself_and_not_to_one_that_looks_like_it() {
        let one = request();
        assert_eq!(one, one.clone());
        assert_ne!(one, Request { scene: SharedScene::new(Scene::default()), ..one.clone() });
    }

    #[test]
    fn a_marked_scene_is_framed_as_the_scene_without_marks() {
        let scene = SharedScene::new(Scene::default());
        let mark = PointMark {
            position: DVec3::splat(100.0),
            shape: crate::appearance::MarkShape::Disc,
            radius: 3.0,
            color: crate::appearance::Rgba::rgb(0, 0, 0),
            fade_if_hidden: false,
        };
        let marked = scene.marked(Scene { marks: vec![mark], ..Scene::default() });
        assert_eq!((marked.bounds(), marked.marks.len()), (None, 1));
        assert_ne!(marked, scene);
    }

    #[test]
    fn what_moves_things_is_seen_in_the_world_alone_and_the_probe_everywhere() {
        let overlays = Overlays {
            probe: Some(Probe::Window(DVec2::ZERO)),
            hot: Some(Handle::Near),
            gizmo: Some(TransformGizmo { does: Transforming::Move, origin: DVec3::ZERO, axes: DVec3::AXES, hot: None }),
            ..Overlays::default()
        };
        assert_eq!(overlays.seen_in(View::World), overlays);
        for view in [View::Canonical, View::Image] {
            assert_eq!(overlays.seen_in(view), Overlays { probe: overlays.probe, ..Overlays::default() });
        }
    }

    #[test]
    fn the_image_on_the_window_has_its_aspect_and_never_vanishes() {
        for (width, height, side) in [(100, 80, 256), (1280, 900, 640), (16_000, 10, 1024)] {
            let request = Request { size: Size { width, height, scale: 2.0 }, ..request() };
            let on_window = request.image_on_window();
            assert_eq!(on_window.view, View::Image);
            assert_eq!(on_window.size, Size { width: side, height: side * 3 / 4, scale: 1.0 });
        }
        let parameters = crate::camera::Parameters { aspect: 1e9, ..crate::camera::Parameters::default() };
        let thin = Request { camera: Camera::new(&parameters).unwrap(), ..request() }.image_on_window();
        assert_eq!((thin.size.width, thin.size.height), (256, 1));
    }
}
