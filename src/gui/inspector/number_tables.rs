//! The numbers of a report as tables, with their symbols, names and rows, ready for display.

use std::borrow::Cow;

use crate::camera::{Camera, Convention, Ndc};
use crate::explain::{Matrix, projection_equation};
use crate::inspect::quantity::{BasisAxis, Quantity, ReportMatrix, WindowNumber};
use crate::inspect::{Asked, Bounds, Report};
use crate::numbers::{self, DecimalMark, without_rests};
use camera_lab_desk::{Conventions, Model};
use camera_lab_words::command_line;
use camera_lab_words::why::conventions;
use camera_lab_words::window::{self, Texts};

/// The numbers of the figure in a convention of NDC.
pub(in crate::gui) fn report(model: &Model, ndc: Ndc) -> Option<Report> {
    let figure = model.desk.shown.figure();
    let camera = model.desk.shown.camera();
    // What's proved are the numbers of the figure as its file has them.
    let camera = if model.settings.bounds { camera.rounded() } else { camera.clone() };
    Report::of(&camera.possible_clip_space(ndc), figure.image, figure.viewport, &[], &[]).ok()
}

/// The bounds of such a report.
pub(in crate::gui) fn bounds(model: &Model, ndc: Ndc, report: &Report) -> Bounds {
    let (figure, camera) = (model.desk.shown.figure(), model.desk.shown.camera());
    let way = (camera.parameters(), &[][..], Convention::default());
    Bounds::new(report, way, camera.possible_clip_space(ndc).ndc(), (figure.image, figure.viewport))
}

/// The bounds of each number of a table on a line, with the digits that they prove. The table with one end of each
/// interval, and that with the other.
pub(in crate::gui) fn proof(t: &Texts, [one, other]: [&Table; 2]) -> String {
    let mut lines = Vec::new();
    for (i, ((name, low), (_, high))) in one.rows.iter().zip(&other.rows).enumerate() {
        for (j, (a, b)) in low.iter().zip(high).enumerate() {
            // A changed sign exchanges the ends.
            let pair = (!a.is_nan() && !b.is_nan()).then(|| [a.min(*b), a.max(*b)]);
            let row = if name.is_empty() { (i + 1).to_string() } else { name.clone() };
            let proof = t.lang.mark().printed(&command_line::bounds(t.lang, pair));
            lines.push(format!("{row}, {}: {proof}", j + 1));
        }
    }
    lines.join("\n")
}

/// All numbers of the figure as text with all their digits, for programs.
pub(in crate::gui) fn text(model: &Model) -> String {
    let (t, shown) = (window::texts(model.settings.lang), model.settings.conventions);
    let Some(report) = report(model, shown.ndc) else { return String::new() };
    let tables = |inverse: bool| tables(t, (model.desk.shown.camera(), &report), inverse, shown);
    let inverses = tables(true).into_iter().filter(|table| table.symbol.contains('⁻'));
    let mut text = String::new();
    let all = tables(false).into_iter().chain(inverses);
    for table in all.filter(|table| !table.is_asked(&model.frame.asked)) {
        let title = format!("{} {}", table.symbol, table.name);
        text.push_str(title.trim());
        text.push('\n');
        text.push_str(&lines(&table.rows, |value| numbers::significant(value, numbers::EXACT_DIGITS)).join("\n"));
        text.push_str("\n\n");
    }
    text
}

/// A group of numbers: its symbol, its name with the equation, and its rows.
pub(in crate::gui) struct Table {
    pub(in crate::gui) symbol: Cow<'static, str>,
    pub(in crate::gui) name: String,
    pub(in crate::gui) rows: Vec<(String, Vec<f64>)>,
    /// An erratum of the notes: the printed version and the correction.
    pub(in crate::gui) erratum: Option<&'static str>,
    /// A number that can be a rounding error of zero, relative to its row, is shown as 0.
    rests: bool,
    /// True if it has other numbers in another convention of NDC.
    pub(in crate::gui) follows_ndc: bool,
    /// The quantities that it prints.
    quantities: Vec<Quantity>,
    /// The matrix whose entries these numbers are, by rows from its first.
    of: Option<Matrix>,
    /// Its rows are the matrix's columns.
    transposed: bool,
}

impl Table {
    fn new(symbol: &'static str, name: &str, rows: Vec<(String, Vec<f64>)>) -> Self {
        let (symbol, name) = (symbol.into(), name.to_owned());
        let (quantities, of) = (Vec::new(), None);
        Self { symbol, name, rows, erratum: None, rests: false, follows_ndc: false, quantities, of, transposed: false }
    }

    /// A matrix. `left_handed`: the effect of the other sign of z_c.
    fn matrix(matrix: Matrix, name: &str, mut rows: [[f64; 4]; 4], left_handed: Mirrored, shown: Conventions) -> Self {
        if shown.left_handed {
            match left_handed {
                Mirrored::Row => rows[2] = rows[2].map(|x| 0.0 - x),
                Mirrored::Column => rows.iter_mut().for_each(|row| row[2] = 0.0 - row[2]),
                Mirrored::Nothing => {}
            }
        }
        let mut symbol = Cow::from(matrix.text());
        if shown.row_vectors {
            rows = std::array::from_fn(|i| std::array::from_fn(|j| rows[j][i]));
            symbol = transposed(&symbol).into();
        }
        let rows = rows.iter().map(|row| (String::new(), row.to_vec())).collect();
        let printed = ReportMatrix::ALL.iter().find(|of| Matrix::from(**of) == matrix);
        let quantities = printed.iter().map(|matrix| Quantity::Matrix(**matrix)).collect();
        Self { symbol, of: Some(matrix), transposed: shown.row_vectors, quantities, ..Self::new("", name, rows) }
    }

    /// True if a question asks for one of its numbers. Then none is printed.
    pub(in crate::gui) fn is_asked(&self, asked: &Asked) -> bool {
        let numbers: Vec<f64> = self.rows.iter().flat_map(|(_, values)| values).copied().collect();
        asked.hides(&self.quantities, &numbers)
    }

    fn of_quantities(self, quantities: &[Quantity]) -> Self {
        Self { quantities: quantities.to_vec(), ..self }
    }

    /// The entry of a matrix that a number is. `None` if it isn't one.
    pub(in crate::gui) fn entry(&self, row: usize, column: usize) -> Option<(Matrix, [usize; 2])> {
        self.of.map(|matrix| (matrix, if self.transposed { [column, row] } else { [row, column] }))
    }

    fn in_ndc(self) -> Self {
        Self { follows_ndc: true, ..self }
    }

    fn rows_of(self, matrix: Matrix) -> Self {
        Self { of: Some(matrix), ..self }
    }

    fn with_rests(self) -> Self {
        Self { rests: true, ..self }
    }

    /// The rows of a matrix have no names.
    pub(in crate::gui) fn is_matrix(&self) -> bool {
        self.rows.iter().all(|(name, _)| name.is_empty())
    }

    /// The rows as aligned cells. All numbers that aren't whole have the same decimals, so that neither they nor their
    /// columns hop while they change.
    pub(in crate::gui) fn written(&self, digits: usize, mark: DecimalMark) -> Vec<Vec<String>> {
        let clean = |values: &[f64]| if self.rests { without_rests(values, digits) } else { values.to_vec() };
        let rows: Vec<_> = self.rows.iter().map(|(name, values)| (name.clone(), clean(values))).collect();
        let values = || rows.iter().flat_map(|(_, values)| values).copied();
        let decimals = decimals(values().fold(0.0, |most: f64, v| most.max(v.abs())), digits);
        let Some(decimals) = decimals.filter(|_| !values().all(is_whole)) else {
            return cells(&rows, |value| mark.number(value, digits), [0, 0]);
        };
        // Room for a sign and a digit, and for the decimals, also if a number happens to have none.
        cells(&rows, |value| mark.printed(&fixed(value, decimals)), [2, decimals + 1])
    }
}

/// The decimals of numbers of which the greatest is `most`, one fewer than the digits. `None` if each has its own
/// digits, since all are wanted or the numbers are too great.
fn decimals(most: f64, digits: usize) -> Option<usize> {
    let beyond = [1e3, 1e4, 1e5, 1e6].iter().filter(|power| most >= **power).count();
    if digits >= numbers::EXACT_DIGITS || beyond == 4 { None } else { Some((digits - 1).saturating_sub(beyond)) }
}

fn is_whole(value: f64) -> bool {
    value == value.trunc()
}

/// A number with this number of decimals. A whole one has none. If it would look like 0, it has an exponent.
fn fixed(value: f64, decimals: usize) -> String {
    if is_whole(value) {
        return format!("{:.0}", value + 0.0);
    }
    let text = format!("{value:.decimals$}");
    if text.contains(|c: char| ('1'..='9').contains(&c)) { text } else { format!("{value:.1e}") }
}

/// The part of a matrix that changes sign if z_c grows along DOP.
#[derive(Clone, Copy)]
enum Mirrored {
    /// Its third row: it leads to view space.
    Row,
    /// Its third column, because it comes from view space.
    Column,
    /// No part.
    Nothing,
}

/// The symbol of a transposed matrix. For a product, the factors in reverse.
fn transposed(symbol: &str) -> String {
    let factor = |factor: &str| if factor.contains('⁻') { format!("({factor})ᵀ") } else { format!("{factor}ᵀ") };
    symbol.split(' ').rev().map(factor).collect::<Vec<_>>().join(" ")
}

fn named<const N: usize>(rows: &[(&str, [f64; N])]) -> Vec<(String, Vec<f64>)> {
    rows.iter().map(|(name, values)| ((*name).to_owned(), values.to_vec())).collect()
}

/// The tables of a report about `camera`.
pub(in crate::gui) fn tables(
    t: &'static Texts,
    (camera, r): (&Camera, &Report),
    inverse: bool,
    shown: Conventions,
) -> Vec<Table> {
    let w = &r.window;
    let window: Vec<Quantity> = WindowNumber::ALL.iter().copied().map(Quantity::Window).collect();
    let corner = |i: usize| {
        (
            format!("{} ({})", i + 1, ["l,b,F", "r,b,F", "r,t,F", "l,t,F", "l,b,B", "r,b,B", "r,t,B", "l,t,B"][i]),
            r.volume_corners[i].to_vec(),
        )
    };
    let mut tables = vec![
        Table::new("DOP, D", t.dop_name, vec![("DOP".into(), r.dop.to_vec()), ("D".into(), vec![r.distance])])
            .with_rests()
            .of_quantities(&[Quantity::Direction, Quantity::Distance]),
        Table::new("u, v, n", t.basis_name, named(&[("u", r.basis.u), ("v", r.basis.v), ("n", r.basis.n)]))
            .with_rests()
            .rows_of(Matrix::View)
            .of_quantities(&[Quantity::Axis(BasisAxis::U)]),
        Table::new(
            "l r b t",
            t.window_name,
            named(&[("l, r", [w.left, w.right]), ("b, t", [w.bottom, w.top]), ("W, H", [w.width, w.height])])
                .into_iter()
                .chain([("A".into(), vec![w.aspect])])
                .collect(),
        )
        .of_quantities(&window),
    ];
    // Entries of M_p can differ by any factor, and each is exact. None is a rounding error of another.
    if inverse {
        let view =
            Table::matrix(Matrix::InverseView, t.inverse_view_name, r.inverse_view_matrix, Mirrored::Column, shown);
        let name = in_convention(t, t.inverse_projection_name, "", r);
        let projection =
            Table::matrix(Matrix::InverseProjection, &name, r.inverse_projection_matrix, Mirrored::Row, shown);
        tables.extend([view.with_rests(), projection.in_ndc()]);
    } else {
        let view = Table::matrix(Matrix::View, t.view_name, r.view_matrix, Mirrored::Row, shown);
        let name = in_convention(t, t.projection_name, projection_equation(camera), r);
        let projection = Table::matrix(Matrix::Projection, &name, r.projection_matrix, Mirrored::Column, shown);
        let of_the_notes = r.ndc == Ndc::default().name() && !shown.row_vectors && !shown.left_handed;
        let erratum = (of_the_notes && r.camera.projection != "perspective").then_some(t.erratum_parallel);
        let name = in_convention(t, t.product_name, "", r);
        let product = Table::matrix(Matrix::ViewProjection, &name, r.view_projection_matrix, Mirrored::Nothing, shown);
        tables.extend([view.with_rests(), Table { erratum, ..projection.in_ndc() }, product.in_ndc()]);
    }
    tables.push(
        Table::new("", t.corners_name, (0..8).map(corner).collect()).with_rests().of_quantities(&[Quantity::Corner(0)]),
    );
    tables
}

/// A name with the equation of the notes, or with the convention if that is another.
fn in_convention(t: &Texts, name: &str, equation: &str, report: &Report) -> String {
    let ndc = ndc_of(report);
    let more =
        if ndc == Ndc::default() { equation.to_owned() } else { format!("· {}", conventions::name(t.lang, ndc)) };
    if more.is_empty() { name.to_owned() } else { format!("{name} {more}") }
}

/// The convention of a report.
pub(in crate::gui) fn ndc_of(report: &Report) -> Ndc {
    Ndc::ALL.into_iter().find(|ndc| ndc.name() == report.ndc).unwrap_or_default()
}

/// The rows as aligned cells. In each column the decimal points stand below each other. `before` and `from` are the
/// fewest characters before a point and from it on. Names come first, if there are any.
fn cells(rows: &[(String, Vec<f64>)], write: impl Fn(f64) -> String, [before, from]: [usize; 2]) -> Vec<Vec<String>> {
    let names = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let columns = rows.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
    let halves = |v: &f64| {
        let text = write(*v);
        let point = text.find(['.', ',', 'e']).unwrap_or(text.len());
        (text[..point].to_owned(), text[point..].to_owned())
    };
    let halved: Vec<Vec<(String, String)>> =
        rows.iter().map(|(_, values)| values.iter().map(halves).collect()).collect();
    let width = |column: usize| {
        let cells = halved.iter().filter_map(|row| row.get(column));
        cells.fold((before, from), |(left, right), (a, b)| (left.max(a.chars().count()), right.max(b.chars().count())))
    };
    let widths: Vec<(usize, usize)> = (0..columns).map(width).collect();
    rows.iter()
        .zip(&halved)
        .map(|((name, _), cells)| {
            let padded = cells.iter().zip(&widths).map(|((a, b), (left, right))| format!("{a:>left$}{b:<right$}"));
            let head = if names == 0 { Vec::new() } else { vec![format!("{name:<names$}")] };
            head.into_iter().chain(padded).collect()
        })
        .collect()
}

/// The rows as aligned text.
pub(in crate::gui) fn lines(rows: &[(String, Vec<f64>)], write: impl Fn(f64) -> String) -> Vec<String> {
    cells(rows, write, [0, 0]).iter().map(|cells| cells.join(GAP).trim_end().to_owned()).collect()
}

/// Between two columns.
pub(in crate::gui) const GAP: &str = "  ";

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]
    use super::*;

    #[test]
    fn decimal_points_stand_below_each_other() {
        let rows = named(&[("u", [1.0, -0.5, 2e-9]), ("n", [-10.25, 0.0, 3.0])]);
        let write = |mark: DecimalMark| move |value: f64| mark.number(value, 5);
        assert_eq!(lines(&rows, write(DecimalMark::Point)), ["u    1     −0.5  2e−9", "n  −10.25   0    3"]);
        assert_eq!(lines(&rows, write(DecimalMark::Comma)), ["u    1     −0,5  2e−9", "n  −10,25   0    3"]);
        let rows = [1.0, 20.0].map(|x| (String::new(), vec![x; 4]));
        assert_eq!(lines(&rows, write(DecimalMark::Point))[1], "20  20  20  20");
    }

    #[test]
    fn a_matrix_has_one_number_of_decimals() {
        let written = |values: [[f64; 2]; 2], digits| {
            let rows = values.map(|row| (String::new(), row.to_vec())).to_vec();
            let cells = Table::new("M", "", rows).written(digits, DecimalMark::Point);
            cells.iter().map(|row| row.join(GAP)).collect::<Vec<_>>()
        };
        assert_eq!(written([[0.5, -1.6094], [0.0, 12.25]], 5), [" 0.5000  −1.6094", " 0       12.2500"]);
        // A number that passes through 1 moves no other.
        let widths = [0.9999, 1.0, 1.0001].map(|x| written([[x, 0.25], [0.0, 1.0]], 5)[0].chars().count());
        assert_eq!(widths, [widths[0]; 3]);
        assert_eq!(written([[1.0, 0.0], [0.0, 1.0]], 5), ["1  0", "0  1"]);
        assert_eq!(written([[2e-7, 0.5], [0.0, 1.0]], 5)[0], " 2.0e−7   0.5000");
        assert_eq!(written([[12345.678, 0.5], [0.0, 1.0]], 5)[0], "12345.68   0.50");
        assert_eq!(written([[0.1 + 0.2, 0.0], [0.0, 1.0]], 17)[0], "0.30000000000000004  0");
    }

    #[test]
    fn the_equation_of_the_projection_matrix_is_the_one_in_force() {
        use crate::camera::{Camera, ImageSize, Parameters, Projection, ViewWindow};
        let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
        for (projection, window, equation) in [
            (Projection::Perspective, window, "(5.13)"),
            (Projection::Perspective, None, "(5.14)"),
            (Projection::Parallel, window, "(5.15)"),
            (Projection::Parallel, None, "(5.16)"),
        ] {
            let camera = Camera::new(&Parameters { projection, window, ..Parameters::default() }).unwrap();
            let report = Report::of(&camera.notes_clip_space(), ImageSize::default(), None, &[], &[]).unwrap();
            let tables = tables(window_texts(), (&camera, &report), false, Conventions::default());
            let named = |table: &Table| table.symbol == "M_p" && table.name.ends_with(equation);
            assert!(tables.iter().any(named), "{equation}");
            let erratum = tables.into_iter().any(|table| table.erratum.is_some());
            assert_eq!(erratum, projection == Projection::Parallel);
        }
    }

    fn window_texts() -> &'static Texts {
        window::texts(camera_lab_words::Lang::En)
    }

    #[test]
    fn rows_and_the_left_hand_show_the_same_matrices() {
        use glam::DMat4;

        use crate::camera::{Camera, ImageSize, Parameters, ViewWindow};
        let window = Some(ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0 });
        let camera = Camera::new(&Parameters { window, ..Parameters::default() }).unwrap();
        let report = Report::of(&camera.notes_clip_space(), ImageSize::default(), None, &[], &[]).unwrap();
        let shown = |symbol: &str, inverse, conventions| {
            let all = tables(window_texts(), (&camera, &report), inverse, conventions);
            let table = all.into_iter().find(|table| table.symbol == symbol).unwrap();
            let rows: Vec<[f64; 4]> = table.rows.into_iter().map(|(_, row)| [row[0], row[1], row[2], row[3]]).collect();
            DMat4::from_cols_array_2d(&[rows[0], rows[1], rows[2], rows[3]]).transpose()
        };
        let plain = Conventions::default();
        let left = Conventions { left_handed: true, ..plain };
        let rows = Conventions { row_vectors: true, ..plain };
        let z_c = |conventions| shown("M_v", false, conventions).row(2);
        assert_eq!(z_c(left), -z_c(plain), "z_c grows along DOP");
        for (forth, back) in [("M_v", "M_v⁻¹"), ("M_p", "M_p⁻¹")] {
            let product = shown(back, true, left) * shown(forth, false, left);
            assert!(product.abs_diff_eq(DMat4::IDENTITY, 1e-9), "{forth}: {product}");
            assert_eq!(shown(&transposed(forth), false, rows), shown(forth, false, plain).transpose());
            assert_eq!(shown(&transposed(back), true, rows), shown(back, true, plain).transpose());
        }
        let product = shown("M_p", false, left) * shown("M_v", false, left);
        assert!(product.abs_diff_eq(shown("M_p M_v", false, left), 1e-12));
        assert_eq!(shown("M_p M_v", false, left), shown("M_p M_v", false, plain));
        assert_eq!(transposed("M_p M_v"), "M_vᵀ M_pᵀ");
        assert_eq!(transposed("M_p⁻¹"), "(M_p⁻¹)ᵀ");
    }
}
