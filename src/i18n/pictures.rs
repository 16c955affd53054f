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
    outside: "outside the volume",
    cuts: "made by clipping",
    back_faces: "back faces: culled",
    dropped: "outside: dropped whole",
    outside_of: "outside",
    planes: ["left", "right", "bottom", "top", "near", "far"],
    divided_first: "divided before clipping",
    wrong: "wrong",
    no_difference: "nothing wrong falls into the volume",
};

const PT_BR: Labels = Labels {
    window: "janela",
    near: "frente",
    far: "fundo",
    before: "antes",
    depth_stored: "z-buffer: Z (5.25)",
    depth_linear: "distância ao olho",
    nothing: "nada aqui",
    outside: "fora do volume",
    cuts: "criado pelo recorte",
    back_faces: "faces de trás: descartadas",
    dropped: "fora: descartado inteiro",
    outside_of: "fora",
    planes: ["esquerda", "direita", "baixo", "topo", "frente", "fundo"],
    divided_first: "dividido antes do recorte",
    wrong: "errado",
    no_difference: "nada de errado cai no volume",
};

/// The words of a language.
#[must_use]
pub const fn labels(lang: Lang) -> &'static Labels {
    match lang {
        Lang::En => &EN,
        Lang::PtBr => &PT_BR,
    }
}
