//! One key of `[show]`, set from outside of a file.

use toml_edit::{DocumentMut, InlineTable, Item, TableLike, Value};

use crate::figure::error::{Allowed, Problem};
use crate::figure::write::document;
use crate::figure::{Figure, FigureError, Show, read};

/// The `[show]` section with one key set to a TOML value: `stage`, `"clip"`, or a part of one, `step.at`, `2.5`. A
/// value that is a plain word may lack its quotes; an empty one removes the key.
///
/// # Errors
/// [`FigureError`]: the key is not known, or the value is not among the allowed ones; its line is meaningless.
pub fn show_with(show: &Show, key: &str, value: &str) -> Result<Show, FigureError> {
    let mut document = document(&Figure { show: show.clone(), ..Figure::default() });
    let path: Vec<&str> = key.split('.').map(str::trim).collect();
    set(&mut document, &path, parsed(key, value)?);
    Ok(read::parse(&document.to_string())?.show)
}

fn parsed(key: &str, value: &str) -> Result<Option<Value>, FigureError> {
    let value = value.trim();
    let is_word = |text: &str| text.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | '/' | ' '));
    match value.parse::<Value>() {
        _ if value.is_empty() => Ok(None),
        Ok(value) => Ok(Some(value)),
        Err(_) if is_word(value) => Ok(Some(value.into())),
        Err(_) => {
            let problem = Problem::Value { found: crate::sanitize::escaped(value), allowed: Allowed::TomlValue };
            Err(FigureError { line: 1, key: format!("[show] {key}"), problem })
        }
    }
}

/// Puts a value where a path leads, through tables that are made where they are missing.
fn set(document: &mut DocumentMut, path: &[&str], value: Option<Value>) {
    let Some((last, tables)) = path.split_last() else { return };
    let mut table: &mut dyn TableLike = document.as_table_mut();
    for name in std::iter::once(&"show").chain(tables) {
        let is_section = *name == "show";
        let missing = || if is_section { toml_edit::table() } else { Item::Value(InlineTable::new().into()) };
        let item = table.entry(name).or_insert_with(missing);
        if item.as_table_like().is_none() {
            *item = missing();
        }
        match item.as_table_like_mut() {
            Some(next) => table = next,
            None => return,
        }
    }
    match value {
        Some(value) => drop(table.insert(last, Item::Value(value))),
        None => drop(table.remove(last)),
    }
}
