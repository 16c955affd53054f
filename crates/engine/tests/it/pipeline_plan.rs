//! The plan: its reasons, and that it changes no pixel.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::sync::Arc;

use camera_lab_engine::appearance::{Dash, HiddenLines, LineStyle, Rgba, Samples, Shading, Style, Visibility};
use camera_lab_engine::camera::{Camera, Projection};
use camera_lab_engine::pipeline::plan::{Options, Output, Reason, Stage};
use camera_lab_engine::pipeline::{Containment, FacesDone, Frame, Pipeline, Target};
use camera_lab_engine::raster::Rasterizer;
use camera_lab_engine::scene::{Light, Line, Mesh, Object, ObjectPaint, Scene, primitives};
use glam::{DMat4, DVec3};
use proptest::prelude::*;

use crate::common::any_scene::{any_camera, any_scene, reproducible};
use crate::common::scenes::{CLAY, TARGET, cube, eye, object, only};

const FORCED: Options = Options {
    force_all_stages: true,
    force_stage: None,
    output: Output::Pixels,
    depth_of_volume: false,
    shown: None,
    followed: None,
    clock: None,
};

fn frame(scene: &Scene, camera: &Camera, style: &Style) -> Frame {
    Pipeline::default().frame(scene, camera, TARGET, style, Options::default())
}

fn at(z: f64) -> DMat4 {
    DMat4::from_translation(DVec3::new(0.0, 0.0, z))
}

fn reason(frame: &Frame, stage: Stage) -> (bool, Reason) {
    let planned = frame.plan.stage(stage);
    assert_eq!(planned.stage, stage);
    (planned.runs, planned.reason)
}

#[test]
fn a_cube_alone_needs_little() {
    let half = DMat4::from_scale(DVec3::splat(0.5));
    let scene = Scene { lights: vec![Light::directional(DVec3::NEG_ONE)], ..only(object(cube(), at(-4.0) * half)) };
    let style = Style { antialias: Samples::One, ..Style::default() };
    let frame = frame(&scene, &eye(Projection::Parallel), &style);
    assert_eq!(reason(&frame, Stage::Clip), (false, Reason::AllInside { objects: 1 }));
    assert_eq!(reason(&frame, Stage::HiddenSurfaces), (false, Reason::ConvexAlone));
    assert_eq!(reason(&frame, Stage::Divide), (false, Reason::ParallelProjection));
    assert_eq!(reason(&frame, Stage::Oblique), (false, Reason::SymmetricWindow));
    assert_eq!(reason(&frame, Stage::Normals), (false, Reason::FlatShading));
    assert_eq!(reason(&frame, Stage::Light), (true, Reason::LitFaces { objects: 1 }));
    assert_eq!(reason(&frame, Stage::Interpolate), (false, Reason::OneColorAFace));
    assert_eq!(reason(&frame, Stage::Blend), (false, Reason::AllOpaque));
    assert_eq!(reason(&frame, Stage::Antialias), (false, Reason::OneSample));
    assert!(!frame.drawing.surfaces[0].depth_test);
    let cull = frame.report[Stage::CullFaces as usize];
    assert_eq!((cull.stage, cull.counts), (Stage::CullFaces, Some((12, 2))));
    assert_eq!(frame.report[Stage::Clip as usize].counts, None, "left out");
}

#[test]
fn each_ground_for_a_stage_brings_it_back() {
    let style = Style::default();
    let camera = eye(Projection::Perspective);
    let depth = |scene: &Scene| reason(&frame(scene, &camera, &style), Stage::HiddenSurfaces);
    let alone = only(object(cube(), at(-4.0)));
    assert_eq!(depth(&alone), (false, Reason::ConvexAlone));
    let mut two = alone.clone();
    two.objects.push(object(cube(), at(-7.0)));
    assert_eq!(depth(&two), (true, Reason::SeveralObjects { objects: 2 }));
    // The second one behind the eye does not count.
    two.objects[1].world_from_object = at(7.0);
    assert_eq!(depth(&two), (false, Reason::ConvexAlone));
    assert_eq!(
        reason(&frame(&two, &camera, &style), Stage::CullObjects),
        (true, Reason::Outside { outside: 1, of: 2 })
    );
    // Outside the near plane, and with w < 0 outside the four sides too, but inside the far plane.
    assert_eq!(frame(&two, &camera, &style).plan.objects[1].containment, Containment::Outside(0b01_1111));
    let mut hollow = alone.clone();
    hollow.objects[0].mesh = Arc::new(primitives::torus(8));
    assert_eq!(depth(&hollow), (true, Reason::HidesItself));
    let mut both_sides = alone.clone();
    both_sides.objects[0].two_sided = true;
    assert_eq!(depth(&both_sides), (true, Reason::HidesItself));
    assert_eq!(
        reason(&frame(&both_sides, &camera, &style), Stage::CullFaces),
        (false, Reason::BothSidesSeen { objects: 1 })
    );
    // Through the hole that the near plane cuts, the inside shows.
    assert_eq!(depth(&only(object(cube(), at(-1.5)))), (true, Reason::HidesItself));
    let mut with_line = alone.clone();
    let line = LineStyle { color: CLAY, width: 1.0, dash: Dash::Solid, hidden: HiddenLines::Dashed, arrow: false };
    with_line.lines.push(Line::new(vec![DVec3::ZERO, DVec3::NEG_Z * 5.0], line));
    assert_eq!(depth(&with_line), (true, Reason::LinesAskForDepth));
    with_line.lines[0].style.hidden = HiddenLines::Shown;
    assert_eq!(depth(&with_line), (false, Reason::ConvexAlone));

    let beside = only(object(cube(), DMat4::from_translation(DVec3::new(8.0, 0.0, -4.0))));
    let crossing = frame(&beside, &camera, &style);
    assert_eq!(reason(&crossing, Stage::Clip), (true, Reason::Crossing { objects: 1, of: 1, planes: 0b10 }));
    assert_eq!(crossing.plan.objects[0].clip_planes, 0b10);

    let wireframe = Style { shading: Shading::Wireframe, ..style };
    let bare = frame(&alone, &camera, &wireframe);
    for stage in [Stage::Fill, Stage::HiddenSurfaces, Stage::Light, Stage::CullFaces, Stage::Blend] {
        assert_eq!(reason(&bare, stage), (false, Reason::Wireframe));
    }
    assert_eq!(reason(&bare, Stage::Divide), (true, Reason::PerspectiveProjection));
}

#[test]
fn the_inside_of_a_box_that_the_near_plane_cuts_open_is_seen() {
    // The eye's near plane is inside the cube: the face behind it is seen, from inside.
    let scene = only(object(cube(), at(-1.5)));
    let frame = frame(&scene, &eye(Projection::Perspective), &Style::default());
    let surface = &frame.drawing.surfaces[0];
    let back_face = surface.triangles.iter().filter(|t| {
        // At d = 2.5: depth (9 − 2.5)/(2.5 · 8)
        t.iter().all(|&i| (surface.positions[i as usize][2] - 0.325).abs() < 1e-6)
    });
    assert_eq!(back_face.count(), 2);
}

/// The report of a stage once all is done.
fn said(frame: &Frame, stage: Stage) -> (bool, Reason, Option<(usize, usize)>) {
    let report = frame.report[stage as usize];
    assert_eq!(report.stage, stage);
    (report.ran, report.reason, report.counts)
}

#[test]
fn back_faces_that_were_kept_are_not_reported_as_dropped() {
    let (camera, style) = (eye(Projection::Perspective), Style::default());
    // The near plane (z = −1) goes through the first cube: its inside shows.
    let mut scene = only(object(cube(), at(-1.5)));
    let open = frame(&scene, &camera, &style);
    assert_eq!(said(&open, Stage::CullFaces), (false, Reason::CutOpen { objects: 1, of: 1 }, None));
    assert_eq!(open.objects[0].faces, FacesDone::CutOpen);
    assert!(reason(&open, Stage::CullFaces).0, "it was planned all the same");
    scene.objects.push(object(cube(), at(-6.0)));
    let both = frame(&scene, &camera, &style);
    let (ran, why, counts) = said(&both, Stage::CullFaces);
    assert_eq!((ran, why), (true, Reason::BackFaces { objects: 1, of: 2 }));
    // Of the second cube the front is left.
    assert_eq!(counts, Some((24, 14)));
    assert_eq!(both.objects.iter().map(|o| o.faces).collect::<Vec<_>>(), [FacesDone::CutOpen, FacesDone::BackDropped]);
}

#[test]
fn a_stage_that_was_left_with_no_face_says_so() {
    // Across the corner of the view volume: the box around the triangle crosses two planes, the triangle is outside.
    let mesh = Mesh {
        positions: [(-12.0, 3.0), (-3.5, 11.0), (-12.0, 11.0)].map(|(x, y)| DVec3::new(x, y, -4.0)).to_vec(),
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let mut scene = only(object(mesh, DMat4::IDENTITY));
    scene.objects[0].two_sided = true;
    scene.lights.push(Light::directional(DVec3::NEG_Z));
    let frame = frame(&scene, &eye(Projection::Perspective), &Style::default());
    assert!(
        matches!(frame.objects[0].containment, Containment::Crosses(planes) if planes != 0),
        "{:?}",
        frame.objects[0]
    );
    assert_eq!(frame.objects[0].triangles, 0);
    for stage in [Stage::Fill, Stage::Light] {
        assert_eq!(said(&frame, stage), (false, Reason::NoFaceLeft, None), "{stage:?}");
    }
}

#[test]
fn light_at_vertices_and_at_pixels_has_separate_reasons() {
    let mut scene = only(object(cube(), at(-4.0)));
    scene.lights.push(Light::directional(DVec3::NEG_Z));
    let colors = vec![CLAY; scene.objects[0].mesh.positions.len()];
    scene.objects.push(Object { paint: ObjectPaint::Vertices(Arc::new(colors)), ..object(cube(), at(-7.0)) });
    let style = Style { shading: Shading::Phong, ..Style::default() };
    let said = |scene: &Scene| {
        let frame = frame(scene, &eye(Projection::Perspective), &style);
        [Stage::Normals, Stage::Light].map(|stage| (said(&frame, stage).0, said(&frame, stage).1))
    };
    assert_eq!(said(&scene), [(true, Reason::LitVerticesAndPixels { vertices: 1, pixels: 1 }); 2]);
    let last = scene.objects.pop().unwrap();
    assert_eq!(said(&scene), [(true, Reason::LitPixels { objects: 1 }), (false, Reason::LitPixels { objects: 1 })]);
    scene.objects[0] = last;
    assert_eq!(said(&scene), [(true, Reason::LitVertices { objects: 1 }); 2]);
}

proptest! {
    #![proptest_config(reproducible(4))]

    #[test]
    fn the_plan_changes_no_pixel(
        scene in any_scene(),
        camera in any_camera(),
        visibility in prop_oneof![
            4 => Just(Visibility::DepthBuffer),
            1 => Just(Visibility::Painter),
            1 => Just(Visibility::Bsp),
        ],
        shading in prop_oneof![Just(Shading::Wireframe), Just(Shading::Flat), Just(Shading::Gouraud), Just(Shading::Phong)],
        antialias in prop_oneof![6 => Just(Samples::One), 2 => Just(Samples::Four), 1 => Just(Samples::Sixteen)],
    ) {
        let target = Target { width: 48, height: 36, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
        let style = Style { shading, visibility, antialias, ..Style::default() };
        let mut pipeline = Pipeline::default();
        let planned = pipeline.frame(&scene, &camera, target, &style, Options::default());
        let mut raster = Rasterizer::default();
        let a = raster.paint(&planned.drawing).unwrap();
        let forced = pipeline.frame(&scene, &camera, target, &style, FORCED);
        prop_assert!(forced.plan.stages.iter().all(|stage| stage.runs));
        let b = raster.paint(&forced.drawing).unwrap();
        prop_assert!(a.data() == b.data());
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    // Large enough for every loop that is shared among threads, and near enough to be cut.
    let ball = object(primitives::sphere(200), at(-3.2) * DMat4::from_scale(DVec3::splat(2.3)));
    let colors = (0..ball.mesh.triangles.len()).map(|i| Rgba::rgb(u8::try_from(i % 251).unwrap(), 90, 200));
    let patches = ObjectPaint::Faces(Arc::new(colors.collect()));
    let lights = vec![Light::point(DVec3::new(2.0, 3.0, 1.0))];
    let threads = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    let (one, three) = (threads(1), threads(3));
    for paint in [ball.paint.clone(), patches] {
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            let object = Object { paint: paint.clone(), ..ball.clone() };
            let scene = Scene { lights: lights.clone(), ..only(object) };
            let style = Style { shading, antialias: Samples::One, ..Style::default() };
            let drawn = || frame(&scene, &eye(Projection::Perspective), &style);
            let (a, b) = (one.install(drawn), three.install(drawn));
            assert!(a.drawing.surfaces.iter().map(|s| s.triangles.len()).sum::<usize>() > 10_000);
            assert!(a == b, "{shading:?}");
        }
    }
}
