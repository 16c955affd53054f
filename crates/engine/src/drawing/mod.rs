//! The display list: the contents of a picture, in pixels with depth. Outputs know nothing else.
//!
//! Pixels: (0, 0) is the top-left corner of the top-left pixel, x to the right, y down; the centre of pixel (i, j) is
//! (i + ½, j + ½). Depth: **1 at the front plane, 0 at the back plane** (reversed, so that `f32` keeps its resolution
//! where perspective crowds the depths), affine in the picture's plane; the greater depth is nearer. If the volume
//! is much deeper than the part of it in view, the depths are those of the part in view, and may be greater than 1. The
//! frame defines their meaning.
//!
//! Order, the same for every output, unless [`Drawing::painted_in_order`]: opaque surfaces (the nearest wins; of equal
//! depths the first listed stays), then translucent surfaces from back to front (hidden by nearer opaque ones),
//! then strokes, then areas in the order of the list (over all strokes, whatever their depths), then marks, then
//! labels.
//!
//! Strokes: their parts behind opaque faces are drawn as [`HiddenLines`](crate::appearance::HiddenLines) says, those
//! behind a tint ([`Surface::tints`]) with a third of their opacity; a stroke on a face counts as visible. Strokes hide
//! strokes as faces hide faces: where two cross, the nearer one is painted over the other, whatever their order in the
//! list. Where they touch, so that neither is nearer by more than the span of their own width, a visible part goes over
//! a hidden one, then the wider stroke over the finer one (an edge over a grid line that runs up to it), then the later
//! one over the earlier. Strokes whose hidden parts are [`Shown`](crate::appearance::HiddenLines::Shown) take no part
//! in this. They are painted over all others, one over the other. [`order`] implements these rules for numbers.

pub mod order;
mod shadow;
mod surface;

use std::ops::Range;

use crate::appearance::{DepthFormat, FaceOrder, LineStyle, MarkShape, Rgba, Role, Samples};
pub use shadow::{BlockedLight, Rays, Shadow, ShadowMap};
pub use surface::{Base, Lighting, PixelLight, Surface, SurfaceLight, ViewLight};

/// A picture, ready for an output.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The colour under everything.
    pub background: Rgba,
    /// Samples per pixel for surfaces: 1, 4 or 16. Strokes and labels are always smooth.
    pub antialias: Samples,
    /// The surfaces are listed from back to front. Each triangle, opaque or translucent, is painted over those before
    /// it, whatever their depths. The last opaque one painted still leaves its depth, for strokes and labels.
    pub painted_in_order: bool,
    /// The format in which the depths of surfaces are stored and compared.
    pub depth_format: DepthFormat,
    /// Corners of faces lie on a finer grid than 1/256 of a pixel.
    pub fine_grid: bool,
    /// The order in which opaque surfaces are painted, for the cost alone. See [`face_order`](Self::face_order).
    pub order: FaceOrder,
    /// Faces.
    pub surfaces: Vec<Surface>,
    /// Lines.
    pub strokes: Vec<StrokeSet>,
    /// Filled areas in front of the picture: the plate of a legend, samples of colours.
    pub areas: Vec<Area>,
    /// Point marks.
    pub marks: Vec<Mark>,
    /// Texts.
    pub labels: Vec<Label>,
}

impl Drawing {
    /// A ground with nothing on it, with one sample per pixel.
    pub fn new(width: u32, height: u32, background: Rgba) -> Self {
        Self {
            width,
            height,
            background,
            antialias: Samples::One,
            painted_in_order: false,
            depth_format: DepthFormat::default(),
            fine_grid: false,
            order: FaceOrder::default(),
            surfaces: Vec::new(),
            strokes: Vec::new(),
            areas: Vec::new(),
            marks: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// The order of opaque triangles. They're as listed without a depth buffer, and also if one without a depth test
    /// lies over others. Of equal depths, the first in the list stays in every order.
    pub fn face_order(&self) -> FaceOrder {
        let is_tested = self.surfaces.iter().filter(|surface| !surface.translucent).map(|surface| surface.depth_test);
        if self.painted_in_order || !is_tested.is_sorted() { FaceOrder::AsListed } else { self.order }
    }
}

/// A set of polylines that look the same and play the same part.
#[derive(Clone, Debug, PartialEq)]
pub struct StrokeSet {
    /// x, y in pixels and depth.
    pub points: Vec<[f32; 3]>,
    /// Each polyline: a range of `points`. The arrow head, if the style has one, is at the last point of each.
    pub polylines: Vec<Range<u32>>,
    /// Their look. The width is in pixels of this drawing (already scaled).
    pub style: LineStyle,
    /// Their part in the picture.
    pub role: Role,
}

impl StrokeSet {
    /// One polyline.
    pub fn line(points: Vec<[f32; 3]>, style: LineStyle) -> Self {
        let end = u32::try_from(points.len()).unwrap_or(u32::MAX);
        Self { points, polylines: std::iter::once(0..end).collect(), style, role: Role::Content }
    }

    /// Segments.
    pub fn pairs(ends: &[[[f32; 3]; 2]], style: LineStyle) -> Self {
        let polylines = (0..).step_by(2).map(|first| first..first + 2).take(ends.len()).collect();
        Self { points: ends.as_flattened().to_vec(), polylines, style, role: Role::Content }
    }
}

/// A filled rectangle, which may have round corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Its upper left corner, x and y in pixels.
    pub corner: [f32; 2],
    /// Width and height in pixels.
    pub size: [f32; 2],
    /// The radius of its corners in pixels, at most half of the shorter side.
    pub radius: f32,
    /// sRGB, with opacity.
    pub fill: Rgba,
}

/// A point mark.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// x, y in pixels and depth.
    pub position: [f32; 3],
    /// Its shape.
    pub shape: MarkShape,
    /// Half its width in pixels.
    pub radius: f32,
    /// sRGB, with opacity.
    pub color: Rgba,
    /// Colour of a thin outline, so that it shows on any ground.
    pub outline: Rgba,
    /// Drawn faintly (true) or fully (false) behind a face.
    pub fade_if_hidden: bool,
}

impl Mark {
    /// A mark that never fades.
    pub fn new(position: [f32; 3], shape: MarkShape, radius: f32, [color, outline]: [Rgba; 2]) -> Self {
        Self { position, shape, radius, color, outline, fade_if_hidden: false }
    }
}

/// The position of a text relative to its point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Anchor {
    /// The point is at the left end of the text.
    #[default]
    Left,
    /// The point is at the middle of the text.
    Center,
    /// The point is at the right end of the text.
    Right,
}

/// A text. `_c` in the text lowers one character, `_{prp}` several (subscripts).
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The name by which an author changes it. It's the same in every language, even if the text says another number.
    pub name: String,
    /// x, y in pixels (before `offset`) and depth.
    pub position: [f32; 3],
    /// Moves the text, in pixels.
    pub offset: [f32; 2],
    /// Letters on one line. `_` and `{}` lower the following letters.
    pub text: String,
    /// Set in the letters of mathematics, if these have them.
    pub mathematical: bool,
    /// Height of the type in pixels.
    pub size: f32,
    /// Colour of the letters.
    pub color: Rgba,
    /// Colour of the halo that keeps the letters legible on any ground.
    pub halo: Rgba,
    /// Horizontal place. Vertically the middle of the x-height is at the point.
    pub anchor: Anchor,
    /// Drawn faintly (true) or fully (false) if a face hides its point.
    pub fade_if_hidden: bool,
    /// Its part in the picture.
    pub role: Role,
}

impl Label {
    /// A text to the right of a point, which authors can't change. It has no name.
    pub fn new(position: [f32; 3], text: impl Into<String>, size: f32, [color, halo]: [Rgba; 2]) -> Self {
        Self {
            name: String::new(),
            position,
            offset: [0.0; 2],
            text: text.into(),
            mathematical: false,
            size,
            color,
            halo,
            anchor: Anchor::Left,
            fade_if_hidden: false,
            role: Role::Content,
        }
    }
}

/// To the precision of the display list, behind the viewport, and of light.
#[expect(clippy::cast_possible_truncation, reason = "single precision is the display list's")]
#[inline(always)]
pub fn single(v: f64) -> f32 {
    v as f32
}
