//! One triangle on its way: its steps, the pixels that it covers, its depth test at each, and its display in the
//! pictures.

use std::sync::Arc;

use tiny_skia::Pixmap;

use crate::appearance::Rgba;
use crate::camera::Camera;
use crate::figure::ShownTriangle;
use crate::limits::MAX_STEPPED_PIXELS;
use crate::pipeline::Target;
use crate::pipeline::one_triangle::{TriangleSteps, one_triangle};
use crate::progress::pause;
use crate::raster::{DepthBuffer, Rasterizer};
use crate::views::depth::DepthTest;
use crate::views::{Look, Request, SharedScene, TriangleOverlay};

/// A triangle on the pixels of the image, m × n, as the rasterizer fills it.
#[derive(Clone, Debug)]
pub struct TrianglePixels {
    test: DepthTest,
    alone: DepthBuffer,
    before: DepthBuffer,
    /// The rows of pixels that it covers: j (from the top), the first i and the one after the last.
    pub rows: Vec<[u32; 3]>,
}

/// The result of the depth test at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tested {
    /// Z of the triangle, `[0]` Eq. (5.25).
    pub z: f64,
    /// The Z that was there before; `None` means nothing.
    pub before: Option<f64>,
    /// Nearer, and kept.
    pub kept: bool,
}

impl TrianglePixels {
    /// The pixels of a triangle (object of the scene, index in its mesh). `None` if its object isn't drawn, and for
    /// images of more than [`MAX_STEPPED_PIXELS`]. It pauses on its way past all faces of the scene.
    pub async fn of(request: &Request, object: usize, triangle: u32) -> Option<Self> {
        let image = request.shot.look.image;
        if u64::from(image.width) * u64::from(image.height) > MAX_STEPPED_PIXELS {
            return None;
        }
        let test = DepthTest::of(request, object, triangle)?;
        pause().await;
        let (mut rasterizer, mut pixmap) = (Rasterizer::default(), Pixmap::new(1, 1)?);
        let [mut alone, mut before] = [DepthBuffer::default(), DepthBuffer::default()];
        for (drawing, depth) in [(&test.alone, &mut alone), (&test.before, &mut before)] {
            if !rasterizer.paint_into(drawing, &mut pixmap).await {
                return None;
            }
            depth.clone_from(rasterizer.depth());
            pause().await;
        }
        let mut rows: Vec<[u32; 3]> = Vec::new();
        for y in 0..image.height {
            // A triangle is convex, so its pixels in a row are in one piece.
            let covered = |x: &u32| alone.at(*x, y).is_some();
            if let Some(first) = (0..image.width).find(covered) {
                let after = (first..image.width).find(|x| !covered(x)).unwrap_or(image.width);
                rows.push([y, first, after]);
            }
        }
        Some(Self { test, alone, before, rows })
    }

    /// True if it covers a pixel, (0, 0) at the top left.
    pub fn covers(&self, [x, y]: [u32; 2]) -> bool {
        self.rows.iter().any(|[row, first, after]| *row == y && (*first..*after).contains(&x))
    }

    /// Number of pixels that it covers.
    pub fn count(&self) -> usize {
        self.rows.iter().map(|[_, first, after]| (after - first) as usize).sum()
    }

    /// The pixel of the depth test: the one in `asked`, else one in the middle.
    pub fn tested(&self, asked: Option<[u32; 2]>) -> Option<[u32; 2]> {
        let [y, first, after] = *self.rows.get(self.rows.len() / 2)?;
        Some(asked.unwrap_or([u32::midpoint(first, after.saturating_sub(1)), y]))
    }

    /// The depth test at a pixel, (0, 0) at the top left; `None` if the triangle doesn't cover it.
    pub fn test(&self, [x, y]: [u32; 2]) -> Option<Tested> {
        let (own, before) = (self.alone.at(x, y)?, self.before.at(x, y));
        let z = |depth| self.test.z(depth);
        Some(Tested { z: z(own), before: before.map(z), kept: before.is_none_or(|before| own > before) })
    }
}

/// The triangle followed last, cached as long as it, its scene and its camera stay the same.
#[derive(Clone, Debug, Default)]
pub struct FollowedTriangle {
    kept: Option<(TriangleKey, Kept)>,
}

/// The inputs of the numbers of a triangle.
#[derive(Clone, Debug, PartialEq)]
struct TriangleKey {
    camera: Camera,
    scene: SharedScene,
    look: Look,
    object: usize,
    index: u32,
}

#[derive(Clone, Debug)]
struct Kept {
    steps: TriangleSteps,
    /// `None` means not computed yet.
    pixels: Option<Option<Arc<TrianglePixels>>>,
}

impl FollowedTriangle {
    /// The steps of the triangle that a request shows. `None` if it shows none, or there's no such triangle.
    pub fn steps(&mut self, request: &Request) -> Option<TriangleSteps> {
        self.of(request).map(|(kept, _)| kept.steps.clone())
    }

    /// Its steps, and its pixels if a step needs them. `None` as for [`steps`](Self::steps).
    pub async fn found(&mut self, request: &Request) -> Option<(TriangleSteps, Option<Arc<TrianglePixels>>)> {
        let ShownTriangle { index, step, .. } = request.shot.show.triangle.as_ref()?;
        let (kept, place) = self.of(request)?;
        let pixels = match (step.needs_pixels(), &kept.pixels) {
            (false, _) => None,
            (true, Some(pixels)) => pixels.clone(),
            (true, None) => {
                let pixels = TrianglePixels::of(request, place, *index).await.map(Arc::new);
                kept.pixels.insert(pixels).clone()
            }
        };
        Some((kept.steps.clone(), pixels))
    }

    /// The triangle of a request, as far as it's known, and the place of its object in the scene.
    fn of(&mut self, request: &Request) -> Option<(&mut Kept, usize)> {
        let ShownTriangle { object, index, .. } = request.shot.show.triangle.as_ref()?;
        let place = request.scene.place_of(object)?;
        let (camera, scene) = (request.camera.clone(), request.scene.clone());
        let key = TriangleKey { camera, scene, look: request.shot.look, object: place, index: *index };
        if self.kept.as_ref().is_none_or(|(of, _)| *of != key) {
            let image = request.shot.look.image;
            let background = Rgba::rgb(0, 0, 0);
            let target = Target { width: image.width, height: image.height, scale: 1.0, background };
            let steps = one_triangle(&request.scene.objects[place], *index as usize, &request.camera, target)?;
            self.kept = Some((key, Kept { steps, pixels: None }));
        }
        self.kept.as_mut().map(|(_, kept)| (kept, place))
    }

    /// Its display in the pictures.
    pub async fn overlay(&mut self, request: &Request) -> Option<Arc<TriangleOverlay>> {
        let (steps, pixels) = self.found(request).await?;
        let shown = request.shot.show.triangle.as_ref()?;
        Some(Arc::new(TriangleOverlay {
            step: shown.step,
            corners: steps.corners.map(|corner| corner.world),
            outside: steps.corners.map(|corner| corner.outside.contains(&true)),
            left: steps.left.iter().map(|corner| (corner.name, corner.world)).collect(),
            rows: pixels.as_ref().map(|pixels| pixels.rows.clone()).unwrap_or_default(),
            pixel: pixels.as_ref().and_then(|pixels| pixels.tested(shown.pixel)),
        }))
    }
}
