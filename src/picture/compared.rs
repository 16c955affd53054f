//! The pictures of both sides of a comparison, put together.

use super::Pixels;
use crate::appearance::Rgba;
use crate::views::Side;

/// The greatest difference of a channel that counts as none: what rounding makes.
const SAME: u8 = 8;
/// Pixels from one stripe to the next, and of a stripe, at scale 1.
const STRIPES: (f32, f32) = (6.0, 2.0);

/// The columns of each side, over those of the first; the share of pixels that differ, which are marked if a colour is
/// given. `scale`: of the stripes.
pub(super) fn joined(
    whole: &mut Pixels,
    sides: &[Side; 2],
    pictures: &[Pixels; 2],
    mark: Option<Rgba>,
    scale: f32,
) -> Option<f64> {
    let width = whole.width as usize;
    let marked = mark.map(|color| {
        let differing = differing(pictures);
        let count = differing.iter().filter(|differs| **differs).count();
        (differing, count, color)
    });
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few pixels")]
    let [period, stripe] = [STRIPES.0, STRIPES.1].map(|pixels| (pixels * scale).round().max(1.0) as usize);
    for (side, picture) in sides.iter().zip(pictures) {
        let inner = picture.width as usize;
        for column in side.columns.start as usize..side.columns.end as usize {
            let Some(x) = column.checked_sub(side.left as usize).filter(|x| *x < inner) else { continue };
            for y in 0..whole.height.min(picture.height) as usize {
                let (from, to) = (4 * (y * inner + x), 4 * (y * width + column));
                let (Some(from_pixel), Some(pixel)) =
                    (picture.rgba.get(from..from + 4), whole.rgba.get_mut(to..to + 4))
                else {
                    continue;
                };
                pixel.copy_from_slice(from_pixel);
                if let Some((differing, _, color)) = &marked
                    && differing.get(y * inner + x) == Some(&true)
                {
                    tint(pixel, *color, if (column + y) % period < stripe { 220 } else { 90 });
                }
            }
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "a share")]
    marked.map(|(differing, count, _)| count as f64 / differing.len().max(1) as f64)
}

/// For each pixel whether the two pictures differ there.
fn differing([one, other]: &[Pixels; 2]) -> Vec<bool> {
    let pixels = |picture: &Pixels| picture.rgba.as_chunks::<4>().0.to_vec();
    let differs = |(a, b): (&[u8; 4], &[u8; 4])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > SAME);
    pixels(one).iter().zip(&pixels(other)).map(differs).collect()
}

/// Mixes a colour into a premultiplied pixel, which becomes as opaque as it is mixed.
fn tint(pixel: &mut [u8], color: Rgba, share: u16) {
    let mixed = |from: u8, to: u8| {
        let sum = u16::from(to) * share + u16::from(from) * (255 - share);
        u8::try_from((sum + 127) / 255).unwrap_or(u8::MAX)
    };
    for (channel, to) in pixel.iter_mut().zip([color.r, color.g, color.b, 255]) {
        *channel = mixed(*channel, to);
    }
}
