//! The numbers of a report by type, which gives their paths in the JSON of `inspect`.

use std::fmt;

use serde::Serialize;

use super::{CameraReport, Report, Whole};
use crate::camera::ParameterKey;

/// Numbers of a [`Report`] that belong together. Points and rays are counted from 0, in the order of the request.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// A parameter of the camera. [`CameraSide`](Self::CameraSide) reads its window.
    Camera(ParameterKey),
    /// A side of the window among the parameters, if they have one.
    CameraSide(Side),
    /// DOP
    Direction,
    /// D
    Distance,
    /// **u**, **v** or **n**
    Axis(BasisAxis),
    /// A number of the view window.
    Window(WindowNumber),
    /// A number of the lens, in perspective.
    Lens(LensNumber),
    /// A matrix, or an inverse.
    Matrix(ReportMatrix),
    /// A corner of the view volume: near (l,b) (r,b) (r,t) (l,t), then far in the same order.
    Corner(usize),
    /// A plane of the view volume.
    Plane(VolumePlane),
    /// A point in a space.
    Point(usize, PointNumber),
    /// The ray through a pixel.
    Ray(usize, RayNumber),
}

/// Numbers of one part of a report: each with its key in the JSON of `inspect`, and its numbers row by row. `None` if
/// the report has none.
macro_rules! numbers {
    ($(#[$doc:meta])* $name:ident of $report:ident { $($(#[$of:meta])* $variant:ident = $field:ident => $numbers:expr),* $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum $name { $($(#[$of])* $variant),* }

        impl $name {
            /// All.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Its key in the JSON of `inspect`.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => stringify!($field)),* }
            }

            fn of_name(name: &str) -> Option<Self> {
                Self::ALL.iter().copied().find(|one| one.name() == name)
            }

            fn numbers(self, of: &$report) -> Option<Vec<f64>> {
                let numbers: fn(&$report) -> Option<Vec<f64>> = match self { $(Self::$variant => $numbers),* };
                numbers(of)
            }
        }
    };
}

/// A part of a report, and its numbers.
macro_rules! part {
    (
        $(#[$doc:meta])* $report:ident,
        $(#[$about:meta])* $name:ident {
            $($(#[$of:meta])* $variant:ident = $field:ident: $type:ty => $numbers:expr),* $(,)?
        }
    ) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Serialize)]
        pub struct $report { $($(#[$of])* pub $field: $type),* }

        numbers! { $(#[$about])* $name of $report { $($(#[$of])* $variant = $field => $numbers),* } }
    };
}

part! {
    /// l, r, b, t.
    SidesReport,
    /// A side of the view window.
    Side {
        /// l
        Left = left: f64 => |window| Some(vec![window.left]),
        /// r
        Right = right: f64 => |window| Some(vec![window.right]),
        /// b
        Bottom = bottom: f64 => |window| Some(vec![window.bottom]),
        /// t
        Top = top: f64 => |window| Some(vec![window.top]),
    }
}

part! {
    /// The planes of the view volume in the world: \[a, b, c, d\] with a x + b y + c z + d ≥ 0 inside, and (a, b, c) of
    /// length 1.
    PlanesReport,
    /// A plane of the view volume, in the order of `Camera::volume_planes`.
    VolumePlane {
        /// Through C and l.
        Left = left: [f64; 4] => |planes| Some(planes.left.to_vec()),
        /// Through C and r.
        Right = right: [f64; 4] => |planes| Some(planes.right.to_vec()),
        /// Through C and b.
        Bottom = bottom: [f64; 4] => |planes| Some(planes.bottom.to_vec()),
        /// Through C and t.
        Top = top: [f64; 4] => |planes| Some(planes.top.to_vec()),
        /// At F.
        Near = near: [f64; 4] => |planes| Some(planes.near.to_vec()),
        /// At B.
        Far = far: [f64; 4] => |planes| Some(planes.far.to_vec()),
    }
}

part! {
    /// The VRC.
    BasisReport,
    /// An axis of the VRC.
    BasisAxis {
        /// **u**
        U = u: [f64; 3] => |basis| Some(basis.u.to_vec()),
        /// **v**
        V = v: [f64; 3] => |basis| Some(basis.v.to_vec()),
        /// **n**
        N = n: [f64; 3] => |basis| Some(basis.n.to_vec()),
    }
}

part! {
    /// The view window.
    WindowReport,
    /// A number of the view window.
    WindowNumber {
        /// l
        Left = left: f64 => |window| Some(vec![window.left]),
        /// r
        Right = right: f64 => |window| Some(vec![window.right]),
        /// b
        Bottom = bottom: f64 => |window| Some(vec![window.bottom]),
        /// t
        Top = top: f64 => |window| Some(vec![window.top]),
        /// W
        Width = width: f64 => |window| Some(vec![window.width]),
        /// H
        Height = height: f64 => |window| Some(vec![window.height]),
        /// A
        Aspect = aspect: f64 => |window| Some(vec![window.aspect]),
    }
}

part! {
    /// The lens in other words than θ.
    LensReport,
    /// A number of the lens.
    LensNumber {
        /// The angle that the window spans from left to right, degrees.
        HorizontalAngle = horizontal_angle: f64 => |lens| Some(vec![lens.horizontal_angle]),
        /// The angle from corner to corner, degrees.
        DiagonalAngle = diagonal_angle: f64 => |lens| Some(vec![lens.diagonal_angle]),
        /// `f_x` and `f_y`, in pixels of the image.
        FocalLengthPixels = focal_length_pixels: [f64; 2] => |lens| Some(lens.focal_length_pixels.to_vec()),
    }
}

numbers! {
    /// A matrix of a report, or an inverse.
    ReportMatrix of Report {
        /// M_v
        View = view_matrix => |report| Some(report.view_matrix.concat()),
        /// M_p
        Projection = projection_matrix => |report| Some(report.projection_matrix.concat()),
        /// M_p M_v
        ViewProjection = view_projection_matrix => |report| Some(report.view_projection_matrix.concat()),
        /// The inverse of M_v.
        InverseView = inverse_view_matrix => |report| Some(report.inverse_view_matrix.concat()),
        /// The inverse of M_p.
        InverseProjection = inverse_projection_matrix => |report| Some(report.inverse_projection_matrix.concat()),
    }
}

part! {
    /// One point in every space. The values after the division are `null` if W = 0.
    PointReport,
    /// A point in one of its spaces.
    PointNumber {
        /// World.
        World = world: [f64; 3] => |point| Some(point.world.to_vec()),
        /// VRC.
        View = view: [f64; 3] => |point| Some(point.view.to_vec()),
        /// Clip coordinates.
        Clip = clip: [f64; 4] => |point| Some(point.clip.to_vec()),
        /// NDC.
        Ndc = ndc: Option<[f64; 3]> => |point| Some(point.ndc?.to_vec()),
        /// (x_p, y_p).
        Window = window: Option<[f64; 2]> => |point| Some(point.window?.to_vec()),
        /// (i, j).
        Pixel = pixel: Option<[Whole; 2]> => |point| Some(point.pixel?.map(|whole| whole.0).to_vec()),
        /// (X, Y, Z).
        Viewport = viewport: Option<(Whole, Whole, f64)> => |point| point.viewport.map(|(x, y, z)| vec![x.0, y.0, z]),
        /// |X|, |Y|, |Z| ≤ W (or the bounds of the convention for Z) and W > 0; `None` if W = 0 (such a point is not
        /// inside).
        Inside = inside: Option<bool> => |point| Some(vec![f64::from(u8::from(point.inside?))]),
    }
}

part! {
    /// The ray through the centre of a pixel.
    RayReport,
    /// The ray through a pixel.
    RayNumber {
        /// (i, j).
        Pixel = pixel: [i64; 2] => |ray| Some(ray.pixel.map(|whole| whole as f64).to_vec()),
        /// Its origin, world.
        Origin = origin: [f64; 3] => |ray| Some(ray.origin.to_vec()),
        /// Unit vector, world.
        Direction = direction: [f64; 3] => |ray| Some(ray.direction.to_vec()),
    }
}

/// Numbers in rows. A number is 1 × 1, and a vector is a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// The number of columns.
    pub columns: usize,
    /// All numbers, row by row.
    pub entries: Vec<f64>,
}

fn column(values: impl IntoIterator<Item = f64>) -> Numbers {
    Numbers { columns: 1, entries: values.into_iter().collect() }
}

impl Quantity {
    /// Its numbers in a report; `None` if the report has none. A point behind the eye has no NDC.
    pub fn of(self, report: &Report) -> Option<Numbers> {
        let entries = match self {
            Self::Camera(key) => of_camera(&report.camera, key),
            Self::CameraSide(side) => side.numbers(report.camera.window.as_ref()?),
            Self::Direction => Some(report.dop.to_vec()),
            Self::Distance => Some(vec![report.distance]),
            Self::Axis(axis) => axis.numbers(&report.basis),
            Self::Window(number) => number.numbers(&report.window),
            Self::Lens(number) => number.numbers(report.lens.as_ref()?),
            Self::Matrix(matrix) => matrix.numbers(report),
            Self::Corner(index) => Some(report.volume_corners.get(index)?.to_vec()),
            Self::Plane(plane) => plane.numbers(&report.planes),
            Self::Point(index, number) => number.numbers(report.points.get(index)?),
            Self::Ray(index, number) => number.numbers(report.rays.get(index)?),
        };
        let columns = if matches!(self, Self::Matrix(_)) { 4 } else { 1 };
        Some(Numbers { columns, entries: entries? })
    }

    /// The quantity of a path. The rest of the path leads to entries of it.
    fn of_path<'a>(parts: &'a [&'a str]) -> Option<(Self, &'a [&'a str])> {
        let index = |part: &str| part.parse::<usize>().ok();
        Some(match parts {
            ["camera", "window", side, rest @ ..] => (Self::CameraSide(Side::of_name(side)?), rest),
            ["camera", key, rest @ ..] => {
                let key = ParameterKey::ALL.into_iter().find(|parameter| parameter.name() == *key)?;
                (Self::Camera(key), rest)
            }
            ["dop", rest @ ..] => (Self::Direction, rest),
            ["distance", rest @ ..] => (Self::Distance, rest),
            ["basis", axis, rest @ ..] => (Self::Axis(BasisAxis::of_name(axis)?), rest),
            ["window", number, rest @ ..] => (Self::Window(WindowNumber::of_name(number)?), rest),
            ["lens", number, rest @ ..] => (Self::Lens(LensNumber::of_name(number)?), rest),
            ["volume_corners", k, rest @ ..] => (Self::Corner(index(k)?), rest),
            ["planes", plane, rest @ ..] => (Self::Plane(VolumePlane::of_name(plane)?), rest),
            ["points", k, number, rest @ ..] => (Self::Point(index(k)?, PointNumber::of_name(number)?), rest),
            ["rays", k, number, rest @ ..] => (Self::Ray(index(k)?, RayNumber::of_name(number)?), rest),
            [matrix, rest @ ..] => (Self::Matrix(ReportMatrix::of_name(matrix)?), rest),
            [] => return None,
        })
    }
}

/// The numbers of a parameter of the camera.
fn of_camera(camera: &CameraReport, key: ParameterKey) -> Option<Vec<f64>> {
    Some(match key {
        ParameterKey::Position => camera.position.to_vec(),
        ParameterKey::FocalPoint => camera.focal_point.to_vec(),
        ParameterKey::ViewUp => camera.view_up.to_vec(),
        ParameterKey::ViewAngle => vec![camera.view_angle],
        ParameterKey::Height => vec![camera.height],
        ParameterKey::Aspect => vec![camera.aspect],
        ParameterKey::Near => vec![camera.near],
        ParameterKey::Far => vec![camera.far],
        ParameterKey::Window => return None,
    })
}

/// The path in the JSON of `inspect`.
impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Camera(key) => write!(f, "camera.{}", key.name()),
            Self::CameraSide(side) => write!(f, "camera.window.{}", side.name()),
            Self::Direction => f.write_str("dop"),
            Self::Distance => f.write_str("distance"),
            Self::Axis(axis) => write!(f, "basis.{}", axis.name()),
            Self::Window(number) => write!(f, "window.{}", number.name()),
            Self::Lens(number) => write!(f, "lens.{}", number.name()),
            Self::Matrix(matrix) => f.write_str(matrix.name()),
            Self::Corner(index) => write!(f, "volume_corners.{index}"),
            Self::Plane(plane) => write!(f, "planes.{}", plane.name()),
            Self::Point(index, number) => write!(f, "points.{index}.{}", number.name()),
            Self::Ray(index, number) => write!(f, "rays.{index}.{}", number.name()),
        }
    }
}

/// A quantity, or an entry of it: the target of a path in the JSON of `inspect`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct QuantityPath {
    /// A number, vector or matrix of `inspect`.
    pub quantity: Quantity,
    /// The row and the column; `None` means all.
    pub entry: [Option<usize>; 2],
}

impl From<Quantity> for QuantityPath {
    fn from(quantity: Quantity) -> Self {
        Self { quantity, entry: [None; 2] }
    }
}

impl QuantityPath {
    /// Reads a path, such as `basis.u`, `points.0.ndc` or `view_matrix.2.3`; `None` if there are no numbers under it
    /// in any report.
    pub fn of(path: &str) -> Option<Self> {
        let parts: Vec<&str> = path.split('.').collect();
        let (quantity, rest) = Quantity::of_path(&parts)?;
        let index = |part: &str| part.parse().ok();
        let entry = match rest {
            [] => [None; 2],
            [row] => [Some(index(row)?), None],
            [row, column] => [Some(index(row)?), Some(index(column)?)],
            _ => return None,
        };
        Some(Self { quantity, entry })
    }

    /// Its numbers in a report, if it has them.
    pub fn numbers(self, report: &Report) -> Option<Numbers> {
        let all = self.quantity.of(report)?;
        match (self.entry, all.columns) {
            ([None, _], _) => Some(all),
            ([Some(k), None], 1) => all.entries.get(k).map(|entry| column([*entry])),
            ([Some(row), None], columns) => all.entries.chunks(columns).nth(row).map(|row| column(row.iter().copied())),
            ([Some(row), Some(k)], columns) if columns > 1 => {
                all.entries.chunks(columns).nth(row)?.get(k).map(|entry| column([*entry]))
            }
            ([Some(_), Some(_)], _) => None,
        }
    }
}

impl fmt::Display for QuantityPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.quantity)?;
        self.entry.iter().flatten().try_for_each(|index| write!(f, ".{index}"))
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use serde_json::Value;

    use super::*;
    use crate::camera::{Convention, ViewWindow};
    use crate::figure::Figure;
    use glam::DVec3;

    /// Every path to a number or to numbers in a JSON value.
    fn paths(value: &Value, at: &str, found: &mut Vec<String>) {
        let join = |key: &str| if at.is_empty() { key.to_owned() } else { format!("{at}.{key}") };
        match value {
            Value::Number(_) | Value::Bool(_) => found.push(at.to_owned()),
            Value::Array(items) => {
                if items.iter().all(Value::is_number) {
                    found.push(at.to_owned());
                }
                items.iter().enumerate().for_each(|(i, item)| paths(item, &join(&i.to_string()), found));
            }
            Value::Object(entries) => entries.iter().for_each(|(key, entry)| paths(entry, &join(key), found)),
            Value::Null | Value::String(_) => {}
        }
    }

    fn numbers_at(value: &Value, path: &str) -> Vec<f64> {
        let step = |at: &Value, part: &str| match at {
            Value::Array(items) => items[part.parse::<usize>().unwrap()].clone(),
            other => other[part].clone(),
        };
        let found = path.split('.').fold(value.clone(), |at, part| step(&at, part));
        match &found {
            Value::Bool(is) => vec![f64::from(u8::from(*is))],
            Value::Array(items) => items.iter().map(|item| item.as_f64().unwrap()).collect(),
            number => vec![number.as_f64().unwrap()],
        }
    }

    #[test]
    fn every_number_of_the_json_is_a_quantity_with_that_path_and_that_value() {
        let window = ViewWindow { left: -1.0, right: 2.0, bottom: -0.5, top: 0.75 };
        for window in [None, Some(window)] {
            let mut figure = Figure::default();
            figure.camera.window = window;
            let points = [DVec3::ZERO, DVec3::new(0.3, 0.2, -0.1)];
            let report = Report::new(&figure, &[], Convention::RightHand, &points, &[[3, 4]]).unwrap();
            let json = serde_json::to_value(&report).unwrap();
            let mut all = Vec::new();
            paths(&json, "", &mut all);
            assert!(all.len() > 150, "{}", all.len());
            for path in all.iter().filter(|path| !path.starts_with("warnings")) {
                let Some(quantity) = QuantityPath::of(path) else {
                    assert_eq!(path, "volume_corners", "only the list of all corners is no quantity");
                    continue;
                };
                assert_eq!(quantity.to_string(), *path);
                assert_eq!(quantity.numbers(&report).unwrap().entries, numbers_at(&json, path), "{path}");
            }
        }
    }

    #[test]
    fn a_path_to_no_numbers_is_no_quantity() {
        for path in
            ["", "basis", "basis.w", "points.x.ndc", "points.0", "camera.projection", "view_matrix.0.1.2", "ndc"]
        {
            assert_eq!(QuantityPath::of(path), None, "{path}");
        }
        let report = Report::new(&Figure::default(), &[], Convention::RightHand, &[], &[]).unwrap();
        for path in
            ["points.0.ndc", "camera.window.left", "basis.u.3", "basis.u.0.0", "view_matrix.4", "volume_corners.8"]
        {
            assert_eq!(QuantityPath::of(path).and_then(|path| path.numbers(&report)), None, "{path}");
        }
    }
}
