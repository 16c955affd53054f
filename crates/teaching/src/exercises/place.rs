//! `place` of a question: the point to mark in the image, computed from a name or from coordinates in any space.

use glam::{DVec3, DVec4};

use super::exercise::{Ask, Kind, Unit};
use super::mistakes::slip::Slips;
use super::subject::Subject;
use super::value::Table;
use crate::camera::{Camera, Convention, Place, Viewport};
use crate::figure::error::Allowed;
use crate::figure::read::Section;
use crate::figure::value::{PIXEL_OF_IMAGE, TEXT, VECTOR};
use crate::figure::variation::varied_by;
use crate::scene::ObjectPoint;

/// The ways to give a point in a table. Each is the key of its value.
const WAYS: [&str; 5] = ["object", "view", "ndc", "clip", "pixel"];

/// An ask for the place of a point in the image of a subject. `told` is the subject that the question describes, in
/// whose spaces it gives coordinates: the figure before `see`. `None`, and a fault, if the image doesn't have the
/// point.
pub(super) fn asked(section: &mut Section<'_>, name: &str, told: &Subject, subject: &Subject) -> Option<Ask> {
    for key in ["quantity", "answer"] {
        if section.is_present(key) {
            section.refuse(key, Allowed::Either("place", "quantity, answer"));
        }
        section.skip(key);
    }
    let table = in_image(section, told, subject)?;
    let image = subject.figure.image;
    let sides = [image.width, image.height].map(f64::from);
    let ask =
        Ask::computed(name, Kind::Vector(2), Vec::new(), move |slips| (slips == Slips::NONE).then(|| table.clone()));
    // A twentieth of the image is accurate enough for the eye.
    let tolerance = (sides[0].min(sides[1]) / 20.0).round().max(1.0);
    Some(Ask { places: true, unit: Unit::Pixels, tolerance, share: f64::INFINITY, ..ask })
}

/// The place of an expected mistake: of another point, or with `see`, in the image after other operations and
/// values of keys than those of the question. An empty list is the image before them. `None`, and a fault, if that
/// image doesn't have the point.
pub(super) fn mistaken(section: &mut Section<'_>, told: &Subject, subject: &Subject) -> Option<Table> {
    if !section.is_present("see") {
        return in_image(section, told, subject);
    }
    let changes = section.list("see", Allowed::Ways, way);
    let changes: Vec<(&str, &str)> = changes.iter().map(|(key, value)| (&**key, &**value)).collect();
    let camera = Camera::new(&told.figure.camera).ok()?;
    let Ok(seen) = varied_by(&told.figure, &camera, &changes, Convention::RightHand) else {
        section.refuse("see", Allowed::Ways);
        return None;
    };
    in_image(section, told, &Subject { figure: seen.figure, ..told.clone() })
}

/// `key=value`.
pub(crate) fn way(text: &str) -> Option<(String, String)> {
    let (key, value) = text.split_once('=')?;
    Some((key.trim().to_owned(), value.trim().to_owned()))
}

/// The place in the image of a subject; `None`, and a fault, if the image doesn't have it.
fn in_image(section: &mut Section<'_>, told: &Subject, subject: &Subject) -> Option<Table> {
    let before = section.faults.len();
    let place = place(section, told, subject);
    let image = subject.figure.image;
    let sides = [image.width, image.height].map(f64::from);
    let is_inside = |place: &[f64; 2]| place.iter().zip(sides).all(|(at, side)| (0.0..=side).contains(at));
    let inside = place.filter(is_inside);
    if inside.is_none() && section.faults.len() == before {
        section.refuse("place", Allowed::PointInImage);
    }
    inside.map(|place| Table { rows: 2, columns: 1, entries: place.to_vec() })
}

/// The place in pixels from the left edge and from the upper one.
fn place(section: &mut Section<'_>, told: &Subject, subject: &Subject) -> Option<[f64; 2]> {
    if section.is_list("place") {
        return subject.place(section.get("place", &VECTOR).unwrap_or_default());
    }
    if section.is_text("place") {
        let name = section.get("place", &TEXT)?;
        return subject.place(subject.figure.points.iter().find(|point| point.name == name)?.position);
    }
    let label = section.name_of("place");
    let mut table = section.section("place", &format!("{label}."));
    let mut ways = WAYS.into_iter().filter(|way| table.is_present(way));
    let way = ways.next().filter(|_| ways.next().is_none());
    let place = way.and_then(|way| match way {
        "object" => subject.place(of_object(&mut table, subject)?),
        // The centre of the pixel, whatever the camera is.
        "pixel" => table.get("pixel", &PIXEL_OF_IMAGE).map(|pixel| pixel.map(|k| f64::from(k) + 0.5)),
        way => subject.place(in_space(&mut table, way, told)?),
    });
    WAYS.into_iter().chain(["vertex"]).for_each(|key| table.skip(key));
    section.faults.extend(table.finish());
    place
}

/// The point of an object in the figure that shows the answer.
fn of_object(table: &mut Section<'_>, subject: &Subject) -> Option<DVec3> {
    table.require("vertex", Allowed::ObjectPoint);
    let (object, vertex) = (table.get("object", &TEXT)?, table.get("vertex", &TEXT)?);
    let point = vertex.parse().ok().and_then(|point: ObjectPoint| point.in_world(&subject.figure.scene, &object));
    if point.is_none() {
        table.refuse("vertex", Allowed::ObjectPoint);
    }
    point
}

/// The world point with these coordinates in a space of the figure that the question describes.
fn in_space(table: &mut Section<'_>, space: &str, told: &Subject) -> Option<DVec3> {
    let place = match space {
        "view" => Place::View(table.get("view", &VECTOR).unwrap_or_default()),
        "ndc" => Place::Ndc(table.get("ndc", &VECTOR).unwrap_or_default()),
        _ => {
            let numbers = table.rows("clip", false)?.concat();
            let clip = DVec4::from_array(numbers.try_into().ok()?);
            // Behind the eye and in its plane nothing has an image.
            Place::Ndc(Some(clip).filter(|clip| clip.w > 0.0)?.truncate() / clip.w)
        }
    };
    let image = told.figure.image;
    told.camera().ok()?.notes_clip_space().world_of(image, &Viewport::whole(image), place).ok()
}
