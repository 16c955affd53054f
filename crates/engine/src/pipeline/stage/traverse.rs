//! **Traverse**: walk through the scene.
//!
//! *Notes*: `[3]` §1.1 step 1 and §1.4: a scene is a tree, and the walk multiplies the matrices of an object's
//! ancestors to place it in the world. *Textbook*: a recursion with a stack of matrices, for each picture. *Here*: the
//! products are made once, when the scene is built ([`build`](crate::scene::build)), because the camera moves far more
//! often than the scene changes. What remains for a picture is a walk through a list.

use crate::pipeline::plan::{ObjectPlan, Plan};
use crate::pipeline::scenes::Scenes;
use crate::scene::Object;

/// The objects to draw in the order of the scene, each with its index and its plan: those that
/// [`cull_objects`](super::cull_objects::cull_objects) left.
pub(crate) fn traverse<'a>(
    scenes: Scenes<'a>,
    plan: &'a Plan,
) -> impl Iterator<Item = (usize, &'a Object, &'a ObjectPlan)> {
    let objects = scenes.objects().zip(&plan.objects).enumerate();
    objects.filter(|(_, (_, planned))| planned.drawn).map(|(index, (object, planned))| (index, object, planned))
}
