//! **Divide**: clip → NDC.
//!
//! *Notes*: `[0]` Eq. (5.6), (x_n, y_n, z_n) = (x_r, y_r, z_r) / w_r; `[2]` on why clipping has to come first.
//! *Textbook*: three divisions. *Here*: one division, 1/w, and products with it. The depth isn't z_n, which is −1 at F
//! and crowds nearly everything next to 1, but the reversed depth of [`DepthScale`]: linear in 1/w too, so that it's
//! linear over a face on the image, but 0 at the far end, where floating-point numbers are densest. Vertices outside
//! the volume are divided as well, since that is faster than a test. No face uses their results. In parallel projection
//! w is 1, and the division changes nothing.

use crate::pipeline::space::depths::DepthScale;
use crate::pipeline::space::point::{ClipPoint, NdcPoint};

/// Divides by w. The depth is clamped to its range, for rounding and for points outside the volume.
#[inline(always)]
pub(crate) fn divide(depths: &DepthScale, p: ClipPoint) -> NdcPoint {
    let inverse_w = 1.0 / p.w;
    NdcPoint {
        x: p.x * inverse_w,
        y: p.y * inverse_w,
        depth: clamp(depths.depth_by(p.depth, inverse_w), depths.greatest()),
    }
}

/// Clamps to 0 … limit. Not a number becomes 0.
#[inline(always)]
pub(crate) fn clamp(value: f64, limit: f64) -> f64 {
    let v = if value > 0.0 { value } else { 0.0 };
    if v < limit { v } else { limit }
}
