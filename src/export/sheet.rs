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
    /// Pictures of these sizes from left to right, their middles at one height, with `gap` pixels between them. `None`
    /// where there are none, or too many pixels.
    #[must_use]
    pub fn row(sizes: &[[u32; 2]], gap: u32) -> Option<Self> {
        let height = sizes.iter().map(|size| size[1]).max()?;
        let (mut corners, mut left) = (Vec::with_capacity(sizes.len()), 0_u32);
        for [width, own] in sizes {
            corners.push([left, (height - own) / 2]);
            left = left.checked_add(*width)?.checked_add(gap)?;
        }
        Some(Self { corners, size: [left - gap, height] })
    }

    /// Pictures from top to bottom, otherwise as in a [`row`](Self::row).
    #[must_use]
    pub fn column(sizes: &[[u32; 2]], gap: u32) -> Option<Self> {
        let turned: Vec<[u32; 2]> = sizes.iter().map(|[width, height]| [*height, *width]).collect();
        let Self { corners, size: [height, width] } = Self::row(&turned, gap)?;
        Some(Self { corners: corners.into_iter().map(|[top, left]| [left, top]).collect(), size: [width, height] })
    }

    /// The last picture replaced by several: those of another layout, which is as large.
    #[must_use]
    pub fn ending_in(mut self, rest: &Self) -> Self {
        if let Some([left, top]) = self.corners.pop() {
            self.corners.extend(rest.corners.iter().map(|[x, y]| [left + x, top + y]));
        }
        self
    }
}

/// The pictures at their places on a ground. `None` where the sheet would be empty or too large for memory.
#[must_use]
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

/// Copies a picture to a corner of the sheet, on which it has room.
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
