//! Numbers that a statement leaves to the student: F and B of 5.2, θ and A of III, found in the answers.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::cell::Cell;

use camera_lab::exercises::{Answer, Entry, Exercise, Free, Judged, check_beside, entry, read_answer};
use camera_lab_words::Lang;
use camera_lab_words::learn::exercises as said;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// The choices of the property tests: F, B − F, θ and A.
fn choices() -> impl Strategy<Value = [f64; 4]> {
    [0.05..30.0_f64, 0.2..100.0_f64, 10.0..150.0_f64, 0.25..4.0_f64]
}

fn runner() -> TestRunner {
    TestRunner::new_with_rng(
        Config { cases: 200, failure_persistence: None, ..Config::default() },
        proptest::test_runner::TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::ChaCha),
    )
}

fn free(numbers: &[(&str, f64)]) -> Free {
    numbers.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect()
}

/// Both exercises with a choice, and the questions whose answers hold it, the first to decide first.
fn chosen([near, deep, theta, aspect]: [f64; 4]) -> [(&'static Entry, Exercise, [&'static str; 3]); 2] {
    let [zoomed, projected] = ["0-5.2", "1-III"].map(|id| entry(id).unwrap());
    [
        (zoomed, zoomed.exercise(0, &free(&[("F", near), ("B", near + deep)])), ["Mp", "corner", ""]),
        (projected, projected.exercise(0, &free(&[("theta", theta), ("A", aspect)])), ["Mp", "clip", "apex"]),
    ]
}

/// The right answer of an exercise, row by row.
fn right(exercise: &Exercise, name: &str) -> Vec<f64> {
    exercise.asks.iter().find(|ask| ask.name == name).unwrap().expected().table().unwrap().entries
}

/// Answers to an exercise of the statement's numbers, each typed with this many digits and judged beside the others.
fn judged(entry: &Entry, with: &Free, answers: &[(&str, Vec<f64>)], digits: usize) -> Vec<Judged> {
    let exercise = entry.exercise(0, with);
    let ask = |name: &str| exercise.asks.iter().find(|ask| ask.name == name).unwrap();
    let text = |name: &str, entries: &[f64]| {
        let [_, columns] = ask(name).shape();
        let list = |row: &[f64]| {
            let row: Vec<String> = row.iter().map(|number| format!("{number:.0$e}", digits - 1)).collect();
            format!("[{}]", row.join(", "))
        };
        if columns == 1 {
            list(entries)
        } else {
            format!("[{}]", entries.chunks(columns).map(list).collect::<Vec<_>>().join(", "))
        }
    };
    let all: Vec<(String, Answer)> = answers
        .iter()
        .map(|(name, entries)| {
            let text = text(name, entries);
            ((*name).to_owned(), read_answer(&text, ask(name), &exercise.free).unwrap())
        })
        .collect();
    answers
        .iter()
        .map(|(name, entries)| check_beside(entry, &exercise, ask(name), &text(name, entries), &all).unwrap())
        .collect()
}

fn alone(entry: &Entry, name: &str, entries: &[f64], digits: usize) -> Judged {
    judged(entry, &Free::new(), &[(name, entries.to_vec())], digits).remove(0)
}

#[test]
fn right_answers_are_right_for_the_numbers_that_they_hold() {
    let judged_alone = Cell::new(0);
    runner()
        .run(&choices(), |numbers| {
            for (entry, exercise, deciding) in chosen(numbers) {
                for name in deciding.into_iter().filter(|name| !name.is_empty()) {
                    for digits in [16, 6, 4] {
                        let verdict = alone(entry, name, &right(&exercise, name), digits);
                        prop_assert!(verdict.right, "{} {name} {digits}: {numbers:?}", entry.id);
                        judged_alone.set(judged_alone.get() + 1);
                    }
                }
                let all: Vec<(&str, Vec<f64>)> =
                    exercise.asks.iter().map(|ask| (ask.name.as_str(), right(&exercise, &ask.name))).collect();
                for verdict in judged(entry, &Free::new(), &all, 12) {
                    prop_assert!(verdict.right, "{} {}: {numbers:?}", entry.id, verdict.name);
                    let own = verdict.numbers.unwrap();
                    prop_assert_eq!(own.ask, "Mp");
                    for (name, value) in own.values {
                        let given = exercise.free.iter().find(|(other, _)| *other == name).unwrap().1;
                        prop_assert!((value - given).abs() <= 1e-9 * given, "{name}: {value} {given}");
                    }
                }
            }
            Ok(())
        })
        .unwrap();
    assert_eq!(judged_alone.get(), 200 * 5 * 3);
}

/// Two entries that are both free can be those of another choice, if they change places: `m_11` and `m_22` of III, x
/// and y of its apex.
fn are_free(id: &str, name: &str, places: [usize; 2]) -> bool {
    id == "1-III" && (name == "Mp" && places == [0, 5] || name == "apex" && places == [0, 1])
}

#[test]
fn an_entry_with_another_sign_or_in_another_place_is_wrong() {
    let wrong = Cell::new(0);
    runner()
        .run(&(choices(), 0..1000_usize, 0..1000_usize), |(numbers, first, second)| {
            for (entry, exercise, deciding) in chosen(numbers) {
                for name in deciding.into_iter().filter(|name| !name.is_empty()) {
                    let entries = right(&exercise, name);
                    let there: Vec<usize> = (0..entries.len()).filter(|k| entries[*k] != 0.0).collect();
                    let k = there[first % there.len()];
                    let mut other = entries.clone();
                    other[k] = -other[k];
                    prop_assert!(!alone(entry, name, &other, 12).right, "{} {name} −{k}: {numbers:?}", entry.id);
                    // As good as equal entries may change places.
                    let differs = |place: &usize| (entries[k] - entries[*place]).abs() > 4e-3 * entries[k].abs();
                    let is_wrong =
                        |place: &usize| differs(place) && !are_free(&entry.id, name, [k.min(*place), k.max(*place)]);
                    let places: Vec<usize> = (0..entries.len()).filter(is_wrong).collect();
                    let place = places[second % places.len()];
                    let mut other = entries.clone();
                    other.swap(k, place);
                    let verdict = alone(entry, name, &other, 12);
                    prop_assert!(!verdict.right, "{} {name} {k} ↔ {place}: {numbers:?}", entry.id);
                    wrong.set(wrong.get() + 2);
                }
            }
            Ok(())
        })
        .unwrap();
    assert_eq!(wrong.get(), 200 * 5 * 2);
}

/// The examples of students who chose F = 1, F = 3 with B = 10, and θ = 60° with A = 4/3, the last with four digits.
#[test]
fn the_verdict_names_the_numbers_and_the_answer_that_decided() {
    let [zoomed, projected] = ["0-5.2", "1-III"].map(|id| entry(id).unwrap());
    let corner = [6.10314, 0.568414, 0.214861];
    let said = |verdict: &Judged| said::own_numbers(Lang::En, verdict).unwrap_or_default();
    let verdict = alone(zoomed, "corner", &corner, 6);
    assert!(verdict.right);
    assert_eq!(said(&verdict), "It's right for F = 1.");
    let mut matrix = vec![4.0 / 3.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -2.0 / 7.0, -13.0 / 7.0];
    matrix.extend([0.0, 0.0, 0.0, 1.0]);
    for digits in [12, 4, 3] {
        let verdict = alone(zoomed, "Mp", &matrix, digits);
        assert!(verdict.right, "{digits}");
        assert_eq!(said(&verdict), "It's right for F = 3 and B = 10.");
    }
    // One decides for all, and the other one says why it's wrong.
    let both = judged(zoomed, &Free::new(), &[("corner", corner.to_vec()), ("Mp", matrix.clone())], 6);
    assert!(!both[0].right && both[1].right && both[0].diagnosis.is_none());
    let reason = "This is right for F = 1. But your Mp holds F = 3 and B = 10. Use the same numbers in all answers.";
    assert_eq!(said(&both[0]), reason);
    let of_statement = right(&zoomed.exercise(0, &Free::new()), "Mp");
    let both = judged(zoomed, &Free::new(), &[("corner", corner.to_vec()), ("Mp", of_statement)], 6);
    assert!(!both[0].right && both[1].right && both[1].numbers.is_none());
    assert!(said(&both[0]).contains("your Mp holds F = 5 and B = 20"), "{}", said(&both[0]));
    // Given numbers decide.
    assert!(!judged(zoomed, &free(&[("F", 5.0), ("B", 20.0)]), &[("corner", corner.to_vec())], 6)[0].right);
    assert!(judged(zoomed, &free(&[("F", 1.0)]), &[("corner", corner.to_vec())], 6)[0].right);
    let mut matrix = vec![1.299, 0.0, 0.0, 0.0, 0.0, 1.732, 0.0, 0.0, 0.0, 0.0, -1.002, -0.3003];
    matrix.extend([0.0, 0.0, -1.0, 0.0]);
    let verdict = alone(projected, "Mp", &matrix, 4);
    assert!(verdict.right);
    assert_eq!(said(&verdict), "It's right for θ = 60° and A = 4/3.");
}

#[test]
fn a_known_mistake_with_the_numbers_of_the_statement_is_that_mistake() {
    let projected = entry("1-III").unwrap();
    // cot(45) of radians, and 1/W for 2/W, are cotangents of other angles too.
    for (scale, code) in [(1.0 / 45.0_f64.tan(), "radians"), (0.5, "factor-two")] {
        let mut entries = right(&projected.exercise(0, &Free::new()), "Mp");
        (entries[0], entries[5]) = (scale, scale);
        let verdict = alone(projected, "Mp", &entries, 12);
        let told = verdict.diagnosis.as_ref().map(|diagnosis| diagnosis.causes[0].mistake.code());
        assert!(!verdict.right && told == Some(code), "{verdict:?}");
    }
    // Numbers out of their range.
    for numbers in [[("theta", 160.0), ("A", 1.0)], [("theta", 60.0), ("A", 5.0)], [("theta", 5.0), ("A", 1.0)]] {
        let outside = right(&projected.exercise(0, &free(&numbers)), "Mp");
        assert!(!alone(projected, "Mp", &outside, 12).right, "{numbers:?}");
    }
}
