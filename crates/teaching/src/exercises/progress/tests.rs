#![expect(clippy::unwrap_used, reason = "tests")]

use super::*;
use crate::exercises::{check, entries, entry};

/// Answers an ask of an exercise, as the window does.
fn answer(progress: &mut Progress, id: &str, seed: u64, ask: &str, text: &str, now: u64) -> bool {
    let entry = entry(id).unwrap();
    let exercise = entry.exercise(seed, &Free::new());
    let found = exercise.asks.iter().find(|found| found.name == ask).unwrap();
    let judged = check(entry, &exercise, found, text).unwrap();
    progress.judged(&exercise, &judged, now);
    judged.right
}

/// Solves an exercise with its own solution.
fn solve(progress: &mut Progress, entry: &Entry, seed: u64, now: u64) {
    let exercise = entry.exercise(seed, &Free::new());
    for ask in &exercise.asks {
        let judged = Judged {
            name: ask.name.clone(),
            right: true,
            score: 1.0,
            entries: vec![vec![true]],
            reading: "",
            conditions: Vec::new(),
            diagnosis: None,
            carried: Vec::new(),
            numbers: None,
            first_step: 0,
            understood: crate::exercises::Answer::Choice(0),
        };
        progress.judged(&exercise, &judged, now);
    }
}

#[test]
fn progress_reads_back_as_it_was_written() {
    let mut progress = Progress::default();
    assert!(progress.is_empty() && progress.to_toml().is_empty());
    assert!(!answer(&mut progress, "0-5.1", 0, "parallel_origin", "[3, 5, -1]", 1_000));
    progress.opened("0-5.1", 0, "parallel_direction", 2);
    progress.opened("0-5.1", 0, "parallel_direction", 1);
    progress.begin("basis", u64::MAX);
    let text = progress.to_toml();
    let read = Progress::read(&text).unwrap();
    assert_eq!(read.exercises, progress.exercises);
    assert_eq!(read.mistakes, progress.mistakes);
    assert_eq!(read.to_toml(), text);
    let tried = read.tried("0-5.1").unwrap();
    assert_eq!((tried.tries, tried.solved, tried.last), (1, 0, Some(1_000)));
    assert_eq!(tried.hints["parallel_direction"], 2);
    let made = read.mistakes().next().unwrap();
    assert_eq!((made.0, made.1.times, made.1.last, made.1.is_open), (Mistake::VupAsV, 1, 1_000, true));
    assert_eq!(read.tried("basis").unwrap().seed, u64::MAX);
    assert_eq!((read.stage("0-5.1"), read.stage("basis")), (Stage::Begun, Stage::Untouched));
}

#[test]
fn keys_of_another_version_stay() {
    let text = "# mine\nlater = 1\n\n[exercise.basis]\ntries = 2 # twice\nlater = [1]\n\n[exercise.\"mine of May\"]\ntries = 1\n\n\
                [mistake.later-one]\ntimes = 7\n";
    let mut progress = Progress::read(text).unwrap();
    assert_eq!(progress.tried("mine of May").unwrap().tries, 1);
    progress.opened("basis", 0, "u", 3);
    let written = progress.to_toml();
    for kept in ["# mine\nlater = 1", "later = [1]", "[exercise.\"mine of May\"]", "[mistake.later-one]\ntimes = 7"] {
        assert!(written.contains(kept), "{kept}: {written}");
    }
    assert!(written.contains("hints = { u = 3 }"), "{written}");
}

#[test]
fn an_error_in_a_damaged_file_names_its_key() {
    for (text, said) in [
        ("[exercise.basis]\ntries = \"two\"", "exercise.basis.tries cannot be read"),
        ("[exercise.basis]\ntries = -1", "exercise.basis.tries cannot be read"),
        ("[exercise.basis]\nseed = \"x\"", "exercise.basis.seed cannot be read"),
        ("exercise = 1", "exercise cannot be read"),
        ("[mistake]\nsign = 1", "mistake.sign cannot be read"),
    ] {
        assert_eq!(Progress::read(text).unwrap_err().to_string(), said);
    }
    assert!(matches!(Progress::read("[exercise"), Err(ProgressError::Toml(_))));
}

#[test]
fn a_mistake_is_open_until_its_exercise_is_solved_without_it() {
    let mut progress = Progress::default();
    let open = |progress: &Progress| progress.mistakes().filter(|(_, made)| made.is_open).count();
    answer(&mut progress, "0-5.1", 0, "parallel_origin", "[3, 5, -1]", 1);
    // Solved, but with the mistake on the way.
    solve(&mut progress, entry("0-5.1").unwrap(), 0, 2);
    assert_eq!((progress.stage("0-5.1"), open(&progress)), (Stage::Alone, 1));
    // The window has nothing to do with v.
    solve(&mut progress, entry("window").unwrap(), 0, 3);
    assert_eq!(open(&progress), 1);
    solve(&mut progress, entry("basis").unwrap(), 0, 4);
    assert_eq!(open(&progress), 0);
    // Made again, it's open again.
    answer(&mut progress, "0-5.1", 0, "parallel_origin", "[3, 5, -1]", 5);
    assert_eq!((open(&progress), progress.mistakes().next().unwrap().1.times), (1, 2));
}

#[test]
fn one_of_several_mistakes_is_not_counted() {
    let mut progress = Progress::default();
    // D_R = n, or n reversed.
    answer(&mut progress, "0-5.1", 0, "parallel_direction", "[3/5, 4/5, 0]", 1);
    assert_eq!(progress.mistakes().count(), 0);
}

#[test]
fn a_solution_counts_once_for_each_seed() {
    let (mut progress, basis) = (Progress::default(), entry("basis").unwrap());
    for (seed, solved) in [(0, 1), (0, 1), (1, 2), (1, 2)] {
        solve(&mut progress, basis, seed, 1);
        assert_eq!(progress.tried("basis").unwrap().solved, solved, "{seed}");
    }
    progress.opened("basis", 2, "u", 1);
    let tried = progress.tried("basis").unwrap();
    assert_eq!((tried.solved, tried.is_solved, tried.right.len()), (2, false, 0));
    assert_eq!(tried.tries as usize, 4 * basis.exercise(0, &Free::new()).asks.len());
}

#[test]
fn a_clock_that_jumps_by_years_keeps_no_exercise_from_coming_back() {
    const YEARS: u64 = 20 * 365 * 86_400;
    let mut progress = Progress::default();
    let some = || entries().filter(|entry| entry.is_family).take(3);
    // Years ahead, back again, to the start of clocks without a battery, and on.
    let times = [YEARS, 3 * YEARS, YEARS + 1, 0, 1, YEARS + 2];
    for (entry, now) in some().zip(times) {
        solve(&mut progress, entry, 0, now);
    }
    for start in [0, YEARS + 10, 4 * YEARS] {
        let mut came = BTreeSet::new();
        for step in 0..3 {
            let now = start + step;
            let next = progress.practise_next(some(), now).unwrap();
            assert!(matches!(next.why, Why::LongestAgo | Why::Due(_)), "{next:?}");
            solve(&mut progress, entry(&next.id).unwrap(), next.seed, now);
            came.insert(next.id);
        }
        assert_eq!(came.len(), 3, "from {start}");
    }
    // Every time that a file can hold has a date.
    let text = progress.to_toml().replace(&(YEARS + 12).to_string(), &i64::MAX.to_string());
    assert!(Progress::read(&text).is_ok_and(|progress| progress.to_csv().lines().count() > 3));
}

#[test]
fn the_next_exercise_is_chosen_for_a_reason() {
    let mut progress = Progress::default();
    let next = |progress: &Progress| {
        let next = progress.practise_next(entries(), 1_000).unwrap();
        (next.id, next.seed, next.why)
    };
    assert_eq!(next(&progress), ("0-5.1".to_owned(), 0, Why::NotSolved));
    // VUP in place of v: the first family that reveals it.
    answer(&mut progress, "0-5.1", 0, "parallel_origin", "[3, 5, -1]", 1);
    assert_eq!(next(&progress), ("basis".to_owned(), 0, Why::Mistake(Mistake::VupAsV, 1)));
    // A slip of the pen isn't a misconception.
    let mut slip = Progress::default();
    let matrix = "[[4/5/tan(25°), 0, 0, 0], [0, 1.5, 0, 0], [0, 0, -21/19, -16/19], [0, 0, -1, 0]]";
    answer(&mut slip, "perspective-matrix", 1, "Mp", matrix, 1);
    assert_eq!(slip.mistakes().next().unwrap().0, Mistake::ArithmeticSlip);
    // The exercise begun last comes up again, with its numbers.
    assert_eq!(next(&slip), ("perspective-matrix".to_owned(), 1, Why::Begun));
    // Solved without it: back to the exercise begun last, and then on to the next unsolved one.
    solve(&mut progress, entry("basis").unwrap(), 0, 2);
    assert_eq!(next(&progress), ("0-5.1".to_owned(), 0, Why::Begun));
    solve(&mut progress, entry("0-5.1").unwrap(), 0, 3);
    assert_eq!(next(&progress), ("0-5.2".to_owned(), 0, Why::NotSolved));
    // All solved: the one tried least recently, a family with new numbers.
    for (at, entry) in (10..).zip(entries()) {
        solve(&mut progress, entry, 0, if entry.id == "roll" { 5 } else { at });
    }
    assert_eq!(next(&progress), ("roll".to_owned(), 1, Why::LongestAgo));
    assert_eq!(Progress::default().practise_next([], 0), None);
}

#[test]
fn due_families_are_listed_with_the_most_overdue_first() {
    let mut progress = Progress::default();
    solve(&mut progress, entry("window").unwrap(), 0, 2 * DAY);
    solve(&mut progress, entry("basis").unwrap(), 0, DAY);
    solve(&mut progress, entry("0-5.1").unwrap(), 0, 0);
    let due = |now| progress.due(entries(), now).into_iter().map(|entry| &*entry.id).collect::<Vec<_>>();
    assert_eq!(due(DAY + 1), [""; 0]);
    assert_eq!(due(2 * DAY), ["basis"]);
    assert_eq!(due(9 * DAY), ["basis", "window"], "numbers that never change don't come back");
    assert!(entries().all(|entry| entry.minutes.is_some_and(|minutes| (4..=50).contains(&minutes))));
}

#[test]
fn a_mistake_of_which_one_was_sure_comes_first_until_it_is_practised() {
    let (question, family) = ("question-1", "basis");
    let guessed = |right, sure| {
        let mut progress = Progress::default();
        progress.guessed(question, Guess { said: "u".to_owned(), right, sure, at: 5 });
        Progress::read(&progress.to_toml()).unwrap()
    };
    let next = |progress: &Progress| progress.practise_after(entries(), 1_000, |_| Some("basis")).unwrap();
    for (right, sure) in [(true, Some(true)), (false, Some(false)), (false, None)] {
        assert_ne!(next(&guessed(right, sure)).why, Why::Sure);
    }
    let mut progress = guessed(false, Some(true));
    let first = next(&progress);
    assert_eq!((first.id.as_str(), first.why), (family, Why::Sure));
    solve(&mut progress, entry(family).unwrap(), 0, 6);
    assert_ne!(next(&progress).why, Why::Sure);
}

#[test]
fn a_wrong_guess_comes_back_the_next_day_and_then_as_its_family_does() {
    let mut progress = Progress::default();
    let two = || entries().filter(|entry| ["basis", "window"].contains(&&*entry.id));
    let next = |progress: &Progress, now| {
        let next = progress.practise_after(two(), now, |_| Some("window")).unwrap();
        (next.id, next.why)
    };
    let first = ("basis".to_owned(), Why::NotSolved);
    let again = |why| ("window".to_owned(), why);
    let at = 5 * DAY;
    let guess = |right| Guess { said: String::new(), right, sure: None, at };
    progress.guessed("right", guess(true));
    progress.guessed("wrong", guess(false));
    // A clock may have run ahead.
    for early in [0, at - 1, at, at + DAY - 1] {
        assert_eq!(next(&progress, early), first, "{early}");
    }
    assert_eq!(next(&progress, at + DAY), again(Why::Guess(1)));
    assert_eq!(next(&progress, at + 4 * DAY), again(Why::Guess(4)));
    let mut solved_at = at + DAY;
    for (seed, days) in (0..).zip([1, 3, 7, 21]) {
        solve(&mut progress, entry("window").unwrap(), seed, solved_at);
        assert_eq!(next(&progress, solved_at + (days - 1) * DAY), first, "{days}");
        solved_at += days * DAY;
        assert_eq!(next(&progress, solved_at), again(Why::Due(days)));
    }
}

/// Days after the beginning, and the reason then.
#[test]
fn a_family_comes_back_after_1_3_7_and_21_days_with_new_numbers() {
    let mut progress = Progress::default();
    let one = || entries().filter(|entry| ["basis", "window"].contains(&&*entry.id));
    let next = |progress: &Progress, now| {
        let next = progress.practise_next(one(), now).unwrap();
        (next.id, next.seed, next.why)
    };
    let mut at = 5 * DAY;
    solve(&mut progress, entry("basis").unwrap(), 0, at);
    for (seed, days) in (1..).zip([1, 3, 7, 21, 21]) {
        // A day before it's due, the other one, which isn't solved, comes first.
        assert_eq!(next(&progress, at + (days - 1) * DAY), ("window".to_owned(), 0, Why::NotSolved), "{days}");
        at += days * DAY;
        assert_eq!(next(&progress, at), ("basis".to_owned(), seed, Why::Due(days)));
        solve(&mut progress, entry("basis").unwrap(), seed, at);
    }
    // The same after writing and reading.
    let read = Progress::read(&progress.to_toml()).unwrap();
    assert_eq!(next(&read, at + 21 * DAY), ("basis".to_owned(), 6, Why::Due(21)));
}

#[test]
fn an_answer_with_help_does_not_count_as_answered_alone() {
    let (mut progress, basis) = (Progress::default(), entry("basis").unwrap());
    progress.opened("basis", 0, "u", 1);
    solve(&mut progress, basis, 0, 1);
    assert_eq!(progress.stage("basis"), Stage::Solved);
    // Nor after a look at other numbers in between.
    progress.begin("basis", 1);
    solve(&mut progress, basis, 0, 2);
    assert_eq!(progress.stage("basis"), Stage::Solved);
    let mut read = Progress::read(&progress.to_toml()).unwrap();
    assert_eq!(read.tried("basis"), progress.tried("basis"));
    solve(&mut read, basis, 2, 3);
    assert_eq!(read.stage("basis"), Stage::Alone);
}

#[test]
fn wrong_answers_in_a_row_are_counted() {
    let mut progress = Progress::default();
    let wrong = |progress: &Progress| progress.tried("window").map_or(0, |tried| tried.wrong);
    for count in 1..=MANY_WRONG {
        assert!(!answer(&mut progress, "window", 0, "H", "12345", 1));
        assert_eq!(wrong(&progress), count);
    }
    let right = entry("window").unwrap().exercise(0, &Free::new()).asks[0].expected().table().unwrap().entries[0];
    assert!(answer(&mut progress, "window", 0, "H", &right.to_string(), 2));
    assert_eq!(wrong(&progress), 0);
}

#[test]
fn it_becomes_a_table() {
    let mut progress = Progress::default();
    // 29 February 2024, 23:59:59.
    answer(&mut progress, "0-5.1", 0, "parallel_origin", "[3, 5, -1]", 1_709_251_199);
    progress.opened("0-5.1", 0, "parallel_direction", 2);
    progress.begin("a, \"b\"", 0);
    let table = "kind,name,tries,solved,last,seed,hints,open,alone,exercise,student\n\
                 exercise,0-5.1,1,0,2024-02-29T23:59:59Z,0,2,,0,,\n\
                 exercise,\"a, \"\"b\"\"\",0,0,,0,0,,0,,\n\
                 mistake,vup-as-v,1,,2024-02-29T23:59:59Z,,,true,,0-5.1,\n";
    assert_eq!(progress.to_csv(), table);
    for (seconds, said) in
        [(0, "1970-01-01T00:00:00Z"), (946_684_800, "2000-01-01T00:00:00Z"), (4_107_542_400, "2100-03-01T00:00:00Z")]
    {
        assert_eq!(date(seconds), said);
    }
}

#[test]
fn one_step_fewer_is_given_after_a_success_and_one_more_after_a_failure() {
    const STEPS: u32 = 3;
    let mut progress = Progress::default();
    let given = |progress: &Progress| progress.given_steps("basis", STEPS as usize);
    assert_eq!(given(&progress), 3);
    solve(&mut progress, entry("basis").unwrap(), 0, 1);
    // Steps right and wrong, with other numbers each time, and the number of given ones after them.
    let (t, f) = (true, false);
    let steps = [(t, 1), (t, 0), (t, 0), (f, 1), (t, 0), (f, 1), (f, 2), (f, 3), (f, 3), (t, 2)];
    for (seed, (right, after)) in (1..).zip(steps) {
        progress.stepped("basis", seed, "v", STEPS, right);
        // Once more with the same numbers doesn't count, nor does solving the exercise then.
        progress.stepped("basis", seed, "v", STEPS, !right);
        solve(&mut progress, entry("basis").unwrap(), seed, 1);
        assert_eq!(given(&progress), after, "{seed}");
        let read = Progress::read(&progress.to_toml()).unwrap();
        assert_eq!(read.exercises, progress.exercises);
        progress = read;
    }
    // Of another family, and of a shorter solution.
    assert_eq!(progress.given_steps("window", 3), 3);
    assert_eq!((progress.given_steps("basis", 1), progress.given_steps("basis", 0)), (0, 0));
    // A file from before there was the key.
    let old = Progress::read("[exercise.basis]\nsolved = 2\n").unwrap();
    assert_eq!(given(&old), 1);
    assert_eq!(Progress::read(&old.to_toml()).unwrap().exercises, old.exercises);
}
