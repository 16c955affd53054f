//! Bounds of a mesh, known before it is looked at: the box and the ball around it.

use crate::geometry::Aabb;
use crate::scene::Mesh;

/// The bounds of a mesh, in its own space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    /// The box around all finite vertices.
    pub(super) aabb: Aabb,
    /// The ball around the middle of the box that holds them all.
    pub(super) radius: f64,
    /// Every coordinate is a number.
    pub(super) finite: bool,
}

impl Bounds {
    /// `None` without a finite vertex.
    pub(super) fn of(mesh: &Mesh) -> Option<Self> {
        let aabb = mesh.bounds()?;
        let (middle, mut square, mut finite) = (aabb.center(), 0.0_f64, true);
        for p in &mesh.positions {
            let distance = (*p - middle).length_squared();
            finite &= distance.is_finite();
            square = square.max(distance);
        }
        Some(Self { aabb, radius: square.sqrt(), finite })
    }
}
