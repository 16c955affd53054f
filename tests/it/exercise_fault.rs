//! The mistake in a student's solution, by its texts and on the command line.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;

use camera_lab::exercises::{FAULT, Free, Kind, check, entries, entry};
use camera_lab::formula;
use camera_lab_words::Lang;
use camera_lab_words::learn::exercises as said;

use crate::common::program::Bench;

#[test]
fn each_line_has_its_number_and_each_cause_a_sentence_of_its_own() {
    let mut all = 0;
    for of in entries() {
        let Some(entry) = entry(&format!("{}{FAULT}", of.id)) else { continue };
        for (seed, lang) in (0..4).zip([Lang::En, Lang::PtBr].into_iter().cycle()) {
            let exercise = entry.exercise(seed, &Free::new());
            let context = format!("{} seed {seed}", entry.id);
            let statement = said::statement(lang, &exercise);
            let lines = statement.iter().filter(|paragraph| paragraph.starts_with("**("));
            for (number, line) in (1..).zip(lines) {
                let latex = line.strip_prefix(&format!("**({number})** $")).and_then(|line| line.strip_suffix('$'));
                assert!(latex.is_some_and(|latex| formula::check_one(latex).is_ok()), "{context}: {line}");
                all += 1;
            }
            let [line, cause] = &exercise.asks[..] else { panic!("{context}") };
            let Kind::Choice(names) = &cause.kind else { panic!("{context}") };
            let sentences: BTreeSet<&str> = names.iter().map(|name| said::choice_of(lang, cause, name)).collect();
            assert!(sentences.len() == names.len() && sentences.iter().all(|text| text.len() > 10), "{context}");
            // Each answer gets its sentence, right or wrong.
            let texts = ["1", "99"].map(|text| (line, text)).into_iter();
            for (ask, text) in texts.chain(names.iter().map(|name| (cause, name.as_str()))) {
                let judged = check(entry, &exercise, ask, text).unwrap();
                assert!(said::diagnosis(lang, ask, &judged).is_some_and(|text| text.len() > 10), "{context}: {text}");
            }
        }
    }
    assert!(all > 1000, "{all}");
}

#[test]
fn the_command_line_shows_a_solution_checks_its_line_and_prints_both() {
    let bench = Bench::new("fault");
    let exercise = entry(&format!("window{FAULT}")).unwrap().exercise(7, &Free::new());
    let fault = exercise.fault().unwrap();
    let of = |command, more: &[&str]| {
        let arguments =
            ["exercise", command, "window", "--fault", "--seed", "7"].into_iter().chain(more.iter().copied());
        bench.run(&arguments.collect::<Vec<_>>())
    };
    let shown = String::from_utf8(of("show", &[]).done().to_vec()).unwrap();
    assert!(shown.contains("(window/fault)") && shown.contains(&format!("({}) ", fault.line)), "{shown}");
    let right = ["a", "b", "c", "d"][fault.causes.iter().position(|cause| *cause == fault.cause).unwrap()];
    let answers = |line: u32, cause| [format!("line={line}"), format!("cause={cause}")];
    let checked = |answers: [String; 2]| of("check", &["--answer", &answers[0], "--answer", &answers[1]]);
    checked(answers(fault.line, right)).done();
    let other = if right == "a" { "b" } else { "a" };
    for wrong in [answers(fault.line + 1, right), answers(fault.line, other)] {
        assert_eq!(checked(wrong).status, Some(1));
    }
    // A choice has no line on which it went wrong.
    bench.run(&["exercise", "show", "place-camera", "--fault"]).refused(2);
    for ending in ["md", "tex", "pdf", "xml"] {
        let [sheet, solutions] = ["sheet", "solutions"].map(|name| format!("{name}.{ending}"));
        let mut arguments = vec!["exercise", "sheet", "--ids", "basis,window/fault", "--seed", "7", "-o", &sheet];
        if ending != "xml" {
            arguments.extend(["--solutions", &solutions]);
        }
        bench.run(&arguments).done();
    }
    let text = |name: &str| String::from_utf8(bench.read(name)).unwrap();
    let cause = said::choice_of(Lang::En, &exercise.asks[1], right);
    assert!(text("sheet.md").contains(&format!("**({})** $", fault.line)), "{}", text("sheet.md"));
    let solutions = text("solutions.md");
    assert!(solutions.contains(cause) && solutions.contains(&format!("**a)** {}\n", fault.line)), "{solutions}");
}
