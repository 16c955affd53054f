//! Lessons of strangers, and handouts of long texts: nothing outside the folder is read, and nothing is dropped.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::process::Command;

use camera_lab_files::share;

use crate::common::program::Bench;

fn lesson(steps: &str) -> String {
    format!("id = \"mine\"\ntitle = \"T\"\n{steps}")
}

fn step_with(object: &str) -> String {
    lesson(&format!("[[step]]\ntitle = \"s\"\ntext = \"t\"\n[[step.scene.objects]]\nname = \"k\"\n{object}\n"))
}

const TRIANGLE: &str = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";

/// A lesson with all that `lesson check` asks for.
fn whole(lesson: &str) -> String {
    format!("aims = [\"a\"]\nplan = \"p\"\nsentence = \"s\"\n{lesson}")
}

#[test]
fn a_lesson_reads_files_of_its_folder_only_and_one_in_a_link_none() {
    let bench = Bench::new("lesson-files");
    std::fs::create_dir_all(bench.path("course/meshes")).unwrap();
    bench.write("outside.obj", TRIANGLE);
    bench.write("course/meshes/inside.obj", TRIANGLE);
    let outside = bench.path("outside.obj");
    let absolute = outside.to_str().unwrap().replace('\\', "/");
    for path in ["../outside.obj", absolute.as_str(), "meshes/../../outside.obj", "../nothing.obj"] {
        let text = step_with(&format!("shape = \"mesh\"\npath = \"{path}\""));
        bench.write("course/l.toml", &text);
        for command in [vec!["check", "course/l.toml"], vec!["render", "course/l.toml", "-o", "out"]] {
            let refused = bench.run(&[&["lesson"], command.as_slice()].concat());
            assert!(refused.status == Some(2) && refused.err.contains("--allow-files"), "{path}: {}", refused.err);
        }
        assert!(!bench.path("out").exists());
    }
    bench.write("course/l.toml", whole(&step_with("shape = \"mesh\"\npath = \"../outside.obj\"")));
    bench.run(&["lesson", "check", "course/l.toml", "--allow-files"]).done();
    let inside = whole(&step_with("shape = \"mesh\"\npath = \"meshes/inside.obj\""));
    bench.write("course/l.toml", &inside);
    bench.run(&["lesson", "check", "course/l.toml"]).done();
    // The link has no folder, even if the program runs beside the mesh.
    let link = share::link("", share::Held::Lesson, &inside.replace("meshes/", "course/meshes/")).unwrap();
    let refused = bench.run(&["lesson", "check", &link]);
    assert!(refused.status == Some(2) && refused.err.contains("the lesson in the link"), "{}", refused.err);
    assert!(!refused.err.contains("#lesson"), "{}", refused.err);
}

#[test]
fn a_missing_texture_is_a_fault_of_the_lesson() {
    let bench = Bench::new("lesson-texture");
    bench.write("l.toml", step_with("shape = \"box\"\ntexture = \"missing.png\""));
    let refused = bench.run(&["lesson", "check", "l.toml"]);
    assert!(refused.status == Some(2) && refused.err.contains("missing.png"), "{}", refused.err);
    assert!(refused.err.contains("l.toml") && refused.err.contains("line 3"), "{}", refused.err);
    let drawn = bench.run(&["lesson", "render", "l.toml", "-o", "l.pdf"]);
    assert!(drawn.status == Some(0) && drawn.err.contains("missing.png"), "{}", drawn.err);
}

#[test]
fn unreachable_goals_and_too_many_conditions_are_refused() {
    let bench = Bench::new("lesson-goals");
    let goal = |until: &str| {
        lesson(&format!(
            "[[step]]\ntitle = \"s\"\ntext = \"t\"\n[[step.scene.objects]]\nname = \"k\"\nshape = \"box\"\n[step.try]\ntext = \"x\"\nuntil = [{until}]\n"
        ))
    };
    for (until, key, allowed) in [
        ("{ quantity = \"distance\", least = 9, most = 8 }", "least", "most"),
        ("{ seen = \"k\" }, { hidden = \"k\" }", "until", "together"),
        ("{ quantity = \"distance\", least = 9 }, { quantity = \"distance\", most = 8 }", "until", "together"),
        (&"{ hidden = \"k\" }, ".repeat(65), "until", "64"),
        (&"{ hidden = \"k\" }, ".repeat(20_000), "until", "64"),
    ] {
        bench.write("l.toml", goal(until));
        let refused = bench.run(&["lesson", "check", "l.toml"]);
        assert_eq!(refused.status, Some(2), "{}", refused.err);
        assert!(refused.err.contains(key) && refused.err.contains(allowed), "{}", refused.err);
    }
    bench.write("l.toml", whole(&goal("{ quantity = \"distance\", least = 8, most = 9 }, { hidden = \"k\" }")));
    bench.run(&["lesson", "check", "l.toml"]).done();
}

/// The words of a PDF, in their order.
fn words(bench: &Bench, pdf: &str) -> Option<String> {
    let output = Command::new("pdftotext").arg(bench.path(pdf)).arg("-").output().ok()?;
    output
        .status
        .success()
        .then(|| String::from_utf8_lossy(&output.stdout).split_whitespace().collect::<Vec<_>>().join(" "))
}

#[test]
fn a_handout_has_all_of_a_long_text_and_its_question() {
    let bench = Bench::new("lesson-long");
    let long: Vec<String> = (0..1500).map(|k| format!("word{k}")).collect();
    let unbroken = "q".repeat(400);
    bench.write(
        "l.toml",
        lesson(&format!(
            "[[step]]\ntitle = \"The title\"\ntext = \"{} {unbroken} END.\"\n[step.ask]\ntext = \"How many words are there?\"\nanswer = \"600\"\n[[step]]\ntitle = \"After\"\ntext = \"Last.\"\n",
            long.join(" ")
        )),
    );
    for per_page in ["2", "4"] {
        bench.run(&["lesson", "render", "l.toml", "--per-page", per_page, "-o", "l.pdf"]).done();
        let Some(text) = words(&bench, "l.pdf") else { return };
        for word in ["word0", "word777", "word1499", "END.", "How many words are there?", "Last."] {
            assert!(text.contains(word), "{per_page}: {word} is missing");
        }
        assert_eq!(text.matches("The title").count(), 1, "a heading is one text");
        assert_eq!(text.matches('q').count(), 400, "a long word is broken, and whole");
    }
}

#[test]
fn fonts_of_a_handout_are_in_it_once() {
    let bench = Bench::new("lesson-fonts");
    let step = "[[step]]\ntitle = \"s\"\ntext = \"word\"\n[step.image]\nwidth = 40\nheight = 30\n[step.scene]\npreset = \"empty\"\n";
    bench.write("l.toml", lesson(&step.repeat(6)));
    bench.run(&["lesson", "render", "l.toml", "-o", "l.pdf"]).done();
    let bytes = bench.read("l.pdf");
    let fonts = bytes.windows(10).filter(|window| window == b"/FontFile2").count();
    assert!((1..=4).contains(&fonts), "{fonts} font files");
}

#[test]
fn options_that_say_nothing_are_refused_and_nothing_is_written_for_a_faulty_step() {
    let bench = Bench::new("lesson-options");
    bench.write("l.toml", lesson("[[step]]\ntitle = \"s\"\ntext = \"t\"\n"));
    for (options, output) in [
        (["--size", "300x200"], "l.pdf"),
        (["--view", "image"], "l.pdf"),
        (["--format", "svg"], "l.pdf"),
        (["--per-page", "4"], "folder"),
    ] {
        let refused = bench.run(&["lesson", "render", "l.toml", options[0], options[1], "-o", output]);
        assert!(refused.status == Some(2) && refused.err.contains(options[0]), "{}", refused.err);
        assert!(!bench.path(output).exists());
    }
    bench.run(&["lesson", "render", "l.toml", "--answers", "-o", "folder"]).refused(2);
    let two = "[[step]]\ntitle = \"s\"\ntext = \"t\"\n[[step]]\ntitle = \"u\"\ntext = \"t\"\n[[step.scene.objects]]\nname = \"k\"\nshape = \"mesh\"\npath = \"none.obj\"\n";
    bench.write("two.toml", lesson(two));
    let refused = bench.run(&["lesson", "render", "two.toml", "-o", "folder"]);
    assert!(refused.status == Some(2) && refused.err.contains("two.toml") && refused.err.contains("step 2"));
    assert!(!bench.path("folder").exists(), "nothing is written");
}

#[test]
fn lessons_in_links_are_shown_and_marks_that_turn_texts_round_are_escaped() {
    let bench = Bench::new("lesson-links");
    let text = lesson("[[step]]\ntitle = \"s\"\ntext = \"\\u202egnirts\"\n");
    let link = share::link("", share::Held::Lesson, &text).unwrap();
    for which in [link.as_str(), "?lesson=basis", "https://example.org/?lesson=basis&step=2"] {
        bench.run(&["lesson", "show", which]).done();
    }
    let shown = String::from_utf8(bench.run(&["lesson", "show", &link]).done().to_vec()).unwrap();
    assert!(!shown.contains('\u{202e}') && shown.contains("gnirts"), "{shown:?}");
    assert!(shown.lines().count() > 3, "lines stay lines: {shown:?}");
}
