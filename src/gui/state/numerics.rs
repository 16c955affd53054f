//! The studies of error against run time: which is shown, what has been measured, and the thread that measures.

use std::collections::BTreeMap;
use std::time::Duration;

use eframe::egui;

use crate::clock;
use crate::gui::worker::{Running, Work, Worker, one_by_one};
use crate::numerics::{self, Effort, Findings, Study};
use crate::progress::Progress;

/// What a study is asked with.
type Asked = (Study, Effort);

/// The study, and what was found, where it was not given up.
type Measured = (Study, Option<Findings>);

/// The panel of studies.
#[derive(Debug)]
pub struct Numerics {
    /// The panel is shown.
    pub shown: bool,
    /// The study that is shown.
    pub study: Study,
    /// Which of its cases, by its place.
    pub case: usize,
    /// Error over time, rather than over the parameter.
    pub over_time: bool,
    /// Which parameter the table is of, by its place; `None`: the stiffest.
    pub parameter: Option<usize>,
    /// How much is tried.
    pub effort: Effort,
    found: BTreeMap<&'static str, Findings>,
    worker: Worker<Asked, Measured>,
    measuring: Option<Study>,
}

impl Default for Numerics {
    fn default() -> Self {
        let work = || -> Work<Asked, Measured> {
            one_by_one(async |(study, effort): Asked, progress: &Progress| {
                let findings = numerics::run(study, &effort, progress).await;
                // What was cancelled is not whole.
                (study, (!progress.is_cancelled()).then_some(findings))
            })
        };
        Self {
            shown: false,
            study: Study::VertexTransform,
            case: 0,
            over_time: false,
            parameter: None,
            effort: Effort { seed: 1, seconds: 3.0, thorough: true },
            found: BTreeMap::new(),
            worker: Worker::new("numerics", clock::now, work),
            measuring: None,
        }
    }
}

impl Numerics {
    /// Measures the study that is shown, beside the window's thread.
    pub fn measure(&mut self, ctx: &egui::Context) {
        self.measuring = Some(self.study);
        self.worker.ask(ctx, 0, (self.study, self.effort));
    }

    /// Gives up what is being measured.
    pub fn cancel(&mut self) {
        self.worker.cancel();
        self.measuring = None;
    }

    /// The study that is being measured, and which share of it is done.
    #[must_use]
    pub fn measuring(&self) -> Option<(Study, Option<f32>)> {
        let share = self.worker.running().and_then(|Running { now, .. }| now).and_then(|(_, share)| share);
        self.measuring.map(|study| (study, share))
    }

    /// What has been found about a study.
    #[must_use]
    pub fn found(&self, study: Study) -> Option<&Findings> {
        self.found.get(study.name())
    }

    /// Takes what has been measured. Waits for it as long as `patience` says.
    pub fn take(&mut self, patience: Duration) {
        let [done] = self.worker.take(patience);
        let Some(done) = done else { return };
        // Where the work panicked nothing was found, and the button is there again.
        if let Some((study, findings)) = done.outcome {
            if let Some(findings) = findings {
                self.found.insert(study.name(), findings);
            }
            if self.measuring == Some(study) {
                self.measuring = None;
            }
        } else {
            self.measuring = None;
        }
    }
}
