//! The panels at the sides: fields, repairs, operations, numbers, undo.

use camera_lab::camera::{Camera, Convention, Operation, Projection, ViewWindow};
use camera_lab::figure::Explanation;
use camera_lab::geometry::Angle;
use camera_lab::views::View;
use camera_lab_desk::message::Message;
use camera_lab_words::Lang;
use camera_lab_words::window::texts;
use eframe::egui::{Event, Key, Modifiers, OutputCommand, PointerButton, pos2, vec2};
use egui_kittest::kittest::{NodeT, Queryable};

use super::window::Window;
use crate::words::{en, pt};

#[test]
fn a_number_is_typed_and_undone() {
    let mut window = Window::new(Lang::En);
    window.enter("C x", "7.25");
    assert_eq!(window.state().model.desk.shown.figure().camera.position.x, 7.25);
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().camera.position.x, 3.0);
    window.command_key(Key::Y);
    assert_eq!(window.state().model.desk.shown.figure().camera.position.x, 7.25);
}

#[test]
fn tab_goes_from_field_to_field_and_commits() {
    let mut window = Window::new(Lang::En);
    window.type_into("C x", "1");
    for text in ["2", "6"] {
        window.key(Key::Tab);
        window.harness.event(Event::Text(text.to_owned()));
        window.run();
    }
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.draft().position.to_array(), [1.0, 2.0, 6.0]);
}

#[test]
fn a_complaint_does_not_take_the_focus_away() {
    let mut window = Window::new(Lang::En);
    window.type_into("F", "20");
    window.key(Key::Tab);
    assert!(window.says("F must be less than B"));
    window.harness.event(Event::Text("30".to_owned()));
    window.run();
    window.key(Key::Enter);
    assert_eq!(
        (window.state().model.desk.shown.draft().near, window.state().model.desk.shown.draft().far),
        (20.0, 30.0)
    );
    assert!(window.state().model.desk.shown.problem().is_none());
}

#[test]
fn expressions_are_evaluated_and_angles_are_degrees() {
    let mut window = Window::new(Lang::PtBr);
    window.enter("C y", "sqrt(2)/2");
    assert_eq!(window.state().model.desk.shown.draft().position.y, 2.0_f64.sqrt() / 2.0);
    window.enter("PF x", "1/3");
    assert_eq!(window.state().model.desk.shown.draft().focal_point.x, 1.0 / 3.0);
    window.enter("C z", "12,5");
    assert_eq!(window.state().model.desk.shown.draft().position.z, 12.5);
    window.enter("θ", "pi/3");
    assert_eq!(window.state().model.desk.shown.draft().view_angle, 60.0);
    window.enter("θ", "45°");
    assert_eq!(window.state().model.desk.shown.draft().view_angle, 45.0);
}

#[test]
fn escape_leaves_the_value_and_a_look_at_it_does_not_round_it() {
    let mut window = Window::new(Lang::En);
    let exact = 0.1 + 0.2;
    window.enter("C x", "0.1+0.2");
    window.type_into("C x", "99");
    window.key(Key::Escape);
    assert_eq!(window.state().model.desk.shown.draft().position.x, exact);
    window.field("C x").click();
    window.run();
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.draft().position.x, exact);
}

#[test]
fn a_faulty_text_that_stands_with_its_reason_goes_with_escape() {
    let mut window = Window::new(Lang::En);
    window.enter("F", "sqrt(");
    assert!(window.says("the expression is not finished"));
    window.key(Key::Escape);
    window.run();
    assert!(!window.says("the expression is not finished"));
    assert_eq!(window.state().model.desk.shown.draft().near, 3.0);
}

#[test]
fn a_faulty_text_stays_with_its_reason_until_it_is_mended() {
    let mut window = Window::new(Lang::En);
    window.enter("F", "1/0");
    assert!(window.says("the result is not a finite number"));
    assert_eq!(window.state().model.desk.shown.draft().near, 3.0);
    // The text is still there to be mended.
    window.field("F").click();
    window.run();
    window.key(Key::End);
    window.harness.event(Event::Text(".5".to_owned()));
    window.run();
    window.key(Key::Enter);
    assert_eq!(window.state().model.desk.shown.draft().near, 2.0);
    assert!(!window.says("the result is not a finite number"));
}

#[test]
fn the_value_of_an_expression_fits_on_one_line() {
    let mut window = Window::new(Lang::En);
    // As it is typed: the hint is a short one before, and a sentence later.
    window.type_into("θ", "1/2");
    for (typed, hint) in [("7", "= 0.037037037037037035°"), ("*x", "unknown name “x”")] {
        window.harness.event(Event::Text(typed.to_owned()));
        window.run();
        assert!(window.written().iter().any(|(line, _)| line == hint), "{hint}: {:?}", window.written());
    }
}

#[test]
fn arrow_keys_step_and_a_screen_reader_can_set() {
    let mut window = Window::new(Lang::En);
    window.field("θ").click();
    window.run();
    window.key(Key::ArrowUp);
    window.key(Key::ArrowUp);
    window.key(Key::ArrowDown);
    assert_eq!(window.state().model.desk.shown.draft().view_angle, 47.0);
    window.key(Key::Enter);
    window.field("B").set_value_accesskit(33.0);
    window.run();
    assert_eq!(window.state().model.desk.shown.draft().far, 33.0);
    window.field("B").increment_accesskit();
    window.run();
    assert!(window.state().model.desk.shown.draft().far > 33.0);
}

#[test]
fn a_drag_changes_a_number_in_one_undo_step() {
    let mut window = Window::new(Lang::En);
    let center = window.field("C x").rect().center();
    window.drag(center, vec2(80.0, 0.0), |window| {
        assert!(window.state().model.desk.shown.draft().position.x > 3.0);
    });
    let after = window.state().model.desk.shown.draft().position.x;
    assert!(after > 3.0);
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.draft().position.x, 3.0);
    assert!(!window.state().model.desk.can_undo(true));
    window.command_key(Key::Y);
    assert_eq!(window.state().model.desk.shown.draft().position.x, after);
}

#[test]
fn one_click_repairs_a_collinear_up_vector() {
    let mut window = Window::new(Lang::En);
    let before = window.state().model.desk.shown.figure().clone();
    window.enter("VUP x", "3");
    window.enter("VUP y", "4");
    window.enter("VUP z", "5");
    assert!(window.says("VUP must not be collinear"));
    // The last good picture stays: VUP = (3, 4, 0).
    assert_eq!(window.state().model.desk.shown.figure().camera.view_up.z, 0.0);
    assert_ne!(window.state().model.desk.shown.figure(), &before);
    window.click("VUP = (0, 1, 0)");
    assert!(window.state().model.desk.shown.problem().is_none());
    assert!(!window.says("VUP must not be collinear"));
    assert_eq!(window.state().model.desk.shown.figure().camera.view_up.to_array(), [0.0, 1.0, 0.0]);
}

#[test]
fn near_beyond_far_offers_to_swap_them() {
    let mut window = Window::new(Lang::PtBr);
    window.enter("F", "20");
    assert!(window.says("F tem de ser menor que B"));
    assert_eq!(window.state().model.desk.shown.figure().camera.near, 3.0);
    window.click(pt::WINDOW.repair_swap_near_far);
    assert_eq!(
        (window.state().model.desk.shown.draft().near, window.state().model.desk.shown.draft().far),
        (12.0, 20.0)
    );
    window.enter("θ", "200");
    assert!(window.says("θ tem de ser maior que 0° e menor que 180°"));
    window.click("θ = 45°");
    assert_eq!(window.state().model.desk.shown.figure().camera.view_angle, 45.0);
}

#[test]
fn a_problem_in_a_closed_section_shows_at_the_top() {
    let mut window = Window::new(Lang::En);
    window.enter("F", "20");
    window.click(en::WINDOW.projection);
    assert!(window.says("F must be less than B"));
    window.click(en::WINDOW.repair_swap_near_far);
    assert!(window.state().model.desk.shown.problem().is_none());
}

#[test]
fn projection_is_switched_both_ways_without_drift() {
    let mut window = Window::new(Lang::En);
    let before = *window.state().model.desk.shown.draft();
    window.click(en::WINDOW.parallel);
    let camera = window.state().model.desk.shown.camera().clone();
    assert_eq!(camera.projection(), Projection::Parallel);
    // An object that spans 2 D tan(θ/2) at PF spans H.
    let height = 2.0 * camera.distance() * (before.view_angle.to_radians() / 2.0).tan();
    assert!((camera.window().height() - height).abs() < 1e-12);
    window.field("H");
    for _ in 0..3 {
        window.click(en::WINDOW.perspective);
        window.click(en::WINDOW.parallel);
    }
    window.click(en::WINDOW.perspective);
    assert_eq!(window.state().model.desk.shown.draft().view_angle, before.view_angle);
}

#[test]
fn the_padlock_frees_the_window_and_closes_it_again() {
    let mut window = Window::new(Lang::En);
    window.click(en::WINDOW.aspect_follows);
    let before = *window.state().model.desk.shown.draft();
    let size = window.state().model.desk.shown.camera().window();
    window.click(en::WINDOW.symmetric);
    assert_eq!(window.state().model.desk.shown.draft().window, Some(size));
    window.click(en::WINDOW.symmetric);
    assert_eq!(*window.state().model.desk.shown.draft(), before);
    window.click(en::WINDOW.symmetric);
    window.enter("r, right", "5");
    let free = window.state().model.desk.shown.draft().window.expect("free");
    assert_eq!(free, ViewWindow { right: 5.0, ..size });
    window.enter("l, left", "6");
    assert!(window.says("l must be less than r"));
    window.click(en::WINDOW.repair_sides);
    assert_eq!(window.state().model.desk.shown.draft().window.map(|w| (w.left, w.right)), Some((5.0, 6.0)));
    window.click(en::WINDOW.symmetric);
    let after = window.state().model.desk.shown.camera().window();
    assert!((after.width() - 1.0).abs() < 1e-12 && (after.left + after.right).abs() < 1e-12);
}

#[test]
fn the_padlock_stays_under_the_pointer() {
    for projection in [Projection::Perspective, Projection::Parallel] {
        let mut window = Window::new(Lang::En);
        let camera = window.state().model.desk.shown.camera().with_projection(projection).expect("a camera");
        window.app_mut().state.model.desk.shown.set_camera(camera);
        window.run();
        let place = |window: &Window| window.harness.get_by_label(en::WINDOW.symmetric).rect();
        let before = place(&window);
        for _ in 0..2 {
            window.click(en::WINDOW.symmetric);
            assert_eq!(place(&window), before, "{projection:?}");
        }
    }
}

#[test]
fn a_right_click_on_a_point_copies_and_follows_it() {
    let mut window = Window::new(Lang::PtBr);
    window.enter("C x", "0,1");
    let mut choose = |entry: &str| {
        let at = window.harness.get_by_label("C y").rect().center();
        window.harness.hover_at(at);
        window.run();
        for pressed in [true, false] {
            let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
            window.harness.event(Event::PointerButton { pos: at, button, pressed, modifiers });
        }
        window.run();
        window.harness.get_by_label(entry).click();
        window.harness.step();
        let commands = &window.harness.output().platform_output.commands;
        let copied = commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
        window.run();
        copied
    };
    assert_eq!(choose("Copiar C").as_deref(), Some("0,1 4 5"));
    choose("Seguir C");
    let state = window.state();
    assert_eq!(state.model.explained.shown(), Explanation::Point);
    assert_eq!(state.model.desk.shown.figure().points[0].position.to_array(), [0.1, 4.0, 5.0]);
}

#[test]
fn the_aspect_follows_the_image_until_the_user_unlinks_it() {
    let mut window = Window::new(Lang::En);
    window.enter("m", "1536");
    assert_eq!(window.state().model.desk.shown.draft().aspect, 2.0);
    window.click(en::WINDOW.aspect_follows);
    window.enter("m", "768");
    assert_eq!(window.state().model.desk.shown.draft().aspect, 2.0);
    window.enter("A", "16/9");
    assert_eq!(window.state().model.desk.shown.draft().aspect, 16.0 / 9.0);
}

#[test]
fn an_operation_turns_the_camera_by_its_step() {
    let mut window = Window::new(Lang::En);
    window.enter("Azimuth: step", "90");
    window.click("Azimuth +");
    // C = (3, 4, 5) looks at the origin, so u = (5, 0, −3)/√34. Its distance stays.
    let camera = window.state().model.desk.shown.camera().clone();
    assert!((camera.distance() - 50.0_f64.sqrt()).abs() < 1e-12);
    assert!((camera.position().dot(glam::DVec3::new(3.0, 4.0, 5.0))).abs() < 1e-12, "{}", camera.position());
    for _ in 0..3 {
        window.click("Azimuth +");
    }
    assert_eq!(window.state().model.desk.shown.draft().position.to_array(), [3.0, 4.0, 5.0]);
    for _ in 0..4 {
        window.command_key(Key::Z);
    }
    assert!(!window.state().model.desk.can_undo(true));
}

#[test]
fn a_slider_scrubs_from_where_the_camera_is_and_springs_back() {
    let mut window = Window::new(Lang::En);
    let before = *window.state().model.desk.shown.draft();
    let slider = window.harness.get_by_label("Elevation: slider").rect();
    window.drag(slider.center(), vec2(slider.width() / 8.0, 0.0), |window| {
        let ghost = window.state().model.frame.hover.ghost.as_ref().expect("a ghost while it is held");
        assert_eq!(*ghost.before.parameters(), before);
        assert_ne!(*window.state().model.desk.shown.draft(), before);
    });
    assert!(window.state().model.frame.hover.ghost.is_none());
    let after = *window.state().model.desk.shown.draft();
    assert_eq!(after.focal_point, before.focal_point);
    assert_ne!(after.position, before.position);
    let slider = window.harness.get_by_label("Elevation: slider");
    assert_eq!(slider.accesskit_node().numeric_value(), Some(0.0));
    window.command_key(Key::Z);
    assert_eq!(*window.state().model.desk.shown.draft(), before);
    assert!(!window.state().model.desk.can_undo(true));
}

#[test]
fn one_operation_is_open_with_its_slider() {
    let mut window = Window::new(Lang::En);
    let t = texts(Lang::En);
    let sliders = |window: &Window| {
        let names = [t.elevation, t.azimuth, t.roll, t.yaw, t.pitch, t.zoom, t.dolly, t.pan_u, t.pan_v];
        names.into_iter().filter(|name| window.says(&format!("{name}: {}", t.scrub))).collect::<Vec<_>>()
    };
    assert_eq!(sliders(&window), [t.elevation]);
    window.click(t.azimuth);
    assert_eq!(sliders(&window), [t.azimuth]);
    assert!(window.says(t.azimuth_effect));
}

/// An operation that was done is kept, a next one continues from it, and one that doesn't is kept alone.
#[test]
fn operations_are_kept_in_the_figure() {
    let mut window = Window::new(Lang::En);
    window.app_mut().state.model.settings.reduce_motion = true;
    let t = texts(Lang::En);
    let shown = |window: &mut Window| {
        let figure = window.app_mut().state.model.figure_as_shown();
        figure.show.operations.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    window.click(t.azimuth);
    assert!(window.harness.get_by_label(t.keep_operation).accesskit_node().is_disabled());
    for name in [t.azimuth, t.zoom] {
        window.click(name);
        window.click(&format!("{name} +"));
        window.click(t.keep_operation);
    }
    assert_eq!(shown(&mut window), ["azimuth=15", "zoom=1.25"]);
    assert!(window.says("Azimuth 15° · Zoom × 1.25"));
    // Another camera has no such way. A message says so, and undoing brings both back.
    window.enter("C x", "7");
    assert!(shown(&mut window).is_empty() && window.says(t.operations_gone));
    window.command_key(Key::Z);
    assert_eq!(shown(&mut window), ["azimuth=15", "zoom=1.25"]);
    window.enter("C x", "7");
    window.click(t.roll);
    window.click("Roll −");
    window.click(t.keep_operation);
    assert_eq!(shown(&mut window), ["roll=-15"]);
    window.harness.get_by_label(t.take_out).click();
    window.run();
    assert!(shown(&mut window).is_empty());
}

/// The numbers are folded at first, and stay as they were left.
#[test]
fn the_numbers_fold() {
    let mut window = Window::new(Lang::En);
    assert!(!camera_lab::gui::State::new(Default::default()).expect("a possible camera").model.settings.numbers_open);
    assert!(window.says(en::WINDOW.digits));
    window.click(en::WINDOW.numbers);
    assert!(!window.says(en::WINDOW.digits) && !window.state().model.settings.numbers_open);
}

/// A symbol is a link to its reference page.
#[test]
fn a_click_on_a_symbol_opens_its_page() {
    let mut window = Window::new(Lang::En);
    window.harness.get_by_label("VUP").click();
    window.run();
    assert!(window.state().model.shows_explanation(Explanation::Notes));
}

#[test]
fn the_signs_of_vtk_turn_elevation_the_other_way() {
    let mut one = Window::new(Lang::En);
    one.click("Elevation −");
    let mut other = Window::new(Lang::En);
    other.more(en::WINDOW.vtk);
    other.harness.get_by_label(en::WINDOW.vtk).click_accesskit();
    other.run();
    other.click("Elevation +");
    assert_eq!(one.state().model.desk.shown.draft(), other.state().model.desk.shown.draft());
}

#[test]
fn numbers_are_those_of_the_report_with_as_many_digits_as_asked_for() {
    let mut window = Window::new(Lang::En);
    let camera = window.state().model.desk.shown.camera().clone();
    assert!(window.says("7.0711"));
    window.enter(en::WINDOW.digits, "17");
    assert!(window.says(&camera.distance().to_string()));
    assert!(window.says(&camera.basis().u.x.to_string().replace('-', "−")));
    window.click(en::WINDOW.inverse);
    assert!(window.says(en::WINDOW.inverse_view_name));
    let inverse = camera.view_from_clip().to_cols_array_2d()[0][0];
    assert!(window.says(&inverse.to_string()));
}

#[test]
fn bounds_stand_below_each_table_of_numbers() {
    for (lang, t, proved) in
        [(Lang::En, en::WINDOW, "15 digits proved"), (Lang::PtBr, pt::WINDOW, "15 dígitos provados")]
    {
        let mut window = Window::new(lang);
        assert!(!window.says(proved));
        window.click(t.bounds);
        // √50 and its neighbour.
        let ends = lang.mark().printed("7.071067811865475 … 7.0710678118654755");
        assert!(window.says(&format!("D, 1: {ends}")), "D");
        assert!(window.says(proved));
        window.click(t.bounds);
        assert!(!window.says(proved));
    }
}

#[test]
fn reset_brings_the_camera_of_the_file_back_and_can_be_undone() {
    let mut window = Window::new(Lang::En);
    window.enter("C x", "1");
    window.enter("θ", "20");
    window.menu(en::WINDOW.menu_edit, "Reset the camera");
    assert_eq!(window.state().model.desk.shown.draft().position.x, 3.0);
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.draft().view_angle, 20.0);
}

#[test]
fn a_number_of_pixels_that_cannot_be_stays_as_it_was_typed_with_its_reason() {
    let mut window = Window::new(Lang::En);
    let image = window.state().model.desk.shown.figure().image;
    for (text, reason) in [
        ("0", "must be between 1 and 16384"),
        ("20000", "must be between 1 and 16384"),
        ("-3", "must be between 1 and 16384"),
        ("10.5", "must be a whole number"),
    ] {
        window.enter("m", text);
        assert!(window.says(reason), "{text}");
        assert_eq!(window.state().model.desk.shown.figure().image, image, "{text}");
        window.key(Key::Escape);
        assert!(!window.says(reason), "{text}");
    }
    window.enter("m", "16384");
    assert_eq!(window.state().model.desk.shown.figure().image.width, 16_384);
    // Steps end at the bounds of the numbers.
    window.field("m").increment_accesskit();
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().image.width, 16_384);
    window.field("m").set_value_accesskit(99_999.0);
    window.run();
    assert!(window.says("must be between 1 and 16384"));
    assert_eq!(window.state().model.desk.shown.figure().image.width, 16_384);
}

#[test]
fn impossible_digits_and_steps_show_their_range() {
    let mut window = Window::new(Lang::PtBr);
    window.enter(pt::WINDOW.digits, "18");
    assert!(window.says("tem de estar entre 2 e 17"));
    assert_eq!(window.state().model.settings.digits, 5);
    window.key(Key::Escape);
    window.enter(pt::WINDOW.digits, "17");
    assert_eq!(window.state().model.settings.digits, 17);
    window.enter("Azimute: passo", "0");
    assert!(window.says("tem de ser maior que 0"));
}

#[test]
fn the_numbers_are_those_of_the_camera_and_not_of_its_rounded_parameters() {
    let mut window = Window::new(Lang::En);
    window.enter(en::WINDOW.digits, "17");
    for _ in 0..5 {
        window.click("Azimuth +");
    }
    let camera = window.state().model.desk.shown.camera().clone();
    assert!(window.says(&camera.basis().u.x.to_string().replace("-", "−")));
    assert!(window.says(&camera.distance().to_string()));
}

#[test]
fn an_impossible_export_size_is_refused_and_nothing_is_written() {
    use eframe::egui::accesskit::Role;
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    window.harness.get_by_role_and_label(Role::ComboBox, "size").click();
    window.run();
    window.click(en::WINDOW.export_typed);
    window.enter(en::WINDOW.export_width, "0");
    assert!(window.says("must be between 1 and 16384"));
    window.click(en::WINDOW.export_action);
    assert!(
        window.says(en::WINDOW.export_heading) && window.says("must be between 1 and 16384"),
        "the question stands"
    );
    window.enter(en::WINDOW.export_width, "64");
    assert!(!window.says("must be between 1 and 16384"));
}

#[test]
fn too_large_a_multiple_of_the_screen_is_refused_not_reduced() {
    use camera_lab::gui::app::file_flow::questions::Dialog;
    use camera_lab::gui::export::Export;
    let mut window = Window::new(Lang::En);
    window.command_key(Key::E);
    let mut export = Export::new([[9000, 100]; 3], 1.0);
    assert_eq!([export.width, export.height], [54_000, 200], "in proportion");
    export.times = None;
    window.app_mut().state.file_flow.dialog = Some(Dialog::Export(export));
    window.run();
    assert!(window.says("must be between 1 and 16384"));
    window.click(en::WINDOW.export_action);
    assert!(window.says(en::WINDOW.export_heading), "the question stands");
}

/// The operation that was just done is open, and no row moves under the pointer.
#[test]
fn a_step_opens_the_row_of_its_operation() {
    let mut window = Window::new(Lang::En);
    let t = en::WINDOW;
    let at = |window: &Window| window.harness.get_by_label("Azimuth +").rect().center();
    let place = at(&window);
    window.quick_click(place);
    let slider = format!("{}: {}", t.azimuth, t.scrub);
    assert!(window.harness.query_by_label(&slider).is_some(), "{slider}");
    assert_eq!(at(&window), place);
    // Nor when the pointer has gone and comes back for the next step.
    window.harness.hover_at(pos2(640.0, 400.0));
    window.run();
    assert_eq!(at(&window), place);
    let keep = window.harness.query_all_by_label(t.keep_operation).last().expect("that of the azimuth");
    keep.click();
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().show.operations.len(), 1);
}

#[test]
fn a_step_moves_smoothly_ends_exactly_and_is_one_change() {
    let mut window = Window::new(Lang::En);
    let camera = |window: &Window| window.state().model.desk.shown.camera().clone();
    let start = camera(&window);
    let step = |camera: &Camera| {
        Operation::Azimuth(Angle::from_degrees(15.0)).apply(camera, Convention::RightHand).expect("a camera")
    };
    let click = |window: &mut Window| {
        window.harness.get_by_label("Azimuth +").click();
        window.harness.step();
    };
    click(&mut window);
    assert_eq!(camera(&window), start, "it begins");
    window.run();
    assert_eq!(camera(&window), step(&start));
    // A key pressed on the way finds the camera at its goal: two steps, two changes.
    click(&mut window);
    click(&mut window);
    window.run();
    assert_eq!(camera(&window), step(&step(&step(&start))));
    for expected in [step(&step(&start)), step(&start), start.clone()] {
        window.command_key(Key::Z);
        assert_eq!(camera(&window), expected);
    }
    assert!(!window.state().model.desk.can_undo(true));
    // If motion is to be reduced, the camera is there at once.
    window.app_mut().state.model.settings.reduce_motion = true;
    click(&mut window);
    assert_eq!(camera(&window), step(&start));
}

#[test]
fn a_step_of_a_button_is_shown_in_the_world_for_two_seconds() {
    let mut window = Window::new(Lang::En);
    let start = window.state().model.desk.shown.camera().clone();
    let now = |window: &Window| window.harness.ctx.input(|input| input.time);
    let ghost = |window: &Window| window.state().model.frame.hover.ghost.as_ref().map(|ghost| ghost.before.clone());
    let begun = now(&window);
    window.harness.get_by_label("Azimuth +").click();
    // Away from the row, which has a ghost of its own.
    window.harness.hover_at(pos2(640.0, 500.0));
    window.run();
    assert_ne!(*window.state().model.desk.shown.camera(), start);
    let done = now(&window);
    while now(&window) < begun + 1.7 {
        window.harness.step();
        assert_eq!(ghost(&window).as_ref(), Some(&start), "after {} s", now(&window) - begun);
    }
    while now(&window) < done + 2.3 {
        window.harness.step();
    }
    assert_eq!(ghost(&window), None);
}

#[test]
fn a_slider_of_angles_stops_at_five_degrees_and_is_free_with_ctrl() {
    for (free, modifiers) in [(false, Modifiers::NONE), (true, Modifiers::COMMAND)] {
        let mut window = Window::new(Lang::En);
        let start = window.state().model.desk.shown.camera().clone();
        let slider = window.harness.get_by_label("Elevation: slider").rect();
        let mut between = 0;
        for share in [0.031, 0.047, 0.059, 0.083, 0.101, 0.117] {
            window.harness.event(Event::ModifiersChanged(modifiers));
            window.drag(slider.center(), vec2(share * slider.width(), 0.0), |window| {
                let place = |camera: &Camera| (camera.position() - camera.parameters().focal_point).normalize();
                let turned = place(&start).angle_between(place(window.state().model.desk.shown.camera())).to_degrees();
                assert!(turned > 4.9, "{turned}°");
                between += i32::from((turned / 5.0 - (turned / 5.0).round()).abs() > 0.01);
            });
            window.harness.event(Event::ModifiersChanged(Modifiers::NONE));
            window.command_key(Key::Z);
            assert_eq!(*window.state().model.desk.shown.camera(), start);
        }
        assert_eq!(between > 2, free, "{between} of six between the stops");
        assert!(free || between == 0);
    }
}

#[test]
fn a_held_slider_keeps_the_scale_and_release_fits_once_and_says_so() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = Window::new(lang);
        window.app_mut().state.model.layout.maximized = Some(View::World);
        window.app_mut().state.model.settings.reduce_motion = true;
        window.run();
        let seen = |window: &Window| window.state().model.frame.seen.world.expect("an observer");
        let first = seen(&window);
        let t = texts(lang);
        window.click(t.dolly);
        let slider = window.harness.get_by_label(&format!("{}: {}", t.dolly, t.scrub)).rect();
        let said = |window: &Window| matches!(window.state().model.message, Some(Message::WentBack(View::World)));
        window.drag(slider.center(), vec2(-0.4 * slider.width(), 0.0), |window| {
            assert!(!said(window), "the scale stays in the hand");
            assert_eq!(seen(window), first);
        });
        assert!(said(&window), "{:?}", window.state().model.message);
        let back = seen(&window);
        assert!(back.distance > 1.5 * first.distance, "{} {}", back.distance, first.distance);
        assert_eq!((back.azimuth, back.elevation), (first.azimuth, first.elevation));
        window.command_key(Key::Z);
        assert_eq!(seen(&window), first, "what was seen comes back with the camera");
    }
}
