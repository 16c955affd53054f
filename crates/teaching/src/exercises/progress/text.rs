//! Progress as the text of a file.

use std::collections::{BTreeMap, BTreeSet};

use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, TableLike, TomlError, Value, value};

use super::{Guess, Made, Progress, ProgressError, Tried};
use crate::exercises::Mistake;

impl Progress {
    /// Reads a text. Unknown keys stay in [`to_toml`](Self::to_toml).
    ///
    /// # Errors
    /// [`ProgressError`] if it isn't TOML, or a known key has an impossible value.
    pub fn read(source: &str) -> Result<Self, ProgressError> {
        let rest: DocumentMut =
            source.parse().map_err(|error: TomlError| ProgressError::Toml(error.message().to_owned()))?;
        let mut progress =
            Self { student: known(rest.as_table(), "student", text).map_err(ProgressError::Value)?, ..Self::default() };
        for (id, item) in table(&rest, "exercise")? {
            let tried = Tried::read(item).map_err(|key| ProgressError::Value(format!("exercise.{id}.{key}")))?;
            progress.exercises.insert(id.to_owned(), tried);
        }
        for (code, item) in table(&rest, "mistake")? {
            // A mistake from another version stays in the file.
            let Some(mistake) = Mistake::of_code(code) else { continue };
            let made = Made::read(item).map_err(|key| ProgressError::Value(format!("mistake.{code}.{key}")))?;
            progress.mistakes.insert(mistake, made);
        }
        for (id, item) in table(&rest, "guess")? {
            let guess = Guess::read(item).map_err(|key| ProgressError::Value(format!("guess.{id}.{key}")))?;
            progress.guesses.insert(id.to_owned(), guess);
        }
        Ok(Self { rest, ..progress })
    }

    /// The text for the file.
    pub fn to_toml(&self) -> String {
        let mut document = self.rest.clone();
        set(document.as_table_mut(), "student", self.student.as_deref().map(value));
        for (id, tried) in &self.exercises {
            if let Some(table) = entered(&mut document, "exercise", id) {
                tried.write(table);
            }
        }
        for (mistake, made) in &self.mistakes {
            if let Some(table) = entered(&mut document, "mistake", mistake.code()) {
                made.write(table);
            }
        }
        for (id, guess) in &self.guesses {
            if let Some(table) = entered(&mut document, "guess", id) {
                guess.write(table);
            }
        }
        document.to_string()
    }
}

/// The tables in a table of the file. Empty if it isn't there.
fn table<'a>(document: &'a DocumentMut, key: &str) -> Result<Vec<(&'a str, &'a dyn TableLike)>, ProgressError> {
    let Some(item) = document.get(key) else { return Ok(Vec::new()) };
    let tables = item.as_table_like().ok_or_else(|| ProgressError::Value(key.to_owned()))?;
    let table = |(name, item): (&'a str, &'a Item)| {
        let table = item.as_table_like().ok_or_else(|| ProgressError::Value(format!("{key}.{name}")))?;
        Ok((name, table))
    };
    tables.iter().map(table).collect()
}

/// The table of an entry, created if it doesn't exist. `None` means the key has another kind of value, which [`table`]
/// wouldn't have read.
fn entered<'a>(document: &'a mut DocumentMut, key: &str, name: &str) -> Option<&'a mut dyn TableLike> {
    let outer = document.entry(key).or_insert_with(|| {
        let mut table = Table::new();
        table.set_implicit(true);
        Item::Table(table)
    });
    let empty = if outer.is_table() { Item::Table(Table::new()) } else { value(InlineTable::new()) };
    outer.as_table_like_mut()?.entry(name).or_insert(empty).as_table_like_mut()
}

/// The value of a key that exists. The key itself is the error if its value has another kind.
fn known<T>(table: &dyn TableLike, key: &str, read: impl Fn(&Item) -> Option<T>) -> Result<Option<T>, String> {
    table.get(key).map(|item| read(item).ok_or_else(|| key.to_owned())).transpose()
}

fn count(item: &Item) -> Option<u32> {
    item.as_integer().and_then(|count| count.try_into().ok())
}

/// A whole number of 64 bits. Numbers too large for TOML are written as text.
fn long(item: &Item) -> Option<u64> {
    match item.as_integer() {
        Some(number) => number.try_into().ok(),
        None => item.as_str()?.parse().ok(),
    }
}

/// Whole numbers, each as text.
fn longs(item: &Item) -> Option<BTreeSet<u64>> {
    item.as_array()?.iter().map(|number| number.as_str()?.parse().ok()).collect()
}

fn long_item(number: u64) -> Item {
    i64::try_from(number).map_or_else(|_| value(number.to_string()), value)
}

fn by_name<T>(item: &Item, read: impl Fn(&Item) -> Option<T>) -> Option<BTreeMap<String, T>> {
    item.as_table_like()?.iter().map(|(name, item)| Some((name.to_owned(), read(item)?))).collect()
}

fn text(item: &Item) -> Option<String> {
    item.as_str().map(str::to_owned)
}

fn names(item: &Item) -> Option<BTreeSet<String>> {
    item.as_array()?.iter().map(|name| name.as_str().map(str::to_owned)).collect()
}

/// Sets a key, or removes it if there's no value.
fn set(table: &mut dyn TableLike, key: &str, item: Option<Item>) {
    match item {
        Some(item) => {
            table.insert(key, item);
        }
        None => {
            table.remove(key);
        }
    }
}

fn inline<T>(texts: &BTreeMap<String, T>, item: impl Fn(&T) -> Value) -> Option<Item> {
    let table: InlineTable = texts.iter().map(|(name, text)| (name.as_str(), item(text))).collect();
    (!texts.is_empty()).then(|| value(table))
}

fn list<'a>(names: impl Iterator<Item = &'a str>) -> Option<Item> {
    let list: Array = names.collect();
    (!list.is_empty()).then(|| value(list))
}

impl Tried {
    fn read(table: &dyn TableLike) -> Result<Self, String> {
        let codes = known(table, "mistakes", names)?.unwrap_or_default();
        let solved = known(table, "solved", count)?.unwrap_or_default();
        Ok(Self {
            tries: known(table, "tries", count)?.unwrap_or_default(),
            solved,
            // In files from before there was such a key, each solution counted.
            own_steps: known(table, "own_steps", count)?.unwrap_or(solved),
            stepped: known(table, "stepped", names)?.unwrap_or_default(),
            alone: known(table, "alone", count)?.unwrap_or_default(),
            solved_at: known(table, "solved_at", long)?,
            helped: known(table, "helped", longs)?.unwrap_or_default(),
            wrong: known(table, "wrong", count)?.unwrap_or_default(),
            last: known(table, "last", long)?,
            seed: known(table, "seed", long)?.unwrap_or_default(),
            hints: known(table, "hints", |item| by_name(item, count))?.unwrap_or_default(),
            right: known(table, "right", names)?.unwrap_or_default(),
            mistakes: codes.iter().filter_map(|code| Mistake::of_code(code)).collect(),
            made: known(table, "made", names)?.iter().flatten().filter_map(|code| Mistake::of_code(code)).collect(),
            is_solved: known(table, "is_solved", Item::as_bool)?.unwrap_or_default(),
        })
    }

    fn write(&self, table: &mut dyn TableLike) {
        set(table, "tries", (self.tries > 0).then(|| value(i64::from(self.tries))));
        set(table, "solved", (self.solved > 0).then(|| value(i64::from(self.solved))));
        set(table, "own_steps", (self.own_steps != self.solved).then(|| value(i64::from(self.own_steps))));
        set(table, "stepped", list(self.stepped.iter().map(String::as_str)));
        set(table, "alone", (self.alone > 0).then(|| value(i64::from(self.alone))));
        set(table, "solved_at", self.solved_at.map(long_item));
        let helped: Array = self.helped.iter().map(u64::to_string).collect();
        set(table, "helped", (!helped.is_empty()).then(|| value(helped)));
        set(table, "wrong", (self.wrong > 0).then(|| value(i64::from(self.wrong))));
        set(table, "last", self.last.map(long_item));
        set(table, "seed", Some(long_item(self.seed)));
        set(table, "hints", inline(&self.hints, |count| i64::from(*count).into()));
        set(table, "right", list(self.right.iter().map(String::as_str)));
        set(table, "mistakes", list(self.mistakes.iter().map(|mistake| mistake.code())));
        set(table, "made", list(self.made.iter().map(|mistake| mistake.code())));
        set(table, "is_solved", self.is_solved.then(|| value(true)));
    }
}

impl Made {
    fn read(table: &dyn TableLike) -> Result<Self, String> {
        Ok(Self {
            times: known(table, "times", count)?.unwrap_or_default(),
            last: known(table, "last", long)?.unwrap_or_default(),
            exercise: known(table, "exercise", text)?.unwrap_or_default(),
            is_open: known(table, "is_open", Item::as_bool)?.unwrap_or_default(),
        })
    }

    fn write(&self, table: &mut dyn TableLike) {
        set(table, "times", Some(value(i64::from(self.times))));
        set(table, "last", Some(long_item(self.last)));
        set(table, "exercise", Some(value(&self.exercise)));
        set(table, "is_open", Some(value(self.is_open)));
    }
}

impl Guess {
    fn read(table: &dyn TableLike) -> Result<Self, String> {
        Ok(Self {
            said: known(table, "said", text)?.unwrap_or_default(),
            right: known(table, "right", Item::as_bool)?.unwrap_or_default(),
            sure: known(table, "sure", Item::as_bool)?,
            at: known(table, "at", long)?.unwrap_or_default(),
        })
    }

    fn write(&self, table: &mut dyn TableLike) {
        set(table, "said", Some(value(&self.said)));
        set(table, "right", Some(value(self.right)));
        set(table, "sure", self.sure.map(value));
        set(table, "at", Some(long_item(self.at)));
    }
}
