//! Numbers with their derivatives by the figure's own numbers, and the condition of a question.

use crate::geometry::double_double::{Dd, sin_cos_degrees, tan_half_degrees};
use crate::numbers::greatest_singular;

use super::real::{GIVEN, Real};

/// A number, and its change for a small change of each number that the figure gives, relative to that number itself. A
/// number of the figure that's 0 has no relative change.
///
/// Automatic differentiation in forward mode, with dual numbers: A. Griewank, A. Walther, *Evaluating Derivatives*
/// (2008), chapter 3. Exact but for rounding, unlike differences.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Gradient {
    value: Dd,
    by: [f64; GIVEN],
}

impl Gradient {
    fn zip(&self, other: &Self, value: Dd, by: impl Fn(f64, f64) -> f64) -> Self {
        Self { value, by: std::array::from_fn(|k| by(self.by[k], other.by[k])) }
    }

    fn plus(self, other: Self) -> Self {
        self.zip(&other, self.value + other.value, |a, b| a + b)
    }

    fn by(self, other: Self) -> Self {
        let (x, y) = (self.value.value(), other.value.value());
        self.zip(&other, self.value * other.value, |a, b| a * y + x * b)
    }

    fn over(self, other: Self) -> Self {
        let (quotient, y) = (self.value / other.value, other.value.value());
        self.zip(&other, quotient, |a, b| (a - quotient.value() * b) / y)
    }

    fn opposite(self) -> Self {
        self.zip(&self, -self.value, |a, _| -a)
    }
}

crate::operators!([] Gradient);

impl Real for Gradient {
    fn of(x: f64) -> Self {
        Self { value: Dd::new(x), by: [0.0; GIVEN] }
    }

    fn to_f64(&self) -> f64 {
        self.value.value()
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.zip(&self, root, |a, _| a / (2.0 * root.value()))
    }

    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        let (sine, cosine) = sin_cos_degrees(degrees);
        (Self { value: sine, ..Self::of(0.0) }, Self { value: cosine, ..Self::of(0.0) })
    }

    fn given(x: f64, k: usize) -> Self {
        let mut number = Self::of(x);
        number.by[k] = x;
        number
    }

    /// d tan(θ/2) = (1 + tan²(θ/2)) dθ/2.
    fn given_half_tangent(degrees: f64, k: usize) -> Self {
        let value = tan_half_degrees(degrees);
        let mut number = Self { value, ..Self::of(0.0) };
        number.by[k] = (1.0 + value.value() * value.value()) * degrees.to_radians() / 2.0;
        number
    }
}

/// The condition of a question: how many times a small relative change of the figure's numbers can grow in a result,
/// both measured by their 2-norms, and the change that grows most. A property of the question, whatever the method.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// The largest singular value of the scaled Jacobian J diag(x)/‖y‖.
    pub number: f64,
    /// The relative change of each number of the figure, of length 1.
    pub direction: [f64; GIVEN],
}

impl Condition {
    /// The condition of the map from the figure's numbers to `result`. `None` if it isn't finite.
    pub fn of<'a>(result: impl IntoIterator<Item = &'a Gradient>) -> Option<Self> {
        let result: Vec<&Gradient> = result.into_iter().collect();
        let size = result.iter().map(|y| y.to_f64()).fold(0.0, f64::hypot);
        let rows: Vec<[f64; GIVEN]> = result.iter().map(|y| y.by.map(|change| change / size)).collect();
        let (number, direction) = greatest_singular(&rows);
        number.is_finite().then_some(Self { number, direction })
    }

    /// The decimal digits that the input loses by itself.
    pub fn digits(&self) -> f64 {
        self.number.max(1.0).log10()
    }
}
