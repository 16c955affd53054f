//! The colours of triangles: blended, between vertices, from textures, in light.

#![expect(clippy::cast_possible_truncation, reason = "small numbers, and bytes of random ones")]

use std::sync::Arc;

use camera_lab_engine::appearance::{Rgba, Sampler, Samples, Texture};
use camera_lab_engine::drawing::{Base, Drawing, Lighting, PixelLight, Surface, SurfaceLight, ViewLight};
use camera_lab_engine::lighting::shade;

use crate::common::triangles::{BLACK, Random, drawing, owns, paint, rgb, surface};

#[test]
fn translucent_surfaces_are_blended_from_back_to_front_whatever_their_order() {
    let square = |z: f32, color: Rgba| {
        let corners = vec![[0.0, 0.0, z], [4.0, 0.0, z], [4.0, 4.0, z], [0.0, 4.0, z]];
        let mut s = surface(corners, vec![[0, 1, 2], [0, 2, 3]], Base::Solid(color));
        s.translucent = !color.is_opaque();
        s
    };
    let (front, back) = (square(0.8, Rgba::rgba(255, 0, 0, 128)), square(0.6, Rgba::rgba(0, 0, 255, 128)));
    let hidden = square(0.2, Rgba::rgba(0, 255, 0, 128));
    let wall = square(0.5, BLACK);
    let middle = |surfaces: Vec<Surface>| rgb(&paint(&drawing(4, 4, Samples::Four, surfaces)), 2, 1);
    // On black: blue 128, then red 128 over it leaves 64 of the blue.
    for order in
        [vec![front.clone(), back.clone(), hidden.clone(), wall.clone()], vec![wall.clone(), hidden, back, front]]
    {
        assert_eq!(middle(order), [128, 0, 64]);
    }
}

#[test]
fn colours_between_vertices_follow_perspective() {
    let (side, triangle) = (64, [[2.0, 3.0, 0.9], [60.0, 10.0, 0.2], [20.0, 62.0, 0.4]]);
    let inverse_w = vec![1.0, 0.1, 0.4];
    let colors = [[250.0, 0.0, 30.0], [0.0, 240.0, 60.0], [10.0, 20.0, 255.0]];
    let rgba = colors.map(|c: [f64; 3]| Rgba::rgb(c[0] as u8, c[1] as u8, c[2] as u8)).to_vec();
    for (inverse_w, w) in [(inverse_w, [1.0, 0.1, 0.4]), (Vec::new(), [1.0; 3])] {
        let mut s = surface(triangle.to_vec(), vec![[0, 1, 2]], Base::Vertices(rgba.clone()));
        s.inverse_w = inverse_w;
        let pixmap = paint(&drawing(side, side, Samples::One, vec![s]));
        let v = triangle.map(|p| [f64::from(p[0]), f64::from(p[1])]);
        let cross =
            |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        for y in 0..side {
            for x in 0..side {
                if !owns(triangle, x, y) {
                    continue;
                }
                let p = [f64::from(x) + 0.5, f64::from(y) + 0.5];
                let b = [cross(v[1], v[2], p) * w[0], cross(v[2], v[0], p) * w[1], cross(v[0], v[1], p) * w[2]];
                let found = rgb(&pixmap, x, y);
                for k in 0..3 {
                    let exact = (0..3).map(|l| b[l] * colors[l][k]).sum::<f64>() / (b[0] + b[1] + b[2]);
                    assert!((f64::from(found[k]) - exact).abs() < 0.51, "({x}, {y}): {found:?}, {exact}");
                }
            }
        }
    }
}

#[test]
fn colours_stay_between_those_of_the_vertices_even_in_slivers_and_at_outer_samples() {
    let mut random = Random(9);
    let mut seen = 0;
    for _ in 0..200 {
        let (a, b) = ([random.unit() * 30.0, random.unit() * 30.0], [random.unit() * 30.0, random.unit() * 30.0]);
        let c = [0.5 * (a[0] + b[0]) + 0.2, 0.5 * (a[1] + b[1])];
        let positions = [a, b, c].map(|p| [p[0], p[1], random.unit()]).to_vec();
        let colors = vec![Rgba::rgb(100, 150, 200), Rgba::rgb(110, 140, 205), Rgba::rgb(105, 160, 210)];
        let mut s = surface(positions, vec![[0, 1, 2]], Base::Vertices(colors));
        s.inverse_w = (0..3).map(|_| 0.1 + random.unit()).collect();
        let mut d = drawing(30, 30, Samples::Four, vec![s]);
        d.background = Rgba::rgba(0, 0, 0, 0);
        for pixel in paint(&d).pixels().iter().filter(|p| p.alpha() > 0) {
            let c = pixel.demultiply();
            // One part in 64 more or less, for the rounding of faint premultiplied colours.
            assert!((98..=112).contains(&c.red()), "{c:?}");
            assert!((138..=162).contains(&c.green()), "{c:?}");
            assert!((198..=212).contains(&c.blue()), "{c:?}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

#[test]
fn a_texture_laid_pixel_on_texel_is_itself() {
    let mut random = Random(10);
    let rgba: Vec<u8> =
        (0..16 * 8).flat_map(|_| [random.next() as u8, random.next() as u8, random.next() as u8, 255]).collect();
    let image = Arc::new(Texture::flat(16, 8, rgba.clone()));
    let corners = vec![[2.0, 1.0, 0.5], [18.0, 1.0, 0.5], [18.0, 9.0, 0.5], [2.0, 9.0, 0.5]];
    let uv = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for translucent in [false, true] {
        let paint_ = Base::Texture {
            image: Arc::clone(&image),
            sampler: Sampler::PICTURE,
            uv: uv.clone(),
            tint: Rgba::rgb(255, 255, 255),
            tints: Vec::new(),
        };
        let mut s = surface(corners.clone(), vec![[0, 1, 2], [0, 2, 3]], paint_);
        s.translucent = translucent;
        let pixmap = paint(&drawing(20, 10, Samples::One, vec![s]));
        for y in 0..8 {
            for x in 0..16 {
                let k = 4 * (16 * y + x) as usize;
                assert_eq!(rgb(&pixmap, x + 2, y + 1), rgba[k..k + 3], "({x}, {y})");
            }
        }
    }
}

#[test]
fn a_white_picture_in_tints_shows_the_colours_of_its_vertices() {
    let image = Arc::new(Texture::flat(2, 2, vec![255; 16]));
    for alpha in [255, 51] {
        let colors = vec![Rgba::rgb(255, 0, 0), Rgba::rgba(0, 255, 0, alpha), Rgba::rgb(0, 0, 255)];
        let painted = |base: Base| {
            let corners = vec![[1.0, 1.0, 0.5], [39.0, 2.0, 0.4], [3.0, 39.0, 0.1]];
            let mut s = surface(corners, vec![[0, 1, 2]], base);
            (s.inverse_w, s.translucent) = (vec![1.0, 0.5, 0.2], alpha < 255);
            paint(&drawing(40, 40, Samples::One, vec![s]))
        };
        let (sampler, uv) = (Sampler::PICTURE, vec![[0.5; 2]; 3]);
        let plain = painted(Base::Vertices(colors.clone()));
        let tint = Rgba::rgb(9, 9, 9);
        let tinted = painted(Base::Texture { image: Arc::clone(&image), sampler, uv, tint, tints: colors });
        for (a, b) in plain.data().iter().zip(tinted.data()) {
            assert!(a.abs_diff(*b) <= 1, "{a} {b}");
        }
    }
}

#[test]
fn a_texture_on_a_slanted_square_converges() {
    // Two columns, black and white: their border is at the middle in space, not on the picture.
    let image = Arc::new(Texture::flat(2, 1, vec![0, 0, 0, 255, 255, 255, 255, 255]));
    let corners = vec![[0.0, 0.0, 0.9], [60.0, 10.0, 0.3], [60.0, 30.0, 0.3], [0.0, 40.0, 0.9]];
    let uv = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut s = surface(
        corners,
        vec![[0, 1, 2], [0, 2, 3]],
        Base::Texture { image, sampler: Sampler::PICTURE, uv, tint: Rgba::rgb(255, 255, 255), tints: Vec::new() },
    );
    // Left edge at distance 1, right edge at 2 (half as high): the middle is at x = 60 · (1/2)/(1/2 + 1)… = 40.
    s.inverse_w = vec![1.0, 0.5, 0.5, 1.0];
    let pixmap = paint(&drawing(60, 40, Samples::One, vec![s]));
    for y in [12, 20, 28] {
        let first = (0..60).find(|&x| rgb(&pixmap, x, y)[0] >= 128).expect("the white half");
        assert_eq!(first, 40, "row {y}");
    }
}

#[test]
fn light_at_each_pixel_is_the_formula_at_that_pixel_on_every_base() {
    let lighting = Lighting {
        ambient: 0.2,
        diffuse: 0.6,
        specular: 0.3,
        shininess: 20.0,
        distant_viewer: false,
        two_sided: false,
        lights: vec![ViewLight::point([1.0, 2.0, 3.0])],
    };
    let color = Rgba::rgb(200, 120, 60);
    let (normals, positions) = (
        vec![[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, 0.6, 0.8]],
        vec![[-1.0, -1.0, -4.0], [1.0, -1.0, -5.0], [0.0, 1.0, -6.0]],
    );
    let light = PixelLight { normals: normals.clone(), positions: positions.clone(), lighting: lighting.clone() };
    let triangle = [[0.0, 0.0, 0.5], [32.0, 0.0, 0.5], [0.0, 32.0, 0.5]];
    let image = |alpha: u8| {
        let texel = [color.r, color.g, color.b, 255].map(|c| (u16::from(c) * u16::from(alpha) / 255) as u8);
        Arc::new(Texture::flat(2, 1, texel.repeat(2)))
    };
    let bases = |alpha: u8| {
        let color = color.with_alpha(alpha);
        [
            Base::Solid(color),
            Base::Faces(vec![color]),
            Base::Vertices(vec![color; 3]),
            Base::Texture {
                image: image(alpha),
                sampler: Sampler::PICTURE,
                uv: vec![[0.0; 2], [1.0, 0.0], [0.0, 1.0]],
                tint: Rgba::rgb(255, 255, 255),
                tints: Vec::new(),
            },
            Base::Texture {
                image: image(255),
                sampler: Sampler::PICTURE,
                uv: vec![[0.5; 2]; 3],
                tint: Rgba::rgba(255, 255, 255, alpha),
                tints: Vec::new(),
            },
        ]
    };
    for (base, alpha) in [255, 51].into_iter().flat_map(|alpha| bases(alpha).map(|base| (base, alpha))) {
        let mut lit = surface(triangle.to_vec(), vec![[0, 1, 2]], base.clone());
        lit.light = SurfaceLight::PerPixel(light.clone());
        lit.inverse_w = vec![0.25, 0.2, 1.0 / 6.0];
        lit.translucent = alpha < 255;
        let pixmap = paint(&Drawing { background: BLACK, ..drawing(32, 32, Samples::One, vec![lit]) });
        for (x, y) in [(1, 1), (20, 3), (5, 20), (10, 10)] {
            let (s, t) = ((f64::from(x) + 0.5) / 32.0, (f64::from(y) + 0.5) / 32.0);
            let b = [(1.0 - s - t) * 0.25, s * 0.2, t / 6.0];
            let mix = |v: &[[f32; 3]]| -> [f32; 3] {
                std::array::from_fn(|k| {
                    ((0..3).map(|l| b[l] * f64::from(v[l][k])).sum::<f64>() / (b[0] + b[1] + b[2])) as f32
                })
            };
            let exact = shade(&lighting, mix(&normals), mix(&positions), color);
            let found = rgb(&pixmap, x, y);
            for (found, exact) in found.into_iter().zip([exact.r, exact.g, exact.b]) {
                let exact = f64::from(exact) * f64::from(alpha) / 255.0;
                // Half a step for rounding once, and a little more if a colour was premultiplied before.
                assert!((f64::from(found) - exact).abs() <= 1.5, "{base:?} ({x}, {y}): {found} and {exact}");
            }
        }
    }
}
