#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use glam::{DVec2, DVec3};

use super::*;
use crate::camera::{Camera, Viewport};

const IMAGE: ImageSize = ImageSize { width: 4000, height: 3000 };

/// The pixel of a point, in the space of the marks.
fn pixel(camera: &Camera, p: DVec3) -> Option<DVec2> {
    let at = camera.stations(p, IMAGE, &Viewport::whole(IMAGE)).projected?.window;
    let window = camera.window();
    let share = DVec2::new((at.x - window.left) / window.width(), (window.top - at.y) / window.height());
    Some(share * DVec2::new(f64::from(IMAGE.width), f64::from(IMAGE.height)))
}

/// The edges of a box of these sides at the origin, three of each axis, as a camera sees them.
fn marks(camera: &Camera, sides: DVec3, round: impl Fn(DVec2) -> DVec2) -> Option<PhotographMarks> {
    let see = |p: DVec3| {
        let is_in_front = -camera.view_point(p).z > 0.1;
        is_in_front.then(|| pixel(camera, p)).flatten().map(&round)
    };
    let mut lines = Vec::new();
    for axis in WorldAxis::ALL {
        let (i, along) = (axis.index(), DVec3::AXES[axis.index()]);
        for [b, c] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]] {
            let mut from = DVec3::ZERO;
            from[(i + 1) % 3] = b * sides[(i + 1) % 3];
            from[(i + 2) % 3] = c * sides[(i + 2) % 3];
            lines.push(PhotographLine { axis, ends: [see(from)?, see(from + along * sides[i])?] });
        }
    }
    let length = Some((WorldAxis::X, see(DVec3::X * sides.x)?, sides.x));
    Some(PhotographMarks { lines, origin: Some(see(DVec3::ZERO)?), length, middle: None })
}

/// A sequence of numbers between 0 and 1. A linear congruential generator is random enough for cameras.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.next()
    }
}

fn camera(random: &mut Numbers) -> Camera {
    let (azimuth, elevation) = (random.between(0.0, std::f64::consts::TAU), random.between(-0.6, 1.1));
    let distance = random.between(4.0, 15.0);
    let out = DVec3::new(elevation.cos() * azimuth.sin(), elevation.sin(), elevation.cos() * azimuth.cos());
    let aside = DVec3::new(random.between(-0.5, 1.5), random.between(-0.5, 1.5), random.between(-0.5, 1.5));
    let up = DVec3::new(random.between(-0.2, 0.2), 1.0, random.between(-0.2, 0.2));
    let parameters = Parameters {
        position: out * distance,
        focal_point: aside,
        view_up: up,
        view_angle: random.between(20.0, 80.0),
        aspect: IMAGE.aspect(),
        ..Parameters::default()
    };
    Camera::new(&parameters).unwrap()
}

fn sides(random: &mut Numbers) -> DVec3 {
    DVec3::new(random.between(1.0, 3.0), random.between(1.0, 3.0), random.between(1.0, 3.0))
}

/// θ differs from that of the cameras. Nothing may come from it.
fn given() -> Parameters {
    Parameters { view_angle: 33.0, ..Parameters::default() }
}

#[test]
fn a_thousand_known_cameras_come_back_from_exact_lines() {
    let mut random = Numbers(1);
    let mut count = 0;
    while count < 1000 {
        let (camera, sides) = (camera(&mut random), sides(&mut random));
        let Some(marks) = marks(&camera, sides, |p| p) else { continue };
        let found = camera_of_photograph(&marks, IMAGE, &given()).unwrap();
        count += 1;
        if found.untold.contains(&Untold::ViewAngle) {
            // Its lines meet so far away that a pixel would hide where.
            continue;
        }
        let again = Camera::new(&found.parameters).unwrap();
        let angle = (again.view_angle().degrees() - camera.view_angle().degrees()).abs();
        assert!(angle < 1e-6, "{angle}");
        let focal_length = 1500.0 / (camera.view_angle().radians() / 2.0).tan();
        assert!((found.focal_length.unwrap() / focal_length - 1.0).abs() < 1e-6);
        let [a, b] = [&again, &camera].map(Camera::basis);
        assert!((a.u - b.u).length() + (a.v - b.v).length() < 1e-7);
        assert!(again.position().distance(camera.position()) < 1e-6 * camera.position().length());
    }
}

#[test]
fn a_thousand_known_cameras_come_back_from_whole_pixels_within_their_cost() {
    let mut random = Numbers(2);
    let (mut count, mut told) = (0, 0);
    while count < 1000 {
        let (camera, sides) = (camera(&mut random), sides(&mut random));
        let Some(marks) = marks(&camera, sides, DVec2::round) else { continue };
        count += 1;
        let Ok(found) = camera_of_photograph(&marks, IMAGE, &given()) else {
            panic!("no camera of {:?}", camera.parameters());
        };
        let Some(cost) = found.view_angle_per_pixel.filter(|cost| *cost < 1.0) else { continue };
        told += 1;
        let again = Camera::new(&found.parameters).unwrap();
        let angle = (again.view_angle().degrees() - camera.view_angle().degrees()).abs();
        // Half a pixel in each of 36 coordinates: at most 0.5 √36 times the root of the squares.
        assert!(angle <= 3.0 * cost, "{angle} {cost}");
        let turn = again.basis().n.angle_between(camera.basis().n).to_degrees();
        assert!(turn <= 3.0 * found.direction_per_pixel, "{turn} {}", found.direction_per_pixel);
    }
    assert!(told > 600, "{told}");
}

#[test]
fn lines_that_meet_at_infinity_leave_theta_open_and_say_so() {
    // It looks along −z: x and y vanish at infinity, and z in the middle.
    let parameters = Parameters {
        position: DVec3::new(0.7, 0.8, 6.0),
        focal_point: DVec3::new(0.7, 0.8, 0.0),
        view_angle: 50.0,
        aspect: IMAGE.aspect(),
        ..Parameters::default()
    };
    let camera = Camera::new(&parameters).unwrap();
    for round in [|p: DVec2| p, DVec2::round] {
        let marks = marks(&camera, DVec3::new(2.0, 1.5, 1.0), round).unwrap();
        let found = camera_of_photograph(&marks, IMAGE, &given()).unwrap();
        assert_eq!((found.focal_length, found.view_angle_per_pixel), (None, None));
        assert_eq!(found.untold, [Untold::ViewAngle]);
        assert_eq!(found.parameters.view_angle, 33.0, "that of the given camera");
        let ideal: Vec<bool> = found.vanishing.iter().map(|vanishing| vanishing.pixel.is_none()).collect();
        assert_eq!(ideal, [true, true, false]);
        let again = Camera::new(&found.parameters).unwrap();
        assert!(again.basis().n.angle_between(camera.basis().n).to_degrees() < 0.1, "R does not depend on it");
    }
}

/// The numbers that the photograph doesn't tell stay as they were, so taking the camera twice changes nothing.
#[test]
fn the_camera_found_from_the_one_found_is_the_same() {
    let mut random = Numbers(5);
    for count in 0..200 {
        let (camera, sides) = (camera(&mut random), sides(&mut random));
        let Some(mut marks) = marks(&camera, sides, |p| p) else { continue };
        if count % 4 != 0 {
            marks.length = None;
        }
        if count % 4 == 1 {
            marks.origin = None;
        }
        let Ok(once) = camera_of_photograph(&marks, IMAGE, &given()) else { continue };
        let again = camera_of_photograph(&marks, IMAGE, &once.parameters).unwrap();
        let [one, other] = [&once, &again].map(|found| &found.parameters);
        let moved = one.position.distance(other.position) + one.focal_point.distance(other.focal_point);
        assert!(moved < 1e-9 * one.position.length(), "{count}: {one:?} {other:?}");
    }
}

#[test]
fn two_axes_are_enough_and_without_the_origin_its_place_is_open() {
    let mut random = Numbers(3);
    let camera = camera(&mut random);
    let mut marks = marks(&camera, DVec3::ONE, |p| p).unwrap();
    marks.lines.retain(|line| line.axis != WorldAxis::Y);
    (marks.origin, marks.length) = (None, None);
    let found = camera_of_photograph(&marks, IMAGE, &given()).unwrap();
    assert_eq!(found.untold, [Untold::Position, Untold::Distance]);
    assert!((found.parameters.view_angle - camera.view_angle().degrees()).abs() < 1e-6);
    // The horizon is the image of points far away on y = 0.
    let [a, b] = found.horizon.unwrap();
    let far = camera.position().with_y(0.0) - camera.basis().n.with_y(0.0) * 1e9 + DVec3::X * 3e8;
    let far = pixel(&camera, far).unwrap();
    assert!((b - a).normalize().perp_dot(far - a).abs() < 1e-2);
}

#[test]
fn impossible_marks_are_refused_with_their_reason() {
    let line = |axis, a: [f64; 2], b: [f64; 2]| PhotographLine { axis, ends: [a, b].map(DVec2::from_array) };
    let refused = |lines: Vec<PhotographLine>| {
        let marks = PhotographMarks { lines, ..PhotographMarks::default() };
        camera_of_photograph(&marks, IMAGE, &given()).unwrap_err()
    };
    let x = [line(WorldAxis::X, [100.0, 100.0], [900.0, 300.0]), line(WorldAxis::X, [100.0, 2000.0], [900.0, 1700.0])];
    assert_eq!(refused(x.to_vec()), PhotographError::TooFewLines);
    let dot = line(WorldAxis::Z, [5.0, 5.0], [5.0, 5.0]);
    assert_eq!(refused([x.to_vec(), vec![dot]].concat()), PhotographError::NoDirection(3));
    // Both meet on the same side of the middle, where axes at right angles never do.
    let z = x.map(|line| PhotographLine { axis: WorldAxis::Z, ends: line.ends.map(|p| p + DVec2::new(0.0, 300.0)) });
    assert!(matches!(refused([x, z].concat()), PhotographError::NotAtRightAngles(WorldAxis::X, WorldAxis::Z, _)));
}

#[test]
fn axes_whose_lines_have_one_direction_are_refused() {
    let line = |axis, a: [f64; 2], b: [f64; 2]| PhotographLine { axis, ends: [a, b].map(DVec2::from_array) };
    // Two pairs of horizontal lines, each pair called another axis; then nearly so, and both at one finite point.
    for (tilt, meet) in [(0.0, 0.0), (0.001, 0.0), (1.0, 0.0), (0.0, 30.0)] {
        let pair = |axis, y: f64, tilt: f64| {
            let below = [200.0, y + 100.0 - meet + tilt];
            [line(axis, [100.0, y], [200.0, y]), line(axis, [100.0, y + 100.0], below)]
        };
        let lines = [pair(WorldAxis::X, 100.0, 0.0), pair(WorldAxis::Z, 100.0, tilt)].concat();
        let marks = PhotographMarks { lines, ..PhotographMarks::default() };
        let refused = camera_of_photograph(&marks, ImageSize { width: 640, height: 480 }, &given()).unwrap_err();
        assert!(
            matches!(
                refused,
                PhotographError::SameDirection(..) | PhotographError::NotAtRightAngles(WorldAxis::X, WorldAxis::Z, _)
            ),
            "{tilt} {meet}: {refused:?}"
        );
    }
}

#[test]
fn whatever_lines_are_marked_the_camera_of_them_is_one() {
    let mut random = Numbers(4);
    let mut cameras = 0;
    for _ in 0..10_000 {
        // Numbers that repeat, so that lines are parallel, coincide, and have no length.
        let grid = 10.0_f64.powf(random.between(0.0, 3.0).floor());
        let pixel = |random: &mut Numbers| {
            let near = DVec2::new(random.between(-100.0, 740.0), random.between(-100.0, 580.0));
            if random.next() < 0.7 { (near / grid).round() * grid } else { near }
        };
        let mut lines = Vec::new();
        for axis in WorldAxis::ALL {
            for _ in 0..4 {
                if random.next() < 0.4 {
                    continue;
                }
                let from = pixel(&mut random);
                let to = match random.next() {
                    share if share < 0.3 => from + DVec2::X * 100.0,
                    share if share < 0.4 => from + DVec2::Y * random.between(-1e-9, 1e-9),
                    share if share < 0.5 => from + DVec2::X * 1e12,
                    _ => pixel(&mut random),
                };
                lines.push(PhotographLine { axis, ends: [from, to] });
            }
        }
        let origin = (random.next() < 0.5).then(|| pixel(&mut random));
        let length = origin.map(|_| (WorldAxis::X, pixel(&mut random), random.between(-2.0, 2.0).round()));
        let given = Parameters { near: random.between(-1.0, 1.0), projection: Projection::Parallel, ..given() };
        let marks = PhotographMarks { lines, origin, length: length.filter(|of| of.2 != 0.0), middle: None };
        if let Ok(found) = camera_of_photograph(&marks, ImageSize { width: 640, height: 480 }, &given) {
            cameras += 1;
            assert!(Camera::new(&found.parameters).is_ok(), "{marks:?}");
            assert!(found.roll().is_finite() && found.axes().iter().all(|axis| axis.is_finite()), "{marks:?}");
        }
    }
    assert!(cameras > 1000, "{cameras}");
}

/// A level camera at a corner of a house, with each coordinate off by up to `off` pixels, evenly spread.
fn level(random: &mut Numbers, off: f64) -> Option<(Camera, PhotographMarks)> {
    let azimuth = random.between(0.4, 1.1);
    let parameters = Parameters {
        position: DVec3::new(azimuth.sin() * 9.0, random.between(1.4, 1.9), azimuth.cos() * 9.0),
        focal_point: DVec3::new(0.0, random.between(1.4, 1.9), 0.0),
        view_angle: random.between(35.0, 65.0),
        aspect: IMAGE.aspect(),
        ..Parameters::default()
    };
    let camera = Camera::new(&parameters).unwrap();
    let sides = DVec3::new(random.between(2.0, 4.0), random.between(2.0, 3.0), random.between(2.0, 4.0));
    let mut exact = marks(&camera, sides, |p| p)?;
    for line in &mut exact.lines {
        line.ends = line.ends.map(|end| end + DVec2::new(random.between(-off, off), random.between(-off, off)));
    }
    Some((camera, exact))
}

#[test]
fn a_weak_third_axis_never_spoils_a_camera() {
    let mut random = Numbers(5);
    let mut worse = 0;
    for off in [1.0, 2.0, 3.5] {
        for _ in 0..100 {
            let Some((camera, marks)) = level(&mut random, off) else { continue };
            let mut two = marks.clone();
            two.lines.retain(|line| line.axis != WorldAxis::Y);
            let [all, two] = [&marks, &two].map(|marks| camera_of_photograph(marks, IMAGE, &given()).unwrap());
            let (Some(cost), Some(of_two)) = (all.view_angle_per_pixel, two.view_angle_per_pixel) else { panic!() };
            assert!(cost.is_finite() && all.direction_per_pixel.is_finite() && cost < 1.1 * of_two, "{cost} {of_two}");
            let theta = camera.view_angle().degrees();
            let error = (all.parameters.view_angle - theta).abs();
            assert!(error < 4.0 * off * cost, "{error} {cost}");
            worse += usize::from(error > (two.parameters.view_angle - theta).abs() + cost);
        }
    }
    assert!(worse < 6, "{worse}");
}

#[test]
fn lines_drawn_the_other_way_round_are_turned_and_named() {
    let mut random = Numbers(6);
    for _ in 0..200 {
        let (camera, sides) = (camera(&mut random), sides(&mut random));
        let Some(marks) = marks(&camera, sides, |p| p) else { continue };
        for axis in WorldAxis::ALL {
            for axes in [vec![WorldAxis::X, axis], WorldAxis::ALL.to_vec()] {
                let mut other = marks.clone();
                other.lines.retain(|line| axes.contains(&line.axis));
                if axes.len() == 2 && axis == WorldAxis::X {
                    continue;
                }
                // The length says which way x runs.
                for line in other.lines.iter_mut().filter(|line| line.axis == WorldAxis::X) {
                    line.ends.reverse();
                }
                let found = camera_of_photograph(&other, IMAGE, &given());
                let Ok(found) = found else {
                    assert!(matches!(found, Err(PhotographError::LengthAtAngle(_))), "{found:?}");
                    continue;
                };
                assert!(found.doubts.contains(&Doubt::Turned(WorldAxis::X)), "{found:?}");
                if found.untold.is_empty() {
                    let p = camera.position();
                    assert!(found.parameters.position.distance(p) < 1e-5 * p.length(), "{found:?}");
                }
            }
        }
    }
}

#[test]
fn pieces_of_one_line_are_left_out_or_refused_and_never_at_infinity() {
    let mut random = Numbers(7);
    for axis in WorldAxis::ALL.into_iter().cycle().take(200) {
        let (camera, sides) = (camera(&mut random), sides(&mut random));
        let Some(mut marks) = marks(&camera, sides, |p| p) else { continue };
        let (a, way) = (DVec2::new(300.0, 400.0), DVec2::from_angle(random.between(0.0, 6.0)) * 300.0);
        let pieces = [0.0, 1.5, 4.0].map(|at| [a + way * at, a + way * (at + 1.0 + random.next())]);
        let pieces = pieces.map(|ends| PhotographLine { axis, ends: ends.map(DVec2::round) });
        marks.lines.retain(|line| line.axis != axis);
        (marks.length, marks.lines) = (None, [marks.lines, pieces.to_vec()].concat());
        let found = camera_of_photograph(&marks, IMAGE, &given()).unwrap();
        assert!(found.doubts.contains(&Doubt::OneLine(axis)), "{found:?}");
        assert_eq!(found.vanishing.len(), 2);
        let other = marks.lines[0].axis;
        marks.lines.retain(|line| line.axis == axis || line.axis == other);
        assert_eq!(camera_of_photograph(&marks, IMAGE, &given()), Err(PhotographError::OneLine(axis)));
    }
}

#[test]
fn a_point_beside_the_axis_is_no_length() {
    let mut random = Numbers(8);
    let mut refused = 0;
    for _ in 0..200 {
        let (camera, sides) = (camera(&mut random), sides(&mut random));
        let Some(mut marks) = marks(&camera, sides, |p| p) else { continue };
        // The edge of the box beside the axis.
        let beside = pixel(&camera, DVec3::new(sides.x, 0.0, sides.z)).unwrap();
        let [o, x] = [marks.origin.unwrap(), marks.length.unwrap().1];
        if (x - o).normalize().perp_dot(beside - o).abs() < 60.0 {
            continue;
        }
        marks.length = Some((WorldAxis::X, beside, sides.x));
        if camera.view_point(DVec3::new(sides.x, 0.0, sides.z)).z < -0.1 {
            let found = camera_of_photograph(&marks, IMAGE, &given());
            refused += 1;
            assert!(
                matches!(found, Err(PhotographError::BesideAxis(WorldAxis::X, pixels)) if pixels > 5.0),
                "{found:?}"
            );
        }
    }
    assert!(refused > 100, "{refused}");
}

#[test]
fn lines_that_no_camera_has_at_right_angles_get_their_angle() {
    let line = |axis, a: [f64; 2], b: [f64; 2]| PhotographLine { axis, ends: [a, b].map(DVec2::from_array) };
    let image = ImageSize { width: 1024, height: 768 };
    // x is ideal, and V_z is 367 pixels to the right of the middle.
    let z = |y: f64, v: DVec2| line(WorldAxis::Z, DVec2::new(150.0, y).lerp(v, 0.6).to_array(), [150.0, y]);
    let v_z = DVec2::new(512.0 + 367.0, 384.0);
    let x = [100.0, 600.0].map(|y| line(WorldAxis::X, [100.0, y], [900.0, y]));
    let lines = [x.to_vec(), vec![z(150.0, v_z), z(650.0, v_z)]].concat();
    let marks = PhotographMarks { lines, ..PhotographMarks::default() };
    let given = Parameters { view_angle: 45.0, ..Parameters::default() };
    let found = camera_of_photograph(&marks, image, &given).unwrap();
    let f = 384.0 / 22.5_f64.to_radians().tan();
    let angle = (f / 367.0).atan().to_degrees();
    assert!(
        matches!(found.doubts[..], [Doubt::Angle(WorldAxis::X, WorldAxis::Z, a)] if (a - angle).abs() < 0.1),
        "{angle}: {:?}",
        found.doubts
    );
    // Two ideal points.
    let y = [100.0, 400.0].map(|x| line(WorldAxis::Y, [x, 600.0], [x + 300.0, 300.0]));
    let marks = PhotographMarks { lines: [x.to_vec(), y.to_vec()].concat(), ..PhotographMarks::default() };
    let found = camera_of_photograph(&marks, image, &given).unwrap();
    assert!(matches!(found.doubts[..], [Doubt::Angle(_, _, a), ..] if (a - 45.0).abs() < 0.1), "{:?}", found.doubts);
}

#[test]
fn three_vanishing_points_of_a_cropped_photograph_give_the_middle_which_brings_the_camera_back() {
    let mut random = Numbers(9);
    let mut offered = 0;
    for _ in 0..300 {
        let (camera, sides) = (camera(&mut random), sides(&mut random));
        let Some(mut marks) = marks(&camera, sides, |p| p) else { continue };
        // Cut off at the left and at the top.
        let cut = DVec2::new(600.0, 300.0);
        for line in &mut marks.lines {
            line.ends = line.ends.map(|end| end - cut);
        }
        marks.origin = marks.origin.map(|p| p - cut);
        marks.length = marks.length.map(|(axis, p, x)| (axis, p - cut, x));
        let image = ImageSize { width: IMAGE.width - 600, height: IMAGE.height - 300 };
        let middle = DVec2::new(2000.0, 1500.0) - cut;
        let doubts = match camera_of_photograph(&marks, image, &given()) {
            Ok(found) => found.doubts,
            Err(PhotographError::OffMiddle(doubt)) => vec![doubt],
            Err(_) => continue,
        };
        let of_middle =
            |doubt: &Doubt| if let Doubt::Middle { pixel, error, .. } = doubt { Some((*pixel, *error)) } else { None };
        let Some((pixel, error)) = doubts.iter().find_map(of_middle) else { continue };
        offered += 1;
        assert!(pixel.distance(middle) < 1e-3 * error, "{pixel} {error}");
        marks.middle = Some(pixel);
        let again = camera_of_photograph(&marks, image, &given()).unwrap();
        if again.untold.is_empty() {
            let own = Camera::new(&again.parameters).unwrap();
            assert!(own.position().distance(camera.position()) < 1e-5 * camera.position().length());
            assert!(own.basis().n.angle_between(camera.basis().n) < 1e-6);
        }
    }
    assert!(offered > 100, "{offered}");
}

/// An oblique view of a long lens: the lines are nearly parallel in the image, and the θ of the figure is far off.
#[test]
fn a_long_lens_with_a_length_gets_the_true_reason() {
    let line = |axis, a: [f64; 2], b: [f64; 2]| PhotographLine { axis, ends: [a, b].map(DVec2::from_array) };
    let lines = vec![
        line(WorldAxis::X, [98.7, 372.7], [666.0, 430.8]),
        line(WorldAxis::X, [448.3, 529.2], [872.6, 568.7]),
        line(WorldAxis::Y, [46.75, 708.4], [38.3, 226.0]),
        line(WorldAxis::Y, [91.4, 497.2], [85.0, 159.2]),
    ];
    let length = Some((WorldAxis::Z, DVec2::new(37.0, 553.0), -39.8));
    let marks = PhotographMarks { lines, origin: Some(DVec2::new(542.0, 377.0)), length, middle: None };
    let image = ImageSize { width: 1024, height: 768 };
    let at = |view_angle| camera_of_photograph(&marks, image, &Parameters { view_angle, ..Parameters::default() });
    assert_eq!(at(45.0).unwrap_err(), PhotographError::LengthAtAngle(45.0));
    assert!(at(5.4).is_ok_and(|found| found.untold == [Untold::ViewAngle]));
}

/// Of 500 cameras: no change of the marks grows more than the condition says, and changes along each number by itself
/// show that it isn't far too large.
#[test]
fn no_change_of_the_marks_grows_more_than_the_condition() {
    let numbers = |found: &PhotographCamera| -> [f64; 10] {
        let Parameters { position: c, focal_point: pf, view_up: up, view_angle, .. } = found.parameters;
        [c.x, c.y, c.z, pf.x, pf.y, pf.z, up.x, up.y, up.z, view_angle]
    };
    let mut random = Numbers(59);
    let mut tried = 0;
    while tried < 500 {
        let (of, sides) = (camera(&mut random), sides(&mut random));
        let Some(marks) = marks(&of, sides, |at| at) else { continue };
        let Some(condition) = condition_of_photograph(&marks, IMAGE, &given()) else { continue };
        let found = camera_of_photograph(&marks, IMAGE, &given()).unwrap();
        let (right, count) = (numbers(&found), 4 * marks.lines.len() + 5);
        let size = right.iter().fold(0.0, |sum: f64, x| sum.hypot(*x));
        let grown = |by: &mut dyn FnMut(usize) -> f64| -> Option<f64> {
            let (mut moved, mut change, mut k) = (marks.clone(), 0.0_f64, 0);
            let mut scale = |x: &mut f64| {
                let by = 1e-7 * by(k);
                (change, k) = (change.hypot(by), k + 1);
                *x *= 1.0 + by;
            };
            let ends = moved.lines.iter_mut().flat_map(|line| &mut line.ends).chain(&mut moved.origin);
            ends.for_each(|end| [&mut end.x, &mut end.y].into_iter().for_each(&mut scale));
            let (_, pixel, length) = moved.length.as_mut()?;
            [&mut pixel.x, &mut pixel.y, length].into_iter().for_each(&mut scale);
            let other = numbers(&camera_of_photograph(&moved, IMAGE, &given()).ok()?);
            let off = right.iter().zip(other).fold(0.0, |sum: f64, (a, b)| sum.hypot(a - b));
            Some(off / size / change)
        };
        let some = grown(&mut |_| random.between(-1.0, 1.0));
        assert!(some.is_none_or(|grown| grown <= 1.01 * condition + 1e-6), "{some:?} {condition}");
        let single = (0..count).filter_map(|one| grown(&mut |k| f64::from(u8::from(k == one)))).fold(0.0, f64::max);
        assert!(single <= 1.01 * condition + 1e-6, "{single} {condition}");
        assert!(single >= condition / (count as f64).sqrt() / 1.01, "{single} {condition}");
        tried += 1;
    }
}
