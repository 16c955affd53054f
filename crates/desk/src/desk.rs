//! The owner of all documents of the window: the one that is shown, and those that wait in a place of their own.
//!
//! ```text
//! shown ── a figure of an exercise comes ──▶ behind it ── undo ──▶ shown, and the other one in front of it
//! shown ── another step, another figure ──▶ its step, or left ── back to it ──▶ shown
//! left  ── the window closes: each is shown and asked about ──▶ given up, until the window is closed or goes on
//! ```

use super::document::Document;
use super::document::source::Source;
use super::history::Revision;
use crate::action::Intent;
use crate::camera::CameraError;
use crate::figure::Figure;

/// The documents.
#[derive(Clone, Debug)]
pub struct Desk {
    /// The document in the views.
    pub shown: Document,
    /// The hidden documents. Of two in places of one kind, the later one came last.
    held: Vec<HeldDocument>,
    /// The changes that count as work in a step of a lesson, while one is played.
    steps: Option<StepWork>,
    /// The intent that waits for an answer, or for a file.
    errand: Option<Errand>,
}

/// An intent that waits.
#[derive(Clone, Debug)]
struct Errand {
    intent: Intent,
    /// True if it waits for text of a lesson, false if it waits for the figure.
    for_text: bool,
}

/// The work that an intent would lose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Losses {
    /// Changes of the shown figure, or of its layout.
    pub figure: bool,
    /// Text of a lesson that can't be saved.
    pub text: bool,
}

/// The desk's answer to an intent, and to a reply.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Need {
    /// Ask if the changes of the figure are to be saved.
    AskAboutFigure,
    /// Ask if the text of the lesson is to be forgotten, or saved elsewhere.
    AskAboutText,
    /// Save the figure, then state the intent again.
    SaveFigure,
    /// Save the lesson with its text in another file, then state the intent again.
    SaveText,
    /// Do this now.
    Do(Intent),
    /// Wait for the user.
    Nothing,
}

/// The user's answer to a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reply {
    /// Save the work.
    Save,
    /// Give up the work of the figure.
    GiveUp,
    /// Stay.
    Cancel,
}

/// A hidden document.
#[derive(Clone, Debug)]
struct HeldDocument {
    document: Document,
    place: Place,
}

/// The place of a hidden document.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Place {
    /// Behind the document with this number. Undoing past its first step leads here.
    Behind(Revision),
    /// In front of the document with this number. Undoing led away, and redoing leads back.
    InFront(Revision),
    /// In a step of the lesson, from 0, until the step is shown again.
    Step(usize),
    /// Left with changes, until its figure is opened again.
    Left,
    /// The user has decided not to save it while closing the window.
    GivenUp,
}

/// The changes in a step of a lesson that count as work. A step is there to be tried. Another camera, image or way of
/// drawing isn't marked, isn't stored, and ends with the step. The user's own objects, lights, points, labels and
/// titles are work, treated as in every other figure. They are marked (•), survive a crash, wait in their step while
/// other steps are shown, and every action that would end them asks first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum StepWork {
    /// Objects, lights, points, labels and titles.
    Built,
    /// Every change, since the lesson is being written and the change may become a step.
    All,
}

impl Desk {
    /// Shows a document, and holds no other.
    pub fn new(shown: Document) -> Self {
        Self { shown, held: Vec::new(), steps: None, errand: None }
    }

    /// States what the user wants next. An intent that would lose work waits for the answer to a question about it.
    /// Every intent that replaces or closes a document comes through here.
    pub fn wish(&mut self, intent: Intent, losses: Losses) -> Need {
        let need = match losses {
            Losses { text: true, .. } => Need::AskAboutText,
            Losses { figure: true, .. } if intent.replaces_figure() => Need::AskAboutFigure,
            _ => {
                self.errand = None;
                return Need::Do(intent);
            }
        };
        self.errand = Some(Errand { intent, for_text: losses.text });
        need
    }

    /// Takes the answer to the question about the intent that waits. If the work is to be saved, the intent waits for
    /// that.
    pub fn reply(&mut self, reply: Reply) -> Need {
        match (reply, self.errand.take()) {
            (Reply::Save, Some(errand)) => {
                let need = if errand.for_text { Need::SaveText } else { Need::SaveFigure };
                self.errand = Some(errand);
                need
            }
            (Reply::GiveUp, Some(errand)) => Need::Do(errand.intent),
            (Reply::Cancel, _) | (_, None) => Need::Nothing,
        }
    }

    /// The intent that waits.
    pub fn errand(&self) -> Option<&Intent> {
        self.errand.as_ref().map(|errand| &errand.intent)
    }

    /// True if a document has changes that mustn't be lost.
    fn is_work(&self, document: &Document) -> bool {
        if self.steps == Some(StepWork::Built) { document.is_built_on() } else { document.is_changed() }
    }

    /// True if the shown document has changes that mustn't be lost.
    pub fn shows_work(&self) -> bool {
        self.is_work(&self.shown)
    }

    /// Makes an undo step of the changes since the last one. Call it when no pointer or key is held, so that a drag is
    /// one step.
    pub fn commit(&mut self) {
        if self.shown.commit() {
            self.drop_in_front();
        }
    }

    /// True if there is a step to undo (`back`), or to redo.
    pub fn can_undo(&self, back: bool) -> bool {
        self.shown.can_undo(back) || self.neighbour(back).is_some()
    }

    /// Goes one step `back`, or forward.
    pub fn undo(&mut self, back: bool) {
        self.commit();
        if self.shown.can_undo(back) {
            return self.shown.undo(back);
        }
        let Some(index) = self.neighbour(back) else { return };
        let HeldDocument { document, .. } = self.held.remove(index);
        let id = document.id();
        let place = if back { Place::InFront(id) } else { Place::Behind(id) };
        self.held.push(HeldDocument { document: std::mem::replace(&mut self.shown, document), place });
    }

    /// The document behind the shown one (`back`), or in front of it.
    fn neighbour(&self, back: bool) -> Option<usize> {
        let id = self.shown.id();
        let place = if back { Place::Behind(id) } else { Place::InFront(id) };
        self.held.iter().position(|held| held.place == place)
    }

    /// Takes another figure over in the shown document, as one undo step.
    ///
    /// # Errors
    /// [`CameraError`] if the figure's camera is impossible. Nothing has changed then.
    pub fn replace(&mut self, figure: Figure) -> Result<(), CameraError> {
        self.commit();
        self.shown.replace(figure)?;
        self.drop_in_front();
        Ok(())
    }

    /// Shows another figure in front of the document, as one undo step. It's a document without a file, so saving asks
    /// for one. The document waits behind it with its file and its changes.
    ///
    /// # Errors
    /// [`CameraError`] if the figure's camera is impossible. Nothing has changed then.
    pub fn show_in_front(&mut self, figure: Figure) -> Result<(), CameraError> {
        let shown = self.shown.beside(figure)?;
        self.commit();
        // A new step drops the steps to redo, as always.
        self.shown.forget_future();
        self.drop_in_front();
        let (place, before) = (Place::Behind(shown.id()), self.neighbour(true));
        let left = std::mem::replace(&mut self.shown, shown);
        match before {
            // A displayed figure without changes doesn't need a way back, so there is no chain of them.
            Some(before) if !left.is_changed() => self.held[before].place = place,
            _ => self.held.push(HeldDocument { document: left, place }),
        }
        Ok(())
    }

    /// A new step drops the documents in front, like the steps to redo.
    fn drop_in_front(&mut self) {
        while let Some(index) = self.neighbour(false) {
            let id = self.held.remove(index).document.id();
            // One that lies in front of it would never be reached.
            self.held.iter_mut().filter(|held| held.place == Place::InFront(id)).for_each(|held| {
                held.place = Place::InFront(self.shown.id());
            });
        }
    }

    /// Shows another document. The shown one is lost, unless the caller has put it away, so ask first. Work behind it
    /// is kept.
    pub fn take_over(&mut self, document: Document) {
        self.keep_behind();
        self.drop_in_front();
        self.shown = document;
    }

    /// Keeps the shown document, if it has changes, because another one is about to take its place.
    pub fn keep_shown(&mut self) {
        self.keep_behind();
        self.hold(self.shown.clone(), Place::Left);
    }

    fn hold(&mut self, document: Document, place: Place) {
        if document.is_changed() {
            self.held.push(HeldDocument { document, place });
        }
    }

    /// Keeps the work behind the shown document, and forgets the rest there.
    pub fn keep_behind(&mut self) {
        for document in self.take_behind(self.shown.id()) {
            if self.is_work(&document) {
                self.hold(document, Place::Left);
            }
        }
    }

    /// Takes the documents behind another one, the nearest first.
    fn take_behind(&mut self, mut id: Revision) -> Vec<Document> {
        let mut taken = Vec::new();
        while let Some(index) = self.held.iter().position(|held| held.place == Place::Behind(id)) {
            let document = self.held.remove(index).document;
            id = document.id();
            taken.push(document);
        }
        taken
    }

    /// Puts the work in the shown document, or the nearest behind it, into the step that is left. What lies behind that
    /// stays there.
    pub fn leave_step(&mut self, step: usize) {
        let mut left = Some(self.shown.clone());
        while let Some(document) = left.take_if(|document| !self.is_work(document)) {
            let behind = self.held.iter().position(|held| held.place == Place::Behind(document.id()));
            left = behind.map(|index| self.held.remove(index).document);
        }
        if let Some(document) = left {
            self.held.retain(|held| held.place != Place::Step(step));
            self.held.push(HeldDocument { document, place: Place::Step(step) });
        }
    }

    /// The document that waits in a step, to show it again.
    pub fn take_from_step(&mut self, step: usize) -> Option<Document> {
        self.take(|held| held.place == Place::Step(step))
    }

    /// Gives the documents that wait in steps other steps. Those without one are left, and so is what lies behind them.
    pub fn move_steps(&mut self, to: impl Fn(usize) -> Option<usize>) {
        let (mut moved, mut left) = (Vec::new(), Vec::new());
        for held in std::mem::take(&mut self.held) {
            match held.place {
                Place::Step(step) => match to(step) {
                    Some(step) => moved.push(HeldDocument { place: Place::Step(step), ..held }),
                    None => left.push(held.document),
                },
                _ => moved.push(held),
            }
        }
        self.held = moved;
        for document in left {
            let behind = self.take_behind(document.id());
            std::iter::once(document).chain(behind).for_each(|document| self.hold(document, Place::Left));
        }
    }

    /// Ends the lesson. The work of its steps is kept.
    pub fn leave_lesson(&mut self) {
        self.move_steps(|_| None);
        self.steps = None;
    }

    /// Begins a lesson, or goes on with it.
    pub fn play_lesson(&mut self) {
        self.steps.get_or_insert(StepWork::Built);
    }

    /// From now on every change in a step counts, because the lesson is being written.
    pub fn write_lesson(&mut self) {
        self.steps = Some(StepWork::All);
    }

    /// True while a lesson is played.
    pub fn plays_lesson(&self) -> bool {
        self.steps.is_some()
    }

    /// A document from this source that was left with changes.
    pub fn take_left(&mut self, source: Option<&Source>) -> Option<Document> {
        self.take(|held| held.place == Place::Left && Source::of(&held.document).as_ref() == source)
    }

    fn take(&mut self, is_it: impl Fn(&HeldDocument) -> bool) -> Option<Document> {
        let index = self.held.iter().position(is_it)?;
        Some(self.held.remove(index).document)
    }

    /// The sources of the documents that were left with changes.
    pub fn left(&self) -> impl Iterator<Item = Option<Source>> {
        self.held.iter().filter(|held| held.place == Place::Left).map(|held| Source::of(&held.document))
    }

    /// The hidden documents with work.
    pub fn held(&self) -> Vec<&Document> {
        let mut behind_shown = vec![self.shown.id()];
        for held in self.held.iter().rev() {
            if matches!(held.place, Place::Behind(id) if behind_shown.contains(&id)) {
                behind_shown.push(held.document.id());
            }
        }
        let is_lost = |held: &&HeldDocument| match held.place {
            // Redoing may lead there, or not.
            Place::InFront(_) => false,
            Place::Behind(id) if behind_shown.contains(&id) => self.is_work(&held.document),
            Place::Behind(_) | Place::Step(_) | Place::Left | Place::GivenUp => held.document.is_changed(),
        };
        self.held.iter().filter(is_lost).map(|held| &held.document).collect()
    }

    /// A document by its number, also a hidden one.
    pub fn by_id(&mut self, id: Revision) -> Option<&mut Document> {
        let held = self.held.iter_mut().map(|held| &mut held.document);
        std::iter::once(&mut self.shown).chain(held).find(|document| document.id() == id)
    }

    /// The next document that closing the window would lose, to show it and ask. `None` if there are none left.
    /// `gives_up` is true if the shown one has changes that the user doesn't want.
    pub fn next_to_close(&mut self, gives_up: bool) -> Option<Document> {
        self.keep_behind();
        self.move_steps(|_| None);
        let last = self.held.iter().rposition(|held| held.place == Place::Left)?;
        let next = self.held.remove(last).document;
        if gives_up {
            // If the window isn't closed after all, the figure is still there.
            self.held.push(HeldDocument { document: self.shown.clone(), place: Place::GivenUp });
        }
        Some(next)
    }

    /// Keeps what the user gave up, because the window isn't closed.
    pub fn keep_given_up(&mut self) {
        for held in self.held.iter_mut().filter(|held| held.place == Place::GivenUp) {
            held.place = Place::Left;
        }
    }
}

#[cfg(test)]
mod tests;
