//! The words in the three pictures.

use crate::views::Labels;

use super::Lang;

const EN: Labels = Labels {
    window: "window",
    near: "near",
    far: "far",
    before: "before",
    depth_stored: "depth buffer: Z (5.25)",
    depth_linear: "distance from the eye",
    nothing: "nothing here",
};

const PT_BR: Labels = Labels {
    window: "janela",
    near: "frente",
    far: "fundo",
    before: "antes",
    depth_stored: "z-buffer: Z (5.25)",
    depth_linear: "distância ao olho",
    nothing: "nada aqui",
};

/// The words of a language.
#[must_use]
pub const fn labels(lang: Lang) -> &'static Labels {
    match lang {
        Lang::En => &EN,
        Lang::PtBr => &PT_BR,
    }
}
