//! Which triangles touch which band of rows, in the order in which they are to be drawn.

use rayon::prelude::*;

use crate::drawing::{Drawing, Surface};

use super::fill::{Size, reach};
use super::setup::{Pixels, snap};
use super::shade::pick;

/// Triangles that are sorted into bands as one piece of work.
const CHUNK: usize = 8192;

/// The opaque triangles of a picture by band, and the translucent ones from back to front. In a drawing that is painted in
/// order, all triangles are treated as the opaque ones here. Kept between pictures.
#[derive(Clone, Debug, Default)]
pub(super) struct Bins {
    chunks: Vec<Chunk>,
    used: usize,
    translucent: Vec<Translucent>,
}

/// A stretch of the triangles of one surface.
#[derive(Clone, Debug, Default)]
struct Chunk {
    surface: usize,
    first: u32,
    end: u32,
    /// For each band the numbers of the triangles that touch it.
    bands: Vec<Vec<u32>>,
}

/// A translucent triangle.
#[derive(Clone, Copy, Debug)]
struct Translucent {
    /// Sum of the depths of its vertices: the order of centroids.
    depth: f32,
    surface: usize,
    triangle: u32,
    first_band: usize,
    last_band: usize,
}

impl Bins {
    /// Sorts all triangles of a drawing. `S`: samples per pixel; `height`: rows of a band.
    pub(super) fn sort<const S: usize>(&mut self, drawing: &Drawing, size: Size, height: usize, bands: usize) {
        self.used = 0;
        let listed = |s: &Surface| drawing.painted_in_order || !s.translucent;
        for (surface, s) in drawing.surfaces.iter().enumerate().filter(|(_, s)| listed(s)) {
            for first in (0..s.triangles.len()).step_by(CHUNK) {
                if self.used == self.chunks.len() {
                    self.chunks.push(Chunk::default());
                }
                let chunk = &mut self.chunks[self.used];
                (chunk.surface, chunk.first) = (surface, number(first));
                chunk.end = number(s.triangles.len().min(first + CHUNK));
                self.used += 1;
            }
        }
        let fill = |chunk: &mut Chunk| chunk.fill::<S>(&drawing.surfaces[chunk.surface], size, height, bands);
        let chunks = &mut self.chunks[..self.used];
        if chunks.len() > 1 && rayon::current_num_threads() > 1 {
            chunks.par_iter_mut().for_each(fill);
        } else {
            chunks.iter_mut().for_each(fill);
        }
        self.sort_translucent::<S>(drawing, size, height);
    }

    fn sort_translucent<const S: usize>(&mut self, drawing: &Drawing, size: Size, height: usize) {
        self.translucent.clear();
        let sorted = |s: &Surface| !drawing.painted_in_order && s.translucent;
        for (surface, s) in drawing.surfaces.iter().enumerate().filter(|(_, s)| sorted(s)) {
            for triangle in 0..number(s.triangles.len()) {
                let Some((pixels, depth)) = pixels::<S>(s, triangle, size) else { continue };
                self.translucent.push(Translucent {
                    depth,
                    surface,
                    triangle,
                    first_band: pixels.rows.start.unsigned_abs() as usize / height,
                    last_band: (pixels.rows.end - 1).unsigned_abs() as usize / height,
                });
            }
        }
        // Stable: of equal depths the first in the drawing is drawn first.
        self.translucent.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    }

    /// The opaque triangles that touch a band, in the order of the drawing: surface and numbers.
    pub(super) fn opaque(&self, band: usize) -> impl Iterator<Item = (usize, &[u32])> {
        self.chunks[..self.used]
            .iter()
            .map(move |chunk| (chunk.surface, chunk.bands[band].as_slice()))
            .filter(|(_, triangles)| !triangles.is_empty())
    }

    /// The translucent triangles that touch a band, from back to front: surface and number.
    pub(super) fn translucent(&self, band: usize) -> impl Iterator<Item = (usize, u32)> {
        self.translucent
            .iter()
            .filter(move |t| (t.first_band..=t.last_band).contains(&band))
            .map(|t| (t.surface, t.triangle))
    }
}

impl Chunk {
    fn fill<const S: usize>(&mut self, surface: &Surface, size: Size, height: usize, bands: usize) {
        self.bands.resize_with(bands, Vec::new);
        self.bands.iter_mut().for_each(Vec::clear);
        for triangle in self.first..self.end {
            let Some((pixels, _)) = pixels::<S>(surface, triangle, size) else { continue };
            let first = pixels.rows.start.unsigned_abs() as usize / height;
            let last = (pixels.rows.end - 1).unsigned_abs() as usize / height;
            for band in &mut self.bands[first..=last] {
                band.push(triangle);
            }
        }
    }
}

/// The pixels that a triangle may own and the sum of its depths; `None` where there are none.
#[inline(always)]
fn pixels<const S: usize>(surface: &Surface, triangle: u32, size: Size) -> Option<(Pixels, f32)> {
    let corners = surface.triangles.get(triangle as usize)?.map(|v| v as usize);
    let p = pick(&surface.positions, corners)?;
    let v = [snap(p[0])?, snap(p[1])?, snap(p[2])?];
    let pixels = Pixels::around(&v, reach::<S>(), size.width, size.height);
    (!pixels.is_empty()).then_some((pixels, p[0][2] + p[1][2] + p[2][2]))
}

/// Numbers of triangles are 32 bits wide: their vertices' are, too, and 2³² triangles would fill 48 GB.
#[expect(clippy::cast_possible_truncation, reason = "see above")]
fn number(index: usize) -> u32 {
    index as u32
}
