//! The explanation of steps. The view volume becomes the canonical one, step by step, in the picture of the canonical
//! volume, and this tab has its factors.

use eframe::egui::{self, Button, Id, Key, Modifiers, RichText, Slider, Ui};
use glam::DMat4;

use super::answer::{self, Writing};
use crate::camera::{Camera, Decomposition, Factor};
use crate::explain::{EntryFormula, Setting, entry_product, factor_entries};
use crate::figure::ShownStep;
use crate::gui::kit::{Both, Explained, brackets, help_topic, theme};
use crate::gui::why::matrix::entries;
use crate::gui::why::matrix::matrices::{cells, reading};
use crate::gui::why::state::explain::Explain;
use crate::numbers::without_rests;
use camera_lab_desk::{Action, FileFor, Model, Reading, Steps, end_of, step_at, time_of};
use camera_lab_words::why::explain::Texts;
use camera_lab_words::why::{explain as words, notes};
use camera_lab_words::{Lang, command_line, pictures};

/// Shows the tab.
pub(super) fn ui(ui: &mut Ui, model: &mut Model, _explain: &mut Explain) {
    let lang = model.settings.lang;
    let t = words::texts(lang);
    let camera = model.desk.shown.camera().clone();
    let now = ui.input(|input| input.time);
    let now_shown = model.shown().step.map_or(model.explained.steps.way, |step| step.way);
    let way = sources(ui, lang, &camera, now_shown);
    let mut shown = model.shown().step.filter(|step| step.way == way).unwrap_or(ShownStep { way, at: None });
    model.explained.steps.way = way;
    let Some(factors) = camera.decomposed(way) else {
        ui.label(command_line::no_steps(lang, way));
        model.desk.shown.show_mut().step = Some(shown);
        return;
    };
    if ui.button(t.film).explained(t.film_hint).clicked() {
        model.request(Action::File(FileFor::Animation(way)));
    }
    let steps = &mut model.explained.steps;
    shown = steps.advance(shown, now, &camera);
    controls(ui, t, &camera, (steps, &mut shown), now);
    if steps.plays() {
        // Whole steps don't move in between.
        let pause = if model.settings.reduce_motion { 200 } else { 0 };
        ui.ctx().request_repaint_after(std::time::Duration::from_millis(pause));
    }
    if !model.layout.is_shown(crate::views::View::Canonical) {
        ui.label(t.steps_hidden);
    }
    list(ui, lang, &camera, &factors, (&mut model.explained.steps, &mut shown));
    model.desk.shown.show_mut().step = Some(shown);
    let time = time_of(shown, &camera);
    ui.separator();
    match running(time).checked_sub(1) {
        None => drop(ui.label(t.nothing_done)),
        Some(last) => matrices_of(ui, model, &camera, (way, &factors, last), time),
    }
    ui.separator();
    let ndc = way.ndc();
    let expected = camera.possible_clip_space(ndc).clip_from_world();
    let (ratio, rest) = compared(&product(&factors), &expected);
    let said = words::comparison(lang, way, ratio, rest);
    theme::wrapped(ui, &said, &egui::TextStyle::Body, ui.visuals().text_color());
}

/// The running step, or the last one done. 0 before the first.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful of steps")]
fn running(time: f64) -> usize {
    (time - 1e-9).ceil() as usize
}

/// The matrix of the step that runs, the product as far as steps are done, and the explanation of the chosen entry.
fn matrices_of(
    ui: &mut Ui,
    model: &mut Model,
    camera: &Camera,
    (way, factors, last): (Decomposition, &[Factor], usize),
    time: f64,
) {
    let lang = model.settings.lang;
    let figure = model.desk.shown.figure();
    let setting = Setting::new(camera.possible_clip_space(way.ndc()), figure.image, figure.viewport);
    let writing = Writing { setting: &setting, lang, digits: model.settings.digits.min(5) };
    let done = factors.iter().take(last + usize::from((last + 1) as f64 <= time + 1e-9)).copied().collect::<Vec<_>>();
    let formulas: Vec<EntryFormula> =
        factors.iter().take(last + 1).map(|factor| factor_entries(factor.step, &setting)).collect();
    let (Some(factor), Some(of_factor)) = (factors.get(last), formulas.last()) else { return };
    let shown = [
        Some((words::factor(lang, last + 1), of_factor.clone(), factor.matrix, model.explained.matrices.reading)),
        (done.len() > 1).then(|| {
            let formulas =
                formulas.iter().take(done.len()).cloned().reduce(|before, next| entry_product(&next, &before));
            (
                words::product(lang, done.len()),
                formulas.unwrap_or_else(|| of_factor.clone()),
                product(&done),
                Reading::Values,
            )
        }),
    ];
    reading(ui, words::texts(lang), &mut model.explained.matrices.reading);
    for (place, (name, formulas, matrix, reading)) in shown.into_iter().flatten().enumerate() {
        ui.push_id(("step", place), |ui| {
            ui.label(RichText::new(&name).strong());
            let rows = matrix.transpose().to_cols_array_2d().map(|row| without_rests(&row, writing.digits));
            let values = rows.map(|row| std::array::from_fn(|j| row[j] + 0.0));
            let cells = cells(model, writing, (&name, &formulas, reading), &values, |_| 0.0);
            let chosen = model.explained.steps.entry.filter(|(of, _)| *of == place).map(|(_, entry)| entry);
            let pointed =
                entries::show(ui, &cells, (chosen.unwrap_or([usize::MAX; 2]), false), notes::of_step(factor.step));
            if let Some(entry) = pointed.chosen {
                model.explained.steps.entry = Some((place, entry));
            }
            if let Some([row, column]) = pointed.hovered.or(chosen) {
                let (text, place) = (format!("m_{}{}", row + 1, column + 1), format!("{}{}", row + 1, column + 1));
                let name = Both { latex: format!("m_{{{place}}}"), text };
                let entry = (&formulas[row][column], values[row][column]);
                let lit = answer::show(ui, writing, &name, entry, &mut model.explained.matrices);
                model.frame.hover.measured.extend(answer::lights(entry.0, lit));
            } else {
                ui.label(RichText::new(words::texts(lang).click_an_entry).small().weak());
            }
        });
    }
}

/// First to last, so that the last one is at the left.
fn product(factors: &[Factor]) -> DMat4 {
    factors.iter().fold(DMat4::IDENTITY, |product, factor| factor.matrix * product)
}

/// The factor between two matrices, and their remaining difference, relative to the greatest entry.
fn compared(product: &DMat4, expected: &DMat4) -> (f64, f64) {
    let (a, b) = (product.to_cols_array(), expected.to_cols_array());
    let greatest = (0..16).max_by(|i, j| b[*i].abs().total_cmp(&b[*j].abs())).unwrap_or(0);
    let ratio = a[greatest] / b[greatest];
    let rest = a.iter().zip(b).map(|(a, b)| (a - ratio * b).abs()).fold(0.0, f64::max);
    (ratio, rest / a[greatest].abs())
}

/// The sources of the steps. Those that the camera lacks are greyed, with the reason.
fn sources(ui: &mut Ui, lang: Lang, camera: &Camera, mut way: Decomposition) -> Decomposition {
    ui.horizontal_wrapped(|ui| {
        for decomposition in Decomposition::ALL {
            let has = camera.decomposed(decomposition).is_some();
            let name = format!("{} {}", decomposition.source(), words::decomposition(lang, decomposition));
            let visuals = ui.visuals();
            let color = if has { visuals.text_color() } else { visuals.weak_text_color() };
            let lowered = theme::lowered(ui, &name, &egui::TextStyle::Button, color);
            let button = Button::selectable(way == decomposition, lowered).frame_when_inactive(true);
            let response = ui.add_enabled(has, button).explained(decomposition.source());
            let response = response.accessible_name(name.replace(['{', '}'], ""));
            if response.explained_disabled(command_line::no_steps(lang, decomposition)).clicked() {
                way = decomposition;
            }
        }
    });
    way
}

/// Buttons to the beginning, a step back, play or pause, a step forward, to the end, and the slider over all of them.
fn controls(ui: &mut Ui, t: &Texts, camera: &Camera, (steps, shown): (&mut Steps, &mut ShownStep), now: f64) {
    let (count, time) = (end_of(shown.way, camera), time_of(*shown, camera));
    let mut wanted = None;
    ui.horizontal(|ui| {
        let mut button = |ui: &mut Ui, sign: &str, name: &str, to: f64| {
            if ui.button(sign).explained(name).accessible_name(name).clicked() {
                wanted = Some(to);
            }
        };
        button(ui, "|◀", t.to_world, 0.0);
        button(ui, "◀", t.step_back, before(time));
        let (sign, name) = if steps.plays() { ("||", t.hold) } else { ("▶", t.play) };
        if ui.button(sign).explained(name).accessible_name(name).clicked() {
            *shown = steps.play_or_hold(*shown, now);
        }
        button(ui, "▶|", t.step_forward, after(time));
        button(ui, "▶▶|", t.to_cube, count);
    });
    wanted = wanted.or(scrubber(ui, t, time, count));
    if let Some(time) = wanted {
        steps.hold();
        *shown = step_at(shown.way, time, camera);
    }
}

/// The slider over all steps. Returns its new place. Arrow keys move it by a tenth of a step, with Ctrl to the next
/// whole one.
fn scrubber(ui: &mut Ui, t: &Texts, time: f64, count: f64) -> Option<f64> {
    let key = Id::unique("scrubber of the steps");
    let focused = ui.data(|data| data.get_temp(key)).is_some_and(|id| ui.memory(|memory| memory.has_focus(id)));
    // Before the slider, for which an arrow key is a pixel.
    let mut wanted = None;
    if focused {
        ui.input_mut(|input| {
            for (modifiers, arrow, to) in [
                (Modifiers::COMMAND, Key::ArrowLeft, before(time)),
                (Modifiers::COMMAND, Key::ArrowRight, after(time)),
                (Modifiers::NONE, Key::ArrowLeft, tenth(time, -1.0)),
                (Modifiers::NONE, Key::ArrowRight, tenth(time, 1.0)),
            ] {
                if input.consume_key(modifiers, arrow) {
                    wanted = Some(to);
                }
            }
        });
    }
    ui.scope(|ui| {
        theme::strengthen_rail(ui);
        ui.spacing_mut().slider_width = (ui.available_width() - 16.0).max(80.0);
        let mut shown = wanted.unwrap_or(time);
        let slider = Slider::new(&mut shown, 0.0..=count).show_value(false).smart_aim(false);
        let response = ui.add(slider).explained(t.scrubber_hint).accessible_name(t.scrubber);
        ui.data_mut(|data| data.insert_temp(key, response.id));
        if response.changed() {
            wanted = Some(shown);
        }
    });
    wanted
}

/// The whole step before.
fn before(time: f64) -> f64 {
    (time - 1e-9).ceil() - 1.0
}

/// The whole step after.
fn after(time: f64) -> f64 {
    (time + 1e-9).floor() + 1.0
}

/// Moves on by tenths of a step. The result is a whole tenth, wherever the pointer has left the slider.
fn tenth(time: f64, by: f64) -> f64 {
    (10.0 * time + by).round() / 10.0
}

/// The steps in their order, each clickable. A change of handedness is marked.
fn list(ui: &mut Ui, lang: Lang, camera: &Camera, factors: &[Factor], (steps, shown): (&mut Steps, &mut ShownStep)) {
    let labels = pictures::labels(lang);
    let runs = running(time_of(*shown, camera));
    let mut left_handed = false;
    for (i, factor) in factors.iter().enumerate() {
        let text = format!("{}. {}", i + 1, labels.step(factor.step));
        let lowered = theme::lowered(ui, &text, &egui::TextStyle::Button, ui.visuals().text_color());
        let button = Button::selectable(runs == i + 1, lowered).wrap();
        let button = ui.add(button).accessible_name(text.replace(['{', '}'], ""));
        help_topic(&button, notes::of_step(factor.step));
        if button.clicked() {
            steps.hold();
            #[expect(clippy::cast_precision_loss, reason = "a handful of steps")]
            let time = (i + 1) as f64;
            *shown = step_at(shown.way, time, camera);
        }
        if factor.left_handed != left_handed {
            left_handed = factor.left_handed;
            let now = if left_handed { labels.left_handed } else { labels.right_handed };
            ui.label(
                RichText::new(format!("      ⚠ {}", words::handedness(lang, now))).color(ui.visuals().warn_fg_color),
            );
        }
    }
}

/// A matrix as numbers. `why` explains an entry, by row and column from 0.
pub(super) fn numbers(
    ui: &mut Ui,
    matrix: &DMat4,
    number: impl Fn(f64) -> String,
    why: impl Fn(usize, usize) -> Option<String>,
) {
    let rows = matrix.transpose().to_cols_array_2d();
    let frame = egui::Frame::NONE.inner_margin(egui::Margin::symmetric(8, 2));
    let place = frame.show(ui, |ui| {
        ui.spacing_mut().interact_size.y = 15.0;
        let id = ui.next_auto_id();
        egui::Grid::new(("matrix", id)).spacing([12.0, 2.0]).show(ui, |ui| {
            for (i, row) in rows.iter().enumerate() {
                for (j, value) in without_rests(row, 5).into_iter().enumerate() {
                    let entry = ui.monospace(number(value + 0.0));
                    if let Some(why) = why(i, j) {
                        entry.explained(why);
                    }
                }
                ui.end_row();
            }
        });
    });
    brackets(ui, place.response.rect);
}
