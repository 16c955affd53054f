//! The entries of one camera → its pose and its lens, and what becomes of each entry.

use glam::{DMat3, DMat4, DQuat, DVec3, EulerRot};

use super::names::Field;
use super::names::Word;
use crate::camera::recovery::reading::{MatrixEntries, Written, rigid};
use crate::camera::recovery::{Axes, MatrixKind, Order, Toward};
use Field as F;

/// An entry of a file: a name with its numbers or its word.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// With the names around it.
    pub(crate) name: String,
    /// The number behind a name, such as 02 of `K_02`.
    pub(crate) index: String,
    pub(crate) fields: &'static [Field],
    pub(crate) numbers: Vec<Written>,
    pub(crate) lines: Vec<usize>,
    pub(crate) text: String,
    /// The kind of a matrix by its name.
    pub(crate) word: Option<Word>,
    /// It stands outside of the camera's own part of the file.
    pub(crate) is_inherited: bool,
}

impl Entry {
    pub(crate) fn has(&self, is: impl Fn(Field) -> bool) -> bool {
        self.fields.iter().any(|field| is(*field))
    }

    /// True, unless a word or 0 says no.
    fn is_on(&self) -> bool {
        let is_off = ["false", "off", "no", "0"].contains(&self.text.to_lowercase().as_str());
        self.numbers.first().map_or(!is_off, |number| number.value > 0.5)
    }

    pub(crate) fn value(&self) -> String {
        if self.numbers.is_empty() {
            return self.text.clone();
        }
        let numbers = self.numbers.iter().take(16).map(|number| number.value.to_string());
        let more = if self.numbers.len() > 16 { " …" } else { "" };
        numbers.collect::<Vec<_>>().join(" ") + more
    }
}

/// The conventions of the program that a text names.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sign {
    /// All of these stand in the text, without capitals.
    words: &'static [&'static str],
    pub(crate) axes: Option<Axes>,
    /// The side that a bare angle spans.
    pub(crate) side: Side,
    pub(crate) is_radians: Option<bool>,
    pub(crate) order: Option<Order>,
    pub(crate) units: f64,
    /// The target is not needed to know C.
    pub(crate) is_parallel: bool,
}

/// A side of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Side {
    Up,
    Across,
    Smaller,
    Larger,
}

const fn sign(words: &'static [&'static str], axes: Axes) -> Sign {
    Sign { words, axes: Some(axes), ..NONE }
}

const NONE: Sign =
    Sign { words: &[], axes: None, side: Side::Up, is_radians: None, order: None, units: 1.0, is_parallel: false };

/// The likelier first.
const SIGNS: [Sign; 31] = [
    Sign { side: Side::Across, units: 0.01, is_radians: Some(false), ..sign(&["fvector("], Axes::UNREAL) },
    Sign { side: Side::Across, units: 0.01, is_radians: Some(false), ..sign(&["ucameracomponent"], Axes::UNREAL) },
    Sign { side: Side::Across, units: 0.01, is_radians: Some(false), ..sign(&["frotator"], Axes::UNREAL) },
    Sign { side: Side::Across, units: 0.01, is_radians: Some(false), ..sign(&["pitch=", "yaw="], Axes::UNREAL) },
    Sign { is_radians: Some(true), ..sign(&["babylon"], Axes::DIRECT3D) },
    sign(&["lookrotation("], Axes::DIRECT3D),
    sign(&["nearclipplane"], Axes::DIRECT3D),
    Sign { is_radians: Some(false), ..sign(&["near clip plane"], Axes::DIRECT3D) },
    sign(&["lookatlh"], Axes::DIRECT3D),
    Sign {
        order: Some(Order::Columns),
        is_parallel: true,
        ..sign(&["pytorch3d", "orthographiccameras("], Axes::PYTORCH3D)
    },
    Sign { order: Some(Order::Columns), ..sign(&["pytorch3d"], Axes::PYTORCH3D) },
    sign(&["bpy"], Axes::BLENDER),
    sign(&["matrix_world"], Axes::BLENDER),
    sign(&["rotation_euler"], Axes::BLENDER),
    Sign { is_radians: Some(false), ..sign(&["transform3d"], Axes::OPENGL) },
    Sign { is_radians: Some(true), ..sign(&["::from_xyz"], Axes::OPENGL) },
    Sign { is_radians: Some(true), side: Side::Smaller, ..sign(&["viewpoint"], Axes::OPENGL) },
    Sign { is_radians: Some(false), side: Side::Across, ..sign(&["look_at", "location"], Axes::DIRECT3D) },
    Sign { is_radians: Some(false), side: Side::Smaller, ..sign(&["lookat", "camera \""], Axes::DIRECT3D) },
    Sign { is_radians: Some(false), side: Side::Across, ..sign(&["<sensor", "to_world"], Axes::PYTORCH3D) },
    Sign { is_radians: Some(false), side: Side::Across, ..sign(&["<scene", "<lookat"], Axes::PYTORCH3D) },
    Sign { order: Some(Order::Columns), ..sign(&["#usda"], Axes::OPENGL) },
    Sign { is_radians: Some(false), ..sign(&["<node"], Axes::OPENGL) },
    Sign { is_radians: Some(false), ..sign(&["glulookat"], Axes::OPENGL) },
    Sign { is_radians: Some(true), ..sign(&["glm::"], Axes::OPENGL) },
    Sign { is_radians: Some(true), ..sign(&["glam::"], Axes::OPENGL) },
    Sign { is_radians: Some(false), ..sign(&["three."], Axes::OPENGL) },
    Sign { is_radians: Some(true), ..sign(&["\"asset\""], Axes::OPENGL) },
    Sign { is_parallel: true, ..sign(&["[2 / (r - l)"], Axes::OPENGL) },
    sign(&["viewnormal"], Axes::OPENGL),
    sign(&["<vcgcamera"], Axes::OPENGL),
];

impl Sign {
    pub(crate) fn is_pov(&self) -> bool {
        self.words.contains(&"look_at")
    }
}

/// The conventions of a text.
pub(crate) fn sign_of(text: &str) -> Sign {
    let text = text.to_lowercase();
    SIGNS.into_iter().find(|sign| sign.words.iter().all(|word| text.contains(word))).unwrap_or(NONE)
}

/// The entries of one camera, by their meanings.
pub(crate) struct Said<'a> {
    pub(crate) entries: &'a [Entry],
    /// The first entry of each meaning, with its numbers.
    pub(crate) first: Vec<(Field, usize, &'a [Written])>,
    pub(crate) taken: Vec<(Field, usize)>,
    pub(crate) repeated: Vec<usize>,
    pub(crate) sign: Sign,
}

impl<'a> Said<'a> {
    pub(crate) fn new(entries: &'a [Entry], sign: Sign) -> Self {
        let (mut first, mut repeated): (Vec<(Field, usize, &[Written])>, _) = (Vec::new(), Vec::new());
        for (at, entry) in entries.iter().enumerate() {
            let mut rest = entry.numbers.as_slice();
            for field in entry.fields {
                let count = if let [_] = entry.fields { rest.len() } else { field.count().unwrap_or(0) };
                let (own, after) = rest.split_at(count.min(rest.len()));
                rest = after;
                let is_many = matches!(field, F::Coefficient | F::Skip | F::Unknown | F::Part | F::Model);
                if !is_many && first.iter().any(|(other, ..)| other == field) {
                    repeated.push(at);
                } else {
                    first.push((*field, at, own));
                }
            }
        }
        Self { entries, first, taken: Vec::new(), repeated, sign }
    }

    pub(crate) fn has(&self, field: Field) -> bool {
        self.first.iter().any(|(own, ..)| *own == field)
    }

    fn written(&mut self, field: Field) -> Option<(usize, &'a [Written])> {
        let (_, at, numbers) = *self.first.iter().find(|(own, ..)| *own == field)?;
        self.taken.push((field, at));
        Some((at, numbers))
    }

    pub(crate) fn list(&mut self, field: Field) -> Option<Vec<f64>> {
        Some(self.written(field)?.1.iter().map(|number| number.value).collect())
    }

    pub(crate) fn number(&mut self, field: Field) -> Option<f64> {
        self.list(field)?.first().copied()
    }

    pub(crate) fn pair(&mut self, a: Field, b: Field) -> Option<[f64; 2]> {
        self.number(a).zip(self.number(b)).map(|(a, b)| [a, b])
    }

    pub(crate) fn vector(&mut self, field: Field) -> Option<DVec3> {
        self.list(field).filter(|list| list.len() >= 3).map(|list| DVec3::from_slice(&list))
    }

    /// A switch, or a word that is one.
    pub(crate) fn is_on(&mut self, field: Field) -> Option<bool> {
        let (at, _) = self.written(field)?;
        let entry = &self.entries[at];
        Some(if let [_] = entry.fields { entry.is_on() } else { true })
    }

    pub(crate) fn words(&self) -> String {
        let models = self.entries.iter().filter(|entry| entry.fields.contains(&F::Model));
        models.map(|entry| entry.text.to_lowercase() + " ").collect()
    }

    /// The name of the entry of a field.
    pub(crate) fn name(&self, field: Field) -> String {
        let place = self.first.iter().find(|(own, ..)| *own == field);
        place.map(|(_, at, _)| self.entries[*at].name.clone()).unwrap_or_default()
    }
}

/// A pose: its numbers, and what the text states of their reading.
type Pose = (MatrixEntries, Word);

pub(crate) const fn word(word: &'static str, kind: MatrixKind, axes: Option<Axes>, order: Option<Order>) -> Word {
    Word { word, kind: Some(kind), axes, order, is_weak: false }
}

impl Said<'_> {
    /// The pose, if there is a whole one. `is_vision`: a lens in pixels stands beside it.
    pub(crate) fn pose(&mut self, is_vision: bool) -> Option<Pose> {
        let mut axes = self.sign.axes;
        if self.sign.is_pov() && self.vector(F::Across).is_some_and(|right| right.x < 0.0) {
            axes = Some(Axes::OPENGL);
        }
        // COLMAP names its quaternion.
        let vision = axes.or((is_vision || self.has(F::Wxyz)).then_some(Axes::OPENCV));
        let exact = |m: DMat4| MatrixEntries::of_matrix(m, 1e-6);
        let view = |m: DMat4, axes| Some((exact(m), word("R, t", MatrixKind::View, axes, Some(Order::Rows))));
        let inverse =
            |m: DMat4, axes, name| Some((exact(m), word(name, MatrixKind::CameraToWorld, axes, Some(Order::Rows))));
        if let Some((_, numbers)) = self.written(F::Pinhole) {
            let said = Word::full("P", MatrixKind::Pinhole, Axes::OPENCV, Order::Rows);
            return Some((MatrixEntries::new(numbers.to_vec(), Some(4))?, said));
        }
        if let Some((at, numbers)) = self.written(F::Matrix).or_else(|| self.written(F::Projection)) {
            let entry = &self.entries[at];
            let entries = MatrixEntries::new(numbers.to_vec(), in_line(&entry.lines))?;
            let mut said = entry.word?;
            said.axes = said.axes.or(axes);
            said.order = said.order.or(self.sign.order);
            if said.word == "transform3d" {
                // Godot prints rows, and its constructor takes columns.
                let is_flat = in_line(&entry.lines).is_none();
                said.order = Some(if is_flat { Order::RotationThenTranslation } else { Order::Columns });
            }
            return Some((entries, said));
        }
        if let (true, Some(minus)) = (self.has(F::R4), self.vector(F::MinusEye)) {
            let r = self.list(F::R4)?;
            return view(matrix_of(&r, 4) * DMat4::from_translation(minus), Some(Axes::OPENGL));
        }
        let eye = if self.has(F::Eye) { F::Eye } else { F::T };
        let is_center = self.has(F::Center) && !self.has(F::Eye);
        let target = if self.has(F::Target) { F::Target } else { F::Center };
        let up = |said: &mut Self| {
            let is_z = axes.is_some_and(|axes| axes.up == crate::camera::WorldUp::Z);
            said.vector(F::Sky).or_else(|| said.vector(F::Up)).unwrap_or(if is_z { DVec3::Z } else { DVec3::Y })
        };
        let units = self.sign.units;
        if self.has(F::Eye) && self.has(target) {
            let (_, c) = self.written(F::Eye)?;
            let (_, pf) = self.written(target)?;
            let vup = up(self).to_array().map(|value| Written { value, error: 0.0 });
            let nine = c.iter().chain(pf).map(|n| Written { value: n.value * units, ..*n }).chain(vup);
            let said = word("PF", MatrixKind::LookAt, axes, Some(Order::Rows));
            return Some((MatrixEntries::new(nine.collect(), Some(3))?, said));
        }
        if let Some(focus) = self.vector(target).filter(|_| !is_center || self.has(F::Backward)) {
            let n = self.vector(F::Backward).or_else(|| self.vector(F::Front))?.normalize();
            let c = focus + n * self.distance()?;
            return look_at([c, focus, up(self)], 1e-9, word("focus", MatrixKind::LookAt, axes, None));
        }
        if self.name(F::Eye).to_lowercase().ends_with("cameraposition") {
            // A trace of ParaView leaves out what is as usual.
            let c = self.vector(F::Eye)?;
            let said = word("CameraPosition", MatrixKind::LookAt, Some(Axes::OPENGL), Some(Order::Rows));
            return look_at([c, DVec3::ZERO, up(self)], 0.0, said);
        }
        let ahead = [F::Forward, F::Front, F::Backward].into_iter().find(|field| self.has(*field));
        if let (Some(field), true) = (ahead, self.has(F::Eye)) {
            let c = self.vector(F::Eye)? * units;
            let ahead = self.vector(field)?.normalize() * if field == F::Backward { -1.0 } else { 1.0 };
            let own = axes.unwrap_or(Axes::OPENGL);
            let up = up(self);
            let right = if own.left_handed { up.cross(ahead) } else { ahead.cross(up) }.normalize();
            let up = if own.left_handed { ahead.cross(right) } else { right.cross(ahead) };
            let [x, y, z] = own.camera.map(|toward| match toward {
                Toward::Right => right,
                Toward::Left => -right,
                Toward::Up => up,
                Toward::Down => -up,
                Toward::Viewer => -ahead,
                Toward::Scene => ahead,
            });
            let m = DMat4::from_cols(x.extend(0.0), y.extend(0.0), z.extend(0.0), c.extend(1.0));
            return inverse(m, Some(own), "DOP");
        }
        let rotation = self.rotation(is_vision)?;
        if self.has(F::Eye) || is_center {
            let c = self.vector(if is_center { F::Center } else { F::Eye })?;
            return match rotation {
                Turn::Matrix(r) if is_center => view(rigid(rows_of(r), -(r * c)), vision),
                Turn::Matrix(r) => inverse(rigid(rows_of(r), c * units), vision, "position"),
                Turn::Quaternion(q, order) => {
                    let axes = axes.or(self.has(F::Fx).then_some(Axes::OPENCV));
                    seven([c.to_array().to_vec(), q], order, word("position", MatrixKind::CameraToWorld, axes, None))
                }
            };
        }
        let t = self.vector(F::T)?;
        match rotation {
            Turn::Matrix(r) => view(rigid(rows_of(r), t), vision),
            // A node of glTF.
            Turn::Quaternion(q, Some(false)) if self.has(F::Xyzw) || !is_vision => {
                let said = word("rotation", MatrixKind::CameraToWorld, axes, None);
                seven([self.vector(eye)?.to_array().to_vec(), q], Some(false), said)
            }
            Turn::Quaternion(q, order) => {
                let m = |w: usize| DQuat::from_xyzw(q[(w + 1) % 4], q[(w + 2) % 4], q[(w + 3) % 4], q[w]).normalize();
                let q = if order == Some(false) { m(3) } else { m(0) };
                view(DMat4::from_rotation_translation(q, t), vision)
            }
        }
    }

    /// M_p alone.
    pub(crate) fn only_projection(&mut self) -> Option<Pose> {
        self.first.retain(|(field, ..)| *field == F::Projection);
        self.pose(false)
    }

    /// From the target to the camera, as `VisIt` and `Open3D` keep it.
    fn distance(&mut self) -> Option<f64> {
        let tangent = |said: &mut Self, field| Some((said.number(field)?.to_radians() / 2.0).tan());
        if let Some([low, high]) = self.vector(F::BoundsMin).zip(self.vector(F::BoundsMax)).map(|(a, b)| [a, b]) {
            let zoom = self.number(F::Zoom)?;
            return Some(zoom * (high - low).max_element() / tangent(self, F::Fov)?);
        }
        Some(self.number(F::HalfHeight)? / tangent(self, F::AngleY)?)
    }

    fn rotation(&mut self, is_vision: bool) -> Option<Turn> {
        let matrix = |m: DMat3| Some(Turn::Matrix(m));
        if let Some(r) = self.list(F::R) {
            let m = DMat3::from_mat4(matrix_of(&r, 3));
            return matrix(if self.sign.order == Some(Order::Columns) { m.transpose() } else { m });
        }
        if self.sign.axes == Some(Axes::UNREAL) && (self.has(F::Yaw) || self.has(F::Rotation3)) {
            let [pitch, yaw, roll] = match self.vector(F::Rotation3) {
                Some(own) => own.to_array(),
                None => [F::Pitch, F::Yaw, F::Roll].map(|field| self.number(field).unwrap_or(0.0)),
            }
            .map(f64::to_radians);
            return matrix(DMat3::from_euler(EulerRot::ZYX, yaw, -pitch, -roll));
        }
        let is_vector = self.has(F::Rvec) || self.has(F::Rotation3) && is_vision;
        if is_vector {
            let field = if self.has(F::Rvec) { F::Rvec } else { F::Rotation3 };
            return matrix(DMat3::from_quat(DQuat::from_scaled_axis(self.vector(field)?)));
        }
        if let Some(a) = self.list(F::AxisAngle) {
            return matrix(DMat3::from_axis_angle(DVec3::from_slice(&a).try_normalize()?, a[3]));
        }
        if let Some(a) = self.vector(F::Euler) {
            return matrix(DMat3::from_euler(EulerRot::ZYX, a.z, a.y, a.x));
        }
        if self.sign.words == ["viewpoint"] && !self.has(F::Quaternion) {
            return matrix(DMat3::IDENTITY);
        }
        let orders = [(F::Wxyz, Some(true)), (F::Xyzw, Some(false)), (F::Quaternion, None)];
        orders.into_iter().find_map(|(field, order)| Some(Turn::Quaternion(self.list(field)?, order)))
    }
}

/// A rotation: a matrix, or a quaternion of which w stands first, last, or either.
enum Turn {
    Matrix(DMat3),
    Quaternion(Vec<f64>, Option<bool>),
}

/// C, PF and VUP, with the share of each number that is its error.
fn look_at(rows: [DVec3; 3], error: f64, said: Word) -> Option<Pose> {
    let written = |value: f64| Written { value, error: error * value.abs().max(1.0) };
    let nine = rows.iter().flat_map(|v| v.to_array()).map(written).collect();
    Some((MatrixEntries::new(nine, Some(3))?, said))
}

/// t and a quaternion.
fn seven(parts: [Vec<f64>; 2], is_w_first: Option<bool>, said: Word) -> Option<Pose> {
    let order = is_w_first.map(|first| if first { Order::TThenWxyz } else { Order::TThenXyzw });
    let numbers = parts.concat().into_iter().map(|value| Written { value, error: 1e-6 }).collect();
    Some((MatrixEntries::new(numbers, None)?, Word { order, ..said }))
}

/// A matrix by the numbers in each of its rows.
pub(crate) fn matrix_of(numbers: &[f64], columns: usize) -> DMat4 {
    let mut m = DMat4::IDENTITY;
    numbers.iter().enumerate().for_each(|(k, x)| m.col_mut(k % columns)[k / columns] = *x);
    m
}

fn rows_of(r: DMat3) -> [DVec3; 3] {
    [0, 1, 2].map(|i| r.row(i))
}

/// The count of numbers in each line, if it's the same in several.
pub(crate) fn in_line(lines: &[usize]) -> Option<usize> {
    let first = *lines.first()?;
    (lines.len() > 1 && first > 1 && lines.iter().all(|line| *line == first)).then_some(first)
}
