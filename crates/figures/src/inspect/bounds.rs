//! The proof beside the numbers: for each number of a report an interval that holds the exact one, and the condition of
//! the questions that they answer.

use serde::Serialize;
use serde_json::Value;

use super::{BasisReport, PointReport, RayReport, Report, Whole, WindowReport, unsigned};
use crate::camera::{Convention, ImageSize, Ndc, Operation, Parameters, Viewport};
use crate::chain::real::Real;
use crate::chain::{Chain, Condition, Enclosure, Gradient, Matrix, Vector};

/// A report with an interval for each of its numbers, and the conditions.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// The report with the lower end of each interval, and with the upper one. NaN if a number isn't enclosed. The
    /// camera's parameters, the lens and the planes are those of the report.
    pub ends: [Report; 2],
    /// How much the questions themselves lose.
    pub condition: Conditions,
}

/// The condition of each map from the figure's numbers to a result; `None` if it's infinite. See [`Condition`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Conditions {
    /// Of **u**, **v**, **n**.
    pub basis: Option<f64>,
    /// Of M_v.
    pub view_matrix: Option<f64>,
    /// Of M_p.
    pub projection_matrix: Option<f64>,
    /// Of the inverse of M_p M_v.
    pub inverse_view_projection: Option<f64>,
}

/// The parts of a report that have no bounds.
const WITHOUT: [&str; 6] = ["camera", "lens", "planes", "cameras", "pairs", "warnings"];

fn chain<R: Real>(p: &Parameters, operations: &[Operation], convention: Convention) -> Chain<R> {
    operations.iter().fold(Chain::new(p), |chain, operation| chain.after(operation, convention))
}

impl Conditions {
    /// The conditions of a camera after operations, in a convention of NDC.
    pub fn new(p: &Parameters, operations: &[Operation], convention: Convention, ndc: Ndc) -> Self {
        let chain = chain::<Gradient>(p, operations, convention);
        let inverse = chain.inverse_view_matrix().product(&chain.inverse_projection_matrix(ndc));
        let of = |m: Matrix<Gradient>| Condition::of(m.0.iter().flatten()).map(|condition| condition.number);
        Self {
            basis: Condition::of(chain.basis.iter().flat_map(|axis| &axis.0)).map(|condition| condition.number),
            view_matrix: of(chain.view_matrix()),
            projection_matrix: of(chain.projection_matrix(ndc)),
            inverse_view_projection: of(inverse),
        }
    }
}

impl Bounds {
    /// The bounds of a report about the camera of `p` after operations.
    pub fn new(
        report: &Report,
        (p, operations, convention): (&Parameters, &[Operation], Convention),
        ndc: Ndc,
        (image, viewport): (ImageSize, Option<Viewport>),
    ) -> Self {
        let chain = chain::<Enclosure>(p, operations, convention);
        let viewport = viewport.unwrap_or_else(|| Viewport::whole(image));
        Self {
            ends: [0, 1].map(|end| of_chain(report, &chain, ndc, (image, viewport), end)),
            condition: Conditions::new(p, operations, convention, ndc),
        }
    }

    /// The bounds in JSON: the numbers of the report under the same names and in the same shapes, each replaced by
    /// \[low, high\], or by null if it isn't enclosed.
    pub fn to_json(&self) -> Value {
        // Everything in a report can become a JSON value.
        let [low, high] = self.ends.each_ref().map(|report| serde_json::to_value(report).unwrap_or_default());
        let mut all = pairs(&low, &high).unwrap_or_default();
        if let Some(parts) = all.as_object_mut() {
            parts.retain(|name, _| !WITHOUT.contains(&name.as_str()));
        }
        all
    }
}

/// The pair of each two numbers at the same place. `None` for booleans and names.
fn pairs(low: &Value, high: &Value) -> Option<Value> {
    Some(match (low, high) {
        (Value::Array(low), Value::Array(high)) => low.iter().zip(high).filter_map(|(a, b)| pairs(a, b)).collect(),
        (Value::Object(low), Value::Object(high)) => {
            let fields = low.iter().zip(high.values());
            Value::Object(fields.filter_map(|((name, a), b)| Some((name.clone(), pairs(a, b)?))).collect())
        }
        (Value::Number(_), Value::Number(_)) => Value::Array(vec![low.clone(), high.clone()]),
        (Value::Bool(_) | Value::String(_), _) => return None,
        _ => Value::Null,
    })
}

/// A report with one end of each interval.
fn of_chain(
    report: &Report,
    chain: &Chain<Enclosure>,
    ndc: Ndc,
    (image, viewport): (ImageSize, Viewport),
    end: usize,
) -> Report {
    let one = |x: &Enclosure| x.ends().map_or(f64::NAN, |ends| unsigned(ends[end]));
    let floor = |x: &Enclosure| Whole(one(x).floor());
    let three = |v: &Vector<Enclosure>| v.0.each_ref().map(one);
    let rows = |m: Matrix<Enclosure>| m.0.map(|row| row.each_ref().map(one));
    let ([u, v, n], [left, right, bottom, top]) = (&chain.basis, chain.given.window.each_ref().map(one));
    let [width, height] = chain.given.window_size();
    let (view, projection) = (chain.view_matrix(), chain.projection_matrix(ndc));
    let point = |printed: &PointReport| {
        let point = chain.point(printed.world.into(), ndc, image, &viewport);
        let mut clip = point.clip.each_ref().map(one);
        if printed.ndc.is_none() {
            // A point in the plane of the eye but for the rounding of its coordinates has w = 0.
            clip[3] = if end == 0 { clip[3].min(0.0) } else { clip[3].max(0.0) };
        }
        PointReport {
            world: printed.world,
            view: three(&point.view),
            clip,
            ndc: printed.ndc.map(|_| point.ndc.each_ref().map(one)),
            window: printed.window.map(|_| point.window.each_ref().map(one)),
            pixel: printed.pixel.map(|_| point.image.each_ref().map(floor)),
            viewport: printed.viewport.map(|_| {
                let [x, y, z] = &point.viewport;
                (floor(x), floor(y), one(z))
            }),
            inside: printed.inside,
        }
    };
    let ray = |printed: &RayReport| {
        let [origin, direction] = chain.ray(image, printed.pixel).each_ref().map(three);
        RayReport { pixel: printed.pixel, origin, direction }
    };
    Report {
        dop: three(&n.opposite()),
        distance: one(&chain.distance),
        basis: BasisReport { u: three(u), v: three(v), n: three(n) },
        window: WindowReport {
            left,
            right,
            bottom,
            top,
            width: one(&width),
            height: one(&height),
            aspect: one(&(width / height)),
        },
        view_projection_matrix: rows(projection.product(&view)),
        view_matrix: rows(view),
        projection_matrix: rows(projection),
        inverse_view_matrix: rows(chain.inverse_view_matrix()),
        inverse_projection_matrix: rows(chain.inverse_projection_matrix(ndc)),
        volume_corners: chain.volume_corners().each_ref().map(three),
        points: report.points.iter().map(point).collect(),
        rays: report.rays.iter().map(ray).collect(),
        ..report.clone()
    }
}

/// The digits of a number that an interval proves, up to 17: log₁₀ of its size over its width.
pub fn proved_digits([low, high]: [f64; 2]) -> f64 {
    let (width, size) = (high - low, low.abs().max(high.abs()));
    if width == 0.0 { 17.0 } else { (size / width).log10().clamp(0.0, 17.0) }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::camera::{Camera, Projection, ViewWindow};
    use crate::figure::Figure;
    use crate::inspect::camera_after;
    use crate::numbers::random::Random;
    use glam::DVec3;

    /// The printed numbers that aren't in their intervals, by their paths.
    fn outside(printed: &Value, bounds: &Value, at: &str, found: &mut Vec<String>) {
        match (printed, bounds) {
            (Value::Number(x), Value::Array(ends)) => {
                let [low, high] = [0, 1].map(|end| ends[end].as_f64().unwrap());
                let x = x.as_f64().unwrap();
                if !(low..=high).contains(&x) {
                    found.push(format!("{at}: {x:e} in {low:e} … {high:e}"));
                }
            }
            (Value::Array(printed), Value::Array(bounds)) => {
                assert_eq!(printed.len(), bounds.len(), "{at}");
                for (i, (x, pair)) in printed.iter().zip(bounds).enumerate() {
                    outside(x, pair, &format!("{at}.{i}"), found);
                }
            }
            (Value::Object(printed), Value::Object(bounds)) => {
                for (name, x) in printed.iter().filter(|(_, x)| !x.is_boolean()) {
                    outside(x, &bounds[name], &format!("{at}.{name}"), found);
                }
            }
            (_, Value::Null) => {}
            _ => panic!("{at}: {printed} has {bounds}"),
        }
    }

    fn all_outside(report: &Report, bounds: &Bounds) -> Vec<String> {
        let (printed, bounds) = (serde_json::to_value(report).unwrap(), bounds.to_json());
        let mut found = Vec::new();
        assert_eq!(bounds.as_object().unwrap().len(), 12);
        for (name, bounds) in bounds.as_object().unwrap() {
            outside(&printed[name], bounds, name, &mut found);
        }
        found
    }

    fn random_figure(random: &mut Random) -> Figure {
        let mut figure = Figure::default();
        let p = &mut figure.camera;
        (p.position, p.focal_point) = (random.direction() * random.between(2.0, 9.0), random.direction());
        p.view_up = random.direction();
        p.view_angle = random.between(1.0, 170.0);
        p.near = random.between(0.01, 0.9);
        if random.between(0.0, 1.0) < 0.4 {
            p.projection = Projection::Parallel;
        }
        if random.between(0.0, 1.0) < 0.4 {
            let mut side = |from: f64, to: f64| random.between(from, to);
            let (left, right, bottom, top) = (side(-1.0, 0.0), side(0.1, 1.0), side(-1.0, 0.0), side(0.1, 1.0));
            p.window = Some(ViewWindow { left, right, bottom, top });
        }
        figure
    }

    /// Of random figures, each with operations, points and pixels: what `of` says about report and bounds.
    fn each(seed: u64, mut of: impl FnMut(&Report, &Bounds, &Camera)) {
        let mut random = Random::new(seed, 0);
        for i in 0..300 {
            let figure = random_figure(&mut random);
            let operations: Vec<Operation> =
                [format!("azimuth={}", random.between(-90.0, 90.0)), "elevation=30".to_owned(), "zoom=1.7".to_owned()]
                    [..i % 4]
                    .iter()
                    .map(|text| text.parse().unwrap())
                    .collect();
            let Ok(camera) = camera_after(&figure.camera, &operations, Convention::RightHand) else { continue };
            let ndc = Ndc::ALL[i % 20];
            let Ok(space) = camera.clip_space(ndc) else { continue };
            let (points, pixels) = ([random.direction(), DVec3::ZERO], [[3, 700], [-5, 2]]);
            let report = Report::of(&space, figure.image, figure.viewport, &points, &pixels).unwrap();
            let way = (&figure.camera, &operations[..], Convention::RightHand);
            of(&report, &Bounds::new(&report, way, ndc, (figure.image, figure.viewport)), &camera);
        }
    }

    #[test]
    fn every_printed_number_is_in_its_interval() {
        let mut reports = 0;
        each(1, |report, bounds, _| {
            reports += 1;
            assert_eq!(all_outside(report, bounds), Vec::<String>::new());
        });
        assert!(reports > 200, "{reports}");
    }

    /// One step of the printed numbers is wrong: **u**, **v**, **n** are rounded before −u · C, −v · C, −n · C.
    #[test]
    fn a_number_after_a_wrong_step_leaves_its_interval() {
        let (mut reports, mut left) = (0, 0);
        each(2, |report, bounds, camera| {
            let mut wrong = report.clone();
            for (i, axis, _) in camera.basis().named() {
                wrong.view_matrix[usize::from(i)][3] = -axis.dot(camera.position());
            }
            reports += 1;
            left += usize::from(all_outside(&wrong, bounds).iter().any(|path| path.starts_with("view_matrix.")));
            // 1 + ε times a number is another one, outside unless the interval is a few units wide.
            wrong = report.clone();
            wrong.projection_matrix[1][1] *= 1.0 + 4.0 * f64::EPSILON;
            assert_eq!(all_outside(&wrong, bounds).len(), 1);
        });
        assert!(left * 10 > reports * 5, "{left} of {reports}");
    }

    #[test]
    fn a_point_in_the_plane_of_the_eye_has_no_bounds_behind_the_division() {
        let figure = Figure::default();
        let camera = Camera::new(&figure.camera).unwrap();
        let beside = camera.position() + camera.basis().u * 2.0;
        let report = Report::of(&camera.notes_clip_space(), figure.image, None, &[beside], &[]).unwrap();
        let bounds =
            Bounds::new(&report, (&figure.camera, &[], Convention::RightHand), Ndc::default(), (figure.image, None));
        assert_eq!(all_outside(&report, &bounds), Vec::<String>::new());
        let point = &bounds.to_json()["points"][0];
        assert!(point["ndc"].is_null() && point["pixel"].is_null(), "{point}");
        assert!(point["clip"][3][0].as_f64().unwrap() <= 0.0 && point["clip"][3][1].as_f64().unwrap() >= 0.0);
    }

    #[test]
    fn digits_are_those_on_which_the_ends_agree() {
        assert_eq!(proved_digits([2.0, 2.0]), 17.0);
        assert_eq!(proved_digits([0.99, 1.0]).round(), 2.0);
        assert_eq!(proved_digits([-1.0, 1.0]), 0.0);
    }
}
