//! The reference: numbers of 512 bits, correctly rounded, without limits of size.

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

use crate::chain::real::Real;

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

    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }

    fn by(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }

    /// Division by zero gives 0, because a reference never needs it.
    fn over(self, other: Self) -> Self {
        if other.0 == Number::ZERO { Self::of(0.0) } else { Self(self.0 / other.0) }
    }

    fn opposite(self) -> Self {
        Self(-self.0)
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

camera_lab_engine::operators!([] Reference);

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use std::cell::Cell;

    use glam::{DMat4, DVec3};

    use super::*;
    use crate::camera::{Camera, Convention, ImageSize, Ndc, Operation, Parameters, Projection, ViewWindow, Viewport};
    use crate::chain::real::GIVEN;
    use crate::chain::{self, Chain, Condition, Enclosure, Gradient, Matrix, pose, scaled_basis};
    use crate::geometry::double_double::Dd;
    use crate::numbers::random::Random;

    fn cameras() -> Vec<Parameters> {
        let p = Parameters::default();
        let window = Some(ViewWindow { left: -0.3, right: 0.7, bottom: -0.2, top: 0.1 });
        let parallel = Parameters { projection: Projection::Parallel, height: 3.0, ..p };
        vec![p, Parameters { window, ..p }, parallel, Parameters { window, ..parallel }]
    }

    fn rows(m: DMat4) -> [[f64; 4]; 4] {
        m.transpose().to_cols_array_2d()
    }

    /// The entries, rounded. The remainder of an exact zero after 512 bits is zero.
    fn rounded(matrix: &Matrix<Reference>) -> [[f64; 4]; 4] {
        matrix.rounded::<f64>().0.map(|row| row.map(|x| if x.abs() < 1e-140 { 0.0 } else { x }))
    }

    /// The notes' formulas in 512 bits, rounded, are the matrices of the model.
    #[test]
    fn the_chain_in_the_reference_is_the_model() {
        for p in cameras() {
            let camera = Camera::new(&p).unwrap();
            let chain = Chain::<Reference>::new(&p);
            let (view, projection) = (chain.view_matrix(), chain.projection_matrix(Ndc::default()));
            assert_eq!(rounded(&view), rows(camera.view_from_world()));
            assert_eq!(rounded(&projection), rows(camera.clip_from_view()));
            assert_eq!(rounded(&projection.product(&view)), rows(camera.clip_from_world()));
        }
    }

    /// Each kind of number gives the chain to its own precision.
    #[test]
    fn every_kind_of_number_has_the_digits_that_it_promises() {
        fn off<R: Real>(p: &Parameters) -> f64 {
            let basis = scaled_basis::<R>(&pose(p));
            let exact = chain::basis::<Reference>(&pose(p));
            let pairs = basis.iter().zip(&exact).flat_map(|(a, b)| a.0.iter().zip(&b.0));
            pairs.map(|(a, b)| (a.to_f64() - b.to_f64()).abs()).fold(0.0, f64::max)
        }
        for p in cameras() {
            assert!(off::<f32>(&p) < 1e-6 && off::<f32>(&p) > 1e-10);
            assert!(off::<f64>(&p) < 1e-15);
            assert_eq!(off::<Dd>(&p), 0.0);
            assert_eq!(off::<Enclosure>(&p), 0.0);
        }
    }

    /// A camera of any kind: ordinary, with VUP almost along DOP, far from the origin, or of any size.
    fn random_camera(random: &mut Random, kind: usize) -> Parameters {
        let distance = random.between(0.5, 20.0);
        let far_away = if kind == 2 { 10_f64.powf(random.between(3.0, 13.0)) } else { 3.0 };
        let size = if kind == 3 { 10_f64.powf(random.between(-140.0, 140.0)) } else { 1.0 };
        let towards = random.direction();
        let focal_point = random.direction() * far_away;
        let across = random.direction();
        let angle = if kind == 1 { 10_f64.powf(random.between(-13.0, -1.0)) } else { random.between(0.1, 1.5) };
        let view_up = towards * angle.cos() + across * angle.sin();
        let near = random.between(0.01, 1.0);
        let mut side = |from: f64, to: f64| near * random.between(from, to) * size;
        let window =
            ViewWindow { left: side(-2.0, 0.5), right: side(0.6, 2.0), bottom: side(-2.0, -0.1), top: side(0.0, 2.0) };
        Parameters {
            position: (focal_point + towards * distance) * size,
            focal_point: focal_point * size,
            view_up,
            projection: if random.between(0.0, 1.0) < 0.3 { Projection::Parallel } else { Projection::Perspective },
            view_angle: random.between(0.1, 179.0),
            height: random.between(0.1, 10.0) * size,
            aspect: random.between(0.3, 3.0),
            near: near * size,
            far: near * size * 10_f64.powf(random.between(0.1, 6.0)),
            window: (random.between(0.0, 1.0) < 0.3).then_some(window),
        }
    }

    /// Every number of `inspect`.
    fn numbers<R: Real>(p: &Parameters, operations: &[Operation], ndc: Ndc, world: DVec3, pixel: [i64; 2]) -> Vec<R> {
        let image = ImageSize { width: 640, height: 480 };
        let viewport = Viewport { x: 10, depth_near: 0.25, ..Viewport::whole(image) };
        let start = Chain::<R>::new(p);
        let chain = operations.iter().fold(start, |chain, operation| chain.after(operation, Convention::Vtk));
        let point = chain.point(world, ndc, image, &viewport);
        let matrices = [
            chain.view_matrix(),
            chain.projection_matrix(ndc),
            chain.projection_matrix(ndc).product(&chain.view_matrix()),
            chain.inverse_view_matrix(),
            chain.inverse_projection_matrix(ndc),
        ];
        let vectors = chain.volume_corners().into_iter().chain(chain.ray(image, pixel)).chain(chain.basis.clone());
        let [w, h] = chain.given.window_size();
        let mut all: Vec<R> = matrices.into_iter().flat_map(|m| m.0).flatten().collect();
        all.extend(vectors.flat_map(|v| v.0));
        all.extend(chain.given.window.iter().cloned().chain([w.clone() / h.clone(), w, h, chain.distance.clone()]));
        all.extend(point.view.0.into_iter().chain(point.clip).chain(point.ndc).chain(point.window));
        all.extend(point.image.into_iter().chain(point.viewport));
        all
    }

    fn random_operation(random: &mut Random) -> Operation {
        let angle = random.between(-400.0, 400.0);
        let text = match random.whole(0, 7) {
            0 => format!("elevation={angle}"),
            1 => format!("azimuth={angle}"),
            2 => format!("roll={angle}"),
            3 => format!("yaw={angle}"),
            4 => format!("pitch={angle}"),
            5 => format!("zoom={}", random.between(0.5, 2.0)),
            6 => format!("dolly={}", random.between(0.5, 2.0)),
            _ => format!("pan={},{}", random.between(-1.0, 1.0), random.between(-1.0, 1.0)),
        };
        text.parse().unwrap()
    }

    /// `CAMERA_LAB_CASES` is the number of cameras.
    #[test]
    fn an_enclosure_holds_the_exact_number() {
        let count = std::env::var("CAMERA_LAB_CASES").ok().and_then(|text| text.parse().ok()).unwrap_or(300_usize);
        let mut random = Random::new(59, 1);
        let (mut widths, mut enclosed, mut all, mut cameras) = (Vec::new(), 0_usize, 0_usize, 0);
        while cameras < count {
            let kind = cameras % 4;
            let p = random_camera(&mut random, kind);
            if Camera::new(&p).is_err() {
                continue;
            }
            cameras += 1;
            let mut ndc = random.one_of(&Ndc::ALL);
            ndc.infinite &= p.projection == Projection::Perspective;
            let operations: Vec<Operation> = (0..cameras % 3).map(|_| random_operation(&mut random)).collect();
            let world = p.focal_point + random.direction() * (p.position - p.focal_point).length();
            let pixel = [random.whole(-100, 700), random.whole(-100, 700)];
            let proved = numbers::<Enclosure>(&p, &operations, ndc, world, pixel);
            let exact = numbers::<Reference>(&p, &operations, ndc, world, pixel);
            for (i, (proved, exact)) in proved.iter().zip(&exact).enumerate() {
                all += 1;
                let Some([low, high]) = proved.ends() else { continue };
                enclosed += 1;
                let holds = Reference::of(low) <= *exact && *exact <= Reference::of(high);
                assert!(
                    holds,
                    "number {i}: {} is not in {low:e} … {high:e} of {p:?} after {operations:?}",
                    exact.to_f64()
                );
                if kind == 0 && i % 7 == cameras % 7 && widths.len() < 1_000_000 {
                    let size = low.abs().max(high.abs());
                    widths.push(if high == low { 0.0 } else { (high - low) / (size.next_up() - size) });
                }
            }
        }
        widths.sort_by(f64::total_cmp);
        let median = widths[widths.len() / 2];
        assert!(median <= 4.0, "{median} units in the last place");
        assert!(enclosed as f64 > 0.99 * all as f64, "{enclosed} of {all}");
    }

    #[test]
    fn a_number_that_cannot_be_enclosed_has_no_ends() {
        let of = Enclosure::of;
        let third = of(1.0) / of(3.0);
        let around_zero = third * of(3.0) - of(1.0);
        let [low, high] = around_zero.ends().unwrap();
        assert!(low < 0.0 && high > 0.0 && high < 1e-30);
        assert_eq!((of(1.0) / around_zero).ends(), None);
        assert_eq!((of(1.0) / of(0.0)).ends(), None);
        assert_eq!((of(1e300) * of(1e300)).ends(), None);
        assert_eq!((-of(1.0)).sqrt().ends(), None);
        // What underflows isn't 0.
        let [low, high] = (of(3e-200) * of(-3e-200)).ends().unwrap();
        assert!(low < 0.0 && high >= 0.0);
        assert_eq!((of(3.0) / of(4.0)).ends(), Some([0.75; 2]));
        assert_eq!(of(25.0).sqrt().ends(), Some([5.0; 2]));
    }

    thread_local! {
        static CHANGE: Cell<[f64; GIVEN]> = const { Cell::new([0.0; GIVEN]) };
    }

    /// A reference with the figure's numbers changed by 2⁻²⁰⁰ times [`CHANGE`], relative to themselves.
    #[derive(Clone, Debug, PartialEq, PartialOrd)]
    struct Changed(Reference);

    impl Changed {
        fn by_share(k: usize) -> Reference {
            Reference::of(CHANGE.get()[k]) * Reference::of(2f64.powi(-200))
        }

        fn plus(self, other: Self) -> Self {
            Self(self.0 + other.0)
        }

        fn by(self, other: Self) -> Self {
            Self(self.0 * other.0)
        }

        fn over(self, other: Self) -> Self {
            Self(self.0 / other.0)
        }

        fn opposite(self) -> Self {
            Self(-self.0)
        }
    }

    camera_lab_engine::operators!([] Changed);

    impl Real for Changed {
        fn of(x: f64) -> Self {
            Self(Reference::of(x))
        }

        fn to_f64(&self) -> f64 {
            self.0.to_f64()
        }

        fn sqrt(self) -> Self {
            Self(self.0.sqrt())
        }

        fn sin_cos_degrees(degrees: f64) -> (Self, Self) {
            let (sine, cosine) = Reference::sin_cos_degrees(degrees);
            (Self(sine), Self(cosine))
        }

        fn given(x: f64, k: usize) -> Self {
            Self(Reference::of(x) * (Reference::one() + Self::by_share(k)))
        }

        /// tan(a + h) = (t + h)/(1 − t h), with tan h = h: h³ is beyond 512 bits.
        fn given_half_tangent(degrees: f64, k: usize) -> Self {
            let (sine, cosine) = Reference::sin_cos_degrees(degrees / 2.0);
            let tangent = sine / cosine;
            let h = Reference::of(degrees.to_radians() / 2.0) * Self::by_share(k);
            Self((tangent.clone() + h.clone()) / (Reference::one() - tangent * h))
        }
    }

    /// u, v, n, M_v, M_p, and the inverse of M_p M_v.
    fn questions<R: Real>(p: &Parameters) -> [Vec<R>; 4] {
        let chain = Chain::<R>::new(p);
        let inverse = chain.inverse_view_matrix().product(&chain.inverse_projection_matrix(Ndc::default()));
        let matrices = [chain.view_matrix(), chain.projection_matrix(Ndc::default()), inverse];
        let [view, projection, inverse] = matrices.map(|m| m.0.into_iter().flatten().collect());
        [chain.basis.into_iter().flat_map(|axis| axis.0).collect(), view, projection, inverse]
    }

    #[test]
    fn no_change_of_the_figure_grows_more_than_its_condition_says_and_the_worst_one_does() {
        let mut random = Random::new(59, 2);
        let norm =
            |x: &[Reference]| x.iter().map(|x| x.clone() * x.clone()).fold(Reference::zero(), |a, b| a + b).sqrt();
        let mut cameras = 0;
        while cameras < 500 {
            let p = random_camera(&mut random, cameras % 4);
            if Camera::new(&p).is_err() {
                continue;
            }
            cameras += 1;
            let conditions = questions::<Gradient>(&p).map(|result| Condition::of(&result).unwrap());
            let exact = questions::<Reference>(&p);
            let growth = |change: [f64; GIVEN], k: usize| {
                CHANGE.set(change);
                let changed = &questions::<Changed>(&p)[k];
                let off: Vec<Reference> = changed.iter().zip(&exact[k]).map(|(a, b)| a.0.clone() - b.clone()).collect();
                let length = change.into_iter().fold(0.0, f64::hypot);
                (norm(&off) / norm(&exact[k]) / Reference::of(2f64.powi(-200))).to_f64() / length
            };
            for (k, Condition { number, direction }) in conditions.into_iter().enumerate() {
                let worst = growth(direction, k);
                assert!((0.9..=1.01).contains(&(worst / number)), "{worst} against {number} in {k} of {p:?}");
                let any = growth(std::array::from_fn(|_| random.between(-1.0, 1.0)), k);
                assert!(any <= 1.01 * number, "{any} against {number} in {k} of {p:?}");
            }
        }
    }

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
