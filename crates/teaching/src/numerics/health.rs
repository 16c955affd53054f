//! The health of a camera in six quantities, each judged by thresholds that are given here with their reasons. A
//! quantity with a [`Warning`] isn't good.

use glam::DVec3;

use crate::appearance::DepthFormat;
use crate::camera::thresholds::{COARSE_DEPTH, FAR_AWAY, NEARLY_COLLINEAR_DEGREES, WIDE_DEGREES};
use crate::camera::{Camera, ImageSize, Parameters, Projection, Warning};
use crate::chain::{Condition, Enclosure, Gradient, pose, scaled_basis};
use crate::geometry::Aabb;
use crate::numbers::{nice_above, nice_below};

crate::worded! {
    /// A level of health.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Level {
        /// No trouble.
        Good = "good",
        /// Worth a look.
        Fair = "fair",
        /// The trouble is visible, or will be.
        Poor = "poor",
    }
    /// Its name in JSON.
    pub fn name
}

crate::listed! {
    /// A judged quantity.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum HealthQuantity {
        /// The angle between VUP and the line of DOP in degrees, 0 … 90.
        VupAngle = "vup-angle",
        /// B / F.
        FarNearRatio = "far-near-ratio",
        /// The smallest difference of depth at B that the figure's depth format keeps, in scene units. For whole
        /// numbers it's that of the figure's own format, otherwise that of 24 bits, which a graphics card has unless a
        /// program asks for more.
        DepthResolution = "depth-resolution",
        /// Decimal digits left for the view of the camera, of the 16 that an `f64` has.
        PositionDigits = "position-digits",
        /// The longest side of the view volume over its shortest, at half its depth.
        VolumeShape = "volume-shape",
        /// θ in degrees; 0 in parallel projection.
        ViewAngle = "view-angle",
    }
    /// Its name in JSON.
    pub fn code
}

impl HealthQuantity {
    /// The line that a warning belongs to.
    const fn of(warning: &Warning) -> Self {
        match warning {
            Warning::ViewUpNearlyCollinear { .. } => Self::VupAngle,
            Warning::DepthPrecision { .. } => Self::FarNearRatio,
            Warning::FarFromOrigin { .. } => Self::PositionDigits,
            Warning::FocalPointClipped { .. } | Warning::AspectMismatch { .. } => Self::VolumeShape,
            Warning::WideAngle { .. } => Self::ViewAngle,
        }
    }
}

/// VUP and DOP closer than this cost **u** two of its digits.
const SMALL_VUP_DEGREES: f64 = 1.0;
/// From here on, less than one step in ten thousand is left for the back half of the volume. With 16 bits, that's less
/// than seven.
const LARGE_RATIO: f64 = 1e4;
/// A step of the depth buffer of this share of its scale (B in perspective, H in parallel projection) may be visible
/// where surfaces nearly touch. A step of [`COARSE_DEPTH`] of it is visible everywhere.
const VISIBLE_STEP: f64 = 6e-4;
/// From here on, single precision (7 digits), in which graphics cards compute, has three digits left, one pixel in a
/// thousand.
const RATHER_FAR: f64 = 1e4;
/// A volume this much longer than wide looks like a needle or a sheet in pictures.
const SLENDER: f64 = 100.0;
/// From here on it looks like a line or like nothing.
const DEGENERATE: f64 = 1e4;
/// From here on, things at the border are drawn 33 times as large as in the middle.
const EXTREME_DEGREES: f64 = 160.0;
/// Below this a perspective can hardly be distinguished from a parallel projection.
const NARROW_DEGREES: f64 = 1.0;
/// Below this the window is a ten-thousandth of the distance, so a hair's turn of the camera loses its target.
const NEEDLE_DEGREES: f64 = 0.01;

/// One quantity of a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Health {
    /// The rated number.
    pub quantity: HealthQuantity,
    /// Good, fair or poor.
    pub level: Level,
    /// In the unit of its [`HealthQuantity`].
    pub value: f64,
    /// The warnings with more details.
    pub warnings: Vec<Warning>,
    /// A camera that sees the same scene and is better in this; `None` if it's good, or nothing helps.
    pub repair: Option<Parameters>,
}

/// Judges a camera. `format` is the figure's depth format, and `bounds` the box around the visible scene.
pub fn health(camera: &Camera, format: DepthFormat, image: ImageSize, bounds: Option<Aabb>) -> Vec<Health> {
    let warnings: Vec<Warning> = camera.warnings().into_iter().chain(camera.aspect_warning(image)).collect();
    let line = |quantity| {
        let warnings: Vec<Warning> = warnings.iter().filter(|w| HealthQuantity::of(w) == quantity).cloned().collect();
        let (value, level) = judged(quantity, camera, format);
        // JSON has no infinity, but the greatest number says as much.
        let value = value.min(f64::MAX);
        let level = if warnings.is_empty() { level } else { level.max(Level::Fair) };
        let repair =
            (level > Level::Good).then(|| repaired(quantity, (camera, format), image, bounds, &warnings)).flatten();
        Health { quantity, level, value, warnings, repair: repair.filter(|p| Camera::new(p).is_ok()) }
    };
    HealthQuantity::ALL.into_iter().map(line).collect()
}

/// The value of a quantity, and its level.
fn judged(quantity: HealthQuantity, camera: &Camera, format: DepthFormat) -> (f64, Level) {
    let perspective = camera.projection() == Projection::Perspective;
    match quantity {
        HealthQuantity::VupAngle => {
            let angle = camera.view_up_angle();
            (angle, below(angle, SMALL_VUP_DEGREES, NEARLY_COLLINEAR_DEGREES))
        }
        HealthQuantity::FarNearRatio => {
            let ratio = camera.far() / camera.near();
            // The step at B is B (1 − F/B) ratio / 2^24.
            let coarse = camera.depth_step(camera.far()) > COARSE_DEPTH * camera.far();
            let level = match perspective {
                true if coarse => Level::Poor,
                true => above(ratio, LARGE_RATIO, f64::INFINITY),
                false => Level::Good,
            };
            (ratio, level)
        }
        HealthQuantity::DepthResolution => {
            let step = camera.depth_step(camera.far()) * coarseness(format);
            let length = if perspective { camera.far() } else { camera.window_height().max(camera.window_width()) };
            (step, above(step, VISIBLE_STEP * length, COARSE_DEPTH * length))
        }
        HealthQuantity::PositionDigits => {
            let ratio = camera.origin_ratio();
            (digits_left(ratio), above(ratio, RATHER_FAR, FAR_AWAY))
        }
        HealthQuantity::VolumeShape => {
            let sides = volume_sides(camera);
            let [least, most] =
                [sides.into_iter().fold(f64::INFINITY, f64::min), sides.into_iter().fold(0.0, f64::max)];
            (most / least, above(most / least, SLENDER, DEGENERATE))
        }
        HealthQuantity::ViewAngle if perspective => {
            let degrees = camera.view_angle().degrees();
            let level = above(degrees, WIDE_DEGREES, EXTREME_DEGREES);
            (degrees, level.max(below(degrees, NARROW_DEGREES, NEEDLE_DEGREES)))
        }
        HealthQuantity::ViewAngle => (0.0, Level::Good),
    }
}

/// The ratio of a step of a depth format to one of 24 bits.
pub fn coarseness(format: DepthFormat) -> f64 {
    match format {
        DepthFormat::Fixed16 => 256.0,
        DepthFormat::Fixed24 | DepthFormat::Float => 1.0,
    }
}

/// The decimal digits that **u**, **v**, **n** of a camera lose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LostDigits {
    /// By the question itself, whatever computes them: those that its condition takes from the input.
    pub question: f64,
    /// By our method, of the 16 that an `f64` has: 0 if every component is proved to be within ε of the exact one.
    pub method: f64,
    /// The greatest distance that the exact components can have from ours.
    pub error: f64,
}

/// The digits lost by the basis of a camera. `None` if its condition is infinite or a number can't be enclosed.
pub fn lost_digits(camera: &Camera) -> Option<LostDigits> {
    let camera = camera.rounded();
    let p = camera.parameters();
    let question = Condition::of(scaled_basis::<Gradient>(&pose(p)).iter().flat_map(|axis| &axis.0))?.digits();
    let mut error = 0.0_f64;
    for (axis, (_, ours, _)) in scaled_basis::<Enclosure>(&pose(p)).iter().zip(camera.basis().named()) {
        for (exact, ours) in axis.0.iter().zip(ours.to_array()) {
            let [low, high] = exact.ends()?;
            error = error.max(ours - low).max(high - ours);
        }
    }
    Some(LostDigits { question, method: (error / f64::EPSILON).max(1.0).log10(), error })
}

fn above(value: f64, fair: f64, poor: f64) -> Level {
    match value {
        v if v > poor => Level::Poor,
        v if v > fair => Level::Fair,
        _ => Level::Good,
    }
}

fn below(value: f64, fair: f64, poor: f64) -> Level {
    above(-value, -fair, -poor)
}

/// The digits left, of log₁₀ 2⁵³ decimal ones, in a difference of numbers that are `ratio` times as large.
fn digits_left(ratio: f64) -> f64 {
    (53.0 * 2f64.log10() - ratio.max(1.0).log10()).max(0.0)
}

/// Width and height of the volume at half its depth, and its depth.
pub fn volume_sides(camera: &Camera) -> [f64; 3] {
    let (near, far) = (camera.near(), camera.far());
    let scale = match camera.projection() {
        Projection::Perspective => f64::midpoint(1.0, far / near),
        Projection::Parallel => 1.0,
    };
    // A size beyond the range of `f64` counts as the greatest `f64`.
    let scale = scale.min(f64::MAX);
    [camera.window_width() * scale, camera.window_height() * scale, far - near].map(|side: f64| side.min(f64::MAX))
}

/// F and B that hold a scene closely. If it reaches behind the eye, F is a thousandth of B.
pub fn suggested_planes(camera: &Camera, bounds: Aabb) -> Option<[f64; 2]> {
    let depths = bounds.corners().map(|corner| -camera.view_point(corner).z);
    let (least, most) = (depths.into_iter().fold(f64::INFINITY, f64::min), depths.into_iter().fold(0.0, f64::max));
    let far = nice_above(1.02 * most)?;
    let near = nice_below(if least > 1e-3 * most { 0.98 * least } else { 1e-3 * far })?;
    (near < far).then_some([near, far])
}

/// The parameters with other planes. A given window keeps its angles.
pub fn with_planes(p: &Parameters, [near, far]: [f64; 2]) -> Parameters {
    let scale = if p.projection == Projection::Perspective { near / p.near } else { 1.0 };
    Parameters { near, far, window: p.window.map(|window| window.map(|x| x * scale)), ..*p }
}

fn repaired(
    quantity: HealthQuantity,
    (camera, format): (&Camera, DepthFormat),
    image: ImageSize,
    bounds: Option<Aabb>,
    warnings: &[Warning],
) -> Option<Parameters> {
    let p = *camera.parameters();
    let planes = || {
        let suggested = suggested_planes(camera, bounds?)?;
        let mended = with_planes(&p, suggested);
        let is_better = Camera::new(&mended)
            .is_ok_and(|after| judged(quantity, &after, format).1 < judged(quantity, camera, format).1);
        is_better.then_some(mended)
    };
    match quantity {
        // The picture stays as it is.
        HealthQuantity::VupAngle => Some(Parameters { view_up: camera.basis().v, ..p }),
        HealthQuantity::FarNearRatio | HealthQuantity::DepthResolution => planes(),
        HealthQuantity::PositionDigits => None,
        HealthQuantity::VolumeShape => match warnings.first() {
            Some(Warning::AspectMismatch { .. }) if p.window.is_none() => {
                Some(Parameters { aspect: image.aspect(), ..p })
            }
            Some(Warning::FocalPointClipped { distance, near, far }) => {
                Some(with_planes(&p, [near.min(0.1 * distance), far.max(2.0 * distance)]))
            }
            _ => planes(),
        },
        HealthQuantity::ViewAngle => (p.window.is_none()).then(|| ordinary_angle(camera)),
    }
}

/// θ = 45°, from a position where the plane of PF fills the window as before.
fn ordinary_angle(camera: &Camera) -> Parameters {
    const DEGREES: f64 = 45.0;
    let p = *camera.parameters();
    let half = |degrees: f64| (0.5 * degrees).to_radians().tan();
    let distance = camera.distance() * half(p.view_angle) / half(DEGREES);
    let position: DVec3 = p.focal_point + camera.basis().n * distance;
    // Points in front of and behind PF stay there.
    let moved = distance - camera.distance();
    let near = p.near + moved;
    let near = if near > 0.0 { near } else { p.near.min(1e-3 * distance) };
    Parameters { position, view_angle: DEGREES, near, far: (p.far + moved).max(2.0 * distance), ..p }
}
