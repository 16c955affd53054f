//! Attributes of the vertices that cutting makes: colours, normals, texture coordinates …
//!
//! Every mesh with attributes by vertex or by face is rebuilt here after a cut. A new attribute of vertices is one more
//! arm in [`object_paint`], [`base_of`] or [`append`].

use std::sync::Arc;

use glam::DVec3;

use crate::appearance::Rgba;
use crate::drawing::{Base, BlockedLight, PixelLight, Shadow, Surface, SurfaceLight};
use crate::geometry::try_unit;
use crate::scene::{Adjacency, FoundLight, InWorld, Mesh, Object, ObjectPaint, Pictured, SharedEdge};

/// The origin of a new vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum VertexOrigin {
    /// This vertex of the old mesh.
    Vertex(u32),
    /// A point on a triangle. Its attributes are the weighted sums of those of three vertices.
    Between {
        /// Vertices of the old mesh.
        of: [u32; 3],
        /// Their shares. They add up to 1.
        weights: [f64; 3],
    },
}

/// The weights of the three corners of an uncut triangle.
pub(crate) const OWN_WEIGHTS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl VertexOrigin {
    /// A point on the triangle with these vertices, with its share of each. It's one of them if it has all of one.
    #[inline]
    pub(crate) fn on(of: [u32; 3], weights: [f64; 3]) -> Self {
        match OWN_WEIGHTS.iter().position(|own| *own == weights) {
            Some(own) => Self::Vertex(of[own]),
            None => Self::Between { of, weights },
        }
    }

    /// An attribute of the vertex, from that of each vertex of the old mesh.
    #[inline]
    pub(crate) fn of<T: Attribute>(&self, attribute: impl Fn(u32) -> T) -> T {
        match *self {
            Self::Vertex(i) => attribute(i),
            Self::Between { of, weights } => T::mean(of.map(attribute), weights),
        }
    }
}

/// An attribute of a vertex.
pub(crate) trait Attribute: Copy {
    /// The weighted sum. The order of the three changes nothing if one weight is 0, so that neighbours that share an
    /// edge agree on it.
    fn mean(of: [Self; 3], weights: [f64; 3]) -> Self;
}

impl Attribute for DVec3 {
    fn mean(of: [Self; 3], weights: [f64; 3]) -> Self {
        (0..3).fold(Self::ZERO, |sum, i| sum + of[i] * weights[i])
    }
}

impl Attribute for [f32; 3] {
    fn mean(of: [Self; 3], weights: [f64; 3]) -> Self {
        let wide = of.map(|v| DVec3::from_array(v.map(f64::from)));
        DVec3::mean(wide, weights).as_vec3().to_array()
    }
}

impl Attribute for f64 {
    fn mean(of: [Self; 3], weights: [f64; 3]) -> Self {
        (0..3).fold(0.0, |sum, i| sum + of[i] * weights[i])
    }
}

impl Attribute for [f32; 2] {
    #[expect(clippy::cast_possible_truncation, reason = "texture coordinates are single precision")]
    fn mean(of: [Self; 3], weights: [f64; 3]) -> Self {
        std::array::from_fn(|axis| (0..3).map(|i| f64::from(of[i][axis]) * weights[i]).sum::<f64>() as f32)
    }
}

impl Attribute for Rgba {
    #[expect(clippy::cast_possible_truncation, reason = "a mean of bytes is a byte")]
    fn mean(of: [Self; 3], weights: [f64; 3]) -> Self {
        let mean = |channel: fn(Self) -> u8| {
            let sum: f64 = (0..3).map(|i| f64::from(channel(of[i])) * weights[i]).sum();
            (sum + 0.5) as u8
        };
        Self::rgba(mean(|c| c.r), mean(|c| c.g), mean(|c| c.b), mean(|c| c.a))
    }
}

/// The colour at a vertex. Grey without a colour.
pub(crate) fn color_at(colors: &[Rgba], index: u32) -> Rgba {
    colors.get(index as usize).copied().unwrap_or(Rgba::rgb(128, 128, 128))
}

/// The colour of a face whose corners have colours.
pub(crate) fn mean_color(colors: &[Rgba], triangle: [u32; 3]) -> Rgba {
    Rgba::mean(triangle.map(|i| color_at(colors, i)), [1.0 / 3.0; 3])
}

/// The one colour of a face, whatever it is painted with.
pub(crate) fn face_color(paint: &ObjectPaint, face: u32, triangle: [u32; 3]) -> Rgba {
    match paint {
        ObjectPaint::Solid(color) => *color,
        ObjectPaint::Faces(colors) => color_at(colors, face),
        ObjectPaint::Vertices(colors) => mean_color(colors, triangle),
        ObjectPaint::Texture(_) => color_at(&[], 0),
    }
}

/// The paint of a mesh whose vertices and triangles come from those of an object. `sources`: the old index of each
/// triangle.
pub(crate) fn object_paint(
    object: &Object,
    origins: impl Iterator<Item = VertexOrigin>,
    sources: &[u32],
) -> ObjectPaint {
    match &object.paint {
        ObjectPaint::Solid(color) => ObjectPaint::Solid(*color),
        ObjectPaint::Faces(colors) => {
            ObjectPaint::Faces(Arc::new(sources.iter().map(|&face| color_at(colors, face)).collect()))
        }
        ObjectPaint::Vertices(colors) => {
            ObjectPaint::Vertices(Arc::new(origins.map(|origin| origin.of(|i| color_at(colors, i))).collect()))
        }
        ObjectPaint::Texture(old) => {
            let inverse_w = object.in_world.as_ref().map_or(&[][..], |in_world| &in_world.inverse_w);
            ObjectPaint::Texture(pictured(old, &origins.collect::<Vec<_>>(), inverse_w))
        }
    }
}

/// The same for a picture.
fn pictured(old: &Pictured, origins: &[VertexOrigin], inverse_w: &[f32]) -> Pictured {
    let at = |i: u32| old.uv.get(i as usize).copied().unwrap_or_default();
    let uv = |origin: &VertexOrigin| {
        if inverse_w.is_empty() {
            return origin.of(at);
        }
        // Values that are affine between the vertices are divided by w.
        let divided = |i: u32| {
            let ([u, v], q) = (at(i), inverse_w.get(i as usize).copied().unwrap_or(1.0));
            [u * q, v * q, q]
        };
        let [u, v, q] = origin.of(divided);
        [u / q, v / q]
    };
    // Colours between corners are affine on the picture, as those of other objects.
    let tint = |origin: &VertexOrigin| origin.of(|i| color_at(&old.tints, i));
    let tints = if old.tints.is_empty() { Vec::new() } else { origins.iter().map(tint).collect() };
    Pictured { uv: Arc::new(origins.iter().map(uv).collect()), tints: Arc::new(tints), ..old.clone() }
}

/// The light found for a mesh whose vertices and triangles come from those of another.
pub(crate) fn found_light(
    old: &FoundLight,
    origins: impl Iterator<Item = VertexOrigin>,
    sources: &[u32],
) -> SurfaceLight {
    match old {
        FoundLight::None => SurfaceLight::InBase,
        FoundLight::Faces(old) => {
            let at = |&face: &u32| old.get(face as usize).copied().unwrap_or_default();
            SurfaceLight::Faces(sources.iter().map(at).collect())
        }
        FoundLight::Vertices(old) => {
            let at = |i: u32| old.get(i as usize).copied().unwrap_or_default();
            SurfaceLight::Vertices(origins.map(|origin| origin.of(at)).collect())
        }
    }
}

/// The colours of an object as they are, for the display list.
pub(crate) fn base_of(paint: ObjectPaint) -> Base {
    match paint {
        ObjectPaint::Solid(color) => Base::Solid(color),
        ObjectPaint::Faces(colors) => Base::Faces(Arc::unwrap_or_clone(colors)),
        ObjectPaint::Vertices(colors) => Base::Vertices(Arc::unwrap_or_clone(colors)),
        ObjectPaint::Texture(Pictured { image, sampler, uv, tint, tints, .. }) => {
            let (uv, tints) = (Arc::unwrap_or_clone(uv), Arc::unwrap_or_clone(tints));
            Base::Texture { image, sampler, uv, tint, tints }
        }
    }
}

/// The normals of a mesh whose vertices come from those of another. None if the other has none.
fn normals(old: &Mesh, origins: &[VertexOrigin]) -> Vec<DVec3> {
    if old.normals.is_empty() {
        return Vec::new();
    }
    let at = |i: u32| old.normals.get(i as usize).copied().unwrap_or_default();
    let unit = |origin: &VertexOrigin| match *origin {
        VertexOrigin::Vertex(i) => at(i),
        VertexOrigin::Between { .. } => try_unit(origin.of(at)).unwrap_or(DVec3::Y),
    };
    origins.iter().map(unit).collect()
}

/// A mesh made of parts of another after a cut: each vertex with its origin, shared as it was.
#[derive(Debug, Default)]
pub(crate) struct Rebuilt {
    /// The new index of each vertex of the old mesh that is still used.
    index: Vec<Option<u32>>,
    /// The origin of each new vertex.
    pub(crate) origins: Vec<VertexOrigin>,
    /// The position of each new vertex.
    pub(crate) positions: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The old triangle of each new one.
    pub(crate) sources: Vec<u32>,
    pub(crate) edges: Vec<[u32; 2]>,
    /// The remaining edges of the old mesh's adjacency. The faces are still the old ones.
    pub(crate) shared: Vec<SharedEdge>,
}

impl Rebuilt {
    pub(crate) fn new(old: &Mesh) -> Self {
        Self { index: vec![None; old.positions.len()], ..Self::default() }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.triangles.is_empty() && self.edges.is_empty()
    }

    /// The index of a vertex, which is new unless it is one of the old mesh and was there before. A new one gets its
    /// position from `position`.
    pub(crate) fn vertex(&mut self, origin: VertexOrigin, position: impl FnOnce() -> DVec3) -> u32 {
        let own = match origin {
            VertexOrigin::Vertex(i) => Some(i as usize),
            VertexOrigin::Between { .. } => None,
        };
        if let Some(index) = own.and_then(|own| self.index[own]) {
            return index;
        }
        let index = u32::try_from(self.origins.len()).unwrap_or(u32::MAX);
        self.origins.push(origin);
        self.positions.push(position());
        if let Some(own) = own {
            self.index[own] = Some(index);
        }
        index
    }

    /// Adds a convex polygon, which is a part of the old triangle `source`, as a fan.
    pub(crate) fn polygon(&mut self, corners: &[u32], source: u32) {
        for k in 1..corners.len().saturating_sub(1) {
            self.triangles.push([corners[0], corners[k], corners[k + 1]]);
            self.sources.push(source);
        }
    }

    /// The object with these parts instead of its mesh. Its inside shows, since it's open now. `None` if nothing is
    /// left.
    pub(crate) fn into_object(self, object: &Object) -> Option<Object> {
        if self.is_empty() {
            return None;
        }
        let old = &object.mesh;
        let paint = object_paint(object, self.origins.iter().copied(), &self.sources);
        let mesh = Mesh {
            normals: normals(old, &self.origins),
            adjacency: Adjacency { planes: old.adjacency.planes.clone(), edges: self.shared },
            positions: self.positions,
            triangles: self.triangles,
            edges: self.edges,
            ..Mesh::default()
        };
        let two_sided = object.two_sided || old.closed;
        Some(Object { mesh: Arc::new(mesh), paint, two_sided, ..object.clone() })
    }
}

/// An object with only some of its triangles and edges, open unless it keeps all. `triangles` are their indices,
/// ascending, and `outlined` the edges of the mesh's adjacency that may still be on its outline.
pub fn with_triangles(object: &Object, triangles: &[u32], edges: Vec<[u32; 2]>, outlined: Vec<SharedEdge>) -> Object {
    let old = &object.mesh;
    let all = triangles.len() == old.triangles.len();
    let mesh = Mesh {
        triangles: triangles.iter().filter_map(|&k| old.triangles.get(k as usize).copied()).collect(),
        edges,
        adjacency: Adjacency { planes: old.adjacency.planes.clone(), edges: outlined },
        closed: old.closed && all,
        convex: old.convex && all,
        positions: old.positions.clone(),
        normals: old.normals.clone(),
    };
    let vertices = 0..u32::try_from(old.positions.len()).unwrap_or(u32::MAX);
    let paint = match &object.paint {
        // Vertices don't change.
        ObjectPaint::Faces(_) => object_paint(object, vertices.map(VertexOrigin::Vertex), triangles),
        paint => paint.clone(),
    };
    let in_world = object.in_world.as_ref().map(|old| Arc::new(of_triangles(old, triangles)));
    Object { mesh: Arc::new(mesh), paint, in_world, ..object.clone() }
}

/// The same with some of the triangles only.
fn of_triangles(old: &InWorld, triangles: &[u32]) -> InWorld {
    let kept = |light: &FoundLight| match light {
        FoundLight::Faces(old) => {
            FoundLight::Faces(triangles.iter().filter_map(|&k| old.get(k as usize).copied()).collect())
        }
        FoundLight::None | FoundLight::Vertices(_) => light.clone(),
    };
    let taken = old.taken.iter().map(|(light, taken)| (*light, kept(taken))).collect();
    InWorld { light: kept(&old.light), taken, ..old.clone() }
}

/// A surface without triangles that takes pieces of `old`. One colour becomes a colour for each face, so that surfaces
/// of different objects can be one.
pub(crate) fn empty_like(old: &Surface) -> Surface {
    let base = match &old.base {
        Base::Solid(_) | Base::Faces(_) => Base::Faces(Vec::new()),
        Base::Vertices(_) => Base::Vertices(Vec::new()),
        Base::Texture { image, sampler, tint, .. } => {
            Base::Texture { image: image.clone(), sampler: *sampler, uv: Vec::new(), tint: *tint, tints: Vec::new() }
        }
    };
    let light = match &old.light {
        SurfaceLight::InBase => SurfaceLight::InBase,
        SurfaceLight::Faces(_) => SurfaceLight::Faces(Vec::new()),
        SurfaceLight::Vertices(_) => SurfaceLight::Vertices(Vec::new()),
        SurfaceLight::PerPixel(light) => SurfaceLight::PerPixel(PixelLight {
            normals: Vec::new(),
            positions: Vec::new(),
            lighting: light.lighting.clone(),
        }),
    };
    let (positions, inverse_w, triangles) = (Vec::new(), Vec::new(), Vec::new());
    let shadows = old.shadows.iter().map(Shadow::bare).collect();
    Surface { positions, inverse_w, triangles, base, light, shadows, ..*old }
}

/// True if `last`, which was made by [`empty_like`] for another surface, can take pieces of `old` too.
pub(crate) fn can_append(last: &Surface, old: &Surface) -> bool {
    let alike = match (&last.base, &old.base) {
        (Base::Faces(_), Base::Faces(_) | Base::Solid(_)) | (Base::Vertices(_), Base::Vertices(_)) => true,
        (Base::Solid(_) | Base::Faces(_) | Base::Vertices(_) | Base::Texture { .. }, _) => false,
    };
    let lit_alike = matches!((&last.light, &old.light), (SurfaceLight::InBase, SurfaceLight::InBase));
    let interpolated_alike = last.inverse_w.is_empty() == old.inverse_w.is_empty();
    alike && lit_alike && interpolated_alike && last.translucent == old.translucent
}

/// Adds to `surface` the attributes in `old` of vertices of these origins, and the base colours of `faces` triangles
/// that are parts of the old triangle `source`. Missing attributes are grey, or zero.
pub(crate) fn append(surface: &mut Surface, old: &Surface, origins: &[VertexOrigin], source: u32, faces: usize) {
    fn add<T: Attribute>(values: &mut Vec<T>, origins: &[VertexOrigin], at: impl Fn(u32) -> T) {
        values.extend(origins.iter().map(|origin| origin.of(&at)));
    }
    fn at<T: Copy + Default>(values: &[T], index: u32) -> T {
        values.get(index as usize).copied().unwrap_or_default()
    }
    match (&mut surface.base, &old.base) {
        (Base::Faces(colors), Base::Solid(color)) => colors.extend(std::iter::repeat_n(*color, faces)),
        (Base::Faces(colors), Base::Faces(old)) => colors.extend(std::iter::repeat_n(color_at(old, source), faces)),
        (Base::Vertices(colors), Base::Vertices(old)) => add(colors, origins, |i| color_at(old, i)),
        (Base::Texture { uv, tints, .. }, Base::Texture { uv: old, tints: old_tints, .. }) => {
            add(uv, origins, |i| at(old, i));
            if !old_tints.is_empty() {
                add(tints, origins, |i| color_at(old_tints, i));
            }
        }
        // Made by `empty_like`, a base is of the kind of the old one, and has no one colour.
        (Base::Solid(_) | Base::Faces(_) | Base::Vertices(_) | Base::Texture { .. }, _) => {}
    }
    match (&mut surface.light, &old.light) {
        (SurfaceLight::Faces(shares), SurfaceLight::Faces(old)) => {
            shares.extend(std::iter::repeat_n(at(old, source), faces));
        }
        (SurfaceLight::Vertices(shares), SurfaceLight::Vertices(old)) => add(shares, origins, |i| at(old, i)),
        (SurfaceLight::PerPixel(light), SurfaceLight::PerPixel(old)) => {
            add(&mut light.normals, origins, |i| at(&old.normals, i));
            add(&mut light.positions, origins, |i| at(&old.positions, i));
        }
        // Made by `empty_like`, a light is of the kind of the old one.
        (SurfaceLight::InBase | SurfaceLight::Faces(_) | SurfaceLight::Vertices(_) | SurfaceLight::PerPixel(_), _) => {}
    }
    for (shadow, old) in surface.shadows.iter_mut().zip(&old.shadows) {
        add(&mut shadow.places, origins, |i| at(&old.places, i));
        shadow.planes.extend(std::iter::repeat_n(at(&old.planes, source), faces));
        match (&mut shadow.taken, &old.taken) {
            (BlockedLight::Faces(shares), BlockedLight::Faces(old)) => {
                shares.extend(std::iter::repeat_n(at(old, source), faces));
            }
            (BlockedLight::Vertices(shares), BlockedLight::Vertices(old)) => add(shares, origins, |i| at(old, i)),
            (BlockedLight::Faces(_) | BlockedLight::Vertices(_) | BlockedLight::Light(_), _) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::{Sampler, Texture};
    use crate::drawing::Lighting;

    const RED: Rgba = Rgba::rgb(255, 0, 0);
    const BLUE: Rgba = Rgba::rgb(0, 0, 255);

    /// Half way between the first two vertices.
    const MIDDLE: VertexOrigin = VertexOrigin::Between { of: [0, 1, 2], weights: [0.5, 0.5, 0.0] };

    fn surface(base: Base, light: SurfaceLight) -> Surface {
        Surface { base, light, ..Surface::solid(Vec::new(), Vec::new(), RED) }
    }

    fn taken(old: Base, origins: &[VertexOrigin]) -> Base {
        let old = surface(old, SurfaceLight::InBase);
        let mut new = empty_like(&old);
        append(&mut new, &old, origins, 1, 2);
        new.base
    }

    #[test]
    fn a_piece_has_the_attributes_of_its_face() {
        assert_eq!(taken(Base::Solid(RED), &[MIDDLE]), Base::Faces(vec![RED; 2]));
        assert_eq!(taken(Base::Faces(vec![RED, BLUE]), &[MIDDLE]), Base::Faces(vec![BLUE; 2]));
        let vertices = Base::Vertices(vec![RED, BLUE, RED]);
        assert_eq!(
            taken(vertices, &[MIDDLE, VertexOrigin::Vertex(1)]),
            Base::Vertices(vec![Rgba::rgb(128, 0, 128), BLUE])
        );
        let image = Arc::new(Texture::flat(1, 1, vec![0; 4]));
        let texture = |uv| Base::Texture {
            image: image.clone(),
            sampler: Sampler::PICTURE,
            uv,
            tint: Rgba::rgb(255, 255, 255),
            tints: Vec::new(),
        };
        assert_eq!(taken(texture(vec![[0.0, 0.0], [1.0, 0.5], [9.0, 9.0]]), &[MIDDLE]), texture(vec![[0.5, 0.25]]));
    }

    #[test]
    fn missing_attributes_are_grey_or_zero() {
        let grey = Rgba::rgb(128, 128, 128);
        let vertex = [VertexOrigin::Vertex(7)];
        assert_eq!(taken(Base::Faces(vec![RED]), &vertex), Base::Faces(vec![grey; 2]));
        assert_eq!(taken(Base::Vertices(vec![RED]), &vertex), Base::Vertices(vec![grey]));
        let light = |normals, positions| {
            SurfaceLight::PerPixel(PixelLight { normals, positions, lighting: Lighting::default() })
        };
        let old = surface(Base::Faces(vec![RED, BLUE]), light(Vec::new(), Vec::new()));
        let mut new = empty_like(&old);
        append(&mut new, &old, &vertex, 1, 1);
        assert_eq!(new, surface(Base::Faces(vec![BLUE]), light(vec![[0.0; 3]], vec![[0.0; 3]])));
    }

    #[test]
    fn faces_of_two_objects_are_one_surface_unless_pixels_are_lit() {
        let lit = SurfaceLight::PerPixel(PixelLight {
            normals: Vec::new(),
            positions: Vec::new(),
            lighting: Lighting::default(),
        });
        let [solid, vertices] = [Base::Solid(RED), Base::Vertices(Vec::new())];
        let of = |base: &Base, light: &SurfaceLight| surface(base.clone(), light.clone());
        let plain = of(&solid, &SurfaceLight::InBase);
        assert!(can_append(&empty_like(&plain), &plain));
        assert!(!can_append(&empty_like(&plain), &of(&vertices, &SurfaceLight::InBase)));
        assert!(!can_append(&empty_like(&plain), &of(&solid, &lit)));
        assert!(!can_append(&empty_like(&of(&solid, &lit)), &of(&solid, &lit)));
    }
}
