//! The words of the gallery: its parts, and a name and a sentence for each figure of the program.

use super::Lang;

texts! {
    // Title.
    gallery: "Gallery", "Galeria";
    // Its parts.
    examples: "Examples", "Exemplos";
    recent: "Recent", "Recentes";
    folder: "Folder", "Pasta";
    // A button.
    choose: "Choose a folder…", "Escolher uma pasta…";
    // The question for the path of a folder.
    which_folder: "Which folder?", "Qual pasta?";
    // What the keys do.
    keys: "Arrows: choose · Enter: open · Ctrl+Tab: next part · Esc: close", "Setas: escolher · Enter: abrir · Ctrl+Tab: parte seguinte · Esc: fechar";
    // The same where there is one part.
    keys_of_one: "Arrows: choose · Enter: open · Esc: close", "Setas: escolher · Enter: abrir · Esc: fechar";
    // A button.
    close: "Close", "Fechar";
    // Where there is nothing to show.
    no_recent: "Nothing has been opened or saved yet.", "Nada foi aberto ou salvo ainda.";
    no_folder: "No folder is chosen: that of the open figure, or one that you choose, is listed here.", "Nenhuma pasta foi escolhida: a da figura aberta, ou uma que você escolher, aparece aqui.";
    empty_folder: "There are no figure files (.toml) in this folder.", "Não há arquivos de figura (.toml) nesta pasta.";
    // Of a file.
    gone: "no longer exists", "não existe mais";
    // Before the number of files that are not shown.
    more: "more files:", "outros arquivos:";
}

/// The name of a built-in figure, and its content in one sentence.
#[must_use]
pub fn shipped(lang: Lang, name: &str) -> (&'static str, &'static str) {
    let (en, pt) = match name {
        "primitives" => (
            ("Primitives", "One of each shape on a table: a scene to try things out."),
            ("Primitivas", "Uma de cada forma sobre uma mesa: uma cena para experimentar."),
        ),
        "house" => (
            ("House", "A house that differs from its mirror image: what is left and right, near and far?"),
            ("Casa", "Uma casa diferente de sua imagem espelhada: o que é esquerda e direita, perto e longe?"),
        ),
        "corridor" => (
            ("Corridor", "Depth cues: parallel lines meet in a vanishing point, equal balls and tiles shrink."),
            (
                "Corredor",
                "Pistas de profundidade: paralelas se encontram em um ponto de fuga, bolas e ladrilhos iguais diminuem.",
            ),
        ),
        "teapot" => (
            ("Teapot", "A mesh from a file, with the colours of its material, on the ground."),
            ("Bule", "Uma malha de um arquivo, com as cores do seu material, sobre o chão."),
        ),
        "arm" => (
            ("Robot arm", "A tree of transforms: each part turns about the end of the one before."),
            ("Braço de robô", "Uma árvore de transformações: cada parte gira em torno do fim da anterior."),
        ),
        "cube" => (
            ("Numbered cube", "Opposite faces add up to 7: turn the camera and tell where it is."),
            ("Cubo numerado", "Faces opostas somam 7: gire a câmera e diga onde ela está."),
        ),
        "ndc-cube" => (
            ("NDC cube", "The view volume is exactly the cube of normalised device coordinates."),
            ("Cubo NDC", "O volume de vista é exatamente o cubo das coordenadas normalizadas de dispositivo."),
        ),
        "pyramid" => (
            ("Pyramid", "[1], exercises I to III, for day 15 and month 8: a camera on the corner of a pyramid."),
            ("Pirâmide", "[1], exercícios I a III, para o dia 15 e o mês 8: uma câmera no canto de uma pirâmide."),
        ),
        "exercise-5.1" => (
            ("Exercise 5.1", "[0]: the rays to P = (1, 1, 0) of the VRC, in parallel projection and in perspective."),
            ("Exercício 5.1", "[0]: os raios para P = (1, 1, 0) do VRC, em projeção paralela e em perspectiva."),
        ),
        "exercise-5.2" => (
            ("Exercise 5.2", "[0]: parallel projection, and a view window whose pixels are not square."),
            ("Exercício 5.2", "[0]: projeção paralela, e uma janela de vista cujos pixels não são quadrados."),
        ),
        "exercise-5.3" => (
            ("Exercise 5.3", "[0]: which camera has exactly this cube as its view volume?"),
            ("Exercício 5.3", "[0]: que câmera tem exatamente este cubo como volume de vista?"),
        ),
        "empty" => (
            ("Empty scene", "Nothing but the camera: a place for your own objects."),
            ("Cena vazia", "Nada além da câmera: um lugar para seus próprios objetos."),
        ),
        extreme => return extreme_figure(lang, extreme),
    };
    match lang {
        Lang::En => en,
        Lang::PtBr => pt,
    }
}

/// The same for cameras at the limits of numbers.
fn extreme_figure(lang: Lang, name: &str) -> (&'static str, &'static str) {
    let (en, pt) = match name {
        "far-plane" => (
            (
                "B = 1e12",
                "In parallel projection NDC flatten the table onto the front face; hidden surfaces are still right.",
            ),
            (
                "B = 1e12 (fundo)",
                "Em projeção paralela, as NDC achatam a mesa na face da frente; as faces ocultas seguem certas.",
            ),
        ),
        "far-near" => (
            (
                "B / F = 1e15",
                "In perspective NDC flatten the table onto the back face; the image is the same for any F.",
            ),
            (
                "B / F = 1e15 (razão)",
                "Em perspectiva, as NDC achatam a mesa na face de fundo; a imagem é a mesma para qualquer F.",
            ),
        ),
        "thin-volume" => (
            (
                "B − F = 1e-12",
                "The volume is a sheet: it holds the fronts of three boxes, and nothing of a fourth, just behind.",
            ),
            (
                "B − F = 1e-12 (folha)",
                "O volume é uma folha: contém a frente de três caixas e nada de uma quarta, logo atrás.",
            ),
        ),
        "narrow-angle" => (
            ("θ = 1e-6°", "A house seen from 3.6e8 units away: in the world the volume is a line."),
            ("θ = 1e-6° (tele)", "Uma casa vista a 3,6e8 unidades: no mundo, o volume é uma linha."),
        ),
        "wide-angle" => (
            (
                "θ = 179.9999°",
                "Towers a million units to the side fill the image; everything near the axis is a point.",
            ),
            ("θ = 179,9999°", "Torres a um milhão de unidades ao lado enchem a imagem; tudo perto do eixo é um ponto."),
        ),
        "wide-window" => (
            ("A = 1e6", "A slit a million times as wide as high: what a scanner with one line of sensors sees."),
            (
                "A = 1e6 (fenda)",
                "Uma fenda um milhão de vezes mais larga que alta: o que vê um scanner de uma só linha.",
            ),
        ),
        "tall-window" => (
            ("A = 1e-6", "An upright slit: in the world the volume is a sheet through the table."),
            ("A = 1e-6 (fenda)", "Uma fenda em pé: no mundo, o volume é uma folha que atravessa a mesa."),
        ),
        "aside" => (
            ("Window far off-axis", "The window is a thousand widths off the axis: the oblique terms are the largest."),
            (
                "Janela muito fora do eixo",
                "A janela está mil larguras fora do eixo: os termos oblíquos são os maiores.",
            ),
        ),
        "far-position" => (
            (
                "C at 1e12",
                "Camera and objects far from the origin: C is subtracted first, so the picture loses nothing.",
            ),
            ("C em 1e12", "Câmera e objetos longe da origem: C é subtraído primeiro, e nada da imagem se perde."),
        ),
        "small-distance" => (
            ("D = 1e-9", "A camera for a world of a few atoms: grid, axes and the camera's body adapt their scale."),
            (
                "D = 1e-9 (átomos)",
                "Uma câmera para um mundo de poucos átomos: grade, eixos e câmera adaptam sua escala.",
            ),
        ),
        "large-distance" => (
            (
                "D = 1e12",
                "A table of six units from 1e12 away: the steps of the coordinates at C are smaller than a pixel.",
            ),
            (
                "D = 1e12 (mesa)",
                "Uma mesa de seis unidades a 1e12: os passos das coordenadas em C são menores que um pixel.",
            ),
        ),
        "steep-up" => (
            ("VUP almost along DOP", "Only the ninth digit of VUP says which way is up: the horizon is tilted."),
            ("VUP quase sobre DOP", "Só o nono dígito de VUP diz o que é acima: o horizonte fica inclinado."),
        ),
        "zoomed-out" => (
            ("H = 1e6", "A volume far wider than everything else is drawn narrower, with broken sides."),
            (
                "H = 1e6 (janela)",
                "Um volume bem mais largo que o resto é desenhado mais estreito, com lados interrompidos.",
            ),
        ),
        "solar" => (
            (
                "Planet and moon",
                "Bodies of 1e9 units with F at arm's length: the moon hides the planet at nearly the same Z.",
            ),
            ("Planeta e lua", "Corpos de 1e9 unidades com F a meio metro: a lua oculta o planeta com quase o mesmo Z."),
        ),
        _ => return ("", ""),
    };
    match lang {
        Lang::En => en,
        Lang::PtBr => pt,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::SHIPPED_FIGURES;

    #[test]
    fn every_figure_of_the_program_has_a_name_and_a_sentence_in_both_languages() {
        for figure in SHIPPED_FIGURES {
            let (en, pt) = (shipped(Lang::En, figure.name), shipped(Lang::PtBr, figure.name));
            assert!(!en.0.is_empty() && en.0 != pt.0 && en.1 != pt.1, "{}", figure.name);
            for sentence in [en.1, pt.1] {
                assert!(sentence.ends_with(['.', '?']) && sentence.chars().count() < 110, "{sentence}");
            }
        }
    }
}
