//! Several cameras in one world: in the report, in pixels and vectors, and as projector pairs.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Camera, Convention, ImageSize, Parameters, Projection, Viewport};
use camera_lab::figure::{Figure, NamedCamera, View, read};
use camera_lab::inspect::Report;
use camera_lab::picture::Renderer;
use camera_lab::views::{Request, Size, camera_at};
use camera_lab_words::{Lang, pictures::labels};
use glam::{DMat3, DVec2, DVec3};
use proptest::prelude::*;

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

/// The pixel of a point, not floored.
fn pixel(camera: &Camera, image: ImageSize, p: DVec3) -> DVec2 {
    let ndc = camera.stations(p, image, &Viewport::whole(image)).projected.unwrap().ndc;
    DVec2::new((ndc.x + 1.0) / 2.0 * f64::from(image.width), (1.0 - ndc.y) / 2.0 * f64::from(image.height))
}

fn matrix(rows: [[f64; 3]; 3]) -> DMat3 {
    DMat3::from_cols_array_2d(&rows).transpose()
}

/// A camera anywhere about the origin.
fn any_camera() -> impl Strategy<Value = Parameters> {
    let place = || (-9.0..9.0, -9.0..9.0, -9.0..9.0).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    (place(), place(), 20.0..100.0, any::<bool>(), 0.5..2.0).prop_map(
        |(position, aim, view_angle, is_parallel, aspect)| {
            let projection = if is_parallel { Projection::Parallel } else { Projection::Perspective };
            let focal_point = aim * 0.2;
            Parameters { position, focal_point, view_angle, aspect, projection, height: 6.0, ..Parameters::default() }
        },
    )
}

proptest! {
    /// F and E by their definitions, from the pixels of points alone.
    #[test]
    fn a_pair_reports_what_a_pixel_here_says_there(own in any_camera(), other in any_camera(), p in prop::array::uniform3(-1.0..1.0)) {
        let ([Ok(here), Ok(there)], p) = ([own, other].map(|p| Camera::new(&p)), DVec3::from_array(p)) else {
            return Ok(());
        };
        prop_assume!([&here, &there].iter().all(|camera| camera.view_point(p).z < -1.0));
        prop_assume!(own.position.distance(other.position) > 0.5);
        let named = NamedCamera { name: "there".to_owned(), color: None, parameters: other, lens: None };
        let figure = Figure { camera: own, cameras: vec![named], ..Figure::default() };
        let report = Report::new(&figure, &[], Convention::RightHand, &[p], &[]).unwrap();
        let pair = &report.pairs[0];
        prop_assert_eq!(DVec3::from_array(pair.baseline), other.position - own.position);
        let f = matrix(pair.fundamental.unwrap());
        prop_assert!((f.to_cols_array().iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-9);
        let [x, x_there] = [&here, &there].map(|camera| pixel(camera, figure.image, p));
        let line = &pair.lines[0];
        prop_assert!((line.disparity.unwrap() - (x.x - x_there.x)).abs() < 1e-6);
        // Distances in pixels from the point's own lines.
        let [a, b] = [(line.here, x), (line.there, x_there)].map(|(line, x)| DVec3::from_array(line.unwrap()).dot(x.extend(1.0)));
        prop_assert!(a.abs() < 1e-4 && b.abs() < 1e-4, "{a} {b}");
        let l = f * x.extend(1.0);
        prop_assert!((l.dot(x_there.extend(1.0)) / l.truncate().length()).abs() < 1e-4);
        // All lines meet in the epipole.
        if let Some(e) = pair.epipole {
            let e = DVec2::from_array(e).extend(1.0);
            prop_assert!((f * e).length() < 1e-8 * e.length(), "{}", f * e);
            if other.projection == Projection::Perspective && here.view_point(other.position).z < -0.1 {
                prop_assert!(pixel(&here, figure.image, other.position).distance(e.truncate()) < 1e-4 * e.length());
            }
        }
        let both = own.projection == Projection::Perspective && other.projection == Projection::Perspective;
        prop_assert_eq!(pair.essential.is_some(), both);
        if let Some(e) = pair.essential {
            // Directions to the point, x to the right, y down and z ahead.
            let [d, d_there] = [&here, &there].map(|camera| camera.view_point(p).normalize() * DVec3::new(1.0, -1.0, -1.0));
            let e = matrix(e);
            prop_assert!(d_there.dot(e * d).abs() < 1e-9 * own.position.distance(other.position));
            // Two equal singular values, the length of the baseline, and 0: 2 E Eᵀ E = tr(E Eᵀ) E.
            let square = e * e.transpose();
            let trace = square.x_axis.x + square.y_axis.y + square.z_axis.z;
            let length = own.position.distance(other.position);
            prop_assert!((trace - 2.0 * length * length).abs() < 1e-9 * trace);
            prop_assert!((square * e * 2.0).abs_diff_eq(e * trace, 1e-9 * trace * length));
        }
    }
}

#[test]
fn a_pair_with_one_centre_has_no_f_and_a_rectified_one_no_epipoles() {
    let bench = Bench::new("cameras-pairs");
    let report = |more: &str| {
        bench.write(
            "f.toml",
            format!("[camera]\nposition = [1, 2, 6]\nfocal_point = [1, 2, 0]\n[[cameras]]\nname = \"b\"\n{more}"),
        );
        bench.run(&["inspect", "f.toml", "--point=0,0,0", "--point=1,2,6", "--format", "json"]).json()["pairs"][0]
            .clone()
    };
    let one = report("position = [1, 2, 6]\nfocal_point = [0, 1, 0]\n");
    assert!(one["fundamental"].is_null() && one["lines"][0]["there"].is_null() && one["epipole"].is_null(), "{one}");
    let rectified = report("position = [1.7, 2, 6]\nfocal_point = [1.7, 2, 0]\n");
    assert!(rectified["epipole"].is_null() && rectified["epipole_there"].is_null(), "{rectified}");
    // f b / z, in pixels of 1024 × 768 at 45°.
    let disparity = 384.0 / 22.5_f64.to_radians().tan() * 0.7 / 6.0;
    assert!((rectified["lines"][0]["disparity"].as_f64().unwrap() - disparity).abs() < 1e-9);
    assert!(rectified["lines"][1]["disparity"].is_null(), "C has no pixel");
}

#[test]
fn an_epipolar_line_crosses_the_whole_image_with_its_name_and_stays_with_depths() {
    for depth in ["", "[reveal]\ndepth = true\n"] {
        let compare = "[show]\nprobe = { pixel = [520, 330] }\n[compare]\ncamera = \"right\"\nlayout = \"beside\"\n";
        let figure = read::parse(&format!("{PAIR}{compare}{depth}")).unwrap();
        let [_, other] = request(&figure, View::Image).sides().unwrap();
        let marked = pixels_of(&other.request, [0xb0, 0x00, 0x5e]);
        let mut columns: Vec<f64> = marked.iter().map(|at| at[0]).collect();
        columns.sort_by(f64::total_cmp);
        columns.dedup();
        let width = f64::from(other.request.size.width);
        let ends = [columns[0], columns[columns.len() - 1]];
        assert!(ends[0] < 12.0 && ends[1] + 12.0 > width && columns.len() as f64 > width * 0.6, "{depth}{ends:?}");
        let svg = Bench::new("cameras-epipolar");
        svg.write("f.toml", format!("{PAIR}{compare}{depth}"));
        svg.run(&["render", "f.toml", "--view", "image", "--lang", "pt-BR", "-o", "f.svg"]).done();
        assert!(String::from_utf8(svg.read("f.svg")).unwrap().contains("reta epipolar"));
    }
}
