//! `render`, help, streams, exit status, and the language of messages.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::process::Stdio;

use crate::common::program::{Bench, Run};

const FIGURE: &str = "[image]\nwidth = 64\nheight = 48\n[scene]\npreset = \"cube\"\n[style]\nantialias = 1\n";

/// A bench with a small figure on it.
fn bench(name: &str) -> Bench {
    let bench = Bench::new(name);
    bench.write("figure.toml", FIGURE);
    bench
}

pub(super) fn pixels(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut data).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    (info.width, info.height, data)
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let bench = bench("same-bytes");
    for view in ["world", "canonical", "image", "all"] {
        for name in ["a.png", "b.png"] {
            let mut command = bench.command(&["render", "figure.toml", "--view", view, "-o", name]);
            // Neither the language of the system nor the number of threads may show.
            if name == "b.png" {
                command.env("LC_ALL", "pt_BR.UTF-8").env("RAYON_NUM_THREADS", "1");
            }
            assert!(Run::of(&mut command).done().is_empty());
        }
        assert!(bench.read("a.png") == bench.read("b.png"), "{view}");
        let (_, _, data) = pixels(&bench.read("a.png"));
        let colors: std::collections::BTreeSet<_> = data.chunks(3).collect();
        assert!(colors.len() > 8, "{view} is blank");
    }
}

#[test]
fn forcing_all_stages_changes_no_pixel() {
    let bench = bench("forced");
    for view in ["world", "canonical", "image"] {
        bench.run(&["render", "figure.toml", "--view", view, "-o", "a.png"]).done();
        bench.run(&["render", "figure.toml", "--view", view, "-o", "b.png", "--force-all-stages"]).done();
        assert!(bench.read("a.png") == bench.read("b.png"), "{view}");
    }
}

#[test]
fn sizes_are_those_asked_for() {
    let bench = bench("sizes");
    for (arguments, size) in [
        (&[][..], (64, 48)),
        (&["--scale", "2"], (128, 96)),
        (&["--size", "100x30"], (100, 30)),
        (&["--size", "10x30", "--scale", "1.5", "--view", "world"], (15, 45)),
        (&["--view", "all"], (3 * 64 + 2 * 4, 48)),
        (&["--view", "all", "--size", "200x50"], (200, 50)),
    ] {
        bench.run(&[&["render", "figure.toml", "-o", "a.png"], arguments].concat()).done();
        let (width, height, _) = pixels(&bench.read("a.png"));
        assert_eq!((width, height), size, "{arguments:?}");
    }
}

#[test]
fn another_aspect_is_letterboxed_not_stretched() {
    let bench = bench("letterbox");
    bench.run(&["render", "figure.toml", "-o", "plain.png"]).done();
    bench.run(&["render", "figure.toml", "--size", "104x48", "-o", "wide.png"]).done();
    let (plain, wide) = (pixels(&bench.read("plain.png")).2, pixels(&bench.read("wide.png")).2);
    // The picture of 64 × 48 stands in the middle of 104 × 48, with bars of 20. Its frame lies on the border.
    for y in 8..40 {
        let row = |data: &[u8], width: usize, x: usize, n: usize| data[3 * (y * width + x)..][..3 * n].to_vec();
        assert!(row(&plain, 64, 2, 60) == row(&wide, 104, 22, 60), "row {y}");
        assert!(row(&wide, 104, 0, 16) == row(&wide, 104, 88, 16), "row {y}");
    }
}

#[test]
fn themes_and_operations_change_the_picture() {
    let bench = bench("theme");
    let render = |arguments: &[&str]| {
        bench.run(&[&["render", "figure.toml", "-o", "a.png"], arguments].concat()).done();
        pixels(&bench.read("a.png")).2
    };
    let plain = render(&[]);
    assert!(render(&["--theme", "dark"]) != plain);
    assert!(render(&["--op", "azimuth=-20"]) != plain);
    assert!(render(&["--op", "azimuth=360"]) == plain);
    assert!(render(&["--lang", "pt-BR"]) == plain, "the image has no words");
    let cube = ["--view", "canonical", "--size", "320x240"];
    assert!(render(&cube) != render(&[&cube[..], &["--lang", "pt-BR"]].concat()), "the volume has words");
}

#[test]
fn pictures_for_paper_and_for_the_web() {
    let bench = bench("paper");
    let render = |arguments: &[&str], name: &str| {
        bench.run(&[&["render", "figure.toml", "-o", name], arguments].concat()).done();
        image::load_from_memory(&bench.read(name)).unwrap()
    };
    // 8 cm at 300 dots per inch, as high as the image of the figure.
    let print = render(&["--width-cm", "8", "--theme", "print"], "a.png").to_rgba8();
    assert_eq!(print.width(), 945);
    let web = render(&["--width-cm", "8", "--theme", "print"], "a.webp").to_rgba8();
    assert_eq!(print, web, "WebP without loss");
    let jpeg = render(&["--width-cm", "8", "--theme", "print"], "a.jpeg").to_rgba8();
    assert_eq!(jpeg.dimensions(), print.dimensions());
    assert!(print.pixels().all(|p| p.0[3] == 255));
    // Without ground, the corner is clear. Cropped, the picture ends at its contents.
    let clear = render(&["--width-cm", "8", "--transparent"], "b.png").to_rgba8();
    assert!(clear.get_pixel(0, 0).0[3] == 0 && clear.pixels().any(|p| p.0[3] == 255));
    let cropped = render(&["--view", "world", "--size", "600x600", "--crop"], "c.png").to_rgba8();
    let whole = render(&["--view", "world", "--size", "600x600"], "d.png").to_rgba8();
    assert!(cropped.width() < whole.width() && cropped.height() < whole.height());
    // Letters in points: larger ones change the picture with words.
    let nine = render(&["--view", "world", "--width-cm", "8", "--letters", "9"], "e.png");
    assert_ne!(nine, render(&["--view", "world", "--width-cm", "8", "--letters", "12"], "f.png"));
    for given in ["--letters=0", "--width-cm=-3", "--dpi=x", "--lines=-1", "--height-cm=0"] {
        let (option, _) = given.split_once('=').unwrap();
        let width = if option == "--width-cm" { "--crop" } else { "--width-cm=8" };
        let run = bench.run(&["render", "figure.toml", "-o", "g.png", width, given]);
        assert!(run.refused(2).contains(option), "{}", run.err);
    }
}

#[test]
fn a_picture_measured_in_points_has_its_density() {
    let bench = bench("points");
    let density = |arguments: &[&str]| {
        let run = bench.run(&[&["render", "figure.toml", "-o", "a.png"], arguments].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        let bytes = bench.read("a.png");
        let reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        reader.info().pixel_dims.map(|dims| (dims.xppu, dims.yppu))
    };
    assert_eq!(density(&[]), None);
    assert_eq!(density(&["--letters", "9", "--lines", "1"]), None, "a guess is not written");
    assert_eq!(density(&["--width-cm", "8"]), Some((11_811, 11_811)));
    assert_eq!(density(&["--dpi", "150"]), Some((5906, 5906)));
    // A PNG with it still carries its figure.
    bench.run(&["render", "figure.toml", "--width-cm", "4", "-o", "first.png"]).done();
    bench.run(&["render", "first.png", "--width-cm", "4", "-o", "again.png"]).done();
    assert!(bench.read("first.png") == bench.read("again.png"));
    // The dots per inch alone change no pixel.
    let bytes = |arguments: &[&str]| {
        bench.run(&[&["render", "figure.toml", "--view", "world", "-o", "b.png"], arguments].concat()).done();
        pixels(&bench.read("b.png")).2
    };
    let plain = bytes(&["--width-cm", "8", "--letters", "9"]);
    assert!(bytes(&["--width-cm", "8", "--letters", "9", "--dpi", "300"]) == plain);
    // Wider lines leave more ink, narrower ones less.
    let dark = |lines: &str| {
        let pixels = bytes(&["--width-cm", "8", "--letters", "9", "--theme", "print", "--lines", lines]);
        pixels.iter().map(|byte| u64::from(255 - byte)).sum::<u64>()
    };
    assert!(dark("0.2") < dark("0.6") && dark("0.6") < dark("2"));
}

#[test]
fn three_pictures_on_small_paper_are_arranged_with_a_notice() {
    let bench = bench("sheet");
    let all = |arguments: &[&str]| {
        bench.run(&[&["render", "figure.toml", "--view", "all", "-o", "a.png", "--width-cm"], arguments].concat())
    };
    let run = all(&["8", "--height-cm", "6", "--letters", "9", "--lang", "en"]);
    assert_eq!(run.status, Some(0));
    assert!(run.err.contains("a.png: the smallest image is 3.5 × 2.9 cm; letters of 9 pt need"), "{}", run.err);
    assert!(run.err.contains("images of at least 5.1 × 3.5 cm"), "{}", run.err);
    let (width, height, _) = pixels(&bench.read("a.png"));
    assert_eq!((width, height), (945, 709));
    let run = all(&["8", "--height-cm", "6", "--letters", "9", "--lang", "pt-BR"]);
    assert!(run.err.contains("a menor imagem tem 3,5 × 2,9 cm"), "{}", run.err);
    all(&["16", "--height-cm", "12", "--letters", "9"]).done();
}

#[test]
fn jpeg_has_no_transparency_and_says_so() {
    let bench = bench("opaque");
    let run = bench.run(&["render", "figure.toml", "--transparent", "-o", "a.jpg", "--lang", "en"]);
    assert!(
        run.refused(2).contains("JPEG has no transparency; allowed: an --output that ends in .png, .webp"),
        "{}",
        run.err
    );
    assert!(!bench.path("a.jpg").exists());
    bench.run(&["render", "figure.toml", "--transparent", "-o", "a.webp"]).done();
}

#[test]
fn a_refused_picture_leaves_the_old_file() {
    let bench = bench("refused");
    bench.write("bad.toml", "[camera]\nnear = -1");
    bench.write("old.png", "old");
    bench.write("old.gif", "old");
    for (arguments, part) in [
        (&["render", "bad.toml", "-o", "old.png"][..], "bad.toml, line 2: [camera] near"),
        (&["render", "figure.toml", "-o", "old.png", "--op", "zoom=-1"], "zoom"),
        (&["render", "figure.toml", "-o", "old.png", "--size", "0x3"], "1 to 16384"),
        (&["render", "figure.toml", "-o", "old.png", "--size", "20000x3"], "--size"),
        (&["render", "figure.toml", "-o", "old.png", "--size", "9000x9000", "--scale", "2"], "18000 × 18000"),
        (&["render", "figure.toml", "-o", "old.png", "--size", "16384x16384", "--view", "all"], "134 million"),
        (
            &["render", "figure.toml", "-o", "old.png", "--size", "6000x6000", "--scale", "2", "--view", "all"],
            "134 million",
        ),
        (&["bench", "figure.toml", "--size", "16384x16384", "--view", "all"], "134 million"),
        (
            &["inspect", "figure.toml", "--op", "pan=1e308,1e308", "--op", "pan=1e308,1e308"],
            "exceed the range of numbers",
        ),
        (&["render", "figure.toml", "-o", "old.png", "--scale", "0"], "--scale is \"0\"; allowed"),
        (&["render", "figure.toml", "-o", "old.png", "--view", "side"], "world, canonical, image, all"),
        (&["render", "figure.toml", "-o", "old.gif"], ".png"),
        (&["render", "figure.toml", "-o", "noending"], ".png"),
        (&["render", "figure.toml"], "--output"),
    ] {
        let run = bench.run(arguments);
        assert!(run.refused(2).contains(part), "{part}: {}", run.err);
    }
    let run = bench.run(&["render", "figure.toml", "-o", "no/such/place.png"]);
    assert!(run.refused(1).contains("place.png cannot be written"), "{}", run.err);
    assert_eq!((bench.read("old.png"), bench.read("old.gif")), (b"old".to_vec(), b"old".to_vec()));
    assert_eq!(bench.names(), ["bad.toml", "figure.toml", "old.gif", "old.png"]);
}

#[test]
fn messages_speak_the_language_asked_for_or_the_systems() {
    let bench = bench("languages");
    let message = |arguments: &[&str], locale: &str| {
        let run = Run::of(bench.command(arguments).env("LC_ALL", locale));
        run.refused(2).to_owned()
    };
    let missing = ["inspect", "none.toml"];
    assert!(message(&missing, "pt_BR.UTF-8").contains("não pode ser lido"));
    assert!(message(&missing, "pt_PT.UTF-8").contains("não pode ser lido"));
    assert!(message(&missing, "fr_FR.UTF-8").contains("cannot be read"));
    assert!(message(&["inspect", "none.toml", "--lang", "en"], "pt_BR.UTF-8").contains("cannot be read"));
    assert!(message(&["inspect", "none.toml", "--lang", "pt-BR"], "C").contains("não pode ser lido"));
    assert!(message(&["inspect", "figure.toml", "--nope", "--lang", "pt-BR"], "C").contains("desconhecido"));
    assert!(message(&["render", "figure.toml"], "pt_BR.UTF-8").contains("falta o argumento obrigatório"));
    assert!(message(&["inspect", "figure.toml", "--lang", "xx"], "pt_BR.UTF-8").contains("permitido: en, pt-BR"));
}

#[test]
fn a_mistyped_command_is_called_so() {
    let bench = bench("mistyped");
    for arguments in [&["rendr", "figure.toml", "-o", "a.png"][..], &["inspct", "figure.toml"]] {
        let run = bench.run(arguments);
        assert!(run.refused(2).contains(&format!("no command {:?}", arguments[0])), "{}", run.err);
        assert!(run.err.contains("allowed: inspect, render"), "{}", run.err);
    }
}

#[test]
fn help_and_version_work_on_every_command() {
    let bench = Bench::new("help");
    for command in [&[][..], &["inspect"], &["render"]] {
        let help = bench.run(&[command, &["--help"]].concat());
        assert!(String::from_utf8_lossy(help.done()).contains("Usage: camera-lab"));
        let version = bench.run(&[command, &["--version"]].concat());
        assert!(String::from_utf8_lossy(version.done()).contains(env!("CARGO_PKG_VERSION")));
    }
}

#[test]
fn without_a_display_it_says_so_and_names_render() {
    let bench = bench("no-display");
    for arguments in [&[][..], &["figure.toml"]] {
        let run = bench.run(arguments);
        assert!(run.refused(1).contains("camera-lab render"), "{}", run.err);
    }
    let run = bench.run(&["none.toml"]);
    assert!(run.refused(2).contains("none.toml"), "{}", run.err);
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_ends_quietly() {
    let bench = bench("pipe");
    for arguments in [&["inspect", "figure.toml"][..], &["--help"]] {
        let mut child = bench.command(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
        assert_eq!(output.status.code(), Some(0));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure_not_bad_input() {
    let bench = bench("full");
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let run = Run::of(bench.command(&["inspect", "figure.toml"]).stdout(full));
    assert_eq!(
        (run.status, run.err.trim()),
        (Some(1), "camera-lab: standard output cannot be written: the disk is full")
    );
}

#[test]
fn numbers_may_be_expressions() {
    let bench = bench("expressions");
    let json = |arguments: &[&str]| {
        let run = bench.run(&[&["inspect", "figure.toml"], arguments].concat());
        String::from_utf8(run.done().to_vec()).unwrap()
    };
    assert_eq!(json(&["--op", "azimuth=360/8"]), json(&["--op", "azimuth=45"]));
    assert_eq!(
        json(&["--op", "azimuth=pi/4 rad", "--op", "zoom=1,5"]),
        json(&["--op", "azimuth=45°", "--op", "zoom=1.5"])
    );
    assert_eq!(json(&["--op", "pan=cos(60°),-1"]), json(&["--op", "pan=0,5;−1"]));
    let point = json(&["--point", "sqrt(2)/2,0,0"]);
    assert!(point.contains("0.7071067811865476"), "{point}");
    for (arguments, part) in [
        (["--op", "azimuth=360/"], "azimuth is \"360/\": the expression is not finished in 360/▸◂; allowed"),
        (["--op", "zoom=2x"], "unknown name “x” in 2▸x◂"),
        (["--op", "zoom=1-1"], "greater than 0"),
        (["--point", "1,sqr(2),3"], "--point is \"1,sqr(2),3\": unknown name “sqr” in ▸sqr◂(2); allowed"),
        (["--point", "1,2"], "--point is \"1,2\"; allowed"),
    ] {
        let run = bench.run(&[&["inspect", "figure.toml"], &arguments[..]].concat());
        assert!(run.refused(2).contains(part), "{part}: {}", run.err);
    }
}

#[test]
fn faces_that_are_too_many_to_be_split_are_drawn_with_the_depth_buffer_and_named() {
    let bench = bench("too-many-pieces");
    let ball = |name: &str| {
        format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"sphere\"\nsegments = 512\ncolor = \"#4477aa80\"\n")
    };
    let figure = |visibility: &str| {
        let style = format!("[style]\nvisibility = \"{visibility}\"\nshading = \"flat\"\nantialias = 1\n");
        format!("[scene]\npreset = \"empty\"\n{}{}{}{style}", ball("one"), ball("other"), ball("third"))
    };
    bench.write("bsp.toml", figure("bsp"));
    bench.write("depth.toml", figure("depth-buffer"));
    let run = Run::of(&mut bench.command(&["render", "bsp.toml", "--size", "24x18", "-o", "bsp.png"]));
    assert_eq!(run.status, Some(0));
    for word in ["bsp.toml", "\"one\"", "\"other\"", "524288 pieces", "depth buffer"] {
        assert!(run.err.contains(word), "{}", run.err);
    }
    bench.run(&["render", "depth.toml", "--size", "24x18", "-o", "depth.png"]).done();
    // So small a picture has no room for the note.
    assert!(pixels(&bench.read("bsp.png")) == pixels(&bench.read("depth.png")));
}

#[test]
fn there_are_not_more_lights_than_may_be() {
    let bench = bench("lights");
    let light = "[[scene.lights]]\nkind = \"point\"\nposition = [1, 2, 3]\n";
    for (count, status) in [(1024, Some(0)), (1025, Some(2))] {
        bench.write("lights.toml", format!("[scene]\npreset = \"cube\"\n{}", light.repeat(count)));
        let run = Run::of(&mut bench.command(&["render", "lights.toml", "--size", "8x6", "-o", "a.png"]));
        assert_eq!(run.status, status, "{}", run.err);
        assert_eq!(run.err.contains("1025; allowed: at most 1024"), count > 1024, "{}", run.err);
    }
}

/// The signal of Ctrl+C. If the user who runs the tests has made this program ignore it, the one that ends programs.
#[cfg(unix)]
fn interrupt() -> &'static str {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| u64::from_str_radix(line.strip_prefix("SigIgn:")?.trim(), 16).ok());
    if ignored.is_some_and(|signals| signals & 0b10 != 0) { "-TERM" } else { "-INT" }
}

#[cfg(unix)]
#[test]
fn an_interrupted_command_leaves_the_file_as_it_was_and_nothing_else() {
    let bench = bench("interrupted");
    bench.write("out.png", "old");
    let before = bench.names();
    for pause in [50, 400, 900] {
        let mut command = bench.command(&["render", "figure.toml", "--size", "12000x8000", "-o", "out.png"]);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(pause));
        let interrupted = std::process::Command::new("kill").args([interrupt(), &child.id().to_string()]).status();
        assert!(interrupted.unwrap().success());
        assert!(!child.wait().unwrap().success());
        assert_eq!(bench.read("out.png"), b"old");
        assert_eq!(bench.names(), before);
    }
}

#[test]
fn an_option_before_the_command_gives_the_right_order() {
    let bench = bench("before");
    for (arguments, found) in [
        (
            ["--allow-files", "render", "figure.toml"].as_slice(),
            "an option comes before the command; allowed: camera-lab COMMAND",
        ),
        (&["--lang", "pt-BR", "render", "figure.toml"], "há uma opção antes do comando; permitido: camera-lab COMANDO"),
    ] {
        let run = Run::of(&mut bench.command(arguments));
        assert_eq!(run.status, Some(2), "{}", run.err);
        assert!(run.err.contains(found), "{}", run.err);
    }
}

#[test]
fn the_address_of_a_page_is_one() {
    let bench = bench("page-address");
    for address in ["ftp://x", "example.org", "https://", ""] {
        let run = bench.run(&["--page-address", address]);
        assert!(run.refused(2).contains("https://"), "{address}");
    }
}
