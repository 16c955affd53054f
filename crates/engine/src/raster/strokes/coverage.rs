//! Coverage of pixels by strokes.
//!
//! The standard way blends each piece of a stroke over the picture, and a translucent colour grows darker wherever two
//! pieces overlap: at joints, crossings, arrow heads. Here all pieces of a layer (the visible or the hidden parts of a
//! set of strokes) meet in one mask, in which a pixel keeps the greatest share, and the colour is blended once at the
//! end, eight pixels at a time. A layer that no depth can put behind another is painted as soon as its mask is
//! complete. For the others each pixel keeps share and depth, as in an A-buffer (Carpenter 1984). They are painted from
//! back to front when all are known. So strokes are as smooth where one passes in front of another as anywhere else.

use std::ops::Range;

use crate::appearance::Rgba;
use crate::simd::prelude::*;

use super::eights::{TouchedColumns, next_column};
use super::fragments::{Fragments, Rank};
use super::segment::{Columns, Point, Segment, Segments, TOGETHER, center, length, pixels};
use crate::raster::pixel::{LANES, Pixel, over, premultiply, scale};

/// The strokes over some rows of a picture, empty once they are painted.
#[derive(Clone, Debug, Default)]
pub(super) struct Coverage {
    width: usize,
    /// The rows of the picture.
    rows: Range<usize>,
    /// Values from one row to the next. There is room for a vector beyond the last column.
    pitch: usize,
    /// 255 times the share of each pixel in the current layer, plus ½. In a layer with a rank, the whole number below.
    shares: Vec<f32>,
    /// The depth of a stroke's middle line where it is nearest to the pixel, and its [`Fragment::reach`]. Arbitrary
    /// if the share is 0. Only in layers with a rank.
    depths: Vec<f32>,
    reaches: Vec<f32>,
    /// The eights of columns that the layer may cover.
    touched: TouchedColumns,
    color: Pixel,
    rank: Option<Rank>,
    /// The layers with a rank.
    fragments: Fragments,
}

impl Coverage {
    /// Fits the mask to some rows of a picture.
    pub(super) fn fit(&mut self, width: usize, rows: Range<usize>) {
        if (self.width, self.rows.len()) != (width, rows.len()) {
            self.pitch = width.next_multiple_of(LANES) + LANES;
            self.shares.clear();
            self.shares.resize(self.pitch * rows.len(), 0.0);
            self.touched.fit(width, rows.len());
            self.fragments.fit(width, rows.len());
        }
        (self.width, self.rows) = (width, rows);
    }

    /// Begins a layer. The following pieces are painted in this colour, over all earlier ones or, with a rank, where
    /// their depths are in front of others.
    pub(super) fn begin(&mut self, color: Rgba, rank: Option<Rank>) {
        (self.color, self.rank) = (premultiply(color), rank);
        if rank.is_some() {
            self.depths.resize(self.shares.len(), 0.0);
            self.reaches.resize(self.shares.len(), 0.0);
        }
    }

    /// Covers the points within `radius` of each segment: strokes with round ends.
    #[inline(never)]
    pub(super) fn segments<K: Simd>(&mut self, simd: K, segments: &[[Point; 2]], radius: f32) {
        // One copy for the four places that call it.
        simd.vectorize(
            #[inline(always)]
            || {
                if self.rank.is_some() {
                    self.segments_of::<K, true>(simd, segments, radius);
                } else {
                    self.segments_of::<K, false>(simd, segments, radius);
                }
            },
        );
    }

    #[inline(always)]
    fn segments_of<K: Simd, const DEPTH: bool>(&mut self, simd: K, segments: &[[Point; 2]], radius: f32) {
        // Its width is lost beside half a pixel, or isn't a number.
        let is_wide = radius + 0.5 > 0.5;
        if !is_wide {
            return;
        }
        for eight in segments.chunks(TOGETHER) {
            let set_up = Segments::new::<K, DEPTH>(simd, eight, radius, self.rows.clone(), self.width);
            for lane in 0..eight.len() {
                let [rows, columns] = set_up.around(lane);
                if rows.is_empty() || columns.is_empty() {
                    continue;
                }
                let segment = set_up.one(lane);
                let reach = if DEPTH { set_up.depth_reach(lane) } else { 0.0 };
                if columns.len() <= LANES {
                    // So short that beyond its reach its share is less than a step, however it's rounded.
                    let eight = segment.columns(simd, columns.start);
                    for row in rows {
                        let at = (row - self.rows.start) * self.pitch + columns.start;
                        self.raise::<K, DEPTH>(simd, at, segment.at(eight, row), reach);
                        self.touched.add(row - self.rows.start, columns.start, columns.end - 1);
                    }
                } else {
                    for row in rows {
                        self.row::<K, DEPTH>(simd, &segment, row, reach);
                    }
                }
            }
        }
    }

    /// Covers a row of a long segment.
    #[inline(always)]
    fn row<K: Simd, const DEPTH: bool>(&mut self, simd: K, segment: &Segment, row: usize, reach: f32) {
        let columns = segment.columns_of(row, self.width);
        if columns.is_empty() {
            return;
        }
        let start = (row - self.rows.start) * self.pitch;
        for first in columns.clone().step_by(LANES) {
            let eight: Columns<K> = segment.columns(simd, first);
            let [mut share, depth] = segment.at(eight, row);
            if columns.end - first < LANES {
                let lanes = f32x8::from_slice(simd, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
                let inside = lanes.simd_lt((columns.end - first) as f32);
                share = inside.select(share, f32x8::splat(simd, 0.0));
            }
            self.raise::<K, DEPTH>(simd, start + first, [share, depth], reach);
        }
        self.touched.add(row - self.rows.start, columns.start, columns.end - 1);
    }

    /// Raises the shares of eight pixels.
    #[inline(always)]
    fn raise<K: Simd, const DEPTH: bool>(&mut self, simd: K, at: usize, [share, depth]: [f32x8<K>; 2], reach: f32) {
        let here = at..at + LANES;
        let Some(shares) = self.shares.get_mut(here.clone()) else { return };
        let own = f32x8::from_slice(simd, shares);
        if !DEPTH {
            own.max(share).store_slice(shares);
            return;
        }
        let (Some(depths), Some(reaches)) = (self.depths.get_mut(here.clone()), self.reaches.get_mut(here)) else {
            return;
        };
        let share = share.floor();
        let (own_depth, own_reach) = (f32x8::from_slice(simd, depths), f32x8::from_slice(simd, reaches));
        // If pieces cover the same share, the nearer one decides the depth.
        let more = share.simd_gt(own) | (share.simd_eq(own) & depth.simd_gt(own_depth));
        more.select(share, own).store_slice(shares);
        more.select(depth, own_depth).store_slice(depths);
        more.select(f32x8::splat(simd, reach), own_reach).store_slice(reaches);
    }

    /// Covers a triangle, an arrow head. `depths` are the least and the greatest in it.
    pub(super) fn triangle(&mut self, corners: [[f32; 2]; 3], depths: [f32; 2]) {
        let [a, b, c] = corners;
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if !area.is_finite() || area.abs() < 1e-3 {
            return;
        }
        let edges = [(a, b), (b, c), (c, a)].map(|(p, q)| {
            let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
            let scale = area.signum() / length(dx, dy);
            (p, dx * scale, dy * scale)
        });
        let low = |k: usize| a[k].min(b[k]).min(c[k]) - 0.5;
        let high = |k: usize| a[k].max(b[k]).max(c[k]) + 0.5;
        let columns = pixels(low(0), high(0), 0..self.width);
        if columns.is_empty() {
            return;
        }
        let (depth, reach) = (0.5 * (depths[0] + depths[1]), depths[1] - depths[0]);
        for row in pixels(low(1), high(1), self.rows.clone()) {
            let j = row - self.rows.start;
            self.touched.add(j, columns.start, columns.end - 1);
            for i in columns.clone() {
                let (x, y) = (center(i), center(row));
                let inside = |(p, dx, dy): ([f32; 2], f32, f32)| dx * (y - p[1]) - dy * (x - p[0]);
                let within = inside(edges[0]).min(inside(edges[1])).min(inside(edges[2]));
                self.raise_one(j * self.pitch + i, (within + 0.5).clamp(0.0, 1.0) * 255.0 + 0.5, depth, reach);
            }
        }
    }

    /// Raises the share of one pixel.
    fn raise_one(&mut self, at: usize, share: f32, depth: f32, reach: f32) {
        let own = &mut self.shares[at];
        if self.rank.is_none() {
            *own = own.max(share);
        } else if (share.floor(), depth) > (*own, self.depths[at]) {
            (*own, self.depths[at], self.reaches[at]) = (share.floor(), depth, reach);
        }
    }

    /// Ends a layer: paints it on `pixels` (the rows of the mask) or, with a rank, keeps its fragments.
    #[inline(never)]
    pub(super) fn end<K: Simd>(&mut self, simd: K, pixels: &mut [[u8; 4]]) {
        simd.vectorize(
            #[inline(always)]
            || self.end_with(simd, pixels),
        );
    }

    #[inline(always)]
    fn end_with<K: Simd>(&mut self, simd: K, pixels: &mut [[u8; 4]]) {
        if let Some(rank) = self.rank {
            self.fragments.begin(self.color, rank);
        }
        for row in 0..self.rows.len() {
            for word in 0..self.touched.words {
                let mut eights = self.touched.take(row, word);
                while eights != 0 {
                    let column = next_column(&mut eights, word);
                    match self.rank {
                        None => self.paint(simd, row, column, pixels),
                        Some(_) => self.keep(row, column),
                    }
                }
            }
        }
    }

    /// Paints eight columns, and empties the mask there.
    #[inline(always)]
    fn paint<K: Simd>(&mut self, simd: K, row: usize, column: usize, pixels: &mut [[u8; 4]]) {
        let at = row * self.pitch + column;
        let Some(shares) = self.shares.get_mut(at..at + LANES) else { return };
        let share = f32x8::from_slice(simd, shares).to_int::<i32x8<K>>().bitcast::<u32x8<K>>();
        f32x8::splat(simd, 0.0).store_slice(shares);
        let start = row * self.width + column;
        let count = LANES.min(self.width - column);
        let Some(pixels) = pixels.get_mut(start..start + count) else { return };
        let mut old = [0; LANES];
        for (old, pixel) in old.iter_mut().zip(&*pixels) {
            *old = u32::from_le_bytes(*pixel);
        }
        let source = scale(u32x8::splat(simd, self.color), share);
        let mut new = [0; LANES];
        over(source, u32x8::from_slice(simd, &old)).store_slice(&mut new);
        for (new, pixel) in new.iter().zip(pixels) {
            *pixel = new.to_le_bytes();
        }
    }

    /// Keeps the layer's fragments in eight columns, and empties the mask there.
    fn keep(&mut self, row: usize, column: usize) {
        let at = row * self.pitch + column;
        let here = at..at + LANES.min(self.width - column);
        let (Some(shares), Some(depths), Some(reaches)) =
            (self.shares.get_mut(here.clone()), self.depths.get(here.clone()), self.reaches.get(here))
        else {
            return;
        };
        self.fragments.touch(row, column);
        for (column, ((share, depth), reach)) in (column..).zip(shares.iter_mut().zip(depths).zip(reaches)) {
            #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
            let share = std::mem::take(share) as u8;
            if share > 0 {
                self.fragments.add([row, column], share, *depth, *reach);
            }
        }
    }

    /// Lays all layers with a rank on `pixels` (the rows of the mask), from back to front, and forgets them.
    pub(super) fn lay(&mut self, pixels: &mut [[u8; 4]]) {
        self.fragments.lay(pixels);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::simd::with_vectors;

    const INK: Rgba = Rgba::rgb(0, 0, 0);

    /// A mask with one layer, whose strokes are flat.
    fn mask(width: usize, rows: Range<usize>) -> Coverage {
        let mut coverage = Coverage::default();
        coverage.fit(width, rows);
        coverage.begin(INK, None);
        coverage
    }

    impl Coverage {
        fn capsule(&mut self, a: Point, b: Point, radius: f32) {
            with_vectors!(simd => self.segments(simd, &[[a, b]], radius));
        }

        fn flat(&mut self, a: [f32; 2], b: [f32; 2], radius: f32) {
            self.capsule([a[0], a[1], 0.5], [b[0], b[1], 0.5], radius);
        }

        /// The share of a pixel that the current layer covers, and the depth, in a layer with a rank.
        #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
        fn at(&self, row: usize, column: usize) -> (u8, f32) {
            let at = (row - self.rows.start) * self.pitch + column;
            (self.shares[at] as u8, self.depths.get(at).copied().unwrap_or_default())
        }

        fn end_on(&mut self, pixels: &mut [[u8; 4]]) {
            with_vectors!(simd => self.end(simd, pixels));
        }

        /// Coverage of each pixel by the current layer.
        #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
        fn shares(&self) -> Vec<u8> {
            let rows = self.shares.chunks(self.pitch).take(self.rows.len());
            rows.flat_map(|row| &row[..self.width]).map(|&share| share as u8).collect()
        }

        fn is_empty(&self) -> bool {
            // Rounding may leave less than a step.
            self.touched.is_empty() && self.fragments.is_empty() && self.shares().iter().all(|&share| share == 0)
        }
    }

    #[test]
    fn a_level_stroke_covers_exactly_its_width() {
        for (y, width, expected) in [
            (3.5, 1.0, [0, 255, 0]),
            (3.0, 1.0, [128, 128, 0]),
            (3.5, 2.0, [128, 255, 128]),
            (3.5, 0.5, [0, 128, 0]),
            (3.75, 1.0, [0, 191, 64]),
        ] {
            let mut coverage = mask(20, 0..8);
            coverage.flat([3.0, y], [17.0, y], width / 2.0);
            let column: [u8; 3] = std::array::from_fn(|j| coverage.shares()[(j + 2) * 20 + 10]);
            assert_eq!(column, expected, "y = {y}, width = {width}");
        }
    }

    #[test]
    #[expect(clippy::cast_possible_truncation, reason = "single precision is what is drawn with")]
    fn a_stroke_covers_its_area_at_any_angle() {
        for degrees in [0.0_f32, 10.0, 30.0, 45.0, 77.0, 90.0] {
            let mut coverage = mask(100, 0..100);
            let (s, c) = f64::from(degrees).to_radians().sin_cos();
            let [s, c] = [s, c].map(|x| x as f32);
            coverage.flat([50.3 - 40.0 * c, 50.1 - 40.0 * s], [50.3 + 40.0 * c, 50.1 + 40.0 * s], 1.25);
            let area = coverage.shares().iter().map(|&s| f64::from(s) / 255.0).sum::<f64>();
            let exact = 80.0 * 2.5 + std::f64::consts::PI * 1.25 * 1.25;
            assert!((area - exact).abs() < 0.02 * exact, "{degrees}°: {area} instead of {exact}");
        }
    }

    #[test]
    fn a_triangle_covers_its_area() {
        for corners in [[[5.0, 5.0], [60.0, 12.0], [20.0, 50.0]], [[5.0, 5.0], [20.0, 50.0], [60.0, 12.0]]] {
            let mut coverage = mask(70, 0..60);
            coverage.triangle(corners, [0.5, 0.5]);
            let area = coverage.shares().iter().map(|&s| f64::from(s) / 255.0).sum::<f64>();
            assert!((area - 1185.0).abs() < 12.0, "{area}");
        }
    }

    #[test]
    fn a_triangle_is_smooth_over_one_pixel_of_its_border_whichever_way_it_runs() {
        // Legs at x = 2.25 and y = 2.75; the third side is x + y = 23, on which pixels with i + j = 22 have their
        // centre.
        let corners = [[2.25, 2.75], [20.25, 2.75], [2.25, 20.75]];
        let expected =
            [(2, 6, 191), (1, 6, 0), (6, 2, 64), (6, 3, 255), (6, 1, 0), (11, 11, 128), (10, 11, 255), (12, 11, 0)];
        for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
            let mut coverage = mask(24, 0..24);
            coverage.triangle(order.map(|k| corners[k]), [0.5, 0.5]);
            let mut turned = mask(24, 0..24);
            turned.triangle(order.map(|k| corners[k].map(|x| 24.0 - x)), [0.5, 0.5]);
            for (i, j, share) in expected {
                assert_eq!(coverage.shares()[j * 24 + i], share, "{i}, {j} in order {order:?}");
                assert!(
                    turned.shares()[(23 - j) * 24 + 23 - i].abs_diff(share) <= 1,
                    "{i}, {j} turned, in order {order:?}"
                );
            }
        }
    }

    #[test]
    fn what_is_outside_or_not_a_number_leaves_no_trace() {
        let mut coverage = mask(10, 0..10);
        coverage.flat([-50.0, -50.0], [-20.0, 70.0], 2.0);
        coverage.flat([f32::NAN, 1.0], [5.0, 5.0], 2.0);
        coverage.flat([1.0, 1.0], [5.0, f32::INFINITY], 2.0);
        coverage.flat([1.0, 1.0], [5.0, 5.0], f32::NAN);
        coverage.flat([1.0, 1.0], [5.0, 5.0], -1.0);
        coverage.triangle([[f32::NAN, 0.0], [5.0, 5.0], [0.0, 5.0]], [0.5, 0.5]);
        assert!(coverage.shares().iter().all(|&s| s == 0));
    }

    #[test]
    fn overlapping_pieces_darken_nothing() {
        let mut pixels = [[0; 4]; 20 * 5];
        let mut coverage = mask(20, 0..5);
        coverage.begin(Rgba::rgba(255, 255, 255, 128), None);
        coverage.flat([2.0, 2.5], [12.0, 2.5], 1.0);
        coverage.flat([8.0, 2.5], [18.0, 2.5], 1.0);
        coverage.end_on(&mut pixels);
        let alpha = |i: usize| pixels[2 * 20 + i][3];
        assert_eq!((alpha(5), alpha(10), alpha(15)), (128, 128, 128));
        assert!(coverage.is_empty());
    }

    #[test]
    fn some_rows_get_what_all_rows_would() {
        let draw = |coverage: &mut Coverage| {
            coverage.flat([2.3, 1.7], [17.1, 18.9], 1.3);
            coverage.triangle([[3.0, 15.0], [9.0, 2.0], [18.0, 12.0]], [0.5, 0.5]);
        };
        let mut whole = mask(20, 0..20);
        draw(&mut whole);
        let mut part = mask(20, 7..12);
        draw(&mut part);
        assert_eq!(part.shares(), whole.shares()[7 * 20..12 * 20]);
    }

    const RED: Rgba = Rgba::rgb(255, 0, 0);
    const BLUE: Rgba = Rgba::rgb(0, 0, 255);

    /// The pixels of 20 × 20 in which strokes lie, painted in this order on white: colour, ends, width, whether
    /// visible.
    fn painted(strokes: &[(Rgba, [Point; 2], f32, bool)]) -> Vec<[u8; 4]> {
        let mut pixels = vec![[255; 4]; 400];
        let mut coverage = Coverage::default();
        coverage.fit(20, 0..20);
        for &(color, [a, b], width, visible) in strokes {
            coverage.begin(color, Some(Rank { visible, width }));
            coverage.capsule(a, b, width / 2.0);
            coverage.end_on(&mut pixels);
        }
        coverage.lay(&mut pixels);
        assert!(coverage.is_empty());
        pixels
    }

    fn level(depth: f32) -> [Point; 2] {
        [[2.0, 10.5, depth], [18.0, 10.5, depth]]
    }

    fn upright(depth: f32) -> [Point; 2] {
        [[10.5, 2.0, depth], [10.5, 18.0, depth]]
    }

    const MIDDLE: usize = 10 * 20 + 10;

    #[test]
    fn the_nearer_of_two_strokes_is_over_the_other_in_any_order_and_stays_smooth() {
        let (far, near) = ((RED, level(0.2), 3.0, true), (BLUE, upright(0.6), 2.0, true));
        let pixels = painted(&[far, near]);
        assert_eq!(pixels, painted(&[near, far]));
        assert_eq!(pixels[MIDDLE], [0, 0, 255, 255]);
        // Beside its middle line the near stroke covers half a pixel; the rest is the far one's.
        assert_eq!(pixels[MIDDLE + 1], [127, 0, 128, 255]);
        // Each is the same as alone where they don't meet.
        assert_eq!(pixels[5 * 20 + 10], painted(&[near])[5 * 20 + 10]);
        assert_eq!(pixels[10 * 20 + 5], painted(&[far])[10 * 20 + 5]);
    }

    #[test]
    fn a_stroke_passes_through_another_where_their_depths_do() {
        // From behind to before. At the left end of the picture it's under the other, at the right end over it.
        let slanting = [[2.0, 10.5, 0.1], [18.0, 10.5, 0.9]];
        let post = |x: f32| (BLUE, [[x, 2.0, 0.5], [x, 18.0, 0.5]], 2.0, true);
        let pixels = painted(&[(RED, slanting, 2.0, true), post(5.0), post(15.0)]);
        assert_eq!(pixels[10 * 20 + 5][..3], [0, 0, 255]);
        assert_eq!(pixels[10 * 20 + 15][..3], [255, 0, 0]);
    }

    #[test]
    fn where_strokes_touch_the_visible_then_the_wider_then_the_later_is_over_the_other() {
        let middle = |strokes: &[(Rgba, [Point; 2], f32, bool)]| painted(strokes)[MIDDLE];
        let [red, blue] = [[255, 0, 0, 255], [0, 0, 255, 255]];
        assert_eq!(middle(&[(RED, level(0.5), 2.0, true), (BLUE, upright(0.5), 2.0, true)]), blue);
        assert_eq!(middle(&[(RED, level(0.5), 3.0, true), (BLUE, upright(0.5), 2.0, true)]), red);
        assert_eq!(middle(&[(RED, level(0.5), 2.0, true), (BLUE, upright(0.5), 3.0, false)]), red);
        // A line on the ground that runs up to an edge and on under it. It's nearer on this side of the edge, and yet
        // the edge is whole.
        let towards = [[10.5, 2.0, 0.42], [10.5, 18.0, 0.58]];
        let pixels = painted(&[(RED, level(0.5), 3.0, true), (BLUE, towards, 1.5, true)]);
        for row in 9..=11 {
            assert_eq!(pixels[row * 20 + 10][0], 255, "{row}");
        }
    }

    #[test]
    fn of_pieces_of_a_stroke_that_cover_the_same_the_nearer_one_tells_the_depth() {
        for depths in [[0.2, 0.8], [0.8, 0.2]] {
            let mut pixels = [[255; 4]; 400];
            let mut coverage = Coverage::default();
            coverage.fit(20, 0..20);
            coverage.begin(RED, Some(Rank { visible: true, width: 3.0 }));
            for [a, b] in depths.map(level) {
                coverage.capsule(a, b, 1.5);
            }
            coverage.end_on(&mut pixels);
            coverage.begin(BLUE, Some(Rank { visible: true, width: 3.0 }));
            let [a, b] = upright(0.5);
            coverage.capsule(a, b, 1.5);
            coverage.end_on(&mut pixels);
            coverage.lay(&mut pixels);
            assert_eq!(pixels[MIDDLE], [255, 0, 0, 255], "{depths:?}");
        }
    }

    /// Share (bytes) and depth of a pixel, by the formula for one pixel alone.
    #[expect(clippy::cast_possible_truncation, reason = "a share is 0 … 1")]
    fn alone([a, b]: [Point; 2], radius: f32, [column, row]: [usize; 2]) -> (u8, f32) {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = length(dx, dy);
        let (ux, uy) = if length > 1e-6 { (dx / length, dy / length) } else { (1.0, 0.0) };
        let (x, y) = (center(column) - a[0], center(row) - a[1]);
        let along = x * ux + y * uy;
        let beside = x * uy - y * ux;
        let beyond = (-along).max(along - length).max(0.0);
        let distance = (beside * beside + beyond * beyond).sqrt();
        let share = (radius.min(distance + 0.5) - (-radius).max(distance - 0.5)).clamp(0.0, 1.0);
        let rise = (b[2] - a[2]) / length.max(1e-6);
        ((share * 255.0 + 0.5) as u8, a[2] + rise * along.clamp(0.0, length))
    }

    const WIDTH: usize = 61;

    fn segment() -> impl Strategy<Value = [Point; 2]> {
        let at = || prop_oneof![4 => -8.0..70.0_f32, 1 => Just(10.5_f32), 1 => Just(20.0_f32), 1 => -3e4..3e4_f32];
        let from = (at(), at(), 0.0..1.0_f32);
        // To anywhere, level, upright, by a few pixels, by nothing.
        let by = || prop_oneof![-3.0..3.0_f32, -60.0..60.0_f32, Just(0.0_f32), Just(1e-7_f32)];
        (from, by(), by(), 0.0..1.0_f32).prop_map(|((x, y, z), dx, dy, to)| [[x, y, z], [x + dx, y + dy, to]])
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn eight_pixels_get_what_each_would_alone(
            segments in prop::collection::vec(segment(), 1..12),
            radius in prop_oneof![Just(0.625_f32), 0.01..4.0_f32],
            first in 0_usize..20,
        ) {
            let rows = first..first + 40;
            for rank in [None, Some(Rank { visible: true, width: 1.0 })] {
                let mut coverage = Coverage::default();
                coverage.fit(WIDTH, rows.clone());
                coverage.begin(Rgba::rgb(0, 0, 0), rank);
                with_vectors!(simd => coverage.segments(simd, &segments, radius));
                for row in rows.clone() {
                    for column in 0..WIDTH {
                        let mut expected = (0, 0.0);
                        for &segment in &segments {
                            let here = alone(segment, radius, [column, row]);
                            if here.0 > 0 && here > expected {
                                expected = here;
                            }
                        }
                        let (share, depth) = coverage.at(row, column);
                        prop_assert_eq!(share, expected.0, "share of {:?}", [column, row]);
                        prop_assert!(rank.is_none() || share == 0 || depth == expected.1, "{} {}", depth, expected.1);
                    }
                }
            }
        }
    }
}
