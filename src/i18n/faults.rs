//! Errors and warnings of the model, in the symbols that the window's fields have.

use super::Lang;
use crate::camera::{CameraError, Derived, Range, Warning};

/// Why camera parameters are not a camera.
#[must_use]
pub fn camera_error(lang: Lang, error: &CameraError) -> String {
    let pt = lang == Lang::PtBr;
    let say = |en: &str, pt_br: &str| (if pt { pt_br } else { en }).to_owned();
    match error {
        CameraError::FocalPointAtPosition => say("PF must differ from C", "PF tem de ser diferente de C"),
        CameraError::ViewUpZero => say("VUP must not be zero", "VUP não pode ser nulo"),
        CameraError::ViewUpCollinear => {
            say("VUP must not be collinear with DOP = PF − C", "VUP não pode ser colinear com DOP = PF − C")
        }
        CameraError::OutOfRange { key, allowed, .. } => {
            let symbol = symbol(key);
            match (allowed, pt) {
                (Range::Finite, false) => format!("{symbol} must be a finite number"),
                (Range::Finite, true) => format!("{symbol} tem de ser um número finito"),
                (Range::Positive, false) => format!("{symbol} must be greater than 0"),
                (Range::Positive, true) => format!("{symbol} tem de ser maior que 0"),
                (Range::HalfTurn, false) => format!("{symbol} must be greater than 0° and less than 180°"),
                (Range::HalfTurn, true) => format!("{symbol} tem de ser maior que 0° e menor que 180°"),
            }
        }
        CameraError::FarNotBeyondNear { .. } => say("F must be less than B", "F tem de ser menor que B"),
        CameraError::WindowWidth { .. } => say("l must be less than r", "l tem de ser menor que r"),
        CameraError::WindowHeight { .. } => say("b must be less than t", "b tem de ser menor que t"),
        CameraError::Overflow { quantity, .. } => {
            let what = derived(*quantity, pt);
            if pt {
                format!("{what} sairia da faixa dos números (cerca de 1e-308 a 1e308)")
            } else {
                format!("{what} would exceed the range of numbers (about 1e-308 to 1e308)")
            }
        }
    }
}

/// The notes' symbol of a key of `[camera]`.
fn symbol(key: &str) -> &str {
    match key {
        "position" => "C",
        "focal_point" => "PF",
        "view_up" => "VUP",
        "view_angle" => "θ",
        "height" => "H",
        "aspect" => "A",
        "near" => "F",
        "far" => "B",
        "window" => "l, r, b, t",
        other => other,
    }
}

fn derived(quantity: Derived, pt: bool) -> &'static str {
    match (quantity, pt) {
        (Derived::Distance, false) => "The distance D",
        (Derived::Distance, true) => "A distância D",
        (Derived::Window, false) => "The view window",
        (Derived::Window, true) => "A janela de vista",
        (Derived::ViewMatrix, false) => "The view matrix",
        (Derived::ViewMatrix, true) => "A matriz de vista",
        (Derived::ProjectionMatrix, false) => "The projection matrix",
        (Derived::ProjectionMatrix, true) => "A matriz de projeção",
        (Derived::ViewProjectionMatrix, false) => "The product of the matrices",
        (Derived::ViewProjectionMatrix, true) => "O produto das matrizes",
        (Derived::VolumeCorners, false) => "A corner of the view volume",
        (Derived::VolumeCorners, true) => "Um canto do volume de vista",
    }
}

/// What is possible, but probably not what was meant.
#[must_use]
pub fn warning(lang: Lang, warning: &Warning) -> String {
    let pt = lang == Lang::PtBr;
    match warning {
        Warning::ViewUpNearlyCollinear { degrees } if pt => {
            format!("VUP está a só {degrees:.2e}° de DOP: seus últimos dígitos decidem onde é em cima")
        }
        Warning::ViewUpNearlyCollinear { degrees } => {
            format!("VUP is only {degrees:.2e}° away from DOP: its last digits decide where up is")
        }
        Warning::DepthPrecision { ratio, step } if pt => format!(
            "B/F é {ratio:.2e}: um buffer de 24 bits não distingue, no fundo, profundidades a menos de {step:.2e}; afaste F da câmera"
        ),
        Warning::DepthPrecision { ratio, step } => format!(
            "B/F is {ratio:.2e}: at the back a 24-bit depth buffer cannot tell depths apart that differ by less than {step:.2e}; move F away from the camera"
        ),
        Warning::FocalPointClipped { .. } if pt => {
            "PF não está entre F e B: o que a câmera olha é recortado".to_owned()
        }
        Warning::FocalPointClipped { .. } => {
            "PF is not between F and B: what the camera looks at is clipped away".to_owned()
        }
        Warning::WideAngle { degrees } if pt => {
            format!("A janela abrange {degrees:.1}°: perto das bordas tudo se estica")
        }
        Warning::WideAngle { degrees } => {
            format!("The window spans {degrees:.1}°: towards its borders everything is stretched")
        }
        Warning::FarFromOrigin { ratio, digits } if pt => format!(
            "A câmera está {ratio:.2e} vezes mais longe da origem que de PF: só {digits} de 15 dígitos sobram para o que ela vê"
        ),
        Warning::FarFromOrigin { ratio, digits } => format!(
            "The camera is {ratio:.2e} times farther from the origin than from PF: only {digits} of 15 digits are left for what it sees"
        ),
        Warning::AspectMismatch { window, image } if pt => {
            format!("A janela tem aspecto {window:.4} e a imagem {image:.4}: as formas se esticam")
        }
        Warning::AspectMismatch { window, image } => {
            format!("The window has aspect {window:.4} and the image {image:.4}: shapes are stretched")
        }
    }
}
