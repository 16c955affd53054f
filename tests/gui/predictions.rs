//! Predictions: a guess that is kept before its picture is shown, a mark in the image, and *Predict first*.

#![expect(clippy::unwrap_used, clippy::cast_possible_truncation, reason = "tests; places on a small screen")]

use camera_lab::gui::{Start, State};
use camera_lab::lessons::{Task, shipped};
use camera_lab::views::View;
use camera_lab_words::learn::{exercise_window, exercises};
use camera_lab_words::{Lang, told};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Pos2, pos2};
use egui_kittest::kittest::Queryable as _;
use glam::{DVec2, DVec3};

use super::lessons::playing;
use super::window::Window;
use crate::words::en;

/// The place on the screen of a point of the image, in pixels of the image.
fn on_screen(window: &mut Window, [i, j]: [f64; 2]) -> Pos2 {
    let image = window.state().model.desk.shown.figure().image;
    let (_, room) = window.app_mut().canvas.places().find(|(view, _)| *view == View::Image).unwrap();
    let aspect = image.width as f32 / image.height as f32;
    let width = room.width().min(room.height() * aspect);
    let corner = room.center() - 0.5 * eframe::egui::vec2(width, width / aspect);
    pos2(corner.x + width * i as f32 / image.width as f32, corner.y + width * j as f32 / image.width as f32)
}

/// Goes on until the camera has arrived.
fn arrive(window: &mut Window) {
    for _ in 0..200 {
        window.harness.step();
    }
}

#[test]
fn a_guess_is_kept_the_picture_moves_and_the_reason_comes_last() {
    for lang in [Lang::En, Lang::PtBr] {
        let (mut window, t) = (playing(0, 2, lang), exercise_window::texts(lang));
        let lesson = &shipped()[0].lesson;
        let Some(Task::Question(entry)) = &lesson.steps[2].task else { panic!("a question") };
        let exercise = entry.exercise(0, &Default::default());
        let ask = &exercise.asks[0];
        let choice = |name: &str| exercises::choice_of(lang, ask, name).to_owned();
        window.harness.get_by_label(&choice("smaller")).click();
        window.run();
        window.harness.get_by_label_contains(t.guess).click();
        window.run();
        arrive(&mut window);
        // Neither verdict nor reason. The picture is the one of the next step.
        let state = window.state();
        assert!(state.learn.exercises.checked.is_empty(), "no verdict before the picture");
        assert_eq!(state.model.desk.shown.figure().camera, lesson.steps[3].figure.camera);
        assert_eq!(state.learn.lesson.as_ref().unwrap().step, 2);
        assert!(!state.learn.lesson.as_ref().unwrap().is_done() && !state.model.is_unsaved());
        let (id, guess) = state.learn.exercises.progress.guesses().next().unwrap();
        assert_eq!((id, guess.said.as_str(), guess.right), (&*entry.id, "smaller", false));
        assert!(window.says(t.what_seen));
        let own = ask.own_mistakes.iter().find(|own| told(lang, &own.message).len() > 20).unwrap();
        assert!(!window.says(told(lang, &own.message).trim()));
        // The next answer is about the visible result. The guess stays.
        window.harness.get_by_label(&choice("nothing")).click();
        window.run();
        window.harness.get_by_label_contains(t.check).click();
        window.run();
        assert!(window.state().learn.lesson.as_ref().unwrap().is_done());
        assert_eq!(window.state().learn.exercises.guess_at(ask), Some(&vec!["smaller".to_owned()]));
        assert!(window.says(t.you_guessed));
    }
}

#[test]
fn a_lesson_that_is_opened_again_asks_again() {
    let mut window = playing(0, 2, Lang::En);
    window.harness.get_by_label("nothing").click();
    window.run();
    window.harness.get_by_label_contains(en::EXERCISE_WINDOW.guess).click();
    window.run();
    let typed =
        |window: &Window| window.state().learn.exercises.typed.values().filter(|typed| !typed.is_empty()).count();
    assert_eq!(typed(&window), 1);
    let mut state = State::new(Start::default()).unwrap();
    state.learn.exercises = window.state().learn.exercises.clone();
    let mut again = Window::with_state(state, [1280.0, 720.0]);
    again.run();
    let app = again.app_mut();
    app.state.learn.exercises.open = None;
    let question = |step: &camera_lab::lessons::Step| match &step.task {
        Some(Task::Question(entry)) => Some(entry.id.clone().into_owned()),
        _ => None,
    };
    app.state.learn.exercises.ask_again(shipped()[0].lesson.steps.iter().filter_map(question));
    assert_eq!(typed(&again), 0);
    assert_eq!(again.state().learn.exercises.progress.guesses().count(), 1, "the guess stays in the progress");
}

#[test]
fn a_right_answer_has_its_reason_too_and_a_guess_its_certainty() {
    for lang in [Lang::En, Lang::PtBr] {
        let (mut window, t) = (playing(0, 2, lang), exercise_window::texts(lang));
        let Some(Task::Question(entry)) = &shipped()[0].lesson.steps[2].task else { panic!("a question") };
        let exercise = entry.exercise(0, &Default::default());
        let because = exercise.asks[0].because.clone().unwrap();
        let reason: String = told(lang, &because).chars().take(20).collect();
        for press in [exercises::choice_of(lang, &exercise.asks[0], "nothing"), t.unsure, t.sure] {
            window.harness.get_by_label(press).click();
            window.run();
        }
        window.harness.get_by_label_contains(t.guess).click();
        window.run();
        arrive(&mut window);
        assert!(!window.says(&reason));
        let nothing = exercises::choice_of(lang, &exercise.asks[0], "nothing");
        window.harness.get_by_role_and_label(Role::RadioButton, nothing).click();
        window.run();
        window.harness.get_by_label_contains(t.check).click();
        window.run();
        assert!(window.says(&reason), "{reason}");
        let (_, guess) = window.state().learn.exercises.progress.guesses().next().unwrap();
        assert_eq!((guess.sure, guess.right), (Some(true), true));
    }
}

/// The place of a point with C, PF, VUP and θ, by the construction of the notes.
fn projected(point: DVec3, [c, pf, vup]: [DVec3; 3], theta: f64, [m, n]: [f64; 2]) -> [f64; 2] {
    let axis = (c - pf).normalize();
    let right = vup.cross(axis).normalize();
    let up = axis.cross(right);
    let d = point - c;
    let half = DVec2::new(m / n, 1.0) * (theta / 2.0).to_radians().tan() * -d.dot(axis);
    [m / 2.0 * (1.0 + d.dot(right) / half.x), n / 2.0 * (1.0 - d.dot(up) / half.y)]
}

#[test]
fn a_place_is_marked_by_click_and_arrows_and_judged_by_where_the_point_is() {
    // The roof's ridge, seen with VUP turned by 30° to the left of the image.
    let (c, pf) = (DVec3::new(3.2, 2.6, 5.4), DVec3::new(0.0, 0.8, 0.0));
    let axis = (c - pf).normalize();
    let right = DVec3::Y.cross(axis).normalize();
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let vup = axis.cross(right) * cos - right * sin;
    let wanted = projected(DVec3::new(-1.5325, 2.125, -0.25), [c, pf, vup], 38.0, [1024.0, 768.0]);
    let mut window = playing(0, 10, Lang::En);
    let camera = window.state().model.desk.shown.figure().camera;
    let at = on_screen(&mut window, [512.0, 100.0]);
    window.click_at(at);
    let mark = |window: &mut Window| placing_of(&mut window.app_mut().state).unwrap().mark.unwrap();
    let [x, y] = mark(&mut window);
    assert!((x - 512.0).abs() <= 2.0 && (y - 100.0).abs() <= 2.0, "{x} {y}");
    assert_eq!(window.state().model.desk.shown.figure().camera, camera, "the camera isn't dragged");
    window.key(Key::ArrowLeft);
    window.harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowUp);
    window.run();
    assert_eq!(mark(&mut window), [x - 1.0, y - 10.0]);
    assert!(
        placing_of(&mut window.app_mut().state).unwrap().right.is_none(),
        "the place is no secret only after the guess"
    );
    let at = on_screen(&mut window, wanted);
    window.click_at(at);
    window.harness.get_by_label_contains(en::EXERCISE_WINDOW.guess).click();
    window.run();
    arrive(&mut window);
    assert!(window.state().learn.lesson.as_ref().unwrap().is_done());
    let placing = placing_of(&mut window.app_mut().state).unwrap();
    let shown = placing.right.unwrap();
    assert!((shown[0] - wanted[0]).abs() < 0.5 && (shown[1] - wanted[1]).abs() < 0.5, "{shown:?} {wanted:?}");
    assert_ne!(window.state().model.desk.shown.figure().camera, camera, "the image has turned");
    assert!(window.state().learn.exercises.progress.guesses().all(|(_, guess)| guess.right));
}

#[test]
fn after_a_wrong_mark_a_second_place_is_asked_for_and_the_first_stays_hidden() {
    let mut window = playing(2, 10, Lang::PtBr);
    let t = exercise_window::texts(Lang::PtBr);
    let Some(Task::Question(entry)) = &shipped()[2].lesson.steps[10].task else { panic!("a question") };
    let exercise = entry.exercise(0, &Default::default());
    let (first, second) = (&exercise.asks[0], exercise.asks[0].second.as_deref().unwrap());
    let camera = window.state().model.desk.shown.figure().camera;
    let place =
        |ask: &camera_lab::exercises::Ask| -> [f64; 2] { ask.expected().table().unwrap().entries.try_into().unwrap() };
    let at = on_screen(&mut window, [512.0, 384.0]);
    window.click_at(at);
    window.harness.get_by_label_contains(t.guess).click();
    window.run();
    arrive(&mut window);
    // P is to the left of the axis and above it, half as far from it as before the zoom.
    assert!(!window.state().learn.lesson.as_ref().unwrap().is_done());
    assert!(window.says("mais à esquerda e mais acima"));
    assert!(window.says(exercises::ask(Lang::PtBr, &exercise, second).trim()));
    let placing = placing_of(&mut window.app_mut().state).unwrap();
    assert!(placing.right.is_none() && placing.is_open && placing.mark.is_none());
    assert_eq!(window.state().model.desk.shown.figure().camera, camera, "the image that answers comes later");
    // The place of the first question doesn't answer the second.
    for (wanted, is_done) in [(place(first), false), (place(second), true)] {
        if is_done {
            // The image has moved, and both places are shown.
            let placing = placing_of(&mut window.app_mut().state).unwrap();
            assert_eq!((placing.right, placing.second), (Some(place(first)), Some(place(second))));
            assert_ne!(window.state().model.desk.shown.figure().camera, camera);
        }
        let at = on_screen(&mut window, wanted);
        window.click_at(at);
        window.harness.get_by_label_contains(t.check).click();
        window.run();
        arrive(&mut window);
        assert_eq!(window.state().learn.lesson.as_ref().unwrap().is_done(), is_done);
    }
    let (_, guess) = window.state().learn.exercises.progress.guesses().next().unwrap();
    assert!(!guess.right, "what was guessed stays guessed");
}

/// The window with the house, and *Predict first* on.
fn predicting() -> Window {
    let figure = camera_lab::figure::Figure::of_preset(camera_lab::scene::Preset::House);
    let mut state = State::new(Start { figure, lang: Lang::En, ..Start::default() }).unwrap();
    state.file_flow.native = false;
    state.model.settings.reduce_motion = true;
    state.model.operations.predict.on = true;
    let mut window = Window::with_state(state, [1280.0, 720.0]);
    window.run();
    window
}

#[test]
fn an_operation_asks_first_where_a_point_goes_and_compares() {
    let mut window = predicting();
    let t = camera_lab_words::window::predict::texts(Lang::En);
    let camera = window.state().model.desk.shown.figure().camera;
    window.harness.get_by_label(&format!("{} +", en::WINDOW.azimuth)).click();
    window.run();
    assert_eq!(window.state().model.desk.shown.figure().camera, camera, "nothing is done yet");
    let placing = placing_of(&mut window.app_mut().state).unwrap();
    assert!(placing.is_open && placing.right.is_none() && placing.from.is_some());
    let at = on_screen(&mut window, [300.0, 200.0]);
    window.click_at(at);
    window.harness.get_by_label(t.do_it).click();
    window.run();
    let after = window.state().model.desk.shown.figure().camera;
    assert_ne!(after, camera);
    let placing = placing_of(&mut window.app_mut().state).unwrap();
    let ([x, y], right) = (placing.guess.unwrap(), placing.right.unwrap());
    assert!((x - 300.0).abs() <= 2.0 && (y - 200.0).abs() <= 2.0, "{x} {y}");
    // The highest vertex before. Its place afterwards by the construction of the notes.
    let sides = [1024.0, 768.0];
    let figure = window.state().model.desk.shown.figure().clone();
    let built = camera_lab::views::scene_of(&figure, &mut camera_lab::scene::no_files, &Default::default()).unwrap();
    let at = |camera: &camera_lab::camera::Parameters, p: DVec3| {
        projected(p, [camera.position, camera.focal_point, camera.view_up], camera.view_angle, sides)
    };
    let moved = built.vertices().map(|v| [at(&camera, v.p_world), at(&after, v.p_world)]);
    // Away from the border, so that its name has room.
    let is_in = |p: &[f64; 2]| (153.6..=870.4).contains(&p[0]) && (115.2..=652.8).contains(&p[1]);
    let highest = moved.filter(|[a, b]| is_in(a) && is_in(b)).min_by(|a, b| a[0][1].total_cmp(&b[0][1])).unwrap();
    assert!((highest[1][0] - right[0]).abs() < 0.5 && (highest[1][1] - right[1]).abs() < 0.5, "{highest:?} {right:?}");
    assert!(window.says("pixels off"));
    // The result belongs to this figure.
    window.command_key(Key::N);
    window.click(en::WINDOW.dont_save);
    assert!(placing_of(&mut window.app_mut().state).is_none() && !window.says("pixels off"));
}

#[test]
fn a_zoom_asks_for_sizes_and_says_by_how_much() {
    let mut window = predicting();
    let t = camera_lab_words::window::predict::texts(Lang::En);
    window.harness.get_by_label(&format!("{} +", en::WINDOW.zoom)).click();
    window.run();
    window.harness.get_by_label(t.smaller).click();
    window.run();
    let before = window.state().model.desk.shown.camera().window_height();
    window.harness.get_by_label(t.do_it).click();
    window.run();
    let times = before / window.state().model.desk.shown.camera().window_height();
    assert!(times > 1.0);
    let asked = window.state().model.operations.predict.asked.as_ref().unwrap();
    assert!(asked.is_done && !asked.about.is_right());
    assert!(window.says(&format!("{} times as large", Lang::En.mark().number(times, 3))));
}

fn placing_of(state: &mut State) -> Option<camera_lab_desk::operations::Placing> {
    state.learn.placing(&state.model)
}
