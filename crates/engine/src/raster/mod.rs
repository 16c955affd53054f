//! [`Drawing`] → pixels.
//!
//! Start with [`textbook`], a complete rasterizer without tricks. The rest of this folder paints the same bytes fast.
//! `surfaces` are painted first, in bands of rows, on as many threads as there are. Over them, and compared with their
//! `depth`, come `strokes`, then areas, marks and texts (`label`). `grid` and `pixel` hold the rules that all share:
//! the grid of vertices, the samples of a pixel, and the arithmetic of colours. The number of threads changes no byte.

mod bands;
mod depth;
mod grid;
mod label;
mod pixel;
mod strokes;
mod surfaces;
#[cfg(feature = "text")]
mod text;
pub mod textbook;

use std::time::Duration;

use tiny_skia::{Color, Pixmap};

use crate::appearance::Rgba;
use crate::drawing::{Drawing, ShadowMap, Surface};
use crate::limits::{MAX_PIXELS, MAX_SIDE};
use crate::progress::{Activity, Progress, at_once};
pub use depth::DepthBuffer;
use depth::Occluders;
pub use label::{FADED, HALO, MarkLayer, area_outline, mark_layers, mark_outline, path_of};
use surfaces::Wanted;
#[cfg(feature = "text")]
pub use text::baseline;

/// Draws pictures. Keeps its buffers from one to the next.
#[derive(Clone, Debug, Default)]
pub struct Rasterizer {
    surfaces: surfaces::Surfaces,
    depth: DepthBuffer,
    tint_depth: DepthBuffer,
    strokes: strokes::Strokes,
    clock: Option<fn() -> Duration>,
    work: Work,
    progress: Progress,
}

/// Statistics of drawing a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Triangles that came in.
    pub triangles: usize,
    /// Triangles that were dropped before filling: so small, or so far outside, that they own no sample.
    pub empty: usize,
    /// Samples inside triangles, once for each triangle. Without antialiasing a sample is a pixel. Zero without a
    /// clock.
    pub covered: u64,
    /// Samples that were drawn, because nothing nearer had been drawn before. Zero without a clock.
    pub written: u64,
    /// Time of the surfaces. Zero without a clock.
    pub surfaces: Duration,
    /// Time of strokes, marks and texts. Zero without a clock.
    pub strokes: Duration,
}

impl Rasterizer {
    /// Paints `drawing` on a fresh pixmap. `None` if a side is 0 or above [`MAX_SIDE`], or there are more than
    /// [`MAX_PIXELS`].
    pub fn paint(&mut self, drawing: &Drawing) -> Option<Pixmap> {
        let mut pixmap = new_pixmap(drawing)?;
        at_once(self.paint_on(drawing, &mut pixmap, [0, 1]));
        Some(pixmap)
    }

    /// Paints `drawing` on `pixmap`, which is replaced if it has another size. For pictures that follow one another.
    /// False, and nothing is painted, if [`paint`](Self::paint) would give `None`. On one thread it pauses after each
    /// band of rows.
    pub async fn paint_into(&mut self, drawing: &Drawing, pixmap: &mut Pixmap) -> bool {
        self.paint_pass(drawing, pixmap, [0, 1]).await
    }

    /// Like [`paint_into`](Self::paint_into), for one of several passes over a picture: its number, from 0, and how
    /// many there are. The progress continues from one to the next.
    pub async fn paint_pass(&mut self, drawing: &Drawing, pixmap: &mut Pixmap, pass: [usize; 2]) -> bool {
        if (pixmap.width(), pixmap.height()) != (drawing.width, drawing.height) {
            let Some(fresh) = new_pixmap(drawing) else { return false };
            *pixmap = fresh;
        }
        self.paint_on(drawing, pixmap, pass).await;
        true
    }

    /// Measures pictures from now on, by a clock that gives the time since a fixed moment. `None` ends that.
    pub fn measure(&mut self, clock: Option<fn() -> Duration>) {
        self.clock = clock;
    }

    /// Reports from now on how far a picture has come. A cancelled picture ends early and isn't whole.
    pub fn watch(&mut self, progress: &Progress) {
        self.progress = progress.clone();
    }

    /// Statistics of the last picture. The counts don't depend on the number of threads.
    pub fn work(&self) -> Work {
        self.work
    }

    /// The depth buffer of the last picture.
    pub fn depth(&self) -> &DepthBuffer {
        &self.depth
    }

    async fn paint_on(&mut self, drawing: &Drawing, pixmap: &mut Pixmap, pass: [usize; 2]) {
        let now = self.clock.unwrap_or(|| Duration::ZERO);
        let start = now();
        let (maps, tints) = (unpainted(drawing), tints(drawing));
        let has_strokes = drawing.strokes.iter().any(|strokes| !strokes.polylines.is_empty());
        let times = 1 + usize::from(tints.is_some()) + usize::from(has_strokes);
        let rows = maps.iter().map(|map| rows_of(map)).sum::<usize>() + times * drawing.height as usize;
        self.progress.begin_pass(Activity::Painting, rows, pass);
        for map in maps {
            self.paint_map(map).await;
        }
        if let Some(tints) = &tints {
            // For its depth alone, since the picture is painted over it.
            let wanted = Wanted { slopes: true, counts: false };
            self.surfaces.paint(tints, pixmap, &mut self.tint_depth, wanted, &self.progress).await;
        }
        let wanted = Wanted { slopes: !is_bare(drawing), counts: self.clock.is_some() };
        self.surfaces.paint(drawing, pixmap, &mut self.depth, wanted, &self.progress).await;
        let middle = now();
        let faces = Occluders { opaque: &self.depth, tints: tints.is_some().then_some(&self.tint_depth) };
        self.strokes.draw(pixmap, faces, drawing, &self.progress).await;
        for area in &drawing.areas {
            label::area(pixmap, area);
        }
        for mark in &drawing.marks {
            label::mark(pixmap, faces, mark);
        }
        #[cfg(feature = "text")]
        for text in &drawing.labels {
            text::draw(pixmap, &self.depth, text);
        }
        let triangles = drawing.surfaces.iter().map(|surface| surface.triangles.len()).sum();
        let (kept, covered, written) = self.surfaces.work();
        self.work = Work {
            triangles,
            empty: triangles - kept,
            covered,
            written,
            surfaces: middle.saturating_sub(start),
            strokes: now().saturating_sub(middle),
        };
    }
}

impl Rasterizer {
    /// Paints the depths that a light sees, unless that has been done. It pauses as [`paint_into`](Self::paint_into)
    /// does.
    pub async fn paint_shadows(&mut self, map: &ShadowMap) {
        self.progress.begin(Activity::Painting, rows_of(map));
        self.paint_map(map).await;
    }

    /// Paints the map.
    async fn paint_map(&mut self, map: &ShadowMap) {
        let wanted = Wanted { slopes: false, counts: false };
        let Some(views) = map.unpainted() else { return };
        let (mut depth, mut depths) = (DepthBuffer::default(), Vec::with_capacity(views.len()));
        for view in &*views {
            let mut values = Vec::new();
            if !view.surfaces.is_empty() {
                let Some(mut pixmap) = new_pixmap(view) else { return };
                self.surfaces.paint(view, &mut pixmap, &mut depth, wanted, &self.progress).await;
                if self.progress.is_cancelled() {
                    return;
                }
                // A large map has as many bytes as a picture, so only its depths stay.
                drop(pixmap);
                values = depth.take_values();
            }
            depths.push(values);
        }
        map.keep(depths);
    }
}

/// The shadow maps of a drawing that no picture has painted yet, each once.
fn unpainted(drawing: &Drawing) -> Vec<&ShadowMap> {
    let mut maps: Vec<&ShadowMap> = Vec::new();
    for map in drawing.surfaces.iter().flat_map(|surface| &surface.shadows).map(|shadow| &*shadow.map) {
        if map.depths().is_none() && !maps.contains(&map) {
            maps.push(map);
        }
    }
    maps
}

/// The rows of a map that are still to be painted.
fn rows_of(map: &ShadowMap) -> usize {
    let views = map.unpainted().unwrap_or_default();
    views.iter().filter(|view| !view.surfaces.is_empty()).map(|view| view.height as usize).sum()
}

fn new_pixmap(drawing: &Drawing) -> Option<Pixmap> {
    let (width, height) = (drawing.width, drawing.height);
    let fits = width.max(height) <= MAX_SIDE && u64::from(width) * u64::from(height) <= MAX_PIXELS;
    if fits { Pixmap::new(width, height) } else { None }
}

/// True if nothing is compared with the depths of surfaces.
fn is_bare(drawing: &Drawing) -> bool {
    drawing.strokes.is_empty() && drawing.marks.is_empty() && drawing.labels.is_empty()
}

/// The tints of a drawing as opaque surfaces. `None` if there are none, or nothing to dim.
fn tints(drawing: &Drawing) -> Option<Drawing> {
    if is_bare(drawing) {
        return None;
    }
    let tint = |surface: &Surface| {
        let triangles: Vec<[u32; 3]> = surface.tints().collect();
        (!triangles.is_empty()).then(|| Surface::solid(surface.positions.clone(), triangles, drawing.background))
    };
    let opaque = |surface| Surface { translucent: false, ..surface };
    let surfaces: Vec<Surface> = drawing.surfaces.iter().filter_map(tint).map(opaque).collect();
    (!surfaces.is_empty())
        .then(|| Drawing { surfaces, ..Drawing::new(drawing.width, drawing.height, drawing.background) })
}

fn color(c: Rgba) -> Color {
    Color::from_rgba8(c.r, c.g, c.b, c.a)
}
