//! The texts of lessons with their numbers, and the words around them, in both languages.

use serde_json::Value;

use crate::figure::{Figure, Localized};
use crate::inspect::Report;
use crate::lessons::{self, Lesson, Question, Step, Task};
use crate::numbers::significant;
use crate::sanitize::escaped;
pub use crate::told;
use crate::{exercises, told_mut};

texts!("learn/lessons");

/// A text with the numbers of a figure. Left as written if the figure has none.
pub fn filled(lang: Lang, text: &Localized, figure: &Figure) -> String {
    match lessons::numbers_of(figure) {
        Ok(report) => filled_from(lang, text, &report),
        Err(_) => told(lang, text).to_owned(),
    }
}

/// A text with the numbers of a report. Left as written if the report lacks one of them.
pub fn filled_from(lang: Lang, text: &Localized, report: &Report) -> String {
    let text = told(lang, text);
    lessons::filled(text, report, lang.mark()).unwrap_or_else(|_| text.to_owned())
}

/// The text of a step, in Markdown.
pub fn text(lang: Lang, step: &Step) -> String {
    filled(lang, &lessons::with_sentence(&step.text, step.sentence.as_ref()), &step.figure)
}

/// The speaker's notes of a step, in Markdown.
pub fn notes(lang: Lang, step: &Step) -> Option<String> {
    step.notes.as_ref().map(|notes| filled(lang, notes, &step.figure))
}

/// A lesson to read in a terminal.
pub fn to_read(lang: Lang, lesson: &Lesson) -> String {
    let t = texts(lang);
    let mut out = format!("{} ({})\n", told(lang, &lesson.title), lesson.id);
    if !lesson.aims.is_empty() {
        out.push_str(&format!("\n{}:\n", t.aims));
        lesson.aims.iter().for_each(|aim| out.push_str(&format!("- {}\n", told(lang, aim).trim())));
    }
    if let Some(plan) = &lesson.plan {
        out.push_str(&format!("\n{}:\n\n{}\n", t.plan, told(lang, plan).trim()));
    }
    out.push_str(&questions(lang, t.pretest, &lesson.pretest));
    for (k, step) in lesson.steps.iter().enumerate() {
        out.push_str(&format!("\n{}. {}\n\n{}\n", k + 1, told(lang, &step.title), text(lang, step).trim()));
        match &step.task {
            Some(Task::Exercise { id, seed }) => {
                out.push_str(&format!("\n{}: camera-lab exercise show {id} --seed {seed}\n", t.question));
            }
            Some(Task::Question(entry)) => {
                let exercise = entry.exercise(0, &Default::default());
                for ask in &exercise.asks {
                    let asked = super::exercises::ask(lang, &exercise, ask);
                    out.push_str(&format!(
                        "\n{}: {} ({})\n",
                        t.question,
                        asked.trim(),
                        super::exercises::kind(lang, ask)
                    ));
                }
            }
            Some(Task::Try(goal)) => {
                out.push_str(&format!("\n{}: {}\n", t.to_try, filled(lang, &goal.text, &step.figure).trim()));
            }
            None => {}
        }
    }
    if let Some(sentence) = &lesson.sentence {
        out.push_str(&format!("\n{}: {}\n", t.keep, told(lang, sentence).trim()));
    }
    out.push_str(&questions(lang, t.posttest, &lesson.posttest));
    out
}

/// The questions before or after a lesson, each with the command that prints it. Empty if there are none.
fn questions(lang: Lang, heading: &str, questions: &[Question]) -> String {
    let line = |question: &Question| {
        let title = exercises::entry(&question.id).map(|entry| super::exercises::title(lang, entry));
        let Question { id, seed } = question;
        format!("- {}: camera-lab exercise show {id} --seed {seed}\n", title.unwrap_or_default())
    };
    let lines: String = questions.iter().map(line).collect();
    if lines.is_empty() { lines } else { format!("\n{heading}:\n{lines}") }
}

/// The titles of the exercises that a lesson leads to, each once.
pub fn exercises_of(lang: Lang, lesson: &Lesson) -> Vec<&'static str> {
    lessons::exercises_of(lesson)
        .into_iter()
        .filter_map(|id| Some(super::exercises::title(lang, exercises::entry(id)?)))
        .collect()
}

texts_with_values! {
    /// A step was added to a file.
    step_added(lang, file: &str, number: usize);

    /// Another program has changed the file of the lesson.
    changed_elsewhere(lang, file: &str): (file, again = texts(lang).read_again);

    /// The tasks of a lesson that are done.
    answered(lang, done: usize, all: usize);

    /// A key of a lesson names another lesson that doesn't exist.
    no_lesson(lang, key: &str, id: &str): (key, id = escaped(id));

    /// A key of a lesson names a note that doesn't exist.
    no_note(lang, key: &str, id: &str): (key, id = escaped(id));

    /// A message about a step, from 1.
    of_step(lang, number: usize, why: &str);

    /// There is no step with this number.
    no_step(lang, found: &str, count: usize): (found = escaped(found), count);

    /// A link names a step that its lesson doesn't have.
    no_step_of(lang, key: &str, step: usize, count: usize);

    /// The goal of a step holds from the start.
    reached_already(lang, key: &str);

    /// The way of a goal doesn't lead to it.
    not_reached(lang, key: &str);

    /// A handout has another number of steps on a page.
    per_page(lang, found: &str): (found = escaped(found));

    /// Pictures of a lesson for a file that can hold only one.
    output_name(lang, path: &str);
}

/// The titles of the recorded step with this number, in the author's language alone: the other language shows the same
/// until it has a title.
pub fn draft(lang: Lang, number: usize) -> lessons::Draft {
    let t = texts(lang);
    let alone = |text: String| {
        let mut both = Localized::default();
        *told_mut(lang, &mut both) = text;
        both
    };
    lessons::Draft { lesson: alone(t.new_lesson.to_owned()), title: alone(format!("{} {number}", t.step)) }
}

/// The title of a lesson, and the minutes that it takes, and those of its exercises.
pub fn with_minutes(lang: Lang, lesson: &Lesson) -> String {
    let more = lessons::exercise_minutes(lesson);
    let minutes = lesson.minutes.map_or_else(String::new, |minutes| {
        let minutes = significant(minutes, 3) + " min";
        let all = if more > 0 { text!(lang, minutes_and_exercises, minutes, more) } else { minutes };
        format!(" ({all})")
    });
    format!("{}{minutes}", told(lang, &lesson.title))
}

/// The step of how many.
pub fn place(lang: Lang, number: usize, of: usize) -> String {
    let t = texts(lang);
    format!("{} {number} {} {of}", t.step, t.of)
}

/// The way on: the title of a lesson and a step of it, from 0.
pub fn go_on(lang: Lang, lesson: &Lesson, step: usize) -> String {
    let step_word = texts(lang).step.to_lowercase();
    format!("{}, {step_word} {}", told(lang, &lesson.title), step + 1)
}

/// A line of the list of lessons, from its data.
pub fn line(lang: Lang, line: &Value) -> String {
    let text = |key: &str| line[key].as_str().unwrap_or_default();
    let minutes = line["minutes"].as_f64().map_or_else(String::new, |minutes| {
        let more = line["exercise_minutes"].as_u64().filter(|more| *more > 0);
        significant(minutes, 3) + &more.map_or_else(String::new, |more| format!(" + {more}")) + " min"
    });
    let steps = text!(lang, line);
    format!("{:<16} {:>12} {:>3} {steps}   {}\n", text("id"), minutes, line["steps"], text("title"))
}

/// There is no such lesson.
pub fn unknown(lang: Lang, id: &str, near: Option<&str>) -> String {
    let id = escaped(id);
    match near {
        Some(near) => text!(lang, unknown_some, id, near),
        None => text!(lang, unknown_none, id),
    }
}

/// A lesson lacks a part that another lecturer needs.
pub fn no_part(lang: Lang, key: &str) -> String {
    let why = match key {
        "aims" => text!(lang, no_part_aims),
        "plan" => text!(lang, no_part_plan),
        _ => text!(lang, no_part_sentence),
    };
    text!(lang, no_part, key, why)
}

/// The name of a link to a step of a lesson: its title, and the number of the step unless it's the first.
pub fn lesson_link(lang: Lang, lesson: &Lesson, step: usize) -> String {
    let t = texts(lang);
    let title = told(lang, &lesson.title);
    if step == 0 {
        format!("{}: {title}", t.see_lesson)
    } else {
        format!("{}: {title}, {} {}", t.see_lesson, t.step.to_lowercase(), step + 1)
    }
}

/// An option of handouts with a folder of pictures, or the other way round.
pub fn unused_option(lang: Lang, option: &str, is_handout: bool) -> String {
    if is_handout {
        return text!(lang, unused_option_is_handout, option);
    }
    text!(lang, unused_option, option)
}

/// All files hold good lessons.
pub fn all_good(lang: Lang, count: usize) -> String {
    match count {
        1 => text!(lang, all_good_one).to_owned(),
        _ => text!(lang, all_good_many, count),
    }
}
