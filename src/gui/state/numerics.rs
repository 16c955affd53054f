//! The studies of error against run time: the one shown, the results, and the thread that measures.

use std::collections::BTreeMap;
use std::time::Duration;

use eframe::egui;

use crate::clock;
use crate::gui::worker::{Running, Work, Worker, one_by_one};
use crate::numerics::{self, Effort, Findings, Study};
use crate::progress::Progress;

/// What a study is asked with, and the number of the request.
type StudyRequest = (u64, Study, Effort);

/// The number of the request, the study, and what was found, where it was not given up.
type Measured = (u64, Study, Option<Findings>);

/// The panel of studies.
#[derive(Debug)]
pub struct Numerics {
    /// The panel is shown.
    pub shown: bool,
    /// The study that is shown.
    pub study: Study,
    /// The case, by its index.
    pub case: usize,
    /// Error over time, rather than over the parameter.
    pub over_time: bool,
    /// The parameter of the table, by its index; `None`: the stiffest.
    pub parameter: Option<usize>,
    /// The effort of a run.
    pub effort: Effort,
    found: BTreeMap<&'static str, Findings>,
    worker: Worker<StudyRequest, Measured>,
    /// The study that is being measured, with the number of its request: one that was given up may still come to its
    /// end.
    measuring: Option<(u64, Study)>,
    requests: u64,
}

impl Default for Numerics {
    fn default() -> Self {
        let work = || -> Work<StudyRequest, Measured> {
            one_by_one(async |(request, study, effort): StudyRequest, progress: &Progress| {
                let findings = numerics::run(study, &effort, progress).await;
                // What was cancelled is not whole.
                (request, study, (!progress.is_cancelled()).then_some(findings))
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
            requests: 0,
        }
    }
}

impl Numerics {
    /// Measures the study that is shown, beside the window's thread.
    pub fn measure(&mut self, ctx: &egui::Context) {
        self.requests += 1;
        self.measuring = Some((self.requests, self.study));
        self.worker.ask(ctx, 0, (self.requests, self.study, self.effort));
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
        self.measuring.map(|(_, study)| (study, share))
    }

    /// The results of a study.
    #[must_use]
    pub fn found(&self, study: Study) -> Option<&Findings> {
        self.found.get(study.name())
    }

    /// Takes what has been measured. Waits for it as long as `patience` says.
    pub fn take(&mut self, patience: Duration) {
        let [done] = self.worker.take(patience);
        let Some(done) = done else { return };
        // Where the work panicked nothing was found, and the button is there again.
        if let Some((request, study, findings)) = done.outcome {
            if let Some(findings) = findings {
                self.found.insert(study.name(), findings);
            }
            if self.measuring == Some((request, study)) {
                self.measuring = None;
            }
        } else {
            self.measuring = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The one that was given up comes to its end later, and says nothing of the one that is wanted now.
    #[test]
    fn a_study_that_is_given_up_and_begun_again_is_measured_until_it_is_found() {
        let ctx = egui::Context::default();
        let mut numerics = Numerics {
            study: Study::Basis,
            effort: Effort { seed: 1, seconds: 0.0, thorough: false },
            ..Numerics::default()
        };
        numerics.measure(&ctx);
        numerics.cancel();
        numerics.measure(&ctx);
        while numerics.found(Study::Basis).is_none() {
            assert!(numerics.measuring().is_some(), "the button would measure it a second time");
            numerics.take(Duration::from_secs(60));
        }
        assert!(numerics.measuring().is_none());
    }
}
