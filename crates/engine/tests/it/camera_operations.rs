//! Operations: the numbers of the camera that they change, and those that stay.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_engine::camera::{
    Camera, CameraError, Changes, Checked, Convention, Derived, Operation, OperationError, Projection, ViewWindow,
};
use camera_lab_engine::geometry::Angle;
use glam::DVec3;

use crate::common::camera::{apply, assert_close, assert_close3, camera};

/// C = (0, 0, 5), PF = 0: **u**, **v**, **n** are x, y, z.
fn plain() -> Camera {
    camera(|p| p.position = DVec3::new(0.0, 0.0, 5.0))
}

#[test]
fn positive_angles_turn_counter_clockwise_seen_from_the_tip_of_the_axis() {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    for (operation, position, focal_point, view_up) in [
        ("elevation=90", -5.0 * y, DVec3::ZERO, z),
        ("azimuth=90", 5.0 * x, DVec3::ZERO, y),
        ("roll=90", 5.0 * z, DVec3::ZERO, -x),
        ("yaw=90", 5.0 * z, 5.0 * z - 5.0 * x, y),
        ("pitch=90", 5.0 * z, 5.0 * z + 5.0 * y, z),
    ] {
        let after = apply(&plain(), operation);
        assert_eq!(after.position(), position, "{operation}");
        assert_eq!(after.focal_point(), focal_point, "{operation}");
        assert_eq!(after.view_up(), view_up, "{operation}");
    }
}

#[test]
fn vtk_turns_elevation_and_roll_the_other_way() {
    for name in ["elevation", "azimuth", "roll", "yaw", "pitch"] {
        let forth: Operation = format!("{name}=20").parse().unwrap();
        let back: Operation = format!("{name}=-20").parse().unwrap();
        let vtk = forth.apply(&plain(), Convention::Vtk).unwrap();
        let same = if matches!(name, "elevation" | "roll") { back } else { forth };
        assert_eq!(vtk, same.apply(&plain(), Convention::RightHand).unwrap(), "{name}");
        let angle = if same == back { -20.0 } else { 20.0 };
        assert_eq!(forth.right_hand_angle(Convention::Vtk), Some(Angle::from_degrees(angle)));
    }
}

#[test]
fn operations_change_only_the_values_they_name() {
    let before = camera(|_| ());
    for text in ["elevation=7", "azimuth=7", "roll=7", "yaw=7", "pitch=7", "zoom=1.7", "dolly=1.7", "pan=0.7,-0.2"] {
        let operation: Operation = text.parse().unwrap();
        let after = apply(&before, text);
        let found = Changes {
            position: after.position() != before.position(),
            focal_point: after.focal_point() != before.focal_point(),
            view_up: after.view_up() != before.view_up(),
            window: after.window() != before.window(),
        };
        assert_eq!(found, operation.changes(), "{text}");
        let (a, b) = (after.parameters(), before.parameters());
        assert_eq!((a.near, a.far, a.aspect, a.height), (b.near, b.far, b.aspect, b.height), "{text}");
        if !matches!(operation, Operation::Dolly(_)) {
            assert_close(after.distance(), before.distance());
        }
    }
}

#[test]
fn the_axis_goes_through_the_fixed_points() {
    let camera = camera(|p| p.focal_point = DVec3::new(1.0, 0.5, -2.0));
    let basis = camera.basis();
    for (text, pivot, direction) in [
        ("elevation=7", camera.focal_point(), basis.u),
        ("azimuth=7", camera.focal_point(), basis.v),
        ("roll=7", camera.position(), basis.n),
        ("yaw=7", camera.position(), basis.v),
        ("pitch=7", camera.position(), basis.u),
    ] {
        let axis = text.parse::<Operation>().unwrap().axis(&camera).unwrap();
        assert_eq!((axis.origin, axis.direction), (pivot, direction), "{text}");
    }
    assert_eq!(Operation::Zoom(2.0).axis(&camera), None);
}

#[test]
fn half_a_turn_is_a_turn() {
    let camera = camera(|p| (p.position, p.focal_point) = (DVec3::Z * 5.0, DVec3::ZERO));
    assert_close3(apply(&camera, "azimuth=180").position(), DVec3::NEG_Z * 5.0);
    assert_close3(apply(&camera, "yaw=-180").focal_point(), DVec3::Z * 10.0);
    assert_close3(apply(&camera, "roll=540").view_up(), -camera.view_up());
}

#[test]
fn nothing_flips_at_a_pole() {
    let start = camera(|p| (p.position, p.view_up) = (DVec3::new(0.0, 0.0, 5.0), DVec3::new(0.0, 3.0, 1.0)));
    let mut camera = start.clone();
    for step in 1..=72 {
        let before = camera.basis();
        camera = apply(&camera, "elevation=-5");
        assert_eq!(camera.basis().u, DVec3::X, "step {step}");
        assert!(camera.basis().v.dot(before.v) > 0.99, "step {step}");
        assert_close(camera.view_up().length(), 10f64.sqrt());
        if step == 18 {
            assert_close3(camera.position(), DVec3::new(0.0, 5.0, 0.0));
        }
    }
    assert_eq!(camera.parameters(), start.parameters(), "after a full circle");
}

#[test]
fn steps_of_a_full_circle_lead_back_bit_for_bit() {
    let start = camera(|p| {
        p.position = DVec3::new(3.1, -4.7, 5.3);
        p.focal_point = DVec3::new(0.1, 0.2, 0.3);
        p.view_up = DVec3::new(0.1, 1.0, -0.3);
    });
    for name in ["elevation", "azimuth", "roll", "yaw", "pitch"] {
        for (steps, degrees) in
            [(1, 360.0), (2, 180.0), (4, -90.0), (12, 30.0), (16, 22.5), (45, 8.0), (3, 240.0), (7, 720.0)]
        {
            let circle = format!("{name}={degrees} ").repeat(steps);
            assert_eq!(apply(&start, &circle).parameters(), start.parameters(), "{steps} × {name} {degrees}");
        }
    }
}

#[test]
fn chains_round_once() {
    // Out and in again by a factor that is no power of two. The angle passes within 1e-4 degrees of 180 on its way.
    let start = camera(|_| ());
    assert_eq!(
        apply(&start, "zoom=3e-7 zoom=7 zoom=0.3 azimuth=12").view_angle(),
        apply(&start, "zoom=63e-8").view_angle()
    );
    let wide = apply(&start, "zoom=0.0000003 zoom=3 zoom=1e6");
    assert_close(wide.window_height(), start.window_height() / 0.9);
    let back = apply(&start, "dolly=3e9 dolly=7 dolly=0.1 elevation=33 elevation=-33 pan=3,4 pan=-3,-4");
    let once = apply(&start, "dolly=2.1e9");
    assert_close3(back.position() * 1e9, once.position() * 1e9);
}

#[test]
fn zoom_divides_the_tangent_not_the_angle() {
    let camera = apply(&camera(|p| (p.view_angle, p.near) = (90.0, 1.0)), "zoom=3");
    assert_close(camera.window_height(), 2.0 / 3.0);
    assert_close(camera.parameters().view_angle, 2.0 * (1.0 / 3.0f64).atan().to_degrees());
    let given = ViewWindow { left: -3.0, right: 6.0, bottom: 1.5, top: 3.0 };
    let zoomed = apply(&crate::common::camera::camera(|p| p.window = Some(given)), "zoom=3");
    let expected = ViewWindow { left: -1.0, right: 2.0, bottom: 0.5, top: 1.0 };
    assert_eq!(zoomed.parameters().window, Some(expected));
    let parallel = crate::common::camera::camera(|p| (p.projection, p.height) = (Projection::Parallel, 6.0));
    assert_eq!(apply(&parallel, "zoom=4").parameters().height, 1.5);
}

#[test]
fn dolly_divides_the_distance_and_pan_shifts_both_points() {
    let near = apply(&plain(), "dolly=2");
    assert_eq!((near.position(), near.focal_point(), near.distance()), (DVec3::new(0.0, 0.0, 2.5), DVec3::ZERO, 2.5));
    let moved = apply(&plain(), "pan=1.5,-2");
    assert_eq!(moved.position(), DVec3::new(1.5, -2.0, 5.0));
    assert_eq!(moved.focal_point(), DVec3::new(1.5, -2.0, 0.0));
}

#[test]
fn a_small_angle_between_view_up_and_direction_survives_a_tour() {
    let start = camera(|p| p.view_up = (DVec3::ZERO - p.position) + DVec3::new(1e-9, 0.0, 0.0));
    let tour = apply(&start, "elevation=33 azimuth=-123 yaw=77 pitch=200 roll=15");
    let back = apply(&tour, "roll=-15 pitch=-200 yaw=-77 azimuth=123 elevation=-33");
    assert_eq!(back.basis(), start.basis());
    assert_eq!(back.parameters(), start.parameters());
}

#[test]
fn switching_the_projection_keeps_the_view_at_the_focal_point() {
    let perspective = camera(|p| (p.view_angle, p.near) = (90.0, 0.5));
    let parallel = perspective.with_projection(Projection::Parallel).unwrap();
    assert_close(parallel.parameters().height, 2.0 * perspective.distance());
    assert_close(parallel.window_aspect(), perspective.window_aspect());
    for camera in [&perspective, &parallel] {
        assert_eq!(camera.with_projection(camera.projection()).as_ref(), Ok(camera));
    }
    let window = ViewWindow { left: -0.1, right: 0.3, bottom: 0.05, top: 0.2 };
    let perspective = camera(|p| p.window = Some(window));
    let parallel = perspective.with_projection(Projection::Parallel).unwrap();
    let ratio = perspective.distance() / perspective.near();
    let found = parallel.parameters().window.unwrap();
    assert_close3(
        DVec3::new(found.left, found.right, found.top),
        DVec3::new(window.left, window.right, window.top) * ratio,
    );
}

#[test]
fn switching_there_and_back_does_not_drift() {
    let other = |p: Projection| if p == Projection::Parallel { Projection::Perspective } else { Projection::Parallel };
    for i in 0..200 {
        let i = f64::from(i);
        let start = camera(|p| {
            p.position = DVec3::new(3.0 + i * 0.37, 4.0 - i * 0.11, 5.0);
            (p.view_angle, p.near) = (0.7 + i * 0.89, 0.1 + i * 0.01);
            p.height = 0.3 + i * 0.71;
            p.projection = if i % 2.0 == 0.0 { Projection::Perspective } else { Projection::Parallel };
        });
        // Through the parameters alone, as a window that keeps nothing else does it.
        let mut parameters = *start.parameters();
        let mut first_round = None;
        for _ in 0..5 {
            for _ in 0..2 {
                let camera = Camera::new(&parameters).unwrap();
                parameters = *camera.with_projection(other(parameters.projection)).unwrap().parameters();
            }
            let shown = (parameters.view_angle, parameters.height);
            assert_eq!(*first_round.get_or_insert(shown), shown);
        }
        let kept = match start.projection() {
            Projection::Perspective => parameters.view_angle == start.parameters().view_angle,
            Projection::Parallel => parameters.height == start.parameters().height,
        };
        assert!(kept, "{:?} became {parameters:?}", start.parameters());
    }
}

#[test]
fn switching_a_given_window_there_and_back_does_not_drift() {
    let other = |p: Projection| if p == Projection::Parallel { Projection::Perspective } else { Projection::Parallel };
    let mut unchanged = 0;
    for i in 0..200 {
        let i = f64::from(i);
        let start = camera(|p| {
            p.position = DVec3::new(3.0 + i * 0.37, 4.0 - i * 0.11, 5.0);
            p.near = 0.1 + i * 0.01;
            p.window =
                Some(ViewWindow { left: -0.3 - i * 0.017, right: 0.1 + i * 0.03, bottom: 0.2, top: 0.9 + i * 0.7 });
        });
        let mut parameters = *start.parameters();
        let mut first_round = None;
        for _ in 0..5 {
            for _ in 0..2 {
                let camera = Camera::new(&parameters).unwrap();
                parameters = *camera.with_projection(other(parameters.projection)).unwrap().parameters();
            }
            assert_eq!(*first_round.get_or_insert(parameters), parameters);
        }
        let (found, given) = (parameters.window.unwrap(), start.window());
        for (x, y) in [(found.left, given.left), (found.right, given.right), (found.top, given.top)] {
            assert!((x / y - 1.0).abs() <= f64::EPSILON, "{x} {y}");
        }
        unchanged += u32::from(found == given);
        let chained = start.with_projection(Projection::Parallel).unwrap().with_projection(Projection::Perspective);
        assert_eq!(chained.unwrap().parameters(), start.parameters(), "nothing is rounded between");
    }
    assert!(unchanged > 50, "{unchanged}");
}

#[test]
fn operations_are_read_and_written() {
    for text in
        ["elevation=30", "azimuth=-12.5", "roll=1e-7", "yaw=720", "pitch=0", "zoom=1.5", "dolly=0.25", "pan=1,-2.5"]
    {
        let operation: Operation = text.parse().unwrap();
        assert_eq!(operation.to_string().parse(), Ok(operation), "{text}");
        assert!(text.starts_with(operation.name()));
    }
    assert_eq!(Operation::Pan { dx: 1.0, dy: -2.5 }.to_string(), "pan=1,-2.5");
    assert_eq!(Operation::Pan { dx: 0.0, dy: -2e-120 }.to_string(), "pan=0,-2e-120");
    assert_eq!(Operation::Zoom(1e300).to_string().parse(), Ok(Operation::Zoom(1e300)));
    let error = |text: &str| text.parse::<Operation>().map_err(|error| error.to_string());
    for name in Operation::names() {
        assert!(error("spin=3").is_err_and(|e| e.contains("\"spin\"") && e.contains(name)));
        assert!(error(name).is_err_and(|e| e.contains("NAME=VALUE")));
        for value in ["", "x", "nan", "inf", "1e999", "1,2,3", "1,2,3,4", "0x10", "3 4"] {
            assert!(error(&format!("{name}={value}")).is_err_and(|e| e.contains(name)), "{name}={value}");
        }
    }
    for text in ["zoom=0", "zoom=-1", "dolly=0", "dolly=-0.0"] {
        assert!(error(text).is_err_and(|e| e.contains("greater than 0")), "{text}");
    }
    assert!(matches!("pan=1".parse::<Operation>(), Err(OperationError::WrongCount { .. })));
}

#[test]
fn impossible_values_and_results_are_errors() {
    let camera = camera(|_| ());
    for operation in [
        Operation::Zoom(0.0),
        Operation::Zoom(f64::NAN),
        Operation::Dolly(-1.0),
        Operation::Pan { dx: f64::INFINITY, dy: 0.0 },
        Operation::Roll(Angle::from_degrees(f64::NAN)),
    ] {
        let error = operation.apply(&camera, Convention::RightHand).unwrap_err();
        assert!(
            matches!(error, CameraError::OutOfRange { key: Checked::Operation(name), .. } if name == operation.name())
        );
    }
    for operation in [
        Operation::Zoom(1e-320),
        Operation::Zoom(f64::MAX),
        Operation::Dolly(1e-320),
        Operation::Pan { dx: 1e308, dy: 1e308 },
    ] {
        assert!(operation.apply(&camera, Convention::RightHand).is_err(), "{operation}");
    }
}

#[test]
fn a_camera_of_which_one_end_leaves_the_numbers_cannot_be_panned_there() {
    let start = camera(|p| {
        p.focal_point = DVec3::new(1.4e308, 0.0, 0.0);
        p.position = DVec3::new(1.5e308, 0.0, 1e307);
    });
    // u lies halfway between x and −z.
    let found = Operation::Pan { dx: 4.5e307, dy: 0.0 }.apply(&start, Convention::RightHand);
    assert!(matches!(found, Err(CameraError::Overflow { quantity: Derived::Distance, .. })), "{found:?}");
}
