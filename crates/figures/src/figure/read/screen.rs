//! The `title`, the `caption` and the `[screen]` of a figure file.

use super::section::{Fault, Section};
use crate::figure::error::Allowed;
use crate::figure::words::{self, ARRANGEMENTS, PANELS, PICTURES, SCREEN_MATRICES};
use crate::figure::{Bilingual, Screen, ScreenEntry, View};
use crate::limits::{MAX_CAPTION, MAX_TITLE};
use crate::sanitize;

/// Reads `title` and `caption`.
pub(super) fn told(root: &mut Section<'_>) -> [Option<Bilingual>; 2] {
    [("title", MAX_TITLE), ("caption", MAX_CAPTION)].map(|(key, limit)| {
        let texts = root.told(key)?;
        let is_short = |text: &String| text.chars().count() <= limit && !text.contains(sanitize::is_obeyed);
        if !texts.iter().all(is_short) {
            root.refuse(key, Allowed::BilingualLine { limit });
            return None;
        }
        Some(texts.into())
    })
}

/// Reads the section. A faulty key changes nothing in the window.
pub(super) fn screen(mut section: Section<'_>, faults: &mut Vec<Fault>) -> Screen {
    let views = section.words("pictures", PICTURES);
    let pictures = View::ALL.map(|view| views.contains(&view));
    let shows_none = section.faults.is_empty() && pictures == [false; View::COUNT];
    if shows_none && section.is_present("pictures") {
        section.refuse("pictures", Allowed::Words(words::names(PICTURES)));
    }
    let entry = entry(section.section("entry", "[screen] entry."), faults);
    let screen = Screen {
        entry,
        pictures: Some(pictures).filter(|pictures| *pictures != [false; View::COUNT]),
        arrangement: section.choice("arrangement", ARRANGEMENTS),
        panel: section.choice("panel", PANELS),
    };
    faults.extend(section.finish());
    screen
}

fn entry(section: Section<'_>, faults: &mut Vec<Fault>) -> Option<ScreenEntry> {
    let mut section = section.there()?;
    let matrix = section.choice("matrix", SCREEN_MATRICES);
    section.require("matrix", Allowed::word_of(SCREEN_MATRICES));
    let inverse = section.switch("inverse");
    let [row, column] = ["row", "column"].map(|key| section.integer(key, 1, 4, 1));
    section.good(matrix.map(|matrix| ScreenEntry { matrix, inverse, place: [row, column] }), faults)
}
