//! The pair of the figure's camera and another one: what a point in one image says about the other image.

use glam::{DMat3, DVec2, DVec3};
use serde::Serialize;

use super::{three, unsigned};
use crate::camera::{Axes, Camera, ImageSize, Projection};

/// The figure's camera (*here*) and one of its `[[cameras]]` (*there*). Pixels are from the top left corner, y down.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PairReport {
    /// As the author named the camera.
    pub name: String,
    /// From C here to C there, world.
    pub baseline: [f64; 3],
    /// E, rows, for directions with x to the right, y down and z ahead, so that E = \[t\]× R; `None` if a projection is
    /// parallel.
    pub essential: Option<[[f64; 3]; 3]>,
    /// F, rows, of norm 1: `x_there`ᵀ F x = 0; `None` if both have one centre.
    pub fundamental: Option<[[f64; 3]; 3]>,
    /// The pixel of C there in the image here; `None` at infinity.
    pub epipole: Option<[f64; 2]>,
    /// The pixel of C here in the image there; `None` at infinity.
    pub epipole_there: Option<[f64; 2]>,
    /// Of the requested points.
    pub lines: Vec<LinesReport>,
}

/// The epipolar lines of a point, a, b, c with a x + b y + c = 0 and a² + b² = 1; `None` if it has none.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LinesReport {
    /// World.
    pub point: [f64; 3],
    /// That of its pixel there.
    pub here: Option<[f64; 3]>,
    /// That of its pixel here.
    pub there: Option<[f64; 3]>,
    /// The column here less the column there; `None` if it has no pixel in one of them.
    pub disparity: Option<f64>,
}

/// One camera of a pair.
struct Eye<'a> {
    camera: &'a Camera,
    /// Rows: to the right, down, ahead.
    turn: DMat3,
    /// K. In parallel projection the third coordinate of its argument is 1.
    pixel_from_view: DMat3,
}

impl<'a> Eye<'a> {
    fn new(camera: &'a Camera, image: ImageSize) -> Self {
        let [f_x, f_y, x, y] = camera.intrinsics(image);
        let columns = [DVec3::X * f_x, DVec3::Y * f_y, DVec3::new(x, y, 1.0)];
        let turn = DMat3::from_mat4(Axes::OPENCV.view_from_world(camera));
        Self { camera, turn, pixel_from_view: DMat3::from_cols_array_2d(&columns.map(|column| column.to_array())) }
    }

    fn is_parallel(&self) -> bool {
        self.camera.projection() == Projection::Parallel
    }

    /// A vector of the world, from C if it's the one to a point, on its way to the pixel, homogeneous.
    fn seen(&self, v: DVec3, is_point: bool) -> DVec3 {
        let v = self.turn * v;
        if self.is_parallel() { v.with_z(f64::from(u8::from(is_point))) } else { v }
    }

    /// The centre of another camera: C, or the direction of the projectors if these are parallel. 0 if it's the same.
    fn epipole(&self, other: &Self) -> DVec3 {
        let (own, there) = (self.camera.position(), other.camera.position());
        let seen = if other.is_parallel() {
            self.seen(other.camera.direction_of_projection(), false)
        } else {
            self.seen(there - own, true)
        };
        // Zero up to the rounding of the coordinates.
        let size = if other.is_parallel() { 1.0 } else { own.abs().max(there.abs()).max_element().max(seen.length()) };
        DVec3::from_array(seen.to_array().map(|x| if x.abs() <= 1e-14 * size { 0.0 } else { x }))
    }

    fn pixel(&self, seen: DVec3) -> Option<DVec2> {
        let p = self.pixel_from_view * seen;
        (p.z != 0.0).then(|| p.truncate() / p.z).filter(|p| p.is_finite())
    }
}

fn cross(v: DVec3) -> DMat3 {
    DMat3::from_cols(DVec3::new(0.0, v.z, -v.y), DVec3::new(-v.z, 0.0, v.x), DVec3::new(v.y, -v.x, 0.0))
}

fn rows(m: DMat3) -> [[f64; 3]; 3] {
    m.transpose().to_cols_array_2d().map(|row| row.map(unsigned))
}

impl PairReport {
    pub(super) fn new(name: &str, cameras: [&Camera; 2], image: ImageSize, points: &[DVec3]) -> Self {
        let [here, there] = cameras.map(|camera| Eye::new(camera, image));
        let baseline = there.camera.position() - here.camera.position();
        // What the projector of each unit of x, y and 1 here is there.
        let projector = |k: usize| {
            let direction = here.turn.transpose().col(k);
            match (here.is_parallel(), k) {
                (true, 2) => there.seen(-baseline, true),
                _ => there.seen(direction, false),
            }
        };
        let [x, y, z] = [0, 1, 2].map(projector);
        let [epipole, epipole_there] = [here.epipole(&there), there.epipole(&here)];
        let essential = cross(epipole_there) * DMat3::from_cols(x, y, z);
        let fundamental = there.pixel_from_view.inverse().transpose() * essential * here.pixel_from_view.inverse();
        let norm = fundamental.to_cols_array().into_iter().fold(0.0, f64::hypot);
        let fundamental = Some(fundamental * norm.recip()).filter(|f| norm > 0.0 && f.is_finite());
        let line = |m: Option<DMat3>, p: Option<DVec2>| {
            let line = m? * p?.extend(1.0);
            Some(three(line / line.truncate().length())).filter(|line| line.iter().all(|x| x.is_finite()))
        };
        let lines = points.iter().map(|p| {
            let [a, b] = [&here, &there].map(|eye| eye.pixel(eye.seen(*p - eye.camera.position(), true)));
            LinesReport {
                point: three(*p),
                here: line(fundamental.map(|f| f.transpose()), b),
                there: line(fundamental, a),
                disparity: a.zip(b).map(|(a, b)| unsigned(a.x - b.x)),
            }
        });
        let place = |eye: &Eye<'_>, epipole| eye.pixel(epipole).map(|p| p.to_array().map(unsigned));
        Self {
            name: name.to_owned(),
            baseline: three(baseline),
            essential: (!here.is_parallel() && !there.is_parallel()).then(|| rows(essential)),
            fundamental: fundamental.map(rows),
            epipole: place(&here, epipole),
            epipole_there: place(&there, epipole_there),
            lines: lines.collect(),
        }
    }
}
