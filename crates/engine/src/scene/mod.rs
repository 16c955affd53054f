//! The scene: meshes in world space, lights, and the lines, marks and texts placed in the world.

mod build;
mod error;
pub mod import;
pub mod mesh;
mod named_point;
pub mod palette;
mod projective;
mod read_error;
mod shadows;
pub mod spec;
pub mod texture;

/// The tree of a figure's scene: presets, its edits, and its names and transforms resolved.
mod tree {
    pub mod edit;
    pub(crate) mod presets;
    pub(crate) mod resolve;
    pub mod transform;
}

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

use glam::{DMat4, DVec3};

use crate::appearance::{LightShare, LineStyle, MarkShape, Rgba, Role, Sampler, Texture};
use crate::geometry::Aabb;
pub use build::{build, build_with};
pub use error::{SceneError, chain_text};
pub use import::{GlbFault, GltfFault, JsonFault, MeshError, MeshFault, MeshFiles, MeshNotice};
pub use mesh::{Adjacency, Mesh, SharedEdge, primitives};
pub use named_point::ObjectPoint;
pub use read_error::{NamedBy, ReadError, ReadFile, ReadProblem, Wanted, is_loop, no_files, system_kind, system_words};
pub use shadows::Shadows;
pub use spec::{FileUse, Light, LightKind, ObjectSpec, Preset, SceneSpec, Shape, ShapeData, TextureSource};
pub use texture::{CornerUv, TextureError, TextureFault};
pub use tree::presets::{LostFeature, objects as preset_objects};
pub use tree::resolve::{DEFAULT_LIGHT, check};
pub use tree::{edit, transform};

/// A scene, flat: every transform has been multiplied out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Meshes.
    pub objects: Vec<Object>,
    /// Lights; without any, faces show their own colour.
    pub lights: Vec<Light>,
    /// Lines in the world.
    pub lines: Vec<Line>,
    /// The lines that belong to each grid, by the name of its object.
    pub grids: Vec<(String, Range<usize>)>,
    /// Point marks in the world.
    pub marks: Vec<PointMark>,
    /// Texts in the world.
    pub texts: Vec<Text>,
    /// The photograph under the image, if the figure has one and its file can be read.
    pub photograph: Option<Arc<Texture>>,
    /// Parts of mesh files that were left out, by the name of the object. None of them is drawn.
    pub notices: Vec<(String, MeshNotice)>,
}

impl Scene {
    /// The box around all objects, lines and marks. `None` for an empty scene.
    pub fn bounds(&self) -> Option<Aabb> {
        let objects = self.objects.iter().filter_map(Object::bounds);
        let lines = self.lines.iter().filter_map(|l| Aabb::around(l.points.iter().copied()));
        let marks = Aabb::around(self.marks.iter().map(|m| m.position));
        objects.chain(lines).chain(marks).reduce(Aabb::union)
    }

    /// The places in the world that framing objects of a scene is about: the middle of the objects with these names and
    /// of everything below them in the tree, and their vertices. Without names, of all objects. `None` if there are
    /// none.
    pub fn extent_of(&self, spec: &SceneSpec, names: &BTreeSet<String>) -> Option<(DVec3, Vec<DVec3>)> {
        let mut all = names.clone();
        all.extend(names.iter().flat_map(|name| edit::descendants(spec, name)));
        let is_meant = |object: &&Object| names.is_empty() || all.contains(object.owner());
        let objects: Vec<&Object> = self.objects.iter().filter(is_meant).collect();
        let placed = |object: &Object| {
            let matrix = object.world_from_object;
            object.mesh.positions.iter().map(move |&p| matrix.transform_point3(p)).collect::<Vec<_>>()
        };
        let points: Vec<DVec3> = objects.iter().flat_map(|object| placed(object)).collect();
        let middle = match objects[..] {
            // The box of a turned object has another middle in the world.
            [object] => object.world_from_object.transform_point3(object.mesh.bounds()?.center()),
            _ => Aabb::around(points.iter().copied())?.center(),
        };
        Some((middle, points))
    }

    /// The index of the object with this name. One of the figure comes before a part of another with the same name.
    pub fn place_of(&self, name: &str) -> Option<usize> {
        let own = |object: &Object| object.name == name && object.part_of.is_none();
        let any = || self.objects.iter().position(|object| object.name == name);
        self.objects.iter().position(own).or_else(any)
    }

    /// All vertices of all objects, in the world, for a probe to catch. A vertex that a crease doubles comes as often.
    pub fn vertices(&self) -> impl Iterator<Item = SceneVertex<'_>> {
        self.objects.iter().flat_map(|object| {
            object.mesh.positions.iter().enumerate().map(|(index, &p)| SceneVertex {
                object: &object.name,
                owner: object.owner(),
                index,
                p_world: object.world_from_object.transform_point3(p),
            })
        })
    }
}

/// A vertex of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneVertex<'a> {
    /// The object's name.
    pub object: &'a str,
    /// The name of the figure's object that it is, or is a part of.
    pub owner: &'a str,
    /// Its place in the mesh's `positions`.
    pub index: usize,
    /// The vertex in the world.
    pub p_world: DVec3,
}

/// A mesh at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// For messages, the scene tree and the probe.
    pub name: String,
    /// The figure's object whose mesh file it's a part of, if that has several. The name doesn't tell, because names
    /// may hold any character.
    pub part_of: Option<Arc<str>>,
    /// The shape, shared between copies.
    pub mesh: Arc<Mesh>,
    /// Model matrix. Finite, affine. It may mirror (determinant < 0). The mesh stays as it is, counter-clockwise seen
    /// from outside in its own space, and the pipeline turns the triangles round.
    pub world_from_object: DMat4,
    /// Colours of its faces.
    pub paint: ObjectPaint,
    /// False: faces show their colour as it is, whatever the lights.
    pub lit: bool,
    /// True: back faces are drawn too. Closed meshes are one-sided.
    pub two_sided: bool,
    /// False: the mesh has no faces in this picture (edges only).
    pub faces: bool,
    /// Style of its edges; `None` means not drawn (except in wireframe, which draws them in the object's colour).
    pub edges: Option<LineStyle>,
    /// Style of the silhouette and the creases of a curved solid, found by the [`adjacency`](Mesh::adjacency) of its
    /// mesh; `None`, and in wireframe: not drawn.
    pub outline: Option<LineStyle>,
    /// The object in the world, if this one is its image under a projection.
    pub in_world: Option<Arc<InWorld>>,
}

/// The object in the world that another one is the image of under a projection: the image in the canonical volume shows
/// the light and the shadows of the world.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InWorld {
    /// The light on it.
    pub light: FoundLight,
    /// 1/w of each vertex, in any unit, because an attribute that's affine in the world is affine here if divided by w.
    /// Empty without perspective: it is as it is.
    pub inverse_w: Vec<f32>,
    /// The vertices. Empty if no light casts shadows.
    pub positions: Vec<DVec3>,
    /// The part of the light that comes from each light which casts shadows, with its place among the lights.
    pub taken: Vec<(usize, FoundLight)>,
}

impl Object {
    /// True if both sides of its faces may be seen, and have to be lit. It's two-sided, or a solid whose inside shows
    /// because it's translucent or the front plane cuts it open (`is_cut_open`).
    pub fn shows_both_sides(&self, is_cut_open: bool) -> bool {
        self.two_sided || (self.mesh.closed && (is_cut_open || self.paint.is_translucent()))
    }

    /// A lit closed solid without lines.
    pub fn new(name: impl Into<String>, mesh: Arc<Mesh>, world_from_object: DMat4, paint: ObjectPaint) -> Self {
        Self {
            name: name.into(),
            part_of: None,
            mesh,
            world_from_object,
            paint,
            lit: true,
            two_sided: false,
            faces: true,
            edges: None,
            outline: None,
            in_world: None,
        }
    }

    /// The name of the object of the figure that it is, or is a part of.
    pub fn owner(&self) -> &str {
        self.part_of.as_deref().unwrap_or(&self.name)
    }

    /// The box around the object in the world (around its vertices, not around its turned box); `None` without
    /// vertices.
    pub fn bounds(&self) -> Option<Aabb> {
        Aabb::around(self.mesh.positions.iter().map(|&p| self.world_from_object.transform_point3(p)))
    }
}

/// The colours of an object.
#[derive(Clone, Debug, PartialEq)]
pub enum ObjectPaint {
    /// One colour. Its alpha is the object's opacity.
    Solid(Rgba),
    /// One colour for each triangle of the mesh.
    Faces(Arc<Vec<Rgba>>),
    /// One colour for each vertex of the mesh.
    Vertices(Arc<Vec<Rgba>>),
    /// A picture by texture coordinates.
    Texture(Pictured),
}

/// A picture on an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Pictured {
    /// Its texels, shared by all objects that use it.
    pub image: Arc<Texture>,
    /// How it's sampled.
    pub sampler: Sampler,
    /// One for each vertex of the mesh: (0, 0) at the top left of the picture, (1, 1) at its bottom right.
    pub uv: Arc<Vec<[f32; 2]>>,
    /// Multiplies the colours of the picture. White leaves them as they are. Its alpha is the opacity.
    pub tint: Rgba,
    /// The tint at each vertex in its place. Empty means the same everywhere.
    pub tints: Arc<Vec<Rgba>>,
    /// Something shows through it.
    pub translucent: bool,
}

impl Pictured {
    /// The one opaque colour that it has everywhere. `None` if it has several, or something shows through.
    pub fn one_color(&self) -> Option<Rgba> {
        let is_plain = !self.translucent && self.sampler.reveal.is_none() && self.tints.is_empty();
        is_plain.then(|| self.image.one_color_times(self.tint)).flatten()
    }

    /// A picture that is shown once, as it is.
    pub fn plain(image: Arc<Texture>, uv: Vec<[f32; 2]>, opacity: u8) -> Self {
        Self {
            image,
            sampler: Sampler::PICTURE,
            uv: Arc::new(uv),
            tint: Rgba::rgba(255, 255, 255, opacity),
            tints: Arc::default(),
            translucent: opacity < 255,
        }
    }
}

/// Light that has been found before a picture is made.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum FoundLight {
    /// None. The lights of the scene fall on it, if it takes light.
    #[default]
    None,
    /// At each triangle.
    Faces(Vec<LightShare>),
    /// At each vertex.
    Vertices(Vec<LightShare>),
}

impl ObjectPaint {
    /// True if something shows through.
    pub fn is_translucent(&self) -> bool {
        match self {
            Self::Solid(color) => !color.is_opaque(),
            Self::Faces(colors) | Self::Vertices(colors) => colors.iter().any(|c| !c.is_opaque()),
            Self::Texture(pictured) => pictured.translucent,
        }
    }
}

/// A polyline in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// World points.
    pub points: Vec<DVec3>,
    /// Colour, width in pixels, and dashes.
    pub style: LineStyle,
    /// Its part in the picture.
    pub role: Role,
}

impl Line {
    /// A line of the scene, or about it.
    pub fn new(points: Vec<DVec3>, style: LineStyle) -> Self {
        Self { points, style, role: Role::Content }
    }
}

/// A point mark in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct PointMark {
    /// World.
    pub position: DVec3,
    /// Its shape.
    pub shape: MarkShape,
    /// Half its width in pixels at scale 1.
    pub radius: f32,
    /// sRGB, with opacity.
    pub color: Rgba,
    /// Faint behind a face, else always fully drawn.
    pub fade_if_hidden: bool,
}

/// A text in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The name by which an author changes it. It's the same in every language, even if the text says another number.
    pub name: String,
    /// World.
    pub position: DVec3,
    /// The text, with `_` for subscripts as in the labels of a drawing.
    pub text: String,
    /// Moves it on the picture, in pixels at scale 1 (x right, y down).
    pub offset: [f32; 2],
    /// Height of the type in pixels at scale 1.
    pub size: f32,
    /// Colour of the letters.
    pub color: Rgba,
    /// Faint if a face hides its point, else always fully drawn.
    pub fade_if_hidden: bool,
    /// Its part in the picture.
    pub role: Role,
}

/// Half the width of a point's mark, in pixels at scale 1.
const MARK_RADIUS: f32 = 4.0;
/// Height of a point's name, in pixels at scale 1.
const NAME_SIZE: f32 = 14.0;

/// The mark of a point.
pub(super) fn point_mark(position: DVec3, shape: MarkShape, color: Rgba) -> PointMark {
    PointMark { position, shape, radius: MARK_RADIUS, color, fade_if_hidden: true }
}

/// The name of an object that is a point, as you type it.
pub(super) fn object_name(position: DVec3, name: &str, color: Rgba) -> Text {
    Text { text: crate::text::literal(name), ..point_name(position, name, color) }
}

/// The name beside a point, with subscripts.
pub(super) fn point_name(position: DVec3, text: &str, color: Rgba) -> Text {
    Text {
        name: text.to_owned(),
        position,
        text: text.to_owned(),
        offset: [8.0, -8.0],
        size: NAME_SIZE,
        color,
        fade_if_hidden: true,
        role: Role::Content,
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;
    use crate::appearance::Style;

    #[test]
    fn an_object_comes_before_a_part_of_another_that_is_called_alike() {
        let spec = SceneSpec {
            preset: Preset::Empty,
            objects: vec![ObjectSpec::new("engine/block", Shape::Box)],
            ..SceneSpec::default()
        };
        let mut scene = build(&spec, &Style::default(), &mut no_files).unwrap();
        let own = scene.objects[0].clone();
        scene.objects.insert(0, Object { part_of: Some("engine".into()), ..own.clone() });
        scene.objects.insert(0, Object { name: "engine/wheel".to_owned(), part_of: Some("engine".into()), ..own });
        assert_eq!(scene.place_of("engine/block"), Some(2));
        assert_eq!(scene.place_of("engine/wheel"), Some(0));
        assert_eq!((scene.place_of("engine"), scene.objects[0].owner()), (None, "engine"));
    }
}
