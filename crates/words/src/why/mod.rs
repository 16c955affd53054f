//! The explanations: the texts about matrices, points, stages and studies.

pub mod conventions;
pub mod dialects;
pub mod entry_reasons;
pub mod explain;
pub mod explain_point;
pub mod notes;
pub mod numerics;
pub mod order;
pub mod photograph;
pub mod pipeline;
pub mod reasons;
pub mod sources;
pub mod this_figure;

/// The explanation of w.
pub mod homogeneous {
    texts!("why/homogeneous");
}

/// Stages and hidden surfaces.
pub mod stages {
    use crate::stage::{Stage, WorksOn};

    texts!("why/stages");

    /// The display of a stage in a picture.
    pub const fn in_and_out(t: &Texts, stage: Stage) -> &'static str {
        match stage.works_on() {
            WorksOn::Objects => t.boxes,
            WorksOn::Normals => t.normals,
            WorksOn::Vertices => t.vertices,
            WorksOn::Faces => t.faces,
            WorksOn::Pieces => t.pieces,
            WorksOn::Colors | WorksOn::Pixels => t.halves,
        }
    }
}

/// One triangle step by step, among the explanations.
pub mod triangle {
    use crate::figure::TriangleStep;

    texts!("why/triangle");

    /// The name of a step.
    pub const fn step(t: &Texts, step: TriangleStep) -> &'static str {
        match step {
            TriangleStep::View => t.step_view,
            TriangleStep::Facing => t.step_facing,
            TriangleStep::Outcodes => t.step_outcodes,
            TriangleStep::Cuts => t.step_cuts,
            TriangleStep::Divide => t.step_divide,
            TriangleStep::Viewport => t.step_viewport,
            TriangleStep::Pixels => t.step_pixels,
            TriangleStep::Depth => t.step_depth,
        }
    }
}

/// Texts in and about code that sets up a camera.
pub mod code {
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
            CodeConvention::MovedBack(back) => {
                let back = lang.mark().number(back, 6);
                text!(lang, convention_moved_back, name, back)
            }
        }
    }

    /// The lines of comment above the code for a camera.
    pub fn comments(lang: Lang, target: CodeTarget, conventions: &[CodeConvention]) -> Vec<String> {
        conventions.iter().map(|said| convention(lang, target, *said)).collect()
    }
}
