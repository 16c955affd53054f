//! The pictures of both sides of a comparison, put together.

use tiny_skia::{ColorU8, Pixmap};

use super::Pixels;
use crate::appearance::Rgba;
use crate::views::{Finish, Hover, Palette, Request, Side, Size, View};

/// The greatest difference of a channel that counts as none, because rounding may cause it.
const SAME: u8 = 8;
/// The longest side of an image whose pixels are counted. A larger one is reduced.
const MOST_COUNTED: u32 = 1024;
/// Pixels from one stripe to the next, and of a stripe, at scale 1.
const STRIPES: (f32, f32) = (6.0, 2.0);

/// The pixels in which the pictures of two sides differ.
pub(super) struct Differences {
    differing: Vec<bool>,
    width: usize,
    color: Rgba,
    /// Pixels from one stripe to the next, and of a stripe.
    stripes: [usize; 2],
}

impl Differences {
    /// The differences that a compared picture marks; `None` if it marks none.
    pub(super) fn marked(request: &Request, pictures: &[Pixels; 2]) -> Option<Self> {
        let compared = request.shot.compared.as_ref().filter(|compared| compared.comparison.differences);
        let color = Palette::of(request.shot.look.style.theme).differing;
        compared.map(|_| Self::new(pictures, color, request.size.scale))
    }

    /// Compares the pictures of two sides. `color` and `scale` belong to the stripes that mark the differing pixels.
    fn new([one, other]: &[Pixels; 2], color: Rgba, scale: f32) -> Self {
        let differing = differing(one, other).collect();
        #[expect(clippy::cast_possible_truncation, reason = "a few pixels")]
        let stripes = [STRIPES.0, STRIPES.1].map(|pixels| (pixels * scale).round().max(1.0) as usize);
        Self { differing, width: one.width as usize, color, stripes }
    }

    /// The opacity of the mark on a pixel of a side that begins in this column of the whole picture; `None` means that
    /// both sides are alike there.
    fn mark(&self, [x, y]: [usize; 2], left: usize) -> Option<u8> {
        let [period, stripe] = self.stripes;
        let is_marked = self.differing.get(y * self.width + x) == Some(&true);
        is_marked.then_some(if (x + left + y) % period < stripe { 220 } else { 90 })
    }

    /// The marks on a side, on a clear background; `None` without memory.
    pub(super) fn marks(&self, side: &Side) -> Option<Pixmap> {
        let Size { width, height, .. } = side.request.size;
        let mut marks = Pixmap::new(width, height)?;
        let Rgba { r, g, b, .. } = self.color;
        for (k, pixel) in marks.pixels_mut().iter_mut().enumerate() {
            if let Some(alpha) = self.mark([k % width as usize, k / width as usize], side.left as usize) {
                *pixel = ColorU8::from_rgba(r, g, b, alpha).premultiply();
            }
        }
        Some(marks)
    }
}

/// True for each pixel of one picture that differs from that of the other.
fn differing<'a>(one: &'a Pixels, other: &'a Pixels) -> impl Iterator<Item = bool> + 'a {
    let differs = |(a, b): (&[u8; 4], &[u8; 4])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > SAME);
    let [one, other] = [one, other].map(|picture| picture.rgba.as_chunks::<4>().0);
    one.iter().zip(other).map(differs)
}

/// The image of each side in its own pixels, for counting those that differ. The count is the same in every size of a
/// picture, and beside any other. `None` for other views.
pub(super) fn counted_requests(sides: &[Side; 2]) -> Option<[Request; 2]> {
    let image = sides[0].request.shot.look.image;
    if sides[0].request.view != View::Image {
        return None;
    }
    let shrink = (f64::from(MOST_COUNTED) / f64::from(image.width.max(image.height).max(1))).min(1.0);
    #[expect(clippy::cast_possible_truncation, reason = "at most as large as before")]
    let [width, height] = [image.width, image.height].map(|side| (f64::from(side) * shrink).round().max(1.0) as u32);
    let size = Size { width, height, scale: 1.0 };
    let finish = Finish { bare: true, ..Finish::default() };
    Some(sides.each_ref().map(|side| Request { size, finish, hover: Hover::default(), ..side.request.clone() }))
}

/// The share of pixels in which two pictures differ, 0 … 1.
pub(super) fn differing_share([one, other]: &[Pixels; 2]) -> f64 {
    let (count, all) =
        differing(one, other).fold((0_usize, 0_usize), |(count, all), differs| (count + usize::from(differs), all + 1));
    count as f64 / all.max(1) as f64
}

/// Puts the columns of each side into the whole picture, with marks on differences if requested.
pub(super) fn joined(whole: &mut Pixels, sides: &[Side; 2], pictures: &[Pixels; 2], differences: Option<&Differences>) {
    let width = whole.width as usize;
    for (side, picture) in sides.iter().zip(pictures) {
        let (inner, left) = (picture.width as usize, side.left as usize);
        for column in side.columns.start as usize..side.columns.end as usize {
            let Some(x) = column.checked_sub(left).filter(|x| *x < inner) else { continue };
            for y in 0..whole.height.min(picture.height) as usize {
                let (from, to) = (4 * (y * inner + x), 4 * (y * width + column));
                let (Some(from_pixel), Some(pixel)) =
                    (picture.rgba.get(from..from + 4), whole.rgba.get_mut(to..to + 4))
                else {
                    continue;
                };
                pixel.copy_from_slice(from_pixel);
                if let Some((alpha, color)) = differences.and_then(|all| Some((all.mark([x, y], left)?, all.color))) {
                    tint(pixel, color, alpha.into());
                }
            }
        }
    }
}

/// Mixes a colour into a premultiplied pixel, which becomes opaque by the share of the colour.
fn tint(pixel: &mut [u8], color: Rgba, share: u16) {
    let mixed = |from: u8, to: u8| {
        let sum = u16::from(to) * share + u16::from(from) * (255 - share);
        u8::try_from((sum + 127) / 255).unwrap_or(u8::MAX)
    };
    for (channel, to) in pixel.iter_mut().zip([color.r, color.g, color.b, 255]) {
        *channel = mixed(*channel, to);
    }
}
