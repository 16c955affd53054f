//! `manual`: pages and completions from the arguments that the program reads.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use crate::common::program::Bench;

/// The commands that `--help` lists, `help` left out.
fn commands(bench: &Bench, of: &[&str]) -> Vec<String> {
    let run = bench.run(&[of, &["--help"]].concat());
    let help = String::from_utf8_lossy(run.done());
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let lines =
        listed.take_while(|line| !line.is_empty()).filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    lines.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help").map(str::to_owned).collect()
}

#[test]
fn every_command_has_a_page_and_is_completed() {
    let bench = Bench::new("manual");
    bench.run(&["manual", "of/the program"]).done();
    let page = |name: &str| String::from_utf8(bench.read(&format!("of/the program/man1/{name}.1"))).unwrap();
    let top = commands(&bench, &[]);
    assert!(top.len() >= 9 && top.contains(&"manual".to_owned()), "{top:?}");
    for name in &top {
        assert!(page(&format!("camera-lab-{name}")).contains(".SH SYNOPSIS"), "{name}");
    }
    for name in commands(&bench, &["exercise"]) {
        assert!(page(&format!("camera-lab-exercise-{name}")).contains(".SH SYNOPSIS"), "{name}");
    }
    assert!(page("camera-lab").contains(r"camera\-lab\-render(1)"));
    assert!(page("camera-lab-render").contains(r"\-\-transparent"));
    for file in ["bash/camera-lab", "zsh/_camera-lab", "fish/camera-lab.fish", "powershell/camera-lab.ps1"] {
        let text = String::from_utf8(bench.read(&format!("of/the program/completions/{file}"))).unwrap();
        for name in &top {
            assert!(text.contains(name.as_str()), "{file}: {name}");
        }
    }
}

#[test]
fn a_manual_that_cannot_be_written_names_the_folder() {
    let bench = Bench::new("no-manual");
    bench.write("file", "x");
    assert!(bench.run(&["manual", "file"]).refused(1).contains("file"));
    assert_eq!(bench.names(), ["file"]);
}
