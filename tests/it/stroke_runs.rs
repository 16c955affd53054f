//! Runs of strokes that are found exactly, against those that the depth buffer shows.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::appearance::{Dash, HiddenLines, LineStyle, Occlusion, Rgba, Shading, Visibility};
use camera_lab::camera::{Camera, Parameters};
use camera_lab::drawing::{Drawing, StrokeSet, Surface};
use camera_lab::figure::read::parse;
use camera_lab::picture::Renderer;
use camera_lab::pipeline::stroke_order::painted_runs;
use camera_lab::pipeline::stroke_runs::{Run, occlusions, stroke_runs};
use camera_lab::pipeline::{Output, Reason, Stage, Target, draw};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{Line, Object, ObjectPaint, Scene, no_files, primitives};
use camera_lab::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_words::{Lang, pictures};
use glam::{DMat4, DVec3};

use crate::common::scenes::{cube, object, shading};

const TARGET: Target = Target { width: 320, height: 240, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
/// For the depth test, which looks at pixels: a stroke hidden by less than two of them is seen, and a little for the
/// width.
const NEAR: f32 = 4.0;

fn solids() -> Scene {
    let style = LineStyle {
        color: Rgba::rgb(0, 0, 0),
        width: 1.5,
        dash: Dash::Solid,
        hidden: HiddenLines::Hidden,
        arrow: false,
    };
    let at = |x: f64, y: f64, z: f64| DMat4::from_translation(DVec3::new(x, y, z));
    let placed = [
        object(cube(), at(0.0, 0.0, 0.0)),
        object(cube(), at(2.5, 0.3, -2.0) * DMat4::from_rotation_y(0.6)),
        object(primitives::pyramid(), at(-2.4, -0.4, 1.0)),
        object(primitives::cylinder(12), at(-1.0, 0.2, -3.0)),
    ];
    let objects = placed.into_iter().map(|o| Object { edges: Some(style), ..o }).collect();
    Scene { objects, ..Scene::default() }
}

fn views(scene: &Scene) -> impl Iterator<Item = Drawing> {
    let eyes = [[7.0, 4.0, 6.0], [-6.0, 3.0, 7.0], [1.0, 8.0, 4.0], [9.0, 0.5, -1.0], [-3.0, -5.0, 6.0]];
    eyes.into_iter().map(move |eye| {
        let parameters = Parameters {
            position: DVec3::from_array(eye),
            focal_point: DVec3::ZERO,
            near: 1.0,
            far: 40.0,
            ..Parameters::default()
        };
        let camera = Camera::new(&parameters).expect("a camera");
        draw(scene, &camera, TARGET, &shading(Shading::Flat))
    })
}

/// The same drawing with strokes that are these runs, one over the other, whatever the depth buffer says.
fn with_runs<'a>(drawing: &Drawing, runs: impl IntoIterator<Item = &'a Run>) -> Drawing {
    let strokes = runs.into_iter().filter_map(|run| {
        let style = run.style(drawing)?;
        let style = LineStyle { hidden: HiddenLines::Shown, arrow: style.arrow && run.has_end, ..style };
        Some(StrokeSet::line(run.points.clone(), style))
    });
    Drawing { strokes: strokes.collect(), ..drawing.clone() }
}

/// The solids, the second of which is a tint.
fn with_a_tint() -> Scene {
    let mut scene = solids();
    scene.objects[1].paint = ObjectPaint::Solid(Rgba::rgb(200, 60, 200).with_alpha(120));
    scene
}

#[test]
fn exact_runs_look_as_the_depth_buffer_shows_strokes() {
    let (mut ink, mut apart, mut dimmed) = (0_usize, 0_usize, 0_usize);
    for drawing in views(&solids()).chain(views(&with_a_tint())) {
        let runs = stroke_runs(&drawing).unwrap();
        dimmed += runs.iter().filter(|run| run.behind == Occlusion::Translucent).count();
        assert!(
            runs.iter().any(|run| run.behind == Occlusion::Opaque)
                && runs.iter().any(|run| run.behind == Occlusion::None)
        );
        let ends: Vec<[f32; 3]> =
            runs.iter().flat_map(|run| [run.points[0], run.points[run.points.len() - 1]]).collect();
        let paint = |drawing: &Drawing| Rasterizer::default().paint(drawing).expect("a picture");
        let (tested, exact) = (paint(&drawing), paint(&with_runs(&drawing, &runs)));
        let bare = paint(&Drawing { strokes: Vec::new(), ..drawing.clone() });
        for (k, ((a, b), c)) in tested.pixels().iter().zip(exact.pixels()).zip(bare.pixels()).enumerate() {
            ink += usize::from(a != c);
            let (x, y) = ((k % 320) as f32 + 0.5, (k / 320) as f32 + 0.5);
            let at_an_end = || ends.iter().any(|end| (end[0] - x).powi(2) + (end[1] - y).powi(2) < NEAR * NEAR);
            apart += usize::from(a.red().abs_diff(b.red()) > 64 && !at_an_end());
        }
    }
    // Away from ends of runs, at which an edge is hidden by less than two pixels along all its length.
    assert!(ink > 10_000 && apart * 200 < ink && dimmed > 10, "{apart} of {ink}, {dimmed} dimmed");
}

#[test]
fn runs_make_up_each_polyline() {
    for drawing in views(&solids()) {
        let runs = stroke_runs(&drawing).unwrap();
        let polylines: usize = drawing.strokes.iter().map(|set| set.polylines.len()).sum();
        assert_eq!(runs.iter().filter(|run| run.has_end).count(), polylines);
        for pair in runs.windows(2).filter(|pair| !pair[0].has_end) {
            assert_eq!((pair[0].set, pair[0].polyline), (pair[1].set, pair[1].polyline));
            assert_eq!(pair[0].points.last(), pair[1].points.first());
            assert_ne!(pair[0].behind, pair[1].behind);
        }
    }
}

/// The solids with edges of different colours and widths, over a fine grid, in a bundle of bars that pass before and
/// behind one another.
fn crossings() -> Scene {
    let mut scene = solids();
    let colors = [[200, 0, 0], [0, 150, 0], [0, 0, 220], [160, 0, 160]].map(|[r, g, b]| Rgba::rgb(r, g, b));
    let style = |color, width| LineStyle { color, width, dash: Dash::Solid, hidden: HiddenLines::Hidden, arrow: false };
    for (object, color) in scene.objects.iter_mut().zip(colors) {
        object.edges = Some(style(color, 2.5));
    }
    let mut line = |color, width, ends: [[f64; 3]; 2]| {
        scene.lines.push(Line::new(ends.map(DVec3::from_array).to_vec(), style(color, width)));
    };
    for k in -4..=4 {
        let k = f64::from(k);
        line(Rgba::rgb(120, 120, 120), 1.0, [[k, -1.0, -4.0], [k, -1.0, 4.0]]);
        line(Rgba::rgb(120, 120, 120), 1.0, [[-4.0, -1.0, k], [4.0, -1.0, k]]);
        // Woven: each leans another way.
        line(colors[0], 3.0, [[-3.5, 1.6 + 0.1 * k, k], [3.5, 1.6 - 0.1 * k, k]]);
        line(colors[2], 3.0, [[k, 1.6 - 0.12 * k, -3.5], [k, 1.6 + 0.12 * k, 3.5]]);
    }
    scene
}

/// Pixels of the strokes in a drawing, those that are otherwise with the runs in their order, and those with the runs
/// as they are listed. Pixels near the hidden ends of strokes are not counted.
fn disagreement(drawing: &Drawing) -> [usize; 3] {
    let paint = |drawing: &Drawing| Rasterizer::default().paint(drawing).expect("a picture");
    let listed = stroke_runs(drawing).unwrap();
    let split = |pair: &[Run]| (!pair[0].has_end).then(|| pair[1].points[0]);
    let ends: Vec<[f32; 3]> = listed.windows(2).filter_map(split).collect();
    let ordered = painted_runs(drawing).unwrap();
    let pictures = [with_runs(drawing, &ordered), with_runs(drawing, &listed)].map(|drawing| paint(&drawing));
    let (tested, bare) = (paint(drawing), paint(&Drawing { strokes: Vec::new(), ..drawing.clone() }));
    let mut counts = [0; 3];
    let width = drawing.width as usize;
    for (k, (a, c)) in tested.pixels().iter().zip(bare.pixels()).enumerate() {
        let (x, y) = ((k % width) as f32 + 0.5, (k / width) as f32 + 0.5);
        counts[0] += usize::from(a != c);
        for (count, picture) in counts[1..].iter_mut().zip(&pictures) {
            let b = picture.pixels()[k];
            let apart = [(a.red(), b.red()), (a.green(), b.green()), (a.blue(), b.blue())];
            let differs = apart.iter().any(|(p, q)| p.abs_diff(*q) > 64);
            *count += usize::from(
                differs && !ends.iter().any(|end| (end[0] - x).powi(2) + (end[1] - y).powi(2) < NEAR * NEAR),
            );
        }
    }
    counts
}

/// The remaining differences have two causes. Strokes along each other at a small angle that change order on the way:
/// each pixel has its own nearer one, but runs are cut once for both and all their width. And joints of one set: the
/// rasterizer keeps the greatest share that any of its segments covers, but runs paint over one another.
#[test]
fn runs_in_their_order_cross_as_the_depths_of_pixels_say() {
    let (mut behind_faces, mut alone) = ([0; 3], [0; 3]);
    for drawing in views(&crossings()) {
        disagreement(&drawing).iter().zip(&mut behind_faces).for_each(|(n, sum)| *sum += n);
        let without = Drawing { surfaces: Vec::new(), ..drawing };
        disagreement(&without).iter().zip(&mut alone).for_each(|(n, sum)| *sum += n);
    }
    let [ink, ordered, listed] = behind_faces;
    assert!(ink > 20_000 && ordered * 250 < ink && ordered * 5 < listed, "{behind_faces:?}");
    // If no face hides anything, order alone decides.
    let [ink, ordered, listed] = alone;
    assert!(ink > 20_000 && ordered * 250 < ink && ordered * 5 < listed, "{alone:?}");
}

/// A figure in which boxes pass through one another, with edges, marks and a legend.
fn figure() -> String {
    let object = |name: &str, rest: &str| format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\n{rest}\n");
    format!(
        "[camera]\nposition = [3, 2.5, 6]\nview_angle = 34\nnear = 3\nfar = 14\n{}{}{}[style]\nshading = \"flat\"\n\
         hidden_lines = \"hidden\"\nantialias = 1\n",
        object("one", "scale = [2.4, 0.6, 0.8]\ncolor = \"#4477aa\""),
        object("two", "scale = [0.6, 2.4, 0.6]\nrotate = [20, 10, 0]\ncolor = \"#ee8866\""),
        object("three", "translate = [0.4, 0, -2]\nscale = [2, 1.5, 0.5]\ncolor = \"#228833\""),
    )
}

#[test]
fn a_drawing_for_vectors_needs_no_depth_buffer() {
    let figure = parse(&figure()).expect("a figure");
    let camera = Camera::new(&figure.camera).expect("a camera");
    let scene = SharedScene::new(
        scene_of(&figure, &mut no_files, &camera_lab::progress::Progress::default()).expect("a scene"),
    );
    for view in [View::World, View::Canonical, View::Image] {
        let size = Size { width: 320, height: 240, scale: 1.0 };
        let pixels = Request::of(&figure, view, &camera, &scene, pictures::labels(Lang::En), size);
        let vectors = Request { output: Output::Vectors, ..pixels.clone() };
        let mut renderer = Renderer::default();
        let mut frame = |request: &Request| renderer.drawing(request).expect("a drawing");
        let (pixels, vectors) = (frame(&pixels), frame(&vectors));
        assert_eq!(vectors.plan.stage(Stage::HiddenSurfaces).reason, Reason::NoDepthBuffer);
        assert!(vectors.drawing.painted_in_order && !pixels.drawing.painted_in_order);
        assert_eq!(vectors.drawing.areas, pixels.drawing.areas);
        assert_eq!(vectors.drawing.labels, pixels.drawing.labels);
        // Whether marks and labels are hidden is found without pixels.
        let places = vectors.drawing.labels.iter().map(|label| label.position);
        assert_eq!(occlusions(&vectors.drawing, places).unwrap().len(), pixels.drawing.labels.len());

        // Without any depth: the faces as they are listed, then the runs.
        let plain = |drawing: &Drawing| Drawing { marks: Vec::new(), labels: Vec::new(), ..drawing.clone() };
        let drawing = plain(&vectors.drawing);
        let flat = |surface: &Surface| Surface {
            positions: surface.positions.iter().map(|p| [p[0], p[1], 0.0]).collect(),
            depth_test: false,
            ..surface.clone()
        };
        let painted = with_runs(&drawing, &painted_runs(&drawing).unwrap());
        let painted = Drawing { surfaces: drawing.surfaces.iter().map(flat).collect(), ..painted };
        let paint = |drawing: &Drawing| Rasterizer::default().paint(drawing).expect("a picture");
        let (tested, painted) = (paint(&plain(&pixels.drawing)), paint(&painted));
        let apart = |p: u8, q: u8| p.abs_diff(q) > 64;
        let differ = tested
            .pixels()
            .iter()
            .zip(painted.pixels())
            .filter(|(a, b)| apart(a.red(), b.red()) || apart(a.green(), b.green()) || apart(a.blue(), b.blue()));
        let differ = differ.count();
        // Ends of dashes along the far edges, and joints.
        assert!(differ * 160 < 320 * 240, "{view:?}: {differ}");
    }
}

#[test]
fn vectors_are_split_unless_the_painter_is_asked_for() {
    let figure = parse(&figure()).expect("a figure");
    let camera = Camera::new(&figure.camera).expect("a camera");
    let scene = SharedScene::new(
        scene_of(&figure, &mut no_files, &camera_lab::progress::Progress::default()).expect("a scene"),
    );
    let size = Size { width: 80, height: 60, scale: 1.0 };
    let request = Request::of(&figure, View::Image, &camera, &scene, pictures::labels(Lang::En), size);
    for (visibility, reason) in [
        (Visibility::DepthBuffer, Reason::NoDepthBuffer),
        (Visibility::Bsp, Reason::PaintedBySplitting),
        (Visibility::Painter, Reason::PaintedByCentroid),
    ] {
        let mut request = Request { output: Output::Vectors, ..request.clone() };
        request = request.clone().with_shot(|shot| shot.look.style.visibility = visibility);
        let frame = Renderer::default().drawing(&request).expect("a drawing");
        assert_eq!(frame.plan.stage(Stage::HiddenSurfaces).reason, reason);
        assert!(frame.drawing.painted_in_order);
    }
}
