//! The numbers: basis, matrices, window, corners. Each one equals that of `camera-lab inspect` for the same figure.

use eframe::egui::text::LayoutJob;
use eframe::egui::{self, RichText, TextFormat};

use super::{TEXT_LINE, complain, erratum, kept_section, section};
use crate::gui::inspector::number_tables::{self, GAP, Table, bounds, ndc_of, report, tables};
use crate::gui::kit::{Explained, NumberField, Step, brackets, context_help, help_topic, help_topic_row, theme, whole};
use camera_lab_desk::Model;
use camera_lab_words::why::conventions::differences;
use camera_lab_words::why::{explain, notes};
use camera_lab_words::window::{self, Texts};

/// Shows the numbers.
pub fn ui(ui: &mut egui::Ui, model: &mut Model) {
    let t = window::texts(model.settings.lang);
    let mut open = model.settings.numbers_open;
    kept_section(ui, t.numbers, "numbers", &mut open, |ui| {
        toolbar(ui, t, model);
        let inverse = model.settings.inverse;
        list(ui, model, inverse, None, |_| true);
    });
    model.settings.numbers_open = open;
    let warnings = model.warnings();
    if !warnings.is_empty() {
        section(ui, t.warnings, "warnings", true, |ui| {
            for warning in warnings {
                let color = ui.visuals().warn_fg_color;
                ui.label(RichText::new(format!("⚠ {warning}")).color(color));
            }
        });
    }
}

/// Lists the wanted tables, each with the one of another convention if there is one. A click on an entry of a matrix
/// explains it.
pub(in crate::gui) fn list(
    ui: &mut egui::Ui,
    model: &mut Model,
    inverse: bool,
    compared: Option<crate::camera::Ndc>,
    is_wanted: fn(&Table) -> bool,
) {
    let t = window::texts(model.settings.lang);
    let shown = model.settings.conventions;
    let Some(report) = report(model, shown.ndc) else { return };
    let camera = model.desk.shown.camera();
    let ends = model.settings.bounds.then(|| bounds(model, shown.ndc, &report).ends);
    let ends = ends.map(|ends| ends.map(|report| tables(t, (camera, &report), inverse, shown)));
    let other = compared.and_then(|ndc| number_tables::report(model, ndc));
    let other = other.map(|other| (tables(t, (camera, &other), inverse, shown), ndc_of(&other)));
    let mut asked = None;
    for (i, table) in tables(t, (camera, &report), inverse, shown).iter().enumerate().filter(|(_, t)| is_wanted(t)) {
        if table.is_asked(&model.frame.asked) {
            hidden(ui, t, table);
            continue;
        }
        let other = other.as_ref().filter(|_| table.follows_ndc);
        asked = show(ui, t, table, other.and_then(|(tables, _)| tables.get(i)), model.settings.digits).or(asked);
        // Said once, below M_p.
        if let Some((_, ndc)) = other.filter(|_| table.symbol.contains("M_p") && !table.symbol.contains("M_v")) {
            let said = differences(t.lang, ndc_of(&report), *ndc);
            theme::wrapped(ui, &said, &egui::TextStyle::Small, ui.visuals().text_color());
        }
        if let Some([low, high]) = ends.as_ref().map(|ends| ends.each_ref().map(|tables| &tables[i])) {
            let proof = number_tables::proof(t, [low, high]);
            ui.label(RichText::new(proof).small().weak());
        }
    }
    if let Some((matrix, entry)) = asked {
        model.explain_entry(matrix, entry);
    }
}

fn toolbar(ui: &mut egui::Ui, t: &'static Texts, model: &mut Model) {
    let output = ui.horizontal(|ui| {
        ui.label(t.digits).explained(t.digits_hint);
        let mut digits = model.settings.digits as f64;
        let field = NumberField::new(t.digits, Step::Add(1.0)).whole().within(2.0..=17.0);
        let output = field.width(40.0).hint(t.digits_hint).show(ui, t, &mut digits);
        model.settings.digits = whole(digits) as usize;
        ui.checkbox(&mut model.settings.inverse, t.inverse).explained(t.inverse_hint);
        ui.checkbox(&mut model.settings.bounds, t.bounds).explained(t.bounds_hint);
        if ui.button(t.copy).explained(t.copy_numbers_hint).clicked() {
            ui.ctx().copy_text(number_tables::text(model));
        }
        output
    });
    complain(ui, t.lang, [&output.inner]);
}

/// A table that an open question asks for: its name without its numbers.
fn hidden(ui: &mut egui::Ui, t: &Texts, table: &Table) {
    ui.add_space(3.0);
    ui.horizontal_wrapped(|ui| {
        ui.label(theme::symbol(ui, &table.symbol));
        ui.label(RichText::new(&table.name).small().weak());
        ui.label(t.asked_here).explained(t.asked_hint);
    });
}

/// An entry of a matrix.
type Entry = (crate::explain::Matrix, [usize; 2]);

/// A table. Below a matrix is the one that it's compared with, and differing entries are marked in both. Returns the
/// clicked entry.
fn show(ui: &mut egui::Ui, t: &'static Texts, table: &Table, other: Option<&Table>, digits: usize) -> Option<Entry> {
    ui.add_space(3.0);
    ui.spacing_mut().item_spacing.y = 1.0;
    let asked = numbers(ui, t, table, other, digits);
    if let Some(other) = other {
        ui.push_id("compared", |ui| numbers(ui, t, other, Some(table), digits));
    }
    asked
}

/// Symbol, name and rows, marked if they differ from those of another table. Returns the clicked entry.
fn numbers(ui: &mut egui::Ui, t: &'static Texts, table: &Table, other: Option<&Table>, digits: usize) -> Option<Entry> {
    let written = |digits: usize| table.written(digits, t.lang.mark());
    let marked = |row: usize, column: usize| {
        let value = |table: &Table| table.rows.get(row).and_then(|(_, values)| values.get(column).copied());
        table.is_matrix() && other.is_some_and(|other| value(other) != value(table))
    };
    // Few digits are rounded to fit, as the heading says. Many can be scrolled.
    let room = ui.available_width() - 18.0;
    let mut fitting = digits;
    while (3..=MOST_TO_FIT).contains(&fitting) && width(ui, job(ui, &written(fitting), marked)) > room {
        fitting -= 1;
    }
    let heading = ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = TEXT_LINE;
        ui.spacing_mut().item_spacing.x = 5.0;
        if table.entry(0, 0).is_some() {
            if theme::linked_symbol(ui, &table.symbol).clicked() {
                context_help::call(ui.ctx());
            }
        } else if !table.symbol.is_empty() {
            ui.label(theme::symbol(ui, &table.symbol));
        }
        ui.label(RichText::new(&table.name).small().weak());
        if let Some(text) = table.erratum {
            erratum(ui, t, text);
        }
        if fitting < digits {
            let said = RichText::new(format!("{fitting} / {digits}")).small().color(ui.visuals().warn_fg_color);
            ui.label(said).explained(t.digits_that_fit);
        }
    });
    if let Some((matrix, _)) = table.entry(0, 0) {
        help_topic_row(ui, heading.response.rect, notes::of_matrix(matrix));
    }
    egui::ScrollArea::horizontal()
        .id_salt(&table.name)
        .show(ui, |ui| {
            let rows = written(fitting);
            let galley = ui.painter().layout_job(job(ui, &rows, marked));
            let label = egui::Label::new(std::sync::Arc::clone(&galley)).extend();
            let corner = if table.is_matrix() {
                let frame = egui::Frame::NONE.inner_margin(egui::Margin::symmetric(8, 0));
                let shown = frame.show(ui, |ui| ui.add(label));
                brackets(ui, shown.response.rect);
                shown.inner.rect.min
            } else {
                ui.add(label).rect.min
            };
            questions(ui, t, table, &rows, &galley, corner)
        })
        .inner
}

/// Makes each number that is the entry of a matrix a control for its explanation. Returns the clicked one.
fn questions(
    ui: &egui::Ui,
    t: &'static Texts,
    table: &Table,
    rows: &[Vec<String>],
    galley: &egui::Galley,
    corner: egui::Pos2,
) -> Option<Entry> {
    let mut asked = None;
    for (i, (row, placed)) in rows.iter().zip(&galley.rows).enumerate() {
        let named = usize::from(!table.is_matrix());
        let mut begins = 0;
        for (j, cell) in row.iter().enumerate() {
            let (length, number) = (cell.chars().count(), cell.trim());
            let first = begins + cell.chars().take_while(|c| *c == ' ').count();
            let last = first + number.chars().count();
            begins += length + GAP.len();
            let Some(entry) = j.checked_sub(named).and_then(|column| table.entry(i, column)) else { continue };
            let glyphs = placed.row.glyphs.get(first..last).unwrap_or_default();
            let (Some(from), Some(to)) = (glyphs.first(), glyphs.last()) else { continue };
            let across = (from.pos.x - 2.0)..=(to.pos.x + to.advance_width + 2.0);
            let place = egui::Rect::from_x_y_ranges(across, 0.0..=placed.row.size.y).translate(placed.pos.to_vec2());
            let place = place.translate(corner.to_vec2());
            let id = ui.scope_id().with(egui::IdSalt::new(("why", &table.symbol, i, j)));
            let response = ui.interact(place, id, egui::Sense::click());
            let (matrix, [row, column]) = entry;
            let name = format!("{}: {number}", explain::entry(t.lang, matrix.text(), row, column));
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
            help_topic(&response, notes::of_matrix(matrix));
            if response.hovered() {
                let under = egui::Stroke::new(1.0, ui.visuals().hyperlink_color);
                ui.painter().hline(place.x_range(), place.bottom() - 1.0, under);
            }
            let response = response.explained(t.why_hint);
            let value = table.rows.get(i).and_then(|(_, values)| values.get(j - named).copied());
            response.context_menu(|ui| {
                if let Some(value) = value
                    && ui.button(format!("{} {number}", t.copy)).clicked()
                {
                    ui.ctx().copy_text(t.lang.mark().printed(&crate::numbers::exact(value)));
                    ui.close();
                }
                if ui.button(t.why).clicked() {
                    asked = Some(entry);
                    ui.close();
                }
            });
            if response.clicked() {
                asked = Some(entry);
            }
        }
    }
    asked
}

/// Rows of cells as text. Marked ones are underlined, on a background of their own.
fn job(ui: &egui::Ui, rows: &[Vec<String>], marked: impl Fn(usize, usize) -> bool) -> LayoutJob {
    let visuals = ui.visuals();
    let font_id = egui::TextStyle::Monospace.resolve(ui.style());
    let plain = TextFormat { font_id, color: visuals.text_color(), ..TextFormat::default() };
    let strong = TextFormat {
        color: visuals.strong_text_color(),
        background: visuals.warn_fg_color.gamma_multiply(0.25),
        underline: egui::Stroke::new(1.0, visuals.warn_fg_color),
        ..plain.clone()
    };
    let mut job = LayoutJob::default();
    for (i, row) in rows.iter().enumerate() {
        if i > 0 {
            job.append("\n", 0.0, plain.clone());
        }
        for (j, cell) in row.iter().enumerate() {
            let cell = if j + 1 == row.len() { cell.trim_end() } else { cell };
            let number = cell.trim();
            let start = cell.len() - cell.trim_start().len();
            job.append(&cell[..start], 0.0, plain.clone());
            job.append(number, 0.0, if marked(i, j) { strong.clone() } else { plain.clone() });
            job.append(&cell[start + number.len()..], 0.0, plain.clone());
            if j + 1 < row.len() {
                job.append(GAP, 0.0, plain.clone());
            }
        }
    }
    job
}

/// The most digits that are rounded further if they don't fit.
const MOST_TO_FIT: usize = 7;

fn width(ui: &egui::Ui, job: LayoutJob) -> f32 {
    ui.painter().layout_job(job).size().x
}
