//! The layout that a figure asks for, and the user's own, which comes back afterwards.

use super::{Side, State};
use crate::figure::{Arrangement, Explanation, Screen, View};

/// The parts of the window's layout that a figure can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gui) struct Placed {
    /// The pictures that are shown.
    pub(in crate::gui) pictures: [bool; View::COUNT],
    /// `None`: automatic.
    pub(in crate::gui) arrangement: Option<Arrangement>,
    /// The side of explanations is open.
    pub(in crate::gui) is_open: bool,
    /// Its explanation.
    pub(in crate::gui) explanation: Explanation,
}

impl Placed {
    /// The layout `now`, with the user's own wherever it is still the one that a figure asked for.
    fn given_back(self, own: &Self, asked: &Self) -> Self {
        fn back<T: PartialEq>(now: T, own: T, asked: &T) -> T {
            if now == *asked { own } else { now }
        }
        Self {
            pictures: back(self.pictures, own.pictures, &asked.pictures),
            arrangement: back(self.arrangement, own.arrangement, &asked.arrangement),
            is_open: back(self.is_open, own.is_open, &asked.is_open),
            explanation: back(self.explanation, own.explanation, &asked.explanation),
        }
    }
}

/// A layout that a figure asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gui) struct AskedLayout {
    /// The user's own, before.
    own: Placed,
    asked: Placed,
    /// In a presentation, whose panels are not those of the window.
    presentation: bool,
}

impl State {
    fn placed(&self) -> Placed {
        Placed {
            pictures: self.layout.shown,
            arrangement: self.layout.arrangement,
            is_open: self.settings.panels().wanted[Side::Explain as usize],
            explanation: self.explain.shown(),
        }
    }

    /// The layout that the user has chosen: what the figure asked for is not remembered.
    pub(in crate::gui) fn preferred_layout(&self) -> Placed {
        let now = Placed { is_open: self.settings.panels.wanted[Side::Explain as usize], ..self.placed() };
        let Some(AskedLayout { own, asked, presentation }) = self.asked_layout else { return now };
        let is_open = now.is_open;
        let given_back = now.given_back(&own, &asked);
        if presentation { Placed { is_open, ..given_back } } else { given_back }
    }

    /// Gives back the layout that was there before a figure asked for its own. What the user has changed since stays.
    pub(in crate::gui) fn give_back_layout(&mut self) {
        let Some(AskedLayout { own, asked, presentation }) = self.asked_layout.take() else { return };
        let Placed { pictures, arrangement, is_open, explanation } = self.placed().given_back(&own, &asked);
        (self.layout.shown, self.layout.arrangement) = (pictures, arrangement);
        if presentation == self.settings.presentation {
            self.settings.panels_mut().wanted[Side::Explain as usize] = is_open;
        }
        if explanation != self.explain.shown() {
            self.explain.show(explanation);
        }
    }

    /// Puts the window into the layout that a figure asks for, else into that of the user.
    pub(in crate::gui) fn show_screen(&mut self, screen: Screen) {
        self.give_back_layout();
        let own = self.placed();
        let Screen { pictures, arrangement, panel } = screen;
        if let Some(pictures) = pictures {
            (self.layout.shown, self.layout.maximized) = (pictures, None);
        }
        if let Some(arrangement) = arrangement {
            self.layout.arrangement = arrangement;
        }
        // A page that shows the pictures alone has no room for a side.
        match panel.filter(|_| !self.settings.bare) {
            Some(Some(explanation)) => self.show_explanation(explanation),
            Some(None) => self.settings.panels_mut().wanted[Side::Explain as usize] = false,
            None => {}
        }
        let presentation = self.settings.presentation;
        self.asked_layout =
            (screen != Screen::default()).then(|| AskedLayout { own, asked: self.placed(), presentation });
        self.keep_what_it_explains();
    }
}
