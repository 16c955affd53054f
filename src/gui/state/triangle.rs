//! The triangle that is followed step by step.

use std::sync::Arc;

use crate::camera::{Camera, ImageSize, Viewport};
use crate::picture::TrianglePixels;
use crate::pipeline::Target;
use crate::pipeline::one_triangle::{TriangleSteps, one_triangle};
use crate::views::{Request, SharedScene, Stepped, TriangleStep};

/// The triangle that is followed step by step.
#[derive(Clone, Debug, Default)]
pub struct OneTriangle {
    /// Its object, by name, and its index in the mesh.
    pub chosen: Option<(String, u32)>,
    /// The step that lights up.
    pub step: TriangleStep,
    /// The pixel of which the depth is tested, (0, 0) at the top left; one in its middle where it does not cover this one.
    pub pixel: Option<[u32; 2]>,
    /// What the pictures show; written by the tab in each frame.
    pub shown: Option<Arc<Stepped>>,
    /// What was found last, and of what.
    found: Option<(Key, Found)>,
}

/// What the numbers of a triangle depend on.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    camera: Camera,
    scene: SharedScene,
    image: ImageSize,
    viewport: Viewport,
    object: usize,
    triangle: u32,
}

/// A triangle on its way.
#[derive(Clone, Debug)]
pub(in crate::gui) struct Found {
    pub(in crate::gui) steps: TriangleSteps,
    /// `None`: nobody has asked yet.
    pixels: Option<Option<Arc<TrianglePixels>>>,
}

impl OneTriangle {
    /// Follows a triangle from now on.
    pub(in crate::gui) fn choose(&mut self, object: &str, triangle: u32) {
        self.chosen = Some((object.to_owned(), triangle));
        self.pixel = None;
    }

    /// The steps of the triangle that is chosen, and from the step on that needs them its pixels; found anew only where what they depend
    /// on has changed. `None` where there is no such triangle.
    pub(in crate::gui) fn found(&mut self, request: &Request) -> Option<(TriangleSteps, Option<Arc<TrianglePixels>>)> {
        let (name, triangle) = self.chosen.clone()?;
        let index = request.scene.objects.iter().position(|object| object.name == name)?;
        let (image, viewport) = (request.look.image, request.look.viewport);
        let (camera, scene) = (request.camera.clone(), request.scene.clone());
        let key = Key { camera, scene, image, viewport, object: index, triangle };
        if self.found.as_ref().is_none_or(|(of, _)| *of != key) {
            let size = Target {
                width: image.width,
                height: image.height,
                scale: 1.0,
                background: crate::appearance::Rgba::rgb(0, 0, 0),
            };
            let steps = one_triangle(&request.scene.objects[index], triangle as usize, &request.camera, size)?;
            self.found = Some((key, Found { steps, pixels: None }));
        }
        let wants_pixels = matches!(self.step, TriangleStep::Pixels | TriangleStep::Depth);
        let (_, found) = self.found.as_mut()?;
        if wants_pixels && found.pixels.is_none() {
            found.pixels = Some(TrianglePixels::of(request, index, triangle).map(Arc::new));
        }
        Some((found.steps.clone(), found.pixels.clone().flatten().filter(|_| wants_pixels)))
    }
}
