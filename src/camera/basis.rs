//! DOP, D, **u** **v** **n** from C, PF and VUP: `[0]` Eqs. (5.2) and (5.3).

use glam::DVec3;

use super::{CameraError, Derived};
use crate::geometry::double_double::{Dd, Dd3, exact_sum, exponent, scale, two_product, two_sum};

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

/// Where a camera stands. Kept in double-double, so that a chain of operations rounds once, at its end.
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

    /// What rounding leaves of C: C = `position.value()` + this.
    pub(super) fn position_rest(&self) -> DVec3 {
        DVec3::from_array(self.position.to_array().map(|x| x.parts()[1]))
    }

    /// True when no operation has left anything between the `f64`s.
    pub(super) fn is_exact(&self) -> bool {
        let [c, pf, up] = [self.position, self.focal_point, self.up];
        [c, pf, up].iter().all(|v| v.to_array().iter().all(|x| x.parts()[1] == 0.0))
    }
}

/// How small the cross product of VUP and C − PF may be before the two count as collinear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Collinear {
    /// Only when it is exactly zero.
    Exactly,
    /// Also when what is left of it could come from rounding the components themselves: VUP = 3 (PF − C), rounded.
    UpToRounding,
}

/// **u**, **v**, **n** and D in double-double.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frame {
    pub(super) u: Dd3,
    pub(super) v: Dd3,
    pub(super) n: Dd3,
    /// D.
    pub(super) distance: Dd,
    /// C − PF times a power of two, exactly: each component is the sum of four numbers.
    to_viewer: [[f64; 4]; 3],
    /// Its length.
    to_viewer_length: Dd,
}

impl Frame {
    /// Derives the VRC.
    ///
    /// The components of C − PF are exact sums, the cross product VUP × (C − PF) is an exact sum of products: only its
    /// rounding to 106 bits, the square root and the division are inexact. Nothing overflows or underflows on the way,
    /// as vectors are scaled by powers of two first.
    pub(super) fn new(pose: &Pose, collinear: Collinear) -> Result<Self, CameraError> {
        let (c, pf) = (pose.position.to_array(), pose.focal_point.to_array());
        let terms: [[f64; 4]; 3] = std::array::from_fn(|i| {
            let ([c_hi, c_lo], [pf_hi, pf_lo]) = (c[i].parts(), pf[i].parts());
            let (sum, error) = two_sum(c_hi, -pf_hi);
            [sum, error, c_lo, -pf_lo]
        });
        let overflow = CameraError::Overflow { quantity: Derived::Distance, keys: &["focal_point", "position"] };
        if terms.iter().any(|t| !t[0].is_finite()) {
            return Err(overflow);
        }
        let size = terms.iter().map(|t| exact_sum(*t).value().abs()).fold(0.0, f64::max);
        if size == 0.0 {
            return Err(CameraError::FocalPointAtPosition);
        }
        let k = exponent(size);
        let to_viewer = terms.map(|t| t.map(|x| scale(x, -k)));
        let w = Dd3::new(exact_sum(to_viewer[0]), exact_sum(to_viewer[1]), exact_sum(to_viewer[2]));
        let length = w.length();
        let distance = length.scaled(k);
        if !distance.value().is_finite() {
            return Err(overflow);
        }
        let n = w.map(|x| x / length);
        let u = sideways(pose.up, &to_viewer, collinear).ok_or(CameraError::ViewUpCollinear)?.unit();
        let v = n.cross(u);
        Ok(Self { u, v, n, distance, to_viewer, to_viewer_length: length })
    }

    /// The basis, rounded.
    pub(super) fn basis(&self) -> Basis {
        Basis { u: self.u.value(), v: self.v.value(), n: self.n.value() }
    }

    /// **n** · `offset`, where each component of `offset` is the exact sum of three numbers. Exactly zero when it is;
    /// with `noise`, also when what is left lies below 2⁻⁹⁶ of the summands.
    pub(super) fn height_above_eye_plane(&self, offset: &[[f64; 3]; 3], noise: bool) -> Dd {
        let mut terms = Vec::with_capacity(72);
        for (w, d) in self.to_viewer.iter().zip(offset) {
            for a in w {
                for b in d {
                    let (product, error) = two_product(*a, *b);
                    terms.extend([product, error]);
                }
            }
        }
        let size: f64 = terms.iter().map(|x| x.abs()).sum();
        let sum = exact_sum(terms);
        if noise && sum.value().abs() <= size * 2f64.powi(-96) { Dd::ZERO } else { sum / self.to_viewer_length }
    }
}

/// VUP × (C − PF); `None` when the two are collinear.
fn sideways(up: Dd3, to_viewer: &[[f64; 4]; 3], collinear: Collinear) -> Option<Dd3> {
    let up = up.to_array().map(Dd::parts);
    let component = |i: usize, j: usize| {
        let mut terms = Vec::with_capacity(32);
        for a in up[i] {
            for b in to_viewer[j] {
                let (product, error) = two_product(a, b);
                terms.extend([product, error]);
            }
        }
        for a in up[j] {
            for b in to_viewer[i] {
                let (product, error) = two_product(-a, b);
                terms.extend([product, error]);
            }
        }
        let size = (up[i][0] * to_viewer[j][0]).abs() + (up[j][0] * to_viewer[i][0]).abs();
        let sum = exact_sum(terms);
        let zero = match collinear {
            Collinear::Exactly => sum.value() == 0.0,
            Collinear::UpToRounding => sum.value().abs() <= 2.0 * f64::EPSILON * size,
        };
        (sum, zero)
    };
    let [(x, x_zero), (y, y_zero), (z, z_zero)] = [component(1, 2), component(2, 0), component(0, 1)];
    if x_zero && y_zero && z_zero { None } else { Some(Dd3::new(x, y, z)) }
}
