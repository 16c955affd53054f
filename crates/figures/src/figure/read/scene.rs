//! The `[scene]` section: a preset, a tree of objects, lights.

use glam::{DVec2, DVec3};
use toml_edit::Document;

use super::line_of;
use super::section::{Fault, Section};
use crate::appearance::{Filter, Theme, Wrap};
use crate::figure::error::{Allowed, Problem};
use crate::figure::near;
use crate::figure::words::{LIGHTS, PRESETS, SHAPES};
use crate::limits::{MAX_SEGMENTS, MAX_TEXTURE_SCALE, MIN_SEGMENTS};
use crate::scene::palette::SceneColors;
use crate::scene::{
    Light, LightKind, ObjectSpec, Preset, SceneError, SceneSpec, Shadows, Shape, TextureSource, check, preset_objects,
};

/// Reads `[scene]`. If no preset is named it's the default one, unless objects are listed, because then these alone are
/// the scene.
pub(super) fn scene(mut section: Section<'_>, faults: &mut Vec<Fault>) -> SceneSpec {
    let objects = section.sections("objects", "[[scene.objects]]");
    let alone = if objects.is_empty() { Preset::default() } else { Preset::Empty };
    let preset = section.word("preset", PRESETS, alone);
    let lights = section.sections("lights", "[[scene.lights]]");
    faults.extend(section.finish());
    let mut places = Places::default();
    let spec = SceneSpec {
        preset,
        objects: objects
            .into_iter()
            .enumerate()
            .map(|(i, o)| o.finished(faults, |o| read_object(i, o, &mut places)))
            .collect(),
        lights: lights
            .into_iter()
            .filter_map(|light| light.finished(faults, |light| read_light(light, &mut places)))
            .collect(),
    };
    if let Err(error) = check(&spec) {
        faults.push(places.fault(&spec, error));
    }
    spec
}

/// The positions of objects and lights in the text.
#[derive(Default)]
struct Places {
    /// The start of each object, and the places of its keys.
    objects: Vec<(usize, Vec<(&'static str, usize)>)>,
    lights: Vec<usize>,
}

impl Places {
    /// The violation of a rule for scenes, at its place in the text.
    fn fault(&self, spec: &SceneSpec, error: SceneError) -> Fault {
        let key = error.key();
        let named = |name: &str| {
            let name = name.to_owned();
            spec.objects.iter().enumerate().filter(move |(_, object)| object.name == name).map(|(i, _)| i)
        };
        let index = match &error {
            // The second one is too many.
            SceneError::DuplicateName { name } => named(name).nth(1),
            _ => error.object().and_then(|name| named(name).next()),
        };
        let (at, label) = match (index.and_then(|i| self.objects.get(i)), &error) {
            (Some((start, keys)), _) => {
                let at = keys.iter().find(|(known, _)| *known == key).map_or(*start, |(_, at)| *at);
                (at, "[[scene.objects]]")
            }
            (None, SceneError::Light { index, .. }) => {
                (self.lights.get(*index).copied().unwrap_or_default(), "[[scene.lights]]")
            }
            (None, _) => (0, "[scene]"),
        };
        let near = near_parent(spec, &error);
        Fault { at, key: format!("{label} {key}"), problem: Problem::Scene { error: Box::new(error), near } }
    }
}

/// The object that the author probably meant as a parent.
fn near_parent(spec: &SceneSpec, error: &SceneError) -> Option<String> {
    let SceneError::UnknownParent { name, parent } = error else { return None };
    let of_preset = preset_objects(spec.preset, &SceneColors::of(Theme::Light));
    let all = spec.objects.iter().chain(&of_preset).map(|object| object.name.as_str());
    near::by_letters(parent, all.filter(|other| other != name))
}

fn read_object(index: usize, section: &mut Section<'_>, places: &mut Places) -> ObjectSpec {
    const KEYS: [&str; 6] = ["name", "parent", "translate", "rotate", "scale", "segments"];
    let keys = KEYS.iter().filter_map(|key| Some((*key, section.place(key)?))).collect();
    places.objects.push((section.at, keys));
    let shape = read_shape(section);
    let segments = Shape::usual_segments(shape.as_ref());
    ObjectSpec {
        name: section.text("name").unwrap_or_else(|| default_name(index)),
        shape,
        parent: section.text("parent"),
        translate: section.vector("translate", DVec3::ZERO),
        rotate: section.angles("rotate", DVec3::ZERO),
        scale: read_scale(section),
        color: section.color("color"),
        segments: section.integer("segments", i64::from(MIN_SEGMENTS), i64::from(MAX_SEGMENTS), segments),
        texture: section.text("texture").map(|text| TextureSource::of(&text)),
        wrap: section.choice("wrap", Wrap::NAMED),
        filter: section.choice("filter", Filter::NAMED),
        texture_scale: read_texture_scale(section),
    }
}

/// The name of an object without one.
fn default_name(index: usize) -> String {
    format!("object {}", index + 1)
}

fn read_texture_scale(section: &mut Section<'_>) -> DVec2 {
    let scale = section.pair("texture_scale").unwrap_or(DVec2::ONE);
    let is_allowed = |v: f64| v != 0.0 && v.abs() <= MAX_TEXTURE_SCALE;
    if !scale.to_array().into_iter().all(is_allowed) {
        section.refuse("texture_scale", Allowed::TextureScale);
        return DVec2::ONE;
    }
    scale
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
            section.require("path", Allowed::Text);
            Shape::Mesh { path: section.text("path")? }
        }
        other => other,
    })
}

fn read_light(section: &mut Section<'_>, places: &mut Places) -> Option<Light> {
    section.require("kind", Allowed::word_of(LIGHTS));
    let light = section.choice("kind", LIGHTS).map(|kind| {
        let (key, default) = kind.vector();
        let vector = section.vector(key, default);
        if kind == LightKind::Directional && vector == DVec3::ZERO {
            section.refuse(key, Allowed::NonZeroVector);
        }
        let shadows = read_shadows(section);
        places.lights.push(section.place(key).unwrap_or(section.at));
        Light { kind, vector, shadows }
    });
    if light.is_none() {
        read_shadows(section);
        // The keys of this kind aren't known, because the kind is the fault to report.
        for (_, kind) in LIGHTS {
            section.vector(kind.vector().0, DVec3::ZERO);
        }
    }
    light
}

fn read_shadows(section: &mut Section<'_>) -> Shadows {
    let usual = Shadows::NONE;
    let ([least, most], bias, softness) = (Shadows::MAPS.map(i64::from), Shadows::BIASES, Shadows::SOFTNESSES);
    Shadows {
        cast: section.switch("shadows"),
        map: section.integer("shadow_map", least, most, usual.map),
        bias: section.number_in("shadow_bias", bias[0], bias[1], usual.bias),
        softness: section.number_in("shadow_softness", softness[0], softness[1], usual.softness),
    }
}

/// The line of a key of the object called `name` (of the object itself, if the key is missing), counted from 1; `None`
/// if the text lists no such object.
pub fn line_of_object(text: &str, name: &str, key: &str) -> Option<usize> {
    let document = Document::parse(text.strip_prefix('\u{feff}').unwrap_or(text)).ok()?;
    let mut root = Section::new(text, Some(document.as_table()), "", 0);
    let objects = root.section("scene", "").sections("objects", "");
    let found = objects.into_iter().enumerate().find_map(|(i, mut object)| {
        let called = object.text("name").unwrap_or_else(|| default_name(i));
        (called == name).then_some(object)
    })?;
    Some(line_of(document.raw(), found.place(key).unwrap_or(found.at)))
}
