//! scene + camera → [`Drawing`]: the stages in the order of the notes `[3]` §1.1.
//!
//! | stage | space, from → to | file |
//! | --- | --- | --- |
//! | plan: the stages needed | – | [`plan`] |
//! | objects outside the volume dropped | object → view | `bounds`, `cull` |
//! | depths spread over those in view | view | [`depths`] |
//! | each vertex transformed once | object → world → view → clip → ndc → pixels | `projector`, `transform` |
//! | back faces dropped | pixels | `faces`, `cull` |
//! | clipping, before the divide | clip | `faces`, `clip` |
//! | light on the remaining faces | view | `light`, `shade` |
//! | order of faces, where no depth buffer decides | view | `hidden_surfaces`, `bsp`, `visibility` |
//! | edges, outlines, lines, marks, texts | world → pixels | `lines`, `outline` |
//!
//! Light comes last although the notes have it second: only faces that are left need any. Filling, hidden surfaces,
//! blending and smoothing are the output's ([`raster`](crate::raster)). [`project`] takes the scene only as far as ndc.
//! [`Pipeline::frame`] takes the objects through the stages one by one, each by `object_pass`; `recorder` counts and
//! times them, and notes in `stage_work` what goes into the stage that a picture shows, and what comes out.
//! [`clip_parts`], [`cull_result`], [`one_triangle`] and [`divide_before_clip`] are not on the way to a picture: they
//! show what clipping and culling do, and what would come of dividing first.
//!
//! A drawing for an output without a depth buffer is completed by [`stroke_runs`], the parts of its strokes that faces
//! hide, and [`stroke_order`], their order in depth.
//!
//! All cutting is done by `cut`, and all attributes of vertices are carried over by `resample`.

pub mod budget;
mod mesh;
mod object_pass;
mod order;
pub mod plan;
pub mod report;
mod scenes;
mod show;
mod space;
mod stage;

use crate::appearance::{DepthFormat, Rgba, Shading, Style, Visibility};
use crate::camera::Camera;
use crate::drawing::Drawing;
use crate::limits::MAX_PIECES;
use crate::progress::Progress;
use crate::scene::Scene;
pub use budget::{MisplacedVertex, OverBudget};
use mesh::bounds::KnownBounds;
pub use mesh::resample::with_triangles;
use object_pass::{ObjectPass, PassContext};
pub use order::{stroke_order, stroke_runs};
pub use plan::{Containment, FacesDone, ObjectReport, Options, Output, Plan, Reason, Stage};
use report::Meter;
pub use report::operations;
use report::recorder::Recorder;
use report::rounding_check::Misplaced;
pub use report::work::{ObjectWork, StageWork, VertexWork};
pub use report::{FollowedTriangle, Frame, StageReport};
pub use scenes::Scenes;
pub use show::canonical as project;
pub use show::{clip_parts, cull_result, divide_before_clip, one_triangle, shadow_rays};
pub use space::depths;
use space::depths::InView;
pub use space::planes::{NEAR, PlaneSet};
use space::projector::Projector;
use space::screen::Screen;
use stage::cull_objects::cull_objects;
use stage::faces::Faces;
use stage::hidden_surfaces::{Unordered, hidden_surfaces};
use stage::lines::{self, Strokes, lines};
use stage::pool::Pool;
pub use stage::reflection as light;
use stage::reflection::Lights;
pub use stage::shadow_maps::{ShadowMaps, light_cameras};
use stage::traverse::traverse;

/// The picture to make: its size in pixels, and how large a stroke's or letter's unit is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
    /// Pixels of this picture for one unit of stroke width or type size.
    pub scale: f32,
    /// Ground of the picture.
    pub background: Rgba,
}

/// Draws `scene` as `camera` sees it. The view window fills the whole target: who wants no distortion gives a target
/// with the window's aspect.
#[must_use]
pub fn draw(scene: &Scene, camera: &Camera, target: Target, style: &Style) -> Drawing {
    Pipeline::default().frame(scene, camera, target, style, Options::default()).drawing
}

/// All faces of a scene as a light sees them, for its shadow map: depths are 1 at F and 0 at B.
fn seen_by_light(scene: &Scene, camera: &Camera, size: u32) -> Drawing {
    let target = Target { width: size, height: size, scale: 1.0, background: Rgba::rgb(0, 0, 0) };
    let style = Style { shading: Shading::Flat, visibility: Visibility::DepthBuffer, antialias: 1, ..Style::default() };
    let options = Options { depth_of_volume: true, ..Options::default() };
    let mut drawing = Pipeline::default().frame(scene, camera, target, &style, options).drawing;
    drawing.surfaces.iter_mut().for_each(|surface| surface.depth_test = true);
    drawing
}

/// Draws pictures one after the other; reuses its buffers, and the bounds of meshes.
#[derive(Debug)]
pub struct Pipeline {
    faces: Faces,
    pool: Pool,
    bounds: KnownBounds,
    shadows: ShadowMaps,
    progress: Progress,
    /// The most pieces of faces that a BSP may make: [`MAX_PIECES`], and fewer in tests.
    pub max_pieces: usize,
}

impl Default for Pipeline {
    fn default() -> Self {
        Self {
            faces: Faces::default(),
            pool: Pool::default(),
            bounds: KnownBounds::default(),
            shadows: ShadowMaps::default(),
            progress: Progress::default(),
            max_pieces: MAX_PIECES,
        }
    }
}

/// A clone begins with empty buffers.
impl Clone for Pipeline {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl Pipeline {
    /// Says from now on how far a drawing has come. One that is cancelled ends early, and is not whole.
    pub fn watch(&mut self, progress: &Progress) {
        self.progress = progress.clone();
    }

    /// Draws as [`draw`] does, and tells what was done. A scene and the gear of a picture are handed over side by side.
    #[must_use]
    pub fn frame<'a>(
        &mut self,
        scenes: impl Into<Scenes<'a>>,
        camera: &Camera,
        target: Target,
        style: &Style,
        options: Options,
    ) -> Frame {
        let (scenes, screen, meter) = (scenes.into(), Screen::new(target), Meter::new(options));
        let mut projector = Projector::new(camera);

        let extents = cull_objects(scenes, &projector, &mut self.bounds);
        let in_view = extents.iter().fold(InView::NOTHING, |all, extent| all.and(extent.in_view));
        if !options.depth_of_volume {
            let in_view = in_view.and(lines::in_view(scenes, &projector));
            projector.depths = projector.depths.resolving(in_view);
        }
        let misplaced = Misplaced::new(camera, &screen, in_view);
        let plan = Plan::new(scenes, &projector, style, &extents, options);
        let lights = Lights::new(scenes.lights(), &projector, style.shading);
        let is_dark = style.shading == Shading::Wireframe;
        let shadows = if is_dark { Vec::new() } else { self.shadows.of(scenes) };
        let context = PassContext {
            plan: &plan,
            projector: &projector,
            screen: &screen,
            lights: &lights,
            shadows: &shadows,
            style,
            options,
        };
        let mut recorder = Recorder::new(meter, misplaced, scenes, context);
        let (faces, pool) = (&mut self.faces, &mut self.pool);
        let mut strokes = Strokes::new(&projector, &screen, target, scenes.fineness(), pool);
        let mut unordered = Unordered::default();

        for (index, object, planned) in traverse(scenes, &plan) {
            if self.progress.is_cancelled() {
                break;
            }
            let pass = ObjectPass::new(index, object, planned, context);
            if planned.faces {
                // Transform, oblique window, divide and viewport: one loop takes a vertex through all of them.
                pass.transform(faces, pool);
                recorder.transformed(&pass);
                pass.cull_faces(faces);
                recorder.culled(&pass, faces);
                pass.clip(faces);
                recorder.clipped(&pass, faces, unordered.surfaces.len());
                // The notes have light and its normals second: only faces that are left need any.
                pass.light(faces, pool, &mut unordered);
                recorder.meter.lap(Stage::Light);
            }
            let ends = pass.lines(&mut strokes);
            recorder.drawn(&pass, ends);
        }

        if style.shading == Shading::Wireframe {
            // Forced, but only edges were requested.
            unordered = Unordered::default();
        }
        let ordered = hidden_surfaces(unordered, plan.order, (&projector, &screen), self.max_pieces, &self.progress);
        recorder.meter.pieces = ordered.pieces;
        recorder.meter.lap(Stage::HiddenSurfaces);

        let (marks, labels) = lines(&mut strokes, scenes, style);
        recorder.meter.lines = (strokes.asked, strokes.drawn() + marks.len() + labels.len());
        recorder.meter.lap(Stage::Lines);

        let drawing = Drawing {
            width: target.width,
            height: target.height,
            background: target.background,
            antialias: style.antialias,
            // Without faces any order is right.
            painted_in_order: ordered.given_up.is_none()
                && (plan.order != Visibility::DepthBuffer || options.output == Output::Vectors),
            depth_format: DepthFormat::default(),
            surfaces: ordered.surfaces,
            strokes: strokes.into_sets(pool),
            areas: Vec::new(),
            marks,
            labels,
        };
        let mut frame = recorder.frame(drawing, scenes);
        if let Some((pieces, over_budget)) = ordered.given_up {
            frame.say(Stage::HiddenSurfaces, Reason::TooManyPieces { pieces });
            frame.too_much = Some(over_budget);
        }
        frame
    }

    /// Takes its shadow maps from these, which other pipelines share.
    pub fn share_shadows(&mut self, shadows: &ShadowMaps) {
        self.shadows = shadows.clone();
    }

    /// Forgets shadow maps: the next picture makes its own.
    pub fn forget(&mut self) {
        self.shadows.forget();
    }

    /// Takes back a drawing that is no longer needed: the next one is made in its memory.
    pub fn recycle(&mut self, drawing: Drawing) {
        self.pool.keep(drawing);
    }
}
