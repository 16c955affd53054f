//! The way from one camera to another: arcs about the fixed point, never a mixture of matrices.
//!
//! The axes **u**, **v**, **n** turn together about one axis at an even speed, and D changes by equal factors. If PF
//! stays, C goes round it on an arc (azimuth, elevation), or on a spiral if D changes too. If C stays, PF goes round C
//! (yaw, pitch). If both move, PF goes straight and C round PF. tan(θ/2), H, A, F and (B − F)/F change by equal factors
//! too, so that things grow evenly, and every camera on the way is one.

use glam::{DMat3, DQuat, DVec3};

use crate::camera::{Camera, CameraError, Parameters, Projection, ViewWindow};

/// The way from one camera to another.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraPath {
    from: Camera,
    to: Camera,
    /// The ends as the other half of the way has them, if the projection changes.
    seen: [Camera; 2],
}

impl CameraPath {
    /// The way between two cameras. If one is in perspective and the other in parallel projection, this changes
    /// half-way, and things at the focal point keep their size.
    ///
    /// # Errors
    /// [`CameraError`] if one of them can't be in the projection of the other.
    pub fn new(from: &Camera, to: &Camera) -> Result<Self, CameraError> {
        let seen = [to.with_projection(from.projection())?, from.with_projection(to.projection())?];
        Ok(Self { from: from.clone(), to: to.clone(), seen })
    }

    /// The camera after a share of the way, 0 … 1.
    ///
    /// *Guarantees*: the ends are the given cameras.
    ///
    /// # Errors
    /// [`CameraError`] if the coordinates are so large or so small that rounding leaves no camera.
    pub fn at(&self, share: f64) -> Result<Camera, CameraError> {
        if share <= 0.0 {
            return Ok(self.from.clone());
        }
        if share >= 1.0 {
            return Ok(self.to.clone());
        }
        let (from, to) = if share < 0.5 { (&self.from, &self.seen[0]) } else { (&self.seen[1], &self.to) };
        let mut parameters = lens(from, to, share);
        pose(from, to, share, &mut parameters);
        Camera::new(&parameters)
    }
}

/// C, PF and VUP on the way.
fn pose(from: &Camera, to: &Camera, t: f64, parameters: &mut Parameters) {
    let turned = |camera: &Camera| {
        let basis = camera.basis();
        DQuat::from_mat3(&DMat3::from_cols(basis.u, basis.v, basis.n))
    };
    let turn = turned(from).slerp(turned(to), t).normalize();
    let (v, n) = (turn * DVec3::Y, turn * DVec3::Z);
    // VUP lies in the plane of v and n, less than a right angle from v.
    let lean = |camera: &Camera| {
        let basis = camera.basis();
        let up = unit(camera.view_up());
        up.dot(basis.n).atan2(up.dot(basis.v))
    };
    let (sin, cos) = between(lean(from), lean(to), t).sin_cos();
    parameters.view_up = unit(v * cos + n * sin) * evenly(length(from.view_up()), length(to.view_up()), t);
    let distance = evenly(from.distance(), to.distance(), t);
    if from.position() == to.position() && from.focal_point() != to.focal_point() {
        parameters.position = from.position();
        parameters.focal_point = parameters.position - n * distance;
    } else {
        let (a, b) = (from.focal_point(), to.focal_point());
        parameters.focal_point = if a == b { a } else { a * (1.0 - t) + b * t };
        parameters.position = parameters.focal_point + n * distance;
    }
}

/// F and B on the way: in even ratios if they're distances in front of the eye. They needn't be in parallel projection,
/// and then go straight.
fn planes(a: &Parameters, b: &Parameters, t: f64) -> [f64; 2] {
    if a.near <= 0.0 || b.near <= 0.0 {
        let near = between(a.near, b.near, t);
        return [near, between(a.far, b.far, t).max(near.next_up())];
    }
    let near = evenly(a.near, b.near, t);
    let depth = evenly((a.far - a.near) / a.near, (b.far - b.near) / b.near, t);
    let far = (near * (1.0 + depth)).max(near.next_up());
    [near, if a.near == b.near { evenly(a.far, b.far, t) } else { far }]
}

/// The parameters of the projection on the way, with the pose of the first camera.
fn lens(from: &Camera, to: &Camera, t: f64) -> Parameters {
    let [a, b] = [from.parameters(), to.parameters()];
    let [near, far] = planes(a, b, t);
    let half = |angle: f64| (angle / 2.0).to_radians().tan();
    let view_angle = if a.view_angle == b.view_angle {
        a.view_angle
    } else {
        let angle = 2.0 * evenly(half(a.view_angle), half(b.view_angle), t).atan().to_degrees();
        angle.clamp(a.view_angle.min(b.view_angle), a.view_angle.max(b.view_angle))
    };
    let window = (a.window.is_some() || b.window.is_some()).then(|| {
        // The slopes of the sides are visible in perspective.
        let [unit_a, unit_b, unit] = match a.projection {
            Projection::Perspective => [a.near, b.near, near],
            Projection::Parallel => [1.0; 3],
        };
        let [wa, wb] = [from.window(), to.window()];
        let side = |sa: f64, sb: f64| {
            if sa == sb && unit_a == unit_b { sa } else { between(sa / unit_a, sb / unit_b, t) * unit }
        };
        ViewWindow {
            left: side(wa.left, wb.left),
            right: side(wa.right, wb.right),
            bottom: side(wa.bottom, wb.bottom),
            top: side(wa.top, wb.top),
        }
    });
    Parameters {
        view_angle,
        height: evenly(a.height, b.height, t),
        aspect: evenly(a.aspect, b.aspect, t),
        near,
        far,
        window,
        ..*a
    }
}

/// From one number to another by equal steps.
fn between(a: f64, b: f64, t: f64) -> f64 {
    if a == b { a } else { a * (1.0 - t) + b * t }
}

/// From one positive number to another by equal factors, never beyond them.
fn evenly(a: f64, b: f64, t: f64) -> f64 {
    if a == b { a } else { between(a.ln(), b.ln(), t).exp().clamp(a.min(b), a.max(b)) }
}

/// The unit vector along one of any length, even if its square overflows or underflows.
fn unit(v: DVec3) -> DVec3 {
    (v / v.abs().max_element()).normalize()
}

fn length(v: DVec3) -> f64 {
    let largest = v.abs().max_element();
    largest * (v / largest).length()
}
