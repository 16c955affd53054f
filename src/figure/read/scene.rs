//! The `[scene]` section: a preset, a tree of objects, lights.

use std::collections::HashMap;

use glam::DVec3;
use toml_edit::Document;

use super::line_of;
use super::section::{Fault, Section};
use crate::appearance::Theme;
use crate::figure::error::{Allowed, Problem};
use crate::figure::near;
use crate::figure::words::{LIGHTS, PRESETS, SHAPES};
use crate::scene::palette::SceneColors;
use crate::scene::{LightSpec, ObjectSpec, Preset, SceneSpec, Shape, preset_objects};

/// The fewest and the most segments of a curved shape.
const SEGMENTS: (i64, i64) = (3, 512);

/// Segments of a shape where the file says nothing.
pub(in crate::figure) fn default_segments(shape: Option<&Shape>) -> u32 {
    shape.map_or(32, Shape::default_segments)
}

/// Reads `[scene]`. Where no preset is named it is the default one, unless objects are listed: then these alone are the scene.
pub(super) fn scene(mut section: Section<'_>, faults: &mut Vec<Fault>) -> SceneSpec {
    let objects = section.sections("objects", "[[scene.objects]]");
    let alone = if objects.is_empty() { Preset::default() } else { Preset::Empty };
    let preset = section.word("preset", PRESETS, alone);
    let lights = section.sections("lights", "[[scene.lights]]");
    faults.extend(section.finish());
    SceneSpec {
        preset,
        objects: read_objects(objects, preset, faults),
        lights: lights.into_iter().filter_map(|light| read_light(light, faults)).collect(),
    }
}

/// Where the names of an object stand.
struct Places {
    name: usize,
    parent: usize,
}

fn read_objects(sections: Vec<Section<'_>>, preset: Preset, faults: &mut Vec<Fault>) -> Vec<ObjectSpec> {
    let mut objects = Vec::new();
    let mut places = Vec::new();
    for (i, mut section) in sections.into_iter().enumerate() {
        let place = |key| section.place(key).unwrap_or(section.start());
        places.push(Places { name: place("name"), parent: place("parent") });
        let shape = read_shape(&mut section);
        let segments = default_segments(shape.as_ref());
        objects.push(ObjectSpec {
            name: section.text("name").unwrap_or_else(|| default_name(i)),
            shape,
            parent: section.text("parent"),
            translate: section.vector("translate", DVec3::ZERO),
            rotate: section.angles("rotate", DVec3::ZERO),
            scale: read_scale(&mut section),
            color: section.color("color"),
            segments: section.integer("segments", SEGMENTS.0, SEGMENTS.1, segments),
        });
        faults.extend(section.finish());
    }
    check_tree(&objects, preset, &places, faults);
    objects
}

/// What an object is called that has no name.
fn default_name(index: usize) -> String {
    format!("object {}", index + 1)
}

fn read_scale(section: &mut Section<'_>) -> DVec3 {
    let scale = section.vector("scale", DVec3::ONE);
    if scale.cmpeq(DVec3::ZERO).any() {
        section.refuse("scale", Allowed::NonZeroScale);
    }
    scale
}

fn read_shape(section: &mut Section<'_>) -> Option<Shape> {
    Some(match section.choice("shape", SHAPES)? {
        Shape::Points(_) => Shape::Points(section.points("points", Allowed::Points)?),
        Shape::Segments(_) => {
            let points = section.points("points", Allowed::PointPairs)?;
            Shape::Segments(points.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect())
        }
        Shape::Mesh { .. } => {
            if !section.is_present("path") {
                section.missing("path", Allowed::Text);
            }
            Shape::Mesh { path: section.text("path")? }
        }
        other => other,
    })
}

/// Names are unique in the list, parents exist in it or in the preset, nobody is their own ancestor.
fn check_tree(objects: &[ObjectSpec], preset: Preset, places: &[Places], faults: &mut Vec<Fault>) {
    let of_preset = preset_objects(preset, &SceneColors::of(Theme::Light));
    let of_preset: Vec<&str> = of_preset.iter().map(|object| object.name.as_str()).collect();
    let mut fault = |at, key: &str, problem| {
        faults.push(Fault { at, key: format!("[[scene.objects]] {key}"), problem });
    };
    let mut index_of: HashMap<&str, usize> = HashMap::new();
    for (i, object) in objects.iter().enumerate() {
        if index_of.insert(&object.name, i).is_some() {
            fault(places[i].name, "name", Problem::DuplicateName { name: object.name.clone() });
        }
    }
    let parents: Vec<Option<usize>> =
        objects.iter().map(|object| index_of.get(object.parent.as_deref()?).copied()).collect();
    for (i, object) in objects.iter().enumerate() {
        let Some(name) = &object.parent else { continue };
        if parents[i].is_none() && !of_preset.contains(&name.as_str()) {
            let others = objects.iter().map(|o| o.name.as_str()).filter(|n| *n != object.name);
            let near = near::by_letters(name, others.chain(of_preset.iter().copied()));
            fault(places[i].parent, "parent", Problem::UnknownParent { name: name.clone(), near });
        }
    }
    if let Some(i) = find_cycle(&parents) {
        fault(places[i].parent, "parent", Problem::ParentCycle { name: objects[i].name.clone() });
    }
}

/// An object that is its own ancestor, if there is one.
fn find_cycle(parents: &[Option<usize>]) -> Option<usize> {
    // 0: not seen; otherwise the number of the walk that came by. So each object is passed once.
    let mut walk_of = vec![0_usize; parents.len()];
    for start in 0..parents.len() {
        let walk = start + 1;
        let mut at = Some(start);
        while let Some(i) = at.filter(|i| walk_of[*i] == 0) {
            walk_of[i] = walk;
            at = parents[i];
        }
        if at.is_some_and(|i| walk_of[i] == walk) {
            return at;
        }
    }
    None
}

fn read_light(mut section: Section<'_>, faults: &mut Vec<Fault>) -> Option<LightSpec> {
    if !section.is_present("kind") {
        section.missing("kind", Allowed::Word { words: vec!["directional", "point"], near: None });
    }
    let light = section.choice("kind", LIGHTS).map(|kind| match kind {
        LightSpec::Directional(default) => {
            let direction = section.vector("direction", default);
            if direction == DVec3::ZERO {
                section.refuse("direction", Allowed::NonZeroVector);
            }
            LightSpec::Directional(direction)
        }
        LightSpec::Point(default) => LightSpec::Point(section.vector("position", default)),
    });
    if light.is_none() {
        // Which keys belong here is not known; the kind is the fault to report.
        section.vector("direction", DVec3::ZERO);
        section.vector("position", DVec3::ZERO);
    }
    faults.extend(section.finish());
    light
}

/// The line of a key of the object called `name` (of the object itself, where the key is missing), counted from 1; `None`
/// where the text lists no such object.
#[must_use]
pub fn line_of_object(text: &str, name: &str, key: &str) -> Option<usize> {
    let document = Document::parse(text.strip_prefix('\u{feff}').unwrap_or(text)).ok()?;
    let mut root = Section::new(text, Some(document.as_table()), "", 0);
    let objects = root.section("scene", "").sections("objects", "");
    let found = objects.into_iter().enumerate().find_map(|(i, mut object)| {
        let called = object.text("name").unwrap_or_else(|| default_name(i));
        (called == name).then_some(object)
    })?;
    Some(line_of(document.raw(), found.place(key).unwrap_or(found.start())))
}
