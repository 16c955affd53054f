//! The light on faces and vertices, eight at a time.
//!
//! *Notes*: `[2]` on Gouraud and Phong; `[3]` §1.1 step 2. *Textbook*: the sum over all lamps, for one point after
//! another. *Here*: the formula of [`lighting`](crate::lighting), which lights pixels too, for eight points by one
//! instruction. Positions are scaled by 1/B, so that single precision is enough in worlds of any size.

use std::sync::atomic::{AtomicBool, Ordering};

use glam::{DMat3, DVec3};

use super::faces::{LANES, to_u32};
use super::normals::{Rows, eight, normals, product, rows, unit_normal};
use super::vertices::Vertices;
use crate::appearance::{LightShare, Rgba, Shading};
use crate::drawing::{Lighting, ViewLight, single};
use crate::geometry::try_unit;
use crate::lighting::{light_eight, packed, shade, unpacked, with_light};
use crate::pipeline::mesh::each_chunk;
use crate::pipeline::space::projector::Projector;
use crate::pipeline::space::{ObjectPoint, ViewPoint, WorldPoint};
use crate::scene::{Light, LightKind, Mesh};
use crate::simd::prelude::*;
use crate::simd::with_vectors;

/// The light of a face that no lamp reaches.
pub const AMBIENT: f32 = 0.35;
/// The light that a lamp adds to a face that it meets squarely.
pub const DIFFUSE: f32 = 0.65;
/// The white of a highlight, in the two models that have any. A face of one colour would flash as a whole.
pub const SPECULAR: f32 = 0.3;
/// The exponent of a highlight.
pub const SHININESS: f32 = 24.0;

/// Lights of the scene in view space. Lengths in units of B, so that they fit in single precision in worlds of any
/// size.
pub(crate) struct Lights {
    lighting: Lighting,
    /// The place in the scene of each light. Lights that can't be turned into view space are missing.
    of_scene: Vec<usize>,
    /// 1/B.
    scale: f64,
}

impl Lights {
    /// The lights of a scene. Without lights only the ambient share remains, and lit faces show their own colour.
    pub(crate) fn new(lights: &[Light], projector: &Projector, shading: Shading) -> Self {
        let (scale, is_dark) = (1.0 / projector.far, lights.is_empty());
        let in_view = |light: &Light| match light.kind {
            LightKind::Directional => {
                let to_light = try_unit(-projector.view_vector(try_unit(light.vector)?))?;
                Some(ViewLight::directional(to_light.as_vec3().to_array()))
            }
            LightKind::Point => {
                Some(ViewLight::point((projector.view(WorldPoint(light.vector)).0 * scale).as_vec3().to_array()))
            }
        };
        let (of_scene, lights): (Vec<usize>, Vec<ViewLight>) =
            lights.iter().enumerate().filter_map(|(k, light)| Some((k, in_view(light)?))).unzip();
        let shiny = matches!(shading, Shading::Gouraud | Shading::Phong);
        let lighting = Lighting {
            ambient: if is_dark { 1.0 } else { AMBIENT },
            diffuse: DIFFUSE,
            specular: if shiny { SPECULAR } else { 0.0 },
            shininess: SHININESS,
            distant_viewer: !projector.projection.is_perspective(),
            two_sided: false,
            lights,
        };
        Self { lighting, of_scene, scale }
    }

    /// The lights for the faces of one object, lit on both sides or on the outer one.
    pub(crate) fn lighting(&self, two_sided: bool) -> Lighting {
        Lighting { two_sided, ..self.lighting.clone() }
    }

    /// The index in this list of a light of the scene.
    pub(crate) fn place_of(&self, light: usize) -> usize {
        self.of_scene.iter().position(|of| *of == light).unwrap_or(usize::MAX)
    }

    /// The light of one lamp of the scene, without the ambient share.
    pub(crate) fn only(&self, light: usize) -> Self {
        let lights = self.lighting.lights.get(self.place_of(light)).copied().into_iter().collect();
        let lighting = Lighting { ambient: 0.0, lights, ..self.lighting.clone() };
        Self { lighting, of_scene: vec![light], scale: self.scale }
    }

    /// True if there is exactly one lamp.
    pub(crate) fn is_one(&self) -> bool {
        self.lighting.lights.len() == 1
    }

    /// A view point in the unit of the lights.
    pub(crate) fn position(&self, p: ViewPoint) -> [f32; 3] {
        (p.0 * self.scale).as_vec3().to_array()
    }
}

/// Light on one object.
pub(crate) struct ObjectLight<'a> {
    pub(crate) lighting: Lighting,
    mesh: &'a Mesh,
    vertices: Vertices<'a>,
    /// Takes normals to view space, and makes them of any length.
    normal_matrix: Rows,
    exact_normal_matrix: DMat3,
    /// Takes `ViewFromObject::offset_from_eye`, times `offset_unit`, to view space in the unit of the lights.
    position_matrix: Rows,
    /// A power of two that keeps offsets in the range of single precision.
    offset_unit: f64,
    needs_positions: bool,
}

/// Points of a surface that are to be lit, coordinate by coordinate.
#[derive(Clone, Copy, Default)]
struct Points {
    /// Normals of any length, in object space.
    normals: [[f32; LANES]; 3],
    /// Offsets in their unit.
    offsets: [[f32; LANES]; 3],
    /// Packed.
    colors: [u32; LANES],
}

impl<'a> ObjectLight<'a> {
    /// `both_sides` means that faces are lit on the visible side rather than on the outer one.
    pub(crate) fn new(lights: &Lights, mesh: &'a Mesh, vertices: Vertices<'a>, both_sides: bool) -> Self {
        let lighting = lights.lighting(both_sides);
        let needs_positions = lighting.needs_positions();
        let of_normals = vertices.view_from_object.normal_matrix();
        let of_normals = of_normals * power_of_two_below_inverse(largest(of_normals));
        let of_offsets = vertices.view_from_object.linear * lights.scale;
        let offset_unit = 1.0 / power_of_two_below_inverse(largest(of_offsets));
        Self {
            lighting,
            mesh,
            vertices,
            normal_matrix: rows(of_normals),
            exact_normal_matrix: of_normals,
            position_matrix: rows(of_offsets * (1.0 / offset_unit)),
            offset_unit,
            needs_positions,
        }
    }

    /// The colours of faces, each from its own normal, at its centroid. `face` gives corners and colour of the k-th.
    pub(crate) fn faces<L: OfLight>(
        &self,
        count: usize,
        face: impl Fn(usize) -> ([u32; 3], Rgba) + Sync + Send,
    ) -> Vec<L> {
        let positions = self.vertices.positions;
        self.lit(count, |first, n, points| {
            for l in 0..n {
                let (triangle, color) = face(first + l);
                let [a, b, c] = triangle;
                let [a, b, c] = [positions[a as usize], positions[b as usize], positions[c as usize]];
                let (ab, ac) = (b - a, c - a);
                // The cofactors take the normal of the object to that of the view, whatever the transform. The length
                // doesn't matter, but must fit in single precision.
                let normal = ab.cross(ac);
                points.set_normal(l, normal * power_of_two_below_inverse(normal.abs().max_element()));
                points.colors[l] = packed(color);
                if self.needs_positions {
                    points.set_offset(l, self.offset(a + (ab + ac) / 3.0));
                }
            }
            true
        })
    }

    /// The colours of the vertices in those groups of [`LANES`] that are `used`. Black for others.
    pub(crate) fn vertices<L: OfLight>(
        &self,
        used: &[AtomicBool],
        color: impl Fn(u32) -> Rgba + Sync + Send,
    ) -> Vec<L> {
        self.lit(self.vertices.len(), |first, n, points| {
            if used.get(first / LANES).is_some_and(|used| !used.load(Ordering::Relaxed)) {
                return false;
            }
            self.gather(first, n, points);
            for (l, i) in (0..n).zip(to_u32(first)..) {
                points.colors[l] = packed(color(i));
            }
            true
        })
    }

    /// The colour of one vertex.
    pub(crate) fn vertex(&self, i: u32, color: Rgba) -> Rgba {
        let mut one = Points::default();
        self.gather(i as usize, 1, &mut one);
        let at = |m: &Rows, v: &[[f32; LANES]; 3]| m.map(|row| row[0] * v[0][0] + row[1] * v[1][0] + row[2] * v[2][0]);
        shade(&self.lighting, at(&self.normal_matrix, &one.normals), at(&self.position_matrix, &one.offsets), color)
    }

    /// The unit normal of a vertex in view space. Zero if there is none.
    pub(crate) fn unit_normal(&self, i: u32) -> DVec3 {
        let normal = self.mesh.normals.get(i as usize).copied().unwrap_or_default();
        unit_normal(self.exact_normal_matrix, normal)
    }

    fn offset(&self, p_object: DVec3) -> DVec3 {
        self.vertices.view_from_object.offset_from_eye(ObjectPoint(p_object)).0 * self.offset_unit
    }

    /// Normals of some vertices, and their offsets if these matter.
    #[inline(always)]
    fn gather(&self, first: usize, n: usize, points: &mut Points) {
        for l in 0..n {
            points.set_normal(l, self.mesh.normals.get(first + l).copied().unwrap_or_default());
        }
        if self.needs_positions {
            for l in 0..n {
                points.set_offset(l, self.offset(self.vertices.positions[first + l]));
            }
        }
    }

    /// Lights `count` points, some at a time. `points` takes the index of the first and their number, and returns true
    /// if they are wanted.
    fn lit<L: OfLight>(
        &self,
        count: usize,
        points: impl Fn(usize, usize, &mut Points) -> bool + Sync + Send,
    ) -> Vec<L> {
        let mut colors = vec![L::UNLIT; count];
        each_chunk(&mut colors, |colors, first| {
            with_vectors!(simd => self.light(simd, colors, first, &points));
        });
        colors
    }

    #[inline(always)]
    fn light<S: Simd, L: OfLight>(
        &self,
        simd: S,
        colors: &mut [L],
        first: usize,
        points: &impl Fn(usize, usize, &mut Points) -> bool,
    ) {
        let mut some = Points::default();
        for (k, lit) in colors.chunks_mut(LANES).enumerate() {
            if points(first + k * LANES, lit.len(), &mut some) {
                let normals = normals(simd, &self.normal_matrix, some.normals);
                let positions = product(&self.position_matrix, eight(simd, some.offsets));
                let shares = light_eight(simd, &self.lighting, normals, positions, |_, _| None);
                L::store(simd, shares, &some.colors, lit);
            } else {
                lit.fill(L::UNLIT);
            }
        }
    }
}

/// The result of light on a point.
pub(crate) trait OfLight: Copy + Send + Sync {
    /// Placeholder for vertices that no visible face uses.
    const UNLIT: Self;

    /// The results for up to eight points, from the light on them and from their packed colours.
    fn store<S: Simd>(simd: S, shares: [f32x8<S>; 2], colors: &[u32; LANES], lit: &mut [Self]);
}

impl OfLight for Rgba {
    const UNLIT: Self = Self::rgb(0, 0, 0);

    #[inline(always)]
    fn store<S: Simd>(simd: S, shares: [f32x8<S>; 2], colors: &[u32; LANES], lit: &mut [Self]) {
        let (colors, most) = (u32x8::simd_from(simd, *colors), f32x8::splat(simd, 255.0));
        let shaded = with_light(simd, shares, colors, most);
        for (lit, &shaded) in lit.iter_mut().zip(shaded.as_slice()) {
            *lit = unpacked(shaded);
        }
    }
}

impl OfLight for LightShare {
    const UNLIT: Self = [0.0; 2];

    #[inline(always)]
    fn store<S: Simd>(_: S, [share, white]: [f32x8<S>; 2], _: &[u32; LANES], lit: &mut [Self]) {
        for (l, lit) in lit.iter_mut().enumerate() {
            *lit = [share[l], white[l]];
        }
    }
}

impl Points {
    #[inline(always)]
    fn set_normal(&mut self, l: usize, n: DVec3) {
        [self.normals[0][l], self.normals[1][l], self.normals[2][l]] = [single(n.x), single(n.y), single(n.z)];
    }

    #[inline(always)]
    fn set_offset(&mut self, l: usize, d: DVec3) {
        [self.offsets[0][l], self.offsets[1][l], self.offsets[2][l]] = [single(d.x), single(d.y), single(d.z)];
    }
}

fn largest(m: DMat3) -> f64 {
    m.to_cols_array().iter().fold(0.0, |most, c| c.abs().max(most))
}

/// A power of two p with 1/4 < p · value < 2 or so, without a division. A harmless one for 0 and for NaN.
#[inline(always)]
fn power_of_two_below_inverse(value: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    const LARGEST: u64 = 0x7fd << 52;
    f64::from_bits(LARGEST.saturating_sub(value.to_bits() & EXPONENT))
}
