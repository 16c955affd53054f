//! Lines of a photograph → vanishing points, f and R.

use glam::{DMat3, DVec2, DVec3};

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
#[derive(Clone, Copy, Debug)]
pub(super) struct Located {
    pub(super) axis: WorldAxis,
    /// Homogeneous, of length 1, in half diagonals.
    pub(super) point: DVec3,
    /// The error of each of its coordinates for one pixel in each end.
    pub(super) error: DVec3,
    /// Degrees.
    spread: f64,
}

impl Located {
    pub(super) fn reported(&self, frame: &PixelFrame) -> AxisVanishing {
        let pixel = (!self.is_ideal()).then(|| frame.pixel(self.point.truncate() / self.point.z));
        AxisVanishing { axis: self.axis, pixel, spread: self.spread }
    }

    /// True if it may as well be a point at infinity.
    fn is_ideal(&self) -> bool {
        self.point.z.abs() <= SURE * self.error.z
    }
}

/// A number counts as different from 0 if it's this many times its error for one pixel.
pub(super) const SURE: f64 = 2.0;

/// The vanishing points of the axes that have at least two lines. `pixel` is the size of a pixel.
pub(super) fn vanishing(
    lines: &[PhotographLine],
    centred: impl Fn(DVec2) -> DVec2,
    pixel: f64,
) -> Result<Vec<Located>, PhotographError> {
    if let Some(at) = lines.iter().position(|line| line.ends[0].distance(line.ends[1]) < 1e-9) {
        return Err(PhotographError::NoDirection(at + 1));
    }
    let mut located = Vec::new();
    for axis in WorldAxis::ALL {
        let own: Vec<[DVec2; 2]> =
            lines.iter().filter(|line| line.axis == axis).map(|line| line.ends.map(&centred)).collect();
        if own.len() >= 2 {
            located.push(located_of(axis, &own, pixel)?);
        }
    }
    if located.len() < 2 { Err(PhotographError::TooFewLines) } else { Ok(located) }
}

fn located_of(axis: WorldAxis, lines: &[[DVec2; 2]], pixel: f64) -> Result<Located, PhotographError> {
    let point = meeting(lines).ok_or(PhotographError::OneLine(axis))?;
    let mut squares = DVec3::ZERO;
    for line in 0..lines.len() {
        for end in 0..2 {
            for step in [DVec2::X, DVec2::Y] {
                let mut moved = lines.to_vec();
                moved[line][end] += step * pixel;
                let other = meeting(&moved).ok_or(PhotographError::OneLine(axis))?;
                let other = if other.dot(point) < 0.0 { -other } else { other };
                squares += (other - point) * (other - point);
            }
        }
    }
    let directions: Vec<DVec2> = lines.iter().map(|[a, b]| (*b - *a).normalize()).collect();
    let first = directions[0];
    let spread = directions.iter().map(|d| d.perp_dot(first).abs().asin().to_degrees()).fold(0.0, f64::max);
    let error = DVec3::from_array(squares.to_array().map(f64::sqrt));
    Ok(Located { axis, point, error, spread })
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

/// Jacobi's method, rotations that make the entries beside the diagonal 0, one after the other.
fn smallest_eigenvector(m: DMat3) -> Option<DVec3> {
    const SWEEPS: usize = 12;
    let (mut m, mut vectors) = (m, DMat3::IDENTITY);
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let off = m.col(q)[p];
            if off == 0.0 {
                continue;
            }
            let theta = 0.5 * (2.0 * off).atan2(m.col(q)[q] - m.col(p)[p]);
            let (sin, cos) = theta.sin_cos();
            let mut turn = DMat3::IDENTITY;
            turn.col_mut(p)[p] = cos;
            turn.col_mut(q)[q] = cos;
            turn.col_mut(q)[p] = sin;
            turn.col_mut(p)[q] = -sin;
            m = turn.transpose() * m * turn;
            vectors *= turn;
        }
    }
    let values = [m.col(0)[0], m.col(1)[1], m.col(2)[2]];
    let least = (0..3).min_by(|a, b| values[*a].total_cmp(&values[*b]))?;
    vectors.col(least).try_normalize()
}

/// f in half diagonals from all pairs of axes, each weighted by how sure it is. `None` if no pair tells it.
pub(super) fn focal_length(located: &[Located]) -> Result<Option<f64>, PhotographError> {
    let (mut sum, mut weights) = (0.0, 0.0);
    for (i, a) in located.iter().enumerate() {
        for b in &located[i + 1..] {
            let across = a.point.truncate().dot(b.point.truncate());
            // 1/f² = −w₁ w₂ / (x₁ x₂ + y₁ y₂), and its error to first order.
            let depths = -a.point.z * b.point.z;
            let error = (a.error.z * b.point.z).hypot(b.error.z * a.point.z);
            let error_across = (a.error.truncate() * b.point.truncate())
                .length()
                .hypot((b.error.truncate() * a.point.truncate()).length());
            // A pair says nothing if one point is ideal or both stand across the axis.
            if depths.abs() <= SURE * error || across.abs() <= SURE * error_across {
                continue;
            }
            let inverse = depths / across;
            if inverse < 0.0 {
                return Err(PhotographError::NotAtRightAngles(a.axis, b.axis));
            }
            let relative = (error / depths).hypot(error_across / across);
            let weight = (relative * inverse).powi(-2).min(f64::MAX / 16.0);
            sum += weight * inverse;
            weights += weight;
        }
    }
    Ok((weights > 0.0).then(|| (sum / weights).sqrt().recip()))
}

/// The direction of a vanishing point in the VRC.
fn direction(point: DVec3, focal_length: f64) -> DVec3 {
    DVec3::new(point.x / focal_length, point.y / focal_length, -point.z)
}

/// Refuses axes whose directions may be one.
pub(super) fn differ(located: &[Located], focal_length: f64, sure: f64) -> Result<(), PhotographError> {
    for (i, a) in located.iter().enumerate() {
        for b in &located[i + 1..] {
            let [d, e] = [a, b].map(|of| direction(of.point, focal_length));
            let sine = d.cross(e).length() / (d.length() * e.length());
            // To first order.
            let [of_d, of_e] = [(a, d), (b, e)].map(|(of, d)| direction(of.error, focal_length).length() / d.length());
            let is_sure = sine > sure * of_d.hypot(of_e);
            if !is_sure {
                return Err(PhotographError::SameDirection(a.axis, b.axis));
            }
        }
    }
    Ok(())
}

/// R: the directions of the axes in the VRC as columns, in the sense of their lines.
pub(super) fn rotation(
    located: &[Located],
    lines: &[PhotographLine],
    focal_length: f64,
    centred: impl Fn(DVec2) -> DVec2,
) -> Result<DMat3, PhotographError> {
    let mut axes: [Option<DVec3>; 3] = [None; 3];
    for Located { axis, point, .. } in located {
        let d = direction(*point, focal_length).normalize();
        let along = |line: &PhotographLine| {
            let [p, q] = line.ends.map(&centred);
            // The image of a point that moves along d: the derivative of (5.9) and (5.10).
            let motion = d.truncate() * focal_length + p * d.z;
            (q - p).dot(motion).signum()
        };
        let sense: f64 = lines.iter().filter(|line| line.axis == *axis).map(along).sum();
        axes[axis.index()] = Some(if sense < 0.0 { -d } else { d });
    }
    let [x, y, z] = axes;
    let m = match (x, y, z) {
        (Some(x), Some(y), Some(z)) => DMat3::from_cols(x, y, z),
        (Some(x), Some(y), None) => DMat3::from_cols(x, y, x.cross(y).normalize()),
        (Some(x), None, Some(z)) => DMat3::from_cols(x, z.cross(x).normalize(), z),
        (None, Some(y), Some(z)) => DMat3::from_cols(y.cross(z).normalize(), y, z),
        _ => return Err(PhotographError::TooFewLines),
    };
    if m.determinant() <= 0.0 {
        return Err(PhotographError::LeftHanded);
    }
    Ok(nearest_rotation(m))
}

/// The nearest rotation, by Higham's iteration for the polar decomposition: the mean of M and its inverse transposed.
fn nearest_rotation(m: DMat3) -> DMat3 {
    (0..30).fold(m, |m, _| (m + m.inverse().transpose()) * 0.5)
}
