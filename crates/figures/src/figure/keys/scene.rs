//! `[scene]`: a preset, a tree of objects, lights.

use glam::{DVec2, DVec3};

use super::Keys;
use crate::appearance::{Filter, Theme, Wrap};
use crate::figure::error::{Allowed, Problem};
use crate::figure::near;
use crate::figure::read::{Fault, Section};
use crate::figure::value::{ANGLES, COLOR, PAIR, TEXT, VECTOR, integer_in, number_in, quoted, write_vectors};
use crate::figure::words::{LIGHTS, PRESETS, SHAPES};
use crate::limits::{MAX_SEGMENTS, MAX_TEXTURE_SCALE, MIN_SEGMENTS};
use crate::scene::palette::SceneColors;
use crate::scene::{
    Light, LightKind, ObjectSpec, Preset, SceneError, SceneSpec, Shadows, Shape, ShapeData, TextureSource, check,
    preset_objects,
};

/// The section. If no preset is named it's the default one, unless objects are listed, because then these alone are the
/// scene.
pub(super) fn scene(keys: &mut Keys<'_>, scene: &mut SceneSpec) {
    let mut places = Places::default();
    if keys.is_writing() {
        keys.word("preset", PRESETS, &mut scene.preset);
    }
    let blank = |i: usize| ObjectSpec { shape: None, ..ObjectSpec::new(default_name(i), Shape::Box) };
    keys.list("objects", "[[scene.objects]]", usize::MAX, &mut scene.objects, blank, |keys, o, _| {
        places.objects.extend(keys.reading().map(|section| places_of(section)));
        object(keys, o);
        true
    });
    if !keys.is_writing() {
        let alone = if scene.objects.is_empty() { Preset::default() } else { Preset::Empty };
        scene.preset = alone;
        keys.word("preset", PRESETS, &mut scene.preset);
    }
    let blank = |_| Light::point(DVec3::ZERO);
    keys.list("lights", "[[scene.lights]]", usize::MAX, &mut scene.lights, blank, |keys, l, _| {
        light(keys, l, &mut places)
    });
    if keys.is_reading()
        && let Err(error) = check(scene)
    {
        keys.fault_later(places.fault(scene, error));
    }
}

/// The name of an object without one.
pub(in crate::figure) fn default_name(index: usize) -> String {
    format!("object {}", index + 1)
}

fn object(keys: &mut Keys<'_>, o: &mut ObjectSpec) {
    // Its keys depend on it, so it's read first.
    if let Some(section) = keys.reading() {
        o.shape = read_shape(section);
        o.segments = Shape::usual_segments(o.shape.as_ref());
    }
    keys.key("name", &TEXT, &mut o.name);
    keys.list_also(&["shape", "points", "path"]);
    if let Some(shape) = &o.shape {
        keys.put("shape", || shape.name().into());
        match shape.data() {
            ShapeData::Points(points) => keys.put("points", || write_vectors(points)),
            ShapeData::Path(path) => keys.put("path", || quoted(path)),
            ShapeData::None => {}
        }
    }
    keys.option("parent", &TEXT, &mut o.parent);
    keys.placed("translate", DVec3::ZERO, &VECTOR, &mut o.translate);
    keys.placed("rotate", DVec3::ZERO, &ANGLES, &mut o.rotate);
    keys.placed("scale", DVec3::ONE, &VECTOR, &mut o.scale);
    if let Some(section) = keys.reading()
        && o.scale.cmpeq(DVec3::ZERO).any()
    {
        section.refuse("scale", Allowed::NonZeroScale);
    }
    keys.option("color", &COLOR, &mut o.color);
    keys.switch("outline", &mut o.outline);
    let usual = Shape::usual_segments(o.shape.as_ref());
    keys.rare("segments", &usual, &integer_in([MIN_SEGMENTS, MAX_SEGMENTS].map(i64::from)), &mut o.segments);
    let texture = |s: &mut Section<'_>| s.get("texture", &TEXT).map(|text| TextureSource::of(&text));
    keys.optional_field("texture", &mut o.texture, texture, |texture| quoted(&texture.to_string()));
    keys.choice("wrap", Wrap::NAMED, &mut o.wrap);
    keys.choice("filter", Filter::NAMED, &mut o.filter);
    keys.rare("texture_scale", &DVec2::ONE, &PAIR, &mut o.texture_scale);
    if let Some(section) = keys.reading()
        && !o.texture_scale.to_array().into_iter().all(|v| v != 0.0 && v.abs() <= MAX_TEXTURE_SCALE)
    {
        section.refuse("texture_scale", Allowed::TextureScale);
    }
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
            Shape::Mesh { path: section.get("path", &TEXT)? }
        }
        other => other,
    })
}

/// False for a light without a kind.
fn light(keys: &mut Keys<'_>, light: &mut Light, places: &mut Places) -> bool {
    let mut kind = Some(light.kind);
    keys.require("kind", Allowed::word_of(LIGHTS));
    keys.choice("kind", LIGHTS, &mut kind);
    let Some(kind) = kind.filter(|_| keys.is_reading() || keys.is_writing()) else {
        shadows(keys, &mut light.shadows);
        // The keys of this kind aren't known, because the kind is the fault to report.
        LIGHTS.iter().for_each(|(_, kind)| keys.key(kind.vector().0, &VECTOR, &mut light.vector));
        return false;
    };
    let (key, usual) = kind.vector();
    if keys.is_reading() {
        (light.kind, light.vector) = (kind, usual);
    }
    keys.key(key, &VECTOR, &mut light.vector);
    if let Some(section) = keys.reading() {
        if kind == LightKind::Directional && light.vector == DVec3::ZERO {
            section.refuse(key, Allowed::NonZeroVector);
        }
        places.lights.push(section.place(key).unwrap_or(section.at));
    }
    shadows(keys, &mut light.shadows);
    true
}

fn shadows(keys: &mut Keys<'_>, shadows: &mut Shadows) {
    let (Shadows { cast, map, bias, softness }, usual) = (shadows, Shadows::NONE);
    keys.switch("shadows", cast);
    keys.rare("shadow_map", &usual.map, &integer_in(Shadows::MAPS.map(i64::from)), map);
    keys.rare("shadow_bias", &usual.bias, &number_in(Shadows::BIASES), bias);
    keys.rare("shadow_softness", &usual.softness, &number_in(Shadows::SOFTNESSES), softness);
}

/// The positions of objects and lights in the text.
#[derive(Default)]
struct Places {
    /// The start of each object, and the places of its keys.
    objects: Vec<(usize, Vec<(&'static str, usize)>)>,
    lights: Vec<usize>,
}

/// The start of an object, and the places of the keys that a rule for scenes concerns.
fn places_of(object: &Section<'_>) -> (usize, Vec<(&'static str, usize)>) {
    const KEYS: [&str; 6] = ["name", "parent", "translate", "rotate", "scale", "segments"];
    (object.at, KEYS.iter().filter_map(|key| Some((*key, object.place(key)?))).collect())
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
