//! The panel of studies: measured beside the window's thread, and each number leads to its camera.

use std::time::Duration;

use camera_lab::camera::Camera;
use camera_lab::numerics::{Effort, OWN, Study};
use camera_lab_words::Lang;
use camera_lab_words::why::this_figure;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable;

use super::files::Folder;
use super::sessions::written;
use super::window::Window;
use crate::words::{en, pt};

/// A window with the panel, which tries so much.
fn window_with(lang: Lang, effort: Effort) -> Window {
    let mut window = Window::new(lang);
    window.app_mut().state.numerics.effort = effort;
    window.command_key(Key::Num9);
    window.run();
    assert!(window.state().numerics.shown);
    window
}

fn window(lang: Lang) -> Window {
    window_with(lang, Effort { seed: 1, seconds: 0.0, thorough: false })
}

/// Waits for the study that the panel has begun by itself.
fn measured(window: &mut Window) {
    window.app_mut().state.numerics.take(Duration::from_secs(120));
    window.run();
    assert!(window.state().numerics.measuring().is_none());
}

/// Clicks an entry of a list that's longer than the panel is high.
fn choose(window: &mut Window, entry: &str) {
    window.harness.get_by_label(entry).scroll_to_me();
    window.run();
    window.click(entry);
}

#[test]
fn a_study_is_measured_and_its_worst_cameras_open_after_a_question() {
    let (folder, mut window) = (Folder::new("study"), window(Lang::En));
    window.app_mut().keep_session(&folder.0, false);
    choose(&mut window, "Clipping through w = 0");
    assert_eq!(window.state().numerics.study, Study::Clipping);
    measured(&mut window);
    assert!(window.harness.query_by_label_contains("f64 before the divide").is_some());

    // Something is changed. The figure of a row is opened over it.
    window
        .app_mut()
        .state
        .model
        .desk
        .shown
        .edit(|figure| figure.style.antialias = camera_lab::appearance::Samples::Sixteen);
    window.wait(|_| written(&folder.0).contains("antialias = 16"));
    let row =
        window.state().numerics.found(Study::Clipping).expect("found").rows.iter().rfind(|r| r.method == OWN).cloned();
    let wanted = camera_lab::figure::read::parse(&row.and_then(|r| r.figure).expect("a figure")).expect("a figure");
    window.app_mut().state.numerics.case = 1;
    window.run();
    let buttons: Vec<_> = window.harness.query_all_by_role_and_label(Role::Button, "open").collect();
    buttons.last().expect("a button for each method").click();
    drop(buttons);
    window.run();
    assert_eq!(
        window.state().model.desk.shown.figure().style.antialias,
        camera_lab::appearance::Samples::Sixteen,
        "it is asked first"
    );
    window.click(en::WINDOW.dont_save);
    assert_eq!(window.state().model.desk.shown.figure().camera, wanted.camera);
    assert!(Camera::new(&wanted.camera).is_ok());
}

#[test]
fn the_panel_speaks_portuguese_and_goes_away_again() {
    let mut window = window(Lang::PtBr);
    assert!(window.harness.query_by_label_contains("por arredondamento ao acaso 15").is_some(), "this figure's M_v");
    choose(&mut window, "Recorte por w = 0");
    measured(&mut window);
    for text in ["erro contra parâmetro", "erro contra tempo", "f64 depois da divisão"] {
        assert!(window.harness.query_by_label_contains(text).is_some(), "{text}");
    }
    window.click(pt::NUMERICS.over_time);
    assert!(window.state().numerics.over_time);
    window.command_key(Key::Num9);
    window.run();
    assert!(window.harness.query_by_label_contains("erro contra tempo").is_none());
}

#[test]
fn a_cancelled_study_is_not_shown_as_measured() {
    let mut window = window_with(Lang::En, Effort { seed: 1, seconds: 600.0, thorough: true });
    window.click("Worlds far away");
    window.click(en::WINDOW.cancel);
    window.app_mut().state.numerics.take(Duration::from_secs(120));
    window.run();
    assert!(window.state().numerics.found(Study::VertexTransform).is_none());
    assert!(window.harness.query_by_label(en::NUMERICS.measure).is_some());
}

/// The panel opens with the figure on the screen. A way that's chosen is shown beside the exact image, and its keys are
/// written in one step.
#[test]
fn the_figure_is_examined_and_the_keys_of_a_way_are_used_in_one_step() {
    let mut window = Window::opened(std::path::Path::new("assets/figures/house.toml"));
    let state = &mut window.app_mut().state;
    state.model.desk.shown.edit(|figure| figure.image = camera_lab::camera::ImageSize { width: 64, height: 48 });
    state.numerics.this_figure.effort.seconds = 0.0;
    window.command_key(Key::Num9);
    window.run();
    window.click(en::THIS_FIGURE.study);
    window.wait(|window| {
        let this = &window.state().numerics.this_figure;
        this.study().is_some() && !this.is_busy()
    });
    let figure = window.state().model.desk.shown.figure().clone();
    let study = window.state().numerics.this_figure.study().cloned().expect("examined");
    let mut others = study.ways.iter().enumerate().filter(|(k, _)| ![study.yours, study.cheapest].contains(k));
    let (_, way) = others.next().expect("several ways");
    let set = this_figure::changed(Lang::En, &figure.scene, &study, way);
    choose(&mut window, &format!("{} {set}", this_figure::mark(way)));
    window.wait(|window| window.harness.query_by_label(en::THIS_FIGURE.divider).is_some());
    window.click(en::THIS_FIGURE.use_these);
    let mut expected = figure.clone();
    camera_lab::numerics::this_figure::apply(&mut expected, &study.changes(way));
    assert_ne!(expected.style, figure.style);
    assert_eq!(window.state().model.desk.shown.figure().style, expected.style);
    assert!(window.harness.query_by_label(en::THIS_FIGURE.old).is_some(), "the results are of another figure now");
    window.command_key(Key::Z);
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().style, figure.style);
    assert!(window.harness.query_by_label(en::THIS_FIGURE.old).is_none());
    // The numbers as tables, with the choices of the figure.
    let folder = Folder::new("numerics-tables");
    window.app_mut().state.file_flow.native = false;
    for (file, known) in [("ways.csv", "style.antialias"), ("ways.json", "\"left_out\"")] {
        window.harness.get_by_label(en::WINDOW.export_chart).scroll_to_me();
        window.run();
        window.click(en::WINDOW.export_chart);
        window.choose(&folder.file(file));
        let text = std::fs::read_to_string(folder.file(file)).expect("a table");
        assert!(text.contains(known) && text.contains("different"), "{file}: {text}");
    }
}
