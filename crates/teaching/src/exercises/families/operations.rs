//! The operations on a camera, `[0]` §5.6.

use super::cameras::{about, any_projection, camera, lens_camera, numbers, subject, telling};
use crate::camera::{Camera, Operation, ParameterKey, Parameters, Projection};
use crate::exercises::{Ask, Entry, Exercise, Fact, Slip, Subject, Table, follows};
use crate::geometry::Angle;
use crate::inspect::quantity::{BasisAxis, Quantity, WindowNumber};
use crate::numbers::random::Random;

macro_rules! turns {
    ($($name:ident, $id:literal, $differs:expr, $operation:ident, $asks:expr;)*) => {
        $(pub(super) const $name: Entry =
            Entry::family($id, "[0] §5.6", |seed, _| turn($id, $differs, seed, Operation::$operation, &$asks));)*
    };
}

turns! {
    ELEVATION, "elevation", &["≠ elevation"], Elevation, [("C", Quantity::Camera(ParameterKey::Position)), ("n", Quantity::Axis(BasisAxis::N)), ("v", Quantity::Axis(BasisAxis::V))];
    AZIMUTH, "azimuth", &["≠ azimuth"], Azimuth, [("C", Quantity::Camera(ParameterKey::Position)), ("n", Quantity::Axis(BasisAxis::N)), ("u", Quantity::Axis(BasisAxis::U))];
    ROLL, "roll", &[], Roll, [("u", Quantity::Axis(BasisAxis::U)), ("v", Quantity::Axis(BasisAxis::V))];
    YAW, "yaw", &["≠ yaw"], Yaw, [("PF", Quantity::Camera(ParameterKey::FocalPoint)), ("n", Quantity::Axis(BasisAxis::N)), ("u", Quantity::Axis(BasisAxis::U))];
    PITCH, "pitch", &["≠ pitch"], Pitch, [("PF", Quantity::Camera(ParameterKey::FocalPoint)), ("n", Quantity::Axis(BasisAxis::N)), ("v", Quantity::Axis(BasisAxis::V))];
}

pub(super) const ZOOM: Entry = Entry::family("zoom", "[0] §5.6", |seed, _| zoom(seed));
pub(super) const DOLLY: Entry = Entry::family("dolly", "[0] §5.2, (5.2)", |seed, _| dolly(seed));
pub(super) const PAN: Entry = Entry::family("pan", "[0] §5.2, (5.3)", |seed, _| pan(seed));

fn turn(
    family: &str,
    differs: &[&'static str],
    seed: u64,
    operation: fn(Angle) -> Operation,
    asks: &[(&str, Quantity)],
) -> Exercise {
    let mut random = numbers(family, seed);
    let is_roll = matches!(operation(Angle::from_degrees(0.0)), Operation::Roll(_));
    // Nothing that a roll turns moves.
    let slips = if is_roll { &[Slip::WorldAxis][..] } else { &[Slip::WorldAxis, Slip::ThroughOrigin] };
    telling(slips, || {
        let projection = any_projection(&mut random);
        let angle = random.one_of(&[30.0, 45.0, 60.0, 90.0, -30.0, -45.0, -60.0, 120.0]);
        let mut subject = subject(camera(&mut random, projection));
        subject.operations.push(operation(Angle::from_degrees(angle)));
        let asks = asks.iter().map(|(name, quantity)| Ask::quantity(name, &subject, *quantity));
        let asks = asks.map(|ask| following(ask, &subject)).collect();
        let mut exercise = Exercise { asks, assumptions: differs.to_vec(), ..about(subject) };
        exercise.facts.push(("alpha", Fact::Angle(angle)));
        exercise
    })
}

/// With the ways from the other answers: **n** from C or PF, the other axis from **n** and the one that stays.
fn following(ask: Ask, subject: &Subject) -> Ask {
    let (Ok(before), Some(operation)) = (Camera::new(&subject.figure.camera), subject.operations.first()) else {
        return ask;
    };
    let (position, focal_point) = (before.position(), before.focal_point());
    let basis = before.basis();
    let moves_position = matches!(operation, Operation::Elevation(_) | Operation::Azimuth(_));
    let normal = move |tables: &[Table]| {
        let moved = tables[0].vector()?;
        follows::unit(if moves_position { moved - focal_point } else { position - moved })
    };
    let moved: &'static [&'static str] = if moves_position { &["C"] } else { &["PF"] };
    match (ask.name.as_str(), operation) {
        ("n", _) => ask.following(moved, move |tables| normal(tables).map(Table::from)),
        ("v", Operation::Roll(_)) => {
            ask.following(&["u"], move |tables| Some(Table::from(basis.n.cross(tables[0].vector()?))))
        }
        ("v", _) => ask
            .following(&["n"], move |tables| Some(Table::from(tables[0].vector()?.cross(basis.u))))
            .following(moved, move |tables| Some(Table::from(normal(tables)?.cross(basis.u)))),
        ("u", Operation::Azimuth(_) | Operation::Yaw(_)) => ask
            .following(&["n"], move |tables| Some(Table::from(basis.v.cross(tables[0].vector()?))))
            .following(moved, move |tables| Some(Table::from(basis.v.cross(normal(tables)?)))),
        _ => ask,
    }
}

/// A factor that is neither 1 nor a 2, which may be lost elsewhere.
fn factor(random: &mut Random) -> f64 {
    random.one_of(&[2.5, 3.0, 1.5, 0.6, 4.0, 0.8])
}

fn zoom(seed: u64) -> Exercise {
    let mut random = numbers("zoom", seed);
    let projection = any_projection(&mut random);
    let s = factor(&mut random);
    let mut subject = subject(lens_camera(&mut random, projection));
    subject.operations.push(Operation::Zoom(s));
    let mut paths = vec![("H", Quantity::Window(WindowNumber::Height)), ("W", Quantity::Window(WindowNumber::Width))];
    if projection == Projection::Perspective {
        paths.push(("theta", Quantity::Camera(ParameterKey::ViewAngle)));
    }
    let (near, aspect) = (subject.figure.camera.near, subject.figure.camera.aspect);
    let asks = paths.into_iter().map(|(name, path)| {
        let ask = Ask::quantity(name, &subject, path);
        match name {
            "W" => ask.following(&["H"], move |tables| Some(tables[0].map(|height| height * aspect))),
            "theta" => ask.following(&["H"], move |tables| {
                Some(tables[0].map(|height| 2.0 * (height / (2.0 * near)).atan().to_degrees()))
            }),
            _ => ask,
        }
    });
    let asks = asks.collect();
    let mut exercise = Exercise { asks, ..about(subject) };
    exercise.facts.push(("s", Fact::Number(s)));
    exercise
}

fn dolly(seed: u64) -> Exercise {
    let mut random = numbers("dolly", seed);
    let projection = any_projection(&mut random);
    let f = factor(&mut random);
    let mut subject = subject(camera(&mut random, projection));
    subject.operations.push(Operation::Dolly(f));
    let focal_point = subject.figure.camera.focal_point;
    let asks = vec![
        Ask::quantity("C", &subject, Quantity::Camera(ParameterKey::Position)),
        Ask::quantity("D", &subject, Quantity::Distance)
            .following(&["C"], move |tables| Some(Table::number((tables[0].vector()? - focal_point).length()))),
    ];
    let mut exercise = Exercise { asks, assumptions: vec!["≠ dolly"], ..about(subject) };
    exercise.facts.push(("f", Fact::Number(f)));
    exercise
}

fn pan(seed: u64) -> Exercise {
    let mut random = numbers("pan", seed);
    let projection = any_projection(&mut random);
    let [dx, dy] = [0, 1].map(|_| random.one_of(&[1.0, 2.0, -1.0, -2.0, 0.5, 3.0]));
    let mut subject = subject(camera(&mut random, projection));
    subject.operations.push(Operation::Pan { dx, dy });
    let Parameters { position, focal_point, .. } = subject.figure.camera;
    let asks = vec![
        Ask::quantity("C", &subject, Quantity::Camera(ParameterKey::Position)),
        Ask::quantity("PF", &subject, Quantity::Camera(ParameterKey::FocalPoint))
            .following(&["C"], move |tables| Some(Table::from(focal_point + tables[0].vector()? - position))),
    ];
    let mut exercise = Exercise { asks, assumptions: vec!["≠ pan"], ..about(subject) };
    exercise.facts.extend([("dx", Fact::Number(dx)), ("dy", Fact::Number(dy))]);
    exercise
}
