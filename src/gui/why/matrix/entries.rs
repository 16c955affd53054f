//! The entries of a matrix as a grid, each a control of its own.

use eframe::egui::{
    self, Color32, EventFilter, Id, Key, Modifiers, Pos2, Rect, Response, Role, Sense, Stroke, Ui, Vec2, WidgetInfo,
    pos2, vec2,
};

use crate::gui::kit::{Formula, brackets, help_topic};

/// A written entry.
#[derive(Clone, Debug)]
pub(in crate::gui::why) struct Cell {
    /// The formula to set.
    pub(in crate::gui::why) latex: String,
    /// The formula on one line.
    pub(in crate::gui::why) text: String,
    /// The name for screen readers.
    pub(in crate::gui::why) name: String,
    /// It depends on the parameter under the pointer.
    pub(in crate::gui::why) depends: bool,
    /// The glow of a recent change: from 1 to 0.
    pub(in crate::gui::why) glow: f32,
}

/// The interaction with the entries.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::gui::why) struct Pointed {
    /// The one under the pointer.
    pub(in crate::gui::why) hovered: Option<[usize; 2]>,
    /// The entry that was clicked, or has the keyboard.
    pub(in crate::gui::why) chosen: Option<[usize; 2]>,
}

/// The type size of entries, in points.
const SIZE: f32 = 13.5;
/// The smallest scale at which all of them have to fit.
const SMALLEST: f32 = 0.72;
/// Between columns and between rows, in points.
const GAP: Vec2 = vec2(12.0, 7.0);
/// Between the brackets and the entries.
const MARGIN: f32 = 10.0;

/// The grid, set in a type size.
struct Layout {
    formulas: Vec<Formula>,
    widths: [f32; 4],
    heights: [f32; 4],
    baselines: [f32; 4],
}

impl Layout {
    fn new(ui: &Ui, cells: &[[Cell; 4]; 4], size: f32) -> Self {
        let formulas: Vec<Formula> =
            cells.as_flattened().iter().map(|cell| Formula::new(ui, &cell.latex, &cell.text, size)).collect();
        let at = |i: usize, j: usize| &formulas[4 * i + j];
        let most = |values: [f32; 4]| values.into_iter().fold(0.0_f32, f32::max);
        let each = |f: &dyn Fn(usize) -> f32| -> [f32; 4] { std::array::from_fn(f) };
        let widths = each(&|j| most(each(&|i| at(i, j).size().x)).max(14.0));
        let baselines = each(&|i| most(each(&|j| at(i, j).baseline())));
        let below = each(&|i| most(each(&|j| at(i, j).size().y - at(i, j).baseline())));
        let heights = each(&|i| (baselines[i] + below[i]).max(14.0));
        Self { formulas, widths, heights, baselines }
    }

    fn size(&self) -> Vec2 {
        let sum = |values: [f32; 4]| values.iter().sum::<f32>();
        vec2(sum(self.widths) + 3.0 * GAP.x + 2.0 * MARGIN, sum(self.heights) + 4.0 * GAP.y)
    }

    /// The room of an entry, with half the gaps around it.
    fn place(&self, corner: Pos2, i: usize, j: usize) -> Rect {
        let x = corner.x + MARGIN + self.widths[..j].iter().sum::<f32>() + GAP.x * gaps(j);
        let y = corner.y + GAP.y / 2.0 + self.heights[..i].iter().sum::<f32>() + GAP.y * gaps(i);
        Rect::from_min_size(pos2(x, y), vec2(self.widths[j], self.heights[i])).expand2(GAP * 0.5 - vec2(1.0, 0.5))
    }

    /// The position of a formula: in the middle of its column, on the baseline of its row.
    fn corner(&self, place: Rect, i: usize, j: usize) -> Pos2 {
        let formula = &self.formulas[4 * i + j];
        let top = place.center().y - self.heights[i] / 2.0 + self.baselines[i] - formula.baseline();
        pos2(place.center().x - formula.size().x / 2.0, top)
    }
}

#[expect(clippy::cast_precision_loss, reason = "0 … 3")]
fn gaps(before: usize) -> f32 {
    before as f32
}

/// Shows the entries between brackets. `chosen` is marked, and takes the keyboard if `wants_focus` is set. `note` is
/// the one on the matrix.
pub(in crate::gui::why) fn show(
    ui: &mut Ui,
    cells: &[[Cell; 4]; 4],
    (chosen, wants_focus): ([usize; 2], bool),
    note: &'static str,
) -> Pointed {
    let mut layout = Layout::new(ui, cells, SIZE);
    let factor = (ui.available_width() / layout.size().x).clamp(SMALLEST, 1.0);
    if factor < 1.0 {
        layout = Layout::new(ui, cells, (SIZE * factor).floor());
    }
    let mut pointed = Pointed::default();
    egui::ScrollArea::horizontal().id_salt("entries").show(ui, |ui| {
        let (room, _) = ui.allocate_exact_size(layout.size(), Sense::hover());
        brackets(ui, room);
        for (i, row) in cells.iter().enumerate() {
            for (j, cell) in row.iter().enumerate() {
                let place = layout.place(room.min, i, j);
                let response = ui.interact(place, entry_id(ui, i, j), Sense::click());
                if wants_focus && chosen == [i, j] {
                    response.request_focus();
                    ui.scroll_to_rect(place, None);
                }
                if response.has_focus() {
                    arrows(ui, [i, j]);
                }
                help_topic(&response, note);
                if response.hovered() {
                    pointed.hovered = Some([i, j]);
                }
                // Arrow keys move the focus after the frame, so no frame reports its arrival.
                if response.clicked() || (response.has_focus() && !wants_focus) {
                    pointed.chosen = Some([i, j]);
                }
                ground(ui, place, cell, chosen == [i, j], &response);
                layout.formulas[4 * i + j].paint(ui.painter(), layout.corner(place, i, j), ui.visuals().text_color());
                let is_chosen = chosen == [i, j];
                response.widget_info(|| WidgetInfo::selected(Role::Button, true, is_chosen, &cell.name));
            }
        }
    });
    pointed
}

/// The arrow keys go from entry to entry, and stay within the matrix at its border.
fn arrows(ui: &Ui, [i, j]: [usize; 2]) {
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(entry_id(ui, i, j), filter));
    // Consumed, so that the entry that gets the keyboard doesn't continue with the same key.
    let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    let step = |at: usize, back: Key, on: Key| match (pressed(back), pressed(on)) {
        (true, false) => at.saturating_sub(1),
        (false, true) => (at + 1).min(3),
        _ => at,
    };
    let next = [step(i, Key::ArrowUp, Key::ArrowDown), step(j, Key::ArrowLeft, Key::ArrowRight)];
    if next != [i, j] {
        ui.memory_mut(|memory| memory.request_focus(entry_id(ui, next[0], next[1])));
    }
}

fn entry_id(ui: &Ui, i: usize, j: usize) -> Id {
    ui.scope_id().with(egui::IdSalt::new(("entry", i, j)))
}

/// The background of an entry: chosen, under the pointer, changed, or dependent on a parameter.
fn ground(ui: &Ui, place: Rect, cell: &Cell, chosen: bool, response: &Response) {
    let visuals = ui.visuals();
    let painter = ui.painter();
    if chosen {
        painter.rect_filled(place, 3.0, visuals.selection.bg_fill);
    } else if response.hovered() {
        painter.rect_filled(place, 3.0, visuals.widgets.hovered.bg_fill);
    }
    if cell.glow > 0.0 {
        painter.rect_filled(place, 3.0, visuals.warn_fg_color.gamma_multiply(0.55 * cell.glow));
    }
    if cell.depends {
        let color: Color32 = visuals.warn_fg_color;
        painter.rect_filled(place, 3.0, color.gamma_multiply(0.2));
        painter.hline(place.x_range(), place.bottom() - 0.5, Stroke::new(1.5, color));
    }
}
