//! The kind and the axes of a matrix of another program, where they are not stated: recognised from its numbers.

use glam::{DMat4, DVec3};

use crate::camera::recovery::SLACK;
use crate::camera::{
    Axes, Camera, ImageSize, MatrixEntries, MatrixKind, Ndc, Parameters, Reading, Recovered, RecoveryError, recover,
};

/// The part of a reading that is stated. `None`: it is recognised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stated {
    /// The kind of the matrix.
    pub kind: Option<MatrixKind>,
    /// Whose axes.
    pub axes: Option<Axes>,
    /// It is written by columns, or for row vectors. Where `kind` is open too, `false` leaves it open.
    pub by_columns: bool,
    /// The convention of its NDC.
    pub ndc: Ndc,
    /// The image that its pixels are of.
    pub image: ImageSize,
}

/// Why a matrix is read as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// No other reading gives a camera.
    Only,
    /// In no other reading the camera is level and upright.
    Level,
    /// In no other reading that is as level the origin lies in front of the camera.
    OriginAhead,
    /// None: others fit as well.
    Nothing,
}

impl Evidence {
    /// The name in the output of the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Only => "only",
            Self::Level => "level",
            Self::OriginAhead => "origin-ahead",
            Self::Nothing => "nothing",
        }
    }
}

/// A matrix whose reading was recognised.
#[derive(Clone, Debug, PartialEq)]
pub struct Recognised {
    /// How it was read.
    pub reading: Reading,
    /// It was read by columns.
    pub by_columns: bool,
    /// Why it was read so.
    pub evidence: Evidence,
    /// Its camera.
    pub found: Recovered,
    /// Other kinds as which it gives another camera, the likelier first.
    pub others: Vec<MatrixKind>,
}

/// A reading with the camera that it gives.
struct Candidate {
    reading: Reading,
    found: Recovered,
    is_level: bool,
    is_ahead: bool,
}

impl Candidate {
    fn new(reading: Reading, matrix: DMat4, current: &Parameters) -> Result<Self, RecoveryError> {
        let found = recover(&reading, matrix, current)?;
        let camera = Camera::new(&found.parameters)?;
        let basis = camera.basis();
        let is_level = basis.u.y.abs() < LEVEL && basis.v.y > LEVEL;
        Ok(Self { reading, found, is_level, is_ahead: camera.position().dot(basis.n) > 0.0 })
    }

    fn score(&self) -> (bool, bool) {
        (self.is_level, self.is_ahead)
    }
}

/// Of a component of **u**: a matrix that was copied with three digits still passes.
const LEVEL: f64 = 1e-3;

/// Reads a matrix as stated, and recognises the rest.
///
/// A rigid matrix may be M_v or its inverse, in the axes of several programs. Cameras are mostly level, and look
/// towards the origin: that decides, where it does; else camera to world is likelier, which programs show.
///
/// # Errors
/// That of the likeliest reading, where none gives a camera.
pub fn recognise(entries: &MatrixEntries, stated: &Stated, current: &Parameters) -> Result<Recognised, RecoveryError> {
    let shape = |by_columns| Shape::of(entries.matrix(by_columns), entries.rows());
    let [rows, columns] = [false, true].map(|by_columns| shape(by_columns).tidiness());
    let orders: &[bool] = match (stated.by_columns, stated.kind) {
        (true, _) => &[true],
        (false, Some(_)) => &[false],
        (false, None) if columns > rows => &[true],
        (false, None) if columns < rows || entries.rows() == 3 => &[false],
        (false, None) => &[false, true],
    };
    let mut first_error = None;
    for by_columns in orders {
        let matrix = entries.matrix(*by_columns);
        match in_order(matrix, shape(*by_columns), stated, current) {
            Ok(found) => return Ok(Recognised { by_columns: *by_columns, ..found }),
            Err(error) => first_error = first_error.or(Some(error)),
        }
    }
    // There is an order, so there is a camera or an error.
    Err(first_error.unwrap_or(RecoveryError::Mirrored))
}

/// Reads a matrix by rows.
fn in_order(matrix: DMat4, shape: Shape, stated: &Stated, current: &Parameters) -> Result<Recognised, RecoveryError> {
    let likely = shape.kinds();
    let mut kinds = stated.kind.map_or_else(|| likely.to_vec(), |kind| vec![kind]);
    kinds.extend(likely.iter().filter(|kind| stated.kind.is_some_and(|stated| stated != **kind)));
    let mut candidates = Vec::new();
    let mut first_error = None;
    for kind in kinds {
        let axes = match stated.axes {
            Some(axes) if kind.has_pose() => vec![axes],
            None if kind.has_camera_axes() => Axes::ALL.to_vec(),
            _ => vec![Axes::default()],
        };
        for axes in axes {
            let reading = Reading { kind, axes, ndc: stated.ndc, image: stated.image };
            match Candidate::new(reading, matrix, current) {
                Ok(candidate) => candidates.push(candidate),
                Err(error) if stated.kind == Some(kind) => return Err(error),
                Err(error) => first_error = first_error.or(Some(error)),
            }
        }
    }
    let Some(first) = candidates.first() else {
        // Without candidates each kind has left its error.
        return Err(first_error.unwrap_or(RecoveryError::Mirrored));
    };
    // The axes of the camera decide only between readings that have some.
    let of_first = |c: &&Candidate| {
        c.reading.kind == first.reading.kind
            || stated.kind.is_none() && c.reading.kind.has_camera_axes() && first.reading.kind.has_camera_axes()
    };
    let best = candidates.iter().filter(of_first).rev().max_by_key(|c| c.score()).unwrap_or(first);
    // Nothing but the up of a level camera tells the worlds of OpenGL and of Blender apart.
    let is_rival = |c: &&Candidate| {
        let only_world = c.reading.kind == best.reading.kind
            && best.reading.axes == Axes::OpenGl
            && c.reading.axes == Axes::Blender
            && !best.is_level;
        c.found.parameters != best.found.parameters && !only_world
    };
    let rivals: Vec<&Candidate> = candidates.iter().filter(of_first).filter(is_rival).collect();
    let evidence = if rivals.is_empty() {
        Evidence::Only
    } else if best.is_level && rivals.iter().all(|c| !c.is_level) {
        Evidence::Level
    } else if rivals.iter().all(|c| c.score() < best.score()) {
        Evidence::OriginAhead
    } else {
        Evidence::Nothing
    };
    let mut others: Vec<MatrixKind> = Vec::new();
    for candidate in &candidates {
        let kind = candidate.reading.kind;
        let differs = candidate.found.parameters != best.found.parameters;
        if kind != best.reading.kind && differs && !others.contains(&kind) {
            others.push(kind);
        }
    }
    Ok(Recognised { reading: best.reading, by_columns: false, evidence, found: best.found.clone(), others })
}

/// The traits of a matrix by which its kind is recognised.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shape {
    /// The count of rows that were given: three or four.
    rows: usize,
    /// The last row is 0 0 0 1, up to a factor.
    is_affine: bool,
    /// The last row is 0 0 0 1 itself, or begins with a unit vector.
    has_unit_last_row: bool,
    /// The rows of the upper left block are perpendicular to one another.
    are_rows_perpendicular: bool,
    /// Its columns are.
    are_columns_perpendicular: bool,
    /// Its rows all have the same length.
    is_uniform: bool,
    /// That length is 1.
    is_unit: bool,
    /// Its determinant is positive.
    is_right_handed: bool,
}

impl Shape {
    fn of(m: DMat4, rows: usize) -> Self {
        let last = m.row(3);
        let axis = last.truncate().length();
        let is_affine = axis <= SLACK * last.w.abs();
        let block = [m.row(0), m.row(1), m.row(2)].map(|row| row.truncate() / if is_affine { last.w } else { 1.0 });
        let columns = [0, 1, 2].map(|i| DVec3::new(block[0][i], block[1][i], block[2][i]));
        let lengths = block.map(DVec3::length);
        let perpendicular = |lines: [DVec3; 3]| {
            [(0, 1), (0, 2), (1, 2)]
                .into_iter()
                .all(|(a, b)| lines[a].normalize_or_zero().dot(lines[b].normalize_or_zero()).abs() <= SLACK)
        };
        let longest = lengths.into_iter().fold(0.0, f64::max);
        Self {
            rows,
            is_affine,
            has_unit_last_row: if is_affine { (last.w - 1.0).abs() } else { (axis - 1.0).abs() } <= SLACK,
            are_rows_perpendicular: perpendicular(block),
            are_columns_perpendicular: perpendicular(columns),
            is_uniform: lengths.iter().all(|length| longest - length <= SLACK * longest),
            is_unit: lengths.iter().all(|length| (length - 1.0).abs() <= SLACK),
            is_right_handed: block[0].cross(block[1]).dot(block[2]) > 0.0,
        }
    }

    fn is_rigid(self) -> bool {
        self.is_affine && self.are_rows_perpendicular && self.is_unit
    }

    /// A node with a scale of its own. In a parallel M_p M_v the rows are perpendicular, and z changes its sign.
    fn is_scaled(self) -> bool {
        let one_scale = self.are_rows_perpendicular && self.is_uniform;
        let scales = !self.are_rows_perpendicular;
        self.is_affine && self.are_columns_perpendicular && self.is_right_handed && (one_scale || scales)
    }

    /// How much speaks for the rows being rows.
    fn tidiness(self) -> u8 {
        if self.is_rigid() || self.is_scaled() { 2 } else { u8::from(self.has_unit_last_row && self.rows == 4) }
    }

    /// The kinds that it may be, the likelier first.
    fn kinds(self) -> &'static [MatrixKind] {
        use MatrixKind::{CameraToWorld, Pinhole, Projection, View, ViewProjection};
        if self.is_rigid() && self.rows == 3 {
            &[CameraToWorld, View, Pinhole]
        } else if self.is_rigid() && self.is_right_handed {
            &[CameraToWorld, View, ViewProjection]
        } else if self.is_rigid() {
            &[View, CameraToWorld, ViewProjection]
        } else if self.is_scaled() {
            &[CameraToWorld, ViewProjection, Pinhole]
        } else if self.rows == 3 {
            &[Pinhole]
        } else if self.is_affine && !self.are_rows_perpendicular {
            &[Pinhole, ViewProjection]
        } else {
            &[Projection, ViewProjection, Pinhole]
        }
    }
}
