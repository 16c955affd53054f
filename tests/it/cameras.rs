//! Several cameras in one world: in the report, in pixels and vectors, and as projector pairs.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Camera, Viewport};
use camera_lab::figure::{Figure, View, read};
use camera_lab::picture::Renderer;
use camera_lab::views::{Request, Size, camera_at};
use camera_lab_words::{Lang, pictures::labels};
use glam::DVec3;

use crate::common::program::Bench;
use crate::common::shot::scene;

const PAIR: &str = "[camera]\nname = \"left\"\nposition = [2, 2, 6]\nfocal_point = [0, 1, 0]\nnear = 2\nfar = 9\n\
                    [[cameras]]\nname = \"right\"\ncolor = \"#8a2be2\"\nposition = [5, 2, 4]\nfocal_point = [0, 1, 0]\n\
                    near = 2\nfar = 9\n[scene]\npreset = \"house\"\n[style]\nantialias = 1\n";
const VIOLET: [u8; 3] = [0x8a, 0x2b, 0xe2];

fn request(figure: &Figure, view: View) -> Request {
    let camera = Camera::new(&figure.camera).unwrap();
    let size = Size { width: 640, height: 480, scale: 1.0 };
    Request::of(figure, view, &camera, &scene(figure), labels(Lang::En), size)
}

/// The pixels of a picture that are nearly a color.
fn pixels_of(request: &Request, color: [u8; 3]) -> Vec<[f64; 2]> {
    let picture = Renderer::default().pixels(request).unwrap();
    let near = |pixel: &[u8]| pixel.iter().zip(color).take(3).all(|(a, b)| a.abs_diff(b) <= 12);
    let width = picture.width() as usize;
    let places = picture.rgba().chunks_exact(4).enumerate().filter(|(_, pixel)| near(pixel));
    places.map(|(i, _)| [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5]).collect()
}

#[test]
fn the_report_lists_the_cameras_with_the_numbers_that_each_has_alone() {
    let bench = Bench::new("cameras-report");
    bench.write("pair.toml", PAIR);
    bench.write("right.toml", "[camera]\nposition = [5, 2, 4]\nfocal_point = [0, 1, 0]\nnear = 2\nfar = 9\n");
    let report = bench.run(&["inspect", "pair.toml", "--format", "json"]).json();
    let alone = bench.run(&["inspect", "right.toml", "--format", "json"]).json();
    let right = &report["cameras"][0];
    assert_eq!((report["cameras"].as_array().unwrap().len(), &right["name"]), (1, &"right".into()));
    assert_eq!(right["color"], "#8a2be2");
    for key in alone["camera"].as_object().unwrap().keys() {
        assert_eq!(right[key], alone["camera"][key], "{key}");
    }
    for key in ["distance", "basis", "view_matrix", "projection_matrix"] {
        assert_eq!(right[key], alone[key], "{key}");
    }
    assert!(alone.get("cameras").is_none());
}

#[test]
fn the_world_shows_each_camera_in_its_color_and_the_image_none() {
    let figure = read::parse(PAIR).unwrap();
    let alone = Figure { cameras: Vec::new(), ..figure.clone() };
    assert!(pixels_of(&request(&figure, View::World), VIOLET).len() > 300);
    assert!(pixels_of(&request(&alone, View::World), VIOLET).is_empty());
    let images = [&figure, &alone].map(|figure| Renderer::default().pixels(&request(figure, View::Image)).unwrap());
    assert_eq!(images[0].rgba(), images[1].rgba());
}

#[test]
fn vectors_show_the_cameras_with_their_names() {
    let bench = Bench::new("cameras-vectors");
    bench.write("pair.toml", PAIR);
    bench.run(&["render", "pair.toml", "--view", "world", "-o", "world.svg"]).done();
    let svg = String::from_utf8(bench.read("world.svg")).unwrap();
    assert!(svg.contains("#8a2be2") && svg.contains("right"));
    bench.run(&["render", "pair.toml", "--view", "world", "-o", "world.pdf"]).done();
}

#[test]
fn a_camera_is_picked_where_its_body_is_drawn() {
    let figure = read::parse(PAIR).unwrap();
    let request = request(&figure, View::World);
    let places = camera_lab::views::pick::places(&request).unwrap();
    let right = Camera::new(&figure.cameras[0].parameters).unwrap();
    assert_eq!(camera_at(&request, places(right.position()).unwrap(), 6.0), Some(0));
    assert_eq!(camera_at(&request, places(DVec3::ZERO).unwrap(), 6.0), None);
}

#[test]
fn a_marked_pixel_is_its_epipolar_line_in_the_other_image() {
    let text =
        format!("{PAIR}[show]\nprobe = {{ pixel = [520, 330] }}\n[compare]\ncamera = \"right\"\nlayout = \"beside\"\n");
    let figure = read::parse(&text).unwrap();
    let whole = request(&figure, View::Image);
    let [_, other] = whole.sides().unwrap();
    let own = Camera::new(&figure.camera).unwrap();
    let right = Camera::new(&figure.cameras[0].parameters).unwrap();
    let ray = own.ray_through_pixel(figure.image, 520, 330);
    let marked = pixels_of(&other.request, [0xb0, 0x00, 0x5e]);
    let size = other.request.size;
    // The image fills the width of its half, and is in its middle.
    let scale = f64::from(size.width) / f64::from(figure.image.width);
    let top = (f64::from(size.height) - f64::from(figure.image.height) * scale) / 2.0;
    let mut on_line = 0;
    for step in 0..60 {
        let p = ray.origin + ray.direction * (3.0 + 0.1 * f64::from(step));
        let seen = right.stations(p, figure.image, &Viewport::whole(figure.image)).projected.unwrap();
        let [m, n] = [f64::from(figure.image.width), f64::from(figure.image.height)];
        let place = [(seen.ndc.x + 1.0) / 2.0 * m * scale, top + (1.0 - seen.ndc.y) / 2.0 * n * scale];
        if place[0] < 4.0 || place[0] > f64::from(size.width) - 4.0 {
            continue;
        }
        let is_drawn = marked.iter().any(|at| (at[0] - place[0]).hypot(at[1] - place[1]) < 3.0);
        on_line += usize::from(is_drawn);
    }
    assert!(on_line > 12, "{on_line}");
    // Nothing of the pair is in the world, which shows both cameras anyway.
    assert!(request(&figure, View::World).sides().is_none());
}
