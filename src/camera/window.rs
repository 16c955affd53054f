//! The view window on the plane z_c = −F: from angle, height and aspect, or given as l, r, b, t.

use super::{Parameters, Projection};
use crate::geometry::double_double::{Dd, atan_degrees, tan_half_degrees};

/// The view window on the plane z_c = −F, in scene units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewWindow {
    /// l
    pub left: f64,
    /// r
    pub right: f64,
    /// b
    pub bottom: f64,
    /// t
    pub top: f64,
}

impl ViewWindow {
    /// W = r − l.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// H = t − b.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.top - self.bottom
    }

    /// A = W / H, `[0]` Eq. (5.1).
    #[must_use]
    pub fn aspect(&self) -> f64 {
        self.width() / self.height()
    }

    /// The window with `f` of each side.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self { left: f(self.left), right: f(self.right), bottom: f(self.bottom), top: f(self.top) }
    }
}

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

    /// Every side times `factor`.
    pub(super) fn scaled(&self, factor: Dd) -> Self {
        Self {
            left: self.left * factor,
            right: self.right * factor,
            bottom: self.bottom * factor,
            top: self.top * factor,
        }
    }

    /// Every side divided by `divisor`.
    pub(super) fn divided(&self, divisor: Dd) -> Self {
        Self {
            left: self.left / divisor,
            right: self.right / divisor,
            bottom: self.bottom / divisor,
            top: self.top / divisor,
        }
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
}
