//! `[labels]`: the author's changes of labels, and notes. A faulty label is left out.

use glam::{DVec2, DVec3};
use toml_edit::{Array, Value};

use super::{Keys, UNIT};
use crate::appearance::Rgba;
use crate::figure::error::{Allowed, Problem};
use crate::figure::labels::{LabelTextError, set_text};
use crate::figure::read::Section;
use crate::figure::value::{COLOR, PAIR, TEXT, VECTOR, integer_in, line, number_in, quoted};
use crate::figure::words::{DIMENSIONS, LETTERS, MEASURE_TEXTS, PICTURES};

use crate::figure::{
    LabelledMeasure, Labels, Measure, MeasureText, MovedLabel, Note, NotePlace, RenamedLabel, StyledLabel,
};
use crate::limits::{LABEL_SIZE, MAX_LABEL_MOVE, MAX_LABEL_TEXT, MAX_LABELS};

const MOVES: [f64; 2] = [-MAX_LABEL_MOVE, MAX_LABEL_MOVE];

pub(super) fn labels(keys: &mut Keys<'_>, labels: &mut Labels) {
    keys.rare_word("letters", LETTERS, &mut labels.letters);
    keys.field(
        "hidden",
        !labels.hidden.is_empty(),
        &mut labels.hidden,
        |s, names| *names = hidden(s),
        |names| names.iter().map(|name| quoted(name)).collect::<Array>().into(),
    );
    let blank = |_| RenamedLabel { name: String::new(), view: None, text: String::new() };
    each(keys, "renamed", &mut labels.renamed, blank, |keys, label| {
        name(keys, &mut label.name);
        keys.choice("view", PICTURES, &mut label.view);
        text(keys, &mut label.text);
    });
    let blank = |_| MovedLabel { name: String::new(), view: None, by: DVec2::ZERO };
    each(keys, "moved", &mut labels.moved, blank, |keys, label| {
        name(keys, &mut label.name);
        keys.choice("view", PICTURES, &mut label.view);
        let mut by = Some(label.by);
        keys.require("by", Allowed::PairIn(-MAX_LABEL_MOVE, MAX_LABEL_MOVE));
        keys.pair_in("by", MOVES, &mut by);
        label.by = by.unwrap_or_default();
    });
    let blank = |_| StyledLabel { name: String::new(), size: None, color: None };
    each(keys, "styled", &mut labels.styled, blank, |keys, label| {
        name(keys, &mut label.name);
        style(keys, &mut label.size, &mut label.color);
    });
    let blank = |_| LabelledMeasure { measure: Measure::Near, shown: MeasureText::default() };
    each(keys, "measures", &mut labels.measures, blank, |keys, label| {
        keys.require("name", Allowed::word_of(DIMENSIONS));
        keys.word("name", DIMENSIONS, &mut label.measure);
        keys.rare_word("as", MEASURE_TEXTS, &mut label.shown);
    });
    let at = NotePlace::World(DVec3::ZERO);
    let blank = |_| Note { view: None, at: at.clone(), by: None, text: String::new(), size: None, color: None };
    each(keys, "notes", &mut labels.notes, blank, note);
}

/// The names of hidden labels.
fn hidden(section: &mut Section<'_>) -> Vec<String> {
    let names = section.list("hidden", Allowed::Texts, |name| {
        let is_name = !name.trim().is_empty() && name.chars().count() <= MAX_LABEL_TEXT;
        is_name.then(|| name.to_owned())
    });
    if let Some(count) = section.list_length("hidden").filter(|count| *count > MAX_LABELS) {
        section.fault("hidden", Problem::TooMany { count, limit: MAX_LABELS });
    }
    names
}

/// A list of labels.
fn each<'a, V>(
    keys: &mut Keys<'a>,
    key: &'static str,
    labels: &mut Vec<V>,
    blank: impl Fn(usize) -> V,
    visit: impl Fn(&mut Keys<'a>, &mut V),
) {
    keys.list(key, &format!("[[labels.{key}]]"), MAX_LABELS, labels, blank, |keys, label, _| {
        visit(keys, label);
        keys.is_good()
    });
}

fn name(keys: &mut Keys<'_>, name: &mut String) {
    keys.needed("name", &line(MAX_LABEL_TEXT), name);
}

/// The text of a label, whose formulas fit on its line.
fn text(keys: &mut Keys<'_>, text: &mut String) {
    keys.needed("text", &line(MAX_LABEL_TEXT), text);
    if let Some(section) = keys.reading()
        && !text.is_empty()
        && let Err(LabelTextError::Formula(error)) = set_text(text)
    {
        section.fault("text", Problem::Formula(error));
    }
}

fn style(keys: &mut Keys<'_>, size: &mut Option<f64>, color: &mut Option<Rgba>) {
    keys.option("size", &number_in([*LABEL_SIZE.start(), *LABEL_SIZE.end()]), size);
    keys.option("color", &COLOR, color);
}

fn note(keys: &mut Keys<'_>, note: &mut Note) {
    keys.choice("view", PICTURES, &mut note.view);
    keys.field("at", true, &mut note.at, |s, at| *at = read_place(s).unwrap_or_else(|| at.clone()), place);
    if matches!(note.at, NotePlace::Picture(_)) {
        keys.require("view", Allowed::word_of(PICTURES));
    }
    keys.pair_in("by", MOVES, &mut note.by);
    text(keys, &mut note.text);
    style(keys, &mut note.size, &mut note.color);
}

fn place(at: &NotePlace) -> Value {
    let of_mesh = |object: &str, key: &str, index: u32| {
        let keys = [("object", quoted(object)), (key, i64::from(index).into())];
        keys.into_iter().collect::<toml_edit::InlineTable>().into()
    };
    match at {
        NotePlace::World(p) => (VECTOR.write)(p),
        NotePlace::Picture(p) => (PAIR.write)(p),
        NotePlace::Vertex { object, vertex } => of_mesh(object, "vertex", *vertex),
        NotePlace::Edge { object, edge } => of_mesh(object, "edge", *edge),
    }
}

fn read_place(section: &mut Section<'_>) -> Option<NotePlace> {
    match section.list_length("at") {
        Some(3) => return Some(NotePlace::World(section.get("at", &VECTOR)?)),
        Some(_) => return section.pair_in("at", UNIT).map(NotePlace::Picture),
        None if !section.is_present("at") => {
            section.skip("at");
            section.missing("at", Allowed::NotePlace);
            return None;
        }
        None => {}
    }
    let mut inner = section.section("at", "[[labels.notes]] at.").there()?;
    inner.require("object", Allowed::Text);
    let (object, index) = (inner.get("object", &TEXT), integer_in([0, i64::from(u32::MAX)]));
    let at = match [inner.is_present("vertex"), inner.is_present("edge")] {
        [true, false] => {
            let index = inner.get("vertex", &index);
            object.zip(index).map(|(object, vertex)| NotePlace::Vertex { object, vertex })
        }
        [false, true] => {
            let index = inner.get("edge", &index);
            object.zip(index).map(|(object, edge)| NotePlace::Edge { object, edge })
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
    inner.good(at, &mut section.faults)
}
