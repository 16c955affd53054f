//! A matrix → its camera: the result has the matrix again, in every convention, and a matrix of no camera is refused
//! with the reason.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{
    Camera, MatrixKind, Ndc, Parameters, Projection, Reading, Recovered, RecoveryError, Unknown, ViewWindow,
};
use glam::{DMat4, DVec3, DVec4};
use proptest::prelude::*;

use crate::common::any_camera::plain_camera;
use crate::common::camera::camera;

/// The camera of a matrix in the axes of [0].
fn recover(kind: MatrixKind, m: DMat4, ndc: Ndc, current: &Parameters) -> Result<Recovered, RecoveryError> {
    camera_lab_engine::camera::recover(&Reading { ndc: ndc.into(), ..Reading::of(kind) }, m, current)
}

fn assert_same(found: DMat4, expected: DMat4, slack: f64, what: &str) {
    let size = expected.to_cols_array().iter().fold(1e-300_f64, |size, x| size.max(x.abs()));
    assert!(found.abs_diff_eq(expected, slack * size), "{what}: {found}\nis not {expected}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_camera_of_a_matrix_has_that_matrix(camera in plain_camera(), factor in 0.1..10.0) {
        let other = Parameters { position: DVec3::new(1.0, 2.0, 3.0), near: camera.near(), ..Parameters::default() };
        for ndc in Ndc::ALL {
            let Ok(space) = camera.clip_space(ndc) else { continue };
            // Homogeneous: any factor gives the same picture.
            let whole = space.clip_from_world() * factor;
            let found = recover(MatrixKind::ViewProjection, whole, ndc, &other).unwrap();
            let again = Camera::new(&found.parameters).unwrap();
            assert_same(again.clip_space(ndc).unwrap().clip_from_world(), space.clip_from_world(), 1e-7, ndc.name());
            let lens = recover(MatrixKind::Projection, space.clip_from_view() * factor, ndc, camera.parameters()).unwrap();
            let again = Camera::new(&lens.parameters).unwrap();
            assert_same(again.clip_space(ndc).unwrap().clip_from_view(), space.clip_from_view(), 1e-7, ndc.name());
        }
        let view = recover(MatrixKind::View, camera.view_from_world(), Ndc::default(), &other).unwrap();
        let again = Camera::new(&view.parameters).unwrap();
        assert_same(again.view_from_world(), camera.view_from_world(), 1e-12, "view");
    }

    #[test]
    fn a_matrix_copied_with_four_digits_still_has_a_camera(camera in plain_camera()) {
        let rounded = |m: DMat4| DMat4::from_cols_array(&m.to_cols_array().map(|x| format!("{x:.4}").parse().unwrap()));
        let view = rounded(camera.view_from_world());
        let found = recover(MatrixKind::View, view, Ndc::default(), &Parameters::default()).unwrap();
        let again = Camera::new(&found.parameters).unwrap().view_from_world();
        prop_assert!(again.abs_diff_eq(view, 2e-3), "{again} is not {view}");
    }

    #[test]
    fn nothing_that_is_pasted_panics(entries in prop::array::uniform16(prop_oneof![
        4 => -10.0..10.0, 2 => Just(0.0), 1 => Just(1.0), 1 => Just(f64::NAN), 1 => -1e300..1e300, 1 => -1e-300..1e-300,
    ])) {
        let matrix = DMat4::from_cols_array(&entries);
        for kind in MatrixKind::ALL {
            for ndc in Ndc::ALL {
                if let Ok(found) = recover(kind, matrix, ndc, &Parameters::default()) {
                    Camera::new(&found.parameters).unwrap();
                }
            }
        }
    }
}

#[test]
fn parameters_that_a_matrix_does_not_hold_are_listed() {
    let camera = camera(|p| p.position = DVec3::new(3.0, 4.0, 5.0));
    let unknown = |kind, matrix| recover(kind, matrix, Ndc::default(), camera.parameters()).unwrap().unknown;
    assert_eq!(
        unknown(MatrixKind::View, camera.view_from_world()),
        [Unknown::FocalDistance, Unknown::ViewUp, Unknown::Lens]
    );
    assert_eq!(unknown(MatrixKind::Projection, camera.clip_from_view()), [Unknown::Pose]);
    assert_eq!(
        unknown(MatrixKind::ViewProjection, camera.clip_from_world()),
        [Unknown::FocalDistance, Unknown::ViewUp]
    );
    // D and VUP are kept if they fit: the same camera comes back.
    let back =
        recover(MatrixKind::ViewProjection, camera.clip_from_world(), Ndc::default(), camera.parameters()).unwrap();
    assert_eq!(back.parameters.view_up, DVec3::Y);
    assert!(back.parameters.focal_point.abs_diff_eq(DVec3::ZERO, 1e-9) && back.parameters.window.is_none());
    assert!((back.parameters.view_angle - camera.parameters().view_angle).abs() < 1e-9);
    // Exercise 5.3, [0]: the identity has the right volume and the wrong hand.
    let cube = unknown(MatrixKind::ViewProjection, DMat4::IDENTITY);
    assert!(cube.contains(&Unknown::DepthDirection) && cube.contains(&Unknown::PositionAlongNormal), "{cube:?}");
    let flipped = DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0));
    assert!(!unknown(MatrixKind::ViewProjection, flipped).contains(&Unknown::DepthDirection));
    let left_handed = DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0)) * camera.view_from_world();
    assert!(unknown(MatrixKind::View, left_handed).contains(&Unknown::LeftHandedView));
    let infinite = Ndc::ALL.into_iter().find(|ndc| ndc.name() == "webgpu-reversed-infinite").unwrap();
    let matrix = camera.clip_space(infinite).unwrap().clip_from_world();
    let found = recover(MatrixKind::ViewProjection, matrix, infinite, camera.parameters()).unwrap();
    assert!(found.unknown.contains(&Unknown::Far) && found.parameters.far == camera.far());
}

#[test]
fn matrices_of_no_camera_are_refused_with_the_reason() {
    let current = Parameters::default();
    let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    let camera = Camera::new(&Parameters { window, near: 1.0, far: 9.0, ..current }).unwrap();
    let (view, lens, whole) = (camera.view_from_world(), camera.clip_from_view(), camera.clip_from_world());
    let fault = |kind, matrix| recover(kind, matrix, Ndc::default(), &current).unwrap_err();
    let mirrored = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0)) * whole;
    assert_eq!(fault(MatrixKind::ViewProjection, mirrored), RecoveryError::Mirrored);
    let mut sheared = view;
    sheared.x_axis.x += 0.5;
    assert!(matches!(fault(MatrixKind::View, sheared), RecoveryError::Length { row: 1, .. }));
    let mut other = lens;
    other.y_axis.x = 0.7;
    assert_eq!(fault(MatrixKind::Projection, other), RecoveryError::NotZero { row: 1, column: 2, value: 0.7 });
    assert!(matches!(fault(MatrixKind::View, lens), RecoveryError::LastRow { .. }));
    assert!(matches!(fault(MatrixKind::Projection, DMat4::ZERO), RecoveryError::LastRow { .. }));
    let mut broken = view;
    broken.w_axis = DVec4::new(f64::NAN, 0.0, 0.0, 1.0);
    assert!(matches!(fault(MatrixKind::View, broken), RecoveryError::NotFinite { row: 1, column: 4, .. }));
    // Another convention is recognised.
    let reversed = Ndc::ALL.into_iter().find(|ndc| ndc.name() == "direct3d-reversed").unwrap();
    let matrix = camera.clip_space(reversed).unwrap().clip_from_view();
    let RecoveryError::Depths { fits, .. } = fault(MatrixKind::Projection, matrix) else { panic!("depths") };
    assert_eq!(fits, Some(reversed));
    let parallel = Camera::new(&Parameters { projection: Projection::Parallel, ..current }).unwrap();
    assert!(recover(MatrixKind::Projection, parallel.clip_from_view(), Ndc::default(), &current).is_ok());
}
