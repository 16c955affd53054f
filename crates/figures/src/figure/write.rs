//! [`Figure`] → the text of a figure file.

use toml_edit::DocumentMut;

use super::Figure;
use super::keys::{self, Keys};
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
