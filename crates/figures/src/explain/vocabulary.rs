//! The camera in the vocabularies of other sources and libraries, and back. Each number that can be set sets the
//! camera.
//!
//! | words | what |
//! | --- | --- |
//! | [`Vocabulary::OpenGl`] | `gluLookAt`, `gluPerspective`, `glFrustum`, `glOrtho`, `[2]` |
//! | [`Vocabulary::Vrc`] | VRP, VPN, VUV, D, w, h, F, B, `[3]`: left-handed, **n** into the scene |
//! | [`Vocabulary::ReferencePoint`] | P₀, P_ref, V, projection reference point, view plane, `[1]` |
//! | [`Vocabulary::Pinhole`] | K \[R \| t\] of computer vision: x right, y down, z into the scene, pixels |

use glam::{DMat3, DVec3};

use super::{Axis, Component};
use crate::camera::{Camera, ImageSize, Parameters, Projection, ViewWindow};

/// A source of vocabulary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Vocabulary {
    /// `[2]`: OpenGL and GLU
    OpenGl,
    /// `[3]`
    Vrc,
    /// `[1]`
    ReferencePoint,
    /// Computer vision
    Pinhole,
}

/// A call or an equation with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// `gluLookAt`, `VRP`, `K` …
    pub name: &'static str,
    /// In the order of the call.
    pub arguments: Vec<Argument>,
}

/// A number of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Argument {
    /// The name in the source: `eyeX`, `fovy`, `z_near`.
    pub name: &'static str,
    /// In the unit of the library.
    pub value: f64,
    /// The quantity that it sets; [`CameraNumber::Fixed`] sets nothing.
    pub quantity: CameraNumber,
}

/// The quantity of a camera that a number stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CameraNumber {
    /// C
    Position(Component),
    /// PF
    FocalPoint(Component),
    /// VUP
    ViewUp(Component),
    /// DOP times any length: PF = C + D DOP
    Direction(Component),
    /// θ, degrees
    ViewAngle,
    /// A
    Aspect,
    /// l
    Left,
    /// r
    Right,
    /// b
    Bottom,
    /// t
    Top,
    /// W/2
    HalfWidth,
    /// H/2
    HalfHeight,
    /// F
    Near,
    /// B
    Far,
    /// −F
    NearCoordinate,
    /// −B
    FarCoordinate,
    /// `f_x`, `f_y`: F m/W, F n/H in pixels
    FocalLength(Component),
    /// `c_x`, `c_y`: where the axis meets the image, pixels
    PrincipalPoint(Component),
    /// t = −R C
    Translation(Component),
    /// An entry of R. The camera is rotated about the origin until the entry has the number.
    Axis(Axis, Component),
    /// Follows from the others, so it can't be set.
    Fixed,
}

/// A limitation of a vocabulary, or a difference from the notes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Limitation {
    /// The window is symmetric there.
    SymmetricOnly,
    /// It can express perspective only.
    PerspectiveOnly,
    /// A number of the lens, of the pixels or F is beyond the range that it takes.
    OutOfRange,
    /// Clipping planes aren't part of it, so F and B stay.
    NoClippingPlanes,
    /// PF isn't part of it, so D stays.
    NoFocalPoint,
    /// The view plane is the front plane here, with D = F, and `z_vp` = −F.
    ViewPlaneIsNear,
    /// Left-handed: **n** points into the scene, **u** = **n** × **v**.
    LeftHanded,
    /// `z_near` and `z_far` are coordinates there, negative.
    Coordinates,
    /// y points down. In some books pixels are counted from the centre of the first one, but here from its corner, as
    /// in (5.22).
    YDown,
}

impl Vocabulary {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::OpenGl, Self::Vrc, Self::ReferencePoint, Self::Pinhole];

    /// Checks that it can express this camera.
    ///
    /// # Errors
    /// [`Limitation::SymmetricOnly`] or [`Limitation::PerspectiveOnly`] if it can't express it at all.
    fn check(self, camera: &Camera) -> Result<(), Limitation> {
        let symmetric = camera.has_symmetric_window();
        match self {
            Self::OpenGl => Ok(()),
            Self::Vrc if symmetric => Ok(()),
            Self::ReferencePoint if symmetric || camera.projection() == Projection::Parallel => Ok(()),
            Self::Vrc | Self::ReferencePoint => Err(Limitation::SymmetricOnly),
            Self::Pinhole if camera.projection() == Projection::Perspective => Ok(()),
            Self::Pinhole => Err(Limitation::PerspectiveOnly),
        }
    }

    /// Its differences from `[0]`, and its gaps.
    pub fn limitations(self) -> &'static [Limitation] {
        match self {
            Self::OpenGl => &[],
            Self::Vrc => &[Limitation::LeftHanded, Limitation::ViewPlaneIsNear, Limitation::NoFocalPoint],
            Self::ReferencePoint => &[Limitation::Coordinates, Limitation::ViewPlaneIsNear],
            Self::Pinhole => &[Limitation::YDown, Limitation::NoClippingPlanes, Limitation::NoFocalPoint],
        }
    }

    /// The camera in these words.
    ///
    /// # Errors
    /// The [`Limitation`] that makes it impossible.
    pub fn lines(self, camera: &Camera, image: ImageSize) -> Result<Vec<Line>, Limitation> {
        self.check(camera)?;
        let symmetric = Self::Vrc.check(camera).is_ok();
        let values = SymbolValues { camera, image };
        Ok(match (self, camera.projection()) {
            (Self::OpenGl, projection) => vec![values.look_at(), values.open_gl_lens(projection, symmetric)],
            (Self::Vrc, _) => values.vrc(),
            (Self::ReferencePoint, projection) => values.reference_point(projection),
            (Self::Pinhole, _) => values.pinhole(),
        })
    }

    /// The parameters of the camera with one of the numbers changed. [`Camera::new`] decides if they make a camera.
    /// [`CameraNumber::Fixed`] changes nothing.
    pub fn set(self, camera: &Camera, image: ImageSize, quantity: CameraNumber, value: f64) -> Parameters {
        let mut p = *camera.parameters();
        let component = |vector: &mut DVec3, c: Component| vector[c.index().min(2)] = value;
        let (m, n) = (f64::from(image.width), f64::from(image.height));
        let window = camera.window();
        match quantity {
            CameraNumber::Position(c) => component(&mut p.position, c),
            CameraNumber::FocalPoint(c) => component(&mut p.focal_point, c),
            CameraNumber::ViewUp(c) => component(&mut p.view_up, c),
            CameraNumber::Direction(c) => {
                let mut direction = camera.direction_of_projection();
                component(&mut direction, c);
                p.focal_point = p.position + direction.normalize_or_zero() * camera.distance();
            }
            CameraNumber::ViewAngle => p.view_angle = value,
            CameraNumber::Aspect => p.aspect = value,
            CameraNumber::Left => p.window = Some(ViewWindow { left: value, ..window }),
            CameraNumber::Right => p.window = Some(ViewWindow { right: value, ..window }),
            CameraNumber::Bottom => p.window = Some(ViewWindow { bottom: value, ..window }),
            CameraNumber::Top => p.window = Some(ViewWindow { top: value, ..window }),
            CameraNumber::HalfWidth => p.aspect = 2.0 * value / camera.window_height(),
            CameraNumber::HalfHeight => {
                p.aspect = camera.window_width() / (2.0 * value);
                match camera.projection() {
                    Projection::Perspective => p.view_angle = 2.0 * value.atan2(camera.near()).to_degrees(),
                    Projection::Parallel => p.height = 2.0 * value,
                }
            }
            CameraNumber::Near => p.near = value,
            CameraNumber::Far => p.far = value,
            CameraNumber::NearCoordinate => p.near = -value,
            CameraNumber::FarCoordinate => p.far = -value,
            CameraNumber::FocalLength(c) => {
                // The image keeps its size, so a longer focal length is a smaller window around the same axis.
                let (pixels, size) = if c == Component::X { (m, window.width()) } else { (n, window.height()) };
                let factor = camera.near() * pixels / value / size;
                p.window = Some(if c == Component::X {
                    ViewWindow { left: window.left * factor, right: window.right * factor, ..window }
                } else {
                    ViewWindow { bottom: window.bottom * factor, top: window.top * factor, ..window }
                });
            }
            CameraNumber::PrincipalPoint(Component::X) => {
                let left = -value * window.width() / m;
                p.window = Some(ViewWindow { left, right: left + window.width(), ..window });
            }
            CameraNumber::PrincipalPoint(_) => {
                let top = value * window.height() / n;
                p.window = Some(ViewWindow { bottom: top - window.height(), top, ..window });
            }
            CameraNumber::Translation(c) => {
                let rotation = vision_rotation(camera);
                let mut t = -(rotation * camera.position());
                component(&mut t, c);
                let position = -(rotation.transpose() * t);
                p.focal_point += position - p.position;
                p.position = position;
            }
            CameraNumber::Axis(axis, c) => {
                // t stays, so C = −Rᵀ t turns with R.
                let turn = turn_of_entry(camera, axis as usize, c.index(), value);
                for vector in [&mut p.position, &mut p.focal_point, &mut p.view_up] {
                    *vector = turn * *vector;
                }
            }
            CameraNumber::Fixed => {}
        }
        p
    }
}

/// Rows **u**, −**v**, −**n**.
fn vision_rotation(camera: &Camera) -> DMat3 {
    let basis = camera.basis();
    DMat3::from_cols(basis.u, -basis.v, -basis.n).transpose()
}

/// The smallest rotation after which an entry of R has a value of −1 … 1. Its axis is the line perpendicular to the
/// entry's row and to the world's axis of its column.
fn turn_of_entry(camera: &Camera, row: usize, column: usize, value: f64) -> DMat3 {
    let rotation = vision_rotation(camera);
    let (along, axis) = (rotation.row(row), DVec3::AXES[column]);
    let across = along.cross(axis);
    // A row along the axis has every perpendicular. The next row is one.
    let about = across.try_normalize().filter(|_| across.length() > 1e-9).unwrap_or(rotation.row((row + 1) % 3));
    let (from, to) = (across.length().atan2(along.dot(axis)), value.clamp(-1.0, 1.0).acos());
    DMat3::from_axis_angle(about, from - to)
}

struct SymbolValues<'a> {
    camera: &'a Camera,
    image: ImageSize,
}

fn argument(name: &'static str, value: f64, quantity: CameraNumber) -> Argument {
    Argument { name, value: value + 0.0, quantity }
}

fn line(name: &'static str, arguments: Vec<Argument>) -> Line {
    Line { name, arguments }
}

fn number(name: &'static str, value: f64, quantity: CameraNumber) -> Line {
    line(name, vec![argument(name, value, quantity)])
}

fn vector(names: [&'static str; 3], value: DVec3, quantity: fn(Component) -> CameraNumber) -> Vec<Argument> {
    let parts = names.into_iter().zip(value.to_array()).zip(Component::THREE);
    parts.map(|((name, value), component)| argument(name, value, quantity(component))).collect()
}

impl SymbolValues<'_> {
    fn window(&self) -> [f64; 4] {
        let ViewWindow { left, right, bottom, top } = self.camera.window();
        [left, right, bottom, top]
    }

    fn look_at(&self) -> Line {
        let camera = self.camera;
        let eye = vector(["eyeX", "eyeY", "eyeZ"], camera.position(), CameraNumber::Position);
        let center = vector(["centerX", "centerY", "centerZ"], camera.focal_point(), CameraNumber::FocalPoint);
        let up = vector(["upX", "upY", "upZ"], camera.view_up(), CameraNumber::ViewUp);
        Line { name: "gluLookAt", arguments: [eye, center, up].concat() }
    }

    fn open_gl_lens(&self, projection: Projection, symmetric: bool) -> Line {
        let camera = self.camera;
        let planes = [
            argument("nearVal", camera.near(), CameraNumber::Near),
            argument("farVal", camera.far(), CameraNumber::Far),
        ];
        if projection == Projection::Perspective && symmetric && camera.parameters().window.is_none() {
            let angle = argument("fovy", camera.view_angle().degrees(), CameraNumber::ViewAngle);
            let aspect = argument("aspect", camera.window_aspect(), CameraNumber::Aspect);
            return Line { name: "gluPerspective", arguments: [&[angle, aspect], &planes[..]].concat() };
        }
        let name = if projection == Projection::Perspective { "glFrustum" } else { "glOrtho" };
        Line { name, arguments: [&self.sides(["left", "right", "bottom", "top"])[..], &planes].concat() }
    }

    fn sides(&self, names: [&'static str; 4]) -> Vec<Argument> {
        let quantities = [CameraNumber::Left, CameraNumber::Right, CameraNumber::Bottom, CameraNumber::Top];
        let parts = names.into_iter().zip(self.window()).zip(quantities);
        parts.map(|((name, value), quantity)| argument(name, value, quantity)).collect()
    }

    fn vrc(&self) -> Vec<Line> {
        let camera = self.camera;
        vec![
            line("VRP", vector(["x", "y", "z"], camera.position(), CameraNumber::Position)),
            line("VPN", vector(["x", "y", "z"], camera.direction_of_projection(), CameraNumber::Direction)),
            line("VUV", vector(["x", "y", "z"], camera.view_up(), CameraNumber::ViewUp)),
            number("D", camera.near(), CameraNumber::Fixed),
            number("w", camera.window_width() / 2.0, CameraNumber::HalfWidth),
            number("h", camera.window_height() / 2.0, CameraNumber::HalfHeight),
            number("F", camera.near(), CameraNumber::Near),
            number("B", camera.far(), CameraNumber::Far),
        ]
    }

    fn reference_point(&self, projection: Projection) -> Vec<Line> {
        let camera = self.camera;
        let mut lines = vec![
            line("P_0", vector(["x_0", "y_0", "z_0"], camera.position(), CameraNumber::Position)),
            line("P_{ref}", vector(["x", "y", "z"], camera.focal_point(), CameraNumber::FocalPoint)),
            line("V", vector(["x", "y", "z"], camera.view_up(), CameraNumber::ViewUp)),
        ];
        if projection == Projection::Perspective {
            let origin = vector(["x_{prp}", "y_{prp}", "z_{prp}"], DVec3::ZERO, |_| CameraNumber::Fixed);
            lines.push(line("prp", origin));
            lines.push(number("z_{vp}", -camera.near(), CameraNumber::Fixed));
            let of_angle = |own| if camera.parameters().window.is_none() { own } else { CameraNumber::Fixed };
            lines.push(number("θ", camera.view_angle().degrees(), of_angle(CameraNumber::ViewAngle)));
            lines.push(number("aspect", camera.window_aspect(), of_angle(CameraNumber::Aspect)));
        } else {
            lines.push(line("xw, yw", self.sides(["xw_{min}", "xw_{max}", "yw_{min}", "yw_{max}"])));
        }
        lines.push(number("z_{near}", -camera.near(), CameraNumber::NearCoordinate));
        lines.push(number("z_{far}", -camera.far(), CameraNumber::FarCoordinate));
        lines
    }

    fn pinhole(&self) -> Vec<Line> {
        let camera = self.camera;
        let [left, _, _, top] = self.window();
        let (m, n) = (f64::from(self.image.width), f64::from(self.image.height));
        let (width, height) = (camera.window_width(), camera.window_height());
        let (x, y) = (Component::X, Component::Y);
        let k = vec![
            argument("f_x", camera.near() * m / width, CameraNumber::FocalLength(x)),
            argument("skew", 0.0, CameraNumber::Fixed),
            argument("c_x", -left / width * m, CameraNumber::PrincipalPoint(x)),
            argument("f_y", camera.near() * n / height, CameraNumber::FocalLength(y)),
            argument("c_y", top / height * n, CameraNumber::PrincipalPoint(y)),
        ];
        let rotation = vision_rotation(camera);
        let axes = [Axis::U, Axis::V, Axis::N];
        let row = |i: usize, names| {
            let parts = Component::THREE.into_iter().zip(rotation.row(i).to_array()).zip(names);
            parts.map(|((c, value), name)| argument(name, value, CameraNumber::Axis(axes[i], c))).collect::<Vec<_>>()
        };
        let rows = [
            row(0, ["r_{11}", "r_{12}", "r_{13}"]),
            row(1, ["r_{21}", "r_{22}", "r_{23}"]),
            row(2, ["r_{31}", "r_{32}", "r_{33}"]),
        ];
        let t = -(rotation * camera.position());
        vec![
            line("K", k),
            line("R", rows.concat()),
            line("t", vector(["t_1", "t_2", "t_3"], t, CameraNumber::Translation)),
        ]
    }
}
