//! The tab of exercises: what is chosen, what was typed, and what became of it.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::camera::{Camera, RecoveryError};
use crate::exercises::{self, Ask, Entry, Exercise, Free, Judged, Kind, Worked};
use crate::expression::{Dimension, evaluate};

/// An exercise with the numbers of a seed.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Chosen {
    /// The identifier of the exercise or of its family.
    pub id: String,
    /// What its numbers come from; 0 where they are those of the notes.
    pub seed: u64,
}

/// How far an exercise is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Nothing was typed.
    Untouched,
    /// Something was typed.
    Begun,
    /// All that is asked was answered rightly.
    Solved,
}

/// What was typed for an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Typed {
    /// By the name of what is asked: the fields, row by row; one for a number, a choice or a camera.
    pub answers: BTreeMap<String, Vec<String>>,
    /// Numbers that the source leaves open, by their names.
    pub free: BTreeMap<String, String>,
    /// All that is asked was answered rightly once.
    pub solved: bool,
}

impl Typed {
    /// True where nothing was typed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let all = self.answers.values().flatten().chain(self.free.values());
        !self.solved && all.into_iter().all(|text| text.trim().is_empty())
    }

    /// The numbers that were chosen where the source leaves them open; what is not a number is left out.
    #[must_use]
    pub fn chosen_numbers(&self) -> Free {
        let number = |text: &String| evaluate(text, Dimension::Number).ok().filter(|value| *value > 0.0);
        self.free.iter().filter_map(|(name, text)| Some((name.clone(), number(text)?))).collect()
    }
}

/// What became of an answer.
#[derive(Clone, Debug)]
pub struct Checked {
    /// The fields as they were judged.
    pub fields: Vec<String>,
    /// What was said.
    pub judged: Judged,
}

/// What is open of the way to an answer.
#[derive(Clone, Debug, Default)]
pub struct Opened {
    /// How many hints.
    pub hints: usize,
    /// How many worked steps.
    pub steps: usize,
    /// The whole way, once a step was asked for.
    pub(in crate::gui) way: Option<Arc<[Worked]>>,
}

/// The camera that an answer describes, or why there is none.
#[derive(Clone, Debug)]
pub struct Described {
    /// The ask that was answered.
    pub ask: String,
    /// What it describes.
    pub camera: Result<Box<Camera>, RecoveryError>,
}

/// The tab of exercises.
#[derive(Clone, Debug, Default)]
pub struct Exercises {
    /// What is searched for in the list.
    pub wanted: String,
    /// The exercise that is worked on; `None`: the list is shown.
    pub open: Option<Chosen>,
    /// What was typed, for every exercise.
    pub typed: BTreeMap<Chosen, Typed>,
    /// What was checked, of the exercise that is worked on.
    pub checked: BTreeMap<String, Checked>,
    /// What is open of the ways, of the exercise that is worked on.
    pub opened: BTreeMap<String, Opened>,
    /// The camera of an answer that is shown beside the right one.
    pub described: Option<Described>,
    /// Where the keyboard goes next in the list: an identifier.
    pub(in crate::gui) wants_focus: Option<String>,
    /// The statement is brought into sight.
    pub(in crate::gui) just_opened: bool,
    /// The exercise as it was made last.
    made: Option<(Chosen, Free, Arc<Exercise>)>,
}

impl Exercises {
    /// Works on an exercise; what was typed for it before is there again.
    pub fn work_on(&mut self, chosen: Chosen) {
        if self.open.as_ref() == Some(&chosen) {
            return;
        }
        self.open = Some(chosen);
        self.checked.clear();
        self.opened.clear();
        self.described = None;
        self.just_opened = true;
    }

    /// Shows the list, where the exercise that was worked on takes the keyboard.
    pub fn leave(&mut self) {
        self.wants_focus = self.open.take().map(|chosen| chosen.id);
        self.described = None;
    }

    /// The exercise that is worked on, with the numbers that were chosen for it.
    pub(in crate::gui) fn exercise(&mut self) -> Option<(&'static Entry, Arc<Exercise>)> {
        let chosen = self.open.clone()?;
        let entry = exercises::entry(&chosen.id)?;
        let free = self.typed.get(&chosen).map(Typed::chosen_numbers).unwrap_or_default();
        let is_made = matches!(&self.made, Some((of, numbers, _)) if *of == chosen && *numbers == free);
        if !is_made {
            let exercise = entry.exercise(chosen.seed, &free);
            if self.made.as_ref().is_some_and(|(of, ..)| *of == chosen) {
                // With other numbers another answer is right.
                self.checked.clear();
            }
            self.made = Some((chosen, free, Arc::new(exercise)));
        }
        self.made.as_ref().map(|(_, _, exercise)| (entry, Arc::clone(exercise)))
    }

    /// The fields of what is asked, to be typed into.
    pub(in crate::gui) fn fields(&mut self, ask: &Ask) -> &mut Vec<String> {
        let chosen = self.open.clone().unwrap_or_default();
        let [rows, columns] = ask.shape();
        let fields = self.typed.entry(chosen).or_default().answers.entry(ask.name.clone()).or_default();
        fields.resize(rows * columns, String::new());
        fields
    }

    /// What was typed for the exercise that is worked on.
    pub(in crate::gui) fn typed_now(&mut self) -> &mut Typed {
        self.typed.entry(self.open.clone().unwrap_or_default()).or_default()
    }

    /// How far an exercise or a family is: as far as the one of it that is farthest.
    #[must_use]
    pub fn standing(&self, id: &str) -> Standing {
        let of = self.typed.iter().filter(|(chosen, typed)| chosen.id == id && !typed.is_empty());
        let (mut any, mut solved) = (false, false);
        for (_, typed) in of {
            (any, solved) = (true, solved || typed.solved);
        }
        match (solved, any) {
            (true, _) => Standing::Solved,
            (false, true) => Standing::Begun,
            (false, false) => Standing::Untouched,
        }
    }

    /// The seed with which a family is gone on with: the greatest that was worked on.
    #[must_use]
    pub fn seed_of(&self, entry: &Entry) -> u64 {
        let seeds = self.typed.iter().filter(|(chosen, typed)| chosen.id == entry.id && !typed.is_empty());
        seeds.map(|(chosen, _)| chosen.seed).max().unwrap_or(u64::from(entry.is_family))
    }

    /// What is practised next: what is begun, else what is untouched, in the order of the list; once all is solved, new numbers of the
    /// families, those first that were practised least.
    #[must_use]
    pub fn next(&self) -> Option<Chosen> {
        let others = || exercises::entries().filter(|entry| self.open.as_ref().is_none_or(|open| open.id != entry.id));
        let first = |wanted| others().find(|entry| self.standing(&entry.id) == wanted);
        if let Some(entry) = first(Standing::Begun).or_else(|| first(Standing::Untouched)) {
            return Some(Chosen { id: entry.id.clone().into_owned(), seed: self.seed_of(entry) });
        }
        let least = others().filter(|entry| entry.is_family).min_by_key(|entry| self.seed_of(entry))?;
        Some(Chosen { id: least.id.clone().into_owned(), seed: self.seed_of(least) + 1 })
    }

    /// Notes that all that is asked is answered rightly, where it is.
    pub(in crate::gui) fn note_solved(&mut self, exercise: &Exercise) {
        let right = |ask: &Ask| self.checked.get(&ask.name).is_some_and(|checked| checked.judged.right);
        if exercise.asks.iter().all(right) {
            self.typed_now().solved = true;
        }
    }

    /// The names of what is answered rightly.
    #[must_use]
    pub fn right(&self) -> BTreeSet<&str> {
        self.checked.iter().filter(|(_, checked)| checked.judged.right).map(|(name, _)| name.as_str()).collect()
    }
}

/// The answer that stands in fields, as one text; empty where nothing was typed. Where the first field holds a whole list or matrix in brackets, it
/// is the answer.
#[must_use]
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

/// True where the first field holds a whole list or matrix in brackets.
#[must_use]
pub fn is_whole(ask: &Ask, fields: &[String]) -> bool {
    let first = fields.first().map_or("", |field| field.trim());
    matches!(ask.kind, Kind::Vector(_) | Kind::Matrix(..)) && first.starts_with('[')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed(text: &str) -> Typed {
        let answers = [("u".to_owned(), vec![text.to_owned()])].into();
        Typed { answers, ..Typed::default() }
    }

    #[test]
    fn what_was_begun_is_practised_next_then_what_is_untouched_then_new_numbers() {
        let mut state = Exercises::default();
        let all: Vec<&Entry> = exercises::entries().collect();
        assert_eq!(state.next().map(|next| next.id), Some(all[0].id.clone().into_owned()));
        let basis = Chosen { id: "basis".to_owned(), seed: 7 };
        state.typed.insert(basis.clone(), typed("1"));
        assert_eq!(state.next(), Some(basis.clone()));
        state.typed.insert(basis.clone(), typed(" "));
        assert_eq!(state.standing("basis"), Standing::Untouched);
        for entry in &all {
            let chosen = Chosen { id: entry.id.clone().into_owned(), seed: u64::from(entry.is_family) };
            state.typed.insert(chosen, Typed { solved: true, ..typed("1") });
        }
        state.typed.insert(basis, Typed { solved: true, ..typed("1") });
        let next = state.next();
        assert!(next.is_some_and(|next| next.seed == 2 && next.id != "basis"));
    }

    #[test]
    fn fields_are_joined_to_what_is_read_and_brackets_in_the_first_one_are_the_whole() {
        let chosen = Chosen { id: "view-matrix".to_owned(), seed: 1 };
        let mut state = Exercises { open: Some(chosen), ..Exercises::default() };
        let exercise = state.exercise().map(|(_, exercise)| exercise);
        let ask = exercise.iter().flat_map(|e| &e.asks).find(|ask| ask.kind == Kind::Matrix(4, 4));
        let Some(ask) = ask else { panic!("a matrix is asked for") };
        assert_eq!(joined(ask, state.fields(ask)), "");
        state.fields(ask)[5] = "0,5".to_owned();
        assert_eq!(joined(ask, state.fields(ask)), "[[?; ?; ?; ?]; [?; 0,5; ?; ?]; [?; ?; ?; ?]; [?; ?; ?; ?]]");
        state.fields(ask)[0] = " [[1, 2], [3, 4]]".to_owned();
        assert_eq!(joined(ask, state.fields(ask)), "[[1, 2], [3, 4]]");
    }
}
