//! The reason why a stage runs or is left out.

use crate::pipeline::space::PlaneSet;
use crate::stage::Stage;

/// The output of a drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Output {
    /// Pixels, with a depth for each: the style chooses the hidden-surface algorithm.
    #[default]
    Pixels,
    /// Shapes that are painted one over the other, without a depth buffer: faces are listed from back to front, split
    /// where they cross each other's planes, or by their centroids if the style asks for the painter.
    Vectors,
}

/// The reason why a stage runs or is left out. Counts are of objects unless they say otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Runs: every picture needs it.
    Always,
    /// Left out: nothing in the volume needs it.
    NothingInView,
    /// Runs: something is in view.
    SomethingInView,
    /// Runs: faces are in view.
    FacesInView {
        /// Those with any.
        objects: usize,
    },
    /// Runs: all stages were requested, needed or not.
    Forced,

    /// Runs: this number of objects are outside one plane of the volume, and dropped whole.
    Outside {
        /// Dropped.
        outside: usize,
        /// In the scene.
        of: usize,
    },
    /// Left out: no object lies outside.
    NoneOutside {
        /// In the scene.
        of: usize,
    },

    /// Left out: only edges are drawn.
    Wireframe,
    /// Left out: no object in view has faces.
    NoFaces,
    /// Left out: there is no light, so faces show their own colour.
    NoLight,
    /// Left out: no object in view takes light.
    Unlit {
        /// In view, with faces.
        objects: usize,
    },
    /// Left out: one light for each face needs no normals of vertices.
    FlatShading,
    /// Runs: one colour for each face.
    LitFaces {
        /// Those that take light.
        objects: usize,
    },
    /// Runs: one colour for each vertex.
    LitVertices {
        /// Those that take light.
        objects: usize,
    },
    /// Left to the pixels. Here only normals and positions are passed on.
    LitPixels {
        /// Those that take light.
        objects: usize,
    },
    /// Runs: one colour for each vertex of objects that have colours there. The light of others is left to the pixels.
    LitVerticesAndPixels {
        /// Those lit at their vertices.
        vertices: usize,
        /// Those lit at their pixels.
        pixels: usize,
    },

    /// Runs: on closed or one-sided objects, back faces can't be seen.
    BackFaces {
        /// Objects whose back faces are dropped.
        objects: usize,
        /// In view, with faces.
        of: usize,
    },
    /// Left out: both sides of all faces may be seen, because they are two-sided or translucent.
    BothSidesSeen {
        /// In view, with faces.
        objects: usize,
    },
    /// Nothing was dropped: the front plane cuts objects open, so that their inside may be seen, and others are
    /// two-sided or translucent.
    CutOpen {
        /// Those cut open.
        objects: usize,
        /// In view, with faces.
        of: usize,
    },
    /// Left out: all faces were dropped or clipped away before.
    NoFaceLeft,

    /// Left out: every object is entirely inside the volume.
    AllInside {
        /// In view.
        objects: usize,
    },
    /// Runs: this number of objects may cross these planes. Only these objects are cut, and only by these planes.
    Crossing {
        /// Those that may cross a plane.
        objects: usize,
        /// In view.
        of: usize,
        /// The planes that any of them may cross: bits left, right, bottom, top, near, far from the lowest.
        planes: PlaneSet,
    },

    /// Left out: l = −r and b = −t, so these terms are 0.
    SymmetricWindow,
    /// Runs: the axis doesn't go through the middle of the window.
    ObliqueWindow,
    /// Left out: w is 1 everywhere.
    ParallelProjection,
    /// Runs: w is the distance from the eye.
    PerspectiveProjection,

    /// Left out: every face has one colour.
    OneColorAFace,
    /// Runs: something varies over a face.
    VariesOverFaces {
        /// On which it does.
        objects: usize,
    },

    /// Left out: a convex closed object alone hides nothing of itself once its back faces are gone, and no line asks
    /// for depth.
    ConvexAlone,
    /// Runs: faces of several objects may hide each other.
    SeveralObjects {
        /// In view, with faces.
        objects: usize,
    },
    /// Runs: an object that isn't convex, or is open, may hide itself.
    HidesItself,
    /// Runs: the hidden parts of lines, marks or texts are drawn otherwise than the visible ones.
    LinesAskForDepth,
    /// Runs: faces are painted from back to front by their centroids.
    PaintedByCentroid,
    /// Runs: faces are painted from back to front, split where they cross each other's planes.
    PaintedBySplitting,
    /// Runs: the same, because the output has no depth buffer.
    NoDepthBuffer,
    /// A depth buffer decides, because splitting would have made more pieces than allowed.
    TooManyPieces {
        /// Those made until then.
        pieces: usize,
    },

    /// Left out: no object has a picture on it.
    NoTexture,
    /// Left out: each picture has one colour everywhere.
    TextureOfOneColor {
        /// With such a picture.
        objects: usize,
    },
    /// Runs.
    Textured {
        /// With a picture.
        objects: usize,
    },
    /// Left out: no light casts a shadow, or nothing is there to cast one.
    NoShadows,
    /// Left out: no object in view takes light, so none can be missing.
    NothingShadowed,
    /// Runs.
    Shadowed {
        /// On which shadows may fall.
        objects: usize,
    },
    /// Left out: nothing shows through anything.
    AllOpaque,
    /// Runs.
    Translucent {
        /// Those that are translucent.
        objects: usize,
    },
    /// Left out: one sample for each pixel.
    OneSample,
    /// Runs.
    Samples {
        /// For each pixel.
        samples: u8,
    },

    /// Left out: nothing but faces is in view.
    NoLines,
    /// Runs.
    LinesInView,

    /// The picture shows depths instead of colours: no light, no lines, and depths that vary over faces.
    DepthsShown,
    /// Runs, but too late: the divide by w was requested before it.
    DividedFirst,
}

/// The plan of one stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StagePlan {
    /// The stage that the plan runs or skips.
    pub stage: Stage,
    /// True if it runs.
    pub runs: bool,
    /// The reason why it does or doesn't run.
    pub reason: Reason,
}
