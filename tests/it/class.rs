//! `exercise report`: what a class got wrong, from the progress of its students.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::time::{Duration, Instant};

use camera_lab::exercises::{Free, Progress, check, entry};
use serde_json::{Value, json};

use crate::common::program::Bench;

/// Answers a question of an exercise, as the window does.
fn answer(progress: &mut Progress, (id, ask): (&str, &str), text: &str, now: u64) {
    let entry = entry(id).unwrap();
    let exercise = entry.exercise(0, &Free::new());
    let asked = exercise.asks.iter().find(|asked| asked.name == ask).unwrap();
    progress.judged(&exercise, &check(entry, &exercise, asked, text).unwrap(), now);
}

const V: (&str, &str) = ("0-5.1", "parallel_origin");
/// VUP in place of **v**.
const WRONG: &str = "[3, 5, -1]";

fn window_solved(progress: &mut Progress, now: u64) {
    let exercise = entry("window").unwrap().exercise(0, &Free::new());
    for ask in &exercise.asks {
        let right = ask.expected().table().unwrap().entries[0];
        answer(progress, ("window", &ask.name), &right.to_string(), now);
    }
}

fn report(bench: &Bench, files: &[&str]) -> Value {
    bench.run(&[&["exercise", "report", "--format", "json"], files].concat()).json()
}

fn of<'a>(report: &'a Value, id: &str) -> &'a Value {
    report["exercises"].as_array().unwrap().iter().find(|row| row["id"] == id).unwrap_or(&Value::Null)
}

/// The names of those who solved an exercise without help, with help, and not yet.
fn who(without_help: &[&str], with_help: &[&str], not_yet: &[&str]) -> Value {
    json!({ "without_help": without_help, "with_help": with_help, "not_yet": not_yet })
}

#[test]
fn a_class_is_counted_from_progress_files_and_tables() {
    let bench = Bench::new("class");
    let mut ana = Progress::default();
    ana.student = Some("Ana".to_owned());
    answer(&mut ana, V, WRONG, 10);
    window_solved(&mut ana, 20);
    let mut bia = Progress::default();
    answer(&mut bia, V, WRONG, 30);
    bia.opened("window", 0, "W", 1);
    window_solved(&mut bia, 40);
    bench.write("one.toml", ana.to_toml());
    bench.write("bia.csv", format!("\u{feff}{}", bia.to_csv().replace(',', ";")));
    let counted = report(&bench, &["one.toml", "bia.csv"]);
    assert_eq!((&counted["students"], &counted["skipped"]), (&json!(2), &json!([])));
    let expected = json!({
        "id": "0-5.1", "solved": 0, "alone": 0, "tried": 2, "who": who(&[], &[], &["Ana", "bia"]),
        "mistakes": [{ "code": "vup-as-v", "count": 2 }],
    });
    assert_eq!(*of(&counted, "0-5.1"), expected);
    let by = who(&["Ana"], &["bia"], &[]);
    let expected = json!({ "id": "window", "solved": 2, "alone": 1, "tried": 2, "who": by, "mistakes": [] });
    assert_eq!(*of(&counted, "window"), expected);
    assert_eq!(counted["discuss"], json!(["vup-as-v"]));
    // The table of the same student is the same work, and earlier work doesn't replace it.
    bench.write("again.csv", ana.to_csv());
    let mut before = Progress::default();
    before.student = Some("Ana".to_owned());
    answer(&mut before, V, "[0, 0, 0]", 1);
    bench.write("before.toml", before.to_toml());
    for files in [["one.toml", "again.csv", "before.toml"], ["before.toml", "again.csv", "one.toml"]] {
        let counted = report(&bench, &files);
        assert_eq!((&counted["students"], &of(&counted, "window")["alone"]), (&json!(1), &json!(1)), "{files:?}");
    }
}

/// A mistake stays with the exercise in which it was made, whatever numbers and exercises come after it.
#[test]
fn mistakes_stay_with_their_exercises() {
    let bench = Bench::new("class-mistakes");
    let mut progress = Progress::default();
    answer(&mut progress, V, WRONG, 10);
    progress.begin("0-5.1", 1);
    let basis = entry("basis").unwrap().exercise(0, &Free::new());
    answer(&mut progress, ("basis", "v"), &format!("{:?}", basis.subject.figure.camera.view_up.to_array()), 20);
    bench.write("a.toml", progress.to_toml());
    bench.write("b.csv", progress.to_csv());
    for file in ["a.toml", "b.csv"] {
        let counted = report(&bench, &[file]);
        for id in ["0-5.1", "basis"] {
            assert_eq!(of(&counted, id)["mistakes"], json!([{ "code": "vup-as-v", "count": 1 }]), "{file} {id}");
        }
        assert_eq!(counted["mistakes"], json!([{ "code": "vup-as-v", "count": 1 }]), "a student counts once");
    }
}

/// Tables of before have neither a student, nor *alone*, nor the exercise of a mistake.
#[test]
fn older_tables_are_read_and_others_are_named_and_skipped() {
    let bench = Bench::new("class-older");
    let old = "kind,name,tries,solved,last,seed,hints,open\n\
               exercise,basis,3,1,1970-01-01T00:00:10Z,0,0,\n\
               mistake,vup-as-v,2,,1970-01-01T00:00:10Z,,,true\nguess,camera.1,1,1,1970-01-01T00:00:10Z,,,\n";
    bench.write("carla.csv", old);
    bench.write("empty.toml", "");
    bench.write("other.toml", "[camera]\nposition = [1, 2, 3]\n");
    bench.write("broken.toml", "[exercise.basis]\ntries = \"two\"");
    bench.write("table.csv", "a,b\n1,2\n");
    bench.write("cell.csv", old.replace(",3,1,", ",three,1,"));
    bench.write("image.png", "\u{89}PNG\r\n");
    let files =
        ["carla.csv", "empty.toml", "other.toml", "broken.toml", "table.csv", "cell.csv", "image.png", "none.csv"];
    let counted = report(&bench, &files);
    assert_eq!(counted["students"], json!(1));
    let by = who(&[], &["carla"], &[]);
    let expected = json!({ "id": "basis", "solved": 1, "alone": 0, "tried": 1, "who": by, "mistakes": [] });
    assert_eq!(*of(&counted, "basis"), expected);
    assert_eq!(counted["mistakes"], json!([{ "code": "vup-as-v", "count": 1 }]));
    let skipped = counted["skipped"].as_array().unwrap();
    let names: Vec<&str> = skipped.iter().filter_map(|skipped| skipped["file"].as_str()).collect();
    assert_eq!(names, files[1..]);
    let reason =
        |name: &str| skipped.iter().find(|skipped| skipped["file"] == name).unwrap()["reason"].as_str().unwrap();
    assert!(reason("cell.csv").contains("tries") && reason("cell.csv").contains("line 2"), "{}", reason("cell.csv"));
    assert!(reason("broken.toml").contains("exercise.basis.tries"));
    // Nothing but such files is no error, and the report says so.
    let text = bench.run(&["exercise", "report", "table.csv", "--lang", "pt-BR"]);
    let text = String::from_utf8_lossy(text.done()).into_owned();
    assert!(text.contains("0 alunos") && text.contains("table.csv: "), "{text}");
}

/// Several students in one table, with columns in another order and names with commas.
#[test]
fn a_table_may_hold_a_whole_class() {
    let bench = Bench::new("class-table");
    let rows = "student;kind;name;solved;tries;alone;exercise;last\n\
                \"Silva; Ana\";exercise;basis;2;4;1;;1970-01-01T00:00:10Z\n\
                \"Silva; Ana\";mistake;of-tomorrow;;1;;basis;\nRui;exercise;basis;0;1;0;;\n";
    bench.write("all.csv", rows);
    let counted = report(&bench, &["all.csv"]);
    let expected = json!({
        "id": "basis", "solved": 1, "alone": 1, "tried": 2, "who": who(&["Silva; Ana"], &[], &["Rui"]),
        "mistakes": [{ "code": "of-tomorrow", "count": 1 }],
    });
    assert_eq!((&counted["students"], of(&counted, "basis")), (&json!(2), &expected));
    // As a table and as a page.
    let table = bench.run(&["exercise", "report", "all.csv", "--format", "csv"]);
    let table = String::from_utf8_lossy(table.done()).into_owned();
    assert_eq!(table, "exercise,tried,solved,alone,mistake,students\nbasis,2,1,1,,\nbasis,,,,of-tomorrow,1\n");
    bench.run(&["exercise", "report", "all.csv", "-o", "page.pdf"]).done();
    assert!(bench.read("page.pdf").starts_with(b"%PDF"));
    assert!(bench.run(&["exercise", "report", "all.csv", "-o", "page.png"]).refused(2).contains(".pdf"));
}

#[test]
fn forty_files_take_less_than_a_second() {
    let bench = Bench::new("class-forty");
    let mut progress = Progress::default();
    for entry in camera_lab::exercises::entries() {
        progress.was_solved(&entry.id);
    }
    answer(&mut progress, V, WRONG, 10);
    let names: Vec<String> = (0..40).map(|k| format!("{k}.toml")).collect();
    for name in &names {
        bench.write(name, progress.to_toml());
    }
    let files: Vec<&str> = names.iter().map(String::as_str).collect();
    let begun = Instant::now();
    let counted = report(&bench, &files);
    // The program isn't optimized here, and others use the machine.
    assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
    assert_eq!((&counted["students"], &of(&counted, "0-5.1")["mistakes"][0]["count"]), (&json!(40), &json!(40)));
}
