//! The words of the dialog that compares a figure with itself in another way, and of the wiper, in both languages.

use crate::figure::FigureError;
use crate::{Lang, messages};

texts!("window/compare");

/// The reason why there is no other side.
pub fn impossible(lang: Lang, error: &FigureError) -> String {
    format!("{} {}", texts(lang).impossible, messages::without_line(lang, error))
}

/// The other figure has another scene.
pub fn other_scene(lang: Lang, file: &str) -> String {
    text!(lang, other_scene, file)
}
