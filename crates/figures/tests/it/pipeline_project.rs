//! The scene in the canonical volume: clipped and projected.

#![expect(clippy::unwrap_used, reason = "tests")]

use camera_lab_engine::appearance::{Rgba, Samples, Shading, Style};
use camera_lab_engine::camera::{Camera, Parameters, Projection, ViewWindow};
use camera_lab_engine::pipeline::canonical::{clipped_scene, displayed_ndc, legible_clipped_scene};
use camera_lab_engine::pipeline::{Options, Pipeline, Target};
use camera_lab_engine::raster::Rasterizer;
use camera_lab_engine::scene::{Light, Line, Mesh, Object, ObjectPaint, Scene, build, no_files};
use camera_lab_figures::figure::read::parse;
use glam::{DMat4, DVec3};

use crate::common::scenes::{CLAY, STROKE, cube, eye, object, only};

fn at(x: f64, y: f64, z: f64) -> DMat4 {
    DMat4::from_translation(DVec3::new(x, y, z))
}

/// Six times the signed volume under the triangles.
fn volume(object: &Object) -> f64 {
    let p = &object.mesh.positions;
    object.mesh.triangles.iter().map(|t| p[t[0] as usize].dot(p[t[1] as usize].cross(p[t[2] as usize]))).sum()
}

fn area(object: &Object) -> f64 {
    let p = |i: u32| object.mesh.positions[i as usize];
    object.mesh.triangles.iter().map(|&[a, b, c]| (p(b) - p(a)).cross(p(c) - p(a)).length() / 2.0).sum()
}

/// The image of a point under the camera's matrices.
fn by_matrix(camera: &Camera, p_world: DVec3) -> DVec3 {
    let p = camera.clip_from_world() * p_world.extend(1.0);
    DVec3::new(p.x / p.w, p.y / p.w, -p.z / p.w)
}

#[test]
fn a_cube_inside_goes_where_the_matrix_of_the_notes_takes_it() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let camera = eye(projection);
        let scene = only(object(cube(), at(0.3, 0.0, -4.0)));
        let clipped = clipped_scene(&scene, &camera, Shading::Flat);
        let (found, given) = (&clipped.objects[0], &scene.objects[0]);
        assert!(found.mesh.closed && found.mesh.convex && !found.two_sided && !found.lit);
        assert_eq!(found.mesh.triangles.len(), 12);
        assert_eq!(found.mesh.edges.len(), given.mesh.edges.len());
        for (t_found, t_given) in found.mesh.triangles.iter().zip(&given.mesh.triangles) {
            for (&i, &j) in t_found.iter().zip(t_given) {
                let p_world = given.world_from_object.transform_point3(given.mesh.positions[j as usize]);
                let expected = by_matrix(&camera, p_world);
                assert!(found.mesh.positions[i as usize].abs_diff_eq(expected, 1e-14));
                assert!(displayed_ndc(&camera, p_world).unwrap().abs_diff_eq(expected, 1e-14));
            }
        }
        // A projective map with w > 0 keeps the outside outside.
        assert!(volume(found) > 0.0);
    }
}

#[test]
fn a_mirrored_object_keeps_its_outside() {
    let place = at(0.3, -0.2, -4.0) * DMat4::from_scale(DVec3::new(1.0, -1.0, 1.0));
    let clipped = clipped_scene(&only(object(cube(), place)), &eye(Projection::Perspective), Shading::Flat);
    assert!(volume(&clipped.objects[0]) > 0.0);
}

#[test]
fn clipped_edges_end_in_the_faces_of_the_volume() {
    let camera = eye(Projection::Perspective);
    for place in [at(0.0, 0.0, -1.0), at(5.0, 2.0, -3.0), at(-7.5, 0.0, -9.0), at(0.1, 0.2, -0.9)] {
        let clipped = clipped_scene(&only(object(cube(), place)), &camera, Shading::Gouraud);
        let cut = &clipped.objects[0];
        assert!(!cut.mesh.closed && !cut.mesh.convex && cut.two_sided);
        let outermost = cut.mesh.positions.iter().fold(DVec3::ZERO, |most, p| most.max(p.abs()));
        assert!(outermost.max_element() == 1.0, "{outermost}");
    }
    assert!(clipped_scene(&only(object(cube(), at(0.0, 0.0, 1.1))), &camera, Shading::Flat).objects.is_empty());
}

#[test]
fn cutting_finer_triangles_leaves_the_same_surface() {
    // The same plate, tilted through the whole volume and out of it, from 2 and from 512 triangles.
    let plate = |n: u32| {
        let mut mesh = Mesh::default();
        let side = f64::from(n);
        for j in 0..=n {
            for i in 0..=n {
                mesh.positions.push(DVec3::new(f64::from(i) / side - 0.5, f64::from(j) / side - 0.5, 0.0) * 30.0);
                mesh.normals.push(DVec3::Z);
            }
        }
        for j in 0..n {
            for i in 0..n {
                let k = j * (n + 1) + i;
                mesh.triangles.extend([[k, k + 1, k + n + 2], [k, k + n + 2, k + n + 1]]);
            }
        }
        let tilt = DMat4::from_rotation_x(-1.2) * DMat4::from_rotation_y(0.3);
        object(mesh, at(0.2, -0.6, -5.0) * tilt)
    };
    for projection in [Projection::Perspective, Projection::Parallel] {
        let areas = [1, 16].map(|n| {
            let clipped = clipped_scene(&only(plate(n)), &eye(projection), Shading::Flat);
            area(&clipped.objects[0])
        });
        assert!(areas[0] > 1.0);
        assert!((areas[0] / areas[1] - 1.0).abs() < 1e-13, "{areas:?}");
    }
}

#[test]
fn colours_are_those_of_the_world() {
    let camera = eye(Projection::Parallel);
    let lit = |shading| {
        let mut scene = only(object(cube(), at(0.0, 0.0, -4.0)));
        scene.lights = vec![Light::directional(DVec3::NEG_Z)];
        clipped_scene(&scene, &camera, shading).objects[0].paint.clone()
    };
    let dark = Rgba::rgb(70, 35, 14);
    let ObjectPaint::Faces(faces) = lit(Shading::Flat) else { panic!("flat") };
    // Faces in the order +x −x +y −y +z −z: only +z looks towards the lamp.
    assert_eq!(*faces, [[dark; 8].as_slice(), &[CLAY; 2], &[dark; 2]].concat());
    let ObjectPaint::Vertices(vertices) = lit(Shading::Gouraud) else { panic!("gouraud") };
    assert_eq!(vertices.len(), 24);
    assert_eq!(lit(Shading::Wireframe), ObjectPaint::Solid(CLAY));
}

#[test]
fn lines_end_in_the_faces_too() {
    let camera = eye(Projection::Perspective);
    let points = [DVec3::new(0.0, 0.0, 3.0), DVec3::new(0.0, 0.0, -3.0), DVec3::new(0.0, 0.0, -30.0)];
    let scene = Scene { lines: vec![Line::new(points.to_vec(), STROKE)], ..Scene::default() };
    let clipped = clipped_scene(&scene, &camera, Shading::Flat);
    assert_eq!(clipped.lines.len(), 1);
    // −z_n at d = 3 is 2 · 6/24 − 1.
    let ends = [1.0, -0.5, -1.0].map(|z| DVec3::new(0.0, 0.0, z));
    assert_eq!(clipped.lines[0].points, ends);
    assert!(!clipped.lines[0].style.arrow, "the end was cut off");
    assert_eq!(displayed_ndc(&camera, DVec3::ZERO), None);
    assert_eq!(displayed_ndc(&camera, DVec3::Z), None);
}

#[test]
fn an_oblique_window_agrees_with_its_matrix() {
    let base = *eye(Projection::Perspective).parameters();
    let window = ViewWindow { left: -0.5, right: 3.0, bottom: 0.25, top: 1.0 };
    for projection in [Projection::Perspective, Projection::Parallel] {
        let camera = Camera::new(&Parameters { window: Some(window), projection, ..base }).unwrap();
        for p_world in [DVec3::new(1.0, 2.0, -5.0), DVec3::new(-1.0, 0.3, -1.5)] {
            assert!(displayed_ndc(&camera, p_world).unwrap().abs_diff_eq(by_matrix(&camera, p_world), 1e-14));
        }
    }
}

#[test]
fn clipped_parts_of_huge_edges_lie_in_the_volume() {
    // The rounding of the point in which one of these edges meets the near plane is up to a million times as wide as
    // the window there, and of any sign.
    let mut state = 1_u64;
    let mut number = |least: f64, most: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        least + (most - least) * ((state >> 11) as f64 / 2_f64.powi(53))
    };
    let mut corners = 0;
    for k in 0..4000 {
        let decade = |from: f64, to: f64, number: &mut dyn FnMut(f64, f64) -> f64| 10_f64.powf(number(from, to));
        let near = decade(-15.0, 0.0, &mut number);
        let parameters = Parameters {
            position: DVec3::ZERO,
            focal_point: DVec3::new(number(-0.1, 0.1), number(-0.1, 0.1), -1.0),
            near,
            far: near + decade(-18.0, 3.0, &mut number),
            view_angle: number(1.0, 170.0),
            projection: if k % 4 == 0 { Projection::Parallel } else { Projection::Perspective },
            ..Parameters::default()
        };
        let Ok(camera) = Camera::new(&parameters) else { continue };
        // A triangle around the eye, of any size: its plane passes the near window at a distance like F.
        let mut size = || decade(-3.0, 6.0, &mut number);
        let (a, b, c) = (size(), size(), size());
        let z = near * number(1.0, 3.0);
        let positions = vec![
            DVec3::new(-a, number(-a, a), -z - number(-a, a)),
            DVec3::new(b, number(-b, b), -z),
            DVec3::new(0.0, -c, c),
        ];
        let mesh =
            Mesh { positions, triangles: vec![[0, 1, 2]], edges: vec![[0, 1], [1, 2], [2, 0]], ..Mesh::default() };
        let scene = only(object(mesh, DMat4::IDENTITY));
        for clipped in [clipped_scene, legible_clipped_scene].map(|clip| clip(&scene, &camera, Shading::Flat)) {
            for p in clipped.objects.iter().flat_map(|object| &object.mesh.positions) {
                assert!(p.abs().max_element() <= 1.0 + 1e-9, "{p} of {parameters:?}");
                corners += 1;
            }
        }
    }
    assert!(corners > 2000, "{corners}");
}

/// A texture has each face's light beside its colours, in every shading, whatever is culled.
#[test]
fn textured_faces_keep_the_light_of_the_world() {
    let figure = parse("[[scene.objects]]\nname = \"floor\"\nshape = \"box\"\ntexture = \"chequer\"\n").unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    let front = Parameters {
        position: DVec3::Z * 2.0,
        projection: Projection::Parallel,
        near: 1.0,
        far: 3.0,
        window: Some(ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 }),
        ..Parameters::default()
    };
    let front = Camera::new(&front).unwrap();
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let style = Style { shading, antialias: Samples::One, ..Style::default() };
        let scene = build(&figure.scene, &style, &mut no_files).unwrap();
        let target = Target { width: 120, height: 90, scale: 1.0, background: Rgba::rgb(0, 0, 255) };
        let pixels = |scene: &Scene, camera: &Camera| {
            let drawing = Pipeline::default().frame(scene, camera, target, &style, Options::default()).drawing;
            Rasterizer::default().paint(&drawing).unwrap().data().as_chunks::<4>().0.to_vec()
        };
        let [image, canonical] = [pixels(&scene, &camera), pixels(&clipped_scene(&scene, &camera, shading), &front)];
        let differs = |(a, b): &(&[u8; 4], &[u8; 4])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 24);
        let covered = image.iter().filter(|pixel| **pixel != [0, 0, 255, 255]).count();
        let different = image.iter().zip(&canonical).filter(differs).count();
        assert!(covered > 1000 && 20 * different < covered, "{shading:?}: {different} of {covered}");
    }
}
