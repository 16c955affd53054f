//! The keyboard's way through the window, from region to region. The focused widget is marked and scrolled into sight,
//! and Enter closes lists.

use eframe::egui::accesskit::Role;
use eframe::egui::{
    self, Context, CornerRadius, Event, FocusDirection, Id, Key, LayerId, Modifiers, Order, Popup, Rect, Response,
    Sense, Stroke, StrokeKind, Ui,
};

/// A part of the window that Ctrl+Tab goes to, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::gui) enum Region {
    /// Menus and switches.
    Bar,
    /// The panel on the left.
    Parameters,
    /// A picture, by its place among [`View::ALL`](crate::views::View::ALL).
    Picture(usize),
    /// The stages of the pipeline.
    Strip,
    /// The lesson being played.
    Lesson,
    /// The studies of error against run time.
    Numerics,
    /// Operations and numbers, or the explanations.
    Numbers,
}

/// The regions of a frame: their focusable widgets, with their places.
#[derive(Clone, Debug, Default)]
struct Regions(Vec<(Region, Id, Rect)>);

/// The state of the focus from frame to frame.
#[derive(Debug, Default)]
pub(in crate::gui) struct Focus {
    /// True if a key moved the focus, not the pointer. Only then it's marked.
    by_keyboard: bool,
    last: Option<Id>,
    /// The focused widget before a list or a menu opened.
    before_popup: Option<Id>,
    popup_was_open: bool,
}

impl Focus {
    /// Begins a frame: takes Ctrl+Tab, unless a dialog has the keyboard.
    pub(in crate::gui) fn begin(&mut self, ctx: &Context, dialog: bool) {
        let (pressed, keyed) = ctx.input(|input| {
            let pressed = input.events.iter().any(|e| matches!(e, Event::PointerButton { pressed: true, .. }));
            let keyed = input.events.iter().any(|e| match e {
                Event::Key { key, pressed: true, .. } => {
                    matches!(key, Key::Tab | Key::ArrowUp | Key::ArrowDown | Key::ArrowLeft | Key::ArrowRight | Key::F6)
                }
                _ => false,
            });
            (pressed, keyed)
        });
        self.by_keyboard = (self.by_keyboard || keyed) && !pressed;
        let now = ctx.memory(|memory| memory.focused());
        let moved = self.by_keyboard && now != self.last;
        self.last = now;
        let regions = ctx.data_mut(|data| {
            data.insert_temp(moved_id(), moved);
            std::mem::take(data.get_temp_mut_or_default::<Regions>(regions_id()))
        });
        // With Shift it's Ctrl+Tab as well, so shortcuts with more keys are tested first.
        let taken = |modifiers| !dialog && ctx.input_mut(|input| input.consume_key(modifiers, Key::Tab));
        let back = taken(Modifiers::CTRL | Modifiers::SHIFT);
        let forward = !back && taken(Modifiers::CTRL);
        if !dialog && !forward && !back {
            go_on_as_read(ctx, &regions, now);
        }
        if forward || back {
            Popup::close_all(ctx);
            if let Some(id) = next_region(ctx, regions, now, back) {
                ctx.memory_mut(|memory| {
                    memory.move_focus(FocusDirection::None);
                    memory.request_focus(id);
                });
                self.by_keyboard = true;
            }
        }
        self.close_popup(ctx, now);
    }

    /// Enter and the space bar choose in an open list or menu, and so close it. The focus goes back to its former
    /// place. In a text field they are typed.
    fn close_popup(&mut self, ctx: &Context, now: Option<Id>) {
        let open = Popup::is_any_open(ctx);
        if open && !self.popup_was_open {
            self.before_popup = self.last;
        }
        let in_popup = now.and_then(|id| ctx.read_response(id)).is_some_and(|r| r.layer_id.order == Order::Foreground);
        let chosen = ctx.input(|input| {
            input.events.iter().any(|e| matches!(e, Event::Key { key: Key::Enter | Key::Space, pressed: true, .. }))
        });
        let chosen = chosen && !ctx.text_edit_focused();
        if !open
            && self.popup_was_open
            && self.by_keyboard
            && now.is_none_or(|_| in_popup || ctx.memory(|m| m.focused().is_none()))
        {
            self.restore(ctx);
        }
        self.popup_was_open = open;
        ctx.data_mut(|data| data.insert_temp(close_id(), open && chosen && in_popup));
    }

    fn restore(&mut self, ctx: &Context) {
        if let Some(id) = self.before_popup.take() {
            ctx.memory_mut(|memory| memory.request_focus(id));
        }
    }

    /// Ends a frame: closes a list after a choice in it, and marks the focused widget.
    pub(in crate::gui) fn end(&mut self, ctx: &Context) {
        if ctx.data(|data| data.get_temp::<bool>(close_id())).unwrap_or(false) {
            ctx.data_mut(|data| data.insert_temp(close_id(), false));
            Popup::close_all(ctx);
            self.popup_was_open = false;
            self.restore(ctx);
        }
        if self.by_keyboard
            && let Some(focused) = ctx.memory(|memory| memory.focused())
            && let Some(response) = ctx.read_response(focused)
        {
            mark(ctx, &response);
        }
    }
}

/// Tab goes through the window in reading order: menus, parameters, pictures, operations and numbers. egui goes through
/// controls in layout order, but the panel on the right is laid out before the pictures, which take the remaining room.
fn go_on_as_read(ctx: &Context, regions: &Regions, now: Option<Id>) {
    let pressed = |shift: bool| {
        ctx.input(|input| {
            let is_tab = |event: &Event| {
                matches!(event, Event::Key { key: Key::Tab, pressed: true, modifiers, .. }
                    if modifiers.shift == shift && !modifiers.command && !modifiers.ctrl && !modifiers.alt)
            };
            input.events.iter().any(is_tab)
        })
    };
    let (forward, back) = (pressed(false), pressed(true));
    if forward == back || Popup::is_any_open(ctx) {
        return;
    }
    let order = as_read(ctx, regions);
    let place = now.map(|now| order.iter().position(|id| *id == now));
    let next = match place {
        // The focused widget isn't in the window itself.
        Some(None) => return,
        None if back => order.last(),
        None => order.first(),
        Some(Some(place)) if back => order.get(place.checked_sub(1).unwrap_or(order.len() - 1)),
        Some(Some(place)) => order.get((place + 1) % order.len()),
    };
    if let Some(next) = next {
        ctx.memory_mut(|memory| {
            memory.move_focus(FocusDirection::None);
            memory.request_focus(*next);
        });
    }
}

/// The focusable widgets of the window itself, as in the last frame: first all but the panel on the right and the one
/// of studies, which are laid out before the pictures, then those two.
fn as_read(ctx: &Context, regions: &Regions) -> Vec<Id> {
    /// A panel's frame, and the handle that makes it wider.
    const MARGIN: f32 = 12.0;
    let find = |wanted: Region| regions.0.iter().find(|(region, ..)| *region == wanted);
    let (numbers, numerics) = (find(Region::Numbers), find(Region::Numerics));
    ctx.viewport(|viewport| {
        let widgets = &viewport.prev_pass.widgets;
        let all = widgets.get_layer(LayerId::background()).filter(|w| w.enabled && w.sense.is_focusable());
        let (mut in_numbers, mut in_numerics) = (false, false);
        let mut late = [Vec::new(), Vec::new()];
        let mut order = Vec::new();
        for widget in all {
            let begins = |region: Option<&(Region, Id, Rect)>| region.is_some_and(|(_, id, _)| widget.id == *id);
            // Its controls come one after the other, up to the next region's. The pictures above it begin with their
            // titles.
            in_numerics = begins(numerics) || (in_numerics && !regions.0.iter().any(|(_, id, _)| widget.id == *id));
            in_numbers |= begins(numbers);
            let center = widget.rect.center();
            if in_numerics && numerics.is_some_and(|(_, _, rect)| center.y > rect.top() - MARGIN) {
                late[0].push(widget.id);
            } else if in_numbers && numbers.is_some_and(|(_, _, rect)| rect.x_range().expand(MARGIN).contains(center.x))
            {
                late[1].push(widget.id);
            } else {
                order.push(widget.id);
            }
        }
        order.into_iter().chain(late.into_iter().flatten()).collect()
    })
}

/// The region after (or before) the one that holds the focus. If none does, the first.
fn next_region(ctx: &Context, regions: Regions, focused: Option<Id>, back: bool) -> Option<Id> {
    let mut all = regions.0;
    all.sort_by_key(|(region, ..)| *region);
    let place = focused.and_then(|id| ctx.read_response(id)).map(|response| response.rect.center());
    let by_id = all.iter().position(|(_, id, _)| Some(*id) == focused);
    let now = by_id.or_else(|| all.iter().position(|(_, _, rect)| place.is_some_and(|place| rect.contains(place))));
    let next = match now {
        None => 0,
        Some(now) if back => (now + all.len() - 1) % all.len().max(1),
        Some(now) => (now + 1) % all.len(),
    };
    all.get(next).map(|(_, id, _)| *id)
}

/// A ring around the focused widget, because the colours of a control that is on, or hovered, don't show the focus.
fn mark(ctx: &Context, response: &Response) {
    let visible = response.interact_rect;
    if !visible.is_positive() {
        return;
    }
    let color = ctx.global_style().visuals.hyperlink_color;
    // Above its own layer, so that a list or a dialog in front of it hides it like the control.
    let painter = ctx.layer_painter(LayerId::new(Order::Foreground, Id::unique("focus ring")));
    let painter =
        if response.layer_id.order == Order::Background { ctx.layer_painter(LayerId::background()) } else { painter };
    painter.rect_stroke(visible.expand(1.0), CornerRadius::same(4), Stroke::new(2.0, color), StrokeKind::Outside);
}

fn regions_id() -> Id {
    Id::unique("regions of the window")
}

fn moved_id() -> Id {
    Id::unique("focus moved by a key")
}

fn close_id() -> Id {
    Id::unique("close the list")
}

/// Makes a part of the window a region that Ctrl+Tab goes to. `name` is for screen readers. Tab moves on to its first
/// control.
pub(in crate::gui) fn region(ui: &Ui, rect: Rect, region: Region, name: &str) {
    let id = Id::unique(("region", region));
    let response = ui.interact(rect, id, Sense::FOCUSABLE);
    ui.ctx().accesskit_node_builder(id, |node| {
        node.set_role(Role::Region);
        node.set_label(name);
    });
    note(ui.ctx(), region, response.id, rect);
}

/// Makes a widget with its surroundings a region that Ctrl+Tab goes to.
pub(in crate::gui) fn note(ctx: &Context, region: Region, id: Id, rect: Rect) {
    ctx.data_mut(|data| data.get_temp_mut_or_default::<Regions>(regions_id()).0.push((region, id, rect)));
}

/// Scrolls a widget that a key has focused into sight. Call it at the end of the content of a scroll area.
pub(in crate::gui) fn keep_in_sight(ui: &Ui) {
    if !ui.ctx().data(|data| data.get_temp::<bool>(moved_id())).unwrap_or(false) {
        return;
    }
    let focused = ui.ctx().memory(|memory| memory.focused()).and_then(|id| ui.ctx().read_response(id));
    if let Some(response) = focused.filter(|response| response.layer_id == ui.layer_id())
        && ui.min_rect().contains(response.rect.center())
        && response.interact_rect.height() < 0.9 * response.rect.height()
    {
        ui.scroll_to_rect(response.rect.expand(8.0), None);
    }
}

/// Controls at the right end of a row, in reading order, which is the order of Tab. A layout from right to left would
/// reverse it.
pub(in crate::gui) fn at_right<R>(ui: &mut Ui, controls: impl FnOnce(&mut Ui) -> R) -> R {
    with_room_before(ui, |_| (), controls)
}

/// As [`at_right`], with other content in the room that is left before the controls.
pub(in crate::gui) fn with_room_before<R>(
    ui: &mut Ui,
    before: impl FnOnce(&mut Ui),
    controls: impl FnOnce(&mut Ui) -> R,
) -> R {
    let id = ui.unique_id().with("controls at the right");
    let known: Option<f32> = ui.data(|data| data.get_temp(id));
    let line = egui::Layout::left_to_right(egui::Align::Center);
    let room = ui.available_rect_before_wrap();
    let left = known.map_or(room.left(), |width| (room.right() - width).max(room.left()));
    let gap = ui.spacing().item_spacing.x;
    let room_before = room.with_max_x((left - gap).max(room.left()));
    before(&mut ui.new_child(egui::UiBuilder::new().id_salt("before").max_rect(room_before).layout(line)));
    // With the whole room, since a text that's cut to the width of a shorter one would never ask for more.
    let whole = Rect::from_min_size(egui::pos2(left, room.top()), room.size());
    let builder = egui::UiBuilder::new().id_salt("controls").max_rect(whole).layout(line);
    let mut at_right = ui.new_child(builder);
    let result = controls(&mut at_right);
    let used = at_right.min_rect();
    // No wider than the room, because a panel would grow to hold it.
    ui.advance_cursor_after_rect(Rect::from_min_max(
        room.min,
        egui::pos2(room.right(), used.bottom().max(room.bottom())),
    ));
    if known.is_none_or(|known| (known - used.width()).abs() > 0.1) {
        ui.data_mut(|data| data.insert_temp(id, used.width()));
        ui.ctx().request_discard("controls at the right have another width");
    }
    result
}
