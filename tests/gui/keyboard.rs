//! The way through the window without a mouse.

use std::collections::BTreeMap;

use camera_lab::gui::{Start, State};
use camera_lab::scene::{ObjectSpec, Preset, Shape};
use camera_lab::views::{Probe, View};
use camera_lab_words::Lang;
use camera_lab_words::window::texts;
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::{By, NodeT, Queryable};
use glam::{DVec2, DVec3};

use super::canvas::{Stage, stage};
use super::window::Window;
use crate::words::en;

impl Window {
    /// Role, name and place of the focused widget. The name is empty if the widget has none.
    fn focused(&self) -> Option<(Role, String, Rect)> {
        let node = self.harness.query_all(By::new().predicate(|node| node.is_focused())).next()?;
        let (label, value) = (node.accesskit_node().label(), node.accesskit_node().value());
        Some((node.accesskit_node().role(), label.or(value).unwrap_or_default(), node.rect()))
    }

    fn focused_name(&self) -> String {
        self.focused().map(|(_, name, _)| name).unwrap_or_default()
    }
}

fn fresh() -> State {
    let (figure, file) = (camera_lab_desk::document::fresh(), None);
    State::new(Start { figure, file, lang: Lang::En, allow_files: false, lesson: None, later: None })
        .expect("a possible camera")
}

/// A window with all three pictures.
fn whole() -> Window {
    let mut window = Window::new(Lang::En);
    window.app_mut().state.model.layout.maximized = None;
    window.run();
    window
}

#[test]
fn ctrl_tab_goes_from_region_to_region_in_both_directions() {
    let mut window = whole();
    let names = |window: &mut Window, modifiers| -> Vec<String> {
        (0..7)
            .map(|_| {
                window.harness.key_press_modifiers(modifiers, Key::Tab);
                window.run();
                let name = window.focused_name();
                name.split([':', '.']).next().unwrap_or_default().to_owned()
            })
            .collect()
    };
    let there = names(&mut window, Modifiers::CTRL);
    assert!(there[0].starts_with("Menus"), "{there:?}");
    assert_eq!(there[2..5], ["World", "Canonical volume", "Image"]);
    assert_eq!(there[6], there[0], "round and round");
    let mut back = names(&mut window, Modifiers::CTRL | Modifiers::SHIFT);
    assert_eq!(back[0], there[5]);
    back.reverse();
    assert_eq!(back[1..], there[..6]);
    // From a control, to the next region. Tab continues into it.
    window.field("θ").focus();
    window.run();
    window.harness.key_press_modifiers(Modifiers::CTRL, Key::Tab);
    window.run();
    assert!(window.focused_name().starts_with("World"));
    window.harness.key_press_modifiers(Modifiers::CTRL | Modifiers::SHIFT, Key::Tab);
    window.run();
    window.key(Key::Tab);
    assert_eq!(window.focused_name(), "Camera tab");
}

#[test]
fn tab_reaches_every_named_control_once_in_reading_order() {
    for lang in [Lang::En, Lang::PtBr] {
        let mut window = whole();
        window.app_mut().state.model.settings.lang = lang;
        window.app_mut().state.model.layout.strip = true;
        window.run();
        let mut seen: Vec<(Role, String, Rect)> = Vec::new();
        // A stop, and the next one with the first as it stands then: reaching a control may scroll.
        let mut pairs: Vec<[(String, Rect); 2]> = Vec::new();
        for _ in 0..400 {
            window.key(Key::Tab);
            let Some(focused) = window.focused() else { continue };
            if seen.first().is_some_and(|first| *first == focused) && seen.len() > 5 {
                break;
            }
            if let Some((role, name, before)) = seen.last() {
                let is_it = |rect: &Rect| (rect.left() - before.left()).abs() < 0.5;
                let now = window.harness.query_all_by_role_and_label(*role, name).map(|node| node.rect()).find(is_it);
                pairs.push([(name.clone(), now.unwrap_or(*before)), (focused.1.clone(), focused.2)]);
            }
            seen.push(focused);
        }
        assert!((60..350).contains(&seen.len()), "{} stops", seen.len());
        let nameless: Vec<_> = seen.iter().filter(|(_, name, _)| name.trim().is_empty()).collect();
        assert!(nameless.is_empty(), "{nameless:?}");
        let mut times: BTreeMap<(String, [i32; 2]), usize> = BTreeMap::new();
        for (_, name, rect) in &seen {
            #[expect(clippy::cast_possible_truncation, reason = "places on a screen")]
            let place = [rect.center().x as i32, rect.center().y as i32];
            *times.entry((name.clone(), place)).or_default() += 1;
        }
        let twice: Vec<_> = times.iter().filter(|(_, times)| **times > 1).collect();
        assert!(twice.is_empty(), "{twice:?}");
        for [(a, before), (b, after)] in &pairs {
            let is_one_row = (before.center().y - after.center().y).abs() < 3.0;
            let is_near = (before.center().x - after.center().x).abs() < 260.0;
            assert!(!(is_one_row && is_near) || before.left() < after.right(), "{a} {before}, then {b} {after}");
        }
        // Menus, parameters, pictures and their bars below, then operations and numbers.
        let t = texts(lang);
        let panel = |name: &str| {
            let region = seen.iter().find(|(role, stop, _)| *role == Role::Region && stop == name);
            region.unwrap_or_else(|| panic!("{name} is not reached")).2.expand(12.0)
        };
        let (left, right) = (panel(t.parameters_panel), panel(t.numbers_panel));
        let column = |rect: &Rect| match rect.center() {
            p if p.y < 27.0 => 0,
            p if p.x < left.right() => 1,
            p if p.x < right.left() => 2,
            _ => 3,
        };
        let columns: Vec<_> = seen.iter().map(|(.., rect)| column(rect)).collect();
        assert!(columns.is_sorted(), "{columns:?} of {seen:?}");
        assert!((0..4).all(|column| columns.iter().filter(|c| **c == column).count() > 5), "{columns:?}");
        // And back the same way.
        let (_, name, rect) = window.focused().expect("a stop");
        window.harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
        window.run();
        assert_eq!(window.focused().as_ref(), seen.last(), "before {name} {rect}");
    }
}

#[test]
fn tab_scrolls_the_focused_control_into_view_and_marks_it_if_it_is_on() {
    let mut state = Window::new(Lang::En);
    let state = std::mem::replace(&mut state.app_mut().state, fresh());
    let mut window = Window::with_state(state, [1280.0, 420.0]);
    window.field("C x").focus();
    window.run();
    let (_, _, first) = window.focused().expect("the field");
    let mut lowest = first.bottom();
    for _ in 0..24 {
        window.key(Key::Tab);
        window.run();
        let Some((_, name, rect)) = window.focused() else { continue };
        assert!(rect.bottom() <= 420.0 && rect.top() >= 0.0, "{name} is at {rect}");
        lowest = lowest.max(rect.bottom());
    }
    assert!(lowest > 380.0, "there is more than fits: {lowest}");
    // A switch that is on looks the same with the focus but for its ring.
    let ring = |window: &mut Window| {
        let rect = window.harness.get_by_role_and_label(Role::Button, texts(Lang::En).parameters_panel).rect();
        let image = window.harness.render().expect("a picture");
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a pixel")]
        let pixel = image.get_pixel((rect.left() - 2.0) as u32, rect.center().y as u32);
        pixel.0
    };
    // With the mouse there is no ring.
    window.harness.get_by_label_contains(en::WINDOW.scene_tab).click();
    window.run();
    let switch = window.harness.get_by_role_and_label(Role::Button, texts(Lang::En).parameters_panel);
    switch.focus();
    window.run();
    let without = ring(&mut window);
    window.key(Key::Tab);
    window.harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
    window.run();
    assert_eq!(window.focused_name(), texts(Lang::En).parameters_panel);
    assert_ne!(ring(&mut window), without);
}

#[test]
fn enter_chooses_in_an_open_list_and_closes_it_and_the_focus_comes_back() {
    let mut window = Window::new(Lang::En);
    window.key(Key::F7);
    let list = |window: &Window| window.harness.get_by_role_and_label(Role::ComboBox, en::WINDOW.shading).rect();
    window.harness.get_by_role_and_label(Role::ComboBox, en::WINDOW.shading).focus();
    window.run();
    window.key(Key::Enter);
    window.run();
    window.key(Key::ArrowDown);
    window.run();
    for _ in 0..4 {
        if window.focused_name() == "wireframe" {
            break;
        }
        window.key(Key::ArrowDown);
    }
    assert_eq!(window.focused_name(), "wireframe");
    window.key(Key::Enter);
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().style.shading, camera_lab::appearance::Shading::Wireframe);
    assert_eq!(window.harness.query_all_by_role_and_label(Role::Button, "wireframe").count(), 0, "it is closed");
    let (_, _, rect) = window.focused().expect("the list has the focus again");
    assert_eq!(rect, list(&window));
}

/// The middle of the image is at pixel (512, 384) of 1024 × 768.
#[test]
fn the_probe_goes_from_pixel_to_pixel_and_from_vertex_to_vertex() {
    let mut h = stage(|state| {
        state.model.desk.shown.edit(|figure| {
            figure.scene.preset = Preset::Empty;
            figure.scene.objects = vec![ObjectSpec::new("box", Shape::Box)];
        });
        state.model.layout.maximized = Some(View::Image);
    });
    h.get_by_label_contains("Image: ").focus();
    h.run();
    let probe = |h: &Harness<Stage>| h.state().state.model.frame.probe;
    let pixel = |h: &Harness<Stage>| match probe(h) {
        Some(Probe::Window(point)) => {
            let state = &h.state().state;
            state
                .model
                .desk
                .shown
                .figure()
                .image
                .image_from_window(&state.model.desk.shown.camera().window(), point)
                .floor()
        }
        other => panic!("{other:?}"),
    };
    let press = |h: &mut Harness<Stage>, key, modifiers| {
        h.key_press_modifiers(modifiers, key);
        h.run();
    };
    let before = *h.state().state.model.desk.shown.draft();
    press(&mut h, Key::I, Modifiers::NONE);
    assert_eq!(pixel(&h), DVec2::new(512.0, 384.0));
    press(&mut h, Key::ArrowRight, Modifiers::NONE);
    press(&mut h, Key::ArrowUp, Modifiers::SHIFT);
    assert_eq!(pixel(&h), DVec2::new(513.0, 374.0));
    for _ in 0..60 {
        press(&mut h, Key::ArrowLeft, Modifiers::SHIFT);
    }
    assert_eq!(pixel(&h), DVec2::new(0.0, 374.0), "at the border it stays");

    press(&mut h, Key::V, Modifiers::NONE);
    let vertex = |h: &Harness<Stage>| match probe(h) {
        Some(Probe::Point(p)) => p,
        other => panic!("{other:?}"),
    };
    // From (3, 4, 5) the corner (1, 1, 1) is nearest to the middle. Six others can be seen around it.
    assert_eq!(vertex(&h), DVec3::ONE);
    let place = |h: &Harness<Stage>| {
        let clip = h.state().state.model.desk.shown.camera().clip_point(vertex(h));
        clip.truncate().truncate() / clip.w
    };
    let middle = place(&h);
    press(&mut h, Key::ArrowRight, Modifiers::NONE);
    assert!(place(&h).x > middle.x && vertex(&h) != DVec3::ONE);
    for _ in 0..4 {
        press(&mut h, Key::ArrowUp, Modifiers::NONE);
    }
    let top = place(&h);
    press(&mut h, Key::ArrowUp, Modifiers::NONE);
    assert_eq!(place(&h), top, "nothing is farther up");
    assert_eq!(vertex(&h).y, 1.0);
    assert_eq!(*h.state().state.model.desk.shown.draft(), before, "the camera stays");

    // Escape ends it, and the arrows turn the camera again.
    press(&mut h, Key::Escape, Modifiers::NONE);
    assert_eq!(probe(&h), None);
    press(&mut h, Key::ArrowUp, Modifiers::NONE);
    assert_ne!(*h.state().state.model.desk.shown.draft(), before);
}
