//! How large pictures, letters and lines may be: an answer or a message, never a panic.

use proptest::prelude::*;

use crate::common::program::{Bench, Run};

const FIGURE: &str = "[image]\nwidth = 48\nheight = 36\n[scene]\npreset = \"cube\"\n[style]\nantialias = 1\n";

fn bench(name: &str) -> Bench {
    let bench = Bench::new(name);
    bench.write("figure.toml", FIGURE);
    bench
}

fn render(bench: &Bench, more: &[&str]) -> Run {
    let size = if more.iter().any(|option| option.contains("-cm")) { &[][..] } else { &["--size", "80x60"] };
    bench.run(&[&["render", "figure.toml", "--view", "world", "-o", "o.png"], size, more].concat())
}

#[test]
fn impossible_paper_options_are_refused_by_name_and_range() {
    let bench = bench("paper-limits");
    for (options, name, range) in [
        (&["--letters", "1e9"][..], "--letters", ["0.5", "1000"]),
        (&["--letters", "1e-9"], "--letters", ["0.5", "1000"]),
        (&["--lines", "1e300"], "--lines", ["0.01", "100"]),
        (&["--lines", "NaN"], "--lines", ["0.01", "100"]),
        (&["--width-cm", "1e-9"], "--width-cm", ["0.1", "1000"]),
        (&["--width-cm", "1e9"], "--width-cm", ["0.1", "1000"]),
        (&["--width-cm", "8", "--height-cm", "inf"], "--height-cm", ["0.1", "1000"]),
        (&["--width-cm", "8", "--dpi", "1e-9"], "--dpi", ["1", "10000"]),
        (&["--dpi", "1e9"], "--dpi", ["1", "10000"]),
        (&["--scale", "1e9"], "--scale", ["0.1", "16"]),
        (&["--width-cm", "0.1", "--dpi", "1"], "--width-cm", ["--dpi", "pixel"]),
        (&["--width-cm", "8", "--height-cm", "0.1", "--dpi", "1"], "--height-cm", ["--dpi", "pixel"]),
    ] {
        for (lang, allowed) in [("en", "allowed: "), ("pt-BR", "permitido: ")] {
            let run = render(&bench, &[options, &["--lang", lang]].concat());
            let said = run.refused(2);
            let (before, after) = said.split_once(allowed).unwrap_or_else(|| panic!("{said}"));
            assert!(before.contains(name), "{said}");
            assert!(range.iter().all(|end| after.contains(end) || before.contains(end)), "{said}");
        }
    }
    assert_eq!(bench.names(), ["figure.toml"]);
    for seconds in ["1e9", "0", "nan"] {
        let run = bench.run(&["animate", "figure.toml", "--seconds", seconds, "-o", "o.gif"]);
        assert!(run.refused(2).contains("allowed: a number from 0.1 to 60"), "{}", run.err);
    }
}

#[test]
fn three_pictures_without_room_ask_for_smaller_letters() {
    let bench = bench("paper-room");
    let all = |more: &[&str]| bench.run(&[&["render", "figure.toml", "--view", "all", "-o", "o.png"], more].concat());
    let run = all(&["--size", "80x60", "--letters", "100"]);
    let said = run.refused(2);
    assert!(said.contains("80 × 60") && said.contains("letters") && !said.contains("16384"), "{said}");
    assert!(all(&["--size", "9x60"]).refused(2).contains("9 × 60"));
    all(&["--size", "11x60"]).done();
}

#[test]
fn letters_larger_than_the_picture_are_drawn() {
    let bench = bench("paper-letters");
    for options in [
        &["--letters", "1000", "--dpi", "10000"][..],
        &["--letters", "1000", "--dpi", "10000", "--lines", "100", "--view", "canonical"],
        &["--letters", "0.5", "--dpi", "1", "--lines", "0.01"],
        &["--letters", "0.5", "--dpi", "1", "--lines", "100", "--view", "image"],
    ] {
        let mut command = bench.command(&["render", "figure.toml", "--size", "80x60", "-o", "o.png"]);
        let view = if options.contains(&"--view") { &[][..] } else { &["--view", "world"] };
        let run = Run::of(command.args([options, view].concat()));
        assert_eq!(run.status, Some(0), "{options:?}");
        let is_small = options.contains(&"0.5");
        assert_eq!(run.err.contains("its letters are 0.5 pt high on paper"), is_small, "{options:?}: {}", run.err);
        assert!(is_small || run.err.is_empty(), "{options:?}: {}", run.err);
    }
}

/// Numbers that people and programs type, from nothing to nonsense.
fn wild() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => (-12.0..12.0_f64).prop_map(|e| format!("{:e}", 10f64.powf(e))),
        2 => (0.01..60.0_f64).prop_map(|v| v.to_string()),
        1 => any::<f64>().prop_map(|v| v.to_string()),
        1 => prop::sample::select(vec!["", "0", "-0", "1e999", "-inf", "nan", "9 ", "1,5", "9pt", "0x9", "٣", "1_0"])
            .prop_map(str::to_owned),
    ]
}

/// Sizes that do not take long, and some that are none.
fn size() -> impl Strategy<Value = String> {
    let side = prop_oneof![4 => 1..200_u32, 1 => prop::sample::select(vec![0, 16_385, u32::MAX])];
    (side.clone(), side).prop_map(|(width, height)| format!("{width}x{height}"))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    #[test]
    fn any_paper_gives_an_answer_or_a_message(
        options in prop::collection::vec((0..6_usize, wild()), 1..4),
        size in prop::option::of(size()),
        view in prop::sample::select(vec!["world", "canonical", "image", "all"]),
        theme in prop::sample::select(vec!["light", "dark", "print"]),
    ) {
        const NAMES: [&str; 6] = ["--letters", "--lines", "--width-cm", "--height-cm", "--dpi", "--scale"];
        let bench = bench("paper-wild");
        let mut arguments = ["render", "figure.toml", "-o", "o.png", "--view", view, "--theme", theme].map(str::to_owned).to_vec();
        arguments.extend(size.map(|size| format!("--size={size}")));
        // On paper as wide as the widest, a picture would take seconds. This test only looks for a refusal or a small
        // one.
        let small = |name: &str, text: &str| {
            let large = if name == "--dpi" { 80.0 } else { 12.0 };
            !(name.ends_with("-cm") || name == "--dpi") || text.parse::<f64>().is_ok_and(|v| v <= large || v > 10_000.0)
        };
        let given = options.iter().map(|(k, text)| (NAMES[*k], text)).filter(|(name, text)| small(name, text));
        arguments.extend(given.map(|(name, text)| format!("{name}={text}")));
        let run = bench.run(&arguments);
        prop_assert!(!run.err.contains("panicked"), "{arguments:?} {}", run.err);
        prop_assert!(matches!(run.status, Some(0 | 2)), "{:?} {arguments:?} {}", run.status, run.err);
        prop_assert!(run.status == Some(0) || !run.err.is_empty());
    }
}
