//! The way of a vertex: object → world → view → clip → NDC → pixels, in the order in which it goes.
//!
//! | stage | from → to | function |
//! | --- | --- | --- |
//! | Transform | object → view | [`transform()`], [`view_point`] |
//! | – projection of a symmetric window | view → clip | [`project_symmetric`] |
//! | Oblique window | clip | [`oblique`], and both as [`clip_from_view`] |
//! | Divide | clip → NDC | [`divide`] |
//! | Viewport | NDC → pixels | [`viewport()`], then [`snap`] to the grid of the image |
//!
//! [`vertices`](super::vertices) calls them in one loop over the vertices of an object.

use crate::appearance::VertexFormat;
use crate::drawing::single;
use crate::pipeline::space::depths::DepthScale;
use crate::pipeline::space::projector::{Projector, ViewFromObject, rounded};
use crate::pipeline::space::{ClipPoint, FromEye, NdcPoint, ObjectPoint, Pixel, Screen, ViewPoint, WorldPoint};
use crate::simd::round_to_steps;

/// **Transform**: object → world → view.
///
/// *Notes*: `[0]` §5.3.1 takes each vertex by the model matrix M_m to the world and by the view matrix M_v, Eq. (5.7),
/// to the view space of the camera; `[3]` §1.1 has it as step 3. *Textbook*: one product with the 4 × 4 matrix
/// M_v · M_m. *Here*: M_v is a rotation after a translation, and the two stay apart: first the difference p − C
/// ([`ViewFromObject::offset_from_eye`]), then the rotation ([`transform()`]). An object far from the origin keeps its
/// digits, since no product of large numbers has to cancel. The difference is made in the space of the object, into
/// which C is taken once, and M_m is multiplied into the rotation, so that object → world costs a vertex nothing. Only
/// if M_m can't be inverted well does a vertex really pass through the world.
///
/// The second half of the stage: takes the difference p − C into view space. The first half is
/// [`ViewFromObject::offset_from_eye`], and [`view_point`] does both.
#[inline(always)]
pub(crate) fn transform(view_from_object: &ViewFromObject, from_eye: FromEye) -> ViewPoint {
    ViewPoint(view_from_object.linear * from_eye.0)
}

/// Takes a point of an object all the way to view space, and rounds it to the format of the style.
#[inline(always)]
pub(crate) fn view_point(view_from_object: &ViewFromObject, p: ObjectPoint) -> ViewPoint {
    let ViewPoint(p) = transform(view_from_object, view_from_object.offset_from_eye(p));
    ViewPoint(rounded(view_from_object.format, p))
}

/// View → clip: the projection matrix of a symmetric window, which [`oblique`] completes.
///
/// *Notes*: `[0]` §5.3.2, M_p by Eqs. (5.14) and (5.16). It has no stage of its own in `[3]` §1.1, where it belongs to
/// the geometric transformations of step 3, and its work is counted as that of [`Transform`](crate::stage::Stage).
/// *Textbook*: a product with a 4 × 4 matrix, most of whose entries are 0. *Here*: the two entries that scale x_c and
/// y_c. The third row isn't computed. Far away z_r comes so close to w_r that their difference is lost to rounding, and
/// z_n crowds next to 1. So a [`ClipPoint`] carries the distance −z_c instead, and the divide makes a depth of it.
///
/// Takes a view point to the clip space of a window whose middle lies on the axis.
#[inline(always)]
pub(crate) fn project_symmetric(projector: &Projector, ViewPoint(p): ViewPoint) -> ClipPoint {
    let distance = -p.z;
    let w = if projector.projection.is_perspective() { distance } else { 1.0 };
    ClipPoint { x: projector.scale[0] * p.x, y: projector.scale[1] * p.y, w, distance }
}

/// Takes a view point to clip space, whatever the window, and rounds it to the format of the style.
#[inline(always)]
pub(crate) fn clip_from_view(projector: &Projector, p: ViewPoint) -> ClipPoint {
    let p = oblique(projector, project_symmetric(projector, p));
    if projector.format == VertexFormat::F64 { p } else { rounded_clip_point(projector, p) }
}

/// Rounds x_r, y_r, z_r and w_r as `[0]` §5.3.2 defines them. The distance becomes the one that z_r and w_r stand for,
/// by w − z = 2F(B − d)/(B − F), or 2(B − d)/(B − F) in parallel projection.
#[cold]
fn rounded_clip_point(projector: &Projector, p: ClipPoint) -> ClipPoint {
    let Projector { near, far, format, projection, .. } = *projector;
    let unit = 2.0 * if projection.is_perspective() { near } else { 1.0 } / (far - near);
    let z = format.round(p.w - unit * (far - p.distance));
    let [x, y, w] = [p.x, p.y, p.w].map(|x| format.round(x));
    ClipPoint { x, y, w, distance: far - (w - z) / unit }
}

/// Takes a world point to clip space.
pub(crate) fn clip_from_world(projector: &Projector, p: WorldPoint) -> ClipPoint {
    clip_from_view(projector, projector.view(p))
}

/// **Oblique window**: the terms of a window whose middle doesn't lie on the axis.
///
/// *Notes*: `[0]` §5.3.2, the terms (r + l)/(r − l) and (t + b)/(t − b) of Eqs. (5.13) and (5.15). The window of `[3]`
/// §1.5 is always centred and has none. *Textbook*: they are entries of M_p, and every vertex pays for them. *Here*: a
/// step of its own, so that the pipeline can say when it has nothing to do: for a symmetric window both terms are 0. It
/// isn't skipped then. A product and a difference in a loop that is waiting for memory cost less than a test.
///
/// Shifts a point that was projected as by a symmetric window.
#[inline(always)]
pub(crate) fn oblique(projector: &Projector, p: ClipPoint) -> ClipPoint {
    ClipPoint { x: p.x - projector.shift[0] * p.w, y: p.y - projector.shift[1] * p.w, ..p }
}

/// **Divide**: clip → NDC.
///
/// *Notes*: `[0]` Eq. (5.6), (x_n, y_n, z_n) = (x_r, y_r, z_r) / w_r; `[2]` on why clipping has to come first.
/// *Textbook*: three divisions. *Here*: one division, 1/w, and products with it. The depth isn't z_n, which is −1 at F
/// and crowds nearly everything next to 1, but the reversed depth of [`DepthScale`]: linear in 1/w too, so that it's
/// linear over a face on the image, but 0 at the far end, where floating-point numbers are densest. Vertices outside
/// the volume are divided as well, since that is faster than a test. No face uses their results. In parallel projection
/// w is 1, and the division changes nothing.
///
/// Divides by w. The depth is clamped to its range, for rounding and for points outside the volume.
#[inline(always)]
pub(crate) fn divide(depths: &DepthScale, p: ClipPoint) -> NdcPoint {
    let inverse_w = 1.0 / p.w;
    NdcPoint {
        x: p.x * inverse_w,
        y: p.y * inverse_w,
        depth: clamp(depths.depth_by(p.distance, inverse_w), depths.greatest()),
    }
}

/// Clamps to 0 … limit. Not a number becomes 0.
#[inline(always)]
pub(crate) fn clamp(value: f64, limit: f64) -> f64 {
    let v = if value > 0.0 { value } else { 0.0 };
    if v < limit { v } else { limit }
}

/// **Viewport**: NDC → pixels, and from there to the grid of the image.
///
/// *Notes*: `[0]` §5.5. The code is Eq. (5.24) for a viewport that fills the image, with y down as in (5.22). The depth
/// needs no (5.25), because the divide has made it already. `[3]` §1.2 calls it the mapping to device coordinates.
/// *Textbook*: a product, a sum and ⌊ ⌋ for each coordinate. *Here*: no ⌊ ⌋ to whole pixels, since a triangle with such
/// corners would jump from pixel to pixel as it moves. [`snap`] rounds to 1/256 of a pixel instead, and only then
/// leaves `f64`: the sums and products in which the rasterizer decides what a triangle covers are exact on that grid,
/// so that neighbours never leave a gap or overlap.
///
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

/// Rounds a pixel to the grid of the image, exactly: a corner of a triangle as the display list holds it.
#[inline(always)]
pub(crate) fn snap(screen: &Screen, p: Pixel) -> [f32; 3] {
    unsnapped(Pixel { x: round_to_steps(p.x, screen.steps), y: round_to_steps(p.y, screen.steps), ..p })
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
        let screen = Screen { half_width: 100.0, half_height: 100.0, steps: 256.0 };
        let snapped = |x: f64, y: f64| snap(&screen, Pixel { x, y, depth: 0.5 });
        assert_eq!(snapped(10.0, 0.0), [10.0, 0.0, 0.5]);
        assert_eq!(snapped(100.0 + 1.4 / 256.0, 3.0 + 1.6 / 256.0), [100.0 + 1.0 / 256.0, 3.0078125, 0.5]);
    }
}
