//! Numbers of which the digits that have just changed glow.

use std::fmt::Debug;
use std::hash::Hash;

use eframe::egui::{Color32, FontId, Id, TextFormat, Ui, text::LayoutJob};

/// How long they glow, in seconds.
const SECONDS: f64 = 1.0;

/// How often the glow is painted anew while it fades, in seconds.
const FRAME: f32 = 0.1;

/// A text as it was shown last, and which part of it has changed when.
#[derive(Clone, Debug, Default, PartialEq)]
struct Shown {
    text: String,
    changed: (usize, usize),
    since: f64,
}

impl Shown {
    /// The text now; what differs from the last one begins to glow.
    fn follow(self, text: &str, now: f64) -> Self {
        if self.text == text {
            return self;
        }
        Self { changed: difference(&self.text, text), text: text.to_owned(), since: now }
    }
}

/// The characters (from, to) of the new text that the old one has not, between what both begin with and what both end with; of texts that
/// are equally long, from the first to the last that differs.
fn difference(old: &str, new: &str) -> (usize, usize) {
    let (a, b): (Vec<char>, Vec<char>) = (old.chars().collect(), new.chars().collect());
    let start = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
    let most = a.len().min(b.len()) - start;
    let end = a.iter().rev().zip(b.iter().rev()).take_while(|(a, b)| a == b).count().min(most);
    (start, b.len() - end)
}

/// How strongly what has changed glows: from 1 to 0.
fn strength(now: f64, since: f64) -> f64 {
    (1.0 - (now - since) / SECONDS).clamp(0.0, 1.0)
}

/// Adds a text to a job. What has changed since the last frame in which the text with this key was shown glows for a second; then nothing
/// is painted anew any more.
pub(super) fn push(ui: &Ui, job: &mut LayoutJob, key: impl Hash + Debug, text: &str, font: &FontId, color: Color32) {
    let id = Id::unique("digits").with(key);
    let now = ui.input(|input| input.time);
    let before = ui.data(|data| data.get_temp::<Shown>(id));
    // What is seen for the first time has not changed.
    let first = || Shown { text: text.to_owned(), changed: (0, 0), since: f64::NEG_INFINITY };
    let shown = before.map_or_else(first, |shown| shown.follow(text, now));
    let strength = strength(now, shown.since);
    let (from, to) = shown.changed;
    ui.data_mut(|data| data.insert_temp(id, shown));
    let glows = strength > 0.0 && from < to;
    if glows {
        ui.ctx().request_repaint_after(std::time::Duration::from_secs_f32(FRAME));
    }
    let plain = TextFormat { font_id: font.clone(), color, ..TextFormat::default() };
    #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
    let background = ui.visuals().selection.bg_fill.gamma_multiply(strength as f32);
    let glowing = TextFormat { background, ..plain.clone() };
    let part = |from: usize, to: usize| text.chars().skip(from).take(to - from).collect::<String>();
    let parts = if glows {
        vec![(part(0, from), &plain), (part(from, to), &glowing), (part(to, text.chars().count()), &plain)]
    } else {
        vec![(text.to_owned(), &plain)]
    };
    for (part, format) in parts {
        job.append(&part, 0.0, format.clone());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_that_differ_are_found_between_what_stays() {
        for (old, new, expected) in [
            ("1.2345", "1.2375", (4, 5)),
            ("1.2345", "1.2345", (6, 6)),
            ("−1.5", "1.5", (0, 0)),
            ("1.5", "−1.5", (0, 1)),
            ("1.11", "1.111", (4, 5)),
            ("", "12", (0, 2)),
            ("2·1 + 3", "2·7 + 3", (2, 3)),
        ] {
            assert_eq!(difference(old, new), expected, "{old} → {new}");
        }
    }

    #[test]
    fn a_change_glows_for_a_second_and_what_stays_does_not() {
        let shown = Shown { text: "1.5".to_owned(), changed: (0, 0), since: f64::NEG_INFINITY };
        assert_eq!(strength(5.0, shown.since), 0.0);
        let same = shown.clone().follow("1.5", 5.0);
        assert_eq!(same, shown);
        let changed = shown.follow("1.7", 5.0);
        assert_eq!((changed.changed, strength(5.5, changed.since), strength(6.0, changed.since)), ((2, 3), 0.5, 0.0));
        assert_eq!(changed.clone().follow("1.7", 5.5).since, 5.0);
    }
}
