//! Everything that pictures show, as one value: the content of a file, a link, a session and an export. The part that
//! depends on the pointer alone is [`Hover`](super::Hover).

use std::sync::Arc;

use glam::DMat4;

use super::{ObjectTransform, OtherCamera, Picture, View};
use crate::appearance::{DepthFormat, Style};
use crate::camera::{Camera, ImageSize, Ndc, Viewport};
use crate::figure::{
    Comparison, Depth, Figure, Labels, NamedPoint, OtherSide, Outside, Reveal, Show, StagePicture, WorldLook,
};
use crate::inspect::Asked;
use crate::scene::SceneSpec;
use crate::scene::edit::{object_named, placements};
use crate::scene::transform::Trs;
use crate::stage::Stage;

/// Everything that pictures show of a scene and a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// The look of everything.
    pub look: Look,
    /// The followed points.
    pub points: Arc<[NamedPoint]>,
    /// The NDC of the canonical volume and the numbers.
    pub ndc: Ndc,
    /// The pictures, each with its observer and its camera.
    pub pictures: Vec<Picture>,
    /// The author's labels.
    pub labels: Labels,
    /// Explanations in the pictures.
    pub show: Show,
    /// The second camera of `show`.
    pub answered: Option<Camera>,
    /// The name of the current camera, if there are others.
    pub camera_name: Option<Arc<str>>,
    /// The other cameras of the figure.
    pub cameras: Arc<[OtherCamera]>,
    /// The transform of the object that `show` measures.
    pub measured_object: Option<ObjectTransform>,
    /// The same in another way, beside it.
    pub compared: Option<Arc<Compared>>,
    /// The quantities that labels don't print.
    pub asked: Asked,
}

/// The other side of a shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// The shot of the figure in the other way.
    pub shot: Shot,
    /// Its camera, if it's another one.
    pub camera: Option<Camera>,
    /// The comparison, with the place of its sides.
    pub comparison: Comparison,
    /// The compared keys, with the values of both sides.
    pub values: Vec<(String, [Option<String>; 2])>,
}

impl Compared {
    /// The other side of a figure; `None` if nothing is compared, or the other side is impossible.
    pub fn of(figure: &Figure, scene: &SceneSpec) -> Option<Self> {
        let comparison = figure.compare.clone()?;
        let OtherSide { figure: other, camera, mut values } = comparison.other_side(figure).ok()?;
        if let Some(name) = &comparison.camera {
            values.insert(0, ("camera.name".to_owned(), [figure.tag.name.clone(), Some(name.clone())]));
        }
        let camera = camera.map(|camera| camera.rounded());
        Some(Self { shot: Shot::of_one(&other, scene), camera, comparison, values })
    }

    /// The part that's visible in a picture of a kind; `None` if it looks like `own` there.
    #[must_use]
    pub(super) fn seen_in(&self, view: View, own: &Shot) -> Option<Self> {
        // Worlds and canonical volumes of two cameras would only show the same scene again.
        if self.comparison.camera.is_some() && view != View::Image {
            return None;
        }
        let mut shot = self.shot.seen_in(view);
        if view == View::Canonical {
            // The pixels of the image don't matter to the canonical volume.
            (shot.look.image, shot.look.viewport) = (own.look.image, own.look.viewport);
            shot.look.undistorted = own.look.undistorted;
        }
        let in_ndc = match view {
            View::World => false,
            View::Canonical => true,
            View::Image => [own, &shot].iter().any(|shot| shot.look.reveal.depth != Depth::Off),
        };
        let alike = if in_ndc { shot == *own } else { Shot { ndc: own.ndc, ..shot.clone() } == *own };
        (self.camera.is_some() || !alike).then(|| Self { shot, ..self.clone() })
    }
}

/// The three pictures of a figure, with nothing explained in them.
impl Default for Shot {
    fn default() -> Self {
        Self::of(&Figure::default())
    }
}

impl Shot {
    /// The shot of a figure.
    pub fn of(figure: &Figure) -> Self {
        let compared = Compared::of(figure, &figure.scene).map(Arc::new);
        Self { compared, ..Self::of_one(figure, &figure.scene) }
    }

    /// The shot of one side of a figure, whose scene may be elsewhere.
    pub fn of_one(figure: &Figure, scene: &SceneSpec) -> Self {
        let show = figure.show.clone();
        let measures_object = show.measure.iter().any(|measured| measured.is_of_object());
        let object = show.measure_of.as_deref().filter(|_| measures_object);
        Self {
            look: Look::of(figure),
            points: figure.points.as_slice().into(),
            ndc: show.ndc.unwrap_or_default(),
            pictures: Picture::of_figure(&figure.observers),
            answered: show.answer.and_then(|parameters| Camera::new(&parameters).ok()),
            camera_name: figure.tag.name.as_deref().filter(|_| !figure.cameras.is_empty()).map(Arc::from),
            cameras: OtherCamera::of_figure(figure).into(),
            measured_object: object.and_then(|name| transform_of(scene, name)),
            labels: figure.labels.clone(),
            show,
            compared: None,
            asked: Asked::default(),
        }
    }

    /// The first picture of a kind, or one of the figure's camera if there is none.
    pub fn picture(&self, kind: View) -> Picture {
        let there = self.pictures.iter().find(|picture| picture.kind == kind);
        there.cloned().unwrap_or_else(|| Picture::new(kind, None))
    }

    /// True if an image shows names or explanations over the scene.
    pub fn has_names(&self) -> bool {
        !self.points.is_empty() || self.show != Show::default() || self.look.reveal != Reveal::default()
    }

    /// The part of it that's visible in a picture of a kind. Parts of others have their defaults, so that they change
    /// nothing here. The pictures are left out, because a request has its own.
    #[must_use]
    pub fn seen_in(&self, view: View) -> Self {
        let show = &self.show;
        let stage = show.stage.filter(|_| show.stage_of.0 == view);
        let everywhere = Show {
            stage,
            stage_of: stage.map_or_else(StagePicture::default, |_| show.stage_of),
            triangle: show.triangle.clone(),
            probe: show.probe,
            operations: show.operations.clone(),
            ..Show::default()
        };
        let mut look = Look { reveal: self.revealed_in(view), ..self.look };
        if view != View::Image {
            // Neither changes the pixels of the image on the window.
            (look.style.order, look.reveal.cost) = Default::default();
        }
        if view == View::Canonical {
            // Depths are stored for the image, which the world shows on the window, with its photograph.
            look.style = Style { depth_format: DepthFormat::default(), ..look.style.with_exact_vertices() };
            look.photograph_opacity = 0.0;
        }
        let show = match view {
            View::World => Show { measure: show.measure.clone(), moved: show.moved.clone(), ..everywhere },
            View::Canonical => Show { step: show.step, ..everywhere },
            View::Image => Show { painted: show.painted, ..everywhere },
        };
        let in_world = view == View::World;
        let seen = Self {
            look,
            points: Arc::clone(&self.points),
            // Steps end in the convention of their source.
            ndc: show.step.map_or(self.ndc, |step| step.way.ndc()),
            pictures: Vec::new(),
            labels: self.labels.seen_in(view),
            show,
            answered: self.answered.clone().filter(|_| in_world),
            camera_name: self.camera_name.clone().filter(|_| in_world),
            cameras: if in_world { Arc::clone(&self.cameras) } else { Arc::default() },
            measured_object: self.measured_object.filter(|_| in_world),
            compared: None,
            asked: self.asked.clone(),
        };
        let compared = self.compared.as_ref().and_then(|compared| compared.seen_in(view, &seen));
        Self { compared: compared.map(Arc::new), ..seen }
    }

    /// The inner work of the pipeline in a picture: the requested part, and while a stage of the image is shown, its
    /// parts in the pictures beside it.
    fn revealed_in(&self, view: View) -> Reveal {
        let reveal = self.look.reveal;
        let beside = self.show.stage_of == StagePicture::default() && view != View::Image;
        match self.show.stage.filter(|_| beside) {
            Some(Stage::CullObjects | Stage::CullFaces) => Reveal { culled: true, ..reveal },
            Some(Stage::Clip) => {
                let outside = if reveal.outside == Outside::Usual { Outside::Tinted } else { reveal.outside };
                Reveal { clipping: true, outside, ..reveal }
            }
            Some(_) | None => reveal,
        }
    }
}

/// The transform of an object of a scene; `None` if there is none of this name, or the scene is impossible.
fn transform_of(scene: &SceneSpec, name: &str) -> Option<ObjectTransform> {
    let spec = object_named(scene, name)?;
    let world_from_parent = match &spec.parent {
        Some(parent) => *placements(scene).ok()?.get(parent)?,
        None => DMat4::IDENTITY,
    };
    let trs = Trs { translate: spec.translate, rotate: spec.rotate, scale: spec.scale };
    Some(ObjectTransform { world_from_parent, trs })
}

/// The inputs of a picture besides camera, scene and observer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// `[image]`
    pub image: ImageSize,
    /// `[image] undistorted`
    pub undistorted: bool,
    /// `[image] photograph_opacity`; 0 without a photograph.
    pub photograph_opacity: f64,
    /// `[viewport]`: the figure's, or the whole image.
    pub viewport: Viewport,
    /// `[style]`
    pub style: Style,
    /// `[reveal]`
    pub reveal: Reveal,
    /// `[world]`
    pub world: WorldLook,
}

impl Default for Look {
    fn default() -> Self {
        Self::of(&Figure::default())
    }
}

impl Look {
    /// As the figure gives it.
    pub fn of(figure: &Figure) -> Self {
        let Figure { image, undistorted, viewport, style, reveal, world, ref photograph, .. } = *figure;
        Self {
            image,
            undistorted,
            photograph_opacity: photograph.as_ref().map_or(0.0, |photograph| photograph.opacity),
            viewport: viewport.unwrap_or_else(|| Viewport::whole(image)),
            style,
            reveal,
            world,
        }
    }

    /// Width / height of the image as displayed: m / n, whatever the window, or that of the window.
    pub fn image_aspect(&self, camera: &Camera) -> f64 {
        if self.undistorted { camera.window().aspect() } else { self.image.aspect() }
    }
}
