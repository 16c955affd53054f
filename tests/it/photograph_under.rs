//! The photograph under the image: `[image] photograph` and `photograph_opacity`.

#![expect(clippy::cast_possible_truncation, reason = "colors are bytes")]

use std::io::Cursor;

use camera_lab::appearance::Theme;
use camera_lab::figure::read::parse;
use camera_lab::figure::write::to_toml;
use camera_lab::figure::{Figure, Photograph, update};
use camera_lab::views::Palette;

use crate::common::program::Bench;
use crate::common::rendered::png_with;

/// The halves of the photograph.
const LEFT: [u8; 3] = [250, 10, 200];
const RIGHT: [u8; 3] = [10, 220, 30];
const SIZE: [usize; 2] = [160, 120];
/// A box in the middle of the image, 40 pixels high, of its own color: no light falls on lines alone.
const BOX: &str = "[[scene.objects]]\nshape = \"box\"\ncolor = \"#2040ff\"\n";

/// A photograph of 8 × 6 pixels whose halves have one color each.
fn photograph() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 8, 6);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    let texels: Vec<u8> = (0..48).flat_map(|i| if i % 8 < 4 { LEFT } else { RIGHT }).collect();
    writer.write_image_data(&texels).expect("pixels");
    writer.finish().expect("a PNG");
    bytes
}

fn figure(image: &str, more: &str) -> String {
    format!(
        "[camera]\nposition = [0, 0, 6]\nprojection = \"parallel\"\nheight = 6\nnear = 1\nfar = 20\n\
         [image]\nwidth = 160\nheight = 120\n{image}\n[scene]\npreset = \"empty\"\n{more}"
    )
}

fn bench(name: &str) -> Bench {
    let bench = Bench::new(name);
    bench.write("photo.png", photograph());
    bench
}

/// The colors of a figure's image.
fn image(bench: &Bench, text: &str, more: &[&str]) -> Vec<[u8; 4]> {
    bench.write("figure.toml", text);
    let mut arguments = vec!["render", "figure.toml", "--view", "image", "-o", "image.png"];
    arguments.extend(more);
    bench.run(&arguments).done();
    let mut decoder = png::Decoder::new(Cursor::new(bench.read("image.png")));
    decoder.set_transformations(png::Transformations::ALPHA);
    let mut reader = decoder.read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut bytes).expect("pixels");
    assert_eq!([info.width as usize, info.height as usize], SIZE);
    bytes.as_chunks::<4>().0.to_vec()
}

fn at(pixels: &[[u8; 4]], x: usize, y: usize) -> [u8; 3] {
    let [r, g, b, _] = pixels[y * SIZE[0] + x];
    [r, g, b]
}

fn near(found: [u8; 3], expected: [u8; 3], what: &str) {
    let most = found.iter().zip(expected).map(|(a, b)| a.abs_diff(b)).max();
    assert!(most <= Some(2), "{what}: {found:?} for {expected:?}");
}

fn paper() -> [u8; 3] {
    let paper = Palette::of(Theme::Light).paper;
    [paper.r, paper.g, paper.b]
}

/// A share of one color over another one, in bytes.
fn mixed(over: [u8; 3], under: [u8; 3], share: f64) -> [u8; 3] {
    let mix = |k: usize| f64::from(over[k]) * share + f64::from(under[k]) * (1.0 - share);
    [0, 1, 2].map(|k| mix(k).round() as u8)
}

/// The places in which the photograph shows, in its two halves: in the corners of the image, and beside the box.
const SEEN: [([usize; 2], [u8; 3]); 6] =
    [([1, 1], LEFT), ([158, 1], RIGHT), ([1, 118], LEFT), ([158, 118], RIGHT), ([50, 60], LEFT), ([110, 60], RIGHT)];
/// Places on the box, away from its edges.
const ON_BOX: [[usize; 2]; 3] = [[72, 52], [84, 60], [90, 66]];

#[test]
fn a_photograph_shows_in_empty_places_and_not_through_objects() {
    let bench = bench("photograph-under");
    // In each way to find hidden surfaces: one box needs no depths, and glass is drawn after everything that is not.
    let glass = format!("{BOX}[[scene.objects]]\nshape = \"sphere\"\nname = \"s\"\ntranslate = [0, 2.2, 0]\n");
    let glass = format!("{glass}scale = [0.5, 0.5, 0.5]\ncolor = \"#80800080\"\n");
    let scenes = [BOX.to_owned(), glass];
    for style in ["visibility = \"depth-buffer\"", "visibility = \"painter\"", "visibility = \"bsp\""] {
        for scene in &scenes {
            let scene = format!("{scene}[style]\n{style}\n");
            let plain = image(&bench, &figure("", &scene), &[]);
            for (opacity, share) in [("", 0.5), ("photograph_opacity = 1", 1.0), ("photograph_opacity = 0.25", 0.25)] {
                let pixels = image(&bench, &figure(&format!("photograph = \"photo.png\"\n{opacity}"), &scene), &[]);
                for ([x, y], color) in SEEN {
                    near(at(&plain, x, y), paper(), "no photograph");
                    near(at(&pixels, x, y), mixed(color, paper(), share), &format!("{style} {share} {x} {y}"));
                }
                for [x, y] in ON_BOX {
                    assert_eq!(at(&pixels, x, y), at(&plain, x, y), "{style} {share}: the box hides it");
                    assert_ne!(at(&pixels, x, y), paper());
                }
            }
            let none = image(&bench, &figure("photograph = \"photo.png\"\nphotograph_opacity = 0", &scene), &[]);
            assert_eq!(none, plain, "opacity 0: {style}");
        }
    }
}

#[test]
fn a_transparent_image_has_the_photograph_at_its_opacity() {
    let bench = bench("photograph-clear");
    let pixels = image(&bench, &figure("photograph = \"photo.png\"", BOX), &["--transparent"]);
    let [r, g, b, alpha] = pixels[SIZE[0] + 1];
    assert_eq!(alpha, 128);
    near([r, g, b], LEFT, "as it is, half clear");
}

#[test]
fn depths_as_greys_and_the_other_pictures_are_without_it() {
    let bench = bench("photograph-depth");
    let depth = format!("{BOX}[reveal]\ndepth = true\n");
    let with = image(&bench, &figure("photograph = \"photo.png\"", &depth), &[]);
    assert_eq!(with, image(&bench, &figure("", &depth), &[]));
    let canonical = |text: &str| {
        bench.write("figure.toml", text);
        bench.run(&["render", "figure.toml", "--view", "canonical", "-o", "c.svg"]).done();
        String::from_utf8(bench.read("c.svg")).expect("text")
    };
    assert!(!canonical(&figure("photograph = \"photo.png\"", BOX)).contains("<image"));
}

#[test]
fn a_photograph_that_is_missing_or_none_is_a_notice() {
    let bench = bench("photograph-missing");
    bench.write("text.png", "no picture");
    for (file, language, words) in [
        ("gone.jpg", "en", "[image]: the photograph gone.jpg"),
        ("text.png", "en", "is no known image; allowed: PNG, JPEG and WebP; the image is shown without it"),
        ("gone.jpg", "pt-BR", "[image]: o arquivo da fotografia gone.jpg"),
        ("text.png", "pt-BR", "e a imagem aparece sem ela"),
    ] {
        bench.write("figure.toml", figure(&format!("photograph = \"{file}\""), BOX));
        let run = bench.run(&["render", "figure.toml", "--view", "image", "-o", "image.png", "--lang", language]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        assert!(run.err.contains(words), "{}", run.err);
    }
    let without = image(&bench, &figure("", BOX), &[]);
    bench.write("figure.toml", figure("photograph = \"gone.jpg\"", BOX));
    assert_eq!(bench.run(&["render", "figure.toml", "--view", "image", "-o", "image.png"]).status, Some(0));
    let mut reader = png::Decoder::new(Cursor::new(bench.read("image.png"))).read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut bytes).expect("pixels");
    let rgb: Vec<u8> = without.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]).collect();
    assert_eq!(bytes, rgb);
}

/// A figure inside a picture may be from anywhere: its photograph is in the picture's folder or below, unless the
/// user allows all files.
#[test]
fn the_photograph_of_a_figure_in_a_picture_is_read_where_its_textures_would_be() {
    let (there, here) = (bench("photograph-there"), bench("photograph-here"));
    let elsewhere = there.path("photo.png").display().to_string();
    here.write("image.png", png_with(&figure(&format!("photograph = '{elsewhere}'"), BOX)));
    let again = |more: &[&str]| {
        let mut arguments = vec!["render", "image.png", "--view", "image", "-o", "again.png"];
        arguments.extend(more);
        here.run(&arguments)
    };
    let refused = again(&[]);
    assert_eq!(refused.status, Some(0), "{}", refused.err);
    assert!(
        refused.err.contains("[image]: the photograph") && refused.err.contains("it lies elsewhere"),
        "{}",
        refused.err
    );
    again(&["--allow-files"]).done();
    here.write("image.png", png_with(&figure("photograph = \"photo.png\"", BOX)));
    again(&[]).done();
}

/// A page has the photograph as a picture, under areas that are still areas.
#[test]
fn pages_of_vectors_have_the_photograph_as_a_picture() {
    let bench = bench("photograph-vectors");
    let written = |image: &str, file: &str| {
        bench.write("figure.toml", figure(image, BOX));
        bench.run(&["render", "figure.toml", "--view", "image", "-o", file]).done();
        bench.read(file)
    };
    let svg = |image: &str| String::from_utf8(written(image, "p.svg")).expect("text");
    for opacity in ["", "\nphotograph_opacity = 1"] {
        let with = svg(&format!("photograph = \"photo.png\"{opacity}"));
        let picture = with.find("<image").expect("a picture");
        let face = with[picture..].find("<path").map(|at| picture + at).expect("areas over it");
        assert!(with[..picture].matches("<image").count() == 0 && face > picture);
        assert_eq!(with.matches("<image").count(), 1);
    }
    assert!(!svg("").contains("<image"));
    let pictures = |pdf: Vec<u8>| {
        pdf.windows(14).filter(|bytes| *bytes == b"/Subtype/Image" || *bytes == b"/Subtype /Imag").count()
    };
    assert!(pictures(written("photograph = \"photo.png\"", "p.pdf")) > 0);
    assert_eq!(pictures(written("", "q.pdf")), 0);
}

#[test]
fn the_keys_are_read_written_and_edited() {
    let text = figure("photograph = \"a \\\"b\\\".jpg\" # of the house\nphotograph_opacity = 0.3", BOX);
    let read = parse(&text).expect("a figure");
    let expected = Photograph { file: "a \"b\".jpg".to_owned(), opacity: 0.3 };
    assert_eq!(read.photograph, Some(expected.clone()));
    assert_eq!(parse(&to_toml(&read)), Ok(read.clone()));
    let usual = parse("[image]\nphotograph = \"a.jpg\"").expect("a figure").photograph.expect("a photograph");
    assert_eq!(usual.opacity, 0.5);
    let fainter = Figure { photograph: Some(Photograph { opacity: 0.75, ..expected }), ..read.clone() };
    assert_eq!(update(&text, &fainter), text.replace("0.3", "0.75"));
    let none = Figure { photograph: None, ..read };
    let edited = update(&text, &none);
    assert!(!edited.contains("photograph") && edited.contains("width = 160"), "{edited}");
    assert_eq!(parse(&edited), Ok(none));
    assert!(!to_toml(&Figure::default()).contains("photograph"));
}

#[test]
fn values_that_the_keys_do_not_allow_are_refused() {
    let bench = Bench::new("photograph-refused");
    for (image, language, words) in [
        (
            "photograph = \"a.jpg\"\nphotograph_opacity = 1.5",
            "en",
            "[image] photograph_opacity is 1.5; allowed: a number from 0 to 1",
        ),
        (
            "photograph = \"a.jpg\"\nphotograph_opacity = -0.1",
            "pt-BR",
            "[image] photograph_opacity é -0.1; permitido: um número de 0 a 1",
        ),
        ("photograph_opacity = 0.5", "en", "[image] photograph is missing"),
        ("photograph_opacity = 0.5", "pt-BR", "[image] photograph"),
        ("photograph = \"\"", "en", "[image] photograph is \"\""),
        ("photograph = 3", "en", "[image] photograph is 3"),
        ("photo = \"a.jpg\"", "en", "photograph"),
    ] {
        bench.write("figure.toml", figure(image, ""));
        let run = bench.run(&["inspect", "figure.toml", "--lang", language]);
        assert!(run.refused(2).contains(words), "{}", run.err);
    }
    bench.write("figure.toml", figure("", "[compare]\nwith = { \"image.photograph\" = \"a.jpg\" }\n"));
    assert!(bench.run(&["inspect", "figure.toml"]).refused(2).contains("image.photograph"));
}

/// The report is of the camera: a photograph changes nothing of it, whether it can be read or not.
#[test]
fn inspect_reports_the_same_with_a_photograph() {
    let bench = bench("photograph-inspect");
    let report = |image: &str| {
        bench.write("figure.toml", figure(image, BOX));
        bench.run(&["inspect", "figure.toml", "--format", "json"]).json()
    };
    assert_eq!(report("photograph = \"photo.png\""), report(""));
    assert_eq!(report("photograph = \"gone.png\""), report(""));
}

/// Both sides of a comparison have it, each with its own opacity.
#[test]
fn a_comparison_may_be_of_the_opacity() {
    let bench = bench("photograph-compared");
    let compare = "[compare]\nwith = { \"image.photograph_opacity\" = 1 }\n";
    let text = figure("photograph = \"photo.png\"\nphotograph_opacity = 0", &format!("{BOX}{compare}"));
    let pixels = image(&bench, &text, &[]);
    near(at(&pixels, 2, 60), paper(), "the side without");
    near(at(&pixels, 157, 60), RIGHT, "the side with it alone");
}
