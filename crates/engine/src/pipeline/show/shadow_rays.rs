//! Shadows by rays: decides in `f64`, on the triangles of the scene, if a light sees a point. Shadow maps are compared
//! with this truth. No picture is made this way.

use glam::DVec3;

use crate::camera::{Camera, ImageSize};
use crate::geometry::{TriangleHit, TriangleTree};
use crate::pipeline::scenes::Scenes;
use crate::scene::{Light, LightKind, Object, Scene};

/// The part of a point's size within which a face touches it and hides nothing.
const TOUCHING: f64 = 1e-9;

/// The opaque triangles of a scene in the world. They hide light, and light falls on them.
#[derive(Clone, Debug)]
pub struct Solids {
    tree: TriangleTree,
    /// The facts of each triangle's object.
    facts: Vec<Facts>,
}

#[derive(Clone, Copy, Debug)]
struct Facts {
    lit: bool,
    /// Backs aren't drawn, as those of an open object with one side.
    fronts_only: bool,
    /// Its place in the world is a reflection, so its corners run clockwise seen from the front.
    mirrored: bool,
}

/// A point of a face that a camera sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenPoint {
    /// The point, in the world.
    pub point: DVec3,
    /// The index of its triangle among all.
    pub triangle: usize,
    /// The unit normal of the triangle on the side that the camera sees.
    pub normal: DVec3,
    /// Light falls on it.
    pub lit: bool,
}

impl Solids {
    /// Number of triangles of a scene that [`Solids::of`] puts into a tree.
    pub fn count(scene: &Scene) -> usize {
        Scenes::from(scene).occluders().map(|object| object.mesh.triangles.len()).sum()
    }

    /// Collects the triangles of a scene.
    pub fn of(scene: &Scene) -> Self {
        let (mut triangles, mut facts) = (Vec::new(), Vec::new());
        for object in Scenes::from(scene).occluders() {
            let Object { mesh, world_from_object, .. } = object;
            let at = |i: u32| {
                let p = mesh.positions.get(i as usize).copied().unwrap_or(DVec3::NAN);
                world_from_object.transform_point3(p)
            };
            triangles.extend(mesh.triangles.iter().map(|triangle| triangle.map(at)));
            let fronts_only = !object.two_sided && !mesh.closed;
            let mirrored = world_from_object.determinant() < 0.0;
            facts.resize(triangles.len(), Facts { lit: object.lit, fronts_only, mirrored });
        }
        Self { tree: TriangleTree::new(triangles), facts }
    }

    /// True if a light sees a point of a triangle.
    pub fn is_lit(&self, p: DVec3, triangle: usize, light: &Light) -> bool {
        let touching = TOUCHING * (1.0 + p.length());
        let (ray, until) = to_light(p, light);
        !self.tree.is_hit(p, ray, touching..until, |other, _| other != triangle)
    }

    /// The point that a camera sees at a place of its image, in pixels from the top left; `None` if there is none.
    pub fn seen(&self, camera: &Camera, image: ImageSize, place: [f64; 2]) -> Option<SeenPoint> {
        let (origin, ray, within) = ray_of(camera, image, place);
        let is_drawn = |triangle: usize, is_front: bool| {
            self.facts.get(triangle).is_some_and(|facts| !facts.fronts_only || is_front != facts.mirrored)
        };
        let TriangleHit { triangle, t } = self.tree.first_hit(origin, ray, within, is_drawn)?;
        let [a, b, c] = *self.tree.triangles().get(triangle)?;
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let normal = if normal.dot(ray) > 0.0 { -normal } else { normal };
        Some(SeenPoint { point: origin + ray * t, triangle, normal, lit: self.facts.get(triangle)?.lit })
    }
}

/// The unit vector from a point to a light, and the distance.
pub fn to_light(p: DVec3, light: &Light) -> (DVec3, f64) {
    match light.kind {
        LightKind::Directional => (-light.vector.normalize_or_zero(), f64::INFINITY),
        LightKind::Point => ((light.vector - p).normalize_or_zero(), light.vector.distance(p)),
    }
}

/// The ray through a place of an image, in pixels from the top left, and its range between the front plane and the back
/// plane. Its points are origin + t · ray, at the distance t from the plane of the eye.
fn ray_of(camera: &Camera, image: ImageSize, [x, y]: [f64; 2]) -> (DVec3, DVec3, std::ops::Range<f64>) {
    let window = camera.window();
    let share = |low: f64, high: f64, part: f64| low + (high - low) * part;
    let on_window = glam::DVec2::new(
        share(window.left, window.right, x / f64::from(image.width)),
        share(window.top, window.bottom, y / f64::from(image.height)),
    );
    let ray = camera.ray_through_window(on_window);
    let per_depth = ray.direction / ray.direction.dot(camera.direction_of_projection());
    (ray.origin, per_depth, camera.near()..camera.far())
}
