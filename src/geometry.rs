//! The words that glam lacks: angle, ray, plane, box. No camera words here.

pub(crate) mod double_double;

use glam::DVec3;

/// An angle. Kept in degrees, as users give it, so that 30°, 45°, 90° stay exact; radians are an inner matter.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Angle {
    degrees: f64,
}

impl Angle {
    /// From degrees.
    #[must_use]
    pub const fn from_degrees(degrees: f64) -> Self {
        Self { degrees }
    }

    /// From radians.
    #[must_use]
    pub fn from_radians(radians: f64) -> Self {
        Self { degrees: radians.to_degrees() }
    }

    /// In degrees.
    #[must_use]
    pub const fn degrees(self) -> f64 {
        self.degrees
    }

    /// In radians.
    #[must_use]
    pub fn radians(self) -> f64 {
        self.degrees.to_radians()
    }

    /// Sine and cosine.
    ///
    /// *Guarantees*: both are the `f64` nearest to the true value (but for ties too close to call). The angle is reduced
    /// in degrees, exactly: multiples of 30°, 45° and 90° give what they should, and whole turns change no bit.
    #[must_use]
    pub fn sin_cos(self) -> (f64, f64) {
        let (sine, cosine) = double_double::sin_cos_degrees(self.degrees);
        (sine.value(), cosine.value())
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
    /// Where it starts.
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
    /// Signed distance of `point`; positive inside.
    #[must_use]
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

    /// The middle.
    #[must_use]
    pub fn center(&self) -> DVec3 {
        self.min + (self.max - self.min) * 0.5
    }

    /// Half of the diagonal.
    #[must_use]
    pub fn radius(&self) -> f64 {
        ((self.max - self.min) * 0.5).length()
    }

    /// The eight corners.
    #[must_use]
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
#[must_use]
pub fn try_unit(v: DVec3) -> Option<DVec3> {
    let greatest = v.abs().max_element();
    if !(greatest > 0.0 && v.is_finite()) {
        return None;
    }
    let k = -double_double::exponent(greatest);
    let near_one = DVec3::new(double_double::scale(v.x, k), double_double::scale(v.y, k), double_double::scale(v.z, k));
    Some(near_one / near_one.length())
}
