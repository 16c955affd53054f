//! The camera parameters of a figure file or a slider, and the reasons why they may not make a camera.

use std::fmt;

use glam::DVec3;

/// The kind of projection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Projection {
    /// Projectors meet in C.
    #[default]
    Perspective,
    /// Projectors are parallel to DOP (orthographic).
    Parallel,
}

impl Projection {
    /// True for perspective, in which points are divided by their distance.
    pub const fn is_perspective(self) -> bool {
        matches!(self, Self::Perspective)
    }
}

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
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// H = t − b.
    pub fn height(&self) -> f64 {
        self.top - self.bottom
    }

    /// A = W / H, `[0]` Eq. (5.1).
    pub fn aspect(&self) -> f64 {
        self.width() / self.height()
    }

    /// The window with `f` of each side.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        Self { left: f(self.left), right: f(self.right), bottom: f(self.bottom), top: f(self.top) }
    }
}

/// The camera parameters of a figure file or a slider. May be nonsense until [`Camera::new`](super::Camera::new) has
/// checked them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// C, world.
    pub position: DVec3,
    /// PF, world.
    pub focal_point: DVec3,
    /// VUP, world.
    pub view_up: DVec3,
    /// The kind of projection.
    pub projection: Projection,
    /// θ, vertical, in degrees, 0 < θ < 180 (perspective).
    pub view_angle: f64,
    /// H in scene units (parallel).
    pub height: f64,
    /// A = W / H.
    pub aspect: f64,
    /// F, distance of the front clipping plane and of the view plane.
    pub near: f64,
    /// B, distance of the back clipping plane.
    pub far: f64,
    /// l, r, b, t. Replaces angle, height and aspect.
    pub window: Option<ViewWindow>,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            position: DVec3::new(3.0, 4.0, 5.0),
            focal_point: DVec3::ZERO,
            view_up: DVec3::Y,
            projection: Projection::Perspective,
            view_angle: 45.0,
            height: 2.0,
            aspect: 4.0 / 3.0,
            near: 0.1,
            far: 100.0,
            window: None,
        }
    }
}

crate::listed! {
    /// A parameter of a camera, or the sides of the view window together.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum ParameterKey {
        /// C
        Position = "position",
        /// PF
        FocalPoint = "focal_point",
        /// VUP
        ViewUp = "view_up",
        /// θ
        ViewAngle = "view_angle",
        /// H
        Height = "height",
        /// A
        Aspect = "aspect",
        /// F
        Near = "near",
        /// B
        Far = "far",
        /// l, r, b and t
        Window = "window",
    }
    /// Its key in `[camera]` of a figure file.
    pub fn name
}

impl ParameterKey {
    /// The notes' symbol.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Position => "C",
            Self::FocalPoint => "PF",
            Self::ViewUp => "VUP",
            Self::ViewAngle => "θ",
            Self::Height => "H",
            Self::Aspect => "A",
            Self::Near => "F",
            Self::Far => "B",
            Self::Window => "l, r, b, t",
        }
    }

    /// Copies this parameter.
    pub fn copy(self, from: &Parameters, to: &mut Parameters) {
        match self {
            Self::Position => to.position = from.position,
            Self::FocalPoint => to.focal_point = from.focal_point,
            Self::ViewUp => to.view_up = from.view_up,
            Self::ViewAngle => to.view_angle = from.view_angle,
            Self::Height => to.height = from.height,
            Self::Aspect => to.aspect = from.aspect,
            Self::Near => to.near = from.near,
            Self::Far => to.far = from.far,
            Self::Window => to.window = from.window,
        }
    }

    /// Their keys, with commas between them.
    pub fn list(keys: &[Self]) -> String {
        keys.iter().map(|key| key.name()).collect::<Vec<_>>().join(", ")
    }
}

/// A value with a range: a parameter, or the amount of an operation (by its name).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Checked {
    /// One of the keys of `[camera]`.
    Parameter(ParameterKey),
    /// An operation by its word in a file, such as `azimuth`.
    Operation(&'static str),
}

impl Checked {
    /// Its key in a figure file, or its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Parameter(key) => key.name(),
            Self::Operation(name) => name,
        }
    }

    /// The notes' symbol, or the name of the operation.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Parameter(key) => key.symbol(),
            Self::Operation(name) => name,
        }
    }
}

impl From<ParameterKey> for Checked {
    fn from(key: ParameterKey) -> Self {
        Self::Parameter(key)
    }
}

impl fmt::Display for Checked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl Parameters {
    /// Checks every value for itself, and near against far, and the sides of the window.
    pub(super) fn check(&self) -> Result<(), CameraError> {
        for (key, vector) in [
            (ParameterKey::Position, self.position),
            (ParameterKey::FocalPoint, self.focal_point),
            (ParameterKey::ViewUp, self.view_up),
        ] {
            for value in vector.to_array() {
                check_range(key.into(), value, Range::Finite)?;
            }
        }
        check_range(ParameterKey::ViewAngle.into(), self.view_angle, Range::HalfTurn)?;
        check_range(ParameterKey::Height.into(), self.height, Range::Positive)?;
        check_range(ParameterKey::Aspect.into(), self.aspect, Range::Positive)?;
        self.check_planes()?;
        if let Some(ViewWindow { left, right, bottom, top }) = self.window {
            for value in [left, right, bottom, top] {
                check_range(ParameterKey::Window.into(), value, Range::Finite)?;
            }
            if left >= right {
                return Err(CameraError::WindowWidth { left, right });
            }
            if bottom >= top {
                return Err(CameraError::WindowHeight { bottom, top });
            }
        }
        if self.view_up == DVec3::ZERO {
            return Err(CameraError::ViewUpZero);
        }
        Ok(())
    }

    /// Checks F and B. A parallel volume has no eye in it, so it may lie anywhere along **n**, as in
    /// `glOrtho(…, −1, 1)`.
    pub(super) fn check_planes(&self) -> Result<(), CameraError> {
        let allowed = match self.projection {
            Projection::Perspective => Range::Positive,
            Projection::Parallel => Range::Finite,
        };
        check_range(ParameterKey::Near.into(), self.near, allowed)?;
        check_range(ParameterKey::Far.into(), self.far, allowed)?;
        if self.near >= self.far {
            return Err(CameraError::FarNotBeyondNear { near: self.near, far: self.far });
        }
        Ok(())
    }
}

/// An error unless `value` lies in `allowed`.
pub(super) fn check_range(key: Checked, value: f64, allowed: Range) -> Result<(), CameraError> {
    if allowed.contains(value) { Ok(()) } else { Err(CameraError::OutOfRange { key, value, allowed }) }
}

/// True if a value asks for a volume without a back plane, which a convention of NDC can have.
pub fn is_infinite_far(key: Checked, value: f64) -> bool {
    key == Checked::Parameter(ParameterKey::Far) && value == f64::INFINITY
}

/// The numbers that a value may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Range {
    /// Every finite number.
    Finite,
    /// Finite and greater than 0.
    Positive,
    /// Degrees between 0 and 180, both excluded.
    HalfTurn,
}

impl Range {
    /// True if `value` is allowed. False for NaN and infinities.
    pub fn contains(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::Finite => true,
                Self::Positive => value > 0.0,
                Self::HalfTurn => value > 0.0 && value < 180.0,
            }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Finite => "a finite number",
            Self::Positive => "a finite number greater than 0",
            Self::HalfTurn => "greater than 0 and less than 180 degrees",
        })
    }
}

/// A number that the model computes from the parameters and that may not fit in `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Derived {
    /// D.
    Distance,
    /// l, r, b, t, W, H, A.
    Window,
    /// M_v or its inverse.
    ViewMatrix,
    /// M_p or its inverse.
    ProjectionMatrix,
    /// M_p M_v.
    ViewProjectionMatrix,
    /// The corners of the view volume.
    VolumeCorners,
}

impl fmt::Display for Derived {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Distance => "the distance from position to focal_point",
            Self::Window => "the view window",
            Self::ViewMatrix => "the view matrix",
            Self::ProjectionMatrix => "the projection matrix",
            Self::ViewProjectionMatrix => "the product of projection and view matrix",
            Self::VolumeCorners => "the corners of the view volume",
        })
    }
}

/// The reason why parameters aren't a camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// C = PF.
    #[error("focal_point is the same point as position; allowed: any other point")]
    FocalPointAtPosition,
    /// VUP has no length.
    #[error("view_up is the zero vector; allowed: any other vector that is not collinear with focal_point − position")]
    ViewUpZero,
    /// VUP is collinear with DOP.
    #[error("view_up is collinear with focal_point − position; allowed: any vector in another direction")]
    ViewUpCollinear,
    /// A value is out of its range.
    #[error("{key} is {value:?}; allowed: {allowed}{}", if is_infinite_far(*key, *value) { "; for B → ∞ keep a finite far and use --ndc NAME-infinite" } else { "" })]
    OutOfRange {
        /// The parameter, or the operation.
        key: Checked,
        /// The value found.
        value: f64,
        /// The allowed range.
        allowed: Range,
    },
    /// F ≥ B.
    #[error(
        "near is {near:?} and far is {far:?}; allowed: near < far, and in perspective 0 < near; for reversed depths keep that and use --ndc NAME-reversed"
    )]
    FarNotBeyondNear {
        /// F.
        near: f64,
        /// B.
        far: f64,
    },
    /// l ≥ r.
    #[error("window: left is {left:?} and right is {right:?}; allowed: left < right")]
    WindowWidth {
        /// l.
        left: f64,
        /// r.
        right: f64,
    },
    /// b ≥ t.
    #[error("window: bottom is {bottom:?} and top is {top:?}; allowed: bottom < top")]
    WindowHeight {
        /// b.
        bottom: f64,
        /// t.
        top: f64,
    },
    /// The parameters are possible one by one, but a quantity derived from them isn't a finite `f64`.
    #[error(
        "{quantity} would exceed the range of numbers (about 1e-308 to 1e308); it follows from {}",
        ParameterKey::list(keys)
    )]
    Overflow {
        /// The quantity.
        quantity: Derived,
        /// The parameters that it follows from.
        keys: &'static [ParameterKey],
    },
}

impl CameraError {
    /// True if one value is impossible by itself, whatever the other parameters are.
    pub const fn is_of_one_value(&self) -> bool {
        matches!(self, Self::OutOfRange { .. } | Self::ViewUpZero)
    }

    /// The parameters that the error is about, the most likely culprit first. None for an operation with an impossible
    /// value.
    pub fn parameters(&self) -> &[ParameterKey] {
        use ParameterKey as Key;
        match self {
            Self::FocalPointAtPosition => &[Key::FocalPoint, Key::Position],
            Self::ViewUpZero => &[Key::ViewUp],
            Self::ViewUpCollinear => &[Key::ViewUp, Key::FocalPoint, Key::Position],
            Self::OutOfRange { key: Checked::Parameter(key), .. } => std::slice::from_ref(key),
            Self::OutOfRange { key: Checked::Operation(_), .. } => &[],
            Self::FarNotBeyondNear { .. } => &[Key::Far, Key::Near],
            Self::WindowWidth { .. } | Self::WindowHeight { .. } => &[Key::Window],
            Self::Overflow { keys, .. } => keys,
        }
    }
}
