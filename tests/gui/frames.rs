//! The area that a frame of the window has to paint: in software each pixel that is painted once more takes its time.

use camera_lab::appearance::{Samples, Theme};
use camera_lab::gui::{self, App, LaunchOptions, Start, State};
use camera_lab::scene::Preset;
use eframe::egui;

use super::files::Folder;
use super::overdraw::painted;
use super::window::Window;

const SIZE: [f32; 2] = [1280.0, 800.0];

/// The three pictures with both panels.
fn window(theme: Theme) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Empty;
    figure.style.antialias = Samples::One;
    let mut state = State::new(Start { figure, ..Start::default() }).expect("a possible camera");
    state.model.settings.theme = theme;
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

#[test]
fn with_a_stored_zoom_the_first_pictures_are_no_larger_than_the_window() {
    let folder = Folder::new("zoom");
    std::fs::write(folder.file("preferences.toml"), "zoom = 0.8\n").expect("written");
    let ctx = egui::Context::default();
    let mut app = App::new(&ctx, State::new(Start::default()).expect("a camera"));
    app.keep_preferences(&ctx, &folder.0, LaunchOptions::default());
    let points = gui::DEFAULT_SIZE.map(|side| side / 0.8);
    let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, points.into());
    let input = egui::RawInput { screen_rect: Some(screen), ..egui::RawInput::default() };
    let mut output = ctx.run_ui(input, |ui| app.show(ui));
    output.textures_delta.clear();
    assert_eq!(ctx.content_rect(), screen);
    let [width, height] = gui::DEFAULT_SIZE.map(|side| side as u32);
    assert!(app.state.model.frame.picture_sizes.iter().all(|size| size[0] <= width && size[1] <= height));
}
