//! Sets one key of a figure from outside its file.

use toml_edit::{DocumentMut, InlineTable, Item, TableLike, Value};

use crate::figure::error::{Allowed, Problem};
use crate::figure::write::document;
use crate::figure::{Figure, FigureError, Show, read};

/// A value that removes its key, for a file that has to give one.
pub(in crate::figure) const NOTHING: &str = "\"\"";

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
    // A scene can be large, and most keys are elsewhere.
    let of_scene = keys.iter().map(|(key, _)| *key).find(|key| is_of_scene(key));
    let whole = without_other_scene(figure, of_scene.unwrap_or_default());
    let varied = varied_whole(&whole, keys.iter().copied())?;
    Ok(if of_scene.is_some() { varied } else { Figure { scene: figure.scene.clone(), ..varied } })
}

/// True if a key of the figure has a value, in the form that [`varied`] takes, so that setting it changes nothing.
pub fn has(figure: &Figure, key: &str, value: &str) -> bool {
    let own = without_other_scene(figure, key);
    varied_whole(&own, [(key, value)]).is_ok_and(|varied| varied == own)
}

/// The number of a key of the figure; `None` if there is none. A way of `show.step` without a place has gone to its
/// end, ∞.
pub fn number_at(figure: &Figure, key: &str) -> Option<f64> {
    let document = document(&without_other_scene(figure, key));
    let at_end = || (key == "show.step.at" && figure.show.step.is_some()).then_some(f64::INFINITY);
    // The file may give a lens instead.
    let angle = || (key == "camera.view_angle").then_some(figure.camera.view_angle);
    let Some(value) = value_of(&document, key) else { return angle().or_else(at_end) };
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

/// The figure without its scene, which can be large, if a key is elsewhere.
fn without_other_scene(figure: &Figure, key: &str) -> Figure {
    if is_of_scene(key) {
        return figure.clone();
    }
    let (observers, show) = (figure.observers, figure.show.clone());
    Figure { observers, show, ..figure.without_scene() }
}

fn is_of_scene(key: &str) -> bool {
    key.split('.').next().is_some_and(|section| section.trim() == "scene")
}

/// Like [`varied_together`], for a figure with a small scene.
pub(in crate::figure) fn varied_whole<'a>(
    figure: &Figure,
    keys: impl IntoIterator<Item = (&'a str, &'a str)>,
) -> Result<Figure, FigureError> {
    let mut document = document(figure);
    for (key, value) in keys {
        let path: Vec<&str> = key.split('.').map(str::trim).collect();
        let value = parsed(key, value)?;
        if let ["camera", way, ..] = path[..]
            && value.is_some()
            && let Some(camera) = document.get_mut("camera").and_then(Item::as_table_like_mut)
        {
            read::remove_rivals(camera, way);
        }
        set(&mut document, &path, value);
    }
    read::parse(&document.to_string())
}

/// The `[show]` section with one key set, as [`varied`] sets it: `stage`, `"clip"`.
///
/// # Errors
/// As for [`varied`].
pub fn show_with(show: &Show, key: &str, value: &str) -> Result<Show, FigureError> {
    let figure = Figure { show: show.clone(), ..Figure::default() };
    Ok(varied_whole(&figure, [(&*format!("show.{key}"), value)])?.show)
}

/// The value of a key in the text of a figure; `None` if the text has none.
pub(in crate::figure) fn value_of(document: &DocumentMut, key: &str) -> Option<Value> {
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
