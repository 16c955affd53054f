//! The camera in other vocabularies, a pasted matrix, and code.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::figure::Explanation;
use camera_lab::gui::{Start, State};
use camera_lab::i18n::Lang;
use camera_lab::scene::Preset;
use camera_lab::views::View;
use eframe::egui::Key;
use egui_kittest::kittest::Queryable as _;
use glam::DVec3;

use super::window::Window;

/// A window that shows an explanation.
fn window(lang: Lang, shown: Explanation) -> Window {
    let mut figure = camera_lab::gui::fresh();
    figure.scene.preset = Preset::Empty;
    let mut state = State::new(Start { figure, file: None, lang, allow_files: false }).unwrap();
    state.layout.maximized = Some(View::Image);
    // So high that nothing has to be scrolled.
    let mut window = Window::with_state(state, [1100.0, 1900.0]);
    window.explain(shown);
    window
}

#[test]
fn a_number_of_another_vocabulary_sets_the_camera() {
    let mut window = window(Lang::En, Explanation::Dialects);
    assert_eq!(window.state().explain.shown(), Explanation::Dialects);
    window.enter("gluLookAt eyeX", "7");
    assert_eq!(window.state().document.camera().position().x, 7.0);
    window.enter("F F", "0.5");
    assert_eq!(window.state().document.camera().near(), 0.5);
    window.enter("z_far z_far", "-40");
    assert_eq!(window.state().document.camera().far(), 40.0);
    let before = window.state().document.camera().clone();
    // What is not a camera stays in its field, with the reason.
    window.enter("B B", "0.25");
    assert_eq!(*window.state().document.camera(), before);
    assert!(window.state().explain.refused.is_some());
    assert!(window.says("near"), "the reason names the key");
    window.enter("B B", "30");
    assert_eq!(window.state().document.camera().far(), 30.0);
    assert!(window.state().explain.refused.is_none());
    window.key(Key::Escape);
    window.command_key(Key::Z);
    assert_eq!(window.state().document.camera().far(), 40.0, "one step for one number");
}

#[test]
fn a_pasted_matrix_gives_its_camera_and_says_what_it_cannot_know() {
    let mut window = window(Lang::PtBr, Explanation::Dialects);
    window.app_mut().state.explain.pasted.text = "1 0 0\n0 1 0".to_owned();
    window.run();
    assert!(window.says("6 números"));
    window.app_mut().state.explain.pasted.text = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]".to_owned();
    window.run();
    assert!(window.says("z_n troca de sinal") && window.says("ao longo de n"));
    window.click("Usar esta câmera");
    let camera = window.state().document.camera();
    let corners = camera.volume_corners();
    assert!(corners.iter().all(|p| p.abs().abs_diff_eq(DVec3::ONE, 1e-12)), "[0] exercise 5.3: {corners:?}");
    // A mirror has no camera; a transposed matrix is recognised.
    window.app_mut().state.explain.pasted.text = "-1 0 0 0 0 1 0 0 0 0 -2 -3 0 0 -1 0".to_owned();
    window.run();
    assert!(window.says("espelha"));
    window.app_mut().state.explain.pasted.text = "1 0 0 0 0 1 0 0 0 0 -1 0 0 0 -3 1".to_owned();
    window.run();
    assert!(window.says("vetores linha"));
}

#[test]
fn code_is_for_the_camera_as_it_is() {
    let mut window = window(Lang::En, Explanation::Code);
    let code = |window: &Window| {
        let mut nodes = window.harness.get_all_by_label("Code").filter_map(|node| node.value());
        nodes.find(|text| text.contains("gl")).unwrap_or_default()
    };
    let text = code(&window);
    assert!(text.contains("gluLookAt(") && text.contains("// angles in degrees"), "{text}");
    window.app_mut().state.explain.code = camera_lab::explain::code::CodeTarget::Glm;
    window.run();
    assert!(code(&window).contains("glm::lookAtRH"));
}
