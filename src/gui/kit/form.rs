//! The basic shapes of panels and dialogs.

use eframe::egui::{self, CollapsingHeader, RichText};
use glam::DVec3;

use super::focus::at_right;
use super::number_field::{self, FieldOutput, NumberField, Step};
use super::tooltip::Explained;
use super::{context_help, theme};
use camera_lab_words::window::Texts;

/// A group of controls under a title that opens and closes it. Returns the title.
pub(in crate::gui) fn section(
    ui: &mut egui::Ui,
    title: &str,
    id: &str,
    open: bool,
    body: impl FnOnce(&mut egui::Ui),
) -> egui::Response {
    let style = ui.style().clone();
    theme::tint_header(ui);
    let title = RichText::new(title).font(theme::bold(12.5));
    let shown = CollapsingHeader::new(title).id_salt(id).default_open(open).show_unindented(ui, |ui| {
        ui.set_style(style.clone());
        ui.add_space(1.0);
        body(ui);
        ui.add_space(4.0);
    });
    ui.set_style(style);
    shown.header_response
}

/// A group that stays open or closed as its user left it.
pub(in crate::gui) fn kept_section(
    ui: &mut egui::Ui,
    title: &str,
    id: &str,
    open: &mut bool,
    body: impl FnOnce(&mut egui::Ui),
) {
    let style = ui.style().clone();
    theme::tint_header(ui);
    let header = CollapsingHeader::new(RichText::new(title).font(theme::bold(12.5))).id_salt(id).open(Some(*open));
    let shown = header.show_unindented(ui, |ui| {
        ui.set_style(style.clone());
        body(ui);
    });
    ui.set_style(style);
    *open ^= shown.header_response.clicked();
}

/// Rarely used controls, folded under *More* and their name.
pub(in crate::gui) fn more(ui: &mut egui::Ui, t: &Texts, what: &str, body: impl FnOnce(&mut egui::Ui)) {
    let title = RichText::new(format!("{}: {what}", t.more)).weak();
    CollapsingHeader::new(title).id_salt(what).default_open(false).show_unindented(ui, body);
}

/// Height of a line without controls.
pub(in crate::gui) const TEXT_LINE: f32 = 16.0;

/// A symbol of the notes and its name.
pub(in crate::gui) fn caption(ui: &mut egui::Ui, symbol: &str, name: &str, hint: &str) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        if !symbol.is_empty() {
            let symbol = theme::linked_symbol(ui, symbol).explained(hint).explained_disabled(hint);
            if symbol.clicked() {
                context_help::call(ui.ctx());
            }
        }
        ui.label(RichText::new(name)).explained(hint).explained_disabled(hint);
    });
}

/// A row: its label on the left, its controls on the right.
pub(in crate::gui) fn row<R>(
    ui: &mut egui::Ui,
    symbol: &str,
    name: &str,
    hint: &str,
    controls: impl FnOnce(&mut egui::Ui) -> R,
) -> R {
    ui.horizontal(|ui| {
        caption(ui, symbol, name, hint);
        at_right(ui, controls)
    })
    .inner
}

/// A vector: its name, and below it three fields side by side.
pub(in crate::gui) struct VectorField<'a> {
    /// The symbol of the notes. May be empty.
    pub(in crate::gui) symbol: &'static str,
    /// Its name.
    pub(in crate::gui) name: &'static str,
    /// The tooltip.
    pub(in crate::gui) hint: &'static str,
    /// The name of its fields for screen readers, before the axis.
    pub(in crate::gui) field: &'static str,
    /// The owner of the vector, if there are several of the same name.
    pub(in crate::gui) owner: &'a str,
    /// The step of an arrow key.
    pub(in crate::gui) step: f64,
    /// Degrees.
    pub(in crate::gui) angles: bool,
    /// If true, marks the fields, because the value is impossible.
    pub(in crate::gui) marked: bool,
}

impl VectorField<'_> {
    /// Shows name and fields, and changes `value`.
    pub(in crate::gui) fn show(&self, ui: &mut egui::Ui, t: &Texts, value: &mut DVec3) -> [FieldOutput; 3] {
        ui.scope(|ui| {
            ui.spacing_mut().interact_size.y = TEXT_LINE;
            ui.spacing_mut().item_spacing.y = 1.0;
            caption(ui, self.symbol, self.name, self.hint);
        });
        self.fields(ui, t, value, 0.0)
    }

    /// Only the fields. Leaves room for something else beside them.
    pub(in crate::gui) fn fields(
        &self,
        ui: &mut egui::Ui,
        t: &Texts,
        value: &mut DVec3,
        beside: f32,
    ) -> [FieldOutput; 3] {
        let gap = 4.0;
        let width = ((ui.available_width() - beside - 2.0 * gap) / 3.0).floor();
        let mut components = value.to_array();
        let greatest = value.abs().max_element();
        let outputs = ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            ["x", "y", "z"].map(|axis| {
                let component = &mut components[usize::from(axis.as_bytes()[0] - b'x')];
                let name = format!("{} {axis}", self.field);
                let field = if self.angles {
                    NumberField::angle(name, self.step)
                } else {
                    NumberField::new(name, Step::Add(self.step))
                };
                field
                    .of(self.owner)
                    .prefix(axis)
                    .hint(self.hint)
                    .width(width)
                    .beside(greatest)
                    .marked(self.marked)
                    .show(ui, t, component)
            })
        });
        *value = DVec3::from_array(components);
        outputs.inner
    }
}

/// A choice out of few, with its name for screen readers.
pub(in crate::gui) fn choice<T: PartialEq + Clone, S: AsRef<str>>(
    ui: &mut egui::Ui,
    name: &str,
    hint: &str,
    value: &mut T,
    options: &[(T, S)],
) -> bool {
    let old = value.clone();
    let chosen = options.iter().find(|(option, _)| *option == old).map_or("", |(_, text)| text.as_ref());
    let below = ui.layer_id();
    let list = egui::ComboBox::from_id_salt(name)
        .selected_text(chosen)
        .width(116.0)
        .show_ui(ui, |ui| {
            // A press brings a dialog to the front. If its click opens a list in the same frame, only
            // this puts the list before the dialog.
            if below.order == ui.layer_id().order {
                ui.ctx().set_sublayer(below, ui.layer_id());
            }
            for (option, text) in options {
                ui.selectable_value(value, option.clone(), text.as_ref());
            }
        })
        .response
        .explained(hint)
        .accessible_name(name);
    number_field::answer_call(ui, &list, name);
    *value != old
}

/// A quiet mark of an erratum in the notes. `text` is the erratum and its correction.
pub(in crate::gui) fn erratum(ui: &mut egui::Ui, t: &Texts, text: &str) {
    let mark = RichText::new(t.erratum).small().weak();
    ui.add(egui::Label::new(mark).sense(egui::Sense::hover())).explained(text);
}

/// A line with a fault, with a sign, so that it doesn't depend on colour alone.
pub(in crate::gui) fn complaint(ui: &mut egui::Ui, text: &str) {
    let color = ui.visuals().error_fg_color;
    announced(&ui.add(egui::Label::new(RichText::new(format!("⚠ {text}")).color(color)).wrap()));
}

/// Screen readers read this text when it appears or changes.
pub(in crate::gui) fn announced(text: &egui::Response) {
    text.ctx.accesskit_node_builder(text.id, |node| node.set_live(egui::accesskit::Live::Polite));
}

/// A line for each fault of number fields.
pub(in crate::gui) fn complain<'a>(
    ui: &mut egui::Ui,
    lang: camera_lab_words::Lang,
    fields: impl IntoIterator<Item = &'a FieldOutput>,
) {
    for error in fields.into_iter().filter_map(|field| field.error.as_ref()) {
        complaint(ui, &error.text(lang));
    }
}

/// A choice in a row with its name.
pub(in crate::gui) fn choice_row<T: PartialEq + Clone, S: AsRef<str>>(
    ui: &mut egui::Ui,
    name: &str,
    hint: &str,
    value: &mut T,
    options: &[(T, S)],
) -> bool {
    row(ui, "", name, hint, |ui| choice(ui, name, hint, value, options))
}

/// A button that is on or off.
pub(in crate::gui) fn toggle<'t>(ui: &mut egui::Ui, on: bool, text: impl egui::IntoAtoms<'t>) -> egui::Response {
    ui.add(egui::Button::selectable(on, text).frame_when_inactive(true))
}

/// Buttons of which one is on, each with its hint.
pub(in crate::gui) fn alternatives<'a, T: PartialEq>(
    ui: &mut egui::Ui,
    value: &mut T,
    options: impl IntoIterator<Item = (T, &'a str, &'a str)>,
) {
    for (option, name, hint) in options {
        if toggle(ui, *value == option, name).explained(hint).clicked() {
            *value = option;
        }
    }
}
