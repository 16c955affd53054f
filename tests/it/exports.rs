//! Every stage that a picture shows, and every comparison, in every format: pixels, SVG and PDF show the same.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::export::format::PictureFormat;
use camera_lab::figure::read::parse;
use camera_lab::figure::words::STAGES;
use camera_lab::picture::{Faces, FileOptions, Renderer};
use camera_lab::views::{Request, View, Views};
use rayon::prelude::*;

use crate::common::program::Bench;
use crate::vectors::{SIZE, bench_with_fonts, drawn, has, printed, request, sheet, svg_of, written};

/// Two boxes, one before the other, a glass ball, and one out of sight. The window is oblique, and the near plane cuts.
const SCENE: &str = "[camera]\nposition = [0, 1.5, 6]\nnear = 3.4\nfar = 20\n[camera.window]\nleft = -1.2\nright = 1\n\
    bottom = -0.8\ntop = 0.8\n[[scene.objects]]\nname = \"close\"\nshape = \"box\"\ntranslate = [0, 0, 2]\n\
    scale = [0.5, 0.5, 0.5]\ncolor = \"#cc2222\"\n[[scene.objects]]\nname = \"wide\"\nshape = \"box\"\n\
    scale = [2, 1, 0.3]\ncolor = \"#2244cc\"\n[[scene.objects]]\nname = \"glass\"\nshape = \"sphere\"\n\
    translate = [1.2, 0.8, 1.5]\nscale = [0.6, 0.6, 0.6]\ncolor = \"#22884480\"\nsegments = 16\n\
    [[scene.objects]]\nname = \"lost\"\nshape = \"box\"\ntranslate = [40, 0, 0]\n\
    [[scene.objects]]\nname = \"written\"\nshape = \"box\"\ntranslate = [-1.6, 0.9, 1]\nscale = [0.5, 0.5, 0.5]\n\
    texture = \"letters\"\n[[scene.lights]]\nkind = \"directional\"\nshadows = true\ndirection = [-1, -2, -1.5]\n";

/// The same without the options that make the faces of a page one picture.
fn plain(text: &str) -> String {
    text.replace("shadows = true\n", "").replace("texture = \"letters\"\n", "")
}

/// The formats in which a figure is not the picture that its pixels are. `faces`: how those of a page are written.
fn differing(text: &str, view: View, faces: Faces, bench: &Bench) -> Vec<String> {
    let figure = parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let sheet = sheet(&figure, Views::One(view), &request(&figure, SIZE));
    let pixels = Renderer::default().pixels(&sheet.requests[0]).unwrap();
    let options = |format| FileOptions { faces, ..FileOptions::of(format) };
    let mut pages = Vec::new();
    let svg = svg_of(&sheet, options(PictureFormat::Svg), &figure);
    pages.extend(drawn(&svg, 1.0, bench).map(|page| ("SVG", page)));
    if has("pdftoppm") {
        let pdf = written(&sheet, options(PictureFormat::Pdf), &figure, "").bytes;
        pages.push(("PDF", printed(&pdf, &format!("{:p}", pdf.as_ptr()), bench)));
    }
    let differences = pages.into_iter().filter_map(|(format, page)| {
        let different = unlike(pixels.rgba(), page.data()).max(unlike(page.data(), pixels.rgba()));
        // At ends of dashes, in letters, and along the wiper, which Poppler puts on whole pixels.
        let allowed = if format == "SVG" { 100 } else { 1000 };
        (different > allowed).then(|| format!("{view:?} {format} {different}"))
    });
    differences.collect()
}

/// The number of pixels that nothing within a pixel of their place in another picture is like: programs draw edges, and
/// the pixels of pictures in a page, a little otherwise.
fn unlike(one: &[u8], other: &[u8]) -> usize {
    let (one, other) = (one.as_chunks::<4>().0, other.as_chunks::<4>().0);
    let (width, height) = (SIZE.width as usize, SIZE.height as usize);
    let is_like = |[x, y]: [usize; 2], at: [usize; 2]| {
        let (a, b) = (one[y * width + x], other[at[1] * width + at[0]]);
        a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 64)
    };
    let around = |v: usize, end: usize| v.saturating_sub(1)..(v + 2).min(end);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
    let has_like =
        |[x, y]: [usize; 2]| around(y, height).any(|row| around(x, width).any(|column| is_like([x, y], [column, row])));
    places.filter(|place| !has_like(*place)).count()
}

/// All of these figures, each in a view, in which a format differs.
fn all_differing(name: &str, cases: Vec<(String, View, Faces)>) -> Vec<String> {
    let bench = bench_with_fonts(name);
    let shown = |text: &str| text.strip_prefix(SCENE).unwrap_or(text).replace('\n', " ");
    let named = |(text, view, faces): (String, View, Faces)| {
        let found = differing(&text, view, faces, &bench);
        found.into_iter().map(|found| format!("{} {}: {found}", shown(&text), faces.name())).collect::<Vec<_>>()
    };
    cases.into_par_iter().flat_map_iter(named).collect()
}

#[test]
fn every_stage_is_shown_alike_in_every_format() {
    let shown = |stage: &str, more: &str| format!("{SCENE}{more}[show]\nstage = \"{stage}\"\n");
    let mut cases = Vec::new();
    for (stage, _) in STAGES {
        cases.push((plain(&shown(stage, "")), View::Image, Faces::Areas));
    }
    for stage in ["light", "fill", "interpolate", "texture", "shadow", "write"] {
        cases.push((shown(stage, ""), View::Image, Faces::Auto));
    }
    for stage in ["clip", "cull-faces", "hidden-surfaces", "blend"] {
        for visibility in ["painter", "bsp"] {
            let text = shown(stage, &format!("[style]\nvisibility = \"{visibility}\"\n"));
            cases.push((plain(&text), View::Image, Faces::Auto));
        }
        for view in [View::World, View::Canonical] {
            let text = format!("{}stage_of = \"{}\"\n", shown(stage, ""), view.name());
            cases.push((text, view, Faces::Auto));
        }
    }
    let differing = all_differing("exports-stages", cases);
    assert!(differing.is_empty(), "{differing:#?}");
}

#[test]
fn every_comparison_is_shown_alike_in_every_format() {
    let kinds = [
        "with = { \"style.visibility\" = \"painter\" }",
        "with = { \"style.hidden_lines\" = \"hidden\" }",
        "with = { \"style.hidden_lines\" = \"shown\" }",
        "with = { \"style.shading\" = \"gouraud\" }",
        "with = { \"style.shading\" = \"wireframe\" }",
        "with = { \"style.antialias\" = 1 }",
        "with = { \"style.depth_format\" = \"fixed-16\" }",
        "with = { \"camera.projection\" = \"parallel\" }",
        "with = { \"reveal.depth\" = \"linear\" }",
        "with = { \"reveal.outside\" = \"tinted\" }",
        "with = { \"reveal.texture\" = \"levels\" }",
        "with = { \"reveal.shadows\" = \"acne\" }",
        "with = { \"show.stage\" = \"cull-faces\" }",
        "with = { \"show.stage\" = \"hidden-surfaces\" }",
        "with = { \"show.painted\" = 0.5 }",
        "ops = [\"azimuth=20\"]",
    ];
    let layouts = ["", "differences = true\nlayout = \"beside\"\n"];
    let cases = kinds.iter().flat_map(|kind| layouts.map(|layout| (kind, layout))).map(|(kind, layout)| {
        let text = format!("{SCENE}[compare]\n{kind}\n{layout}");
        let is_plain = !["texture", "shadows"].into_iter().any(|word| kind.contains(word));
        (if is_plain { plain(&text) } else { text }, View::Image, Faces::Auto)
    });
    let differing = all_differing("exports-compared", cases.collect());
    assert!(differing.is_empty(), "{differing:#?}");
}

#[test]
fn the_share_of_differing_pixels_is_that_of_the_pixels() {
    let text = format!("{SCENE}[compare]\nwith = {{ \"style.shading\" = \"gouraud\" }}\ndifferences = true\n");
    let figure = parse(&text).unwrap();
    let sheet = sheet(&figure, Views::One(View::Image), &request(&figure, SIZE));
    let mut picture = Default::default();
    let report = camera_lab::progress::at_once(Renderer::default().pixels_into(&sheet.requests[0], &mut picture));
    let differ = report.unwrap().labels.into_iter().find(|label| label.name == "differ").unwrap().text;
    let svg = svg_of(&sheet, FileOptions::of(PictureFormat::Svg), &figure);
    assert!(differ.ends_with('%') && svg.contains(&differ), "{differ}");
}

#[test]
fn forced_stages_change_no_byte_of_any_format() {
    // A texture of one colour, and a figure so small that the window of the world is a pixel.
    let small = "[camera]\nposition = [0, 0, 8]\nnear = 1e-6\nfar = 20\nprojection = \"parallel\"\n[camera.window]\n\
        left = 1000\nright = 1001\nbottom = -0.375\ntop = 0.375\n[[scene.objects]]\nname = \"box\"\nshape = \"box\"\n\
        translate = [8003, 0, 0]\n";
    let show = |stage: &str| format!("[show]\nstage = \"{stage}\"\n");
    let inside = SCENE.replace("translate = [40, 0, 0]", "translate = [1, 0, 0]");
    let shown = STAGES.iter().map(|(stage, _)| format!("{}{}", plain(&inside), show(stage)));
    let shown: Vec<String> =
        shown.chain(["cull-objects", "texture"].map(|stage| format!("{SCENE}{}", show(stage)))).collect();
    let changed: Vec<String> = shown
        .par_iter()
        .map(|text| (text, View::Image))
        .chain([(&small.to_owned(), View::World), (&small.to_owned(), View::Image)])
        .filter_map(|(text, view)| {
            let figure = parse(text).unwrap();
            let planned = sheet(&figure, Views::One(view), &request(&figure, SIZE));
            let mut forced = planned.clone();
            forced.requests = vec![Request { force_all_stages: true, ..planned.requests[0].clone() }];
            let written =
                |format| [&planned, &forced].map(|sheet| written(sheet, FileOptions::of(format), &figure, ""));
            let same = [PictureFormat::Png, PictureFormat::Svg].into_iter().all(|format| {
                let [one, other] = written(format);
                one.bytes == other.bytes
            });
            (!same).then(|| format!("{view:?} {text}"))
        })
        .collect();
    assert!(changed.is_empty(), "{changed:#?}");
}
