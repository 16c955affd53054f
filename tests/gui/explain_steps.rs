//! The way from the world to the canonical volume, by the scrubber and by keyboard.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;

use camera_lab::camera::{Decomposition, Parameters, ViewWindow};
use camera_lab::figure::Explanation;
use camera_lab::views::View;
use camera_lab_words::Lang;
use camera_lab_words::why::explain::texts;
use camera_lab_words::window::canvas;
use eframe::egui::{Key, Modifiers, Rect};
use egui_kittest::kittest::{NodeT, Queryable};

use super::files::Folder;
use super::window::Window;

fn stepping(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    window.app_mut().state.model.layout.maximized = Some(View::Canonical);
    window.explain(Explanation::Steps);
    window
}

fn time(window: &Window) -> f64 {
    window.state().model.normalizing().expect("a way").time
}

#[test]
fn the_scrubber_steps_by_keyboard_and_its_end_is_the_canonical_picture() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut window = stepping(lang);
        assert_eq!(time(&window), 4.0, "the tab opens at the end: T, R, M_p, ÷ w");
        let at_the_end = window.app_mut().canvas.drawn();
        assert!(!window.state().model.is_on_the_way());
        window.harness.get_by_label(t.to_world).focus();
        window.run();
        window.key(Key::Enter);
        assert_eq!(time(&window), 0.0);
        assert!(window.state().model.is_on_the_way() && window.says(t.nothing_done));
        assert!(window.app_mut().canvas.drawn()[View::Canonical.index()] > at_the_end[View::Canonical.index()]);
        for step in 1..=4 {
            window.harness.get_by_label(t.step_forward).focus();
            window.run();
            window.key(Key::Enter);
            assert_eq!(time(&window), f64::from(step));
        }
        let way = window.state().model.normalizing().expect("a way");
        assert_eq!((way.decomposition, way.time), (Decomposition::Notes, 4.0));
        assert!(!window.state().model.is_on_the_way(), "things can be picked again");
        window.click(t.step_back);
        assert_eq!(time(&window), 3.0);
        // Its own keys move the slider by tenths, and with Ctrl to whole steps.
        window.harness.get_by_label(t.scrubber).focus();
        window.run();
        window.key(Key::ArrowLeft);
        assert!((time(&window) - 2.9).abs() < 1e-12, "{}", time(&window));
        window.key(Key::ArrowLeft);
        assert!((time(&window) - 2.8).abs() < 1e-12);
        window.command_key(Key::ArrowLeft);
        assert_eq!(time(&window), 2.0, "the previous or next whole step");
        window.command_key(Key::ArrowLeft);
        assert_eq!(time(&window), 1.0);
        window.key(Key::ArrowRight);
        assert!((time(&window) - 1.1).abs() < 1e-12);
        window.command_key(Key::ArrowRight);
        assert_eq!(time(&window), 2.0);
        for _ in 0..3 {
            window.command_key(Key::ArrowRight);
        }
        assert_eq!(time(&window), 4.0, "not beyond its end");
        // Elsewhere the keys are not its own.
        window.harness.get_by_label(t.step_back).focus();
        window.run();
        window.command_key(Key::ArrowLeft);
        assert_eq!(time(&window), 4.0);
        // Hidden, it changes no picture.
        window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
        window.run();
        assert!(window.state().model.normalizing().is_none() && !window.state().model.is_on_the_way());
    }
}

#[test]
fn playing_ends_at_the_canonical_volume_and_then_nothing_moves() {
    let mut window = stepping(Lang::En);
    window.harness.get_by_label(texts(Lang::En).play).click();
    window.harness.step();
    assert!(window.state().model.explained.steps.plays());
    for _ in 0..1000 {
        if !window.state().model.explained.steps.plays() {
            break;
        }
        window.harness.step();
    }
    assert_eq!(time(&window), 4.0);
    window.run();
    let delay = window.harness.output().viewport_output.values().map(|output| output.repaint_delay).min();
    assert!(delay.is_some_and(|delay| delay.as_secs() > 5), "idle: {delay:?}");
}

#[test]
fn the_product_is_compared_and_handedness_announced() {
    let mut window = stepping(Lang::PtBr);
    assert!(window.says("O produto de todos os passos é M_p M_v"));
    assert!(window.says("daqui em diante, mão esquerda"));
    window.click("[2] S T P");
    // P is over F.
    assert!(window.says("O produto de todos os passos é 1") || window.says("O produto de todos os passos é 0"));
    window.click("[3] M_P N");
    assert_eq!(window.state().model.explained.steps.way, Decomposition::Normalised);
    assert!(window.says("z_n de 0 a 1"));
    // With a free window, [1] and [3] have no steps: they are greyed, and the reason is in their place.
    let document = &mut window.app_mut().state.model.desk.shown;
    let free = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    document.set_parameters(Parameters { window: free, ..*document.draft() });
    window.run();
    assert!(window.says("só com janela simétrica"));
    assert!(window.state().model.normalizing().is_none());
    assert!(window.harness.get_by_label("[3] M_P N").accesskit_node().is_disabled());
    window.click("[0] M_p M_v, ÷ w");
    assert!(window.says("O produto de todos os passos é M_p M_v"));
}

/// (`animate` is the same code with other arguments, and its animations are decoded in its own tests.)
#[test]
fn the_way_is_exported_beside_the_window() {
    let folder = Folder::new("film");
    let mut window = stepping(Lang::En);
    window.app_mut().state.file_flow.native = false;
    window.click(texts(Lang::En).film);
    let strip = folder.file("strip.png");
    window.choose(&strip);
    window.wait_until(|_| strip.exists().then_some(()));
    let reader = png::Decoder::new(std::io::Cursor::new(fs::read(&strip).unwrap())).read_info().unwrap();
    // The world and four steps, with gaps.
    assert_eq!((reader.info().width, reader.info().height), (5 * 640 + 4 * 4, 480));
}

#[test]
fn the_way_is_played_in_the_largest_picture_under_a_title_of_its_own() {
    for lang in [Lang::En, Lang::PtBr] {
        let words = canvas::texts(lang);
        let mut window = Window::new(lang);
        window.app_mut().state.model.layout.maximized = None;
        window.run();
        window.explain(Explanation::Steps);
        let places: Vec<_> = window.app_mut().canvas.places().collect();
        let of = |view| places.iter().find(|(of, _)| *of == view).map(|(_, place)| *place).unwrap();
        let moving = of(View::Canonical);
        for other in [View::World, View::Image] {
            assert!(moving.area() > of(other).area(), "{moving:?}, {other:?} {:?}", of(other));
        }
        // Above it, in its title.
        let title = |window: &Window| {
            let above = |place: &Rect| place.bottom() <= moving.top() + 1.0 && place.top() > moving.top() - 40.0;
            let within = |place: &Rect| above(place) && moving.x_range().contains(place.left());
            let names = [words.view(View::Canonical), words.on_the_way];
            let written = window.written();
            names.map(|name| written.iter().any(|(text, place)| text == name && within(place)))
        };
        assert_eq!(title(&window), [true, false], "at the end of the way it is the canonical volume");
        window.harness.get_by_label(texts(lang).play).click();
        window.harness.run_steps(4);
        assert!(window.state().model.explained.steps.plays() && window.state().model.is_on_the_way());
        assert_eq!(title(&window), [false, true]);
    }
}
