//! Operations that a figure shows, and the one that the user is trying: axis and pivot, the way of the moved points,
//! and the camera before.

use glam::{DQuat, DVec2, DVec3};

use crate::appearance::{Dash, MarkShape, Rgba, Role};
use crate::camera::{Camera, Operation};
use crate::geometry::Ray;

use super::camera_gizmo::GizmoSizes;
use super::gizmos::{AnnotationBuilder, SMALL_TYPE, TYPE};
use crate::views::{Ghost, Palette, Request};

/// Adds the operations that the figure shows, the one that the user is trying, and the camera that an answer describes.
pub(in crate::views) fn in_world(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    gear: GizmoSizes,
) {
    if let Some(answered) = &request.shot.answered {
        camera_answered(builder, request, palette, gear, answered);
    }
    let led = request.operations();
    for (k, (ghost, after)) in led.iter().enumerate() {
        // The camera before the first operation has a name, and those between have numbers.
        let name = if k == 0 { request.labels.before.to_owned() } else { k.to_string() };
        camera_before(builder, palette, gear, (&ghost.before, after), &name);
        let middle = path(builder, palette, gear, ghost, after);
        let text = request.operation_text(k, led.len(), ghost.operation);
        let outwards = builder.screen.heading(after.focal_point(), middle - after.focal_point());
        builder.named(ghost.operation.name(), middle, &text, outwards, SMALL_TYPE, palette.probe);
    }
    if let Some(ghost) = &request.hover.ghost {
        camera_before(builder, palette, gear, (&ghost.before, &request.camera), request.labels.before);
        path(builder, palette, gear, ghost, &request.camera);
    }
}

/// The way of an operation to the camera after it: axis, pivot and arc of a rotation, the arrows of a move, the former
/// window of a zoom. Returns a place in its middle.
fn path(builder: &mut AnnotationBuilder, palette: Palette, gear: GizmoSizes, ghost: &Ghost, after: &Camera) -> DVec3 {
    let before = &ghost.before;
    if let Some(axis) = ghost.operation.axis(before) {
        return turn(builder, palette, gear, ghost, axis);
    }
    let moved = |a: DVec3, b: DVec3| (a != b).then(|| vec![a, b]);
    for way in [moved(before.position(), after.position()), moved(before.focal_point(), after.focal_point())] {
        builder.arrows(way, palette.probe);
    }
    let [.., corner, _, _, _, _] = before.volume_corners();
    if before.position() == after.position() { corner } else { before.position().midpoint(after.position()) }
}

/// The camera before, faintly, with its name if it has moved.
fn camera_before(
    builder: &mut AnnotationBuilder,
    palette: Palette,
    gear: GizmoSizes,
    (before, after): (&Camera, &Camera),
    name: &str,
) {
    let (c, color) = (before.position(), palette.ghost);
    camera(builder, gear, before, "camera before", color);
    let moved = c.distance(after.position()) > 0.5 * gear.axis;
    if moved {
        builder.mark(c, MarkShape::Ring, 3.0, color);
        builder.named("before", c, name, DVec2::new(-0.6, -0.8), SMALL_TYPE, color);
    }
}

/// The camera of an answer with its axes and its name, in the colour of errors.
fn camera_answered(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    gear: GizmoSizes,
    answered: &Camera,
) {
    let (c, color) = (answered.position(), palette.wrong);
    camera(builder, gear, answered, "camera of the answer", color);
    let basis = answered.basis();
    for (k, axis, name) in basis.named() {
        builder.axis(k, c, axis * gear.axis, (color, 1.4), name);
    }
    builder.mark(c, MarkShape::Ring, 4.0, color);
    builder.role = Role::Aside;
    builder.named("answered", c, request.labels.answered, DVec2::new(-0.6, 0.8), SMALL_TYPE, color);
}

/// A camera that isn't the one of the picture, faintly, with its body, its line to PF, and the place of its window.
fn camera(builder: &mut AnnotationBuilder, gear: GizmoSizes, camera: &Camera, name: &str, color: Rgba) {
    let c = camera.position();
    builder.camera_body(name, camera, gear.body, [color, color.with_alpha(70)]);
    builder.line(vec![c, camera.focal_point()], color, 0.9, Dash::Dotted);
    let corners = camera.volume_corners();
    builder.closed(&corners[..4], color, 1.2, Dash::Dotted);
}

/// The axis through the pivot, and the arc in the sense of the rotation. Returns its middle.
fn turn(builder: &mut AnnotationBuilder, palette: Palette, gear: GizmoSizes, ghost: &Ghost, axis: Ray) -> DVec3 {
    let (before, pivot) = (&ghost.before, axis.origin);
    let (moved, number) = match ghost.operation {
        Operation::Elevation(_) => (before.position(), 0),
        Operation::Azimuth(_) => (before.position(), 1),
        Operation::Roll(_) => (gear.view_up_tip(before), 2),
        Operation::Yaw(_) => (before.focal_point(), 1),
        Operation::Pitch(_) => (before.focal_point(), 0),
        Operation::Zoom(_) | Operation::Dolly(_) | Operation::Pan { .. } => return pivot,
    };
    let (color, name) = (palette.axes[usize::from(number)], ["u", "v", "n"][usize::from(number)]);
    let Some(angle) = ghost.operation.right_hand_angle(ghost.convention) else { return pivot };
    let reach = builder.screen.units_per_pixel(pivot) * 0.2 * builder.screen.extent.min_element();
    let tip = pivot + axis.direction * reach;
    builder.arrow(vec![pivot - axis.direction * reach, tip], color, 1.6, Dash::DashDot);
    builder.role = Role::Axis(number);
    builder.text(tip, name, builder.screen.heading(pivot, axis.direction), TYPE, color);
    builder.mark(pivot, MarkShape::Ring, 5.0, color);

    let arc = arc(axis, moved, angle.radians());
    let ends = [arc.first().copied(), arc.last().copied()];
    for end in ends.into_iter().flatten() {
        builder.line(vec![pivot, end], palette.probe, 0.9, Dash::Dotted);
    }
    let middle = arc.get(arc.len() / 2).copied().unwrap_or(pivot);
    builder.arrows(Some(arc), palette.probe);
    middle
}

/// The path of a point that rotates about an axis. More than two full turns aren't distinguished.
pub(in crate::views) fn arc(axis: Ray, from: DVec3, radians: f64) -> Vec<DVec3> {
    const STEPS: u32 = 96;
    let angle = radians.clamp(-2.0 * std::f64::consts::TAU, 2.0 * std::f64::consts::TAU);
    let arm = from - axis.origin;
    let turned = |t: f64| axis.origin + DQuat::from_axis_angle(axis.direction, angle * t) * arm;
    (0..=STEPS).map(|i| turned(f64::from(i) / f64::from(STEPS))).collect()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{Convention, Parameters};
    use crate::geometry::Angle;

    #[test]
    fn the_arc_ends_where_the_operation_leads() {
        let before = Camera::new(&Parameters::default()).unwrap();
        let by = Angle::from_degrees(50.0);
        for convention in [Convention::RightHand, Convention::Vtk] {
            for (operation, moved) in [
                (Operation::Elevation(by), Camera::position as fn(&Camera) -> DVec3),
                (Operation::Azimuth(by), Camera::position),
                (Operation::Yaw(by), Camera::focal_point),
                (Operation::Pitch(by), Camera::focal_point),
            ] {
                let after = operation.apply(&before, convention).unwrap();
                let axis = operation.axis(&before).unwrap();
                let angle = operation.right_hand_angle(convention).unwrap().radians();
                let (from, to) = (moved(&before), moved(&after));
                let way = arc(axis, from, angle);
                assert!((way.first().unwrap() - from).length() < 1e-12);
                assert!((way.last().unwrap() - to).length() < 1e-12, "{operation:?} {convention:?}");
            }
        }
    }
}
