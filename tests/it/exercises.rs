//! Exercises: no right answer is refused, no known mistake is accepted, and each is named.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

use std::collections::{BTreeMap, BTreeSet};

use camera_lab::camera::{Parameters, Projection};
use camera_lab::exercises::{
    Answer, Ask, Entry, Exercise, Expected, Free, Kind, Mistake, Nature, Slip, Slips, Table, check, entries, entry,
    judge_answer,
};
use camera_lab::numbers::exact_form;
use camera_lab_words::Lang;
use camera_lab_words::learn::exercise_messages;
use camera_lab_words::learn::exercises as texts;
use camera_lab_words::learn::exercises::typed_choice;

/// The number of seeds that are tried of each family. `EXERCISE_SEEDS=10000 cargo test --release --test it exercises`
/// tries more.
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

/// The right answer in words, for answers that are not made of numbers.
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
fn the_quantity_agrees_with_inspect() {
    // Few of the cameras that make it hard are among the first, and it costs little.
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

/// The values that the notes' equations give by hand are those of the camera.
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

/// Questions whose vector has to be of length 1.
fn has_lengths(nature: Nature) -> bool {
    matches!(nature, Nature::Direction | Nature::Cosine | Nature::Light | Nature::Matrix)
}

fn is_near(a: &Table, b: &Table) -> bool {
    a.entries.iter().zip(&b.entries).all(|(a, b)| (a - b).abs() <= 2e-4 * b.abs().max(b.abs().max(1e-9)))
}

fn differs(ask: &Ask, wrong: &Table, right: &Table) -> bool {
    let off = |wrong: f64, right: f64| !ask.accepts(Some(wrong), right);
    wrong.entries.iter().zip(&right.entries).any(|(wrong, right)| off(*wrong, *right))
}

#[test]
fn known_mistakes_are_refused_by_name() {
    let (mut told, mut triples, mut several) = (BTreeSet::new(), 0, 0);
    all_of(seeds().max(16), |entry, exercise| {
        for ask in &exercise.asks {
            // If there are several readings, a mistake in one may be right in another.
            let Some(right) = ask.expected().table().filter(|_| ask.readings.len() == 1) else { continue };
            let of_slip = |slip: &Slip| Some((*slip, ask.expected().slipped(Slips::one(*slip))?));
            let wrong: Vec<(Slip, Table)> = Slip::ALL
                .iter()
                .filter(|slip| !(ask.not_asked)(**slip))
                .filter_map(of_slip)
                .filter(|(_, wrong)| wrong.shape() == right.shape() && differs(ask, wrong, &right))
                .collect();
            let before = ask.expected().slipped(Slips::one(Slip::NothingDone));
            for (slip, table) in &wrong {
                // A roll leaves C as it was: nothing was done to it.
                let is_idle = slip.mistake() == Mistake::OtherOperation;
                if is_idle && before.as_ref().is_some_and(|before| !differs(ask, table, before)) {
                    continue;
                }
                let same: BTreeSet<Mistake> = wrong
                    .iter()
                    .filter(|(_, numbers)| is_near(numbers, table))
                    .map(|(slip, _)| slip.mistake())
                    .collect();
                // A wrong length shows only if it has to be 1, and that one of many was made says nothing.
                let is_length = slip.mistake() == Mistake::NotNormalised;
                if (is_length && !has_lengths(ask.nature)) || same.len() > 3 {
                    continue;
                }
                let is_sign = right.entries.iter().zip(&table.entries).all(|(a, b)| (a.abs() - b.abs()).abs() < 1e-9);
                let answer = Answer::Numbers {
                    rows: table.rows,
                    columns: table.columns,
                    entries: table.entries.iter().map(|x| Some(*x)).collect(),
                };
                let judged = judge_answer(ask, answer);
                let context = format!("{} seed {} {} {slip:?}", entry.id, exercise.seed, ask.name);
                assert!(!judged.right && judged.score < 1.0, "{context}: {table:?} is taken for {right:?}");
                let found = judged.diagnosis.unwrap_or_else(|| panic!("{context}: not told"));
                told.insert(found.causes[0].mistake);
                triples += 1;
                several += u32::from(!found.others.is_empty());
                // Others with the same numbers are named as well, but none besides.
                assert!(
                    found.causes.len() == 1 && found.mistakes().any(|told| told == slip.mistake()),
                    "{context}: {found:?}"
                );
                for other in found.mistakes() {
                    let gives = |(slip, numbers): &(Slip, Table)| slip.mistake() == other && is_near(numbers, table);
                    assert!(wrong.iter().any(gives) || (is_sign && other == Mistake::Sign), "{context}: {other:?}");
                }
            }
        }
    });
    assert!(3 * several < triples, "{several} of {triples} are told as one of several");
    assert!(told.len() >= 30, "{told:?}");
    assert!(triples > 10_000, "{triples}");
}

/// A number as students and programs write it.
const NOTATIONS: [fn(f64) -> String; 5] = [
    |x| format!("{x:.9}"),
    |x| format!("{x:.9}").replace('.', ","),
    |x| format!("{x:.9e}"),
    |x| exact_form(x).map_or_else(|| format!("{x:.9}"), |form| form.text()),
    |x| format!(r"\frac{{{:.9}}}{{2}}", 2.0 * x),
];

#[test]
fn a_right_answer_is_right_in_every_notation_and_as_each_language_shows_it() {
    all_of(4, |entry, exercise| {
        for ask in &exercise.asks {
            let Some(right) = ask.expected().table() else {
                let Some(word) = right_word(ask) else { continue };
                for lang in [Lang::En, Lang::PtBr] {
                    let word = texts::choice(lang, &word);
                    assert!(check(entry, exercise, ask, typed_choice(ask, word)).unwrap().right, "{} {word}", entry.id);
                }
                continue;
            };
            for (k, number) in NOTATIONS.into_iter().enumerate() {
                let text = typed(&right, number);
                let text = if k == 1 { text.replace(", ", "; ") } else { text };
                let judged = check(entry, exercise, ask, &text).unwrap();
                assert!(judged.right, "{} seed {} {}: {text}: {judged:?}", entry.id, exercise.seed, ask.name);
                for lang in [Lang::En, Lang::PtBr] {
                    let shown = texts::understood(lang, ask, &judged.understood);
                    let again = check(entry, exercise, ask, &shown);
                    assert!(again.is_ok_and(|again| again.right), "{} {} {lang:?}: {shown}", entry.id, ask.name);
                }
            }
        }
    });
}

/// As copied from notes: a matrix of LaTeX, one that's written transposed, and the minus sign of print in an exponent.
#[test]
fn a_right_answer_is_right_as_a_matrix_of_latex_and_transposed() {
    let latex = |of: &Table| {
        let row =
            |row: &[f64]| row.iter().map(|x| format!("{x:.9e}").replace('-', "−")).collect::<Vec<_>>().join(" & ");
        format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", of.rows().map(row).collect::<Vec<_>>().join(r" \\ "))
    };
    all_of(2, |entry, exercise| {
        for ask in &exercise.asks {
            let Some(right) = ask.expected().table() else { continue };
            for text in [latex(&right), format!("{}^T", latex(&right.transposed()))] {
                let judged = check(entry, exercise, ask, &text).unwrap();
                assert!(judged.right, "{} seed {} {}: {text}: {judged:?}", entry.id, exercise.seed, ask.name);
            }
        }
    });
}

#[test]
fn no_number_that_is_wrong_by_a_third_is_right() {
    let mut tried = 0;
    all(|entry, exercise| {
        for ask in &exercise.asks {
            let Some(right) = ask.expected().table() else { continue };
            let others: Vec<Table> = ask.readings[1..].iter().filter_map(|reading| reading.expected.table()).collect();
            for k in (0..right.entries.len()).filter(|k| right.entries[*k].abs() > 1e-12) {
                for factor in [0.7, 1.3] {
                    let mut wrong = right.clone();
                    wrong.entries[k] *= factor;
                    // The number of another reading.
                    if others.iter().any(|other| !differs(ask, &wrong, other)) {
                        continue;
                    }
                    let judged = check(entry, exercise, ask, &typed(&wrong, |x| x.to_string())).unwrap();
                    // Right for other numbers that the statement leaves open: for another A.
                    if judged.numbers.is_some() && entry.id == "1-III" {
                        continue;
                    }
                    let context = format!("{} seed {} {}: {wrong:?}", entry.id, exercise.seed, ask.name);
                    assert!(!judged.right && !judged.entries.iter().flatten().nth(k).unwrap(), "{context}");
                    tried += 1;
                }
            }
        }
    });
    assert!(tried > 4_000, "{tried}");
}

/// Nothing that can be answered wrongly leaves a student without a word.
#[test]
fn unexplained_answers_get_a_hint() {
    let mut tried = 0;
    all_of(3, |entry, exercise| {
        for ask in &exercise.asks {
            let answers = match &ask.kind {
                Kind::Choice(choices) => choices.clone(),
                Kind::Camera => vec!["C=(7, 7, 7.5); PF=(0.3, 0.2, 0.1); projection=parallel; H=0.37".to_owned()],
                _ => {
                    let [rows, columns] = ask.shape();
                    let entries = (0..rows * columns).map(|k| [7171.0, -3313.0, 5501.0][k % 3]).collect();
                    vec![typed(&Table { rows, columns, entries }, |x| x.to_string())]
                }
            };
            for answer in answers {
                let judged = check(entry, exercise, ask, &answer).unwrap();
                if judged.right {
                    continue;
                }
                tried += 1;
                for lang in [Lang::En, Lang::PtBr] {
                    let context = format!("{} seed {} {} {lang:?}", entry.id, exercise.seed, ask.name);
                    let hints = exercise_messages::hints(lang, exercise, ask, &judged);
                    assert!(!hints.is_empty() && hints.iter().all(|hint| !hint.trim().is_empty()), "{context}");
                    let said = texts::diagnosis(lang, ask, &judged);
                    assert!(said.is_none_or(|said| !said.trim().is_empty()), "{context}");
                }
            }
        }
    });
    assert!(tried > 200, "{tried}");
}

/// A camera by the names of the notes.
fn camera_text(model: &Parameters, lang: Lang) -> String {
    let mark = |x: f64| if lang == Lang::En { x.to_string() } else { x.to_string().replace('.', ",") };
    let separator = if lang == Lang::En { ", " } else { "; " };
    let tuple = |v: glam::DVec3| format!("({})", v.to_array().map(mark).join(separator));
    let [name, perspective, parallel] = match lang {
        Lang::En => ["projection", "perspective", "parallel"],
        _ => ["projeção", "perspectiva", "paralela"],
    };
    let lens = match model.projection {
        Projection::Perspective => format!("{name}={perspective}; θ={}°", mark(model.view_angle)),
        Projection::Parallel => format!("{name}={parallel}; H={}", mark(model.height)),
    };
    let [c, pf, up] = [model.position, model.focal_point, model.view_up].map(tuple);
    let [a, f, b] = [model.aspect, model.near, model.far].map(mark);
    format!("C={c}; PF={pf}; VUP={up}; {lens}; A={a}; F={f}; B={b}")
}

#[test]
fn a_right_camera_is_right_by_the_names_of_the_notes_in_each_language() {
    let mut tried = 0;
    all(|entry, exercise| {
        for ask in &exercise.asks {
            let Expected::Camera(_, model, ..) = ask.expected() else { continue };
            for lang in [Lang::En, Lang::PtBr] {
                let text = camera_text(model, lang);
                let judged = check(entry, exercise, ask, &text).unwrap();
                assert!(judged.right, "{} seed {}: {text}: {judged:?}", entry.id, exercise.seed);
                tried += 1;
            }
        }
    });
    assert!(tried > 50, "{tried}");
}

/// A mistake that shows in most numbers of a family shows in all: F = 1 would hide that F was forgotten.
#[test]
fn no_numbers_hide_a_mistake_of_their_family() {
    let mut shown: BTreeMap<(String, bool, Slip), (u32, Vec<u64>)> = BTreeMap::new();
    all_of(100, |entry, exercise| {
        let tables: Vec<(&Ask, Table)> =
            exercise.asks.iter().filter_map(|ask| Some((ask, ask.expected().table()?))).collect();
        let is_parallel = exercise.subject.figure.camera.projection == Projection::Parallel;
        for slip in Slip::ALL {
            let of_slip = |(ask, right): &(&Ask, Table)| {
                let wrong = ask.expected().slipped(Slips::one(*slip))?;
                Some(wrong.shape() == right.shape() && differs(ask, &wrong, right))
            };
            let mut of_asks = tables.iter().filter_map(of_slip).peekable();
            // No camera comes out.
            if of_asks.peek().is_none() {
                continue;
            }
            let shows = of_asks.any(|shows| shows);
            let (all, hidden) = shown.entry((entry.id.to_string(), is_parallel, *slip)).or_default();
            *all += 1;
            // The first seeds keep their numbers: 45°, for which the sine is the cosine, tan 45° = 1, PF at the origin,
            // and equal steps along both axes.
            let may_hide = matches!(
                slip,
                Slip::SineForCosine | Slip::TangentForCotangent | Slip::FocalPointForgotten | Slip::AxesExchanged
            );
            let is_kept = exercise.seed <= 50 && may_hide;
            if !shows && !is_kept {
                hidden.push(exercise.seed);
            }
        }
    });
    let hiding = shown.iter().filter(|(_, (all, hidden))| {
        let hides = u32::try_from(hidden.len()).unwrap();
        hides > 0 && 4 * hides <= *all
    });
    let hiding: Vec<_> = hiding.collect();
    assert!(hiding.is_empty(), "{hiding:?}");
}

/// The code of the first diagnosis of an answer.
fn code(id: &str, seed: u64, name: &str, answer: &str) -> &'static str {
    let entry = entry(id).unwrap();
    let exercise = entry.exercise(seed, &Free::new());
    let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    let judged = check(entry, &exercise, ask, answer).unwrap();
    assert!(!judged.right, "{answer}");
    judged.diagnosis.map_or("", |diagnosis| diagnosis.causes[0].mistake.code())
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
    // D_R = n rather than n reversed.
    assert_eq!(code("0-5.1", 0, "parallel_direction", "[3/5, 4/5, 0]"), "sign");
    assert_eq!(code("0-5.1", 0, "parallel_direction", "[-3, -4, 0]"), "not-normalised");
    assert_eq!(code("0-5.1", 0, "perspective_direction", "[-4/5, 3/5, -1]"), "not-normalised");
    assert_eq!(code("0-5.1", 0, "parallel_direction", "[-3/5, -4/5]"), "wrong-shape");
}

/// B13, B17.
#[test]
fn the_figures_of_the_notes_exercises_are_those_of_the_gallery_and_hold_no_answer() {
    for (id, name) in [("0-5.1", "exercise-5.1"), ("0-5.2", "exercise-5.2"), ("0-5.3", "exercise-5.3")] {
        let shipped = camera_lab_files::ShippedFigure::named(name).unwrap();
        let shown = camera_lab::figure::read::parse(&shipped.text()).unwrap();
        let exercise = entry(id).unwrap().exercise(1, &Free::new());
        let given = &exercise.subject.figure;
        assert_eq!((given.camera, given.image, &given.scene), (shown.camera, shown.image, &shown.scene), "{id}");
    }
    // [0] 5.1 asks for the origins of the rays and their directions.
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

/// B14.
#[test]
fn statements_name_differences_from_the_notes() {
    for (id, en, pt) in [
        ("yaw", "exchanges the axes of yaw and pitch", "troca os eixos de guinada e arfagem"),
        ("pitch", "exchanges the axes of yaw and pitch", "troca os eixos de guinada e arfagem"),
        ("elevation", "turns C alone", "gira só C"),
        ("azimuth", "turns C alone", "gira só C"),
        ("dolly", "doesn't have this operation", "não tem esta operação"),
        ("pan", "doesn't have this operation", "não tem esta operação"),
    ] {
        let exercise = entry(id).unwrap().exercise(3, &Free::new());
        for (lang, word, mark) in [(Lang::En, en, "≠ notes: "), (Lang::PtBr, pt, "≠ notas: ")] {
            let said = camera_lab_words::learn::exercises::assumptions(lang, &exercise);
            assert!(said.iter().any(|text| text.starts_with(mark) && text.contains(word)), "{id}: {said:?}");
        }
    }
}

#[test]
fn calls_of_functions_are_written_as_code_in_both_languages() {
    let mut calls = BTreeSet::new();
    for lang in [Lang::En, Lang::PtBr] {
        all_of(6, |_, exercise| {
            for paragraph in camera_lab_words::learn::exercises::statement(lang, exercise) {
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
