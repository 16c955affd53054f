//! [`Labels`] → the `[labels]` of a figure file.

use glam::DVec2;
use toml_edit::{Array, ArrayOfTables, InlineTable, Item, Table, Value};

use super::{number, quoted, table, vector};
use crate::appearance::Rgba;
use crate::figure::words::{self, DIMENSIONS, LETTERS, MEASURE_TEXTS};
use crate::figure::{
    LabelledMeasure, Labels, Letters, MeasureText, MovedLabel, Note, NotePlace, RenamedLabel, StyledLabel,
};

/// The section. Empty if every label is as the pictures make it.
pub(super) fn labels(labels: &Labels) -> Table {
    let Labels { letters, hidden, renamed, moved, styled, measures, notes } = labels;
    let mut keys: Vec<(&str, Value)> = Vec::new();
    if *letters != Letters::default() {
        keys.push(("letters", words::name(LETTERS, *letters).into()));
    }
    if !hidden.is_empty() {
        keys.push(("hidden", hidden.iter().map(|name| quoted(name)).collect::<Array>().into()));
    }
    let mut section = table(keys);
    let lists: [(&str, ArrayOfTables); 5] = [
        ("renamed", renamed.iter().map(of_renamed).collect()),
        ("moved", moved.iter().map(of_moved).collect()),
        ("styled", styled.iter().map(of_styled).collect()),
        ("measures", measures.iter().map(of_measure).collect()),
        ("notes", notes.iter().map(of_note).collect()),
    ];
    for (key, list) in lists.into_iter().filter(|(_, list)| !list.is_empty()) {
        section.insert(key, Item::ArrayOfTables(list));
    }
    section
}

fn pair(p: DVec2) -> Value {
    p.to_array().into_iter().map(number).collect::<Array>().into()
}

fn style(size: Option<f64>, color: Option<Rgba>) -> impl Iterator<Item = (&'static str, Value)> {
    let size = size.map(|size| ("size", number(size)));
    size.into_iter().chain(color.map(|color| ("color", color.to_string().into())))
}

fn of_styled(styled: &StyledLabel) -> Table {
    table([("name", quoted(&styled.name))].into_iter().chain(style(styled.size, styled.color)))
}

fn of_renamed(renamed: &RenamedLabel) -> Table {
    let view = renamed.view.map(|view| ("view", view.name().into()));
    table([("name", quoted(&renamed.name))].into_iter().chain(view).chain([("text", quoted(&renamed.text))]))
}

fn of_moved(moved: &MovedLabel) -> Table {
    let view = moved.view.map(|view| ("view", view.name().into()));
    table([("name", quoted(&moved.name))].into_iter().chain(view).chain([("by", pair(moved.by))]))
}

fn of_measure(measure: &LabelledMeasure) -> Table {
    let shown =
        (measure.shown != MeasureText::default()).then(|| ("as", words::name(MEASURE_TEXTS, measure.shown).into()));
    table([("name", words::name(DIMENSIONS, measure.measure).into())].into_iter().chain(shown))
}

fn of_note(note: &Note) -> Table {
    let of_mesh = |object: &str, key: &str, index: u32| {
        let keys = [("object", quoted(object)), (key, i64::from(index).into())];
        keys.into_iter().collect::<InlineTable>().into()
    };
    let at = match &note.at {
        NotePlace::World(p) => vector(*p),
        NotePlace::Picture(p) => pair(*p),
        NotePlace::Vertex { object, vertex } => of_mesh(object, "vertex", *vertex),
        NotePlace::Edge { object, edge } => of_mesh(object, "edge", *edge),
    };
    let view = note.view.map(|view| ("view", view.name().into()));
    let by = note.by.map(|by| ("by", pair(by)));
    let keys = view.into_iter().chain([("at", at)]).chain(by).chain([("text", quoted(&note.text))]);
    table(keys.chain(style(note.size, note.color)))
}
