//! Each entry of each matrix as a formula, from `[0]` §5.3 and §5.5, and derived ones for inverses, products and other
//! conventions.

use super::formula::{minus, over, plus, sum, times};
use super::setting::EntryOf;
use super::{Axis, Component, Formula, Function, Matrix, Setting, Symbol, Vector};
use crate::camera::{Camera, Ndc, Projection};

/// The sixteen formulas of a matrix, by rows.
pub type EntryFormula = [[Formula; 4]; 4];

/// A matrix with its formulas, and its place in the notes.
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixFormula {
    /// The matrix with these formulas.
    pub matrix: Matrix,
    /// The equation that applies. Empty if the notes have none for it.
    pub equation: &'static str,
    /// The section of `[0]`.
    pub section: &'static str,
    /// Rows of entries.
    pub entries: EntryFormula,
}

impl Setting<'_> {
    /// Other numbers for some symbols, as a student has them who made a mistake on the way. Entries of matrices follow
    /// from them.
    #[must_use]
    pub fn with_values(mut self, own: &[(Symbol, f64)]) -> Self {
        let entry: EntryOf = |setting, matrix, [row, column]| {
            MatrixFormula::new(matrix, setting).entry(usize::from(row), usize::from(column)).value(setting)
        };
        self.own = Some((own.to_vec(), entry));
        self
    }
}

impl MatrixFormula {
    /// The formulas that apply in a setting: (5.13) to (5.16) by projection and symmetry, the third row by the
    /// convention of NDC.
    ///
    /// *Guarantees*: each entry's [`Formula::value`] is the program's number ([`Setting::matrix`]) up to the rounding
    /// of plain `f64`.
    pub fn new(matrix: Matrix, setting: &Setting<'_>) -> Self {
        let entries = match matrix {
            Matrix::Model => with_parent(local_model(), setting),
            Matrix::InverseModel => inverse_model(setting),
            Matrix::Parent | Matrix::InverseParent => entries_of(matrix),
            Matrix::View => view(),
            Matrix::InverseView => inverse_view(),
            Matrix::Projection => projection(setting),
            Matrix::InverseProjection => inverse_projection(setting),
            Matrix::ViewProjection => entry_product(&projection(setting), &view()),
            Matrix::InverseViewProjection => entry_product(&inverse_view(), &inverse_projection(setting)),
            Matrix::Viewport => viewport(setting),
            Matrix::InverseViewport => inverse_viewport(setting),
        };
        let (equation, section) = place(matrix, setting);
        Self { matrix, equation, section, entries }
    }

    /// One entry. Rows and columns from 0.
    pub fn entry(&self, row: usize, column: usize) -> &Formula {
        &self.entries[row.min(3)][column.min(3)]
    }
}

/// The equation that applies to M_p, `[0]` (5.13) to (5.16).
pub fn projection_equation(camera: &Camera) -> &'static str {
    match (camera.projection() == Projection::Perspective, camera.has_symmetric_window()) {
        (true, false) => "(5.13)",
        (true, true) => "(5.14)",
        (false, false) => "(5.15)",
        (false, true) => "(5.16)",
    }
}

fn place(matrix: Matrix, setting: &Setting<'_>) -> (&'static str, &'static str) {
    let of_the_notes = setting.space().ndc() == Ndc::default();
    match matrix {
        Matrix::Model | Matrix::InverseModel | Matrix::Parent | Matrix::InverseParent => ("", "§5.3.1"),
        Matrix::View => ("(5.7)", "§5.3.1"),
        Matrix::InverseView => ("", "§5.3.1"),
        Matrix::Projection if of_the_notes => (projection_equation(setting.space().camera()), "§5.3.2"),
        Matrix::Projection | Matrix::InverseProjection => ("", "§5.3.2"),
        Matrix::ViewProjection | Matrix::InverseViewProjection => ("", "§5.3"),
        Matrix::Viewport if of_the_notes => ("(5.24), (5.25)", "§5.5"),
        Matrix::Viewport | Matrix::InverseViewport => ("", "§5.5"),
    }
}

pub(super) fn zero() -> Formula {
    Formula::Number(0.0)
}

pub(super) fn one() -> Formula {
    Formula::Number(1.0)
}

pub(super) fn symbol(symbol: Symbol) -> Formula {
    symbol.into()
}

pub(super) fn last_row() -> [Formula; 4] {
    [zero(), zero(), zero(), one()]
}

/// a b, with each entry a sum of products without those that are 0.
pub fn entry_product(a: &EntryFormula, b: &EntryFormula) -> EntryFormula {
    std::array::from_fn(|i| std::array::from_fn(|j| sum((0..4).map(|k| times([a[i][k].clone(), b[k][j].clone()])))))
}

/// (5.7).
pub(super) fn view() -> EntryFormula {
    let row = |axis| {
        let [x, y, z] = Component::THREE.map(|c| symbol(Symbol::Axis(axis, c)));
        [x, y, z, -Formula::Dot(Vector::Axis(axis), Vector::Position)]
    };
    let [u, v, n] = Axis::ALL.map(row);
    [u, v, n, last_row()]
}

/// Its columns are **u**, **v**, **n** and C.
fn inverse_view() -> EntryFormula {
    let row = |c| {
        let [u, v, n] = Axis::ALL.map(|axis| symbol(Symbol::Axis(axis, c)));
        [u, v, n, symbol(Symbol::Position(c))]
    };
    let [x, y, z] = Component::THREE.map(row);
    [x, y, z, last_row()]
}

/// The parts of M_p that depend on the window: 2/W or 2/(r − l) times a factor, and (r + l)/(r − l), for x and for y.
struct WindowParts {
    size: [Formula; 2],
    sum: [Formula; 2],
    difference: [Formula; 2],
}

fn window_parts(setting: &Setting<'_>) -> WindowParts {
    let pairs = [(Symbol::Right, Symbol::Left), (Symbol::Top, Symbol::Bottom)];
    let symmetric = setting.space().camera().has_symmetric_window();
    let difference = pairs.map(|(high, low)| minus(high, low));
    let size = if symmetric { [Symbol::Width, Symbol::Height].map(symbol) } else { difference.clone() };
    let sum = pairs.map(|(high, low)| if symmetric { zero() } else { plus(high, low) });
    WindowParts { size, sum, difference }
}

/// y_n in the direction of the convention.
fn up(setting: &Setting<'_>, formula: Formula) -> Formula {
    if setting.space().ndc().y_points_down() { -formula } else { formula }
}

/// (5.13) to (5.16), and the substitutes for their third row in other conventions.
pub(super) fn projection(setting: &Setting<'_>) -> EntryFormula {
    let WindowParts { size: [width, height], sum: [sum_x, sum_y], difference: [across, upwards] } =
        window_parts(setting);
    let skew = |sum: Formula, difference| if sum == zero() { zero() } else { over(sum, difference) };
    let (skew_x, skew_y) = (skew(sum_x, across), up(setting, skew(sum_y, upwards)));
    let [z, depth] = depth_row(setting);
    if setting.space().camera().projection() == Projection::Perspective {
        let twice_near = || times([2.0.into(), symbol(Symbol::Near)]);
        [
            [over(twice_near(), width), zero(), skew_x, zero()],
            [zero(), up(setting, over(twice_near(), height)), skew_y, zero()],
            [zero(), zero(), z, depth],
            [zero(), zero(), -one(), zero()],
        ]
    } else {
        [
            [over(2.0, width), zero(), zero(), -skew_x],
            [zero(), up(setting, over(2.0, height)), zero(), -skew_y],
            [zero(), zero(), z, depth],
            last_row(),
        ]
    }
}

/// B − F, B + F and B F.
fn planes() -> [Formula; 3] {
    let (near, far) = (Symbol::Near, Symbol::Far);
    [minus(far, near), plus(far, near), times([symbol(far), symbol(near)])]
}

/// The two entries of M_p's third row, from z_n = z₀ at F and z₁ at B.
fn depth_row(setting: &Setting<'_>) -> [Formula; 2] {
    let ndc = setting.space().ndc();
    let (near, far) = (|| symbol(Symbol::Near), || symbol(Symbol::Far));
    let [difference, total, both] = planes();
    let over_difference = |above: Formula| over(above, difference.clone());
    let perspective = setting.space().camera().projection() == Projection::Perspective;
    let kind = depth_kind(ndc);
    match (perspective, ndc.infinite, kind) {
        (true, true, Depths::Both) => [-one(), -times([2.0.into(), near()])],
        (true, true, Depths::Forward) => [-one(), -near()],
        (true, true, Depths::Reversed) => [zero(), near()],
        (true, false, Depths::Both) => [-over_difference(total), -over_difference(times([2.0.into(), both]))],
        (true, false, Depths::Forward) => [-over_difference(far()), -over_difference(both)],
        (true, false, Depths::Reversed) => [over_difference(near()), over_difference(both)],
        (false, _, Depths::Both) => [-over_difference(2.0.into()), -over_difference(total)],
        (false, _, Depths::Forward) => [-over_difference(one()), -over_difference(near())],
        (false, _, Depths::Reversed) => [over_difference(one()), over_difference(far())],
    }
}

/// The ranges of z_n from F to B.
#[derive(Clone, Copy)]
enum Depths {
    /// −1 … 1
    Both,
    /// 0 … 1
    Forward,
    /// 1 … 0
    Reversed,
}

fn depth_kind(ndc: Ndc) -> Depths {
    match ndc.depths() {
        [-1.0, _] => Depths::Both,
        [0.0, _] => Depths::Forward,
        _ => Depths::Reversed,
    }
}

/// `M_p⁻¹`.
fn inverse_projection(setting: &Setting<'_>) -> EntryFormula {
    let WindowParts { size: [width, height], sum: [sum_x, sum_y], .. } = window_parts(setting);
    let [z, one_row] = inverse_depth_row(setting);
    let divided = |sum: Formula, below: Formula| if sum == zero() { zero() } else { over(sum, below) };
    if setting.space().camera().projection() == Projection::Perspective {
        let twice_near = || times([2.0.into(), symbol(Symbol::Near)]);
        [
            [over(width, twice_near()), zero(), zero(), divided(sum_x, twice_near())],
            [zero(), up(setting, over(height, twice_near())), zero(), divided(sum_y, twice_near())],
            [zero(), zero(), zero(), -one()],
            [zero(), zero(), z, one_row],
        ]
    } else {
        [
            [over(width, 2.0), zero(), zero(), divided(sum_x, 2.0.into())],
            [zero(), up(setting, over(height, 2.0)), zero(), divided(sum_y, 2.0.into())],
            [zero(), zero(), z, one_row],
            last_row(),
        ]
    }
}

/// The two entries that lead back to depth. They're in the fourth row in perspective, in the third in parallel
/// projection.
fn inverse_depth_row(setting: &Setting<'_>) -> [Formula; 2] {
    let ndc = setting.space().ndc();
    let (near, far) = (|| symbol(Symbol::Near), || symbol(Symbol::Far));
    let [difference, total, both] = planes();
    let twice = |formula: Formula| times([2.0.into(), formula]);
    let perspective = setting.space().camera().projection() == Projection::Perspective;
    match (perspective, ndc.infinite, depth_kind(ndc)) {
        (true, true, Depths::Both) => [-over(one(), twice(near())), over(one(), twice(near()))],
        (true, true, Depths::Forward) => [-over(one(), near()), over(one(), near())],
        (true, true, Depths::Reversed) => [over(one(), near()), zero()],
        (true, false, Depths::Both) => [-over(difference, twice(both.clone())), over(total, twice(both))],
        (true, false, Depths::Forward) => [-over(difference, both), over(one(), near())],
        (true, false, Depths::Reversed) => [over(difference, both), over(one(), far())],
        (false, _, Depths::Both) => [-over(difference, 2.0), -over(total, 2.0)],
        (false, _, Depths::Forward) => [-difference, -near()],
        (false, _, Depths::Reversed) => [difference, -far()],
    }
}

/// (5.24) before the floor, and (5.25), where Z goes from n at z₀ to f at z₁.
fn viewport(setting: &Setting<'_>) -> EntryFormula {
    let half = |s: Symbol| over(s, 2.0);
    let (x, y) = (half(Symbol::ViewportWidth), half(Symbol::ViewportHeight));
    let difference = minus(Symbol::DepthFar, Symbol::DepthNear);
    let (slope, start) = match depth_kind(setting.space().ndc()) {
        Depths::Both => (over(difference, 2.0), over(plus(Symbol::DepthFar, Symbol::DepthNear), 2.0)),
        Depths::Forward => (difference, symbol(Symbol::DepthNear)),
        Depths::Reversed => (minus(Symbol::DepthNear, Symbol::DepthFar), symbol(Symbol::DepthFar)),
    };
    [
        [x.clone(), zero(), zero(), sum([x, symbol(Symbol::ViewportX)])],
        [zero(), up(setting, y.clone()), zero(), sum([y, symbol(Symbol::ViewportY)])],
        [zero(), zero(), slope, start],
        last_row(),
    ]
}

fn inverse_viewport(setting: &Setting<'_>) -> EntryFormula {
    // x_n = (2/W_v) X − (W_v + 2 X_v)/W_v
    let row = |size: Symbol, start: Symbol| {
        [over(2.0, size), -over(sum([symbol(size), times([2.0.into(), symbol(start)])]), size)]
    };
    let [x, x_0] = row(Symbol::ViewportWidth, Symbol::ViewportX);
    let [y, y_0] = row(Symbol::ViewportHeight, Symbol::ViewportY);
    let difference = || minus(Symbol::DepthFar, Symbol::DepthNear);
    let (near, far) = (|| symbol(Symbol::DepthNear), || symbol(Symbol::DepthFar));
    let [z, z_0] = match depth_kind(setting.space().ndc()) {
        Depths::Both => [over(2.0, difference()), -over(plus(far(), near()), difference())],
        Depths::Forward => [over(one(), difference()), -over(near(), difference())],
        Depths::Reversed => [-over(one(), difference()), over(far(), difference())],
    };
    [[x, zero(), zero(), x_0], [zero(), up(setting, y), zero(), up(setting, y_0)], [zero(), zero(), z, z_0], last_row()]
}

/// The nine entries of R = `R_z` `R_y` `R_x`.
fn rotation() -> [[Formula; 3]; 3] {
    let of = |function| move |c| Formula::Of(function, Box::new(symbol(Symbol::Rotate(c))));
    let (sin, cos) = (of(Function::Sine), of(Function::Cosine));
    let (x, y, z) = (Component::X, Component::Y, Component::Z);
    [
        [
            times([cos(z), cos(y)]),
            sum([times([cos(z), sin(y), sin(x)]), -times([sin(z), cos(x)])]),
            sum([times([cos(z), sin(y), cos(x)]), times([sin(z), sin(x)])]),
        ],
        [
            times([sin(z), cos(y)]),
            sum([times([sin(z), sin(y), sin(x)]), times([cos(z), cos(x)])]),
            sum([times([sin(z), sin(y), cos(x)]), -times([cos(z), sin(x)])]),
        ],
        [-sin(y), times([cos(y), sin(x)]), times([cos(y), cos(x)])],
    ]
}

/// T R S of one object.
fn local_model() -> EntryFormula {
    let rotation = rotation();
    let row = |i: usize| {
        let c = Component::THREE[i];
        let scaled = |j: usize| times([rotation[i][j].clone(), symbol(Symbol::Scale(Component::THREE[j]))]);
        [scaled(0), scaled(1), scaled(2), symbol(Symbol::Translate(c))]
    };
    [row(0), row(1), row(2), last_row()]
}

fn entries_of(matrix: Matrix) -> EntryFormula {
    const INDICES: [u8; 4] = [0, 1, 2, 3];
    INDICES.map(|row| match row {
        3 => last_row(),
        row => INDICES.map(|column| symbol(Symbol::Entry(matrix, row, column))),
    })
}

fn with_parent(model: EntryFormula, setting: &Setting<'_>) -> EntryFormula {
    let has_parent = setting.placement().is_some_and(|placement| placement.parent.is_some());
    if has_parent { entry_product(&entries_of(Matrix::Parent), &model) } else { model }
}

/// S⁻¹ Rᵀ T⁻¹, after the inverse of the parent.
fn inverse_model(setting: &Setting<'_>) -> EntryFormula {
    let rotation = rotation();
    let row = |i: usize| {
        let divided = |formula| over(formula, Symbol::Scale(Component::THREE[i]));
        let along =
            sum((0..3).map(|k| times([rotation[k][i].clone(), symbol(Symbol::Translate(Component::THREE[k]))])));
        let [a, b, c] = [0, 1, 2].map(|k: usize| divided(rotation[k][i].clone()));
        [a, b, c, -divided(along)]
    };
    let own = [row(0), row(1), row(2), last_row()];
    let has_parent = setting.placement().is_some_and(|placement| placement.parent.is_some());
    if has_parent { entry_product(&own, &entries_of(Matrix::InverseParent)) } else { own }
}
