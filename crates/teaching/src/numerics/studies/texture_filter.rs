//! Filters of a chequered floor against the exact mean of the chequer over each pixel.
//!
//! The error is that of the light, as a share of the way from black to white. A pixel's correct value is a share of
//! white, and light adds up linearly, while bytes don't.

use std::mem::size_of;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::painter::{Painter, flat, object};
use crate::appearance::{Filter, Rgba, Sampler, Samples, Style, Texture, Visibility};
use crate::camera::{Camera, ImageSize, Parameters};
use crate::figure::{Figure, write};
use crate::numbers::random::Random;
use crate::numerics::measure::{Off, Trial, Watch, bits_off};
use crate::numerics::{Findings, Group, Lab, OWN, Row, Study, Unit};
use crate::progress::pause;
use crate::scene::{Mesh, Object, ObjectPaint, ObjectSpec, Pictured, Preset, Scene, SceneSpec, Shape, TextureSource};

const SIZE: [u32; 2] = [48, 36];
/// A side of the texture, and of a square of the chequer, in texels.
const TEXELS: u32 = 64;
const SQUARE: u32 = 4;
/// Squares of the program's own chequer along one side.
const OWN_SQUARES: f64 = 8.0;
/// Texels along a pixel in the middle of the picture: magnified, one to one, minified.
const SCALES: [f64; 4] = [0.125, 1.0, 4.0, 15.0];
/// Angles between the line of sight and the normal of the floor, in degrees.
const TILTS: [(&str, f64); 3] = [("floor from above", 0.0), ("slanted floor", 45.0), ("grazing floor", 75.0)];
const VIEW_ANGLE: f64 = 16.0;
/// From the eye to the middle of the floor, and half a side of the floor.
const DISTANCE: f64 = 3.0;
const HALF: f64 = 10.0;

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let watch = lab.watch(TILTS.len() * SCALES.len() * METHODS.len(), 1);
    let chequer = Arc::new(chequer());
    let mut rows = Vec::new();
    for (c, (case, tilt)) in TILTS.into_iter().enumerate() {
        for (s, scale) in SCALES.into_iter().enumerate() {
            if lab.progress.is_cancelled() {
                break;
            }
            let mut random = Random::new(lab.effort.seed, 900 + (c * SCALES.len() + s) as u64);
            let shift = DVec2::new(random.unit(), random.unit());
            let Some(setup) = Setup::new(tilt, scale, shift).await else { continue };
            let measure = |method: &Way, input, setup: &Setup, trial: &mut Trial| {
                let light = setup.light(*method, &chequer, trial, &watch);
                for (&computed, &exact) in light.iter().zip(&setup.exact).take(trial.to_judge()) {
                    trial.note(input, Off { error: (computed - exact).abs(), bits: bits_off(computed, exact) });
                }
            };
            let methods = lab.methods(&METHODS, std::slice::from_ref(&setup), measure).await;
            let group = Group { case: case.to_owned(), parameter: scale, unit: Unit::Color, methods };
            // Each method has a figure of its own with its filter.
            let of_methods = METHODS.map(|(_, way)| Some(setup.figure(way)));
            rows.extend(
                group
                    .rows(Study::TextureFilter, |_| None)
                    .into_iter()
                    .zip(of_methods)
                    .map(|(row, figure)| Row { figure, ..row }),
            );
        }
    }
    let texels = (TEXELS * TEXELS) as usize;
    let working_set = (texels + texels / 3 + (SIZE[0] * SIZE[1]) as usize) * size_of::<u32>();
    Findings { study: Study::TextureFilter, reference: "exact mean over the pixel in linear light", working_set, rows }
}

#[derive(Clone, Copy)]
enum Way {
    /// One sample of a filter of the program.
    One(Filter),
    /// 4 × 4 samples of the nearest texel, and the mean of their light.
    Sixteen,
    /// The default of a figure.
    Own,
}

impl Way {
    fn filter(self) -> Filter {
        match self {
            Self::One(filter) => filter,
            Self::Sixteen => Filter::Nearest,
            Self::Own => Filter::default(),
        }
    }
}

const METHODS: [(&str, Way); 5] = [
    ("nearest", Way::One(Filter::Nearest)),
    ("bilinear", Way::One(Filter::Bilinear)),
    ("trilinear", Way::One(Filter::Trilinear)),
    ("16 samples of nearest", Way::Sixteen),
    (OWN, Way::Own),
];

/// Black and white squares. The first is white.
fn chequer() -> Texture {
    let square = |i: u32| (i % TEXELS / SQUARE + i / TEXELS / SQUARE).is_multiple_of(2);
    let rgba = (0..TEXELS * TEXELS).flat_map(|i| if square(i) { [255; 4] } else { [0, 0, 0, 255] });
    Texture::flat(TEXELS, TEXELS, rgba.collect()).with_levels()
}

/// A view of the floor y = 0, and the share of white of each pixel.
struct Setup {
    parameters: Parameters,
    camera: Camera,
    /// Texture coordinates for a scene unit, and at the origin.
    per_unit: f64,
    shift: DVec2,
    exact: Vec<f64>,
}

impl Setup {
    /// Pauses after each row of pixels.
    async fn new(tilt: f64, scale: f64, shift: DVec2) -> Option<Self> {
        let [m, n] = SIZE.map(f64::from);
        let (sin, cos) = tilt.to_radians().sin_cos();
        let parameters = Parameters {
            position: DVec3::new(0.0, cos, sin) * DISTANCE,
            focal_point: DVec3::ZERO,
            view_up: DVec3::new(0.0, sin, -cos),
            view_angle: VIEW_ANGLE,
            aspect: m / n,
            near: 0.1,
            far: 4.0 * HALF,
            ..Parameters::default()
        };
        let camera = Camera::new(&parameters).ok()?;
        let pixel = 2.0 * DISTANCE * (VIEW_ANGLE / 2.0).to_radians().tan() / n;
        let per_unit = scale / (pixel * f64::from(TEXELS));
        let mut setup = Self { parameters, camera, per_unit, shift, exact: Vec::new() };
        for j in 0..SIZE[1] {
            for i in 0..SIZE[0] {
                let share = setup.white(f64::from(i), f64::from(j))?;
                setup.exact.push(share);
            }
            pause().await;
        }
        Some(setup)
    }

    /// The place on the chequer, in its squares, at a point of the picture; `None` above the horizon.
    fn place(&self, [x, y]: [f64; 2]) -> Option<DVec2> {
        let (window, basis) = (self.camera.window(), self.camera.basis());
        let u = window.left + (window.right - window.left) * x / f64::from(SIZE[0]);
        let v = window.top + (window.bottom - window.top) * y / f64::from(SIZE[1]);
        let ray = (basis.u * u + basis.v * v) / self.camera.near() - basis.n;
        let eye = self.camera.position();
        let t = -eye.y / ray.y;
        (t > 0.0 && t.is_finite()).then(|| {
            let p = eye + ray * t;
            (DVec2::new(p.x, p.z) * self.per_unit + self.shift) * f64::from(TEXELS / SQUARE)
        })
    }

    /// The point of the picture that shows a place on the chequer, in its squares.
    fn pixel(&self, place: DVec2) -> DVec2 {
        let (window, basis) = (self.camera.window(), self.camera.basis());
        let on_floor = (place / f64::from(TEXELS / SQUARE) - self.shift) / self.per_unit;
        let to = DVec3::new(on_floor.x, 0.0, on_floor.y) - self.camera.position();
        let to_window = self.camera.near() / -to.dot(basis.n);
        let (u, v) = (to.dot(basis.u) * to_window, to.dot(basis.v) * to_window);
        let x = (u - window.left) / (window.right - window.left) * f64::from(SIZE[0]);
        let y = (v - window.top) / (window.bottom - window.top) * f64::from(SIZE[1]);
        DVec2::new(x, y)
    }

    /// The exact share of white of a pixel by its top left corner, from its image on the floor, cut at the lines of the
    /// chequer, and the areas of the white pieces back in the picture.
    fn white(&self, x: f64, y: f64) -> Option<f64> {
        let mut pixel = Vec::with_capacity(4);
        for corner in [[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]] {
            pixel.push(self.place(corner)?);
        }
        let middle = DVec2::new(x + 0.5, y + 0.5);
        let mut sum = 0.0;
        let (low, high) = range(&pixel, 1);
        let mut row = low.floor();
        while row < high {
            let strip = between(&pixel, 1, row);
            let (left, right) = range(&strip, 0);
            let mut column = left.floor();
            while column < right {
                if (row + column).rem_euclid(2.0) == 0.0 {
                    let corners = between(&strip, 0, column);
                    // About the pixel, so that nothing large cancels.
                    let seen: Vec<DVec2> = corners.iter().map(|&p| self.pixel(p) - middle).collect();
                    sum += area(&seen);
                }
                column += 1.0;
            }
            row += 1.0;
        }
        Some(sum.clamp(0.0, 1.0))
    }

    fn floor(&self, chequer: &Arc<Texture>, filter: Filter) -> Object {
        let corners = [[-HALF, -HALF], [-HALF, HALF], [HALF, HALF], [HALF, -HALF]];
        let uv = corners.map(|[x, z]| [x * self.per_unit + self.shift.x, z * self.per_unit + self.shift.y]);
        let uv = uv.map(|uv| uv.map(single)).to_vec();
        let mesh = Mesh {
            positions: corners.map(|[x, z]| DVec3::new(x, 0.0, z)).to_vec(),
            normals: vec![DVec3::Y; 4],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..Mesh::default()
        };
        let sampler = Sampler { filter, ..Sampler::default() };
        let paint = ObjectPaint::Texture(Pictured { sampler, ..Pictured::plain(Arc::clone(chequer), uv, 255) });
        Object { lit: false, two_sided: true, paint, ..object(mesh, Rgba::rgb(0, 0, 0)) }
    }

    /// The light of each pixel, 0 … 1.
    fn light(&self, way: Way, chequer: &Arc<Texture>, trial: &mut Trial, watch: &Watch) -> Vec<f64> {
        let (samples, finer) = match way {
            Way::One(_) => (Samples::One, 1),
            Way::Sixteen => (Samples::One, 4),
            Way::Own => (Style::default().antialias, 1),
        };
        let (filter, style) = (way.filter(), flat(Visibility::default(), samples));
        let scene = Scene { objects: vec![self.floor(chequer, filter)], ..Scene::default() };
        let mut painter = Painter::default();
        let (mut pixels, mut light) = (Vec::new(), Vec::new());
        trial.time_whole(watch, self.exact.len(), || {
            pixels = painter.paint(&scene, &self.camera, SIZE.map(|side| side * finer), &style);
            if finer > 1 {
                light = means(&pixels, finer);
            }
        });
        if finer > 1 { light } else { pixels.iter().map(|pixel| pixel.luminance()).collect() }
    }

    /// The measured picture, apart from its colours. The squares of the program's own chequer lie where those of the
    /// study do.
    fn figure(&self, way: Way) -> String {
        let repeated = DVec2::splat(2.0 * HALF * self.per_unit * f64::from(TEXELS / SQUARE) / OWN_SQUARES);
        // The middle of the floor. The squares of a box are counted from its back left corner.
        let squares_from_middle = 0.5 * OWN_SQUARES * repeated;
        let squares_aside = DVec2::new(1.0, -1.0) * squares_from_middle - self.shift * f64::from(TEXELS / SQUARE);
        let middle = squares_aside.rem_euclid(DVec2::splat(2.0)) * HALF / squares_from_middle;
        let floor = ObjectSpec::new("floor", Shape::Box).at(middle.x, -0.01, middle.y).scaled(HALF, 0.01, HALF);
        let floor = ObjectSpec {
            texture: Some(TextureSource::Chequer),
            filter: Some(way.filter()),
            texture_scale: repeated,
            ..floor
        };
        let scene = SceneSpec { preset: Preset::Empty, objects: vec![floor], ..SceneSpec::default() };
        let image = ImageSize { width: SIZE[0], height: SIZE[1] };
        write::to_toml(&Figure { camera: self.parameters, image, scene, ..Figure::default() })
    }
}

/// The mean light of blocks of `side` × `side` pixels.
fn means(pixels: &[Rgba], side: u32) -> Vec<f64> {
    let [m, n] = SIZE;
    let of = |i: u32, j: u32| {
        let inside = (0..side * side).map(|k| (j * side + k / side) * m * side + i * side + k % side);
        let sum: f64 = inside.filter_map(|k| pixels.get(k as usize)).map(|pixel| pixel.luminance()).sum();
        sum / f64::from(side * side)
    };
    (0..n).flat_map(|j| (0..m).map(move |i| (i, j))).map(|(i, j)| of(i, j)).collect()
}

/// The least and the greatest coordinate along an axis.
fn range(polygon: &[DVec2], axis: usize) -> (f64, f64) {
    polygon.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p[axis]), high.max(p[axis])))
}

/// The part of a convex polygon between `low` and `low` + 1 along an axis.
fn between(polygon: &[DVec2], axis: usize, low: f64) -> Vec<DVec2> {
    let mut kept = polygon.to_vec();
    for (border, sign) in [(low, 1.0), (low + 1.0, -1.0)] {
        let whole = std::mem::take(&mut kept);
        let next = whole.iter().cycle().skip(1);
        for (&a, &b) in whole.iter().zip(next) {
            let (da, db) = ((a[axis] - border) * sign, (b[axis] - border) * sign);
            if da >= 0.0 {
                kept.push(a);
            }
            if (da < 0.0) != (db < 0.0) {
                kept.push(a + (b - a) * (da / (da - db)));
            }
        }
    }
    kept
}

/// The area of a polygon.
fn area(polygon: &[DVec2]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    (polygon.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() / 2.0).abs()
}

#[expect(clippy::cast_possible_truncation, reason = "texture coordinates are single precision in all pictures")]
fn single(x: f64) -> f32 {
    x as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::read::parse;
    use crate::progress::at_once;
    use crate::scene::{build, no_files};

    #[test]
    fn the_share_of_white_is_that_of_many_samples() {
        for (tilt, scale) in [(0.0, 1.0), (45.0, 4.0), (75.0, 4.0)] {
            let setup = at_once(Setup::new(tilt, scale, DVec2::new(0.3, 0.7))).expect("a camera");
            for (i, j) in [(0_u32, 0_u32), (20, 17), (47, 35), (5, 30)] {
                let mut white = 0.0;
                for k in 0..40_000_u32 {
                    let at = |k: u32| (f64::from(k) + 0.5) / 200.0;
                    let p = setup.place([f64::from(i) + at(k % 200), f64::from(j) + at(k / 200)]).expect("the floor");
                    white += f64::from((p.x.floor() + p.y.floor()).rem_euclid(2.0) == 0.0);
                }
                let exact = setup.exact[(j * SIZE[0] + i) as usize];
                assert!((white / 40_000.0 - exact).abs() < 0.006, "{tilt} {scale} {i} {j}: {exact}");
            }
        }
    }

    #[test]
    fn the_squares_of_figure_and_study_lie_in_the_same_places() {
        for (tilt, scale) in [(0.0, 1.0), (45.0, 4.0)] {
            let setup = at_once(Setup::new(tilt, scale, DVec2::new(0.3, 0.7))).expect("a camera");
            let figure = parse(&setup.figure(Way::One(Filter::Nearest))).expect("a figure");
            let scene = build(&figure.scene, &figure.style, &mut no_files).expect("a scene");
            let pixels =
                Painter::default().paint(&scene, &setup.camera, SIZE, &flat(Visibility::default(), Samples::One));
            let is_wrong = |(i, j): (u32, u32)| {
                let place = setup.place([f64::from(i) + 0.5, f64::from(j) + 0.5]).expect("the floor");
                // Within a hundredth of a square of its sides, either square may be hit.
                let is_inside = [place.x, place.y].iter().all(|at| (at - at.round()).abs() > 0.01);
                let white = (place.x.floor() + place.y.floor()).rem_euclid(2.0) == 0.0;
                is_inside && white != (pixels[(j * SIZE[0] + i) as usize].luminance() > 0.2)
            };
            let all = (0..SIZE[1]).flat_map(|j| (0..SIZE[0]).map(move |i| (i, j)));
            assert_eq!(all.filter(|&at| is_wrong(at)).collect::<Vec<_>>(), [], "{tilt} {scale}");
        }
    }
}
