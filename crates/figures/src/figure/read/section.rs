//! One section of a figure file, whose keys are read one by one. The remaining keys are unknown.

use glam::{DMat4, DVec2, DVec3};
use toml_edit::{Item, TableLike, Value};

use super::snippet;
use super::value::{Refused, number, number_if, numbers, told, told_by, vector, whole_numbers};
use crate::appearance::{Rgba, Samples};
use crate::expression::Dimension;
use crate::figure::error::{Allowed, Problem};
use crate::figure::near;
use crate::figure::words::{self, Words};

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
    /// Faults of the keys read so far.
    pub faults: Vec<Fault>,
}

impl<'a> Section<'a> {
    /// The section of `table`. `label` precedes its keys in messages, and `at` is its start.
    pub fn new(text: &'a str, table: Option<&'a dyn TableLike>, label: &str, at: usize) -> Self {
        Self { text, table, label: label.to_owned(), at, asked: Vec::new(), faults: Vec::new() }
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

    /// The value that `read` gives at `key`. If it gives none, the default, and a fault.
    fn read<T>(
        &mut self,
        key: &'static str,
        default: T,
        allowed: Allowed,
        read: impl FnOnce(&Value) -> Option<T>,
    ) -> T {
        let Some(item) = self.ask(key) else { return default };
        item.as_value().and_then(read).unwrap_or_else(|| {
            self.refuse(key, allowed);
            default
        })
    }

    /// Like [`Self::read`], for values with numbers in them.
    fn read_numbers<T>(
        &mut self,
        key: &'static str,
        default: T,
        allowed: Allowed,
        read: impl FnOnce(&Value) -> Result<T, Refused>,
    ) -> T {
        let Some(item) = self.ask(key) else { return default };
        match item.as_value().map_or(Err(Refused::Value), read) {
            Ok(value) => return value,
            Err(Refused::Value) => self.refuse(key, allowed),
            Err(Refused::Expression { text, error }) => {
                self.fault(key, Problem::Expression { text, error: Box::new(error), allowed });
            }
        }
        default
    }

    /// A finite number.
    pub fn number(&mut self, key: &'static str, default: f64) -> f64 {
        self.quantity(key, Dimension::Number, default)
    }

    /// A number, or infinity, which the caller refuses with a better message.
    pub fn number_or_infinity(&mut self, key: &'static str, default: f64) -> f64 {
        self.read_numbers(key, default, Allowed::Number, |value| match value.as_float() {
            Some(f64::INFINITY) => Ok(f64::INFINITY),
            _ => number(value, Dimension::Number),
        })
    }

    /// Degrees.
    pub fn angle(&mut self, key: &'static str, default: f64) -> f64 {
        self.quantity(key, Dimension::Angle, default)
    }

    fn quantity(&mut self, key: &'static str, dimension: Dimension, default: f64) -> f64 {
        self.read_numbers(key, default, Allowed::Number, |value| number(value, dimension))
    }

    /// A number between `least` and `most`, both included.
    pub fn number_in(&mut self, key: &'static str, least: f64, most: f64, default: f64) -> f64 {
        self.quantity_in(key, Dimension::Number, least, most, default)
    }

    /// Like [`number_in`](Self::number_in), if the key is there; the default if it's wrong.
    pub fn optional_in(&mut self, key: &'static str, least: f64, most: f64, default: f64) -> Option<f64> {
        let is_present = self.is_present(key);
        let number = self.number_in(key, least, most, default);
        is_present.then_some(number)
    }

    /// An angle is in degrees.
    pub fn quantity_in(&mut self, key: &'static str, dimension: Dimension, least: f64, most: f64, default: f64) -> f64 {
        self.read_numbers(key, default, Allowed::NumberIn(least, most), |value| {
            number_if(value, dimension, |x| (least..=most).contains(&x))
        })
    }

    /// A number greater than 0.
    pub fn positive(&mut self, key: &'static str, default: f64) -> f64 {
        self.read_numbers(key, default, Allowed::PositiveNumber, |value| {
            number_if(value, Dimension::Number, |x| x > 0.0)
        })
    }

    /// Degrees between 0 and 180, both excluded; `None` if the key is missing, or wrong.
    pub fn angle_of_half_turn(&mut self, key: &'static str) -> Option<f64> {
        self.read_numbers(key, None, Allowed::HalfTurn, |value| {
            number_if(value, Dimension::Angle, |degrees| degrees > 0.0 && degrees < 180.0).map(Some)
        })
    }

    /// Two numbers greater than 0.
    pub fn positive_pair(&mut self, key: &'static str, default: [f64; 2]) -> [f64; 2] {
        self.read_numbers(key, default, Allowed::PositivePair, |value| {
            let pair: [f64; 2] = numbers(value, Dimension::Number)?;
            pair.iter().all(|x| *x > 0.0).then_some(pair).ok_or(Refused::Value)
        })
    }

    /// An integer from `least` to `most`, which fit the type.
    pub fn integer<T: TryFrom<i64>>(&mut self, key: &'static str, least: i64, most: i64, default: T) -> T {
        self.read(key, default, Allowed::IntegerIn(least, most), |value| {
            value.as_integer().filter(|i| (least..=most).contains(i)).and_then(|i| T::try_from(i).ok())
        })
    }

    /// 1, 4 or 16.
    pub fn samples(&mut self, key: &'static str, default: Samples) -> Samples {
        self.read(key, default, Allowed::Integers(&[1, 4, 16]), |value| {
            value.as_integer().and_then(|count| Samples::from_count(u8::try_from(count).ok()?))
        })
    }

    /// `true` or `false`. False if the key is missing.
    pub fn switch(&mut self, key: &'static str) -> bool {
        self.switch_else(key, false)
    }

    /// A switch with this default.
    pub fn switch_else(&mut self, key: &'static str, default: bool) -> bool {
        self.read(key, default, Allowed::Switch, Value::as_bool)
    }

    /// One of two values, or one of `words`. The first if the key is missing.
    pub fn switch_or<T: Copy>(&mut self, key: &'static str, [off, on]: [T; 2], words: Words<T>) -> T {
        self.read(key, off, Allowed::SwitchOr(words::names(words)), |value| match value.as_bool() {
            Some(switch) => Some(if switch { on } else { off }),
            None => words::value(words, value.as_str()?),
        })
    }

    /// Three finite numbers.
    pub fn vector(&mut self, key: &'static str, default: DVec3) -> DVec3 {
        self.read_numbers(key, default, Allowed::Vector, |value| vector(value, Dimension::Number))
    }

    /// Degrees about x, y and z.
    pub fn angles(&mut self, key: &'static str, default: DVec3) -> DVec3 {
        self.read_numbers(key, default, Allowed::Vector, |value| vector(value, Dimension::Angle))
    }

    /// Points of three numbers each. [`Allowed::PointPairs`] asks for an even number of points. `None`, and a fault, if
    /// the key is missing.
    pub fn points(&mut self, key: &'static str, allowed: Allowed) -> Option<Vec<DVec3>> {
        let pairs = allowed == Allowed::PointPairs;
        if self.ask(key).is_none() {
            self.missing(key, allowed);
            return None;
        }
        self.read_numbers(key, None, allowed, |value| {
            let list = value.as_array().filter(|list| !pairs || list.len() % 2 == 0).ok_or(Refused::Value)?;
            list.iter().map(|point| vector(point, Dimension::Number)).collect::<Result<Vec<_>, _>>().map(Some)
        })
    }

    /// A colour as `#rrggbb` or `#rrggbbaa`.
    pub fn color(&mut self, key: &'static str) -> Option<Rgba> {
        self.read(key, None, Allowed::Color, |value| value.as_str()?.parse().ok().map(Some))
    }

    /// A text that isn't empty.
    pub fn text(&mut self, key: &'static str) -> Option<String> {
        self.read(key, None, Allowed::Text, |value| {
            value.as_str().filter(|text| !text.is_empty()).map(|text| Some(text.to_owned()))
        })
    }

    /// A text that's the same in all languages, or one for each: `{ en = "…", "pt-BR" = "…" }`, in English and in
    /// Portuguese.
    pub fn told(&mut self, key: &'static str) -> Option<[String; 2]> {
        let found = told_by(self.ask(key)?);
        if found.is_none() {
            self.refuse(key, Allowed::Bilingual);
        }
        found
    }

    /// A table of such texts, in the order of the file.
    pub fn bilingual_table(&mut self, key: &'static str) -> Vec<(String, [String; 2])> {
        let Some(table) = self.ask(key).and_then(Item::as_table_like) else { return Vec::new() };
        let texts: Option<Vec<_>> = table.iter().map(|(name, item)| Some((name.to_owned(), told_by(item)?))).collect();
        if texts.is_none() {
            self.refuse(key, Allowed::Bilingual);
        }
        texts.unwrap_or_default()
    }

    /// A list of such texts.
    pub fn bilingual_list(&mut self, key: &'static str) -> Vec<[String; 2]> {
        self.read(key, Vec::new(), Allowed::ToldList, |value| value.as_array()?.iter().map(told).collect())
    }

    /// A list of texts, each of which `read` can read.
    pub fn list<T>(&mut self, key: &'static str, allowed: Allowed, read: impl Fn(&str) -> Option<T>) -> Vec<T> {
        self.read(key, Vec::new(), allowed, |value| value.as_array()?.iter().map(|text| read(text.as_str()?)).collect())
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

    /// Two finite numbers.
    pub fn pair(&mut self, key: &'static str) -> Option<DVec2> {
        self.read_numbers(key, None, Allowed::Pair, |value| {
            numbers(value, Dimension::Number).map(|pair| Some(DVec2::from_array(pair)))
        })
    }

    /// Two finite numbers between two others, both included.
    pub fn pair_in(&mut self, key: &'static str, least: f64, most: f64) -> Option<DVec2> {
        let before = self.faults.len();
        let pair = self.pair(key)?;
        if !pair.to_array().iter().all(|x| (least..=most).contains(x)) && self.faults.len() == before {
            self.refuse(key, Allowed::PairIn(least, most));
            return None;
        }
        Some(pair)
    }

    /// A text of one line, of at most `limit` characters.
    pub fn line(&mut self, key: &'static str, limit: usize) -> Option<String> {
        self.read(key, None, Allowed::Line { limit }, |value| {
            let text = value.as_str()?;
            let is_line = !text.trim().is_empty() && !text.contains(crate::sanitize::is_obeyed);
            (is_line && text.chars().count() <= limit).then(|| Some(text.to_owned()))
        })
    }

    /// The number of values in the list at `key`; `None` if there's no list.
    pub fn list_length(&self, key: &str) -> Option<usize> {
        Some(self.item(key)?.as_array()?.len())
    }

    /// Two whole numbers from `least` on.
    pub fn whole_pair<T: TryFrom<i64>>(&mut self, key: &'static str, least: i64) -> Option<[T; 2]> {
        self.read(key, None, Allowed::Pixel, |value| {
            let whole = |i: i64| T::try_from(i).ok().filter(|_| i >= least);
            let [i, j] = whole_numbers(value)?.map(whole);
            Some(Some([i?, j?]))
        })
    }

    /// A 4 × 4 matrix, row by row.
    pub fn matrix(&mut self, key: &'static str) -> Option<DMat4> {
        self.read_numbers(key, None, Allowed::Matrix, |value| {
            let rows = value.as_array().filter(|rows| rows.len() == 4).ok_or(Refused::Value)?;
            let mut entries = [[0.0; 4]; 4];
            for (place, row) in entries.iter_mut().zip(rows) {
                *place = numbers(row, Dimension::Number)?;
            }
            Ok(Some(DMat4::from_cols_array_2d(&entries).transpose()))
        })
    }

    /// A list of pairs of whole numbers.
    pub fn pairs(&mut self, key: &'static str) -> Vec<[i64; 2]> {
        self.read(key, Vec::new(), Allowed::Pixels, |value| value.as_array()?.iter().map(whole_numbers).collect())
    }

    /// Numbers in rows. A number is one row of one, a list is a row for each, and a list of lists is itself.
    pub fn rows(&mut self, key: &'static str, is_angle: bool) -> Option<Vec<Vec<f64>>> {
        let dimension = if is_angle { Dimension::Angle } else { Dimension::Number };
        self.read_numbers(key, None, Allowed::Numbers, |value| {
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
            if is_table { Ok(Some(rows)) } else { Err(Refused::Value) }
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
        Self::new(self.text, table, label, self.place(key).unwrap_or(self.at))
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
        tables.into_iter().map(|(t, at)| Self::new(self.text, Some(t), label, at.unwrap_or(here))).collect()
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
        let written =
            |item: &Item| item.span().and_then(|span| self.text.get(span)).unwrap_or_default().trim().to_owned();
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
            let problem = Problem::UnknownKey { near: near::key(&key, &known), known };
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
