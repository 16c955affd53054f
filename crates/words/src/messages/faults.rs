//! Errors and warnings of the model beside the window's fields, in the symbols that these have.

use super::cameras::{camera_wording, warning_wording};
use super::scene_errors::scene_wording;
pub use super::scene_errors::segments_allowed;
use crate::Lang;
use crate::camera::{CameraError, Warning};
use crate::scene::SceneError;

/// The reason why camera parameters aren't a camera.
pub fn camera_error(lang: Lang, error: &CameraError) -> String {
    camera_wording(lang, error).in_symbols
}

/// A warning about a camera that is possible, but probably not meant.
pub fn warning(lang: Lang, warning: &Warning) -> String {
    warning_wording(lang, warning).in_symbols
}

/// The reason why an object or a light is impossible.
pub fn scene_error(lang: Lang, error: &SceneError) -> String {
    scene_wording(lang, error).in_symbols
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::messages;

    #[test]
    fn numbers_in_warnings_of_the_window_are_written_as_the_language_writes_them() {
        let aspect = Warning::AspectMismatch { window: 0.75, image: 1.25 };
        assert_eq!(warning(Lang::PtBr, &aspect), "A janela tem aspecto 0,7500 e a imagem 1,2500: as formas se esticam");
        assert!(warning(Lang::En, &aspect).contains("0.7500"));
        assert!(messages::warning(Lang::PtBr, &aspect).contains("0.750000"), "beside the figure file a point");
        let others = [
            Warning::ViewUpNearlyCollinear { degrees: 1.5e-7 },
            Warning::DepthPrecision { ratio: 1.5e7, step: 2.5 },
            Warning::WideAngle { degrees: 170.5 },
            Warning::FarFromOrigin { ratio: 1.5e9, digits: 6 },
        ];
        for warning in others {
            let text = super::warning(Lang::PtBr, &warning);
            assert!(text.contains(",5") && !text.contains(".5"), "{text}");
        }
        assert_eq!(messages::outside(Lang::PtBr, -0.5, 1.0), "tem de estar entre −0,5 e 1");
    }
}
