//! Answers that are right for a wrong one beside them, computed by hand from it: they get their credit, and the first
//! cause is named once.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::camera::{Operation, Projection};
use camera_lab::exercises::{Slip, Slips};
use glam::{DMat4, DVec3, DVec4};

use super::exercise_slips::typed;
use super::exercise_slips_others::{number, tuple};
use super::exercise_verdicts::{exercise, right, together};

/// A wrong answer, and another one that follows from it, row by row.
struct Pair {
    wrong: (&'static str, Vec<f64>),
    follows: Vec<(&'static str, Vec<f64>)>,
}

fn array(v: DVec3) -> Vec<f64> {
    v.to_array().to_vec()
}

/// The right matrix, row by row, and that with one number changed.
fn matrix(id: &str, seed: u64, name: &str) -> (DMat4, Vec<f64>) {
    let mut rows = right(id, seed, name);
    rows[0] += 0.25;
    rows[6] -= 0.5;
    (DMat4::from_cols_array(&rows.clone().try_into().unwrap()).transpose(), rows)
}

fn pair(id: &str, seed: u64) -> Pair {
    let exercise = exercise(id, seed);
    let of = |name| right(id, seed, name);
    let vector = |name| DVec3::from_slice(&of(name));
    let p = &exercise.subject.figure.camera;
    let (c, pf, up) = (p.position, p.focal_point, p.view_up);
    let [n, by] = [(c - pf).normalize(), DVec3::new(0.3, -0.2, 0.45)];
    let u = up.cross(n).normalize();
    let v = n.cross(u);
    match id {
        "basis" => {
            // n with one wrong difference, and u and v computed from it.
            let n = (c - pf + DVec3::X).normalize();
            let u = up.cross(n).normalize();
            Pair { wrong: ("n", array(n)), follows: vec![("u", array(u)), ("v", array(n.cross(u)))] }
        }
        "order" => {
            let (m, rows) = matrix(id, seed, "M");
            let p = DVec3::from_slice(&tuple(&exercise, "p"));
            Pair { wrong: ("M", rows), follows: vec![("P", array(m.transform_point3(p)))] }
        }
        "clip-segment" => {
            let [a, b] = ["A", "B"].map(|name| DVec4::from_slice(&tuple(&exercise, name)));
            let t = of("t_in")[0] * 0.8;
            Pair { wrong: ("t_in", vec![t]), follows: vec![("P", (a + (b - a) * t).to_array().to_vec())] }
        }
        "painter" => {
            let [mut depths, mut order] = ["depths", "order"].map(of);
            // The farthest and the nearest are exchanged.
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 4")]
            let [far, near] = [order[0], order[3]].map(|thing| thing as usize - 1);
            depths.swap(far, near);
            order.swap(0, 3);
            Pair { wrong: ("depths", depths), follows: vec![("order", order)] }
        }
        "viewport" => {
            let ndc = vector("ndc") * 0.7;
            let port = exercise.subject.figure.viewport.unwrap();
            let along = |start: i32, size: u32, n: f64| (f64::from(size) / 2.0 * (n + 1.0)).floor() + f64::from(start);
            let z = port.depth_near + (port.depth_far - port.depth_near) * (ndc.z + 1.0) / 2.0;
            let at = vec![along(port.x, port.width, ndc.x), along(port.y, port.height, ndc.y), z];
            Pair { wrong: ("ndc", array(ndc)), follows: vec![("viewport", at)] }
        }
        "vocabulary" => {
            let sides: Vec<f64> = of("frustum").iter().map(|side| side * 1.7).collect();
            let [f, m, n] = ["F", "m", "n"].map(|name| number(&exercise, name));
            let (right, top) = (sides[1], sides[3]);
            let k = [[m * f / (2.0 * right), 0.0, m / 2.0], [0.0, n * f / (2.0 * top), n / 2.0], [0.0, 0.0, 1.0]];
            Pair { wrong: ("frustum", sides), follows: vec![("K", k.concat())] }
        }
        "left-handed" => {
            let up = DVec3::from_slice(&tuple(&exercise, "VUV"));
            let n = (DVec3::from_slice(&tuple(&exercise, "VPN")) + DVec3::Y).normalize();
            let v = (up - n * n.dot(up)).normalize();
            Pair { wrong: ("n", array(n)), follows: vec![("v", array(v)), ("u", array(n.cross(v)))] }
        }
        "light" => {
            let [p, n, c] = ["P", "N", "C"].map(|name| DVec3::from_slice(&tuple(&exercise, name)));
            let [ka, kd, ks, m] = ["ka", "kd", "ks", "exponent"].map(|name| number(&exercise, name));
            let (n, v) = (n.normalize(), (c - p).normalize());
            let l = (vector("L") + by).normalize();
            let h = (l + v).normalize();
            let share = vec![ka + kd * n.dot(l).max(0.0)];
            let highlight = vec![ks * n.dot(h).powf(m)];
            let follows = vec![("cosine", vec![n.dot(l)]), ("share", share), ("H", array(h)), ("highlight", highlight)];
            Pair { wrong: ("L", array(l)), follows }
        }
        "pan" => {
            let moved = vector("C") + by;
            Pair { wrong: ("C", array(moved)), follows: vec![("PF", array(pf + moved - c))] }
        }
        "dolly" => {
            let moved = vector("C") + by;
            Pair { wrong: ("C", array(moved)), follows: vec![("D", vec![(moved - pf).length()])] }
        }
        "zoom" => {
            let height = of("H")[0] * 1.4;
            let mut follows = vec![("W", vec![height * p.aspect])];
            if p.projection == Projection::Perspective {
                follows.push(("theta", vec![2.0 * (height / (2.0 * p.near)).atan().to_degrees()]));
            }
            Pair { wrong: ("H", vec![height]), follows }
        }
        "zoom-or-dolly" => {
            let [share, s] = [of("before")[0] * 1.4, number(&exercise, "s")];
            let follows = vec![("zoomed", vec![share * s]), ("dollied", vec![share * s])];
            Pair { wrong: ("before", vec![share]), follows }
        }
        "elevation" | "azimuth" => {
            let moved = vector("C") + by;
            let n = (moved - pf).normalize();
            let axis = if id == "elevation" { ("v", array(n.cross(u))) } else { ("u", array(v.cross(n))) };
            Pair { wrong: ("C", array(moved)), follows: vec![("n", array(n)), axis] }
        }
        "yaw" | "pitch" => {
            let moved = vector("PF") + by;
            let n = (c - moved).normalize();
            let axis = if id == "pitch" { ("v", array(n.cross(u))) } else { ("u", array(v.cross(n))) };
            Pair { wrong: ("PF", array(moved)), follows: vec![("n", array(n)), axis] }
        }
        "roll" => {
            assert!(matches!(exercise.subject.operations[..], [Operation::Roll(_)]));
            let turned = (u * 0.9 + v * 0.3).normalize();
            Pair { wrong: ("u", array(turned)), follows: vec![("v", array(n.cross(turned)))] }
        }
        "1-II" => {
            let (m, rows) = matrix(id, seed, "Mm");
            let local = columns(&right("1-I", 0, "local"));
            let world: Vec<DVec4> = local.iter().map(|vertex| m * *vertex).collect();
            let view = DMat4::from_cols_array(&of("Mv").try_into().unwrap()).transpose();
            let seen: Vec<DVec4> = world.iter().map(|vertex| view * *vertex).collect();
            Pair { wrong: ("Mm", rows), follows: vec![("world", as_rows(&world)), ("view", as_rows(&seen))] }
        }
        _ => {
            let (m, rows) = matrix(id, seed, "Mp");
            let apex = right("1-II", 0, "view");
            let apex = DVec4::new(apex[4], apex[9], apex[14], apex[19]);
            Pair { wrong: ("Mp", rows), follows: vec![("apex", (m * apex).to_array().to_vec())] }
        }
    }
}

/// The columns of a table of four rows.
fn columns(rows: &[f64]) -> Vec<DVec4> {
    let count = rows.len() / 4;
    (0..count).map(|k| DVec4::new(rows[k], rows[count + k], rows[2 * count + k], rows[3 * count + k])).collect()
}

fn as_rows(columns: &[DVec4]) -> Vec<f64> {
    (0..4).flat_map(|row| columns.iter().map(move |column| column[row])).collect()
}

const EXERCISES: [&str; 19] = [
    "basis",
    "order",
    "clip-segment",
    "painter",
    "viewport",
    "vocabulary",
    "left-handed",
    "pan",
    "dolly",
    "zoom",
    "zoom-or-dolly",
    "elevation",
    "azimuth",
    "yaw",
    "pitch",
    "roll",
    "light",
    "1-II",
    "1-III",
];

#[test]
fn consequences_of_a_wrong_answer_are_carried_in_every_family() {
    let mut carried = 0;
    for id in EXERCISES {
        for seed in 0..if id.starts_with("1-") { 1 } else { 12 } {
            let exercise = exercise(id, seed);
            let Pair { wrong, follows } = pair(id, seed);
            let shape = |name: &str| exercise.asks.iter().find(|ask| ask.name == name).unwrap().shape();
            let answers: Vec<(&str, String)> = std::iter::once(&wrong)
                .chain(&follows)
                .map(|(name, numbers)| (*name, typed(numbers, shape(name))))
                .collect();
            let judged = together(id, seed, &answers);
            assert!(!judged[0].right && judged[0].carried.is_empty(), "{id} {seed}: {:?}", judged[0]);
            for judged in &judged[1..] {
                // It may be right all the same, for example v if n is turned about it.
                if judged.right {
                    continue;
                }
                let context = format!("{id} {seed} {}: {judged:?}", judged.name);
                assert_eq!(judged.carried, [wrong.0.to_owned()], "{context}");
                assert!((judged.score - 1.0).abs() < 1e-12 && judged.diagnosis.is_none(), "{context}");
                carried += 1;
            }
            // The same answers without the wrong one are wrong for themselves.
            for (k, answer) in answers.iter().enumerate().skip(1) {
                let alone = together(id, seed, std::slice::from_ref(answer)).remove(0);
                assert!(alone.carried.is_empty() && alone.right == judged[k].right, "{id} {seed}: {alone:?}");
            }
        }
    }
    assert!(carried > 250, "{carried}");
}

/// Never is “u points to the wrong side” said beside a u that is right.
#[test]
fn no_reason_is_given_that_a_right_answer_beside_it_excludes() {
    let mut told = 0;
    for id in ["basis", "window", "pixel", "ndc", "elevation", "yaw", "left-handed", "vocabulary", "viewport"] {
        for seed in 0..6 {
            let exercise = exercise(id, seed);
            let tables: Vec<_> = exercise.asks.iter().map(|ask| ask.expected().table().unwrap()).collect();
            for (k, ask) in exercise.asks.iter().enumerate() {
                for slip in Slip::ALL {
                    let Some(wrong) = ask.expected().slipped(Slips::one(*slip)) else { continue };
                    let answers: Vec<(&str, String)> = exercise
                        .asks
                        .iter()
                        .zip(&tables)
                        .enumerate()
                        .map(|(j, (other, right))| {
                            let table = if j == k { &wrong } else { right };
                            (other.name.as_str(), typed(&table.entries, other.shape()))
                        })
                        .collect();
                    let judged = together(id, seed, &answers).swap_remove(k);
                    let Some(diagnosis) = judged.diagnosis else { continue };
                    told += 1;
                    for cause in diagnosis.causes.iter().chain(&diagnosis.others) {
                        // One way of making it leaves all the others right.
                        let leaves = |slip: &Slip| {
                            exercise.asks.iter().zip(&tables).enumerate().all(|(j, (other, right))| {
                                let found = other.expected().slipped(Slips::one(*slip));
                                j == k
                                    || found.is_none_or(|found| {
                                        let pairs = found.entries.iter().zip(&right.entries);
                                        pairs.into_iter().all(|(found, right)| other.accepts(Some(*found), *right))
                                    })
                            })
                        };
                        let mut ways = Slip::ALL.iter().filter(|slip| slip.mistake() == cause.mistake);
                        // A minus in front of the whole, a matrix turned round.
                        let is_general = matches!(cause.mistake.code(), "sign" | "transposed" | "inverse");
                        assert!(
                            is_general || ways.any(leaves),
                            "{id} {seed} {} {slip:?}: {cause:?} beside right answers",
                            ask.name
                        );
                    }
                }
            }
        }
    }
    assert!(told > 300, "{told}");
}
