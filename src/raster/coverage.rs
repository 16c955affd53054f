//! Coverage of pixels by strokes, and the order of strokes in depth.
//!
//! All pieces of a layer (the visible or the hidden parts of a set of strokes) meet in one mask, each pixel keeping the
//! greatest share: pieces may overlap (joints, crossings, arrow heads) without a translucent colour growing darker
//! there. Each pixel stores the layers that cover it, with share and depth, as in an A-buffer (Carpenter 1984); only
//! when all are known are they painted, from back to front. So strokes are as smooth where one passes in front of
//! another as anywhere else.

use std::ops::Range;

use glam::DVec2;

use crate::appearance::Rgba;
use crate::drawing::order::{StrokePoint, later_is_over, stroke_reach};

use super::pixel::{Pixel, over, premultiply, scale};

/// The strokes over some rows of a picture, empty once they are laid on it.
#[derive(Clone, Debug, Default)]
pub(super) struct Coverage {
    width: usize,
    /// The rows of the picture.
    first: usize,
    end: usize,
    layers: Vec<Layer>,
    fragments: Vec<Fragment>,
    /// For each pixel the fragment that came last, counted from 1; 0 where there is none.
    last: Vec<u32>,
    /// For each row the columns that were touched: first and end.
    rows: Vec<(u32, u32)>,
    /// The rows that were touched, counted from `first`.
    touched: Range<usize>,
    /// The fragments of the pixel at hand, from back to front.
    order: Vec<Fragment>,
}

/// A set of pieces painted in one way.
#[derive(Clone, Copy, Debug)]
struct Layer {
    color: Pixel,
    depth: LayerDepth,
}

/// The order of a layer relative to others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum LayerDepth {
    /// Hidden only by later layers.
    OnTop,
    /// Compared by its depth, and by the other criteria of [`later_is_over`].
    Tested {
        /// No face hides it.
        visible: bool,
        /// Of the stroke, in pixels.
        width: f32,
    },
}

/// The share of a pixel that a layer covers.
#[derive(Clone, Copy, Debug)]
struct Fragment {
    layer: u32,
    /// The fragment of the same pixel that came before, counted from 1.
    before: u32,
    share: u8,
    /// Depth of the stroke's middle line where it is nearest to the pixel.
    depth: f32,
    /// By how much depths may differ between there and the places on the stroke around that touch the pixel.
    reach: f32,
}

/// A point of a stroke's middle line.
pub(super) type Point = [f32; 3];

const UNTOUCHED: (u32, u32) = (u32::MAX, 0);

impl Coverage {
    /// Makes the mask fit some rows of a picture.
    pub(super) fn fit(&mut self, width: usize, rows: Range<usize>) {
        if (self.width, self.rows.len()) != (width, rows.len()) {
            self.last.clear();
            self.last.resize(width * rows.len(), 0);
            self.rows.clear();
            self.rows.resize(rows.len(), UNTOUCHED);
        }
        (self.width, self.first, self.end) = (width, rows.start, rows.end);
    }

    /// Begins a layer: the following pieces are painted in this colour.
    pub(super) fn begin(&mut self, color: Rgba, depth: LayerDepth) {
        self.layers.push(Layer { color: premultiply(color), depth });
    }

    /// Covers the points within `radius` of the segment a–b: a stroke with round ends. A stroke thinner than a pixel
    /// covers it in part.
    pub(super) fn capsule(&mut self, a: Point, b: Point, radius: f32) {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = length(dx, dy);
        let reach = radius + 0.5;
        if !(length.is_finite() && reach > 0.5) {
            return;
        }
        let (ux, uy) = if length > 1e-6 { (dx / length, dy / length) } else { (1.0, 0.0) };
        let (left, right) = (a[0].min(b[0]) - reach, a[0].max(b[0]) + reach);
        // The depth along the middle line.
        let rise = (b[2] - a[2]) / length.max(1e-6);
        let depth_reach = stroke_reach(radius, b[2] - a[2], length);
        for j in pixels(a[1].min(b[1]) - reach, a[1].max(b[1]) + reach, self.first..self.end) {
            let y = center(j) - a[1];
            // Along the row the distance to the line grows by |uy| a pixel.
            let (mut from, mut to) = (left, right);
            if uy.abs() > 1e-3 {
                let (middle, half) = (a[0] + y * ux / uy, reach / uy.abs());
                (from, to) = (from.max(middle - half), to.min(middle + half));
            }
            self.row(j, from, to, depth_reach, |x| {
                let x = x - a[0];
                let along = x * ux + y * uy;
                let beside = x * uy - y * ux;
                let beyond = (-along).max(along - length).max(0.0);
                let depth = a[2] + rise * along.clamp(0.0, length);
                (overlap((beside * beside + beyond * beyond).sqrt(), radius), depth)
            });
        }
    }

    /// Covers a triangle, an arrow head; `depths`: the least and the greatest in it.
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
        for j in pixels(low(1), high(1), self.first..self.end) {
            let y = center(j);
            self.row(j, low(0), high(0), depths[1] - depths[0], |x| {
                let inside = |(p, dx, dy): ([f32; 2], f32, f32)| dx * (y - p[1]) - dy * (x - p[0]);
                let depth = inside(edges[0]).min(inside(edges[1])).min(inside(edges[2]));
                ((depth + 0.5).clamp(0.0, 1.0), 0.5 * (depths[0] + depths[1]))
            });
        }
    }

    /// Raises the shares of a row between two abscissae to the value of `share` for each pixel centre, with the depth
    /// there.
    fn row(&mut self, j: usize, from: f32, to: f32, reach: f32, share: impl Fn(f32) -> (f32, f32)) {
        let columns = pixels(from, to, 0..self.width);
        if columns.is_empty() || self.layers.is_empty() {
            return;
        }
        let j = j - self.first;
        let touched = &mut self.rows[j];
        self.touched =
            if self.touched.is_empty() { j..j + 1 } else { self.touched.start.min(j)..self.touched.end.max(j + 1) };
        #[expect(clippy::cast_possible_truncation, reason = "sides are at most 16384")]
        let (first, end) = (columns.start as u32, columns.end as u32);
        *touched = (touched.0.min(first), touched.1.max(end));
        let layer = number(self.layers.len() - 1);
        for i in columns {
            let (share, depth) = share(center(i));
            #[expect(clippy::cast_possible_truncation, reason = "a share is 0 … 1")]
            let share = (share * 255.0 + 0.5) as u8;
            if share == 0 {
                continue;
            }
            let last = &mut self.last[j * self.width + i];
            match self.fragments.get_mut((*last as usize).wrapping_sub(1)) {
                // Of pieces that cover the same share the nearer one tells the depth.
                Some(own) if own.layer == layer => {
                    if (share, depth) > (own.share, own.depth) {
                        (own.share, own.depth, own.reach) = (share, depth, reach);
                    }
                }
                _ => {
                    self.fragments.push(Fragment { layer, before: *last, share, depth, reach });
                    *last = number(self.fragments.len());
                }
            }
        }
    }

    /// Lays all layers on `pixels` (the rows of the mask), from back to front, and forgets them.
    pub(super) fn lay(&mut self, pixels: &mut [[u8; 4]]) {
        for j in std::mem::take(&mut self.touched) {
            let (first, end) = std::mem::replace(&mut self.rows[j], UNTOUCHED);
            if first >= end {
                continue;
            }
            let range = j * self.width + first as usize..j * self.width + end as usize;
            for (last, pixel) in self.last[range.clone()].iter_mut().zip(&mut pixels[range]) {
                let mut next = std::mem::take(last);
                if next == 0 {
                    continue;
                }
                self.order.clear();
                while let Some(&fragment) = self.fragments.get((next as usize).wrapping_sub(1)) {
                    self.order.push(fragment);
                    next = fragment.before;
                }
                self.order.reverse();
                sort(&mut self.order, &self.layers);
                for fragment in &self.order {
                    let source = scale(self.layers[fragment.layer as usize].color, u32::from(fragment.share));
                    *pixel = over(source, u32::from_le_bytes(*pixel)).to_le_bytes();
                }
            }
        }
        self.layers.clear();
        self.fragments.clear();
    }
}

/// Sorts the fragments of a pixel, which come in the order of the drawing, from back to front: each goes below those
/// that it is behind. ("Of the same depth" is not an order, since it is within bounds; so each is held against one
/// after the other.)
fn sort(fragments: &mut [Fragment], layers: &[Layer]) {
    for k in 1..fragments.len() {
        let mut at = k;
        while at > 0 && is_behind(&fragments[at], &fragments[at - 1], layers) {
            fragments.swap(at, at - 1);
            at -= 1;
        }
    }
}

/// True where a fragment is behind one that came before it in the drawing.
fn is_behind(later: &Fragment, earlier: &Fragment, layers: &[Layer]) -> bool {
    let of = |fragment: &Fragment| layers[fragment.layer as usize].depth;
    match (of(later), of(earlier)) {
        (LayerDepth::OnTop, _) => false,
        (LayerDepth::Tested { .. }, LayerDepth::OnTop) => true,
        (LayerDepth::Tested { visible, width }, LayerDepth::Tested { visible: other_visible, width: other_width }) => {
            let point = |&Fragment { depth, reach, .. }: &Fragment, visible, width| StrokePoint {
                depth,
                reach,
                visible,
                width,
            };
            !later_is_over(point(later, visible, width), point(earlier, other_visible, other_width))
        }
    }
}

/// Fragments are counted with 32 bits: each pixel of a picture has room for thirty.
fn number(k: usize) -> u32 {
    u32::try_from(k).unwrap_or(u32::MAX)
}

/// The length of a way, rounded once.
#[expect(clippy::cast_possible_truncation, reason = "rounded to the precision of pixels")]
pub(super) fn length(dx: f32, dy: f32) -> f32 {
    DVec2::new(f64::from(dx), f64::from(dy)).length() as f32
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

    const INK: Rgba = Rgba::rgb(0, 0, 0);

    /// A mask with one layer, whose strokes are flat.
    fn mask(width: usize, rows: Range<usize>) -> Coverage {
        let mut coverage = Coverage::default();
        coverage.fit(width, rows);
        coverage.begin(INK, LayerDepth::OnTop);
        coverage
    }

    impl Coverage {
        fn flat(&mut self, a: [f32; 2], b: [f32; 2], radius: f32) {
            self.capsule([a[0], a[1], 0.5], [b[0], b[1], 0.5], radius);
        }

        /// Coverage of each pixel by the last layer.
        fn shares(&self) -> Vec<u8> {
            let share = |last: &u32| self.fragments.get((*last as usize).wrapping_sub(1)).map_or(0, |f| f.share);
            self.last.iter().map(share).collect()
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
        coverage.begin(Rgba::rgba(255, 255, 255, 128), LayerDepth::OnTop);
        coverage.flat([2.0, 2.5], [12.0, 2.5], 1.0);
        coverage.flat([8.0, 2.5], [18.0, 2.5], 1.0);
        coverage.lay(&mut pixels);
        let alpha = |i: usize| pixels[2 * 20 + i][3];
        assert_eq!((alpha(5), alpha(10), alpha(15)), (128, 128, 128));
        assert!(coverage.shares().iter().all(|&s| s == 0));
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
            coverage.begin(color, LayerDepth::Tested { visible, width });
            coverage.capsule(a, b, width / 2.0);
        }
        coverage.lay(&mut pixels);
        assert!(coverage.last.iter().all(|&last| last == 0));
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
        // Where they do not meet, each is the same as alone.
        assert_eq!(pixels[5 * 20 + 10], painted(&[near])[5 * 20 + 10]);
        assert_eq!(pixels[10 * 20 + 5], painted(&[far])[10 * 20 + 5]);
    }

    #[test]
    fn a_stroke_passes_through_another_where_their_depths_do() {
        // From behind to before: at the left end of the picture under it, at the right end over it.
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
        // A line on the ground that runs up to an edge and on under it: it is nearer on this side of the edge, and yet
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
            coverage.begin(RED, LayerDepth::Tested { visible: true, width: 3.0 });
            for [a, b] in depths.map(level) {
                coverage.capsule(a, b, 1.5);
            }
            coverage.begin(BLUE, LayerDepth::Tested { visible: true, width: 3.0 });
            let [a, b] = upright(0.5);
            coverage.capsule(a, b, 1.5);
            coverage.lay(&mut pixels);
            assert_eq!(pixels[MIDDLE], [255, 0, 0, 255], "{depths:?}");
        }
    }

    #[test]
    fn what_nothing_hides_is_painted_in_its_order_over_all_others() {
        let mut pixels = vec![[255; 4]; 400];
        let mut coverage = mask(20, 0..20);
        for (color, ends) in [(RED, level(0.1)), (BLUE, upright(0.9))] {
            coverage.begin(color, LayerDepth::OnTop);
            coverage.capsule(ends[0], ends[1], 1.5);
        }
        coverage.begin(INK, LayerDepth::Tested { visible: true, width: 9.0 });
        coverage.capsule([2.0, 2.0, 1.0], [18.0, 18.0, 1.0], 4.5);
        coverage.lay(&mut pixels);
        assert_eq!(pixels[MIDDLE], [0, 0, 255, 255]);
        assert_eq!(pixels[10 * 20 + 7], [255, 0, 0, 255]);
        assert_eq!(pixels[6 * 20 + 6], [0, 0, 0, 255]);
    }
}
