//! The lesson being played: its step, the move to it, and finished tasks.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::hands::{Hands, question_with_choices};
use super::moving::Moving;
use crate::camera::{Camera, Operation};
use crate::figure::{Figure, Observers, Show};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::Chosen;
use crate::gui::learn::lesson::writing::Writing;
use crate::lessons::{Goal, Lesson, OpenLesson, Passage, Seen, Step, Subject, Task, shipped};
use camera_lab_desk::{Document, Message, Model, Panels, Revision};
use camera_lab_files as files;

/// Seconds of the move to the figure that answers a question.
const SEEN: f64 = 2.0;

/// A lesson being played.
#[derive(Debug, Default)]
pub struct Playing {
    /// The lesson.
    pub lesson: Arc<Lesson>,
    /// Its file. `None` for a built-in lesson.
    pub path: Option<std::path::PathBuf>,
    /// The step, from 0.
    pub step: usize,
    /// The move to the step, while it continues.
    pub(in crate::gui) moving: Option<Moving>,
    /// The text of the step is shown.
    pub shows_text: bool,
    /// The question of the step is shown.
    pub shows_question: bool,
    /// The speaker's notes are shown, in a window of their own or, if there is none, below the views.
    pub shows_notes: bool,
    /// In a presentation, the notes are shown below the views, which the class sees. False at its beginning.
    pub shows_private_notes: bool,
    /// The writing of the step, in a lesson of the user's own.
    pub writing: Option<Writing>,
    /// True if a link holds the whole lesson, if it's the user's own, instead of the figure of the step.
    pub links_whole: bool,
    /// Counts the fadings of the pictures before a step.
    pub(in crate::gui) fades: u64,
    /// The hands that the class has raised.
    pub(in crate::gui) hands: Hands,
    /// True if part of text and task is out of sight. Set by the panel.
    pub is_cut: bool,
    /// The height of the panel, and the values that it depends on. Set by the panel.
    pub(in crate::gui) height: Option<(super::Fits, f32)>,
    /// The steps whose task is done.
    done: BTreeSet<usize>,
    /// The steps whose task was skipped.
    passed: BTreeSet<usize>,
    /// The steps whose way was shown.
    shown: BTreeSet<usize>,
    /// The step whose task the next request to continue skips.
    warned: Option<usize>,
    /// The typed digits of the number of a step, and the time of the last one.
    pub(in crate::gui) typed: Option<(usize, f64)>,
    /// The last figure for which the goal was checked, and what it shows.
    looked_at: Option<(Revision, Observers, Show)>,
    seen: Seen,
    /// The panels as they were before the lesson, out of a presentation.
    panels_before: Panels,
}

impl Playing {
    /// Shows or hides the notes: in a presentation those below the views, so their window stays as it is.
    pub(in crate::gui) fn toggle_notes(&mut self, presents: bool) {
        *(if presents { &mut self.shows_private_notes } else { &mut self.shows_notes }) ^= true;
    }

    /// True if the notes are on, as [`Self::toggle_notes`] changes them.
    pub(in crate::gui) fn has_notes(&self, presents: bool) -> bool {
        if presents { self.shows_private_notes } else { self.shows_notes }
    }

    /// The displayed step.
    pub fn now(&self) -> Option<&Step> {
        self.lesson.steps.get(self.step)
    }

    /// True if the step has nothing left to do.
    pub fn is_done(&self) -> bool {
        self.now().is_none_or(|step| step.task.is_none()) || self.done.contains(&self.step)
    }

    /// True if the next step may be shown, because the task is done, or was skipped.
    pub fn may_go_on(&self) -> bool {
        self.is_done() || self.passed.contains(&self.step)
    }

    /// True while a question of the lesson's own is shown.
    pub(in crate::gui) fn asks_question(&self) -> bool {
        self.shows_question && self.now().is_some_and(|step| matches!(step.task, Some(Task::Question(_))))
    }

    /// Goes on with another text of the lesson, in which steps may have other places.
    pub(in crate::gui) fn take_lesson(&mut self, lesson: Arc<Lesson>) {
        self.lesson = lesson;
        self.done.clear();
        self.passed.clear();
    }

    /// True if the goal was checked for this figure.
    fn has_looked_at(&self, document: &Document) -> bool {
        let Figure { observers, show, .. } = document.figure();
        self.looked_at
            .as_ref()
            .is_some_and(|(version, seen, shown)| (*version, seen, shown) == (document.version(), observers, show))
    }

    /// Shows the question of the step, then its answer if the class has choices, and then neither.
    pub(in crate::gui) fn go_on_asking(&mut self, presents: bool) {
        let has_choices = self.now().and_then(question_with_choices).is_some();
        if self.shows_question && presents && has_choices && self.hands.answered != Some(self.step) {
            self.hands.answered = Some(self.step);
            // The class has seen the answer, so the next step may come.
            self.passed.insert(self.step);
        } else {
            self.shows_question ^= true;
            self.hands.answered = None;
        }
    }

    /// True if its steps are remembered. A lesson of the user's own doesn't count as the built-in one with the same
    /// name.
    fn counts(&self) -> bool {
        self.path.is_none() || !shipped().iter().any(|shipped| shipped.lesson.id == self.lesson.id)
    }

    /// True if this step is the last one.
    pub fn is_last(&self) -> bool {
        self.step + 1 >= self.lesson.steps.len()
    }
}

impl Learn {
    /// True if "•" marks the figure in the title of the window and in its menu bar: closing the window asks about it.
    pub(in crate::gui) fn is_marked(&self, model: &Model) -> bool {
        !self.moves_to_step() && model.is_unsaved() || self.unsaved_text().is_some()
    }

    /// Keeps the work in the figure, or behind it, waiting in the step that is left.
    pub(in crate::gui) fn leave_step(&self, model: &mut Model) {
        if let Some(playing) = &self.lesson {
            model.desk.leave_step(playing.step);
        }
    }

    /// The panels at the sides as the user wants them without a lesson.
    pub fn own_panels<'a>(&'a self, model: &'a Model) -> &'a Panels {
        self.lesson.as_ref().map_or(&model.settings.panels, |playing| &playing.panels_before)
    }

    /// The number of steps of a lesson that have a task, and of those that are done.
    pub fn done_of(&self, lesson: &Lesson) -> (usize, usize) {
        let done = self.done.get(&lesson.id);
        let tasks = lesson.steps.iter().enumerate().filter(|(_, step)| step.task.is_some());
        let (all, is_done): (Vec<usize>, Vec<bool>) =
            tasks.map(|(step, _)| (step, done.is_some_and(|done| done.contains(&step)))).unzip();
        (is_done.into_iter().filter(|is| *is).count(), all.len())
    }

    /// True if all tasks of a lesson are done.
    pub fn is_finished(&self, lesson: &Lesson) -> bool {
        let (done, all) = self.done_of(lesson);
        done == all && self.taken.contains_key(&lesson.id)
    }

    /// The next built-in lesson to take, by its place: the first unfinished one that was begun, else the first
    /// unfinished one.
    pub fn next_lesson(&self) -> Option<usize> {
        let open = || shipped().iter().enumerate().filter(|(_, shipped)| !self.is_finished(&shipped.lesson));
        let mut begun = open().filter(|(_, shipped)| self.taken.contains_key(&shipped.lesson.id));
        begun.next().or_else(|| open().next()).map(|(place, _)| place)
    }

    /// The lesson and the step to go on with: those that were left last, or if that was the end of the lesson, those of
    /// the next one.
    pub fn place_to_go_on(&self) -> Option<(&'static Arc<Lesson>, usize)> {
        let stopped = self.stopped.as_ref().and_then(|(id, step)| {
            let lesson = &shipped().iter().find(|shipped| shipped.lesson.id == *id)?.lesson;
            let is_done = || self.done.get(id).is_some_and(|done| done.contains(step));
            let has_more = step + 1 < lesson.steps.len() || (lesson.steps.get(*step)?.task.is_some() && !is_done());
            has_more.then_some((lesson, *step))
        });
        let next = || self.next_lesson().and_then(|place| shipped().get(place)).map(|shipped| &shipped.lesson);
        stopped.or_else(|| next().map(|lesson| (lesson, self.step_to_go_on(lesson))))
    }

    /// The step from which a lesson continues: the first with an unfinished task, at its last step or before.
    pub fn step_to_go_on(&self, lesson: &Lesson) -> usize {
        let furthest = self.taken.get(&lesson.id).copied().unwrap_or_default();
        let done = self.done.get(&lesson.id);
        let is_open = |step: &usize| lesson.steps[*step].task.is_some() && done.is_none_or(|done| !done.contains(step));
        let last = lesson.steps.len().saturating_sub(1);
        if furthest < last { furthest } else { (0..lesson.steps.len()).find(is_open).unwrap_or_default() }
    }

    /// Plays a lesson. The figure is lost, so only the window's start calls this, and
    /// [`file_flow`](crate::gui::app::file_flow) once it has asked.
    pub(in crate::gui) fn play(&mut self, model: &mut Model, open: OpenLesson) {
        let OpenLesson { lesson, path, step } = open;
        if step == 0 {
            let question = |step: &Step| match &step.task {
                Some(Task::Question(entry)) => Some(entry.id.clone().into_owned()),
                _ => None,
            };
            self.exercises.ask_again(lesson.steps.iter().filter_map(question));
        }
        // A session of another folder has to find the file too.
        let path =
            path.map(|path| if camera_lab_files::share::link_of(&path).is_some() { path } else { files::whole(&path) });
        let playing = Playing {
            lesson,
            path,
            step,
            shows_text: true,
            shows_question: !model.settings.presentation,
            links_whole: true,
            panels_before: *self.own_panels(model),
            ..Playing::default()
        };
        self.show_step(model, playing, step, false);
    }

    /// Ends the lesson. The figure of its step stays.
    pub(in crate::gui) fn leave_lesson(&mut self, model: &mut Model) {
        self.end_move(model);
        self.close_lesson(model);
    }

    /// Forgets the lesson, and restores the panels. Work in its steps is kept.
    pub(in crate::gui) fn close_lesson(&mut self, model: &mut Model) {
        if let Some(playing) = self.lesson.take() {
            model.settings.panels.wanted = playing.panels_before.wanted;
            model.desk.leave_lesson();
        }
        self.exercises.of_lesson.clear();
        self.exercises.leave_unknown();
    }

    /// Shows the original figure of the step. Undoing brings the changed one back.
    pub fn step_again(&mut self, model: &mut Model) {
        self.end_move(model);
        let Some(playing) = self.lesson.take() else { return };
        let mut document = model.desk.shown.clone();
        if let Some(step) = playing.now()
            && document.replace((*step.figure).clone()).is_ok()
        {
            let step = playing.step;
            self.show_in_step(model, playing, step, document, false);
        } else {
            self.lesson = Some(playing);
        }
    }

    /// Goes to a step, from 0, if it exists. Work in the step that is left waits there.
    pub fn go_to_step(&mut self, model: &mut Model, step: usize) {
        if !self.save_text(model) {
            return;
        }
        self.end_move(model);
        if self.lesson.as_ref().is_none_or(|playing| step >= playing.lesson.steps.len()) {
            return;
        }
        self.leave_step(model);
        let Some(playing) = self.lesson.take() else { return };
        let moves = step == playing.step + 1;
        self.show_step(model, playing, step, moves);
    }

    /// Goes on to the next step, or back to the one before. A message mentions an open task once, and the next
    /// call skips it.
    pub fn step_lesson(&mut self, model: &mut Model, forwards: bool) {
        if self.end_move(model) && forwards {
            return;
        }
        let Some(playing) = &mut self.lesson else { return };
        let step = playing.step;
        if !forwards {
            match step.checked_sub(1) {
                Some(before) => self.go_to_step(model, before),
                None => model.say(Message::FirstStep),
            }
            return;
        }
        if !playing.may_go_on() && playing.warned != Some(step) {
            playing.warned = Some(step);
            playing.shows_question = true;
            return model.say(Message::TaskFirst);
        }
        playing.passed.insert(step);
        if playing.is_last() {
            return model.say(Message::LastStep);
        }
        self.go_to_step(model, step + 1);
    }

    /// Passes over the task of the step.
    pub(in crate::gui) fn pass_over(&mut self) {
        if let Some(playing) = &mut self.lesson {
            playing.passed.insert(playing.step);
        }
    }

    /// Changes the figure by the lesson's way to the goal, from the figure of the step, as one change.
    pub(in crate::gui) fn show_solution(&mut self, model: &mut Model, goal: &Goal) {
        let Some(figure) = self.lesson.as_ref().and_then(|playing| Some(playing.now()?.figure.clone())) else {
            return;
        };
        let Ok(camera) = Camera::new(&figure.camera) else { return };
        // A lesson that was read has tried it.
        let Ok(after) = goal.reached_from(&figure, &camera) else { return };
        if let Some(playing) = &mut self.lesson {
            playing.shown.insert(playing.step);
        }
        let seen = model.desk.shown.figure().observers;
        let done = model.desk.replace(Figure { observers: seen, ..after.figure });
        model.say_camera_error(done);
    }

    /// Shows a step and brings back the changes you tried in it, either at once or with a camera move.
    pub(in crate::gui) fn show_step(&mut self, model: &mut Model, playing: Playing, step: usize, moves: bool) {
        self.end_move(model);
        let Some(shown) = playing.lesson.steps.get(step) else { return };
        let waiting = model.desk.take_from_step(step);
        let document = match waiting {
            Some(document) => Ok(document),
            None => Document::of_lesson((*shown.figure).clone(), playing.path.as_deref()),
        };
        match document {
            Ok(document) => self.show_in_step(model, playing, step, document, moves),
            Err(error) => {
                self.lesson = Some(playing);
                model.say(Message::Camera(error));
            }
        }
    }

    /// Shows this document in a step.
    fn show_in_step(&mut self, model: &mut Model, mut playing: Playing, step: usize, document: Document, moves: bool) {
        let Some(shown) = playing.lesson.steps.get(step) else { return };
        let seconds = if model.settings.reduce_motion { 0.0 } else { shown.seconds };
        let seen = model.as_seen();
        let from = Figure { observers: seen.observers, show: seen.show, ..model.desk.shown.figure().clone() };
        let from = Arc::new(from);
        let to = Arc::new(document.figure().clone());
        playing.step = step;
        playing.warned = None;
        playing.looked_at = None;
        playing.shows_question = !model.settings.presentation;
        let question = match &shown.task {
            Some(Task::Question(entry)) => Some((**entry).clone()),
            _ => None,
        };
        let exercise = match &shown.task {
            Some(Task::Exercise { id, seed }) => Some(Chosen { id: id.clone(), seed: *seed }),
            _ => None,
        };
        // The pictures and the text have the room. For a try, its panel is open: the operations, or else the numbers of
        // the camera.
        let goal = if let Some(Task::Try(goal)) = &shown.task { Some(goal) } else { None };
        let operates =
            goal.is_some_and(|goal| goal.way.iter().any(|(key, _)| Operation::names().contains(&key.as_str())));
        let tries = goal.is_some();
        self.take_over(model, document.clone());
        model.desk.play_lesson();
        // Its author chooses them.
        if playing.writing.is_none() {
            model.settings.panels.wanted = [tries && !operates, operates, model.settings.panels.wanted[2]];
        }
        if let Some(entry) = question {
            self.exercises.work_on(Chosen { id: entry.id.clone().into_owned(), seed: 0 });
            self.exercises.of_lesson = vec![entry];
        }
        if let Some(chosen) = exercise {
            self.exercises.work_on(chosen);
            model.show_explanation(crate::figure::Explanation::Exercises);
        }
        let passage = Passage::new(from, to);
        if moves && seconds > 0.0 && !passage.is_at_once() {
            // New parts fade in, then the camera moves.
            playing.fades += 1;
            playing.moving = Some(Moving { passage, target: Box::new(document), seconds, began: None });
        }
        if playing.counts() {
            let furthest = self.taken.entry(playing.lesson.id.clone()).or_default();
            *furthest = step.max(*furthest);
            self.stopped = Some((playing.lesson.id.clone(), step));
        }
        self.lesson = Some(playing);
        self.follow_writing();
        if self.waits_for_seen() {
            self.show_seen(model);
        }
    }

    /// True for a question with a guess but without an answer, which asks about the figure that was shown.
    fn waits_for_seen(&self) -> bool {
        let step = self.lesson.as_ref().filter(|playing| playing.writing.is_none()).and_then(Playing::now);
        let Some(Task::Question(entry)) = step.and_then(|step| step.task.as_ref()) else { return false };
        let right = self.exercises.right();
        let asks = entry.exercise(0, &Default::default()).asks;
        let waits =
            |ask: &crate::exercises::Ask| self.exercises.guess_at(ask).is_some() && !right.contains(ask.name.as_str());
        asks.iter().any(|ask| !ask.places && waits(ask))
    }

    /// Shows the figure that answers the question of the step, with a move to it. Returns false if there is none.
    pub(in crate::gui) fn show_seen(&mut self, model: &mut Model) -> bool {
        self.end_move(model);
        let Some(playing) = &self.lesson else { return false };
        let Some(seen) = playing.lesson.seen_after(playing.step).cloned() else { return false };
        let Ok(document) = Document::of_lesson(Figure::clone(&seen), playing.path.as_deref()) else { return false };
        self.leave_step(model);
        let Some(mut playing) = self.lesson.take() else { return false };
        let shown = model.as_seen();
        let from = Figure { observers: shown.observers, show: shown.show, ..model.desk.shown.figure().clone() };
        let passage = Passage::new(Arc::new(from), seen);
        // The question stays open under the other figure.
        let (of_lesson, open) = (std::mem::take(&mut self.exercises.of_lesson), self.exercises.open.take());
        self.take_over(model, document.clone());
        (self.exercises.of_lesson, self.exercises.open) = (of_lesson, open);
        if !model.settings.reduce_motion && !passage.is_at_once() {
            playing.fades += 1;
            playing.moving = Some(Moving { passage, target: Box::new(document), seconds: SEEN, began: None });
        }
        self.lesson = Some(playing);
        true
    }

    /// Notes the progress in the step.
    pub(in crate::gui) fn check_goal(&mut self, model: &Model) {
        let Some(mut playing) = self.lesson.take() else { return };
        let step = playing.step;
        let reached = match playing.now().and_then(|now| now.task.as_ref()) {
            _ if playing.is_done() || playing.moving.is_some() => false,
            Some(Task::Question(_) | Task::Exercise { .. }) => self.is_answered(&playing),
            Some(Task::Try(goal)) if !playing.has_looked_at(&model.desk.shown) => {
                // Once for each figure: pixels are counted.
                let subject = Subject {
                    figure: model.desk.shown.figure(),
                    camera: model.desk.shown.camera(),
                    scene: model.scene_cache.scene(),
                };
                let goal = goal.clone();
                // The scene of a step that has just begun is built after this.
                let is_ready = model.scene_cache.is_of(&model.desk.shown, model.settings.theme);
                if is_ready {
                    let Figure { observers, show, .. } = model.desk.shown.figure();
                    playing.looked_at = Some((model.desk.shown.version(), *observers, show.clone()));
                }
                is_ready && goal.is_reached(subject, &mut playing.seen)
            }
            Some(Task::Try(_)) | None => false,
        };
        if reached {
            playing.done.insert(step);
            if !playing.shown.contains(&step) && playing.counts() {
                self.done.entry(playing.lesson.id.clone()).or_default().insert(step);
            }
        }
        self.lesson = Some(playing);
    }

    /// True if every question of the step has its right answer.
    fn is_answered(&self, playing: &Playing) -> bool {
        let (id, seed) = match playing.now().and_then(|now| now.task.as_ref()) {
            Some(Task::Question(entry)) => (&*entry.id, 0),
            Some(Task::Exercise { id, seed }) => (id.as_str(), *seed),
            _ => return false,
        };
        let is_open = self.exercises.open.as_ref().is_some_and(|open| open.id == id && open.seed == seed);
        let asks = self.exercises.entry(id).map(|entry| entry.exercise(seed, &Default::default()).asks);
        is_open && asks.is_some_and(|asks| asks.iter().all(|ask| self.exercises.is_right(ask)))
    }
}
