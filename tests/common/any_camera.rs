//! Cameras for property tests: ordinary ones, and those that are made to break a property.

use camera_lab_engine::camera::{Camera, Parameters, Projection, ViewWindow};
use glam::DVec3;
use proptest::prelude::*;

/// A number of any size between 10^−`digits` and 10^`digits`, of any sign, sometimes 0 or 1.
fn any_size(digits: f64) -> BoxedStrategy<f64> {
    prop_oneof![
        1 => Just(0.0),
        1 => Just(1.0),
        6 => -10.0..10.0,
        4 => (-digits..digits, any::<bool>())
            .prop_map(|(exponent, negative)| 10f64.powf(exponent) * if negative { -1.0 } else { 1.0 }),
    ]
    .boxed()
}

pub(crate) fn any_vector(digits: f64) -> BoxedStrategy<DVec3> {
    [any_size(digits), any_size(digits), any_size(digits)].prop_map(DVec3::from_array).boxed()
}

/// C, PF and VUP: of any size, all of one size, far from the origin, or with VUP almost along DOP.
fn any_pose() -> BoxedStrategy<(DVec3, DVec3, DVec3)> {
    let plain = || (any_vector(1.0), any_vector(1.0), any_vector(1.0));
    prop_oneof![
        3 => plain(),
        2 => (any_vector(12.0), any_vector(12.0), any_vector(150.0)),
        2 => (plain(), -150.0..150.0).prop_map(|((c, pf, up), k)| (c * 10f64.powf(k), pf * 10f64.powf(k), up)),
        2 => (plain(), any_vector(12.0)).prop_map(|((c, pf, up), far)| (c + far, pf + far, up)),
        2 => (plain(), -12.0..-3.0).prop_map(|((c, pf, up), k)| (c, pf, (c - pf) + up * 10f64.powf(k))),
    ]
    .boxed()
}

fn any_lens() -> BoxedStrategy<Parameters> {
    let angle = prop_oneof![
        3 => 1.0..179.0,
        1 => (-6.0..0.0).prop_map(|k| 10f64.powf(k)),
        1 => (-4.0..0.0).prop_map(|k| 180.0 - 10f64.powf(k)),
    ];
    let ratio = prop_oneof![
        3 => 1.1..1e4,
        1 => (4.0..15.0).prop_map(|k| 10f64.powf(k)),
        1 => (-12.0..-1.0).prop_map(|k| 1.0 + 10f64.powf(k)),
    ];
    let window = proptest::option::weighted(
        0.3,
        (-3.0..3.0, 0.01..5.0, -3.0..3.0, 0.01..5.0).prop_map(|(left, w, bottom, h)| ViewWindow {
            left,
            right: left + w,
            bottom,
            top: bottom + h,
        }),
    );
    (any::<bool>(), angle, 0.1..10.0, 0.2..4.0, 1e-3..10.0, ratio, window)
        .prop_map(|(perspective, view_angle, height, aspect, near, ratio, window)| Parameters {
            projection: if perspective { Projection::Perspective } else { Projection::Parallel },
            view_angle,
            height,
            aspect,
            near,
            far: near * ratio,
            window,
            ..Parameters::default()
        })
        .boxed()
}

/// Cameras as hard as the contract has them.
pub(crate) fn any_camera() -> BoxedStrategy<Camera> {
    (any_pose(), any_lens())
        .prop_filter_map("no camera", |((position, focal_point, view_up), lens)| {
            Camera::new(&Parameters { position, focal_point, view_up, ..lens }).ok()
        })
        .boxed()
}

/// Cameras of everyday size.
pub(crate) fn plain_camera() -> BoxedStrategy<Camera> {
    let vector = || [-10.0..10.0, -10.0..10.0, -10.0..10.0].prop_map(DVec3::from_array);
    (vector(), vector(), vector(), any_lens())
        .prop_filter_map("no camera", |(position, focal_point, view_up, lens)| {
            let lens = Parameters { view_angle: lens.view_angle.clamp(5.0, 150.0), far: lens.near * 50.0, ..lens };
            let apart = (position - focal_point).cross(view_up).length() > 0.1;
            apart.then(|| Camera::new(&Parameters { position, focal_point, view_up, ..lens }).ok()).flatten()
        })
        .boxed()
}
