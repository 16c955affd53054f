//! Everything that a picture depends on, as one value. Equal requests give equal pixels.

use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use super::pixels::image_frame;
use super::words::values::done;
use super::{
    CostMap, Ghost, Hover, Labels, Look, ObjectTransform, Picture, Probe, Projector, ShadowTruth, Shot, Size,
    TriangleOverlay, View,
};
use crate::camera::{Camera, Decomposition, Operation};
use crate::figure::{Figure, Measured, Observer, ShownStep};
use crate::geometry::Aabb;
use crate::inspect::quantity::Quantity;
use crate::numbers::DecimalMark;
use crate::pipeline::Output;
use crate::scene::Scene;
use crate::stage::Stage;

/// A requested picture. "Has anything changed?" is `==`, whose cost doesn't grow with the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The kind of the picture.
    pub view: View,
    /// The observer of a three-dimensional picture; `None` means from a corner, with everything in the picture.
    pub observer: Option<Observer>,
    /// The camera of the picture.
    pub camera: Camera,
    /// The part of the shot that's visible in this picture.
    pub shot: Arc<Shot>,
    /// Shared by all views of a frame.
    pub scene: SharedScene,
    /// The part that depends on the pointer alone.
    pub hover: Hover,
    /// The settings of the output.
    pub finish: Finish,
    /// The words in the picture.
    pub labels: &'static Labels,
    /// Size of the picture.
    pub size: Size,
    /// Runs every stage of the pipeline, needed or not. The picture is the same.
    pub force_all_stages: bool,
    /// Runs this stage of the pipeline, needed or not. The picture is the same.
    pub force_stage: Option<Stage>,
    /// The kind of output. Pixels are made from drawings for pixels.
    pub output: Output,
    /// The triangle of the shot on its way. Only the renderer sets it.
    pub triangle: Option<Arc<TriangleOverlay>>,
    /// Set if the image is that of another camera, beside the figure's own: the projector marked there, if any.
    pub projector: Option<Option<Projector>>,
    /// The places where the shadow maps of the image are wrong. Only the renderer sets it.
    pub shadow_truth: Option<Arc<ShadowTruth>>,
    /// The costs of the pixels of the image. Only the renderer sets it.
    pub cost: Option<Arc<CostMap>>,
}

/// The settings of an output, independent of the content.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Finish {
    /// Without texts and legends, for painting the picture on something.
    pub bare: bool,
    /// Transparent background.
    pub transparent: bool,
    /// The factor of stroke widths; `None` means in proportion to the letters.
    pub stroke_factor: Option<f32>,
    /// The image has a border, with space around it for the marks at its sides, on paper and beside other pictures.
    pub framed: bool,
    /// No letters are smaller than those of names, unless the author made them so, because the user chose their height.
    pub least_letters: bool,
}

impl Request {
    /// A picture of a figure, without hover. The camera is the figure's, or the one after operations, as in
    /// [`of_picture`](Self::of_picture). The scene is [`scene_of`](super::scene_of) the figure.
    pub fn of(
        figure: &Figure,
        view: View,
        camera: &Camera,
        scene: &SharedScene,
        labels: &'static Labels,
        size: Size,
    ) -> Self {
        Self::new(&Shot::of(figure), view, camera, scene, labels, size)
    }

    /// The first picture of a kind of a shot, without hover. The camera is the figure's.
    pub fn new(
        shot: &Shot,
        view: View,
        camera: &Camera,
        scene: &SharedScene,
        labels: &'static Labels,
        size: Size,
    ) -> Self {
        Self::of_picture(shot, &shot.picture(view), camera, scene, labels, size)
    }

    /// A picture of a shot, without hover. The camera is the figure's, but the picture may have its own. It's
    /// [rounded](Camera::rounded), so that a picture is the same before its figure is saved and after.
    pub fn of_picture(
        shot: &Shot,
        picture: &Picture,
        camera: &Camera,
        scene: &SharedScene,
        labels: &'static Labels,
        size: Size,
    ) -> Self {
        Self {
            view: picture.kind,
            observer: picture.observer.filter(|_| picture.kind != View::Image),
            camera: picture.camera.as_ref().unwrap_or(camera).rounded(),
            shot: Arc::new(shot.seen_in(picture.kind)),
            scene: scene.clone(),
            hover: Hover::default(),
            finish: Finish::default(),
            labels,
            size,
            force_all_stages: false,
            force_stage: None,
            output: Output::Pixels,
            triangle: None,
            projector: None,
            shadow_truth: None,
            cost: None,
        }
    }

    /// The operations that the figure shows, each with the camera before it and the one after it.
    pub fn operations(&self) -> Vec<(Ghost, Camera)> {
        Ghost::leading_to(&self.camera, &self.shot.show.operations)
    }

    /// An operation in the words of the picture, numbered from 1 if there are several.
    pub(in crate::views) fn operation_text(&self, place: usize, count: usize, operation: Operation) -> String {
        let text = done(operation, self.labels);
        if count > 1 { format!("{}. {text}", place + 1) } else { text }
    }

    /// The same picture with another shot, of which only the part visible in it counts. If it's compared, this applies
    /// to both sides.
    pub fn with_shot(self, change: impl Fn(&mut Shot)) -> Self {
        let mut shot = Shot::clone(&self.shot);
        change(&mut shot);
        if let Some(compared) = &mut shot.compared {
            change(&mut Arc::make_mut(compared).shot);
        }
        Self { shot: Arc::new(shot.seen_in(self.view)), ..self }
    }

    /// The same picture with another observer. Only the camera sees the image.
    pub fn seen_by(self, observer: Option<Observer>) -> Self {
        Self { observer: observer.filter(|_| self.view != View::Image), ..self }
    }

    /// The canonical picture on its way from the world, step by step; `None` means that there's no way for the camera,
    /// or none is shown.
    pub fn normalizing(&self) -> Option<Normalizing> {
        Normalizing::of(self.shot.show.step?, &self.camera)
    }

    /// The height of the smallest requested letters, in pixels; 0 if any are fine.
    pub(in crate::views) fn least_letters(&self) -> f32 {
        if self.finish.least_letters { self.size.letters() } else { 0.0 }
    }

    /// The probe marked in all three pictures: the pinned one, or that of the pointer.
    pub fn probe(&self) -> Option<Probe> {
        let pinned = self.shot.show.probe.map(|probe| Probe::of(probe, &self.camera, self.shot.look.image));
        pinned.or(self.hover.probe)
    }

    /// The numbers of quantities in a label, as `write` puts them, or a question mark while a question asks for one.
    pub(super) fn written(
        &self,
        quantities: &[Quantity],
        numbers: &[f64],
        write: impl FnOnce(DecimalMark) -> String,
    ) -> String {
        if self.shot.asked.hides(quantities, numbers) { "?".to_owned() } else { write(self.labels.mark) }
    }

    /// A number in a label, or a question mark.
    pub(super) fn number(&self, quantity: Quantity, value: f64) -> String {
        self.written(&[quantity], &[value], |mark| mark.number(value, 4))
    }

    /// The lengths, angles and coordinates that light up in the world.
    pub fn measured(&self) -> impl Iterator<Item = Measured> {
        let shown = &self.shot.show.measure;
        let pointed = self.hover.measured.iter().filter(move |measured| !shown.contains(measured));
        shown.iter().chain(pointed).copied()
    }

    /// The object whose parts are measured.
    pub fn measured_object(&self) -> Option<ObjectTransform> {
        self.hover.object.or(self.shot.measured_object)
    }

    /// The image, without margins and legends, for the view window in the world. It's half as large as the picture,
    /// within reason, and has the aspect of the window, in which it's undistorted.
    #[must_use]
    pub fn image_on_window(&self) -> Self {
        let side = (self.size.width.max(self.size.height) / 2).clamp(256, 1024);
        let frame = image_frame(Size { width: side, height: side, scale: 1.0 }, self.camera.window().aspect());
        // Points and explanations are drawn in the world.
        let look = Look { undistorted: true, ..self.shot.look };
        let shot = Shot { look, ndc: self.shot.ndc, ..Shot::default().seen_in(View::Image) };
        Self {
            view: View::Image,
            observer: None,
            shot: Arc::new(shot),
            hover: Hover::default(),
            finish: Finish { bare: true, stroke_factor: self.finish.stroke_factor, ..Finish::default() },
            size: Size { width: frame.width, height: frame.height, scale: 1.0 },
            // It's a texture in a vector picture too.
            output: Output::Pixels,
            triangle: None,
            shadow_truth: None,
            cost: None,
            ..self.clone()
        }
    }
}

/// The progress of the scene through a decomposition. Whole numbers are whole steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normalizing {
    /// The source of the steps.
    pub decomposition: Decomposition,
    /// 0 is the world. From the number of steps on, it's the canonical volume.
    pub time: f64,
}

impl Normalizing {
    /// The progress of a camera; `None` if it has no steps of this source.
    pub fn of(step: ShownStep, camera: &Camera) -> Option<Self> {
        let ShownStep { way, at } = step;
        let end = camera.decomposed(way)?.len() as f64;
        Some(Self { decomposition: way, time: at.unwrap_or(end).clamp(0.0, end) })
    }
}

/// A scene that requests share. Two are equal if they're the same one, not if they look alike, because scenes have
/// millions of vertices, and a new one is made only if something in it has changed.
#[derive(Clone, Debug, Default)]
pub struct SharedScene(Arc<SceneWithBounds>);

#[derive(Debug, Default)]
struct SceneWithBounds {
    scene: Scene,
    /// The box around the scene, which takes a while to find with a million vertices. A single thread does it, because
    /// threads of the pool would begin another picture of the scene meanwhile, which would wait for it.
    bounds: OnceLock<Option<Aabb>>,
}

impl SharedScene {
    /// Shares a scene.
    pub fn new(scene: Scene) -> Self {
        Self(Arc::new(SceneWithBounds { scene, bounds: OnceLock::new() }))
    }

    /// Another scene, which is this one with marks in it. Pictures frame it like this one.
    #[must_use]
    pub fn marked(&self, scene: Scene) -> Self {
        Self(Arc::new(SceneWithBounds { scene, bounds: OnceLock::from(self.bounds()) }))
    }

    /// The box around the scene; `None` for an empty one.
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
    use crate::scene::PointMark;
    use crate::views::{Handle, TransformGizmo, Transforming, unlabelled};
    use glam::{DVec2, DVec3};

    fn request() -> Request {
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        let size = Size { width: 400, height: 300, scale: 1.0 };
        let scene = SharedScene::new(Scene::default());
        Request::of(&figure, View::World, &camera, &scene, unlabelled(), size)
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
    fn the_gizmo_is_seen_in_the_world_alone_and_the_probe_everywhere() {
        let hover = Hover {
            probe: Some(Probe::Window(DVec2::ZERO)),
            hovered: Some(Handle::Near),
            gizmo: Some(TransformGizmo {
                does: Transforming::Move,
                origin: DVec3::ZERO,
                axes: DVec3::AXES,
                hovered: None,
            }),
            ..Hover::default()
        };
        assert_eq!(hover.seen_in(View::World), hover);
        for view in [View::Canonical, View::Image] {
            assert_eq!(hover.seen_in(view), Hover { probe: hover.probe, ..Hover::default() });
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
