//! A picture without the empty background around its content.

use tiny_skia::{IntRect, Pixmap};

/// The part of a picture that differs from its background, the pixel at the top left, with `margin` pixels around it,
/// and its corner. The whole picture if nothing differs.
pub fn cropped(pixmap: Pixmap, margin: u32) -> (Pixmap, [u32; 2]) {
    let [left, top, ..] = part(&pixmap, margin);
    match content(&pixmap, margin).and_then(|rect| pixmap.clone_rect(rect)) {
        Some(part) => (part, [left, top]),
        None => (pixmap, [0; 2]),
    }
}

/// The left, top, width and height of the part that [`cropped`] keeps.
pub fn part(pixmap: &Pixmap, margin: u32) -> [u32; 4] {
    let whole = [0, 0, pixmap.width(), pixmap.height()];
    let kept = content(pixmap, margin).and_then(|rect| {
        Some([u32::try_from(rect.left()).ok()?, u32::try_from(rect.top()).ok()?, rect.width(), rect.height()])
    });
    kept.unwrap_or(whole)
}

fn content(pixmap: &Pixmap, margin: u32) -> Option<IntRect> {
    let width = pixmap.width() as usize;
    let pixels = pixmap.pixels();
    let ground = *pixels.first()?;
    let (mut left, mut right) = (u32::MAX, 0);
    let (mut top, mut bottom) = (u32::MAX, 0);
    for (y, row) in (0..).zip(pixels.chunks_exact(width)) {
        let differs = |pixel: &tiny_skia::PremultipliedColorU8| *pixel != ground;
        let (Some(first), Some(last)) = (row.iter().position(differs), row.iter().rposition(differs)) else { continue };
        #[expect(clippy::cast_possible_truncation, reason = "a column of a picture")]
        let (first, last) = (first as u32, last as u32);
        (left, right) = (left.min(first), right.max(last));
        (top, bottom) = (top.min(y), y);
    }
    if left > right {
        return None;
    }
    let (left, top) = (left.saturating_sub(margin), top.saturating_sub(margin));
    let right = right.saturating_add(margin).min(pixmap.width() - 1);
    let bottom = bottom.saturating_add(margin).min(pixmap.height() - 1);
    IntRect::from_xywh(i32::try_from(left).ok()?, i32::try_from(top).ok()?, right - left + 1, bottom - top + 1)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use tiny_skia::PremultipliedColorU8;

    #[test]
    fn only_the_ground_around_goes() {
        let mut pixmap = Pixmap::new(20, 10).unwrap();
        let ink = PremultipliedColorU8::from_rgba(9, 9, 9, 255).unwrap();
        for (x, y) in [(5, 3), (11, 6)] {
            pixmap.pixels_mut()[y * 20 + x] = ink;
        }
        let part = cropped(pixmap.clone(), 0).0;
        assert_eq!((part.width(), part.height()), (7, 4));
        assert_eq!((part.pixels()[0], part.pixels()[27]), (ink, ink));
        // The margin ends at the border.
        let part = cropped(pixmap, 4).0;
        assert_eq!((part.width(), part.height()), (15, 10));
        let empty = Pixmap::new(4, 3).unwrap();
        assert_eq!(cropped(empty.clone(), 1).0, empty);
    }
}
