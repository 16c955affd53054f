//! The figure files of the documentation and of the assets: each can be read, drawn, and edited.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use camera_lab::camera::Parameters;
use camera_lab::exercises::own;
use camera_lab::figure::update;
use camera_lab::figure::write::to_toml;
use camera_lab::figure::{Figure, read};
use camera_lab::scene::Preset;

use crate::common::program::Bench;

const DOCUMENTED: &str = include_str!("../figures/documented.toml");

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files with this ending in a folder, sorted. None if there is no folder.
fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(root().join(folder)) else { return Vec::new() };
    let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    files.retain(|path| path.extension().is_some_and(|found| found == ending));
    files.sort();
    files
}

#[test]
fn the_documented_keys_are_the_keys() {
    let figure = read::parse(DOCUMENTED).unwrap();
    assert_eq!(figure.camera, Parameters::default());
    assert_eq!(figure.viewport.unwrap().width, 1024);
    assert_eq!(figure.scene.objects.len(), 3);
    assert_eq!(figure.style, Figure::default().style);
    // Whatever is written has been documented, and the other way round.
    let keys = |text: &str| {
        let mut keys: Vec<String> =
            text.lines().filter_map(|line| Some(line.split_once('=')?.0.trim().to_owned())).collect();
        keys.retain(|key| !key.starts_with('#'));
        keys.sort();
        keys.dedup();
        keys
    };
    let mut all = figure;
    all.scene.objects[1].segments = 7;
    all.scene.objects[1].scale.x = 2.0;
    assert_eq!(keys(&to_toml(&all)), keys(DOCUMENTED));
}

#[test]
fn the_documented_file_is_drawn() {
    let bench = Bench::new("documented");
    bench.write("figure.toml", DOCUMENTED);
    bench.run(&["render", "figure.toml", "--view", "all", "--size", "300x80", "-o", "a.png"]).done();
}

#[test]
fn the_comments_of_a_documented_file_survive_an_edit() {
    let mut figure = read::parse(DOCUMENTED).unwrap();
    figure.camera.near = 0.25;
    figure.scene.preset = Preset::House;
    let edited = update(DOCUMENTED, &figure);
    let expected =
        DOCUMENTED.replace("near        = 0.1  ", "near        = 0.25  ").replace("\"primitives\" ", "\"house\" ");
    assert_eq!(edited, expected);
}

#[test]
fn a_lamp_hangs_on_the_table_of_the_primitives() {
    let lamp = "[scene]\npreset = \"primitives\"\n[[scene.objects]]\nname = \"lamp\"\nshape = \"cone\"\n\
                parent = \"table\"\ntranslate = [0.0, 1.0, 0.0]\n";
    let figure = read::parse(lamp).unwrap();
    let scene = camera_lab::views::scene_of(
        &figure,
        &mut camera_lab::scene::no_files,
        &camera_lab::progress::Progress::default(),
    )
    .unwrap();
    let lamp = scene.objects.iter().find(|object| object.name == "lamp").unwrap();
    assert_eq!(lamp.world_from_object, glam::DMat4::from_translation(glam::DVec3::Y));
}

#[test]
fn figures_in_the_assets_and_in_the_texts_can_be_read() {
    let folders = ["assets/figures", "assets/figures/pipeline", "assets/figures/extreme"];
    for path in folders.into_iter().flat_map(|folder| files(folder, "toml")) {
        let read = read::parse(&fs::read_to_string(&path).unwrap());
        assert!(read.is_ok(), "{}: {}", path.display(), read.unwrap_err());
    }
    let mut texts = files("docs", "md");
    texts.push(root().join("README.md"));
    for path in texts {
        let Ok(text) = fs::read_to_string(&path) else { continue };
        for block in text.split("```toml\n").skip(1) {
            let block = block.split("```").next().unwrap();
            // A block that asks something is an exercise.
            let asks = block.contains("[[ask]]");
            // One that has steps is a lesson, which has a test of its own.
            let is_lesson = block.contains("[[step]]");
            let fault = if asks { own::parse(block).err() } else { read::parse(block).err().filter(|_| !is_lesson) };
            assert!(fault.is_none(), "{}: {}\n{block}", path.display(), fault.unwrap());
        }
    }
}
