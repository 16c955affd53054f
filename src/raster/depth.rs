//! The depth of what is seen at each pixel.

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
    /// Something was drawn.
    used: bool,
    values: Vec<f32>,
    /// Change of the depth per pixel to the right and down, on the face that is seen.
    slopes: Vec<[f32; 2]>,
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
    /// Makes the buffer fit and empties it.
    pub(super) fn reset(&mut self, width: usize, height: usize, offset: [i32; 2]) {
        (self.width, self.height, self.used) = (width, height, false);
        #[expect(clippy::cast_precision_loss, reason = "less than 256")]
        let pixels = |v: i32| v as f32 / STEPS as f32;
        self.offset = offset.map(pixels);
        self.values.clear();
        self.values.resize(width * height, f32::NEG_INFINITY);
        self.slopes.clear();
        self.slopes.resize(width * height, [0.0; 2]);
    }

    pub(super) fn set(&mut self, x: usize, y: usize, depth: f32, slope: [f32; 2]) {
        self.used = true;
        self.values[y * self.width + x] = depth;
        self.slopes[y * self.width + x] = slope;
    }

    /// True where no surface was drawn.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.used
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
        (x < self.width && y < self.height).then(|| self.values[y * self.width + x]).filter(|z| z.is_finite())
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
        #[expect(clippy::cast_precision_loss, reason = "sides are at most 16384")]
        let inside = i >= 0.0 && j >= 0.0 && i < self.width as f32 && j < self.height as f32;
        if !inside {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked just above")]
        let index = j as usize * self.width + i as usize;
        let depth = self.values[index];
        if depth == f32::NEG_INFINITY {
            return Some(None);
        }
        let [dx, dy] = self.slopes[index];
        Some(Some(Face { depth: depth + dx * (x - i - 0.5) + dy * (y - j - 0.5), slope: dx.abs() + dy.abs() }))
    }
}
