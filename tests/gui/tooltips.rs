//! Tooltips: the hints when the pointer rests on something.

use camera_lab_words::Lang;
use camera_lab_words::window::texts;
use eframe::egui::{Key, Rect};

use super::window::Window;
use crate::words::en;

impl Window {
    /// The place of this text.
    fn place_of(&self, text: &str) -> Option<Rect> {
        self.written().into_iter().find(|(written, _)| written.contains(text)).map(|(_, place)| place)
    }

    /// Takes the pointer to a place and lets it rest there.
    fn rest_at(&mut self, place: Rect) {
        self.harness.hover_at(place.center());
        self.harness.run_steps(6);
    }
}

#[test]
fn a_field_that_is_greyed_says_why() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = Window::new(lang);
        let why = texts(lang).aspect_greyed.split('“').next().expect("a beginning").trim();
        assert!(window.place_of(why).is_none());
        window.rest_at(window.field("A").rect());
        assert!(window.place_of(why).is_some(), "{why}");
        window.app_mut().state.model.settings.aspect_follows_image = false;
        window.harness.run_steps(6);
        assert!(window.place_of(why).is_none());
        assert!(window.place_of("A = W / H").is_some(), "what it is");
        assert!(window.place_of("[0] P. Pagliosa").is_some(), "which notes these are");
    }
}

#[test]
fn the_hint_of_a_field_stands_beside_its_panel() {
    let mut window = Window::new(Lang::En);
    let hint = texts(Lang::En).number_field_hint;
    let panel = window.field("C z").rect();
    window.rest_at(window.field("C x").rect());
    let place = window.place_of(hint).expect("it is said");
    assert!(place.left() > panel.right(), "{place:?}");
    window.rest_at(window.field(en::WINDOW.digits).rect());
    let place = window.place_of(hint).expect("it is said");
    assert!(place.right() < window.field(en::WINDOW.digits).rect().left(), "{place:?}");
}

#[test]
fn the_value_of_an_expression_stands_beside_the_panel_over_no_row() {
    let mut window = Window::new(Lang::En);
    let panel = window.field("C z").rect();
    let row = window.field("F").rect();
    window.type_into("F", "1/3");
    let place = window.place_of("= 0.333").expect("its value");
    assert!(place.left() > panel.right(), "{place:?}");
    assert!((place.center().y - row.center().y).abs() < row.height(), "in its row: {place:?}, {row:?}");
}

#[test]
fn a_tooltip_waits_and_is_gone_once_a_dialog_is_open() {
    let mut window = Window::new(Lang::En);
    let hint = texts(Lang::En).number_field_hint;
    let field = window.field("F").rect();
    window.harness.hover_at(field.center());
    window.harness.step();
    assert!(window.place_of(hint).is_none(), "it comes after a delay");
    window.harness.run_steps(6);
    assert!(window.place_of(hint).is_some());
    window.command_key(Key::E);
    window.harness.run_steps(2);
    assert!(window.state().file_flow.dialog.is_some());
    assert!(window.place_of(hint).is_none(), "it stays behind the dialog");
    window.rest_at(field);
    assert!(window.place_of(hint).is_none(), "and comes no more");
}
