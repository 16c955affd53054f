//! Several pictures on one sheet.

use tiny_skia::Pixmap;

use crate::appearance::Rgba;

/// The places of pictures on a sheet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The upper left corner of each picture, in pixels.
    pub corners: Vec<[u32; 2]>,
    /// Width and height of the sheet, in pixels.
    pub size: [u32; 2],
}

impl Layout {
    /// Places pictures of these sizes from left to right, their middles at one height, with `gap` pixels between them.
    /// `None` if there are no pictures, or too many pixels.
    pub fn row(sizes: &[[u32; 2]], gap: u32) -> Option<Self> {
        let height = sizes.iter().map(|size| size[1]).max()?;
        let (mut corners, mut left) = (Vec::with_capacity(sizes.len()), 0_u32);
        for [width, own] in sizes {
            corners.push([left, (height - own) / 2]);
            left = left.checked_add(*width)?.checked_add(gap)?;
        }
        Some(Self { corners, size: [left - gap, height] })
    }

    /// Places pictures from top to bottom, otherwise like a [`row`](Self::row).
    pub fn column(sizes: &[[u32; 2]], gap: u32) -> Option<Self> {
        let turned: Vec<[u32; 2]> = sizes.iter().map(|[width, height]| [*height, *width]).collect();
        let Self { corners, size: [height, width] } = Self::row(&turned, gap)?;
        Some(Self { corners: corners.into_iter().map(|[top, left]| [left, top]).collect(), size: [width, height] })
    }

    /// Places pictures in rows of `columns`, each in the middle of its place, with `gap` pixels between them and
    /// `below` free pixels under each. They're in the middle of a sheet that's at least as large as `least`.
    pub fn grid(sizes: &[[u32; 2]], columns: usize, [gap, below]: [u32; 2], least: [u32; 2]) -> Option<Self> {
        let columns = columns.clamp(1, sizes.len().max(1));
        let rows: Vec<&[[u32; 2]]> = sizes.chunks(columns).collect();
        let widths: Option<Vec<u32>> =
            (0..columns).map(|k| rows.iter().filter_map(|row| row.get(k)).map(|size| size[0]).max()).collect();
        let heights: Option<Vec<u32>> = rows.iter().map(|row| row.iter().map(|size| size[1]).max()).collect();
        let (widths, heights) = (widths?, heights?);
        let total = |sides: &[u32], more: u32| {
            let sum = sides.iter().try_fold(0_u32, |sum, side| sum.checked_add(*side)?.checked_add(more))?;
            sum.checked_add(u32::try_from(sides.len()).ok()?.checked_sub(1)?.checked_mul(gap)?)
        };
        let own = [total(&widths, 0)?, total(&heights, below)?];
        let size = [own[0].max(least[0]), own[1].max(least[1])];
        let [left, top] = [(size[0] - own[0]) / 2, (size[1] - own[1]) / 2];
        let mut corners = Vec::with_capacity(sizes.len());
        let mut y = top;
        for (row, height) in rows.iter().zip(&heights) {
            let mut x = left;
            for ([wide, high], room) in row.iter().zip(&widths) {
                corners.push([x + (room - wide) / 2, y + (height - high)]);
                x += room + gap;
            }
            y += height + below + gap;
        }
        Some(Self { corners, size })
    }

    /// Replaces the last picture by several, those of another layout of the same size.
    pub fn ending_in(mut self, rest: &Self) -> Self {
        if let Some([left, top]) = self.corners.pop() {
            self.corners.extend(rest.corners.iter().map(|[x, y]| [left + x, top + y]));
        }
        self
    }
}

/// Puts the pictures at their places on a background. `None` if the sheet would be empty or too large for memory.
pub fn sheet(pictures: &[Pixmap], layout: &Layout, ground: Rgba) -> Option<Pixmap> {
    let mut sheet = filled(layout.size[0], layout.size[1], ground)?;
    for (picture, corner) in pictures.iter().zip(&layout.corners) {
        put(&mut sheet, picture, *corner);
    }
    Some(sheet)
}

fn filled(width: u32, height: u32, ground: Rgba) -> Option<Pixmap> {
    let mut sheet = Pixmap::new(width, height)?;
    sheet.fill(tiny_skia::Color::from_rgba8(ground.r, ground.g, ground.b, ground.a));
    Some(sheet)
}

/// Copies a picture to a corner of the sheet, which has room for it.
fn put(sheet: &mut Pixmap, picture: &Pixmap, [left, top]: [u32; 2]) {
    let (row, length) = (4 * sheet.width() as usize, 4 * picture.width() as usize);
    let left = 4 * left as usize;
    let rows = sheet.data_mut().chunks_exact_mut(row).skip(top as usize);
    for (from, to) in picture.data().chunks_exact(length).zip(rows) {
        to[left..left + length].copy_from_slice(from);
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;

    fn picture(width: u32, height: u32, shade: u8) -> Pixmap {
        filled(width, height, Rgba::rgb(shade, shade, shade)).unwrap()
    }

    #[test]
    fn pictures_stand_in_a_row_or_a_column_with_ground_between() {
        let pictures = [picture(2, 3, 10), picture(1, 1, 20)];
        let reds = |sheet: &Pixmap| -> Vec<u8> { sheet.pixels().iter().map(|p| p.red()).collect() };
        let of = |layout: fn(&[[u32; 2]], u32) -> Option<Layout>, pictures: &[Pixmap]| {
            let sizes: Vec<[u32; 2]> = pictures.iter().map(|picture| [picture.width(), picture.height()]).collect();
            sheet(pictures, &layout(&sizes, 1).unwrap(), Rgba::rgb(99, 99, 99)).unwrap()
        };
        let sheet = of(Layout::row, &pictures);
        assert_eq!((sheet.width(), sheet.height()), (4, 3));
        assert_eq!(reds(&sheet), [10, 10, 99, 99, 10, 10, 99, 20, 10, 10, 99, 99]);
        let pictures = [picture(1, 1, 20), picture(3, 2, 10)];
        let sheet = of(Layout::column, &pictures);
        assert_eq!((sheet.width(), sheet.height()), (3, 4));
        assert_eq!(reds(&sheet), [99, 20, 99, 99, 99, 99, 10, 10, 10, 10, 10, 10]);
    }

    #[test]
    fn a_grid_has_rows_with_room_below() {
        let sizes = [[4, 3], [4, 3], [2, 2]];
        let grid = Layout::grid(&sizes, 2, [1, 5], [0, 0]).unwrap();
        // Small pictures stand on the line of their row, above their text.
        assert_eq!(grid, Layout { corners: vec![[0, 0], [5, 0], [1, 9]], size: [9, 3 + 5 + 1 + 2 + 5] });
        let larger = Layout::grid(&sizes, 2, [1, 5], [12, 10]).unwrap();
        assert_eq!(larger, Layout { corners: vec![[1, 0], [6, 0], [2, 9]], size: [12, 16] });
        assert_eq!(
            Layout::grid(&sizes, 9, [1, 0], [0, 0]),
            Layout::row(&sizes, 1).map(|row| Layout { corners: vec![[0, 0], [5, 0], [10, 1]], ..row })
        );
        assert_eq!(Layout::grid(&[], 2, [1, 5], [0, 0]), None);
        assert_eq!(Layout::grid(&[[1, 1]; 3], 3, [u32::MAX, 0], [0, 0]), None);
    }

    #[test]
    fn a_sheet_that_is_empty_or_too_large_is_none() {
        for of in [Layout::row, Layout::column] {
            assert_eq!(of(&[], 1), None);
            assert_eq!(of(&[[1, 1], [1, 1]], u32::MAX), None);
        }
    }

    #[test]
    fn several_stand_in_the_place_of_the_last_one() {
        let rest = Layout::row(&[[3, 4], [3, 4]], 1).unwrap();
        let all = Layout::column(&[[7, 5], rest.size], 1).unwrap().ending_in(&rest);
        assert_eq!(all, Layout { corners: vec![[0, 0], [0, 6], [4, 6]], size: [7, 10] });
    }
}
