//! The pixels that one triangle covers, and its depth test at each.

use crate::limits::MAX_STEPPED_PIXELS;
use crate::raster::{DepthBuffer, Rasterizer};
use crate::views::Request;
use crate::views::depth::DepthTest;

/// A triangle on the pixels of the image, m × n, as the rasterizer fills it.
#[derive(Clone, Debug)]
pub struct TrianglePixels {
    test: DepthTest,
    alone: DepthBuffer,
    before: DepthBuffer,
    /// Rows of pixels that it covers: j (from the top), the first i and the one after the last.
    pub rows: Vec<[u32; 3]>,
}

/// What the depth test says at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tested {
    /// Z of the triangle, `[0]` Eq. (5.25).
    pub z: f64,
    /// Z that was there; `None`: nothing.
    pub before: Option<f64>,
    /// It is nearer, and kept.
    pub kept: bool,
}

impl TrianglePixels {
    /// Of a triangle (object of the scene, index in its mesh). `None` where its object is not drawn, and for images of more than
    /// [`MAX_STEPPED_PIXELS`].
    #[must_use]
    pub fn of(request: &Request, object: usize, triangle: u32) -> Option<Self> {
        let image = request.look.image;
        if u64::from(image.width) * u64::from(image.height) > MAX_STEPPED_PIXELS {
            return None;
        }
        let test = DepthTest::of(request, object, triangle)?;
        let mut rasterizer = Rasterizer::default();
        rasterizer.paint(&test.alone)?;
        let alone = rasterizer.depth().clone();
        rasterizer.paint(&test.before)?;
        let before = rasterizer.depth().clone();
        let mut rows: Vec<[u32; 3]> = Vec::new();
        for y in 0..image.height {
            // A triangle is convex: what it covers of a row is in one piece.
            let covered = |x: &u32| alone.at(*x, y).is_some();
            if let Some(first) = (0..image.width).find(covered) {
                let after = (first..image.width).find(|x| !covered(x)).unwrap_or(image.width);
                rows.push([y, first, after]);
            }
        }
        Some(Self { test, alone, before, rows })
    }

    /// How many pixels it covers.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows.iter().map(|[_, first, after]| (after - first) as usize).sum()
    }

    /// The depth test at a pixel, (0, 0) at the top left; `None` where it does not cover it.
    #[must_use]
    pub fn test(&self, [x, y]: [u32; 2]) -> Option<Tested> {
        let (own, before) = (self.alone.at(x, y)?, self.before.at(x, y));
        let z = |depth| self.test.z(depth);
        Some(Tested { z: z(own), before: before.map(z), kept: before.is_none_or(|before| own > before) })
    }
}
