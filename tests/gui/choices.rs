//! The choices of every question of the lessons, as students see them: in the window, before a class, and on paper.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use camera_lab::exercises::{Exercise, Kind};
use camera_lab::gui::{Start, State};
use camera_lab::lessons::{Lesson, OpenLesson, Step, Task, shipped};
use camera_lab::picture::Paragraph;
use camera_lab::scene::{Preset, SceneSpec, no_files};
use camera_lab::views::{SharedScene, View, Views, scene_of};
use camera_lab_words::Lang;
use camera_lab_words::handout::{self, HandoutOptions, Solutions};
use camera_lab_words::learn::exercises::choice_of;
use camera_lab_words::why::notes;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;

use super::window::Window;

/// The exercise of a step that offers choices.
fn with_choices(step: &Step) -> Option<Exercise> {
    let Some(Task::Question(entry)) = &step.task else { return None };
    let exercise = entry.exercise(0, &Default::default());
    matches!(exercise.asks[0].kind, Kind::Choice(_)).then_some(exercise)
}

/// The choices of an exercise, in Markdown.
fn choices(lang: Lang, exercise: &Exercise) -> Vec<String> {
    let ask = &exercise.asks[0];
    let Kind::Choice(names) = &ask.kind else { panic!("choices") };
    names.iter().map(|name| choice_of(lang, ask, name).to_owned()).collect()
}

fn has_marks(text: &str) -> bool {
    text.contains('$') || text.contains("**") || text.contains('`')
}

/// A window that plays a step. There is nothing in its scene, because only the question counts.
fn playing(lesson: &Arc<Lesson>, step: usize, lang: Lang) -> Window {
    let mut lesson = Arc::clone(lesson);
    for step in &mut Arc::make_mut(&mut lesson).steps {
        let figure = Arc::make_mut(&mut step.figure);
        figure.scene = SceneSpec { preset: Preset::Empty, ..SceneSpec::default() };
        figure.style.antialias = camera_lab::appearance::Samples::One;
    }
    let figure = (*lesson.steps[step].figure).clone();
    let start = Start { figure, lang, lesson: Some(OpenLesson { lesson, path: None, step }), ..Start::default() };
    let mut state = State::new(start).unwrap();
    state.file_flow.native = false;
    state.model.layout.maximized = Some(View::Image);
    let mut window = Window::with_state(state, [1280.0, 1000.0]);
    window.run();
    window
}

#[test]
fn no_choice_shows_its_marks_in_the_window_or_before_a_class() {
    let mut drawn = 0;
    for lang in [Lang::En, Lang::PtBr] {
        for lesson in shipped().iter().map(|shipped| &shipped.lesson) {
            for (k, step) in lesson.steps.iter().enumerate() {
                let Some(exercise) = with_choices(step) else { continue };
                let mut window = playing(lesson, k, lang);
                let marked = |window: &Window| {
                    let mut texts = window.written().into_iter().map(|(text, _)| text);
                    texts.find(|text| has_marks(text))
                };
                assert_eq!(marked(&window), None, "{} {}", lesson.id, k + 1);
                for choice in choices(lang, &exercise) {
                    let name = notes::line(&choice);
                    let radio = window.harness.query_by_role_and_label(Role::RadioButton, &name);
                    assert!(radio.is_some(), "{} {}: {name}", lesson.id, k + 1);
                }
                window.key(Key::F11);
                window.key(Key::Q);
                assert!(window.state().learn.lesson.as_ref().unwrap().shows_question);
                assert_eq!(marked(&window), None, "{} {} before a class", lesson.id, k + 1);
                drawn += 1;
            }
        }
    }
    assert!(drawn > 100, "{drawn}");
}

/// A click on the words of a choice chooses it, as one on its button does.
#[test]
fn the_words_of_a_choice_with_a_formula_choose_it() {
    let shipped = shipped().iter().find(|shipped| shipped.lesson.id == "depth").unwrap();
    let exercise = with_choices(&shipped.lesson.steps[0]).unwrap();
    let marked = choices(Lang::En, &exercise).into_iter().find(|choice| has_marks(choice)).unwrap();
    let mut window = playing(&shipped.lesson, 0, Lang::En);
    let radio = window.harness.get_by_role_and_label(Role::RadioButton, &notes::line(&marked)).rect();
    window.click_at(eframe::egui::pos2(radio.right() + 14.0, radio.center().y));
    let ask = &exercise.asks[0];
    let typed = window.app_mut().state.learn.exercises.typed.values().find_map(|typed| typed.answers.get(&ask.name));
    let chosen = typed.unwrap()[0].clone();
    assert_eq!(choice_of(Lang::En, ask, &chosen), marked);
}

#[test]
fn no_choice_shows_its_marks_on_paper() {
    for lang in [Lang::En, Lang::PtBr] {
        for lesson in shipped().iter().map(|shipped| &shipped.lesson) {
            let options = HandoutOptions { lang, columns: 1, answers: Solutions::AtEnd, plan: true, late: false };
            let handout = handout::of_lesson(lesson, options, |(_, step), size| {
                let scene = SharedScene::new(scene_of(&step.figure, &mut no_files, &Default::default()).unwrap());
                handout::picture(&step.figure, &scene, Views::One(View::Image), size, lang)
            });
            let paragraphs: Vec<Paragraph> = handout
                .unwrap()
                .parts
                .into_iter()
                .flat_map(|part| part.entries)
                .flat_map(|entry| entry.paragraphs)
                .collect();
            let asked = lesson.steps.iter().filter_map(with_choices).map(|exercise| choices(lang, &exercise).len());
            let is_choice =
                |paragraph: &&Paragraph| matches!(paragraph, Paragraph::Text(text) if text.starts_with('☐'));
            assert!(paragraphs.iter().filter(is_choice).count() >= asked.sum::<usize>(), "{}", lesson.id);
            for paragraph in paragraphs {
                if let Paragraph::Text(text) | Paragraph::Heading(text) | Paragraph::Remark(text) = &paragraph {
                    assert!(!has_marks(text), "{}: {text}", lesson.id);
                }
            }
        }
    }
}
