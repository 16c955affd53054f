//! `[0]` 5.1 to 5.3.

use glam::DVec3;

use super::{chosen, figure_of};
use crate::camera::{ImageSize, Operation, Parameters, Projection, ViewWindow};
use crate::exercises::placing::around_box;
use crate::exercises::statement_facts::{about, image, with_point};
use crate::exercises::worked::{Worked, named, worked};
use crate::exercises::{
    Ask, Exercise, Fact, Free, Holds, Kind, Mistake, Nature, Slip, Slips, Subject, TOLERANCE, Table, Unit, textbook,
};
use crate::explain::{Formula, Function, over, plus, sum, times};
use crate::figure::{Figure, NamedPoint};
use crate::geometry::Angle;
use crate::inspect::quantity::{BasisAxis, PointNumber, Quantity, RayNumber, ReportMatrix};
use crate::scene::Preset;

/// 5.1: the rays towards the point (1, 1, 0) of the VRC.
pub(super) fn rays(_seed: u64) -> Exercise {
    let parameters = Parameters {
        position: DVec3::new(3.0, 4.0, 0.0),
        focal_point: DVec3::ZERO,
        view_up: DVec3::Y,
        projection: Projection::Parallel,
        height: 4.0,
        aspect: 1.0,
        near: 1.0,
        far: 10.0,
        ..Parameters::default()
    };
    let mut figure = Figure::of_preset(Preset::Exercise51);
    figure.camera = parameters;
    figure.image = ImageSize { width: 400, height: 400 };
    let parallel = Subject { figure, ..Subject::default() };
    // The centre of pixel (1, 0) of a window of 4 × 4 in 2 × 2 pixels is (1, 1).
    let mut through = parallel.clone();
    through.figure.image = ImageSize { width: 2, height: 2 };
    through.pixels = vec![[1, 0]];
    let mut in_perspective = through.clone();
    let perspective = Parameters {
        projection: Projection::Perspective,
        window: Some(ViewWindow { left: -2.0, right: 2.0, bottom: -2.0, top: 2.0 }),
        ..parameters
    };
    in_perspective.figure.camera = perspective;
    let direction = Ask::computed("perspective_direction", Kind::Vector(3), towards_vrc(&in_perspective), {
        let subject = in_perspective.clone();
        move |slips| {
            let point = DVec3::new(1.0, 1.0, 0.0);
            if slips.has(Slip::ViewAsWorld) {
                return Some(Table::from(point.normalize()));
            }
            if slips.has(Slip::VrcPointFromEye) {
                return Some(Table::from((point - parameters.position).normalize()));
            }
            if slips.has(Slip::ProjectionsExchanged) {
                return subject.value(Quantity::Direction);
            }
            let [u, v] = [Quantity::Axis(BasisAxis::U), Quantity::Axis(BasisAxis::V)].map(|path| {
                if slips == Slips::NONE { subject.value(path) } else { textbook::value(&subject, path, slips) }
            });
            let sum: Vec<f64> = u?.entries.iter().zip(&v?.entries).map(|(u, v)| u + v).collect();
            let from_origin = slips.has(Slip::PointAsDirection);
            let start = if from_origin { parameters.position } else { DVec3::ZERO };
            let sum = (start + DVec3::from_slice(&sum)) * if slips.has(Slip::RayReversed) { -1.0 } else { 1.0 };
            let keeps = slips.any(&[Slip::LengthForgotten, Slip::RayNotNormalised]);
            Some(Table::from(if keeps { sum } else { sum.normalize_or_zero() }))
        }
    });
    let direction = direction.of_nature(Nature::Direction);
    // The statement has a point of the window, and no pixels.
    let of = |name, subject, path: Quantity| Ask::of_subject(name, subject, path).without_steps(Slip::is_of_pixels);
    let [parallel_origin, parallel_direction, perspective_origin] = rays_of_vrc(&through);
    let asks = vec![
        of("parallel_origin", &through, Quantity::Ray(0, RayNumber::Origin)).worked_as(parallel_origin),
        of("parallel_direction", &through, Quantity::Ray(0, RayNumber::Direction)).worked_as(parallel_direction),
        of("perspective_origin", &in_perspective, Quantity::Ray(0, RayNumber::Origin)).worked_as(perspective_origin),
        direction.or_read_as("window-point", of("", &in_perspective, Quantity::Ray(0, RayNumber::Direction))),
    ];
    let figure = figure_of(include_str!("../../../../../assets/figures/exercise-5.1.toml"));
    let mut answered = Figure { scene: Figure::of_preset(Preset::Exercise51).scene, ..figure.clone() };
    // The point of the VRC where its rays start: C + u + v.
    if let Ok(camera) = parallel.camera() {
        let basis = camera.basis();
        let point = camera.position() + basis.u + basis.v;
        answered.points.push(NamedPoint { name: "O_R".to_owned(), position: point });
    }
    let mut exercise = about(Subject { figure, ..Subject::default() });
    exercise.answered = Some(Box::new(answered));
    exercise.facts.push(("p", Fact::Tuple(vec![1.0, 1.0, 0.0])));
    Exercise { assumptions: vec!["v-is-vup", "unit-direction", "vrc-point"], asks, ..exercise }
}

const ORIGIN: [(&str, &str); 3] = [("O_R,x", "O_{R,x}"), ("O_R,y", "O_{R,y}"), ("O_R,z", "O_{R,z}")];
const DIRECTION: [(&str, &str); 3] =
    [("D_R,x", r"\mathbf{D}_{R,x}"), ("D_R,y", r"\mathbf{D}_{R,y}"), ("D_R,z", r"\mathbf{D}_{R,z}")];

/// The steps to the origin and the direction in parallel projection, and to the origin in perspective, from the point
/// (1, 1, 0) of the VRC, as the statement gives it.
fn rays_of_vrc(subject: &Subject) -> [Vec<Worked>; 3] {
    let Ok(camera) = subject.camera() else { return Default::default() };
    let (basis, position) = (camera.basis(), camera.position());
    let [x_p, y_p] = [named("x_p", "x_p", 1.0), named("y_p", "y_p", 1.0)];
    let names = [("c_x", "u_x", "v_x", "n_x"), ("c_y", "u_y", "v_y", "n_y"), ("c_z", "u_z", "v_z", "n_z")];
    let mut origin = Worked::new("ray-of-point", "(5.21)");
    let mut direction = Worked::new("ray-along-n", "(5.20)");
    let mut eye = Worked::new("ray-from-eye", "(5.17)");
    for (k, (c, u, v, n)) in names.into_iter().enumerate() {
        let [c, u, v] = [named(c, c, position[k]), named(u, u, basis.u[k]), named(v, v, basis.v[k])];
        let (text, latex) = ORIGIN[k];
        let along = sum([c.into(), times([x_p.into(), u.into()]), times([y_p.into(), v.into()])]);
        origin = origin.row(named(text, latex, position[k] + basis.u[k] + basis.v[k]), along);
        eye = eye.row(named(text, latex, position[k]), c.into());
        let (text, latex) = DIRECTION[k];
        direction = direction.row(named(text, latex, -basis.n[k]), -Formula::from(named(n, n, basis.n[k])));
    }
    let axes = worked(subject, Quantity::Axis(BasisAxis::V));
    let normal = worked(subject, Quantity::Axis(BasisAxis::N));
    [[axes, vec![origin]].concat(), [normal, vec![direction]].concat(), vec![eye]]
}

/// (**u** + **v**)/√2.
fn towards_vrc(subject: &Subject) -> Vec<Worked> {
    let mut steps = worked(subject, Quantity::Axis(BasisAxis::V));
    let Ok(camera) = subject.camera() else { return steps };
    let basis = camera.basis();
    let mut step = Worked::new("direction-to-point", "(5.18)");
    let parts = [("u_x", "v_x"), ("u_y", "v_y"), ("u_z", "v_z")];
    for (k, ((text, latex), (u, v))) in DIRECTION.into_iter().zip(parts).enumerate() {
        let (u, v) = (named(u, u, basis.u[k]), named(v, v, basis.v[k]));
        let length = Formula::Of(Function::Root, Box::new(2.0.into()));
        let value = (basis.u[k] + basis.v[k]) / 2.0_f64.sqrt();
        step = step.row(named(text, latex, value), over(plus(u, v), length));
    }
    steps.push(step);
    steps
}

/// 5.2: zoom, image, matrices and elevation of a parallel camera with a view angle.
pub(super) fn zoomed(free: &Free) -> Exercise {
    let near = chosen(free, "F", 5.0);
    let far = chosen(free, "B", 20.0).max(near * (1.0 + 1e-6));
    let position = DVec3::new(7.0, 0.0, 0.0);
    let focal_point = DVec3::ONE;
    let mut figure = figure_of(include_str!("../../../../../assets/figures/exercise-5.2.toml"));
    // H = 2 F tan 45°, (5.5).
    figure.camera = Parameters { height: 2.0 * near, near, far, ..figure.camera };
    let with_height = |height: f64, operations: Vec<Operation>| {
        let mut figure = figure.clone();
        figure.camera.height = height;
        let subject = Subject { figure, operations, ..Subject::default() };
        let Ok(camera) = subject.camera() else { return subject };
        let basis = camera.basis();
        with_point(subject, position + basis.u + basis.v)
    };
    let zoom = vec![Operation::Zoom(3.0)];
    let after = with_height(2.0 * near, zoom.clone());
    let before = with_height(2.0 * near, Vec::new());
    let distance = (position - focal_point).length();
    let at_distance = with_height(2.0 * distance, zoom.clone());
    let at_distance_before = with_height(2.0 * distance, Vec::new());
    let elevated = with_height(2.0 * near, vec![zoom[0], Operation::Elevation(Angle::from_degrees(45.0))]);
    // The point has the coordinates (1, 1) exactly. Its world coordinates have them only approximately. Between two
    // pixels that would count.
    let pixel_of = |subject: &Subject| {
        let subject = subject.clone();
        let steps = steps_to_pixel(&subject);
        let pixel = Ask::computed("pixel", Kind::Vector(2), steps, move |slips| {
            if slips != Slips::NONE {
                return textbook::value(&subject, Quantity::Point(0, PointNumber::Pixel), slips);
            }
            let camera = subject.camera().ok()?;
            let [i, j] = [1024.0 * (1.0 / camera.window_width() + 0.5), 768.0 * (0.5 - 1.0 / camera.window_height())];
            Some(Table::column(&[i, j].map(|x| (x + 1e-9).floor())))
        });
        pixel.whole().of_nature(Nature::Pixel).in_unit(Unit::Pixels)
    };
    let pixel = Ask { quantity: Some(Quantity::Point(0, PointNumber::Pixel).into()), ..pixel_of(&after) }
        .or_read_as("before-zoom", pixel_of(&before))
        .or_read_as("angle-at-distance", pixel_of(&at_distance))
        .or_read_as("angle-at-distance-before-zoom", pixel_of(&at_distance_before));
    let read = |ask: Ask, path: Quantity| {
        let of = |subject| Ask::of_subject("", subject, path);
        ask.or_read_as("before-zoom", of(&before))
            .or_read_as("angle-at-distance", of(&at_distance))
            .or_read_as("angle-at-distance-before-zoom", of(&at_distance_before))
    };
    let corner = Ask::quantity("corner", &after, Quantity::Corner(2));
    let corner = corner.or_read_as("angle-at-distance", Ask::of_subject("", &at_distance, Quantity::Corner(2)));
    let mut asks = vec![
        corner,
        pixel,
        Ask::quantity("Mv", &after, Quantity::Matrix(ReportMatrix::View)),
        read(
            Ask::quantity("Mp", &after, Quantity::Matrix(ReportMatrix::Projection)),
            Quantity::Matrix(ReportMatrix::Projection),
        ),
    ];
    let axes = BasisAxis::ALL.iter().map(|axis| Ask::of_subject(axis.name(), &elevated, Quantity::Axis(*axis)));
    asks.extend(axes.map(|ask| match ask.name.as_str() {
        "v" => ask.following(&["n", "u"], |tables| Some(Table::from(tables[0].vector()?.cross(tables[1].vector()?)))),
        _ => ask,
    }));
    let holds = planes_in_answers(&after);
    let exercise = about(after);
    let facts = [
        ("theta", Fact::Angle(90.0)),
        ("s", Fact::Number(3.0)),
        ("alpha", Fact::Angle(45.0)),
        ("p", Fact::Tuple(vec![1.0, 1.0, 0.0])),
    ];
    let facts = [exercise.facts.clone(), facts.to_vec(), image(exercise.subject.figure.image)].concat();
    Exercise {
        facts: facts.into_iter().rev().collect(),
        free: vec![("F", near), ("B", far)],
        holds,
        assumptions: vec!["angle-needs-distance", "planes-chosen", "zoom-stays", "elevation-sign"],
        asks,
        ..exercise
    }
}

/// F and B in M_p, and F in the upper right corner of the window, after the zoom or before it.
fn planes_in_answers(subject: &Subject) -> Vec<Holds> {
    let in_matrix = |m: &[f64]| {
        let [m_22, m_33, m_34] = [5, 10, 11].map(|k| m.get(k).copied().unwrap_or_default());
        // m_33 = −2/(B − F), m_34 = −(B + F)/(B − F), m_22 = 2/H, H = 2 F, a third of it after the zoom.
        let depth = -2.0 / m_33;
        let of = |near: f64| vec![("F", near), ("B", near + depth)];
        vec![of(3.0 / m_22), of(1.0 / m_22), of((-m_34 * depth - depth) / 2.0)]
    };
    let camera = subject.camera().ok();
    let in_corner = move |corner: &[f64]| {
        let (Some(camera), [x, y, z]) = (&camera, corner) else { return Vec::new() };
        let from_eye = DVec3::new(*x, *y, *z) - camera.position();
        let corner_for_1 = (camera.volume_corners()[2] - camera.position()) / camera.near();
        let along = from_eye.dot(corner_for_1) / corner_for_1.length_squared();
        vec![vec![("F", along)], vec![("F", -from_eye.dot(camera.basis().n))]]
    };
    vec![Holds::new("Mp", &["F", "B"], in_matrix), Holds::new("corner", &["F"], in_corner)]
}

/// The steps from the point (1, 1, 0) of the VRC to its pixel. World coordinates aren't given or needed.
fn steps_to_pixel(subject: &Subject) -> Vec<Worked> {
    let (x, y) = (named("x_c", "x_c", 1.0), named("y_c", "y_c", 1.0));
    let on_window = Worked::new("point-on-window", "§5.3.2")
        .row(named("x_p", "x_p", 1.0), x.into())
        .row(named("y_p", "y_p", 1.0), y.into());
    let mut steps = worked(subject, Quantity::Point(0, PointNumber::Pixel));
    steps.retain(|step| !matches!(step.heading, "n" | "u" | "v" | "to-view"));
    if let Some(to_window) = steps.iter_mut().find(|step| step.heading == "to-window") {
        *to_window = on_window;
    }
    steps
}

/// 5.3: the cameras whose view volume is the cube of NDC.
pub(super) fn cube() -> Exercise {
    let model = Parameters {
        position: DVec3::new(0.0, 0.0, 2.0),
        focal_point: DVec3::ZERO,
        view_up: DVec3::Y,
        projection: Projection::Parallel,
        height: 2.0,
        aspect: 1.0,
        near: 1.0,
        far: 3.0,
        ..Parameters::default()
    };
    let figure = figure_of(include_str!("../../../../../assets/figures/exercise-5.3.toml"));
    let subject = Subject { figure, ..Subject::default() };
    let at = |z: f64, near: f64, far: f64| Parameters { position: DVec3::new(0.0, 0.0, z), near, far, ..model };
    let mistakes = [
        // C in the middle of the cube, and distances measured from there as if they were coordinates.
        (Parameters { focal_point: DVec3::NEG_Z, ..at(0.0, 1.0, 2.0) }, Mistake::NearFarAsCoordinates),
        (Parameters { height: 1.0, ..model }, Mistake::FactorTwo),
    ];
    let steps = around_box(&model, [-DVec3::ONE, DVec3::ONE]);
    let ask = Ask::camera("camera", (model, steps), &mistakes, |camera| {
        let near = |a: f64, b: f64| (a - b).abs() <= TOLERANCE * b;
        let corners = camera.volume_corners();
        let n = camera.basis().n;
        let is_cube = |at: &DVec3| at.to_array().iter().all(|x| near(x.abs(), 1.0));
        let octant = |at: &DVec3| at.to_array().map(|x| x > 0.0);
        let distinct = (0..8).all(|a| (0..a).all(|b| octant(&corners[a]) != octant(&corners[b])));
        let middle = corners.iter().sum::<DVec3>() / 8.0;
        vec![
            ("is-parallel", camera.projection() == Projection::Parallel),
            ("looks-along-axis", n.to_array().iter().any(|x| (x.abs() - 1.0).abs() <= 1e-6)),
            ("window-is-2-by-2", near(camera.window_width(), 2.0) && near(camera.window_height(), 2.0)),
            ("planes-2-apart", near(camera.far() - camera.near(), 2.0)),
            ("front-before-c", camera.near() > 0.0),
            ("middle-at-origin", middle.length() <= TOLERANCE),
            ("is-the-cube", corners.iter().all(is_cube) && distinct),
        ]
    });
    let mut exercise = about(subject);
    exercise.facts.clear();
    Exercise { assumptions: vec!["family-of-cameras", "ndc-mirrored"], asks: vec![ask], ..exercise }
}
