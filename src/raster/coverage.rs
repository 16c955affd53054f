//! How much of each pixel a set of strokes covers.
//!
//! All pieces of a set meet in one mask, each pixel keeping the greatest share, and the mask is laid on the picture at once:
//! pieces may overlap (joints, crossings, arrow heads) without a translucent colour growing darker there.

use std::ops::Range;

use crate::appearance::Rgba;

use super::pixel::{over, premultiply, scale};

/// A mask for some rows of a picture, cleared where it was used.
#[derive(Clone, Debug, Default)]
pub(super) struct Coverage {
    width: usize,
    /// The rows of the picture.
    first: usize,
    end: usize,
    shares: Vec<u8>,
    /// For each row the columns that were touched: first and end.
    rows: Vec<(u32, u32)>,
    /// The rows that were touched, counted from `first`.
    touched: Range<usize>,
}

const UNTOUCHED: (u32, u32) = (u32::MAX, 0);
/// Pixels that are looked at together whether the mask covers any.
const BLOCK: usize = 32;

impl Coverage {
    /// Makes the mask fit some rows of a picture.
    pub(super) fn fit(&mut self, width: usize, rows: Range<usize>) {
        if (self.width, self.rows.len()) != (width, rows.len()) {
            self.shares.clear();
            self.shares.resize(width * rows.len(), 0);
            self.rows.clear();
            self.rows.resize(rows.len(), UNTOUCHED);
        }
        (self.width, self.first, self.end) = (width, rows.start, rows.end);
    }

    /// Covers what lies within `radius` of the segment a–b: a stroke with round ends. A stroke thinner than a pixel covers it
    /// in part.
    pub(super) fn capsule(&mut self, a: [f32; 2], b: [f32; 2], radius: f32) {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        let reach = radius + 0.5;
        if !(length.is_finite() && reach > 0.5) {
            return;
        }
        let (ux, uy) = if length > 1e-6 { (dx / length, dy / length) } else { (1.0, 0.0) };
        let (left, right) = (a[0].min(b[0]) - reach, a[0].max(b[0]) + reach);
        for j in pixels(a[1].min(b[1]) - reach, a[1].max(b[1]) + reach, self.first..self.end) {
            let y = center(j) - a[1];
            // Along the row the distance to the line grows by |uy| a pixel.
            let (mut from, mut to) = (left, right);
            if uy.abs() > 1e-3 {
                let (middle, half) = (a[0] + y * ux / uy, reach / uy.abs());
                (from, to) = (from.max(middle - half), to.min(middle + half));
            }
            self.row(j, from, to, |x| {
                let x = x - a[0];
                let along = x * ux + y * uy;
                let beside = x * uy - y * ux;
                let beyond = (-along).max(along - length).max(0.0);
                overlap((beside * beside + beyond * beyond).sqrt(), radius)
            });
        }
    }

    /// Covers a triangle.
    pub(super) fn triangle(&mut self, corners: [[f32; 2]; 3]) {
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if !area.is_finite() || area.abs() < 1e-3 {
            return;
        }
        let edges = [(a, b), (b, c), (c, a)].map(|(p, q)| {
            let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
            let scale = area.signum() / dx.hypot(dy);
            (p, dx * scale, dy * scale)
        });
        let low = |k: usize| a[k].min(b[k]).min(c[k]) - 0.5;
        let high = |k: usize| a[k].max(b[k]).max(c[k]) + 0.5;
        for j in pixels(low(1), high(1), self.first..self.end) {
            let y = center(j);
            self.row(j, low(0), high(0), |x| {
                let inside = |(p, dx, dy): ([f32; 2], f32, f32)| dx * (y - p[1]) - dy * (x - p[0]);
                let depth = inside(edges[0]).min(inside(edges[1])).min(inside(edges[2]));
                (depth + 0.5).clamp(0.0, 1.0)
            });
        }
    }

    /// Raises the shares of a row between two abscissae to what `share` says for each pixel centre.
    fn row(&mut self, j: usize, from: f32, to: f32, share: impl Fn(f32) -> f32) {
        let columns = pixels(from, to, 0..self.width);
        if columns.is_empty() {
            return;
        }
        let j = j - self.first;
        let touched = &mut self.rows[j];
        self.touched =
            if self.touched.is_empty() { j..j + 1 } else { self.touched.start.min(j)..self.touched.end.max(j + 1) };
        #[expect(clippy::cast_possible_truncation, reason = "sides are at most 16384")]
        let (first, end) = (columns.start as u32, columns.end as u32);
        *touched = (touched.0.min(first), touched.1.max(end));
        for i in columns {
            #[expect(clippy::cast_possible_truncation, reason = "a share is 0 … 1")]
            let share = (share(center(i)) * 255.0 + 0.5) as u8;
            let pixel = &mut self.shares[j * self.width + i];
            *pixel = share.max(*pixel);
        }
    }

    /// Lays the colour on `pixels` (the rows of the mask) wherever the mask covers them, and clears the mask.
    pub(super) fn lay(&mut self, pixels: &mut [[u8; 4]], color: Rgba) {
        let source = premultiply(color);
        for j in std::mem::take(&mut self.touched) {
            let (first, end) = std::mem::replace(&mut self.rows[j], UNTOUCHED);
            if first >= end {
                continue;
            }
            let range = j * self.width + first as usize..j * self.width + end as usize;
            let (shares, pixels) = (&mut self.shares[range.clone()], &mut pixels[range]);
            for (shares, pixels) in shares.chunks_mut(BLOCK).zip(pixels.chunks_mut(BLOCK)) {
                // Between the strokes of a set most is empty.
                if shares.iter().fold(0, |all, &share| all | share) == 0 {
                    continue;
                }
                for (share, pixel) in shares.iter_mut().zip(pixels) {
                    match std::mem::take(share) {
                        0 => {}
                        s => *pixel = over(scale(source, u32::from(s)), u32::from_le_bytes(*pixel)).to_le_bytes(),
                    }
                }
            }
        }
    }
}

/// The share of a pixel that a stroke of this half width covers, `distance` from its middle line.
fn overlap(distance: f32, radius: f32) -> f32 {
    (radius.min(distance + 0.5) - (-radius).max(distance - 0.5)).clamp(0.0, 1.0)
}

fn center(i: usize) -> f32 {
    i as f32 + 0.5
}

/// The pixels of a range whose centres lie between two abscissae.
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates; NaN gives nothing")]
fn pixels(from: f32, to: f32, range: Range<usize>) -> Range<usize> {
    let first = (from - 0.5).ceil().max(0.0) as usize;
    let end = (to + 0.5).floor().max(0.0) as usize;
    first.max(range.start)..end.min(range.end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_stroke_covers_exactly_its_width() {
        for (y, width, expected) in [
            (3.5, 1.0, [0, 255, 0]),
            (3.0, 1.0, [128, 128, 0]),
            (3.5, 2.0, [128, 255, 128]),
            (3.5, 0.5, [0, 128, 0]),
            (3.75, 1.0, [0, 191, 64]),
        ] {
            let mut mask = Coverage::default();
            mask.fit(20, 0..8);
            mask.capsule([3.0, y], [17.0, y], width / 2.0);
            let column: [u8; 3] = std::array::from_fn(|j| mask.shares[(j + 2) * 20 + 10]);
            assert_eq!(column, expected, "y = {y}, width = {width}");
        }
    }

    #[test]
    fn a_stroke_covers_its_area_at_any_angle() {
        for degrees in [0.0_f32, 10.0, 30.0, 45.0, 77.0, 90.0] {
            let mut mask = Coverage::default();
            mask.fit(100, 0..100);
            let (s, c) = degrees.to_radians().sin_cos();
            mask.capsule([50.3 - 40.0 * c, 50.1 - 40.0 * s], [50.3 + 40.0 * c, 50.1 + 40.0 * s], 1.25);
            let area = mask.shares.iter().map(|&s| f64::from(s) / 255.0).sum::<f64>();
            let exact = 80.0 * 2.5 + std::f64::consts::PI * 1.25 * 1.25;
            assert!((area - exact).abs() < 0.02 * exact, "{degrees}°: {area} instead of {exact}");
        }
    }

    #[test]
    fn a_triangle_covers_its_area() {
        for corners in [[[5.0, 5.0], [60.0, 12.0], [20.0, 50.0]], [[5.0, 5.0], [20.0, 50.0], [60.0, 12.0]]] {
            let mut mask = Coverage::default();
            mask.fit(70, 0..60);
            mask.triangle(corners);
            let area = mask.shares.iter().map(|&s| f64::from(s) / 255.0).sum::<f64>();
            assert!((area - 1185.0).abs() < 12.0, "{area}");
        }
    }

    #[test]
    fn what_is_outside_or_no_number_leaves_no_trace() {
        let mut mask = Coverage::default();
        mask.fit(10, 0..10);
        mask.capsule([-50.0, -50.0], [-20.0, 70.0], 2.0);
        mask.capsule([f32::NAN, 1.0], [5.0, 5.0], 2.0);
        mask.capsule([1.0, 1.0], [5.0, f32::INFINITY], 2.0);
        mask.capsule([1.0, 1.0], [5.0, 5.0], f32::NAN);
        mask.capsule([1.0, 1.0], [5.0, 5.0], -1.0);
        mask.triangle([[f32::NAN, 0.0], [5.0, 5.0], [0.0, 5.0]]);
        assert!(mask.shares.iter().all(|&s| s == 0));
    }

    #[test]
    fn overlapping_pieces_darken_nothing() {
        let mut pixels = [[0; 4]; 20 * 5];
        let mut mask = Coverage::default();
        mask.fit(20, 0..5);
        mask.capsule([2.0, 2.5], [12.0, 2.5], 1.0);
        mask.capsule([8.0, 2.5], [18.0, 2.5], 1.0);
        mask.lay(&mut pixels, Rgba::rgba(255, 255, 255, 128));
        let alpha = |i: usize| pixels[2 * 20 + i][3];
        assert_eq!((alpha(5), alpha(10), alpha(15)), (128, 128, 128));
        assert!(mask.shares.iter().all(|&s| s == 0));
    }

    #[test]
    fn some_rows_get_what_all_rows_would() {
        let draw = |mask: &mut Coverage| {
            mask.capsule([2.3, 1.7], [17.1, 18.9], 1.3);
            mask.triangle([[3.0, 15.0], [9.0, 2.0], [18.0, 12.0]]);
        };
        let mut whole = Coverage::default();
        whole.fit(20, 0..20);
        draw(&mut whole);
        let mut part = Coverage::default();
        part.fit(20, 7..12);
        draw(&mut part);
        assert_eq!(part.shares, whole.shares[7 * 20..12 * 20]);
    }
}
