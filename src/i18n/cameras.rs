//! What is wrong with a camera, an operation or a question about it, or may not have been meant, in both languages.
//!
//! Keys, words of the figure file, and numbers are the same in every language. Each function is one exhaustive `match`: an
//! error without a text does not compile.

use super::Lang;
use super::expressions::in_expression;
use crate::camera::{Amount, CameraError, Derived, Descriptor, Operation, OperationError, Range, Warning};
use crate::inspect::InspectError;

/// Why parameters are no camera, with the keys concerned and what is allowed.
#[must_use]
pub fn camera(lang: Lang, error: &CameraError) -> String {
    match error {
        CameraError::FocalPointAtPosition => match lang { Lang::En => "focal_point is the same point as position; allowed: any other point".to_owned(), Lang::PtBr => "focal_point é o mesmo ponto que position; permitido: qualquer outro ponto".to_owned() },
        CameraError::ViewUpZero => match lang { Lang::En => "view_up is the zero vector; allowed: any other vector that is not collinear with focal_point − position".to_owned(), Lang::PtBr => "view_up é o vetor nulo; permitido: qualquer outro vetor não colinear com focal_point − position".to_owned() },
        CameraError::ViewUpCollinear => match lang { Lang::En => "view_up is collinear with focal_point − position; allowed: any vector that points to another side".to_owned(), Lang::PtBr => "view_up é colinear com focal_point − position; permitido: qualquer vetor que aponte para outro lado".to_owned() },
        CameraError::OutOfRange { key, value, allowed } => {
            let allowed = range(lang, *allowed);
            match lang { Lang::En => format!("{key} is {value:?}; allowed: {allowed}"), Lang::PtBr => format!("{key} é {value:?}; permitido: {allowed}") }
        }
        CameraError::FarNotBeyondNear { near, far } => match lang { Lang::En => format!("near is {near:?} and far is {far:?}; allowed: 0 < near < far"), Lang::PtBr => format!("near é {near:?} e far é {far:?}; permitido: 0 < near < far") },
        CameraError::WindowWidth { left, right } => match lang { Lang::En => format!("window: left is {left:?} and right is {right:?}; allowed: left < right"), Lang::PtBr => format!("window: left é {left:?} e right é {right:?}; permitido: left < right") },
        CameraError::WindowHeight { bottom, top } => match lang { Lang::En => format!("window: bottom is {bottom:?} and top is {top:?}; allowed: bottom < top"), Lang::PtBr => format!("window: bottom é {bottom:?} e top é {top:?}; permitido: bottom < top") },
        CameraError::Overflow { quantity, keys } => {
            let (quantity, keys) = (derived(lang, *quantity), keys.join(", "));
            match lang { Lang::En => format!("{quantity} would exceed the range of numbers (about 1e-308 to 1e308); it follows from {keys}"), Lang::PtBr => format!("{quantity} excederia os limites dos números (cerca de 1e-308 a 1e308); depende de {keys}") }
        }
    }
}

fn range(lang: Lang, range: Range) -> String {
    match range {
        Range::Finite => match lang {
            Lang::En => "a finite number".to_owned(),
            Lang::PtBr => "um número finito".to_owned(),
        },
        Range::Positive => match lang {
            Lang::En => "a finite number greater than 0".to_owned(),
            Lang::PtBr => "um número finito maior que 0".to_owned(),
        },
        Range::HalfTurn => match lang {
            Lang::En => "greater than 0 and less than 180 degrees".to_owned(),
            Lang::PtBr => "maior que 0 e menor que 180 graus".to_owned(),
        },
    }
}

fn derived(lang: Lang, quantity: Derived) -> String {
    match quantity {
        Derived::Distance => match lang {
            Lang::En => "the distance from position to focal_point".to_owned(),
            Lang::PtBr => "a distância de position a focal_point".to_owned(),
        },
        Derived::Window => match lang {
            Lang::En => "the view window".to_owned(),
            Lang::PtBr => "a janela de projeção".to_owned(),
        },
        Derived::ViewMatrix => match lang {
            Lang::En => "the view matrix".to_owned(),
            Lang::PtBr => "a matriz de visão".to_owned(),
        },
        Derived::ProjectionMatrix => match lang {
            Lang::En => "the projection matrix".to_owned(),
            Lang::PtBr => "a matriz de projeção".to_owned(),
        },
        Derived::ViewProjectionMatrix => match lang {
            Lang::En => "the product of projection and view matrix".to_owned(),
            Lang::PtBr => "o produto das matrizes de projeção e de visão".to_owned(),
        },
        Derived::VolumeCorners => match lang {
            Lang::En => "the corners of the view volume".to_owned(),
            Lang::PtBr => "os vértices do volume de vista".to_owned(),
        },
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
    match error {
        InspectError::Camera(error) => camera(lang, error),
        InspectError::Operation { operation, error } => {
            let why = camera(lang, error);
            match lang {
                Lang::En => format!("operation {operation}: {why}"),
                Lang::PtBr => format!("operação {operation}: {why}"),
            }
        }
        InspectError::Point { point, space } => {
            let [x, y, z] = point.to_array();
            match lang {
                Lang::En => format!(
                    "point {x},{y},{z}: its coordinates in {space} would exceed the range of numbers (about 1e-308 to 1e308)"
                ),
                Lang::PtBr => format!(
                    "ponto {x},{y},{z}: suas coordenadas ({space}) excederiam os limites dos números (cerca de 1e-308 a 1e308)"
                ),
            }
        }
        InspectError::Pixel { pixel: [i, j] } => match lang {
            Lang::En => format!("pixel {i},{j}: its ray would exceed the range of numbers (about 1e-308 to 1e308)"),
            Lang::PtBr => format!("pixel {i},{j}: seu raio excederia os limites dos números (cerca de 1e-308 a 1e308)"),
        },
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
