//! The `[[cameras]]` of a figure file, and the name and color of its `[camera]`.

use super::camera_keys;
use super::section::{Fault, Section, at_most};
use crate::camera::{LensForm, Parameters};
use crate::figure::error::{Allowed, Problem};
use crate::figure::{CameraTag, NamedCamera};
use crate::limits::{MAX_CAMERA_NAME, MAX_CAMERAS};

/// Reads `[camera]`.
pub(super) fn current(mut section: Section<'_>, faults: &mut Vec<Fault>) -> (CameraTag, Parameters, Option<LensForm>) {
    let tag = tag(&mut section);
    let (parameters, lens) = camera_keys(&mut section, faults);
    faults.extend(section.finish());
    (tag, parameters, lens)
}

/// Reads the list. A camera that has no name or is impossible is left out, with a fault.
pub(super) fn cameras(sections: Vec<Section<'_>>, current: &CameraTag, faults: &mut Vec<Fault>) -> Vec<NamedCamera> {
    let mut names: Vec<String> = current.name.iter().cloned().collect();
    let mut found = Vec::new();
    for section in at_most(sections, MAX_CAMERAS, "[[cameras]]", faults) {
        let camera = camera(section, &names, faults);
        names.extend(camera.iter().map(|camera| camera.name.clone()));
        found.extend(camera);
    }
    found
}

fn tag(section: &mut Section<'_>) -> CameraTag {
    CameraTag { name: section.line("name", MAX_CAMERA_NAME), color: section.color("color") }
}

fn camera(mut section: Section<'_>, before: &[String], faults: &mut Vec<Fault>) -> Option<NamedCamera> {
    let CameraTag { name, color } = tag(&mut section);
    section.require("name", Allowed::Line { limit: MAX_CAMERA_NAME });
    if name.as_ref().is_some_and(|name| before.contains(name)) {
        section.fault("name", Problem::Duplicate);
    }
    let (parameters, lens) = camera_keys(&mut section, faults);
    section.good(name.map(|name| NamedCamera { name, color, parameters, lens }), faults)
}
