//! The outlines of curved solids, compared with the contours of the ideal surfaces.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::TAU;

use camera_lab_engine::appearance::{HiddenLines, Shading, Style};
use camera_lab_engine::camera::{Camera, Parameters, Projection, ViewWindow};
use camera_lab_engine::drawing::Drawing;
use camera_lab_engine::pipeline::canonical::clipped_scene;
use camera_lab_engine::pipeline::{Stage, draw};
use camera_lab_engine::scene::{
    Adjacency, Mesh, ObjectSpec, Preset, Scene, SceneSpec, Shape, build, no_files, primitives,
};
use glam::DVec3;

use crate::common::scenes::{TARGET, shading};

/// Looks at the origin from 6 away. The window is 4 × 2 at the origin, 200 × 100 pixels.
fn camera(projection: Projection, direction: DVec3) -> Camera {
    let near = 3.0;
    let half = if projection == Projection::Perspective { 0.5 } else { 1.0 };
    Camera::new(&Parameters {
        position: direction.normalize() * 6.0,
        focal_point: DVec3::ZERO,
        projection,
        near,
        far: 9.0,
        window: Some(ViewWindow { left: -2.0 * half, right: 2.0 * half, bottom: -half, top: half }),
        ..Parameters::default()
    })
    .unwrap()
}

fn solid(shape: Shape, scale: f64, style: &Style) -> Scene {
    let object = ObjectSpec::new("thing", shape).with_segments(32).scaled(scale, scale, scale);
    let spec = SceneSpec { preset: Preset::Empty, objects: vec![object], ..SceneSpec::default() };
    build(&spec, style, &mut no_files).unwrap()
}

/// The outline of a solid, from its middle in scene units at the origin.
fn outline(drawing: &Drawing) -> Vec<Vec<[f64; 2]>> {
    let polylines = drawing
        .strokes
        .iter()
        .flat_map(|set| set.polylines.iter().map(|range| &set.points[range.start as usize..range.end as usize]));
    polylines
        .map(|points| points.iter().map(|&[x, y, _]| [f64::from(x) / 50.0 - 2.0, 1.0 - f64::from(y) / 50.0]).collect())
        .collect()
}

fn is_closed(polyline: &[[f64; 2]]) -> bool {
    polyline.first() == polyline.last()
}

const OBLIQUE: DVec3 = DVec3::new(0.3, 0.6, 0.8);

#[test]
fn a_sphere_is_outlined_by_one_loop_near_its_contour() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        for direction in [OBLIQUE, DVec3::Z, DVec3::new(-0.2, -0.9, 0.1)] {
            let radius = 0.8;
            let scene = solid(Shape::Sphere, radius, &Style::default());
            let outline = outline(&draw(&scene, &camera(projection, direction), TARGET, &Style::default()));
            let [contour] = &outline[..] else { panic!("{} polylines", outline.len()) };
            assert!(is_closed(contour));
            // The tangents from the eye touch at the angle asin(r/6), and meet the plane through the middle there.
            let ideal = match projection {
                Projection::Perspective => 6.0 * (radius / 6.0_f64).asin().tan(),
                Projection::Parallel => radius,
            };
            // A vertex on the sphere, by less than a segment and a half off the contour.
            let least = ideal * (1.5 * TAU / 32.0).cos();
            let mut turned = 0.0;
            for pair in contour.windows(2) {
                let [r, _] = pair.iter().map(|[x, y]| x.hypot(*y)).collect::<Vec<_>>()[..] else { unreachable!() };
                assert!((least..=ideal + 1e-4).contains(&r), "{r} {ideal}");
                let ([ax, ay], [bx, by]) = (pair[0], pair[1]);
                let step = (ax * by - ay * bx).atan2(ax * bx + ay * by);
                assert!(step.abs() < 2.0 * TAU / 32.0, "{step}");
                turned += step;
            }
            assert!((turned.abs() - TAU).abs() < 1e-3, "{turned}");
        }
    }
}

#[test]
fn a_cylinder_has_two_side_lines_and_two_rims() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let scene = solid(Shape::Cylinder, 0.4, &Style::default());
        let outline = outline(&draw(&scene, &camera(projection, OBLIQUE), TARGET, &Style::default()));
        let (rims, sides): (Vec<_>, Vec<_>) = outline.iter().partition(|polyline| is_closed(polyline));
        assert_eq!((rims.len(), sides.len()), (2, 2));
        assert!(rims.iter().all(|rim| rim.len() == 33) && sides.iter().all(|side| side.len() == 2));
        // One at the left, one at the right, as far out as a rim is wide.
        let mut at: Vec<f64> = sides.iter().map(|side| side[0][0].min(side[1][0])).collect();
        at.sort_by(f64::total_cmp);
        assert!(at[0] < -0.35 && at[1] > 0.35, "{at:?}");
    }
}

#[test]
fn a_cone_has_a_rim_and_two_sides_that_meet_at_the_apex() {
    let scene = solid(Shape::Cone, 0.4, &Style::default());
    let from_the_side = outline(&draw(&scene, &camera(Projection::Perspective, OBLIQUE), TARGET, &Style::default()));
    let (rims, sides): (Vec<_>, Vec<_>) = from_the_side.iter().partition(|polyline| is_closed(polyline));
    assert_eq!((rims.len(), sides.len()), (1, 1));
    assert_eq!(sides[0].len(), 3);
    // From right above, no side is seen from behind.
    let above = camera(Projection::Perspective, DVec3::new(0.0, 1.0, 1e-3));
    let from_above = outline(&draw(&scene, &above, TARGET, &Style::default()));
    assert!(from_above.len() == 1 && is_closed(&from_above[0]));
}

#[test]
fn a_torus_has_an_outer_and_an_inner_contour() {
    let scene = solid(Shape::Torus, 0.9, &Style::default());
    let steep = DVec3::new(0.2, 1.0, 0.4);
    let outline = outline(&draw(&scene, &camera(Projection::Perspective, steep), TARGET, &Style::default()));
    assert_eq!(outline.len(), 2);
    assert!(outline.iter().all(|contour| is_closed(contour)));
    let mut widths = [0, 1].map(|k| outline[k].iter().fold(0.0, |most: f64, [x, _]| most.max(x.abs())));
    widths.sort_by(f64::total_cmp);
    // Radii 0.7 ± 0.3, times 0.9. Parts nearer to the eye look a little larger.
    assert!((widths[0] - 0.36).abs() < 0.05 && (widths[1] - 0.9).abs() < 0.08, "{widths:?}");
}

#[test]
fn the_canonical_volume_seen_from_its_front_has_the_outline_of_the_image() {
    let front = Camera::new(&Parameters {
        position: DVec3::Z * 2.0,
        focal_point: DVec3::ZERO,
        projection: Projection::Parallel,
        near: 1.0,
        far: 3.0,
        window: Some(ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 }),
        ..Parameters::default()
    })
    .unwrap();
    for projection in [Projection::Perspective, Projection::Parallel] {
        for shape in [Shape::Sphere, Shape::Cylinder, Shape::Cone, Shape::Torus] {
            // Twice as large, it is cut by the window.
            for scale in [0.45, 2.0] {
                let scene = solid(shape.clone(), scale, &Style::default());
                let camera = camera(projection, OBLIQUE);
                let image = outline(&draw(&scene, &camera, TARGET, &Style::default()));
                let clipped = clipped_scene(&scene, &camera, Shading::Flat);
                // If it is cut, it has borders, which the image has not.
                assert!(scale < 1.0 || !clipped.lines.is_empty(), "{shape:?} {scale}");
                let canonical = Scene { lines: Vec::new(), ..clipped };
                let shown = outline(&draw(&canonical, &front, TARGET, &Style::default()));
                let [all, again] = [&image, &shown].map(|outline| {
                    let segments = outline.iter().flat_map(|p| p.windows(2));
                    segments.map(|p| (p[0][0] - p[1][0]).hypot(p[0][1] - p[1][1])).sum::<f64>()
                });
                assert!(all > 1.0 && (all - again).abs() < 1e-3 * all, "{shape:?} {scale}: {all} {again}");
            }
        }
    }
}

#[test]
fn outlines_have_the_style_of_hidden_lines_and_are_not_there_in_wireframe() {
    for hidden_lines in [HiddenLines::Dashed, HiddenLines::Hidden, HiddenLines::Shown] {
        let style = Style { hidden_lines, ..Style::default() };
        let scene = solid(Shape::Cylinder, 0.4, &style);
        let camera = camera(Projection::Perspective, OBLIQUE);
        let drawing = draw(&scene, &camera, TARGET, &style);
        assert!(drawing.strokes.len() == 1 && drawing.strokes[0].style.hidden == hidden_lines);
        let edges = scene.objects[0].mesh.edges.len();
        assert_eq!(outline(&draw(&scene, &camera, TARGET, &shading(Shading::Wireframe))).len(), edges);
    }
}

#[test]
fn the_report_counts_outlines_by_polyline() {
    let scene = solid(Shape::Cylinder, 0.4, &Style::default());
    let camera = camera(Projection::Perspective, OBLIQUE);
    let mut pipeline = camera_lab_engine::pipeline::Pipeline::default();
    let frame = pipeline.frame(&scene, &camera, TARGET, &Style::default(), Default::default());
    let lines = frame.report.iter().find(|report| report.stage == Stage::Lines).unwrap();
    assert!(lines.ran && lines.counts == Some((4, 4)), "{:?}", lines.counts);
}

#[test]
fn facets_and_meshes_of_files_have_no_outline() {
    let style = Style::default();
    assert!(solid(Shape::Prism, 1.0, &style).objects[0].outline.is_none());
    let object = ObjectSpec::new("thing", Shape::Mesh { path: "camera-lab:teapot.obj".into() });
    let spec = SceneSpec { preset: Preset::Empty, objects: vec![object], ..SceneSpec::default() };
    let sphere = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    let scene = build(&spec, &style, &mut |_| Ok(sphere.as_bytes().to_vec())).unwrap();
    assert!(scene.objects[0].outline.is_none() && scene.objects[0].mesh.adjacency.edges.is_empty());
    let drawn = draw(&scene, &camera(Projection::Perspective, OBLIQUE), TARGET, &style);
    assert!(drawn.strokes.is_empty());
}

fn adjacency(mesh: &Mesh) -> Adjacency {
    Adjacency::of(&mesh.positions, &mesh.triangles)
}

fn creases(mesh: &Mesh) -> usize {
    adjacency(mesh).edges.iter().filter(|edge| edge.crease).count()
}

#[test]
fn each_edge_of_a_closed_mesh_is_there_once() {
    for mesh in [primitives::sphere(12), primitives::cylinder(12), primitives::cone(12), primitives::torus(12)] {
        let adjacency = adjacency(&mesh);
        assert_eq!(adjacency.planes.len(), mesh.triangles.len());
        assert_eq!(2 * adjacency.edges.len(), 3 * mesh.triangles.len());
        for edge in &adjacency.edges {
            let [p, q] = edge.ends.map(|i| mesh.positions[i as usize].extend(1.0));
            for face in edge.faces {
                let plane = adjacency.planes[face as usize];
                assert!(plane.dot(p).abs() < 1e-12 && plane.dot(q).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn rims_are_creases_and_smooth_sides_are_not_however_coarse() {
    for n in [3, 6, 32] {
        assert_eq!(creases(&primitives::sphere(n)), 0);
        assert_eq!(creases(&primitives::torus(n)), 0);
        assert_eq!(creases(&primitives::cylinder(n)), 2 * n as usize);
        assert_eq!(creases(&primitives::cone(n)), n as usize);
    }
}

#[test]
fn a_border_is_not_among_them() {
    let square = primitives::tiles([0.0; 2], [1.0; 2], 1, 1);
    let adjacency = adjacency(&square);
    assert_eq!(adjacency.edges.len(), 1);
    assert_eq!(adjacency.edges[0].faces, [0, 1]);
}
