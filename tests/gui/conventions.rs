//! Conventions: whose NDC, compared with whose, row vectors, the left hand.

use camera_lab::camera::{Api, Ndc, Projection};
use camera_lab::gui::state::Conventions;
use camera_lab::i18n::Lang;
use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable;

use super::window::Window;

const VULKAN: Ndc = Ndc { api: Api::Vulkan, reversed: false, infinite: false };

/// A window whose section of conventions is open.
fn window(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    window.click(if lang == Lang::En { "Conventions" } else { "Convenções" });
    window
}

fn choose(window: &mut Window, list: &str, entry: &str) {
    window.harness.get_by_role_and_label(Role::ComboBox, list).click();
    window.run();
    window.harness.get_by_role_and_label(Role::Button, entry).click();
    window.run();
}

fn shown(window: &Window) -> Conventions {
    window.state().settings.conventions
}

#[test]
fn the_numbers_are_in_the_convention_that_is_chosen() {
    let mut window = window(Lang::En);
    // The first digits of the entry of y, with a minus.
    let y = window.state().document.camera().clip_from_view().y_axis.y;
    let downwards = format!("−{}", &format!("{y:.6}")[..4]);
    assert!(window.says("projection matrix (5.14)") && !window.says(&downwards));
    choose(&mut window, "NDC of", "Vulkan");
    assert_eq!(shown(&window), Conventions { ndc: VULKAN, ..Conventions::default() });
    assert!(window.says("projection matrix · Vulkan") && !window.says("(5.14)"));
    assert!(window.says(&downwards), "y points down");
    window.click("NDC of: reversed");
    window.click("NDC of: B → ∞");
    assert_eq!(shown(&window).ndc, Ndc { reversed: true, infinite: true, ..VULKAN });
    assert!(window.says("projection matrix · Vulkan, reversed, B → ∞"));
    // The figure is as it was.
    window.key(Key::Escape);
    assert!(!window.state().document.is_changed());
}

#[test]
fn what_differs_is_said() {
    let mut window = window(Lang::En);
    choose(&mut window, "compared with", "Vulkan");
    assert_eq!(shown(&window).compared, Some(VULKAN));
    assert!(window.says("projection matrix (5.14)") && window.says("projection matrix · Vulkan"));
    assert!(
        window.says("Marked: what differs in Vulkan. z_n goes from 0 at F to 1, not from −1 to 1; y_n points down.")
    );
    choose(&mut window, "NDC of", "Metal");
    choose(&mut window, "compared with", "Direct3D");
    assert!(window.says("Direct3D has the same NDC as Metal: nothing differs."));
    window.click("compared with: B → ∞");
    assert!(window.says("Marked: what differs in Direct3D, B → ∞. It has no far plane."));
    choose(&mut window, "compared with", "nothing");
    assert_eq!(shown(&window).compared, None);
    assert!(!window.says("Marked") && !window.says("Direct3D, B"));
}

#[test]
fn without_a_far_plane_a_parallel_projection_keeps_it_and_says_so() {
    let mut window = window(Lang::PtBr);
    window.click("NDC de: B → ∞");
    assert!(!window.says("o mesmo z"));
    window.click("Paralela");
    assert_eq!(window.state().document.camera().projection(), Projection::Parallel);
    assert!(window.says("B → ∞ dá o mesmo z a todas as profundidades de uma projeção paralela: OpenGL aparece"));
    assert!(window.says("matriz de projeção (5.16)"), "as with a far plane");
}

#[test]
fn rows_and_the_left_hand_are_said() {
    let mut window = window(Lang::En);
    window.click("row vectors");
    assert!(window.says("every matrix is transposed"));
    assert!(window.says("Mvᵀ Mpᵀ"));
    window.click("left-handed view space");
    assert!(window.says("the third row of M_v and the third column of M_p have the other sign"));
    assert!(shown(&window).row_vectors && shown(&window).left_handed);
}
