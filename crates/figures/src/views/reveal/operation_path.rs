//! The operations that a figure shows, in the canonical volume and in the image, with the pivot, the axis, the arc and
//! the former window as far as the present camera sees them. The world shows all of it.

use glam::DVec3;

use crate::appearance::{Dash, MarkShape};
use crate::camera::{Camera, Operation};
use crate::geometry::Ray;
use crate::pipeline::canonical::displayed_ndc;
use crate::views::canonical::canonical_box::CanonicalBox;
use crate::views::words::legend::{LegendRow, LegendText};
use crate::views::world::ghost::arc;
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE};
use crate::views::{Ghost, Palette, Request};

/// The reach of an axis and of the arc about it, in terms of D.
const REACH: f64 = 0.3;

/// The operations in the canonical volume.
pub(in crate::views) fn in_canonical(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
) -> Vec<LegendRow> {
    let canonical = CanonicalBox::of(request);
    drawn(builder, request, palette, |p| {
        let ndc = displayed_ndc(&request.camera, p)?;
        Some(canonical.place(ndc))
    })
}

/// The operations in the image.
pub(in crate::views) fn in_image(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
) -> Vec<LegendRow> {
    let eye = request.camera.position();
    // A hair behind the window, because rounding decides if a line in the front plane is clipped.
    drawn(builder, request, palette, |p| Some(eye + (p - eye) * 1.0005))
}

/// Draws them, with each point at the place that `place` gives. Operations without an arc for the name are named in the
/// legend.
fn drawn(
    builder: &mut AnnotationBuilder,
    request: &Request,
    palette: Palette,
    place: impl Fn(DVec3) -> Option<DVec3>,
) -> Vec<LegendRow> {
    let led = request.operations();
    let mut rows = Vec::new();
    for (k, (ghost, after)) in led.iter().enumerate() {
        let text = request.operation_text(k, led.len(), ghost.operation);
        let before = &ghost.before;
        let corners = before.volume_corners();
        let window: Vec<DVec3> = corners[..4].iter().chain(&corners[..1]).copied().collect();
        for run in seen(&request.camera, &divided(&window), &place) {
            builder.line(run, palette.ghost, 1.4, Dash::Dotted);
        }
        let in_legend = |text| LegendRow::Title(LegendText::new("operation", text), palette.probe);
        let Some(turn) = Turn::of(ghost, after) else {
            rows.push(in_legend(text));
            continue;
        };
        for run in seen(&request.camera, &divided(&turn.axis), &place) {
            builder.arrow(run, palette.ghost, 1.4, Dash::DashDot);
        }
        let arcs = seen(&request.camera, &turn.arc, &place);
        if let Some(longest) = arcs.iter().max_by_key(|run| run.len())
            && let Some(middle) = longest.get(longest.len() / 2).copied()
        {
            let toward = builder.screen.heading(middle, middle - longest[0]);
            builder.named(ghost.operation.name(), middle, &text, toward, SMALL_TYPE, palette.probe);
        } else {
            rows.push(in_legend(text));
        }
        for run in arcs {
            builder.arrows(Some(run), palette.probe);
        }
        if let [pivot] = seen(&request.camera, &[turn.pivot], &place).concat()[..] {
            builder.mark(pivot, MarkShape::Ring, 5.0, palette.ghost);
        }
    }
    rows
}

/// A rotation as seen from the camera after it.
struct Turn {
    pivot: DVec3,
    axis: [DVec3; 2],
    arc: Vec<DVec3>,
}

impl Turn {
    /// About PF, the arc is that of the line of sight, since C is the eye of the picture. About C, it's the way of PF.
    /// A roll is shown at PF.
    fn of(ghost: &Ghost, after: &Camera) -> Option<Self> {
        let before = &ghost.before;
        let axis = ghost.operation.axis(before)?;
        let angle = ghost.operation.right_hand_angle(ghost.convention)?.radians();
        let (pf, reach) = (after.focal_point(), REACH * after.distance());
        let (pivot, from) = match ghost.operation {
            Operation::Elevation(_) | Operation::Azimuth(_) => {
                (axis.origin, axis.origin + (before.position() - axis.origin).normalize_or_zero() * reach)
            }
            Operation::Roll(_) => (pf, pf + before.basis().v * reach),
            Operation::Yaw(_) | Operation::Pitch(_) => (axis.origin, before.focal_point()),
            Operation::Zoom(_) | Operation::Dolly(_) | Operation::Pan { .. } => return None,
        };
        let axis = Ray { origin: pivot, ..axis };
        let ends = [-reach, reach].map(|along| pivot + axis.direction * along);
        Some(Self { pivot, axis: ends, arc: arc(axis, from, angle) })
    }
}

/// A line through points, in short pieces.
fn divided(points: &[DVec3]) -> Vec<DVec3> {
    const PIECES: u32 = 48;
    let piece = |pair: &[DVec3]| {
        let (a, b) = (pair[0], pair[1]);
        (0..=PIECES).map(move |i| a.lerp(b, f64::from(i) / f64::from(PIECES))).collect::<Vec<_>>()
    };
    points.windows(2).flat_map(piece).collect()
}

/// The parts of a line in the view volume of the camera, with each point at the place that `place` gives.
fn seen(camera: &Camera, line: &[DVec3], place: impl Fn(DVec3) -> Option<DVec3>) -> Vec<Vec<DVec3>> {
    /// Points on a face count as inside.
    const EDGE: f64 = 1.0 + 1e-6;
    let inside = |p: DVec3| {
        let depth = -camera.view_point(p).z;
        let in_front = depth >= camera.near() * (2.0 - EDGE) && depth <= camera.far() * EDGE;
        let ndc = displayed_ndc(camera, p).filter(|_| in_front)?;
        (ndc.x.abs() <= EDGE && ndc.y.abs() <= EDGE).then(|| place(p)).flatten()
    };
    let mut runs = vec![Vec::new()];
    for p in line {
        match (inside(*p), runs.last_mut()) {
            (Some(p), Some(run)) => run.push(p),
            (None, Some(run)) if !run.is_empty() => runs.push(Vec::new()),
            _ => {}
        }
    }
    let least = line.len().min(2);
    runs.retain(|run| run.len() >= least);
    runs
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{Convention, Parameters};

    #[test]
    fn operations_lead_back_from_the_camera_of_the_figure() {
        let first = Camera::new(&Parameters::default()).unwrap();
        let operations = ["azimuth=30", "zoom=2", "pan=1,-0.5", "roll=20"].map(|text| text.parse().unwrap());
        let mut camera = first.clone();
        for operation in operations {
            camera = Operation::apply(&operation, &camera, Convention::RightHand).unwrap();
        }
        let led = Ghost::leading_to(&camera, &operations);
        assert_eq!(led.len(), 4);
        let begin = led[0].0.before.parameters();
        assert!((begin.position - first.position()).length() < 1e-12, "{begin:?}");
        for pair in led.windows(2) {
            assert_eq!(pair[0].1, pair[1].0.before, "each goes on where the one before ends");
        }
        assert_eq!(led[3].1, camera);
    }

    #[test]
    fn only_parts_in_the_volume_are_drawn() {
        let camera = Camera::new(&Parameters::default()).unwrap();
        let beyond = camera.position() - camera.direction_of_projection() * 3.0;
        let line = divided(&[beyond, camera.focal_point()]);
        let [run] = seen(&camera, &line, Some).try_into().unwrap();
        assert!(run.iter().all(|p| -camera.view_point(*p).z >= camera.near() * 0.999));
        assert_eq!(run.last().copied(), Some(camera.focal_point()));
        assert!(seen(&camera, &[beyond], Some).is_empty());
    }
}
