//! Visible surfaces: painter, BSP, depth buffers, against ray casting in high precision.
//!
//! The error is the share of pixels that show another surface than the one that the ray through their centre meets
//! first. B is 100; F is B over the parameter.

use std::mem::size_of;

use glam::DVec3;

use super::figure_with;
use super::painter::{Painter, flat, triangle};
use crate::appearance::{Rgba, Samples, Visibility};
use crate::camera::{Camera, Parameters, Projection};
use crate::chain::Vector;
use crate::chain::real::Real;
use crate::numbers::random::Random;
use crate::numerics::depth_format::{Format, Range};
use crate::numerics::measure::{Off, Trial, Watch};
use crate::numerics::reference::Reference;
use crate::numerics::{Findings, Group, Lab, OWN, Study, Unit};
use crate::progress::pause;
use crate::scene::{ObjectSpec, Scene, Shape};

const FAR: f64 = 100.0;
const RATIOS: [f64; 4] = [10.0, 1e3, 1e5, 1e7];
const SIZE: [u32; 2] = [96, 72];

type Triangle = [DVec3; 3];
type Triangles = fn(&mut Random) -> Vec<Triangle>;

const CASES: [(&str, Triangles); 3] =
    [("cyclic overlap", cyclic), ("interpenetrating", interpenetrating), ("close surfaces", close)];

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let (count, ratios) = (lab.many(3, 1), &RATIOS[..lab.many(4, 3)]);
    let watch = lab.watch(CASES.len() * ratios.len() * METHODS.len(), count);
    let mut rows = Vec::new();
    for (c, (case, triangles)) in CASES.into_iter().enumerate() {
        for &ratio in ratios {
            if lab.progress.is_cancelled() {
                break;
            }
            // The same surfaces for every ratio.
            let mut random = Random::new(lab.effort.seed, 600 + c as u64);
            let mut setups = Vec::new();
            for _ in 0..count {
                setups.extend(Setup::new(triangles(&mut random), ratio).await);
            }
            let measure = |method: &Seen, input, setup: &Setup, trial: &mut Trial| {
                let seen = method(setup, trial, &watch);
                if trial.is_first() {
                    trial.note(input, setup.off(&seen));
                }
            };
            let methods = lab.methods(&METHODS, &setups, measure).await;
            let group = Group { case: case.to_owned(), parameter: ratio, unit: Unit::Share, methods };
            rows.extend(group.rows(Study::Visibility, |input| setups.get(input).map(Setup::figure)));
        }
    }
    let working_set = (SIZE[0] * SIZE[1]) as usize * size_of::<u64>();
    Findings { study: Study::Visibility, reference: "ray casting in 512 bits", working_set, rows }
}

/// Three bars in front of the camera, each over the next. No order of whole faces is right.
fn cyclic(random: &mut Random) -> Vec<Triangle> {
    let turn = random.between(0.0, 2.0);
    (0..3)
        .flat_map(|k| {
            let angle = turn + std::f64::consts::TAU * f64::from(k) / 3.0;
            let (along, across) =
                (DVec3::new(angle.cos(), angle.sin(), 0.0), DVec3::new(-angle.sin(), angle.cos(), 0.0));
            let middle = DVec3::new(0.0, 0.0, -30.0) + across * 3.0;
            let (half, tilt, wide) = (along * 10.0, DVec3::Z * 2.0, across * 1.2);
            let [a, b] = [middle - half - tilt, middle + half + tilt];
            [[a - wide, b - wide, b + wide], [a - wide, b + wide, a + wide]]
        })
        .collect()
}

/// Large triangles through one another.
fn interpenetrating(random: &mut Random) -> Vec<Triangle> {
    let place = |random: &mut Random| {
        DVec3::new(random.between(-14.0, 14.0), random.between(-10.0, 10.0), random.between(-45.0, -20.0))
    };
    (0..12).map(|_| std::array::from_fn(|_| place(random))).collect()
}

/// Two walls, tilted alike, a ten-thousandth of their depth apart, each in front of the other in one half.
fn close(random: &mut Random) -> Vec<Triangle> {
    let (a, b) = (random.between(-0.3, 0.3), random.between(-0.3, 0.3));
    let wall =
        |sign: f64| move |x: f64, y: f64| DVec3::new(x, y, -50.0 + a * x + b * y + sign * 0.0025 * (x / 10.0 + 0.3));
    let of = |sign| {
        let at = wall(sign);
        let [p, q, r, s] = [at(-24.0, -18.0), at(24.0, -18.0), at(24.0, 18.0), at(-24.0, 18.0)];
        [[p, q, r], [p, r, s]]
    };
    [of(1.0), of(-1.0)].concat()
}

/// Surfaces, the camera, and the truly visible surfaces.
struct Setup {
    parameters: Parameters,
    camera: Camera,
    triangles: Vec<Triangle>,
    scene: Scene,
    /// In view space, on the plane z = −1, of each pixel's centre.
    rays: Vec<DVec3>,
    exact: Vec<Option<usize>>,
}

impl Setup {
    /// The camera is at the origin and looks along −z, so world and view space are the same. Pauses after each row of
    /// rays.
    async fn new(triangles: Vec<Triangle>, ratio: f64) -> Option<Self> {
        let [m, n] = SIZE.map(f64::from);
        let parameters = Parameters {
            position: DVec3::ZERO,
            focal_point: DVec3::new(0.0, 0.0, -30.0),
            view_angle: 40.0,
            aspect: m / n,
            near: FAR / ratio,
            far: FAR,
            ..Parameters::default()
        };
        let camera = Camera::new(&parameters).ok()?;
        let objects = triangles.iter().enumerate().map(|(i, &t)| triangle(t, color(i))).collect();
        let scene = Scene { objects, ..Scene::default() };
        // tan(θ/2) in the reference. The centres of pixels are fractions of few digits.
        let (sine, cosine) = Reference::sin_cos_degrees(20.0);
        let half = sine / cosine;
        let solids: Vec<RayTriangle> = triangles.iter().map(RayTriangle::new).collect();
        let (mut rays, mut exact) = (Vec::new(), Vec::new());
        for j in 0..SIZE[1] {
            for i in 0..SIZE[0] {
                let x = (f64::from(i) + 0.5) * 2.0 / m - 1.0;
                let y = 1.0 - (f64::from(j) + 0.5) * 2.0 / n;
                let aspect = Reference::of(m) / Reference::of(n);
                let ray = Vector([
                    Reference::of(x) * half.clone() * aspect,
                    Reference::of(y) * half.clone(),
                    Reference::of(-1.0),
                ]);
                exact.push(first(&solids, &ray, &parameters));
                rays.push(ray.to_f64());
            }
            pause().await;
        }
        Some(Self { parameters, camera, triangles, scene, rays, exact })
    }

    fn off(&self, seen: &[Option<usize>]) -> Off {
        // The two triangles of a wall or bar are one surface where they meet, so either of them is right in a pixel on
        // their seam.
        let surface = |index: &Option<usize>| index.map(|i| color(i).g);
        let wrong = self.exact.iter().zip(seen).filter(|(a, b)| surface(a) != surface(b)).count();
        let error = wrong as f64 / self.exact.len() as f64;
        Off { error, bits: 64.0 * error }
    }

    fn figure(&self) -> String {
        let edges = |[a, b, c]: Triangle| vec![[a, b], [b, c], [c, a]];
        let objects =
            self.triangles.iter().enumerate().map(|(i, &t)| {
                ObjectSpec::new(format!("triangle {}", i + 1), Shape::Segments(edges(t))).colored(color(i))
            });
        figure_with(&self.parameters, objects.collect())
    }
}

/// The colour of a triangle: its number in red, that of its surface in green.
fn color(index: usize) -> Rgba {
    #[expect(clippy::cast_possible_truncation, reason = "a dozen triangles")]
    let index = index as u8;
    Rgba::rgb(40 + 10 * index, 40 + 10 * (index / 2), 200)
}

/// A triangle ready for rays from the origin.
struct RayTriangle {
    corners: [Vector<Reference>; 3],
    /// a × b, b × c, c × a. The ray is inside if its products with them are all positive or all negative.
    sides: [Vector<Reference>; 3],
    normal: Vector<Reference>,
    sides_f64: [DVec3; 3],
}

impl RayTriangle {
    fn new(corners: &Triangle) -> Self {
        let [a, b, c] = corners.map(Vector::<Reference>::of);
        let sides = [a.cross(&b), b.cross(&c), c.cross(&a)];
        let normal = b.minus(&a).cross(&c.minus(&a));
        let sides_f64 = [sides[0].to_f64(), sides[1].to_f64(), sides[2].to_f64()];
        Self { corners: [a, b, c], sides, normal, sides_f64 }
    }

    /// The depth at which the ray meets it.
    fn hit(&self, ray: &Vector<Reference>) -> Option<Reference> {
        let near_ray = ray.to_f64();
        // A plain miss needs no more digits.
        let products = self.sides_f64.map(|side| side.dot(near_ray) / side.length());
        if products.iter().any(|&x| x > 1e-9) && products.iter().any(|&x| x < -1e-9) {
            return None;
        }
        let zero = Reference::zero();
        let products: Vec<Reference> = self.sides.iter().map(|side| side.dot(ray)).collect();
        let inside = products.iter().all(|x| *x >= zero) || products.iter().all(|x| *x <= zero);
        let slope = self.normal.dot(ray);
        (inside && slope != zero).then(|| self.normal.dot(&self.corners[0]) / slope)
    }
}

/// The triangle that a ray meets first between F and B.
fn first(solids: &[RayTriangle], ray: &Vector<Reference>, p: &Parameters) -> Option<usize> {
    let (near, far) = (Reference::of(p.near), Reference::of(p.far));
    let hits = solids.iter().enumerate().filter_map(|(i, solid)| Some((i, solid.hit(ray)?)));
    let hits = hits.filter(|(_, depth)| *depth >= near && *depth <= far);
    let nearest = hits.reduce(|a, b| if b.1 < a.1 { b } else { a });
    nearest.map(|(i, _)| i)
}

type Seen = fn(&Setup, &mut Trial, &Watch) -> Vec<Option<usize>>;

const METHODS: [(&str, Seen); 5] = [
    ("painter", |setup, trial, watch| picture(setup, Visibility::Painter, trial, watch)),
    ("bsp", |setup, trial, watch| picture(setup, Visibility::Bsp, trial, watch)),
    ("depth buffer 16", |setup, trial, watch| buffered(setup, Format::Fixed16, trial, watch)),
    ("depth buffer 24", |setup, trial, watch| buffered(setup, Format::Fixed24, trial, watch)),
    (OWN, |setup, trial, watch| picture(setup, Visibility::default(), trial, watch)),
];

/// The program's own picture. The time is that of a pixel of the whole picture.
fn picture(setup: &Setup, visibility: Visibility, trial: &mut Trial, watch: &Watch) -> Vec<Option<usize>> {
    let mut painter = Painter::default();
    let style = flat(visibility, Samples::One);
    let mut pixels = Vec::new();
    trial.time_whole(watch, setup.rays.len(), || {
        pixels = painter.paint(&setup.scene, &setup.camera, SIZE, &style);
    });
    let index = |pixel: &Rgba| (0..setup.triangles.len()).find(|&i| color(i) == *pixel);
    pixels.iter().map(index).collect()
}

/// A depth buffer of another format, in double precision except for the stored depths. Of equal depths, the first
/// stays.
fn buffered(setup: &Setup, format: Format, trial: &mut Trial, watch: &Watch) -> Vec<Option<usize>> {
    let (near, far) = (setup.parameters.near, setup.parameters.far);
    let range = Range::from_0_to_1(Projection::Perspective, far / near);
    let mut seen = Vec::new();
    trial.time_whole(watch, setup.rays.len(), || {
        let mut depths = vec![i64::MAX; setup.rays.len()];
        seen = vec![None; setup.rays.len()];
        for (index, &[a, b, c]) in setup.triangles.iter().enumerate() {
            let sides = [a.cross(b), b.cross(c), c.cross(a)];
            let normal = (b - a).cross(c - a);
            for ((ray, depth), seen) in setup.rays.iter().zip(&mut depths).zip(&mut seen) {
                let products = sides.map(|side| side.dot(*ray));
                if products.iter().all(|&x| x >= 0.0) || products.iter().all(|&x| x <= 0.0) {
                    let distance = normal.dot(a) / normal.dot(*ray);
                    let value = format.value(&range, distance / near);
                    if distance >= near && distance <= far && value < *depth {
                        (*depth, *seen) = (value, Some(index));
                    }
                }
            }
        }
    });
    seen
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two walls: the nearer one is visible, and a corner that both hide behind each other isn't confused.
    #[test]
    fn the_ray_meets_the_nearer_wall() {
        let wall = |z: f64, x: f64| [DVec3::new(x - 5.0, -5.0, z), DVec3::new(x + 5.0, -5.0, z), DVec3::new(x, 9.0, z)];
        let solids: Vec<RayTriangle> =
            [wall(-20.0, 0.0), wall(-10.0, 0.0), wall(-5.0, 40.0)].iter().map(RayTriangle::new).collect();
        let p = Parameters { near: 1.0, far: 100.0, ..Parameters::default() };
        let ray = Vector::of(DVec3::new(0.0, 0.0, -1.0));
        assert_eq!(first(&solids, &ray, &p), Some(1));
        assert_eq!(first(&solids, &ray, &Parameters { near: 15.0, ..p }), Some(0));
        assert_eq!(first(&solids, &ray, &Parameters { far: 5.0, ..p }), None);
    }
}
