//! The formats of depth buffers: the value that each stores for a depth in a convention of NDC, and so the surfaces
//! that it distinguishes.

use crate::appearance::VertexFormat;
use crate::camera::{Api, ClipSpace, Ndc, Projection};
use crate::drawing::single;
use crate::numerics::OWN;
use crate::pipeline::depths::DepthScale;

/// F = 1, B, the kind of projection, and the convention of NDC.
pub(in crate::numerics) struct Range {
    pub(in crate::numerics) projection: Projection,
    pub(in crate::numerics) far: f64,
    ndc: Ndc,
}

impl Range {
    /// The range in a convention that has z_n from 0 at F to 1 at B.
    pub(in crate::numerics) fn from_0_to_1(projection: Projection, far: f64) -> Self {
        Self { projection, far, ndc: Ndc { api: Api::Direct3d, ..Ndc::default() } }
    }

    /// The range of a clip space, with F as the unit.
    fn of(space: &ClipSpace<'_>) -> Self {
        let camera = space.camera();
        Self { projection: camera.projection(), far: camera.far() / camera.near(), ndc: space.ndc() }
    }

    /// The range of a clip space, the unit of its depths, and a depth in it. In parallel projection F may be 0 or less,
    /// so it can't be a unit. Only differences count there, so the volume is moved to 1 … 2.
    fn with_unit(space: &ClipSpace<'_>, depth: f64) -> (Self, f64, f64) {
        let camera = space.camera();
        let (near, far) = (camera.near(), camera.far());
        if near > 0.0 {
            return (Self::of(space), near, depth / near);
        }
        let unit = far - near;
        (Self { projection: camera.projection(), far: 2.0, ndc: space.ndc() }, unit, (depth - near) / unit + 1.0)
    }

    /// The value of a depth, 0 … 1, before the conversion to a format. If `reversed`, it's 1 at F and 0 at B. The
    /// transformation is done in single precision, as graphics cards do it, with z_n = (z_c entries of M_p) / w, and
    /// (z_n + 1)/2 if z_n goes from −1 to 1.
    fn stored(&self, z: f64, reversed: bool) -> f32 {
        #[expect(clippy::cast_possible_truncation, reason = "single precision is what is studied")]
        let (depth, far) = (z as f32, if self.ndc.infinite { f32::INFINITY } else { self.far as f32 });
        let span = far - 1.0;
        // B/(B − F), which is 1 if there's no far plane.
        let ratio = if far.is_finite() { far / span } else { 1.0 };
        let perspective = self.projection == Projection::Perspective;
        match (perspective, reversed, self.ndc.depths()) {
            (true, true, _) => (ratio - depth / span) / depth,
            (false, true, _) => (far - depth) / span,
            (true, false, [-1.0, _]) => 0.5 * (((2.0 * ratio - 1.0) * depth - 2.0 * ratio) / depth) + 0.5,
            (false, false, [-1.0, _]) => 0.5 * ((2.0 * depth - (far + 1.0)) / span) + 0.5,
            (true, false, _) => (ratio * depth - ratio) / depth,
            (false, false, _) => (depth - 1.0) / span,
        }
    }

    /// The growth of depth with the stored value, and the stored value at a depth, which is 1 at F and 0 at B.
    fn slope_and_reversed(&self, z: f64) -> (f64, f64) {
        let (far, span) = (self.far, self.far - 1.0);
        match self.projection {
            Projection::Perspective if self.ndc.infinite => (z * z, 1.0 / z),
            Projection::Perspective => (z * z * span / far, (far - z) / (z * span)),
            Projection::Parallel => (span, (far - z) / span),
        }
    }
}

#[derive(Clone, Copy, PartialEq)]
pub(in crate::numerics) enum Format {
    Fixed16,
    Fixed24,
    Float,
    FloatReversed,
    Logarithmic,
    /// Reversed, in the format of vertices.
    Narrow(VertexFormat),
    Own,
}

const FORMATS: [Format; 6] =
    [Format::Fixed16, Format::Fixed24, Format::Float, Format::FloatReversed, Format::Logarithmic, Format::Own];

/// Reversed depth as a number that grows with the depth.
pub(in crate::numerics) fn order(reversed: f32) -> i64 {
    -i64::from(reversed.to_bits())
}

impl Format {
    pub(in crate::numerics) const fn name(self) -> &'static str {
        match self {
            Self::Fixed16 => "fixed 16",
            Self::Fixed24 => "fixed 24",
            Self::Float => "f32",
            Self::FloatReversed => "f32 reversed",
            Self::Logarithmic => "logarithmic 24",
            Self::Narrow(VertexFormat::F16) => "f16 reversed",
            Self::Narrow(VertexFormat::Bf16) => "bf16 reversed",
            Self::Narrow(_) => "fixed-16.16 reversed",
            Self::Own => OWN,
        }
    }

    /// The stored value of a depth, as a whole number that grows with the depth.
    pub(in crate::numerics) fn value(self, range: &Range, z: f64) -> i64 {
        let reversed = range.ndc.reversed;
        let normal = || range.stored(z, reversed);
        let growing = |x: i64| if reversed { -x } else { x };
        #[expect(clippy::cast_possible_truncation, reason = "between 0 and 2^24")]
        let fixed = |x: f32, bits: i32| (f64::from(x) * (2f64.powi(bits) - 1.0)).round() as i64;
        match self {
            Self::Fixed16 => growing(fixed(normal(), 16)),
            Self::Fixed24 => growing(fixed(normal(), 24)),
            Self::Float => growing(i64::from(normal().max(0.0).to_bits())),
            Self::FloatReversed | Self::Own => order(range.stored(z, true).max(0.0)),
            Self::Narrow(format) => order(single(format.round(range.stored(z, true).max(0.0).into()))),
            #[expect(
                clippy::cast_possible_truncation,
                clippy::disallowed_methods,
                reason = "single precision is what is studied"
            )]
            Self::Logarithmic => fixed((z as f32).ln() / (range.far as f32).ln(), 24),
        }
    }

    /// The length of one step at depth `z`, for the program's own format with its scale: a unit of the stored value
    /// over its derivative.
    pub(in crate::numerics) fn step(self, range: &Range, own: &DepthScale, z: f64) -> f64 {
        if self != Self::Own {
            return self.step_in_range(range, z);
        }
        // Depths relative to the farthest in view, whatever their unit.
        let far = own.far;
        let slope = match range.projection {
            Projection::Perspective => z * (far - z) / far,
            Projection::Parallel => far - z,
        };
        let depth = own.depth(z);
        slope * ulp(depth) / depth
    }

    /// The same for a format whose range is F … B.
    fn step_in_range(self, range: &Range, z: f64) -> f64 {
        let (slope, reversed) = range.slope_and_reversed(z);
        let step = match self {
            Self::Fixed16 => slope * 2f64.powi(-16),
            Self::Fixed24 => slope * 2f64.powi(-24),
            Self::Float if range.ndc.reversed => slope * ulp(reversed),
            // z_n in −1 … 1 resolves only its own last place, half of which counts.
            Self::Float if range.ndc.depths()[0] < 0.0 => {
                slope * ulp(1.0 - reversed).max(0.5 * ulp((1.0 - 2.0 * reversed).abs()))
            }
            Self::Float => slope * ulp(1.0 - reversed),
            Self::FloatReversed | Self::Own => slope * ulp(reversed),
            // 11 and 8 bits in place of 24.
            Self::Narrow(VertexFormat::F16) => slope * (2f64.powi(13) * ulp(reversed)).max(2f64.powi(-24)),
            Self::Narrow(VertexFormat::Bf16) => slope * 2f64.powi(16) * ulp(reversed),
            Self::Narrow(_) => slope * 2f64.powi(-16),
            Self::Logarithmic => z * range.far.ln() * 2f64.powi(-24),
        };
        // A depth in single precision resolves only its own last place.
        step.max(ulp(z)).min(2.0 * range.far)
    }
}

/// The distance from one f32 to the next.
fn ulp(x: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "an exponent")]
    let exponent = x.max(f64::MIN_POSITIVE).log2().floor() as i32;
    2f64.powi(exponent.max(-126) - 23)
}

/// The visible plane at a place of a picture of two planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// Neither.
    Ground,
    /// The nearer plane.
    Nearer,
    /// The farther plane, with nothing in front of it.
    Farther,
    /// The farther plane, although the nearer one is in front of it.
    Through,
}

/// Two planes in a depth buffer, one in front of the other at a distance of a gap. They're parallel, and tilted so that
/// they pass through many depths.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TwoPlanes {
    /// Rows from the top, each of [`WIDTH`](Self::WIDTH).
    pub seen: Vec<Seen>,
}

impl TwoPlanes {
    /// Pixels across.
    pub const WIDTH: u32 = 150;
    /// Pixels down.
    pub const HEIGHT: u32 = 24;
    /// Depth of the picture in gaps. If a step is longer than the gap, there are stripes.
    const GAPS: f64 = 10.0;

    /// `depth` is that of the nearest corner, in units of F, F … B. Planes that would reach beyond B begin nearer to
    /// the eye. The farther plane is drawn last, and appears if its value isn't greater, because then the buffer can't
    /// tell which plane is nearer.
    fn drawn(format: Format, range: &Range, depth: f64, gap: f64) -> Self {
        let deep = (Self::GAPS * gap).min(0.5 * depth);
        let nearest = depth.min(range.far - deep - gap).max(1.0);
        let (nearer, farther) = (0.05..0.7, 0.3..0.95);
        let pixels = (0..Self::HEIGHT).flat_map(|j| (0..Self::WIDTH).map(move |i| (i, j)));
        let seen = pixels.map(|(i, j)| {
            let (x, y) = (f64::from(i) / f64::from(Self::WIDTH), f64::from(j) / f64::from(Self::HEIGHT));
            let border = (0.1..0.9).contains(&y);
            // The eye notices slanting stripes more easily than upright ones.
            let z = nearest + deep * (0.8 * x + 0.2 * y);
            match (border && nearer.contains(&x), border && farther.contains(&x)) {
                (true, true) if format.value(range, z + gap) <= format.value(range, z) => Seen::Through,
                (true, _) => Seen::Nearer,
                (false, true) => Seen::Farther,
                (false, false) => Seen::Ground,
            }
        });
        Self { seen: seen.collect() }
    }

    /// The share of the area covered by both planes in which the farther one appears.
    pub fn share_through(&self) -> f64 {
        let (mut both, mut through) = (0_u32, 0_u32);
        let columns = (0..Self::WIDTH).cycle();
        for (i, seen) in columns.zip(&self.seen) {
            let x = f64::from(i) / f64::from(Self::WIDTH);
            both += u32::from(*seen != Seen::Ground && (0.3..0.7).contains(&x));
            through += u32::from(*seen == Seen::Through);
        }
        f64::from(through) / f64::from(both.max(1))
    }
}

/// The resolution of a format of depth buffers for the depths of a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Resolution {
    /// The word of the format, such as `fixed-24`.
    pub format: &'static str,
    /// The length of one step at a depth, in scene units.
    pub step: f64,
    /// The picture of two planes in this format.
    pub planes: TwoPlanes,
}

/// Each format of graphics cards in a convention, at a depth from the eye, F … B, and its picture of two planes that
/// are `gap` apart there. The reversed formats are included even if the convention isn't reversed.
pub fn resolutions(space: &ClipSpace<'_>, depth: f64, gap: f64) -> Vec<Resolution> {
    let (range, unit, z) = Range::with_unit(space, depth);
    let gap = gap / unit;
    let of = |format: Format| Resolution {
        format: format.name(),
        step: format.step_in_range(&range, z) * unit,
        planes: TwoPlanes::drawn(format, &range, z, gap),
    };
    // In a reversed convention, every float is reversed.
    let is_another = |format: &Format| *format != Format::Own && !(range.ndc.reversed && *format == Format::Float);
    FORMATS.into_iter().filter(is_another).map(of).collect()
}
