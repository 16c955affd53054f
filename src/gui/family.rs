//! A family in the export dialog: the same figure at several values of a key or an operation, on one sheet.

use eframe::egui;

use super::panels::{choice, row};
use super::text_field::TextField;
use super::tooltip::Explained;
use crate::figure::variation::{Variation, VariationError};
use crate::i18n::families;
use crate::i18n::window::Texts;
use crate::limits::MAX_TYPED_NAME;

/// The families that have a name: a key or an operation, and the values that it begins with.
pub const READY: [(&str, &str); 9] = [
    ("camera.view_angle", "20, 40, 60, 90"),
    ("azimuth", "0, 90, 180, 270"),
    ("elevation", "0, 30, 60"),
    ("zoom", "1, 2, 4"),
    ("dolly", "1, 2, 4"),
    ("camera.projection", "perspective, parallel"),
    ("style.visibility", "painter, depth-buffer"),
    ("style.shading", "wireframe, flat, gouraud, phong"),
    ("style.antialias", "1, 4, 16"),
];

/// What varies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Subject {
    /// Nothing: the figure alone.
    #[default]
    Nothing,
    /// One of [`READY`].
    Ready(usize),
    /// What is typed: `KEY=VALUE,VALUE,…`.
    Typed,
}

/// The settings of a family.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FamilyChoice {
    /// What varies.
    pub subject: Subject,
    /// Its values as they are typed; with the key before them, where that is typed too.
    pub values: String,
    /// The number of pictures in a row; `None`: as many as there is room for.
    pub columns: Option<usize>,
    /// Letters before the captions.
    pub parts: bool,
}

impl FamilyChoice {
    /// A family of the view angle, or the one that was there.
    #[must_use]
    pub fn or_first(mut self) -> Self {
        if self.subject == Subject::Nothing {
            self.choose(Subject::Ready(0));
        }
        self
    }

    /// The variation; `None`: no family is wanted.
    #[must_use]
    pub fn variation(&self) -> Option<Result<Variation, VariationError>> {
        match self.subject {
            Subject::Nothing => None,
            Subject::Ready(place) => READY.get(place).map(|(key, _)| Variation::new(key, &self.values, None)),
            Subject::Typed => Some(Variation::parse(&self.values, None)),
        }
    }

    fn choose(&mut self, subject: Subject) {
        self.subject = subject;
        match subject {
            Subject::Nothing => {}
            Subject::Ready(place) => self.values = READY.get(place).map_or("", |(_, values)| values).to_owned(),
            Subject::Typed => self.values = "camera.near=1, 2".to_owned(),
        }
    }
}

/// The rows of the dialog; they are always there, so that nothing moves under the pointer.
pub(super) fn rows(ui: &mut egui::Ui, t: &'static Texts, family: &mut FamilyChoice) {
    let words = families::texts(t.lang);
    let names = [
        words.view_angle,
        t.azimuth,
        t.elevation,
        t.zoom,
        t.dolly,
        words.projection,
        words.visibility,
        words.shading,
        words.samples,
    ];
    let ready = (0..).zip(names).map(|(place, name)| (Subject::Ready(place), name));
    let choices: Vec<(Subject, &str)> =
        [(Subject::Nothing, words.none)].into_iter().chain(ready).chain([(Subject::Typed, words.typed)]).collect();
    let mut subject = family.subject;
    row(ui, "", words.family, words.family_hint, |ui| {
        choice(ui, words.family, words.family_hint, &mut subject, &choices);
    });
    if subject != family.subject {
        family.choose(subject);
    }
    ui.add_enabled_ui(subject != Subject::Nothing, |ui| {
        row(ui, "", words.values, words.values_hint, |ui| {
            let field = TextField::line(&mut family.values, MAX_TYPED_NAME).with(|edit| edit.desired_width(200.0));
            field.show(ui, t.lang).explained(words.values_hint).accessible_name(words.values);
        });
        row(ui, "", words.columns, words.columns_hint, |ui| {
            let columns: Vec<(Option<usize>, String)> = [None]
                .into_iter()
                .chain((1..=8).map(Some))
                .map(|n| (n, n.map_or_else(|| words.automatic.to_owned(), |n: usize| n.to_string())))
                .collect();
            let columns: Vec<(Option<usize>, &str)> = columns.iter().map(|(n, text)| (*n, &**text)).collect();
            choice(ui, words.columns, words.columns_hint, &mut family.columns, &columns);
            ui.checkbox(&mut family.parts, words.parts).explained(words.parts_hint);
        });
    });
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::{Camera, Convention};
    use crate::figure::Figure;
    use crate::figure::variation::variants;
    use crate::limits::MAX_FAMILY;

    #[test]
    fn every_ready_family_is_one_of_the_default_figure() {
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        for place in 0..READY.len() {
            let mut family = FamilyChoice::default();
            family.choose(Subject::Ready(place));
            let variation = family.variation().unwrap().unwrap();
            let made = variants(&figure, &camera, &[variation], Convention::default(), MAX_FAMILY).unwrap();
            assert!(made.len() > 1, "{}", READY[place].0);
        }
        assert_eq!(FamilyChoice::default().variation(), None);
        assert_eq!(FamilyChoice::default().or_first().subject, Subject::Ready(0));
    }
}
