//! A scene under a projective map.

use std::sync::Arc;

use glam::{DMat4, DVec3};

use super::{InWorld, Mesh, Scene};

impl Scene {
    /// Moves everything by a projective map that keeps orientation. Positions are divided by their w, and planes are
    /// transformed too. Normals and lights are dropped, so lit objects must have their colours already. An object,
    /// line, mark or text with a point of w ≤ 0 is left out.
    pub fn project(&mut self, matrix: &DMat4) {
        let place = |p: DVec3| {
            let q = *matrix * p.extend(1.0);
            (q.w > 0.0).then(|| q.truncate() / q.w).filter(|p| p.is_finite())
        };
        self.lights.clear();
        self.grids.clear();
        self.objects.retain_mut(|object| {
            let map = *matrix * object.world_from_object;
            let of_planes = map.inverse().transpose();
            let positions: Option<Vec<DVec3>> =
                object.mesh.positions.iter().map(|&p| place(object.world_from_object.transform_point3(p))).collect();
            let Some(positions) = positions else { return false };
            let mut mesh = Mesh { positions, normals: Vec::new(), ..Mesh::clone(&object.mesh) };
            mesh.adjacency.planes.iter_mut().for_each(|plane| *plane = of_planes * *plane);
            if let Some(in_world) = &object.in_world {
                let before = |i: usize| in_world.inverse_w.get(i).copied().unwrap_or(1.0);
                let is_affine = map.row(3).truncate() == DVec3::ZERO && in_world.inverse_w.is_empty();
                let after = |(i, &p): (usize, &DVec3)| single(f64::from(before(i)) / map.row(3).dot(p.extend(1.0)));
                let inverse_w = object.mesh.positions.iter().enumerate().map(after).filter(|_| !is_affine).collect();
                object.in_world = Some(Arc::new(InWorld { inverse_w, ..InWorld::clone(in_world) }));
            }
            object.mesh = Arc::new(mesh);
            object.world_from_object = DMat4::IDENTITY;
            object.lit = false;
            true
        });
        self.lines.retain_mut(|line| {
            let points: Option<Vec<DVec3>> = line.points.iter().map(|&p| place(p)).collect();
            points.map(|points| line.points = points).is_some()
        });
        self.marks.retain_mut(|mark| place(mark.position).map(|p| mark.position = p).is_some());
        self.texts.retain_mut(|text| place(text.position).map(|p| text.position = p).is_some());
    }
}

#[expect(clippy::cast_possible_truncation, reason = "in any unit, and for interpolation only")]
fn single(v: f64) -> f32 {
    v as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::Style;
    use crate::scene::{Preset, SceneSpec, build, no_files};

    /// Taken back, an image under a perspective isn't bent any more. Under another perspective it is.
    #[test]
    fn what_is_bent_by_a_perspective_is_straight_again_after_its_inverse() {
        let mut matrix = DMat4::IDENTITY;
        matrix.x_axis.w = 0.125;
        matrix.z_axis.w = 0.25;
        matrix.w_axis.w = 2.0;
        let spec = SceneSpec { preset: Preset::Cube, ..SceneSpec::default() };
        let mut scene = build(&spec, &Style::default(), &mut no_files).expect("a cube");
        scene.objects.truncate(1);
        scene.objects[0].in_world = Some(Arc::default());
        let bent =
            |scene: &Scene| scene.objects[0].in_world.as_ref().map_or_else(Vec::new, |own| own.inverse_w.clone());
        scene.project(&DMat4::from_scale(DVec3::new(1.0, 2.0, 3.0)));
        assert!(bent(&scene).is_empty(), "an affine map bends nothing");
        scene.project(&matrix);
        let there = bent(&scene);
        assert!(!there.is_empty() && there.iter().any(|q| (q / there[0] - 1.0).abs() > 0.1), "{there:?}");
        scene.project(&matrix.inverse());
        let back = bent(&scene);
        assert!(back.len() == there.len() && back.iter().all(|q| (q / back[0] - 1.0).abs() < 1e-6), "{back:?}");
    }
}
