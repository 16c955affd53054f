//! The kinds of numbers for the textbook chain.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::appearance::VertexFormat;
use crate::geometry::Angle;
use crate::geometry::double_double::{Dd, sin_cos_degrees};

/// The most numbers that a figure gives its camera: C, PF, VUP, F, B and l, r, b, t.
pub const GIVEN: usize = 15;

/// The operations that the textbook chain needs from a number: single, double, twice double, or the reference; an
/// [`Enclosure`](super::Enclosure), or a number with its [`Gradient`](super::Gradient).
pub trait Real:
    Clone
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number of this kind that's nearest to `x`.
    fn of(x: f64) -> Self;

    /// The `f64` nearest to it.
    fn to_f64(&self) -> f64;

    /// The square root of a number that isn't negative.
    fn sqrt(self) -> Self;

    /// Sine and cosine of an angle in degrees.
    fn sin_cos_degrees(degrees: f64) -> (Self, Self);

    /// The number `x` that a figure gives as its `k`-th, 0 … [`GIVEN`] − 1.
    fn given(x: f64, _k: usize) -> Self {
        Self::of(x)
    }

    /// tan(θ/2) of an angle in degrees that a figure gives as its `k`-th number.
    fn given_half_tangent(degrees: f64, _k: usize) -> Self {
        let (sine, cosine) = Self::sin_cos_degrees(degrees / 2.0);
        sine / cosine
    }

    /// 0.
    fn zero() -> Self {
        Self::of(0.0)
    }

    /// 1.
    fn one() -> Self {
        Self::of(1.0)
    }
}

/// The operators of a kind of number, from its methods `plus`, `by`, `over` and `opposite`.
#[macro_export]
macro_rules! operators {
    ([$($generic:tt)*] $number:ty) => {
        impl<$($generic)*> std::ops::Add for $number {
            type Output = Self;
            fn add(self, other: Self) -> Self { self.plus(other) }
        }
        impl<$($generic)*> std::ops::Sub for $number {
            type Output = Self;
            fn sub(self, other: Self) -> Self { self.plus(-other) }
        }
        impl<$($generic)*> std::ops::Mul for $number {
            type Output = Self;
            fn mul(self, other: Self) -> Self { self.by(other) }
        }
        impl<$($generic)*> std::ops::Div for $number {
            type Output = Self;
            fn div(self, other: Self) -> Self { self.over(other) }
        }
        impl<$($generic)*> std::ops::Neg for $number {
            type Output = Self;
            fn neg(self) -> Self { self.opposite() }
        }
    };
}

impl Real for f32 {
    #[expect(clippy::cast_possible_truncation, reason = "what single precision makes of a number is what is studied")]
    fn of(x: f64) -> Self {
        x as Self
    }

    fn to_f64(&self) -> f64 {
        f64::from(*self)
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        let (sine, cosine) = Angle::from_degrees(degrees).sin_cos();
        (Self::of(sine), Self::of(cosine))
    }
}

impl Real for f64 {
    fn of(x: f64) -> Self {
        x
    }

    fn to_f64(&self) -> f64 {
        *self
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        Angle::from_degrees(degrees).sin_cos()
    }
}

impl Real for Dd {
    fn of(x: f64) -> Self {
        Self::new(x)
    }

    fn to_f64(&self) -> f64 {
        self.value()
    }

    fn sqrt(self) -> Self {
        self.sqrt()
    }

    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        sin_cos_degrees(degrees)
    }
}

/// A number of a format, kept as the `f64` that it is. Each result is that of `f64`, rounded to the format. `f64` has
/// more than twice the bits of the floats here, so two roundings are one (S. A. Figueroa, *When is double rounding
/// innocuous?*, 1995).
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Narrow<const FORMAT: usize>(f64);

/// Half precision.
pub type F16 = Narrow<0>;
/// `bfloat16`.
pub type Bf16 = Narrow<1>;
/// Fixed point with 16 bits before and 16 behind the point.
pub type Fixed16 = Narrow<2>;

impl<const FORMAT: usize> Narrow<FORMAT> {
    const FORMAT: VertexFormat = [VertexFormat::F16, VertexFormat::Bf16, VertexFormat::Fixed16][FORMAT];

    fn plus(self, other: Self) -> Self {
        Self::of(self.0 + other.0)
    }

    fn by(self, other: Self) -> Self {
        Self::of(self.0 * other.0)
    }

    fn over(self, other: Self) -> Self {
        Self::of(self.0 / other.0)
    }

    fn opposite(self) -> Self {
        Self::of(-self.0)
    }
}

crate::operators!([const FORMAT: usize] Narrow<FORMAT>);

impl<const FORMAT: usize> Real for Narrow<FORMAT> {
    fn of(x: f64) -> Self {
        Self(Self::FORMAT.round(x))
    }

    fn to_f64(&self) -> f64 {
        self.0
    }

    fn sqrt(self) -> Self {
        Self::of(self.0.sqrt())
    }

    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        let (sine, cosine) = Angle::from_degrees(degrees).sin_cos();
        (Self::of(sine), Self::of(cosine))
    }
}
