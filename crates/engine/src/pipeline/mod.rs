//! scene + camera → [`Drawing`]: the stages of the notes `[3]` §1.1.
//!
//! [`Pipeline::frame`] is the pipeline on one page. Each stage is a function under its own name in `stage`, one file
//! each, and the head of a file says what the notes have, what the textbook does, and what we do instead. Start with
//! `stage/vertices.rs`, the way of a vertex. The rasterizer's half begins with [`textbook`](crate::raster::textbook).
//!
//! | folder | holds |
//! | --- | --- |
//! | `stage` | the stages: traverse, cull objects, transform, … light, hidden surfaces, lines |
//! | `plan` | which stages a picture needs, and the reason for each |
//! | `order` | the order in which faces and strokes are painted if no depth buffer decides |
//! | `space` | the spaces of a point as types, the camera between them, the planes of the volume, the scale of depths |
//! | `mesh` | parts that stages share: bounds, cutting by a plane, attributes of new vertices, outlines |
//! | `report` | the report of a picture: counts, times, operations, rounding |
//! | `show` | the inner work made visible; no picture needs it: the canonical volume ([`canonical`]), [`clip_parts`], [`cull_result`], [`one_triangle`], [`divide_before_clip`], [`shadow_rays`] |
//!
//! A folder uses those that come before it in this order: `space`, `mesh`, `plan`, `order`, `stage`, `show`, `report`.
//! `object_pass` takes one object through its stages. `scenes` holds the objects of a picture, `budget` the limits that
//! a picture may exceed.
//!
//! Light comes last of an object's stages although the notes have it second: only the faces that are left need any.
//! Filling, hidden surfaces by depth, blending and smoothing are the rasterizer's ([`raster`](crate::raster)).
//!
//! A drawing for an output without a depth buffer is completed by [`stroke_runs`], which finds the parts of strokes
//! that faces hide, and [`stroke_order`], their order in depth.

pub mod budget;
mod mesh;
mod object_pass;
pub mod plan;
pub mod report;
mod scenes;
mod space;
mod stage;

/// Reveals the inner work of the pipeline. No picture of a scene needs any of it.
mod show {
    pub mod canonical;
    pub mod clip_parts;
    pub mod cull_result;
    pub mod divide_before_clip;
    pub mod one_triangle;
    mod projected;
    pub mod shadow_rays;
}

/// The order in which faces and strokes are painted if no depth buffer decides.
mod order {
    pub(crate) mod bsp;
    pub(crate) mod painter;
    pub(crate) mod pieces;
    pub mod stroke_order;
    pub mod stroke_runs;
}

use crate::appearance::{Rgba, Samples, Shading, Style, SubpixelBits, VertexFormat, Visibility};
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
use report::recorder::Recorder;
use report::rounding_check::Misplaced;
pub use report::rounding_check::infinite_faces;
pub use report::work::{ObjectWork, StageWork, VertexWork};
pub use report::{FollowedTriangle, Frame, StageReport, operations};
pub use scenes::Scenes;
pub use show::{canonical, clip_parts, cull_result, divide_before_clip, one_triangle, shadow_rays};
use space::Screen;
use space::depths::InView;
use space::projector::Projector;
pub use space::{NEAR, PlaneSet, depths};
use stage::cull_objects::cull_objects;
use stage::faces::Faces;
use stage::hidden_surfaces::{PieceBudget, Unordered, hidden_surfaces};
use stage::lines::{self, Strokes, lines};
pub use stage::reflection;
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

/// Draws `scene` as `camera` sees it. The view window fills the whole target, without distortion only if the target has
/// the window's aspect.
pub fn draw(scene: &Scene, camera: &Camera, target: Target, style: &Style) -> Drawing {
    Pipeline::default().frame(scene, camera, target, style, Options::default()).drawing
}

/// All faces of a scene as a light sees them, for its shadow map: depths are 1 at F and 0 at B.
fn seen_by_light(scene: &Scene, camera: &Camera, size: u32) -> Drawing {
    let target = Target { width: size, height: size, scale: 1.0, background: Rgba::rgb(0, 0, 0) };
    let style = Style {
        shading: Shading::Flat,
        visibility: Visibility::DepthBuffer,
        antialias: Samples::One,
        ..Style::default()
    };
    let options = Options { depth_of_volume: true, ..Options::default() };
    let mut drawing = Pipeline::default().frame(scene, camera, target, &style, options).drawing;
    drawing.surfaces.iter_mut().for_each(|surface| surface.depth_test = true);
    drawing
}

/// Draws pictures one after the other. Reuses its buffers, and the bounds of meshes.
#[derive(Debug, Default)]
pub struct Pipeline {
    faces: Faces,
    bounds: KnownBounds,
    shadows: ShadowMaps,
    progress: Progress,
    /// The most pieces into which the BSP may split faces. `None` means [`MAX_PIECES`].
    pub max_pieces: Option<usize>,
}

/// A clone has the limit of pieces, and begins with empty buffers and shadow maps of its own.
impl Clone for Pipeline {
    fn clone(&self) -> Self {
        Self { max_pieces: self.max_pieces, ..Self::default() }
    }
}

impl Pipeline {
    /// Reports from now on how far a drawing has come. A cancelled drawing ends early and isn't whole.
    pub fn watch(&mut self, progress: &Progress) {
        self.progress = progress.clone();
    }

    /// Draws as [`draw`] does, and reports what each stage did. `scenes`: a scene, or a scene with the gear of a
    /// picture next to it.
    pub fn frame<'a>(
        &mut self,
        scenes: impl Into<Scenes<'a>>,
        camera: &Camera,
        target: Target,
        style: &Style,
        options: Options,
    ) -> Frame {
        let (scenes, meter) = (scenes.into(), Meter::new(options));
        let screen = Screen { steps: style.subpixel_bits.steps(), ..Screen::new(target) };
        let mut projector = Projector::new(camera);
        projector.format = style.vertex_format;

        // The objects that may be in view, how their depths are stored, and which stages are needed.
        let extents = cull_objects(scenes, &projector, &mut self.bounds);
        let in_view = extents.iter().fold(InView::NOTHING, |all, extent| all.and(extent.in_view));
        // The depths of a narrow format are z_r/w_r.
        if !options.depth_of_volume && style.vertex_format == VertexFormat::F64 {
            let in_view = in_view.and(lines::in_view(scenes, &projector));
            projector.depths = projector.depths.resolving(in_view);
        }
        let misplaced = Misplaced::new(camera, &screen, in_view);
        let plan = Plan::new(scenes, &projector, style, &extents, options);
        let lights = Lights::new(scenes.lights, &projector, style.shading);
        let is_wireframe = style.shading == Shading::Wireframe;
        let shadows = if is_wireframe { Vec::new() } else { self.shadows.of(scenes) };
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
        let faces = &mut self.faces;
        let mut strokes = Strokes::new(&projector, &screen, target, scenes.fineness);
        let mut unordered = Unordered::default();

        for (index, object, planned) in traverse(scenes, &plan) {
            if self.progress.is_cancelled() {
                break;
            }
            let pass = ObjectPass::new(index, object, planned, context);
            if planned.faces {
                // Transform, oblique window, divide and viewport, in one loop over the vertices.
                pass.transform(faces);
                recorder.transformed(&pass);
                pass.cull_faces(faces);
                recorder.culled(&pass, faces);
                pass.clip(faces);
                recorder.clipped(&pass, faces, unordered.surfaces.len());
                // Normals and light. The notes have them second, but only faces that are left need any.
                pass.light(faces, &mut unordered);
                recorder.meter.lap(Stage::Light);
            }
            let ends = pass.lines(&mut strokes);
            recorder.drawn(&pass, ends);
        }

        if is_wireframe {
            // All stages were forced, but a wireframe shows no faces.
            unordered = Unordered::default();
        }
        let max_pieces = self.max_pieces.unwrap_or(MAX_PIECES);
        let budget = PieceBudget { max_pieces, own_objects: scenes.own_object_count() };
        let ordered = hidden_surfaces(unordered, plan.order, (&projector, &screen), budget, &self.progress);
        recorder.meter.pieces = ordered.pieces;
        recorder.meter.lap(Stage::HiddenSurfaces);

        let (marks, labels) = lines(&mut strokes, scenes, style);
        recorder.meter.lines = (strokes.asked, strokes.drawn() + marks.len() + labels.len());
        recorder.meter.lap(Stage::Lines);

        let drawing = Drawing {
            antialias: style.antialias,
            // Without faces any order is right.
            painted_in_order: ordered.given_up.is_none()
                && (plan.order != Visibility::DepthBuffer || options.output == Output::Vectors),
            fine_grid: style.subpixel_bits == SubpixelBits::Twelve,
            surfaces: ordered.surfaces,
            strokes: strokes.sets,
            marks,
            labels,
            ..Drawing::new(target.width, target.height, target.background)
        };
        let mut frame = recorder.frame(drawing, scenes);
        if let Some((pieces, over_budget)) = ordered.given_up {
            frame.say(Stage::HiddenSurfaces, Reason::TooManyPieces { pieces });
            frame.over_budget = over_budget.or(frame.over_budget);
        }
        frame
    }

    /// Shares these shadow maps with other pipelines.
    pub fn share_shadows(&mut self, shadows: &ShadowMaps) {
        self.shadows = shadows.clone();
    }

    /// Forgets all shadow maps. The next picture makes its own.
    pub fn forget(&mut self) {
        self.shadows.forget();
    }
}
