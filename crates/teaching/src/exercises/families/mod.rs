//! Families: exercises whose numbers come from a seed.

mod cameras;
mod clipping;
mod depth;
mod hands;
mod light;
mod matrices;
mod operations;
mod points;
mod spaces;
mod stereo;

use super::Entry;
use crate::camera::{Operation, Projection};
use operations::{C, N, PF, U, V, turn};

use super::{Exercise, Fact, Slip, Slips};
use crate::numbers::random::Random;

/// The last seed with its first numbers, coincidences or not, because sheets and lessons with them are printed.
const LAST_PRINTED: u64 = 50;

/// The exercise of a family for a seed. Numbers that make different mistakes look alike are drawn again.
pub(super) fn without_coincidences(family: &str, seed: u64, make: fn(&mut Random) -> Exercise) -> Exercise {
    const TRIES: usize = 200;
    let mut random = cameras::numbers(family, seed);
    let mut exercise = make(&mut random);
    for _ in 1..TRIES {
        if seed <= LAST_PRINTED || !has_coincidence(family, &exercise) {
            break;
        }
        exercise = make(&mut random);
    }
    // A guess at the same place each time is no way to the answer.
    exercise.asks = exercise.asks.into_iter().map(|ask| ask.shuffled(&mut random)).collect();
    exercise
}

/// True for numbers of a statement that hide which one was used: F = A, D = e, P on an axis, PF at the origin, and
/// angles whose half has a tangent that another step has too, tan 30° = cot 60° and tan 45° = 1.
fn has_coincidence(family: &str, exercise: &Exercise) -> bool {
    let number = |name: &str| {
        exercise.facts.iter().find(|(other, _)| *other == name).and_then(|(_, fact)| match fact {
            Fact::Number(number) | Fact::Angle(number) => Some(*number),
            _ => None,
        })
    };
    let is = |name: &str, values: &[f64]| number(name).is_some_and(|number| values.contains(&number));
    let are_equal = |a: &str, b: &str| number(a).is_some() && number(a) == number(b);
    let is_on_an_axis = |name: &str| match exercise.facts.iter().find(|(other, _)| *other == name) {
        Some((_, Fact::Tuple(values))) => values.iter().filter(|value| **value == 0.0).count() + 1 >= values.len(),
        _ => false,
    };
    let in_perspective = exercise.subject.figure.camera.projection == Projection::Perspective;
    let tells = |slip: Slip| exercise.asks.iter().any(|ask| ask.tells(slip));
    let are_alike = |a: Slip, b: Slip| {
        exercise.asks.iter().filter(|ask| ask.tells(a)).any(|ask| {
            let [a, b] = [a, b].map(|slip| ask.expected().slipped(Slips::one(slip)));
            a.zip(b).is_some_and(|(a, b)| ask.accepts_all(&a.entries, &b))
        })
    };
    match family {
        // On the back plane Z is z_n, and one depth has the same Z without its range and without a minus.
        "viewport" if !tells(Slip::DepthNotMapped) || are_alike(Slip::DepthRangeIgnored, Slip::DepthScaleSign) => true,
        // With PF on the line from the origin to C, and with equal steps along **u** and **v**.
        "basis" | "view-matrix" | "ndc" | "inside" | "pixel" | "ray" | "viewport"
            if !tells(Slip::FocalPointForgotten) =>
        {
            true
        }
        "pan" | "ray" if !tells(Slip::AxesExchanged) => true,
        "ndc" | "pixel" if is_on_an_axis("P") => true,
        "window" | "perspective-matrix" | "ndc" | "inside" | "pixel" | "ray" | "viewport" | "zoom" | "vocabulary" => {
            in_perspective && (is("theta", &[60.0, 90.0]) || are_equal("F", "A"))
        }
        "zoom-or-dolly" => is("theta", &[60.0, 90.0]) || are_equal("D", "e"),
        "disparity" => is("theta", &[60.0, 90.0]),
        // With ±45° the sine is the cosine, apart from its sign.
        "elevation" | "azimuth" | "roll" | "yaw" | "pitch" => is("alpha", &[45.0, -45.0]),
        _ => false,
    }
}

/// All families, in the order in which they are learnt.
pub static ENTRIES: &[Entry] = &[
    Entry::family("basis", "[0] §5.2, (5.2), (5.3)", 6, matrices::basis),
    Entry::family("view-matrix", "[0] §5.3.1, (5.7)", 8, matrices::view_matrix),
    Entry::family("window", "[0] §5.2, (5.1), (5.5)", 4, matrices::window),
    Entry::family("perspective-matrix", "[0] §5.3.2, (5.14)", 8, |random| {
        matrices::projection(random, Projection::Perspective)
    }),
    Entry::family("parallel-matrix", "[0] §5.3.2, (5.16)", 8, |random| {
        matrices::projection(random, Projection::Parallel)
    }),
    Entry::family("asymmetric-window", "[0] §5.3.2, (5.13), (5.15)", 10, matrices::asymmetric_window),
    Entry::family("ndc", "[0] §5.3.2, [2]", 10, points::ndc),
    Entry::family("inside", "[2], [0] §5.3.2", 8, points::inside),
    Entry::family("pixel", "[0] §5.5, (5.22)", 8, points::pixel),
    Entry::family("ray", "[0] §5.4, (5.17)–(5.23)", 10, points::ray),
    Entry::family("viewport", "[0] §5.5, (5.24), (5.25)", 10, points::viewport),
    Entry::family("elevation", "[0] §5.6", 10, |random| {
        turn(random, Operation::Elevation, &["≠ elevation"], &[C, N, V])
    }),
    Entry::family("azimuth", "[0] §5.6", 10, |random| turn(random, Operation::Azimuth, &["≠ azimuth"], &[C, N, U])),
    Entry::family("roll", "[0] §5.6", 8, |random| turn(random, Operation::Roll, &[], &[U, V])),
    Entry::family("yaw", "[0] §5.6", 10, |random| turn(random, Operation::Yaw, &["≠ yaw"], &[PF, N, U])),
    Entry::family("pitch", "[0] §5.6", 10, |random| turn(random, Operation::Pitch, &["≠ pitch"], &[PF, N, V])),
    Entry::family("zoom", "[0] §5.6", 4, operations::zoom),
    Entry::family("dolly", "[0] §5.2, (5.2)", 4, operations::dolly),
    Entry::family("pan", "[0] §5.2, (5.3)", 6, operations::pan),
    Entry::family("zoom-or-dolly", "[0] §5.6, (5.5)", 8, depth::zoom_or_dolly),
    Entry::family("canonical-camera", "[0] 5.3", 8, hands::canonical_camera),
    Entry::family("outcodes", "[2]", 5, clipping::outcodes),
    Entry::family("clip-segment", "[2]", 8, clipping::clip_segment),
    Entry::family("pyramid", "[1] II, III", 25, spaces::pyramid),
    Entry::family("left-handed", "[3] §1.5", 6, spaces::left_handed),
    Entry::family("vocabulary", "[2], K [R|t]", 10, spaces::vocabulary),
    Entry::family("order", "[4], [3]", 8, spaces::order),
    Entry::family("depth-resolution", "[0] (5.25), [2]", 5, depth::resolution),
    Entry::family("painter", "[2]", 6, depth::painter),
    Entry::family("disparity", "[0] (5.5), (5.9)", 12, stereo::disparity),
    Entry::family("light", "[2], [3] §1.1", 12, light::light),
    Entry::family("match-picture", "[0] §5.2, §5.6", 5, hands::match_picture),
    Entry::family("place-camera", "[0] §5.2", 6, hands::place_camera),
    Entry::family("predict-visible", "[2], [0] §5.3", 8, hands::predict_visible),
];
