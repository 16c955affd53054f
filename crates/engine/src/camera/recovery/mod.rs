//! A matrix → its camera: (5.7) and (5.13) to (5.16) read backwards, in any convention of NDC.
//!
//! Quantities that a matrix does not hold are taken from the present camera, and reported ([`Unknown`]): D (a direction
//! has no length), VUP (only **v** is known), and in parallel projection C along **n** (moving the eye along its line
//! of sight changes nothing).

mod matrix_text;
mod pinhole;
mod reading;
mod recognition;

pub use matrix_text::{MatrixEntries, MatrixTextError};
pub use reading::{Axes, MatrixKind, Reading};
pub use recognition::{Evidence, Recognised, Stated, recognise};

use glam::{DMat4, DVec3, DVec4};

use crate::camera::{Api, Camera, CameraError, Ndc, Parameters, Projection, ViewWindow};

/// A quantity that the matrix leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unknown {
    /// PF lies anywhere along DOP: D is the one that was there.
    FocalDistance,
    /// VUP is any vector above **v**: it is the one that was there where that fits, else **v**.
    ViewUp,
    /// C lies anywhere along **n**: F is the one that was there.
    PositionAlongNormal,
    /// Only where the window lies beside the axis *and* where C lies sideways together are known: the window is
    /// symmetric.
    WindowCentre,
    /// The far plane is at infinity: B is the one that was there.
    Far,
    /// Lens, F and B are those that were there.
    Lens,
    /// C, PF and VUP are those that were there.
    Pose,
    /// z is turned around beside that of the notes: the volume is the same, depth grows the other way.
    DepthDirection,
    /// The axes of the view are left-handed there: **n** is turned around.
    LeftHandedView,
    /// The axes are orthonormal only as far as their digits go: they were straightened.
    Rounded,
    /// The axes of a node have other lengths than 1: its scale was divided out.
    Scaled,
    /// z is up in the world of the matrix: that world was turned.
    WorldTurned,
    /// K \[R | t\] has no clipping planes: F and B are those that were there.
    ClippingPlanes,
    /// K \[R | t\] does not hold the size of the image: it is that of the reading.
    ImageSize,
    /// `f_x` and `f_y` differ: A is not m/n.
    PixelAspect,
    /// The pixels are rectangles only as far as the digits go: the skew was dropped.
    SkewDropped,
    /// The determinant is negative: all signs were reversed, as for a matrix that is known up to a factor.
    SignReversed,
}

impl Unknown {
    /// The name in the output of the command line.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::FocalDistance => "focal-distance",
            Self::ViewUp => "view-up",
            Self::PositionAlongNormal => "position-along-normal",
            Self::WindowCentre => "window-centre",
            Self::Far => "far",
            Self::Lens => "lens",
            Self::Pose => "pose",
            Self::DepthDirection => "depth-direction",
            Self::LeftHandedView => "left-handed",
            Self::Rounded => "rounded",
            Self::Scaled => "scaled",
            Self::WorldTurned => "world-turned",
            Self::ClippingPlanes => "clipping-planes",
            Self::ImageSize => "image-size",
            Self::PixelAspect => "pixel-aspect",
            Self::SkewDropped => "skew-dropped",
            Self::SignReversed => "sign-reversed",
        }
    }
}

/// The lines of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines {
    /// From left to right.
    Rows,
    /// From top to bottom.
    Columns,
}

impl Lines {
    const fn plural(self) -> &'static str {
        match self {
            Self::Rows => "rows",
            Self::Columns => "columns",
        }
    }

    const fn singular(self) -> &'static str {
        match self {
            Self::Rows => "row",
            Self::Columns => "column",
        }
    }
}

/// A camera's parameters from a matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Recovered {
    /// The parameters of the camera.
    pub parameters: Parameters,
    /// Quantities that the matrix left open, and other notices.
    pub unknown: Vec<Unknown>,
}

/// Why a matrix is not that of a camera.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RecoveryError {
    /// An entry is not a finite number.
    #[error("entry {row},{column} is not a finite number")]
    NotFinite {
        /// From 1.
        row: usize,
        /// From 1.
        column: usize,
    },
    /// The last row fits neither projection.
    #[error("the last row is {0}; a camera's is 0 0 0 1 (view, parallel) or, with its factor taken out, −n and n·c (perspective: 0 0 −1 0)", row(*.last))]
    LastRow {
        /// Its entries.
        last: DVec4,
    },
    /// Axes that must be perpendicular are not.
    #[error("{} {a} and {b} are not perpendicular (the cosine between them is {cosine:.2e}): a shear, which no camera has", .lines.plural())]
    Shear {
        /// The lines that hold the axes.
        lines: Lines,
        /// From 1.
        a: usize,
        /// From 1.
        b: usize,
        /// Of the angle.
        cosine: f64,
    },
    /// A row that must have the length 1 has another one.
    #[error("row {row} has length {length}; the rows of a view matrix are unit vectors")]
    Length {
        /// From 1.
        row: usize,
        /// Its length.
        length: f64,
    },
    /// An entry that must be zero is not.
    #[error("entry {row},{column} is {value}; in a projection matrix it is 0")]
    NotZero {
        /// From 1.
        row: usize,
        /// From 1.
        column: usize,
        /// The value of the entry.
        value: f64,
    },
    /// The image is mirrored.
    #[error("it mirrors: left and right, or up and down, are exchanged, which no camera does")]
    Mirrored,
    /// A line is zero.
    #[error("{} {at} is zero: the matrix is singular", .lines.singular())]
    Singular {
        /// Rows or columns.
        lines: Lines,
        /// From 1.
        at: usize,
    },
    /// Pixels that are parallelograms.
    #[error("K has a skew of {skew:.4} (f_x is {focal_length:.4}): its pixels are parallelograms, which no window has")]
    Skew {
        /// The second entry of K.
        skew: f64,
        /// `f_x`
        focal_length: f64,
    },
    /// The third row of K \[R | t\] holds no axis.
    #[error("the row of the depth is 0 0 0 w: an affine camera, whose centre is at infinity")]
    Affine,
    /// Near and far come out impossible in the convention.
    #[error("near and far would be {near} and {far}, which must be 0 < near < far{}", .fits.map_or_else(String::new, |ndc| format!("; read as {} it is a camera", ndc.name())))]
    Depths {
        /// F
        near: f64,
        /// B
        far: f64,
        /// A convention in which it would be a camera.
        fits: Option<Ndc>,
    },
    /// The result is not a camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
}

fn row(v: DVec4) -> String {
    format!("{} {} {} {}", v.x, v.y, v.z, v.w)
}

/// Beside 1: a matrix that was copied with three digits still passes.
pub(crate) const SLACK: f64 = 2e-3;
/// Errors below this are not reported: all digits of an `f64` are there.
pub(crate) const EXACT: f64 = 1e-9;

/// The camera of a matrix that acts on column vectors, as it is read. What the matrix does not hold comes from
/// `current`.
///
/// ```
/// use camera_lab_engine::camera::{MatrixKind, Parameters, Projection, Reading, recover};
/// use glam::DMat4;
///
/// // [0] Exercise 5.3: the camera whose view volume is the cube of NDC. The identity keeps z, which a camera
/// // turns around.
/// let found = recover(&Reading::of(MatrixKind::ViewProjection), DMat4::IDENTITY, &Parameters::default())?;
/// let p = found.parameters;
/// assert_eq!((p.projection, p.height, p.aspect), (Projection::Parallel, 2.0, 1.0));
/// assert_eq!(p.far - p.near, 2.0);
/// assert_eq!(p.position.z, 1.0 + p.near);
/// # Ok::<(), camera_lab_engine::camera::RecoveryError>(())
/// ```
///
/// # Errors
/// [`RecoveryError`] names the entry or row that no camera has.
pub fn recover(reading: &Reading, matrix: DMat4, current: &Parameters) -> Result<Recovered, RecoveryError> {
    for row in 0..4 {
        for column in 0..4 {
            if !matrix.row(row)[column].is_finite() {
                return Err(RecoveryError::NotFinite { row: row + 1, column: column + 1 });
            }
        }
    }
    let mut recovery = Recovery { current: *current, found: *current, reading: *reading, unknown: Vec::new() };
    match reading.kind {
        MatrixKind::View => recovery.view(matrix)?,
        MatrixKind::CameraToWorld => recovery.camera_to_world(matrix)?,
        MatrixKind::Projection => recovery.projection(matrix)?,
        MatrixKind::ViewProjection => recovery.both(matrix)?,
        MatrixKind::Pinhole => recovery.pinhole(matrix)?,
    }
    Camera::new(&recovery.found)?;
    recovery.unknown.sort();
    recovery.unknown.dedup();
    Ok(Recovered { parameters: recovery.found, unknown: recovery.unknown })
}

/// A camera on its way from its matrix.
pub(crate) struct Recovery {
    pub(crate) current: Parameters,
    pub(crate) found: Parameters,
    pub(crate) reading: Reading,
    pub(crate) unknown: Vec<Unknown>,
}

impl Recovery {
    fn view(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let mut rows = affine_rows(m)?;
        for (i, row) in rows.iter().enumerate() {
            let length = row.truncate().length();
            if (length - 1.0).abs() > SLACK {
                return Err(RecoveryError::Length { row: i + 1, length });
            }
        }
        if self.reading.axes == Axes::OpenCv {
            (rows[1], rows[2]) = (-rows[1], -rows[2]);
        }
        let [u, v, mut n] = self.straightened(Lines::Rows, rows.map(DVec4::truncate))?;
        let mut depth = rows[2].w;
        if u.cross(v).dot(n) < 0.0 {
            self.unknown.push(Unknown::LeftHandedView);
            (n, depth) = (-n, -depth);
        }
        let position = -(u * rows[0].w + v * rows[1].w + n * depth);
        self.pose(position, v, n);
        self.unknown.push(Unknown::Lens);
        Ok(())
    }

    /// C and the axes are the columns; an object may be scaled as well.
    fn camera_to_world(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let rows = affine_rows(m)?;
        let column = |i: usize| DVec3::new(rows[0][i], rows[1][i], rows[2][i]);
        let axes = [0, 1, 2].map(column);
        let [u, mut v, mut n] = self.straightened(Lines::Columns, axes)?;
        let error = axes.iter().map(|axis| (axis.length() - 1.0).abs()).fold(0.0, f64::max);
        if error > SLACK {
            self.unknown.push(Unknown::Scaled);
        } else if error > EXACT {
            self.unknown.push(Unknown::Rounded);
        }
        if self.reading.axes == Axes::OpenCv {
            (v, n) = (-v, -n);
        }
        if u.cross(v).dot(n) < 0.0 {
            self.unknown.push(Unknown::LeftHandedView);
            n = -n;
        }
        self.pose(column(3), v, n);
        self.unknown.push(Unknown::Lens);
        Ok(())
    }

    /// Unit vectors at right angles, where the rows are that up to their digits.
    fn straightened(&mut self, lines: Lines, rows: [DVec3; 3]) -> Result<[DVec3; 3], RecoveryError> {
        for (i, row) in rows.iter().enumerate() {
            if row.length() == 0.0 {
                return Err(RecoveryError::Singular { lines, at: i + 1 });
            }
        }
        let units = rows.map(DVec3::normalize);
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let cosine = units[a].dot(units[b]);
            if cosine.abs() > SLACK {
                return Err(RecoveryError::Shear { lines, a: a + 1, b: b + 1, cosine });
            }
            if cosine.abs() > EXACT {
                self.unknown.push(Unknown::Rounded);
            }
        }
        let n = units[2];
        let u = (units[0] - n * units[0].dot(n)).normalize();
        let v = units[1] - n * units[1].dot(n);
        Ok([u, (v - u * v.dot(u)).normalize(), n])
    }

    /// C, and PF and VUP as far as they were right.
    pub(crate) fn pose(&mut self, position: DVec3, v: DVec3, n: DVec3) {
        let [position, v, n] = if self.reading.axes == Axes::Blender {
            self.unknown.push(Unknown::WorldTurned);
            [position, v, n].map(with_y_up)
        } else {
            [position, v, n]
        };
        let distance = (self.current.focal_point - self.current.position).length();
        let up = self.current.view_up;
        let above = up - n * up.dot(n);
        self.found.position = position;
        self.found.focal_point = position - n * distance;
        let fits = above.length() > 1e-6 * up.length() && above.normalize().dot(v) > 1.0 - 1e-12;
        self.found.view_up = if fits { up } else { v };
        self.unknown.extend([Unknown::FocalDistance, Unknown::ViewUp]);
    }

    fn projection(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        let rows = [m.row(0), m.row(1), m.row(2)];
        let size = rows.iter().map(|row| row.abs().max_element()).fold(last.abs().max_element(), f64::max);
        let perspective = last.z.abs() > SLACK * last.abs().max_element();
        let others = if perspective { [last.x, last.y, last.w] } else { [last.x, last.y, last.z] };
        if others.iter().any(|x| x.abs() > SLACK * last.abs().max_element()) || last == DVec4::ZERO {
            return Err(RecoveryError::LastRow { last });
        }
        let kept = if perspective { [[0, 2], [1, 2], [2, 3]] } else { [[0, 3], [1, 3], [2, 3]] };
        for (i, (row, kept)) in rows.iter().zip(kept).enumerate() {
            for column in (0..4).filter(|column| !kept.contains(column)) {
                if row[column].abs() > SLACK * size {
                    return Err(RecoveryError::NotZero { row: i + 1, column: column + 1, value: row[column] });
                }
            }
        }
        self.unknown.push(Unknown::Pose);
        if perspective {
            let [x, y, z] = rows.map(|row| row / -last.z);
            self.perspective([x.x, y.y], [x.z, y.z], z.z, z.w)
        } else {
            let [x, y, z] = rows.map(|row| row / last.w);
            let near = self.near_in_parallel(z.z, z.w)?;
            self.parallel([x.x, y.y], [x.w, y.w], z.z, near)
        }
    }

    fn both(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        let axis = last.truncate().length();
        let largest = (0..3).map(|i| m.row(i).truncate().length()).fold(0.0, f64::max);
        // A perspective's last row is as long as 1 beside 2F/W and the like; one that is only noise has no direction.
        if axis > 1e-9 * largest.max(last.w.abs()) { self.both_perspective(m / axis) } else { self.both_parallel(m) }
    }

    fn both_perspective(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        let n = -last.truncate();
        let rows = [m.row(0), m.row(1), m.row(2)];
        let skew = [0, 1].map(|i| rows[i].truncate().dot(n));
        let across = [0, 1].map(|i: usize| rows[i].truncate() - n * skew[i]);
        let [u, mut v, _] = self.straightened(Lines::Rows, [across[0], across[1], n])?;
        let scale = [u.dot(rows[0].truncate()), v.dot(rows[1].truncate())];
        if self.reading.ndc.y_points_down() {
            v = -v;
        }
        if u.cross(v).dot(n) < 0.0 {
            return Err(RecoveryError::Mirrored);
        }
        let deep = rows[2].truncate();
        let z = deep.dot(n);
        if (deep - n * z).length() > SLACK * deep.length().max(EXACT) && deep.length() > EXACT {
            return Err(RecoveryError::Shear {
                lines: Lines::Rows,
                a: 3,
                b: 4,
                cosine: (deep - n * z).length() / deep.length(),
            });
        }
        // n·c, then the rest of the constants of the first two rows.
        let along = last.w;
        let down = if self.reading.ndc.y_points_down() { -1.0 } else { 1.0 };
        let [x_c, y_c] = [(-rows[0].w - skew[0] * along) / scale[0], (-rows[1].w - skew[1] * along) / scale[1] * down];
        let position = u * x_c + v * y_c + n * along;
        self.pose(position, v, n);
        self.perspective([scale[0], down * scale[1]], skew, z, rows[2].w + z * along)
    }

    fn both_parallel(&mut self, m: DMat4) -> Result<(), RecoveryError> {
        let last = m.row(3);
        if last.w == 0.0 {
            return Err(RecoveryError::LastRow { last });
        }
        let rows = [0, 1, 2].map(|i| m.row(i) / last.w);
        let [u, v, deep] = self.straightened(Lines::Rows, rows.map(DVec4::truncate))?;
        let v = if self.reading.ndc.y_points_down() { -v } else { v };
        let n = u.cross(v);
        let mut z = deep.dot(n) * rows[2].truncate().length();
        let mut constant = rows[2].w;
        let [at_near, at_far] = self.reading.ndc.depths();
        // z_n grows away from the viewer, from z₀ to z₁.
        if z * (at_near - at_far) < 0.0 {
            self.unknown.push(Unknown::DepthDirection);
            (z, constant) = (-z, at_near + at_far - constant);
        }
        let scale = [rows[0].truncate().length(), rows[1].truncate().length()];
        let down = if self.reading.ndc.y_points_down() { -1.0 } else { 1.0 };
        let near = self.current.near;
        let along = (at_near + z * near - constant) / z;
        let position = u * (-rows[0].w / scale[0]) + v * (-rows[1].w * down / scale[1]) + n * along;
        self.pose(position, v, n);
        self.unknown.extend([Unknown::PositionAlongNormal, Unknown::WindowCentre]);
        self.parallel([scale[0], down * scale[1]], [0.0, 0.0], z, near)
    }

    /// Window, F and B from the entries of (5.13).
    fn perspective(
        &mut self,
        [x, y]: [f64; 2],
        [skew_x, skew_y]: [f64; 2],
        z: f64,
        depth: f64,
    ) -> Result<(), RecoveryError> {
        let (y, skew_y) = if self.reading.ndc.y_points_down() { (-y, -skew_y) } else { (y, skew_y) };
        if x <= 0.0 || y <= 0.0 {
            return Err(RecoveryError::Mirrored);
        }
        let (near, far) = self.planes(z, depth)?;
        self.found.projection = Projection::Perspective;
        (self.found.near, self.found.far) = (near, far);
        let (width, height) = (2.0 * near / x, 2.0 * near / y);
        self.window([width, height], [skew_x * width / 2.0, skew_y * height / 2.0]);
        Ok(())
    }

    /// F and B: z_n is z₀ at F and z₁ at B, so that F = d/(z + z₀), B = d/(z + z₁).
    fn planes(&mut self, z: f64, depth: f64) -> Result<(f64, f64), RecoveryError> {
        let of = |ndc: Ndc| {
            let [at_near, at_far] = ndc.depths();
            (depth / (z + at_near), depth / (z + at_far))
        };
        let is_possible = |(near, far): (f64, f64)| near > 0.0 && near.is_finite() && near < far && far.is_finite();
        let (near, far) = of(self.reading.ndc);
        // Beyond what 1 − F/B can hold in an f64, B is lost.
        if near > 0.0 && near.is_finite() && !(far > 0.0 && far < near * 1e15) {
            let [_, at_far] = self.reading.ndc.depths();
            if (z + at_far).abs() <= 1e-14 {
                self.unknown.push(Unknown::Far);
                return Ok((near, self.current.far.max(near * 2.0)));
            }
        }
        if is_possible((near, far)) {
            return Ok((near, far));
        }
        let fits = conventions().find(|ndc| is_possible(of(*ndc)));
        Err(RecoveryError::Depths { near, far, fits })
    }

    fn near_in_parallel(&mut self, z: f64, depth: f64) -> Result<f64, RecoveryError> {
        let [at_near, at_far] = self.reading.ndc.depths();
        if z == 0.0 {
            return Err(RecoveryError::Singular { lines: Lines::Rows, at: 3 });
        }
        let (near, far) = ((depth - at_near) / z, (depth - at_far) / z);
        if near > 0.0 && near < far {
            return Ok(near);
        }
        let possible = |ndc: &Ndc| {
            let [at_near, at_far] = ndc.depths();
            let (near, far) = ((depth - at_near) / z, (depth - at_far) / z);
            near > 0.0 && near < far
        };
        Err(RecoveryError::Depths { near, far, fits: conventions().find(possible) })
    }

    fn parallel(
        &mut self,
        [x, y]: [f64; 2],
        [shift_x, shift_y]: [f64; 2],
        z: f64,
        near: f64,
    ) -> Result<(), RecoveryError> {
        let down = self.reading.ndc.y_points_down();
        let (y, shift_y) = if down { (-y, -shift_y) } else { (y, shift_y) };
        if x <= 0.0 || y <= 0.0 {
            return Err(RecoveryError::Mirrored);
        }
        let [at_near, at_far] = self.reading.ndc.depths();
        self.found.projection = Projection::Parallel;
        self.found.near = near;
        self.found.far = near + (at_near - at_far) / z;
        self.window([2.0 / x, 2.0 / y], [-shift_x / x, -shift_y / y]);
        Ok(())
    }

    /// A window of a size around a middle; a symmetric one as angle or height and aspect.
    pub(crate) fn window(&mut self, [width, height]: [f64; 2], [middle_x, middle_y]: [f64; 2]) {
        let symmetric = middle_x.abs() <= EXACT * width && middle_y.abs() <= EXACT * height;
        if symmetric {
            self.found.window = None;
            self.found.aspect = width / height;
            match self.found.projection {
                Projection::Perspective => {
                    self.found.view_angle = 2.0 * (height / 2.0).atan2(self.found.near).to_degrees();
                }
                Projection::Parallel => self.found.height = height,
            }
        } else {
            self.found.window = Some(ViewWindow {
                left: middle_x - width / 2.0,
                right: middle_x + width / 2.0,
                bottom: middle_y - height / 2.0,
                top: middle_y + height / 2.0,
            });
        }
    }
}

/// The first three rows of a matrix whose last one is 0 0 0 1, up to a factor.
fn affine_rows(m: DMat4) -> Result<[DVec4; 3], RecoveryError> {
    let last = m.row(3);
    if last.truncate().length() > SLACK * last.w.abs() || last.w == 0.0 {
        return Err(RecoveryError::LastRow { last });
    }
    Ok([0, 1, 2].map(|i| m.row(i) / last.w))
}

/// A vector of a world whose z is up, in one whose y is: as exporters of glTF turn it.
fn with_y_up(p: DVec3) -> DVec3 {
    DVec3::new(p.x, p.z, -p.y)
}

/// The conventions that a matrix may be in, those of the libraries themselves first.
fn conventions() -> impl Iterator<Item = Ndc> {
    let of_others = |ndc: &Ndc| !(ndc.infinite || ndc.api == Api::OpenGl && ndc.reversed);
    Ndc::ALL.into_iter().filter(of_others)
}
