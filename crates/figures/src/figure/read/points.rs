//! The `[[points]]` of a figure file.

use glam::DVec3;

use super::section::{Fault, Section};
use crate::figure::error::{Allowed, Problem};
use crate::figure::points::{NamedPoint, may_be_named};
use crate::limits::MAX_NAMED_POINTS;

/// Reads the points. Those that have no name or position are left out, with a fault.
pub(super) fn points(sections: Vec<Section<'_>>, faults: &mut Vec<Fault>) -> Vec<NamedPoint> {
    if let Some(beyond) = sections.get(MAX_NAMED_POINTS) {
        let problem = Problem::TooMany { count: sections.len(), limit: MAX_NAMED_POINTS };
        faults.push(Fault { at: beyond.start(), key: "[[points]]".to_owned(), problem });
        return Vec::new();
    }
    let mut found = Vec::new();
    for section in sections {
        let point = point(section, &found, faults);
        found.extend(point);
    }
    found
}

fn point(mut section: Section<'_>, before: &[NamedPoint], faults: &mut Vec<Fault>) -> Option<NamedPoint> {
    for (key, allowed) in [("name", Allowed::Text), ("position", Allowed::Vector)] {
        if !section.is_present(key) {
            section.missing(key, allowed);
        }
    }
    let name = section.text("name");
    let position = section.vector("position", DVec3::ZERO);
    if name.as_ref().is_some_and(|name| !may_be_named(name, before.iter())) {
        section.fault("name", Problem::Duplicate);
    }
    let found = section.finish();
    let good = found.iter().all(Fault::is_unknown_key);
    faults.extend(found);
    name.filter(|_| good).map(|name| NamedPoint { name, position })
}
