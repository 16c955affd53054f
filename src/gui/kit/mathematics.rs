//! Formulas set like those of `KaTeX`. `RaTeX` lays out glyphs and lines, and the window paints them with the fonts of
//! `KaTeX`.

use std::sync::Arc;

use eframe::egui::cache::{ComputerMut, FrameCache};
use eframe::egui::{
    self, Color32, FontData, FontDefinitions, FontFamily, FontId, Painter, Pos2, Rect, Response, Role, Sense,
    TextStyle, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use ratex_layout::{LayoutOptions, layout, to_display_list};
use ratex_types::display_item::{DisplayItem, DisplayList};

use crate::drawing::single;
use crate::text;
use camera_lab_words::why::notes::plain;

/// The fonts, by `RaTeX`'s names for them. Formulas that need another one are written as text.
const FONTS: [(&str, &[u8]); 7] = [
    ("Main-Regular", text::ROMAN_BYTES),
    ("Main-Bold", text::BOLD_BYTES),
    ("Math-Italic", text::ITALIC_BYTES),
    ("Size1-Regular", font!("KaTeX_Size1-Regular.ttf")),
    ("Size2-Regular", font!("KaTeX_Size2-Regular.ttf")),
    ("Size3-Regular", font!("KaTeX_Size3-Regular.ttf")),
    ("Size4-Regular", font!("KaTeX_Size4-Regular.ttf")),
];

/// Makes the fonts known, each as a family of its own.
pub(in crate::gui) fn add_fonts(fonts: &mut FontDefinitions) {
    for (name, bytes) in FONTS {
        fonts.font_data.insert(name.to_owned(), Arc::new(FontData::from_static(bytes)));
        fonts.families.insert(FontFamily::Name(name.into()), vec![name.to_owned()]);
    }
}

/// A glyph, in units of the type size, from the upper left corner of its formula.
#[derive(Debug)]
struct Glyph {
    character: char,
    font: &'static str,
    /// The left end of its baseline.
    place: [f32; 2],
    scale: f32,
}

/// The painted parts of a formula, in units of the type size.
#[derive(Debug, Default)]
struct FormulaInk {
    glyphs: Vec<Glyph>,
    /// Left end, middle of the height. Length and thickness.
    lines: Vec<[f32; 4]>,
    size: [f32; 2],
    baseline: f32,
}

impl FormulaInk {
    /// `None` for text that isn't LaTeX, or needs more than the fonts have.
    fn new(latex: &str) -> Option<Self> {
        // No font has glyphs for brackets as high as a matrix, so they are lines here.
        if let Some((before, rest)) = latex.split_once(r"\begin{bmatrix}") {
            let (entries, after) = rest.split_once(r"\end{bmatrix}")?;
            let matrix = Self::new(&format!(r"\begin{{matrix}}{entries}\end{{matrix}}"))?.in_brackets();
            return Some(Self::new(before)?.beside(matrix).beside(Self::new(after)?));
        }
        let list = to_display_list(&layout(&ratex_parser::parse(latex).ok()?, &LayoutOptions::default()));
        let DisplayList { items, width, height, depth } = list;
        let mut ink =
            Self { size: [single(width), single(height + depth)], baseline: single(height), ..Self::default() };
        for item in items {
            match item {
                DisplayItem::GlyphPath { x, y, scale, font, char_code, .. } => {
                    let (font, _) = FONTS.iter().find(|(name, _)| *name == font)?;
                    let character = char::from_u32(char_code)?;
                    ink.glyphs.push(Glyph { character, font, place: [single(x), single(y)], scale: single(scale) });
                }
                DisplayItem::Line { x, y, width, thickness, .. } => {
                    ink.lines.push([x, y, width, thickness].map(single));
                }
                DisplayItem::Rect { .. } | DisplayItem::Path { .. } => return None,
            }
        }
        Some(ink)
    }

    fn moved(mut self, [x, y]: [f32; 2]) -> Self {
        for place in self.glyphs.iter_mut().map(|glyph| &mut glyph.place) {
            *place = [place[0] + x, place[1] + y];
        }
        for line in &mut self.lines {
            (line[0], line[1]) = (line[0] + x, line[1] + y);
        }
        self
    }

    /// Both on one baseline.
    fn beside(self, other: Self) -> Self {
        const GAP: f32 = 0.28;
        let gap = if self.size[0] > 0.0 && other.size[0] > 0.0 { GAP } else { 0.0 };
        let baseline = self.baseline.max(other.baseline);
        let below = (self.size[1] - self.baseline).max(other.size[1] - other.baseline);
        let left = self.size[0] + gap;
        let size = [left + other.size[0], baseline + below];
        let (down, other_down) = (baseline - self.baseline, baseline - other.baseline);
        let (mut both, other) = (self.moved([0.0, down]), other.moved([left, other_down]));
        both.glyphs.extend(other.glyphs);
        both.lines.extend(other.lines);
        Self { size, baseline, ..both }
    }

    fn in_brackets(self) -> Self {
        // Thickness of the lines, length of those at the ends, room between brackets and entries.
        const LINE: f32 = 0.07;
        const END: f32 = 0.25;
        const ROOM: f32 = 0.4;
        let [width, height] = [self.size[0] + 2.0 * ROOM, self.size[1]];
        let (size, baseline) = ([width, height], self.baseline);
        let mut ink = self.moved([ROOM, 0.0]);
        for (side, end) in [(0.0, 0.0), (width - LINE, width - END)] {
            ink.lines.push([side, height / 2.0, LINE, height]);
            ink.lines.extend([LINE / 2.0, height - LINE / 2.0].map(|y| [end, y, END, LINE]));
        }
        Self { size, baseline, ..ink }
    }
}

#[derive(Default)]
struct Typesetter;

impl ComputerMut<&str, Option<Arc<FormulaInk>>> for Typesetter {
    fn compute(&mut self, latex: &str) -> Option<Arc<FormulaInk>> {
        FormulaInk::new(latex).map(Arc::new)
    }
}

/// A formula of a size, ready to paint.
#[derive(Clone, Debug)]
pub(in crate::gui) struct Formula {
    set: Set,
    size: f32,
}

#[derive(Clone, Debug)]
enum Set {
    Ink(Arc<FormulaInk>),
    Text(Arc<egui::Galley>),
}

impl Formula {
    /// Sets a formula, or shows `text` if that fails. It's set once, as long as every frame shows it.
    pub(in crate::gui) fn new(ui: &Ui, latex: &str, text: &str, size: f32) -> Self {
        type Cache = FrameCache<Option<Arc<FormulaInk>>, Typesetter>;
        let ink = ui.memory_mut(|memory| memory.caches.cache::<Cache>().get(latex).clone());
        let set = ink.map_or_else(
            || {
                let font = TextStyle::Body.resolve(ui.style());
                Set::Text(ui.painter().layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER))
            },
            Set::Ink,
        );
        Self { set, size }
    }

    /// The room that it needs, in points.
    pub(in crate::gui) fn size(&self) -> Vec2 {
        match &self.set {
            Set::Ink(ink) => Vec2::from(ink.size) * self.size,
            Set::Text(galley) => galley.size(),
        }
    }

    /// Distance of its baseline below its upper end, in points.
    pub(in crate::gui) fn baseline(&self) -> f32 {
        match &self.set {
            Set::Ink(ink) => ink.baseline * self.size,
            Set::Text(galley) => baseline_of(galley),
        }
    }

    /// Paints it with its upper left corner at `corner`.
    pub(in crate::gui) fn paint(&self, painter: &Painter, corner: Pos2, color: Color32) {
        let ink = match &self.set {
            Set::Text(galley) => {
                painter.galley(corner, Arc::clone(galley), color);
                return;
            }
            Set::Ink(ink) => ink,
        };
        // On whole pixels vertically, so that all formulas of a line look alike.
        let pixel = 1.0 / painter.pixels_per_point();
        let top = (corner.y / pixel).round() * pixel;
        for Glyph { character, font, place: [x, y], scale } in &ink.glyphs {
            let font = FontId::new(self.size * scale, FontFamily::Name((*font).into()));
            let galley = painter.layout_no_wrap(character.to_string(), font, color);
            let place = pos2(corner.x + x * self.size, top + y * self.size - baseline_of(&galley));
            painter.galley(place, galley, color);
        }
        for [x, y, length, thickness] in &ink.lines {
            let thickness = ((thickness * self.size / pixel).round() * pixel).max(pixel);
            let upper = ((top + y * self.size - thickness / 2.0) / pixel).round() * pixel;
            let line = Rect::from_min_size(pos2(corner.x + x * self.size, upper), vec2(length * self.size, thickness));
            painter.rect_filled(line, 0.0, color);
        }
    }
}

fn baseline_of(galley: &egui::Galley) -> f32 {
    let row = galley.rows.first();
    row.and_then(|row| row.glyphs.first().map(|glyph| row.pos.y + glyph.pos.y)).unwrap_or(galley.size().y)
}

/// Shows a formula. `text` is the same one in a line, for screen readers.
pub(in crate::gui) fn show(ui: &mut Ui, latex: &str, text: &str, size: f32) -> Response {
    let formula = Formula::new(ui, latex, text, size);
    let (place, response) = ui.allocate_exact_size(formula.size(), Sense::hover());
    formula.paint(ui.painter(), place.min, ui.visuals().text_color());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    response
}

/// The size of a formula in a line of words, as a share of theirs.
const IN_LINE: f32 = 1.08;

/// The width of a formula in a line of words.
pub(in crate::gui) fn inline_width(ui: &Ui, latex: &str, font: &FontId) -> f32 {
    Formula::new(ui, latex, &plain(latex), font.size * IN_LINE).size().x
}

/// A formula in a line of words, on their baseline.
pub(in crate::gui) fn inline(ui: &mut Ui, latex: &str, font: &FontId, color: Color32) {
    let text = plain(latex);
    let formula = Formula::new(ui, latex, &text, font.size * IN_LINE);
    let sample = ui.painter().layout_no_wrap("x".to_owned(), font.clone(), color);
    let (place, response) = ui.allocate_exact_size(vec2(formula.size().x, sample.size().y), Sense::hover());
    formula.paint(ui.painter(), place.min + vec2(0.0, baseline_of(&sample) - formula.baseline()), color);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
}

/// A formula as LaTeX and as text.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::gui) struct Both {
    pub(in crate::gui) latex: String,
    pub(in crate::gui) text: String,
}

/// The layout of the links of a [`chain`].
#[derive(Clone, Copy, PartialEq)]
pub(in crate::gui) enum Links {
    /// Each below the other, so that formula, numbers and value are always in the same place.
    Below,
    /// As many on a line as fit, because many chains follow one another.
    Dense,
}

/// name = formula = numbers = value, each once.
pub(in crate::gui) fn chain(ui: &mut Ui, name: &Both, said: &[Both], links: Links) {
    /// The type size, in points.
    const CHAIN: f32 = 14.0;
    let (mut last, mut line, mut is_first) = (name, name.clone(), true);
    let mut lines = Vec::new();
    for next in said {
        if !is_first && next.text == last.text {
            continue;
        }
        let longer =
            Both { latex: format!("{} = {}", line.latex, next.latex), text: format!("{} = {}", line.text, next.text) };
        let fits = || Formula::new(ui, &longer.latex, &longer.text, CHAIN).size().x <= ui.available_width();
        if is_first || (links == Links::Dense && fits()) {
            line = longer;
        } else {
            let begun = Both { latex: format!(r"\quad = {}", next.latex), text: format!("= {}", next.text) };
            lines.push(std::mem::replace(&mut line, begun));
        }
        (last, is_first) = (next, false);
    }
    lines.push(line);
    for (i, Both { latex, text }) in lines.iter().enumerate() {
        egui::ScrollArea::horizontal().id_salt(("chain", &name.text, i)).show(ui, |ui| {
            show(ui, latex, text, CHAIN);
        });
    }
}

/// Length of the ends of a bracket, in points.
const BRACKET: f32 = 4.0;

/// Square brackets at both sides of a place.
pub(in crate::gui) fn brackets(ui: &Ui, place: Rect) {
    let stroke = egui::Stroke::new(1.0, ui.visuals().weak_text_color());
    let (top, bottom) = (place.top() + 1.0, place.bottom() - 1.0);
    for (x, inwards) in [(place.left() + 1.0, BRACKET), (place.right() - 1.0, -BRACKET)] {
        let points = [(x + inwards, top), (x, top), (x, bottom), (x + inwards, bottom)];
        ui.painter().line(points.map(|(x, y)| pos2(x, y)).to_vec(), stroke);
    }
}

#[cfg(test)]
mod tests {
    use super::FormulaInk;
    use camera_lab_words::Lang;
    use camera_lab_words::why::notes::{Piece, notes};

    #[test]
    fn the_mathematics_of_all_notes_is_set_with_the_fonts_that_are_there() {
        let mut equations = 0;
        for note in [Lang::En, Lang::PtBr].into_iter().flat_map(notes) {
            let inline = note.paragraphs.iter().chain(&note.errata).flatten().filter_map(|piece| match piece {
                Piece::Mathematics(latex) => Some(*latex),
                Piece::Words(_) => None,
            });
            for latex in inline {
                let ink = FormulaInk::new(latex);
                assert!(ink.as_ref().is_some_and(|ink| !ink.glyphs.is_empty()), "{}: {latex}", note.id);
                // Such a formula is part of a line of words.
                assert!(ink.is_some_and(|ink| ink.size[1] < 1.1), "{}: {latex} is too high", note.id);
            }
            for latex in &note.equations {
                assert!(FormulaInk::new(latex).is_some_and(|ink| !ink.glyphs.is_empty()), "{}: {latex}", note.id);
                equations += 1;
            }
        }
        assert!(equations > 80, "{equations}");
        assert!(FormulaInk::new(r"\frac{1").is_none(), "what is not LaTeX is told apart");
    }
}
