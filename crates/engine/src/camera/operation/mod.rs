//! The operations of `[0]` §5.6, with dolly and pan: a camera in, a camera out.
//!
//! One rule covers the five rotations: a positive angle turns counter-clockwise seen from the tip of the axis (the
//! right-hand rule), and the whole VRC turns rigidly, VUP with it, so that nothing flips at a pole. The notes turn
//! guinada (yaw) about x_c and arfagem (pitch) about y_c. The field, and the author's own library, turn yaw about **v**
//! and pitch about **u**, as is done here.

mod descriptors;
mod path;

pub use descriptors::{Amount, Descriptor, Freedom, OPERATIONS, OperationError};
pub use path::CameraPath;

use crate::camera::basis::{CameraFrame, Pose};
use crate::camera::parameters::{Checked, ParameterKey, check_range};
use crate::camera::{Camera, CameraError, Derived, Parameters, Range};
use crate::geometry::double_double::{Dd, Dd3, sin_cos_degrees};
use crate::geometry::{Angle, Ray};

/// The sign convention of the rotations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Convention {
    /// Counter-clockwise seen from the tip of the axis, for all five.
    #[default]
    RightHand,
    /// VTK's: elevation and roll turn the other way.
    Vtk,
}

/// A change of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    /// C and VUP turn about **u** through PF.
    Elevation(Angle),
    /// C and VUP turn about **v** through PF.
    Azimuth(Angle),
    /// VUP turns about **n**.
    Roll(Angle),
    /// PF and VUP turn about **v** through C.
    Yaw(Angle),
    /// PF and VUP turn about **u** through C.
    Pitch(Angle),
    /// l, r, b, t are divided by the factor, which is > 0.
    Zoom(f64),
    /// D is divided by the factor, which is > 0; PF stays.
    Dolly(f64),
    /// C and PF move along **u** and **v**, in scene units.
    Pan {
        /// Along **u**.
        dx: f64,
        /// Along **v**.
        dy: f64,
    },
}

/// The parameters that an operation changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Changes {
    /// C.
    pub position: bool,
    /// PF.
    pub focal_point: bool,
    /// VUP.
    pub view_up: bool,
    /// θ, H or l, r, b, t.
    pub window: bool,
}

impl Operation {
    /// The parameters that change.
    pub const fn changes(&self) -> Changes {
        let (position, focal_point, view_up, window) = match self {
            Self::Elevation(_) | Self::Azimuth(_) => (true, false, true, false),
            Self::Roll(_) => (false, false, true, false),
            Self::Yaw(_) | Self::Pitch(_) => (false, true, true, false),
            Self::Zoom(_) => (false, false, false, true),
            Self::Dolly(_) => (true, false, false, false),
            Self::Pan { .. } => (true, true, false, false),
        };
        Changes { position, focal_point, view_up, window }
    }

    /// The angle of a rotation, as given.
    pub const fn angle(&self) -> Option<Angle> {
        match *self {
            Self::Elevation(angle)
            | Self::Azimuth(angle)
            | Self::Roll(angle)
            | Self::Yaw(angle)
            | Self::Pitch(angle) => Some(angle),
            Self::Zoom(_) | Self::Dolly(_) | Self::Pan { .. } => None,
        }
    }

    /// The angle by which a rotation turns about [`Operation::axis`], counter-clockwise seen from its tip.
    pub fn right_hand_angle(&self, convention: Convention) -> Option<Angle> {
        let turned = convention == Convention::Vtk && matches!(self, Self::Elevation(_) | Self::Roll(_));
        self.angle().map(|angle| if turned { -angle } else { angle })
    }

    /// The axis of a rotation. Its origin is the pivot, through which it goes.
    pub fn axis(&self, camera: &Camera) -> Option<Ray> {
        let basis = camera.basis();
        let (origin, direction) = match self {
            Self::Elevation(_) => (camera.focal_point(), basis.u),
            Self::Azimuth(_) => (camera.focal_point(), basis.v),
            Self::Roll(_) => (camera.position(), basis.n),
            Self::Yaw(_) => (camera.position(), basis.v),
            Self::Pitch(_) => (camera.position(), basis.u),
            Self::Zoom(_) | Self::Dolly(_) | Self::Pan { .. } => return None,
        };
        Some(Ray { origin, direction })
    }

    /// The camera after the operation.
    ///
    /// *Guarantees*: the result retains the rest that doesn't fit the `f64`s of its parameters, so a chain of
    /// operations rounds once, at its end. Twelve steps of 30° lead back to the same parameters, bit for bit.
    ///
    /// ```
    /// # use camera_lab_engine::camera::{Camera, Convention, Operation, Parameters};
    /// # use glam::DVec3;
    /// let position = DVec3::new(0.0, 0.0, 5.0);
    /// let camera = Camera::new(&Parameters { position, ..Parameters::default() })?;
    /// let elevation: Operation = "elevation=90".parse()?;
    /// let below = elevation.apply(&camera, Convention::RightHand)?;
    /// assert_eq!((below.position(), below.view_up()), (DVec3::new(0.0, -5.0, 0.0), DVec3::Z));
    /// let above = elevation.apply(&camera, Convention::Vtk)?;
    /// assert_eq!((above.position(), above.view_up()), (DVec3::new(0.0, 5.0, 0.0), DVec3::NEG_Z));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CameraError`] for a value out of its range, or if the result isn't a camera: numbers that overflow, or C
    /// so near PF that they are the same `f64`s.
    pub fn apply(&self, camera: &Camera, convention: Convention) -> Result<Camera, CameraError> {
        self.check()?;
        let Camera { parameters, pose, frame, wide_window, .. } = camera;
        let (mut parameters, mut pose, mut frame, mut window) =
            (*parameters, pose.clone(), frame.clone(), *wide_window);
        let turn = || Turn::new(self.right_hand_angle(convention).unwrap_or_default());
        match *self {
            Self::Elevation(_) | Self::Azimuth(_) => {
                let axis = if matches!(self, Self::Elevation(_)) { Axis::U } else { Axis::V };
                turn().apply(axis, &mut frame, &mut pose.up);
                pose.position = pose.focal_point.plus(frame.to_viewer);
            }
            Self::Roll(_) => turn().apply(Axis::N, &mut frame, &mut pose.up),
            Self::Yaw(_) | Self::Pitch(_) => {
                let axis = if matches!(self, Self::Pitch(_)) { Axis::U } else { Axis::V };
                turn().apply(axis, &mut frame, &mut pose.up);
                pose.focal_point = pose.position.plus(-frame.to_viewer);
            }
            Self::Zoom(factor) => {
                window = window.map(|side| side / Dd::new(factor));
                window.write(&mut parameters);
            }
            Self::Dolly(factor) => {
                let factor = Dd::new(factor);
                frame.to_viewer = frame.to_viewer.map(|x| x / factor);
                frame.distance = frame.distance / factor;
                pose.position = pose.focal_point.plus(frame.to_viewer);
            }
            Self::Pan { dx, dy } => {
                let step = frame.u * Dd::new(dx) + frame.v * Dd::new(dy);
                pose.position = pose.position.plus(step);
                pose.focal_point = pose.focal_point.plus(step);
                // C and PF moved alike, so they are as far from each other as before. If their numbers don't say so,
                // the numbers ran out of digits.
                let (position, focal_point) = (pose.position.value(), pose.focal_point.value());
                if position == focal_point || !position.is_finite() || !focal_point.is_finite() {
                    let keys = &[ParameterKey::Position, ParameterKey::FocalPoint];
                    return Err(CameraError::Overflow { quantity: Derived::Distance, keys });
                }
            }
        }
        pose.write(&mut parameters);
        Camera::derive(parameters, pose, frame, window)
    }

    /// The operation that leads back, for a camera after this one. A factor that has no inverse among the `f64`s comes
    /// back to within a rounding.
    #[must_use]
    pub fn inverse(self) -> Self {
        match self {
            Self::Elevation(angle) => Self::Elevation(-angle),
            Self::Azimuth(angle) => Self::Azimuth(-angle),
            Self::Roll(angle) => Self::Roll(-angle),
            Self::Yaw(angle) => Self::Yaw(-angle),
            Self::Pitch(angle) => Self::Pitch(-angle),
            Self::Zoom(factor) => Self::Zoom(1.0 / factor),
            Self::Dolly(factor) => Self::Dolly(1.0 / factor),
            Self::Pan { dx, dy } => Self::Pan { dx: -dx, dy: -dy },
        }
    }

    fn check(&self) -> Result<(), CameraError> {
        let name = Checked::Operation(self.name());
        match *self {
            Self::Zoom(factor) | Self::Dolly(factor) => check_range(name, factor, Range::Positive),
            Self::Pan { dx, dy } => {
                check_range(name, dx, Range::Finite)?;
                check_range(name, dy, Range::Finite)
            }
            Self::Elevation(angle)
            | Self::Azimuth(angle)
            | Self::Roll(angle)
            | Self::Yaw(angle)
            | Self::Pitch(angle) => check_range(name, angle.degrees(), Range::Finite),
        }
    }
}

impl Pose {
    fn write(&self, parameters: &mut Parameters) {
        parameters.position = self.position.value();
        parameters.focal_point = self.focal_point.value();
        parameters.view_up = self.view_up();
    }
}

/// An axis of the VRC.
#[derive(Clone, Copy)]
enum Axis {
    U,
    V,
    N,
}

/// A rotation by an angle that isn't a whole number of turns, or none at all.
struct Turn {
    sine: Dd,
    cosine: Dd,
    /// 1 − cos α, from the half angle.
    versine: Dd,
}

impl Turn {
    fn new(angle: Angle) -> Self {
        let degrees = angle.degrees() % 360.0;
        let (sine, cosine) = sin_cos_degrees(degrees);
        let (half_sine, _) = sin_cos_degrees(degrees / 2.0);
        Self { sine, cosine, versine: (half_sine * half_sine).scaled(1) }
    }

    /// Turns the VRC, C − PF and VUP as one rigid body about an axis of the VRC.
    fn apply(&self, axis: Axis, frame: &mut CameraFrame, up: &mut Dd3) {
        if self.sine == Dd::ZERO && self.cosine == Dd::ONE {
            return;
        }
        let CameraFrame { u, v, n, .. } = *frame;
        // With two axes a, b and a × b = the third, a turns towards b, and b towards −a.
        let ahead = |a: Dd3, b: Dd3| (a * self.cosine).plus(b * self.sine);
        let (third, [u, v, n]) = match axis {
            Axis::U => (u, [u, ahead(v, n), ahead(n, -v)]),
            Axis::V => (v, [ahead(u, -n), v, ahead(n, u)]),
            Axis::N => (n, [ahead(u, v), ahead(v, -u), n]),
        };
        let to_viewer = if matches!(axis, Axis::N) { frame.to_viewer } else { n * frame.distance };
        *frame = CameraFrame { u, v, n, to_viewer, ..*frame };
        *up = self.rotated(third, *up);
    }

    /// Rodrigues: x cos α + (k × x) sin α + k (k · x)(1 − cos α).
    fn rotated(&self, k: Dd3, x: Dd3) -> Dd3 {
        (x * self.cosine).plus(k.cross(x) * self.sine).plus(k * (k.dot(x) * self.versine))
    }
}
