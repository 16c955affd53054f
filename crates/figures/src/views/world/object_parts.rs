//! Measures of the parts of an object's own transform in the world: the arrow of its translation, axis and arc of a
//! rotation, the length of a local axis.

use glam::{DMat4, DQuat, DVec2, DVec3};

use crate::appearance::{Dash, MarkShape};
use crate::geometry::Angle;

use super::components::{component, lettered};
use super::dimensions::Pen;
use super::gizmos::{AnnotationBuilder, SMALL_TYPE};
use crate::figure::Measured;
use crate::views::{ObjectTransform, Palette, Request};

/// The radius of an arc, in pixels at scale 1.
const RADIUS: f64 = 46.0;

/// Draws the measures of the explained object in the panel's hover.
pub(in crate::views) fn in_world(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    let Some(object) = request.measured_object() else { return };
    let pen = Pen { color: palette.probe, width: 2.0 };
    for measured in request.measured() {
        match measured {
            Measured::Translate(i) => translation(builder, request, object, i, pen),
            Measured::Rotate(i) => rotation(builder, request, object, i, pen),
            Measured::Scale(i) => scale(builder, request, object, i, pen),
            _ => {}
        }
    }
}

fn written(request: &Request, symbol: char, i: usize, value: f64, unit: &str) -> String {
    format!("{symbol}_{} = {}{unit}", ["x", "y", "z"][i], request.labels.mark.number(value + 0.0, 4))
}

/// From the origin of the parent's frame, which is the world's if there's no parent, to that of the object.
fn translation(builder: &mut AnnotationBuilder, request: &Request, object: ObjectTransform, i: usize, pen: Pen) {
    let ObjectTransform { world_from_parent, trs } = object;
    let origin = world_from_parent.transform_point3(DVec3::ZERO);
    let of = |v: DVec3| world_from_parent.transform_vector3(v);
    let text = written(request, 't', i, trs.translate[i], "");
    component(builder, origin, [of(trs.translate), of(DVec3::AXES[i] * trs.translate[i])], &text, pen);
}

/// The first angle rotates about the x axis as the other rotations leave it, the second about the y axis as the third
/// leaves it: R = `R_z` `R_y` `R_x`.
fn axis_of_rotation(rotate: DVec3, i: usize) -> DQuat {
    let about = |k: usize| DQuat::from_axis_angle(DVec3::AXES[k], Angle::from_degrees(rotate[k]).radians());
    ((i + 1)..3).rev().fold(DQuat::IDENTITY, |turned, k| turned * about(k))
}

/// The line through its origin about which the object is rotated, and the arc of the angle, which begins at the next
/// axis.
fn rotation(builder: &mut AnnotationBuilder, request: &Request, object: ObjectTransform, i: usize, pen: Pen) {
    /// Angle between two points of an arc, in degrees.
    const STEP: f64 = 5.0;
    let ObjectTransform { world_from_parent, trs } = object;
    let frame = world_from_parent * DMat4::from_translation(trs.translate);
    let origin = frame.transform_point3(DVec3::ZERO);
    let turned = axis_of_rotation(trs.rotate, i);
    let along = |v: DVec3| frame.transform_vector3(turned * v);
    let (axis, from) = (DVec3::AXES[i], DVec3::AXES[(i + 1) % 3]);
    // The parent may scale, so the arc belongs to its frame too.
    let pixels = RADIUS * builder.screen.scale * builder.screen.units_per_pixel(origin);
    let (Some(radius), Some(reach)) = (share(pixels, along(from)), share(1.6 * pixels, along(axis))) else { return };
    builder.line(vec![origin - along(axis) * reach, origin + along(axis) * reach], pen.color, pen.width, Dash::DashDot);
    let angle = trs.rotate[i].clamp(-360.0, 360.0);
    let at = |degrees: f64| {
        let by = DQuat::from_axis_angle(axis, Angle::from_degrees(degrees).radians());
        origin + along(by * from) * radius
    };
    builder.line(vec![origin, at(0.0)], pen.color, 0.6 * pen.width, Dash::Solid);
    builder.line(vec![origin, at(angle)], pen.color, 0.6 * pen.width, Dash::Solid);
    #[expect(clippy::cast_possible_truncation, reason = "1 … 72")]
    let count = (angle.abs() / STEP).ceil().max(1.0) as u32;
    if angle != 0.0 {
        let points = (0..=count).map(|k| at(angle * f64::from(k) / f64::from(count))).collect();
        builder.arrow(points, pen.color, 1.3 * pen.width, Dash::Solid);
    }
    let middle = at(0.5 * angle);
    let toward = builder.screen.heading(middle, middle - origin);
    let text = written(request, 'φ', i, trs.rotate[i], "°");
    builder.text(middle, &text, if toward == DVec2::ZERO { DVec2::X } else { toward }, SMALL_TYPE, pen.color);
}

/// The factor that gives a vector a length; `None` for a vector without one.
fn share(length: f64, vector: DVec3) -> Option<f64> {
    let share = length / vector.length();
    share.is_finite().then_some(share)
}

/// A local axis as long as the scale makes it, with a mark at its end before scaling.
fn scale(builder: &mut AnnotationBuilder, request: &Request, object: ObjectTransform, i: usize, pen: Pen) {
    let ObjectTransform { world_from_parent, trs } = object;
    let frame = world_from_parent * DMat4::from_translation(trs.translate);
    let origin = frame.transform_point3(DVec3::ZERO);
    let axis = frame.transform_vector3(axis_of_rotation(trs.rotate, 0) * turned_by_x(trs.rotate, i));
    let tip = origin + axis * trs.scale[i];
    builder.arrow(vec![origin, tip], pen.color, pen.width, Dash::Solid);
    lettered(builder, [origin, tip], &written(request, 's', i, trs.scale[i], ""), pen);
    builder.line(vec![origin, origin + axis], pen.color, 0.8 * pen.width, Dash::Dotted);
    builder.mark_above(origin + axis, MarkShape::Ring, 4.0, pen.color);
}

/// A local axis after the first of the rotations, `R_x`.
fn turned_by_x(rotate: DVec3, i: usize) -> DVec3 {
    DQuat::from_axis_angle(DVec3::X, Angle::from_degrees(rotate.x).radians()) * DVec3::AXES[i]
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{Camera, Parameters};
    use crate::drawing::Drawing;
    use crate::figure::{Figure, Observer};
    use crate::scene::transform::Trs;
    use crate::views::timed_pipeline::TimedPipeline;
    use crate::views::{Hover, SharedScene, Size, View, frame, unlabelled};

    fn drawn(measured: Vec<Measured>, object: ObjectTransform) -> Drawing {
        let (figure, camera) = (Figure::default(), Camera::new(&Parameters::default()).unwrap());
        let size = Size { width: 600, height: 400, scale: 1.0 };
        let observer = Observer {
            target: DVec3::ZERO,
            distance: 30.0,
            azimuth: 40.0,
            elevation: 25.0,
            roll: 0.0,
            parallel: false,
        };
        let request = Request {
            hover: Hover { measured, object: Some(object), ..Hover::default() },
            ..Request::of(&figure, View::World, &camera, &SharedScene::default(), unlabelled(), size)
        }
        .seen_by(Some(observer));
        frame(&request, None, &mut TimedPipeline::default()).drawing
    }

    #[test]
    fn each_part_says_its_symbol_and_number() {
        let trs = Trs {
            translate: DVec3::new(1.0, -2.0, 0.5),
            rotate: DVec3::new(30.0, 0.0, -400.0),
            scale: DVec3::new(2.0, 1.0, 0.25),
        };
        let object = ObjectTransform { world_from_parent: DMat4::from_translation(DVec3::Y), trs };
        let plain = drawn(Vec::new(), object);
        let said = |drawing: &Drawing, text: &str| drawing.labels.iter().any(|label| label.text == text);
        for (measured, text) in [
            (Measured::Translate(1), "t_y = −2"),
            (Measured::Rotate(0), "φ_x = 30°"),
            (Measured::Rotate(1), "φ_y = 0°"),
            (Measured::Rotate(2), "φ_z = −400°"),
            (Measured::Scale(0), "s_x = 2"),
            (Measured::Scale(2), "s_z = 0.25"),
        ] {
            let shown = drawn(vec![measured], object);
            assert!(said(&shown, text) && !said(&plain, text), "{text}");
            assert!(shown.strokes.len() > plain.strokes.len(), "{text}");
        }
    }

    /// The axes about which the parts rotate, compared with the product.
    #[test]
    fn rotations_turn_about_the_axes_that_later_ones_have_turned() {
        let rotate = DVec3::new(20.0, -50.0, 110.0);
        let [x, y, z] = rotate.to_array().map(f64::to_radians);
        let [rx, ry, rz] = [DQuat::from_rotation_x(x), DQuat::from_rotation_y(y), DQuat::from_rotation_z(z)];
        // Applied from last to first, each about its axis, they make the whole rotation.
        let whole = (0..3).fold(DQuat::IDENTITY, |done, i| {
            let axis = axis_of_rotation(rotate, i) * DVec3::AXES[i];
            done * DQuat::from_axis_angle(axis, rotate[i].to_radians())
        });
        assert!(whole.abs_diff_eq(rz * ry * rx, 1e-12) || whole.abs_diff_eq(-(rz * ry * rx), 1e-12));
        for i in 0..3 {
            let column = axis_of_rotation(rotate, 0) * turned_by_x(rotate, i);
            assert!(column.abs_diff_eq(rz * ry * rx * DVec3::AXES[i], 1e-12));
        }
    }
}
