//! The strip under the pictures: every stage of the pipeline, and why it was skipped.

use camera_lab::figure::Explanation;
use camera_lab::gui::{Start, State};
use camera_lab::pipeline::Stage;
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_words::Lang;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};

use super::window::Window;
use crate::words::{en, pt};

impl Window {
    /// The line of a stage in the strip.
    fn stage(&self, begins: &str) -> bool {
        self.harness
            .query_all_by_role(Role::ListItem)
            .any(|node| node.accesskit_node().label().is_some_and(|l| l.starts_with(begins)))
    }

    /// Clicks a stage of the strip, in English.
    fn click_stage(&mut self, stage: Stage) {
        let name = camera_lab_words::why::pipeline::stage(Lang::En, stage);
        let is_it = |l: &str| l.starts_with(name);
        self.harness.get_by(|node| node.role() == Role::ListItem && node.label().is_some_and(|l| is_it(&l))).click();
        self.run();
    }
}

#[test]
fn the_divide_is_left_out_in_parallel_projection_and_says_why() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F6);
    window.harness.get_by_role_and_label(Role::Button, "Add").click();
    window.run();
    window.click(en::SCENES.shape_box);
    window.run();
    assert!(!window.stage("divide by w"), "it is hidden at first");
    window.key(Key::F10);
    window.run();
    assert!(window.stage("divide by w: 24 → 24 vertices") || window.stage("divide by w: 8 → 8 vertices"));
    assert!(window.stage("off-axis window: skipped – symmetric window"));
    window.key(Key::F5);
    window.click(en::WINDOW.parallel);
    assert!(window.stage("divide by w: skipped – parallel projection: w is 1 everywhere"));
    // Under the pointer, its text is in full at the head of the strip.
    let divide = |label: &str| label.starts_with("divide by w");
    let at = window.harness.get_by(|node| node.label().is_some_and(|l| divide(&l)) && node.role() == Role::ListItem);
    at.hover();
    window.run();
    let said = window.harness.query_all_by_label_contains("divide by w: skipped – parallel projection").count();
    assert!(said >= 2, "{said}");
    window.command_key(Key::Z);
    assert!(!window.stage("divide by w: skipped"));
}

#[test]
fn nothing_in_the_strip_lies_over_another_text() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut figure = camera_lab_desk::document::fresh();
        figure.style.antialias = camera_lab::appearance::Samples::One;
        let mut state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
            .expect("a camera");
        state.model.layout.strip = true;
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
    window.click(pt::WINDOW.pipeline);
    assert!(window.state().model.layout.strip);
    assert!(window.stage("escrita"));
    let drawn = window.app_mut().canvas.drawn();
    window.harness.get_by_role_and_label(Role::ComboBox, pt::CANVAS.strip_of).click();
    window.run();
    window.harness.get_by_role_and_label(Role::Button, "Mundo").click();
    window.run();
    assert_eq!(window.state().model.layout.strip_of, View::World);
    assert!(window.says(pt::CANVAS.strip_hidden) && !window.stage("escrita"));
    assert_eq!(window.app_mut().canvas.drawn(), drawn);
    window.click(pt::CANVAS.strip_close);
    assert!(!window.state().model.layout.strip);
}

#[test]
fn a_window_with_the_strip_that_is_left_alone_does_not_repaint() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F10);
    window.assert_rests();
}

fn cell<'a>(window: &'a Window, name: &str) -> egui_kittest::Node<'a> {
    let name = name.to_owned();
    window
        .harness
        .get_by(move |node| node.role() == Role::ListItem && node.label().is_some_and(|label| label.starts_with(&name)))
}

fn click(window: &mut Window, name: &str) {
    let at = cell(window, name).rect().center();
    window.harness.hover_at(at);
    window.run();
    window.harness.drag_at(at);
    window.harness.drop_at(at);
    window.run();
}

/// A window with the house, and the strip under its image.
fn with_house(lang: Lang) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::House;
    (figure.style.antialias, figure.camera.near) = (camera_lab::appearance::Samples::One, 2.0);
    let mut state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
        .expect("a camera");
    state.model.layout.strip = true;
    state.model.layout.maximized = Some(View::Image);
    Window::with_state(state, [1280.0, 800.0])
}

#[test]
fn a_click_on_a_stage_shows_it_and_a_second_click_or_escape_hides_it() {
    let mut window = with_house(Lang::En);
    let figure = window.state().model.desk.shown.figure().clone();
    let drawn = |window: &mut Window| window.app_mut().canvas.drawn()[View::Image.index()];
    for (name, stage) in [("back faces", Stage::CullFaces), ("divide by w", Stage::Divide), ("fill", Stage::Fill)] {
        let before = drawn(&mut window);
        click(&mut window, name);
        assert_eq!(window.state().model.shown_stage(), Some(stage));
        assert!(drawn(&mut window) > before, "{name}: the picture shows it");
        let toggled = cell(&window, name).accesskit_node().toggled();
        assert_eq!(toggled, Some(eframe::egui::accesskit::Toggled::True), "{name} is marked");
    }
    click(&mut window, "fill");
    assert_eq!(window.state().model.shown_stage(), None, "a second click");
    click(&mut window, "fill");
    window.key(Key::Escape);
    assert_eq!(window.state().model.shown_stage(), None, "Esc");
    // One that was skipped says why, and is shown as skipped.
    click(&mut window, "texture");
    assert_eq!(window.state().model.shown_stage(), Some(Stage::Texture));
    window.harness.remove_cursor();
    window.run();
    assert!(window.says("texture: skipped – no object has a texture"));
    window.key(Key::F10);
    assert_eq!(window.state().model.shown_stage(), None, "hidden, it is not shown");
    assert_eq!(*window.state().model.desk.shown.figure(), figure, "the figure stays as it is");
}

#[test]
fn the_strip_says_the_same_numbers_while_it_shows_a_stage() {
    let mut window = with_house(Lang::En);
    let counts = |window: &Window| -> Vec<String> {
        let cells = window.harness.query_all_by_role(Role::ListItem);
        let labels = cells.filter_map(|cell| cell.accesskit_node().label());
        // Without the times.
        labels
            .map(|label| label.split(" · ").filter(|part| !part.ends_with('s') || part.contains('→')).collect())
            .collect()
    };
    let before = counts(&window);
    for name in ["back faces", "clipping", "hidden surfaces", "fill"] {
        click(&mut window, name);
        let now: Vec<_> = counts(&window);
        for (now, before) in now.iter().zip(&before) {
            // Marks that show it are lines. Nothing else is counted.
            assert!(now == before || before.starts_with("lines"), "{name}: {now} for {before}");
        }
        click(&mut window, name);
    }
}

#[test]
fn stages_are_reached_shown_and_explained_by_keyboard() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = with_house(lang);
        let name = camera_lab_words::why::pipeline::stage(lang, Stage::Clip);
        cell(&window, name).focus();
        window.run();
        assert!(cell(&window, name).is_focused());
        window.key(Key::Enter);
        assert_eq!(window.state().model.shown_stage(), Some(Stage::Clip), "Enter");
        window.key(Key::Space);
        assert_eq!(window.state().model.shown_stage(), None, "Space");
        // Tab moves on to the next stage.
        window.key(Key::Tab);
        assert!(cell(&window, camera_lab_words::why::pipeline::stage(lang, Stage::Oblique)).is_focused());
        window.key(Key::F1);
        assert_eq!(window.state().model.explained.shown(), Explanation::Notes);
        assert_eq!(window.state().explain.notes.chosen, camera_lab_words::why::notes::of_stage(Stage::Oblique));
    }
}

#[test]
fn in_the_world_a_stage_of_the_image_shows_its_objects() {
    let mut window = with_house(Lang::En);
    window.explain(Explanation::Stages);
    assert!(window.state().model.layout.strip, "the strip has the stages");
    window.click_stage(Stage::Clip);
    assert_eq!(window.state().model.shown_stage(), Some(Stage::Clip));
    assert!(window.says(&format!("{}: clipping", en::STAGES.shown)), "and the panel names it");
    window.app_mut().state.model.layout.maximized = Some(View::World);
    window.run();
    let drawn = window.app_mut().canvas.drawn()[View::World.index()];
    window.app_mut().state.model.toggle_stage(Stage::Clip);
    window.run();
    assert_eq!(window.state().model.shown_stage(), None);
    assert!(window.app_mut().canvas.drawn()[View::World.index()] > drawn, "the cuts were marked there");
}
