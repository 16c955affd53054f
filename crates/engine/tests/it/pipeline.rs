//! Scenes through the pipeline, compared with numbers that were worked out by hand.

#![expect(clippy::unwrap_used, reason = "tests")]

use camera_lab_engine::appearance::{Rgba, Shading, Style};
use camera_lab_engine::camera::{Camera, Parameters, Projection};
use camera_lab_engine::drawing::{Base, Drawing};
use camera_lab_engine::pipeline::{Options, Pipeline, draw};
use camera_lab_engine::scene::{Light, Line, PointMark, Scene};
use glam::{DMat4, DVec3};

use crate::common::scenes::{CLAY, STROKE, TARGET, cube, eye, object, only, shading};

fn triangles(drawing: &Drawing) -> usize {
    drawing.surfaces.iter().map(|s| s.triangles.len()).sum()
}

#[test]
fn a_cube_before_the_eye_shows_its_front_where_the_notes_say() {
    let scene = only(object(cube(), DMat4::from_translation(DVec3::new(0.0, 0.0, -4.0))));
    let drawing = draw(&scene, &eye(Projection::Perspective), TARGET, &shading(Shading::Flat));
    // Only the face towards the eye, because the sides of a cube in the middle turn away.
    assert_eq!(triangles(&drawing), 2);
    let surface = &drawing.surfaces[0];
    assert_eq!(surface.base, Base::Solid(CLAY), "no light, own colour");
    let mut corners: Vec<_> =
        surface.triangles.iter().flatten().map(|&i| surface.positions[i as usize].map(f64::from)).collect();
    corners.sort_by(|a, b| a.partial_cmp(b).unwrap());
    corners.dedup();
    // The face is at d = 3: x_p = ±1/3 of a window 4 wide, 50 pixels a unit, and depth = F(B − d)/(d(B − F)) = 6/24.
    let (l, r) = (100.0 - 50.0 / 3.0, 100.0 + 50.0 / 3.0);
    let (t, b) = (50.0 - 50.0 / 3.0, 50.0 + 50.0 / 3.0);
    for (found, expected) in corners.iter().zip([[l, t], [l, b], [r, t], [r, b]]) {
        assert!((found[0] - expected[0]).abs() < 1.0 / 500.0 && (found[1] - expected[1]).abs() < 1.0 / 500.0);
        assert_eq!(found[2], 0.25);
    }
}

#[test]
fn a_mirrored_cube_still_shows_its_front() {
    let place = DMat4::from_translation(DVec3::new(0.0, 0.0, -4.0)) * DMat4::from_scale(DVec3::new(1.0, -1.0, 1.0));
    let scene = only(object(cube(), place));
    for projection in [Projection::Perspective, Projection::Parallel] {
        let drawing = draw(&scene, &eye(projection), TARGET, &shading(Shading::Flat));
        assert_eq!(triangles(&drawing), 2);
        let surface = &drawing.surfaces[0];
        let nearest = if projection == Projection::Perspective { 0.25 } else { 0.75 };
        assert!(surface.triangles.iter().flatten().all(|&i| surface.positions[i as usize][2] == nearest));
    }
}

#[test]
fn flat_light_follows_the_normal() {
    let scene = Scene {
        lights: vec![Light::directional(DVec3::new(0.0, 0.0, -2.0))],
        ..only(object(cube(), DMat4::from_translation(DVec3::new(0.0, 0.0, -4.0))))
    };
    let face = |scene: &Scene| match &draw(scene, &eye(Projection::Perspective), TARGET, &shading(Shading::Flat))
        .surfaces[0]
        .base
    {
        Base::Faces(colors) => colors.clone(),
        other => panic!("{other:?}"),
    };
    // The lamp is behind the eye: cosine 1, ambient + diffuse = 1, the colour itself.
    assert_eq!(face(&scene), [CLAY, CLAY]);
    // From behind the cube: ambient only, 0.35 of it.
    let behind = Scene { lights: vec![Light::directional(DVec3::Z)], ..scene.clone() };
    assert_eq!(face(&behind), [Rgba::rgb(70, 35, 14); 2]);
    // A lamp on the axis at the eye, seen from the centroid (∓1/3, ±1/3, −3): cosine 3/√(9 + 2/9).
    let lamp = Scene { lights: vec![Light::point(DVec3::ZERO)], ..scene.clone() };
    let share = 0.35 + 0.65 * 3.0 / (9.0_f64 + 2.0 / 9.0).sqrt();
    for color in face(&lamp) {
        assert!((f64::from(color.r) - 200.0 * share).abs() <= 0.5 && (f64::from(color.b) - 40.0 * share).abs() <= 0.5);
    }
}

#[test]
fn wireframe_has_strokes_and_no_surfaces() {
    let scene = only(object(cube(), DMat4::from_translation(DVec3::new(0.0, 0.0, -4.0))));
    let drawing = draw(&scene, &eye(Projection::Perspective), TARGET, &shading(Shading::Wireframe));
    assert!(drawing.surfaces.is_empty());
    assert_eq!(drawing.strokes.len(), 1);
    assert_eq!(drawing.strokes[0].polylines.len(), 8);
    assert_eq!(drawing.strokes[0].style.color, CLAY);
}

#[test]
fn objects_outside_are_dropped_and_crossing_ones_stay() {
    let style = shading(Shading::Gouraud);
    for far_away in [DVec3::new(0.0, 0.0, 4.0), DVec3::new(30.0, 0.0, -4.0), DVec3::new(0.0, 0.0, -11.0)] {
        let scene = only(object(cube(), DMat4::from_translation(far_away)));
        assert!(draw(&scene, &eye(Projection::Perspective), TARGET, &style).surfaces.is_empty());
    }
    for crossing in [DVec3::new(0.0, 0.0, -1.0), DVec3::new(8.0, -4.0, -4.0), DVec3::new(0.0, 0.5, -9.0)] {
        let mut thing = object(cube(), DMat4::from_translation(crossing));
        thing.two_sided = true;
        let drawing = draw(&only(thing), &eye(Projection::Perspective), TARGET, &style);
        assert!(triangles(&drawing) > 0);
        for p in drawing.surfaces.iter().flat_map(|s| s.triangles.iter().flatten().map(|&i| s.positions[i as usize])) {
            assert!((0.0..=200.0).contains(&p[0]) && (0.0..=100.0).contains(&p[1]) && (0.0..=1.0).contains(&p[2]));
        }
    }
}

#[test]
fn lines_are_cut_scaled_and_keep_their_arrow_only_at_the_true_end() {
    let line = |points: &[DVec3]| Line::new(points.to_vec(), STROKE);
    let scene = Scene {
        lines: vec![
            line(&[DVec3::new(0.0, 0.0, 5.0), DVec3::new(0.0, 0.0, -2.0)]),
            line(&[DVec3::new(0.0, 0.0, -2.0), DVec3::new(0.0, 0.0, -20.0)]),
            // Leaves on the left and comes back.
            line(&[
                DVec3::new(0.0, 0.0, -2.0),
                DVec3::new(-9.0, 0.0, -2.0),
                DVec3::new(-9.0, 0.5, -2.0),
                DVec3::new(0.0, 0.5, -2.0),
            ]),
        ],
        ..Scene::default()
    };
    let drawing = draw(&scene, &eye(Projection::Perspective), TARGET, &Style::default());
    let arrows: Vec<_> = drawing.strokes.iter().map(|s| (s.style.arrow, s.polylines.len())).collect();
    assert_eq!(arrows, [(true, 1), (false, 2), (true, 1)]);
    assert_eq!(drawing.strokes[0].style.width, 3.0);
    // From the near plane (depth 1) to d = 2 (7/16), and from there to the far plane (depth 0).
    assert_eq!(drawing.strokes[0].points, [[100.0, 50.0, 1.0], [100.0, 50.0, 0.4375]]);
    assert_eq!(drawing.strokes[1].points[..2], [[100.0, 50.0, 0.4375], [100.0, 50.0, 0.0]]);
    assert_eq!(drawing.strokes[1].points[2..], [[100.0, 50.0, 0.4375], [0.0, 50.0, 0.4375]]);
    assert_eq!(drawing.strokes[2].points, [[0.0, 37.5, 0.4375], [100.0, 37.5, 0.4375]]);
}

#[test]
fn marks_behind_the_eye_are_not_drawn() {
    let mark = |z| PointMark {
        position: DVec3::new(0.0, 0.0, z),
        shape: camera_lab_engine::appearance::MarkShape::Disc,
        radius: 4.0,
        color: CLAY,
        fade_if_hidden: true,
    };
    let scene = Scene { marks: [2.0, 0.0, -0.5, -2.0, -9.5].map(mark).to_vec(), ..Scene::default() };
    let drawing = draw(&scene, &eye(Projection::Perspective), TARGET, &Style::default());
    assert_eq!(drawing.marks.len(), 1);
    assert_eq!((drawing.marks[0].position, drawing.marks[0].radius), ([100.0, 50.0, 0.4375], 8.0));
}

#[test]
fn depth_is_exact_over_six_decades() {
    let camera = Camera::new(&Parameters {
        position: DVec3::ZERO,
        focal_point: DVec3::NEG_Z,
        near: 1e-3,
        far: 1e3,
        ..Parameters::default()
    })
    .unwrap();
    let distances = [1e-3, 2e-3, 0.1, 1.0, 500.0, 999.0, 999.999];
    let mark = |d: f64| PointMark {
        position: DVec3::new(0.0, 0.0, -d),
        shape: camera_lab_engine::appearance::MarkShape::Disc,
        radius: 1.0,
        color: CLAY,
        fade_if_hidden: true,
    };
    let scene = Scene { marks: distances.map(mark).to_vec(), ..Scene::default() };
    let options = Options { depth_of_volume: true, ..Options::default() };
    let drawing = Pipeline::default().frame(&scene, &camera, TARGET, &Style::default(), options).drawing;
    // F(B − d)/(d(B − F)) in rational arithmetic, then rounded.
    let exact = [
        1.0,
        0.4999994999995,
        0.00999900999901,
        0.000999000999000999,
        1.000001000001e-6,
        1.001002002003003e-9,
        1.000002000003e-12,
    ];
    for (mark, exact) in drawing.marks.iter().zip(exact) {
        assert!((f64::from(mark.position[2]) / exact - 1.0).abs() < 1e-7, "{} for {exact}", mark.position[2]);
    }
    assert_eq!(drawing.marks.len(), exact.len());
}
