//! The axes of a camera, its window, and its matrices.

use glam::DVec3;

use super::cameras::{about, any_projection, camera, lens_camera, subject};
use crate::camera::{Parameters, Projection, ViewWindow};
use crate::exercises::{Ask, Exercise, Table, follows};
use crate::inspect::quantity::{BasisAxis, Quantity, ReportMatrix, WindowNumber};
use crate::numbers::random::Random;

pub(super) fn basis(random: &mut Random) -> Exercise {
    let subject = subject(camera(random, Projection::Perspective));
    let asks = BasisAxis::ALL.iter().map(|axis| Ask::quantity(axis.name(), &subject, Quantity::Axis(*axis)));
    let asks = axes(asks.collect(), subject.figure.camera.view_up);
    Exercise { asks, ..about(subject) }
}

pub(super) fn view_matrix(random: &mut Random) -> Exercise {
    let subject = subject(camera(random, Projection::Perspective));
    let asks = vec![Ask::quantity("Mv", &subject, Quantity::Matrix(ReportMatrix::View))];
    Exercise { asks, ..about(subject) }
}

pub(super) fn window(random: &mut Random) -> Exercise {
    let subject = subject(lens_camera(random, Projection::Perspective));
    let asks = [
        ("H", Quantity::Window(WindowNumber::Height)),
        ("W", Quantity::Window(WindowNumber::Width)),
        ("r", Quantity::Window(WindowNumber::Right)),
        ("b", Quantity::Window(WindowNumber::Bottom)),
    ];
    let aspect = subject.figure.camera.aspect;
    let asks = asks.map(|(name, path)| {
        let ask = Ask::quantity(name, &subject, path);
        match name {
            "W" => ask.following(&["H"], move |tables| Some(tables[0].map(|height| height * aspect))),
            "r" => ask
                .following(&["W"], |tables| Some(tables[0].map(|width| width / 2.0)))
                .following(&["H"], move |tables| Some(tables[0].map(|height| height * aspect / 2.0))),
            "b" => ask.following(&["H"], |tables| Some(tables[0].map(|height| -height / 2.0))),
            _ => ask,
        }
    });
    Exercise { asks: asks.to_vec(), ..about(subject) }
}

pub(super) fn projection(random: &mut Random, projection: Projection) -> Exercise {
    // With F = 1 the scale of a perspective, 2F/W, would be right in parallel projection too.
    let mut camera = Parameters { projection, ..lens_camera(random, Projection::Perspective) };
    // tan 30° is cot 60°, and tan 45° is 1, so one mistake would look like another.
    if camera.view_angle >= 60.0 {
        camera.view_angle = random.one_of(&[40.0, 50.0, 70.0]);
    }
    let subject = subject(camera);
    let asks = vec![Ask::quantity("Mp", &subject, Quantity::Matrix(ReportMatrix::Projection))];
    Exercise { asks, ..about(subject) }
}

pub(super) fn asymmetric_window(random: &mut Random) -> Exercise {
    let projection = any_projection(random);
    let camera = lens_camera(random, projection);
    let [left, bottom] = [0, 1].map(|_| -random.one_of(&[0.5, 1.0, 1.5, 2.0]));
    // The two sides are never equally far.
    let right = -left * random.one_of(&[0.5, 2.0, 3.0]);
    let top = -bottom * random.one_of(&[0.5, 1.5, 2.0]);
    let camera = Parameters { window: Some(ViewWindow { left, right, bottom, top }), ..camera };
    let subject = subject(camera);
    let asks = vec![Ask::quantity("Mp", &subject, Quantity::Matrix(ReportMatrix::Projection))];
    Exercise { asks, ..about(subject) }
}

/// The axes of an exercise that asks for **n**, **u** = VUP × **n** and **v** = **n** × **u**.
fn axes(asks: Vec<Ask>, view_up: DVec3) -> Vec<Ask> {
    let of_normal = move |tables: &[Table]| follows::unit(view_up.cross(tables[0].vector()?));
    let along = |ask: Ask| match ask.name.as_str() {
        "u" => ask.following(&["n"], move |tables| of_normal(tables).map(Table::from)),
        "v" => ask
            .following(&["n", "u"], |tables| Some(Table::from(tables[0].vector()?.cross(tables[1].vector()?))))
            .following(&["n"], move |tables| {
                Some(Table::from(follows::unit(tables[0].vector()?.cross(of_normal(tables)?))?))
            }),
        _ => ask,
    };
    asks.into_iter().map(along).collect()
}
