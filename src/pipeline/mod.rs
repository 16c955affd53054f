//! scene + camera → [`Drawing`]: the stages in the order of the notes `[3]` §1.1.
//!
//! | stage | space, from → to | file |
//! | --- | --- | --- |
//! | plan: the stages needed | – | [`plan`] |
//! | objects outside the volume dropped | object, world | `bounds`, `bounding_tree`, `cull` |
//! | depths spread over those in view | view | [`depths`] |
//! | each vertex transformed once | object → world → view → clip → ndc → pixels | `projector`, `transform` |
//! | back faces dropped | pixels | `faces`, `cull` |
//! | clipping, before the divide | clip | `faces`, `clip` |
//! | light on what is left | view | `light`, `shade` |
//! | order of faces, where no depth buffer decides | view | `visibility` |
//! | edges, outlines, lines, marks, texts | world → pixels | `lines`, `outline` |
//!
//! Light comes last although the notes have it second: only faces that are left need any. Filling, hidden surfaces,
//! blending and smoothing are the output's ([`raster`](crate::raster)). [`project`] takes the scene only as far as ndc.
//! What goes into a stage and comes out of it is noted by `stage_work`, where a picture shows it. [`clip_parts`],
//! [`cull_result`], [`one_triangle`] and [`divide_before_clip`] are not on the way to a picture: they show what
//! clipping and culling do, and what would come of dividing first.
//!
//! A drawing for an output without a depth buffer is completed by [`stroke_runs`], the parts of its strokes that faces
//! hide, and [`stroke_order`], their order in depth.
//!
//! All cutting is done by `cut`, and all attributes of vertices are carried over by `resample`.
//!
//! | file | purpose |
//! | --- | --- |
//! | `bounding_tree` | a tree of boxes over the scene, so that objects out of sight are dropped by the thousand |
//! | `bounds` | bounds of a mesh, known before it is looked at: the box and the ball around it |
//! | `budget` | budgets of a drawing, and its shortfall where one is exceeded |
//! | `clip` | clipping in homogeneous coordinates, before the divide `[2]`: points behind the eye never reach it |
//! | `clip_parts` | the parts of the scene that clipping keeps and removes |
//! | `cull` | culling: objects outside the volume, and back faces |
//! | `cull_result` | the result of culling an object, for showing the faces that are not drawn |
//! | `cut` | the one way in which a polygon, or a segment, is cut by a plane |
//! | `depths` | the range of distances resolved by the depths of a picture |
//! | `divide_before_clip` | the result of dividing by w before clipping: the mistake that homogeneous clipping avoids `[2]` |
//! | `faces` | the faces of one object that are left to draw: projected, culled, clipped |
//! | `light` | light on faces and vertices, by the one formula of `lighting` |
//! | `lines` | edges and lines → strokes: clipped, projected, grouped by style |
//! | `one_triangle` | one triangle step by step, as every triangle goes |
//! | `outline` | the outline of a curved solid: its silhouette, which depends on the viewpoint, and its creases |
//! | `plan` | the stages that a picture needs, and the reason why each other one is left out |
//! | `plan_counts` | counts of planned or finished work, and the reasons that follow from them |
//! | `planes` | the six planes of the view volume |
//! | `pool` | reuse of the memory of returned drawings: fresh memory costs more than writing to it |
//! | `project` | the scene after clipping and projection: the content of the canonical volume |
//! | `projector` | the camera as the pipeline applies it, point by point: object → world → view → clip, in `f64` |
//! | `report` | the report of a picture: counts and times, stage by stage |
//! | `resample` | attributes of the vertices that cutting makes: colours, normals, texture coordinates … |
//! | `rounding_check` | detection of vertices that rounding misplaces in the picture, by the code that draws them |
//! | `shade` | surfaces of the drawing from the faces that are left |
//! | `stage_work` | input and output of a stage, recorded while a picture is made, so that the picture can show them |
//! | `stages` | reasons of stages, plans and reports of objects |
//! | `stroke_order` | the order of strokes for outputs that have no depth buffer: later strokes cover earlier ones |
//! | `stroke_runs` | the visible and the hidden runs of strokes, for outputs that have no depth buffer |
//! | `transform` | the vertices of an object on the image |
//! | `visibility` | the order of faces where no depth buffer decides |

mod bounding_tree;
mod bounds;
pub mod budget;
mod clip;
pub mod clip_parts;
mod cull;
pub mod cull_result;
mod cut;
pub mod depths;
pub mod divide_before_clip;
mod faces;
pub mod light;
mod lines;
pub mod one_triangle;
mod outline;
pub mod plan;
mod plan_counts;
mod planes;
mod pool;
pub mod project;
mod projector;
pub mod report;
mod resample;
mod rounding_check;
mod shade;
mod stage_work;
mod stages;
pub mod stroke_order;
pub mod stroke_runs;
mod transform;
mod visibility;

use crate::appearance::{Rgba, Shading, Style, Visibility};
use crate::camera::Camera;
use crate::drawing::{Drawing, Surface};
use crate::limits::MAX_PIECES;
use crate::progress::Progress;
use crate::scene::Scene;
use bounding_tree::BoundingTree;
pub use budget::OverBudget;
pub use cull::Containment;
use faces::{FaceTask, Faces};
use light::Lights;
use lines::Strokes;
pub use plan::{Options, Output, Plan, Reason, Stage};
use plan_counts::Survey;
pub use planes::{NEAR, PlaneSet};
use pool::Pool;
use projector::Projector;
use report::Meter;
pub use report::{FollowedTriangle, Frame, StageReport};
pub use resample::with_triangles;
use rounding_check::Misplaced;
pub use rounding_check::MisplacedVertex;
use shade::Shaded;
use stage_work::Notes;
pub use stage_work::{ObjectWork, StageWork, VertexWork};
use stages::LitAt;
pub use stages::{FacesDone, ObjectReport};
use transform::{Screen, Vertices};
use visibility::{Layer, TooManyPieces};

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

/// Draws pictures one after the other; reuses its buffers, and the bounds of meshes.
#[derive(Debug)]
pub struct Pipeline {
    faces: Faces,
    pool: Pool,
    tree: BoundingTree,
    progress: Progress,
    /// [`MAX_PIECES`]; tests have fewer.
    pub(crate) max_pieces: usize,
}

impl Default for Pipeline {
    fn default() -> Self {
        Self {
            faces: Faces::default(),
            pool: Pool::default(),
            tree: BoundingTree::default(),
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

    /// Draws as [`draw`] does, and tells what was done.
    #[must_use]
    pub fn frame(&mut self, scene: &Scene, camera: &Camera, target: Target, style: &Style, options: Options) -> Frame {
        let mut meter = Meter::new(options);
        let mut projector = Projector::new(camera);
        let screen = Screen::new(target);
        let places = self.tree.places(scene, &projector);
        if !options.depth_of_volume {
            let in_view = places.in_view.and(lines::in_view(scene, &projector));
            projector.depths = projector.depths.resolving(in_view);
        }
        let mut misplaced = Misplaced::new(camera, &screen, places.in_view);
        let plan = Plan::new(scene, &projector, style, places, options);
        let lights = Lights::new(&scene.lights, &projector, style.shading);
        let mut strokes = Strokes::new(&projector, &screen, target);
        let (faces, pool) = (&mut self.faces, &mut self.pool);
        let mut done: Vec<ObjectReport> = plan.objects.iter().map(ObjectReport::new).collect();
        let (mut surfaces, mut layers, mut of_object) = (Vec::new(), Vec::new(), Vec::new());
        let mut notes = options.shown.map(|stage| Notes::new(stage, &projector, &screen));
        if let Some(notes) = &mut notes {
            notes.objects(scene, &plan);
        }
        meter.lap(Stage::Traverse);

        let mut followed = None;
        let objects = scene.objects.iter().zip(&plan.objects).zip(&mut done).enumerate();
        for (index, ((object, todo), done)) in objects.filter(|(_, ((_, todo), _))| todo.drawn) {
            if self.progress.is_cancelled() {
                break;
            }
            let view_from_object = projector.view_from_object(object.world_from_object);
            let mesh = &object.mesh;
            let vertices =
                Vertices { projector: &projector, view_from_object: &view_from_object, positions: &mesh.positions };
            if todo.faces {
                let interpolates = projector.perspective && Shaded::interpolates(object, todo.lit);
                pool.refill(faces);
                faces.image.fill(&vertices, &screen, todo.clip_planes != 0, interpolates);
                if let Some(notes) = &mut notes {
                    notes.vertices(object, &vertices, &lights);
                }
                meter.lap(Stage::Transform);

                let cut_open = mesh.closed && faces.cut_open();
                let cull_back = todo.cull_back && !cut_open;
                let task = FaceTask {
                    cull_back,
                    watch_turning: !plan.depth,
                    want_source: Shaded::colors_faces(object, todo.lit) || options.followed.is_some(),
                    want_used: todo.lit == LitAt::Vertices,
                };
                faces.cull(&vertices, &mesh.triangles, task);
                if let Some(notes) = &mut notes {
                    notes.culled(&vertices, &mesh.triangles, faces);
                }
                meter.lap(Stage::CullFaces);

                faces.clip(&vertices, &screen, task.want_source, options.force_all_stages);
                if let Some(notes) = &mut notes {
                    notes.clipped(&vertices, faces);
                }
                meter.lap(Stage::Clip);
                if let Some((_, triangle)) = options.followed.filter(|(of, _)| *of == index) {
                    let its = (0..).zip(&faces.source).filter(|(_, source)| **source == triangle).map(|(i, _)| i);
                    followed = Some(FollowedTriangle { surface: surfaces.len(), triangles: its.collect() });
                }
                done.triangles = faces.triangles.len();
                done.lit = todo.lit;
                done.faces = match cull_back {
                    true => FacesDone::BackDropped,
                    false if todo.cull_back => FacesDone::CutOpen,
                    false => FacesDone::BothSides,
                };
                meter.count(&vertices, faces, object, done);

                let shaded = Shaded {
                    object,
                    vertices,
                    lights: &lights,
                    lit: todo.lit,
                    both_sides: object.two_sided || cut_open || (mesh.closed && todo.translucent),
                    depth_test: plan.depth || (faces.turned_over > 0 && plan.order == Visibility::DepthBuffer),
                };
                if plan.order == Visibility::DepthBuffer {
                    surfaces.extend(shaded.surfaces(faces, pool));
                } else {
                    let never_hides_itself = mesh.convex && mesh.closed && cull_back && faces.turned_over == 0;
                    layers.extend(shaded.layers(faces, pool, never_hides_itself));
                    of_object.resize(layers.len(), object);
                }
                meter.lap(Stage::Light);
            }
            let ends = strokes.edges(object, &vertices, style) + strokes.outline(object, &vertices, style);
            if !todo.faces {
                meter.count_ends(ends);
            }
            meter.lap(Stage::Lines);
            misplaced.look_at(object, &vertices);
            meter.lap(Stage::Transform);
        }
        let mut too_many: Option<TooManyPieces> = None;
        match plan.order {
            // Forced to be made, but only edges were asked for.
            _ if style.shading == Shading::Wireframe => surfaces.clear(),
            Visibility::DepthBuffer => {}
            order @ (Visibility::Painter | Visibility::Bsp) => {
                let faces = layers.iter().map(|layer| layer.surface.triangles.len()).sum();
                let sorted = match order {
                    Visibility::Bsp => {
                        visibility::by_splitting(&layers, &projector, &screen, self.max_pieces, &self.progress)
                    }
                    Visibility::Painter | Visibility::DepthBuffer => {
                        Ok(visibility::by_centroid(&layers, &projector, &screen))
                    }
                };
                match sorted {
                    Ok((sorted, pieces)) => {
                        surfaces = sorted;
                        meter.pieces = Some((faces, pieces));
                    }
                    Err(error) => {
                        // A depth buffer decides what no order can be found for.
                        let tested = |layer: Layer| Surface { depth_test: true, ..layer.surface };
                        surfaces = std::mem::take(&mut layers).into_iter().map(tested).collect();
                        too_many = Some(error);
                    }
                }
            }
        }
        meter.lap(Stage::HiddenSurfaces);
        strokes.lines(scene);
        let marks = strokes.marks(scene, target.background);
        let labels = strokes.labels(scene, target.background);
        meter.lines = (strokes.asked, strokes.drawn() + marks.len() + labels.len());
        meter.lap(Stage::Lines);

        let drawing = Drawing {
            width: target.width,
            height: target.height,
            background: target.background,
            antialias: style.antialias,
            // Without faces any order is right.
            painted_in_order: too_many.is_none()
                && (plan.order != Visibility::DepthBuffer || options.output == Output::Vectors),
            surfaces,
            strokes: strokes.sets,
            areas: Vec::new(),
            marks,
            labels,
        };
        let report = meter.report(&plan, &Survey::of_done(scene, &plan.objects, &done, style), style);
        let too_much = OverBudget::rounding(misplaced.found());
        let work = notes.map(|notes| notes.work).filter(|work| report.iter().any(|r| r.stage == work.stage && r.ran));
        let depths = projector.depths;
        let mut frame = Frame {
            drawing,
            report,
            plan,
            objects: done,
            too_much,
            depths,
            work,
            dropped_faces: Vec::new(),
            before: None,
            followed,
        };
        if let Some(TooManyPieces { pieces, of_layer }) = too_many {
            frame.say(Stage::HiddenSurfaces, Reason::TooManyPieces { pieces });
            frame.too_much =
                Some(OverBudget::pieces(of_object.iter().map(|object| object.name.as_str()).zip(of_layer)));
        }
        frame
    }

    /// Takes back a drawing that is no longer needed: the next one is made in its memory.
    pub fn recycle(&mut self, drawing: Drawing) {
        self.pool.keep(drawing);
    }
}
