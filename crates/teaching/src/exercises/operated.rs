//! The operations on a camera with the known mistakes.

use glam::{DQuat, DVec3};

use super::subject::Subject;
use crate::camera::{Camera, CameraError, Convention, Operation, Parameters, Projection};
use crate::exercises::mistakes::slip::{Slip, Slips};
use crate::geometry::Angle;

/// The camera after the operations, done with the slips.
pub(super) fn operated(subject: &Subject, slips: Slips) -> Result<Camera, CameraError> {
    let mut operations = subject.operations.clone();
    if slips.has(Slip::OrderReversed) {
        operations.reverse();
    }
    if slips.has(Slip::NothingDone) {
        operations.clear();
    }
    let camera = Camera::new(&subject.figure.camera)?;
    operations.iter().try_fold(camera, |camera, operation| match otherwise(&camera, *operation, slips) {
        Some(parameters) => Camera::new(&parameters),
        None => slipped(*operation, slips).apply(&camera, Convention::RightHand),
    })
}

/// A rotation by an angle.
type Turn = fn(Angle) -> Operation;

/// The operation that slips turn another into.
fn slipped(operation: Operation, slips: Slips) -> Operation {
    if let Some(angle) = operation.angle() {
        let angle = if slips.has(Slip::OppositeAngle) { -angle } else { angle };
        let angle = if slips.has(Slip::TurnInRadians) { Angle::from_radians(angle.degrees()) } else { angle };
        let angle = if slips.has(Slip::HalfTurn) { Angle::from_degrees(angle.degrees() / 2.0) } else { angle };
        // sin(90° − α) = cos α
        let angle = if slips.has(Slip::SineForCosine) { Angle::from_degrees(90.0 - angle.degrees()) } else { angle };
        let others: [(Slip, Turn); 5] = [
            (Slip::Elevated, Operation::Elevation),
            (Slip::Turned, Operation::Azimuth),
            (Slip::Rolled, Operation::Roll),
            (Slip::Yawed, Operation::Yaw),
            (Slip::Pitched, Operation::Pitch),
        ];
        if let Some((_, other)) = others.into_iter().find(|(slip, _)| slips.has(*slip)) {
            return other(angle);
        }
        let is_printed = slips.has(Slip::PrintedAxes);
        return match operation {
            Operation::Elevation(_) => Operation::Elevation(angle),
            Operation::Azimuth(_) => Operation::Azimuth(angle),
            Operation::Roll(_) => Operation::Roll(angle),
            Operation::Yaw(_) if is_printed => Operation::Pitch(angle),
            Operation::Yaw(_) => Operation::Yaw(angle),
            _ if is_printed => Operation::Yaw(angle),
            _ => Operation::Pitch(angle),
        };
    }
    let factor = |factor: f64| if slips.has(Slip::FactorInverted) { 1.0 / factor } else { factor };
    match operation {
        Operation::Zoom(by) if slips.has(Slip::Dollied) => Operation::Dolly(factor(by)),
        Operation::Dolly(by) if slips.has(Slip::Zoomed) => Operation::Zoom(factor(by)),
        Operation::Zoom(by) => Operation::Zoom(factor(by)),
        Operation::Dolly(by) => Operation::Dolly(factor(by)),
        Operation::Pan { dx, dy } => {
            let both = slips.any(&[Slip::OppositePan, Slip::UReversed]);
            let dx = if both || slips.has(Slip::UReversedAlone) { -dx } else { dx };
            let dy = if both || slips.has(Slip::VReversed) { -dy } else { dy };
            if slips.has(Slip::AxesExchanged) { Operation::Pan { dx: dy, dy: dx } } else { Operation::Pan { dx, dy } }
        }
        other => other,
    }
}

/// The camera after slips that no operation performs; `None` if none of them was made.
fn otherwise(camera: &Camera, operation: Operation, slips: Slips) -> Option<Parameters> {
    let before = *camera.parameters();
    let (position, focal_point) = (before.position, before.focal_point);
    match operation {
        Operation::Zoom(factor) if camera.projection() == Projection::Perspective && before.window.is_none() => {
            let angle = before.view_angle;
            // The angle with which the same mistake gives the window divided by s.
            let divided = |tangent: f64| (tangent / factor).atan();
            if slips.any(&[Slip::WholeAngle, Slip::WholeAngleOnce]) {
                Some(Parameters { view_angle: divided(angle.to_radians().tan()).to_degrees(), ..before })
            } else if slips.has(Slip::Radians) {
                Some(Parameters { view_angle: 2.0 * divided((angle / 2.0).tan()), ..before })
            } else if slips.has(Slip::ZoomOnAngle) {
                Some(Parameters { view_angle: angle / factor, ..before })
            } else if slips.has(Slip::ZoomTimesAngle) {
                Some(Parameters { view_angle: angle * factor, ..before })
            } else {
                None
            }
        }
        Operation::Dolly(factor) if slips.has(Slip::ThroughOrigin) => {
            Some(Parameters { position: position / factor, ..before })
        }
        Operation::Dolly(factor) if slips.has(Slip::WayForDistance) && factor > 1.0 => {
            Some(Parameters { position: position + (focal_point - position) / factor, ..before })
        }
        Operation::Pan { dx, dy } if slips.any(&[Slip::UnitViewUpAsV, Slip::ViewUpAsV]) => {
            let up = before.view_up;
            let up = if slips.has(Slip::UnitViewUpAsV) { up.normalize() } else { up };
            let by = camera.basis().u * dx + up * dy;
            Some(Parameters { position: position + by, focal_point: focal_point + by, ..before })
        }
        Operation::Pan { dx, dy } if slips.has(Slip::ViewAsWorld) => {
            let by = DVec3::new(dx, dy, 0.0);
            Some(Parameters { position: position + by, focal_point: focal_point + by, ..before })
        }
        // The height that follows from the view angle, in a parallel projection too (5.2 of `[0]`).
        Operation::Zoom(factor) if slips.has(Slip::ZoomOnAngle) && has_height_of_angle(&before) => {
            let half = (before.view_angle / factor / 2.0).to_radians().tan();
            Some(Parameters { height: 2.0 * before.near * half, ..before })
        }
        _ => turned(camera, operation, slips),
    }
}

/// True if the height of a parallel camera is 2 F tan(θ/2).
fn has_height_of_angle(camera: &Parameters) -> bool {
    let height = 2.0 * camera.near * (camera.view_angle / 2.0).to_radians().tan();
    camera.projection == Projection::Parallel && (camera.height - height).abs() <= 1e-9 * height
}

/// C' = C + R (PF − C) for C' = PF + R (C − PF), or PF' = PF + R (C − PF) for PF' = C + R (PF − C).
fn exchanged_points(camera: &Camera, angle: Angle, about_u: bool, moves_position: bool) -> Parameters {
    let before = *camera.parameters();
    let axis = if about_u { camera.basis().u } else { camera.basis().v };
    let turn = DQuat::from_axis_angle(axis, angle.degrees().to_radians());
    let (position, focal_point) = (before.position, before.focal_point);
    let view_up = turn * before.view_up;
    if moves_position {
        Parameters { position: position + turn * (focal_point - position), view_up, ..before }
    } else {
        Parameters { focal_point: focal_point + turn * (position - focal_point), view_up, ..before }
    }
}

/// A rotation about another axis, through another point, or of less than the whole camera.
fn turned(camera: &Camera, operation: Operation, slips: Slips) -> Option<Parameters> {
    let angle = operation.angle()?;
    let before = *camera.parameters();
    let basis = camera.basis();
    let is_elevation = matches!(operation, Operation::Elevation(_));
    let about_u = is_elevation || matches!(operation, Operation::Pitch(_));
    let is_roll = matches!(operation, Operation::Roll(_));
    let keeps_up = (slips.has(Slip::ViewUpKept) && !is_elevation && !is_roll)
        || (slips.has(Slip::PrintedElevation) && is_elevation);
    if keeps_up {
        let after = operation.apply(camera, Convention::RightHand).ok()?;
        return Some(Parameters { view_up: before.view_up, ..*after.parameters() });
    }
    let of_point = [Slip::PointsExchanged, Slip::TurnedInPlace, Slip::CentreNotAddedBack, Slip::DistanceLeftOut];
    if is_roll && slips.any(&of_point) {
        return None;
    }
    let shortened = slips.pick(
        [(Slip::CentreNotAddedBack, Some([0.0, 1.0])), (Slip::DistanceLeftOut, Some([1.0, 1.0 / camera.distance()]))],
        None,
    );
    if let Some([of_centre, of_vector]) = shortened {
        let after = *operation.apply(camera, Convention::RightHand).ok()?.parameters();
        let shortened = |centre: DVec3, moved: DVec3| centre * of_centre + (moved - centre) * of_vector;
        return Some(if is_elevation || matches!(operation, Operation::Azimuth(_)) {
            Parameters { position: shortened(before.focal_point, after.position), ..after }
        } else {
            Parameters { focal_point: shortened(before.position, after.focal_point), ..after }
        });
    }
    if slips.has(Slip::TurnedInPlace) {
        return Some(before);
    }
    if slips.has(Slip::PointsExchanged) {
        return Some(exchanged_points(
            camera,
            angle,
            about_u,
            is_elevation || matches!(operation, Operation::Azimuth(_)),
        ));
    }
    let axis = if slips.has(Slip::WorldAxis) {
        [DVec3::Y, DVec3::X, DVec3::Z][if is_roll { 2 } else { usize::from(about_u) }]
    } else if slips.has(Slip::ViewUpAxis) && !about_u && !is_roll {
        before.view_up.normalize()
    } else if slips.any(&[Slip::ThroughOrigin, Slip::ThroughOriginAll]) && !is_roll {
        if about_u { basis.u } else { basis.v }
    } else {
        return None;
    };
    let turn = DQuat::from_axis_angle(axis, angle.degrees().to_radians());
    let (position, focal_point) = (before.position, before.focal_point);
    let view_up = turn * before.view_up;
    let moves_position = matches!(operation, Operation::Elevation(_) | Operation::Azimuth(_));
    let all = slips.has(Slip::ThroughOriginAll);
    let from_origin = all || slips.has(Slip::ThroughOrigin);
    let about = |fixed: DVec3, point: DVec3| {
        let fixed = if from_origin { DVec3::ZERO } else { fixed };
        fixed + turn * (point - fixed)
    };
    let turned_position = if moves_position || all { about(focal_point, position) } else { position };
    let turned_focal_point =
        if (!moves_position && !is_roll) || all { about(position, focal_point) } else { focal_point };
    Some(Parameters { position: turned_position, focal_point: turned_focal_point, view_up, ..before })
}
