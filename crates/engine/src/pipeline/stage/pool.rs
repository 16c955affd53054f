//! Reuse of the memory of returned drawings: fresh memory costs more than writing to it.

use std::ops::Range;

use glam::DVec3;

use crate::appearance::{LightShare, Rgba};
use crate::drawing::{Base, BlockedLight, Drawing, SurfaceLight};

use super::faces::Faces;
use super::vertices::OnImage;

/// Points, and polylines.
type StrokeArrays = (Vec<[f32; 3]>, Vec<Range<u32>>);

/// Arrays for strokes.
#[derive(Debug, Default)]
pub(crate) struct StrokePool {
    /// Points and polylines of sets, the first set on top. Contents unspecified, overwrite before use.
    pub(crate) sets: Vec<StrokeArrays>,
    /// The vertices of an object on the image, for its edges.
    pub(crate) ends: OnImage,
}

/// Arrays of the last drawing that was given back, the first one on top.
#[derive(Debug, Default)]
pub(crate) struct Pool {
    /// Positions or normals.
    pub(crate) vectors: Vec<Vec<[f32; 3]>>,
    inverse_w: Vec<Vec<f32>>,
    triangles: Vec<Vec<[u32; 3]>>,
    colors: Vec<Vec<Rgba>>,
    shares: Vec<Vec<LightShare>>,
    pub(crate) strokes: StrokePool,
    /// Places of vertices for a light, while its shadows are made.
    pub(crate) exact: Vec<DVec3>,
}

impl Pool {
    /// Keeps the arrays of one drawing, and forgets those of others.
    pub(crate) fn keep(&mut self, drawing: Drawing) {
        let (exact, mut strokes) = (std::mem::take(&mut self.exact), std::mem::take(&mut self.strokes));
        strokes.sets.clear();
        strokes.sets.extend(drawing.strokes.into_iter().rev().map(|set| (set.points, set.polylines)));
        *self = Self { exact, strokes, ..Self::default() };
        for surface in drawing.surfaces.into_iter().rev() {
            match surface.base {
                Base::Faces(colors) | Base::Vertices(colors) => self.colors.push(colors),
                Base::Texture { uv, .. } => self.shares.push(uv),
                Base::Solid(_) => {}
            }
            match surface.light {
                SurfaceLight::PerPixel(light) => self.vectors.extend([light.positions, light.normals]),
                SurfaceLight::Faces(shares) | SurfaceLight::Vertices(shares) => self.shares.push(shares),
                SurfaceLight::InBase => {}
            }
            for shadow in surface.shadows.into_iter().rev() {
                self.vectors.extend([shadow.planes, shadow.places]);
                match shadow.taken {
                    BlockedLight::Faces(shares) | BlockedLight::Vertices(shares) => self.shares.push(shares),
                    BlockedLight::Light(_) => {}
                }
            }
            self.vectors.push(surface.positions);
            self.inverse_w.push(surface.inverse_w);
            self.triangles.push(surface.triangles);
        }
    }

    /// Gives `faces` the arrays that a surface has taken away.
    pub(crate) fn refill(&mut self, faces: &mut Faces) {
        refill(&mut faces.image.positions, &mut self.vectors);
        refill(&mut faces.image.inverse_w, &mut self.inverse_w);
        refill(&mut faces.triangles, &mut self.triangles);
    }

    /// An array of light or texture coordinates. Contents unspecified, overwrite before use.
    pub(crate) fn shares(&mut self) -> Vec<LightShare> {
        self.shares.pop().unwrap_or_default()
    }

    /// An array of colours. Contents unspecified, overwrite before use.
    pub(crate) fn colors(&mut self) -> Vec<Rgba> {
        self.colors.pop().unwrap_or_default()
    }
}

fn refill<T>(array: &mut Vec<T>, pool: &mut Vec<Vec<T>>) {
    if array.capacity() == 0 {
        *array = pool.pop().unwrap_or_default();
    }
}
