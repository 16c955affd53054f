//! The depth of what is seen at each pixel.

use super::fill::unpack_slope;
use super::setup::STEPS;

/// Depth per pixel, greater is nearer.
///
/// A pixel with several samples is represented by its first; [`offset`](Self::offset) tells where that lies.
#[derive(Clone, Debug, Default)]
pub struct DepthBuffer {
    width: usize,
    height: usize,
    /// Place of the values relative to the pixel centres, in pixels.
    offset: [f32; 2],
    /// Rows of a band, and values from one row to the next.
    rows: usize,
    pitch: usize,
    bands: Vec<BandDepth>,
}

/// The part of a depth buffer that belongs to one band of rows.
#[derive(Clone, Debug, Default)]
pub(super) struct BandDepth {
    /// Whether anything was drawn; if not, what the arrays hold is of an older picture.
    pub(super) used: bool,
    /// −∞ where there is no surface.
    pub(super) values: Vec<f32>,
    /// Change of the depth per pixel to the right and down on the face that is seen, packed; empty where nobody asked.
    pub(super) slopes: Vec<u32>,
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
    pub(super) fn reset(&mut self, [width, height]: [usize; 2], offset: [i32; 2], rows: usize, pitch: usize) {
        (self.width, self.height, self.rows, self.pitch) = (width, height, rows, pitch);
        self.offset = offset.map(|v| v as f32 / STEPS as f32);
        self.bands.resize_with(height.div_ceil(rows), BandDepth::default);
        for band in &mut self.bands {
            band.used = false;
        }
    }

    /// The parts of the bands, from above.
    pub(super) fn bands_mut(&mut self) -> &mut [BandDepth] {
        &mut self.bands
    }

    /// The depth at a pixel and the slope of the face there.
    fn value(&self, x: usize, y: usize) -> Option<(f32, [f32; 2])> {
        let band = self.bands.get(y / self.rows).filter(|band| band.used && x < self.width)?;
        let index = (y % self.rows) * self.pitch + x;
        let depth = *band.values.get(index)?;
        let slope = band.slopes.get(index).map_or([0.0; 2], |&packed| unpack_slope(packed));
        (depth > f32::NEG_INFINITY).then_some((depth, slope))
    }

    /// True where no surface was drawn.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.bands.iter().any(|band| band.used)
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
        (y < self.height).then(|| self.value(x, y))?.map(|(depth, _)| depth)
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
        let Some((depth, [dx, dy])) = self.value(i as usize, j as usize) else { return Some(None) };
        Some(Some(Face { depth: depth + dx * (x - i - 0.5) + dy * (y - j - 0.5), slope: dx.abs() + dy.abs() }))
    }
}
