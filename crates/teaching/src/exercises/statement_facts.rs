//! The facts of a statement about a subject.

use glam::DVec3;

use super::Free;
use super::exercise::{Exercise, Fact};
use super::subject::Subject;
use crate::camera::{ImageSize, Parameters, Projection};
use crate::figure::NamedPoint;
use crate::figure::points::free_name;

/// Adds a point that the subject follows and the figure shows.
pub(super) fn with_point(mut subject: Subject, point: DVec3) -> Subject {
    subject.points.push(point);
    let name = free_name(&subject.figure.points);
    subject.figure.points.push(NamedPoint { name, position: point });
    subject
}

/// The facts of every statement about a camera.
fn placement(parameters: &Parameters) -> Vec<(&'static str, Fact)> {
    let Parameters { position, focal_point, view_up, .. } = *parameters;
    vec![("C", position.into()), ("PF", focal_point.into()), ("VUP", view_up.into())]
}

/// The kind of projection with its parameters.
fn lens(parameters: &Parameters) -> Vec<(&'static str, Fact)> {
    let projection = match (parameters.projection, parameters.window) {
        (Projection::Perspective, None) => "lens-perspective",
        (Projection::Parallel, None) => "lens-parallel",
        (Projection::Perspective, Some(_)) => "lens-window-perspective",
        (Projection::Parallel, Some(_)) => "lens-window-parallel",
    };
    let mut facts = vec![
        ("lens", Fact::Text(projection)),
        ("theta", Fact::Angle(parameters.view_angle)),
        ("H", Fact::Number(parameters.height)),
        ("A", Fact::Number(parameters.aspect)),
        ("F", Fact::Number(parameters.near)),
        ("B", Fact::Number(parameters.far)),
    ];
    if let Some(window) = parameters.window {
        let sides = [("l", window.left), ("r", window.right), ("b", window.bottom), ("t", window.top)];
        facts.extend(sides.map(|(name, side)| (name, Fact::Number(side))));
    }
    facts
}

/// An exercise about a subject, with the facts of its camera.
pub(super) fn about(subject: Subject) -> Exercise {
    let mut facts = placement(&subject.figure.camera);
    facts.extend(lens(&subject.figure.camera));
    Exercise {
        id: String::new(),
        seed: 0,
        subject,
        free: Vec::new(),
        chosen: Free::new(),
        holds: Vec::new(),
        facts,
        assumptions: Vec::new(),
        answered: None,
        asks: Vec::new(),
        texts: None,
    }
}

/// The fact of an image: m × n.
pub(super) fn image(size: ImageSize) -> Vec<(&'static str, Fact)> {
    vec![("m", Fact::Number(f64::from(size.width))), ("n", Fact::Number(f64::from(size.height)))]
}
