//! Predictions in lessons: a place in the image, judged by the pipeline, and the figure that shows what was asked.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::exercises::{self, Guess, Progress};
use camera_lab::i18n::Lang;
use camera_lab::i18n::learn::{exercise_messages, exercises as said};
use camera_lab::lessons::{See, Task, parse, shipped};

/// C = (0, 0, 5) looks at the origin, θ = 90° and 800 × 600 pixels. P = (1, 1, 0) has the depth 5: half the window is
/// 5 high there, so P is 1/5 of 300 pixels above the middle, and as many pixels to the right of it.
const LESSON: &str = r#"
id = "places"
title = "Places"
[[step]]
title = "One"
text = "One"
[step.camera]
position = [0, 0, 5]
focal_point = [0, 0, 0]
view_angle = 90
near = 1
far = 20
[step.image]
width = 800
height = 600
[[step.points]]
name = "P"
position = [1, 1, 0]
[step.ask]
text = "Where is P?"
place = "P"
[[step]]
title = "Two"
text = "Two"
[step.ask]
text = "Where will (1, 1, 0) be?"
place = [1, 1, 0]
see = ["camera.position=[0, 0, 10]"]
tolerance = 5
[[step]]
title = "Three"
text = "Three"
[step.ask]
text = "Is it smaller?"
choices = ["yes", "no"]
answer = "yes"
see = "next"
[[step]]
title = "Four"
text = "Four"
[step.camera]
position = [0, 0, 20]
"#;

#[test]
fn a_place_is_judged_by_its_pixels_and_says_how_far_it_is_off() {
    let lesson = parse(LESSON).unwrap();
    let judge = |step: usize, text: &str| {
        let Some(Task::Question(entry)) = &lesson.steps[step].task else { panic!("a question") };
        let exercise = entry.exercise(0, &Default::default());
        let ask = &exercise.asks[0];
        let judged = exercises::check(entry, &exercise, ask, text).unwrap();
        (judged.right, ask.off(&judged.understood).unwrap())
    };
    let near = |a: [f64; 2], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    let (right, off) = judge(0, "[460, 240]");
    assert!(right && near(off, [0.0, 0.0]), "{off:?}");
    // A twentieth of 600 pixels.
    assert!(judge(0, "[490, 240]").0 && !judge(0, "[491, 240]").0);
    let (right, off) = judge(0, "[400, 300]");
    assert!(!right && near(off, [-60.0, 60.0]), "{off:?}");
    let (en, pt) = (exercise_messages::off(Lang::En, off), exercise_messages::off(Lang::PtBr, off));
    assert!(en.contains("85 pixels") && en.contains("to the right and higher"), "{en}");
    assert!(pt.contains("85 pixels") && pt.contains("à direita e mais acima"), "{pt}");
    // From twice as far it's half as far from the middle.
    assert!(judge(1, "[430, 270]").0 && judge(1, "[435, 275]").0 && !judge(1, "[460, 240]").0);
    assert_eq!(exercise_messages::off(Lang::En, [-3.0, 0.2]).matches("higher").count(), 0);
}

#[test]
fn a_question_knows_the_figure_that_answers_it() {
    let lesson = parse(LESSON).unwrap();
    assert!(lesson.seen_after(0).is_none() && lesson.seen_after(3).is_none());
    assert_eq!(lesson.seen_after(1).unwrap().camera.position.z, 10.0);
    assert_eq!(lesson.steps[1].figure.camera.position.z, 5.0);
    assert_eq!(lesson.seen_after(2).unwrap().camera.position.z, 20.0);
}

#[test]
fn a_place_that_the_image_does_not_have_is_refused_with_its_line() {
    for (from, to, key) in [
        ("place = \"P\"", "place = \"Q\"", "[step.ask] place"),
        ("place = \"P\"", "place = [0, 0, 9]", "[step.ask] place"),
        ("place = \"P\"", "place = \"P\"\nanswer = 3", "[step.ask] answer"),
        ("see = \"next\"", "see = \"there\"", "[step.ask] see"),
        ("see = \"next\"", "see = [\"camera.near=-1\"]", "[step.ask] see"),
    ] {
        let text = LESSON.replace(from, to);
        let error = parse(&text).unwrap_err();
        assert_eq!(error.key, key, "{to}: {error}");
        let line = 1 + text.lines().position(|line| line.starts_with(key.rsplit(' ').next().unwrap())).unwrap();
        assert!(error.line >= line, "{to}: line {} of {line}", error.line);
    }
}

#[test]
fn each_lesson_asks_for_a_place_and_shows_what_it_asks() {
    let mut shown = 0;
    for shipped in shipped() {
        let lesson = &shipped.lesson;
        let questions = lesson.steps.iter().filter_map(|step| match &step.task {
            Some(Task::Question(entry)) => Some(entry.exercise(0, &Default::default())),
            _ => None,
        });
        let places = questions.flat_map(|exercise| exercise.asks).filter(|ask| ask.places);
        for ask in places.clone() {
            let right = ask.expected().table().unwrap().entries;
            // Neither the middle nor a corner, which anybody marks.
            assert!((right[0], right[1]) != (512.0, 384.0), "{}", lesson.id);
            assert!(said::tolerance(Lang::PtBr, &ask).contains("vertical"), "{}", lesson.id);
        }
        assert!(places.count() > 0, "{}", lesson.id);
        shown += lesson.steps.iter().filter(|step| !matches!(step.see, See::Nothing)).count();
    }
    assert!(shown > 25, "{shown} questions move the picture");
}

#[test]
fn guesses_are_kept_in_the_text_of_the_progress() {
    let mut progress = Progress::default();
    let guess = |said: &str, right, at| Guess { said: said.to_owned(), right, at };
    progress.guessed("question-1", guess("smaller", false, 9));
    progress.guessed("question-1", guess("larger", true, 10));
    assert!(!progress.is_empty());
    let read = Progress::read(&progress.to_toml()).unwrap();
    let kept: Vec<(&str, Guess)> = read.guesses().map(|(id, guess)| (id, guess.clone())).collect();
    assert_eq!(kept, [("question-1", guess("larger", true, 10))]);
    assert!(read.to_csv().contains("guess,question-1,1,1,1970-01-01T00:00:10Z"), "{}", read.to_csv());
}
