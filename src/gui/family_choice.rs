//! The family that is exported: a key or an operation, with its values.

use crate::figure::variation::{Variation, VariationError};

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

/// The key or operation that varies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Subject {
    /// Nothing: the figure alone.
    #[default]
    Nothing,
    /// One of [`READY`].
    Ready(usize),
    /// A typed one: `KEY=VALUE,VALUE,…`.
    Typed,
}

/// The settings of a family.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FamilyChoice {
    /// The key or operation.
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

    pub(super) fn choose(&mut self, subject: Subject) {
        self.subject = subject;
        match subject {
            Subject::Nothing => {}
            Subject::Ready(place) => self.values = READY.get(place).map_or("", |(_, values)| values).to_owned(),
            Subject::Typed => self.values = "camera.near=1, 2".to_owned(),
        }
    }
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
        for (place, (key, _)) in READY.iter().enumerate() {
            let mut family = FamilyChoice::default();
            family.choose(Subject::Ready(place));
            let variation = family.variation().unwrap().unwrap();
            let made = variants(&figure, &camera, &[variation], Convention::default(), MAX_FAMILY).unwrap();
            assert!(made.len() > 1, "{key}");
        }
        assert_eq!(FamilyChoice::default().variation(), None);
        assert_eq!(FamilyChoice::default().or_first().subject, Subject::Ready(0));
    }
}
