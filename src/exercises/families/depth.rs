//! Depth: the resolution of a depth buffer, the painter's order, and the difference between a zoom and a dolly.

use glam::DVec3;

use super::cameras::{about, camera, numbers, plain, point_inside, subject, with_point};
use crate::camera::{Camera, Parameters, Projection};
use crate::exercises::textbook::half_tangent;
use crate::exercises::worked::{Worked, angle, named};
use crate::exercises::{Ask, Entry, Exercise, Fact, Kind, Mistake, Slip, Slips, Table, Unit};
use crate::explain::{Formula, Function, minus, over, plus, times};

pub(super) const DEPTH_RESOLUTION: Entry =
    Entry::family("depth-resolution", "[0] (5.25), [2]", |seed, _| resolution(seed));
pub(super) const PAINTER: Entry = Entry::family("painter", "[2]", |seed, _| painter(seed));
pub(super) const ZOOM_OR_DOLLY: Entry =
    Entry::family("zoom-or-dolly", "[0] §5.6, (5.5)", |seed, _| zoom_or_dolly(seed));

fn resolution(seed: u64) -> Exercise {
    let mut random = numbers("depth-resolution", seed);
    let near = random.one_of(&[0.1, 0.5, 1.0, 2.0]);
    let far = near * random.one_of(&[10.0, 50.0, 100.0, 1000.0]);
    let bits = random.one_of(&[8.0_f64, 10.0, 12.0, 16.0]);
    let distance = near + (far - near) * random.one_of(&[0.25, 0.5, 0.75]);
    let z = move |slips: Slips| {
        let (near, far) = if slips.has(Slip::NearFarAsCoordinates) { (-near, -far) } else { (near, far) };
        let ndc = (far + near) / (far - near) - 2.0 * far * near / ((far - near) * distance);
        if slips.has(Slip::DepthNotMapped) { ndc } else { f64::midpoint(ndc, 1.0) }
    };
    let step = move |slips: Slips| {
        let steps = bits.exp2() - 1.0;
        let slope = far * near / ((far - near) * distance * distance);
        let slope = if slips.has(Slip::DepthNotMapped) { 2.0 * slope } else { slope };
        // The length of the buffer for a unit of depth, and not the depth of a step.
        let found = 1.0 / (slope * steps);
        if slips.has(Slip::Inverted) { 1.0 / found } else { found }
    };
    let [f, b, d, n] = [
        named("F", "F", near),
        named("B", "B", far),
        named("d", "d", distance),
        named("2^b − 1", "(2^b - 1)", bits.exp2() - 1.0),
    ];
    let range = || minus(b, f);
    let first = over(plus(b, f), range());
    let second = over(times([2.0.into(), b.into(), f.into()]), times([range(), d.into()]));
    let ndc = named("z_n", "z_n", 2.0 * z(Slips::NONE) - 1.0);
    let worked = Worked::new("depth", "(5.13), (5.25)")
        .row(ndc, minus(first, second))
        .row(named("Z", "Z", z(Slips::NONE)), over(plus(ndc, 1.0), 2.0));
    let resolution = Worked::new("depth-step", "(5.25)").row(
        named("Δd", r"\Delta d", step(Slips::NONE)),
        over(times([range(), d.into(), d.into()]), times([b.into(), f.into(), n.into()])),
    );
    let value = step(Slips::NONE);
    let asks = vec![
        Ask::computed("Z", Kind::Number, vec![worked.clone()], move |slips| Some(Table::number(z(slips)))).within(1e-4),
        Ask::computed("step", Kind::Number, vec![worked, resolution], move |slips| Some(Table::number(step(slips))))
            .within(1e-3 * value)
            .in_unit(Unit::Scene),
    ];
    let facts = [("F", near), ("B", far), ("d", distance), ("bits", bits)];
    Exercise { asks, facts: facts.map(|(name, value)| (name, Fact::Number(value))).to_vec(), ..plain() }
}

fn painter(seed: u64) -> Exercise {
    let mut random = numbers("painter", seed);
    let projection = super::cameras::any_projection(&mut random);
    let parameters = camera(&mut random, projection);
    let camera = Camera::new(&parameters);
    let depth = |point: DVec3| camera.as_ref().map_or(0.0, |camera| -camera.view_point(point).z);
    let points = loop {
        let points: Vec<DVec3> = (0..4).map(|_| point_inside(&mut random, &parameters)).collect();
        let mut depths: Vec<f64> = points.iter().map(|point| depth(*point)).collect();
        depths.sort_by(f64::total_cmp);
        if depths.windows(2).all(|pair| pair[1] - pair[0] > 0.05) {
            break points;
        }
        // A volume in which no four small points are apart: points beside it will do.
        if depths.windows(2).all(|pair| pair[1] - pair[0] <= 0.05) {
            let along = (parameters.focal_point - parameters.position).normalize();
            break (0..4).map(|k| parameters.focal_point + along * f64::from((k * 3) % 4)).collect();
        }
    };
    let depths: Vec<f64> = points.iter().map(|point| depth(*point)).collect();
    let order = |depths: &[f64]| {
        let mut order: Vec<u8> = (1..=4).collect();
        order.sort_by(|a, b| depths[usize::from(*b) - 1].total_cmp(&depths[usize::from(*a) - 1]));
        order.into_iter().map(f64::from).collect::<Vec<f64>>()
    };
    let right = order(&depths);
    let names = ["d_1", "d_2", "d_3", "d_4"];
    let subject = points.iter().fold(subject(parameters), |subject, point| with_point(subject, *point));
    let steps = {
        let n = camera.as_ref().map_or(DVec3::Z, |camera| camera.basis().n);
        let parts = [("n_x", n.x), ("n_y", n.y), ("n_z", n.z)].map(|(name, value)| named(name, name, value));
        let offsets = [["C_x − P_x", "C_x - P_x"], ["C_y − P_y", "C_y - P_y"], ["C_z − P_z", "C_z - P_z"]];
        points.iter().enumerate().fold(Worked::new("depths", "(5.7)"), |step, (k, point)| {
            let by = parameters.position - *point;
            let terms = (0..3).map(|c| times([parts[c].into(), named(offsets[c][0], offsets[c][1], by[c]).into()]));
            step.row(named(names[k], names[k], depths[k]), crate::explain::sum(terms))
        })
    };
    let depth_ask = {
        let depths = depths.clone();
        Ask::computed("depths", Kind::Vector(4), vec![steps.clone()], move |slips| {
            let sign = if slips.any(&[Slip::ViewDepthSign, Slip::NReversed]) { -1.0 } else { 1.0 };
            Some(Table::column(&depths.iter().map(|depth| sign * depth).collect::<Vec<_>>()))
        })
        .in_unit(Unit::Scene)
    };
    let order_ask = Ask::computed("order", Kind::Vector(4), vec![steps], move |slips| {
        let order: Vec<f64> =
            if slips.has(Slip::OrderReversed) { right.iter().rev().copied().collect() } else { right.clone() };
        Some(Table::column(&order))
    });
    let facts: Vec<(&'static str, Fact)> = ["P1", "P2", "P3", "P4"]
        .into_iter()
        .zip(&points)
        .map(|(n, p)| (n, Fact::Tuple(p.to_array().to_vec())))
        .collect();
    let mut exercise = Exercise { asks: vec![depth_ask, order_ask.whole()], ..about(subject) };
    exercise.facts.extend(facts);
    exercise
}

fn zoom_or_dolly(seed: u64) -> Exercise {
    let mut random = numbers("zoom-or-dolly", seed);
    let parameters = Parameters {
        position: DVec3::Z * random.one_of(&[6.0, 8.0, 10.0, 12.0]),
        view_angle: random.one_of(&[60.0, 90.0, 40.0, 50.0]),
        focal_point: DVec3::ZERO,
        near: 1.0,
        far: 50.0,
        ..Parameters::default()
    };
    let (size, behind) = (random.one_of(&[1.0, 2.0, 1.5]), random.one_of(&[4.0, 6.0, 10.0]));
    let factor = random.one_of(&[2.0, 1.5, 3.0, 4.0]);
    let distance = parameters.position.z;
    let share = move |slips: Slips, zoom: f64, distance: f64| {
        let zoomed = if slips.has(Slip::ZoomOnAngle) {
            half_tangent(parameters.view_angle / zoom, slips)
        } else {
            half_tangent(parameters.view_angle, slips) / zoom
        };
        size / (2.0 * distance * zoomed)
    };
    let ask = |name: &str, zoom: f64, dolly: f64, further: f64| {
        let at = distance / dolly + further;
        let d = named("d", "d", at);
        let tangent = Formula::Of(Function::Tangent, Box::new(over(angle("θ", r"\theta", parameters.view_angle), 2.0)));
        let tangent = if zoom == 1.0 { tangent } else { over(tangent, named("s", "s", zoom)) };
        let formula = over(named("h", "h", size), times([2.0.into(), d.into(), tangent]));
        let value = share(Slips::NONE, zoom, at);
        let moved = over(named("D", "D", distance), named("f", "f", dolly));
        let moved = if further > 0.0 { plus(moved, named("e", "e", further)) } else { moved };
        let step = Worked::new("share", "(5.5)").row(d, moved).row(named("h'", "h'", value), formula);
        Ask::computed(name, Kind::Number, vec![step], move |slips| {
            let by = |factor: f64| if slips.has(Slip::FactorInverted) { 1.0 / factor } else { factor };
            let (zoom, dolly) = if slips.any(&[Slip::Dollied, Slip::Zoomed]) { (dolly, zoom) } else { (zoom, dolly) };
            Some(Table::number(share(slips, by(zoom), distance / by(dolly) + further)))
        })
    };
    let ratio = {
        let [d, e, f] = [("D", distance), ("e", behind), ("f", factor)].map(|(name, value)| named(name, name, value));
        let nearer = || over(d, f);
        Worked::new("ratio", "(5.5)")
            .row(named("r", "r", (distance + behind) / distance), over(plus(d, e), d))
            .row(named("r'", "r'", (distance / factor + behind) * factor / distance), over(plus(nearer(), e), nearer()))
    };
    let asks = vec![
        ask("before", 1.0, 1.0, 0.0),
        ask("zoomed", factor, 1.0, 0.0),
        ask("dollied", 1.0, factor, 0.0),
        ask("zoomed_behind", factor, 1.0, behind),
        ask("dollied_behind", 1.0, factor, behind),
        Ask::choice("changes", &["zoom", "dolly"], 1, &[(0, Mistake::OtherOperation)], vec![ratio]),
    ];
    let mut exercise =
        Exercise { asks, ..about(subject(Parameters { projection: Projection::Perspective, ..parameters })) };
    let facts = [("h", size), ("e", behind), ("s", factor), ("D", distance)];
    exercise.facts.extend(facts.map(|(name, value)| (name, Fact::Number(value))));
    exercise
}
