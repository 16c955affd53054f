//! The tab that follows a point.

use crate::numbers::significant;
use crate::sanitize::escaped;
use crate::views::{ShadowAt, TexelAt};

texts!("why/explain_point");

/// The depths compared for the shadow at a point.
pub fn in_shadow(lang: Lang, at: &ShadowAt, digits: usize) -> String {
    let number = |value: f64| lang.mark().printed(&significant(value, digits));
    let (light, own, size, [i, j]) = (at.light + 1, number(at.own), at.size, at.texel);
    let Some(map) = at.nearest.map(number) else {
        return text!(lang, in_shadow_empty, light, own);
    };
    let lit = match at.is_hidden() {
        true => text!(lang, in_shadow_dark),
        false => text!(lang, in_shadow_lit),
    };
    text!(lang, in_shadow, light, own, map, i, j, size, lit)
}

/// The place of a point in a texture.
pub fn on_texture(lang: Lang, at: &TexelAt, digits: usize) -> String {
    let number = |value: f64| lang.mark().printed(&significant(value, digits));
    let ([u, v], [i, j], [wide, high], object) = (at.uv.map(number), at.texel, at.size, escaped(&at.object));
    text!(lang, on_texture, object, u, v, i, j, wide, high)
}

impl Texts {
    /// A space, by its name in `camera-lab inspect`.
    pub fn space(&self, name: &str) -> &'static str {
        match name {
            "local" => self.local,
            "world" => self.world,
            "view" => self.view,
            "clip" => self.clip,
            "ndc" => self.ndc,
            "window" => self.window,
            "pixel" => self.pixel,
            "viewport" => self.viewport,
            _ => self.homogeneous,
        }
    }
}
