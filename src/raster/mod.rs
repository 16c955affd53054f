//! [`Drawing`] → pixels.

mod coverage;
mod depth;
mod fill;
mod label;
mod line;
mod setup;
pub mod text;

use tiny_skia::{Color, Pixmap};

use crate::appearance::Rgba;
use crate::drawing::Drawing;
pub use depth::DepthBuffer;

/// The longest side of a picture, in pixels.
pub const MAX_SIDE: u32 = 16384;
/// The most pixels of a picture: 15360 × 8640, with a little room.
pub const MAX_PIXELS: u64 = 1 << 27;

/// Draws pictures; keeps its buffers from one to the next.
#[derive(Clone, Debug, Default)]
pub struct Rasterizer {
    samples: fill::Samples,
    depth: DepthBuffer,
    strokes: line::Strokes,
}

impl Rasterizer {
    /// Paints `drawing` on a fresh pixmap. `None` where a side is 0 or above [`MAX_SIDE`], or there are more than
    /// [`MAX_PIXELS`].
    pub fn paint(&mut self, drawing: &Drawing) -> Option<Pixmap> {
        let mut pixmap = new_pixmap(drawing)?;
        self.paint_on(drawing, &mut pixmap);
        Some(pixmap)
    }

    /// Paints `drawing` on `pixmap`, which is replaced if it has another size: for pictures that follow one another. False,
    /// and nothing is painted, where [`paint`](Self::paint) would give `None`.
    pub fn paint_into(&mut self, drawing: &Drawing, pixmap: &mut Pixmap) -> bool {
        if (pixmap.width(), pixmap.height()) != (drawing.width, drawing.height) {
            let Some(fresh) = new_pixmap(drawing) else { return false };
            *pixmap = fresh;
        }
        self.paint_on(drawing, pixmap);
        true
    }

    /// The depth buffer of the last picture.
    #[must_use]
    pub fn depth(&self) -> &DepthBuffer {
        &self.depth
    }

    fn paint_on(&mut self, drawing: &Drawing, pixmap: &mut Pixmap) {
        let (width, height) = (drawing.width as usize, drawing.height as usize);
        let per_pixel = match drawing.antialias {
            0..=1 => 1,
            2..=4 => 4,
            _ => 16,
        };
        self.samples.per_pixel = per_pixel;
        self.samples.colors.clear();
        self.samples.colors.resize(width * height * per_pixel, fill::premultiply(drawing.background));
        self.samples.depths.clear();
        self.samples.depths.resize(width * height * per_pixel, f32::NEG_INFINITY);
        self.depth.reset(width, height, setup::samples(per_pixel)[0]);
        fill::surfaces(drawing, &mut self.samples, &mut self.depth);
        for (pixel, samples) in pixmap.data_mut().chunks_exact_mut(4).zip(self.samples.colors.chunks_exact(per_pixel)) {
            let n = samples.len();
            for (k, byte) in pixel.iter_mut().enumerate() {
                let sum: usize = samples.iter().map(|s| usize::from(s[k])).sum();
                #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes")]
                let mean = ((sum + n / 2) / n) as u8;
                *byte = mean;
            }
        }
        self.strokes.coverage.resize(width, height);
        for set in &drawing.strokes {
            self.strokes.draw(pixmap, &self.depth, set);
        }
        for mark in &drawing.marks {
            label::mark(pixmap, &self.depth, mark);
        }
        for text in &drawing.labels {
            label::label(pixmap, &self.depth, text);
        }
    }
}

fn new_pixmap(drawing: &Drawing) -> Option<Pixmap> {
    let (width, height) = (drawing.width, drawing.height);
    let fits = width.max(height) <= MAX_SIDE && u64::from(width) * u64::from(height) <= MAX_PIXELS;
    if fits { Pixmap::new(width, height) } else { None }
}

fn color(c: Rgba) -> Color {
    Color::from_rgba8(c.r, c.g, c.b, c.a)
}
