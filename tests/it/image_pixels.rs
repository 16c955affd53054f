//! The image picture is the m × n image of (5.22): the pixel that `inspect` gives for a point is its pixel in the PNG,
//! even if A ≠ m / n.

use std::io::Cursor;

use crate::common::program::Bench;

/// Exercise 5.2 as it is printed: A = 3/4, m × n = 1024 × 768.
const EXERCISE_52: &str = "position = [7, 0, 0]\nfocal_point = [1, 1, 1]\nview_up = [1, 0, 0]\nprojection = \"parallel\"\n\
    height = \"2 sqrt(38)\"\naspect = \"3/4\"\nnear = 1\nfar = 12\n";
/// Looks along −z at a window of 3 × 4.
const STRAIGHT: &str =
    "position = [0, 0, 5]\nprojection = \"parallel\"\nheight = 4\naspect = 0.75\nnear = 1\nfar = 20\n";
/// The padlock is open.
const FREE: &str =
    "position = [3, 4, 5]\nnear = 2\nfar = 20\nwindow = { left = -3, right = 1, bottom = -1, top = 1.5 }\n";

/// A decoded picture: width, height, RGB.
type Pixels = (u32, u32, Vec<[u8; 3]>);

fn decoded(bytes: Vec<u8>) -> Pixels {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut bytes).expect("pixels");
    let rgb = bytes.chunks(info.color_type.samples()).map(|p| [p[0], p[1], p[2]]).collect();
    (info.width, info.height, rgb)
}

fn figure(camera: &str, image: &str, objects: &str) -> String {
    format!(
        "[camera]\n{camera}\n[image]\nwidth = 1024\nheight = 768\n{image}\n[style]\nshading = \"flat\"\nantialias = 1\n\n\
         [scene]\npreset = \"empty\"\n{objects}"
    )
}

/// The middle of the red area, in pixels.
fn red_middle((width, _, rgb): &Pixels) -> [f64; 2] {
    let (mut sum, mut count) = ([0.0; 2], 0.0);
    for (i, p) in rgb.iter().enumerate() {
        if p[0] > 200 && p[1] < 60 && p[2] < 60 {
            let (x, y) = (i % *width as usize, i / *width as usize);
            sum = [sum[0] + x as f64 + 0.5, sum[1] + y as f64 + 0.5];
            count += 1.0;
        }
    }
    assert!(count > 8.0, "something red is seen");
    sum.map(|s| s / count)
}

fn render(bench: &Bench, text: &str, more: &[&str]) -> Pixels {
    bench.write("figure.toml", text);
    let mut arguments = vec!["render", "figure.toml", "--view", "image", "-o", "image.png"];
    arguments.extend(more);
    assert_eq!(bench.run(&arguments).status, Some(0));
    decoded(bench.read("image.png"))
}

fn inspected(bench: &Bench, point: &str) -> [f64; 2] {
    let report = bench.run(&["inspect", "figure.toml", "--point", point, "--format", "json"]).json();
    let pixel = &report["points"][0]["pixel"];
    [0, 1].map(|k| pixel[k].as_f64().expect("a number"))
}

#[test]
fn a_point_stands_in_the_picture_at_the_pixel_that_inspect_says() {
    let bench = Bench::new("image-pixels");
    for (name, camera, point) in [
        ("straight", STRAIGHT, [1.0, 1.0, 0.0]),
        ("exercise 5.2", EXERCISE_52, [1.0, 1.0, 0.0]),
        ("exercise 5.2", EXERCISE_52, [-0.8, 0.5, 1.0]),
        ("free window", FREE, [0.5, 0.2, -0.7]),
        ("free window", FREE, [-0.4, 0.6, 1.0]),
    ] {
        let [x, y, z] = point;
        let object = format!(
            "[[scene.objects]]\nname = \"P\"\nshape = \"points\"\ncolor = \"#ff0000\"\npoints = [[{x}, {y}, {z}]]\n"
        );
        let pixels = render(&bench, &figure(camera, "", &object), &[]);
        assert_eq!((pixels.0, pixels.1), (1024, 768));
        let (pixel, middle) = (inspected(&bench, &format!("{x},{y},{z}")), red_middle(&pixels));
        if name == "straight" {
            assert_eq!(pixel, [853.0, 192.0], "by hand: 1024 (1 + 3/2) / 3, 768 (2 − 1) / 4");
        }
        // The mark is round: its middle is the point, which lies somewhere in its pixel.
        for k in 0..2 {
            assert!((middle[k] - pixel[k] - 0.5).abs() <= 1.0, "{name} {point:?}: {middle:?}, pixel {pixel:?}");
        }
    }
}

#[test]
fn a_face_covers_the_pixels_between_those_of_its_corners() {
    let bench = Bench::new("image-faces");
    // From (−1, −1) to (1, 1): columns 1024/6 = 170.67 to 853.33, rows 192 to 576.
    let object = "[[scene.objects]]\nname = \"box\"\nshape = \"box\"\ncolor = \"#ff0000\"\n";
    let covered = |(width, height, rgb): &Pixels| {
        let differs = |x: u32, y: u32| rgb[(y * width + x) as usize] != rgb[0];
        let columns: Vec<u32> = (0..*width).filter(|&x| differs(x, height / 2)).collect();
        let rows: Vec<u32> = (0..*height).filter(|&y| differs(width / 2, y)).collect();
        [columns[0], columns[columns.len() - 1], rows[0], rows[rows.len() - 1]]
    };
    let pixels = render(&bench, &figure(STRAIGHT, "", object), &[]);
    for (found, exact) in covered(&pixels).into_iter().zip([171, 852, 192, 575]) {
        // Half of the edge's stroke lies outside.
        assert!(found.abs_diff(exact) <= 2, "{found} for {exact}");
    }
    // A picture of another size is the same image scaled, with its own aspect.
    let pixels = render(&bench, &figure(STRAIGHT, "", object), &["--size", "512x384"]);
    for (found, exact) in covered(&pixels).into_iter().zip([85, 426, 96, 287]) {
        assert!(found.abs_diff(exact) <= 2, "{found} for {exact}");
    }
    // As the eye would see it: a square is a square, in the middle of the picture, with its border at 224 and 800.
    let (_, _, rgb) = render(&bench, &figure(STRAIGHT, "undistorted = true", object), &[]);
    let row = &rgb[1024 * 384..][..1024];
    let seen: Vec<usize> = (230..794).filter(|&x| row[x] != rgb[1024 * 20 + 512]).collect();
    assert!(seen[0].abs_diff(512 - 192) <= 2 && seen.len().abs_diff(384) <= 4, "{} … {}", seen[0], seen.len());
}
