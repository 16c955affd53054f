//! The `[[points]]` of a figure file.

use glam::DVec3;

use super::section::{Fault, Section, at_most};
use crate::figure::error::{Allowed, Problem};
use crate::figure::points::{NamedPoint, may_be_named};
use crate::limits::MAX_NAMED_POINTS;

/// Reads the points. Points without a name or position are left out, with a fault.
pub(super) fn points(sections: Vec<Section<'_>>, faults: &mut Vec<Fault>) -> Vec<NamedPoint> {
    let mut found = Vec::new();
    for section in at_most(sections, MAX_NAMED_POINTS, "[[points]]", faults) {
        let point = point(section, &found, faults);
        found.extend(point);
    }
    found
}

fn point(mut section: Section<'_>, before: &[NamedPoint], faults: &mut Vec<Fault>) -> Option<NamedPoint> {
    section.require("name", Allowed::Text);
    section.require("position", Allowed::Vector);
    let name = section.text("name");
    let position = section.vector("position", DVec3::ZERO);
    if name.as_ref().is_some_and(|name| !may_be_named(name, before.iter())) {
        section.fault("name", Problem::Duplicate);
    }
    section.good(name.map(|name| NamedPoint { name, position }), faults)
}
