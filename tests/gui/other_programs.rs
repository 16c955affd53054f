//! Files that another program, or another window, changes in between. Files that may not be written.

use std::fs;
use std::path::Path;
use std::time::Duration;

use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab_files as files;
use camera_lab_words::Lang;
use eframe::egui::{Event, Key, Modifiers};

use super::files::Folder;
use super::window::Window;
use crate::words::en;

const MINE: &str = "# Mine.\n[camera]\nfar = 50.0\n\n[scene]\npreset = \"empty\"\n";
const THEIRS: &str = "# Theirs.\n[camera]\nfar = 61.0\n\n[scene]\npreset = \"empty\"\n";

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("there")
}

impl Window {
    /// The window gets the focus, and frames follow until `done`.
    fn focus(&mut self, done: impl Fn(&Self) -> bool) {
        self.harness.event(Event::WindowFocused(true));
        self.wait(done);
    }

    fn is_asked_about_the_file(&self) -> bool {
        matches!(self.state().file_flow.dialog, Some(Dialog::Changed(_)))
    }
}

#[test]
fn a_file_changed_by_another_program_is_replaced_only_after_asking() {
    let folder = Folder::new("changed-file");
    let path = folder.file("a.toml");
    fs::write(&path, MINE).expect("written");
    let mut window = Window::opened(&path);
    window.enter("B", "75");
    fs::write(&path, THEIRS).expect("written");
    window.command_key(Key::S);
    assert!(window.is_asked_about_the_file());
    assert_eq!(read(&path), THEIRS);
    window.click(en::WINDOW.compare);
    assert!(window.says("− # Theirs.") && window.says("− far = 61.0"));
    assert!(window.says("+ # Mine.") && window.says("+ far = 75.0"));
    window.click(en::WINDOW.cancel);
    assert_eq!(read(&path), THEIRS);
    assert!(window.state().model.desk.shown.is_changed());

    // A file that was not there at the question is asked about again.
    window.command_key(Key::S);
    fs::write(&path, "# Again.\n").expect("written");
    window.click(en::WINDOW.replace);
    assert!(window.is_asked_about_the_file());
    assert_eq!(read(&path), "# Again.\n");
    window.click(en::WINDOW.replace);
    assert!(read(&path).contains("far = 75.0") && read(&path).contains("# Mine."));
    assert!(!window.state().model.desk.shown.is_changed());
    window.enter("B", "76");
    window.command_key(Key::S);
    assert!(window.state().file_flow.dialog.is_none());
    assert!(read(&path).contains("far = 76.0"));
}

#[test]
fn a_changed_file_can_be_saved_beside_before_closing() {
    let folder = Folder::new("changed-beside");
    let path = folder.file("a.toml");
    fs::write(&path, MINE).expect("written");
    let mut window = Window::opened(&path);
    window.enter("B", "75");
    fs::write(&path, THEIRS).expect("written");
    window.command_key(Key::Q);
    window.click(en::WINDOW.save);
    assert!(window.is_asked_about_the_file() && !window.state().file_flow.may_close);
    window.click(en::WINDOW.save_as);
    window.choose(&folder.file("b.toml"));
    assert_eq!(read(&path), THEIRS);
    assert!(read(&folder.file("b.toml")).contains("far = 75.0"));
    assert!(window.state().file_flow.may_close);
}

#[test]
fn a_window_that_gets_the_focus_offers_to_reload_once() {
    let folder = Folder::new("reload");
    let path = folder.file("a.toml");
    fs::write(&path, MINE).expect("written");
    for lang in [Lang::En, Lang::PtBr] {
        fs::write(&path, MINE).expect("written");
        let mut window = Window::opened(&path);
        window.app_mut().state.model.settings.lang = lang;
        let [says, reload, keep] = match lang {
            Lang::En => ["was changed by another program.", "Reload", "Keep mine"],
            _ => ["foi alterado por outro programa.", "Recarregar", "Manter o meu"],
        };
        fs::write(&path, THEIRS).expect("written");
        window.focus(|window| window.theirs().is_some());
        assert!(window.says(says));
        window.click(keep);
        assert!(!window.says(says));
        assert_eq!(window.state().model.desk.shown.figure().camera.far, 50.0);
        // The same content gives no second message. Another one does.
        window.harness.event(Event::WindowFocused(true));
        for _ in 0..10 {
            std::thread::sleep(Duration::from_millis(10));
            window.run();
        }
        assert!(!window.says(says));
        fs::write(&path, THEIRS.replace("61", "62")).expect("written");
        window.focus(|window| window.theirs().is_some());
        window.click(reload);
        assert_eq!(window.state().model.desk.shown.figure().camera.far, 62.0);
        assert!(!window.says(says) && !window.state().model.desk.shown.is_changed());
        // As it was read, so there is no message.
        let touched = fs::File::options().write(true).open(&path).expect("there");
        touched.set_modified(std::time::SystemTime::UNIX_EPOCH).expect("possible");
        window.harness.event(Event::WindowFocused(true));
        for _ in 0..10 {
            std::thread::sleep(Duration::from_millis(10));
            window.run();
        }
        assert!(!window.says(says));
    }
}

#[test]
fn a_window_with_changes_says_that_the_file_was_changed_too() {
    let folder = Folder::new("both-changed");
    let path = folder.file("a.toml");
    fs::write(&path, MINE).expect("written");
    let mut window = Window::opened(&path);
    window.enter("B", "75");
    fs::write(&path, THEIRS).expect("written");
    window.focus(|window| window.theirs().is_some());
    assert!(window.says("you have changes in this window too. Saving asks first."));
    assert!(!window.says(en::WINDOW.reload));
    window.click(en::WINDOW.compare);
    assert!(window.is_asked_about_the_file());
    window.key(Key::Escape);
    // The other program takes its change back.
    fs::write(&path, MINE).expect("written");
    window.focus(|window| window.theirs().is_none());
    window.command_key(Key::S);
    assert!(read(&path).contains("far = 75.0"));
}

#[test]
fn two_windows_on_one_file_do_not_write_over_each_other() {
    let folder = Folder::new("two-windows");
    let path = folder.file("a.toml");
    fs::write(&path, MINE).expect("written");
    let (mut one, mut other) = (Window::opened(&path), Window::opened(&path));
    one.enter("B", "75");
    other.enter("F", "0.5");
    one.command_key(Key::S);
    other.command_key(Key::S);
    assert!(other.is_asked_about_the_file());
    assert!(read(&path).contains("far = 75.0") && !read(&path).contains("0.5"));
    other.click(en::WINDOW.replace);
    assert!(read(&path).contains("near = 0.5"));
    one.focus(|one| one.theirs().is_some());
    one.click(en::WINDOW.reload);
    assert_eq!(one.state().model.desk.shown.figure().camera.near, 0.5);
}

#[test]
fn a_read_only_file_is_asked_about() {
    let folder = Folder::new("read-only");
    let path = folder.file("a.toml");
    fs::write(&path, MINE).expect("written");
    let mut permissions = fs::metadata(&path).expect("there").permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&path, permissions).expect("possible");
    let mut window = Window::opened(&path);
    window.enter("B", "75");
    window.command_key(Key::S);
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::ReadOnly(..))));
    window.click(en::WINDOW.cancel);
    assert_eq!(read(&path), MINE);
    // Two reasons to ask are two questions.
    window.command_key(Key::S);
    window.click(en::WINDOW.save_as);
    window.choose(&folder.file("b.toml"));
    assert!(read(&folder.file("b.toml")).contains("far = 75.0"));
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    window.choose(&path);
    window.click(en::WINDOW.replace);
    assert_eq!(read(&path), MINE);
    assert!(window.says(en::WINDOW.read_only_title));
    window.click(en::WINDOW.replace);
    assert!(read(&path).contains("far = 75.0"));
    assert!(fs::metadata(&path).expect("there").permissions().readonly());
}

#[test]
fn paths_are_whole_from_the_moment_they_are_taken() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::O);
    window.choose(Path::new("tests/figures/documented.toml"));
    let path = window.state().model.desk.shown.path().expect("a file").clone();
    assert_eq!(path, Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/figures/documented.toml"));
    let (_, file) = files::open_figure(&path).expect("a figure").at(Path::new("tests/figures/documented.toml"));
    assert_eq!(file.path, path);
    let folder = window.state().model.desk.shown.folder().expect("a folder").to_owned();
    assert!(folder.is_absolute());
}
