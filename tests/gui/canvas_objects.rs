//! The selection of the scene in the pictures: its arrows, its mark, and the click that selects it.

#![expect(clippy::unwrap_used, clippy::cast_possible_truncation, reason = "tests; places on a small screen")]

use camera_lab::gui::State;
use camera_lab::scene::{Light, LightKind, ObjectSpec, Preset, Shape};
use camera_lab::views::transform_gizmo::part_at;
use camera_lab::views::{GizmoPart, Hover, Request, TransformGizmo, Transforming, pick};
use camera_lab_desk::scene_tree::Selected;
use eframe::egui::{Key, Modifiers, PointerButton, Pos2, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::{DVec2, DVec3};

use super::canvas::{Stage, WORLD, drag, place, stage, world};
use crate::words::en;

/// A turned group with a cone in it that is selected, and a lamp.
fn with_cone(state: &mut State) {
    state.model.desk.shown.edit(|figure| {
        figure.scene.preset = Preset::Empty;
        figure.scene.objects = vec![
            ObjectSpec::group("group").at(1.0, 0.0, 1.0).turned(0.0, 90.0, 0.0).scaled(2.0, 2.0, 2.0),
            ObjectSpec::new("cone", Shape::Cone).at(0.5, 0.5, 0.25).under("group"),
        ];
        figure.scene.lights = vec![Light::point(DVec3::new(0.0, 3.0, 0.0))];
    });
    state.model.tree.select(Some(Selected::Object("cone".to_owned())));
}

fn gizmo(does: Transforming, origin: DVec3, axes: [DVec3; 3]) -> TransformGizmo {
    TransformGizmo { does, origin, axes, hovered: None }
}

/// A place in the world picture that grabs this part of an axis.
fn on_axis(harness: &Harness<Stage>, gizmo: TransformGizmo, axis: usize) -> Pos2 {
    let rect = place(harness, WORLD);
    let hover = Hover { gizmo: Some(gizmo), ..Hover::default() };
    let world = Request { hover, ..world(harness, rect) };
    let found = {
        let columns = (0..rect.width() as u32).step_by(3);
        let mut places = columns.flat_map(|x| (0..rect.height() as u32).step_by(3).map(move |y| (x, y)));
        places.find(|&(x, y)| {
            let at = DVec2::new(f64::from(x), f64::from(y));
            part_at(&world, at, 2.0) == Some(GizmoPart::Axis(axis))
        })
    };
    let (x, y) = found.unwrap();
    rect.min + vec2(x as f32, y as f32)
}

#[test]
fn an_arrow_moves_the_selection_along_one_parent_axis_in_one_step() {
    let mut h = stage(with_cone);
    h.state_mut().state.model.desk.commit();
    let undoable = h.state().state.model.desk.can_undo(true);
    // The group's x is the world's −z, its z the world's x.
    let arrows = gizmo(Transforming::Move, DVec3::new(1.5, 1.0, 0.0), [DVec3::NEG_Z, DVec3::Y, DVec3::X]);
    let cone = |h: &Harness<Stage>| h.state().state.model.desk.shown.figure().scene.objects[1].translate;
    let before = cone(&h);
    let from = on_axis(&h, arrows, 1);
    drag(&mut h, from, vec2(0.0, -30.0), PointerButton::Primary, Modifiers::NONE);
    let after = cone(&h);
    assert!(after.y > before.y && after.x == before.x && after.z == before.z, "{before} {after}");
    // Tidy: no more digits than pixels.
    assert_eq!(after.y, (after.y * 1000.0).round() / 1000.0);
    assert!(h.state().state.model.desk.can_undo(true));
    h.state_mut().state.model.desk.undo(true);
    h.run();
    assert_eq!((cone(&h), h.state().state.model.desk.can_undo(true)), (before, undoable));

    h.hover_at(from);
    h.run();
    assert!(h.query_all_by_label_contains(en::SCENES.drag_object).next().is_some());
}

#[test]
fn the_selected_object_is_marked_and_a_lamp_is_moved_too() {
    let mut h = stage(with_cone);
    h.state_mut().state.model.desk.commit();
    let drawn = h.state().canvas.drawn();
    h.state_mut().state.model.tree.select(Some(Selected::Light(0)));
    h.run();
    assert!(h.state().canvas.drawn().iter().zip(drawn).all(|(now, before)| *now == before + 1), "all three, once");
    let arrows = gizmo(Transforming::Move, DVec3::Y * 3.0, DVec3::AXES);
    let from = on_axis(&h, arrows, 0);
    drag(&mut h, from, vec2(25.0, 0.0), PointerButton::Primary, Modifiers::NONE);
    let Light { kind: LightKind::Point, vector: lamp, .. } = h.state().state.model.desk.shown.figure().scene.lights[0]
    else {
        panic!("a lamp")
    };
    assert!(lamp.x != 0.0 && lamp.y == 3.0 && lamp.z == 0.0, "{lamp}");
    // Selecting is no change of the figure.
    h.state_mut().state.model.desk.undo(true);
    h.state_mut().state.model.tree.select(None);
    h.run();
    let Light { kind: LightKind::Point, vector: lamp, .. } = h.state().state.model.desk.shown.figure().scene.lights[0]
    else {
        panic!("a lamp")
    };
    assert_eq!(lamp, DVec3::Y * 3.0);
}

#[test]
fn a_click_on_an_object_selects_it_while_the_tree_is_open() {
    let mut h = stage(with_cone);
    h.state_mut().state.model.tree.select(None);
    h.run();
    // The cone is at (1.5, 1 … 5, 0) and 4 wide.
    let rect = place(&h, WORLD);
    let world = world(&h, rect);
    let at = {
        let screen_center = DVec2::new(f64::from(rect.width()) / 2.0, f64::from(rect.height()) / 2.0);
        (0..400)
            .map(|i| screen_center + DVec2::new(f64::from(i % 20) * 6.0 - 60.0, f64::from(i / 20) * 6.0 - 60.0))
            .find(|p| pick::object(&world, *p).as_deref() == Some("cone"))
            .unwrap()
    };
    let at = rect.min + vec2(at.x as f32, at.y as f32);
    let click = |h: &mut Harness<Stage>| {
        drag(h, at, Vec2::ZERO, PointerButton::Primary, Modifiers::NONE);
        h.run();
    };
    let selected = |h: &Harness<Stage>| {
        h.state().state.model.tree.selected(&h.state().state.model.desk.shown.figure().scene).cloned()
    };
    click(&mut h);
    assert_eq!(selected(&h), None, "the tree is not open");
    h.state_mut().state.model.settings.tab = camera_lab_desk::layout::Tab::Scene;
    // Not as a double-click.
    for _ in 0..20 {
        h.step();
    }
    click(&mut h);
    assert_eq!(selected(&h), Some(Selected::Object("cone".to_owned())));
}

#[test]
fn a_ring_turns_and_a_bar_scales_the_selection_with_steps_on_a_key() {
    let mut h = stage(with_cone);
    h.state_mut().state.model.desk.commit();
    let cone = |h: &Harness<Stage>| h.state().state.model.desk.shown.figure().scene.objects[1].clone();
    let before = cone(&h);
    let origin = DVec3::new(1.5, 1.0, 0.0);
    let axes = [DVec3::NEG_Z, DVec3::Y, DVec3::X];

    // The keys of the world choose the transform.
    h.get_by_label_contains(WORLD).focus();
    h.run();
    h.key_press(Key::R);
    h.run();
    let from = on_axis(&h, gizmo(Transforming::Turn, origin, axes), 1);
    drag(&mut h, from, vec2(23.0, 17.0), PointerButton::Primary, Modifiers::COMMAND);
    let turned = cone(&h).rotate;
    assert!(turned.y != 0.0 && turned.y % 15.0 == 0.0 && turned.x == 0.0 && turned.z == 0.0, "{turned}");
    assert_eq!((cone(&h).translate, cone(&h).scale), (before.translate, before.scale));
    let state = &mut h.state_mut().state;
    state.learn.undo(&mut state.model, true);
    h.run();
    assert_eq!(cone(&h), before, "one step");

    h.key_press(Key::S);
    h.run();
    let from = on_axis(&h, gizmo(Transforming::Scale, origin, axes), 1);
    drag(&mut h, from, vec2(0.0, -25.0), PointerButton::Primary, Modifiers::NONE);
    let scaled = cone(&h).scale;
    assert!(scaled.y > 1.0 && scaled.x == 1.0 && scaled.z == 1.0, "{scaled}");
    // Esc gives it back, in the middle of a pull.
    h.hover_at(from);
    h.run();
    h.key_press(Key::T);
    h.run();
    assert!(h.query_all_by_label_contains(en::SCENES.drag_object).next().is_some());
}

#[test]
fn objects_that_are_selected_together_go_together() {
    let mut h = stage(|state| {
        with_cone(state);
        state.model.desk.shown.edit(|figure| {
            figure.scene.objects.push(ObjectSpec::new("ball", Shape::Sphere).at(-2.0, 0.0, 0.0));
        });
        let also = ["ball".to_owned()].into();
        state.model.tree.select_all(Some(Selected::Object("cone".to_owned())), also);
    });
    h.state_mut().state.model.desk.commit();
    let places = |h: &Harness<Stage>| {
        let objects = &h.state().state.model.desk.shown.figure().scene.objects;
        (objects[1].translate, objects[2].translate)
    };
    let before = places(&h);
    let from = on_axis(&h, gizmo(Transforming::Move, DVec3::new(1.5, 1.0, 0.0), [DVec3::NEG_Z, DVec3::Y, DVec3::X]), 1);
    drag(&mut h, from, vec2(0.0, -30.0), PointerButton::Primary, Modifiers::NONE);
    let after = places(&h);
    // The cone's group makes everything twice as large.
    let (cone, ball) = (after.0 - before.0, after.1 - before.1);
    assert!(cone.y > 0.0 && (ball - cone * 2.0).length() < 1e-9, "{cone} {ball}");
    let state = &mut h.state_mut().state;
    state.learn.undo(&mut state.model, true);
    h.run();
    assert_eq!(places(&h), before);
    assert_eq!(
        h.state().state.model.tree.names(&h.state().state.model.desk.shown.figure().scene).len(),
        2,
        "still selected"
    );
}

#[test]
fn parallel_light_is_turned_by_rings() {
    let mut h = stage(|state| {
        with_cone(state);
        state
            .model
            .desk
            .shown
            .edit(|figure| figure.scene.lights = vec![Light::directional(DVec3::new(0.0, -1.0, 0.0))]);
        state.model.tree.select(Some(Selected::Light(0)));
    });
    let middle = h.state().state.model.scene_cache.scene().bounds().unwrap().center();
    let from = on_axis(&h, gizmo(Transforming::Turn, middle, DVec3::AXES), 0);
    drag(&mut h, from, vec2(30.0, 20.0), PointerButton::Primary, Modifiers::COMMAND);
    let Light { kind: LightKind::Directional, vector: d, .. } =
        h.state().state.model.desk.shown.figure().scene.lights[0]
    else {
        panic!("parallel")
    };
    let angle = d.y.atan2(d.z).to_degrees();
    assert!(d.x.abs() < 1e-12 && d != DVec3::NEG_Y && (angle / 15.0 - (angle / 15.0).round()).abs() < 1e-9, "{d}");
    assert!((d.length() - 1.0).abs() < 1e-11);
}

#[test]
fn turns_of_the_view_are_gone_back_through() {
    let mut h = stage(with_cone);
    let observers = |h: &Harness<Stage>| h.state().state.model.desk.shown.figure().observers;
    let before = observers(&h);
    let rect = place(&h, WORLD);
    let corner = rect.min + vec2(8.0, 30.0);
    drag(&mut h, corner, vec2(40.0, 10.0), PointerButton::Primary, Modifiers::NONE);
    let turned = observers(&h);
    assert_ne!(turned, before);
    let views = &mut h.state_mut().state.model.views;
    views.reset(before);
    assert!(views.can_go(turned, true) && !views.can_go(turned, false));
    assert_eq!(views.go(turned, true), Some(before));
    assert_eq!(views.go(before, false), Some(turned));
}
