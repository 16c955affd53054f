//! What a frame of the window has to paint: in software each pixel that is painted once more takes its time.

use camera_lab::appearance::Theme;
use camera_lab::gui::{self, Start, State};
use camera_lab::scene::Preset;

use super::overdraw::painted;
use super::window::Window;

const SIZE: [f32; 2] = [1280.0, 800.0];

/// The three pictures with both panels.
fn window(theme: Theme) -> Window {
    let mut figure = gui::fresh();
    figure.scene.preset = Preset::Empty;
    figure.style.antialias = 1;
    let mut state = State::new(Start { figure, ..Start::default() }).expect("a possible camera");
    state.settings.theme = theme;
    Window::with_state(state, SIZE)
}

#[test]
fn most_pixels_are_painted_once() {
    let window = window(Theme::Light);
    let output = window.harness.output();
    let primitives = window.harness.ctx.tessellate(output.shapes.clone(), output.pixels_per_point);
    let layers = painted(&primitives) / (SIZE[0] * SIZE[1]);
    assert!((0.8..1.25).contains(&layers), "{layers}");
}

#[test]
fn a_frame_begins_with_the_colour_of_the_panels() {
    for theme in [Theme::Light, Theme::Dark] {
        let mut window = window(theme);
        let visuals = window.harness.ctx.global_style().visuals.clone();
        assert_eq!(visuals.dark_mode, theme == Theme::Dark);
        let [r, g, b, a] = eframe::App::clear_color(window.app_mut(), &visuals);
        assert_eq!([r, g, b, a], visuals.panel_fill.to_normalized_gamma_f32());
        assert_eq!(a, 1.0);
    }
}
