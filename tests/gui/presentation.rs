//! A lecture: one figure after the other without losing what was changed, and what is drawn and shown over the
//! pictures.

use std::fs;

use camera_lab::figure::Explanation;
use camera_lab::i18n::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, vec2};
use egui_kittest::kittest::{By, Queryable};

use super::files::Folder;
use super::window::Window;

/// A window with the second of four figures of a folder, the third of which is broken.
fn lecture(folder: &Folder) -> Window {
    for (name, far) in [("aula 1.toml", 30), ("aula 2.toml", 40), ("aula 9.toml", 0), ("aula 10.toml", 50)] {
        fs::write(folder.file(name), format!("[camera]\nfar = {far}\n[scene]\npreset = \"empty\"\n")).expect("written");
    }
    Window::opened(&folder.file("aula 2.toml"))
}

fn name(window: &Window) -> String {
    window.state().document.name().unwrap_or_default()
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
    assert!(!window.says("By the sea.") && window.state().shows_explanation(Explanation::Depth));
    window.key(Key::PageDown);
    let state = window.state();
    assert!(!state.shows_explanation(Explanation::Depth) && state.layout.shown == [true; 3], "the user's own");
    window.key(Key::PageUp);
    window.key(Key::PageUp);
    window.command_key(Key::L);
    assert!(window.says("Uma casa") && window.says("À beira-mar."));
    // What a figure wants to be explained stays open where a presentation begins with it.
    let mut window = Window::opened(&folder.file("2.toml"));
    window.key(Key::F11);
    assert!(window.state().settings.presentation && window.state().shows_explanation(Explanation::Depth));
}

#[test]
fn figures_come_one_after_the_other_and_what_was_changed_is_there_when_one_comes_back() {
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
    assert!(window.says("This is the last figure"));
    window.key(Key::PageUp);
    assert_eq!((name(&window).as_str(), window.state().document.figure().camera.far), ("aula 2.toml", 77.0));
    assert!(window.state().document.is_changed() && window.state().document.can_undo());
    window.key(Key::PageUp);
    assert_eq!((name(&window).as_str(), window.state().kept.len()), ("aula 1.toml", 1));
    // What was gone through is among the files that were used last.
    let recent = ["aula 1.toml", "aula 2.toml", "aula 10.toml"].map(|name| folder.file(name));
    assert_eq!(window.state().recent.files[..3], recent);
    // Opened by its name, it is the one that was left.
    window.command_key(Key::O);
    window.choose(&folder.file("aula 2.toml"));
    assert_eq!(window.state().document.figure().camera.far, 77.0);
    window.key(Key::PageUp);
    // Whoever closes the window is asked about it.
    window.command_key(Key::Q);
    assert!(window.says("Save the changes?") && window.says("aula 2.toml"));
    window.click("Save");
    assert!(fs::read_to_string(folder.file("aula 2.toml")).expect("there").contains("far = 77"));
    assert!(window.state().file_flow.may_close);
}

#[test]
fn what_lies_between_two_figures_is_passed_over_and_told() {
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
fn whoever_does_not_close_after_all_has_lost_no_figure() {
    let folder = Folder::new("given-up");
    for name in ["1.toml", "2.toml", "3.toml"] {
        fs::write(folder.file(name), "[camera]\nfar = 50.0\n").expect("written");
    }
    let mut window = Window::opened(&folder.file("1.toml"));
    for far in ["61", "62", "63"] {
        window.enter("B", far);
        window.command_key(Key::PageDown);
    }
    assert_eq!((name(&window).as_str(), window.state().kept.len()), ("3.toml", 2));
    // Esc and the button alike; also in the question that comes in between.
    for cancel in [true, false] {
        window.command_key(Key::Q);
        for _ in 0..2 {
            window.click("Don't save");
        }
        assert!(window.says("Save the changes?") && !window.state().file_flow.may_close);
        if cancel {
            window.click("Cancel");
        } else {
            window.key(Key::Escape);
        }
        window.run();
        let mut left: Vec<f64> = window.state().kept.iter().map(|(_, kept)| kept.figure().camera.far).collect();
        left.push(window.state().document.figure().camera.far);
        left.sort_by(f64::total_cmp);
        assert_eq!(left, [61.0, 62.0, 63.0]);
    }
    // They are asked about again, all three of them.
    window.command_key(Key::Q);
    for _ in 0..3 {
        assert!(!window.state().file_flow.may_close);
        window.click("Don't save");
    }
    assert!(window.state().file_flow.may_close);
}

#[test]
fn outside_of_a_presentation_the_keys_are_those_of_the_menu_and_a_new_figure_is_not_lost() {
    let mut window = Window::new(Lang::En);
    window.enter("B", "33");
    window.command_key(Key::PageDown);
    assert_eq!(name(&window), "primitives.toml");
    window.command_key(Key::PageDown);
    assert_eq!(name(&window), "house.toml");
    window.key(Key::PageUp);
    assert_eq!(name(&window), "house.toml");
    window.command_key(Key::PageUp);
    window.command_key(Key::PageUp);
    assert_eq!((window.state().document.name(), window.state().document.figure().camera.far), (None, 33.0));
}

#[test]
fn escape_clears_what_lies_over_the_pictures_and_then_leaves() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F11);
    window.key(Key::P);
    let before = window.state().document.figure().clone();
    let picture = window.harness.get_by_label_contains("Image: what the camera sees").rect();
    window.drag(picture.center(), vec2(60.0, 20.0), |_| {});
    assert_eq!(window.state().annotations.strokes.len(), 1);
    assert!(window.state().annotations.strokes[0].len() > 2);
    assert_eq!(window.state().document.figure(), &before, "the pen moves nothing");
    window.key(Key::S);
    window.key(Key::Period);
    assert!(window.state().annotations.spot && window.state().annotations.blank);
    window.key(Key::Escape);
    assert!(!window.state().annotations.any() && window.state().settings.presentation);
    window.key(Key::Escape);
    assert!(!window.state().settings.presentation);
    // Esc does not begin one.
    window.key(Key::Escape);
    assert!(!window.state().settings.presentation);
}

#[test]
fn frozen_pictures_stay_while_one_edits() {
    let mut window = Window::new(Lang::En);
    window.harness.key_press_modifiers(eframe::egui::Modifiers::ALT, Key::F);
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
        window.app_mut().state.layout.maximized = None;
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
    /// B of the camera, in a presentation, where the panel is hidden.
    fn enter_far(&mut self, text: &str) {
        self.key(Key::F8);
        self.enter("B", text);
        self.key(Key::F8);
    }
}
