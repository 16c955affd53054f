//! The view volume: eight corners, six planes.

use glam::DVec3;

use super::{Camera, Projection};
use crate::geometry::Plane;
use crate::geometry::double_double::{Dd, Dd3};

impl Camera {
    /// Eight world points: near (l,b) (r,b) (r,t) (l,t), then far in the same order. (`[0]` §5.3.2 prints −F for the
    /// depth of the back face; it lies at −B.)
    ///
    /// *Guarantees*: the `f64` nearest to the exact corner, component by component (but for ties too close to call).
    pub fn volume_corners(&self) -> [DVec3; 8] {
        let w = &self.wide_window;
        let corners = [(w.left, w.bottom), (w.right, w.bottom), (w.right, w.top), (w.left, w.top)];
        let (near, far) = (Dd::new(self.near()), Dd::new(self.far()));
        let spread = match self.projection() {
            Projection::Perspective => far / near,
            Projection::Parallel => Dd::ONE,
        };
        std::array::from_fn(|i| {
            let (x, y) = corners[i % 4];
            let (s, depth) = if i < 4 { (Dd::ONE, near) } else { (spread, far) };
            self.world_of_view(Dd3::new(x * s, y * s, -depth)).value()
        })
    }

    /// Six world planes, inside positive: left, right, bottom, top, near, far.
    ///
    /// *Guarantees*: normals of unit length to the last digit; the offsets are those of the exact planes, rounded.
    pub fn volume_planes(&self) -> [Plane; 6] {
        let w = &self.wide_window;
        let (near, far) = (Dd::new(self.near()), Dd::new(self.far()));
        let (one, zero) = (Dd::ONE, Dd::ZERO);
        // Normal (not yet of unit length) and offset in the VRC.
        let planes = match self.projection() {
            Projection::Perspective => [
                (Dd3::new(near, zero, w.left), zero),
                (Dd3::new(-near, zero, -w.right), zero),
                (Dd3::new(zero, near, w.bottom), zero),
                (Dd3::new(zero, -near, -w.top), zero),
                (Dd3::new(zero, zero, -one), -near),
                (Dd3::new(zero, zero, one), far),
            ],
            Projection::Parallel => [
                (Dd3::new(one, zero, zero), -w.left),
                (Dd3::new(-one, zero, zero), w.right),
                (Dd3::new(zero, one, zero), -w.bottom),
                (Dd3::new(zero, -one, zero), w.top),
                (Dd3::new(zero, zero, -one), -near),
                (Dd3::new(zero, zero, one), far),
            ],
        };
        planes.map(|(normal, offset)| {
            let normal = self.world_direction(normal.unit());
            Plane { normal: normal.value(), offset: (offset - normal.dot(self.pose.position)).value() }
        })
    }

    /// A direction of the VRC in the world.
    pub(super) fn world_direction(&self, d: Dd3) -> Dd3 {
        self.frame.u * d.x + self.frame.v * d.y + self.frame.n * d.z
    }

    /// A point of the VRC in the world.
    pub(super) fn world_of_view(&self, p: Dd3) -> Dd3 {
        self.pose.position + self.world_direction(p)
    }
}
