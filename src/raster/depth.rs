//! The depth of what is seen at each pixel.

/// Depth per sample, greater is nearer; cleared to −∞, "nothing there".
#[derive(Clone, Debug, Default)]
pub struct DepthBuffer {
    width: usize,
    height: usize,
    samples: usize,
    values: Vec<f32>,
}

impl DepthBuffer {
    /// Makes the buffer fit and empties it.
    pub(super) fn reset(&mut self, width: usize, height: usize, samples: usize) {
        (self.width, self.height, self.samples) = (width, height, samples);
        self.values.clear();
        self.values.resize(width * height * samples, f32::NEG_INFINITY);
    }

    pub(super) fn sample(&mut self, x: usize, y: usize, sample: usize) -> &mut f32 {
        &mut self.values[(y * self.width + x) * self.samples + sample]
    }

    /// Depth of the surface at a pixel (at its first sample): 1 at the near plane, 0 at the far plane. `None` where no surface
    /// was drawn, or outside.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Option<f32> {
        let (x, y) = (x as usize, y as usize);
        if x >= self.width || y >= self.height {
            return None;
        }
        Some(self.values[(y * self.width + x) * self.samples]).filter(|z| z.is_finite())
    }
}
