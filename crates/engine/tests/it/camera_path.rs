//! The way from one camera to another: exact ends, cameras in between, and arcs about fixed points.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{Camera, CameraPath, Parameters, Projection, ViewWindow};
use glam::DVec3;
use proptest::prelude::*;

use crate::common::camera::{apply, camera};

const SHARES: [f64; 9] = [0.0, 0.1, 0.25, 0.4999, 0.5, 0.6, 0.75, 0.99, 1.0];

fn any_camera() -> BoxedStrategy<Camera> {
    let vector = || [-10.0..10.0, -10.0..10.0, -10.0..10.0].prop_map(DVec3::from_array);
    let window = proptest::option::weighted(
        0.3,
        (-3.0..3.0, 0.01..5.0, -3.0..3.0, 0.01..5.0).prop_map(|(left, w, bottom, h)| ViewWindow {
            left,
            right: left + w,
            bottom,
            top: bottom + h,
        }),
    );
    let lens = (any::<bool>(), 0.5..179.5, 0.1..10.0, 0.2..4.0, 1e-3..10.0, 1.000_1..1e6, window);
    (vector(), vector(), vector(), lens)
        .prop_filter_map("no camera", |(position, focal_point, view_up, lens)| {
            let (perspective, view_angle, height, aspect, near, ratio, window) = lens;
            let projection = if perspective { Projection::Perspective } else { Projection::Parallel };
            let far = near * ratio;
            Camera::new(&Parameters {
                position,
                focal_point,
                view_up,
                projection,
                view_angle,
                height,
                aspect,
                near,
                far,
                window,
            })
            .ok()
            .filter(|camera| camera.distance() > 0.01 && view_up.length() > 0.01)
        })
        .boxed()
}

proptest! {
    #[test]
    fn the_ends_are_exact_and_every_camera_on_the_way_is_one(from in any_camera(), to in any_camera()) {
        let path = CameraPath::new(&from, &to).unwrap();
        prop_assert_eq!(&path.at(0.0).unwrap(), &from);
        prop_assert_eq!(&path.at(1.0).unwrap(), &to);
        let [d0, d1] = [from.distance(), to.distance()];
        for share in SHARES {
            let camera = path.at(share).unwrap();
            let basis = camera.basis();
            let axes = [basis.u, basis.v, basis.n];
            for (i, a) in axes.iter().enumerate() {
                prop_assert!((a.length() - 1.0).abs() < 1e-12);
                prop_assert!(axes.iter().skip(i + 1).all(|b| a.dot(*b).abs() < 1e-12), "at right angles");
            }
            let expected = d0.powf(1.0 - share) * d1.powf(share);
            prop_assert!((camera.distance() / expected - 1.0).abs() < 1e-9, "{} {}", camera.distance(), expected);
            prop_assert!(camera.near() < camera.far());
        }
    }

    #[test]
    fn the_way_back_is_the_same_way(from in any_camera(), to in any_camera(), share in 0.01..0.49) {
        let there = CameraPath::new(&from, &to).unwrap().at(share).unwrap();
        let back = CameraPath::new(&to, &from).unwrap().at(1.0 - share).unwrap();
        // A half turn may go either way round.
        prop_assume!(from.basis().n.dot(to.basis().n) > -0.99);
        prop_assert!((there.position() - back.position()).length() < 1e-6 * (1.0 + there.position().length()));
        prop_assert!((there.basis().v - back.basis().v).length() < 1e-6);
        prop_assert!((there.window_height() / back.window_height() - 1.0).abs() < 1e-6);
    }
}

/// The operations of the notes are ways: half of one is half of its angle or the root of its factor.
#[test]
fn half_of_an_operation_is_an_operation() {
    let from = camera(|p| p.position = DVec3::new(3.0, 2.0, 1.0));
    for (whole, half) in [
        ("azimuth=60", "azimuth=30"),
        ("azimuth=180", "azimuth=90"),
        ("elevation=-40", "elevation=-20"),
        ("roll=100", "roll=50"),
        ("yaw=80", "yaw=40"),
        ("pitch=-30", "pitch=-15"),
        ("zoom=4", "zoom=2"),
        ("dolly=9", "dolly=3"),
        ("pan=2,-4", "pan=1,-2"),
    ] {
        let found = CameraPath::new(&from, &apply(&from, whole)).unwrap().at(0.5).unwrap();
        let expected = apply(&from, half);
        let close = |a: DVec3, b: DVec3| assert!((a - b).length() < 1e-12, "{whole}: {a} {b}");
        close(found.position(), expected.position());
        close(found.focal_point(), expected.focal_point());
        close(found.view_up(), expected.view_up());
        assert!((found.window_height() - expected.window_height()).abs() < 1e-12, "{whole}");
    }
}

#[test]
fn fixed_points_stay_exactly() {
    let from = camera(|p| p.focal_point = DVec3::new(0.1, 0.2, 0.3));
    for share in SHARES {
        let orbit = CameraPath::new(&from, &apply(&from, "azimuth=77 elevation=12 dolly=1.7")).unwrap();
        assert_eq!(orbit.at(share).unwrap().focal_point(), from.focal_point());
        let turn = CameraPath::new(&from, &apply(&from, "yaw=50 pitch=7")).unwrap();
        assert_eq!(turn.at(share).unwrap().position(), from.position());
    }
    let still = CameraPath::new(&from, &from).unwrap().at(0.3).unwrap();
    assert_eq!(still.near(), from.near());
    assert!((still.position() - from.position()).length() < 1e-12);
}

#[test]
fn the_projection_changes_half_way_and_things_at_the_focal_point_keep_their_size() {
    let from = camera(|_| {});
    let to = apply(&from, "azimuth=40 dolly=1.5").with_projection(Projection::Parallel).unwrap();
    let path = CameraPath::new(&from, &to).unwrap();
    let size = |share: f64| {
        let camera = path.at(share).unwrap();
        let scale = match camera.projection() {
            Projection::Perspective => camera.distance() / camera.near(),
            Projection::Parallel => 1.0,
        };
        (camera.projection(), camera.window_height() * scale)
    };
    let (before, after) = (size(0.5 - 1e-9), size(0.5));
    assert_eq!([before.0, after.0], [Projection::Perspective, Projection::Parallel]);
    assert!((before.1 / after.1 - 1.0).abs() < 1e-6, "{before:?} {after:?}");
}
