//! A camera and the pixels of its window, from points to pixels and back to rays.

use glam::{DVec2, DVec3};

use crate::camera::{Camera, Projection};
use crate::drawing::single;
use crate::geometry::Ray;

use super::Request;
use super::pixels::PixelRect;

/// A camera and the rectangle of the picture that its view window fills.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Screen {
    camera: Camera,
    origin: DVec2,
    /// Width and height in pixels.
    pub(super) extent: DVec2,
    /// Pixels for one unit of stroke width or type size.
    pub(super) scale: f64,
}

impl Screen {
    /// `scale` is the number of pixels for one unit of stroke width or type size.
    pub(super) fn new(camera: Camera, rect: PixelRect, scale: f32) -> Self {
        let origin = DVec2::new(f64::from(rect.x), f64::from(rect.y));
        Self {
            camera,
            origin,
            extent: DVec2::new(f64::from(rect.width), f64::from(rect.height)),
            scale: f64::from(scale),
        }
    }

    pub(super) fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The displayed position of a point, in pixels, also outside the rectangle. `None` for points not in front of the
    /// front plane.
    pub(super) fn place(&self, p: DVec3) -> Option<DVec2> {
        let c = self.camera.clip_point(p);
        let in_front = c.w > 0.0 && c.z >= -c.w * (1.0 + 1e-12);
        let ndc = c.truncate() / c.w;
        (in_front && ndc.is_finite())
            .then(|| self.origin + self.extent * DVec2::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y))
    }

    /// Like [`place`](Self::place), for points within the rectangle only.
    pub(super) fn place_inside(&self, p: DVec3) -> Option<DVec2> {
        self.place(p).filter(|&px| self.holds(px))
    }

    /// The middle of the rectangle (pixels).
    pub(super) fn middle(&self) -> DVec2 {
        self.origin + self.extent * 0.5
    }

    /// Width of the edges of the scene, and size of marks, in units of their own (`Scenes::with_fineness`). It's less
    /// than 1 if the scene is small in the picture, unless the width of edges was requested. `place` gives the
    /// displayed place of a point of the world.
    pub(super) fn fineness(&self, request: &Request, place: impl Fn(DVec3) -> Option<DVec2>) -> f32 {
        /// Distance of the corners of a scene from its middle from which on its strokes have their own width, in units
        /// of stroke width.
        const SMALL: f64 = 40.0;
        const LEAST: f64 = 0.4;
        const SPECK: f64 = 4.0;
        let Some(bounds) = request.scene.bounds().filter(|_| request.finish.stroke_factor.is_none()) else {
            return 1.0;
        };
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for corner in bounds.corners() {
            let Some(px) = place(corner) else { return 1.0 };
            let px = px.clamp(self.origin, self.origin + self.extent);
            (low, high) = (low.min(px), high.max(px));
        }
        let radius = 0.5 * (high - low).length();
        let radius = radius / f64::from(request.size.type_scale());
        // If a scene isn't larger than its marks, only these make it visible.
        if radius > SPECK { single((radius / SMALL).clamp(LEAST, 1.0)) } else { 1.0 }
    }

    /// True for a place (pixels) within the rectangle.
    pub(super) fn holds(&self, px: DVec2) -> bool {
        px.cmpge(self.origin).all() && px.cmple(self.origin + self.extent).all()
    }

    /// The point (x_p, y_p) of the view window at a place (pixels).
    pub(super) fn window_point(&self, px: DVec2) -> DVec2 {
        let w = self.camera.window();
        let s = (px - self.origin) / self.extent;
        DVec2::new(w.left + w.width() * s.x, w.top - w.height() * s.y)
    }

    /// The place (pixels) of a point (x_p, y_p) of the view window.
    #[cfg(test)]
    pub(super) fn window_place(&self, point: DVec2) -> DVec2 {
        let w = self.camera.window();
        self.origin + self.extent * DVec2::new((point.x - w.left) / w.width(), (w.top - point.y) / w.height())
    }

    /// The ray through a place (pixels), `[0]` Eqs. (5.17) to (5.21).
    pub(super) fn ray(&self, px: DVec2) -> Ray {
        self.camera.ray_through_window(self.window_point(px))
    }

    /// The direction in which a point moves on the screen when it moves along `direction`. Zero if that isn't visible.
    pub(super) fn heading(&self, p: DVec3, direction: DVec3) -> DVec2 {
        let step = direction * (self.units_per_pixel(p) * 0.01);
        match (self.place(p), self.place(p + step)) {
            (Some(a), Some(b)) if (b - a).length() > 1e-5 => (b - a).normalize_or_zero(),
            _ => DVec2::ZERO,
        }
    }

    /// A point moved in the plane through it that's parallel to the picture, by pixels (y down).
    pub(super) fn moved(&self, p: DVec3, by: DVec2) -> DVec3 {
        let basis = self.camera.basis();
        p + (basis.u * by.x - basis.v * by.y) * self.units_per_pixel(p)
    }

    /// The length that one pixel spans at the depth of a point.
    pub(super) fn units_per_pixel(&self, p: DVec3) -> f64 {
        let at_window = self.camera.window().height() / self.extent.y.max(1.0);
        match self.camera.projection() {
            Projection::Parallel => at_window,
            Projection::Perspective => {
                let depth = -self.camera.view_point(p).z;
                at_window * depth.max(self.camera.near()) / self.camera.near()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::Parameters;

    fn screen(projection: Projection) -> Screen {
        let parameters = Parameters { projection, height: 8.0, ..Parameters::default() };
        Screen::new(Camera::new(&parameters).unwrap(), PixelRect { x: 10, y: 20, width: 400, height: 300 }, 1.0)
    }

    #[test]
    fn the_focal_point_is_in_the_middle_and_its_pixel_leads_back_to_it() {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let s = screen(projection);
            let pf = s.camera().focal_point();
            assert!((s.place(pf).unwrap() - DVec2::new(210.0, 170.0)).length() < 1e-9);
            let p = DVec3::new(0.5, -0.25, 1.0);
            let ray = s.ray(s.place(p).unwrap());
            let off = (p - ray.origin).cross(ray.direction).length();
            assert!(off < 1e-12, "{projection:?}: {off}");
        }
    }

    #[test]
    fn points_behind_the_eye_have_no_place() {
        let s = screen(Projection::Perspective);
        assert_eq!(s.place(s.camera().position() + s.camera().basis().n), None);
    }

    #[test]
    fn units_per_pixel_move_a_point_by_one_pixel() {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let s = screen(projection);
            let step = s.camera().basis().v * s.units_per_pixel(DVec3::ZERO);
            let moved = s.place(step).unwrap() - s.place(DVec3::ZERO).unwrap();
            assert!((moved - DVec2::new(0.0, -1.0)).length() < 1e-9, "{moved}");
            assert!((s.heading(DVec3::ZERO, s.camera().basis().u) - DVec2::X).length() < 1e-6);
        }
    }
}
