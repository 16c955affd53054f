//! Families of pictures: `sheet`, `animate --vary`, and the observer of a series.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::figure::variation::{Variation, VariationError};

use crate::common::program::Bench;

const FIGURE: &str = "[image]\nwidth = 64\nheight = 48\n[scene]\npreset = \"cube\"\n[style]\nantialias = 1\n";

fn bench(name: &str) -> Bench {
    let bench = Bench::new(name);
    bench.write("figure.toml", FIGURE);
    bench
}

/// A PNG: its width, and RGBA from the top.
struct Picture {
    width: u32,
    height: u32,
    rgba: Vec<u8>,
}

impl Picture {
    fn width(&self) -> u32 {
        self.width
    }

    fn height(&self) -> u32 {
        self.height
    }

    fn data(&self) -> &[u8] {
        &self.rgba
    }
}

fn picture(bench: &Bench, name: &str) -> Picture {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bench.read(name))).read_info().unwrap();
    let mut rgba = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut rgba).unwrap();
    rgba.truncate(info.buffer_size());
    if info.color_type == png::ColorType::Rgb {
        rgba = rgba.chunks(3).flat_map(|c| [c[0], c[1], c[2], 255]).collect();
    }
    Picture { width: info.width, height: info.height, rgba }
}

fn read(bench: &Bench, name: &str) -> String {
    String::from_utf8(bench.read(name)).unwrap()
}

/// The pixels of a part of a picture.
fn part(picture: &Picture, [left, top]: [u32; 2], [width, height]: [u32; 2]) -> Vec<u8> {
    let pixel = |x: u32, y: u32| {
        let at = 4 * (y * picture.width() + x) as usize;
        picture.data()[at..at + 4].to_vec()
    };
    (top..top + height).flat_map(|y| (left..left + width).flat_map(move |x| pixel(x, y))).collect()
}

#[test]
fn each_picture_of_a_sheet_is_that_of_render_with_the_same_observer() {
    let bench = bench("families-cells");
    for view in ["world", "canonical", "image"] {
        let vary = ["sheet", "figure.toml", "--vary", "azimuth=0,30", "--vary", "zoom=1,2"];
        let out = ["--view", view, "--observer-of", "figure.toml", "-o", "sheet.png"];
        bench.run(&[&vary[..], &out[..]].concat()).done();
        let sheet = picture(&bench, "sheet.png");
        // Two columns of 480 × 360, a gap of 4, and the captions.
        assert_eq!(sheet.width(), 2 * 480 + 4);
        let row = (sheet.height() + 4) / 2;
        for (place, ops) in
            [["azimuth=0", "zoom=1"], ["azimuth=0", "zoom=2"], ["azimuth=30", "zoom=1"], ["azimuth=30", "zoom=2"]]
                .into_iter()
                .enumerate()
        {
            let one = ["render", "figure.toml", "--op", ops[0], "--op", ops[1], "--view", view, "--size", "480x360"];
            bench.run(&[&one[..], &["--observer-of", "figure.toml", "-o", "one.png"]].concat()).done();
            let place = u32::try_from(place).unwrap();
            let corner = [place % 2 * 484, place / 2 * row];
            let found = part(&sheet, corner, [480, 360]);
            assert!(found == picture(&bench, "one.png").data(), "{view} {ops:?}");
        }
    }
}

#[test]
fn a_series_has_one_observer_who_has_every_camera_in_the_picture() {
    let bench = bench("families-observer");
    let azimuths = ["render", "figure.toml", "--view", "world", "--size", "200x150"];
    let with = |more: &[&str], name: &str| {
        bench.run(&[&azimuths[..], more, &["-o", name]].concat()).done();
        picture(&bench, name).data().to_vec()
    };
    // Without an observer the camera stays in its place, and the cube has turned.
    let own = with(&["--op", "azimuth=90"], "own.png");
    let series = with(&["--op", "azimuth=90", "--observer-of", "figure.toml"], "series.png");
    assert_ne!(own, series);
    assert_eq!(with(&[], "plain.png"), with(&["--observer-of", "figure.toml"], "same.png"), "its own observer");
    // The observer of a sheet sees nothing cut off: no picture touches the border of its place.
    bench.run(&["sheet", "figure.toml", "--vary", "azimuth=0,90,180,270", "--view", "world", "-o", "sheet.png"]).done();
    let sheet = picture(&bench, "sheet.png");
    for k in 0..4 {
        let ground = part(&sheet, [0, 0], [1, 1]);
        let column = part(&sheet, [k * 484, 0], [1, 360]);
        assert!(column.chunks(4).all(|pixel| pixel == ground), "picture {k}");
    }
}

#[test]
fn captions_say_the_value_in_the_words_of_the_language_and_parts_have_letters() {
    let bench = bench("families-captions");
    let text = |arguments: &[&str]| {
        let run = bench.run(&[&["sheet", "figure.toml", "-o", "o.svg"], arguments].concat());
        run.done();
        let svg = read(&bench, "o.svg");
        let texts: Vec<String> = svg
            .split("<text")
            .skip(1)
            .map(|part| {
                let inner = &part[part.find('>').unwrap() + 1..part.find("</text>").unwrap()];
                let mut plain = String::new();
                let mut in_tag = false;
                for c in inner.chars() {
                    match c {
                        '<' => in_tag = true,
                        '>' => in_tag = false,
                        c if !in_tag => plain.push(c),
                        _ => {}
                    }
                }
                plain
            })
            .collect();
        texts.join("\n")
    };
    for (arguments, expected) in [
        (&["--vary", "camera.view_angle=20,40.5", "--parts"][..], &["(a) θ = 20°", "(b) θ = 40.5°"][..]),
        (&["--vary", "camera.view_angle=20..60:3", "--lang", "pt-BR"], &["θ = 20°", "θ = 40°", "θ = 60°"]),
        (&["--vary", "camera.view_angle=40.5", "--lang", "pt-BR"], &["θ = 40,5°"]),
        (&["--vary", "style.visibility=painter,depth-buffer", "--view", "image"], &["painter", "depth buffer"]),
        (&["--vary", "style.visibility=painter,depth-buffer", "--lang", "pt-BR"], &["pintor", "z-buffer"]),
        (&["--vary", "camera.projection=perspective,parallel"], &["perspective", "parallel"]),
        (&["--vary", "camera.position=[3,4,5],[5,4,3]"], &["C = (3, 4, 5)", "C = (5, 4, 3)"]),
        (&["--vary", "azimuth=-30,0", "--parts"], &["(a) Azimuth −30°", "(b) Azimuth 0°"]),
        (&["--vary", "pan=[1,0],[0,-1]"], &["(1, 0)", "(0, −1)"]),
        (
            &["--show", "step={way=\"notes\"}", "--vary", "show.step.at=0,2", "--view", "canonical"],
            &["step 0", "step 2"],
        ),
        (&["--vary", "show.stage=clip,divide"], &["clip", "divide"]),
        (&["--vary", "zoom=1,2", "--parts", "--caption", "once", "--caption", ""], &["(a) once", "(b)"]),
        (
            &["--vary", "camera.projection=perspective,parallel", "--vary", "camera.near=1,2"],
            &["perspective, F = 1", "parallel, F = 2"],
        ),
    ] {
        let found = text(arguments).to_lowercase();
        for caption in expected {
            assert!(found.contains(&caption.to_lowercase()), "{arguments:?}: {caption} in {found}");
        }
    }
}

#[test]
fn impossible_variations_are_refused_by_key_value_and_range() {
    let bench = bench("families-refusals");
    let many = format!("azimuth={}", (0..65).map(|k| k.to_string()).collect::<Vec<_>>().join(","));
    for (arguments, parts) in [
        (&["--vary", "camera.view_angle=40,200"][..], &["camera.view_angle", "200", "180"][..]),
        (&["--vary", "style.visibility=painter,paint"], &["style.visibility", "\"paint\"", "\"painter\""]),
        (&["--vary", "style.visibilty=painter"], &["visibilty", "visibility"]),
        (&["--vary", "azimut=30"], &["azimut"]),
        (&["--vary", "azimuth=30,x"], &["azimuth", "x"]),
        (&["--vary", "zoom=0"], &["zoom", "0"]),
        (&["--vary", "camera.near=200"], &["camera.near", "200"]),
        (&["--vary", "camera.near="], &["allowed: KEY=VALUE"]),
        (&["--vary", "camera.near"], &["allowed: KEY=VALUE"]),
        (&["--vary", "camera.near=1..2"], &["1..2", "FROM..TO:COUNT"]),
        (&["--vary", "camera.near=1..2:99"], &["64"]),
        (&["--vary", &many], &["65", "64"]),
        (&["--vary", "azimuth=0..80:9", "--vary", "elevation=0..80:9"], &["81", "64"]),
        (&["--vary", "zoom=1,2", "--vary", "roll=0,9", "--vary", "yaw=0,9"], &["--vary", "3"]),
        (&[], &["--vary"]),
        (&["--vary", "zoom=1,2", "--columns", "0"], &["--columns", "1 to 64"]),
        (&["--vary", "zoom=1,2,3", "--columns", "2", "--view", "all"], &["3", "2", "divides"]),
        (&["--vary", "zoom=1,2", "--size", "20000x9"], &["16384"]),
        (&["--vary", "zoom=1,2", "--observer-of", "none.toml"], &["none.toml"]),
    ] {
        let run = bench.run(&[&["sheet", "figure.toml", "-o", "o.png"], arguments].concat());
        let said = run.refused(2);
        assert!(parts.iter().all(|part| said.contains(part)), "{arguments:?}: {said}");
    }
    assert_eq!(bench.names(), ["figure.toml"]);
}

#[test]
fn the_size_is_that_of_the_whole_sheet_and_every_format_carries_its_text() {
    let bench = bench("families-sizes");
    let vary = ["sheet", "figure.toml", "--vary", "camera.view_angle=20,40,60,90", "--parts"];
    bench.run(&[&vary[..], &["--size", "401x303", "--columns", "2", "-o", "a.png"]].concat()).done();
    let sheet = picture(&bench, "a.png");
    assert_eq!((sheet.width(), sheet.height()), (401, 303));
    bench.run(&[&vary[..], &["--width-cm", "16", "-o", "a.pdf"]].concat()).done();
    bench.run(&[&vary[..], &["--paper", "slide", "--columns", "2", "-o", "a.svg"]].concat()).done();
    assert!(read(&bench, "a.svg").contains("width=\"338.67mm\"") || read(&bench, "a.svg").contains("4000"));
    bench.run(&[&vary[..], &["--width-cm", "16", "-o", "a.tex"]].concat()).done();
    let latex = read(&bench, "a.tex");
    assert!(latex.contains("(a)") && latex.contains("(d)"), "{latex}");
    // Two of the three pictures, in one row each, and all of them.
    for (view, count) in [("world,image", 2), ("canonical,image", 2), ("all", 3)] {
        bench.run(&[&vary[..], &["--view", view, "-o", "v.png"]].concat()).done();
        let one = bench.run(&["render", "figure.toml", "--view", view, "-o", "r.png"]);
        one.done();
        assert_eq!(picture(&bench, "r.png").width(), count * 64 + (count - 1) * 4);
        assert!(picture(&bench, "v.png").height() > count * 360);
    }
    // The figure is in it.
    bench.run(&["inspect", "a.png"]).done();
    bench.run(&["inspect", "a.svg"]).done();
}

#[test]
fn an_animation_goes_through_a_family_or_to_another_camera() {
    let bench = bench("families-animations");
    let frames = |name: &str| {
        let reader = png::Decoder::new(std::io::Cursor::new(bench.read(name))).read_info().unwrap();
        reader.info().animation_control().unwrap().num_frames
    };
    let animate = |more: &[&str]| bench.run(&[&["animate", "figure.toml", "--size", "64x48"], more].concat());
    animate(&["--vary", "camera.view_angle=20..60", "--frames", "7", "-o", "a.apng"]).done();
    assert_eq!(frames("a.apng"), 7);
    animate(&["--vary", "style.visibility=painter,depth-buffer", "--view", "image", "-o", "b.apng"]).done();
    assert_eq!(frames("b.apng"), 2);
    bench.write("other.toml", "[camera]\nposition = [5, 4, -3]\nview_angle = 30\n[scene]\npreset = \"cube\"\n");
    animate(&["--to", "other.toml", "-o", "c.apng"]).done();
    assert_eq!(frames("c.apng"), 40);
    // The ends of the way are the two figures.
    animate(&["--to", "other.toml", "--view", "image", "--frames", "2", "-o", "ends.png"]).done();
    let ends = picture(&bench, "ends.png");
    for (k, name) in [(0, "figure.toml"), (1, "other.toml")] {
        let style = ["--view", "image", "--size", "64x48", "-o", "one.png"];
        bench.write("one.toml", bench.read(name));
        let text = read(&bench, "one.toml");
        let text = if text.contains("[style]") { text } else { text + "[style]\nantialias = 1\n" };
        bench.write("one.toml", text);
        bench.run(&[&["render", "one.toml"], &style[..]].concat()).done();
        assert!(part(&ends, [k * 68, 0], [64, 48]) == picture(&bench, "one.png").data(), "{name}");
    }
    // Three views side by side: the left part of each frame is the world alone.
    let vary = ["--vary", "azimuth=0,40"];
    animate(&[&vary[..], &["--view", "all", "-o", "three.apng"]].concat()).done();
    animate(&[&vary[..], &["--view", "world", "-o", "world.apng"]].concat()).done();
    assert_eq!(frames("three.apng"), 2);
    let three = picture(&bench, "three.apng");
    assert_eq!([three.width(), three.height()], [3 * 64 + 2 * 4, 48]);
    assert!(part(&three, [0, 0], [64, 48]) == picture(&bench, "world.apng").data());
    for (arguments, said) in [
        (&["--vary", "zoom=1..2", "--view", "all", "-o", "d.png"][..], "one view"),
        (&["--vary", "zoom=1..2", "--frames", "1", "-o", "d.gif"], "2 to 1200"),
        (&["--to", "none.toml", "-o", "d.gif"], "none.toml"),
        (&["--vary", "camera.view_angle=20..200", "-o", "d.gif"], "180"),
    ] {
        assert!(animate(arguments).refused(2).contains(said), "{arguments:?}");
        assert!(!bench.names().contains(&"d.gif".to_owned()));
    }
}

#[test]
fn an_animation_is_seen_by_the_observer_of_another_figure() {
    let bench = bench("families-film-observer");
    let film = ["animate", "figure.toml", "--vary", "azimuth=0,40", "--view", "world", "--size", "120x90"];
    bench.run(&[&film[..], &["--observer-of", "figure.toml", "-o", "film.png"]].concat()).done();
    let strip = picture(&bench, "film.png");
    let one = ["render", "figure.toml", "--op", "azimuth=40", "--view", "world", "--size", "120x90"];
    bench.run(&[&one[..], &["--observer-of", "figure.toml", "-o", "one.png"]].concat()).done();
    assert!(part(&strip, [strip.width() - 120, 0], [120, 90]) == picture(&bench, "one.png").data());
    bench.run(&[&film[..], &["-o", "own.png"]].concat()).done();
    assert!(picture(&bench, "own.png").data() != strip.data(), "one observer for all by default");
    // The steps have their own way of looking.
    let said = bench.run(&["animate", "figure.toml", "--observer-of", "figure.toml", "-o", "steps.png"]);
    assert!(said.refused(2).contains("--vary"), "{}", said.err);
}

#[test]
fn lists_are_split_between_values() {
    let values = |text: &str| Variation::parse(text, None).map(|variation| variation.values);
    assert_eq!(values("a.b=1, 2 ,3").unwrap(), ["1", "2", "3"]);
    assert_eq!(values("a=[1,2],[3,4]").unwrap(), ["[1,2]", "[3,4]"]);
    assert_eq!(values("a={x=1,y=2},\"b,c\"").unwrap(), ["{x=1,y=2}", "\"b,c\""]);
    assert_eq!(values("a=0..1:3").unwrap(), ["0", "0.5", "1"]);
    assert_eq!(values("a=1e-3..-1:2,7").unwrap(), ["0.001", "-1", "7"]);
    assert!(matches!(values("a=0..1:1"), Err(VariationError::Range { .. })));
    assert!(matches!(values("=1"), Err(VariationError::NoValues)));
    assert_eq!(Variation::parse("a=0..1", Some(3)).unwrap().values, ["0", "0.5", "1"]);
}
