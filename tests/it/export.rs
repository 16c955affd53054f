//! A picture holds its figure: it opens wherever a figure file does.

use crate::common::program::Bench;

const FIGURE: &str = "# a câmera da aula\n[camera]\nposition = [3, 2, 6] # up a bit\n[image]\nwidth = 40\nheight = 30\n\
                      [scene]\npreset = \"house\"\n";

#[test]
fn a_picture_opens_as_the_figure_that_it_shows() {
    let bench = Bench::new("picture");
    bench.write("figure.toml", FIGURE);
    bench.run(&["render", "figure.toml", "-o", "picture.png"]).done();
    bench.run(&["render", "picture.png", "-o", "again.png"]).done();
    assert!(bench.read("picture.png") == bench.read("again.png"));
    let arguments = ["--point", "1,2,3", "--pixel", "4,5"];
    let of_figure = bench.run(&[&["inspect", "figure.toml"][..], &arguments].concat());
    let of_picture = bench.run(&[&["inspect", "picture.png"][..], &arguments].concat());
    assert_eq!(of_figure.done(), of_picture.done());
}

#[test]
fn the_chunk_is_the_file_itself() {
    let bench = Bench::new("chunk");
    bench.write("figure.toml", FIGURE);
    bench.run(&["render", "figure.toml", "-o", "picture.png"]).done();
    let bytes = bench.read("picture.png");
    // iTXt: keyword, 0, not compressed (0, 0), no language (0), no translated keyword (0), the text in UTF-8.
    let chunk = [b"iTXtcamera-lab-figure\0\0\0\0\0", FIGURE.as_bytes()].concat();
    assert_eq!(bytes.windows(chunk.len()).filter(|window| *window == chunk).count(), 1);
}

#[test]
fn changes_by_arguments_go_into_the_picture() {
    let bench = Bench::new("changed");
    bench.write("figure.toml", FIGURE);
    let changes = ["--op", "azimuth=30", "--op", "zoom=1.5", "--theme", "dark"];
    bench.run(&[&["render", "figure.toml", "-o", "picture.png"][..], &changes].concat()).done();
    bench.run(&["render", "picture.png", "-o", "again.png"]).done();
    assert!(bench.read("picture.png") == bench.read("again.png"));
    let text = String::from_utf8_lossy(&bench.read("picture.png")).into_owned();
    assert!(text.contains("# a câmera da aula") && text.contains("# up a bit"), "comments go along");
}

#[test]
fn another_programs_picture_is_not_a_figure() {
    let bench = Bench::new("foreign");
    let mut bytes = Vec::new();
    let writer = png::Encoder::new(&mut bytes, 1, 1).write_header();
    writer.and_then(|mut writer| writer.write_image_data(&[0])).expect("a small PNG");
    bench.write("foreign.png", &bytes);
    let run = bench.run(&["inspect", "foreign.png"]);
    assert!(run.refused(2).contains("foreign.png: this image contains no figure"), "{}", run.err);
}
