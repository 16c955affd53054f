//! [`Figure`] → the text of a figure file.

use glam::{DMat4, DVec2, DVec3};
use toml_edit::{Array, DocumentMut, InlineTable, Value};

use super::keys::{self, Keys};
use super::{Bilingual, Figure};
use crate::numbers;
use crate::scene::SceneSpec;

/// The figure file of `figure`, with its keys in the order of the documentation.
///
/// # Guarantees
/// Reading the text gives the same figure back, every number to the last bit, for each figure that a file can hold.
pub fn to_toml(figure: &Figure) -> String {
    document(figure).to_string()
}

/// The figure file as a document.
pub(super) fn document(figure: &Figure) -> DocumentMut {
    written(Keys::write(false), &mut figure.clone())
}

/// Some sections of the figure file, with the keys that don't have their usual values, or with every key.
pub(super) fn sections(figure: &Figure, sections: &[&str], every: bool) -> DocumentMut {
    // A scene can be large, and most keys are elsewhere.
    let scene = if sections.contains(&"scene") { figure.scene.clone() } else { SceneSpec::default() };
    let (observers, show) = (figure.observers, figure.show.clone());
    let mut figure = Figure { scene, observers, show, ..figure.without_scene() };
    written(Keys::write(every).only(sections), &mut figure)
}

fn written(mut keys: Keys<'_>, figure: &mut Figure) -> DocumentMut {
    keys::figure(&mut keys, figure);
    keys.into_table().into()
}

/// A text that's the same in both languages, or one for each.
pub(super) fn told(text: &Bilingual) -> Value {
    let Bilingual { en, pt_br } = text;
    if en == pt_br {
        return quoted(en);
    }
    [("en", quoted(en)), ("pt-BR", quoted(pt_br))].into_iter().collect::<InlineTable>().into()
}

/// A text in double quotes on one line. The library would take several lines for a text with a line end, and those
/// change with the line ends of the file. (JSON escapes the same characters as TOML, except for DEL.)
pub(super) fn quoted(text: &str) -> Value {
    let quoted = serde_json::Value::from(text).to_string().replace('\u{7f}', "\\u007F");
    let mut value = quoted.parse().unwrap_or_else(|_| Value::from(text));
    value.decor_mut().clear();
    value
}

/// The shortest decimal number that reads back as the same `f64`. It's in Rust's notation for floats, because the
/// library's has hundreds of zeros if the number is very large or small.
pub(super) fn number(x: f64) -> Value {
    let mut value = numbers::exact(x).parse().unwrap_or_else(|_| Value::from(x));
    // Spaces around it belong to its place.
    value.decor_mut().clear();
    value
}

pub(super) fn pair(p: DVec2) -> Value {
    numbers_of(p.to_array())
}

pub(super) fn vector(v: DVec3) -> Value {
    numbers_of(v.to_array())
}

pub(super) fn vectors(points: &[DVec3]) -> Value {
    points.iter().map(|p| vector(*p)).collect::<Array>().into()
}

pub(super) fn matrix(m: &DMat4) -> Value {
    (0..4).map(|i| numbers_of(m.row(i).to_array())).collect::<Array>().into()
}

pub(super) fn numbers_of<const N: usize>(numbers: [f64; N]) -> Value {
    numbers.into_iter().map(number).collect::<Array>().into()
}
