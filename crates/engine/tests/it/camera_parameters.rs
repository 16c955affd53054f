//! Parameters that are a camera, and the errors and warnings of those that are not, or hardly.

use camera_lab_engine::camera::{
    Camera, CameraError, Derived, ImageSize, ParameterKey, Parameters, Projection, Range, ViewWindow, Warning,
};
use glam::DVec3;

use crate::common::camera::camera;

fn error(change: impl FnOnce(&mut Parameters)) -> CameraError {
    let mut parameters = Parameters::default();
    change(&mut parameters);
    match Camera::new(&parameters) {
        Ok(_) => panic!("a camera: {parameters:?}"),
        Err(error) => error,
    }
}

#[test]
fn every_number_has_its_range() {
    type Number = fn(&mut Parameters) -> &mut f64;
    type Vector = fn(&mut Parameters) -> &mut DVec3;
    let numbers: [(&str, Number, Range); 5] = [
        ("view_angle", |p| &mut p.view_angle, Range::HalfTurn),
        ("height", |p| &mut p.height, Range::Positive),
        ("aspect", |p| &mut p.aspect, Range::Positive),
        ("near", |p| &mut p.near, Range::Positive),
        ("far", |p| &mut p.far, Range::Positive),
    ];
    for (key, field, allowed) in numbers {
        for value in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let found = error(|p| *field(p) = value);
            assert!(
                matches!(&found, CameraError::OutOfRange { key: k, value: v, allowed: a }
                    if k.name() == key && v.to_bits() == value.to_bits() && *a == allowed),
                "{key} = {value}: {found:?}"
            );
            assert_eq!(found.parameters().iter().map(|key| key.name()).collect::<Vec<_>>(), [key]);
            assert!(found.to_string().contains(key) && found.to_string().contains("greater than 0"), "{found}");
        }
    }
    for value in [180.0, 180.0000001, 360.0] {
        assert!(error(|p| p.view_angle = value).to_string().contains("180"));
    }
    assert!(error(|p| p.view_angle = 360.0).to_string().contains("360.0"), "the message says what was found");
    camera(|p| p.view_angle = 180f64.next_down());
    let vectors: [(&str, Vector); 3] =
        [("position", |p| &mut p.position), ("focal_point", |p| &mut p.focal_point), ("view_up", |p| &mut p.view_up)];
    for (key, field) in vectors {
        for value in [f64::NAN, f64::INFINITY] {
            for axis in 0..3 {
                assert_eq!(
                    error(|p| field(p)[axis] = value).parameters().iter().map(|key| key.name()).collect::<Vec<_>>(),
                    [key]
                );
            }
        }
    }
}

#[test]
fn near_lies_before_far() {
    for (near, far) in [(10.0, 1.0), (1.0, 1.0)] {
        let found = error(|p| (p.near, p.far) = (near, far));
        assert_eq!(found, CameraError::FarNotBeyondNear { near, far });
        assert_eq!(found.parameters(), [ParameterKey::Far, ParameterKey::Near]);
    }
    camera(|p| (p.near, p.far) = (1.0, 1f64.next_up()));
}

#[test]
fn the_window_has_a_size() {
    let window = |left, right, bottom, top| Some(ViewWindow { left, right, bottom, top });
    for (given, expected) in [
        (window(1.0, 1.0, 0.0, 1.0), CameraError::WindowWidth { left: 1.0, right: 1.0 }),
        (window(2.0, 1.0, 0.0, 1.0), CameraError::WindowWidth { left: 2.0, right: 1.0 }),
        (window(0.0, 1.0, 1.0, 1.0), CameraError::WindowHeight { bottom: 1.0, top: 1.0 }),
        (window(0.0, 1.0, 1.0, -1.0), CameraError::WindowHeight { bottom: 1.0, top: -1.0 }),
    ] {
        let found = error(|p| p.window = given);
        assert_eq!((&found, found.parameters()), (&expected, &[ParameterKey::Window][..]));
    }
    for given in [window(f64::NAN, 1.0, 0.0, 1.0), window(0.0, f64::INFINITY, 0.0, 1.0)] {
        assert_eq!(error(|p| p.window = given).parameters(), [ParameterKey::Window]);
    }
    camera(|p| p.window = window(5.0, 6.0, -3.0, -2.5));
}

#[test]
fn position_and_focal_point_differ() {
    let found = error(|p| p.focal_point = p.position);
    assert_eq!(found, CameraError::FocalPointAtPosition);
    assert_eq!(found.parameters(), [ParameterKey::FocalPoint, ParameterKey::Position]);
    let tiny = camera(|p| (p.position, p.focal_point) = (DVec3::X * 5e-324, DVec3::ZERO));
    assert_eq!((tiny.distance(), tiny.basis().n), (5e-324, DVec3::X));
}

#[test]
fn view_up_is_not_zero() {
    assert_eq!(error(|p| p.view_up = DVec3::ZERO), CameraError::ViewUpZero);
    let tiny = camera(|p| (p.position, p.view_up) = (DVec3::Z, DVec3::Y * 5e-324));
    assert_eq!(tiny.basis().v, DVec3::Y);
}

#[test]
fn view_up_along_the_direction_is_an_error_whatever_its_size() {
    for direction in [
        DVec3::new(3.0, 4.0, 5.0),
        DVec3::new(0.1, 0.2, 0.3),
        DVec3::new(1.0 / 3.0, -0.7, 1e-3),
        DVec3::new(0.1, 1e-9, -7e12),
        DVec3::new(0.1, 1e-100, 0.7e-120),
    ] {
        for factor in [1.0, -1.0, 3.0, -0.1, 1e150, 1e-150, 7e-310] {
            for focal_point in [DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0)] {
                let position = focal_point + direction;
                // Rounded, so that it is hardly ever collinear to the last bit.
                let view_up = (position - focal_point) * factor;
                if view_up.abs().min_element() < f64::MIN_POSITIVE {
                    continue; // Too small to keep its direction.
                }
                let found = error(|p| (p.position, p.focal_point, p.view_up) = (position, focal_point, view_up));
                assert_eq!(found, CameraError::ViewUpCollinear, "{direction} {factor} {focal_point}");
                assert_eq!(found.parameters()[0], ParameterKey::ViewUp);
            }
        }
    }
    // Typed by hand: collinear as decimals, not quite as binary numbers.
    let found = error(|p| {
        p.position = DVec3::new(0.1, 0.2, 0.3);
        p.view_up = DVec3::new(0.3, 0.6, 0.9);
    });
    assert_eq!(found, CameraError::ViewUpCollinear);
}

#[test]
fn a_small_angle_between_view_up_and_direction_is_not_an_error() {
    // VUP = w + ε s with s ⟂ w: u must be s × w / ‖s × w‖, to the last digit.
    for w in [DVec3::new(0.0, 0.0, 1.0), DVec3::new(1.0, 2.0, 2.0), DVec3::new(3.0, -4.0, 12.0)] {
        let side = w.any_orthogonal_vector();
        for angle in [1e-3, 1e-6, 1e-10, 1e-12] {
            let view_up = w + side * angle;
            let camera = camera(|p| (p.position, p.focal_point, p.view_up) = (w, DVec3::ZERO, view_up));
            let basis = camera.basis();
            assert!(basis.u.dot(side.cross(w)) > 0.0, "{w} {angle}");
            let worst = [
                basis.u.dot(basis.v),
                basis.u.dot(basis.n),
                basis.v.dot(basis.n),
                basis.u.length() - 1.0,
                basis.v.length() - 1.0,
            ]
            .into_iter()
            .fold(0.0, |worst: f64, x| worst.max(x.abs()));
            assert!(worst <= 4.0 * f64::EPSILON, "{w} {angle}: {worst:e}");
        }
    }
    let camera = camera(|p| (p.position, p.view_up) = (DVec3::Y, DVec3::new(1e-17, 1.0, 0.0)));
    assert_eq!(camera.basis().u, DVec3::Z, "nothing of this angle is rounding");
}

#[test]
fn numbers_that_overflow_are_errors() {
    let huge = 1e308;
    let sideways = |p: &mut Parameters| {
        (p.position, p.focal_point) = (DVec3::new(1e160, 0.0, 1e160), DVec3::Z * 1e160);
        p.view_angle = 1e-160;
    };
    for (found, expected) in [
        (error(|p| (p.position, p.focal_point) = (DVec3::X * huge, DVec3::X * -huge)), Derived::Distance),
        (error(|p| p.position = DVec3::splat(1.5e308)), Derived::Distance),
        (error(|p| (p.projection, p.height, p.aspect) = (Projection::Parallel, huge, 10.0)), Derived::Window),
        // Its borders are numbers, its width is not.
        (error(|p| p.window = Some(ViewWindow { left: -huge, right: huge, bottom: -1.0, top: 1.0 })), Derived::Window),
        (error(|p| (p.projection, p.height, p.aspect) = (Projection::Parallel, 1e-308, 1e-30)), Derived::Window),
        (error(|p| p.aspect = 1e-320), Derived::ProjectionMatrix),
        (error(|p| (p.near, p.far) = (1e-320, 1.0)), Derived::ProjectionMatrix),
        (error(|p| p.view_angle = 1e-307), Derived::ProjectionMatrix),
        (error(sideways), Derived::ViewProjectionMatrix),
        (error(|p| (p.far, p.view_angle) = (huge, 179.0)), Derived::VolumeCorners),
    ] {
        let CameraError::Overflow { quantity, keys } = &found else { panic!("{found:?}") };
        assert_eq!(*quantity, expected);
        assert!(!keys.is_empty() && keys.iter().all(|key| found.to_string().contains(key.name())), "{found}");
        assert!(found.to_string().starts_with(&format!("{quantity} would")) && !quantity.to_string().is_empty());
    }
}

#[test]
fn an_overflow_names_the_numbers_that_the_projection_uses() {
    let keys = |found: CameraError| match found {
        CameraError::Overflow { keys, .. } => keys.iter().map(|key| key.name()).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    assert_eq!(
        keys(error(|p| (p.view_angle, p.near, p.far) = (179.999, 1e307, 1e308))),
        ["view_angle", "aspect", "near"]
    );
    let parallel = |p: &mut Parameters| (p.projection, p.height, p.aspect) = (Projection::Parallel, 1e308, 10.0);
    assert_eq!(keys(error(parallel)), ["height", "aspect"]);
    let window = ViewWindow { left: -1e308, right: 1e308, bottom: -1.0, top: 1.0 };
    assert_eq!(keys(error(|p| p.window = Some(window))), ["window"]);
}

#[test]
fn ordinary_cameras_have_no_warnings() {
    let camera = camera(|_| ());
    assert_eq!(camera.warnings(), []);
    assert_eq!(camera.aspect_warning(ImageSize::default()), None);
    for (width, height) in [(640, 480), (800, 600), (1023, 767), (4, 3)] {
        assert_eq!(camera.aspect_warning(ImageSize { width, height }), None, "less than a pixel");
    }
}

#[test]
fn warnings_name_probable_mistakes() {
    let codes =
        |change: fn(&mut Parameters)| -> Vec<&str> { camera(change).warnings().iter().map(Warning::code).collect() };
    assert_eq!(codes(|p| p.view_up = p.position + DVec3::X * 1e-10), ["view-up-nearly-collinear"]);
    assert_eq!(codes(|p| p.near = 1e-6), ["depth-precision"]);
    assert_eq!(codes(|p| (p.near, p.projection) = (1e-6, Projection::Parallel)), [""; 0]);
    assert_eq!(codes(|p| p.view_angle = 150.0), ["wide-angle"]);
    assert_eq!(codes(|p| p.near = 8.0), ["focal-point-clipped"]);
    assert_eq!(codes(|p| p.far = 7.0), ["focal-point-clipped"]);
    assert_eq!(
        codes(|p| (p.position, p.focal_point) = (DVec3::new(1e12, 3.0, 4.0), DVec3::new(1e12, 0.0, 0.0))),
        ["far-from-origin"]
    );
    let square = camera(|_| ()).aspect_warning(ImageSize { width: 100, height: 100 });
    assert_eq!(square.as_ref().map(Warning::code), Some("aspect-mismatch"));
    for warning in camera(|p| (p.near, p.view_angle) = (1e-6, 150.0)).warnings() {
        let text = warning.to_string();
        assert!(text.len() > 40 && !text.contains("NaN") && !text.contains("inf"), "{text}");
    }
}

#[test]
fn warnings_begin_where_they_say() {
    let codes = |change: fn(&mut Parameters)| -> Vec<&str> {
        let camera = camera(|p| {
            (p.position, p.focal_point) = (DVec3::Z * 5.0, DVec3::ZERO);
            change(p);
        });
        camera.warnings().iter().map(Warning::code).collect()
    };
    // PF on a plane of the volume is seen.
    assert_eq!(codes(|p| (p.near, p.far) = (5.0, 6.0)), [""; 0]);
    assert_eq!(codes(|p| (p.near, p.far) = (1.0, 5.0)), [""; 0]);
    assert_eq!(codes(|p| p.view_angle = 120.0), [""; 0]);
    assert_eq!(codes(|p| p.view_angle = 120.001), ["wide-angle"]);
    // A step at B is B (B − F) / F 2⁻²⁴: a hundredth of B if (B − F) / F = 167772.16.
    assert_eq!(codes(|p| (p.near, p.far) = (1.0, 167_772.9)), [""; 0]);
    assert_eq!(codes(|p| (p.near, p.far) = (1.0, 167_773.5)), ["depth-precision"]);
    let away = |p: &mut Parameters, x: f64| (p.position, p.focal_point) = (DVec3::new(x, 0.0, 2.0), DVec3::X * x);
    let far_away = camera(|p| away(p, 2e9)).warnings();
    assert_eq!(
        far_away.first(),
        Some(&Warning::FarFromOrigin { ratio: 1e9, digits: 6 }),
        "1e-6 of the distance is left"
    );
    assert_eq!(camera(|p| away(p, 2e7)).warnings(), []);
}

#[test]
fn the_step_of_a_coarse_depth_is_that_at_the_back_plane() {
    let warnings = camera(|p| (p.near, p.far) = (1e-6, 16.0)).warnings();
    let [Warning::DepthPrecision { ratio, step }] = warnings[..] else { panic!("{warnings:?}") };
    assert_eq!(ratio, 1.6e7);
    // B (B − F) / F 2⁻²⁴
    let expected = 16.0 * (16.0 - 1e-6) / 1e-6 / 16_777_216.0;
    assert!((step - expected).abs() < 1e-12 * expected, "{step} for {expected}");
}

#[test]
fn less_than_a_pixel_of_stretching_one_way_or_the_other_is_none() {
    let warns = |aspect: f64, width: u32, height: u32| {
        camera(|p| p.aspect = aspect).aspect_warning(ImageSize { width, height }).is_some()
    };
    assert!(!warns(2.0, 201, 100), "a pixel of width, half a pixel of height");
    assert!(!warns(0.5, 50, 101), "half a pixel of width, a pixel of height");
    assert!(warns(2.0, 202, 100) && warns(2.0, 198, 100) && warns(0.5, 50, 102));
}
