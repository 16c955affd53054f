//! Clipping before the division by w, `[2]`: outcodes, and a segment cut by the planes of the view volume.

use glam::DVec4;

use super::cameras::{plain, small, telling};
use crate::exercises::worked::{Worked, named};
use crate::exercises::{Ask, Exercise, Fact, Kind, Nature, Slip, Slips, Table};
use crate::explain::{Formula, minus, over, plus, times};
use crate::numbers::random::Random;

/// Distances of a point inside each plane (left, right, bottom, top, near, far). Negative outside.
fn distances(p: DVec4, slips: Slips) -> [f64; 6] {
    let w = if slips.has(Slip::NoDivide) { 1.0 } else { p.w };
    let z = if slips.has(Slip::DepthRowSign) { -p.z } else { p.z };
    let near = if slips.has(Slip::DepthRange) { z } else { w + z };
    let all = slips.has(Slip::PairsExchanged);
    let (x, y) = if all || slips.has(Slip::SidesExchanged) { (-p.x, -p.y) } else { (p.x, p.y) };
    let (near, far) = if all { (w - z, w + z) } else { (near, w - z) };
    [w + x, w - x, w + y, w - y, near, far]
}

fn tuple(p: DVec4) -> Fact {
    Fact::Tuple(p.to_array().to_vec())
}

/// A point of small whole numbers in clip space.
fn clip_point(random: &mut Random) -> DVec4 {
    let w = random.one_of(&[2.0, 3.0, 4.0, 5.0]);
    DVec4::new(small(random, 7), small(random, 7), small(random, 7), w)
}

pub(super) fn outcodes(random: &mut Random) -> Exercise {
    let mut one = || loop {
        let p = clip_point(random);
        let out = distances(p, Slips::NONE).iter().filter(|distance| **distance < 0.0).count();
        // On a plane both answers would be right. Inside all of them there's nothing to find.
        if out > 0 && distances(p, Slips::NONE).iter().all(|distance| *distance != 0.0) {
            return p;
        }
    };
    let slips = [Slip::NoDivide, Slip::DepthRange, Slip::DepthRowSign, Slip::SidesExchanged];
    telling(&slips, || outcodes_of(one(), one()))
}

fn outcodes_of(a: DVec4, b: DVec4) -> Exercise {
    let ask = |name: &str, p: DVec4| {
        let code = move |slips: Slips| {
            let inverted = slips.has(Slip::OutcodeInverted);
            let [left, right, bottom, top, near, far] = distances(p, slips);
            let negative_first = slips.has(Slip::NegativePlanesFirst);
            let distances = if negative_first {
                [left, bottom, near, right, top, far]
            } else {
                [left, right, bottom, top, near, far]
            };
            distances.map(|distance| f64::from(u8::from((distance < 0.0) != inverted)))
        };
        let of = |text: &'static str, latex, value| named(text, latex, value);
        let [x, y, z, w] = [of("x", "x", p.x), of("y", "y", p.y), of("z", "z", p.z), of("w", "w", p.w)];
        let distance = distances(p, Slips::NONE);
        let names = ["left", "right", "bottom", "top", "near", "far"];
        let step = [(x, true), (x, false), (y, true), (y, false), (z, true), (z, false)]
            .into_iter()
            .zip(names)
            .zip(distance)
            .fold(Worked::new("outcode", "[2]"), |step, (((along, is_sum), name), distance)| {
                let formula = if is_sum { plus(w, along) } else { minus(w, along) };
                step.row(named(name, name, distance), formula)
            });
        Ask::computed(name, Kind::Vector(6), vec![step], move |slips| Some(Table::column(&code(slips))))
            .whole()
            .of_nature(Nature::Outcode)
    };
    let asks = vec![ask("A", a), ask("B", b)];
    Exercise { asks, facts: vec![("A", tuple(a)), ("B", tuple(b))], ..plain() }
}

/// The interval of the segment from `a` to `b` inside the volume: Liang and Barsky in homogeneous coordinates.
fn inside(a: DVec4, b: DVec4, slips: Slips) -> Option<[f64; 2]> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    let is_other = slips.has(Slip::MinForMax);
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    // With the same planes.
    let mut added = [0.0, 1.0];
    for (at_a, at_b) in distances(a, slips).into_iter().zip(distances(b, slips)) {
        if at_a < 0.0 && at_b < 0.0 {
            return None;
        }
        let cut = at_a / (at_a - at_b);
        if at_a < 0.0 && cut >= from {
            added[0] = at_a / (at_a + at_b);
        } else if at_a >= 0.0 && at_b < 0.0 && cut <= to {
            added[1] = at_a / (at_a + at_b);
        }
        if at_a < 0.0 {
            (from, least) = (from.max(cut), least.min(cut));
        } else if at_b < 0.0 {
            (to, greatest) = (to.min(cut), greatest.max(cut));
        }
    }
    if is_other && least.is_finite() && greatest.is_finite() {
        return Some([least, greatest]);
    }
    if slips.has(Slip::DistancesAdded) {
        return Some(added);
    }
    (from < to).then_some([from, to])
}

pub(super) fn clip_segment(random: &mut Random) -> Exercise {
    telling(&[Slip::MinForMax], || clip_segment_of(random))
}

fn clip_segment_of(random: &mut Random) -> Exercise {
    let (a, b) = loop {
        let (a, b) = (clip_point(random), clip_point(random));
        // With equal w the division wouldn't bend t.
        let found = inside(a, b, Slips::NONE).filter(|_| a.w != b.w);
        // Both ends are cut off, and the rest is long enough to see.
        if found.is_some_and(|[from, to]| from > 0.05 && to < 0.95 && to - from > 0.1 && (from + to - 1.0).abs() > 0.01)
        {
            break (a, b);
        }
    };
    let ends = move |slips: Slips| {
        let (a, b) = ends_of(a, b, slips);
        let [from, to] = inside(a, b, slips)?;
        Some(if slips.has(Slip::EntryExit) { [to, from] } else { [from, to] })
    };
    let step = steps(a, b);
    let ask = |name: &str, k: usize| {
        Ask::computed(name, Kind::Number, vec![step.clone()], move |slips| ends(slips).map(|t| t[k].into()))
            .of_nature(Nature::Parameter)
    };
    let way = std::iter::once(step.clone()).chain(ends(Slips::NONE).map(|[from, _]| point_at(a, b, from))).collect();
    let at = move |a: DVec4, b: DVec4, t: f64| Table::from(a + (b - a) * t);
    let point = Ask::computed("P", Kind::Vector(4), way, move |slips| {
        let [from, _] = ends(slips)?;
        let (a, b) = ends_of(a, b, slips);
        Some(at(a, b, from))
    });
    let point = point.following(&["t_in"], move |tables| Some(at(a, b, *tables[0].entries.first()?)));
    let asks = vec![ask("t_in", 0), ask("t_out", 1), point];
    Exercise { asks, facts: vec![("A", tuple(a)), ("B", tuple(b))], ..plain() }
}

/// The ends of the segment to clip.
fn ends_of(a: DVec4, b: DVec4, slips: Slips) -> (DVec4, DVec4) {
    let (a, b) = if slips.has(Slip::ClipAfterDivide) { (a / a.w, b / b.w) } else { (a, b) };
    if slips.has(Slip::EndsExchanged) { (b, a) } else { (a, b) }
}

/// The point of the segment at t.
fn point_at(a: DVec4, b: DVec4, t: f64) -> Worked {
    let names = [
        [("P_x", "P_x"), ("A_x", "A_x"), ("B_x", "B_x")],
        [("P_y", "P_y"), ("A_y", "A_y"), ("B_y", "B_y")],
        [("P_z", "P_z"), ("A_z", "A_z"), ("B_z", "B_z")],
        [("P_w", "P_w"), ("A_w", "A_w"), ("B_w", "B_w")],
    ];
    let (start, end) = (a.to_array(), b.to_array());
    names.into_iter().enumerate().fold(Worked::new("at-t", "[2]"), |step, (k, [p, of_a, of_b])| {
        let name = |(text, latex), value| named(text, latex, value);
        let (from, to) = (name(of_a, start[k]), name(of_b, end[k]));
        let t_in = named("t_in", r"t_{\mathrm{in}}", t);
        let formula = plus(from, times([t_in.into(), minus(to, from)]));
        step.row(name(p, start[k] + t * (end[k] - start[k])), formula)
    })
}

/// The cuts of the planes that separate the ends.
fn steps(a: DVec4, b: DVec4) -> Worked {
    let names = ["t_left", "t_right", "t_bottom", "t_top", "t_near", "t_far"];
    let latex = [
        r"t_{\mathrm{left}}",
        r"t_{\mathrm{right}}",
        r"t_{\mathrm{bottom}}",
        r"t_{\mathrm{top}}",
        r"t_{\mathrm{near}}",
        r"t_{\mathrm{far}}",
    ];
    let ends = distances(a, Slips::NONE).into_iter().zip(distances(b, Slips::NONE));
    let mut step = Worked::new("cuts", "[2]");
    for (k, (at_a, at_b)) in ends.enumerate().filter(|(_, (at_a, at_b))| at_a * at_b < 0.0) {
        let (da, db) = (named("d_A", "d_A", at_a), named("d_B", "d_B", at_b));
        let formula: Formula = over(da, minus(da, db));
        step = step.row(named(names[k], latex[k], at_a / (at_a - at_b)), formula);
    }
    step
}
