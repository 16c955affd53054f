//! Worked solutions that fade: after each success one step more is to be done, and one fewer after a failure.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::exercises::Progress;
use camera_lab_words::Lang;
use camera_lab_words::learn::{exercise_window, exercises as said};
use eframe::egui::Event;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;

use super::exercises::{made, working_on};
use super::window::Window;

/// Opens worked steps until there is no button for another. Returns their number.
fn open_steps(window: &mut Window, name: &str, lang: Lang) -> usize {
    let t = exercise_window::texts(lang);
    for opened in 0.. {
        let label = exercise_window::of_ask(if opened == 0 { t.first_step } else { t.next_step }, name);
        let Some(button) = window.harness.query_by_label(&label) else { return opened };
        button.click();
        window.run();
    }
    unreachable!("a solution ends")
}

#[test]
fn all_steps_are_given_at_first_and_one_fewer_each_time() {
    let mut progress = Progress::default();
    assert_eq!(progress.given_steps("basis", 4), 4);
    progress.was_solved("basis");
    assert_eq!((progress.given_steps("basis", 4), progress.given_steps("window", 4)), (3, 4));
    assert_eq!(progress.given_steps("basis", 0), 0);
}

#[test]
fn the_last_step_is_typed_once_the_exercise_has_been_solved_before() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = exercise_window::texts(lang);
        let (_, exercise) = made("basis", 1);
        let ask = &exercise.asks[0];
        let name = said::ask(lang, &exercise, ask).replace("**", "");
        // Never solved: the whole solution, and nothing to type.
        let mut window = working_on("basis", 1, lang);
        let all = open_steps(&mut window, &name, lang);
        assert!(all > 1);
        let field = exercise_window::of_ask(t.your_step, &name);
        assert!(window.harness.query_by_role_and_label(Role::TextInput, &field).is_none());
        // Solved once: the last number of the last step is to be typed.
        let mut window = working_on("basis", 1, lang);
        window.app_mut().state.learn.exercises.progress.was_solved("basis");
        assert_eq!(open_steps(&mut window, &name, lang), all);
        let last = |window: &Window| window.state().learn.exercises.opened[&ask.name].is_to_do(all - 1);
        assert!(last(&window) && !window.state().learn.exercises.opened[&ask.name].is_to_do(all - 2));
        // The third component of the axis that is asked for, from the camera alone.
        let camera = exercise.subject.figure.camera;
        let n = (camera.position - camera.focal_point).normalize();
        let u = camera.view_up.cross(n).normalize();
        let axes = [("n", n), ("u", u), ("v", n.cross(u))];
        let axis = axes.iter().find(|(of, _)| *of == ask.name).unwrap().1;
        let own = |window: &Window| window.state().learn.exercises.progress.tried("basis").unwrap().own_steps;
        for (text, is_right) in [(format!("{}", axis.z + 0.1), false), (format!("{:.5}", axis.z), true)] {
            window.harness.get_by_role_and_label(Role::TextInput, &field).focus();
            window.run();
            let typed = window.state().learn.exercises.opened[&ask.name].typed[&(all - 1)].chars().count();
            for _ in 0..typed {
                window.key(eframe::egui::Key::Backspace);
            }
            window.harness.event(Event::Text(text));
            window.run();
            window.harness.get_by_label(&exercise_window::of_ask(t.check_step, &name)).click();
            window.run();
            assert_eq!(!last(&window), is_right);
            // The first try counts.
            assert_eq!(own(&window), 0);
        }
        // With other numbers, the first try is right.
        let mut window = working_on("basis", 1, lang);
        window.app_mut().state.learn.exercises.progress.was_solved("basis");
        open_steps(&mut window, &name, lang);
        window.harness.get_by_role_and_label(Role::TextInput, &field).focus();
        window.run();
        window.harness.event(Event::Text(format!("{:.5}", axis.z)));
        window.run();
        window.key(eframe::egui::Key::Enter);
        window.run();
        assert_eq!(own(&window), 2);
        // All steps at once, which leaves nothing to do.
        let mut window = working_on("basis", 1, lang);
        window.app_mut().state.learn.exercises.progress.was_solved("basis");
        window.harness.get_by_label(&exercise_window::of_ask(t.all_steps, &name)).click();
        window.run();
        assert!(window.state().learn.exercises.opened[&ask.name].is_at_end());
        assert!(window.harness.query_by_role_and_label(Role::TextInput, &field).is_none());
        assert_eq!(own(&window), 0);
    }
}
