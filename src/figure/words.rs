//! The words of a figure file: each name as it is written there, with its value.

use super::{Depth, Outside};
use crate::appearance::{HiddenLines, Shading, Theme, Visibility};
use crate::camera::Projection;
use crate::scene::{LightSpec, Preset, Shape};

/// Names and their values, in the order in which they are offered.
pub type Words<T> = &'static [(&'static str, T)];

/// `projection`
pub const PROJECTIONS: Words<Projection> =
    &[("perspective", Projection::Perspective), ("parallel", Projection::Parallel)];

/// `[scene] preset`
pub const PRESETS: Words<Preset> = Preset::NAMED;

/// `[style] shading`
pub const SHADINGS: Words<Shading> = &[
    ("wireframe", Shading::Wireframe),
    ("flat", Shading::Flat),
    ("gouraud", Shading::Gouraud),
    ("phong", Shading::Phong),
];

/// `[style] visibility`
pub const VISIBILITIES: Words<Visibility> =
    &[("depth-buffer", Visibility::DepthBuffer), ("painter", Visibility::Painter), ("bsp", Visibility::Bsp)];

/// `[style] hidden_lines`
pub const HIDDEN_LINES: Words<HiddenLines> =
    &[("dashed", HiddenLines::Dashed), ("hidden", HiddenLines::Hidden), ("shown", HiddenLines::Shown)];

/// `[style] theme`
pub const THEMES: Words<Theme> = &[("light", Theme::Light), ("dark", Theme::Dark), ("print", Theme::Print)];

/// `[reveal] depth`, besides `true` and `false`
pub const DEPTHS: Words<Depth> = &[("linear", Depth::Linear)];

/// `[reveal] outside`
pub const OUTSIDES: Words<Outside> = &[("cut", Outside::Cut), ("tinted", Outside::Tinted), ("shown", Outside::Shown)];

/// `[[scene.objects]] shape`; those that have data are empty here.
pub const SHAPES: Words<Shape> = Shape::NAMED;

/// `[[scene.lights]] kind`; the vectors are what a light has that gives none.
pub const LIGHTS: Words<LightSpec> = LightSpec::NAMED;

/// The value called `name`.
#[must_use]
pub fn value<T: Clone>(words: Words<T>, name: &str) -> Option<T> {
    words.iter().find(|(word, _)| *word == name).map(|(_, value)| value.clone())
}

/// What `value` is called; empty where the list lacks it, which a test excludes.
#[must_use]
pub fn name<T: Copy + PartialEq>(words: Words<T>, value: T) -> &'static str {
    words.iter().find(|(_, v)| *v == value).map_or("", |(word, _)| word)
}

/// All names, in order.
pub(super) fn names<T>(words: Words<T>) -> Vec<&'static str> {
    words.iter().map(|(word, _)| *word).collect()
}
