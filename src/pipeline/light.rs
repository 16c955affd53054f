//! Light on faces and vertices, by the one formula of [`Lighting::shade`].

use glam::{DVec3, Mat3};

use super::transform::{Projector, Vertices, each_chunk};
use crate::appearance::{Rgba, Shading};
use crate::drawing::{Lighting, ViewLight};
use crate::geometry::try_unit;
use crate::scene::{Light, Mesh};

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
    /// 1/B.
    scale: f64,
}

impl Lights {
    /// The lights of a scene. Without any, the ambient share is all, and lit faces show their own colour.
    pub(super) fn new(lights: &[Light], projector: &Projector, shading: Shading) -> Self {
        let scale = 1.0 / projector.far;
        let in_view = |light: &Light| match *light {
            Light::Directional { direction } => {
                let to_light = try_unit(-projector.view_vector(try_unit(direction)?))?;
                Some(ViewLight::Directional(to_light.as_vec3().to_array()))
            }
            Light::Point { position } => {
                Some(ViewLight::Point((projector.view(position) * scale).as_vec3().to_array()))
            }
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
        Self { lighting, scale }
    }

    /// For the faces of one object, lit on both sides or on the outer one.
    pub(super) fn lighting(&self, two_sided: bool) -> Lighting {
        Lighting { two_sided, ..self.lighting.clone() }
    }

    /// A view point in the unit of the lights.
    pub(super) fn position(&self, p_view: DVec3) -> [f32; 3] {
        (p_view * self.scale).as_vec3().to_array()
    }
}

/// Light on one object.
pub(super) struct ObjectLight<'a> {
    lights: &'a Lights,
    pub(super) lighting: Lighting,
    mesh: &'a Mesh,
    vertices: Vertices<'a>,
    /// Takes normals to view space, and makes them of any length.
    normal_matrix: Mat3,
    needs_positions: bool,
}

/// Points that are lit together, coordinate by coordinate, for loops that become vector instructions.
const LANES: usize = 8;
type Lanes<T> = [T; LANES];

/// Points of a surface that are to be lit.
struct Points {
    normals: [Lanes<f32>; 3],
    positions: [Lanes<f32>; 3],
    colors: Lanes<Rgba>,
}

impl<'a> ObjectLight<'a> {
    /// `both_sides`: faces are lit on the side that is seen, rather than on the outer one.
    pub(super) fn new(lights: &'a Lights, mesh: &'a Mesh, vertices: Vertices<'a>, both_sides: bool) -> Self {
        let lighting = lights.lighting(both_sides);
        let needs_positions = lighting.needs_positions();
        let matrix = vertices.view_from_object.normal_matrix();
        let largest = matrix.to_cols_array().iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        let normal_matrix = (matrix * power_of_two_below_inverse(largest)).as_mat3();
        Self { lights, lighting, mesh, vertices, normal_matrix, needs_positions }
    }

    /// The colours of faces, each from its own normal, at its centroid. `face` gives corners and colour of the k-th.
    pub(super) fn faces(&self, count: usize, face: impl Fn(usize) -> ([u32; 3], Rgba) + Sync + Send) -> Vec<Rgba> {
        self.lit(count, |at| {
            let faces = at.map(&face);
            let [a, b, c] = [0, 1, 2].map(|corner| {
                let corners = faces.map(|(triangle, _)| self.vertices.positions[triangle[corner] as usize]);
                [corners.map(|p| p.x), corners.map(|p| p.y), corners.map(|p| p.z)]
            });
            let minus = |p: &[Lanes<f64>; 3], q: &[Lanes<f64>; 3]| -> [Lanes<f64>; 3] {
                std::array::from_fn(|axis| std::array::from_fn(|l| p[axis][l] - q[axis][l]))
            };
            let (ab, ac) = (minus(&b, &a), minus(&c, &a));
            let normal: [Lanes<f64>; 3] = std::array::from_fn(|axis| {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                std::array::from_fn(|l| ab[i][l] * ac[j][l] - ab[j][l] * ac[i][l])
            });
            // The cofactors take the normal of the object to that of the view, whatever the transform; the length is of no
            // matter, but must fit in single precision.
            let scale: Lanes<f64> = std::array::from_fn(|l| {
                power_of_two_below_inverse(normal[0][l].abs().max(normal[1][l].abs()).max(normal[2][l].abs()))
            });
            let normals = self.to_view(normal.map(|axis| std::array::from_fn(|l| single(axis[l] * scale[l]))));
            let centroid = |l: usize| {
                let along = |axis: usize| a[axis][l] + (ab[axis][l] + ac[axis][l]) / 3.0;
                DVec3::new(along(0), along(1), along(2))
            };
            let positions = self.positions(centroid);
            Points { normals, positions, colors: faces.map(|(_, color)| color) }
        })
    }

    /// The colours of all vertices, from their normals.
    pub(super) fn vertices(&self, color: impl Fn(u32) -> Rgba + Sync + Send) -> Vec<Rgba> {
        self.lit(self.vertices.len(), |at| {
            let normals = at.map(|i| self.mesh.normals.get(i).copied().unwrap_or_default());
            let normals = [normals.map(|n| single(n.x)), normals.map(|n| single(n.y)), normals.map(|n| single(n.z))];
            let colors = at.map(|i| color(u32::try_from(i).unwrap_or(u32::MAX)));
            let positions = self.positions(|l| self.vertices.positions[at[l]]);
            Points { normals: self.to_view(normals), positions, colors }
        })
    }

    /// The colour of one vertex.
    pub(super) fn vertex(&self, i: u32, color: Rgba) -> Rgba {
        let normal = self.mesh.normals.get(i as usize).copied().unwrap_or_default();
        let normal = self.to_view(normal.to_array().map(|c| [single(c); LANES])).map(|axis| axis[0]);
        let position = self.positions(|_| self.vertices.positions[i as usize]).map(|axis| axis[0]);
        self.lighting.shade(normal, position, color)
    }

    /// The unit normal of a vertex in view space; zero where there is none.
    pub(super) fn unit_normal(&self, i: u32) -> DVec3 {
        let normal = self.mesh.normals.get(i as usize).copied().unwrap_or_default();
        try_unit(self.vertices.view_from_object.normal_matrix() * normal).unwrap_or_default()
    }

    #[inline(always)]
    fn to_view(&self, n: [Lanes<f32>; 3]) -> [Lanes<f32>; 3] {
        let Mat3 { x_axis: x, y_axis: y, z_axis: z } = self.normal_matrix;
        [[x.x, y.x, z.x], [x.y, y.y, z.y], [x.z, y.z, z.z]]
            .map(|row| std::array::from_fn(|l| row[0] * n[0][l] + row[1] * n[1][l] + row[2] * n[2][l]))
    }

    /// The points, given in object space, in the unit of the lights; zero where they do not matter.
    #[inline(always)]
    fn positions(&self, p_object: impl Fn(usize) -> DVec3) -> [Lanes<f32>; 3] {
        if !self.needs_positions {
            return [[0.0; LANES]; 3];
        }
        let view: Lanes<DVec3> = std::array::from_fn(|l| self.vertices.view_from_object.point(p_object(l)));
        let scale = self.lights.scale;
        [view.map(|p| single(p.x * scale)), view.map(|p| single(p.y * scale)), view.map(|p| single(p.z * scale))]
    }

    /// Lights `count` points, some at a time.
    fn lit(&self, count: usize, points: impl Fn(Lanes<usize>) -> Points + Sync + Send) -> Vec<Rgba> {
        let mut colors = vec![Rgba::rgb(0, 0, 0); count];
        each_chunk(&mut colors, |colors, first| {
            for (k, lit) in colors.chunks_mut(LANES).enumerate() {
                let last = lit.len() - 1;
                // Where fewer are left, the last one fills the lanes.
                let at = std::array::from_fn(|l| first + k * LANES + l.min(last));
                let Points { normals, positions, colors } = points(at);
                let shaded = self.lighting.shade_each(&normals, &positions, &colors);
                lit.copy_from_slice(&shaded[..lit.len()]);
            }
        });
        colors
    }
}

/// A power of two p with 1/4 < p · value < 2 or so, without a division; a harmless one for 0 and for what is no number.
#[inline(always)]
fn power_of_two_below_inverse(value: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    const LARGEST: u64 = 0x7fd << 52;
    f64::from_bits(LARGEST.saturating_sub(value.to_bits() & EXPONENT))
}

#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "light needs no more than single precision")]
fn single(value: f64) -> f32 {
    value as f32
}
