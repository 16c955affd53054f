//! Segments of strokes, eight at a time: the pixels around each, and their shares of these.
//!
//! The standard way fills the outline of a stroke, a polygon with arcs. Here the share of a pixel is a function of its
//! distance from the middle line. A stroke with round ends is all points within its half width of that line, and the
//! share is that of a band of the stroke's width. It's exact along level and upright strokes, and within a few
//! hundredths at any other angle. A stroke thinner than a pixel covers it in part. Eight segments are set up at once,
//! and each is compared with eight pixels of a row at once.

use std::ops::Range;

use glam::DVec2;

use crate::drawing::order::stroke_reach;
use crate::simd::prelude::*;

/// A point of a stroke's middle line.
pub(super) type Point = [f32; 3];

/// Segments whose boxes are found together.
pub(super) const TOGETHER: usize = 8;

/// Eight segments of one half width, ready to be compared with pixels.
pub(super) struct Segments {
    from: [[f32; TOGETHER]; 3],
    /// The unit vector along each.
    ux: [f32; TOGETHER],
    uy: [f32; TOGETHER],
    length: [f32; TOGETHER],
    /// The change of depth per pixel.
    rise: [f32; TOGETHER],
    /// The abscissae between which it may cover anything.
    left: [f32; TOGETHER],
    right: [f32; TOGETHER],
    /// The pixels around it: first and end.
    rows: [[u32; TOGETHER]; 2],
    columns: [[u32; TOGETHER]; 2],
    to_depth: [f32; TOGETHER],
    radius: f32,
}

impl Segments {
    /// Sets up eight segments at most. The others have no pixels. `DEPTH` means that depths are wanted.
    #[inline(always)]
    pub(super) fn new<K: Simd, const DEPTH: bool>(
        simd: K,
        list: &[[Point; 2]],
        radius: f32,
        rows: Range<usize>,
        width: usize,
    ) -> Self {
        let (mut from, mut to) = ([[0.0; TOGETHER]; 3], [[0.0; TOGETHER]; 3]);
        for (l, [a, b]) in list.iter().enumerate().take(TOGETHER) {
            for k in 0..3 {
                (from[k][l], to[k][l]) = (a[k], b[k]);
            }
        }
        let a = [f32x8::from_slice(simd, &from[0]), f32x8::from_slice(simd, &from[1])];
        let b = [f32x8::from_slice(simd, &to[0]), f32x8::from_slice(simd, &to[1])];
        let along = [b[0] - a[0], b[1] - a[1]];
        let (mut dx, mut dy, mut lengths) = ([0.0; TOGETHER], [0.0; TOGETHER], [0.0; TOGETHER]);
        along[0].store_slice(&mut dx);
        along[1].store_slice(&mut dy);
        for l in 0..TOGETHER {
            lengths[l] = length(dx[l], dy[l]);
        }
        let whole = f32x8::from_slice(simd, &lengths);
        let some = whole.simd_gt(1e-6);
        // A point has no direction: any will do.
        let unit = [
            some.select(along[0] / whole, f32x8::splat(simd, 1.0)),
            some.select(along[1] / whole, f32x8::splat(simd, 0.0)),
        ];
        let reach = radius + 0.5;
        let (left, right) = (a[0].min(b[0]) - reach, a[0].max(b[0]) + reach);
        let (top, bottom) = (a[1].min(b[1]) - reach, a[1].max(b[1]) + reach);
        let mut result = Self {
            from,
            ux: [0.0; TOGETHER],
            uy: [0.0; TOGETHER],
            length: lengths,
            rise: [0.0; TOGETHER],
            left: [0.0; TOGETHER],
            right: [0.0; TOGETHER],
            rows: [[0; TOGETHER]; 2],
            columns: [[0; TOGETHER]; 2],
            to_depth: to[2],
            radius,
        };
        unit[0].store_slice(&mut result.ux);
        unit[1].store_slice(&mut result.uy);
        left.store_slice(&mut result.left);
        right.store_slice(&mut result.right);
        if DEPTH {
            let rise = f32x8::from_slice(simd, &to[2]) - f32x8::from_slice(simd, &from[2]);
            (rise / whole.max(1e-6)).store_slice(&mut result.rise);
        }
        let [first, mut end] = pixels_of_eight(top, bottom, rows);
        // A segment that isn't a number, or too long, or missing, has no rows.
        let mut some = whole.simd_lt(f32::INFINITY);
        if list.len() < TOGETHER {
            some &= f32x8::from_slice(simd, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]).simd_lt(list.len() as f32);
        }
        end = some.select(end, i32x8::splat(simd, 0));
        let columns = pixels_of_eight(left, right, 0..width);
        first.bitcast::<u32x8<K>>().store_slice(&mut result.rows[0]);
        end.bitcast::<u32x8<K>>().store_slice(&mut result.rows[1]);
        columns[0].bitcast::<u32x8<K>>().store_slice(&mut result.columns[0]);
        columns[1].bitcast::<u32x8<K>>().store_slice(&mut result.columns[1]);
        result
    }

    /// The rows in which a segment may cover anything, and the columns.
    #[inline(always)]
    pub(super) fn around(&self, lane: usize) -> [Range<usize>; 2] {
        let ([top, bottom], [left, right]) = (&self.rows, &self.columns);
        [top[lane] as usize..bottom[lane] as usize, left[lane] as usize..right[lane] as usize]
    }

    /// One of them.
    #[inline(always)]
    pub(super) fn one(&self, lane: usize) -> Segment {
        Segment {
            from: [self.from[0][lane], self.from[1][lane], self.from[2][lane]],
            ux: self.ux[lane],
            uy: self.uy[lane],
            length: self.length[lane],
            rise: self.rise[lane],
            radius: self.radius,
            left: self.left[lane],
            right: self.right[lane],
        }
    }

    /// The greatest difference of depths along it, within its own width.
    #[inline(always)]
    pub(super) fn depth_reach(&self, lane: usize) -> f32 {
        stroke_reach(self.radius, self.to_depth[lane] - self.from[2][lane], self.length[lane])
    }
}

/// One of eight segments.
#[derive(Clone, Copy)]
pub(super) struct Segment {
    from: Point,
    ux: f32,
    uy: f32,
    length: f32,
    rise: f32,
    radius: f32,
    left: f32,
    right: f32,
}

/// Eight adjacent columns, by how far their centres lie along and beside a segment in the row of its beginning.
#[derive(Clone, Copy)]
pub(super) struct Columns<K: Simd> {
    along: f32x8<K>,
    beside: f32x8<K>,
}

impl Segment {
    /// The columns from this one on.
    #[inline(always)]
    pub(super) fn columns<K: Simd>(&self, simd: K, first: usize) -> Columns<K> {
        let x = f32x8::from_slice(simd, &[0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5]) + first as f32 - self.from[0];
        Columns { along: x * self.ux, beside: x * self.uy }
    }

    /// At each of the pixels of a row: 255 times its share plus ½, or less than ½ if it has none, and the depth of the
    /// nearest point of the middle line.
    #[inline(always)]
    pub(super) fn at<K: Simd>(&self, columns: Columns<K>, row: usize) -> [f32x8<K>; 2] {
        let y = center(row) - self.from[1];
        let along = columns.along + y * self.uy;
        let beside = columns.beside - y * self.ux;
        let nearest = along.max(0.0).min(self.length);
        let beyond = along - nearest;
        let distance = (beside * beside + beyond * beyond).sqrt();
        let share = (distance + 0.5).min(self.radius) - (distance - 0.5).max(-self.radius);
        [share.min(1.0) * 255.0 + 0.5, nearest * self.rise + self.from[2]]
    }

    /// The columns of a row in which it may cover anything, because the distance to its line grows by |uy| a pixel
    /// along a row.
    #[inline(always)]
    pub(super) fn columns_of(&self, row: usize, width: usize) -> Range<usize> {
        let (mut from, mut to) = (self.left, self.right);
        if self.uy.abs() > 1e-3 {
            let y = center(row) - self.from[1];
            let (middle, half) = (self.from[0] + y * self.ux / self.uy, (self.radius + 0.5) / self.uy.abs());
            (from, to) = (from.max(middle - half), to.min(middle + half));
        }
        pixels(from, to, 0..width)
    }
}

/// The centre of a column or row.
#[inline(always)]
pub(super) fn center(i: usize) -> f32 {
    i as f32 + 0.5
}

/// The pixels of a range whose centres lie between two abscissae.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "`as` saturates; NaN gives nothing")]
pub(super) fn pixels(from: f32, to: f32, range: Range<usize>) -> Range<usize> {
    let first = (from - 0.5).ceil().max(0.0) as usize;
    let end = (to + 0.5).floor().max(0.0) as usize;
    first.max(range.start)..end.min(range.end)
}

/// [`pixels`] for eight: the first, and the end, each within the range.
#[inline(always)]
fn pixels_of_eight<K: Simd>(from: f32x8<K>, to: f32x8<K>, range: Range<usize>) -> [i32x8<K>; 2] {
    let (first, end) = (range.start as f32, range.end as f32);
    let (from, to) = ((from - 0.5).ceil().max(first), (to + 0.5).floor().min(end));
    [from.min(end).to_int::<i32x8<K>>(), to.max(first).to_int::<i32x8<K>>()]
}

/// The length of a way, rounded once.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "rounded to the precision of pixels")]
pub(super) fn length(dx: f32, dy: f32) -> f32 {
    DVec2::new(f64::from(dx), f64::from(dy)).length() as f32
}
