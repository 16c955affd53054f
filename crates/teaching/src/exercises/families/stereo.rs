//! Two images: disparity, and depth from it.

use glam::DVec3;

use super::cameras::{about, subject, with_image};
use crate::camera::Parameters;
use crate::exercises::statement_facts::image;
use crate::exercises::textbook::half_tangent;
use crate::exercises::worked::{Worked, angle, named};
use crate::exercises::{Ask, Exercise, Kind, Nature, Slip, Slips, Table, Unit};
use crate::explain::{Formula, Function, minus, over, times};
use crate::figure::NamedCamera;
use crate::numbers::random::Random;

/// The numbers of the statement.
#[derive(Clone, Copy)]
struct StereoPair {
    view_angle: f64,
    near: f64,
    /// m and n.
    image: [f64; 2],
    baseline: f64,
    /// The depth of P.
    depth: f64,
    /// The depth at which the shifted windows coincide.
    meeting: f64,
    /// The columns of Q, from the middle of each image.
    columns: [f64; 2],
}

impl StereoPair {
    /// n/(2 tan(θ/2)), which is F n/H.
    fn focal_length(&self, slips: Slips) -> f64 {
        if slips.has(Slip::WindowUnits) {
            return self.near;
        }
        let side = if slips.has(Slip::SizesExchanged) { self.image[0] } else { self.image[1] };
        let halves = if slips.has(Slip::ScaleDoubled) { 1.0 } else { 2.0 };
        let tangent = half_tangent(self.view_angle, slips);
        let tangent = if slips.has(Slip::ScaleInverted) { 1.0 / tangent } else { tangent };
        side / (halves * tangent)
    }

    /// f b, of which both disparity and depth are a fraction.
    fn product(&self, slips: Slips) -> f64 {
        let baseline = if slips.has(Slip::BaselineHalved) { self.baseline / 2.0 } else { self.baseline };
        self.focal_length(slips) * baseline
    }

    fn disparity(&self, slips: Slips) -> f64 {
        if slips.has(Slip::DepthOverBaseline) {
            return self.focal_length(slips) * self.depth / self.baseline;
        }
        let found = self.product(slips) / self.depth;
        let found = if slips.has(Slip::DisparityInverted) { 1.0 / found } else { found };
        if slips.has(Slip::EyesExchanged) { -found } else { found }
    }

    /// Of Q.
    fn measured(&self, slips: Slips) -> f64 {
        let [left, right] = self.columns;
        slips.pick(
            [(Slip::OneImage, left), (Slip::PositionsAdded, left + right), (Slip::EyesExchanged, right - left)],
            left - right,
        )
    }

    fn depth(&self, slips: Slips) -> f64 {
        let measured = self.measured(slips);
        if slips.has(Slip::DepthOverBaseline) {
            return self.focal_length(slips) * measured / self.baseline;
        }
        let found = self.product(slips) / measured;
        if slips.has(Slip::DisparityInverted) { 1.0 / found } else { found }
    }

    /// The derivative of the depth with respect to the disparity, as a size.
    fn step(&self, slips: Slips) -> f64 {
        let found = self.product(slips) / self.measured(slips).powi(2);
        if slips.has(Slip::DisparityInverted) { 1.0 / found } else { found }
    }

    fn shifted(&self, slips: Slips) -> f64 {
        if slips.has(Slip::MeetingForDepth) {
            return self.product(slips) / self.meeting;
        }
        let shift = if slips.has(Slip::ShiftForgotten) { 0.0 } else { 1.0 / self.meeting };
        self.product(slips) * (1.0 / self.depth - shift)
    }
}

/// Numbers with which no mistake looks like another one.
fn pair(random: &mut Random) -> StereoPair {
    let view_angle = random.one_of(&[60.0, 40.0, 50.0, 70.0]);
    let near = random.one_of(&[0.4, 0.8, 1.5, 2.5]);
    let image = random.one_of(&[[640.0, 480.0], [1200.0, 800.0], [1280.0, 720.0], [1000.0, 800.0]]);
    let baseline = random.one_of(&[0.3, 0.12, 0.6, 0.24]);
    let [depth, meeting] = random.one_of(&[[4.0, 6.0], [3.0, 5.0], [6.0, 4.0], [5.0, 3.0], [8.0, 6.0], [10.0, 7.0]]);
    let pair = StereoPair { view_angle, near, image, baseline, depth, meeting, columns: [0.0; 2] };
    let depth_of_other = random.one_of(&[2.5, 3.5, 4.5, 7.0]);
    let disparity = (pair.product(Slips::NONE) / depth_of_other).round().max(5.0);
    // A column in the left image that isn't the disparity, half of it or twice it, and doesn't make the sum of both
    // columns so.
    let is_apart = |x: f64| [0.5, 1.0, 2.0].iter().all(|factor| (x / (factor * disparity) - 1.0).abs() > 0.05);
    let shares = [0.7, 1.7, 2.3, 1.3, 0.8];
    let left = loop {
        let left = (disparity * random.one_of(&shares)).round();
        if is_apart(left) && is_apart(2.0 * left - disparity) && 2.0 * left > disparity {
            break left;
        }
    };
    StereoPair { columns: [left, left - disparity], ..pair }
}

pub(super) fn disparity(random: &mut Random) -> Exercise {
    let pair = pair(random);
    let f = named("f", "f", pair.focal_length(Slips::NONE));
    let b = named("b", "b", pair.baseline);
    let d = named("d", "d", pair.depth);
    let parallax = named("δ", r"\delta", pair.disparity(Slips::NONE));
    let measured = named("δ_Q", r"\delta_Q", pair.measured(Slips::NONE));
    let depth = named("d_Q", "d_Q", pair.depth(Slips::NONE));
    let [left, right] = [named("x_l", "x_l", pair.columns[0]), named("x_r", "x_r", pair.columns[1])];
    let product = || times([f.into(), b.into()]);
    let focal_length = {
        let n = named("n", "n", pair.image[1]);
        let half = over(angle("θ", r"\theta", pair.view_angle), 2.0);
        let tangent = Formula::Of(Function::Tangent, Box::new(half));
        Worked::new("pixels-of-window", "(5.5)").row(f, over(n, times([2.0.into(), tangent])))
    };
    let of_p = Worked::new("disparity", "(5.9)").row(parallax, over(product(), d));
    let of_q = Worked::new("depth-of-disparity", "(5.9)")
        .row(measured, minus(left, right))
        .row(depth, over(product(), measured));
    let cost = Worked::new("cost-of-pixel", "(5.9)").row(
        named("Δd", r"\Delta d", pair.step(Slips::NONE)),
        over(product(), times([measured.into(), measured.into()])),
    );
    let moved = {
        let meeting = named("D", "D", pair.meeting);
        let shifted = named("δ'", r"\delta'", pair.shifted(Slips::NONE));
        Worked::new("shifted-windows", "(5.9)").row(shifted, minus(over(product(), d), over(product(), meeting)))
    };
    let number = |name: &str, steps: &[&Worked], value: fn(&StereoPair, Slips) -> f64| {
        let steps = steps.iter().copied().cloned().collect();
        Ask::computed(name, Kind::Number, steps, move |slips| Some(Table::number(value(&pair, slips))))
    };
    // All others are multiples of f.
    let of_f = |ask: Ask| {
        let right = ask.expected().table().and_then(|table| table.entries.first().copied()).unwrap_or(f64::NAN);
        ask.following(&["f"], move |tables| Some(tables[0].map(|focal_length| right * focal_length / f.value)))
    };
    let first = number("f", &[&focal_length], StereoPair::focal_length).of_nature(Nature::Size).in_unit(Unit::Pixels);
    let disparity = number("disparity", &[&focal_length, &of_p], StereoPair::disparity);
    let shifted = number("shifted", &[&focal_length, &moved], StereoPair::shifted);
    let depth = number("depth", &[&focal_length, &of_q], StereoPair::depth);
    let step = number("step", &[&focal_length, &of_q, &cost], StereoPair::step);
    let asks = vec![
        first,
        of_f(disparity.of_nature(Nature::Size).in_unit(Unit::Pixels)),
        of_f(shifted.in_unit(Unit::Pixels)),
        of_f(depth.of_nature(Nature::Size).in_unit(Unit::Scene)),
        of_f(step.of_nature(Nature::Size).in_unit(Unit::Scene)),
    ];
    let subject = with_image(subject_of(&pair), side(pair.image[1]));
    let size = image(subject.figure.image);
    let facts = [("b", pair.baseline), ("d", pair.depth), ("D", pair.meeting), ("xl", left.value), ("xr", right.value)];
    Exercise { asks, ..about(subject) }.with_facts(facts).with_facts(size)
}

#[expect(clippy::cast_possible_truncation, reason = "a few hundred pixels")]
const fn side(pixels: f64) -> u32 {
    pixels as u32
}

/// Both cameras, in front of small things.
fn subject_of(pair: &StereoPair) -> crate::exercises::Subject {
    let left = Parameters {
        position: DVec3::new(-pair.baseline / 2.0, 1.0, pair.depth),
        focal_point: DVec3::new(-pair.baseline / 2.0, 1.0, 0.0),
        view_angle: pair.view_angle,
        aspect: pair.image[0] / pair.image[1],
        near: pair.near,
        far: 10.0 * pair.depth,
        ..Parameters::default()
    };
    let by = DVec3::X * pair.baseline;
    let right = Parameters { position: left.position + by, focal_point: left.focal_point + by, ..left };
    let mut subject = subject(left);
    subject.figure.cameras = vec![NamedCamera { name: "C_r".to_owned(), color: None, parameters: right, lens: None }];
    subject
}
