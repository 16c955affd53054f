//! Depth: the resolution of a depth buffer, the painter's order, and the difference between a zoom and a dolly.

use glam::DVec3;

use super::cameras::{about, camera, plain, point_inside, small, subject, with_point};
use crate::camera::{Camera, Parameters, Projection};
use crate::exercises::textbook::half_tangent;
use crate::exercises::worked::{Worked, angle, named};
use crate::exercises::{Ask, Exercise, Kind, Mistake, Nature, Slip, Slips, Table, Unit};
use crate::explain::{Formula, Function, minus, over, plus, times};
use crate::numbers::random::Random;

pub(super) fn resolution(random: &mut Random) -> Exercise {
    let near = random.one_of(&[0.1, 0.5, 1.0, 2.0]);
    let far = near * random.one_of(&[10.0, 50.0, 100.0, 20.0]);
    let bits = random.one_of(&[8.0_f64, 10.0, 12.0, 16.0]);
    let distance = near + (far - near) * random.one_of(&[0.25, 0.5, 0.75]);
    let z = move |slips: Slips| {
        let (near, far) = if slips.has(Slip::NearFarAsCoordinates) { (-near, -far) } else { (near, far) };
        let term = if slips.has(Slip::DepthTermHalved) { 1.0 } else { 2.0 };
        let ndc = (far + near) / (far - near) - term * far * near / ((far - near) * distance);
        if slips.has(Slip::LinearDepth) {
            return (distance - near) / (far - near);
        }
        if slips.has(Slip::DepthNotMapped) { ndc } else { f64::midpoint(ndc, 1.0) }
    };
    let step = move |slips: Slips| {
        let is_near = slips.has(Slip::ApproximateStep);
        let steps = if is_near || slips.has(Slip::PowerOfTwo) { bits.exp2() } else { bits.exp2() - 1.0 };
        let range = if is_near || slips.has(Slip::FarForgotten) { far } else { far - near };
        let slope = far * near / (range * distance * distance);
        let slope = if slips.has(Slip::DepthTermHalved) { slope / 2.0 } else { slope };
        let slope = if slips.has(Slip::DepthNotMapped) { 2.0 * slope } else { slope };
        if slips.has(Slip::StepNotConverted) {
            return 1.0 / steps;
        }
        let slope = if slips.has(Slip::LinearDepth) { 1.0 / (far - near) } else { slope };
        // The length in the buffer for a unit of depth, not the depth of a step.
        let found = 1.0 / (slope * steps);
        if slips.has(Slip::Inverted) { 1.0 / found } else { found }
    };
    let [f, b, d, n] = [
        named("F", "F", near),
        named("B", "B", far),
        named("d", "d", distance),
        named("(2^b − 1)", "(2^b - 1)", bits.exp2() - 1.0),
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
    let asks = vec![
        Ask::computed("Z", Kind::Number, vec![worked.clone()], move |slips| Some(Table::number(z(slips)))).within(1e-4),
        Ask::computed("step", Kind::Number, vec![worked, resolution], move |slips| Some(Table::number(step(slips))))
            .of_nature(Nature::Size)
            .in_unit(Unit::Scene),
    ];
    let facts = [("F", near), ("B", far), ("d", distance), ("bits", bits)];
    Exercise { asks, ..plain() }.with_facts(facts)
}

/// The place of each of four things in an order.
fn ranks(order: &[f64]) -> Vec<f64> {
    let place = |thing: u8| order.iter().position(|at| *at == f64::from(thing));
    let number = |place: usize| u8::try_from(place + 1).ok().map(f64::from);
    (1..=4).filter_map(place).filter_map(number).collect()
}

pub(super) fn painter(random: &mut Random) -> Exercise {
    let projection = super::cameras::any_projection(random);
    let parameters = camera(random, projection);
    let camera = Camera::new(&parameters);
    let depth = |point: DVec3| camera.as_ref().map_or(0.0, |camera| -camera.view_point(point).z);
    let beside =
        |random: &mut Random| parameters.focal_point + DVec3::new(small(random, 3), small(random, 3), small(random, 3));
    let order = |depths: &[f64]| {
        let mut order: Vec<u8> = (1..=4).collect();
        order.sort_by(|a, b| depths[usize::from(*b) - 1].total_cmp(&depths[usize::from(*a) - 1]));
        order.into_iter().map(f64::from).collect::<Vec<f64>>()
    };
    let distances =
        |points: &[DVec3]| -> Vec<f64> { points.iter().map(|point| (*point - parameters.position).length()).collect() };
    // Attempts to find points inside the volume for which the distance from C, or the place of each in the order, gives
    // another answer. If there are none, points beside it serve.
    const TRIES_INSIDE: usize = 200;
    let mut tries = 0..TRIES_INSIDE;
    let points = loop {
        let is_inside = tries.next().is_some();
        let mut one = |_| if is_inside { point_inside(random, &parameters) } else { beside(random) };
        let points: Vec<DVec3> = (0..4).map(&mut one).collect();
        let depths: Vec<f64> = points.iter().map(|point| depth(*point)).collect();
        let mut sorted = depths.clone();
        sorted.sort_by(f64::total_cmp);
        let hides = order(&depths) == order(&distances(&points)) || ranks(&order(&depths)) == order(&depths);
        if !hides && sorted[0] > 0.1 && sorted.windows(2).all(|pair| pair[1] - pair[0] > 0.05) {
            break points;
        }
    };
    let depths: Vec<f64> = points.iter().map(|point| depth(*point)).collect();
    let right = order(&depths);
    let names = ["d_1", "d_2", "d_3", "d_4"];
    let subject = points.iter().fold(subject(parameters), |subject, point| with_point(subject, *point));
    let steps = {
        let n = camera.as_ref().map_or(DVec3::Z, |camera| camera.basis().n);
        let parts = [("n_x", n.x), ("n_y", n.y), ("n_z", n.z)].map(|(name, value)| named(name, name, value));
        let offsets = [["(C_x − P_x)", "(C_x - P_x)"], ["(C_y − P_y)", "(C_y - P_y)"], ["(C_z − P_z)", "(C_z - P_z)"]];
        points.iter().enumerate().fold(Worked::new("depths", "(5.7)"), |step, (k, point)| {
            let by = parameters.position - *point;
            let terms = (0..3).map(|c| times([parts[c].into(), named(offsets[c][0], offsets[c][1], by[c]).into()]));
            step.row(named(names[k], names[k], depths[k]), crate::explain::sum(terms))
        })
    };
    let distances = distances(&points);
    let depth_ask = {
        let (depths, distances) = (depths.clone(), distances.clone());
        Ask::computed("depths", Kind::Vector(4), vec![steps.clone()], move |slips| {
            if slips.has(Slip::DistanceAsDepth) {
                return Some(Table::column(&distances));
            }
            let sign = if slips.any(&[Slip::ViewDepthSign, Slip::NReversed]) { -1.0 } else { 1.0 };
            Some(Table::column(&depths.iter().map(|depth| sign * depth).collect::<Vec<_>>()))
        })
        .in_unit(Unit::Scene)
    };
    let order_ask = Ask::computed("order", Kind::Vector(4), vec![steps], move |slips| {
        let right = if slips.has(Slip::DistanceAsDepth) { order(&distances) } else { right.clone() };
        let order: Vec<f64> =
            if slips.has(Slip::OrderReversed) { right.iter().rev().copied().collect() } else { right };
        if slips.has(Slip::RankOfEach) {
            return Some(Table::column(&ranks(&order)));
        }
        Some(Table::column(&order))
    });
    let order_ask = order_ask.of_nature(Nature::Order).following(&["depths"], move |tables| {
        let mut sorted = tables[0].entries.clone();
        sorted.sort_by(f64::total_cmp);
        // If depths are equal, none is farther.
        let distinct = sorted.windows(2).all(|pair| pair[0] < pair[1]);
        distinct.then(|| Table::column(&order(&tables[0].entries)))
    });
    let facts = ["P1", "P2", "P3", "P4"].into_iter().zip(points);
    Exercise { asks: vec![depth_ask, order_ask.whole()], ..about(subject) }.with_facts(facts)
}

pub(super) fn zoom_or_dolly(random: &mut Random) -> Exercise {
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
            // Each question names the operation done instead: a zoom for a dolly, or a dolly for a zoom.
            let is_other = if zoom == 1.0 { slips.has(Slip::Zoomed) } else { slips.has(Slip::Dollied) };
            let (zoom, dolly) = if is_other { (dolly, zoom) } else { (zoom, dolly) };
            let once = if slips.has(Slip::ScaleHalved) { 2.0 } else { 1.0 };
            let (zoom, dolly) = if slips.has(Slip::NothingDone) { (1.0, 1.0) } else { (zoom, dolly) };
            let further = if slips.has(Slip::BehindForgotten) { 0.0 } else { further };
            let at = if slips.has(Slip::DollyOfBehind) {
                (distance + further) / dolly
            } else {
                distance / by(dolly) + further
            };
            let found = share(slips, by(zoom), at) * once;
            Some(Table::number(found))
        })
        .of_nature(Nature::Size)
    };
    // Both enlarge the pole at PF by the factor s.
    let enlarged = |ask: Ask| ask.following(&["before"], move |tables| Some(tables[0].map(|share| share * factor)));
    let ratio = {
        let [d, e, f] = [("D", distance), ("e", behind), ("f", factor)].map(|(name, value)| named(name, name, value));
        let nearer = || over(d, f);
        Worked::new("ratio", "(5.5)")
            .row(named("r", "r", (distance + behind) / distance), over(plus(d, e), d))
            .row(named("r'", "r'", (distance / factor + behind) * factor / distance), over(plus(nearer(), e), nearer()))
    };
    let asks = vec![
        ask("before", 1.0, 1.0, 0.0),
        enlarged(ask("zoomed", factor, 1.0, 0.0)),
        enlarged(ask("dollied", 1.0, factor, 0.0)),
        ask("zoomed_behind", factor, 1.0, behind),
        ask("dollied_behind", 1.0, factor, behind),
        Ask::choice("changes", &["zoom", "dolly"], 1, &[(0, Mistake::OtherOperation)], vec![ratio]),
    ];
    let subject = subject(Parameters { projection: Projection::Perspective, ..parameters });
    let facts = [("h", size), ("e", behind), ("s", factor), ("D", distance)];
    Exercise { asks, ..about(subject) }.with_facts(facts)
}
