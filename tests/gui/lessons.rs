//! A lesson in the window: its steps by buttons and keys, its questions and goals, and every step of every lesson.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;
use std::time::Duration;

use camera_lab::exercises::{Exercise, ExpectedAnswer, Kind};
use camera_lab::figure::NamedPoint;
use camera_lab::gui::{LaunchOptions, Start, State};
use camera_lab::lessons::{OpenLesson, Task, shipped};
use camera_lab_desk::layout::Side;
use camera_lab_words::learn::exercises::choice_of;
use camera_lab_words::learn::{exercise_sheet, exercise_window, exercises, lessons as words};
use camera_lab_words::why::notes::line;
use camera_lab_words::{Lang, told};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::{By, Queryable as _};

use super::files::Folder;
use super::window::Window;
use crate::words::en;

/// A window with a step of one of the program's lessons. Pictures have one sample, because they take their time without
/// optimisation.
pub(crate) fn playing(lesson: usize, step: usize, lang: Lang) -> Window {
    let mut lesson = shipped()[lesson].lesson.clone();
    for step in &mut Arc::make_mut(&mut lesson).steps {
        Arc::make_mut(&mut step.figure).style.antialias = camera_lab::appearance::Samples::One;
    }
    let figure = (*lesson.steps[step].figure).clone();
    let start = Start { figure, lang, lesson: Some(OpenLesson { lesson, path: None, step }), ..Start::default() };
    let mut state = State::new(start).unwrap();
    state.file_flow.native = false;
    let mut window = Window::with_state(state, [1280.0, 720.0]);
    window.run();
    window
}

/// The same with the first step. Its pictures come whenever they are ready, for a test that only measures the panels.
pub(crate) fn measured(lesson: usize) -> Window {
    let mut window = playing(lesson, 0, Lang::En);
    window.app_mut().state.model.settings.reduce_motion = true;
    window.app_mut().canvas.patience = Some(Duration::ZERO);
    window
}

fn step(window: &Window) -> usize {
    window.state().learn.lesson.as_ref().unwrap().step
}

#[test]
fn the_question_of_a_lesson_that_is_closed_leaves_the_list_of_exercises() {
    let mut window = playing(0, 0, Lang::En);
    for key in [Key::W, Key::X] {
        window.harness.key_press_modifiers(Modifiers::ALT, key);
        window.run();
    }
    let search = window.harness.get_by_role_and_label(Role::TextInput, en::EXERCISE_WINDOW.search);
    assert!(search.is_focused());
    assert!(window.harness.query_by_label(en::EXERCISE_WINDOW.back).is_none());
}

#[test]
fn a_question_is_answered_before_the_next_step_is_shown() {
    let mut window = playing(16, 7, Lang::En);
    // A question without a picture that answers it.
    let lesson = &shipped()[16].lesson;
    let Some(Task::Question(entry)) = &lesson.steps[7].task else { panic!("a question") };
    let exercise = entry.exercise(0, &Default::default());
    let ask = &exercise.asks[0];
    // Page down names the task to be done first.
    window.harness.key_press(Key::PageDown);
    window.run();
    assert_eq!(step(&window), 7);
    let right = exercise_sheet::answer(Lang::En, ask);
    window.harness.get_by_label(&right).click();
    window.run();
    window.harness.get_by_label_contains(en::EXERCISE_WINDOW.guess).click();
    window.run();
    assert!(window.state().learn.lesson.as_ref().unwrap().is_done());
    window.harness.get_by_label_contains(en::LESSONS.next).click();
    for _ in 0..200 {
        window.harness.step();
    }
    assert_eq!(step(&window), 8);
    assert_eq!(window.state().model.desk.shown.figure().camera, lesson.steps[8].figure.camera);
    assert!(!window.state().model.desk.can_undo(true), "the move is no change");
    // Back, and the question is still answered.
    window.harness.key_press(Key::PageUp);
    window.run();
    assert_eq!(step(&window), 7);
    assert!(window.state().learn.lesson.as_ref().unwrap().is_done());
}

#[test]
fn a_wrong_answer_gets_a_reason_in_both_languages() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = playing(16, 7, lang);
        let Some(Task::Question(entry)) = &shipped()[16].lesson.steps[7].task else { panic!("a question") };
        let exercise = entry.exercise(0, &Default::default());
        let ask = &exercise.asks[0];
        let mistake = &ask.own_mistakes[0];
        let ExpectedAnswer::Choice(wrong) = mistake.answer else { panic!("a choice") };
        let Kind::Choice(choices) = &ask.kind else { panic!("a choice") };
        window.harness.get_by_label(choice_of(lang, ask, &choices[wrong])).click();
        window.run();
        let guess = exercise_window::texts(lang).guess;
        window.harness.get_by_label_contains(guess).click();
        window.run();
        let checked = &window.state().learn.exercises.checked[&ask.name];
        assert!(!checked.judged.right);
        assert!(!window.state().learn.lesson.as_ref().unwrap().is_done());
        let said = exercises::diagnosis(lang, ask, &checked.judged).unwrap();
        assert!(said.contains(told(lang, &mistake.message).trim()), "{said}");
    }
}

#[test]
fn a_goal_is_noticed_and_the_way_to_it_is_shown_and_undone() {
    let lesson = &shipped()[0].lesson;
    let with_goal = lesson.steps.iter().position(|step| matches!(step.task, Some(Task::Try(_)))).unwrap();
    let mut window = playing(0, with_goal, Lang::En);
    assert!(window.state().model.settings.panels().is_shown(Side::Left), "the camera's numbers are at hand");
    assert!(!window.state().learn.lesson.as_ref().unwrap().is_done());
    let t = words::texts(Lang::En);
    window.harness.get_by_label(t.show_way).click();
    window.run();
    assert!(window.state().learn.lesson.as_ref().unwrap().is_done());
    window.harness.get_by_label_contains(t.done);
    assert_ne!(window.state().model.desk.shown.figure().camera, lesson.steps[with_goal].figure.camera);
    // Nothing that is tried is lost work, and the step comes back.
    assert!(window.state().model.desk.shown.is_changed() && !window.state().model.is_unsaved());
    window.harness.get_by_label(t.again).click();
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().camera, lesson.steps[with_goal].figure.camera);
}

#[test]
fn a_presentation_has_keys_for_all_of_it() {
    let mut window = playing(0, 0, Lang::En);
    window.harness.key_press(Key::F11);
    window.run();
    let state = &mut window.app_mut().state;
    state.learn.go_to_step(&mut state.model, 1);
    window.run();
    let state = &mut window.app_mut().state;
    state.learn.go_to_step(&mut state.model, 0);
    window.run();
    let lesson = |window: &Window| {
        let playing = window.state().learn.lesson.as_ref().unwrap();
        (playing.shows_text, playing.shows_question, playing.shows_private_notes)
    };
    assert_eq!(lesson(&window), (true, false, false), "the question waits for the lecturer");
    for (key, after) in [(Key::C, (false, false, false)), (Key::Q, (false, true, false)), (Key::N, (false, true, true))]
    {
        window.harness.key_press(key);
        window.run();
        assert_eq!(lesson(&window), after);
    }
    for (digits, place) in [(&[Key::Num4][..], 3), (&[Key::Num1, Key::Num0], 9), (&[Key::Num1, Key::Num1], 10)] {
        digits.iter().for_each(|digit| window.harness.key_press(*digit));
        // All in one frame, as when drawing is slow.
        window.harness.step();
        window.harness.key_press(Key::Enter);
        window.run();
        assert_eq!(step(&window), place);
    }
}

/// The notes beside the views are the lecturer's. A presentation begins without them, and shows them only marked as
/// private.
#[test]
fn notes_come_into_a_presentation_only_if_they_are_asked_for() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = words::texts(lang);
        let mut window = playing(0, 0, lang);
        let notes = told(lang, shipped()[0].lesson.steps[0].notes.as_ref().unwrap()).to_owned();
        let first: String = notes.split(['*', '$', '{', '\n']).next().unwrap().to_owned();
        assert!(first.len() > 10, "{first}");
        window.harness.key_press_modifiers(Modifiers::ALT, Key::N);
        window.run();
        assert!(window.says(&first) && !window.says(t.notes_private));
        window.key(Key::F11);
        assert!(!window.says(&first), "the class doesn't see them");
        window.key(Key::N);
        assert!(window.says(&first) && window.says(t.notes_private));
        window.key(Key::N);
        assert!(!window.says(&first));
        window.key(Key::N);
        window.key(Key::F11);
        assert!(window.says(&first) && !window.says(t.notes_private), "they're where they were");
        window.key(Key::F11);
        assert!(!window.says(&first), "every presentation begins without them");
    }
}

#[test]
fn leaving_a_lesson_brings_the_figure_and_the_panels_back() {
    let mut window = Window::new(Lang::En);
    window.run();
    let panels = window.state().model.settings.panels.wanted;
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::L);
    window.run();
    let title = told(Lang::En, &shipped()[1].lesson.title);
    // By its name, because another line may be under the pointer by now.
    window.harness.get_by_label_contains(title).click_accesskit();
    window.run();
    assert_eq!(window.state().learn.lesson.as_ref().unwrap().lesson.id, shipped()[1].lesson.id);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::W);
    window.run();
    assert!(window.state().learn.lesson.is_none());
    assert_eq!(window.state().model.settings.panels.wanted, panels);
    assert_eq!(window.state().model.desk.shown.figure().camera, shipped()[1].lesson.steps[0].figure.camera);
}

#[test]
fn the_first_start_offers_the_first_lesson_and_no_later_one_does() {
    let folder = Folder::new("welcome");
    for first in [true, false] {
        let mut window = Window::new(Lang::En);
        let ctx = window.harness.ctx.clone();
        window.run();
        window.app_mut().keep_preferences(&ctx, &folder.file("config"), LaunchOptions::default());
        window.run();
        let t = words::texts(window.state().model.settings.lang);
        assert_eq!(window.harness.query_by_label(t.new_here).is_some(), first);
        if first {
            let lang = window.state().model.settings.lang;
            window.harness.get_by_label(&words::with_minutes(lang, &shipped()[0].lesson)).click();
            window.run();
            assert_eq!(step(&window), 0);
        }
    }
}

/// The next start continues at the step of the last end, and closing the line is for this time only. The end of a
/// lesson leads to the next one.
#[test]
fn a_later_start_offers_the_step_at_which_the_lesson_was_left() {
    for (stopped, id, place) in
        [("", "window", 9), ("photograph=4", "photograph", 3), ("camera=13", "window", 9), ("gone=2", "window", 9)]
    {
        let folder = Folder::new("go-on");
        let config = folder.file("config");
        std::fs::create_dir_all(&config).unwrap();
        let kept = format!(
            "language = \"en\"\nwelcomed = true\nlessons = [\"camera=13\", \"window=10\", \"photograph=9\"]\n\
             lessons_done = [\"camera=1\", \"camera=2\", \"camera=3\", \"camera=5\", \"camera=6\", \"camera=8\", \
             \"camera=10\", \"camera=11\", \"camera=12\", \"camera=13\"]\nlesson_stopped = \"{stopped}\"\n"
        );
        std::fs::write(config.join("preferences.toml"), kept).unwrap();
        let mut window = Window::new(Lang::En);
        let ctx = window.harness.ctx.clone();
        window.run();
        window.app_mut().keep_preferences(&ctx, &config, LaunchOptions::default());
        window.run();
        let lesson = &shipped().iter().find(|shipped| shipped.lesson.id == id).unwrap().lesson;
        assert!(window.state().learn.is_finished(&shipped()[0].lesson) && !window.state().learn.is_finished(lesson));
        let name = words::go_on(Lang::En, lesson, place);
        assert!(name.ends_with(&format!("step {}", place + 1)), "{name}");
        window.harness.get_by_label(&name).click();
        window.run();
        assert_eq!((step(&window), window.state().learn.lesson.as_ref().unwrap().lesson.id.as_str()), (place, id));
        assert!(!window.state().learn.goes_on);
        assert_eq!(window.state().learn.stopped, Some((id.to_owned(), place)));
    }
}

/// Passing over everything finishes nothing. A shown way is no answer.
#[test]
fn a_lesson_is_finished_when_its_questions_are() {
    let lesson = &shipped()[0].lesson;
    let mut window = playing(0, lesson.steps.len() - 1, Lang::En);
    assert!(!window.state().learn.is_finished(lesson));
    assert_eq!(window.state().learn.done_of(lesson).0, 0);
    let with_goal = lesson.steps.iter().position(|step| matches!(step.task, Some(Task::Try(_)))).unwrap();
    window.app_mut().state.model.settings.reduce_motion = true;
    let state = &mut window.app_mut().state;
    state.learn.go_to_step(&mut state.model, with_goal);
    window.run();
    window.harness.get_by_label(words::texts(Lang::En).show_way).click();
    window.run();
    assert!(window.state().learn.lesson.as_ref().unwrap().is_done());
    assert_eq!(window.state().learn.done_of(lesson).0, 0, "it was shown");
    let state = &mut window.app_mut().state;
    state.learn.go_to_step(&mut state.model, 0);
    window.run();
    let Some(Task::Question(entry)) = &lesson.steps[0].task else { panic!("a question") };
    let right = exercise_sheet::answer(Lang::En, &entry.exercise(0, &Default::default()).asks[0]);
    // The guess, and then what the picture shows.
    for button in [en::EXERCISE_WINDOW.guess, en::EXERCISE_WINDOW.check] {
        window.harness.get_by_role_and_label(Role::RadioButton, &right).click();
        window.run();
        window.harness.get_by_label_contains(button).click();
        window.run();
    }
    assert_eq!(window.state().learn.done_of(lesson).0, 1);
}

/// Everything of a step is in sight without scrolling: in the window, and on a projector with the question hidden.
#[test]
fn every_step_has_room_for_its_text() {
    let mut cut = Vec::new();
    for (place, shipped) in shipped().iter().enumerate() {
        let mut window = measured(place);
        for presents in [false, true] {
            if presents {
                window.harness.key_press(Key::F11);
                window.run();
            }
            for lang in [Lang::En, Lang::PtBr] {
                window.app_mut().state.model.settings.lang = lang;
                for k in 0..shipped.lesson.steps.len() {
                    let state = &mut window.app_mut().state;
                    state.learn.go_to_step(&mut state.model, k);
                    window.run();
                    // The bar is below the pictures, and not behind them.
                    let below =
                        window.harness.query_all_by_label_contains("Camera check").map(|node| node.rect().bottom());
                    let below = below.fold(0.0, f32::max);
                    let bar = window.harness.query_by_label("◀ Back").map_or(f32::INFINITY, |back| back.rect().top());
                    let hidden = bar < below;
                    let playing = window.state().learn.lesson.as_ref().unwrap();
                    if playing.is_cut || hidden {
                        cut.push(format!("{} {} {lang:?} presents: {presents}", shipped.lesson.id, k + 1));
                    }
                }
            }
        }
    }
    assert!(cut.is_empty(), "{cut:#?}");
}

/// Gives wrong answers to all that an exercise asks.
fn answer_wrongly(window: &mut Window, exercise: &Exercise) {
    let t = en::EXERCISE_WINDOW;
    for ask in &exercise.asks {
        let says = |window: &mut Window, label: &str| {
            let name = exercises::ask(Lang::En, exercise, ask).replace("**", "");
            window.harness.get_by_label(&exercise_window::of_ask(label, &name)).click();
            window.run();
        };
        if let Kind::Choice(choices) = &ask.kind {
            let right = exercise_sheet::answer(Lang::En, ask);
            let wrong = choices.iter().map(|choice| choice_of(Lang::En, ask, choice)).find(|name| *name != right);
            window.harness.get_by_role_and_label(Role::RadioButton, &line(wrong.unwrap())).click();
        } else {
            let shape @ [rows, columns] = ask.shape();
            let name = exercises::ask(Lang::En, exercise, ask).replace("**", "");
            for place in (0..rows * columns).map(|k| [k / columns, k % columns]) {
                let field = exercise_window::field(Lang::En, &name, shape, place);
                window.harness.get_by_role_and_label(Role::TextInput, &field).focus();
                window.run();
                window.harness.get_by_role_and_label(Role::TextInput, &field).type_text("12345");
                window.run();
            }
        }
        window.run();
        let guesses = window.state().learn.exercises.asks_for_guess(ask);
        says(window, if guesses { t.guess } else { t.check });
        if let Some(choices) =
            Some(&ask.kind).filter(|_| !window.state().learn.exercises.checked.contains_key(&ask.name))
        {
            // The picture has moved. The next question is about the visible result.
            let Kind::Choice(choices) = choices else { panic!("a place is judged at once") };
            let right = exercise_sheet::answer(Lang::En, ask);
            let wrong = choices.iter().map(|choice| choice_of(Lang::En, ask, choice)).find(|name| *name != right);
            window.harness.get_by_role_and_label(Role::RadioButton, &line(wrong.unwrap())).click();
            window.run();
            says(window, t.check);
        }
        assert!(!window.state().learn.exercises.checked[&ask.name].judged.right);
    }
}

/// The bar stays in its place from step to step, and when a wrong answer gets its verdict.
#[test]
fn the_panel_of_a_lesson_keeps_its_height() {
    let mut moved = Vec::new();
    for size in [[1280.0, 720.0], [1920.0, 1080.0]] {
        for (place, shipped) in shipped().iter().enumerate() {
            let mut window = measured(place);
            window.harness.set_size(vec2(size[0], size[1]));
            window.run();
            let mut first = None;
            for (k, step) in shipped.lesson.steps.iter().enumerate() {
                let state = &mut window.app_mut().state;
                state.learn.go_to_step(&mut state.model, k);
                window.run();
                if let Some(Task::Question(entry)) = &step.task {
                    answer_wrongly(&mut window, &entry.exercise(0, &Default::default()));
                }
                let top = window.harness.get_by_label("◀ Back").rect().top();
                let first = *first.get_or_insert(top);
                if (top - first).abs() > 0.5 {
                    moved.push(format!(
                        "{} {} at {size:?}: {} from {first} to {top}",
                        shipped.lesson.id,
                        k + 1,
                        top - first
                    ));
                }
            }
        }
    }
    assert!(moved.is_empty(), "{moved:#?}");
}

/// On a projector of 1280 × 720 pixels, a question is shown with the button that checks or shows its answer. A short
/// one leaves more than half to the pictures.
#[test]
fn the_check_of_a_question_is_in_sight_on_a_small_projector() {
    let (mut out_of_sight, mut of_pictures) = (Vec::new(), Vec::new());
    for (place, shipped) in shipped().iter().enumerate() {
        let mut window = measured(place);
        window.key(Key::F11);
        // The size of the window is in points, which are larger now.
        window.harness.set_size(vec2(1280.0, 720.0) / window.harness.ctx.zoom_factor());
        window.run();
        let asks = |k: &usize| matches!(shipped.lesson.steps[*k].task, Some(Task::Question(_)));
        for k in (0..shipped.lesson.steps.len()).filter(asks) {
            for lang in [Lang::En, Lang::PtBr] {
                window.app_mut().state.model.settings.lang = lang;
                let state = &mut window.app_mut().state;
                state.learn.go_to_step(&mut state.model, k);
                window.run();
                window.key(Key::Q);
                window.run();
                let button = |label| window.harness.query(By::new().role(Role::Button).label_contains(label));
                let back = button("◀").unwrap().rect().top();
                of_pictures.push(back / window.harness.ctx.content_rect().height());
                let check = button(exercise_window::texts(lang).check);
                let check = check.or_else(|| button(exercise_window::texts(lang).guess));
                let check = check.or_else(|| button(words::texts(lang).show_answer)).unwrap();
                let bottom = check.rect().bottom();
                let screen = window.harness.ctx.content_rect();
                assert!((440.0..460.0).contains(&screen.height()), "{screen:?}");
                if bottom > screen.bottom() - 3.0 {
                    let beyond = bottom - screen.bottom();
                    out_of_sight.push(format!("{} {} {lang:?}: {beyond}", shipped.lesson.id, k + 1));
                }
            }
        }
    }
    assert!(out_of_sight.is_empty(), "{out_of_sight:#?}");
    assert!(of_pictures.iter().all(|share| *share >= 0.49), "{of_pictures:?}");
    assert!(of_pictures.iter().filter(|share| **share > 0.53).count() > 20, "{of_pictures:?}");
}

#[test]
fn steps_are_recorded_from_the_screen_and_played() {
    let folder = Folder::new("record");
    let file = folder.file("mine.toml");
    let mut window = Window::new(Lang::En);
    window.run();
    let record = |window: &mut Window| {
        window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::A);
        window.run();
    };
    record(&mut window);
    window.choose(&file);
    window.run();
    let mut second = *window.state().model.desk.shown.camera().parameters();
    second.near = 2.5;
    window.app_mut().state.model.desk.shown.set_parameters(second);
    window.run();
    // The file is known now.
    record(&mut window);
    let (lesson, text) = camera_lab_files::read_lesson(&file).unwrap();
    assert_eq!((lesson.id.as_str(), lesson.steps.len()), ("mine", 2));
    assert_eq!(lesson.steps[1].figure.camera, second);
    let added = text.rsplit("[[step]]").next().unwrap();
    assert!(added.contains("near = 2.5") && !added.contains("position"), "{added}");
    // Its texts are written at once.
    window.harness.key_press_modifiers(Modifiers::ALT, Key::R);
    window.run();
    assert!(window.state().learn.writes_lesson(&window.state().model) && step(&window) == 1);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::W);
    window.run();
    assert!(window.state().learn.lesson.is_none());
    // It opens as any file does.
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run();
    if window.state().file_flow.dialog.is_some() && window.state().model.desk.shown.is_changed() {
        window.harness.get_by_label_contains(en::WINDOW.dont_save).click();
        window.run();
    }
    window.choose(&file);
    window.run();
    assert_eq!(window.state().learn.lesson.as_ref().unwrap().lesson.id, "mine");
}

#[test]
fn links_of_a_text_open_pages_and_no_files() {
    let folder = Folder::new("links");
    let path = folder.file("mine.toml");
    let text = "id = \"x\"\ntitle = \"T\"\n[[step]]\ntitle = \"One\"\n\
        text = \"[here](file:///etc/passwd) and [there](https://example.org/)\"\n";
    std::fs::write(&path, text).unwrap();
    let (lesson, _) = camera_lab_files::read_lesson(&path).unwrap();
    let figure = (*lesson.steps[0].figure).clone();
    let lesson = Some(OpenLesson { lesson: lesson.into(), path: Some(path), step: 0 });
    let state = State::new(Start { figure, lang: Lang::En, lesson, ..Start::default() }).unwrap();
    let mut window = Window::with_state(state, [1280.0, 720.0]);
    let mut opened = |label: &str| {
        window.harness.get_by_label(label).click();
        let mut opened = Vec::new();
        for _ in 0..4 {
            window.harness.step();
            let commands = &window.harness.output().platform_output.commands;
            opened.extend(commands.iter().filter_map(|command| match command {
                eframe::egui::OutputCommand::OpenUrl(link) => Some(link.url.clone()),
                _ => None,
            }));
        }
        opened
    };
    assert_eq!(opened("here"), [""; 0]);
    assert_eq!(opened("there"), ["https://example.org/"]);
    assert!(window.says(camera_lab_words::window::texts(Lang::En).link_refused));
}

#[test]
fn work_in_a_step_waits_there_and_mere_trials_do_not() {
    let mut window = playing(0, 0, Lang::En);
    let camera = *window.state().model.desk.shown.camera().parameters();
    let tried = camera_lab::camera::Parameters { far: 77.0, ..camera };
    window.app_mut().state.model.desk.shown.set_parameters(tried);
    window.run();
    assert!(window.state().model.desk.shown.is_changed() && !window.state().model.is_unsaved());
    let turn = |window: &mut Window, step: usize| {
        let state = &mut window.app_mut().state;
        state.learn.go_to_step(&mut state.model, step);
        for _ in 0..200 {
            window.harness.step();
        }
    };
    turn(&mut window, 1);
    turn(&mut window, 0);
    assert_eq!(window.state().model.desk.shown.draft(), &camera, "it was tried");
    window.app_mut().state.model.desk.shown.set_parameters(tried);
    let point = NamedPoint { name: "Mine".to_owned(), position: glam::DVec3::ONE };
    window.app_mut().state.model.desk.shown.edit(|figure| figure.points.push(point));
    window.run();
    assert!(window.state().model.is_unsaved());
    turn(&mut window, 1);
    assert!(!window.state().model.is_unsaved() && window.state().would_lose_something());
    turn(&mut window, 0);
    assert_eq!(window.state().model.desk.shown.draft(), &tried, "it is work");
    // The step as it was is one undo step away from the work.
    let state = &mut window.app_mut().state;
    state.learn.step_again(&mut state.model);
    window.run();
    assert!(!window.state().model.is_unsaved());
    let state = &mut window.app_mut().state;
    state.learn.undo(&mut state.model, true);
    assert!(window.state().model.is_unsaved() && window.state().model.desk.shown.draft() == &tried);
}

/// A class answers by hands: letters count them, and the bars come with the answer.
#[test]
fn hands_of_a_class_are_counted_and_shown_with_the_answer() {
    let t = words::texts(Lang::En);
    let step_before = 0;
    let mut window = playing(0, step_before, Lang::En);
    window.key(Key::F11);
    // Without the question, letters are the usual shortcuts.
    window.key(Key::C);
    assert!(!window.state().learn.lesson.as_ref().unwrap().shows_text);
    window.key(Key::C);
    window.key(Key::Q);
    for key in [Key::A, Key::B, Key::B, Key::C] {
        window.key(key);
    }
    window.harness.key_press_modifiers(Modifiers::SHIFT, Key::C);
    window.run();
    assert!(window.says(&format!("{}: 3", t.hands)), "A, B, B");
    assert!(window.state().learn.lesson.as_ref().unwrap().shows_text, "C is a choice now");
    assert!(!window.says("✓"));
    window.key(Key::Q);
    assert!(window.says("✓") && !window.says(t.show_answer));
    // The answer has been seen: the next step comes at once, and the hands are still there on the way back.
    window.key(Key::PageDown);
    assert_eq!(step(&window), step_before + 1);
    window.key(Key::PageUp);
    if !window.state().learn.lesson.as_ref().unwrap().shows_question {
        window.key(Key::Q);
    }
    assert!(window.says(&format!("{}: 3", t.hands)));
}
