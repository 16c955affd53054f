//! Windows as narrow as a telephone, or as a tablet held upright.

use camera_lab::exercises::entries;
use camera_lab::lessons::shipped;
use camera_lab::views::View;
use camera_lab_desk::layout::Side;
use camera_lab_words::Lang;
use camera_lab_words::window::texts;
use eframe::egui::accesskit::Role;
use eframe::egui::{Rect, Shape};
use egui_kittest::kittest::Queryable as _;

use super::exercises::working_on;
use super::lessons::measured;
use super::window::Window;

const SIZES: [[f32; 2]; 2] = [[360.0, 740.0], [820.0, 1180.0]];

#[test]
fn in_a_window_held_in_the_hand_there_is_one_view_and_a_panel_comes_from_below() {
    for size in SIZES {
        let mut window = Window::new(Lang::En);
        let t = texts(Lang::En);
        window.harness.set_size(size.into());
        window.run();
        let views = |window: &mut Window| window.app_mut().canvas.places().map(|(view, _)| view).collect::<Vec<_>>();
        assert_eq!(views(&mut window), [View::Image]);
        window.click("World");
        assert_eq!(views(&mut window), [View::World]);
        // Whether it's open already or not.
        window.app_mut().state.model.settings.panels_mut().show(Side::Left);
        window.run();
        let (_, view) = window.app_mut().canvas.places().next().expect("a view");
        let tab = window.harness.get_by_label(t.camera_tab).rect();
        assert!(tab.min.y > view.max.y && tab.height() >= 44.0, "{tab:?} {view:?}");
        assert!(view.height() > 100.0 && view.width() > 0.9 * size[0], "{view:?}");
        for name in [t.parameters_panel, t.numbers_panel, t.undo] {
            let switch = window.harness.get_by_role_and_label(Role::Button, name).rect();
            assert!(switch.width() >= 44.0 && switch.height() >= 44.0, "{name}: {switch:?}");
        }
    }
}

/// The lines of text that are cut at a side, or end in dots.
fn cut(window: &Window) -> Vec<String> {
    fn collect(shape: &Shape, clip: Rect, cut: &mut Vec<String>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, cut)),
            Shape::Text(text) => {
                let rows = text.galley.rows.iter().map(|row| (row.text(), row.rect().translate(text.pos.to_vec2())));
                let is_cut = |rect: &Rect| rect.left() < clip.left() - 2.0 || rect.right() > clip.right() + 2.0;
                let seen = rows.filter(|(_, rect)| rect.intersects(clip));
                cut.extend(seen.filter(|(_, rect)| text.galley.elided || is_cut(rect)).map(|(text, _)| text));
            }
            _ => {}
        }
    }
    let mut all = Vec::new();
    window.harness.output().shapes.iter().for_each(|clipped| collect(&clipped.shape, clipped.clip_rect, &mut all));
    all
}

#[test]
fn no_text_of_a_lesson_is_cut() {
    for (lesson, shipped) in shipped().iter().enumerate() {
        let mut window = measured(lesson);
        window.harness.set_size(SIZES[0].into());
        for lang in Lang::ALL {
            window.app_mut().state.model.settings.lang = lang;
            for step in 0..shipped.lesson.steps.len() {
                let state = &mut window.app_mut().state;
                state.learn.go_to_step(&mut state.model, step);
                window.run();
                assert_eq!(cut(&window), [""; 0], "{lang:?} {} {}", shipped.lesson.id, step + 1);
            }
        }
    }
}

#[test]
fn no_text_of_an_exercise_is_cut() {
    for (size, lang) in SIZES.into_iter().flat_map(|size| Lang::ALL.map(|lang| (size, lang))) {
        for entry in entries() {
            let mut window = working_on(&entry.id, 0, lang);
            window.harness.set_size(size.into());
            window.run();
            assert_eq!(cut(&window), [""; 0], "{lang:?} {} {size:?}", entry.id);
        }
    }
}
