//! `[compare]`: other values of keys, operations or another camera on the other side.

use toml_edit::{Array, InlineTable, Item, Value};

use super::{Keys, UNIT, keys_of};
use crate::figure::error::{Allowed, FigureError, Problem};
use crate::figure::read::{Fault, Section, parse};
use crate::figure::value::{NOTHING, TEXT, number_in, quoted};
use crate::figure::{Comparison, NamedCamera, near};
use crate::limits::MAX_COMPARED_KEYS;
use crate::sanitize;

/// The sections whose keys can be compared. The scene, its points and the observers are the same on both sides.
const COMPARED: [&str; 7] = ["camera", "image", "viewport", "style", "reveal", "world", "show"];

/// The section; `None` if there is none, or nothing to compare.
pub(super) fn compare(keys: &mut Keys<'_>, label: &str, value: &mut Option<Comparison>, cameras: &[NamedCamera]) {
    keys.optional("compare", label, Item::Table, value, Comparison::default(), |keys, comparison| {
        comparison_keys(keys, comparison);
        if let Some(section) = keys.reading() {
            check_whole(section, comparison, cameras);
        }
    });
    *value = value.take().filter(|comparison| count(comparison) > 0);
}

fn comparison_keys(keys: &mut Keys<'_>, comparison: &mut Comparison) {
    let Comparison { with, ops, camera, wiper, beside, differences } = comparison;
    keys.in_order(&["with", "ops", "camera", "wiper"]);
    keys.field(
        "with",
        !with.is_empty(),
        with,
        |s, with| *with = read_with(s),
        |with| {
            let value =
                |value: &str| value.parse::<Value>().map_or_else(|_| quoted(value), |value| value.decorated("", ""));
            with.iter().map(|(key, text)| (key.as_str(), value(text))).collect::<InlineTable>().into()
        },
    );
    let read = |s: &mut Section<'_>, ops: &mut Vec<_>| {
        *ops = s.list("ops", Allowed::Operations, |text| text.parse().ok());
    };
    keys.field("ops", !ops.is_empty(), ops, read, |ops| ops.iter().map(ToString::to_string).collect::<Array>().into());
    keys.option("camera", &TEXT, camera);
    keys.rare_word("layout", &[("wiper", false), ("beside", true)], beside);
    keys.key_if("wiper", !*beside || *wiper != Comparison::default().wiper, &number_in(UNIT), wiper);
    keys.switch("differences", differences);
}

fn count(comparison: &Comparison) -> usize {
    comparison.with.len() + comparison.ops.len() + usize::from(comparison.camera.is_some())
}

fn check_whole(section: &mut Section<'_>, comparison: &Comparison, cameras: &[NamedCamera]) {
    if comparison.camera.as_ref().is_some_and(|name| cameras.iter().all(|camera| camera.name != *name)) {
        section.refuse("camera", Allowed::Camera);
    }
    let count = count(comparison);
    if count == 0 && section.faults.is_empty() {
        section.missing("with", Allowed::Section);
    } else if count > MAX_COMPARED_KEYS {
        let key = if comparison.with.is_empty() { "ops" } else { "with" };
        section.fault(key, Problem::TooMany { count, limit: MAX_COMPARED_KEYS });
    }
}

/// The compared keys with their values.
fn read_with(section: &mut Section<'_>) -> Vec<(String, String)> {
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
    with
}

/// Checks that a key can be compared and has this value in some figure. If it's possible together with the values of
/// this figure is another question, because those change, and it must still be possible to read a file then.
pub(in crate::figure) fn checked(key: &str, value: &str, others: &[(String, String, usize)]) -> Result<(), Problem> {
    let section = key.split('.').next().unwrap_or_default().trim();
    let is_plain = key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '-'));
    if COMPARED.contains(&key) {
        return Err(Problem::Value { found: sanitize::escaped(value), allowed: Allowed::Section });
    }
    if !COMPARED.contains(&section) || !key.contains('.') || !is_plain {
        return Err(Problem::UnknownKey { near: near::word(section, &COMPARED), known: COMPARED.to_vec() });
    }
    // Both sides show one scene, whose colours come from a theme, and whose photograph is read with it.
    if let Some(own) = match key {
        "style.theme" => Some("theme"),
        "image.photograph" => Some("photograph"),
        _ => None,
    } {
        let known = keys_of(section).filter(|other| *other != own).collect();
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
