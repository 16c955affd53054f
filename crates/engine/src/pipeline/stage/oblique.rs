//! **Oblique window**: the terms of a window whose middle doesn't lie on the axis.
//!
//! *Notes*: `[0]` §5.3.2, the terms (r + l)/(r − l) and (t + b)/(t − b) of Eqs. (5.13) and (5.15). The window of `[3]`
//! §1.5 is always centred and has none. *Textbook*: they are entries of M_p, and every vertex pays for them. *Here*: a
//! step of its own, so that the pipeline can say when it has nothing to do: for a symmetric window both terms are 0. It
//! isn't skipped then. A product and a difference in a loop that is waiting for memory cost less than a test.

use crate::pipeline::space::point::ClipPoint;
use crate::pipeline::space::projector::Projector;

/// Shifts a point that was projected as by a symmetric window.
#[inline(always)]
pub(crate) fn oblique(projector: &Projector, p: ClipPoint) -> ClipPoint {
    ClipPoint { x: p.x - projector.shift[0] * p.w, y: p.y - projector.shift[1] * p.w, ..p }
}
