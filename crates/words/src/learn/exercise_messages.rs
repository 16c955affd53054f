//! The words of the command line about exercises, besides the exercises themselves.

use super::exercises::mistake;
use super::{exercises, lessons};
use crate::exercises::{Ask, Exercise, Judged, Why};
use crate::lessons::lesson_of;
use crate::sanitize::escaped;
use crate::told;

texts!("learn/exercise_messages");

/// An identifier that no exercise has.
pub fn unknown_exercise(lang: Lang, id: &str, near: Option<&str>) -> String {
    let id = escaped(id);
    let meant = near.map(|near| text!(lang, unknown_exercise_meant, near)).unwrap_or_default();
    text!(lang, unknown_exercise, id, meant)
}

texts_with_values! {
    /// An answer to an unknown question.
    unknown_ask(lang, id: &str, name: &str, asks: &[&str]): (id, name = escaped(name), asks = asks.join(", "));

    /// The same question answered twice.
    answered_twice(lang, name: &str): (name = escaped(name));

    /// A file of a folder that isn't an exercise, if the others are used.
    passed_over(lang, why: &str);

    /// An answer that can't be read. It hasn't been judged.
    unreadable(lang, name: &str, why: &str);

    /// `--hints` that isn't a number of hints.
    hints_range(lang, text: &str): (text = escaped(text));

    /// The number of right entries.
    score(lang, right: usize, all: usize);

    /// The titles of the exercises that are due to come back, and the minutes that they take.
    due(lang, minutes: u16, titles: &str);

    /// The number of right entries or conditions of a wrong answer.
    right_of(lang, right: usize, all: usize);

    /// A sheet with an ending that can't be written.
    sheet_ending(lang, path: &str);

    /// A picture of an exercise that doesn't have one.
    no_picture(lang, id: &str);

    /// A picture with an ending that can't be written.
    picture_ending(lang, path: &str);

    /// The progress is deleted, and still in the file at `path`.
    progress_deleted(lang, path: &str);

    /// An exercise that no question of Moodle can hold.
    no_question(lang, title: &str);

    /// The name of a version of a sheet.
    version(lang, number: u64);

    /// `--seed` that isn't a range of seeds of a sheet.
    seeds(lang, text: &str, most: u32): (text = escaped(text), most);

    /// `--pass` that isn't a percentage.
    pass(lang, text: &str): (text = escaped(text));

    /// The place of a point in the image, in whole pixels.
    lands(lang, place: [f64; 2]): (pixel = lang.mark().tuple(&place.map(f64::floor), 5));
}

/// Markdown without its marks, and mathematics in a line, also if it had one of its own.
pub fn plain(markdown: &str) -> String {
    let part =
        |(k, part): (usize, &str)| if k % 2 == 1 { crate::why::notes::plain(part) } else { part.replace("**", "") };
    markdown.replace("\n\n$$", " $").replace("$$", "$").split('$').enumerate().map(part).collect()
}

/// An exercise's identifier with the seed of its numbers, or the remark that they're the same for everybody.
pub fn source_of_numbers(lang: Lang, exercise: &Exercise) -> String {
    if crate::exercises::entry(&exercise.id).is_some_and(|entry| entry.is_family) {
        format!("{}, {} {}", exercise.id, texts(lang).seed, exercise.seed)
    } else {
        format!("{}, {}", exercise.id, text!(lang, same_for_everybody))
    }
}

/// The reason why a file was skipped, if others were too.
pub fn and_more(lang: Lang, why: &str, more: usize) -> String {
    match more {
        1 => text!(lang, and_more_one, why),
        _ => {
            text!(lang, and_more_many, why, more)
        }
    }
}

/// An answer without `=`.
pub fn answer_form(lang: Lang, text: &str) -> String {
    format!("--answer {}: {}", escaped(text), name_and_value(lang))
}

/// `--with` that can't be used.
pub fn with(_lang: Lang, text: &str, why: &str) -> String {
    format!("--with {}: {why}", escaped(text))
}

/// A number that the exercise doesn't leave open.
pub fn not_free(lang: Lang, id: &str, name: &str, free: &[&str]) -> String {
    let name = escaped(name);
    if free.is_empty() {
        return text!(lang, not_free_free, id, name);
    }
    text!(lang, not_free, id, name, free = free.join(", "))
}

/// The expected form.
pub const fn name_and_value(lang: Lang) -> &'static str {
    text!(lang, name_and_value)
}

/// The expected range.
pub const fn greater_than_zero(lang: Lang) -> &'static str {
    text!(lang, greater_than_zero)
}

/// Hints for a wrong answer, weaker ones first. None for a right one.
pub fn hints(lang: Lang, exercise: &Exercise, ask: &Ask, verdict: &Judged) -> Vec<String> {
    /// Digits of the numbers in the first step.
    const DIGITS: usize = 6;
    match &verdict.diagnosis {
        // On a fault each answer has its sentence.
        _ if verdict.right || !verdict.carried.is_empty() || ask.fault.is_some() => Vec::new(),
        // The reason has been given.
        _ if verdict.numbers.as_ref().is_some_and(|own| own.instead.is_some()) => Vec::new(),
        Some(diagnosis) => exercises::hints(lang, ask, diagnosis).into_iter().map(str::to_owned).collect(),
        None => {
            let steps = exercises::steps(lang, exercise, ask, DIGITS);
            let first = steps.get(verdict.first_step).and_then(|step| step.lines().next()).map(str::to_owned);
            let way = lesson_of(&exercise.id);
            let keep = way.and_then(|way| {
                let sentence = way.lesson.sentence.as_ref().map(|sentence| told(lang, sentence).trim().to_owned())?;
                Some(format!("{sentence} ({})", lessons::lesson_link(lang, &way.lesson, way.step)))
            });
            exercises::hints_without_diagnosis(lang, verdict, (keep, first.as_deref()))
        }
    }
}

/// The reason why an exercise is the next to practise.
pub fn why(lang: Lang, why: Why) -> String {
    match why {
        Why::Mistake(made, 1) => text!(lang, why_mistake_once, mistake = mistake(lang, made)[0]),
        Why::Mistake(made, times) => text!(lang, why_mistake_times, times, mistake = mistake(lang, made)[0]),
        Why::Begun => text!(lang, why_begun).to_owned(),
        Why::Due(1) => text!(lang, why_due_day).to_owned(),
        Why::Due(days) => text!(lang, why_due_days, days),
        Why::Guess(1) => text!(lang, why_guess_day).to_owned(),
        Why::Guess(days) => text!(lang, why_guess_days, days),
        Why::NotSolved => text!(lang, why_not_solved).to_owned(),
        Why::Sure => text!(lang, why_sure).to_owned(),
        Why::LongestAgo => text!(lang, why_longest_ago).to_owned(),
    }
}

/// The distance of an answer from the right place in the image, pixels to the right and down, and that place.
pub fn off(lang: Lang, [x, y]: [f64; 2]) -> String {
    let distance = x.hypot(y);
    let by = lang.mark().number(distance.round(), 5);
    let is_far = |part: f64| part.abs() >= 0.25 * distance && part.abs() >= 0.5;
    let across = is_far(x).then_some(match x > 0.0 {
        true => text!(lang, off_left),
        false => text!(lang, off_right),
    });
    let down = is_far(y).then_some(match y > 0.0 {
        true => text!(lang, off_higher),
        false => text!(lang, off_lower),
    });
    let ways: Vec<&str> = across.into_iter().chain(down).collect();
    if ways.is_empty() {
        return text!(lang, off_ways).to_owned();
    }
    let ways = ways.join(text!(lang, off_and));
    text!(lang, off, by, ways)
}
