//! Which stages a picture needs, and why each other one is left out.
//!
//! A [`Plan`] is a pure function of scene, camera and style, made before anything is drawn from bounding boxes and properties
//! of the meshes alone. It changes no pixel: with [`Options::force_all_stages`] everything runs, and the picture is the same.

use std::time::Duration;

use super::clip::{ALL_PLANES, NEAR, PlaneSet};
use super::cull::Place;
use super::shade::Shaded;
use super::transform::Projector;
use crate::appearance::{HiddenLines, Shading, Style, Visibility};
use crate::scene::{Object, ObjectPaint, Scene};

/// A stage of the pipeline, in the order of `[3]` §1.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// Walk through the scene.
    Traverse,
    /// Drop objects whose bounding box is outside the volume.
    CullObjects,
    /// Take vertex normals to view space.
    Normals,
    /// The reflection model: light on faces or vertices.
    Light,
    /// World → view, each vertex once.
    Transform,
    /// Drop faces that turn their back.
    CullFaces,
    /// Cut what crosses a plane of the volume, before the divide.
    Clip,
    /// The terms of an oblique window.
    Oblique,
    /// The perspective divide.
    Divide,
    /// Ndc → pixels.
    Viewport,
    /// Find the pixels of each face.
    Fill,
    /// Colours, normals or texture coordinates between the vertices of a face.
    Interpolate,
    /// Remove hidden surfaces.
    HiddenSurfaces,
    /// Pictures on surfaces.
    Texture,
    /// Mix translucent colours with what is behind.
    Blend,
    /// Several samples for a pixel.
    Antialias,
    /// Edges, lines, marks and texts, over the finished surfaces.
    Lines,
    /// Colours go to the memory of the image.
    Write,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: [Self; 18] = [
        Self::Traverse,
        Self::CullObjects,
        Self::Normals,
        Self::Light,
        Self::Transform,
        Self::CullFaces,
        Self::Clip,
        Self::Oblique,
        Self::Divide,
        Self::Viewport,
        Self::Fill,
        Self::Interpolate,
        Self::HiddenSurfaces,
        Self::Texture,
        Self::Blend,
        Self::Antialias,
        Self::Lines,
        Self::Write,
    ];

    /// The name in data that programs read.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Traverse => "traverse",
            Self::CullObjects => "cull-objects",
            Self::Normals => "normals",
            Self::Light => "light",
            Self::Transform => "transform",
            Self::CullFaces => "cull-faces",
            Self::Clip => "clip",
            Self::Oblique => "oblique-window",
            Self::Divide => "divide",
            Self::Viewport => "viewport",
            Self::Fill => "fill",
            Self::Interpolate => "interpolate",
            Self::HiddenSurfaces => "hidden-surfaces",
            Self::Texture => "texture",
            Self::Blend => "blend",
            Self::Antialias => "antialias",
            Self::Lines => "lines",
            Self::Write => "write",
        }
    }

    /// The stage in whose loop this one runs, so that it has no time of its own: what is done to a number while it is at hand
    /// costs less than a walk over all numbers for each stage.
    #[must_use]
    pub fn timed_with(self) -> Option<Self> {
        match self {
            Self::CullObjects => Some(Self::Traverse),
            Self::Normals => Some(Self::Light),
            Self::Oblique | Self::Divide | Self::Viewport => Some(Self::Transform),
            Self::Interpolate | Self::HiddenSurfaces | Self::Texture | Self::Blend | Self::Antialias | Self::Write => {
                Some(Self::Fill)
            }
            _ => None,
        }
    }
}

/// Why a stage runs or is left out. Counts are of objects unless they say otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Runs: every picture needs it.
    Always,
    /// Left out: there is nothing in the volume that it could work on.
    NothingInView,
    /// Runs: something is in view.
    SomethingInView,
    /// Runs: faces are in view.
    FacesInView {
        /// That have any.
        objects: usize,
    },
    /// Runs: everything was asked for, needed or not.
    Forced,

    /// Runs: so many of all objects are outside one plane of the volume, and dropped whole.
    Outside {
        /// Dropped.
        outside: usize,
        /// In the scene.
        of: usize,
    },
    /// Left out: no object lies outside.
    NoneOutside {
        /// In the scene.
        of: usize,
    },

    /// Left out: only edges are drawn.
    Wireframe,
    /// Left out: no object in view has faces.
    NoFaces,
    /// Left out: there is no light; faces show their own colour.
    NoLight,
    /// Left out: no object in view takes light.
    Unlit {
        /// In view, with faces.
        objects: usize,
    },
    /// Left out: one light for each face needs no normals of vertices.
    FlatShading,
    /// Runs: one colour for each face.
    LitFaces {
        /// That take light.
        objects: usize,
    },
    /// Runs: one colour for each vertex.
    LitVertices {
        /// That take light.
        objects: usize,
    },
    /// Left to the pixels (Phong); here only normals and positions are passed on.
    LitPixels {
        /// That take light.
        objects: usize,
    },

    /// Runs: on closed or one-sided objects, back faces cannot be seen.
    BackFaces {
        /// Whose back faces are dropped.
        objects: usize,
        /// In view, with faces.
        of: usize,
    },
    /// Left out: both sides of all faces may be seen, because they are two-sided or translucent.
    BothSidesSeen {
        /// In view, with faces.
        objects: usize,
    },

    /// Left out: every object is wholly inside the volume.
    AllInside {
        /// In view.
        objects: usize,
    },
    /// Runs: so many objects may cross so many planes; only they are cut, and only by these.
    Crossing {
        /// That may cross a plane.
        objects: usize,
        /// In view.
        of: usize,
        /// The planes that any of them may cross: bits left, right, bottom, top, near, far from the lowest.
        planes: PlaneSet,
    },

    /// Left out: l = −r and b = −t, so these terms are 0.
    SymmetricWindow,
    /// Runs: the axis does not go through the middle of the window.
    ObliqueWindow,
    /// Left out: w is 1 everywhere.
    ParallelProjection,
    /// Runs: w is the distance from the eye.
    PerspectiveProjection,

    /// Left out: every face has one colour.
    OneColorAFace,
    /// Runs: something varies over a face.
    VariesOverFaces {
        /// On which it does.
        objects: usize,
    },

    /// Left out: a convex closed object alone hides nothing of itself once its back faces are gone, and no line asks for depth.
    ConvexAlone,
    /// Runs: faces of several objects may hide each other.
    SeveralObjects {
        /// In view, with faces.
        objects: usize,
    },
    /// Runs: an object that is not convex, or open, may hide itself.
    HidesItself,
    /// Runs: the hidden parts of lines, marks or texts are drawn otherwise than the visible ones.
    LinesAskForDepth,
    /// Runs: faces are painted from back to front by their centroids.
    PaintedByCentroid,
    /// Runs: faces are painted from back to front, split where they cross each other's planes.
    PaintedBySplitting,

    /// Left out: no object has a picture on it.
    NoTexture,
    /// Runs.
    Textured {
        /// With a picture.
        objects: usize,
    },
    /// Left out: nothing shows through anything.
    AllOpaque,
    /// Runs.
    Translucent {
        /// That something shows through.
        objects: usize,
    },
    /// Left out: one sample for each pixel.
    OneSample,
    /// Runs.
    Samples {
        /// For each pixel.
        samples: u8,
    },

    /// Left out: nothing but faces is in view.
    NoLines,
    /// Runs.
    LinesInView,

    /// The picture shows depths instead of colours: no light, no lines, and depths that vary over faces.
    DepthsShown,
    /// Runs, but too late: the divide by w was asked for before it.
    DividedFirst,
}

/// What the plan says of one stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StagePlan {
    /// Which one.
    pub stage: Stage,
    /// It runs.
    pub runs: bool,
    /// Why, or why not.
    pub reason: Reason,
}

/// Where light is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LitAt {
    /// Nowhere: own colours.
    Nowhere,
    /// Once for each face.
    Faces,
    /// Once for each vertex.
    Vertices,
    /// Once for each pixel.
    Pixels,
}

/// What the plan says of one object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectPlan {
    /// Where its bounding box lies.
    pub place: Place,
    /// It is worked on at all; where not, nothing more is said.
    pub drawn: bool,
    /// The planes that its faces are clipped against.
    pub clip_planes: PlaneSet,
    /// Its faces are drawn.
    pub faces: bool,
    /// Its back faces are dropped, unless the near plane cuts it open.
    pub cull_back: bool,
    /// Where light is computed.
    pub lit: LitAt,
    /// Something shows through it.
    pub translucent: bool,
}

/// What a picture needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// One entry for each object of the scene.
    pub objects: Vec<ObjectPlan>,
    /// One entry for each stage, in order.
    pub stages: Vec<StagePlan>,
    /// The depth of faces is recorded.
    pub depth: bool,
    /// How many boxes, around objects or many of them, were held against the volume.
    pub boxes_tested: usize,
}

/// How a picture is made, other than by what is in it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// Run all stages, needed or not. The picture is the same.
    pub force_all_stages: bool,
    /// Gives the time since any moment, for the report; without it nothing is timed.
    pub clock: Option<fn() -> Duration>,
}

impl Plan {
    /// Plans the picture. `places` are those of the objects; `boxes_tested`: see there.
    pub(super) fn new(
        scene: &Scene,
        projector: &Projector,
        style: &Style,
        (places, boxes_tested): (Vec<Place>, usize),
        force: bool,
    ) -> Self {
        let dark = scene.lights.is_empty();
        let objects = scene.objects.iter().zip(places);
        let objects = objects.map(|(object, place)| plan_object(object, place, style, dark, force));
        let objects: Vec<ObjectPlan> = objects.collect();
        let survey = Survey::new(scene, &objects, style);
        let stages = Stage::ALL
            .map(|stage| {
                let (runs, reason) = survey.stage(stage, projector, style);
                let reason = if force && !runs { Reason::Forced } else { reason };
                StagePlan { stage, runs: runs || force, reason }
            })
            .to_vec();
        let mut plan = Self { objects, stages, depth: true, boxes_tested };
        plan.depth = match plan.order() {
            Visibility::DepthBuffer => plan.runs(Stage::HiddenSurfaces),
            Visibility::Painter | Visibility::Bsp => survey.lines_ask || force,
        };
        plan
    }

    /// What is said of one stage.
    #[must_use]
    pub fn stage(&self, stage: Stage) -> StagePlan {
        // `stages` holds all of them in the order of the enumeration.
        self.stages[stage as usize]
    }

    /// What decides which face is seen: the style's choice, where faces may hide each other at all.
    #[must_use]
    pub fn order(&self) -> Visibility {
        match self.stage(Stage::HiddenSurfaces).reason {
            Reason::PaintedByCentroid => Visibility::Painter,
            Reason::PaintedBySplitting => Visibility::Bsp,
            _ => Visibility::DepthBuffer,
        }
    }

    /// True where `stage` runs.
    #[must_use]
    pub fn runs(&self, stage: Stage) -> bool {
        self.stage(stage).runs
    }
}

fn plan_object(object: &Object, place: Place, style: &Style, dark: bool, force: bool) -> ObjectPlan {
    let drawn = match place {
        Place::Crosses(_) => true,
        Place::Outside(_) => force,
        Place::Empty => false,
    };
    if !drawn {
        return ObjectPlan {
            place,
            drawn,
            clip_planes: 0,
            faces: false,
            cull_back: false,
            lit: LitAt::Nowhere,
            translucent: false,
        };
    }
    let clip_planes = match place {
        Place::Crosses(planes) if !force => planes,
        _ => ALL_PLANES,
    };
    let translucent = object.paint.is_translucent();
    let vertex_colors = matches!(object.paint, ObjectPaint::Vertices(_));
    let lit = match style.shading {
        _ if !object.lit || matches!(object.paint, ObjectPaint::Texture { .. }) => LitAt::Nowhere,
        _ if dark && !force => LitAt::Nowhere,
        // Without a lamp the formula gives each colour back, wherever it is applied.
        _ if dark && vertex_colors => LitAt::Vertices,
        _ if dark => LitAt::Faces,
        Shading::Wireframe if !force => LitAt::Nowhere,
        Shading::Wireframe | Shading::Flat => LitAt::Faces,
        Shading::Gouraud => LitAt::Vertices,
        // What is lit at the pixels has one colour.
        Shading::Phong if vertex_colors => LitAt::Vertices,
        Shading::Phong => LitAt::Pixels,
    };
    ObjectPlan {
        place,
        drawn,
        clip_planes,
        faces: object.faces && !object.mesh.triangles.is_empty() && (force || style.shading != Shading::Wireframe),
        cull_back: !(object.two_sided || (object.mesh.closed && translucent)),
        lit,
        translucent,
    }
}

/// The counts on which the plan of a frame rests. Of objects in view only, and of their faces only where there are any.
struct Survey {
    objects: usize,
    outside: usize,
    in_view: usize,
    crossing: usize,
    planes: PlaneSet,
    faces: usize,
    culled: usize,
    lit: LitAt,
    lit_objects: usize,
    dark: bool,
    varies: usize,
    textured: usize,
    translucent: usize,
    hides_itself: bool,
    lines_ask: bool,
    lines: bool,
}

impl Survey {
    fn new(scene: &Scene, plans: &[ObjectPlan], style: &Style) -> Self {
        let in_view: Vec<(&Object, &ObjectPlan)> =
            scene.objects.iter().zip(plans).filter(|(_, plan)| matches!(plan.place, Place::Crosses(_))).collect();
        let wireframe = style.shading == Shading::Wireframe;
        let faces: Vec<_> = in_view.iter().filter(|(_, plan)| plan.faces && !wireframe).collect();
        let lit: Vec<_> = faces.iter().filter(|(_, plan)| plan.lit != LitAt::Nowhere).collect();
        let planes = |plan: &ObjectPlan| match plan.place {
            Place::Crosses(planes) => planes,
            Place::Outside(_) | Place::Empty => 0,
        };
        let asks = |hidden: HiddenLines| hidden != HiddenLines::Shown;
        // The inside of an object that the near plane may cut open is hidden by its outside.
        let hides_itself = |object: &Object, plan: &ObjectPlan| {
            !(object.mesh.convex && object.mesh.closed && plan.cull_back && planes(plan) & NEAR == 0)
        };
        Self {
            objects: scene.objects.len(),
            outside: plans.iter().filter(|plan| matches!(plan.place, Place::Outside(_))).count(),
            in_view: in_view.len(),
            crossing: in_view.iter().filter(|(_, plan)| planes(plan) != 0).count(),
            planes: in_view.iter().fold(0, |all, (_, plan)| all | planes(plan)),
            faces: faces.len(),
            culled: faces.iter().filter(|(_, plan)| plan.cull_back).count(),
            lit: lit.first().map_or(LitAt::Nowhere, |(_, plan)| plan.lit),
            lit_objects: lit.len(),
            dark: scene.lights.is_empty(),
            varies: faces.iter().filter(|(object, plan)| Shaded::interpolates(object, plan.lit)).count(),
            textured: faces.iter().filter(|(object, _)| matches!(object.paint, ObjectPaint::Texture { .. })).count(),
            translucent: faces.iter().filter(|(_, plan)| plan.translucent).count(),
            hides_itself: faces.iter().any(|(object, plan)| hides_itself(object, plan)),
            lines_ask: in_view.iter().any(|(object, _)| object.edges.is_some_and(|style| asks(style.hidden)))
                || scene.lines.iter().any(|line| asks(line.style.hidden))
                || scene.marks.iter().any(|mark| mark.fade_if_hidden)
                || scene.texts.iter().any(|text| text.fade_if_hidden),
            lines: in_view.iter().any(|(object, _)| wireframe || object.edges.is_some())
                || !(scene.lines.is_empty() && scene.marks.is_empty() && scene.texts.is_empty()),
        }
    }

    /// Whether a stage is needed, and why.
    fn stage(&self, stage: Stage, projector: &Projector, style: &Style) -> (bool, Reason) {
        let no_faces = match style.shading {
            Shading::Wireframe => Some((false, Reason::Wireframe)),
            _ if self.in_view == 0 => Some((false, Reason::NothingInView)),
            _ if self.faces == 0 => Some((false, Reason::NoFaces)),
            _ => None,
        };
        let with_faces = |otherwise: (bool, Reason)| no_faces.unwrap_or(otherwise);
        match stage {
            Stage::Transform | Stage::Oblique | Stage::Divide | Stage::Viewport if self.in_view == 0 && !self.lines => {
                (false, Reason::NothingInView)
            }
            Stage::Traverse | Stage::Write => (true, Reason::Always),
            Stage::Viewport | Stage::Transform => (true, Reason::SomethingInView),
            Stage::CullObjects if self.outside == 0 => (false, Reason::NoneOutside { of: self.objects }),
            Stage::CullObjects => (true, Reason::Outside { outside: self.outside, of: self.objects }),
            Stage::Normals | Stage::Light => with_faces(self.light(stage)),
            Stage::CullFaces => with_faces(match self.culled {
                0 => (false, Reason::BothSidesSeen { objects: self.faces }),
                objects => (true, Reason::BackFaces { objects, of: self.faces }),
            }),
            Stage::Clip if self.in_view == 0 => (false, Reason::NothingInView),
            Stage::Clip if self.crossing == 0 => (false, Reason::AllInside { objects: self.in_view }),
            Stage::Clip => (true, Reason::Crossing { objects: self.crossing, of: self.in_view, planes: self.planes }),
            Stage::Oblique if projector.shift == [0.0, 0.0] => (false, Reason::SymmetricWindow),
            Stage::Oblique => (true, Reason::ObliqueWindow),
            Stage::Divide if projector.perspective => (true, Reason::PerspectiveProjection),
            Stage::Divide => (false, Reason::ParallelProjection),
            Stage::Fill => with_faces((true, Reason::FacesInView { objects: self.faces })),
            Stage::Interpolate => with_faces(match self.varies {
                0 => (false, Reason::OneColorAFace),
                objects => (true, Reason::VariesOverFaces { objects }),
            }),
            Stage::HiddenSurfaces => with_faces(self.hidden_surfaces(style)),
            Stage::Texture => with_faces(match self.textured {
                0 => (false, Reason::NoTexture),
                objects => (true, Reason::Textured { objects }),
            }),
            Stage::Blend => with_faces(match self.translucent {
                0 => (false, Reason::AllOpaque),
                objects => (true, Reason::Translucent { objects }),
            }),
            Stage::Antialias => with_faces(match style.antialias {
                0 | 1 => (false, Reason::OneSample),
                samples => (true, Reason::Samples { samples }),
            }),
            Stage::Lines if self.lines => (true, Reason::LinesInView),
            Stage::Lines if self.in_view == 0 => (false, Reason::NothingInView),
            Stage::Lines => (false, Reason::NoLines),
        }
    }

    fn light(&self, stage: Stage) -> (bool, Reason) {
        let objects = self.lit_objects;
        match self.lit {
            _ if self.dark => (false, Reason::NoLight),
            LitAt::Nowhere => (false, Reason::Unlit { objects: self.faces }),
            LitAt::Faces if stage == Stage::Normals => (false, Reason::FlatShading),
            LitAt::Faces => (true, Reason::LitFaces { objects }),
            LitAt::Vertices => (true, Reason::LitVertices { objects }),
            LitAt::Pixels if stage == Stage::Light => (false, Reason::LitPixels { objects }),
            LitAt::Pixels => (true, Reason::LitPixels { objects }),
        }
    }

    fn hidden_surfaces(&self, style: &Style) -> (bool, Reason) {
        if self.faces > 1 || self.hides_itself {
            return (
                true,
                match style.visibility {
                    Visibility::Painter => Reason::PaintedByCentroid,
                    Visibility::Bsp => Reason::PaintedBySplitting,
                    Visibility::DepthBuffer if self.faces > 1 => Reason::SeveralObjects { objects: self.faces },
                    Visibility::DepthBuffer => Reason::HidesItself,
                },
            );
        }
        if self.lines_ask { (true, Reason::LinesAskForDepth) } else { (false, Reason::ConvexAlone) }
    }
}
