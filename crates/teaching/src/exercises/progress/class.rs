//! The progress of a class: what its students solved, and which mistakes how many of them made.

use std::collections::{BTreeMap, BTreeSet};

use super::{Progress, ProgressError, Tried, date};
use crate::exercises::mistakes::mistake::Mistake;

/// The work of one student.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Student {
    /// By the identifiers of the exercises.
    pub exercises: BTreeMap<String, Work>,
    /// The codes of mistakes whose exercise isn't known, as in older tables.
    pub elsewhere: BTreeSet<String>,
    /// When an answer was last judged, as a date and a time of day in UTC. Later dates are greater texts.
    pub last: String,
}

/// The work of one student in an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// An answer was judged.
    pub tried: bool,
    /// It was solved.
    pub solved: bool,
    /// It was solved without help. False if that isn't known.
    pub alone: bool,
    /// The codes of the mistakes made in it, also of those that another version knows.
    pub mistakes: BTreeSet<String>,
}

/// The reason why a file holds no progress.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ClassError {
    /// Neither a progress file nor its table.
    #[error("holds no progress")]
    Foreign,
    /// A progress file that can't be read.
    #[error(transparent)]
    Progress(#[from] ProgressError),
    /// A cell of a table that isn't a whole number: the line, from 1, the column, and the text.
    #[error("line {line}: {column} is {text:?}; allowed: a whole number")]
    Cell {
        /// Counted from 1.
        line: u64,
        /// The heading of the column.
        column: &'static str,
        /// The text of the cell.
        text: String,
    },
    /// A table that breaks off or has rows of different lengths.
    #[error("{0}")]
    Table(String),
}

/// The progress of several students, by their names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Class {
    /// In the order of their names.
    pub students: BTreeMap<String, Student>,
}

/// How a class did in an exercise. Each number counts students.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Those who tried it.
    pub tried: usize,
    /// Those who solved it.
    pub solved: usize,
    /// Those who solved it without help.
    pub alone: usize,
    /// Those who made each mistake in it, by its code. The most frequent first.
    pub mistakes: Vec<(String, usize)>,
}

impl Class {
    /// Adds the students of a progress file or of its table. `name` is the name of a student whose file has none. Of
    /// two texts of one student, the one with the later work counts, and of two as late the later one added.
    ///
    /// # Errors
    /// [`ClassError`]. Nothing is added then.
    pub fn add(&mut self, name: &str, text: &str) -> Result<(), ClassError> {
        let text = text.trim_start_matches('\u{feff}');
        let heading = text.lines().next().unwrap_or_default().to_lowercase();
        let is_table = ["kind", "name", "solved"].iter().all(|column| heading.contains(column));
        let students = if is_table { of_table(name, text)? } else { of_progress(name, text)? };
        for (name, student) in students {
            match self.students.get(&name) {
                Some(known) if known.last > student.last => {}
                _ => drop(self.students.insert(name, student)),
            }
        }
        Ok(())
    }

    /// How the class did in each exercise that someone tried, in the order of `order` and then of the identifiers.
    pub fn exercises<'a>(&self, order: impl Iterator<Item = &'a str>) -> Vec<(String, Counts)> {
        let all: BTreeSet<&str> = self.works().map(|(id, _)| id).collect();
        let mut ids: Vec<&str> = order.filter_map(|id| all.get(id).copied()).collect();
        ids.extend(all.iter().filter(|id| !ids.contains(*id)).copied().collect::<Vec<_>>());
        let of = |id: &str| {
            let works: Vec<&Work> = self.works().filter(|(of, _)| *of == id).map(|(_, work)| work).collect();
            let count = |is: fn(&Work) -> bool| works.iter().filter(|work| is(work)).count();
            Counts {
                tried: count(|work| work.tried),
                solved: count(|work| work.solved),
                alone: count(|work| work.alone),
                mistakes: frequent(works.iter().flat_map(|work| &work.mistakes)),
            }
        };
        ids.into_iter().map(|id| (id.to_owned(), of(id))).collect()
    }

    /// The names of the students who tried an exercise: those who solved it without help, with help, and not yet.
    pub fn who(&self, id: &str) -> [Vec<&str>; 3] {
        let mut who = [const { Vec::new() }; 3];
        for (name, student) in &self.students {
            match student.exercises.get(id) {
                Some(Work { alone: true, .. }) => who[0].push(name.as_str()),
                Some(Work { solved: true, .. }) => who[1].push(name),
                Some(Work { tried: true, .. }) => who[2].push(name),
                _ => {}
            }
        }
        who
    }

    /// How many students made each mistake, in whatever exercise. The most frequent first.
    pub fn mistakes(&self) -> Vec<(String, usize)> {
        let of = |student: &Student| -> BTreeSet<String> {
            let made = student.exercises.values().flat_map(|work| &work.mistakes);
            made.chain(&student.elsewhere).cloned().collect()
        };
        let made: Vec<BTreeSet<String>> = self.students.values().map(of).collect();
        frequent(made.iter().flatten())
    }

    /// A table for spreadsheets: a row for each exercise, and one for each mistake in it.
    pub fn to_csv<'a>(&self, order: impl Iterator<Item = &'a str>) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let mut row = |cells: [&str; 6]| {
            // Writing to memory can't fail, and all rows have the same length.
            let _ = writer.write_record(cells);
        };
        row(["exercise", "tried", "solved", "alone", "mistake", "students"]);
        for (id, Counts { tried, solved, alone, mistakes }) in self.exercises(order) {
            let [tried, solved, alone] = [tried, solved, alone].map(|count| count.to_string());
            row([&id, &tried, &solved, &alone, "", ""]);
            mistakes.iter().for_each(|(code, count)| row([&id, "", "", "", code, &count.to_string()]));
        }
        String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
    }

    fn works(&self) -> impl Iterator<Item = (&str, &Work)> {
        self.students.values().flat_map(|student| student.exercises.iter().map(|(id, work)| (id.as_str(), work)))
    }
}

/// Codes with the number of times that they come, the most frequent first.
fn frequent<'a>(codes: impl Iterator<Item = &'a String>) -> Vec<(String, usize)> {
    let mut counts = BTreeMap::<&String, usize>::new();
    codes.for_each(|code| *counts.entry(code).or_default() += 1);
    let mut counts: Vec<(String, usize)> = counts.into_iter().map(|(code, count)| (code.clone(), count)).collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts
}

fn of_progress(name: &str, text: &str) -> Result<Vec<(String, Student)>, ClassError> {
    if !["exercise", "mistake", "guess"].iter().any(|table| text.contains(&format!("[{table}"))) {
        return Err(ClassError::Foreign);
    }
    let progress = Progress::read(text)?;
    if progress.is_empty() {
        return Err(ClassError::Foreign);
    }
    let mut student = Student::default();
    for (id, tried) in &progress.exercises {
        let Tried { tries, solved, alone, last, .. } = tried;
        let mistakes = tried.made.iter().map(|mistake| mistake.code().to_owned()).collect();
        let work = Work { tried: *tries > 0 || *solved > 0, solved: *solved > 0, alone: *alone > 0, mistakes };
        student.exercises.insert(id.clone(), work);
        student.last = student.last.max(last.map(date).unwrap_or_default());
    }
    // Files of before know only the exercise in which a mistake was last made.
    for (mistake, made) in progress.mistakes() {
        match student.exercises.get_mut(&made.exercise) {
            Some(work) => drop(work.mistakes.insert(mistake.code().to_owned())),
            None => drop(student.elsewhere.insert(mistake.code().to_owned())),
        }
    }
    let named = progress.student.filter(|name| !name.trim().is_empty());
    let name = named.unwrap_or_else(|| name.to_owned());
    Ok(vec![(name, student)])
}

/// A table as [`Progress::to_csv`] writes it, or as a spreadsheet saves that again: with semicolons or tabulators,
/// with its columns in another order, or with several students in it.
fn of_table(name: &str, text: &str) -> Result<Vec<(String, Student)>, ClassError> {
    let first = text.lines().next().unwrap_or_default();
    let separator =
        [b',', b';', b'\t'].into_iter().max_by_key(|separator| first.matches(char::from(*separator)).count());
    let mut reader =
        csv::ReaderBuilder::new().delimiter(separator.unwrap_or(b',')).flexible(true).from_reader(text.as_bytes());
    let broken = |error: &csv::Error| ClassError::Table(error.to_string());
    let headings = reader.headers().map_err(|error| broken(&error))?.clone();
    let column = |name: &str| headings.iter().position(|heading| heading.trim().eq_ignore_ascii_case(name));
    let (Some(_), Some(_), Some(_)) = (column("kind"), column("name"), column("solved")) else {
        return Err(ClassError::Foreign);
    };
    let mut students = BTreeMap::<String, Student>::new();
    for record in reader.records() {
        let record = record.map_err(|error| broken(&error))?;
        let line = record.position().map_or(0, csv::Position::line);
        let cell = |name: &str| column(name).and_then(|at| record.get(at)).unwrap_or_default().trim();
        let count = |column: &'static str| match cell(column) {
            "" => Ok(0),
            text => text.parse::<u32>().map_err(|_| ClassError::Cell { line, column, text: text.to_owned() }),
        };
        let owner = Some(cell("student")).filter(|name| !name.is_empty()).unwrap_or(name);
        let student = students.entry(owner.to_owned()).or_default();
        student.last = student.last.clone().max(cell("last").to_owned());
        let (tries, solved, alone) = (count("tries")?, count("solved")?, count("alone")?);
        match (cell("kind"), cell("exercise")) {
            ("exercise", _) => {
                let work = student.exercises.entry(cell("name").to_owned()).or_default();
                (work.tried, work.solved, work.alone) = (tries > 0 || solved > 0, solved > 0, alone > 0);
            }
            ("mistake", "") => drop(student.elsewhere.insert(cell("name").to_owned())),
            ("mistake", id) => {
                student.exercises.entry(id.to_owned()).or_default().mistakes.insert(cell("name").to_owned());
            }
            _ => {}
        }
    }
    if students.is_empty() {
        return Err(ClassError::Foreign);
    }
    Ok(students.into_iter().collect())
}

/// The mistakes of a class to discuss: the most frequent of those that aren't slips of the pen, at most three.
pub fn to_discuss(mistakes: &[(String, usize)]) -> Vec<Mistake> {
    let known = mistakes.iter().filter_map(|(code, _)| Mistake::of_code(code));
    known.filter(|mistake| mistake.is_misconception()).take(3).collect()
}
