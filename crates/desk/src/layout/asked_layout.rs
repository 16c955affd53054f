//! The layout that a figure asks for, and the user's own, which comes back afterwards.

use crate::explain::Matrix;
use crate::explained::matrices::Matrices;
use crate::figure::{Arrangement, Explanation, Screen, ScreenEntry, ScreenMatrix, View};
use crate::layout::Side;
use crate::model::Model;

/// The parts of the window's layout that a figure can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed {
    /// `None` means automatic.
    pub arrangement: Option<Arrangement>,
    /// The side of explanations is open.
    pub is_open: bool,
    /// Its explanation.
    pub explanation: Explanation,
}

impl Placed {
    /// The layout `now`, with the user's own values in place of those that a figure asked for and that haven't changed
    /// since.
    fn given_back(self, own: &Self, asked: &Self) -> Self {
        fn back<T: PartialEq>(now: T, own: T, asked: &T) -> T {
            if now == *asked { own } else { now }
        }
        Self {
            arrangement: back(self.arrangement, own.arrangement, &asked.arrangement),
            is_open: back(self.is_open, own.is_open, &asked.is_open),
            explanation: back(self.explanation, own.explanation, &asked.explanation),
        }
    }
}

/// A layout that a figure asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AskedLayout {
    /// The user's own, before.
    own: Placed,
    asked: Placed,
    /// True in a presentation, whose panels aren't those of the window.
    presentation: bool,
}

impl Model {
    fn placed(&self) -> Placed {
        Placed {
            arrangement: self.layout.arrangement,
            is_open: self.settings.panels().wanted[Side::Explain as usize],
            explanation: self.explained.shown(),
        }
    }

    /// The layout that the user has chosen. Layouts that figures ask for aren't remembered.
    pub fn preferred_layout(&self) -> Placed {
        let now = Placed { is_open: self.settings.panels.wanted[Side::Explain as usize], ..self.placed() };
        let Some(AskedLayout { own, asked, presentation }) = self.asked_layout else { return now };
        let is_open = now.is_open;
        let given_back = now.given_back(&own, &asked);
        if presentation { Placed { is_open, ..given_back } } else { given_back }
    }

    /// Gives back the layout from before a figure asked for its own. The user's changes since then stay.
    pub fn give_back_layout(&mut self) {
        let Some(AskedLayout { own, asked, presentation }) = self.asked_layout.take() else { return };
        let Placed { arrangement, is_open, explanation } = self.placed().given_back(&own, &asked);
        self.layout.arrangement = arrangement;
        if presentation == self.settings.presentation {
            self.settings.panels_mut().wanted[Side::Explain as usize] = is_open;
        }
        if explanation != self.explained.shown() {
            self.explained.show(explanation);
        }
    }

    /// Gives the window the layout that a figure asks for, or otherwise the user's.
    pub fn show_screen(&mut self, screen: Screen) {
        self.give_back_layout();
        let own = self.placed();
        let Screen { pictures, arrangement, panel, entry } = screen;
        // Views are hidden in a figure, not in the window, so the next figure begins with all of them.
        self.layout.shown = pictures.unwrap_or([true; View::COUNT]);
        if pictures.is_some() {
            self.layout.maximized = None;
        }
        if let Some(arrangement) = arrangement {
            self.layout.arrangement = arrangement;
        }
        if self.settings.presentation {
            self.layout.turn_presentation(true);
        }
        // A page that shows the pictures alone has no room for a side.
        match panel.filter(|_| !self.settings.bare) {
            Some(Some(explanation)) => self.show_explanation(explanation),
            Some(None) => self.settings.panels_mut().wanted[Side::Explain as usize] = false,
            None => {}
        }
        if let Some(ScreenEntry { matrix, inverse, place }) = entry {
            self.explained.matrices.show_entry(
                matrix_of(matrix),
                inverse,
                place.map(|k| usize::from(k.clamp(1, 4)) - 1),
            );
        }
        let presentation = self.settings.presentation;
        self.asked_layout =
            (screen != Screen::default()).then(|| AskedLayout { own, asked: self.placed(), presentation });
        self.keep_what_it_explains();
    }
}

/// The matrices that a figure can name, as in the explanation of matrices.
const MATRICES: [(ScreenMatrix, Matrix); 5] = [
    (ScreenMatrix::Model, Matrix::Model),
    (ScreenMatrix::View, Matrix::View),
    (ScreenMatrix::Projection, Matrix::Projection),
    (ScreenMatrix::ViewProjection, Matrix::ViewProjection),
    (ScreenMatrix::Viewport, Matrix::Viewport),
];

fn matrix_of(named: ScreenMatrix) -> Matrix {
    MATRICES.into_iter().find(|(name, _)| *name == named).map_or(Matrix::Projection, |(_, matrix)| matrix)
}

/// The entry that the explanation of matrices shows.
pub fn shown_entry(matrices: &Matrices) -> Option<ScreenEntry> {
    let (matrix, _) = MATRICES.into_iter().find(|(_, matrix)| *matrix == matrices.matrix)?;
    // At most 4.
    let place = matrices.entry.map(|k| u8::try_from(k + 1).unwrap_or(4));
    Some(ScreenEntry { matrix, inverse: matrices.inverse, place })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::tests::model;

    #[test]
    fn the_layout_of_a_figure_is_no_preference_and_ends_with_it() {
        let mut model = model();
        model.layout.arrangement = Some(Arrangement::Row);
        let own = model.preferred_layout();
        let asked = Screen {
            pictures: Some([false, true, true]),
            arrangement: Some(Some(Arrangement::Column)),
            panel: Some(Some(Explanation::Depth)),
            entry: None,
        };
        model.show_screen(asked);
        assert_eq!((model.layout.shown, model.layout.arrangement), ([false, true, true], Some(Arrangement::Column)));
        assert!(model.shows_explanation(Explanation::Depth));
        assert_eq!(model.preferred_layout(), own);
        // The next figure asks for less: all views, and the rest from the user.
        model.show_screen(Screen { panel: Some(None), ..Screen::default() });
        assert_eq!(model.preferred_layout(), own);
        assert_eq!(model.layout.shown, [true; View::COUNT]);
        // A change by the user becomes part of the user's layout.
        model.show_screen(asked);
        model.layout.arrangement = Some(Arrangement::Above);
        assert_eq!(model.preferred_layout(), Placed { arrangement: Some(Arrangement::Above), ..own });
        model.show_screen(Screen::default());
        assert_eq!(model.placed(), Placed { arrangement: Some(Arrangement::Above), ..own });
    }
}
