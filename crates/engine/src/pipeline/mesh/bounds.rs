//! Bounds of a mesh, known before it is looked at: the box and the ball around it.

use std::collections::HashMap;
use std::sync::{Arc, Weak};

use crate::geometry::Aabb;
use crate::scene::Mesh;

/// The bounds of a mesh, in its own space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    /// The box around all finite vertices.
    pub(crate) aabb: Aabb,
    /// The ball around the middle of the box that holds all vertices.
    pub(crate) radius: f64,
    /// Every coordinate is a number.
    pub(crate) finite: bool,
}

/// The bounds of the meshes of earlier pictures, by their addresses. No other mesh gets an address as long as the weak
/// pointer to it exists, and a mesh doesn't change as long as it's shared.
#[derive(Debug, Default)]
pub(crate) struct KnownBounds(HashMap<usize, (Weak<Mesh>, Option<Bounds>)>);

impl KnownBounds {
    /// The bounds of a mesh; `None` without a finite vertex.
    pub(crate) fn of(&mut self, mesh: &Arc<Mesh>) -> Option<Bounds> {
        let new = || (Arc::downgrade(mesh), Bounds::of(mesh));
        self.0.entry(Arc::as_ptr(mesh).addr()).or_insert_with(new).1
    }

    /// Forgets meshes that are gone, once there are many more than the `count` objects of a picture can have.
    pub(crate) fn forget_gone(&mut self, count: usize) {
        if self.0.len() > 2 * count + 16 {
            self.0.retain(|_, (mesh, _)| mesh.strong_count() > 0);
        }
    }
}

impl Bounds {
    /// `None` without a finite vertex.
    pub(crate) fn of(mesh: &Mesh) -> Option<Self> {
        let aabb = mesh.bounds()?;
        let middle = aabb.center();
        let (square, finite) = mesh.positions.iter().fold((0.0_f64, true), |(square, finite), p| {
            let distance = (*p - middle).length_squared();
            (square.max(distance), finite & distance.is_finite())
        });
        Some(Self { aabb, radius: square.sqrt(), finite })
    }
}
