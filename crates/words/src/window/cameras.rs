//! The words of the list of cameras, in both languages.

use crate::Lang;

texts!("window/cameras");

/// A camera has been kept under this name.
pub fn kept(lang: Lang, name: &str) -> String {
    text!(lang, kept, name)
}
