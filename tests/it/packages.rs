//! Lessons and exercises for course platforms, read by another reader of zips.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::collections::BTreeMap;

use camera_lab::lessons::{Task, parse, shipped};
use serde_json::Value;

use crate::common::program::Bench;

/// A page of this version, as far as the program looks.
const PAGE: &str = concat!(
    "<!DOCTYPE html><meta name=\"camera-lab\" content=\"",
    env!("CARGO_PKG_VERSION"),
    "\">Stand-in for the page"
);

fn number(bytes: &[u8], at: usize, length: usize) -> usize {
    bytes[at..at + length].iter().rev().fold(0, |number, byte| number << 8 | usize::from(*byte))
}

/// The files of a zip, by its central directory.
fn files(zip: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let end = zip.len() - 22;
    assert_eq!(&zip[end..end + 4], b"PK\x05\x06");
    let (count, mut at) = (number(zip, end + 10, 2), number(zip, end + 16, 4));
    assert_eq!(at + number(zip, end + 12, 4), end, "the directory ends where the end begins");
    let mut files = BTreeMap::new();
    for _ in 0..count {
        assert_eq!(&zip[at..at + 4], b"PK\x01\x02");
        assert_eq!(number(zip, at + 10, 2), 0, "stored");
        let (length, names) = (number(zip, at + 24, 4), number(zip, at + 28, 2));
        let name = String::from_utf8(zip[at + 46..at + 46 + names].to_vec()).unwrap();
        let local = number(zip, at + 42, 4);
        assert_eq!(&zip[local..local + 4], b"PK\x03\x04");
        // Version to flags, packing, time, checksum, lengths: the same in both places.
        assert_eq!(zip[local + 4..local + 30], zip[at + 6..at + 32]);
        assert_eq!(&zip[local + 30..local + 30 + names], name.as_bytes());
        files.insert(name, zip[local + 30 + names..local + 30 + names + length].to_vec());
        at += 46 + names;
    }
    files
}

fn text(files: &BTreeMap<String, Vec<u8>>, name: &str) -> String {
    String::from_utf8(files[name].clone()).unwrap()
}

/// What `lesson.js` hands over.
fn course(files: &BTreeMap<String, Vec<u8>>) -> Value {
    let script = text(files, "lesson.js");
    let json = script.trim_end().strip_prefix("'use strict';\nconst cameraLabCourse = ").unwrap();
    serde_json::from_str(json.strip_suffix(';').unwrap()).unwrap()
}

/// What every platform needs to find.
fn holds_one_item(files: &BTreeMap<String, Vec<u8>>) {
    let manifest = text(files, "imsmanifest.xml");
    for needed in [
        "xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\"",
        "xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_rootv1p2\"",
        "<schema>ADL SCORM</schema>",
        "<schemaversion>1.2</schemaversion>",
        "adlcp:scormtype=\"sco\" href=\"index.html\"",
        "identifierref=\"resource\"",
    ] {
        assert_eq!(manifest.matches(needed).count(), 1, "{needed}: {manifest}");
    }
    let named: Vec<&str> =
        manifest.split("<file href=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    let there: Vec<&str> = files.keys().map(String::as_str).filter(|name| *name != "imsmanifest.xml").collect();
    assert_eq!(named.len(), there.len());
    assert!(there.iter().all(|name| named.contains(name)), "{named:?} {there:?}");
}

#[test]
fn every_lesson_is_packed_with_all_its_questions() {
    let bench = Bench::new("packages");
    bench.write("page.html", PAGE);
    for shipped in shipped() {
        let lesson = &shipped.lesson;
        bench.run(&["lesson", "package", &lesson.id, "--page", "page.html", "--pass", "60", "-o", "out.zip"]).done();
        let files = files(&bench.read("out.zip"));
        holds_one_item(&files);
        assert_eq!(text(&files, "camera-lab.html"), PAGE);
        let course = course(&files);
        assert_eq!((&course["lesson"], &course["pass"]), (&lesson.id.as_str().into(), &60.0.into()));
        assert_eq!(course["steps"], lesson.steps.len());
        let tasks =
            lesson.steps.iter().filter(|step| matches!(step.task, Some(Task::Question(_) | Task::Exercise { .. })));
        assert!(course["questions"].as_array().unwrap().len() >= tasks.count());
    }
}

#[test]
fn exercises_are_a_lesson_with_a_step_for_each() {
    let bench = Bench::new("packed-exercises");
    bench.write("page.html", PAGE);
    let all: Vec<&str> = camera_lab::exercises::entries().map(|entry| &*entry.id).collect();
    let ids = all.join(",");
    let pack = ["exercise", "package", "--ids", &ids, "--seed", "7", "--page", "page.html", "-o", "out.zip"];
    bench.run(&pack).done();
    let zip = bench.read("out.zip");
    let files = files(&zip);
    holds_one_item(&files);
    let lesson = parse(course(&files)["lesson"].as_str().unwrap()).unwrap();
    let asked: Vec<(&str, u64)> = lesson
        .steps
        .iter()
        .map(|step| match &step.task {
            Some(Task::Exercise { id, seed }) => (id.as_str(), *seed),
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(asked, all.iter().map(|id| (*id, 7)).collect::<Vec<_>>());
    bench.run(&pack).done();
    assert!(bench.read("out.zip") == zip, "the same command gives the same bytes");
}

#[test]
fn a_lesson_of_your_own_travels_whole_and_its_files_are_refused() {
    let bench = Bench::new("packed-own");
    bench.write("page.html", PAGE);
    let lesson = "id = \"mine\"\ntitle = \"A < B & \\\"C\\\"\"\n\n[[step]]\ntitle = \"One\"\ntext = \"One.\"\n";
    bench.write("mine.toml", lesson);
    bench.run(&["lesson", "package", "mine.toml", "--page", "page.html", "-o", "out.zip"]).done();
    let files = files(&bench.read("out.zip"));
    assert_eq!(course(&files)["lesson"], lesson);
    assert!(text(&files, "imsmanifest.xml").contains("<title>A &lt; B &amp; &quot;C&quot;</title>"));
    assert!(text(&files, "index.html").contains("<title>A &lt; B &amp; &quot;C&quot;</title>"));

    let mesh = "\n[[step.scene.objects]]\nname = \"m\"\nshape = \"mesh\"\npath = \"m.obj\"\n";
    bench.write("mesh.toml", format!("{lesson}{mesh}"));
    let run = bench.run(&["lesson", "package", "mesh.toml", "--page", "page.html", "-o", "mesh.zip"]);
    assert!(run.refused(2).contains("m.obj"));
}

#[test]
fn another_page_and_impossible_values_are_refused() {
    let bench = Bench::new("packed-badly");
    bench.write("page.html", PAGE);
    bench.write("older.html", PAGE.replace(env!("CARGO_PKG_VERSION"), "0.0.1"));
    bench.write("served.html", format!("{PAGE}<script src=\"./camera-lab.js\"></script>"));
    bench.write("empty.html", "");
    for page in ["older.html", "served.html", "empty.html", "missing.html"] {
        let run = bench.run(&["lesson", "package", "basis", "--page", page, "-o", "out.zip"]);
        assert!(run.refused(2).contains(page));
    }
    for pass in ["-1", "101", "NaN", "half", ""] {
        let run = bench.run(&["lesson", "package", "basis", "--page", "page.html", "--pass", pass, "-o", "out.zip"]);
        assert!(run.refused(2).contains("0 to 100"));
    }
    let run = bench.run(&["exercise", "package", "--ids", "basis,nothing", "--page", "page.html", "-o", "out.zip"]);
    assert!(run.refused(2).contains("nothing"));
    assert!(!bench.names().contains(&"out.zip".to_owned()));
}

/// The page that a lecturer hands out opens with their lesson, also if it opened with another before.
#[test]
fn a_page_for_students_opens_a_lesson() {
    let bench = Bench::new("handed-out");
    bench.write("page.html", PAGE);
    let lesson = "id = \"mine\"\ntitle = \"Mine\"\n\n[[step]]\ntitle = \"One\"\ntext = \"One.\"\n";
    bench.write("mine.toml", lesson);
    bench.run(&["lesson", "page", "mine.toml", "--page", "page.html", "-o", "out.html"]).done();
    let page = String::from_utf8(bench.read("out.html")).unwrap();
    let link = page.split("location.replace('").nth(1).and_then(|rest| rest.split('\'').next()).unwrap();
    assert_eq!(camera_lab_files::share::text_in(link), Some(Ok(lesson.as_bytes().to_vec())));
    bench.run(&["lesson", "page", "basis", "--page", "out.html", "-o", "again.html"]).done();
    let again = String::from_utf8(bench.read("again.html")).unwrap();
    assert!(again.contains("&lesson=basis") && !again.contains("#lesson=") && again.ends_with("Stand-in for the page"));
    bench.write(
        "mesh.toml",
        format!("{lesson}\n[[step.scene.objects]]\nname = \"m\"\nshape = \"mesh\"\npath = \"m.obj\"\n"),
    );
    let run = bench.run(&["lesson", "page", "mesh.toml", "--page", "page.html", "-o", "mesh.html"]);
    assert!(run.refused(2).contains("m.obj"));
}
