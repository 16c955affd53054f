//! Answers to exercises and their progress: judged again, reported with their numbers, beside a file of one's own.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::Parameters;
use camera_lab::exercises::Ask;
use camera_lab::gui::LaunchOptions;
use camera_lab::gui::learn::exercises::state::Chosen;
use camera_lab_words::Lang;
use camera_lab_words::learn::{exercise_window, exercises as said};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable as _;

use super::exercises::{fill, focused, made, right, window, window_of, working_on};
use super::files::Folder;
use super::window::Window;
use crate::words::en;

/// A window that keeps preferences and progress in a folder. The next one in the same folder is the program started
/// again.
fn keeping(folder: &Folder) -> Window {
    // With room for panels on both sides.
    let mut window = window_of(Lang::En, [1400.0, 1900.0]);
    window.app_mut().state.file_flow.native = false;
    let ctx = window.harness.ctx.clone();
    window.app_mut().keep_preferences(
        &ctx,
        &folder.file("config"),
        LaunchOptions { lang: Some(Lang::En), ..LaunchOptions::default() },
    );
    window.run();
    window
}

#[test]
fn the_exercises_key_moves_the_keyboard_there_and_closes_no_open_panel() {
    let folder = Folder::new("called");
    let call = |window: &mut Window| {
        window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
        window.run();
        (window.state().model.shows_exercises(), focused(window))
    };
    let search = Some("Search the exercises".to_owned());
    let mut first = keeping(&folder);
    assert_eq!(call(&mut first), (true, search.clone()));
    eframe::App::on_exit(first.app_mut(), None);
    let mut again = keeping(&folder);
    assert!(again.state().model.shows_exercises(), "the panel is remembered");
    assert_eq!(call(&mut again), (true, search.clone()));
    again.harness.event(Event::Text("axes of a camera".to_owned()));
    again.run();
    again.key(Key::Enter);
    assert_eq!(focused(&again).as_deref(), Some("Back to the list"));
    assert!(!call(&mut again).0, "called once more they go");
    assert_eq!(call(&mut again), (true, Some("Back to the list".to_owned())));
}

#[test]
fn a_reopened_exercise_is_judged_again_without_a_new_try() {
    let folder = Folder::new("judged-again");
    let (_, exercise) = made("basis", 1);
    let name_of = |name: &str| {
        let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
        (said::ask(Lang::En, &exercise, ask).replace("**", ""), right(ask))
    };
    let ((u, right_u), (n, right_n)) = (name_of("u"), name_of("n"));
    let open = |window: &mut Window| {
        window.app_mut().state.learn.exercises.work_on(Chosen { id: "basis".to_owned(), seed: 1 });
        window.run();
    };
    let mut first = keeping(&folder);
    first.click(en::WINDOW.exercises);
    open(&mut first);
    fill(&mut first, &u, 1, &right_u.iter().map(|text| format!("-({text})")).collect::<Vec<_>>());
    first.click(&format!("Check: {u}"));
    fill(&mut first, &n, 1, &right_n);
    first.click(&format!("Check: {n}"));
    eframe::App::on_exit(first.app_mut(), None);

    let mut again = keeping(&folder);
    open(&mut again);
    let exercises = &again.state().learn.exercises;
    assert_eq!(
        exercises.checked.iter().map(|(ask, c)| (ask.as_str(), c.judged.right)).collect::<Vec<_>>(),
        [("n", true), ("u", false)]
    );
    assert!(exercises.checked["u"].judged.diagnosis.is_some());
    assert_eq!(exercises.progress.tried("basis").unwrap().tries, 2, "no new try");
    // Text typed since is not judged before you ask for it.
    fill(&mut again, &u, 1, &["1".to_owned(), "0".to_owned(), "0".to_owned()]);
    eframe::App::on_exit(again.app_mut(), None);
    let mut last = keeping(&folder);
    open(&mut last);
    assert_eq!(last.state().learn.exercises.checked.keys().collect::<Vec<_>>(), ["n"]);
}

#[test]
fn a_verdict_on_an_axis_calls_it_an_axis_and_a_change_hides_its_camera() {
    let mut window = working_on("basis", 1, Lang::En);
    let (_, exercise) = made("basis", 1);
    let ask = |name: &str| exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    let name = |ask: &Ask| said::ask(Lang::En, &exercise, ask).replace("**", "");
    let camera = exercise.subject.camera().unwrap();
    let texts = |v: glam::DVec3| v.to_array().map(|x| format!("{x:.9}")).to_vec();
    let answer = |window: &mut Window, axis: &str, v| {
        let name = name(ask(axis));
        fill(window, &name, 1, &texts(v));
        window.click(&format!("Check: {name}"));
        window.click(&format!("Show the camera of your answer: {name}"));
        window.state().learn.exercises.described.clone().unwrap().camera
    };
    let basis = camera.basis();
    // Looking the other way, from the same place.
    let turned = answer(&mut window, "n", -basis.n).unwrap();
    assert!(turned.basis().n.distance(-basis.n) < 1e-6 && turned.position() == camera.position());
    // On its head.
    let turned = answer(&mut window, "u", -basis.u).unwrap();
    assert!(turned.basis().u.distance(-basis.u) < 1e-6 && turned.basis().n.distance(basis.n) < 1e-6);
    let u = name(ask("u"));
    window.harness.get_by_role_and_label(Role::TextInput, &format!("{u} 1")).click();
    window.run();
    window.harness.event(Event::Text("1".to_owned()));
    window.run();
    assert!(window.state().learn.exercises.described.is_none(), "another answer is another camera");
    assert!(answer(&mut window, "u", 2.0 * basis.u).is_err());
    assert!(window.says("your vector has length 2, but an axis of a camera has length 1"));
    assert!(answer(&mut window, "u", basis.n).is_err());
    assert!(window.says("your vector is not perpendicular to n: their scalar product is 1, not 0"));
}

#[test]
fn too_few_numbers_give_both_counts_and_a_whole_answer_is_marked() {
    let mut window = working_on("basis", 1, Lang::En);
    let (_, exercise) = made("basis", 1);
    let ask = exercise.asks.iter().find(|ask| ask.name == "u").unwrap();
    let name = said::ask(Lang::En, &exercise, ask).replace("**", "");
    window.harness.get_by_role_and_label(Role::TextInput, &format!("{name} 1")).click();
    window.run();
    window.harness.event(Event::Text("[1, 2]".to_owned()));
    window.run();
    window.command_key(Key::Enter);
    assert!(window.says("Expected 3 numbers, got 2."));
    let signs = |window: &Window, sign: &str| window.written().iter().filter(|(text, _)| text == sign).count();
    assert_eq!((signs(&window, "✗"), signs(&window, "✓")), (1, 0));
    window.command_key(Key::L);
    assert!(window.says("Esperavam-se 3 números, foram dados 2."));
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text(format!("[{}]", right(ask).join("; "))));
    window.run();
    window.command_key(Key::Enter);
    assert_eq!((signs(&window, "✗"), signs(&window, "✓")), (0, 1));
}

#[test]
fn a_lecturers_own_message_goes_with_the_expected_answer() {
    let lecture = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/exercises");
    let mut window = window(Lang::En);
    window.app_mut().state.learn.exercises.look_into(Some(lecture.into()));
    window.click(en::WINDOW.exercises);
    window.app_mut().state.learn.exercises.work_on(Chosen { id: "house-view".to_owned(), seed: 0 });
    window.run();
    let answer = ["3/13", "4/13", "12/13"].map(str::to_owned);
    fill(&mut window, "n afterwards", 1, &answer);
    window.click("Check: n afterwards");
    assert!(window.says("✗ wrong") && window.says("before the azimuth."));
    window.click("A hint: n afterwards");
    assert!(window.says("Which of the two cameras is asked about?"));
    window.command_key(Key::L);
    assert!(window.says("de antes do azimute.") && window.says("De qual das duas câmeras se trata?"));
}

#[test]
fn other_files_of_a_folder_are_one_quiet_line_that_opens() {
    let folder = Folder::new("foreign-exercises");
    let good =
        "id = \"mine\"\ntitle = \"My own\"\nstatement = \"S\"\n[[ask]]\nname = \"a\"\ntext = \"A\"\nanswer = 1\n";
    std::fs::write(folder.file("good.toml"), good).unwrap();
    std::fs::write(folder.file("figure.toml"), "[camera]\nfar = 50.0\n").unwrap();
    std::fs::write(folder.file("hostile.toml"), good.replace("S\"", "$\\\\input{x}$\"").replace("mine", "other"))
        .unwrap();
    std::fs::create_dir(folder.file("d.toml")).unwrap();
    let mut window = window(Lang::En);
    window.app_mut().state.learn.exercises.look_into(folder.file("good.toml").parent().map(Into::into));
    window.click(en::WINDOW.exercises);
    assert!(window.says("My own") && !window.says(en::WINDOW.untitled_file));
    window.click("Skipped in the folder: 3");
    assert!(window.says("figure.toml, line 1: id is missing"));
    assert!(window.says("hostile.toml, line 3: statement has the formula") && window.says("\\input"));
    assert!(window.says("d.toml is a directory"));
    window.command_key(Key::L);
    assert!(window.says("Ignorados na pasta: 3") && window.says("figure.toml, linha 1"));
}

#[test]
fn the_figure_of_an_exercise_leaves_the_file_of_ones_own_as_it_is() {
    let folder = Folder::new("lent");
    let file = folder.file("mine.toml");
    let text = "# mine\n[camera]\nposition = [1, 2, 9] # from here\n";
    std::fs::write(&file, text).unwrap();
    let mut window = Window::opened(&file);
    let own = window.state().model.desk.shown.figure().clone();
    window.app_mut().state.learn.exercises.work_on(Chosen { id: "basis".to_owned(), seed: 1 });
    window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
    window.run();
    window.click(en::EXERCISE_WINDOW.show_figure);
    assert_ne!(window.state().model.desk.shown.figure(), &own);
    let scene = &window.state().model.desk.shown.figure().scene;
    assert!(!scene.objects.is_empty() && window.state().model.tree.names(scene).is_empty(), "nothing is selected");
    // Saving asks for a file.
    window.command_key(Key::S);
    assert!(window.harness.query_by_role_and_label(Role::TextInput, "file").is_some());
    window.choose(&folder.file("theirs.toml"));
    assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
    assert!(std::fs::read_to_string(folder.file("theirs.toml")).unwrap().contains("[camera]"));
}

#[test]
fn undoing_the_figure_of_an_exercise_leads_back_to_the_file_of_ones_own() {
    let folder = Folder::new("lent-and-back");
    let file = folder.file("mine.toml");
    std::fs::write(&file, "# mine\n[camera]\nposition = [1, 2, 9] # from here\n").unwrap();
    let mut window = Window::opened(&file);
    window.app_mut().state.learn.exercises.work_on(Chosen { id: "basis".to_owned(), seed: 1 });
    window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
    window.run();
    window.click(en::EXERCISE_WINDOW.show_figure);
    assert_eq!(window.state().model.desk.shown.path(), None);
    window.key(Key::Escape);
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.path(), Some(&file));
    let parameters = *window.state().model.desk.shown.camera().parameters();
    window.app_mut().state.model.desk.shown.set_parameters(Parameters { near: 0.5, ..parameters });
    window.run();
    window.command_key(Key::S);
    let saved = std::fs::read_to_string(&file).unwrap();
    assert!(
        saved.starts_with("# mine\n[camera]\nposition = [1, 2, 9] # from here\n") && saved.contains("near = 0.5"),
        "{saved}"
    );
}

#[test]
fn enter_goes_on_to_the_next_empty_field_and_then_checks() {
    let mut window = working_on("basis", 1, Lang::En);
    let (_, exercise) = made("basis", 1);
    let ask = exercise.asks.iter().find(|ask| ask.name == "u").unwrap();
    let name = said::ask(Lang::En, &exercise, ask).replace("**", "");
    window.harness.get_by_role_and_label(Role::TextInput, &format!("{name} 1")).click();
    window.run();
    for (k, text) in right(ask).into_iter().enumerate() {
        assert_eq!(focused(&window), Some(format!("{name} {}", k + 1)));
        assert!(window.state().learn.exercises.checked.is_empty());
        window.harness.event(Event::Text(text));
        window.run();
        window.key(Key::Enter);
    }
    assert!(window.state().learn.exercises.checked["u"].judged.right);
    assert_eq!(focused(&window), Some(format!("{name} 3")), "the keyboard stays");
}

#[test]
fn the_next_help_keeps_the_keyboard_and_comes_into_sight() {
    /// Higher than a verdict, lower than the way.
    const HEIGHT: f32 = 720.0;
    let mut window = working_on("basis", 1, Lang::En);
    window.harness.set_size(eframe::egui::vec2(1280.0, HEIGHT));
    window.run();
    let (_, exercise) = made("basis", 1);
    let ask = exercise.asks.iter().find(|ask| ask.name == "u").unwrap();
    let name = said::ask(Lang::En, &exercise, ask).replace("**", "");
    let wrong: Vec<String> = right(ask).iter().map(|text| format!("-({text})")).collect();
    fill(&mut window, &name, 1, &wrong);
    window.key(Key::Enter);
    for _ in 0..2 {
        window.key(Key::Tab);
    }
    let helps = ["A hint", "A stronger hint", "A worked step", "The next step"].map(|help| format!("{help}: {name}"));
    let mut pressed = Vec::new();
    while let Some(help) = focused(&window).filter(|label| helps.contains(label)) {
        let place = window.harness.get_by_role_and_label(Role::Button, &help).rect();
        assert!(place.min.y > 0.0 && place.max.y < HEIGHT, "{help} is at {place:?} after {pressed:?}");
        pressed.push(help);
        window.key(Key::Enter);
    }
    assert!(pressed.len() > 3 && helps.iter().all(|help| pressed.contains(help)), "{pressed:?}");
    assert_eq!(window.state().learn.exercises.opened["u"].steps, ask.steps().len());
    assert_eq!(focused(&window), Some(format!("{name} 1")), "after the last step the keyboard is at the answer");
}

#[test]
fn the_button_that_checks_stays_where_it_is_while_an_answer_is_typed() {
    for id in ["view-matrix", "basis", "window", "depth-resolution"] {
        let mut window = working_on(id, 1, Lang::En);
        let (_, exercise) = made(id, 1);
        let ask = &exercise.asks[0];
        let title = said::ask(Lang::En, &exercise, ask).replace("**", "");
        let button = |window: &Window| window.harness.get_by_label(&format!("Check: {title}")).rect();
        let understood = |window: &Window| window.says(exercise_window::texts(Lang::En).understood);
        let before = button(&window);
        assert!(!understood(&window));
        fill(&mut window, &title, ask.shape()[1], &right(ask));
        assert!(understood(&window));
        assert_eq!(button(&window), before, "{id}");
    }
}
