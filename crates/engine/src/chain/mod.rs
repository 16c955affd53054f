//! The textbook chain, once, for every kind of number: **u** **v** **n**, M_v, the window, M_p, and every other number
//! of `inspect`, by the formulas of the notes `[0]`.
//!
//! Nothing here is careful: no compensation, and no scaling but in [`scaled_basis`]. The studies measure the value of
//! care. Care can also come from the kind of number: an [`Enclosure`] proves its digits, and a [`Gradient`] knows how a
//! change of the figure's numbers grows.

mod enclosure;
mod gradient;
pub mod real;

use glam::DVec3;

use crate::camera::{Convention, ImageSize, Ndc, Operation, Parameters, Projection, Viewport};
pub use enclosure::Enclosure;
pub use gradient::{Condition, Gradient};
use real::Real;

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

    /// The vector in the opposite direction.
    #[must_use]
    pub fn opposite(&self) -> Self {
        Self(self.0.each_ref().map(|x| -x.clone()))
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

/// The numbers that a figure gives its camera, but for VUP.
#[derive(Clone, Debug, PartialEq)]
pub struct Given<R> {
    /// The kind of projection.
    pub projection: Projection,
    /// C.
    pub position: Vector<R>,
    /// PF.
    pub focal_point: Vector<R>,
    /// F.
    pub near: R,
    /// B.
    pub far: R,
    /// l, r, b, t as given, or from `[0]` Eq. (5.5).
    pub window: [R; 4],
}

impl<R: Real> Given<R> {
    /// The numbers of a figure.
    pub fn of(p: &Parameters) -> Self {
        let [position, focal_point, _] = pose(p);
        let (near, far) = (R::given(p.near, 9), R::given(p.far, 10));
        let window = if let Some(w) = p.window {
            [R::given(w.left, 11), R::given(w.right, 12), R::given(w.bottom, 13), R::given(w.top, 14)]
        } else {
            let half = match p.projection {
                Projection::Perspective => near.clone() * R::given_half_tangent(p.view_angle, 11),
                Projection::Parallel => R::given(p.height, 11) / R::of(2.0),
            };
            let across = half.clone() * R::given(p.aspect, 12);
            [-across.clone(), across, -half.clone(), half]
        };
        Self { projection: p.projection, position, focal_point, near, far, window }
    }

    /// W and H.
    pub fn window_size(&self) -> [R; 2] {
        let [l, r, b, t] = self.window.clone();
        [r - l, t - b]
    }
}

/// C, PF and VUP of a figure.
pub fn pose<R: Real>(p: &Parameters) -> [Vector<R>; 3] {
    let vector = |v: DVec3, k: usize| Vector([R::given(v.x, k), R::given(v.y, k + 1), R::given(v.z, k + 2)]);
    [vector(p.position, 0), vector(p.focal_point, 3), vector(p.view_up, 6)]
}

/// **u**, **v**, **n** from `[0]` Eq. (5.3) as printed, for C, PF and VUP.
pub fn basis<R: Real>([position, focal_point, view_up]: &[Vector<R>; 3]) -> [Vector<R>; 3] {
    let n = position.minus(focal_point).unit();
    let u = view_up.cross(&n).unit();
    let v = n.cross(&u);
    [u, v, n]
}

/// A vector over its greatest component, and that.
fn scaled<R: Real>(v: &Vector<R>) -> (Vector<R>, R) {
    let greatest = R::of(v.to_f64().abs().max_element());
    (v.times(&(R::one() / greatest.clone())), greatest)
}

/// The numbers of [`basis`], computed with more care, because vectors are scaled before they're normalised.
pub fn scaled_basis<R: Real>([position, focal_point, view_up]: &[Vector<R>; 3]) -> [Vector<R>; 3] {
    let n = scaled(&position.minus(focal_point)).0.unit();
    let u = scaled(&scaled(view_up).0.cross(&n)).0.unit();
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
pub fn view_matrix<R: Real>(basis: &[Vector<R>; 3], position: &Vector<R>) -> Matrix<R> {
    let row = |axis: &Vector<R>| {
        let [x, y, z] = axis.0.clone();
        [x, y, z, -axis.dot(position)]
    };
    let [u, v, n] = basis;
    Matrix([row(u), row(v), row(n), [R::zero(), R::zero(), R::zero(), R::one()]])
}

/// M_p, `[0]` Eqs. (5.13) and (5.15), with the last row (0 0 −1 0) in perspective; its third row for the z_n that a
/// convention of NDC has at F and at B, z₀ and z₁.
pub fn projection_matrix<R: Real>(given: &Given<R>, ndc: Ndc) -> Matrix<R> {
    let ([l, r, b, t], [w, h]) = (given.window.clone(), given.window_size());
    let (near, far) = (given.near.clone(), given.far.clone());
    let [z0, z1] = ndc.depths().map(R::of);
    let (range, depth) = (z0.clone() - z1.clone(), far.clone() - near.clone());
    let (two, zero, one) = (R::of(2.0), R::zero(), R::one());
    let down = R::of(if ndc.y_points_down() { -1.0 } else { 1.0 });
    let (across, up) = ((r + l) / w.clone(), down.clone() * ((t + b) / h.clone()));
    let z = || zero.clone();
    match given.projection {
        Projection::Perspective => {
            let [by_z, by_w] = if ndc.infinite {
                [-z1, range * near.clone()]
            } else {
                let nearer = z0 * near.clone() - z1 * far.clone();
                [nearer / depth.clone(), range * near.clone() * (far / depth)]
            };
            Matrix([
                [two.clone() * near.clone() / w, z(), across, z()],
                [z(), down * (two * near / h), up, z()],
                [z(), z(), by_z, by_w],
                [z(), z(), -one, z()],
            ])
        }
        Projection::Parallel => Matrix([
            [two.clone() / w, z(), z(), -across],
            [z(), down * (two / h), z(), -up],
            [z(), z(), range / depth.clone(), (z0 * far - z1 * near) / depth],
            [z(), z(), z(), one],
        ]),
    }
}

/// Every number of `inspect` in one kind of number.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain<R> {
    /// The figure's numbers, after the operations.
    pub given: Given<R>,
    /// **u**, **v**, **n**.
    pub basis: [Vector<R>; 3],
    /// D.
    pub distance: R,
}

/// A point in the spaces of `inspect`.
#[derive(Clone, Debug, PartialEq)]
pub struct PointChain<R> {
    /// VRC.
    pub view: Vector<R>,
    /// Clip coordinates.
    pub clip: [R; 4],
    /// NDC.
    pub ndc: [R; 3],
    /// (x_p, y_p).
    pub window: [R; 2],
    /// (5.22) before it takes the floor.
    pub image: [R; 2],
    /// (5.24) before it takes the floor, and (5.25).
    pub viewport: [R; 3],
}

impl<R: Real> Chain<R> {
    /// The chain of a figure's camera.
    pub fn new(p: &Parameters) -> Self {
        let given = Given::of(p);
        let (to_viewer, greatest) = scaled(&given.position.minus(&given.focal_point));
        Self { basis: scaled_basis(&pose(p)), distance: to_viewer.length() * greatest, given }
    }

    /// The chain after an operation of `[0]` §5.6. The VRC turns as a rigid body.
    #[must_use]
    pub fn after(mut self, operation: &Operation, convention: Convention) -> Self {
        let degrees = operation.right_hand_angle(convention).unwrap_or_default().degrees();
        let (sine, cosine) = R::sin_cos_degrees(degrees);
        match *operation {
            Operation::Elevation(_) | Operation::Pitch(_) => self.turn(0, &sine, &cosine),
            Operation::Azimuth(_) | Operation::Yaw(_) => self.turn(1, &sine, &cosine),
            Operation::Roll(_) => self.turn(2, &sine, &cosine),
            Operation::Zoom(factor) => self.given.window = self.given.window.map(|side| side / R::of(factor)),
            Operation::Dolly(factor) => self.distance = self.distance / R::of(factor),
            Operation::Pan { dx, dy } => {
                let step = self.direction_in_world(&Vector::of(DVec3::new(dx, dy, 0.0)));
                self.given.position = self.given.position.plus(&step);
                self.given.focal_point = self.given.focal_point.plus(&step);
            }
        }
        let to_viewer = self.basis[2].times(&self.distance);
        match operation {
            Operation::Elevation(_) | Operation::Azimuth(_) | Operation::Dolly(_) => {
                self.given.position = self.given.focal_point.plus(&to_viewer);
            }
            Operation::Yaw(_) | Operation::Pitch(_) => {
                self.given.focal_point = self.given.position.minus(&to_viewer);
            }
            Operation::Roll(_) | Operation::Zoom(_) | Operation::Pan { .. } => {}
        }
        self
    }

    /// With two axes a, b and a × b = the third, about which the VRC turns, a turns towards b, and b towards −a.
    fn turn(&mut self, axis: usize, sine: &R, cosine: &R) {
        let [a, b] = [1, 2].map(|next| (axis + next) % 3);
        let ahead = self.basis[a].times(cosine).plus(&self.basis[b].times(sine));
        self.basis[b] = self.basis[b].times(cosine).minus(&self.basis[a].times(sine));
        self.basis[a] = ahead;
    }

    /// M_v.
    pub fn view_matrix(&self) -> Matrix<R> {
        view_matrix(&self.basis, &self.given.position)
    }

    /// M_p in a convention of NDC.
    pub fn projection_matrix(&self, ndc: Ndc) -> Matrix<R> {
        projection_matrix(&self.given, ndc)
    }

    /// The inverse of M_v: its columns are **u**, **v**, **n** and C.
    pub fn inverse_view_matrix(&self) -> Matrix<R> {
        let ([u, v, n], c) = (&self.basis, &self.given.position);
        let row = |i: usize| [u, v, n, c].map(|column| column.0[i].clone());
        Matrix([row(0), row(1), row(2), [R::zero(), R::zero(), R::zero(), R::one()]])
    }

    /// The inverse of M_p, in closed form.
    pub fn inverse_projection_matrix(&self, ndc: Ndc) -> Matrix<R> {
        let [[x, _, skew_x, at_x], [_, y, skew_y, at_y], [_, _, z, depth], _] = self.projection_matrix(ndc).0;
        let (zero, one) = (R::zero, R::one);
        match self.given.projection {
            Projection::Perspective => Matrix([
                [one() / x.clone(), zero(), zero(), skew_x / x],
                [zero(), one() / y.clone(), zero(), skew_y / y],
                [zero(), zero(), zero(), -one()],
                [zero(), zero(), one() / depth.clone(), z / depth],
            ]),
            Projection::Parallel => Matrix([
                [one() / x.clone(), zero(), zero(), -at_x / x],
                [zero(), one() / y.clone(), zero(), -at_y / y],
                [zero(), zero(), one() / z.clone(), -depth / z],
                [zero(), zero(), zero(), one()],
            ]),
        }
    }

    /// A point of the VRC in the world.
    fn world_of_view(&self, p: &Vector<R>) -> Vector<R> {
        self.given.position.plus(&self.direction_in_world(p))
    }

    fn direction_in_world(&self, d: &Vector<R>) -> Vector<R> {
        let [u, v, n] = &self.basis;
        u.times(&d.0[0]).plus(&v.times(&d.0[1])).plus(&n.times(&d.0[2]))
    }

    /// Eight world points: near (l,b) (r,b) (r,t) (l,t), then far in the same order.
    pub fn volume_corners(&self) -> [Vector<R>; 8] {
        let Given { projection, near, far, window: [l, r, b, t], .. } = &self.given;
        let spread = if projection.is_perspective() { far.clone() / near.clone() } else { R::one() };
        std::array::from_fn(|i| {
            let (x, y) = [(l, b), (r, b), (r, t), (l, t)][i % 4];
            let (s, depth) = if i < 4 { (R::one(), near) } else { (spread.clone(), far) };
            self.world_of_view(&Vector([x.clone() * s.clone(), y.clone() * s, -depth.clone()]))
        })
    }

    /// A world point in every space.
    pub fn point(&self, p_world: DVec3, ndc: Ndc, image: ImageSize, viewport: &Viewport) -> PointChain<R> {
        let d = Vector::of(p_world).minus(&self.given.position);
        let view = Vector(std::array::from_fn(|i| self.basis[i].dot(&d)));
        let [x, y, z] = view.0.clone();
        let in_space = |ndc: Ndc| {
            let clip = self.projection_matrix(ndc).transform(&[x.clone(), y.clone(), z.clone(), R::one()]);
            (std::array::from_fn(|i| clip[i].clone() / clip[3].clone()), clip)
        };
        let ((ndc, clip), ([x_n, y_n, z_n], _)) = (in_space(ndc), in_space(Ndc::default()));
        let window = match self.given.projection {
            Projection::Perspective => [x, y].map(|x| self.given.near.clone() * (x / -z.clone())),
            Projection::Parallel => [x, y],
        };
        let ([l, _, _, t], [w, h], [x_p, y_p]) = (self.given.window.clone(), self.given.window_size(), window.clone());
        let image = [R::of(image.width.into()) * ((x_p - l) / w), R::of(image.height.into()) * ((t - y_p) / h)];
        let half = |x: R| x / R::of(2.0);
        let along = |start: i32, size: u32, x: R| R::of(size.into()) * half(x + R::one()) + R::of(start.into());
        let (n, f) = (R::of(viewport.depth_near), R::of(viewport.depth_far));
        let depth = half(f.clone() - n.clone()) * z_n + half(f + n);
        let viewport = [along(viewport.x, viewport.width, x_n), along(viewport.y, viewport.height, y_n), depth];
        PointChain { view, clip, ndc, window, image, viewport }
    }

    /// Origin and direction of the ray through the centre of the pixel (i, j): (5.23), then (5.17) to (5.21).
    pub fn ray(&self, image: ImageSize, pixel: [i64; 2]) -> [Vector<R>; 2] {
        let ([l, _, _, t], [w, h]) = (self.given.window.clone(), self.given.window_size());
        let [i, j] = pixel.map(|whole| {
            let low = whole.rem_euclid(1 << 32);
            R::of((whole - low) as f64) + R::of(low as f64) + R::of(0.5)
        });
        let (x, y) = (l + w * (i / R::of(image.width.into())), t - h * (j / R::of(image.height.into())));
        match self.given.projection {
            Projection::Perspective => {
                let p = scaled(&Vector([x, y, -self.given.near.clone()])).0.unit();
                [self.given.position.clone(), self.direction_in_world(&p)]
            }
            Projection::Parallel => [self.world_of_view(&Vector([x, y, R::zero()])), self.basis[2].opposite()],
        }
    }
}
