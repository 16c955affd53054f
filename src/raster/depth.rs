//! The depth of what is seen at each pixel.

use super::fill::unpack_slope;
use super::setup::STEPS;

/// Depth per pixel, greater is nearer; −∞ where no surface was drawn.
///
/// A pixel with several samples is represented by its first; [`offset`](Self::offset) tells where that lies.
#[derive(Clone, Debug, Default)]
pub struct DepthBuffer {
    width: usize,
    height: usize,
    /// Place of the values relative to the pixel centres, in pixels.
    offset: [f32; 2],
    /// Rows of a band.
    rows: usize,
    /// For each band whether anything was drawn in it; where not, what the other arrays hold is of an older picture.
    used: Vec<bool>,
    values: Vec<f32>,
    /// Change of the depth per pixel to the right and down on the face that is seen, packed; empty where nobody asked.
    slopes: Vec<u32>,
}

/// The part of a depth buffer that belongs to one band.
pub(super) struct BandDepth<'a> {
    width: usize,
    used: &'a mut bool,
    values: &'a mut [f32],
    slopes: &'a mut [u32],
}

impl BandDepth<'_> {
    /// Copies the depths of the band, which stand `pitch` apart from row to row.
    pub(super) fn keep(&mut self, pitch: usize, depths: &[f32], slopes: Option<&Vec<u32>>) {
        *self.used = true;
        for (to, from) in self.values.chunks_exact_mut(self.width).zip(depths.chunks_exact(pitch)) {
            to.copy_from_slice(&from[..self.width]);
        }
        let slopes = slopes.map_or(&[][..], Vec::as_slice);
        for (to, from) in self.slopes.chunks_exact_mut(self.width).zip(slopes.chunks_exact(pitch)) {
            to.copy_from_slice(&from[..self.width]);
        }
    }
}

/// The face that is seen at a pixel: its plane.
#[derive(Clone, Copy, Debug)]
struct Face {
    /// Depth at the point asked for.
    depth: f32,
    /// Change over one pixel, in the worst direction.
    slope: f32,
}

impl DepthBuffer {
    /// Makes the buffer fit a picture in bands of `rows`, and empties it.
    pub(super) fn reset(&mut self, width: usize, height: usize, offset: [i32; 2], rows: usize, slopes: bool) {
        (self.width, self.height, self.rows) = (width, height, rows);
        let pixels = |v: i32| v as f32 / STEPS as f32;
        self.offset = offset.map(pixels);
        self.values.resize(width * height, f32::NEG_INFINITY);
        self.slopes.resize(if slopes { width * height } else { 0 }, 0);
        self.used.clear();
        self.used.resize(height.div_ceil(rows), false);
    }

    /// The parts of the bands, from above.
    pub(super) fn bands(&mut self) -> impl Iterator<Item = BandDepth<'_>> {
        let (width, length) = (self.width, self.rows * self.width);
        let mut slopes = self.slopes.chunks_mut(length);
        self.values.chunks_mut(length).zip(&mut self.used).map(move |(values, used)| {
            let slopes = slopes.next().unwrap_or_default();
            BandDepth { width, used, values, slopes }
        })
    }

    /// The depth at a pixel of the picture, −∞ where there is nothing.
    fn value(&self, x: usize, y: usize) -> f32 {
        if self.used[y / self.rows] { self.values[y * self.width + x] } else { f32::NEG_INFINITY }
    }

    /// True where no surface was drawn.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.used.contains(&true)
    }

    /// Where in its pixel a depth was taken, relative to the pixel's centre, in pixels: (0, 0) without antialiasing.
    #[must_use]
    pub fn offset(&self) -> [f32; 2] {
        self.offset
    }

    /// Depth of the surface at a pixel: 1 at the near plane, 0 at the far plane. `None` where no surface was drawn, or outside.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Option<f32> {
        let (x, y) = (x as usize, y as usize);
        (x < self.width && y < self.height).then(|| self.value(x, y)).filter(|z| z.is_finite())
    }

    /// True where a point (pixels and depth) can be seen: no face stands before it. A point **on** a face can be seen.
    ///
    /// The face's plane is followed from where its depth was taken to the point, so that a steep face does not hide the lines
    /// on it. Where the pixel of the point says "hidden" its neighbours are asked too: an edge belongs to faces on both sides,
    /// and at a silhouette the face may be steeper than one pixel can tell.
    pub(super) fn shows(&self, p: [f32; 3]) -> bool {
        let [x, y] = [p[0] - self.offset[0], p[1] - self.offset[1]];
        let Some(Some(own)) = self.face(x.floor(), y.floor(), x, y) else { return true };
        let base = 1e-4 * p[2].abs() + 1e-6;
        let tolerance = |face: Face| base + 0.02 * face.slope;
        if own.depth <= p[2] + tolerance(own) {
            return true;
        }
        let explained = own.depth - p[2] <= own.slope + base;
        let side = |v: f32| if v - v.floor() < 0.5 { -1.0 } else { 1.0 };
        let (sx, sy) = (side(x), side(y));
        [(sx, 0.0), (0.0, sy), (sx, sy)].into_iter().any(|(dx, dy)| {
            match self.face(x.floor() + dx, y.floor() + dy, x, y) {
                None => false,
                Some(None) => explained,
                Some(Some(face)) => {
                    let before = p[2] - face.depth;
                    before >= -tolerance(face) && (explained || before <= tolerance(face))
                }
            }
        })
    }

    /// The face seen at a pixel (whole numbers), followed to the point (x, y) (relative to [`offset`](Self::offset)).
    /// `None` outside of the picture, `Some(None)` where there is no face.
    #[expect(clippy::option_option, reason = "outside and empty are different answers")]
    fn face(&self, i: f32, j: f32, x: f32, y: f32) -> Option<Option<Face>> {
        let inside = i >= 0.0 && j >= 0.0 && i < self.width as f32 && j < self.height as f32;
        if !inside {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, reason = "checked just above")]
        let (column, row) = (i as usize, j as usize);
        let depth = self.value(column, row);
        if depth == f32::NEG_INFINITY {
            return Some(None);
        }
        let [dx, dy] = self.slopes.get(row * self.width + column).map_or([0.0; 2], |&packed| unpack_slope(packed));
        Some(Some(Face { depth: depth + dx * (x - i - 0.5) + dy * (y - j - 0.5), slope: dx.abs() + dy.abs() }))
    }
}
