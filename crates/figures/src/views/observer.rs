//! The sides from which to see a three-dimensional picture, and the observer that has all of it in the picture.

use glam::{DVec2, DVec3};

use crate::camera::{Basis, Camera};
use crate::figure::Observer;
use crate::figure::observer::half_tangents;
use crate::geometry::Aabb;

use super::{Request, SharedScene, Shot, Size};

/// The share of the picture's width and height that [`enclosing`] leaves free on each side, and its minimum in pixels
/// at scale 1. A label has space there. In a small picture with large letters it's no more than `MOST_MARGIN`.
const MARGIN: f64 = 0.05;
const LEAST_MARGIN: f64 = 26.0;
const MOST_MARGIN: f64 = 0.11;

/// A side to look from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Viewpoint {
    /// From +z, parallel.
    Front,
    /// From +y, parallel.
    Top,
    /// From +x, parallel.
    Side,
    /// From a corner, in perspective.
    #[default]
    Iso,
    /// Along **u**, parallel: the side figure of the notes, with the eye to the left and the far plane to the right.
    AlongU,
    /// Along **v**, parallel: the same from above.
    AlongV,
    /// Along **n**, parallel, in the direction of the camera.
    AlongN,
}

impl Viewpoint {
    /// All, in the order of menus.
    pub const ALL: [Self; 7] =
        [Self::Front, Self::Top, Self::Side, Self::Iso, Self::AlongU, Self::AlongV, Self::AlongN];
}

/// An observer on a side of the origin. Only its direction matters.
pub(super) const fn on_side(azimuth: f64, elevation: f64, parallel: bool) -> Observer {
    Observer { target: DVec3::ZERO, distance: 1.0, azimuth, elevation, roll: 0.0, parallel }
}

impl Viewpoint {
    /// An observer with the direction in a space where the camera has the axes `basis`. `iso` gives the corner.
    pub(super) fn direction(self, iso: Observer, basis: Basis) -> Observer {
        let along = |azimuth, elevation| on_side(azimuth, elevation, true);
        let from = |right, back| along(0.0, 0.0).looking(right, back);
        let Basis { u, v, n } = basis;
        match self {
            Self::Front => along(0.0, 0.0),
            Self::Top => along(0.0, 90.0),
            Self::Side => along(90.0, 0.0),
            Self::Iso => iso,
            Self::AlongU => from(-n, u),
            Self::AlongV => from(-n, v),
            Self::AlongN => from(u, n),
        }
    }
}

/// Towards the eye.
fn eye(o: Observer) -> DVec3 {
    o.axes()[2]
}

/// This direction, or the nearest one in which the eye keeps clear of lines. Along one of `lines` (unit vectors), all
/// points on it would coincide.
pub(super) fn clear_of(own: Observer, lines: &[DVec3]) -> Observer {
    /// From this angle to all lines on, a direction stays. Any new one has an angle of at least `CLEAR`.
    const STAYS: f64 = 18.0;
    const CLEAR: f64 = 26.0;
    let clear = |d: Observer, least: f64| {
        let most = least.to_radians().cos();
        lines.iter().all(|line| line.dot(eye(d)).abs() <= most)
    };
    if clear(own, STAYS) {
        return own;
    }
    // Turning about the vertical keeps the ground as it is, so rising is the second choice.
    let around = (1..=36_u32).flat_map(|i| [1.0, -1.0].map(|side| side * f64::from(i) * 5.0));
    let up = [0.0, 12.0, -12.0, 24.0, -24.0, 36.0];
    up.into_iter()
        .flat_map(|rise| around.clone().map(move |turn| (rise, turn)))
        .map(|(rise, turn)| Observer {
            azimuth: (own.azimuth + turn).rem_euclid(360.0),
            elevation: (own.elevation + rise).clamp(-85.0, 85.0),
            ..own
        })
        .filter(|d| clear(*d, CLEAR))
        .max_by(|a, b| eye(*a).dot(eye(own)).total_cmp(&eye(*b).dot(eye(own))))
        .unwrap_or(own)
}

/// The share of the picture's width and height that [`enclosing`] fills.
fn fill(size: Size) -> DVec2 {
    let pixels = DVec2::new(f64::from(size.width), f64::from(size.height));
    let wanted = LEAST_MARGIN * f64::from(size.scale) / pixels;
    1.0 - 2.0 * wanted.clamp(DVec2::splat(MARGIN), DVec2::splat(MOST_MARGIN))
}

/// The nearest observer in a direction that has all `points` in a picture of this size, with a margin. Points that
/// aren't finite are left out. Without any, the observer looks at the cube \[−1, 1\]³.
pub(super) fn enclosing(points: &[DVec3], direction: Observer, size: Size) -> Observer {
    let Some(bounds) = Aabb::around(points.iter().copied()) else {
        return enclosing(&[DVec3::NEG_ONE, DVec3::ONE], direction, size);
    };
    // Far from the origin coordinates are coarse, so the eye stays many of their steps away.
    let least = (bounds.radius() * 0.05).max(bounds.center().abs().max_element() * 1e-13);
    let least = if least > 0.0 { least } else { 1e-9 };
    let target = bounds.center();
    let [right, up, back] = direction.axes();
    // Each side of the view volume is pushed out until it touches the outermost point, a maximum of (across + t ·
    // depth), after `[0]` Eq. (5.9). Opposite sides then meet in the eye.
    let support = |axis: DVec3, t: f64| {
        let slope = if direction.parallel { 0.0 } else { t };
        points
            .iter()
            .filter(|p| p.is_finite())
            .map(|&p| p - target)
            .map(|d| axis.dot(d) + slope * back.dot(d))
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let DVec2 { x: tan_x, y: tan_y } = half_tangents(size.aspect()) * fill(size);
    let (r, l) = (support(right, tan_x), support(-right, tan_x));
    let (t, b) = (support(up, tan_y), support(-up, tan_y));
    let distance = ((r + l) / (2.0 * tan_x)).max((t + b) / (2.0 * tan_y)).max(least);
    let target = target + right * ((r - l) / 2.0) + up * ((t - b) / 2.0);
    Observer { target, distance, ..direction }
}

/// True if an observer has all `points` in its picture, to the very border. Points that aren't finite don't count.
pub(super) fn holds(observer: &Observer, points: &[DVec3], size: Size) -> bool {
    let [right, up, back] = observer.axes();
    let tangents = half_tangents(size.aspect());
    points.iter().filter(|p| p.is_finite()).map(|&p| p - observer.target).all(|d| {
        let depth = observer.distance - if observer.parallel { 0.0 } else { back.dot(d) };
        right.dot(d).abs() <= tangents.x * depth && up.dot(d).abs() <= tangents.y * depth
    })
}

/// A figure whose observers serve others.
#[derive(Clone, Debug, PartialEq)]
pub struct ObserverOf {
    /// The content of its pictures.
    pub shot: Shot,
    /// The camera of that figure.
    pub camera: Camera,
    /// The scene of that figure.
    pub scene: SharedScene,
}

impl ObserverOf {
    /// The observer of its picture of the kind and the size of another one; `None` for an image.
    pub fn observer(&self, like: &Request) -> Option<Observer> {
        let own = Request::new(&self.shot, like.view, &self.camera, &self.scene, like.labels, like.size);
        own.seen_from()
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]
    use super::*;
    use crate::camera::Camera;

    const ISO: Observer = on_side(35.0, 25.0, false);

    const BASIS: Basis = Basis { u: DVec3::X, v: DVec3::Y, n: DVec3::Z };

    fn cloud() -> Vec<DVec3> {
        let b = Aabb { min: DVec3::new(-2.0, 0.0, -1.0), max: DVec3::new(3.0, 1.0, 7.0) };
        b.corners().to_vec()
    }

    fn ndc(camera: &Camera, p: DVec3) -> DVec3 {
        let c = camera.clip_point(p);
        c.truncate() / c.w
    }

    #[test]
    fn enclosing_has_every_point_in_the_picture_and_touches_two_sides() {
        for viewpoint in Viewpoint::ALL {
            for (width, height) in [(300, 600), (800, 800), (1200, 600)] {
                let size = Size { width, height, scale: 1.0 };
                let o = enclosing(&cloud(), viewpoint.direction(ISO, BASIS), size);
                let camera = o.camera(Aabb::around(cloud()), size.aspect()).unwrap();
                let points: Vec<_> = cloud().iter().map(|&p| ndc(&camera, p)).collect();
                let margins = (f64::from(width) * 0.05).max(26.0) / f64::from(width);
                let over = (f64::from(height) * 0.05).max(26.0) / f64::from(height);
                let least_x = points.iter().map(|p| 0.5 - 0.5 * p.x.abs()).fold(1.0, f64::min);
                let least_y = points.iter().map(|p| 0.5 - 0.5 * p.y.abs()).fold(1.0, f64::min);
                let slack = (least_x - margins, least_y - over);
                assert!(slack.0.min(slack.1).abs() < 1e-9 && slack.0.max(slack.1) > -1e-9, "{viewpoint:?} {slack:?}");
                assert!(points.iter().all(|p| p.z.abs() < 1.0), "{viewpoint:?}: inside the clipping planes");
                assert!(holds(&o, &cloud(), size), "with margins");
                // The margins are a tenth at least. A fifth nearer, something is outside.
                let nearer = Observer { distance: 0.5 * o.distance, ..o };
                assert!(!holds(&nearer, &cloud(), size), "{viewpoint:?}");
            }
        }
    }

    #[test]
    fn viewpoints_look_from_their_side() {
        let size = Size { width: 400, height: 400, scale: 1.0 };
        let eye = |p: Viewpoint| enclosing(&cloud(), p.direction(ISO, BASIS), size).axes()[2];
        assert!((eye(Viewpoint::Front) - DVec3::Z).length() < 1e-15);
        assert!((eye(Viewpoint::Top) - DVec3::Y).length() < 1e-15);
        assert!((eye(Viewpoint::Side) - DVec3::X).length() < 1e-15);
        let top = enclosing(&cloud(), Viewpoint::Top.direction(ISO, BASIS), size);
        assert!((top.axes()[0] - DVec3::X).length() < 1e-15, "on a map, x goes to the right");
        assert!((top.axes()[1] + DVec3::Z).length() < 1e-15, "and z towards the reader");
    }

    #[test]
    fn an_eye_moves_aside_from_lines_and_stays_otherwise() {
        for azimuth in 0..72 {
            for elevation in [-60.0, 0.0, 20.0, 70.0] {
                let before = Observer { azimuth: f64::from(azimuth) * 5.0, elevation, ..ISO };
                let angle = |d: Observer| {
                    DVec3::AXES.map(|line| line.dot(eye(d)).abs().acos().to_degrees()).into_iter().fold(90.0, f64::min)
                };
                let after = clear_of(before, &DVec3::AXES);
                if angle(before) >= 18.0 {
                    assert_eq!(after, before);
                } else {
                    assert!(angle(after) > 25.9 && eye(after).dot(eye(before)) > 0.5, "{before:?} {after:?}");
                }
            }
        }
    }
}
