//! Nothing is lost without a question: every command, key, link, card, dropped file and way to close the window is
//! tried with unsaved work of each kind. The work must still be in the window afterwards, and in a window that starts
//! after a crash.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use camera_lab::camera::Parameters;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::gui::kit::keys::Command;
use camera_lab::gui::learn::exercises::state::Chosen;
use camera_lab::gui::{Start, State};
use camera_lab::lessons::{OpenLesson, shipped};
use camera_lab::views::View;
use camera_lab_desk::UnsavedText;
use camera_lab_desk::document::Document;
use camera_lab_desk::storage::session::Sessions;
use camera_lab_files::{open_figure, read_lesson};
use camera_lab_words::learn::{exercise_window, lessons as words};
use camera_lab_words::{Lang, told, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, KeyboardShortcut, Modifiers, ViewportEvent, ViewportId};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use super::files::{Dropped, Folder};
use super::sessions::written;
use super::window::Window;

/// The far plane of unsaved work: no other figure has it.
const FAR: f64 = 61.5;
/// The name of a point of unsaved work.
const POINT: &str = "MyPoint";
/// A part of typed texts.
const TYPED: &str = "my own words";

/// A kind of unsaved work.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Work {
    /// A figure with a file.
    Figure,
    /// A new figure behind that of an exercise.
    BehindExercise,
    /// A figure that was left for the next one of a presentation.
    Left,
    /// Something built in a step of a lesson.
    Step,
    /// Text of a lesson that its file cannot hold.
    WrongText,
    /// Text of a lesson whose file another program has changed.
    TextBeside,
    /// A path in a dialog, and a figure.
    Path,
}

/// Something that a user does.
#[derive(Clone, Debug)]
enum Deed {
    Keys(KeyboardShortcut),
    Write(&'static str),
    /// Clicks the widget of this role with the number that it has among those of its role.
    Click(Role, usize),
    Label(&'static str),
    Drop(PathBuf),
    Give(PathBuf),
    Close,
    Change(fn(&mut State)),
}

const LESSON: &str = r#"id = "mine"
title = "Mine"

[[step]]
title = "One"
text = "First"
links = [{ lesson = "basis" }, { exercise = "basis" }, { note = "C" }]

[step.scene]
preset = "empty"

[step.style]
antialias = 1

[[step]]
title = "Two"
text = "Second"
"#;

fn files(folder: &Folder) {
    for name in ["a.toml", "b.toml", "c.toml"] {
        fs::write(folder.file(name), "[camera]\nfar = 50.0\n\n[scene]\npreset = \"empty\"\n").unwrap();
    }
    fs::write(folder.file("lesson.toml"), LESSON).unwrap();
    fs::write(folder.file("other.toml"), LESSON.replace("Mine", "Other")).unwrap();
    fs::write(folder.file("m.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
}

/// The state of a window before the work, in a folder as it is at first.
fn first(work: Work, folder: &Folder) -> State {
    let _ = fs::remove_dir_all(folder.file("sessions"));
    files(folder);
    let (start, path) = match work {
        Work::Step | Work::WrongText | Work::TextBeside => {
            let path = folder.file("lesson.toml");
            let lesson = read_lesson(&path).unwrap().0;
            let figure = (*lesson.steps[0].figure).clone();
            let lesson = Some(OpenLesson { lesson: lesson.into(), path: Some(path.clone()), step: 0 });
            (Start { figure, lesson, ..Start::default() }, path)
        }
        // A new figure has no file.
        Work::BehindExercise => {
            let figure = open_figure(&folder.file("a.toml")).unwrap().figure;
            (Start { figure, ..Start::default() }, folder.file("other.toml"))
        }
        Work::Figure | Work::Left | Work::Path => {
            let path = folder.file("a.toml");
            let (figure, file) = open_figure(&path).unwrap().at(&path);
            (Start { figure, file: Some(file), ..Start::default() }, folder.file("other.toml"))
        }
    };
    let mut state = State::new(Start { lang: Lang::En, ..start }).unwrap();
    state.file_flow.native = false;
    state.model.layout.maximized = Some(View::Image);
    state.model.settings.panels.wanted = [false; 3];
    state.model.settings.reduce_motion = true;
    state.learn.welcome = true;
    state.learn.file = Some(path);
    state
}

/// Has unsaved work in the window, and in its session.
fn begin(work: Work, window: &mut Window, folder: &Folder) {
    window.begin_again(first(work, folder));
    window.app_mut().keep_session(&folder.file("sessions"), false);
    let path = folder.file("lesson.toml");
    if window.state().learn.lesson.is_none() {
        let far = Parameters { far: FAR, ..*window.state().model.desk.shown.draft() };
        window.app_mut().state.model.desk.shown.set_parameters(far);
        window.run();
    }
    let t = words::texts(Lang::En);
    match work {
        Work::Figure => {}
        Work::BehindExercise => {
            window.app_mut().state.learn.exercises.work_on(Chosen { id: "basis".to_owned(), seed: 1 });
            press(window, Modifiers::ALT, Key::X);
            window.click(exercise_window::texts(Lang::En).show_figure);
        }
        Work::Left => press(window, Modifiers::COMMAND, Key::PageDown),
        Work::Step => {
            window.app_mut().state.model.desk.shown.edit(|figure| {
                let position = glam::DVec3::ONE;
                figure.points.push(camera_lab::figure::NamedPoint { name: POINT.to_owned(), position });
            });
            window.run();
        }
        Work::WrongText | Work::TextBeside => {
            press(window, Modifiers::ALT, Key::R);
            window.run();
            if work == Work::TextBeside {
                fs::write(&path, LESSON.replace("[[step]]", "# Theirs.\n[[step]]")).unwrap();
            }
            let wrong = if work == Work::WrongText { " $\\input{x}$" } else { "" };
            window.harness.get_by_role_and_label(Role::MultilineTextInput, t.step_text_field).focus();
            window.run();
            window.harness.event(Event::Text(format!("{TYPED}{wrong}")));
            window.run();
        }
        Work::Path => {
            press(window, Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
            window.harness.get_by_role_and_label(Role::TextInput, "file").focus();
            window.run();
            window.harness.event(Event::Text(TYPED.to_owned()));
            window.run();
        }
    }
    assert!(work.is_held(window.state()) && stored_soon(work, window, folder), "{work:?}");
}

fn press(window: &mut Window, modifiers: Modifiers, key: Key) {
    window.harness.key_press_modifiers(modifiers, key);
    window.run();
}

impl Work {
    fn is_in(self, document: &Document) -> bool {
        match self {
            Self::Step => document.figure().points.iter().any(|point| point.name == POINT),
            _ => document.draft().far == FAR,
        }
    }

    fn is_in_text(self, text: Option<&UnsavedText>) -> bool {
        text.is_some_and(|text| text.words[1].en.contains(TYPED))
    }

    fn is_text(self) -> bool {
        matches!(self, Self::WrongText | Self::TextBeside)
    }

    /// The window still has it, shown or not.
    fn is_held(self, state: &State) -> bool {
        if self.is_text() {
            return self.is_in_text(state.learn.unsaved_text().map(|text| &**text));
        }
        let (mut back, mut forth) = (state.model.desk.clone(), state.model.desk.clone());
        let mut is_near = false;
        for _ in 0..20 {
            is_near |= self.is_in(&back.shown) || self.is_in(&forth.shown);
            back.undo(true);
            forth.undo(false);
        }
        is_near || state.model.desk.held().into_iter().any(|document| self.is_in(document))
    }

    /// The user has it in a file.
    fn is_saved(self, folder: &Folder) -> bool {
        let names = ["a.toml", "lesson.toml"];
        let texts = names.map(|name| fs::read_to_string(folder.file(name)).unwrap_or_default());
        let mark = match self {
            Self::Step => POINT.to_owned(),
            Self::WrongText | Self::TextBeside => TYPED.to_owned(),
            _ => format!("far = {FAR}"),
        };
        texts.iter().any(|text| text.contains(&mark))
    }

    /// The session of the window has it.
    fn is_stored(self, folder: &Folder) -> bool {
        let text = written(&folder.file("sessions"));
        match self {
            Self::Step => text.contains(POINT),
            Self::WrongText | Self::TextBeside => text.contains(TYPED),
            _ => text.contains(&format!("far = {FAR}")),
        }
    }

    /// A window that starts after a crash has it, or offers it.
    fn comes_back(self, folder: &Folder) -> bool {
        let (mut sessions, first) = Sessions::begin(&folder.file("sessions"), true);
        let slots: Vec<usize> = sessions.left().iter().map(|left| left.slot).collect();
        let others: Vec<_> = slots.into_iter().filter_map(|slot| sessions.restore(slot)).collect();
        first.into_iter().chain(others).any(|restored| {
            if self.is_text() { self.is_in_text(restored.text.as_ref()) } else { self.is_in(&restored.document) }
        })
    }

    /// The window is as [`begin`] has left it, as far as the work goes.
    fn is_as_at_first(self, state: &State) -> bool {
        let is_open = match &state.file_flow.dialog {
            Some(Dialog::Path(..)) => self == Self::Path,
            Some(_) => false,
            None => self != Self::Path,
        };
        let plays = matches!(self, Self::Step | Self::WrongText | Self::TextBeside);
        let is_shown = match self {
            Self::BehindExercise | Self::Left => state.model.desk.held().iter().any(|document| self.is_in(document)),
            Self::WrongText | Self::TextBeside => true,
            Self::Figure | Self::Step | Self::Path => self.is_in(&state.model.desk.shown),
        };
        let is_at_rest =
            !state.model.settings.presentation && state.model.settings.lang == Lang::En && state.learn.welcome;
        is_open && is_shown && is_at_rest && plays == state.learn.lesson.is_some()
    }
}

impl Deed {
    fn is_enter(&self) -> bool {
        matches!(self, Self::Keys(keys) if keys.logical_key == Key::Enter)
    }
}

fn does(window: &mut Window, deed: &Deed) {
    match deed {
        Deed::Keys(keys) => window.harness.key_press_modifiers(keys.modifiers, keys.logical_key),
        Deed::Write(text) => window.harness.event(Event::Text((*text).to_owned())),
        Deed::Click(role, number) => {
            let found = window.harness.query_all_by_role(*role).nth(*number);
            found.into_iter().for_each(|node| node.click());
        }
        Deed::Label(label) => {
            let found = window.harness.query_all_by_label_contains(label).last();
            found.into_iter().for_each(|node| node.click());
        }
        Deed::Drop(path) => {
            window.harness.input_mut().dropped_files.push(Arc::new(Dropped(path.clone())));
        }
        Deed::Give(path) => window.app_mut().state.file_flow.give(path.clone()),
        Deed::Close => {
            let viewport = window.harness.input_mut().viewports.entry(ViewportId::ROOT).or_default();
            viewport.events.push(ViewportEvent::Close);
            window.harness.step();
            let viewport = window.harness.input_mut().viewports.entry(ViewportId::ROOT).or_default();
            viewport.events.clear();
        }
        Deed::Change(change) => change(&mut window.app_mut().state),
    }
    window.run();
}

const fn keys(modifiers: Modifiers, key: Key) -> Deed {
    Deed::Keys(KeyboardShortcut::new(modifiers, key))
}

const ENTER: Deed = keys(Modifiers::NONE, Key::Enter);
const CTRL: Modifiers = Modifiers::COMMAND;

/// All that can be done in a window, each in a row of deeds with a name.
fn all(folder: &Folder) -> Vec<(String, Vec<Deed>)> {
    let mut rows: Vec<(String, Vec<Deed>)> = Vec::new();
    let mut row = |name: &str, deeds: Vec<Deed>| rows.push((name.to_owned(), deeds));
    for command in Command::all() {
        row(&format!("{command:?}"), vec![Deed::Keys(command.shortcut())]);
    }
    let presents = keys(Modifiers::NONE, Key::F11);
    for key in [Key::PageDown, Key::PageUp, Key::ArrowRight, Key::ArrowLeft, Key::Q, Key::C, Key::N, Key::Escape] {
        row(&format!("{key:?}"), vec![keys(Modifiers::NONE, key)]);
        row(&format!("{key:?} in a presentation"), vec![presents.clone(), keys(Modifiers::NONE, key)]);
    }
    row("the number of a step", vec![presents, keys(Modifiers::NONE, Key::Num2), ENTER]);
    for name in ["b.toml", "other.toml", "m.obj", "none.toml"] {
        row(&format!("{name} is dropped"), vec![Deed::Drop(folder.file(name))]);
        row(&format!("{name} is given to a page"), vec![Deed::Give(folder.file(name))]);
    }
    row("the window's own button", vec![Deed::Close]);
    row("the window's own button twice", vec![Deed::Close, Deed::Close]);
    let search = keys(CTRL.plus(Modifiers::SHIFT), Key::P);
    for words in ["house", "lesson basis", "exercise basis", "new figure"] {
        row(&format!("search for {words}"), vec![search.clone(), Deed::Write(words), ENTER]);
    }
    let lessons = keys(CTRL.plus(Modifiers::SHIFT), Key::L);
    let first = words::with_minutes(Lang::En, &shipped()[1].lesson);
    row("a lesson of the list", vec![lessons.clone(), Deed::Label(first.leak())]);
    row("an own lesson of the list", vec![lessons, Deed::Label("Other")]);
    row("a card", vec![keys(CTRL, Key::G), ENTER]);
    let [house, _] = camera_lab_files::SHIPPED_FIGURES[1].told();
    let house = told(Lang::En, &house).to_owned();
    row("another card", vec![keys(CTRL, Key::G), Deed::Label(house.leak())]);
    row("to another step and back", vec![keys(Modifiers::NONE, Key::PageDown), keys(Modifiers::NONE, Key::PageUp)]);
    row(
        "the figure of an exercise",
        vec![
            Deed::Change(|state| state.learn.exercises.work_on(Chosen { id: "window".to_owned(), seed: 1 })),
            keys(Modifiers::ALT, Key::X),
            Deed::Label(exercise_window::texts(Lang::En).show_figure),
        ],
    );
    row("the way back", vec![keys(CTRL, Key::Z), keys(CTRL, Key::Z), keys(CTRL, Key::S)]);
    rows
}

/// Commands that take changes back because the user asks for just that. They can be undone or redone.
fn is_asked_for(name: &str) -> bool {
    let t = words::texts(Lang::En);
    let buttons = [window::texts(Lang::En).undo, t.again].map(|label| format!("Button {label}"));
    let commands = [Command::Undo, Command::Reset, Command::StepAgain].map(|command| format!("{command:?}"));
    commands.iter().chain(&buttons).any(|asked| asked == name) || name == "the way back"
}

/// Each clickable thing in the window, but the many of the panels at the sides.
fn clickable(window: &Window) -> Vec<(String, Vec<Deed>)> {
    let mut rows = Vec::new();
    let picture = window.harness.get_by_label_contains("Image: what the camera sees").rect();
    for role in [Role::Link, Role::Button] {
        for (number, node) in window.harness.query_all_by_role(role).enumerate() {
            let place = node.rect().center();
            let beside = place.y > picture.top() && place.y < picture.bottom();
            let name = node.accesskit_node().label().unwrap_or_default();
            // This one says that it forgets the text.
            let is_asked = name == words::texts(Lang::En).forget_typed;
            if (role == Role::Link || !beside) && !is_asked {
                rows.push((format!("{role:?} {name}"), vec![Deed::Click(role, number)]));
            }
        }
    }
    rows
}

/// Tries everything with a kind of work.
fn nothing_loses(work: Work) {
    let folder = Folder::new(&format!("lost-{work:?}"));
    let mut window = Window::with_state(first(work, &folder), [1280.0, 800.0]);
    begin(work, &mut window, &folder);
    let mut rows = all(&folder);
    match work {
        // Enter is the answer.
        Work::Path => rows.retain(|(_, deeds)| !deeds.iter().any(Deed::is_enter)),
        Work::Figure | Work::WrongText => rows.extend(clickable(&window)),
        // They have the same buttons as these.
        Work::BehindExercise | Work::Left | Work::Step | Work::TextBeside => {}
    }
    let mut lost = Vec::new();
    for (name, deeds) in rows {
        if !work.is_as_at_first(window.state()) {
            begin(work, &mut window, &folder);
        }
        for deed in &deeds {
            does(&mut window, deed);
        }
        let mut faults = look(work, &window, &folder);
        // In a field these keys are its own, and so is the history that gives the text back.
        if work.is_text() && ["Undo", "ClearAnnotations"].contains(&&*name) && is_given_back(work, &mut window) {
            faults.clear();
        }
        if work == Work::Path {
            faults.extend(look_at_path(&mut window, &name));
        } else {
            // The question, or whatever is open, is left.
            press(&mut window, Modifiers::NONE, Key::Escape);
            faults.extend(look(work, &window, &folder));
        }
        if is_asked_for(&name) || work.is_saved(&folder) {
            begin(work, &mut window, &folder);
        } else if !stored_soon(work, &mut window, &folder) {
            faults.push("not in the session");
        }
        if !faults.is_empty() {
            lost.push((name, faults));
            begin(work, &mut window, &folder);
        }
    }
    assert!(lost.is_empty(), "{work:?}: {lost:#?}");
    drop(window);
    // The thread that stores the session lets go of its file a moment later.
    let comes_back = (0..100).any(|_| {
        let is_back = work.comes_back(&folder);
        if !is_back {
            std::thread::sleep(Duration::from_millis(50));
        }
        is_back
    });
    assert!(comes_back, "{work:?}");
}

fn stored_soon(work: Work, window: &mut Window, folder: &Folder) -> bool {
    (0..60).any(|_| {
        window.run();
        let is_stored = work.is_stored(folder);
        if !is_stored {
            // It is written in the background.
            std::thread::sleep(Duration::from_millis(10));
        }
        is_stored
    })
}

fn look(work: Work, window: &Window, folder: &Folder) -> Vec<&'static str> {
    let mut faults = Vec::new();
    if !work.is_held(window.state()) && !work.is_saved(folder) {
        faults.push("not in the window");
    }
    if window.state().file_flow.may_close {
        faults.push("the window closes");
    }
    faults
}

fn is_given_back(work: Work, window: &mut Window) -> bool {
    [Key::Y, Key::Z].into_iter().any(|key| {
        press(window, Modifiers::COMMAND, key);
        work.is_held(window.state())
    })
}

/// The dialog with the path is still open, or comes back after the question that has covered it.
fn look_at_path(window: &mut Window, name: &str) -> Option<&'static str> {
    let has_path = |window: &Window| matches!(&window.state().file_flow.dialog, Some(Dialog::Path(_, path)) if path.contains(TYPED));
    if !has_path(window) {
        press(window, Modifiers::NONE, Key::Escape);
    }
    // These keys are the field's own: they close the dialog, or delete in the field.
    let is_left = ["Escape", "Escape in a presentation", "Undo", "the way back", "ClearAnnotations"].contains(&name);
    (!has_path(window) && !is_left).then_some("the typed path is gone")
}

#[test]
fn an_unsaved_figure_is_never_lost_without_a_question() {
    nothing_loses(Work::Figure);
}

#[test]
fn a_figure_behind_that_of_an_exercise_is_never_lost_without_a_question() {
    nothing_loses(Work::BehindExercise);
}

#[test]
fn a_figure_that_was_left_is_never_lost_without_a_question() {
    nothing_loses(Work::Left);
}

#[test]
fn work_in_a_step_is_never_lost_without_a_question() {
    nothing_loses(Work::Step);
}

#[test]
fn text_that_a_lesson_cannot_hold_is_never_lost_without_a_question() {
    nothing_loses(Work::WrongText);
}

#[test]
fn text_beside_another_program_is_never_lost_without_a_question() {
    nothing_loses(Work::TextBeside);
}

#[test]
fn an_open_dialog_is_never_replaced() {
    nothing_loses(Work::Path);
}
