//! The depth of the visible surface at each pixel.
//!
//! A z-buffer keeps the depth of a pixel. Strokes lie on faces, so they'd be hidden and visible by turns where rounding
//! decides. Here the slope of the visible face is kept too, and a point is compared with the face's plane in the four
//! pixels around it, at once.

use std::ops::Range;

use super::grid::STEPS;
use crate::appearance::Occlusion;
use crate::drawing::order::{ON_A_FACE, same_depth};
use crate::simd::prelude::*;
use crate::simd::with_vectors;

/// Depth per pixel, greater is nearer.
///
/// A pixel with several samples is represented by its first; [`offset`](Self::offset) tells where that lies.
#[derive(Clone, Debug, Default)]
pub struct DepthBuffer {
    width: usize,
    height: usize,
    /// Place of the values relative to the pixel centres, in pixels.
    offset: [f32; 2],
    /// Rows of a band, as the exponent of 2, and values from one row to the next.
    rows_log: u32,
    pitch: usize,
    bands: Vec<BandDepth>,
    /// From one stored depth to the next if they're whole numbers, else 0.
    pub(super) step: f32,
}

/// The part of a depth buffer that belongs to one band of rows.
#[derive(Clone, Debug, Default)]
pub(super) struct BandDepth {
    /// The columns that may have a surface. Elsewhere the arrays hold an older picture.
    pub(super) columns: Range<usize>,
    /// −∞ if there is no surface.
    pub(super) values: Vec<f32>,
    /// Change of the depth per pixel to the right and down on the visible face, packed. Empty unless requested.
    pub(super) slopes: Vec<u32>,
}

impl DepthBuffer {
    /// Fits the buffer to a picture in bands of `rows` (a power of two), and empties it.
    pub(super) fn reset(&mut self, [width, height]: [usize; 2], offset: [i32; 2], rows: usize, pitch: usize) {
        (self.width, self.height, self.rows_log, self.pitch) = (width, height, rows.ilog2(), pitch);
        self.offset = offset.map(|v| v as f32 / STEPS as f32);
        self.bands.resize_with(height.div_ceil(rows), BandDepth::default);
        for band in &mut self.bands {
            band.columns = 0..0;
        }
    }

    /// Takes the depths of a whole picture, row by row, and the slopes if requested.
    pub(super) fn store(&mut self, depths: &[f32], slopes: Option<&[[f32; 2]]>) {
        let (width, pitch) = (self.width, self.pitch);
        let rows = width << self.rows_log;
        for (k, (band, depths)) in self.bands.iter_mut().zip(depths.chunks(rows)).enumerate() {
            let count = depths.len() / width;
            let is_empty = depths.iter().all(|depth| *depth == f32::NEG_INFINITY);
            band.columns = if is_empty { 0..0 } else { 0..width };
            band.values.resize(band.values.len().max((count + 1) * pitch), f32::NEG_INFINITY);
            for (row, depths) in depths.chunks(width).enumerate() {
                band.values[row * pitch..][..width].copy_from_slice(depths);
            }
            band.slopes.resize(if slopes.is_some() { (count + 1) * pitch } else { 0 }, 0);
            for (n, &[dx, dy]) in slopes.unwrap_or_default().iter().skip(k * rows).take(count * width).enumerate() {
                band.slopes[n / width * pitch + n % width] = pack_slope(dx, dy);
            }
        }
    }

    /// The parts of the bands, from above.
    pub(super) fn bands_mut(&mut self) -> &mut [BandDepth] {
        &mut self.bands
    }

    /// The depth at a pixel and the packed slope of the face there.
    #[inline]
    fn value(&self, x: usize, y: usize) -> Option<(f32, u32)> {
        let band = self.bands.get(y >> self.rows_log).filter(|band| band.columns.contains(&x))?;
        let index = (y - (y >> self.rows_log << self.rows_log)) * self.pitch + x;
        let depth = *band.values.get(index)?;
        (depth > f32::NEG_INFINITY).then(|| (depth, band.slopes.get(index).copied().unwrap_or_default()))
    }

    /// Takes all depths, row by row. −∞ means that no surface was drawn. Each band gives its memory back when its
    /// depths are copied.
    pub(super) fn take_values(&mut self) -> Vec<f32> {
        let mut values = Vec::with_capacity(self.width * self.height);
        for (k, band) in self.bands.iter_mut().enumerate() {
            let Range { start, end } = std::mem::take(&mut band.columns);
            let depths = std::mem::take(&mut band.values);
            let first_row = k << self.rows_log;
            for row in 0..(self.height - first_row).min(1 << self.rows_log) {
                let first = row * self.pitch;
                values.resize(values.len() + start, f32::NEG_INFINITY);
                values.extend_from_slice(depths.get(first + start..first + end).unwrap_or_default());
                values.resize((first_row + row + 1) * self.width, f32::NEG_INFINITY);
            }
        }
        values
    }

    /// True if no surface was drawn.
    pub fn is_empty(&self) -> bool {
        self.bands.iter().all(|band| band.columns.is_empty())
    }

    /// The point of its pixel at which a depth was taken, relative to the pixel's centre, in pixels: (0, 0) without
    /// antialiasing.
    pub fn offset(&self) -> [f32; 2] {
        self.offset
    }

    /// Depth of the surface at a pixel, as in the drawing. `None` if no surface was drawn, or outside.
    pub fn at(&self, x: u32, y: u32) -> Option<f32> {
        let (x, y) = (x as usize, y as usize);
        (y < self.height).then(|| self.value(x, y))?.map(|(depth, _)| depth)
    }

    /// True if a point (pixels and depth) can be seen, because no face hides it. A point **on** a face can be seen.
    ///
    /// The four pixels around the point are tested, and one that has nothing in front of the point is enough. An edge
    /// belongs to the faces on both of its sides, and the border of a face between two pixels isn't known. So a point
    /// hidden by less than two pixels is seen. Faces' planes are followed from the points where their depths were
    /// taken, so that a steep face doesn't hide the lines on it, in the corner of a room as little as on an edge.
    /// Depths in whole numbers are known to a step.
    pub(super) fn shows(&self, p: [f32; 3]) -> bool {
        with_vectors!(simd => self.show(simd, p))
    }

    /// [`shows`](Self::shows) for some points.
    fn shows_each(&self, points: &[[f32; 3]], shown: &mut [bool]) {
        with_vectors!(simd => {
            for (shown, &p) in shown.iter_mut().zip(points) {
                *shown = self.show(simd, p);
            }
        });
    }

    /// [`shows`](Self::shows) with vectors.
    #[inline(always)]
    fn show<K: Simd>(&self, simd: K, p: [f32; 3]) -> bool {
        let [x, y] = [p[0] - self.offset[0] - 0.5, p[1] - self.offset[1] - 0.5];
        let (i, j) = (floor(x), floor(y));
        let (left, top) = (x - i as f32, y - j as f32);
        let (right, bottom) = (x - (i + 1) as f32, y - (j + 1) as f32);
        let (across, down) = ([left, right, left, right], [top, top, bottom, bottom]);
        let around = |(depths, slopes)| Around { depths, slopes, across, down };
        match self.four(i, j).or_else(|| self.four_at_border(i, j)) {
            Some(four) => around(four).show(simd, p, self.step),
            None => true,
        }
    }

    /// Depths and packed slopes of a pixel, the one to its right, and the two below. `None` if they aren't all in one
    /// band of the picture, where surfaces may be.
    #[inline(always)]
    fn four(&self, i: i32, j: i32) -> Option<([f32; 4], [u32; 4])> {
        let (column, row) = (usize::try_from(i).ok()?, usize::try_from(j).ok()?);
        let band = row >> self.rows_log;
        if row + 1 >= self.height || (row + 1) >> self.rows_log != band {
            return None;
        }
        let start = (row - (band << self.rows_log)) * self.pitch + column;
        let band = self.bands.get(band)?;
        if column < band.columns.start || column + 1 >= band.columns.end {
            return None;
        }
        let (above, below) = (band.values.get(start..start + 2)?, band.values.get(start + self.pitch..)?.get(..2)?);
        let mut slopes = [0; 4];
        if !band.slopes.is_empty() {
            let (above, below) = (band.slopes.get(start..start + 2)?, band.slopes.get(start + self.pitch..)?.get(..2)?);
            slopes = [above[0], above[1], below[0], below[1]];
        }
        Some(([above[0], above[1], below[0], below[1]], slopes))
    }

    /// The same at a border, where a pixel outside the picture shows nothing. `None` if a pixel has no surface, or all
    /// are outside, so that nothing hides the point.
    fn four_at_border(&self, i: i32, j: i32) -> Option<([f32; 4], [u32; 4])> {
        let (mut depths, mut slopes, mut is_inside) = ([f32::INFINITY; 4], [0; 4], false);
        for (k, (i, j)) in [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].into_iter().enumerate() {
            let (Ok(column), Ok(row)) = (usize::try_from(i), usize::try_from(j)) else { continue };
            if column < self.width && row < self.height {
                (depths[k], slopes[k]) = self.value(column, row)?;
                is_inside = true;
            }
        }
        is_inside.then_some((depths, slopes))
    }
}

/// Four pixels around a point.
struct Around {
    /// ∞ outside the picture.
    depths: [f32; 4],
    /// Packed.
    slopes: [u32; 4],
    /// The way from each pixel to the point.
    across: [f32; 4],
    down: [f32; 4],
}

impl Around {
    /// True if any has nothing in front of the point. The plane of its face is no nearer there than
    /// [`on_a_face`](crate::drawing::order::on_a_face) allows.
    #[inline(always)]
    fn show<K: Simd>(&self, simd: K, p: [f32; 3], step: f32) -> bool {
        let (depth, packed) = (f32x4::from_slice(simd, &self.depths), u32x4::from_slice(simd, &self.slopes));
        let dx = (packed & 0xffff_0000).bitcast::<f32x4<K>>();
        let dy = (packed << 16).bitcast::<f32x4<K>>();
        let (across, down) = (f32x4::from_slice(simd, &self.across), f32x4::from_slice(simd, &self.down));
        let plane = depth + dx * across + dy * down;
        let on_the_face = (dx.abs() + dy.abs()) * ON_A_FACE + same_depth(p[2]);
        let shown = plane.simd_le(on_the_face + p[2] + step);
        (shown | !depth.simd_gt(f32::NEG_INFINITY)).any_true()
    }
}

/// The depths that are compared with strokes and marks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Occluders<'a> {
    /// Depths of opaque surfaces.
    pub(super) opaque: &'a DepthBuffer,
    /// Depths of tints, if there are any.
    pub(super) tints: Option<&'a DepthBuffer>,
}

impl Occluders<'_> {
    /// True if they hide nothing.
    pub(super) fn is_empty(&self) -> bool {
        self.opaque.is_empty() && self.tints.is_none()
    }

    /// The faces in front of a point (pixels and depth).
    pub(super) fn before(&self, p: [f32; 3]) -> Occlusion {
        if !self.opaque.shows(p) {
            Occlusion::Opaque
        } else if self.tints.is_some_and(|tints| !tints.shows(p)) {
            Occlusion::Translucent
        } else {
            Occlusion::None
        }
    }

    /// [`before`](Self::before) for some points, [`MAX_POINTS`] at most.
    pub(super) fn before_each(&self, points: &[[f32; 3]], before: &mut [Occlusion]) {
        let mut shown = [[true; MAX_POINTS]; 2];
        self.opaque.shows_each(points, &mut shown[0]);
        if let Some(tints) = self.tints {
            tints.shows_each(points, &mut shown[1]);
        }
        for (k, before) in before.iter_mut().enumerate().take(MAX_POINTS) {
            *before = match [shown[0][k], shown[1][k]] {
                [false, _] => Occlusion::Opaque,
                [_, false] => Occlusion::Translucent,
                _ => Occlusion::None,
            };
        }
    }
}

/// Points that are compared with the faces before them together.
pub(super) const MAX_POINTS: usize = 32;

/// The whole number below. The library's function is slow on processors for which no instruction may be assumed.
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates, short of the last number")]
fn floor(v: f32) -> i32 {
    let whole = v.clamp(-1e9, 1e9) as i32;
    whole - i32::from(whole as f32 > v)
}

/// Two slopes as the upper halves of two `f32`. Their 8 bits are enough, and round towards 0 by 1/128 at most.
pub(super) fn pack_slope(dx: f32, dy: f32) -> u32 {
    (dx.to_bits() & 0xffff_0000) | dy.to_bits() >> 16
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::drawing::order::on_a_face;

    /// [`DepthBuffer::shows`], pixel by pixel.
    fn is_shown(buffer: &DepthBuffer, p: [f32; 3]) -> bool {
        let [x, y] = [p[0] - buffer.offset[0] - 0.5, p[1] - buffer.offset[1] - 0.5];
        let (i, j) = (floor(x), floor(y));
        let mut inside = false;
        for (i, j) in [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)] {
            let (Ok(column), Ok(row)) = (usize::try_from(i), usize::try_from(j)) else { continue };
            if column >= buffer.width || row >= buffer.height {
                continue;
            }
            let Some((depth, packed)) = buffer.value(column, row) else { return true };
            let [dx, dy] = [f32::from_bits(packed & 0xffff_0000), f32::from_bits(packed << 16)];
            if depth + dx * (x - i as f32) + dy * (y - j as f32) <= p[2] + on_a_face(p[2], [dx, dy]) + buffer.step {
                return true;
            }
            inside = true;
        }
        !inside
    }

    proptest! {
        #[test]
        fn four_pixels_at_once_show_what_each_shows(
            values in prop::collection::vec(prop_oneof![Just(f32::NEG_INFINITY), 0.0..1.0_f32], 7 * 6),
            slopes in prop::collection::vec([-0.3..0.3_f32, -0.3..0.3], 7 * 6),
            points in prop::collection::vec([-2.0..8.0_f32, -2.0..9.0, 0.0..1.0], 1..MAX_POINTS),
            (with_slopes, columns, step) in (any::<bool>(), [0..5_usize, 0..6], prop_oneof![Just(0.0_f32), Just(0.01)]),
        ) {
            let slopes: Vec<u32> = slopes.into_iter().map(|[dx, dy]| pack_slope(dx, dy)).collect();
            // Two bands of four rows, of which the picture has six.
            let band = |first: usize, columns| BandDepth {
                columns,
                values: values[first..].to_vec(),
                slopes: if with_slopes { slopes[first..].to_vec() } else { Vec::new() },
            };
            let buffer = DepthBuffer {
                width: 5,
                height: 6,
                offset: [0.125, -0.375],
                rows_log: 2,
                pitch: 7,
                bands: vec![band(0, 0..5), band(7, columns[0]..columns[1])],
                step,
            };
            let mut shown = [false; MAX_POINTS];
            buffer.shows_each(&points, &mut shown);
            for (&point, shown) in points.iter().zip(shown) {
                prop_assert_eq!(shown, is_shown(&buffer, point), "{:?}", point);
                prop_assert_eq!(shown, buffer.shows(point), "{:?}", point);
            }
        }
    }
}
