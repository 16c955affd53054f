//! All surfaces of a picture: bands of rows, each painted on its own, by as many threads as there are.

use std::sync::Mutex;

use tiny_skia::Pixmap;

use crate::drawing::Drawing;

use super::bins::Bins;
use super::depth::{BandDepth, DepthBuffer};
use super::fill::{Band, Size, fill};
use super::pixel::{Pixel, mean, premultiply};
use super::setup::samples;
use super::shade::LANES;

/// The samples of a band should stay in a processor's own cache: this many, each with colour and depth (8 bytes).
const BAND_SAMPLES: usize = 1 << 16;
/// Rows of the highest and of the lowest band.
const BAND_ROWS: (usize, usize) = (64, 8);

/// Paints surfaces; keeps its buffers from one picture to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct Surfaces {
    bins: Bins,
    /// One for each thread.
    scratch: Vec<Scratch>,
}

/// The samples of the band at hand.
#[derive(Clone, Debug, Default)]
struct Scratch {
    colors: Vec<Pixel>,
    depths: Vec<f32>,
    slopes: Vec<u32>,
}

/// A band on its way to the picture.
struct Job<'a> {
    band: usize,
    pixels: &'a mut [[u8; 4]],
    depth: BandDepth<'a>,
}

/// What is the same for all bands.
struct Frame<'a> {
    drawing: &'a Drawing,
    bins: &'a Bins,
    size: Size,
    rows: usize,
    background: Pixel,
    depth_test: bool,
    want_slopes: bool,
}

impl Surfaces {
    /// Paints background and surfaces over all of `pixmap`, with `S` samples per pixel, and remembers their depth.
    pub(super) fn paint<const S: usize>(&mut self, drawing: &Drawing, pixmap: &mut Pixmap, depth: &mut DepthBuffer) {
        let (width, height) = (drawing.width as usize, drawing.height as usize);
        let size = Size { width: drawing.width as i32, height: drawing.height as i32 };
        let rows = (BAND_SAMPLES / S / (width + LANES)).clamp(BAND_ROWS.1, BAND_ROWS.0);
        let bands = height.div_ceil(rows);
        self.bins.sort::<S>(drawing, size, rows, bands);
        let depth_test = drawing.surfaces.iter().any(|s| s.depth_test && !s.translucent);
        // Only strokes, marks and labels ask for slopes.
        let want_slopes =
            depth_test && !(drawing.strokes.is_empty() && drawing.marks.is_empty() && drawing.labels.is_empty());
        depth.reset(width, height, samples::<S>()[0], rows, want_slopes);
        let frame = Frame {
            drawing,
            bins: &self.bins,
            size,
            rows,
            background: premultiply(drawing.background),
            depth_test,
            want_slopes,
        };
        let pixels = pixmap.data_mut().as_chunks_mut::<4>().0;
        let jobs = pixels.chunks_mut(rows * width).zip(depth.bands()).enumerate().map(|(band, (pixels, depth))| Job {
            band,
            pixels,
            depth,
        });
        let threads = rayon::current_num_threads().min(bands);
        self.scratch.resize_with(threads.max(self.scratch.len()), Scratch::default);
        if threads > 1 {
            let queue = Mutex::new(jobs);
            rayon::scope(|scope| {
                for scratch in &mut self.scratch[..threads] {
                    let (queue, frame) = (&queue, &frame);
                    scope.spawn(move |_| {
                        while let Some(job) = queue.lock().ok().and_then(|mut jobs| jobs.next()) {
                            scratch.paint::<S>(frame, job);
                        }
                    });
                }
            });
        } else if let Some(scratch) = self.scratch.first_mut() {
            for job in jobs {
                scratch.paint::<S>(&frame, job);
            }
        }
    }
}

impl Scratch {
    fn paint<const S: usize>(&mut self, frame: &Frame, mut job: Job) {
        let Frame { drawing, bins, size, .. } = *frame;
        let width = size.width.unsigned_abs() as usize;
        let rows = job.pixels.len() / width;
        if bins.opaque(job.band).next().is_none() && bins.translucent(job.band).next().is_none() {
            job.pixels.fill(frame.background.to_le_bytes());
            return;
        }
        let pitch = width.next_multiple_of(LANES) + LANES;
        let plane = rows * pitch;
        self.colors.clear();
        self.colors.resize(S * plane, frame.background);
        if frame.depth_test {
            self.depths.clear();
            self.depths.resize(S * plane, f32::NEG_INFINITY);
        }
        if frame.want_slopes {
            self.slopes.resize(plane, 0);
        }
        #[expect(clippy::cast_possible_truncation, reason = "rows are at most 16384")]
        let (first, count) = ((job.band * frame.rows) as i32, rows as i32);
        let mut band = Band {
            size,
            rows: first..first + count,
            pitch,
            plane,
            colors: &mut self.colors,
            depths: if frame.depth_test { &mut self.depths } else { &mut [] },
            slopes: frame.want_slopes.then_some(&mut self.slopes),
            in_order: drawing.painted_in_order,
        };
        for (surface, triangles) in bins.opaque(job.band) {
            fill::<S>(&mut band, &drawing.surfaces[surface], triangles.iter().copied());
        }
        for (surface, triangle) in bins.translucent(job.band) {
            fill::<S>(&mut band, &drawing.surfaces[surface], std::iter::once(triangle));
        }
        for (row, pixels) in job.pixels.chunks_exact_mut(width).enumerate() {
            let start = row * pitch;
            let samples: [&[Pixel]; S] =
                std::array::from_fn(|s| &self.colors[s * plane + start..s * plane + start + width]);
            for (i, pixel) in pixels.iter_mut().enumerate() {
                *pixel = mean::<S>(std::array::from_fn(|s| samples[s][i])).to_le_bytes();
            }
        }
        if frame.depth_test {
            job.depth.keep(pitch, &self.depths[..plane], frame.want_slopes.then_some(&self.slopes));
        }
    }
}
