//! The strip under the pictures: every stage of the pipeline, and why it was left out.

use camera_lab::gui::{Start, State};
use camera_lab::i18n::Lang;
use camera_lab::views::View;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};

use super::window::Window;

impl Window {
    /// The line of a stage in the strip.
    fn stage(&self, begins: &str) -> bool {
        self.harness
            .query_all_by_role(Role::ListItem)
            .any(|node| node.accesskit_node().label().is_some_and(|l| l.starts_with(begins)))
    }
}

#[test]
fn the_divide_is_left_out_in_parallel_projection_and_says_why() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F6);
    window.harness.get_by_role_and_label(Role::Button, "Add").click();
    window.run();
    window.click("box");
    window.run();
    assert!(!window.stage("divide by w"), "it is hidden at first");
    window.key(Key::F10);
    window.run();
    assert!(window.stage("divide by w: 24 → 24 vertices") || window.stage("divide by w: 8 → 8 vertices"));
    assert!(window.stage("oblique window: left out – symmetric window"));
    window.key(Key::F5);
    window.click("Parallel");
    assert!(window.stage("divide by w: left out – parallel projection: w is 1 everywhere"));
    // Pointed at, it is said in full at the head of the strip.
    let divide = |label: &str| label.starts_with("divide by w");
    let at = window.harness.get_by(|node| node.label().is_some_and(|l| divide(&l)) && node.role() == Role::ListItem);
    at.hover();
    window.run();
    let said = window.harness.query_all_by_label_contains("divide by w: left out – parallel projection").count();
    assert!(said >= 2, "{said}");
    window.command_key(Key::Z);
    assert!(!window.stage("divide by w: left out"));
}

#[test]
fn nothing_in_the_strip_lies_over_another_text() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut figure = camera_lab::gui::fresh();
        figure.style.antialias = 1;
        let mut state = State::new(Start { figure, file: None, lang, allow_files: false }).expect("a camera");
        state.layout.strip = true;
        let mut window = Window::with_state(state, [1280.0, 720.0]);
        window.run();
        let cells: Vec<_> = window.harness.query_all_by_role(Role::ListItem).map(|cell| cell.rect()).collect();
        assert!(cells.len() > 10);
        let written = window.written();
        let mut timed = 0;
        for cell in cells {
            let inside: Vec<_> =
                written.iter().filter(|(text, at)| cell.contains(at.center()) && !text.is_empty()).collect();
            timed += inside.len().saturating_sub(2);
            for (i, (text, at)) in inside.iter().enumerate() {
                for (other, there) in &inside[..i] {
                    let both = at.intersect(*there);
                    assert!(both.width() <= 0.0 || both.height() <= 2.0, "{lang:?}: {text} over {other}");
                }
            }
        }
        assert!(timed > 3, "most times have room: {timed}");
    }
}

#[test]
fn the_strip_is_of_the_picture_that_is_chosen_and_a_hidden_one_costs_nothing() {
    let mut window = Window::new(Lang::PtBr);
    window.click("Pipeline");
    assert!(window.state().layout.strip);
    assert!(window.stage("escrita"));
    let drawn = window.app_mut().canvas.drawn();
    window.harness.get_by_role_and_label(Role::ComboBox, "Etapas da imagem").click();
    window.run();
    window.harness.get_by_role_and_label(Role::Button, "Mundo").click();
    window.run();
    assert_eq!(window.state().layout.strip_of, View::World);
    assert!(window.says("Esta imagem está escondida") && !window.stage("escrita"));
    assert_eq!(window.app_mut().canvas.drawn(), drawn);
    window.click("Esconder o pipeline (F10)");
    assert!(!window.state().layout.strip);
}

#[test]
fn a_window_with_the_strip_that_is_left_alone_does_not_repaint() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F10);
    window.harness.remove_cursor();
    window.run();
    let drawn = window.app_mut().canvas.drawn();
    for _ in 0..3 {
        window.harness.step();
        let delay = window.harness.output().viewport_output[&eframe::egui::ViewportId::ROOT].repaint_delay;
        assert_eq!(delay, std::time::Duration::MAX);
    }
    assert_eq!(window.app_mut().canvas.drawn(), drawn);
}

#[test]
fn a_click_on_a_stage_shows_what_it_does_where_the_pictures_can() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F10);
    let click = |window: &mut Window, name: &str| {
        let starts = |label: &str| label.starts_with(name);
        let at = window
            .harness
            .get_by(|node| node.label().is_some_and(|l| starts(&l)) && node.role() == Role::ListItem)
            .rect()
            .center();
        window.harness.hover_at(at);
        window.run();
        window.harness.drag_at(at);
        window.harness.drop_at(at);
        window.run();
    };
    let reveal = |window: &Window| window.state().document.figure().reveal;
    for _ in 0..2 {
        let before = reveal(&window);
        click(&mut window, "clip");
        assert_ne!(reveal(&window).clipping, before.clipping);
        click(&mut window, "back faces");
        assert_ne!(reveal(&window).culled, before.culled);
        click(&mut window, "hidden");
        assert_ne!(reveal(&window).depth, before.depth);
    }
    let before = reveal(&window);
    click(&mut window, "write");
    assert_eq!(reveal(&window), before, "there is nothing to show");
}
