//! Several pictures on one sheet.

use tiny_skia::Pixmap;

use crate::appearance::Rgba;

/// The pictures from left to right, their middles at one height, with `gap` pixels of `ground` between them. `None`
/// where the sheet would be empty or too large for memory.
#[must_use]
pub fn row(pictures: &[Pixmap], gap: u32, ground: Rgba) -> Option<Pixmap> {
    let length = length(pictures, Pixmap::width, gap)?;
    let mut sheet = filled(length, pictures.iter().map(Pixmap::height).max()?, ground)?;
    let mut left = 0;
    for picture in pictures {
        let top = (sheet.height() - picture.height()) / 2;
        put(&mut sheet, picture, [left, top]);
        left += picture.width() + gap;
    }
    Some(sheet)
}

/// The pictures from top to bottom, otherwise as in a [`row`].
#[must_use]
pub fn column(pictures: &[Pixmap], gap: u32, ground: Rgba) -> Option<Pixmap> {
    let length = length(pictures, Pixmap::height, gap)?;
    let mut sheet = filled(pictures.iter().map(Pixmap::width).max()?, length, ground)?;
    let mut top = 0;
    for picture in pictures {
        let left = (sheet.width() - picture.width()) / 2;
        put(&mut sheet, picture, [left, top]);
        top += picture.height() + gap;
    }
    Some(sheet)
}

/// The sides of all pictures with the gaps between them.
fn length(pictures: &[Pixmap], side: fn(&Pixmap) -> u32, gap: u32) -> Option<u32> {
    let gaps = gap.checked_mul(u32::try_from(pictures.len().checked_sub(1)?).ok()?)?;
    pictures.iter().try_fold(gaps, |sum, picture| sum.checked_add(side(picture)))
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
        let sheet = row(&pictures, 1, Rgba::rgb(99, 99, 99)).unwrap();
        assert_eq!((sheet.width(), sheet.height()), (4, 3));
        assert_eq!(reds(&sheet), [10, 10, 99, 99, 10, 10, 99, 20, 10, 10, 99, 99]);
        let pictures = [picture(1, 1, 20), picture(3, 2, 10)];
        let sheet = column(&pictures, 1, Rgba::rgb(99, 99, 99)).unwrap();
        assert_eq!((sheet.width(), sheet.height()), (3, 4));
        assert_eq!(reds(&sheet), [99, 20, 99, 99, 99, 99, 10, 10, 10, 10, 10, 10]);
    }

    #[test]
    fn a_sheet_that_is_empty_or_too_large_is_none() {
        for of in [row, column] {
            assert_eq!(of(&[], 1, Rgba::rgb(0, 0, 0)), None);
            assert_eq!(of(&[picture(1, 1, 0), picture(1, 1, 0)], u32::MAX, Rgba::rgb(0, 0, 0)), None);
        }
    }
}
