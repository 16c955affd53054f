//! The camera in other vocabularies, a pasted matrix, and code.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Axes, MatrixKind, Projection};
use camera_lab::figure::{Explanation, Measure, Measured, WindowSide};
use camera_lab::gui::{Start, State};
use camera_lab::scene::Preset;
use camera_lab::views::View;
use camera_lab_words::Lang;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, vec2};
use egui_kittest::kittest::Queryable as _;
use glam::DVec3;

use super::window::Window;
use crate::words::{en, pt};

/// A window that shows an explanation.
fn window(lang: Lang, shown: Explanation) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Empty;
    let mut state =
        State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
    state.model.layout.maximized = Some(View::Image);
    // So high that nothing has to be scrolled.
    let mut window = Window::with_state(state, [1100.0, 1900.0]);
    window.explain(shown);
    window
}

#[test]
fn a_number_of_another_vocabulary_sets_the_camera() {
    let mut window = window(Lang::En, Explanation::Dialects);
    assert_eq!(window.state().model.explained.shown(), Explanation::Dialects);
    window.enter("gluLookAt eyeX", "7");
    assert_eq!(window.state().model.desk.shown.camera().position().x, 7.0);
    window.enter("F F", "0.5");
    assert_eq!(window.state().model.desk.shown.camera().near(), 0.5);
    window.enter("z_far z_far", "-40");
    assert_eq!(window.state().model.desk.shown.camera().far(), 40.0);
    let before = window.state().model.desk.shown.camera().clone();
    // Text that is not a camera stays in its field, with the reason.
    window.enter("B B", "0.25");
    assert_eq!(*window.state().model.desk.shown.camera(), before);
    assert!(window.state().explain.refused.is_some());
    assert!(window.says("near"), "the reason names the key");
    window.enter("B B", "30");
    assert_eq!(window.state().model.desk.shown.camera().far(), 30.0);
    assert!(window.state().explain.refused.is_none());
    window.key(Key::Escape);
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.camera().far(), 40.0, "one step for one number");
}

#[test]
fn a_pasted_matrix_gives_its_camera_and_says_what_it_cannot_know() {
    let mut window = window(Lang::PtBr, Explanation::Dialects);
    window.app_mut().state.explain.pasted.text = "1 0 0\n0 1 0".to_owned();
    window.run();
    assert!(window.says("6 números"));
    window.app_mut().state.explain.pasted.kind = Some(MatrixKind::ViewProjection);
    window.app_mut().state.explain.pasted.text = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]".to_owned();
    window.run();
    assert!(window.says("z_n troca de sinal") && window.says("ao longo de n"));
    window.click(pt::DIALECTS.take);
    let camera = window.state().model.desk.shown.camera();
    let corners = camera.volume_corners();
    assert!(corners.iter().all(|p| p.abs().abs_diff_eq(DVec3::ONE, 1e-12)), "[0] exercise 5.3: {corners:?}");
    // A mirror is that of a left-handed world. A transposed matrix is recognised.
    window.app_mut().state.explain.pasted.text = "-1 0 0 0 0 1 0 0 0 0 -2 -3 0 0 -1 0".to_owned();
    window.run();
    assert!(window.says("de mão esquerda"));
    window.app_mut().state.explain.pasted.text = "1 0 0 0 0 1 0 0 0 0 -1 0 0 0 -3 1".to_owned();
    window.run();
    assert!(window.says(pt::CONVENTIONS.row_vectors));
}

/// K, R and t of a camera, from its basis and its window, without the table of words.
fn k_r_t(window: &Window) -> ([f64; 4], [DVec3; 3], DVec3) {
    let (camera, image) = (window.state().model.desk.shown.camera(), window.state().model.desk.shown.figure().image);
    let (w, near) = (camera.window(), camera.near());
    let [m, n] = [image.width, image.height].map(f64::from);
    let (width, height) = (w.right - w.left, w.top - w.bottom);
    let k = [near * m / width, near * n / height, -w.left * m / width, w.top * n / height];
    let basis = camera.basis();
    let r = [basis.u, -basis.v, -basis.n];
    (k, r, DVec3::from_array(r.map(|row| -row.dot(camera.position()))))
}

#[test]
fn k_and_t_are_handles() {
    let mut window = window(Lang::En, Explanation::Dialects);
    for (at, field, typed) in [(0, "K f_x", 700.0), (1, "K f_y", 650.0), (2, "K c_x", 300.5), (3, "K c_y", 210.25)] {
        let (mut expected, r, t) = k_r_t(&window);
        expected[at] = typed;
        window.enter(field, &typed.to_string());
        let now = k_r_t(&window);
        let same = now.0.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9 * b.abs());
        assert!(same && now.1 == r && now.2.abs_diff_eq(t, 1e-12), "{field}: {now:?}, not {expected:?}");
    }
    for (at, field, typed) in [(0, "t t_1", 1.5), (1, "t t_2", -0.75), (2, "t t_3", 8.0)] {
        let (k, r, mut t) = k_r_t(&window);
        t[at] = typed;
        window.enter(field, &typed.to_string());
        let now = k_r_t(&window);
        assert!(now.2.abs_diff_eq(t, 1e-12), "{field}: {}, not {t}", now.2);
        assert!(now.1.iter().zip(r).all(|(a, b)| a.abs_diff_eq(b, 1e-12)), "t doesn't turn the camera");
        assert!(now.0.iter().zip(k).all(|(a, b)| (a - b).abs() < 1e-9 * b), "nor does it change its lens");
    }
    // No focal length is negative: the reason is beside the field, and the camera stays.
    let before = window.state().model.desk.shown.camera().clone();
    window.enter("K f_x", "-3");
    assert!(window.says("greater than 0") && *window.state().model.desk.shown.camera() == before);
}

#[test]
fn an_entry_of_r_turns_the_camera() {
    let mut window = window(Lang::En, Explanation::Dialects);
    for (field, row, column, typed) in [("R r_11", 0, 0, 0.3), ("R r_23", 1, 2, -0.4), ("R r_31", 2, 0, 1.0)] {
        let (k, before, t) = k_r_t(&window);
        window.enter(field, &typed.to_string());
        let (k_after, r, t_after) = k_r_t(&window);
        assert!((r[row][column] - typed).abs() < 1e-12, "{field}: {}", r[row]);
        // R is a rotation, and the turn is the shortest: the trace of R R₀ᵀ is 1 + 2 cos of the change of its angle.
        assert!(r[0].cross(r[1]).abs_diff_eq(r[2], 1e-12));
        let trace: f64 = r.iter().zip(before).map(|(a, b)| a.dot(b)).sum();
        let turn = before[row][column].acos() - f64::acos(typed);
        assert!((trace - 1.0 - 2.0 * turn.cos()).abs() < 1e-9, "{field}: {trace}");
        assert!(t_after.abs_diff_eq(t, 1e-12) && k_after.iter().zip(k).all(|(a, b)| (a - b).abs() < 1e-9));
    }
    let before = window.state().model.desk.shown.camera().clone();
    window.enter("R r_22", "1.5");
    assert!(window.says("−1") && *window.state().model.desk.shown.camera() == before, "an entry is a cosine");
    window.key(Key::Escape);
}

#[test]
fn an_entry_is_dragged_in_one_step_and_lights_up_what_it_moves() {
    let mut window = window(Lang::En, Explanation::Dialects);
    for (field, measured) in [
        ("R r_33", Measured::Axis(2, 2)),
        ("t t_3", Measured::OriginAlong(2)),
        ("K f_x", Measured::Dimension(Measure::Width)),
        ("K c_y", Measured::Side(WindowSide::Top)),
    ] {
        let before = k_r_t(&window);
        let place = window.field(field).rect().center();
        window.drag(place, vec2(24.0, 0.0), |window| {
            assert!(window.state().model.frame.hover.measured.contains(&measured), "{field} lights {measured:?}");
        });
        assert_ne!(k_r_t(&window), before, "{field} moves the camera");
        window.command_key(Key::Z);
        assert_eq!(k_r_t(&window), before, "{field}: one drag is one step");
    }
}

/// `matrix_world` of the camera of Blender's default scene (`tests/it/other_programs.rs` names the source).
const BLENDER: &str = "<Matrix 4x4 (0.6859, -0.3240,  0.6516,  7.3589)\n            (0.7277,  0.3054, -0.6142, -6.9258)\n\
    (0.0000,  0.8954,  0.4453,  4.9583)\n            (0.0000,  0.0000,  0.0000,  1.0000)>";

/// B18.
#[test]
fn a_rigid_matrix_is_recognised_and_its_other_reading_is_one_click_away() {
    for (lang, said, instead, other, take) in [
        (
            Lang::En,
            "camera → world in the axes of Blender, nerfstudio: only then",
            "Read it as",
            "M_v: view",
            "Take this camera",
        ),
        (
            Lang::PtBr,
            "câmera → mundo nos eixos de Blender, nerfstudio: só assim",
            "Ler como",
            "M_v: vista",
            "Usar esta câmera",
        ),
    ] {
        let mut window = window(lang, Explanation::Dialects);
        window.app_mut().state.explain.pasted.text = BLENDER.to_owned();
        window.run();
        assert!(window.says(said) && window.says(instead));
        window.click(take);
        let position = window.state().model.desk.shown.camera().position();
        assert!(position.abs_diff_eq(DVec3::new(7.3589, 4.9583, 6.9258), 1e-9), "z was up: {position}");
        window.app_mut().state.explain.pasted.axes = Some(Axes::OPENGL);
        window.run();
        window.click(other);
        assert_eq!(window.state().explain.pasted.kind, Some(MatrixKind::View));
        window.click(take);
        // −Rᵀ t
        let position = window.state().model.desk.shown.camera().position();
        assert!(position.abs_diff_eq(DVec3::new(-0.0081, 0.0599, -11.2545), 1e-2), "{position}");
    }
}

/// B19.
#[test]
fn k_r_t_asks_for_its_image_and_leaves_the_clipping_planes() {
    let mut window = window(Lang::En, Explanation::Dialects);
    let before = *window.state().model.desk.shown.draft();
    window.app_mut().state.explain.pasted.text =
        "721.5377 0.0 609.5593 44.85728 0.0 721.5377 172.854 0.2163791 0.0 0.0 1.0 0.002745884".to_owned();
    window.run();
    assert!(window.says("Read as K [R | t]") && window.says("F and B are unknown"));
    assert!(window.says("f_x = 721.5") && window.says("c_y = 172.8"));
    window.enter("Image of the matrix m", "1242");
    window.enter("Image of the matrix n", "375");
    window.click(en::DIALECTS.take);
    let document = &window.state().model.desk.shown;
    assert_eq!((document.figure().image.width, document.figure().image.height), (1242, 375));
    let after = *document.draft();
    assert_eq!((after.near, after.far), (before.near, before.far));
    let pixels = after.window.unwrap();
    // c_x is left of the middle by 11.4 pixels.
    let share = -pixels.left / (pixels.right - pixels.left);
    assert!((share * 1242.0 - 609.5593).abs() < 1e-9, "{share}");
    window.command_key(Key::Z);
    assert_eq!(
        window.state().model.desk.shown.figure().image,
        camera_lab_desk::document::fresh().image,
        "one step for both"
    );
    assert_eq!(*window.state().model.desk.shown.draft(), before);
}

/// B20.
#[test]
fn the_words_of_computer_vision_switch_a_parallel_camera() {
    let mut window = window(Lang::En, Explanation::Dialects);
    let perspective = window.state().model.desk.shown.camera().clone();
    let parallel = perspective.with_projection(Projection::Parallel).unwrap();
    window.app_mut().state.model.desk.shown.set_camera(parallel);
    window.run();
    window.click(en::DIALECTS.to_perspective);
    let camera = window.state().model.desk.shown.camera();
    assert_eq!((camera.projection(), camera.window()), (Projection::Perspective, perspective.window()));
    window.enter("K f_x", "700");
    assert!(window.state().model.desk.shown.draft().window.is_some());
}

#[test]
fn code_is_for_the_camera_as_it_is() {
    let mut window = window(Lang::En, Explanation::Code);
    let code = |window: &Window| {
        let mut nodes = window.harness.get_all_by_label(en::EXPLAIN.code).filter_map(|node| node.value());
        nodes.find(|text| text.contains("gl")).unwrap_or_default()
    };
    let text = code(&window);
    assert!(text.contains("gluLookAt(") && text.contains("// angles in degrees"), "{text}");
    window.app_mut().state.explain.code = camera_lab::explain::code::CodeTarget::Glm;
    window.run();
    assert!(code(&window).contains("glm::lookAtRH"));
}

#[test]
fn a_file_with_several_cameras_has_a_list() {
    // Three images of COLMAP, each 4 from the origin: t is the same, the quaternions turn by 0°, 90° and 180° about y.
    let text = "1 PINHOLE 640 480 400 400 320 240\n\
        1 1 0 0 0 0 0 4 1 front.png\n\n\
        2 0.7071067811865476 0 0.7071067811865476 0 0 0 4 1 side.png\n\n\
        3 0 0 1 0 0 0 4 1 back.png\n\n";
    for (lang, words) in [(Lang::En, en::DIALECTS), (Lang::PtBr, pt::DIALECTS)] {
        let mut window = window(lang, Explanation::Dialects);
        window.app_mut().state.explain.pasted.text = text.to_owned();
        window.run();
        window.click(words.take);
        let front = window.state().model.desk.shown.camera().position();
        window.harness.get_by_role_and_label(Role::ComboBox, words.camera).click();
        window.run();
        window.click("back.png");
        assert_eq!(window.state().explain.pasted.camera, 2);
        window.click(words.take);
        let back = window.state().model.desk.shown.camera().position();
        assert!(front.length() > 3.9 && front.abs_diff_eq(-back, 1e-12), "{front} {back}");
        // One camera needs no list, and the number of the other text is no matter.
        window.app_mut().state.explain.pasted.text = BLENDER.to_owned();
        window.run();
        assert!(window.harness.query_by_role_and_label(Role::ComboBox, words.camera).is_none());
        assert_eq!(window.state().explain.pasted.camera, 0);
    }
}

/// Two cameras, each on a node of its own, the second one on an arm.
const GLTF: &str = include_str!("../common/two_cameras.gltf");

#[test]
fn all_cameras_of_a_gltf_file_become_those_of_the_figure_and_are_undone() {
    let mut window = window(Lang::En, Explanation::Dialects);
    let before = window.state().model.desk.shown.figure().clone();
    window.app_mut().state.explain.pasted.text = GLTF.to_owned();
    window.run();
    window.click(en::DIALECTS.take_all);
    let figure = window.state().model.desk.shown.figure();
    assert_eq!(figure.tag.name.as_deref(), Some("front"));
    assert_eq!((figure.camera.position, figure.camera.near), (DVec3::new(1.0, 2.0, 6.0), 0.25));
    let [arm] = &figure.cameras[..] else { panic!("{:?}", figure.cameras) };
    assert_eq!((arm.name.as_str(), arm.parameters.position), ("arm", DVec3::new(0.0, 1.0, 9.0)));
    assert_eq!((arm.parameters.projection, arm.parameters.height), (Projection::Parallel, 4.0));
    window.command_key(Key::Z);
    assert_eq!(*window.state().model.desk.shown.figure(), before);
}
