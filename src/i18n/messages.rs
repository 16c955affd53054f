//! What went wrong, or may not have been meant, in both languages.
//!
//! Keys, words of the figure file, and numbers are the same in every language. Each function is one exhaustive `match`: an
//! error without a text does not compile.

use super::Lang;
pub use super::figure_files::{figure, file, png, scene};
use crate::camera::{Amount, CameraError, Derived, Descriptor, Operation, OperationError, Range, Warning};
use crate::expression::{self, ExpressionError, ExpressionProblem};
use crate::inspect::InspectError;

/// One of the two texts.
pub(super) fn pick(lang: Lang, en: impl Into<String>, pt_br: impl Into<String>) -> String {
    match lang {
        Lang::En => en.into(),
        Lang::PtBr => pt_br.into(),
    }
}

/// Why parameters are no camera, with the keys concerned and what is allowed.
#[must_use]
pub fn camera(lang: Lang, error: &CameraError) -> String {
    match error {
        CameraError::FocalPointAtPosition => pick(
            lang,
            "focal_point is the same point as position; allowed: any other point",
            "focal_point é o mesmo ponto que position; permitido: qualquer outro ponto",
        ),
        CameraError::ViewUpZero => pick(
            lang,
            "view_up is the zero vector; allowed: any other vector that is not collinear with focal_point − position",
            "view_up é o vetor nulo; permitido: qualquer outro vetor não colinear com focal_point − position",
        ),
        CameraError::ViewUpCollinear => pick(
            lang,
            "view_up is collinear with focal_point − position; allowed: any vector that points to another side",
            "view_up é colinear com focal_point − position; permitido: qualquer vetor que aponte para outro lado",
        ),
        CameraError::OutOfRange { key, value, allowed } => {
            let allowed = range(lang, *allowed);
            pick(
                lang,
                format!("{key} is {value:?}; allowed: {allowed}"),
                format!("{key} é {value:?}; permitido: {allowed}"),
            )
        }
        CameraError::FarNotBeyondNear { near, far } => pick(
            lang,
            format!("near is {near:?} and far is {far:?}; allowed: 0 < near < far"),
            format!("near é {near:?} e far é {far:?}; permitido: 0 < near < far"),
        ),
        CameraError::WindowWidth { left, right } => pick(
            lang,
            format!("window: left is {left:?} and right is {right:?}; allowed: left < right"),
            format!("window: left é {left:?} e right é {right:?}; permitido: left < right"),
        ),
        CameraError::WindowHeight { bottom, top } => pick(
            lang,
            format!("window: bottom is {bottom:?} and top is {top:?}; allowed: bottom < top"),
            format!("window: bottom é {bottom:?} e top é {top:?}; permitido: bottom < top"),
        ),
        CameraError::Overflow { quantity, keys } => {
            let (quantity, keys) = (derived(lang, *quantity), keys.join(", "));
            pick(
                lang,
                format!("{quantity} would exceed the range of numbers (about 1e-308 to 1e308); it follows from {keys}"),
                format!("{quantity} excederia os limites dos números (cerca de 1e-308 a 1e308); depende de {keys}"),
            )
        }
    }
}

fn range(lang: Lang, range: Range) -> String {
    match range {
        Range::Finite => pick(lang, "a finite number", "um número finito"),
        Range::Positive => pick(lang, "a finite number greater than 0", "um número finito maior que 0"),
        Range::HalfTurn => pick(lang, "greater than 0 and less than 180 degrees", "maior que 0 e menor que 180 graus"),
    }
}

fn derived(lang: Lang, quantity: Derived) -> String {
    match quantity {
        Derived::Distance => {
            pick(lang, "the distance from position to focal_point", "a distância de position a focal_point")
        }
        Derived::Window => pick(lang, "the view window", "a janela de projeção"),
        Derived::ViewMatrix => pick(lang, "the view matrix", "a matriz de visão"),
        Derived::ProjectionMatrix => pick(lang, "the projection matrix", "a matriz de projeção"),
        Derived::ViewProjectionMatrix => {
            pick(lang, "the product of projection and view matrix", "o produto das matrizes de projeção e de visão")
        }
        Derived::VolumeCorners => pick(lang, "the corners of the view volume", "os vértices do volume de vista"),
    }
}

/// Why a text is not an operation.
#[must_use]
pub fn operation(lang: Lang, error: &OperationError) -> String {
    let names = || Operation::names().join(", ");
    match (lang, error) {
        (Lang::En, error) => error.to_string(),
        (Lang::PtBr, OperationError::NoValue { text }) => {
            format!("{text:?} não é uma operação; permitido: NOME=VALOR, em que NOME é um de {}", names())
        }
        (Lang::PtBr, OperationError::UnknownName { name }) => {
            format!("não há a operação {name:?}; permitido: {}", names())
        }
        (Lang::PtBr, OperationError::NotANumber { descriptor, value, error }) => {
            let (why, allowed) = (in_expression(lang, value, error), amount_in_portuguese(descriptor));
            format!("{} é {value:?}: {why}; permitido: {allowed}", descriptor.word)
        }
        (
            Lang::PtBr,
            OperationError::NotAFactor { descriptor, value } | OperationError::WrongCount { descriptor, value },
        ) => {
            format!("{} é {value:?}; permitido: {}", descriptor.word, amount_in_portuguese(descriptor))
        }
    }
}

fn amount_in_portuguese(descriptor: &Descriptor) -> String {
    let word = descriptor.word;
    match descriptor.amount {
        Amount::Angle => format!("um número finito de graus, como {word}=30"),
        Amount::Factor => format!("um número finito maior que 0, como {word}=1.5"),
        Amount::Length => format!("dois números finitos DX,DY em unidades da cena, como {word}=1,-0.5"),
    }
}

/// Why an expression is not a number, and where in it that shows.
pub(super) fn in_expression(lang: Lang, text: &str, error: &ExpressionError) -> String {
    let (why, marked) = (expression(lang, &error.problem), expression::marked(text, &error.span));
    match lang {
        Lang::En => format!("{why} in {marked}"),
        Lang::PtBr => format!("{why} em {marked}"),
    }
}

/// Why an expression is not a number.
#[must_use]
pub fn expression(lang: Lang, problem: &ExpressionProblem) -> String {
    match (lang, problem) {
        (Lang::En, problem) => problem.to_string(),
        (Lang::PtBr, ExpressionProblem::Empty) => "falta um número".to_owned(),
        (Lang::PtBr, ExpressionProblem::Unexpected(c)) => format!("inesperado: “{c}”"),
        (Lang::PtBr, ExpressionProblem::Unfinished) => "a expressão não terminou".to_owned(),
        (Lang::PtBr, ExpressionProblem::UnknownName(name)) => format!("nome desconhecido: “{name}”"),
        (Lang::PtBr, ExpressionProblem::MissingParenthesis) => "falta um “)”".to_owned(),
        (Lang::PtBr, ExpressionProblem::MixedUnits) => "ângulo e número não se misturam aqui".to_owned(),
        (Lang::PtBr, ExpressionProblem::NotFinite) => "o resultado não é um número finito".to_owned(),
        (Lang::PtBr, ExpressionProblem::TooLong) => "a expressão é longa demais".to_owned(),
    }
}

/// Why there are no numbers to report.
#[must_use]
pub fn inspect(lang: Lang, error: &InspectError) -> String {
    match error {
        InspectError::Camera(error) => camera(lang, error),
        InspectError::Operation { operation, error } => {
            let why = camera(lang, error);
            pick(lang, format!("operation {operation}: {why}"), format!("operação {operation}: {why}"))
        }
        InspectError::Point { point, space } => {
            let [x, y, z] = point.to_array();
            pick(
                lang,
                format!(
                    "point {x},{y},{z}: its coordinates in {space} would exceed the range of numbers (about 1e-308 to 1e308)"
                ),
                format!(
                    "ponto {x},{y},{z}: suas coordenadas ({space}) excederiam os limites dos números (cerca de 1e-308 a 1e308)"
                ),
            )
        }
        InspectError::Pixel { pixel: [i, j] } => pick(
            lang,
            format!("pixel {i},{j}: its ray would exceed the range of numbers (about 1e-308 to 1e308)"),
            format!("pixel {i},{j}: seu raio excederia os limites dos números (cerca de 1e-308 a 1e308)"),
        ),
    }
}

/// What is possible, but probably not what was meant.
#[must_use]
pub fn warning(lang: Lang, warning: &Warning) -> String {
    match warning {
        Warning::ViewUpNearlyCollinear { degrees } => pick(
            lang,
            warning.to_string(),
            format!(
                "view_up está a apenas {degrees:.3e} graus da direção de projeção: seus últimos dígitos decidem o que fica para cima"
            ),
        ),
        Warning::DepthPrecision { ratio, step } => pick(
            lang,
            warning.to_string(),
            format!(
                "far / near é {ratio:.3e}: um z-buffer de 24 bits não distingue profundidades que diferem menos de {step:.3e} no plano far; afaste near da câmera"
            ),
        ),
        Warning::FocalPointClipped { distance, near, far } => pick(
            lang,
            warning.to_string(),
            format!(
                "focal_point está à distância {distance}, que não fica entre near = {near} e far = {far}: o que a câmera mira é recortado"
            ),
        ),
        Warning::WideAngle { degrees } => pick(
            lang,
            warning.to_string(),
            format!("a janela abrange {degrees:.6} graus: perto das bordas tudo fica esticado"),
        ),
        Warning::FarFromOrigin { ratio, digits } => pick(
            lang,
            warning.to_string(),
            format!(
                "a câmera está {ratio:.3e} vezes mais longe da origem que de focal_point: restam só {digits} de 15 dígitos para o que ela vê"
            ),
        ),
        Warning::AspectMismatch { window, image } => pick(
            lang,
            warning.to_string(),
            format!(
                "a janela de projeção tem razão de aspecto {window:.6} e a imagem {image:.6}: as formas são esticadas"
            ),
        ),
    }
}
