//! The camera of the notes `[0]`: pure values in `f64`.
//!
//! [`Parameters`] may be nonsense. A [`Camera`] isn't, because it's made by [`Camera::new`] or by an [`Operation`] and
//! never changed. A point goes through these spaces, and [`Camera::stations`] shows them all:
//!
//! | space | unit | axes | reached by |
//! | --- | --- | --- | --- |
//! | world | scene units | right-handed, y up | [`Camera::world_from_view`] |
//! | view (VRC) | scene units | right-handed: x along **u**, y along **v**, z along **n**, towards the viewer | [`Camera::view_from_world`] (5.7) |
//! | clip | homogeneous | x, y, z in \[−w, w\] inside the volume | [`Camera::clip_from_view`] (5.13) to (5.16); as other libraries have it, [`Camera::clip_space`] |
//! | ndc | 1 | left-handed: −1 … 1, z into the screen | division by w (5.6) |
//! | window | scene units | on the plane z_c = −F: x right, y up | (5.9), (5.10) |
//! | image | pixels | (0, 0) is the top left corner, y down | [`ImageSize::image_from_window`] (5.22) |
//! | viewport | pixels, depth | (0, 0) is the bottom left corner, y up | (5.24), (5.25) |
//!
//! The model computes in double-double (106 bits) and rounds once, so that numbers are right to the last digit even if
//! the formulas cancel, overflow or nearly divide by zero. `docs/equations.md` has each equation with its function and
//! its test.

mod basis;
mod conventions;
mod framing;
mod image_map;
mod lens_form;
mod operation;
mod parameters;
mod photograph;
mod place;
mod recovery;
mod stations;
mod stereo;
mod unproject;
mod volume;
mod window;

/// The matrices of a camera, in every convention of NDC, and as a product of steps.
mod matrix {
    mod clip_space;
    mod decomposition;
    pub(crate) mod projection;

    pub use clip_space::ClipSpace;
    pub use decomposition::{Decomposition, Factor, Step};
}

/// Cameras that aren't what their author meant: repairs of impossible ones, warnings about possible ones.
mod check {
    mod repair;
    mod warnings;

    pub use repair::{CameraRepair, camera_repairs};
    pub use warnings::{Warning, thresholds};
}

pub use basis::Basis;
pub use check::{CameraRepair, Warning, camera_repairs, thresholds};
pub use conventions::{AngleUnit, Api, Axes, InfiniteParallel, Ndc, NdcRange, Order, Program, Toward, WorldUp};
pub use framing::Framing;
pub use image_map::{ImageSize, Viewport};
pub use lens_form::{LensForm, LensNumbers, Sensor, SensorFit};
pub use matrix::{ClipSpace, Decomposition, Factor, Step};
pub use operation::{
    Amount, CameraPath, Changes, Convention, Descriptor, Freedom, OPERATIONS, Operation, OperationError,
};
pub use parameters::{
    CameraError, Checked, Derived, ParameterKey, Parameters, Projection, Range, ViewWindow, is_infinite_far,
};
pub use photograph::{
    AxisVanishing, Doubt, PhotographCamera, PhotographError, PhotographLine, PhotographMarks, Untold, WorldAxis,
    camera_of_photograph, condition_of_photograph,
};
pub use place::Place;
pub use recovery::{
    Assumed, Candidate, Certainty, Evidence, LeftOut, Lines, MatrixEntries, MatrixKind, MatrixTextError, Pasted,
    Reading, Reason, Recognised, Recovered, RecoveryError, Stated, Unknown, Used, Why, camera_names, read_cameras,
    recognise, recover,
};
pub use stations::{Projected, Stations};
pub use stereo::Convergence;
pub use unproject::{NotProjectable, Unprojected};

use glam::DVec3;

use basis::{CameraFrame, Pose};
use matrix::projection::{Lens, lens};
use window::WideWindow;

use crate::geometry::Angle;

/// A camera whose parameters have been checked. Everything derived is there, and every number of it is finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    parameters: Parameters,
    pose: Pose,
    frame: CameraFrame,
    wide_window: WideWindow,
    lens: Lens,
    basis: Basis,
}

impl Camera {
    /// Checks the parameters and derives basis and window.
    ///
    /// *Guarantees*: D, basis, window, matrices and corners are finite, and rounded from a computation in twice the
    /// precision of `f64`. VUP and DOP are collinear if they are so exactly, or if the rest of their cross product
    /// could come from rounding their components. An angle of 1e-10 rad between them is neither.
    ///
    /// ```
    /// use camera_lab_engine::camera::{Camera, Parameters};
    /// use glam::DVec3;
    ///
    /// // [0] Exercise 5.1. The (0, 1, 0) that it calls v is not perpendicular to n: it can only be VUP.
    /// let camera = Camera::new(&Parameters { position: DVec3::new(3.0, 4.0, 0.0), ..Parameters::default() })?;
    /// assert_eq!(camera.distance(), 5.0);
    /// assert_eq!(camera.basis().n, DVec3::new(0.6, 0.8, 0.0));
    /// assert_eq!(camera.basis().u, DVec3::new(0.0, 0.0, -1.0));
    /// assert_eq!(camera.basis().v, DVec3::new(-0.8, 0.6, 0.0));
    /// # Ok::<(), camera_lab_engine::camera::CameraError>(())
    /// ```
    ///
    /// # Errors
    /// [`CameraError`] names the impossible value and the allowed ones.
    pub fn new(parameters: &Parameters) -> Result<Self, CameraError> {
        let p = *parameters;
        p.check()?;
        let pose = Pose::new(p.position, p.focal_point, p.view_up);
        let frame = CameraFrame::new(&pose)?;
        Self::finish(p, pose, frame, WideWindow::new(&p))
    }

    /// The result of an operation, which must be a camera after rounding too.
    fn derive(
        parameters: Parameters,
        pose: Pose,
        frame: CameraFrame,
        wide_window: WideWindow,
    ) -> Result<Self, CameraError> {
        Self::new(&parameters)?;
        Self::finish(parameters, pose, frame, wide_window)
    }

    fn finish(
        parameters: Parameters,
        pose: Pose,
        frame: CameraFrame,
        wide_window: WideWindow,
    ) -> Result<Self, CameraError> {
        let lens = lens(parameters.projection, &wide_window, parameters.near, parameters.far, Ndc::default());
        let basis = frame.basis();
        let camera = Self { parameters, pose, frame, wide_window, lens, basis };
        camera.check_finite()?;
        Ok(camera)
    }

    /// All derived numbers must be finite, and the window must have a size.
    fn check_finite(&self) -> Result<(), CameraError> {
        use ParameterKey as Key;
        const VIEW: &[Key] = &[Key::Position];
        const CORNERS: &[Key] = &[Key::Far, Key::Position];
        let perspective = self.projection() == Projection::Perspective;
        let (shape, lens, all): (&'static [Key], &'static [Key], &'static [Key]) =
            match (self.parameters.window.is_some(), perspective) {
                (true, _) => (
                    &[Key::Window],
                    &[Key::Window, Key::Near, Key::Far],
                    &[Key::Window, Key::Position, Key::Near, Key::Far],
                ),
                (false, true) => (
                    &[Key::ViewAngle, Key::Aspect, Key::Near],
                    &[Key::Near, Key::Far, Key::ViewAngle, Key::Aspect],
                    &[Key::Position, Key::Near, Key::Far, Key::ViewAngle, Key::Aspect],
                ),
                (false, false) => (
                    &[Key::Height, Key::Aspect],
                    &[Key::Height, Key::Aspect, Key::Near, Key::Far],
                    &[Key::Position, Key::Height, Key::Aspect, Key::Near, Key::Far],
                ),
            };
        let w = self.window();
        let sizes = [self.window_width(), self.window_height(), self.window_aspect()];
        let window = [w.left, w.right, w.bottom, w.top].iter().all(|x| x.is_finite())
            && sizes.iter().all(|x| x.is_finite() && *x > 0.0);
        let corners = || self.volume_corners().iter().all(|p| p.is_finite());
        for (good, quantity, keys) in [
            (window, Derived::Window, shape),
            (self.view_from_world().is_finite(), Derived::ViewMatrix, VIEW),
            (self.clip_from_view().is_finite(), Derived::ProjectionMatrix, lens),
            (self.view_from_clip().is_finite(), Derived::ProjectionMatrix, lens),
            (self.clip_from_world().is_finite(), Derived::ViewProjectionMatrix, all),
            (corners(), Derived::VolumeCorners, CORNERS),
        ] {
            if !good {
                return Err(CameraError::Overflow { quantity, keys });
            }
        }
        Ok(())
    }

    /// The parameters of the camera. (After an operation: the `f64`s nearest to its result.)
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The camera of its parameters alone, as a file can hold them, without the rest beyond their `f64`s, which
    /// operations retain.
    #[must_use]
    pub fn rounded(&self) -> Self {
        // No operation gives parameters that aren't a camera.
        Self::new(&self.parameters).unwrap_or_else(|_| self.clone())
    }

    /// C.
    pub fn position(&self) -> DVec3 {
        self.parameters.position
    }

    /// PF.
    pub fn focal_point(&self) -> DVec3 {
        self.parameters.focal_point
    }

    /// VUP.
    pub fn view_up(&self) -> DVec3 {
        self.parameters.view_up
    }

    /// The kind of projection.
    pub fn projection(&self) -> Projection {
        self.parameters.projection
    }

    /// F.
    pub fn near(&self) -> f64 {
        self.parameters.near
    }

    /// B.
    pub fn far(&self) -> f64 {
        self.parameters.far
    }

    /// DOP = −n, `[0]` Eq. (5.2).
    pub fn direction_of_projection(&self) -> DVec3 {
        -self.basis.n
    }

    /// D, the distance from C to PF.
    pub fn distance(&self) -> f64 {
        self.frame.distance.value()
    }

    /// u, v, n.
    pub fn basis(&self) -> Basis {
        self.basis
    }

    /// l, r, b, t on the plane z_c = −F: as given, or H = 2 F tan(θ/2) high, `[0]` Eq. (5.5), and A times as wide.
    ///
    /// *Guarantees*: rounded once. Near 180° the tangent comes from the complement 180° − θ, and whatever the angle,
    /// its half is reduced in degrees: tan 45° is 1.
    ///
    /// ```
    /// # use camera_lab_engine::camera::{Camera, Parameters};
    /// let right_angle = Parameters { view_angle: 90.0, near: 7.0, aspect: 2.0, ..Parameters::default() };
    /// let window = Camera::new(&right_angle)?.window();
    /// assert_eq!((window.left, window.right, window.bottom, window.top), (-14.0, 14.0, -7.0, 7.0));
    /// # Ok::<(), camera_lab_engine::camera::CameraError>(())
    /// ```
    pub fn window(&self) -> ViewWindow {
        self.wide_window.value()
    }

    /// W, rounded once. [`ViewWindow::width`] of the rounded sides may differ in the last digit.
    pub fn window_width(&self) -> f64 {
        self.wide_window.width().value()
    }

    /// H, rounded once.
    pub fn window_height(&self) -> f64 {
        self.wide_window.height().value()
    }

    /// A = W / H, `[0]` Eq. (5.1), rounded once.
    pub fn window_aspect(&self) -> f64 {
        (self.wide_window.width() / self.wide_window.height()).value()
    }

    /// True if r = −l and t = −b: the cases (5.14) and (5.16) of the notes.
    pub fn has_symmetric_window(&self) -> bool {
        let ViewWindow { left, right, bottom, top } = self.window();
        left == -right && bottom == -top
    }

    /// The vertical angle that the window spans seen from C: θ, `[0]` Eq. (5.4), if the window is symmetric.
    pub fn view_angle(&self) -> Angle {
        // F may be 0 or behind C in parallel projection. The angle is then that at its distance.
        Angle::from_degrees(self.wide_window.vertical_angle(self.near().abs().max(f64::MIN_POSITIVE)))
    }
}
