//! **Light**: the reflection model on the faces that are left, and their surfaces in the drawing.
//!
//! *Notes*: `[3]` §1.1 step 2; `[2]` on flat, Gouraud and Phong shading. *Textbook*: second in the list, right after
//! the walk through the scene: every face or vertex of every object is lit before anything is dropped. *Here*: last of
//! the stages of an object, because light costs most and half of all faces were dropped meanwhile. The formula is in
//! [`lighting`](crate::lighting), and [`reflection`](super::reflection) applies it to eight points at a time. This file
//! decides which points those are ([`LitAt`]): one for each face (flat), the vertices of the remaining faces (Gouraud),
//! or none, if the pixels are lit by the rasterizer (Phong), which then needs normals and positions. Light is
//! multiplied into the colours. It stays apart from them under a texture, and if a shadow may take part of it away,
//! because the pixel then needs both. Everything else that a surface carries is made in
//! [`attributes`](super::attributes).

use glam::DVec3;

use super::attributes::FacesToLight;
use super::faces::Faces;
use super::reflection::ObjectLight;
use crate::appearance::{LightShare, Rgba};
use crate::drawing::{Base, BlockedLight, PixelLight, Shadow, Surface, SurfaceLight};
use crate::pipeline::mesh::resample::{color_at, face_color};
use crate::pipeline::order::pieces::Layer;
use crate::pipeline::plan::LitAt;
use crate::pipeline::space::ViewPoint;
use crate::scene::ObjectPaint;

/// The base colour of light that is kept apart from the colours.
pub(crate) const WHITE: Rgba = Rgba::rgb(255, 255, 255);

/// Lights the faces of an object and makes their surface. Takes the arrays of `faces`. `None` if no face is left.
pub(crate) fn light(of: &FacesToLight, faces: &mut Faces) -> Option<Surface> {
    if faces.triangles.is_empty() {
        return None;
    }
    let light = ObjectLight::new(of.lights, &of.object.mesh, of.vertices, of.both_sides);
    let shadows: Vec<Shadow> = of.shadows.iter().filter_map(|shadow| of.shadow(shadow, faces)).collect();
    let (base, light) = match (of.lit, &of.object.paint) {
        (LitAt::Nowhere, _) => of.own_base(faces),
        (LitAt::Pixels, _) => (of.own_base(faces).0, of.per_pixel(faces, &light)),
        (LitAt::Faces, _) if of.keeps_light_apart() => of.light_apart_at_faces(faces, &light, &shadows),
        (LitAt::Faces, _) => (of.lit_faces(faces, &light), SurfaceLight::InBase),
        (LitAt::Vertices, _) if of.keeps_light_apart() => of.light_apart_at_vertices(faces, &light, &shadows),
        (LitAt::Vertices, ObjectPaint::Faces(colors)) => return Some(of.unshared(faces, &light, colors)),
        (LitAt::Vertices, _) => (of.lit_vertices(faces, &light), SurfaceLight::InBase),
    };
    of.bend(faces);
    Some(Surface {
        shadows,
        positions: std::mem::take(&mut faces.image.positions),
        inverse_w: std::mem::take(&mut faces.image.inverse_w),
        triangles: std::mem::take(&mut faces.triangles),
        ..of.bare(base, light)
    })
}

impl FacesToLight<'_> {
    /// The surface, with the data for sorting its faces.
    pub(crate) fn layer(&self, faces: &mut Faces, never_hides_itself: bool) -> Option<Layer> {
        let own = (0..self.vertex_count()).map(|i| self.vertices.view_point(i).0);
        let cuts = faces.cuts.iter().map(|cut| cut.of(|i| self.vertices.view_point(i).0));
        let mut view: Vec<DVec3> = own.chain(cuts).collect();
        if self.shares_no_vertex() {
            view = faces.triangles.iter().flatten().map(|&i| view[i as usize]).collect();
        }
        Some(Layer { surface: light(self, faces)?, view, never_hides_itself })
    }

    /// The colours of faces, and next to them the light on each face.
    fn light_apart_at_faces(&self, faces: &Faces, light: &ObjectLight, shadows: &[Shadow]) -> (Base, SurfaceLight) {
        let base = match &self.object.paint {
            ObjectPaint::Vertices(_) => self.face_colors(faces),
            _ => self.own_base(faces).0,
        };
        let shares = match self.of_only_lamp(shadows) {
            Some(BlockedLight::Faces(taken)) => with_ambient(taken, light),
            _ => self.face_shares(faces, light),
        };
        (base, SurfaceLight::Faces(shares))
    }

    /// The colours of vertices, and next to them the light on each vertex.
    fn light_apart_at_vertices(&self, faces: &Faces, light: &ObjectLight, shadows: &[Shadow]) -> (Base, SurfaceLight) {
        let base = self.own_base(faces).0;
        let shares = match self.of_only_lamp(shadows) {
            Some(BlockedLight::Vertices(taken)) => {
                let own = taken.get(..self.vertices.len()).unwrap_or_default();
                Self::at_cuts(faces, with_ambient(own, light))
            }
            _ => Self::vertex_shares(faces, light),
        };
        (base, SurfaceLight::Vertices(shares))
    }

    /// True if the light of faces or vertices is not put into the colours: under a picture, and if a shadow may
    /// take some of it away.
    fn keeps_light_apart(&self) -> bool {
        !self.shadows.is_empty() || matches!(self.object.paint, ObjectPaint::Texture(_))
    }

    /// Light at each face, whatever its colours.
    pub(super) fn face_shares(&self, faces: &Faces, light: &ObjectLight) -> Vec<LightShare> {
        let triangles = &self.object.mesh.triangles;
        light.faces(faces.source.len(), |k| (triangles[faces.source[k] as usize], WHITE))
    }

    /// Light at each vertex, whatever its colour. Cuts interpolate between their neighbours.
    pub(super) fn vertex_shares(faces: &Faces, light: &ObjectLight) -> Vec<LightShare> {
        Self::at_cuts(faces, light.vertices(&faces.used, |_| WHITE))
    }

    /// The light of the only lamp of the scene, if its shadow falls here. Together with the ambient share it's all the
    /// light.
    fn of_only_lamp<'s>(&self, shadows: &'s [Shadow]) -> Option<&'s BlockedLight> {
        match shadows {
            [only] if self.lights.is_one() => Some(&only.taken),
            _ => None,
        }
    }

    /// Light at each face.
    fn lit_faces(&self, faces: &Faces, light: &ObjectLight) -> Base {
        let (triangles, paint) = (&self.object.mesh.triangles, &self.object.paint);
        Base::Faces(light.faces(faces.source.len(), |k| {
            let (face, triangle) = (faces.source[k], triangles[faces.source[k] as usize]);
            (triangle, face_color(paint, face, triangle))
        }))
    }

    /// Light at each vertex. Cuts interpolate between their neighbours.
    fn lit_vertices(&self, faces: &Faces, light: &ObjectLight) -> Base {
        let mut colors = match &self.object.paint {
            ObjectPaint::Solid(color) => light.vertices(&faces.used, |_| *color),
            ObjectPaint::Vertices(own) => light.vertices(&faces.used, |i| color_at(own, i)),
            // Faces go through `unshared`, and light on a picture is kept apart from it.
            ObjectPaint::Faces(_) | ObjectPaint::Texture(_) => return self.own_base(faces).0,
        };
        for cut in &faces.cuts {
            colors.push(cut.of(|i| colors[i as usize]));
        }
        Base::Vertices(colors)
    }

    /// Light at each pixel, from attributes that are interpolated between the vertices.
    fn per_pixel(&self, faces: &Faces, light: &ObjectLight) -> SurfaceLight {
        let (normal, view) = (|i| light.unit_normal(i), |i| self.vertices.view_point(i));
        let mut normals = self.at_vertices(|i| normal(i).as_vec3().to_array());
        let mut positions = self.at_vertices(|i| self.lights.position(view(i)));
        for cut in &faces.cuts {
            normals.push(cut.of(normal).as_vec3().to_array());
            positions.push(self.lights.position(ViewPoint(cut.of(|i| view(i).0))));
        }
        SurfaceLight::PerPixel(PixelLight { normals, positions, lighting: light.lighting.clone() })
    }
}

/// The light of a lamp, and the ambient share with it: to the bit the same as for both together.
fn with_ambient(of_lamp: &[LightShare], light: &ObjectLight) -> Vec<LightShare> {
    let ambient = light.lighting.ambient;
    of_lamp.iter().map(|[share, white]| [share + ambient, *white]).collect()
}
