//! The three pictures, by name.

crate::listed! {
    /// One of the three pictures.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum View {
        /// The world, with the camera in it.
        World = "world",
        /// The canonical volume.
        Canonical = "canonical",
        /// The projected image.
        Image = "image",
    }
    /// The word for it on the command line, in file names and in data for programs.
    pub fn name
}

impl View {
    /// How many there are.
    pub const COUNT: usize = Self::ALL.len();

    /// Its place in [`View::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
}

/// The pictures drawn at once: one, two of the three, or all side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Views {
    /// One of the three.
    One(View),
    /// All but this one.
    Without(View),
    /// All three.
    All,
}

impl Views {
    /// Every choice.
    pub const CHOICES: [Self; 7] = [
        Self::One(View::World),
        Self::One(View::Canonical),
        Self::One(View::Image),
        Self::All,
        Self::Without(View::Image),
        Self::Without(View::Canonical),
        Self::Without(View::World),
    ];

    /// The word for it on the command line, in file names and in data for programs.
    pub const fn name(self) -> &'static str {
        match self {
            Self::One(view) => view.name(),
            Self::Without(View::Image) => "world,canonical",
            Self::Without(View::Canonical) => "world,image",
            Self::Without(View::World) => "canonical,image",
            Self::All => "all",
        }
    }

    /// True if a picture is among them.
    pub fn contains(self, view: View) -> bool {
        match self {
            Self::One(one) => one == view,
            Self::Without(other) => other != view,
            Self::All => true,
        }
    }

    /// The pictures, from left to right.
    pub fn views(self) -> impl Iterator<Item = View> {
        View::ALL.into_iter().filter(move |view| self.contains(*view))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_picture_has_its_place_and_every_choice_its_own_word() {
        for (i, view) in View::ALL.into_iter().enumerate() {
            assert_eq!(view.index(), i);
            assert_eq!(Views::CHOICES[i], Views::One(view));
        }
        let words: std::collections::BTreeSet<_> = Views::CHOICES.into_iter().map(Views::name).collect();
        assert_eq!(words.len(), 7);
        for views in Views::CHOICES.into_iter().filter(|views| *views != Views::All) {
            assert_eq!(views.views().map(View::name).collect::<Vec<_>>().join(","), views.name());
        }
        assert_eq!(Views::All.views().collect::<Vec<_>>(), View::ALL);
    }
}
