//! The kinds of numbers for the textbook chain.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::geometry::Angle;
use crate::geometry::double_double::{Dd, sin_cos_degrees};

/// The operations that the textbook chain needs from a number: single, double, twice double, or the reference.
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

    /// 0.
    fn zero() -> Self {
        Self::of(0.0)
    }

    /// 1.
    fn one() -> Self {
        Self::of(1.0)
    }
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
