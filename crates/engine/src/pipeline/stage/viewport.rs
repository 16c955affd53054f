//! **Viewport**: NDC → pixels, and from there to the grid of the image.
//!
//! *Notes*: `[0]` §5.5. The code is Eq. (5.24) for a viewport that fills the image, with y down as in (5.22). The depth
//! needs no (5.25), because the divide has made it already. `[3]` §1.2 calls it the mapping to device coordinates.
//! *Textbook*: a product, a sum and ⌊ ⌋ for each coordinate. *Here*: no ⌊ ⌋ to whole pixels, since a triangle with such
//! corners would jump from pixel to pixel as it moves. [`snap`] rounds to 1/256 of a pixel instead, and only then
//! leaves `f64`: the sums and products in which the rasterizer decides what a triangle covers are exact on that grid,
//! so that neighbours never leave a gap or overlap.

use super::divide::clamp;
use crate::drawing::single;
use crate::pipeline::space::point::{NdcPoint, Pixel};
use crate::pipeline::space::screen::{SUBPIXELS, Screen};
use crate::simd::round_to_steps;

/// Takes a point inside the volume to the image. The clamp only takes back what rounding adds at the border. A vertex
/// outside the volume lands anywhere on the image, and no face that is drawn uses it.
#[inline(always)]
pub(crate) fn viewport(screen: &Screen, p: NdcPoint) -> Pixel {
    Pixel {
        x: clamp(p.x * screen.half_width + screen.half_width, 2.0 * screen.half_width),
        y: clamp(screen.half_height - p.y * screen.half_height, 2.0 * screen.half_height),
        depth: p.depth,
    }
}

/// Rounds a pixel to the grid of [`SUBPIXELS`], exactly: a corner of a triangle as the display list holds it.
#[inline(always)]
pub(crate) fn snap(p: Pixel) -> [f32; 3] {
    unsnapped(Pixel { x: round_to_steps(p.x, SUBPIXELS), y: round_to_steps(p.y, SUBPIXELS), ..p })
}

/// A pixel as the display list holds points of lines: in single precision, off the grid.
#[inline(always)]
pub(crate) fn unsnapped(p: Pixel) -> [f32; 3] {
    [single(p.x), single(p.y), single(p.depth)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_grid_has_256_places_a_pixel_and_rounds_to_the_nearest() {
        let snapped = |x: f64, y: f64| snap(Pixel { x, y, depth: 0.5 });
        assert_eq!(snapped(10.0, 0.0), [10.0, 0.0, 0.5]);
        assert_eq!(snapped(100.0 + 1.4 / 256.0, 3.0 + 1.6 / 256.0), [100.0 + 1.0 / 256.0, 3.0078125, 0.5]);
    }
}
