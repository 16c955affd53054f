//! A camera that looks at a thing, and one whose image holds it whole.

use glam::DVec3;

use super::{Camera, CameraError, Convention, Operation, Parameters, Projection, ViewWindow};
use crate::geometry::Aabb;

/// The share of the image's width or height that a thing has at most.
const FILLED: f64 = 0.9;
/// The least and the greatest vertical angle of a window that a thing alone chooses, in degrees. Narrower ones flatten,
/// and wider ones stretch what's seen.
const ANGLES: [f64; 2] = [10.0, 120.0];

/// A way to look at objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Framing {
    /// [`Camera::aimed_at`] their middle.
    Aim,
    /// [`Camera::fitted_to`] their vertices.
    Fit,
}

impl Framing {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Aim, Self::Fit];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Aim => "aim",
            Self::Fit => "fit",
        }
    }

    /// The camera that looks at objects with this middle and these vertices, in the world.
    ///
    /// # Errors
    /// [`CameraError`] if the numbers overflow.
    pub fn of(self, camera: &Camera, (middle, points): &(DVec3, Vec<DVec3>)) -> Result<Camera, CameraError> {
        match self {
            Self::Aim => camera.aimed_at(*middle),
            Self::Fit => camera.fitted_to(points),
        }
    }
}

/// Sizes of a window that hold some points, as multiples of the present one.
struct Scales {
    least: f64,
    most: f64,
}

impl Camera {
    /// The same camera with PF at a point of the world. C goes along, so **u**, **v**, **n** and D stay.
    ///
    /// # Errors
    /// [`CameraError`] if the numbers overflow.
    pub fn aimed_at(&self, target: DVec3) -> Result<Self, CameraError> {
        let position = target + self.basis().n * self.distance();
        Self::new(&Parameters { position, focal_point: target, ..*self.parameters() })
    }

    /// The camera whose image holds these points of the world whole, with a margin. The window keeps its shape, and θ
    /// (H in parallel projection) changes. C moves only if θ would leave 10° to 120°, or if no window of this shape can
    /// hold the points from C, because some are behind the eye or the window is far off the axis. The planes move only
    /// if they would cut the points.
    ///
    /// # Errors
    /// [`CameraError`] if the numbers overflow. Without points, the camera stays as it is.
    pub fn fitted_to(&self, points: &[DVec3]) -> Result<Self, CameraError> {
        let Some(bounds) = Aabb::around(points.iter().copied()) else { return Ok(self.clone()) };
        let scaled = |camera: &Self, scale: f64| Operation::Zoom(1.0 / scale).apply(camera, Convention::RightHand);
        let angle = |camera: &Self| match camera.projection() {
            Projection::Perspective => camera.angle(),
            Projection::Parallel => ANGLES[0],
        };
        let scales = self.scales(points).filter(|scales| scales.least <= scales.most);
        let fits = scales.map(|scales| scaled(self, (scales.least / FILLED).min(scales.most)));
        if let Some(fitted) = fits {
            let fitted = fitted?;
            if (ANGLES[0]..=ANGLES[1]).contains(&angle(&fitted)) {
                return fitted.with_planes_around(points);
            }
        }
        let middle = bounds.center();
        let sized = match self.projection() {
            // The nearest angle, or the present one if it would do.
            Projection::Perspective => {
                let wanted = match self.scales(points).map(|scales| scaled(self, scales.least / FILLED)) {
                    Some(Ok(fitted)) => fitted.angle(),
                    _ => self.angle(),
                };
                // A window given by its sides stays as it is. Far off the axis it spans a small angle in any size.
                let view_angle = wanted.clamp(ANGLES[0], ANGLES[1]);
                Self::new(&Parameters { view_angle, ..*self.parameters() })?
            }
            Projection::Parallel => {
                let (basis, ViewWindow { left, right, bottom, top }) = (self.basis(), self.window());
                let halves = [(basis.u, (right - left) / 2.0), (basis.v, (top - bottom) / 2.0)];
                let shares = points.iter().flat_map(|p| halves.map(|(axis, half)| axis.dot(*p - middle).abs() / half));
                let share = shares.fold(0.0, f64::max);
                scaled(self, if share > 0.0 { share / FILLED } else { 1.0 })?
            }
        };
        sized.moved_back(middle, points)?.with_planes_around(points)
    }

    /// The vertical angle of the window, in degrees, in perspective.
    fn angle(&self) -> f64 {
        self.wide_window.vertical_angle(self.near())
    }

    /// The coordinates of points on **u** and **v**, and their depths before C, in scene units.
    fn seen(&self, points: &[DVec3]) -> Vec<[f64; 3]> {
        let (basis, position) = (self.basis(), self.position());
        let of = |p: &DVec3| [basis.u, basis.v, -basis.n].map(|axis| axis.dot(*p - position));
        points.iter().map(of).collect()
    }

    /// The scales of the window that hold all points. `None` if one isn't in front of the eye.
    fn scales(&self, points: &[DVec3]) -> Option<Scales> {
        let ViewWindow { left, right, bottom, top } = self.window();
        let mut scales = Scales { least: f64::MIN_POSITIVE, most: f64::INFINITY };
        for [x, y, depth] in self.seen(points) {
            let unit = if self.projection() == Projection::Perspective { self.near() / depth } else { 1.0 };
            if depth <= 0.0 {
                return None;
            }
            for (at, side, sign) in [(x, left, -1.0), (x, right, 1.0), (y, bottom, -1.0), (y, top, 1.0)] {
                // The point has to lie inwards of the side: at ≤ scale · side, or ≥ for the left and the lower one.
                let (at, side) = (sign * at * unit, sign * side);
                if side > 0.0 {
                    scales.least = scales.least.max(at / side);
                } else if side < 0.0 {
                    scales.most = scales.most.min(at / side);
                } else if at > 0.0 {
                    scales.most = 0.0;
                }
            }
        }
        Some(scales)
    }

    /// The same camera, moved so that a point lies in the middle of its window and all points lie in it, no farther
    /// from them than needed.
    fn moved_back(&self, middle: DVec3, points: &[DVec3]) -> Result<Self, CameraError> {
        let (basis, ViewWindow { left, right, bottom, top }) = (self.basis(), self.window());
        let perspective = self.projection() == Projection::Perspective;
        let (halves, centre) =
            ([(right - left) / 2.0, (top - bottom) / 2.0], [(left + right) / 2.0, (bottom + top) / 2.0]);
        let mut distance = f64::MIN_POSITIVE;
        for p in points {
            let [x, y, towards] = [basis.u, basis.v, basis.n].map(|axis| axis.dot(*p - middle));
            distance = distance.max(towards + self.near());
            // From C = middle + t n − t (centre / F): |F x + centre · towards| ≤ FILLED · half · (t − towards).
            for (at, (half, centre)) in [(x, (halves[0], centre[0])), (y, (halves[1], centre[1]))] {
                if perspective {
                    let needed = (self.near() * at + centre * towards).abs() / (FILLED * half);
                    distance = distance.max(towards + needed);
                }
            }
        }
        let aside = if perspective { distance / self.near() } else { 1.0 };
        let back = basis.n * distance - (basis.u * centre[0] + basis.v * centre[1]) * aside;
        let position = middle + back;
        let focal_point = position - basis.n * distance;
        Self::new(&Parameters { position, focal_point, ..*self.parameters() })
    }

    /// The same view with planes that don't cut these points, which are all before the eye. The window keeps its angle.
    fn with_planes_around(&self, points: &[DVec3]) -> Result<Self, CameraError> {
        let depths = self.seen(points).into_iter().map(|[.., depth]| depth);
        let [least, most] =
            depths.fold([f64::INFINITY, 0.0], |[least, most], d| [f64::min(least, d), f64::max(most, d)]);
        // The margin is larger than what the numbers of points and planes round.
        let near = if self.near() > least { 0.9 * least } else { self.near() };
        let far = if self.far() < most { 1.1 * most } else { self.far() };
        let ratio = if self.projection() == Projection::Perspective { near / self.near() } else { 1.0 };
        let scaled = |side: f64| side * ratio;
        let window = self.parameters().window.map(|ViewWindow { left, right, bottom, top }| ViewWindow {
            left: scaled(left),
            right: scaled(right),
            bottom: scaled(bottom),
            top: scaled(top),
        });
        Self::new(&Parameters { near, far, window, ..*self.parameters() })
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use proptest::prelude::*;

    use super::*;

    fn vector(range: std::ops::Range<f64>) -> impl Strategy<Value = DVec3> {
        proptest::array::uniform3(range).prop_map(DVec3::from)
    }

    prop_compose! {
        /// Cameras of all kinds; some windows don't contain the axis.
        fn cameras()(
            position in vector(-20.0..20.0),
            focal_point in vector(-20.0..20.0),
            view_angle in 5.0..150.0_f64,
            (near, depth) in (0.05..5.0_f64, 1.0..50.0_f64),
            parallel in any::<bool>(),
            window in proptest::option::of((-2.0..2.0_f64, 0.1..3.0_f64, -2.0..2.0_f64, 0.1..3.0_f64)),
        ) -> Option<Camera> {
            let window = window.map(|(left, width, bottom, height)| ViewWindow {
                left, right: left + width, bottom, top: bottom + height,
            });
            let projection = if parallel { Projection::Parallel } else { Projection::Perspective };
            let far = near + depth;
            Camera::new(&Parameters {
                position, focal_point, view_angle, near, far, projection, window, ..Parameters::default()
            }).ok()
        }
    }

    proptest! {
        #[test]
        fn a_fitted_image_holds_all_points_whatever_the_camera(
            camera in cameras(),
            middle in vector(-30.0..30.0),
            points in proptest::collection::vec(vector(-3.0..3.0), 1..12),
        ) {
            let Some(camera) = camera else { return Ok(()) };
            let points: Vec<DVec3> = points.into_iter().map(|p| middle + p).collect();
            let fitted = camera.fitted_to(&points).unwrap();
            for p in &points {
                let clip = fitted.clip_point(*p);
                let ndc = clip / clip.w;
                prop_assert!(clip.w > 0.0 && ndc.truncate().abs().max_element() <= 1.0 + 1e-9, "{ndc} {fitted:?}");
            }
            let same_axes = |a: DVec3, b: DVec3| (a - b).length() < 1e-9;
            prop_assert!(same_axes(camera.basis().u, fitted.basis().u) && same_axes(camera.basis().n, fitted.basis().n));
            if fitted.projection() == Projection::Perspective && camera.parameters().window.is_none() {
                let angle = fitted.parameters().view_angle;
                prop_assert!((ANGLES[0] - 1e-9..=ANGLES[1] + 1e-9).contains(&angle), "{angle}");
                // C moved only if it had to: at the border of the angles, or because something was behind the eye.
                let is_inside = (ANGLES[0] + 1e-6..ANGLES[1] - 1e-6).contains(&angle);
                let is_before = camera.seen(&points).iter().all(|[.., depth]| *depth > 0.0);
                prop_assert!(!(is_inside && is_before) || fitted.position() == camera.position());
            }
        }

        #[test]
        fn an_aimed_camera_looks_at_the_point_and_keeps_axes_and_distance(camera in cameras(), target in vector(-30.0..30.0)) {
            let Some(camera) = camera else { return Ok(()) };
            let aimed = camera.aimed_at(target).unwrap();
            prop_assert_eq!(aimed.focal_point(), target);
            prop_assert!((aimed.distance() - camera.distance()).abs() < 1e-9);
            prop_assert!((aimed.basis().n - camera.basis().n).length() < 1e-9);
        }
    }

    #[test]
    fn the_thing_fills_the_image_up_to_a_margin() {
        let camera = Camera::new(&Parameters { position: DVec3::Z * 10.0, ..Parameters::default() }).unwrap();
        let fitted = camera.fitted_to(&[DVec3::new(0.0, 1.0, 0.0), DVec3::new(0.0, -1.0, 0.0)]).unwrap();
        let height = fitted.clip_point(DVec3::Y).y / 10.0;
        assert!((height - FILLED).abs() < 1e-12 && fitted.position() == camera.position(), "{height}");
    }
}
