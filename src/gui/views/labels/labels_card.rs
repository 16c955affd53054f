//! The card of the mode *Labels*: the chosen label, hidden ones, notes.

use std::collections::BTreeSet;

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{self, Align2, ComboBox, FontSelection, Galley, Id, TextStyle, Ui, WidgetText, Window, vec2};

use crate::appearance::Rgba;
use crate::figure::labels::{LEGEND, Labels, is_in_legend, note_index, set_text};
use crate::figure::words::{DIMENSIONS, value};
use crate::figure::{Letters, Measure, MeasureText};
use crate::gui::kit::{Explained, TextField, text_field, theme};
use crate::gui::views::{Canvas, Pane};
use crate::limits::{LABEL_SIZE, MAX_LABEL_TEXT, MAX_LABELS};
use crate::picture::Renderer;
use crate::sanitize::escaped;
use crate::text::{Face, face};
use crate::views::{LabelPlace, View, unknown_labels};
use camera_lab_desk::Model;
use camera_lab_words::window::labels::Texts;
use camera_lab_words::window::{canvas, labels as words};
use camera_lab_words::{Lang, pictures};

/// The factor of one press of *larger*.
const LARGER: f64 = 1.25;

impl Canvas {
    /// Shows the card while the mode is on. The user can move it.
    pub(in crate::gui::views) fn labels_card(&self, ui: &Ui, model: &mut Model, panes: &[Pane]) {
        model.label_mode.is_typing = false;
        let room = panes.iter().map(|pane| pane.rect.rect).reduce(|a, b| a.union(b));
        let Some(room) = room.filter(|_| model.label_mode.on) else { return };
        let t = words::texts(model.settings.lang);
        let window = Window::new(t.title).id(Id::unique("card of labels")).constrain_to(room).resizable(false);
        let window =
            window.default_width(250.0).pivot(Align2::RIGHT_TOP).default_pos(room.right_top() + vec2(-8.0, 8.0));
        window.collapsible(false).show(ui.ctx(), |ui| {
            ui.set_max_width(250.0);
            self.choice(ui, model, panes, t);
            if let Some((view, name)) = model.label_mode.chosen.clone() {
                self.chosen(ui, model, (view, &name), t);
            }
            ui.separator();
            measures(ui, model, t);
            if whole(ui, model, t, &|ui, name| self.words_of(ui, t.lang, name)) {
                hide_all(ui, model, panes);
            }
            for (name, near) in unknown_labels(&self.shot, model.scene_cache.scene()) {
                let text = words::unknown(model.settings.lang, &name, near.as_deref());
                ui.colored_label(ui.visuals().warn_fg_color, text);
            }
        });
    }

    /// The label to change.
    fn choice(&self, ui: &mut Ui, model: &mut Model, panes: &[Pane], t: &Texts) {
        let mut all: Vec<(View, String)> = Vec::new();
        for pane in panes {
            for label in &self.pictures[pane.picture].labels {
                if !all.iter().any(|(_, name)| *name == label.name) {
                    all.push((pane.view, label.name.clone()));
                    // They are known once it's hidden.
                    remember(ui, t.lang, label);
                }
            }
        }
        let named = |ui: &Ui, (view, name): &(View, String)| {
            let text = self.words_of(ui, t.lang, name);
            // Two pictures may have different labels with the same words.
            let is_other = |(_, other): &(View, String)| other != name && self.words_of(ui, t.lang, other) == text;
            let of_view = canvas::texts(t.lang).view(*view);
            let text = if all.iter().any(is_other) { format!("{text} ({of_view})") } else { text };
            theme::lowered(ui, &escaped(&text), &TextStyle::Button, ui.visuals().text_color())
        };
        let mut chosen = model.label_mode.chosen.clone();
        ui.horizontal(|ui| {
            let label = ui.label(t.choose);
            let shown = chosen.as_ref().map_or_else(|| t.none.into(), |one| WidgetText::from(named(ui, one)));
            let combo = ComboBox::from_id_salt("label").selected_text(shown).width(150.0).show_ui(ui, |ui| {
                ui.selectable_value(&mut chosen, None, t.none);
                for one in &all {
                    let text = named(ui, one);
                    ui.selectable_value(&mut chosen, Some(one.clone()), text);
                }
            });
            combo.response.labelled_by(label.id).explained(t.choose_hint);
        });
        model.label_mode.choose(chosen);
    }

    /// The words of a label in the pictures, or, if it's hidden, those that it had, in plain letters.
    fn words_of(&self, ui: &Ui, lang: Lang, name: &str) -> String {
        let mut labels = self.pictures.iter().flat_map(|picture| &picture.labels);
        if let Some(shown) = labels.find(|label| label.name == name && !label.text.trim().is_empty()) {
            remember(ui, lang, shown);
        }
        let known = ui.data(|data| data.get_temp(words_id(lang, name)));
        known.unwrap_or_else(|| pictures::labels(lang).named(name))
    }

    /// The author's wishes for a label.
    fn chosen(&self, ui: &mut Ui, model: &mut Model, (view, name): (View, &str), t: &Texts) {
        let change = model.desk.shown.figure().labels.change(name, view);
        let (size, color) = (change.size, change.color);
        let place = self.pictures.iter().flat_map(|picture| &picture.labels).find(|label| label.name == name);
        let own = change.text.map(str::to_owned).or_else(|| place.map(|place| place.text.clone()));
        self.text(ui, model, (view, name, own.unwrap_or_default()), t);
        text_of_measure(ui, model, name, t);
        ui.horizontal(|ui| {
            ui.label(t.size);
            let now = size.unwrap_or(1.0);
            let (least, most) = (*LABEL_SIZE.start(), *LABEL_SIZE.end());
            for (text, words, factor) in [("−", t.smaller, LARGER.recip()), ("+", t.larger, LARGER)] {
                if ui.button(text).explained(words).accessible_name(format!("{} {words}", t.size)).clicked() {
                    let next = ((now * factor).clamp(least, most) * 100.0).round() / 100.0;
                    let next = Some(next).filter(|next| (next - 1.0).abs() > 0.02);
                    model.desk.shown.edit_labels(|labels| labels.style(name, next, color));
                }
            }
            ui.label(format!("{} %", model.settings.lang.mark().number(100.0 * now, 3)));
            ui.add_space(8.0);
            ui.label(t.color);
            let Rgba { r, g, b, .. } = color.or(place.map(|place| place.color)).unwrap_or(Rgba::rgb(0, 0, 0));
            let mut bytes = [r, g, b];
            if ui.color_edit_button_srgb(&mut bytes).accessible_name(t.color).changed() {
                let [r, g, b] = bytes;
                model.desk.shown.edit_labels(|labels| labels.style(name, size, Some(Rgba::rgb(r, g, b))));
            }
        });
        ui.horizontal_wrapped(|ui| {
            let hide = if note_index(name).is_some() { t.delete } else { t.hide };
            if ui.button(hide).clicked() {
                model.desk.shown.edit_labels(|labels| labels.hide(name));
                model.label_mode.choose(None);
            }
            if is_in_legend(name) && ui.button(t.hide_legend).explained(t.legend_hint).clicked() {
                model.desk.shown.edit_labels(|labels| labels.hide(LEGEND));
                model.label_mode.choose(None);
            }
            if ui.button(t.automatic).explained(t.automatic_hint).clicked() {
                model.desk.shown.edit_labels(|labels| labels.reset(name));
                model.label_mode.typed = None;
            }
        });
    }

    /// The picture in which a label gets another text. `None` for all, if the label says the same in all of them.
    fn renamed_in(&self, labels: &Labels, view: View, name: &str) -> Option<View> {
        let entry =
            |view: Option<View>| labels.renamed.iter().any(|renamed| renamed.name == name && renamed.view == view);
        if entry(Some(view)) || entry(None) {
            return entry(Some(view)).then_some(view);
        }
        let mut texts = self.pictures.iter().flat_map(|picture| &picture.labels).filter(|label| label.name == name);
        let first = texts.next();
        let is_same = texts.all(|label| first.is_some_and(|first| first.text == label.text));
        (!is_same).then_some(view)
    }

    /// The field of its text, which becomes the figure's as far as it's valid.
    fn text(&self, ui: &mut Ui, model: &mut Model, (view, name, own): (View, &str, String), t: &Texts) {
        let lang = model.settings.lang;
        let mut typed = model.label_mode.typed.clone().unwrap_or_else(|| own.clone());
        let response = ui
            .horizontal(|ui| {
                let label = ui.label(t.text);
                let id = Id::unique(("text of label", name));
                let mut letters = |ui: &Ui, typed: &dyn egui::TextBuffer, _: f32| with_letters(ui, typed.as_str());
                let field = TextField::line(&mut typed, MAX_LABEL_TEXT);
                let field = field.with(|edit| edit.id(id).desired_width(190.0).layouter(&mut letters));
                field.show(ui, lang).labelled_by(label.id).explained(t.text_hint)
            })
            .inner;
        if std::mem::take(&mut model.label_mode.is_new) {
            response.request_focus();
            text_field::select(ui.ctx(), response.id, 0..typed.chars().count());
        }
        model.label_mode.is_typing = response.has_focus() || response.lost_focus();
        if response.changed() {
            if set_text(&typed).is_ok() {
                let view = self.renamed_in(&model.desk.shown.figure().labels, view, name);
                model.desk.shown.edit_labels(|labels| labels.rename(name, view, &typed));
            }
            model.label_mode.typed = Some(typed);
        } else if let Err(error) = set_text(&typed) {
            ui.colored_label(ui.visuals().error_fg_color, words::refused(lang, &error));
        }
        if response.lost_focus() {
            model.label_mode.typed = None;
        }
    }
}

/// A typed text in which other fonts replace the letters of Unicode's mathematics, which no font of the window has.
fn with_letters(ui: &Ui, typed: &str) -> std::sync::Arc<Galley> {
    let (plain, color) = (FontSelection::Default.resolve(ui.style()), ui.visuals().text_color());
    let mut job = LayoutJob { keep_trailing_whitespace: true, ..LayoutJob::default() };
    for c in typed.chars() {
        let (face, letter) = face(c, false);
        let font = if face == Face::Bold { theme::bold(plain.size) } else { plain.clone() };
        let italics = face == Face::Plain && letter != c;
        job.append(&letter.to_string(), 0.0, TextFormat { font_id: font, color, italics, ..TextFormat::default() });
    }
    ui.fonts_mut(|fonts| fonts.layout_job(job))
}

/// The lengths and angles that the author shows in the world.
fn measures(ui: &mut Ui, model: &mut Model, t: &Texts) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        ui.label(t.measures);
        for measure in Measure::ALL {
            let is_shown = model.desk.shown.figure().labels.measures.iter().any(|shown| shown.measure == measure);
            let button = ui.add(egui::Button::new(measure.symbol()).selected(is_shown));
            if button.explained(t.measures_hint).clicked() {
                let shown = (!is_shown).then(MeasureText::default);
                model.desk.shown.edit_labels(|labels| labels.measure(measure, shown));
            }
        }
    });
}

/// The text of the chosen label, if that belongs to one of these.
fn text_of_measure(ui: &mut Ui, model: &mut Model, name: &str, t: &Texts) {
    let shown = &model.desk.shown.figure().labels.measures;
    let measure = value(DIMENSIONS, name);
    let Some(labelled) = shown.iter().find(|labelled| Some(labelled.measure) == measure).copied() else { return };
    ui.horizontal(|ui| {
        ui.label(t.shown);
        for (text, words) in
            [(MeasureText::Symbol, t.symbol), (MeasureText::Value, t.value), (MeasureText::Both, t.both)]
        {
            if ui.selectable_label(labelled.shown == text, words).clicked() {
                model.desk.shown.edit_labels(|labels| labels.measure(labelled.measure, Some(text)));
            }
        }
    });
}

/// The part for all labels, with the words of hidden ones. Returns true if all are to be hidden.
fn whole(ui: &mut Ui, model: &mut Model, t: &Texts, words_of: &dyn Fn(&Ui, &str) -> String) -> bool {
    let labels = &model.desk.shown.figure().labels;
    let (hidden, notes) = (labels.hidden.clone(), labels.notes.len());
    let mut is_mathematics = labels.letters == Letters::Mathematics;
    if ui.checkbox(&mut is_mathematics, t.mathematics).explained(t.mathematics_hint).changed() {
        let letters = if is_mathematics { Letters::Mathematics } else { Letters::Plain };
        model.desk.shown.edit_labels(|labels| labels.letters = letters);
    }
    let mut hides_all = false;
    ui.horizontal_wrapped(|ui| {
        let has_room = notes < MAX_LABELS;
        let add = ui.add_enabled(has_room, egui::Button::new(t.add).selected(model.label_mode.adding));
        if add.explained(if has_room { t.add_hint } else { t.full }).clicked() {
            model.label_mode.adding ^= true;
        }
        hides_all = ui.button(t.hide_all).explained(t.hide_all_hint).clicked();
        if ui.button(t.all_automatic).explained(t.all_automatic_hint).clicked() {
            model.desk.shown.edit_labels(|labels| labels.reset_all());
            model.label_mode.typed = None;
        }
        if ui.button(t.leave).clicked() {
            model.label_mode.toggle();
        }
    });
    // Below the buttons, which stay under the pointer.
    if !hidden.is_empty() {
        ui.horizontal_wrapped(|ui| {
            ui.label(t.hidden);
            for name in &hidden {
                let words =
                    theme::lowered(ui, &escaped(&words_of(ui, name)), &TextStyle::Button, ui.visuals().text_color());
                if ui.button(words).explained(t.show_again).clicked() {
                    model.desk.shown.edit_labels(|labels| labels.show(name));
                }
            }
        });
    }
    hides_all
}

fn words_id(lang: Lang, name: &str) -> Id {
    Id::unique(("words of label", lang, name))
}

/// Keeps the words of a label for the time when it's hidden.
fn remember(ui: &Ui, lang: Lang, label: &LabelPlace) {
    let words: String = label.text.chars().map(|c| face(c, false).1).collect();
    ui.data_mut(|data| data.insert_temp(words_id(lang, &label.name), words));
}

/// Hides the labels of the views, also those without room, which would take the places that become free. Notes stay,
/// because hiding one deletes it.
fn hide_all(ui: &Ui, model: &mut Model, panes: &[Pane]) {
    let mut renderer = Renderer::default();
    let lang = model.settings.lang;
    let labels = panes.iter().flat_map(|pane| renderer.labels_with_room(&pane.request));
    let labels = labels.inspect(|label| remember(ui, lang, label));
    let names: BTreeSet<String> = labels.map(|label| label.name).filter(|name| note_index(name).is_none()).collect();
    let room = MAX_LABELS.saturating_sub(model.desk.shown.figure().labels.hidden.len());
    model.desk.shown.edit_labels(|shown| names.iter().take(room).for_each(|name| shown.hide(name)));
    model.label_mode.choose(None);
}
