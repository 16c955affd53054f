//! Progress in exercises, in its file.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::fs;

use eframe::egui;

use crate::exercises::{Free, Stage, check, entry};
use crate::gui::app::preferences::store::tests::Folder;
use crate::gui::app::state::State;
use crate::gui::learn::exercises::state::{Chosen, Done, Typed};
use camera_lab_desk::News;

fn basis() -> Chosen {
    Chosen { id: "basis".to_owned(), seed: 3 }
}

fn typed(text: &str) -> Typed {
    let fields = [text, "", "0,5\n\"'"].map(str::to_owned).to_vec();
    Typed {
        answers: [("u".to_owned(), fields)].into(),
        free: [("F".to_owned(), "2".to_owned())].into(),
        judged: ["u".to_owned()].into(),
        guesses: [("u".to_owned(), vec!["0".to_owned()])].into(),
    }
}

/// VUP in the place of **v**, judged.
fn mistaken(state: &mut State) {
    let entry = entry("0-5.1").unwrap();
    let exercise = entry.exercise(0, &Free::new());
    let ask = exercise.asks.iter().find(|ask| ask.name == "parallel_origin").unwrap();
    let judged = check(entry, &exercise, ask, "[3, 5, -1]").unwrap();
    state.learn.exercises.note(Done::Judged(exercise.clone().into(), judged.into(), 1_000));
}

fn times(state: &State) -> Vec<u32> {
    state.learn.exercises.progress.mistakes().map(|(_, made)| made.times).collect()
}

fn file(folder: &Folder, name: &str) -> String {
    fs::read_to_string(folder.0.join(name)).unwrap_or_default()
}

#[test]
fn of_two_windows_nothing_is_lost() {
    let folder = Folder::new("progress-two");
    let ((mut one, mut of_one), (mut two, mut of_two)) = (folder.window(), folder.window());
    mistaken(&mut one);
    one.learn.exercises.typed.insert(basis(), typed("1/sqrt(3)"));
    of_one.keep(&egui::Context::default(), &mut one);
    of_one.finish(&mut one);
    mistaken(&mut two);
    mistaken(&mut two);
    two.learn.exercises.note(Done::WasSolved("window".to_owned()));
    two.learn.exercises.typed.insert(Chosen { seed: 4, ..basis() }, typed("2"));
    of_two.keep(&egui::Context::default(), &mut two);
    of_two.finish(&mut two);
    assert_eq!((times(&two), two.learn.exercises.unwritten.len()), (vec![3], 0), "this window knows of the other one");
    let (mut third, mut of_third) = folder.window();
    assert_eq!((times(&third), third.learn.exercises.stage("window")), (vec![3], Stage::Solved));
    assert_eq!(third.learn.exercises.typed[&basis()], typed("1/sqrt(3)"));
    assert_eq!(third.learn.exercises.typed.len(), 2);
    // Answers taken back disappear from the file.
    third.learn.exercises.typed.insert(basis(), Typed::default());
    of_third.finish(&mut third);
    assert!(!file(&folder, "progress.toml").contains("basis 3"));
    assert_eq!(file(&folder, "preferences.toml"), "", "none of it is a preference");
}

#[test]
fn answers_kept_in_old_preferences_are_read_once() {
    let folder = Folder::new("progress-before");
    fs::create_dir_all(&folder.0).unwrap();
    let before = "digits = 7\n\"answers basis 3\" = { u = [\"1\", \"\"], \"is solved\" = true } \n";
    fs::write(folder.0.join("preferences.toml"), before).unwrap();
    let (mut state, mut preferences) = folder.window();
    assert_eq!(state.learn.exercises.typed[&basis()].answers["u"], ["1", ""]);
    preferences.finish(&mut state);
    assert_eq!(file(&folder, "preferences.toml"), "digits = 7\n");
    let (mut next, mut preferences) = folder.window();
    assert_eq!(next.learn.exercises.stage("basis"), Stage::Solved);
    assert_eq!(next.learn.exercises.typed[&basis()].answers["u"], ["1", ""]);
    // Once deleted, it doesn't come back. The file stays under another name.
    let kept = file(&folder, "progress.toml");
    next.learn.exercises.forgets = true;
    preferences.keep(&egui::Context::default(), &mut next);
    assert!(next.learn.exercises.progress.is_empty() && next.learn.exercises.typed.is_empty());
    assert!(matches!(&next.model.message, Some(message) if !message.is_error()));
    assert_eq!((file(&folder, "progress.toml"), file(&folder, "progress.bak")), (String::new(), kept));
    // The same answer, typed again, is written again.
    next.learn.exercises.typed.insert(basis(), typed("1"));
    preferences.finish(&mut next);
    let (last, _) = folder.window();
    assert_eq!((last.learn.exercises.stage("basis"), last.learn.exercises.typed.len()), (Stage::Begun, 1));
}

#[test]
fn a_damaged_file_is_set_aside_and_reported() {
    for bytes in [&b"[exercise.basis]\ntries = \"two\"\n"[..], b"answers = [", &[0xff, 0x00]] {
        let folder = Folder::new("progress-damaged");
        fs::create_dir_all(&folder.0).unwrap();
        fs::write(folder.0.join("progress.toml"), bytes).unwrap();
        let (mut state, mut preferences) = folder.window();
        let news = preferences.news();
        let [News::ProgressSetAside(aside)] = &news[..] else { panic!("{news:?}") };
        assert_eq!(fs::read(aside).unwrap(), bytes);
        mistaken(&mut state);
        preferences.finish(&mut state);
        assert_eq!(times(&folder.window().0), [1]);
    }
}
