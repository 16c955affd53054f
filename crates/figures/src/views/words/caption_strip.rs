//! The captions under a row of pictures.

use super::label_layout::half_size_of;
use super::values;
use crate::appearance::{Rgba, Theme};
use crate::drawing::{Anchor, Drawing, Label, single};
use crate::figure::variation::VariedValue;
use crate::views::Palette;
use crate::views::compared::on_clear_ground;
use crate::{sanitize, text};

/// The distance from one line to the next, and of the first from the picture, in letters.
const LINE: f32 = 1.35;
const ABOVE: f32 = 0.25;
/// The most lines of a caption. A longer caption ends in dots.
const MOST_LINES: usize = 4;
/// The longest caption in characters.
const LONGEST: usize = 300;

/// Texts under pictures.
#[derive(Clone, Debug, PartialEq)]
pub struct Captions {
    /// The text of each picture, in their order. It may be empty.
    pub texts: Vec<String>,
    /// The height of the letters in pixels.
    pub letters: f32,
    /// The theme of the pictures.
    pub theme: Theme,
}

impl Captions {
    /// The captions of a family: its values, or texts that replace them, with letters before them, (a), (b) …, if
    /// `parts` are requested.
    pub fn of(
        values: &[&[VariedValue]],
        own: &[String],
        parts: bool,
        labels: &crate::views::Labels,
        (letters, theme): (f32, Theme),
    ) -> Self {
        let text = |(place, at): (usize, &&[VariedValue])| {
            let text = own.get(place).map_or_else(|| values::caption(at, labels), |own| sanitize::within(own, LONGEST));
            let part = if parts { format!("({}) ", part(place)) } else { String::new() };
            format!("{part}{text}").trim_end().to_owned()
        };
        Self { texts: values.iter().enumerate().map(text).collect(), letters, theme }
    }

    /// The strip under a row of pictures. `cells` are the index of each in [`texts`](Self::texts), its left side and
    /// its width.
    pub fn strip(&self, cells: &[(usize, f32, f32)], size: [u32; 2]) -> Drawing {
        let palette = Palette::of(self.theme);
        let mut drawing = on_clear_ground(size, palette.paper);
        for (place, left, width) in cells {
            let text = self.texts.get(*place).map_or("", String::as_str);
            for (row, line) in (0_u8..).zip(lines(text, self.letters, *width)) {
                drawing.labels.push(Label {
                    anchor: Anchor::Center,
                    ..Label::new(
                        [left + width / 2.0, self.letters * (ABOVE + (f32::from(row) + 0.5) * LINE), 1.0],
                        line,
                        self.letters,
                        [palette.ink, Rgba { a: 0, ..palette.paper }],
                    )
                });
            }
        }
        drawing
    }
}

/// The height of the strip under pictures of a width, in pixels, with space for the longest of these captions.
pub fn caption_height(captions: &Captions, width: f32) -> u32 {
    let count = captions.texts.iter().map(|text| lines(text, captions.letters, width).len()).max().unwrap_or(0);
    if count == 0 {
        return 0;
    }
    #[expect(clippy::cast_possible_truncation, reason = "at most four lines of letters")]
    let height = (captions.letters * (2.0 * ABOVE + LINE * count as f32)).ceil() as u32;
    height
}

/// The letter of a part: a … z, aa, ab …
fn part(place: usize) -> String {
    let letter = char::from(b'a' + u8::try_from(place % 26).unwrap_or(0));
    if place < 26 { letter.to_string() } else { format!("{}{letter}", part(place / 26 - 1)) }
}

/// A text in lines that fit into a width.
fn lines(caption: &str, letters: f32, width: f32) -> Vec<String> {
    let fits = |line: &str| 2.0 * single(half_size_of(line, letters, false).x) <= width;
    let words = caption.split_whitespace().map(|word| format!("{word} "));
    let mut lines = text::broken(words, fits);
    if lines.len() > MOST_LINES {
        lines.truncate(MOST_LINES);
        lines.iter_mut().last().into_iter().for_each(|last| last.push_str(" …"));
    }
    // A word wider than its picture would run into the next one.
    for line in &mut lines {
        while !fits(line) && line.chars().count() > 2 {
            let kept: String = line.chars().take(line.chars().count() - 2).collect();
            *line = format!("{kept}…");
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn captions_break_between_words_and_stay_within_their_picture() {
        let text = "painter's algorithm, projection parallel, view angle 40 degrees";
        for width in [40.0, 90.0, 200.0, 2000.0] {
            let broken = lines(text, 14.0, width);
            assert!(broken.len() <= MOST_LINES, "{broken:?}");
            let widest = broken.iter().map(|line| 2.0 * half_size_of(line, 14.0, false).x).fold(0.0, f64::max);
            assert!(widest <= f64::from(width), "{width}: {broken:?}");
        }
        assert_eq!(lines(text, 14.0, 2000.0), [text]);
        assert_eq!(lines("", 14.0, 100.0), Vec::<String>::new());
    }

    #[test]
    fn parts_go_on_after_z() {
        assert_eq!([0, 25, 26, 27, 63].map(part), ["a", "z", "aa", "ab", "bl"]);
    }
}
