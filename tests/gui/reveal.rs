//! The inner work of the pipeline: its marks in the pictures, and the numbers under the pointer.

use camera_lab::appearance::{Rgba, Samples, Visibility};
use camera_lab::camera::Parameters;
use camera_lab::figure::{Depth, Explanation, Figure, Observer, Outside, Reveal};
use camera_lab::gui::{Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_words::Lang;
use eframe::egui::{Key, Pos2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;

use super::window::Window;
use crate::words::en;

/// A window on whose image a camera at (0, 0, 5) sees the cube, with F = 2 and B = 8.
fn window(lang: Lang, picture: View) -> Window {
    window_with(lang, picture, [900.0, 700.0], |_| ())
}

fn window_with(lang: Lang, picture: View, size: [f32; 2], change: impl FnOnce(&mut Figure)) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Cube;
    figure.camera = Parameters { position: DVec3::Z * 5.0, near: 2.0, far: 8.0, ..Parameters::default() };
    figure.style.antialias = Samples::One;
    figure.observers.world = Some(Observer {
        target: DVec3::ZERO,
        distance: 9.0,
        azimuth: 20.0,
        elevation: 15.0,
        roll: 0.0,
        parallel: false,
    });
    change(&mut figure);
    let mut state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
        .expect("a possible camera");
    state.model.layout.maximized = Some(picture);
    Window::with_state(state, size)
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
fn the_way_of_finding_hidden_faces_is_chosen_and_undone() {
    let mut window = window(Lang::En, View::Image);
    window.explain(Explanation::HiddenSurfaces);
    window.click(en::STAGES.painter);
    assert_eq!(window.state().model.desk.shown.figure().style.visibility, Visibility::Painter);
    window.click(en::STAGES.bsp);
    assert_eq!(window.state().model.desk.shown.figure().style.visibility, Visibility::Bsp);
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().style.visibility, Visibility::Painter);
}

#[test]
fn the_depth_buffer_is_shown_with_its_numbers_and_undone() {
    let mut window = window(Lang::En, View::Image);
    window.explain(Explanation::Depth);
    let at = middle(&window, "Image: what");
    // Beside the lines that cross at the pointer, and the probe's own mark.
    let beside = at + eframe::egui::vec2(30.0, 30.0);
    let color = pixel(&mut window, beside);
    assert!(color.r != color.g || color.g != color.b, "{color}");
    choose(&mut window, "image", "depths (Z)");
    assert_eq!(window.state().model.desk.shown.figure().reveal.depth, Depth::Stored);
    // z = 1 is 4 units away: Z = (1/3 + 1)/2 = 2/3, and 2/3 of 255 is 170.
    assert_eq!(pixel(&mut window, beside), Rgba::rgb(170, 170, 170));
    window.harness.hover_at(at);
    window.run();
    assert!(window.says("Depth Z = 0.666667") && window.says("−z_c = 4"));
    window.harness.hover_at(at + eframe::egui::vec2(-150.0, -110.0));
    window.run();
    assert!(window.says("Depth nothing here"));
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().reveal.depth, Depth::Off);
}

#[test]
fn the_section_speaks_portuguese() {
    let mut window = window(Lang::PtBr, View::Image);
    window.explain(Explanation::Depth);
    choose(&mut window, "imagem", "distâncias");
    assert_eq!(window.state().model.desk.shown.figure().reveal.depth, Depth::Linear);
    let at = middle(&window, "Imagem: o que");
    window.harness.hover_at(at);
    window.run();
    assert!(window.says("Profundidade Z = 0,666667") && window.says("Distância −z_c = 4"));
}

#[test]
fn each_switch_shows_something_and_is_undone() {
    let mut window = window_with(Lang::En, View::World, [900.0, 700.0], |_| ());
    for (explanation, switch, reveal) in [
        (Explanation::HiddenSurfaces, "Culled parts", Reveal { culled: true, ..Reveal::default() }),
        (Explanation::Clipping, "Clipping vertices", Reveal { clipping: true, ..Reveal::default() }),
        (Explanation::Clipping, "Divide before clipping", Reveal { divide_first: true, ..Reveal::default() }),
    ] {
        window.explain(explanation);
        let drawn = window.app_mut().canvas.drawn()[0];
        window.click(switch);
        assert_eq!(window.state().model.desk.shown.figure().reveal, reveal);
        assert!(window.app_mut().canvas.drawn()[0] > drawn, "{switch}");
        window.command_key(Key::Z);
        assert_eq!(window.state().model.desk.shown.figure().reveal, Reveal::default());
    }
    choose(&mut window, "outside", "tinted");
    assert_eq!(window.state().model.desk.shown.figure().reveal.outside, Outside::Tinted);
}

#[test]
fn a_vertex_says_its_outcode_and_its_distances() {
    for (lang, switch, planes, place, distances) in [
        (Lang::En, "Clipping vertices", "Outcode 000010 near", "(0, 0, 5)", "w + z, w − z −2.286, 10.29"),
        (Lang::PtBr, "Vértices do recorte", "Outcode 000010 frente", "(0; 0; 5)", "w + z, w − z −2,286; 10,29"),
    ] {
        // F = 4.5: the corner (1, 1, 1), 4 units before C, is cut off. Seen from the front it lies to the right of the
        // middle.
        let mut window = window_with(lang, View::World, [1280.0, 720.0], |figure| figure.camera.near = 4.5);
        window.explain(Explanation::Clipping);
        window.click(switch);
        let corner = {
            let state = window.state();
            let rect = window.harness.get_by_label_contains(place).rect();
            let observer = state.model.desk.shown.figure().observers.world.expect("it was given");
            let camera =
                observer.camera(None, f64::from(rect.width()) / f64::from(rect.height())).expect("an observer");
            let clip = camera.clip_from_world() * DVec3::ONE.extend(1.0);
            let share = (clip.truncate() / clip.w).truncate();
            rect.center()
                + eframe::egui::vec2(share.x as f32 * rect.width() / 2.0, -share.y as f32 * rect.height() / 2.0)
        };
        window.harness.hover_at(corner);
        window.run();
        assert!(window.says(planes));
        // w = 4 and w + z = 2 B (d − F)/(B − F) = 16 · (−0.5)/3.5; w − z = 2 F (B − d)/(B − F) = 9 · 4/3.5.
        assert!(window.says(distances));
    }
}
