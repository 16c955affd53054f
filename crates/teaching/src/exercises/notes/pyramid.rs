//! `[1]` I to III: the pyramid with the day D and the month M of a date of birth.
//!
//! The figure with its local coordinates is lost. Here the base is the square of side 1 about the origin of the plane y
//! = 0, and the height is 1.

use glam::{DMat4, DVec3, DVec4};

use super::chosen;
use crate::camera::{ImageSize, Parameters, Projection};
use crate::exercises::products::{multiplied, multiplied_as};
use crate::exercises::statement_facts::{about, with_point};
use crate::exercises::worked::{Worked, named, worked};
use crate::exercises::{Ask, Exercise, Fact, Free, Holds, Kind, Nature, Slip, Slips, Subject, Table, textbook};
use crate::explain::{over, times};
use crate::figure::Figure;
use crate::inspect::quantity::{PointNumber, Quantity, ReportMatrix};
use crate::scene::{ObjectSpec, Preset, Shape};

const BASE: [DVec3; 4] =
    [DVec3::new(-0.5, 0.0, -0.5), DVec3::new(0.5, 0.0, -0.5), DVec3::new(0.5, 0.0, 0.5), DVec3::new(-0.5, 0.0, 0.5)];
const APEX: DVec3 = DVec3::Y;

#[derive(Clone, Copy)]
struct Birth {
    day: f64,
    month: f64,
    view_angle: f64,
    aspect: f64,
}

impl Birth {
    fn new(free: &Free) -> Self {
        let view_angle = chosen(free, "theta", 90.0);
        Self {
            day: chosen(free, "D", 15.0),
            month: chosen(free, "M", 8.0),
            view_angle: if view_angle < 180.0 { view_angle } else { 90.0 },
            aspect: chosen(free, "A", 1.0),
        }
    }

    /// M_m. The base touches the planes x = 0 and z = 0.
    fn model(&self, slips: Slips) -> DMat4 {
        let (day, month) = if slips.has(Slip::DayAndMonth) { (self.month, self.day) } else { (self.day, self.month) };
        let scale = DMat4::from_scale(DVec3::new(month, day, month));
        let by = slips.pick(
            [
                (Slip::MovedByHalf, 0.5),
                (Slip::MovedByWhole, month),
                (Slip::MovedOneMore, month / 2.0 + 1.0),
                (Slip::OnlyScaled, 0.0),
            ],
            month / 2.0,
        );
        let move_by = DMat4::from_translation(DVec3::new(by, 0.0, by));
        if slips.has(Slip::OrderReversed) { scale * move_by } else { move_by * scale }
    }

    fn vertices(&self) -> impl Iterator<Item = DVec4> {
        BASE.into_iter().chain([APEX]).map(|vertex| vertex.extend(1.0))
    }

    fn world(&self, slips: Slips) -> Vec<DVec4> {
        self.vertices().map(|vertex| self.model(slips) * vertex).collect()
    }

    fn subject(&self) -> Subject {
        let mut figure = Figure::of_preset(Preset::Empty);
        let half = self.month / 2.0;
        // The shape's own base is 2 wide, and its height is 2.
        let pyramid = ObjectSpec::new("pyramid", Shape::Pyramid).at(half, 0.0, half);
        figure.scene.objects.push(pyramid.scaled(half, self.day / 2.0, half));
        figure.camera = Parameters {
            position: DVec3::new(0.0, 0.0, self.month),
            focal_point: DVec3::ZERO,
            view_up: DVec3::Y,
            projection: Projection::Perspective,
            view_angle: self.view_angle,
            aspect: self.aspect,
            near: self.day / 100.0,
            far: 10.0 * self.day,
            ..Parameters::default()
        };
        #[expect(clippy::cast_possible_truncation, reason = "at least 1, at most 4000")]
        let width = (400.0 * self.aspect).clamp(1.0, 4000.0).round() as u32;
        figure.image = ImageSize { width, height: 400 };
        let subject = Subject { figure, ..Subject::default() };
        self.world(Slips::NONE).into_iter().fold(subject, |subject, vertex| with_point(subject, vertex.truncate()))
    }

    /// A quantity of the subject, with slips in the model and in the planes too.
    fn value(&self, quantity: Quantity, slips: Slips) -> Option<Table> {
        let mut subject = self.subject();
        if slips == Slips::NONE {
            return subject.value(quantity);
        }
        let camera = &mut subject.figure.camera;
        if slips.has(Slip::MonthForDay) {
            (camera.near, camera.far) = (self.month / 100.0, 10.0 * self.month);
        } else if slips.has(Slip::DayUndivided) {
            camera.near = self.day;
        }
        if slips.has(Slip::ModelForgotten) {
            subject.points = self.vertices().map(|vertex| vertex.truncate()).collect();
        }
        textbook::value(&subject, quantity, slips)
    }

    /// A question for it.
    fn ask(self, name: &str, kind: Kind, steps: Vec<Worked>, quantity: Quantity) -> Ask {
        let ask = Ask::computed(name, kind, steps, move |slips| self.value(quantity, slips));
        Ask { quantity: Some(quantity.into()), ..ask }
    }

    /// The vertices before M_m.
    fn local(&self, slips: Slips) -> Vec<DVec4> {
        let wide = slips.any(&[Slip::BaseOfTwo, Slip::PyramidOfTwo]);
        let (side, height) = if slips.has(Slip::ScaledAlready) {
            (self.month, self.day)
        } else {
            (if wide { 2.0 } else { 1.0 }, if slips.has(Slip::PyramidOfTwo) { 2.0 } else { 1.0 })
        };
        let w = if slips.has(Slip::WithoutW) { 0.0 } else { 1.0 };
        let placed = |vertex: DVec4| {
            let [x, y, z] = [vertex.x * side, vertex.y * height, vertex.z * side];
            if slips.has(Slip::BaseUpright) { DVec4::new(x, z, y, w) } else { DVec4::new(x, y, z, w) }
        };
        self.vertices().map(placed).collect()
    }

    fn exercise(&self, free: &[&'static str]) -> Exercise {
        let all = [("D", self.day), ("M", self.month), ("theta", self.view_angle), ("A", self.aspect)];
        let exercise = about(self.subject());
        let own = vec![("D", Fact::Number(self.day)), ("M", Fact::Number(self.month))];
        let facts = own.into_iter().chain(exercise.facts.clone()).collect();
        let free = all.into_iter().filter(|(name, _)| free.contains(name)).collect();
        Exercise { facts, free, assumptions: vec!["lost-pyramid"], ..exercise }
    }
}

fn columns(points: &[DVec4]) -> Table {
    Table::from_columns(&points.iter().map(DVec4::to_array).collect::<Vec<_>>())
}

fn matrix_of_points(
    name: &str,
    steps: Vec<Worked>,
    compute: impl Fn(Slips) -> Option<Vec<DVec4>> + Send + Sync + 'static,
) -> Ask {
    Ask::computed(name, Kind::Matrix(4, 5), steps, move |slips| compute(slips).map(|points| columns(&points)))
}

/// I: the vertices in homogeneous coordinates, and the sides of the resulting pyramid.
pub(super) fn vertices(free: &Free) -> Exercise {
    let birth = Birth::new(free);
    let (day, month) = (birth.day, birth.month);
    let number = |name: &str, [symbol, factor]: [&'static str; 2], value: f64| {
        // The pyramid has side 1 and height 1 before.
        let scaled = times([named(factor, factor, value).into(), 1.0.into()]);
        let step = Worked::new("scaled", "[1]").row(named(symbol, symbol, value), scaled);
        let ask = Ask::computed(name, Kind::Number, vec![step], move |slips| {
            // The other number of the two.
            let wrong = if value.to_bits() == day.to_bits() { month } else { day };
            Some(Table::number(if slips.has(Slip::OrderReversed) { wrong } else { value }))
        });
        ask.of_nature(Nature::Size)
    };
    let asks = vec![
        Ask { any_order: true, ..matrix_of_points("local", Vec::new(), move |slips| Some(birth.local(slips))) },
        number("side", ["a", "M"], month),
        number("height", ["h", "D"], day),
    ];
    Exercise { asks, ..birth.exercise(&["D", "M"]) }
}

/// II: M_m with the vertices in the world, M_v with the vertices before the camera.
pub(super) fn model_and_view(free: &Free) -> Exercise {
    let birth = Birth::new(free);
    let (day, month) = (birth.day, birth.month);
    let subject = birth.subject();
    let model_step = || {
        let half = named("M/2", "M/2", month / 2.0);
        Worked::new("model", "[1], [4]")
            .row(named("m_11", "m_{11}", month), named("M", "M", month).into())
            .row(named("m_22", "m_{22}", day), named("D", "D", day).into())
            .row(named("m_33", "m_{33}", month), named("M", "M", month).into())
            .row(named("m_14", "m_{14}", month / 2.0), over(named("M", "M", month), 2.0))
            .row(named("m_34", "m_{34}", month / 2.0), half.into())
    };
    let of = move || Birth { day, month, view_angle: 90.0, aspect: 1.0 };
    let model =
        Ask::computed("Mm", Kind::Matrix(4, 4), vec![model_step()], move |slips| Some(Table::from(of().model(slips))));
    let placed = multiplied(birth.model(Slips::NONE), &birth.vertices().collect::<Vec<_>>());
    let world = matrix_of_points("world", vec![model_step(), placed], move |slips| Some(of().world(slips))).following(
        &["Mm"],
        move |tables| {
            let model = tables[0].matrix()?;
            Some(columns(&of().vertices().map(|vertex| model * vertex).collect::<Vec<_>>()))
        },
    );
    let seen = {
        let subject = subject.clone();
        let mut steps = worked(&subject, Quantity::Matrix(ReportMatrix::View));
        steps.extend(
            matrix(&subject, Quantity::Matrix(ReportMatrix::View), Slips::NONE)
                .map(|view| multiplied(view, &of().world(Slips::NONE))),
        );
        matrix_of_points("view", steps, move |slips| {
            let view = matrix(&subject, Quantity::Matrix(ReportMatrix::View), slips)?;
            Some(of().world(slips).into_iter().map(|vertex| view * vertex).collect())
        })
        .following(&["world", "Mv"], |tables| Some(columns(&through(tables[1].matrix()?, &tables[0])?)))
    };
    let exercise = birth.exercise(&["D", "M"]);
    let asks = vec![model, world, Ask::quantity("Mv", &subject, Quantity::Matrix(ReportMatrix::View)), seen];
    Exercise { asks, assumptions: vec!["lost-pyramid", "touches-planes"], ..exercise }
}

/// III: M_p, and the vertices in clip space, some of them with w = 0.
pub(super) fn projection(free: &Free) -> Exercise {
    let birth = Birth::new(free);
    let subject = birth.subject();
    let of = birth;
    let projected = matrix(&subject, Quantity::Matrix(ReportMatrix::Projection), Slips::NONE);
    let view = matrix(&subject, Quantity::Matrix(ReportMatrix::View), Slips::NONE);
    // As the statement says: the vertices in view space, from exercise II, times M_p.
    let seen: Vec<DVec4> = view.map_or_else(Vec::new, |view| of.world(Slips::NONE).iter().map(|p| view * *p).collect());
    let times_projection = |vertices: &[DVec4]| {
        let mut steps = worked(&subject, Quantity::Matrix(ReportMatrix::Projection));
        steps.extend(projected.map(|by| multiplied_as("vertices-seen", by, vertices)));
        steps
    };
    let clip = {
        matrix_of_points("clip", times_projection(&seen), move |slips| {
            let [view, projection] = [ReportMatrix::View, ReportMatrix::Projection]
                .map(|of_report| of.value(Quantity::Matrix(of_report), slips).and_then(|matrix| matrix.matrix()));
            let (view, projection) = (view?, projection?);
            let world = if slips.has(Slip::ModelForgotten) { of.vertices().collect() } else { of.world(Slips::NONE) };
            let view = if slips.has(Slip::ViewForgotten) { DMat4::IDENTITY } else { view };
            let projection = if slips.has(Slip::ProjectionForgotten) { DMat4::IDENTITY } else { projection };
            Some(world.iter().map(|vertex| projection * (view * *vertex)).collect())
        })
    };
    let world = of.world(Slips::NONE);
    let apex_seen = view.zip(world.last().copied()).map(|(view, apex)| view * apex);
    let clip = clip.following(&["Mp"], move |tables| {
        let all = tables[0].matrix()? * view?;
        Some(columns(&world.iter().map(|vertex| all * *vertex).collect::<Vec<_>>()))
    });
    let apex_alone = seen.last().map_or_else(Vec::new, |apex| vec![*apex]);
    let apex = of
        .ask("apex", Kind::Vector(4), times_projection(&apex_alone), Quantity::Point(4, PointNumber::Clip))
        .following(&["Mp", "Mv", "Mm"], |tables| {
            let [projection, view, model] = [0, 1, 2].map(|k: usize| tables[k].matrix());
            Some(Table::from(projection? * (view? * (model? * APEX.extend(1.0)))))
        })
        .following(&["Mp"], move |tables| Some(Table::from(tables[0].matrix()? * apex_seen?)));
    let holds = vec![
        Holds::new("Mp", &LENS, |m| m.get(5).map_or_else(Vec::new, |m_22| lens_of(m[0], *m_22))),
        lens_in_points("clip", seen.clone()),
        lens_in_points("apex", seen.last().copied().into_iter().collect()),
    ];
    let exercise = of.exercise(&["D", "M", "theta", "A"]);
    let of_projection = Quantity::Matrix(ReportMatrix::Projection);
    let asks = vec![of.ask("Mp", Kind::Matrix(4, 4), worked(&subject, of_projection), of_projection), clip, apex];
    let assumptions = vec!["lost-pyramid", "touches-planes", "angle-and-aspect", "distances-not-coordinates", "w-zero"];
    Exercise { asks, assumptions, holds, ..exercise }
}

/// The numbers of III that are a free choice.
const LENS: [&str; 2] = ["theta", "A"];

/// θ and A from `m_22 = cot(θ/2)` and `m_11 = m_22/A`.
fn lens_of(m_11: f64, m_22: f64) -> Vec<Vec<(&'static str, f64)>> {
    vec![vec![(LENS[0], 2.0 * (1.0 / m_22).atan().to_degrees()), (LENS[1], m_22 / m_11)]]
}

/// θ and A in points of clip space: `x_r = m_11 x_c` and `y_r = m_22 y_c`, by least squares.
fn lens_in_points(ask: &'static str, seen: Vec<DVec4>) -> Holds {
    Holds::new(ask, &LENS, move |clip| {
        let factor = |row: usize| {
            let sums = seen.iter().zip(clip.iter().skip(row * seen.len())).fold((0.0, 0.0), |sums, (point, found)| {
                (sums.0 + point[row] * found, sums.1 + point[row] * point[row])
            });
            sums.0 / sums.1
        };
        lens_of(factor(0), factor(1))
    })
}

/// II and III in one: M_m, M_v, M_p, and the apex in clip space.
pub(in crate::exercises) fn whole(free: &Free) -> Exercise {
    let [first, last] = [model_and_view(free), projection(free)];
    let wanted = ["Mm", "Mv", "Mp", "apex"];
    let mut last = last;
    if let Some(apex) = last.asks.iter_mut().find(|ask| ask.name == "apex") {
        apex.way = Some(way_of_apex(&Birth::new(free)));
    }
    let asks = first.asks.into_iter().chain(last.asks).filter(|ask| wanted.contains(&ask.name.as_str())).collect();
    Exercise {
        asks,
        free: Vec::new(),
        holds: Vec::new(),
        assumptions: vec!["touches-planes", "distances-not-coordinates"],
        ..last
    }
}

/// The steps of the apex from its own space into the world, into the VRC, and into clip space.
fn way_of_apex(birth: &Birth) -> Vec<Worked> {
    let subject = birth.subject();
    let apex = APEX.extend(1.0);
    let world = birth.model(Slips::NONE) * apex;
    let of = |quantity| matrix(&subject, Quantity::Matrix(quantity), Slips::NONE);
    let (Some(view), Some(projection)) = (of(ReportMatrix::View), of(ReportMatrix::Projection)) else {
        return Vec::new();
    };
    let mut steps = vec![multiplied_as("apex-world", birth.model(Slips::NONE), &[apex])];
    steps.push(multiplied_as("apex-view", view, &[world]));
    steps.push(multiplied_as("apex-clip", projection, &[view * world]));
    steps
}

/// Points in the columns of a table, multiplied by a matrix.
fn through(matrix: DMat4, points: &Table) -> Option<Vec<DVec4>> {
    let points = points.transposed();
    points.rows().map(|point| Some(matrix * DVec4::from_array(point.try_into().ok()?))).collect()
}

/// A matrix of a subject, computed with slips.
fn matrix(subject: &Subject, path: Quantity, slips: Slips) -> Option<DMat4> {
    let table = if slips == Slips::NONE { subject.value(path) } else { textbook::value(subject, path, slips) }?;
    let entries: [f64; 16] = table.entries.try_into().ok()?;
    Some(DMat4::from_cols_array(&entries).transpose())
}
