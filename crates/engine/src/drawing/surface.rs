//! Surfaces of the display list: triangles, their base colours, and the light on these.
//!
//! A [`Base`] and a [`SurfaceLight`] are independent, and any two go together. The questions that the rest of the
//! program has about either are answered here, so that a new base or a new light is an arm in each method of
//! [`Surface`], in the two files of the pipeline that make it (`pipeline/stage/attributes.rs`, `light.rs`), in
//! `pipeline/mesh/resample.rs`, which cuts it, and in `raster/surfaces/per_pixel.rs`, which paints it.

use std::sync::Arc;

use super::Shadow;
use crate::appearance::{LightShare, Rgba, Sampler, Texture};

/// A set of triangles painted one way.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// x, y in pixels and depth, one per vertex. All inside the picture (clipping has been done).
    pub positions: Vec<[f32; 3]>,
    /// 1/w of each vertex for perspective-correct interpolation. Empty if w is the same everywhere or nothing is
    /// interpolated.
    pub inverse_w: Vec<f32>,
    /// Indices into `positions`. Either winding (culling has been done).
    pub triangles: Vec<[u32; 3]>,
    /// The colours before light, or with it if `light` says so.
    pub base: Base,
    /// The light on them.
    pub light: SurfaceLight,
    /// The light that shadows take away, one for each light that casts any. It isn't in the base colours then.
    pub shadows: Vec<Shadow>,
    /// Drawn after all opaque surfaces, from back to front, with the alpha of its colours.
    pub translucent: bool,
    /// False: no depth test and no depth written (the plan has shown that no test can change the picture).
    pub depth_test: bool,
}

/// The base colours of a [`Surface`].
#[derive(Clone, Debug, PartialEq)]
pub enum Base {
    /// One colour for everything.
    Solid(Rgba),
    /// One colour for each triangle.
    Faces(Vec<Rgba>),
    /// One colour for each vertex, interpolated.
    Vertices(Vec<Rgba>),
    /// A picture, stretched over the surface.
    Texture {
        /// The picture.
        image: Arc<Texture>,
        /// How it's sampled.
        sampler: Sampler,
        /// Texture coordinates of each vertex: (0, 0) at the top left of the picture, (1, 1) at its bottom right.
        uv: Vec<[f32; 2]>,
        /// Multiplies the colours of the picture. White leaves them as they are. Its alpha is the opacity.
        tint: Rgba,
        /// The tint at each vertex in its place, interpolated. Empty means the same everywhere.
        tints: Vec<Rgba>,
    },
}

/// The light on the base colours of a [`Surface`].
#[derive(Clone, Debug, PartialEq)]
pub enum SurfaceLight {
    /// The base colours are final. They take no light, or hold it already, from their faces (flat) or their vertices
    /// (Gouraud).
    InBase,
    /// Light at each triangle, on a base colour that varies over it (flat).
    Faces(Vec<LightShare>),
    /// Light at each vertex, interpolated, on a base colour that varies otherwise (Gouraud).
    Vertices(Vec<LightShare>),
    /// Light at each pixel, on the base colour there (Phong).
    PerPixel(PixelLight),
}

/// The inputs for lighting a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelLight {
    /// Unit normals in view space, one per vertex, interpolated.
    pub normals: Vec<[f32; 3]>,
    /// Positions in view space, one per vertex, in any unit of length that the lights share.
    pub positions: Vec<[f32; 3]>,
    /// The lights, in view space.
    pub lighting: Lighting,
}

/// Lights in view space, in the simple model of `[2]` and `[3]`: ambient + diffuse + specular. The formula is that of
/// [`lighting`](crate::lighting).
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Lighting {
    /// Ambient share of the colour, 0 … 1.
    pub ambient: f32,
    /// Share of the diffuse term, 0 … 1.
    pub diffuse: f32,
    /// Share of the specular term, 0 … 1.
    pub specular: f32,
    /// Exponent of the specular term, a whole number.
    pub shininess: f32,
    /// True if the viewer is at infinity (parallel projection).
    pub distant_viewer: bool,
    /// Light both sides of a face.
    pub two_sided: bool,
    /// The lights in view space, in the order of the scene.
    pub lights: Vec<ViewLight>,
}

/// One light, in view space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewLight {
    /// Its position or, for a distant light, the unit vector **towards** it.
    pub vector: [f32; 3],
    /// True if the light is at infinity (parallel light).
    pub distant: bool,
}

/// The least opacity of a tint: a third. Fainter surfaces, such as the faces of a view volume, dim no strokes.
const TINT: u8 = 85;

impl Surface {
    /// Triangles of one final colour, depth-tested, and translucent if the colour is.
    pub fn solid(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>, color: Rgba) -> Self {
        Self {
            positions,
            inverse_w: Vec::new(),
            triangles,
            base: Base::Solid(color),
            light: SurfaceLight::InBase,
            shadows: Vec::new(),
            translucent: !color.is_opaque(),
            depth_test: true,
        }
    }

    /// True if the colour of a triangle varies over it, so that something is interpolated between its vertices.
    pub fn varies(&self) -> bool {
        match (&self.base, &self.light) {
            (Base::Solid(_) | Base::Faces(_), SurfaceLight::InBase) => false,
            (Base::Vertices(_) | Base::Texture { .. }, SurfaceLight::InBase)
            | (_, SurfaceLight::Faces(_) | SurfaceLight::Vertices(_) | SurfaceLight::PerPixel(_)) => true,
        }
    }

    /// True if it has a picture on it.
    pub fn is_textured(&self) -> bool {
        matches!(self.base, Base::Texture { .. })
    }

    /// The base colour of a triangle. `None` if the list has none, or if it varies over the triangle.
    #[inline]
    pub fn face_color(&self, triangle: usize) -> Option<Rgba> {
        match &self.base {
            Base::Solid(color) => Some(*color),
            Base::Faces(colors) => colors.get(triangle).copied(),
            Base::Vertices(_) | Base::Texture { .. } => None,
        }
    }

    /// The base colour of a triangle at one of its vertices. Grey under a picture. `None` if the list has none.
    pub fn color_at_vertex(&self, triangle: usize, vertex: u32) -> Option<Rgba> {
        match &self.base {
            Base::Solid(_) | Base::Faces(_) => self.face_color(triangle),
            Base::Vertices(colors) => colors.get(vertex as usize).copied(),
            Base::Texture { .. } => Some(Rgba::rgb(128, 128, 128)),
        }
    }

    /// The opacity of a triangle at its first vertex. `None` if the list has none.
    pub fn alpha_of(&self, triangle: usize) -> Option<u8> {
        match &self.base {
            Base::Solid(_) | Base::Faces(_) | Base::Vertices(_) => {
                let first = self.triangles.get(triangle)?[0];
                self.color_at_vertex(triangle, first).map(|color| color.a)
            }
            Base::Texture { tint, .. } => Some(tint.a),
        }
    }

    /// Its tints: translucent triangles of some strength, which dim the strokes and marks behind them. Pictures don't
    /// count, because many are clear in places.
    pub fn tints(&self) -> impl Iterator<Item = [u32; 3]> {
        let may_dim = self.translucent && !self.is_textured();
        let tints = move |triangle: usize| may_dim && self.alpha_of(triangle).is_some_and(|alpha| alpha >= TINT);
        self.triangles.iter().enumerate().filter(move |(k, _)| tints(*k)).map(|(_, triangle)| *triangle)
    }

    /// Replaces an opaque picture of one colour by the colour.
    pub fn simplify(&mut self) {
        if let Base::Texture { image, sampler, tint, tints, .. } = &self.base
            && !self.translucent
            && tints.is_empty()
            && sampler.reveal.is_none()
            && let Some(color) = image.one_color_times(*tint)
        {
            self.base = Base::Solid(color);
        }
    }

    /// Gives it other colours, which are final.
    pub fn repaint(&mut self, base: Base) {
        (self.base, self.light) = (base, SurfaceLight::InBase);
        self.shadows.clear();
    }

    /// Makes all colours opaque.
    pub fn make_opaque(&mut self) {
        self.translucent = false;
        match &mut self.base {
            Base::Solid(color) => color.a = 255,
            Base::Faces(colors) | Base::Vertices(colors) => colors.iter_mut().for_each(|color| color.a = 255),
            Base::Texture { tint, tints, .. } => tints.iter_mut().chain([tint]).for_each(|tint| tint.a = 255),
        }
    }

    /// Keeps only the first triangles.
    pub fn truncate(&mut self, count: usize) {
        self.triangles.truncate(count);
        if let Base::Faces(colors) = &mut self.base {
            colors.truncate(count);
        }
        if let SurfaceLight::Faces(shares) = &mut self.light {
            shares.truncate(count);
        }
        self.shadows.iter_mut().for_each(|shadow| shadow.truncate(count));
    }
}

impl ViewLight {
    /// Parallel light from the direction of this unit vector.
    pub const fn directional(to_light: [f32; 3]) -> Self {
        Self { vector: to_light, distant: true }
    }

    /// A lamp at this position.
    pub const fn point(position: [f32; 3]) -> Self {
        Self { vector: position, distant: false }
    }
}

impl Lighting {
    /// True if the positions of the points matter.
    pub fn needs_positions(&self) -> bool {
        let viewer = !self.distant_viewer && (self.two_sided || self.specular > 0.0);
        viewer || self.lights.iter().any(|light| !light.distant)
    }
}
