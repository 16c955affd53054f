//! Makes a step of a lesson from the current figure. Only the difference from the step before is written.

use toml_edit::{ArrayOfTables, DocumentMut, Item, Table};

use super::edit::put_figure;
use super::items::told_item;
use super::lesson::Lesson;
use super::read::parse;
use crate::figure::{Figure, FigureError, Localized, difference};
use crate::limits::MAX_EXERCISE_NAME;

/// The titles of a new step, for its author to change. It has no text yet.
#[derive(Clone, Debug)]
pub struct Draft {
    /// The title of a lesson that doesn't have one yet.
    pub lesson: Localized,
    /// The title of the step.
    pub title: Localized,
}

/// The text of a lesson file with one more step, which shows `now`. An empty text becomes a lesson with the identifier
/// `id`. The existing text stays as it is.
///
/// # Guarantees
/// Reading the text gives the lesson with that figure in its last step.
///
/// # Errors
/// [`FigureError`] if the text isn't a lesson, or already has the greatest number of steps.
pub fn with_step(text: &str, id: &str, draft: &Draft, now: &Figure) -> Result<(String, Lesson), FigureError> {
    let (mut out, last) = if text.trim().is_empty() {
        let mut head = DocumentMut::new();
        head.insert("id", Item::Value(identifier(id).into()));
        head.insert("title", told_item(&draft.lesson));
        (head.to_string(), None)
    } else {
        let lesson = parse(text)?;
        (text.to_owned(), lesson.steps.last().map(|step| step.figure.clone()))
    };
    let mut step = Table::new();
    step.insert("title", told_item(&draft.title));
    put_figure(&mut step, &difference(last.as_deref(), now));
    let mut steps = ArrayOfTables::new();
    steps.push(step);
    let mut document = DocumentMut::new();
    document.insert("step", Item::ArrayOfTables(steps));
    if !out.ends_with('\n') {
        out.push('\n');
    }
    out.push('\n');
    out.push_str(document.to_string().trim_start());
    let lesson = parse(&out)?;
    Ok((out, lesson))
}

/// The letters of a name that are allowed in an identifier.
fn identifier(name: &str) -> String {
    let is_of_name = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
    let id: String = name.chars().map(|c| if is_of_name(c) { c } else { '-' }).take(MAX_EXERCISE_NAME).collect();
    if id.is_empty() { "lesson".to_owned() } else { id }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::figure::read;
    use crate::lessons::shipped;

    fn draft() -> Draft {
        let text = |en: &str| Localized::from([en.to_owned(), format!("{en} (pt)")]);
        Draft { lesson: text("Lesson"), title: text("Step") }
    }

    /// Steps of all lessons one after the other, each recorded after the one before: any changes, and back.
    #[test]
    fn recorded_steps_are_the_figures_that_were_shown() {
        for shipped in shipped() {
            let (mut text, mut figures) = (String::new(), Vec::new());
            let forwards = shipped.lesson.steps.iter();
            for step in forwards.clone().chain(forwards.rev()) {
                let (with, lesson) = with_step(&text, "my lesson", &draft(), &step.figure).unwrap();
                figures.push(Figure { title: Some(draft().title), ..(*step.figure).clone() });
                text = with;
                assert_eq!(lesson.id, "my-lesson");
            }
            let lesson = parse(&text).unwrap();
            assert_eq!(lesson.steps.len(), figures.len());
            for (step, figure) in lesson.steps.iter().zip(&figures) {
                assert_eq!(*step.figure, *figure, "{}\n{text}", shipped.lesson.id);
            }
        }
    }

    #[test]
    fn only_changes_are_written_and_earlier_text_stays() {
        let figure = read::parse("[camera]\nposition = [0, 0, 5]\n[show]\nmeasure = [\"F\"]\n").unwrap();
        let (first, _) = with_step("", "mine", &draft(), &figure).unwrap();
        let commented = first.replace("[[step]]", "# The first.\n[[step]]");
        let mut nearer = figure.clone();
        nearer.camera.near = 2.0;
        nearer.show.measure.clear();
        let (second, _) = with_step(&commented, "mine", &draft(), &nearer).unwrap();
        let added = second.strip_prefix(&commented).unwrap();
        assert!(added.contains("near = 2.0") && added.contains("without = [\"show\"]"), "{added}");
        assert!(!added.contains("position") && !added.contains("[step.scene]"), "{added}");
    }

    #[test]
    fn a_kept_operation_ends_with_the_camera_that_it_led_to_unless_it_is_written_again() {
        let figure = read::parse("[show]\noperation = \"azimuth=15\"\n").unwrap();
        let (text, _) = with_step("", "mine", &draft(), &figure).unwrap();
        let step = "\n[[step]]\ntitle = \"Next\"\ntext = \"Nearer.\"\n[step.camera]\nnear = 0.5\n";
        let next = parse(&format!("{text}{step}")).unwrap();
        assert!(next.steps[1].figure.show.operations.is_empty());
        let mut nearer = figure.clone();
        nearer.camera.near = 0.5;
        let (_, lesson) = with_step(&text, "mine", &draft(), &nearer).unwrap();
        assert_eq!(lesson.steps[1].figure.show.operations, figure.show.operations);
    }

    #[test]
    fn a_text_that_is_no_lesson_is_refused_and_none_is_written() {
        assert!(with_step("[camera]\nnear = 1\n", "x", &draft(), &Figure::default()).is_err());
    }
}
