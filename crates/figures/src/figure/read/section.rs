//! One section of a figure file, whose keys are read one by one. The remaining keys are unknown.

use glam::{DVec2, DVec3};
use toml_edit::{Item, TableLike, Value};

use super::snippet;
use crate::expression::Dimension;
use crate::figure::error::{Allowed, Problem};
use crate::figure::value::{PAIR, Refused, Values, number, told, told_by, vector, whole_numbers};
use crate::figure::words::{self, Words};
use crate::figure::{Localized, near};

/// A fault, and its place in the text.
#[derive(Debug)]
pub struct Fault {
    /// Byte offset in the text.
    pub at: usize,
    /// The key as a message names it, with its section.
    pub key: String,
    /// The rule that the value breaks.
    pub problem: Problem,
}

impl Fault {
    /// True if an unknown key is the only fault.
    pub fn is_unknown_key(&self) -> bool {
        matches!(self.problem, Problem::UnknownKey { .. })
    }
}

/// A section that's there, or one of which every key has its default.
pub struct Section<'a> {
    /// The text of the file that contains it.
    pub(super) text: &'a str,
    /// The tables and values in it, as written.
    pub(super) table: Option<&'a dyn TableLike>,
    label: String,
    /// The start of the section.
    pub at: usize,
    asked: Vec<&'static str>,
    /// The section of a key in the wrong one.
    home: fn(&str) -> Option<String>,
    /// Faults of the keys read so far.
    pub faults: Vec<Fault>,
}

impl<'a> Section<'a> {
    /// The section of `table`. `label` precedes its keys in messages, and `at` is its start.
    pub fn new(text: &'a str, table: Option<&'a dyn TableLike>, label: &str, at: usize) -> Self {
        Self { text, table, label: label.to_owned(), at, asked: Vec::new(), home: |_| None, faults: Vec::new() }
    }

    /// The section, whose messages know the sections of keys in a wrong place.
    pub(in crate::figure) fn with_homes(self, home: fn(&str) -> Option<String>) -> Self {
        Self { home, ..self }
    }

    /// The place of `key`; `None` if it's missing.
    pub fn place(&self, key: &str) -> Option<usize> {
        let (key, item) = self.table?.get_key_value(key)?;
        Some(key.span().or_else(|| item.span()).map_or(self.at, |span| span.start))
    }

    /// True if the section has the key, whatever its value.
    pub fn is_present(&self, key: &str) -> bool {
        self.table.is_some_and(|table| table.contains_key(key))
    }

    /// Marks a key as known without reading it.
    pub fn skip(&mut self, key: &'static str) {
        self.ask(key);
    }

    /// True if there is a list.
    pub fn is_list(&self, key: &str) -> bool {
        self.item(key).is_some_and(Item::is_array)
    }

    /// True if there is a text.
    pub fn is_text(&self, key: &str) -> bool {
        self.item(key).is_some_and(Item::is_str)
    }

    /// True if there is a table, even an empty one.
    pub fn is_table(&self) -> bool {
        self.table.is_some()
    }

    /// The section, if there is a table, even an empty one.
    pub fn there(self) -> Option<Self> {
        self.is_table().then_some(self)
    }

    /// True if no key is there.
    pub fn is_empty(&self) -> bool {
        self.table.is_none_or(|table| table.iter().next().is_none())
    }

    /// The name of a key in messages, with the label of the section.
    pub fn name_of(&self, key: &str) -> String {
        match self.label.as_str() {
            "" => key.to_owned(),
            label if label.ends_with('.') => format!("{label}{key}"),
            label => format!("{label} {key}"),
        }
    }

    /// Adds a fault at the place of `key`, or of the section if the key is missing.
    pub fn fault(&mut self, key: &str, problem: Problem) {
        let at = self.place(key).unwrap_or(self.at);
        self.faults.push(Fault { at, key: self.name_of(key), problem });
    }

    /// Reports that the value of `key` isn't allowed.
    pub fn refuse(&mut self, key: &str, allowed: Allowed) {
        let found = self.item(key).and_then(Item::span).map_or_else(String::new, |span| snippet(self.text, span));
        self.fault(key, Problem::Value { found, allowed });
    }

    /// Reports that the section must have `key`, if it's missing.
    pub fn require(&mut self, key: &str, allowed: Allowed) {
        if !self.is_present(key) {
            self.missing(key, allowed);
        }
    }

    /// Reports that the section must have `key`.
    pub fn missing(&mut self, key: &str, allowed: Allowed) {
        self.fault(key, Problem::Missing { allowed });
    }

    fn item(&self, key: &str) -> Option<&'a Item> {
        self.table?.get(key)
    }

    fn ask(&mut self, key: &'static str) -> Option<&'a Item> {
        if !self.asked.contains(&key) {
            self.asked.push(key);
        }
        self.item(key)
    }

    /// The value of a key; `None` if it's missing, and `None` with a fault if it isn't allowed.
    pub fn get<V>(&mut self, key: &'static str, values: &Values<V>) -> Option<V> {
        self.read(key, &values.allowed, |value| (values.read)(value, &values.allowed))
    }

    /// The value that `read` gives at `key`. If it gives none, a fault.
    fn read<V>(
        &mut self,
        key: &'static str,
        allowed: &Allowed,
        read: impl FnOnce(&Value) -> Result<V, Refused>,
    ) -> Option<V> {
        match self.ask(key)?.as_value().map_or(Err(Refused::Value), read) {
            Ok(value) => return Some(value),
            Err(Refused::Value) => self.refuse(key, allowed.clone()),
            Err(Refused::Expression { text, error }) => {
                self.fault(key, Problem::Expression { text, error: Box::new(error), allowed: allowed.clone() });
            }
        }
        None
    }

    /// One of two values, or one of `words`. The first if the key is missing.
    pub fn switch_or<T: Copy>(&mut self, key: &'static str, [off, on]: [T; 2], words: Words<T>) -> T {
        let value = self.read(key, &Allowed::SwitchOr(words::names(words)), |value| {
            let word = || words::value(words, value.as_str()?);
            value.as_bool().map(|switch| if switch { on } else { off }).or_else(word).ok_or(Refused::Value)
        });
        value.unwrap_or(off)
    }

    /// Points of three numbers each. [`Allowed::PointPairs`] asks for an even number of points. `None`, and a fault, if
    /// the key is missing.
    pub fn points(&mut self, key: &'static str, allowed: Allowed) -> Option<Vec<DVec3>> {
        let pairs = allowed == Allowed::PointPairs;
        if self.ask(key).is_none() {
            self.missing(key, allowed);
            return None;
        }
        self.read(key, &allowed, |value| {
            let list = value.as_array().filter(|list| !pairs || list.len() % 2 == 0).ok_or(Refused::Value)?;
            list.iter().map(|point| vector(point, Dimension::Number)).collect()
        })
    }

    /// A text that's the same in all languages, or one for each: `{ en = "…", "pt-BR" = "…" }`, in English and in
    /// Portuguese.
    pub fn told(&mut self, key: &'static str) -> Option<Localized> {
        let found = told_by(self.ask(key)?);
        if found.is_none() {
            self.refuse(key, Allowed::Bilingual);
        }
        found
    }

    /// A table of such texts, in the order of the file.
    pub fn bilingual_table(&mut self, key: &'static str) -> Vec<(String, Localized)> {
        let Some(table) = self.ask(key).and_then(Item::as_table_like) else { return Vec::new() };
        let texts: Option<Vec<_>> = table.iter().map(|(name, item)| Some((name.to_owned(), told_by(item)?))).collect();
        if texts.is_none() {
            self.refuse(key, Allowed::Bilingual);
        }
        texts.unwrap_or_default()
    }

    /// A list of such texts.
    pub fn bilingual_list(&mut self, key: &'static str) -> Vec<Localized> {
        self.read_list(key, &Allowed::ToldList, told)
    }

    /// A list of texts, each of which `read` can read.
    pub fn list<T>(&mut self, key: &'static str, allowed: Allowed, read: impl Fn(&str) -> Option<T>) -> Vec<T> {
        self.read_list(key, &allowed, |text| read(text.as_str()?))
    }

    fn read_list<T>(&mut self, key: &'static str, allowed: &Allowed, read: impl Fn(&Value) -> Option<T>) -> Vec<T> {
        let list = |value: &Value| value.as_array()?.iter().map(&read).collect::<Option<Vec<T>>>();
        self.read(key, allowed, |value| list(value).ok_or(Refused::Value)).unwrap_or_default()
    }

    /// A list of `words`. The message names the first one that isn't among them.
    pub fn words<T: Clone>(&mut self, key: &'static str, words: Words<T>) -> Vec<T> {
        let Some(item) = self.ask(key) else { return Vec::new() };
        let list: Option<Vec<&str>> = item.as_array().and_then(|list| list.iter().map(Value::as_str).collect());
        let Some(list) = list else {
            self.refuse(key, Allowed::Words(words::names(words)));
            return Vec::new();
        };
        let known = |text: &&str| words::value(words, text);
        if let Some(stranger) = list.iter().find(|text| known(text).is_none()) {
            let allowed =
                Allowed::Word { near: near::word(stranger, &words::names(words)), words: words::names(words) };
            self.fault(key, Problem::Value { found: snippet(stranger, 0..stranger.len()), allowed });
        }
        list.iter().filter_map(known).collect()
    }

    /// Two finite numbers between two others, both included.
    pub fn pair_in(&mut self, key: &'static str, [least, most]: [f64; 2]) -> Option<DVec2> {
        let pair = self.get(key, &PAIR)?;
        if !pair.to_array().iter().all(|x| (least..=most).contains(x)) {
            self.refuse(key, Allowed::PairIn(least, most));
            return None;
        }
        Some(pair)
    }

    /// The number of values in the list at `key`; `None` if there's no list.
    pub fn list_length(&self, key: &str) -> Option<usize> {
        Some(self.item(key)?.as_array()?.len())
    }

    /// A list of pairs of whole numbers.
    pub fn pairs(&mut self, key: &'static str) -> Vec<[i64; 2]> {
        self.read_list(key, &Allowed::Pixels, whole_numbers)
    }

    /// Numbers in rows. A number is one row of one, a list is a row for each, and a list of lists is itself.
    pub fn rows(&mut self, key: &'static str, is_angle: bool) -> Option<Vec<Vec<f64>>> {
        let dimension = if is_angle { Dimension::Angle } else { Dimension::Number };
        self.read(key, &Allowed::Numbers, |value| {
            let row = |value: &Value| match value.as_array() {
                Some(list) => list.iter().map(|entry| number(entry, dimension)).collect::<Result<Vec<_>, _>>(),
                None => Ok(vec![number(value, dimension)?]),
            };
            let rows = match value.as_array() {
                Some(list) => list.iter().map(row).collect::<Result<Vec<_>, _>>()?,
                None => vec![row(value)?],
            };
            let columns = rows.first().map_or(0, Vec::len);
            let is_table = columns > 0 && rows.iter().all(|row| row.len() == columns);
            if is_table { Ok(rows) } else { Err(Refused::Value) }
        })
    }

    /// The value of one of `words`, or the default.
    pub fn word<T: Clone>(&mut self, key: &'static str, words: Words<T>, default: T) -> T {
        self.choice(key, words).unwrap_or(default)
    }

    /// The value of one of `words`; `None` if the key is missing or holds no such word.
    pub fn choice<T: Clone>(&mut self, key: &'static str, words: Words<T>) -> Option<T> {
        let written = self.ask(key)?.as_str();
        let value = written.and_then(|text| words::value(words, text));
        if value.is_none() {
            let words = words::names(words);
            let near = written.and_then(|text| near::word(text, &words));
            self.refuse(key, Allowed::Word { words, near });
        }
        value
    }

    /// A section in this one.
    pub fn section(&mut self, key: &'static str, label: &str) -> Self {
        let item = self.ask(key);
        let table = item.and_then(Item::as_table_like);
        if item.is_some() && table.is_none() {
            self.refuse(key, Allowed::Section);
        }
        Self::new(self.text, table, label, self.place(key).unwrap_or(self.at)).with_homes(self.home)
    }

    /// Sections in this one: `[[label]]`, or a list of inline tables.
    pub fn sections(&mut self, key: &'static str, label: &str) -> Vec<Self> {
        let Some(item) = self.ask(key) else { return Vec::new() };
        let tables: Option<Vec<(&dyn TableLike, Option<usize>)>> = match item {
            Item::ArrayOfTables(tables) => {
                Some(tables.iter().map(|t| (t as &dyn TableLike, t.span().map(|s| s.start))).collect())
            }
            Item::Value(Value::Array(list)) => list
                .iter()
                .map(|v| {
                    let table = v.as_inline_table()?;
                    Some((table as &dyn TableLike, table.span().map(|s| s.start)))
                })
                .collect(),
            _ => None,
        };
        let Some(tables) = tables else {
            self.refuse(key, Allowed::Sections);
            return Vec::new();
        };
        let here = self.place(key).unwrap_or(self.at);
        let one = |table, at| Self::new(self.text, Some(table), label, at).with_homes(self.home);
        tables.into_iter().map(|(table, at)| one(table, at.unwrap_or(here))).collect()
    }

    /// The entries of a table in this section, each with its value as written and its place in the text. Entries of
    /// tables in it have the path `table.key`.
    pub fn entries(&mut self, key: &'static str) -> Vec<(String, String, usize)> {
        let Some(item) = self.ask(key) else { return Vec::new() };
        let Some(table) = item.as_table_like() else {
            self.refuse(key, Allowed::Section);
            return Vec::new();
        };
        let place = |item: &Item| item.span().map_or(self.at, |span| span.start);
        // Only a text has values as written.
        let written = |item: &Item| {
            let text = item.span().and_then(|span| self.text.get(span)).map(str::to_owned);
            text.unwrap_or_else(|| item.to_string()).trim().to_owned()
        };
        let entry = |path: String, item: &Item| (path, written(item), place(item));
        let entries =
            table.iter().flat_map(|(name, item)| match item.as_table_like().filter(|_| !name.contains('.')) {
                Some(inner) => inner.iter().map(|(key, item)| entry(format!("{name}.{key}"), item)).collect(),
                None => vec![entry(name.to_owned(), item)],
            });
        entries.collect()
    }

    /// The value of a key as written in the text.
    pub fn written(&mut self, key: &'static str) -> Option<String> {
        let span = self.ask(key)?.as_value()?.span()?;
        Some(self.text.get(span)?.trim().to_owned())
    }

    /// The result of a section whose only faults are unknown keys. Its faults join the others.
    pub fn good<T>(self, found: Option<T>, faults: &mut Vec<Fault>) -> Option<T> {
        let is_good = self.is_good(faults);
        found.filter(|_| is_good)
    }

    /// Adds the section's faults to others. True if its only faults are unknown keys.
    pub fn is_good(self, faults: &mut Vec<Fault>) -> bool {
        let own = self.finish();
        let is_good = own.iter().all(Fault::is_unknown_key);
        faults.extend(own);
        is_good
    }

    /// The result of `read`, once the section is finished.
    pub fn finished<T>(mut self, faults: &mut Vec<Fault>, read: impl FnOnce(&mut Self) -> T) -> T {
        let found = read(&mut self);
        faults.extend(self.finish());
        found
    }

    /// The faults of the section, including those for unknown keys.
    pub fn finish(mut self) -> Vec<Fault> {
        let unknown: Vec<String> = self
            .table
            .iter()
            .flat_map(|table| table.iter())
            .map(|(key, _)| key.to_owned())
            .filter(|key| !self.asked.contains(&key.as_str()))
            .collect();
        for key in unknown {
            let known = self.asked.clone();
            let problem = Problem::UnknownKey { near: near::key(&key, &known, self.home), known };
            let at = self.place(&key).unwrap_or(self.at);
            self.faults.push(Fault { at, key: self.name_of(&snippet(&key, 0..key.len())), problem });
        }
        self.faults
    }
}

/// The sections of a list with at most `limit` of them. If there are more, none, and a fault. `label` names the list in
/// the message.
pub fn at_most<'a>(sections: Vec<Section<'a>>, limit: usize, label: &str, faults: &mut Vec<Fault>) -> Vec<Section<'a>> {
    let Some(beyond) = sections.get(limit) else { return sections };
    let problem = Problem::TooMany { count: sections.len(), limit };
    faults.push(Fault { at: beyond.at, key: label.to_owned(), problem });
    Vec::new()
}
