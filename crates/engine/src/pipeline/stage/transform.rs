//! **Transform**: object → world → view.
//!
//! *Notes*: `[0]` §5.3.1 takes each vertex by the model matrix M_m to the world and by the view matrix M_v, Eq. (5.7),
//! to the view space of the camera; `[3]` §1.1 has it as step 3. *Textbook*: one product with the 4 × 4 matrix
//! M_v · M_m. *Here*: M_v is a rotation after a translation, and the two stay apart: first the difference p − C
//! ([`ViewFromObject::offset_from_eye`]), then the rotation ([`transform()`]). An object far from the origin keeps its
//! digits, since no product of large numbers has to cancel. The difference is made in the space of the object, into
//! which C is taken once, and M_m is multiplied into the rotation, so that object → world costs a vertex nothing. Only
//! if M_m can't be inverted well does a vertex really pass through the world.

use crate::pipeline::space::point::{FromEye, ObjectPoint, ViewPoint};
use crate::pipeline::space::projector::ViewFromObject;

/// The second half of the stage: takes the difference p − C into view space. The first half is
/// [`ViewFromObject::offset_from_eye`], and [`view_point`] does both.
#[inline(always)]
pub(crate) fn transform(view_from_object: &ViewFromObject, from_eye: FromEye) -> ViewPoint {
    ViewPoint(view_from_object.linear * from_eye.0)
}

/// Takes a point of an object all the way to view space.
#[inline(always)]
pub(crate) fn view_point(view_from_object: &ViewFromObject, p: ObjectPoint) -> ViewPoint {
    transform(view_from_object, view_from_object.offset_from_eye(p))
}
