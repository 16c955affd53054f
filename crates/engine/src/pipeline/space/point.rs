//! The spaces of a point as types: object → world → view → clip → NDC → pixel.
//!
//! Each stage of a vertex is a function from one of these types to the next, so that no point can skip a space
//! unnoticed: [`transform`](crate::pipeline::stage::vertex::transform),
//! [`project_symmetric`](crate::pipeline::stage::vertex::project_symmetric), [`oblique`](crate::pipeline::stage::vertex::oblique),
//! [`divide`](crate::pipeline::stage::vertex::divide), [`viewport`](crate::pipeline::stage::vertex::viewport) and
//! [`snap`](crate::pipeline::stage::vertex::snap). Up to the pixel everything is `f64`.

use glam::DVec3;

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
    /// ([`DepthScale`](super::depths::DepthScale)).
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
