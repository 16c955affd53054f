//! The section "Inside the pipeline": what it shows in the pictures, and the numbers under the pointer.

use camera_lab::appearance::Rgba;
use camera_lab::camera::Parameters;
use camera_lab::figure::Depth;
use camera_lab::gui::state::Picture;
use camera_lab::gui::{Start, State};
use camera_lab::i18n::Lang;
use camera_lab::scene::Preset;
use eframe::egui::{Key, Pos2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;

use super::window::Window;

/// A window high enough for the whole panel, on whose image a camera at (0, 0, 5) sees the cube, with F = 2 and B = 8.
fn window(lang: Lang, picture: Picture) -> Window {
    let mut figure = camera_lab::gui::fresh();
    figure.scene.preset = Preset::Cube;
    figure.camera = Parameters { position: DVec3::Z * 5.0, near: 2.0, far: 8.0, ..Parameters::default() };
    figure.style.antialias = 1;
    let mut state = State::new(Start { figure, file: None, lang }).expect("a possible camera");
    state.layout.maximized = Some(picture);
    Window::with_state(state, [760.0, 1200.0])
}

/// The middle of the one picture.
fn middle(window: &Window, label: &str) -> Pos2 {
    window.harness.get_by_label_contains(label).rect().center()
}

fn pixel(window: &mut Window, at: Pos2) -> Rgba {
    let image = window.harness.render().expect("a painter");
    let [r, g, b, a] = image.get_pixel(at.x as u32, at.y as u32).0;
    Rgba::rgba(r, g, b, a)
}

/// Takes an entry of a choice.
fn choose(window: &mut Window, choice: &str, entry: &str) {
    let role = eframe::egui::accesskit::Role::ComboBox;
    window.harness.get_by_role_and_label(role, choice).click();
    window.run();
    window.click(entry);
}

#[test]
fn the_depth_buffer_is_shown_with_its_numbers_and_undone() {
    let mut window = window(Lang::En, Picture::Image);
    window.key(Key::F7);
    let at = middle(&window, "Image: what");
    // Beside the lines that cross at the pointer, and the probe's own mark.
    let beside = at + eframe::egui::vec2(30.0, 30.0);
    let color = pixel(&mut window, beside);
    assert!(color.r != color.g || color.g != color.b, "{color}");
    choose(&mut window, "image", "depths (Z)");
    assert_eq!(window.state().document.figure().reveal.depth, Depth::Stored);
    // z = 1 is 4 units away: Z = (1/3 + 1)/2 = 2/3, and 2/3 of 255 is 170.
    assert_eq!(pixel(&mut window, beside), Rgba::rgb(170, 170, 170));
    window.harness.hover_at(at);
    window.run();
    assert!(window.says("Depth Z = 0.666667") && window.says("−z_c = 4"));
    window.harness.hover_at(at + eframe::egui::vec2(-250.0, -150.0));
    window.run();
    assert!(window.says("Depth nothing here"));
    window.command_key(Key::Z);
    assert_eq!(window.state().document.figure().reveal.depth, Depth::Off);
}

#[test]
fn the_section_speaks_portuguese() {
    let mut window = window(Lang::PtBr, Picture::Image);
    window.key(Key::F7);
    choose(&mut window, "imagem", "distâncias");
    assert_eq!(window.state().document.figure().reveal.depth, Depth::Linear);
    let at = middle(&window, "Imagem: o que");
    window.harness.hover_at(at);
    window.run();
    assert!(window.says("Profundidade Z = 0.666667") && window.says("Distância −z_c = 4"));
}
