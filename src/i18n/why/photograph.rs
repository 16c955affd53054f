//! The camera of a photograph: its arithmetic, its errors, and the numbers that it can't give.

use crate::camera::{AxisVanishing, PhotographCamera, PhotographError, Untold};
use crate::i18n::Lang;
use crate::i18n::messages::camera as camera_error;
use crate::sanitize::escaped;

/// Digits of the numbers in sentences.
const DIGITS: usize = 6;

/// An argument that can't be read, with an example.
pub fn unreadable(lang: Lang, text: &str, example: &str) -> String {
    let text = escaped(text);
    both!(lang; "{text} cannot be read; for example: {example}", "{text} não pode ser lido; por exemplo: {example}")
}

/// The reason why there is no camera.
pub fn error(lang: Lang, error: &PhotographError) -> String {
    match error {
        PhotographError::TooFewLines => both!(lang; "at least two axes need two lines each",
            "pelo menos dois eixos precisam de duas retas cada um"),
        PhotographError::NoDirection(line) => both!(lang; "the ends of line {line} are one point",
            "as pontas da reta {line} são um só ponto"),
        PhotographError::OneLine(axis) => {
            let axis = axis.name();
            both!(lang; "the lines of {axis} lie on one line, so they meet everywhere",
                "as retas de {axis} estão sobre uma só reta, e se encontram em toda parte")
        }
        PhotographError::NotAtRightAngles(a, b) => {
            let (a, b) = (a.name(), b.name());
            both!(lang; "f² would be negative: {a} and {b} are not at right angles in any camera whose axis goes through \
                         the middle of the image",
                "f² seria negativo: {a} e {b} não são perpendiculares em nenhuma câmera cujo eixo passa pelo meio da \
                 imagem")
        }
        PhotographError::SameDirection(a, b) => {
            let (a, b) = (a.name(), b.name());
            both!(lang; "the lines of {a} and {b} run in the same direction, to within a pixel; allowed: lines of axes at right angles",
                "as retas de {a} e de {b} têm a mesma direção, com margem de um pixel; permitido: retas de eixos perpendiculares")
        }
        PhotographError::Impossible(error) => camera_error(lang, error),
        PhotographError::LeftHanded => both!(lang; "the senses of the lines make a left-handed system; reverse the \
                                                    lines of one axis",
            "os sentidos das retas formam um sistema de mão esquerda; inverta as retas de um eixo"),
        PhotographError::Length => both!(lang; "the origin and the length contradict each other: C would lie behind \
                                                the origin",
            "a origem e o comprimento se contradizem: C ficaria atrás da origem"),
    }
}

/// A number that the photograph can't give, and the one that stands for it.
pub fn untold(lang: Lang, untold: Untold) -> &'static str {
    match untold {
        Untold::ViewAngle => pick!(lang; "θ cannot be known: of each pair of axes, one has lines that nearly meet at \
                                          infinity. It is that of the figure.",
            "θ não pode ser conhecido: de cada par de eixos, um tem retas que quase se encontram no infinito. É o da \
             figura."),
        Untold::Position => pick!(lang; "The direction to C cannot be known without the pixel of the origin. The \
                                         camera looks at the origin.",
            "A direção até C não pode ser conhecida sem o pixel da origem. A câmera olha para a origem."),
        Untold::Distance => pick!(lang; "The distance of C cannot be known without a length. It is D of the figure.",
            "A distância de C não pode ser conhecida sem um comprimento. É D da figura."),
    }
}

/// The steps from the lines to the camera, one sentence each.
pub fn steps(lang: Lang, found: &PhotographCamera) -> Vec<String> {
    let number = |x: f64| lang.mark().number(x, DIGITS);
    let mut steps: Vec<String> = found.vanishing.iter().map(|point| vanishing(lang, point)).collect();
    if let (Some(f), Some(cost)) = (found.focal_length, found.view_angle_per_pixel) {
        let (f, theta, cost) = (number(f), number(found.parameters.view_angle), lang.mark().number(cost, 2));
        steps.push(both!(lang; "f² = −(V₁ · V₂), from the centre of the image: f = {f} px",
            "f² = −(V₁ · V₂), a partir do meio da imagem: f = {f} px"));
        steps.push(both!(lang; "tan(θ/2) = n / 2f: θ = {theta}°; a pixel of error in each end costs {cost}°",
            "tan(θ/2) = n / 2f: θ = {theta}°; um pixel de erro em cada ponta custa {cost}°"));
    }
    steps.push(horizon(lang, found));
    let cost = lang.mark().number(found.direction_per_pixel, 2);
    steps.push(
        both!(lang; "R: an axis with the vanishing point (x, y) has the direction (x, y, −f) in the VRC; a pixel \
                            of error in each end turns n by {cost}°",
        "R: um eixo com o ponto de fuga (x, y) tem a direção (x, y, −f) no VRC; um pixel de erro em cada ponta gira n \
         em {cost}°"),
    );
    let [u, v, n] = found.axes().map(|axis| lang.mark().tuple(&axis.to_array(), 4));
    steps.push(format!("u = {u}, v = {v}, n = {n}"));
    let c = lang.mark().tuple(&found.parameters.position.to_array(), DIGITS);
    if found.untold.contains(&Untold::Position) {
        return steps;
    }
    steps.push(if found.untold.contains(&Untold::Distance) {
        both!(lang; "The origin with the pixel (x, y) is at λ (x, y, −f) in the VRC; with D of the figure, C = {c}",
            "A origem com o pixel (x, y) está em λ (x, y, −f) no VRC; com D da figura, C = {c}")
    } else {
        both!(lang; "The origin with the pixel (x, y) is at λ (x, y, −f) in the VRC, and the length gives λ: C = {c}",
            "A origem com o pixel (x, y) está em λ (x, y, −f) no VRC, e o comprimento dá λ: C = {c}")
    });
    steps
}

/// The horizon, and the roll of the camera that it shows.
fn horizon(lang: Lang, found: &PhotographCamera) -> String {
    let roll = lang.mark().number(found.roll(), 3);
    match found.horizon {
        Some(_) => both!(lang; "The horizon goes through V_x and V_z, since both lie at infinity on y = 0: the camera \
                                is rolled by {roll}°",
            "O horizonte passa por V_x e V_z, pois ambos estão no infinito de y = 0: a câmera está rolada em {roll}°"),
        None => both!(lang; "The horizon is at infinity: the camera looks straight up or down",
            "O horizonte está no infinito: a câmera olha reto para cima ou para baixo"),
    }
}

fn vanishing(lang: Lang, point: &AxisVanishing) -> String {
    let (axis, spread) = (point.axis.name(), lang.mark().number(point.spread, 3));
    match point.pixel {
        Some(pixel) => {
            let pixel = lang.mark().tuple(&pixel.to_array(), DIGITS);
            both!(lang; "V_{axis} = {pixel}: its lines meet at up to {spread}°",
                "V_{axis} = {pixel}: suas retas se encontram com até {spread}°")
        }
        None => both!(lang; "V_{axis} is at infinity up to the error of a pixel: its lines meet at up to {spread}°",
            "V_{axis} está no infinito a menos do erro de um pixel: suas retas se encontram com até {spread}°"),
    }
}
