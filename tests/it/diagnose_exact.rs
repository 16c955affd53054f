//! `diagnose` against exact visibility: wrong pixels are findings, and their repairs leave none.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab_words::Lang;
use camera_lab_words::window::coach;
use serde_json::Value;

use crate::common::program::Bench;

/// Three bars, each over one and under another.
fn cycle(style: &str) -> String {
    let bar = |name: &str, color: &str, at: &str, turn: u32| {
        format!(
            "[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\ncolor = \"{color}\"\ntranslate = {at}\nrotate = [0, 12, {turn}]\nscale = [2.2, 0.4, 0.1]\n"
        )
    };
    format!(
        "[camera]\nposition = [0, 0, 6]\nfocal_point = [0, 0, 0]\nview_angle = 35\nnear = 2\nfar = 12\n[image]\nwidth = 160\nheight = 120\n[style]\n{style}\n{}{}{}",
        bar("a", "#4477aa", "[0, -0.5, 0]", 0),
        bar("b", "#ee8866", "[0.433, 0.25, 0]", 120),
        bar("c", "#228833", "[-0.433, 0.25, 0]", 240),
    )
}

/// Two sheets that lie closely on each other, seen from far away.
fn sheets(format: &str, planes: &str) -> String {
    let sheet = |name: &str, color: &str, at: &str| {
        format!(
            "[[scene.objects]]\nname = \"{name}\"\nshape = \"box\"\ncolor = \"{color}\"\ntranslate = {at}\nscale = [9, 9, 0.0005]\n"
        )
    };
    format!(
        "[camera]\nposition = [0, -30, 40]\nfocal_point = [0, 0, 0]\n{planes}\n[image]\nwidth = 160\nheight = 120\n[style]\ndepth_format = \"{format}\"\n{}{}",
        sheet("lower", "#cc2222", "[0, 0, 0]"),
        sheet("upper", "#cccc22", "[2, 0, 0.0015]"),
    )
}

fn diagnosed(bench: &Bench, figure: &str) -> Value {
    bench.run(&["diagnose", figure, "--format", "json"]).json()
}

/// The codes of the findings, and the shares of wrong pixels.
fn codes(answer: &Value) -> Vec<(String, Option<f64>)> {
    let findings = answer["findings"].as_array().unwrap().iter();
    findings.map(|f| (f["code"].as_str().unwrap().to_owned(), f["wrong_share"].as_f64())).collect()
}

/// Has one finding with this code, whose repair leaves none.
#[track_caller]
fn is_found_and_repaired(bench: &Bench, text: &str, code: &str, share: std::ops::Range<f64>) -> Value {
    bench.write("f.toml", text);
    let answer = diagnosed(bench, "f.toml");
    let found = codes(&answer);
    let [(found_code, Some(found_share))] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!(found_code, code);
    assert!(share.contains(found_share), "{found_share}");
    bench.run(&["diagnose", "f.toml", "--repair", "-o", "g.toml"]).done();
    let after = diagnosed(bench, "g.toml");
    assert_eq!(codes(&after), [], "{}", String::from_utf8(bench.read("g.toml")).unwrap());
    answer
}

/// A ball far to the right, seen from nearby.
fn far_ball(style: &str, at: f64) -> String {
    format!(
        "[camera]\nposition = [{}, 2, 6]\nfocal_point = [{at}, 0, 0]\n[image]\nwidth = 160\nheight = 120\n[style]\n{style}\n[[scene.objects]]\nname = \"ball\"\nshape = \"sphere\"\ntranslate = [{at}, 0, 0]\n",
        at + 1.0
    )
}

#[test]
fn vertices_of_other_machines_are_a_finding() {
    let bench = Bench::new("diagnose-vertices");
    for (style, at, share) in [
        ("vertex_format = \"f32\"", 1e6, 0.01..0.9),
        ("vertex_format = \"f16\"", 300.0, 0.01..0.9),
        ("vertex_format = \"bf16\"", 3.0, 0.01..0.9),
        ("subpixel_bits = 4", 0.0, 1e-4..0.05),
    ] {
        let answer = is_found_and_repaired(&bench, &far_ball(style, at), "vertex-rounding", share);
        let key = style.split(' ').next().unwrap();
        let repaired: Vec<&String> = answer["findings"][0]["repair"].as_object().unwrap().keys().collect();
        assert_eq!(repaired, [key]);
        assert_eq!(answer["findings"][0]["infinite_faces"], 0);
    }
    // In f16 all vertices are infinite there: every face is left out, and every pixel of the ball is wrong.
    bench.write("f.toml", far_ball("vertex_format = \"f16\"", 1e5));
    let answer = diagnosed(&bench, "f.toml");
    assert_eq!(codes(&answer), [("vertex-rounding".to_owned(), Some(1.0))]);
    assert!(answer["findings"][0]["infinite_faces"].as_u64().unwrap() > 100, "{answer}");
    // Nothing is wrong in the formats that are enough.
    for style in ["vertex_format = \"f64\"", "subpixel_bits = 8"] {
        bench.write("f.toml", far_ball(style, 0.0));
        assert_eq!(codes(&diagnosed(&bench, "f.toml")), [], "{style}");
    }
}

#[test]
fn an_order_of_painting_that_is_wrong_is_a_finding() {
    let bench = Bench::new("diagnose-order");
    let answer = is_found_and_repaired(&bench, &cycle("visibility = \"painter\""), "wrong-order", 0.03..0.2);
    assert_eq!(answer["findings"][0]["repair"], serde_json::json!({ "visibility": "depth-buffer" }));
    for visibility in ["depth-buffer", "bsp"] {
        bench.write("f.toml", cycle(&format!("visibility = \"{visibility}\"")));
        assert_eq!(codes(&diagnosed(&bench, "f.toml")), [], "{visibility}");
    }
    // Bars of the same colour can't be distinguished.
    bench.write("f.toml", cycle("visibility = \"painter\"\nshading = \"wireframe\""));
    assert_eq!(codes(&diagnosed(&bench, "f.toml")), []);
}

#[test]
fn translucent_faces_in_the_wrong_order_are_a_finding() {
    let bench = Bench::new("diagnose-layers");
    let glass = |style: &str| cycle(style).replace("#4477aa", "#4477aa80").replace("#ee8866", "#ee886680");
    let answer = is_found_and_repaired(&bench, &glass(""), "wrong-order", 0.005..0.3);
    assert_eq!(answer["findings"][0]["repair"]["visibility"], "bsp");
}

#[test]
fn depths_that_the_format_confuses_are_a_finding() {
    let bench = Bench::new("diagnose-depths");
    let deep = "near = 0.001\nfar = 100000";
    is_found_and_repaired(&bench, &sheets("fixed-24", deep), "depth-conflict", 0.2..0.9);
    is_found_and_repaired(&bench, &sheets("fixed-16", "near = 10\nfar = 200"), "depth-conflict", 0.2..0.9);
    for (format, planes) in [("f32-reversed", deep), ("fixed-24", "near = 20\nfar = 100")] {
        bench.write("f.toml", sheets(format, planes));
        assert_eq!(codes(&diagnosed(&bench, "f.toml")), [], "{format}");
    }
}

#[test]
fn shadows_and_textures_that_are_wrong_are_findings() {
    let bench = Bench::new("diagnose-shadows");
    let shipped = |name: &str| {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/figures/pipeline").join(name);
        std::fs::read_to_string(path).unwrap()
    };
    is_found_and_repaired(&bench, &shipped("shadow-acne.toml"), "shadow-acne", 0.3..0.6);
    is_found_and_repaired(&bench, &shipped("shadow-detached.toml"), "shadow-detached", 0.001..0.01);
    bench.write("f.toml", shipped("shadow-light.toml"));
    assert_eq!(codes(&diagnosed(&bench, "f.toml")), []);
    let affine = shipped("texture-affine.toml");
    let own = affine.replace("[compare]\nwith = { \"reveal.texture\" = \"affine\" }", "[reveal]\ntexture = \"affine\"");
    let answer = is_found_and_repaired(&bench, &own, "affine-texture", 0.2..0.9);
    assert_eq!(answer["findings"][0]["repair"], serde_json::json!({ "reveal.texture": null }));
    // On the other side of a comparison, no key of the figure repairs it.
    bench.write("f.toml", affine);
    let other = diagnosed(&bench, "f.toml");
    assert_eq!(codes(&other).len(), 1);
    assert!(other["findings"][0]["repair"].is_null());
    let message = other["findings"][0]["message"].as_str().unwrap();
    assert!(message.starts_with(coach::texts(Lang::En).on_the_other_side), "{message}");
}

#[test]
fn an_impossible_camera_is_a_finding_with_a_repair() {
    let bench = Bench::new("diagnose-camera");
    for (camera, code, key) in [
        ("position = [0, 55, 0]\nfocal_point = [0, -5, 0]", "view-up-along-view", "view_up"),
        ("view_up = [0, 0, 0]", "view-up-along-view", "view_up"),
        ("position = [1, 2, 3]\nfocal_point = [1, 2, 3]", "focal-point-at-position", "focal_point"),
        ("near = 100\nfar = 0.1", "near-beyond-far", "near"),
        ("near = -1", "near-beyond-far", "near"),
        ("far = inf", "near-beyond-far", "far"),
        ("view_angle = 180", "view-angle-range", "view_angle"),
        ("view_angle = -10", "view-angle-range", "view_angle"),
        ("window = { left = 1, right = -1, bottom = -1, top = 1 }", "camera-value", "window"),
        ("projection = \"parallel\"\nheight = 0", "camera-value", "height"),
    ] {
        bench.write("f.toml", format!("# Mine.\n[camera]\n{camera}\n[image]\nwidth = 80\nheight = 60\n"));
        let answer = diagnosed(&bench, "f.toml");
        assert_eq!(codes(&answer), [(code.to_owned(), None)], "{camera}");
        assert_eq!((answer["visible"].as_u64(), answer["health"].as_array().unwrap().len()), (Some(0), 0));
        assert!(!answer["findings"][0]["repair"][key].is_null(), "{camera}: {answer}");
        bench.run(&["diagnose", "f.toml", "--repair", "-o", "g.toml"]).done();
        assert!(String::from_utf8(bench.read("g.toml")).unwrap().starts_with("# Mine.\n"));
        assert!(diagnosed(&bench, "g.toml")["visible"].as_u64().unwrap() > 0, "{camera}");
        // Other commands keep refusing.
        for command in ["inspect", "explain"] {
            bench.run(&[command, "f.toml"]).refused(2);
        }
        bench.run(&["diagnose", "f.toml", "--op", "azimuth=10"]).refused(2);
    }
}

#[test]
fn a_refused_camera_names_the_convention_that_allows_it() {
    let bench = Bench::new("diagnose-way-out");
    for lang in ["en", "pt-BR"] {
        for (camera, way) in [("far = inf", "-infinite"), ("near = 100\nfar = 0.1", "-reversed")] {
            bench.write("f.toml", format!("[camera]\n{camera}\n"));
            let refused = bench.run(&["inspect", "f.toml", "--lang", lang]);
            assert!(refused.status == Some(2) && refused.err.contains(way), "{}", refused.err);
            assert!(refused.err.contains("f.toml") && refused.err.contains("[camera]"), "{}", refused.err);
        }
    }
}

#[test]
fn an_angle_in_radians_is_read_and_one_without_quotes_is_explained() {
    let bench = Bench::new("figure-radians");
    bench.write("f.toml", "[camera]\nview_angle = \"0.9 rad\"\n");
    let angle = bench.run(&["inspect", "f.toml", "--op", "azimuth=0.9 rad", "--format", "json"]).json();
    assert!((angle["camera"]["view_angle"].as_f64().unwrap() - 0.9_f64.to_degrees()).abs() < 1e-12);
    for (value, lang) in [("0.9 rad", "en"), ("45°", "pt-BR"), ("1/3  # a third", "en")] {
        bench.write("f.toml", format!("[camera]\nview_angle = {value}\n"));
        let refused = bench.run(&["inspect", "f.toml", "--lang", lang]);
        let quoted = format!("\"{}\"", value.split('#').next().unwrap().trim());
        assert!(refused.status == Some(2) && refused.err.contains(&quoted), "{}", refused.err);
        assert!(refused.err.contains("line 2") || refused.err.contains("linha 2"), "{}", refused.err);
    }
}

#[test]
fn the_resolution_of_depths_is_that_of_the_figure() {
    let bench = Bench::new("diagnose-resolution");
    for (format, steps) in [("fixed-16", 65536.0), ("fixed-24", 16_777_216.0), ("f32-reversed", 16_777_216.0)] {
        let camera = "projection = \"parallel\"\nheight = 20\nnear = 1\nfar = 1000";
        bench.write(
            "f.toml",
            format!("[camera]\n{camera}\n[image]\nwidth = 80\nheight = 60\n[style]\ndepth_format = \"{format}\"\n"),
        );
        let answer = diagnosed(&bench, "f.toml");
        let line = &answer["health"][2];
        assert_eq!(line["code"], "depth-resolution");
        let value = line["value"].as_f64().unwrap();
        assert!((value * steps / 999.0 - 1.0).abs() < 1e-12, "{format}: {value}");
    }
}

#[test]
fn an_image_that_was_not_compared_is_not_called_right() {
    let bench = Bench::new("diagnose-not-compared");
    bench.write("f.toml", "[image]\nwidth = 3000\nheight = 2000\n");
    assert_eq!(codes(&diagnosed(&bench, "f.toml")), [("not-compared".to_owned(), None)]);
}
