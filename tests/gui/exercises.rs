//! The exercises: from reading to a right answer, with the mouse and with the keyboard alone.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::Parameters;
use camera_lab::exercises::{Ask, Entry, Exercise, Expected, Free, Stage, entry};
use camera_lab::figure::{Explanation, ShownProbe};
use camera_lab::gui::learn::exercises::state::Chosen;
use camera_lab::gui::{LaunchOptions, Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_words::Lang;
use camera_lab_words::learn::{exercise_messages, exercise_window, exercises as said};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use glam::DVec2;

use super::files::Folder;
use super::window::Window;
use crate::words::en;

pub(super) fn window(lang: Lang) -> Window {
    // So high that nothing has to be scrolled, and not as narrow as one held in the hand.
    window_of(lang, [900.0, 1900.0])
}

pub(super) fn window_of(lang: Lang, size: [f32; 2]) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Empty;
    figure.style.antialias = camera_lab::appearance::Samples::One;
    let mut state =
        State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
    state.model.layout.maximized = Some(View::Image);
    let mut window = Window::with_state(state, size);
    window.run();
    window
}

/// A window in which an exercise is worked on.
pub(super) fn working_on(id: &str, seed: u64, lang: Lang) -> Window {
    let mut window = window(lang);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
    window.run();
    window.app_mut().state.learn.exercises.work_on(Chosen { id: id.to_owned(), seed });
    window.run();
    window
}

pub(super) fn made(id: &str, seed: u64) -> (&'static Entry, Exercise) {
    let entry = entry(id).unwrap();
    (entry, entry.exercise(seed, &Free::new()))
}

/// The numbers of the right answer, as they may be typed.
pub(super) fn right(ask: &Ask) -> Vec<String> {
    ask.expected().table().unwrap().entries.iter().map(|value| format!("{value:.9}")).collect()
}

/// Types into fields, which are found by their names.
pub(super) fn fill(window: &mut Window, ask: &str, columns: usize, texts: &[String]) {
    for (k, text) in texts.iter().enumerate() {
        let name = match (texts.len(), columns) {
            (1, 1) => ask.to_owned(),
            (_, 1) => format!("{ask} {}", k + 1),
            _ => format!("{ask} row {}, column {}", k / columns + 1, k % columns + 1),
        };
        window.harness.get_by_role_and_label(Role::TextInput, &name).click();
        window.run();
        window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        window.harness.event(Event::Text(text.clone()));
        window.run();
    }
}

pub(super) fn focused(window: &Window) -> Option<String> {
    let node = window.harness.query_all_by(|node| node.is_focused()).next()?;
    node.accesskit_node().label()
}

#[test]
fn a_wrong_view_matrix_is_explained_and_seen_and_then_put_right_with_the_mouse() {
    let mut window = window(Lang::En);
    let own = window.state().model.desk.shown.figure().clone();
    assert!(!window.state().model.shows_exercises(), "off at the start");
    window.click(en::WINDOW.exercises);
    assert_eq!(window.state().model.explained.shown(), Explanation::Exercises);
    window.click(&format!("The view matrix, [0] §5.3.1, (5.7), {}", en::EXERCISE_WINDOW.untouched));
    let (_, exercise) = made("view-matrix", 0);
    let ask = &exercise.asks[0];
    // −C in the last column, not turned into the VRC.
    let mut wrong = right(ask);
    let c = exercise.subject.figure.camera.position;
    for (row, value) in c.to_array().into_iter().enumerate() {
        wrong[4 * row + 3] = format!("{}", -value);
    }
    fill(&mut window, "M_v", 4, &wrong);
    assert!(window.says(en::EXERCISE_WINDOW.understood));
    assert!(window.harness.query_by_label_contains("✗").is_none(), "nothing is judged before it is asked for");
    window.click("Check: M_v");
    assert!(window.says("✗ wrong"));
    let checked = &window.state().learn.exercises.checked["Mv"];
    assert_eq!(checked.judged.diagnosis.as_ref().unwrap().causes[0].mistake.code(), "translation-not-rotated");
    let diagnosis = said::diagnosis(Lang::En, ask, &checked.judged).unwrap();
    let begins: String = diagnosis.chars().take_while(|c| !"*_".contains(*c)).collect();
    assert!(window.says(begins.trim()), "{begins}");
    assert_eq!(window.state().learn.exercises.stage("view-matrix"), Stage::Begun);

    // The camera of the matrix stands beside the right one, until Escape.
    window.click("Show the camera of your answer: M_v");
    let described = window.state().learn.exercises.described.clone().unwrap().camera.unwrap();
    let right_camera = exercise.subject.camera().unwrap();
    assert_eq!(window.state().model.desk.shown.figure().camera, exercise.subject.figure.camera, "the right one is set");
    assert!(described.position().distance(right_camera.position()) > 0.1);
    window.app_mut().state.model.desk.shown.show_mut().probe = Some(ShownProbe::Window(DVec2::ZERO));
    window.run();
    window.key(Key::Escape);
    assert!(
        window.state().learn.exercises.described.is_none() && window.state().model.pinned().is_some(),
        "one after the other"
    );
    window.key(Key::Escape);
    assert!(window.state().model.pinned().is_none());
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure(), &own, "one step leads back to the own figure");

    window.click("A hint: M_v");
    window.click("A stronger hint: M_v");
    assert!(window.harness.query_by_label("A hint: M_v").is_none());
    window.click("A worked step: M_v");
    assert!(window.says("‖") || window.says("n_x"), "a step of the way, set");
    fill(&mut window, "M_v", 4, &right(ask));
    window.click("Check: M_v");
    assert!(window.says("✓ right") && window.says(en::EXERCISE_WINDOW.all_right));
    assert_eq!(window.state().learn.exercises.stage("view-matrix"), Stage::Solved);

    window.click(en::EXERCISE_WINDOW.show_figure);
    assert_eq!(window.state().model.desk.shown.figure().camera, exercise.subject.figure.camera);
    window.click(en::EXERCISE_WINDOW.back);
    let row = format!("The view matrix, [0] §5.3.1, (5.7), {}", en::EXERCISE_WINDOW.solved);
    assert_eq!(focused(&window).as_deref(), Some(row.as_str()));
}

#[test]
fn the_same_with_the_keyboard_alone() {
    let mut window = window(Lang::En);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
    window.run();
    let tab_to = |window: &mut Window, name: &str| {
        for _ in 0..200 {
            if focused(window).as_deref() == Some(name) {
                return;
            }
            window.key(Key::Tab);
        }
        panic!("{name} is not reached");
    };
    tab_to(&mut window, "Search the exercises");
    window.harness.event(Event::Text("axes of a camera".to_owned()));
    window.run();
    window.key(Key::Enter);
    let open = window.state().learn.exercises.open.clone().unwrap();
    let (_, exercise) = made(&open.id, open.seed);
    assert_eq!(open.id, "basis");
    let ask = exercise.asks.iter().find(|ask| ask.name == "u").unwrap();
    let name = said::ask(Lang::En, &exercise, ask).replace("**", "");
    let answer = right(ask);
    // The other way round, then right.
    for turn in [true, false] {
        for (k, text) in answer.iter().enumerate() {
            tab_to(&mut window, &format!("{name} {}", k + 1));
            let text = if turn { format!("-({text})") } else { text.clone() };
            window.harness.event(Event::Text(text));
            window.run();
        }
        window.command_key(Key::Enter);
        let judged = &window.state().learn.exercises.checked["u"].judged;
        assert_eq!(judged.right, !turn, "{:?}", judged.understood);
        if turn {
            let code = judged.diagnosis.as_ref().unwrap().causes[0].mistake.code();
            assert!(["u-reversed", "sign", "n-reversed"].contains(&code), "{code}");
            tab_to(&mut window, &format!("A hint: {name}"));
            window.key(Key::Enter);
            assert!(window.says("Hint:"));
            tab_to(&mut window, &format!("Show the camera of your answer: {name}"));
        }
    }
    tab_to(&mut window, "Show the figure");
    window.key(Key::Space);
    assert_eq!(window.state().model.desk.shown.figure().camera, exercise.subject.figure.camera);
}

#[test]
fn an_unreadable_answer_costs_nothing_and_nothing_typed_is_lost() {
    let mut window = working_on("view-matrix", 2, Lang::En);
    fill(&mut window, "M_v", 4, &["1/sqrt(3".to_owned(), "0,5".to_owned(), "2/3".to_owned()]);
    assert!(window.says("⚠"), "the message is at the field");
    window.command_key(Key::Enter);
    assert!(window.state().learn.exercises.checked.is_empty());
    let typed = window.state().learn.exercises.typed.clone();
    // Another exercise, another language, hidden, undone, a new figure: it is still there.
    window.click(en::EXERCISE_WINDOW.new_numbers);
    assert_eq!(window.state().learn.exercises.open.as_ref().unwrap().seed, 3);
    window.click(en::EXERCISE_WINDOW.back);
    window.command_key(Key::L);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
    window.run();
    assert!(!window.state().model.shows_exercises());
    window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
    window.run();
    window.command_key(Key::Z);
    window.app_mut().state.learn.exercises.work_on(Chosen { id: "view-matrix".to_owned(), seed: 2 });
    window.run();
    assert_eq!(
        window.state().learn.exercises.typed[&Chosen { id: "view-matrix".to_owned(), seed: 2 }].answers["Mv"][..3],
        {
            let of = |window: &camera_lab::gui::learn::exercises::state::Typed| window.answers["Mv"][..3].to_vec();
            of(typed.values().next().unwrap())
        }
    );
    let field = window.harness.get_by_role_and_label(Role::TextInput, "M_v linha 1, coluna 2");
    assert_eq!(field.value().as_deref(), Some("0,5"));
}

#[test]
fn a_whole_matrix_may_be_typed_into_the_first_field_and_half_of_one_counts_half() {
    let mut window = working_on("view-matrix", 1, Lang::En);
    let (_, exercise) = made("view-matrix", 1);
    let numbers = right(&exercise.asks[0]);
    let rows: Vec<String> = numbers.chunks(4).map(|row| format!("[{}]", row.join(", "))).collect();
    fill(&mut window, "M_v", 4, &[format!("[{}]", rows.join(", "))]);
    window.command_key(Key::Enter);
    assert!(window.state().learn.exercises.checked["Mv"].judged.right);
    let half: Vec<String> = numbers[..8].to_vec();
    let mut window = working_on("view-matrix", 1, Lang::En);
    fill(&mut window, "M_v", 4, &half);
    window.command_key(Key::Enter);
    assert!(window.says(&format!("✗ wrong ({})", exercise_messages::right_of(Lang::En, 8, 16))));
}

#[test]
fn the_camera_of_the_window_is_an_answer_and_the_picture_to_match_is_shown() {
    let mut window = working_on("match-picture", 3, Lang::PtBr);
    let t = exercise_window::texts(Lang::PtBr);
    assert!(window.says(exercise_messages::texts(Lang::PtBr).target));
    assert!(window.says(t.other_figure));
    window.click(t.show_figure);
    assert!(!window.says(t.other_figure));
    window.click(t.take_camera);
    window.command_key(Key::Enter);
    assert!(!window.state().learn.exercises.checked["camera"].judged.right, "where one begins");
    let (_, exercise) = made("match-picture", 3);
    let Expected::Camera(_, model, ..) = exercise.asks[0].expected() else { panic!("a camera") };
    let wanted: Parameters = **model;
    window.app_mut().state.model.desk.shown.set_parameters(wanted);
    window.run();
    window.click(t.take_camera);
    window.command_key(Key::Enter);
    assert!(window.state().learn.exercises.checked["camera"].judged.right);
    assert!(window.says(&format!("✓ {}", t.right)));
}

/// B16: a question comes before the picture that answers it.
#[test]
fn a_prediction_is_answered_before_its_figure_is_shown() {
    let mut window = working_on("predict-visible", 4, Lang::En);
    let t = exercise_window::texts(Lang::En);
    assert!(window.says(t.figure_later) && window.harness.query_by_label(t.show_figure).is_none());
    let (_, exercise) = made("predict-visible", 4);
    let yes = said::choice(Lang::En, "yes");
    for k in 0..exercise.asks.len() {
        window.harness.get_all_by_role_and_label(Role::RadioButton, yes).nth(k).unwrap().click();
        window.run();
    }
    window.command_key(Key::Enter);
    window.click(t.show_figure);
    let points = &window.state().model.desk.shown.figure().points;
    assert_eq!(points.iter().map(|point| point.name.as_str()).collect::<Vec<_>>(), ["P", "Q", "R"]);
    assert_eq!(points[1].position, exercise.subject.points[1]);
}

/// B17.
#[test]
fn the_figure_shows_the_answer_once_every_question_has_been_tried() {
    let mut window = working_on("0-5.1", 1, Lang::En);
    let t = exercise_window::texts(Lang::En);
    window.click(t.show_figure);
    let names = |window: &Window| -> Vec<String> {
        window.state().model.desk.shown.figure().points.iter().map(|point| point.name.clone()).collect()
    };
    assert!(names(&window).is_empty(), "C + u + v is what is asked for");
    let (_, exercise) = made("0-5.1", 1);
    for ask in &exercise.asks {
        fill(
            &mut window,
            &said::ask(Lang::En, &exercise, ask).replace("**", ""),
            1,
            &["1", "2", "3"].map(str::to_owned),
        );
        window.command_key(Key::Enter);
    }
    assert_eq!(window.state().learn.exercises.checked.len(), 4);
    window.click(t.show_figure);
    assert_eq!(names(&window), ["O_R"]);

    let window = working_on("elevation", 1, Lang::En);
    assert!(
        window.harness.get_by_label(t.do_operations).accesskit_node().is_disabled(),
        "C afterwards is what is asked for"
    );
    let window = working_on("inside", 1, Lang::PtBr);
    assert!(window.says(exercise_window::texts(Lang::PtBr).figure_later));
}

#[test]
fn all_exercises_are_shown_in_both_languages() {
    let mut window = window(Lang::En);
    window.click(en::WINDOW.exercises);
    for entry in camera_lab::exercises::entries() {
        let seed = u64::from(entry.is_family);
        window.app_mut().state.learn.exercises.work_on(Chosen { id: entry.id.clone().into_owned(), seed });
        for _ in 0..2 {
            window.command_key(Key::L);
            let lang = window.state().model.settings.lang;
            assert!(window.says(said::title(lang, entry)), "{}", entry.id);
            assert!(window.says(exercise_window::texts(lang).check), "{}", entry.id);
            let written = window.written();
            assert!(!written.iter().any(|(text, _)| text.contains("**") || text.contains('{')), "{}", entry.id);
        }
    }
}

#[test]
fn numbers_left_open_are_chosen_and_answers_may_depend_on_them() {
    let mut window = working_on("0-5.2", 0, Lang::En);
    let field = window.harness.get_by_role_and_label(Role::TextInput, "F");
    field.click();
    window.run();
    window.harness.event(Event::Text("2".to_owned()));
    window.run();
    let free: Free = [("F".to_owned(), 2.0)].into();
    let exercise = entry("0-5.2").unwrap().exercise(0, &free);
    let ask = exercise.asks.iter().find(|ask| ask.name == "Mp").unwrap();
    let name = said::ask(Lang::En, &exercise, ask).replace("**", "");
    fill(&mut window, &name, 4, &right(ask));
    window.command_key(Key::Enter);
    assert!(window.state().learn.exercises.checked["Mp"].judged.right);
}

/// B15: the next exercise, and why it is the next.
#[test]
fn progress_is_counted_shown_exported_as_a_table_and_deleted_on_request() {
    let folder = Folder::new("progress");
    let mut window = working_on("view-matrix", 1, Lang::En);
    window.app_mut().state.file_flow.native = false;
    window.app_mut().state.model.settings.welcomed = true;
    let ctx = window.harness.ctx.clone();
    window.app_mut().keep_preferences(
        &ctx,
        &folder.file("config"),
        LaunchOptions { lang: Some(Lang::En), ..LaunchOptions::default() },
    );
    let (_, exercise) = made("view-matrix", 1);
    let mut wrong = right(&exercise.asks[0]);
    let c = exercise.subject.camera().unwrap().position();
    for (row, value) in c.to_array().into_iter().enumerate() {
        wrong[4 * row + 3] = format!("{}", -value);
    }
    fill(&mut window, "M_v", 4, &wrong);
    window.click("Check: M_v");
    window.click("A hint: M_v");
    let tried = window.state().learn.exercises.progress.tried("view-matrix").unwrap();
    assert_eq!((tried.tries, tried.seed, tried.hints["Mv"]), (1, 1, 1));
    // The same family with new numbers, because of the mistake. The window shows this reason.
    window.click(en::EXERCISE_WINDOW.practise_next);
    assert_eq!(window.state().learn.exercises.open, Some(Chosen { id: "view-matrix".to_owned(), seed: 2 }));
    assert!(window.says("It practises a mistake that you made once"));
    window.command_key(Key::L);
    assert!(window.says("Ele exercita um erro que você cometeu uma vez"));
    window.command_key(Key::L);

    window.click(en::EXERCISE_WINDOW.back);
    window.click(en::EXERCISE_WINDOW.progress);
    assert!(window.says("progress.toml") && window.says("1 ×"));
    window.click(en::EXERCISE_WINDOW.export_progress);
    let table = folder.file("mine");
    window.choose(&table);
    let table = std::fs::read_to_string(table.with_extension("csv")).unwrap();
    assert!(table.contains("mistake,translation-not-rotated,1,"), "{table}");

    window.click("Delete progress…");
    assert!(window.says("progress.bak"));
    window.click(en::WINDOW.cancel);
    assert!(!window.state().learn.exercises.progress.is_empty());
    window.click("Delete progress…");
    window.harness.get_by_role_and_label(Role::Button, "Delete progress").click();
    window.run();
    window.run();
    assert!(window.state().learn.exercises.progress.is_empty() && window.state().learn.exercises.typed.is_empty());
    assert!(
        matches!(&window.state().model.message, Some(camera_lab_desk::message::Message::ProgressDeleted(_))),
        "{:?}",
        window.state().model.message
    );
    let kept = std::fs::read_to_string(folder.file("config").join("progress.bak")).unwrap();
    assert!(kept.contains("translation-not-rotated"), "{kept}");
}

#[test]
fn own_exercises_stand_beside_the_others_and_a_faulty_file_is_named() {
    let folder = Folder::new("own-exercises");
    let lecture = folder.file("graphics course");
    std::fs::create_dir_all(&lecture).unwrap();
    let house = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/exercises/house-view.toml");
    std::fs::copy(house, lecture.join("house-view.toml")).unwrap();
    std::fs::write(lecture.join("faulty.toml"), "id = \"faulty\"\ntitle = 3\n").unwrap();
    let remembering = || {
        let mut window = window(Lang::En);
        window.app_mut().state.file_flow.native = false;
        let ctx = window.harness.ctx.clone();
        window.app_mut().keep_preferences(
            &ctx,
            &folder.file("config"),
            LaunchOptions { lang: Some(Lang::En), ..LaunchOptions::default() },
        );
        window.run();
        if !window.state().model.shows_exercises() {
            window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
            window.run();
        }
        window
    };
    let mut window = remembering();
    window.click(en::EXERCISE_WINDOW.own_open);
    window.choose(&lecture);
    assert!(window.says("graphics course"), "the group has the folder's name");
    window.click("Skipped in the folder: 1");
    let told: Vec<String> = window.written().into_iter().map(|(text, _)| text).collect();
    let told = told.join(" ").split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("faulty.toml") && told.contains("line 1: statement is missing"), "{told}");
    let own = window.state().learn.exercises.entry("house-view").unwrap().clone();
    let title = said::title(Lang::En, &own).to_owned();
    window.click(&format!("{title}, {}", en::EXERCISE_WINDOW.untouched));
    let exercise = own.exercise(0, &Free::new());
    let ask = exercise.asks.iter().find(|ask| !ask.own_mistakes.is_empty()).unwrap();
    let message = said::ask(Lang::En, &exercise, ask).replace("**", "");
    assert!(window.harness.query_by_label(&format!("Check: {message}")).is_some(), "{message}");
    eframe::App::on_exit(window.app_mut(), None);

    // Remembered, and gone: said, and nothing else happens.
    let next = remembering();
    assert!(next.state().learn.exercises.entry("house-view").is_some());
    drop(next);
    std::fs::remove_dir_all(&lecture).unwrap();
    let mut gone = remembering();
    assert!(gone.says("graphics course") && gone.state().learn.exercises.entry("basis").is_some());
    gone.click(en::EXERCISE_WINDOW.own_close);
    assert!(gone.state().learn.exercises.own.is_none() && !gone.says("graphics course"));
}

#[test]
fn question_field_and_button_are_in_sight_together_in_a_step_of_a_lesson() {
    for lang in [Lang::En, Lang::PtBr] {
        for step in 1..=6 {
            let lesson = camera_lab::lessons::shipped().iter().position(|shipped| shipped.lesson.id == "sheet");
            let window = super::lessons::playing(lesson.unwrap(), step, lang);
            let t = exercise_window::texts(lang);
            let name = format!("{}: ", t.check);
            let checks = window.harness.query_all_by_label_contains(&name);
            let button = checks.map(|node| node.rect()).min_by(|a, b| a.top().total_cmp(&b.top())).unwrap();
            let fields = window
                .harness
                .query_all_by_role(Role::TextInput)
                .chain(window.harness.query_all_by_role(Role::MultilineTextInput));
            let above = fields.map(|node| node.rect()).filter(|field| field.bottom() <= button.top());
            let field = above.max_by(|a, b| a.bottom().total_cmp(&b.bottom())).unwrap();
            assert!(button.bottom() <= 720.0, "{lang:?} {step}: {button:?}");
            assert!(
                field.top() >= 26.0 && button.top() - field.bottom() < 30.0,
                "{lang:?} {step}: {field:?} {button:?}"
            );
        }
    }
}
