//! Numbers that are proved: a middle in double-double, and how far the true number can be from it.
//!
//! Of the two forms of an interval, its ends or its middle and radius, this is the tighter and the cheaper one here. A
//! pair of ends in double-double costs twice the operations, and each end has the whole error bound of an operation.
//! The middle is rounded to nearest, wrong by a few parts in 2¹⁰⁶, and the radius needs only a few bits. Both forms are
//! rounded outward to `f64`s once, at the end. An interval 50 bits finer than an `f64` ends between the same two
//! neighbours, so that ordinary numbers are one unit of the last place wide, which is the least for numbers that aren't
//! `f64`s.

use crate::geometry::double_double::{Dd, in_quarters, sin_cos_radians, turned, two_sum};

use super::real::Real;

/// All numbers whose distance from a middle is at most a radius. If nothing is known about a number (a quotient by an
/// interval that holds 0, an overflow), the radius isn't finite.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Enclosure {
    middle: Dd,
    radius: f64,
}

/// u = 2⁻⁵³. The error of a sum of two [`Dd`] is at most 3u² + 13u³ of it, that of a product at most 5u²: M. Joldes,
/// J.-M. Muller, V. Popescu, *Tight and rigorous error bounds for basic building blocks of double-word arithmetic*
/// (2017), Algorithms 6 and 10, with the proofs and bounds of J.-M. Muller, L. Rideau, *Formalization of double-word
/// arithmetic* (2022). Here each has a part more, which pays for |hi| instead of |hi + lo|. A sum has no other error,
/// because sums of subnormal numbers are exact, and the sum of two `f64`s has none.
const SUM: f64 = 4.0 * UNIT * UNIT;
const PRODUCT: f64 = 8.0 * UNIT * UNIT;
const UNIT: f64 = f64::EPSILON / 2.0;
/// Below this, the error term of a product isn't exact any more, nor are products of radii, but wrong by a few of the
/// least numbers each.
const SMALL: f64 = 1e-270;
/// 2⁻¹⁰⁷⁰, more than all of these errors of one operation.
const TINY: f64 = 8e-323;
/// More than what a radius loses to roundings in one operation.
const UP: f64 = 1.0 + 64.0 * UNIT;

impl Enclosure {
    const ZERO: Self = Self { middle: Dd::ZERO, radius: 0.0 };
    /// Nothing is known.
    const ANYTHING: Self = Self { middle: Dd::ZERO, radius: f64::INFINITY };

    fn new(middle: Dd, radius: f64) -> Self {
        let [hi, lo] = middle.parts();
        if (hi + lo + radius).is_finite() { Self { middle, radius } } else { Self::ANYTHING }
    }

    fn exact(middle: Dd) -> Self {
        Self::new(middle, 0.0)
    }

    fn size(self) -> f64 {
        self.middle.value().abs()
    }

    /// Nothing in it is farther from 0.
    fn most(self) -> f64 {
        (self.size() + self.radius) * UP
    }

    /// Nothing in it is nearer to 0. Negative if it holds 0.
    fn least(self) -> f64 {
        (self.size() * (1.0 - 4.0 * UNIT) - self.radius) / UP
    }

    /// True if it's an `f64`, exactly.
    fn is_single(self) -> bool {
        self.radius == 0.0 && self.middle.parts()[1] == 0.0
    }

    /// The greatest `f64` that isn't above it, and the least that isn't below. `None` if it isn't enclosed.
    pub fn ends(self) -> Option<[f64; 2]> {
        // The lower end of −x is the upper one of x.
        let low = |x: Dd| {
            let [hi, lo] = x.parts();
            let rest = if self.radius == 0.0 { lo } else { (lo - self.radius).next_down() };
            let (sum, error) = two_sum(hi, rest);
            if error < 0.0 { sum.next_down() } else { sum }
        };
        let ends = [low(self.middle) + 0.0, 0.0 - low(-self.middle)];
        ends.iter().all(|end| end.is_finite()).then_some(ends)
    }

    fn plus(self, other: Self) -> Self {
        let middle = self.middle + other.middle;
        let rounded = if self.is_single() && other.is_single() { 0.0 } else { SUM * middle.value().abs() };
        Self::new(middle, (self.radius + other.radius + rounded) * UP)
    }

    fn by(self, other: Self) -> Self {
        let (a, b) = (self, other);
        if a == Self::ZERO && b.radius.is_finite() || b == Self::ZERO && a.radius.is_finite() {
            return Self::ZERO;
        }
        let middle = a.middle * b.middle;
        let size = middle.value().abs();
        let rounded = if a.is_single() && b.is_single() { 0.0 } else { PRODUCT * size };
        let tiny = if size < SMALL { TINY } else { 0.0 };
        Self::new(middle, (a.size() * b.radius + b.size() * a.radius + a.radius * b.radius + rounded) * UP + tiny)
    }

    /// Whatever the error of the quotient q of the middles: x/y − q = (x − q y)/y.
    fn over(self, other: Self) -> Self {
        let (quotient, least) = (self.middle / other.middle, other.least());
        if least > 0.0 { Self::within(quotient, self - Self::exact(quotient) * other, least) } else { Self::ANYTHING }
    }

    fn opposite(self) -> Self {
        Self { middle: -self.middle, ..self }
    }

    /// The numbers that differ from `middle` by no more than `error` over a positive number from `least` on.
    fn within(middle: Dd, error: Self, least: f64) -> Self {
        let most = error.most();
        Self::new(middle, if most == 0.0 { 0.0 } else { most / least * UP + TINY })
    }
}

crate::operators!([] Enclosure);

impl From<f64> for Enclosure {
    fn from(x: f64) -> Self {
        Self::exact(Dd::new(x))
    }
}

impl Real for Enclosure {
    fn of(x: f64) -> Self {
        x.into()
    }

    fn to_f64(&self) -> f64 {
        self.middle.value()
    }

    /// Whatever the error of the root s of the middle: |√x − s| = |x − s²|/(√x + s).
    fn sqrt(self) -> Self {
        if self == Self::ZERO {
            return Self::ZERO;
        }
        let (root, positive) = (self.middle.sqrt(), self.middle.value() > 0.0 && self.least() > 0.0);
        let square = Self::exact(root) * Self::exact(root);
        if positive { Self::within(root, self - square, root.value() / UP) } else { Self::ANYTHING }
    }

    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        /// π/180 ends 2⁻¹¹⁴ below its first digit, so it's known to half of that.
        const RADIANS_PER_DEGREE: Enclosure = Enclosure { middle: Dd::RADIANS_PER_DEGREE, radius: 3e-35 };
        /// The rest of Taylor's series from x³² on: |x| ≤ π/4, and (π/4)³¹/32! is less.
        const REST: f64 = 3e-39;
        let (quarters, rest) = in_quarters(degrees);
        let x = Self::of(rest) * RADIANS_PER_DEGREE;
        let (sine, cosine) = sin_cos_radians(x);
        let cut = |y: Self| Self::new(y.middle, (y.radius + REST * x.most()) * UP + TINY);
        turned(if rest == 0.0 { (sine, cosine) } else { (cut(sine), cut(cosine)) }, quarters)
    }
}
