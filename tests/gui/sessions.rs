//! Windows that did not close: their figures are back, or offered in a list until the user has decided.

use std::fs;
use std::path::Path;
use std::time::Duration;

use camera_lab::camera::{Convention, Operation, Parameters};
use camera_lab::figure::{Measure, Measured};
use camera_lab::geometry::Angle;
use camera_lab::gui;
use camera_lab::gui::app::file_flow;
use camera_lab::gui::{LaunchOptions, Start, State};
use camera_lab::views::View;
use camera_lab_desk::action::Intent;
use camera_lab_desk::message::Message;
use camera_lab_files::FileError;
use camera_lab_words::Lang;
use camera_lab_words::window::texts;
use eframe::egui::{Key, Rect, pos2, vec2};
use egui_kittest::kittest::Queryable;

use super::files::Folder;
use super::window::Window;
use crate::words::en;

const MINE: &str = "# Mine.\n[camera]\nfar = 50.0\n\n[scene]\npreset = \"empty\"\n";

/// The figures of the sessions in this folder.
pub(crate) fn written(folder: &Path) -> String {
    let files = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    files
        .filter(|path| path.extension().is_some_and(|e| e == "json"))
        .filter_map(|p| fs::read_to_string(p).ok())
        .collect()
}

impl Window {
    /// The window ends as in a crash, once the typed values have been stored.
    pub(super) fn crash(mut self, folder: &Path, typed: &str) {
        self.wait(|_| written(folder).contains(typed));
    }
}

/// A window that edits a file, and does not close.
fn leave(folder: &Folder, file: &str, far: &str) {
    let path = folder.file(file);
    if !path.exists() {
        fs::write(&path, MINE).expect("written");
    }
    let mut window = Window::opened(&path);
    window.app_mut().keep_session(&folder.file("sessions"), false);
    window.run();
    window.enter("B", far);
    window.crash(&folder.file("sessions"), &format!("far = {far}"));
}

#[test]
fn a_crashed_session_is_back_at_the_next_start() {
    let folder = Folder::new("session");
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.0, true);
    window.enter("C x", "1.25");
    window.crash(&folder.0, "1.25");
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.0, true);
    window.run();
    assert_eq!(window.state().model.desk.shown.draft().position.x, 1.25);
    assert!(window.says("The last session, which had not been saved"));
    assert!(window.state().model.desk.shown.is_changed());
}

/// A window with a figure file, and the world in it.
fn world(folder: &Folder, restore: bool) -> Window {
    fs::write(folder.file("mine.toml"), MINE).expect("written");
    let mut window = Window::opened(&folder.file("mine.toml"));
    window.app_mut().state.model.layout.maximized = Some(View::World);
    window.app_mut().keep_session(&folder.file("sessions"), restore);
    window.run();
    window
}

#[test]
fn explanations_come_back_although_the_figure_has_not_changed() {
    let folder = Folder::new("explained");
    let mut window = world(&folder, false);
    let near = vec![Measured::Dimension(Measure::Near)];
    window.app_mut().state.model.desk.shown.show_mut().measure = near.clone();
    window.run();
    assert!(!window.state().model.desk.shown.is_changed());
    window.crash(&folder.file("sessions"), "measure");
    let window = world(&folder, true);
    assert!(window.says("The last session, which had not been saved"));
    assert_eq!(window.state().model.shown().measure, near);
    assert!(!window.state().model.desk.shown.is_changed(), "nothing else is");
}

#[test]
fn a_session_keeps_its_view_even_if_the_picture_was_never_turned() {
    let folder = Folder::new("seen");
    let mut window = world(&folder, false);
    // The picture stays the same while the camera turns.
    let operation = Operation::Azimuth(Angle::from_degrees(6.0));
    window.app_mut().state.model.desk.shown.operate(operation, Convention::default()).expect("a camera");
    window.run();
    let seen = window.state().model.frame.seen.world.expect("it is shown");
    assert_eq!(window.state().model.desk.shown.figure().observers.world, None);
    window.crash(&folder.file("sessions"), &seen.distance.to_string());
    let window = world(&folder, true);
    assert_ne!(window.state().model.desk.shown.draft().position, Parameters::default().position);
    assert_eq!(window.state().model.frame.seen.world, Some(seen));
}

#[test]
fn a_session_is_kept_after_a_plus() {
    let folder = Folder::new("plus");
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.0, false);
    window.plus_that_comes_up_as_equals();
    window.enter("C x", "1.25");
    window.crash(&folder.0, "1.25");
}

#[test]
fn a_restored_figure_goes_to_its_own_file_and_not_over_a_newer_one() {
    let folder = Folder::new("newer");
    leave(&folder, "a.toml", "75.0");
    let newer = MINE.replace("50.0", "61.0");
    fs::write(folder.file("a.toml"), &newer).expect("written");
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    window.wait(|window| window.theirs().is_some());
    assert_eq!(window.state().model.desk.shown.figure().camera.far, 75.0);
    assert!(window.says("a.toml was changed by another program, and you have changes in this window too."));
    window.command_key(Key::S);
    assert!(window.says(en::WINDOW.changed_title));
    assert_eq!(fs::read_to_string(folder.file("a.toml")).expect("there"), newer);
    window.click(en::WINDOW.replace);
    let text = fs::read_to_string(folder.file("a.toml")).expect("there");
    assert!(text.contains("# Mine.") && text.contains("far = 75.0"));
    // Saved: nothing is left.
    window.wait(|_| written(&folder.file("sessions")).is_empty());
}

#[test]
fn a_start_with_a_file_lists_left_sessions() {
    for lang in [Lang::En, Lang::PtBr] {
        let folder = Folder::new("listed");
        leave(&folder, "a.toml", "75.0");
        leave(&folder, "b.toml", "76.0");
        let mut window = Window::opened(&folder.file("b.toml"));
        window.app_mut().state.model.settings.lang = lang;
        window.app_mut().keep_session(&folder.file("sessions"), false);
        window.run();
        let [title, restore, discard, unsaved, without] = match lang {
            Lang::En => ["Windows that did not close", "Restore", "Discard", "Save the changes?", "Don't save"],
            _ => ["Janelas que não fecharam", "Restaurar", "Descartar", "Salvar as mudanças?", "Não salvar"],
        };
        let ago = if lang == Lang::En { "just now" } else { "agora mesmo" };
        assert!(window.says(title) && window.says("a.toml") && window.says(ago));
        // It stays, whatever else happens, and the window asks about unsaved changes here.
        window.enter("B", "51");
        assert!(window.says(title));
        let press = |window: &mut Window, label: &str| {
            let buttons = window.harness.query_all_by_label(label);
            buttons.min_by(|a, b| a.rect().top().total_cmp(&b.rect().top())).expect("a button").click();
            window.run();
        };
        press(&mut window, restore);
        assert!(window.says(unsaved));
        window.click(without);
        window.wait(|window| window.state().model.desk.shown.figure().camera.far == 75.0);
        assert_eq!(window.state().model.desk.shown.name().as_deref(), Some("a.toml"));
        assert!(window.state().model.desk.shown.is_changed() && window.says(title));
        press(&mut window, discard);
        assert!(!window.says(title));
        assert!(!written(&folder.file("sessions")).contains("76.0"));
    }
}

#[test]
fn a_figure_that_did_not_survive_is_offered_and_not_restored() {
    let folder = Folder::new("fatal");
    leave(&folder, "a.toml", "75.0");
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    assert_eq!(window.state().model.desk.shown.figure().camera.far, 75.0);
    // The program ends at once.
    drop(window);
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    window.run();
    assert_ne!(window.state().model.desk.shown.figure().camera.far, 75.0);
    assert!(window.says(en::WINDOW.did_not_survive));
    window.click(en::WINDOW.restore);
    window.wait(|window| window.state().model.desk.shown.figure().camera.far == 75.0);
}

#[test]
fn an_unreadable_session_is_named_with_its_path() {
    let folder = Folder::new("not-understood");
    fs::create_dir_all(folder.file("sessions")).expect("made");
    fs::write(folder.file("sessions/session-0.json"), "?").expect("written");
    let mut window = Window::new(Lang::PtBr);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    window.run();
    assert!(window.says("não podem ser lidas") && window.says("session-0.damaged"));
    // A message at the bottom does not take its place: only the user does.
    window.key(Key::F11);
    window.key(Key::F11);
    assert!(window.says("session-0.damaged"));
    window.click("Fechar");
    window.run();
    assert!(!window.says("session-0.damaged"));
}

/// The place of the button of each line, over the frames in which the pointer moves.
fn closing_buttons(window: &mut Window) -> Vec<Rect> {
    for step in 0..10_u8 {
        window.harness.hover_at(pos2(300.0 + f32::from(step), 500.0));
        window.harness.step();
    }
    window.harness.query_all_by_label(en::WINDOW.close).map(|button| button.rect()).collect()
}

#[test]
fn lines_at_the_top_take_a_row_each_however_often_they_are_shown() {
    for (lines, width, name) in
        [(2, 1280.0, "s"), (3, 640.0, "a-long-name-of-a-folder-that-holds-sessions-of-many-windows")]
    {
        let folder = Folder::new("rows");
        let sessions = folder.file(name);
        fs::create_dir_all(&sessions).expect("made");
        for slot in 0..lines {
            fs::write(sessions.join(format!("session-{slot}.json")), "?").expect("written");
        }
        let mut window = Window::new(Lang::En);
        window.harness.set_size(vec2(width, 720.0));
        window.run();
        let picture = |window: &Window| window.state().model.frame.picture_sizes[View::Image.index()][1] as f32;
        let whole = picture(&window);
        window.app_mut().keep_session(&sessions, false);
        window.run();
        let at_first = closing_buttons(&mut window);
        let row = at_first[0].height() + 4.0;
        assert_eq!(at_first.len(), lines);
        assert!(at_first.windows(2).all(|pair| pair[1].top() - pair[0].top() <= row + 2.0), "{at_first:?}");
        assert!(at_first.iter().all(|button| button.right() <= width), "{at_first:?}");
        assert_eq!(closing_buttons(&mut window), at_first);
        assert!(picture(&window) >= whole - (lines as f32) * row - 12.0, "{whole} {}", picture(&window));
        for left in (0..lines).rev() {
            window.harness.query_all_by_label(en::WINDOW.close).next().expect("a line").click();
            window.run();
            assert_eq!(window.harness.query_all_by_label(en::WINDOW.close).count(), left);
        }
    }
}

#[test]
fn an_unusable_home_gives_one_message_of_one_line() {
    let folder = Folder::new("no-home");
    let home = folder.file("home");
    fs::write(&home, "a file").expect("written");
    let mut window = Window::new(Lang::En);
    let ctx = window.harness.ctx.clone();
    window.app_mut().keep_preferences(&ctx, &home.join(".config/camera-lab"), LaunchOptions::default());
    window.app_mut().keep_session(&home.join(".local/share/camera-lab"), true);
    window.run();
    let told = |window: &Window| window.harness.query_all_by_label_contains("is not a directory").count();
    assert!(window.says("not saved, and changes in this window would be lost in a crash"));
    assert_eq!((told(&window), closing_buttons(&mut window).len()), (1, 1));
    // Writing runs beside the window.
    let change = |window: &mut Window, x: &str| {
        window.command_key(Key::T);
        window.enter("C x", x);
        for _ in 0..20 {
            std::thread::sleep(Duration::from_millis(5));
            window.run();
        }
    };
    change(&mut window, "1.25");
    assert_eq!((told(&window), closing_buttons(&mut window).len()), (1, 1));
    window.click(en::WINDOW.close);
    change(&mut window, "1.5");
    assert_eq!(told(&window), 0);
}

#[test]
fn a_small_screen_shows_the_message_at_the_bottom_of_the_window() {
    // The height that title bars and task bars take of a screen of 720 lines, generously.
    const BARS: f32 = 76.0;
    let mut state = State::new(Start::default()).expect("a camera");
    state.model.layout.maximized = Some(View::Image);
    state.model.say(Message::File("a.toml".into(), FileError::ReadOnly));
    let window = Window::with_state(state, gui::DEFAULT_SIZE);
    let error = window.harness.get_by_label_contains("a.toml is read-only").rect();
    assert!(error.bottom() <= 720.0 - BARS && error.right() <= 1280.0, "{error}");
}

#[test]
fn a_lesson_of_a_link_takes_the_place_of_a_restored_figure_after_a_question() {
    let folder = Folder::new("class-link");
    leave(&folder, "a.toml", "75.0");
    let mut window = Window::new(Lang::En);
    window.app_mut().keep_session(&folder.file("sessions"), true);
    // As a page does with `?lesson=basis`.
    let (asked, _) = LaunchOptions::of_query("?lesson=basis");
    let (ctx, open) = (window.harness.ctx.clone(), asked.open_lesson().expect("a lesson"));
    file_flow::begin(&ctx, &mut window.app_mut().state, Intent::Lesson(open));
    window.run();
    let t = texts(Lang::En);
    assert!(window.says(t.unsaved_title) && window.says("a.toml") && window.state().learn.lesson.is_none());
    window.click(t.dont_save);
    assert_eq!(window.state().learn.lesson.as_ref().map(|playing| playing.lesson.id.as_str()), Some("basis"));
}
