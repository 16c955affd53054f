//! Menus, keys, presentation, and a window that is left alone.

use camera_lab::appearance::Theme;
use camera_lab::gui::command::Command;
use camera_lab::gui::state::{ObserverChange, Side};
use camera_lab::i18n::Lang;
use camera_lab::i18n::window::texts;
use camera_lab::views::View;
use camera_lab::views::observer::Viewpoint;
use eframe::egui::{self, Key, Modifiers};

use super::window::Window;

#[test]
fn every_command_stands_in_a_menu_with_its_keys() {
    let mut window = Window::new(Lang::En);
    let t = texts(Lang::En);
    for (menu, commands) in
        [("File", &Command::FILE[..]), ("Edit", &Command::EDIT), ("View", &Command::VIEW), ("Help", &Command::HELP)]
    {
        window.click(menu);
        for command in commands {
            assert!(window.says(command.label(t)), "{command:?}");
            assert!(window.says(&window.harness.ctx.format_shortcut(&command.shortcut())), "{command:?}");
        }
        window.key(Key::Escape);
    }
}

#[test]
fn presentation_enlarges_everything_and_gives_the_room_to_the_pictures() {
    let mut window = Window::new(Lang::En);
    assert_eq!(window.state().settings.stroke_scale(), 1.0);
    window.key(Key::F11);
    assert!(window.state().settings.stroke_scale() > 1.0);
    assert!(window.harness.ctx.zoom_factor() > 1.5);
    assert!(!window.says("C, VUP about u through PF"));
    window.key(Key::F9);
    assert!(window.says("C, VUP about u through PF"));
    window.key(Key::F11);
    assert_eq!(window.harness.ctx.zoom_factor(), 1.0);
    assert!(window.says("C, VUP about u through PF") && window.says("view angle"));
}

#[test]
fn the_interface_grows_and_shrinks() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::Plus);
    window.command_key(Key::Equals);
    assert!((window.harness.ctx.zoom_factor() - 1.2).abs() < 1e-6);
    window.command_key(Key::Minus);
    assert!((window.harness.ctx.zoom_factor() - 1.1).abs() < 1e-6);
    window.command_key(Key::Num0);
    assert_eq!(window.harness.ctx.zoom_factor(), 1.0);
}

#[test]
fn a_narrow_window_has_room_for_one_panel() {
    let mut window = Window::new(Lang::En);
    window.harness.set_size([800.0, 600.0].into());
    window.run();
    let shown = |window: &Window| [Side::Left, Side::Right].map(|side| window.state().settings.panels().is_shown(side));
    assert_eq!(shown(&window), [true, false]);
    window.key(Key::F9);
    assert_eq!(shown(&window), [false, true]);
    window.key(Key::F8);
    assert_eq!(shown(&window), [true, false]);
    window.key(Key::F8);
    assert_eq!(shown(&window), [false, true]);
    window.key(Key::F9);
    assert_eq!(shown(&window), [false, false]);
}

#[test]
fn the_theme_is_that_of_the_pictures_and_of_the_window() {
    let mut window = Window::new(Lang::En);
    assert_eq!(window.harness.ctx.theme(), egui::Theme::Light);
    window.command_key(Key::T);
    assert_eq!(window.state().document.figure().style.theme, Theme::Dark);
    assert_eq!(window.harness.ctx.theme(), egui::Theme::Dark);
    window.command_key(Key::Z);
    assert_eq!(window.harness.ctx.theme(), egui::Theme::Light);
}

#[test]
fn pictures_are_hidden_and_shown_and_looked_at() {
    let mut window = Window::new(Lang::En);
    window.command_key(Key::Num1);
    assert!(window.state().layout.is_shown(View::World));
    window.command_key(Key::Num1);
    assert!(!window.state().layout.is_shown(View::World));
    // The last one stays.
    window.command_key(Key::Num3);
    assert!(window.state().layout.is_shown(View::Image));
    window.command_key(Key::Num1);
    window.harness.key_press_modifiers(Modifiers::ALT, Key::Num2);
    window.run();
    let observers = window.state().document.figure().observers;
    assert_eq!(
        observers.world.map(|observer| observer.elevation),
        Some(90.0),
        "{:?}",
        ObserverChange::From(Viewpoint::Top)
    );
    // Looking from somewhere else is no change of the figure.
    assert!(!window.state().document.is_changed() && !window.state().document.can_undo());
}

#[test]
fn a_window_that_is_left_alone_does_not_repaint() {
    let mut window = Window::new(Lang::En);
    window.enter("C x", "2");
    window.harness.remove_cursor();
    window.run();
    for _ in 0..3 {
        window.harness.step();
        let delay = window.harness.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay;
        assert_eq!(delay, std::time::Duration::MAX);
    }
}

#[test]
fn help_lists_the_keys() {
    let mut window = Window::new(Lang::PtBr);
    window.key(Key::F1);
    assert!(window.says("Mouse e teclado") && window.says("Ctrl+Shift+S"));
    window.click("Fechar");
    assert_eq!(window.state().file_flow.dialog, None);
    assert!(!window.says("Ctrl+Shift+S"));
}
