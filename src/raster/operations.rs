//! The operations of filling and colouring: how many each formula has, for a triangle, a sample, a pixel.
//!
//! How each number is counted stands beside it; [`Operations`] says what counts. A product or a sum that a row or a
//! column of a tile has in common is left out: it is a small part of one for each sample.

use crate::appearance::{Filter, Sampler, Texture, TextureReveal};
use crate::drawing::{Base, Drawing, Rays, ShadowMap, Surface, SurfaceLight, TakenLight};
use crate::lighting::{WITH_LIGHT, light_operations};
use crate::stage::{Cost, Operations, Stage};

/// Numbers of elements of one surface that were worked on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Tally {
    /// Triangles that were set up eight at a time, and on their own.
    pub(super) triangles: u64,
    pub(super) alone: u64,
    /// Samples whose edge functions were asked.
    pub(super) edge_tests: u64,
    /// Rows between borders, and the samples in them that were held against these.
    pub(super) rows: u64,
    pub(super) border_tests: u64,
    /// Samples inside of triangles, and those of them that nothing nearer has hidden.
    pub(super) covered: u64,
    pub(super) written: u64,
    /// Pixels that were given a colour without a division by 1/w, and with one.
    pub(super) colored: u64,
    pub(super) divided: u64,
    /// Pixels whose colour comes from two levels of a texture.
    pub(super) two_levels: u64,
}

/// The treatment of the depths of a surface's samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Depths {
    /// Held against those that are there.
    pub(super) tested: bool,
    /// Put in their place.
    pub(super) kept: bool,
    /// Rounded to a format.
    pub(super) stored: bool,
    /// Those of several samples in a pixel.
    pub(super) stepped: bool,
}

/// `Batch::new`: six coordinates on the grid (a product and a sum each; 2 tests, a mask and a subtraction of their
/// bits), four sides of the box (2 comparisons and a subtraction; to whole pixels a sum, a shift, a comparison), and 24
/// comparisons that grade it. Three indices and six coordinates are read.
const BOX: Operations = Operations::new(6 * 2, 6 * 4 + 4 * 6 + 24, 3 + 6);

/// `Batch::set_up`: twice the area (4 differences, 2 products, a difference) and its sign; the first centre (2 shifts,
/// 2 sums); three edge functions (2 differences, 4 tests of who owns the edge, at the first centre 2 differences, 2
/// products, 2 sums); 4 differences; the reciprocal of the area, the 4 terms of a gradient, 2 coordinates of the
/// origin.
const SET_UP: Operations = Operations::new(1 + 4 + 2, 7 + 1 + 4 + 3 * 12 + 4, 0);

/// `Triangle::new` and `Borders::new`: six coordinates on the grid, the area (2 products, a difference, a comparison),
/// its reciprocal and 4 products; for three edges a reciprocal, a sum and 2 products, in whole numbers 10 for the
/// constant of the line; 4 comparisons for the rows.
const ALONE: Operations = Operations::new(6 * 2 + 4 + 5 + 3 * 4, 6 * 2 + 4 + 3 * 10 + 4, 6);

/// `planes`: 2 differences, 4 products and 2 differences for the gradient, 4 comparisons for the range.
const PLANE: Operations = Operations::new(2 + 6 + 4, 0, 3);

/// An edge-function test: 3 sums to get there, 2 joins of signs, a comparison.
const EDGE_TEST: Operations = Operations::new(0, 6, 0);

/// `Borders::rows`: four lines (a product and a sum), 8 comparisons, 2 sums that round.
const ROW: Operations = Operations::new(4 * 2 + 8 + 2, 0, 0);

/// A pixel between the borders of its row: the next column, and a comparison.
const BORDER_TEST: Operations = Operations::new(0, 2, 0);

/// Depth at a sample: a product and a sum, and 2 comparisons that hold it to the range of the vertices.
const DEPTH: Operations = Operations::new(4, 0, 0);

/// The step from the centre to the sample.
const DEPTH_STEP: Operations = Operations::new(1, 0, 0);

/// `stored`: to steps, a comparison, a sum and a difference that round, and back.
const DEPTH_FORMAT: Operations = Operations::new(5, 0, 0);

/// A comparison with the depth that is read.
const DEPTH_TEST: Operations = Operations::new(1, 0, 1);

/// One number that is written: a depth, a colour.
const STORE: Operations = Operations::new(0, 0, 1);

/// `Affine`: for each of three channels a product and a sum, and the sum that rounds, and a mask; 5 operations join
/// them.
const AFFINE_COLOR: Operations = Operations::new(3 * 3, 3 + 5, 0);

/// `Gouraud` with regard to perspective: 1/w (a product, a sum, 2 comparisons), its reciprocal; for each channel a
/// product and a sum, a product with w, 2 comparisons, the sum that rounds, and a mask; 5 operations join them.
const DIVIDED_COLOR: Operations = Operations::new(4 + 1 + 3 * 6, 3 + 5, 0);

/// `Weights::at`: for each of three vertices a plane (2 products, 2 sums, 2 comparisons) and a product; their sum; 3
/// divisions.
const SHARES: Operations = Operations::new(3 * 7 + 2 + 3, 0, 0);

/// `mix`: a component of an attribute from three shares: 3 products, 2 sums.
const COMPONENT: Operations = Operations::new(5, 0, 0);

/// `bytes`: for each of four channels the half that rounds and 2 comparisons; 6 operations join them.
const BYTES: Operations = Operations::new(4 * 3, 6, 0);

/// The coordinates of four texels: on two axes the coordinate is folded (2), scaled (1), moved by half a texel (1),
/// split in a whole number and a rest (2), and the two texels are held to the picture (a sum, 4 comparisons).
const FOUR: Operations = Operations::new(2 * 6, 2 * 5, 4);

/// `mixed_channel`: in four texels a shift and a mask; between them three times a difference, a product and a sum.
const MIXED: Operations = Operations::new(9, 4 * 2, 0);

/// The place of a texel in the picture: a product, a sum. The four of a level that stands among others are read from
/// one place, behind the first of its level, in rows of one more: two sums more.
const PLACE: Operations = Operations::new(0, 2, 0);
const PLACE_IN_LEVELS: Operations = Operations::new(0, 4, 0);

/// `nearest`: on two axes the coordinate is folded (2), scaled (1), and held to the picture (2); the place in the
/// picture (a product, a sum) and four channels (3 shifts, 4 masks).
const NEAREST: Operations = Operations::new(2 * 3, 2 * 2 + 2 + 7, 1);

/// The way from one level to the next, for each channel: a difference, a product, a sum.
const BETWEEN_LEVELS: Operations = Operations::new(3, 0, 0);

/// The level of detail: four squares of changes (3 products, a difference, a square), 2 sums and a comparison; half of
/// a logarithm to base 2 (a shift, 2 masks; 2 differences, a sum, a division, a product, and the half).
const DETAIL: Operations = Operations::new(4 * 5 + 3 + 6, 3, 0);

/// The interpolated w, a division; the tint, a product for each of four channels.
const TINT: Operations = Operations::new(1 + 4, 0, 0);

/// `filtered` on the map of parallel light: what is allowed (3 products, 3 sums), 2 tests that the place is a number,
/// the first texel (2 differences, rounded down), the mean (a product, 2 comparisons).
const SHADOW: Operations = Operations::new(6 + 2 + 4 + 3, 0, 0);

/// The same of a lamp: of six views five products of three components, and a comparison; a test that it lies ahead, the
/// place in the view that was found (2 divisions, 3 products, 3 sums), the slopes and the step (3 products).
const SHADOW_OF_LAMP: Operations = SHADOW.and(Operations::new(6 * (5 * 5 + 1) + 1 + 8 + 3, 0, 0));

/// A row or a column of texels under the soft edge: the next one (a sum), its part under the edge (3 sums, a
/// difference, 3 comparisons), and the plane in its middle (a sum, a difference, a product); a test that the map has
/// it.
const SHADOW_ROW: Operations = Operations::new(1 + 7 + 3, 2, 0);

/// A texel under the soft edge: its place in the map (a product, a sum); the plane there (2 sums, a product), a
/// comparison, its share (a product, a sum).
const SHADOW_TEXEL: Operations = Operations::new(3 + 1 + 2, 2, 1);

/// The loss of the two shares of light in a shadow: a product and a difference each.
const TAKEN: Operations = Operations::new(1 + 2 * 2, 0, 0);

/// `over`: what shows through (a shift, a mask, a bit-wise not), two halves of a pixel (3 masks, a product, 2 sums, 2
/// shifts, and 2 shifts between them), a join and a sum; the colour behind is read.
const OVER: Operations = Operations::new(0, 3 + 2 * 8 + 2 + 2, 1);

/// `premultiply_eight`: for each of three channels a shift, a mask, a product, 3 sums, 3 shifts; 3 joins and a shift.
const PREMULTIPLY: Operations = Operations::new(0, 3 * 9 + 4, 0);

/// `mean`: for each sample 2 masks, a shift and 2 sums; it is read.
const SAMPLE: Operations = Operations::new(0, 5, 1);

/// The end of `mean`: 3 shifts, 2 masks, a join.
const MEAN: Operations = Operations::new(0, 6, 0);

/// A pixel that goes to the picture: read and written.
const COPY: Operations = Operations::new(0, 0, 2);

/// Adds the work on one surface in one band of rows. The elements were counted, and these are their formulas.
pub(super) fn of_surface(cost: &mut Cost, surface: &Surface, depths: Depths, tally: &Tally) {
    let Tally { triangles, alone, edge_tests, rows, border_tests, covered, written, .. } = *tally;
    let pixels = tally.colored + tally.divided;
    let in_batches = matches!(surface.light, SurfaceLight::InBase)
        && (matches!(surface.base, Base::Solid(_) | Base::Faces(_))
            || matches!(surface.base, Base::Vertices(_)) && !surface.translucent);

    cost.add(Stage::Fill, BOX, triangles);
    cost.add(Stage::Fill, SET_UP, triangles);
    cost.add(Stage::Fill, ALONE, alone);
    cost.add(Stage::Fill, EDGE_TEST, edge_tests);
    cost.add(Stage::Fill, ROW, rows);
    cost.add(Stage::Fill, BORDER_TEST, border_tests);
    cost.add(Stage::Fill, STORE, written);

    let hidden = Stage::HiddenSurfaces;
    cost.add(hidden, PLANE, triangles + alone);
    cost.add(hidden, DEPTH, covered);
    cost.add(hidden, DEPTH_STEP, if depths.stepped { covered } else { 0 });
    cost.add(hidden, DEPTH_FORMAT, if depths.stored { covered } else { 0 });
    cost.add(hidden, DEPTH_TEST, if depths.tested { covered } else { 0 });
    cost.add(hidden, STORE, if depths.kept { written } else { 0 });

    let between = Stage::Interpolate;
    if in_batches {
        if matches!(surface.base, Base::Vertices(_)) {
            // Red, green and blue; with 1/w where the triangle goes alone.
            cost.add(between, PLANE.times(3), triangles);
            cost.add(between, PLANE.times(4), alone);
            cost.add(between, AFFINE_COLOR, tally.colored);
            cost.add(between, DIVIDED_COLOR, tally.divided);
        }
    } else {
        // The share of each vertex.
        cost.add(between, PLANE.times(3), triangles + alone);
        cost.add(between, SHARES, pixels);
        match &surface.base {
            Base::Solid(_) | Base::Faces(_) => {}
            Base::Vertices(_) => cost.add(between, COMPONENT.times(4).and(BYTES), pixels),
            Base::Texture { image, sampler, .. } => {
                cost.add(between, COMPONENT.times(2).and(BYTES), pixels);
                let (one_level, second_level) = texture(*sampler, image);
                cost.add(Stage::Texture, one_level, pixels);
                cost.add(Stage::Texture, second_level, tally.two_levels);
            }
        }
        match &surface.light {
            SurfaceLight::InBase => {}
            SurfaceLight::Faces(_) | SurfaceLight::Vertices(_) => {
                cost.add(between, COMPONENT.times(2).and(WITH_LIGHT), pixels);
            }
            SurfaceLight::PerPixel(light) => {
                // A normal and a position.
                cost.add(between, COMPONENT.times(6), pixels);
                cost.add(between, light_operations(&light.lighting).and(WITH_LIGHT), pixels);
            }
        }
    }
    for shadow in &surface.shadows {
        // The place for the light; of baked light also what may be missing of it.
        let taken = if matches!(shadow.taken, TakenLight::Light(_)) { 0 } else { 2 };
        cost.add(between, COMPONENT.times(3 + taken), pixels);
        cost.add(Stage::Shadow, self::shadow(&shadow.map).and(TAKEN), pixels);
    }
    if surface.translucent {
        let one_color = !in_batches && matches!(surface.base, Base::Solid(_) | Base::Faces(_));
        cost.add(Stage::Blend, PREMULTIPLY, if one_color { pixels } else { 0 });
        cost.add(Stage::Blend, OVER, written);
    }
}

/// The operations of a shadow at a pixel: along an axis, a soft edge of whole texels reaches over one more.
fn shadow(map: &ShadowMap) -> Operations {
    let once = match map.rays {
        Rays::Parallel { .. } => SHADOW,
        Rays::FromLamp { .. } => SHADOW_OF_LAMP,
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "8 at most")]
    let side = if map.softness > 0.0 { map.softness.ceil() as u64 + 1 } else { 1 };
    // The columns are gone through once in each row.
    once.and(SHADOW_ROW.times(side + side * side)).and(SHADOW_TEXEL.times(side * side))
}

/// The operations of a texture at a pixel that lies in one level, and what there is more where it lies between two.
fn texture(sampler: Sampler, image: &Texture) -> (Operations, Operations) {
    let has_levels = image.levels().len() > 1;
    let asks = sampler.filter == Filter::Trilinear && has_levels
        || matches!(sampler.reveal, Some(TextureReveal::Levels | TextureReveal::Texels));
    // Where all is opaque, alpha is not mixed.
    let channels = if image.is_opaque() { 3 } else { 4 };
    let mixed = FOUR.and(MIXED.times(channels));
    let in_levels = mixed.and(PLACE_IN_LEVELS);
    let texel = match sampler.filter {
        Filter::Nearest => NEAREST,
        _ if sampler.reveal == Some(TextureReveal::Texels) => NEAREST,
        Filter::Trilinear if has_levels => in_levels,
        Filter::Bilinear | Filter::Trilinear => mixed.and(PLACE.times(4)),
    };
    let detail = if asks { DETAIL } else { Operations::NONE };
    // The share, and the mean of four channels.
    let second = in_levels.and(BETWEEN_LEVELS.times(4)).and(Operations::new(1, 0, 0));
    (texel.and(detail).and(TINT), second)
}

/// Adds the work on all pixels of a picture: they are sorted, cleared, and written. `samples`: of a pixel; `cleared`:
/// the samples whose colours, and whose depths, were set before anything was filled: those of the pixels around which
/// there are triangles. The other pixels get the background.
pub(super) fn of_picture(cost: &mut Cost, drawing: &Drawing, samples: u64, cleared: [u64; 2]) {
    let pixels = u64::from(drawing.width) * u64::from(drawing.height);
    let sampled = cleared[0] / samples;
    let triangles: usize = drawing.surfaces.iter().map(|surface| surface.triangles.len()).sum();
    // Sorted into bands of rows by their boxes.
    cost.add(Stage::Fill, BOX, triangles as u64);
    cost.add(Stage::Fill, STORE, cleared[0]);
    cost.add(Stage::HiddenSurfaces, STORE, cleared[1]);
    if samples > 1 {
        cost.add(Stage::Antialias, SAMPLE.times(samples).and(MEAN), sampled);
        cost.add(Stage::Write, STORE, pixels);
    } else {
        cost.add(Stage::Write, COPY, sampled);
        cost.add(Stage::Write, STORE, pixels - sampled);
    }
}
