//! The surface of an object's faces, with everything that it carries after a cut: colours, texture coordinates, 1/w,
//! and the places and planes of shadows. [`light`](super::light) adds the light.

use glam::DMat4;

use super::faces::{Faces, to_u32};
use super::reflection::{Lights, ObjectLight};
use super::shadow_maps::{SeenByLight, ShadowLight};
use super::vertices::Vertices;
use crate::appearance::{LightShare, Rgba};
use crate::drawing::{Base, BlockedLight, Shadow, Surface, SurfaceLight, single};
use crate::pipeline::mesh::each_chunk;
use crate::pipeline::mesh::resample::{VertexOrigin, base_of, color_at, face_color, found_light, object_paint};
use crate::pipeline::plan::LitAt;
use crate::pipeline::space::ObjectPoint;
use crate::scene::{Object, ObjectPaint, Pictured};

/// One object's faces as light and their surface need them.
pub(crate) struct FacesToLight<'a> {
    pub(crate) object: &'a Object,
    pub(crate) vertices: Vertices<'a>,
    pub(crate) lights: &'a Lights,
    /// The place of the light computation.
    pub(crate) lit: LitAt,
    /// The lights whose shadows may fall on it.
    pub(crate) shadows: &'a [ShadowLight],
    /// Its picture has more than one colour.
    pub(crate) textured: bool,
    /// Both sides of the faces may be seen and are lit.
    pub(crate) both_sides: bool,
    /// The surfaces test depth, or write it.
    pub(crate) depth_test: bool,
}

impl FacesToLight<'_> {
    /// True if [`unshared`](Self::unshared) makes the surface.
    pub(super) fn shares_no_vertex(&self) -> bool {
        self.shadows.is_empty() && matches!((self.lit, &self.object.paint), (LitAt::Vertices, ObjectPaint::Faces(_)))
    }

    /// A surface without faces.
    pub(super) fn bare(&self, base: Base, light: SurfaceLight) -> Surface {
        Surface {
            positions: Vec::new(),
            inverse_w: Vec::new(),
            triangles: Vec::new(),
            base,
            light,
            shadows: Vec::new(),
            translucent: self.object.paint.is_translucent(),
            depth_test: self.depth_test,
        }
    }

    /// 1/w of the vertices in the world's perspective, if the object is its image in the canonical view. Else empty.
    fn inverse_w(&self) -> &[f32] {
        self.object.in_world.as_ref().map_or(&[], |in_world| &in_world.inverse_w)
    }

    /// Multiplies 1/w by that of the world's perspective, if the object is its image in the canonical view. Attributes
    /// then go through two perspectives.
    pub(super) fn bend(&self, faces: &mut Faces) {
        let inverse_w = self.inverse_w();
        if inverse_w.is_empty() {
            return;
        }
        let of = |i: u32| f64::from(inverse_w.get(i as usize).copied().unwrap_or(1.0));
        let own = (0..self.vertex_count()).map(of);
        let cuts = faces.cuts.iter().map(|cut| cut.of(of));
        let all = own.chain(cuts).map(single);
        if faces.image.inverse_w.is_empty() {
            faces.image.inverse_w = all.collect();
        } else {
            faces.image.inverse_w.iter_mut().zip(all).for_each(|(own, q)| *own *= q);
        }
    }

    /// The object's colours as they are, with the light that has been found for them.
    pub(super) fn own_base(&self, faces: &Faces) -> (Base, SurfaceLight) {
        let origins = || (0..self.vertex_count()).map(VertexOrigin::Vertex).chain(faces.cuts.iter().copied());
        let in_world = self.object.in_world.as_ref();
        let light =
            in_world.map_or(SurfaceLight::InBase, |in_world| found_light(&in_world.light, origins(), &faces.source));
        if let ObjectPaint::Texture(pictured) = &self.object.paint
            && let Some(color) = pictured.one_color().filter(|_| !self.textured)
        {
            // The light is kept apart from it as from a picture, so that it comes out the same.
            return (Base::Solid(color), light);
        }
        if let ObjectPaint::Texture(Pictured { image, sampler, uv: own, tint, tints, .. }) = &self.object.paint
            && faces.cuts.is_empty()
        {
            // Nothing is new: the coordinates stay as they are.
            let mut uv = Vec::clone(own);
            uv.resize(self.vertices.len(), [0.0; 2]);
            let tints = Vec::clone(tints);
            return (Base::Texture { image: image.clone(), sampler: *sampler, uv, tint: *tint, tints }, light);
        }
        (base_of(object_paint(self.object, origins(), &faces.source)), light)
    }

    /// The light at the vertices of the mesh, and at the cuts between them.
    pub(super) fn at_cuts(faces: &Faces, mut shares: Vec<LightShare>) -> Vec<LightShare> {
        for cut in &faces.cuts {
            shares.push(cut.of(|i| shares[i as usize]));
        }
        shares
    }

    /// The one colour of each face.
    pub(super) fn face_colors(&self, faces: &Faces) -> Base {
        let (triangles, paint) = (&self.object.mesh.triangles, &self.object.paint);
        let color = |&face: &u32| face_color(paint, face, triangles[face as usize]);
        Base::Faces(faces.source.iter().map(color).collect())
    }

    /// The shadows of one light. `None` if the object is lit in the world, and not by this light.
    pub(super) fn shadow(&self, shadow: &ShadowLight, faces: &Faces) -> Option<Shadow> {
        let mesh = &self.object.mesh;
        let (world_from_object, positions) = match &self.object.in_world {
            Some(in_world) => (DMat4::IDENTITY, &in_world.positions),
            None => (self.object.world_from_object, &mesh.positions),
        };
        let found = match &self.object.in_world {
            Some(in_world) => Some(&in_world.taken.iter().find(|(light, _)| *light == shadow.light)?.1),
            None => None,
        };
        let seen: SeenByLight = shadow.sees(world_from_object);
        let place = |i: u32| seen.place(ObjectPoint(positions[i as usize]));
        // Six faces share a vertex, so its exact place, which their planes are made of, is found once.
        let exact = self.at_vertices(place);
        let mut places = self.at_vertices(|i| exact[i as usize].as_vec3().to_array());
        let inverse_w = self.inverse_w();
        let of_cut = |cut: &VertexOrigin| {
            if inverse_w.is_empty() {
                return cut.of(place);
            }
            // Values that are affine between the vertices are divided by w.
            let q = |i: u32| f64::from(inverse_w.get(i as usize).copied().unwrap_or(1.0));
            cut.of(|i| place(i) * q(i)) / cut.of(q)
        };
        places.extend(faces.cuts.iter().map(|cut| of_cut(cut).as_vec3().to_array()));
        let mut planes = vec![[0.0; 3]; faces.triangles.len()];
        each_chunk(&mut planes, |planes, first| {
            for (plane, &source) in planes.iter_mut().zip(&faces.source[first..]) {
                *plane = seen.plane(mesh.triangles[source as usize].map(|i| exact[i as usize]));
            }
        });
        let alone = || {
            let lights = self.lights.only(shadow.light);
            ObjectLight::new(&lights, mesh, self.vertices, self.both_sides)
        };
        let origins = (0..self.vertex_count()).map(VertexOrigin::Vertex).chain(faces.cuts.iter().copied());
        let taken = match (found.map(|found| found_light(found, origins, &faces.source)), self.lit) {
            (Some(SurfaceLight::Faces(shares)), _) => BlockedLight::Faces(shares),
            (Some(SurfaceLight::Vertices(shares)), _) => BlockedLight::Vertices(shares),
            (_, LitAt::Faces) => BlockedLight::Faces(self.face_shares(faces, &alone())),
            (_, LitAt::Vertices) => BlockedLight::Vertices(Self::vertex_shares(faces, &alone())),
            // Without light there is no shadow.
            (_, LitAt::Pixels | LitAt::Nowhere) => BlockedLight::Light(self.lights.place_of(shadow.light)),
        };
        Some(Shadow { map: std::sync::Arc::clone(&shadow.map), bias: shadow.bias, places, planes, taken })
    }

    /// An attribute of every vertex of the mesh.
    pub(super) fn at_vertices<T: Default + Clone + Send>(&self, attribute: impl Fn(u32) -> T + Sync + Send) -> Vec<T> {
        let mut values = vec![T::default(); self.vertices.len()];
        each_chunk(&mut values, |values, first| {
            for (value, i) in values.iter_mut().zip(to_u32(first)..) {
                *value = attribute(i);
            }
        });
        values
    }

    /// Gouraud shading of faces that have colours of their own. Vertices are no longer shared, so each has one colour.
    pub(super) fn unshared(&self, faces: &Faces, light: &ObjectLight, colors: &[Rgba]) -> Surface {
        let own = self.vertices.len();
        let mut paint = Vec::with_capacity(3 * faces.triangles.len());
        for (triangle, &face) in faces.triangles.iter().zip(&faces.source) {
            let color = color_at(colors, face);
            paint.extend(triangle.map(|i| match (i as usize).checked_sub(own) {
                None => light.vertex(i, color),
                Some(cut) => faces.cuts[cut].of(|i| light.vertex(i, color)),
            }));
        }
        let corners = || faces.triangles.iter().flatten().map(|&i| i as usize);
        let count = to_u32(faces.triangles.len());
        Surface {
            positions: corners().map(|i| faces.image.positions[i]).collect(),
            inverse_w: corners().filter_map(|i| faces.image.inverse_w.get(i).copied()).collect(),
            triangles: (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
            ..self.bare(Base::Vertices(paint), SurfaceLight::InBase)
        }
    }

    pub(super) fn vertex_count(&self) -> u32 {
        to_u32(self.vertices.len())
    }
}
