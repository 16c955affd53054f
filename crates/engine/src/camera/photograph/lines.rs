//! Lines of a photograph → vanishing points, f and R.

use glam::{DMat2, DMat3, DVec2, DVec3};

use super::{AxisVanishing, PhotographError, PixelFrame};

crate::listed! {
    /// An axis of the world.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum WorldAxis {
        /// x
        X = "x",
        /// y
        Y = "y",
        /// z
        Z = "z",
    }
    /// `x`, `y` or `z`.
    pub fn name
}

impl WorldAxis {
    pub(super) const fn index(self) -> usize {
        match self {
            Self::X => 0,
            Self::Y => 1,
            Self::Z => 2,
        }
    }
}

/// A line in a photograph along an axis of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhotographLine {
    /// The direction of the line in the world.
    pub axis: WorldAxis,
    /// Its ends in pixels, (0, 0) at the top left. The coordinate grows from the first to the second.
    pub ends: [DVec2; 2],
}

/// A vanishing point with its error.
#[derive(Clone, Debug)]
pub(super) struct Located {
    pub(super) axis: WorldAxis,
    /// Homogeneous, of length 1, in half diagonals.
    pub(super) point: DVec3,
    /// The error of each of its coordinates for one pixel in each end.
    error: DVec3,
    /// Degrees.
    spread: f64,
    /// In half diagonals.
    lines: Vec<[DVec2; 2]>,
}

/// A number counts as different from 0 if it's this many times its error for one pixel.
pub(super) const SURE: f64 = 2.0;
/// Marks contradict each other if they differ by this many times their error for one pixel: by two pixels for sure.
pub(super) const CONTRADICTS: f64 = 2.0 * SURE;
/// With a greater error, a vanishing point of length 1 may be anywhere on its lines: within 30°, for sure.
const UNDETERMINED: f64 = 0.5 / SURE;

impl Located {
    /// `None` if its lines are pieces of one line, to within a pixel.
    fn new(axis: WorldAxis, lines: Vec<[DVec2; 2]>, pixel: f64) -> Option<Self> {
        let point = meeting(&lines)?;
        let directions: Vec<DVec2> = lines.iter().map(|[a, b]| (*b - *a).normalize()).collect();
        let angles = directions.iter().map(|d| d.perp_dot(directions[0]).abs().asin().to_degrees());
        let located = Self { axis, point, error: DVec3::ZERO, spread: angles.fold(0.0, f64::max), lines };
        let error = DVec3::from_array(located.squares(pixel, |point| point)?.to_array().map(f64::sqrt));
        let is_sure = error.length() < UNDETERMINED && width(&located.lines) > SURE * pixel;
        is_sure.then_some(Self { error, ..located })
    }

    /// The squares of the changes that one pixel in each coordinate of each end makes in what follows from the
    /// vanishing point, summed. From derivatives, because a whole pixel may turn a short line round.
    pub(super) fn squares(&self, pixel: f64, of: impl Fn(DVec3) -> DVec3) -> Option<DVec3> {
        const PART: f64 = 1.0 / 64.0;
        let (mut squares, base) = (DVec3::ZERO, of(self.point));
        for (line, end) in (0..self.lines.len()).flat_map(|line| [(line, 0), (line, 1)]) {
            for step in [DVec2::X, DVec2::Y] {
                let mut moved = self.lines.clone();
                moved[line][end] += step * (pixel * PART);
                let other = meeting(&moved)?;
                let change = (of(if other.dot(self.point) < 0.0 { -other } else { other }) - base) / PART;
                squares += change * change;
            }
        }
        Some(squares)
    }

    pub(super) fn reported(&self, frame: &PixelFrame) -> AxisVanishing {
        let pixel = (!self.is_ideal()).then(|| frame.pixel(self.point.truncate() / self.point.z));
        AxisVanishing { axis: self.axis, pixel, spread: self.spread }
    }

    /// True if it may as well be a point at infinity.
    fn is_ideal(&self) -> bool {
        self.point.z.abs() <= SURE * self.error.z
    }

    /// True if it's so surely finite that its place has an error to first order. A nearly ideal one, as that of
    /// verticals, has not.
    pub(super) fn is_finite(&self) -> bool {
        self.point.z.abs() > 5.0 * self.error.z
    }

    /// The error of its direction in the VRC for one pixel, as a sine and to first order.
    pub(super) fn direction_error(&self, focal_length: f64) -> f64 {
        direction(self.error, focal_length).length() / direction(self.point, focal_length).length()
    }

    /// The numbers of lines drawn along [`direction`] and against it.
    pub(super) fn senses(&self, focal_length: f64) -> [usize; 2] {
        let d = direction(self.point, focal_length);
        // The image of a point that moves along d: the derivative of (5.9) and (5.10).
        let is_along = |[p, q]: &&[DVec2; 2]| (*q - *p).dot(d.truncate() * focal_length + *p * d.z) > 0.0;
        let along = self.lines.iter().filter(is_along).count();
        [along, self.lines.len() - along]
    }

    /// How far a pixel lies beside the line from another one to this vanishing point, and the error of that. In half
    /// diagonals.
    pub(super) fn beside(&self, from: DVec2, p: DVec2) -> [f64; 2] {
        let way = self.point.truncate() - from * self.point.z;
        let error = self.error.truncate().length().hypot(from.length() * self.error.z) / way.length();
        [way.normalize_or_zero().perp_dot(p - from).abs(), error * p.distance(from)]
    }
}

/// The vanishing points of the axes that have at least two lines, and the axes whose lines are pieces of one line.
pub(super) fn vanishing(
    lines: &[PhotographLine],
    frame: &PixelFrame,
) -> Result<(Vec<Located>, Vec<WorldAxis>), PhotographError> {
    if let Some(at) = lines.iter().position(|line| line.ends[0].distance(line.ends[1]) < 1e-9) {
        return Err(PhotographError::NoDirection(at + 1));
    }
    let (mut located, mut undetermined) = (Vec::new(), Vec::new());
    for axis in WorldAxis::ALL {
        let own = lines.iter().filter(|line| line.axis == axis);
        let own: Vec<[DVec2; 2]> = own.map(|line| line.ends.map(|end| frame.centred(end))).collect();
        if own.len() >= 2 {
            match Located::new(axis, own, frame.pixel_size()) {
                Some(point) => located.push(point),
                None => undetermined.push(axis),
            }
        }
    }
    match undetermined.first() {
        Some(axis) if located.len() < 2 => return Err(PhotographError::OneLine(*axis)),
        None if located.len() < 2 => return Err(PhotographError::TooFewLines),
        _ => {}
    }
    while let Some((surer, weaker)) = alike(&located) {
        // A third axis that says nothing may stay out.
        if located.len() < 3 {
            return Err(PhotographError::SameDirection(located[surer].axis, located[weaker].axis));
        }
        undetermined.push(located.remove(weaker).axis);
    }
    Ok((located, undetermined))
}

/// The greatest distance of ends of lines from the line that fits all of them, their principal axis.
fn width(lines: &[[DVec2; 2]]) -> f64 {
    let ends = || lines.iter().flatten();
    let mean = ends().sum::<DVec2>() / ends().count() as f64;
    // The double angle of the axis is that of Σ (p − mean)², as complex numbers.
    let square = |v: DVec2| DVec2::new(v.x * v.x - v.y * v.y, 2.0 * v.x * v.y);
    let axis = DVec2::from_angle(ends().map(|end| square(*end - mean)).sum::<DVec2>().to_angle() / 2.0);
    ends().map(|end| axis.perp_dot(*end - mean).abs()).fold(0.0, f64::max)
}

/// The point where lines meet, homogeneous and of length 1: the least squares solution of l · v = 0 with lines of
/// length 1, which is the eigenvector of the smallest eigenvalue of Σ l lᵀ. `None` if it isn't one point.
fn meeting(lines: &[[DVec2; 2]]) -> Option<DVec3> {
    let homogeneous = lines.iter().map(|[a, b]| a.extend(1.0).cross(b.extend(1.0)));
    let lines: Vec<DVec3> = homogeneous.map(|line| line / line.truncate().length()).collect();
    if let [a, b] = lines.as_slice() {
        return a.cross(*b).try_normalize();
    }
    let sum = lines.iter().fold(DMat3::ZERO, |sum, l| sum + DMat3::from_cols(*l * l.x, *l * l.y, *l * l.z));
    smallest_eigenvector(sum)
}

/// Inverse iteration, from the column of the inverse that's nearest to it. The shift lets a singular matrix have one.
fn smallest_eigenvector(m: DMat3) -> Option<DVec3> {
    let trace = m.col(0).x + m.col(1).y + m.col(2).z;
    let inverse = (m + DMat3::IDENTITY * (1e-15 * trace)).inverse();
    let columns = [0, 1, 2].map(|k| inverse.col(k));
    let first = columns.into_iter().max_by(|a, b| a.length().total_cmp(&b.length()))?;
    (0..50).try_fold(first.try_normalize()?, |v, _| (inverse * v).try_normalize())
}

/// Two of the vanishing points, by their places.
pub(super) type Pair = (usize, usize);

/// 1/f² in half diagonals, from all pairs of axes that agree.
pub(super) struct Focal {
    pub(super) inverse_square: f64,
    /// For one pixel in each end.
    pub(super) error: f64,
    /// Pairs that contradict surer ones.
    pub(super) left_out: Vec<Pair>,
    pairs: Vec<(Pair, f64)>,
}

impl Focal {
    /// At right angles, the directions have the product 0: q A = D with q = 1/f², A = x₁ x₂ + y₁ y₂ and D = −w₁ w₂.
    /// That's linear in q, so a pair whose points say nothing, because one is ideal or both stand across the axis,
    /// weighs next to nothing. The worst pair that contradicts the others is left out.
    pub(super) fn new(located: &[Located]) -> Self {
        let first = |b| (0..b).map(move |a| (a, b));
        let mut pairs: Vec<Pair> = (0..located.len()).flat_map(first).collect();
        let mut left_out = Vec::new();
        loop {
            let focal = Self::fitted(located, &pairs);
            let doubts = pairs.iter().map(|pair| doubt(located, *pair, focal.inverse_square));
            let worst = doubts.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
            match worst {
                Some((at, doubt)) if doubt > CONTRADICTS && pairs.len() > 1 => left_out.push(pairs.remove(at)),
                _ => return Self { left_out, ..focal },
            }
        }
    }

    /// Weighted least squares. The weights depend on q, so a few rounds.
    fn fitted(located: &[Located], pairs: &[Pair]) -> Self {
        let points: Vec<DVec3> = located.iter().map(|located| located.point).collect();
        let mut focal = Self { inverse_square: 0.0, error: f64::INFINITY, left_out: Vec::new(), pairs: Vec::new() };
        for _ in 0..10 {
            let weight = |pair: &Pair| (*pair, error(located, *pair, focal.inverse_square).powi(-2));
            focal.pairs = pairs.iter().map(weight).collect();
            (focal.inverse_square, focal.error) = focal.of(&points);
        }
        focal
    }

    /// 1/f² of other points with the same weights, and its error.
    pub(super) fn of(&self, points: &[DVec3]) -> (f64, f64) {
        let (mut top, mut bottom) = (0.0, 0.0);
        for ((a, b), weight) in &self.pairs {
            let (a, b) = (points[*a], points[*b]);
            let across = a.truncate().dot(b.truncate());
            top -= weight * across * a.z * b.z;
            bottom += weight * across * across;
        }
        if bottom > 0.0 { (top / bottom, bottom.sqrt().recip()) } else { (0.0, f64::INFINITY) }
    }

    /// The pair that says most.
    pub(super) fn surest(&self, located: &[Located]) -> Pair {
        let says = |((a, b), weight): &(Pair, f64)| {
            weight * located[*a].point.truncate().dot(located[*b].point.truncate()).powi(2)
        };
        self.pairs.iter().max_by(|a, b| says(a).total_cmp(&says(b))).map_or((0, 1), |(pair, _)| *pair)
    }
}

/// The error of the product of the directions of a pair, scaled so that 1/f² = q stands at x and y.
fn error(located: &[Located], (a, b): Pair, q: f64) -> f64 {
    let (a, b) = (&located[a], &located[b]);
    let products = [a.error * b.point, a.point * b.error, a.error * b.error];
    let squares = products.map(|product| (product * DVec3::new(q, q, 1.0)).length_squared());
    // Beyond 2⁵² pixels, a pixel changes nothing.
    squares.iter().sum::<f64>().sqrt().max(f64::EPSILON)
}

/// The product of the directions of a pair over its error.
pub(super) fn doubt(located: &[Located], pair: Pair, q: f64) -> f64 {
    let (a, b) = (located[pair.0].point, located[pair.1].point);
    (a * DVec3::new(q, q, 1.0)).dot(b).abs() / error(located, pair, q)
}

/// The direction of a vanishing point in the VRC.
pub(super) fn direction(point: DVec3, focal_length: f64) -> DVec3 {
    DVec3::new(point.x / focal_length, point.y / focal_length, -point.z)
}

/// The middle of the lens, the only point in which the axis can go through the image so that three axes are at right
/// angles: the intersection of the altitudes of the vanishing points. `None` if there is none.
pub(super) fn middle(points: &[DVec3]) -> Option<DVec2> {
    let &[a, b, c] = points else { return None };
    let [a, b, c] = [a, b, c].map(|point| point.truncate() / point.z);
    let altitudes = DMat2::from_cols(a - b, b - c).transpose();
    let middle = altitudes.inverse() * DVec2::new((a - b).dot(c), (b - c).dot(a));
    // −f²
    ((a - middle).dot(b - middle) < 0.0).then_some(middle)
}

/// Two axes whose vanishing points may be one, the surer first.
fn alike(located: &[Located]) -> Option<Pair> {
    let pairs = (0..located.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
    let of = |at: usize| (located[at].point, located[at].error.length());
    let is_alike = |(a, b): &Pair| of(*a).0.cross(of(*b).0).length() <= SURE * of(*a).1.hypot(of(*b).1);
    pairs.into_iter().find(is_alike).map(|(a, b)| if of(a).1 > of(b).1 { (b, a) } else { (a, b) })
}

/// R: the directions of axes in the VRC as columns. An axis counts by its weight. `None` if they are left-handed.
pub(super) fn rotation(directions: &[(WorldAxis, DVec3, f64)]) -> Option<DMat3> {
    let of = |axis| directions.iter().find(|of| of.0 == axis).map(|of| (of.1.normalize(), of.2));
    // The third axis follows from two, whatever its weight.
    let third = |a: (DVec3, f64), b: (DVec3, f64)| (a.0.cross(b.0).normalize(), 1.0);
    let [x, y, z] = match [WorldAxis::X, WorldAxis::Y, WorldAxis::Z].map(of) {
        [Some(x), Some(y), Some(z)] => [x, y, z],
        [Some(x), Some(y), None] => [x, y, third(x, y)],
        [Some(x), None, Some(z)] => [x, third(z, x), z],
        [None, Some(y), Some(z)] => [third(y, z), y, z],
        _ => return None,
    };
    let is_right_handed = DMat3::from_cols(x.0, y.0, z.0).determinant() > 0.0;
    is_right_handed.then(|| nearest_rotation(DMat3::from_cols(x.0 * x.1, y.0 * y.1, z.0 * z.1)))
}

/// The nearest rotation, by Higham's iteration for the polar decomposition: the mean of M and its inverse transposed.
fn nearest_rotation(m: DMat3) -> DMat3 {
    (0..40).fold(m, |m, _| (m + m.inverse().transpose()) * 0.5)
}
