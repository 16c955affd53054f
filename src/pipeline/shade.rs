//! Surfaces of the drawing from the faces that are left: own colours, or light on faces, vertices or (later) pixels.

use glam::DVec3;

use super::faces::Faces;
use super::light::{Lights, ObjectLight};
use super::pool::Pool;
use super::resample::{VertexOrigin, color_at, mean_color, object_paint, paint_of};
use super::stages::LitAt;
use super::transform::{Vertices, each_chunk};
use super::visibility::Layer;
use crate::appearance::Rgba;
use crate::drawing::{Paint, Phong, Surface};
use crate::scene::{Object, ObjectPaint};

/// One object's faces as its surfaces in the picture need them.
pub(super) struct Shaded<'a> {
    pub(super) object: &'a Object,
    pub(super) vertices: Vertices<'a>,
    pub(super) lights: &'a Lights,
    /// The place of the light computation.
    pub(super) lit: LitAt,
    /// Both sides of the faces may be seen, and are lit.
    pub(super) both_sides: bool,
    /// The surfaces ask for depth, or write it.
    pub(super) depth_test: bool,
}

impl Shaded<'_> {
    /// True where a value is interpolated over the faces, so that 1/w is needed.
    pub(super) fn interpolates(object: &Object, lit: LitAt) -> bool {
        match lit {
            LitAt::Vertices | LitAt::Pixels => true,
            LitAt::Faces => false,
            LitAt::Nowhere => matches!(object.paint, ObjectPaint::Vertices(_) | ObjectPaint::Texture { .. }),
        }
    }

    /// True where the triangles of the mesh have colours, their own or those of their light, so that each face that is
    /// left must know which one it was.
    pub(super) fn colors_faces(object: &Object, lit: LitAt) -> bool {
        lit == LitAt::Faces || matches!(object.paint, ObjectPaint::Faces(_))
    }

    /// The surfaces of the object: one, or with Phong shading one for each colour of its faces. Takes the faces'
    /// arrays.
    pub(super) fn surfaces(&self, faces: &mut Faces, pool: &mut Pool) -> Vec<Surface> {
        if faces.triangles.is_empty() {
            return Vec::new();
        }
        let light = ObjectLight::new(self.lights, &self.object.mesh, self.vertices, self.both_sides);
        let triangles = &self.object.mesh.triangles;
        let on_faces = |pool: &mut Pool, color: &(dyn Fn(u32) -> Rgba + Sync)| {
            Paint::Faces(light.faces(pool.colors(), faces.source.len(), |k| {
                let face = faces.source[k];
                (triangles[face as usize], color(face))
            }))
        };
        let paint = match (self.lit, &self.object.paint) {
            (LitAt::Nowhere, _) | (_, ObjectPaint::Texture { .. }) => self.own_paint(faces),
            (LitAt::Faces, ObjectPaint::Solid(color)) => on_faces(pool, &|_| *color),
            (LitAt::Faces, ObjectPaint::Faces(colors)) => on_faces(pool, &|face| color_at(colors, face)),
            (LitAt::Faces, ObjectPaint::Vertices(colors)) => {
                on_faces(pool, &|face| mean_color(colors, triangles[face as usize]))
            }
            (LitAt::Vertices, ObjectPaint::Solid(color)) => {
                self.lit_vertices(faces, &light, pool.colors(), &|_| *color)
            }
            (LitAt::Vertices | LitAt::Pixels, ObjectPaint::Vertices(colors)) => {
                self.lit_vertices(faces, &light, pool.colors(), &|i| color_at(colors, i))
            }
            (LitAt::Pixels, ObjectPaint::Solid(color)) => self.phong(faces, &light, pool, *color),
            (LitAt::Vertices, ObjectPaint::Faces(colors)) => return vec![self.unshared(faces, &light, colors)],
            (LitAt::Pixels, ObjectPaint::Faces(colors)) => return self.surfaces_by_color(faces, &light, pool, colors),
        };
        vec![Surface {
            positions: std::mem::take(&mut faces.image.positions),
            inverse_w: std::mem::take(&mut faces.image.inverse_w),
            triangles: std::mem::take(&mut faces.triangles),
            ..self.bare(paint)
        }]
    }

    /// The surfaces, with the data for sorting them.
    pub(super) fn layers(&self, faces: &mut Faces, pool: &mut Pool, never_hides_itself: bool) -> Vec<Layer> {
        let own = (0..self.vertex_count()).map(|i| self.vertices.view(i));
        let cuts = faces.cuts.iter().map(|cut| cut.of(|i| self.vertices.view(i)));
        let mut view: Vec<DVec3> = own.chain(cuts).collect();
        if self.shares_no_vertex() {
            view = faces.triangles.iter().flatten().map(|&i| view[i as usize]).collect();
        }
        let layer = |surface| Layer { surface, view: view.clone(), never_hides_itself };
        self.surfaces(faces, pool).into_iter().map(layer).collect()
    }

    /// True where [`unshared`](Self::unshared) makes the surface.
    fn shares_no_vertex(&self) -> bool {
        matches!((self.lit, &self.object.paint), (LitAt::Vertices, ObjectPaint::Faces(_)))
    }

    /// A surface without faces.
    fn bare(&self, paint: Paint) -> Surface {
        Surface {
            positions: Vec::new(),
            inverse_w: Vec::new(),
            triangles: Vec::new(),
            paint,
            translucent: self.object.paint.is_translucent(),
            depth_test: self.depth_test,
        }
    }

    /// The object's colours as they are.
    fn own_paint(&self, faces: &Faces) -> Paint {
        let own = (0..self.vertex_count()).map(VertexOrigin::Vertex);
        paint_of(object_paint(&self.object.paint, own.chain(faces.cuts.iter().copied()), &faces.source))
    }

    /// Light at each vertex; cuts interpolate between their neighbours.
    fn lit_vertices(
        &self,
        faces: &Faces,
        light: &ObjectLight,
        colors: Vec<Rgba>,
        color: &(dyn Fn(u32) -> Rgba + Sync),
    ) -> Paint {
        let mut colors = light.vertices(colors, &faces.used, color);
        for cut in &faces.cuts {
            colors.push(cut.of(|i| colors[i as usize]));
        }
        Paint::Vertices(colors)
    }

    fn phong(&self, faces: &Faces, light: &ObjectLight, pool: &mut Pool, color: Rgba) -> Paint {
        let (normal, view) = (|i| light.unit_normal(i), |i| self.vertices.view(i));
        let mut normals = pool.vectors.pop().unwrap_or_default();
        let mut positions = pool.vectors.pop().unwrap_or_default();
        self.at_vertices(&mut normals, |i| normal(i).as_vec3().to_array());
        self.at_vertices(&mut positions, |i| self.lights.position(view(i)));
        for cut in &faces.cuts {
            normals.push(cut.of(normal).as_vec3().to_array());
            positions.push(self.lights.position(cut.of(view)));
        }
        Paint::Phong(Phong { normals, positions, color, lighting: light.lighting.clone() })
    }

    /// Fills an array, whatever was in it, with an attribute of every vertex of the mesh.
    fn at_vertices(&self, values: &mut Vec<[f32; 3]>, attribute: impl Fn(u32) -> [f32; 3] + Sync + Send) {
        values.resize(self.vertices.len(), [0.0; 3]);
        each_chunk(values, |values, first| {
            for (value, i) in values.iter_mut().zip(u32::try_from(first).unwrap_or(u32::MAX)..) {
                *value = attribute(i);
            }
        });
    }

    /// Gouraud shading of faces that have colours of their own: no vertex is shared any more, so that each has one
    /// colour.
    fn unshared(&self, faces: &Faces, light: &ObjectLight, colors: &[Rgba]) -> Surface {
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
        let count = u32::try_from(faces.triangles.len()).unwrap_or(u32::MAX);
        Surface {
            positions: corners().map(|i| faces.image.positions[i]).collect(),
            inverse_w: corners().filter_map(|i| faces.image.inverse_w.get(i).copied()).collect(),
            triangles: (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
            ..self.bare(Paint::Vertices(paint))
        }
    }

    /// Phong shading of faces that have colours of their own: one surface for each colour, in the order in which they
    /// occur.
    fn surfaces_by_color(&self, faces: &Faces, light: &ObjectLight, pool: &mut Pool, colors: &[Rgba]) -> Vec<Surface> {
        let mut surfaces: Vec<(Rgba, Surface)> = Vec::new();
        for (triangle, &face) in faces.triangles.iter().zip(&faces.source) {
            let color = color_at(colors, face);
            let at = surfaces.iter().position(|(c, _)| *c == color).unwrap_or_else(|| {
                let surface = Surface {
                    positions: faces.image.positions.clone(),
                    inverse_w: faces.image.inverse_w.clone(),
                    ..self.bare(self.phong(faces, light, pool, color))
                };
                surfaces.push((color, surface));
                surfaces.len() - 1
            });
            surfaces[at].1.triangles.push(*triangle);
        }
        surfaces.into_iter().map(|(_, surface)| surface).collect()
    }

    fn vertex_count(&self) -> u32 {
        u32::try_from(self.vertices.len()).unwrap_or(u32::MAX)
    }
}
