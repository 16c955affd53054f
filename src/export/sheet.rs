//! Several pictures on one sheet.

use tiny_skia::Pixmap;

use crate::appearance::Rgba;

/// The pictures side by side from the left, their tops aligned, with `gap` pixels of `ground` between them. `None` where the
/// sheet would be empty or too large for memory.
#[must_use]
pub fn side_by_side(pictures: &[Pixmap], gap: u32, ground: Rgba) -> Option<Pixmap> {
    let gaps = gap.checked_mul(u32::try_from(pictures.len().checked_sub(1)?).ok()?)?;
    let width = pictures.iter().try_fold(gaps, |sum, picture| sum.checked_add(picture.width()))?;
    let height = pictures.iter().map(Pixmap::height).max()?;
    let mut sheet = Pixmap::new(width, height)?;
    sheet.fill(tiny_skia::Color::from_rgba8(ground.r, ground.g, ground.b, ground.a));
    let row = 4 * width as usize;
    let mut left = 0;
    for picture in pictures {
        let length = 4 * picture.width() as usize;
        for (from, to) in picture.data().chunks_exact(length).zip(sheet.data_mut().chunks_exact_mut(row)) {
            to[left..left + length].copy_from_slice(from);
        }
        left += length + 4 * gap as usize;
    }
    Some(sheet)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;

    #[test]
    fn pictures_stand_side_by_side_with_ground_between() {
        let picture = |width, height, shade| {
            let mut pixmap = Pixmap::new(width, height).unwrap();
            pixmap.fill(tiny_skia::Color::from_rgba8(shade, shade, shade, 255));
            pixmap
        };
        let sheet = side_by_side(&[picture(2, 2, 10), picture(1, 1, 20)], 1, Rgba::rgb(99, 99, 99)).unwrap();
        assert_eq!((sheet.width(), sheet.height()), (4, 2));
        let reds: Vec<u8> = sheet.pixels().iter().map(|p| p.red()).collect();
        assert_eq!(reds, [10, 10, 99, 20, 10, 10, 99, 99]);
        assert_eq!(side_by_side(&[], 1, Rgba::rgb(0, 0, 0)), None);
        assert_eq!(side_by_side(&[picture(1, 1, 0), picture(1, 1, 0)], u32::MAX, Rgba::rgb(0, 0, 0)), None);
    }
}
