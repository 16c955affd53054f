//! [`Drawing`] → pixels.

use tiny_skia::Pixmap;

use crate::drawing::Drawing;

/// Draws pictures; keeps its buffers from one to the next.
#[derive(Debug, Default)]
pub struct Rasterizer {}

impl Rasterizer {
    /// Paints `drawing` on a fresh pixmap. `None` where a side is 0 or too large for memory.
    pub fn paint(&mut self, drawing: &Drawing) -> Option<Pixmap> {
        let mut pixmap = Pixmap::new(drawing.width, drawing.height)?;
        let b = drawing.background;
        pixmap.fill(tiny_skia::Color::from_rgba8(b.r, b.g, b.b, b.a));
        Some(pixmap)
    }
}
