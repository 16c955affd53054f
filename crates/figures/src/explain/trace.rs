//! A point followed from space to space, with its whole arithmetic, and a pixel with a depth followed back.

use serde::Serialize;

use super::formula::{minus, over, plus, times};
use super::matrices::projection_equation;
use super::{Axis, Component, Formula, Function, Matrix, Setting, Symbol};
use crate::camera::{Ndc, Projection, Unprojected};

/// One step of a point's way. The sum of each row of `terms` is the number of `output` in that row.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Step {
    /// The space that it starts from, as `camera-lab inspect` names it.
    pub from: &'static str,
    /// The space that it leads to.
    pub to: &'static str,
    /// The equation of `[0]`, or a name.
    pub equation: String,
    /// The matrix, if the step is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub matrix: Option<[[f64; 4]; 4]>,
    /// The numbers to multiply, divide or map.
    pub input: Vec<f64>,
    /// The summands, a row for each number of `output`. In a row with a floor, the last one that belongs under the
    /// floor is the fraction that it removes.
    pub terms: Vec<Vec<f64>>,
    /// The result: the numbers of `camera-lab inspect`.
    pub output: Vec<f64>,
    /// The symbols of the output.
    #[serde(skip)]
    pub symbols: Vec<Symbol>,
    /// The formula of each number of the output.
    #[serde(skip)]
    pub formulas: Vec<Formula>,
    /// The matrix that takes the point to the next space.
    #[serde(skip)]
    pub by: Option<Matrix>,
    /// Computed with a back plane although the convention has none.
    #[serde(skip)]
    pub with_far_plane: bool,
}

impl Step {
    /// The difference between the sum of the terms of each row and the output, which is the cost of rounding the
    /// factors to `f64`.
    pub fn rests(&self) -> Vec<f64> {
        self.terms.iter().zip(&self.output).map(|(terms, out)| terms.iter().sum::<f64>() - out).collect()
    }

    /// The setting of its formulas, derived from the setting of the trace.
    pub fn setting<'a>(&self, setting: &Setting<'a>) -> Setting<'a> {
        if self.with_far_plane { setting.with_far_plane() } else { setting.clone() }
    }

    fn finite(self) -> Self {
        Self { equation: format!("{} B < ∞", self.equation), with_far_plane: true, ..self }
    }
}

/// A row of a step before it's evaluated.
struct UnevaluatedRow {
    symbol: Symbol,
    /// The products to add up.
    terms: Vec<Formula>,
    /// The summand after the floor, if there is one.
    after_floor: Option<Option<Formula>>,
}

impl UnevaluatedRow {
    fn sum(symbol: Symbol, terms: impl IntoIterator<Item = Formula>) -> Self {
        Self { symbol, terms: terms.into_iter().collect(), after_floor: None }
    }

    fn floor(symbol: Symbol, terms: impl IntoIterator<Item = Formula>, after: Option<Formula>) -> Self {
        Self { symbol, terms: terms.into_iter().collect(), after_floor: Some(after) }
    }

    fn formula(&self) -> Formula {
        let sum = if let [only] = &self.terms[..] { only.clone() } else { Formula::Sum(self.terms.clone()) };
        match &self.after_floor {
            None => sum,
            Some(None) => Formula::Of(Function::Floor, Box::new(sum)),
            Some(Some(after)) => plus(Formula::Of(Function::Floor, Box::new(sum)), after.clone()),
        }
    }

    /// The summands. The fraction that a floor removes is one of them, so that the row adds up.
    fn numbers(&self, setting: &Setting<'_>) -> Vec<f64> {
        let mut numbers: Vec<f64> = self.terms.iter().map(|term| term.value(setting) + 0.0).collect();
        if let Some(after) = &self.after_floor {
            let after = after.as_ref().map(|after| after.value(setting));
            let whole = setting.value(self.symbol) - after.unwrap_or(0.0);
            let sum: f64 = numbers.iter().sum();
            numbers.push(whole - sum);
            numbers.extend(after);
        }
        numbers
    }
}

fn step(
    setting: &Setting<'_>,
    (from, to): (&'static str, &'static str),
    equation: impl Into<String>,
    input: Vec<f64>,
    rows: Vec<UnevaluatedRow>,
) -> Step {
    Step {
        from,
        to,
        equation: equation.into(),
        matrix: None,
        input,
        terms: rows.iter().map(|row| row.numbers(setting)).collect(),
        output: rows.iter().map(|row| setting.value(row.symbol) + 0.0).collect(),
        symbols: rows.iter().map(|row| row.symbol).collect(),
        formulas: rows.iter().map(UnevaluatedRow::formula).collect(),
        by: None,
        with_far_plane: false,
    }
}

/// The rows of a matrix times a column of symbols, the fourth of which is 1.
fn matrix_step(
    setting: &Setting<'_>,
    spaces: (&'static str, &'static str),
    equation: &str,
    matrix: Matrix,
    input: [Symbol; 3],
    output: &[Symbol],
) -> Step {
    const INDICES: [u8; 4] = [0, 1, 2, 3];
    let factor = |column: u8| input.get(usize::from(column)).map_or(Formula::Number(1.0), |s| Formula::Symbol(*s));
    let rows = output.iter().zip(INDICES).map(|(symbol, row)| {
        // Products with 1 are included, because students write them.
        let product = |column| Formula::Product(vec![Symbol::Entry(matrix, row, column).into(), factor(column)]);
        UnevaluatedRow::sum(*symbol, INDICES.map(product))
    });
    let column = input.iter().map(|symbol| setting.value(*symbol)).chain([1.0]).collect();
    let numbers = setting.matrix(matrix).transpose().to_cols_array_2d().map(|row| row.map(|x| x + 0.0));
    let step = step(setting, spaces, equation, column, rows.collect());
    Step { matrix: Some(numbers), by: Some(matrix), ..step }
}

/// The way of the setting's point, from its object (if it was given there) or from the world to pixel and viewport. It
/// ends with clip coordinates if w = 0. Empty without a point.
pub fn forward(setting: &Setting<'_>) -> Vec<Step> {
    let Some(point) = setting.point() else { return Vec::new() };
    let mut steps = Vec::new();
    if setting.local().is_some() {
        let (input, output) = (Component::THREE.map(Symbol::Local), Component::THREE.map(Symbol::World));
        steps.push(matrix_step(setting, ("local", "world"), "§5.3.1", Matrix::Model, input, &output));
    }
    steps.push(to_view(setting));
    let equation = if setting.space().ndc() == Ndc::default() {
        projection_equation(setting.space().camera())
    } else {
        setting.space().ndc().name()
    };
    let (input, output) = (Component::THREE.map(Symbol::View), Component::FOUR.map(Symbol::Clip));
    steps.push(matrix_step(setting, ("view", "clip"), equation, Matrix::Projection, input, &output));
    if point.projected.is_some() {
        steps.extend([divide(setting), to_window(setting), to_pixel(setting), to_viewport(setting)]);
    }
    steps
}

/// By M_v. If the terms of the matrix cancel so far that its rows no longer add up (C far from the origin), by p − C,
/// as the program computes it.
fn to_view(setting: &Setting<'_>) -> Step {
    let (input, output) = (Component::THREE.map(Symbol::World), Component::THREE.map(Symbol::View));
    let by_matrix = matrix_step(setting, ("world", "view"), "(5.7)", Matrix::View, input, &output);
    let size = by_matrix.output.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    if by_matrix.rests().iter().all(|rest| rest.abs() <= 1e-12 * size) {
        return by_matrix;
    }
    let from_eye = |c| minus(Symbol::World(c), Symbol::Position(c));
    let rows = Axis::ALL.into_iter().zip(output).map(|(axis, symbol)| {
        UnevaluatedRow::sum(
            symbol,
            Component::THREE.map(|c| Formula::Product(vec![Symbol::Axis(axis, c).into(), from_eye(c)])),
        )
    });
    let offset = Component::THREE.map(|c| from_eye(c).value(setting)).to_vec();
    step(setting, ("world", "view"), "(5.7), p − C", offset, rows.collect())
}

/// (5.6).
fn divide(setting: &Setting<'_>) -> Step {
    let input = Component::FOUR.map(|c| setting.value(Symbol::Clip(c))).to_vec();
    let row = |c| UnevaluatedRow::sum(Symbol::Ndc(c), [over(Symbol::Clip(c), Symbol::Clip(Component::W))]);
    step(setting, ("clip", "ndc"), "(5.6)", input, Component::THREE.map(row).into())
}

/// (5.9) and (5.10); in parallel projection (x_p, y_p) = (x_c, y_c).
fn to_window(setting: &Setting<'_>) -> Step {
    let input = Component::THREE.map(|c| setting.value(Symbol::View(c))).to_vec();
    let perspective = setting.space().camera().projection() == Projection::Perspective;
    let row = |c| {
        let formula = if perspective {
            over(times([Symbol::Near.into(), Symbol::View(c).into()]), -Formula::from(Symbol::View(Component::Z)))
        } else {
            Symbol::View(c).into()
        };
        UnevaluatedRow::sum(Symbol::Window(c), [formula])
    };
    let equation = if perspective { "(5.9), (5.10)" } else { "§5.3.2" };
    step(setting, ("view", "window"), equation, input, vec![row(Component::X), row(Component::Y)])
}

/// (5.22), for a window that may be asymmetric.
fn to_pixel(setting: &Setting<'_>) -> Step {
    let input = [Component::X, Component::Y].map(|c| setting.value(Symbol::Window(c))).to_vec();
    let scaled = |pixels: Symbol, size: Symbol, x: Symbol| times([over(pixels, size), x.into()]);
    let (columns, rows) = (Symbol::ImageWidth, Symbol::ImageHeight);
    let (x, y) = (Symbol::Window(Component::X), Symbol::Window(Component::Y));
    let (from_left, from_top) = if setting.space().camera().has_symmetric_window() {
        (over(columns, 2.0), over(rows, 2.0))
    } else {
        (-scaled(columns, Symbol::Width, Symbol::Left), scaled(rows, Symbol::Height, Symbol::Top))
    };
    let rows = vec![
        UnevaluatedRow::floor(Symbol::Pixel(Component::X), [scaled(columns, Symbol::Width, x), from_left], None),
        UnevaluatedRow::floor(Symbol::Pixel(Component::Y), [from_top, -scaled(rows, Symbol::Height, y)], None),
    ];
    step(setting, ("window", "pixel"), "(5.22)", input, rows)
}

/// (5.24) and (5.25). They come from the notes, whose NDC has a far plane. Without one, the same convention with a far
/// plane is used.
fn to_viewport(setting: &Setting<'_>) -> Step {
    let ndc = setting.space().ndc();
    if ndc.infinite {
        return to_viewport(&setting.with_far_plane()).finite();
    }
    let input = Component::THREE.map(|c| setting.value(Symbol::Ndc(c))).to_vec();
    let entry = |row, column| Formula::from(Symbol::Entry(Matrix::Viewport, row, column));
    let along = |output, size: Symbol, start: Symbol, ndc: Symbol, down: bool| {
        let half = || over(size, 2.0);
        let scaled = times([half(), ndc.into()]);
        UnevaluatedRow::floor(output, [if down { -scaled } else { scaled }, half()], Some(start.into()))
    };
    let (x, y, z) = (Component::X, Component::Y, Component::Z);
    let depth = [times([entry(2, 2), Symbol::Ndc(z).into()]), entry(2, 3)];
    let rows = vec![
        along(Symbol::Viewport(x), Symbol::ViewportWidth, Symbol::ViewportX, Symbol::Ndc(x), false),
        along(Symbol::Viewport(y), Symbol::ViewportHeight, Symbol::ViewportY, Symbol::Ndc(y), ndc.y_points_down()),
        UnevaluatedRow::sum(Symbol::Viewport(z), depth),
    ];
    step(setting, ("ndc", "viewport"), "(5.24), (5.25)", input, rows)
}

/// The way back from the centre of a pixel with a depth Z: (5.23), (5.25), then the inverses of M_p and M_v. Empty if
/// the way leaves the range of numbers.
///
/// The formulas have their numbers in [`Step::setting`] of the setting [with the way](Setting::with_way_back). Without
/// a far plane, the convention with one is used, because Z of (5.25) has one.
pub fn back(setting: &Setting<'_>, way: &Unprojected) -> Vec<Step> {
    if setting.space().ndc().infinite {
        let finite = setting.with_far_plane();
        let again = finite.space().way_back(finite.image(), &finite.viewport(), way.pixel, way.depth);
        let steps = again.map(|way| back(&finite, &way)).unwrap_or_default();
        return steps.into_iter().map(Step::finite).collect();
    }
    let setting = &setting.clone().with_way_back(way);
    let (three, four) = (Component::THREE, Component::FOUR);
    let to_homogeneous = matrix_step(
        setting,
        ("ndc", "homogeneous"),
        Matrix::InverseProjection.text(),
        Matrix::InverseProjection,
        three.map(Symbol::Ndc),
        &four.map(Symbol::Homogeneous),
    );
    let divided = {
        let input = four.map(|c| setting.value(Symbol::Homogeneous(c))).to_vec();
        let row =
            |c| UnevaluatedRow::sum(Symbol::View(c), [over(Symbol::Homogeneous(c), Symbol::Homogeneous(Component::W))]);
        step(setting, ("homogeneous", "view"), "÷ w", input, three.map(row).into())
    };
    let to_world = matrix_step(
        setting,
        ("view", "world"),
        Matrix::InverseView.text(),
        Matrix::InverseView,
        three.map(Symbol::View),
        &three.map(Symbol::World),
    );
    vec![window_of_pixel(setting), ndc_of_window(setting), to_homogeneous, divided, to_world]
}

/// (5.23), for the centre of a pixel.
fn window_of_pixel(setting: &Setting<'_>) -> Step {
    let centre = |c| plus(Symbol::Pixel(c), over(1.0, 2.0));
    let scaled = |size: Symbol, pixels: Symbol, c| times([over(size, pixels), centre(c)]);
    let (x, y) = (Component::X, Component::Y);
    let input = [x, y].map(|c| centre(c).value(setting)).to_vec();
    let rows = vec![
        UnevaluatedRow::sum(Symbol::Window(x), [scaled(Symbol::Width, Symbol::ImageWidth, x), Symbol::Left.into()]),
        UnevaluatedRow::sum(Symbol::Window(y), [Symbol::Top.into(), -scaled(Symbol::Height, Symbol::ImageHeight, y)]),
    ];
    step(setting, ("pixel", "window"), "(5.23)", input, rows)
}

/// (5.11) and (5.12) for x_n and y_n, (5.25) solved for z_n.
fn ndc_of_window(setting: &Setting<'_>) -> Step {
    let (x, y, z) = (Component::X, Component::Y, Component::Z);
    let input = [Symbol::Window(x), Symbol::Window(y), Symbol::Viewport(z)].map(|s| setting.value(s)).to_vec();
    let middle = |a: Symbol, b: Symbol, size: Symbol| over(plus(a, b), size);
    let scaled = |c, size: Symbol| times([over(2.0, size), Symbol::Window(c).into()]);
    let (height, middle_y) = (scaled(y, Symbol::Height), middle(Symbol::Top, Symbol::Bottom, Symbol::Height));
    let row_y = if setting.space().ndc().y_points_down() { [-height, middle_y] } else { [height, -middle_y] };
    let entry = |column| Formula::from(Symbol::Entry(Matrix::InverseViewport, 2, column));
    let rows = vec![
        UnevaluatedRow::sum(
            Symbol::Ndc(x),
            [scaled(x, Symbol::Width), -middle(Symbol::Right, Symbol::Left, Symbol::Width)],
        ),
        UnevaluatedRow::sum(Symbol::Ndc(y), row_y),
        UnevaluatedRow::sum(Symbol::Ndc(z), [times([entry(2), Symbol::Viewport(z).into()]), entry(3)]),
    ];
    step(setting, ("window", "ndc"), "(5.11), (5.12), (5.25)", input, rows)
}
