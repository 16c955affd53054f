//! Worked steps to a wanted camera: around a box, above a point, and about PF.

use glam::DVec3;

use super::worked::{Worked, angle, named};
use crate::camera::Parameters;
use crate::explain::{Formula, Function, Named, minus, over, plus, times};

const LOW: [(&str, &str); 3] = [("x_0", "x_0"), ("y_0", "y_0"), ("z_0", "z_0")];
const HIGH: [(&str, &str); 3] = [("x_1", "x_1"), ("y_1", "y_1"), ("z_1", "z_1")];
const POSITION: [(&str, &str); 3] = [("C_x", "C_x"), ("C_y", "C_y"), ("C_z", "C_z")];
const FOCAL_POINT: [(&str, &str); 3] =
    [("PF_x", r"\mathrm{PF}_x"), ("PF_y", r"\mathrm{PF}_y"), ("PF_z", r"\mathrm{PF}_z")];
const P: [(&str, &str); 3] = [("P_x", "P_x"), ("P_y", "P_y"), ("P_z", "P_z")];
const ASIDE: [(&str, &str); 3] = [("a_x", "a_x"), ("a_y", "a_y"), ("a_z", "a_z")];

/// The components of a vector, with their names.
fn components(names: [(&'static str, &'static str); 3], of: DVec3) -> [Named; 3] {
    [0, 1, 2].map(|k| named(names[k].0, names[k].1, of[k]))
}

/// A parallel camera that looks along −z, with VUP = (0, 1, 0), and whose view volume is the box from `low` to `high`,
/// `[0]` §5.2.
pub(super) fn around_box(camera: &Parameters, [low, high]: [DVec3; 2]) -> Vec<Worked> {
    let (low, high) = (components(LOW, low), components(HIGH, high));
    let side = |k: usize| minus(high[k], low[k]);
    let middle = |k: usize| over(plus(low[k], high[k]), 2.0);
    let [width, height] = [("W", camera.height * camera.aspect), ("H", camera.height)].map(|(n, v)| named(n, n, v));
    let near = named("F", "F", camera.near);
    let position = components(POSITION, camera.position);
    let target = components(FOCAL_POINT, camera.focal_point);
    let window = Worked::new("box-window", "(5.1)")
        .row(width, side(0))
        .row(height, side(1))
        .row(named("A", "A", camera.aspect), over(width, height));
    let planes = Worked::new("box-planes", "§5.2")
        .row(position[0], middle(0))
        .row(position[1], middle(1))
        .row(position[2], plus(high[2], near))
        .row(named("B", "B", camera.far), plus(near, side(2)));
    let straight = (0..3).fold(Worked::new("box-focal-point", "(5.2)"), |step, k| step.row(target[k], middle(k)));
    vec![window, planes, straight]
}

/// A camera that has P in the middle of its image, and looks down at it by `slope` degrees from a direction in which Q
/// isn't behind it.
pub(super) fn looking_down(camera: &Parameters, q: DVec3, aside: DVec3, slope: f64) -> Vec<Worked> {
    let p = camera.focal_point;
    let [p_of, q_of] = [components(P, p), components([("Q_x", "Q_x"), ("Q_y", "Q_y"), ("Q_z", "Q_z")], q)];
    let a = components(ASIDE, aside);
    let target = components(FOCAL_POINT, p);
    let straight = (0..3).fold(Worked::new("place-middle", "§5.2"), |step, k| step.row(target[k], p_of[k].into()));
    // (Q − P) × (0, 1, 0) lies in the plane y = 0 at a right angle to the way from P to Q.
    let b = [named("b_x", "b_x", p.z - q.z), named("b_z", "b_z", q.x - p.x)];
    let across = Worked::new("place-aside", "").row(b[0], minus(p_of[2], q_of[2])).row(b[1], minus(q_of[0], p_of[0]));
    let squares = plus(times([b[0].into(), b[0].into()]), times([b[1].into(), b[1].into()]));
    let length = named("‖b‖", r"\|\mathbf{b}\|", b[0].value.hypot(b[1].value));
    let across = if length.value > 0.0 {
        across
            .row(length, Formula::Of(Function::Root, Box::new(squares)))
            .row(a[0], over(b[0], length))
            .row(a[2], over(b[1], length))
    } else {
        // If Q is above or below P, any side will do.
        across.row(a[0], aside.x.into()).row(a[2], aside.z.into())
    };
    let slope = angle("α", r"\alpha", slope);
    let size = named("s", "s", (camera.position - p).length() * slope.value.to_radians().cos());
    let position = components(POSITION, camera.position);
    let along = |k: usize| plus(p_of[k], times([size.into(), a[k].into()]));
    let up = Formula::Of(Function::Tangent, Box::new(slope.into()));
    let placed = Worked::new("place-position", "")
        .row(position[0], along(0))
        .row(position[1], plus(p_of[1], times([size.into(), up])))
        .row(position[2], along(2));
    vec![straight, across, placed]
}

/// The place of C about PF by its distance, its turn about the vertical, and its slope; `[0]` §5.6, azimuth and
/// elevation.
pub(super) fn about_focal_point(camera: &Parameters) -> Vec<Worked> {
    let by = camera.position - camera.focal_point;
    let distance = named("D", "D", by.length());
    let turn = angle("α", r"\alpha", by.x.atan2(by.z).to_degrees());
    let slope = angle("ε", r"\varepsilon", (by.y / by.length()).asin().to_degrees());
    let of = |function, of: Named| Formula::Of(function, Box::new(of.into()));
    let target = components(FOCAL_POINT, camera.focal_point);
    let position = components(POSITION, camera.position);
    let level = |function| times([distance.into(), of(Function::Cosine, slope), of(function, turn)]);
    let step = Worked::new("match-position", "§5.6")
        .row(position[0], plus(target[0], level(Function::Sine)))
        .row(position[1], plus(target[1], times([distance.into(), of(Function::Sine, slope)])))
        .row(position[2], plus(target[2], level(Function::Cosine)));
    let tall = 2.0 * camera.near * (camera.view_angle / 2.0).to_radians().tan();
    let [height, near] = [("H", tall), ("F", camera.near)].map(|(name, value)| named(name, name, value));
    let half = over(height, times([2.0.into(), near.into()]));
    let angle_of = times([2.0.into(), Formula::Of(Function::ArcTangent, Box::new(half))]);
    vec![step, Worked::new("match-angle", "(5.4)").row(angle("θ", r"\theta", camera.view_angle), angle_of)]
}
