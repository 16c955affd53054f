//! The tab of stages: the image as far as it is painted.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::appearance::{FaceOrder, Samples, Visibility};
use camera_lab::figure::{CostReveal, Explanation};
use camera_lab::gui::{Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_words::Lang;
use camera_lab_words::why::stages::texts;
use camera_lab_words::window::canvas;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::Queryable as _;

use super::window::Window;

fn staged(lang: Lang) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Cube;
    figure.style.antialias = Samples::One;
    let mut state =
        State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
    state.model.layout.maximized = Some(View::Image);
    let mut window = Window::with_state(state, [1000.0, 900.0]);
    window.explain(Explanation::HiddenSurfaces);
    window
}

#[test]
fn the_image_is_painted_triangle_by_triangle_while_the_tab_is_shown() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut window = staged(lang);
        assert_eq!(window.state().model.painted_share(), None, "at first all is painted");
        window.click(t.nothing);
        assert_eq!(window.state().model.painted_share(), Some(0.0));
        let drawn = window.app_mut().canvas.drawn()[View::Image.index()];
        window.click(t.more);
        assert!(window.state().model.painted_share().unwrap() > 0.0);
        assert!(window.app_mut().canvas.drawn()[View::Image.index()] > drawn, "the picture follows");
        // The slider has keys of its own.
        let before = window.state().model.painted_share().unwrap();
        window.harness.get_by_label(t.scrubber).focus();
        window.run();
        window.key(Key::ArrowRight);
        assert!(window.state().model.painted_share().unwrap() > before);
        window.click(t.all);
        assert_eq!(window.state().model.painted_share(), None);
        window.click(t.fewer);
        assert!(window.state().model.painted_share().is_some());
        // Hidden, it changes no picture.
        window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
        window.run();
        assert_eq!(window.state().model.painted_share(), None);
    }
}

#[test]
fn the_ways_to_hide_are_the_figures_and_say_their_order() {
    let mut window = staged(Lang::En);
    let t = texts(Lang::En);
    for (name, visibility, said) in [
        (t.painter, Visibility::Painter, t.painter_said),
        (t.bsp, Visibility::Bsp, t.bsp_said),
        (t.depth_buffer, Visibility::DepthBuffer, t.depth_buffer_said),
    ] {
        window.click(name);
        assert_eq!(window.state().model.desk.shown.figure().style.visibility, visibility);
        assert!(window.says(said));
    }
    window.click(t.depth);
    assert_eq!(window.state().model.desk.shown.figure().reveal.depth, camera_lab::figure::Depth::Stored);
}

/// The cube hides nothing but its own back, so its faces need no order.
#[test]
fn the_cost_of_pixels_is_chosen_among_the_stages_and_told_at_the_pointer() {
    for lang in [Lang::En, Lang::PtBr] {
        let (t, labels) = (texts(lang), camera_lab_words::pictures::labels(lang));
        let mut window = staged(lang);
        window.explain(Explanation::Stages);
        window.harness.get_by_role_and_label(Role::ComboBox, t.costs).click();
        window.run();
        window.click(labels.costs[1]);
        assert_eq!(window.state().model.desk.shown.figure().reveal.cost, Some(CostReveal::Overdraw));
        window.harness.get_by_role_and_label(Role::ComboBox, t.order).click();
        window.run();
        window.click(labels.face_orders[1]);
        assert_eq!(window.state().model.desk.shown.figure().style.order, FaceOrder::FrontToBack);
        window.wait(|window| window.says(t.point_there));
        let share = if lang == Lang::En { "0 % of the fills were painted over." } else { "0 % dos preenchimentos" };
        assert!(window.written().iter().any(|(text, _)| text.starts_with(share)), "{:?}", window.written());
        let image = window.harness.get_by_role_and_label(Role::Image, &described(&window, lang)).rect();
        window.harness.hover_at(image.center());
        window.run();
        assert!(window.says(t.at_pixel), "{:?}", window.written());
        assert!(window.written().iter().any(|(text, _)| text.starts_with("1. ")), "{:?}", window.written());
        // The sky, in the upper left corner of the image that the view has in its middle.
        let side = image.height().min(image.width() * 0.75);
        window.harness.hover_at(image.center() - vec2(0.5, 0.4) * side);
        window.run();
        assert!(window.says(t.no_faces), "{:?}", window.written());
    }
}

/// The description of the image.
fn described(window: &Window, lang: Lang) -> String {
    let shown = &window.state().model.desk.shown;
    canvas::describe(lang, View::Image, shown.camera(), shown.figure().image)
}
