//! The camera of the notes `[0]`: pure values in `f64`.
//!
//! [`Parameters`] may be nonsense; a [`Camera`] is not.

use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::geometry::{Angle, Plane, Ray};

/// The kind of projection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Projection {
    /// Projectors meet in C.
    #[default]
    Perspective,
    /// Projectors are parallel to DOP (orthographic).
    Parallel,
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
}

/// What a figure file or a slider holds; may be nonsense until [`Camera::new`] has seen it.
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
    /// l, r, b, t; replaces angle, height and aspect.
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

/// Why parameters are no camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// C = PF.
    #[error("focal_point must differ from position")]
    FocalPointAtPosition,
    /// VUP has no length.
    #[error("view_up must not be zero")]
    ViewUpZero,
    /// VUP is collinear with DOP.
    #[error("view_up must not be collinear with focal_point − position")]
    ViewUpCollinear,
    /// A value is out of its range.
    #[error("{key} is {value}; allowed: {allowed}")]
    OutOfRange {
        /// The figure file's key.
        key: &'static str,
        /// What was found.
        value: f64,
        /// What is allowed, in words of the field.
        allowed: &'static str,
    },
}

/// The VRC: an orthonormal right-handed basis, `[0]` Eq. (5.3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// To the right.
    pub u: DVec3,
    /// Up.
    pub v: DVec3,
    /// Towards the viewer (VPN).
    pub n: DVec3,
}

/// A camera whose parameters have been checked; everything derived is there.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    parameters: Parameters,
    distance: f64,
    basis: Basis,
    window: ViewWindow,
}

impl Camera {
    /// Checks the parameters and derives basis and window.
    ///
    /// # Errors
    /// [`CameraError`] names what is impossible.
    pub fn new(parameters: &Parameters) -> Result<Self, CameraError> {
        let p = *parameters;
        let to_viewer = p.position - p.focal_point;
        let n = crate::geometry::try_unit(to_viewer).ok_or(CameraError::FocalPointAtPosition)?;
        let up = crate::geometry::try_unit(p.view_up).ok_or(CameraError::ViewUpZero)?;
        let u = crate::geometry::try_unit(up.cross(n)).ok_or(CameraError::ViewUpCollinear)?;
        let v = n.cross(u);
        let window = p.window.unwrap_or_else(|| {
            let h = match p.projection {
                Projection::Perspective => 2.0 * p.near * (p.view_angle.to_radians() / 2.0).tan(),
                Projection::Parallel => p.height,
            };
            let w = h * p.aspect;
            ViewWindow { left: -w / 2.0, right: w / 2.0, bottom: -h / 2.0, top: h / 2.0 }
        });
        Ok(Self { parameters: p, distance: to_viewer.length(), basis: Basis { u, v, n }, window })
    }

    /// What the camera was made from.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// C.
    #[must_use]
    pub fn position(&self) -> DVec3 {
        self.parameters.position
    }

    /// PF.
    #[must_use]
    pub fn focal_point(&self) -> DVec3 {
        self.parameters.focal_point
    }

    /// VUP.
    #[must_use]
    pub fn view_up(&self) -> DVec3 {
        self.parameters.view_up
    }

    /// The kind of projection.
    #[must_use]
    pub fn projection(&self) -> Projection {
        self.parameters.projection
    }

    /// F.
    #[must_use]
    pub fn near(&self) -> f64 {
        self.parameters.near
    }

    /// B.
    #[must_use]
    pub fn far(&self) -> f64 {
        self.parameters.far
    }

    /// DOP = −n, `[0]` Eq. (5.2).
    #[must_use]
    pub fn direction_of_projection(&self) -> DVec3 {
        -self.basis.n
    }

    /// D, the distance from C to PF.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// u, v, n.
    #[must_use]
    pub fn basis(&self) -> Basis {
        self.basis
    }

    /// l, r, b, t on the plane z_c = −F.
    #[must_use]
    pub fn window(&self) -> ViewWindow {
        self.window
    }

    /// The vertical angle that the window spans seen from C.
    #[must_use]
    pub fn view_angle(&self) -> Angle {
        Angle::from_radians((self.window.top / self.near()).atan() - (self.window.bottom / self.near()).atan())
    }

    /// M_v, `[0]` Eq. (5.7).
    #[must_use]
    pub fn view_from_world(&self) -> DMat4 {
        let Basis { u, v, n } = self.basis;
        let c = self.position();
        DMat4::from_cols(
            DVec4::new(u.x, v.x, n.x, 0.0),
            DVec4::new(u.y, v.y, n.y, 0.0),
            DVec4::new(u.z, v.z, n.z, 0.0),
            DVec4::new(-u.dot(c), -v.dot(c), -n.dot(c), 1.0),
        )
    }

    /// The inverse of M_v.
    #[must_use]
    pub fn world_from_view(&self) -> DMat4 {
        let Basis { u, v, n } = self.basis;
        DMat4::from_cols(u.extend(0.0), v.extend(0.0), n.extend(0.0), self.position().extend(1.0))
    }

    /// M_p, `[0]` Eqs. (5.13) and (5.15).
    #[must_use]
    pub fn clip_from_view(&self) -> DMat4 {
        let w = self.window;
        let (f, b) = (self.near(), self.far());
        let (dx, dy, dz) = (w.width(), w.height(), b - f);
        let (sx, sy) = (w.right + w.left, w.top + w.bottom);
        match self.projection() {
            Projection::Perspective => DMat4::from_cols(
                DVec4::new(2.0 * f / dx, 0.0, 0.0, 0.0),
                DVec4::new(0.0, 2.0 * f / dy, 0.0, 0.0),
                DVec4::new(sx / dx, sy / dy, -(b + f) / dz, -1.0),
                DVec4::new(0.0, 0.0, -2.0 * b * f / dz, 0.0),
            ),
            Projection::Parallel => DMat4::from_cols(
                DVec4::new(2.0 / dx, 0.0, 0.0, 0.0),
                DVec4::new(0.0, 2.0 / dy, 0.0, 0.0),
                DVec4::new(0.0, 0.0, -2.0 / dz, 0.0),
                DVec4::new(-sx / dx, -sy / dy, -(b + f) / dz, 1.0),
            ),
        }
    }

    /// The inverse of M_p.
    #[must_use]
    pub fn view_from_clip(&self) -> DMat4 {
        self.clip_from_view().inverse()
    }

    /// M_p M_v.
    #[must_use]
    pub fn clip_from_world(&self) -> DMat4 {
        self.clip_from_view() * self.view_from_world()
    }

    /// A world point in the VRC; C is subtracted before anything is rotated.
    #[must_use]
    pub fn view_point(&self, p_world: DVec3) -> DVec3 {
        let d = p_world - self.position();
        let Basis { u, v, n } = self.basis;
        DVec3::new(u.dot(d), v.dot(d), n.dot(d))
    }

    /// A world point in clip coordinates.
    #[must_use]
    pub fn clip_point(&self, p_world: DVec3) -> DVec4 {
        self.clip_from_view() * self.view_point(p_world).extend(1.0)
    }

    /// Eight world points: near (l,b) (r,b) (r,t) (l,t), then far in the same order.
    #[must_use]
    pub fn volume_corners(&self) -> [DVec3; 8] {
        let m = self.world_from_view();
        let w = self.window;
        let corners = [(w.left, w.bottom), (w.right, w.bottom), (w.right, w.top), (w.left, w.top)];
        std::array::from_fn(|i| {
            let (x, y) = corners[i % 4];
            let depth = if i < 4 { self.near() } else { self.far() };
            let s = match self.projection() {
                Projection::Perspective => depth / self.near(),
                Projection::Parallel => 1.0,
            };
            m.transform_point3(DVec3::new(x * s, y * s, -depth))
        })
    }

    /// Six world planes, inside positive: left, right, bottom, top, near, far.
    #[must_use]
    pub fn volume_planes(&self) -> [Plane; 6] {
        let m = self.clip_from_world().transpose();
        let rows = [m.x_axis, m.y_axis, m.z_axis, m.w_axis];
        std::array::from_fn(|i| {
            let p = if i % 2 == 0 { rows[3] + rows[i / 2] } else { rows[3] - rows[i / 2] };
            let length = p.truncate().length();
            Plane { normal: p.truncate() / length, offset: p.w / length }
        })
    }

    /// The ray through a point of the view window, `[0]` Eqs. (5.17) to (5.21).
    #[must_use]
    pub fn ray_through_window(&self, point: DVec2) -> Ray {
        let Basis { u, v, n } = self.basis;
        match self.projection() {
            Projection::Perspective => {
                Ray { origin: self.position(), direction: (u * point.x + v * point.y - n * self.near()).normalize() }
            }
            Projection::Parallel => Ray { origin: self.position() + u * point.x + v * point.y, direction: -n },
        }
    }
}

/// The size of an image in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ImageSize {
    /// m
    pub width: u32,
    /// n
    pub height: u32,
}

impl Default for ImageSize {
    fn default() -> Self {
        Self { width: 1024, height: 768 }
    }
}

/// glViewport and glDepthRange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Left, pixels.
    pub x: i32,
    /// Bottom, pixels.
    pub y: i32,
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Depth of z_n = −1.
    pub depth_near: f64,
    /// Depth of z_n = 1.
    pub depth_far: f64,
}
