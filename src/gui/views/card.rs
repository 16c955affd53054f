//! The card with the coordinates of the pinned probe: its place, and its buttons.

use eframe::egui::{Context, Id, Pos2, Rect, Ui, Vec2, Window, vec2};
use glam::DVec3;

use super::readout::{self, Cell};
use super::status::{Status, line_height, table};
use super::{Canvas, Pane};
use crate::figure::{Depth, Explanation};
use crate::gui::kit::Explained;
use crate::gui::views::pointer::picking::{PickQuery, PickRequest};
use crate::numbers::{DecimalMark, EXACT_DIGITS};
use crate::views::{Hover, LabelPlace, Probe, Request, Shot, Size, View, pick};
use camera_lab_words::why::explain_point;
use camera_lab_words::window::canvas::CanvasTexts;

/// The room that a card takes before it has been shown, in points.
const USUAL: Vec2 = vec2(250.0, 190.0);
/// Between a card and the border of the pictures.
const MARGIN: f32 = 8.0;

/// The action of a button of a card.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CardAction {
    /// Copy all digits.
    Copy,
    /// Follow the point through every space.
    Follow,
    /// Release the pinned probe.
    Release,
}

fn id() -> Id {
    Id::unique("card of the probe")
}

/// The coordinates of the pinned probe, on a card that stays until it's released, at `place` if it's given. The user
/// can move it.
pub(super) fn show(
    ui: &Ui,
    room: Rect,
    place: Option<Pos2>,
    (cells, is_point): (&[Cell], bool),
    texts: &CanvasTexts,
) -> Option<CardAction> {
    let words = explain_point::texts(texts.lang);
    let mut action = None;
    let mut window = Window::new(texts.card).id(id()).constrain_to(room).title_bar(false).resizable(false);
    if let Some(place) = place {
        window = window.current_pos(place);
    }
    window.show(ui.ctx(), |ui| {
        ui.spacing_mut().item_spacing.y = 1.0;
        let lines = line_height(ui);
        let height = std::mem::replace(&mut ui.spacing_mut().interact_size.y, lines);
        table(ui, cells);
        ui.spacing_mut().interact_size.y = height;
        ui.add_space(3.0);
        ui.horizontal(|ui| {
            if ui.button(texts.copy).explained(texts.copy_hint).clicked() {
                action = Some(CardAction::Copy);
            }
            if is_point && ui.button(words.follow).explained(words.follow_hint).clicked() {
                action = Some(CardAction::Follow);
            }
            if ui.button(texts.release).clicked() {
                action = Some(CardAction::Release);
            }
        });
    });
    action
}

impl Canvas {
    pub(super) fn describe_probe(
        &mut self,
        (ui, room): (&Ui, Rect),
        panes: &[Pane],
        model: &mut camera_lab_desk::Model,
        status: &mut Status,
        texts: &'static CanvasTexts,
    ) {
        let ctx = ui.ctx();
        self.card.follow(ctx, model.pinned(), room);
        let Some(probe) = model.frame.probe else {
            status.note = texts.probe_hint;
            return;
        };
        // The result doesn't depend on the size.
        let size = Size { width: 1, height: 1, scale: 1.0 };
        let of_frame = panes.iter().find(|pane| pane.view == View::Image).map(|pane| pane.request.clone());
        let request = of_frame.unwrap_or_else(|| self.request(model, &self.shot.picture(View::Image), size));
        // The other side of a comparison, with a camera and an image of its own, may be under the pointer.
        let side = self.probed_side.filter(|(of, _)| *of == probe).map(|(_, side)| side);
        let side = side.and_then(|side| request.sides()?.into_iter().nth(side)).map(|side| side.request);
        let request = match side {
            Some(Request { camera, shot, .. }) => {
                Request { camera, shot: Shot { compared: None, ..Shot::clone(&shot) }.into(), ..request }
            }
            None => request,
        };
        let request = Request { hover: Hover::default(), size, ..request };
        let digits = model.settings.digits;
        let asks = matches!(probe, Probe::Window(_)) && request.shot.look.reveal.depth != Depth::Off;
        let at = (asks || self.card.is_placed_again()).then(|| {
            let pick = PickRequest { request: request.clone(), what: PickQuery::At(probe) };
            self.probe_picker.ask(ctx, pick)
        });
        let (depths, point) = at.map_or((None, None), |at| (at.depths, at.point));
        let labels = panes.iter().flat_map(|pane| {
            let of_pane = &self.pictures[pane.picture].labels;
            of_pane.iter().map(|label| place_of_label(pane, label))
        });
        let labels: Vec<Rect> = labels.collect();
        let place = self.card.place(ctx, panes, point, &labels);
        let (mark, scene) = (texts.lang.mark(), model.scene_cache.scene());
        let vertex = match probe {
            Probe::Point(p) => self.vertex_names.at(ctx, p, scene, &model.desk.shown.figure().scene),
            Probe::Window(_) => None,
        };
        let vertex: Vec<_> = vertex.iter().map(|name| readout::vertex_cell(name, texts)).collect();
        let cells = |digits, mark| {
            let coordinates = readout::cells(probe, depths, &request, (digits, mark), texts);
            let coordinates = coordinates.into_iter().map(|cell| cell.unless_asked(&model.frame.asked, texts));
            vertex.iter().cloned().chain(coordinates).collect::<Vec<_>>()
        };
        status.cells = cells(digits.min(4), mark);
        status.exact = cells(digits, mark);
        // In a presentation the same numbers are below the pictures in large letters, and nothing covers the pictures.
        if model.pinned().is_some() && !model.settings.presentation {
            let point = match probe {
                Probe::Point(p) => Some(p),
                Probe::Window(_) => None,
            };
            match show(ui, room, place, (&status.exact, point.is_some()), texts) {
                None => {}
                Some(CardAction::Follow) => {
                    if let Some(p) = point {
                        model.follow_point(p);
                        model.show_explanation(Explanation::Point);
                        ctx.request_repaint();
                    }
                }
                Some(CardAction::Copy) => ctx.copy_text(copied(&cells(EXACT_DIGITS, DecimalMark::Point))),
                Some(CardAction::Release) => {
                    self.stop_probing();
                    model.pin(None);
                    ctx.request_repaint();
                }
            }
        }
        if model.pinned().is_some() {
            status.aside = if status.aside.is_empty() {
                texts.pinned.to_owned()
            } else {
                format!("{} · {}", texts.pinned, status.aside)
            };
        }
    }
}

/// The place of the card.
#[derive(Debug)]
pub(super) struct CardPlace {
    /// The probe on it.
    probe: Option<Probe>,
    /// The room of the pictures.
    room: Rect,
    /// Its upper left corner in the frame before, once it has been shown.
    at: Option<Pos2>,
    /// By hand.
    is_moved: bool,
    /// Number of frames until it has settled.
    settles: u8,
}

impl Default for CardPlace {
    fn default() -> Self {
        Self { probe: None, room: Rect::NOTHING, at: None, is_moved: false, settles: 0 }
    }
}

impl CardPlace {
    /// Places the card again for another probe, and in another room, if the user hasn't moved it.
    fn follow(&mut self, ctx: &Context, probe: Option<Probe>, room: Rect) {
        /// In its first frame a card doesn't know its size yet.
        const FRAMES: u8 = 3;
        let at = ctx.memory(|memory| memory.area_rect(id())).map(|rect| rect.min);
        if probe != self.probe {
            (self.probe, self.is_moved) = (probe, false);
            self.settles = if probe.is_some() { FRAMES } else { 0 };
        } else if room != self.room && !self.is_moved && probe.is_some() {
            self.settles = FRAMES;
        } else if !self.is_placed_again() {
            self.is_moved |= at != self.at;
        }
        (self.room, self.at) = (room, at);
    }

    fn is_placed_again(&self) -> bool {
        self.settles > 0
    }

    /// The new position, in the corner that covers the fewest labels, and of these the farthest from all marks of the
    /// probe and of C. `None` if it has its place, and while the point of the probe is unknown, as in a heavy scene.
    fn place(&mut self, ctx: &Context, panes: &[Pane], point: Option<DVec3>, labels: &[Rect]) -> Option<Pos2> {
        let point = point.filter(|_| self.is_placed_again())?;
        self.settles -= 1;
        ctx.request_repaint();
        // Nor does it cover the camera, where the rays and triangles of the probe meet.
        let shown = panes.iter().flat_map(|pane| {
            let eye = (pane.view != View::Image).then(|| pane.request.camera.position());
            [Some(point), eye].into_iter().flatten().filter_map(|p| place_on_screen(pane, p))
        });
        let shown: Vec<Pos2> = shown.collect();
        let size = ctx.memory(|memory| memory.area_rect(id())).map_or(USUAL, |rect| rect.size());
        let rooms: Vec<Rect> = std::iter::once(self.room).chain(panes.iter().map(|pane| pane.rect.rect)).collect();
        Some(freest_corner(&rooms, size, labels, &shown))
    }
}

/// The place in which a pane shows a point of the world, in points.
fn place_on_screen(pane: &Pane, p_world: DVec3) -> Option<Pos2> {
    let request = Request { hover: Hover::default(), ..pane.request.clone() };
    let pixel = pick::places(&request)?(p_world)?;
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    let [x, y] = pixel.to_array().map(|v| v as f32);
    Some(pane.rect.rect_of(x, y, 0.0, 0.0).min)
}

/// The place of a label of a pane on the screen, in points.
#[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
fn place_of_label(pane: &Pane, label: &LabelPlace) -> Rect {
    let [corner, size] = [label.center - label.half, 2.0 * label.half].map(|v| v.to_array().map(|v| v as f32));
    pane.rect.rect_of(corner[0], corner[1], size[0], size[1])
}

/// The upper left corner of a card of this size, in a corner of a room: where it covers the fewest labels, and of these
/// the one farthest from all places. Of equal ones, the first of: below on the left, below on the right, above on the
/// left, above on the right.
fn freest_corner(rooms: &[Rect], size: Vec2, labels: &[Rect], places: &[Pos2]) -> Pos2 {
    let corners = rooms.iter().flat_map(|room| {
        let inner = room.shrink(MARGIN);
        let (left, top) = (inner.left(), inner.top());
        let (right, bottom) = ((inner.right() - size.x).max(left), (inner.bottom() - size.y).max(top));
        [[left, bottom], [right, bottom], [left, top], [right, top]].map(|[x, y]| Pos2::new(x, y))
    });
    let rank = |corner: &Pos2| {
        let card = Rect::from_min_size(*corner, size);
        let apart = places.iter().map(|place| card.distance_to_pos(*place)).fold(f32::INFINITY, f32::min);
        // A card that lies on its own mark is worse than one on a label.
        let covered = labels.iter().filter(|label| card.intersects(**label)).count();
        (apart <= 0.0, covered, -apart)
    };
    let best = corners.min_by(|a, b| rank(a).partial_cmp(&rank(b)).unwrap_or(std::cmp::Ordering::Equal));
    best.unwrap_or_default()
}

/// Cells as text, a space in a line, with numbers as programs read them.
fn copied(cells: &[Cell]) -> String {
    cells.iter().map(|cell| format!("{}\t{}\n", cell.space, cell.value)).collect::<String>().replace('−', "-")
}

#[cfg(test)]
mod tests {
    use eframe::egui::pos2;

    use super::*;

    #[test]
    fn a_card_stands_in_the_corner_farthest_from_its_point() {
        let room = Rect::from_min_size(pos2(10.0, 20.0), vec2(800.0, 600.0));
        let size = vec2(200.0, 100.0);
        let (left, right, top, bottom) = (18.0, 602.0, 28.0, 512.0);
        let corner = |places: &[Pos2]| freest_corner(&[room], size, &[], places);
        assert_eq!(corner(&[]), pos2(left, bottom));
        assert_eq!(corner(&[pos2(100.0, 550.0)]), pos2(right, top));
        assert_eq!(corner(&[pos2(700.0, 100.0)]), pos2(left, bottom));
        assert_eq!(corner(&[pos2(100.0, 550.0), pos2(700.0, 60.0), pos2(120.0, 80.0)]), pos2(right, bottom));
        let label = Rect::from_center_size(pos2(700.0, 550.0), vec2(40.0, 12.0));
        let beside = freest_corner(&[room], size, &[label], &[pos2(100.0, 60.0)]);
        assert_eq!(beside, pos2(right, top), "not on the label in the farthest corner");
    }
}
