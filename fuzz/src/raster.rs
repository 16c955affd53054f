//! Filling: any triangles and strokes in the picture, at any depths, become pixels.

use camera_lab::appearance::{Dash, HiddenLines, LineStyle, Rgba, Samples};
use camera_lab::drawing::{Base, Drawing, StrokeSet, Surface};
use camera_lab::raster::Rasterizer;

const SIZE: [u32; 2] = [70, 53];

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Some((&[choices, alpha], bytes)) = bytes.split_first_chunk::<2>() else { return };
    // Places on the grid of subpixels, in the picture. Depths stay as they are.
    let point = |b: &[u8]| {
        let place = |low: u8, high: u8, size: u32| f32::from(u16::from_le_bytes([low, high])) / 65535.0 * size as f32;
        let grid = |v: f32| (v * 256.0).round() / 256.0;
        let depth = f32::from_le_bytes([b[4], b[5], b[6], b[7]]);
        [grid(place(b[0], b[1], SIZE[0])), grid(place(b[2], b[3], SIZE[1])), depth]
    };
    let positions: Vec<[f32; 3]> = bytes.chunks_exact(8).map(point).collect();
    let count = u32::try_from(positions.len()).expect("a short input");
    if count < 3 {
        return;
    }
    let triangles: Vec<[u32; 3]> = (2..count).map(|i| [i - 2, i - 1, i]).collect();
    let base = if choices & 1 == 0 {
        Base::Solid(Rgba::rgba(200, 100, 50, alpha))
    } else {
        Base::Vertices((0..count).map(|i| Rgba::rgba(i.to_le_bytes()[0], 90, 200, alpha)).collect())
    };
    let color = Rgba::rgba(0, 0, 0, alpha);
    let surface = Surface { base, depth_test: choices & 2 == 0, ..Surface::solid(positions.clone(), triangles, color) };
    let hidden = [HiddenLines::Dashed, HiddenLines::Hidden, HiddenLines::Shown][usize::from(choices >> 2) % 3];
    let style = LineStyle {
        color: Rgba::rgb(0, 0, 0),
        width: 1.0 + f32::from(choices >> 4),
        dash: if choices & 4 == 0 { Dash::Solid } else { Dash::DashDot },
        hidden,
        arrow: choices & 8 != 0,
    };
    // Of strokes the depths are numbers: they are clipped.
    let points: Vec<[f32; 3]> =
        positions.iter().map(|p| [p[0], p[1], if p[2].is_finite() { p[2] } else { 0.5 }]).collect();
    let drawing = Drawing {
        antialias: Samples::ALL[usize::from(choices >> 6) % 3],
        painted_in_order: choices & 32 != 0,
        surfaces: vec![surface],
        strokes: vec![StrokeSet::line(points, style)],
        ..Drawing::new(SIZE[0], SIZE[1], Rgba::rgb(255, 255, 255))
    };
    let pixels = Rasterizer::default().paint(&drawing).expect("a small picture");
    assert!(pixels.data().chunks_exact(4).all(|p| p[3] == 255), "the ground is opaque");
}
