//! Whole windows, drawn by the small painter: what has moved, vanished or lost its words shows here.

use camera_lab::appearance::Theme;
use camera_lab::gui::{Start, State};
use camera_lab::i18n::Lang;
use camera_lab::scene::Preset;
use egui_kittest::SnapshotOptions;

use super::window::Window;

fn picture(name: &str, lang: Lang, theme: Theme, change: impl FnOnce(&mut Window)) {
    let mut figure = camera_lab::gui::fresh();
    figure.scene.preset = Preset::Cube;
    figure.style.theme = theme;
    figure.style.antialias = 1;
    let mut state = State::new(Start { figure, file: None, lang }).expect("a possible camera");
    state.filing.native = false;
    let mut window = Window::with_state(state, [1100.0, 640.0]);
    change(&mut window);
    window.run();
    // Letters are drawn with what the processor offers: another one may differ by a last bit here and there.
    let options = SnapshotOptions::new().output_path("tests/images/window").max_failed_pixels(60);
    window.harness.snapshot_options(name, &options);
}

#[test]
fn the_window_in_english() {
    picture("english", Lang::En, Theme::Light, |_| {});
}

#[test]
fn the_window_in_portuguese_on_a_dark_ground() {
    picture("portuguese_dark", Lang::PtBr, Theme::Dark, |_| {});
}

#[test]
fn an_impossible_value_with_its_reason_and_repairs() {
    picture("problem", Lang::PtBr, Theme::Light, |window| window.enter("F", "500"));
}
