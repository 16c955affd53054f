//! The coach in the window: an empty image says why, one click shows the missing objects, one step undoes it.

use std::time::Duration;

use camera_lab::camera::{Api, Ndc, Parameters};
use camera_lab::figure::Explanation;
use camera_lab::gui::app::file_flow;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::scene::Preset;
use camera_lab_desk::action::Intent;
use camera_lab_words::Lang;
use camera_lab_words::window::coach;
use eframe::egui::{Event, Key, Modifiers, PointerButton};
use egui_kittest::kittest::Queryable;

use super::files::Folder;
use super::window::Window;
use crate::words::en;

/// A window with a cube, which there is little to draw of.
fn window(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    window.app_mut().state.model.desk.shown.edit(|figure| figure.scene.preset = Preset::Cube);
    settled(&mut window);
    window
}

fn settled(window: &mut Window) {
    window.run();
    window.app_mut().state.model.coach.take(Duration::from_secs(60));
    window.run();
}

#[test]
fn an_empty_image_says_why_and_one_click_shows_the_missing_objects() {
    for (lang, why) in [(Lang::En, "behind the camera"), (Lang::PtBr, "atrás da câmera")] {
        let button = coach::texts(lang).show_it;
        let mut window = window(lang);
        assert!(window.harness.query_by_label(button).is_none());
        // It turns its back to the scene.
        let before = window.state().model.desk.shown.figure().camera;
        let behind = Parameters { focal_point: 2.0 * before.position, ..before };
        window.app_mut().state.model.desk.shown.set_parameters(behind);
        settled(&mut window);
        assert!(window.says(why));
        window.click(button);
        settled(&mut window);
        assert!(!window.says(why));
        let advice = window.state().model.coach.advice().expect("it is known").clone();
        assert!(advice.diagnosis.expect("it can be drawn").visible > 0);
        window.command_key(Key::Z);
        assert_eq!(window.state().model.desk.shown.figure().camera, behind, "one step back");
    }
}

#[test]
fn the_line_under_the_pictures_opens_all_there_is_to_say_and_repairs() {
    let mut window = window(Lang::En);
    assert!(window.harness.query_by_label("Camera check: good").is_some());
    window.enter("F", "0.00001");
    settled(&mut window);
    window.click("⚠ Camera check: poor");
    settled(&mut window);
    assert!(window.says(coach::texts(Lang::En).no_problems_in_coarse));
    assert!(window.says("⚠ B / F: poor"));
    let improve = window.harness.query_all_by_label(en::COACH.improve).next().expect("a repair");
    improve.click();
    settled(&mut window);
    assert!(window.state().model.desk.shown.figure().camera.near > 0.5);
    assert!(window.harness.query_by_label("Camera check: good").is_some());
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().camera.near, 1e-5);
}

/// Numbers in the fields that make no camera are a finding with a repair, and the last good image stays.
#[test]
fn an_impossible_camera_is_a_finding_and_one_click_repairs_it() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = coach::texts(lang);
        let mut window = window(lang);
        let good = window.state().model.desk.shown.figure().camera;
        window.enter("B", "0,01");
        settled(&mut window);
        assert_eq!(window.state().model.desk.shown.figure().camera, good);
        window.click(&format!("⚠ {}", t.one_finding));
        settled(&mut window);
        let why = if lang == Lang::En { "F must be less than B" } else { "F tem de ser menor que B" };
        assert!(window.says(why), "{lang:?}");
        window.click(t.show_it);
        settled(&mut window);
        assert!(window.state().model.desk.shown.problem().is_none());
        // B = 10 F, since with F and B exchanged the cube would be beyond the back plane.
        assert_eq!(window.state().model.desk.shown.figure().camera, Parameters { far: 10.0 * good.near, ..good });
        window.command_key(Key::Z);
        assert_eq!(window.state().model.desk.shown.figure().camera, good);
    }
}

/// A file whose camera is impossible opens: its numbers are in the fields, and one click repairs them.
#[test]
fn a_figure_with_an_impossible_camera_opens_and_is_repaired() {
    let folder = Folder::new("impossible-camera");
    let path = folder.file("up.toml");
    std::fs::write(&path, "# Mine.\n[camera]\nposition = [0, 9, 0]\nfocal_point = [0, 0, 0]\n").expect("written");
    let mut window = window(Lang::En);
    let t = coach::texts(Lang::En);
    let ctx = window.harness.ctx.clone();
    file_flow::begin(&ctx, &mut window.app_mut().state, Intent::OpenPath(path));
    settled(&mut window);
    if window.state().file_flow.dialog.is_some() {
        window.click(camera_lab_words::window::texts(Lang::En).dont_save);
        settled(&mut window);
    }
    assert!(window.state().model.desk.shown.problem().is_some());
    assert_eq!(window.state().model.desk.shown.draft().position.y, 9.0);
    window.click(&format!("⚠ {}", t.one_finding));
    settled(&mut window);
    assert!(window.says("VUP × n"));
    window.click(t.show_it);
    settled(&mut window);
    assert!(window.state().model.desk.shown.problem().is_none());
    assert_eq!(window.state().model.desk.shown.figure().camera.position.y, 9.0);
}

/// While the coach examines a change, a click on its button is the coach's all the same.
#[test]
fn a_click_is_the_coachs_even_while_it_examines_a_change() {
    let mut window = window(Lang::En);
    let place = |window: &Window, label: &str| window.harness.get_by_label(label).rect();
    let coach = place(&window, "Camera check: good").center();
    let button = |window: &Window, pressed| {
        let modifiers = Modifiers::NONE;
        window.harness.event(Event::PointerButton { pos: coach, button: PointerButton::Primary, pressed, modifiers });
    };
    window.harness.event(Event::PointerMoved(coach));
    window.harness.step();
    let before = window.state().model.desk.shown.figure().camera;
    window.app_mut().state.model.desk.shown.set_parameters(Parameters { near: 1e-5, ..before });
    window.harness.step();
    button(&window, true);
    window.harness.step();
    button(&window, false);
    window.harness.step();
    settled(&mut window);
    assert!(window.state().file_flow.dialog == Some(Dialog::Coach) && !window.state().model.layout.strip);
    window.key(Key::Escape);
    assert!(window.harness.query_by_label("⚠ Camera check: poor").is_some());
}

/// Once it has given its advice, the coach does nothing until the figure changes.
#[test]
fn an_unchanged_figure_is_not_examined_again() {
    let mut window = window(Lang::En);
    let known = window.state().model.coach.advice().expect("it is known").clone();
    for _ in 0..3 {
        window.run();
    }
    assert_eq!(window.state().model.coach.advice(), Some(&known));
}

/// The explanation of depths uses the convention of the window, and draws the two planes that it describes.
#[test]
fn the_depth_panel_follows_the_convention_and_the_gap_of_two_planes() {
    let cases = [
        (
            Lang::En,
            "In the NDC of OpenGL, z_n is −1 at F and 1 at B.",
            "fixed 24",
            "f32",
            "told apart",
            "flicker (z-fighting)",
        ),
        (
            Lang::PtBr,
            "No NDC de OpenGL, z_n é −1 em F e 1 em B.",
            "ponto fixo 24",
            "f32",
            "distinguem-se",
            "cintilam (z-fighting)",
        ),
    ];
    for (lang, in_convention, fixed, float, apart, flicker) in cases {
        let mut window = window(lang);
        window.explain(Explanation::Depth);
        assert!(window.harness.query_by_label(in_convention).is_some());
        assert!(window.harness.query_by_label(float).is_some());
        let picture = |window: &Window, text: &str| {
            let label = format!("{fixed}: {text}");
            window.harness.query_by(|node| node.label().is_some_and(|l| l.starts_with(&label))).is_some()
        };
        assert!(picture(&window, apart) && !picture(&window, flicker));
        let field = if lang == Lang::En { "Two planes, this far apart:" } else { "Dois planos, a esta distância:" };
        window.enter(field, "1e-9");
        assert_eq!(window.state().explain.gap, 1e-9);
        assert!(picture(&window, flicker) && !picture(&window, apart));
        window.app_mut().state.model.settings.conventions.ndc =
            Ndc { api: Api::Vulkan, reversed: true, infinite: true };
        window.run();
        let (said, missing) = match lang {
            Lang::En => ("In the NDC of Vulkan, reversed, B → ∞, z_n is 1 at F and 0 at B → ∞.", "f32 reversed"),
            _ => ("No NDC de Vulkan, invertido, B → ∞, z_n é 1 em F e 0 em B → ∞.", "f32 invertido"),
        };
        assert!(window.harness.query_by_label(said).is_some());
        assert!(window.harness.query_by_label(missing).is_some() && window.harness.query_by_label(float).is_none());
    }
}

#[test]
fn repairs_use_the_symbols_and_the_numbers_of_the_panel() {
    for (lang, comma, point) in [(Lang::PtBr, ',', '.'), (Lang::En, '.', ',')] {
        let mut window = window(lang);
        // Nothing is seen up to here, and F is far too small.
        let camera = window.state().model.desk.shown.figure().camera;
        window.app_mut().state.model.desk.shown.set_parameters(Parameters { near: 1e-5, far: 3.7, ..camera });
        settled(&mut window);
        window.app_mut().state.file_flow.dialog = Some(Dialog::Coach);
        settled(&mut window);
        let told: Vec<String> = window.written().into_iter().map(|(text, _)| text).collect();
        let changes: Vec<&String> =
            told.iter().filter(|text| text.starts_with("F = ") || text.starts_with("B = ")).collect();
        assert!(!changes.is_empty(), "{told:?}");
        assert!(changes.iter().any(|text| text.contains(comma)), "{changes:?}");
        assert!(changes.iter().all(|text| !text.contains(point)), "{changes:?}");
        for key in ["near =", "far =", "view_angle", "focal_point"] {
            assert!(!told.iter().any(|text| text.contains(key)), "{key} in {told:?}");
        }
    }
}

#[test]
fn the_chart_of_depths_is_written_as_its_name_says() {
    let folder = Folder::new("depth-chart");
    let mut window = window(Lang::En);
    window.app_mut().state.file_flow.native = false;
    window.explain(Explanation::Depth);
    let mut written = |name: &str| {
        window.harness.get_by_label(en::WINDOW.export_chart).scroll_to_me();
        window.run();
        window.click(en::WINDOW.export_chart);
        window.choose(&folder.file(name));
    };
    written("depths");
    let svg = std::fs::read_to_string(folder.file("depths.svg")).expect("a chart");
    assert!(svg.contains("distance from the eye") && svg.contains("zₙ"), "{svg}");
    assert!(svg.matches("<path").count() >= 3, "{svg}");
    written("depths.pdf");
    assert!(std::fs::read(folder.file("depths.pdf")).expect("a chart").starts_with(b"%PDF"));
    written("depths.tex");
    assert!(folder.file("depths.tex").exists() && folder.file("depths-art.pdf").exists());
}
