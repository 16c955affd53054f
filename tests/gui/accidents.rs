//! Accidents to files and clocks while a window is open: a message names each, and nothing is lost.
#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs::{self, File};
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

use camera_lab::camera::Parameters;
use camera_lab::gui::learn::exercises::state::Chosen;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;

use super::exercises;
use super::files::{Dropped, Folder};
use super::window::Window;
use crate::words::en;

fn pipe(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().is_ok_and(|status| status.success()));
}

impl Window {
    fn drop_files<'a>(&mut self, paths: impl IntoIterator<Item = &'a Path>) {
        let dropped = &mut self.harness.input_mut().dropped_files;
        dropped.extend(paths.into_iter().map(|path| Arc::new(Dropped(path.to_owned())) as _));
        self.run();
    }
}

#[test]
fn a_dropped_file_that_is_no_figure_is_refused() {
    let folder = Folder::new("dropped-else");
    let huge = folder.file("huge.toml");
    // A hole, which takes no room on the disk.
    File::create(&huge).unwrap().set_len(5 << 30).unwrap();
    fs::create_dir(folder.file("folder.toml")).unwrap();
    pipe(&folder.file("pipe.toml"));
    let mut window = Window::new(Lang::En);
    for (name, said) in [
        ("huge.toml", "huge.toml is too large; allowed: at most 8 MiB"),
        ("folder.toml", "folder.toml is a directory"),
        ("pipe.toml", "pipe.toml is a device, a pipe or a socket"),
        ("gone.toml", "gone.toml cannot be read: there is no such file"),
    ] {
        window.drop_files([&*folder.file(name)]);
        assert!(window.says(said), "{:?}", window.state().model.message);
        assert_eq!(window.state().model.desk.shown.name(), None);
    }
    // With changes, the window asks first, and the changes are there after all.
    window.enter("B", "40");
    window.drop_files([&*huge]);
    window.click(en::WINDOW.dont_save);
    assert!(window.says("huge.toml is too large"));
    assert_eq!(window.state().model.desk.shown.draft().far, 40.0);
    assert!(window.state().model.desk.shown.is_changed());
}

#[test]
fn meshes_that_are_none_stand_in_the_scene_with_the_reason() {
    let folder = Folder::new("dropped-meshes");
    File::create(folder.file("huge.obj")).unwrap().set_len(5 << 30).unwrap();
    fs::create_dir(folder.file("folder.glb")).unwrap();
    pipe(&folder.file("pipe.gltf"));
    fs::write(folder.file("tent.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let mut window = Window::new(Lang::En);
    // Alone they're no scene.
    window.drop_files([&*folder.file("huge.obj")]);
    window.wait(|window| window.says("512 MiB"));
    assert!(window.state().model.desk.shown.figure().scene.objects.iter().all(|object| object.name != "huge"));
    window.drop_files([&*folder.file("tent.obj")]);
    for (name, said) in [("huge.obj", "512 MiB"), ("folder.glb", "a directory"), ("pipe.gltf", "a pipe")] {
        window.drop_files([&*folder.file(name)]);
        window.wait(|window| window.says(said));
    }
    assert_eq!(window.state().model.desk.shown.figure().scene.objects.len(), 4);
    // The tent is a scene of its own.
    for left in (1..4).rev() {
        window.command_key(Key::Z);
        assert_eq!(window.state().model.desk.shown.figure().scene.objects.len(), left);
    }
}

#[test]
fn of_a_thousand_dropped_files_one_opens_and_a_message_says_so() {
    let folder = Folder::new("dropped-many");
    let paths: Vec<_> = (0..1000).map(|i| folder.file(&format!("{i}.toml"))).collect();
    fs::write(&paths[0], "[camera]\nfar = 61.0\n[scene]\npreset = \"empty\"\n").unwrap();
    let mut window = Window::new(Lang::En);
    window.drop_files(paths.iter().map(|path| &**path));
    assert_eq!(window.state().model.desk.shown.draft().far, 61.0);
    let said = window.state().model.message.as_ref().unwrap().text(Lang::En);
    assert!(said.starts_with("Of 1000 files, the window opens one: ") && said.ends_with("0.toml"), "{said}");
    // An error in the one file matters more than the number of files.
    window.drop_files(paths[1..].iter().map(|path| &**path));
    assert!(window.says("1.toml cannot be read"));
    assert_eq!(window.state().model.desk.shown.draft().far, 61.0);
}

#[test]
fn a_folder_of_exercises_that_goes_or_changes_its_kind_takes_no_answer_along() {
    let folder = Folder::new("exercises-go");
    let lecture = folder.file("lecture");
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/exercises/field-of-view.toml");
    let put = || {
        fs::create_dir_all(&lecture).unwrap();
        fs::copy(source, lecture.join("a.toml")).unwrap();
    };
    put();
    let mut window = exercises::window(Lang::En);
    window.app_mut().state.learn.exercises.look_into(Some(lecture.clone()));
    window.harness.key_press_modifiers(Modifiers::ALT, Key::X);
    window.run();
    let chosen = Chosen { id: "field-of-view".to_owned(), seed: 0 };
    let open = |window: &mut Window| {
        window.app_mut().state.learn.exercises.work_on(chosen.clone());
        window.run();
    };
    let again = |window: &mut Window| {
        window.app_mut().state.learn.exercises.leave();
        window.run();
        window.click(en::EXERCISE_WINDOW.own_again);
    };
    open(&mut window);
    window.harness.get_all_by_role(Role::TextInput).next().unwrap().click();
    window.run();
    window.harness.event(Event::Text("89".to_owned()));
    window.run();
    let typed = |window: &Window| {
        let mut fields = window.harness.get_all_by_role(Role::TextInput);
        fields.any(|field| field.value().as_deref() == Some("89"))
    };
    assert!(typed(&window));
    // The folder is gone, but you still work on the open exercise, and it is judged.
    fs::remove_dir_all(&lecture).unwrap();
    window.command_key(Key::Enter);
    assert!(typed(&window) && window.says("wrong"));
    again(&mut window);
    assert!(window.says("lecture cannot be read: there is no such file"));
    assert!(window.state().learn.exercises.entry("field-of-view").is_none());
    // A pipe in the place of its file: a message says so at once, and nothing waits for it.
    fs::create_dir_all(&lecture).unwrap();
    pipe(&lecture.join("a.toml"));
    window.click(en::EXERCISE_WINDOW.own_again);
    window.click("Skipped in the folder: 1");
    assert!(window.says("a.toml is a device, a pipe or a socket"));
    // A file in the place of the folder.
    fs::remove_dir_all(&lecture).unwrap();
    fs::write(&lecture, "?").unwrap();
    window.click(en::EXERCISE_WINDOW.own_again);
    assert!(window.says("lecture cannot be read: a part of the path is not a directory"));
    // It is back, and the typed answer as well.
    fs::remove_file(&lecture).unwrap();
    put();
    window.click(en::EXERCISE_WINDOW.own_again);
    open(&mut window);
    assert!(typed(&window));
}

/// "•" in the title of the window and in its menu bar means the same: closing asks.
#[test]
fn the_title_and_the_bar_mark_the_same_changes() {
    let marked = |window: &mut Window| {
        window.run();
        let bar = window.harness.query_all_by_label_contains(" •").next().is_some();
        let title = window.app_mut().title().contains(" •");
        assert_eq!(bar, title, "{}", window.app_mut().title());
        bar
    };
    // A step of a lesson is there to be tried.
    let mut window = super::lessons::playing(0, 0, Lang::En);
    assert!(!marked(&mut window));
    let document = &mut window.app_mut().state.model.desk.shown;
    document.set_parameters(Parameters { near: 1.5, ..*document.draft() });
    assert!(!marked(&mut window) && window.state().model.desk.shown.is_changed());
    // The layout of a figure that has a file is part of it.
    let folder = Folder::new("marks");
    let path = folder.file("mine.toml");
    fs::write(&path, "[scene]\npreset = \"empty\"\n[screen]\npictures = [\"image\"]\n").expect("a figure file");
    let mut window = Window::opened(&path);
    assert!(!marked(&mut window));
    window.command_key(Key::Num1);
    assert!(marked(&mut window));
    window.command_key(Key::S);
    assert!(!marked(&mut window));
    let document = &mut window.app_mut().state.model.desk.shown;
    document.set_parameters(Parameters { near: 1.5, ..*document.draft() });
    assert!(marked(&mut window));
}
