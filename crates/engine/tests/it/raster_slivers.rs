//! Colours on slivers: terms that nearly cancel in a gradient must not show.

use camera_lab_engine::appearance::Rgba;
use camera_lab_engine::drawing::{Base, Drawing, Surface};
use camera_lab_engine::raster::Rasterizer;

/// Numbers without a pattern, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: i32) -> i32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i32::try_from((self.0 >> 33) % u64::from(limit.unsigned_abs())).unwrap_or(0)
    }
}

/// Corners in steps of 1/256 pixel around the centre of a pixel, and one channel for each. The triangle is 75 pixels
/// high, and less than 1/32 of a step wide at the pixel, so gradients are differences of terms some thousand times as
/// large.
fn sliver(numbers: &mut Numbers) -> ([[i32; 2]; 3], [u8; 3]) {
    let centre = [48 * 256 + 128, 48 * 256 + 128];
    let [x, y] = [numbers.below(2), numbers.below(2)].map(|side| 2 * side - 1);
    let corner = |dx: i32, dy: i32| [centre[0] + x * (dx + 3563), centre[1] + y * (dy + 19_079) - y * 9472];
    let corners = [corner(0, 0), corner(-2777, -14_870), corner(-3594, -19_245)];
    let channel = |numbers: &mut Numbers| u8::try_from(numbers.below(256)).unwrap_or(0);
    let (from, to) = (channel(numbers), channel(numbers));
    // As a smooth picture has them: evenly along the sliver.
    let between = f64::from(from) + (f64::from(to) - f64::from(from)) * 14_870.0 / 19_245.0;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two bytes")]
    let between = between.round() as u8;
    (corners, [from, between, to])
}

#[test]
fn colours_on_slivers_are_those_of_exact_arithmetic() {
    let mut numbers = Numbers(7);
    let mut painted = 0;
    for _ in 0..1000 {
        let (corners, channels) = sliver(&mut numbers);
        let positions = corners.iter().map(|c| [c[0] as f32 / 256.0, c[1] as f32 / 256.0, 0.5]).collect();
        let colors = channels.iter().map(|&c| Rgba::rgb(c, c, c)).collect();
        let drawing = Drawing {
            surfaces: vec![Surface {
                base: Base::Vertices(colors),
                // So many that they are set up together, as those of a mesh are.
                ..Surface::solid(positions, vec![[0, 1, 2]; 8], Rgba::rgb(0, 0, 0))
            }],
            ..Drawing::new(96, 96, Rgba::rgb(1, 2, 3))
        };
        let Some(pixmap) = Rasterizer::default().paint(&drawing) else { panic!("a small picture") };
        for (i, pixel) in pixmap.data().chunks_exact(4).enumerate().filter(|(_, p)| p[..3] != [1, 2, 3]) {
            let (x, y) = ((i % 96) as i64 * 256 + 128, (i / 96) as i64 * 256 + 128);
            let exact = at(&corners, &channels, x, y);
            assert!(
                (f64::from(pixel[0]) - exact).abs() <= 1.0,
                "{corners:?} {channels:?}: {} instead of {exact}",
                pixel[0]
            );
            painted += 1;
        }
    }
    assert!(painted >= 1000, "{painted}");
}

/// The channel between those of the corners, from whole numbers.
fn at(corners: &[[i32; 2]; 3], channels: &[u8; 3], x: i64, y: i64) -> f64 {
    let p = corners.map(|c| c.map(i64::from));
    let area = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let q = [x, y];
    let weights = [area(q, p[1], p[2]), area(p[0], q, p[2]), area(p[0], p[1], q)];
    let sum: i64 = weights.iter().zip(channels).map(|(w, &c)| w * i64::from(c)).sum();
    sum as f64 / area(p[0], p[1], p[2]) as f64
}
