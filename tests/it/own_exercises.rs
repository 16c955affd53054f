//! A lecturer's own exercises: the contents of their files, the errors of faulty ones, and the command line over them.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::path::Path;

use camera_lab::exercises::{Free, check, own};
use camera_lab::limits::MAX_OWN_EXERCISES;
use camera_lab_files::{FileError, read_exercises};
use camera_lab_words::learn::exercises as texts;
use camera_lab_words::{Lang, messages};

use crate::common::program::Bench;

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/exercises");

/// An exercise about a camera at (0, 0, 5) that looks at the origin.
const PLAIN: &str = "id = \"mine\"\ntitle = \"Mine\"\nstatement = \"Say it.\"\n[figure.camera]\nposition = [0, 0, 5]\n";

fn fault(text: &str) -> [String; 2] {
    let error = own::parse(text).err().unwrap_or_else(|| panic!("read: {text}"));
    [Lang::En, Lang::PtBr].map(|lang| messages::figure(lang, &error))
}

/// By hand: C = (3, 4, 12), so D = 13 and **n** = (3, 4, 12)/13. Then (0, 1, 0) × **n** = (12, 0, −3)/13, so **u** =
/// (4, 0, −1)/√17. A quarter turn about **v** takes **n** to **u**.
#[test]
fn the_examples_are_read_and_judged() {
    let found = read_exercises(Path::new(EXAMPLES)).unwrap();
    assert!(found.faults.is_empty(), "{:?}", found.faults);
    let ids: Vec<&str> = found.entries.iter().map(|entry| &*entry.id).collect();
    assert_eq!(ids, ["field-of-view", "house-view"]);
    let judged = |entry: usize, name: &str, answer: &str| {
        let entry = &found.entries[entry];
        let exercise = entry.exercise(0, &Free::new());
        let ask = exercise.asks.iter().find(|ask| ask.name == name).unwrap();
        let judged = check(entry, &exercise, ask, answer).unwrap();
        let said = texts::diagnosis(Lang::PtBr, ask, &judged).unwrap_or_default();
        (judged.right, said)
    };
    assert_eq!(judged(1, "n", "[4/sqrt(17), 0, -1/sqrt(17)]"), (true, String::new()));
    assert_eq!(judged(1, "n", "[3/13, 4/13, 12/13]").1, "Este é o **n** de antes do azimute.");
    // The known mistakes come by themselves: this is a quarter turn the other way, or **n** reversed.
    let (_, said) = judged(1, "n", "[-4/sqrt(17), 0, 1/sqrt(17)]");
    assert!(said.contains("Pode ser este: Você girou para o outro lado. Ou este: **n** aponta de C para PF"), "{said}");
    assert_eq!(judged(0, "theta", "90°"), (true, String::new()));
    assert_eq!(judged(0, "theta", "45").1, "Esta é a metade do ângulo: do eixo à borda.");
    assert_eq!(judged(0, "changes", "dolly").1, "Um dolly move a câmera, seu ângulo fica.");
    assert!(judged(0, "changes", "zoom").0);
    let (_, said) = judged(0, "axes", "[[1, 0, 0], [0, 1, 0], [0, 0, -1]]");
    assert!(said.contains("sinal"), "{said}");
    for (lang, title) in [(Lang::En, "Half the picture"), (Lang::PtBr, "Metade da imagem")] {
        assert_eq!(texts::title(lang, &found.entries[0]), title);
    }
}

#[test]
fn a_faulty_file_is_refused_with_line_key_and_allowed_values() {
    let whole = |text: String| format!("{text}[[ask]]\nname = \"a\"\ntext = \"What?\"\nanswer = 1\n");
    let ask = |rest: &str| format!("{PLAIN}[[ask]]\nname = \"a\"\ntext = \"What?\"\n{rest}\n");
    for (text, parts) in [
        (whole(PLAIN.replace("id = \"mine\"\n", "")), &["id ", "64"][..]),
        (whole(PLAIN.replace("mine", "my own")), &["1", "id", "\"my own\""]),
        (whole(PLAIN.replace("\"Mine\"", "{ en = \"Mine\", pt = \"Meu\" }")), &["2", "title", "pt-BR"]),
        (PLAIN.to_owned(), &["ask"]),
        (whole(PLAIN.replace("position", "positoin")), &["5", "[figure.camera] positoin", "position"]),
        (whole(format!("ops = [\"azimut=30\"]\n{PLAIN}")), &["1", "ops", "azimuth=30"]),
        (whole(format!("ops = [\"dolly=1e308\", \"dolly=1e308\"]\n{PLAIN}")), &["1", "ops"]),
        (whole(format!("pixels = [[1.5, 2]]\n{PLAIN}")), &["1", "pixels", "[[i, j], …]"]),
        (ask("quantity = \"basis.w\""), &["9", "[[ask]] quantity", "\"basis.w\"", "points.0.ndc"]),
        (ask("quantity = \"points.0.ndc\""), &["9", "[[ask]] quantity"]),
        (ask("quantity = \"basis.n\"\nanswer = 3"), &["10", "[[ask]] answer", "quantity"]),
        (ask(""), &["[[ask]] answer", "quantity"]),
        (ask("answer = \"1/\""), &["9", "[[ask]] answer", "1/"]),
        (ask("answer = [[1, 2], [3]]"), &["9", "[[ask]] answer", "[[…], […], …]"]),
        (ask("answer = 3\nunit = \"pixel\""), &["10", "[[ask]] unit", "\"pixels\""]),
        (ask("answer = 3\ntolerance = 0"), &["10", "[[ask]] tolerance", "0"]),
        (
            ask("choices = [\"up\", \"down\"]\nanswer = \"left\""),
            &["10", "[[ask]] answer", "\"left\"", "\"up\", \"down\""],
        ),
        (ask("answer = 3\n[[ask]]\nname = \"a\"\ntext = \"?\"\nanswer = 4"), &["11", "[[ask]] name"]),
        (
            ask("answer = 3\n[[ask.mistake]]\nanswer = 3.0001\nmessage = \"no\""),
            &["11", "[[ask.mistake]] answer", "3.0001"],
        ),
        (ask("answer = 3\n[[ask.mistake]]\nanswer = 4"), &["[[ask.mistake]] message"]),
        (
            ask("answer = 3\n[[ask.mistake]]\nanswer = 4\nmessage = \"no\"\ncode = \"signs\""),
            &["13", "code", "\"sign\""],
        ),
        (ask("answer = 3\nhint = \"x\""), &["10", "[[ask]] hint"]),
    ] {
        let [en, pt] = fault(&text);
        for part in parts {
            assert!(en.contains(part) && pt.contains(part), "{part}: {en} / {pt}");
        }
        assert_ne!(en, pt);
    }
}

#[test]
fn a_folder_is_read_file_by_file_and_within_its_budget() {
    let bench = Bench::new("own-folder");
    let named = |id: &str| format!("{}[[ask]]\nname = \"a\"\ntext = \"?\"\nanswer = 1\n", PLAIN.replace("mine", id));
    bench.write("10.toml", named("ten"));
    bench.write("9.toml", named("nine"));
    bench.write("notes.md", "not an exercise");
    bench.write("taken.toml", format!("# mine\n{}", named("basis")));
    bench.write("twice.toml", named("ten"));
    bench.write("wrong.toml", "id = 3\n");
    bench.write("long.toml", "#".repeat((1 << 20) + 1));
    let found = read_exercises(&bench.path("")).unwrap();
    assert_eq!(found.entries.iter().map(|entry| &*entry.id).collect::<Vec<_>>(), ["nine", "ten"]);
    let said: Vec<String> = found.faults.iter().map(|bad| messages::file(Lang::En, "x", &bad.error)).collect();
    assert_eq!(said.len(), 4, "{said:?}");
    for (said, part) in
        said.iter().zip(["1048576 bytes", "line 2: id is \"basis\"", "line 1: id is \"ten\"", "line 1: id"])
    {
        assert!(said.contains(part), "{said}");
    }
    for k in 0..MAX_OWN_EXERCISES {
        bench.write(&format!("more-{k}.toml"), "");
    }
    assert!(matches!(read_exercises(&bench.path("")), Err(FileError::TooManyExercises)));
    assert!(matches!(read_exercises(&bench.path("none")), Err(FileError::Read(_))));
    assert!(matches!(read_exercises(Path::new("//host/share")), Err(FileError::Network)));
}

#[test]
fn the_command_line_takes_a_folder() {
    let bench = Bench::new("own-command");
    let list = bench.run(&["exercise", "list", "--folder", EXAMPLES, "--format", "json"]).json();
    let ids: Vec<&str> = list.as_array().unwrap().iter().map(|line| line["id"].as_str().unwrap()).collect();
    assert_eq!((ids[0], &ids[ids.len() - 2..]), ("0-5.1", &["field-of-view", "house-view"][..]));
    let shown =
        bench.run(&["exercise", "show", "house-view", "--folder", EXAMPLES, "--format", "json", "--solution"]).json();
    assert_eq!(shown["ops"][0], "azimuth=90");
    assert_eq!(shown["asks"][0]["quantity"], "basis.n");
    assert!((shown["answers"]["n"][0].as_f64().unwrap() - 4.0 / 17.0_f64.sqrt()).abs() < 1e-12);
    assert!(shown["steps"].as_array().unwrap().len() > 3);
    let answers = [
        "exercise",
        "check",
        "field-of-view",
        "--folder",
        EXAMPLES,
        "--format",
        "json",
        "--answer",
        "theta=45",
        "--answer",
        "changes=dolly",
    ];
    let run = bench.run(&answers);
    assert_eq!(run.status, Some(1), "{}", run.err);
    let judged: serde_json::Value = serde_json::from_slice(&run.out).unwrap();
    assert_eq!(judged["answers"][0]["diagnosis"]["code"], "whole-angle");
    assert_eq!(judged["answers"][0]["diagnosis"]["hints"][1], "$\\tan(\\theta/2) = 2/2$");
    assert_eq!(judged["answers"][1]["diagnosis"]["code"], "own");
    for name in ["sheet.md", "sheet.tex"] {
        bench
            .run(&[
                "exercise",
                "sheet",
                "--ids",
                "house-view,basis,field-of-view",
                "--folder",
                EXAMPLES,
                "--answers",
                "-o",
                name,
            ])
            .done();
        let text = String::from_utf8(bench.read(name)).unwrap();
        assert!(text.contains("The house from the corner") && text.contains("$\\theta = 60^{\\circ}$"), "{text}");
    }
    bench.run(&["exercise", "show", "house-view"]).refused(2);
}

/// Figures and their exercises lie in one folder, naturally.
#[test]
fn a_foreign_file_leaves_the_exercises_beside_it_usable_and_is_named() {
    let bench = Bench::new("own-foreign");
    let good = format!("{PLAIN}[[ask]]\nname = \"a\"\ntext = \"?\"\nanswer = 1\n");
    bench.write("good.toml", &good);
    bench.write("figure.toml", "[camera]\nnear = 0.5\n");
    bench.write("broken.toml", "# mine\nid = \"broken\"\ntitle = \"T\"\nstatement = \"$\\\\input{x}$\"\n[[ask]]\nname = \"a\"\ntext = \"?\"\nanswer = 1\n");
    bench.write("no-toml.toml", "id = 'no-toml'\nthis is not TOML\n");
    bench.write("large.toml", "#".repeat((1 << 20) + 1));
    bench.write("no-text.toml", [0xff, 0xfe]);
    std::fs::create_dir(bench.path("d.toml")).unwrap();
    let mut bad = vec![
        ("figure.toml", "line 1"),
        ("broken.toml", "line 4"),
        ("no-toml.toml", "line 2"),
        ("large.toml", "1048576"),
        ("no-text.toml", "UTF-8"),
        ("d.toml", "directory"),
    ];
    #[cfg(unix)]
    {
        use std::os::unix::fs::symlink;
        symlink("nowhere", bench.path("dangling.toml")).unwrap();
        symlink("loop.toml", bench.path("loop.toml")).unwrap();
        assert!(std::process::Command::new("mkfifo").arg(bench.path("pipe.toml")).status().unwrap().success());
        bad.extend([("dangling.toml", "no such file"), ("loop.toml", "cycle"), ("pipe.toml", "pipe")]);
    }
    let folder = bench.path("");
    let exercise =
        |arguments: &[&str]| bench.run(&[&["exercise"], arguments, &["--folder", folder.to_str().unwrap()]].concat());
    for arguments in [
        &["list"][..],
        &["show", "mine"],
        &["check", "mine", "--answer", "a=1"],
        &["sheet", "--ids", "mine,basis", "-o", "o.md"],
    ] {
        let run = exercise(arguments);
        assert_eq!(run.status, Some(0), "{}", run.err);
        assert_eq!(run.err.lines().count(), bad.len(), "{}", run.err);
        for (name, why) in &bad {
            let line =
                run.err.lines().find(|line| line.contains(name)).unwrap_or_else(|| panic!("{name}: {}", run.err));
            assert!(line.contains(why), "{line}");
        }
    }
    assert!(String::from_utf8_lossy(&exercise(&["list"]).out).contains("mine"));
    // A request for the broken one gives the reason, and nothing of the others.
    for (id, line) in [("broken", "broken.toml, line 4"), ("no-toml", "no-toml.toml, line 2")] {
        let run = exercise(&["show", id]);
        assert!(run.refused(2).contains(line) && !run.err.contains("figure.toml"), "{}", run.err);
    }
    let run = exercise(&["show", "nothing-of-this-name"]);
    assert!(run.refused(2).contains("nothing-of-this-name") && run.err.contains("figure.toml"), "{}", run.err);
    let run = exercise(&["list", "--lang", "pt-BR"]);
    assert!(run.err.contains("ignorado: ") && run.err.contains("linha 4"), "{}", run.err);
    // A folder that is none is refused as before.
    assert!(bench.run(&["exercise", "list", "--folder", "none"]).refused(2).contains("none"));
}

/// The picture that is to be matched goes beside a sheet. A figure in it would give the camera away.
#[test]
fn a_picture_to_be_matched_goes_beside_its_sheet_and_keeps_its_camera_to_itself() {
    let bench = Bench::new("exercise-pictures");
    let exercise = |arguments: &[&str]| bench.run(&[&["exercise"], arguments].concat());
    for (name, says) in [("a sheet.md", "(a-sheet-2.png)"), ("b.tex", "{b-2.png}")] {
        exercise(&["sheet", "--ids", "basis,match-picture", "--seed", "3", "-o", name]).done();
        let text = String::from_utf8(bench.read(name)).unwrap();
        assert_eq!(text.matches(says).count(), 1, "{text}");
    }
    let picture = bench.read("a-sheet-2.png");
    assert_eq!(picture, bench.read("b-2.png"));
    let shown =
        exercise(&["show", "match-picture", "--seed", "3", "--picture", "shown.png", "--format", "json"]).json();
    assert_eq!(shown["picture"], "camera-lab exercise show match-picture --seed 3 --picture OUT.png");
    assert_eq!(bench.read("shown.png"), picture);
    exercise(&["show", "match-picture", "--seed", "4", "--picture", "other.png"]).done();
    assert_ne!(bench.read("other.png"), picture);
    bench.run(&["inspect", "shown.png"]).refused(2);
    exercise(&["show", "basis", "--picture", "none.png"]).refused(2);
    assert!(exercise(&["show", "basis", "--format", "json"]).json()["picture"].is_null());
}

#[test]
fn a_range_of_seeds_makes_versions_with_their_solutions_in_a_file_of_their_own() {
    let bench = Bench::new("exercise-versions");
    let sheet =
        |arguments: &[&str]| bench.run(&[&["exercise", "sheet", "--ids", "basis,match-picture"], arguments].concat());
    sheet(&["--seed", "4-6", "--solutions", "answers.md", "-o", "sheet.md"]).done();
    sheet(&["--seed", "4-6", "--solutions", "answers.tex", "-o", "sheet.tex", "--lang", "pt-BR"]).done();
    let read = |name: &str| String::from_utf8(bench.read(name)).unwrap();
    for number in 4..=6 {
        for name in ["sheet.md", "answers.md"] {
            assert_eq!(read(name).matches(&format!("Version {number}")).count(), 1, "{name}");
        }
        assert!(read("sheet.md").contains(&format!("basis, seed {number}")));
        assert!(read("sheet.tex").contains(&format!("{{\\hfil Versão {number} ")), "{number}");
        // The picture to match of each version.
        assert!(read("sheet.md").contains(&format!("(sheet-{number}-2.png)")));
        assert_ne!(bench.read(&format!("sheet-{number}-2.png")), bench.read("sheet-4-2.png").split_off(1));
        // A version is what its seed alone gives.
        sheet(&["--seed", &number.to_string(), "-o", "one.md"]).done();
        let one = read("one.md");
        let statement = one.lines().find(|line| line.starts_with("A camera")).expect("a statement");
        assert!(read("sheet.md").contains(statement), "{statement}");
        assert!(!one.contains("Version"), "{one}");
    }
    let answers = read("answers.md");
    assert!(!answers.contains("Name:") && answers.contains("**a)**"), "{answers}");
    for seeds in ["6-4", "1-", "a-b", "0-100000", "-1"] {
        let run = sheet(&["--seed", seeds, "-o", "no.md"]);
        assert!(run.refused(2).contains("1-30"), "{seeds}");
    }
}
