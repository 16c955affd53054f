//! The choices of a figure that its scene doesn't make irrelevant, and the images that they give.

use crate::appearance::{FaceOrder, Filter, Samples, Shading, Style, Visibility};
use crate::figure::Figure;
use crate::figure::words::{DEPTH_FORMATS, FACE_ORDERS, SHADINGS, VISIBILITIES, Words};
use crate::limits::MAX_SHADOW_TEXELS;
use crate::pipeline::{Plan, Reason, Stage};
use crate::scene::{Light, ObjectPaint, Scene, SceneSpec, build, no_files};
use crate::views::Request;

/// Sides of shadow maps to try, texels.
const MAPS: [u32; 5] = [256, 512, 1024, 2048, 4096];
/// Biases to try.
const BIASES: [f64; 4] = [0.5, 1.0, 2.0, 4.0];

/// An order of faces that saves less than this share of the fills has nothing to set against the place of each
/// sample's face, which it keeps.
const FEW_FILLS: f64 = 0.1;

/// A key of a figure that may be chosen differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// `style.visibility`
    Visibility,
    /// `style.depth_format`
    DepthFormat,
    /// `style.order`
    Order,
    /// `style.antialias`
    Antialias,
    /// `style.shading`
    Shading,
    /// `filter` of an object of the figure.
    Filter(usize),
    /// `shadow_map` of a light.
    ShadowMap(usize),
    /// `shadow_bias` of a light.
    ShadowBias(usize),
}

impl Key {
    /// The path in a figure file, such as `scene.objects.0.filter`.
    pub fn path(self) -> String {
        match self {
            Self::Visibility => "style.visibility".to_owned(),
            Self::DepthFormat => "style.depth_format".to_owned(),
            Self::Order => "style.order".to_owned(),
            Self::Antialias => "style.antialias".to_owned(),
            Self::Shading => "style.shading".to_owned(),
            Self::Filter(k) => format!("scene.objects.{k}.filter"),
            Self::ShadowMap(k) => format!("scene.lights.{k}.shadow_map"),
            Self::ShadowBias(k) => format!("scene.lights.{k}.shadow_bias"),
        }
    }

    /// Keys with the same number interact, so their values are tried together even if each is beaten by itself.
    pub(super) const fn group(self) -> usize {
        match self {
            Self::Visibility | Self::DepthFormat | Self::Order => 0,
            Self::Antialias | Self::Filter(_) => 1,
            Self::Shading => 2,
            Self::ShadowMap(light) | Self::ShadowBias(light) => 3 + light,
        }
    }
}

/// A value of a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A word.
    Word(&'static str),
    /// A number.
    Number(f64),
}

/// A key with the values to try. The figure's own is among them.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The key.
    pub key: Key,
    /// The values.
    pub values: Vec<Value>,
    /// The place of the figure's own value.
    pub own: usize,
}

/// The reason why a key isn't tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WhyNot {
    /// It can't change this image, as the plan of the image says.
    Plan(Reason),
    /// Flat shading and wireframe are looks, not approximations.
    Look,
    /// The objects and lights of a preset have no key.
    Preset,
    /// The texture is nowhere smaller than a pixel, and its filter there is a look.
    Magnified,
    /// From one order of faces to another, the fills differ by less than a tenth: by this share, 0 … 1.
    FewFills(f64),
}

/// A key that isn't tried, with the reason.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// Its path, without a number if it's about all objects or lights.
    pub key: String,
    /// The reason.
    pub why: WhyNot,
}

/// Finds the choices of a figure. `plan`: that of its image with a depth buffer and several samples. `fills`: the
/// fills of that image in each order of faces. `minified`: for each object of the scene, true if its texture is
/// minified anywhere in the image.
pub(super) fn choices(
    figure: &Figure,
    scene: &Scene,
    plan: &Plan,
    fills: &[(FaceOrder, [u64; 2])],
    minified: &[bool],
) -> (Vec<Choice>, Vec<LeftOut>) {
    let (mut all, mut left_out) = (Vec::new(), Vec::new());
    let style = &figure.style;
    let mut add = |key: Key, values: Vec<Value>, own: Value| {
        let mut values = values;
        let own = values.iter().position(|value| *value == own).unwrap_or_else(|| {
            values.push(own);
            values.len() - 1
        });
        all.push(Choice { key, values, own });
    };
    let mut leave = |key: &str, why: WhyNot| left_out.push(LeftOut { key: key.to_owned(), why });
    let skipped = |stage| Some(plan.stage(stage)).filter(|stage| !stage.runs).map(|stage| WhyNot::Plan(stage.reason));
    let [no_hiding, no_faces] = [Stage::HiddenSurfaces, Stage::Fill].map(skipped);
    match no_hiding {
        Some(why) => {
            let keys = ["style.visibility", "style.depth_format", "style.order"];
            keys.into_iter().for_each(|key| leave(key, why));
        }
        None => {
            add(Key::Visibility, words(VISIBILITIES), word(VISIBILITIES, style.visibility));
            add(Key::DepthFormat, words(DEPTH_FORMATS), word(DEPTH_FORMATS, style.depth_format));
            let filled = || fills.iter().map(|(_, [filled, _])| *filled);
            let (least, most) = (filled().min().unwrap_or(0), filled().max().unwrap_or(0));
            let saved = (most - least) as f64 / most.max(1) as f64;
            if saved < FEW_FILLS {
                leave("style.order", WhyNot::FewFills(saved));
            } else {
                add(Key::Order, words(FACE_ORDERS), word(FACE_ORDERS, style.order));
            }
        }
    }
    match no_faces {
        Some(why) => leave("style.antialias", why),
        None => {
            let count = |samples: Samples| Value::Number(f64::from(samples.count()));
            add(Key::Antialias, Samples::ALL.map(count).to_vec(), count(style.antialias));
        }
    }
    let smooth = [Shading::Gouraud, Shading::Phong];
    match no_faces.or(skipped(Stage::Light).filter(|_| !is_lit(plan))) {
        _ if !smooth.contains(&style.shading) => leave("style.shading", no_faces.unwrap_or(WhyNot::Look)),
        Some(why) => leave("style.shading", why),
        None => {
            add(Key::Shading, smooth.map(|shading| word(SHADINGS, shading)).to_vec(), word(SHADINGS, style.shading));
        }
    }
    let first = own_objects(&figure.scene);
    match skipped(Stage::Texture) {
        Some(why) => leave("scene.objects.filter", why),
        None => {
            let filter = |place: usize| match &scene.objects.get(place)?.paint {
                ObjectPaint::Texture(pictured) if pictured.one_color().is_none() => Some(pictured.sampler.filter),
                _ => None,
            };
            if (0..first).any(|place| filter(place).is_some()) {
                leave("scene.objects.filter", WhyNot::Preset);
            }
            for (k, spec) in figure.scene.objects.iter().enumerate() {
                let parts = || (first..scene.objects.len()).filter(|&place| scene.objects[place].owner() == spec.name);
                let Some(own) = parts().find_map(filter) else { continue };
                if parts().any(|place| minified.get(place).copied().unwrap_or(false)) {
                    add(Key::Filter(k), words(Filter::NAMED), word(Filter::NAMED, own));
                } else {
                    leave(&Key::Filter(k).path(), WhyNot::Magnified);
                }
            }
        }
    }
    match skipped(Stage::Shadow) {
        Some(why) => {
            ["scene.lights.shadow_map", "scene.lights.shadow_bias"].into_iter().for_each(|key| leave(key, why));
        }
        None => {
            for (k, light) in figure.scene.lights.iter().enumerate().filter(|(_, light)| light.shadows.cast) {
                let number = |map: u32| Value::Number(f64::from(map));
                add(Key::ShadowMap(k), MAPS.map(number).to_vec(), number(light.shadows.map));
                add(Key::ShadowBias(k), BIASES.map(Value::Number).to_vec(), Value::Number(light.shadows.bias));
            }
        }
    }
    (all, left_out)
}

fn words<T>(words: Words<T>) -> Vec<Value> {
    words.iter().map(|(name, _)| Value::Word(name)).collect()
}

fn word<T: PartialEq>(words: Words<T>, value: T) -> Value {
    Value::Word(words.iter().find(|(_, of)| *of == value).map_or("", |(name, _)| name))
}

fn named<T: Copy>(words: Words<T>, value: Value) -> Option<T> {
    words.iter().find(|(name, _)| Value::Word(name) == value).map(|(_, of)| *of)
}

/// True if any object is lit, at its faces and vertices, or at its pixels.
fn is_lit(plan: &Plan) -> bool {
    plan.runs(Stage::Light) || matches!(plan.stage(Stage::Light).reason, Reason::LitPixels { .. })
}

/// The number of objects of a scene that come from its preset. They come first.
fn own_objects(spec: &SceneSpec) -> usize {
    let preset = SceneSpec { preset: spec.preset, ..SceneSpec::default() };
    build(&preset, &Style::default(), &mut no_files).map_or(0, |scene| scene.objects.len())
}

/// Places of values, one for each choice.
pub(super) type Combination = Vec<usize>;

/// A combination in which keys that mean nothing have the figure's value: those of a depth buffer without one.
pub(super) fn canonical(choices: &[Choice], mut combination: Combination) -> Combination {
    let value = |key: Key| {
        let place = choices.iter().position(|choice| choice.key == key)?;
        Some((place, choices[place].values[combination[place]]))
    };
    if value(Key::Visibility).is_some_and(|(_, visibility)| visibility != word(VISIBILITIES, Visibility::DepthBuffer)) {
        for (place, _) in [value(Key::DepthFormat), value(Key::Order)].into_iter().flatten() {
            combination[place] = choices[place].own;
        }
    }
    combination
}

/// Writes values of keys into a figure. Values that a key doesn't have are left out.
pub fn apply(figure: &mut Figure, changes: &[(Key, Value)]) {
    let (style, scene) = (&mut figure.style, &mut figure.scene);
    for &(key, value) in changes {
        match (key, value) {
            (Key::Visibility, _) => style.visibility = named(VISIBILITIES, value).unwrap_or(style.visibility),
            (Key::DepthFormat, _) => style.depth_format = named(DEPTH_FORMATS, value).unwrap_or(style.depth_format),
            (Key::Order, _) => style.order = named(FACE_ORDERS, value).unwrap_or(style.order),
            (Key::Shading, _) => style.shading = named(SHADINGS, value).unwrap_or(style.shading),
            (Key::Antialias, Value::Number(count)) => {
                let found = Samples::ALL.into_iter().find(|samples| f64::from(samples.count()) == count);
                style.antialias = found.unwrap_or(style.antialias);
            }
            (Key::Filter(k), _) => {
                if let Some(object) = scene.objects.get_mut(k) {
                    object.filter = named(Filter::NAMED, value).or(object.filter);
                }
            }
            (Key::ShadowMap(k), Value::Number(map)) => {
                if let Some(light) = scene.lights.get_mut(k) {
                    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "one of a few sizes")]
                    let map = map as u32;
                    light.shadows.map = map;
                }
            }
            (Key::ShadowBias(k), Value::Number(bias)) => {
                if let Some(light) = scene.lights.get_mut(k) {
                    light.shadows.bias = bias;
                }
            }
            (_, Value::Word(_)) => {}
        }
    }
}

/// The request for the image of a figure with other values of its keys, instead of its own. `None` if its shadow maps
/// would be too large together.
pub(super) fn chosen(own: &Request, figure: &Figure, changes: &[(Key, Value)]) -> Option<Request> {
    let mut other = figure.clone();
    apply(&mut other, changes);
    let request = own.clone().with_shot(|shot| shot.look.style = other.style);
    if other.scene == figure.scene {
        return Some(request);
    }
    // Meshes and textures stay the same.
    let mut scene = Scene::clone(&own.scene);
    let first = own_objects(&figure.scene);
    for object in scene.objects.iter_mut().skip(first) {
        let spec = other.scene.objects.iter().find(|spec| object.owner() == spec.name);
        if let (Some(filter), ObjectPaint::Texture(pictured)) = (spec.and_then(|spec| spec.filter), &mut object.paint) {
            pictured.sampler.filter = filter;
        }
    }
    if other.scene.lights.iter().map(Light::shadow_texels).fold(0, u64::saturating_add) > MAX_SHADOW_TEXELS {
        return None;
    }
    if !other.scene.lights.is_empty() {
        scene.lights.clone_from(&other.scene.lights);
    }
    Some(Request { scene: own.scene.marked(scene), ..request })
}
