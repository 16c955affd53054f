//! Fields for text: a long pasted text is cut before it is laid out, and a message says so.

use std::fs;
use std::path::Path;

use camera_lab::figure::Explanation;
use camera_lab::gui::app::file_flow::questions::{Dialog, Purpose};
use camera_lab::limits::{MAX_EXPRESSION, MAX_TYPED, MAX_TYPED_NAME};
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::kittest::Queryable;

use super::window::Window;

/// A text that somebody may have on the clipboard.
fn a_whole_file() -> String {
    "Praça, 1.5 θ\n".repeat(10 << 17)
}

impl Window {
    /// Pastes a whole file into a text field, and returns the field's text then.
    fn paste_a_file_into(&mut self, name: &str) -> String {
        self.harness.get_by_role_and_label(Role::TextInput, name).focus();
        self.run();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.harness.event(Event::Paste(a_whole_file()));
        self.run();
        self.harness.get_by_role_and_label(Role::TextInput, name).value().unwrap_or_default()
    }
}

#[test]
fn a_long_text_in_a_number_field_is_cut_and_refused() {
    let mut window = Window::new(Lang::En);
    let before = window.state().model.desk.shown.draft().position.x;
    window.field("C x").click();
    window.run();
    window.harness.event(Event::Paste("1+".repeat(5 << 20)));
    window.run();
    assert!(window.says("the expression is too long"));
    let longest = window.written().into_iter().map(|(text, _)| text.chars().count()).max();
    assert!(longest <= Some(MAX_EXPRESSION.0 + 1), "{longest:?}");
    window.key(Key::Enter);
    assert!(window.says("the expression is too long"));
    assert_eq!(window.state().model.desk.shown.draft().position.x, before);
    window.key(Key::Escape);
    assert!(!window.says("the expression is too long"));
}

#[test]
fn a_long_text_in_any_other_field_is_cut_with_a_message() {
    let mut window = Window::new(Lang::En);
    window.app_mut().state.file_flow.dialog = Some(Dialog::Path(Purpose::Open, String::new()));
    window.run();
    assert_eq!(window.paste_a_file_into("file").chars().count(), MAX_TYPED);
    assert!(window.says(&format!("at most {MAX_TYPED} characters")));
    window.key(Key::Enter);
    assert!(matches!(window.state().file_flow.dialog, Some(Dialog::Path(..))), "refused, with a reason");
    window.key(Key::Escape);
    window.run();

    window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
    window.run();
    window.app_mut().state.model.explained.show(Explanation::Notes);
    window.run();
    assert_eq!(window.paste_a_file_into("Search the reference pages").chars().count(), MAX_TYPED_NAME);
    assert!(window.says(&format!("at most {MAX_TYPED_NAME} characters")));
    // A typed letter has no more room either, and deleting one makes some.
    window.key(Key::Backspace);
    assert!(!window.says("at most"));
    window.harness.event(Event::Text("ab".to_owned()));
    window.run();
    assert!(window.says(&format!("at most {MAX_TYPED_NAME} characters")));
}

/// Every file of the window but the one that has the fields.
fn sources(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("sources").flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.file_name().is_some_and(|name| name != "text_field.rs") {
            found.push((path.display().to_string(), fs::read_to_string(&path).expect("text")));
        }
    }
}

#[test]
fn no_field_takes_more_than_it_should() {
    let mut found = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/gui"), &mut found);
    assert!(found.len() > 100);
    for (path, text) in found {
        for raw in
            ["TextEdit::singleline", "TextEdit::multiline", "text_edit_singleline", "text_edit_multiline", "DragValue"]
        {
            assert!(!text.contains(raw), "{path} has a field of egui's own: {raw}");
        }
        // A slider has a field beside it unless its options say otherwise.
        for (at, _) in text.match_indices("Slider::new(") {
            let built = text[at..].split(';').next().unwrap_or_default();
            assert!(built.contains("show_value(false)"), "{path} has a field of egui's own: {built}");
        }
    }
}

#[test]
fn the_caret_blinks_while_somebody_types_and_rests_afterwards() {
    let mut window = Window::new(Lang::En);
    window.field("C x").click();
    window.run();
    window.harness.ctx.global_style_mut(|style| style.visuals.text_cursor.blink = true);
    let wakes = |window: &mut Window, seconds: f64| {
        let end = window.harness.ctx.input(|input| input.time) + seconds;
        while window.harness.ctx.input(|input| input.time) < end {
            window.harness.step();
        }
        window.harness.output().viewport_output[&eframe::egui::ViewportId::ROOT].repaint_delay
    };
    let half = std::time::Duration::from_millis(500);
    assert!(wakes(&mut window, 5.0) <= half, "it blinks");
    assert_eq!(wakes(&mut window, 6.0), std::time::Duration::MAX, "it rests");
    window.harness.key_press(Key::ArrowRight);
    assert!(wakes(&mut window, 1.0) <= half, "it blinks again");
}
