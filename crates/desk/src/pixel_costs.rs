//! The cost of the pixels of a picture, counted beside the window's thread while the stages are explained.

use std::time::Duration;

use crate::background::memo::Latest;
use crate::model::Model;
use crate::picture::{Costs, Renderer};
use crate::views::Request;

/// The costs of the last picture.
#[derive(Debug)]
pub struct PixelCosts(Latest<Request, Option<Costs>>);

impl Default for PixelCosts {
    fn default() -> Self {
        let count = || {
            let mut renderer = Renderer::default();
            async move |request: &Request, progress: &crate::progress::Progress| renderer.costs(request, progress).await
        };
        Self(Latest::new("costs", count))
    }
}

impl PixelCosts {
    /// The costs of a picture. `None` until they're counted.
    pub fn known(&self, request: &Request) -> Option<&Costs> {
        let (of, costs) = self.0.newest()?;
        costs.as_ref().filter(|_| of == request)
    }
}

impl Model {
    /// Has the costs of the picture counted whose stages are explained, unless something moves.
    pub fn count_pixels(&mut self, window: &dyn crate::Wake, is_down: bool) {
        self.costs.0.poll(Duration::ZERO);
        if let Some(request) = self.frame.explained.clone().filter(|_| !is_down && self.motion.is_none()) {
            self.costs.0.ask(window, request);
        }
    }
}
