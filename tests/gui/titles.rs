//! Title and caption, typed in the window.

use std::fs;

use camera_lab::figure::Localized;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab_files::read_lesson;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable as _;

use super::files::Folder;
use super::window::Window;
use crate::words::en;

fn type_into(window: &mut Window, name: &str, text: &str) {
    window.harness.get_by_role_and_label(Role::TextInput, name).click();
    window.run();
    window.harness.event(Event::Text(text.to_owned()));
    window.run();
}

#[test]
fn title_and_caption_are_typed_in_one_language_or_in_both_and_undone() {
    let t = en::WINDOW;
    let mut window = Window::new(Lang::En);
    window.command_key(Key::I);
    type_into(&mut window, &format!("{}, {}", t.title_name, Lang::En.name()), "My camera");
    let caption = format!("{}, {}", t.caption_name, Lang::En.name());
    let field = window.harness.get_by_role_and_label(Role::MultilineTextInput, &caption);
    field.click();
    window.run();
    window.harness.event(Event::Text("What it sees".to_owned()));
    window.run();
    window.click(t.title_action);
    let figure = window.state().model.desk.shown.figure();
    let both = |text: &str| Some(Localized::from([text.to_owned(), text.to_owned()]));
    assert_eq!((figure.title.clone(), figure.caption.clone()), (both("My camera"), both("What it sees")));
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().title, None);
    window.command_key(Key::Y);
    // The other language of its own.
    window.command_key(Key::I);
    let portuguese = format!("{}, {}", t.title_name, Lang::PtBr.name());
    window.harness.get_by_role_and_label(Role::TextInput, &portuguese).click();
    window.run();
    window.command_key(Key::A);
    window.harness.event(Event::Text("Minha câmera".to_owned()));
    window.run();
    window.key(Key::Enter);
    let title = window.state().model.desk.shown.figure().title.clone();
    assert_eq!(title, Some(Localized::from(["My camera".to_owned(), "Minha câmera".to_owned()])));
}

/// A figure that was made of a card doesn't keep the card's words: saving it asks for its own.
#[test]
fn a_figure_made_of_a_card_has_words_of_its_own() {
    let t = en::WINDOW;
    let folder = Folder::new("titles");
    let mut window = Window::new(Lang::En);
    window.command_key(Key::G);
    window.wait_for("House: ");
    window.search_cards("mirror image");
    window.run();
    window.key(Key::ArrowDown);
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.shipped_name(), Some("house"));
    assert!(window.state().model.desk.shown.figure().title.is_some());
    window.enter("C x", "7");
    assert_eq!(window.state().model.figure_as_shown().title, None, "the card speaks of another figure");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::S);
    window.run();
    type_into(&mut window, &format!("{}, {}", t.title_name, Lang::En.name()), "Azimuth");
    let proposed = window.harness.get_by_role_and_label(Role::TextInput, t.title_file).value();
    assert_eq!(proposed.as_deref(), Some("azimuth.toml"));
    let file = folder.file("azimuth.toml");
    window.harness.get_by_role_and_label(Role::TextInput, t.title_file).click();
    window.run();
    window.command_key(Key::A);
    window.harness.event(Event::Text(file.display().to_string()));
    window.run();
    window.key(Key::Enter);
    window.wait(|_| file.exists());
    let text = fs::read_to_string(&file).expect("a figure");
    assert!(text.starts_with("title   = \"Azimuth\"") && !text.contains("caption"), "{text}");
}

/// From the gallery into the folder of the last file: open, save, title, Enter. For the values of a family: a click,
/// and Enter.
#[test]
fn a_figure_and_a_family_need_four_actions() {
    let t = en::WINDOW;
    let folder = Folder::new("titles-four");
    let mut window = Window::new(Lang::En);
    let last = folder.file("last.toml");
    window.command_key(Key::S);
    window.choose(&last);
    window.wait(|_| last.exists());
    window.command_key(Key::G);
    window.wait_for("House: ");
    window.search_cards("mirror image");
    window.run();
    window.key(Key::Enter);
    window.command_key(Key::S);
    window.harness.event(Event::Text("Azimuth 30".to_owned()));
    window.run();
    window.key(Key::Enter);
    let file = folder.file("azimuth-30.toml");
    window.wait(|_| file.exists());
    assert_eq!(
        window.state().model.desk.shown.figure().title.as_ref().map(|title| title.en.as_str()),
        Some("Azimuth 30")
    );
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::E);
    window.run();
    window.harness.event(Event::Text("30, 60".to_owned()));
    window.run();
    assert_eq!(window.state().family.first.values, "30, 60", "the values have the keyboard");
    window.click_in_dialog(t.azimuth);
    window.harness.event(Event::Text("10, 20".to_owned()));
    window.run();
    window.key(Key::Enter);
    let picture = folder.file("azimuths.png");
    window.choose(&picture);
    window.wait(|_| picture.exists());
    assert_eq!(window.state().family.last[0].values, "10, 20");
}

/// A name without a folder would land in the folder in which the program was started, so the system's dialog asks.
#[test]
fn without_a_folder_the_dialog_of_the_system_asks() {
    let t = en::WINDOW;
    let mut window = Window::new(Lang::En);
    window.app_mut().state.file_flow.native = true;
    window.command_key(Key::G);
    window.wait_for("House: ");
    window.search_cards("mirror image");
    window.run();
    window.key(Key::Enter);
    window.command_key(Key::S);
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Title(_))));
    assert!(window.harness.query_by_role_and_label(Role::TextInput, t.title_file).is_none());
    assert!(window.harness.query_by_role_and_label(Role::Button, t.save_as).is_some());
}

/// Gives the figure a title, in the place of the one that it has.
fn entitle(window: &mut Window, title: &str) {
    let t = en::WINDOW;
    window.command_key(Key::I);
    for language in [Lang::En.name(), Lang::PtBr.name()] {
        window.harness.get_by_role_and_label(Role::TextInput, &format!("{}, {language}", t.title_name)).click();
        window.run();
        window.command_key(Key::A);
        window.harness.event(Event::Text(title.to_owned()));
        window.run();
    }
    window.click(t.title_action);
}

fn alt(window: &mut Window, key: Key) {
    window.harness.key_press_modifiers(Modifiers::ALT, key);
    window.run();
}

/// A title is the recorded step's, and one that no step has is asked about.
#[test]
fn no_title_is_lost_on_the_way_into_a_lesson() {
    let folder = Folder::new("title-of-step");
    let path = folder.file("lesson.toml");
    let mut window = Window::new(Lang::En);
    let both = |text: &str| Localized::from([text.to_owned(), text.to_owned()]);
    entitle(&mut window, "My camera");
    window.harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::A);
    window.run();
    window.choose(&path);
    let title = |number: usize| read_lesson(&path).expect("a lesson").0.steps[number].title.clone();
    assert_eq!(title(0), both("My camera"));
    entitle(&mut window, "Another title");
    alt(&mut window, Key::R);
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Unsaved)), "no step has it");
    window.key(Key::Escape);
    entitle(&mut window, "My camera");
    alt(&mut window, Key::R);
    assert!(window.state().learn.writes_lesson(&window.state().model), "the step has it");
    // A title that is given in the step goes with its picture, and stays when the lesson is closed.
    entitle(&mut window, "From above");
    window.click(en::LESSONS.step_screen);
    assert_eq!(title(0), both("From above"));
    entitle(&mut window, "From below");
    alt(&mut window, Key::W);
    assert!(window.state().learn.lesson.is_none());
    assert_eq!(window.state().model.desk.shown.figure().title, Some(both("From below")));
    window.command_key(Key::N);
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Unsaved)));
}
