//! The triangle followed step by step. Its pixels are found beside the window's thread in heavy scenes.

use std::sync::Arc;

use eframe::egui;

use crate::figure::{ShownTriangle, TriangleStep};
use crate::gui::kit::frames;
use crate::picture::{FollowedTriangle, TrianglePixels};
use crate::pipeline::one_triangle::TriangleSteps;
use crate::progress::{Progress, at_once};
use crate::views::Request;
use camera_lab_desk::background::memo::MAX_WAIT;
use camera_lab_desk::{Latest, is_heavy};

/// The numbers of the triangle followed step by step.
#[derive(Debug)]
pub struct TriangleNumbers {
    followed: FollowedTriangle,
    search: Latest<Request, Option<Arc<TrianglePixels>>>,
}

impl Default for TriangleNumbers {
    fn default() -> Self {
        let search = Latest::new("triangle", || {
            let mut followed = FollowedTriangle::default();
            async move |request: &Request, _: &Progress| followed.found(request).await.and_then(|(_, pixels)| pixels)
        });
        Self { followed: FollowedTriangle::default(), search }
    }
}

/// The pixels that a triangle covers.
#[derive(Clone, Debug)]
pub(in crate::gui) enum Covered {
    /// `None` if there are no pixels to show.
    Found(Option<Arc<TrianglePixels>>),
    /// They are being found.
    Searched,
}

impl TriangleNumbers {
    /// The steps of the triangle that a request shows, and its pixels in the steps that need them. `None` if the
    /// request shows none, or there is no such triangle. If pixels are still being found, requests a frame of `ctx`
    /// when they are there.
    pub(in crate::gui) fn found(&mut self, ctx: &egui::Context, request: &Request) -> Option<(TriangleSteps, Covered)> {
        let Some(triangle) = &request.shot.show.triangle else {
            self.search.give_up();
            return None;
        };
        if !triangle.step.needs_pixels() || !is_heavy(&request.scene) {
            self.search.give_up();
            let (steps, pixels) = at_once(self.followed.found(request))?;
            return Some((steps, Covered::Found(pixels)));
        }
        // The same for each step that needs them.
        let triangle = ShownTriangle { step: TriangleStep::Pixels, pixel: None, ..triangle.clone() };
        self.search.ask(&frames(ctx), request.clone().with_shot(|shot| shot.show.triangle = Some(triangle.clone())));
        self.search.poll(MAX_WAIT);
        let covered = match self.search.answer() {
            Some(pixels) => Covered::Found(pixels.clone()),
            None if self.is_searched() => Covered::Searched,
            // The search has panicked.
            None => Covered::Found(None),
        };
        Some((self.followed.steps(request)?, covered))
    }

    /// True while its pixels are being found.
    pub(in crate::gui) fn is_searched(&self) -> bool {
        self.search.waiting().is_some()
    }
}
