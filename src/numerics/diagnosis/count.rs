//! Counts pixels: the pipeline draws, the rasterizer paints, and whatever is not ground counts.

use std::sync::Arc;

use crate::appearance::{Rgba, Shading, Style, Visibility};
use crate::camera::{Camera, ImageSize, Projection};
use crate::pipeline::{ByObject, ObjectReport, Options, Pipeline, Target};
use crate::raster::Rasterizer;
use crate::scene::{Object, ObjectPaint, Scene};

/// Draws images in order to count their pixels; keeps its buffers.
#[derive(Debug, Default)]
pub struct Counter {
    pipeline: Pipeline,
    rasterizer: Rasterizer,
}

/// The result of drawing a scene.
pub(super) struct Drawn {
    /// Pixels that anything but a text covers.
    pub(super) pixels: u64,
    /// The report of each object of the scene.
    pub(super) objects: ByObject<ObjectReport>,
}

impl Counter {
    /// Draws the image with one sample for each pixel. `None` where it is too large.
    pub(super) fn draw(&mut self, scene: &Scene, camera: &Camera, style: &Style, image: ImageSize) -> Option<Drawn> {
        let mut pixels = 0;
        let objects = self.paint(scene, camera, style, image, |pixel| pixels += u64::from(pixel[3] > 0))?;
        Some(Drawn { pixels, objects })
    }

    /// Of each of these objects, the pixels on which a face is seen that turns its back to the eye.
    pub(super) fn back_faces(&mut self, scene: &Scene, of: &[usize], camera: &Camera, image: ImageSize) -> Vec<u64> {
        self.faces(scene, of, camera, image, |object, triangle| turns_back(object, triangle, camera))
    }

    /// Of each of these objects, by their places in the scene, the pixels on which one of its faces is seen; 0 where
    /// the image is too large to be drawn.
    #[must_use]
    pub fn seen(&mut self, scene: &Scene, of: &[usize], camera: &Camera, image: ImageSize) -> Vec<u64> {
        self.faces(scene, of, camera, image, |_, _| true)
    }

    /// Of each of these objects, the pixels on which a face of it is seen that counts.
    fn faces(
        &mut self,
        scene: &Scene,
        of: &[usize],
        camera: &Camera,
        image: ImageSize,
        counts_as: impl Fn(&Object, usize) -> bool,
    ) -> Vec<u64> {
        let mut marked = Scene::default();
        for (i, object) in scene.objects.iter().enumerate().filter(|(_, object)| object.faces) {
            let mark = of.iter().position(|&j| j == i).and_then(|k| u32::try_from(k + 1).ok()).unwrap_or(0);
            let [_, r, g, b] = mark.to_be_bytes();
            let color = |counts: bool| if counts { Rgba::rgb(r, g, b) } else { Rgba::rgb(0, 0, 0) };
            let colors = (0..object.mesh.triangles.len()).map(|t| color(counts_as(object, t)));
            marked.objects.push(Object {
                paint: ObjectPaint::Faces(Arc::new(colors.collect())),
                lit: false,
                edges: None,
                outline: None,
                ..object.clone()
            });
        }
        let mut counts = vec![0; of.len()];
        let style = Style { shading: Shading::Flat, ..Style::default() };
        self.paint(&marked, camera, &style, image, |[r, g, b, _]| {
            let mark = u32::from_be_bytes([0, r, g, b]) as usize;
            if let Some(count) = mark.checked_sub(1).and_then(|k| counts.get_mut(k)) {
                *count += 1;
            }
        });
        counts
    }

    fn paint(
        &mut self,
        scene: &Scene,
        camera: &Camera,
        style: &Style,
        image: ImageSize,
        mut each: impl FnMut([u8; 4]),
    ) -> Option<ByObject<ObjectReport>> {
        let clear = Rgba::rgba(0, 0, 0, 0);
        let target = Target { width: image.width, height: image.height, scale: 1.0, background: clear };
        // The order of faces does not change which pixels are covered.
        let style = Style { antialias: 1, visibility: Visibility::DepthBuffer, ..*style };
        let mut frame = self.pipeline.frame(scene, camera, target, &style, Options::default());
        // The name of a thing that is not seen is not the thing.
        frame.drawing.labels.clear();
        let pixmap = self.rasterizer.paint(&frame.drawing)?;
        self.pipeline.recycle(frame.drawing);
        pixmap.data().chunks_exact(4).for_each(|pixel| each([pixel[0], pixel[1], pixel[2], pixel[3]]));
        Some(frame.objects)
    }
}

/// True where the eye is behind the plane of a triangle.
fn turns_back(object: &Object, triangle: usize, camera: &Camera) -> bool {
    let corners = object.mesh.triangles[triangle].map(|i| object.mesh.positions.get(i as usize).copied());
    let [Some(a), Some(b), Some(c)] = corners else { return false };
    let [a, b, c] = [a, b, c].map(|p| object.world_from_object.transform_point3(p));
    let mirrored = object.world_from_object.determinant() < 0.0;
    let normal = (b - a).cross(c - a) * if mirrored { -1.0 } else { 1.0 };
    match camera.projection() {
        Projection::Perspective => normal.dot(camera.position() - a) < 0.0,
        Projection::Parallel => normal.dot(camera.basis().n) < 0.0,
    }
}
