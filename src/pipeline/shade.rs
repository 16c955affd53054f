//! Light on faces and vertices, by the one formula of [`Lighting::shade`].

use glam::DVec3;

use super::faces::Faces;
use super::plan::LitAt;
use super::transform::{Projector, ViewFromObject, ViewVertices};
use super::visibility::Layer;
use crate::appearance::{Rgba, Shading};
use crate::drawing::{Lighting, Paint, Phong, Surface, ViewLight};
use crate::geometry::try_unit;
use crate::scene::{Light, Object, ObjectPaint};

/// What a face shows where no lamp reaches it.
const AMBIENT: f32 = 0.35;
/// What a lamp adds to a face that it meets squarely.
const DIFFUSE: f32 = 0.65;
/// The white of a highlight, in the two models that have any: a face of one colour would flash as a whole.
const SPECULAR: f32 = 0.3;
/// How small a highlight is.
const SHININESS: f32 = 24.0;

/// Lights of the scene in view space; lengths in units of B, so that they fit in single precision in worlds of any size.
pub(super) struct Lights {
    lighting: Lighting,
    unit: f64,
}

impl Lights {
    /// The lights of a scene. Without any, the ambient share is all, and lit faces show their own colour.
    pub(super) fn new(lights: &[Light], projector: &Projector, shading: Shading) -> Self {
        let unit = projector.far;
        let in_view = |light: &Light| match *light {
            Light::Directional { direction } => {
                let to_light = try_unit(-projector.view_vector(try_unit(direction)?))?;
                Some(ViewLight::Directional(to_light.as_vec3().to_array()))
            }
            Light::Point { position } => Some(ViewLight::Point((projector.view(position) / unit).as_vec3().to_array())),
        };
        let shiny = matches!(shading, Shading::Gouraud | Shading::Phong);
        let lighting = Lighting {
            ambient: if lights.is_empty() { 1.0 } else { AMBIENT },
            diffuse: DIFFUSE,
            specular: if shiny { SPECULAR } else { 0.0 },
            shininess: SHININESS,
            distant_viewer: !projector.perspective,
            two_sided: false,
            lights: lights.iter().filter_map(in_view).collect(),
        };
        Self { lighting, unit }
    }

    /// For the faces of one object, lit on both sides or on the outer one.
    pub(super) fn lighting(&self, two_sided: bool) -> Lighting {
        Lighting { two_sided, ..self.lighting.clone() }
    }

    /// A view point in the unit of the lights.
    pub(super) fn position(&self, p_view: DVec3) -> [f32; 3] {
        (p_view / self.unit).as_vec3().to_array()
    }

    /// The colour of a face, from its own normal, at its centroid. `outward` is −1 where the object is mirrored.
    pub(super) fn face(&self, lighting: &Lighting, [a, b, c]: [DVec3; 3], outward: f64, color: Rgba) -> Rgba {
        let normal = try_unit((b - a).cross(c - a) * outward).unwrap_or_default();
        let centroid = a + ((b - a) + (c - a)) / 3.0;
        lighting.shade(normal.as_vec3().to_array(), self.position(centroid), color)
    }

    /// The colour of a vertex, from its normal.
    pub(super) fn vertex(&self, lighting: &Lighting, p_view: DVec3, normal: DVec3, color: Rgba) -> Rgba {
        let normal = try_unit(normal).unwrap_or_default();
        lighting.shade(normal.as_vec3().to_array(), self.position(p_view), color)
    }
}

/// One object's faces as its surfaces in the picture need them.
pub(super) struct Shaded<'a> {
    pub(super) object: &'a Object,
    pub(super) projector: &'a Projector,
    pub(super) view_from_object: &'a ViewFromObject,
    pub(super) vertices: &'a ViewVertices,
    pub(super) faces: &'a Faces,
    pub(super) lights: &'a Lights,
    /// Where light is computed.
    pub(super) lit: LitAt,
    /// Both sides of the faces may be seen, and are lit.
    pub(super) both_sides: bool,
}

impl Shaded<'_> {
    /// The surfaces, with what their order can be found by.
    pub(super) fn layers(&self, depth_test: bool, never_hides_itself: bool) -> Vec<Layer> {
        let own = (0..self.vertices.len()).map(|i| self.vertices.at(i));
        let cuts = self.faces.cuts.iter().map(|cut| cut.mean(|i| self.vertices.point(i)));
        let mut view: Vec<DVec3> = own.chain(cuts).collect();
        if self.shares_no_vertex() {
            view = self.faces.triangles.iter().flatten().map(|&i| view[i as usize]).collect();
        }
        let layer = |surface| Layer { surface, view: view.clone(), never_hides_itself };
        self.surfaces(depth_test).into_iter().map(layer).collect()
    }

    /// True where [`unshared`](Self::unshared) makes the surface.
    fn shares_no_vertex(&self) -> bool {
        matches!((self.lit, &self.object.paint), (LitAt::Vertices, ObjectPaint::Faces(_)))
    }

    /// The surfaces of the object: one, or with Phong shading one for each colour of its faces.
    pub(super) fn surfaces(&self, depth_test: bool) -> Vec<Surface> {
        if self.faces.triangles.is_empty() {
            return Vec::new();
        }
        let paint = match (self.lit, &self.object.paint) {
            (LitAt::Nowhere, _) | (_, ObjectPaint::Texture { .. }) => self.own_paint(),
            (LitAt::Faces, ObjectPaint::Solid(color)) => self.lit_faces(|_| *color),
            (LitAt::Faces, ObjectPaint::Faces(colors)) => self.lit_faces(|face| color_at(colors, face)),
            (LitAt::Faces, ObjectPaint::Vertices(colors)) => {
                self.lit_faces(|face| mean_color(colors, self.object.mesh.triangles[face as usize]))
            }
            (LitAt::Vertices, ObjectPaint::Solid(color)) => self.lit_vertices(|_| *color),
            (LitAt::Vertices | LitAt::Pixels, ObjectPaint::Vertices(colors)) => {
                self.lit_vertices(|i| color_at(colors, i))
            }
            (LitAt::Pixels, ObjectPaint::Solid(color)) => self.phong(*color),
            (LitAt::Vertices, ObjectPaint::Faces(colors)) => return vec![self.unshared(colors, depth_test)],
            (LitAt::Pixels, ObjectPaint::Faces(colors)) => return self.surfaces_by_color(colors, depth_test),
        };
        vec![self.surface(paint, depth_test)]
    }

    fn surface(&self, paint: Paint, depth_test: bool) -> Surface {
        let interpolated = !matches!(paint, Paint::Solid(_) | Paint::Faces(_));
        let inverse_w = if interpolated && self.projector.perspective { self.inverse_w() } else { Vec::new() };
        Surface {
            positions: self.faces.positions.clone(),
            inverse_w,
            triangles: self.faces.triangles.clone(),
            translucent: translucent(&self.object.paint),
            paint,
            depth_test,
        }
    }

    fn inverse_w(&self) -> Vec<f32> {
        let cuts = self.faces.cuts.iter().map(|cut| cut.w);
        self.vertices.depth.iter().copied().chain(cuts).map(|w| self.projector.relative_inverse_w(w)).collect()
    }

    /// The object's colours as they are.
    fn own_paint(&self) -> Paint {
        match &self.object.paint {
            ObjectPaint::Solid(color) => Paint::Solid(*color),
            ObjectPaint::Faces(colors) => {
                Paint::Faces(self.faces.source.iter().map(|&face| color_at(colors, face)).collect())
            }
            ObjectPaint::Vertices(colors) => Paint::Vertices(self.with_cuts(|i| color_at(colors, i), mean_of_colors)),
            ObjectPaint::Texture { image, uv, opacity } => Paint::Texture {
                image: image.clone(),
                uv: self.with_cuts(|i| uv.get(i as usize).copied().unwrap_or_default(), mean_of_uv),
                opacity: *opacity,
            },
        }
    }

    /// Light on each face, where it is still to be drawn.
    fn lit_faces(&self, color: impl Fn(u32) -> Rgba) -> Paint {
        let lighting = self.lights.lighting(self.both_sides);
        let outward = self.view_from_object.outward();
        let triangles = &self.object.mesh.triangles;
        let mut last = None;
        let colors = self
            .faces
            .source
            .iter()
            .map(|&face| match last {
                Some((same, lit)) if same == face => lit,
                _ => {
                    let corners = triangles[face as usize].map(|i| self.vertices.point(i));
                    let lit = self.lights.face(&lighting, corners, outward, color(face));
                    last = Some((face, lit));
                    lit
                }
            })
            .collect();
        Paint::Faces(colors)
    }

    /// Light at each vertex; cuts take the mean of what they lie between.
    fn lit_vertices(&self, color: impl Fn(u32) -> Rgba) -> Paint {
        let lit = self.vertex_light();
        Paint::Vertices(self.with_cuts(|i| lit(i, color(i)), mean_of_colors))
    }

    /// The colour of a vertex of the mesh under the lights.
    fn vertex_light(&self) -> impl Fn(u32, Rgba) -> Rgba {
        let lighting = self.lights.lighting(self.both_sides);
        let normals = self.view_from_object.normal_matrix();
        move |i, color| {
            let normal = normals * self.object.mesh.normals.get(i as usize).copied().unwrap_or_default();
            self.lights.vertex(&lighting, self.vertices.point(i), normal, color)
        }
    }

    fn phong(&self, color: Rgba) -> Paint {
        let matrix = self.view_from_object.normal_matrix();
        let normal = |i: u32| {
            let normal = matrix * self.object.mesh.normals.get(i as usize).copied().unwrap_or_default();
            try_unit(normal).unwrap_or_default()
        };
        let cuts = &self.faces.cuts;
        let all = 0..self.vertex_count();
        let normals = all.clone().map(normal).chain(cuts.iter().map(|cut| cut.mean(normal)));
        let positions =
            all.map(|i| self.vertices.point(i)).chain(cuts.iter().map(|cut| cut.mean(|i| self.vertices.point(i))));
        Paint::Phong(Phong {
            normals: normals.map(|n| n.as_vec3().to_array()).collect(),
            positions: positions.map(|p| self.lights.position(p)).collect(),
            color,
            lighting: self.lights.lighting(self.both_sides),
        })
    }

    /// Gouraud shading of faces that have colours of their own: no vertex is shared any more, so that each has one colour.
    fn unshared(&self, colors: &[Rgba], depth_test: bool) -> Surface {
        let lit = self.vertex_light();
        let shared = self.surface(Paint::Vertices(Vec::new()), depth_test);
        let corners = || self.faces.triangles.iter().flatten().map(|&i| i as usize);
        let own = self.vertices.len();
        let mut paint = Vec::with_capacity(3 * self.faces.triangles.len());
        for (triangle, &face) in self.faces.triangles.iter().zip(&self.faces.source) {
            let color = color_at(colors, face);
            paint.extend(triangle.map(|i| match (i as usize).checked_sub(own) {
                None => lit(i, color),
                Some(cut) => {
                    let cut = &self.faces.cuts[cut];
                    mean_of_colors(cut.of.map(|i| lit(i, color)), cut.weights)
                }
            }));
        }
        let count = u32::try_from(self.faces.triangles.len()).unwrap_or(u32::MAX);
        Surface {
            positions: corners().map(|i| shared.positions[i]).collect(),
            inverse_w: corners().filter_map(|i| shared.inverse_w.get(i).copied()).collect(),
            triangles: (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
            paint: Paint::Vertices(paint),
            ..shared
        }
    }

    /// Phong shading of faces that have colours of their own: one surface for each colour, in the order in which they occur.
    fn surfaces_by_color(&self, colors: &[Rgba], depth_test: bool) -> Vec<Surface> {
        let mut surfaces: Vec<(Rgba, Surface)> = Vec::new();
        for (triangle, &face) in self.faces.triangles.iter().zip(&self.faces.source) {
            let color = color_at(colors, face);
            let at = surfaces.iter().position(|(c, _)| *c == color).unwrap_or_else(|| {
                let surface = self.surface(self.phong(color), depth_test);
                surfaces.push((color, Surface { triangles: Vec::new(), ..surface }));
                surfaces.len() - 1
            });
            surfaces[at].1.triangles.push(*triangle);
        }
        surfaces.into_iter().map(|(_, surface)| surface).collect()
    }

    fn vertex_count(&self) -> u32 {
        u32::try_from(self.vertices.len()).unwrap_or(u32::MAX)
    }

    /// An attribute of every vertex of the mesh, then of every cut.
    fn with_cuts<T>(&self, attribute: impl Fn(u32) -> T, mean: impl Fn([T; 3], [f64; 3]) -> T) -> Vec<T> {
        let own = (0..self.vertex_count()).map(&attribute);
        own.chain(self.faces.cuts.iter().map(|cut| mean(cut.of.map(&attribute), cut.weights))).collect()
    }
}

/// True where something shows through the paint.
pub(super) fn translucent(paint: &ObjectPaint) -> bool {
    match paint {
        ObjectPaint::Solid(color) => !color.is_opaque(),
        ObjectPaint::Faces(colors) | ObjectPaint::Vertices(colors) => colors.iter().any(|c| !c.is_opaque()),
        ObjectPaint::Texture { opacity, .. } => *opacity < 255,
    }
}

/// Grey for what has no colour of its own.
pub(super) fn color_at(colors: &[Rgba], index: u32) -> Rgba {
    colors.get(index as usize).copied().unwrap_or(Rgba::rgb(128, 128, 128))
}

/// The colour of a face whose corners have colours.
pub(super) fn mean_color(colors: &[Rgba], triangle: [u32; 3]) -> Rgba {
    mean_of_colors(triangle.map(|i| color_at(colors, i)), [1.0 / 3.0; 3])
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a mean of bytes is a byte")]
pub(super) fn mean_of_colors(colors: [Rgba; 3], weights: [f64; 3]) -> Rgba {
    let mean = |channel: fn(Rgba) -> u8| {
        let sum: f64 = (0..3).map(|i| f64::from(channel(colors[i])) * weights[i]).sum();
        (sum + 0.5) as u8
    };
    Rgba::rgba(mean(|c| c.r), mean(|c| c.g), mean(|c| c.b), mean(|c| c.a))
}

#[expect(clippy::cast_possible_truncation, reason = "texture coordinates are single precision")]
pub(super) fn mean_of_uv(uv: [[f32; 2]; 3], weights: [f64; 3]) -> [f32; 2] {
    std::array::from_fn(|axis| (0..3).map(|i| f64::from(uv[i][axis]) * weights[i]).sum::<f64>() as f32)
}
