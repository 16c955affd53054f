//! A point that is followed: typed in each of its spaces, dragged, picked, undone, explained if it has no image.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::camera::{Parameters, Place};
use camera_lab::explain::{Notation, Setting, Style, forward};
use camera_lab::figure::Explanation;
use camera_lab::figure::{Figure, NamedPoint, ShownProbe};
use camera_lab::scene::{ObjectSpec, Shape};
use camera_lab::views::{Probe, image_frame, pick};
use camera_lab_desk::scene_tree::Selected;
use camera_lab_words::Lang;
use eframe::egui::{Key, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::{DVec2, DVec3};

use super::canvas::{IMAGE, Stage, WORLD, place, stage, world};
use super::window::Window;
use crate::words::en;

const P: DVec3 = DVec3::new(0.5, 1.0, 1.5);

fn followed(figure: &mut Figure, position: DVec3) {
    figure.points = vec![NamedPoint { name: "P".to_owned(), position }];
}

/// A window with the tab, and a point at `p`.
fn window(lang: Lang, p: DVec3) -> Window {
    let mut window = Window::new(lang);
    let state = &mut window.app_mut().state;
    state.model.desk.shown.set_parameters(Parameters { near: 2.0, far: 12.0, ..Parameters::default() });
    state.model.desk.shown.edit(|figure| followed(figure, p));
    state.model.desk.commit();
    state.model.settings.panels.wanted = [false, false, true];
    state.model.explained.show(Explanation::Point);
    window.run();
    window
}

fn position(window: &Window) -> DVec3 {
    window.state().model.desk.shown.figure().points[0].position
}

#[test]
fn typed_in_any_space_the_point_goes_where_it_has_these_coordinates() {
    for (field, text, of) in [
        ("world x", "0.25", 0),
        ("view z_c", "-4", 1),
        ("NDC z_n", "0.5", 2),
        ("window −z_c", "sqrt(16)", 3),
        ("pixel j", "300", 4),
    ] {
        let mut window = window(Lang::En, P);
        let figure = window.state().model.desk.shown.figure().clone();
        let camera = window.state().model.desk.shown.camera().clone();
        let space = camera.notes_clip_space();
        let viewport = figure.viewport.unwrap_or(camera_lab::camera::Viewport::whole(figure.image));
        let before = space.stations(P, figure.image, &viewport);
        let projected = before.projected.unwrap();
        let place = match of {
            0 => Place::World(P.with_x(0.25)),
            1 => Place::View(before.view.with_z(-4.0)),
            2 => Place::Ndc(projected.ndc.with_z(0.5)),
            3 => Place::Window(projected.window, 4.0),
            #[expect(clippy::cast_possible_truncation, reason = "a pixel")]
            _ => Place::Pixel([projected.pixel.x as i64, 300], projected.viewport.z),
        };
        let expected = space.world_of(figure.image, &viewport, place).unwrap();
        window.enter(field, text);
        assert!(position(&window).abs_diff_eq(expected, 1e-12), "{field}: {} not {expected}", position(&window));
        window.command_key(Key::Z);
        assert_eq!(position(&window), P, "{field}");
    }
}

/// One point has one set of coordinates.
#[test]
fn a_probe_pinned_on_a_point_goes_with_it_and_another_one_stays() {
    for (pinned, goes) in [(P, true), (P + DVec3::X, false)] {
        let mut window = window(Lang::En, P);
        window.app_mut().state.model.desk.shown.show_mut().probe = Some(ShownProbe::World(pinned));
        window.run();
        window.enter("world x", "0.25");
        let probe = window.state().model.desk.shown.figure().show.probe;
        assert_eq!(probe, Some(ShownProbe::World(if goes { P.with_x(0.25) } else { pinned })));
    }
}

#[test]
fn impossible_coordinates_are_refused_with_the_allowed_range() {
    for (lang, field, message) in
        [(Lang::En, "NDC z_n", "no point of the world is that far"), (Lang::PtBr, "NDC z_n", "nenhum ponto do mundo")]
    {
        let mut window = window(lang, P);
        // z_n reaches (B + F)/(B − F) = 2 at infinity.
        let parameters = Parameters { near: 2.0, far: 6.0, ..Parameters::default() };
        window.app_mut().state.model.desk.shown.set_parameters(parameters);
        window.run();
        window.enter(field, "2");
        assert!(window.says(message));
        assert_eq!(position(&window), P);
        window.enter(field, if lang == Lang::En { "0.5" } else { "0,5" });
        assert!(!window.says(message));
        assert_ne!(position(&window), P);
    }
    let mut window = window(Lang::En, P);
    window.enter("window −z_c", "0");
    assert!(window.says("in the plane of the eye no point has an image; allowed: any other distance"));
}

#[test]
fn ndc_beyond_infinity_are_those_of_a_point_behind_the_eye() {
    for (lang, behind, no_pixel) in [
        (Lang::En, "w < 0, so the point is behind the eye", "points behind the eye. Clipping stops those"),
        (Lang::PtBr, "w < 0, logo o ponto está atrás do olho", "pontos atrás do olho. O recorte os detém"),
    ] {
        let mut window = window(lang, P);
        assert!(!window.says(behind));
        window.enter("NDC z_n", "5");
        let p = position(&window);
        let camera = window.state().model.desk.shown.camera().clone();
        // z_n = (B + F)/(B − F) − 2BF/((B − F) distance), with F = 2 and B = 12.
        assert!((1.4 - 4.8 / -camera.view_point(p).z - 5.0).abs() < 1e-12 && camera.view_point(p).z > 0.0);
        assert!(window.says(behind));
        // It has no pixel, and the panel says so.
        window.enter("pixel i", "100");
        assert!(window.says(no_pixel));
        assert_eq!(position(&window), p);
        window.enter("NDC x_n", if lang == Lang::En { "0.25" } else { "0,25" });
        assert!(!window.says(no_pixel) && position(&window) != p, "its other coordinates are typed too");
        assert!((camera.view_point(position(&window)).z - camera.view_point(p).z).abs() < 1e-12);
    }
}

#[test]
fn a_local_coordinate_is_typed_in_the_space_of_the_selected_object() {
    let mut window = window(Lang::En, P);
    assert!(window.harness.query_by_label("local x_o").is_none(), "no object is selected");
    let object = ObjectSpec::new("box", Shape::Box).at(2.0, 0.0, 0.0).turned(0.0, 0.0, 90.0).scaled(2.0, 1.0, 1.0);
    let state = &mut window.app_mut().state;
    state.model.desk.shown.edit(|figure| figure.scene.objects = vec![object]);
    state.model.tree.select(Some(Selected::Object("box".to_owned())));
    window.run();
    // Scaled by 2 along x, turned from x to y, moved by 2: (x, y, z) is at (2 − y, 2 x, z).
    for (field, text) in [("local x_o", "1"), ("local y_o", "-1/2"), ("local z_o", "3")] {
        window.enter(field, text);
    }
    let p = position(&window);
    assert!(p.abs_diff_eq(DVec3::new(2.5, 2.0, 3.0), 1e-12), "{p}");
    window.command_key(Key::Z);
    assert!(position(&window).abs_diff_eq(DVec3::new(2.5, 2.0, 1.5), 1e-12), "one step for each");
}

#[test]
fn the_arithmetic_that_is_shown_is_that_of_the_trace() {
    let window = window(Lang::En, P);
    let state = window.state();
    let figure = state.model.desk.shown.figure();
    let setting = Setting::new(state.model.desk.shown.camera().notes_clip_space(), figure.image, figure.viewport);
    let setting = setting.with_point(P);
    let style = Style { notation: Notation::Text, mark: Lang::En.mark(), digits: state.model.settings.digits };
    for step in forward(&setting) {
        for line in step.lines(&setting, style) {
            assert!(window.says(&format!("{} = {}", line.symbol, line.formula)), "{line:?}");
            assert!(window.says(&format!("= {}", line.numbers)), "{line:?}");
            assert!(window.says(&format!("= {}", line.value)), "{line:?}");
        }
    }
    assert!(window.says("world → view   (5.7)") && window.says("pixel → window   (5.23)"));
}

#[test]
fn behind_the_eye_and_in_its_plane_the_point_is_explained() {
    let camera = window(Lang::En, P).state().model.desk.shown.camera().clone();
    let (c, basis) = (camera.position(), camera.basis());
    for (lang, behind, in_plane, back) in [
        (Lang::En, "w < 0, so the point is behind the eye", "w = 0, so the point is in the plane of the eye", "Back"),
        (Lang::PtBr, "w < 0, logo o ponto está atrás do olho", "w = 0, logo o ponto está no plano do olho", "Volta"),
    ] {
        assert!(window(lang, P).says(back));
        let shown = window(lang, c + 2.0 * basis.n + basis.u);
        assert!(shown.says(behind) && !shown.says(in_plane) && !shown.says(back));
        let shown = window(lang, c + 3.0 * basis.u);
        assert!(shown.says(in_plane) && !shown.says(behind) && !shown.says("(5.6)   "));
    }
}

#[test]
fn points_are_added_renamed_and_deleted_and_each_is_a_step() {
    let mut window = window(Lang::En, P);
    window.click(en::EXPLAIN_POINT.add);
    let names = |window: &Window| -> Vec<String> {
        window.state().model.desk.shown.figure().points.iter().map(|point| point.name.clone()).collect()
    };
    assert_eq!(names(&window), ["P", "Q"]);
    assert_eq!(window.state().model.desk.shown.figure().points[1].position, DVec3::ZERO, "at PF");
    let rename = |window: &mut Window, text: &str| {
        window.click(en::EXPLAIN_POINT.name);
        window.harness.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::A);
        window.harness.event(eframe::egui::Event::Text(text.to_owned()));
        window.run();
        window.key(Key::Enter);
    };
    rename(&mut window, "P");
    assert!(window.says(en::EXPLAIN_POINT.name_taken));
    assert_eq!(names(&window), ["P", "Q"]);
    rename(&mut window, "corner");
    assert_eq!(names(&window), ["P", "corner"]);
    window.click(en::EXPLAIN_POINT.delete);
    assert_eq!(names(&window), ["P"]);
    for expected in [vec!["P", "corner"], vec!["P", "Q"], vec!["P"]] {
        window.command_key(Key::Z);
        assert_eq!(names(&window), expected);
    }
}

/// The place of a point in the image of the stage.
fn in_image(h: &Harness<'_, Stage>, p: DVec3) -> Pos2 {
    let rect = place(h, IMAGE);
    let camera = h.state().state.model.desk.shown.camera();
    let frame = image_frame(world(h, rect).size, camera.window().aspect());
    let clip = camera.clip_point(p);
    let share = DVec2::new(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
    let inside = DVec2::new(f64::from(frame.width), f64::from(frame.height)) * share;
    rect.min + vec2((f64::from(frame.x) + inside.x) as f32, (f64::from(frame.y) + inside.y) as f32)
}

#[test]
fn a_point_is_dragged_in_the_image_at_its_distance_and_esc_puts_it_back() {
    let mut h = stage(|state| state.model.desk.shown.edit(|figure| followed(figure, P)));
    let camera = h.state().state.model.desk.shown.camera().clone();
    let goal = P + camera.basis().u * 0.4 - camera.basis().v * 0.3;
    let (from, to) = (in_image(&h, P), in_image(&h, goal));
    let now = |h: &Harness<'_, Stage>| h.state().state.model.desk.shown.figure().points[0].position;
    for gives_up in [false, true] {
        let before = now(&h);
        let (from, to) = if gives_up { (to, from) } else { (from, to) };
        h.hover_at(from);
        h.run();
        assert_eq!(h.state().state.model.frame.probe, Some(Probe::Point(before)));
        h.drag_at(from);
        h.run();
        h.hover_at(to);
        h.run();
        let moved = now(&h);
        assert!((camera.view_point(moved).z - camera.view_point(P).z).abs() < 1e-12, "its distance stays");
        if gives_up {
            h.key_press(Key::Escape);
            h.run();
            assert_eq!(now(&h), before);
        } else {
            assert!(moved.distance(goal) < 0.05, "{moved} is not {goal}");
        }
        h.drop_at(to);
        h.run();
    }
}

#[test]
fn a_point_is_dragged_in_the_world_at_its_distance_from_the_eye() {
    let mut h = stage(|state| state.model.desk.shown.edit(|figure| followed(figure, P)));
    let in_world = |h: &Harness<'_, Stage>, p: DVec3| {
        let rect = place(h, WORLD);
        let at = pick::places(&world(h, rect)).unwrap()(p).unwrap();
        rect.min + vec2(at.x as f32, at.y as f32)
    };
    let camera = h.state().state.model.desk.shown.camera().clone();
    let goal = P + camera.basis().u * 0.8 + camera.basis().v * 0.5;
    let (from, to) = (in_world(&h, P), in_world(&h, goal));
    for at in [from, to] {
        h.hover_at(at);
        h.run();
        if at == from {
            h.drag_at(at);
            h.run();
        }
    }
    h.drop_at(to);
    h.run();
    let moved = h.state().state.model.desk.shown.figure().points[0].position;
    assert!((camera.view_point(moved).z - camera.view_point(P).z).abs() < 1e-9, "its distance stays");
    assert!(moved.distance(goal) < 0.05, "{moved} is not {goal}");
}

#[test]
fn a_pinned_vertex_is_followed_from_its_card() {
    let mut h = stage(|_| ());
    let camera = h.state().state.model.desk.shown.camera().clone();
    let scene = h.state().state.model.scene_cache.scene().clone();
    let object = &scene.objects[0];
    let corners = object.mesh.positions.iter().map(|&p| object.world_from_object.transform_point3(p));
    let corner =
        corners.min_by(|a, b| a.distance(camera.position()).total_cmp(&b.distance(camera.position()))).unwrap();
    // Pinned as the keys do it.
    let at = in_image(&h, corner);
    h.hover_at(at);
    h.run();
    h.drag_at(at);
    h.drop_at(at);
    h.run();
    if !matches!(h.state().state.model.frame.probe, Some(Probe::Point(_))) {
        panic!("{:?}", h.state().state.model.frame.probe);
    }
    h.get_by_label(en::EXPLAIN_POINT.follow).click();
    h.run();
    let state = &h.state().state;
    assert_eq!(state.model.desk.shown.figure().points, [NamedPoint { name: "P".to_owned(), position: corner }]);
    assert_eq!((state.model.explained.shown(), state.model.settings.panels.wanted[2]), (Explanation::Point, true));
}
