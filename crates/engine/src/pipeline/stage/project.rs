//! View → clip: the projection matrix of a symmetric window, which [`oblique`] completes.
//!
//! *Notes*: `[0]` §5.3.2, M_p by Eqs. (5.14) and (5.16). It has no stage of its own in `[3]` §1.1, where it belongs to
//! the geometric transformations of step 3, and its work is counted as that of [`Transform`](crate::stage::Stage).
//! *Textbook*: a product with a 4 × 4 matrix, most of whose entries are 0. *Here*: the two entries that scale x_c and
//! y_c. The third row isn't computed. Far away z_r comes so close to w_r that their difference is lost to rounding, and
//! z_n crowds next to 1. So a [`ClipPoint`] carries the distance −z_c instead, and the divide makes a depth of it.

use super::oblique::oblique;
use crate::pipeline::space::point::{ClipPoint, ViewPoint, WorldPoint};
use crate::pipeline::space::projector::Projector;

/// Takes a view point to the clip space of a window whose middle lies on the axis.
#[inline(always)]
pub(crate) fn project(projector: &Projector, ViewPoint(p): ViewPoint) -> ClipPoint {
    let depth = -p.z;
    let w = if projector.perspective { depth } else { 1.0 };
    ClipPoint { x: projector.scale[0] * p.x, y: projector.scale[1] * p.y, w, depth }
}

/// Takes a view point to clip space, whatever the window.
#[inline(always)]
pub(crate) fn clip_from_view(projector: &Projector, p: ViewPoint) -> ClipPoint {
    oblique(projector, project(projector, p))
}

/// Takes a world point to clip space.
pub(crate) fn clip_from_world(projector: &Projector, p: WorldPoint) -> ClipPoint {
    clip_from_view(projector, projector.view(p))
}
