//! Conventions: whose NDC, compared with whose, row vectors, the left hand.

use std::fs;

use camera_lab::camera::{Api, Ndc, Projection};
use camera_lab::figure::Explanation;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::gui::{Start, State};
use camera_lab::views::{Probe, View, Views};
use camera_lab_desk::Conventions;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable};

use super::files::Folder;
use super::window::Window;
use crate::words::{en, pt};

const VULKAN: Ndc = Ndc { api: Api::Vulkan, reversed: false, infinite: false };

/// A window that shows the conventions.
fn window(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    window.explain(Explanation::Conventions);
    window
}

fn choose(window: &mut Window, list: &str, entry: &str) {
    window.harness.get_by_role_and_label(Role::ComboBox, list).click();
    window.run();
    window.harness.get_by_role_and_label(Role::Button, entry).click();
    window.run();
}

fn shown(window: &Window) -> Conventions {
    window.state().model.settings.conventions
}

#[test]
fn the_numbers_are_in_the_convention_that_is_chosen() {
    let mut window = window(Lang::En);
    // The first digits of the entry of y, with a minus.
    let y = window.state().model.desk.shown.camera().clip_from_view().y_axis.y;
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
    assert!(!window.state().model.desk.shown.is_changed());
}

#[test]
fn differing_entries_are_marked_and_listed() {
    let mut window = window(Lang::En);
    choose(&mut window, "compared with", "Vulkan");
    assert_eq!(shown(&window).compared, Some(VULKAN));
    assert!(window.says("projection matrix (5.14)") && window.says("projection matrix · Vulkan"));
    assert!(window.says(
        "The entries of Vulkan that differ are marked. z_n goes from 0 at F to 1, not from −1 to 1; y_n points down."
    ));
    choose(&mut window, "NDC of", "Metal");
    choose(&mut window, "compared with", "Direct3D");
    assert!(window.says("Direct3D has the same NDC as Metal, so nothing differs."));
    window.click("compared with: B → ∞");
    assert!(window.says("The entries of Direct3D, B → ∞ that differ are marked. It has no back plane."));
    choose(&mut window, "compared with", "nothing");
    assert_eq!(shown(&window).compared, None);
    assert!(!window.says("that differ are marked") && !window.says("Direct3D, B"));
}

#[test]
fn without_a_far_plane_a_parallel_projection_keeps_it_and_says_so() {
    let mut window = window(Lang::PtBr);
    window.click("NDC de: B → ∞");
    assert!(!window.says("o mesmo z"));
    window.click(pt::WINDOW.parallel);
    assert_eq!(window.state().model.desk.shown.camera().projection(), Projection::Parallel);
    assert!(window.says("B → ∞ dá o mesmo z a todas as profundidades de uma projeção paralela: OpenGL aparece"));
    assert!(window.says("matriz de projeção (5.16)"), "as with a far plane");
}

#[test]
fn row_vectors_and_the_left_hand_have_their_notes() {
    let mut window = window(Lang::En);
    window.click(en::CONVENTIONS.row_vectors);
    assert!(window.says("Every matrix is transposed"));
    assert!(window.says("Mvᵀ Mpᵀ"));
    window.click(en::CONVENTIONS.left_handed);
    assert!(window.says("The third row of M_v and the third column of M_p change sign"));
    assert!(shown(&window).row_vectors && shown(&window).left_handed);
}

/// A window of its size with the canonical volume alone, in a convention.
fn canonical(ndc: Ndc) -> Window {
    let start = Start {
        figure: camera_lab_desk::document::fresh(),
        file: None,
        lang: Lang::En,
        allow_files: false,
        lesson: None,
        later: None,
    };
    let mut state = State::new(start).expect("a possible camera");
    state.file_flow.native = false;
    state.model.layout.maximized = Some(View::Canonical);
    state.model.settings.conventions.ndc = ndc;
    Window::with_state(state, [900.0, 560.0])
}

/// Numbers read out for a place are in the convention, and a presentation stays in it.
#[test]
fn the_probe_and_a_presentation_are_in_the_convention() {
    let mut window = canonical(VULKAN);
    let read_out = |window: &Window| {
        let node = window.harness.get_by_label_contains("NDC");
        node.accesskit_node().value().unwrap_or_default()
    };
    for presenting in [false, true] {
        if presenting {
            window.key(Key::F11);
            assert!(window.state().model.settings.presentation && shown(&window).ndc == VULKAN);
        }
        let picture = window.harness.get_by(|node| {
            node.role() == Role::Image && node.label().is_some_and(|label| label.starts_with("Canonical volume"))
        });
        // Somewhere near the middle there is a vertex.
        let middle = picture.rect().center();
        let places = (-12..12).flat_map(|j| (-12..12).map(move |i| middle + 8.0 * vec2(i as f32, j as f32)));
        let vertex = places.into_iter().find_map(|at| {
            window.harness.hover_at(at);
            window.run();
            window.state().model.frame.probe.and_then(|probe| if let Probe::Point(p) = probe { Some(p) } else { None })
        });
        let p = vertex.expect("a vertex");
        let clip =
            window.state().model.desk.shown.camera().clip_space(VULKAN).expect("in perspective").clip_from_view()
                * window.state().model.desk.shown.camera().view_point(p).extend(1.0);
        let text = read_out(&window);
        let z = format!("{:.6}", clip.z / clip.w)[..4].to_owned();
        assert!(text.contains(&z) && clip.z > 0.0, "{text} has no {z}");
    }
}

/// The exported canonical volume is the one on the screen and says whose NDC it is in. In the notes' own NDC it says
/// nothing.
#[test]
fn an_exported_canonical_volume_is_in_the_convention_and_names_it() {
    let folder = Folder::new("export-convention");
    let export = |name: &str, ndc: Ndc| {
        let mut window = canonical(ndc);
        let path = folder.file(name);
        let [width, height] = window.state().model.frame.picture_sizes[View::Canonical.index()];
        let on_screen = window.pixels([width as usize, height as usize]);
        window.command_key(Key::E);
        let Some(Dialog::Export(mut export)) = window.state().file_flow.dialog.clone() else { panic!("no dialog") };
        let (sizes, unit) = (window.state().model.frame.picture_sizes, window.state().model.frame.screen_scale);
        let theme = window.state().model.settings.theme;
        (export.what, export.times, export.theme) = (Views::One(View::Canonical), Some(1), theme);
        export.fit_screen(sizes, unit);
        window.app_mut().state.file_flow.dialog = Some(Dialog::Export(export));
        window.run();
        window.click(en::WINDOW.export_action);
        window.choose(&path);
        window.wait(|_| path.exists());
        let bytes = fs::read(&path).expect("exported");
        let image = image::load_from_memory(&bytes).expect("a PNG").to_rgba8();
        assert!(image.into_raw() == on_screen, "{name}: not what is on the screen");
        bytes
    };
    let says = |bytes: &[u8], text: &str| bytes.windows(text.len()).any(|part| part == text.as_bytes());
    let (of_notes, vulkan) = (export("notes.png", Ndc::default()), export("vulkan.png", VULKAN));
    assert!(says(&vulkan, "Description") && says(&vulkan, "NDC: Vulkan"));
    assert!(!says(&of_notes, "Description"));
    assert!(of_notes != vulkan);
}
