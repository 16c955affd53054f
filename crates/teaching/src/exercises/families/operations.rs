//! The operations on a camera, `[0]` §5.6.

use super::cameras::{about, any_projection, camera, lens_camera, subject, telling};
use crate::camera::{Camera, Operation, ParameterKey, Parameters, Projection};
use crate::exercises::{Ask, Exercise, Fact, Slip, Subject, Table, follows};
use crate::geometry::Angle;
use crate::inspect::quantity::{BasisAxis, Quantity, WindowNumber};
use crate::numbers::random::Random;

/// The quantities that a rotation of the camera moves, under the names of their questions.
pub(super) const C: (&str, Quantity) = ("C", Quantity::Camera(ParameterKey::Position));
pub(super) const PF: (&str, Quantity) = ("PF", Quantity::Camera(ParameterKey::FocalPoint));
pub(super) const U: (&str, Quantity) = ("u", Quantity::Axis(BasisAxis::U));
pub(super) const V: (&str, Quantity) = ("v", Quantity::Axis(BasisAxis::V));
pub(super) const N: (&str, Quantity) = ("n", Quantity::Axis(BasisAxis::N));

pub(super) fn turn(
    random: &mut Random,
    operation: fn(Angle) -> Operation,
    differs: &[&'static str],
    asks: &[(&str, Quantity)],
) -> Exercise {
    let is_roll = matches!(operation(Angle::from_degrees(0.0)), Operation::Roll(_));
    // A roll turns only directions, so the centre of its rotation doesn't matter.
    let slips = if is_roll { &[Slip::WorldAxis][..] } else { &[Slip::WorldAxis, Slip::ThroughOrigin] };
    telling(slips, || {
        let projection = any_projection(random);
        let angle = random.one_of(&[30.0, 45.0, 60.0, 90.0, -30.0, -45.0, -60.0, 120.0]);
        let mut subject = subject(camera(random, projection));
        subject.operations.push(operation(Angle::from_degrees(angle)));
        let asks = asks.iter().map(|(name, quantity)| Ask::quantity(name, &subject, *quantity));
        let asks = asks.map(|ask| following(ask, &subject)).collect();
        let exercise = Exercise { asks, assumptions: differs.to_vec(), ..about(subject) };
        exercise.with_facts([("alpha", Fact::Angle(angle))])
    })
}

/// Adds the ways from the other answers: **n** from C or PF, the other axis from **n** and the one that stays.
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

/// A factor that's neither 1 nor 2, because a 2 may get lost elsewhere.
fn factor(random: &mut Random) -> f64 {
    random.one_of(&[2.5, 3.0, 1.5, 0.6, 4.0, 0.8])
}

pub(super) fn zoom(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    let s = factor(random);
    let mut subject = subject(lens_camera(random, projection));
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
    Exercise { asks, ..about(subject) }.with_facts([("s", s)])
}

pub(super) fn dolly(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    let f = factor(random);
    let mut subject = subject(camera(random, projection));
    subject.operations.push(Operation::Dolly(f));
    let focal_point = subject.figure.camera.focal_point;
    let asks = vec![
        Ask::quantity("C", &subject, Quantity::Camera(ParameterKey::Position)),
        Ask::quantity("D", &subject, Quantity::Distance)
            .following(&["C"], move |tables| Some(Table::number((tables[0].vector()? - focal_point).length()))),
    ];
    Exercise { asks, assumptions: vec!["≠ dolly"], ..about(subject) }.with_facts([("f", f)])
}

pub(super) fn pan(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    let [dx, dy] = [0, 1].map(|_| random.one_of(&[1.0, 2.0, -1.0, -2.0, 0.5, 3.0]));
    let mut subject = subject(camera(random, projection));
    subject.operations.push(Operation::Pan { dx, dy });
    let Parameters { position, focal_point, .. } = subject.figure.camera;
    let asks = vec![
        Ask::quantity("C", &subject, Quantity::Camera(ParameterKey::Position)),
        Ask::quantity("PF", &subject, Quantity::Camera(ParameterKey::FocalPoint))
            .following(&["C"], move |tables| Some(Table::from(focal_point + tables[0].vector()? - position))),
    ];
    Exercise { asks, assumptions: vec!["≠ pan"], ..about(subject) }.with_facts([("dx", dx), ("dy", dy)])
}
