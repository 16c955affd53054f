//! The words of appearance that scenes, drawings and figures share: colour, line style, and the `[style]` of a figure.
//!
//! A leaf module, which imports nothing of the crate.

mod level;
mod texture;

use std::fmt;
use std::str::FromStr;

pub use level::Level;
pub(crate) use level::LevelPairs;
pub use texture::{Filter, LEVEL_COLORS, LightShare, Sampler, Texture, TextureReveal, Wrap};

/// A colour with straight (not premultiplied) alpha, 8 bits a channel, in sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rgba {
    /// Red, 0 … 255.
    pub r: u8,
    /// Green, 0 … 255.
    pub g: u8,
    /// Blue, 0 … 255.
    pub b: u8,
    /// Opacity, 0 (clear) … 255 (opaque).
    pub a: u8,
}

impl Rgba {
    /// An opaque colour.
    pub const fn rgb(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b, a: 255 }
    }

    /// A colour with opacity.
    #[expect(clippy::self_named_constructors, reason = "named after its letters, as `rgb` is")]
    pub const fn rgba(r: u8, g: u8, b: u8, a: u8) -> Self {
        Self { r, g, b, a }
    }

    /// The same colour with another opacity.
    #[must_use]
    pub const fn with_alpha(self, a: u8) -> Self {
        Self { a, ..self }
    }

    /// The relative luminance of WCAG 2: 0 black … 1 white.
    pub fn luminance(self) -> f64 {
        let linear = |v: u8| {
            let v = f64::from(v) / 255.0;
            if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * linear(self.r) + 0.7152 * linear(self.g) + 0.0722 * linear(self.b)
    }

    /// The contrast of WCAG 2 between two opaque colours: 1 (equal) … 21 (black on white).
    pub fn contrast(self, other: Self) -> f64 {
        let (a, b) = (self.luminance() + 0.05, other.luminance() + 0.05);
        a.max(b) / a.min(b)
    }

    /// This colour if a stroke in it can be seen on `ground` (contrast at least 3), else the nearest one on the way
    /// to black or to white, whichever `ground` is farther from. The opacity stays.
    #[must_use]
    pub fn legible_on(self, ground: Self) -> Self {
        const ENOUGH: f64 = 3.0;
        // Black and white have equal contrast on a ground of this luminance.
        let end = if ground.luminance() > 0.179 { 0 } else { 255 };
        let mixed = |sixteenths: u16| {
            #[expect(clippy::cast_possible_truncation, reason = "a mean of two bytes")]
            let mix = |from: u8| ((u16::from(from) * (16 - sixteenths) + end * sixteenths) / 16) as u8;
            Self::rgba(mix(self.r), mix(self.g), mix(self.b), self.a)
        };
        (0..16).map(mixed).find(|c| c.contrast(ground) >= ENOUGH).unwrap_or_else(|| mixed(16))
    }

    /// True if nothing shows through.
    pub const fn is_opaque(self) -> bool {
        self.a == 255
    }
}

/// The reason why a text isn't a colour.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a colour is written \"#rrggbb\" or \"#rrggbbaa\" in hexadecimal digits")]
pub struct ColorError;

impl FromStr for Rgba {
    type Err = ColorError;

    /// Reads `#rrggbb` or `#rrggbbaa`.
    fn from_str(text: &str) -> Result<Self, ColorError> {
        let digits = text.strip_prefix('#').ok_or(ColorError)?;
        if !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return Err(ColorError);
        }
        let value = u32::from_str_radix(digits, 16).map_err(|_| ColorError)?;
        let bytes = match digits.len() {
            6 => ((value << 8) | 0xff).to_be_bytes(),
            8 => value.to_be_bytes(),
            _ => return Err(ColorError),
        };
        Ok(Self::rgba(bytes[0], bytes[1], bytes[2], bytes[3]))
    }
}

impl fmt::Display for Rgba {
    /// `#rrggbb` if opaque, `#rrggbbaa` otherwise.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.r, self.g, self.b)?;
        if !self.is_opaque() {
            write!(f, "{:02x}", self.a)?;
        }
        Ok(())
    }
}

/// Shading of faces (`[style] shading`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shading {
    /// Edges only, no faces.
    Wireframe,
    /// One colour a face, from the face's own normal.
    #[default]
    Flat,
    /// Light at the vertices, colours interpolated.
    Gouraud,
    /// Normals interpolated, light at each pixel.
    Phong,
}

/// Removal of hidden surfaces (`[style] visibility`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Visibility {
    /// A depth per pixel. The nearest wins.
    #[default]
    DepthBuffer,
    /// Faces sorted by the depth of their centroid. It fails if faces interlock, and is there to show this.
    Painter,
    /// Exact order by splitting faces at each other's planes.
    Bsp,
}

/// Drawing of the part of a line that lies behind a face (`[style] hidden_lines`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum HiddenLines {
    /// Drawn with dashes, thinner.
    #[default]
    Dashed,
    /// Not drawn.
    Hidden,
    /// Drawn as if nothing were in front of it.
    Shown,
    /// As the style of the picture says. Lines of a scene have this, strokes of a drawing never do.
    OfStyle,
}

/// The format in which the image stores depths (`[style] depth_format`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DepthFormat {
    /// Whole numbers of 16 bits.
    Fixed16,
    /// Whole numbers of 24 bits.
    Fixed24,
    /// Single precision and reversed: greater in front, 0 at the back of the range that a drawing spreads its depths
    /// over.
    #[default]
    Float,
}

impl DepthFormat {
    /// The greatest stored number, which stands for the depth 1. `None` means depths are stored as they are.
    pub const fn greatest(self) -> Option<f32> {
        match self {
            Self::Fixed16 => Some(65_535.0),
            Self::Fixed24 => Some(16_777_215.0),
            Self::Float => None,
        }
    }
}

crate::worded! {
    /// The order in which the depth buffer gets the opaque faces (`[style] order`). The image is the same in each.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum FaceOrder {
        /// As the scene lists them.
        #[default]
        AsListed = "as-listed",
        /// The nearest first, by the depths of their middles. Most hidden faces aren't filled then.
        FrontToBack = "front-to-back",
        /// The farthest first, as the painter does.
        BackToFront = "back-to-front",
    }
    /// Its name in a figure file.
    pub fn name
}

/// The ground and the contrast of all pictures (`[style] theme`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Theme {
    /// A light ground.
    #[default]
    Light,
    /// A dark ground.
    Dark,
    /// White ground and strokes that survive greyscale, for paper.
    Print,
}

impl Theme {
    /// The opaque colour of this theme among those of the light, the dark and the printed one, each `0xrrggbb`.
    pub const fn color(self, colors: [u32; 3]) -> Rgba {
        let [_, r, g, b] = colors[self as usize].to_be_bytes();
        Rgba::rgb(r, g, b)
    }
}

/// The number of samples in each pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Samples {
    /// The centre alone, without antialiasing.
    One,
    /// Two by two, on a turned lattice.
    #[default]
    Four,
    /// Four by four, on a turned lattice.
    Sixteen,
}

impl Samples {
    /// All, the fewest first.
    pub const ALL: [Self; 3] = [Self::One, Self::Four, Self::Sixteen];

    /// The number: 1, 4 or 16.
    pub const fn count(self) -> u8 {
        match self {
            Self::One => 1,
            Self::Four => 4,
            Self::Sixteen => 16,
        }
    }

    /// The samples of this number. `None` for numbers other than 1, 4 and 16.
    pub fn from_count(count: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|samples| samples.count() == count)
    }
}

impl fmt::Display for Samples {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.count().fmt(f)
    }
}

/// The format of the numbers in which vertices go through the pipeline (`[style] vertex_format`). All but `f64` imitate
/// other machines: each position is rounded to the format in the world, in view space, and in clip space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum VertexFormat {
    /// Double precision, the program's own.
    #[default]
    F64,
    /// Single precision, as in the vertex stage of a graphics card.
    F32,
    /// Half precision, IEEE 754 `binary16`: 11 bits, up to 65504.
    F16,
    /// `bfloat16`: 8 bits, with the range of single precision.
    Bf16,
    /// Fixed point: 16 bits before the point and 16 behind it, saturated at ±32768.
    Fixed16,
}

impl VertexFormat {
    /// The nearest number of the format. Of two, the one whose last bit is 0. Beyond the range of a float it's
    /// infinite.
    pub fn round(self, x: f64) -> f64 {
        // A float with this many bits, the exponent below which its steps grow no finer, and its greatest number.
        let float = |bits: i32, least: i32, greatest: f64| {
            let exponent = (x.to_bits() >> 52 & 0x7ff) as i32 - 1023;
            let step = 2_f64.powi(exponent.max(least) - (bits - 1));
            let rounded = (x / step).round_ties_even() * step;
            if rounded.abs() > greatest { f64::INFINITY.copysign(x) } else { rounded }
        };
        match self {
            Self::F64 => x,
            Self::F32 => float(24, -126, f32::MAX.into()),
            Self::F16 => float(11, -14, 65_504.0),
            Self::Bf16 => float(8, -126, 255.0 * 2_f64.powi(120)),
            Self::Fixed16 => (x * 65_536.0).round_ties_even().clamp(-2_147_483_648.0, 2_147_483_647.0) / 65_536.0,
        }
    }
}

/// The grid of a pixel on which corners of faces lie (`[style] subpixel_bits`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SubpixelBits {
    /// 16 steps, as in many phones.
    Four,
    /// 256 steps: the program's own, and most cards'.
    #[default]
    Eight,
    /// 4096 steps.
    Twelve,
}

impl SubpixelBits {
    /// All, the coarsest first.
    pub const ALL: [Self; 3] = [Self::Four, Self::Eight, Self::Twelve];

    /// The number: 4, 8 or 12.
    pub const fn count(self) -> u8 {
        match self {
            Self::Four => 4,
            Self::Eight => 8,
            Self::Twelve => 12,
        }
    }

    /// Steps per pixel.
    pub fn steps(self) -> f64 {
        f64::from(1_u16 << self.count())
    }
}

/// The `[style]` section of a figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Style {
    /// Shading of faces.
    pub shading: Shading,
    /// Removal of hidden surfaces.
    pub visibility: Visibility,
    /// Drawing of hidden parts of lines.
    pub hidden_lines: HiddenLines,
    /// Samples per pixel.
    pub antialias: Samples,
    /// The ground and the contrast.
    pub theme: Theme,
    /// The format in which the image stores depths.
    pub depth_format: DepthFormat,
    /// The format of the numbers of vertices.
    pub vertex_format: VertexFormat,
    /// The grid on which corners of faces lie.
    pub subpixel_bits: SubpixelBits,
    /// The order in which the image's depth buffer gets the faces.
    pub order: FaceOrder,
}

impl Style {
    /// This style with vertices as the program computes them.
    #[must_use]
    pub fn with_exact_vertices(self) -> Self {
        Self { vertex_format: VertexFormat::default(), subpixel_bits: SubpixelBits::default(), ..self }
    }
}

/// The pattern of a stroke. Lengths are multiples of the stroke's width.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Dash {
    /// No gaps.
    #[default]
    Solid,
    /// Dashes of 4 widths, gaps of 3.
    Dashed,
    /// Dots, gaps of 2.5 widths.
    Dotted,
    /// A dash, a dot.
    DashDot,
}

impl Dash {
    /// Lengths drawn and left out in turn, in multiples of the width, the round ends included. Empty means no gaps.
    pub const fn pattern(self) -> &'static [f32] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[4.0, 3.0],
            Self::Dotted => &[1.0, 2.5],
            Self::DashDot => &[4.0, 2.5, 1.0, 2.5],
        }
    }
}

/// The part that a text or a line plays in a picture. The layout of texts depends on it, never on colours and names,
/// which authors choose. Texts of the parts before [`Content`](Self::Content) choose their places in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// C.
    Center,
    /// PF.
    FocalPoint,
    /// An axis: the first, the second or the third.
    Axis(u8),
    /// VUP.
    ViewUp,
    /// The view window.
    Window,
    /// The far face of the view volume.
    FarFace,
    /// DOP.
    Direction,
    /// Something of the scene, or about it.
    #[default]
    Content,
    /// A text that stands beside bodies, not in front of them.
    Aside,
    /// A line that texts may cover: the ground grid.
    Ground,
}

/// The look of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineStyle {
    /// Colour of the stroke.
    pub color: Rgba,
    /// Width in pixels at scale 1.
    pub width: f32,
    /// Pattern of the part that can be seen.
    pub dash: Dash,
    /// Drawing of the part that lies behind a face.
    pub hidden: HiddenLines,
    /// An arrow head at the last point.
    pub arrow: bool,
}

/// The faces in front of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Occlusion {
    /// An opaque one.
    Opaque,
    /// No opaque one, but one of a tint.
    Translucent,
    /// None.
    None,
}

impl LineStyle {
    /// Without dashes and without an arrow.
    pub const fn solid(color: Rgba, width: f32, hidden: HiddenLines) -> Self {
        Self { color, width, dash: Dash::Solid, hidden, arrow: false }
    }

    /// The line as a picture in this style draws it. The style decides about hidden parts that are left to it.
    #[must_use]
    pub fn in_style(self, style: &Style) -> Self {
        let hidden = if self.hidden == HiddenLines::OfStyle { style.hidden_lines } else { self.hidden };
        Self { hidden, ..self }
    }

    /// The style of the part behind such faces. `None` means it isn't drawn.
    #[must_use]
    pub fn behind(self, faces: Occlusion) -> Option<Self> {
        #[expect(clippy::cast_possible_truncation, reason = "less than the alpha it comes from")]
        let faded = |tenths: u16| self.color.with_alpha((u16::from(self.color.a) * tenths / 10) as u8);
        match (faces, self.hidden) {
            (Occlusion::None, _) | (_, HiddenLines::Shown) => Some(self),
            (Occlusion::Translucent, _) => Some(Self { color: faded(3), ..self }),
            (Occlusion::Opaque, HiddenLines::Hidden) => None,
            (Occlusion::Opaque, HiddenLines::Dashed | HiddenLines::OfStyle) => {
                Some(Self { color: faded(7), width: 0.7 * self.width, dash: Dash::Dashed, ..self })
            }
        }
    }

    /// The lengths of dashes and of the gaps between them, in turn, for a painter that adds round ends to each. They
    /// are those of [`pattern`](Dash::pattern) without the ends, and empty if there are no gaps. The second value is
    /// the length of one period, which begins with half a width of gap.
    pub fn dash_lengths(self) -> (Vec<f32>, f32) {
        let pattern = self.dash.pattern();
        let period = pattern.iter().sum::<f32>() * self.width;
        // A pattern finer than a fifth of a pixel is seen as a plain line.
        if pattern.is_empty() || period < 0.2 || !period.is_finite() {
            return (Vec::new(), 0.0);
        }
        let length = |(k, part): (usize, &f32)| (if k % 2 == 0 { part - 1.0 } else { part + 1.0 }) * self.width;
        (pattern.iter().enumerate().map(length).collect(), period)
    }

    /// The length of the arrow head on a stroke of this length, both in pixels. Short strokes get small heads, and none
    /// below a few pixels. A head is 0.76 times as wide as long. The stroke goes on for a fifth of it inside.
    pub fn head_length(self, stroke_length: f32) -> f32 {
        let length = (4.0 * self.width + 4.0).min(0.6 * stroke_length);
        if !self.arrow || length < 2.0 { 0.0 } else { length }
    }
}

/// The corners of an arrow head between its point and the middle of its base.
pub fn head_corners([tip, base]: [[f32; 2]; 2]) -> [[f32; 2]; 3] {
    let (nx, ny) = (-0.38 * (tip[1] - base[1]), 0.38 * (tip[0] - base[0]));
    [tip, [base[0] + nx, base[1] + ny], [base[0] - nx, base[1] - ny]]
}

/// The shape of a point mark. Shapes differ so that colour never carries the meaning alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MarkShape {
    /// A filled disc.
    #[default]
    Disc,
    /// A ring.
    Ring,
    /// A filled square.
    Square,
    /// A filled diamond.
    Diamond,
    /// Two crossing strokes.
    Cross,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values from IEEE 754 `binary16`, from `bfloat16`, and by hand.
    #[test]
    fn formats_round_to_the_nearest_and_to_even() {
        let infinity = f64::INFINITY;
        for (format, x, rounded) in [
            (VertexFormat::F16, 1.0 / 3.0, 0.333_251_953_125),
            (VertexFormat::F16, -65_519.0, -65_504.0),
            (VertexFormat::F16, 65_520.0, infinity),
            (VertexFormat::F16, 2049.0, 2048.0),
            (VertexFormat::F16, 2051.0, 2052.0),
            (VertexFormat::F16, 2_f64.powi(-25), 0.0),
            (VertexFormat::F16, 1.5 * 2_f64.powi(-24), 2_f64.powi(-23)),
            (VertexFormat::Bf16, 1.0 / 3.0, 0.333_984_375),
            (VertexFormat::Bf16, 257.0, 256.0),
            (VertexFormat::Bf16, 3.4e38, infinity),
            (VertexFormat::F32, 16_777_217.0, 16_777_216.0),
            (VertexFormat::F32, -1e39, -infinity),
            (VertexFormat::Fixed16, 1.0 / 3.0, 21_845.0 / 65_536.0),
            (VertexFormat::Fixed16, 40_000.0, 32_768.0 - 1.0 / 65_536.0),
            (VertexFormat::Fixed16, -1e300, -32_768.0),
            (VertexFormat::F64, 0.1, 0.1),
            (VertexFormat::F16, -infinity, -infinity),
        ] {
            assert_eq!(format.round(x), rounded, "{x} in {format:?}");
        }
        for x in (0..2000).map(|k| (f64::from(k) * 0.37).sin() * 10_f64.powi(k % 90 - 45)) {
            #[expect(clippy::cast_possible_truncation, reason = "single precision is meant")]
            let single = f64::from(x as f32);
            assert_eq!(VertexFormat::F32.round(x), single, "{x}");
        }
    }

    #[test]
    fn contrast_is_that_of_wcag() {
        let (black, white) = (Rgba::rgb(0, 0, 0), Rgba::rgb(255, 255, 255));
        assert!((black.contrast(white) - 21.0).abs() < 1e-12);
        // A published example: #777777 on white is 4.48 : 1.
        assert!((Rgba::rgb(0x77, 0x77, 0x77).contrast(white) - 4.48).abs() < 0.005);
    }

    #[test]
    fn strokes_are_darkened_or_lightened_only_as_far_as_needed() {
        let yellow = Rgba::rgba(0xf0, 0xe4, 0x42, 90);
        let (white, night) = (Rgba::rgb(255, 255, 255), Rgba::rgb(0x16, 0x1a, 0x20));
        let dark = yellow.legible_on(white);
        assert!((3.0..3.6).contains(&dark.contrast(white)), "{dark}");
        assert_eq!(dark.a, 90);
        assert_eq!(yellow.legible_on(night), yellow);
        let navy = Rgba::rgb(0, 0x44, 0x88);
        assert_eq!(navy.legible_on(white), navy);
        assert!((3.0..3.6).contains(&navy.legible_on(night).contrast(night)));
        for grey in 0..=255 {
            let ground = Rgba::rgb(grey, grey, grey);
            assert!(ground.legible_on(ground).contrast(ground) >= 3.0, "{ground}");
        }
    }
}
