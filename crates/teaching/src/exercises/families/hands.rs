//! Exercises done by hand: setting a camera, and answering before the solution appears.

use glam::DVec3;

use super::cameras::{about, camera, point_inside, small, subject, with_point};
use crate::camera::{Camera, Parameters, Projection};
use crate::exercises::placing::{about_focal_point, around_box, looking_down};
use crate::exercises::worked::inside as steps_inside;
use crate::exercises::{Ask, Exercise, Fact, Mistake, TOLERANCE};
use crate::figure::Figure;
use crate::inspect::quantity::{PointNumber, Quantity};
use crate::numbers::random::Random;
use crate::scene::{ObjectSpec, Preset, Shape};

/// A camera whose view volume is a box along the axes.
pub(super) fn canonical_camera(random: &mut Random) -> Exercise {
    let middle = DVec3::new(small(random, 3), small(random, 3), small(random, 3));
    let half = DVec3::from_array(random.one_of(&[[1.0, 2.0, 3.0], [2.0, 1.0, 1.5], [3.0, 2.0, 1.0], [2.0, 3.0, 4.0]]));
    let model = Parameters {
        position: middle + DVec3::Z * (half.z + 1.0),
        focal_point: middle,
        view_up: DVec3::Y,
        projection: Projection::Parallel,
        height: 2.0 * half.y,
        aspect: half.x / half.y,
        near: 1.0,
        far: 1.0 + 2.0 * half.z,
        ..Parameters::default()
    };
    let mistakes = [
        (Parameters { aspect: half.y / half.x, ..model }, Mistake::AspectInverted),
        (Parameters { height: half.y, ..model }, Mistake::FactorTwo),
    ];
    let steps = around_box(&model, [middle - half, middle + half]);
    let ask = Ask::camera("camera", (model, steps), &mistakes, move |camera| {
        let along = |n: DVec3| n.to_array().iter().any(|x| (x.abs() - 1.0).abs() <= 1e-6);
        let corners = camera.volume_corners().map(|corner| corner - middle);
        let octant = |at: &DVec3| at.to_array().map(|x| x > 0.0);
        let distinct = (0..8).all(|a| (0..a).all(|b| octant(&corners[a]) != octant(&corners[b])));
        let is_corner = |at: &DVec3| (0..3).all(|k| (at[k].abs() - half[k]).abs() <= TOLERANCE * half[k]);
        let off = (corners.iter().sum::<DVec3>() / 8.0).abs();
        vec![
            ("is-parallel", camera.projection() == Projection::Parallel),
            ("looks-along-axis", along(camera.basis().n)),
            ("middle-of-box", off.cmple(half * TOLERANCE).all()),
            ("is-the-box", corners.iter().all(is_corner) && distinct),
        ]
    });
    let mut figure = Figure::of_preset(Preset::Empty);
    let shape = ObjectSpec::new("box", Shape::Box).at(middle.x, middle.y, middle.z);
    figure.scene.objects.push(shape.scaled(half.x, half.y, half.z));
    figure.camera =
        Parameters { position: middle + DVec3::new(6.0, 4.0, 8.0), focal_point: middle, ..Parameters::default() };
    let subject = crate::exercises::Subject { figure, ..Default::default() };
    let facts = vec![("low", (middle - half).into()), ("high", (middle + half).into())];
    Exercise { asks: vec![ask], facts, assumptions: vec!["family-of-cameras"], ..about(subject) }
}

/// Points for comparing two pictures of the house.
const REFERENCE: [DVec3; 6] = [
    DVec3::new(1.0, 0.0, 1.0),
    DVec3::new(-1.0, 0.0, 1.0),
    DVec3::new(1.0, 1.0, -1.0),
    DVec3::new(-1.0, 1.0, -1.0),
    DVec3::new(0.0, 1.5, 0.5),
    DVec3::new(0.5, 0.5, 0.0),
];

/// Tolerance for the positions of points, in NDC.
const NEAR_ENOUGH: f64 = 0.05;

/// The directions in which C is off: around the house, in height, and in its distance from PF. A picture that fits is
/// right, although a farther camera with a smaller angle shows nearly the same.
fn directions(camera: &Camera, wanted: &Camera, fits: bool) -> [(&'static str, bool); 3] {
    let from_focal_point = |camera: &Camera| camera.position() - wanted.focal_point();
    let (now, then) = (from_focal_point(camera), from_focal_point(wanted));
    let round = |at: DVec3| at.x.atan2(at.z).to_degrees();
    let height = |at: DVec3| at.y.atan2(at.x.hypot(at.z)).to_degrees();
    // From −180 to 180: the shorter way round.
    let to_the_right = (round(then) - round(now) + 540.0).rem_euclid(360.0) - 180.0;
    let up = height(then) - height(now);
    let away = then.length() / now.length().max(f64::MIN_POSITIVE);
    let tell = |off: f64, within: f64, [right, more, less]: [&'static str; 3]| match off {
        _ if fits || off.abs() <= within => (right, true),
        _ if off > 0.0 => (more, false),
        _ => (less, false),
    };
    [
        tell(to_the_right, 4.0, ["round-matches", "more-to-the-right", "more-to-the-left"]),
        tell(up, 4.0, ["height-matches", "higher", "lower"]),
        tell(away.ln(), 0.07, ["distance-matches", "farther", "nearer"]),
    ]
}

pub(super) fn match_picture(random: &mut Random) -> Exercise {
    let start = Figure::of_preset(Preset::House);
    let target = Parameters {
        position: DVec3::new(6.0, 0.0, 0.0) + DVec3::new(small(random, 2), 4.0 + small(random, 2), small(random, 5)),
        focal_point: DVec3::new(0.0, 0.5, 0.0),
        view_angle: random.one_of(&[30.0, 40.0, 50.0]),
        aspect: start.camera.aspect,
        near: 1.0,
        far: 40.0,
        ..Parameters::default()
    };
    let wanted = Camera::new(&target);
    let ask = Ask::camera("camera", (target, about_focal_point(&target)), &[], move |camera| {
        let Ok(wanted) = &wanted else { return vec![("picture-matches", false)] };
        let ndc = |camera: &Camera, point: DVec3| {
            let clip = camera.clip_point(point);
            (clip.w > 0.0).then(|| clip.truncate().truncate() / clip.w)
        };
        let near = |point: &DVec3| {
            let places = ndc(camera, *point).zip(ndc(wanted, *point));
            places.is_some_and(|(a, b)| (a - b).length() <= NEAR_ENOUGH)
        };
        let turned = camera.basis().n.dot(wanted.basis().n);
        let tall = camera.window_height() / camera.near() / (wanted.window_height() / wanted.near());
        let fits = REFERENCE.iter().all(near);
        let mut conditions = vec![("same-projection", camera.projection() == wanted.projection())];
        conditions.extend(directions(camera, wanted, fits));
        conditions.push(("same-direction", turned > 0.995));
        conditions.push(match tall {
            _ if (0.93..1.07).contains(&tall) => ("same-angle", true),
            _ if tall > 1.0 => ("angle-smaller", false),
            _ => ("angle-larger", false),
        });
        conditions.push(("picture-matches", fits));
        conditions
    });
    let subject = crate::exercises::Subject { figure: start, ..Default::default() };
    Exercise { asks: vec![ask], facts: Vec::new(), ..about(subject) }
}

pub(super) fn place_camera(random: &mut Random) -> Exercise {
    let [a, b] = [0, 1].map(|_| DVec3::new(small(random, 3), 1.0 + small(random, 1), small(random, 3)));
    let b = if (a - b).length() < 1.5 { a + DVec3::new(2.0, 0.0, 1.0) } else { b };
    let least = random.one_of(&[20.0, 30.0, 40.0]);
    let height: f64 = f64::tan(f64::to_radians(least + 15.0));
    let aside = (b - a).cross(DVec3::Y).normalize_or(DVec3::Z);
    let distance = (b - a).length() * 2.5;
    let model = Parameters {
        position: a + (aside + DVec3::Y * height) * distance,
        focal_point: a,
        view_angle: 60.0,
        near: 0.1,
        far: 100.0,
        ..Parameters::default()
    };
    let ask = Ask::camera("camera", (model, looking_down(&model, b, aside, least + 15.0)), &[], move |camera| {
        let seen = |point: DVec3| {
            let clip = camera.clip_point(point);
            (clip.w > 0.0).then(|| clip.truncate() / clip.w).filter(|ndc| ndc.abs().max_element() <= 1.0)
        };
        let in_middle = seen(a).is_some_and(|ndc| ndc.truncate().length() <= 0.02);
        vec![
            ("a-in-the-middle", in_middle),
            ("b-is-seen", seen(b).is_some()),
            ("b-is-apart", seen(a).zip(seen(b)).is_some_and(|(a, b)| (a - b).truncate().length() >= 0.2)),
            ("from-above", camera.basis().n.y >= f64::sin(f64::to_radians(least)) - 1e-9),
        ]
    });
    let mut figure = Figure::of_preset(Preset::House);
    figure.camera = Parameters { position: DVec3::new(9.0, 1.0, 9.0), ..figure.camera };
    let subject = crate::exercises::Subject { figure, ..Default::default() };
    let subject = with_point(with_point(subject, a), b);
    let facts = vec![("P", a.into()), ("Q", b.into()), ("least", Fact::Angle(least))];
    Exercise { asks: vec![ask], facts, ..about(subject) }
}

pub(super) fn predict_visible(random: &mut Random) -> Exercise {
    let projection = super::cameras::any_projection(random);
    let parameters = camera(random, projection);
    let clip = |point: DVec3| Camera::new(&parameters).ok().map(|camera| camera.clip_point(point));
    let is_seen = |point: DVec3| clip(point).is_some_and(|clip| clip.truncate().abs().max_element() <= clip.w);
    // Not so near a plane that the eye can't tell. In the plane of the eye there is no NDC, so nothing can be decided.
    let is_clear = |point: DVec3| {
        clip(point).is_some_and(|clip| {
            let rest = clip.w - clip.truncate().abs().max_element();
            rest.abs() > 0.05 * clip.w.abs().max(1.0) && clip.w.abs() > 0.05
        })
    };
    // One is visible in any case. If a camera has no point that's clear enough, the last one tried serves.
    let mut first = point_inside(random, &parameters);
    for _ in 0..100 {
        if is_clear(first) {
            break;
        }
        first = point_inside(random, &parameters);
    }
    let mut points = vec![first];
    while points.len() < 3 {
        let point = parameters.focal_point + DVec3::new(small(random, 8), small(random, 8), small(random, 8));
        if is_clear(point) && !points.contains(&point) {
            points.push(point);
        }
    }
    // The visible one isn't always the first.
    points.rotate_left(usize::try_from(random.whole(0, 2)).unwrap_or(0));
    let subject = points.iter().fold(subject(parameters), |subject, point| with_point(subject, *point));
    let names = ["P", "Q", "R"];
    let asks = names.into_iter().zip(&points).enumerate().map(|(k, (name, point))| {
        let ask = Ask::choice(name, &["yes", "no"], usize::from(!is_seen(*point)), &[], steps_inside(&subject, k));
        Ask { quantity: Some(Quantity::Point(k, PointNumber::Inside).into()), ..ask }
    });
    let asks = asks.collect();
    Exercise { asks, ..about(subject) }.with_facts(names.into_iter().zip(points))
}
