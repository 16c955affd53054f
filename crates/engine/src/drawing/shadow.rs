//! Shadows on surfaces: the depths that a light sees, and the part of the light that is missing where it sees
//! something nearer.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::Drawing;
use crate::appearance::LightShare;

/// The shadows of one light on a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Shadow {
    /// The view of the light.
    pub map: Arc<ShadowMap>,
    /// See [`Shadows::bias`](crate::scene::Shadows::bias).
    pub bias: f32,
    /// The place of each vertex for the light, in the space of [`Rays`]. Affine over each triangle.
    pub places: Vec<[f32; 3]>,
    /// The plane of each triangle for the light, as [`Rays`] has it.
    pub planes: Vec<[f32; 3]>,
    /// The light that is missing in the shadow.
    pub taken: BlockedLight,
}

/// The light of one lamp, which a shadow takes away.
#[derive(Clone, Debug, PartialEq)]
pub enum BlockedLight {
    /// From each triangle, of its light by [`SurfaceLight::Faces`](super::SurfaceLight::Faces).
    Faces(Vec<LightShare>),
    /// From each vertex, of its light by [`SurfaceLight::Vertices`](super::SurfaceLight::Vertices).
    Vertices(Vec<LightShare>),
    /// From each pixel: all of this one of [`Lighting::lights`](super::Lighting::lights).
    Light(usize),
}

/// The view of a light: the depths of all occluders, which a rasterizer makes. Pictures of one scene share it.
#[derive(Debug)]
pub struct ShadowMap {
    /// Side of each view, texels.
    pub size: u32,
    /// The way of its rays.
    pub rays: Rays,
    /// Width of the soft edge, texels.
    pub softness: f32,
    /// The drawings that are still to be painted, each of the whole scene. `None` once they are.
    views: Mutex<Option<Arc<Vec<Drawing>>>>,
    /// The depths, row by row; −∞ where the light sees nothing.
    depths: OnceLock<Vec<Vec<f32>>>,
}

/// The way of the rays of a light, and with it the space of places and planes.
#[derive(Clone, Debug, PartialEq)]
pub enum Rays {
    /// A place is x and y in texels, and the depth of the drawing. A plane the change of the depth from texel to texel,
    /// to the right and down, and 0.
    Parallel {
        /// The difference in depth that is as long as a texel.
        step: f32,
    },
    /// A place is the vector from the lamp, in units of the farthest distance. A plane the vector **q** with
    /// **q** · p = 1 at each of its points.
    FromLamp {
        /// The unit vectors of each view to the right, up, and forwards.
        axes: Box<[[[f32; 3]; 3]; 6]>,
        /// Half of the width of a view at the distance 1: a little more than 1, so that views overlap.
        reach: f32,
        /// The depth is this times 1/distance − 1.
        unit: f32,
    },
}

impl ShadowMap {
    /// A map that is still to be painted. `views` has one drawing for parallel light, six around a lamp. They are
    /// square, without light, with one sample in each pixel. A pixel is a texel.
    pub fn new(views: Vec<Drawing>, size: u32, rays: Rays, softness: f32) -> Self {
        Self { size, rays, softness, views: Mutex::new(Some(Arc::new(views))), depths: OnceLock::new() }
    }

    /// The depths of each view, row by row. `None` until they are painted. An empty view has no depths.
    pub fn depths(&self) -> Option<&[Vec<f32>]> {
        self.depths.get().map(Vec::as_slice)
    }

    /// The views that are still to be painted; `None` once they are.
    pub fn unpainted(&self) -> Option<Arc<Vec<Drawing>>> {
        self.views.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Keeps the depths that were painted, and drops the views. The first depths stay.
    pub fn keep(&self, depths: Vec<Vec<f32>>) {
        // Two pictures may have painted it at the same time, with the same result.
        let _ = self.depths.set(depths);
        self.views.lock().unwrap_or_else(PoisonError::into_inner).take();
    }
}

/// Compares the views if neither map is painted, and the depths if both are. Of a painted map the views are gone, so
/// nothing tells it from one that is still to be painted, as long as size and rays agree. Only tests compare drawings.
impl PartialEq for ShadowMap {
    fn eq(&self, other: &Self) -> bool {
        let is_same = match (self.depths(), other.depths()) {
            (None, None) => self.unpainted() == other.unpainted(),
            (Some(own), Some(others)) => own == others,
            (None, Some(_)) | (Some(_), None) => true,
        };
        is_same && (self.size, self.softness, &self.rays) == (other.size, other.softness, &other.rays)
    }
}

impl Shadow {
    /// The same shadow on a surface that has no vertices and no triangles yet.
    #[must_use]
    pub fn bare(&self) -> Self {
        let taken = match &self.taken {
            BlockedLight::Faces(_) => BlockedLight::Faces(Vec::new()),
            BlockedLight::Vertices(_) => BlockedLight::Vertices(Vec::new()),
            BlockedLight::Light(light) => BlockedLight::Light(*light),
        };
        Self { map: Arc::clone(&self.map), bias: self.bias, places: Vec::new(), planes: Vec::new(), taken }
    }

    /// Keeps only the data of the first triangles.
    pub(super) fn truncate(&mut self, count: usize) {
        self.planes.truncate(count);
        if let BlockedLight::Faces(shares) = &mut self.taken {
            shares.truncate(count);
        }
    }
}
