//! What the `[scene]` section of a figure says, before meshes are made: a preset, a tree of objects, lights.

use glam::DVec3;

use crate::appearance::Rgba;

/// A named scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Preset {
    /// Nothing but what `objects` lists.
    Empty,
    /// One of each primitive.
    #[default]
    Primitives,
    /// A unit cube with coloured faces.
    Cube,
    /// A house without symmetry, so that mirror errors show.
    House,
    /// Depth cues and a vanishing point.
    Corridor,
    /// The pyramid of `[1]`, exercises I–III.
    Pyramid,
    /// The cube that is exactly the NDC volume, `[0]` exercise 5.3.
    NdcCube,
    /// `[0]` exercise 5.1.
    Exercise51,
    /// `[0]` exercise 5.2.
    Exercise52,
    /// `[0]` exercise 5.3.
    Exercise53,
}

/// A shape of `[[scene.objects]]`. Each has size about 2 and its centre (box, sphere, torus …) or base centre at the origin;
/// y is up. Sizes are changed by `scale`.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The cube \[−1, 1\]³.
    Box,
    /// A regular prism about y.
    Prism,
    /// A pyramid on a square base.
    Pyramid,
    /// The unit sphere.
    Sphere,
    /// An ellipsoid with half axes 1, ⅔, ½.
    Ellipsoid,
    /// A cylinder about y.
    Cylinder,
    /// A cone about y.
    Cone,
    /// A torus about y.
    Torus,
    /// A grid of lines on the plane y = 0.
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

/// One entry of `[[scene.objects]]`.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectSpec {
    /// Its name; unique in the figure.
    pub name: String,
    /// Its shape; `None`: a group, there for its transform.
    pub shape: Option<Shape>,
    /// The name of the object whose transform comes before its own.
    pub parent: Option<String>,
    /// Translation, scene units.
    pub translate: DVec3,
    /// Rotation in degrees about x, then y, then z.
    pub rotate: DVec3,
    /// Scale, along the object's own axes.
    pub scale: DVec3,
    /// Colour; `None`: the theme's.
    pub color: Option<Rgba>,
    /// Segments of curved shapes, 3 … 512.
    pub segments: u32,
}

/// One entry of `[[scene.lights]]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightSpec {
    /// Parallel light that travels along this vector.
    Directional(DVec3),
    /// A lamp at this point.
    Point(DVec3),
}

/// The `[scene]` section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneSpec {
    /// The preset; `objects` are added to it.
    pub preset: Preset,
    /// The tree, parents by name.
    pub objects: Vec<ObjectSpec>,
    /// Lights; empty: the default light.
    pub lights: Vec<LightSpec>,
}
