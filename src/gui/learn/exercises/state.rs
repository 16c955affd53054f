//! The exercises in the window: the choice, typed answers, and verdicts.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui;

use crate::camera::{Camera, RecoveryError};
use crate::exercises::{self, Answer, Ask, Entry, Exercise, Free, Guess, Judged, Kind, Progress, Stage, Why, Worked};
use crate::expression::{Dimension, evaluate};
use camera_lab_desk::{Mark, Placing};
use camera_lab_files::{self as files, FileError, OwnExercises};

/// An exercise with the numbers of a seed.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Chosen {
    /// The identifier of the exercise or of its family.
    pub id: String,
    /// The source of its numbers. 0 if they are those of the notes.
    pub seed: u64,
}

/// The typed answers of an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Typed {
    /// The fields by the name of the ask, row by row. One for a number, a choice or a camera.
    pub answers: BTreeMap<String, Vec<String>>,
    /// Numbers that the source leaves open, by their names.
    pub free: BTreeMap<String, String>,
    /// The answers judged as they are here, by the names of the asks. Their verdicts are computed again, not stored.
    pub judged: BTreeSet<String>,
    /// The guesses at questions of lessons, which can't be changed, by the names of the asks. Fields as for answers.
    pub guesses: BTreeMap<String, Vec<String>>,
}

impl Typed {
    /// True if all fields are empty.
    pub fn is_empty(&self) -> bool {
        let fields = self.answers.values().chain(self.guesses.values());
        let mut all = fields.flatten().chain(self.free.values());
        all.all(|text| text.trim().is_empty())
    }

    /// The numbers chosen for values that the source leaves open. Texts that aren't numbers are left out.
    pub fn chosen_numbers(&self) -> Free {
        let number = |text: &String| evaluate(text, Dimension::Number).ok().filter(|value| *value > 0.0);
        self.free.iter().filter_map(|(name, text)| Some((name.clone(), number(text)?))).collect()
    }
}

/// The two numbers in the fields of a place.
fn place_in(ask: &Ask, fields: &[String]) -> Option<[f64; 2]> {
    match exercises::read_answer(&joined(ask, fields), ask, &[]).ok()? {
        Answer::Numbers { entries, .. } => match entries[..] {
            [Some(x), Some(y)] => Some([x, y]),
            _ => None,
        },
        Answer::Choice(_) | Answer::Camera(_) => None,
    }
}

/// A record of progress in a window. Files are written from records, so that two windows lose nothing of each other.
#[derive(Clone, Debug)]
pub(in crate::gui) enum Done {
    /// An answer was judged, at a time in seconds since the beginning of 1970.
    Judged(Arc<Exercise>, Box<Judged>, u64),
    /// The number of open hints and worked steps of an ask.
    Opened { id: String, seed: u64, ask: String, hints: u32 },
    /// The last steps of a solution with this number of steps were done, or weren't.
    Stepped { id: String, seed: u64, ask: String, steps: u32, right: bool },
    /// The user chose other numbers for values that the notes leave open.
    NumbersChanged(String),
    /// Solved before there was a file of progress.
    WasSolved(String),
    /// A guess at a question of a lesson.
    Guessed(String, Guess),
    /// The student's name.
    Named(String),
}

impl Done {
    /// Notes it.
    pub(in crate::gui) fn note(&self, progress: &mut Progress) {
        match self {
            Self::Judged(exercise, judged, now) => progress.judged(exercise, judged, *now),
            Self::Opened { id, seed, ask, hints } => progress.opened(id, *seed, ask, *hints),
            Self::Stepped { id, seed, ask, steps, right } => progress.stepped(id, *seed, ask, *steps, *right),
            Self::NumbersChanged(id) => progress.numbers_changed(id),
            Self::WasSolved(id) => progress.was_solved(id),
            Self::Guessed(id, guess) => progress.guessed(id, guess.clone()),
            Self::Named(name) => progress.student = Some(name.clone()).filter(|name| !name.is_empty()),
        }
    }
}

/// The verdict on an answer.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The fields as they were judged.
    pub fields: Vec<String>,
    /// The verdict.
    pub judged: Judged,
}

/// The open part of the help for an answer.
#[derive(Clone, Debug, Default)]
pub struct Opened {
    /// Number of hints.
    pub hints: usize,
    /// Number of worked steps.
    pub steps: usize,
    /// The whole solution, once a step was requested.
    pub(in crate::gui) way: Option<Arc<[Worked]>>,
    /// Number of its given steps. The others are to be done.
    pub given: usize,
    /// The texts typed into the steps to be done, by their numbers.
    pub typed: BTreeMap<usize, String>,
    /// The steps that the user has done, or has been shown in the end.
    pub filled: BTreeSet<usize>,
    /// The step whose last number was wrong.
    pub(in crate::gui) missed: Option<usize>,
}

impl Opened {
    /// True if the whole solution is shown.
    pub fn is_at_end(&self) -> bool {
        let last = self.steps.checked_sub(1).filter(|last| !self.is_to_do(*last));
        last.is_some() && self.way.as_ref().is_some_and(|way| self.steps >= way.len())
    }

    /// True for a step that is still to be done.
    pub fn is_to_do(&self, step: usize) -> bool {
        step >= self.given && !self.filled.contains(&step)
    }
}

/// The camera that an answer describes, or the reason why there is none.
#[derive(Clone, Debug)]
pub struct Described {
    /// The ask that was answered.
    pub ask: String,
    /// The camera that the answer describes.
    pub camera: Result<Box<Camera>, NotCamera>,
}

/// The reason why an answer describes no camera.
#[derive(Clone, Debug, PartialEq)]
pub enum NotCamera {
    /// The entries of a matrix don't fit, or its camera is impossible.
    Matrix(RecoveryError),
    /// An axis has another length than 1.
    Length(f64),
    /// An axis isn't perpendicular to n. Holds their scalar product.
    Oblique(f64),
}

/// A folder of a lecturer's own exercises, as it was when opened.
#[derive(Debug)]
pub struct OwnFolder {
    /// The path of the folder.
    pub folder: PathBuf,
    /// Its content, or the reason why it can't be read.
    pub found: Result<OwnExercises, FileError>,
}

/// The exercises in the window.
#[derive(Clone, Debug, Default)]
pub struct Exercises {
    /// The search text of the list.
    pub wanted: String,
    /// The open exercise. `None` if the list is shown.
    pub open: Option<Chosen>,
    /// The typed answers of every exercise.
    pub typed: BTreeMap<Chosen, Typed>,
    /// The verdicts, of the current exercise.
    pub checked: BTreeMap<String, Checked>,
    /// The open help, of the current exercise.
    pub opened: BTreeMap<String, Opened>,
    /// The camera of an answer, shown beside the right one.
    pub described: Option<Described>,
    /// True if the exercises were opened in this window. A panel that was open at the start doesn't count.
    pub(in crate::gui) was_called: bool,
    /// The keyboard goes to the first control, which is the search field, or the way back to the list.
    pub(in crate::gui) calls_keyboard: bool,
    /// The next target of the focus: in the list an identifier, in an exercise the answer to the ask of this name.
    pub(in crate::gui) wants_focus: Option<String>,
    /// The ask with a new verdict or help, which is scrolled into sight within this number of frames.
    pub(in crate::gui) just_said: Option<(String, u8)>,
    /// The statement is brought into sight.
    pub(in crate::gui) just_opened: bool,
    /// The progress, in this window and others.
    pub progress: Progress,
    /// The file of the progress.
    pub file: Option<PathBuf>,
    /// Records that aren't in the file yet.
    pub(in crate::gui) unwritten: Vec<Done>,
    /// True if all of it is to be forgotten, and the file to be set aside.
    pub(in crate::gui) forgets: bool,
    /// The folder of a lecturer's own exercises.
    pub own: Option<Arc<OwnFolder>>,
    /// The exercise, the ask and whether it was right, of each answer and guess since the page around this one was
    /// last told. Empty outside a browser.
    pub(in crate::gui) answered: Vec<(Chosen, String, bool)>,
    /// The questions of the lesson being played, which are in no list.
    pub(in crate::gui) of_lesson: Vec<Entry>,
    /// True if the user is sure of the guess to be made, false if not. `None` until they say so.
    pub sure: Option<bool>,
    /// The reason why this exercise was chosen for practice next.
    pub(in crate::gui) why: Option<(Chosen, Why)>,
    /// The exercise as last built.
    made: Option<(Chosen, Free, Arc<Exercise>)>,
}

impl Exercises {
    /// All exercises: the built-in ones, and after them a lecturer's own.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        let found = self.own.as_ref().and_then(|own| own.found.as_ref().ok());
        exercises::with_own(found.map_or(&[], |found| &found.entries))
    }

    /// The exercise or family with an identifier.
    pub fn entry(&self, id: &str) -> Option<&Entry> {
        self.entries().chain(&self.of_lesson).find(|entry| entry.id == id).or_else(|| exercises::entry(id))
    }

    /// Reads a folder of a lecturer's own exercises. `None` removes it.
    pub fn look_into(&mut self, folder: Option<PathBuf>) {
        self.own = folder.map(|folder| Arc::new(OwnFolder { found: files::read_exercises(&folder), folder }));
        // A reread file may have other content.
        self.made = None;
        self.checked.clear();
        self.leave_unknown();
    }

    /// Shows the list if the open exercise is gone with its file, or with the lesson whose question it was.
    pub(in crate::gui) fn leave_unknown(&mut self) {
        if self.open.as_ref().is_some_and(|open| self.entry(&open.id).is_none()) {
            self.open = None;
            self.described = None;
        }
    }

    /// Has the keyboard come to them.
    pub(in crate::gui) const fn call(&mut self) {
        (self.was_called, self.calls_keyboard) = (true, true);
    }

    /// Gives the keyboard to their first control, once requested.
    pub(in crate::gui) fn answer_call(&mut self, first: &egui::Response) {
        // A menu that closes takes the keyboard back after its frame.
        if self.calls_keyboard && first.has_focus() {
            self.calls_keyboard = false;
        } else if self.calls_keyboard {
            first.request_focus();
            first.ctx.request_repaint();
        }
    }

    /// Marks an ask as having a new verdict or help.
    pub(in crate::gui) fn say(&mut self, ask: &Ask) {
        /// It's laid out in one frame, and its height is known in the next.
        const FRAMES: u8 = 2;
        self.just_said = Some((ask.name.clone(), FRAMES));
    }

    /// The name of the ask with a new verdict or help.
    pub(in crate::gui) fn take_said(&mut self, ctx: &egui::Context) -> Option<String> {
        let (name, frames) = self.just_said.take()?;
        ctx.request_repaint();
        if frames > 1 {
            self.just_said = Some((name.clone(), frames - 1));
        }
        Some(name)
    }

    /// Gives the focus to the widget requested by its name.
    pub(in crate::gui) fn give_focus(&mut self, name: &str, response: &egui::Response) {
        if self.wants_focus.as_deref() != Some(name) {
            return;
        }
        // A click elsewhere takes the keyboard away once more after its frame.
        if response.has_focus() {
            self.wants_focus = None;
        } else {
            response.request_focus();
            response.scroll_to_me(Some(egui::Align::Center));
            response.ctx.request_repaint();
        }
    }

    /// Opens an exercise. Its typed answers are restored.
    pub fn work_on(&mut self, chosen: Chosen) {
        if self.open.as_ref() == Some(&chosen) {
            return;
        }
        self.open = Some(chosen);
        self.made = None;
        self.checked.clear();
        self.opened.clear();
        (self.described, self.sure) = (None, None);
        self.wants_focus = None;
        self.just_opened = true;
    }

    /// The camera that an answer describes, in the form of a file.
    pub(in crate::gui) fn answered_camera(&self) -> Option<Camera> {
        self.described.as_ref()?.camera.as_deref().ok().map(Camera::rounded)
    }

    /// Works on a question that its author is writing. The keyboard stays in the author's field.
    pub(in crate::gui) fn preview(&mut self, entry: Entry) {
        self.work_on(Chosen { id: entry.id.clone().into_owned(), seed: 0 });
        self.of_lesson = vec![entry];
        (self.made, self.just_opened) = (None, false);
        self.checked.clear();
    }

    /// Shows the list, in which the former exercise takes the keyboard.
    pub fn leave(&mut self) {
        self.wants_focus = self.open.take().map(|chosen| chosen.id);
        self.described = None;
    }

    /// The open exercise, with the numbers chosen for it.
    pub(in crate::gui) fn exercise(&mut self) -> Option<(Entry, Arc<Exercise>)> {
        let chosen = self.open.clone()?;
        let entry = self.entry(&chosen.id)?.clone();
        let free = self.typed.get(&chosen).map(Typed::chosen_numbers).unwrap_or_default();
        let is_made = matches!(&self.made, Some((of, numbers, _)) if *of == chosen && *numbers == free);
        if !is_made {
            let exercise = entry.exercise(chosen.seed, &free);
            if self.made.as_ref().is_some_and(|(of, ..)| *of == chosen) {
                // With other numbers another answer is right.
                self.checked.clear();
                self.described = None;
                self.typed_now().judged.clear();
                self.note(Done::NumbersChanged(chosen.id.clone()));
            } else {
                self.judge_again(&entry, &exercise);
            }
            self.made = Some((chosen, free, Arc::new(exercise)));
        }
        let (_, _, exercise) = self.made.as_ref()?;
        Some((entry, Arc::clone(exercise)))
    }

    /// Judges the answers again that were judged before, which doesn't count as a new try.
    fn judge_again(&mut self, entry: &Entry, exercise: &Exercise) {
        let mut answers = Vec::new();
        for ask in &exercise.asks {
            let text = joined(ask, self.fields(ask));
            let was_judged = self.typed_now().judged.contains(&ask.name);
            let read = exercises::read_answer(&text, ask, &exercise.free).ok().filter(|_| was_judged);
            answers.extend(read.map(|answer| (ask.name.clone(), answer)));
        }
        for ask in exercise.asks.iter().flat_map(|ask| [Some(ask), ask.second.as_deref()]).flatten() {
            if !self.typed_now().judged.contains(&ask.name) {
                continue;
            }
            let fields = self.fields(ask).to_vec();
            // Another version of the program, or of a lecturer's exercise, may read it otherwise.
            if let Ok(judged) = exercises::check_beside(entry, exercise, ask, &joined(ask, &fields), &answers) {
                self.checked.insert(ask.name.clone(), Checked { fields, judged });
            }
        }
    }

    /// The fields of an ask.
    pub(in crate::gui) fn fields(&mut self, ask: &Ask) -> &[String] {
        let [rows, columns] = ask.shape();
        let fields = self.typed_now().answers.entry(ask.name.clone()).or_default();
        fields.resize(rows * columns, String::new());
        fields
    }

    /// Types into the fields of an ask. The new answer isn't judged yet, and describes no camera.
    pub(in crate::gui) fn type_into(&mut self, ask: &Ask, fields: Vec<String>) {
        if *self.fields(ask) == fields {
            return;
        }
        let is_as_judged = self.checked.get(&ask.name).is_some_and(|checked| checked.fields == fields);
        let typed = self.typed_now();
        typed.answers.insert(ask.name.clone(), fields);
        if is_as_judged {
            typed.judged.insert(ask.name.clone());
        } else {
            typed.judged.remove(&ask.name);
        }
        if self.described.as_ref().is_some_and(|described| described.ask == ask.name) {
            self.described = None;
        }
    }

    /// True for a question of a lesson that asks for a guess first, before it shows the picture.
    pub fn asks_for_guess(&self, ask: &Ask) -> bool {
        let id = self.open.as_ref().map(|open| open.id.as_str());
        let is_of_lesson = self.of_lesson.iter().any(|entry| Some(&*entry.id) == id);
        is_of_lesson && ask.name != exercises::SECOND && (ask.places || matches!(ask.kind, Kind::Choice(_)))
    }

    /// The question for a place in the image, of the open exercise.
    pub(in crate::gui) fn placing(&mut self, hint: &'static str) -> Option<Placing> {
        let (_, exercise) = self.exercise()?;
        let first = exercise.asks.iter().find(|ask| ask.places)?;
        let ask = self.second_of(first).unwrap_or(first);
        let guess = self.guess_at(first).and_then(|fields| place_in(first, fields));
        let verdict = self.checked.get(&ask.name).map(|checked| checked.judged.right);
        // A wrong guess is no way to the right place: it's shown after the second try.
        let is_tried = self.checked.get(&ask.name).is_some_and(|checked| {
            checked.judged.right || ask.name == exercises::SECOND || self.guess_at(ask) != Some(&checked.fields)
        });
        let place = |ask: &Ask| ask.expected().table().filter(|_| is_tried)?.entries.try_into().ok();
        let right = place(first);
        let second = Some(ask).filter(|ask| ask.name == exercises::SECOND).and_then(place);
        Some(Placing {
            from: None,
            mark: place_in(ask, self.fields(ask)),
            guess,
            right,
            second,
            is_open: verdict != Some(true),
            hint,
            of: Mark::Ask(Box::new(ask.clone())),
        })
    }

    /// The second place to mark, if the guess at the first was wrong.
    pub fn second_of<'a>(&self, ask: &'a Ask) -> Option<&'a Ask> {
        let is_wrong = self.checked.get(&ask.name).is_some_and(|checked| !checked.judged.right);
        ask.second.as_deref().filter(|_| is_wrong && self.guess_at(ask).is_some())
    }

    /// True if the answer to a question is right, or the one to its second place.
    pub fn is_right(&self, ask: &Ask) -> bool {
        let is = |ask: &Ask| self.checked.get(&ask.name).is_some_and(|checked| checked.judged.right);
        is(ask) || ask.second.as_deref().is_some_and(is)
    }

    /// The guess at a question, once there is one.
    pub fn guess_at(&self, ask: &Ask) -> Option<&Vec<String>> {
        self.typed.get(self.open.as_ref()?)?.guesses.get(&ask.name)
    }

    /// Keeps the typed answer as the guess, which can't be changed. `now` is in seconds since the beginning of 1970.
    pub(in crate::gui) fn guess(&mut self, ask: &Ask, right: bool, now: u64) {
        let (fields, Some(open)) = (self.fields(ask).to_vec(), self.open.clone()) else { return };
        let said = joined(ask, &fields);
        self.typed_now().guesses.insert(ask.name.clone(), fields);
        self.note_answered(ask, right);
        let done = Done::Guessed(open.id, Guess { said, right, sure: self.sure.take(), at: now });
        done.note(&mut self.progress);
        self.unwritten.push(done);
    }

    /// Takes back the answers to the questions of a lesson, because users who open it again answer them again.
    pub fn ask_again(&mut self, questions: impl Iterator<Item = String>) {
        for id in questions {
            if self.open.as_ref().is_some_and(|open| open.id == id) {
                (self.open, self.described) = (None, None);
            }
            // An empty one is stored too.
            if let Some(typed) = self.typed.get_mut(&Chosen { id, seed: 0 }) {
                *typed = Typed::default();
            }
        }
    }

    /// The other judged answers, by the names of their questions.
    pub(in crate::gui) fn answers_beside(&self, ask: &Ask) -> Vec<(String, Answer)> {
        let others = self.checked.iter().filter(|(name, _)| **name != ask.name);
        others.map(|(name, checked)| (name.clone(), checked.judged.understood.clone())).collect()
    }

    /// Stores the verdict on an answer, and that it was judged.
    pub(in crate::gui) fn took(&mut self, ask: &Ask, checked: Checked) {
        self.note_answered(ask, checked.judged.right);
        self.typed_now().judged.insert(ask.name.clone());
        self.checked.insert(ask.name.clone(), checked);
    }

    fn note_answered(&mut self, ask: &Ask, right: bool) {
        if cfg!(target_arch = "wasm32") {
            self.answered.extend(self.open.clone().map(|open| (open, ask.name.clone(), right)));
        }
    }

    /// The typed answers of the current exercise.
    pub(in crate::gui) fn typed_now(&mut self) -> &mut Typed {
        self.typed.entry(self.open.clone().unwrap_or_default()).or_default()
    }

    /// The stage of an exercise or a family: that of its most advanced member.
    pub fn stage(&self, id: &str) -> Stage {
        match self.progress.stage(id) {
            Stage::Untouched if self.typed.iter().any(|(chosen, typed)| chosen.id == id && !typed.is_empty()) => {
                Stage::Begun
            }
            stage => stage,
        }
    }

    /// The seed for going on with a family: the greatest one used.
    pub fn seed_of(&self, entry: &Entry) -> u64 {
        let seeds = self.typed.iter().filter(|(chosen, typed)| chosen.id == entry.id && !typed.is_empty());
        seeds.map(|(chosen, _)| chosen.seed).max().unwrap_or_default()
    }

    /// The next exercise to practise, and the reason. Never the current one. `now` is in seconds since the beginning of
    /// 1970.
    pub fn next(&self, now: u64) -> Option<(Chosen, Why)> {
        let all = crate::lessons::in_order_of_lessons(self.entries());
        let next = self.next_of(&all, now).filter(|(chosen, _)| self.open.as_ref() != Some(chosen));
        next.or_else(|| {
            let is_open = |entry: &Entry| self.open.as_ref().is_some_and(|open| open.id == entry.id);
            self.next_of(&all.iter().copied().filter(|entry| !is_open(entry)).collect::<Vec<_>>(), now)
        })
    }

    /// Goes on with the next exercise to practise. Returns false if there is none.
    pub(in crate::gui) fn practise(&mut self) -> bool {
        let Some((next, why)) = self.next(crate::clock::seconds_since_1970()) else { return false };
        self.work_on(next.clone());
        self.why = Some((next, why));
        true
    }

    fn next_of(&self, entries: &[&Entry], now: u64) -> Option<(Chosen, Why)> {
        let next = self.progress.practise_after(entries.iter().copied(), now, crate::lessons::family_after)?;
        // An exercise with typed but unjudged answers is continued.
        let begun = entries.iter().find(|entry| entry.id == next.id && self.progress.tried(&next.id).is_none());
        let seed = begun.map_or(next.seed, |entry| self.seed_of(entry));
        Some((Chosen { id: next.id, seed }, next.why))
    }

    /// Records progress, for this window and for the file.
    pub(in crate::gui) fn note(&mut self, done: Done) {
        // Questions of lessons aren't exercises to practise.
        if self.of_lesson.iter().any(|entry| Some(&*entry.id) == self.open.as_ref().map(|open| &*open.id)) {
            return;
        }
        done.note(&mut self.progress);
        self.unwritten.push(done);
    }

    /// Records the number of open hints and worked steps of an ask.
    pub(in crate::gui) fn note_opened(&mut self, exercise: &Exercise, ask: &Ask) {
        let opened = self.opened.get(&ask.name).map_or(0, |opened| opened.hints + opened.steps);
        let hints = u32::try_from(opened).unwrap_or(u32::MAX);
        self.note(Done::Opened { id: exercise.id.clone(), seed: exercise.seed, ask: ask.name.clone(), hints });
    }

    /// Records that the last steps of the solution to an ask were done, or weren't.
    pub(in crate::gui) fn note_stepped(&mut self, exercise: &Exercise, ask: &Ask, right: bool) {
        let steps = self.opened.get(&ask.name).and_then(|opened| opened.way.as_ref()).map_or(0, |way| way.len());
        let steps = u32::try_from(steps).unwrap_or(u32::MAX);
        self.note(Done::Stepped { id: exercise.id.clone(), seed: exercise.seed, ask: ask.name.clone(), steps, right });
    }

    /// Deletes all progress and all typed answers.
    pub(in crate::gui) fn forget(&mut self) {
        let Self { wanted, open, made, file, own, was_called, .. } = std::mem::take(self);
        *self = Self { wanted, open, made, file, own, was_called, ..Self::default() };
    }

    /// The names of the asks with right answers.
    pub fn right(&self) -> BTreeSet<&str> {
        self.checked.iter().filter(|(_, checked)| checked.judged.right).map(|(name, _)| name.as_str()).collect()
    }
}

/// The answer in the fields, as one text. Empty if all fields are. If the first field holds a whole list or matrix in
/// brackets, that's the answer.
pub fn joined(ask: &Ask, fields: &[String]) -> String {
    let first = fields.first().map_or("", |field| field.trim());
    if fields.iter().all(|field| field.trim().is_empty()) {
        return String::new();
    }
    if is_whole(ask, fields) {
        return first.to_owned();
    }
    let list = |fields: &[String]| {
        let parts: Vec<&str> = fields.iter().map(|field| if field.trim().is_empty() { "?" } else { field }).collect();
        format!("[{}]", parts.join("; "))
    };
    match ask.kind {
        Kind::Number | Kind::Choice(_) | Kind::Camera => first.to_owned(),
        Kind::Vector(_) => list(fields),
        Kind::Matrix(_, columns) => {
            format!("[{}]", fields.chunks(columns.max(1)).map(list).collect::<Vec<_>>().join("; "))
        }
    }
}

/// True if the first field holds a whole list or matrix, in brackets, or as a list of the required count while the
/// other fields are empty. Two numbers may be one with a decimal comma.
pub fn is_whole(ask: &Ask, fields: &[String]) -> bool {
    let first = fields.first().map_or("", |field| field.trim());
    let alone = fields.iter().skip(1).all(|field| field.trim().is_empty());
    let as_many = |rows: usize| {
        let count = crate::expression::parts(first).count();
        count == rows && (count > 2 || first.contains(';'))
    };
    match ask.kind {
        Kind::Vector(rows) => first.starts_with('[') || (alone && as_many(rows)),
        Kind::Matrix(..) => first.starts_with('['),
        Kind::Number | Kind::Choice(_) | Kind::Camera => false,
    }
}

#[cfg(test)]
mod tests;
