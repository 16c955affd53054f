//! Triangles for the rasterizer, and the exact rule about the pixels that they own.

#![expect(clippy::cast_possible_truncation, reason = "small numbers, and bytes of random ones")]

use camera_lab_engine::appearance::{Rgba, Samples};
use camera_lab_engine::drawing::{Base, Drawing, Surface};
use camera_lab_engine::raster::Rasterizer;
use tiny_skia::Pixmap;

pub(crate) const BLACK: Rgba = Rgba::rgb(0, 0, 0);
pub(crate) const WHITE: Rgba = Rgba::rgb(255, 255, 255);

/// Numbers that look random and are the same each time (splitmix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// 0 … 1.
    pub(crate) fn unit(&mut self) -> f32 {
        (self.next() >> 40) as f32 / (1 << 24) as f32
    }

    pub(crate) fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }
}

pub(crate) fn drawing(width: u32, height: u32, antialias: Samples, surfaces: Vec<Surface>) -> Drawing {
    Drawing { antialias, surfaces, ..Drawing::new(width, height, WHITE) }
}

pub(crate) fn surface(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>, base: Base) -> Surface {
    Surface { base, ..Surface::solid(positions, triangles, BLACK) }
}

pub(crate) fn paint(drawing: &Drawing) -> Pixmap {
    Rasterizer::default().paint(drawing).expect("a picture")
}

pub(crate) fn rgb(pixmap: &Pixmap, x: u32, y: u32) -> [u8; 3] {
    let p = pixmap.pixel(x, y).expect("inside");
    [p.red(), p.green(), p.blue()]
}

/// A position in 1/256 pixel, as the rasterizer must round it.
pub(crate) fn grid(v: f32) -> i128 {
    (f64::from(v) * 256.0).round_ties_even() as i128
}

/// Does the triangle own the centre of the pixel?
pub(crate) fn owns(triangle: [[f32; 3]; 3], x: u32, y: u32) -> bool {
    owns_point(triangle, [i128::from(x) * 256 + 128, i128::from(y) * 256 + 128])
}

/// Does the triangle own the point (in 1/256 pixel)? By the definition of the top-left rule, in whole numbers.
pub(crate) fn owns_point(triangle: [[f32; 3]; 3], p: [i128; 2]) -> bool {
    let v = triangle.map(|p| [grid(p[0]), grid(p[1])]);
    let cross =
        |a: [i128; 2], b: [i128; 2], c: [i128; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let area = cross(v[0], v[1], v[2]);
    if area == 0 {
        return false;
    }
    (0..3).all(|k| {
        let (a, b) = if area > 0 { (v[k], v[(k + 1) % 3]) } else { (v[(k + 1) % 3], v[k]) };
        let third = v[(k + 2) % 3];
        match cross(a, b, p) {
            0 if a[1] == b[1] => third[1] > a[1],
            0 => {
                // The edge is at the left if the third corner lies to the right of it, at its own height.
                let at = |q: [i128; 2]| (q[0] - a[0]) * (b[1] - a[1]) - (q[1] - a[1]) * (b[0] - a[0]);
                (at(third) > 0) == (b[1] > a[1])
            }
            e => e > 0,
        }
    })
}
