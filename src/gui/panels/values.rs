//! The numbers: basis, matrices, window, corners. Each one is what `camera-lab inspect` prints for the same figure.

use eframe::egui::{self, RichText};

use super::{TEXT_LINE, complaint, section};
use crate::gui::number_field::{NumberField, Step};
use crate::gui::state::State;
use crate::gui::theme;
use crate::i18n::window::{self, Texts};
use crate::inspect::Report;
use crate::numbers;

/// The numbers of the figure.
fn report(state: &State) -> Option<Report> {
    let figure = state.document.figure();
    Report::of(state.document.camera(), figure.image, figure.viewport, &[], &[]).ok()
}

/// Shows the numbers.
pub fn ui(ui: &mut egui::Ui, state: &mut State) {
    let t = window::texts(state.settings.lang);
    section(ui, t.numbers, "numbers", true, |ui| {
        let Some(report) = report(state) else { return };
        toolbar(ui, t, state, &report);
        for table in tables(t, &report, state.settings.inverse) {
            show(ui, &table, state.settings.digits);
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
        ui.label(t.digits).on_hover_text(t.digits_hint);
        let mut digits = state.settings.digits as f64;
        let field = NumberField::new(t.digits, Step::Add(1.0)).whole().within(2.0..=17.0);
        let output = field.width(40.0).hint(t.digits_hint).show(ui, t, &mut digits);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole, between 2 and 17")]
        let digits = digits as usize;
        state.settings.digits = digits;
        ui.checkbox(&mut state.settings.inverse, t.inverse).on_hover_text(t.inverse_hint);
        if ui.button(t.copy).on_hover_text(t.copy_numbers_hint).clicked() {
            ui.ctx().copy_text(text(t, report, numbers::EXACT_DIGITS));
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
        Table {
            symbol: "DOP, D",
            name: t.dop_name,
            rows: vec![("DOP".into(), r.dop.to_vec()), ("D".into(), vec![r.distance])],
        },
        Table {
            symbol: "u, v, n",
            name: t.basis_name,
            rows: named(&[("u", r.basis.u), ("v", r.basis.v), ("n", r.basis.n)]),
        },
        Table {
            symbol: "l r b t",
            name: t.window_name,
            rows: named(&[("l, r", [w.left, w.right]), ("b, t", [w.bottom, w.top]), ("W, H", [w.width, w.height])])
                .into_iter()
                .chain([("A".into(), vec![w.aspect])])
                .collect(),
        },
        Table {
            symbol: if inverse { "M_v⁻¹" } else { "M_v" },
            name: if inverse { t.inverse_view_name } else { t.view_name },
            rows: matrix(view),
        },
        Table {
            symbol: if inverse { "M_p⁻¹" } else { "M_p" },
            name: if inverse { t.inverse_projection_name } else { t.projection_name },
            rows: matrix(projection),
        },
    ];
    if !inverse {
        tables.push(Table { symbol: "M_p M_v", name: t.product_name, rows: matrix(&r.view_projection_matrix) });
    }
    tables.push(Table { symbol: "", name: t.corners_name, rows: (0..8).map(corner).collect() });
    tables
}

fn show(ui: &mut egui::Ui, table: &Table, digits: usize) {
    ui.add_space(3.0);
    ui.spacing_mut().item_spacing.y = 1.0;
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = TEXT_LINE;
        ui.spacing_mut().item_spacing.x = 5.0;
        if !table.symbol.is_empty() {
            ui.label(theme::symbol(ui, table.symbol));
        }
        ui.label(RichText::new(table.name).small().weak());
    });
    egui::ScrollArea::horizontal().id_salt(table.name).show(ui, |ui| {
        let text = lines(&table.rows, digits).join("\n");
        ui.add(egui::Label::new(RichText::new(text).monospace()).extend());
    });
}

/// The rows as aligned text: in each column the decimal points stand below each other.
fn lines(rows: &[(String, Vec<f64>)], digits: usize) -> Vec<String> {
    let names = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let columns = rows.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
    let halves = |v: &f64| {
        let text = numbers::significant(*v, digits);
        let point = text.find(['.', 'e']).unwrap_or(text.len());
        (text[..point].to_owned(), text[point..].to_owned())
    };
    let cells: Vec<Vec<(String, String)>> =
        rows.iter().map(|(_, values)| values.iter().map(halves).collect()).collect();
    let width = |column: usize| {
        let cells = cells.iter().filter_map(|row| row.get(column));
        cells.fold((0, 0), |(left, right), (a, b)| (left.max(a.len()), right.max(b.len())))
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

/// All numbers as text.
fn text(t: &'static Texts, report: &Report, digits: usize) -> String {
    let mut text = String::new();
    let inverses = tables(t, report, true).into_iter().filter(|table| table.symbol.contains('⁻'));
    for table in tables(t, report, false).into_iter().chain(inverses) {
        let title = format!("{} {}", table.symbol, table.name);
        text.push_str(title.trim());
        text.push('\n');
        text.push_str(&lines(&table.rows, digits).join("\n"));
        text.push_str("\n\n");
    }
    text
}

/// All numbers of the figure as text, every digit.
#[must_use]
pub fn copy(state: &State) -> String {
    let t = window::texts(state.settings.lang);
    report(state).map(|report| text(t, &report, numbers::EXACT_DIGITS)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_points_stand_below_each_other() {
        let rows = named(&[("u", [1.0, -0.5, 2e-9]), ("n", [-10.25, 0.0, 3.0])]);
        assert_eq!(lines(&rows, 5), ["u    1     -0.5  2e-9", "n  -10.25   0    3"]);
        assert_eq!(lines(&matrix(&[[1.0; 4], [20.0; 4], [0.0; 4], [0.0; 4]])[..2], 5)[1], "20  20  20  20");
    }
}
