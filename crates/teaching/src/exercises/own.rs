//! A lecturer's own exercises: one TOML file each, read like figure files.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::exercise::{Ask, Exercise, Expected, Kind, Unit};
use super::own_texts::{ExpectedAnswer, OwnMistake, OwnTexts};
use super::statement_facts::about;
use super::subject::Subject;
use super::value::Table;
use super::{Entry, Make, SECOND, place};
use crate::exercises::mistakes::mistake::Mistake;
use crate::exercises::mistakes::slip::Slip;
use crate::figure::error::{Allowed, Problem};
use crate::figure::read::{self, Fault, Section, at_most};
use crate::figure::value::{POSITIVE, SWITCH, TEXT};
use crate::figure::words::Words;
use crate::figure::{Figure, FigureError, Localized};
use crate::formula;
use crate::inspect::quantity::{PointNumber, Quantity, QuantityPath};
use crate::limits::{MAX_ASKS, MAX_EXERCISE_BYTES, MAX_EXERCISE_NAME};
use crate::scene::Preset;

impl Entry {
    /// Changes each text of a lecturer's own question: the question, the choices, the messages and hints.
    ///
    /// # Errors
    /// The errors of `change`.
    pub(crate) fn with_texts<E>(&mut self, mut change: impl FnMut(&mut Localized) -> Result<(), E>) -> Result<(), E> {
        let Make::Own(exercise) = &mut self.make else { return Ok(()) };
        let exercise = Arc::make_mut(exercise);
        if let Some(texts) = &mut exercise.texts {
            Arc::make_mut(texts).asks.values_mut().try_for_each(&mut change)?;
        }
        for ask in &mut exercise.asks {
            ask.own_choices.values_mut().try_for_each(&mut change)?;
            ask.because.iter_mut().try_for_each(&mut change)?;
            for mistake in &mut ask.own_mistakes {
                let mistake = Arc::make_mut(mistake);
                change(&mut mistake.message)?;
                mistake.hints.iter_mut().try_for_each(&mut change)?;
            }
        }
        Ok(())
    }
}

impl Entry {
    /// Marks the questions about a point whose coordinates in the VRC are given, by its index.
    pub(crate) fn with_views_given(&mut self, is_given: impl Fn(usize) -> bool) {
        let Make::Own(exercise) = &mut self.make else { return };
        for ask in &mut Arc::make_mut(exercise).asks {
            let point = match ask.quantity.map(|path| path.quantity) {
                Some(Quantity::Point(k, number)) if number != PointNumber::View => Some(k),
                _ => None,
            };
            if point.is_some_and(&is_given) {
                ask.not_asked = Slip::is_before_view;
            }
        }
    }
}

/// The name of the only question of an exercise.
pub(crate) const QUESTION: &str = "answer";

/// `unit`
const UNITS: Words<Unit> =
    &[("none", Unit::None), ("scene", Unit::Scene), ("degrees", Unit::Degrees), ("pixels", Unit::Pixels)];

/// `code`
const CODES: Words<Mistake> = {
    const SWAPPED: [(&str, Mistake); Mistake::ALL.len()] = {
        let mut words = [("", Mistake::Sign); Mistake::ALL.len()];
        let mut k = 0;
        while k < words.len() {
            words[k] = (Mistake::ALL[k].code(), Mistake::ALL[k]);
            k += 1;
        }
        words
    };
    &SWAPPED
};

/// Reads the bytes of a file that holds an exercise.
///
/// # Guarantees
/// Its questions have right answers, and the mistakes that it names are wrong.
///
/// # Errors
/// [`FigureError`] names the first faulty line: the line, the key, the value found and the values allowed.
pub fn parse_bytes(bytes: &[u8]) -> Result<Entry, FigureError> {
    parse(read::text_of(bytes, MAX_EXERCISE_BYTES)?)
}

/// Reads an exercise.
///
/// # Errors
/// As for [`parse_bytes`].
pub fn parse(text: &str) -> Result<Entry, FigureError> {
    let exercise = read::parse_with(text, exercise)?;
    Ok(entry(exercise))
}

fn entry(exercise: Exercise) -> Entry {
    Entry {
        id: exercise.id.clone().into(),
        source: "",
        minutes: None,
        is_family: false,
        make: Make::Own(Arc::new(exercise)),
    }
}

/// The identifier in the bytes of a file that may be faulty elsewhere.
pub fn id_in(bytes: &[u8]) -> Option<String> {
    let text = read::text_of(bytes, MAX_EXERCISE_BYTES).ok()?;
    // Found by its line, because the file may not be TOML. Keys of sections come later.
    let top = text.lines().map(str::trim).take_while(|line| !line.starts_with('['));
    let values = top.filter_map(|line| line.strip_prefix("id")?.trim_start().strip_prefix('='));
    let quoted = values.filter_map(|value| {
        let value = value.trim_start();
        let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''))?;
        value[1..].split(quote).next()
    });
    quoted.map(str::to_owned).next().filter(|id| !id.is_empty())
}

/// The error for an exercise whose identifier another one has.
pub fn taken(text: &str, id: &str) -> FigureError {
    let refuse = |mut section: Section<'_>, faults: &mut Vec<Fault>| {
        section.refuse("id", Allowed::FreeName);
        // The others were good.
        faults.append(&mut section.faults);
    };
    let otherwise = || {
        let problem = Problem::Value { found: id.to_owned(), allowed: Allowed::FreeName };
        FigureError { line: 1, key: "id".to_owned(), problem }
    };
    read::parse_with(text, refuse).err().unwrap_or_else(otherwise)
}

fn exercise(mut root: Section<'_>, faults: &mut Vec<Fault>) -> Exercise {
    let id = name(&mut root, "id");
    let title = told(&mut root, "title");
    let statement = told(&mut root, "statement");
    let assumptions = bilingual_list(&mut root, "assumptions");
    let figure_section = root.section("figure", "[figure]");
    let has_figure = figure_section.is_table();
    let figure = read::figure(figure_section, faults);
    let figure = if has_figure { figure } else { Figure::of_preset(Preset::House) };
    let operations = root.list("ops", Allowed::Operations, |text| text.parse().ok());
    let points = if root.is_present("points") { root.points("points", Allowed::Points) } else { None };
    let pixels = root.pairs("pixels");
    let subject = Subject { figure, operations, points: points.unwrap_or_default(), pixels };
    // An impossible camera has been reported already.
    if faults.is_empty() && root.faults.is_empty() && subject.camera().is_err() {
        root.refuse("ops", Allowed::Operations);
    }
    let sections = root.sections("ask", "[[ask]]");
    if sections.is_empty() {
        root.missing("ask", Allowed::Sections);
    }
    let sections = at_most(sections, MAX_ASKS, "[[ask]]", faults);
    faults.extend(root.finish());
    // Questions about a faulty figure aren't checked.
    let is_good = faults.iter().all(Fault::is_unknown_key);
    let mut asks: Vec<Ask> = Vec::new();
    let mut texts = OwnTexts { title, statement, assumptions, ..OwnTexts::default() };
    for mut section in sections.into_iter().filter(|_| is_good) {
        let name = name(&mut section, "name");
        if asks.iter().any(|other| other.name == name) && !name.is_empty() {
            section.fault("name", Problem::Duplicate);
        }
        asks.extend(ask(section, name, [&subject; 2], &mut texts, faults));
    }
    own(id, subject, asks, texts)
}

fn own(id: String, subject: Subject, asks: Vec<Ask>, texts: OwnTexts) -> Exercise {
    // Its statement has its numbers already, so braces in it belong to formulas.
    Exercise { id, facts: Vec::new(), asks, texts: Some(Arc::new(texts)), ..about(subject) }
}

/// An exercise of one question, in a section of its own; `None`, and a fault, if it's impossible. `told` is the subject
/// that its text describes, and `subject` the one that it's about.
pub(crate) fn question(
    section: Section<'_>,
    [told, subject]: [Subject; 2],
    title: Localized,
    faults: &mut Vec<Fault>,
) -> Option<Entry> {
    let mut texts = OwnTexts { title, ..OwnTexts::default() };
    let ask = ask(section, QUESTION.to_owned(), [&told, &subject], &mut texts, faults)?;
    Some(entry(own(String::new(), subject, vec![ask], texts)))
}

/// A name that's valid in a command line and in a file.
pub(crate) fn name(section: &mut Section<'_>, key: &'static str) -> String {
    let allowed = || Allowed::Name { limit: MAX_EXERCISE_NAME };
    let Some(text) = section.get(key, &TEXT) else {
        section.require(key, allowed());
        return String::new();
    };
    let is_name = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    if text.chars().all(is_name) && text.len() <= MAX_EXERCISE_NAME {
        return text;
    }
    section.refuse(key, allowed());
    String::new()
}

/// A required text.
pub(crate) fn told(section: &mut Section<'_>, key: &'static str) -> Localized {
    section.require(key, Allowed::Bilingual);
    let told = section.told(key);
    told.and_then(|texts| harmless(section, key, texts)).unwrap_or_default()
}

/// An optional list of texts.
pub(crate) fn bilingual_list(section: &mut Section<'_>, key: &'static str) -> Vec<Localized> {
    let all = section.bilingual_list(key);
    all.into_iter().filter_map(|texts| harmless(section, key, texts)).collect()
}

/// A text that the window can show and a sheet can set; `None`, and a fault, if it has more than words and mathematics.
pub(crate) fn harmless(section: &mut Section<'_>, key: &str, texts: Localized) -> Option<Localized> {
    // Files from Windows have these line ends.
    let texts = texts.map(|_, text| text.replace("\r\n", "\n"));
    for (_, text) in texts.iter() {
        if text.contains(|c: char| c.is_control() && !matches!(c, '\n' | '\t')) {
            section.refuse(key, Allowed::Bilingual);
            return None;
        }
        if let Err(error) = formula::check(text) {
            section.fault(key, error.into());
            return None;
        }
    }
    Some(texts)
}

/// A question; `None`, and a fault, if it's impossible. The subjects are the one that the text describes, and the one
/// that the question is about.
fn ask(
    mut section: Section<'_>,
    name: String,
    subjects: [&Subject; 2],
    texts: &mut OwnTexts,
    faults: &mut Vec<Fault>,
) -> Option<Ask> {
    let text = told(&mut section, "text");
    let unit = section.choice("unit", UNITS);
    let whole = section.is_present("whole").then(|| section.get("whole", &SWITCH).unwrap_or(false));
    let tolerance = section.is_present("tolerance").then(|| section.get("tolerance", &POSITIVE).unwrap_or(1.0));
    let hidden = section.list("asks", Allowed::Quantity, QuantityPath::of);
    let because = section.told("because").and_then(|texts| harmless(&mut section, "because", texts));
    let (choices, own_choices) = choices(&mut section);
    let ask = asked(&mut section, &name, subjects, choices, unit);
    let mut second = None;
    if ask.as_ref().is_some_and(|ask| ask.places) && section.is_present(SECOND) {
        let mut section = section.section(SECOND, "second.");
        texts.asks.insert(SECOND.to_owned(), told(&mut section, "text"));
        second = place::asked(&mut section, SECOND, subjects[0], subjects[1]).map(Box::new);
        faults.extend(section.finish());
    }
    let mistakes = section.sections("mistake", "[[ask.mistake]]");
    faults.extend(section.finish());
    let mut ask = ask?;
    (ask.own_choices, ask.because, ask.second) = (own_choices, because, second);
    ask.asks = hidden.into_iter().map(|path| path.quantity).collect();
    ask.unit = unit.unwrap_or(ask.unit);
    ask.whole = whole.unwrap_or(ask.whole);
    if let Some(tolerance) = tolerance {
        (ask.tolerance, ask.share) = (tolerance, f64::INFINITY);
    }
    for section in mistakes {
        let own = own_mistake(section, &ask, subjects, faults);
        ask.own_mistakes.extend(own.map(Arc::new));
    }
    texts.asks.insert(name, text);
    Some(ask)
}

/// `choices`: a list of words that are the same in both languages, or a table of names, each with its text.
fn choices(section: &mut Section<'_>) -> (Vec<String>, BTreeMap<String, Localized>) {
    if section.is_list("choices") || !section.is_present("choices") {
        let word = |text: &str| (!text.trim().is_empty()).then(|| text.to_owned());
        return (section.list("choices", Allowed::Texts, word), BTreeMap::new());
    }
    let told = section.bilingual_table("choices");
    let names = told.iter().map(|(name, _)| name.clone()).collect();
    let texts = told.into_iter().filter_map(|(name, text)| Some((name, harmless(section, "choices", text)?)));
    (names, texts.collect())
}

/// An ask by its `place`, its `quantity` or its `answer`.
fn asked(
    section: &mut Section<'_>,
    name: &str,
    [told, subject]: [&Subject; 2],
    choices: Vec<String>,
    unit: Option<Unit>,
) -> Option<Ask> {
    if section.is_present("place") {
        return place::asked(section, name, told, subject);
    }
    let quantity = section.get("quantity", &TEXT);
    match (section.is_present("quantity"), section.is_present("answer")) {
        (true, true) => {
            section.refuse("answer", Allowed::Either("quantity", "answer"));
            // The key is known all the same.
            section.skip("answer");
            None
        }
        (false, false) => {
            section.skip("answer");
            section.missing("answer", Allowed::Either("quantity", "answer"));
            None
        }
        (true, false) => {
            section.skip("answer");
            let path =
                QuantityPath::of(&quantity?).filter(|path| subject.value(*path).is_some_and(|table| table.is_finite()));
            if path.is_none() {
                section.refuse("quantity", Allowed::Quantity);
            }
            Some(Ask::quantity(name, subject, path?))
        }
        (false, true) => match given(section, &choices, unit)? {
            ExpectedAnswer::Choice(right) => {
                let choices: Vec<&str> = choices.iter().map(String::as_str).collect();
                Some(Ask::choice(name, &choices, right, &[], Vec::new()))
            }
            ExpectedAnswer::Numbers(table) => {
                let kind = match table.shape() {
                    [1, 1] => Kind::Number,
                    [rows, 1] => Kind::Vector(rows),
                    [rows, columns] => Kind::Matrix(rows, columns),
                };
                Some(Ask::computed(name, kind, Vec::new(), move |slips| {
                    // Most known mistakes need a figure. Only those that apply to any table are known here.
                    (slips == super::Slips::NONE).then(|| table.clone())
                }))
            }
        },
    }
}

/// `answer`: one of the choices, or numbers.
fn given(section: &mut Section<'_>, choices: &[String], unit: Option<Unit>) -> Option<ExpectedAnswer> {
    if choices.is_empty() {
        let rows = section.rows("answer", unit == Some(Unit::Degrees))?;
        let columns = rows.first().map_or(0, Vec::len);
        return Some(ExpectedAnswer::Numbers(Table { rows: rows.len(), columns, entries: rows.concat() }));
    }
    let allowed = || Allowed::Choice(choices.to_vec());
    let text = section.get("answer", &TEXT);
    let found = text.and_then(|text| choices.iter().position(|choice| *choice == text));
    if found.is_none() && section.is_present("answer") {
        section.faults.retain(|fault| !matches!(fault.problem, Problem::Value { allowed: Allowed::Text, .. }));
        section.refuse("answer", allowed());
    }
    found.map(ExpectedAnswer::Choice)
}

fn own_mistake(
    mut section: Section<'_>,
    ask: &Ask,
    [told_of, subject]: [&Subject; 2],
    faults: &mut Vec<Fault>,
) -> Option<OwnMistake> {
    let choices = match &ask.kind {
        Kind::Choice(choices) => choices.clone(),
        _ => Vec::new(),
    };
    let key = if ask.places && section.is_present("place") { "place" } else { "answer" };
    let answer = if key == "place" {
        place::mistaken(&mut section, told_of, subject).map(ExpectedAnswer::Numbers)
    } else {
        let allowed = if choices.is_empty() { Allowed::Numbers } else { Allowed::Choice(choices.clone()) };
        section.require("answer", allowed);
        given(&mut section, &choices, Some(ask.unit))
    };
    let is_right = match (&answer, ask.expected()) {
        (Some(ExpectedAnswer::Choice(wrong)), Expected::Choice(right, ..)) => wrong == right,
        (Some(ExpectedAnswer::Numbers(wrong)), expected) => expected.table().is_some_and(|right| {
            let mut both = wrong.entries.iter().zip(&right.entries);
            wrong.shape() == right.shape() && both.all(|(wrong, right)| ask.accepts(Some(*wrong), *right))
        }),
        _ => false,
    };
    if is_right {
        section.refuse(key, Allowed::WrongAnswer);
    }
    let message = told(&mut section, "message");
    let hints = if section.is_list("hint") {
        bilingual_list(&mut section, "hint")
    } else {
        let hint = section.told("hint");
        hint.and_then(|texts| harmless(&mut section, "hint", texts)).into_iter().collect()
    };
    let mistake = section.choice("code", CODES);
    faults.extend(section.finish());
    answer.map(|answer| OwnMistake { answer, mistake, message, hints })
}
