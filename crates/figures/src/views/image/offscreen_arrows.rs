//! Points beside the image, or behind the eye. An arrow at the border of the image shows the direction to each of them.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, LineStyle};
use crate::camera::{Camera, Projection};
use crate::drawing::{Anchor, Drawing, Label, StrokeSet, single};
use crate::sanitize;

use crate::views::reveal::probe;
use crate::views::world::gizmos::{SMALL_TYPE, stroke};
use crate::views::{Palette, Request};

/// Length of an arrow, and its distance from the border, in pixels at scale 1.
const LENGTH: f64 = 22.0;
const MARGIN: f64 = 3.0;

/// The direction (pixels, y down) from the middle of a picture of this size to a point outside it, and true if it's
/// behind the eye. In that case it's the direction in which the camera would have to turn. `None` for a point in the
/// picture, even if it's cut off by F or B.
fn direction(camera: &Camera, size: DVec2, p: DVec3) -> Option<(DVec2, bool)> {
    let (view, clip) = (camera.view_point(p), camera.clip_point(p));
    if camera.projection() == Projection::Perspective && view.z >= 0.0 {
        let aside = DVec2::new(view.x, -view.y);
        // Straight behind the eye, any direction is as good as another.
        let seen = aside.length() > 1e-9 * view.z;
        return Some((if seen { aside } else { DVec2::Y }, true));
    }
    let ndc = clip.truncate().truncate() / clip.w;
    let beside = ndc.abs().max_element() > 1.0;
    (ndc.is_finite() && beside).then(|| (ndc * DVec2::new(0.5, -0.5) * size, false))
}

/// The direction may be of any length.
fn unit(direction: DVec2) -> DVec2 {
    (direction / direction.abs().max_element()).normalize_or(DVec2::Y)
}

/// The point where the line from the middle of a picture in a direction leaves it, `MARGIN` before.
fn border(size: DVec2, direction: DVec2, scale: f64) -> DVec2 {
    let half = size / 2.0 - MARGIN * scale;
    let unit = unit(direction);
    size / 2.0 + unit * (half / unit.abs().max(DVec2::splat(1e-12))).min_element()
}

/// Adds the arrows and the names. Arrows to points behind the eye are dashed, and marked as such.
pub(in crate::views) fn in_image(drawing: &mut Drawing, request: &Request, palette: Palette) {
    let size = DVec2::new(f64::from(drawing.width), f64::from(drawing.height));
    let scale = f64::from(request.size.scale);
    for (p, look) in probe::points(request, palette) {
        let Some((direction, behind)) = direction(&request.camera, size, p) else { continue };
        let tip = border(size, direction, scale);
        let tail = tip - unit(direction) * (LENGTH * scale);
        let dash = if behind { Dash::Dashed } else { Dash::Solid };
        let style = stroke(look.color, 2.0 * request.size.scale, dash, HiddenLines::Shown);
        let ends = [tail, tip].map(|p| [single(p.x), single(p.y), 1.0]);
        drawing.strokes.push(StrokeSet::line(ends.to_vec(), LineStyle { arrow: true, ..style }));
        let name = if look.name.is_empty() { String::new() } else { sanitize::escaped(look.name) };
        let where_it_is = match request.camera.view_point(p) {
            DVec3::ZERO => request.labels.in_eye,
            view if view.z == 0.0 => request.labels.in_eye_plane,
            _ => request.labels.behind_eye,
        };
        let text = match (behind, name.is_empty()) {
            (false, _) => name,
            (true, true) => where_it_is.to_owned(),
            (true, false) => format!("{name}: {where_it_is}"),
        };
        if text.is_empty() {
            continue;
        }
        let type_size = (SMALL_TYPE * request.size.scale).max(request.least_letters());
        let inwards = (tail - tip).normalize_or(DVec2::NEG_Y) * f64::from(0.7 * type_size);
        drawing.labels.push(Label {
            name: if look.name.is_empty() { "behind-eye".to_owned() } else { sanitize::escaped(look.name) },
            offset: [single(inwards.x), single(inwards.y)],
            anchor: if inwards.x < 0.0 { Anchor::Right } else { Anchor::Left },
            ..Label::new([single(tail.x), single(tail.y), 1.0], text, type_size, [look.color, palette.paper])
        });
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::Parameters;
    use crate::figure::{Figure, NamedPoint};
    use crate::views::timed_pipeline::TimedPipeline;
    use crate::views::{Labels, SharedScene, Size, View, frame};

    /// From (0, 0, 5) towards the origin: x to the right, y upwards.
    fn ahead(projection: Projection) -> Camera {
        let position = DVec3::new(0.0, 0.0, 5.0);
        Camera::new(&Parameters { position, aspect: 1.0, projection, ..Parameters::default() }).unwrap()
    }

    #[test]
    fn arrows_point_to_objects_beside_the_image_and_behind_the_eye() {
        let size = DVec2::new(200.0, 100.0);
        for (p, expected) in [
            (DVec3::ZERO, None),
            (DVec3::new(50.0, 0.0, 0.0), Some((DVec2::X, false))),
            (DVec3::new(0.0, 50.0, 0.0), Some((DVec2::NEG_Y, false))),
            // Behind the eye, to the left. The division would place it to the right.
            (DVec3::new(-3.0, 0.0, 8.0), Some((DVec2::NEG_X, true))),
            (DVec3::new(0.0, 0.0, 8.0), Some((DVec2::Y, true))),
        ] {
            let found = direction(&ahead(Projection::Perspective), size, p);
            let found = found.map(|(direction, behind)| (direction.normalize(), behind));
            match (found, expected) {
                (None, None) => {}
                (Some((a, is_behind)), Some((b, behind))) => {
                    assert!(a.distance(b) < 1e-9 && is_behind == behind, "{p}: {a} {is_behind}");
                }
                _ => panic!("{p}: {found:?}"),
            }
        }
        // Parallel projectors have no eye.
        assert_eq!(direction(&ahead(Projection::Parallel), size, DVec3::new(0.0, 0.0, 8.0)), None);
        assert_eq!(border(size, DVec2::new(1e300, 0.0), 1.0), DVec2::new(197.0, 50.0));
        assert_eq!(border(size, DVec2::new(0.0, -1e-300), 1.0), DVec2::new(100.0, 3.0));
    }

    #[test]
    fn the_image_names_them_at_its_border() {
        let named = |name: &str, position| NamedPoint { name: name.to_owned(), position };
        let points = vec![
            named("A", DVec3::new(50.0, 0.0, 0.0)),
            named("B", DVec3::ZERO),
            named("C'", DVec3::new(-3.0, 1.0, 8.0)),
            named("D", DVec3::new(-3.0, 1.0, 5.0)),
            named("E", DVec3::new(0.0, 0.0, 5.0)),
        ];
        let figure = Figure { points, ..Figure::default() };
        let size = Size { width: 300, height: 300, scale: 1.0 };
        let camera = ahead(Projection::Perspective);
        let labels: &'static Labels = Box::leak(Box::new(Labels {
            behind_eye: "behind the eye",
            in_eye_plane: "in its plane",
            in_eye: "there",
            ..Labels::default()
        }));
        let request = Request::of(&figure, View::Image, &camera, &SharedScene::default(), labels, size);
        let drawing = frame(&request, None, &mut TimedPipeline::default()).drawing;
        let mut texts: Vec<&str> = drawing.labels.iter().map(|label| label.text.as_str()).collect();
        texts.sort_unstable();
        assert_eq!(texts, ["A", "B", "C': behind the eye", "D: in its plane", "E: there"]);
        assert_eq!(drawing.strokes.iter().filter(|set| set.style.arrow).count(), 4);
    }
}
