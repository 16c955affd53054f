//! The author's labels and notes in a picture: the `[labels]` of a figure.

use glam::{DVec2, DVec3};

use crate::appearance::Rgba;
use crate::drawing::{Drawing, Label, single};
use crate::figure::labels::{is_in_legend, note_name};
use crate::figure::{Note, NotePlace};
use crate::limits::MAX_LABEL_MOVE;

use super::label_layout::{half_size, middle};
use crate::views::canonical::canonical_box::shown_at;
use crate::views::screen::Screen;
use crate::views::world::gizmos::SMALL_TYPE;
use crate::views::{Palette, Request, SharedScene};

pub(in crate::views) fn extent(request: &Request) -> DVec2 {
    DVec2::new(f64::from(request.size.width), f64::from(request.size.height))
}

/// Adds the notes of a picture, in a drawing that begins at `corner` of it. A note about something outside the picture
/// is left out.
pub(in crate::views) fn add_notes(drawing: &mut Drawing, request: &Request, corner: DVec2, screen: Option<&Screen>) {
    let notes = &request.shot.labels.notes;
    if notes.is_empty() || request.finish.bare {
        return;
    }
    let palette = Palette::of(request.shot.look.style.theme);
    let place = |p| screen?.place_inside(shown_at(request, p)?);
    let seen = notes.iter().enumerate().filter(|(_, note)| note.view.is_none_or(|view| view == request.view));
    for (i, note) in seen {
        let at = match &note.at {
            NotePlace::Picture(p) => Some(DVec2::new(p.x, 1.0 - p.y) * extent(request)),
            _ => world_point(note, &request.scene).and_then(place),
        };
        let Some(at) = at.map(|at| at - corner) else { continue };
        let size = (SMALL_TYPE * request.size.scale).max(request.least_letters());
        // A text at a place of the picture stands there, others beside their subject.
        let offset = if matches!(note.at, NotePlace::Picture(_)) { [0.0; 2] } else { [0.6 * size, -0.6 * size] };
        drawing.labels.push(Label {
            name: note_name(i),
            offset,
            ..Label::new([single(at.x), single(at.y), 1.0], String::new(), size, [palette.ink, drawing.background])
        });
    }
}

/// The place of a label in a picture, in its pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelPlace {
    /// The name with which an author changes it.
    pub name: String,
    /// The text there.
    pub text: String,
    /// The point that it names.
    pub point: DVec2,
    /// The middle of its text.
    pub center: DVec2,
    /// Half its width and height.
    pub half: DVec2,
    /// Height of its type.
    pub em: f64,
    /// The colour of its letters.
    pub color: Rgba,
}

impl LabelPlace {
    /// The labels of a drawing that have names, as they're laid out.
    pub fn all(drawing: &Drawing) -> Vec<Self> {
        let named = drawing.labels.iter().filter(|label| !label.name.is_empty());
        named.map(Self::of).collect()
    }

    fn of(label: &Label) -> Self {
        let [x, y, _] = label.position;
        let point = DVec2::new(f64::from(x), f64::from(y));
        let center = middle(label);
        // A legend moves as a whole, so only the distance of its lines from their places counts.
        let offset = DVec2::new(f64::from(label.offset[0]), f64::from(label.offset[1]));
        Self {
            name: label.name.clone(),
            text: label.text.clone(),
            point: if is_in_legend(&label.name) { center - offset } else { point },
            center,
            half: half_size(label),
            em: f64::from(label.size),
            color: label.color,
        }
    }

    /// The place in the coordinates of a picture in which its own picture begins at a column.
    pub fn shifted(self, column: f64) -> Self {
        let by = DVec2::X * column;
        Self { point: self.point + by, center: self.center + by, ..self }
    }

    /// True if a place (pixels) is on its text.
    pub fn holds(&self, place: DVec2) -> bool {
        (place - self.center).abs().cmple(self.half).all()
    }

    /// The offset that puts the middle of its text at a place (pixels), like
    /// [`MovedLabel::by`](crate::figure::MovedLabel::by).
    pub fn moved_to(&self, center: DVec2) -> DVec2 {
        let by = (center - self.point) / self.em.max(1e-9) * DVec2::new(1.0, -1.0);
        // Hundredths are fine enough for the eye, and short in a file.
        ((by * 100.0).round() / 100.0).clamp(DVec2::splat(-MAX_LABEL_MOVE), DVec2::splat(MAX_LABEL_MOVE))
    }
}

/// The point of the world of a note; `None` for a place of the picture, or if its object or the part of it doesn't
/// exist.
fn world_point(note: &Note, scene: &SharedScene) -> Option<DVec3> {
    let of_object = |name: &str| scene.objects.iter().find(|object| object.name == name);
    match &note.at {
        NotePlace::World(p) => Some(*p),
        NotePlace::Picture(_) => None,
        NotePlace::Vertex { object, vertex } => {
            let object = of_object(object)?;
            Some(object.world_from_object.transform_point3(*object.mesh.positions.get(*vertex as usize)?))
        }
        NotePlace::Edge { object, edge } => {
            let object = of_object(object)?;
            let [a, b] = *object.mesh.edges.get(*edge as usize)?;
            let [a, b] = [object.mesh.positions.get(a as usize)?, object.mesh.positions.get(b as usize)?];
            Some(object.world_from_object.transform_point3(a.lerp(*b, 0.5)))
        }
    }
}
