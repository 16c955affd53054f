//! `cameras.txt` and `images.txt` of COLMAP, one after the other or alone.
//!
//! <https://colmap.github.io/format.html>: the pose leads from the world to the camera, in the axes of `OpenCV`.

use glam::DVec3;

use crate::camera::ImageSize;
use crate::camera::recovery::entries::{MatrixEntries, Written};
use crate::camera::recovery::text::{GivenLens, Pasted, of_quaternion, side};
use crate::camera::recovery::{Axes, MatrixKind, Order};

/// A line of `cameras.txt`.
struct Lens<'a> {
    id: &'a str,
    image: Option<ImageSize>,
    lens: GivenLens,
}

/// The cameras of a text, if it is one of COLMAP's files.
pub(crate) fn cameras(text: &str) -> Option<Vec<Pasted>> {
    let lines = || text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let lenses: Vec<Lens<'_>> = lines().filter_map(lens).collect();
    let poses: Vec<Pasted> = lines().filter_map(|line| image(line, &lenses)).collect();
    if !poses.is_empty() {
        return Some(poses);
    }
    let alone = lenses.iter().map(|lens| Pasted {
        name: lens.id.to_owned(),
        entries: None,
        word: None,
        lens: Some(lens.lens),
        image: lens.image,
    });
    let alone: Vec<Pasted> = alone.collect();
    (!alone.is_empty()).then_some(alone)
}

/// `CAMERA_ID MODEL WIDTH HEIGHT PARAMS…`. Distortion is left out.
fn lens(line: &str) -> Option<Lens<'_>> {
    let mut parts = line.split_whitespace();
    let (id, model) = (parts.next()?, parts.next()?);
    let numbers: Vec<f64> = parts.map(str::parse).collect::<Result<_, _>>().ok()?;
    let [width, height, parameters @ ..] = numbers.as_slice() else { return None };
    let pixels = |f_x, f_y, x, y| GivenLens::Pixels { focal_lengths: [f_x, f_y], principal_point: [x, y] };
    let lens = match (model, parameters) {
        ("SIMPLE_PINHOLE" | "SIMPLE_RADIAL" | "RADIAL" | "SIMPLE_RADIAL_FISHEYE" | "RADIAL_FISHEYE", [f, x, y, ..]) => {
            pixels(*f, *f, *x, *y)
        }
        ("PINHOLE" | "OPENCV" | "OPENCV_FISHEYE" | "FULL_OPENCV" | "FOV" | "THIN_PRISM_FISHEYE", [f, g, x, y, ..]) => {
            pixels(*f, *g, *x, *y)
        }
        _ => return None,
    };
    let image = side(*width).zip(side(*height)).map(|(width, height)| ImageSize { width, height });
    Some(Lens { id, image, lens })
}

/// `IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME`.
fn image(line: &str, lenses: &[Lens<'_>]) -> Option<Pasted> {
    let parts: Vec<&str> = line.split_whitespace().collect();
    let [id, numbers @ .., camera, name] = parts.as_slice() else { return None };
    id.parse::<u32>().ok()?;
    camera.parse::<u32>().ok()?;
    // A line of points has numbers only.
    if numbers.len() != 7 || name.parse::<f64>().is_ok() {
        return None;
    }
    let numbers: Vec<f64> = numbers.iter().map(|part| part.parse()).collect::<Result<_, _>>().ok()?;
    let [w, x, y, z, t @ ..] = numbers.as_slice() else { return None };
    let matrix = of_quaternion([*w, *x, *y, *z], DVec3::from_slice(t));
    let entries = (0..16).map(|k| Written { value: matrix.row(k / 4)[k % 4], error: 0.0 }).collect();
    let entries = MatrixEntries::new(entries, Some(4))?;
    let lens = lenses.iter().find(|lens| lens.id == *camera);
    let pose = Pasted::pose(name, entries, MatrixKind::View, Axes::OPENCV, (Order::Rows, "images.txt"));
    Some(Pasted { lens: lens.map(|lens| lens.lens), image: lens.and_then(|lens| lens.image), ..pose })
}
