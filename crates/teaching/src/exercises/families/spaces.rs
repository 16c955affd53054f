//! Other vocabularies, other orders: the left-handed basis of `[3]`, the calls of OpenGL, K of computer vision,
//! products of transforms.

use glam::{DMat3, DMat4, DVec3};

use super::cameras::{about, camera, lens_camera, plain, small, subject, telling};
use crate::camera::{Parameters, Projection};
use crate::exercises::products::{ENTRIES, multiplied};
use crate::exercises::textbook::{half_tangent, over_height};
use crate::exercises::worked::{Worked, angle, named};
use crate::exercises::{Ask, Exercise, Fact, Kind, Mistake, Nature, Slip, Slips, Table, follows, notes};
use crate::explain::{Formula, Function, minus, over, sum, times};
use crate::geometry::Angle;
use crate::numbers::random::Random;

pub(super) fn pyramid(random: &mut Random) -> Exercise {
    telling(&[Slip::DayAndMonth, Slip::ClipWithOne], || {
        let birth = [("D", random.whole(2, 31) as f64), ("M", random.whole(2, 12) as f64)];
        notes::pyramid_of(&birth.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
    })
}

/// **n** into the scene, **v** from VUV' without its part along **n**, **u** = **n** × **v**.
fn left_handed_basis(normal: DVec3, up: DVec3, slips: Slips) -> [DVec3; 3] {
    let into = if slips.has(Slip::LeftHandedNReversed) { -normal } else { normal };
    let keeps = slips.any(&[Slip::NothingNormalised, Slip::NNotNormalised]);
    let n = if keeps { into } else { into.normalize() };
    // With a VPN that isn't of length 1, the formula of [3] subtracts too much.
    let printed = slips.any(&[Slip::PrintedViewUp, Slip::PrintedViewUpUnit]);
    let along = if printed { normal } else { n };
    let v = up - along * along.dot(up);
    let v = if slips.any(&[Slip::ViewUpAsV, Slip::UnitViewUpAsV]) { up } else { v };
    let v = if slips.any(&[Slip::NothingNormalised, Slip::ViewUpAsV, Slip::LengthForgotten, Slip::PrintedViewUp]) {
        v
    } else {
        v.normalize()
    };
    let v = if slips.has(Slip::LeftHandedVReversed) { -v } else { v };
    let u = if slips.has(Slip::LeftHandedUReversed) { v.cross(n) } else { n.cross(v) };
    [u, v, n]
}

const LEFT_HANDED_NAMES: [[&str; 6]; 3] = [
    ["n_x", "VPN_x", "v_x", "VUV'_x", "VUV_x", "u_x"],
    ["n_y", "VPN_y", "v_y", "VUV'_y", "VUV_y", "u_y"],
    ["n_z", "VPN_z", "v_z", "VUV'_z", "VUV_z", "u_z"],
];

/// The steps to **n**, to **v** and to **u**, one after the other. Every number comes from a row before it.
fn left_handed_steps(normal: DVec3, up: DVec3, [v, n]: [DVec3; 2]) -> [Worked; 3] {
    let part = |text: &'static str, value: f64| named(text, text, value);
    let root = |vector: DVec3, names: [&'static str; 3]| {
        let square = |k: usize| times([part(names[k], vector[k]).into(), part(names[k], vector[k]).into()]);
        Formula::Of(Function::Root, Box::new(sum((0..3).map(square))))
    };
    let all = |k: usize| [0, 1, 2].map(|row: usize| LEFT_HANDED_NAMES[row][k]);
    let along = n.dot(up);
    let rest = up - n * along;
    let length = named("‖VPN‖", r"\|\mathrm{VPN}\|", normal.length());
    let dot = named("n·VUV'", r"\mathbf{n}\cdot\mathrm{VUV}'", along);
    let norm = named("‖VUV‖", r"\|\mathrm{VUV}\|", rest.length());
    let mut of_n = Worked::new("left-handed-n", "[3] §1.5").row(length, root(normal, all(1)));
    let products =
        (0..3).map(|k| times([part(all(0)[k], n[k]).into(), part(all(3)[k], up[k]).into()])).collect::<Vec<_>>();
    let mut of_v = Worked::new("left-handed-v", "[3] §1.5").row(dot, sum(products));
    for k in 0..3 {
        of_n = of_n.row(part(all(0)[k], n[k]), over(part(all(1)[k], normal[k]), length));
        let taken = times([part(all(0)[k], n[k]).into(), dot.into()]);
        of_v = of_v.row(part(all(4)[k], rest[k]), minus(part(all(3)[k], up[k]), taken));
    }
    of_v = of_v.row(norm, root(rest, all(4)));
    for k in 0..3 {
        of_v = of_v.row(part(all(2)[k], v[k]), over(part(all(4)[k], rest[k]), norm));
    }
    let mut of_u = Worked::new("left-handed-u", "[3] §1.5");
    for k in 0..3 {
        let [a, b] = [(k + 1) % 3, (k + 2) % 3];
        let of = |i: usize, j: usize| times([part(all(0)[i], n[i]).into(), part(all(2)[j], v[j]).into()]);
        of_u = of_u.row(part(all(5)[k], n.cross(v)[k]), minus(of(a, b), of(b, a)));
    }
    [of_n, of_v, of_u]
}

pub(super) fn left_handed(random: &mut Random) -> Exercise {
    let Parameters { position, focal_point, view_up, .. } = camera(random, Projection::Perspective);
    let normal = focal_point - position;
    let [_, v, n] = left_handed_basis(normal, view_up, Slips::NONE);
    let steps = left_handed_steps(normal, view_up, [v, n]);
    let ask = |name: &str, k: usize| {
        // n alone, then v as well, then u.
        let way = steps[..3 - k].to_vec();
        let ask = Ask::computed(name, Kind::Vector(3), way, move |slips| {
            Some(Table::from(left_handed_basis(normal, view_up, slips)[k]))
        });
        let up = move |n: DVec3| follows::unit(view_up - n * n.dot(view_up));
        let ask = ask.of_nature(Nature::Direction);
        match k {
            0 => ask
                .following(&["n", "v"], |tables| Some(Table::from(tables[0].vector()?.cross(tables[1].vector()?))))
                .following(&["n"], move |tables| {
                    let n = tables[0].vector()?;
                    Some(Table::from(n.cross(up(n)?)))
                }),
            1 => ask.following(&["n"], move |tables| Some(Table::from(up(tables[0].vector()?)?))),
            _ => ask,
        }
    };
    let asks = vec![ask("n", 2), ask("v", 1), ask("u", 0)];
    Exercise { asks, assumptions: vec!["unit-vpn"], ..plain() }.with_facts([("VPN", normal), ("VUV", view_up)])
}

/// l, r, b, t of glFrustum, and K, from the arguments of gluPerspective.
fn frustum(parameters: &Parameters, slips: Slips) -> [f64; 4] {
    let distance = (parameters.position - parameters.focal_point).length();
    let near = slips.pick([(Slip::NearForgotten, 1.0), (Slip::DistanceForNear, distance)], parameters.near);
    let times = slips.pick([(Slip::SideWhole, 2.0), (Slip::HeightHalved, 0.5)], 1.0);
    let top = times * near * half_tangent(parameters.view_angle, slips);
    let top = if slips.has(Slip::AngleAcross) { top / parameters.aspect } else { top };
    let right = top * over_height(parameters.aspect, slips);
    [-right, right, -top, top]
}

pub(super) fn vocabulary(random: &mut Random) -> Exercise {
    let parameters = lens_camera(random, Projection::Perspective);
    let subject = super::cameras::with_image(subject(parameters), random.one_of(&[240, 480, 600]));
    let size = subject.figure.image;
    let (m, n) = (f64::from(size.width), f64::from(size.height));
    let theta = angle("θ", r"\theta", parameters.view_angle);
    let near = named("F", "F", parameters.near);
    let aspect = named("A", "A", parameters.aspect);
    let [left, right, bottom, top] = frustum(&parameters, Slips::NONE);
    let tangent = Formula::Of(Function::Tangent, Box::new(over(theta, 2.0)));
    let t = named("t", "t", top);
    let frustum_step = Worked::new("frustum", "(5.5), (5.1)")
        .row(t, times([near.into(), tangent]))
        .row(named("b", "b", bottom), -Formula::from(t))
        .row(named("r", "r", right), times([aspect.into(), t.into()]))
        .row(named("l", "l", left), -Formula::from(named("r", "r", right)));
    let k_step = {
        let (m, n) = (named("m", "m", m), named("n", "n", n));
        let (r, t) = (named("r", "r", right), named("t", "t", top));
        let twice = |side| times([2.0.into(), Formula::from(side)]);
        Worked::new("pinhole", "K [R|t]")
            .row(
                named("f_x", "f_x", m.value * near.value / (2.0 * right)),
                over(times([m.into(), near.into()]), twice(r)),
            )
            .row(
                named("f_y", "f_y", n.value * near.value / (2.0 * top)),
                over(times([n.into(), near.into()]), twice(t)),
            )
            .row(named("c_x", "c_x", m.value / 2.0), over(m, 2.0))
            .row(named("c_y", "c_y", n.value / 2.0), over(n, 2.0))
    };
    let frustum_ask = Ask::computed("frustum", Kind::Vector(4), vec![frustum_step.clone()], move |slips| {
        let [left, right, bottom, top] = frustum(&parameters, slips);
        let by_pairs = slips.has(Slip::SidesByPairs);
        Some(Table::column(&if by_pairs { [left, bottom, right, top] } else { [left, right, bottom, top] }))
    });
    let pinhole = move |[right, top]: [f64; 2], slips: Slips| {
        let (m, n) = if slips.has(Slip::ColumnsAndRows) { (n, m) } else { (m, n) };
        let near = if slips.has(Slip::NearForgottenInScale) { 1.0 } else { parameters.near };
        let twice = if slips.has(Slip::ScaleDoubled) { 1.0 } else { 2.0 };
        let f = if slips.has(Slip::ScaleInverted) {
            [m * right / (twice * near), n * top / (twice * near)]
        } else {
            [m * near / (twice * right), n * near / (twice * top)]
        };
        // cot(θ/2) alone is inverted, and A stays where it is.
        let tangent = if slips.has(Slip::TangentForCotangent) { top / near } else { 1.0 };
        let f = f.map(|f| f * tangent * tangent);
        let by = slips.pick([(Slip::CentreWhole, 1.0), (Slip::CentreIgnored, 0.0)], 0.5);
        let less = if slips.has(Slip::CentresAtWhole) { 0.5 } else { 0.0 };
        let centre = if slips.has(Slip::CentresExchanged) { [n, m] } else { [m, n] };
        let [x, y] = centre.map(|side| side * by - less);
        Table::from(DMat3::from_cols_array_2d(&[[f[0], 0.0, x], [0.0, f[1], y], [0.0, 0.0, 1.0]]).transpose())
    };
    let k = Ask::computed("K", Kind::Matrix(3, 3), vec![frustum_step, k_step], move |slips| {
        let [_, right, _, top] = frustum(&parameters, slips);
        Some(pinhole([right, top], slips))
    });
    let k = k.following(&["frustum"], move |tables| {
        let [_, right, _, top] = tables[0].entries[..] else { return None };
        Some(pinhole([right, top], Slips::NONE))
    });
    Exercise { asks: vec![frustum_ask, k], ..about(subject) }.with_facts(super::cameras::image(size))
}

pub(super) fn order(random: &mut Random) -> Exercise {
    let by = DVec3::new(small(random, 4), small(random, 4), small(random, 4)) + DVec3::X * 5.0;
    let degrees = random.one_of(&[30.0, 90.0, 45.0, 60.0, -90.0, -30.0]);
    let scale = DVec3::from_array(random.one_of(&[[2.0, 1.0, 3.0], [1.0, 3.0, 2.0], [2.0, 3.0, 1.0], [3.0, 1.0, 0.5]]));
    let axis = random.one_of(&[DVec3::X, DVec3::Y, DVec3::Z]);
    let point = DVec3::new(1.0, small(random, 3), 2.0);
    let product = move |slips: Slips| {
        let angle = if slips.has(Slip::OppositeAngle) { -degrees } else { degrees };
        let angle =
            if slips.has(Slip::TurnInRadians) { Angle::from_radians(angle) } else { Angle::from_degrees(angle) };
        // The sine of whole degrees is exact there.
        let (sin, cos) = angle.sin_cos();
        let turn = DMat4::from_mat3(rotation(axis, sin, cos));
        let (move_by, stretch) = (DMat4::from_translation(by), DMat4::from_scale(scale));
        slips.pick(
            [
                (Slip::OrderReversed, stretch * turn * move_by),
                (Slip::OrderRts, turn * move_by * stretch),
                (Slip::OrderTsr, move_by * stretch * turn),
                (Slip::OrderStr, stretch * move_by * turn),
                (Slip::OrderRst, turn * stretch * move_by),
                (Slip::WithoutTranslation, turn * stretch),
                (Slip::WithoutRotation, move_by * stretch),
                (Slip::WithoutScale, move_by * turn),
            ],
            move_by * turn * stretch,
        )
    };
    let alpha = angle("α", r"\alpha", degrees);
    let of = |function| Formula::Of(function, Box::new(alpha.into()));
    let (sin, cos) = Angle::from_degrees(degrees).sin_cos();
    let step = Worked::new("order", "[4]")
        .row(named("cos α", r"\cos\alpha", cos), of(Function::Cosine))
        .row(named("sin α", r"\sin\alpha", sin), of(Function::Sine));
    let step = {
        let turn = rotation(axis, sin, cos);
        let stretch = [("s_x", scale.x), ("s_y", scale.y), ("s_z", scale.z)].map(|(name, s)| named(name, name, s));
        (0..3).fold(step, |step, row| {
            let step = stretch.iter().enumerate().fold(step, |step, (column, s)| {
                let (text, latex) = ENTRIES[row][column];
                let r = turn.row(row)[column];
                step.row(named(text, latex, r * s.value), times([named("r", "r", r).into(), (*s).into()]))
            });
            let (name, (text, latex)) = (["t_x", "t_y", "t_z"][row], ENTRIES[row][3]);
            step.row(named(text, latex, by[row]), named(name, name, by[row]).into())
        })
    };
    let moved = multiplied(product(Slips::NONE), &[point.extend(1.0)]);
    let matrix =
        Ask::computed("M", Kind::Matrix(4, 4), vec![step.clone()], move |slips| Some(Table::from(product(slips))));
    let image = Ask::computed("P", Kind::Vector(3), vec![step, moved], move |slips| {
        Some(Table::from(product(slips).transform_point3(point)))
    });
    let image = image.following(&["M"], move |tables| Some(Table::from(tables[0].matrix()?.transform_point3(point))));
    let first = Ask::choice("first", &["translate", "rotate", "scale"], 2, &[(0, Mistake::OrderReversed)], Vec::new());
    let axis_name = if axis.x > 0.0 {
        "1, 0, 0"
    } else if axis.y > 0.0 {
        "0, 1, 0"
    } else {
        "0, 0, 1"
    };
    let facts = vec![
        ("t", by.into()),
        ("alpha", degrees.into()),
        ("axis", Fact::Word(axis_name.to_owned())),
        ("s", scale.into()),
        ("p", point.into()),
    ];
    Exercise { asks: vec![matrix, image, first], facts, ..plain() }
}

/// A rotation about an axis of coordinates.
fn rotation(axis: DVec3, sin: f64, cos: f64) -> DMat3 {
    let columns = if axis.x > 0.0 {
        [[1.0, 0.0, 0.0], [0.0, cos, sin], [0.0, -sin, cos]]
    } else if axis.y > 0.0 {
        [[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]]
    } else {
        [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]]
    };
    DMat3::from_cols_array_2d(&columns)
}
