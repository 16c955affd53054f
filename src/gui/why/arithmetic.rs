//! A point's way, step by step, with each product written out: forward and back.

use eframe::egui::text::LayoutJob;
use eframe::egui::{self, CollapsingHeader, RichText, TextStyle};

use crate::explain::{Line, Notation, Setting, Step, Style, back, forward, written};
use crate::gui::kit::{Explained, help_topic, mathematics};
use crate::gui::why::matrix::digits;
use camera_lab_words::why::explain_point::Texts;
use camera_lab_words::why::notes;

/// The type size of formulas, in points.
const SIZE: f32 = 14.0;

/// Shows both ways of the setting's point. `name` distinguishes it from others.
pub(super) fn ui(ui: &mut egui::Ui, setting: &Setting<'_>, name: &str, (t, digits): (&Texts, usize)) {
    let style = |notation| Style { notation, mark: t.lang.mark(), digits };
    let there = forward(setting);
    let way = way_back(setting);
    let returned = way.as_ref().and_then(|way| way.as_ref().ok());
    let on_the_way = returned.map(|way| (setting.clone().with_way_back(way), back(setting, way)));
    ui.horizontal_wrapped(|ui| {
        for (label, notation) in [(t.copy_text, Notation::Text), (t.copy_latex, Notation::Latex)] {
            if ui.button(label).explained(t.copy_hint).clicked() {
                let spaces = |space: &str| t.space(space).to_owned();
                let mut text = written(&there, setting, style(notation), spaces);
                if let Some((setting, steps)) = &on_the_way {
                    text.push('\n');
                    text.push_str(&written(steps, setting, style(notation), spaces));
                }
                ui.ctx().copy_text(text);
            }
        }
    });
    ui.label(RichText::new(t.forward).strong());
    let w = setting.point().map_or(1.0, |point| point.clip.w);
    let inside = setting.point().is_some_and(|point| point.inside);
    for step in &there {
        self::step(ui, step, setting, (name, "forward"), t, style(Notation::Text));
        if step.to == "clip" {
            let said = if w == 0.0 {
                t.in_plane
            } else if w < 0.0 {
                t.behind
            } else if !inside {
                t.outside
            } else {
                continue;
            };
            ui.add(egui::Label::new(RichText::new(said).color(ui.visuals().warn_fg_color)).wrap());
        }
    }
    let Some(way) = way.filter(|_| w > 0.0) else { return };
    ui.add_space(4.0);
    ui.label(RichText::new(t.back).strong());
    match (way, &on_the_way) {
        (Err(why), _) => {
            let why = format!("{} {}", t.no_way_back, camera_lab_words::messages::no_way_back(t.lang, why));
            ui.add(egui::Label::new(why).wrap());
        }
        (Ok(_), Some((setting, steps))) => {
            ui.add(egui::Label::new(RichText::new(t.from_pixel).small().weak()).wrap());
            for step in steps {
                self::step(ui, step, setting, (name, "back"), t, style(Notation::Text));
            }
        }
        (Ok(_), None) => {}
    }
}

/// From the centre of the point's pixel with its Z. `None` for a point without a pixel.
fn way_back(setting: &Setting<'_>) -> Option<Result<crate::camera::Unprojected, crate::camera::NotProjectable>> {
    /// Whole numbers up to here are exact.
    const LARGEST: f64 = 9e15;
    let point = setting.point()?;
    let projected = point.projected.filter(|_| point.clip.w > 0.0)?;
    let pixel = projected.pixel.to_array();
    if pixel.iter().any(|x| x.is_nan() || x.abs() > LARGEST) {
        return None;
    }
    #[expect(clippy::cast_possible_truncation, reason = "a whole number below 2^53")]
    let pixel = pixel.map(|x| x as i64);
    Some(setting.space().way_back(setting.image(), &setting.viewport(), pixel, projected.viewport.z))
}

/// One step, which folds.
fn step(ui: &mut egui::Ui, step: &Step, setting: &Setting<'_>, key: (&str, &str), t: &Texts, style: Style) {
    let heading = format!("{} → {}   {}", t.space(step.from), t.space(step.to), step.equation);
    let id = ("step", key.1, step.from, step.to);
    let shown = CollapsingHeader::new(heading).id_salt(id).default_open(true).show(ui, |ui| {
        let typeset = step.lines(setting, Style { notation: Notation::Latex, ..style });
        for (row, (line, latex)) in step.lines(setting, style).iter().zip(&typeset).enumerate() {
            self::line(ui, (line, latex), (key, step.from, step.to, row, style.digits, t.lang.mark()));
        }
    });
    if let Some(note) = notes::of_equation(&step.equation) {
        help_topic(&shown.header_response, note);
    }
}

/// A row: the formula, set as mathematics, and below it the same with the numbers and the result.
fn line(ui: &mut egui::Ui, (line, latex): (&Line, &Line), key: impl std::hash::Hash + std::fmt::Debug + Copy) {
    let formula = |line: &Line| format!("{} = {}", line.symbol, line.formula);
    mathematics::show(ui, &formula(latex), &formula(line), SIZE);
    let font = TextStyle::Body.resolve(ui.style());
    let (strong, weak) = (ui.visuals().strong_text_color(), ui.visuals().weak_text_color());
    let mut job = LayoutJob::default();
    let plain = |job: &mut LayoutJob, text: &str, color| {
        job.append(text, 0.0, egui::TextFormat { font_id: font.clone(), color, ..Default::default() });
    };
    plain(&mut job, "  = ", weak);
    if line.numbers != line.value {
        digits::push(ui, &mut job, (key, "numbers"), &line.numbers, &font, ui.visuals().text_color());
        plain(&mut job, "\n  = ", weak);
    }
    digits::push(ui, &mut job, (key, "value"), &line.value, &font, strong);
    job.wrap.max_width = ui.available_width();
    ui.add(egui::Label::new(job).wrap());
}
