//! The text of a figure file → [`Figure`].

mod section;
mod stacked;
mod syntax;

use std::ops::Range;

use toml_edit::{Document, DocumentMut, TableLike};

use super::error::{FigureError, Problem};
use super::keys::{self, Keys};
use super::value::{TEXT, quoted};
use super::{Comparison, Figure};
use crate::camera::CameraError;
use crate::limits::MAX_FIGURE_BYTES;
use crate::sanitize;
pub use section::{Fault, Section, at_most};
pub use stacked::Stacked;

/// Reads the bytes of a figure file, or any other bytes.
///
/// # Errors
/// [`FigureError`] names the first faulty line.
pub fn parse_bytes(bytes: &[u8]) -> Result<Figure, FigureError> {
    parse(text_of(bytes, MAX_FIGURE_BYTES)?)
}

/// The text of a file of at most `limit` bytes.
///
/// # Errors
/// [`FigureError`] if it's too large, or isn't UTF-8.
pub fn text_of(bytes: &[u8], limit: usize) -> Result<&str, FigureError> {
    let fault = |line, problem| FigureError { line, key: String::new(), problem };
    if bytes.len() > limit {
        return Err(fault(1, Problem::TooLarge { limit }));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let good = error.valid_up_to();
        let line = 1 + bytes[..good].iter().filter(|b| **b == b'\n').count();
        fault(line, Problem::NotUtf8 { byte: bytes[good] })
    })
}

/// Reads a file of another kind, with sections of its own, which may contain a figure.
///
/// # Errors
/// [`FigureError`] names the first faulty line.
pub fn parse_with<T>(text: &str, read: impl FnOnce(Section<'_>, &mut Vec<Fault>) -> T) -> Result<T, FigureError> {
    let (found, _) = parse_but(text, read, |_| false)?;
    Ok(found)
}

/// Like [`parse_with`], but returns the `excused` faults.
fn parse_but<T>(
    text: &str,
    read: impl FnOnce(Section<'_>, &mut Vec<Fault>) -> T,
    excused: impl FnMut(&Fault) -> bool,
) -> Result<(T, Vec<Fault>), FigureError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let document = Document::parse(text).map_err(|error| syntax::explain(text, &error))?;
    let mut faults = Vec::new();
    let root = Section::new(text, Some(document.as_table() as &dyn TableLike), "", 0).with_homes(keys::home);
    let found = read(root, &mut faults);
    let (excused, faults): (Vec<Fault>, Vec<Fault>) = faults.into_iter().partition(excused);
    match faults.into_iter().min_by_key(|fault| fault.at) {
        Some(Fault { at, key, problem }) => Err(FigureError { line: line_of(text, at), key, problem }),
        None => Ok((found, excused)),
    }
}

/// Reads a figure file. A missing key has its default. The empty text is the default figure.
///
/// # Guarantees
/// The camera of the figure is one that [`Camera::new`](crate::camera::Camera::new) accepts.
///
/// # Errors
/// [`FigureError`] names the first faulty line: the line, the key, the value found and the values allowed.
pub fn parse(text: &str) -> Result<Figure, FigureError> {
    parse_with(text, figure)
}

/// Like [`parse`], but skips unknown keys, which a later version may have written. It returns them.
///
/// # Errors
/// As for [`parse`].
pub fn parse_known(text: &str) -> Result<(Figure, Vec<String>), FigureError> {
    let (figure, unknown) = parse_but(text, figure, Fault::is_unknown_key)?;
    Ok((figure, unknown.into_iter().map(|fault| fault.key).collect()))
}

/// Like [`parse`], but an impossible camera isn't a fault. Its error comes with the figure.
///
/// # Errors
/// As for [`parse`], except for [`Problem::Camera`].
pub fn parse_with_any_camera(text: &str) -> Result<(Figure, Option<CameraError>), FigureError> {
    let is_camera = |fault: &Fault| matches!(fault.problem, Problem::Camera(_)) && fault.key.starts_with("[camera]");
    let (figure, faults) = parse_but(text, figure, is_camera)?;
    let error = faults.into_iter().find_map(|fault| match fault.problem {
        Problem::Camera(error) => Some(error),
        _ => None,
    });
    Ok((figure, error))
}

/// The figure whose sections are in a section, which is a file or a part of one.
pub fn figure(root: Section<'_>, faults: &mut Vec<Fault>) -> Figure {
    let mut figure = Figure::default();
    let mut keys = Keys::read(root);
    keys::figure(&mut keys, &mut figure);
    keys.finish(faults);
    figure
}

/// The figure with some of its sections read again from a document. The line of an error is meaningless.
pub(super) fn reread(figure: &Figure, sections: &[&str], document: &DocumentMut) -> Result<Figure, FigureError> {
    let read = |root: Section<'_>, faults: &mut Vec<Fault>| {
        let mut figure = figure.clone();
        let mut keys = Keys::read(root).only(sections);
        keys::figure(&mut keys, &mut figure);
        keys.finish(faults);
        figure
    };
    let mut faults = Vec::new();
    let found = read(Section::new("", Some(document.as_table()), "", 0), &mut faults);
    // Only a text has the values as written, for the message.
    if faults.is_empty() { Ok(found) } else { parse_with(&document.to_string(), read) }
}

/// A comparison of one key as the user types it, `camera.near = 0.5`. A value that's a plain word may lack its quotes.
///
/// # Errors
/// The same as for a figure file with this comparison. The line is meaningless.
pub fn typed_comparison(text: &str) -> Result<Comparison, FigureError> {
    let (key, value) = text.split_once('=').unwrap_or((text, ""));
    let (key, value) = (key.trim(), value.trim());
    let is_word = !value.is_empty() && value.chars().all(|c| c.is_ascii_alphabetic() || c == '-');
    let value =
        if is_word && !matches!(value, "true" | "false") { quoted(value).to_string() } else { value.to_owned() };
    let fault = |problem| FigureError { line: 1, key: format!("[compare] with.{}", sanitize::escaped(key)), problem };
    keys::checked(key, &value, &[]).map_err(fault)?;
    Ok(Comparison::of_key(key, &value))
}

/// The line of a key of the object called `name` (of the object itself, if the key is missing), counted from 1; `None`
/// if the text lists no such object.
pub fn line_of_object(text: &str, name: &str, key: &str) -> Option<usize> {
    let document = Document::parse(text.strip_prefix('\u{feff}').unwrap_or(text)).ok()?;
    let mut root = Section::new(text, Some(document.as_table()), "", 0);
    let objects = root.section("scene", "").sections("objects", "");
    let found = objects.into_iter().enumerate().find_map(|(i, mut object)| {
        let called = object.get("name", &TEXT).unwrap_or_else(|| keys::default_name(i));
        (called == name).then_some(object)
    })?;
    Some(line_of(document.raw(), found.place(key).unwrap_or(found.at)))
}

/// The line of a place in the text, counted from 1.
pub fn line_of(text: &str, at: usize) -> usize {
    1 + text.as_bytes()[..at.min(text.len())].iter().filter(|b| **b == b'\n').count()
}

/// A piece of the text that fits into a sentence: one line, no control characters, not long.
fn snippet(text: &str, span: Range<usize>) -> String {
    let piece = text.get(span).unwrap_or_default();
    sanitize::escaped(&piece.split_whitespace().collect::<Vec<_>>().join(" "))
}

#[cfg(test)]
mod tests;
