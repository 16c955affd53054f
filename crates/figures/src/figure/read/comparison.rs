//! The `[compare]` of a figure file.

use super::parse;
use super::section::{Fault, Section};
use crate::camera::Operation;
use crate::figure::edit::NOTHING;
use crate::figure::error::{Allowed, FigureError, Problem};
use crate::figure::near;
use crate::figure::write::quoted;
use crate::figure::{Comparison, NamedCamera};
use crate::limits::MAX_COMPARED_KEYS;
use crate::sanitize;

/// The sections whose keys can be compared. The scene, its points and the observers are the same on both sides.
const SECTIONS: [&str; 7] = ["camera", "image", "viewport", "style", "reveal", "world", "show"];

/// Reads the section; `None` if there is none, or nothing to compare.
pub(super) fn comparison(
    mut section: Section<'_>,
    cameras: &[NamedCamera],
    faults: &mut Vec<Fault>,
) -> Option<Comparison> {
    let is_there = section.is_table();
    let entries = section.entries("with");
    let mut with: Vec<(String, String)> = Vec::new();
    for (key, value, at) in entries.clone() {
        match checked(&key, &value, &entries) {
            Ok(()) => {
                with.retain(|(other, _)| *other != key);
                with.push((key, value));
            }
            Err(problem) => {
                let key = section.name_of(&format!("with.{}", sanitize::escaped(&key)));
                section.faults.push(Fault { at, key, problem });
            }
        }
    }
    let ops: Vec<Operation> = section.list("ops", Allowed::Operations, |text| text.parse().ok());
    let camera = section.text("camera");
    if camera.as_ref().is_some_and(|name| cameras.iter().all(|camera| camera.name != *name)) {
        section.refuse("camera", Allowed::Camera);
    }
    let wiper = section.number_in("wiper", 0.0, 1.0, 0.5);
    let beside = section.word("layout", &[("wiper", false), ("beside", true)], false);
    let differences = section.switch("differences");
    let count = with.len() + ops.len() + usize::from(camera.is_some());
    if is_there && count == 0 && section.faults.is_empty() {
        section.missing("with", Allowed::Section);
    } else if count > MAX_COMPARED_KEYS {
        let key = if with.is_empty() { "ops" } else { "with" };
        section.fault(key, Problem::TooMany { count, limit: MAX_COMPARED_KEYS });
    }
    let is_good = section.is_good(faults);
    (is_there && is_good && count > 0).then_some(Comparison { with, ops, camera, wiper, beside, differences })
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
    checked(key, &value, &[]).map_err(fault)?;
    Ok(Comparison::of_key(key, &value))
}

/// Checks that a key can be compared and has this value in some figure. If it's possible together with the values of
/// this figure is another question, because those change, and it must still be possible to read a file then.
fn checked(key: &str, value: &str, others: &[(String, String, usize)]) -> Result<(), Problem> {
    let section = key.split('.').next().unwrap_or_default().trim();
    let is_plain = key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '-'));
    if SECTIONS.contains(&key) {
        return Err(Problem::Value { found: sanitize::escaped(value), allowed: Allowed::Section });
    }
    if !SECTIONS.contains(&section) || !key.contains('.') || !is_plain {
        return Err(Problem::UnknownKey { near: near::word(section, &SECTIONS), known: SECTIONS.to_vec() });
    }
    if key == "style.theme" {
        // Both sides show one scene, whose colours come from a theme.
        let known = vec!["shading", "visibility", "hidden_lines", "antialias", "depth_format"];
        return Err(Problem::UnknownKey { near: None, known });
    }
    if key == "image.photograph" {
        // Both sides show one scene, and its photograph is read with it.
        let known = vec!["width", "height", "undistorted", "photograph_opacity"];
        return Err(Problem::UnknownKey { near: None, known });
    }
    if key == "camera.window" && value == NOTHING {
        // The window that belongs to the angle.
        return Ok(());
    }
    let projection = others.iter().find(|(other, ..)| other == "camera.projection" && key != other);
    let projection = projection.map_or_else(String::new, |(key, value, _)| format!("{key} = {value}\n"));
    // The sections are tables, so `show.step.at` is a key of `[show]`.
    match parse(&format!("{key} = {value}\n")) {
        Ok(_) => Ok(()),
        // These are impossible with the other values of any figure. In parallel projection F may be 0 or less.
        Err(FigureError { problem: Problem::Camera(error), .. })
            if error.is_of_one_value() && parse(&format!("{projection}{key} = {value}\n")).is_err() =>
        {
            Err(Problem::Camera(error))
        }
        Err(FigureError { problem: Problem::Camera(_) | Problem::Missing { .. }, .. }) => Ok(()),
        Err(FigureError { problem, .. }) => Err(problem),
    }
}
