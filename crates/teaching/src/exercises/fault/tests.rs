use std::collections::BTreeMap;

use super::*;
use crate::exercises::{Free, entries};

/// The rows as text.
fn lines(steps: &[Worked]) -> Vec<String> {
    steps.iter().flat_map(|step| step.said().2).map(|line| format!("{line:?}")).collect()
}

#[test]
fn a_solution_is_wrong_from_one_line_on_and_the_judge_names_its_cause() {
    let (mut left_out, mut told) = (BTreeSet::new(), BTreeMap::<&str, BTreeSet<Mistake>>::new());
    let mut wrong = Vec::new();
    for entry in entries() {
        if !is_possible(&entry.exercise(0, &Free::new())) {
            left_out.insert(&*entry.id);
            continue;
        }
        for seed in 0..20 {
            let exercise = entry.exercise(seed, &Free::new());
            let mut check = |is_so: bool, what: &str| {
                if !is_so {
                    wrong.push(format!("{} seed {seed}: {what}", entry.id));
                }
            };
            let about = of_exercise(exercise);
            let Some(fault) = about.fault() else {
                check(false, "no mistake");
                continue;
            };
            told.entry(&entry.id).or_default().insert(fault.cause.mistake);
            let Some(way) = Way::new(&fault.ask) else { panic!("{} seed {seed}", entry.id) };
            let (right, theirs) = (lines(&way.steps), lines(&fault.steps));
            let at = usize::try_from(fault.line).unwrap_or_default() - 1;
            check(right.len() == theirs.len() && right[..at] == theirs[..at], "a line before it differs");
            check(right[at] != theirs[at], "it doesn't differ");
            check(lines(&about.asks[0].steps()) == right[at..=at], "the right line is another one");
            let answer = way.answer(&fault.steps);
            let entries = answer.entries.iter().copied().map(Some).collect();
            let given = Answer::Numbers { rows: answer.rows, columns: answer.columns, entries };
            let judged = judge_answer(&fault.ask, given);
            let causes = judged.diagnosis.map(|found| found.causes);
            check(!judged.right && causes == Some(vec![fault.cause]), "the judge finds another cause");
            // The cause is among three or four, and no other is true.
            check((3..=4).contains(&fault.causes.len()), "as many causes to choose from");
            let is_it = |cause: &&Cause| **cause == fault.cause;
            check(fault.causes.iter().filter(is_it).count() == 1, "the cause isn't there once");
            for other in fault.causes.iter().filter(|cause| !is_it(cause)) {
                let slips = Slip::ALL.iter().filter(|slip| slip.mistake() == other.mistake);
                let mut tables = slips.filter_map(|slip| fault.ask.expected().slipped(Slips::one(*slip)));
                let is_true = tables.any(|table| fault.ask.accepts_all(&answer.entries, &table));
                check(!is_true, &format!("{other:?} is true too"));
            }
        }
    }
    assert!(wrong.is_empty(), "{} {wrong:#?}", wrong.len());
    // Their answers are choices and cameras, and in 1-I two numbers that may only be exchanged.
    let without = ["0-5.3", "1-I", "canonical-camera", "match-picture", "place-camera", "predict-visible"];
    assert_eq!(left_out, without.into());
}
