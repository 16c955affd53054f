//! `[show]`: explanations in the pictures. A faulty key shows nothing.

use glam::{DMat4, DVec3};
use toml_edit::{Array, Item};

use super::{Keys, UNIT, camera, inline};
use crate::camera::{Operation, Parameters};
use crate::figure::error::{Allowed, Problem};
use crate::figure::read::Section;
use crate::figure::value::{MATRIX, PAIR, PIXEL, PIXEL_OF_IMAGE, TEXT, VECTOR, integer_in, number_in, quoted};
use crate::figure::words::{self, MEASURES, NDCS, STAGE_PICTURES, STAGES, TRIANGLE_STEPS, WAYS};
use crate::figure::{Show, ShownProbe, ShownStep, ShownTriangle, TransformPreview, TriangleStep};
use crate::geometry::Ray;
use crate::limits::MAX_SHOWN_OBJECTS;

pub(super) fn show(keys: &mut Keys<'_>, show: &mut Show) {
    keys.in_order(&["painted", "step", "triangle", "probe", "answer"]);
    keys.choice("stage", STAGES, &mut show.stage);
    keys.rare_word("stage_of", STAGE_PICTURES, &mut show.stage_of);
    keys.option("painted", &number_in(UNIT), &mut show.painted);
    step(keys, &mut show.step);
    triangle(keys, &mut show.triangle);
    let measures = |s: &mut Section<'_>, measures: &mut Vec<_>| *measures = s.words("measure", MEASURES);
    keys.field("measure", !show.measure.is_empty(), &mut show.measure, measures, |measures| {
        measures.iter().map(|measured| words::name(MEASURES, *measured)).collect::<Array>().into()
    });
    keys.option("measure_of", &TEXT, &mut show.measure_of);
    probe(keys, &mut show.probe);
    // Without the key it's that of the notes.
    let ndc = |s: &mut Section<'_>, ndc: &mut Option<_>| *ndc = s.choice("ndc", NDCS);
    keys.field("ndc", show.ndc.is_some(), &mut show.ndc, ndc, |ndc| words::name(NDCS, ndc.unwrap_or_default()).into());
    let written = !show.operations.is_empty();
    keys.field(
        "operation",
        written,
        &mut show.operations,
        |s, list| *list = operations(s),
        |list| match list.as_slice() {
            [one] => one.to_string().into(),
            several => several.iter().map(ToString::to_string).collect::<Array>().into(),
        },
    );
    moved(keys, &mut show.moved);
    let default = Parameters::default();
    keys.optional("answer", "[show.answer]", Item::Table, &mut show.answer, default, |keys, answer| {
        camera::camera(keys, answer, &mut None);
    });
}

/// One operation, or several in a list.
fn operations(section: &mut Section<'_>) -> Vec<Operation> {
    let key = "operation";
    if !section.is_list(key) {
        let Some(text) = section.get(key, &TEXT) else { return Vec::new() };
        let operation = text.parse().ok();
        if operation.is_none() {
            section.refuse(key, Allowed::Operations);
        }
        return operation.into_iter().collect();
    }
    let operations: Vec<Operation> = section.list(key, Allowed::Operations, |text| text.parse().ok());
    let (count, limit) = (operations.len(), Show::MOST_OPERATIONS);
    if count > limit {
        section.fault(key, Problem::TooMany { count, limit });
        return Vec::new();
    }
    operations
}

fn step(keys: &mut Keys<'_>, step: &mut Option<ShownStep>) {
    let blank = ShownStep { way: Default::default(), at: None };
    keys.optional("step", "[show] step.", inline, step, blank, |keys, step| {
        keys.word("way", WAYS, &mut step.way);
        // In either projection, so that a figure can still be read after a change of it.
        keys.option("at", &number_in([0.0, f64::from(step.way.most_steps())]), &mut step.at);
    });
}

fn triangle(keys: &mut Keys<'_>, triangle: &mut Option<ShownTriangle>) {
    let blank = ShownTriangle { object: String::new(), index: 0, step: TriangleStep::default(), pixel: None };
    keys.optional("triangle", "[show] triangle.", inline, triangle, blank, |keys, triangle| {
        keys.needed("object", &TEXT, &mut triangle.object);
        keys.key("index", &integer_in([0, i64::from(u32::MAX)]), &mut triangle.index);
        keys.word("step", TRIANGLE_STEPS, &mut triangle.step);
        keys.option("pixel", &PIXEL_OF_IMAGE, &mut triangle.pixel);
    });
}

fn probe(keys: &mut Keys<'_>, probe: &mut Option<ShownProbe>) {
    keys.optional("probe", "[show] probe.", inline, probe, ShownProbe::World(DVec3::ZERO), |keys, probe| {
        let (mut world, mut window, mut pixel) = match *probe {
            ShownProbe::World(p) => (Some(p), None, None),
            ShownProbe::Window(p) => (None, Some(p), None),
            ShownProbe::Pixel(pixel) => (None, None, Some(pixel)),
        };
        keys.option("world", &VECTOR, &mut world);
        keys.option("window", &PAIR, &mut window);
        keys.option("pixel", &PIXEL, &mut pixel);
        if let Some(section) = keys.reading() {
            let given = ["world", "window", "pixel"].into_iter().filter(|key| section.is_present(key));
            match given.collect::<Vec<_>>().as_slice() {
                [] => section.missing("world", Allowed::Vector),
                [_] => {}
                [_, second, ..] => section.refuse(second, Allowed::Either("world, window", "pixel")),
            }
        }
        let of_image = window.map(ShownProbe::Window).or(pixel.map(ShownProbe::Pixel));
        *probe = world.map(ShownProbe::World).or(of_image).unwrap_or(*probe);
    });
}

fn moved(keys: &mut Keys<'_>, previews: &mut Vec<TransformPreview>) {
    let blank = |_| TransformPreview {
        objects: Default::default(),
        change: DMat4::IDENTITY,
        world_from_frame: DMat4::IDENTITY,
        axis: None,
        wrong: false,
    };
    keys.list("moved", "[[show.moved]]", MAX_SHOWN_OBJECTS, previews, blank, |keys, preview, _| {
        keys.in_order(&["change", "frame", "objects", "wrong"]);
        keys.field(
            "objects",
            true,
            &mut preview.objects,
            |s, names| *names = s.list("objects", Allowed::Texts, |name| Some(name.to_owned())).into_iter().collect(),
            |names| names.iter().map(|name| quoted(name)).collect::<Array>().into(),
        );
        for (key, value) in [("change", &mut preview.change), ("frame", &mut preview.world_from_frame)] {
            keys.needed(key, &MATRIX, value);
        }
        axis(keys, &mut preview.axis);
        keys.switch("wrong", &mut preview.wrong);
        keys.is_good()
    });
}

fn axis(keys: &mut Keys<'_>, axis: &mut Option<Ray>) {
    let blank = Ray { origin: DVec3::ZERO, direction: DVec3::Y };
    keys.optional("axis", "[[show.moved]] axis.", inline, axis, blank, |keys, axis| {
        keys.key("origin", &VECTOR, &mut axis.origin);
        keys.key("direction", &VECTOR, &mut axis.direction);
        if let Some(section) = keys.reading() {
            if axis.direction == DVec3::ZERO {
                section.refuse("direction", Allowed::NonZeroVector);
            }
            // As written, if it's a unit vector except for rounding.
            if (axis.direction.length() - 1.0).abs() >= 1e-12 {
                axis.direction = axis.direction.normalize_or_zero();
            }
        }
    });
}
