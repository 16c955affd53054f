//! The operations of the stages on vertices and triangles: how many each formula has.
//!
//! How each number is counted stands beside it; [`Operations`] says what counts. The tests run the same formulas on
//! numbers that count: they get the same bits, and as many operations as stand here.

use super::faces::Faces;
use super::light::Lights;
use super::object_pass::ObjectPass;
use super::stages::LitAt;
use crate::lighting::{WITH_LIGHT, light_operations};
use crate::stage::{Cost, Operations, Stage};

/// `ViewFromObject::point`: p − C (3 differences), and a matrix of 3 × 3 (9 products, 6 sums). A point is read.
const VIEW: Operations = Operations::new(3 + 15, 0, 3);

/// The same through the world, where the eye cannot be taken to the space of the object: one matrix more, and a
/// translation.
const THROUGH_WORLD: Operations = Operations::new(15 + 3, 0, 0);

/// `Projector::clip`: the scale of x and that of y.
const CLIP_SPACE: Operations = Operations::new(2, 0, 0);

/// The shift of an oblique window: for x and y a product with w, and a difference.
const OBLIQUE: Operations = Operations::new(4, 0, 0);

/// `Screen::project`, the divide: 1/w, x/w and y/w as products.
const DIVIDE: Operations = Operations::new(3, 0, 0);

/// The depth in perspective: unit/w, and the product with it.
const DIVIDE_DEPTH: Operations = Operations::new(2, 0, 0);

/// `relative_inverse_w`: a division, a product, a comparison; it is written.
const INVERSE_W: Operations = Operations::new(3, 0, 1);

/// `Screen::project`, the rest: for x and y a product and a sum, for the depth 2 differences and a division, 6 comparisons
/// that hold them to the picture, and 2 sums that round x and 2 that round y to the grid. Three numbers are written.
const VIEWPORT: Operations = Operations::new(2 * 2 + 3 + 6 + 4, 0, 3);

/// `outcode`: six distances from the planes and their signs; the sum of three sizes and its test; a shift and a join for
/// each bit. It is written.
const OUTCODE: Operations = Operations::new(6 + 6 + 2 + 1, 6 * 2, 1);

/// The outcodes of three corners, joined and masked.
const OUTCODES: Operations = Operations::new(0, 6, 3);

/// `turned_here`: 4 differences, 2 products, 2 comparisons. Three indices, and x and y of three corners, are read.
const TURNED: Operations = Operations::new(8, 0, 3 + 6);

/// `judge`, on the image: 4 differences, 2 products, a difference, the sign and the side.
const JUDGED: Operations = Operations::new(4 + 3 + 3, 0, 3 + 6);

/// `facing`: three corners in view space, 2 differences of vectors, their cross product (6 products, 3 differences) and
/// a dot product.
const IN_WORLD: Operations = VIEW.times(3).and(Operations::new(6 + 9 + 5, 0, 0));

/// A triangle that is left is handed on: three indices read, and three written.
const KEPT: Operations = Operations::new(0, 0, 6);

/// A corner that comes to be clipped: to clip space once more, and its six distances.
const CORNER: Operations = VIEW.and(CLIP_SPACE).and(OBLIQUE).and(Operations::new(6, 0, 0));

/// A corner is held against a plane: not negative, not positive, and two tests whether its edge crosses.
const PLANE_TEST: Operations = Operations::new(4, 0, 0);

/// A new corner: the shares (a sum, 2 divisions), and twelve means (2 products, a sum): six distances, three coordinates,
/// three weights; four tests, two comparisons for each coordinate.
const CROSSING: Operations = Operations::new(3 + 12 * 3 + 4 + 6, 0, 0);

/// A normal in view space: a matrix of 3 × 3. It is read.
const NORMAL: Operations = Operations::new(15, 0, 3);

/// A normal for the light of pixels, of length 1: the square, 2 comparisons, a root, 3 divisions; it is written.
const UNIT_NORMAL: Operations = NORMAL.and(Operations::new(5 + 2 + 1 + 3, 0, 3));

/// The normal of a face: 2 differences of vectors, a cross product, its size and the factor (2 comparisons, 3 products),
/// and the matrix. Three indices and three corners are read.
const FACE_NORMAL: Operations = Operations::new(6 + 9 + 5 + 15, 0, 3 + 9);

/// The middle of a face: a sum, a division and a sum of vectors.
const CENTROID: Operations = Operations::new(9, 0, 0);

/// The place of a point for lamps and viewers that are not far away: p − C, the unit, and a matrix.
const PLACE: Operations = Operations::new(3 + 3 + 15, 0, 3);

/// The colour that is read and the one that is written, or the two parts of a light that are.
const COLORS: Operations = Operations::new(0, 0, 2);

/// Adds the work on the faces of one object. `lit`: the number of faces or vertices that were lit.
pub(super) fn of_faces(cost: &mut Cost, pass: &ObjectPass, faces: &Faces, lit: u64, lights: &Lights) {
    let (vertices, object) = (pass.vertices(), pass.object);
    let (n, cuts) = (vertices.len() as u64, faces.cuts.len() as u64);
    let through = if vertices.view_from_object.goes_through_world() { THROUGH_WORLD } else { Operations::NONE };

    cost.add(Stage::Transform, VIEW.and(through).and(CLIP_SPACE), n);
    cost.add(Stage::Oblique, OBLIQUE, n);
    of_points(cost, vertices.projector.perspective, n + cuts);
    let with_w = if faces.image.inverse_w.is_empty() { 0 } else { n + cuts };
    cost.add(Stage::Divide, INVERSE_W, with_w);

    let crosses = pass.plan.clip_planes != 0;
    let judged = faces.judged();
    let (together, alone) = (judged.together as u64, judged.alone as u64);
    cost.add(Stage::CullFaces, TURNED, together);
    cost.add(Stage::CullFaces, JUDGED, alone);
    cost.add(Stage::CullFaces, IN_WORLD.and(through.times(3)), judged.in_world as u64);
    cost.add(Stage::CullFaces, KEPT, faces.triangles.len() as u64);

    cost.add(Stage::Clip, OUTCODE, if crosses { n } else { 0 });
    let coded = if faces.image.outcodes.is_empty() { 0 } else { object.mesh.triangles.len() as u64 };
    cost.add(Stage::Clip, OUTCODES, coded);
    let work = faces.clipper.work;
    cost.add(Stage::Clip, CORNER.and(through), work.corners);
    cost.add(Stage::Clip, PLANE_TEST, work.tests);
    cost.add(Stage::Clip, CROSSING, work.crossings);

    let lighting = lights.lighting(pass.lights_both_sides(faces));
    let place = if lighting.needs_positions() { PLACE } else { Operations::NONE };
    // On a texture the light stays apart from the colour.
    let color = if pass.plan.textured { COLORS } else { WITH_LIGHT.and(COLORS) };
    let light = light_operations(&lighting).and(color);
    match pass.plan.lit {
        LitAt::Nowhere => {}
        LitAt::Faces => {
            let middle = if lighting.needs_positions() { CENTROID.and(PLACE) } else { Operations::NONE };
            cost.add(Stage::Light, FACE_NORMAL.and(middle).and(light), lit);
        }
        LitAt::Vertices => {
            cost.add(Stage::Normals, NORMAL, lit);
            cost.add(Stage::Light, place.and(light), lit);
        }
        LitAt::Pixels => cost.add(Stage::Normals, UNIT_NORMAL.and(place), n),
    }
}

/// Adds the divide and the viewport of `n` points.
fn of_points(cost: &mut Cost, perspective: bool, n: u64) {
    cost.add(Stage::Divide, DIVIDE.and(if perspective { DIVIDE_DEPTH } else { Operations::NONE }), n);
    cost.add(Stage::Viewport, VIEWPORT, n);
}

/// Adds the work on the ends of the edges of an object whose faces are not drawn.
pub(super) fn of_ends(cost: &mut Cost, perspective: bool, ends: u64) {
    cost.add(Stage::Transform, VIEW.and(CLIP_SPACE), ends);
    cost.add(Stage::Oblique, OBLIQUE, ends);
    of_points(cost, perspective, ends);
}
