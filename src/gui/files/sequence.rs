//! A sequence of figures, as in a lecture: those of the folder of the open one in natural order, or the built-in ones;
//! also after a figure whose folder cannot be read, as in a page.
//!
//! There are no questions on the way. A figure with changes is kept, and is as it was left when one comes back to it.
//! Closing the window asks about it.

use crate::files::{SHIPPED_FIGURES, open_figure};
use crate::gui::app::annotations::Annotations;
use crate::gui::app::state::State;
use crate::gui::gallery::figures_in;
use crate::gui::learn::Learn;
use crate::gui::model::Model;
use crate::gui::model::document::Document;
use crate::gui::model::message::Message;
use crate::gui::model::source::Source;

/// The sequence of the open figure, and its place in it. A new figure comes before the built-in ones.
fn places(model: &Model) -> (Vec<Option<Source>>, usize) {
    let here = Source::of(&model.document);
    let of_program = || SHIPPED_FIGURES.iter().map(|figure| Some(Source::Shipped(figure.name))).collect();
    let files = match &here {
        Some(Source::File(path)) => path.parent().and_then(|folder| figures_in(folder).ok()),
        Some(Source::Shipped(_)) | None => None,
    };
    let is_of_program = files.is_none();
    let mut places: Vec<Option<Source>> =
        files.map_or_else(of_program, |files| files.into_iter().map(|path| Some(Source::File(path))).collect());
    if is_of_program && (here.is_none() || model.kept.iter().any(|(source, _)| source.is_none())) {
        places.insert(0, None);
    }
    let at = places.iter().position(|place| *place == here).unwrap_or_else(|| {
        places.insert(0, here.clone());
        0
    });
    (places, at)
}

/// Opens the figure at a place, as it was left or as it is in its file.
fn document_at(model: &mut Model, place: Option<&Source>) -> Result<Document, Box<Message>> {
    if let Some(kept) = model.take_kept(place) {
        return Ok(kept);
    }
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
        None => Ok(Document::new(crate::gui::fresh(), None).map_err(Message::Camera)?),
    }
}

fn keep_and_show(
    model: &mut Model,
    learn: &mut Learn,
    annotations: &mut Annotations,
    source: Option<Source>,
    document: Document,
) {
    model.settle_layout(learn.lesson.is_some());
    let mut left = model.document.clone();
    annotations.turn_page(source.clone(), Source::of(&document).as_ref());
    learn.take_over(model, document);
    // What was behind it is kept already.
    left.take_behind();
    if left.is_changed() {
        model.kept.push((source, left));
    }
}

/// Moves on to the next figure, or back to the one before. Files that cannot be opened are skipped, and reported.
/// Returns whether the window shows another figure now.
pub(in crate::gui) fn step(state: &mut State, forwards: bool) -> bool {
    state.model.document.commit();
    let (places, at) = places(&state.model);
    let next = |at: usize| if forwards { Some(at + 1).filter(|next| *next < places.len()) } else { at.checked_sub(1) };
    let mut faults = Vec::new();
    let mut candidate = next(at);
    while let Some(index) = candidate {
        match document_at(&mut state.model, places[index].as_ref()) {
            Ok(document) => {
                keep_and_show(&mut state.model, &mut state.learn, &mut state.annotations, places[at].clone(), document);
                if let Some(Source::File(path)) = &places[index] {
                    state.recent.add(path);
                }
                // Another program may have gone on with the file.
                state.file_flow.look = true;
                state.model.say(passed_over(faults).unwrap_or(Message::Step { number: index + 1, of: places.len() }));
                return true;
            }
            Err(error) => faults.push(*error),
        }
        candidate = next(index);
    }
    state.model.say(passed_over(faults).unwrap_or(if forwards { Message::LastFigure } else { Message::FirstFigure }));
    false
}

/// The message about files that cannot be opened: the reason for the first, and the number of others.
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

    use std::path::Path;

    use super::*;
    use crate::files::figure_from;
    use crate::gui::Start;

    #[test]
    fn after_a_figure_whose_folder_cannot_be_looked_into_come_those_of_the_program() {
        let mut state = State::new(Start::default()).unwrap();
        let (figure, file) =
            figure_from(b"[camera]\nnear = 0.5\n").unwrap().at(Path::new("/no/such/folder/saved.toml"));
        state.learn.take_over(&mut state.model, Document::new(figure, Some(file)).unwrap());
        assert!(step(&mut state, true));
        assert_eq!(state.model.document.shipped_name(), Some(SHIPPED_FIGURES[0].name));
        assert!(step(&mut state, true));
        assert_eq!(state.model.document.shipped_name(), Some(SHIPPED_FIGURES[1].name));
    }
}
