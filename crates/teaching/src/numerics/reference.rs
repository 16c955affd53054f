//! The reference: numbers of 512 bits, correctly rounded, without limits of size.

use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

use super::real::Real;

/// Bits of the significand. At least 200 of them are left if VUP and DOP are 1e-15 apart and a world 1e12 away.
pub const PRECISION: usize = 512;

type Number = FBig<HalfEven, 2>;

/// A number of [`PRECISION`] bits, of any size.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Reference(Number);

impl Reference {
    fn wide(x: Number) -> Self {
        Self(x.with_precision(PRECISION).value())
    }

    /// |x|.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.0 < Number::ZERO { -self } else { self }
    }
}

impl Real for Reference {
    /// Exactly `x`; 0 for non-finite numbers, which a reference doesn't have.
    fn of(x: f64) -> Self {
        Self::wide(Number::try_from(x).unwrap_or(Number::ZERO))
    }

    fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }

    fn sqrt(self) -> Self {
        if self.0 <= Number::ZERO { Self::of(0.0) } else { Self(self.0.sqrt()) }
    }

    /// The angle is reduced as a fraction of a whole turn, exactly.
    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        let (sine, cosine) = Self::of(degrees).0.sin_cos_unit(360);
        (Self(sine), Self(cosine))
    }
}

impl Add for Reference {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Reference {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Reference {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

/// Division by zero gives 0, because a reference never needs it.
impl Div for Reference {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.0 == Number::ZERO { Self::of(0.0) } else { Self(self.0 / other.0) }
    }
}

impl Neg for Reference {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// √2, sin 18° = (√5 − 1)/4 and 1/3 to more digits than 200 bits have, from exact identities.
    #[test]
    fn the_reference_has_more_than_two_hundred_bits() {
        let tiny = Reference::of(2f64.powi(-500));
        let below = |x: Reference| x.abs() < tiny;
        let root = Reference::of(2.0).sqrt();
        assert!(below(root.clone() * root - Reference::of(2.0)));
        let (sine, cosine) = Reference::sin_cos_degrees(18.0);
        let golden = (Reference::of(5.0).sqrt() - Reference::one()) / Reference::of(4.0);
        assert!(below(sine.clone() - golden));
        assert!(below(sine.clone() * sine + cosine.clone() * cosine - Reference::one()));
        assert!(below(Reference::one() / Reference::of(3.0) * Reference::of(3.0) - Reference::one()));
        // A difference that's lost in 53 bits, and in 106, and a size that f64 doesn't have.
        let large = Reference::of(1e40);
        assert_eq!((large.clone() + Reference::of(1e-40) - large).to_f64(), 1e-40);
        let square = Reference::of(1e300) * Reference::of(1e300);
        assert_eq!((square / Reference::of(1e300)).to_f64(), 1e300);
    }
}
