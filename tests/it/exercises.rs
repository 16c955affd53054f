//! Exercises: no right answer is refused, no known mistake is accepted, and each is told.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;

use camera_lab::exercises::{
    Answer, Ask, Entry, Exercise, Expected, Free, Kind, Slip, Slips, Table, check, entries, entry, judge_answer,
};
use camera_lab::i18n::Lang;
use camera_lab::i18n::exercises::typed_choice;
use camera_lab::numbers::exact_form;

/// How many seeds of each family are tried; more by `EXERCISE_SEEDS=10000 cargo test --release --test it exercises`.
fn seeds() -> u64 {
    std::env::var("EXERCISE_SEEDS").ok().and_then(|text| text.parse().ok()).unwrap_or(12)
}

/// Every exercise, families with many seeds.
fn all(visit: impl FnMut(&'static Entry, &Exercise)) {
    all_of(seeds(), visit);
}

fn all_of(seeds: u64, mut visit: impl FnMut(&'static Entry, &Exercise)) {
    for entry in entries() {
        for seed in 0..if entry.is_family { seeds } else { 1 } {
            visit(entry, &entry.exercise(seed, &Free::new()));
        }
    }
}

fn typed(table: &Table, number: impl Fn(f64) -> String) -> String {
    if table.shape() == [1, 1] {
        return number(table.entries[0]);
    }
    let row = |row: &[f64]| format!("[{}]", row.iter().map(|x| number(*x)).collect::<Vec<_>>().join(", "));
    if table.columns == 1 {
        return row(&table.entries);
    }
    format!("[{}]", table.rows().map(row).collect::<Vec<_>>().join(", "))
}

/// The right answer in words, for what is not made of numbers.
fn right_word(ask: &Ask) -> Option<String> {
    match (&ask.kind, ask.expected()) {
        (Kind::Choice(choices), Expected::Choice(right, ..)) => Some(choices[*right].clone()),
        _ => None,
    }
}

fn in_digits(value: f64, digits: usize) -> String {
    format!("{:.*e}", digits - 1, value)
}

#[test]
fn no_right_answer_is_refused() {
    all(|entry, exercise| {
        for ask in &exercise.asks {
            let context = format!("{} seed {} {}", entry.id, exercise.seed, ask.name);
            if let Some(word) = right_word(ask) {
                assert!(check(entry, exercise, ask, &word).unwrap().right, "{context}: {word}");
                continue;
            }
            let Some(right) = ask.expected().table() else { continue };
            assert!(right.is_finite(), "{context}");
            assert_eq!(right.shape(), ask.shape(), "{context}");
            let digits = if ask.whole { 10..=17 } else { 3..=17 };
            let as_exact = |x: f64| match exact_form(x) {
                Some(form) => form.text(),
                None => x.to_string(),
            };
            let texts = digits.map(|digits| typed(&right, |x| in_digits(x, digits)));
            for text in texts.chain([typed(&right, as_exact), typed(&right, |x| x.to_string())]) {
                let judged =
                    check(entry, exercise, ask, &text).unwrap_or_else(|error| panic!("{context}: {text}: {error}"));
                assert!(
                    judged.right && judged.score == 1.0 && judged.diagnosis.is_none(),
                    "{context}: {text}: {judged:?}"
                );
            }
        }
    });
}

#[test]
fn yes_and_no_are_also_typed_as_inspect_writes_them() {
    let mut asked = 0;
    all_of(6, |entry, exercise| {
        for ask in &exercise.asks {
            let Some(word) = right_word(ask).filter(|word| ["yes", "no"].contains(&word.as_str())) else { continue };
            asked += 1;
            for (typed, means) in
                [("true", "yes"), ("False", "no"), ("verdadeiro", "yes"), ("falso", "no"), ("Sim", "yes")]
            {
                let judged = check(entry, exercise, ask, typed_choice(ask, typed)).unwrap();
                assert_eq!(judged.right, word == means, "{}: {typed}", entry.id);
            }
            assert_eq!(typed_choice(ask, "maybe"), "maybe");
        }
    });
    assert!(asked > 5, "{asked}");
}

#[test]
fn the_quantity_is_what_inspect_says() {
    // Few of the cameras that make it hard are among the first; it costs little.
    all_of(10 * seeds(), |entry, exercise| {
        for ask in &exercise.asks {
            let Some(quantity) = &ask.quantity else { continue };
            let inspected = exercise.subject.value(*quantity).unwrap_or_else(|| panic!("{} {quantity}", entry.id));
            match ask.expected().table() {
                Some(right) => assert_eq!(right, inspected, "{} {}", entry.id, ask.name),
                None => {
                    let word = right_word(ask).unwrap();
                    let context = format!("{} seed {} {}", entry.id, exercise.seed, ask.name);
                    assert_eq!(inspected.entries, [f64::from(u8::from(word == "yes"))], "{context}");
                }
            }
        }
    });
}

/// What the notes' equations give by hand is what the camera gives.
#[test]
fn the_textbook_without_slips_agrees() {
    all(|entry, exercise| {
        for ask in &exercise.asks {
            let (Some(right), Some(by_hand)) = (ask.expected().table(), ask.expected().slipped(Slips::NONE)) else {
                assert!(matches!(ask.kind, Kind::Choice(_) | Kind::Camera), "{} {}", entry.id, ask.name);
                continue;
            };
            for (a, b) in right.entries.iter().zip(&by_hand.entries) {
                assert!(
                    (a - b).abs() <= 1e-9 * a.abs().max(1.0),
                    "{} {} {}: {right:?} {by_hand:?}",
                    entry.id,
                    exercise.seed,
                    ask.name
                );
            }
        }
    });
}

fn differs(ask: &Ask, wrong: &Table, right: &Table) -> bool {
    let off = |wrong: f64, right: f64| {
        (wrong - right).abs() > if ask.whole { 0.5 } else { ask.tolerance } && !ask.accepts(Some(wrong), right)
    };
    wrong.entries.iter().zip(&right.entries).any(|(wrong, right)| off(*wrong, *right))
}

#[test]
fn no_known_mistake_is_accepted_and_each_is_told() {
    let mut told = BTreeSet::new();
    all(|entry, exercise| {
        for ask in &exercise.asks {
            // Where there are several readings, a mistake in one may be right in another.
            let Some(right) = ask.expected().table().filter(|_| ask.readings.len() == 1) else { continue };
            let of_slip = |slip: &Slip| Some((*slip, ask.expected().slipped(Slips::one(*slip))?));
            let wrong: Vec<(Slip, Table)> = Slip::ALL
                .iter()
                .filter_map(of_slip)
                .filter(|(_, wrong)| wrong.shape() == right.shape() && differs(ask, wrong, &right))
                .collect();
            for (slip, table) in &wrong {
                let answer = Answer::Numbers {
                    rows: table.rows,
                    columns: table.columns,
                    entries: table.entries.iter().map(|x| Some(*x)).collect(),
                };
                let judged = judge_answer(ask, answer);
                let context = format!("{} seed {} {} {slip:?}", entry.id, exercise.seed, ask.name);
                assert!(!judged.right && judged.score < 1.0, "{context}: {table:?} is taken for {right:?}");
                let found = judged.diagnosis.unwrap_or_else(|| panic!("{context}: not told"));
                told.insert(found.mistakes[0]);
                // Another mistake with the same numbers may be told, but no other.
                let same = wrong
                    .iter()
                    .any(|(other, numbers)| other.mistake() == found.mistakes[0] && !differs(ask, numbers, table));
                assert!(found.mistakes == [slip.mistake()] || same, "{context}: {found:?}");
            }
        }
    });
    assert!(told.len() >= 20, "{told:?}");
}

/// The code of the first diagnosis of an answer.
fn code(id: &str, seed: u64, name: &str, answer: &str) -> &'static str {
    let entry = entry(id).unwrap();
    let exercise = entry.exercise(seed, &Free::new());
    let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    let judged = check(entry, &exercise, ask, answer).unwrap();
    assert!(!judged.right, "{answer}");
    judged.diagnosis.map_or("", |diagnosis| diagnosis.mistakes[0].code())
}

/// By hand, from the numbers of `[0]` 5.1: **n** = (3/5, 4/5, 0), **u** = (0, 0, −1), **v** = (−4/5, 3/5, 0).
#[test]
fn exercise_5_1_is_judged_as_a_teacher_would() {
    let entry = entry("0-5.1").unwrap();
    let exercise = entry.exercise(0, &Free::new());
    let judge = |name: &str, answer: &str| {
        let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
        check(entry, &exercise, ask, answer).unwrap()
    };
    for (name, answer) in [
        ("parallel_origin", "[11/5, 23/5, -1]"),
        ("parallel_origin", "(2,2; 4,6; −1)"),
        ("parallel_direction", "[-3/5, -4/5, 0]"),
        ("perspective_origin", "[3, 4, 0]"),
        ("perspective_direction", "[-4/(5 sqrt(2)), 3/(5√2), -1/√2]"),
        ("perspective_direction", "[-0.566, 0.424, -0.707]"),
    ] {
        let judged = judge(name, answer);
        assert!(judged.right && judged.reading.is_empty(), "{name} {answer}: {judged:?}");
    }
    // u + v − F n with F = 1, of length 1.
    let judged = judge("perspective_direction", "[-1.4/sqrt(3), -0.2/sqrt(3), -1/sqrt(3)]");
    assert!(judged.right && judged.reading == "window-point", "{judged:?}");
    assert_eq!(code("0-5.1", 0, "parallel_origin", "[3, 5, -1]"), "vup-as-v");
    assert_eq!(code("0-5.1", 0, "parallel_direction", "[3/5, 4/5, 0]"), "n-reversed");
    assert_eq!(code("0-5.1", 0, "parallel_direction", "[-3, -4, 0]"), "not-normalised");
    assert_eq!(code("0-5.1", 0, "perspective_direction", "[-4/5, 3/5, -1]"), "not-normalised");
    assert_eq!(code("0-5.1", 0, "parallel_direction", "[-3/5, -4/5]"), "wrong-shape");
}

#[test]
fn the_figures_of_the_notes_exercises_are_those_of_the_gallery_and_hold_no_answer() {
    for (id, name) in [("0-5.1", "exercise-5.1"), ("0-5.2", "exercise-5.2"), ("0-5.3", "exercise-5.3")] {
        let shipped = camera_lab::files::ShippedFigure::named(name).unwrap();
        let shown = camera_lab::figure::read::parse(&shipped.text()).unwrap();
        let exercise = entry(id).unwrap().exercise(1, &Free::new());
        let given = &exercise.subject.figure;
        assert_eq!((given.camera, given.image, &given.scene), (shown.camera, shown.image, &shown.scene), "{id}");
    }
    // [0] 5.1 asks where the rays begin and where they go.
    let rays = entry("0-5.1").unwrap().exercise(1, &Free::new());
    let scene = |figure: &camera_lab::figure::Figure| {
        let files = &mut camera_lab::scene::no_files;
        camera_lab::views::scene_of(figure, files, &camera_lab::progress::Progress::default()).unwrap()
    };
    let (before, after) = (&rays.subject.figure, rays.answered.as_deref().unwrap());
    let (plain, answered) = (scene(before), scene(after));
    assert!(
        plain.lines.iter().all(|line| !line.style.arrow)
            && plain.texts.iter().all(|text| text.text != "D_R")
            && before.points.is_empty()
    );
    assert!(plain.objects.iter().all(|object| object.name != "P"), "C + u + v is the origin of the parallel ray");
    assert_eq!(answered.texts.iter().filter(|text| text.text == "D_R").count(), 2);
    assert_eq!(after.points.iter().map(|point| point.name.as_str()).collect::<Vec<_>>(), ["O_R"]);
    assert_eq!((after.camera, after.image), (before.camera, before.image));
}

#[test]
fn statements_say_where_the_notes_have_it_otherwise() {
    for (id, en, pt) in [
        ("yaw", "exchanges the axes of yaw and pitch", "troca os eixos de guinada e arfagem"),
        ("pitch", "exchanges the axes of yaw and pitch", "troca os eixos de guinada e arfagem"),
        ("elevation", "turns C alone", "gira só C"),
        ("azimuth", "turns C alone", "gira só C"),
        ("dolly", "does not have this operation", "não tem esta operação"),
        ("pan", "does not have this operation", "não tem esta operação"),
    ] {
        let exercise = entry(id).unwrap().exercise(3, &Free::new());
        for (lang, word, mark) in [(Lang::En, en, "≠ notes: "), (Lang::PtBr, pt, "≠ notas: ")] {
            let said = camera_lab::i18n::exercises::assumptions(lang, &exercise);
            assert!(said.iter().any(|text| text.starts_with(mark) && text.contains(word)), "{id}: {said:?}");
        }
    }
}

#[test]
fn calls_of_functions_are_written_as_code_in_both_languages() {
    let mut calls = BTreeSet::new();
    for lang in [Lang::En, Lang::PtBr] {
        all_of(6, |_, exercise| {
            for paragraph in camera_lab::i18n::exercises::statement(lang, exercise) {
                for call in paragraph.split("gl").skip(1) {
                    let Some((name, rest)) = call.split_once('(') else { continue };
                    let arguments = rest.split(')').next().unwrap();
                    let is_call = name.chars().all(char::is_alphanumeric) && !name.is_empty();
                    assert!(!is_call || !arguments.contains(['°', ';', '{']), "gl{name}({arguments})");
                    let comma = arguments.find(',').map(|at| arguments[at + 1..].starts_with(' '));
                    assert!(!is_call || comma != Some(false), "gl{name}({arguments})");
                    calls.extend(is_call.then(|| name.to_owned()));
                }
            }
        });
    }
    assert_eq!(
        calls.into_iter().collect::<Vec<_>>(),
        ["DepthRange", "Rotate", "Scale", "Translate", "Viewport", "uPerspective"]
    );
}
