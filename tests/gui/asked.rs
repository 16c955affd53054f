//! While a question is open, the number that answers it is nowhere on the screen.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;
use std::time::Duration;

use camera_lab::appearance::Samples;
use camera_lab::exercises::{self, Ask, Exercise, Free};
use camera_lab::export::format::PictureFormat;
use camera_lab::figure::{Explanation, Figure, Measure, Measured, NamedPoint, ShownProbe};
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::gui::learn::exercises::state::Chosen;
use camera_lab::gui::{Start, State};
use camera_lab::lessons::{OpenLesson, Task, filled, numbers_of, shipped};
use camera_lab::numbers::significant;
use camera_lab::views::{View, Views};
use camera_lab_words::Lang;
use camera_lab_words::learn::exercises as said;
use eframe::egui::Key;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use super::files::Folder;
use super::window::Window;
use crate::words::en;

/// The explanations that print numbers.
const EXPLANATIONS: [Explanation; 4] =
    [Explanation::Matrices, Explanation::Point, Explanation::Triangle, Explanation::Dialects];

/// The numbers in a text, as they are printed.
fn printed(text: &str) -> Vec<String> {
    let words = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    words.map(|word| word.trim_matches('.').to_owned()).filter(|word| !word.is_empty()).collect()
}

/// The significant digits of a number, without zeros at its ends.
fn digits(number: &str) -> usize {
    let digits: String = number.chars().filter(char::is_ascii_digit).collect();
    digits.trim_matches('0').len()
}

/// True if a printed number is `value`, rounded to its own digits.
fn is(number: &str, value: f64) -> bool {
    let decimals = number.split_once('.').map_or(0, |(_, after)| after.len());
    digits(number) >= 3 && format!("{:.decimals$}", value.abs()) == *number
}

/// Everything on the screen: texts, names and values of controls, and the labels in the views.
fn texts(window: &mut Window) -> Vec<String> {
    let nodes = window.harness.query_all_by(|_| true);
    let of_nodes = nodes.flat_map(|node| {
        let node = node.accesskit_node();
        [node.label(), node.value(), node.description()].into_iter().flatten().collect::<Vec<_>>()
    });
    let mut all: Vec<String> = of_nodes.collect();
    let canvas = &window.app_mut().canvas;
    all.extend(View::ALL.iter().flat_map(|view| canvas.labels(*view)).map(|label| label.text.clone()));
    all
}

/// The numbers of the answers with three digits or more that the statement doesn't print.
fn answers(exercise: &Exercise, statement: &str) -> Vec<f64> {
    let of_ask = |ask: &Ask| {
        let table = ask.expected().table().filter(|_| !ask.places);
        table.map_or_else(Vec::new, |table| table.entries)
    };
    let given = printed(statement);
    let is_new = |value: &f64| digits(&significant(*value, 6)) >= 3 && !given.iter().any(|given| is(given, *value));
    exercise.asks.iter().flat_map(of_ask).filter(is_new).collect()
}

/// The texts on the screen that hold one of the numbers, with every panel open.
fn leaks(window: &mut Window, answers: &[f64]) -> Vec<String> {
    let mut leaks = Vec::new();
    let mut look = |window: &mut Window, at: &str| {
        window.run();
        for text in texts(window) {
            let found = printed(&text);
            if let Some(answer) = answers.iter().find(|answer| found.iter().any(|number| is(number, **answer))) {
                leaks.push(format!("{at}: {answer} in {text:?}"));
            }
        }
    };
    let points = window.state().model.desk.shown.figure().points.clone();
    let pinned = points.iter().map(|point| ShownProbe::World(point.position)).chain([ShownProbe::Pixel([3, 2])]);
    // Operations and numbers are in the place of explanations.
    window.app_mut().state.model.settings.panels.wanted = [true, true, false];
    for probe in pinned {
        window.app_mut().state.model.desk.shown.show_mut().probe = Some(probe);
        look(window, "probe");
    }
    for explanation in EXPLANATIONS {
        window.app_mut().state.model.show_explanation(explanation);
        look(window, explanation.name());
    }
    leaks
}

/// A window in which all panels fit beside each other, with their sections open.
fn window(figure: Figure, lesson: Option<OpenLesson>) -> Window {
    let mut figure = figure;
    figure.style.antialias = Samples::One;
    let mut state = State::new(Start { figure, lang: Lang::En, lesson, ..Start::default() }).unwrap();
    state.file_flow.native = false;
    state.model.settings.reduce_motion = true;
    state.model.settings.panels.wanted = [true; 3];
    state.model.settings.numbers_open = true;
    let mut window = Window::with_state(state, [1900.0, 2400.0]);
    window.app_mut().state.model.settings.panels.wanted = [true; 3];
    window.app_mut().canvas.patience = Some(Duration::from_secs(60));
    window.run();
    window
}

#[test]
fn no_question_of_a_lesson_is_answered_by_the_screen() {
    let mut all = Vec::new();
    for shipped in shipped() {
        for (k, step) in shipped.lesson.steps.iter().enumerate() {
            let Some(Task::Question(entry)) = &step.task else { continue };
            let exercise = entry.exercise(0, &Free::new());
            let report = numbers_of(&step.figure).unwrap();
            let mut statement = filled(&step.text.en, &report, Lang::En.mark()).unwrap();
            for ask in &exercise.asks {
                statement += &said::ask(Lang::En, &exercise, ask);
                ask.own_choices.values().for_each(|choice| statement += &choice.en);
            }
            let answers = answers(&exercise, &statement);
            let open = OpenLesson { lesson: Arc::clone(&shipped.lesson), path: None, step: k };
            let mut window = window((*step.figure).clone(), Some(open));
            let found = leaks(&mut window, &answers);
            // Also if the numbers are too short to be recognized.
            let is_asked = exercise.asks.iter().any(|ask| ask.quantity.is_some() || !ask.asks.is_empty());
            assert!(!is_asked || window.says(en::WINDOW.asked_here), "{} {}", shipped.lesson.id, k + 1);
            all.extend(found.into_iter().map(|leak| format!("{} {}: {leak}", shipped.lesson.id, k + 1)));
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn no_exercise_is_answered_by_the_screen() {
    let mut all = Vec::new();
    for entry in exercises::entries() {
        let exercise = entry.exercise(2, &Free::new());
        let mut statement = said::statement(Lang::En, &exercise);
        statement.extend(said::assumptions(Lang::En, &exercise));
        statement.extend(exercise.asks.iter().map(|ask| said::ask(Lang::En, &exercise, ask)));
        let answers = answers(&exercise, &statement.join("\n"));
        let mut figure = exercise.subject.figure.clone();
        for (k, point) in exercise.subject.points.iter().enumerate() {
            figure.points.push(NamedPoint { name: format!("P_{k}"), position: *point });
        }
        let mut window = window(figure, None);
        window.app_mut().state.model.show_explanation(Explanation::Exercises);
        window.app_mut().state.learn.exercises.work_on(Chosen { id: entry.id.clone().into_owned(), seed: 2 });
        let found = leaks(&mut window, &answers);
        all.extend(found.into_iter().map(|leak| format!("{}: {leak}", entry.id)));
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn neither_camera_check_nor_examine_nor_exported_labels_answer() {
    let (_, exercise) = super::exercises::made("window", 2);
    let mut figure = exercise.subject.figure.clone();
    figure.show.measure = vec![Measured::Dimension(Measure::Height)];
    let mut window = window(figure, None);
    window.app_mut().state.file_flow.native = false;
    window.app_mut().state.model.show_explanation(Explanation::Exercises);
    window.app_mut().state.learn.exercises.work_on(Chosen { id: "window".to_owned(), seed: 2 });
    window.run();
    window.app_mut().state.file_flow.dialog = Some(Dialog::Coach);
    window.run();
    assert!(window.says(en::COACH.coach) && !window.says(en::COACH.findings));
    window.app_mut().state.file_flow.dialog = None;
    window.command_key(Key::Num9);
    window.run();
    assert!(window.says(en::THIS_FIGURE.tab) && !window.says(en::THIS_FIGURE.study));
    let folder = Folder::new("asked-export");
    let path = folder.file("world.svg");
    window.command_key(Key::E);
    let Some(Dialog::Export(mut export)) = window.state().file_flow.dialog.clone() else { panic!("no dialog") };
    (export.what, export.format) = (Views::One(View::World), PictureFormat::Svg);
    window.app_mut().state.file_flow.dialog = Some(Dialog::Export(export));
    window.run();
    window.click(en::WINDOW.export_action);
    window.choose(&path);
    window.wait(|_| path.exists());
    let drawn = std::fs::read_to_string(&path).unwrap();
    let height = exercise.asks[0].expected().table().unwrap().entries[0];
    assert!(drawn.contains("= ?") && !drawn.contains(&format!("= {}", significant(height, 4))), "{height}");
}

#[test]
fn an_asked_quantity_stays_hidden_after_a_wrong_answer_and_comes_with_the_right_one_or_the_solution() {
    for gives_up in [false, true] {
        let (_, exercise) = super::exercises::made("view-matrix", 2);
        let mut window = window(exercise.subject.figure.clone(), None);
        window.app_mut().state.model.show_explanation(Explanation::Exercises);
        window.app_mut().state.learn.exercises.work_on(Chosen { id: "view-matrix".to_owned(), seed: 2 });
        window.run();
        let hidden = |window: &mut Window| {
            window.app_mut().state.model.settings.panels.wanted = [false, true, false];
            window.run();
            let is = window.says(en::WINDOW.asked_here);
            window.app_mut().state.model.show_explanation(Explanation::Exercises);
            window.run();
            is
        };
        assert!(hidden(&mut window));
        let right = super::exercises::right(&exercise.asks[0]);
        let wrong: Vec<String> = right.iter().map(|_| "3".to_owned()).collect();
        super::exercises::fill(&mut window, "M_v", 4, &wrong);
        window.click("Check: M_v");
        assert!(window.says("✗ wrong") && hidden(&mut window));
        if gives_up {
            while let Some(next) = ["A worked step: M_v", "The next step: M_v", "A hint: M_v", "A stronger hint: M_v"]
                .into_iter()
                .find(|name| window.harness.query_by_label(name).is_some())
            {
                window.click(next);
            }
        } else {
            super::exercises::fill(&mut window, "M_v", 4, &right);
            window.click("Check: M_v");
        }
        assert!(!hidden(&mut window), "{gives_up}");
    }
}
