//! Counts pixels. The pipeline draws, the rasterizer paints, and every pixel that isn't background counts.

use std::sync::Arc;

use crate::appearance::{DepthFormat, Rgba, Samples, Shading, Style, Visibility};
use crate::camera::{Camera, ImageSize, Projection};
use crate::pipeline::{ObjectReport, Options, OverBudget, Pipeline, Scenes, Target};
use crate::raster::Rasterizer;
use crate::scene::{Object, ObjectPaint, Scene};

/// Draws images in order to count their pixels. Keeps its buffers.
#[derive(Debug, Default)]
pub struct Counter {
    pipeline: Pipeline,
    rasterizer: Rasterizer,
}

/// The result of drawing a scene.
pub(super) struct Drawn {
    /// Pixels covered by anything but a text.
    pub(super) pixels: u64,
    /// The report of each object of the scene.
    pub(super) objects: Vec<ObjectReport>,
    /// See [`Frame::placed_within`](crate::pipeline::Frame::placed_within).
    pub(super) placed_within: f64,
}

impl Counter {
    /// Draws the image with one sample for each pixel. `None` if it's too large.
    pub(super) fn draw(&mut self, scene: &Scene, camera: &Camera, style: &Style, image: ImageSize) -> Option<Drawn> {
        let mut pixels = 0;
        // The order of faces doesn't change the set of covered pixels.
        // Rounded vertices are a fault of their own.
        let style = Style { visibility: Visibility::DepthBuffer, ..style.with_exact_vertices() };
        // Nor does the light, whose shadow maps would take most of the memory.
        let dark = Scenes::from(scene).without_lights();
        let painted = self.paint(dark, camera, &style, image, |pixel| pixels += u64::from(pixel[3] > 0))?;
        Some(Drawn { pixels, objects: painted.objects, placed_within: painted.placed_within })
    }

    /// For each of these objects, the number of pixels that show a face turned away from the eye.
    pub(super) fn back_faces(&mut self, scene: &Scene, of: &[usize], camera: &Camera, image: ImageSize) -> Vec<u64> {
        self.faces(scene, of, camera, image, |object, triangle| turns_back(object, triangle, camera))
    }

    /// For each of these objects, by their places in the scene, the number of pixels that show one of its faces; 0 if
    /// the image is too large to draw.
    pub fn seen(&mut self, scene: &Scene, of: &[usize], camera: &Camera, image: ImageSize) -> Vec<u64> {
        self.faces(scene, of, camera, image, |_, _| true)
    }

    /// For each of these objects, the number of pixels that show one of its faces that counts.
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
            marked.objects.push(numbered(object, |triangle| if counts_as(object, triangle) { mark } else { 0 }));
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

    /// Paints a scene with one sample for each pixel, and passes each pixel to `each`, row by row. `None` if the image
    /// is too large.
    pub(super) fn paint<'a>(
        &mut self,
        scene: impl Into<Scenes<'a>>,
        camera: &Camera,
        style: &Style,
        image: ImageSize,
        mut each: impl FnMut([u8; 4]),
    ) -> Option<Painted> {
        let clear = Rgba::rgba(0, 0, 0, 0);
        let target = Target { width: image.width, height: image.height, scale: 1.0, background: clear };
        let style = Style { antialias: Samples::One, ..*style };
        // As in the image: whole numbers of a format are shares of the range from F to B.
        let depth_of_volume = style.depth_format != DepthFormat::Float;
        let options = Options { depth_of_volume, ..Options::default() };
        let mut frame = self.pipeline.frame(scene, camera, target, &style, options);
        frame.drawing.depth_format = style.depth_format;
        // The name of a hidden thing isn't the thing.
        frame.drawing.labels.clear();
        let pixmap = self.rasterizer.paint(&frame.drawing)?;
        pixmap.data().chunks_exact(4).for_each(|pixel| each([pixel[0], pixel[1], pixel[2], pixel[3]]));
        let (over_budget, placed_within) = (frame.over_budget, frame.placed_within);
        Some(Painted { objects: frame.objects, over_budget, placed_within })
    }
}

/// The report of the pipeline on a painted scene.
pub(super) struct Painted {
    objects: Vec<ObjectReport>,
    /// The faces that were too many to sort.
    pub(super) over_budget: Option<OverBudget>,
    placed_within: f64,
}

/// An object whose faces have numbers, 0 … 2²⁴ − 1, as colours, and no strokes.
pub(super) fn numbered(object: &Object, number: impl Fn(usize) -> u32) -> Object {
    let color = |triangle| {
        let [_, r, g, b] = number(triangle).to_be_bytes();
        Rgba::rgb(r, g, b)
    };
    let colors = (0..object.mesh.triangles.len()).map(color).collect();
    let paint = ObjectPaint::Faces(Arc::new(colors));
    Object { paint, lit: false, edges: None, outline: None, ..object.clone() }
}

/// True if the eye is behind the plane of a triangle.
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
