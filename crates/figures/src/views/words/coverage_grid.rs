//! The parts of a picture that bodies cover. A text there would hide the subject of the picture.

use glam::DVec2;

use crate::drawing::Drawing;

/// Number of cells along the shorter side of a picture.
const CELLS: u32 = 90;
/// The least side of a cell in pixels.
const LEAST: f64 = 3.0;
/// From this alpha on, a face is more than glass.
const OPAQUE: u8 = 110;

/// The parts of a picture that faces cover, in square cells.
pub(in crate::views) struct Solids {
    cell: f64,
    grid: Cells,
    /// Number of covered cells above and to the left of each corner of a cell, by rows.
    sums: Vec<u32>,
}

impl Solids {
    /// The area covered by the faces of a drawing, except for glass.
    pub(in crate::views) fn of(drawing: &Drawing) -> Self {
        let cell = (f64::from(drawing.width.min(drawing.height)) / f64::from(CELLS)).max(LEAST);
        #[expect(clippy::cast_possible_truncation, reason = "a number of cells")]
        let cells = |side: u32| (f64::from(side) / cell).ceil() as usize;
        let grid = Cells { columns: cells(drawing.width), rows: cells(drawing.height) };
        let mut covered = vec![false; grid.columns * grid.rows];
        // A picture without pixels has no cells for faces to cover.
        let surfaces = drawing.surfaces.iter().filter(|_| grid.columns * grid.rows > 0);
        for surface in surfaces {
            let in_cells = |p: &[f32; 3]| DVec2::new(f64::from(p[0]), f64::from(p[1])) / cell;
            let at = |i: u32| surface.positions.get(i as usize).map_or(DVec2::NAN, in_cells);
            let is_opaque = |i: usize| surface.alpha_of(i).is_some_and(|alpha| alpha >= OPAQUE);
            for (_, triangle) in surface.triangles.iter().enumerate().filter(|(i, _)| is_opaque(*i)) {
                let corners = triangle.map(at);
                // NaN has no place.
                if corners.iter().all(|p| p.is_finite()) {
                    grid.cover(&mut covered, corners);
                }
            }
        }
        Self { cell, grid, sums: grid.sums(&covered) }
    }

    /// The covered share of a rectangle (pixels), 0 … 1.
    pub(in crate::views) fn share(&self, center: DVec2, half: DVec2) -> f64 {
        let extent = DVec2::new(self.grid.columns as f64, self.grid.rows as f64);
        let limit = |p: DVec2| (p / self.cell).clamp(DVec2::ZERO, extent);
        let (low, high) = (limit(center - half).floor(), limit(center + half).ceil());
        #[expect(clippy::cast_possible_truncation, reason = "cells of the image")]
        let at = |x: f64, y: f64| f64::from(self.sums[y as usize * (self.grid.columns + 1) + x as usize]);
        let inside = at(high.x, high.y) - at(low.x, high.y) - at(high.x, low.y) + at(low.x, low.y);
        inside / ((high - low).element_product()).max(1.0)
    }
}

/// The cells of a picture.
#[derive(Clone, Copy)]
struct Cells {
    columns: usize,
    rows: usize,
}

impl Cells {
    /// The column, or the row, of a place. Places beside the picture have the nearest one.
    fn index(v: f64, count: usize) -> usize {
        #[expect(clippy::cast_possible_truncation, reason = "a cell of the image")]
        let index = v.max(0.0) as usize;
        index.min(count.saturating_sub(1))
    }

    /// Marks the cells whose middle is in a triangle (in cells), and those of its corners.
    fn cover(self, covered: &mut [bool], [a, b, c]: [DVec2; 3]) {
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let side = |p: DVec2, q: DVec2, at: DVec2| (q - p).perp_dot(at - p);
        for y in Self::index(low.y, self.rows)..=Self::index(high.y, self.rows) {
            for x in Self::index(low.x, self.columns)..=Self::index(high.x, self.columns) {
                let middle = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                let sides = [side(a, b, middle), side(b, c, middle), side(c, a, middle)];
                if sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0) {
                    covered[y * self.columns + x] = true;
                }
            }
        }
        for p in [a, b, c] {
            covered[Self::index(p.y, self.rows) * self.columns + Self::index(p.x, self.columns)] = true;
        }
    }

    /// Sums over all cells above and to the left of each corner (Crow 1984).
    fn sums(self, covered: &[bool]) -> Vec<u32> {
        let Self { columns, rows } = self;
        let width = columns + 1;
        let mut sums = vec![0_u32; width * (rows + 1)];
        for y in 0..rows {
            let mut row = 0;
            for x in 0..columns {
                row += u32::from(covered[y * columns + x]);
                sums[(y + 1) * width + x + 1] = sums[y * width + x + 1] + row;
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::Rgba;
    use crate::drawing::Surface;

    /// A picture of 200 × 100 pixels with a triangle in its left half.
    fn drawing(alpha: u8) -> Drawing {
        Drawing {
            surfaces: vec![Surface::solid(
                vec![[0.0, 0.0, 0.5], [0.0, 100.0, 0.5], [100.0, 100.0, 0.5]],
                vec![[0, 1, 2]],
                Rgba::rgb(1, 2, 3).with_alpha(alpha),
            )],
            ..Drawing::new(200, 100, Rgba::rgb(255, 255, 255))
        }
    }

    #[test]
    fn a_picture_without_pixels_has_nothing_covered() {
        for (width, height) in [(0, 100), (200, 0), (0, 0)] {
            let solids = Solids::of(&Drawing { width, height, ..drawing(255) });
            assert_eq!(solids.share(DVec2::splat(10.0), DVec2::splat(5.0)), 0.0);
        }
    }

    #[test]
    fn the_share_of_a_rectangle_under_a_triangle() {
        let solids = Solids::of(&drawing(255));
        let share = |x, y, half| solids.share(DVec2::new(x, y), DVec2::splat(half));
        assert!((share(50.0, 50.0, 50.0) - 0.5).abs() < 0.03, "half of a square: {}", share(50.0, 50.0, 50.0));
        assert_eq!(share(20.0, 80.0, 8.0), 1.0);
        assert_eq!(share(80.0, 20.0, 8.0), 0.0);
        assert_eq!(share(150.0, 50.0, 40.0), 0.0);
        assert_eq!(share(-50.0, 500.0, 20.0), 0.0, "outside of the picture");
    }

    #[test]
    fn glass_covers_nothing() {
        let solids = Solids::of(&drawing(40));
        assert_eq!(solids.share(DVec2::splat(50.0), DVec2::splat(50.0)), 0.0);
    }
}
