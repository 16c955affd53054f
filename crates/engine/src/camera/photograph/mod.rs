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
//! 1/f² is computed in place of f: if it's within the error of a pixel from 0, f is unknown.

mod lines;

use glam::{DMat3, DVec2, DVec3};

use super::{Camera, CameraError, ImageSize, Parameters, Projection};
use lines::{Located, SURE, differ, focal_length, rotation, vanishing};
pub use lines::{PhotographLine, WorldAxis};

/// The lines and points of a photograph that say where its camera was.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PhotographMarks {
    /// Lines along the axes of the world, at least two each of at least two axes.
    pub lines: Vec<PhotographLine>,
    /// The pixel of the origin of the world, (0, 0) at the top left.
    pub origin: Option<DVec2>,
    /// A point on an axis: its pixel, and its coordinate, which isn't 0.
    pub length: Option<(WorldAxis, DVec2, f64)>,
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
    /// θ, because in each pair of axes, one has lines that nearly meet at infinity.
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
    /// The lines of an axis lie on one line, and meet everywhere.
    #[error("the lines of {} lie on one line", .0.name())]
    OneLine(WorldAxis),
    /// 1/f² is negative. Axes at right angles never look like this with the principal point in the middle.
    #[error("{} and {} are not at right angles in any camera with its axis through the middle", .0.name(), .1.name())]
    NotAtRightAngles(WorldAxis, WorldAxis),
    /// The lines of two axes meet in one point, up to the error of a pixel.
    #[error("the lines of {} and {} point in the same direction", .0.name(), .1.name())]
    SameDirection(WorldAxis, WorldAxis),
    /// The directions of three axes lie in one plane, or a number isn't finite.
    #[error("{0}")]
    Impossible(CameraError),
    /// The senses of the lines make a left-handed system.
    #[error("the senses of the lines make a left-handed system")]
    LeftHanded,
    /// The known length is nowhere in front of the camera.
    #[error("the length and the origin contradict each other")]
    Length,
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
    /// f in pixels. `None` means it can't be known.
    pub focal_length: Option<f64>,
    /// The change of θ in degrees if each end of each line is wrong by one pixel, root of the sum of squares. `None` if
    /// θ can't be known.
    pub view_angle_per_pixel: Option<f64>,
    /// The same of the direction of **n**, degrees.
    pub direction_per_pixel: f64,
    /// The numbers that the photograph doesn't tell.
    pub untold: Vec<Untold>,
}

impl PhotographCamera {
    /// **u**, **v** and **n** in the world, the rows of R.
    pub fn axes(&self) -> [DVec3; 3] {
        let (v, n) = (self.parameters.view_up, (self.parameters.position - self.parameters.focal_point).normalize());
        [v.cross(n), v, n]
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
    let (frame, given) = (PixelFrame::new(image), &in_perspective(given));
    let solved = solve(marks, &frame, given, SURE)?;
    let mut untold = Vec::new();
    if solved.focal_length.is_none() {
        untold.push(Untold::ViewAngle);
    }
    let placed = place(marks, &frame, &solved, given, &mut untold)?;
    let costs = costs(marks, &frame, &solved, given);
    let parameters = Parameters {
        position: placed,
        // On the axis, as far as the origin is deep.
        focal_point: placed - solved.axes.row(2) * placed.dot(solved.axes.row(2)).abs().max(given.near),
        view_up: solved.axes.row(1),
        projection: Projection::Perspective,
        view_angle: solved.focal_length.map_or(given.view_angle, |f| frame.view_angle(f)),
        aspect: image.aspect(),
        window: None,
        ..*given
    };
    Camera::new(&parameters).map_err(PhotographError::Impossible)?;
    Ok(PhotographCamera {
        parameters,
        vanishing: solved.located.iter().map(|located| located.reported(&frame)).collect(),
        horizon: horizon(&solved, &frame),
        focal_length: solved.focal_length.map(|f| f * frame.scale),
        view_angle_per_pixel: solved.focal_length.map(|_| costs[0]),
        direction_per_pixel: costs[1],
        untold,
    })
}

/// F and B of a parallel camera may be 0 or less. A perspective takes the usual ones then.
fn in_perspective(given: &Parameters) -> Parameters {
    let Parameters { near, far, .. } = if given.near > 0.0 { *given } else { Parameters::default() };
    Parameters { near, far, ..*given }
}

/// Pixels → centred coordinates, y up, in half diagonals of the image, so that squares neither grow nor vanish.
struct PixelFrame {
    middle: DVec2,
    scale: f64,
    height: f64,
}

impl PixelFrame {
    fn new(image: ImageSize) -> Self {
        let size = DVec2::new(f64::from(image.width), f64::from(image.height));
        Self { middle: size / 2.0, scale: size.length() / 2.0, height: size.y }
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
}

/// f and R.
struct Solved {
    located: Vec<Located>,
    /// In half diagonals. `None` means it can't be known.
    focal_length: Option<f64>,
    /// The one in use: the given one if it can't be known.
    used_focal_length: f64,
    /// The directions of x, y, z in the VRC are its columns, so **u**, **v**, **n** its rows.
    axes: DMat3,
}

/// Directions count as different if the sine of their angle is `sure` times its error for one pixel.
fn solve(
    marks: &PhotographMarks,
    frame: &PixelFrame,
    given: &Parameters,
    sure: f64,
) -> Result<Solved, PhotographError> {
    let located = vanishing(&marks.lines, |pixel| frame.centred(pixel), 1.0 / frame.scale)?;
    let focal_length = focal_length(&located)?;
    let used = focal_length.unwrap_or_else(|| frame.focal_length(given.view_angle));
    differ(&located, used, sure)?;
    let axes = rotation(&located, &marks.lines, used, |pixel| frame.centred(pixel))?;
    Ok(Solved { located, focal_length, used_focal_length: used, axes })
}

/// C in the world.
fn place(
    marks: &PhotographMarks,
    frame: &PixelFrame,
    solved: &Solved,
    given: &Parameters,
    untold: &mut Vec<Untold>,
) -> Result<DVec3, PhotographError> {
    let distance = given.position.distance(given.focal_point);
    let world_from_view = solved.axes.transpose();
    let ray = |pixel: DVec2| frame.centred(pixel).extend(-solved.used_focal_length);
    let Some(origin) = marks.origin.map(ray) else {
        untold.extend([Untold::Position, Untold::Distance]);
        // It looks at the origin, from as far as the given camera.
        return Ok(solved.axes.row(2) * distance);
    };
    let Some((axis, pixel, length)) = marks.length else {
        untold.push(Untold::Distance);
        return Ok(-(world_from_view * origin.normalize()) * distance);
    };
    // λ r_o + L d is on the ray r_q, so its cross product with r_q is 0, and λ is the least squares solution of that.
    let (r_q, d) = (ray(pixel), solved.axes.col(axis.index()));
    let (across, moved) = (origin.cross(r_q), d.cross(r_q) * length);
    let lambda = -moved.dot(across) / across.length_squared();
    if !(lambda.is_finite() && lambda > 0.0) {
        return Err(PhotographError::Length);
    }
    Ok(-(world_from_view * origin) * lambda)
}

/// Through the vanishing points of x and z: the points at infinity of y = 0.
fn horizon(solved: &Solved, frame: &PixelFrame) -> Option<[DVec2; 2]> {
    let f = solved.used_focal_length;
    let [x, z] = [0, 2].map(|axis| {
        let d = solved.axes.col(axis);
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

/// The changes of θ and of the direction of **n**, degrees, for one pixel in each coordinate of each end: the root of
/// the sum of squares of differences.
fn costs(marks: &PhotographMarks, frame: &PixelFrame, solved: &Solved, given: &Parameters) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for line in 0..marks.lines.len() {
        for end in 0..2 {
            for step in [DVec2::X, DVec2::Y] {
                let mut moved = marks.clone();
                moved.lines[line].ends[end] += step;
                let Ok(other) = solve(&moved, frame, given, 0.0) else { return [f64::INFINITY; 2] };
                let angle = |f: f64| frame.view_angle(f);
                sums[0] += (angle(other.used_focal_length) - angle(solved.used_focal_length)).powi(2);
                sums[1] += other.axes.row(2).angle_between(solved.axes.row(2)).to_degrees().powi(2);
            }
        }
    }
    sums.map(f64::sqrt)
}

#[cfg(test)]
mod tests;
