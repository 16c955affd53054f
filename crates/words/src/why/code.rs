//! Texts in and about code that sets up a camera.

use crate::Lang;
use crate::camera::WorldUp;
use crate::explain::code::{CodeConvention, CodeTarget};
use crate::why::conventions::camera_axes;

texts!("why/code");

/// A convention that the code states about itself.
pub fn convention(lang: Lang, target: CodeTarget, convention: CodeConvention) -> String {
    let name = target.name();
    match convention {
        CodeConvention::OfTheNotes => text!(lang, convention_of_the_notes, name),
        CodeConvention::ColumnMajor => text!(lang, convention_column_major, name),
        CodeConvention::Radians => text!(lang, convention_radians).to_owned(),
        CodeConvention::Degrees => text!(lang, convention_degrees).to_owned(),
        CodeConvention::WindowCentre => text!(lang, convention_window_centre).to_owned(),
        CodeConvention::ByMatrix => text!(lang, convention_by_matrix, name),
        CodeConvention::Axes(axes) => {
            let camera = camera_axes(lang, axes);
            let world = match (axes.left_handed, axes.up) {
                (true, WorldUp::Z) => text!(lang, convention_z),
                (true, _) => text!(lang, convention_left_handed),
                (false, WorldUp::Z) => {
                    text!(lang, convention_z_up)
                }
                (false, _) => text!(lang, convention_as_here),
            };
            text!(lang, convention_axes, name, camera, world)
        }
        CodeConvention::Centimetres => text!(lang, convention_centimetres).to_owned(),
    }
}

/// The lines of comment above the code for a camera.
pub fn comments(lang: Lang, target: CodeTarget, conventions: &[CodeConvention]) -> Vec<String> {
    conventions.iter().map(|said| convention(lang, target, *said)).collect()
}
