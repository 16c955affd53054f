//! Sets one key of a figure from outside its file.

use toml_edit::{DocumentMut, InlineTable, Item, TableLike, Value};

use crate::figure::error::{Allowed, Problem};
use crate::figure::keys::remove_rivals;
use crate::figure::value::NOTHING;
use crate::figure::{Figure, FigureError, Show, read, write};

/// The figure with one key set to a TOML value: `style.shading`, `"flat"`, or a part of one, `show.step.at`, `2.5`. A
/// value that's a plain word may lack its quotes. An empty one removes the key.
///
/// # Errors
/// [`FigureError`] if the key isn't known, or the value isn't allowed. Its line is meaningless.
pub fn varied(figure: &Figure, key: &str, value: &str) -> Result<Figure, FigureError> {
    varied_together(figure, &[(key, value)])
}

/// Like [`varied`], for several keys together. For example, near and far may both move past the other.
///
/// # Errors
/// As for [`varied`].
pub fn varied_together(figure: &Figure, keys: &[(&str, &str)]) -> Result<Figure, FigureError> {
    let mut sections: Vec<&str> = keys.iter().map(|(key, _)| section_of(key)).collect();
    // The names of cameras differ, and a comparison refers to one.
    if sections.contains(&"camera") && !figure.cameras.is_empty() {
        sections.push("cameras");
    }
    if sections.contains(&"cameras") {
        sections.push("compare");
    }
    let mut document = write::sections(figure, &sections, false);
    for (key, value) in keys {
        let path: Vec<&str> = key.split('.').map(str::trim).collect();
        let value = parsed(key, value)?;
        if let ["camera", way, ..] = path[..]
            && value.is_some()
            && let Some(camera) = document.get_mut("camera").and_then(Item::as_table_like_mut)
        {
            remove_rivals(camera, way);
        }
        set(&mut document, &path, value);
    }
    read::reread(figure, &sections, &document)
}

/// True if a key of the figure has a value, in the form that [`varied`] takes, so that setting it changes nothing.
pub fn has(figure: &Figure, key: &str, value: &str) -> bool {
    varied(figure, key, value).is_ok_and(|varied| varied == *figure)
}

/// The number of a key of the figure; `None` if there is none. A way of `show.step` without a place has gone to its
/// end, ∞.
pub fn number_at(figure: &Figure, key: &str) -> Option<f64> {
    let at_end = || (key == "show.step.at" && figure.show.step.is_some()).then_some(f64::INFINITY);
    // The file may give a lens instead.
    let angle = || (key == "camera.view_angle").then_some(figure.camera.view_angle);
    let Some(value) = value_of(figure, key, false) else { return angle().or_else(at_end) };
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

/// The section of a key, or the key itself.
fn section_of(key: &str) -> &str {
    key.split('.').next().unwrap_or_default().trim()
}

/// The `[show]` section with one key set, as [`varied`] sets it: `stage`, `"clip"`.
///
/// # Errors
/// As for [`varied`].
pub fn show_with(show: &Show, key: &str, value: &str) -> Result<Show, FigureError> {
    let figure = Figure { show: show.clone(), ..Figure::default() };
    Ok(varied(&figure, &format!("show.{key}"), value)?.show)
}

/// The value of a key in the text of a figure; `None` if the text has none. With `every`, the usual values count too.
pub(in crate::figure) fn value_of(figure: &Figure, key: &str, every: bool) -> Option<Value> {
    let document = write::sections(figure, &[section_of(key)], every);
    let mut item = document.as_item();
    for name in key.split('.') {
        item = item.as_table_like()?.get(name.trim())?;
    }
    item.as_value().cloned()
}

fn parsed(key: &str, value: &str) -> Result<Option<Value>, FigureError> {
    let value = value.trim();
    let is_word = |text: &str| text.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | '/' | ' '));
    match value.parse::<Value>() {
        _ if matches!(value, "" | NOTHING) => Ok(None),
        Ok(value) => Ok(Some(value)),
        Err(_) if is_word(value) => Ok(Some(value.into())),
        Err(_) => {
            let problem = Problem::Value { found: crate::sanitize::escaped(value), allowed: Allowed::TomlValue };
            let key = key.split_once('.').map_or_else(|| key.to_owned(), |(section, key)| format!("[{section}] {key}"));
            Err(FigureError { line: 1, key, problem })
        }
    }
}

/// Puts a value at the end of a path, creating tables that don't exist.
fn set(document: &mut DocumentMut, path: &[&str], value: Option<Value>) {
    let Some((last, tables)) = path.split_last() else { return };
    let mut table: &mut dyn TableLike = document.as_table_mut();
    for (depth, name) in tables.iter().enumerate() {
        let missing = || if depth == 0 { toml_edit::table() } else { Item::Value(InlineTable::new().into()) };
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
