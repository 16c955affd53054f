//! A trajectory of `Open3D`, `.log`: for each pose a line of three whole numbers, and four lines of a matrix.
//!
//! <https://www.open3d.org/docs/release/python_api/open3d.io.read_pinhole_camera_trajectory.html>: the matrix leads
//! from the camera to the world, in the axes of `OpenCV`.

use crate::camera::recovery::entries::{MatrixEntries, Written};
use crate::camera::recovery::text::Pasted;
use crate::camera::recovery::{Axes, MatrixKind, Order};

/// The lines of one pose.
const LINES: usize = 5;

/// The poses of a text, if it has nothing else.
pub(crate) fn cameras(text: &str) -> Option<Vec<Pasted>> {
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
