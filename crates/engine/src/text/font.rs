//! Labels in the bundled fonts: the room that they take, and their outlines as points and curves. Pixels and vector
//! output call the same functions, so both agree.

use std::sync::LazyLock;

use skrifa::instance::{LocationRef, Size};
use skrifa::metrics::GlyphMetrics;
use skrifa::outline::{DrawSettings, OutlineGlyphCollection, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider};

use super::{Element, runs};

/// A font. A page downloads one with fewer characters of the same outlines, and without instructions for hinting
/// (`dist/web/fonts.sh`).
macro_rules! font {
    ($name:literal) => {{
        #[cfg(not(target_arch = "wasm32"))]
        let bytes = include_bytes!(concat!("../../fonts/", $name));
        #[cfg(target_arch = "wasm32")]
        let bytes = include_bytes!(concat!("../../fonts/page/", $name));
        bytes
    }};
}

/// `DejaVu Sans`: free licence (beside it), Latin with accents, Greek, arrows and mathematical signs.
pub static FONT_BYTES: &[u8] = font!("DejaVuSans.ttf");
/// The letters of mathematics, those of `KaTeX`: free licence (beside them).
pub const ROMAN_BYTES: &[u8] = font!("KaTeX_Main-Regular.ttf");
/// Vectors.
pub const BOLD_BYTES: &[u8] = font!("KaTeX_Main-Bold.ttf");
/// Other symbols.
pub const ITALIC_BYTES: &[u8] = font!("KaTeX_Math-Italic.ttf");

/// The font of a letter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Face {
    /// `DejaVu Sans`.
    #[default]
    Plain,
    /// Words and digits of mathematics.
    Roman,
    /// Vectors.
    Bold,
    /// Other symbols.
    Italic,
}

impl Face {
    /// All.
    pub const ALL: [Self; 4] = [Self::Plain, Self::Roman, Self::Bold, Self::Italic];

    /// The bytes of its font.
    pub fn bytes(self) -> &'static [u8] {
        match self {
            Self::Plain => FONT_BYTES,
            Self::Roman => ROMAN_BYTES,
            Self::Bold => BOLD_BYTES,
            Self::Italic => ITALIC_BYTES,
        }
    }

    fn font(self) -> Option<&'static Font> {
        FONTS[self as usize].as_ref()
    }

    fn has(self, c: char) -> bool {
        self.font().is_some_and(|font| font.charmap.map(c).is_some())
    }
}

/// The font of a character, and the character that it has there. The bold and italic letters of Unicode's mathematics
/// are letters of other fonts. `mathematical` means that the rest of the text too is in the letters of mathematics, if
/// these have it.
pub fn face(c: char, mathematical: bool) -> (Face, char) {
    let letter = |from: u32, to: char| char::from_u32(u32::from(to) + (u32::from(c) - from)).unwrap_or(c);
    let italic = |letter| (if mathematical { Face::Italic } else { Face::Plain }, letter);
    match c {
        '\u{1d400}'..='\u{1d419}' => (Face::Bold, letter(0x1d400, 'A')),
        '\u{1d41a}'..='\u{1d433}' => (Face::Bold, letter(0x1d41a, 'a')),
        '\u{1d7ce}'..='\u{1d7d7}' => (Face::Bold, letter(0x1d7ce, '0')),
        '\u{1d434}'..='\u{1d44d}' => italic(letter(0x1d434, 'A')),
        '\u{1d44e}'..='\u{1d467}' => italic(letter(0x1d44e, 'a')),
        '\u{210e}' => italic('h'),
        'α'..='ω' if mathematical && Face::Italic.has(c) => (Face::Italic, c),
        c if mathematical && Face::Roman.has(c) => (Face::Roman, c),
        c => (Face::Plain, c),
    }
}

/// Size of a subscript, as a share of the text's.
const SUBSCRIPT_SIZE: f32 = 0.7;
/// Distance of the baseline of a subscript below the text's, in ems of the text.
const SUBSCRIPT_DROP: f32 = 0.2;

/// The properties of the font, read once.
struct Font {
    charmap: skrifa::charmap::Charmap<'static>,
    metrics: GlyphMetrics<'static>,
    outlines: OutlineGlyphCollection<'static>,
    /// Font units per em.
    units_per_em: f32,
    /// Height of the letter x in ems.
    x_height: f32,
}

/// `None` only if the bundled bytes aren't a font. A test checks that they are.
static FONTS: LazyLock<[Option<Font>; 4]> = LazyLock::new(|| Face::ALL.map(|face| Font::of(face.bytes())));

impl Font {
    fn of(bytes: &'static [u8]) -> Option<Self> {
        let font = FontRef::new(bytes).ok()?;
        let metrics = font.metrics(Size::unscaled(), LocationRef::default());
        let glyph_metrics = font.glyph_metrics(Size::unscaled(), LocationRef::default());
        let charmap = font.charmap();
        let em = f32::from(metrics.units_per_em);
        // The font's table is too old to hold the height of x, so the letter itself tells it.
        let x_height = charmap.map('x').and_then(|x| glyph_metrics.bounds(x)).map_or(0.5 * em, |b| b.y_max);
        Some(Self {
            charmap,
            metrics: glyph_metrics,
            outlines: font.outline_glyphs(),
            units_per_em: em,
            x_height: x_height / em,
        })
    }
}

/// The room that a text takes, in the unit of its size (pixels).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// From the origin to the start of the next letter.
    pub width: f32,
    /// Height of its letters above the baseline.
    pub above: f32,
    /// Depth of its letters below the baseline. 0 if they stand on it.
    pub below: f32,
}

/// One character with its place: `x` and the baseline `y` (downwards) in ems of the text, `scale` of its own size.
struct Placed {
    font: &'static Font,
    glyph: GlyphId,
    x: f32,
    y: f32,
    scale: f32,
}

/// The room that `text` takes at `size` (height of the em in pixels), subscripts included.
pub fn measure(text: &str, size: f32, mathematical: bool) -> Extent {
    let (glyphs, width) = set(text, mathematical);
    let mut extent = Extent { width: width * size, above: 0.0, below: 0.0 };
    for Placed { font, glyph, y, scale, .. } in glyphs {
        let Some(bounds) = font.metrics.bounds(glyph) else { continue };
        let to_ems = scale / font.units_per_em;
        extent.above = extent.above.max((bounds.y_max * to_ems - y) * size);
        extent.below = extent.below.max((y - bounds.y_min * to_ems) * size);
    }
    extent
}

/// Height of the letter x at `size`.
pub fn x_height(size: f32) -> f32 {
    Face::Plain.font().map_or(0.0, |font| font.x_height * size)
}

/// The outline of `text` at `size` (height of the em in pixels). Filled by the non-zero rule it's the text. The origin
/// is the left end of the baseline, y points down. `_c` and `_{abc}` are set as subscripts. A character that the font
/// lacks becomes the font's box. Empty if there is nothing to fill (no text, blanks only, or a size that isn't
/// positive).
pub fn outline(text: &str, size: f32, mathematical: bool) -> Vec<Element> {
    let mut elements = Vec::new();
    if !(size.is_finite() && size > 0.0) {
        return elements;
    }
    for placed in set(text, mathematical).0 {
        let font = placed.font;
        let Some(glyph) = font.outlines.get(placed.glyph) else { continue };
        let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
        let scale = placed.scale * size / font.units_per_em;
        let mut pen = Pen { elements: &mut elements, scale, x: placed.x * size, y: placed.y * size };
        // A glyph that can't be read leaves its place empty.
        let _ = glyph.draw(settings, &mut pen);
    }
    elements
}

/// Sets a line: every glyph at its place, and the width, in ems.
fn set(text: &str, mathematical: bool) -> (Vec<Placed>, f32) {
    let mut placed = Vec::with_capacity(text.len());
    let mut x = 0.0;
    for run in runs(text) {
        let (scale, y) = if run.lowered { (SUBSCRIPT_SIZE, SUBSCRIPT_DROP) } else { (1.0, 0.0) };
        for c in run.text.chars().filter(|c| !c.is_control()) {
            let (face, c) = face(c, mathematical);
            let Some(font) = face.font() else { continue };
            let glyph = font.charmap.map(c).unwrap_or(GlyphId::NOTDEF);
            placed.push(Placed { font, glyph, x, y, scale });
            x += scale * font.metrics.advance_width(glyph).unwrap_or(0.0) / font.units_per_em;
        }
    }
    (placed, x)
}

/// A run of a text in one font, with its place in a line.
#[derive(Clone, Debug, PartialEq)]
pub struct SetRun {
    /// In the order of reading, on one line.
    pub text: String,
    /// Their font.
    pub face: Face,
    /// From the left end of the text's baseline to that of the run, in pixels. Y points down.
    pub at: [f32; 2],
    /// Height of its em in pixels.
    pub size: f32,
}

/// The runs of `text` at `size` (height of the em in pixels), as [`outline`] draws them.
pub fn set_runs(text: &str, size: f32, mathematical: bool) -> Vec<SetRun> {
    let mut x = 0.0;
    let mut set: Vec<SetRun> = Vec::new();
    let mut last = None;
    for run in runs(text) {
        let (scale, y) = if run.lowered { (SUBSCRIPT_SIZE, SUBSCRIPT_DROP) } else { (1.0, 0.0) };
        let size_here = scale * size;
        for c in run.text.chars().filter(|c| !c.is_control()) {
            let (face, c) = face(c, mathematical);
            match set.last_mut().filter(|_| last == Some((face, run.lowered))) {
                Some(run) => run.text.push(c),
                None => set.push(SetRun { text: c.to_string(), face, at: [x, y * size], size: size_here }),
            }
            last = Some((face, run.lowered));
            x += advance(face, glyph(face, c)) * size_here;
        }
    }
    set
}

/// The number of a character's glyph in a font. 0 if the font lacks it.
pub fn glyph(face: Face, c: char) -> u16 {
    let found = face.font().and_then(|font| font.charmap.map(c)).unwrap_or(GlyphId::NOTDEF);
    u16::try_from(found.to_u32()).unwrap_or_default()
}

/// From a glyph to the next one, in ems.
pub fn advance(face: Face, glyph: u16) -> f32 {
    let font = face.font();
    font.map_or(0.0, |font| font.metrics.advance_width(glyph.into()).unwrap_or(0.0) / font.units_per_em)
}

/// Takes an outline in font units (y up) to pixels (y down).
struct Pen<'a> {
    elements: &'a mut Vec<Element>,
    scale: f32,
    x: f32,
    y: f32,
}

impl Pen<'_> {
    fn at(&self, x: f32, y: f32) -> [f32; 2] {
        [self.x + self.scale * x, self.y - self.scale * y]
    }
}

impl OutlinePen for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        self.elements.push(Element::Move(self.at(x, y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.elements.push(Element::Line(self.at(x, y)));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.elements.push(Element::Quad(self.at(cx, cy), self.at(x, y)));
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        self.elements.push(Element::Cubic(self.at(ax, ay), self.at(bx, by), self.at(x, y)));
    }

    fn close(&mut self) {
        self.elements.push(Element::Close);
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

    use super::*;

    #[test]
    fn the_font_is_there_and_has_what_the_labels_need() {
        let font = Face::Plain.font().unwrap();
        for c in "ABCxyzuvn0123456789áàâãçéêíóôõúüÁÀÂÃÇÉÊÍÓÔÕÚαβθφλμ·×°−±√≤≥≠→←↑↓′″½²³".chars()
        {
            assert!(font.charmap.map(c).is_some(), "{c} is missing");
        }
    }

    #[test]
    fn widths_add_up_and_scale() {
        let w = |t| measure(t, 20.0, false).width;
        assert!((w("ab") - w("a") - w("b")).abs() < 1e-3);
        assert!((measure("abc", 40.0, false).width - 2.0 * w("abc")).abs() < 1e-3);
        assert!((w("x_c") - w("x") - 0.7 * w("c")).abs() < 1e-3);
        // DejaVu Sans: the letter x is 1212 of 2048 units wide and 1120 high.
        assert!((w("x") - 20.0 * 1212.0 / 2048.0).abs() < 1e-3);
        assert!((x_height(20.0) - 20.0 * 1120.0 / 2048.0).abs() < 1e-3);
    }

    /// Least and greatest x and y of the points of an outline.
    fn bounds(elements: &[Element]) -> [f32; 4] {
        let points = elements.iter().filter_map(|element| match *element {
            Element::Move(p) | Element::Line(p) | Element::Quad(_, p) | Element::Cubic(_, _, p) => Some(p),
            Element::Close => None,
        });
        points.fold([f32::MAX, f32::MAX, f32::MIN, f32::MIN], |[left, top, right, bottom], [x, y]| {
            [left.min(x), top.min(y), right.max(x), bottom.max(y)]
        })
    }

    #[test]
    fn an_outline_stands_on_its_baseline_and_spans_the_x_height() {
        let [_, top, _, bottom] = bounds(&outline("x", 2048.0, false));
        assert!(bottom.abs() < 1.0 && (top + 1120.0).abs() < 1.0, "{top} {bottom}");
    }

    #[test]
    fn what_is_measured_is_what_is_drawn() {
        for text in ["x", "PF", "far (B)", "fffttt", "@@@@", "WWWW", "x_c", "M_{prp}", "Ângulo θ", "gjpqy", "x_{gq}"]
        {
            let Extent { width, above, below } = measure(text, 100.0, false);
            let [left, top, right, bottom] = bounds(&outline(text, 100.0, false));
            assert!((above + top).abs() < 0.1 && (below - bottom.max(0.0)).abs() < 0.1, "{text}: {above} {below}");
            // Side bearings: letters keep a little distance from the ends of their room.
            assert!(
                (-3.0..12.0).contains(&left) && (-4.0..12.0).contains(&(width - right)),
                "{text}: {left} {right} {width}"
            );
        }
    }

    #[test]
    fn a_missing_character_shows_as_a_box() {
        let [left, top, right, bottom] = bounds(&outline("\u{10FFFD}", 20.0, false));
        assert!(right - left > 4.0 && bottom - top > 8.0);
    }

    #[test]
    fn nothing_to_draw_is_empty() {
        for text in ["", "  ", "\n\t"] {
            assert_eq!(outline(text, 12.0, false), []);
        }
        for size in [0.0, -3.0, f32::NAN, f32::INFINITY] {
            assert_eq!(outline("a", size, false), []);
        }
    }
}
