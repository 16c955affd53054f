//! The presentation besides large type: its keys, and the annotations over the pictures.

use std::time::Duration;

use eframe::egui::text::LayoutJob;
use eframe::egui::{
    self, Area, Color32, Context, CursorIcon, Event, FontId, Id, Key, KeyboardShortcut, LayerId, Modifiers, Order,
    Pos2, RawInput, Rect, Sense, Shape, Stroke, TextStyle, Ui, vec2,
};

use crate::gui::app::file_flow::questions::FileFlow;
use crate::gui::app::state::State;
use crate::gui::kit::{Command, theme};
use crate::gui::learn::Learn;
use crate::gui::views::annotations::Annotations;
use camera_lab_desk::Model;
use camera_lab_words::learn::lessons;
use camera_lab_words::{told, window};

/// Duration of the display of the keys, in seconds, and of its fading.
const SHOWN: f64 = 8.0;
const FADES: f64 = 0.7;

/// The enlargement of a presentation on the usual screen, and on a finer one without a scale of its own.
const ENLARGEMENT: f32 = 1.6;
const USUAL_SCREEN: egui::Vec2 = vec2(1920.0, 1080.0);
const FINEST: f32 = 6.0;

/// The zoom of a presentation in a window of this size in points without any zoom. Letters have at least the share of a
/// large screen that they have of the usual one, even if the system gives the screen no scale.
pub(in crate::gui) fn zoom(window: egui::Vec2) -> f32 {
    ENLARGEMENT * (window / USUAL_SCREEN).min_elem().clamp(1.0, FINEST)
}

/// Colour of the pen and of the spot, visible on light and on dark ground.
const INK: Color32 = Color32::from_rgb(0xe0, 0x2a, 0x1f);

/// The plain keys of a presentation, including those of a remote control.
pub(in crate::gui) const KEYS: [(KeyboardShortcut, Command); 11] = [
    (KeyboardShortcut::new(Modifiers::NONE, Key::PageDown), Command::NextFigure),
    (KeyboardShortcut::new(Modifiers::NONE, Key::PageUp), Command::PreviousFigure),
    (KeyboardShortcut::new(Modifiers::NONE, Key::P), Command::Pen),
    (KeyboardShortcut::new(Modifiers::NONE, Key::S), Command::Spot),
    (KeyboardShortcut::new(Modifiers::NONE, Key::F), Command::Freeze),
    (KeyboardShortcut::new(Modifiers::NONE, Key::B), Command::Blank),
    (KeyboardShortcut::new(Modifiers::NONE, Key::Period), Command::Blank),
    (KeyboardShortcut::new(Modifiers::NONE, Key::C), Command::StepText),
    (KeyboardShortcut::new(Modifiers::NONE, Key::Q), Command::StepQuestion),
    (KeyboardShortcut::new(Modifiers::NONE, Key::N), Command::StepNotes),
    (KeyboardShortcut::new(Modifiers::NONE, Key::K), Command::Contrast),
];

/// The keys of a remote control, which turn the steps of a lesson without a presentation too.
pub(in crate::gui) const PAGES: [(KeyboardShortcut, Command); 2] = [KEYS[0], KEYS[1]];

/// The arrows of a remote control, when no picture and no field has the keyboard.
pub(in crate::gui) const ARROWS: [(KeyboardShortcut, Command); 2] = [
    (KeyboardShortcut::new(Modifiers::NONE, Key::ArrowRight), Command::NextFigure),
    (KeyboardShortcut::new(Modifiers::NONE, Key::ArrowLeft), Command::PreviousFigure),
];

/// Handles Esc if it has no other meaning: it clears annotations, or without any leaves the presentation. Returns the
/// command.
pub(in crate::gui) fn escape(
    ctx: &Context,
    model: &Model,
    file_flow: &FileFlow,
    annotations: &Annotations,
) -> Option<Command> {
    let shown = model.settings.presentation || annotations.any();
    let busy = ctx.text_edit_focused() || ctx.any_popup_open() || file_flow.dialog.is_some();
    if !shown || busy || !ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
        return None;
    }
    Some(if annotations.any() { Command::ClearAnnotations } else { Command::Presentation })
}

/// Seconds after which a resting pointer disappears.
const REST: f64 = 3.0;

/// The pointer of a presentation. When it rests, it disappears with its bar, hint and cross hairs, because you can't
/// move it away with a remote control.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::gui) struct RestingPointer {
    moved: f64,
    at: Option<Pos2>,
    gone: bool,
}

impl RestingPointer {
    /// Takes the pointer out of the input once it has rested. `is_free` means that nothing is held or open, and no
    /// question is pending.
    pub(in crate::gui) fn follow(&mut self, input: &mut RawInput, now: f64, is_free: bool) {
        let is_of_pointer = |event: &Event| {
            matches!(
                event,
                Event::PointerMoved(_) | Event::PointerButton { .. } | Event::MouseWheel { .. } | Event::Touch { .. }
            )
        };
        for event in &input.events {
            match event {
                Event::PointerMoved(at) => self.at = Some(*at),
                Event::PointerGone => self.at = None,
                _ => {}
            }
        }
        let turns = input.events.iter().any(|event| matches!(event, Event::MouseWheel { .. }));
        if !is_free || input.events.iter().any(is_of_pointer) {
            if let Some(at) = self.at.filter(|_| self.gone && turns) {
                // The wheel acts where the pointer rested.
                input.events.insert(0, Event::PointerMoved(at));
            }
            (self.moved, self.gone) = (now, false);
        } else if !self.gone && now - self.moved >= REST {
            self.gone = true;
            input.events.push(Event::PointerGone);
        }
    }

    /// Hides the arrow too, or requests a frame for the time when it will have rested.
    pub(in crate::gui) fn show(self, ctx: &Context, presents: bool) {
        if self.gone {
            ctx.set_cursor_icon(CursorIcon::None);
        } else if presents {
            let left = self.moved + REST - ctx.input(|input| input.time);
            ctx.request_repaint_after(Duration::from_secs_f64(left.max(0.05)));
        }
    }
}

/// The height at the upper border in which the pointer calls the bar, in points.
const EDGE: f32 = 26.0;

/// The bar of a presentation, over the pictures. It appears when the pointer goes to the upper border, and stays while
/// one of its menus is open. Returns the chosen command.
pub(in crate::gui) fn bar(ctx: &Context, state: &State) -> Option<Command> {
    let id = Id::unique("bar of the presentation");
    let was_shown = ctx.data(|data| data.get_temp::<bool>(id)).unwrap_or(false);
    let at_edge = ctx.pointer_hover_pos().is_some_and(|pointer| pointer.y < if was_shown { 1.6 * EDGE } else { EDGE });
    let held = ctx.input(|input| input.pointer.any_down()) && !was_shown;
    let is_shown = !state.file_flow.is_asking()
        && (at_edge && !held && !state.annotations.pen || was_shown && ctx.any_popup_open());
    ctx.data_mut(|data| data.insert_temp(id, is_shown));
    let area = Area::new(id).order(Order::Middle).fixed_pos(ctx.content_rect().min).constrain(false);
    if !is_shown {
        return None;
    }
    let shown = area.show(ctx, |ui| {
        ui.set_width(ctx.content_rect().width());
        let frame = egui::Frame::side_top_panel(ui.style()).fill(ui.visuals().panel_fill);
        frame.show(ui, |ui| super::menu::bar(ui, state)).inner
    });
    shown.inner
}

/// Lines of a caption, at most.
const CAPTION_ROWS: usize = 2;

/// The title and the caption of the figure, large, above the pictures. Shows nothing if it has none. The title of a
/// step may have been edited since its figure was shown.
pub(in crate::gui) fn caption(ui: &mut Ui, model: &Model, learn: &Learn) {
    let figure = model.desk.shown.figure();
    let of_step = learn.lesson.as_ref().and_then(|playing| playing.now()).map(|step| &step.title);
    let is_own = figure.title != model.desk.shown.saved().title;
    let title = of_step.filter(|title| !is_own && !title.en.is_empty()).or(figure.title.as_ref());
    let has_none = title.is_none() && figure.caption.is_none();
    if has_none || model.desk.shown.has_words_of_card() {
        return;
    }
    let lang = model.settings.lang;
    egui::Panel::top("caption").show(ui, |ui| {
        let body = TextStyle::Body.resolve(ui.style());
        let rows = [
            (title, TextStyle::Heading.resolve(ui.style()), ui.visuals().strong_text_color(), 1),
            (
                figure.caption.as_ref(),
                FontId::new(1.15 * body.size, body.family),
                ui.visuals().text_color(),
                CAPTION_ROWS,
            ),
        ];
        for (text, font, color, rows) in rows {
            let Some(text) = text else { continue };
            let text = told(lang, text);
            let width = ui.available_width();
            let mut job = match rows {
                // Titles name matrices, M_p.
                1 => theme::lowered(ui, text, &TextStyle::Heading, color),
                _ => LayoutJob::simple(text.to_owned(), font, color, width),
            };
            job.wrap.max_width = width;
            job.wrap.max_rows = rows;
            ui.label(job);
        }
    });
}

/// The annotations over the pictures, which are in `room`.
pub(in crate::gui) fn show(ctx: &Context, learn: &Learn, annotations: &mut Annotations, room: Rect) {
    let playing = learn.lesson.as_ref();
    annotations.follow_step(playing.map(|playing| (playing.lesson.id.as_str(), playing.step)));
    if annotations.pen {
        pen(ctx, annotations, room);
    }
    let painter = ctx.layer_painter(LayerId::new(Order::Middle, Id::unique("annotations"))).with_clip_rect(room);
    for stroke in &annotations.strokes {
        painter.add(Shape::line(stroke.clone(), Stroke::new(3.0, INK)));
    }
    if annotations.spot
        && let Some(pointer) = ctx.pointer_hover_pos().filter(|pointer| room.contains(*pointer))
    {
        painter.circle(pointer, 26.0, INK.gamma_multiply(0.18), Stroke::new(2.5, INK));
        painter.circle_filled(pointer, 3.0, INK);
    }
    if annotations.blank {
        let painter = ctx.layer_painter(LayerId::new(Order::Tooltip, Id::unique("blank")));
        painter.rect_filled(ctx.content_rect(), 0.0, Color32::BLACK);
    }
}

/// The pointer draws over the pictures, which don't react to it meanwhile.
fn pen(ctx: &Context, annotations: &mut Annotations, room: Rect) {
    let strokes = &mut annotations.strokes;
    Area::new(Id::unique("pen")).order(Order::Middle).fixed_pos(room.min).show(ctx, |ui| {
        let response = ui.allocate_rect(room, Sense::drag());
        let response = response.on_hover_and_drag_cursor(CursorIcon::Crosshair);
        if response.drag_started() {
            strokes.push(ctx.input(|input| input.pointer.press_origin()).into_iter().collect());
        }
        let at = response.interact_pointer_pos().filter(|_| response.dragged());
        if let (Some(at), Some(stroke)) = (at, strokes.last_mut())
            && stroke.last().is_none_or(|last: &Pos2| last.distance(at) > 1.0)
        {
            stroke.push(at);
        }
    });
}

/// The keys of a presentation while they are visible, with their opacity. While Esc would remove something, they say
/// so.
pub(in crate::gui) fn keys(
    ctx: &Context,
    model: &Model,
    learn: &Learn,
    annotations: &mut Annotations,
) -> Option<(&'static str, f32)> {
    let t = window::texts(model.settings.lang);
    if annotations.any() {
        return Some((if annotations.frozen { t.frozen } else { t.escape_clears }, 1.0));
    }
    let since = annotations.keys_since.filter(|_| model.settings.presentation)?;
    let left = since + SHOWN - ctx.input(|input| input.time);
    let fading = if model.settings.reduce_motion { 0.0 } else { FADES };
    if left <= 0.0 {
        annotations.keys_since = None;
        return None;
    }
    ctx.request_repaint_after(Duration::from_secs_f64((left - fading).max(1.0 / 60.0)));
    #[expect(clippy::cast_possible_truncation, reason = "a share")]
    let share = if fading > 0.0 { (left / fading).min(1.0) as f32 } else { 1.0 };
    let lang = model.settings.lang;
    let of_lesson = learn.lesson.is_some().then(|| lessons::texts(lang).presentation_keys);
    Some((of_lesson.unwrap_or(window::texts(lang).presentation_keys), share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_have_the_same_share_of_large_screens() {
        let share = |width: f32, height: f32| zoom(vec2(width, height)) / height;
        for height in [1080.0, 1440.0, 2160.0] {
            assert!((share(height * 16.0 / 9.0, height) - share(1920.0, 1080.0)).abs() < 1e-6, "{height}");
        }
        // Small screens have the letters of the usual one, and a wide one isn't high.
        assert_eq!([vec2(1280.0, 720.0), vec2(5120.0, 1080.0)].map(zoom), [ENLARGEMENT; 2]);
    }

    #[test]
    fn a_pointer_that_rests_is_gone_until_it_moves() {
        let mut pointer = RestingPointer::default();
        let mut after = |events: Vec<Event>, now, is_free| {
            let mut input = RawInput { events, ..RawInput::default() };
            pointer.follow(&mut input, now, is_free);
            input.events.contains(&Event::PointerGone)
        };
        let moved = || vec![Event::PointerMoved(egui::pos2(5.0, 5.0))];
        assert!(!after(moved(), 10.0, true) && !after(vec![], 12.9, true));
        assert!(after(vec![], 13.0, true), "it has rested for three seconds");
        assert!(!after(vec![], 14.0, true), "once");
        assert!(!after(moved(), 20.0, true) && !after(vec![], 22.0, true) && after(vec![], 23.1, true));
        // The wheel wakes it in its old place.
        let wheel = Event::MouseWheel {
            unit: egui::MouseWheelUnit::Line,
            delta: vec2(0.0, 1.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers: Modifiers::NONE,
        };
        let mut input = RawInput { events: vec![wheel], ..RawInput::default() };
        RestingPointer { at: Some(egui::pos2(5.0, 5.0)), gone: true, moved: 0.0 }.follow(&mut input, 24.0, true);
        assert_eq!(input.events[0], moved()[0]);
        // A key, and a pointer that has left the window, leave it alone.
        let mut input = RawInput::default();
        RestingPointer { at: Some(egui::pos2(5.0, 5.0)), gone: true, moved: 0.0 }.follow(&mut input, 24.0, false);
        assert!(input.events.is_empty());
        // While a button is held or a question is open, it stays.
        assert!(!after(vec![], 30.0, false) && !after(vec![], 32.0, true) && after(vec![], 33.0, true));
    }
}
