//! Runs of strokes that are found exactly, against those that the depth buffer shows.

use camera_lab::appearance::{Dash, HiddenLines, LineStyle, Rgba, Shading};
use camera_lab::camera::{Camera, Parameters};
use camera_lab::drawing::{Drawing, StrokeSet};
use camera_lab::pipeline::stroke_runs::{Run, stroke_runs};
use camera_lab::pipeline::{Target, draw};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{Object, Scene, primitives};
use glam::{DMat4, DVec3};

use super::pipeline::{cube, object, shading};

const TARGET: Target = Target { width: 320, height: 240, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
/// Of the depth test, which looks at pixels: what is hidden by less than two of them is seen, and a little for the width.
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

fn views() -> impl Iterator<Item = Drawing> {
    let eyes = [[7.0, 4.0, 6.0], [-6.0, 3.0, 7.0], [1.0, 8.0, 4.0], [9.0, 0.5, -1.0], [-3.0, -5.0, 6.0]];
    eyes.into_iter().map(|eye| {
        let parameters = Parameters {
            position: DVec3::from_array(eye),
            focal_point: DVec3::ZERO,
            near: 1.0,
            far: 40.0,
            ..Parameters::default()
        };
        let camera = Camera::new(&parameters).expect("a camera");
        draw(&solids(), &camera, TARGET, &shading(Shading::Flat))
    })
}

/// The same drawing with strokes that are the visible runs, whatever the depth buffer says.
fn with_runs(drawing: &Drawing, runs: &[Run]) -> Drawing {
    let strokes = runs.iter().filter(|run| run.visible).map(|run| StrokeSet {
        points: run.points.clone(),
        polylines: std::iter::once(0..u32::try_from(run.points.len()).expect("few points")).collect(),
        style: LineStyle { hidden: HiddenLines::Shown, ..drawing.strokes[run.set].style },
    });
    Drawing { strokes: strokes.collect(), ..drawing.clone() }
}

#[test]
fn exact_runs_look_as_the_depth_buffer_shows_strokes() {
    let (mut ink, mut apart) = (0_usize, 0_usize);
    for drawing in views() {
        let runs = stroke_runs(&drawing);
        assert!(runs.iter().any(|run| !run.visible) && runs.iter().any(|run| run.visible));
        let ends: Vec<[f32; 3]> =
            runs.iter().flat_map(|run| [run.points[0], run.points[run.points.len() - 1]]).collect();
        let paint = |drawing: &Drawing| Rasterizer::default().paint(drawing).expect("a picture");
        let (tested, exact) = (paint(&drawing), paint(&with_runs(&drawing, &runs)));
        let bare = paint(&Drawing { strokes: Vec::new(), ..drawing.clone() });
        for (k, ((a, b), c)) in tested.pixels().iter().zip(exact.pixels()).zip(bare.pixels()).enumerate() {
            ink += usize::from(a != c);
            let (x, y) = ((k % 320) as f32 + 0.5, (k / 320) as f32 + 0.5);
            let at_an_end = || ends.iter().any(|end| (end[0] - x).hypot(end[1] - y) < NEAR);
            apart += usize::from(a.red().abs_diff(b.red()) > 64 && !at_an_end());
        }
    }
    // Away from ends of runs: where an edge is hidden by less than two pixels along all its length.
    assert!(ink > 5000 && apart * 200 < ink, "{apart} of {ink}");
}

#[test]
fn runs_make_up_each_polyline() {
    for drawing in views() {
        let runs = stroke_runs(&drawing);
        let polylines: usize = drawing.strokes.iter().map(|set| set.polylines.len()).sum();
        assert_eq!(runs.iter().filter(|run| run.has_end).count(), polylines);
        for pair in runs.windows(2).filter(|pair| !pair[0].has_end) {
            assert_eq!((pair[0].set, pair[0].polyline), (pair[1].set, pair[1].polyline));
            assert_eq!(pair[0].points.last(), pair[1].points.first());
            assert_ne!(pair[0].visible, pair[1].visible);
        }
    }
}
