//! DOP, D, **u** **v** **n** from C, PF and VUP: `[0]` Eqs. (5.2) and (5.3).

use glam::DVec3;

use super::{CameraError, Derived, ParameterKey};
use crate::geometry::double_double::{Dd, Dd3, exact_sum, two_product};

/// The VRC: an orthonormal right-handed basis, `[0]` Eq. (5.3).
///
/// *Guarantees*: each component is the `f64` nearest to the exact value for the given C, PF and VUP, whatever their
/// size and however small the angle between VUP and DOP (but for ties too close to call).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// To the right.
    pub u: DVec3,
    /// Up.
    pub v: DVec3,
    /// Towards the viewer (VPN).
    pub n: DVec3,
}

impl Basis {
    /// The axes: the number of each, from 0, and its name.
    pub fn named(&self) -> [(u8, DVec3, &'static str); 3] {
        [(0, self.u, "u"), (1, self.v, "v"), (2, self.n, "n")]
    }
}

/// The pose of a camera: position and axes. Stored in double-double, so that a chain of operations rounds once, at its
/// end.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pose {
    pub(super) position: Dd3,
    pub(super) focal_point: Dd3,
    /// VUP times 2^−`up_exponent`, which brings its greatest component near 1.
    pub(super) up: Dd3,
    pub(super) up_exponent: i32,
}

impl Pose {
    pub(super) fn new(position: DVec3, focal_point: DVec3, view_up: DVec3) -> Self {
        let up = Dd3::from(view_up);
        let up_exponent = up.exponent();
        let up = up.scaled(-up_exponent);
        Self { position: position.into(), focal_point: focal_point.into(), up, up_exponent }
    }

    /// VUP, rounded.
    pub(super) fn view_up(&self) -> DVec3 {
        self.up.scaled(self.up_exponent).value()
    }

    /// The rest of C after rounding: C = `position.value()` + this.
    pub(super) fn position_rest(&self) -> DVec3 {
        DVec3::from_array(self.position.to_array().map(|x| x.parts()[1]))
    }
}

/// **u**, **v**, **n** and D in double-double. Operations turn it as a rigid body. It is never found again from VUP, so
/// nothing flips at a pole, and a small angle between VUP and DOP costs no digits.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct CameraFrame {
    pub(super) u: Dd3,
    pub(super) v: Dd3,
    pub(super) n: Dd3,
    /// D.
    pub(super) distance: Dd,
    /// C − PF = D **n**: before any operation, exactly.
    pub(super) to_viewer: Dd3,
}

impl CameraFrame {
    /// Derives the VRC.
    ///
    /// The components of C − PF are exact, and so is the sum of products VUP × (C − PF). Only its rounding to 106 bits,
    /// the square root and the division aren't. Nothing overflows or underflows on the way, as vectors are scaled by
    /// powers of two first.
    pub(super) fn new(pose: &Pose) -> Result<Self, CameraError> {
        let overflow = CameraError::Overflow {
            quantity: Derived::Distance,
            keys: &[ParameterKey::FocalPoint, ParameterKey::Position],
        };
        let to_viewer = pose.position - pose.focal_point;
        if !to_viewer.value().is_finite() {
            return Err(overflow);
        }
        if to_viewer.value() == DVec3::ZERO {
            return Err(CameraError::FocalPointAtPosition);
        }
        let k = to_viewer.exponent();
        let near_one = to_viewer.scaled(-k);
        let length = near_one.length();
        let distance = length.scaled(k);
        if !distance.value().is_finite() {
            return Err(overflow);
        }
        let n = near_one.map(|x| x / length);
        let u = sideways(pose.up, near_one).ok_or(CameraError::ViewUpCollinear)?.unit();
        let v = n.cross(u);
        Ok(Self { u, v, n, distance, to_viewer })
    }

    /// The basis, rounded.
    pub(super) fn basis(&self) -> Basis {
        Basis { u: self.u.value(), v: self.v.value(), n: self.n.value() }
    }

    /// **n** · `offset`, zero if and only if the exact product is. (A value below 2⁻⁹⁶ of its summands is zero too,
    /// because after operations that's noise.)
    pub(super) fn along_normal(&self, offset: Dd3) -> Dd {
        let near_one = self.to_viewer.scaled(-self.to_viewer.exponent());
        let pairs = near_one.to_array().into_iter().zip(offset.to_array());
        let terms: Vec<f64> = pairs.flat_map(|(w, d)| products(w, d)).collect();
        let size: f64 = terms.iter().map(|x| x.abs()).sum();
        exact_sum(terms).without_noise(size) / near_one.length()
    }
}

/// VUP × (C − PF). `None` if the two are collinear, exactly or so nearly that the rest of the product could come from
/// rounding the components of both, as with VUP = 3 (PF − C), rounded.
fn sideways(up: Dd3, to_viewer: Dd3) -> Option<Dd3> {
    let (up, w) = (up.to_array(), to_viewer.to_array());
    let component = |i: usize, j: usize| {
        let sum = exact_sum(products(up[i], w[j]).into_iter().chain(products(-up[j], w[i])));
        let size = (up[i].value() * w[j].value()).abs() + (up[j].value() * w[i].value()).abs();
        let zero = sum.value().abs() <= 2.0 * f64::EPSILON * size;
        (sum, zero)
    };
    let [(x, x_zero), (y, y_zero), (z, z_zero)] = [component(1, 2), component(2, 0), component(0, 1)];
    if x_zero && y_zero && z_zero { None } else { Some(Dd3::new(x, y, z)) }
}

/// Eight numbers whose exact sum is `a b`.
fn products(a: Dd, b: Dd) -> [f64; 8] {
    let ([a, a_rest], [b, b_rest]) = (a.parts(), b.parts());
    let [(p, pe), (q, qe), (r, re), (s, se)] =
        [two_product(a, b), two_product(a, b_rest), two_product(a_rest, b), two_product(a_rest, b_rest)];
    [p, pe, q, qe, r, re, s, se]
}
