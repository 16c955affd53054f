//! A student's progress per exercise and per known mistake, stored as a TOML text, and the choice of the next exercise.
//!
//! There's no clock here. Times are arguments, in seconds since the beginning of 1970 (UTC).

mod text;

pub mod class;

use std::collections::{BTreeMap, BTreeSet};

use toml_edit::DocumentMut;

use super::exercise::{Exercise, Expected};
use super::judge::Judged;
use super::{Entry, Free};
use crate::exercises::mistakes::mistake::Mistake;
use crate::exercises::mistakes::slip::{Cause, Slip, Slips};

/// The progress in all exercises. It has a text form, which is a file that the student can read and delete.
#[derive(Clone, Debug, Default)]
pub struct Progress {
    exercises: BTreeMap<String, Tried>,
    mistakes: BTreeMap<Mistake, Made>,
    guesses: BTreeMap<String, Guess>,
    /// The name of the student, for a lecturer who gets the file.
    pub student: Option<String>,
    /// The file as read, which keeps unknown keys.
    rest: DocumentMut,
}

/// The progress in an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tried {
    /// Number of answers judged, whatever their numbers.
    pub tries: u32,
    /// Number of complete right solutions, at most one for each seed.
    pub solved: u32,
    /// Number of these found without a hint or a worked step, with numbers for which none was ever opened.
    pub alone: u32,
    /// When it was last solved.
    pub solved_at: Option<u64>,
    /// The sources of numbers for which a hint or a worked step was opened.
    pub helped: BTreeSet<u64>,
    /// Number of wrong answers in a row, with the present numbers.
    pub wrong: u32,
    /// When an answer was last judged.
    pub last: Option<u64>,
    /// The present source of its numbers, which the following fields are about.
    pub seed: u64,
    /// Number of hints and worked steps opened, by the names of the asks.
    pub hints: BTreeMap<String, u32>,
    /// The asks with right answers so far.
    pub right: BTreeSet<String>,
    /// The number of steps at the end of its worked solutions that the student does.
    pub own_steps: u32,
    /// The asks whose steps the student has done, or failed to do.
    pub stepped: BTreeSet<String>,
    /// The mistakes made.
    pub mistakes: BTreeSet<Mistake>,
    /// The mistakes ever made, whatever the numbers.
    pub made: BTreeSet<Mistake>,
    /// All questions have been answered rightly.
    pub is_solved: bool,
}

/// The guess at a question of a lesson, before the picture that answers it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Guess {
    /// The answer as given.
    pub said: String,
    /// It was right.
    pub right: bool,
    /// The student was sure of it; `None` if they didn't say.
    pub sure: Option<bool>,
    /// When it was made, in seconds since the beginning of 1970.
    pub at: u64,
}

/// The record of a known mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Made {
    /// Number of times.
    pub times: u32,
    /// When it was last made.
    pub last: u64,
    /// The exercise in which it was last made.
    pub exercise: String,
    /// No exercise that reveals it has been solved without it since.
    pub is_open: bool,
}

/// The stage of an exercise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// No answer has been judged.
    Untouched,
    /// An answer has been judged.
    Begun,
    /// Solved, with these numbers or others.
    Solved,
    /// Solved without help, with new numbers.
    Alone,
}

/// Seconds of a day.
const DAY: u64 = 86_400;
/// Days after which a solved exercise comes back: after the first time, the second, the third, and from then on.
const DAYS: [u64; 4] = [1, 3, 7, 21];
/// Wrong answers in a row after which a lesson or other numbers help more than another try.
pub const MANY_WRONG: u32 = 3;

/// The next exercise to practise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Next {
    /// The identifier of the exercise.
    pub id: String,
    /// The seed of its numbers.
    pub seed: u64,
    /// The reason for this one.
    pub why: Why,
}

/// The reason why an exercise is next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// It practises a question of a lesson, to which a guess was wrong though the student was sure.
    Sure,
    /// It practises this mistake, which was made this many times, and more often than other open ones.
    Mistake(Mistake, u32),
    /// It was begun last, and isn't solved.
    Begun,
    /// It was solved this many days ago, and comes back.
    Due(u64),
    /// It practises a question of a lesson, to which a guess was wrong this many days ago.
    Guess(u64),
    /// The first unsolved one.
    NotSolved,
    /// All are solved. This one was tried least recently.
    LongestAgo,
}

/// An error of a text that isn't a progress file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProgressError {
    /// Not TOML.
    #[error("{0}")]
    Toml(String),
    /// A key with an impossible value.
    #[error("{0} cannot be read")]
    Value(String),
}

impl Progress {
    /// The progress in an exercise, if any.
    pub fn tried(&self, id: &str) -> Option<&Tried> {
        self.exercises.get(id)
    }

    /// The stage of an exercise.
    pub fn stage(&self, id: &str) -> Stage {
        match self.tried(id) {
            Some(tried) if tried.alone > 0 => Stage::Alone,
            Some(tried) if tried.solved > 0 => Stage::Solved,
            Some(tried) if tried.tries > 0 => Stage::Begun,
            _ => Stage::Untouched,
        }
    }

    /// The number of steps of a solution that are shown in full, which is all of them at first. The student does the
    /// others at the end: one more after each success, and one fewer after a failure.
    pub fn given_steps(&self, id: &str, steps: usize) -> usize {
        let own = self.tried(id).map_or(0, |tried| tried.own_steps);
        steps.saturating_sub(usize::try_from(own).unwrap_or(usize::MAX))
    }

    /// Records that the student has done the last steps of a solution with this number of steps to an ask, or has
    /// failed to. With the numbers of a seed, only the first time counts.
    pub fn stepped(&mut self, id: &str, seed: u64, ask: &str, steps: u32, right: bool) {
        if self.of(id).seed != seed {
            self.begin(id, seed);
        }
        let tried = self.of(id);
        if tried.stepped.insert(ask.to_owned()) {
            let least = tried.own_steps.min(steps);
            // A short solution says nothing about the longer ones of other asks.
            tried.own_steps =
                if right { tried.own_steps.max(least + u32::from(least < steps)) } else { least.saturating_sub(1) };
        }
    }

    /// The known mistakes made so far.
    pub fn mistakes(&self) -> impl Iterator<Item = (Mistake, &Made)> {
        self.mistakes.iter().map(|(mistake, made)| (*mistake, made))
    }

    /// The guesses at questions of lessons, by the identifiers of the questions.
    pub fn guesses(&self) -> impl Iterator<Item = (&str, &Guess)> {
        self.guesses.iter().map(|(id, guess)| (id.as_str(), guess))
    }

    /// Records a guess. Only the last guess at a question is kept.
    pub fn guessed(&mut self, id: &str, guess: Guess) {
        self.guesses.insert(id.to_owned(), guess);
    }

    /// True if there's no progress at all.
    pub fn is_empty(&self) -> bool {
        self.exercises.is_empty() && self.mistakes.is_empty() && self.guesses.is_empty()
    }

    /// Records the number of open hints and worked steps of an ask, with the numbers of a seed. The greatest number
    /// ever counts.
    pub fn opened(&mut self, id: &str, seed: u64, ask: &str, hints: u32) {
        if self.of(id).seed != seed {
            self.begin(id, seed);
        }
        let tried = self.of(id);
        let kept = tried.hints.entry(ask.to_owned()).or_default();
        *kept = hints.max(*kept);
        if *kept > 0 {
            tried.helped.insert(seed);
        }
    }

    /// Records other choices of numbers that the notes leave open. Other answers are right now.
    pub fn numbers_changed(&mut self, id: &str) {
        if let Some(tried) = self.exercises.get_mut(id) {
            tried.right.clear();
        }
    }

    /// Records that an exercise was solved before any other record of it.
    pub fn was_solved(&mut self, id: &str) {
        let kept = self.of(id);
        (kept.solved, kept.own_steps) = (kept.solved.max(1), kept.own_steps.max(1));
    }

    /// Begins the exercise again, with the numbers of a seed.
    pub fn begin(&mut self, id: &str, seed: u64) {
        let kept = self.of(id);
        let Tried { tries, solved, alone, solved_at, last, own_steps, .. } = *kept;
        let (helped, made) = (std::mem::take(&mut kept.helped), std::mem::take(&mut kept.made));
        *kept = Tried { seed, tries, solved, alone, solved_at, last, own_steps, helped, made, ..Tried::default() };
    }

    /// Records the judgement of an answer to an exercise at a time.
    pub fn judged(&mut self, exercise: &Exercise, judged: &Judged, now: u64) {
        if self.of(&exercise.id).seed != exercise.seed {
            self.begin(&exercise.id, exercise.seed);
        }
        let tried = self.exercises.entry(exercise.id.clone()).or_default();
        tried.tries = tried.tries.saturating_add(1);
        tried.last = Some(now);
        let is_wrong = !judged.right && judged.carried.is_empty();
        tried.wrong = if is_wrong { tried.wrong.saturating_add(1) } else { 0 };
        // If several give the same numbers, we can't know which was made.
        let known = judged.diagnosis.iter().filter(|diagnosis| diagnosis.others.is_empty());
        for Cause { mistake, .. } in known.flat_map(|diagnosis| &diagnosis.causes) {
            tried.mistakes.insert(*mistake);
            tried.made.insert(*mistake);
            let made = self.mistakes.entry(*mistake).or_insert_with(|| Made {
                times: 0,
                last: now,
                exercise: String::new(),
                is_open: true,
            });
            *made =
                Made { times: made.times.saturating_add(1), last: now, exercise: exercise.id.clone(), is_open: true };
        }
        if judged.right {
            tried.right.insert(judged.name.clone());
        } else {
            tried.right.remove(&judged.name);
        }
        if !tried.is_solved && exercise.asks.iter().all(|ask| tried.right.contains(&ask.name)) {
            tried.is_solved = true;
            tried.solved = tried.solved.saturating_add(1);
            tried.solved_at = Some(now);
            // Steps of one's own have counted already.
            tried.own_steps = tried.own_steps.saturating_add(u32::from(tried.stepped.is_empty()));
            if !tried.helped.contains(&tried.seed) {
                tried.alone = tried.alone.saturating_add(1);
            }
            let made_here = tried.mistakes.clone();
            for (mistake, made) in &mut self.mistakes {
                let could_be_made = made.exercise == exercise.id || exercise.shows(*mistake);
                made.is_open &= made_here.contains(mistake) || !could_be_made;
            }
        }
    }

    /// The next of these to practise. The first choice is a family that reveals the open mistake made most often.
    /// Otherwise it's the exercise begun last, or else the family that's most overdue to come back, or the first
    /// unsolved one in the order of `entries`, or the one tried least recently before `now`. A later time comes from a
    /// clock that ran ahead. Its true time is unknown, so it comes before the known ones. `None` if there are no
    /// entries.
    pub fn practise_next<'a>(&self, entries: impl IntoIterator<Item = &'a Entry>, now: u64) -> Option<Next> {
        self.next_of(&entries.into_iter().collect::<Vec<_>>(), now, |_| None)
    }

    fn next_of(&self, entries: &[&Entry], now: u64, family: fn(&str) -> Option<&'static str>) -> Option<Next> {
        let mut open: Vec<(Mistake, &Made)> =
            self.mistakes().filter(|(mistake, made)| made.is_open && mistake.is_misconception()).collect();
        open.sort_by_key(|(mistake, made)| (std::cmp::Reverse((made.times, made.last)), *mistake));
        for (mistake, made) in open {
            let families = || entries.iter().filter(|entry| entry.is_family);
            // The mistake can be made again in the same exercise; otherwise the first one that reveals it.
            let found = families().find(|entry| entry.id == made.exercise).or_else(|| {
                families().find(|entry| entry.exercise(self.next_seed(entry), &Free::new()).shows(mistake))
            });
            if let Some(entry) = found {
                return Some(self.next(entry, Why::Mistake(mistake, made.times)));
            }
        }
        let begun = entries.iter().filter(|entry| self.stage(&entry.id) == Stage::Begun);
        if let Some(entry) = begun.max_by_key(|entry| self.tried(&entry.id).and_then(|tried| tried.last)) {
            let seed = self.tried(&entry.id).map_or(0, |tried| tried.seed);
            return Some(Next { id: entry.id.clone().into_owned(), seed, why: Why::Begun });
        }
        let due = self.overdue(entries, now).map(|(entry, beyond, days)| (entry, beyond, Why::Due(days)));
        let guessed = self.guesses().filter_map(|(question, guess)| {
            let (beyond, days) = waited(guess.at, 1, now).filter(|_| !guess.right)?;
            let entry = self.after_question(entries, guess, family(question)?)?;
            Some((entry, beyond, Why::Guess(days)))
        });
        if let Some((entry, _, why)) = guessed.chain(due).max_by_key(|(_, beyond, _)| *beyond) {
            return Some(self.next(entry, why));
        }
        let is_solved = |entry: &Entry| matches!(self.stage(&entry.id), Stage::Solved | Stage::Alone);
        if let Some(entry) = entries.iter().find(|entry| !is_solved(entry)) {
            return Some(self.next(entry, Why::NotSolved));
        }
        let last = |entry: &&&Entry| self.tried(&entry.id).and_then(|tried| tried.last).filter(|last| *last <= now);
        entries.iter().min_by_key(last).map(|entry| self.next(entry, Why::LongestAgo))
    }

    /// The family that practises the last guess that was wrong though the student was sure, unless it has been solved
    /// since. `family` gives the family that comes after a question of a lesson.
    fn sure_and_wrong<'a>(&self, entries: &[&'a Entry], family: fn(&str) -> Option<&'static str>) -> Option<&'a Entry> {
        let mut wrong: Vec<(&str, &Guess)> =
            self.guesses().filter(|(_, guess)| guess.sure == Some(true) && !guess.right).collect();
        wrong.sort_by_key(|(_, guess)| std::cmp::Reverse(guess.at));
        wrong.into_iter().find_map(|(question, guess)| self.after_question(entries, guess, family(question)?).copied())
    }

    /// The family that practises the question of a guess, unless it has been solved since.
    fn after_question<'a, 'b>(&self, entries: &'b [&'a Entry], guess: &Guess, family: &str) -> Option<&'b &'a Entry> {
        let is_solved = self.tried(family).and_then(|tried| tried.solved_at).is_some_and(|at| at > guess.at);
        entries.iter().find(|entry| entry.id == family && !is_solved)
    }

    /// As [`practise_next`](Self::practise_next), but a mistake that the student was sure of comes first, and other
    /// wrong guesses come back from the next day on. `family` gives the family that comes after a question of a
    /// lesson.
    pub fn practise_after<'a>(
        &self,
        entries: impl IntoIterator<Item = &'a Entry>,
        now: u64,
        family: fn(&str) -> Option<&'static str>,
    ) -> Option<Next> {
        let entries: Vec<&Entry> = entries.into_iter().collect();
        match self.sure_and_wrong(&entries, family) {
            Some(entry) => Some(self.next(entry, Why::Sure)),
            None => self.next_of(&entries, now, family),
        }
    }

    /// The families that are due to come back, the most overdue first.
    pub fn due<'a>(&self, entries: impl IntoIterator<Item = &'a Entry>, now: u64) -> Vec<&'a Entry> {
        let entries: Vec<&Entry> = entries.into_iter().collect();
        let mut due: Vec<_> = self.overdue(&entries, now).map(|(entry, beyond, _)| (beyond, *entry)).collect();
        due.sort_by_key(|(beyond, _)| std::cmp::Reverse(*beyond));
        due.into_iter().map(|(_, entry)| entry).collect()
    }

    /// The families that are due, each with the seconds since then, and the days since it was solved.
    fn overdue<'a, 'b>(&self, entries: &'b [&'a Entry], now: u64) -> impl Iterator<Item = (&'b &'a Entry, u64, u64)> {
        entries.iter().filter(|entry| entry.is_family).filter_map(move |entry| {
            let (beyond, days) = self.waited(&entry.id, now)?;
            Some((entry, beyond, days))
        })
    }

    /// Seconds since the time at which a solved exercise comes back, and days since it was solved; `None` before that
    /// time, and for an exercise that isn't solved.
    fn waited(&self, id: &str, now: u64) -> Option<(u64, u64)> {
        let tried = self.tried(id).filter(|tried| tried.solved > 0)?;
        waited(tried.solved_at?, tried.solved, now)
    }

    fn next(&self, entry: &Entry, why: Why) -> Next {
        Next { id: entry.id.clone().into_owned(), seed: self.next_seed(entry), why }
    }

    /// A new seed if the present numbers are solved, or a mistake was made with them.
    fn next_seed(&self, entry: &Entry) -> u64 {
        match self.tried(&entry.id) {
            Some(tried) if entry.is_family && (tried.is_solved || !tried.mistakes.is_empty()) => {
                tried.seed.wrapping_add(1)
            }
            Some(tried) => tried.seed,
            None => 0,
        }
    }

    /// A table for spreadsheets: a row for each exercise, and one for each known mistake in each exercise.
    pub fn to_csv(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let student = self.student.as_deref().unwrap_or_default();
        let mut row = |cells: [&str; 11]| {
            // Writing to memory can't fail, and all rows have the same length.
            let _ = writer.write_record(cells);
        };
        row(["kind", "name", "tries", "solved", "last", "seed", "hints", "open", "alone", "exercise", "student"]);
        for (id, tried) in &self.exercises {
            let hints: u64 = tried.hints.values().map(|hints| u64::from(*hints)).sum();
            let [tries, solved, alone] = [tried.tries, tried.solved, tried.alone].map(|count| count.to_string());
            let (last, seed, hints) =
                (tried.last.map(date).unwrap_or_default(), tried.seed.to_string(), hints.to_string());
            row(["exercise", id, &tries, &solved, &last, &seed, &hints, "", &alone, "", student]);
        }
        for (mistake, made) in &self.mistakes {
            let (times, last, open) = (made.times.to_string(), date(made.last), made.is_open.to_string());
            row(["mistake", mistake.code(), &times, "", &last, "", "", &open, "", &made.exercise, student]);
            let others =
                self.exercises.iter().filter(|(id, tried)| **id != made.exercise && tried.made.contains(mistake));
            others.for_each(|(id, _)| row(["mistake", mistake.code(), "", "", "", "", "", "", "", id, student]));
        }
        for (id, guess) in &self.guesses {
            row(["guess", id, "1", if guess.right { "1" } else { "0" }, &date(guess.at), "", "", "", "", "", student]);
        }
        let bytes = writer.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }

    fn of(&mut self, id: &str) -> &mut Tried {
        self.exercises.entry(id.to_owned()).or_default()
    }
}

/// Seconds since something comes back for this time (from 1), and days since `at`; `None` before, and if `at` is yet to
/// come.
fn waited(at: u64, times: u32, now: u64) -> Option<(u64, u64)> {
    let times = usize::try_from(times).unwrap_or(DAYS.len()).clamp(1, DAYS.len());
    let since = now.checked_sub(at)?;
    Some((since.checked_sub(DAYS[times - 1] * DAY)?, since / DAY))
}

impl Mistake {
    /// True unless it's a slip of the pen, of the calculator or of the eye. Practice can mend it.
    pub const fn is_misconception(self) -> bool {
        !matches!(self, Self::ArithmeticSlip | Self::RoundedTooEarly | Self::WrongShape)
    }
}

impl Exercise {
    /// True if a known mistake, made in it, gives another answer than the right one.
    pub fn shows(&self, mistake: Mistake) -> bool {
        self.asks.iter().any(|ask| match ask.expected() {
            Expected::Choice(_, mistakes, _) => mistakes.iter().any(|(_, known)| *known == mistake),
            Expected::Camera(_, model, mistakes, _) => {
                mistakes.iter().any(|(wrong, known)| *known == mistake && wrong != &**model)
            }
            expected => expected.table().is_some_and(|right| {
                let slips = Slip::ALL.iter().filter(|slip| slip.mistake() == mistake);
                slips.filter_map(|slip| expected.slipped(Slips::one(*slip))).any(|wrong| {
                    let mut both = wrong.entries.iter().zip(&right.entries);
                    wrong.shape() == right.shape() && both.any(|(wrong, right)| !ask.accepts(Some(*wrong), *right))
                })
            }),
        })
    }
}

/// Seconds since the beginning of 1970 as a date and a time of day in UTC, in the Gregorian calendar.
fn date(seconds: u64) -> String {
    let (days, rest) = (seconds / 86_400, seconds % 86_400);
    // Years begin in March here, so that the leap day is their last; 400 of them are one cycle.
    let since = days + 719_468;
    let (cycle, day) = (since / 146_097, since % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let day = day - (153 * month + 2) / 5 + 1;
    let (year, month) = (cycle * 400 + year + u64::from(month > 9), if month > 9 { month - 9 } else { month + 3 });
    format!("{year:04}-{month:02}-{day:02}T{:02}:{:02}:{:02}Z", rest / 3600, rest / 60 % 60, rest % 60)
}

#[cfg(test)]
mod tests;
