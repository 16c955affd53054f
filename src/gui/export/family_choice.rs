//! The exported family: one or two keys or operations, with their values.

use crate::figure::variation::{Variation, VariationError};

/// The named families: a key or an operation, and its initial values.
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
/// Between captions, which may have commas.
pub const BETWEEN_CAPTIONS: char = ';';

/// The key or operation that varies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Subject {
    /// Nothing, so the figure alone, or no second key.
    #[default]
    Nothing,
    /// One of [`READY`].
    Ready(usize),
    /// A typed one: `KEY=VALUE,VALUE,…`.
    Typed,
}

/// The word of a typed key in the preferences.
const TYPED: &str = "typed";

impl Subject {
    /// Its word in the preferences: that of its key.
    pub fn word(self) -> &'static str {
        match self {
            Self::Nothing => "",
            Self::Ready(place) => READY.get(place).map_or("", |(key, _)| key),
            Self::Typed => TYPED,
        }
    }

    /// The subject with a word. `None` if there is none.
    pub fn of_word(word: &str) -> Option<Self> {
        match word {
            "" => Some(Self::Nothing),
            TYPED => Some(Self::Typed),
            word => READY.iter().position(|(key, _)| *key == word).map(Self::Ready),
        }
    }
}

/// A key or an operation, and its values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Varied {
    /// The key or operation.
    pub subject: Subject,
    /// Its values as typed, with the key before them if that is typed too.
    pub values: String,
}

impl Varied {
    /// The variation. `None` if there is none.
    pub fn variation(&self) -> Option<Result<Variation, VariationError>> {
        match self.subject {
            Subject::Nothing => None,
            Subject::Ready(place) => READY.get(place).map(|(key, _)| Variation::new(key, &self.values, None)),
            Subject::Typed => Some(Variation::parse(&self.values, None)),
        }
    }

    /// Takes a subject, with its initial values.
    pub fn choose(&mut self, subject: Subject) {
        self.subject = subject;
        match subject {
            Subject::Nothing => {}
            Subject::Ready(place) => self.values = READY.get(place).map_or("", |(_, values)| values).to_owned(),
            Subject::Typed => self.values = "camera.near=1, 2".to_owned(),
        }
    }
}

/// The settings of a family.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FamilyChoice {
    /// The key that varies. If it's `Nothing`, there is no family.
    pub first: Varied,
    /// The key that varies along each row, if there is one. The first then varies from row to row.
    pub second: Varied,
    /// The number of pictures in a row. `None` for as many as there is room for, or as the second has values.
    pub columns: Option<usize>,
    /// Letters before the captions.
    pub parts: bool,
    /// Captions in place of the values, as typed, with [`BETWEEN_CAPTIONS`] between them.
    pub captions: String,
    /// The keys of the last family, also of an earlier session.
    pub last: [Varied; 2],
}

impl Default for FamilyChoice {
    /// No family. A requested one has letters, since a text names its parts.
    fn default() -> Self {
        let nothing = Varied::default();
        let (first, second) = (nothing.clone(), nothing.clone());
        Self { first, second, columns: None, parts: true, captions: String::new(), last: [nothing.clone(), nothing] }
    }
}

impl FamilyChoice {
    /// The last family, or one of the view angle.
    pub fn or_last(mut self) -> Self {
        if self.first.subject == Subject::Nothing {
            [self.first, self.second] = self.last.clone();
        }
        if self.first.subject == Subject::Nothing {
            self.first.choose(Subject::Ready(0));
        }
        self
    }

    /// Takes a subject. [`Subject::Nothing`] ends the family, which is remembered: if its subject is chosen again, it's
    /// as it was.
    pub fn choose(&mut self, subject: Subject) {
        if subject == Subject::Nothing {
            self.last = self.remembered();
        } else if self.first.subject == Subject::Nothing && subject == self.last[0].subject {
            return [self.first, self.second] = self.last.clone();
        }
        self.first.choose(subject);
    }

    /// Leaves the family without exporting it. It comes back when a family is requested.
    pub fn leave(&mut self) {
        self.last = self.remembered();
        (self.first, self.second) = (Varied::default(), Varied::default());
    }

    /// The keys that vary, or varied last.
    pub fn remembered(&self) -> [Varied; 2] {
        match self.first.subject {
            Subject::Nothing => self.last.clone(),
            _ => [self.first.clone(), self.second.clone()],
        }
    }

    /// The variations. `None` if there is no family.
    ///
    /// # Errors
    /// [`VariationError`] of the first faulty one.
    pub fn variations(&self) -> Option<Result<Vec<Variation>, VariationError>> {
        let first = self.first.variation()?;
        Some([Some(first), self.second.variation()].into_iter().flatten().collect())
    }

    /// The captions. Empty if none are typed.
    pub fn captions(&self) -> Vec<String> {
        if self.captions.trim().is_empty() {
            return Vec::new();
        }
        self.captions.split(BETWEEN_CAPTIONS).map(|caption| caption.trim().to_owned()).collect()
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
            let variations = family.variations().unwrap().unwrap();
            let made = variants(&figure, &camera, &variations, Convention::default(), MAX_FAMILY).unwrap();
            assert!(made.len() > 1, "{key}");
            assert_eq!(Subject::of_word(Subject::Ready(place).word()), Some(Subject::Ready(place)));
        }
        assert_eq!(FamilyChoice::default().variations(), None);
        assert_eq!(FamilyChoice::default().or_last().first.subject, Subject::Ready(0));
    }

    #[test]
    fn a_family_that_is_given_up_comes_back() {
        let mut family = FamilyChoice::default().or_last();
        family.second.choose(Subject::Ready(5));
        family.first.values = "10, 20".to_owned();
        let was = family.clone();
        family.choose(Subject::Nothing);
        assert_eq!(family.variations(), None);
        let mut again = family.clone();
        again.choose(was.first.subject);
        let back = family.or_last();
        assert_eq!([back.first, back.second], [was.first.clone(), was.second.clone()]);
        assert_eq!([again.first, again.second], [was.first, was.second], "chosen from the list");
    }

    #[test]
    fn a_family_of_cameras_leaves_out_the_kept_operation() {
        let mut figure = Figure::default();
        figure.show.operations = vec!["azimuth=30".parse().unwrap()];
        let camera = Camera::new(&figure.camera).unwrap();
        for (key, values, keeps) in [
            ("azimuth", "0, 90", false),
            ("camera.view_angle", "20, 40", false),
            ("style.shading", "flat, phong", true),
        ] {
            let varied = Variation::new(key, values, None).unwrap();
            let all = variants(&figure, &camera, &[varied], Convention::default(), MAX_FAMILY).unwrap();
            assert!(all.iter().all(|variant| variant.figure.show.operations.is_empty() != keeps), "{key}");
        }
    }

    #[test]
    fn a_family_that_was_left_comes_back_when_it_is_requested() {
        let mut family = FamilyChoice::default().or_last();
        family.first.values = "1, 2, 3".to_owned();
        family.captions = "small; large".to_owned();
        let left = family.clone();
        family.leave();
        assert_eq!(family.variations(), None);
        let back = family.or_last();
        assert_eq!((back.first, back.captions), (left.first, left.captions));
    }

    #[test]
    fn captions_are_typed_with_semicolons() {
        let captions = |text: &str| FamilyChoice { captions: text.to_owned(), ..FamilyChoice::default() }.captions();
        assert_eq!(captions(" "), Vec::<String>::new());
        assert_eq!(captions("near, large; ;far"), ["near, large", "", "far"]);
    }
}
