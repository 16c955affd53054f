//! Files and arguments that are wrong, too large, or slow: the limits of each reader, and its messages.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs::{self, File};

use camera_lab::sanitize::is_obeyed;
use serde_json::Value;

use crate::common::program::Bench;

/// A file of this size that takes no room on the disk.
fn sparse(bench: &Bench, name: &str, start: &[u8], size: u64) {
    bench.write(name, start);
    File::options().write(true).open(bench.path(name)).unwrap().set_len(size).unwrap();
}

#[test]
fn each_reader_refuses_larger_input_and_names_its_limit() {
    const MIB: u64 = 1 << 20;
    let bench = Bench::new("limits");
    bench.write("figure.toml", "[scene]\npreset = \"cube\"\n");
    sparse(&bench, "large.toml", b"[camera]\n", 8 * MIB + 1);
    sparse(&bench, "lesson.toml", b"[[step]]\n", 4 * MIB + 1);
    sparse(&bench, "cameras.json", b"{", 8 * MIB + 1);
    sparse(&bench, "cameras.yaml", b"a:", 8 * MIB + 1);
    let glb = [&b"glTF\x02\0\0\0"[..], &[0xff; 4], &((8_u32 << 20) + 1).to_le_bytes(), b"JSON"].concat();
    sparse(&bench, "cameras.glb", &glb, 9 * MIB);
    sparse(&bench, "image.png", b"\x89PNG\r\n\x1a\n", (1 << 30) + 1);
    sparse(&bench, "mesh.obj", b"v 0 0 0\n", 512 * MIB + 1);
    bench.write("mesh.toml", "[[scene.objects]]\nname = \"m\"\nshape = \"mesh\"\npath = \"mesh.obj\"\n");
    for (arguments, limit) in [
        (&["inspect", "large.toml"][..], "8 MiB"),
        (&["lesson", "check", "lesson.toml"], "4 MiB"),
        (&["matrix", "figure.toml", "--from", "cameras.json"], "8 MiB"),
        (&["matrix", "figure.toml", "--from", "cameras.yaml"], "8 MiB"),
        (&["matrix", "figure.toml", "--from", "cameras.glb"], "8 MiB"),
        (&["inspect", "image.png"], "1 GiB"),
        (&["render", "mesh.toml", "-o", "o.png"], "512 MiB"),
    ] {
        for lang in ["en", "pt-BR"] {
            let run = bench.run(&[arguments, &["--lang", lang][..]].concat());
            assert!(run.refused(2).contains(limit), "{arguments:?}: {}", run.err);
        }
    }
}

#[test]
fn of_a_glb_file_the_json_is_read_and_the_rest_is_not() {
    let bench = Bench::new("glb");
    bench.write("figure.toml", "");
    let json = r#"{"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"camera":0,"translation":[0,0,5]}],"cameras":[{"type":"perspective","perspective":{"yfov":0.8,"znear":0.1,"zfar":10}}]}"#;
    let length = u32::try_from(json.len()).unwrap().to_le_bytes();
    let glb = [&b"glTF\x02\0\0\0"[..], &[0xff; 4], &length, b"JSON", json.as_bytes()].concat();
    // Larger than any file that's read whole.
    sparse(&bench, "large.glb", &glb, 3 << 30);
    let answer = bench.run(&["matrix", "figure.toml", "--from", "large.glb", "--format", "json"]).json();
    assert_eq!(answer["camera"]["position"], serde_json::json!([0.0, 0.0, 5.0]));
}

#[test]
fn names_of_cameras_reach_programs_whole_and_no_terminal_raw() {
    let bench = Bench::new("names");
    bench.write("figure.toml", "");
    let name = "a\u{202e}b\u{9b}2J\u{1b}[2J\u{e0041}";
    let pose = |name: &str| serde_json::json!({ "file_path": name, "transform_matrix": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]] });
    let file = serde_json::json!({ "camera_angle_x": 0.8, "frames": [pose(name), pose("other")] });
    bench.write("transforms.json", file.to_string());
    for format in ["json", "text"] {
        for camera in ["1", "all"] {
            let run = bench.run(&[
                "matrix",
                "figure.toml",
                "--from",
                "transforms.json",
                "--camera",
                camera,
                "--format",
                format,
            ]);
            let text = String::from_utf8(run.done().to_vec()).unwrap();
            assert!(!text.contains(|c| c != '\n' && is_obeyed(c)), "{format} {camera}: {text:?}");
            if format == "json" {
                let answer: Value = serde_json::from_str(&text).unwrap();
                assert_eq!(answer["cameras"][0], name);
            }
        }
    }
    let run = bench.run(&["matrix", "figure.toml", "--from", "transforms.json", "--camera", "none"]);
    assert!(!run.refused(2).contains(|c| c != '\n' && is_obeyed(c)));
}

#[test]
fn a_pipe_is_no_place_for_an_image() {
    if cfg!(unix) {
        let bench = Bench::new("fifo");
        bench.write("figure.toml", "");
        let made = std::process::Command::new("mkfifo").arg(bench.path("p.png")).status();
        assert!(made.is_ok_and(|status| status.success()));
        // Would wait for a reader for ever.
        let run = bench.run(&["render", "figure.toml", "--size", "16x12", "-o", "p.png"]);
        assert!(run.refused(1).contains("pipe"), "{}", run.err);
    }
}

#[test]
fn a_step_on_the_way_needs_no_way() {
    let bench = Bench::new("step-at");
    bench.write("figure.toml", "");
    let render = |show: &str, name: &str| {
        bench
            .run(&["render", "figure.toml", "--view", "canonical", "--size", "64x48", "--show", show, "-o", name])
            .done();
        bench.read(name)
    };
    assert_eq!(render("step.at=2.5", "a.webp"), render("step={way=\"notes\",at=2.5}", "b.webp"));
    bench.run(&["sheet", "figure.toml", "--view", "canonical", "--vary", "show.step.at=0,1,2", "-o", "c.png"]).done();
    bench.run(&["render", "figure.toml", "--show", "step.at=99", "-o", "d.png"]).refused(2);
}

#[test]
fn lines_of_one_direction_are_no_camera_in_any_format() {
    let bench = Bench::new("one-direction");
    bench.write("figure.toml", "[camera]\nprojection = \"parallel\"\nnear = -3\n[image]\nwidth = 640\nheight = 480\n");
    let x = "x: 100,100 200,100; 100,200 200,200";
    let z = "z: 100,300 200,300; 100,400 200,400";
    for format in ["text", "json"] {
        let run = bench.run(&["photograph", "figure.toml", "--lines", x, "--lines", z, "--format", format]);
        assert!(run.refused(2).contains("x and z run in the same direction"), "{}", run.err);
    }
    // A parallel figure gets the usual planes of a perspective.
    let z = "z: 100,100 20,130; 100,300 10,260";
    let x = "x: 100,100 200,120; 100,300 200,270";
    let found = bench.run(&["photograph", "figure.toml", "--lines", x, "--lines", z]);
    bench.write("found.toml", found.done());
    bench.run(&["inspect", "found.toml"]).done();
    fs::remove_file(bench.path("found.toml")).unwrap();
}

#[test]
fn the_whole_list_of_cameras_follows_the_convention_of_ndc() {
    let bench = Bench::new("list-ndc");
    let keys = "position = [3, 4, 5]\nnear = 0.5\n";
    bench.write("figure.toml", format!("[camera]\n{keys}[[cameras]]\nname = \"A\"\n{keys}"));
    for ndc in ["opengl", "direct3d", "vulkan", "metal-reversed", "webgpu-infinite", "vulkan-reversed-infinite"] {
        let report = bench.run(&["inspect", "figure.toml", "--ndc", ndc, "--format", "json"]).json();
        assert_eq!(report["cameras"][0]["projection_matrix"], report["projection_matrix"], "{ndc}");
    }
    bench.write(
        "parallel.toml",
        format!("[camera]\n{keys}[[cameras]]\nname = \"A\"\n{keys}projection = \"parallel\"\n"),
    );
    bench.run(&["inspect", "parallel.toml", "--ndc", "vulkan", "--format", "json"]).json();
    let alone = bench.run(&["inspect", "parallel.toml", "--ndc", "vulkan-infinite"]);
    assert!(alone.refused(2).contains("vulkan-infinite"), "{}", alone.err);
}

#[test]
fn an_impossible_camera_of_the_list_is_named_with_all_its_brackets() {
    let bench = Bench::new("brackets");
    for (list, section) in [("[camera]\n", "[camera] "), ("[[cameras]]\nname = \"A\"\n", "[[cameras]] ")] {
        bench.write("figure.toml", format!("{list}position = [0, 0, 0]\n"));
        for lang in ["en", "pt-BR"] {
            let run = bench.run(&["inspect", "figure.toml", "--lang", lang]);
            assert!(run.refused(2).contains(&format!(": {section}")), "{}", run.err);
        }
    }
}

#[test]
fn a_handout_of_many_steps_draws_each_picture_once() {
    let bench = Bench::new("hundred");
    let lesson = |count: usize| {
        let steps = "[[step]]\ntitle = \"Word\"\ntext = \"Word\"\n".repeat(count);
        format!("id = \"many\"\ntitle = \"Many\"\n{steps}")
    };
    bench.write("lesson.toml", lesson(100));
    bench.run(&["lesson", "render", "lesson.toml", "-o", "many.pdf"]).done();
    let size = bench.read("many.pdf").len();
    assert!(size < 1_000_000, "{size} bytes");
}
