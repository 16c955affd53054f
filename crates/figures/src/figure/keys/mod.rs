//! The keys of a figure file. Each has one row: a call with its name, its values and its field. One function per
//! section lists its rows, and the same rows read a text, write one, and name every key ([`KEYS`]).
//!
//! A row that reads leaves its field alone if the key is missing, so the figure holds the defaults before. Rows with
//! rules of their own ask for the section that's read ([`Keys::reading`]).

mod camera;
mod comparison;
mod labels;
mod scene;
mod sections;
mod show;

use std::sync::LazyLock;

use glam::{DVec2, DVec3};
use toml_edit::{ArrayOfTables, InlineTable, Item, Table, Value};

use super::error::Allowed;
use super::read::{Fault, Section, at_most};
use super::value::{PAIR, SWITCH, Values, quoted};
use super::words::{self, Words};
pub(super) use camera::{is_way_of_the_angle, remove_rivals};
pub(super) use comparison::checked;
pub(super) use scene::default_name;
pub(super) use sections::figure;

/// Every key of a figure file, `camera.near`, section by section.
pub static KEYS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let mut keys = Keys::new(Pass::List(Vec::new()));
    figure(&mut keys, &mut super::Figure::default());
    match keys.pass {
        Pass::List(paths) => paths,
        Pass::Read { .. } | Pass::Write(_) => Vec::new(),
    }
});

/// Shares, and depths of the viewport.
const UNIT: [f64; 2] = [0.0, 1.0];

/// Keys that several sections have, so the section says little about them in a wrong place.
const AMBIGUOUS: [&str; 4] = ["camera.name", "camera.color", "camera.height", "compare.camera"];

/// The section of a key in the wrong one, `[camera] near`.
pub(super) fn home(key: &str) -> Option<String> {
    let is_home = |path: &&String| {
        let mut names = path.split('.');
        let section = names.next();
        names.next() == Some(key)
            && !matches!(section, Some("cameras" | "points"))
            && !AMBIGUOUS.contains(&path.as_str())
    };
    let path = KEYS.iter().filter(|_| key.len() > 1).find(is_home)?;
    Some(format!("[{}] {key}", path.split('.').next()?))
}

/// The keys of a section, `style`.
pub(super) fn keys_of(section: &str) -> impl Iterator<Item = &'static str> {
    KEYS.iter().filter_map(move |key| key.strip_prefix(section)?.strip_prefix('.'))
}

/// The sections of a figure, and its lists of sections.
pub(super) fn sections() -> Vec<&'static str> {
    let mut names: Vec<&str> = KEYS.iter().filter_map(|key| Some(key.split_once('.')?.0)).collect();
    names.dedup();
    names
}

/// A pass through the keys of a section.
pub(super) struct Keys<'a> {
    pass: Pass<'a>,
    /// The keys that take part; `None` means all.
    only: Option<Vec<&'a str>>,
    /// True if keys with their usual values are written too.
    every: bool,
}

/// The purpose of a pass.
enum Pass<'a> {
    /// Values come from a section. The faults of the sections in it come after its own.
    Read { section: Section<'a>, inner: Vec<Fault> },
    /// Values go to a table.
    Write(Table),
    /// The paths of all keys.
    List(Vec<String>),
}

impl<'a> Keys<'a> {
    /// Reads a section.
    pub(super) fn read(section: Section<'a>) -> Self {
        Self::new(Pass::Read { section, inner: Vec::new() })
    }

    /// Writes the keys that don't have their usual values, or every key.
    pub(super) fn write(every: bool) -> Self {
        Self { every, ..Self::new(Pass::Write(Table::new())) }
    }

    fn new(pass: Pass<'a>) -> Self {
        Self { pass, only: None, every: false }
    }

    /// Passes only through these keys of the section. The others keep their values.
    pub(super) fn only(self, only: &[&'a str]) -> Self {
        Self { only: Some(only.to_vec()), ..self }
    }

    /// Adds the faults to others. True if the section's own faults are only unknown keys.
    pub(super) fn finish(self, faults: &mut Vec<Fault>) -> bool {
        let Pass::Read { section, inner } = self.pass else { return true };
        let is_good = section.is_good(faults);
        faults.extend(inner);
        is_good
    }

    /// The written table.
    pub(super) fn into_table(self) -> Table {
        match self.pass {
            Pass::Write(table) => table,
            Pass::Read { .. } | Pass::List(_) => Table::new(),
        }
    }

    /// The section, if this pass reads.
    fn reading(&mut self) -> Option<&mut Section<'a>> {
        match &mut self.pass {
            Pass::Read { section, .. } => Some(section),
            Pass::Write(_) | Pass::List(_) => None,
        }
    }

    fn is_reading(&self) -> bool {
        matches!(self.pass, Pass::Read { .. })
    }

    fn is_writing(&self) -> bool {
        matches!(self.pass, Pass::Write(_))
    }

    /// True if the faults so far are only unknown keys.
    fn is_good(&mut self) -> bool {
        self.reading().is_none_or(|section| section.faults.iter().all(Fault::is_unknown_key))
    }

    /// The order of keys in a message, if it isn't that of a written file.
    fn in_order(&mut self, keys: &[&'static str]) {
        if let Some(section) = self.reading() {
            keys.iter().for_each(|key| section.skip(key));
        }
    }

    /// The label of the keys of a section on one line.
    fn label_of(&mut self, key: &str) -> String {
        self.reading().map_or_else(String::new, |section| format!("{}.", section.name_of(key)))
    }

    /// Writes the section without a line of its own, because all of its keys are sections.
    fn without_line(&mut self) {
        if let Pass::Write(table) = &mut self.pass {
            table.set_implicit(true);
        }
    }

    /// Adds a fault after those of the section.
    fn fault_later(&mut self, fault: Fault) {
        if let Pass::Read { inner, .. } = &mut self.pass {
            inner.push(fault);
        }
    }

    /// True if a key takes part.
    fn takes(&mut self, key: &'static str) -> bool {
        let takes = self.only.as_ref().is_none_or(|only| only.contains(&key));
        if !takes {
            self.in_order(&[key]);
        }
        takes
    }

    /// A field with its own way to be read and written. `written` is false if it needn't be written.
    fn field<V>(
        &mut self,
        key: &'static str,
        written: bool,
        value: &mut V,
        read: impl FnOnce(&mut Section<'a>, &mut V),
        write: impl FnOnce(&V) -> Value,
    ) {
        if !self.takes(key) {
            return;
        }
        match &mut self.pass {
            Pass::Read { section, .. } => read(section, value),
            Pass::Write(table) if self.every || written => drop(table.insert(key, Item::Value(write(value)))),
            Pass::Write(_) => {}
            Pass::List(paths) => paths.push(key.to_owned()),
        }
    }

    /// A field that may have no value.
    fn optional_field<V>(
        &mut self,
        key: &'static str,
        value: &mut Option<V>,
        read: impl FnOnce(&mut Section<'a>) -> Option<V>,
        write: impl FnOnce(&V) -> Value,
    ) {
        if !self.is_writing() || value.is_some() {
            self.field(key, true, value, |s, v| *v = read(s), |v| v.as_ref().map_or_else(|| quoted(""), write));
        }
    }

    /// Writes a key that's read in its own way.
    fn put(&mut self, key: &'static str, value: impl FnOnce() -> Value) {
        if let Pass::Write(table) = &mut self.pass {
            table.insert(key, Item::Value(value()));
        }
    }

    /// Lists keys that are read and written in their own way.
    fn list_also(&mut self, keys: &[&str]) {
        if let Pass::List(paths) = &mut self.pass {
            paths.extend(keys.iter().map(|key| (*key).to_owned()));
        }
    }

    /// A key that's always written.
    fn key<V>(&mut self, key: &'static str, values: &Values<V>, value: &mut V) {
        self.key_if(key, true, values, value);
    }

    /// A key that isn't written if it has its usual value.
    fn rare<V: PartialEq>(&mut self, key: &'static str, usual: &V, values: &Values<V>, value: &mut V) {
        self.key_if(key, value != usual, values, value);
    }

    /// A key that's written on a condition.
    fn key_if<V>(&mut self, key: &'static str, written: bool, values: &Values<V>, value: &mut V) {
        let read = |s: &mut Section<'a>, v: &mut V| {
            if let Some(found) = s.get(key, values) {
                *v = found;
            }
        };
        self.field(key, written, value, read, values.write);
    }

    /// A key that the section must have.
    fn needed<V>(&mut self, key: &'static str, values: &Values<V>, value: &mut V) {
        self.require(key, values.allowed.clone());
        self.key(key, values, value);
    }

    /// A key that may be missing.
    fn option<V>(&mut self, key: &'static str, values: &Values<V>, value: &mut Option<V>) {
        self.optional_field(key, value, |s| s.get(key, values), values.write);
    }

    /// Three numbers, which aren't written if they're the usual ones.
    fn placed(&mut self, key: &'static str, usual: DVec3, values: &Values<DVec3>, value: &mut DVec3) {
        // −0 isn't 0, so they're compared bit by bit.
        let written = value.to_array().map(f64::to_bits) != usual.to_array().map(f64::to_bits);
        self.key_if(key, written, values, value);
    }

    /// `true` or `false`.
    fn switch(&mut self, key: &'static str, value: &mut bool) {
        self.rare(key, &false, &SWITCH, value);
    }

    /// Two numbers in a range, or nothing.
    fn pair_in(&mut self, key: &'static str, range: [f64; 2], value: &mut Option<DVec2>) {
        self.optional_field(key, value, |s| s.pair_in(key, range), PAIR.write);
    }

    /// One of `words`.
    fn word<V: Copy + PartialEq>(&mut self, key: &'static str, words: Words<V>, value: &mut V) {
        self.word_if(key, true, words, value);
    }

    /// One of `words`, which isn't written if it's the default.
    fn rare_word<V: Copy + PartialEq + Default>(&mut self, key: &'static str, words: Words<V>, value: &mut V) {
        let written = *value != V::default();
        // Only the lack of the key gives some defaults.
        if written || !self.is_writing() || !words::name(words, *value).is_empty() {
            self.word_if(key, written, words, value);
        }
    }

    fn word_if<V: Copy + PartialEq>(&mut self, key: &'static str, written: bool, words: Words<V>, value: &mut V) {
        self.field(key, written, value, |s, v| *v = s.word(key, words, *v), |v| words::name(words, *v).into());
    }

    /// One of `words`, or nothing.
    fn choice<V: Copy + PartialEq>(&mut self, key: &'static str, words: Words<V>, value: &mut Option<V>) {
        self.optional_field(key, value, |s| s.choice(key, words), |v| words::name(words, *v).into());
    }

    /// A section in this one, which isn't written without keys. `label` precedes its keys in messages.
    fn section(&mut self, key: &'static str, label: &str, visit: impl FnOnce(&mut Self)) {
        if !self.takes(key) {
            return;
        }
        match &mut self.pass {
            Pass::Read { section, inner } => {
                let mut keys = Self::read(section.section(key, label));
                visit(&mut keys);
                keys.finish(inner);
            }
            Pass::Write(table) => {
                let mut keys = Self::write(self.every);
                visit(&mut keys);
                let section = keys.into_table();
                if !section.is_empty() {
                    table.insert(key, Item::Table(section));
                }
            }
            Pass::List(paths) => list_inner(paths, key, visit),
        }
    }

    /// A section that is one field, each of whose keys has a default.
    fn part<V: Default>(
        &mut self,
        key: &'static str,
        label: &str,
        value: &mut V,
        visit: impl FnOnce(&mut Self, &mut V),
    ) {
        self.section(key, label, |keys| {
            if keys.is_reading() {
                *value = V::default();
            }
            visit(keys, value);
        });
    }

    /// A section in this one that may be missing. If it's faulty, it's left out. `form` makes it a table or a value,
    /// and `blank` is its value without keys.
    fn optional<V>(
        &mut self,
        key: &'static str,
        label: &str,
        form: fn(Table) -> Item,
        value: &mut Option<V>,
        mut blank: V,
        visit: impl FnOnce(&mut Self, &mut V),
    ) {
        if !self.takes(key) {
            return;
        }
        match &mut self.pass {
            Pass::Read { section, inner } => {
                *value = None;
                let Some(section) = section.section(key, label).there() else { return };
                let mut keys = Self::read(section);
                visit(&mut keys, &mut blank);
                *value = keys.finish(inner).then_some(blank);
            }
            Pass::Write(table) => {
                let Some(value) = value else { return };
                let mut keys = Self::write(self.every);
                visit(&mut keys, value);
                table.insert(key, form(keys.into_table()));
            }
            Pass::List(paths) => list_inner(paths, key, |keys| visit(keys, &mut blank)),
        }
    }

    /// A list of at most `limit` sections. `blank` is the value of the one at a place, without keys. `visit` gets those
    /// before it, and is false for one to leave out.
    fn list<V>(
        &mut self,
        key: &'static str,
        label: &str,
        limit: usize,
        values: &mut Vec<V>,
        blank: impl Fn(usize) -> V,
        mut visit: impl FnMut(&mut Self, &mut V, &[V]) -> bool,
    ) {
        if !self.takes(key) {
            return;
        }
        match &mut self.pass {
            Pass::Read { section, inner } => {
                values.clear();
                for (i, section) in at_most(section.sections(key, label), limit, label, inner).into_iter().enumerate() {
                    let (mut keys, mut value) = (Self::read(section), blank(i));
                    if visit(&mut keys, &mut value, values) {
                        values.push(value);
                    }
                    keys.finish(inner);
                }
            }
            Pass::Write(table) => {
                let one = |value: &mut V| {
                    let mut keys = Self::write(self.every);
                    visit(&mut keys, value, &[]);
                    keys.into_table()
                };
                let list: ArrayOfTables = values.iter_mut().map(one).collect();
                if !list.is_empty() {
                    table.insert(key, Item::ArrayOfTables(list));
                }
            }
            Pass::List(paths) => list_inner(paths, key, |keys| {
                visit(keys, &mut blank(0), &[]);
            }),
        }
    }

    /// A key that the section must have.
    fn require(&mut self, key: &'static str, allowed: Allowed) {
        if let Some(section) = self.reading() {
            section.require(key, allowed);
        }
    }
}

/// Adds the paths of the keys of a section in another one.
fn list_inner<'a>(paths: &mut Vec<String>, key: &str, visit: impl FnOnce(&mut Keys<'a>)) {
    let mut keys = Keys::new(Pass::List(Vec::new()));
    visit(&mut keys);
    if let Pass::List(inner) = keys.pass {
        paths.extend(inner.into_iter().map(|path| format!("{key}.{path}")));
    }
}

/// A section on one line, `{ … }`.
fn inline(table: Table) -> Item {
    let values = table.into_iter().filter_map(|(key, item)| Some((key, item.into_value().ok()?)));
    Item::Value(values.collect::<InlineTable>().into())
}

#[cfg(test)]
mod tests;
