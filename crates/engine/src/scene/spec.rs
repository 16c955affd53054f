//! The `[scene]` section of a figure, before meshes are made: a preset, a tree of objects, lights.

use std::fmt;
use std::str::FromStr;

use glam::{DVec2, DVec3};

use super::Shadows;
use crate::appearance::{Filter, Rgba, Wrap};
use crate::limits::DEFAULT_SEGMENTS;

/// Makes `NAMED` and `name` from one list of names, patterns and values, in the order in which they are offered. If
/// a variant has data, the value is the one that has none yet.
macro_rules! named {
    ($type:ident { $($name:literal: $pattern:pat, $value:expr;)* }) => {
        impl $type {
            /// Each with its name in a figure file, in the order of a menu. If there are data, they are the ones that a
            /// file needn't give.
            pub const NAMED: &'static [(&'static str, Self)] = &[$(($name, $value)),*];

            /// Its name in a figure file.
            pub const fn name(&self) -> &'static str {
                match self {
                    $($pattern => $name,)*
                }
            }
        }
    };
}

crate::worded! {
    /// A named scene.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
    pub enum Preset {
        /// One of each primitive.
        #[default]
        Primitives = "primitives",
        /// A unit cube with coloured faces.
        Cube = "cube",
        /// A house without symmetry, so that mirror errors show.
        House = "house",
        /// Depth cues and a vanishing point.
        Corridor = "corridor",
        /// The pyramid of `[1]`, exercises I–III.
        Pyramid = "pyramid",
        /// The cube that is exactly the NDC volume, `[0]` exercise 5.3.
        NdcCube = "ndc-cube",
        /// `[0]` exercise 5.1.
        Exercise51 = "exercise-5.1",
        /// `[0]` exercise 5.2.
        Exercise52 = "exercise-5.2",
        /// `[0]` exercise 5.3.
        Exercise53 = "exercise-5.3",
        /// Nothing but what `objects` lists.
        Empty = "empty",
    }
    /// Its name in a figure file.
    pub fn name
}

impl fmt::Display for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A name that no preset has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no preset \"{0}\"")]
pub struct UnknownPreset(pub String);

impl FromStr for Preset {
    type Err = UnknownPreset;

    fn from_str(text: &str) -> Result<Self, UnknownPreset> {
        let found = Self::NAMED.iter().find(|(name, _)| *name == text);
        found.map(|(_, preset)| *preset).ok_or_else(|| UnknownPreset(text.to_owned()))
    }
}

/// A shape of `[[scene.objects]]`. Each has size about 2. Y is up. Box, sphere, ellipsoid and torus have their centre
/// at the origin. Prism, pyramid, cylinder and cone stand on it (y from 0 to 2). Sizes are changed by `scale`.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The cube \[−1, 1\]³.
    Box,
    /// A regular prism about y with `segments` sides (circumradius 1); without `segments`: 6.
    Prism,
    /// A pyramid on the square base \[−1, 1\]².
    Pyramid,
    /// The unit sphere.
    Sphere,
    /// An ellipsoid with half axes 1, ⅔, ½ along x, y, z.
    Ellipsoid,
    /// A cylinder about y.
    Cylinder,
    /// A cone about y.
    Cone,
    /// A torus about y.
    Torus,
    /// A grid of lines on the square \[−1, 1\]² of the plane y = 0, with `segments` cells a side; without
    /// `segments`: 10.
    Grid,
    /// Points.
    Points(Vec<DVec3>),
    /// Segments, end to end in pairs.
    Segments(Vec<[DVec3; 2]>),
    /// A file, relative to the figure file.
    Mesh {
        /// OBJ, glTF or GLB.
        path: String,
    },
}

named! { Shape {
    "box": Self::Box, Self::Box;
    "prism": Self::Prism, Self::Prism;
    "pyramid": Self::Pyramid, Self::Pyramid;
    "sphere": Self::Sphere, Self::Sphere;
    "ellipsoid": Self::Ellipsoid, Self::Ellipsoid;
    "cylinder": Self::Cylinder, Self::Cylinder;
    "cone": Self::Cone, Self::Cone;
    "torus": Self::Torus, Self::Torus;
    "grid": Self::Grid, Self::Grid;
    "points": Self::Points(_), Self::Points(Vec::new());
    "segments": Self::Segments(_), Self::Segments(Vec::new());
    "mesh": Self::Mesh { .. }, Self::Mesh { path: String::new() };
} }

/// The data of a shape in a figure besides its name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShapeData<'a> {
    /// Nothing.
    None,
    /// Its points or, for segments, both ends of each.
    Points(&'a [DVec3]),
    /// The file that it comes from.
    Path(&'a str),
}

impl Shape {
    /// The default of `segments`, for a shape or for a group.
    pub fn usual_segments(shape: Option<&Self>) -> u32 {
        shape.map_or(DEFAULT_SEGMENTS, Self::default_segments)
    }

    /// The default of `segments`: 6 sides of a prism, 10 cells of a grid, 32 segments of curved shapes.
    pub const fn default_segments(&self) -> u32 {
        match self {
            Self::Prism => 6,
            Self::Grid => 10,
            _ => DEFAULT_SEGMENTS,
        }
    }

    /// The data of the shape in a figure besides its name.
    pub fn data(&self) -> ShapeData<'_> {
        match self {
            Self::Points(points) => ShapeData::Points(points),
            Self::Segments(pairs) => ShapeData::Points(pairs.as_flattened()),
            Self::Mesh { path } => ShapeData::Path(path),
            _ => ShapeData::None,
        }
    }

    /// The file that it comes from, relative to the figure file.
    pub fn mesh_file(&self) -> Option<&str> {
        if let Self::Mesh { path } = self { Some(path) } else { None }
    }

    /// False if `segments` has no meaning.
    pub const fn has_segments(&self) -> bool {
        use Shape::{Cone, Cylinder, Ellipsoid, Grid, Prism, Sphere, Torus};
        matches!(self, Prism | Sphere | Ellipsoid | Cylinder | Cone | Torus | Grid)
    }
}

/// The source of the texture of an object, `texture` in a figure file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum TextureSource {
    /// None, even if the mesh file has one.
    None,
    /// Black and white squares, eight by eight.
    Chequer,
    /// A grid with a letter in each of its sixteen cells.
    Letters,
    /// u in red, v in green.
    Uv,
    /// A picture, relative to the figure file.
    File(String),
}

impl TextureSource {
    /// Those of the program, with their names in a figure file.
    pub const NAMED: [(&'static str, Self); 4] =
        [("none", Self::None), ("chequer", Self::Chequer), ("letters", Self::Letters), ("uv", Self::Uv)];

    /// The source with this name, or the file.
    pub fn of(text: &str) -> Self {
        let named = Self::NAMED.into_iter().find(|(name, _)| *name == text);
        named.map_or_else(|| Self::File(text.to_owned()), |(_, source)| source)
    }

    /// The file that it comes from, relative to the figure file.
    pub fn file(&self) -> Option<&str> {
        if let Self::File(path) = self { Some(path) } else { None }
    }
}

impl fmt::Display for TextureSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::File(path) => path,
            own => Self::NAMED.iter().find(|(_, source)| source == own).map_or("", |(name, _)| name),
        })
    }
}

/// One entry of `[[scene.objects]]`.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectSpec {
    /// Its name. Unique in the figure.
    pub name: String,
    /// Its shape. `None` means a group, which only has a transform.
    pub shape: Option<Shape>,
    /// The name of the object whose transform comes before its own.
    pub parent: Option<String>,
    /// Translation, scene units.
    pub translate: DVec3,
    /// Rotation in degrees about x, then y, then z.
    pub rotate: DVec3,
    /// Scale, along the object's own axes.
    pub scale: DVec3,
    /// Colour; `None` means the theme's.
    pub color: Option<Rgba>,
    /// A mesh shows its silhouette and its creases, as the program's own solids do.
    pub outline: bool,
    /// Segments of curved shapes, sides of a prism, cells of a grid; 3 … 512.
    pub segments: u32,
    /// Its texture; `None` means that of its mesh file, if it has one.
    pub texture: Option<TextureSource>,
    /// The continuation of the texture beyond its border; `None` means that of the mesh file, else it repeats.
    pub wrap: Option<Wrap>,
    /// The way from texels to a colour; `None` means that of the mesh file, else trilinear.
    pub filter: Option<Filter>,
    /// Repetitions of the texture along u and v. A negative number mirrors it.
    pub texture_scale: DVec2,
}

impl ObjectSpec {
    /// A shape at the origin, without parent or colour.
    pub fn new(name: impl Into<String>, shape: Shape) -> Self {
        let segments = shape.default_segments();
        Self { segments, shape: Some(shape), ..Self::group(name) }
    }

    /// A group: a transform for others, without a shape.
    pub fn group(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            shape: None,
            parent: None,
            translate: DVec3::ZERO,
            rotate: DVec3::ZERO,
            scale: DVec3::ONE,
            color: None,
            outline: false,
            segments: DEFAULT_SEGMENTS,
            texture: None,
            wrap: None,
            filter: None,
            texture_scale: DVec2::ONE,
        }
    }

    /// The same object with another parent.
    pub fn under(self, parent: impl Into<String>) -> Self {
        Self { parent: Some(parent.into()), ..self }
    }

    /// The same object at another place.
    pub fn at(self, x: f64, y: f64, z: f64) -> Self {
        Self { translate: DVec3::new(x, y, z), ..self }
    }

    /// The same object, turned by degrees about x, then y, then z.
    pub fn turned(self, x: f64, y: f64, z: f64) -> Self {
        Self { rotate: DVec3::new(x, y, z), ..self }
    }

    /// The same object, scaled along its own axes.
    pub fn scaled(self, x: f64, y: f64, z: f64) -> Self {
        Self { scale: DVec3::new(x, y, z), ..self }
    }

    /// The same object in another colour.
    pub fn colored(self, color: Rgba) -> Self {
        Self { color: Some(color), ..self }
    }

    /// The same object with another number of segments.
    pub fn with_segments(self, segments: u32) -> Self {
        Self { segments, ..self }
    }
}

/// A source of light, one entry of `[[scene.lights]]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The source of the light.
    pub kind: LightKind,
    /// The direction in which parallel light travels, of any length but 0, or the position of a lamp, in the world.
    pub vector: DVec3,
    /// Its shadow map, or none.
    pub shadows: Shadows,
}

/// The kind of a light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightKind {
    /// Parallel light.
    Directional,
    /// Light from a point.
    Point,
}

named! { LightKind {
    "directional": Self::Directional, Self::Directional;
    "point": Self::Point, Self::Point;
} }

impl LightKind {
    /// The key of a light's vector in a figure file, and the vector of one without.
    pub const fn vector(self) -> (&'static str, DVec3) {
        match self {
            Self::Directional => ("direction", DVec3::new(-1.0, -2.0, -1.0)),
            Self::Point => ("position", DVec3::new(0.0, 5.0, 0.0)),
        }
    }
}

impl Light {
    /// Parallel light that travels along this vector.
    pub const fn directional(direction: DVec3) -> Self {
        Self { kind: LightKind::Directional, vector: direction, shadows: Shadows::NONE }
    }

    /// A lamp at this point.
    pub const fn point(position: DVec3) -> Self {
        Self { kind: LightKind::Point, vector: position, shadows: Shadows::NONE }
    }

    /// The texels of its shadow maps.
    pub fn shadow_texels(&self) -> u64 {
        let maps = match self.kind {
            LightKind::Directional => 1,
            LightKind::Point => 6,
        };
        let side = u64::from(self.shadows.held().map);
        if self.shadows.cast { maps * side * side } else { 0 }
    }

    /// The same light with shadows.
    #[must_use]
    pub const fn with_shadows(self, shadows: Shadows) -> Self {
        Self { shadows, ..self }
    }
}

/// The `[scene]` section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneSpec {
    /// The preset; `objects` are added to it.
    pub preset: Preset,
    /// The tree, parents by name.
    pub objects: Vec<ObjectSpec>,
    /// Lights. Empty means the default light.
    pub lights: Vec<Light>,
}

/// The use of a file that a figure names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FileUse {
    /// A mesh, which may name further files: materials, buffers, textures.
    Mesh,
    /// A texture, or the photograph under the image.
    Image,
}

impl SceneSpec {
    /// Every name in the scene that leads to a file, with the use of the file. Some lead to files of the program.
    pub fn files(&self) -> impl Iterator<Item = (&str, FileUse)> {
        self.objects.iter().flat_map(|object| {
            let mesh = object.shape.as_ref().and_then(Shape::mesh_file).map(|path| (path, FileUse::Mesh));
            let texture = object.texture.as_ref().and_then(TextureSource::file).map(|path| (path, FileUse::Image));
            mesh.into_iter().chain(texture)
        })
    }

    /// The same names, to be replaced by others.
    pub fn files_mut(&mut self) -> impl Iterator<Item = &mut String> {
        self.objects.iter_mut().flat_map(|object| {
            let mesh = object.shape.as_mut().and_then(|shape| match shape {
                Shape::Mesh { path } => Some(path),
                _ => None,
            });
            let texture = object.texture.as_mut().and_then(|texture| match texture {
                TextureSource::File(path) => Some(path),
                _ => None,
            });
            mesh.into_iter().chain(texture)
        })
    }
}
