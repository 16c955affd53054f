//! The studies of error against run time: the displayed one, the results, and the thread that measures.

use std::collections::BTreeMap;
use std::time::Duration;

use eframe::egui;

use super::this_figure::ThisFigure;
use crate::gui::kit::frames;
use crate::numerics::{self, Effort, Findings, Study};
use camera_lab_desk::{Latest, Running};

/// The panel of studies.
#[derive(Debug)]
pub struct Numerics {
    /// True if the panel is shown.
    pub shown: bool,
    /// True for the study of the figure on the screen, rather than one of random cameras.
    pub of_figure: bool,
    /// The study of the figure on the screen.
    pub this_figure: ThisFigure,
    /// The displayed study.
    pub study: Study,
    /// The case, by its index.
    pub case: usize,
    /// True for error over time, rather than over the parameter.
    pub over_time: bool,
    /// The parameter of the table, by its index. `None` for the stiffest.
    pub parameter: Option<usize>,
    /// The effort of a run.
    pub effort: Effort,
    found: BTreeMap<&'static str, Findings>,
    /// The study that was begun by itself last.
    begun: Option<Study>,
    measured: Latest<(Study, Effort), Findings>,
}

impl Default for Numerics {
    fn default() -> Self {
        Self {
            shown: false,
            of_figure: true,
            this_figure: ThisFigure::default(),
            study: Study::VertexTransform,
            case: 0,
            over_time: false,
            parameter: None,
            effort: Effort { seed: 1, seconds: 3.0, thorough: true },
            found: BTreeMap::new(),
            begun: None,
            measured: Latest::new("numerics", || {
                async |(study, effort): &(Study, Effort), progress: &crate::progress::Progress| {
                    numerics::run(*study, effort, progress).await
                }
            }),
        }
    }
}

impl Numerics {
    /// Measures the displayed study, beside the window's thread.
    pub fn measure(&mut self, ctx: &egui::Context) {
        self.measured.ask_again(&frames(ctx), (self.study, self.effort));
    }

    /// Begins the displayed study, once, if it hasn't been measured. A running one makes room for it.
    pub(in crate::gui) fn begin(&mut self, ctx: &egui::Context) {
        if self.begun != Some(self.study) && self.found(self.study).is_none() {
            self.begun = Some(self.study);
            self.measure(ctx);
        }
    }

    /// Cancels the running study.
    pub fn cancel(&mut self) {
        self.measured.stop();
        self.measured.give_up();
    }

    /// The study being measured, and the share already done.
    pub fn measuring(&self) -> Option<(Study, Option<f32>)> {
        let share = self.measured.running().and_then(|Running { now, .. }| now).and_then(|(_, share)| share);
        self.measured.waiting().map(|(study, _)| (*study, share))
    }

    /// The results of a study.
    pub fn found(&self, study: Study) -> Option<&Findings> {
        self.found.get(study.name())
    }

    /// Takes results. Waits up to `patience`.
    pub fn take(&mut self, patience: Duration) {
        if let Some(((study, _), findings)) = self.measured.take(patience) {
            self.found.insert(study.name(), findings);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The one that was given up ends later, and doesn't affect the one that is wanted now.
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
