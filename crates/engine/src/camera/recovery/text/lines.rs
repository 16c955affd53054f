//! Files of one record in a line, or in a few: COLMAP, and trajectories of `Open3D`.

use glam::DVec3;

use crate::camera::recovery::entries::{MatrixEntries, Written};
use crate::camera::recovery::text::{GivenLens, Pasted, image_size, of_quaternion};
use crate::camera::recovery::{Axes, MatrixKind, Order};

/// The cameras of `cameras.txt` and `images.txt` of COLMAP, one after the other or alone.
///
/// <https://colmap.github.io/format.html>: the pose leads from the world to the camera, in the axes of `OpenCV`.
pub(crate) fn colmap(text: &str) -> Option<Vec<Pasted>> {
    let lines = || text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let lenses: Vec<Pasted> = lines().filter_map(lens).collect();
    let poses: Vec<Pasted> = lines().filter_map(|line| image(line, &lenses)).collect();
    Some(if poses.is_empty() { lenses } else { poses }).filter(|cameras| !cameras.is_empty())
}

/// `CAMERA_ID MODEL WIDTH HEIGHT PARAMS…`. Distortion is left out.
fn lens(line: &str) -> Option<Pasted> {
    let mut parts = line.split_whitespace();
    let (id, model) = (parts.next()?, parts.next()?);
    let numbers: Vec<f64> = parts.map(str::parse).collect::<Result<_, _>>().ok()?;
    let [width, height, parameters @ ..] = numbers.as_slice() else { return None };
    let lens = match (model, parameters) {
        ("SIMPLE_PINHOLE" | "SIMPLE_RADIAL" | "RADIAL" | "SIMPLE_RADIAL_FISHEYE" | "RADIAL_FISHEYE", [f, x, y, ..]) => {
            GivenLens::pixels([*f, *f], [*x, *y])
        }
        ("PINHOLE" | "OPENCV" | "OPENCV_FISHEYE" | "FULL_OPENCV" | "FOV" | "THIN_PRISM_FISHEYE", [f, g, x, y, ..]) => {
            GivenLens::pixels([*f, *g], [*x, *y])
        }
        _ => return None,
    };
    Some(Pasted::lens(id, lens, image_size(*width, *height)))
}

/// `IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME`.
fn image(line: &str, lenses: &[Pasted]) -> Option<Pasted> {
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
    let entries = MatrixEntries::of_matrix(matrix, 0.0);
    let lens = lenses.iter().find(|lens| lens.name == *camera);
    let pose = Pasted::pose(name, entries, MatrixKind::View, Axes::OPENCV, (Order::Rows, "images.txt"));
    Some(Pasted { lens: lens.and_then(|lens| lens.lens), image: lens.and_then(|lens| lens.image), ..pose })
}

/// The lines of one pose.
const LINES: usize = 5;

/// The poses of a trajectory of `Open3D`, `.log`, if the text has nothing else: for each pose a line of three whole
/// numbers, and four lines of a matrix.
///
/// <https://www.open3d.org/docs/release/python_api/open3d.io.read_pinhole_camera_trajectory.html>: the matrix leads
/// from the camera to the world, in the axes of `OpenCV`.
pub(crate) fn trajectory(text: &str) -> Option<Vec<Pasted>> {
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    if lines.is_empty() || !lines.len().is_multiple_of(LINES) {
        return None;
    }
    lines.chunks(LINES).map(pose).collect()
}

fn pose(lines: &[&str]) -> Option<Pasted> {
    let (head, rows) = lines.split_first()?;
    let head: Vec<&str> = head.split_whitespace().collect();
    if head.len() != 3 || head.iter().any(|number| number.parse::<u32>().is_err()) {
        return None;
    }
    let mut entries = Vec::new();
    for row in rows {
        let before = entries.len();
        entries.extend(row.split_whitespace().map(|part| part.parse().ok()).collect::<Option<Vec<f64>>>()?);
        if entries.len() != before + 4 {
            return None;
        }
    }
    // Eigen prints about eight digits.
    let written = |value: f64| Written { value, error: 1e-8 * value.abs().max(1.0) };
    let entries = MatrixEntries::new(entries.into_iter().map(written).collect(), Some(4))?;
    Some(Pasted::pose(head[0], entries, MatrixKind::CameraToWorld, Axes::OPENCV, (Order::Rows, ".log")))
}
