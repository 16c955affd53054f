//! The stages of the pipeline by name, for plans, files and windows, and the operations that each of them costs.

use std::ops::{Add, AddAssign, Mul};

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
    /// Take away light where the lamp sees something nearer.
    Shadow,
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
    pub const ALL: [Self; 19] = [
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
        Self::Shadow,
        Self::Blend,
        Self::Antialias,
        Self::Lines,
        Self::Write,
    ];

    /// Its name in data that programs read, what it works on, and the stage in whose loop it runs.
    const fn row(self) -> (&'static str, WorksOn, Option<Self>) {
        match self {
            Self::Traverse => ("traverse", WorksOn::Objects, None),
            Self::CullObjects => ("cull-objects", WorksOn::Objects, Some(Self::Traverse)),
            Self::Normals => ("normals", WorksOn::Normals, Some(Self::Light)),
            Self::Light => ("light", WorksOn::Colors, None),
            Self::Transform => ("transform", WorksOn::Vertices, None),
            Self::CullFaces => ("cull-faces", WorksOn::Faces, None),
            Self::Clip => ("clip", WorksOn::Pieces, None),
            Self::Oblique => ("oblique-window", WorksOn::Vertices, Some(Self::Transform)),
            Self::Divide => ("divide", WorksOn::Vertices, Some(Self::Transform)),
            Self::Viewport => ("viewport", WorksOn::Vertices, Some(Self::Transform)),
            Self::Fill => ("fill", WorksOn::Pixels, None),
            Self::Interpolate => ("interpolate", WorksOn::Pixels, Some(Self::Fill)),
            Self::HiddenSurfaces => ("hidden-surfaces", WorksOn::Pixels, Some(Self::Fill)),
            Self::Texture => ("texture", WorksOn::Pixels, Some(Self::Fill)),
            Self::Shadow => ("shadow", WorksOn::Pixels, Some(Self::Fill)),
            Self::Blend => ("blend", WorksOn::Pixels, Some(Self::Fill)),
            Self::Antialias => ("antialias", WorksOn::Pixels, Some(Self::Fill)),
            Self::Lines => ("lines", WorksOn::Pixels, None),
            Self::Write => ("write", WorksOn::Pixels, Some(Self::Fill)),
        }
    }

    /// The name in data that programs read.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.row().0
    }

    /// False where its operations are not counted: work on whole objects; lines, marks and texts.
    #[must_use]
    pub const fn is_counted(self) -> bool {
        !matches!(self, Self::Traverse | Self::CullObjects | Self::Lines)
    }

    /// True for a stage that works on pixels, the block of rasterization in `[3]` §1.2; else it belongs to geometry.
    #[must_use]
    pub const fn is_raster(self) -> bool {
        matches!(self.works_on(), WorksOn::Pixels)
    }

    /// The elements on which it works.
    #[must_use]
    pub const fn works_on(self) -> WorksOn {
        self.row().1
    }

    /// The stage in whose loop this one runs, so that it has no time of its own: working on a number while it is at
    /// hand costs less than a pass over all numbers for each stage.
    #[must_use]
    pub const fn timed_with(self) -> Option<Self> {
        self.row().2
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

/// Operations of arithmetic and accesses to memory, counted: vertices, faces and samples that were worked on, times the
/// operations of the formula that ran.
///
/// *Guarantees*: the count depends neither on the machine nor on its vectors or threads. What is done once for an
/// object or a picture (its matrices, its lamps), the arithmetic of loops and addresses, and choices between two
/// values are not in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions, subtractions, multiplications, divisions, roots and comparisons of floating-point numbers.
    pub float: u64,
    /// The same of whole numbers, their shifts, and bits that are masked or joined.
    pub integer: u64,
    /// Accesses: numbers (a coordinate, an index, a depth, a colour, a texel) read from the arrays of scene, picture
    /// and texture, or written to them.
    pub memory: u64,
}

impl Operations {
    /// None at all.
    pub const NONE: Self = Self::new(0, 0, 0);

    /// So many of each kind.
    #[must_use]
    pub const fn new(float: u64, integer: u64, memory: u64) -> Self {
        Self { float, integer, memory }
    }

    /// Both together.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self::new(self.float + other.float, self.integer + other.integer, self.memory + other.memory)
    }

    /// So many times.
    #[must_use]
    pub const fn times(self, n: u64) -> Self {
        Self::new(self.float * n, self.integer * n, self.memory * n)
    }
}

impl Add for Operations {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.and(other)
    }
}

impl AddAssign for Operations {
    fn add_assign(&mut self, other: Self) {
        *self = self.and(other);
    }
}

impl Mul<u64> for Operations {
    type Output = Self;

    fn mul(self, n: u64) -> Self {
        self.times(n)
    }
}

/// The operations of a picture by stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost([Operations; Stage::ALL.len()]);

impl Cost {
    /// Those of a stage.
    #[must_use]
    pub const fn of(&self, stage: Stage) -> Operations {
        self.0[stage as usize]
    }

    /// Those of all stages together.
    #[must_use]
    pub fn total(&self) -> Operations {
        self.0.iter().fold(Operations::NONE, |sum, operations| sum.and(*operations))
    }

    /// Adds work on `n` elements, each of which costs `each`.
    pub fn add(&mut self, stage: Stage, each: Operations, n: u64) {
        self.0[stage as usize] += each.times(n);
    }

    /// Gives the work of stages that did not run to those that did it along with their own: where a loop takes a vertex
    /// through several stages, it subtracts a shift of 0 and divides by a w of 1 sooner than asking.
    #[must_use]
    pub fn booked(mut self, ran: impl Fn(Stage) -> bool) -> Self {
        // From the back: a stage whose loop did not run either hands on what it was given.
        for stage in Stage::ALL.into_iter().rev().filter(|&stage| !ran(stage)) {
            let by = stage.timed_with().filter(|&by| ran(by)).unwrap_or(Stage::Transform);
            let work = std::mem::take(&mut self.0[stage as usize]);
            if ran(by) {
                self.0[by as usize] += work;
            }
        }
        self
    }
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        for (own, more) in self.0.iter_mut().zip(other.0) {
            *own += more;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_for_a_stage_that_did_not_run_is_booked_to_the_loop_that_did_it() {
        let one = Operations::new(1, 2, 3);
        let mut cost = Cost::default();
        for stage in [Stage::Transform, Stage::Oblique, Stage::Divide, Stage::CullFaces, Stage::HiddenSurfaces] {
            cost.add(stage, one, 10);
        }
        assert_eq!(cost.booked(|_| true), cost);
        let booked = cost.booked(|stage| matches!(stage, Stage::Transform | Stage::CullFaces));
        // Fill, in whose loop hidden surfaces are removed, did not run either.
        assert_eq!(booked.of(Stage::Transform), one * 40);
        assert_eq!(booked.of(Stage::CullFaces), one * 10);
        let left = [Stage::Oblique, Stage::Divide, Stage::HiddenSurfaces, Stage::Fill];
        assert!(left.iter().all(|&stage| booked.of(stage) == Operations::NONE));
        assert_eq!(Cost::default().booked(|_| false), Cost::default());
    }
}
