//! Texts in and about code that sets up a camera.

use crate::camera::WorldUp;
use crate::explain::code::{CodeConvention, CodeTarget};
use crate::i18n::Lang;
use crate::i18n::why::conventions::camera_axes;

/// A convention that the code states about itself.
pub fn convention(lang: Lang, target: CodeTarget, convention: CodeConvention) -> String {
    let name = target.name();
    match convention {
        CodeConvention::OfTheNotes => both!(lang;
            "{name}: p' = M p with column vectors, right-handed view space looking along -n, NDC -1 to 1, as in the lecture notes",
            "{name}: p' = M p com vetores coluna, espaço de vista de mão direita olhando ao longo de -n, NDC de -1 a 1, como nas notas de aula"),
        CodeConvention::ColumnMajor => both!(lang; "{name} stores matrices by columns: m[j][i] is row i, column j",
            "{name} guarda matrizes por colunas: m[j][i] é a linha i, coluna j"),
        CodeConvention::Radians => both!(lang; "angles in radians, vertical", "ângulos em radianos, verticais"),
        CodeConvention::Degrees => both!(lang; "angles in degrees, vertical", "ângulos em graus, verticais"),
        CodeConvention::WindowCentre => both!(lang;
            "the window is not symmetric: its centre is shifted in units of half windows (SetWindowCenter)",
            "a janela não é simétrica: seu centro é deslocado em unidades de meia janela (SetWindowCenter)"),
        CodeConvention::ByMatrix => both!(lang;
            "the window is not symmetric: {name} has no call for it, so the matrix is set; updateProjectionMatrix would undo it",
            "a janela não é simétrica: {name} não tem chamada para ela, e a matriz é definida; updateProjectionMatrix a desfaria"),
        CodeConvention::Axes(axes) => {
            let camera = camera_axes(lang, axes);
            let world = match (axes.left_handed, axes.up) {
                (true, WorldUp::Z) => pick!(lang; "left-handed, z up: (x, y, z) -> (x, z, y)",
                    "mão esquerda, z para cima: (x, y, z) -> (x, z, y)"),
                (true, _) => pick!(lang; "left-handed, so z is reversed", "mão esquerda, então z é invertido"),
                (false, WorldUp::Z) => {
                    pick!(lang; "z up: (x, y, z) -> (x, -z, y)", "z para cima: (x, y, z) -> (x, -z, y)")
                }
                (false, _) => pick!(lang; "as here", "como aqui"),
            };
            both!(lang; "{name}: the camera has {camera}; the world is {world}",
                "{name}: a câmera tem {camera}; o mundo é {world}")
        }
        CodeConvention::Centimetres => both!(lang; "lengths in centimetres", "comprimentos em centímetros"),
    }
}

/// The lines of comment above the code for a camera.
pub fn comments(lang: Lang, target: CodeTarget, conventions: &[CodeConvention]) -> Vec<String> {
    conventions.iter().map(|said| convention(lang, target, *said)).collect()
}
