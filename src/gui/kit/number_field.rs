//! A field for one number: drag it, type a number or an expression, or step it with the arrow keys.
//!
//! egui's own field drops text that it can't read, and rounds the displayed value before it's edited. This one keeps a
//! faulty text, with the reason, until it's corrected. It changes the value only if you type a different one, and
//! rounds the display to fit if there isn't room for all of it.

use std::ops::RangeInclusive;

use eframe::egui::{self, Button, CursorIcon, Key, Modifiers, Sense, TextWrapMode, WidgetInfo};

use crate::expression::{self, Dimension, ExpressionProblem};
use crate::gui::kit::text_field::{self, TextField};
use crate::gui::kit::theme;
use crate::gui::kit::tooltip::{self, Explained};
use crate::numbers::{self, round_to};
use camera_lab_words::why::sources::with_titles;
use camera_lab_words::window::Texts;
use camera_lab_words::{Lang, messages};

/// The effect of dragging and of the arrow keys.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// An arrow key adds or takes this. Dragging a tenth of it for each point.
    Add(f64),
    /// An arrow key multiplies or divides by this. Dragging by its tenth root for each point. For positive values.
    Multiply(f64),
}

impl Step {
    fn apply(self, value: f64, steps: f64) -> f64 {
        match self {
            Self::Add(step) => round_to(value + step * steps, step / 100.0),
            Self::Multiply(factor) => {
                let new = value * factor.powf(steps);
                let digit = 10f64.powf(new.abs().log10().floor());
                if digit.is_finite() && digit > 0.0 { round_to(new, digit / 1000.0) } else { new }
            }
        }
    }
}

/// A number field. [`NumberField::show`] displays it.
#[derive(Clone, Debug)]
pub struct NumberField<'a> {
    name: String,
    owner: &'a str,
    hint: &'a str,
    greyed: &'a str,
    prefix: &'a str,
    unit: &'static str,
    dimension: Dimension,
    step: Step,
    whole: bool,
    range: RangeInclusive<f64>,
    width: f32,
    marked: bool,
    beside: f64,
    fractions: bool,
}

/// The result of a field in this frame.
#[derive(Debug, Default)]
pub struct FieldOutput {
    /// The reason why the text in the field is refused. The value hasn't changed then.
    pub error: Option<FieldError>,
    /// True while it's being dragged.
    pub held: bool,
    /// Enter has just ended the typing.
    pub entered: bool,
}

/// A reason why the typed text can't be applied.
#[derive(Clone, Debug, PartialEq)]
pub enum FieldError {
    /// Not a number.
    Expression(ExpressionProblem),
    /// Not a whole number.
    NotWhole,
    /// Outside the range.
    Outside(RangeInclusive<f64>),
}

impl FieldError {
    /// The reason in words.
    pub fn text(&self, lang: Lang) -> String {
        match self {
            Self::Expression(problem) => messages::expression(lang, problem),
            Self::NotWhole => messages::not_whole(lang).to_owned(),
            Self::Outside(range) => messages::outside(lang, *range.start(), *range.end()),
        }
    }
}

#[derive(Clone, Default)]
struct Editing {
    text: String,
    first: String,
    value: f64,
    error: Option<FieldError>,
}

/// Gives the keyboard to the field or control of this name when it's next shown.
pub(in crate::gui) fn take_keyboard(ctx: &egui::Context, name: &str) {
    ctx.data_mut(|data| data.insert_temp(called(), name.to_owned()));
    ctx.request_repaint();
}

/// Gives this control the keyboard and scrolls it into sight, if that was requested. Returns true if it was.
pub(in crate::gui) fn answer_call(ui: &egui::Ui, control: &egui::Response, name: &str) -> bool {
    let called = is_called(ui, name);
    if called {
        control.request_focus();
        control.scroll_to_me(None);
    }
    called
}

fn is_called(ui: &egui::Ui, name: &str) -> bool {
    let is_it = ui.data(|data| data.get_temp::<String>(called())).as_deref() == Some(name);
    if is_it {
        ui.data_mut(|data| data.remove::<String>(called()));
    }
    is_it
}

fn called() -> egui::Id {
    egui::Id::unique("number field that takes the keyboard")
}

impl<'a> NumberField<'a> {
    /// A field with this name for screen readers.
    pub fn new(name: impl Into<String>, step: Step) -> Self {
        Self {
            name: name.into(),
            owner: "",
            hint: "",
            greyed: "",
            prefix: "",
            unit: "",
            dimension: Dimension::Number,
            step,
            whole: false,
            range: f64::MIN..=f64::MAX,
            width: 64.0,
            marked: false,
            beside: 0.0,
            fractions: false,
        }
    }

    /// The greatest of its neighbours. If the value can be a rounding error relative to it, it's shown as 0.
    pub fn beside(self, greatest: f64) -> Self {
        Self { beside: greatest, ..self }
    }

    /// The reason why it's greyed, if it is.
    pub fn greyed(self, why: &'a str) -> Self {
        Self { greyed: why, ..self }
    }

    /// Shows 4/3 if the value is that to the last digit.
    pub fn fractions(self) -> Self {
        Self { fractions: true, ..self }
    }

    /// The owner of the number, if several have one of the same name. Text typed for one never goes to another.
    pub fn of(self, owner: &'a str) -> Self {
        Self { owner, ..self }
    }

    /// A field for an angle in degrees.
    pub fn angle(name: impl Into<String>, step: f64) -> Self {
        Self { unit: "°", dimension: Dimension::Angle, ..Self::new(name, Step::Add(step)) }
    }

    /// Whole numbers only.
    pub fn whole(self) -> Self {
        Self { whole: true, ..self }
    }

    /// Only numbers in this range.
    pub fn within(self, range: RangeInclusive<f64>) -> Self {
        Self { range, ..self }
    }

    /// Only numbers greater than 0.
    pub fn positive(self) -> Self {
        self.within(f64::MIN_POSITIVE..=f64::MAX)
    }

    /// The tooltip.
    pub fn hint(self, hint: &'a str) -> Self {
        Self { hint, ..self }
    }

    /// Shown, in a weak colour, before the number.
    pub fn prefix(self, prefix: &'a str) -> Self {
        Self { prefix, ..self }
    }

    /// Width in points.
    pub fn width(self, width: f32) -> Self {
        Self { width, ..self }
    }

    /// If true, marks the field, because its value is impossible.
    pub fn marked(self, marked: bool) -> Self {
        Self { marked, ..self }
    }

    /// Shows the field and changes `value`.
    pub fn show(self, ui: &mut egui::Ui, texts: &Texts, value: &mut f64) -> FieldOutput {
        let (_, rect) = ui.allocate_space(egui::vec2(self.width, ui.spacing().interact_size.y));
        // The id comes from the name, because a complaint that comes or goes above must not take the focus away.
        let place = egui::UiBuilder::new()
            .scope_id(egui::Id::unique(("number field", self.owner, &self.name)))
            .max_rect(rect)
            .layout(egui::Layout::centered_and_justified(egui::Direction::LeftToRight));
        self.show_in(&mut ui.new_child(place), texts, value)
    }

    /// Takes the keyboard if this field was asked to.
    fn answer_call(&self, ui: &egui::Ui, id: egui::Id) {
        if self.owner.is_empty() && is_called(ui, &self.name) {
            ui.memory_mut(|memory| memory.request_focus(id));
        }
    }

    /// As [`Self::show`], in a place of its own, because button and text field must have one and the same id.
    fn show_in(self, ui: &mut egui::Ui, texts: &Texts, value: &mut f64) -> FieldOutput {
        let id = ui.next_auto_id();
        self.answer_call(ui, id);
        let old = *value;
        let editing = ui.is_enabled()
            && ui.memory_mut(|memory| {
                memory.interested_in_focus(id, ui.layer_id());
                memory.has_focus(id)
            });
        let refused = self.step_by_keys(ui, id, (editing, texts), value);
        let stale = |e: &Editing| e.value.to_bits() != value.to_bits();
        let mut state = refused.or_else(|| ui.data_mut(|data| data.remove_temp::<Editing>(id)).filter(|e| !stale(e)));
        if !editing && state.as_ref().is_some_and(|s| s.error.is_none()) {
            state = self.finish(ui, state, value);
        }
        // Enter has left a faulty text with its reason, so Escape still drops it.
        let idle = !editing && ui.memory(|memory| memory.focused().is_none());
        if idle && state.is_some() && ui.input(|input| input.key_pressed(Key::Escape)) {
            state = None;
        }
        let mut entered = false;
        let mut response = if editing {
            let response = self.text_edit(ui, id, texts, &mut state, *value);
            if response.lost_focus() {
                entered = ui.input(|input| input.key_pressed(Key::Enter));
                state = self.finish(ui, state, value);
            }
            response
        } else {
            self.button(ui, id, texts, state.as_ref(), value)
        };
        if value.to_bits() != old.to_bits() {
            response.mark_changed();
        }
        let error = state.as_ref().and_then(|s| s.error.clone());
        if let Some(state) = state {
            ui.data_mut(|data| data.insert_temp(id, state));
        }
        self.announce(ui, &response, texts, *value);
        FieldOutput { error, held: response.dragged(), entered }
    }

    /// Arrow keys while it's edited, and requests of a screen reader. Returns the error of those.
    fn step_by_keys(
        &self,
        ui: &egui::Ui,
        id: egui::Id,
        (editing, texts): (bool, &Texts),
        value: &mut f64,
    ) -> Option<Editing> {
        use egui::accesskit::{Action, ActionData};
        let steps = ui.input_mut(|input| {
            let mut steps = 0.0;
            if editing {
                let mut count = |modifiers, key| input.count_and_consume_key(modifiers, key) as f64;
                steps += count(Modifiers::NONE, Key::ArrowUp) - count(Modifiers::NONE, Key::ArrowDown);
                steps += 10.0 * (count(Modifiers::NONE, Key::PageUp) - count(Modifiers::NONE, Key::PageDown));
            }
            steps += input.num_accesskit_action_requests(id, Action::Increment) as f64;
            steps - input.num_accesskit_action_requests(id, Action::Decrement) as f64
        });
        let asked: Option<f64> = ui.input(|input| {
            input
                .accesskit_action_requests(id, Action::SetValue)
                .filter_map(|request| match request.data {
                    Some(ActionData::NumericValue(v)) if v.is_finite() => Some(v),
                    _ => None,
                })
                .last()
        });
        if steps != 0.0 {
            *value = self.stepped(*value, steps);
        }
        match self.checked(asked?) {
            Ok(asked) => {
                *value = asked;
                None
            }
            Err(error) => {
                let text = |v: f64| texts.lang.mark().typed(&numbers::significant(v, numbers::EXACT_DIGITS));
                Some(Editing { text: text(asked?), first: text(*value), value: *value, error: Some(error) })
            }
        }
    }

    /// The value some steps further. Steps end at the ends of the range.
    fn stepped(&self, value: f64, steps: f64) -> f64 {
        let stepped = self.step.apply(value, steps).clamp(*self.range.start(), *self.range.end());
        if self.whole { stepped.round() } else { stepped }
    }

    /// A number that can be the field's value.
    fn checked(&self, value: f64) -> Result<f64, FieldError> {
        match value {
            _ if self.whole && value != value.round() => Err(FieldError::NotWhole),
            _ if !self.range.contains(&value) => Err(FieldError::Outside(self.range.clone())),
            _ => Ok(value),
        }
    }

    fn evaluate(&self, text: &str) -> Result<f64, FieldError> {
        let value = expression::evaluate(text, self.dimension);
        self.checked(value.map_err(|error| FieldError::Expression(error.problem))?)
    }

    /// Applies the typed text when the field has lost the focus. Escape drops it.
    fn finish(&self, ui: &egui::Ui, state: Option<Editing>, value: &mut f64) -> Option<Editing> {
        let mut state = state?;
        if ui.input(|input| input.key_pressed(Key::Escape)) || state.text == state.first {
            return None;
        }
        match self.evaluate(&state.text) {
            Ok(new) => {
                *value = new;
                None
            }
            Err(error) => {
                state.error = Some(error);
                Some(state)
            }
        }
    }

    fn text_edit(
        &self,
        ui: &mut egui::Ui,
        id: egui::Id,
        texts: &Texts,
        state: &mut Option<Editing>,
        value: f64,
    ) -> egui::Response {
        let fresh = state.is_none();
        let exact = texts.lang.mark().typed(&numbers::significant(value, numbers::EXACT_DIGITS));
        let state = state.get_or_insert_with(|| Editing { text: exact.clone(), first: exact, value, error: None });
        state.error = None;
        if fresh {
            text_field::select(ui.ctx(), id, 0..state.text.chars().count());
        }
        let field = TextField::line(&mut state.text, crate::limits::MAX_EXPRESSION.0).refused_beyond().with(|edit| {
            let edit = edit.id(id).clip_text(true).desired_width(self.width);
            edit.align(egui::Align2::LEFT_CENTER).margin(egui::Margin::symmetric(4, 2))
        });
        let response = field.show(ui, texts.lang);
        if state.text != state.first {
            match self.evaluate(&state.text) {
                Ok(v) if state.text.trim().replace(',', ".").parse() != Ok(v) => {
                    let preview = texts.lang.mark().number(v, numbers::EXACT_DIGITS);
                    say_beside(&response, format!("= {preview}{}", self.unit));
                }
                Ok(_) => {}
                Err(FieldError::Expression(
                    ExpressionProblem::Empty | ExpressionProblem::Unfinished | ExpressionProblem::MissingParenthesis,
                )) => {}
                Err(error) => say_beside(&response, error.text(texts.lang)),
            }
        }
        response
    }

    fn button(
        &self,
        ui: &mut egui::Ui,
        id: egui::Id,
        texts: &Texts,
        state: Option<&Editing>,
        value: &mut f64,
    ) -> egui::Response {
        let problem = state.is_some() || self.marked;
        let color = if problem { ui.visuals().error_fg_color } else { ui.visuals().text_color() };
        let font = egui::TextStyle::Button.resolve(ui.style());
        let mut job = egui::text::LayoutJob::default();
        if !self.prefix.is_empty() {
            job = theme::lowered(
                ui,
                &format!("{} ", self.prefix),
                &egui::TextStyle::Button,
                ui.visuals().weak_text_color(),
            );
        }
        let mut push = |text: &str, color| {
            job.append(text, 0.0, egui::TextFormat { font_id: font.clone(), color, ..Default::default() });
        };
        match state {
            Some(state) => push(&state.text, color),
            None => push(&self.shown(ui, &font, texts, *value), color),
        }
        let mut button = Button::new(job).wrap_mode(TextWrapMode::Truncate).sense(Sense::click_and_drag());
        if problem {
            button = button.stroke(egui::Stroke::new(1.5, color));
        }
        let response = ui.add(button);
        let response = response.on_hover_cursor(CursorIcon::ResizeHorizontal);
        if response.clicked() {
            ui.memory_mut(|memory| memory.request_focus(id));
        }
        self.drag(ui, &response, value);
        let response = response.explained_disabled(if self.greyed.is_empty() { self.hint } else { self.greyed });
        response.explained_by(|ui| {
            if !self.hint.is_empty() {
                ui.label(with_titles(self.hint));
            }
            ui.label(format!("= {}{}", texts.lang.mark().number(*value, numbers::EXACT_DIGITS), self.unit));
            ui.weak(texts.number_field_hint);
        })
    }

    /// The value as displayed in the field: in full or rounded, but never cut.
    fn shown(&self, ui: &egui::Ui, font: &egui::FontId, texts: &Texts, value: f64) -> String {
        let mark = texts.lang.mark();
        let width =
            |text: &str| -> f32 { ui.fonts_mut(|fonts| text.chars().map(|c| fonts.glyph_width(font, c)).sum()) };
        let prefix = if self.prefix.is_empty() { 0.0 } else { width(self.prefix) + width(" ") };
        let room = self.width - 2.0 * ui.spacing().button_padding.x - prefix - width(self.unit) - 1.0;
        let fraction = self.fractions.then(|| numbers::fraction(value)).flatten();
        let text = match fraction {
            Some(fraction) => mark.printed(&fraction),
            None if numbers::is_rest(value, self.beside) => "0".to_owned(),
            None => mark.fitted(value, |text| width(text) <= room),
        };
        format!("{text}{}", self.unit)
    }

    /// The value follows the pointer from its value at the press, so that a slow frame loses nothing.
    fn drag(&self, ui: &egui::Ui, response: &egui::Response, value: &mut f64) {
        let id = response.id.with("drag");
        if response.drag_started() {
            ui.data_mut(|data| data.insert_temp(id, *value));
        }
        if !response.dragged() {
            return;
        }
        let start = ui.data_mut(|data| data.get_temp::<f64>(id));
        if let (Some(start), Some(way)) = (start, response.total_drag_delta()) {
            let slow = if ui.input(|i| i.modifiers.shift) { 0.1 } else { 1.0 };
            let steps = f64::from(way.x - way.y) * 0.1 * slow;
            *value = if steps == 0.0 { start } else { self.stepped(start, steps) };
        }
    }

    /// Name and value for screen readers.
    fn announce(&self, ui: &egui::Ui, response: &egui::Response, texts: &Texts, value: f64) {
        use egui::accesskit::Action;
        response.widget_info(|| WidgetInfo::drag_value(ui.is_enabled(), value));
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_label(self.name.clone());
            node.add_action(Action::SetValue);
            node.add_action(Action::Increment);
            node.add_action(Action::Decrement);
            let exact = texts.lang.mark().typed(&numbers::significant(value, numbers::EXACT_DIGITS));
            node.set_value(format!("{exact}{}", self.unit));
        });
    }
}

/// Shows a message beside a field while it's edited.
fn say_beside(response: &egui::Response, text: String) {
    tooltip::beside(response, |ui| drop(ui.label(text)));
}

/// The value of a field of whole numbers that aren't negative.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "its field takes whole numbers that fit")]
pub(in crate::gui) fn whole(value: f64) -> u32 {
    value as u32
}
