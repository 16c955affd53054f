//! The text of a lesson file → [`Lesson`].

use std::borrow::Cow;
use std::sync::Arc;

use super::condition::{Condition, Goal, Range, angle as angle_between};
use super::lesson::{Lesson, Link, Question, See, Step, Task};
use super::numbers_in_texts::{filled, numbers_of, pixels_of, with_sentence};
use crate::camera::Camera;
use crate::exercises::own::{bilingual_list, harmless, name, question, told};
use crate::exercises::place::way;
use crate::exercises::{self, Entry, Kind, Subject};
use crate::figure::error::{Allowed, Problem};
use crate::figure::read::{Fault, Section, Stacked, at_most, parse_with, text_of};
use crate::figure::value::{ANGLE, NUMBER, TEXT, integer_in, number_in};
use crate::figure::{Figure, FigureError, Localized, update, varied};
use crate::inspect::Report;
use crate::inspect::quantity::QuantityPath;
use crate::limits::{MAX_CONDITIONS, MAX_LESSON_BYTES, MAX_LESSON_STEPS, MAX_TITLE};
use crate::numbers::DecimalMark;

/// Seconds of the move to a step if a lesson doesn't give them.
const SECONDS: f64 = 1.5;
/// The longest move.
const MOST_SECONDS: f64 = 20.0;
/// The longest lesson in minutes.
const MOST_MINUTES: f64 = 600.0;
/// The most questions before a lesson, and after it. More of them need more than a page.
const MOST_QUESTIONS: usize = 12;

/// Reads the bytes of a file that holds a lesson.
///
/// # Guarantees
/// Each step is a figure with a camera. Its questions have right answers, and every `{quantity}` is a number of it.
///
/// # Errors
/// [`FigureError`] names the first faulty line: the line, the key, the value found and the values allowed.
pub fn parse_bytes(bytes: &[u8]) -> Result<Lesson, FigureError> {
    parse(text_of(bytes, MAX_LESSON_BYTES)?)
}

/// Reads a lesson.
///
/// # Errors
/// As for [`parse_bytes`].
pub fn parse(text: &str) -> Result<Lesson, FigureError> {
    parse_with(text, lesson)
}

fn lesson(mut root: Section<'_>, faults: &mut Vec<Fault>) -> Lesson {
    let id = name(&mut root, "id");
    let title = line(&mut root, "title");
    let sentence = optional(&mut root, "sentence");
    let minutes = root.get("minutes", &number_in([0.5, MOST_MINUTES]));
    let aims = bilingual_list(&mut root, "aims");
    let plan = optional(&mut root, "plan");
    let [pretest, posttest] = ["pretest", "posttest"].map(|key| questions(&mut root, key, faults));
    let before = root.list("before", Allowed::Texts, |text| (!text.trim().is_empty()).then(|| text.to_owned()));
    let sections = root.sections("step", "[[step]]");
    if sections.is_empty() && root.faults.is_empty() {
        root.missing("step", Allowed::Sections);
    }
    let sections = at_most(sections, MAX_LESSON_STEPS, "[[step]]", faults);
    faults.extend(root.finish());
    let mut stacked = Stacked::default();
    let steps = sections.into_iter().map(|section| step(section, &mut stacked, sentence.as_ref(), faults)).collect();
    Lesson { id, title, sentence, minutes, aims, plan, pretest, posttest, before, steps }
}

/// The questions before or after a lesson.
fn questions(root: &mut Section<'_>, key: &'static str, faults: &mut Vec<Fault>) -> Vec<Question> {
    let sections = root.sections(key, &format!("[[{key}]]"));
    let count = sections.len();
    if count > MOST_QUESTIONS {
        root.fault(key, Problem::TooMany { count, limit: MOST_QUESTIONS });
        return Vec::new();
    }
    let question = |section: &mut Section<'_>| {
        section.require("exercise", Allowed::Exercise);
        exercise(section).map(|(id, seed)| Question { id, seed })
    };
    sections.into_iter().filter_map(|section| section.finished(faults, question)).collect()
}

/// A required text of one line.
fn line(section: &mut Section<'_>, key: &'static str) -> Localized {
    let text = told(section, key);
    let is_line = |text: &str| text.chars().count() <= MAX_TITLE && !text.contains('\n');
    if !text.iter().all(|(_, text)| is_line(text)) {
        section.refuse(key, Allowed::BilingualLine { limit: MAX_TITLE });
    }
    text
}

/// An optional text.
fn optional(section: &mut Section<'_>, key: &'static str) -> Option<Localized> {
    let texts = section.told(key)?;
    harmless(section, key, texts)
}

fn step(
    mut section: Section<'_>,
    stacked: &mut Stacked,
    sentence: Option<&Localized>,
    faults: &mut Vec<Fault>,
) -> Step {
    let title = line(&mut section, "title");
    let seconds = section.get("seconds", &number_in([0.0, MOST_SECONDS])).unwrap_or(SECONDS);
    let without = section.list("without", Allowed::Texts, |text| Some(text.to_owned()));
    if let Some(unknown) = without.iter().find(|path| !stacked.remove(path)) {
        let problem = Problem::Value { found: unknown.clone(), allowed: Allowed::KeyOfSteps };
        section.fault("without", problem);
    }
    stacked.put(&mut section);
    let before = faults.len();
    let figure = stacked.figure(&section, faults);
    let is_good = faults[before..].iter().all(Fault::is_unknown_key);
    let figure = Figure { title: Some(title.clone()).filter(|title| !title.en.is_empty()), ..figure };
    // A faulty figure has no numbers to check.
    let report = numbers_of(&figure).ok().filter(|_| is_good);
    let text = with_numbers(&mut section, "text", sentence, report.as_ref());
    let notes = section.is_present("notes").then(|| with_numbers(&mut section, "notes", None, report.as_ref()));
    let [mut asked, to_try] = ["ask", "try"].map(|key| section.section(key, &format!("[step.{key}]")));
    let links = section.sections("links", "[[step.links]]");
    if asked.is_table() && to_try.is_table() {
        section.refuse("try", Allowed::Either("ask", "try"));
    }
    faults.extend(section.finish());
    let see = if asked.is_table() && report.is_some() { see(&mut asked, &figure) } else { See::Nothing };
    let task = if asked.is_table() {
        let subject = Subject {
            points: figure.points.iter().map(|point| point.position).collect(),
            pixels: pixels_of(&figure),
            figure: figure.clone(),
            operations: Vec::new(),
        };
        report.as_ref().and_then(|report| task(asked, subject, &see, (&title, &text, report), faults))
    } else {
        report.filter(|_| to_try.is_table()).map(|report| Task::Try(goal(to_try, &figure, &report, faults)))
    };
    let links = links.into_iter().filter_map(|section| section.finished(faults, link)).collect();
    let sentence = sentence.cloned();
    Step { title, text, sentence, notes, figure: Arc::new(figure), seconds, task, see, links }
}

/// `see`: the figure of the next step, or this one after operations and with other values of keys.
fn see(section: &mut Section<'_>, figure: &Figure) -> See {
    if !section.is_present("see") {
        return See::Nothing;
    }
    if section.is_list("see") {
        let way = section.list("see", Allowed::Ways, way);
        let goal = Goal { text: Localized::default(), until: Vec::new(), way };
        let after = Camera::new(&figure.camera).ok().and_then(|camera| goal.reached_from(figure, &camera).ok());
        if let Some(after) = after.filter(|_| !goal.way.is_empty()) {
            return See::Changed(Arc::new(after.figure));
        }
    } else if section.get("see", &TEXT).is_some_and(|text| text == "next") {
        return See::Next;
    }
    section.refuse("see", Allowed::Seen);
    See::Nothing
}

/// A text with the numbers of a figure, and with a sentence that may stand in it. Without a report they aren't checked.
/// It's empty if the key is missing.
fn with_numbers(
    section: &mut Section<'_>,
    key: &'static str,
    sentence: Option<&Localized>,
    report: Option<&Report>,
) -> Localized {
    if !section.is_present(key) {
        return Localized::default();
    }
    let Some(texts) = section.told(key) else { return Localized::default() };
    if let Some(report) = report {
        match in_each(&with_sentence(&texts, sentence), report) {
            Ok(filled) => drop(harmless(section, key, filled)),
            Err(found) => section.fault(key, Problem::Value { found, allowed: Allowed::Quantity }),
        }
    }
    texts.map(|_, text| text.replace("\r\n", "\n"))
}

/// A text in each language with the numbers of a report.
fn in_each(text: &Localized, report: &Report) -> Result<Localized, String> {
    text.try_map(|tag, text| filled(text, report, DecimalMark::of_language(tag)))
}

/// `[step.ask]`: an exercise of the program, or a question of its own.
fn task(
    mut section: Section<'_>,
    subject: Subject,
    see: &See,
    (title, told, report): (&Localized, &Localized, &Report),
    faults: &mut Vec<Fault>,
) -> Option<Task> {
    if section.is_present("exercise") {
        let exercise = exercise(&mut section);
        faults.extend(section.finish());
        return exercise.map(|(id, seed)| Task::Exercise { id, seed });
    }
    let at = section.at;
    let figure = subject.figure.clone();
    // A place refers to the figure that comes after the question. Coordinates are those of the step.
    let after = match see {
        See::Changed(after) if section.is_present("place") => {
            Subject { figure: Figure::clone(after), ..subject.clone() }
        }
        _ => subject.clone(),
    };
    let mut entry = question(section, [subject, after], title.clone(), faults)?;
    // Coordinates that the step prints needn't be computed.
    entry.with_views_given(|point| told.en.contains(&format!("{{points.{point}.view")));
    if let Err(found) = entry.with_texts(|text| {
        *text = in_each(text, report)?;
        Ok(())
    }) {
        let problem = Problem::Value { found, allowed: Allowed::Quantity };
        faults.push(Fault { at, key: "[step.ask] text".to_owned(), problem });
    }
    entry.id = Cow::Owned(question_id(&entry, &figure));
    Some(Task::Question(Arc::new(entry)))
}

/// The identifier of a question, from its content. Answers are stored under it, so they belong to the question in any
/// place of any lesson. A changed question is another one.
fn question_id(entry: &Entry, figure: &Figure) -> String {
    let exercise = entry.exercise(0, &Default::default());
    // The question doesn't depend on the step's title.
    let mut content = vec![update("", &Figure { title: None, ..figure.clone() })];
    let mut add = |text: &Localized| content.extend([text.en.clone(), text.pt_br.clone()]);
    exercise.asks.iter().flat_map(|ask| ask.own_choices.values()).for_each(&mut add);
    exercise.texts.iter().flat_map(|texts| texts.asks.values()).for_each(add);
    for ask in &exercise.asks {
        // An answer is stored by its fields, and a choice by its name.
        let [rows, columns] = ask.shape();
        content.push(format!("{rows} {columns}"));
        if let Kind::Choice(choices) = &ask.kind {
            content.extend(choices.iter().cloned());
        }
    }
    // FNV-1a, because it has to give the same in every version of the program.
    let byte = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let hash = content.join("\0").bytes().fold(0xcbf2_9ce4_8422_2325, byte);
    format!("question-{hash:016x}")
}

/// `exercise` and `seed`.
fn exercise(section: &mut Section<'_>) -> Option<(String, u64)> {
    let id = section.get("exercise", &TEXT);
    let seed = section.get("seed", &integer_in::<i64>([0, i64::MAX])).map_or(0, i64::cast_unsigned);
    if id.as_ref().is_some_and(|id| exercises::entry(id).is_none()) {
        section.refuse("exercise", Allowed::Exercise);
        return None;
    }
    id.map(|id| (id, seed))
}

fn goal(mut section: Section<'_>, figure: &Figure, report: &Report, faults: &mut Vec<Fault>) -> Goal {
    section.require("text", Allowed::Bilingual);
    let text = with_numbers(&mut section, "text", None, Some(report));
    let written = section.list("way", Allowed::Ways, way);
    let conditions = section.sections("until", "[step.try] until.");
    if conditions.is_empty() && section.faults.is_empty() {
        section.missing("until", Allowed::Sections);
    }
    let count = conditions.len();
    if count > MAX_CONDITIONS {
        section.fault("until", Problem::TooMany { count, limit: MAX_CONDITIONS });
    }
    let goal = Goal {
        text,
        until: conditions
            .into_iter()
            .take(MAX_CONDITIONS)
            .filter_map(|section| section.finished(faults, |section| condition(section, figure, report)))
            .collect(),
        way: written,
    };
    let excluded = |k: usize| goal.until.iter().take(k).any(|earlier| earlier.excludes(&goal.until[k]));
    if (0..goal.until.len()).any(excluded) {
        section.refuse("until", Allowed::Compatible);
    }
    if let Ok(camera) = Camera::new(&figure.camera)
        && goal.reached_from(figure, &camera).is_err()
    {
        section.refuse("way", Allowed::Ways);
    }
    faults.extend(section.finish());
    goal
}

fn condition(section: &mut Section<'_>, figure: &Figure, report: &Report) -> Option<Condition> {
    let [seen, hidden, path, key] = ["seen", "hidden", "quantity", "key"].map(|key| section.get(key, &TEXT));
    let angle = section.is_present("angle");
    let named = [angle, seen.is_some(), hidden.is_some(), path.is_some(), key.is_some()];
    match (seen, hidden, path, key) {
        _ if named.iter().filter(|is_named| **is_named).count() != 1 => {
            section.missing("quantity", Allowed::Either("quantity, angle, key, seen", "hidden"));
            None
        }
        (Some(name), ..) => Some(Condition::Seen(name)),
        (_, Some(name), ..) => Some(Condition::Hidden(name)),
        (.., Some(path), _) => {
            let known = QuantityPath::of(&path).filter(|path| path.numbers(report).is_some());
            if known.is_none() {
                section.refuse("quantity", Allowed::Quantity);
            }
            let range = range(section, path == "camera.view_angle");
            known.zip(range).map(|(path, range)| Condition::Quantity { path, range })
        }
        (.., Some(key)) => of_key(section, key, figure),
        _ => {
            let paths = section.list("angle", Allowed::TwoVectors, QuantityPath::of);
            let between: Option<[QuantityPath; 2]> = paths.try_into().ok();
            let between = between.filter(|between| angle_between(*between, report).is_some());
            if between.is_none() && section.faults.is_empty() {
                section.refuse("angle", Allowed::TwoVectors);
            }
            let range = range(section, true);
            between.zip(range).map(|(between, range)| Condition::Angle { between, range })
        }
    }
}

/// `least` and `most`, at least one of which is there.
fn range(section: &mut Section<'_>, is_angle: bool) -> Option<Range> {
    let [least, most] = ["least", "most"].map(|key| {
        section.is_present(key).then(|| section.get(key, if is_angle { &ANGLE } else { &NUMBER }).unwrap_or(0.0))
    });
    let range = Range { least, most };
    if range.is_everything() {
        section.missing("least", Allowed::Number);
    } else if range.is_empty() {
        section.refuse("least", Allowed::NotAbove("most"));
    }
    Some(range).filter(|range| !range.is_everything())
}

/// A condition on a key of the figure: the value that it `is`, or `least` and `most` of its number.
fn of_key(section: &mut Section<'_>, key: String, figure: &Figure) -> Option<Condition> {
    let value = section.written("is");
    if value.is_some() && (section.is_present("least") || section.is_present("most")) {
        section.refuse("is", Allowed::Either("is", "least and most"));
        return None;
    }
    let (tried, written) = match &value {
        Some(value) => ("is", Some(value.clone())),
        None if section.is_present("least") => ("least", section.written("least")),
        None => ("most", section.written("most")),
    };
    let Some(written) = written else {
        section.missing("is", Allowed::Either("is", "least and most"));
        return None;
    };
    // A key is known, and a value possible, if the figure of the step can have it.
    match varied(figure, &key, &written) {
        Err(FigureError { problem: Problem::UnknownKey { near, known }, .. }) => {
            section.fault("key", Problem::Value { found: key, allowed: Allowed::Word { words: known, near } });
            return None;
        }
        // Only this value is judged, not the keys that need it. A camera may become possible on the way.
        Err(FigureError { problem, key: found, .. })
            if !matches!(problem, Problem::Camera(_))
                && key.rsplit('.').next().is_some_and(|last| found.ends_with(last)) =>
        {
            section.fault(tried, problem);
            return None;
        }
        Ok(_) | Err(_) => {}
    }
    match value {
        Some(value) => Some(Condition::Key { key, value }),
        None => {
            let is_angle = ["angle", "azimuth", "elevation", "roll"].iter().any(|angle| key.ends_with(angle));
            range(section, is_angle).map(|range| Condition::Number { key, range })
        }
    }
}

fn link(section: &mut Section<'_>) -> Option<Link> {
    let [note, lesson] = ["note", "lesson"].map(|key| section.get(key, &TEXT));
    let exercise = section.is_present("exercise").then(|| exercise(section)).flatten();
    let step =
        section.get("step", &integer_in::<u32>([1, MAX_LESSON_STEPS as i64])).map_or(0, |step| step as usize - 1);
    if section.is_present("step") && lesson.is_none() {
        section.refuse("step", Allowed::Either("note, exercise", "lesson"));
    }
    match (note, lesson, exercise) {
        (Some(note), None, None) => Some(Link::Note(note)),
        (None, Some(lesson), None) => Some(Link::Lesson(lesson, step)),
        (None, None, Some((id, seed))) => Some(Link::Exercise(id, seed)),
        _ if !section.faults.is_empty() => None,
        _ => {
            section.missing("note", Allowed::Either("note, exercise", "lesson"));
            None
        }
    }
}
