//! A picture in two ways: the request of each side, and the line and the words over both.

use glam::DVec2;

use super::{Compared, LabelPlace, Labels, Palette, Probe, Request, Shot, Size};
use crate::appearance::{HiddenLines, LineStyle, Rgba};
use crate::drawing::{Anchor, Area, Drawing, Label, StrokeSet, single};
use crate::sanitize;
use crate::views::reveal::probe::projector;
use crate::views::words::label_layout::Author;
use crate::views::words::label_obstacles::Box2;
use crate::views::words::values::{done, said};
use crate::views::world::gizmos::SMALL_TYPE;

/// Space between two halves, in pixels at scale 1.
const GAP: f32 = 4.0;
/// The names of the headings of the sides, with which an author changes them.
const SIDES: [&str; 2] = ["side:1", "side:2"];
/// The longest heading in characters.
const LONGEST: usize = 60;

/// The heading of a side, 0 or 1.
fn heading(compared: &Compared, side: usize, labels: &Labels) -> String {
    if compared.comparison.is_of_camera() {
        return [labels.this_camera, labels.other_camera][side].to_owned();
    }
    if compared.comparison.camera.is_some() {
        let name = compared.values.first().and_then(|(_, names)| names[side].clone());
        return sanitize::within(name.as_deref().unwrap_or(labels.this_camera), LONGEST);
    }
    let mut parts: Vec<String> =
        compared.values.iter().map(|(key, values)| said(key, values[side].as_deref(), labels)).collect();
    match (compared.comparison.ops.is_empty(), side) {
        (true, _) => {}
        (false, 0) => parts.push(labels.before.to_owned()),
        (false, _) => parts.extend(compared.comparison.ops.iter().map(|operation| done(*operation, labels))),
    }
    sanitize::within(&parts.join(", "), LONGEST)
}

/// A side of a compared picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// The picture, in which nothing is compared.
    pub request: Request,
    /// The column of the whole picture in which this one begins.
    pub left: u32,
    /// The columns of the whole picture that show this one.
    pub columns: std::ops::Range<u32>,
}

impl Request {
    /// The sides of a picture: the figure as it is, and the other way, seen by one observer. `None` if nothing is
    /// compared.
    pub fn sides(&self) -> Option<[Side; 2]> {
        let compared = self.shot.compared.as_ref()?;
        let requests = self.each_side();
        let [own, other] = <[Self; 2]>::try_from(requests).ok()?;
        let observer = self.seen_from();
        let width = self.size.width;
        let [lefts, columns] = if compared.comparison.beside {
            let second = width - other.size.width;
            [[0, second], [own.size.width, second]]
        } else {
            #[expect(clippy::cast_possible_truncation, reason = "a share of the width")]
            let at = (f64::from(width) * compared.comparison.wiper.clamp(0.0, 1.0)).round() as u32;
            [[0, 0], [at, at]]
        };
        let side = |request: Self, left, columns| Side { request: request.seen_by(observer), left, columns };
        Some([side(own, lefts[0], 0..columns[0]), side(other, lefts[1], columns[1]..width)])
    }

    /// The side of a compared picture at a column; `None` if nothing is compared.
    pub fn side_at(&self, x: f64) -> Option<Side> {
        let [own, other] = self.sides()?;
        Some(if x < f64::from(other.columns.start) { own } else { other })
    }

    /// Its sides with their sizes, which don't share one observer yet. The request itself if nothing is compared.
    pub(super) fn each_side(&self) -> Vec<Self> {
        let Some(compared) = &self.shot.compared else { return vec![self.clone()] };
        let size = if compared.comparison.beside { half(self.size) } else { self.size };
        let alone = Shot { compared: None, ..Shot::clone(&self.shot) };
        let own = Self { shot: alone.into(), size, ..self.clone() };
        let other = Self {
            shot: compared.shot.clone().into(),
            camera: compared.camera.as_ref().unwrap_or(&self.camera).clone(),
            ..own.clone()
        };
        let other = if compared.comparison.camera.is_some() { projected(other, &own) } else { other };
        vec![own, other]
    }
}

/// The image of another camera, in which a pixel of the first one is the line of its projector.
fn projected(mut other: Request, own: &Request) -> Request {
    other.projector = Some(own.probe().map(|probe| projector(own, probe)));
    if matches!(own.probe(), Some(Probe::Window(_))) {
        // A place on the window of one camera isn't one on that of the other.
        other.hover.probe = None;
        let mut shot = Shot::clone(&other.shot);
        shot.show.probe = None;
        other.shot = shot.into();
    }
    other
}

/// The size of one of two halves.
fn half(size: Size) -> Size {
    #[expect(clippy::cast_possible_truncation, reason = "a small positive number")]
    let gap = (GAP * size.scale).round().clamp(1.0, 100.0) as u32;
    Size { width: size.width.saturating_sub(gap) / 2, ..size }
}

/// The line between the sides, a heading on each, and the number of differing pixels, on a clear background. `labels`
/// are those of the sides, which a heading doesn't cover as long as there's another corner.
pub fn overlay(
    request: &Request,
    [own, other]: &[Side; 2],
    labels: &[LabelPlace],
    differ: Option<f64>,
) -> Option<Drawing> {
    let compared = request.shot.compared.as_ref()?;
    let Size { width, height, scale } = request.size;
    let palette = Palette::of(request.shot.look.style.theme);
    let mut drawing = on_clear_ground([width, height], palette.paper);
    let [wide, high] = [width, height].map(|side| side as f32);
    let [left, right] = [own.columns.end, other.columns.start].map(|column| column as f32);
    let beside = compared.comparison.beside;
    if beside {
        let size = [right - left, high];
        drawing.areas.push(Area { corner: [left, 0.0], size, radius: 0.0, fill: palette.surround });
    } else {
        for (color, stroke) in [(palette.paper, 3.0), (palette.ink, 1.2)] {
            let style = LineStyle::solid(color, stroke * scale, HiddenLines::Shown);
            drawing.strokes.push(StrokeSet::line(vec![[left, 0.0, 1.0], [left, high, 1.0]], style));
        }
    }
    if request.finish.bare {
        return Some(drawing);
    }
    let em = (SMALL_TYPE * scale).max(request.least_letters());
    let author = Author::of(request, palette);
    let label = |name: &str, text: &str, (x, anchor): (f32, Anchor), y: f32| {
        let label = Label::new([x, y, 1.0], text.to_owned(), em, [palette.ink, palette.paper]);
        Label { name: name.to_owned(), anchor, ..label }
    };
    let (top, bottom) = (1.2 * em, high - 1.2 * em);
    for (side, room) in [[0.0, left], [right, wide]].into_iter().enumerate() {
        let text = heading(compared, side, request.labels);
        let mut across = vec![(room[0] + em, Anchor::Left), (room[1] - em, Anchor::Right)];
        if beside {
            across.insert(0, ((room[0] + room[1]) / 2.0, Anchor::Center));
        } else if side == 0 {
            // Near the line.
            across.reverse();
        }
        let places = [top, bottom].into_iter().flat_map(|y| across.iter().map(move |x| (*x, y)));
        let places = places.map(|(x, y)| label(SIDES[side], &text, x, y)).collect();
        plate(&mut drawing, places, labels, room, (&author, request));
    }
    if let Some(share) = differ {
        let text = format!("{}: {} %", request.labels.differ, request.labels.mark.number(100.0 * share, 3));
        let place = label("differ", &text, (wide - em, Anchor::Right), bottom);
        plate(&mut drawing, vec![place], labels, [0.0, wide], (&author, request));
    }
    Some(drawing)
}

/// An empty drawing on a clear background of a colour, to put over others.
pub(super) fn on_clear_ground([width, height]: [u32; 2], ground: Rgba) -> Drawing {
    Drawing { painted_in_order: true, ..Drawing::new(width, height, ground.with_alpha(0)) }
}

/// A text on a plate with its author's changes, if its range of columns has space for it: at the first of its places
/// that covers no label, or else the least of them. At a place that the author chose, it needs no space.
fn plate(
    drawing: &mut Drawing,
    places: Vec<Label>,
    labels: &[LabelPlace],
    room: [f32; 2],
    (author, request): (&Author<'_>, &Request),
) {
    let page = Author::page(request, DVec2::ZERO);
    let finished = places.into_iter().filter_map(|label| author.finished(label, &page));
    let covered = |place: &Box2| {
        // With the border of the plate.
        let own = |label: &LabelPlace| Box2 { center: label.center, half: label.half + DVec2::splat(0.5 * label.em) };
        labels.iter().map(|label| place.overlap(&own(label))).sum::<f64>()
    };
    let best = finished.min_by(|(_, a), (_, b)| covered(a).total_cmp(&covered(b)));
    let Some((label, place)) = best else { return };
    let is_moved = author.labels.change(&label.name, author.view).by.is_some();
    let [middle, y, half_width, half_height] = [place.center.x, place.center.y, place.half.x, place.half.y].map(single);
    let pad = 0.35 * label.size;
    let corner = [middle - half_width - pad, y - half_height - pad];
    if label.text.is_empty() || !is_moved && (corner[0] < room[0] || middle + half_width + pad > room[1]) {
        return;
    }
    let size = [2.0 * (half_width + pad), 2.0 * (half_height + pad)];
    drawing.areas.push(Area { corner, size, radius: pad, fill: Rgba { a: 235, ..label.halo } });
    drawing.labels.push(label);
}
