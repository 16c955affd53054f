//! The files that a figure names: mesh, material, texture, photograph. Each way to write the figure elsewhere leads to
//! the same files.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;

use crate::common::named_files::{self, NAMES};
use crate::common::program::Bench;

const X: &str = "x: 100,100 200,120; 100,300 200,270";
const Z: &str = "z: 100,100 20,130; 100,300 10,260";

/// A folder `a` with the figure and its files, and an empty one.
fn bench(name: &str) -> Bench {
    let bench = Bench::new(name);
    fs::create_dir(bench.path("a")).unwrap();
    fs::create_dir(bench.path("far")).unwrap();
    named_files::write(&bench.path("a"));
    bench
}

/// The pixels of the world of a figure. Nothing is missing in it.
fn pixels(bench: &Bench, figure: &str) -> Vec<u8> {
    bench.run(&["render", figure, "--view", "world", "--size", "200x150", "-o", "pixels.webp"]).done();
    bench.run(&["render", figure, "--size", "64x48", "-o", "image.webp"]).done();
    [bench.read("pixels.webp"), bench.read("image.webp")].concat()
}

/// Writes a figure file in the bench in each way that a command has.
fn written(bench: &Bench) -> Vec<&'static str> {
    // It has nothing to repair, and says so.
    assert_eq!(bench.run(&["diagnose", "a/figure.toml", "--repair", "-o", "far/repaired.toml"]).status, Some(0));
    let photograph = bench.run(&["photograph", "a/figure.toml", "--lines", X, "--lines", Z]);
    bench.write("photograph.toml", photograph.done());
    let numbers = "1 0 0 0  0 1 0 0  0 0 1 -5  0 0 0 1";
    let matrix = bench.run(&["matrix", "a/figure.toml", "--as", "view", "--numbers", numbers]);
    bench.write("matrix.toml", matrix.done());
    vec!["far/repaired.toml", "photograph.toml", "matrix.toml"]
}

#[test]
fn each_command_that_writes_a_figure_elsewhere_names_the_same_files() {
    let bench = bench("elsewhere");
    for figure in written(&bench) {
        let whole = pixels(&bench, figure);
        for name in NAMES {
            let (there, away) = (bench.path("a").join(name), bench.path("away"));
            fs::rename(&there, &away).unwrap();
            let without = bench.run(&["render", figure, "--size", "64x48", "-o", "without.png"]);
            assert!(without.err.contains(name), "{figure} doesn't use {name}: {}", without.err);
            fs::rename(&away, &there).unwrap();
        }
        assert_eq!(pixels(&bench, figure), whole, "{figure}");
    }
    // A copy of the text alone leads nowhere.
    fs::copy(bench.path("a/figure.toml"), bench.path("far/copy.toml")).unwrap();
    bench.run(&["render", "far/copy.toml", "-o", "copy.png"]).refused(2);
}

#[test]
fn an_image_carries_its_files_wherever_it_goes() {
    let bench = bench("carried");
    let own = pixels(&bench, "a/figure.toml");
    for ending in ["png", "svg", "pdf"] {
        let image = format!("far/p.{ending}");
        bench.run(&["render", "a/figure.toml", "--view", "world", "-o", &image]).done();
        fs::rename(bench.path("a"), bench.path("gone")).unwrap();
        assert_eq!(pixels(&bench, &image), own, "{ending}");
        // From one image to the next, and into a figure file with its files.
        bench.run(&["render", &image, "-o", "far/again.png"]).done();
        assert_eq!(pixels(&bench, "far/again.png"), own, "{ending}");
        let repaired = bench.run(&["diagnose", &image, "--repair", "-o", &format!("far/{ending}.toml")]);
        assert_eq!(repaired.status, Some(0), "{}", repaired.err);
        fs::remove_file(bench.path(&image)).unwrap();
        pixels(&bench, &format!("far/{ending}.toml"));
        // The files it carries come before files of the same name.
        fs::write(bench.path("far/m.obj"), "v 0 0 0\n").unwrap();
        assert_eq!(pixels(&bench, "far/again.png"), own, "{ending}");
        fs::remove_file(bench.path("far/m.obj")).unwrap();
        fs::rename(bench.path("gone"), bench.path("a")).unwrap();
    }
    // The names stay.
    let text = String::from_utf8_lossy(&bench.read("far/again.png")).into_owned();
    assert!(text.contains("path = \"m.obj\"") && text.contains("photograph = \"ph.png\""));
}

#[test]
fn steps_of_lessons_and_families_carry_their_files_too() {
    let bench = bench("carried-steps");
    let figure = fs::read_to_string(bench.path("a/figure.toml")).unwrap();
    let step = figure.replace("[image]", "[step.image]").replace("[scene]", "[step.scene]");
    let step = step.replace("[[scene.objects]]", "[[step.scene.objects]]");
    bench.write(
        "a/lesson.toml",
        format!("id = \"one\"\ntitle = \"One\"\n[[step]]\ntitle = \"A\"\ntext = \"A\"\n{step}"),
    );
    bench.run(&["lesson", "render", "a/lesson.toml", "-o", "far/steps"]).done();
    bench.run(&["sheet", "a/figure.toml", "--vary", "azimuth=0,30", "-o", "far/family.png"]).done();
    bench.run(&["animate", "a/figure.toml", "-o", "far/strip.png"]).done();
    fs::rename(bench.path("a"), bench.path("gone")).unwrap();
    for image in ["far/steps/01-one.png", "far/family.png", "far/strip.png"] {
        pixels(&bench, image);
    }
}
