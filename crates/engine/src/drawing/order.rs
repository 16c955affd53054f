//! The rules by which depths are compared, the same for every output: the order in depth, and the tolerance within
//! which depths count as equal.

/// The greatest difference of two depths that count as the same. Depths have some 16 bits where perspective crowds
/// them.
#[inline]
pub fn same_depth(depth: f32) -> f32 {
    1e-4 * depth.abs() + 1e-6
}

/// The part of a face's slope that counts as on the face.
pub(crate) const ON_A_FACE: f32 = 0.02;

/// The distance by which a point may lie behind a face and still be on it. `slope` is the change of the face's depth
/// per pixel to the right and down.
///
/// Corners of faces lie on a grid of the pixel, but ends of strokes don't, and slopes stored for each pixel are
/// rounded.
#[inline]
pub fn on_a_face(depth: f32, slope: [f32; 2]) -> f32 {
    same_depth(depth) + ON_A_FACE * (slope[0].abs() + slope[1].abs())
}

/// The greatest difference of a stroke's depth between a point of its middle line and the place where another stroke
/// touches it there, also at an acute angle. `radius` is half its width in pixels, `rise` the change of its depth on
/// `length` pixels.
#[inline]
pub fn stroke_reach(radius: f32, rise: f32, length: f32) -> f32 {
    (3.0 * (radius + 0.5) * (rise / length.max(1e-6)).abs()).min(rise.abs())
}

/// A stroke at a place where it touches another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrokePoint {
    /// The depth of its middle line where that is nearest.
    pub depth: f32,
    /// The greatest difference of its depth around there.
    pub reach: f32,
    /// No face hides it.
    pub visible: bool,
    /// Its width in pixels.
    pub width: f32,
}

/// True if the later of two strokes is over the earlier one where they touch. The nearer one goes over the other. If
/// neither is nearer by more than their reach, a visible one goes over one behind a face, then the wider over the finer
/// one, then the later in the list.
#[inline]
pub fn later_is_over(later: StrokePoint, earlier: StrokePoint) -> bool {
    let nearer = later.depth - earlier.depth;
    let same = later.reach + earlier.reach + same_depth(later.depth);
    if nearer.abs() > same { nearer > 0.0 } else { (later.visible, later.width) >= (earlier.visible, earlier.width) }
}
