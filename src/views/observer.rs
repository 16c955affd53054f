//! The observer of a three-dimensional picture: an orbit about a target, and the camera that it amounts to.

use glam::DVec3;

use crate::camera::{Camera, CameraError, Parameters, Projection};
use crate::figure::Observer;
use crate::geometry::{Aabb, Angle};

/// The observer's vertical view angle.
pub const VIEW_ANGLE: Angle = Angle::from_degrees(30.0);

/// A side to look from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Preset {
    /// From +z, parallel.
    Front,
    /// From +y, parallel.
    Top,
    /// From +x, parallel.
    Side,
    /// From a corner, in perspective.
    #[default]
    Iso,
}

impl Observer {
    /// Looks at a box from a preset's side so that it fills the picture.
    #[must_use]
    pub fn fit(bounds: Aabb, preset: Preset, aspect: f64) -> Self {
        let (azimuth, elevation, parallel) = match preset {
            Preset::Front => (0.0, 0.0, true),
            Preset::Top => (0.0, 90.0, true),
            Preset::Side => (90.0, 0.0, true),
            Preset::Iso => (35.0, 25.0, false),
        };
        let radius = bounds.radius().max(f64::MIN_POSITIVE);
        let distance = radius * 1.2 / (VIEW_ANGLE.radians() / 2.0).sin() / aspect.min(1.0);
        Self { target: bounds.center(), distance, azimuth, elevation, parallel }
    }

    /// Turns about the target: `dx_deg` to the right (the eye goes to the left of what it sees), `dy_deg` up.
    #[must_use]
    pub fn orbit(self, dx_deg: f64, dy_deg: f64) -> Self {
        Self {
            azimuth: (self.azimuth - dx_deg).rem_euclid(360.0),
            elevation: (self.elevation + dy_deg).clamp(-90.0, 90.0),
            ..self
        }
    }

    /// Moves the target so that what it sees follows the pointer by (`dx_px`, `dy_px`), y down, in a picture `height_px` high.
    #[must_use]
    pub fn pan(self, dx_px: f64, dy_px: f64, height_px: f64) -> Self {
        let unit = 2.0 * self.distance * (VIEW_ANGLE.radians() / 2.0).tan() / height_px.max(1.0);
        let [right, up, _] = self.axes();
        Self { target: self.target - right * (dx_px * unit) + up * (dy_px * unit), ..self }
    }

    /// Goes nearer (`factor` > 1) or away; what is at the target is shown `factor` times as large.
    #[must_use]
    pub fn zoom(self, factor: f64) -> Self {
        if factor > 0.0 && factor.is_finite() { Self { distance: self.distance / factor, ..self } } else { self }
    }

    /// Right, up and towards the eye, unit vectors in the space of the picture.
    #[must_use]
    pub fn axes(&self) -> [DVec3; 3] {
        let (sa, ca) = Angle::from_degrees(self.azimuth).sin_cos();
        let (se, ce) = Angle::from_degrees(self.elevation).sin_cos();
        [DVec3::new(ca, 0.0, -sa), DVec3::new(-se * sa, ce, -se * ca), DVec3::new(ce * sa, se, ce * ca)]
    }

    /// The camera of this observer. Its clipping planes enclose `bounds` as far as a depth buffer in `f32` bears it.
    ///
    /// # Errors
    /// [`CameraError`] for an observer that is no camera, such as one at distance 0.
    pub fn camera(&self, _bounds: Option<Aabb>, aspect: f64) -> Result<Camera, CameraError> {
        let [_, up, back] = self.axes();
        Camera::new(&Parameters {
            position: self.target + back * self.distance,
            focal_point: self.target,
            view_up: up,
            projection: if self.parallel { Projection::Parallel } else { Projection::Perspective },
            view_angle: VIEW_ANGLE.degrees(),
            height: 2.0 * self.distance * (VIEW_ANGLE.radians() / 2.0).tan(),
            aspect,
            near: self.distance * 0.01,
            far: self.distance * 100.0,
            window: None,
        })
    }
}
