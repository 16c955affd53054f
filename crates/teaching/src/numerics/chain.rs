//! The textbook chain, once, for every kind of number: **u** **v** **n**, M_v, the window, M_p as printed in the notes
//! `[0]`.
//!
//! Nothing here is careful: no scaling, no compensation. The studies measure the value of care.

use glam::DVec3;

use super::real::Real;
use crate::camera::{Parameters, Projection};

/// A vector of three numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Vector<R>(pub [R; 3]);

impl<R: Real> Vector<R> {
    /// Rounds `f64`s.
    pub fn of(v: DVec3) -> Self {
        Self(v.to_array().map(R::of))
    }

    /// The nearest `f64`s.
    pub fn to_f64(&self) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|i| self.0[i].to_f64()))
    }

    /// The sum of the products.
    pub fn dot(&self, other: &Self) -> R {
        let product = |i: usize| self.0[i].clone() * other.0[i].clone();
        product(0) + product(1) + product(2)
    }

    /// The vector product.
    pub fn cross(&self, other: &Self) -> Self {
        let component =
            |i: usize, j: usize| self.0[i].clone() * other.0[j].clone() - self.0[j].clone() * other.0[i].clone();
        Self([component(1, 2), component(2, 0), component(0, 1)])
    }

    /// Componentwise, rounded in `R`.
    pub fn minus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].clone() - other.0[i].clone()))
    }

    /// Componentwise, rounded in `R`.
    pub fn plus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i].clone() + other.0[i].clone()))
    }

    /// `factor` times the vector.
    pub fn times(&self, factor: &R) -> Self {
        Self(std::array::from_fn(|i| self.0[i].clone() * factor.clone()))
    }

    /// The square root of the scalar product with itself.
    pub fn length(&self) -> R {
        self.dot(self).sqrt()
    }

    /// The vector over its length.
    pub fn unit(&self) -> Self {
        let length = self.length();
        Self(std::array::from_fn(|i| self.0[i].clone() / length.clone()))
    }
}

/// **u**, **v**, **n** from `[0]` Eq. (5.3) as printed.
pub fn basis<R: Real>(position: DVec3, focal_point: DVec3, view_up: DVec3) -> [Vector<R>; 3] {
    let n = Vector::<R>::of(position).minus(&Vector::of(focal_point)).unit();
    let u = Vector::of(view_up).cross(&n).unit();
    let v = n.cross(&u);
    [u, v, n]
}

/// The numbers of [`basis`], computed with more care, because vectors are scaled before they're normalised.
pub fn scaled_basis<R: Real>(position: DVec3, focal_point: DVec3, view_up: DVec3) -> [Vector<R>; 3] {
    let scaled = |v: Vector<R>| {
        let greatest = v.to_f64().abs().max_element();
        v.times(&(R::one() / R::of(greatest)))
    };
    let n = scaled(Vector::<R>::of(position).minus(&Vector::of(focal_point))).unit();
    let u = scaled(scaled(Vector::of(view_up)).cross(&n)).unit();
    let v = n.cross(&u);
    [u, v, n]
}

/// A 4 × 4 matrix, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix<R>(pub [[R; 4]; 4]);

impl<R: Real> Matrix<R> {
    /// The product of row `i` and a column.
    fn row(&self, i: usize, p: &[R; 4]) -> R {
        let product = |k: usize| self.0[i][k].clone() * p[k].clone();
        product(0) + product(1) + product(2) + product(3)
    }

    /// Matrix times column.
    pub fn transform(&self, p: &[R; 4]) -> [R; 4] {
        std::array::from_fn(|i| self.row(i, p))
    }

    /// Matrix times matrix.
    pub fn product(&self, other: &Self) -> Self {
        let column = |j: usize| -> [R; 4] { std::array::from_fn(|k| other.0[k][j].clone()) };
        Self(std::array::from_fn(|i| std::array::from_fn(|j| self.row(i, &column(j)))))
    }

    /// The same matrix in another kind of number, by way of `f64`.
    pub fn rounded<S: Real>(&self) -> Matrix<S> {
        Matrix(std::array::from_fn(|i| std::array::from_fn(|j| S::of(self.0[i][j].to_f64()))))
    }
}

/// M_v, `[0]` Eq. (5.7), with the basis in its rows and −u·C, −v·C, −n·C in its last column.
pub fn view_matrix<R: Real>(basis: &[Vector<R>; 3], position: DVec3) -> Matrix<R> {
    let c = Vector::of(position);
    let row = |axis: &Vector<R>| {
        let [x, y, z] = axis.0.clone();
        [x, y, z, -axis.dot(&c)]
    };
    let [u, v, n] = basis;
    Matrix([row(u), row(v), row(n), [R::zero(), R::zero(), R::zero(), R::one()]])
}

/// l, r, b, t as given, or from `[0]` Eq. (5.5).
pub fn window<R: Real>(p: &Parameters) -> [R; 4] {
    if let Some(w) = p.window {
        return [w.left, w.right, w.bottom, w.top].map(R::of);
    }
    let half = match p.projection {
        Projection::Perspective => {
            let (sine, cosine) = R::sin_cos_degrees(p.view_angle / 2.0);
            R::of(p.near) * (sine / cosine)
        }
        Projection::Parallel => R::of(p.height) / R::of(2.0),
    };
    let across = half.clone() * R::of(p.aspect);
    [-across.clone(), across, -half.clone(), half]
}

/// M_p, `[0]` Eqs. (5.13) and (5.15), with the last row (0 0 −1 0) in perspective.
pub fn projection_matrix<R: Real>(p: &Parameters) -> Matrix<R> {
    let [l, r, b, t] = window::<R>(p);
    let (near, far) = (R::of(p.near), R::of(p.far));
    let (two, zero, one) = (R::of(2.0), R::zero(), R::one());
    let (w, h, depth) = (r.clone() - l.clone(), t.clone() - b.clone(), far.clone() - near.clone());
    let (across, up) = ((r + l) / w.clone(), (t + b) / h.clone());
    let sum = (far.clone() + near.clone()) / depth.clone();
    let z = || zero.clone();
    match p.projection {
        Projection::Perspective => Matrix([
            [two.clone() * near.clone() / w, z(), across, z()],
            [z(), two.clone() * near.clone() / h, up, z()],
            [z(), z(), -sum, -(two * far * near) / depth],
            [z(), z(), -one, z()],
        ]),
        Projection::Parallel => Matrix([
            [two.clone() / w, z(), z(), -across],
            [z(), two.clone() / h, z(), -up],
            [z(), z(), -(two / depth), -sum],
            [z(), z(), z(), one],
        ]),
    }
}

#[cfg(test)]
mod tests {
    use glam::DMat4;

    use super::*;
    use crate::camera::{Camera, ViewWindow};
    use crate::geometry::double_double::Dd;
    use crate::numerics::reference::Reference;

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
            let camera = Camera::new(&p).expect("a camera");
            let basis = basis::<Reference>(p.position, p.focal_point, p.view_up);
            let view = view_matrix(&basis, p.position);
            assert_eq!(rounded(&view), rows(camera.view_from_world()));
            let projection = projection_matrix::<Reference>(&p);
            assert_eq!(rounded(&projection), rows(camera.clip_from_view()));
            assert_eq!(rounded(&projection.product(&view)), rows(camera.clip_from_world()));
        }
    }

    /// Each kind of number gives the chain to its own precision.
    #[test]
    fn every_kind_of_number_has_the_digits_that_it_promises() {
        fn off<R: Real>(p: &Parameters) -> f64 {
            let basis = scaled_basis::<R>(p.position, p.focal_point, p.view_up);
            let exact = super::basis::<Reference>(p.position, p.focal_point, p.view_up);
            let pairs = basis.iter().zip(&exact).flat_map(|(a, b)| a.0.iter().zip(&b.0));
            pairs.map(|(a, b)| (a.to_f64() - b.to_f64()).abs()).fold(0.0, f64::max)
        }
        for p in cameras() {
            assert!(off::<f32>(&p) < 1e-6 && off::<f32>(&p) > 1e-10);
            assert!(off::<f64>(&p) < 1e-15);
            assert_eq!(off::<Dd>(&p), 0.0);
        }
    }
}
