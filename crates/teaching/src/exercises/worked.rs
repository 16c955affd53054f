//! Worked steps: the formulas of the notes with the numbers of an exercise.

use std::sync::Arc;

use glam::DVec3;

use super::subject::Subject;
use crate::camera::{Camera, Convention, Operation, ParameterKey, Projection};
use crate::explain::{
    self, Axis, Component, Formula, Function, Line, Matrix, MatrixFormula, Named, Notation, Setting, Style, Symbol,
    definition, over, plus, times,
};
use crate::inspect::camera_after;
use crate::inspect::quantity::{BasisAxis, PointNumber, Quantity, QuantityPath, RayNumber, ReportMatrix};
use crate::numbers::{DecimalMark, EXACT_DIGITS};

/// A step of a solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Worked {
    /// The name of the text above it.
    pub heading: &'static str,
    /// The equations that it uses.
    pub equation: String,
    /// The figure, without operations, that gives the symbols their numbers.
    subject: Arc<Subject>,
    /// The point whose coordinates it uses.
    point: Option<DVec3>,
    /// The rows to compute.
    rows: Vec<FormulaRow>,
    /// Wrong numbers of symbols, from rows with a mistake.
    wrong: Vec<(Symbol, f64)>,
}

/// `symbol` = `formula` = `value`.
#[derive(Clone, Debug, PartialEq)]
struct FormulaRow {
    symbol: Formula,
    formula: Formula,
    value: f64,
}

/// A number that has a name of its own in a solution.
pub(super) const fn named(text: &'static str, latex: &'static str, value: f64) -> Named {
    Named { text, latex, value, is_angle: false }
}

/// An angle in degrees that has a name of its own in a solution.
pub(super) const fn angle(text: &'static str, latex: &'static str, degrees: f64) -> Named {
    Named { text, latex, value: degrees, is_angle: true }
}

impl Worked {
    /// A step whose formulas have only numbers with names of their own.
    pub fn new(heading: &'static str, equation: &str) -> Self {
        let subject = Arc::new(Subject::default());
        Self::of(heading, equation, &subject)
    }

    /// Adds a row. The number of `symbol` is `formula`.
    pub fn row(mut self, symbol: Named, formula: Formula) -> Self {
        self.rows.push(FormulaRow { symbol: symbol.into(), formula, value: symbol.value });
        self
    }

    fn of(heading: &'static str, equation: impl Into<String>, subject: &Arc<Subject>) -> Self {
        let subject = Arc::clone(subject);
        Self { heading, equation: equation.into(), subject, point: None, rows: Vec::new(), wrong: Vec::new() }
    }

    fn push(&mut self, setting: &Setting<'_>, symbol: impl Into<Formula>, formula: Formula) {
        let value = formula.value(setting);
        self.rows.push(FormulaRow { symbol: symbol.into(), formula, value });
    }

    /// All its content, for comparison with other steps, because steps of different cameras may have the same content.
    pub fn said(&self) -> (&'static str, String, Vec<Line>) {
        let style = Style { notation: Notation::Text, mark: DecimalMark::Point, digits: EXACT_DIGITS };
        (self.heading, self.equation.clone(), self.lines(style, true))
    }

    /// The numbers of its symbols. `camera` is that of its subject.
    fn setting<'a>(&self, camera: &'a Camera) -> Setting<'a> {
        let setting = setting(camera, &self.subject);
        match self.point {
            Some(point) => setting.with_point(point),
            None => setting,
        }
    }

    /// The value of its last row.
    pub(super) fn last_value(&self) -> Option<f64> {
        self.rows.last().map(|row| row.value)
    }

    /// The rows as text.
    pub fn lines(&self, style: Style, exact: bool) -> Vec<Line> {
        let Ok(camera) = self.subject.camera() else { return Vec::new() };
        let setting = self.setting(&camera).with_values(&self.wrong);
        let Style { notation, mark, digits } = style;
        let symbols = explain::Writer { notation, mark, numbers: None };
        let numbers =
            explain::Writer { notation, mark, numbers: Some(explain::Numbers { setting: &setting, digits, exact }) };
        let line = |row: &FormulaRow| Line {
            symbol: symbols.write(&row.symbol),
            formula: symbols.write(&row.formula),
            numbers: numbers.write(&row.formula),
            value: numbers.number(row.value),
        };
        self.rows.iter().map(line).collect()
    }
}

fn setting<'a>(camera: &'a Camera, subject: &Subject) -> Setting<'a> {
    Setting::new(camera.notes_clip_space(), subject.figure.image, subject.figure.viewport)
}

/// The steps to a quantity of `inspect`. There are none to an entry of it.
pub(super) fn worked(subject: &Subject, path: impl Into<QuantityPath>) -> Vec<Worked> {
    let QuantityPath { quantity, entry } = path.into();
    let (mut steps, after) = operated(subject, |operation| matters(quantity, operation));
    let done = steps.len();
    let Ok(camera) = after.camera() else { return steps };
    if entry != [None; 2] {
        return steps;
    }
    let setting = setting(&camera, &after);
    let axes = || basis(&after, &setting, BasisAxis::V);
    let sides = || window(&after, &setting);
    match quantity {
        Quantity::Axis(axis) => steps.extend(basis(&after, &setting, axis)),
        Quantity::Direction | Quantity::Distance => steps.extend(basis(&after, &setting, BasisAxis::N)),
        Quantity::Window(_) | Quantity::Camera(ParameterKey::Height) => steps.extend(sides()),
        Quantity::Matrix(of @ (ReportMatrix::View | ReportMatrix::InverseView)) => {
            steps.extend(axes());
            let of = if of == ReportMatrix::View { Matrix::View } else { Matrix::InverseView };
            steps.push(matrix(&after, &setting, of));
        }
        Quantity::Matrix(of @ (ReportMatrix::Projection | ReportMatrix::InverseProjection)) => {
            steps.extend(sides());
            let of = if of == ReportMatrix::Projection { Matrix::Projection } else { Matrix::InverseProjection };
            steps.push(matrix(&after, &setting, of));
        }
        Quantity::Matrix(ReportMatrix::ViewProjection) => {
            steps.extend(axes());
            steps.extend(sides());
            let all = [Matrix::View, Matrix::Projection, Matrix::ViewProjection];
            steps.extend(all.map(|of| matrix(&after, &setting, of)));
        }
        Quantity::Point(k, number) => {
            steps.extend(axes());
            if number != PointNumber::View {
                steps.extend(sides());
            }
            let point = subject.points.get(k);
            steps.extend(point.map(|point| trace(&after, &setting, *point, number.name())).unwrap_or_default());
        }
        Quantity::Ray(k, number) => {
            steps.extend(axes());
            steps.extend(sides());
            steps.extend(subject.pixels.get(k).map(|pixel| ray(&after, &setting, *pixel, number)));
        }
        Quantity::Corner(k) => {
            steps.extend(axes());
            steps.extend(sides());
            steps.push(corner(&after, &setting, k));
        }
        Quantity::Camera(_) | Quantity::CameraSide(_) | Quantity::Lens(_) | Quantity::Plane(_) => {}
    }
    if done > 0 && steps.len() > done {
        // The next steps write C for C', and so on.
        steps.insert(done, Worked::of("afterwards", "§5.6", &after));
    }
    steps
}

/// The steps that decide if a point is inside: its clip coordinates, and how far inside each plane it is.
pub(super) fn inside(subject: &Subject, k: usize) -> Vec<Worked> {
    let mut steps = worked(subject, Quantity::Point(k, PointNumber::Clip));
    let (_, after) = operated(subject, |_| false);
    let (Ok(camera), Some(point)) = (after.camera(), subject.points.get(k)) else { return steps };
    let setting = setting(&camera, &after).with_point(*point);
    let mut step = Worked { point: Some(*point), ..Worked::of("outcode", "[2]", &after) };
    let planes = [("left", "right", Component::X), ("bottom", "top", Component::Y), ("near", "far", Component::Z)];
    let w = || Formula::from(Symbol::Clip(Component::W));
    for (low, high, along) in planes {
        step.push(&setting, named(low, low, 0.0), plus(w(), Symbol::Clip(along)));
        step.push(&setting, named(high, high, 0.0), explain::minus(w(), Symbol::Clip(along)));
    }
    steps.push(step);
    steps
}

/// True if an operation changes the value at a path.
fn matters(quantity: Quantity, operation: Operation) -> bool {
    let changes = operation.changes();
    let (pose, window) = (changes.position || changes.focal_point || changes.view_up, changes.window);
    match quantity {
        Quantity::Axis(_)
        | Quantity::Direction
        | Quantity::Distance
        | Quantity::Matrix(ReportMatrix::View | ReportMatrix::InverseView)
        | Quantity::Camera(ParameterKey::Position | ParameterKey::FocalPoint | ParameterKey::ViewUp) => pose,
        Quantity::Window(_)
        | Quantity::Matrix(ReportMatrix::Projection | ReportMatrix::InverseProjection)
        | Quantity::Camera(ParameterKey::ViewAngle | ParameterKey::Height) => window,
        _ => true,
    }
}

/// The operations that matter, one after the other, and the subject after all of them.
fn operated(subject: &Subject, matters: impl Fn(Operation) -> bool) -> (Vec<Worked>, Arc<Subject>) {
    let mut before = Subject { operations: Vec::new(), ..subject.clone() };
    let mut steps = Vec::new();
    for done in &subject.operations {
        let at = Arc::new(before.clone());
        let (Ok(camera), Ok(after)) =
            (at.camera(), camera_after(&before.figure.camera, &[*done], Convention::RightHand))
        else {
            break;
        };
        if matters(*done) {
            steps.push(operation(&at, &setting(&camera, &at), *done));
        }
        before.figure.camera = *after.parameters();
    }
    (steps, Arc::new(before))
}

/// A coordinate of a point.
type Coordinate = fn(Component) -> Symbol;

const NEW_POSITION: [(&str, &str); 3] = [("C'_x", "C'_x"), ("C'_y", "C'_y"), ("C'_z", "C'_z")];
const NEW_FOCAL_POINT: [(&str, &str); 3] =
    [("PF'_x", r"\mathrm{PF}'_x"), ("PF'_y", r"\mathrm{PF}'_y"), ("PF'_z", r"\mathrm{PF}'_z")];
const NEW_VIEW_UP: [(&str, &str); 3] =
    [("VUP'_x", r"\mathrm{VUP}'_x"), ("VUP'_y", r"\mathrm{VUP}'_y"), ("VUP'_z", r"\mathrm{VUP}'_z")];
const NEW_U: [(&str, &str); 3] = [("u'_x", "u'_x"), ("u'_y", "u'_y"), ("u'_z", "u'_z")];
const NEW_V: [(&str, &str); 3] = [("v'_x", "v'_x"), ("v'_y", "v'_y"), ("v'_z", "v'_z")];
const NEW_N: [(&str, &str); 3] = [("n'_x", "n'_x"), ("n'_y", "n'_y"), ("n'_z", "n'_z")];

/// The effect of an operation: the VRC turns about one of its axes, and C or PF with it.
fn operation(subject: &Arc<Subject>, setting: &Setting<'_>, operation: Operation) -> Worked {
    let (heading, turn) = match operation {
        Operation::Elevation(by) => ("elevation", Some((Axis::U, by))),
        Operation::Azimuth(by) => ("azimuth", Some((Axis::V, by))),
        Operation::Roll(by) => ("roll", Some((Axis::N, by))),
        Operation::Yaw(by) => ("yaw", Some((Axis::V, by))),
        Operation::Pitch(by) => ("pitch", Some((Axis::U, by))),
        Operation::Zoom(_) => ("zoom", None),
        Operation::Dolly(_) => ("dolly", None),
        Operation::Pan { .. } => ("pan", None),
    };
    let equation = match operation {
        // [0] has neither, so these are the equations they're made of.
        Operation::Dolly(_) => "(5.2)",
        Operation::Pan { .. } => "(5.3)",
        _ => "§5.6",
    };
    let mut step = Worked::of(heading, equation, subject);
    if let Some((axis, by)) = turn {
        turned(&mut step, setting, operation, axis, by.degrees());
        return step;
    }
    let axis = |axis, c| Formula::from(Symbol::Axis(axis, c));
    let parameters = setting.space().camera().parameters();
    match operation {
        Operation::Zoom(by) => {
            let s = named("s", "s", by);
            if parameters.window.is_some() {
                for (symbol, name) in
                    [(Symbol::Left, "l'"), (Symbol::Right, "r'"), (Symbol::Bottom, "b'"), (Symbol::Top, "t'")]
                {
                    step.push(setting, named(name, name, 0.0), over(symbol, s));
                }
            } else {
                step.push(setting, named("H'", "H'", 0.0), over(Symbol::Height, s));
                step.push(setting, named("W'", "W'", 0.0), over(Symbol::Width, s));
                if parameters.projection == Projection::Perspective {
                    let half = Formula::Of(Function::Tangent, Box::new(over(Symbol::ViewAngle, 2.0)));
                    let turned = Formula::Of(Function::ArcTangent, Box::new(over(half, s)));
                    step.push(setting, angle("θ'", r"\theta'", 0.0), times([2.0.into(), turned]));
                }
            }
        }
        Operation::Dolly(by) => {
            let factor = named("f", "f", by);
            let distance = named("D'", "D'", setting.value(Symbol::Distance) / by);
            step.push(setting, distance, over(Symbol::Distance, factor));
            for (c, (text, latex)) in Component::THREE.into_iter().zip(NEW_POSITION) {
                let moved = plus(Symbol::FocalPoint(c), times([distance.into(), axis(Axis::N, c)]));
                step.push(setting, named(text, latex, 0.0), moved);
            }
        }
        Operation::Pan { dx, dy } => {
            let (dx, dy) = (named("dx", "dx", dx), named("dy", "dy", dy));
            let by = |c| plus(times([dx.into(), axis(Axis::U, c)]), times([dy.into(), axis(Axis::V, c)]));
            for (names, of) in [(NEW_POSITION, Symbol::Position as Coordinate), (NEW_FOCAL_POINT, Symbol::FocalPoint)] {
                for (c, (text, latex)) in Component::THREE.into_iter().zip(names) {
                    step.push(setting, named(text, latex, 0.0), explain::sum([of(c).into(), by(c)]));
                }
            }
        }
        _ => {}
    }
    step
}

/// The VRC turned about one of its axes. The axis that turns towards the next one gets a part of it, and C or PF
/// follow.
fn turned(step: &mut Worked, setting: &Setting<'_>, operation: Operation, about: Axis, degrees: f64) {
    let alpha = angle("α", r"\alpha", degrees);
    let of = |function| Formula::Of(function, Box::new(alpha.into()));
    // About u, v turns towards n, and n away from v. The other axes work alike, in cyclic order.
    let (first, second) = match about {
        Axis::U => ((Axis::V, NEW_V), (Axis::N, NEW_N)),
        Axis::V => ((Axis::N, NEW_N), (Axis::U, NEW_U)),
        Axis::N => ((Axis::U, NEW_U), (Axis::V, NEW_V)),
    };
    let mut normal = [0.0; 3];
    let mut turned_axes = Vec::new();
    for ((axis, names), (other, _), sign) in [(first, second, 1.0), (second, first, -1.0)] {
        for (k, (c, (text, latex))) in Component::THREE.into_iter().zip(names).enumerate() {
            let along = times([Symbol::Axis(axis, c).into(), of(Function::Cosine)]);
            let across = times([Symbol::Axis(other, c).into(), of(Function::Sine)]);
            let formula = plus(along, if sign < 0.0 { -across } else { across });
            let value = formula.value(setting);
            if axis == Axis::N {
                normal[k] = value;
            }
            turned_axes.push((axis, k, named(text, latex, value)));
            step.push(setting, named(text, latex, 0.0), formula);
        }
    }
    // VUP turns with the VRC: its components along the axes stay.
    let up = setting.space().camera().view_up();
    let basis = setting.space().camera().basis();
    let parts = [
        (Axis::U, named("VUP·u", r"\mathrm{VUP}\cdot\mathbf{u}", up.dot(basis.u))),
        (Axis::V, named("VUP·v", r"\mathrm{VUP}\cdot\mathbf{v}", up.dot(basis.v))),
        (Axis::N, named("VUP·n", r"\mathrm{VUP}\cdot\mathbf{n}", up.dot(basis.n))),
    ];
    for (k, (c, (text, latex))) in Component::THREE.into_iter().zip(NEW_VIEW_UP).enumerate() {
        let along = parts.iter().map(|(axis, part)| {
            let turned = turned_axes.iter().find(|(turned, at, _)| turned == axis && *at == k);
            let unit = turned.map_or_else(|| Symbol::Axis(*axis, c).into(), |(.., unit)| Formula::from(*unit));
            times([(*part).into(), unit])
        });
        step.push(setting, named(text, latex, 0.0), explain::sum(along));
    }
    let moves: Option<(_, Coordinate, f64)> = match operation {
        Operation::Elevation(_) | Operation::Azimuth(_) => Some((NEW_POSITION, Symbol::FocalPoint, 1.0)),
        Operation::Yaw(_) | Operation::Pitch(_) => Some((NEW_FOCAL_POINT, Symbol::Position, -1.0)),
        _ => None,
    };
    let Some((names, from, sign)) = moves else { return };
    for (k, (c, (text, latex))) in Component::THREE.into_iter().zip(names).enumerate() {
        let n = named(NEW_N[k].0, NEW_N[k].1, normal[k]);
        let along = times([Symbol::Distance.into(), n.into()]);
        step.push(setting, named(text, latex, 0.0), plus(from(c), if sign < 0.0 { -along } else { along }));
    }
}

/// D and **n**, then **u**, then **v**, up to the requested axis.
fn basis(subject: &Arc<Subject>, setting: &Setting<'_>, up_to: BasisAxis) -> Vec<Worked> {
    let mut steps = Vec::new();
    for (axis, heading, last) in
        [(Axis::N, "n", BasisAxis::N), (Axis::U, "u", BasisAxis::U), (Axis::V, "v", BasisAxis::V)]
    {
        let symbols = Component::THREE.map(|c| Symbol::Axis(axis, c));
        let distance = (axis == Axis::N).then_some(Symbol::Distance);
        let mut step = defined(subject, setting, heading, distance.into_iter().chain(symbols));
        if axis == Axis::U {
            with_cross_product(&mut step, setting);
        }
        steps.push(step);
        if last == up_to {
            break;
        }
    }
    steps
}

const CROSS: [(&str, &str); 3] = [("a_x", "a_x"), ("a_y", "a_y"), ("a_z", "a_z")];

/// **a** = VUP × **n** and its length in rows of their own, before the components of **u**, which use them.
fn with_cross_product(step: &mut Worked, setting: &Setting<'_>) {
    let mut of_axis = std::mem::take(&mut step.rows);
    let mut parts: Vec<Named> = Vec::new();
    for (row, (text, latex)) in of_axis.iter().zip(CROSS) {
        if let Formula::Quotient(above, _) = &row.formula {
            parts.push(named(text, latex, above.value(setting)));
            step.push(setting, named(text, latex, 0.0), (**above).clone());
        }
    }
    let (length, norm) = length_of("‖a‖", r"\|\mathbf{a}\|", &parts, setting);
    step.push(setting, norm, length);
    for (row, part) in of_axis.iter_mut().zip(parts) {
        row.formula = over(part, norm);
    }
    step.rows.extend(of_axis);
}

/// The length of a vector whose components have names, and the name of the length.
fn length_of(text: &'static str, latex: &'static str, parts: &[Named], setting: &Setting<'_>) -> (Formula, Named) {
    let squares = parts.iter().map(|part| times([(*part).into(), (*part).into()]));
    let length = Formula::Of(Function::Root, Box::new(explain::sum(squares)));
    let norm = named(text, latex, length.value(setting));
    (length, norm)
}

/// The steps to the window.
fn window(subject: &Arc<Subject>, setting: &Setting<'_>) -> Vec<Worked> {
    let symbols = [Symbol::Height, Symbol::Width, Symbol::Left, Symbol::Right, Symbol::Bottom, Symbol::Top];
    let step = defined(subject, setting, "window", symbols);
    if step.rows.is_empty() { Vec::new() } else { vec![step] }
}

/// A step of definitions, for those symbols that have one.
fn defined(
    subject: &Arc<Subject>,
    setting: &Setting<'_>,
    heading: &'static str,
    symbols: impl IntoIterator<Item = Symbol>,
) -> Worked {
    let mut step = Worked::of(heading, "", subject);
    let mut equations: Vec<&str> = Vec::new();
    for symbol in symbols {
        if let Some(found) = definition(symbol, setting) {
            for equation in found.equation.split(", ") {
                if !equations.contains(&equation) {
                    equations.push(equation);
                }
            }
            // The camera's own number, because a formula in plain f64 may miss it by its last digit.
            let value = setting.value(symbol);
            step.rows.push(FormulaRow { symbol: symbol.into(), formula: found.formula, value });
        }
    }
    step.equation = equations.join(", ");
    step
}

/// The entries of a matrix that aren't 0 or 1 for every camera.
fn matrix(subject: &Arc<Subject>, setting: &Setting<'_>, of: Matrix) -> Worked {
    let formulas = MatrixFormula::new(of, setting);
    let mut step = Worked::of("matrix", formulas.equation, subject);
    for row in 0..4_u8 {
        for column in 0..4_u8 {
            let formula = formulas.entry(usize::from(row), usize::from(column));
            if !matches!(formula, Formula::Number(_)) {
                let symbol = Symbol::Entry(of, row, column);
                step.rows.push(FormulaRow {
                    symbol: symbol.into(),
                    formula: formula.clone(),
                    value: setting.value(symbol),
                });
            }
        }
    }
    step
}

/// The steps of a point from the world to a space.
fn trace(subject: &Arc<Subject>, setting: &Setting<'_>, point: DVec3, to: &str) -> Vec<Worked> {
    let all = explain::forward(&setting.clone().with_point(point));
    let mut wanted = to;
    let mut steps = Vec::new();
    while let Some(found) = all.iter().find(|step| step.to == wanted) {
        let rows = found.symbols.iter().zip(&found.formulas).zip(&found.output);
        let rows = rows.map(|((symbol, formula), value)| FormulaRow {
            symbol: (*symbol).into(),
            formula: formula.clone(),
            value: *value,
        });
        steps.push(Worked {
            point: Some(point),
            rows: rows.collect(),
            ..Worked::of(heading_of(found.to), found.equation.clone(), subject)
        });
        wanted = found.from;
    }
    steps.reverse();
    steps
}

fn heading_of(space: &str) -> &'static str {
    match space {
        "view" => "to-view",
        "clip" => "to-clip",
        "ndc" => "to-ndc",
        "window" => "to-window",
        "pixel" => "to-pixel",
        _ => "to-viewport",
    }
}

const DIRECTION: [(&str, &str); 3] = [("d_x", "d_x"), ("d_y", "d_y"), ("d_z", "d_z")];
const UNIT_DIRECTION: [(&str, &str); 3] =
    [("D_R,x", r"\mathbf{D}_{R,x}"), ("D_R,y", r"\mathbf{D}_{R,y}"), ("D_R,z", r"\mathbf{D}_{R,z}")];
const ORIGIN: [(&str, &str); 3] = [("O_R,x", "O_{R,x}"), ("O_R,y", "O_{R,y}"), ("O_R,z", "O_{R,z}")];

/// The ray through the centre of a pixel: (5.23) with the half, then (5.17) to (5.21).
fn ray(subject: &Arc<Subject>, setting: &Setting<'_>, [i, j]: [i64; 2], number: RayNumber) -> Worked {
    let in_perspective = setting.space().camera().projection() == Projection::Perspective;
    let equation = if in_perspective { "(5.23), (5.17)–(5.19)" } else { "(5.23), (5.20), (5.21)" };
    let mut step = Worked::of("ray", equation, subject);
    let (i, j) = (named("i", "i", i as f64), named("j", "j", j as f64));
    let share = |pixel: Named, size: Symbol| over(plus(pixel, 0.5), size);
    let x = plus(Symbol::Left, times([Symbol::Width.into(), share(i, Symbol::ImageWidth)]));
    let y = explain::minus(Symbol::Top, times([Symbol::Height.into(), share(j, Symbol::ImageHeight)]));
    let (x_p, y_p) = (named("x_p", "x_p", x.value(setting)), named("y_p", "y_p", y.value(setting)));
    step.push(setting, x_p, x);
    step.push(setting, y_p, y);
    let across = |c| {
        let part = |along: Named, axis| times([along.into(), Symbol::Axis(axis, c).into()]);
        [part(x_p, Axis::U), part(y_p, Axis::V)]
    };
    let components = Component::THREE.into_iter();
    if in_perspective && number == RayNumber::Direction {
        let mut parts = [0.0_f64; 3];
        for (k, (c, (text, latex))) in components.clone().zip(DIRECTION).enumerate() {
            let [x, y] = across(c);
            let back = times([Symbol::Near.into(), Symbol::Axis(Axis::N, c).into()]);
            let formula = explain::sum([x, y, -back]);
            parts[k] = formula.value(setting);
            step.push(setting, named(text, latex, 0.0), formula);
        }
        let part = |k: usize| named(DIRECTION[k].0, DIRECTION[k].1, parts[k]);
        let (length, norm) = length_of("‖d‖", r"\|\mathbf{d}\|", &[part(0), part(1), part(2)], setting);
        step.push(setting, norm, length);
        for (k, (text, latex)) in UNIT_DIRECTION.into_iter().enumerate() {
            step.push(setting, named(text, latex, 0.0), over(part(k), norm));
        }
    } else {
        let names = if number == RayNumber::Origin { ORIGIN } else { UNIT_DIRECTION };
        for (c, (text, latex)) in components.zip(names) {
            let formula = match (number, in_perspective) {
                (RayNumber::Origin, true) => Symbol::Position(c).into(),
                (RayNumber::Origin, false) => {
                    let [x, y] = across(c);
                    explain::sum([Symbol::Position(c).into(), x, y])
                }
                _ => -Formula::from(Symbol::Axis(Axis::N, c)),
            };
            step.push(setting, named(text, latex, 0.0), formula);
        }
    }
    step
}

const CORNER: [(&str, &str); 3] = [("P_x", "P_x"), ("P_y", "P_y"), ("P_z", "P_z")];

/// A corner of the view volume: C + x **u** + y **v** − z **n**.
fn corner(subject: &Arc<Subject>, setting: &Setting<'_>, k: usize) -> Worked {
    let mut step = Worked::of("corner", "§5.3.2", subject);
    let x = if matches!(k % 4, 0 | 3) { Symbol::Left } else { Symbol::Right };
    let y = if matches!(k % 4, 0 | 1) { Symbol::Bottom } else { Symbol::Top };
    let (depth, is_far) = if k < 4 { (Symbol::Near, false) } else { (Symbol::Far, true) };
    let spread = is_far && setting.space().camera().projection() == Projection::Perspective;
    let side =
        |side: Symbol| if spread { over(times([side.into(), Symbol::Far.into()]), Symbol::Near) } else { side.into() };
    for (c, (text, latex)) in Component::THREE.into_iter().zip(CORNER) {
        let along = |by: Formula, axis| times([by, Symbol::Axis(axis, c).into()]);
        let back = along(depth.into(), Axis::N);
        let formula =
            explain::sum([Symbol::Position(c).into(), along(side(x), Axis::U), along(side(y), Axis::V), -back]);
        step.push(setting, named(text, latex, 0.0), formula);
    }
    step
}

pub(super) mod miswritten;

#[cfg(test)]
mod tests;
