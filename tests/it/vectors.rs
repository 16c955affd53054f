//! Pictures as SVG, PDF and LaTeX, compared with the pixels of the same figure by librsvg, Poppler and pdfTeX, if they
//! are installed.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use camera_lab::appearance::{Shading, Theme};
use camera_lab::camera::Camera;
use camera_lab::export::format::PictureFormat;
use camera_lab::export::vector::Letters;
use camera_lab::figure::read::parse;
use camera_lab::figure::{Figure, update};
use camera_lab::picture::{Composite, Faces, FileOptions, Metadata, PictureFile, Renderer, file};
use camera_lab::progress::{Progress, at_once};
use camera_lab::views::{Finish, Request, SharedScene, Shot, Size, View, Views, scene_of};
use camera_lab_files::{FigureFiles, FileAccess, SHIPPED_FIGURES, figure_from};
use camera_lab_words::{Lang, pictures};
use rayon::prelude::*;
use tiny_skia::Pixmap;

use crate::common::program::Bench;

pub(crate) const SIZE: Size = Size { width: 320, height: 240, scale: 1.0 };

pub(crate) fn request(figure: &Figure, size: Size) -> Request {
    let camera = Camera::new(&figure.camera).unwrap();
    let mut files = FigureFiles::new(Path::new("."), FileAccess::Figure);
    let scene = scene_of(figure, &mut |wanted| files.read(wanted), &Progress::default()).unwrap();
    let scene = SharedScene::new(scene);
    Request::of(figure, View::Image, &camera, &scene, pictures::labels(Lang::En), size)
}

pub(crate) fn sheet(figure: &Figure, what: Views, request: &Request) -> Composite {
    Composite::of(what, request, &Shot::of(figure), None).unwrap()
}

pub(crate) fn written(sheet: &Composite, options: FileOptions, figure: &Figure, text: &str) -> PictureFile {
    let told = pictures::told_of(Lang::En, figure, sheet, text.to_owned());
    at_once(file(sheet, options, &told, &Progress::default())).unwrap()
}

pub(crate) fn svg_of(sheet: &Composite, options: FileOptions, figure: &Figure) -> String {
    String::from_utf8(written(sheet, options, figure, "").bytes).unwrap()
}

/// Whether a program is there. The checks on a bare machine install it.
pub(crate) fn has(program: &str) -> bool {
    let found = Command::new(program).arg("--version").output().is_ok();
    assert!(found || std::env::var_os("CAMERA_LAB_ALL_TOOLS").is_none(), "{program} is not installed");
    found
}

/// The SVG as pixels, `zoom` times as large as the picture. `None` without the program for it.
pub(crate) fn drawn(svg: &str, zoom: f64, bench: &Bench) -> Option<Pixmap> {
    let (from, to) = (format!("{:p}.svg", svg.as_ptr()), format!("{:p}.png", svg.as_ptr()));
    if !has("rsvg-convert") {
        return None;
    }
    let from = bench.write(&from, svg);
    let mut run = Command::new("rsvg-convert");
    run.args(["-z", &zoom.to_string(), "-o"])
        .arg(bench.path(&to))
        .arg(from)
        .env("FONTCONFIG_FILE", bench.path("fonts.conf"));
    assert!(run.status().unwrap().success());
    Some(read(&bench.read(&to)))
}

/// The first page of a PDF as pixels, one for each of the picture. `name`: of its files.
pub(crate) fn printed(pdf: &[u8], name: &str, bench: &Bench) -> Pixmap {
    let path = bench.write(&format!("{name}.pdf"), pdf);
    let mut run = Command::new("pdftoppm");
    run.args(["-r", "96", "-png", "-singlefile"]).arg(path).arg(bench.path(name));
    assert!(run.status().unwrap().success());
    read(&bench.read(&format!("{name}.png")))
}

/// A PNG as premultiplied pixels.
pub(crate) fn read(bytes: &[u8]) -> Pixmap {
    let image = image::load_from_memory(bytes).unwrap().into_rgba8();
    let mut pixmap = Pixmap::new(image.width(), image.height()).unwrap();
    for (to, from) in pixmap.pixels_mut().iter_mut().zip(image.pixels()) {
        let [r, g, b, a] = from.0;
        *to = tiny_skia::ColorU8::from_rgba(r, g, b, a).premultiply();
    }
    pixmap
}

/// A folder with a configuration of fonts that has the program's alone: a bare machine has none.
pub(crate) fn bench_with_fonts(name: &str) -> Bench {
    let bench = Bench::new(name);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/engine/fonts");
    let cache = bench.path("fonts");
    let text = format!(
        "<?xml version=\"1.0\"?><fontconfig><dir>{}</dir><cachedir>{}</cachedir></fontconfig>",
        folder.display(),
        cache.display()
    );
    bench.write("fonts.conf", text);
    bench
}

/// The mean difference of a channel, and the share of pixels of which a channel differs by more than a quarter.
fn difference(one: &[u8], other: &[u8]) -> (f64, f64) {
    assert_eq!(one.len(), other.len());
    let sum: u64 = one.iter().zip(other).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    let pixels = || one.as_chunks::<4>().0.iter().zip(other.as_chunks::<4>().0);
    let far = pixels().filter(|(a, b)| a.iter().zip(b.iter()).any(|(a, b)| a.abs_diff(*b) > 64)).count();
    (sum as f64 / one.len() as f64, far as f64 / pixels().count() as f64)
}

#[test]
fn vectors_agree_with_pixels_in_every_shipped_figure_view_and_theme() {
    let bench = bench_with_fonts("vectors-shipped");
    let jobs: Vec<_> = SHIPPED_FIGURES.iter().flat_map(|figure| View::ALL.map(|view| (figure, view))).collect();
    let worst: Vec<String> = jobs
        .into_par_iter()
        .flat_map_iter(|(shipped, view)| {
            let mut figure = parse(&shipped.text()).unwrap();
            let bench = &bench;
            [Theme::Light, Theme::Dark, Theme::Print].into_iter().filter_map(move |theme| {
                figure.style.theme = theme;
                let sheet = sheet(&figure, Views::One(view), &request(&figure, SIZE));
                let pixels = Renderer::default().pixels(&sheet.requests[0]).unwrap();
                let svg = svg_of(&sheet, FileOptions::of(PictureFormat::Svg), &figure);
                let (mean, far) = difference(pixels.rgba(), drawn(&svg, 1.0, bench)?.data());
                (mean > 2.0 || far > 0.012).then(|| format!("{} {view:?} {theme:?}: {mean:.2} {far:.4}", shipped.name))
            })
        })
        .collect();
    assert!(worst.is_empty(), "{worst:#?}");
}

#[test]
fn poppler_agrees_with_the_pixels_and_finds_every_name() {
    if !has("pdftoppm") || !has("pdftotext") {
        return;
    }
    let bench = Bench::new("vectors-poppler");
    for name in ["primitives", "pyramid", "ndc-cube", "exercise-5.3", "painter", "clipping", "gouraud", "culled"] {
        let shipped = camera_lab_files::ShippedFigure::named(name).unwrap();
        let figure = parse(&shipped.text()).unwrap();
        for view in View::ALL {
            let sheet = sheet(&figure, Views::One(view), &request(&figure, SIZE));
            let pdf = written(&sheet, FileOptions::of(PictureFormat::Pdf), &figure, "");
            let path = bench.write("a.pdf", &pdf.bytes);
            let picture = printed(&pdf.bytes, "b", &bench);
            let pixels = Renderer::default().pixels(&sheet.requests[0]).unwrap();
            let (mean, far) = difference(pixels.rgba(), picture.data());
            assert!(mean < 3.0 && far < 0.02, "{name} {view:?}: {mean:.2} {far:.4}");
            let words = Command::new("pdftotext").args(["-layout"]).arg(&path).arg("-").output().unwrap();
            let words = String::from_utf8(words.stdout).unwrap();
            let found: String = words.split_whitespace().collect();
            let frame = Renderer::default().drawing(&sheet.requests[0]).unwrap();
            for label in &frame.drawing.labels {
                for run in camera_lab::text::runs(&label.text) {
                    let wanted: String = run.text.split_whitespace().collect();
                    assert!(found.contains(&wanted), "{name} {view:?}: {wanted} in {words}");
                }
            }
        }
    }
}

/// The texts of an SVG file, without their marks.
fn texts(svg: &str) -> BTreeSet<String> {
    let inner = |text: &str| -> String {
        text.split('<').map(|part| part.split_once('>').map_or(part, |(_, words)| words)).collect()
    };
    let elements = svg.split("<text").skip(1).filter_map(|rest| rest.split_once('>')?.1.split_once("</text>"));
    elements.map(|(text, _)| inner(text).replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")).collect()
}

#[test]
fn every_name_is_a_text_that_can_be_searched() {
    for shipped in SHIPPED_FIGURES.iter().take(12) {
        let figure = parse(&shipped.text()).unwrap();
        let sheet = sheet(&figure, Views::One(View::World), &request(&figure, SIZE));
        let svg = svg_of(&sheet, FileOptions::of(PictureFormat::Svg), &figure);
        let texts = texts(&svg);
        let frame = Renderer::default().drawing(&sheet.requests[0]).unwrap();
        for label in &frame.drawing.labels {
            let plain: String = camera_lab::text::runs(&label.text).iter().map(|run| run.text).collect();
            assert!(texts.contains(&plain), "{}: {plain} in {texts:?}", shipped.name);
        }
        let outlines = FileOptions { letters: Letters::Outlines, ..FileOptions::of(PictureFormat::Svg) };
        assert!(!svg_of(&sheet, outlines, &figure).contains("<text"), "{}", shipped.name);
    }
}

/// Inkscape and librsvg drop a space at the beginning of a run that has a place of its own.
#[test]
fn the_space_after_a_subscript_is_kept() {
    let figure = parse("[scene]\npreset = \"cube\"\n").unwrap();
    let sheet = sheet(&figure, Views::One(View::Canonical), &request(&figure, SIZE));
    let svg = svg_of(&sheet, FileOptions::of(PictureFormat::Svg), &figure);
    let mut with_space = 0;
    for text in svg.split("<text").skip(1).filter_map(|rest| rest.split_once("</text>")) {
        let (text, _) = text;
        let has_space = text.split("<tspan").skip(2).any(|run| run.contains("> "));
        with_space += usize::from(has_space);
        assert_eq!(has_space, text.starts_with(" xml:space=\"preserve\""), "{text}");
    }
    assert!(with_space >= 2, "near (z_n = −1) and far (z_n = 1)");
}

#[test]
fn browsers_get_the_letters_of_every_text() {
    let text = "[scene]\npreset = \"house\"\n[labels]\nletters = \"mathematics\"\n[[labels.renamed]]\nname = \"C\"\ntext = 'eye ≠ $\\mathbf{e}_0$'\n";
    let figure = parse(text).unwrap();
    let sheet = sheet(&figure, Views::One(View::World), &request(&figure, SIZE));
    let svg = svg_of(&sheet, FileOptions::of(PictureFormat::Svg), &figure);
    let ranges: Vec<&str> = svg.split("unicode-range:").skip(1).filter_map(|rest| rest.split(';').next()).collect();
    // The sign that the letters of mathematics lack, their upright, bold and italic ones.
    assert_eq!(ranges.len(), 4, "{ranges:?}");
    let embedded: BTreeSet<String> = ranges.iter().flat_map(|range| range.split(',')).map(str::to_owned).collect();
    let used: BTreeSet<String> =
        texts(&svg).iter().flat_map(|text| text.chars()).map(|c| format!("U+{:X}", u32::from(c))).collect();
    assert_eq!(used, embedded);
    let outlines = FileOptions { letters: Letters::Outlines, ..FileOptions::of(PictureFormat::Svg) };
    assert!(!svg_of(&sheet, outlines, &figure).contains("@font-face"));
}

#[test]
fn the_image_on_the_window_is_a_picture_among_areas() {
    let mut figure = parse("[scene]\npreset = \"house\"\n").unwrap();
    let images = |figure: &Figure| -> Vec<f64> {
        let sheet = sheet(figure, Views::One(View::World), &request(figure, SIZE));
        let svg = svg_of(&sheet, FileOptions::of(PictureFormat::Svg), figure);
        let widths = svg.split("<image ").skip(1).filter_map(|rest| rest.split("width=\"").nth(1)?.split('"').next());
        widths.map(|width| width.parse().unwrap()).collect()
    };
    let widths = images(&figure);
    assert!(matches!(widths.as_slice(), [width] if *width < 60.0), "{widths:?}");
    // Colours that vary over the faces of the scene are one picture of it all.
    figure.style.shading = Shading::Gouraud;
    let widths = images(&figure);
    assert!(matches!(widths.as_slice(), [width] if *width > 100.0), "{widths:?}");
}

#[test]
fn the_same_figure_gives_the_same_bytes_and_comes_back_from_them() {
    let text = "# mine\ntitle = { en = \"A & <B>\", pt-BR = \"C\" }\n[scene]\npreset = \"house\"\n";
    let figure = parse(text).unwrap();
    let sheet = sheet(&figure, Views::All, &request(&figure, SIZE));
    for format in [PictureFormat::Svg, PictureFormat::Pdf] {
        let make = || written(&sheet, FileOptions::of(format), &figure, &update(text, &figure)).bytes;
        let bytes = make();
        assert_eq!(bytes, make());
        let opened = figure_from(&bytes).unwrap();
        assert!(opened.from_picture && opened.text.starts_with("# mine"), "{}", opened.text);
        assert_eq!(opened.figure, figure);
        // Without a figure, or cut anywhere: a message and no panic.
        let none = written(&sheet, FileOptions::of(format), &figure, "").bytes;
        let refused = figure_from(&none).unwrap_err().to_string();
        assert!(refused.contains("contains no figure"), "{refused}");
        for end in (0..bytes.len()).step_by(bytes.len() / 97) {
            let _ = figure_from(&bytes[..end]);
        }
    }
}

/// Names that hold characters XML doesn't allow, in every place an SVG writes a name.
#[test]
fn an_svg_is_well_formed_whatever_names_are() {
    for name in ["a]]>b", "a\u{ffff}b", "a\u{fffe}b", "<&>\"'", "]]&gt;<!--", "a\u{1f}b", "\u{10ffff}"] {
        let quoted = toml_edit::Value::from(name).to_string();
        let quoted = quoted.trim();
        let text = format!(
            "title = {quoted}\ncaption = {quoted}\n[scene]\npreset = \"cube\"\n[[scene.objects]]\nname = {quoted}\n\
             shape = \"points\"\npoints = [[0, 2, 0]]\n[[scene.objects]]\nname = \"b\"\nshape = \"box\"\n[[points]]\n\
             name = {quoted}\nposition = [1, 1, 1]\n[show]\nstage = \"cull-objects\"\n[labels]\n[[labels.renamed]]\n\
             name = \"object:b\"\ntext = {quoted}\n[[labels.notes]]\nat = [0.5, 0.5]\ntext = {quoted}\n"
        );
        // Controls are no text of a label.
        let Ok(figure) = parse(&text) else { continue };
        for (view, letters) in View::ALL.into_iter().flat_map(|view| [(view, Letters::Text), (view, Letters::Outlines)])
        {
            let sheet = sheet(&figure, Views::One(view), &request(&figure, SIZE));
            let svg = svg_of(&sheet, FileOptions { letters, ..FileOptions::of(PictureFormat::Svg) }, &figure);
            if let Some(wrong) = ill_formed(&svg) {
                panic!("{name:?} {view:?} {letters:?}: {wrong}");
            }
        }
    }
}

/// The first character data of an SVG that XML does not allow.
fn ill_formed(svg: &str) -> Option<String> {
    if let Some(c) = svg.chars().find(|c| matches!(c, '\u{fffe}' | '\u{ffff}' | '\0'..'\t' | '\u{b}'..' ')) {
        return Some(format!("{c:?}"));
    }
    let mut rest = svg;
    while let Some((text, tag)) = rest.split_once('<') {
        let (tag, after) = tag.split_once('>')?;
        let references = text.split('&').skip(1).chain(tag.split('&').skip(1));
        let mut names = references.map(|after| after.split(';').next().unwrap_or_default());
        if text.contains("]]>") || tag.contains('<') || names.any(|name| !["amp", "lt", "gt", "quot"].contains(&name)) {
            return Some(format!("{text}<{tag}>"));
        }
        rest = after;
    }
    None
}

#[test]
fn words_about_the_picture_are_in_the_file() {
    let text = "title = { en = \"A & <B>\", pt-BR = \"Um título\" }\n[scene]\npreset = \"house\"\n";
    let figure = parse(text).unwrap();
    let sheet = sheet(&figure, Views::One(View::Image), &request(&figure, SIZE));
    let told = pictures::told_of(Lang::PtBr, &figure, &sheet, String::new());
    let Metadata { title, description, language, .. } = &told;
    assert_eq!((title.as_str(), *language), ("Um título", "pt-BR"));
    assert!(description.contains("o que a câmera vê"), "{description}");
    let svg = svg_of(&sheet, FileOptions::of(PictureFormat::Svg), &figure);
    assert!(svg.contains("<title>A &amp; &lt;B&gt;</title>"), "{}", &svg[..600]);
    assert!(svg.contains("<desc>Image: ") && svg.contains("xml:lang=\"en\""), "{}", &svg[..600]);
    let pdf = written(&sheet, FileOptions::of(PictureFormat::Pdf), &figure, "").bytes;
    let has = |wanted: &[u8]| pdf.windows(wanted.len()).any(|window| window == wanted);
    assert!(has(b"/S /Figure") && has(b"/Alt") && has(b"/MarkInfo") && has(b"/Lang"));
    assert!(!has(b"/CreationDate") && !has(b"/ModDate"));
}

#[test]
fn areas_have_no_gaps_between_neighbours_at_any_zoom() {
    let bench = bench_with_fonts("vectors-areas");
    for (name, shading) in [("cube", Shading::Flat), ("primitives", Shading::Flat), ("house", Shading::Flat)] {
        let shipped = camera_lab_files::ShippedFigure::named(name).unwrap();
        let mut figure = parse(&shipped.text()).unwrap();
        figure.style.shading = shading;
        let request = request(&figure, SIZE);
        let finish = Finish { transparent: true, bare: true, ..Finish::default() };
        let sheet = sheet(&figure, Views::One(View::Image), &Request { finish, ..request });
        let pixels = Renderer::default().pixels(&sheet.requests[0]).unwrap();
        let options = FileOptions { faces: Faces::Areas, ..FileOptions::of(PictureFormat::Svg) };
        let PictureFile { bytes, no_areas, .. } = written(&sheet, options, &figure, "");
        assert_eq!(no_areas, None);
        let svg = String::from_utf8(bytes).unwrap();
        assert!(!svg.contains("<image"));
        let opaque = |x: u32, y: u32| pixels.rgba()[4 * (y * SIZE.width + x) as usize + 3] == 255;
        let inside = |x: u32, y: u32| (0..25).all(|k| opaque(x + k % 5 - 2, y + k / 5 - 2));
        for zoom in [1.0, 1.37, 2.6, 4.0] {
            let Some(picture) = drawn(&svg, zoom, &bench) else { return };
            let (mut tried, mut open) = (0, 0);
            for y in 2..SIZE.height - 2 {
                for x in (2..SIZE.width - 2).filter(|x| inside(*x, y)) {
                    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a pixel")]
                    let at = |v: u32| ((f64::from(v) + 0.5) * zoom) as u32;
                    let alpha = picture.pixel(at(x), at(y)).unwrap().alpha();
                    tried += 1;
                    open += usize::from(alpha < 250);
                }
            }
            assert!(tried > 5000 && open == 0, "{name} {shading:?} at {zoom}: {open} of {tried}");
        }
    }
}

#[test]
fn the_command_line_writes_vectors_and_reports_parts_left_out() {
    let bench = Bench::new("vectors-cli");
    bench.write("a.toml", "[scene]\npreset = \"house\"\n[style]\nshading = \"gouraud\"\n");
    let run = bench.run(&["render", "a.toml", "--faces", "vector", "--size", "200x150", "-o", "a.svg"]);
    assert_eq!(run.status, Some(0));
    assert!(run.err.contains("a.svg: the faces are an image") && run.err.contains("shading"), "{}", run.err);
    assert!(String::from_utf8(bench.read("a.svg")).unwrap().contains("<image"));
    bench.write("b.toml", "[scene]\npreset = \"house\"\n[style]\nshading = \"flat\"\n");
    bench.run(&["render", "b.toml", "--view", "world", "--width-cm", "12", "--letters", "8", "-o", "b.pdf"]).done();
    assert!(bench.read("b.pdf").starts_with(b"%PDF-"));
    // 12 cm are 340.16 points.
    let pdf = bench.read("b.pdf");
    let text = String::from_utf8_lossy(&pdf);
    let media = text.split("/MediaBox [").nth(1).unwrap().split(']').next().unwrap().to_owned();
    let width: f64 = media.split_whitespace().nth(2).unwrap().parse().unwrap();
    assert!((width - 340.16).abs() < 0.2, "{media}");
    assert!(bench.run(&["inspect", "b.pdf"]).json()["camera"].is_object(), "the figure is in it");
}

#[test]
fn latex_sets_the_names_in_the_documents_font_over_a_pdf_beside_it() {
    let bench = Bench::new("vectors-latex");
    bench.write("a.toml", "[scene]\npreset = \"house\"\n");
    bench.run(&["render", "a.toml", "--view", "all", "--width-cm", "24", "-o", "my figure.tex"]).done();
    let latex = String::from_utf8(bench.read("my figure.tex")).unwrap();
    assert!(
        latex.contains("{my-figure-art}") && latex.contains("$\\mathbf{u}$") && latex.contains("$z_{n}$"),
        "{latex}"
    );
    assert!(bench.read("my-figure-art.pdf").starts_with(b"%PDF-"));
    assert!(bench.run(&["inspect", "my-figure-art.pdf"]).json()["camera"].is_object(), "the figure is in it");
    let document = "\\documentclass{article}\\usepackage[utf8]{inputenc}\\usepackage{graphicx,color}\
                    \\begin{document}\\input{figure}\\end{document}";
    bench.write("figure.tex", &latex);
    bench.write("document.tex", document);
    if !has("pdflatex") {
        return;
    }
    let run = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "document.tex"])
        .current_dir(bench.path("."))
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stdout));
    if has("pdftotext") {
        let words = Command::new("pdftotext").arg(bench.path("document.pdf")).arg("-").output().unwrap();
        let words = String::from_utf8(words.stdout).unwrap();
        assert!(words.contains("VUP") && words.contains("PF") && words.contains("DOP"), "{words}");
    }
    // Compiled alone, it is a page as large as the picture.
    let alone = Command::new("pdflatex")
        .args(["-interaction=nonstopmode", "-halt-on-error", "figure.tex"])
        .current_dir(bench.path("."))
        .output()
        .unwrap();
    assert!(alone.status.success(), "{}", String::from_utf8_lossy(&alone.stdout));
    if has("pdfinfo") {
        let info = Command::new("pdfinfo").arg(bench.path("figure.pdf")).output().unwrap();
        let info = String::from_utf8(info.stdout).unwrap();
        let art = Command::new("pdfinfo").arg(bench.path("my-figure-art.pdf")).output().unwrap();
        let art = String::from_utf8(art.stdout).unwrap();
        let line = |info: &str, key: &str| info.lines().find(|line| line.starts_with(key)).unwrap().to_owned();
        let number =
            |line: &str| -> Vec<f64> { line.split_whitespace().filter_map(|word| word.parse().ok()).collect() };
        assert_eq!(number(&line(&info, "Pages:")), [1.0]);
        let [page, art] = [&info, &art].map(|info| number(&line(info, "Page size:")));
        assert!(page.iter().zip(&art).all(|(a, b)| (a - b).abs() < 0.5), "{page:?} {art:?}");
    }
}

#[test]
fn letters_on_paper_are_nine_points_and_small_ones_give_a_notice() {
    let bench = Bench::new("vectors-letters");
    bench.write("a.toml", "[scene]\npreset = \"house\"\n");
    let render = |arguments: &[&str]| bench.run(&[&["render", "a.toml", "--view", "world", "-o"], arguments].concat());
    render(&["a.png", "--width-cm", "8"]).done();
    render(&["b.png", "--width-cm", "8", "--letters", "9"]).done();
    assert!(bench.read("a.png") == bench.read("b.png"));
    let small = render(&["c.svg", "--width-cm", "8", "--letters", "4", "--lang", "en"]);
    assert!(small.err.contains("c.svg: its letters are 4.0 pt high on paper"), "{}", small.err);
    // Pixels of CSS: 96 per inch, and 9 points of them.
    render(&["d.svg", "--size", "480x360", "--letters", "9"]).done();
    let svg = String::from_utf8(bench.read("d.svg")).unwrap();
    assert!(svg.contains("width=\"360pt\"") && svg.contains("viewBox=\"0 0 480 360\""), "{}", &svg[..300]);
    assert!(svg.contains("font-size=\"12\""), "9 pt are 12 px");
}

/// The sizes of the letters of an SVG file. Subscripts are smaller.
fn letter_sizes(svg: &str) -> Vec<f64> {
    let size = |text: &str| text.split_once("font-size=\"")?.1.split('"').next()?.parse().ok();
    svg.split("<text").skip(1).filter_map(size).collect()
}

#[test]
fn no_letters_on_paper_are_smaller_than_they_were_asked_for() {
    let bench = Bench::new("vectors-least-letters");
    bench.write("a.toml", "[camera]\nnear = 2\n[scene]\npreset = \"house\"\n[show]\nmeasure = [\"D\", \"W\", \"F\"]\n");
    let sizes = |name: &str, more: &[&str]| {
        bench.run(&[&["render", "a.toml", "--view", "world", "-o", name], more].concat()).done();
        letter_sizes(&String::from_utf8(bench.read(name)).unwrap())
    };
    let usual = sizes("usual.svg", &["--size", "1890x1417", "--scale", "2"]);
    let (least, most) = usual.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), size| (a.min(*size), b.max(*size)));
    assert!(least < 0.9 * most, "names of points and of planes differ: {usual:?}");
    let on_paper = sizes("paper.svg", &["--width-cm", "16", "--dpi", "300", "--letters", "9"]);
    assert_eq!(on_paper.len(), usual.len());
    // 9 points are 37.5 pixels at 300 per inch.
    assert!(on_paper.iter().all(|size| *size > 37.4), "{on_paper:?}");
}

#[test]
fn a_cropped_picture_is_as_wide_as_it_was_asked_to_be() {
    let bench = Bench::new("vectors-exact-width");
    bench.write("a.toml", "[scene]\npreset = \"house\"\n");
    let asked = 16.0 / 2.54 * 72.0;
    for view in ["world", "canonical", "image", "all"] {
        let written = |name: &str| {
            let options = ["--width-cm", "16", "--height-cm", "12", "--dpi", "150", "--letters", "9", "--crop"];
            bench.run(&[&["render", "a.toml", "--view", view, "-o", name][..], &options].concat()).done();
            bench.read(name)
        };
        let png = image::load_from_memory(&written("a.png")).unwrap();
        assert_eq!(png.width(), 945, "{view}: 16 cm at 150 pixels per inch");
        assert!(png.height() <= 709, "{view}: {}", png.height());
        let svg = String::from_utf8(written("a.svg")).unwrap();
        let width: f64 = svg.split_once("width=\"").unwrap().1.split_once("pt\"").unwrap().0.parse().unwrap();
        assert!((width - asked).abs() < 72.0 / 150.0, "{view}: {width}");
        let pdf = String::from_utf8_lossy(&written("a.pdf")).into_owned();
        let page = pdf.split_once("/MediaBox").unwrap().1;
        let page = page[page.find('[').unwrap() + 1..page.find(']').unwrap()].to_owned();
        let sides: Vec<f64> = page.split_whitespace().map(|side| side.parse().unwrap()).collect();
        assert!((sides[2] - asked).abs() < 72.0 / 150.0, "{view}: {page}");
        let tex = String::from_utf8(written("a.tex")).unwrap();
        let width = |before: &str, after: &str| -> f64 {
            tex.split_once(before).unwrap().1.split_once(after).unwrap().0.parse().unwrap()
        };
        for width in [width("\\begin{picture}(", ","), width("includegraphics[width=", "bp]")] {
            assert!((width - asked).abs() < 72.0 / 150.0, "{view}: {width}");
        }
        assert!(letter_sizes(&svg).iter().all(|size| *size > 18.7 * if view == "all" { 0.6 } else { 1.0 }), "{view}");
    }
}
