//! The menu at θ: the lens in other words.

use camera_lab::camera::{ImageSize, LensForm};
use camera_lab::figure::write::to_toml;
use camera_lab_words::Lang;
use camera_lab_words::window::lens::texts;

use super::window::Window;

fn window(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    window.app_mut().state.model.desk.shown.edit(|figure| figure.image = ImageSize { width: 1920, height: 1440 });
    window.run();
    window.click(texts(lang).lens);
    window
}

fn is_near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found}, expected {expected}");
}

#[test]
fn each_row_of_the_lens_is_typed() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut window = window(lang);
        let angle = |window: &Window| window.state().model.desk.shown.draft().view_angle;
        // 90° and 4 : 3: tan θ/2 is 3/4.
        window.enter(t.horizontal, "90");
        is_near(angle(&window), 2.0 * 0.75_f64.atan().to_degrees());
        assert_eq!(window.state().model.desk.shown.figure().lens, Some(LensForm::HorizontalAngle(90.0)));
        // Half of the diagonal is 5/3 of half of the height.
        window.enter(t.diagonal, "90");
        is_near(angle(&window), 2.0 * 0.6_f64.atan().to_degrees());
        window.enter(t.vertical, "60");
        is_near(angle(&window), 60.0);
        // 36 mm behind 18 mm: 45° to each side.
        window.enter(t.focal_length, "18");
        is_near(angle(&window), 2.0 * 0.75_f64.atan().to_degrees());
        assert!(to_toml(window.state().model.desk.shown.figure()).contains("lens = { focal_length = 18.0"));
        // As long as the image is high.
        window.enter("f_y", "1440");
        is_near(angle(&window), 2.0 * 0.5_f64.atan().to_degrees());
    }
}

#[test]
fn a_shift_frees_the_window() {
    let t = texts(Lang::En);
    let mut window = window(Lang::En);
    let (width, height) = {
        let camera = window.state().model.desk.shown.camera();
        (camera.window_width(), camera.window_height())
    };
    window.enter(&format!("{} x", t.shift), "0.25");
    let moved = window.state().model.desk.shown.draft().window.expect("a free window");
    is_near(moved.left, -width / 4.0);
    is_near(moved.right, 3.0 * width / 4.0);
    is_near(moved.top, height / 2.0);
}

#[test]
fn the_panel_shows_the_size_of_the_view_at_a_distance() {
    let t = texts(Lang::En);
    let mut window = window(Lang::En);
    window.enter(t.vertical, "90");
    window.enter(t.distance, "10");
    assert!(window.says("26.667 × 20"), "H is 2 · 10 · tan 45°");
}
