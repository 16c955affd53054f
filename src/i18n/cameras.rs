//! What is wrong with a camera, an operation or a question about it, or may not have been meant, in both languages.
//!
//! Keys, words of the figure file, and numbers are the same in every language. Each function is one exhaustive `match`: an
//! error without a text does not compile.

use super::Lang;
use super::expressions::in_expression;
use crate::camera::{Amount, CameraError, Derived, Descriptor, Operation, OperationError, Range, Warning};
use crate::inspect::InspectError;

/// Why parameters are not a camera, with the keys concerned and what is allowed.
#[must_use]
pub fn camera(lang: Lang, error: &CameraError) -> String {
    match (lang, error) {
        (Lang::En, error) => error.to_string(),
        (Lang::PtBr, CameraError::FocalPointAtPosition) => {
            "focal_point é o mesmo ponto que position; permitido: qualquer outro ponto".to_owned()
        }
        (Lang::PtBr, CameraError::ViewUpZero) => {
            "view_up é o vetor nulo; permitido: qualquer outro vetor não colinear com focal_point − position".to_owned()
        }
        (Lang::PtBr, CameraError::ViewUpCollinear) => {
            "view_up é colinear com focal_point − position; permitido: qualquer vetor que aponte para outro lado"
                .to_owned()
        }
        (Lang::PtBr, CameraError::OutOfRange { key, value, allowed }) => {
            format!("{key} é {value:?}; permitido: {}", range_in_portuguese(*allowed))
        }
        (Lang::PtBr, CameraError::FarNotBeyondNear { near, far }) => {
            format!("near é {near:?} e far é {far:?}; permitido: 0 < near < far")
        }
        (Lang::PtBr, CameraError::WindowWidth { left, right }) => {
            format!("window: left é {left:?} e right é {right:?}; permitido: left < right")
        }
        (Lang::PtBr, CameraError::WindowHeight { bottom, top }) => {
            format!("window: bottom é {bottom:?} e top é {top:?}; permitido: bottom < top")
        }
        (Lang::PtBr, CameraError::Overflow { quantity, keys }) => format!(
            "{} excederia os limites dos números (cerca de 1e-308 a 1e308); depende de {}",
            derived_in_portuguese(*quantity),
            keys.join(", ")
        ),
    }
}

fn range_in_portuguese(range: Range) -> &'static str {
    match range {
        Range::Finite => "um número finito",
        Range::Positive => "um número finito maior que 0",
        Range::HalfTurn => "maior que 0 e menor que 180 graus",
    }
}

fn derived_in_portuguese(quantity: Derived) -> &'static str {
    match quantity {
        Derived::Distance => "a distância de position a focal_point",
        Derived::Window => "a janela de projeção",
        Derived::ViewMatrix => "a matriz de visão",
        Derived::ProjectionMatrix => "a matriz de projeção",
        Derived::ViewProjectionMatrix => "o produto das matrizes de projeção e de visão",
        Derived::VolumeCorners => "os vértices do volume de vista",
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

/// Why there are no numbers to report.
#[must_use]
pub fn inspect(lang: Lang, error: &InspectError) -> String {
    match (lang, error) {
        (Lang::En, error) => error.to_string(),
        (Lang::PtBr, InspectError::Camera(error)) => camera(lang, error),
        (Lang::PtBr, InspectError::Operation { operation, error }) => {
            format!("operação {operation}: {}", camera(lang, error))
        }
        (Lang::PtBr, InspectError::Point { point, space }) => {
            let [x, y, z] = point.to_array();
            format!(
                "ponto {x},{y},{z}: suas coordenadas ({space}) excederiam os limites dos números (cerca de 1e-308 a 1e308)"
            )
        }
        (Lang::PtBr, InspectError::Pixel { pixel: [i, j] }) => {
            format!("pixel {i},{j}: seu raio excederia os limites dos números (cerca de 1e-308 a 1e308)")
        }
    }
}

/// What is possible, but probably not what was meant.
#[must_use]
pub fn warning(lang: Lang, warning: &Warning) -> String {
    match warning {
        Warning::ViewUpNearlyCollinear { degrees } => match lang {
            Lang::En => warning.to_string(),
            Lang::PtBr => format!(
                "view_up está a apenas {degrees:.3e} graus da direção de projeção: seus últimos dígitos decidem o que fica para cima"
            ),
        },
        Warning::DepthPrecision { ratio, step } => match lang {
            Lang::En => warning.to_string(),
            Lang::PtBr => format!(
                "far / near é {ratio:.3e}: um z-buffer de 24 bits não distingue profundidades que diferem menos de {step:.3e} no plano far; afaste near da câmera"
            ),
        },
        Warning::FocalPointClipped { distance, near, far } => match lang {
            Lang::En => warning.to_string(),
            Lang::PtBr => format!(
                "focal_point está à distância {distance}, que não fica entre near = {near} e far = {far}: o que a câmera mira é recortado"
            ),
        },
        Warning::WideAngle { degrees } => match lang {
            Lang::En => warning.to_string(),
            Lang::PtBr => format!("a janela abrange {degrees:.6} graus: perto das bordas tudo fica esticado"),
        },
        Warning::FarFromOrigin { ratio, digits } => match lang {
            Lang::En => warning.to_string(),
            Lang::PtBr => format!(
                "a câmera está {ratio:.3e} vezes mais longe da origem que de focal_point: restam só {digits} de 15 dígitos para o que ela vê"
            ),
        },
        Warning::AspectMismatch { window, image } => match lang {
            Lang::En => warning.to_string(),
            Lang::PtBr => format!(
                "a janela de projeção tem razão de aspecto {window:.6} e a imagem {image:.6}: as formas são esticadas"
            ),
        },
    }
}
