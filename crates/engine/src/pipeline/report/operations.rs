//! The cost of a stage by the textbook: the operations of its usual algorithm for one element, times the elements.
//!
//! The rows count the formulas of the lecture, not our code, which works on eight numbers at a time and leaves out what
//! a picture doesn't need. A comment next to each row gives its arithmetic, and [`Operations`] lists the kinds.

use crate::stage::{Operations, Stage};

/// The elements of a stage, and the numbers that their cost depends on.
#[derive(Clone, Copy, Debug)]
pub struct Elements {
    /// Elements that go in: objects, vertices, triangles, samples or pixels, as the stage has them.
    pub entering: u64,
    /// Elements that come out.
    pub leaving: u64,
    /// Lamps of the scene.
    pub lamps: u64,
    /// Pixels that are lit one by one.
    pub lit_pixels: u64,
    /// Faces are painted from back to front, without a depth buffer.
    pub in_order: bool,
}

/// The operations of a stage with these elements.
pub fn operations(stage: Stage, elements: Elements) -> Operations {
    let Elements { entering, leaving, lamps, lit_pixels, in_order } = elements;
    let each = |entered: Operations, left: Operations| entered.times(entering).and(left.times(leaving));
    let light = LIGHT.and(LAMP.times(lamps));
    match stage {
        Stage::Traverse | Stage::CullObjects | Stage::Lines => Operations::NONE,
        Stage::Normals => NORMAL.times(entering),
        Stage::Light => light.times(entering),
        Stage::Transform => TRANSFORM.times(entering),
        Stage::Oblique => OBLIQUE.times(entering),
        Stage::CullFaces => each(FACING, TRIANGLE),
        Stage::Clip => each(OUTCODES, TRIANGLE),
        Stage::Divide => DIVIDE.times(entering),
        Stage::Viewport => VIEWPORT.times(entering),
        Stage::Fill => each(EDGES, SAMPLE),
        Stage::Interpolate => INTERPOLATE.times(entering).and(NORMAL_BETWEEN.and(light).times(lit_pixels)),
        // Sorted by the middles of faces: ⌈log₂ n⌉ comparisons for each.
        Stage::HiddenSurfaces if in_order => {
            MIDDLE.and(Operations::new(leaving.next_power_of_two().trailing_zeros().into(), 0, 0)).times(leaving)
        }
        Stage::HiddenSurfaces => each(DEPTH_TEST, DEPTH_WRITTEN),
        Stage::Texture => BILINEAR.times(entering),
        Stage::Shadow => LOOK_UP.times(entering),
        Stage::Blend => OVER.times(entering),
        Stage::Antialias => each(SUMMED, MEAN),
        Stage::Write => WRITTEN.times(entering),
    }
}

/// A vertex, `[0]` Eqs. (5.7), (5.14): M_v · p (9 products, 9 sums); the scale of x_c and of y_c; a product and a sum
/// for z_r. Its coordinates are read.
const TRANSFORM: Operations = Operations::new(18 + 2 + 2, 0, 3);

/// `[0]` Eq. (5.13): one more product and sum for x_r and for y_r.
const OBLIQUE: Operations = Operations::new(4, 0, 0);

/// `[0]` Eq. (5.6): x_r, y_r and z_r by w_r.
const DIVIDE: Operations = Operations::new(3, 0, 0);

/// `[0]` Eqs. (5.24), (5.25): a product and a sum for each of X, Y and Z, two floors. They are written.
const VIEWPORT: Operations = Operations::new(6 + 2, 0, 3);

/// A normal: the matrix of 3 × 3 (9 products, 6 sums). It is read.
const NORMAL: Operations = Operations::new(15, 0, 3);

/// `I = k_a + Σ (k_d N·L + k_s (N·H)ⁿ)`, once: **N** of length 1 (5 for the square, a root, 3 divisions),
/// a product and a sum for each channel. Normal and colour are read, the colour is written.
const LIGHT: Operations = Operations::new(9 + 6, 0, 3 + 2);

/// For each lamp: **N**·**L** and **N**·**H** (5 each), **H** = **L** + **V** of length 1 (3 + 9), not below 0 (2), the
/// power, 2 products, 2 sums.
const LAMP: Operations = Operations::new(10 + 12 + 2 + 1 + 4, 0, 0);

/// The sign of (x₁ − x₀)(y₂ − y₀) − (x₂ − x₀)(y₁ − y₀). Three indices and six coordinates are read.
const FACING: Operations = Operations::new(4 + 2 + 1 + 1, 0, 3 + 6);

/// A triangle that is left: three indices are written.
const TRIANGLE: Operations = Operations::new(0, 0, 3);

/// The six planes of Cohen and Sutherland, for three corners: a sum and a comparison each; 3 masks are joined, and
/// intersected. Three indices and four coordinates for each corner are read. The few corners that clipping makes are
/// left out.
const OUTCODES: Operations = Operations::new(3 * 12, 4, 3 + 12);

/// Three edge functions (4 differences or products each, and a difference) and the box of a triangle (8 comparisons)
/// [Pineda 1988]. Three indices and six coordinates are read.
const EDGES: Operations = Operations::new(0, 3 * 5 + 8, 3 + 6);

/// A sample inside: as many of the box are outside, so twice three sums and three comparisons. Its colour is written.
const SAMPLE: Operations = Operations::new(0, 2 * 6, 1);

/// Three channels and 1/w (a sum each), a division by 1/w and 3 products.
const INTERPOLATE: Operations = Operations::new(4 + 4, 0, 0);

/// A normal between vertices, for the light of a pixel: a sum and a product for each of its three numbers.
const NORMAL_BETWEEN: Operations = Operations::new(6, 0, 0);

/// A sample and the depth buffer: a sum, a comparison. The old depth is read.
const DEPTH_TEST: Operations = Operations::new(2, 0, 1);

/// The nearer depth is written.
const DEPTH_WRITTEN: Operations = Operations::new(0, 0, 1);

/// The depth of the middle of a face: 2 sums. Three depths are read.
const MIDDLE: Operations = Operations::new(2, 0, 3);

/// A texel between four: u and v in texels (2 products, 2 floors, 2 differences), three means of two for each of three
/// channels (a difference, a product, a sum). Four texels are read.
const BILINEAR: Operations = Operations::new(6 + 3 * 9, 0, 4);

/// A point on a shadow map [Williams 1978]: a matrix of 4 × 4 (16 products, 12 sums), 3 divisions, to the map (3
/// products, 3 sums), the bias and a comparison. A depth is read. The map itself is a picture of its own, and not in
/// the count.
const LOOK_UP: Operations = Operations::new(28 + 3 + 6 + 2, 0, 1);

/// α S + (1 − α) D: a difference, and for each of three channels 2 products and a sum. D is read.
const OVER: Operations = Operations::new(0, 1 + 9, 1);

/// A sample is read and added to its pixel: three channels.
const SUMMED: Operations = Operations::new(0, 3, 1);

/// The mean of a pixel: three divisions.
const MEAN: Operations = Operations::new(0, 3, 0);

/// A pixel is written to the image.
const WRITTEN: Operations = Operations::new(0, 0, 1);

#[cfg(test)]
mod tests {
    use super::*;

    const TEN: Elements = Elements { entering: 10, leaving: 5, lamps: 0, lit_pixels: 0, in_order: false };

    #[test]
    fn the_cost_is_that_of_each_element() {
        assert_eq!(operations(Stage::Transform, TEN), Operations::new(220, 0, 30));
        assert_eq!(operations(Stage::CullFaces, TEN), Operations::new(80, 0, 90 + 15));
        assert_eq!(operations(Stage::HiddenSurfaces, TEN), Operations::new(20, 0, 10 + 5));
        // Five faces need three comparisons each.
        let in_order = Elements { in_order: true, ..TEN };
        assert_eq!(operations(Stage::HiddenSurfaces, in_order), Operations::new(5 * (2 + 3), 0, 15));
    }

    #[test]
    fn each_lamp_costs_as_much_as_the_last() {
        let float = |lamps| operations(Stage::Light, Elements { lamps, ..TEN }).float;
        assert_eq!(float(1) - float(0), 290);
        assert_eq!(float(3) - float(2), 290);
    }

    #[test]
    fn a_stage_without_elements_costs_nothing() {
        let none = Elements { entering: 0, leaving: 0, lamps: 2, lit_pixels: 0, in_order: true };
        assert!(Stage::ALL.into_iter().all(|stage| operations(stage, none) == Operations::NONE));
    }
}
