//! A lesson of the user's own, written in the window: its texts and those of its step as typed, the changes of its
//! file, and undo.

use std::path::Path;
use std::sync::Arc;

use crate::figure::{Figure, FigureError, Localized, difference};
use crate::gui::learn::lesson::recording::for_lesson;
use crate::gui::learn::{CAN_WRITE, Learn};
use crate::lessons::{
    Edit, Lesson, LessonText, OpenLesson, StepText, Task, TaskText, Words, edited, reworded, text_of_step, with_step,
    words_in_file,
};
use camera_lab_desk::{Message, Model, UnsavedText};
use camera_lab_files::{self as files, FileError, Overwrite, share};
use camera_lab_words::Lang;

/// Changes that can be taken back.
const MOST_EARLIER: usize = 100;

/// The writing of the displayed step.
#[derive(Debug, Default)]
pub struct Writing {
    /// The text of the file as last read or written.
    text: String,
    /// The step whose texts these are, from 0.
    step: usize,
    /// The typed texts.
    pub typed: Typed,
    /// The same as they are in the file.
    kept: Typed,
    /// The file with the typed texts that are valid, not yet written, and these texts.
    ahead: Option<(String, Typed)>,
    /// The reason why the others can't be written.
    pub fault: Option<FigureError>,
    /// The language of the fields.
    pub lang: Lang,
    /// The displayed group of fields.
    pub shows: Fields,
    /// The time of the last key, in seconds.
    pub typed_at: f64,
    /// The file before each change, and the displayed step then.
    earlier: Vec<(String, usize)>,
    /// The file after each change that was undone, and its step.
    later: Vec<(String, usize)>,
    /// Typed text that isn't in the file, as a session stores it.
    unsaved: Option<Arc<UnsavedText>>,
}

/// A group of fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fields {
    /// Title, text and notes of the step.
    #[default]
    Step,
    /// The question or goal of the step.
    Task,
    /// Title, sentence and minutes of the lesson.
    Lesson,
}

/// The typed texts of a step and of its lesson.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Typed {
    /// Title, text and notes of the step, then title, sentence and minutes of the lesson. The minutes in the first
    /// language alone.
    pub words: [Localized; FIELDS.len()],
    /// The task of the step.
    pub task: TaskText,
}

impl Writing {
    fn new(text: String, lang: Lang) -> Self {
        Self { text, step: usize::MAX, lang, ..Self::default() }
    }

    /// The changes of the file to undo, or to redo.
    fn changes(&mut self, back: bool) -> &mut Vec<(String, usize)> {
        if back { &mut self.earlier } else { &mut self.later }
    }

    /// True if a change of the file can be undone, or redone.
    pub fn can_undo(&self, back: bool) -> bool {
        !if back { &self.earlier } else { &self.later }.is_empty()
    }

    /// True if the typed text isn't in the file.
    pub fn is_ahead(&self) -> bool {
        self.typed != self.kept
    }

    /// Shows the texts of a step, and of its lesson.
    fn show(&mut self, number: usize, lesson: &Lesson) {
        if number >= lesson.steps.len() {
            return;
        }
        let minutes =
            lesson.minutes.map(|minutes| crate::numbers::significant(minutes, MINUTES_DIGITS)).unwrap_or_default();
        let [title, text, notes, of_lesson, sentence] = words_in_file(&self.text, number);
        let minutes = Localized { en: minutes, ..Localized::default() };
        let texts = [title, text, notes, of_lesson, sentence, minutes];
        let task = text_of_step(&self.text, number).map(TaskText::of_step).unwrap_or_default();
        let typed = Typed { words: texts, task };
        (self.step, self.typed, self.kept) = (number, typed.clone(), typed);
        (self.ahead, self.fault, self.unsaved) = (None, None, None);
    }

    /// True if typed text waits to be written.
    pub(in crate::gui) const fn has_valid_text(&self) -> bool {
        self.ahead.is_some()
    }

    /// Holds the typed text that isn't in the file for the session.
    fn hold(&mut self, path: &Path) {
        self.unsaved = self.is_ahead().then(|| {
            let (text, Typed { words, task }) = (self.text.clone(), self.typed.clone());
            Arc::new(UnsavedText { path: path.to_owned(), step: self.step, text, words, task })
        });
    }

    /// The file with the typed texts, its lesson and these texts. If one of them has a fault, it keeps its old text in
    /// the file, and the fault comes too.
    fn tried(&self) -> (Option<(String, Lesson, Typed)>, Option<FigureError>) {
        let fault = match self.with(&self.typed) {
            Ok((text, lesson)) => return (Some((text, lesson, self.typed.clone())), None),
            Err(fault) => fault,
        };
        let mut found: Option<(String, Lesson, Typed)> = None;
        for part in 0..=FIELDS.len() {
            let mut next = found.as_ref().map_or(&self.kept, |(.., valid)| valid).clone();
            match (next.words.get_mut(part), self.typed.words.get(part)) {
                (Some(words), Some(typed)) => words.clone_from(typed),
                _ => next.task.clone_from(&self.typed.task),
            }
            if let Ok((text, lesson)) = self.with(&next) {
                found = Some((text, lesson, next));
            }
        }
        (found, Some(fault))
    }

    /// The file with these texts.
    fn with(&self, typed: &Typed) -> Result<(String, Lesson), FigureError> {
        let fields = FIELDS.into_iter().zip(typed.words.iter().zip(&self.kept.words));
        let changed = fields.filter(|(_, (typed, kept))| typed != kept);
        let words = changed.map(|(words, (typed, _))| words(self.step, typed.clone()));
        let task = (typed.task != self.kept.task).then(|| Box::new(typed.task.clone()));
        let words: Vec<Words> = words.chain(task.map(|task| Words::Task(self.step, task))).collect();
        reworded(&self.text, &words)
    }
}

/// The words of a field: those of a step, then those of the lesson.
const FIELDS: [fn(usize, Localized) -> Words; 6] = [
    |step, told| Words::OfStep(step, StepText::Title, told),
    |step, told| Words::OfStep(step, StepText::Text, told),
    |step, told| Words::OfStep(step, StepText::Notes, told),
    |_, told| Words::OfLesson(LessonText::Title, told),
    |_, told| Words::OfLesson(LessonText::Sentence, told),
    |_, told| Words::OfLesson(LessonText::Minutes, told),
];

/// The fields that are those of the step.
pub(in crate::gui) const FIELDS_OF_STEP: usize = 3;

/// Digits of the minutes in their field.
const MINUTES_DIGITS: usize = 4;

/// A change of the steps of a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StepChange {
    /// The step comes before the one above it.
    Earlier,
    /// The step comes after the next one.
    Later,
    /// The step shows the state on the screen.
    Screen,
    /// One more step after this one, with the state on the screen.
    Another,
    /// A step less.
    Remove,
}

impl Learn {
    /// True if the lesson being played is a file that can be written.
    pub fn plays_own_lesson(&self, model: &Model) -> bool {
        let path = self.lesson.as_ref().and_then(|playing| playing.path.as_deref());
        CAN_WRITE && path.is_some_and(|path| share::link_of(path).is_none()) && !model.in_browser
    }

    /// True if the user is writing the step. In a presentation the class sees its final form.
    pub fn writes_lesson(&self, model: &Model) -> bool {
        let writes = || self.lesson.as_ref().is_some_and(|playing| playing.writing.is_some());
        CAN_WRITE && !model.settings.presentation && writes()
    }

    /// Starts or ends writing the displayed step.
    pub(in crate::gui) fn write_lesson(&mut self, model: &mut Model) {
        if !CAN_WRITE || !self.save_text(model) || !self.plays_own_lesson(model) {
            return;
        }
        let lang = model.settings.lang;
        let Some(playing) = &mut self.lesson else { return };
        if playing.writing.take().is_some() {
            return;
        }
        let Some(path) = playing.path.clone() else { return };
        match files::read_lesson(&path) {
            Ok((lesson, text)) => {
                playing.lesson = Arc::new(lesson);
                playing.step = playing.step.min(playing.lesson.steps.len().saturating_sub(1));
                playing.writing = Some(Writing::new(text, lang));
                model.desk.write_lesson();
                self.file = Some(path);
                self.follow_writing();
            }
            Err(error) => model.say(Message::File(path, error)),
        }
    }

    /// Plays the last step of the lesson to which steps were added last, and starts writing it. The figure is lost.
    pub(in crate::gui) fn write_recorded(&mut self, model: &mut Model) {
        let Some(path) = self.file.clone() else { return };
        match files::read_lesson(&path) {
            Ok((lesson, _)) => {
                let step = lesson.steps.len().saturating_sub(1);
                self.play(model, OpenLesson { lesson: Arc::new(lesson), path: Some(path), step });
                self.write_lesson(model);
            }
            Err(error) => model.say(Message::File(path, error)),
        }
    }

    /// Shows the texts of the step being played in the fields.
    pub(in crate::gui) fn follow_writing(&mut self) {
        let Some(playing) = &mut self.lesson else { return };
        if let Some(writing) = &mut playing.writing
            && writing.step != playing.step
        {
            writing.show(playing.step, &playing.lesson);
        }
    }

    /// The text of the lesson that isn't in its file.
    pub fn unsaved_text(&self) -> Option<&Arc<UnsavedText>> {
        self.lesson.as_ref()?.writing.as_ref()?.unsaved.as_ref()
    }

    /// True if the text that isn't in the file could be written into another one.
    pub(in crate::gui) fn has_good_text(&self) -> bool {
        let writing = self.lesson.as_ref().and_then(|playing| playing.writing.as_ref());
        writing.is_some_and(|writing| writing.ahead.is_some())
    }

    /// Goes on with the text of a session, in the step in which it was typed. `shown` is the figure of the window.
    pub(in crate::gui) fn resume_text(&mut self, model: &mut Model, unsaved: UnsavedText, shown: Figure) {
        if !CAN_WRITE {
            return;
        }
        let UnsavedText { path, step, text, words, task } = unsaved;
        // A session without a lesson was not restored.
        let Ok(lesson) = crate::lessons::parse(&text) else { return };
        let step = step.min(lesson.steps.len().saturating_sub(1));
        self.play(model, OpenLesson { lesson: Arc::new(lesson), path: Some(path.clone()), step });
        let lang = model.settings.lang;
        if let Some(playing) = &mut self.lesson {
            playing.writing = Some(Writing::new(text, lang));
            model.desk.write_lesson();
        }
        self.follow_writing();
        if let Some(writing) = self.lesson.as_mut().and_then(|playing| playing.writing.as_mut()) {
            writing.typed = Typed { words, task };
        }
        self.file = Some(path);
        self.text_edited(0.0);
        if model.desk.shown.figure() != &shown {
            let done = model.desk.replace(shown);
            model.say_camera_error(done);
        }
    }

    /// Applies the typed text to the displayed lesson, or finds the reason why it can't.
    pub(in crate::gui) fn text_edited(&mut self, now: f64) {
        if !CAN_WRITE {
            return;
        }
        let Some(playing) = &mut self.lesson else { return };
        let (Some(path), Some(writing)) = (&playing.path, &mut playing.writing) else { return };
        writing.typed_at = now;
        writing.hold(path);
        let (found, fault) = writing.tried();
        (writing.ahead, writing.fault) = (None, fault);
        let Some((text, lesson, valid)) = found else { return };
        writing.ahead = (valid != writing.kept).then_some((text, valid));
        if let Some(Task::Question(entry)) = lesson.steps.get(playing.step).and_then(|step| step.task.as_ref()) {
            self.exercises.preview((**entry).clone());
        }
        playing.lesson = Arc::new(lesson);
    }

    /// Writes the typed text into the file. Returns false if some of it can't be written. Then a message says why, and
    /// the texts stay in their fields.
    pub(in crate::gui) fn save_text(&mut self, model: &mut Model) -> bool {
        if !self.save_valid_text(model) {
            return false;
        }
        let Some(playing) = &self.lesson else { return true };
        let (Some(path), Some(writing)) = (&playing.path, &playing.writing) else { return true };
        if let Some(fault) = writing.fault.clone().filter(|_| writing.is_ahead()) {
            model.say(Message::StepNotKept(path.clone(), FileError::Figure(fault)));
        }
        !writing.is_ahead()
    }

    /// Writes the typed texts without a fault into the file. Returns false, with a message, if the file can't be
    /// written.
    pub(in crate::gui) fn save_valid_text(&mut self, model: &mut Model) -> bool {
        if !CAN_WRITE {
            return true;
        }
        let Some(playing) = &mut self.lesson else { return true };
        let (Some(path), Some(writing)) = (playing.path.clone(), &mut playing.writing) else { return true };
        let Some((text, valid)) = writing.ahead.clone() else { return true };
        let step = writing.step;
        let is_kept = self.store(model, &path, text, step);
        if is_kept && let Some(writing) = self.lesson.as_mut().and_then(|playing| playing.writing.as_mut()) {
            (writing.kept, writing.ahead) = (valid, None);
            writing.hold(&path);
        }
        is_kept
    }

    /// Drops typed text that isn't in the file.
    pub(in crate::gui) fn forget_text(&mut self) {
        let Some(playing) = &mut self.lesson else { return };
        let Some(writing) = &mut playing.writing else { return };
        writing.typed = writing.kept.clone();
        self.text_edited(0.0);
    }

    /// Saves the lesson with its typed text as another file and continues with that file. Returns false if it can't be
    /// written.
    pub(in crate::gui) fn save_text_as(&mut self, model: &mut Model, path: &Path, overwrite: Overwrite) -> bool {
        if !CAN_WRITE {
            return true;
        }
        let Some(playing) = &mut self.lesson else { return true };
        let Some(writing) = &mut playing.writing else { return true };
        let Some((text, valid)) = writing.ahead.clone() else { return false };
        if let Err(error) = files::save(path, text.as_bytes(), overwrite) {
            model.say(Message::File(path.to_owned(), error));
            return false;
        }
        playing.path = Some(path.to_owned());
        (writing.text, writing.kept, writing.ahead) = (text, valid, None);
        writing.hold(path);
        // The changes of the other file aren't those of this one.
        (writing.earlier, writing.later) = Default::default();
        self.file = Some(path.to_owned());
        true
    }

    /// Adds the state on the screen as the last step of the lesson being written.
    pub(in crate::gui) fn add_to_written(&mut self, model: &mut Model, path: &Path) {
        if !CAN_WRITE || !self.save_text(model) {
            return;
        }
        let (figure, left_out) = for_lesson(model, path);
        let Some(playing) = &self.lesson else { return };
        let Some(writing) = &playing.writing else { return };
        let draft = self.draft_of_step(model, Some(&playing.lesson));
        let step = playing.step;
        match with_step(&writing.text, &playing.lesson.id, &draft, &figure) {
            Ok((text, lesson)) => {
                if self.store(model, path, text, step) {
                    self.step_is_added(model, path, lesson, left_out);
                }
            }
            Err(fault) => model.say(Message::StepNotKept(path.to_owned(), FileError::Figure(fault))),
        }
    }

    /// Changes the steps of the lesson in its file.
    pub(in crate::gui) fn change_steps(&mut self, model: &mut Model, change: StepChange) {
        if !CAN_WRITE || !self.save_text(model) {
            return;
        }
        let Some(path) = self.lesson.as_ref().and_then(|playing| playing.path.clone()) else { return };
        let shown = matches!(change, StepChange::Screen | StepChange::Another);
        let (figure, left_out) = if shown { for_lesson(model, &path) } else { Default::default() };
        let Some(playing) = &self.lesson else { return };
        let Some(writing) = &playing.writing else { return };
        let (step, count) = (playing.step, playing.lesson.steps.len());
        let (changed, then) = match change {
            StepChange::Earlier => {
                (edited(&writing.text, &Edit::Move(step, step.saturating_sub(1))), step.saturating_sub(1))
            }
            StepChange::Later => (edited(&writing.text, &Edit::Move(step, step + 1)), step + 1),
            StepChange::Screen => {
                let title = self.title_to_record(model, Some(&playing.lesson));
                let title = title.map(|title| Words::OfStep(step, StepText::Title, title));
                let shown = edited(&writing.text, &Edit::Show(step, Box::new(figure)));
                (shown.and_then(|(text, _)| reworded(&text, title.as_slice())), step)
            }
            StepChange::Another => {
                let draft = self.draft_of_step(model, Some(&playing.lesson));
                let added = with_step(&writing.text, &playing.lesson.id, &draft, &figure);
                (added.and_then(|(text, _)| edited(&text, &Edit::Move(count, step + 1))), step + 1)
            }
            StepChange::Remove => (edited(&writing.text, &Edit::Remove(step)), step.saturating_sub(1)),
        };
        match changed {
            Ok((text, lesson)) => {
                let taken = lesson.steps.get(step).map(|now| &*now.figure);
                let taken = self.lesson.as_ref().zip(taken).map(|(before, now)| {
                    let before = before.now().map(|step| &*step.figure);
                    difference(before, now).keys()
                });
                if self.store(model, &path, text, step) {
                    let message = match (left_out, &change) {
                        (Some(left_out), StepChange::Screen) => Some(Message::OutOfReach(path, left_out)),
                        (left_out @ Some(_), StepChange::Another) => Some(Message::StepAdded(path, then + 1, left_out)),
                        (None, StepChange::Screen) => taken.map(Message::StepTook),
                        _ => None,
                    };
                    // A step that begins takes the message of the one before it away.
                    self.go_on_changed(model, lesson, change, step, then);
                    let writing = self.lesson.as_mut().and_then(|playing| playing.writing.as_mut());
                    if let Some(writing) = writing.filter(|_| change == StepChange::Another) {
                        // The fields of a question would take the title that you type first.
                        writing.shows = Fields::Step;
                    }
                    message.into_iter().for_each(|message| model.say(message));
                }
            }
            Err(fault) => model.say(Message::StepNotKept(path, FileError::Figure(fault))),
        }
    }

    /// True if the lesson being written has a change to undo, or to redo, after those of the figure on the screen.
    pub fn can_undo_lesson(&self, model: &Model, back: bool) -> bool {
        self.writes_lesson(model)
            && self.lesson.as_ref().and_then(|playing| playing.writing.as_ref()).is_some_and(|w| w.can_undo(back))
    }

    /// Undoes the last change of the lesson's file, or redoes it.
    pub(in crate::gui) fn undo_lesson(&mut self, model: &mut Model, back: bool) {
        if !CAN_WRITE || !self.save_text(model) {
            return;
        }
        let Some(playing) = &mut self.lesson else { return };
        let (Some(path), Some(writing)) = (playing.path.clone(), &mut playing.writing) else { return };
        let Some((text, step)) = writing.changes(back).pop() else { return };
        let (now, shown) = (writing.text.clone(), writing.step);
        let Ok(lesson) = crate::lessons::parse(&text) else { return };
        let kept = (std::mem::take(&mut writing.earlier), std::mem::take(&mut writing.later));
        let is_stored = self.store(model, &path, text, step);
        if let Some(writing) = self.lesson.as_mut().and_then(|playing| playing.writing.as_mut()) {
            // The way back is no change of its own.
            (writing.earlier, writing.later) = kept;
            if is_stored {
                writing.changes(!back).push((now, shown));
            }
        }
        if is_stored {
            self.play_changed(model, lesson, step);
        }
    }

    /// Writes the text of the lesson into its file, unless another program has changed it. Returns true if it's
    /// written.
    fn store(&mut self, model: &mut Model, path: &Path, text: String, step: usize) -> bool {
        if !CAN_WRITE {
            return false;
        }
        let Some(writing) = self.lesson.as_mut().and_then(|playing| playing.writing.as_mut()) else {
            return false;
        };
        match files::read_lesson(path) {
            Ok((_, now)) if now == writing.text => {}
            // A disk that answers late says nothing about the file.
            Err(FileError::Read(error)) if error.kind() == std::io::ErrorKind::TimedOut => {
                model.say(Message::File(path.to_owned(), FileError::Read(error)));
                return false;
            }
            _ if files::disk::may_exist(path) => {
                model.say(Message::LessonChanged(path.to_owned()));
                return false;
            }
            _ => {}
        }
        match files::save(path, text.as_bytes(), Overwrite::Writable) {
            Ok(()) => {
                let before = std::mem::replace(&mut writing.text, text);
                if writing.earlier.len() == MOST_EARLIER {
                    writing.earlier.remove(0);
                }
                writing.earlier.push((before, step));
                writing.later.clear();
                true
            }
            Err(error) => {
                model.say(Message::File(path.to_owned(), error));
                false
            }
        }
    }

    /// Reads the lesson again after another program has changed it. Text that isn't in the file is lost.
    pub(in crate::gui) fn read_lesson_again(&mut self, model: &mut Model) {
        if !CAN_WRITE {
            return;
        }
        let Some(playing) = &self.lesson else { return };
        let (Some(path), step) = (playing.path.clone(), playing.step) else { return };
        match files::read_lesson(&path) {
            Ok((lesson, text)) => {
                let writing = self.lesson.as_mut().and_then(|playing| playing.writing.as_mut());
                writing.into_iter().for_each(|writing| writing.text.clone_from(&text));
                self.play_changed(model, lesson, step);
            }
            Err(error) => model.say(Message::File(path, error)),
        }
    }

    /// Goes on after a change of the steps. The work in each step goes with it. That in a removed step is kept.
    fn go_on_changed(&mut self, model: &mut Model, lesson: Lesson, change: StepChange, step: usize, then: usize) {
        self.end_move(model);
        // A step has no caption.
        let has_caption = model.desk.shown.figure().caption != model.desk.shown.saved().caption;
        if change == StepChange::Remove {
            self.leave_step(model);
        } else if has_caption && matches!(change, StepChange::Screen | StepChange::Another) {
            model.desk.keep_shown();
        }
        model.desk.move_steps(|place: usize| match change {
            StepChange::Earlier | StepChange::Later if place == step => Some(then),
            StepChange::Earlier | StepChange::Later if place == then => Some(step),
            StepChange::Another if place > step => Some(place + 1),
            StepChange::Remove if place > step => Some(place - 1),
            StepChange::Remove if place == step => None,
            _ => Some(place),
        });
        let Some(playing) = &mut self.lesson else { return };
        if matches!(change, StepChange::Earlier | StepChange::Later) {
            // The step is the same, and so is the figure on the screen.
            playing.take_lesson(Arc::new(lesson));
            playing.step = then;
            if let Some(writing) = &mut playing.writing {
                writing.step = usize::MAX;
            }
            self.follow_writing();
        } else {
            self.show_changed(model, lesson, then);
        }
    }

    /// Shows a step of the lesson from another text of the file. The work in steps is kept, because it's unknown to
    /// which of the new steps it belongs.
    fn play_changed(&mut self, model: &mut Model, lesson: Lesson, step: usize) {
        self.end_move(model);
        self.leave_step(model);
        model.desk.move_steps(|_| None);
        self.show_changed(model, lesson, step);
    }

    fn show_changed(&mut self, model: &mut Model, lesson: Lesson, step: usize) {
        let Some(playing) = &mut self.lesson else { return };
        let step = step.min(lesson.steps.len().saturating_sub(1));
        playing.take_lesson(Arc::new(lesson));
        if let Some(writing) = &mut playing.writing {
            writing.step = usize::MAX;
        }
        if let Some(playing) = self.lesson.take() {
            self.show_step(model, playing, step, false);
        }
        self.follow_writing();
    }
}
