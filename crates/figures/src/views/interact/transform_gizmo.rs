//! The gizmo that moves, rotates and scales the selected objects in the world: three arrows, three rings, or three
//! bars.

use glam::{DVec2, DVec3};

use crate::appearance::{Dash, HiddenLines, LineStyle, MarkShape};
use crate::geometry::{Angle, Ray};
use crate::scene::Line;

use super::handles::Grip;
use crate::views::screen::Screen;
use crate::views::world::gizmos::{AnnotationBuilder, SMALL_TYPE, circle};
use crate::views::world::world_framing;
use crate::views::{GizmoPart, Palette, Request, TransformGizmo, Transforming};

/// Corners of a ring.
const CORNERS: u32 = 64;

/// A pull at a part of the gizmo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pull {
    /// A distance (world) along the axis, and the length of a pixel there.
    Along {
        /// Scene units.
        way: f64,
        /// Scene units.
        pixel: f64,
    },
    /// A turn about the axis.
    Round {
        /// Counter-clockwise seen from the tip of the axis, −180° … 180°.
        angle: Angle,
        /// The angle of a pixel at the ring.
        pixel: Angle,
    },
    /// A factor of the distance from the middle.
    Times {
        /// Above 0.
        factor: f64,
        /// The change by a pixel.
        pixel: f64,
    },
}

/// The length of arrows and bars, and the radius of the rings (world). It's fixed on the screen.
fn length(gizmo: &TransformGizmo, screen: &Screen) -> f64 {
    let (side, scale) = (screen.extent.min_element(), screen.scale);
    screen.units_per_pixel(gizmo.origin) * (0.15 * side).clamp(40.0 * scale, 120.0 * scale)
}

fn tip(gizmo: &TransformGizmo, screen: &Screen, axis: usize) -> DVec3 {
    gizmo.origin + gizmo.axes[axis] * length(gizmo, screen)
}

/// The ring about an axis (world), closed.
fn ring(gizmo: &TransformGizmo, screen: &Screen, axis: usize) -> Vec<DVec3> {
    let normal = gizmo.axes[axis];
    let a = normal.any_orthonormal_vector() * length(gizmo, screen);
    let mut points = circle(gizmo.origin, a, normal.cross(a), CORNERS);
    points.extend(points.first().copied());
    points
}

/// The part at `pointer` (pixels), within `reach` pixels: an arrow or bar near its tip or on its outer half (unless
/// it's seen end-on and can't be dragged), a ring, or the middle of the bars.
pub fn part_at(request: &Request, pointer: DVec2, reach: f64) -> Option<GizmoPart> {
    let gizmo = request.hover.gizmo?;
    let screen = world_framing::screen(request)?;
    let middle = screen.place(gizmo.origin)?;
    if gizmo.does == Transforming::Scale && pointer.distance(middle) <= reach {
        return Some(GizmoPart::Middle);
    }
    let distance = |axis: usize| match gizmo.does {
        Transforming::Move | Transforming::Scale => {
            let way = screen.place(tip(&gizmo, &screen, axis))? - middle;
            if way.length() < 1.5 * reach {
                return None;
            }
            let t = ((pointer - middle).dot(way) / way.length_squared()).clamp(0.4, 1.0);
            Some(pointer.distance(middle + way * t))
        }
        Transforming::Turn => {
            let places: Vec<DVec2> = ring(&gizmo, &screen, axis).iter().filter_map(|p| screen.place(*p)).collect();
            places.windows(2).map(|ends| to_segment(pointer, ends[0], ends[1])).min_by(f64::total_cmp)
        }
    };
    (0..3)
        .filter_map(|axis| Some((axis, distance(axis).filter(|d| *d <= reach)?)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(axis, _)| GizmoPart::Axis(axis))
}

fn to_segment(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let way = b - a;
    let t = if way == DVec2::ZERO { 0.0 } else { ((p - a).dot(way) / way.length_squared()).clamp(0.0, 1.0) };
    p.distance(a + way * t)
}

/// The pull at a part of `gizmo` when the pointer moved from `from` to `to` (pixels). `None` if it can't be
/// interpreted, for example an axis seen end-on, or a bar pulled through the middle.
pub fn pull(request: &Request, gizmo: &TransformGizmo, part: GizmoPart, from: DVec2, to: DVec2) -> Option<Pull> {
    let screen = world_framing::screen(request)?;
    let observer = world_framing::seen_from(request);
    let grip = Grip { observer: &observer, from: screen.ray(from), to: screen.ray(to) };
    let (length, pixel) = (length(gizmo, &screen), screen.units_per_pixel(gizmo.origin));
    match (part, gizmo.does) {
        (GizmoPart::Middle, _) => {
            // Right and up make it larger, twice as large after the length of a bar.
            let pixels = (to - from).dot(DVec2::new(1.0, -1.0)) / std::f64::consts::SQRT_2;
            Some(Pull::Times { factor: (pixels * pixel / length).exp2(), pixel: pixel / length })
        }
        (GizmoPart::Axis(axis), Transforming::Move) => {
            Some(Pull::Along { way: grip.along(gizmo.origin, gizmo.axes[axis])?, pixel })
        }
        (GizmoPart::Axis(axis), Transforming::Scale) => {
            let (before, now) = grip.places_along(gizmo.origin, gizmo.axes[axis])?;
            let factor = now / before;
            (before > 0.0 && factor > 0.0).then_some(Pull::Times { factor, pixel: pixel / before })
        }
        (GizmoPart::Axis(axis), Transforming::Turn) => {
            let angle = turned(gizmo, axis, length, &grip)?;
            Some(Pull::Round { angle, pixel: Angle::from_radians(pixel / length) })
        }
    }
}

/// The angle of the pointer's motion about an axis, on the ring's plane, or along its nearer side if that plane is
/// nearly edge-on.
fn turned(gizmo: &TransformGizmo, axis: usize, length: f64, grip: &Grip<'_>) -> Option<Angle> {
    /// Sine of the angle below which a pixel would turn too far.
    const EDGE_ON: f64 = 0.2;
    let (origin, normal) = (gizmo.origin, gizmo.axes[axis]);
    if normal.dot(grip.from.direction).abs() < EDGE_ON || normal.dot(grip.to.direction).abs() < EDGE_ON {
        // On the near side the ring goes this way.
        let forward = normal.cross(-grip.from.direction).try_normalize()?;
        return Some(Angle::from_radians(grip.along(origin, forward)? / length));
    }
    let hit = |ray: Ray| {
        let t = normal.dot(origin - ray.origin) / normal.dot(ray.direction);
        (ray.origin + ray.direction * t - origin).try_normalize()
    };
    let (a, b) = (hit(grip.from)?, hit(grip.to)?);
    Some(Angle::from_radians(normal.dot(a.cross(b)).atan2(a.dot(b))))
}

/// Adds the gizmo, if there is one. Nothing hides it. Its letters are those of the fields, T, R and S, which
/// distinguishes it from the axes of the world.
pub(in crate::views) fn in_world(builder: &mut AnnotationBuilder, request: &Request, palette: Palette) {
    let Some(gizmo) = request.hover.gizmo else { return };
    let letter = match gizmo.does {
        Transforming::Move => "T",
        Transforming::Turn => "R",
        Transforming::Scale => "S",
    };
    for (axis, (color, name)) in palette.axes.into_iter().zip(["x", "y", "z"]).enumerate() {
        let width = if gizmo.hovered == Some(GizmoPart::Axis(axis)) { 4.5 } else { 2.5 };
        let arrow = gizmo.does == Transforming::Move;
        let style = LineStyle { color, width, dash: Dash::Solid, hidden: HiddenLines::Shown, arrow };
        let tip = tip(&gizmo, builder.screen, axis);
        let (points, named) = match gizmo.does {
            Transforming::Move | Transforming::Scale => (vec![gizmo.origin, tip], tip),
            Transforming::Turn => {
                let ring = ring(&gizmo, builder.screen, axis);
                let right = |p: &DVec3| builder.screen.place(*p).map_or(f64::NEG_INFINITY, |place| place.x - place.y);
                let named = ring.iter().copied().max_by(|a, b| right(a).total_cmp(&right(b)));
                (ring, named.unwrap_or(tip))
            }
        };
        builder.gear.lines.push(Line::new(points, style));
        if gizmo.does == Transforming::Scale {
            builder.mark_above(tip, MarkShape::Square, 4.5, color);
        }
        let toward = builder.screen.heading(gizmo.origin, named - gizmo.origin);
        builder.text(named, &format!("{letter}_{name}"), toward, SMALL_TYPE, color);
    }
    let (shape, radius) = match gizmo.does {
        Transforming::Scale if gizmo.hovered == Some(GizmoPart::Middle) => (MarkShape::Square, 7.0),
        Transforming::Scale => (MarkShape::Square, 5.0),
        Transforming::Move | Transforming::Turn => (MarkShape::Disc, 3.0),
    };
    builder.mark_above(gizmo.origin, shape, radius, palette.ink);
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::{Camera, Parameters};
    use crate::figure::{Figure, Observer};
    use crate::views::{Hover, SharedScene, Size, View, unlabelled};

    const OBSERVER: Observer =
        Observer { target: DVec3::ZERO, distance: 30.0, azimuth: 40.0, elevation: 25.0, roll: 0.0, parallel: false };

    fn gizmo(does: Transforming) -> TransformGizmo {
        let axes = [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.0, 0.8)];
        TransformGizmo { does, origin: DVec3::new(1.0, 0.5, -1.0), axes, hovered: None }
    }

    fn with(gizmo: TransformGizmo, observer: Observer, test: impl Fn(&Request, &Screen)) {
        let (figure, camera) = (Figure::default(), Camera::new(&Parameters::default()).unwrap());
        let size = Size { width: 600, height: 400, scale: 1.0 };
        let scene = SharedScene::default();
        let request = Request {
            hover: Hover { gizmo: Some(gizmo), ..Hover::default() },
            ..Request::of(&figure, View::World, &camera, &scene, unlabelled(), size)
        }
        .seen_by(Some(observer));
        test(&request, &world_framing::screen(&request).unwrap());
    }

    #[test]
    fn an_arrow_is_picked_at_its_tip_and_moves_its_object_with_the_pointer() {
        let arrows = gizmo(Transforming::Move);
        with(arrows, OBSERVER, |request, screen| {
            for axis in 0..3 {
                let tip = tip(&arrows, screen, axis);
                let place = screen.place(tip).unwrap();
                assert_eq!(part_at(request, place + 1.0, 8.0), Some(GizmoPart::Axis(axis)));
                let goal = screen.place(tip + arrows.axes[axis] * 1.75).unwrap();
                // Taken at its tip, the arrow's line stays under the pointer.
                let Some(Pull::Along { way, pixel }) = pull(request, &arrows, GizmoPart::Axis(axis), place, goal)
                else {
                    panic!("it goes along the axis");
                };
                assert!((way - 1.75).abs() < 1e-9 && pixel > 0.0, "{way}");
            }
            assert_eq!(part_at(request, screen.place(arrows.origin).unwrap(), 4.0), None);
        });
        let along_axis = Observer { azimuth: 90.0, elevation: 0.0, parallel: true, ..OBSERVER };
        with(arrows, along_axis, |request, _| {
            let (from, to) = (DVec2::new(10.0, 10.0), DVec2::new(90.0, 10.0));
            assert_eq!(pull(request, &arrows, GizmoPart::Axis(0), from, to), None);
        });
    }

    #[test]
    fn a_ring_turns_by_the_angle_that_the_pointer_goes_round_it() {
        let rings = TransformGizmo { axes: DVec3::AXES, ..gizmo(Transforming::Turn) };
        with(rings, OBSERVER, |request, screen| {
            for axis in 0..3 {
                let ring = ring(&rings, screen, axis);
                let turned_by = |k: usize, steps: usize| {
                    let (a, b) = (ring[k], ring[(k + steps) % 64]);
                    let (from, to) = (screen.place(a).unwrap(), screen.place(b).unwrap());
                    match pull(request, &rings, GizmoPart::Axis(axis), from, to) {
                        Some(Pull::Round { angle, .. }) => angle.degrees(),
                        other => panic!("{other:?}"),
                    }
                };
                for k in 0..64 {
                    let wanted = 360.0 / 64.0 * 8.0;
                    assert!((turned_by(k, 8) - wanted).abs() < 1e-6, "axis {axis}, {k}: {}", turned_by(k, 8));
                }
                let on_ring = screen.place(ring[5]).unwrap();
                assert!(part_at(request, on_ring, 3.0).is_some());
            }
            assert_eq!(part_at(request, screen.place(rings.origin).unwrap(), 4.0), None);
        });
        // Edge-on, the near side goes to the right for a rotation about an upright axis.
        let level = Observer { elevation: 0.0, parallel: true, ..OBSERVER };
        with(rings, level, |request, screen| {
            let middle = screen.place(rings.origin).unwrap();
            let Some(Pull::Round { angle, pixel }) =
                pull(request, &rings, GizmoPart::Axis(1), middle, middle + DVec2::new(10.0, 0.0))
            else {
                panic!("it goes round");
            };
            assert!((angle.degrees() / pixel.degrees() - 10.0).abs() < 1e-6);
        });
    }

    #[test]
    fn a_bar_scales_as_far_as_its_tip_goes_and_not_through_the_middle() {
        let bars = gizmo(Transforming::Scale);
        with(bars, OBSERVER, |request, screen| {
            let times = |axis: usize, factor: f64| {
                let tip = tip(&bars, screen, axis);
                let goal = bars.origin + (tip - bars.origin) * factor;
                let (from, to) = (screen.place(tip).unwrap(), screen.place(goal).unwrap());
                pull(request, &bars, GizmoPart::Axis(axis), from, to)
            };
            for axis in 0..3 {
                for factor in [0.25, 1.0, 2.5] {
                    let Some(Pull::Times { factor: found, .. }) = times(axis, factor) else { panic!("it scales") };
                    assert!((found - factor).abs() < 1e-9);
                }
                assert_eq!(times(axis, -0.5), None);
            }
            let middle = screen.place(bars.origin).unwrap();
            assert_eq!(part_at(request, middle + 2.0, 6.0), Some(GizmoPart::Middle));
            let all = |by: DVec2| pull(request, &bars, GizmoPart::Middle, middle, middle + by);
            let (Some(Pull::Times { factor: up, .. }), Some(Pull::Times { factor: down, .. })) =
                (all(DVec2::new(20.0, -20.0)), all(DVec2::new(-20.0, 20.0)))
            else {
                panic!("it scales");
            };
            assert!(up > 1.0 && (up * down - 1.0).abs() < 1e-12);
        });
    }
}
