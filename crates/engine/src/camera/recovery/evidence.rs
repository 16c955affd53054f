//! The evidence for a reading: graded points, which rank the readings that the numbers allow.
//!
//! A point is about a natural logarithm of odds. A matrix rarely is level, upright, or made of short numbers by chance,
//! so each such coincidence speaks for the reading in which it appears.

use glam::{DMat4, DVec3};

use crate::camera::recovery::reading::MatrixEntries;
use crate::camera::recovery::{Axes, MatrixKind, Order, Reading, Recovered, SLACK, Unknown, WorldUp};
use crate::camera::{Camera, Program, Projection};

/// A fact that speaks for a reading, or against it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    /// A word of the text means it.
    Word(&'static str),
    /// **u** is horizontal.
    Level,
    /// **v** points up.
    Upright,
    /// **v** points down.
    UpsideDown,
    /// The origin lies in front.
    OriginAhead,
    /// The origin lies behind.
    OriginBehind,
    /// C has short round coordinates.
    RoundPosition,
    /// F or B is a short round number.
    RoundPlanes,
    /// Zeros and ±1 are those of a projection.
    ProjectionPattern,
    /// The principal point and the focal lengths are those of an image.
    Pixels,
    /// θ, A or B/F is out of the ordinary.
    Unusual,
}

/// The points of a reading, and its reasons.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Weight {
    pub(crate) score: f64,
    pub(crate) reasons: Vec<Reason>,
    /// **u** is horizontal and **v** points up.
    pub(crate) is_level: bool,
    /// The origin lies in front.
    pub(crate) is_ahead: bool,
}

/// The most that being level counts, because digits may be made up, and a hand-held camera is nearly level as well.
const LEVEL: f64 = 9.0;
/// A **v** · up below this is a view straight down or up, and then **u** tells nothing.
const STEEP: f64 = 0.2;
/// The least difference of two directions that a matrix of three digits can tell.
const SAME: f64 = 5e-3;

impl Weight {
    /// Weighs a reading. `matrix` acts on column vectors.
    pub(crate) fn new(
        (reading, order): (&Reading, Order),
        (matrix, entries): (DMat4, &MatrixEntries),
        found: &Recovered,
        camera: &Camera,
    ) -> Self {
        let mut weight = Self { score: prior(reading, order, entries.is_flat()), ..Self::default() };
        if reading.kind.has_pose() {
            weight.pose(reading.axes, camera);
            weight.round_position(reading.kind, entries.error(), camera);
        }
        match reading.kind {
            MatrixKind::Projection | MatrixKind::ViewProjection => {
                weight.lens(reading, matrix, entries.errors(order), found, camera);
            }
            MatrixKind::Pinhole | MatrixKind::Intrinsics => {
                let is_odd = |unknown: &Unknown| matches!(unknown, Unknown::PrincipalPoint | Unknown::WideAngle);
                if !found.unknown.iter().any(is_odd) {
                    weight.add(1.0, Reason::Pixels);
                }
                // Three zeros and a one in their places are no accident of three vectors.
                if reading.kind == MatrixKind::Intrinsics {
                    weight.score += 20.0;
                }
            }
            MatrixKind::CameraToWorld if found.unknown.contains(&Unknown::Scaled) => weight.score -= 3.0,
            MatrixKind::View | MatrixKind::CameraToWorld | MatrixKind::LookAt => {}
        }
        weight
    }

    fn add(&mut self, points: f64, reason: Reason) {
        self.score += points;
        self.reasons.push(reason);
    }

    /// How level and upright the camera is, and if it looks at the origin.
    fn pose(&mut self, axes: Axes, camera: &Camera) {
        // The world is turned or mirrored by now.
        let ups: &[(DVec3, f64)] = match axes.up {
            WorldUp::Y | WorldUp::Z => &[(DVec3::Y, 0.0)],
            WorldUp::Open => &[(DVec3::Z, -0.7), (DVec3::Y, -1.5), (DVec3::NEG_Y, -2.5)],
        };
        let basis = camera.basis();
        let best = ups.iter().map(|(up, prior)| upright(basis.u.dot(*up), basis.v.dot(*up)).plus(*prior));
        let best = best.max_by(|a, b| a.score.total_cmp(&b.score)).unwrap_or_default();
        self.score += best.score;
        self.reasons.extend(best.reasons);
        self.is_level = best.is_level;
        let distance = camera.position().length();
        if distance > 0.0 {
            let ahead = -camera.position().dot(camera.direction_of_projection()) / distance;
            self.is_ahead = ahead > 0.0;
            let aims = if ahead > 1.0 - 1e-5 { 2.0 } else { 0.0 };
            if ahead > 0.5 {
                self.add(2.0 * ahead + aims, Reason::OriginAhead);
            } else if ahead < -0.5 {
                self.add(2.0 * ahead, Reason::OriginBehind);
            } else {
                self.score += 2.0 * ahead;
            }
        }
    }

    fn round_position(&mut self, kind: MatrixKind, error: f64, camera: &Camera) {
        let position = camera.position();
        // Products of entries add up their errors.
        let error = if kind == MatrixKind::CameraToWorld { error } else { 2.0 * error * (1.0 + position.length()) };
        let are_round = position.to_array().iter().all(|x| x.abs() <= error.max(1e-12) || is_round(*x, error));
        if are_round && position.length() > error.max(1e-9) {
            self.add(3.0, Reason::RoundPosition);
        }
    }

    /// The zeros of a projection, its angle, and its clipping planes.
    fn lens(&mut self, reading: &Reading, matrix: DMat4, errors: DMat4, found: &Recovered, camera: &Camera) {
        let last = matrix.row(3);
        let is_perspective = camera.projection() == Projection::Perspective;
        let size = if is_perspective { last.truncate().length() } else { last.w.abs() };
        if (size - 1.0).abs() > 5.0 * SLACK {
            // Homogeneous, so any factor would do, but programs write 1.
            self.score -= 6.0;
        }
        if reading.kind == MatrixKind::Projection {
            // A parallel projection with F ≤ 0 is that of a picture without a view, such as glOrtho(…, −1, 1).
            let points = if is_perspective || camera.near() > 0.0 { 20.0 } else { 6.0 };
            self.add(points, Reason::ProjectionPattern);
        }
        // A view or a pose, in either order, isn't one.
        if is_rigid(matrix) || is_rigid(matrix.transpose()) {
            self.score -= 25.0;
        }
        if found.unknown.contains(&Unknown::DepthDirection) {
            self.score -= 1.5;
        }
        let window = camera.window();
        let (width, height) = (window.right - window.left, window.top - window.bottom);
        let mut unusual = 0.0;
        if is_perspective {
            let slope = height / 2.0 / camera.near();
            // 1° and 170°.
            if !(0.0087..11.4).contains(&slope) {
                unusual += 8.0;
            }
            if (window.left + window.right).abs() > width || (window.bottom + window.top).abs() > height {
                unusual += 6.0;
            }
            let ratio = camera.far() / camera.near();
            if ratio < 1.05 || ratio > 1e8 && !found.unknown.contains(&Unknown::Far) {
                unusual += 3.0;
            } else if ratio < 3.0 {
                self.score -= 1.5;
            }
        }
        if !(0.2..5.0).contains(&(width / height)) {
            unusual += 3.0;
        }
        if unusual > 0.0 {
            self.add(-unusual, Reason::Unusual);
        }
        // F is the present one in a parallel M_p M_v.
        if !found.unknown.contains(&Unknown::PositionAlongNormal) {
            self.round_planes(reading, errors, found, camera);
        }
    }

    /// F and B that an author typed are short, but not in a wrong range of NDC.
    fn round_planes(&mut self, reading: &Reading, errors: DMat4, found: &Recovered, camera: &Camera) {
        let (near, far) = (camera.near(), camera.far());
        let [of_z, of_depth] = if reading.kind == MatrixKind::ViewProjection {
            // z and d are sums over a row, times C.
            let error = errors.row(2).max_element().max(errors.row(3).max_element());
            [2.0 * error, 2.0 * error * (1.0 + camera.position().length())]
        } else {
            [errors.row(2).z, errors.row(2).w]
        };
        let [at_near, at_far] = reading.ndc.depths();
        let range = (at_near - at_far).abs();
        // z_n = a + d/F with d = (z₀ − z₁) F B/(B − F), so a small change of a moves F by F²/d of it, one of d by F/d.
        let error = |plane: f64| {
            if camera.projection() == Projection::Parallel {
                return (far - near) / range * (of_depth + of_z * plane.abs());
            }
            let depth = range * near * if found.unknown.contains(&Unknown::Far) { 1.0 } else { far / (far - near) };
            plane / depth * (plane * of_z + of_depth)
        };
        let far_is_open = found.unknown.contains(&Unknown::Far);
        let rounds = |plane: f64| is_round(plane, error(plane));
        let points = if rounds(near) { 3.0 } else { 0.0 } + if !far_is_open && rounds(far) { 2.0 } else { 0.0 };
        if points > 0.0 {
            self.add(points, Reason::RoundPlanes);
        }
    }

    fn plus(self, points: f64) -> Self {
        Self { score: self.score + points, ..self }
    }
}

/// Points for the share of **u** and of **v** along the vertical.
fn upright(u: f64, v: f64) -> Weight {
    if u.abs() < SAME && v.abs() < SAME {
        // Straight down or up an axis, as in a plan.
        return Weight { score: LEVEL + 2.0, reasons: vec![Reason::Level], is_level: false, is_ahead: false };
    }
    if v < 0.0 {
        return Weight { score: 4.0 * v - 2.0, reasons: vec![Reason::UpsideDown], ..Weight::default() };
    }
    let level = (-u.abs().ln()).min(LEVEL) * (v / STEEP).min(1.0);
    let is_level = u.abs() < 1e-3 && v > 1e-2;
    let mut reasons = Vec::new();
    if u.abs() < 0.02 && v > STEEP {
        reasons.push(Reason::Level);
    }
    if v > 0.5 {
        reasons.push(Reason::Upright);
    }
    Weight { score: level + 4.0 * v, reasons, is_level, is_ahead: false }
}

/// Points before any number speaks, for how common a reading is.
fn prior(reading: &Reading, order: Order, is_flat: bool) -> f64 {
    let axes = reading.axes;
    let mut points = 0.0;
    if reading.kind.has_camera_axes() {
        points -= f64::from(axes.rarity) / 10.0;
        points -= match (reading.kind, axes == Axes::OPENCV) {
            (MatrixKind::View, true) | (MatrixKind::CameraToWorld, false) => 0.0,
            _ => 0.5,
        };
    } else if reading.kind == MatrixKind::Projection {
        points -= if axes == Axes::OPENCV { 2.0 } else { f64::from(axes.rarity) / 20.0 };
    } else if reading.kind == MatrixKind::ViewProjection {
        points -= f64::from(axes.rarity) / 10.0;
    }
    if reading.kind.has_ndc() {
        // M_p M_v tells nothing of the camera's z, but OpenCV's z goes with its y.
        let tells_z = reading.kind == MatrixKind::Projection || axes == Axes::DIRECT3D || reading.ndc.y_down;
        let is_forward = tells_z && axes.signs()[1] < 0.0;
        points -= reading.ndc.rarity(is_forward);
        // OpenCV's y points down, in the image as in the camera; else it's Vulkan, whose depths are 0 … 1.
        if reading.ndc.y_down != (axes == Axes::OPENCV) {
            points -= if [reading.ndc.at_near, reading.ndc.at_far] == [-1, 1] { 2.5 } else { 0.5 };
        }
    }
    points - unusual_order(reading, order, is_flat)
}

/// Programs have their order: Blender prints rows, Unreal and `PyTorch3D` have row vectors, Direct3D both.
fn unusual_order(reading: &Reading, order: Order, is_flat: bool) -> f64 {
    let axes = reading.axes;
    let rows_of_vectors = Program::is_always_by_columns(axes);
    let by_kind = if axes == Axes::BLENDER && reading.kind == MatrixKind::View { 3.0 } else { 0.0 };
    by_kind
        + match (order, reading.kind) {
            (Order::Columns, _) if axes == Axes::BLENDER && is_flat => 6.0,
            (Order::Columns, _) if rows_of_vectors || axes == Axes::DIRECT3D => 0.0,
            (Order::Columns, _) => 1.0,
            (Order::Rows, MatrixKind::View | MatrixKind::CameraToWorld) if rows_of_vectors => 1.0,
            // Unity prints the rows of a Transform.
            (Order::Rows, MatrixKind::View) if axes == Axes::DIRECT3D => 1.0,
            // COLMAP, and TUM or glTF; Unity has such a pose too.
            (Order::WxyzThenT, MatrixKind::View) if axes == Axes::OPENCV => 0.0,
            (Order::TThenXyzw, MatrixKind::CameraToWorld) if axes == Axes::DIRECT3D => 1.0,
            (Order::TThenXyzw, MatrixKind::CameraToWorld) => 0.0,
            (Order::WxyzThenT | Order::TThenXyzw, _) => 2.0,
            (Order::XyzwThenT | Order::TThenWxyz, _) => 3.0,
            _ => 0.0,
        }
}

/// True if a number has one or two digits beside zeros, as far as its error tells.
fn is_round(value: f64, error: f64) -> bool {
    if value == 0.0 || !value.is_finite() {
        return false;
    }
    let step = 10.0_f64.powf(value.abs().log10().floor() - 1.0);
    let nearest = (value / step).round() * step;
    let error = error.max(1e-12 * value.abs());
    error < 0.02 * step && (value - nearest).abs() <= 1.05 * error
}

/// True if rows are perpendicular unit vectors, followed by 0 0 0 1.
pub(crate) fn is_rigid(m: DMat4) -> bool {
    let last = m.row(3);
    last.truncate().length() <= SLACK && (last.w - 1.0).abs() <= SLACK && is_rotation(m)
}

/// True if the first three rows are perpendicular unit vectors.
pub(crate) fn is_rotation(m: DMat4) -> bool {
    let rows = [0, 1, 2].map(|i| m.row(i).truncate());
    rows.iter().all(|row| (row.length() - 1.0).abs() <= SLACK) && are_perpendicular(rows)
}

fn are_perpendicular(lines: [DVec3; 3]) -> bool {
    let units = lines.map(DVec3::normalize_or_zero);
    [(0, 1), (0, 2), (1, 2)].into_iter().all(|(a, b)| units[a].dot(units[b]).abs() <= SLACK)
}

/// True if it's the matrix of a node with a scale of its own. In a parallel M_p M_v the rows are perpendicular but of
/// different lengths, and z changes its sign.
pub(crate) fn is_scaled(m: DMat4) -> bool {
    let rows = [0, 1, 2].map(|i| m.row(i).truncate());
    let columns = [0, 1, 2].map(|i| m.col(i).truncate());
    let lengths = rows.map(DVec3::length);
    let longest = lengths.into_iter().fold(0.0, f64::max);
    let is_uniform = lengths.iter().all(|length| longest - length <= SLACK * longest);
    let is_right_handed = rows[0].cross(rows[1]).dot(rows[2]) > 0.0;
    are_perpendicular(columns) && is_right_handed && (is_uniform || !are_perpendicular(rows))
}
