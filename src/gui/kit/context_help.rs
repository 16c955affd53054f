//! Context help: widgets report the note on them in each frame, and F1, or a click on a symbol, opens it.

use eframe::egui::{self, Id, Rect, Response, Ui};

/// The notes on the widget under the pointer, and on the focused one.
#[derive(Clone, Copy, Default)]
struct Noted {
    pointed: Option<&'static str>,
    focused: Option<&'static str>,
    /// True if a symbol was clicked, so that the note under the pointer has to open.
    called: bool,
}

fn key() -> Id {
    Id::unique("noted")
}

/// Clears the reports of the last frame.
pub(in crate::gui) fn begin(ctx: &egui::Context) {
    ctx.data_mut(|data| data.remove::<Noted>(key()));
}

/// The note on the widget under the pointer, else on the focused one.
pub(in crate::gui) fn asked(ctx: &egui::Context) -> Option<&'static str> {
    let noted = ctx.data(|data| data.get_temp::<Noted>(key()))?;
    noted.pointed.or(noted.focused)
}

/// Requests the note on the control under the pointer.
pub(in crate::gui) fn call(ctx: &egui::Context) {
    ctx.data_mut(|data| data.get_temp_mut_or_default::<Noted>(key()).called = true);
}

/// The note requested by a click in this frame.
pub(in crate::gui) fn called(ctx: &egui::Context) -> Option<&'static str> {
    ctx.data(|data| data.get_temp::<Noted>(key())).filter(|noted| noted.called)?.pointed
}

/// Makes F1 on this control open the note `id`.
pub(in crate::gui) fn help_topic(response: &Response, id: &'static str) {
    say(&response.ctx, response.contains_pointer(), response.has_focus(), id);
}

/// Makes F1 on a row, or on a field in it, open the note `id`.
pub(in crate::gui) fn help_topic_row(ui: &Ui, row: Rect, id: &'static str) {
    say(ui.ctx(), ui.rect_contains_pointer(row), has_focus(ui, row), id);
}

/// True if a control in a rectangle has the keyboard.
pub(in crate::gui) fn has_focus(ui: &Ui, rect: Rect) -> bool {
    let focused = ui.memory(|memory| memory.focused()).and_then(|id| ui.ctx().read_response(id));
    focused.is_some_and(|r| r.layer_id == ui.layer_id() && rect.contains(r.rect.center()))
}

fn say(ctx: &egui::Context, pointed: bool, focused: bool, id: &'static str) {
    if pointed || focused {
        ctx.data_mut(|data| {
            let noted = data.get_temp_mut_or_default::<Noted>(key());
            if pointed {
                noted.pointed = Some(id);
            }
            if focused {
                noted.focused = Some(id);
            }
        });
    }
}
