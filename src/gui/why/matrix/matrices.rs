//! The explanation of matrices: each entry of each matrix with its formula, its numbers and its value.

use eframe::egui::{self, RichText, Ui};

use super::entries::{self, Cell};
use crate::camera::{Ndc, Projection};
use crate::explain::{EntryFormula, Formula, Matrix, MatrixFormula, Setting, forward, leaves};
use crate::gui::kit::{Both, Explained, erratum, help_topic, prose, theme};
use crate::gui::why::ExplainedSetting;
use crate::gui::why::answer::{self, Writing};
use crate::gui::why::state::explain::Explain;
use camera_lab_desk::{Matrices, Model, Reading};
use camera_lab_words::why::explain::Texts;
use camera_lab_words::why::{conventions, entry_reasons, explain as words, notes};

/// Shows the tab.
pub(in crate::gui::why) fn ui(ui: &mut Ui, model: &mut Model, _explain: &mut Explain) {
    let t = words::texts(model.settings.lang);
    choices(ui, t, &mut model.explained.matrices);
    let subject = ExplainedSetting::of(model);
    let matrix = model.explained.matrices.shown();
    if model.explained.matrices.matrix == Matrix::Model {
        match &subject.object {
            None => {
                ui.label(t.select_object);
                return;
            }
            Some((name, _)) => drop(ui.label(crate::sanitize::escaped(name))),
        }
    }
    let setting = subject.setting(model);
    let formulas = MatrixFormula::new(matrix, &setting);
    heading(ui, model, &setting, &formulas);
    let writing = Writing { setting: &setting, lang: model.settings.lang, digits: model.settings.digits };
    let values = values(&setting, matrix, model.settings.digits);
    if values.iter().flatten().any(|value| !value.is_finite()) {
        ui.label(t.no_inverse);
        return;
    }
    let now = ui.input(|input| input.time);
    let object = subject.object.as_ref().filter(|_| model.explained.matrices.matrix == Matrix::Model);
    model.explained.matrices.glow.follow((matrix, object.map(|(name, _)| name.as_str())), values, now);
    let (reading, glow) = (model.explained.matrices.reading, &model.explained.matrices.glow);
    let written = (matrix.text(), &formulas.entries, reading);
    let cells = cells(model, writing, written, &values, |entry| glow.strength(entry, now));
    let Matrices { entry, wants_focus, .. } = model.explained.matrices;
    let pointed = entries::show(ui, &cells, (entry, wants_focus), note_on(&formulas));
    model.explained.matrices.wants_focus = false;
    if let Some(chosen) = pointed.chosen {
        model.explained.matrices.entry = chosen;
    }
    if model.explained.matrices.glow.is_seen(now) {
        ui.ctx().request_repaint_after(std::time::Duration::from_millis(if model.settings.reduce_motion {
            250
        } else {
            40
        }));
    }
    copy(ui, t, matrix, &cells);
    ui.separator();
    let [row, column] = pointed.hovered.unwrap_or(model.explained.matrices.entry);
    let name = entry_name(matrix, row, column);
    let place = words::entry(t.lang, matrix.text(), row, column);
    let heading = theme::lowered(ui, &place, &egui::TextStyle::Body, ui.visuals().strong_text_color());
    ui.label(heading).accessible_name(place);
    let formula = formulas.entry(row, column);
    let lit = answer::show(ui, writing, &name, (formula, values[row][column]), &mut model.explained.matrices);
    let lights = answer::lights(formula, lit);
    if let Some(why) = entry_reasons::reason(t.lang, matrix, &setting, [row, column]) {
        ui.add_space(4.0);
        prose::show(ui, &why);
    }
    used_in(ui, model, &setting, writing, (matrix, row, column));
    model.frame.hover.measured.extend(lights);
}

/// The note on the equation in force. If there is none, on the matrix.
fn note_on(formulas: &MatrixFormula) -> &'static str {
    notes::of_equation(formulas.equation).unwrap_or(notes::of_matrix(formulas.matrix))
}

/// The term with an entry in the trace of the followed point, with its numbers, in its row.
fn used_in(
    ui: &mut Ui,
    model: &Model,
    setting: &Setting<'_>,
    writing: Writing<'_>,
    (matrix, row, column): (Matrix, usize, usize),
) {
    let points = &model.desk.shown.figure().points;
    let Some(point) = model.follow.index(points).and_then(|index| points.get(index)) else { return };
    let followed = setting.clone().with_point_seen_from_object(point.position);
    for step in forward(&followed).into_iter().filter(|step| step.by == Some(matrix)) {
        let (Some(symbol), Some(formula), Some(value)) =
            (step.symbols.get(row), step.formulas.get(row), step.terms.get(row).and_then(|terms| terms.get(column)))
        else {
            continue;
        };
        let Some(term) = formula.terms().get(column).cloned() else { continue };
        let writing = Writing { setting: &followed, ..writing };
        ui.add_space(4.0);
        let name = crate::sanitize::escaped(&point.name);
        let said = words::used_in(writing.lang, &name, &symbol.text());
        theme::wrapped(ui, &said, &egui::TextStyle::Small, ui.visuals().weak_text_color());
        answer::term(ui, writing, &term, *value);
    }
}

/// The choice of the matrix, of its inverse, and of its notation.
fn choices(ui: &mut Ui, t: &'static Texts, state: &mut Matrices) {
    ui.horizontal_wrapped(|ui| {
        for matrix in Matrices::CHOICES {
            let button = egui::Button::selectable(state.matrix == matrix, matrix_symbol(ui, matrix));
            let button = ui.add(button.frame_when_inactive(true)).explained(words::matrix(t.lang, matrix));
            help_topic(&button, notes::of_matrix(matrix));
            button.widget_info(|| {
                let on = state.matrix == matrix;
                egui::WidgetInfo::selected(egui::Role::Button, true, on, matrix.text())
            });
            if button.clicked() {
                state.matrix = matrix;
            }
        }
        ui.checkbox(&mut state.inverse, t.inverse);
    });
    reading(ui, t, &mut state.reading);
}

/// The choice of the notation of entries.
pub(in crate::gui::why) fn reading(ui: &mut Ui, t: &'static Texts, chosen: &mut Reading) {
    ui.horizontal_wrapped(|ui| {
        for (reading, name, hint) in [
            (Reading::Formulas, t.formulas, t.formulas_hint),
            (Reading::Numbers, t.numbers, t.numbers_hint),
            (Reading::Values, t.values, t.values_hint),
        ] {
            ui.selectable_value(chosen, reading, name).explained(hint);
        }
    });
}

/// The symbol of a matrix, with subscripts lowered.
fn matrix_symbol(ui: &Ui, matrix: Matrix) -> egui::text::LayoutJob {
    theme::lowered(ui, &matrix.text().replace("_vp", "_{vp}"), &egui::TextStyle::Button, ui.visuals().text_color())
}

/// The matrix, the equation in force and its place, and the errata of the notes.
fn heading(ui: &mut Ui, model: &Model, setting: &Setting<'_>, formulas: &MatrixFormula) {
    let lang = model.settings.lang;
    let (t, ndc) = (camera_lab_words::window::texts(lang), setting.space().ndc());
    ui.horizontal_wrapped(|ui| {
        ui.label(words::matrix(lang, formulas.matrix));
        let place = format!("[0] {} {}", formulas.section, formulas.equation);
        let place = ui.label(RichText::new(place.trim_end()).weak()).explained(words::in_force(lang, formulas));
        help_topic(&place, note_on(formulas));
        if ndc != Ndc::default() {
            ui.label(RichText::new(format!("· {}", conventions::name(lang, ndc))).weak());
        }
        let parallel = setting.space().camera().projection() == Projection::Parallel;
        if parallel && formulas.matrix == Matrix::Projection && !formulas.equation.is_empty() {
            erratum(ui, t, t.erratum_parallel);
        }
    });
    let shown = model.settings.conventions;
    if shown.row_vectors || shown.left_handed {
        ui.label(RichText::new(words::texts(lang).as_in_the_notes).small().weak());
    }
}

/// The program's own numbers. For matrices whose rows each have one scale, without rounding errors of zero.
fn values(setting: &Setting<'_>, matrix: Matrix, digits: usize) -> [[f64; 4]; 4] {
    let rows = setting.matrix(matrix).transpose().to_cols_array_2d().map(|row| row.map(|x| x + 0.0));
    let of_axes = matches!(matrix, Matrix::View | Matrix::InverseView | Matrix::Model | Matrix::InverseModel);
    if !of_axes {
        return rows;
    }
    rows.map(|row| {
        let clean = crate::numbers::without_rests(&row, digits);
        std::array::from_fn(|j| clean[j])
    })
}

/// p₁₁ of M_p. For an inverse, which has no letters of its own, the matrix with the place.
fn entry_name(matrix: Matrix, row: usize, column: usize) -> Both {
    let place = format!("{}{}", row + 1, column + 1);
    let (latex, text) = (matrix.latex(), matrix.text());
    let compound = text.contains(['⁻', ' ']) && !text.ends_with(')');
    if compound {
        Both { latex: format!(r"\left({latex}\right)_{{{place}}}"), text: format!("({text})_{place}") }
    } else {
        Both { latex: format!(r"\left({latex}\right)_{{{place}}}"), text: format!("{text}_{place}") }
    }
}

/// The written entries of the matrix called `name`. `glow` is the strength of an entry's glow, 0 … 1.
pub(in crate::gui::why) fn cells(
    model: &Model,
    writing: Writing<'_>,
    (name, formulas, reading): (&str, &EntryFormula, Reading),
    values: &[[f64; 4]; 4],
    glow: impl Fn([usize; 2]) -> f64,
) -> [[Cell; 4]; 4] {
    let pointed = &model.frame.hover.pointed;
    let depends = |formula: &Formula| {
        !pointed.is_empty() && leaves(formula, writing.setting).iter().any(|symbol| pointed.contains(symbol))
    };
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let formula = &formulas[i][j];
            let Both { latex, text } = match reading {
                Reading::Formulas => writing.formula(formula),
                Reading::Numbers => writing.numbers(formula),
                Reading::Values => writing.value(values[i][j]),
            };
            let name = format!("{}: {text}", words::entry(writing.lang, name, i, j));
            let strength = glow([i, j]);
            #[expect(clippy::cast_possible_truncation, reason = "0 … 1")]
            let glow = if model.settings.reduce_motion { strength.ceil() } else { strength } as f32;
            Cell { latex, text, name, depends: depends(formula), glow }
        })
    })
}

/// Copies the displayed matrix, as LaTeX and as text.
fn copy(ui: &mut Ui, t: &'static Texts, matrix: Matrix, cells: &[[Cell; 4]; 4]) {
    ui.horizontal_wrapped(|ui| {
        if ui.button(t.copy_latex).explained(t.copy_latex_hint).clicked() {
            let rows = cells.each_ref().map(|row| row.each_ref().map(|cell| cell.latex.as_str()).join(" & "));
            let matrix = matrix.latex();
            ui.ctx()
                .copy_text(format!("{matrix} = \\begin{{bmatrix}}\n  {}\n\\end{{bmatrix}}\n", rows.join(" \\\\\n  ")));
        }
        if ui.button(t.copy_text).explained(t.copy_text_hint).clicked() {
            let rows = cells.each_ref().map(|row| row.each_ref().map(|cell| cell.text.as_str()).join("\t"));
            ui.ctx().copy_text(format!("{}\n{}\n", matrix.text(), rows.join("\n")));
        }
    });
}
