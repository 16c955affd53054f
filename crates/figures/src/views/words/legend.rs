//! The legend of a picture's colours, in its lower left corner.

use glam::DVec2;

use crate::appearance::{MarkShape, Rgba};
use crate::drawing::{Anchor, Area, Drawing, Label, Mark, single};

use super::label_layout::{Author, half_size_of};
use super::label_obstacles::Box2;
use crate::figure::labels::{LEGEND, set_text, symbols};
use crate::views::pixels::PixelRect;
use crate::views::world::gizmos::SMALL_TYPE;
use crate::views::{Palette, Size};

/// Height of a line, in heights of its letters.
const LINE: f64 = 1.45;
/// Free space around the lines, in heights of letters.
const PAD: f64 = 0.6;
/// A colour's sample and the space up to its text, in heights of letters.
const SWATCH: DVec2 = DVec2::new(1.5, 0.8);
const INDENT: f64 = 2.1;
/// Length of a scale, in heights of letters.
const SCALE: f64 = 16.0;
/// Least distance between numbers below a scale, in heights of the letters.
const APART: f64 = 0.1;
/// Smallest scale of a legend. Below it, the legend is left out, because it would be illegible.
const SMALLEST: f64 = 0.5;

/// A text of a legend, with the name with which an author changes it.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::views) struct LegendText {
    name: String,
    text: String,
    /// The author's colour.
    color: Option<Rgba>,
    /// The author's factor of its size.
    size: f64,
    mathematical: bool,
}

impl LegendText {
    /// `name` is the part of its name after `legend:`.
    pub(in crate::views) fn new(name: &str, text: impl Into<String>) -> Self {
        let name = format!("{LEGEND}:{name}");
        Self { name, text: text.into(), color: None, size: 1.0, mathematical: false }
    }

    /// The texts below the ends and the middle of a scale.
    pub(in crate::views) fn below_a_scale(name: &str, texts: [String; 3]) -> [Self; 3] {
        let [near, middle, far] = texts;
        let text = |end, text: String| Self::new(&format!("{name}-{end}"), text);
        [text("near", near), text("middle", middle), text("far", far)]
    }

    /// The text with the author's changes; `None` if it's hidden.
    fn changed(self, author: &Author<'_>) -> Option<Self> {
        let change = author.labels.change(&self.name, author.view);
        // Symbols stand alone below a scale, but elsewhere a single letter may be a word.
        let text = match change.text.and_then(|text| set_text(text).ok()) {
            Some(text) => text,
            None if author.is_mathematical() && self.text.contains(" = ") => symbols(&self.text),
            None => self.text,
        };
        let (color, size) = (change.color, change.size.unwrap_or(1.0));
        (!change.hidden).then_some(Self { text, color, size, mathematical: author.is_mathematical(), ..self })
    }

    /// Width in heights of the legend's letters.
    fn width(&self) -> f64 {
        2.0 * self.size * half_size_of(&self.text, 1.0, self.mathematical).x
    }
}

/// A line of a legend.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::views) enum LegendRow {
    /// A heading, in its own colour.
    Title(LegendText, Rgba),
    /// A colour and its meaning.
    Swatch(Rgba, LegendText),
    /// A colour and the fault that it marks.
    Warning(Rgba, LegendText),
    /// A mark and its meaning.
    Mark(MarkShape, Rgba, LegendText),
    /// A run of colours from left to right, with texts below its left end, its middle and its right end.
    Scale(Vec<Rgba>, Vec<[LegendText; 3]>),
}

impl LegendRow {
    /// The row with the author's changes; `None` if it's hidden. A scale stays, without its hidden texts.
    fn changed(self, author: &Author<'_>) -> Option<Self> {
        Some(match self {
            Self::Title(text, color) => Self::Title(text.changed(author)?, color),
            Self::Swatch(color, text) => Self::Swatch(color, text.changed(author)?),
            Self::Warning(color, text) => Self::Warning(color, text.changed(author)?),
            Self::Mark(shape, color, text) => Self::Mark(shape, color, text.changed(author)?),
            Self::Scale(colors, texts) => {
                let shown = |text: LegendText| {
                    let empty = LegendText { text: String::new(), ..text.clone() };
                    text.changed(author).unwrap_or(empty)
                };
                let lines = texts.into_iter().map(|line| line.map(shown));
                Self::Scale(colors, lines.filter(|line| line.iter().any(|text| !text.text.is_empty())).collect())
            }
        })
    }

    /// The factor of its size.
    fn size(&self) -> f64 {
        match self {
            Self::Title(text, _) | Self::Swatch(_, text) | Self::Warning(_, text) | Self::Mark(_, _, text) => text.size,
            Self::Scale(_, texts) => texts.iter().flatten().map(|text| text.size).fold(1.0, f64::max),
        }
    }

    /// Height in lines of the legend's letters.
    fn lines(&self) -> f64 {
        let lines = match self {
            Self::Scale(_, texts) => 1.0 + f64::from(u32::try_from(texts.len()).unwrap_or(u32::MAX)),
            Self::Title(..) | Self::Swatch(..) | Self::Warning(..) | Self::Mark(..) => 1.0,
        };
        self.size() * lines
    }

    /// Width in heights of the legend's letters.
    fn width(&self) -> f64 {
        match self {
            Self::Title(title, _) => title.width(),
            Self::Swatch(_, meaning) | Self::Warning(_, meaning) | Self::Mark(_, _, meaning) => {
                INDENT * meaning.size + meaning.width()
            }
            Self::Scale(..) => SCALE * self.size(),
        }
    }
}

/// Lines one below the other.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::views) struct Legend {
    rows: Vec<LegendRow>,
    /// The corner of the part of the picture that contains it, and the size of that part.
    part: [DVec2; 2],
    /// Height of the letters in pixels.
    em: f64,
    palette: Palette,
    /// The author's colour of its letters.
    color: Option<Rgba>,
    /// The way from its corner to the author's place for it, in pixels.
    moved: DVec2,
}

impl Legend {
    /// `part` is the part of the picture that contains it, and `scale` the number of pixels for one unit of stroke
    /// width or type size. `None` if there are no rows, or no space, or the author hides it.
    pub(in crate::views) fn new(
        rows: Vec<LegendRow>,
        part: PixelRect,
        scale: f32,
        (palette, author): (Palette, Option<&Author<'_>>),
        picture: Size,
    ) -> Option<Self> {
        let part = [(part.x, part.y), (part.width, part.height)].map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
        let change = author.map(|author| author.labels.change(LEGEND, author.view)).unwrap_or_default();
        let rows = match author {
            Some(author) => rows.into_iter().filter_map(|row| row.changed(author)).collect(),
            None => rows,
        };
        if change.hidden || rows.is_empty() {
            return None;
        }
        let least = author.map_or(0.0, |author| author.least);
        let wanted = f64::from((SMALL_TYPE * scale).max(least)) * change.size.unwrap_or(1.0);
        let legend = Self { rows, part, em: wanted, palette, color: change.color, moved: DVec2::ZERO };
        let room = DVec2::new(0.96, 0.5) * part[1] / legend.size();
        let fit = room.min_element().min(1.0);
        if fit * change.size.unwrap_or(1.0).max(1.0) < SMALLEST {
            return None;
        }
        let mut legend = Self { em: wanted * fit, ..legend };
        if let Some(by) = change.by {
            // Anywhere in the picture.
            let Box2 { center, half } = legend.place();
            let size = DVec2::new(f64::from(picture.width), f64::from(picture.height));
            let (least, most) = (half, (size - half).max(half));
            legend.moved = (center + DVec2::new(by.x, -by.y) * legend.em).clamp(least, most) - center;
        }
        Some(legend)
    }

    /// In pixels.
    fn size(&self) -> DVec2 {
        let width = self.rows.iter().map(LegendRow::width).fold(0.0, f64::max);
        let height: f64 = self.rows.iter().map(|row| LINE * row.lines()).sum();
        (DVec2::new(width, height) + 2.0 * PAD) * self.em
    }

    /// Its place.
    pub(in crate::views) fn place(&self) -> Box2 {
        let half = self.size() / 2.0;
        let edge = 0.5 * self.em;
        let [corner, size] = self.part;
        Box2 { center: corner + DVec2::new(edge + half.x, size.y - edge - half.y) + self.moved, half }
    }

    /// Draws it over everything else.
    pub(in crate::views) fn draw(&self, drawing: &mut Drawing) {
        let Box2 { center, half } = self.place();
        let corner = center - half;
        self.plate(drawing, corner, 2.0 * half);
        let mut at = corner + DVec2::splat(PAD * self.em);
        for row in &self.rows {
            let em = self.em * row.size();
            self.row(drawing, row, at + DVec2::Y * (0.5 * LINE * em), em);
            at.y += LINE * self.em * row.lines();
        }
    }

    /// A background with round corners.
    fn plate(&self, drawing: &mut Drawing, corner: DVec2, size: DVec2) {
        let fill = self.palette.paper.with_alpha(225);
        drawing.areas.push(area(corner, size, 0.4 * self.em, fill));
    }

    /// `em` is the height of the row's letters in pixels.
    fn row(&self, drawing: &mut Drawing, row: &LegendRow, at: DVec2, em: f64) {
        // From its default place, so that an author can move it on.
        let (from, moved) = (self.moved, [single(self.moved.x), single(self.moved.y)]);
        let mut text = |at: DVec2, text: &LegendText, color: Rgba, anchor: Anchor| {
            if text.text.is_empty() {
                return;
            }
            drawing.labels.push(Label {
                name: text.name.clone(),
                mathematical: text.mathematical,
                offset: moved,
                anchor,
                ..Label::new(
                    [single(at.x - from.x), single(at.y - from.y), 1.0],
                    text.text.clone(),
                    single(self.em * text.size),
                    [text.color.or(self.color).unwrap_or(color), self.palette.paper],
                )
            });
        };
        let ink = self.palette.ink;
        match row {
            LegendRow::Title(title, color) => text(at, title, *color, Anchor::Left),
            LegendRow::Swatch(color, meaning) | LegendRow::Warning(color, meaning) => {
                let letters = if matches!(row, LegendRow::Warning(..)) { *color } else { ink };
                text(at + DVec2::X * (INDENT * em), meaning, letters, Anchor::Left);
                let (corner, size) = (at - DVec2::Y * (SWATCH.y / 2.0 * em), SWATCH * em);
                let layers = [self.palette.paper, *color, *color];
                // The front and the back of a body lie over each other if it's translucent.
                let layers = if color.is_opaque() { &layers[..2] } else { &layers[..] };
                drawing.areas.extend(sample(corner, size, ink, layers));
            }
            LegendRow::Mark(shape, color, meaning) => {
                text(at + DVec2::X * (INDENT * em), meaning, ink, Anchor::Left);
                let middle = at + DVec2::X * (SWATCH.x / 2.0 * em);
                let (position, colors) = ([single(middle.x), single(middle.y), 1.0], [*color, self.palette.paper]);
                drawing.marks.push(Mark::new(position, *shape, single(0.3 * em), colors));
            }
            LegendRow::Scale(colors, texts) => {
                for (i, line) in (1..).zip(texts) {
                    let below = at + DVec2::Y * (LINE * em * f64::from(i));
                    // Long numbers at the ends leave no space for the one in the middle.
                    let room = 0.5 * SCALE - 0.5 * line[1].width() - APART;
                    let has_room = line[0].width().max(line[2].width()) < room;
                    for (share, part, anchor) in
                        [(0.0, &line[0], Anchor::Left), (0.5, &line[1], Anchor::Center), (1.0, &line[2], Anchor::Right)]
                    {
                        if has_room || anchor != Anchor::Center {
                            text(below + DVec2::X * (share * SCALE * em), part, ink, anchor);
                        }
                    }
                }
                self.scale(drawing, colors, at, em);
            }
        }
    }

    /// Steps of colour side by side, between round ends of the first and the last one.
    fn scale(&self, drawing: &mut Drawing, colors: &[Rgba], at: DVec2, em: f64) {
        let high = 0.45 * em;
        let (corner, size) = (at - DVec2::Y * high, DVec2::new(SCALE * em, 2.0 * high));
        let [first, .., last] = colors else { return };
        drawing.areas.extend(sample(corner, size, self.palette.ink, &[*last]));
        drawing.areas.push(area(corner, DVec2::splat(2.0 * high), high, *first));
        let length = size.x - 2.0 * high;
        let step = length / f64::from(u32::try_from(colors.len()).unwrap_or(u32::MAX));
        // Each reaches to the end and is covered by the next one, so that there's no seam between two.
        for (i, color) in (0_u32..).zip(colors) {
            let before = step * f64::from(i);
            let rest = DVec2::new(length - before, size.y);
            drawing.areas.push(area(corner + DVec2::X * (high + before), rest, 0.0, *color));
        }
    }
}

/// A sample of colours laid over each other, with round ends and a border one pixel wide.
fn sample(corner: DVec2, size: DVec2, border: Rgba, colors: &[Rgba]) -> Vec<Area> {
    let around = area(corner - 1.0, size + 2.0, size.y / 2.0 + 1.0, border);
    let inside = colors.iter().map(|&color| area(corner, size, size.y / 2.0, color));
    std::iter::once(around).chain(inside).collect()
}

fn area(corner: DVec2, size: DVec2, radius: f64, fill: Rgba) -> Area {
    Area {
        corner: [single(corner.x), single(corner.y)],
        size: [single(size.x), single(size.y)],
        radius: single(radius),
        fill,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_legend_lies_inside_its_picture_or_is_left_out() {
        let square = |side| PixelRect { x: 0, y: 0, width: side, height: side };
        let rows = || vec![LegendRow::Swatch(Rgba::rgb(1, 2, 3), LegendText::new("outside", "outside the volume")); 3];
        let palette = Palette::of(crate::appearance::Theme::Light);
        let whole = Size { width: 400, height: 400, scale: 1.0 };
        let mut smaller = 0;
        for side in (0..400).step_by(8) {
            let Some(legend) = Legend::new(rows(), square(side), 1.0, (palette, None), whole) else {
                assert!(side < 150, "{side}");
                continue;
            };
            smaller += i32::from(legend.em < f64::from(SMALL_TYPE));
            let Box2 { center, half } = legend.place();
            assert!((center - half).min_element() >= 0.0 && (center + half).max_element() <= f64::from(side));
        }
        assert!(smaller > 2);
        assert_eq!(Legend::new(Vec::new(), square(400), 1.0, (palette, None), whole), None);
    }
}
