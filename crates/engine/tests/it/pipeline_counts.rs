//! The report of a picture: counts of a small scene, counted by hand.

use camera_lab_engine::appearance::{Shading, Style, Visibility};
use camera_lab_engine::camera::Projection;
use camera_lab_engine::pipeline::{Frame, Options, Pipeline, Stage};
use camera_lab_engine::scene::{Light, Line, Mesh, Object, Scene};
use glam::{DMat4, DVec3};

use crate::common::scenes::{STROKE, TARGET, cube, eye, object, only, shading};

/// Three cubes: one wholly in view, one that the left plane (x = −2d) cuts, one behind the eye.
fn cubes() -> Scene {
    let at = |x: f64, z: f64| object(cube(), DMat4::from_translation(DVec3::new(x, 0.0, z)));
    let line = Line::new(vec![DVec3::new(50.0, 0.0, -4.0), DVec3::new(60.0, 0.0, -4.0)], STROKE);
    Scene {
        objects: vec![Object { edges: Some(STROKE), ..at(0.0, -4.0) }, at(-8.0, -4.0), at(0.0, 4.0)],
        lights: vec![Light::directional(DVec3::NEG_ONE)],
        lines: vec![line],
        ..Scene::default()
    }
}

fn frame(scene: &Scene, style: &Style) -> Frame {
    Pipeline::default().frame(scene, &eye(Projection::Perspective), TARGET, style, Options::default())
}

fn counts(frame: &Frame, stage: Stage) -> Option<(usize, usize)> {
    assert_eq!(frame.report[stage as usize].stage, stage);
    frame.report[stage as usize].counts
}

#[test]
fn every_stage_counts_its_input_and_its_output() {
    let frame = frame(&cubes(), &shading(Shading::Gouraud));
    let expected = [
        (Stage::Traverse, (3, 3)),
        // The one behind the eye.
        (Stage::CullObjects, (3, 2)),
        // Vertices go by eights: those with the front of the first cube and those with the right side of the second.
        (Stage::Normals, (16, 16)),
        (Stage::Light, (16, 16)),
        (Stage::Transform, (48, 48)),
        // Two triangles of the first turn to the eye, its front, and four of the second, its front and its right side.
        (Stage::CullFaces, (24, 6)),
        // The front of the second (d = 3, x ≤ −7) is outside. Its right side (x = −7) is cut at d = 3.5: of the
        // triangle with one corner inside a triangle is left, of that with two a quadrilateral.
        (Stage::Clip, (6, 5)),
        // Two cuts for each of them.
        (Stage::Divide, (52, 52)),
        (Stage::Viewport, (52, 52)),
        // Eight edges and a line that is out of sight.
        (Stage::Lines, (9, 8)),
    ];
    for (stage, expected) in expected {
        assert_eq!(counts(&frame, stage), Some(expected), "{stage:?}");
    }
    for out_of_its_hands in [Stage::Fill, Stage::Interpolate, Stage::HiddenSurfaces] {
        assert_eq!(counts(&frame, out_of_its_hands), None, "{out_of_its_hands:?}");
    }
    assert_eq!(counts(&frame, Stage::Oblique), None, "left out");
    assert_eq!(frame.drawing.surfaces.iter().map(|s| s.triangles.len()).sum::<usize>(), 5);
}

#[test]
fn flat_shading_lights_faces_and_phong_neither() {
    let flat = frame(&cubes(), &shading(Shading::Flat));
    assert_eq!(counts(&flat, Stage::Light), Some((5, 5)));
    assert_eq!(counts(&flat, Stage::Normals), None);
    let phong = frame(&cubes(), &shading(Shading::Phong));
    assert_eq!(counts(&phong, Stage::Light), None);
    assert_eq!(counts(&phong, Stage::Normals), Some((48, 48)));
    let wireframe = frame(&cubes(), &shading(Shading::Wireframe));
    for without_faces in [Stage::CullFaces, Stage::Light, Stage::Normals] {
        assert_eq!(counts(&wireframe, without_faces), None);
    }
    // All edges of the two that may be in view, and the line. Of the second cube's eight edges, those of its front are
    // outside.
    assert_eq!(counts(&wireframe, Stage::Lines).map(|(asked, _)| asked), Some(17));
}

#[test]
fn faces_that_cross_are_split() {
    // A square on z = −4 and one on x = ½ across it: whichever plane divides, both triangles of the other square are
    // cut.
    let square = |s: DVec3, t: DVec3| Mesh {
        positions: vec![-s - t, s - t, s + t, t - s],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    };
    let mut scene = only(object(square(DVec3::X, DVec3::Y), DMat4::from_translation(DVec3::new(0.0, 0.0, -4.0))));
    let across = object(square(DVec3::Z, DVec3::Y), DMat4::from_translation(DVec3::new(0.5, 0.0, -4.0)));
    scene.objects.push(across);
    let style = |visibility| Style { visibility, ..shading(Shading::Flat) };
    let split = frame(&scene, &style(Visibility::Bsp));
    assert_eq!(counts(&split, Stage::HiddenSurfaces), Some((4, 6)));
    let whole = frame(&scene, &style(Visibility::Painter));
    assert_eq!(counts(&whole, Stage::HiddenSurfaces), Some((4, 4)));
}
