//! The words that glam lacks: angle, ray, plane, box. No camera words here.

pub mod double_double;
mod triangle_tree;

use glam::DVec3;

pub use triangle_tree::{TriangleHit, TriangleTree, ray_meets_triangle};

/// An angle. Kept in degrees, as users give it, so that 30°, 45°, 90° stay exact. Radians are an inner matter.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Angle {
    degrees: f64,
}

impl Angle {
    /// From degrees.
    pub const fn from_degrees(degrees: f64) -> Self {
        Self { degrees }
    }

    /// From radians.
    pub fn from_radians(radians: f64) -> Self {
        Self { degrees: radians.to_degrees() }
    }

    /// The angle in degrees.
    pub const fn degrees(self) -> f64 {
        self.degrees
    }

    /// The angle in radians.
    pub fn radians(self) -> f64 {
        self.degrees.to_radians()
    }

    /// Sine and cosine.
    ///
    /// *Guarantees*: both are the `f64` nearest to the true value (but for ties too close to call). The angle is
    /// reduced in degrees, exactly, so multiples of 30°, 45° and 90° give the exact values, and whole turns change no
    /// bit.
    pub fn sin_cos(self) -> (f64, f64) {
        let (sine, cosine) = double_double::sin_cos_degrees(self.degrees);
        (sine.value(), cosine.value())
    }

    /// The tangent: sine by cosine.
    pub fn tan(self) -> f64 {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }
}

impl std::ops::Neg for Angle {
    type Output = Self;

    fn neg(self) -> Self {
        Self { degrees: -self.degrees }
    }
}

/// A half-line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The point at t = 0.
    pub origin: DVec3,
    /// Unit vector.
    pub direction: DVec3,
}

/// An oriented plane: `normal · p + offset = 0`; inside is where the sum is ≥ 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Unit normal, towards the inside.
    pub normal: DVec3,
    /// Signed distance of the origin.
    pub offset: f64,
}

impl Plane {
    /// Signed distance of `point`. Positive inside.
    pub fn distance(&self, point: DVec3) -> f64 {
        self.normal.dot(point) + self.offset
    }
}

/// A box with sides parallel to the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Least corner.
    pub min: DVec3,
    /// Greatest corner.
    pub max: DVec3,
}

impl Aabb {
    /// The least box around `points`; `None` without a finite point.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Option<Self> {
        let mut all: Option<Self> = None;
        for p in points.into_iter().filter(|p| p.is_finite()) {
            all = Some(match all {
                None => Self { min: p, max: p },
                Some(b) => Self { min: b.min.min(p), max: b.max.max(p) },
            });
        }
        all
    }

    /// Half the sum of both corners.
    pub fn center(&self) -> DVec3 {
        self.min + (self.max - self.min) * 0.5
    }

    /// Half of the diagonal.
    pub fn radius(&self) -> f64 {
        ((self.max - self.min) * 0.5).length()
    }

    /// The eight corners.
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|i| {
            DVec3::new(
                if i & 1 == 0 { self.min.x } else { self.max.x },
                if i & 2 == 0 { self.min.y } else { self.max.y },
                if i & 4 == 0 { self.min.z } else { self.max.z },
            )
        })
    }

    /// The least box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }
}

/// The unit vector along `v`; `None` for a zero or a non-finite vector.
///
/// *Guarantees*: free of overflow and underflow, since `v` is first scaled by a power of two, which is exact.
pub fn try_unit(v: DVec3) -> Option<DVec3> {
    let greatest = v.abs().max_element();
    if !(greatest > 0.0 && v.is_finite()) {
        return None;
    }
    let k = -double_double::exponent(greatest);
    let near_one = DVec3::new(double_double::scale(v.x, k), double_double::scale(v.y, k), double_double::scale(v.z, k));
    Some(near_one / near_one.length())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_reduced_in_degrees() {
        for (degrees, sine, cosine) in
            [(30.0, 0.5, 0.75f64.sqrt()), (60.0, 0.75f64.sqrt(), 0.5), (90.0, 1.0, 0.0), (180.0, 0.0, -1.0)]
        {
            for turns in [-720.0, 0.0, 360.0, 36e12] {
                assert_eq!(Angle::from_degrees(degrees + turns).sin_cos(), (sine, cosine), "{degrees} + {turns}");
                assert_eq!(Angle::from_degrees(-degrees - turns).sin_cos(), (-sine, cosine));
            }
        }
        let (sine, cosine) = Angle::from_degrees(225.0).sin_cos();
        assert_eq!((sine, cosine), (-0.5f64.sqrt(), -0.5f64.sqrt()));
    }

    #[test]
    fn unit_vectors_neither_overflow_nor_underflow() {
        let expected = DVec3::new(0.6, 0.0, -0.8);
        for size in [1e-320, 1e-200, 1.0, 1e200, 1e307] {
            let unit = try_unit(DVec3::new(3.0, 0.0, -4.0) * size);
            let tolerance = if size < 1e-300 { 1e-3 } else { 1e-15 };
            assert!(unit.is_some_and(|unit| (unit - expected).length() < tolerance), "{size}: {unit:?}");
        }
        assert_eq!(try_unit(DVec3::ZERO), None);
        assert_eq!(try_unit(DVec3::new(1.0, f64::NAN, 0.0)), None);
        assert_eq!(try_unit(DVec3::new(1.0, f64::INFINITY, 0.0)), None);
    }

    #[test]
    fn a_box_holds_the_finite_points() {
        let points = [DVec3::new(1.0, 5.0, -1.0), DVec3::splat(f64::NAN), DVec3::new(-2.0, 0.0, 3.0)];
        let all = Aabb::around(points);
        assert_eq!(all, Some(Aabb { min: DVec3::new(-2.0, 0.0, -1.0), max: DVec3::new(1.0, 5.0, 3.0) }));
        assert_eq!(
            all.map(|b| (b.center(), b.corners()[7])),
            Some((DVec3::new(-0.5, 2.5, 1.0), DVec3::new(1.0, 5.0, 3.0)))
        );
        assert_eq!(Aabb::around([DVec3::splat(f64::INFINITY)]), None);
    }
}
