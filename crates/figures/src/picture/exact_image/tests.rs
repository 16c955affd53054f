#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use super::*;
use crate::figure::read::parse;
use crate::figure::{Reveal, Show};
use crate::picture::Renderer;
use crate::progress::at_once;
use crate::scene::{build, no_files};
use crate::views::{SharedScene, Size, View, image_frame, unlabelled};

fn small() -> Size {
    Size { width: 96, height: 72, scale: 1.0 }
}

/// The image of a figure without the inner work that it reveals.
fn request_of(text: &str, size: Size) -> Request {
    let mut figure = parse(text).unwrap();
    (figure.reveal, figure.show) = (Reveal::default(), Show::default());
    let scene = build(&figure.scene, &figure.style, &mut no_files).unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    Request::of(&figure, View::Image, &camera, &SharedScene::new(scene), unlabelled(), size)
}

/// The text of a figure of the program.
fn shipped(name: &str) -> String {
    let path = format!("{}/../../assets/figures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

/// The shortcut, against 64 rays for each pixel. Only light that changes smoothly may differ a little.
#[test]
fn one_ray_is_enough_if_a_pixel_shows_one_face_and_one_texel() {
    for (name, most) in [
        ("house", 1e-9),
        ("corridor", 1e-9),
        ("pipeline/painter", 1e-9),
        ("pipeline/z-fighting", 1e-9),
        ("pipeline/texture-texels", 0.5),
        ("pipeline/shadow-detached", 3.0),
        ("pipeline/phong", 3.0),
    ] {
        let request = request_of(&shipped(name), small());
        let frame = request.image_frame();
        let rays = Rays::new(&request, frame).unwrap();
        let (mut worst, mut saved) = (0.0_f64, 0);
        for (at, edge) in rays.edges.iter().enumerate() {
            let at = u32::try_from(at).unwrap();
            let pixel = [at % frame.width, at / frame.width];
            let (short, whole) = (rays.pixel(pixel, *edge), rays.pixel(pixel, true));
            saved += usize::from(!edge);
            worst = short.iter().zip(whole).map(|(a, b)| (a - b).abs()).fold(worst, f64::max);
        }
        assert!(worst <= most, "{name}: {worst}");
        assert!(saved > rays.edges.len() / 10, "{name}: {saved}");
    }
}

/// A red half-plane from a corner to the opposite one covers half of the pixels on the diagonal.
#[test]
fn a_pixel_is_the_mean_of_its_places() {
    let text = "[scene]\npreset = \"empty\"\n[[scene.objects]]\nshape = \"box\"\ncolor = \"#ff000080\"\n\
                rotate = [0, 0, 45]\nscale = [10, 10, 0.001]\ntranslate = [7.0710678, -7.0710678, 0]\n\
                [camera]\nposition = [0, 0, 5]\nfocal_point = [0, 0, 0]\nprojection = \"parallel\"\nheight = 2\naspect = 1\n\
                [image]\nwidth = 8\nheight = 8\n";
    let size = Size { width: 8, height: 8, scale: 1.0 };
    let request = request_of(text, size);
    let rays = Rays::new(&request, image_frame(size, 1.0)).unwrap();
    let ground = rays.ground;
    let pixel = |i, j| rays.pixel([i, j], rays.edges[8 * j as usize + i as usize]);
    assert_eq!(pixel(0, 4), ground, "left of the diagonal");
    let inside = pixel(6, 6);
    assert!(inside[1] < ground[1] && inside[0] > 100.0, "{inside:?}");
    let half = pixel(3, 4);
    for k in 0..3 {
        assert!((half[k] - 0.5 * (ground[k] + inside[k])).abs() <= 255.0 / 16.0, "{half:?} {ground:?} {inside:?}");
    }
}

fn exact_of(text: &str) -> ExactImage {
    at_once(exact_image(&request_of(text, small()), &Progress::default())).unwrap()
}

/// Three bars, each over one and under another. The painter would also hide their outlines wrongly.
#[test]
fn the_exact_image_does_not_depend_on_what_the_figure_chooses() {
    let text = shipped("pipeline/painter");
    let with = |style: &str| exact_of(&text.replace("visibility   = \"painter\"\n", style)).pixels;
    let exact = with("");
    for style in ["visibility = \"painter\"\n", "depth_format = \"fixed-16\"\n", "antialias = 1\n"] {
        assert!(with(style) == exact, "{style}");
    }
}

/// Squares far smaller than a place, dark and bright: their mean is that of their light, and not of their bytes.
#[test]
fn a_texture_far_smaller_than_a_place_has_the_light_of_its_texels() {
    let text = "[scene]\npreset = \"empty\"\n[[scene.objects]]\nshape = \"box\"\ntexture = \"chequer\"\n\
                texture_scale = [9001, 9001]\n[camera]\nposition = [0, 0, 5]\nfocal_point = [0, 0, 0]\n\
                projection = \"parallel\"\nheight = 1\n[style]\nhidden_lines = \"hidden\"\n";
    let exact = exact_of(text);
    assert!(exact.minified.iter().any(|minified| *minified));
    // The program reads the last level of detail here, which is the mean of the light.
    let drawn = Renderer::default().pixels(&request_of(text, small())).unwrap();
    for (pixel, drawn) in exact.pixels.rgba().chunks_exact(4).zip(drawn.rgba().chunks_exact(4)) {
        assert!(pixel.iter().zip(drawn).all(|(a, b)| a.abs_diff(*b) <= 3), "{pixel:?} {drawn:?}");
    }
}

#[test]
fn what_is_too_large_is_refused() {
    let request = request_of(&shipped("house"), Size { width: 4096, height: 4096, scale: 1.0 });
    let refused = at_once(exact_image(&request, &Progress::default())).err();
    assert_eq!(refused, Some(NoExactImage::Pixels));
}
