//! The equations of the notes, one by one, against numbers that were worked out by hand.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::path::{Path, PathBuf};

use camera_lab_engine::camera::{Camera, ImageSize, Parameters, Projection, ViewWindow, Viewport};
use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::common::camera::{assert_close, assert_close3, camera, rows};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// C = (0, 0, 5) looking at the origin: world and VRC have parallel axes.
fn plain(change: impl FnOnce(&mut Parameters)) -> Camera {
    camera(|p| {
        p.position = DVec3::new(0.0, 0.0, 5.0);
        change(p);
    })
}

const OFF_AXIS: ViewWindow = ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 };

fn off_axis(projection: Projection) -> Camera {
    plain(|p| {
        (p.projection, p.window) = (projection, Some(OFF_AXIS));
        (p.near, p.far) = (2.0, 6.0);
    })
}

#[test]
fn eq_5_1_aspect_is_width_over_height() {
    assert_eq!(OFF_AXIS.aspect(), 4.0 / 3.0);
    assert_eq!(off_axis(Projection::Perspective).window_aspect(), 4.0 / 3.0);
    assert_eq!(plain(|p| p.aspect = 2.5).window_aspect(), 2.5);
}

#[test]
fn eq_5_2_direction_of_projection_and_distance() {
    let camera = camera(|p| {
        p.position = DVec3::new(1.0, 2.0, 3.0);
        p.focal_point = DVec3::new(3.0, 5.0, 9.0);
    });
    assert_eq!(camera.distance(), 7.0);
    assert_eq!(camera.direction_of_projection(), DVec3::new(2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0));
}

#[test]
fn eq_5_3_basis_of_exercise_5_1() {
    // The exercise gives (0, 1, 0) as v. It is not perpendicular to n = (3/5, 4/5, 0), so it is a VUP.
    let camera = camera(|p| p.position = DVec3::new(3.0, 4.0, 0.0));
    let basis = camera.basis();
    assert_eq!(basis.n, DVec3::new(0.6, 0.8, 0.0));
    assert_eq!(basis.u, DVec3::new(0.0, 0.0, -1.0));
    assert_eq!(basis.v, DVec3::new(-0.8, 0.6, 0.0));
}

#[test]
fn eq_5_3_basis_of_exercise_5_2() {
    let basis = exercise_5_2(Projection::Parallel).basis();
    assert_close3(basis.n, DVec3::new(6.0, -1.0, -1.0) / 38f64.sqrt());
    assert_close3(basis.u, DVec3::new(0.0, 1.0, -1.0) / 2f64.sqrt());
    assert_close3(basis.v, DVec3::new(1.0, 3.0, 3.0) / 19f64.sqrt());
}

#[test]
fn eq_5_4_and_5_5_height_from_angle_and_back() {
    let camera = plain(|p| (p.view_angle, p.near, p.aspect) = (60.0, 1.5, 2.0));
    assert_close(camera.window_height(), 3f64.sqrt());
    assert_close(camera.window_width(), 2.0 * 3f64.sqrt());
    assert_eq!(camera.view_angle().degrees(), 60.0);
    let right = plain(|p| (p.view_angle, p.near, p.far) = (90.0, 7.0, 8.0)).window();
    assert_eq!((right.bottom, right.top), (-7.0, 7.0), "tan 45° is 1");
}

#[test]
fn eq_5_6_and_5_8_clip_and_device_coordinates() {
    let camera = plain(|p| (p.view_angle, p.near, p.far, p.aspect) = (90.0, 1.0, 3.0, 2.0));
    let s = camera.stations(DVec3::new(2.0, -1.0, 3.0), ImageSize::default(), &Viewport::whole(ImageSize::default()));
    assert_eq!(s.view, DVec3::new(2.0, -1.0, -2.0));
    assert_eq!(s.clip, DVec4::new(1.0, -1.0, 1.0, 2.0));
    assert_eq!(s.projected.map(|p| p.ndc), Some(DVec3::new(0.5, -0.5, 0.5)));
    assert!(s.inside);
    assert_eq!(camera.clip_point(s.world), s.clip);
}

#[test]
fn eq_5_7_view_matrix() {
    let camera = camera(|p| p.position = DVec3::new(3.0, 4.0, 0.0));
    let expected = [[0.0, 0.0, -1.0, 0.0], [-0.8, 0.6, 0.0, 0.0], [0.6, 0.8, 0.0, -5.0], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(rows(camera.view_from_world()), expected);
    let inverse = [[0.0, -0.8, 0.6, 3.0], [0.0, 0.6, 0.8, 4.0], [-1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(rows(camera.world_from_view()), inverse);
}

#[test]
fn eq_5_9_and_5_10_projection_onto_the_window() {
    let image = ImageSize::default();
    let window =
        |camera: &Camera, point| camera.stations(point, image, &Viewport::whole(image)).projected.map(|p| p.window);
    let perspective = plain(|p| (p.near, p.far) = (2.0, 100.0));
    assert_eq!(window(&perspective, DVec3::new(3.0, -6.0, -1.0)), Some(DVec2::new(1.0, -2.0)));
    let behind = DVec3::new(3.0, -6.0, 11.0);
    assert_eq!(window(&perspective, behind), Some(DVec2::new(-1.0, 2.0)), "what is behind C appears upside down");
    let parallel = plain(|p| p.projection = Projection::Parallel);
    assert_eq!(window(&parallel, behind), Some(DVec2::new(3.0, -6.0)));
}

#[test]
fn eq_5_11_to_5_13_perspective_matrix_off_axis() {
    // (5.11) prints 2n/(r − l) for 2F/(r − l).
    let expected =
        [[1.0, 0.0, 0.5, 0.0], [0.0, 4.0 / 3.0, -1.0 / 3.0, 0.0], [0.0, 0.0, -2.0, -6.0], [0.0, 0.0, -1.0, 0.0]];
    assert_eq!(rows(off_axis(Projection::Perspective).clip_from_view()), expected);
    let inverse =
        [[1.0, 0.0, 0.0, 0.5], [0.0, 0.75, 0.0, -0.25], [0.0, 0.0, 0.0, -1.0], [0.0, 0.0, -1.0 / 6.0, 1.0 / 3.0]];
    assert_eq!(rows(off_axis(Projection::Perspective).view_from_clip()), inverse);
}

#[test]
fn eq_5_14_perspective_matrix_symmetric() {
    let camera = plain(|p| (p.view_angle, p.aspect, p.near, p.far) = (90.0, 2.0, 0.5, 1.0));
    let expected = [[0.5, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, -3.0, -2.0], [0.0, 0.0, -1.0, 0.0]];
    assert_eq!(rows(camera.clip_from_view()), expected);
}

#[test]
fn eq_5_15_parallel_matrix_off_axis_with_its_last_row() {
    // The notes print 0 0 0 0 as the last row.
    let expected =
        [[0.5, 0.0, 0.0, -0.5], [0.0, 2.0 / 3.0, 0.0, 1.0 / 3.0], [0.0, 0.0, -0.5, -2.0], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(rows(off_axis(Projection::Parallel).clip_from_view()), expected);
    let inverse = [[2.0, 0.0, 0.0, 1.0], [0.0, 1.5, 0.0, -0.5], [0.0, 0.0, -2.0, -4.0], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(rows(off_axis(Projection::Parallel).view_from_clip()), inverse);
}

#[test]
fn eq_5_16_parallel_matrix_symmetric() {
    let camera = plain(|p| {
        (p.projection, p.height, p.aspect) = (Projection::Parallel, 4.0, 2.0);
        (p.near, p.far) = (1.0, 9.0);
    });
    let expected = [[0.25, 0.0, 0.0, 0.0], [0.0, 0.5, 0.0, 0.0], [0.0, 0.0, -0.25, -1.25], [0.0, 0.0, 0.0, 1.0]];
    assert_eq!(rows(camera.clip_from_view()), expected);
}

#[test]
fn corners_lie_on_the_near_and_on_the_far_plane() {
    // §5.3.2 says −F for the back face. It lies at −B, the depth at which (l, b) has grown to (B l / F, B b / F).
    let corners = off_axis(Projection::Perspective).volume_corners();
    assert_eq!(corners[0], DVec3::new(-1.0, -2.0, 3.0));
    assert_eq!(corners[2], DVec3::new(3.0, 1.0, 3.0));
    assert_eq!(corners[4], DVec3::new(-3.0, -6.0, -1.0));
    assert_eq!(corners[6], DVec3::new(9.0, 3.0, -1.0));
    let corners = off_axis(Projection::Parallel).volume_corners();
    assert_eq!(corners[1], DVec3::new(3.0, -2.0, 3.0));
    assert_eq!(corners[7], DVec3::new(-1.0, 1.0, -1.0));
}

#[test]
fn planes_hold_their_corners_and_face_inwards() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let camera = off_axis(projection);
        let corners = camera.volume_corners();
        let middle = corners.iter().sum::<DVec3>() / 8.0;
        let held = [[0, 3, 4, 7], [1, 2, 5, 6], [0, 1, 4, 5], [2, 3, 6, 7], [0, 1, 2, 3], [4, 5, 6, 7]];
        for (plane, held) in camera.volume_planes().iter().zip(held) {
            assert_close(plane.normal.length(), 1.0);
            assert!(plane.distance(middle) > 0.1);
            for corner in held {
                assert!(plane.distance(corners[corner]).abs() < 1e-14, "{plane:?} {corner}");
            }
        }
    }
}

#[test]
fn eq_5_17_to_5_19_perspective_ray_of_exercise_5_1() {
    let camera = camera(|p| (p.position, p.near) = (DVec3::new(3.0, 4.0, 0.0), 1.0));
    let ray = camera.ray_through_window(DVec2::ONE);
    assert_eq!(ray.origin, DVec3::new(3.0, 4.0, 0.0));
    // u + v − F n = (0, 0, −1) + (−4/5, 3/5, 0) − (3/5, 4/5, 0)
    assert_close3(ray.direction, DVec3::new(-1.4, -0.2, -1.0) / 3f64.sqrt());
}

#[test]
fn eq_5_20_and_5_21_parallel_ray_of_exercise_5_1() {
    let camera = camera(|p| (p.position, p.projection) = (DVec3::new(3.0, 4.0, 0.0), Projection::Parallel));
    let ray = camera.ray_through_window(DVec2::ONE);
    assert_close3(ray.origin, DVec3::new(2.2, 4.6, -1.0));
    assert_eq!(ray.direction, DVec3::new(-0.6, -0.8, 0.0));
}

/// The pixel of a window point, by the way of a world point on the window.
fn pixel(camera: &Camera, image: ImageSize, x: f64, y: f64) -> Option<DVec2> {
    let on_window = DVec3::new(x, y, 5.0 - camera.near());
    camera.stations(on_window, image, &Viewport::whole(image)).projected.map(|p| p.pixel)
}

#[test]
fn eq_5_22_window_to_image_and_the_borders() {
    let camera = plain(|p| (p.projection, p.height, p.aspect) = (Projection::Parallel, 2.0, 4.0 / 3.0));
    let image = ImageSize { width: 8, height: 6 };
    let at = |x, y| pixel(&camera, image, x, y);
    assert_eq!(at(0.0, 0.0), Some(DVec2::new(4.0, 3.0)));
    let w = camera.window();
    assert_eq!(at(w.left, w.top), Some(DVec2::ZERO), "left and upper border are inside");
    assert_eq!(at(w.right, w.bottom), Some(DVec2::new(8.0, 6.0)), "right and lower border are i = m, j = n");
    assert!(image.contains(DVec2::ZERO) && image.contains(DVec2::new(7.0, 5.0)));
    assert!(!image.contains(DVec2::new(8.0, 5.0)) && !image.contains(DVec2::new(7.0, 6.0)));
    assert!(!image.contains(DVec2::new(-1.0, 0.0)));
    // Whatever lies within one pixel of the window is that pixel.
    let size = camera.window_width() / 8.0;
    for (dx, dy) in [(0.0, 0.0), (0.5, 0.5), (0.999, 0.001), (0.001, 0.999)] {
        let point = image.window_from_image(&w, DVec2::new(2.0 + dx, 4.0 + dy));
        assert_eq!(at(point.x + 1e-9 * size, point.y - 1e-9 * size), Some(DVec2::new(2.0, 4.0)), "{dx} {dy}");
    }
}

#[test]
fn eq_5_22_with_an_asymmetric_window() {
    let camera = off_axis(Projection::Parallel);
    let image = ImageSize { width: 4, height: 3 };
    assert_eq!(pixel(&camera, image, -1.0, 1.0), Some(DVec2::ZERO));
    assert_eq!(pixel(&camera, image, 2.5, -1.5), Some(DVec2::new(3.0, 2.0)));
    assert_eq!(pixel(&camera, image, -1.5, 1.5), Some(DVec2::NEG_ONE));
    assert_eq!(image.image_from_window(&OFF_AXIS, DVec2::new(2.5, -1.5)), DVec2::new(3.5, 2.5));
}

#[test]
fn eq_5_23_image_to_window_and_pixel_centres() {
    let window = plain(|p| (p.view_angle, p.near, p.aspect) = (90.0, 3.0, 4.0 / 3.0)).window();
    let image = ImageSize { width: 8, height: 6 };
    let at = |i, j| image.window_from_image(&window, DVec2::new(i, j));
    assert_eq!(at(0.0, 0.0), DVec2::new(-4.0, 3.0), "whole numbers are upper left corners");
    assert_eq!(at(0.5, 0.5), DVec2::new(-3.5, 2.5), "halves are centres");
    assert_eq!(at(8.0, 6.0), DVec2::new(4.0, -3.0));
    assert_eq!(image.image_from_window(&window, DVec2::new(-3.5, 2.5)), DVec2::splat(0.5));
}

#[test]
fn rays_of_pixels_go_through_their_centres() {
    let camera = plain(|p| (p.view_angle, p.near, p.aspect) = (90.0, 3.0, 4.0 / 3.0));
    let image = ImageSize { width: 8, height: 6 };
    let ray = camera.ray_through_pixel(image, 0, 0);
    assert_close3(ray.direction, DVec3::new(-3.5, 2.5, -3.0) / 27.5f64.sqrt());
    let odd = camera.ray_through_pixel(ImageSize { width: 7, height: 5 }, 3, 2);
    assert_eq!(odd.direction, DVec3::NEG_Z, "the middle pixel of an odd image looks along DOP");
}

#[test]
fn eq_5_24_and_5_25_viewport_and_depth() {
    let camera = plain(|p| (p.projection, p.height, p.aspect) = (Projection::Parallel, 2.0, 1.0));
    let image = ImageSize::default();
    let viewport = Viewport { x: 10, y: -20, width: 100, height: 50, depth_near: 0.25, depth_far: 0.75 };
    let at = |viewport: &Viewport, x, y, z| {
        camera.stations(DVec3::new(x, y, z), image, viewport).projected.map(|p| p.viewport)
    };
    let (near, far) = (5.0 - camera.near(), 5.0 - camera.far());
    assert_eq!(at(&viewport, -1.0, -1.0, near), Some(DVec3::new(10.0, -20.0, 0.25)), "Y grows upwards");
    assert_eq!(at(&viewport, 1.0, 1.0, far), Some(DVec3::new(110.0, 30.0, 0.75)));
    assert_eq!(at(&viewport, 0.013, -0.03, (near + far) / 2.0), Some(DVec3::new(60.0, 4.0, 0.5)));
    let reversed = Viewport { depth_near: 1.0, depth_far: 0.0, ..viewport };
    assert_eq!(at(&reversed, 0.0, 0.0, far).map(|p| p.z), Some(0.0), "depth_near > depth_far is allowed");
    assert_eq!(
        Viewport::whole(image),
        Viewport { x: 0, y: 0, width: 1024, height: 768, depth_near: 0.0, depth_far: 1.0 }
    );
}

/// The exercise gives an angle for a parallel projection, but no distance at which it spans the window: here it is D.
fn exercise_5_2(projection: Projection) -> Camera {
    let perspective = camera(|p| {
        p.position = DVec3::new(7.0, 0.0, 0.0);
        p.focal_point = DVec3::ONE;
        p.view_up = DVec3::X;
        (p.view_angle, p.aspect, p.near) = (90.0, 0.75, 1.0);
    });
    match perspective.with_projection(projection) {
        Ok(camera) => camera,
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn exercise_5_2_a_and_b_zoomed_window_and_pixel() {
    let camera = exercise_5_2(Projection::Parallel);
    assert_close(camera.window_height(), 2.0 * 38f64.sqrt());
    let zoomed = crate::common::camera::apply(&camera, "zoom=3");
    assert_close(zoomed.window_height(), 2.0 * 38f64.sqrt() / 3.0);
    let root = 38f64.sqrt();
    let (u, v, n) = (
        DVec3::new(0.0, 1.0, -1.0) / 2f64.sqrt(),
        DVec3::new(1.0, 3.0, 3.0) / 19f64.sqrt(),
        DVec3::new(6.0, -1.0, -1.0) / root,
    );
    let corner = DVec3::new(7.0, 0.0, 0.0) + u * (root / 4.0) + v * (root / 3.0) - n;
    assert_close3(zoomed.volume_corners()[2], corner);
    let image = ImageSize { width: 1024, height: 768 };
    let p_world = DVec3::new(7.0, 0.0, 0.0) + u + v;
    let pixel = zoomed.stations(p_world, image, &Viewport::whole(image)).projected.map(|p| p.pixel);
    assert_eq!(pixel, Some(DVec2::new(844.0, 197.0)), "1024/W + 512 = 844.2…, 384 − 768/H = 197.1…");
}

#[test]
fn exercise_5_2_d_elevation() {
    let camera = exercise_5_2(Projection::Parallel);
    let (before, after) = (camera.basis(), crate::common::camera::apply(&camera, "elevation=45").basis());
    assert_eq!(after.u, before.u);
    assert_close3(after.v, (before.v + before.n) / 2f64.sqrt());
    assert_close3(after.n, (before.n - before.v) / 2f64.sqrt());
}

#[test]
fn exercise_5_3_the_view_volume_is_the_ndc_cube() {
    let camera = camera(|p| {
        p.position = DVec3::new(0.0, 0.0, 2.0);
        (p.projection, p.height, p.aspect) = (Projection::Parallel, 2.0, 1.0);
        (p.near, p.far) = (1.0, 3.0);
    });
    // NDC is left-handed, the world is not: z changes its sign.
    assert_eq!(camera.clip_from_world(), DMat4::from_diagonal(DVec4::new(1.0, 1.0, -1.0, 1.0)));
    assert_eq!(camera.volume_corners()[0], DVec3::new(-1.0, -1.0, 1.0));
    assert_eq!(camera.volume_corners()[6], DVec3::new(1.0, 1.0, -1.0));
    let image = ImageSize::default();
    assert!(camera.stations(DVec3::ONE, image, &Viewport::whole(image)).inside, "the border is inside");
}

#[test]
fn pyramid_of_the_exercises_on_spaces() {
    // [1] Exercises II and III, with D = 15 and M = 8: base 8 × 8, height 15, eye in (0, 0, 8).
    let camera = camera(|p| {
        p.position = DVec3::new(0.0, 0.0, 8.0);
        (p.view_angle, p.aspect, p.near, p.far) = (90.0, 1.0, 0.15, 150.0);
    });
    let image = ImageSize::default();
    let at = |x, y, z| camera.stations(DVec3::new(x, y, z), image, &Viewport::whole(image));
    let apex = at(4.0, 15.0, 4.0);
    assert_eq!(apex.view, DVec3::new(4.0, 15.0, -4.0));
    let depth = (150.15 * 4.0 - 45.0) / 149.85;
    assert_close(apex.clip.z, depth);
    assert_close3(apex.projected.map_or(DVec3::NAN, |p| p.ndc), DVec3::new(1.0, 3.75, depth / 4.0));
    assert!(!apex.inside);
    // Two corners of the base stand beside and in the eye: W = 0, and nothing follows.
    for corner in [at(8.0, 0.0, 8.0), at(0.0, 0.0, 8.0)] {
        assert_eq!((corner.clip.w, corner.projected, corner.inside), (0.0, None, false));
    }
}

#[test]
fn the_table_of_equations_names_existing_tests() {
    let mut open: Vec<PathBuf> = ["crates", "tests/it"].map(|path| Path::new(ROOT).join(path)).into();
    let mut sources = String::new();
    while let Some(path) = open.pop() {
        if path.is_dir() {
            open.extend(std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            sources += &std::fs::read_to_string(path).unwrap();
        }
    }
    let table = std::fs::read_to_string(Path::new(ROOT).join("docs/equations.md")).unwrap();
    let mut names = 0;
    for word in table.split('`').skip(1).step_by(2) {
        let name = word.rsplit("::").next().unwrap_or(word).trim_end_matches('…');
        let is_function =
            name.contains('_') && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        if is_function {
            names += 1;
            assert!(sources.contains(&format!("fn {name}")), "docs/equations.md: {word}");
        }
    }
    assert!(names > 60, "{names}");
    for number in 1..=25 {
        assert!(table.contains(&format!("(5.{number})")), "(5.{number}) is missing");
    }
}
