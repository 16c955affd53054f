//! The study of the figure on the screen: error, time and memory of each way to draw it.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use eframe::egui::{self, Grid, ProgressBar, RichText, ScrollArea, Ui};
use egui_plot::{Plot, PlotPoint};

use super::{GLANCE, plot};
use crate::camera::ImageSize;
use crate::figure::Figure;
use crate::gui::kit::frames::frames;
use crate::gui::kit::{Explained, choice, export_button, keep_in_sight, logarithmic_x, logarithmic_y, still};
use crate::numerics::this_figure::{self, Effort, NoExactImage, Study, Subject, apply};
use crate::progress::Progress;
use crate::views::{Request, SharedScene, Size};
use camera_lab_desk::{Action, Latest, MethodImage, Model, Running};
use camera_lab_words::pictures::labels;
use camera_lab_words::why::{numerics as other_words, this_figure as words};

/// Distance within which the pointer catches a point, in points.
const NEAR: f32 = 14.0;
/// Room for the answers below the chart.
const ANSWERS: f32 = 74.0;

/// The figure to examine.
#[derive(Clone, PartialEq)]
struct Asked {
    figure: Arc<Figure>,
    scene: SharedScene,
    request: Request,
    set_aside: Vec<&'static str>,
    /// Results after each round go here.
    partial: Partial,
}

/// The results so far. All of one question.
#[derive(Clone, Default)]
struct Partial(Arc<Mutex<Option<Arc<Study>>>>);

impl PartialEq for Partial {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Partial {
    fn take(&self) -> Option<Arc<Study>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// The state of the study.
pub(super) struct ThisFigure {
    effort: Effort,
    asked: Option<Asked>,
    study: Option<Arc<Study>>,
    failed: Option<NoExactImage>,
    job: Latest<Asked, Result<Arc<Study>, NoExactImage>>,
    /// The choice that gives the colours, by its place; the most telling one at first.
    by: Option<usize>,
    /// The way whose image is kept in the view.
    kept: Option<usize>,
    image: Latest<Pictured, Option<Arc<MethodImage>>>,
}
