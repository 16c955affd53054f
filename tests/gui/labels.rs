//! The mode *Labels*: labels are dragged, renamed, hidden, brought back, and notes added. All of it is undone.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::camera::Parameters;
use camera_lab::figure::{Comparison, Labels, Measure, NotePlace, Outside};
use camera_lab::scene::Preset;
use camera_lab::views::{LabelPlace, View};
use camera_lab_words::Lang;
use camera_lab_words::window::labels as labels_words;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec2;

use super::window::Window;
use crate::words::en;

/// A window in the mode.
fn window(lang: Lang) -> Window {
    let mut window = Window::new(lang);
    let state = &mut window.app_mut().state;
    // Its labels are dragged in the world.
    state.model.layout.maximized = Some(View::World);
    state.model.desk.shown.set_parameters(Parameters { near: 2.0, far: 12.0, ..Parameters::default() });
    state.model.desk.commit();
    window.run();
    window.harness.key_press_modifiers(Modifiers::ALT, Key::T);
    window.run();
    assert!(window.state().model.label_mode.on);
    window
}

fn labels(window: &Window) -> &Labels {
    &window.state().model.desk.shown.figure().labels
}

/// A label of the world, and the place of its middle on the screen.
fn shown(window: &mut Window, name: &str) -> Option<(LabelPlace, Pos2)> {
    let canvas = &window.app_mut().canvas;
    let label = canvas.labels(View::World).iter().find(|label| label.name == name)?.clone();
    let (_, rect) = canvas.places().find(|(view, _)| *view == View::World)?;
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    let [x, y] = label.center.to_array().map(|v| v as f32);
    Some((label, rect.min + vec2(x, y)))
}

/// Types another text into a field.
fn write(window: &mut Window, field: &str, text: &str) {
    window.harness.get_by_role_and_label(Role::TextInput, field).click();
    window.run();
    window.command_key(Key::A);
    window.harness.event(Event::Text(text.to_owned()));
    window.run();
}

/// A figure of the notes has a few names: all are hidden, and those that it needs come back.
#[test]
fn all_labels_are_hidden_at_once_and_single_ones_come_back() {
    let mut window = window(Lang::En);
    let t = labels_words::texts(Lang::En);
    window.click(t.hide_all);
    let left = |window: &mut Window| {
        let views = [View::World, View::Canonical];
        views.iter().map(|view| window.app_mut().canvas.labels(*view).len()).sum::<usize>()
    };
    window.wait(|window| window.state().model.desk.shown.figure().labels.hidden.len() > 5);
    assert_eq!(left(&mut window), 0);
    let card = window.harness.query_all_by_role_and_label(Role::Button, "C").last().expect("the hidden one");
    card.click();
    window.run();
    assert!(shown(&mut window, "C").is_some() && shown(&mut window, "far").is_none());
    // Delete hides the chosen one.
    let place = shown(&mut window, "C").unwrap().1;
    window.click_at(place);
    window.key(Key::Delete);
    assert!(shown(&mut window, "C").is_none());
    for _ in 0..3 {
        window.command_key(Key::Z);
    }
    assert!(shown(&mut window, "far").is_some());
}

#[test]
fn a_label_is_dragged_in_one_step_and_undone() {
    let mut window = window(Lang::En);
    let (before, place) = shown(&mut window, "C").unwrap();
    window.drag(place, vec2(40.0, 60.0), |_| {});
    let (after, _) = shown(&mut window, "C").unwrap();
    assert!((after.center - before.center).abs_diff_eq(DVec2::new(40.0, 60.0), 1.0), "{before:?} {after:?}");
    assert!(after.point.abs_diff_eq(before.point, 0.1), "its point stays");
    assert_eq!(labels(&window).moved.len(), 1);
    assert_eq!(window.state().model.label_mode.chosen, Some((View::World, "C".to_owned())));
    window.command_key(Key::Z);
    assert_eq!(*labels(&window), Labels::default(), "the whole drag is one step");
    // Esc while it is held puts it back.
    window.drag(place, vec2(30.0, 30.0), |window| window.key(Key::Escape));
    assert_eq!(*labels(&window), Labels::default());
    window.key(Key::Escape);
    assert!(!window.state().model.label_mode.on);
}

#[test]
fn lengths_and_angles_are_shown_by_symbol_or_value() {
    let mut window = window(Lang::En);
    window.click("H/2");
    let (label, place) = shown(&mut window, "H/2").unwrap();
    assert!(label.text.starts_with("H/2 = "), "{}", label.text);
    // A click chooses it, and its card has the ways of showing it.
    window.click_at(place);
    window.click(en::LABELS.symbol);
    assert_eq!(shown(&mut window, "H/2").unwrap().0.text, "H/2");
    window.click("H/2");
    assert!(shown(&mut window, "H/2").is_none() && labels(&window).measures.is_empty());
    for _ in 0..3 {
        window.command_key(Key::Z);
    }
    assert_eq!(*labels(&window), Labels::default());
}

#[test]
fn the_chosen_label_is_renamed_styled_hidden_and_automatic_again() {
    for (lang, text, larger, hide, automatic) in [
        (Lang::En, "text", "size larger", "Hide", "Automatic again"),
        (Lang::PtBr, "texto", "tamanho maior", "Ocultar", "Automático de novo"),
    ] {
        let mut window = window(lang);
        let (_, place) = shown(&mut window, "C").unwrap();
        window.click_at(place);
        write(&mut window, text, r"eye $\mathbf{e}$");
        assert_eq!(labels(&window).renamed[0].text, r"eye $\mathbf{e}$");
        assert_eq!(shown(&mut window, "C").unwrap().0.text, "eye 𝐞");
        write(&mut window, text, r"$\begin{matrix}a\end{matrix}$");
        assert_eq!(labels(&window).renamed[0].text, r"eye $\mathbf{e}$", "what no label can show is not taken");
        window.click(larger);
        assert_eq!(labels(&window).styled[0].size, Some(1.25));
        window.click(automatic);
        assert_eq!(*labels(&window), Labels::default());
        window.click(hide);
        assert_eq!(labels(&window).hidden, ["C"]);
        assert!(shown(&mut window, "C").is_none());
        // The list of hidden ones brings it back.
        window.harness.get_by_role_and_label(Role::Button, "C").click();
        window.run();
        assert!(shown(&mut window, "C").is_some() && labels(&window).hidden.is_empty());
    }
}

#[test]
fn a_note_is_put_by_a_click_or_by_enter_typed_and_deleted() {
    let mut window = window(Lang::En);
    window.click(en::LABELS.add);
    let (c, place) = shown(&mut window, "C").unwrap();
    // Far from everything: in the corner above on the left.
    let corner = place - vec2(0.0, 0.0) + vec2(8.0, 8.0) - {
        #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
        let [x, y] = c.center.to_array().map(|v| v as f32);
        vec2(x, y)
    };
    window.click_at(corner);
    assert!(matches!(labels(&window).notes[0].at, NotePlace::Picture(_)) && !window.state().model.label_mode.adding);
    window.harness.event(Event::Text("see (5.3)".to_owned()));
    window.run();
    assert_eq!(labels(&window).notes[0].text, "see (5.3)", "its text is chosen, ready to be typed over");
    assert_eq!(shown(&mut window, "note:1").unwrap().0.text, "see (5.3)");
    window.click(en::LABELS.delete);
    assert_eq!(*labels(&window), Labels::default());
    window.command_key(Key::Z);
    assert_eq!(labels(&window).notes.len(), 1);
}

#[test]
fn labels_of_a_comparison_are_dragged_on_either_side() {
    for beside in [true, false] {
        let mut window = window(Lang::En);
        window.app_mut().state.model.desk.shown.edit(|figure| {
            let with = vec![("style.shading".to_owned(), "\"phong\"".to_owned())];
            figure.compare = Some(Comparison { with, beside, ..Comparison::default() });
        });
        window.run();
        let all: Vec<LabelPlace> = window.app_mut().canvas.labels(View::World).to_vec();
        let cs: Vec<&LabelPlace> = all.iter().filter(|label| label.name == "C").collect();
        assert_eq!(cs.len(), if beside { 2 } else { 1 }, "beside: {beside}");
        let (_, rect) = window.app_mut().canvas.places().find(|(view, _)| *view == View::World).unwrap();
        // The last one: beside each other, that of the other side.
        let last = cs[cs.len() - 1].center;
        #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
        let [x, y] = last.to_array().map(|v| v as f32);
        window.drag(rect.min + vec2(x, y), vec2(-20.0, 30.0), |_| {});
        assert_eq!(labels(&window).moved.len(), 1);
        let moved: Vec<DVec2> = {
            let all = window.app_mut().canvas.labels(View::World);
            all.iter().filter(|label| label.name == "C").map(|label| label.center).collect()
        };
        // It continues both sides: they are one figure's.
        for (from, to) in cs.iter().zip(&moved) {
            let is_last = from.center == last;
            assert!(
                !is_last || (*to - from.center).abs_diff_eq(DVec2::new(-20.0, 30.0), 1.0),
                "{beside}: {from:?} {to}"
            );
            assert!(*to != from.center);
        }
    }
}

#[test]
fn a_legend_is_dragged_as_a_whole_and_hidden_from_a_line_of_it() {
    let mut window = window(Lang::En);
    let state = &mut window.app_mut().state;
    state.model.desk.shown.set_parameters(Parameters { near: 2.0, far: 7.0, ..Parameters::default() });
    state.model.desk.shown.edit(|figure| {
        figure.scene.preset = Preset::Cube;
        figure.reveal.outside = Outside::Tinted;
    });
    state.model.desk.commit();
    window.run();
    let (before, place) = shown(&mut window, "legend:outside").unwrap();
    window.drag(place, vec2(50.0, -40.0), |_| {});
    let (after, place) = shown(&mut window, "legend:outside").unwrap();
    assert!((after.center - before.center).abs_diff_eq(DVec2::new(50.0, -40.0), 1.0), "{before:?} {after:?}");
    assert_eq!(labels(&window).moved[0].name, "legend");
    window.click_at(place);
    write(&mut window, "text", "beyond");
    assert_eq!(shown(&mut window, "legend:outside").unwrap().0.text, "beyond");
    window.click(en::LABELS.hide_legend);
    assert_eq!(labels(&window).hidden, ["legend"]);
    assert!(shown(&mut window, "legend:outside").is_none());
}

#[test]
fn the_arrow_keys_move_the_chosen_label() {
    let mut window = window(Lang::En);
    let (before, place) = shown(&mut window, "C").unwrap();
    window.click_at(place);
    let camera = window.state().model.desk.shown.camera().clone();
    window.key(Key::ArrowRight);
    let (after, _) = shown(&mut window, "C").unwrap();
    assert!((after.center - before.center).abs_diff_eq(DVec2::new(0.25 * before.em, 0.0), 0.5));
    assert_eq!(*window.state().model.desk.shown.camera(), camera, "the camera stays");
}

#[test]
fn all_are_automatic_again_and_notes_stay() {
    let mut window = window(Lang::En);
    window.app_mut().state.model.desk.shown.edit_labels(|labels| {
        labels.hide("u");
        labels.move_to("C", View::World, DVec2::X);
        labels.rename("v", None, "up");
    });
    window.run();
    window.click(en::LABELS.all_automatic);
    assert_eq!(*labels(&window), Labels::default());
    window.click(en::LABELS.leave);
    assert!(!window.state().model.label_mode.on);
    assert!(window.harness.query_by_label(en::LABELS.all_automatic).is_none());
}

#[test]
fn a_right_click_on_a_parameter_keeps_its_length_in_the_figure() {
    let mut window = Window::new(Lang::En);
    window.app_mut().state.model.layout.maximized = Some(View::World);
    window.run();
    let kept = |window: &Window| labels(window).measures.iter().map(|shown| shown.measure).collect::<Vec<_>>();
    assert_eq!(kept(&window), []);
    let entry = format!("{}: F", en::WINDOW.keep_operation);
    for expected in [vec![Measure::Near], vec![]] {
        let at = window.harness.get_by_role_and_label(Role::SpinButton, "F").rect().left_center() - vec2(20.0, 0.0);
        window.harness.hover_at(at);
        window.run();
        for pressed in [true, false] {
            let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
            window.harness.input_mut().events.push(Event::PointerButton { pos: at, button, pressed, modifiers });
        }
        window.run();
        window.click(&entry);
        assert_eq!(kept(&window), expected);
    }
}
