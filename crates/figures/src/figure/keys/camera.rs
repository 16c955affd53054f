//! `[camera]` and `[[cameras]]`. θ has three keys, of which a camera has one.

use toml_edit::TableLike;

use super::{Keys, inline};
use crate::camera::{Camera, LensForm, Parameters, Sensor, ViewWindow};
use crate::figure::error::Problem;
use crate::figure::value::{
    ANGLE, COLOR, HALF_TURN, NUMBER, NUMBER_OR_INFINITY, POSITIVE, POSITIVE_PAIR, VECTOR, line,
};
use crate::figure::words::{PROJECTIONS, SENSOR_FITS};
use crate::figure::{CameraTag, Figure, NamedCamera};
use crate::limits::{MAX_CAMERA_NAME, MAX_CAMERAS};

/// The keys of `[camera]` that each give θ, so a figure may have only one of them.
const WAYS_OF_THE_ANGLE: [&str; 3] = ["view_angle", "horizontal_angle", "lens"];

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

/// `[camera]`, with its optional name and color.
pub(super) fn current(keys: &mut Keys<'_>, figure: &mut Figure) {
    if keys.is_reading() {
        (figure.tag, figure.camera, figure.lens) = Default::default();
    }
    let CameraTag { name, color } = &mut figure.tag;
    keys.option("name", &line(MAX_CAMERA_NAME), name);
    keys.option("color", &COLOR, color);
    camera(keys, &mut figure.camera, &mut figure.lens);
}

/// `[[cameras]]`. `label` names the list in messages.
pub(super) fn cameras(keys: &mut Keys<'_>, label: &str, figure: &mut Figure) {
    let (current, parameters) = (figure.tag.name.clone(), Parameters::default());
    let blank = |_| NamedCamera { name: String::new(), color: None, parameters, lens: None };
    keys.list("cameras", label, MAX_CAMERAS, &mut figure.cameras, blank, |keys, other, before| {
        keys.needed("name", &line(MAX_CAMERA_NAME), &mut other.name);
        keys.option("color", &COLOR, &mut other.color);
        let mut names = before.iter().map(|camera| &camera.name).chain(&current);
        if let Some(section) = keys.reading()
            && names.any(|name| *name == other.name)
        {
            section.fault("name", Problem::Duplicate);
        }
        camera(keys, &mut other.parameters, &mut other.lens);
        keys.is_good()
    });
}

/// The keys of a camera, in a section that may have others. `lens` is the form in which the file gives θ.
pub(super) fn camera(keys: &mut Keys<'_>, p: &mut Parameters, lens: &mut Option<LensForm>) {
    // As long as it gives the angle of the camera.
    let form = lens.filter(|lens| lens.view_angle(p.aspect) == p.view_angle);
    let (mut across, mut focal) = match form {
        Some(LensForm::HorizontalAngle(degrees)) => (Some(degrees), None),
        Some(LensForm::FocalLength { focal_length, sensor }) => (None, Some((focal_length, sensor))),
        Some(LensForm::DiagonalAngle(_)) | None => (None, None),
    };
    keys.key("position", &VECTOR, &mut p.position);
    keys.key("focal_point", &VECTOR, &mut p.focal_point);
    keys.key("view_up", &VECTOR, &mut p.view_up);
    keys.word("projection", PROJECTIONS, &mut p.projection);
    keys.key_if("view_angle", across.is_none() && focal.is_none(), &ANGLE, &mut p.view_angle);
    keys.in_order(&["height", "aspect", "near", "far", "window"]);
    if let Some(section) = keys.reading() {
        let mut given = WAYS_OF_THE_ANGLE.into_iter().filter(|key| section.is_present(key));
        if let (Some(first), Some(second)) = (given.next(), given.next()) {
            section.fault(second, Problem::Rival { other: first, ways: &WAYS_OF_THE_ANGLE });
        }
    }
    keys.option("horizontal_angle", &HALF_TURN, &mut across);
    focal_length(keys, &mut focal);
    keys.key("height", &NUMBER, &mut p.height);
    keys.key("aspect", &NUMBER, &mut p.aspect);
    keys.key("near", &NUMBER, &mut p.near);
    keys.key("far", &NUMBER_OR_INFINITY, &mut p.far);
    window(keys, &mut p.window);
    if let Some(section) = keys.reading()
        && section.faults.is_empty()
    {
        let focal = focal.map(|(focal_length, sensor)| LensForm::FocalLength { focal_length, sensor });
        *lens = across.map(LensForm::HorizontalAngle).or(focal);
        p.view_angle = lens.map_or(p.view_angle, |lens| lens.view_angle(p.aspect));
        if let Err(error) = Camera::new(p) {
            let given = WAYS_OF_THE_ANGLE.into_iter().find(|way| section.is_present(way));
            let written = |key| if is_way_of_the_angle(key) { given.unwrap_or(key) } else { key };
            let concerned: Vec<&str> = error.parameters().iter().map(|key| written(key.name())).collect();
            let key = concerned.iter().find(|key| section.is_present(key)).or(concerned.first()).copied();
            section.fault(key.unwrap_or_default(), Problem::Camera(error));
        }
    }
}

/// `lens = { focal_length = 35.0, sensor = [36.0, 24.0], fit = "horizontal" }`.
fn focal_length(keys: &mut Keys<'_>, focal: &mut Option<(f64, Sensor)>) {
    let (label, usual) = (keys.label_of("lens"), Sensor::default());
    keys.optional("lens", &label, inline, focal, (50.0, usual), |keys, (focal_length, sensor)| {
        keys.needed("focal_length", &POSITIVE, focal_length);
        let mut sides = [sensor.width, sensor.height];
        keys.key("sensor", &POSITIVE_PAIR, &mut sides);
        [sensor.width, sensor.height] = sides;
        keys.word("fit", SENSOR_FITS, &mut sensor.fit);
    });
}

fn window(keys: &mut Keys<'_>, window: &mut Option<ViewWindow>) {
    let label = keys.label_of("window");
    let blank = ViewWindow { left: 0.0, right: 0.0, bottom: 0.0, top: 0.0 };
    keys.optional("window", &label, inline, window, blank, |keys, window| {
        let ViewWindow { left, right, bottom, top } = window;
        for (key, side) in [("left", left), ("right", right), ("bottom", bottom), ("top", top)] {
            keys.needed(key, &NUMBER, side);
        }
    });
}
