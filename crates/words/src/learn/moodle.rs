//! Exercises as a bank of questions for Moodle, in its XML format.
//!
//! A number is a question of its kind, a choice too. Several numbers are one question with a field for each (*cloze*).
//! Moodle knows absolute tolerances only, so each number has its own. Known mistakes are wrong answers with feedback:
//! the sentence that the program itself gives to that answer.

use super::{exercise_messages, exercises};
use crate::Lang;
use crate::exercises::{Ask, Entry, Exercise, Kind, Slip, Slips, Table, check};

/// A right number, or a wrong one with the sentence about it.
struct Known {
    value: f64,
    tolerance: f64,
    /// Empty for a right number.
    feedback: String,
}

/// The bank, and the titles of the exercises that can't be such questions.
pub fn moodle(lang: Lang, sheet: &[(&Entry, &Exercise)]) -> (String, Vec<String>) {
    let (mut text, mut left_out) = (String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n"), Vec::new());
    let mut category = "";
    for (entry, exercise) in sheet {
        let title = exercises::exercise_title(lang, exercise);
        if !is_question(exercise) {
            left_out.extend((!left_out.contains(&title.to_owned())).then(|| title.to_owned()));
            continue;
        }
        if category != title {
            text += &format!(
                "<question type=\"category\"><category><text>{}</text></category></question>\n",
                escaped(&format!("$course$/top/Camera Lab/{}", title.replace('/', "//")))
            );
            category = title;
        }
        text += &question(lang, entry, exercise);
    }
    (text + "</quiz>\n", left_out)
}

/// False for a figure to match, a camera, and points in any order: no field of Moodle can hold them.
fn is_question(exercise: &Exercise) -> bool {
    exercise.figure_to_match().is_none()
        && exercise.asks.iter().all(|ask| !matches!(ask.kind, Kind::Camera) && !ask.any_order)
}

fn question(lang: Lang, entry: &Entry, exercise: &Exercise) -> String {
    let statement = exercises::statement(lang, exercise);
    let assumptions = exercises::assumptions(lang, exercise);
    let mut html: String = statement.iter().chain(&assumptions).map(|text| paragraph(text)).collect();
    let (kind, answers) = match &exercise.asks[..] {
        [ask] if matches!(ask.kind, Kind::Number) => {
            html += &paragraph(&exercises::ask(lang, exercise, ask));
            let known = known_numbers(lang, entry, exercise, ask);
            ("numerical", known.first().into_iter().flatten().map(number_answer).collect())
        }
        [ask] if matches!(ask.kind, Kind::Choice(_)) => {
            html += &paragraph(&exercises::ask(lang, exercise, ask));
            let choices = choices(lang, entry, exercise, ask);
            ("multichoice", choices.iter().map(choice_answer).collect::<String>() + "<single>true</single>\n")
        }
        asks => {
            for ask in asks {
                let (asked, kind) = (exercises::ask(lang, exercise, ask), exercises::kind(lang, ask));
                html += &paragraph(&format!("{asked} ({kind})"));
                html += &fields(lang, entry, exercise, ask);
            }
            ("cloze", String::new())
        }
    };
    let steps = exercise.new_steps();
    let steps = steps.iter().flatten().map(|step| exercises::step(lang, exercise, step, 5));
    let solution: String = steps.map(|step| paragraph(&step)).collect();
    let name = format!(
        "{} ({})",
        exercises::exercise_title(lang, exercise),
        exercise_messages::source_of_numbers(lang, exercise)
    );
    format!(
        "<question type=\"{kind}\">\n<name><text>{}</text></name>\n<questiontext format=\"html\"><text>{}</text></questiontext>\n\
         <generalfeedback format=\"html\"><text>{}</text></generalfeedback>\n<penalty>0.3333333</penalty>\n{answers}</question>\n",
        escaped(&name),
        escaped(&html),
        escaped(&solution)
    )
}

fn number_answer(known: &Known) -> String {
    let fraction = if known.feedback.is_empty() { 100 } else { 0 };
    format!(
        "<answer fraction=\"{fraction}\"><text>{:?}</text><tolerance>{:?}</tolerance><feedback format=\"html\"><text>{}</text></feedback></answer>\n",
        known.value,
        known.tolerance,
        escaped(&inline(&known.feedback))
    )
}

fn choice_answer((text, is_right, feedback): &(String, bool, String)) -> String {
    format!(
        "<answer fraction=\"{}\" format=\"html\"><text>{}</text><feedback format=\"html\"><text>{}</text></feedback></answer>\n",
        if *is_right { 100 } else { 0 },
        escaped(&inline(text)),
        escaped(&inline(feedback))
    )
}

/// The choices of a question: each text, whether it's right, and the sentence about it.
fn choices(lang: Lang, entry: &Entry, exercise: &Exercise, ask: &Ask) -> Vec<(String, bool, String)> {
    let Kind::Choice(names) = &ask.kind else { return Vec::new() };
    let choice = |name: &String| {
        let text = exercises::choice_of(lang, ask, name).to_owned();
        let judged = check(entry, exercise, ask, name).ok();
        let is_right = judged.as_ref().is_some_and(|judged| judged.right);
        let feedback = judged.as_ref().and_then(|judged| exercises::diagnosis(lang, ask, judged));
        (text, is_right, feedback.unwrap_or_default())
    };
    names.iter().map(choice).collect()
}

/// The fields of a question with several, in HTML.
fn fields(lang: Lang, entry: &Entry, exercise: &Exercise, ask: &Ask) -> String {
    if matches!(ask.kind, Kind::Choice(_)) {
        let option = |(text, is_right, feedback): &(String, bool, String)| {
            format!("{}{}#{}", if *is_right { "=" } else { "" }, in_field(&inline(text)), in_field(&inline(feedback)))
        };
        let options: Vec<String> = choices(lang, entry, exercise, ask).iter().map(option).collect();
        return format!("<p>{{1:MULTICHOICE_V:{}}}</p>\n", options.join("~"));
    }
    let field = |known: &Vec<Known>| {
        let answer = |known: &Known| {
            let share = if known.feedback.is_empty() { "=" } else { "%0%" };
            format!("{share}{:?}:{:?}#{}", known.value, known.tolerance, in_field(&inline(&known.feedback)))
        };
        format!("{{1:NUMERICAL:{}}}", known.iter().map(answer).collect::<Vec<_>>().join("~"))
    };
    let fields: Vec<String> = known_numbers(lang, entry, exercise, ask).iter().map(field).collect();
    let columns =
        ask.expected().table().map_or(1, |table| if ask.shape()[1] > 1 { table.columns } else { fields.len() });
    let rows = fields.chunks(columns.max(1)).map(|row| {
        let cells: String = row.iter().map(|field| format!("<td>{field}</td>")).collect();
        format!("<tr>{cells}</tr>")
    });
    format!("<table>{}</table>\n", rows.collect::<String>())
}

/// For each number of an answer, the right ones (one for each reading of the question), and then those that known
/// mistakes give.
fn known_numbers(lang: Lang, entry: &Entry, exercise: &Exercise, ask: &Ask) -> Vec<Vec<Known>> {
    let Some(right) = ask.expected().table() else { return Vec::new() };
    let mut known: Vec<Vec<Known>> = right.entries.iter().map(|_| Vec::new()).collect();
    let tables = ask.readings.iter().filter_map(|reading| reading.expected.table());
    for table in tables.filter(|table| table.shape() == right.shape()) {
        for (known, value) in known.iter_mut().zip(table.entries) {
            let is_there = known.iter().any(|other| (other.value - value).abs() <= other.tolerance);
            known.extend((!is_there).then(|| Known {
                value,
                tolerance: tolerance(ask, value),
                feedback: String::new(),
            }));
        }
    }
    for slip in Slip::ALL {
        let Some(wrong) = ask.expected().slipped(Slips::one(*slip)).filter(|wrong| wrong.shape() == right.shape())
        else {
            continue;
        };
        if wrong.entries == right.entries {
            continue;
        }
        let Ok(judged) = check(entry, exercise, ask, &typed(&wrong)) else { continue };
        let Some(feedback) = exercises::diagnosis(lang, ask, &judged).filter(|_| !judged.right) else { continue };
        for (known, &value) in known.iter_mut().zip(&wrong.entries) {
            let nearest = known.iter().filter(|other| other.feedback.is_empty());
            let apart =
                nearest.map(|other| (other.value - value).abs() - other.tolerance).fold(f64::INFINITY, f64::min);
            if apart <= 0.0 {
                continue;
            }
            let same = known
                .iter_mut()
                .find(|other| !other.feedback.is_empty() && (other.value - value).abs() <= other.tolerance);
            match same {
                Some(same) if !same.feedback.contains(&feedback) => {
                    same.feedback = format!("{} {feedback}", same.feedback);
                }
                Some(_) => {}
                None => {
                    let tolerance = tolerance(ask, value).min(0.5 * apart);
                    known.push(Known { value, tolerance, feedback: feedback.clone() });
                }
            }
        }
    }
    known
}

/// The absolute tolerance of a number: that of the question at this size, or half a unit of its third digit, because a
/// number that's rounded to three digits is right.
fn tolerance(ask: &Ask, value: f64) -> f64 {
    if ask.whole {
        return 1e-6;
    }
    if value.abs() <= 1e-9 * ask.tolerance {
        return ask.tolerance;
    }
    let third_digit = 10.0_f64.powf(value.abs().log10().floor() - 2.0);
    ask.tolerance.min(ask.share * value.abs()).max(0.5 * third_digit * (1.0 + 1e-9))
}

/// Numbers as a student would type them.
fn typed(table: &Table) -> String {
    let row = |row: &[f64]| row.iter().map(|entry| format!("{entry:?}")).collect::<Vec<_>>().join(", ");
    match table.shape() {
        [1, 1] => row(&table.entries),
        [_, 1] => format!("[{}]", row(&table.entries)),
        _ => format!("[{}]", table.rows().map(|entries| format!("[{}]", row(entries))).collect::<Vec<_>>().join(", ")),
    }
}

/// Characters that would end an answer or its feedback in a field, after backslashes.
fn in_field(text: &str) -> String {
    text.chars().flat_map(|c| "}#~/\"\\".contains(c).then_some('\\').into_iter().chain([c])).collect()
}

/// Markdown and mathematics as a paragraph of HTML.
fn paragraph(markdown: &str) -> String {
    let text = inline(markdown).replace('\n', "<br>");
    format!("<p>{text}</p>\n")
}

/// Markdown as HTML, and mathematics for the filter of Moodle.
fn inline(markdown: &str) -> String {
    let plain = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let marked = |text: &str, mark: &str, tag: &str| -> String {
        let part =
            |(k, part): (usize, &str)| if k % 2 == 1 { format!("<{tag}>{part}</{tag}>") } else { part.to_owned() };
        text.split(mark).enumerate().map(part).collect()
    };
    let texts = |text: &str| marked(&marked(&marked(&plain(text), "**", "strong"), "*", "em"), "`", "code");
    let inner = |text: &str| -> String {
        let part = |(k, part): (usize, &str)| if k % 2 == 1 { format!("\\({}\\)", plain(part)) } else { texts(part) };
        text.split('$').enumerate().map(part).collect()
    };
    let part = |(k, part): (usize, &str)| if k % 2 == 1 { format!("\\[{}\\]", plain(part)) } else { inner(part) };
    markdown.split("$$").enumerate().map(part).collect()
}

/// A text in XML.
fn escaped(text: &str) -> String {
    format!("<![CDATA[{}]]>", text.replace("]]>", "]]]]><![CDATA[>"))
}
