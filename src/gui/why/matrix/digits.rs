//! Numbers in which recently changed digits glow.

use std::fmt::Debug;

use eframe::egui::text::LayoutJob;
use eframe::egui::{Color32, FontId, Id, TextFormat, Ui};

/// Duration of the glow, in seconds.
const SECONDS: f64 = 1.0;

/// Interval between repaints of the fading glow, in seconds.
const FRAME: f32 = 0.1;

/// A text as last shown, and the times when its characters changed.
#[derive(Clone, Debug, Default, PartialEq)]
struct ShownDigits {
    text: String,
    changed: Vec<bool>,
    since: f64,
}

impl ShownDigits {
    /// Sets the present text. Differences from the last one begin to glow.
    fn follow(self, text: &str, now: f64) -> Self {
        if self.text == text {
            return self;
        }
        Self { changed: difference(&self.text, text), text: text.to_owned(), since: now }
    }
}

/// For each character of the new text, true if it differs from the old one. Compares numbers digit by digit, aligned at
/// their decimal points. The text between them, and texts with another count of numbers, are compared between their
/// common beginning and their common end.
fn difference(old: &str, new: &str) -> Vec<bool> {
    let (before, after) = (parts(old), parts(new));
    if before.len() != after.len() {
        return between(&old.chars().collect::<Vec<_>>(), &new.chars().collect::<Vec<_>>());
    }
    let pairs = before.iter().zip(&after).enumerate();
    pairs.flat_map(|(i, (a, b))| if i % 2 == 0 { between(a, b) } else { digits(a, b) }).collect()
}

/// The text before the first number, the first number, the text before the second one … Numbers are at the odd places.
fn parts(text: &str) -> Vec<Vec<char>> {
    let text: Vec<char> = text.chars().collect();
    let mut parts = vec![Vec::new()];
    for (i, c) in text.iter().enumerate() {
        let digit = |at: Option<&char>| at.is_some_and(char::is_ascii_digit);
        let in_number = parts.len() % 2 == 0;
        let has_mark = || parts.last().is_some_and(|part| part.iter().any(|c| is_mark(*c)));
        let mark = in_number && is_mark(*c) && digit(text.get(i + 1)) && !has_mark();
        if (digit(Some(c)) || mark) != in_number {
            parts.push(Vec::new());
        }
        if let Some(part) = parts.last_mut() {
            part.push(*c);
        }
    }
    if parts.len() % 2 == 0 {
        parts.push(Vec::new());
    }
    parts
}

/// The decimal point, or comma.
const fn is_mark(c: char) -> bool {
    matches!(c, '.' | ',')
}

/// The digits of a number that the old one lacks at the same distance from the decimal point.
fn digits(old: &[char], new: &[char]) -> Vec<bool> {
    let whole = |number: &[char]| number.iter().position(|c| is_mark(*c)).unwrap_or(number.len());
    let (before, after) = (whole(old), whole(new));
    let same = |i: usize| (i + before).checked_sub(after).and_then(|k| old.get(k));
    new.iter().enumerate().map(|(i, c)| c.is_ascii_digit() && same(i) != Some(c)).collect()
}

/// The part of the new text that the old one lacks, between their common beginning and their common end.
fn between(old: &[char], new: &[char]) -> Vec<bool> {
    let start = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let most = old.len().min(new.len()) - start;
    let end = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count().min(most);
    (0..new.len()).map(|i| (start..new.len() - end).contains(&i)).collect()
}

/// Strength of the glow: from 1 to 0.
fn strength(now: f64, since: f64) -> f64 {
    (1.0 - (now - since) / SECONDS).clamp(0.0, 1.0)
}

/// Adds a text to a job. Changes since the last frame that showed the text with this key glow for a second. After that,
/// no more repaints are needed.
pub(in crate::gui::why) fn push(
    ui: &Ui,
    job: &mut LayoutJob,
    key: impl std::hash::Hash + Debug,
    text: &str,
    font: &FontId,
    color: Color32,
) {
    let id = Id::unique("digits").with(key);
    let now = ui.input(|input| input.time);
    let before = ui.data(|data| data.get_temp::<ShownDigits>(id));
    // A text shown for the first time hasn't changed.
    let first = || ShownDigits { text: text.to_owned(), changed: Vec::new(), since: f64::NEG_INFINITY };
    let shown = before.map_or_else(first, |shown| shown.follow(text, now));
    let strength = strength(now, shown.since);
    let glows = |i: usize| strength > 0.0 && shown.changed.get(i).is_some_and(|changed| *changed);
    let plain = TextFormat { font_id: font.clone(), color, ..TextFormat::default() };
    #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
    let background = ui.visuals().selection.bg_fill.gamma_multiply(strength as f32);
    let glowing = TextFormat { background, ..plain.clone() };
    let characters: Vec<(usize, char)> = text.chars().enumerate().collect();
    for part in characters.chunk_by(|a, b| glows(a.0) == glows(b.0)) {
        let glows = part.first().is_some_and(|(i, _)| glows(*i));
        if glows {
            ui.ctx().request_repaint_after(std::time::Duration::from_secs_f32(FRAME));
        }
        let part: String = part.iter().map(|(_, c)| c).collect();
        job.append(&part, 0.0, if glows { glowing.clone() } else { plain.clone() });
    }
    ui.data_mut(|data| data.insert_temp(id, shown));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `marked`: a caret below each character that has changed.
    #[test]
    fn digits_that_differ_are_marked_below_the_decimal_point() {
        for (old, new, marked) in [
            ("1.2345", "1.2375", "    ^ "),
            ("1.2345", "1.2345", "      "),
            ("1.2345", "1.9346", "  ^  ^"),
            ("−1.5", "1.5", "   "),
            ("1.5", "−1.5", "^   "),
            ("1.11", "1.111", "    ^"),
            ("9.5", "10.5", "^^  "),
            ("19.25", "9.25", "    "),
            ("3", "3.25", "  ^^"),
            ("1,5", "12,5", "^^  "),
            ("", "12", "^^"),
            ("2·1 + 3", "2·7 + 3", "  ^    "),
            ("2·1.5 + 3·4", "2·1.7 − 3·5", "    ^ ^   ^"),
            ("(1,5; 2)", "(1,6; 2)", "   ^    "),
            ("1·2", "1·2·3", "   ^^"),
        ] {
            let found: String = difference(old, new).iter().map(|changed| if *changed { '^' } else { ' ' }).collect();
            assert_eq!(found, marked, "{old} → {new}");
        }
    }

    #[test]
    fn a_change_glows_for_a_second_and_equal_entries_do_not() {
        let shown = ShownDigits { text: "1.5".to_owned(), changed: Vec::new(), since: f64::NEG_INFINITY };
        assert_eq!(strength(5.0, shown.since), 0.0);
        let same = shown.clone().follow("1.5", 5.0);
        assert_eq!(same, shown);
        let changed = shown.follow("1.7", 5.0);
        assert_eq!(changed.changed, [false, false, true]);
        assert_eq!((strength(5.5, changed.since), strength(6.0, changed.since)), (0.5, 0.0));
        assert_eq!(changed.clone().follow("1.7", 5.5).since, 5.0);
    }
}
