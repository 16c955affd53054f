//! Error against run time. Each [`Study`] takes a place where a graphics programmer has a choice, and runs all methods
//! on the same seeded inputs. It measures how far each is from a reference of [`PRECISION`](reference::PRECISION) bits,
//! and how long it takes.
//!
//! The textbook chain is written once, in [`chain`](crate::chain), for every kind of number
//! ([`Real`](crate::chain::real::Real)). The program's own code isn't generic. It's one of the methods, [`OWN`], called
//! as the program calls it.

pub mod charts;
mod depth_format;
pub mod diagnosis;
pub mod health;
mod measure;
mod memory;
pub mod overhead;
pub mod reference;
mod studies;
pub mod this_figure;
pub mod three_ways;
pub mod times;

use std::time::Duration;

use serde::{Serialize, Serializer};

use crate::clock;
use crate::progress::{Activity, Progress};
pub use depth_format::{Resolution, Seen, TwoPlanes, resolutions};
use measure::{Trial, Watch};
use times::{Interval, decide};

/// The name of the program's own method.
pub const OWN: &str = "camera-lab";

crate::listed! {
    /// A place where a graphics programmer has a choice.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Study {
        /// World points to view space, in worlds far from the origin.
        VertexTransform = "vertex-transform",
        /// **u** **v** **n** with VUP almost along DOP, and for vectors of every size.
        Basis = "basis",
        /// Many small rotations, one after the other.
        RepeatedOperations = "repeated-operations",
        /// The formats of depth buffers.
        DepthBuffer = "depth-buffer",
        /// Visible surfaces.
        Visibility = "visibility",
        /// Light on curved surfaces made of flat faces.
        Shading = "shading",
        /// Samples of a pixel.
        Antialiasing = "antialiasing",
        /// Grids for the corners of faces.
        Grid = "grid",
        /// Segments through w = 0, cut before or after the division.
        Clipping = "clipping",
        /// Filters of pictures on surfaces.
        TextureFilter = "texture-filter",
        /// Shadow maps: their size, bias and soft edge.
        Shadows = "shadows",
        /// The camera of a photograph, from lines that are a pixel off.
        Photograph = "photograph",
    }
    /// Its name on the command line and in JSON.
    pub fn name
}

impl Serialize for Study {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

crate::worded! {
    /// The unit of an error.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Unit {
        /// Scene units.
        SceneUnits = "scene units",
        /// Radians.
        Radians = "radians",
        /// A share of the quantity itself.
        Relative = "relative",
        /// A share of the depths, or of the pixels, under test.
        Share = "share",
        /// A share of the whole range of a colour's channels, or of a pixel's area.
        Color = "color",
        /// In normalised device coordinates, 2 from side to side.
        Ndc = "ndc",
    }
    /// Its name in JSON.
    pub fn name
}

impl Serialize for Unit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// The results of one method on the inputs of one case.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The series of inputs.
    pub case: String,
    /// The stiffness of the inputs.
    pub parameter: f64,
    /// The way of computing.
    pub method: &'static str,
    /// Root mean square of the errors.
    pub error: f64,
    /// The greatest error.
    pub error_max: f64,
    /// The unit of the errors.
    pub unit: Unit,
    /// Median time of one item, in nanoseconds.
    pub nanos: f64,
    /// The ends of an interval that holds it with 95 %.
    pub nanos_low: f64,
    /// The upper one.
    pub nanos_high: f64,
    /// Bytes that the method keeps for one item.
    pub bytes: f64,
    /// log₂ of the distance from the truth in units of the last place of an `f64`, averaged.
    pub bits: f64,
    /// No other method of the same case and parameter has at most its error and an interval of time wholly below its
    /// own.
    pub pareto: bool,
    /// More turns could change [`pareto`](Self::pareto).
    pub undecided: bool,
    /// The theoretical prediction of `error`, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub predicted: Option<f64>,
    /// The figure file of the worst input, if the input is a camera.
    pub figure: Option<String>,
}

/// The result of a study.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Findings {
    /// The study that was measured.
    pub study: Study,
    /// The reference of the errors.
    pub reference: &'static str,
    /// Bytes of the inputs of one pass. They must stay in a cache, or the times wouldn't be those of the arithmetic.
    pub working_set: usize,
    /// Each (case, parameter) with all methods.
    pub rows: Vec<Row>,
}

/// The effort of a run: inputs and time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// The seed. The same one gives the same inputs, and so the same errors.
    pub seed: u64,
    /// Approximate time for measuring the methods of one study.
    pub seconds: f64,
    /// True for the inputs that a user gets; false for a few of them, for tests.
    pub thorough: bool,
}

/// Runs one study. If cancelled, it ends early, with the results so far. It pauses after each method of each series of
/// inputs.
pub async fn run(study: Study, effort: &Effort, progress: &Progress) -> Findings {
    let lab = Lab { effort: *effort, progress: progress.clone() };
    match study {
        Study::VertexTransform => studies::vertex_transform::run(&lab).await,
        Study::Basis => studies::basis::run(&lab).await,
        Study::RepeatedOperations => studies::repeated_operations::run(&lab).await,
        Study::DepthBuffer => studies::depth_buffer::run(&lab).await,
        Study::Visibility => studies::visibility::run(&lab).await,
        Study::Shading => studies::shading::run(&lab).await,
        Study::Antialiasing => studies::antialiasing::run(&lab).await,
        Study::Grid => studies::grid::run(&lab).await,
        Study::Clipping => studies::clipping::run(&lab).await,
        Study::TextureFilter => studies::texture_filter::run(&lab).await,
        Study::Shadows => studies::shadows::run(&lab).await,
        Study::Photograph => studies::photograph::run(&lab).await,
    }
}

/// Turns in which the methods of a case are timed.
const TURNS: usize = 7;
/// Slow methods get this many at least.
const LEAST_TURNS: usize = 2;
/// The time of all methods of a case together after which they count as slow.
const SLOW: Duration = Duration::from_millis(400);

/// The working state of a study.
struct Lab {
    effort: Effort,
    progress: Progress,
}

impl Lab {
    /// The watch of a study that times this many methods of cases in each turn, on a number of setups each.
    fn watch(&self, methods: usize, setups: usize) -> Watch {
        self.progress.begin(Activity::Measuring, methods * self.most_turns());
        let share = self.effort.seconds / (methods * setups * self.most_turns()).max(1) as f64;
        Watch {
            slice: Duration::try_from_secs_f64(share).unwrap_or_default(),
            tick: clock::resolution(),
            progress: self.progress.clone(),
        }
    }

    /// Without time for it, there's one turn.
    const fn most_turns(&self) -> usize {
        if self.effort.seconds > 0.0 { TURNS } else { 1 }
    }

    /// Measures methods in turns, so that whatever slows the machine slows them alike. `run` measures one, by its
    /// place, and notes its errors in the first turn. Of several trials of a method the first is timed. Slow methods
    /// get fewer turns. Pauses after each.
    async fn in_turns<const N: usize>(
        &self,
        methods: usize,
        mut run: impl AsyncFnMut(usize, &mut [Trial; N]),
    ) -> Vec<[Trial; N]> {
        let mut trials: Vec<[Trial; N]> = (0..methods).map(|_| std::array::from_fn(|_| Trial::default())).collect();
        let start = clock::now();
        for turn in 0..self.most_turns() {
            let left = self.most_turns() - turn;
            if self.progress.is_cancelled() || turn >= LEAST_TURNS && clock::now().saturating_sub(start) > SLOW {
                self.progress.advance(left * methods);
                break;
            }
            for k in 0..methods {
                let k = (k + turn) % methods;
                run(k, &mut trials[k]).await;
                if let Some(timed) = trials[k].first_mut() {
                    timed.end_turn();
                }
                self.progress.advance_and_pause(1).await;
            }
        }
        for trials in &mut trials {
            if let [timed, others @ ..] = &mut trials[..] {
                others.iter_mut().for_each(|trial| trial.takes_time_of(timed));
            }
        }
        trials
    }

    /// Measures methods, each on all setups.
    async fn methods<M, S>(
        &self,
        methods: &[(&'static str, M)],
        setups: &[S],
        mut measure: impl FnMut(&M, usize, &S, &mut Trial),
    ) -> Vec<Method> {
        let run = async |k: usize, [trial]: &mut [Trial; 1]| {
            for (input, setup) in setups.iter().enumerate() {
                measure(&methods[k].1, input, setup, trial);
            }
        };
        let trials = self.in_turns(methods.len(), run).await;
        methods.iter().zip(trials).map(|((name, _), [trial])| Method::new(name, trial)).collect()
    }

    /// `all` of something, or `few` for tests.
    const fn many(&self, all: usize, few: usize) -> usize {
        if self.effort.thorough { all } else { few }
    }
}

/// The methods of one case and parameter, before the front is known.
struct Group {
    case: String,
    parameter: f64,
    unit: Unit,
    methods: Vec<Method>,
}

/// The results of one method of a group.
struct Method {
    name: &'static str,
    trial: Trial,
    predicted: Option<f64>,
}

impl Method {
    const fn new(name: &'static str, trial: Trial) -> Self {
        Self { name, trial, predicted: None }
    }
}

impl Group {
    /// The rows, each with the figure of its worst input.
    fn rows(self, study: Study, figure: impl Fn(usize) -> Option<String>) -> Vec<Row> {
        let times: Vec<(f64, Interval)> = self.methods.iter().map(|m| (m.trial.error(), m.trial.nanos())).collect();
        let verdicts = decide(&times, |a, b| a <= b);
        self.methods
            .iter()
            .zip(times.iter().zip(verdicts))
            .map(|(Method { name, trial, predicted }, (&(error, nanos), (pareto, undecided)))| Row {
                case: self.case.clone(),
                parameter: self.parameter,
                method: name,
                error,
                error_max: trial.worst(),
                unit: self.unit,
                nanos: nanos.median,
                nanos_low: nanos.low,
                nanos_high: nanos.high,
                bytes: memory::bytes(study, name, self.parameter),
                bits: trial.bits(),
                pareto,
                undecided,
                predicted: *predicted,
                figure: figure(trial.worst_input()),
            })
            .collect()
    }
}
