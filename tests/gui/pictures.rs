//! Whole windows against pictures that were looked at. `UPDATE_IMAGES=1` renews them.

use std::fs::File;
use std::path::PathBuf;
use std::time::Duration;

use camera_lab::appearance::{Samples, Theme};
use camera_lab::gui::{Start, State};
use camera_lab::scene::Preset;
use camera_lab_words::Lang;
use eframe::egui::Key;
use image::RgbaImage;

use super::window::Window;
use crate::words::{en, pt};

/// The last bits of letters depend on the processor. Nothing that one could see is less than this.
const TOLERANCE: u8 = 2;

fn assert_window(name: &str, window: &mut Window) {
    window.harness.remove_cursor();
    window.run();
    window.app_mut().state.model.coach.take(Duration::from_secs(60));
    window.run();
    let actual = window.harness.render().expect("a picture");
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/images/window");
    let path = folder.join(format!("{name}.png"));
    if std::env::var_os("UPDATE_IMAGES").is_some() {
        write(&path, &actual);
        return;
    }
    let expected = image::open(&path).expect("a reference picture").to_rgba8();
    assert_eq!(expected.dimensions(), actual.dimensions());
    let differs =
        |a: &image::Rgba<u8>, b: &image::Rgba<u8>| a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > TOLERANCE);
    let count = expected.pixels().zip(actual.pixels()).filter(|(a, b)| differs(a, b)).count();
    if count > 0 {
        let new = folder.join(format!("{name}.new.png"));
        write(&new, &actual);
        panic!("{count} pixels of {name} differ; look at {}", new.display());
    }
}

/// Every colour as it is.
pub(super) fn write(path: &PathBuf, picture: &RgbaImage) {
    let mut encoder = png::Encoder::new(File::create(path).expect("a file"), picture.width(), picture.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    let pixels: Vec<u8> = picture.pixels().flat_map(|p| [p[0], p[1], p[2]]).collect();
    encoder.write_header().and_then(|mut writer| writer.write_image_data(&pixels)).expect("written");
}

/// The window that one sees first.
fn first(lang: Lang, theme: Theme, size: [f32; 2]) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.style.antialias = Samples::One;
    figure.scene.preset = Preset::Cube;
    let mut state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
        .expect("a possible camera");
    state.model.settings.theme = theme;
    state.file_flow.native = false;
    Window::with_state(state, size)
}

#[test]
fn first_look_in_english() {
    assert_window("english", &mut first(Lang::En, Theme::Light, [1120.0, 640.0]));
}

#[test]
fn first_look_in_portuguese_and_dark() {
    assert_window("portuguese_dark", &mut first(Lang::PtBr, Theme::Dark, [1120.0, 640.0]));
}

#[test]
fn a_problem_and_its_repairs_in_a_narrow_window() {
    let mut window = first(Lang::PtBr, Theme::Light, [640.0, 560.0]);
    window.enter("F", "20");
    // The camera check knows it too.
    window.app_mut().state.model.coach.take(Duration::from_secs(60));
    window.run();
    assert_window("problem", &mut window);
}

#[test]
fn the_tree_of_the_scene_and_an_object_with_its_arrows() {
    let mut window = first(Lang::PtBr, Theme::Light, [1120.0, 640.0]);
    window.key(Key::F6);
    window.click(pt::SCENES.edit_copy);
    window.click("Adicionar");
    window.click(en::SCENES.shape_cone);
    window.run();
    window.enter("translação x", "2");
    assert_window("scene", &mut window);
}

#[test]
fn changes_that_have_not_been_saved() {
    let mut window = Window::new(Lang::PtBr);
    window.harness.set_size([640.0, 400.0].into());
    window.run();
    window.enter("C x", "1");
    window.command_key(Key::N);
    assert_window("unsaved", &mut window);
}
