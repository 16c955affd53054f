//! Objects out of sight: dropped by their bounds, never wrongly.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::sync::Arc;

use camera_lab_engine::appearance::{Rgba, Samples, Shading, Style};
use camera_lab_engine::camera::{Camera, Parameters};
use camera_lab_engine::pipeline::{Containment, Frame, Options, Pipeline, Reason, Scenes, Stage, Target};
use camera_lab_engine::raster::Rasterizer;
use camera_lab_engine::scene::{Light, Mesh, Object, Scene, Shadows, primitives};
use glam::{DMat4, DVec3};
use proptest::prelude::*;

use crate::common::scenes::object;

const SMALL: Target = Target { width: 60, height: 60, scale: 1.0, background: Rgba::rgb(255, 255, 255) };

/// Looks down −z from z = 10 at a square 4 wide on z = 0.
fn above() -> Camera {
    Camera::new(&Parameters {
        position: DVec3::new(0.0, 0.0, 10.0),
        focal_point: DVec3::ZERO,
        view_angle: 2.0 * 0.2_f64.atan().to_degrees(),
        aspect: 1.0,
        near: 5.0,
        far: 15.0,
        ..Parameters::default()
    })
    .unwrap()
}

/// `side`² cubes half a unit large, 1.25 apart, on z = 0.
fn field(side: u32, mesh: &Arc<Mesh>) -> Scene {
    let place = |k: u32| 1.25 * (f64::from(k) - f64::from(side / 2) + 0.5);
    let cube = |k: u32| {
        let at = DVec3::new(place(k % side), place(k / side), 0.0);
        let place = DMat4::from_translation(at) * DMat4::from_scale(DVec3::splat(0.25));
        Object { mesh: mesh.clone(), ..object(Mesh { closed: true, ..Mesh::default() }, place) }
    };
    let light = Light::directional(DVec3::NEG_ONE);
    Scene { objects: (0..side * side).map(cube).collect(), lights: vec![light], ..Scene::default() }
}

fn frame(pipeline: &mut Pipeline, scene: &Scene, force: bool) -> Frame {
    let options = Options { force_all_stages: force, ..Options::default() };
    pipeline.frame(
        scene,
        &above(),
        SMALL,
        &Style { antialias: Samples::One, ..crate::common::scenes::shading(Shading::Gouraud) },
        options,
    )
}

fn pixels(frame: &Frame) -> Vec<u8> {
    Rasterizer::default().paint(&frame.drawing).unwrap().take()
}

#[test]
fn objects_out_of_sight_are_dropped() {
    let scene = field(40, &Arc::new(primitives::cube()));
    let mut pipeline = Pipeline::default();
    let planned = frame(&mut pipeline, &scene, false);
    // The view is 4 wide: ±0.625 and ±1.875 in each direction are in it, or cross its border.
    assert_eq!(planned.plan.objects.iter().filter(|object| object.drawn).count(), 16);
    assert!(pixels(&planned) == pixels(&frame(&mut pipeline, &scene, true)));
}

#[test]
fn a_scene_that_changes_is_seen_as_it_is() {
    let mesh = Arc::new(primitives::cube());
    let mut scene = field(12, &mesh);
    let mut kept = Pipeline::default();
    let aside = |k: usize| DMat4::from_translation(DVec3::new(1e3, 0.1 * k as f64, 0.0));
    for step in 0..40_usize {
        match step % 8 {
            // One comes into view, and goes again.
            0 => scene.objects[7 * step % 60].world_from_object = DMat4::from_scale(DVec3::splat(0.3)),
            1 => scene.objects[7 * (step - 1) % 60].world_from_object = aside(step),
            // Another shape at the same place.
            2 => scene.objects[70].mesh = Arc::new(primitives::sphere(6)),
            3 => scene.objects.truncate(scene.objects.len() - 9),
            4 => scene.objects.extend(field(3, &mesh).objects),
            // Everything moves.
            5 => scene
                .objects
                .iter_mut()
                .for_each(|o| o.world_from_object = DMat4::from_rotation_z(0.1) * o.world_from_object),
            6 => scene.objects.reverse(),
            _ => {}
        }
        let (old, new) = (frame(&mut kept, &scene, false), frame(&mut Pipeline::default(), &scene, false));
        let drawn = |frame: &Frame| frame.plan.objects.iter().map(|object| object.drawn).collect::<Vec<_>>();
        assert_eq!(drawn(&old), drawn(&new), "step {step}");
        assert!(old.drawing == new.drawing, "step {step}");
    }
}

/// Something that happens between two pictures.
#[derive(Clone, Copy, Debug)]
enum Change {
    Nothing,
    Moves(usize, [f64; 3]),
    Shape(usize),
    Shorter(usize),
    Longer(u32),
    Gear(u32),
    Light,
    Shadows,
}

fn changes() -> impl Strategy<Value = (Change, [f64; 4])> {
    let change = prop_oneof![
        3 => Just(Change::Nothing),
        3 => (any::<usize>(), prop::array::uniform3(-9.0..9.0)).prop_map(|(k, at)| Change::Moves(k, at)),
        1 => any::<usize>().prop_map(Change::Shape),
        1 => (0..40_usize).prop_map(Change::Shorter),
        1 => (1..5_u32).prop_map(Change::Longer),
        1 => (0..3_u32).prop_map(Change::Gear),
        1 => Just(Change::Light),
        1 => Just(Change::Shadows),
    ];
    (change, [-3.0..3.0, -9.0..9.0, -9.0..9.0, 4.0..60.0])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn a_pipeline_that_knows_a_scene_draws_and_reports_as_a_new_one(
        changes in prop::collection::vec(changes(), 1..12),
        side in 2..14_u32,
    ) {
        let mesh = Arc::new(primitives::cube());
        let (mut scene, mut gear) = (field(side, &mesh), Scene::default());
        let mut kept = Pipeline::default();
        for (change, [height, x, y, view_angle]) in changes {
            let count = scene.objects.len().max(1);
            match change {
                Change::Nothing => {}
                Change::Gear(side) => gear = field(side, &mesh),
                Change::Light => scene.lights.push(Light::directional(DVec3::new(1.0, 2.0, -3.0))),
                Change::Shadows => {
                    scene.lights[0].shadows = Shadows { map: 64, ..Shadows::CAST };
                }
                Change::Moves(k, at) => if let Some(object) = scene.objects.get_mut(k % count) {
                    object.world_from_object = DMat4::from_translation(DVec3::from_array(at)) * object.world_from_object;
                },
                Change::Shape(k) => if let Some(object) = scene.objects.get_mut(k % count) {
                    object.mesh = Arc::new(if k % 3 == 0 { Mesh::default() } else { primitives::sphere(6) });
                },
                Change::Shorter(by) => scene.objects.truncate(scene.objects.len().saturating_sub(by)),
                Change::Longer(side) => scene.objects.extend(field(side, &mesh).objects),
            }
            let camera = Camera::new(&Parameters {
                position: DVec3::new(x, y, 8.0 + height),
                focal_point: DVec3::new(0.7 * x, 0.8 * y, 0.0),
                view_angle,
                aspect: 1.0,
                near: 1.0,
                far: 40.0,
                ..Parameters::default()
            }).unwrap();
            let style = Style { antialias: Samples::One, ..crate::common::scenes::shading(Shading::Gouraud) };
            let draw = |pipeline: &mut Pipeline, scenes: Scenes, force_all_stages| {
                let options = Options { force_all_stages, ..Options::default() };
                pipeline.frame(scenes, &camera, SMALL, &style, options)
            };
            let scenes = Scenes::new(&scene, &gear);
            let known = draw(&mut kept, scenes, false);
            let mut fresh = Pipeline::default();
            let new = draw(&mut fresh, scenes, false);
            prop_assert!(known.drawing == new.drawing);
            // Maps of shadows are kept, and cost nothing then.
            let operations = |frame: &Frame| frame.report.iter().map(|r| (r.stage, r.ran, r.reason, r.counts)).collect::<Vec<_>>();
            prop_assert_eq!(operations(&known), operations(&new));
            prop_assert_eq!(&known.plan.stages, &new.plan.stages);
            prop_assert!(pixels(&known) == pixels(&draw(&mut fresh, scenes, true)));

            let all = || scene.objects.iter().chain(&gear.objects);
            prop_assert_eq!((known.objects.len(), known.plan.objects.len()), (all().count(), all().count()));
            let outside = |place| matches!(place, Containment::Outside(_));
            let mut dropped = 0;
            for (k, object) in all().enumerate() {
                let (report, plan) = (&known.objects[k], &known.plan.objects[k]);
                prop_assert_eq!(plan.containment, report.containment);
                dropped += usize::from(outside(report.containment));
                let alone = Scene { objects: vec![object.clone()], ..Scene::default() };
                let alone = draw(&mut Pipeline::default(), Scenes::from(&alone), false).objects[0];
                prop_assert_eq!(report.containment, alone.containment);
                prop_assert_eq!((report, plan), (&new.objects[k], &new.plan.objects[k]));
                if outside(report.containment) {
                    prop_assert_eq!((report.triangles, plan.drawn), (0, false));
                }
            }
            let culled = new.report.iter().find(|report| report.stage == Stage::CullObjects).unwrap().reason;
            let said = if dropped == 0 { Reason::NoneOutside { of: all().count() } } else {
                Reason::Outside { outside: dropped, of: all().count() }
            };
            prop_assert_eq!(culled, said);
        }
    }
}

#[test]
fn a_ball_is_inside_although_the_corners_of_its_box_are_not() {
    let ball = |radius: f64| {
        let place = DMat4::from_rotation_x(0.7) * DMat4::from_rotation_y(0.6) * DMat4::from_scale(DVec3::splat(radius));
        let scene = Scene { objects: vec![object(primitives::sphere(16), place)], ..Scene::default() };
        frame(&mut Pipeline::default(), &scene, false).plan.objects[0].containment
    };
    // The planes go through x = ±2 on z = 0, and are 2 · cos(atan 0.2) = 1.961 from the origin.
    assert_eq!(ball(1.95), Containment::Crosses(0));
    assert_eq!(ball(1.99), Containment::Crosses(0b1111));
}

#[test]
fn a_vertex_that_is_not_a_number_takes_its_faces_with_it() {
    let mut mesh = primitives::cube();
    mesh.positions[0].x = f64::NAN;
    let scene = Scene { objects: vec![object(mesh, DMat4::IDENTITY)], ..Scene::default() };
    let planned = frame(&mut Pipeline::default(), &scene, false);
    assert!(pixels(&planned) == pixels(&frame(&mut Pipeline::default(), &scene, true)));
    let finite = |s: &camera_lab_engine::drawing::Surface| {
        s.triangles.iter().flatten().all(|&i| s.positions[i as usize].iter().all(|c| c.is_finite()))
    };
    assert!(planned.drawing.surfaces.iter().all(finite));
}
