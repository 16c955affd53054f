//! Pictures on surfaces: their levels of detail, and how they are asked for a colour.

use std::sync::{LazyLock, OnceLock};

use super::Rgba;
use super::level_pairs::LevelPairs;

/// A picture that is painted on surfaces, with its levels of detail.
#[derive(Clone, Debug)]
pub struct Texture {
    /// The picture itself, then smaller ones, each half as wide and high as the one before, down to one texel. Only the
    /// first is there where no filter asks for the others.
    levels: Vec<Level>,
    /// The same for filters that mix two levels; none where there is only one.
    pairs: Option<LevelPairs>,
    /// Looked for once, where somebody asks.
    one_color: OnceLock<Option<[u8; 4]>>,
    opaque: OnceLock<bool>,
}

impl PartialEq for Texture {
    fn eq(&self, other: &Self) -> bool {
        self.levels == other.levels
    }
}

/// One level of detail: premultiplied RGBA, rows from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Width in texels, at least 1.
    pub width: u32,
    /// Height in texels, at least 1.
    pub height: u32,
    /// 4 bytes a texel, premultiplied.
    pub rgba: Vec<u8>,
}

/// The continuation of a picture beyond its border.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// It is there again.
    #[default]
    Repeat,
    /// Its border goes on.
    Clamp,
    /// It is there again, mirrored each time.
    Mirror,
}

/// The way from texels to a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The nearest texel.
    Nearest,
    /// Between the four nearest texels.
    Bilinear,
    /// The same in the two levels of detail whose texels are about as large as a pixel, and between them.
    #[default]
    Trilinear,
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

/// The colours of levels of detail, from the picture itself on; the last goes on for all that are smaller.
pub const LEVEL_COLORS: [Rgba; 6] = [
    Rgba::rgb(0xd5, 0x5e, 0x00),
    Rgba::rgb(0xe6, 0x9f, 0x00),
    Rgba::rgb(0x00, 0x9e, 0x73),
    Rgba::rgb(0x56, 0xb4, 0xe9),
    Rgba::rgb(0x00, 0x72, 0xb2),
    Rgba::rgb(0xcc, 0x79, 0xa7),
];

/// How a picture is asked for a colour.
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

impl Wrap {
    /// All of them, with their names in a figure file.
    pub const NAMED: [(&'static str, Self); 3] =
        [("repeat", Self::Repeat), ("clamp", Self::Clamp), ("mirror", Self::Mirror)];

    /// Its name in a figure file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Repeat => "repeat",
            Self::Clamp => "clamp",
            Self::Mirror => "mirror",
        }
    }
}

impl Filter {
    /// All of them, with their names in a figure file.
    pub const NAMED: [(&'static str, Self); 3] =
        [("nearest", Self::Nearest), ("bilinear", Self::Bilinear), ("trilinear", Self::Trilinear)];

    /// Its name in a figure file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nearest => "nearest",
            Self::Bilinear => "bilinear",
            Self::Trilinear => "trilinear",
        }
    }
}

impl Sampler {
    /// A picture that is shown once, smoothly.
    pub const PICTURE: Self = Self { wrap_u: Wrap::Clamp, wrap_v: Wrap::Clamp, filter: Filter::Bilinear, reveal: None };
}

impl Texture {
    /// A picture without smaller levels. `rgba` has 4 bytes for each of `width` · `height` texels, premultiplied; what
    /// is missing is clear, and a picture without texels has one.
    #[must_use]
    pub fn flat(width: u32, height: u32, mut rgba: Vec<u8>) -> Self {
        let (width, height) = (width.max(1), height.max(1));
        rgba.resize(4 * width as usize * height as usize, 0);
        Self::of_levels(vec![Level { width, height, rgba }])
    }

    /// The same with all levels of detail: means over areas, in linear light, so that a level is as bright as the
    /// picture.
    #[must_use]
    pub fn with_levels(self) -> Self {
        let mut levels = self.levels;
        levels.truncate(1);
        while let Some(next) = levels.last().and_then(Level::half) {
            levels.push(next);
        }
        Self::of_levels(levels)
    }

    fn of_levels(levels: Vec<Level>) -> Self {
        let pairs = (levels.len() > 1).then(|| LevelPairs::new(&levels));
        Self { levels, pairs, one_color: OnceLock::new(), opaque: OnceLock::new() }
    }

    /// The levels of detail, the picture itself first; never empty.
    #[must_use]
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }

    /// The levels of detail in one array; `None` where there is only the picture itself.
    pub(crate) fn level_pairs(&self) -> Option<&LevelPairs> {
        self.pairs.as_ref()
    }

    /// Width in texels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.levels.first().map_or(1, |level| level.width)
    }

    /// Height in texels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.levels.first().map_or(1, |level| level.height)
    }

    /// The one colour of all its texels, premultiplied; `None` where they differ.
    #[must_use]
    pub fn one_color(&self) -> Option<[u8; 4]> {
        *self.one_color.get_or_init(|| {
            let texels = self.levels.first()?.rgba.as_chunks::<4>().0;
            let first = *texels.first()?;
            texels.iter().all(|texel| *texel == first).then_some(first)
        })
    }

    /// True where no texel lets anything through.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        *self.opaque.get_or_init(|| {
            self.levels.first().is_some_and(|level| level.rgba.as_chunks::<4>().0.iter().all(|texel| texel[3] == 255))
        })
    }
}

impl Level {
    /// The level that is half as wide and high; `None` where it is one texel.
    fn half(&self) -> Option<Self> {
        if self.width <= 1 && self.height <= 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let (columns, rows) = (Shares::new(self.width, width), Shares::new(self.height, height));
        let mut rgba = Vec::with_capacity(4 * width as usize * height as usize);
        for y in 0..height {
            for x in 0..width {
                let mut sum = [0.0_f32; 4];
                for (row, tall) in rows.of(y) {
                    for (column, wide) in columns.of(x) {
                        let texel = linear(self.texel(column, row));
                        for (sum, channel) in sum.iter_mut().zip(texel) {
                            *sum += tall * wide * channel;
                        }
                    }
                }
                rgba.extend(encoded(sum));
            }
        }
        Some(Self { width, height, rgba })
    }

    /// A texel by its column and row; clear outside.
    #[inline]
    #[must_use]
    pub fn texel(&self, x: u32, y: u32) -> [u8; 4] {
        self.at(y as usize * self.width as usize + x as usize)
    }

    /// A texel by its number, row by row; clear behind the last.
    #[inline]
    #[must_use]
    pub fn at(&self, index: usize) -> [u8; 4] {
        self.rgba.as_chunks::<4>().0.get(index).copied().unwrap_or_default()
    }
}

/// The texels of one axis that lie under each texel of a shorter one, with their shares.
struct Shares {
    long: u32,
    short: u32,
}

impl Shares {
    fn new(long: u32, short: u32) -> Self {
        Self { long, short }
    }

    /// Indices and shares of the texels under the `k`-th of the shorter axis; the shares add up to 1.
    fn of(&self, k: u32) -> impl Iterator<Item = (u32, f32)> {
        let step = f64::from(self.long) / f64::from(self.short);
        let (begin, end) = (f64::from(k) * step, f64::from(k + 1) * step);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 … long")]
        let (first, last) = (begin.floor() as u32, (end.ceil() as u32).min(self.long));
        (first..last).map(move |i| {
            let covered = end.min(f64::from(i + 1)) - begin.max(f64::from(i));
            #[expect(clippy::cast_possible_truncation, reason = "a share")]
            let share = (covered / step) as f32;
            (i, share)
        })
    }
}

/// The light of each byte.
static DECODED: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|byte| u8::try_from(byte).map_or(1.0, |byte| decoded(f32::from(byte) / 255.0)))
});

/// A premultiplied texel in linear light, still premultiplied; alpha 0 … 1.
fn linear(texel: [u8; 4]) -> [f32; 4] {
    let alpha = f32::from(texel[3]) / 255.0;
    match texel[3] {
        0 => return [0.0; 4],
        255 => {
            return [
                DECODED[usize::from(texel[0])],
                DECODED[usize::from(texel[1])],
                DECODED[usize::from(texel[2])],
                1.0,
            ];
        }
        _ => {}
    }
    let channel = |c: u8| alpha * decoded(f32::from(c) / 255.0 / alpha);
    [channel(texel[0]), channel(texel[1]), channel(texel[2]), alpha]
}

/// The way back from [`linear`].
fn encoded([r, g, b, alpha]: [f32; 4]) -> [u8; 4] {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "`as` saturates: 0 … 255")]
    let byte = |v: f32| (v * 255.0 + 0.5) as u8;
    if alpha <= 0.0 {
        return [0; 4];
    }
    let channel = |c: f32| byte(alpha * srgb((c / alpha).min(1.0)));
    [channel(r), channel(g), channel(b), byte(alpha)]
}

/// sRGB → linear light, both 0 … 1 (IEC 61966-2-1); in double precision, so that every machine rounds to the same byte.
fn decoded(v: f32) -> f32 {
    let v = f64::from(v);
    let light = if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
    #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
    let light = light as f32;
    light
}

/// Linear light → sRGB, both 0 … 1.
fn srgb(v: f32) -> f32 {
    let v = f64::from(v);
    let encoded = if v <= 0.003_130_8 { v * 12.92 } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
    let encoded = encoded as f32;
    encoded
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;

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
