//! The `[show]` of a figure file.

use glam::DVec3;

use super::camera;
use super::section::{Fault, Section, at_most};
use crate::camera::{Decomposition, Operation};
use crate::figure::error::{Allowed, Problem};
use crate::figure::words::{MEASURES, NDCS, STAGE_PICTURES, STAGES, TRIANGLE_STEPS, WAYS};
use crate::figure::{Show, ShownProbe, ShownStep, ShownTriangle, StagePicture, TransformPreview, TriangleStep};
use crate::geometry::Ray;
use crate::limits::MAX_SHOWN_OBJECTS;

/// Reads the section. A faulty key shows nothing.
pub(super) fn show(mut section: Section<'_>, faults: &mut Vec<Fault>) -> Show {
    let painted = section.optional_in("painted", 0.0, 1.0, 1.0);
    let [step_section, triangle_section, probe_section] =
        ["step", "triangle", "probe"].map(|key| section.section(key, &format!("[show] {key}.")));
    let answer_section = section.section("answer", "[show.answer]");
    let (stage, stage_of) =
        (section.choice("stage", STAGES), section.word("stage_of", STAGE_PICTURES, StagePicture::default()));
    let (measure, measure_of) = (section.words("measure", MEASURES), section.text("measure_of"));
    let ndc = section.choice("ndc", NDCS);
    let operations = operations(&mut section);
    let moved = section.sections("moved", "[[show.moved]]");
    faults.extend(section.finish());
    Show {
        stage,
        stage_of,
        painted,
        step: step(step_section, faults),
        triangle: triangle(triangle_section, faults),
        measure,
        measure_of,
        probe: probe(probe_section, faults),
        moved: previews(moved, faults),
        ndc,
        answer: answer_section.is_table().then(|| camera(answer_section, faults).0),
        operations,
    }
}

/// One operation, or several in a list.
fn operations(section: &mut Section<'_>) -> Vec<Operation> {
    let key = "operation";
    if !section.is_list(key) {
        let Some(text) = section.text(key) else { return Vec::new() };
        let operation = text.parse().ok();
        if operation.is_none() {
            section.refuse(key, Allowed::Operations);
        }
        return operation.into_iter().collect();
    }
    let operations: Vec<Operation> = section.list(key, Allowed::Operations, |text| text.parse().ok());
    let (count, limit) = (operations.len(), Show::MOST_OPERATIONS);
    if count > limit {
        section.fault(key, Problem::TooMany { count, limit });
        return Vec::new();
    }
    operations
}

fn step(section: Section<'_>, faults: &mut Vec<Fault>) -> Option<ShownStep> {
    let mut section = section.there()?;
    let way = section.word("way", WAYS, Decomposition::default());
    // In either projection, so that a figure can still be read after a change of it.
    let at = section.optional_in("at", 0.0, f64::from(way.most_steps()), 0.0);
    section.good(Some(ShownStep { way, at }), faults)
}

fn triangle(section: Section<'_>, faults: &mut Vec<Fault>) -> Option<ShownTriangle> {
    let mut section = section.there()?;
    let object = section.text("object");
    section.require("object", Allowed::Text);
    let index = section.integer("index", 0, i64::from(u32::MAX), 0);
    let step = section.word("step", TRIANGLE_STEPS, TriangleStep::default());
    let pixel = section.whole_pair("pixel", 0);
    section.good(object.map(|object| ShownTriangle { object, index, step, pixel }), faults)
}

fn probe(section: Section<'_>, faults: &mut Vec<Fault>) -> Option<ShownProbe> {
    let mut section = section.there()?;
    let given: Vec<&str> = ["world", "window", "pixel"].into_iter().filter(|key| section.is_present(key)).collect();
    let world = section.vector("world", DVec3::ZERO);
    let (window, pixel) = (section.pair("window"), section.whole_pair("pixel", i64::MIN));
    let found = match given.as_slice() {
        ["world"] => Some(ShownProbe::World(world)),
        ["window"] => window.map(ShownProbe::Window),
        ["pixel"] => pixel.map(ShownProbe::Pixel),
        [_, second, ..] => {
            section.refuse(second, Allowed::Either("world, window", "pixel"));
            None
        }
        [] | [_] => {
            section.missing("world", Allowed::Vector);
            None
        }
    };
    section.good(found, faults)
}

fn previews(sections: Vec<Section<'_>>, faults: &mut Vec<Fault>) -> Vec<TransformPreview> {
    let sections = at_most(sections, MAX_SHOWN_OBJECTS, "[[show.moved]]", faults);
    sections.into_iter().filter_map(|section| preview(section, faults)).collect()
}

fn preview(mut section: Section<'_>, faults: &mut Vec<Fault>) -> Option<TransformPreview> {
    for key in ["change", "frame"] {
        section.require(key, Allowed::Matrix);
    }
    let (change, frame) = (section.matrix("change"), section.matrix("frame"));
    let objects = section.list("objects", Allowed::Texts, |name| Some(name.to_owned())).into_iter().collect();
    let wrong = section.switch("wrong");
    let axis = axis(section.section("axis", "[[show.moved]] axis."), faults);
    let found = change.zip(frame).map(|(change, world_from_frame)| TransformPreview {
        objects,
        change,
        world_from_frame,
        axis,
        wrong,
    });
    section.good(found, faults)
}

fn axis(section: Section<'_>, faults: &mut Vec<Fault>) -> Option<Ray> {
    let mut section = section.there()?;
    let origin = section.vector("origin", DVec3::ZERO);
    let direction = section.vector("direction", DVec3::Y);
    if direction == DVec3::ZERO {
        section.refuse("direction", Allowed::NonZeroVector);
    }
    // As written, if it's a unit vector except for rounding.
    let length = direction.length();
    let direction = if (length - 1.0).abs() < 1e-12 { direction } else { direction.normalize_or_zero() };
    section.good(Some(Ray { origin, direction }), faults)
}
