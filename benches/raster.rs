//! Time to paint one closed mesh: `cargo bench --no-default-features --bench raster [-- WORDS…]`.
//!
//! A bumpy sphere fills most of the picture, and back faces are culled already. Each row is the median of many pictures
//! that are painted over one another, with as many threads as there are. Behind that come rows for the parts: the
//! background alone, the sorting and dropping of triangles that own no sample, strokes with and without regard to the
//! depth buffer, texts.

#![expect(clippy::print_stdout, reason = "a benchmark prints")]
#![expect(clippy::cast_possible_truncation, reason = "small numbers")]

use std::time::Instant;

use camera_lab::appearance::{Dash, HiddenLines, LineStyle, Rgba, Samples};
use camera_lab::drawing::{Base, Drawing, Label, StrokeSet, Surface};
use camera_lab::progress::at_once;
use camera_lab::raster::Rasterizer;

/// The half of a bumpy sphere that can be seen, in perspective.
fn mesh(width: u32, height: u32, triangles: usize, gouraud: bool) -> Surface {
    let n = ((triangles / 4) as f64).sqrt().round() as u32;
    let (rows, columns) = (n, 2 * n);
    let (mut positions, mut inverse_w, mut colors) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..=rows {
        for j in 0..=columns {
            let theta = std::f64::consts::PI * f64::from(i) / f64::from(rows);
            let phi = std::f64::consts::TAU * f64::from(j) / f64::from(columns);
            let r = 1.0 + 0.02 * (5.0 * theta).sin() * (7.0 * phi).cos();
            let (x, y, z) = (r * theta.sin() * phi.cos(), r * theta.cos(), r * theta.sin() * phi.sin());
            let (y, z) = (0.8 * y + 0.6 * z, 0.8 * z - 0.6 * y);
            let w = 4.0 - z;
            let f = 1.75 * f64::from(height);
            let at = [f64::from(width) / 2.0 + f * x / w, f64::from(height) / 2.0 - f * y / w, 1.0 / w];
            positions.push(at.map(|v| v as f32));
            inverse_w.push((1.0 / w) as f32);
            let light = 60.0 + 190.0 * ((x + y + z) / 3.0_f64.sqrt()).clamp(0.0, 1.0);
            colors.push(Rgba::rgb(light as u8, (light * 0.8) as u8, (light * 0.5) as u8));
        }
    }
    let mut list = Vec::new();
    for i in 0..rows {
        for j in 0..columns {
            let a = i * (columns + 1) + j;
            let (b, c, d) = (a + 1, a + columns + 1, a + columns + 2);
            for t in [[a, b, d], [a, d, c]] {
                let [p, q, r] = t.map(|v| positions[v as usize]);
                if (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0.0 {
                    list.push(t);
                }
            }
        }
    }
    let base = if gouraud {
        Base::Vertices(colors)
    } else {
        Base::Faces(list.iter().map(|t| colors[t[0] as usize]).collect())
    };
    Surface { inverse_w, base, ..Surface::solid(positions, list, Rgba::rgb(0, 0, 0)) }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    println!("{:>10} {:>8} {:>8} {:>8} {:>10} {:>10}", "picture", "paint", "samples", "faces", "median ms", "least ms");
    for (width, height) in [(640, 640), (1920, 1080)] {
        for (name, gouraud) in [("gouraud", true), ("flat", false)] {
            for antialias in [Samples::One, Samples::Four] {
                for triangles in [1_000, 10_000, 100_000, 1_000_000] {
                    let row = format!("{width}x{height} {name} {antialias}x {triangles}");
                    if !words.iter().all(|w| row.contains(w.as_str())) {
                        continue;
                    }
                    let surfaces = vec![mesh(width, height, triangles, gouraud)];
                    let (median, least) = time(&Drawing { surfaces, ..empty(width, height, antialias) });
                    let picture = format!("{width}x{height}");
                    println!("{picture:>10} {name:>8} {antialias:>8} {triangles:>8} {median:>10.3} {least:>10.3}");
                }
            }
        }
    }
    println!("\n{:>34} {:>8} {:>10} {:>10}", "part, 1920x1080", "samples", "median ms", "least ms");
    for antialias in [Samples::One, Samples::Four] {
        for (name, drawing) in parts(antialias) {
            if words.iter().all(|w| name.contains(w.as_str())) {
                let (median, least) = time(&drawing);
                println!("{name:>34} {antialias:>8} {median:>10.3} {least:>10.3}");
            }
        }
    }
}

fn empty(width: u32, height: u32, antialias: Samples) -> Drawing {
    Drawing { antialias, ..Drawing::new(width, height, Rgba::rgb(255, 255, 255)) }
}

/// Drawings with one part that takes time, or with one part more than another drawing has.
fn parts(antialias: Samples) -> Vec<(&'static str, Drawing)> {
    let (width, height) = (1920, 1080);
    let nothing = empty(width, height, antialias);
    // All within a share of a pixel that has no sample.
    let mut dust = mesh(width, height, 1_000_000, true);
    dust.positions.iter_mut().for_each(|p| *p = [1e-5 * p[0] + 0.001, 1e-5 * p[1] + 0.001, p[2]]);
    let ball = mesh(width, height, 1_000, true);
    // Level lines through the ball, in pieces of 40 pixels: half of their length is hidden.
    let strokes = |hidden| {
        let (mut points, mut polylines) = (Vec::new(), Vec::new());
        for row in (10..height - 10).step_by(40) {
            for column in (0..width - 40).step_by(40) {
                let first = points.len() as u32;
                let depth = if (row / 40) % 2 == 0 { 0.4 } else { 0.2 };
                points.extend([column, column + 40].map(|x| [x as f32, row as f32 + 0.3, depth]));
                polylines.push(first..first + 2);
            }
        }
        let style = LineStyle { color: Rgba::rgb(20, 20, 20), width: 1.5, dash: Dash::Solid, hidden, arrow: false };
        vec![StrokeSet { polylines, ..StrokeSet::line(points, style) }]
    };
    let label = |k: u32| Label {
        fade_if_hidden: true,
        ..Label::new(
            [100.0 + (k % 10) as f32 * 170.0, 80.0 + (k / 10) as f32 * 200.0, 0.5],
            "(x_n, y_n) = (0.25, −1)",
            16.0,
            [Rgba::rgb(20, 20, 20), Rgba::rgba(255, 255, 255, 200)],
        )
    };
    let with_ball = Drawing { surfaces: vec![ball], ..nothing.clone() };
    vec![
        ("background", nothing.clone()),
        ("1M triangles that own nothing", Drawing { surfaces: vec![dust], ..nothing.clone() }),
        ("ball", with_ball.clone()),
        ("ball, 1269 strokes shown", Drawing { strokes: strokes(HiddenLines::Shown), ..with_ball.clone() }),
        ("ball, 1269 strokes dashed behind", Drawing { strokes: strokes(HiddenLines::Dashed), ..with_ball.clone() }),
        ("ball, 50 texts", Drawing { labels: (0..50).map(label).collect(), ..with_ball }),
    ]
}

/// Median and least time of a picture in milliseconds.
fn time(drawing: &Drawing) -> (f64, f64) {
    let mut rasterizer = Rasterizer::default();
    let Some(mut pixmap) = rasterizer.paint(drawing) else { return (f64::NAN, f64::NAN) };
    let mut times = Vec::new();
    let start = Instant::now();
    while times.len() < 20 || (start.elapsed().as_secs_f64() < 0.4 && times.len() < 500) {
        let start = Instant::now();
        at_once(rasterizer.paint_into(drawing, &mut pixmap));
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], times[0])
}
