//! The view window on the plane z_c = −F: from angle, height and aspect, or given as l, r, b, t; and the change of the
//! projection, which keeps the size of things at the focal point.

use super::{Camera, CameraError, Parameters, Projection, ViewWindow};
use crate::geometry::double_double::{Dd, atan_degrees, tan_half_degrees};

/// A window in double-double: l, r, b, t as sums, so that zoom and the change of projection round once, at the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WideWindow {
    pub(super) left: Dd,
    pub(super) right: Dd,
    pub(super) bottom: Dd,
    pub(super) top: Dd,
}

impl WideWindow {
    /// The window that the parameters describe: `[0]` Eq. (5.5) in perspective.
    pub(super) fn new(p: &Parameters) -> Self {
        if let Some(w) = p.window {
            return Self { left: w.left.into(), right: w.right.into(), bottom: w.bottom.into(), top: w.top.into() };
        }
        let top = match p.projection {
            Projection::Perspective => Dd::new(p.near) * tan_half_degrees(p.view_angle),
            Projection::Parallel => Dd::new(p.height).scaled(-1),
        };
        let right = top * Dd::new(p.aspect);
        Self { left: -right, right, bottom: -top, top }
    }

    /// W.
    pub(super) fn width(&self) -> Dd {
        self.right - self.left
    }

    /// H.
    pub(super) fn height(&self) -> Dd {
        self.top - self.bottom
    }

    /// Rounded to `f64`.
    pub(super) fn value(&self) -> ViewWindow {
        ViewWindow {
            left: self.left.value(),
            right: self.right.value(),
            bottom: self.bottom.value(),
            top: self.top.value(),
        }
    }

    /// The window with `f` of each side.
    pub(super) fn map(&self, f: impl Fn(Dd) -> Dd) -> Self {
        Self { left: f(self.left), right: f(self.right), bottom: f(self.bottom), top: f(self.top) }
    }

    /// θ in degrees of a window that is symmetric, seen from a distance: `[0]` Eq. (5.4) solved for θ.
    pub(super) fn view_angle(&self, distance: Dd) -> f64 {
        atan_degrees(self.top / distance).scaled(1).value()
    }

    /// The vertical angle in degrees that any window spans, seen from a distance.
    pub(super) fn vertical_angle(&self, distance: f64) -> f64 {
        let distance = Dd::new(distance);
        (atan_degrees(self.top / distance) - atan_degrees(self.bottom / distance)).value()
    }

    /// Writes the window into the parameters that keep it: θ, H or l, r, b, t.
    pub(super) fn write(&self, parameters: &mut Parameters) {
        if parameters.window.is_some() {
            parameters.window = Some(self.value());
        } else if parameters.projection == Projection::Perspective {
            parameters.view_angle = self.size_parameter(parameters);
        } else {
            parameters.height = self.size_parameter(parameters);
        }
    }

    /// θ in degrees in perspective, H in parallel projection.
    fn size_parameter(&self, parameters: &Parameters) -> f64 {
        match parameters.projection {
            Projection::Perspective => self.view_angle(Dd::new(parameters.near)),
            Projection::Parallel => self.height().value(),
        }
    }
}

impl Camera {
    /// The same camera with the other kind of projection. Things at the focal point keep their size. The window is as
    /// high in parallel projection as the frustum is at distance D.
    ///
    /// *Guarantees*: without drift. There and back again gives the same parameters: the angle (or the height) that the
    /// parameters still hold is used if it's equivalent, and a given window returns within one rounding, and from
    /// then on exactly.
    ///
    /// # Errors
    /// [`CameraError`] if the new window overflows, or its angle is so near to 180° that no `f64` is nearer.
    pub fn with_projection(&self, projection: Projection) -> Result<Self, CameraError> {
        if projection == self.projection() {
            return Ok(self.clone());
        }
        Parameters { projection, ..*self.parameters() }.check_planes()?;
        let near = Dd::new(self.near());
        let ratio = match projection {
            Projection::Parallel => self.frame.distance / near,
            Projection::Perspective => near / self.frame.distance,
        };
        let mut parameters = Parameters { projection, ..*self.parameters() };
        let mut window = self.wide_window.map(|side| side * ratio);
        if parameters.window.is_some() {
            parameters.window = Some(window.value());
        } else {
            let kept = WideWindow::new(&parameters);
            let back = kept.map(|side| side / ratio);
            if back.size_parameter(self.parameters()) == self.wide_window.size_parameter(self.parameters()) {
                window = kept;
            } else {
                window.write(&mut parameters);
            }
        }
        Self::derive(parameters, self.pose.clone(), self.frame.clone(), window)
    }
}
