//! Pictures on surfaces: their levels of detail, and how they're sampled.

use std::sync::OnceLock;

use super::Rgba;
use super::level::{Level, LevelPairs};

/// A picture that is painted on surfaces, with its levels of detail.
#[derive(Clone, Debug)]
pub struct Texture {
    /// The picture itself, then smaller ones, each half as wide and high as the one before, down to one texel. Only the
    /// first is there if no filter needs the others.
    levels: Vec<Level>,
    /// The same for filters that mix two levels. Laid out once a picture is drawn with such a filter.
    pairs: OnceLock<LevelPairs>,
    /// Computed once, when it's needed.
    one_color: OnceLock<Option<[u8; 4]>>,
    opaque: OnceLock<bool>,
}

impl PartialEq for Texture {
    fn eq(&self, other: &Self) -> bool {
        self.levels == other.levels
    }
}

crate::worded! {
    /// The continuation of a picture beyond its border.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Wrap {
        /// The picture repeats.
        #[default]
        Repeat = "repeat",
        /// Its border continues.
        Clamp = "clamp",
        /// The picture repeats, mirrored each time.
        Mirror = "mirror",
    }
    /// Its name in a figure file.
    pub fn name
}

crate::worded! {
    /// The way from texels to a colour.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Filter {
        /// The nearest texel.
        Nearest = "nearest",
        /// Between the four nearest texels.
        Bilinear = "bilinear",
        /// The same in the two levels of detail whose texels are about as large as a pixel, and between them.
        #[default]
        Trilinear = "trilinear",
    }
    /// Its name in a figure file.
    pub fn name
}

/// The light on a point of a surface, whatever its colour: the share of its own colour that it sends back, and the
/// white that is added, 0 … 1.
pub type LightShare = [f32; 2];

/// The inner work of texturing, made visible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TextureReveal {
    /// u and v are interpolated as if w were the same everywhere.
    Affine,
    /// Each level of detail has a colour of its own, mixed with the picture.
    Levels,
    /// The nearest texel, with lines between the texels where these are larger than a few pixels.
    Texels,
}

/// The colours of levels of detail, from the picture itself on. The last goes on for all that are smaller.
pub const LEVEL_COLORS: [Rgba; 6] = [
    Rgba::rgb(0xd5, 0x5e, 0x00),
    Rgba::rgb(0xe6, 0x9f, 0x00),
    Rgba::rgb(0x00, 0x9e, 0x73),
    Rgba::rgb(0x56, 0xb4, 0xe9),
    Rgba::rgb(0x00, 0x72, 0xb2),
    Rgba::rgb(0xcc, 0x79, 0xa7),
];

/// How a picture is sampled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Sampler {
    /// Along u.
    pub wrap_u: Wrap,
    /// Along v.
    pub wrap_v: Wrap,
    /// Between texels.
    pub filter: Filter,
    /// Inner work that is shown.
    pub reveal: Option<TextureReveal>,
}

impl Sampler {
    /// A picture that is shown once, smoothly.
    pub const PICTURE: Self = Self { wrap_u: Wrap::Clamp, wrap_v: Wrap::Clamp, filter: Filter::Bilinear, reveal: None };
}

impl Texture {
    /// A picture without smaller levels. `rgba` has 4 bytes for each of `width` · `height` texels, premultiplied.
    /// Missing texels are clear, and a picture without texels has one.
    pub fn flat(width: u32, height: u32, mut rgba: Vec<u8>) -> Self {
        let (width, height) = (width.max(1), height.max(1));
        rgba.resize(4 * width as usize * height as usize, 0);
        Self::of_levels(vec![Level { width, height, rgba }])
    }

    /// The same with all levels of detail, which are means over areas in linear light, so that a level is as bright as
    /// the picture.
    pub fn with_levels(self) -> Self {
        let mut levels = self.levels;
        levels.truncate(1);
        while let Some(next) = levels.last().and_then(Level::half) {
            levels.push(next);
        }
        Self::of_levels(levels)
    }

    fn of_levels(levels: Vec<Level>) -> Self {
        Self { levels, pairs: OnceLock::new(), one_color: OnceLock::new(), opaque: OnceLock::new() }
    }

    /// The levels of detail, the picture itself first. Never empty.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// The levels of detail in one array; `None` if there is only the picture itself.
    pub(crate) fn level_pairs(&self) -> Option<&LevelPairs> {
        (self.levels.len() > 1).then(|| self.pairs.get_or_init(|| LevelPairs::new(&self.levels)))
    }

    /// Width in texels.
    pub fn width(&self) -> u32 {
        self.levels.first().map_or(1, |level| level.width)
    }

    /// Height in texels.
    pub fn height(&self) -> u32 {
        self.levels.first().map_or(1, |level| level.height)
    }

    /// The one colour of all its texels, premultiplied; `None` if they differ.
    pub fn one_color(&self) -> Option<[u8; 4]> {
        *self.one_color.get_or_init(|| {
            let texels = self.levels.first()?.rgba.as_chunks::<4>().0;
            let first = *texels.first()?;
            texels.iter().all(|texel| *texel == first).then_some(first)
        })
    }

    /// The one colour of all its texels, multiplied by another one, opaque; `None` if they differ.
    pub fn one_color_times(&self, tint: Rgba) -> Option<Rgba> {
        let [r, g, b, _] = self.one_color()?;
        #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
        let product = |texel: u8, tint: u8| (f32::from(texel) * (f32::from(tint) / 255.0) + 0.5) as u8;
        Some(Rgba::rgb(product(r, tint.r), product(g, tint.g), product(b, tint.b)))
    }

    /// True if no texel lets anything through.
    pub fn is_opaque(&self) -> bool {
        *self.opaque.get_or_init(|| {
            self.levels.first().is_some_and(|level| level.rgba.as_chunks::<4>().0.iter().all(|texel| texel[3] == 255))
        })
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;
    use crate::appearance::level::srgb;

    #[test]
    fn levels_end_in_one_texel_and_keep_the_light() {
        // Chequers of black and white: the mean of the light is a half, which is 188 in sRGB, not 128.
        let chequer = |n: u32| {
            (0..n * n).flat_map(move |i| {
                [if (i % n + i / n).is_multiple_of(2) { 255 } else { 0 }; 3].into_iter().chain([255])
            })
        };
        for n in [2, 4, 64] {
            let texture = Texture::flat(n, n, chequer(n).collect()).with_levels();
            let last = texture.levels().last().unwrap();
            assert_eq!((last.width, last.height, last.texel(0, 0)), (1, 1, [188, 188, 188, 255]));
            assert_eq!(texture.levels().len(), n.ilog2() as usize + 1);
        }
    }

    #[test]
    fn sides_that_are_no_powers_of_two_are_halved_by_areas() {
        let texture =
            Texture::flat(5, 1, [[255; 4], [0, 0, 0, 255], [255; 4], [0, 0, 0, 255], [255; 4]].concat()).with_levels();
        let sizes: Vec<_> = texture.levels().iter().map(|level| (level.width, level.height)).collect();
        assert_eq!(sizes, [(5, 1), (2, 1), (1, 1)]);
        // 1.5 of 2.5 texels are white in each half.
        let [r, ..] = texture.levels()[1].texel(0, 0);
        assert_eq!(r, texture.levels()[1].texel(1, 0)[0]);
        assert!((f64::from(r) / 255.0 - f64::from(srgb(0.6))).abs() < 0.003, "{r}");
    }

    #[test]
    fn clear_texels_do_not_darken_their_neighbours() {
        let texture = Texture::flat(2, 1, vec![200, 100, 50, 255, 0, 0, 0, 0]).with_levels();
        let [r, g, b, a] = texture.levels()[1].texel(0, 0);
        assert_eq!(a, 128);
        for (half, whole) in [(r, 200), (g, 100), (b, 50)] {
            assert!((i32::from(half) - whole / 2).abs() <= 1, "{half} {whole}");
        }
    }

    #[test]
    fn a_picture_that_lacks_texels_is_clear_there() {
        let texture = Texture::flat(0, 2, vec![9; 4]);
        assert_eq!((texture.width(), texture.height(), texture.levels()[0].texel(0, 1)), (1, 2, [0; 4]));
        assert_eq!(Texture::flat(1, 2, vec![9; 8]).one_color(), Some([9; 4]));
        assert_eq!(texture.one_color(), None);
    }
}
