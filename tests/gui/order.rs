//! The order of transforms: the list, its two readings, another order beside it, and its effect on the figure.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::explain::order::{Call, Reading, product};
use camera_lab::figure::Explanation;
use camera_lab::figure::Figure;
use camera_lab::gui::{Start, State};
use camera_lab::scene::edit::placements;
use camera_lab::scene::{ObjectSpec, Preset, Shape};
use camera_lab::views::View;
use camera_lab_words::Lang;
use camera_lab_words::why::order::texts;
use eframe::egui::{Key, Modifiers, Vec2};
use egui_kittest::kittest::{NodeT, Queryable as _};
use glam::{DMat4, DVec3};

use super::window::Window;
use crate::words::en;

/// A window that shows the tab, with a box below a moved group.
fn window(lang: Lang, selected: Option<&str>) -> Window {
    let mut figure = camera_lab_desk::document::fresh();
    figure.scene.preset = Preset::Empty;
    figure.style.antialias = camera_lab::appearance::Samples::One;
    figure.scene.objects = vec![
        ObjectSpec::group("arm").at(0.0, 1.0, 0.0),
        ObjectSpec::new("box", Shape::Box).at(2.0, 0.0, 0.0).turned(0.0, 90.0, 0.0).scaled(1.0, 2.0, 3.0).under("arm"),
    ];
    let mut state =
        State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
    state.model.layout.maximized = Some(View::World);
    let selected = selected.map(|name| camera_lab_desk::scene_tree::Selected::Object(name.to_owned()));
    state.model.tree.select(selected);
    // So high that nothing has to be scrolled.
    let mut window = Window::with_state(state, [900.0, 1300.0]);
    window.explain(Explanation::Order);
    window
}

fn calls(window: &Window) -> Vec<Call> {
    window.state().explain.order.calls()
}

fn symbols(window: &Window) -> Vec<&'static str> {
    calls(window).iter().map(|call| call.symbol()).collect()
}

fn alt(window: &mut Window, key: Key) {
    window.harness.key_press_modifiers(Modifiers::ALT, key);
    window.run();
}

/// The places of the object by the list and by the other order.
fn placed(window: &Window) -> Vec<DMat4> {
    window.state().model.frame.placed.iter().map(|placed| placed.world_from_frame).collect()
}

#[test]
fn the_list_begins_with_the_objects_own_transform_and_is_reordered_by_keyboard() {
    let mut window = window(Lang::En, Some("box"));
    assert_eq!(symbols(&window), ["T", "R_z", "R_y", "R_x", "S"]);
    assert_eq!(calls(&window)[2], Call::RotateY(90.0));
    let before = window.state().model.desk.shown.figure().clone();
    window.harness.get_by_label("Step 3: R_y").focus();
    window.run();
    alt(&mut window, Key::ArrowUp);
    alt(&mut window, Key::ArrowUp);
    assert_eq!(symbols(&window), ["R_y", "T", "R_z", "R_x", "S"]);
    assert!(window.harness.get_by_label("Step 1: R_y").is_focused(), "the keyboard goes with it");
    alt(&mut window, Key::ArrowUp);
    assert_eq!(symbols(&window)[0], "R_y", "the first one stays");
    // From a field of the row too, whose number stays.
    window.field("S x").click();
    window.run();
    alt(&mut window, Key::ArrowUp);
    assert_eq!(symbols(&window), ["R_y", "T", "R_z", "S", "R_x"]);
    assert_eq!(calls(&window)[3], Call::Scale(DVec3::new(1.0, 2.0, 3.0)));
    window.key(Key::Escape);
    window.click("Later 4");
    assert_eq!(symbols(&window), ["R_y", "T", "R_z", "R_x", "S"]);
    // Numbers are edited, calls added and removed.
    window.enter("T x", "5");
    assert_eq!(calls(&window)[1], Call::Translate(DVec3::new(5.0, 0.0, 0.0)));
    window.click("+ Add");
    window.click("rotate about z");
    assert_eq!(calls(&window).last(), Some(&Call::RotateZ(30.0)));
    window.click("Remove 6");
    assert_eq!(calls(&window).len(), 5);
    let after = Figure { show: before.show.clone(), ..window.state().model.desk.shown.figure().clone() };
    assert_eq!(after, before, "nothing of it is in the figure but what is shown");
    window.click(en::ORDER.again);
    assert_eq!(symbols(&window), ["T", "R_z", "R_y", "R_x", "S"]);
}

#[test]
fn a_call_is_dragged_by_its_dots() {
    let mut window = window(Lang::En, Some("box"));
    let [first, fourth] = ["Step 1: T", "Step 4: R_x"].map(|name| window.harness.get_by_label(name).rect());
    let from = first.left_center() + Vec2::new(8.0, 0.0);
    let way = Vec2::new(0.0, fourth.center().y - first.center().y + 4.0);
    window.drag(from, way, |window| assert_eq!(symbols(window)[0], "T", "until it is let go"));
    assert_eq!(symbols(&window), ["R_z", "R_y", "R_x", "T", "S"]);
}

#[test]
fn taking_over_is_in_sight_in_a_small_window_also_when_the_list_is_scrolled() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut figure = camera_lab_desk::document::fresh();
        figure.scene.objects = vec![ObjectSpec::new("box", Shape::Box)];
        let mut state =
            State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None }).unwrap();
        state.model.tree.select(Some(camera_lab_desk::scene_tree::Selected::Object("box".to_owned())));
        state.model.settings.panels.wanted = [false, false, true];
        state.model.explained.show(Explanation::Order);
        let mut window = Window::with_state(state, [1280.0, 720.0]);
        let place = |window: &Window| window.harness.get_by_label(t.take).rect();
        let before = place(&window);
        assert!(before.bottom() < 300.0, "{before}");
        let list = window.harness.get_by_label_contains(t.list).rect();
        window.harness.hover_at(list.center());
        window.run();
        let delta = Vec2::new(0.0, -300.0);
        window.harness.event(eframe::egui::Event::MouseWheel {
            unit: eframe::egui::MouseWheelUnit::Point,
            delta,
            phase: eframe::egui::TouchPhase::Move,
            source: eframe::egui::MouseWheelSource::Wheel,
            modifiers: Modifiers::NONE,
        });
        window.harness.run_steps(30);
        let gone = window.harness.query_by_label_contains(t.list);
        assert!(gone.is_none_or(|node| node.rect().top() < list.top() - 50.0), "it has been scrolled");
        assert_eq!(place(&window), before);
    }
}

#[test]
fn both_readings_end_at_one_matrix_and_the_wrong_order_elsewhere() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = texts(lang);
        let mut window = window(lang, Some("box"));
        let scene = &window.state().model.desk.shown.figure().scene;
        let own = placements(scene).unwrap()["box"];
        let parent = DMat4::from_translation(DVec3::Y);
        // T and R_y exchanged: turned about the parent's origin, it is at −2 z.
        assert_eq!(window.state().explain.order.exchange, [0, 2], "the first pair that tells");
        let [right, wrong] = placed(&window)[..] else { panic!("two") };
        assert!(right.abs_diff_eq(own, 1e-12));
        assert!(wrong.w_axis.truncate().abs_diff_eq(DVec3::new(0.0, 1.0, -2.0), 1e-12), "{wrong}");
        assert!(window.says(t.differs));
        window.click(t.fixed);
        assert_eq!(window.state().explain.order.reading, Reading::Object);
        assert!(placed(&window)[0].abs_diff_eq(own, 1e-12));
        // One step back: in this reading without T, which is the last to move the object.
        window.click(t.back);
        let without = parent * product(&calls(&window)[1..]).unwrap();
        assert!(placed(&window)[0].abs_diff_eq(without, 1e-12), "without T");
        window.click(t.frame);
        let without = parent * product(&calls(&window)[..4]).unwrap();
        assert!(placed(&window)[0].abs_diff_eq(without, 1e-12), "without S");
        window.click(t.forward);
        assert_eq!(window.state().explain.order.done, None);
        // R_z by 0° is exchanged with anything.
        window.app_mut().state.explain.order.exchange = [1, 2];
        window.run();
        assert!(window.says(t.same));
        // Hidden, nothing of it is in the world.
        alt(&mut window, Key::E);
        assert!(placed(&window).is_empty());
    }
}

#[test]
fn the_object_takes_over_t_r_s_and_it_can_be_undone() {
    let mut window = window(Lang::PtBr, Some("box"));
    let t = texts(Lang::PtBr);
    let before = window.state().model.desk.shown.figure().scene.clone();
    window.enter("R_z", "30");
    window.enter("S x", "0");
    window.click(t.take);
    assert_eq!(window.state().model.desk.shown.figure().scene, before, "scaled to nothing it is not an object");
    assert!(window.state().model.message.is_some());
    window.enter("S x", "4");
    assert!(window.says(t.is_form));
    window.click(t.take);
    let object = &window.state().model.desk.shown.figure().scene.objects[1];
    assert_eq!((object.rotate, object.scale.x), (DVec3::new(0.0, 90.0, 30.0), 4.0));
    assert_eq!(symbols(&window), ["T", "R_z", "R_y", "R_x", "S"]);
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().scene, before, "one step");
}

#[test]
fn another_order_is_taken_over_with_groups_that_lead_to_the_same_matrix() {
    let mut window = window(Lang::En, Some("box"));
    let before = window.state().model.desk.shown.figure().scene.clone();
    window.harness.get_by_label("Step 5: S").focus();
    window.run();
    for _ in 0..4 {
        alt(&mut window, Key::ArrowUp);
    }
    assert_eq!(symbols(&window), ["S", "T", "R_z", "R_y", "R_x"]);
    assert!(window.says("Step 2 (T) doesn't fit"));
    let wanted = placed(&window)[0];
    window.click(en::ORDER.take);
    let scene = &window.state().model.desk.shown.figure().scene;
    let names: Vec<&str> = scene.objects.iter().map(|o| o.name.as_str()).collect();
    assert_eq!(names, ["arm", "group", "box"]);
    assert!(placements(scene).unwrap()["box"].abs_diff_eq(wanted, 1e-12));
    // The list is that of the object, below its new parent.
    assert!(placed(&window)[0].abs_diff_eq(wanted, 1e-12));
    window.command_key(Key::Z);
    assert_eq!(window.state().model.desk.shown.figure().scene, before);
}

#[test]
fn push_and_pop_are_in_the_list_and_a_pop_alone_is_named() {
    let mut window = window(Lang::En, None);
    assert!(window.says("No object is selected"));
    assert_eq!(symbols(&window), ["T", "R_y", "S"]);
    assert!(window.harness.get_by_label(en::ORDER.take).accesskit_node().is_disabled());
    assert!(window.state().model.frame.placed[0].objects.is_empty(), "a cube");
    for entry in ["push: save the matrix", "translate", "pop: restore it"] {
        window.click("+ Add");
        window.click(entry);
    }
    let whole = product(&calls(&window)[..3]).unwrap();
    assert!(placed(&window)[0].abs_diff_eq(whole, 1e-12), "what was pushed is back");
    window.click("Remove 4");
    assert!(window.says("Step 5 is a pop, and nothing was pushed before it."));
    assert!(window.state().model.frame.placed.is_empty());
}
