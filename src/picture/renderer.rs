//! Makes pictures from requests: the drawing of the view, then its pixels.

use std::sync::Arc;
use std::time::Duration;

use tiny_skia::Pixmap;

use super::sheet::gap;
use super::{Account, Picture};
use crate::appearance::Texture;
use crate::pipeline::Frame;
use crate::raster::Rasterizer;
use crate::views::{self, Palette, Request, TimedPipeline, View};

/// Makes pictures; keeps its buffers, and the image on the view window, from one to the next.
///
/// *Guarantees*: equal requests give equal pixels, whatever has been drawn before.
#[derive(Debug, Default)]
pub struct Renderer {
    /// One for each picture: each finds its own buffers again.
    pipelines: [TimedPipeline; 3],
    /// For the image that the view window of the world shows.
    window_pipeline: TimedPipeline,
    rasterizer: Rasterizer,
    on_window: Option<(Request, Arc<Texture>)>,
    clock: Option<fn() -> Duration>,
}

impl Renderer {
    /// Times every stage from now on, by a clock that gives the time since any moment that stays the same; `None`: no more.
    pub fn measure(&mut self, clock: Option<fn() -> Duration>) {
        self.clock = clock;
    }

    /// Forgets pictures that were kept: the next one is made from scratch, in the same memory.
    pub fn forget(&mut self) {
        self.on_window = None;
    }

    /// A picture. `None` where a side is 0, or there is no memory for so many pixels.
    pub fn pixels(&mut self, request: &Request) -> Option<Picture> {
        let mut picture = Picture::default();
        self.pixels_into(request, &mut picture).map(|_| picture)
    }

    /// A picture as [`pixels`](Self::pixels) gives it, over another one, and how it came about. Where the result is `None`, the
    /// other one is lost too.
    pub fn pixels_into(&mut self, request: &Request, picture: &mut Picture) -> Option<Account> {
        let now = self.clock.unwrap_or(|| Duration::ZERO);
        let start = now();
        let (frame, on_window) = self.timed_drawing(request)?;
        let mut pixmap = picture.take_pixmap().or_else(|| Pixmap::new(1, 1))?;
        self.rasterizer.measure(self.clock);
        if !self.rasterizer.paint_into(&frame.drawing, &mut pixmap) {
            return None;
        }
        *picture = pixmap.into();
        let total = now().saturating_sub(start);
        let account = match self.clock {
            Some(_) => Account::of(&frame, self.rasterizer.work(), on_window, total),
            None => Account::default(),
        };
        self.pipelines[request.view.index()].stages.recycle(frame.drawing);
        Some(account)
    }

    /// Pictures side by side; of one, the picture itself. `None` as for [`pixels`](Self::pixels), and without requests.
    pub fn sheet(&mut self, requests: &[Request]) -> Option<Picture> {
        match requests {
            [] => None,
            [one] => self.pixels(one),
            [first, ..] => {
                let pictures: Option<Vec<Picture>> = requests.iter().map(|request| self.pixels(request)).collect();
                let ground = Palette::of(first.look.style.theme).surround;
                Picture::side_by_side(pictures?, gap(first.size.scale), ground)
            }
        }
    }

    /// The drawing of a picture with its plan and report, for outputs that are not made of pixels: what [`pixels`](Self::pixels)
    /// paints, or what is asked for by [`Output`](crate::pipeline::Output) in the request. `None` where there is no memory for
    /// the image on the window.
    pub fn drawing(&mut self, request: &Request) -> Option<Frame> {
        self.timed_drawing(request).map(|(frame, _)| frame)
    }

    /// The drawing of a picture, and the time that the image on the window took, if one was drawn for it.
    fn timed_drawing(&mut self, request: &Request) -> Option<(Frame, Option<Duration>)> {
        let (on_window, time) = match request.view {
            View::World => {
                let (texture, time) = self.image_on_window(request)?;
                (Some(texture), time)
            }
            View::Canonical | View::Image => (None, None),
        };
        let pipeline = &mut self.pipelines[request.view.index()];
        pipeline.clock = self.clock;
        Some((views::frame(request, on_window.as_ref(), pipeline), time))
    }

    /// The image that the window of the world shows; drawn again only when what it shows has changed.
    fn image_on_window(&mut self, request: &Request) -> Option<(Arc<Texture>, Option<Duration>)> {
        let image = request.image_on_window();
        if let Some((made_from, texture)) = &self.on_window
            && *made_from == image
        {
            return Some((Arc::clone(texture), None));
        }
        let now = self.clock.unwrap_or(|| Duration::ZERO);
        let start = now();
        self.rasterizer.measure(None);
        let frame = views::frame(&image, None, &mut self.window_pipeline);
        let picture = Picture::from(self.rasterizer.paint(&frame.drawing)?);
        self.window_pipeline.stages.recycle(frame.drawing);
        let texture = Arc::new(picture.into_texture());
        self.on_window = Some((image, Arc::clone(&texture)));
        Some((texture, Some(now().saturating_sub(start))))
    }
}
