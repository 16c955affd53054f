//! A lecture: one figure after the other without losing changes, and the ink and the overlays over the pictures.

use std::fs;

use camera_lab::figure::Explanation;
use camera_lab::gui::kit::keys::Command;
use camera_lab::gui::{Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_desk::layout::Side;
use camera_lab_words::Lang;
use camera_lab_words::window::texts;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, pos2, vec2};
use egui_kittest::kittest::{By, Queryable};

use super::files::Folder;
use super::window::Window;
use crate::words::en;

/// A window with the second of four figures of a folder, the third of which is broken.
fn lecture(folder: &Folder) -> Window {
    for (name, far) in [("aula 1.toml", 30), ("aula 2.toml", 40), ("aula 9.toml", 0), ("aula 10.toml", 50)] {
        fs::write(folder.file(name), format!("[camera]\nfar = {far}\n[scene]\npreset = \"empty\"\n")).expect("written");
    }
    Window::opened(&folder.file("aula 2.toml"))
}

fn name(window: &Window) -> String {
    window.state().model.desk.shown.name().unwrap_or_default()
}

#[test]
fn a_presentation_says_title_and_caption_and_shows_each_figure_as_it_wants() {
    let folder = Folder::new("captions");
    let told = "title = { en = \"A house\", pt-BR = \"Uma casa\" }\ncaption = { en = \"By the sea.\", pt-BR = \"À beira-mar.\" }\n";
    fs::write(folder.file("1.toml"), format!("{told}[scene]\npreset = \"house\"\n[screen]\npictures = [\"image\"]\n"))
        .expect("written");
    fs::write(folder.file("2.toml"), "[scene]\npreset = \"empty\"\n[screen]\npanel = \"depth\"\n").expect("written");
    fs::write(folder.file("3.toml"), "[scene]\npreset = \"empty\"\n").expect("written");
    let mut window = Window::opened(&folder.file("1.toml"));
    assert!(!window.says("By the sea."));
    window.key(Key::F11);
    assert!(window.says("A house") && window.says("By the sea."));
    window.key(Key::PageDown);
    assert!(!window.says("By the sea.") && window.state().model.shows_explanation(Explanation::Depth));
    window.key(Key::PageDown);
    let state = window.state();
    assert!(
        !state.model.shows_explanation(Explanation::Depth) && state.model.layout.shown == [true; 3],
        "the user's own"
    );
    window.key(Key::PageUp);
    window.key(Key::PageUp);
    window.command_key(Key::L);
    assert!(window.says("Uma casa") && window.says("À beira-mar."));
    // An explanation that a figure asks for stays open if a presentation begins with it.
    let mut window = Window::opened(&folder.file("2.toml"));
    window.key(Key::F11);
    assert!(window.state().model.settings.presentation && window.state().model.shows_explanation(Explanation::Depth));
}

#[test]
fn figures_follow_each_other_and_changes_are_there_on_return() {
    let folder = Folder::new("lecture");
    let mut window = lecture(&folder);
    window.key(Key::F11);
    window.enter_far("77");
    // The broken one is passed over, and said.
    window.key(Key::PageDown);
    assert_eq!(name(&window), "aula 10.toml");
    assert!(window.says("aula 9.toml") && window.state().file_flow.dialog.is_none());
    window.key(Key::PageDown);
    assert_eq!(name(&window), "aula 10.toml");
    assert!(window.says(en::WINDOW.last_figure));
    window.key(Key::PageUp);
    assert_eq!((name(&window).as_str(), window.state().model.desk.shown.figure().camera.far), ("aula 2.toml", 77.0));
    assert!(window.state().model.desk.shown.is_changed() && window.state().model.desk.can_undo(true));
    window.key(Key::PageUp);
    assert_eq!((name(&window).as_str(), window.state().model.desk.held().len()), ("aula 1.toml", 1));
    // Shown figures are among the recent files.
    let recent = ["aula 1.toml", "aula 2.toml", "aula 10.toml"].map(|name| folder.file(name));
    assert_eq!(window.state().recent.files[..3], recent);
    // Opened by its name, it is the one that was left.
    window.command_key(Key::O);
    window.choose(&folder.file("aula 2.toml"));
    assert_eq!(window.state().model.desk.shown.figure().camera.far, 77.0);
    window.key(Key::PageUp);
    // Closing the window asks about it.
    window.command_key(Key::Q);
    assert!(window.says(en::WINDOW.unsaved_title) && window.says("aula 2.toml"));
    window.click(en::WINDOW.save);
    assert!(fs::read_to_string(folder.file("aula 2.toml")).expect("there").contains("far = 77"));
    assert!(window.state().file_flow.may_close);
}

#[test]
fn unreadable_files_between_two_figures_are_skipped_with_a_message() {
    let folder = Folder::new("foreign-figures");
    for name in ["1.toml", "9.toml"] {
        fs::write(folder.file(name), "[scene]\npreset = \"empty\"\n").expect("written");
    }
    let mut window = Window::opened(&folder.file("1.toml"));
    fs::write(folder.file("2 exercise.toml"), "id = \"x\"\ntitle = \"T\"\n").expect("written");
    window.command_key(Key::PageDown);
    assert_eq!(name(&window), "9.toml");
    assert!(window.says("2 exercise.toml, line 1") && !window.says("were skipped"));
    window.command_key(Key::PageUp);
    fs::create_dir(folder.file("3.toml")).expect("made");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("nowhere", folder.file("4.toml")).expect("linked");
        std::os::unix::fs::symlink("5.toml", folder.file("5.toml")).expect("linked");
        let made = std::process::Command::new("mkfifo").arg(folder.file("6.toml")).status();
        assert!(made.is_ok_and(|status| status.success()));
    }
    window.command_key(Key::PageDown);
    assert_eq!(name(&window), "9.toml");
    assert!(window.says("2 exercise.toml, line 1") && window.says("were skipped"));
    window.command_key(Key::L);
    window.command_key(Key::PageUp);
    assert_eq!(name(&window), "1.toml");
    assert!(window.says("ignorado"));
}

#[test]
fn cancelling_the_close_loses_no_figure() {
    let folder = Folder::new("given-up");
    for name in ["1.toml", "2.toml", "3.toml"] {
        fs::write(folder.file(name), "[camera]\nfar = 50.0\n").expect("written");
    }
    let mut window = Window::opened(&folder.file("1.toml"));
    for far in ["61", "62", "63"] {
        window.enter("B", far);
        window.command_key(Key::PageDown);
    }
    assert_eq!((name(&window).as_str(), window.state().model.desk.held().len()), ("3.toml", 2));
    // Esc and the button alike, also in the question that comes in between.
    for cancel in [true, false] {
        window.command_key(Key::Q);
        for _ in 0..2 {
            window.click(en::WINDOW.dont_save);
        }
        assert!(window.says(en::WINDOW.unsaved_title) && !window.state().file_flow.may_close);
        if cancel {
            window.click(en::WINDOW.cancel);
        } else {
            window.key(Key::Escape);
        }
        window.run();
        let mut left: Vec<f64> = window.state().model.desk.held().iter().map(|held| held.figure().camera.far).collect();
        left.push(window.state().model.desk.shown.figure().camera.far);
        left.sort_by(f64::total_cmp);
        assert_eq!(left, [61.0, 62.0, 63.0]);
    }
    // They are asked about again, all three of them.
    window.command_key(Key::Q);
    for _ in 0..3 {
        assert!(!window.state().file_flow.may_close);
        window.click(en::WINDOW.dont_save);
    }
    assert!(window.state().file_flow.may_close);
}

#[test]
fn outside_a_presentation_menu_keys_apply_and_a_new_figure_is_not_lost() {
    let mut window = Window::new(Lang::En);
    window.enter("B", "33");
    window.command_key(Key::PageDown);
    assert_eq!(name(&window), "primitives.toml");
    assert!(window.says(en::WINDOW.work_waits), "its changes aren't saved");
    window.command_key(Key::PageDown);
    assert_eq!(name(&window), "house.toml");
    window.key(Key::PageUp);
    assert_eq!(name(&window), "house.toml");
    window.command_key(Key::PageUp);
    window.command_key(Key::PageUp);
    assert_eq!(
        (window.state().model.desk.shown.name(), window.state().model.desk.shown.figure().camera.far),
        (None, 33.0)
    );
}

#[test]
fn escape_clears_the_overlays_and_then_leaves() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F11);
    window.key(Key::P);
    let before = window.state().model.desk.shown.figure().clone();
    let picture = window.harness.get_by_label_contains("Image: what the camera sees").rect();
    window.drag(picture.center(), vec2(60.0, 20.0), |_| {});
    assert_eq!(window.state().annotations.strokes.len(), 1);
    assert!(window.state().annotations.strokes[0].len() > 2);
    assert_eq!(window.state().model.desk.shown.figure(), &before, "the pen moves nothing");
    window.key(Key::S);
    window.key(Key::Period);
    assert!(window.state().annotations.spot && window.state().annotations.blank);
    window.key(Key::Escape);
    assert!(!window.state().annotations.any() && window.state().model.settings.presentation);
    window.key(Key::Escape);
    assert!(!window.state().model.settings.presentation);
    // Esc does not begin one.
    window.key(Key::Escape);
    assert!(!window.state().model.settings.presentation);
}

#[test]
fn frozen_pictures_stay_while_one_edits() {
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::F);
    window.run();
    let drawn = window.app_mut().canvas.drawn();
    window.enter("B", "44");
    assert_eq!(window.app_mut().canvas.drawn(), drawn);
    assert!(window.written().iter().any(|(line, _)| line.contains("frozen")));
    window.key(Key::Escape);
    assert_ne!(window.app_mut().canvas.drawn(), drawn);
}

#[test]
fn the_keys_stand_under_the_pictures_for_a_while_and_cover_nothing() {
    for (lang, first) in [(Lang::En, "Esc: leave"), (Lang::PtBr, "Esc: sair")] {
        let mut window = Window::new(lang);
        window.app_mut().state.model.layout.maximized = None;
        window.key(Key::F11);
        let said = window.written().into_iter().find(|(text, _)| text.contains(first)).expect("the keys");
        let shown = window.harness.query_all(By::new().role(Role::Image));
        let lowest = shown.map(|picture| picture.rect().bottom()).fold(0.0, f32::max);
        assert!(lowest > 100.0 && said.1.top() >= lowest, "{said:?}, pictures end at {lowest}");
        let others = window.written().into_iter().filter(|(text, _)| *text != said.0);
        for (text, place) in others {
            assert!(!place.shrink(1.0).intersects(said.1), "over “{text}”");
        }
    }
}

impl Window {
    /// True if this is drawn.
    fn is_written(&self, text: &str) -> bool {
        self.written().iter().any(|(written, _)| written.contains(text))
    }

    /// B of the camera, in a presentation, in which the panel is hidden.
    fn enter_far(&mut self, text: &str) {
        self.key(Key::F8);
        self.enter("B", text);
        self.key(Key::F8);
    }
}

#[test]
fn beside_a_panel_one_picture_is_large_and_it_is_the_one_that_is_explained() {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Empty;
    figure.style.antialias = camera_lab::appearance::Samples::One;
    let mut state =
        State::new(Start { figure, file: None, lang: Lang::En, allow_files: false, lesson: None, later: None })
            .expect("a camera");
    state.model.settings.reduce_motion = true;
    let mut window = Window::with_state(state, [1280.0, 720.0]);
    let shown = |window: &mut Window| -> Vec<View> { window.app_mut().canvas.places().map(|(view, _)| view).collect() };
    window.key(Key::F11);
    assert_eq!(shown(&mut window).len(), 3, "there is room for three without a panel");
    for (explanation, expected) in
        [(Explanation::Matrices, View::World), (Explanation::Steps, View::Canonical), (Explanation::Depth, View::Image)]
    {
        let state = &mut window.app_mut().state;
        state.model.settings.panels_mut().show(Side::Explain);
        state.model.explained.show(explanation);
        window.run();
        assert_eq!(shown(&mut window), [expected], "{explanation:?}");
        let place = window.app_mut().canvas.places().map(|(_, place)| place).next().expect("one");
        assert!(place.width() > 300.0 && place.height() > 300.0, "{place:?}");
    }
    window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
    window.run();
    assert_eq!(shown(&mut window).len(), 3);
}

#[test]
fn ink_stays_with_its_step() {
    let mut window = super::lessons::playing(0, 0, Lang::En);
    window.key(Key::F11);
    window.key(Key::P);
    let picture = window.harness.get_by_label_contains("Image: what the camera sees").rect();
    window.drag(picture.center(), vec2(60.0, 20.0), |_| {});
    let ink = window.state().annotations.strokes.clone();
    assert_eq!(ink.len(), 1);
    window.key(Key::PageDown);
    window.key(Key::PageDown);
    assert!(window.state().annotations.strokes.is_empty());
    while window.state().learn.lesson.as_ref().is_some_and(|playing| playing.step > 0) {
        window.key(Key::PageUp);
    }
    assert_eq!(window.state().annotations.strokes, ink);
}

#[test]
fn ink_stays_with_its_figure_and_the_window_says_escape_clears_it() {
    let folder = Folder::new("ink");
    for name in ["1.toml", "2.toml"] {
        fs::write(folder.file(name), "[scene]\npreset = \"empty\"\n").expect("written");
    }
    let mut window = Window::opened(&folder.file("1.toml"));
    window.key(Key::F11);
    assert!(window.is_written("Esc: leave") && !window.is_written("Esc: clear"));
    window.key(Key::P);
    let draw = |window: &mut Window| {
        let picture = window.harness.get_by_label_contains("Image: what the camera sees").rect();
        window.drag(picture.center(), vec2(60.0, 20.0), |_| {});
    };
    draw(&mut window);
    // Also without the pen, as long as there is ink.
    window.key(Key::P);
    assert!(!window.state().annotations.pen && window.is_written("Esc: clear"));
    let ink = window.state().annotations.strokes.clone();
    assert_eq!(ink.len(), 1);
    window.key(Key::PageDown);
    assert_eq!((name(&window).as_str(), window.state().annotations.strokes.len()), ("2.toml", 0));
    window.key(Key::P);
    draw(&mut window);
    draw(&mut window);
    window.key(Key::PageUp);
    assert_eq!(window.state().annotations.strokes, ink);
    window.key(Key::PageDown);
    assert_eq!(window.state().annotations.strokes.len(), 2);
    window.key(Key::Escape);
    assert!(window.state().annotations.strokes.is_empty() && !window.is_written("Esc: clear"));
    window.key(Key::PageUp);
    assert_eq!(window.state().annotations.strokes, ink, "that of the other figure was not cleared");
}

#[test]
fn menus_and_signs_are_hidden_until_the_pointer_comes_to_the_upper_border() {
    let mut window = Window::new(Lang::En);
    let bar = |window: &Window| [window.is_written("File"), window.is_written("◧")];
    assert_eq!(bar(&window), [true; 2]);
    window.key(Key::F11);
    assert_eq!(bar(&window), [false; 2]);
    let room = |window: &mut Window| window.app_mut().canvas.places().next().map(|(_, place)| place);
    let before = room(&mut window);
    for (at, expected) in [(300.0, false), (4.0, true), (300.0, false)] {
        window.harness.hover_at(pos2(500.0, at));
        window.run();
        assert_eq!(bar(&window), [expected; 2], "pointer at {at}");
        assert_eq!(room(&mut window), before, "it moves no picture");
    }
}

#[test]
fn the_help_lists_the_signs_of_the_bar() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut window = Window::new(lang);
        assert!(!window.says(t.help_signs));
        window.key(Key::F1);
        assert!(window.says(t.help_signs));
        let said = |sign: &str, command: Command| {
            let entry = format!("{sign} {}", command.label(t));
            assert!(window.says(&entry), "{entry}");
        };
        said("↶", Command::Undo);
        said("◧", Command::ParametersPanel);
        said("⬓", Command::Pipeline);
        said("◨", Command::NumbersPanel);
        said("✎", Command::Exercises);
        said("▶", Command::Presentation);
    }
}
