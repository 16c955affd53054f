//! The `[labels]` of a figure file.

use glam::DVec3;

use super::section::{Fault, Section, at_most};
use crate::figure::error::{Allowed, Problem};
use crate::figure::labels::{LabelTextError, set_text};
use crate::figure::words::{DIMENSIONS, LETTERS, MEASURE_TEXTS, PICTURES};
use crate::figure::{
    LabelledMeasure, Labels, Letters, MeasureText, MovedLabel, Note, NotePlace, RenamedLabel, StyledLabel,
};
use crate::limits::{LABEL_SIZE, MAX_LABEL_MOVE, MAX_LABEL_TEXT, MAX_LABELS};

/// Reads the section. A faulty label is left out, with a fault.
pub(super) fn labels(mut section: Section<'_>, faults: &mut Vec<Fault>) -> Labels {
    let letters = section.word("letters", LETTERS, Letters::default());
    let hidden = section.list("hidden", Allowed::Texts, |name| {
        let is_name = !name.trim().is_empty() && name.chars().count() <= MAX_LABEL_TEXT;
        is_name.then(|| name.to_owned())
    });
    if let Some(count) = section.list_length("hidden").filter(|count| *count > MAX_LABELS) {
        section.fault("hidden", Problem::TooMany { count, limit: MAX_LABELS });
    }
    let lists = ["renamed", "moved", "styled", "measures", "notes"]
        .map(|key| section.sections(key, &format!("[[labels.{key}]]")));
    faults.extend(section.finish());
    let [renamed_list, moved_list, styled_list, measures, notes] = lists;
    Labels {
        letters,
        hidden,
        renamed: each(renamed_list, "renamed", faults, renamed),
        moved: each(moved_list, "moved", faults, moved),
        styled: each(styled_list, "styled", faults, styled),
        measures: each(measures, "measures", faults, measure),
        notes: each(notes, "notes", faults, note),
    }
}

/// Reads each section of a list, or none if there are too many.
fn each<'a, T>(
    sections: Vec<Section<'a>>,
    key: &str,
    faults: &mut Vec<Fault>,
    read: fn(&mut Section<'a>, &mut Vec<Fault>) -> Option<T>,
) -> Vec<T> {
    let sections = at_most(sections, MAX_LABELS, &format!("[[labels.{key}]]"), faults);
    let one = |mut section: Section<'a>| {
        let found = read(&mut section, faults);
        section.good(found, faults)
    };
    sections.into_iter().filter_map(one).collect()
}

/// A required line.
fn needed(section: &mut Section<'_>, key: &'static str) -> Option<String> {
    section.require(key, Allowed::Line { limit: MAX_LABEL_TEXT });
    section.line(key, MAX_LABEL_TEXT)
}

/// The text of a label, whose formulas fit on its line.
fn text(section: &mut Section<'_>) -> Option<String> {
    let text = needed(section, "text")?;
    if let Err(LabelTextError::Formula(error)) = set_text(&text) {
        section.fault("text", Problem::Formula(error));
    }
    Some(text)
}

fn renamed(section: &mut Section<'_>, _: &mut Vec<Fault>) -> Option<RenamedLabel> {
    let (name, view, text) = (needed(section, "name"), section.choice("view", PICTURES), text(section));
    Some(RenamedLabel { name: name?, view, text: text? })
}

fn moved(section: &mut Section<'_>, _: &mut Vec<Fault>) -> Option<MovedLabel> {
    let name = needed(section, "name");
    let view = section.choice("view", PICTURES);
    section.require("by", Allowed::PairIn(-MAX_LABEL_MOVE, MAX_LABEL_MOVE));
    let by = section.pair_in("by", -MAX_LABEL_MOVE, MAX_LABEL_MOVE);
    Some(MovedLabel { name: name?, view, by: by? })
}

fn size(section: &mut Section<'_>) -> Option<f64> {
    section.optional_in("size", *LABEL_SIZE.start(), *LABEL_SIZE.end(), 1.0)
}

fn styled(section: &mut Section<'_>, _: &mut Vec<Fault>) -> Option<StyledLabel> {
    let (name, size, color) = (needed(section, "name"), size(section), section.color("color"));
    Some(StyledLabel { name: name?, size, color })
}

fn measure(section: &mut Section<'_>, _: &mut Vec<Fault>) -> Option<LabelledMeasure> {
    section.require("name", Allowed::word_of(DIMENSIONS));
    let measure = section.choice("name", DIMENSIONS);
    let shown = section.word("as", MEASURE_TEXTS, MeasureText::default());
    Some(LabelledMeasure { measure: measure?, shown })
}

fn note(section: &mut Section<'_>, faults: &mut Vec<Fault>) -> Option<Note> {
    let view = section.choice("view", PICTURES);
    let at = place(section, faults);
    if matches!(at, Some(NotePlace::Picture(_))) {
        section.require("view", Allowed::word_of(PICTURES));
    }
    let by = section.pair_in("by", -MAX_LABEL_MOVE, MAX_LABEL_MOVE);
    let (text, size, color) = (text(section), size(section), section.color("color"));
    Some(Note { view, at: at?, by, text: text?, size, color })
}

fn place(section: &mut Section<'_>, faults: &mut Vec<Fault>) -> Option<NotePlace> {
    match section.list_length("at") {
        Some(3) => return Some(NotePlace::World(section.vector("at", DVec3::ZERO))),
        Some(_) => return section.pair_in("at", 0.0, 1.0).map(NotePlace::Picture),
        None if !section.is_present("at") => {
            section.missing("at", Allowed::NotePlace);
            return None;
        }
        None => {}
    }
    let mut inner = section.section("at", "[[labels.notes]] at.").there()?;
    inner.require("object", Allowed::Text);
    let object = inner.text("object");
    let at = match [inner.is_present("vertex"), inner.is_present("edge")] {
        [true, false] => {
            let vertex = inner.integer("vertex", 0, i64::from(u32::MAX), 0);
            object.map(|object| NotePlace::Vertex { object, vertex })
        }
        [false, true] => {
            let edge = inner.integer("edge", 0, i64::from(u32::MAX), 0);
            object.map(|object| NotePlace::Edge { object, edge })
        }
        [true, true] => {
            inner.skip("vertex");
            inner.skip("edge");
            inner.refuse("edge", Allowed::Either("vertex", "edge"));
            None
        }
        [false, false] => {
            inner.missing("vertex", Allowed::Either("vertex", "edge"));
            None
        }
    };
    inner.good(at, faults)
}
