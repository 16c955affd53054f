//! [`Show`] → the `[show]` of a figure file.

use glam::DMat4;
use toml_edit::{Array, ArrayOfTables, InlineTable, Item, Table, Value};

use super::{camera, number, quoted, table, vector};
use crate::figure::words::{self, MEASURES, NDCS, STAGE_PICTURES, STAGES, TRIANGLE_STEPS, WAYS};
use crate::figure::{Show, ShownProbe, ShownStep, ShownTriangle, StagePicture, TransformPreview};

/// The section. Empty if nothing is shown.
pub(super) fn show(show: &Show) -> Table {
    let Show { stage, stage_of, painted, step, triangle, measure, measure_of, probe, moved, ndc, answer, operations } =
        show;
    let mut keys: Vec<(&str, Value)> = Vec::new();
    keys.extend(stage.map(|stage| ("stage", words::name(STAGES, stage).into())));
    if *stage_of != StagePicture::default() {
        keys.push(("stage_of", words::name(STAGE_PICTURES, *stage_of).into()));
    }
    keys.extend(painted.map(|share| ("painted", number(share))));
    keys.extend(step.map(|step| ("step", of_step(step))));
    keys.extend(triangle.as_ref().map(|triangle| ("triangle", of_triangle(triangle))));
    if !measure.is_empty() {
        let names: Array = measure.iter().map(|measured| words::name(MEASURES, *measured)).collect();
        keys.push(("measure", names.into()));
    }
    keys.extend(measure_of.as_ref().map(|object| ("measure_of", quoted(object))));
    keys.extend(probe.map(|probe| ("probe", of_probe(probe))));
    keys.extend(ndc.map(|ndc| ("ndc", words::name(NDCS, ndc).into())));
    match operations.as_slice() {
        [] => {}
        [one] => keys.push(("operation", one.to_string().into())),
        several => {
            let several: Array = several.iter().map(ToString::to_string).collect();
            keys.push(("operation", several.into()));
        }
    }
    let mut section = table(keys);
    let previews: ArrayOfTables = moved.iter().map(preview).collect();
    if !previews.is_empty() {
        section.insert("moved", Item::ArrayOfTables(previews));
    }
    if let Some(parameters) = answer {
        section.insert("answer", Item::Table(camera(parameters, None)));
    }
    section
}

fn inline<'a>(keys: impl IntoIterator<Item = (&'a str, Value)>) -> Value {
    keys.into_iter().collect::<InlineTable>().into()
}

fn of_step(step: ShownStep) -> Value {
    let at = step.at.map(|at| ("at", number(at)));
    inline([("way", words::name(WAYS, step.way).into())].into_iter().chain(at))
}

fn of_triangle(triangle: &ShownTriangle) -> Value {
    let pair = |[i, j]: [u32; 2]| Value::from([i, j].into_iter().map(i64::from).collect::<Array>());
    let pixel = triangle.pixel.map(|pixel| ("pixel", pair(pixel)));
    let keys = [
        ("object", quoted(&triangle.object)),
        ("index", i64::from(triangle.index).into()),
        ("step", words::name(TRIANGLE_STEPS, triangle.step).into()),
    ];
    inline(keys.into_iter().chain(pixel))
}

fn of_probe(probe: ShownProbe) -> Value {
    inline([match probe {
        ShownProbe::World(p) => ("world", vector(p)),
        ShownProbe::Window(p) => ("window", p.to_array().into_iter().map(number).collect::<Array>().into()),
        ShownProbe::Pixel(pixel) => ("pixel", pixel.into_iter().collect::<Array>().into()),
    }])
}

fn preview(preview: &TransformPreview) -> Table {
    let TransformPreview { objects, change, world_from_frame, axis, wrong } = preview;
    let names: Array = objects.iter().map(|name| quoted(name)).collect();
    let mut keys = vec![("objects", names.into()), ("change", matrix(change)), ("frame", matrix(world_from_frame))];
    keys.extend(
        axis.map(|axis| ("axis", inline([("origin", vector(axis.origin)), ("direction", vector(axis.direction))]))),
    );
    if *wrong {
        keys.push(("wrong", true.into()));
    }
    table(keys)
}

fn matrix(m: &DMat4) -> Value {
    let row = |i: usize| Value::from(m.row(i).to_array().into_iter().map(number).collect::<Array>());
    (0..4).map(row).collect::<Array>().into()
}
