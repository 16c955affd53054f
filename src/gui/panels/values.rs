//! The numbers: basis, matrices, window, corners. Each one is what `camera-lab inspect` prints for the same figure.

use eframe::egui::{self, RichText};

use super::{TEXT_LINE, complaint, erratum, section};
use crate::gui::number_field::{NumberField, Step};
use crate::gui::state::State;
use crate::gui::theme;
use crate::gui::tooltip::Explained;
use crate::i18n::window::{self, Texts};
use crate::inspect::Report;
use crate::numbers::{self, without_rests};

/// The numbers of the figure.
fn report(state: &State) -> Option<Report> {
    let figure = state.document.figure();
    Report::of(&state.document.camera().notes_clip_space(), figure.image, figure.viewport, &[], &[]).ok()
}

/// Shows the numbers.
pub fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    section(ui, t.numbers, "numbers", true, |ui| {
        let Some(report) = report(state) else { return };
        toolbar(ui, t, state, &report);
        for table in tables(t, &report, state.settings.inverse) {
            show(ui, t, (&report, &table), state.settings.digits);
        }
    });
    let warnings = state.warnings();
    if !warnings.is_empty() {
        section(ui, t.warnings, "warnings", true, |ui| {
            for warning in warnings {
                let color = ui.visuals().warn_fg_color;
                ui.label(RichText::new(format!("⚠ {warning}")).color(color));
            }
        });
    }
}

fn toolbar(ui: &mut egui::Ui, t: &'static Texts, state: &mut State, report: &Report) {
    let error = ui.horizontal(|ui| {
        ui.label(t.digits).explained(t.digits_hint);
        let mut digits = state.settings.digits as f64;
        let field = NumberField::new(t.digits, Step::Add(1.0)).whole().within(2.0..=17.0);
        let output = field.width(40.0).hint(t.digits_hint).show(ui, t, &mut digits);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole, between 2 and 17")]
        let digits = digits as usize;
        state.settings.digits = digits;
        ui.checkbox(&mut state.settings.inverse, t.inverse).explained(t.inverse_hint);
        if ui.button(t.copy).explained(t.copy_numbers_hint).clicked() {
            ui.ctx().copy_text(text(t, report));
        }
        output.error
    });
    if let Some(error) = error.inner {
        complaint(ui, &error.text(t.lang));
    }
}

/// A group of numbers: its symbol, its name with the equation, and its rows.
struct Table {
    symbol: &'static str,
    name: &'static str,
    rows: Vec<(String, Vec<f64>)>,
    /// Where the notes print something else: what, and what is right.
    erratum: Option<&'static str>,
    /// What rounding can have left of zero, beside its row, is shown as 0.
    rests: bool,
}

impl Table {
    fn new(symbol: &'static str, name: &'static str, rows: Vec<(String, Vec<f64>)>) -> Self {
        Self { symbol, name, rows, erratum: None, rests: false }
    }

    fn with_rests(self) -> Self {
        Self { rests: true, ..self }
    }

    /// The rows of a matrix have no names.
    fn is_matrix(&self) -> bool {
        self.rows.iter().all(|(name, _)| name.is_empty())
    }

    /// The rows as they are shown with so many digits.
    fn shown(&self, digits: usize) -> Vec<(String, Vec<f64>)> {
        let clean = |values: &[f64]| if self.rests { without_rests(values, digits) } else { values.to_vec() };
        self.rows.iter().map(|(name, values)| (name.clone(), clean(values))).collect()
    }
}

/// The equation of M_p that is in force, `[0]` (5.13) to (5.16).
fn projection_equation(r: &Report) -> &'static str {
    let w = &r.window;
    match (r.camera.projection == "perspective", w.left == -w.right && w.bottom == -w.top) {
        (true, false) => "(5.13)",
        (true, true) => "(5.14)",
        (false, false) => "(5.15)",
        (false, true) => "(5.16)",
    }
}

fn named<const N: usize>(rows: &[(&str, [f64; N])]) -> Vec<(String, Vec<f64>)> {
    rows.iter().map(|(name, values)| ((*name).to_owned(), values.to_vec())).collect()
}

fn matrix(rows: &[[f64; 4]; 4]) -> Vec<(String, Vec<f64>)> {
    rows.iter().map(|row| (String::new(), row.to_vec())).collect()
}

fn tables(t: &'static Texts, r: &Report, inverse: bool) -> Vec<Table> {
    let (view, projection) = if inverse {
        (&r.inverse_view_matrix, &r.inverse_projection_matrix)
    } else {
        (&r.view_matrix, &r.projection_matrix)
    };
    let w = &r.window;
    let corner = |i: usize| {
        (
            format!("{} ({})", i + 1, ["l,b,F", "r,b,F", "r,t,F", "l,t,F", "l,b,B", "r,b,B", "r,t,B", "l,t,B"][i]),
            r.volume_corners[i].to_vec(),
        )
    };
    let mut tables = vec![
        Table::new("DOP, D", t.dop_name, vec![("DOP".into(), r.dop.to_vec()), ("D".into(), vec![r.distance])])
            .with_rests(),
        Table::new("u, v, n", t.basis_name, named(&[("u", r.basis.u), ("v", r.basis.v), ("n", r.basis.n)]))
            .with_rests(),
        Table::new(
            "l r b t",
            t.window_name,
            named(&[("l, r", [w.left, w.right]), ("b, t", [w.bottom, w.top]), ("W, H", [w.width, w.height])])
                .into_iter()
                .chain([("A".into(), vec![w.aspect])])
                .collect(),
        ),
    ];
    // Entries of M_p can differ by any factor, and each is exact: none is a rest of another.
    if inverse {
        tables.push(Table::new("M_v⁻¹", t.inverse_view_name, matrix(view)).with_rests());
        tables.push(Table::new("M_p⁻¹", t.inverse_projection_name, matrix(projection)));
    } else {
        let erratum = (r.camera.projection != "perspective").then_some(t.erratum_parallel);
        tables.push(Table::new("M_v", t.view_name, matrix(view)).with_rests());
        tables.push(Table { erratum, ..Table::new("M_p", t.projection_name, matrix(projection)) });
        tables.push(Table::new("M_p M_v", t.product_name, matrix(&r.view_projection_matrix)));
    }
    tables.push(Table::new("", t.corners_name, (0..8).map(corner).collect()).with_rests());
    tables
}

fn show(ui: &mut egui::Ui, t: &'static Texts, (report, table): (&Report, &Table), digits: usize) {
    ui.add_space(3.0);
    ui.spacing_mut().item_spacing.y = 1.0;
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = TEXT_LINE;
        ui.spacing_mut().item_spacing.x = 5.0;
        if !table.symbol.is_empty() {
            ui.label(theme::symbol(ui, table.symbol));
        }
        ui.label(RichText::new(title(report, table)).small().weak());
        if let Some(text) = table.erratum {
            erratum(ui, t, text);
        }
    });
    let room = ui.available_width() - 18.0;
    egui::ScrollArea::horizontal().id_salt(table.name).show(ui, |ui| {
        let written = |digits: usize| {
            let write = |value: f64| t.lang.mark().number(value, digits);
            lines(&table.shown(digits), write).join("\n")
        };
        // Few digits are rounded to what fits; whoever wants many scrolls.
        let mut fitting = digits;
        while (3..=MOST_TO_FIT).contains(&fitting) && width(ui, &written(fitting)) > room {
            fitting -= 1;
        }
        let label = egui::Label::new(RichText::new(written(fitting)).monospace()).extend();
        if table.is_matrix() {
            let frame = egui::Frame::NONE.inner_margin(egui::Margin::symmetric(8, 0));
            let place = frame.show(ui, |ui| ui.add(label)).response.rect;
            brackets(ui, place);
        } else {
            ui.add(label);
        }
    });
}

/// So many digits are rounded further where they do not fit.
const MOST_TO_FIT: usize = 7;

fn width(ui: &egui::Ui, text: &str) -> f32 {
    let font = egui::TextStyle::Monospace.resolve(ui.style());
    ui.painter().layout_no_wrap(text.to_owned(), font, ui.visuals().text_color()).size().x
}

/// What a table is, with the equation that is in force.
fn title(report: &Report, table: &Table) -> String {
    match table.symbol {
        "M_p" => format!("{} {}", table.name, projection_equation(report)),
        _ => table.name.to_owned(),
    }
}

/// How far the ends of a bracket reach, in points.
const BRACKET: f32 = 4.0;

/// Square brackets at both sides of a place.
fn brackets(ui: &egui::Ui, place: egui::Rect) {
    let stroke = egui::Stroke::new(1.0, ui.visuals().weak_text_color());
    let (top, bottom) = (place.top() + 1.0, place.bottom() - 1.0);
    for (x, inwards) in [(place.left() + 1.0, BRACKET), (place.right() - 1.0, -BRACKET)] {
        let points = [(x + inwards, top), (x, top), (x, bottom), (x + inwards, bottom)];
        ui.painter().line(points.map(|(x, y)| egui::pos2(x, y)).to_vec(), stroke);
    }
}

/// The rows as aligned text: in each column the decimal points stand below each other.
fn lines(rows: &[(String, Vec<f64>)], write: impl Fn(f64) -> String) -> Vec<String> {
    let names = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let columns = rows.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
    let halves = |v: &f64| {
        let text = write(*v);
        let point = text.find(['.', ',', 'e']).unwrap_or(text.len());
        (text[..point].to_owned(), text[point..].to_owned())
    };
    let cells: Vec<Vec<(String, String)>> =
        rows.iter().map(|(_, values)| values.iter().map(halves).collect()).collect();
    let width = |column: usize| {
        let cells = cells.iter().filter_map(|row| row.get(column));
        cells.fold((0, 0), |(left, right), (a, b)| (left.max(a.chars().count()), right.max(b.chars().count())))
    };
    let widths: Vec<(usize, usize)> = (0..columns).map(width).collect();
    rows.iter()
        .zip(&cells)
        .map(|((name, _), cells)| {
            let padded = cells.iter().zip(&widths).map(|((a, b), (left, right))| format!("{a:>left$}{b:<right$}"));
            let head = if names == 0 { Vec::new() } else { vec![format!("{name:<names$}")] };
            head.into_iter().chain(padded).collect::<Vec<_>>().join("  ").trim_end().to_owned()
        })
        .collect()
}

/// All numbers as text with all their digits, as programs read them.
fn text(t: &'static Texts, report: &Report) -> String {
    let mut text = String::new();
    let inverses = tables(t, report, true).into_iter().filter(|table| table.symbol.contains('⁻'));
    for table in tables(t, report, false).into_iter().chain(inverses) {
        let title = format!("{} {}", table.symbol, title(report, &table));
        text.push_str(title.trim());
        text.push('\n');
        text.push_str(&lines(&table.rows, |value| numbers::significant(value, numbers::EXACT_DIGITS)).join("\n"));
        text.push_str("\n\n");
    }
    text
}

/// All numbers of the figure as text, every digit.
#[must_use]
pub fn copy(state: &State) -> String {
    let t = window::texts(state.settings.lang);
    report(state).map(|report| text(t, &report)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use crate::numbers::DecimalMark;

    #[test]
    fn decimal_points_stand_below_each_other() {
        let rows = named(&[("u", [1.0, -0.5, 2e-9]), ("n", [-10.25, 0.0, 3.0])]);
        let write = |mark: DecimalMark| move |value: f64| mark.number(value, 5);
        assert_eq!(lines(&rows, write(DecimalMark::Point)), ["u    1     −0.5  2e−9", "n  −10.25   0    3"]);
        assert_eq!(lines(&rows, write(DecimalMark::Comma)), ["u    1     −0,5  2e−9", "n  −10,25   0    3"]);
        let rows = &matrix(&[[1.0; 4], [20.0; 4], [0.0; 4], [0.0; 4]])[..2];
        assert_eq!(lines(rows, write(DecimalMark::Point))[1], "20  20  20  20");
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
            assert_eq!(projection_equation(&report), equation);
            let erratum = tables(window_texts(), &report, false).into_iter().any(|table| table.erratum.is_some());
            assert_eq!(erratum, projection == Projection::Parallel);
        }
    }

    fn window_texts() -> &'static Texts {
        window::texts(crate::i18n::Lang::En)
    }
}
