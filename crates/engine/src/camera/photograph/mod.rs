//! The camera of a photograph, from lines in it that are parallel to the axes of the world.
//!
//! The lines of one axis meet in the image of its ideal point, the vanishing point `[4]`. In units of pixels, with the
//! origin in the middle of the image, x to the right and y up, the direction **d** in the VRC, with the coordinates
//! a, b and c along **u**, **v** and **n**, vanishes at (f a, f b, −c) in homogeneous coordinates, because (5.9) and
//! (5.10) divide by −z. Two axes at right angles give f² w₁ w₂ = −(x₁ x₂ + y₁ y₂), so two vanishing points give f and
//! with it θ. The directions of the axes are the columns of R. The pixel of the origin gives the direction to C, and a
//! known length the distance.
//!
//! The textbook way divides by w and fails when lines are parallel in the image. Here points stay homogeneous, and
//! 1/f² is computed in place of f: if it's within the error of a pixel from 0, f is unknown. Each pair of axes counts
//! by what it knows.

mod lines;

use glam::{DMat3, DVec2, DVec3};

use super::{Camera, CameraError, ImageSize, Parameters, Projection, ViewWindow};
use crate::numbers::greatest_singular;
use lines::{CONTRADICTS, Focal, Located, Pair, SURE, direction, doubt, middle, rotation, vanishing};
pub use lines::{PhotographLine, WorldAxis};

/// A relative step for differences: neither the third derivatives nor the digits of `f64` are seen in them.
const STEP: f64 = 1e-5;

/// The lines and points of a photograph that say where its camera was.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PhotographMarks {
    /// Lines along the axes of the world, at least two each of at least two axes.
    pub lines: Vec<PhotographLine>,
    /// The pixel of the origin of the world, (0, 0) at the top left.
    pub origin: Option<DVec2>,
    /// A point on an axis through the origin: its pixel, and its coordinate, which isn't 0.
    pub length: Option<(WorldAxis, DVec2, f64)>,
    /// The pixel in which the axis of the camera goes through the image. `None` for the middle.
    pub middle: Option<DVec2>,
}

/// A vanishing point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisVanishing {
    /// The axis whose lines meet there.
    pub axis: WorldAxis,
    /// Its pixel; `None` if its lines may be parallel in the image.
    pub pixel: Option<DVec2>,
    /// Smallest angle between its lines and the average of their directions, degrees. The smaller it is, the more a
    /// pixel costs.
    pub spread: f64,
}

/// A number that a photograph can't tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Untold {
    /// θ, because no pair of axes tells it: lines nearly meet at infinity, or in the middle of the image.
    ViewAngle,
    /// The direction to C, because no pixel of the origin was given.
    Position,
    /// The distance of C, because no length was given.
    Distance,
}

impl Untold {
    /// Its name in output for programs.
    pub const fn code(self) -> &'static str {
        match self {
            Self::ViewAngle => "view-angle",
            Self::Position => "position",
            Self::Distance => "distance",
        }
    }
}

/// A thing that the marks say and that the camera doesn't follow, or only in part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Doubt {
    /// The lines of an axis are pieces of one line, to within a pixel. The axis is left out.
    OneLine(WorldAxis),
    /// The angle between two axes (degrees, up to 90) at θ in use. If θ is known, this pair is left out of it.
    Angle(WorldAxis, WorldAxis, f64),
    /// Lines of an axis were drawn the other way round, and are turned.
    Turned(WorldAxis),
    /// The camera stands upside down, or two axes were drawn the other way round.
    UpsideDown,
    /// Three vanishing points put the axis of the camera through this pixel, so many pixels beside the middle, with
    /// this error for one pixel in each end.
    Middle {
        /// Its pixel.
        pixel: DVec2,
        /// From the pixel in use.
        offset: f64,
        /// In pixels, smaller than the offset.
        error: f64,
    },
}

impl Doubt {
    /// Its name in output for programs.
    pub const fn code(self) -> &'static str {
        match self {
            Self::OneLine(_) => "one-line",
            Self::Angle(..) => "angle",
            Self::Turned(_) => "turned",
            Self::UpsideDown => "upside-down",
            Self::Middle { .. } => "middle",
        }
    }
}

/// The reason why there is no camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PhotographError {
    /// Fewer than two axes have two lines each.
    #[error("fewer than two axes have two lines each")]
    TooFewLines,
    /// A line whose ends are one point.
    #[error("line {0} has no direction")]
    NoDirection(usize),
    /// The lines of an axis lie on one line, to within a pixel, and meet everywhere on it.
    #[error("the lines of {} lie on one line", .0.name())]
    OneLine(WorldAxis),
    /// 1/f² is negative. Axes at right angles never look like this with the principal point in the middle. With their
    /// angle at the given θ, both in degrees.
    #[error("{} and {} are not at right angles in any camera with its axis through the middle", .0.name(), .1.name())]
    NotAtRightAngles(WorldAxis, WorldAxis, [f64; 2]),
    /// The same, and [`Doubt::Middle`] says in which pixel the axis goes through the image.
    #[error("the axis of the camera isn't in the middle")]
    OffMiddle(Doubt),
    /// The lines of two axes meet in one point, up to the error of a pixel.
    #[error("the lines of {} and {} point in the same direction", .0.name(), .1.name())]
    SameDirection(WorldAxis, WorldAxis),
    /// A number isn't finite, or out of the range of cameras.
    #[error("{0}")]
    Impossible(CameraError),
    /// The point of the length lies beside the axis through the origin, by these pixels.
    #[error("the point of the length lies {} pixels beside {}", .1, .0.name())]
    BesideAxis(WorldAxis, f64),
    /// The pixel of the length shows no point of the axis at that distance.
    #[error("the length and the origin contradict each other")]
    Length,
    /// The same, with a θ that isn't known. It's the given one, in degrees.
    #[error("the length needs another angle than {0}")]
    LengthAtAngle(f64),
}

/// The camera of a photograph, with the cost of an error of one pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotographCamera {
    /// The camera. The [untold](Self::untold) numbers are those of the given camera.
    pub parameters: Parameters,
    /// The vanishing points, in the order of the axes.
    pub vanishing: Vec<AxisVanishing>,
    /// Two points of the horizon, the image of the ideal line of the plane y = 0; `None` if it is at infinity.
    pub horizon: Option<[DVec2; 2]>,
    /// The pixel in which the axis of the camera goes through the image.
    pub middle: DVec2,
    /// f in pixels. `None` means it can't be known.
    pub focal_length: Option<f64>,
    /// The change of θ in degrees if each end of each line is wrong by one pixel, root of the sum of squares. `None` if
    /// θ can't be known.
    pub view_angle_per_pixel: Option<f64>,
    /// The same of the direction of **n**, degrees.
    pub direction_per_pixel: f64,
    /// The numbers that the photograph doesn't tell.
    pub untold: Vec<Untold>,
    /// The marks that contradict each other, or the camera.
    pub doubts: Vec<Doubt>,
}

impl PhotographCamera {
    /// **u**, **v** and **n** in the world, the rows of R.
    pub fn axes(&self) -> [DVec3; 3] {
        let (v, n) = (self.parameters.view_up, (self.parameters.position - self.parameters.focal_point).normalize());
        [v.cross(n), v, n]
    }

    /// The way of an axis through a pixel of the image, towards larger coordinates: the derivative of (5.9) and (5.10).
    pub fn way(&self, axis: WorldAxis, pixel: DVec2, image: ImageSize) -> DVec2 {
        let frame = PixelFrame::new(image, None);
        let d = DVec3::from_array(self.axes().map(|of| of[axis.index()]));
        let f = self.focal_length.map_or_else(|| frame.focal_length(self.parameters.view_angle), |f| f / frame.scale);
        let way = d.truncate() * f + (frame.centred(pixel) - frame.centred(self.middle)) * d.z;
        let way = DVec2::new(way.x, -way.y).normalize_or_zero();
        // Its own lines know better than R, which all axes share.
        let vanishing = self.vanishing.iter().find(|point| point.axis == axis).and_then(|point| point.pixel);
        let own = vanishing.map_or(way, |point| (point - pixel).normalize_or_zero());
        if own.dot(way) < 0.0 { -own } else { own }
    }

    /// The angle by which the camera is rolled about **n**, between the horizon and the rows of the image. Degrees.
    pub fn roll(&self) -> f64 {
        let [u, v, _] = self.axes();
        u.y.atan2(v.y).to_degrees()
    }
}

/// The camera of the marks in an image. The numbers that they leave open come from `given`: θ, F, B, and the distance
/// of C.
///
/// # Errors
/// [`PhotographError`] says why there is none.
pub fn camera_of_photograph(
    marks: &PhotographMarks,
    image: ImageSize,
    given: &Parameters,
) -> Result<PhotographCamera, PhotographError> {
    let (frame, given) = (PixelFrame::new(image, marks.middle), &in_perspective(given));
    let solved = solve(marks, &frame, given)?;
    let (axes, position, senses) = oriented(marks, &frame, &solved, given)?;
    if let (Some(origin), Some((axis, pixel, _))) = (marks.origin, marks.length) {
        let located = solved.located.iter().find(|located| located.axis == axis);
        let [beside, error] = located.map_or([0.0; 2], |of| of.beside(frame.centred(origin), frame.centred(pixel)));
        if beside > CONTRADICTS * error.hypot(frame.pixel_size()) {
            return Err(PhotographError::BesideAxis(axis, beside * frame.scale));
        }
    }
    let mut untold = Vec::new();
    untold.extend(solved.told.is_none().then_some(Untold::ViewAngle));
    untold.extend(marks.origin.is_none().then_some(Untold::Position));
    untold.extend((marks.origin.is_none() || marks.length.is_none()).then_some(Untold::Distance));
    let costs = costs(&frame, &solved, &senses, axes);
    // On the axis, as deep as the origin. Without a length D stays the given one, so that the camera found from the
    // camera found is the same.
    let depth = if marks.length.is_some() { position.dot(axes.row(2)).abs() } else { position.length() };
    let mut parameters = Parameters {
        position,
        focal_point: position - axes.row(2) * depth.max(given.near),
        view_up: axes.row(1),
        projection: Projection::Perspective,
        view_angle: solved.told.map_or(given.view_angle, |f| frame.view_angle(f)),
        aspect: image.aspect(),
        window: None,
        ..*given
    };
    parameters.window = marks.middle.map(|_| frame.window(image, given.near / solved.focal_length));
    Camera::new(&parameters).map_err(PhotographError::Impossible)?;
    Ok(PhotographCamera {
        parameters,
        vanishing: solved.located.iter().map(|located| located.reported(&frame)).collect(),
        horizon: horizon(axes, solved.focal_length, &frame),
        middle: frame.middle,
        focal_length: solved.told.map(|f| f * frame.scale),
        view_angle_per_pixel: solved.told.map(|_| costs.x),
        direction_per_pixel: costs.y,
        untold,
        doubts: doubts(solved, &frame, &senses, axes),
    })
}

/// The condition of the question which camera took a photograph: how many times a small relative change of the marks
/// can grow in C, PF, VUP and θ, both measured by their 2-norms. `None` if it isn't finite.
///
/// *Textbook*: the Jacobian by formulas. *Here*: by central differences, because an eigenvector has no short formula,
/// and they're right to nine digits.
pub fn condition_of_photograph(marks: &PhotographMarks, image: ImageSize, given: &Parameters) -> Option<f64> {
    fn numbers(marks: &mut PhotographMarks) -> Vec<&mut f64> {
        let ends = marks.lines.iter_mut().flat_map(|line| &mut line.ends).chain(&mut marks.origin);
        let mut numbers: Vec<&mut f64> = ends.flat_map(|end| [&mut end.x, &mut end.y]).collect();
        if let Some((_, pixel, length)) = &mut marks.length {
            numbers.extend([&mut pixel.x, &mut pixel.y, length]);
        }
        numbers
    }
    let result = |marks: &PhotographMarks| -> Option<[f64; 10]> {
        let Parameters { position: c, focal_point: pf, view_up: up, view_angle, .. } =
            camera_of_photograph(marks, image, given).ok()?.parameters;
        Some([c.x, c.y, c.z, pf.x, pf.y, pf.z, up.x, up.y, up.z, view_angle])
    };
    let size = result(marks)?.into_iter().fold(0.0, f64::hypot);
    let mut marks = marks.clone();
    let mut columns = Vec::new();
    for k in 0..numbers(&mut marks).len() {
        let moved = |step: f64| {
            let mut moved = marks.clone();
            let number = numbers(&mut moved).into_iter().nth(k)?;
            let (x, step) = (*number, step * number.abs().max(1.0));
            *number += step;
            Some((x / (2.0 * step), result(&moved)?))
        };
        let ((scale, after), (_, before)) = (moved(STEP)?, moved(-STEP)?);
        columns.push(std::array::from_fn(|row| scale * (after[row] - before[row]) / size));
    }
    Some(greatest_singular::<10>(&columns).0).filter(|number| number.is_finite())
}

/// F and B of a parallel camera may be 0 or less. A perspective takes the usual ones then. A window has a θ, too.
fn in_perspective(given: &Parameters) -> Parameters {
    let Parameters { near, far, .. } = if given.near > 0.0 { *given } else { Parameters::default() };
    let of_window = |window: ViewWindow| 2.0 * (window.height() / 2.0).atan2(near).to_degrees();
    let window = given.window.filter(|_| given.projection == Projection::Perspective);
    Parameters { near, far, view_angle: window.map_or(given.view_angle, of_window), ..*given }
}

/// Pixels → centred coordinates, y up, in half diagonals of the image, so that squares neither grow nor vanish.
struct PixelFrame {
    middle: DVec2,
    scale: f64,
    height: f64,
}

impl PixelFrame {
    fn new(image: ImageSize, middle: Option<DVec2>) -> Self {
        let size = DVec2::new(f64::from(image.width), f64::from(image.height));
        Self { middle: middle.unwrap_or(size / 2.0), scale: size.length() / 2.0, height: size.y }
    }

    fn pixel_size(&self) -> f64 {
        1.0 / self.scale
    }

    fn centred(&self, pixel: DVec2) -> DVec2 {
        let p = (pixel - self.middle) / self.scale;
        DVec2::new(p.x, -p.y)
    }

    fn pixel(&self, p: DVec2) -> DVec2 {
        self.middle + DVec2::new(p.x, -p.y) * self.scale
    }

    /// tan(θ/2) = (n/2) / f.
    fn view_angle(&self, focal_length: f64) -> f64 {
        2.0 * (self.height / (2.0 * self.scale * focal_length)).atan().to_degrees()
    }

    fn focal_length(&self, view_angle: f64) -> f64 {
        self.height / (2.0 * self.scale * (view_angle.to_radians() / 2.0).tan())
    }

    /// The whole image, `share` of its size.
    fn window(&self, image: ImageSize, share: f64) -> ViewWindow {
        let corner = DVec2::new(f64::from(image.width), f64::from(image.height));
        let [a, b] = [DVec2::ZERO, corner].map(|corner| self.centred(corner) * share);
        ViewWindow { left: a.x, right: b.x, bottom: b.y, top: a.y }
    }
}

/// The vanishing points and f.
struct Solved {
    located: Vec<Located>,
    one_line: Vec<WorldAxis>,
    focal: Focal,
    /// f in half diagonals. `None` means it can't be known.
    told: Option<f64>,
    /// The one in use: the given one if it can't be known.
    focal_length: f64,
    /// The pixel in half diagonals, and its error.
    middle: Option<(DVec2, f64)>,
}

impl Solved {
    /// Two axes, and their angle at a focal length, degrees up to 90.
    fn angle(&self, (a, b): Pair, focal_length: f64) -> (WorldAxis, WorldAxis, f64) {
        let [a, b] = [&self.located[a], &self.located[b]];
        let [d, e] = [a, b].map(|of| direction(of.point, focal_length).normalize());
        (a.axis, b.axis, d.cross(e).length().atan2(d.dot(e).abs()).to_degrees())
    }

    /// [`Doubt::Middle`] if the middle of the lens is surely elsewhere.
    fn off_middle(&self, frame: &PixelFrame) -> Option<Doubt> {
        let (middle, error) = self.middle.filter(|(middle, error)| *error < middle.length())?;
        let [offset, error] = [middle.length(), error].map(|length| length * frame.scale);
        Some(Doubt::Middle { pixel: frame.pixel(middle), offset, error })
    }
}

fn solve(marks: &PhotographMarks, frame: &PixelFrame, given: &Parameters) -> Result<Solved, PhotographError> {
    let (located, one_line) = vanishing(&marks.lines, frame)?;
    let focal = Focal::new(&located);
    let middle = if located.iter().all(Located::is_finite) { middle_of(&located, frame) } else { None };
    let q = focal.inverse_square;
    let told = (q > SURE * focal.error).then(|| q.sqrt().recip());
    let given = frame.focal_length(given.view_angle);
    let is_possible = q >= -SURE * focal.error;
    let solved = Solved { located, one_line, focal, told, focal_length: told.unwrap_or(given), middle };
    if is_possible {
        return Ok(solved);
    }
    if let Some(middle) = solved.off_middle(frame) {
        return Err(PhotographError::OffMiddle(middle));
    }
    let (a, b, angle) = solved.angle(solved.focal.surest(&solved.located), given);
    Err(PhotographError::NotAtRightAngles(a, b, [angle, frame.view_angle(given)]))
}

/// The middle of the lens and its error for one pixel.
fn middle_of(located: &[Located], frame: &PixelFrame) -> Option<(DVec2, f64)> {
    let points: Vec<DVec3> = located.iter().map(|located| located.point).collect();
    let found = middle(&points)?;
    let squares = squares(located, frame, |points| middle(points).unwrap_or(found).extend(0.0));
    Some((found, squares.element_sum().sqrt())).filter(|(_, error)| error.is_finite())
}

/// The squares of the changes that one pixel in each coordinate of each end makes in a function of vanishing points.
fn squares(located: &[Located], frame: &PixelFrame, of: impl Fn(&[DVec3]) -> DVec3) -> DVec3 {
    let points: Vec<DVec3> = located.iter().map(|located| located.point).collect();
    let of_one = |(at, located): (usize, &Located)| {
        let with = |point| {
            let mut points = points.clone();
            points[at] = point;
            of(&points)
        };
        located.squares(frame.pixel_size(), with).unwrap_or_default()
    };
    located.iter().enumerate().map(of_one).sum()
}

/// R of vanishing points with their senses. The surer an axis, the more it counts.
fn turned(solved: &Solved, points: &[DVec3], senses: &[f64], focal_length: f64) -> Option<DMat3> {
    let errors = solved.located.iter().map(|of| of.direction_error(solved.focal_length).max(f64::EPSILON));
    let least = errors.clone().fold(f64::INFINITY, f64::min);
    let directions = solved.located.iter().zip(errors).zip(points.iter().zip(senses));
    let weighted = directions.map(|((located, error), (point, sense))| {
        (located.axis, direction(*point, focal_length) * *sense, (least / error).powi(2).max(1e-4))
    });
    rotation(&weighted.collect::<Vec<_>>())
}

/// R, C, and the senses of the axes: those in which most lines were drawn, if they are right-handed and the length is
/// in front of the camera. If not, the senses that turn the fewest lines and let the camera stand upright.
fn oriented(
    marks: &PhotographMarks,
    frame: &PixelFrame,
    solved: &Solved,
    given: &Parameters,
) -> Result<(DMat3, DVec3, Vec<f64>), PhotographError> {
    let votes: Vec<[usize; 2]> = solved.located.iter().map(|of| of.senses(solved.focal_length)).collect();
    let least: usize = votes.iter().flat_map(|of| of.iter().min()).sum();
    let points: Vec<DVec3> = solved.located.iter().map(|of| of.point).collect();
    let mut best: Option<((bool, bool, usize), _)> = None;
    let mut refused = PhotographError::SameDirection(solved.located[0].axis, solved.located[1].axis);
    for pattern in 0..1_usize << votes.len() {
        let reversed: Vec<bool> = (0..votes.len()).map(|at| pattern >> at & 1 == 1).collect();
        let against = votes.iter().zip(&reversed).map(|(of, reversed)| of[usize::from(!reversed)]).sum();
        let senses: Vec<f64> = reversed.iter().map(|reversed| if *reversed { -1.0 } else { 1.0 }).collect();
        let Some(axes) = turned(solved, &points, &senses, solved.focal_length) else { continue };
        let Some(position) = place(marks, frame, (axes, solved.focal_length), given) else {
            refused = PhotographError::Length;
            // The reason may be θ, not a line.
            if solved.told.is_none() && against == least {
                return Err(PhotographError::LengthAtAngle(given.view_angle));
            }
            continue;
        };
        let rank = (against > least, axes.col(1).y < 0.0, against);
        if best.as_ref().is_none_or(|best| rank < best.0) {
            best = Some((rank, (axes, position, senses)));
        }
    }
    best.map(|best| best.1).ok_or(refused)
}

/// C in the world. `None` if the length is nowhere in front of it.
fn place(
    marks: &PhotographMarks,
    frame: &PixelFrame,
    (axes, focal_length): (DMat3, f64),
    given: &Parameters,
) -> Option<DVec3> {
    let distance = given.position.distance(given.focal_point);
    let world_from_view = axes.transpose();
    let ray = |pixel: DVec2| frame.centred(pixel).extend(-focal_length);
    let Some(origin) = marks.origin.map(ray) else {
        // It looks at the origin, from as far as the given camera.
        return Some(axes.row(2) * distance);
    };
    let Some((axis, pixel, length)) = marks.length else {
        return Some(-(world_from_view * origin.normalize()) * distance);
    };
    // λ r_o + L d is on the ray r_q, so its cross product with r_q is 0, and λ is the least squares solution of that.
    let (r_q, d) = (ray(pixel), axes.col(axis.index()));
    let (across, moved) = (origin.cross(r_q), d.cross(r_q) * length);
    let lambda = -moved.dot(across) / across.length_squared();
    (lambda.is_finite() && lambda > 0.0).then(|| -(world_from_view * origin) * lambda)
}

fn doubts(solved: Solved, frame: &PixelFrame, senses: &[f64], axes: DMat3) -> Vec<Doubt> {
    let f = solved.focal_length;
    let is_doubtful = |pair: &Pair| doubt(&solved.located, *pair, f.powi(-2)) > CONTRADICTS;
    let pairs = [(0, 1), (0, 2), (1, 2)].into_iter().filter(|pair| pair.1 < solved.located.len() && is_doubtful(pair));
    let angles = if solved.told.is_some() { solved.focal.left_out.clone() } else { pairs.collect() };
    let angle = |pair| {
        let (a, b, angle) = solved.angle(pair, f);
        Doubt::Angle(a, b, angle)
    };
    let is_turned = |(of, sense): &(&Located, &f64)| of.senses(f)[usize::from(**sense > 0.0)] > 0;
    let turned = solved.located.iter().zip(senses).filter(is_turned).map(|(of, _)| Doubt::Turned(of.axis));
    let one_line = solved.one_line.iter().copied().map(Doubt::OneLine);
    let mut doubts: Vec<Doubt> = one_line.chain(angles.into_iter().map(angle)).chain(turned).collect();
    let y = axes.col(1);
    doubts.extend((y.y < -y.x.abs()).then_some(Doubt::UpsideDown));
    doubts.extend(solved.off_middle(frame));
    doubts
}

/// Through the vanishing points of x and z: the points at infinity of y = 0.
fn horizon(axes: DMat3, f: f64, frame: &PixelFrame) -> Option<[DVec2; 2]> {
    let [x, z] = [0, 2].map(|axis| {
        let d = axes.col(axis);
        DVec3::new(f * d.x, f * d.y, -d.z)
    });
    let DVec3 { x: a, y: b, z: c } = x.cross(z);
    let normal = DVec2::new(a, b);
    // A camera that looks straight up or down has its horizon at infinity.
    if normal.length() <= 1e-9 * c.abs() {
        return None;
    }
    let nearest = normal * (-c / normal.length_squared());
    let along = normal.perp().normalize();
    Some([nearest - along, nearest + along].map(|p| frame.pixel(p)))
}

/// The changes of θ and of the direction of **n**, degrees, for one pixel in each coordinate of each end.
fn costs(frame: &PixelFrame, solved: &Solved, senses: &[f64], axes: DMat3) -> DVec3 {
    let of = |points: &[DVec3]| {
        let f = solved.told.map_or(solved.focal_length, |_| solved.focal.of(points).0.sqrt().recip());
        let other = turned(solved, points, senses, f).unwrap_or(axes);
        // The sine of a small angle, from a difference without cancellation.
        let turn = other.row(2).cross(axes.row(2)).length().asin();
        DVec3::new(frame.view_angle(f), turn.to_degrees(), 0.0)
    };
    squares(&solved.located, frame, of).map(f64::sqrt)
}

#[cfg(test)]
mod tests;
