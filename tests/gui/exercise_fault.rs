//! The mistake in a student's solution: a click marks the first wrong line, and then the cause is chosen.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::exercises::{Expected, FAULT};
use camera_lab_words::Lang;
use camera_lab_words::learn::{exercise_window, exercises as said};
use eframe::egui::Rect;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;

use super::exercises::{made, working_on};

#[test]
fn a_line_is_marked_by_a_click_and_then_the_cause_is_asked() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = exercise_window::texts(lang);
        let mut window = working_on("view-matrix", 0, lang);
        window.harness.get_by_label(t.find_fault).click();
        window.run();
        let id = format!("view-matrix{FAULT}");
        assert_eq!(window.state().learn.exercises.open.as_ref().unwrap().id, id);
        let (_, exercise) = made(&id, 1);
        let (fault, asks) = (exercise.fault().unwrap(), &exercise.asks);
        let check =
            |k: usize| exercise_window::of_ask(t.check, &said::ask(lang, &exercise, &asks[k]).replace("**", ""));
        let mark = |line: u32| line.to_string();
        let verdict = |window: &super::window::Window, name: &str| {
            window.state().learn.exercises.checked.get(name).map(|checked| checked.judged.right)
        };
        let wrong = if fault.line == 1 { 2 } else { 1 };
        for (line, is_right) in [(wrong, false), (fault.line, true)] {
            // The question for the cause would give the line away.
            assert!(window.harness.query_by_label(&check(1)).is_none());
            window.harness.get_by_role_and_label(Role::Button, &mark(line)).click_accesskit();
            window.run();
            window.harness.get_by_label(&check(0)).click_accesskit();
            window.run();
            assert_eq!(verdict(&window, "line"), Some(is_right));
        }
        let Expected::Choice(right, ..) = asks[1].expected() else { panic!("a choice") };
        let name = char::from(b'a' + u8::try_from(*right).unwrap()).to_string();
        let cause = camera_lab_words::why::notes::line(said::choice_of(lang, &asks[1], &name));
        // Sentences, one below the other.
        let mut places: Vec<_> = window.harness.get_all_by_role(Role::RadioButton).map(|radio| radio.rect()).collect();
        places.sort_by(|a, b| a.top().total_cmp(&b.top()));
        let apart = |pair: &[Rect]| (0.0..30.0).contains(&(pair[1].top() - pair[0].bottom()));
        assert!(places.len() > 1 && places.windows(2).all(apart), "{places:?}");
        window.harness.get_by_role_and_label(Role::RadioButton, &cause).click_accesskit();
        window.run();
        window.harness.get_by_label(&check(1)).click_accesskit();
        window.run();
        assert_eq!(verdict(&window, "cause"), Some(true));
        window.harness.get_by_label(t.solve_yourself).click();
        window.run();
        assert_eq!(window.state().learn.exercises.open.as_ref().unwrap().id, "view-matrix");
    }
}
