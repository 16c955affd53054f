//! The words of conventions: the NDC, rows or columns, left or right hand.

use crate::camera::{Axes, InfiniteParallel, Ndc, Toward, WorldUp};
use crate::i18n::{Lang, pictures};

texts! {
    title: "Conventions", "Convenções";
    ndc: "NDC of", "NDC de";
    ndc_hint: "The convention of the normalised device coordinates in M_p, the probe and the canonical volume. Pixels and depths of the image stay the same", "A convenção das coordenadas de dispositivo normalizadas em M_p, na sonda e no volume canônico. Pixels e profundidades da imagem não mudam";
    compared: "compared with", "comparar com";
    compared_hint: "The same matrices in another convention, below. Entries that differ are marked", "As mesmas matrizes em outra convenção, embaixo. Os elementos que diferem ficam marcados";
    nobody: "nothing", "nada";
    reversed: "reversed", "invertido";
    reversed_hint: "z_n is 1 at F and 0 at B. Floating-point numbers are dense around 0, where perspective crowds the depths. In OpenGL by glClipControl with GL_ZERO_TO_ONE", "z_n é 1 em F e 0 em B. Números de ponto flutuante são densos perto de 0, onde a perspectiva comprime as profundidades. No OpenGL, por glClipControl com GL_ZERO_TO_ONE";
    infinite: "B → ∞", "B → ∞";
    infinite_hint: "The limit of the matrices as the back plane goes to infinity, in perspective only. The views are still clipped at B", "O limite das matrizes quando o plano de fundo vai ao infinito, só em perspectiva. As vistas ainda são recortadas em B";
    row_vectors: "row vectors", "vetores linha";
    row_vectors_hint: "As in texts that write p′ = p M", "Como em textos que escrevem p′ = p M";
    row_vectors_said: "Points are rows, p′ = p M. Every matrix is transposed, and a product is read from the left.", "Pontos são linhas, p′ = p M. Cada matriz é transposta, e um produto é lido da esquerda.";
    left_handed: "left-handed view space", "espaço de vista de mão esquerda";
    left_handed_hint: "z_c grows along DOP, as in texts on Direct3D", "z_c cresce ao longo de DOP, como em textos sobre Direct3D";
    left_handed_said: "z_c grows along DOP. The third row of M_v and the third column of M_p change sign, and their product stays the same.", "z_c cresce ao longo de DOP. A terceira linha de M_v e a terceira coluna de M_p trocam de sinal, e o produto não muda.";
}

/// The axes of a camera.
pub fn camera_axes(lang: Lang, axes: Axes) -> String {
    let [x, y, z] = axes.camera.map(|toward| direction(lang, toward));
    format!("x {x}, y {y}, z {z}")
}

/// A row of the table of axes: camera and world.
pub fn axes_row(lang: Lang, axes: Axes) -> String {
    let world = match axes.up {
        WorldUp::Y => pick!(lang; "y up in the world", "no mundo, y para cima"),
        WorldUp::Z => pick!(lang; "z up in the world", "no mundo, z para cima"),
        WorldUp::Open => pick!(lang; "the world is taken as it is", "o mundo fica como está"),
    };
    let hand = if axes.left_handed { pick!(lang; ", left-handed", ", mão esquerda") } else { "" };
    format!("{}; {world}{hand}", camera_axes(lang, axes))
}

/// The table of axes, a line for each row, by their titles or by the names on the command line.
pub fn axes_table(lang: Lang, name: fn(Axes) -> &'static str) -> String {
    let rows = Axes::ALL.map(|axes| format!("{}: {}", name(axes), axes_row(lang, axes)));
    rows.join("\n")
}

/// The direction of an axis of a camera.
fn direction(lang: Lang, toward: Toward) -> &'static str {
    match toward {
        Toward::Right => pick!(lang; "right", "à direita"),
        Toward::Left => pick!(lang; "left", "à esquerda"),
        Toward::Up => pick!(lang; "up", "para cima"),
        Toward::Down => pick!(lang; "down", "para baixo"),
        Toward::Viewer => pick!(lang; "towards the viewer", "rumo ao observador"),
        Toward::Scene => pick!(lang; "into the scene", "para dentro da cena"),
    }
}

/// A convention in words, as in the pictures.
pub fn name(lang: Lang, ndc: Ndc) -> String {
    pictures::labels(lang).ndc_title(ndc)
}

/// The reason why the pictures still have a back plane.
pub fn finite_instead(lang: Lang, error: InfiniteParallel) -> String {
    let name = error.0.api.title();
    both!(lang; "B → ∞ gives all depths of a parallel projection the same z: {name} is shown with its back plane",
        "B → ∞ dá o mesmo z a todas as profundidades de uma projeção paralela: {name} aparece com seu plano de fundo")
}

/// The differences of a convention from the one in use, as the reasons for different entries.
pub fn differences(lang: Lang, ndc: Ndc, compared: Ndc) -> String {
    let (mine, other) = (name(lang, ndc), name(lang, compared));
    let mut reasons = Vec::new();
    let number = |depth: f64| lang.mark().number(depth, 2);
    let ([near, far], [other_near, other_far]) = (ndc.depths().map(number), compared.depths().map(number));
    if ndc.depths() != compared.depths() {
        reasons.push(both!(lang; "z_n goes from {other_near} at F to {other_far}, not from {near} to {far}",
            "z_n vai de {other_near} em F a {other_far}, e não de {near} a {far}"));
    }
    if ndc.y_points_down() != compared.y_points_down() {
        reasons.push(match compared.y_points_down() {
            true => both!(lang; "y_n points down", "y_n aponta para baixo"),
            false => both!(lang; "y_n points up", "y_n aponta para cima"),
        });
    }
    if ndc.infinite != compared.infinite {
        reasons.push(match compared.infinite {
            true => both!(lang; "it has no back plane", "não há plano de fundo"),
            false => both!(lang; "it has a back plane", "há plano de fundo"),
        });
    }
    match reasons.is_empty() {
        true => both!(lang; "{other} has the same NDC as {mine}, so nothing differs.",
            "{other} tem o mesmo NDC que {mine}, e nada difere."),
        false => both!(lang; "The entries of {other} that differ are marked. {}.",
            "Os elementos de {other} que diferem estão marcados. {}."; capital(&reasons.join("; "))),
    }
}

/// A sentence begins with a capital letter, but not with a symbol's.
fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    match letters.next() {
        Some(first) if !sentence.starts_with("z_n") && !sentence.starts_with("y_n") => {
            first.to_uppercase().chain(letters).collect()
        }
        _ => sentence.to_owned(),
    }
}
