//! The spaces of a point as types (object → world → view → clip → NDC → pixel), the camera between them, the six planes
//! of the view volume, and the image.
//!
//! Each stage of a vertex is a function from one of these types to the next, so that no point can skip a space
//! unnoticed: [`transform`](crate::pipeline::stage::vertex::transform),
//! [`project_symmetric`](crate::pipeline::stage::vertex::project_symmetric),
//! [`oblique`](crate::pipeline::stage::vertex::oblique), [`divide`](crate::pipeline::stage::vertex::divide),
//! [`viewport`](crate::pipeline::stage::vertex::viewport) and [`snap`](crate::pipeline::stage::vertex::snap). Up to the
//! pixel everything is `f64`.

pub mod depths;
pub(crate) mod projector;

use glam::{DVec2, DVec3};

use super::Target;
use crate::appearance::SubpixelBits;
use projector::Projector;

/// A point in the space of its object: the local coordinates of `[0]` §5.3.1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ObjectPoint(pub(crate) DVec3);

/// A point in the world, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WorldPoint(pub(crate) DVec3);

/// The way from the eye to a point, still along the axes of the world or of the object. The difference p − C, before
/// anything is rotated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FromEye(pub(crate) DVec3);

/// A point in view space (VRC): x_c to the right, y_c up, z_c towards the viewer, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ViewPoint(pub(crate) DVec3);

/// A point in clip space: x_r, y_r and w_r of `[0]` Eq. (5.8), with the distance from the eye instead of z_r. Far
/// away z_r differs from w_r by less and less, and rounding loses that. The distance keeps it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClipPoint {
    /// x, in \[−w, w\] inside the volume.
    pub(crate) x: f64,
    /// y, in \[−w, w\] inside the volume.
    pub(crate) y: f64,
    /// Homogeneous w: `distance` in perspective, 1 in parallel projection.
    pub(crate) w: f64,
    /// Distance from the plane through the eye, −z_c, in scene units; in \[F, B\] inside the volume.
    pub(crate) distance: f64,
}

/// A point after the divide: x_n and y_n in \[−1, 1\] inside the volume, and the depth instead of z_n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NdcPoint {
    /// x_n, to the right.
    pub(crate) x: f64,
    /// y_n, up.
    pub(crate) y: f64,
    /// The depth that the depth buffer holds: 0 for the farthest point in view, greater for nearer ones
    /// ([`DepthScale`](depths::DepthScale)).
    pub(crate) depth: f64,
}

/// A point on the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pixel {
    /// Pixels from the left side of the image.
    pub(crate) x: f64,
    /// Pixels from its upper side.
    pub(crate) y: f64,
    /// The depth of the [`NdcPoint`].
    pub(crate) depth: f64,
}

/// The planes of the volume, each a linear function of the clip point, positive inside `[2]`. In the order of the
/// distances: left, right, bottom, top, near, far.
pub(crate) const PLANES: usize = 6;

/// A set of planes: bit `i` is plane `i` of left, right, bottom, top, near, far.
pub type PlaneSet = u8;

/// All six planes.
pub(crate) const ALL_PLANES: PlaneSet = 0b11_1111;

/// The near plane.
pub const NEAR: PlaneSet = 1 << 4;

/// The bit of an outcode for "not a number": such a point is drawn nowhere.
pub(crate) const NOT_A_NUMBER: PlaneSet = 0b100_0000;

/// Near and far first, so that w is positive for all planes that follow.
pub(crate) const ORDER: [usize; PLANES] = [4, 5, 0, 1, 2, 3];

/// The six homogeneous distances, positive inside: w + x, w − x, w + y, w − y, and, up to a positive factor, w + z and
/// w − z.
///
/// w + z = 2B(d − F)/(B − F) and w − z = 2F(B − d)/(B − F) with the distance d from the eye, so d − F and B − d decide,
/// without the cancellation of clip z.
#[inline(always)]
pub(crate) fn distances(projector: &Projector, p: ClipPoint) -> [f64; PLANES] {
    [p.w + p.x, p.w - p.x, p.w + p.y, p.w - p.y, p.distance - projector.near, projector.far - p.distance]
}

/// Bit `i` is set if the point is outside plane `i`; [`NOT_A_NUMBER`] if a coordinate isn't a number, or is too large
/// to be cut.
#[inline(always)]
pub(crate) fn outcode(projector: &Projector, p: ClipPoint) -> PlaneSet {
    let size = p.x.abs() + p.y.abs() + p.distance.abs();
    let mut code = 0;
    for (i, distance) in distances(projector, p).into_iter().enumerate() {
        code |= PlaneSet::from(distance < 0.0) << i;
    }
    // False if it isn't a number.
    if size <= f64::MAX / 4.0 { code } else { NOT_A_NUMBER }
}

/// The size of the image.
#[derive(Clone, Debug)]
pub(crate) struct Screen {
    /// Half of the width, pixels.
    pub(crate) half_width: f64,
    /// Half of the height, pixels.
    pub(crate) half_height: f64,
    /// Corners of triangles lie on a grid with so many steps per pixel, so decisions about a triangle (its orientation,
    /// its coverage) are exact arithmetic on the very numbers that are drawn.
    pub(crate) steps: f64,
}

impl Screen {
    /// With the grid of 1/256 pixel.
    pub(crate) fn new(target: Target) -> Self {
        let [half_width, half_height] = [target.width, target.height].map(|side| f64::from(side) / 2.0);
        Self { half_width, half_height, steps: SubpixelBits::default().steps() }
    }

    /// Half of the image's width and height, pixels.
    pub(crate) fn half_size(&self) -> DVec2 {
        DVec2::new(self.half_width, self.half_height)
    }

    /// A point of the window, by its x_n and y_n, in pixels (y down).
    pub(crate) fn pixels(&self, ndc: DVec2) -> DVec2 {
        self.half_size() + DVec2::new(ndc.x, -ndc.y) * self.half_size()
    }

    /// Greatest distance by which [`snap`](crate::pipeline::stage::vertex::snap) moves a point of this image, pixels:
    /// half a step of the grid in x and in y, and no more than that by single precision, as long as that has the steps.
    pub(crate) fn snap_distance(&self) -> f64 {
        let single = 2.0 * self.half_size().max_element() * f64::from(f32::EPSILON);
        2.0 * (0.5 / self.steps).max(single)
    }
}
