//! Properties of every camera, tried on cameras that are made to break it, with glam's cameras as a second opinion.

use camera_lab_engine::camera::{Camera, Convention, ImageSize, Operation, Parameters, Projection, Viewport};
use camera_lab_engine::geometry::Angle;
use glam::{DMat4, DVec2, DVec3, dcamera};
use proptest::prelude::*;

use crate::common::any_camera::{any_camera, any_vector, plain_camera};

fn any_operation() -> BoxedStrategy<Operation> {
    let angle = prop_oneof![
        4 => -720.0..720.0,
        1 => prop::sample::select(vec![-90.0, 30.0, 45.0, 90.0, 180.0, 360.0]),
        1 => (-12.0..-3.0).prop_map(|k| 10f64.powf(k)),
    ]
    .prop_map(Angle::from_degrees);
    (angle, 0.1..10.0, -3.0..3.0, -3.0..3.0, 0..8)
        .prop_map(|(angle, factor, dx, dy, which)| match which {
            0 => Operation::Elevation(angle),
            1 => Operation::Azimuth(angle),
            2 => Operation::Roll(angle),
            3 => Operation::Yaw(angle),
            4 => Operation::Pitch(angle),
            5 => Operation::Zoom(factor),
            6 => Operation::Dolly(factor),
            _ => Operation::Pan { dx, dy },
        })
        .boxed()
}

/// The greatest entry, as a size against which errors are measured.
fn size(m: &DMat4) -> f64 {
    m.to_cols_array().into_iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}

const IMAGE: ImageSize = ImageSize { width: 640, height: 480 };

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_basis_is_orthonormal_and_right_handed(camera in any_camera()) {
        let basis = camera.basis();
        let rows = [basis.u, basis.v, basis.n];
        for (i, a) in rows.iter().enumerate() {
            for (j, b) in rows.iter().enumerate() {
                let expected = if i == j { 1.0 } else { 0.0 };
                prop_assert!((a.dot(*b) - expected).abs() <= 4.0 * f64::EPSILON, "{i} {j}: {}", a.dot(*b));
            }
        }
        prop_assert!(basis.u.cross(basis.v).dot(basis.n) > 0.999_999);
        let up = camera::unit(camera.view_up());
        prop_assert!(basis.v.dot(up) > 0.0, "VUP is above the horizon: {}", basis.v.dot(up));
        prop_assert!(basis.u.dot(up).abs() <= 4.0 * f64::EPSILON);
    }

    #[test]
    fn the_view_matrix_is_inverted(camera in any_camera()) {
        let product = camera.view_from_world() * camera.world_from_view();
        let scale = camera.position().abs().max_element().max(1.0);
        for (x, e) in product.to_cols_array().into_iter().zip(DMat4::IDENTITY.to_cols_array()) {
            prop_assert!((x - e).abs() <= 16.0 * f64::EPSILON * scale, "{product}");
        }
    }

    #[test]
    fn the_projection_matrix_is_inverted(camera in any_camera()) {
        let (m, inverse) = (camera.clip_from_view(), camera.view_from_clip());
        for i in 0..4 {
            for j in 0..4 {
                let terms = m.row(i) * inverse.col(j);
                let (x, scale) = (terms.element_sum(), terms.abs().element_sum().max(1.0));
                let expected = if i == j { 1.0 } else { 0.0 };
                prop_assert!((x - expected).abs() <= 8.0 * f64::EPSILON * scale, "{i} {j}: {x}");
            }
        }
    }

    #[test]
    fn the_product_is_that_of_the_factors(camera in any_camera()) {
        let (view, clip) = (camera.view_from_world(), camera.clip_from_view());
        let product = camera.clip_from_world();
        for i in 0..4 {
            for j in 0..4 {
                let terms = clip.row(i) * view.col(j);
                let error = (product.row(i)[j] - terms.element_sum()).abs();
                // Factors are rounded, −u · c among them: its error is that of ‖c‖.
                let scale = terms.abs().element_sum() + clip.row(i).abs().element_sum() * camera.position().length();
                prop_assert!(error <= 8.0 * f64::EPSILON * scale, "{i} {j}: {error:e} {scale:e}");
            }
        }
    }

    #[test]
    fn corners_of_the_volume_are_corners_of_the_cube(camera in plain_camera()) {
        for (i, corner) in camera.volume_corners().into_iter().enumerate() {
            let s = camera.stations(corner, IMAGE, &Viewport::whole(IMAGE));
            let x = if matches!(i % 4, 0 | 3) { -1.0 } else { 1.0 };
            let y = if i % 4 < 2 { -1.0 } else { 1.0 };
            let z = if i < 4 { -1.0 } else { 1.0 };
            let ndc = s.projected.map(|p| p.ndc).unwrap_or(DVec3::NAN);
            // A corner is rounded at its own place, and the window may be a hundredth of that.
            let tolerance = 1e-10;
            prop_assert!((ndc - DVec3::new(x, y, z)).abs().max_element() < tolerance, "{i}: {ndc}");
        }
    }

    #[test]
    fn inside_agrees_with_the_clip_coordinates(camera in any_camera(), p in any_vector(12.0), t in -0.5..1.5, along in 0usize..8) {
        let corners = camera.volume_corners();
        for point in [p, camera.position() + p, corners[along], corners[along].lerp(corners[(along + 3) % 8], t)] {
            if !point.is_finite() {
                continue;
            }
            let s = camera.stations(point, IMAGE, &Viewport::whole(IMAGE));
            let c = s.clip;
            let inside = c.w > 0.0 && c.x.abs() <= c.w && c.y.abs() <= c.w && c.z.abs() <= c.w;
            prop_assert_eq!(s.inside, inside);
            prop_assert_eq!(s.projected.is_none(), c.w == 0.0);
            if let Some(p) = s.projected && inside {
                prop_assert!(p.ndc.abs().max_element() <= 1.0 + f64::EPSILON);
                // A point may round to the border from without.
                prop_assert!(p.viewport.z >= -f64::EPSILON && p.viewport.z <= 1.0);
            }
        }
    }

    #[test]
    fn planes_agree_with_the_clip_coordinates(camera in plain_camera(), p in any_vector(1.0)) {
        let s = camera.stations(p, IMAGE, &Viewport::whole(IMAGE));
        let distances = camera.volume_planes().map(|plane| plane.distance(p));
        if distances.iter().all(|d| d.abs() > 1e-9) {
            let expected = distances.iter().all(|d| *d > 0.0);
            prop_assert_eq!(s.inside, expected, "{:?} {}", distances, s.clip);
        }
    }

    #[test]
    fn points_on_the_plane_of_the_eye_have_no_picture(camera in any_camera(), x in -9i32..9, y in -9i32..9) {
        // Exactly: C itself, and for a camera along an axis whatever stands beside it.
        let at = |point| camera.stations(point, IMAGE, &Viewport::whole(IMAGE));
        let perspective = camera.projection() == Projection::Perspective;
        prop_assert_eq!(at(camera.position()).projected.is_none(), perspective);
        let p = Parameters { position: DVec3::new(0.1, 0.7, 1e9), focal_point: DVec3::new(0.1, 0.7, 0.3), ..*camera.parameters() };
        if let Ok(camera) = Camera::new(&p) {
            let beside = DVec3::new(0.1 + f64::from(x), 0.7 + f64::from(y), 1e9);
            let s = camera.stations(beside, IMAGE, &Viewport::whole(IMAGE));
            prop_assert_eq!((s.view.z, s.projected.is_none()), (0.0, perspective));
        }
    }

    #[test]
    fn rays_pass_through_the_centres_of_their_pixels(camera in plain_camera(), i in 0i64..640, j in 0i64..480, depth in 0.5..20.0) {
        let ray = camera.ray_through_pixel(IMAGE, i, j);
        prop_assert!((ray.direction.length() - 1.0).abs() <= 4.0 * f64::EPSILON);
        let s = camera.stations(ray.origin + ray.direction * depth, IMAGE, &Viewport::whole(IMAGE));
        let Some(p) = s.projected else { return Err(TestCaseError::fail("no picture")) };
        let image = IMAGE.image_from_window(&camera.window(), p.window);
        let expected = DVec2::new(pixel(i) + 0.5, pixel(j) + 0.5);
        prop_assert!((image - expected).abs().max_element() < 1e-6, "{image} {expected}");
        prop_assert_eq!(p.pixel, DVec2::new(pixel(i), pixel(j)));
        let window = camera.ray_through_window(IMAGE.window_from_image(&camera.window(), expected));
        prop_assert!((window.direction - ray.direction).abs().max_element() < 1e-12);
    }

    #[test]
    fn fast_and_exact_points_agree(camera in any_camera(), offset in any_vector(3.0)) {
        let point = camera.position() + offset;
        let exact = camera.stations(point, IMAGE, &Viewport::whole(IMAGE));
        let d = (point - camera.position()).length();
        prop_assert!((camera.view_point(point) - exact.view).abs().max_element() <= 4.0 * f64::EPSILON * d);
    }

    #[test]
    fn operations_are_rigid_and_can_be_undone(camera in any_camera(), operation in any_operation()) {
        let Ok(after) = operation.apply(&camera, Convention::RightHand) else { return Ok(()) };
        let inverse = match operation {
            Operation::Elevation(a) => Operation::Elevation(-a),
            Operation::Azimuth(a) => Operation::Azimuth(-a),
            Operation::Roll(a) => Operation::Roll(-a),
            Operation::Yaw(a) => Operation::Yaw(-a),
            Operation::Pitch(a) => Operation::Pitch(-a),
            Operation::Zoom(f) => Operation::Zoom(1.0 / f),
            Operation::Dolly(f) => Operation::Dolly(1.0 / f),
            Operation::Pan { dx, dy } => Operation::Pan { dx: -dx, dy: -dy },
        };
        let basis = after.basis();
        prop_assert!(basis.u.dot(basis.v).abs() <= 4.0 * f64::EPSILON);
        if !matches!(operation, Operation::Dolly(_)) {
            prop_assert_eq!(after.distance(), camera.distance());
        }
        let (up, before_up) = (camera::length(after.view_up()), camera::length(camera.view_up()));
        prop_assert!((up / before_up - 1.0).abs() <= 4.0 * f64::EPSILON, "VUP keeps its length");
        let Ok(back) = inverse.apply(&after, Convention::RightHand) else { return Ok(()) };
        for (a, b) in [(back.basis().u, camera.basis().u), (back.basis().v, camera.basis().v), (back.basis().n, camera.basis().n)] {
            prop_assert!(camera::same(a, b, 1.0), "{a} {b}");
        }
        if matches!(operation, Operation::Zoom(_) | Operation::Dolly(_)) {
            // 1 / factor is rounded.
            prop_assert!((back.distance() / camera.distance() - 1.0).abs() <= 2.0 * f64::EPSILON);
            prop_assert!((back.window_height() / camera.window_height() - 1.0).abs() <= 2.0 * f64::EPSILON);
        } else {
            let size = camera.position().abs().max(camera.focal_point().abs()).max_element().max(3.0);
            prop_assert!(camera::same(back.position(), camera.position(), size));
            prop_assert!(camera::same(back.focal_point(), camera.focal_point(), size));
            prop_assert!(camera::same(back.view_up(), camera.view_up(), camera.view_up().abs().max_element()));
        }
    }

    #[test]
    fn a_result_can_be_saved_and_read(camera in plain_camera(), operations in prop::collection::vec(any_operation(), 1..8)) {
        let after = operations.iter().try_fold(camera, |camera, operation| operation.apply(&camera, Convention::Vtk));
        let Ok(after) = after else { return Ok(()) };
        let read = Camera::new(after.parameters());
        prop_assert!(read.is_ok(), "{read:?}");
        if let Ok(read) = read {
            let scale = (after.position().length() / after.distance()).max(1.0) * 1e3;
            prop_assert!((read.basis().n - after.basis().n).length() <= scale * f64::EPSILON);
            let wide = 1.0 / (180.0 - after.view_angle().degrees());
            let error = (read.window_height() / after.window_height() - 1.0).abs();
            // Of a given window the sides are rounded, not H.
            let w = after.window();
            let sides = (w.bottom.abs() + w.top.abs()) / after.window_height();
            prop_assert!(error <= (4.0 + 180.0 * wide) * 4.0 * f64::EPSILON * sides, "{error:e}");
        }
    }

    #[test]
    fn glam_has_the_same_matrices(camera in plain_camera()) {
        let view = dcamera::rh::view::look_at_mat4(camera.position(), camera.focal_point(), camera.view_up());
        // The textbook formulas lose the digits that the angle between VUP and DOP and the distance from the origin
        // cost.
        let tolerance = 1e-11 * size(&view);
        for (a, b) in view.to_cols_array().into_iter().zip(camera.view_from_world().to_cols_array()) {
            prop_assert!((a - b).abs() <= tolerance, "{view} {}", camera.view_from_world());
        }
        let (w, near, far) = (camera.window(), camera.near(), camera.far());
        let clip = match camera.projection() {
            Projection::Perspective => dcamera::rh::proj::opengl::frustum(w.left, w.right, w.bottom, w.top, near, far),
            Projection::Parallel => dcamera::rh::proj::opengl::orthographic(w.left, w.right, w.bottom, w.top, near, far),
        };
        for (a, b) in clip.to_cols_array().into_iter().zip(camera.clip_from_view().to_cols_array()) {
            prop_assert!((a - b).abs() <= 1e-12 * size(&clip), "{clip} {}", camera.clip_from_view());
        }
    }
}

/// A pixel's number.
fn pixel(i: i64) -> f64 {
    f64::from(u16::try_from(i).unwrap_or(u16::MAX))
}

mod camera {
    use glam::DVec3;

    pub(super) fn unit(v: DVec3) -> DVec3 {
        camera_lab_engine::geometry::try_unit(v).unwrap_or(DVec3::NAN)
    }

    /// The same numbers, except for digits beyond 106 bits of the greatest of their terms.
    pub(super) fn same(a: DVec3, b: DVec3, size: f64) -> bool {
        (a - b).abs().max_element() <= size * 1e-28
    }

    pub(super) fn length(v: DVec3) -> f64 {
        v.dot(unit(v))
    }
}
