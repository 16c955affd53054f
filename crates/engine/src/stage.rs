//! The stages of the pipeline by name, for plans, files and windows, and the operations that each of them costs.

crate::listed! {
    /// A stage of the pipeline. The order is that of `[3]` §1.1, with our own stages between its steps.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Stage {
        /// Walk through the scene.
        Traverse = "traverse",
        /// Drop objects whose bounding box is outside the volume.
        CullObjects = "cull-objects",
        /// Take vertex normals to view space.
        Normals = "normals",
        /// The reflection model: light on faces or vertices.
        Light = "light",
        /// Object → world → view, each vertex once.
        Transform = "transform",
        /// Drop faces that turn their back.
        CullFaces = "cull-faces",
        /// Cut faces that cross a plane of the volume, before the divide.
        Clip = "clip",
        /// The terms of an oblique window.
        Oblique = "oblique-window",
        /// The perspective divide.
        Divide = "divide",
        /// NDC → pixels.
        Viewport = "viewport",
        /// Find the pixels of each face.
        Fill = "fill",
        /// Colours, normals or texture coordinates between the vertices of a face.
        Interpolate = "interpolate",
        /// Remove hidden surfaces.
        HiddenSurfaces = "hidden-surfaces",
        /// Pictures on surfaces.
        Texture = "texture",
        /// Take away light where the lamp sees something nearer.
        Shadow = "shadow",
        /// Blend translucent colours with those behind them.
        Blend = "blend",
        /// Several samples for a pixel.
        Antialias = "antialias",
        /// Edges, outlines, lines, marks and texts, over the finished surfaces.
        Lines = "lines",
        /// Colours go to the memory of the image.
        Write = "write",
    }
    /// The name in data that programs read.
    pub fn name
}

impl Stage {
    /// The elements on which it works, and the stage in whose loop it runs.
    const fn row(self) -> (WorksOn, Option<Self>) {
        match self {
            Self::Traverse => (WorksOn::Objects, None),
            Self::CullObjects => (WorksOn::Objects, Some(Self::Traverse)),
            Self::Normals => (WorksOn::Normals, Some(Self::Light)),
            Self::Light => (WorksOn::Colors, None),
            Self::Transform => (WorksOn::Vertices, None),
            Self::CullFaces => (WorksOn::Faces, None),
            Self::Clip => (WorksOn::Pieces, None),
            Self::Oblique => (WorksOn::Vertices, Some(Self::Transform)),
            Self::Divide => (WorksOn::Vertices, Some(Self::Transform)),
            Self::Viewport => (WorksOn::Vertices, Some(Self::Transform)),
            Self::Fill => (WorksOn::Pixels, None),
            Self::Interpolate => (WorksOn::Pixels, Some(Self::Fill)),
            Self::HiddenSurfaces => (WorksOn::Pixels, Some(Self::Fill)),
            Self::Texture => (WorksOn::Pixels, Some(Self::Fill)),
            Self::Shadow => (WorksOn::Pixels, Some(Self::Fill)),
            Self::Blend => (WorksOn::Pixels, Some(Self::Fill)),
            Self::Antialias => (WorksOn::Pixels, Some(Self::Fill)),
            Self::Lines => (WorksOn::Pixels, None),
            Self::Write => (WorksOn::Pixels, Some(Self::Fill)),
        }
    }

    /// The file that shows how it works, from the root of the project. It has a function of the stage's name.
    ///
    /// A stage of geometry has the code that pictures use. A stage of the rasterizer has the textbook's, and the fast
    /// path gives the same bytes. Without a depth buffer, see `crates/engine/src/pipeline/stage/hidden_surfaces.rs`.
    pub fn source(self) -> String {
        let file = match self {
            Self::Transform | Self::Oblique | Self::Divide | Self::Viewport => "vertex".to_owned(),
            Self::Lines => "lines".to_owned(),
            _ if self.is_raster() => return "crates/engine/src/raster/textbook.rs".to_owned(),
            _ => self.name().replace('-', "_"),
        };
        format!("crates/engine/src/pipeline/stage/{file}.rs")
    }

    /// False if its operations aren't counted, as for work on whole objects and for lines, marks and texts.
    pub const fn is_counted(self) -> bool {
        !matches!(self, Self::Traverse | Self::CullObjects | Self::Lines)
    }

    /// True for a stage that works on pixels, the block of rasterization in `[3]` §1.2, else it belongs to geometry.
    pub const fn is_raster(self) -> bool {
        matches!(self.works_on(), WorksOn::Pixels)
    }

    /// The elements on which it works.
    pub const fn works_on(self) -> WorksOn {
        self.row().0
    }

    /// The stage in whose loop this one runs. It then has no time of its own. One loop for several stages costs less
    /// than a pass over the array for each of them.
    #[must_use]
    pub const fn timed_with(self) -> Option<Self> {
        self.row().1
    }
}

/// The elements on which a stage works, and by which it shows in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorksOn {
    /// Objects by their boxes.
    Objects,
    /// Vertices.
    Vertices,
    /// The normals of vertices.
    Normals,
    /// Triangles, whole.
    Faces,
    /// Triangles, which it cuts.
    Pieces,
    /// The colours of faces or vertices.
    Colors,
    /// Pixels.
    Pixels,
}

/// Operations of arithmetic and accesses to memory: those of the textbook's algorithm for one element, times the number
/// of elements that a stage had.
///
/// *Guarantees*: neither the machine nor its vectors or threads change them. Work done once for an object or a picture
/// (its matrices, its lamps), the arithmetic of loops and addresses, and choices between two values aren't in them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions, subtractions, multiplications, divisions, roots and comparisons of floating-point numbers.
    pub float: u64,
    /// The same for whole numbers.
    pub integer: u64,
    /// Accesses: numbers (a coordinate, an index, a depth, a colour, a texel) read from the arrays of scene, picture
    /// and texture, or written to them.
    pub memory: u64,
}

impl Operations {
    /// None at all.
    pub const NONE: Self = Self::new(0, 0, 0);

    /// This number of each kind.
    pub const fn new(float: u64, integer: u64, memory: u64) -> Self {
        Self { float, integer, memory }
    }

    /// The sum of both.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self::new(self.float + other.float, self.integer + other.integer, self.memory + other.memory)
    }

    /// Multiplied by a number.
    #[must_use]
    pub const fn times(self, n: u64) -> Self {
        Self::new(self.float * n, self.integer * n, self.memory * n)
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// The function that a stage's file has to have.
    fn function(stage: Stage) -> String {
        match stage {
            Stage::Oblique => "oblique".to_owned(),
            _ => stage.name().replace('-', "_"),
        }
    }

    #[test]
    fn the_source_of_a_stage_has_a_function_of_its_name() {
        for stage in Stage::ALL {
            let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../").to_owned() + &stage.source();
            let text = std::fs::read_to_string(&file).unwrap();
            let name = function(stage);
            let is_there = [format!("fn {name}("), format!("fn {name}<")].iter().any(|start| text.contains(start));
            assert!(is_there, "{file} has no function {name}");
        }
    }
}
