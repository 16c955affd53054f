//! Every number of a figure, as the command line prints it and the window shows it.

mod asked;
mod bounds;
mod pairs;
pub mod quantity;

use glam::{DMat4, DVec2, DVec3};
use serde::{Serialize, Serializer};
use serde_json::Value;

use crate::camera::{
    Basis, Camera, CameraError, ClipSpace, Convention, ImageSize, InfiniteParallel, LensNumbers, Ndc, NotProjectable,
    Operation, Parameters, Stations, ViewWindow, Viewport, Warning,
};
use crate::figure::words::{self, PROJECTIONS};
use crate::figure::{Figure, NamedCamera};
use crate::geometry::Plane;
use crate::sanitize;
pub use asked::Asked;
pub use bounds::{Bounds, Conditions, proved_digits};
pub use pairs::{LinesReport, PairReport};
pub use quantity::{BasisReport, LensReport, PlanesReport, PointReport, RayReport, SidesReport, WindowReport};

/// The output of `camera-lab inspect`. The order of the fields is the order of the keys.
///
/// *Guarantees*: every number is finite, and zero has no sign. Written as JSON, a number reads back as the same `f64`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The camera's parameters after the operations, under the names of the figure file.
    pub camera: CameraReport,
    /// DOP.
    pub dop: [f64; 3],
    /// D.
    pub distance: f64,
    /// **u**, **v**, **n**.
    pub basis: BasisReport,
    /// The view window on the plane z_c = −F.
    pub window: WindowReport,
    /// The lens in other words than θ; `None` in parallel projection, whose projectors span no angle.
    pub lens: Option<LensReport>,
    /// The convention of NDC: [`Ndc::name`](crate::camera::Ndc::name). The derived M_p, clip coordinates and NDC are
    /// in it.
    pub ndc: &'static str,
    /// M_v, rows.
    pub view_matrix: [[f64; 4]; 4],
    /// M_p, rows.
    pub projection_matrix: [[f64; 4]; 4],
    /// M_p M_v, rows.
    pub view_projection_matrix: [[f64; 4]; 4],
    /// The inverse of M_v, rows.
    pub inverse_view_matrix: [[f64; 4]; 4],
    /// The inverse of M_p, rows.
    pub inverse_projection_matrix: [[f64; 4]; 4],
    /// Near (l,b) (r,b) (r,t) (l,t), then far in the same order.
    pub volume_corners: [[f64; 3]; 8],
    /// The planes of the view volume.
    pub planes: PlanesReport,
    /// `[[cameras]]`. The key is left out if the figure has none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub cameras: Vec<NamedCameraReport>,
    /// The camera with each of `[[cameras]]`. The key is left out if the figure has none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<PairReport>,
    /// The requested points.
    pub points: Vec<PointReport>,
    /// The rays through the requested pixels.
    pub rays: Vec<RayReport>,
    /// Warnings about a camera that's possible, but probably unintended.
    pub warnings: Vec<WarningReport>,
}

/// The keys of `[camera]`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraReport {
    /// C.
    pub position: [f64; 3],
    /// PF.
    pub focal_point: [f64; 3],
    /// VUP.
    pub view_up: [f64; 3],
    /// `perspective` or `parallel`.
    pub projection: &'static str,
    /// θ, degrees.
    pub view_angle: f64,
    /// H.
    pub height: f64,
    /// A.
    pub aspect: f64,
    /// F.
    pub near: f64,
    /// B.
    pub far: f64,
    /// l, r, b, t, if they're given instead of angle, height and aspect.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub window: Option<SidesReport>,
}

/// One of the `[[cameras]]`: its name, the keys of `camera`, and the numbers that follow from them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedCameraReport {
    /// As the author named the point.
    pub name: String,
    /// `#rrggbb`, if the figure gives one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub color: Option<String>,
    /// The keys of `camera`.
    #[serde(flatten)]
    pub camera: CameraReport,
    /// D.
    pub distance: f64,
    /// **u**, **v**, **n**
    pub basis: BasisReport,
    /// M_v, rows.
    pub view_matrix: [[f64; 4]; 4],
    /// M_p, rows, in the convention of the report.
    pub projection_matrix: [[f64; 4]; 4],
}

impl NamedCameraReport {
    /// The numbers of a camera.
    fn new(named: &NamedCamera, ndc: Ndc) -> Result<Self, InspectError> {
        let camera = Camera::new(&named.parameters)?;
        let space = camera.clip_space(ndc)?;
        Ok(Self {
            name: named.name.clone(),
            color: named.color.map(|color| color.to_string()),
            camera: CameraReport::new(&named.parameters),
            distance: camera.distance(),
            basis: camera.basis().into(),
            view_matrix: rows(camera.view_from_world()),
            projection_matrix: rows(space.clip_from_view()),
        })
    }
}

impl From<ViewWindow> for SidesReport {
    fn from(window: ViewWindow) -> Self {
        let ViewWindow { left, right, bottom, top } = window.map(unsigned);
        Self { left, right, bottom, top }
    }
}

impl From<Basis> for BasisReport {
    fn from(Basis { u, v, n }: Basis) -> Self {
        Self { u: three(u), v: three(v), n: three(n) }
    }
}

impl From<LensNumbers> for LensReport {
    fn from(LensNumbers { horizontal_angle, diagonal_angle, focal_length_pixels }: LensNumbers) -> Self {
        Self { horizontal_angle, diagonal_angle, focal_length_pixels }
    }
}

impl PlanesReport {
    fn new(camera: &Camera) -> Self {
        // As the report guarantees, zero has no sign.
        let four = |plane: Plane| plane.normal.extend(plane.offset).to_array().map(|x| x + 0.0);
        let [left, right, bottom, top, near, far] = camera.volume_planes().map(four);
        Self { left, right, bottom, top, near, far }
    }
}

/// A warning in English, with its code.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WarningReport {
    /// [`Warning::code`].
    pub code: &'static str,
    /// One sentence.
    pub message: String,
}

/// A whole number that may be too great for an integer type. Written without a fraction if JSON readers keep it whole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Whole(pub f64);

impl Serialize for Whole {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        const EXACT: f64 = 9_007_199_254_740_992.0;
        if self.0.abs() <= EXACT {
            #[expect(clippy::cast_possible_truncation, reason = "whole numbers up to 2^53 are exact in both types")]
            let whole = self.0 as i64;
            serializer.serialize_i64(whole)
        } else {
            serializer.serialize_f64(self.0)
        }
    }
}

/// The reason why there's no report.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum InspectError {
    /// The figure's camera is impossible.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// An operation has no result.
    #[error("operation {operation}: {error}")]
    Operation {
        /// The operation.
        operation: Operation,
        /// The reason.
        error: CameraError,
    },
    /// The camera has no matrices in the convention of NDC.
    #[error(transparent)]
    InfiniteParallel(#[from] InfiniteParallel),
    /// A point has coordinates that `f64` can't hold.
    #[error("point {},{},{}: its coordinates in {space} would exceed the range of numbers (about 1e-308 to 1e308)", point.x, point.y, point.z)]
    Point {
        /// The point, world.
        point: DVec3,
        /// The first space that can't hold it.
        space: &'static str,
    },
    /// A pixel with a depth that belongs to no point.
    #[error("depth pixel {},{}: {error}", pixel[0], pixel[1])]
    DepthPixel {
        /// (i, j).
        pixel: [i64; 2],
        /// The reason.
        error: NotProjectable,
    },
    /// A pixel has a ray that `f64` can't hold, or the image has no pixels.
    #[error("pixel {},{}: its ray would exceed the range of numbers (about 1e-308 to 1e308)", pixel[0], pixel[1])]
    Pixel {
        /// (i, j).
        pixel: [i64; 2],
    },
}

/// Applies `operations` in the order given.
///
/// # Errors
/// [`InspectError`] for a fault of the camera or of an operation.
pub fn camera_after(
    parameters: &Parameters,
    operations: &[Operation],
    convention: Convention,
) -> Result<Camera, InspectError> {
    operations.iter().try_fold(Camera::new(parameters)?, |camera, operation| {
        operation.apply(&camera, convention).map_err(|error| InspectError::Operation { operation: *operation, error })
    })
}

impl Report {
    /// The numbers of `figure` after `operations`, with `points` (world) and rays through `pixels`.
    ///
    /// # Errors
    /// [`InspectError`] names the impossible value.
    pub fn new(
        figure: &Figure,
        operations: &[Operation],
        convention: Convention,
        points: &[DVec3],
        pixels: &[[i64; 2]],
    ) -> Result<Self, InspectError> {
        let camera = camera_after(&figure.camera, operations, convention)?;
        let space = camera.notes_clip_space();
        Self::of(&space, figure.image, figure.viewport, points, pixels)?.with_cameras(figure, &space, points)
    }

    /// Adds the other cameras of the figure, in the convention of NDC of its own, and each as a pair with that.
    ///
    /// # Errors
    /// [`InspectError`] if one of them has no matrices in it.
    pub fn with_cameras(
        mut self,
        figure: &Figure,
        space: &ClipSpace<'_>,
        points: &[DVec3],
    ) -> Result<Self, InspectError> {
        for named in &figure.cameras {
            self.cameras.push(NamedCameraReport::new(named, space.ndc())?);
            let there = Camera::new(&named.parameters)?;
            self.pairs.push(PairReport::new(&named.name, [space.camera(), &there], figure.image, points));
        }
        Ok(self)
    }

    /// The numbers of a camera in a convention of NDC. Without a viewport it's the whole image, depth 0 … 1.
    ///
    /// # Errors
    /// [`InspectError`] names the point or the pixel whose numbers `f64` can't hold.
    pub fn of(
        clip_space: &ClipSpace<'_>,
        image: ImageSize,
        viewport: Option<Viewport>,
        points: &[DVec3],
        pixels: &[[i64; 2]],
    ) -> Result<Self, InspectError> {
        let camera = clip_space.camera();
        let viewport = viewport.unwrap_or_else(|| Viewport::whole(image));
        let SidesReport { left, right, bottom, top } = camera.window().into();
        Ok(Self {
            camera: CameraReport::new(camera.parameters()),
            dop: three(camera.direction_of_projection()),
            distance: camera.distance(),
            basis: camera.basis().into(),
            window: WindowReport {
                left,
                right,
                bottom,
                top,
                width: camera.window_width(),
                height: camera.window_height(),
                aspect: camera.window_aspect(),
            },
            lens: camera.lens_numbers(image).map(LensReport::from),
            ndc: clip_space.ndc().name(),
            view_matrix: rows(camera.view_from_world()),
            projection_matrix: rows(clip_space.clip_from_view()),
            view_projection_matrix: rows(clip_space.clip_from_world()),
            inverse_view_matrix: rows(camera.world_from_view()),
            inverse_projection_matrix: rows(clip_space.view_from_clip()),
            volume_corners: camera.volume_corners().map(three),
            planes: PlanesReport::new(camera),
            cameras: Vec::new(),
            pairs: Vec::new(),
            points: points
                .iter()
                .map(|point| PointReport::new(&clip_space.stations(*point, image, &viewport)))
                .collect::<Result<_, _>>()?,
            rays: pixels.iter().map(|pixel| RayReport::new(camera, image, *pixel)).collect::<Result<_, _>>()?,
            warnings: camera
                .warnings()
                .into_iter()
                .chain(camera.aspect_warning(image))
                .map(|warning| WarningReport::new(&warning))
                .collect(),
        })
    }

    /// One JSON object, indented, vectors and rows on one line, with a line break at its end.
    pub fn to_json(&self) -> String {
        // Everything in a report can become a JSON value.
        json_text(&serde_json::to_value(self).unwrap_or_default())
    }
}

/// A JSON value in the form of reports: indented, vectors and rows on one line, with a line break at its end.
pub fn json_text(value: &Value) -> String {
    let mut text = String::new();
    write_json(&mut text, value, "");
    text.push('\n');
    for_terminals(&text)
}

/// The same JSON with escapes for the characters in its texts that a terminal would obey. Programs read the same texts.
pub fn for_terminals(json: &str) -> String {
    let mut text = String::with_capacity(json.len());
    for c in json.chars() {
        if c != '\n' && sanitize::is_obeyed(c) {
            let units = c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")).collect::<String>();
            text.push_str(&units);
        } else {
            text.push(c);
        }
    }
    text
}

fn write_json(text: &mut String, value: &Value, indent: &str) {
    let deeper = format!("{indent}  ");
    let mut list = |open, close, items: &mut dyn Iterator<Item = (Option<&String>, &Value)>| {
        text.push(open);
        for (i, (key, item)) in items.enumerate() {
            text.push_str(if i == 0 { "\n" } else { ",\n" });
            text.push_str(&deeper);
            if let Some(key) = key {
                text.push_str(&format!("{}: ", Value::from(key.as_str())));
            }
            write_json(text, item, &deeper);
        }
        text.push('\n');
        text.push_str(indent);
        text.push(close);
    };
    match value {
        Value::Object(fields) => list('{', '}', &mut fields.iter().map(|(key, item)| (Some(key), item))),
        Value::Array(items) if items.iter().any(|item| item.is_array() || item.is_object()) => {
            list('[', ']', &mut items.iter().map(|item| (None, item)));
        }
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(Value::to_string).collect();
            text.push_str(&format!("[{}]", items.join(", ")));
        }
        scalar => text.push_str(&scalar.to_string()),
    }
}

impl CameraReport {
    /// The keys of these parameters.
    pub fn new(p: &Parameters) -> Self {
        Self {
            position: three(p.position),
            focal_point: three(p.focal_point),
            view_up: three(p.view_up),
            projection: words::name(PROJECTIONS, p.projection),
            view_angle: p.view_angle,
            height: p.height,
            aspect: p.aspect,
            near: p.near,
            far: p.far,
            window: p.window.map(SidesReport::from),
        }
    }
}

impl PointReport {
    fn new(s: &Stations) -> Result<Self, InspectError> {
        let check = |finite: bool, space| {
            if finite { Ok(()) } else { Err(InspectError::Point { point: s.world, space }) }
        };
        check(s.world.is_finite(), "the world")?;
        check(s.view.is_finite(), "view")?;
        check(s.clip.is_finite(), "clip")?;
        if let Some(p) = s.projected {
            check(p.ndc.is_finite(), "ndc")?;
            check(p.window.is_finite(), "window")?;
            check(p.pixel.is_finite(), "pixel")?;
            check(p.viewport.is_finite(), "viewport")?;
        }
        Ok(Self {
            world: three(s.world),
            view: three(s.view),
            clip: s.clip.to_array().map(unsigned),
            ndc: s.projected.map(|p| three(p.ndc)),
            window: s.projected.map(|p| p.window.to_array().map(unsigned)),
            pixel: s.projected.map(|p| wholes(p.pixel)),
            viewport: s.projected.map(|p| {
                let [x, y] = wholes(p.viewport.truncate());
                (x, y, unsigned(p.viewport.z))
            }),
            inside: s.projected.map(|_| s.inside),
        })
    }
}

impl RayReport {
    fn new(camera: &Camera, image: ImageSize, pixel: [i64; 2]) -> Result<Self, InspectError> {
        let ray = camera.ray_through_pixel(image, pixel[0], pixel[1]);
        if !(ray.origin.is_finite() && ray.direction.is_finite()) {
            return Err(InspectError::Pixel { pixel });
        }
        Ok(Self { pixel, origin: three(ray.origin), direction: three(ray.direction) })
    }
}

impl WarningReport {
    fn new(warning: &Warning) -> Self {
        Self { code: warning.code(), message: warning.to_string() }
    }
}

/// −0 is 0.
fn unsigned(x: f64) -> f64 {
    x + 0.0
}

fn three(v: DVec3) -> [f64; 3] {
    v.to_array().map(unsigned)
}

fn wholes(v: DVec2) -> [Whole; 2] {
    v.to_array().map(|x| Whole(unsigned(x)))
}

fn rows(m: DMat4) -> [[f64; 4]; 4] {
    m.transpose().to_cols_array_2d().map(|row| row.map(unsigned))
}
