//! The cost of each pixel, in the order of painting.
//!
//! The counts are those of [`paint`](super::paint): the same triangles go to the same samples. A sample's count belongs
//! to its pixel. Only the set-up of triangles belongs to no pixel.

use rayon::prelude::*;

use super::{Face, Met, cleared, depth, painting_order, samples, scan};
use crate::drawing::{Drawing, Surface, SurfaceLight};
use crate::progress::{Progress, pause};
use crate::raster::grid::in_pixels;
use crate::raster::textbook::triangle::Triangle;

/// Rows that are counted as one piece of work.
const ROWS: u32 = 32;

/// The work on one pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelCost {
    /// Samples inside triangles, once for each triangle.
    pub covered: u32,
    /// Samples that were filled, because nothing nearer had been drawn before.
    pub filled: u32,
    /// Those of them on the ground: surfaces that lie under the scene.
    pub ground: u32,
    /// Fills that an opaque face painted over later, besides those on the ground.
    pub painted_over: u32,
    /// Colours of which something is interpolated.
    pub interpolated: u32,
    /// Colours with the light of this pixel.
    pub lit: u32,
    /// Texels looked up.
    pub textured: u32,
    /// Shadow maps looked up.
    pub shadowed: u32,
    /// Colours blended.
    pub blended: u32,
    /// The greatest distance between the stored depths of its samples and the exact depths of the faces there. The
    /// vertices of a face lie on the grid of the rasterizer, and a format rounds depths. 0 without opaque faces.
    pub rounding: f32,
}

impl PixelCost {
    /// Counts a colour of a surface.
    fn color(&mut self, surface: &Surface) {
        self.interpolated += u32::from(surface.varies());
        self.lit += u32::from(matches!(surface.light, SurfaceLight::PerPixel(_)));
        self.textured += u32::from(surface.is_textured());
        self.shadowed += u32::try_from(surface.shadows.len()).unwrap_or(u32::MAX);
        self.blended += u32::from(surface.translucent);
    }
}

/// Counts the work on each pixel, row by row. The first `ground` surfaces are the ground. `None` if it was cancelled.
/// It pauses on the way. Shadow maps are pictures of their own, and not in the counts.
pub async fn cost(drawing: &Drawing, ground: usize, progress: &Progress) -> Option<Vec<PixelCost>> {
    let order = painting_order(drawing);
    let ground = drawing.surfaces.iter().take(ground).map(|surface| surface.triangles.len()).sum();
    let starts: Vec<u32> = (0..drawing.height).step_by(ROWS as usize).collect();
    let mut all = Vec::with_capacity(drawing.width as usize * drawing.height as usize);
    for starts in starts.chunks(rayon::current_num_threads().max(1)) {
        let parts: Vec<_> = starts.par_iter().map(|&first| of_rows(drawing, &order, ground, first)).collect();
        all.extend(parts.into_iter().flatten());
        if progress.is_cancelled() {
            return None;
        }
        pause().await;
    }
    Some(all)
}

fn of_rows(drawing: &Drawing, order: &[Face], ground: usize, first: u32) -> Vec<PixelCost> {
    let rows = first..drawing.height.min(first + ROWS);
    let places = samples(drawing.antialias);
    let mut all = cleared(drawing, rows.end - rows.start);
    // Of each sample: the fills that nothing has painted over, and the rounding of its depth.
    let mut fills = vec![(0, 0.0_f32); all.len()];
    let mut costs = vec![PixelCost::default(); all.len() / places.len()];
    for &face in order {
        scan(drawing, face, rows.clone(), &mut all, |triangle, met, pixel| {
            let cost = &mut costs[met.pixel];
            let number = |list: &[usize]| u32::try_from(list.len()).unwrap_or(u32::MAX);
            cost.covered += number(met.covered);
            cost.filled += number(met.visible);
            cost.ground += if face.place < ground { number(met.visible) } else { 0 };
            if !met.visible.is_empty() {
                cost.color(face.surface);
            }
            for &s in met.visible {
                let (fills, rounding) = &mut fills[met.pixel * places.len() + s];
                if !face.surface.translucent {
                    cost.painted_over += std::mem::take(fills);
                    *rounding =
                        if face.surface.depth_test { rounded(triangle, &met, places[s], pixel[s].depth) } else { 0.0 };
                }
                *fills += u32::from(face.place >= ground);
            }
        });
    }
    for (cost, fills) in costs.iter_mut().zip(fills.chunks(places.len())) {
        cost.rounding = fills.iter().map(|(_, rounding)| *rounding).fold(0.0, f32::max);
    }
    costs
}

/// The distance of a stored depth from the plane through the vertices where the drawing has them, in `f64`.
fn rounded(triangle: &Triangle, met: &Met, place: [i32; 2], stored: f32) -> f32 {
    let Some([a, b, c]) = triangle.of(&triangle.surface.positions).map(|points| points.map(|p| p.map(f64::from)))
    else {
        return 0.0;
    };
    let [x, y] = [0, 1].map(|k| f64::from(met.center[k] + in_pixels(place[k])) + triangle.origin()[k] - a[k]);
    let [[ax, ay, az], [bx, by, bz]] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    let area = ax * by - ay * bx;
    let exact = a[2] + ((az * by - bz * ay) * x + (bz * ax - az * bx) * y) / area;
    let exact = exact.clamp(a[2].min(b[2]).min(c[2]), a[2].max(b[2]).max(c[2]));
    #[expect(clippy::cast_possible_truncation, reason = "a small difference")]
    let distance = (f64::from(stored) - exact).abs() as f32;
    distance
}

/// A face at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceAtPixel {
    /// Its surface in the drawing, and its number there.
    pub face: [usize; 2],
    /// Its depth at the first sample that it covers, as the depth buffer would store it.
    pub depth: f32,
    /// The distance by which it lies behind another face at the first sample that is hidden; `None` if none is.
    pub behind: Option<f32>,
    /// The work on it.
    pub cost: PixelCost,
}

/// The faces of a pixel (column, row) in the order of painting. Empty outside of the picture.
pub fn faces_at(drawing: &Drawing, [column, row]: [u32; 2]) -> Vec<FaceAtPixel> {
    let mut faces = Vec::new();
    if column >= drawing.width || row >= drawing.height {
        return faces;
    }
    let places = samples(drawing.antialias);
    let mut all = cleared(drawing, 1);
    let mut first_of_surface: Vec<usize> = vec![0];
    for surface in &drawing.surfaces {
        first_of_surface.push(first_of_surface.last().unwrap_or(&0) + surface.triangles.len());
    }
    for face in painting_order(drawing) {
        scan(drawing, face, row..row + 1, &mut all, |triangle, met, pixel| {
            if met.pixel != column as usize {
                return;
            }
            let plane = triangle.plane(triangle.depths);
            let at = |s: usize| depth(&plane, met.center, places[s], drawing.depth_format);
            let hidden = met.covered.iter().find(|s| !met.visible.contains(s));
            let number = |list: &[usize]| u32::try_from(list.len()).unwrap_or(u32::MAX);
            let mut cost =
                PixelCost { covered: number(met.covered), filled: number(met.visible), ..PixelCost::default() };
            if cost.filled > 0 {
                cost.color(face.surface);
            }
            faces.push(FaceAtPixel {
                face: [first_of_surface.partition_point(|&first| first <= face.place) - 1, face.number],
                depth: met.covered.first().map_or(0.0, |&s| at(s)),
                behind: hidden.map(|&s| pixel[s].depth - at(s)),
                cost,
            });
        });
    }
    faces
}
