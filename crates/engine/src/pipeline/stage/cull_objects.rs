//! **Cull objects**: measure which objects have their bounding box outside the volume, so they can be dropped.
//!
//! *Notes*: `[3]` §1.2 names the removal of what can't be seen before clipping, without saying how; there each polygon
//! is tested. *Textbook*: the eight corners of an object's bounding box against the six planes: if all are outside one
//! plane, so is the object. *Here*: the same, and the bounding sphere as well, which is tighter than a box that
//! stands askew. The test has a third answer, "inside these planes", which spares the object's faces the comparison
//! with them. The depths of the boxes also say how the depth buffer's range is best spent
//! ([`DepthScale`](crate::pipeline::space::depths::DepthScale)).

use super::vertex::{clip_from_view, view_point};
use crate::appearance::VertexFormat;
use crate::pipeline::mesh::bounds::{Bounds, KnownBounds};
use crate::pipeline::plan::{Containment, Extent};
use crate::pipeline::scenes::Scenes;
use crate::pipeline::space::depths::InView;
use crate::pipeline::space::projector::{Projector, ViewFromObject};
use crate::pipeline::space::{ALL_PLANES, ObjectPoint, PLANES, PlaneSet, distances};
use crate::scene::Object;

/// Compares each object with the volume, in the order of the scene. [`Plan`](crate::pipeline::plan::Plan) marks those
/// outside, and [`traverse`](super::traverse::traverse) leaves them out.
pub(crate) fn cull_objects(scenes: Scenes, projector: &Projector, known: &mut KnownBounds) -> Vec<Extent> {
    known.forget_gone(scenes.object_count());
    let extent = |object: &Object| match known.of(&object.mesh) {
        Some(bounds) => containment(projector, &projector.view_from_object(object.world_from_object), &bounds),
        None => Extent { containment: Containment::Empty, in_view: InView::NOTHING },
    };
    scenes.objects().map(extent).collect()
}

/// Tests the bounding box and the bounding sphere against the six planes. Before the divide a distance is linear, so
/// its extremes over a box lie at corners. Over a sphere they are the middle's distance ± the radius times the slope.
///
/// Inside needs a margin for rounding. Only then would clipping leave the object as it is.
pub(crate) fn containment(projector: &Projector, view_from_object: &ViewFromObject, bounds: &Bounds) -> Extent {
    const MARGIN: f64 = 1e-13;
    let corners = bounds.aabb.corners();
    let reach = corners.iter().fold(0.0, |most, &corner| view_from_object.magnitude(corner).max(most));
    let slack = slack(projector, MARGIN, reach);
    // The corners of a box say nothing about rounded vertices.
    if !bounds.finite || projector.format != VertexFormat::F64 || !slack.iter().all(|s| s.is_finite()) {
        let in_view = InView::between(projector.near, projector.far);
        return Extent { containment: Containment::Crosses(ALL_PLANES), in_view };
    }
    let nothing = (f64::INFINITY, f64::NEG_INFINITY);
    let widened = |range: (f64, f64), by: f64| (range.0.min(by), range.1.max(by));
    let (mut range, mut depths) = ([nothing; PLANES], nothing);
    for corner in corners {
        let p = clip_from_view(projector, view_point(view_from_object, ObjectPoint(corner)));
        depths = widened(depths, p.distance);
        for (range, d) in range.iter_mut().zip(distances(projector, p)) {
            *range = widened(*range, d);
        }
    }
    let middle = clip_from_view(projector, view_point(view_from_object, ObjectPoint(bounds.aabb.center())));
    let across = bounds.radius * view_from_object.slope(projector.gradient(4));
    let depths = (depths.0.max(middle.distance - across), depths.1.min(middle.distance + across));
    let middle = distances(projector, middle);
    let (mut outside, mut inside) = (0, 0);
    for (i, (least, most)) in range.into_iter().enumerate() {
        let across = bounds.radius * view_from_object.slope(projector.gradient(i));
        let (least, most) = (least.max(middle[i] - across), most.min(middle[i] + across));
        outside |= PlaneSet::from(most < -slack[i / 2]) << i;
        inside |= PlaneSet::from(least > slack[i / 2]) << i;
    }
    if outside != 0 {
        return Extent { containment: Containment::Outside(outside), in_view: InView::NOTHING };
    }
    let in_view =
        InView { nearest: depths.0, farthest: depths.1, magnitude: reach }.clipped(projector.near, projector.far);
    Extent { containment: Containment::Crosses(ALL_PLANES & !inside), in_view }
}

/// Greatest error of the distances from the planes: of left and right, bottom and top, near and far.
fn slack(projector: &Projector, margin: f64, reach: f64) -> [f64; 3] {
    let w = if projector.projection.is_perspective() { reach } else { 1.0 };
    [
        margin * (projector.scale[0] * reach + (1.0 + projector.shift[0].abs()) * w),
        margin * (projector.scale[1] * reach + (1.0 + projector.shift[1].abs()) * w),
        margin * (reach + projector.far.abs().max(projector.near.abs())),
    ]
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::camera::{Camera, Parameters, Projection, ViewWindow};
    use crate::geometry::Aabb;
    use glam::{DMat4, DQuat, DVec3};

    /// Looks down −z.
    fn eye(position: DVec3, projection: Projection, window: ViewWindow, [near, far]: [f64; 2]) -> Projector {
        let parameters = Parameters {
            position,
            focal_point: position + DVec3::NEG_Z,
            near,
            far,
            projection,
            window: Some(window),
            ..Parameters::default()
        };
        Projector::new(&Camera::new(&parameters).unwrap())
    }

    /// Window ±1 on F = 1, B = 9, from the origin. The planes are |x| = d, |y| = d.
    fn right_angle() -> Projector {
        eye(
            DVec3::ZERO,
            Projection::Perspective,
            ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 },
            [1.0, 9.0],
        )
    }

    /// The containment of a box around `middle`, with a sphere of this radius.
    fn of_box(projector: &Projector, middle: DVec3, half: DVec3, radius: f64) -> Containment {
        let bounds = Bounds { aabb: Aabb { min: middle - half, max: middle + half }, radius, finite: true };
        containment(projector, &projector.view_from_object(DMat4::IDENTITY), &bounds).containment
    }

    #[test]
    fn the_slack_is_the_size_of_the_terms_that_a_distance_is_summed_up_from() {
        // 4 wide and 6 high on F = 1: x_r = ½ x − ½ w, y_r = ⅓ y − ⅓ w. The coordinates are at most 6, and in
        // perspective w is too. So x: 3 + (1 + ½) · 6, y: 2 + (1 + ⅓) · 6, z: 6 + 9.
        let near = |found: [f64; 3], expected: [f64; 3]| {
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() < 1e-12 * expected, "{found} is not {expected}");
            }
        };
        let window = ViewWindow { left: -1.0, right: 3.0, bottom: -2.0, top: 4.0 };
        let perspective = eye(DVec3::ZERO, Projection::Perspective, window, [1.0, 9.0]);
        near(slack(&perspective, 1e-3, 6.0), [0.012, 0.010, 0.015]);
        // w = 1 in parallel projection.
        let parallel = eye(DVec3::ZERO, Projection::Parallel, window, [1.0, 9.0]);
        near(slack(&parallel, 1e-3, 6.0), [0.0045, 0.001 * (2.0 + 4.0 / 3.0), 0.015]);
        // It's as far to the other side.
        let window = ViewWindow { left: -3.0, right: 1.0, bottom: -4.0, top: 2.0 };
        near(slack(&eye(DVec3::ZERO, Projection::Perspective, window, [1.0, 9.0]), 1e-3, 6.0), [0.012, 0.010, 0.015]);
    }

    /// A point at a distance from a plane, at depth 2 and away from all other planes.
    fn at(projector: &Projector, plane: usize, distance: f64) -> DVec3 {
        let w = if projector.projection.is_perspective() { 2.0 } else { 1.0 };
        let across = |axis: usize| {
            let clip = match plane {
                p if p / 2 != axis => 0.0,
                p if p % 2 == 0 => distance - w,
                _ => w - distance,
            };
            (clip + projector.shift[axis] * w) / projector.scale[axis]
        };
        let depth = match plane {
            4 => projector.near + distance,
            5 => projector.far - distance,
            _ => return DVec3::new(across(0), across(1), -2.0),
        };
        // The middle of the window there.
        let w = if projector.projection.is_perspective() { depth } else { 1.0 };
        DVec3::new(projector.shift[0] * w / projector.scale[0], projector.shift[1] * w / projector.scale[1], -depth)
    }

    /// Cameras whose slack differs by orders of magnitude between the axes, each in its own way.
    fn uneven() -> [Projector; 3] {
        let narrow = ViewWindow { left: -1e-6, right: 3e-6, bottom: -4.0, top: 2.0 };
        let low = ViewWindow { left: -4.0, right: 2.0, bottom: -1e-6, top: 3e-6 };
        [
            eye(DVec3::ZERO, Projection::Perspective, narrow, [1.0, 4.0]),
            eye(DVec3::ZERO, Projection::Perspective, low, [1.0, 4.0]),
            eye(DVec3::ZERO, Projection::Parallel, low, [1.0, 1e4]),
        ]
    }

    #[test]
    fn an_object_is_inside_or_outside_a_plane_only_beyond_what_rounding_may_do() {
        for (projector, plane) in uneven().iter().flat_map(|projector| (0..PLANES).map(move |plane| (projector, plane)))
        {
            let bit = 1 << plane;
            let reach = projector.view_from_object(DMat4::IDENTITY).magnitude(at(projector, plane, 0.0));
            let slack = slack(projector, 1e-13, reach)[[0, 0, 1, 1, 2, 2][plane]];
            let found = |distance: f64| of_box(projector, at(projector, plane, distance), DVec3::ZERO, 0.0);
            let crosses = |found| matches!(found, Containment::Crosses(planes) if planes & bit != 0);
            assert_eq!(found(-1.5 * slack), Containment::Outside(bit), "{plane}");
            assert!(crosses(found(-0.5 * slack)), "{plane}");
            assert!(crosses(found(0.0)) && crosses(found(0.5 * slack)), "{plane}");
            assert!(matches!(found(1.5 * slack), Containment::Crosses(planes) if planes & bit == 0), "{plane}");
        }
    }

    #[test]
    fn what_lies_in_a_plane_of_a_turned_camera_crosses_it() {
        // A thousand points in the planes, from the corners of the volume that the camera gives.
        for k in 0..50 {
            let turn = f64::from(k);
            let direction = DQuat::from_rotation_y(turn) * DQuat::from_rotation_x(0.7 * turn.sin()) * DVec3::NEG_Z;
            let position = DVec3::new(10.0 * turn.cos(), turn, -3.0);
            let parameters = Parameters {
                position,
                focal_point: position + direction,
                near: 0.3,
                far: 40.0,
                ..Parameters::default()
            };
            let camera = Camera::new(&parameters).unwrap();
            let projector = Projector::new(&camera);
            let c = camera.volume_corners();
            let faces = [[0, 3, 7, 4], [1, 2, 6, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 2, 3], [4, 5, 6, 7]];
            for (plane, face) in faces.into_iter().enumerate() {
                for shares in [[0.25; 4], [0.5, 0.25, 0.125, 0.125], [0.1, 0.2, 0.3, 0.4]] {
                    let point = (0..4).fold(DVec3::ZERO, |sum, i| sum + shares[i] * c[face[i]]);
                    assert_eq!(
                        of_box(&projector, point, DVec3::ZERO, 0.0),
                        Containment::Crosses(1 << plane),
                        "{k} {plane}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_box_and_the_ball_tell_the_more_of_the_two() {
        let eye = right_angle();
        // The planes x = ±d are d / √2 from the point at depth d in the middle: 2.83 at 4. A box of ±2 around it
        // crosses all four of them, a ball of 2 none, one of 3 all; and planes missed by the box need not be missed by
        // the ball.
        let middle = DVec3::new(0.0, 0.0, -4.0);
        let half = DVec3::splat(2.0);
        assert_eq!(of_box(&eye, middle, half, 100.0), Containment::Crosses(0b1111));
        assert_eq!(of_box(&eye, middle, half, 3.0), Containment::Crosses(0b1111));
        assert_eq!(of_box(&eye, middle, half, 2.8), Containment::Crosses(0));
        assert_eq!(of_box(&eye, middle, DVec3::splat(1.0), 100.0), Containment::Crosses(0));
        // 7.4 to the right of it, 3.4 / √2 = 2.40 outside.
        let aside = DVec3::new(7.4, 0.0, -4.0);
        assert_eq!(of_box(&eye, aside, half, 100.0), Containment::Crosses(0b1110));
        assert_eq!(of_box(&eye, aside, half, 2.5), Containment::Crosses(0b0010));
        assert_eq!(of_box(&eye, aside, half, 2.3), Containment::Outside(0b0010));
        assert_eq!(of_box(&eye, aside, DVec3::splat(1.6), 100.0), Containment::Outside(0b0010));
        // Behind the eye it is outside the near plane, and the sides.
        assert_eq!(of_box(&eye, DVec3::new(0.0, 0.0, 4.0), DVec3::ONE, 2.0), Containment::Outside(0b01_1111));
    }

    #[test]
    fn bounds_that_cannot_be_relied_on_say_nothing() {
        let eye = right_angle();
        let way = eye.view_from_object(DMat4::IDENTITY);
        let aabb = Aabb { min: DVec3::new(20.0, -1.0, -5.0), max: DVec3::new(22.0, 1.0, -3.0) };
        let bounds = |aabb, finite| Bounds { aabb, radius: 2.0, finite };
        let containment = |bounds| containment(&eye, &way, &bounds).containment;
        assert_eq!(containment(bounds(aabb, true)), Containment::Outside(0b0010));
        assert_eq!(containment(bounds(aabb, false)), Containment::Crosses(ALL_PLANES));
        let large = Aabb { min: aabb.min, max: DVec3::new(1.7e308, 1.0, -3.0) };
        assert_eq!(containment(bounds(large, true)), Containment::Crosses(ALL_PLANES));
    }
}
