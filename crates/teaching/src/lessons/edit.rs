//! Changes that an author makes to a lesson file in the window: texts, figures, and the order of steps.

use std::borrow::Cow;

use toml_edit::{Array, Document, DocumentMut, Item, Table};

use super::items::{number_item, told, told_if_any, told_item};
use super::lesson::Lesson;
use super::read::parse;
use super::task_text::TaskText;
use crate::figure::{Difference, Figure, FigureError, Localized, difference};

/// The keys of a step that don't belong to its figure.
const WORDS: [&str; 7] = ["title", "text", "notes", "seconds", "ask", "try", "links"];

/// A text of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StepText {
    /// Its title, one line.
    Title,
    /// Its text. An empty one removes it.
    Text,
    /// The notes of the speaker. An empty text removes them.
    Notes,
}

/// A text of the whole lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LessonText {
    /// Its title, one line.
    Title,
    /// The sentence to keep. An empty text removes it.
    Sentence,
    /// The duration in minutes as the author types it, in the first language. An empty text removes it.
    Minutes,
}

/// A new text. Steps are counted from 0.
#[derive(Clone, Debug)]
pub enum Words {
    /// For the whole lesson.
    OfLesson(LessonText, Localized),
    /// For a step.
    OfStep(usize, StepText, Localized),
    /// The task of a step.
    Task(usize, Box<TaskText>),
}

/// The text of a lesson file with new words, and its lesson. Everything else stays as it's written.
///
/// # Errors
/// [`FigureError`] if the text wouldn't be a lesson.
pub fn reworded(text: &str, words: &[Words]) -> Result<(String, Lesson), FigureError> {
    let (head, steps) = parts(text);
    let mut parts: Vec<Cow<'_, str>> = std::iter::once(head).chain(steps).map(Cow::Borrowed).collect();
    for words in words {
        let (part, changed) = match words {
            Words::OfLesson(which, told) => (0, retold(&parts[0], *which, told)),
            Words::OfStep(step, which, told) => {
                let part = step + 1;
                (part, parts.get(part).and_then(|text| respoken(text, *which, told)))
            }
            Words::Task(step, task) => {
                let part = step + 1;
                (part, parts.get(part).and_then(|text| changed_step(text, |table| task.put(table))))
            }
        };
        if let Some(changed) = changed {
            parts[part] = Cow::Owned(changed);
        }
    }
    let mut out = String::new();
    for part in parts {
        separate(&mut out);
        out.push_str(&part);
    }
    let lesson = parse(&out)?;
    Ok((out, lesson))
}

/// A change of the steps of a lesson. Steps are counted from 0.
#[derive(Clone, Debug)]
pub enum Edit {
    /// A new figure for a step.
    Show(usize, Box<Figure>),
    /// Moves a step to the place of another one. Those between move up or down.
    Move(usize, usize),
    /// Removes a step.
    Remove(usize),
}

/// The text of a lesson file after a change, and its lesson. Comments, and steps that the change doesn't concern, stay
/// as they're written.
///
/// # Guarantees
/// The figure of a step stays the same wherever the step ends up.
///
/// # Errors
/// [`FigureError`] if the text isn't a lesson, or wouldn't be one after the change.
pub fn edited(text: &str, edit: &Edit) -> Result<(String, Lesson), FigureError> {
    let lesson = parse(text)?;
    let figures: Vec<&Figure> = lesson.steps.iter().map(|step| &*step.figure).collect();
    let (head, steps) = parts(text);
    let mut steps: Vec<Part<'_>> = steps
        .into_iter()
        .zip(figures)
        .enumerate()
        .map(|(place, (text, figure))| Part { text, place, figure })
        .collect();
    let count = steps.len();
    let mut shown_anew = None;
    match edit {
        Edit::Show(step, figure) if *step < count => {
            steps[*step].figure = figure;
            shown_anew = Some(*step);
        }
        Edit::Move(from, to) if *from < count && *to < count => {
            let moved = steps.remove(*from);
            steps.insert(*to, moved);
        }
        Edit::Remove(step) if *step < count && count > 1 => drop(steps.remove(*step)),
        _ => return Ok((text.to_owned(), lesson)),
    }
    let mut before: Option<&Part<'_>> = None;
    let mut out = head.to_owned();
    for part in &steps {
        // A step states only its changes, so it depends on the step before it.
        let places = [Some(part.place), before.map(|before| before.place)];
        let is_after_the_same = part.place.checked_sub(1) == places[1];
        let stays = is_after_the_same && (shown_anew.is_none() || !places.contains(&shown_anew));
        let figure = (!stays).then(|| difference(before.map(|before| before.figure), part.figure));
        separate(&mut out);
        match figure.and_then(|figure| redrawn(part.text, &figure)) {
            Some(text) => out.push_str(&text),
            None => out.push_str(part.text),
        }
        before = Some(part);
    }
    let lesson = parse(&out)?;
    Ok((out, lesson))
}

/// A step in the text of a file.
struct Part<'a> {
    text: &'a str,
    /// Its original place in the file.
    place: usize,
    figure: &'a Figure,
}

/// A blank line between two steps.
fn separate(out: &mut String) {
    let kept = out.trim_end().len();
    out.truncate(kept);
    out.push_str(if kept > 0 { "\n\n" } else { "" });
}

/// The text before the first step, and the text of each step with the comments above it.
fn parts(text: &str) -> (&str, Vec<&str>) {
    let starts: Vec<usize> = Document::parse(text)
        .ok()
        .and_then(|document| {
            let steps = document.get("step")?.as_array_of_tables()?;
            Some(steps.iter().filter_map(Table::span).map(|span| with_comments(text, span.start)).collect())
        })
        .unwrap_or_default();
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    let head = &text[..starts.first().copied().unwrap_or(text.len())];
    (head, starts.iter().zip(ends).map(|(&start, end)| &text[start..end]).collect())
}

/// The words of a step (from 0) and of its lesson as they stand in a file: title, text and notes of the step, then
/// title and sentence of the lesson. A language without a text of its own is empty.
pub fn words_in_file(text: &str, step: usize) -> [Localized; 5] {
    let (head, steps) = parts(text);
    let document = |part: &str| part.parse::<DocumentMut>().unwrap_or_default();
    let (head, step) = (document(head), document(steps.get(step).copied().unwrap_or_default()));
    let step = step.get("step").and_then(Item::as_array_of_tables).and_then(|steps| steps.get(0));
    let of_step = |key: &str| step.and_then(|step| told(step.get(key))).unwrap_or_default();
    let of_lesson = |key: &str| told(head.get(key)).unwrap_or_default();
    [of_step("title"), of_step("text"), of_step("notes"), of_lesson("title"), of_lesson("sentence")]
}

/// The part of a lesson file that holds a step, counted from 0.
pub fn text_of_step(text: &str, step: usize) -> Option<&str> {
    parts(text).1.get(step).copied()
}

/// The beginning of the comments directly above the line at `start`.
fn with_comments(text: &str, start: usize) -> usize {
    let mut begin = text[..start].rfind('\n').map_or(0, |end| end + 1);
    while let Some(above) = begin.checked_sub(1) {
        let line = text[..above].rfind('\n').map_or(0, |end| end + 1);
        if !text[line..above].trim_start().starts_with('#') {
            break;
        }
        begin = line;
    }
    begin
}

/// The text of a step after a change of its table.
fn changed_step(text: &str, change: impl FnOnce(&mut Table)) -> Option<String> {
    let mut document: DocumentMut = text.parse().ok()?;
    change(document.get_mut("step")?.as_array_of_tables_mut()?.get_mut(0)?);
    Some(document.to_string())
}

/// The text of a step with new words.
fn respoken(text: &str, which: StepText, told: &Localized) -> Option<String> {
    changed_step(text, |step| match which {
        StepText::Title => put(step, "title", told_item(told)),
        StepText::Text => put_or_remove(step, "text", told_if_any(told)),
        StepText::Notes => put_or_remove(step, "notes", told_if_any(told)),
    })
}

/// The text of a step with a new figure.
fn redrawn(text: &str, figure: &Difference) -> Option<String> {
    changed_step(text, |step| {
        let of_figure: Vec<String> =
            step.iter().map(|(key, _)| key.to_owned()).filter(|key| !WORDS.contains(&key.as_str())).collect();
        of_figure.iter().for_each(|key| drop(step.remove(key)));
        put_figure(step, figure);
    })
}

/// The text before the first step with a new text of the lesson.
fn retold(head: &str, which: LessonText, told: &Localized) -> Option<String> {
    let mut document: DocumentMut = head.parse().ok()?;
    match which {
        LessonText::Title => put(&mut document, "title", told_item(told)),
        LessonText::Sentence => put_or_remove(&mut document, "sentence", told_if_any(told)),
        LessonText::Minutes => put_or_remove(&mut document, "minutes", number_item(&told.en)),
    }
    Some(document.to_string())
}

/// Writes a figure into a step, as its difference from the step before.
pub(super) fn put_figure(step: &mut Table, Difference { changed, without }: &Difference) {
    if !without.is_empty() {
        step.insert("without", Item::Value(without.iter().collect::<Array>().into()));
    }
    for (section, item) in changed.iter() {
        step.insert(section, item.clone());
    }
}

/// Replaces the value of a key.
fn put(step: &mut Table, key: &str, item: Item) {
    match step.get_mut(key) {
        Some(old) => *old = item,
        None => drop(step.insert(key, item)),
    }
}

/// Replaces the value of a key, or removes the key if there's no value.
fn put_or_remove(table: &mut Table, key: &str, item: Option<Item>) {
    match item {
        Some(item) => put(table, key, item),
        None => drop(table.remove(key)),
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::lessons::shipped;

    fn figures(lesson: &Lesson) -> Vec<Figure> {
        lesson.steps.iter().map(|step| (*step.figure).clone()).collect()
    }

    fn titles(lesson: &Lesson) -> Vec<String> {
        lesson.steps.iter().map(|step| step.title.en.clone()).collect()
    }

    /// Every lesson, with each step moved by one place, the last one to the front, and the first one to the end: the
    /// steps show the same as before, in the new order.
    #[test]
    fn a_step_that_moves_takes_its_figure_with_it() {
        for shipped in shipped() {
            let count = shipped.lesson.steps.len();
            for (from, to) in (0..count).map(|from| (from, (from + 1) % count)).chain([(0, count - 1)]) {
                let (text, lesson) = edited(shipped.text, &Edit::Move(from, to)).unwrap();
                let (mut shown, mut named) = (figures(&shipped.lesson), titles(&shipped.lesson));
                let figure = shown.remove(from);
                shown.insert(to, figure);
                let title = named.remove(from);
                named.insert(to, title);
                assert_eq!(titles(&lesson), named, "{} {from} {to}", shipped.lesson.id);
                assert!(figures(&lesson) == shown, "{} {from} {to}\n{text}", shipped.lesson.id);
            }
        }
    }

    #[test]
    fn steps_after_a_removed_or_updated_step_stay_as_they_were() {
        let shipped = &shipped()[0];
        let count = shipped.lesson.steps.len();
        for step in 0..count {
            let (_, lesson) = edited(shipped.text, &Edit::Remove(step)).unwrap();
            let mut rest = figures(&shipped.lesson);
            rest.remove(step);
            assert!(figures(&lesson) == rest, "{step}");
        }
        // A step without a task, because a goal may be out of reach from another figure.
        let step = shipped.lesson.steps.iter().position(|step| step.task.is_none()).unwrap();
        let mut other = (*shipped.lesson.steps[step].figure).clone();
        other.camera.near *= 1.25;
        let (_, lesson) = edited(shipped.text, &Edit::Show(step, Box::new(other.clone()))).unwrap();
        let mut all = figures(&shipped.lesson);
        all[step] = other;
        assert!(figures(&lesson) == all);
    }

    #[test]
    fn only_rewritten_texts_change_in_the_file() {
        let shipped = &shipped()[1];
        let told = Localized::from(["Two\nlines".to_owned(), "Duas\nlinhas".to_owned()]);
        for which in [StepText::Text, StepText::Notes] {
            let (text, lesson) = reworded(shipped.text, &[Words::OfStep(2, which, told.clone())]).unwrap();
            let said =
                if which == StepText::Text { Some(&lesson.steps[2].text) } else { lesson.steps[2].notes.as_ref() };
            assert_eq!(said, Some(&told));
            // The parts before and after are the same to the letter.
            let (old, new) = (parts(shipped.text).1, parts(&text).1);
            for (k, (old, new)) in old.iter().zip(&new).enumerate().filter(|(k, _)| *k != 2) {
                assert_eq!(old.trim_end(), new.trim_end(), "{k}");
            }
            assert!(figures(&lesson) == figures(&shipped.lesson));
        }
        let (_, lesson) = reworded(shipped.text, &[Words::OfStep(2, StepText::Notes, Localized::default())]).unwrap();
        assert_eq!(lesson.steps[2].notes, None);
    }

    #[test]
    fn texts_of_the_whole_lesson_change_nothing_of_its_steps() {
        let shipped = &shipped()[1];
        let told = Localized::from(["Axes".to_owned(), "Eixos".to_owned()]);
        let in_one = Localized { pt_br: "Uma frase".to_owned(), ..Localized::default() };
        let minutes = |typed: &str| Localized { en: typed.to_owned(), ..Localized::default() };
        let say = |text: &str, which, told: &Localized| reworded(text, &[Words::OfLesson(which, told.clone())]);
        let (text, _) = say(shipped.text, LessonText::Title, &told).unwrap();
        let (text, _) = say(&text, LessonText::Sentence, &in_one).unwrap();
        let (text, lesson) = say(&text, LessonText::Minutes, &minutes("7,5")).unwrap();
        assert_eq!(lesson.title, told);
        // A text in one language appears in both.
        assert_eq!(lesson.sentence.unwrap().en, "Uma frase");
        assert_eq!(lesson.minutes, Some(7.5));
        assert_eq!((lesson.id, lesson.aims), (shipped.lesson.id.clone(), shipped.lesson.aims.clone()));
        assert_eq!(parts(&text).1, parts(shipped.text).1, "to the letter");
        let comment = shipped.text.lines().next().unwrap();
        assert!(comment.starts_with('#') && text.starts_with(comment));
        // An empty text removes an optional key.
        let (text, _) = say(&text, LessonText::Sentence, &Localized::default()).unwrap();
        let (text, lesson) = say(&text, LessonText::Minutes, &minutes(" ")).unwrap();
        assert_eq!((lesson.sentence, lesson.minutes), (None, None));
        // They're added if there were none.
        let (text, _) = say(&text, LessonText::Minutes, &minutes("9")).unwrap();
        let (text, lesson) = say(&text, LessonText::Sentence, &told).unwrap();
        assert_eq!((lesson.sentence, lesson.minutes), (Some(told), Some(9.0)));
        assert!(text.contains("minutes = 9\n") && figures(&parse(&text).unwrap()) == figures(&shipped.lesson));
        for refused in ["nine", "-1", "9000", "inf"] {
            assert!(say(&text, LessonText::Minutes, &minutes(refused)).is_err(), "{refused}");
        }
        assert!(say(&text, LessonText::Title, &Localized::default()).is_err());
    }

    #[test]
    fn a_change_that_leaves_no_lesson_is_refused() {
        let shipped = &shipped()[0];
        let unknown = Localized::from(["{camera.nonsense}".to_owned(), String::new()]);
        assert!(reworded(shipped.text, &[Words::OfStep(0, StepText::Text, unknown)]).is_err());
        assert!(reworded(shipped.text, &[Words::OfStep(0, StepText::Title, Localized::default())]).is_err());
        let (only, _) =
            edited("id = \"x\"\ntitle = \"x\"\n[[step]]\ntitle = \"a\"\ntext = \"a\"\n", &Edit::Remove(0)).unwrap();
        assert!(only.contains("[[step]]"), "a lesson has one step at least");
    }
}
