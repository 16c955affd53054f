//! The words in the three pictures.

use crate::views::Labels;

use super::Lang;

const EN: Labels = Labels { window: "window", near: "near", far: "far", before: "before" };

const PT_BR: Labels = Labels { window: "janela", near: "frente", far: "fundo", before: "antes" };

/// The words of a language.
#[must_use]
pub const fn labels(lang: Lang) -> &'static Labels {
    match lang {
        Lang::En => &EN,
        Lang::PtBr => &PT_BR,
    }
}
