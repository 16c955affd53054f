//! Numbers of twice the precision of `f64`, for the few cases in which one rounding too many would show.
//!
//! A [`Dd`] is an unevaluated sum `hi + lo` with `hi = fl(hi + lo)`: 106 bits, the range of `f64`. The model computes
//! in it and rounds once, at the end. Sources: T. J. Dekker, *A floating-point technique for extending the available
//! precision* (1971); D. M. Priest (1991); J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast
//! robust geometric predicates* (1997).

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec3;

/// `a + b` as rounded sum and exact error.
#[inline]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// `a + b` as rounded sum and exact error, if |a| ≥ |b|.
#[inline]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// `a b` as rounded product and error. The error is exact unless it underflows.
#[inline]
pub fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    (p, a.mul_add(b, -p))
}

/// `x · 2^k`: exact unless it overflows or becomes subnormal.
pub fn scale(x: f64, k: i32) -> f64 {
    let mut x = x;
    let mut k = k;
    while k > 1000 {
        x *= 2f64.powi(1000);
        k -= 1000;
    }
    while k < -1000 {
        x *= 2f64.powi(-1000);
        k += 1000;
    }
    x * 2f64.powi(k)
}

/// The k with 2^k ≤ |x| < 2^(k+1); 0 for zero and non-finite numbers.
pub fn exponent(x: f64) -> i32 {
    const BIAS: i32 = 1023;
    if x == 0.0 || !x.is_finite() {
        return 0;
    }
    let (x, shift) = if x.abs() < f64::MIN_POSITIVE { (x * 2f64.powi(64), 64) } else { (x, 0) };
    let bits = ((x.to_bits() >> 52) & 0x7ff) as i32;
    bits - BIAS - shift
}

/// 2⁻⁹⁶: anything smaller than this part of its summands is the noise of a computation with 106 bits.
pub const NOISE: f64 = 1.262_177_448_353_619e-29;

/// A number `hi + lo`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dd {
    hi: f64,
    lo: f64,
}

impl Dd {
    /// 0
    pub const ZERO: Self = Self::new(0.0);
    /// 1
    pub const ONE: Self = Self::new(1.0);
    /// π / 180.
    pub(crate) const RADIANS_PER_DEGREE: Self = Self { hi: 0.017_453_292_519_943_295, lo: 2.948_652_270_870_168_7e-19 };
    /// 180 / π.
    const DEGREES_PER_RADIAN: Self = Self { hi: 57.295_779_513_082_32, lo: -1.987_849_567_057_628_3e-15 };

    /// Exactly `x`.
    pub const fn new(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }

    /// Exactly `a + b`.
    pub fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// Exactly `a − b`.
    pub fn difference(a: f64, b: f64) -> Self {
        Self::sum(a, -b)
    }

    /// The nearest `f64`.
    pub const fn value(self) -> f64 {
        self.hi
    }

    /// Both parts, the greater first.
    pub const fn parts(self) -> [f64; 2] {
        [self.hi, self.lo]
    }

    /// `self · 2^k`.
    pub fn scaled(self, k: i32) -> Self {
        Self { hi: scale(self.hi, k), lo: scale(self.lo, k) }
    }

    /// The square root of a number that isn't negative.
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::ZERO;
        }
        let x = 1.0 / self.hi.sqrt();
        let a = self.hi * x;
        let rest = (self - Self::new(a) * Self::new(a)).hi;
        Self::sum(a, rest * (x * 0.5))
    }

    /// Zero if nothing is left of a sum but the noise of its summands: below 2⁻⁹⁶ of their `size`.
    pub fn without_noise(self, size: f64) -> Self {
        if self.hi.abs() <= size * NOISE { Self::ZERO } else { self }
    }

    /// The sum. Zero if nothing but noise is left of it.
    pub fn plus(self, other: Self) -> Self {
        (self + other).without_noise(self.hi.abs() + other.hi.abs())
    }

    /// The greatest whole number that isn't above it. A value within `noise` (at most 2⁻²⁰) of a whole number is that
    /// number.
    pub fn floor(self, noise: f64) -> f64 {
        let nearest = self.hi.round();
        let off = (self - Self::new(nearest)).hi;
        let noise = noise.max(self.hi.abs() * NOISE).min(2f64.powi(-20));
        if off >= -noise { nearest } else { nearest - 1.0 }
    }
}

impl From<f64> for Dd {
    fn from(x: f64) -> Self {
        Self::new(x)
    }
}

impl Neg for Dd {
    type Output = Self;

    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for Dd {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (t, f) = two_sum(self.lo, other.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Self { hi, lo }
    }
}

impl Sub for Dd {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (p, e) = two_product(self.hi, other.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * other.lo + self.lo * other.hi));
        Self { hi, lo }
    }
}

impl Div for Dd {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let q1 = self.hi / other.hi;
        let rest = self - other * Self::new(q1);
        let q2 = rest.hi / other.hi;
        let rest = rest - other * Self::new(q2);
        let (hi, lo) = quick_two_sum(q1, q2);
        Self { hi, lo } + Self::new(rest.hi / other.hi)
    }
}

impl PartialOrd for Dd {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.parts().partial_cmp(&other.parts())
    }
}

/// The sum of `terms`, as if it were computed exactly and then rounded to 106 bits (Shewchuk's growing expansions).
/// Zero if and only if the exact sum is zero.
pub fn exact_sum(terms: impl IntoIterator<Item = f64>) -> Dd {
    let mut parts: Vec<f64> = Vec::with_capacity(16);
    for term in terms {
        let mut x = term;
        let mut kept = 0;
        for i in 0..parts.len() {
            let (s, e) = two_sum(x, parts[i]);
            if e != 0.0 {
                parts[kept] = e;
                kept += 1;
            }
            x = s;
        }
        parts.truncate(kept);
        if x != 0.0 {
            parts.push(x);
        }
    }
    parts.iter().rev().fold(Dd::ZERO, |sum, part| sum + Dd::new(*part))
}

/// Sine and cosine of an angle in degrees, to about 100 bits, exact at the multiples of 30° where they are rational.
/// The angle is reduced exactly: 360° more or less change no bit.
pub fn sin_cos_degrees(degrees: f64) -> (Dd, Dd) {
    let (quarters, rest) = in_quarters(degrees);
    let half = Dd::new(0.5);
    let (s, c) = if rest.abs() == 30.0 {
        (if rest > 0.0 { half } else { -half }, Dd::new(0.75).sqrt())
    } else if rest.abs() == 45.0 {
        let root = half.sqrt();
        (if rest > 0.0 { root } else { -root }, root)
    } else {
        sin_cos_radians(Dd::new(rest) * Dd::RADIANS_PER_DEGREE)
    };
    turned((s, c), quarters)
}

/// Quarters of a turn, and the rest in degrees, −45 … 45. Both are exact: a remainder is, and so is the difference of
/// numbers of which neither is more than twice the other.
pub(crate) fn in_quarters(degrees: f64) -> (f64, f64) {
    let turn = degrees % 360.0;
    let quarters = (turn / 90.0).round();
    (quarters, turn - quarters * 90.0)
}

/// Sine and cosine of an angle that is quarters of a turn greater.
pub(crate) fn turned<T: Neg<Output = T>>((s, c): (T, T), quarters: f64) -> (T, T) {
    match quarters.rem_euclid(4.0) {
        0.0 => (s, c),
        1.0 => (c, -s),
        2.0 => (-s, -c),
        _ => (-c, s),
    }
}

/// By Taylor's series up to x³¹, |x| ≤ π/4.
pub(crate) fn sin_cos_radians<T>(x: T) -> (T, T)
where
    T: Copy + From<f64> + Neg<Output = T> + Add<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    let minus_square = -(x * x);
    let (mut sine, mut cosine) = (x, T::from(1.0));
    let (mut odd, mut even) = (x, T::from(1.0));
    for k in 1..=15 {
        let k = f64::from(2 * k);
        even = even * minus_square / T::from(k * (k - 1.0));
        odd = odd * minus_square / T::from(k * (k + 1.0));
        cosine = cosine + even;
        sine = sine + odd;
    }
    (sine, cosine)
}

/// tan(θ/2) for 0 ≤ θ < 180 in degrees. Near 180° it comes from the complement 180° − θ, which is exact.
pub fn tan_half_degrees(degrees: f64) -> Dd {
    if degrees > 90.0 {
        let (s, c) = sin_cos_degrees((180.0 - degrees) / 2.0);
        c / s
    } else if degrees == 90.0 {
        Dd::ONE
    } else {
        let (s, c) = sin_cos_degrees(degrees / 2.0);
        s / c
    }
}

/// arctan in degrees: one step of Newton's method, in double-double, from the `f64` value.
pub fn atan_degrees(tangent: Dd) -> Dd {
    if tangent.hi < 0.0 {
        return -atan_degrees(-tangent);
    }
    if tangent.hi > 1.0 {
        return Dd::new(90.0) - atan_degrees(Dd::ONE / tangent);
    }
    let start = tangent.hi.atan();
    let (s, c) = sin_cos_radians(Dd::new(start));
    // tan(a − b) = (tan a − tan b) / (1 + tan a tan b); the difference is so small that it is its own arctangent.
    let step = (tangent * c - s) / (c + tangent * s);
    (Dd::new(start) + step) * Dd::DEGREES_PER_RADIAN
}

/// A vector of three [`Dd`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dd3 {
    /// x
    pub x: Dd,
    /// y
    pub y: Dd,
    /// z
    pub z: Dd,
}

impl Dd3 {
    /// The vector (x, y, z).
    pub const fn new(x: Dd, y: Dd, z: Dd) -> Self {
        Self { x, y, z }
    }

    /// x, y and z.
    pub const fn to_array(self) -> [Dd; 3] {
        [self.x, self.y, self.z]
    }

    /// The nearest `f64` vector.
    pub fn value(self) -> DVec3 {
        DVec3::new(self.x.value(), self.y.value(), self.z.value())
    }

    /// The vector of `f` of each coordinate.
    pub fn map(self, f: impl Fn(Dd) -> Dd) -> Self {
        Self { x: f(self.x), y: f(self.y), z: f(self.z) }
    }

    /// The scalar product. Zero if nothing but noise is left of it.
    pub fn dot(self, other: Self) -> Dd {
        let [x, y, z] = [self.x * other.x, self.y * other.y, self.z * other.z];
        (x + y + z).without_noise(x.hi.abs() + y.hi.abs() + z.hi.abs())
    }

    /// The sum, with [`Dd::plus`] in each component.
    pub fn plus(self, other: Self) -> Self {
        Self { x: self.x.plus(other.x), y: self.y.plus(other.y), z: self.z.plus(other.z) }
    }

    /// The vector product, with [`Dd::plus`] in each component.
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: (self.y * other.z).plus(-(self.z * other.y)),
            y: (self.z * other.x).plus(-(self.x * other.z)),
            z: (self.x * other.y).plus(-(self.y * other.x)),
        }
    }

    /// The power of two of the greatest component.
    pub fn exponent(self) -> i32 {
        exponent(self.value().abs().max_element())
    }

    /// Every component times 2^k.
    pub fn scaled(self, k: i32) -> Self {
        self.map(|x| x.scaled(k))
    }

    /// Length of a vector whose greatest component is near 1. See [`Self::exponent`] and [`Self::scaled`].
    pub fn length(self) -> Dd {
        self.dot(self).sqrt()
    }

    /// The unit vector along a vector that is neither zero nor infinite, whatever its size.
    pub fn unit(self) -> Self {
        let near_one = self.scaled(-self.exponent());
        let length = near_one.length();
        near_one.map(|x| x / length)
    }
}

impl From<DVec3> for Dd3 {
    fn from(v: DVec3) -> Self {
        Self { x: Dd::new(v.x), y: Dd::new(v.y), z: Dd::new(v.z) }
    }
}

impl Neg for Dd3 {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl Add for Dd3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl Sub for Dd3 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul<Dd> for Dd3 {
    type Output = Self;

    fn mul(self, s: Dd) -> Self {
        self.map(|x| x * s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// hi and lo of a number that is known to 32 digits.
    fn near(x: Dd, hi: f64, lo: f64) -> bool {
        (x - Dd::sum(hi, lo)).value().abs() <= hi.abs() * 2f64.powi(-100)
    }

    #[test]
    fn sums_and_products_lose_nothing() {
        assert_eq!(two_sum(1e16, 1.0), (1e16, 1.0));
        assert_eq!(two_product(1.0 + f64::EPSILON, 1.0 - f64::EPSILON), (1.0, -f64::EPSILON * f64::EPSILON));
        let third = Dd::ONE / Dd::new(3.0);
        assert_eq!((third * Dd::new(3.0) - Dd::ONE).value(), 0.0);
        assert_eq!(third.parts()[0], 1.0 / 3.0);
        assert_eq!(exact_sum([1e300, 1.0, -1e300, 1e-300, -1.0]).value(), 1e-300);
        assert_eq!(exact_sum([0.1, 0.2, -0.1, -0.2]), Dd::ZERO);
    }

    #[test]
    fn roots_have_thirty_digits() {
        // √2 = 1.41421356237309504880168872420969807…
        assert!(near(Dd::new(2.0).sqrt(), std::f64::consts::SQRT_2, -9.667_293_313_452_913e-17));
        assert_eq!(Dd::ZERO.sqrt(), Dd::ZERO);
        assert_eq!(Dd::new(1e-300).sqrt().value(), 1e-150);
    }

    #[test]
    fn sine_and_cosine_are_exact_where_they_are_rational() {
        let half = Dd::new(0.5);
        for (degrees, sine, cosine) in [
            (0.0, Dd::ZERO, Some(Dd::ONE)),
            (30.0, half, None),
            (90.0, Dd::ONE, Some(Dd::ZERO)),
            (150.0, half, None),
            (180.0, Dd::ZERO, Some(-Dd::ONE)),
            (210.0, -half, None),
            (-30.0, -half, None),
            (330.0, -half, None),
            (-90.0, -Dd::ONE, Some(Dd::ZERO)),
            (390.0, half, None),
            (360e9, Dd::ZERO, Some(Dd::ONE)),
        ] {
            let (s, c) = sin_cos_degrees(degrees);
            assert_eq!(s.value(), sine.value(), "sin {degrees}");
            assert!(cosine.is_none_or(|cosine| c.value() == cosine.value()), "cos {degrees}");
        }
        let (s, c) = sin_cos_degrees(60.0);
        assert_eq!(c, half);
        assert_eq!(s, Dd::new(0.75).sqrt());
        let (s, c) = sin_cos_degrees(45.0);
        assert_eq!(s, c);
    }

    #[test]
    fn sine_of_any_angle_has_thirty_digits() {
        // sin 1° = 0.017452406437283512819418978516316192…, cos 1° = 0.99984769515639123915701155881391485…
        let (s, c) = sin_cos_degrees(1.0);
        assert!(near(s, 0.017_452_406_437_283_51, 1.166_216_639_340_766_1e-18), "{s:?}");
        assert!(near(c, 0.999_847_695_156_391_3, -3.042_050_003_471_091_4e-17), "{c:?}");
        for degrees in [0.1, 12.3, 44.9, 45.1, 77.0, 133.3, -299.9] {
            let (s, c) = sin_cos_degrees(degrees);
            assert!((s * s + c * c - Dd::ONE).value().abs() < 1e-30, "{degrees}");
            assert_eq!(sin_cos_degrees(degrees * 4.0 + 1440.0).0, sin_cos_degrees((degrees * 4.0 + 1440.0) % 360.0).0);
        }
    }

    #[test]
    fn half_tangents_and_their_angles_agree() {
        assert_eq!(tan_half_degrees(90.0), Dd::ONE);
        // tan(89.99995°) = 1145915.5902…: the complement retains the digits of 180 − θ.
        let wide = tan_half_degrees(179.9999).value();
        assert!((wide - 1_145_915.590_3).abs() < 0.01, "{wide}");
        for degrees in [1e-300, 1e-6, 0.5, 45.0, 60.0, 89.0, 90.0, 91.0, 120.0, 179.9999, 179.999_999_999] {
            assert_eq!(atan_degrees(tan_half_degrees(degrees)).scaled(1).value(), degrees);
        }
        assert_eq!(atan_degrees(-Dd::ONE).value(), -45.0);
    }

    #[test]
    fn floors_are_those_of_the_exact_number() {
        assert_eq!(Dd::new(3.0).floor(0.0), 3.0);
        assert_eq!(Dd::sum(3.0, -1e-20).floor(0.0), 2.0);
        assert_eq!(Dd::sum(3.0, -1e-20).floor(1e-19), 3.0);
        assert_eq!(Dd::sum(3.0, 1e-20).floor(0.0), 3.0);
        assert_eq!(Dd::new(-0.5).floor(0.0), -1.0);
        assert_eq!(Dd::new(1e300).floor(0.0), 1e300);
        assert_eq!(Dd::new(0.75).floor(1.0), 0.0, "noise is never more than 2⁻²⁰");
    }

    #[test]
    fn scaling_by_powers_of_two_is_exact_over_the_whole_range() {
        assert_eq!(exponent(1.0), 0);
        assert_eq!(exponent(-0.75), -1);
        assert_eq!(exponent(f64::MAX), 1023);
        assert_eq!(exponent(f64::MIN_POSITIVE), -1022);
        assert_eq!(exponent(5e-324), -1074);
        assert_eq!(exponent(0.0), 0);
        assert_eq!(scale(5e-324, 1074), 1.0);
        assert_eq!(scale(1.5, 1023), 1.5 * 2f64.powi(1023));
        assert_eq!(scale(f64::MAX, -1023), 2.0 - f64::EPSILON);
        let tiny = Dd3::from(DVec3::new(3e-310, 0.0, 4e-310)).unit().value();
        assert!((tiny - DVec3::new(0.6, 0.0, 0.8)).length() < 1e-13, "as good as the subnormal input");
        assert_eq!(Dd3::from(DVec3::new(3e300, 0.0, 4e300)).unit().value(), DVec3::new(0.6, 0.0, 0.8));
    }
}
