//! The stages of the pipeline by name, for plans, files and windows.

/// A stage of the pipeline, in the order of `[3]` §1.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stage {
    /// Walk through the scene.
    Traverse,
    /// Drop objects whose bounding box is outside the volume.
    CullObjects,
    /// Take vertex normals to view space.
    Normals,
    /// The reflection model: light on faces or vertices.
    Light,
    /// World → view, each vertex once.
    Transform,
    /// Drop faces that turn their back.
    CullFaces,
    /// Cut faces that cross a plane of the volume, before the divide.
    Clip,
    /// The terms of an oblique window.
    Oblique,
    /// The perspective divide.
    Divide,
    /// Ndc → pixels.
    Viewport,
    /// Find the pixels of each face.
    Fill,
    /// Colours, normals or texture coordinates between the vertices of a face.
    Interpolate,
    /// Remove hidden surfaces.
    HiddenSurfaces,
    /// Pictures on surfaces.
    Texture,
    /// Blend translucent colours with those behind them.
    Blend,
    /// Several samples for a pixel.
    Antialias,
    /// Edges, outlines, lines, marks and texts, over the finished surfaces.
    Lines,
    /// Colours go to the memory of the image.
    Write,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: [Self; 18] = [
        Self::Traverse,
        Self::CullObjects,
        Self::Normals,
        Self::Light,
        Self::Transform,
        Self::CullFaces,
        Self::Clip,
        Self::Oblique,
        Self::Divide,
        Self::Viewport,
        Self::Fill,
        Self::Interpolate,
        Self::HiddenSurfaces,
        Self::Texture,
        Self::Blend,
        Self::Antialias,
        Self::Lines,
        Self::Write,
    ];

    /// The name in data that programs read.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Traverse => "traverse",
            Self::CullObjects => "cull-objects",
            Self::Normals => "normals",
            Self::Light => "light",
            Self::Transform => "transform",
            Self::CullFaces => "cull-faces",
            Self::Clip => "clip",
            Self::Oblique => "oblique-window",
            Self::Divide => "divide",
            Self::Viewport => "viewport",
            Self::Fill => "fill",
            Self::Interpolate => "interpolate",
            Self::HiddenSurfaces => "hidden-surfaces",
            Self::Texture => "texture",
            Self::Blend => "blend",
            Self::Antialias => "antialias",
            Self::Lines => "lines",
            Self::Write => "write",
        }
    }

    /// The stage in whose loop this one runs, so that it has no time of its own: working on a number while it is at
    /// hand costs less than a pass over all numbers for each stage.
    #[must_use]
    pub fn timed_with(self) -> Option<Self> {
        match self {
            Self::CullObjects => Some(Self::Traverse),
            Self::Normals => Some(Self::Light),
            Self::Oblique | Self::Divide | Self::Viewport => Some(Self::Transform),
            Self::Interpolate | Self::HiddenSurfaces | Self::Texture | Self::Blend | Self::Antialias | Self::Write => {
                Some(Self::Fill)
            }
            Self::Traverse
            | Self::Light
            | Self::Transform
            | Self::CullFaces
            | Self::Clip
            | Self::Fill
            | Self::Lines => None,
        }
    }
}
