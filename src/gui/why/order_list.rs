//! The list of the explanation of order: calls with their numbers, moved by dragging their dots and by keyboard.

use eframe::egui::{
    self, CursorIcon, Key, Modifiers, Rect, Role, Sense, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};

use crate::explain::order::Call;
use crate::gui::kit::{Explained, NumberField, Step, at_right, help_topic_row, theme};
use crate::gui::why::state::order::Order;
use camera_lab_words::why::order as words;
use camera_lab_words::why::order::Texts;

/// Widths, in points: of the dots, of number and symbol, of a button at the right.
const DOTS: f32 = 14.0;
const SYMBOL: f32 = 50.0;
const BUTTON: f32 = 20.0;
/// Width of the three buttons.
const BUTTONS: f32 = 3.0 * (BUTTON + 6.0);

/// A change of the list, applied after all rows have been shown.
enum OrderChange {
    Step(usize, bool),
    Put(usize, usize),
    Remove(usize),
}

/// Shows the list. `included` are the places of the applied calls.
pub(super) fn ui(ui: &mut Ui, t: &'static Texts, order: &mut Order, included: &[usize]) {
    // Before the fields, for which an arrow key is a step of their number.
    if let Some(key) = order.focused {
        for (arrow, forward) in [(Key::ArrowUp, false), (Key::ArrowDown, true)] {
            if ui.input_mut(|input| input.consume_key(Modifiers::ALT, arrow)) {
                order.step(key, forward);
                // An arrow key would also move the focus up or down.
                ui.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
            }
        }
    }
    order.focused = None;
    let (mut change, mut held, mut rows) = (None, None, Vec::new());
    for place in 0..order.list.len() {
        let key = order.list[place].key;
        // The id goes with the call, so that the keyboard does too.
        let own = egui::UiBuilder::new().scope_id(egui::Id::unique(("call of the order", key)));
        let row = ui.scope_builder(own, |ui| {
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 3.0;
                let dots = handle(ui, t, order, place, included.contains(&place));
                if dots.dragged() || dots.drag_stopped() {
                    held = Some((place, dots.drag_stopped()));
                }
                if dots.has_focus() && ui.input(|input| input.key_pressed(Key::Delete)) {
                    change = Some(OrderChange::Remove(place));
                }
                fields(ui, t, &mut order.list[place].call, key);
                if let Some(asked) = buttons(ui, t, place, key, order.list.len()) {
                    change = Some(asked);
                }
            })
            .response
            .rect
        });
        help_topic_row(ui, row.inner, note_on(order.list[place].call));
        rows.push(row.inner);
        let focused = ui.memory(egui::Memory::focused).and_then(|id| ui.ctx().read_response(id));
        if focused.is_some_and(|response| row.inner.expand(1.0).contains(response.rect.center())) {
            order.focused = Some(key);
        }
    }
    if let Some((from, dropped)) = held {
        let to = target(ui, &rows);
        if dropped {
            change = Some(OrderChange::Put(from, to));
        } else {
            insertion_line(ui, &rows, to);
        }
    }
    match change {
        None => return,
        Some(OrderChange::Step(key, forward)) => order.step(key, forward),
        Some(OrderChange::Put(from, to)) => order.put(from, to),
        Some(OrderChange::Remove(place)) => drop(order.list.remove(place)),
    }
    ui.ctx().request_repaint();
}

/// The row before which the pointer would drop the dragged one. The number of rows after the last one.
fn target(ui: &Ui, rows: &[Rect]) -> usize {
    let Some(pointer) = ui.input(|input| input.pointer.latest_pos()) else { return rows.len() };
    rows.iter().filter(|row| row.center().y < pointer.y).count()
}

fn insertion_line(ui: &Ui, rows: &[Rect], to: usize) {
    ui.set_cursor_icon(CursorIcon::Grabbing);
    let y = match (rows.get(to), rows.last()) {
        (Some(row), _) => row.top() - 2.0,
        (None, Some(last)) => last.bottom() + 2.0,
        (None, None) => return,
    };
    let stroke = Stroke::new(2.0, ui.visuals().hyperlink_color);
    ui.painter().hline(ui.max_rect().x_range(), y, stroke);
}

/// The dots for dragging a row, which keep the keyboard while it's moved. Its number and its symbol. A bar means that
/// it's applied.
fn handle(ui: &mut Ui, t: &'static Texts, order: &Order, place: usize, is_done: bool) -> egui::Response {
    let call = order.list[place].call;
    let height = ui.spacing().interact_size.y;
    let (rect, response) = ui.allocate_exact_size(vec2(DOTS + SYMBOL, height), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, words::step(t.lang, place, call)));
    if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Grab);
    }
    let (visuals, painter) = (ui.visuals(), ui.painter());
    if is_done {
        let bar = Rect::from_min_size(rect.min, vec2(3.0, height));
        painter.rect_filled(bar, 1.0, visuals.selection.bg_fill);
    }
    let color = if response.hovered() { visuals.text_color() } else { visuals.weak_text_color() };
    for (dx, dy) in [(0.0, -5.0), (0.0, 0.0), (0.0, 5.0), (4.0, -5.0), (4.0, 0.0), (4.0, 5.0)] {
        painter.circle_filled(pos2(rect.left() + 6.0 + dx, rect.center().y + dy), 1.2, color);
    }
    let galley = painter.layout_job(theme::symbol(ui, &format!("{}. {}", place + 1, call.symbol())));
    let at = pos2(rect.left() + DOTS + 2.0, rect.center().y - galley.size().y / 2.0);
    painter.galley(at, galley, visuals.text_color());
    if response.has_focus() {
        painter.rect_stroke(rect, 2.0, Stroke::new(1.5, visuals.hyperlink_color), StrokeKind::Inside);
    }
    response.explained(format!("{} ({})", words::kind(t.lang, call), words::function(call)))
}

/// The note on a call. Those of the stack have the note on the matrix of an object.
const fn note_on(call: Call) -> &'static str {
    match call {
        Call::Translate(_) => "translation",
        Call::RotateX(_) | Call::RotateY(_) | Call::RotateZ(_) => "rotation",
        Call::Scale(_) => "scale",
        Call::Push | Call::Pop => "M_m",
    }
}

/// The numbers of a call.
fn fields(ui: &mut Ui, t: &'static Texts, call: &mut Call, key: usize) {
    let owner = format!("call {key}");
    let symbol = call.symbol();
    let room = ui.available_width() - BUTTONS;
    let hint = words::kind(t.lang, *call);
    let texts = camera_lab_words::window::texts(t.lang);
    match call {
        Call::Translate(v) | Call::Scale(v) => {
            let width = ((room - 2.0 * 3.0) / 3.0).floor().max(30.0);
            let mut components: [f64; 3] = v.to_array();
            for (component, axis) in components.iter_mut().zip(["x", "y", "z"]) {
                let field = NumberField::new(format!("{symbol} {axis}"), Step::Add(0.1)).of(&owner);
                field.prefix(axis).hint(hint).width(width).show(ui, texts, component);
            }
            *v = glam::DVec3::from_array(components);
        }
        Call::RotateX(degrees) | Call::RotateY(degrees) | Call::RotateZ(degrees) => {
            let field = NumberField::angle(symbol, 5.0).of(&owner);
            field.hint(hint).width(((room - 2.0 * 3.0) / 3.0).floor().max(50.0)).show(ui, texts, degrees);
        }
        Call::Push | Call::Pop => {
            ui.add(egui::Label::new(egui::RichText::new(words::function(*call)).monospace().weak()).truncate());
        }
    }
}

/// Earlier, later, away, at the right end of the row.
fn buttons(ui: &mut Ui, t: &'static Texts, place: usize, key: usize, count: usize) -> Option<OrderChange> {
    let number = place + 1;
    let (up, down, away) = at_right(ui, |ui| {
        let mut button = |sign: &str, name: &str, enabled: bool| {
            let button = egui::Button::new(sign).min_size(vec2(BUTTON, 0.0)).small();
            ui.add_enabled(enabled, button).explained(name).accessible_name(format!("{name} {number}")).clicked()
        };
        (button("▲", t.earlier, place > 0), button("▼", t.later, place + 1 < count), button("✕", t.remove, true))
    });
    match (up, down, away) {
        (true, _, _) => Some(OrderChange::Step(key, false)),
        (_, true, _) => Some(OrderChange::Step(key, true)),
        (_, _, true) => Some(OrderChange::Remove(place)),
        _ => None,
    }
}
