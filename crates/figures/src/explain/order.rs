//! Lists of transforms, as a program passes them to a stack of matrices `[4]`. Each call multiplies the current matrix
//! from the right, push saves it, and pop restores the one saved last.
//!
//! A list has two readings with one result. From left to right, each call moves the *frame*, along and about its
//! current axes. From right to left, each moves the *object*, along and about fixed axes `[3]`.

use glam::{DMat4, DVec3};

use super::{EntryFormula, Formula, Function, Named};
use crate::geometry::{Angle, Ray, try_unit};
use crate::scene::transform::Trs;

/// A call.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Call {
    /// T: scene units.
    Translate(DVec3),
    /// Rx: degrees.
    RotateX(f64),
    /// Ry: degrees.
    RotateY(f64),
    /// Rz: degrees.
    RotateZ(f64),
    /// S: factors.
    Scale(DVec3),
    /// Keeps the current matrix.
    Push,
    /// Restores the matrix saved last.
    Pop,
}

/// A pop without a push before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("step {} is a pop, and nothing was pushed before it", .call + 1)]
pub struct Unbalanced {
    /// Its place in the list, from 0.
    pub call: usize,
}

/// A reading of a list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reading {
    /// From left to right, where each call moves the frame about its own axes.
    #[default]
    Frame,
    /// From right to left, where each call moves the object about fixed axes.
    Object,
}

/// The state after a part of the list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// The last call of the part; `None` before the first one.
    pub call: Option<usize>,
    /// Parent ← object, by the calls of this part only.
    pub matrix: DMat4,
    /// The axis of the last call (in the parent's space).
    pub axis: Option<Ray>,
}

impl Call {
    /// The matrix that the call multiplies by; `None` means that it acts on the stack.
    pub fn matrix(self) -> Option<DMat4> {
        let turned = |axis: usize, degrees: f64| {
            let (sin, cos) = Angle::from_degrees(degrees).sin_cos();
            let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut rows = DMat4::IDENTITY.to_cols_array_2d();
            (rows[a][a], rows[a][b], rows[b][a], rows[b][b]) = (cos, sin, -sin, cos);
            DMat4::from_cols_array_2d(&rows)
        };
        match self {
            Self::Translate(t) => Some(DMat4::from_translation(t)),
            Self::RotateX(degrees) => Some(turned(0, degrees)),
            Self::RotateY(degrees) => Some(turned(1, degrees)),
            Self::RotateZ(degrees) => Some(turned(2, degrees)),
            Self::Scale(s) => Some(DMat4::from_scale(s)),
            Self::Push | Self::Pop => None,
        }
    }

    /// The formulas of its matrix, by rows; `None` means that it acts on the stack.
    ///
    /// *Guarantees*: each gives the entry of [`matrix`](Self::matrix).
    pub fn entries(self) -> Option<EntryFormula> {
        let cell = |i: usize, j: usize| Formula::Number(if i == j { 1.0 } else { 0.0 });
        let mut rows: EntryFormula = std::array::from_fn(|i| std::array::from_fn(|j| cell(i, j)));
        let named = |text, value, is_angle| Named { text, latex: text, value, is_angle };
        let (vector, names) = match self {
            Self::Translate(t) => (t.to_array(), ["t_x", "t_y", "t_z"]),
            Self::Scale(s) => (s.to_array(), ["s_x", "s_y", "s_z"]),
            Self::RotateX(degrees) | Self::RotateY(degrees) | Self::RotateZ(degrees) => {
                let axis =
                    usize::from(!matches!(self, Self::RotateX(_))) + usize::from(matches!(self, Self::RotateZ(_)));
                let angle = || Formula::Named(Named { latex: r"\alpha", ..named("α", degrees, true) });
                let of = |function| Formula::Of(function, Box::new(angle()));
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                (rows[a][a], rows[b][b]) = (of(Function::Cosine), of(Function::Cosine));
                (rows[a][b], rows[b][a]) = (-of(Function::Sine), of(Function::Sine));
                return Some(rows);
            }
            Self::Push | Self::Pop => return None,
        };
        for (i, (value, name)) in vector.into_iter().zip(names).enumerate() {
            let column = if matches!(self, Self::Scale(_)) { i } else { 3 };
            rows[i][column] = named(name, value, false).into();
        }
        Some(rows)
    }

    /// The axis of a rotation, in the space in which it acts.
    pub fn axis(self) -> Option<DVec3> {
        match self {
            Self::RotateX(_) => Some(DVec3::X),
            Self::RotateY(_) => Some(DVec3::Y),
            Self::RotateZ(_) => Some(DVec3::Z),
            Self::Translate(_) | Self::Scale(_) | Self::Push | Self::Pop => None,
        }
    }

    /// Its symbol, with an underscore before a subscript.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Translate(_) => "T",
            Self::RotateX(_) => "R_x",
            Self::RotateY(_) => "R_y",
            Self::RotateZ(_) => "R_z",
            Self::Scale(_) => "S",
            Self::Push => "push",
            Self::Pop => "pop",
        }
    }

    /// Its place in T Rz Ry Rx S, the form of an object's own transform.
    const fn place(self) -> Option<usize> {
        match self {
            Self::Translate(_) => Some(0),
            Self::RotateZ(_) => Some(1),
            Self::RotateY(_) => Some(2),
            Self::RotateX(_) => Some(3),
            Self::Scale(_) => Some(4),
            Self::Push | Self::Pop => None,
        }
    }
}

/// The calls of an object's own transform, T Rz Ry Rx S.
pub fn calls_of(trs: &Trs) -> Vec<Call> {
    let Trs { translate, rotate, scale } = *trs;
    let [x, y, z] = rotate.to_array();
    vec![Call::Translate(translate), Call::RotateZ(z), Call::RotateY(y), Call::RotateX(x), Call::Scale(scale)]
}

/// The calls that make the current matrix after the whole list, without those that a pop has undone.
///
/// # Errors
/// [`Unbalanced`]
pub fn in_force(calls: &[Call]) -> Result<Vec<usize>, Unbalanced> {
    let (mut current, mut kept) = (Vec::new(), Vec::new());
    for (call, what) in calls.iter().enumerate() {
        match what {
            Call::Push => kept.push(current.len()),
            Call::Pop => current.truncate(kept.pop().ok_or(Unbalanced { call })?),
            _ => current.push(call),
        }
    }
    Ok(current)
}

/// The states after each part of a list. From left to right, a part consists of its first calls, with the stack at that
/// point. From right to left, it consists of the last of the calls in force. Both begin with no call and end with the
/// same matrix.
///
/// # Errors
/// [`Unbalanced`]
pub fn read(calls: &[Call], reading: Reading) -> Result<Vec<Stage>, Unbalanced> {
    match reading {
        Reading::Frame => frame_moves(calls),
        Reading::Object => Ok(object_moves(calls, &in_force(calls)?)),
    }
}

const START: Stage = Stage { call: None, matrix: DMat4::IDENTITY, axis: None };

fn frame_moves(calls: &[Call]) -> Result<Vec<Stage>, Unbalanced> {
    let (mut stages, mut current, mut kept) = (vec![START], DMat4::IDENTITY, Vec::new());
    for (i, call) in calls.iter().enumerate() {
        // About an axis of the frame before the call.
        let axis = call.axis().and_then(|axis| {
            let direction = try_unit(current.transform_vector3(axis))?;
            Some(Ray { origin: current.w_axis.truncate(), direction })
        });
        match call {
            Call::Push => kept.push(current),
            Call::Pop => current = kept.pop().ok_or(Unbalanced { call: i })?,
            _ => current *= call.matrix().unwrap_or(DMat4::IDENTITY),
        }
        stages.push(Stage { call: Some(i), matrix: current, axis });
    }
    Ok(stages)
}

fn object_moves(calls: &[Call], in_force: &[usize]) -> Vec<Stage> {
    let (mut stages, mut current) = (vec![START], DMat4::IDENTITY);
    for &i in in_force.iter().rev() {
        let axis = calls[i].axis().map(|direction| Ray { origin: DVec3::ZERO, direction });
        current = calls[i].matrix().unwrap_or(DMat4::IDENTITY) * current;
        stages.push(Stage { call: Some(i), matrix: current, axis });
    }
    stages
}

/// The matrix of a whole list.
///
/// # Errors
/// [`Unbalanced`]
pub fn product(calls: &[Call]) -> Result<DMat4, Unbalanced> {
    Ok(frame_moves(calls)?.last().map_or(DMat4::IDENTITY, |stage| stage.matrix))
}

/// The list with two of its calls exchanged, or unchanged if there are no such calls.
pub fn exchanged(calls: &[Call], [a, b]: [usize; 2]) -> Vec<Call> {
    let mut calls = calls.to_vec();
    if a < calls.len() && b < calls.len() {
        calls.swap(a, b);
    }
    calls
}

/// True if two matrices are the same except for rounding.
pub fn same(a: &DMat4, b: &DMat4) -> bool {
    let (a, b) = (a.to_cols_array(), b.to_cols_array());
    let greatest = |values: &[f64]| values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let apart = a.iter().zip(b).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    apart <= 1e-12 * greatest(&a).max(greatest(&b))
}

/// A part of a list that one T R S holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Its first call; `None` if it has none.
    pub first: Option<usize>,
    /// Its translation, rotation and scale.
    pub trs: Trs,
}

/// A list as a chain of T R S, the first of them nearest to the parent. The chain has one link if the list has the form
/// T Rz Ry Rx S, in which calls may be missing. The product of the chain is exactly that of the list.
///
/// # Errors
/// [`Unbalanced`]
pub fn chain(calls: &[Call]) -> Result<Vec<Link>, Unbalanced> {
    let empty = Link { first: None, trs: Trs::default() };
    let (mut links, mut next_place) = (vec![empty], 0);
    for i in in_force(calls)? {
        let Some(place) = calls[i].place() else { continue };
        if place < next_place {
            links.push(empty);
        }
        next_place = place + 1;
        let Some(link) = links.last_mut() else { continue };
        link.first = link.first.or(Some(i));
        match calls[i] {
            Call::Translate(t) => link.trs.translate = t,
            Call::RotateX(degrees) => link.trs.rotate.x = degrees,
            Call::RotateY(degrees) => link.trs.rotate.y = degrees,
            Call::RotateZ(degrees) => link.trs.rotate.z = degrees,
            Call::Scale(s) => link.trs.scale = s,
            Call::Push | Call::Pop => {}
        }
    }
    Ok(links)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use glam::DQuat;

    fn near(a: &DMat4, b: &DMat4) -> bool {
        a.abs_diff_eq(*b, 1e-12)
    }

    /// By quaternions, in degrees.
    fn turn(axis: DVec3, degrees: f64) -> DMat4 {
        DMat4::from_quat(DQuat::from_axis_angle(axis, degrees.to_radians()))
    }

    const T: DVec3 = DVec3::new(10.0, 5.0, 3.0);
    const S: DVec3 = DVec3::new(2.0, 0.5, -1.0);

    fn list() -> Vec<Call> {
        vec![Call::Translate(T), Call::RotateZ(10.0), Call::RotateX(-70.0), Call::Scale(S), Call::RotateY(25.0)]
    }

    #[test]
    fn each_prefix_is_the_product_by_hand() {
        let by_hand = [
            DMat4::IDENTITY,
            DMat4::from_translation(T),
            DMat4::from_translation(T) * turn(DVec3::Z, 10.0),
            DMat4::from_translation(T) * turn(DVec3::Z, 10.0) * turn(DVec3::X, -70.0),
            DMat4::from_translation(T) * turn(DVec3::Z, 10.0) * turn(DVec3::X, -70.0) * DMat4::from_scale(S),
            DMat4::from_translation(T)
                * turn(DVec3::Z, 10.0)
                * turn(DVec3::X, -70.0)
                * DMat4::from_scale(S)
                * turn(DVec3::Y, 25.0),
        ];
        let stages = read(&list(), Reading::Frame).unwrap();
        assert_eq!(stages.len(), by_hand.len());
        assert!(stages.iter().zip(&by_hand).all(|(stage, wanted)| near(&stage.matrix, wanted)));
        // [4]: glTranslatef (10, 5, 3); glRotatef (10, 0, 0, 1). The object is rotated and then moved.
        let p = stages[2].matrix.transform_point3(DVec3::X);
        let (sin, cos) = 10_f64.to_radians().sin_cos();
        assert!((p - (T + DVec3::new(cos, sin, 0.0))).length() < 1e-12);
    }

    #[test]
    fn both_readings_lead_to_one_matrix_about_other_axes() {
        let frame = read(&list(), Reading::Frame).unwrap();
        let object = read(&list(), Reading::Object).unwrap();
        assert!(near(&frame[5].matrix, &object[5].matrix));
        assert!(near(&object[1].matrix, &turn(DVec3::Y, 25.0)), "it begins at the right");
        assert!(near(&object[2].matrix, &(DMat4::from_scale(S) * turn(DVec3::Y, 25.0))));
        assert_eq!(
            object.iter().map(|s| s.call).collect::<Vec<_>>(),
            [None, Some(4), Some(3), Some(2), Some(1), Some(0)]
        );
        // The frame turns about its own x, rotated by R_z, through T. The object turns about x through the origin.
        let moved = frame[3].axis.unwrap();
        assert!((moved.origin - T).length() < 1e-12);
        assert!((moved.direction - turn(DVec3::Z, 10.0).transform_vector3(DVec3::X)).length() < 1e-12);
        assert_eq!(object[3].axis, Some(Ray { origin: DVec3::ZERO, direction: DVec3::X }));
        // A rotation about that axis is the effect of the call on the frame before it.
        let (before, after) = (frame[2].matrix, frame[3].matrix);
        let about = DMat4::from_translation(moved.origin)
            * turn(moved.direction, -70.0)
            * DMat4::from_translation(-moved.origin);
        assert!(near(&(about * before), &after));
    }

    #[test]
    fn pop_brings_back_the_matrix_that_push_kept() {
        let calls = [
            Call::Translate(T),
            Call::Push,
            Call::RotateZ(90.0),
            Call::Push,
            Call::Scale(S),
            Call::Pop,
            Call::Pop,
            Call::RotateX(30.0),
        ];
        let stages = read(&calls, Reading::Frame).unwrap();
        assert_eq!(stages[6].matrix, stages[4].matrix);
        assert_eq!(stages[7].matrix, DMat4::from_translation(T));
        assert_eq!(in_force(&calls).unwrap(), [0, 7]);
        let object = read(&calls, Reading::Object).unwrap();
        assert!(object.len() == 3 && near(&object[2].matrix, &stages[8].matrix));
        // A push without a pop is in force.
        assert_eq!(in_force(&calls[..5]).unwrap(), [0, 2, 4]);
    }

    #[test]
    fn a_pop_without_a_push_is_named() {
        let calls = [Call::Push, Call::Pop, Call::Translate(T), Call::Pop];
        for reading in [Reading::Frame, Reading::Object] {
            assert_eq!(read(&calls, reading), Err(Unbalanced { call: 3 }));
        }
        assert_eq!(chain(&calls), Err(Unbalanced { call: 3 }));
        assert!(Unbalanced { call: 3 }.to_string().contains("step 4"));
    }

    #[test]
    fn commuting_transforms_are_recognised() {
        let commutes = |a: Call, b: Call| {
            let calls = [a, b];
            same(&product(&calls).unwrap(), &product(&exchanged(&calls, [0, 1])).unwrap())
        };
        let even = Call::Scale(DVec3::splat(3.0));
        assert!(commutes(Call::Translate(T), Call::Translate(S)));
        assert!(commutes(Call::RotateZ(20.0), Call::RotateZ(70.0)));
        assert!(commutes(Call::RotateX(33.0), even) && commutes(Call::Scale(S), even));
        assert!(commutes(Call::Translate(DVec3::Z), Call::RotateZ(40.0)), "along its own axis");
        assert!(commutes(Call::RotateX(180.0), Call::RotateY(180.0)));
        assert!(!commutes(Call::Translate(T), Call::RotateZ(40.0)));
        assert!(!commutes(Call::RotateX(90.0), Call::RotateY(90.0)));
        assert!(!commutes(Call::Translate(T), even));
        assert!(!commutes(Call::RotateZ(45.0), Call::Scale(S)));
    }

    #[test]
    fn a_chain_of_t_r_s_is_the_list() {
        let own = Trs { translate: T, rotate: DVec3::new(10.0, 20.0, 30.0), scale: S };
        let links = chain(&calls_of(&own)).unwrap();
        assert_eq!(links, [Link { first: Some(0), trs: own }]);
        assert_eq!(chain(&[]).unwrap(), [Link { first: None, trs: Trs::default() }]);
        let links = chain(&list()).unwrap();
        assert_eq!(links.iter().map(|link| link.first).collect::<Vec<_>>(), [Some(0), Some(4)]);
        let matrix = |link: &Link| product(&calls_of(&link.trs)).unwrap();
        let of_links = links.iter().fold(DMat4::IDENTITY, |m, link| m * matrix(link));
        assert!(near(&of_links, &product(&list()).unwrap()));
        // Calls undone by a pop aren't in it.
        let popped = [Call::Scale(S), Call::Push, Call::Translate(T), Call::Pop, Call::Push];
        assert_eq!(chain(&popped).unwrap(), [Link { first: Some(0), trs: Trs { scale: S, ..Trs::default() } }]);
    }
}
