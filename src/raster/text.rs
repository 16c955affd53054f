//! Texts as outlines: characters of the bundled font → paths. One function feeds pixels and vector output, so both agree.

use std::sync::LazyLock;

use skrifa::instance::{LocationRef, Size};
use skrifa::metrics::GlyphMetrics;
use skrifa::outline::{DrawSettings, OutlineGlyphCollection, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider};
use tiny_skia::{Path, PathBuilder};

/// `DejaVu Sans`: free licence (beside it), Latin with accents, Greek, arrows and mathematical signs.
static FONT_BYTES: &[u8] = include_bytes!("../../assets/fonts/DejaVuSans.ttf");

/// Size of a subscript, as a share of the text's.
const SUBSCRIPT_SIZE: f32 = 0.7;
/// How far the baseline of a subscript lies below the text's, in ems of the text.
const SUBSCRIPT_DROP: f32 = 0.2;

/// What the font knows, read once.
struct Font {
    charmap: skrifa::charmap::Charmap<'static>,
    metrics: GlyphMetrics<'static>,
    outlines: OutlineGlyphCollection<'static>,
    /// Font units per em.
    units_per_em: f32,
    /// Height of the letter x in ems.
    x_height: f32,
    ascent: f32,
    descent: f32,
}

/// `None` only if the bundled bytes were no font; a test holds them to be one.
static FONT: LazyLock<Option<Font>> = LazyLock::new(|| {
    let font = FontRef::new(FONT_BYTES).ok()?;
    let metrics = font.metrics(Size::unscaled(), LocationRef::default());
    let glyph_metrics = font.glyph_metrics(Size::unscaled(), LocationRef::default());
    let charmap = font.charmap();
    let em = f32::from(metrics.units_per_em);
    // The font's table is too old to hold the height of x: the letter itself tells it.
    let x_height = charmap.map('x').and_then(|x| glyph_metrics.bounds(x)).map_or(0.5 * em, |b| b.y_max);
    Some(Font {
        charmap,
        metrics: glyph_metrics,
        outlines: font.outline_glyphs(),
        units_per_em: em,
        x_height: x_height / em,
        ascent: metrics.ascent / em,
        descent: -metrics.descent / em,
    })
});

/// The room that a text takes, in the unit of its size (pixels).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// From the origin to where the next letter would begin.
    pub width: f32,
    /// Above the baseline, the same for every text of this size.
    pub ascent: f32,
    /// Below the baseline, the same for every text of this size.
    pub descent: f32,
}

/// One character with its place: `x` and the baseline `y` (downwards) in ems of the text, `scale` of its own size.
struct Placed {
    glyph: GlyphId,
    x: f32,
    y: f32,
    scale: f32,
}

/// The room that `text` takes at `size` (height of the em in pixels), subscripts included.
#[must_use]
pub fn measure(text: &str, size: f32) -> Extent {
    let Some(font) = FONT.as_ref() else { return Extent::default() };
    let (_, width) = set(font, text);
    Extent { width: width * size, ascent: font.ascent * size, descent: font.descent * size }
}

/// Height of the letter x at `size`.
#[must_use]
pub fn x_height(size: f32) -> f32 {
    FONT.as_ref().map_or(0.0, |font| font.x_height * size)
}

/// The outline of `text` at `size` (height of the em in pixels): filled by the non-zero rule it is the text. The origin is
/// the left end of the baseline, y points down. `_c` and `_{abc}` are set as subscripts. A character that the font lacks
/// becomes the font's box. `None` where there is nothing to fill (empty, blanks only, or a size that is not positive).
#[must_use]
pub fn outline(text: &str, size: f32) -> Option<Path> {
    if !(size.is_finite() && size > 0.0) {
        return None;
    }
    let font = FONT.as_ref()?;
    let (glyphs, _) = set(font, text);
    let mut builder = PathBuilder::new();
    for placed in glyphs {
        let Some(glyph) = font.outlines.get(placed.glyph) else { continue };
        let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
        let scale = placed.scale * size / font.units_per_em;
        let mut pen = Pen { builder: &mut builder, scale, x: placed.x * size, y: placed.y * size };
        // A glyph that cannot be read leaves its place empty.
        let _ = glyph.draw(settings, &mut pen);
    }
    builder.finish()
}

/// Sets a line: every glyph at its place, and the width, in ems.
fn set(font: &Font, text: &str) -> (Vec<Placed>, f32) {
    let mut placed = Vec::with_capacity(text.len());
    let mut x = 0.0;
    for (c, lowered) in characters(text) {
        if c.is_control() {
            continue;
        }
        let glyph = font.charmap.map(c).unwrap_or(GlyphId::NOTDEF);
        let (scale, y) = if lowered { (SUBSCRIPT_SIZE, SUBSCRIPT_DROP) } else { (1.0, 0.0) };
        placed.push(Placed { glyph, x, y, scale });
        x += scale * font.metrics.advance_width(glyph).unwrap_or(0.0) / font.units_per_em;
    }
    (placed, x)
}

/// The characters of a label with the sign whether each is lowered. A `_` with nothing to lower stands for itself.
fn characters(text: &str) -> Vec<(char, bool)> {
    let mut result = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        if c != '_' {
            result.push((c, false));
        } else if let Some((group, after)) = rest.strip_prefix('{').and_then(|r| r.split_once('}')) {
            result.extend(group.chars().map(|c| (c, true)));
            rest = after;
        } else if let Some(next) = rest.chars().next() {
            result.push((next, true));
            rest = &rest[next.len_utf8()..];
        } else {
            result.push(('_', false));
        }
    }
    result
}

/// Takes an outline in font units (y up) to the builder's pixels (y down).
struct Pen<'a> {
    builder: &'a mut PathBuilder,
    scale: f32,
    x: f32,
    y: f32,
}

impl Pen<'_> {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + self.scale * x, self.y - self.scale * y)
    }
}

impl OutlinePen for Pen<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let p = self.at(x, y);
        self.builder.move_to(p.0, p.1);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let p = self.at(x, y);
        self.builder.line_to(p.0, p.1);
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        let (c, p) = (self.at(cx, cy), self.at(x, y));
        self.builder.quad_to(c.0, c.1, p.0, p.1);
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        let (a, b, p) = (self.at(ax, ay), self.at(bx, by), self.at(x, y));
        self.builder.cubic_to(a.0, a.1, b.0, b.1, p.0, p.1);
    }

    fn close(&mut self) {
        self.builder.close();
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failed unwrap is a failed test")]

    use super::*;

    #[test]
    fn the_font_is_there_and_has_what_the_labels_need() {
        let font = FONT.as_ref().unwrap();
        for c in "ABCxyzuvn0123456789áàâãçéêíóôõúüÁÀÂÃÇÉÊÍÓÔÕÚαβθφλμ·×°−±√≤≥≠→←↑↓′″½²³".chars()
        {
            assert!(font.charmap.map(c).is_some(), "{c} is missing");
        }
    }

    #[test]
    fn subscripts_are_found() {
        let marked =
            |t: &str| characters(t).iter().map(|&(c, s)| if s { format!("[{c}]") } else { c.into() }).collect();
        let cases: [(&str, &str); 7] = [
            ("x_c", "x[c]"),
            ("M_{prp}·p", "M[p][r][p]·p"),
            ("a_", "a_"),
            ("_{", "[{]"),
            ("", ""),
            ("_é_ç", "[é][ç]"),
            ("p_{}q", "pq"),
        ];
        for (text, expected) in cases {
            let found: String = marked(text);
            assert_eq!(found, expected, "{text}");
        }
    }

    #[test]
    fn widths_add_up_and_scale() {
        let w = |t| measure(t, 20.0).width;
        assert!((w("ab") - w("a") - w("b")).abs() < 1e-3);
        assert!((measure("abc", 40.0).width - 2.0 * w("abc")).abs() < 1e-3);
        assert!((w("x_c") - w("x") - 0.7 * w("c")).abs() < 1e-3);
        // DejaVu Sans: the letter x is 1212 of 2048 units wide and 1120 high.
        assert!((w("x") - 20.0 * 1212.0 / 2048.0).abs() < 1e-3);
        assert!((x_height(20.0) - 20.0 * 1120.0 / 2048.0).abs() < 1e-3);
    }

    #[test]
    fn an_outline_stands_on_its_baseline_and_spans_the_x_height() {
        let b = outline("x", 2048.0).unwrap().bounds();
        assert!(b.bottom().abs() < 1.0 && (b.top() + 1120.0).abs() < 1.0, "{b:?}");
    }

    #[test]
    fn a_missing_character_shows_as_a_box() {
        let b = outline("\u{10FFFD}", 20.0).unwrap().bounds();
        assert!(b.width() > 4.0 && b.height() > 8.0);
    }

    #[test]
    fn nothing_to_draw_is_none() {
        assert!(outline("", 12.0).is_none());
        assert!(outline("  ", 12.0).is_none());
        assert!(outline("\n\t", 12.0).is_none());
        for size in [0.0, -3.0, f32::NAN, f32::INFINITY] {
            assert!(outline("a", size).is_none());
        }
    }
}
