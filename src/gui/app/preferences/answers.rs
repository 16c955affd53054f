//! Answers typed in exercises, a key for each: `"answers basis 3" = { u = ["1", "0", "0"], "is judged" = ["u"] }`.

use toml_edit::{Array, DocumentMut, InlineTable, Value};

use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::{Chosen, Typed};

/// The prefix of the keys.
const PREFIX: &str = "answers ";
/// The prefix of chosen values of open numbers. No ask has such a name.
const FREE: &str = "free ";
/// The key of answers judged as typed.
const JUDGED: &str = "is judged";
/// The key of guesses.
const GUESSED: &str = "is guessed";
/// All was answered rightly once.
const SOLVED: &str = "is solved";

/// The value of an exercise without typed answers, which marks answers taken back.
pub(in crate::gui) const NOTHING: &str = "{}";

/// Keys with their values as TOML.
pub(in crate::gui) fn values(learn: &Learn) -> impl Iterator<Item = (String, String)> + '_ {
    learn.exercises.typed.iter().map(|(Chosen { id, seed }, typed)| {
        let value = if typed.is_empty() { NOTHING.to_owned() } else { table(typed).to_string() };
        (format!("{PREFIX}{id} {seed}"), value)
    })
}

fn table(typed: &Typed) -> InlineTable {
    let mut table = InlineTable::new();
    for (name, fields) in typed.answers.iter().filter(|(_, fields)| fields.iter().any(|field| !field.is_empty())) {
        table.insert(name, fields.iter().map(String::as_str).collect::<Array>().into());
    }
    for (name, text) in typed.free.iter().filter(|(_, text)| !text.is_empty()) {
        table.insert(format!("{FREE}{name}"), text.as_str().into());
    }
    if !typed.judged.is_empty() {
        table.insert(JUDGED, typed.judged.iter().map(String::as_str).collect::<Array>().into());
    }
    if !typed.guesses.is_empty() {
        let guess = |(name, fields): (&String, &Vec<String>)| {
            (name.clone(), Value::from(fields.iter().map(String::as_str).collect::<Array>()))
        };
        table.insert(GUESSED, typed.guesses.iter().map(guess).collect::<InlineTable>().into());
    }
    table
}

/// The typed answers. Unreadable ones are ignored.
pub(in crate::gui) fn read(document: &DocumentMut) -> impl Iterator<Item = (Chosen, &InlineTable)> {
    document.iter().filter_map(|(key, item)| {
        let (id, seed) = key.strip_prefix(PREFIX)?.rsplit_once(' ')?;
        Some((Chosen { id: id.to_owned(), seed: seed.parse().ok()? }, item.as_inline_table()?))
    })
}

/// True if all questions were once answered correctly. Files of preferences had this key before there was a progress
/// file.
pub(in crate::gui) fn is_solved(table: &InlineTable) -> bool {
    table.get(SOLVED).and_then(Value::as_bool).unwrap_or_default()
}

/// Removes typed answers from preferences, which had them before there was a file of progress.
pub(in crate::gui) fn remove(document: &mut DocumentMut) {
    document.retain(|key, _| !key.starts_with(PREFIX));
}

/// The fields of an exercise.
pub(in crate::gui) fn typed(table: &InlineTable) -> Typed {
    let mut typed = Typed::default();
    for (name, value) in table {
        match (name.strip_prefix(FREE), value) {
            (Some(name), Value::String(text)) => drop(typed.free.insert(name.to_owned(), text.value().clone())),
            (None, Value::Array(texts)) => {
                let texts = texts.iter().filter_map(Value::as_str).map(str::to_owned);
                if name == JUDGED {
                    typed.judged = texts.collect();
                } else {
                    typed.answers.insert(name.to_owned(), texts.collect());
                }
            }
            (None, Value::InlineTable(guesses)) if name == GUESSED => {
                let guess = |(name, value): (&str, &Value)| {
                    let fields = value.as_array()?.iter().filter_map(Value::as_str).map(str::to_owned);
                    Some((name.to_owned(), fields.collect()))
                };
                typed.guesses = guesses.iter().filter_map(guess).collect();
            }
            _ => {}
        }
    }
    typed
}
