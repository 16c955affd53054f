//! The canonical volume of a convention of NDC, as placed in the picture.
//!
//! Everything is placed as the camera sees it, x to the right, up upwards and the front face in front, in any
//! convention. The conventions differ in the depth of the box, its origin, and the directions of y_n and z_n.

use glam::{DMat4, DVec3};

use crate::camera::{Camera, Ndc, Projection};
use crate::geometry::Aabb;
use crate::scene::Scene;

use crate::pipeline::canonical::displayed_ndc;
use crate::views::{Request, View};

/// A box in display space, from that of the notes: (x_n, y_n, −z_n) in \[−1, 1\]³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::views) struct CanonicalBox {
    /// The convention, without a far plane only if that's possible.
    pub(in crate::views) ndc: Ndc,
    /// Display depth from that of the notes: `scale` · depth + `offset`.
    scale: f64,
    offset: f64,
}

impl CanonicalBox {
    pub(in crate::views) fn of(request: &Request) -> Self {
        let camera = &request.camera;
        Self::new(camera.possible_clip_space(request.shot.ndc).ndc(), camera)
    }

    fn new(ndc: Ndc, camera: &Camera) -> Self {
        if ndc == Ndc::default() {
            return Self { ndc, scale: 1.0, offset: 0.0 };
        }
        let [at_near, at_far] = ndc.depths();
        // From a share that's 1 at F and 0 at B to one that's 0 at infinity: F/d = share (1 − F/B) + F/B.
        let rest = match camera.projection() {
            Projection::Perspective if ndc.infinite => camera.near() / camera.far(),
            Projection::Perspective | Projection::Parallel => 0.0,
        };
        // z_n = at_far + (at_near − at_far) share, and share = (depth + 1)/2.
        let side = Self::side(ndc);
        let range = side * (at_near - at_far);
        let scale = range * (1.0 - rest) / 2.0;
        Self { ndc, scale, offset: side * at_far + range * rest + scale }
    }

    /// Display depth for z_n = 1: into the screen, or out of it if depth is reversed.
    fn side(ndc: Ndc) -> f64 {
        if ndc.reversed { 1.0 } else { -1.0 }
    }

    /// The whole volume, up to infinity without a far plane.
    pub(in crate::views) fn bounds(&self) -> Aabb {
        let [at_near, at_far] = self.ndc.depths().map(|depth| Self::side(self.ndc) * depth);
        Aabb { min: DVec3::new(-1.0, -1.0, at_far), max: DVec3::new(1.0, 1.0, at_near) }
    }

    /// Its near and its far face, each counter-clockwise from the lower left as the camera sees them.
    pub(in crate::views) fn faces(&self) -> [[DVec3; 4]; 2] {
        let Aabb { min, max } = self.bounds();
        let square =
            |z| [(min.x, min.y), (max.x, min.y), (max.x, max.y), (min.x, max.y)].map(|(x, y)| DVec3::new(x, y, z));
        [square(max.z), square(min.z)]
    }

    /// The axes x_n, y_n, z_n.
    pub(in crate::views) fn axes(&self) -> [DVec3; 3] {
        [DVec3::X, DVec3::Y * self.up(), DVec3::Z * Self::side(self.ndc)]
    }

    fn up(&self) -> f64 {
        if self.ndc.y_points_down() { -1.0 } else { 1.0 }
    }

    /// NDC of a place in the picture.
    pub(in crate::views) fn ndc_at(&self, shown: DVec3) -> DVec3 {
        DVec3::new(shown.x, self.up() * shown.y, Self::side(self.ndc) * shown.z)
    }

    /// The place in the picture of a place in the notes' NDC.
    pub(in crate::views) fn place(&self, of_notes: DVec3) -> DVec3 {
        of_notes.with_z(self.scale * of_notes.z + self.offset)
    }

    /// Moves a scene from the display space of the notes.
    pub(in crate::views) fn move_scene(&self, scene: &mut Scene) {
        if self.ndc == Ndc::default() {
            return;
        }
        let matrix =
            DMat4::from_translation(DVec3::Z * self.offset) * DMat4::from_scale(DVec3::new(1.0, 1.0, self.scale));
        let place = |p: &mut DVec3| *p = self.place(*p);
        scene.objects.iter_mut().for_each(|object| object.world_from_object = matrix * object.world_from_object);
        scene.lines.iter_mut().flat_map(|line| &mut line.points).for_each(place);
        scene.marks.iter_mut().for_each(|mark| place(&mut mark.position));
        scene.texts.iter_mut().for_each(|text| place(&mut text.position));
    }
}

/// The place of a vertex (world) in the space of the picture. The canonical volume and the image only show those inside
/// the view volume.
pub(in crate::views) fn shown_at(request: &Request, p: DVec3) -> Option<DVec3> {
    let inside = || displayed_ndc(&request.camera, p).filter(|n| n.abs().max_element() <= 1.0);
    match request.view {
        View::World => Some(p),
        View::Canonical => inside().map(|shown| CanonicalBox::of(request).place(shown)),
        View::Image => inside().map(|_| p),
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{ImageSize, Parameters, Viewport};
    use crate::pipeline::canonical::displayed_ndc;

    /// The displayed position, read as NDC, is that of the model.
    #[test]
    fn places_in_the_picture_are_the_ndc_of_the_convention() {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let parameters = Parameters { projection, near: 2.0, far: 12.0, height: 8.0, ..Parameters::default() };
            let camera = Camera::new(&parameters).unwrap();
            let image = ImageSize::default();
            for ndc in Ndc::ALL {
                let space = camera.possible_clip_space(ndc);
                let canonical = CanonicalBox::new(space.ndc(), &camera);
                for p in [DVec3::ZERO, DVec3::new(1.0, 0.5, -0.25), DVec3::new(-1.0, -1.5, 1.0)] {
                    let shown = canonical.place(displayed_ndc(&camera, p).unwrap());
                    let expected = space.stations(p, image, &Viewport::whole(image)).projected.unwrap().ndc;
                    assert!(canonical.ndc_at(shown).distance(expected) < 1e-14, "{}: {shown} {expected}", ndc.name());
                    let bounds = canonical.bounds();
                    assert!(shown.cmpge(bounds.min).all() && shown.cmple(bounds.max).all(), "{}", ndc.name());
                }
            }
        }
    }

    #[test]
    fn the_near_face_is_in_front_and_the_box_as_deep_as_the_range() {
        let camera = Camera::new(&Parameters::default()).unwrap();
        for ndc in Ndc::ALL {
            let canonical = CanonicalBox::new(ndc, &camera);
            let Aabb { min, max } = canonical.bounds();
            let [at_near, at_far] = ndc.depths();
            assert_eq!(max.z - min.z, (at_far - at_near).abs());
            assert_eq!((canonical.ndc_at(max).z, canonical.ndc_at(min).z), (at_near, at_far));
            let [x, y, z] = canonical.axes();
            assert_eq!(x.cross(y).dot(z) > 0.0, ndc.is_right_handed());
            let at_b = canonical.place(DVec3::NEG_Z).z;
            assert_eq!(at_b > min.z, ndc.infinite, "what lies at B is in front of infinity");
        }
    }
}
