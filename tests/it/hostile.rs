//! Files of strangers: limits on their messages, on the files they reach, and on their cost.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use crate::common::program::{Bench, Run};
use crate::common::rendered::png_with;

/// Every language of the messages.
const LANGS: [&str; 2] = ["en", "pt-BR"];

/// A scene with these meshes.
fn meshes(paths: &[&str]) -> String {
    let object =
        |(i, path): (usize, &&str)| format!("[[scene.objects]]\nname = \"m{i}\"\nshape = \"mesh\"\npath = {path}\n");
    "[image]\nwidth = 16\nheight = 12\n".to_owned() + &paths.iter().enumerate().map(object).collect::<String>()
}

fn render(bench: &Bench, figure: &str, more: &[&str]) -> Run {
    bench.run(&[&["render", figure, "-o", "o.png"], more].concat())
}

/// Holds that the message has no control characters and can be read at a glance.
#[track_caller]
fn is_harmless(message: &str) {
    let line = message.trim_end_matches('\n');
    assert!(!line.chars().any(|c| c.is_control() || ('\u{202a}'..='\u{202e}').contains(&c)), "{line:?}");
    assert!(line.chars().count() < 900, "{} characters: {line:.200}…", line.chars().count());
}

#[test]
fn foreign_text_reaches_no_terminal_raw_or_at_full_length() {
    let bench = Bench::new("foreign-text");
    let escape = "\u{1b}[31mEVIL\u{1b}[2J\u{202e}";
    let long = "x".repeat(100_000);
    for word in [escape, &long] {
        let toml = word.chars().map(|c| if c.is_control() { format!("\\u{:04x}", c as u32) } else { c.to_string() });
        let toml: String = toml.collect();
        bench.write("evil.obj", format!("v 0 0 0\nv 1 {word} 0\n"));
        bench.write("corner.obj", format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 {word}\n"));
        let gltf =
            |uri: &str| format!(r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":1,"uri":"{uri}"}}]}}"#);
        bench.write("uri.gltf", gltf(&toml));
        bench.write("key.gltf", format!(r#"{{"asset":{{"version":"2.0"}},"buffers":"{toml}"}}"#));
        bench.write("version.gltf", format!(r#"{{"asset":{{"version":"{toml}"}}}}"#));
        let object = |key: &str| format!("[[scene.objects]]\nname = \"a\"\n{key} = \"{toml}\"\n");
        let named = format!("[[scene.objects]]\nname = \"{toml}\"\n");
        let parents: String = (0..2000)
            .map(|i| format!("[[scene.objects]]\nname = \"{i}\"\nparent = \"{}\"\n", (i + 1) % 2000))
            .collect();
        for figure in [
            meshes(&[&format!("\"{toml}.obj\"")]),
            meshes(&["\"evil.obj\""]),
            meshes(&["\"corner.obj\""]),
            meshes(&["\"uri.gltf\""]),
            meshes(&["\"key.gltf\""]),
            meshes(&["\"version.gltf\""]),
            object("parent"),
            object("shape"),
            object("color"),
            object("scale"),
            named.clone() + &named,
            format!("{named}parent = \"{toml}\"\n"),
            format!(
                "{named}scale = [1e200, 1, 1]\n[[scene.objects]]\nname = \"b\"\nparent = \"{toml}\"\nscale = [1e200, 1, 1]\n"
            ),
            format!("[camera]\n\"{toml}\" = 1\n"),
            format!("[camera]\nnear = \"{toml}\"\n"),
            format!("[\"{toml}\"]\n"),
            format!("near = {word}\n"),
            format!("[camera]\nnear = 1 {word}\n"),
            parents,
        ] {
            bench.write("figure.toml", &figure);
            for lang in LANGS {
                is_harmless(render(&bench, "figure.toml", &["--lang", lang]).refused(2));
            }
        }
        if word == escape {
            is_harmless(render(&bench, &format!("{word}.toml"), &[]).refused(2));
        }
        for option in [["--op", word], ["--scale", word], ["--view", word], ["--theme", word], [word, word]] {
            bench.write("figure.toml", "");
            for lang in LANGS {
                is_harmless(render(&bench, "figure.toml", &[&option[..], &["--lang", lang]].concat()).refused(2));
            }
        }
    }
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";

/// A glTF file with one triangle in a buffer that lies at `uri`, and the bytes of that buffer.
fn gltf(uri: &str, buffers: usize) -> (String, Vec<u8>) {
    let buffer = format!(r#"{{"byteLength": 36, "uri": "{uri}"}}"#);
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}}],
"bufferViews": [{{"buffer": 0, "byteLength": 36}}], "buffers": [{}]}}"#,
        vec![buffer; buffers].join(", ")
    );
    let points = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    (json, points.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect())
}

#[test]
fn a_mesh_reaches_nothing_outside_of_its_folder_unless_the_user_lets_it() {
    let bench = Bench::new("reach");
    std::fs::create_dir(bench.path("meshes")).unwrap();
    std::fs::create_dir(bench.path("figures")).unwrap();
    let (_, points) = gltf("", 1);
    bench.write("points.bin", &points);
    let absolute = bench.path("points.bin");
    bench.write("figures/figure.toml", meshes(&["\"../meshes/m.gltf\""]));
    for uri in ["../points.bin", "%2e%2e/points.bin", "..%5cpoints.bin", "..\\\\points.bin", absolute.to_str().unwrap()]
    {
        bench.write("meshes/m.gltf", gltf(uri, 1).0);
        let message = |lang| render(&bench, "figures/figure.toml", &["--lang", lang]).refused(2).to_owned();
        let (en, pt) = (message("en"), message("pt-BR"));
        assert!(en.contains("a mesh names it and it lies elsewhere"), "{en}");
        assert!(pt.contains("uma malha o indica e ele está em outro lugar"), "{pt}");
        for message in [en, pt] {
            assert!(message.contains("points.bin") && message.contains("--allow-files"), "{message}");
        }
        for command in ["render", "explain", "bench"] {
            let more: &[&str] = match command {
                "render" => &["-o", "o.png"],
                "bench" => &["--frames", "1"],
                _ => &[],
            };
            bench.run(&[&[command, "figures/figure.toml"], more].concat()).refused(2);
            let allowed = bench.run(&[&[command, "figures/figure.toml", "--allow-files"], more].concat());
            assert_eq!((allowed.status, allowed.err.as_str()), (Some(0), ""), "{uri}");
        }
        bench.run(&["inspect", "figures/figure.toml", "--allow-files"]).done();
    }
    // Another machine is never asked, and a missing file gives the same message as an existing one.
    for (uri, part) in [
        ("//host/points.bin", "another machine"),
        ("\\\\\\\\host\\\\x", "another machine"),
        ("../nothing", "elsewhere"),
    ] {
        bench.write("meshes/m.gltf", gltf(uri, 1).0);
        assert!(render(&bench, "figures/figure.toml", &[]).refused(2).contains(part), "{uri}");
    }
    let network = render(&bench, "figures/figure.toml", &["--allow-files"]);
    assert!(network.refused(2).contains("there is no such file"), "{}", network.err);
}

#[test]
fn a_figure_in_a_picture_reaches_only_the_pictures_folder() {
    let bench = Bench::new("picture-reach");
    std::fs::create_dir(bench.path("inner")).unwrap();
    bench.write("m.obj", TRIANGLE.replace("usemtl red\n", ""));
    bench.write("figure.toml", meshes(&["\"m.obj\""]));
    bench.run(&["render", "figure.toml", "-o", "inside.png"]).done();
    bench.run(&["render", "inside.png", "-o", "again.png"]).done();
    bench.write("inner/figure.toml", meshes(&["\"../m.obj\""]));
    bench.run(&["render", "inner/figure.toml", "-o", "inner/carried.png"]).done();
    bench.run(&["render", "inner/carried.png", "-o", "o.png"]).done();
    assert_eq!(bench.read("o.png"), bench.read("inner/carried.png"));
    // It doesn't carry the mesh.
    bench.write("inner/outside.png", png_with(&meshes(&["\"../m.obj\""])));
    let run = bench.run(&["render", "inner/outside.png", "-o", "o.png"]);
    assert!(run.refused(2).contains("a figure inside an image names it"), "{}", run.err);
    bench.run(&["render", "inner/outside.png", "--allow-files", "-o", "o.png"]).done();
}

#[test]
fn a_material_library_that_is_not_read_is_mentioned() {
    let bench = Bench::new("mtllib");
    std::fs::create_dir(bench.path("inner")).unwrap();
    bench.write("red.mtl", "newmtl red\nKd 1 0 0\n");
    bench.write("figure.toml", meshes(&["\"inner/m.obj\""]));
    for (library, en, pt) in [
        ("gone.mtl", "gone.mtl cannot be read: there is no such file", "gone.mtl não pode ser lido"),
        ("../red.mtl", "it lies elsewhere", "está em outro lugar"),
        ("//host/red.mtl", "another machine", "outra máquina"),
    ] {
        bench.write("inner/m.obj", format!("mtllib {library}\nmtllib {library}\n{TRIANGLE}"));
        let run = render(&bench, "figure.toml", &[]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        assert!(run.err.contains(en) && run.err.contains("drawn without it"), "{}", run.err);
        assert_eq!(run.err.lines().count(), 1, "once: {}", run.err);
        let run = render(&bench, "figure.toml", &["--lang", "pt-BR"]);
        assert!(run.err.contains(pt) && run.err.contains("desenhada sem ele"), "{}", run.err);
    }
    bench.write("inner/m.obj", format!("mtllib ../red.mtl\n{TRIANGLE}"));
    assert_eq!(render(&bench, "figure.toml", &["--allow-files"]).err, "");
}

#[cfg(unix)]
#[test]
fn devices_and_pipes_are_refused_wherever_they_are_named() {
    let bench = Bench::new("devices");
    assert!(std::process::Command::new("mkfifo").arg(bench.path("pipe")).status().unwrap().success());
    assert!(std::process::Command::new("mkfifo").arg(bench.path("pipe.obj")).status().unwrap().success());
    for figure in ["pipe", "/dev/zero", "/dev/stdin"] {
        assert!(render(&bench, figure, &[]).refused(2).contains("a device, a pipe or a socket"), "{figure}");
    }
    bench.write("figure.toml", meshes(&["\"pipe.obj\""]));
    assert!(render(&bench, "figure.toml", &[]).refused(2).contains("a device, a pipe or a socket"));
    bench.write("figure.toml", meshes(&["\"m.obj\"", "\"m.gltf\""]));
    bench.write("m.gltf", gltf("pipe", 1).0);
    bench.write("m.obj", TRIANGLE);
    assert!(render(&bench, "figure.toml", &[]).refused(2).contains("a device, a pipe or a socket"));
    bench.write("figure.toml", meshes(&["\"m.obj\""]));
    for library in ["pipe", "/dev/urandom"] {
        bench.write("m.obj", format!("mtllib {library}\n{TRIANGLE}"));
        let run = render(&bench, "figure.toml", &["--allow-files"]);
        assert_eq!(run.status, Some(0));
        assert!(run.err.contains("a device, a pipe or a socket"), "{}", run.err);
    }
}

#[test]
fn files_named_by_a_figure_share_a_budget_and_count_once_each() {
    let bench = Bench::new("budget");
    let points = gltf("", 1).1;
    // 200 MiB that take no room on the disk.
    let sparse = |name: &str, mib: u64| {
        bench.write(name, &points);
        std::fs::OpenOptions::new().write(true).open(bench.path(name)).unwrap().set_len(mib << 20).unwrap();
    };
    sparse("a.bin", 200);
    sparse("b.bin", 200);
    sparse("c.bin", 200);
    bench.write("a.gltf", gltf("a.bin", 20).0);
    bench.write("b.gltf", gltf("b.bin", 1).0);
    bench.write("c.gltf", gltf("c.bin", 1).0);
    bench.write("figure.toml", meshes(&["\"a.gltf\"", "\"b.gltf\""]));
    render(&bench, "figure.toml", &[]).done();
    bench.write("figure.toml", meshes(&["\"a.gltf\"", "\"b.gltf\"", "\"c.gltf\""]));
    for (lang, part) in [("en", "with it the files of this figure exceed 512 MiB"), ("pt-BR", "passam de 512 MiB")] {
        let run = render(&bench, "figure.toml", &["--lang", lang]);
        assert!(run.refused(2).contains(part) && run.err.contains("c.bin"), "{}", run.err);
    }
}

/// A message does not repeat the link, which no user typed. It names the figure in the link.
#[test]
fn errors_in_a_link_name_the_figure_in_it() {
    let bench = Bench::new("link-faults");
    let link = |text: &str| {
        camera_lab_files::share::link("https://example.org/lab/", camera_lab_files::share::Held::Figure, text).unwrap()
    };
    let long = "# x\n".repeat(40);
    for lang in LANGS {
        let (name, line) =
            if lang == "en" { ("the figure in the link", "line 42") } else { ("a figura no link", "linha 42") };
        let run = render(&bench, &link(&format!("{long}[camera]\nnear = 0\n")), &["--lang", lang]);
        let said = run.refused(2);
        assert!(said.contains(&format!("{name}, {line}: [camera] near")) && !said.contains("…"), "{said}");
        let run = render(&bench, &link(&meshes(&["\"../secret.obj\""])), &["--lang", lang]);
        let said = run.refused(2);
        assert!(
            said.contains(name)
                && said.contains("../secret.obj")
                && !said.contains("figure=")
                && !said.contains("example.org"),
            "{said}"
        );
    }
}
