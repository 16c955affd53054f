//! The stages of the pipeline, and the reason why each runs or is skipped.

pub use super::reasons::{planes, reason};
use crate::appearance::FaceOrder;
use crate::numbers;
use crate::picture::{Costs, PricedFace};
use crate::pipeline::{Containment, FacesDone, ObjectReport, Reason, Stage, StageReport};
use crate::stage::Operations;

texts!("why/pipeline");

/// The name of a stage, short enough for a column.
pub const fn stage(lang: Lang, stage: Stage) -> &'static str {
    match stage {
        Stage::Traverse => text!(lang, stage_traverse),
        Stage::CullObjects => text!(lang, stage_cull_objects),
        Stage::Normals => text!(lang, stage_normals),
        Stage::Light => text!(lang, stage_light),
        Stage::Transform => text!(lang, stage_transform),
        Stage::CullFaces => text!(lang, stage_cull_faces),
        Stage::Clip => text!(lang, stage_clip),
        Stage::Oblique => text!(lang, stage_oblique),
        Stage::Divide => text!(lang, stage_divide),
        Stage::Viewport => "viewport",
        Stage::Fill => text!(lang, stage_fill),
        Stage::Interpolate => text!(lang, stage_interpolate),
        Stage::HiddenSurfaces => text!(lang, stage_hidden_surfaces),
        Stage::Texture => text!(lang, stage_texture),
        Stage::Shadow => text!(lang, stage_shadow),
        Stage::Blend => text!(lang, stage_blend),
        Stage::Antialias => "antialiasing",
        Stage::Lines => text!(lang, stage_lines),
        Stage::Write => text!(lang, stage_write),
    }
}

/// The report of a stage: counts in and out, time, and reason. If it was skipped, the reason for that.
pub fn line(lang: Lang, report: &StageReport) -> String {
    let (name, reason) = (stage(lang, report.stage), reason(lang, report.reason));
    if !report.ran {
        return format!("{name}: {} – {reason}", left_out(lang));
    }
    let mut parts = Vec::new();
    if let Some((from, to)) = report.counts {
        let [from, to] = [from, to].map(numbers::in_threes);
        parts.push(format!("{from} → {to} {}", unit(lang, report)));
    }
    if let Some(time) = report.time {
        parts.push(lang.mark().printed(&numbers::duration(time)));
    }
    parts.push(reason);
    parts.extend(cost(lang, report));
    format!("{name}: {}", parts.join(" · "))
}

/// The operations of a stage in short. `None` if none were counted.
pub fn cost(lang: Lang, report: &StageReport) -> Option<String> {
    let Operations { float, integer, memory } = report.operations;
    let count = |n: u64| lang.mark().printed(&numbers::count(usize::try_from(n).unwrap_or(usize::MAX)));
    let [float_name, integer_name, memory_name] = text!(lang, cost);
    let counted = [(float, float_name), (integer, integer_name), (memory, memory_name)].into_iter();
    let said: Vec<String> = counted.filter(|(n, _)| *n > 0).map(|(n, name)| format!("{} {name}", count(n))).collect();
    (!said.is_empty()).then(|| said.join(", "))
}

/// The share of fills that were painted over, and what it would be in other orders of the faces. Empty without fills.
pub fn needless(lang: Lang, costs: &Costs) -> String {
    let line = |(place, &(order, [fills, over])): (usize, &(FaceOrder, [u64; 2]))| {
        let share = lang.mark().number(100.0 * over as f64 / fills as f64, 2);
        match order {
            _ if place == 0 => text!(lang, needless, share),
            FaceOrder::AsListed => text!(lang, needless_as_listed, share),
            FaceOrder::FrontToBack => text!(lang, needless_front, share),
            FaceOrder::BackToFront => text!(lang, needless_back, share),
        }
    };
    let counted = costs.fills.iter().enumerate().filter(|(_, (_, [fills, _]))| *fills > 0);
    counted.map(line).collect::<Vec<_>>().join(" ")
}

/// A face at a pixel: its distance from the eye, what hides it, and its cost.
pub fn face(lang: Lang, face: &PricedFace) -> String {
    let number = |value: f64| lang.mark().number(value, 4);
    let operations = numbers::in_threes(usize::try_from(face.operations).unwrap_or(usize::MAX));
    let distance = number(face.distance);
    match face.behind.map(number) {
        None => text!(lang, face_drawn, distance, operations),
        Some(behind) if face.is_partly_drawn => text!(lang, face_partly, distance, behind, operations),
        Some(behind) => text!(lang, face_hidden, distance, behind, operations),
    }
}

/// The action of a stage, in a sentence, with the place in the notes.
pub const fn purpose(lang: Lang, stage: Stage) -> &'static str {
    match stage {
        Stage::Traverse => text!(lang, purpose_traverse),
        Stage::CullObjects => text!(lang, purpose_cull_objects),
        Stage::Normals => text!(lang, purpose_normals),
        Stage::Light => text!(lang, purpose_light),
        Stage::Transform => text!(lang, purpose_transform),
        Stage::CullFaces => text!(lang, purpose_cull_faces),
        Stage::Clip => text!(lang, purpose_clip),
        Stage::Oblique => text!(lang, purpose_oblique),
        Stage::Divide => text!(lang, purpose_divide),
        Stage::Viewport => text!(lang, purpose_viewport),
        Stage::Fill => text!(lang, purpose_fill),
        Stage::Interpolate => text!(lang, purpose_interpolate),
        Stage::HiddenSurfaces => text!(lang, purpose_hidden_surfaces),
        Stage::Texture => text!(lang, purpose_texture),
        Stage::Shadow => text!(lang, purpose_shadow),
        Stage::Blend => text!(lang, purpose_blend),
        Stage::Antialias => text!(lang, purpose_antialias),
        Stage::Lines => text!(lang, purpose_lines),
        Stage::Write => text!(lang, purpose_write),
    }
}

/// The unit of a stage's counts. A sample is a pixel if there is one for each.
pub const fn unit(lang: Lang, report: &StageReport) -> &'static str {
    match (report.stage, report.reason) {
        (Stage::Traverse | Stage::CullObjects, _) => text!(lang, unit_traverse),
        (Stage::Transform | Stage::Viewport | Stage::Divide | Stage::Oblique | Stage::Normals, _)
        | (Stage::Light, Reason::LitVertices { .. }) => text!(lang, unit_light),
        (Stage::Fill, _) => text!(lang, unit_fill),
        (Stage::HiddenSurfaces, Reason::PaintedByCentroid | Reason::PaintedBySplitting | Reason::NoDepthBuffer) => {
            text!(lang, unit_pieces)
        }
        (
            Stage::CullFaces
            | Stage::Clip
            | Stage::Light
            | Stage::Interpolate
            | Stage::Texture
            | Stage::Shadow
            | Stage::Blend,
            _,
        ) => text!(lang, unit_triangles),
        (Stage::HiddenSurfaces, _) => text!(lang, unit_samples),
        (Stage::Antialias, _) => text!(lang, unit_antialias),
        (Stage::Lines, _) => text!(lang, unit_lines),
        (Stage::Write, _) => text!(lang, unit_write),
    }
}

/// "skipped": the mark of a stage that doesn't run.
pub const fn left_out(lang: Lang) -> &'static str {
    text!(lang, left_out)
}

/// The treatment of an object, and the reason.
pub fn object(lang: Lang, report: &ObjectReport) -> String {
    let mut text = match report.containment {
        Containment::Empty => {
            return text!(lang, object_empty).to_owned();
        }
        Containment::Outside(outside) => {
            let names = planes(lang, outside);
            return text!(lang, object_outside, names);
        }
        Containment::Crosses(0) => text!(lang, object_crosses).to_owned(),
        Containment::Crosses(crossed) => {
            let names = planes(lang, crossed);
            text!(lang, object_crosses_names, names)
        }
    };
    text += match report.faces {
        FacesDone::NotDrawn => text!(lang, object_not_drawn),
        FacesDone::BackDropped => text!(lang, object_back_dropped),
        FacesDone::BothSides => text!(lang, object_both_sides),
        FacesDone::CutOpen => text!(lang, object_cut_open),
    };
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_are_named_in_their_order() {
        assert_eq!(planes(Lang::En, 0b01_0001), "left and near");
        assert_eq!(planes(Lang::PtBr, 0b11_1110), "os planos da direita, de baixo, de cima, da frente e de fundo");
        assert_eq!(planes(Lang::PtBr, 0b01_0000), "o plano da frente");
        assert_eq!(planes(Lang::En, 0b10_0000), "far");
    }

    #[test]
    fn one_is_not_many() {
        assert_eq!(
            reason(Lang::En, Reason::Outside { outside: 1, of: 1 }),
            "1 of 1 object: all of the bounding box is outside one plane of the volume"
        );
        assert_eq!(reason(Lang::PtBr, Reason::LitFaces { objects: 2 }), "uma cor para cada face de 2 objetos");
    }

    #[test]
    fn stages_have_names_and_purposes_of_their_own() {
        for lang in [Lang::En, Lang::PtBr] {
            for texts in [Stage::ALL.map(|s| stage(lang, s)), Stage::ALL.map(|s| purpose(lang, s))] {
                let different: std::collections::BTreeSet<_> = texts.into_iter().collect();
                assert_eq!(different.len(), Stage::ALL.len());
            }
        }
    }
}
