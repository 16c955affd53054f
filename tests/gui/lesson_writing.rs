//! A lesson of the user's own, written in the window: texts beside their preview, the order of steps, and the way back.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::path::{Path, PathBuf};

use camera_lab::exercises::{Ask, judge_answer, read_answer};
use camera_lab::figure::Localized;
use camera_lab::gui::{Start, State};
use camera_lab::lessons::{Lesson, OpenLesson, Task, shipped, with_step};
use camera_lab_files::read_lesson;
use camera_lab_files::share::{self, Held};
use camera_lab_words::Lang;
use camera_lab_words::learn::lesson_tasks as tasks;
use camera_lab_words::learn::lessons as words;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use super::files::Folder;
use super::sessions::written;
use super::window::Window;
use crate::words::en;

/// A window that plays the user's copy of a lesson.
fn own(folder: &Folder, step: usize) -> (Window, PathBuf) {
    let path = folder.file("mine.toml");
    std::fs::write(&path, shipped()[1].text).unwrap();
    (playing(&path, step), path)
}

pub(crate) fn playing(path: &Path, step: usize) -> Window {
    playing_in(path, step, Lang::En)
}

fn playing_in(path: &Path, step: usize, lang: Lang) -> Window {
    let (lesson, _) = read_lesson(path).unwrap();
    let figure = (*lesson.steps[step].figure).clone();
    let lesson = Some(OpenLesson { lesson: lesson.into(), path: Some(path.to_owned()), step });
    let mut state = State::new(Start { figure, lang, lesson, ..Start::default() }).unwrap();
    state.file_flow.native = false;
    let mut window = Window::with_state(state, [1280.0, 720.0]);
    window.run();
    window
}

pub(crate) fn write(window: &mut Window) {
    window.harness.key_press_modifiers(Modifiers::ALT, Key::R);
    window.run();
    // Another frame: the panel has its height by then.
    window.run();
}

fn titles(path: &Path) -> Vec<String> {
    read_lesson(path).unwrap().0.steps.iter().map(|step| step.title.en.clone()).collect()
}

fn of(lesson: &Lesson) -> Vec<String> {
    lesson.steps.iter().map(|step| step.title.en.clone()).collect()
}

/// Types into a field of the editor, in place of its text.
pub(crate) fn type_into(window: &mut Window, field: &str, text: &str) {
    let is_named = |role| window.harness.query_by_role_and_label(role, field);
    is_named(Role::TextInput).or_else(|| is_named(Role::MultilineTextInput)).unwrap().focus();
    window.run();
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.run();
    window.harness.event(Event::Text(text.to_owned()));
    window.run();
}

#[test]
fn typed_text_is_shown_at_once_and_in_the_file_soon() {
    let folder = Folder::new("write");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    write(&mut window);
    // A class sees neither the fields nor the notes.
    for is_written in [false, true] {
        window.key(Key::F11);
        let field = window.harness.query_by_role_and_label(Role::MultilineTextInput, t.step_text_field);
        assert_eq!(field.is_some(), is_written);
    }
    type_into(&mut window, t.step_text_field, "The axis n is {basis.n:2}.");
    let shown = &window.state().learn.lesson.as_ref().unwrap().lesson.steps[1];
    assert_eq!(shown.text.en, "The axis n is {basis.n:2}.");
    // A second without a key.
    for _ in 0..100 {
        window.harness.step();
    }
    let (lesson, _) = read_lesson(&path).unwrap();
    assert_eq!(lesson.steps[1].text.en, "The axis n is {basis.n:2}.");
    assert_eq!(lesson.steps[1].text.pt_br, shipped()[1].lesson.steps[1].text.pt_br, "the other language stays");
    window.click(en::WINDOW.undo);
    assert_eq!(read_lesson(&path).unwrap().1, shipped()[1].text, "to the letter");
    assert_eq!(window.state().learn.lesson.as_ref().unwrap().step, 1);
    window.click(en::WINDOW.redo);
    assert_eq!(read_lesson(&path).unwrap().0.steps[1].text.en, "The axis n is {basis.n:2}.");
    // A change after the way back leaves nothing to redo. Ctrl+S writes it without a pause.
    window.click(en::WINDOW.undo);
    type_into(&mut window, t.step_text_field, "Another text.");
    window.command_key(Key::S);
    assert_eq!(read_lesson(&path).unwrap().0.steps[1].text.en, "Another text.");
    assert!(
        !window.state().learn.can_undo_lesson(&window.state().model, false)
            && window.state().file_flow.dialog.is_none()
    );
}

/// Waits a second without a key.
pub(crate) fn pause(window: &mut Window) {
    for _ in 0..100 {
        window.harness.step();
    }
}

#[test]
fn title_sentence_and_minutes_of_the_lesson_are_written_and_taken_back() {
    let folder = Folder::new("write-lesson");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    write(&mut window);
    assert!(window.harness.query_by_role_and_label(Role::TextInput, t.lesson_title_field).is_none());
    window.click(t.of_lesson);
    assert!(window.harness.query_by_role_and_label(Role::TextInput, t.step_title_field).is_none());
    type_into(&mut window, t.lesson_title_field, "Axes of a camera");
    pause(&mut window);
    type_into(&mut window, t.lesson_sentence_field, "Keep **n**.");
    pause(&mut window);
    let (lesson, text) = read_lesson(&path).unwrap();
    let shipped = &shipped()[1];
    assert_eq!((lesson.title.en.as_str(), &lesson.title.pt_br), ("Axes of a camera", &shipped.lesson.title.pt_br));
    let (said, before) = (lesson.sentence.unwrap(), shipped.lesson.sentence.clone().unwrap());
    assert_eq!((said.en.as_str(), said.pt_br), ("Keep **n**.", before.pt_br));
    let steps = |text: &str| text[text.find("[[step]]").unwrap()..].to_owned();
    assert_eq!(steps(&text), steps(shipped.text), "to the letter");
    // The preview has the title with the minutes, as lists have it.
    window.harness.get_by_label(&words::with_minutes(Lang::En, &read_lesson(&path).unwrap().0));
    // A text that is no number of minutes gets a message, stays in its field, and holds the lesson.
    type_into(&mut window, t.lesson_minutes_field, "long");
    pause(&mut window);
    assert!(window.says(&format!("“{}”", t.lesson_minutes_field)) && window.says(t.not_written));
    window.key(Key::PageDown);
    let playing = window.state().learn.lesson.as_ref().unwrap();
    assert_eq!((playing.step, playing.writing.as_ref().unwrap().typed.words[5].en.as_str()), (1, "long"));
    assert_eq!(read_lesson(&path).unwrap().1, text);
    type_into(&mut window, t.lesson_minutes_field, "12");
    pause(&mut window);
    assert_eq!(read_lesson(&path).unwrap().0.minutes, Some(12.0));
    // The way back, change by change.
    for _ in 0..3 {
        window.click(en::WINDOW.undo);
    }
    assert_eq!(read_lesson(&path).unwrap().1, shipped.text, "to the letter");
    assert_eq!(
        window.state().learn.lesson.as_ref().unwrap().writing.as_ref().unwrap().typed.words[3],
        shipped.lesson.title
    );
}

#[test]
fn the_fields_of_a_lesson_are_named_in_portuguese_and_write_portuguese() {
    let folder = Folder::new("write-pt");
    let path = folder.file("minha.toml");
    std::fs::write(&path, "id = \"x\"\ntitle = \"A new lesson\"\n\n[[step]]\ntitle = \"Um\"\ntext = \"Um\"\n").unwrap();
    let mut window = playing(&path, 0);
    window.app_mut().state.model.settings.lang = Lang::PtBr;
    window.run();
    write(&mut window);
    window.click("A lição inteira");
    type_into(&mut window, "Título da lição", "Uma câmera");
    type_into(&mut window, "Frase para guardar (Markdown, $fórmulas$)", "Guarde isto.");
    type_into(&mut window, "Minutos", "7,5");
    pause(&mut window);
    let (lesson, _) = read_lesson(&path).unwrap();
    assert_eq!((lesson.title.pt_br.as_str(), lesson.title.en.as_str()), ("Uma câmera", "A new lesson"));
    // Written in one language, it stands for both.
    assert_eq!(lesson.sentence.unwrap().en, "Guarde isto.");
    assert_eq!(lesson.minutes, Some(7.5));
}

#[test]
fn a_wrong_text_gets_a_message_and_is_not_lost() {
    let folder = Folder::new("write-wrong");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    write(&mut window);
    type_into(&mut window, t.step_text_field, "See {basis.nonsense}");
    assert!(window.says("basis.nonsense") && window.says(t.not_written));
    // Neither another step nor the end of the lesson takes it away.
    for key in [Key::PageDown, Key::PageUp] {
        window.key(key);
        assert_eq!(window.state().learn.lesson.as_ref().unwrap().step, 1);
    }
    window.harness.key_press_modifiers(Modifiers::ALT, Key::W);
    window.run();
    assert!(window.says(t.unsaved_text_title) && window.says("basis.nonsense"), "the question says why");
    assert!(window.harness.query_by_label(t.save_copy).is_none(), "no file could hold it");
    window.key(Key::Escape);
    assert_eq!(step_text(&window), "See {basis.nonsense}");
    assert_eq!(read_lesson(&path).unwrap().1, shipped()[1].text);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::W);
    window.run();
    window.click(camera_lab_words::window::texts(Lang::En).dont_save);
    assert!(window.state().learn.lesson.is_none());
    assert_eq!(read_lesson(&path).unwrap().1, shipped()[1].text);
}

#[test]
fn steps_change_their_places_and_keep_their_pictures() {
    let folder = Folder::new("write-order");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    let before = of(&shipped()[1].lesson);
    write(&mut window);
    window.click(t.step_later);
    let mut expected = before.clone();
    expected.swap(1, 2);
    assert_eq!((titles(&path), window.state().learn.lesson.as_ref().unwrap().step), (expected, 2));
    assert_eq!(
        window.state().model.desk.shown.figure().camera,
        shipped()[1].lesson.steps[1].figure.camera,
        "the step is followed"
    );
    window.click(t.step_earlier);
    assert_eq!(titles(&path), before);
    window.click(t.step_remove);
    assert_eq!(titles(&path).len(), before.len() - 1);
    window.click(en::WINDOW.undo);
    assert_eq!(titles(&path), before);
    // A step with the figure on the screen.
    let mut camera = *window.state().model.desk.shown.camera().parameters();
    camera.near *= 1.5;
    window.app_mut().state.model.desk.shown.set_parameters(camera);
    window.run();
    // The title that you type first must not go to the question of the step before.
    let has_title =
        |window: &Window| window.harness.query_by_role_and_label(Role::TextInput, t.step_title_field).is_some();
    window.click(tasks::texts(Lang::En).task);
    assert!(!has_title(&window));
    window.click(t.step_another);
    assert!(has_title(&window));
    let (lesson, _) = read_lesson(&path).unwrap();
    assert_eq!(lesson.steps.len(), before.len() + 1);
    let step = window.state().learn.lesson.as_ref().unwrap().step;
    assert_eq!(lesson.steps[step].figure.camera, camera);
    camera.near *= 1.1;
    window.app_mut().state.model.desk.shown.set_parameters(camera);
    window.run();
    window.click(t.step_screen);
    assert_eq!(read_lesson(&path).unwrap().0.steps[step].figure.camera, camera);
}

#[test]
fn changes_by_another_program_are_not_overwritten() {
    let folder = Folder::new("write-both");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    write(&mut window);
    let theirs = shipped()[1].text.replace("[[step]]", "# Theirs.\n[[step]]");
    std::fs::write(&path, &theirs).unwrap();
    window.click(t.step_later);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), theirs);
    window.click(t.read_again);
    window.click(t.step_later);
    assert_ne!(titles(&path), of(&shipped()[1].lesson));
    assert!(std::fs::read_to_string(&path).unwrap().contains("# Theirs."));
}

#[test]
fn text_whose_file_another_program_has_changed_goes_into_a_copy() {
    let folder = Folder::new("write-beside");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    write(&mut window);
    let theirs = shipped()[1].text.replace("[[step]]", "# Theirs.\n[[step]]");
    std::fs::write(&path, &theirs).unwrap();
    type_into(&mut window, t.step_text_field, "My words.");
    window.command_key(Key::Q);
    assert!(window.says(t.unsaved_text_title) && !window.state().file_flow.may_close);
    window.click(t.save_copy);
    let copy = folder.file("copy.toml");
    window.choose(&copy);
    assert!(window.state().file_flow.may_close, "the window may close after the answer");
    assert_eq!(read_lesson(&copy).unwrap().0.steps[1].text.en, "My words.");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), theirs);
}

#[test]
fn a_step_added_to_the_edited_lesson_is_no_change_by_another_program() {
    let folder = Folder::new("write-add");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    let before = of(&shipped()[1].lesson).len();
    write(&mut window);
    type_into(&mut window, t.step_text_field, "Before.");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::A);
    window.run();
    assert_eq!(titles(&path).len(), before + 1);
    assert!(window.says(&words::place(Lang::En, 2, before + 1)), "the bar counts it");
    type_into(&mut window, t.step_text_field, "After.");
    pause(&mut window);
    let (lesson, _) = read_lesson(&path).unwrap();
    assert_eq!((lesson.steps[1].text.en.as_str(), lesson.steps.len()), ("After.", before + 1));
}

#[test]
fn a_lesson_of_the_program_is_written_in_a_copy() {
    let folder = Folder::new("write-copy");
    let lesson = shipped()[2].lesson.clone();
    let figure = (*lesson.steps[3].figure).clone();
    let open = Some(OpenLesson { lesson, path: None, step: 3 });
    let mut state = State::new(Start { figure, lang: Lang::En, lesson: open, ..Start::default() }).unwrap();
    state.file_flow.native = false;
    let mut window = Window::with_state(state, [1280.0, 720.0]);
    window.run();
    write(&mut window);
    let path = folder.file("copy.toml");
    window.choose(&path);
    window.run();
    let playing = window.state().learn.lesson.as_ref().unwrap();
    assert_eq!((playing.path.as_deref(), playing.step), (Some(path.as_path()), 3));
    assert!(playing.writing.is_some());
    assert_eq!(std::fs::read_to_string(&path).unwrap(), shipped()[2].text);
}

#[test]
fn a_link_holds_a_whole_lesson() {
    let text = "id = \"x\"\ntitle = \"In a link\"\n[[step]]\ntitle = \"One\"\ntext = \"First\"\n[[step]]\ntitle = \"Two\"\ntext = \"Second\"\n";
    let link = share::link("https://example.org/lab/", Held::Lesson, text).unwrap();
    let mut window = Window::new(Lang::En);
    window.run();
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run();
    window.choose(Path::new(&link));
    window.run();
    let playing = window.state().learn.lesson.as_ref().unwrap();
    assert_eq!(of(&playing.lesson), ["One", "Two"]);
    // There is no file to be written.
    assert!(!window.state().learn.plays_own_lesson(&window.state().model));
    window.key(Key::PageDown);
    assert_eq!(window.state().learn.lesson.as_ref().unwrap().step, 1);
}

#[test]
fn text_of_a_window_that_was_killed_is_in_its_fields_again() {
    let folder = Folder::new("write-killed");
    let t = words::texts(Lang::En);
    let (mut window, path) = own(&folder, 1);
    window.app_mut().keep_session(&folder.file("sessions"), false);
    write(&mut window);
    type_into(&mut window, t.step_text_field, "See {basis.nonsense}");
    window.wait(|_| written(&folder.file("sessions")).contains("basis.nonsense"));
    drop(window);
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    window.run();
    window.run();
    assert_eq!(step_text(&window), "See {basis.nonsense}");
    assert!(window.says(t.not_written) && window.state().learn.lesson.as_ref().unwrap().step == 1);
    assert_eq!(read_lesson(&path).unwrap().1, shipped()[1].text);
    type_into(&mut window, t.step_text_field, "See $n$.");
    pause(&mut window);
    assert_eq!(read_lesson(&path).unwrap().0.steps[1].text.en, "See $n$.");
    window.wait(|_| written(&folder.file("sessions")).is_empty());
}

/// The text of the step, as it is typed.
fn step_text(window: &Window) -> String {
    window.state().learn.lesson.as_ref().unwrap().writing.as_ref().unwrap().typed.words[1].en.clone()
}

/// A lesson of one step that asks nothing.
fn bare(folder: &Folder) -> (Window, PathBuf) {
    let path = folder.file("bare.toml");
    std::fs::write(&path, "id = \"bare\"\ntitle = \"Bare\"\n\n[[step]]\ntitle = \"One\"\ntext = \"Look.\"\n").unwrap();
    let mut window = playing(&path, 0);
    write(&mut window);
    window.click(tasks::texts(Lang::En).task);
    (window, path)
}

fn task_in(path: &Path) -> Option<Task> {
    read_lesson(path).unwrap().0.steps[0].task.clone()
}

/// Whether this answer to the question in the file is right, and the message about it.
fn judged(path: &Path, answer: &str) -> (bool, Vec<String>) {
    let Some(Task::Question(entry)) = task_in(path) else { panic!("no question") };
    let exercise = entry.exercise(0, &Default::default());
    let ask = &exercise.asks[0];
    let judged = judge_answer(ask, read_answer(answer, ask, &[]).unwrap());
    (judged.right, judged.diagnosis.iter().map(|found| format!("{found:?}")).collect())
}

#[test]
fn a_question_with_choices_is_made_in_the_window() {
    let folder = Folder::new("choices");
    let (mut window, path) = bare(&folder);
    let t = tasks::texts(Lang::En);
    window.click(t.choices);
    type_into(&mut window, t.question_field, "What is larger?");
    window.click(t.add_choice);
    for (place, choice) in ["only F", "only B", "only D"].into_iter().enumerate() {
        type_into(&mut window, &format!("{} {}", t.choice_field, place + 1), choice);
    }
    window.click(&format!("{} B", t.right_field));
    type_into(&mut window, &format!("{} 3", t.message_field), "D is no plane.");
    // The preview asks as the class will be asked.
    assert!(window.says("What is larger?"));
    pause(&mut window);
    assert!(judged(&path, "b").0 && !judged(&path, "a").0);
    let (is_right, why) = judged(&path, "c");
    assert!(!is_right && why.concat().contains("D is no plane."), "{why:?}");
    // Another choice, taken away again, and then the whole question.
    window.click(t.add_choice);
    type_into(&mut window, &format!("{} 4", t.choice_field), "H");
    pause(&mut window);
    assert!(!judged(&path, "d").0);
    window.click(en::WINDOW.undo);
    assert!(read_answer("d", &asked(&path), &[]).is_err());
    window.click(t.none);
    pause(&mut window);
    assert!(task_in(&path).is_none());
}

/// Without a lesson, writing begins with the figure on the screen.
#[test]
fn writing_begins_a_lesson_with_the_figure_on_the_screen() {
    let folder = Folder::new("begin-writing");
    let path = folder.file("first.toml");
    let mut window = Window::new(Lang::En);
    window.menu(en::WINDOW.menu_present, words::texts(Lang::En).write_command);
    window.choose(&path);
    assert!(window.state().learn.writes_lesson(&window.state().model) && window.state().file_flow.dialog.is_none());
    assert_eq!(read_lesson(&path).unwrap().0.steps.len(), 1);
}

/// Typing, Tab, and one click for all of it: an empty question has the keyboard.
#[test]
fn a_new_question_is_typed_from_field_to_field() {
    let folder = Folder::new("new-question");
    let (mut window, path) = bare(&folder);
    let t = tasks::texts(Lang::En);
    window.click(t.none);
    window.click(t.new_question);
    for text in ["Which is nearer?", "the front plane", "the back plane", "B lies behind F."] {
        window.harness.event(Event::Text(text.to_owned()));
        window.run();
        window.key(Key::Tab);
    }
    pause(&mut window);
    assert!(judged(&path, "a").0, "the first one is right");
    let (is_right, why) = judged(&path, "b");
    assert!(!is_right && why.concat().contains("B lies behind F."), "{why:?}");
    assert!(window.harness.get_by_label(t.new_question).accesskit_node().is_disabled());
}

fn asked(path: &Path) -> Ask {
    let Some(Task::Question(entry)) = task_in(path) else { panic!("no question") };
    entry.exercise(0, &Default::default()).asks[0].clone()
}

#[test]
fn numbers_goals_and_exercises_are_tasks_too() {
    let folder = Folder::new("tasks");
    let (mut window, path) = bare(&folder);
    let t = tasks::texts(Lang::En);
    window.click(t.number);
    type_into(&mut window, t.question_field, "How much?");
    type_into(&mut window, &format!("{} 1", t.answer_field), "2,5");
    type_into(&mut window, &format!("{} 1", t.tolerance_field), "0.1");
    window.click(t.add_wrong);
    type_into(&mut window, &format!("{} 1", t.wrong_field), "5");
    type_into(&mut window, &format!("{} 1", t.wrong_message), "That's twice as much.");
    pause(&mut window);
    assert!(judged(&path, "2.58").0 && !judged(&path, "2.65").0);
    assert!(judged(&path, "5").1.concat().contains("twice"));
    // A quantity is chosen from the menu.
    window.click(&format!("{} ▾", t.quantity));
    window.click(t.axes_group);
    window.click_in_dialog("n");
    window.click("basis.n.1");
    pause(&mut window);
    let n = camera_lab::lessons::numbers_of(&read_lesson(&path).unwrap().0.steps[0].figure).unwrap().basis.n[1];
    assert!(judged(&path, &n.to_string()).0);

    window.click(t.goal);
    type_into(&mut window, t.goal_field, "Turn the camera.");
    type_into(&mut window, &format!("{} 1", t.of_quantity), "camera.view_angle");
    type_into(&mut window, &format!("{} 1", t.at_least), "60");
    pause(&mut window);
    let Some(Task::Try(goal)) = task_in(&path) else { panic!("no goal") };
    assert_eq!((goal.text.en.as_str(), goal.until.len()), ("Turn the camera.", 1));
    // A mistake is named, and the file keeps the last good goal.
    type_into(&mut window, &format!("{} 1", t.of_quantity), "camera.angle");
    pause(&mut window);
    assert!(window.says(words::texts(Lang::En).not_written));
    assert!(matches!(task_in(&path), Some(Task::Try(kept)) if kept == goal));

    window.click(t.exercise);
    pause(&mut window);
    assert!(matches!(task_in(&path), Some(Task::Exercise { seed: 0, .. })));
}

#[test]
fn a_task_of_a_window_that_was_killed_is_in_its_fields_again() {
    let folder = Folder::new("killed-task");
    let (mut window, path) = bare(&folder);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    let t = tasks::texts(Lang::En);
    window.click(t.goal);
    // Without a condition it can't be in the file.
    type_into(&mut window, t.goal_field, "Only half of a goal");
    pause(&mut window);
    assert!(task_in(&path).is_none());
    window.crash(&folder.file("sessions"), "Only half of a goal");
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    window.run();
    let writing = window.state().learn.lesson.as_ref().unwrap().writing.as_ref().unwrap();
    assert_eq!(writing.typed.task.text.en, "Only half of a goal");
    assert!(writing.fault.is_some());
}

/// A new step has no text, and its title stands in its author's language. Whatever is missing in a language, the other
/// one has.
#[test]
fn a_step_in_one_language_shows_it_in_the_other_until_it_has_its_own() {
    let folder = Folder::new("write-in-one-language");
    let t = words::texts(Lang::PtBr);
    let path = folder.file("mine.toml");
    let figure = camera_lab_desk::document::fresh();
    let (text, lesson) = with_step("", "mine", &words::draft(Lang::PtBr, 1), &figure).unwrap();
    let step = &lesson.steps[0];
    assert_eq!((step.text.clone(), step.title.en.as_str()), (Localized::default(), "Passo 1"));
    std::fs::write(&path, text).unwrap();
    let mut window = playing_in(&path, 0, Lang::PtBr);
    write(&mut window);
    type_into(&mut window, t.step_title_field, "Olhar");
    type_into(&mut window, t.step_text_field, "Uma pirâmide.");
    pause(&mut window);
    let step = || read_lesson(&path).unwrap().0.steps[0].clone();
    assert_eq!((step().title.en.as_str(), step().text.en.as_str()), ("Olhar", "Uma pirâmide."));
    // The field of the other language is empty, not a copy that stays behind.
    window.click_in_dialog("English");
    type_into(&mut window, t.step_text_field, "A pyramid.");
    pause(&mut window);
    assert_eq!(step().text, Localized::from(["A pyramid.".to_owned(), "Uma pirâmide.".to_owned()]));
    assert_eq!(step().title.en, "Olhar");
    type_into(&mut window, t.step_text_field, "");
    window.harness.key_press(Key::Backspace);
    window.run();
    pause(&mut window);
    assert_eq!(step().text.en, "Uma pirâmide.");
}
