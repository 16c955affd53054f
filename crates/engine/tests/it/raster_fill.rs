//! The pixels and depths of triangles, against exact arithmetic.

#![expect(clippy::cast_possible_truncation, reason = "small numbers, and bytes of random ones")]

use std::sync::Arc;
use std::time::Duration;

use camera_lab_engine::appearance::{Rgba, Sampler, Samples, Texture};
use camera_lab_engine::drawing::{Base, Lighting, PixelLight, Surface, SurfaceLight};
use camera_lab_engine::limits::MAX_SIDE;
use camera_lab_engine::progress::at_once;
use camera_lab_engine::raster::Rasterizer;
use tiny_skia::Pixmap;

use crate::common::triangles::{BLACK, Random, WHITE, drawing, grid, owns, owns_point, paint, rgb, surface};

#[track_caller]
fn check_coverage(width: u32, height: u32, triangle: [[f32; 3]; 3]) -> usize {
    let s = surface(triangle.to_vec(), vec![[0, 1, 2]], Base::Solid(BLACK));
    let pixmap = paint(&drawing(width, height, Samples::One, vec![s]));
    let mut covered = 0;
    for y in 0..height {
        for x in 0..width {
            let found = rgb(&pixmap, x, y) == [0, 0, 0];
            assert_eq!(found, owns(triangle, x, y), "pixel ({x}, {y}) of {triangle:?}");
            covered += usize::from(found);
        }
    }
    covered
}

#[test]
fn a_triangle_covers_exactly_the_pixels_it_owns() {
    let mut random = Random(1);
    let mut covered = 0;
    for round in 0..400 {
        let triangle = std::array::from_fn(|_| {
            let (x, y) = (random.unit() * 40.0, random.unit() * 24.0);
            // Anywhere, or on quarters of a pixel, so that centres lie on edges, or on corners and centres of pixels
            // only.
            let [x, y] = match round % 3 {
                0 => [x, y],
                1 => [(x * 4.0).round() / 4.0, (y * 4.0).round() / 4.0],
                _ => [(x * 2.0).round() / 2.0, (y * 2.0).round() / 2.0],
            };
            [x, y, 0.5]
        });
        covered += check_coverage(40, 24, triangle);
    }
    assert!(covered > 10_000, "the triangles were too small to prove anything: {covered}");
}

#[test]
fn slivers_cover_exactly_the_pixels_they_own() {
    let mut random = Random(2);
    let mut covered = 0;
    for _ in 0..300 {
        let (a, b) = ([random.unit() * 48.0, random.unit() * 24.0], [random.unit() * 48.0, random.unit() * 24.0]);
        let t = random.unit();
        let nudge = [random.unit() - 0.5, random.unit() - 0.5];
        let c = [a[0] + t * (b[0] - a[0]) + nudge[0], a[1] + t * (b[1] - a[1]) + nudge[1]];
        covered += check_coverage(48, 24, [a, b, c].map(|p| [p[0], p[1], 0.5]));
    }
    assert!(covered > 500, "{covered}");
}

#[test]
fn tiny_triangles_cover_exactly_the_pixels_they_own() {
    let mut random = Random(3);
    let mut covered = 0;
    for _ in 0..1500 {
        let size = 0.2 + 3.0 * random.unit();
        let near = [random.unit() * 10.0, random.unit() * 10.0];
        covered += check_coverage(
            12,
            12,
            std::array::from_fn(|_| {
                [near[0] + size * (random.unit() - 0.5), near[1] + size * (random.unit() - 0.5), 0.5]
            }),
        );
    }
    assert!(covered > 300, "{covered}");
}

/// Samples of a pixel that the triangle owns, of `side`² on a turned lattice: no two of them in one row or column.
fn owned_samples(triangle: [[f32; 3]; 3], x: u32, y: u32, side: u32) -> u32 {
    let step = 256 / i128::from(side * side);
    let place = |pixel: u32, k: u32| i128::from(pixel) * 256 + step * i128::from(k) + step / 2;
    let mut owned = 0;
    for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
        let point = [place(x, side * i + j), place(y, side * j + side - 1 - i)];
        owned += u32::from(owns_point(triangle, point));
    }
    owned
}

#[test]
fn a_triangle_covers_exactly_the_samples_it_owns() {
    let mut random = Random(9);
    for (antialias, side) in [(Samples::One, 1), (Samples::Four, 2), (Samples::Sixteen, 4)] {
        let mut partly = 0;
        for round in 0..60 {
            // Of a pixel's size, of some pixels, wide ones, and slivers across the picture.
            let size = [1.5, 9.0, 60.0, 120.0][round % 4];
            let near = [random.unit() * 90.0, random.unit() * 40.0];
            let mut triangle = std::array::from_fn(|_| {
                [near[0] + size * (random.unit() - 0.5), near[1] + 0.5 * size * (random.unit() - 0.5), 0.5]
            });
            if round % 8 == 7 {
                let [a, b, _] = triangle;
                triangle[2] = [0.5 * (a[0] + b[0]) + random.unit(), 0.5 * (a[1] + b[1]) + random.unit(), 0.5];
            }
            let s = surface(triangle.to_vec(), vec![[0, 1, 2]], Base::Solid(BLACK));
            let pixmap = paint(&drawing(90, 40, antialias, vec![s]));
            let samples = side * side;
            for (k, pixel) in (0..).zip(pixmap.pixels()) {
                let owned = owned_samples(triangle, k % 90, k / 90, side);
                // The mean of white and black samples, a half rounded up.
                let expected = (2 * 255 * (samples - owned) + samples) / (2 * samples);
                let found = u32::from(pixel.red());
                assert_eq!(found, expected, "pixel ({}, {}) of {triangle:?}, {samples} samples", k % 90, k / 90);
                partly += usize::from(owned > 0 && owned < samples);
            }
        }
        assert!(side == 1 || partly > 1000, "{partly}");
    }
}

/// A bumpy ball in perspective, as a picture of this side sees it: a closed mesh, front and back.
fn ball(side: u32, rings: u32, turn: f64) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let sectors = 2 * rings;
    let mut positions = Vec::new();
    for i in 0..=rings {
        for j in 0..sectors {
            let theta = std::f64::consts::PI * f64::from(i) / f64::from(rings);
            let phi = std::f64::consts::TAU * f64::from(j) / f64::from(sectors);
            // At the poles all are one point, to the last bit.
            let across = if i == 0 || i == rings { 0.0 } else { theta.sin() };
            let r = 1.0 + 0.1 * across * (3.0 * phi).cos();
            let (x, y, z) = (r * across * phi.cos(), r * theta.cos(), r * across * phi.sin());
            let (sin, cos) = turn.sin_cos();
            let (y, z) = (cos * y + sin * z, cos * z - sin * y);
            let (x, y) = (cos * x + sin * y, cos * y - sin * x);
            let scale = 1.2 * f64::from(side) / (3.5 - z);
            let middle = 0.5 * f64::from(side);
            positions.push([(middle + scale * x) as f32, (middle - scale * y) as f32, (1.0 / (3.5 - z)) as f32]);
        }
    }
    let mut triangles = Vec::new();
    for i in 0..rings {
        for j in 0..sectors {
            let a = i * sectors + j;
            let b = i * sectors + (j + 1) % sectors;
            triangles.extend([[a, b, b + sectors], [a, b + sectors, a + sectors]]);
        }
    }
    (positions, triangles)
}

#[test]
fn every_pixel_of_a_closed_mesh_has_as_many_fronts_as_backs() {
    for (side, rings) in [(61, 3), (61, 8), (61, 40), (230, 6), (230, 90)] {
        for turn in [0.3, 1.1, 2.0] {
            let (positions, triangles) = ball(side, rings, turn);
            let area = |t: &[u32; 3]| {
                let [a, b, c] = t.map(|k| positions[k as usize].map(grid));
                (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            };
            let coats = |front: bool| {
                let chosen = triangles.iter().copied().filter(|t| (area(t) > 0) == front).collect();
                let mut s = surface(positions.clone(), chosen, Base::Solid(Rgba::rgba(0, 0, 0, 128)));
                s.translucent = true;
                paint(&drawing(side, side, Samples::One, vec![s]))
            };
            // One half of the ball may hide parts of itself, but each way in has a way out.
            assert!(coats(true) == coats(false), "{rings} rings turned by {turn}");
            assert!(coats(true).pixels().iter().filter(|p| p.red() < 255).count() > (side * side / 4) as usize);
        }
    }
}

#[test]
fn the_largest_triangles_do_not_overflow() {
    let mut random = Random(4);
    for round in 0..12 {
        let far = |random: &mut Random, size: u32| (random.unit() * size as f32).min(size as f32);
        let (width, height) = if round % 2 == 0 { (MAX_SIDE, 5) } else { (5, MAX_SIDE) };
        let triangle = std::array::from_fn(|_| [far(&mut random, width), far(&mut random, height), 0.5]);
        check_coverage(width, height, triangle);
    }
    let m = MAX_SIDE as f32;
    check_coverage(MAX_SIDE, 3, [[0.0, 0.0, 0.5], [m, 0.0, 0.5], [m, 3.0, 0.5]]);
    // Vertices far outside of the picture, as far as they may be.
    let (n, f) = (-4096.0, 28_671.0);
    check_coverage(6, 6, [[n, n, 0.5], [f, n, 0.5], [3.0, f, 0.5]]);
    check_coverage(6, 6, [[n, 3.1, 0.5], [f, 2.9, 0.5], [3.0, f, 0.5]]);
    check_coverage(6, 6, [[5.2, n, 0.5], [4.9, f, 0.5], [f, 0.0, 0.5]]);
}

/// A picture full of triangles that share all their edges, vertices on no particular places.
fn carpet(side: u32, cells: u32, random: &mut Random) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let step = side as f32 / cells as f32;
    let mut positions = Vec::new();
    for j in 0..=cells {
        for i in 0..=cells {
            let inner = |k: u32| if k == 0 || k == cells { 0.0 } else { 0.7 };
            let x = (i as f32 + inner(i) * (random.unit() - 0.5)) * step;
            let y = (j as f32 + inner(j) * (random.unit() - 0.5)) * step;
            positions.push([x, y, random.unit()]);
        }
    }
    let mut triangles = Vec::new();
    for j in 0..cells {
        for i in 0..cells {
            let a = j * (cells + 1) + i;
            let (b, c, d) = (a + 1, a + cells + 1, a + cells + 2);
            // Diagonals and windings of both kinds.
            match random.below(4) {
                0 => triangles.extend([[a, b, d], [a, d, c]]),
                1 => triangles.extend([[a, d, b], [c, d, a]]),
                2 => triangles.extend([[a, b, c], [b, d, c]]),
                _ => triangles.extend([[c, b, a], [b, c, d]]),
            }
        }
    }
    (positions, triangles)
}

#[test]
fn triangles_with_common_edges_cover_each_sample_exactly_once() {
    let mut random = Random(5);
    let sizes = [(3, 1), (9, 1), (48, 1), (90, 1), (9, 4), (60, 4), (5, 16), (30, 16)];
    for (cells, antialias) in sizes.map(|(cells, count)| (cells, Samples::from_count(count).expect("1, 4 or 16"))) {
        let (positions, triangles) = carpet(48, cells, &mut random);
        let mut s = surface(positions, triangles, Base::Solid(Rgba::rgba(0, 0, 0, 128)));
        s.translucent = true;
        let pixmap = paint(&drawing(48, 48, antialias, vec![s]));
        // White under one coat is 127, no coat would be 255, two 63.
        for (k, pixel) in pixmap.pixels().iter().enumerate() {
            assert_eq!(pixel.red(), 127, "pixel ({}, {}), {cells} cells, {antialias} samples", k % 48, k / 48);
        }
    }
}

#[test]
fn depth_is_that_of_exact_arithmetic_within_its_bound() {
    let mut random = Random(6);
    let mut checked = 0;
    for round in 0..300 {
        let scale = if round % 2 == 0 { 1.0 } else { 1e-4 };
        let mut triangle: [[f32; 3]; 3] = std::array::from_fn(|_| [0.0; 3]);
        for p in &mut triangle {
            *p = [random.unit() * 60.0, random.unit() * 40.0, scale * random.unit()];
        }
        if round % 3 == 0 {
            // A sliver.
            triangle[2][0] = 0.5 * (triangle[0][0] + triangle[1][0]) + 0.02;
            triangle[2][1] = 0.5 * (triangle[0][1] + triangle[1][1]);
        }
        let mut rasterizer = Rasterizer::default();
        let s = surface(triangle.to_vec(), vec![[0, 1, 2]], Base::Solid(BLACK));
        rasterizer.paint(&drawing(60, 40, Samples::One, vec![s])).expect("a picture");
        // In f64: exact but for some 1e-13 of the terms.
        let v = triangle.map(|p| [grid(p[0]) as f64 / 256.0, grid(p[1]) as f64 / 256.0, f64::from(p[2])]);
        let (p, q) = ([v[1][0] - v[0][0], v[1][1] - v[0][1]], [v[2][0] - v[0][0], v[2][1] - v[0][1]]);
        let area = p[0] * q[1] - p[1] * q[0];
        let (d1, d2) = (v[1][2] - v[0][2], v[2][2] - v[0][2]);
        let (dx, dy) = ((d1 * q[1] - d2 * p[1]) / area, (d2 * p[0] - d1 * q[0]) / area);
        let low = v[0][2].min(v[1][2]).min(v[2][2]);
        let high = v[0][2].max(v[1][2]).max(v[2][2]);
        let extent = |k: usize| {
            v.iter().map(|p| p[k]).fold(f64::MIN, f64::max) - v.iter().map(|p| p[k]).fold(f64::MAX, f64::min)
        };
        // Some roundings of the terms that a gradient is made of, as large as they get within the triangle. In slivers
        // they are far greater than the gradient.
        let (terms_x, terms_y) = ((d1 * q[1]).abs() + (d2 * p[1]).abs(), (d2 * p[0]).abs() + (d1 * q[0]).abs());
        let terms = (terms_x * (extent(0) + 1.0) + terms_y * (extent(1) + 1.0)) / area.abs();
        let bound = 5.0 * 2.0_f64.powi(-24) * (terms + high);
        for y in 0..40 {
            for x in 0..60 {
                let Some(found) = rasterizer.depth().at(x, y) else {
                    assert!(!owns(triangle, x, y));
                    continue;
                };
                let exact = v[0][2] + dx * (f64::from(x) + 0.5 - v[0][0]) + dy * (f64::from(y) + 0.5 - v[0][1]);
                let error = (f64::from(found) - exact).abs();
                assert!(error <= bound, "({x}, {y}) of {triangle:?}: {error:e} above {bound:e}");
                assert!((low..=high).contains(&f64::from(found)), "outside of the vertices' range");
                checked += 1;
            }
        }
    }
    assert!(checked > 30_000, "{checked}");
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let mut random = Random(7);
    let (positions, triangles) = carpet(300, 60, &mut random);
    let colors = positions.iter().map(|_| Rgba::rgb(random.next() as u8, random.next() as u8, random.next() as u8));
    let colors: Vec<Rgba> = colors.collect();
    let mut opaque = surface(positions.clone(), triangles.clone(), Base::Vertices(colors));
    opaque.inverse_w = positions.iter().map(|_| 0.2 + random.unit()).collect();
    let faces = triangles.iter().map(|_| Rgba::rgba(random.next() as u8, 90, random.next() as u8, 60)).collect();
    let mut clear =
        surface(positions.iter().map(|p| [p[1], p[0], 1.0 - p[2]]).collect(), triangles, Base::Faces(faces));
    clear.translucent = true;
    for antialias in [Samples::One, Samples::Four] {
        let d = drawing(300, 300, antialias, vec![opaque.clone(), clear.clone()]);
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| {
                let mut rasterizer = measuring();
                let pixmap = rasterizer.paint(&d).expect("a picture");
                let depths: Vec<_> = (0..300 * 300).map(|k| rasterizer.depth().at(k % 300, k / 300)).collect();
                (pixmap, depths, rasterizer.work())
            })
        };
        let one = on(1);
        for threads in [2, 3, 8] {
            let many = on(threads);
            assert!(one == many, "{threads} threads, {antialias} samples");
        }
    }
}

fn measuring() -> Rasterizer {
    let mut rasterizer = Rasterizer::default();
    rasterizer.measure(Some(|| Duration::ZERO));
    rasterizer
}

#[test]
fn counts_agree_with_the_work_done() {
    let mut random = Random(71);
    for (cells, samples) in [(4, 1), (11, 1), (70, 1), (4, 4), (40, 4), (13, 16)] {
        let antialias = Samples::from_count(samples).expect("1, 4 or 16");
        let samples = u64::from(samples);
        // Every sample once, and again behind that: covered twice and written once. A triangle outside follows.
        let (mut positions, triangles) = carpet(67, cells, &mut random);
        let near: Vec<_> = positions.iter().map(|p| [p[0], p[1], 0.9]).collect();
        positions.extend([[-9.0, 5.0, 1.0], [-5.0, 5.0, 1.0], [-5.0, 9.0, 1.0]]);
        let mut back = surface(positions, triangles.clone(), Base::Solid(BLACK));
        back.positions.iter_mut().for_each(|p| p[2] = 0.1);
        let last = u32::try_from(back.positions.len()).expect("few");
        back.triangles.push([last - 3, last - 2, last - 1]);
        let number = 2 * triangles.len() + 1;
        let d = drawing(67, 67, antialias, vec![surface(near, triangles, Base::Solid(WHITE)), back]);
        let mut rasterizer = measuring();
        rasterizer.paint(&d).expect("a picture");
        let work = rasterizer.work();
        let all = 67 * 67 * samples;
        assert_eq!((work.covered, work.written, work.triangles), (2 * all, all, number), "{cells} cells, {antialias}");
        assert!(work.empty >= 1 && (cells > 60 || work.empty < number / 4), "{} of {number}", work.empty);
        rasterizer.measure(None);
        rasterizer.paint(&d).expect("a picture");
        assert_eq!((rasterizer.work().covered, rasterizer.work().written), (0, 0));
    }
}

#[test]
fn buffers_keep_nothing_of_the_picture_before() {
    use Samples::{Four, One, Sixteen};

    let mut random = Random(8);
    let (positions, triangles) = carpet(40, 6, &mut random);
    // In front of all that follows.
    let near: Vec<_> = positions.iter().map(|p| [p[0], p[1], 0.9]).collect();
    let full = surface(near, triangles, Base::Solid(BLACK));
    let corners = vec![[5.0, 5.0, 0.1], [20.0, 6.0, 0.1], [8.0, 18.0, 0.1], [24.0, 9.0, 0.1]];
    let small = surface(corners, vec![[0, 1, 2], [1, 2, 3]], Base::Solid(Rgba::rgb(9, 8, 7)));
    let mut rasterizer = measuring();
    let mut pixmap = Pixmap::new(1, 1).expect("a pixmap");
    for (first, then) in
        [(One, One), (One, Four), (Four, Four), (Four, Sixteen), (Sixteen, Sixteen), (Sixteen, One), (Four, One)]
    {
        for width in [40, 30, 40] {
            let full = drawing(40, 40, first, vec![full.clone()]);
            let over = Surface { depth_test: false, ..small.clone() };
            let empty = drawing(40, 40, then, Vec::new());
            for d in [full, drawing(width, 40, then, vec![small.clone()]), drawing(width, 40, then, vec![over]), empty]
            {
                assert!(at_once(rasterizer.paint_into(&d, &mut pixmap)));
                let mut fresh = measuring();
                assert!(pixmap == fresh.paint(&d).expect("a picture"), "{first} to {then} samples, {width} wide");
                assert_eq!(rasterizer.work(), fresh.work());
                for k in 0..40 * 40 {
                    assert_eq!(rasterizer.depth().at(k % 40, k / 40), fresh.depth().at(k % 40, k / 40));
                }
            }
        }
    }
}

#[test]
fn upright_and_level_edges_have_as_many_shades_as_samples() {
    for (antialias, samples) in Samples::ALL.map(|antialias| (antialias, u32::from(antialias.count()))) {
        for k in 0..=samples {
            let edge = 2.0 + k as f32 / samples as f32;
            let upright = vec![[0.0, 0.0, 0.5], [edge, 0.0, 0.5], [edge, 6.0, 0.5], [0.0, 6.0, 0.5]];
            let level = upright.iter().map(|p| [p[1], p[0], p[2]]).collect();
            for (positions, at) in [(upright, (2, 3)), (level, (3, 2))] {
                let s = surface(positions, vec![[0, 1, 2], [0, 2, 3]], Base::Solid(BLACK));
                let found = rgb(&paint(&drawing(6, 6, antialias, vec![s])), at.0, at.1)[0];
                let expected = (255.0 * (1.0 - f64::from(k) / f64::from(samples)) + 0.5).floor() as u8;
                assert_eq!(found, expected, "{k}/{samples} covered");
            }
        }
    }
}

#[test]
fn of_equal_depths_the_first_stays_and_a_nearer_one_wins() {
    let square = |z: f32, color: Rgba| {
        let corners = vec![[0.0, 0.0, z], [4.0, 0.0, z], [4.0, 4.0, z], [0.0, 4.0, z]];
        surface(corners, vec![[0, 1, 2], [0, 2, 3]], Base::Solid(color))
    };
    let red = Rgba::rgb(255, 0, 0);
    let middle = |surfaces: Vec<Surface>| rgb(&paint(&drawing(4, 4, Samples::One, surfaces)), 2, 1);
    assert_eq!(middle(vec![square(0.5, red), square(0.5, BLACK)]), [255, 0, 0]);
    assert_eq!(middle(vec![square(0.5, BLACK), square(0.5, red)]), [0, 0, 0]);
    assert_eq!(middle(vec![square(0.5, red), square(0.25, BLACK)]), [255, 0, 0]);
    assert_eq!(middle(vec![square(0.5, red), square(0.75, BLACK)]), [0, 0, 0]);
    // The far plane itself is in front of nothing at all.
    assert_eq!(middle(vec![square(0.0, red)]), [255, 0, 0]);
    // Without the test the last one stays.
    let mut untested = square(0.25, BLACK);
    untested.depth_test = false;
    assert_eq!(middle(vec![square(0.5, red), untested]), [0, 0, 0]);
}

#[test]
fn a_missing_size_is_none() {
    let mut rasterizer = Rasterizer::default();
    for (width, height) in [(0, 10), (10, 0), (0, 0), (MAX_SIDE + 1, 1), (1, u32::MAX), (MAX_SIDE, MAX_SIDE)] {
        assert!(rasterizer.paint(&drawing(width, height, Samples::One, Vec::new())).is_none(), "{width}×{height}");
        let mut pixmap = Pixmap::new(3, 3).expect("a pixmap");
        assert!(!at_once(rasterizer.paint_into(&drawing(width, height, Samples::One, Vec::new()), &mut pixmap)));
        assert_eq!(pixmap.width(), 3);
    }
    assert_eq!(paint(&drawing(1, 1, Samples::Sixteen, Vec::new())).pixel(0, 0).map(|p| p.red()), Some(255));
}

#[test]
fn nonsense_is_left_out_without_harm() {
    let bad = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30, -1e30, f32::MAX, 30_000.0, -5000.0];
    let bases = [
        Base::Solid(BLACK),
        Base::Faces(Vec::new()),
        Base::Vertices(vec![BLACK; 2]),
        Base::Texture {
            image: Arc::new(Texture::flat(0, 7, Vec::new())),
            sampler: Sampler::PICTURE,
            uv: Vec::new(),
            tint: BLACK.with_alpha(9),
            tints: Vec::new(),
        },
        Base::Texture {
            image: Arc::new(Texture::flat(9, 9, vec![1; 5])),
            sampler: Sampler::PICTURE,
            uv: vec![[f32::NAN, 1e30]; 4],
            tint: BLACK,
            tints: vec![BLACK; 2],
        },
        Base::Texture {
            image: Arc::new(Texture::flat(9, 9, vec![1; 5]).with_levels()),
            sampler: Sampler::default(),
            uv: vec![[f32::NAN, f32::INFINITY], [1e30, -1e30], [f32::MAX, f32::MIN], [0.0, -0.0]],
            tint: BLACK,
            tints: vec![BLACK; 4],
        },
    ];
    let lit = PixelLight { normals: Vec::new(), positions: Vec::new(), lighting: Lighting::default() };
    let long = PixelLight { normals: vec![[f32::NAN; 3]; 4], positions: vec![[1e30; 3]; 4], ..lit.clone() };
    let lights = [
        SurfaceLight::InBase,
        SurfaceLight::Faces(Vec::new()),
        SurfaceLight::Vertices(vec![[f32::NAN, 1e30]; 4]),
        SurfaceLight::PerPixel(lit),
        SurfaceLight::PerPixel(long),
    ];
    for (base, light) in bases.iter().flat_map(|base| lights.iter().map(move |light| (base, light))) {
        for value in bad {
            for slot in 0..3 {
                for translucent in [false, true] {
                    let mut positions = vec![[1.0, 1.0, 0.5], [9.0, 1.0, 0.5], [1.0, 9.0, 0.5], [4.0, 4.0, 0.5]];
                    positions[1][slot] = value;
                    let triangles = vec![[0, 1, 2], [0, 2, 3], [0, 1, 77], [u32::MAX; 3], [3, 3, 3]];
                    let mut s = surface(positions, triangles, base.clone());
                    s.light = light.clone();
                    s.translucent = translucent;
                    s.inverse_w = vec![1.0, value, 0.0, -1.0];
                    for antialias in Samples::ALL {
                        paint(&drawing(10, 10, antialias, vec![s.clone()]));
                    }
                    s.inverse_w = vec![1.0];
                    paint(&drawing(10, 10, Samples::One, vec![s]));
                }
            }
        }
    }
}
