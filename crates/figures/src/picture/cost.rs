//! The cost of each pixel of a picture, stage by stage, as the textbook's rasterizer counts it.

use std::sync::Arc;

use super::Pixels;
use super::exact_image::{NoExactImage, exact_image};
use crate::appearance::{FaceOrder, Rgba};
use crate::drawing::Drawing;
use crate::figure::{CostReveal, Reveal, Show};
use crate::pipeline::depths::DepthScale;
use crate::pipeline::operations::{Elements, operations};
use crate::pipeline::{Frame, ShadowMaps};
use crate::progress::Progress;
use crate::raster::Rasterizer;
use crate::raster::textbook::{FaceAtPixel, PixelCost, cost, faces_at};
use crate::scene::Scene;
use crate::stage::{Operations, Stage};
use crate::views::{self, CostMap, Hover, Request, TimedPipeline, View};

/// Number of cached maps: the two sides of a comparison.
const KEPT: usize = 2;

/// The work on the pixels of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Costs {
    /// The work on each pixel, row by row.
    pub pixels: Vec<PixelCost>,
    /// The fills of all samples by the scene, and those of them that were painted over, in each order of faces that the
    /// picture can have. Its own comes first.
    pub fills: Vec<(FaceOrder, [u64; 2])>,
    drawing: Drawing,
    ground: usize,
    depths: DepthScale,
    /// The stages of pixels that ran, each with all its operations. Those on triangles belong to no pixel.
    stages: Vec<(Stage, Operations)>,
    lamps: u64,
    samples: u64,
    in_order: bool,
}

impl Costs {
    /// Counts the work on the pixels of a picture. `None` if it was cancelled. It pauses on the way.
    pub(super) async fn of(frame: Frame, progress: &Progress) -> Option<Self> {
        let Frame { drawing, report, lamps, depths, ground, .. } = frame;
        let pixels = cost(&drawing, ground, progress).await?;
        let mut counted = vec![(drawing.face_order(), fills(&pixels))];
        for &(_, order) in FaceOrder::NAMED.iter().filter(|(_, order)| *order != drawing.face_order()) {
            let other = Drawing { order, ..drawing.clone() };
            if other.face_order() == order {
                counted.push((order, fills(&cost(&other, ground, progress).await?)));
            }
        }
        let in_order = drawing.painted_in_order;
        let triangles = drawing.surfaces.iter().map(|surface| surface.triangles.len() as u64).sum();
        let (lamps, samples) = (lamps as u64, u64::from(drawing.antialias.count()));
        let stages = report.iter().filter(|report| report.ran && report.stage.is_raster()).map(|report| {
            let (entering, leaving) = match report.stage {
                Stage::Fill => (triangles, 0),
                Stage::HiddenSurfaces if in_order => {
                    report.counts.map(|(entering, leaving)| (entering as u64, leaving as u64)).unwrap_or_default()
                }
                _ => (0, 0),
            };
            let elements = Elements { entering, leaving, lamps, lit_pixels: 0, in_order };
            (report.stage, operations(report.stage, elements))
        });
        let stages = stages.collect();
        let mut costs = Self { pixels, fills: counted, drawing, ground, depths, stages, lamps, samples, in_order };
        let sum = |(stage, own): &(Stage, Operations)| {
            let on_pixels = costs.pixels.iter().map(|pixel| costs.at(*stage, pixel));
            (*stage, on_pixels.fold(*own, Operations::and))
        };
        costs.stages = costs.stages.iter().map(sum).collect();
        Some(costs)
    }

    /// The operations of a stage on a pixel.
    pub fn at(&self, stage: Stage, pixel: &PixelCost) -> Operations {
        if !self.stages.iter().any(|(ran, _)| *ran == stage) {
            return Operations::NONE;
        }
        let (entering, leaving) = match stage {
            Stage::Fill => (0, pixel.covered.into()),
            Stage::HiddenSurfaces if self.in_order => (0, 0),
            Stage::HiddenSurfaces => (pixel.covered.into(), pixel.filled.into()),
            Stage::Interpolate => (pixel.interpolated.into(), 0),
            Stage::Texture => (pixel.textured.into(), 0),
            Stage::Shadow => (pixel.shadowed.into(), 0),
            Stage::Blend => (pixel.blended.into(), 0),
            Stage::Antialias => (self.samples, 1),
            Stage::Write => (1, 1),
            _ => (0, 0),
        };
        let lit_pixels = pixel.lit.into();
        operations(stage, Elements { entering, leaving, lamps: self.lamps, lit_pixels, in_order: self.in_order })
    }

    /// The operations of all stages on a pixel.
    pub fn of_pixel(&self, pixel: &PixelCost) -> Operations {
        self.stages.iter().fold(Operations::NONE, |sum, (stage, _)| sum.and(self.at(*stage, pixel)))
    }

    /// The operations of a stage on all pixels, and on triangles.
    pub fn of_stage(&self, stage: Stage) -> Operations {
        self.stages.iter().find(|(ran, _)| *ran == stage).map_or(Operations::NONE, |(_, all)| *all)
    }

    /// The faces at a pixel of the picture, in the order of painting.
    pub fn faces_at(&self, pixel: [u32; 2]) -> Vec<PricedFace> {
        let priced = |face: FaceAtPixel| {
            let distance = |depth: f32| self.depths.distance(f64::from(depth));
            // Averaging and writing are done once for a pixel.
            let is_once = |stage: Stage| matches!(stage, Stage::Antialias | Stage::Write);
            let stages = self.stages.iter().filter(|(stage, _)| !is_once(*stage));
            let Operations { float, integer, memory } =
                stages.fold(Operations::NONE, |sum, (stage, _)| sum.and(self.at(*stage, &face.cost)));
            PricedFace {
                color: self.drawing.surfaces.get(face.face[0]).and_then(|surface| surface.face_color(face.face[1])),
                distance: distance(face.depth),
                behind: face.behind.map(|behind| distance(face.depth) - distance(face.depth + behind)),
                is_partly_drawn: face.cost.filled > 0,
                operations: float + integer + memory,
            }
        };
        let of_scene = |face: &FaceAtPixel| face.face[0] >= self.ground;
        faces_at(&self.drawing, pixel).into_iter().filter(of_scene).map(priced).collect()
    }

    /// The share of fills that were painted over in an order, 0 … 1; `None` if the picture can't have it.
    pub fn painted_over(&self, order: FaceOrder) -> Option<f64> {
        let [fills, over] = self.fills.iter().find(|(of, _)| *of == order)?.1;
        Some(over as f64 / fills.max(1) as f64)
    }
}

/// A face at a pixel, with its price.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PricedFace {
    /// Its own colour, if it has one.
    pub color: Option<Rgba>,
    /// Its distance from the eye along DOP, in scene units.
    pub distance: f64,
    /// The distance by which it lies behind the face that hides it; `None` if none does.
    pub behind: Option<f64>,
    /// True if not all of its samples are hidden.
    pub is_partly_drawn: bool,
    /// Operations and memory accesses of all stages that work on it there.
    pub operations: u64,
}

fn fills(pixels: &[PixelCost]) -> [u64; 2] {
    let sum = |of: fn(&PixelCost) -> u32| pixels.iter().map(|pixel| u64::from(of(pixel))).sum();
    [sum(|pixel| pixel.filled - pixel.ground), sum(|pixel| pixel.painted_over)]
}

/// The maps of the last pictures.
#[derive(Clone, Debug, Default)]
pub(super) struct FoundCosts {
    kept: Vec<(Request, Arc<CostMap>)>,
}

impl FoundCosts {
    /// The map with which the image of a request is tinted; `None` if it isn't, or was cancelled.
    pub(super) async fn of(
        &mut self,
        request: &Request,
        shadow_maps: &ShadowMaps,
        progress: &Progress,
    ) -> Option<Arc<CostMap>> {
        request.shot.look.reveal.cost.filter(|_| request.view == View::Image)?;
        let (hover, output) = (Hover::default(), crate::pipeline::Output::Pixels);
        let key = Request { hover, output, ..request.clone() };
        if let Some((_, map)) = self.kept.iter().find(|(of, _)| *of == key) {
            return Some(Arc::clone(map));
        }
        let mut pipeline = TimedPipeline::default();
        pipeline.stages.share_shadows(shadow_maps);
        let map = Arc::new(map(&key, &mut pipeline, progress).await?);
        self.kept.truncate(KEPT - 1);
        self.kept.insert(0, (key, Arc::clone(&map)));
        Some(map)
    }
}

async fn map(request: &Request, pipeline: &mut TimedPipeline, progress: &Progress) -> Option<CostMap> {
    let of = request.shot.look.reveal.cost?;
    let size = [request.size.width, request.size.height];
    let plain = request.clone().with_shot(|shot| shot.look.reveal.cost = None);
    let frame = views::frame(&plain, None, pipeline);
    if of == CostReveal::Error {
        let drawn = Pixels::from(Rasterizer::default().paint(&frame.drawing)?);
        let values = match exact_image(&exact(&plain), progress).await {
            Err(NoExactImage::Cancelled | NoExactImage::Memory) => return None,
            Err(NoExactImage::Pixels | NoExactImage::Triangles) => Vec::new(),
            Ok(exact) => {
                let pixels = drawn.rgba().as_chunks::<4>().0.iter().zip(exact.pixels.rgba().as_chunks::<4>().0);
                pixels.map(|(a, b)| f32::from((0..3).map(|k| a[k].abs_diff(b[k])).max().unwrap_or(0))).collect()
            }
        };
        return Some(CostMap { size, values, painted_over: (0.0, None) });
    }
    let costs = Costs::of(frame, progress).await?;
    let camera = &request.camera;
    let volume = DepthScale::of_volume(camera.projection(), camera.near(), camera.far());
    let [back, front] = [0.0, 1.0].map(|depth| costs.depths.in_scale(&volume, depth));
    #[expect(clippy::cast_possible_truncation, reason = "for a colour")]
    let value = |pixel: &PixelCost| match of {
        CostReveal::Overdraw => f64::from(pixel.filled - pixel.ground) / costs.samples as f64,
        CostReveal::Operations => {
            let Operations { float, integer, memory } = costs.of_pixel(pixel);
            (float + integer + memory) as f64
        }
        CostReveal::Rounding | CostReveal::Error => f64::from(pixel.rounding) * (front - back),
    } as f32;
    let values = costs.pixels.iter().map(value).collect();
    let now = costs.painted_over(costs.drawing.face_order()).unwrap_or(0.0);
    Some(CostMap { size, values, painted_over: (now, costs.painted_over(FaceOrder::FrontToBack)) })
}

/// The request for the exact image beside a picture: without the inner work that it reveals, and its photograph.
fn exact(request: &Request) -> Request {
    let plain = request.clone().with_shot(|shot| {
        shot.look.reveal = Reveal::default();
        shot.show = Show { stage: None, painted: None, triangle: None, ..shot.show.clone() };
    });
    let without = || Scene { photograph: None, ..Scene::clone(&request.scene) };
    let scene =
        if request.scene.photograph.is_some() { request.scene.marked(without()) } else { request.scene.clone() };
    Request { scene, ..plain }
}
