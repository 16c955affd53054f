//! An exercise: the facts of its statement, its questions, and the right answers.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use glam::DVec3;

use super::follows::{Follows, Holds};
use super::own_texts::{OwnMistake, OwnTexts};
use super::subject::Subject;
use super::value::Table;
use super::worked::{Worked, worked};
use super::{Free, textbook};
use crate::camera::{Camera, ParameterKey, Parameters};
use crate::exercises::mistakes::mistake::Mistake;
use crate::exercises::mistakes::nature::Nature;
use crate::exercises::mistakes::slip::{Cause, Slip, Slips};
use crate::figure::{Figure, Localized};
use crate::inspect::Asked;
use crate::inspect::quantity::{PointNumber, Quantity, QuantityPath, RayNumber, WindowNumber};
use crate::numbers::random::Random;

/// An exercise with its numbers.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// Its identifier: `0-5.1`, `view-matrix`.
    pub id: String,
    /// The source of its numbers.
    pub seed: u64,
    /// The figure that the statement is about.
    pub subject: Subject,
    /// Numbers that the notes leave open and an answer may choose, with the values chosen here.
    pub free: Vec<(&'static str, f64)>,
    /// Those of them that the student gave beside the answers. They decide.
    pub chosen: Free,
    /// The answers from which the others follow. The first one decides.
    pub holds: Vec<Holds>,
    /// The facts of the statement, by their names in its text.
    pub facts: Vec<(&'static str, Fact)>,
    /// Assumptions for questions that the source leaves open, as the names of their texts.
    pub assumptions: Vec<&'static str>,
    /// The figure with the answers drawn into it, if there is one, to show once the student has tried them.
    pub answered: Option<Box<Figure>>,
    /// In the order of the sheet.
    pub asks: Vec<Ask>,
    /// Its texts, if it's a lecturer's own exercise.
    pub texts: Option<Arc<OwnTexts>>,
}

impl Exercise {
    /// Adds facts to its statement.
    pub(super) fn with_facts<F: Into<Fact>>(mut self, facts: impl IntoIterator<Item = (&'static str, F)>) -> Self {
        self.facts.extend(facts.into_iter().map(|(name, fact)| (name, fact.into())));
        self
    }

    /// The figure with the right camera, if its picture is part of the statement.
    pub fn figure_to_match(&self) -> Option<Figure> {
        let shows = self.id == "match-picture";
        let wanted = self.asks.iter().filter(|_| shows).find_map(|ask| match ask.expected() {
            Expected::Camera(_, model, ..) => Some(**model),
            Expected::Quantity(..) | Expected::Computed(..) | Expected::Choice(..) => None,
        });
        wanted.map(|camera| Figure { camera, ..self.subject.figure.clone() })
    }

    /// True if any picture of the figure answers a question, for example if a point is inside.
    pub fn is_told_by_figure(&self) -> bool {
        let inside = |path: QuantityPath| matches!(path.quantity, Quantity::Point(_, PointNumber::Inside));
        self.asks.iter().any(|ask| ask.quantity.is_some_and(inside))
    }

    /// The solution of a student that it's about, if it asks for the mistake in one.
    pub fn fault(&self) -> Option<&Fault> {
        self.asks.first()?.fault.as_deref()
    }

    /// The steps of each ask that didn't occur in an ask before it.
    pub fn new_steps(&self) -> Vec<Vec<Worked>> {
        let mut told = Vec::new();
        let new = |ask: &Ask| {
            let mut steps = ask.steps();
            steps.retain(|step| {
                let said = step.said();
                let is_new = !told.contains(&said);
                told.push(said);
                is_new
            });
            steps
        };
        self.asks.iter().map(new).collect()
    }
}

/// One or more numbers in a statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// A number.
    Number(f64),
    /// Degrees.
    Angle(f64),
    /// A point or a vector.
    Tuple(Vec<f64>),
    /// A matrix.
    Matrix(Table),
    /// A word that's the same in both languages: the name of a function, a colour.
    Word(String),
    /// A word that differs between the languages, as the name of its text.
    Text(&'static str),
}

impl From<f64> for Fact {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<DVec3> for Fact {
    fn from(v: DVec3) -> Self {
        Self::Tuple(v.to_array().to_vec())
    }
}

/// A solution with a mistake.
#[derive(Clone, Debug)]
pub struct Fault {
    /// The question that the student answered.
    pub ask: Ask,
    /// The student's steps.
    pub steps: Vec<Worked>,
    /// The number of the first wrong line, from 1. The lines of all steps count.
    pub line: u32,
    /// The cause, as the judge names it.
    pub cause: Cause,
    /// The cause and others that would have led to other numbers.
    pub causes: Vec<Cause>,
}

/// A question of an exercise.
#[derive(Clone, Debug)]
pub struct Ask {
    /// Its name, without spaces.
    pub name: String,
    /// The kind of answer.
    pub kind: Kind,
    /// The quantity that its numbers measure.
    pub unit: Unit,
    /// The nature of the answer.
    pub nature: Nature,
    /// Greatest distance of each number from the right one. A number that equals the right one rounded to three or more
    /// significant digits is right too, unless whole numbers are required.
    pub tolerance: f64,
    /// Greatest distance of each number from the right one, as a share of it. Infinite if a lecturer gives the
    /// tolerance.
    pub share: f64,
    /// Whole numbers are required.
    pub whole: bool,
    /// A place in the image: two numbers, pixels from its left edge and from its upper one.
    pub places: bool,
    /// After a wrong first mark, a second place to mark, whose name is [`SECOND`](super::SECOND).
    pub second: Option<Box<Self>>,
    /// Columns are points, in any order.
    pub any_order: bool,
    /// Slips in steps that the question doesn't contain, because it gives their result or needs none.
    pub not_asked: fn(Slip) -> bool,
    /// The path to the right answer in the report of the exercise's subject, if it has one.
    pub quantity: Option<QuantityPath>,
    /// The quantities that it asks for besides, which an author names.
    pub asks: Vec<Quantity>,
    /// The readings of the question. An answer is right if it's right in one of them. The first follows from the
    /// assumptions. The others have the name of their text.
    pub readings: Vec<Reading>,
    /// The texts of a lecturer's choices, by their names.
    pub own_choices: BTreeMap<String, Localized>,
    /// The sentence on the right answer, once it's given.
    pub because: Option<Localized>,
    /// Wrong answers that a lecturer expects.
    pub own_mistakes: Vec<Arc<OwnMistake>>,
    /// The ways to the answer from other answers.
    pub follows: Vec<Follows>,
    /// The worked steps, if they begin with numbers of the statement instead of the camera.
    pub way: Option<Vec<Worked>>,
    /// The solution of a student that it asks about.
    pub fault: Option<Arc<Fault>>,
}

/// A kind of answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One number.
    Number,
    /// A vector with this number of entries.
    Vector(usize),
    /// Rows and columns.
    Matrix(usize, usize),
    /// One of these. They're the names of their texts, or the same in both languages.
    Choice(Vec<String>),
    /// A camera.
    Camera,
}

impl Kind {
    const fn nature(&self) -> Nature {
        match self {
            Self::Number => Nature::Number,
            Self::Vector(_) => Nature::Vector,
            Self::Matrix(..) => Nature::Matrix,
            Self::Choice(_) => Nature::Choice,
            Self::Camera => Nature::Camera,
        }
    }
}

/// The quantity that a number measures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// A ratio, an entry of a matrix, a direction.
    #[default]
    None,
    /// Lengths and coordinates of the scene.
    Scene,
    /// Degrees.
    Degrees,
    /// Pixels.
    Pixels,
}

impl Unit {
    /// The symbol as the contract writes it. Empty for plain numbers.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Scene => "scene units",
            Self::Degrees => "°",
            Self::Pixels => "px",
        }
    }
}

/// One way to understand a question.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The name of its text. Empty for the reading that the statement settles.
    pub name: &'static str,
    /// The right answer in it.
    pub expected: Expected,
}

/// Computes a table, with the results of any slips. `None` means that nothing comes out, or that the slip can't be made
/// there.
pub type Compute = Arc<dyn Fn(Slips) -> Option<Table> + Send + Sync>;
/// The conditions on a camera: their names, and whether it meets them.
pub type Conditions = Arc<dyn Fn(&Camera) -> Vec<(&'static str, bool)> + Send + Sync>;

/// A right answer.
#[derive(Clone)]
pub enum Expected {
    /// The value of `inspect` at a path of a subject.
    Quantity(Box<Subject>, QuantityPath),
    /// A value computed by a family.
    Computed(Compute, Vec<Worked>),
    /// One of the choices. Others are known mistakes.
    Choice(usize, Vec<(usize, Mistake)>, Vec<Worked>),
    /// A camera that meets all conditions, one example with the way to it, and others that are known mistakes.
    Camera(Conditions, Box<Parameters>, Vec<(Parameters, Mistake)>, Vec<Worked>),
}

impl fmt::Debug for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quantity(_, path) => write!(f, "Quantity({path})"),
            Self::Computed(compute, _) => write!(f, "Computed({:?})", compute(Slips::NONE)),
            Self::Choice(right, ..) => write!(f, "Choice({right})"),
            Self::Camera(_, model, ..) => write!(f, "Camera({model:?})"),
        }
    }
}

impl Expected {
    /// The right numbers; `None` for choices and cameras.
    pub fn table(&self) -> Option<Table> {
        match self {
            Self::Quantity(subject, path) => subject.value(*path),
            Self::Computed(compute, _) => compute(Slips::NONE),
            Self::Choice(..) | Self::Camera(..) => None,
        }
    }

    /// The numbers that result from slips.
    pub fn slipped(&self, slips: Slips) -> Option<Table> {
        match self {
            Self::Quantity(subject, path) => textbook::value(subject, *path, slips),
            Self::Computed(compute, _) => compute(slips).filter(Table::is_finite),
            Self::Choice(..) | Self::Camera(..) => None,
        }
    }
}

/// The tolerance of numbers about 1 that a student computes with a calculator.
pub const TOLERANCE: f64 = 1e-3;
/// The tolerance of numbers of which the greatest has this size. It's a power of ten, so it doesn't reveal the answer.
fn tolerance_of(table: &Table) -> f64 {
    let size = table.size();
    if size > 0.0 && size.is_finite() { TOLERANCE * 10.0_f64.powf(size.log10().round()) } else { TOLERANCE }
}

impl Ask {
    /// Adds what it asks for: the quantity of its answer, those that its author names, and the numbers of the answer.
    /// A camera to find isn't a secret, because its parameters are what the answer sets.
    pub fn add_to(&self, asked: &mut Asked, statement: &str) {
        if let Some(fault) = &self.fault {
            return fault.ask.add_to(asked, statement);
        }
        let expected = self.readings.iter().map(|reading| &reading.expected);
        let quantities = expected.clone().filter_map(|expected| match expected {
            Expected::Quantity(_, path) => Some(path.quantity),
            // Its coordinates tell where it is.
            Expected::Computed(..) if self.places => Some(Quantity::Point(0, PointNumber::Inside)),
            Expected::Computed(..) | Expected::Choice(..) | Expected::Camera(..) => None,
        });
        let tables: Vec<Table> = expected.clone().filter(|_| !self.places).filter_map(Expected::table).collect();
        let points = tables.iter().filter(|table| table.columns > 1).map(Table::transposed);
        asked.add_points(points.flat_map(|points| points.rows().map(<[f64]>::to_vec).collect::<Vec<_>>()));
        let numbers: Vec<f64> = tables.into_iter().flat_map(|table| table.entries).collect();
        asked.add(quantities.chain(self.asks.iter().copied()), &numbers, statement);
    }

    fn new(name: &str, kind: Kind, expected: Expected) -> Self {
        let tolerance = expected.table().map_or(TOLERANCE, |right| tolerance_of(&right));
        Self {
            name: name.to_owned(),
            nature: kind.nature(),
            kind,
            unit: Unit::None,
            tolerance,
            share: TOLERANCE,
            whole: false,
            places: false,
            second: None,
            any_order: false,
            not_asked: |_| false,
            quantity: None,
            asks: Vec::new(),
            readings: vec![Reading { name: "", expected }],
            own_choices: BTreeMap::new(),
            because: None,
            own_mistakes: Vec::new(),
            follows: Vec::new(),
            way: None,
            fault: None,
        }
    }

    /// An ask for the value of `inspect` at a path of the exercise's own subject.
    ///
    /// # Panics
    /// Never: a path without numbers gives a number that no answer equals.
    pub fn quantity(name: &str, subject: &Subject, path: impl Into<QuantityPath>) -> Self {
        let path = path.into();
        Self { quantity: Some(path), ..Self::of_subject(name, subject, path) }
    }

    /// An ask for the value of `inspect` at a path of another subject: the same camera after an operation of its own.
    pub fn of_subject(name: &str, subject: &Subject, path: impl Into<QuantityPath>) -> Self {
        let path = path.into();
        let [rows, columns] = subject.value(path).map_or([1, 1], |table| table.shape());
        let kind = match (rows, columns) {
            (1, 1) => Kind::Number,
            (rows, 1) => Kind::Vector(rows),
            _ => Kind::Matrix(rows, columns),
        };
        let ask = Self::new(name, kind, Expected::Quantity(Box::new(subject.clone()), path));
        let ask = Self { nature: Nature::of_quantity(path.quantity).unwrap_or(ask.nature), ..ask };
        match path.quantity {
            Quantity::Point(_, PointNumber::Pixel) | Quantity::Ray(_, RayNumber::Pixel) => {
                Self { unit: Unit::Pixels, whole: true, ..ask }
            }
            // Z has another size than X and Y.
            Quantity::Point(_, PointNumber::Viewport) => Self { unit: Unit::Pixels, tolerance: TOLERANCE, ..ask },
            Quantity::Camera(ParameterKey::ViewAngle) => Self { unit: Unit::Degrees, ..ask },
            Quantity::Camera(ParameterKey::Position | ParameterKey::FocalPoint | ParameterKey::Height)
            | Quantity::CameraSide(_)
            | Quantity::Distance
            | Quantity::Corner(_)
            | Quantity::Point(_, PointNumber::World | PointNumber::View)
            | Quantity::Ray(_, RayNumber::Origin) => Self { unit: Unit::Scene, ..ask },
            Quantity::Window(number) if number != WindowNumber::Aspect => Self { unit: Unit::Scene, ..ask },
            Quantity::Camera(
                ParameterKey::ViewUp
                | ParameterKey::Aspect
                | ParameterKey::Near
                | ParameterKey::Far
                | ParameterKey::Window,
            )
            | Quantity::Direction
            | Quantity::Lens(_)
            | Quantity::Plane(_)
            | Quantity::Axis(_)
            | Quantity::Window(_)
            | Quantity::Matrix(_)
            | Quantity::Point(_, PointNumber::Clip | PointNumber::Ndc | PointNumber::Window | PointNumber::Inside)
            | Quantity::Ray(_, RayNumber::Direction) => ask,
        }
    }

    /// An ask for a value that a family computes, with its worked steps.
    pub fn computed(
        name: &str,
        kind: Kind,
        steps: Vec<Worked>,
        compute: impl Fn(Slips) -> Option<Table> + Send + Sync + 'static,
    ) -> Self {
        Self::new(name, kind, Expected::Computed(Arc::new(compute), steps))
    }

    /// A choice.
    pub fn choice(
        name: &str,
        choices: &[&str],
        right: usize,
        mistakes: &[(usize, Mistake)],
        steps: Vec<Worked>,
    ) -> Self {
        let choices = choices.iter().map(|choice| (*choice).to_owned()).collect();
        Self::new(name, Kind::Choice(choices), Expected::Choice(right, mistakes.to_vec(), steps))
    }

    /// Puts its choices in another order.
    pub(super) fn shuffled(mut self, random: &mut Random) -> Self {
        let Kind::Choice(choices) = &mut self.kind else { return self };
        // The old place of each choice.
        let mut old: Vec<usize> = (0..choices.len()).collect();
        for k in (1..old.len()).rev() {
            let places: Vec<usize> = (0..=k).collect();
            old.swap(k, random.one_of(&places));
        }
        *choices = old.iter().map(|k| choices[*k].clone()).collect();
        for reading in &mut self.readings {
            if let Expected::Choice(right, mistakes, _) = &mut reading.expected {
                for place in mistakes.iter_mut().map(|(place, _)| place).chain([right]) {
                    *place = old.iter().position(|k| *k == *place).unwrap_or(*place);
                }
            }
        }
        let table = |place: usize| Table::number(u32::try_from(place).map_or(0.0, f64::from));
        let of_old = |Follows { from, compute }: Follows| {
            let old = old.clone();
            let new = move |found: Table| old.iter().position(|k| table(*k) == found).map(table);
            Follows { from, compute: Arc::new(move |tables| compute(tables).and_then(&new)) }
        };
        self.follows = self.follows.into_iter().map(of_old).collect();
        self
    }

    /// A camera that meets conditions, and one example with the way to it.
    pub fn camera(
        name: &str,
        (model, steps): (Parameters, Vec<Worked>),
        mistakes: &[(Parameters, Mistake)],
        conditions: impl Fn(&Camera) -> Vec<(&'static str, bool)> + Send + Sync + 'static,
    ) -> Self {
        let expected = Expected::Camera(Arc::new(conditions), Box::new(model), mistakes.to_vec(), steps);
        Self::new(name, Kind::Camera, expected)
    }

    /// Sets the quantity that its numbers measure.
    pub fn in_unit(self, unit: Unit) -> Self {
        Self { unit, ..self }
    }

    /// Sets the nature of the answer.
    pub fn of_nature(self, nature: Nature) -> Self {
        Self { nature, ..self }
    }

    /// Adds a way to it from other answers, by their names.
    pub fn following(
        mut self,
        from: &'static [&'static str],
        compute: impl Fn(&[Table]) -> Option<Table> + Send + Sync + 'static,
    ) -> Self {
        self.follows.push(Follows { from, compute: Arc::new(compute) });
        self
    }

    /// Gives it worked steps of its own.
    pub fn worked_as(self, way: Vec<Worked>) -> Self {
        Self { way: Some(way), ..self }
    }

    /// Leaves out slips in steps that the question doesn't contain.
    pub fn without_steps(self, not_asked: fn(Slip) -> bool) -> Self {
        Self { not_asked, ..self }
    }

    /// Requires whole numbers.
    pub fn whole(self) -> Self {
        Self { whole: true, ..self }
    }

    /// Sets its tolerance.
    pub fn within(self, tolerance: f64) -> Self {
        Self { tolerance, ..self }
    }

    /// Adds another reading, in which `other` is right.
    pub fn or_read_as(mut self, name: &'static str, other: Self) -> Self {
        self.readings.extend(other.readings.into_iter().map(|reading| Reading { name, ..reading }));
        self
    }

    /// Rows and columns of an answer; 1 × 1 for choices and cameras.
    pub const fn shape(&self) -> [usize; 2] {
        match self.kind {
            Kind::Vector(rows) => [rows, 1],
            Kind::Matrix(rows, columns) => [rows, columns],
            Kind::Number | Kind::Choice(_) | Kind::Camera => [1, 1],
        }
    }

    /// The right answer in the first reading.
    ///
    /// # Panics
    /// Never: every ask has a first reading.
    pub fn expected(&self) -> &Expected {
        &self.readings[0].expected
    }

    /// The steps to the right answer.
    pub fn steps(&self) -> Vec<Worked> {
        if let Some(way) = &self.way {
            return way.clone();
        }
        match self.expected() {
            Expected::Quantity(subject, path) => worked(subject, *path),
            Expected::Computed(_, steps) | Expected::Choice(_, _, steps) | Expected::Camera(.., steps) => steps.clone(),
        }
    }
}
