//! The observer of a three-dimensional picture, and the camera equivalent to it.

use glam::{DVec2, DVec3};

use crate::camera::{Camera, CameraError, Parameters, Projection};
use crate::geometry::{Aabb, Angle};

/// Half the observer's view angle across the smaller side of the picture. It's narrow, so that the picture's own
/// perspective doesn't compete with the one it shows.
pub const HALF_VIEW_ANGLE: Angle = Angle::from_degrees(14.0);

/// The tangents of half the view angles, across and up, of a picture of this aspect. The smaller side has the angle of
/// the observer. So an upright view has all of a square one, and nothing is cut off at its sides.
pub fn half_tangents(aspect: f64) -> DVec2 {
    HALF_VIEW_ANGLE.tan() * DVec2::new(aspect.max(1.0), (1.0 / aspect).max(1.0))
}

/// Greatest depth range over the observer's distance in parallel projection, where depth is linear and stored in `f32`.
/// Beyond it, faces that touch would flicker.
const PARALLEL_DEPTH: f64 = 100.0;

/// The observer of a three-dimensional picture, in an orbit about a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observer {
    /// The point in the middle of the picture, in the space of the picture.
    pub target: DVec3,
    /// Distance of the eye from the target. Also the measure of zoom.
    pub distance: f64,
    /// Degrees about y, 0 = the eye on the +z side, 90 = on the +x side.
    pub azimuth: f64,
    /// Degrees above the ground, −90 … 90.
    pub elevation: f64,
    /// Rotation of the eye about its line of sight in degrees, counter-clockwise as seen in the picture, so the picture
    /// turns clockwise.
    pub roll: f64,
    /// Parallel (true) or perspective projection of this picture.
    pub parallel: bool,
}

impl Observer {
    /// Turns about the target. The scene follows the pointer. `dx_deg` > 0 turns its front to the right, and `dy_deg` >
    /// 0 turns it down, so that the eye rises.
    #[must_use]
    pub fn orbit(self, dx_deg: f64, dy_deg: f64) -> Self {
        // Across and along the ground, which is tilted for a rolled eye.
        let (s, c) = Angle::from_degrees(self.roll).sin_cos();
        let (dx_deg, dy_deg) = (dx_deg * c + dy_deg * s, dy_deg * c - dx_deg * s);
        Self {
            azimuth: (self.azimuth - dx_deg).rem_euclid(360.0),
            elevation: (self.elevation + dy_deg).clamp(-90.0, 90.0),
            ..self
        }
    }

    /// Moves the target so that points at its depth follow the pointer by (`dx_px`, `dy_px`), y down, in a picture
    /// whose smaller side has `side_px` pixels.
    #[must_use]
    pub fn pan(self, dx_px: f64, dy_px: f64, side_px: f64) -> Self {
        let unit = 2.0 * self.distance * HALF_VIEW_ANGLE.tan() / side_px.max(1.0);
        let [right, up, _] = self.axes();
        Self { target: self.target - right * (dx_px * unit) + up * (dy_px * unit), ..self }
    }

    /// Moves nearer (`factor` > 1) or away, so that things at the target appear `factor` times as large. A factor that
    /// isn't positive and finite changes nothing.
    #[must_use]
    pub fn zoom(self, factor: f64) -> Self {
        let distance = self.distance / factor;
        if distance > 0.0 && distance.is_finite() { Self { distance, ..self } } else { self }
    }

    /// Right, up and towards the eye: unit vectors in the space of the picture.
    pub fn axes(&self) -> [DVec3; 3] {
        let (sa, ca) = Angle::from_degrees(self.azimuth).sin_cos();
        let (se, ce) = Angle::from_degrees(self.elevation).sin_cos();
        let (right, up) = (DVec3::new(ca, 0.0, -sa), DVec3::new(-se * sa, ce, -se * ca));
        let back = DVec3::new(ce * sa, se, ce * ca);
        if self.roll == 0.0 {
            return [right, up, back];
        }
        let (sr, cr) = Angle::from_degrees(self.roll).sin_cos();
        [right * cr + up * sr, up * cr - right * sr, back]
    }

    /// This observer, turned so that two unit vectors at right angles point to the right and towards the eye.
    #[must_use]
    pub fn looking(self, right: DVec3, back: DVec3) -> Self {
        let elevation = back.y.clamp(-1.0, 1.0).asin().to_degrees();
        let at_pole = back.x.hypot(back.z) < 1e-9;
        let azimuth = if at_pole { (-right.z).atan2(right.x) } else { back.x.atan2(back.z) }.to_degrees();
        let upright = Self { azimuth: azimuth.rem_euclid(360.0), elevation, roll: 0.0, ..self };
        let [level, up, _] = upright.axes();
        let roll = right.dot(up).atan2(right.dot(level)).to_degrees();
        Self { roll: if roll.abs() < 1e-9 { 0.0 } else { roll }, ..upright }
    }

    /// The camera of this observer. Its clipping planes enclose `bounds` as far as a depth buffer in `f32` allows.
    ///
    /// # Errors
    /// [`CameraError`] for an observer that isn't a camera, such as one at distance 0.
    pub fn camera(&self, bounds: Option<Aabb>, aspect: f64) -> Result<Camera, CameraError> {
        let [_, up, back] = self.axes();
        let tangents = half_tangents(aspect);
        // The angle itself, not the angle of its tangent, if it's the observer's own.
        let view_angle = 2.0 * if aspect < 1.0 { tangents.y.atan().to_degrees() } else { HALF_VIEW_ANGLE.degrees() };
        let reach = bounds.map_or(0.0, |b| {
            b.corners().iter().map(|&p| back.dot(p - self.target).abs()).filter(|d| d.is_finite()).fold(0.0, f64::max)
        });
        // In parallel projection the place of the eye doesn't matter, so it steps back from everything visible. In
        // perspective it stays, and depth, which is reversed, keeps its resolution with any far plane.
        let (eye, near, far) = if self.parallel {
            let half = (1.01 * reach).clamp(self.distance, PARALLEL_DEPTH * self.distance);
            (1.01 * half, 0.01 * half, 2.02 * half)
        } else {
            (self.distance, 0.02 * self.distance, 2.0 * self.distance + 1.01 * reach)
        };
        Camera::new(&Parameters {
            position: self.target + back * eye,
            focal_point: self.target,
            view_up: up,
            projection: if self.parallel { Projection::Parallel } else { Projection::Perspective },
            view_angle,
            height: 2.0 * self.distance * tangents.y,
            aspect,
            near,
            far,
            window: None,
        })
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;

    fn ndc(camera: &Camera, p: DVec3) -> DVec3 {
        let c = camera.clip_point(p);
        c.truncate() / c.w
    }

    #[test]
    fn a_pan_moves_the_target_with_the_pointer() {
        for parallel in [false, true] {
            let before =
                Observer { target: DVec3::ONE, distance: 7.0, azimuth: 30.0, elevation: 40.0, roll: 0.0, parallel };
            let after = before.pan(30.0, -20.0, 400.0);
            let seen = ndc(&after.camera(None, 1.5).unwrap(), before.target);
            assert!((seen.x * 300.0 - 30.0).abs() < 1e-9 && (-seen.y * 200.0 + 20.0).abs() < 1e-9, "{seen}");
        }
    }

    #[test]
    fn an_upright_picture_shows_as_much_as_a_square_one() {
        for parallel in [false, true] {
            let observer =
                Observer { target: DVec3::ONE, distance: 7.0, azimuth: 30.0, elevation: 40.0, roll: 0.0, parallel };
            let p = observer.target + observer.axes()[0] - observer.axes()[1];
            let [upright, square, flat] = [0.5, 1.0, 2.0].map(|aspect| ndc(&observer.camera(None, aspect).unwrap(), p));
            assert!((upright.x - square.x).abs() < 1e-12 && (upright.y - 0.5 * square.y).abs() < 1e-12, "{upright}");
            assert!((flat.x - 0.5 * square.x).abs() < 1e-12 && (flat.y - square.y).abs() < 1e-12, "{flat}");
        }
    }

    #[test]
    fn zoom_scales_things_at_the_target_and_refuses_nonsense() {
        let before =
            Observer { target: DVec3::ONE, distance: 7.0, azimuth: 30.0, elevation: 40.0, roll: 0.0, parallel: false };
        let p = before.target + before.axes()[0];
        let size = |o: Observer| ndc(&o.camera(None, 1.0).unwrap(), p).x;
        assert!((size(before.zoom(3.0)) / size(before) - 3.0).abs() < 1e-12);
        for nonsense in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(before.zoom(nonsense), before);
        }
    }

    #[test]
    fn an_orbit_turns_the_scene_with_the_pointer_and_stops_at_the_poles() {
        let before =
            Observer { target: DVec3::ZERO, distance: 7.0, azimuth: 10.0, elevation: 40.0, roll: 0.0, parallel: false };
        let front = before.axes()[2];
        let seen = ndc(&before.orbit(5.0, 5.0).camera(None, 1.0).unwrap(), front);
        assert!(seen.x > 0.0 && seen.y < 0.0, "{seen}");
        assert_eq!(before.orbit(0.0, 5.0).elevation, before.elevation + 5.0);
        assert_eq!(before.orbit(0.0, -500.0).elevation, -90.0);
        let top = before.orbit(0.0, 500.0);
        assert_eq!(top.elevation, 90.0);
        assert!(top.camera(None, 1.0).is_ok());
        assert!((before.orbit(-400.0, 0.0).azimuth - 50.0).abs() < 1e-12);
    }

    #[test]
    fn an_eye_looks_the_given_way_and_a_point_ahead_follows_the_pointer() {
        let any =
            Observer { target: DVec3::ONE, distance: 7.0, azimuth: 0.0, elevation: 0.0, roll: 3.0, parallel: false };
        for (right, back) in [
            (DVec3::X, DVec3::Z),
            (DVec3::NEG_Z, DVec3::Y),
            (DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.48, 0.8, -0.36)),
            (DVec3::new(0.0, 0.8, 0.6), DVec3::new(0.0, -0.6, 0.8)),
        ] {
            let seen = any.looking(right, back).axes();
            let wanted = [right, back.cross(right), back];
            assert!(seen.iter().zip(wanted).all(|(a, b)| (*a - b).length() < 1e-12), "{seen:?} {wanted:?}");
            let looking = any.looking(right, back);
            if looking.elevation.abs() < 80.0 {
                let front = looking.target + looking.axes()[2];
                let turned = ndc(&looking.orbit(0.01, 0.0).camera(None, 1.0).unwrap(), front);
                assert!(turned.x > 0.0 && turned.y.abs() < 0.3 * turned.x, "{turned}");
            }
        }
    }

    #[test]
    fn depth_is_bounded_in_parallel_projection() {
        let o =
            Observer { target: DVec3::ZERO, distance: 7.0, azimuth: 10.0, elevation: 40.0, roll: 0.0, parallel: true };
        let camera = o.camera(Aabb::around([DVec3::splat(-1e6), DVec3::splat(1e6)]), 1.0).unwrap();
        assert!(camera.far() - camera.near() <= 2.02 * PARALLEL_DEPTH * o.distance);
        assert!(ndc(&camera, o.target).abs().max_element() < 0.1);
        assert!(Observer { distance: 0.0, ..o }.camera(None, 1.0).is_err());
    }
}
