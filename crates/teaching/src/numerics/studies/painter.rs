//! Pictures of the program, pixel by pixel, for the studies of visibility.

use std::sync::Arc;

use glam::{DMat4, DVec3};

use crate::appearance::{Rgba, Samples, Shading, Style, Visibility};
use crate::camera::Camera;
use crate::pipeline::{Options, Pipeline, Target};
use crate::raster::Rasterizer;
use crate::scene::{Mesh, Object, ObjectPaint, Scene};

/// A pipeline and a rasterizer that keep their buffers.
#[derive(Default)]
pub(in crate::numerics) struct Painter {
    pipeline: Pipeline,
    rasterizer: Rasterizer,
}

pub(super) const BLACK: Rgba = Rgba::rgb(0, 0, 0);

impl Painter {
    /// The colours of a picture on black, row by row from the top.
    pub(in crate::numerics) fn paint(
        &mut self,
        scene: &Scene,
        camera: &Camera,
        size: [u32; 2],
        style: &Style,
    ) -> Vec<Rgba> {
        let target = Target { width: size[0], height: size[1], scale: 1.0, background: BLACK };
        let frame = self.pipeline.frame(scene, camera, target, style, Options::default());
        // The sizes are those of the studies, far below the limit.
        let Some(pixmap) = self.rasterizer.paint(&frame.drawing) else { return Vec::new() };
        pixmap.data().as_chunks::<4>().0.iter().map(|p| Rgba::rgb(p[0], p[1], p[2])).collect()
    }
}

/// Faces in their own colours, without light and lines.
pub(super) fn flat(visibility: Visibility, antialias: Samples) -> Style {
    Style { shading: Shading::Flat, visibility, antialias, ..Style::default() }
}

/// A triangle in the world in one colour.
pub(super) fn triangle(corners: [DVec3; 3], color: Rgba) -> Object {
    let mesh =
        Mesh { positions: corners.to_vec(), normals: vec![DVec3::Z; 3], triangles: vec![[0, 1, 2]], ..Mesh::default() };
    Object { lit: false, two_sided: true, ..object(mesh, color) }
}

/// A closed mesh in one colour, lit, without lines.
pub(super) fn object(mesh: Mesh, color: Rgba) -> Object {
    Object::new(String::new(), Arc::new(mesh), DMat4::IDENTITY, ObjectPaint::Solid(color))
}
