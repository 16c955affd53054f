//! The side of explanations: reached and read by keyboard, every entry answered, changed and dependent entries marked.

use camera_lab::camera::{Camera, ImageSize, Parameters, Projection, ViewWindow, Viewport};
use camera_lab::explain::Matrix;
use camera_lab::figure::{Explanation, Measure, Measured, NamedPoint};
use camera_lab::gui::{LaunchOptions, Start, State};
use camera_lab::numbers::{DecimalMark, without_rests};
use camera_lab::scene;
use camera_lab_desk::explained::matrices::{Matrices, Reading};
use camera_lab_desk::layout::{Side, Tab};
use camera_lab_desk::scene_tree::Selected;
use camera_lab_words::Lang;
use camera_lab_words::why::explain::texts;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect, Shape};
use egui_kittest::kittest::{NodeT, Queryable};
use glam::{DMat4, DVec3};

use super::files::Folder;
use super::window::{Window, names};
use crate::words::en;

fn explaining(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    toggle(&mut window);
    window
}

fn toggle(window: &mut Window) {
    window.harness.key_press_modifiers(Modifiers::ALT, Key::E);
    window.run();
}

fn with_camera(window: &mut Window, change: impl FnOnce(&mut Parameters)) {
    let document = &mut window.app_mut().state.model.desk.shown;
    let mut parameters = *document.draft();
    change(&mut parameters);
    document.set_parameters(parameters);
    window.run();
}

fn focused(window: &Window) -> Option<String> {
    let node = window.harness.query_by(|node| node.is_focused())?;
    node.accesskit_node().label()
}

/// How many filled rectangles and lines are painted within a place.
fn painted(window: &Window, place: Rect) -> usize {
    fn count(shape: &Shape, place: Rect) -> usize {
        match shape {
            Shape::Rect(rect) => usize::from(place.expand(0.5).contains_rect(rect.rect)),
            Shape::LineSegment { points, .. } => usize::from(points.iter().all(|p| place.expand(0.5).contains(*p))),
            Shape::Vec(shapes) => shapes.iter().map(|shape| count(shape, place)).sum(),
            _ => 0,
        }
    }
    window.harness.output().shapes.iter().map(|clipped| count(&clipped.shape, place)).sum()
}

fn entry(window: &Window, begins: &str) -> Rect {
    window.harness.get_by_label_contains(begins).rect()
}

#[test]
fn alt_e_shows_explanations_in_the_place_of_the_numbers_and_takes_them_away_again() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = Window::new(lang);
        let shown = |window: &Window, side| window.state().model.settings.panels().is_shown(side);
        assert!(shown(&window, Side::Right) && !shown(&window, Side::Explain), "off at the start");
        toggle(&mut window);
        assert!(!shown(&window, Side::Right) && shown(&window, Side::Explain));
        assert!(window.harness.query_by_label(texts(lang).matrices).is_some());
        toggle(&mut window);
        assert!(shown(&window, Side::Right) && !shown(&window, Side::Explain));
        assert!(window.harness.query_by_label(texts(lang).matrices).is_none());
        // F9 asks for the numbers, whatever stands in their place.
        toggle(&mut window);
        window.key(Key::F9);
        assert!(shown(&window, Side::Right) && !shown(&window, Side::Explain));
    }
}

#[test]
fn a_focused_entry_shows_formula_and_value_and_lights_up_the_world() {
    let mut window = explaining(Lang::PtBr);
    with_camera(&mut window, |camera| {
        camera.view_angle = 90.0;
        (camera.near, camera.far, camera.aspect) = (1.0, 4.0, 1.0);
    });
    window.harness.get_by_label_contains("M_p, linha 3, coluna 3").focus();
    window.run();
    assert_eq!(window.state().model.explained.matrices.entry, [2, 2]);
    for said in ["M_p_33 = −(B + F)/(B − F)", "= −(4 + 1)/(4 − 1)", "= −5/3 ≈ −1,6667"] {
        assert!(window.harness.query_by_label(said).is_some(), "{said}");
    }
    let lit = window.state().model.frame.hover.measured.clone();
    assert_eq!(lit, [Measured::Dimension(Measure::Far), Measured::Dimension(Measure::Near)]);
    // With the keyboard on to the next entry, and to a symbol that is made of others.
    window.key(Key::Tab);
    assert_eq!(window.state().model.explained.matrices.entry, [2, 3]);
    window.key(Key::ArrowDown);
    assert_eq!(window.state().model.explained.matrices.entry, [3, 3]);
    // At the border of the matrix the keyboard stays, and each press is one step.
    window.key(Key::ArrowRight);
    window.key(Key::ArrowDown);
    assert_eq!(window.state().model.explained.matrices.entry, [3, 3]);
    for (key, entry) in [(Key::ArrowLeft, [3, 2]), (Key::ArrowUp, [2, 2]), (Key::ArrowRight, [2, 3])] {
        window.key(key);
        assert_eq!(window.state().model.explained.matrices.entry, entry);
    }
    window.harness.get_by_label_contains("M_p, linha 1, coluna 1").focus();
    window.run();
    window.key(Key::ArrowLeft);
    assert_eq!(window.state().model.explained.matrices.entry, [0, 0]);
    window.run();
    window.harness.get_by_label("W = 8/3 ≈ 2,6667").focus();
    window.run();
    assert_eq!(window.state().model.frame.hover.measured, [Measured::Dimension(Measure::Width)]);
    window.key(Key::Enter);
    assert!(window.harness.query_by_label("W = AH").is_some(), "(5.1)");
    window.click("H = 2");
    assert!(window.harness.query_by_label("H = 2 F tan(θ/2)").is_some(), "(5.5)");
    assert!(window.harness.query_by_label("θ = 90°").is_some(), "down to the parameter");
}

/// The program's matrices, each from the camera itself.
fn matrix_of(window: &Window, matrix: Matrix) -> DMat4 {
    let camera: &Camera = window.state().model.desk.shown.camera();
    match matrix {
        Matrix::View => camera.view_from_world(),
        Matrix::InverseView => camera.world_from_view(),
        Matrix::Projection => camera.notes_clip_space().clip_from_view(),
        Matrix::InverseProjection => camera.notes_clip_space().view_from_clip(),
        Matrix::ViewProjection => camera.notes_clip_space().clip_from_world(),
        Matrix::InverseViewProjection => camera.world_from_view() * camera.notes_clip_space().view_from_clip(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn every_entry_in_every_projection_answers_with_its_value() {
    let mut window = explaining(Lang::En);
    let free = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
    for (projection, sides) in
        [(Projection::Perspective, None), (Projection::Perspective, free), (Projection::Parallel, free)]
    {
        with_camera(&mut window, |camera| {
            camera.position = DVec3::new(3.0, 4.0, 5.0);
            (camera.projection, camera.window) = (projection, sides);
        });
        for matrix in Matrices::CHOICES[1..4].iter().flat_map(|matrix| [*matrix, matrix.inverse()]) {
            let rows = matrix_of(&window, matrix).transpose().to_cols_array_2d();
            let clean = matches!(matrix, Matrix::View | Matrix::InverseView);
            for (row, values) in rows.iter().enumerate() {
                let values = if clean { without_rests(values, 5) } else { values.to_vec() };
                for (column, value) in values.into_iter().enumerate() {
                    let shown = &mut window.app_mut().state.model.explained.matrices;
                    shown.inverse = matrix.text().contains('⁻');
                    shown.matrix = if shown.inverse { matrix.inverse() } else { matrix };
                    shown.entry = [row, column];
                    shown.reading = Reading::Values;
                    window.harness.step();
                    let number = DecimalMark::Point.number(value + 0.0, 5);
                    let what = format!("{}, row {}, column {}", matrix.text(), row + 1, column + 1);
                    // name = value, = value, or name = fraction ≈ value
                    let ends = [format!("= {number}"), format!("≈ {number}")];
                    let said = window.harness.query_all_by(|node| {
                        node.role() == Role::Label
                            && node.value().is_some_and(|l| ends.iter().any(|end| l.ends_with(end)))
                    });
                    assert!(said.count() > 0, "{what}: {number} ({projection:?}, {sides:?})");
                    assert!(window.harness.query_by_label_contains(&format!("{what}: ")).is_some(), "{what}");
                }
            }
        }
    }
}

#[test]
fn changed_entries_glow_and_then_painting_stops() {
    let mut window = explaining(Lang::En);
    let [first, last] = ["M_p, row 1, column 1:", "M_p, row 4, column 4:"].map(|begins| entry(&window, begins));
    window.app_mut().state.model.explained.matrices.entry = [0, 1];
    window.run();
    let before = [painted(&window, first), painted(&window, last)];
    let document = &mut window.app_mut().state.model.desk.shown;
    document.set_parameters(Parameters { view_angle: 50.0, ..*document.draft() });
    window.harness.step();
    window.harness.step();
    let glowing = [painted(&window, first), painted(&window, last)];
    assert_eq!(glowing, [before[0] + 1, before[1]], "2F/W has changed, 0 has not");
    for _ in 0..200 {
        window.harness.step();
    }
    assert_eq!([painted(&window, first), painted(&window, last)], before);
    let delay = window.harness.output().viewport_output.values().map(|output| output.repaint_delay).min();
    assert!(delay.is_some_and(|delay| delay.as_secs() > 5), "idle: {delay:?}");
}

#[test]
fn dependent_entries_are_marked_while_a_parameters_field_has_focus() {
    let mut window = explaining(Lang::En);
    let places = ["row 1, column 1", "row 2, column 2", "row 3, column 3", "row 4, column 3"]
        .map(|place| entry(&window, &format!("M_p, {place}:")));
    let count = |window: &Window| places.map(|place| painted(window, place));
    let before = count(&window);
    window.field("B").focus();
    window.run();
    let marked: Vec<bool> = count(&window).iter().zip(before).map(|(now, before)| *now > before).collect();
    assert_eq!(marked, [false, false, true, false], "B is in the third row alone");
    window.field("θ").focus();
    window.run();
    let marked: Vec<bool> = count(&window).iter().zip(before).map(|(now, before)| *now > before).collect();
    assert_eq!(marked, [true, true, false, false], "θ through H, and W = A H");
}

#[test]
fn a_number_in_the_panel_of_numbers_leads_to_its_reason_without_a_mouse_too() {
    for by_keyboard in [false, true] {
        let mut usual = Window::new(Lang::En);
        let state = &mut usual.app_mut().state;
        let another = State::new(Start::default()).expect("a possible camera");
        // So high that all numbers are in sight.
        let mut window = Window::with_state(std::mem::replace(state, another), [1280.0, 1400.0]);
        with_camera(&mut window, |camera| (camera.near, camera.far) = (1.0, 4.0));
        let number = "M_p, row 3, column 3: −1.6667";
        if by_keyboard {
            window.harness.get_by_label(number).focus();
            window.run();
            window.key(Key::Enter);
        } else {
            window.click(number);
        }
        window.run();
        assert!(window.state().model.settings.panels().is_shown(Side::Explain));
        assert_eq!(window.state().model.explained.matrices.entry, [2, 2]);
        assert_eq!(focused(&window).as_deref(), Some("M_p, row 3, column 3: −(B + F)/(B − F)"));
    }
    // Of transposed matrices, the entry that is shown. Of u, v, n, the row of M_v.
    let mut window = Window::new(Lang::En);
    window.app_mut().state.model.settings.conventions.row_vectors = true;
    window.run();
    let label = window.harness.query_all_by_label_contains("M_p, row 4, column 3: ").next().map(|node| node.rect());
    let other = window.harness.query_all_by_label_contains("M_p, row 3, column 4: ").next().map(|node| node.rect());
    assert!(label.expect("it is there").center().x > other.expect("it is there").center().x, "a column to the right");
}

#[test]
fn a_matrix_is_copied_as_latex_and_as_text() {
    let mut window = explaining(Lang::En);
    let copied = |window: &Window| {
        window.harness.output().platform_output.commands.iter().find_map(|command| match command {
            eframe::egui::OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        })
    };
    for (button, begins, within) in [
        (texts(Lang::En).copy_latex, r"\mathbf{M}_p = \begin{bmatrix}", r"\frac{2 F}{W} & 0 & 0 & 0 \\"),
        (texts(Lang::En).copy_text, "M_p\n2F/W\t0\t0\t0\n", "−(B + F)/(B − F)\t−2BF/(B − F)"),
    ] {
        window.harness.get_by_label(button).click();
        window.harness.step();
        let text = copied(&window).expect("a copy");
        assert!(text.starts_with(begins) && text.contains(within), "{text}");
    }
}

#[test]
fn m_m_is_that_of_the_object_that_is_selected() {
    let mut window = explaining(Lang::PtBr);
    window.click("M_m");
    assert!(window.says("é a matriz de um objeto"));
}

/// A window with the matrix of a box that hangs on nothing.
fn with_object(lang: Lang) -> Window {
    let mut window = explaining(lang);
    let object = scene::ObjectSpec::new("box", scene::Shape::Box)
        .at(2.0, 0.0, -1.0)
        .turned(0.0, 30.0, 0.0)
        .scaled(1.0, 2.0, 3.0);
    let state = &mut window.app_mut().state;
    state.model.desk.shown.edit(|figure| figure.scene.objects = vec![object]);
    state.model.tree.select(Some(Selected::Object("box".to_owned())));
    state.model.settings.tab = Tab::Scene;
    window.run();
    window.click("M_m");
    window
}

#[test]
fn the_entries_of_m_m_light_up_translation_rotation_and_scale() {
    let mut window = with_object(Lang::En);
    for (place, lit) in [
        ("row 1, column 4", vec![Measured::Translate(0)]),
        ("row 3, column 4", vec![Measured::Translate(2)]),
        ("row 3, column 1", vec![Measured::Rotate(1), Measured::Scale(0)]),
    ] {
        window.harness.get_by_label_contains(&format!("M_m, {place}:")).focus();
        window.run();
        let mut found = window.state().model.frame.hover.measured.clone();
        found.sort_by_key(|measured| format!("{measured:?}"));
        assert_eq!(found, lit, "{place}");
    }
    // A symbol of an entry lights up alone.
    window.harness.get_by_label("s_x = 1").focus();
    window.run();
    assert_eq!(window.state().model.frame.hover.measured, [Measured::Scale(0)]);
}

#[test]
fn fields_of_an_object_mark_dependent_entries_and_light_up_the_world() {
    let mut window = with_object(Lang::PtBr);
    let t = camera_lab_words::window::scenes::texts(Lang::PtBr);
    let places = ["linha 1, coluna 1", "linha 2, coluna 2", "linha 2, coluna 4", "linha 4, coluna 4"]
        .map(|place| entry(&window, &format!("M_m, {place}:")));
    let count = |window: &Window| places.map(|place| painted(window, place));
    let before = count(&window);
    for (name, marks, lit) in [
        (t.translate, [false, false, true, false], Measured::Translate(0)),
        (t.rotate, [true, true, false, false], Measured::Rotate(0)),
        (t.scale, [true, true, false, false], Measured::Scale(0)),
    ] {
        let name = format!("{name} y");
        window.field(&name).focus();
        window.run();
        let marked = [0, 1, 2, 3].map(|i| count(&window)[i] > before[i]);
        assert_eq!(marked, marks, "{name}");
        assert_eq!(window.state().model.frame.hover.measured.first(), Some(&lit));
        let at = window.field(&name).rect().center();
        window.harness.get_by_label("M_m").focus();
        window.run();
        assert_eq!(count(&window), before, "{name}");
        window.harness.hover_at(at);
        window.run();
        assert_eq!([0, 1, 2, 3].map(|i| count(&window)[i] > before[i]), marks, "{name}, under the pointer");
        window.harness.hover_at(eframe::egui::Pos2::ZERO);
        window.run();
    }
}

#[test]
fn the_fields_of_image_and_viewport_mark_dependent_entries() {
    let mut window = explaining(Lang::En);
    window.click("M_vp");
    let places = ["row 1, column 1", "row 2, column 2", "row 3, column 3"]
        .map(|place| entry(&window, &format!("M_vp, {place}:")));
    let count = |window: &Window| places.map(|place| painted(window, place));
    let before = count(&window);
    let marked = |window: &Window| [0, 1, 2].map(|i| count(window)[i] > before[i]);
    window.field("m").focus();
    window.run();
    assert_eq!(marked(&window), [true, true, false], "the viewport is the whole image");
    let viewport = Viewport { width: 300, ..Viewport::whole(ImageSize::default()) };
    window.app_mut().state.model.desk.shown.edit(|figure| figure.viewport = Some(viewport));
    window.run();
    window.harness.get_by_label("M_vp").focus();
    window.run();
    window.more(en::WINDOW.viewport);
    window.field("W_v").focus();
    window.run();
    assert_eq!(marked(&window), [true, true, false]);
    window.field("n (Z)").focus();
    window.run();
    assert_eq!(marked(&window), [false, false, true]);
    window.field("m").focus();
    window.run();
    assert_eq!(marked(&window), [false, false, false], "the viewport is its own");
}

#[test]
fn an_entry_says_where_it_is_used_on_the_way_of_a_point() {
    let mut window = explaining(Lang::En);
    assert!(!window.says("it appears in the sum of"), "no point is followed");
    let point = NamedPoint { name: "A".to_owned(), position: DVec3::new(0.5, 1.0, 0.25) };
    window.app_mut().state.model.desk.shown.edit(|figure| figure.points.push(point));
    window.run();
    assert!(window.says("for A it appears in the sum of x_r, in the term"));
}

#[test]
fn a_matrix_without_an_inverse_says_so_in_the_place_of_numbers_that_are_none() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = explaining(lang);
        let viewport = Viewport { depth_near: 0.5, depth_far: 0.5, ..Viewport::whole(ImageSize::default()) };
        window.app_mut().state.model.desk.shown.edit(|figure| figure.viewport = Some(viewport));
        window.app_mut().state.model.explained.matrices.matrix = Matrix::Viewport;
        window.app_mut().state.model.explained.matrices.inverse = true;
        window.run();
        assert!(window.says(texts(lang).no_inverse) && !window.says("NaN") && !window.says("inf"));
    }
}

#[test]
fn each_question_reopens_where_you_left_it_also_in_the_next_window() {
    let folder = Folder::new("questions");
    let keeping = || {
        let mut window = Window::new(Lang::En);
        let ctx = window.harness.ctx.clone();
        let options = LaunchOptions { lang: Some(Lang::En), ..LaunchOptions::default() };
        window.app_mut().keep_preferences(&ctx, &folder.file("config"), options);
        window.run();
        window
    };
    let left = [Explanation::Point, Explanation::Triangle, Explanation::Code, Explanation::Notes];
    let mut window = keeping();
    for explanation in left.into_iter().rev() {
        window.explain(explanation);
    }
    eframe::App::on_exit(window.app_mut(), None);
    let mut next = keeping();
    assert!(next.state().model.shows_explanation(Explanation::Point), "the one that was open");
    for explanation in left {
        let [question, _] = names(Lang::En, explanation);
        let named = next.harness.get_all_by_label(question).filter(|node| node.rect().top() > 26.0);
        named.max_by(|a, b| a.rect().left().total_cmp(&b.rect().left())).expect("a question").click();
        next.run();
        assert!(next.state().model.shows_explanation(explanation), "{explanation:?}");
    }
}
