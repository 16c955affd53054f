//! The gallery: the figures of the program, those used last, those of a folder.

use std::fs;
use std::time::{Duration, Instant};

use camera_lab::figure::Explanation;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::gui::gallery::Part;
use camera_lab::scene::Preset;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;

use super::files::Folder;
use super::window::Window;
use crate::words::{en, pt};

impl Window {
    /// Frames until two seconds bring nothing new: each small picture that comes in asks for a frame.
    fn wait_for_quiet(&mut self) {
        let since = Instant::now();
        let mut quiet = 0;
        while quiet < 40 {
            assert!(since.elapsed() < Duration::from_secs(300), "pictures keep coming");
            std::thread::sleep(Duration::from_millis(50));
            let still = self.harness.try_run().is_ok_and(|steps| steps <= 1);
            quiet = if still { quiet + 1 } else { 0 };
        }
    }
}

impl Window {
    /// Types words of cards in the place of others.
    pub(crate) fn search_cards(&mut self, wanted: &str) {
        self.harness.get_by_role_and_label(Role::TextInput, "Search the cards").focus();
        self.run();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.harness.event(Event::Text(wanted.to_owned()));
        self.run();
    }
}

#[test]
fn figures_of_the_program_are_chosen_with_the_keys_and_opened() {
    let mut window = Window::new(Lang::PtBr);
    window.click(pt::GALLERY.gallery);
    window.wait_for("Primitivas: Uma de cada forma");
    window.wait_for("Cena vazia: Nada");
    window.wait_for_quiet();
    for key in [Key::ArrowRight, Key::ArrowDown, Key::ArrowLeft, Key::ArrowUp, Key::ArrowUp] {
        window.key(key);
    }
    // Right, down, left and up lead back. Further up there is nothing.
    window.key(Key::ArrowRight);
    window.key(Key::Enter);
    let document = &window.state().model.desk.shown;
    assert_eq!((document.name().as_deref(), document.path()), (Some("house.toml"), None));
    assert_eq!(document.figure().scene.preset, Preset::House);
    assert!(!document.is_changed() && window.state().file_flow.dialog.is_none());
}

#[test]
fn a_card_is_found_by_other_words_and_opens_its_state() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::G);
    for heading in ["The camera", "Hidden surfaces and depth", "Limits of numbers"] {
        assert!(window.says(heading), "{heading}");
    }
    window.wait_for("The painter's failure: Three bars");
    window.search_cards("depth sort");
    window.run();
    assert!(window.says("The painter's failure: ") && !window.says("Teapot: ") && !window.says(en::GALLERY.limits));
    window.search_cards("xyzzy");
    window.run();
    assert!(window.says("No card has these words."));
    window.search_cards("painter failure");
    window.key(Key::Enter);
    let state = window.state();
    assert_eq!(state.model.desk.shown.shipped_name(), Some("painter"));
    assert_eq!(
        (state.model.layout.shown, state.model.explained.shown()),
        ([false, false, true], Explanation::HiddenSurfaces)
    );
    assert!(state.model.shows_explanation(Explanation::HiddenSurfaces) && !state.model.desk.shown.is_changed());
    // The next one says nothing about the layout: it is as it was before the card.
    window.command_key(Key::G);
    window.wait_for("House: ");
    window.search_cards("mirror image");
    window.run();
    window.key(Key::ArrowDown);
    window.key(Key::Enter);
    let state = window.state();
    assert_eq!(state.model.desk.shown.shipped_name(), Some("house"));
    assert!(state.model.layout.shown == [true; 3] && !state.model.shows_explanation(Explanation::HiddenSurfaces));
    // The frame stands on the figure that is open, also after paging.
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::PageDown);
    window.run();
    assert_eq!(window.state().model.desk.shown.shipped_name(), Some("corridor"));
    window.command_key(Key::G);
    window.wait_for("Corridor: ");
    assert!(window.harness.get_by_label_contains("Corridor: ").is_focused());
}

#[test]
fn the_card_of_an_exercise_opens_the_exercise() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::G);
    window.wait_for("House: ");
    window.search_cards("5.1");
    window.run();
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.shipped_name(), Some("exercise-5.1"));
    assert!(window.state().model.shows_exercises());
    assert_eq!(window.state().learn.exercises.open.as_ref().map(|open| open.id.as_str()), Some("0-5.1"));
}

#[test]
fn who_types_in_the_gallery_searches_and_headings_are_links() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::G);
    window.wait_for("Primitives: ");
    let top = |window: &Window| window.harness.get_by_label_contains("Phong shading: ").rect().top();
    assert!(top(&window) > 800.0, "far below");
    window.harness.get_by_role_and_label(Role::Link, "Light, textures and shadows").click();
    window.run();
    window.run();
    assert!(top(&window) < 500.0, "{}", top(&window));
    window.harness.event(Event::Text("z-fi".to_owned()));
    window.run();
    window.harness.event(Event::Text("ghting".to_owned()));
    window.run();
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.shipped_name(), Some("z-fighting"));
    let other = window.state().model.compared().expect("it compares");
    assert_eq!(other.comparison.with[0].0, "style.depth_format");
}

#[test]
fn the_frame_in_a_folder_follows_the_figure_that_is_open() {
    let folder = Folder::new("frame");
    for name in ["a.toml", "b.toml", "c.toml"] {
        fs::write(folder.file(name), "title = \"One\"\n[scene]\npreset = \"empty\"\n").expect("written");
    }
    let mut window = Window::opened(&folder.file("a.toml"));
    window.command_key(Key::G);
    for _ in 0..2 {
        window.harness.key_press_modifiers(Modifiers::CTRL, Key::Tab);
        window.run();
    }
    // A figure with neither caption nor comment shows its place.
    let card = |name: &str| format!("One: {}", folder.file(name).display());
    window.wait_for(&card("a.toml"));
    window.wait_for(&card("b.toml"));
    window.key(Key::ArrowRight);
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.path(), Some(&folder.file("b.toml")));
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::PageDown);
    window.run();
    window.command_key(Key::G);
    window.wait_for(&card("c.toml"));
    assert!(window.harness.get_by_label_contains(&card("c.toml")).is_focused());
}

#[test]
fn if_dividing_first_does_no_harm_a_figure_that_shows_it_is_offered() {
    let mut window = Window::new(Lang::En);
    window.explain(Explanation::Clipping);
    assert!(!window.says(en::GALLERY.shows));
    window.click(en::WINDOW.divide_first);
    window.click("Open the figure that shows it: Dividing before clipping");
    assert!(window.says(en::WINDOW.unsaved_title));
    window.click(en::WINDOW.dont_save);
    let state = window.state();
    assert_eq!(state.model.desk.shown.shipped_name(), Some("divide-first"));
    assert!(state.model.shows_explanation(Explanation::Clipping) && !window.says(en::GALLERY.shows));
}

#[test]
fn changes_are_asked_about_and_esc_leaves_everything_as_it_was() {
    let mut window = Window::new(Lang::En);
    window.enter("C x", "1");
    window.command_key(Key::G);
    assert!(window.says(en::GALLERY.gallery));
    window.key(Key::Escape);
    assert!(window.state().file_flow.dialog.is_none());
    // As a finger does.
    window.command_key(Key::G);
    window.click(en::WINDOW.close);
    assert!(window.state().file_flow.dialog.is_none());
    window.command_key(Key::G);
    window.key(Key::Enter);
    assert!(window.says(en::WINDOW.unsaved_title));
    window.click(en::WINDOW.cancel);
    assert_eq!(window.state().model.desk.shown.figure().camera.position.x, 1.0);
}

#[test]
fn recent_files_are_offered_and_missing_ones_are_marked() {
    let folder = Folder::new("recent");
    let [here, gone] = ["here.toml", "gone.toml"].map(|name| folder.file(name));
    let mut window = Window::new(Lang::En);
    for path in [&here, &gone] {
        fs::write(path, "# What it is about.\n[scene]\npreset = \"empty\"\n").expect("written");
        window.command_key(Key::O);
        window.choose(path);
    }
    fs::remove_file(&gone).expect("removed");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::O);
    window.run();
    assert_eq!(window.state().gallery.part, Part::Recent);
    window.wait_for("here.toml: What it is about.");
    window.wait_for("gone.toml no longer exists");
    let top = |label: &str| window.harness.get_by_label_contains(label).rect().left();
    assert!(top("here.toml: ") < top("gone.toml: "), "what is there comes first, although it was used before");
    // The frame stands on the one that is open.
    assert!(window.harness.get_by_label_contains("gone.toml: ").is_focused());
    window.key(Key::ArrowLeft);
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.path(), Some(&here));
}

#[test]
fn a_folder_shows_everything_that_opens_the_newest_first_and_names_errors() {
    let folder = Folder::new("folder");
    for (name, text) in [
        ("aula 10.toml", "[scene]\npreset = \"cube\"\n"),
        ("aula 9.toml", "# A nona aula.\n[camera]\nnear = 5\nfar = 2\n"),
    ] {
        fs::write(folder.file(name), text).expect("written");
    }
    fs::write(folder.file("notes.txt"), "no figure").expect("written");
    fs::write(folder.file("solid.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n").expect("written");
    fs::write(folder.file("mine.toml"), camera_lab::lessons::shipped()[0].text).expect("written");
    fs::write(folder.file("photograph.png"), include_bytes!("../../dist/icon.png")).expect("written");
    // The older, the later.
    for (days, name) in (0..).zip(["aula 9.toml", "solid.obj", "mine.toml", "aula 10.toml"]) {
        let file = fs::File::options().append(true).open(folder.file(name)).expect("a file");
        file.set_modified(std::time::SystemTime::now() - Duration::from_secs(86_400 * days)).expect("a time");
    }
    let mut window = Window::new(Lang::En);
    window.command_key(Key::G);
    window.harness.key_press_modifiers(Modifiers::CTRL, Key::Tab);
    window.run();
    window.harness.key_press_modifiers(Modifiers::CTRL, Key::Tab);
    window.run();
    window.click(en::GALLERY.choose);
    window.harness.get_by_label("file").focus();
    window.run();
    window.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    window.harness.event(Event::Text(folder.0.display().to_string()));
    window.run();
    window.key(Key::Enter);
    assert_eq!(window.state().file_flow.dialog, Some(Dialog::Gallery));
    window.wait_for("aula 9.toml: ");
    window.wait_for("near < far");
    // Its own description is there as well, without a picture.
    window.wait_for("A nona aula.");
    window.wait_for("aula 10.toml: ");
    window.wait_for("solid.obj: ");
    assert!(!window.says("notes: ") && !window.says("photograph: "));
    let place = |label: &str| {
        let place = window.harness.get_by_label_contains(label).rect().min;
        (place.y, place.x)
    };
    let lesson = format!("Lesson: {}", camera_lab::lessons::shipped()[0].lesson.title.en);
    let places = ["aula 9.toml: ", "solid.obj: ", &lesson, "aula 10.toml: "].map(place);
    assert!(places.is_sorted(), "{places:?}");
}
