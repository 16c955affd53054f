//! Three ways to know an error, side by side: against a reference, by a bound, by random rounding.

use super::reference::Reference;
use crate::camera::Parameters;
use crate::chain::real::Real;
use crate::chain::{Enclosure, Matrix, basis, pose, scaled_basis, view_matrix};
use crate::geometry::double_double::{sin_cos_degrees, two_product, two_sum};
use crate::numbers::random::Random;

/// An `f64` of which each operation is rounded up or down at random. What several runs agree on, rounding hasn't
/// changed: J. Vignes, *A stochastic arithmetic for reliable scientific computation* (1993). One number has one value
/// in a run, so the coin is that of the operation's result and rest.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
struct Chance<const RUN: u64>(f64);

impl<const RUN: u64> Chance<RUN> {
    /// One of the neighbours of an exact result that's `rest` beyond its nearest `f64`.
    fn rounded(nearest: f64, rest: f64) -> Self {
        let heads = || Random::new(nearest.to_bits() ^ rest.to_bits().rotate_left(32), RUN).between(0.0, 1.0) < 0.5;
        Self(match rest {
            rest if rest > 0.0 && heads() => nearest.next_up(),
            rest if rest < 0.0 && heads() => nearest.next_down(),
            _ => nearest,
        })
    }

    fn plus(self, other: Self) -> Self {
        let (sum, rest) = two_sum(self.0, other.0);
        Self::rounded(sum, rest)
    }

    fn by(self, other: Self) -> Self {
        let (product, rest) = two_product(self.0, other.0);
        Self::rounded(product, rest)
    }

    fn over(self, other: Self) -> Self {
        let quotient = self.0 / other.0;
        Self::rounded(quotient, (-quotient).mul_add(other.0, self.0) / other.0)
    }

    fn opposite(self) -> Self {
        Self(-self.0)
    }
}

camera_lab_engine::operators!([const RUN: u64] Chance<RUN>);

impl<const RUN: u64> Real for Chance<RUN> {
    fn of(x: f64) -> Self {
        Self(x)
    }

    fn to_f64(&self) -> f64 {
        self.0
    }

    fn sqrt(self) -> Self {
        let root = self.0.sqrt();
        Self::rounded(root, (-root).mul_add(root, self.0))
    }

    fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
        let (sine, cosine) = sin_cos_degrees(degrees);
        let rounded = |[nearest, rest]: [f64; 2]| Self::rounded(nearest, rest);
        (rounded(sine.parts()), rounded(cosine.parts()))
    }
}

/// The decimal digits of M_v by the textbook's formulas in `f64`, as each way tells them, 0 … 16: those of the error in
/// the 2-norm, relative to M_v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreeWays {
    /// Compared with 512 bits.
    pub reference: f64,
    /// At least these, whatever the truth is: compared with the far ends of intervals that hold it.
    pub bound: f64,
    /// Those on which three runs agree that round each operation up or down at random. They don't know the truth.
    pub random: f64,
}

fn textbook<R: Real>(p: &Parameters) -> Matrix<R> {
    let pose = pose::<R>(p);
    view_matrix(&basis(&pose), &pose[0])
}

impl ThreeWays {
    /// The three ways for the camera of `p`.
    pub fn new(p: &Parameters) -> Self {
        let computed = textbook::<f64>(p);
        let pose = pose::<Enclosure>(p);
        let enclosed = view_matrix(&scaled_basis(&pose), &pose[0]);
        let runs = [
            textbook::<Chance<1>>(p).rounded(),
            textbook::<Chance<2>>(p).rounded(),
            textbook::<Chance<3>>(p).rounded(),
        ];
        let exact = textbook::<Reference>(p);
        let digits = |error: &dyn Fn(usize, usize) -> f64| {
            let norm = |f: &dyn Fn(usize, usize) -> f64| (0..12).map(|k| f(k / 4, k % 4)).fold(0.0, f64::hypot);
            let share = norm(error) / norm(&|i, j| computed.0[i][j]);
            if share.is_nan() { 0.0 } else { (-share.log10()).clamp(0.0, 16.0) }
        };
        let far_end = |i: usize, j: usize| match enclosed.0[i][j].ends() {
            Some([low, high]) => (computed.0[i][j] - low).abs().max((high - computed.0[i][j]).abs()),
            None => f64::INFINITY,
        };
        let spread = |i: usize, j: usize| {
            let values = runs.each_ref().map(|run: &Matrix<f64>| run.0[i][j]);
            values.into_iter().fold(f64::MIN, f64::max) - values.into_iter().fold(f64::MAX, f64::min)
        };
        Self {
            reference: digits(&|i, j| (Reference::of(computed.0[i][j]) - exact.0[i][j].clone()).to_f64()),
            bound: digits(&far_end),
            random: digits(&spread),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_bound_and_the_runs_tell_what_the_reference_knows() {
        let ordinary = ThreeWays::new(&Parameters::default());
        assert!(ordinary.reference > 15.0 && ordinary.bound > 15.0 && ordinary.random > 14.5, "{ordinary:?}");
        // VUP is 1e-7 from DOP.
        let along = Parameters::default().position.normalize();
        let p = Parameters { view_up: along + 1e-7 * DVec3::X, ..Parameters::default() };
        let stiff = ThreeWays::new(&p);
        assert!((7.0..11.0).contains(&stiff.reference), "{stiff:?}");
        assert!(stiff.bound <= stiff.reference + 0.1 && stiff.bound > stiff.reference - 1.0, "{stiff:?}");
        assert!((stiff.random - stiff.reference).abs() < 2.0, "{stiff:?}");
    }

    #[test]
    fn an_operation_is_rounded_to_a_neighbour_and_an_exact_one_is_not_rounded() {
        let third = Chance::<1>(1.0) / Chance(3.0);
        assert!([1.0 / 3.0, (1.0_f64 / 3.0).next_up()].contains(&third.0));
        assert_eq!((Chance::<2>(0.5) + Chance(0.25)).0, 0.75);
        let sums: Vec<f64> = (1..100).map(|i| (Chance::<3>(1.0) + Chance(f64::from(i) * 1e-17)).0).collect();
        assert!(sums.contains(&1.0) && sums.iter().any(|sum| *sum > 1.0));
    }
}
