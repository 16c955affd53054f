//! A sequence of figures, as in a lecture: those of the folder of the open one in natural order, or the built-in ones.
//! The latter also follow a figure whose folder can't be read, as in a page.
//!
//! There are no questions on the way. A figure with changes is kept, and has them when the user comes back to it.
//! Closing the window asks about it.

use std::path::Path;

use crate::gui::app::state::State;
use crate::gui::gallery::figures_in;
use camera_lab_desk::{Document, Message, Model, Source};
use camera_lab_files::{SHIPPED_FIGURES, open_figure};

/// The inputs of the search for the next figure.
#[derive(Clone, Debug)]
pub(super) struct FigureSearch {
    /// The open figure.
    here: Option<Source>,
    /// Figures that were left with changes.
    kept: Vec<Option<Source>>,
    forwards: bool,
}

/// The next figure that can be opened.
#[derive(Debug)]
pub(super) struct Found {
    search: FigureSearch,
    /// The figure, or the kept one. `None` at the end of the sequence.
    next: Option<NextFigure>,
    /// The reasons why the ones before it couldn't be opened.
    faults: Vec<Message>,
}

#[derive(Debug)]
struct NextFigure {
    source: Option<Source>,
    /// `None` if it was left with changes.
    document: Option<Box<Document>>,
    /// Its number, from 1, and that of the last figure.
    number: usize,
    of: usize,
}

impl FigureSearch {
    /// Looks for the figure after the open one, or for the one before.
    pub(super) fn of(model: &Model, forwards: bool) -> Self {
        let kept = model.desk.left().collect();
        Self { here: Source::of(&model.desk.shown), kept, forwards }
    }

    /// The folder of the figure.
    pub(super) fn folder(&self) -> Option<&Path> {
        match self.here.as_ref()? {
            Source::File(path) => path.parent(),
            Source::Shipped(_) => None,
        }
    }

    /// The sequence of the open figure, and its place in it. A new figure comes before the built-in ones.
    fn places(&self) -> (Vec<Option<Source>>, usize) {
        let of_program = || SHIPPED_FIGURES.iter().map(|figure| Some(Source::Shipped(figure.name))).collect();
        let files = self.folder().and_then(|folder| figures_in(folder).ok());
        let is_of_program = files.is_none();
        let mut places: Vec<Option<Source>> =
            files.map_or_else(of_program, |files| files.into_iter().map(|path| Some(Source::File(path))).collect());
        if is_of_program && (self.here.is_none() || self.kept.contains(&None)) {
            places.insert(0, None);
        }
        let at = places.iter().position(|place| *place == self.here).unwrap_or_else(|| {
            places.insert(0, self.here.clone());
            0
        });
        (places, at)
    }

    /// Opens the next figure. Skips files that can't be opened.
    pub(super) fn find(self) -> Found {
        let (places, mut at) = self.places();
        let mut faults = Vec::new();
        loop {
            let next = if self.forwards { at + 1 } else { at.wrapping_sub(1) };
            let Some(source) = places.get(next) else { return Found { search: self, next: None, faults } };
            let opened = if self.kept.contains(source) { Ok(None) } else { document_at(source.as_ref()).map(Some) };
            match opened {
                Ok(document) => {
                    let (source, document) = (source.clone(), document.map(Box::new));
                    let next = Some(NextFigure { source, document, number: next + 1, of: places.len() });
                    return Found { search: self, next, faults };
                }
                Err(error) => faults.push(*error),
            }
            at = next;
        }
    }
}

/// Opens the figure at a place, as in its file.
fn document_at(place: Option<&Source>) -> Result<Document, Box<Message>> {
    let opened = match place {
        None => None,
        Some(Source::Shipped(name)) => Document::shipped(name),
        Some(Source::File(path)) => {
            let opened = open_figure(path).map_err(|error| Message::File(path.clone(), error))?;
            let (figure, file) = opened.at(path);
            Some(Document::new(figure, Some(file)).map_err(|error| Message::NotOpened(path.clone(), error))?)
        }
    };
    match opened {
        Some(document) => Ok(document),
        None => Ok(Document::new(camera_lab_desk::document::fresh(), None).map_err(Message::Camera)?),
    }
}

/// Shows the figure found. Work in the one before is kept.
pub(super) fn show(state: &mut State, found: Found) {
    let Found { search: FigureSearch { here, forwards, .. }, next, faults } = found;
    let State { model, learn, annotations, recent, file_flow, .. } = state;
    let shown = next.and_then(|next| {
        let document =
            next.document.map(|document| *document).or_else(|| model.desk.take_left(next.source.as_ref()))?;
        let leaves_work = model.is_unsaved();
        Some((next.source, document, Message::Step { number: next.number, of: next.of, leaves_work }))
    });
    let Some((source, document, step)) = shown else {
        let end = if forwards { Message::LastFigure } else { Message::FirstFigure };
        return model.say(passed_over(faults).unwrap_or(end));
    };
    model.desk.commit();
    model.settle_layout();
    annotations.turn_page(here, source.as_ref());
    model.desk.keep_shown();
    learn.take_over(model, document);
    if let Some(Source::File(path)) = &source {
        recent.add(path);
    }
    // Another program may have changed the file since.
    file_flow.look = true;
    model.say(passed_over(faults).unwrap_or(step));
}

/// The message about files that can't be opened, with the reason for the first, and the number of others.
fn passed_over(faults: Vec<Message>) -> Option<Message> {
    let mut faults = faults.into_iter();
    let first = faults.next()?;
    Some(match faults.len() {
        0 => first,
        more => Message::AndMore(Box::new(first), more),
    })
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use eframe::egui;

    use super::*;
    use crate::gui::Start;
    use crate::gui::app::file_flow::step;
    use camera_lab_files::figure_from;

    #[test]
    fn after_a_figure_whose_folder_cannot_be_looked_into_come_those_of_the_program() {
        let mut state = State::new(Start::default()).unwrap();
        let (figure, file) =
            figure_from(b"[camera]\nnear = 0.5\n").unwrap().at(Path::new("/no/such/folder/saved.toml"));
        state.learn.take_over(&mut state.model, Document::new(figure, Some(file)).unwrap());
        step(&egui::Context::default(), &mut state, true);
        assert_eq!(state.model.desk.shown.shipped_name(), Some(SHIPPED_FIGURES[0].name));
        step(&egui::Context::default(), &mut state, true);
        assert_eq!(state.model.desk.shown.shipped_name(), Some(SHIPPED_FIGURES[1].name));
    }
}
