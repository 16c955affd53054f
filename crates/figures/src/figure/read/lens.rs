//! `[camera] horizontal_angle` and `lens`: other ways to give θ.

use toml_edit::TableLike;

use super::section::{Fault, Section};
use crate::camera::{LensForm, Sensor, SensorFit};
use crate::figure::error::{Allowed, Problem};
use crate::figure::words::SENSOR_FITS;

/// The keys of `[camera]` that each give θ, so a figure may have only one of them.
pub(in crate::figure) const WAYS_OF_THE_ANGLE: [&str; 3] = ["view_angle", "horizontal_angle", "lens"];

/// True for a key of `[camera]` that gives θ.
pub(in crate::figure) fn is_way_of_the_angle(key: &str) -> bool {
    WAYS_OF_THE_ANGLE.contains(&key)
}

/// Removes the other ways to give θ from `[camera]`, if `key` is one.
pub(in crate::figure) fn remove_rivals(camera: &mut dyn TableLike, key: &str) {
    if is_way_of_the_angle(key) {
        WAYS_OF_THE_ANGLE.into_iter().filter(|way| *way != key).for_each(|way| drop(camera.remove(way)));
    }
}

/// The lens, unless the section has `view_angle` or none of these keys.
pub(super) fn lens(camera: &mut Section<'_>, faults: &mut Vec<Fault>) -> Option<LensForm> {
    let mut given = WAYS_OF_THE_ANGLE.into_iter().filter(|key| camera.is_present(key));
    if let (Some(first), Some(second)) = (given.next(), given.next()) {
        camera.fault(second, Problem::Rival { other: first, ways: &WAYS_OF_THE_ANGLE });
    }
    let angle = camera.angle_of_half_turn("horizontal_angle");
    angle.map(LensForm::HorizontalAngle).or(focal_length(camera, faults))
}

/// `lens = { focal_length = 35.0, sensor = [36.0, 24.0], fit = "horizontal" }`.
fn focal_length(camera: &mut Section<'_>, faults: &mut Vec<Fault>) -> Option<LensForm> {
    let mut section = camera.section("lens", &format!("{}.", camera.name_of("lens"))).there()?;
    let usual = Sensor::default();
    let focal_length = section.positive("focal_length", 50.0);
    section.require("focal_length", Allowed::PositiveNumber);
    let [width, height] = section.positive_pair("sensor", [usual.width, usual.height]);
    let fit = section.word("fit", SENSOR_FITS, SensorFit::default());
    let found = section.finish();
    let good = found.is_empty();
    faults.extend(found);
    good.then_some(LensForm::FocalLength { focal_length, sensor: Sensor { width, height, fit } })
}
