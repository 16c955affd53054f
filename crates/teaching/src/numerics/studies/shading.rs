//! Flat, Gouraud and Phong shading of a sphere and a torus of 8 … 512 segments, against the true surfaces under the
//! same light.
//!
//! The error is that of the colours in pixels that show both. For silhouettes, it's the share of the pixels that one
//! covers and the other doesn't. Colours are a share of a channel's range.

use std::mem::size_of;

use glam::DVec3;

use super::painter::{Painter, object};
use crate::appearance::{Rgba, Samples, Shading, Style, VertexFormat};
use crate::camera::{Camera, ImageSize, Parameters};
use crate::chain::real::Real;
use crate::chain::{Chain, Vector};
use crate::figure::{Figure, write};
use crate::numerics::measure::{Off, Trial, Watch, bits_off};
use crate::numerics::reference::Reference;
use crate::numerics::{Findings, Group, Lab, Method, OWN, Study, Unit};
use crate::pipeline::reflection::{AMBIENT, DIFFUSE, SHININESS, SPECULAR};
use crate::progress::pause;
use crate::scene::primitives::{self, TORUS_RADIUS, TORUS_TUBE};
use crate::scene::{Light, Mesh, ObjectSpec, Preset, Scene, SceneSpec, Shape};

const SEGMENTS: [u32; 7] = [8, 16, 32, 64, 128, 256, 512];
const SIZE: [u32; 2] = [80, 60];
const COLOR: Rgba = Rgba::rgb(200, 120, 60);
/// The direction of the light.
const LIGHT: DVec3 = DVec3::new(-0.5, -1.0, -0.7);

pub(in crate::numerics) async fn run(lab: &Lab) -> Findings {
    let segments = &SEGMENTS[..lab.many(7, 3)];
    let watch = lab.watch(2 * segments.len() * METHODS.len(), 1);
    let mut rows = Vec::new();
    for solid in [Solid::Sphere, Solid::Torus] {
        if lab.progress.is_cancelled() {
            break;
        }
        let Some(setup) = Setup::new(solid).await else { continue };
        let mut silhouettes = Vec::new();
        for &count in segments {
            let (mut colors, mut outlines) = (Vec::new(), Vec::new());
            let run = async |k: usize, [color, outline]: &mut [Trial; 2]| {
                let pixels = setup.painted(count, METHODS[k], color, &watch);
                if color.is_first() {
                    setup.judge(&pixels, color, outline);
                }
            };
            for ((name, ..), [color, outline]) in METHODS.into_iter().zip(lab.in_turns(METHODS.len(), run).await) {
                colors.push(Method::new(name, color));
                outlines.push(Method::new(name, outline));
            }
            let parameter = f64::from(count);
            let [case, silhouette] = solid.cases();
            let figure = |_| Some(setup.figure(count));
            rows.extend(
                Group { case: case.to_owned(), parameter, unit: Unit::Color, methods: colors }
                    .rows(Study::Shading, figure),
            );
            let group = Group { case: silhouette.to_owned(), parameter, unit: Unit::Share, methods: outlines };
            silhouettes.extend(group.rows(Study::Shading, figure));
        }
        rows.extend(silhouettes);
    }
    let working_set = (SIZE[0] * SIZE[1]) as usize * size_of::<u32>();
    Findings { study: Study::Shading, reference: "ray casting of the true surface in 512 bits", working_set, rows }
}

/// The shadings, with the formats of vertices. The program's own is the default of a figure.
type Shaded = (&'static str, Shading, VertexFormat);

const METHODS: [Shaded; 7] = [
    ("flat", Shading::Flat, VertexFormat::F64),
    ("gouraud", Shading::Gouraud, VertexFormat::F64),
    ("phong", Shading::Phong, VertexFormat::F64),
    ("phong f16", Shading::Phong, VertexFormat::F16),
    ("phong bf16", Shading::Phong, VertexFormat::Bf16),
    ("phong fixed-16.16", Shading::Phong, VertexFormat::Fixed16),
    (OWN, Shading::Flat, VertexFormat::F64),
];

#[derive(Clone, Copy)]
enum Solid {
    Sphere,
    Torus,
}

impl Solid {
    const fn cases(self) -> [&'static str; 2] {
        match self {
            Self::Sphere => ["sphere", "sphere silhouette"],
            Self::Torus => ["torus", "torus silhouette"],
        }
    }

    fn mesh(self, segments: u32) -> Mesh {
        match self {
            Self::Sphere => primitives::sphere(segments),
            Self::Torus => primitives::torus(segments),
        }
    }

    const fn shape(self) -> Shape {
        match self {
            Self::Sphere => Shape::Sphere,
            Self::Torus => Shape::Torus,
        }
    }

    /// The function that's negative inside, for the unit sphere and the torus about y.
    fn value<R: Real>(self, p: &Vector<R>) -> R {
        let square = p.dot(p);
        match self {
            Self::Sphere => square - R::one(),
            Self::Torus => {
                let [x, _, z] = &p.0;
                let (big, small) = (R::of(TORUS_RADIUS), R::of(TORUS_TUBE));
                let ring = big.clone() * big.clone();
                let sum = square + ring.clone() - small.clone() * small;
                sum.clone() * sum - R::of(4.0) * ring * (x.clone() * x.clone() + z.clone() * z.clone())
            }
        }
    }

    /// Its gradient: the normal, outwards, of any length.
    fn normal<R: Real>(self, p: &Vector<R>) -> Vector<R> {
        match self {
            Self::Sphere => p.clone(),
            Self::Torus => {
                let (big, small) = (R::of(TORUS_RADIUS), R::of(TORUS_TUBE));
                let ring = big.clone() * big;
                let sum = p.dot(p) + ring.clone() - small.clone() * small;
                let across = sum.clone() - (ring.clone() + ring);
                let [x, y, z] = p.0.clone();
                Vector([x * across.clone(), y * sum, z * across])
            }
        }
    }
}

/// A solid, the camera, and the true picture.
struct Setup {
    solid: Solid,
    parameters: Parameters,
    camera: Camera,
    /// The colour at each pixel's centre, rounded to bytes as pictures are; `None` means the background.
    exact: Vec<Option<[f64; 3]>>,
}

impl Setup {
    /// Pauses after each row of rays.
    async fn new(solid: Solid) -> Option<Self> {
        let [m, n] = SIZE.map(f64::from);
        let parameters = Parameters {
            position: DVec3::new(0.7, 2.1, 3.1),
            view_angle: 40.0,
            aspect: m / n,
            near: 1.0,
            far: 10.0,
            ..Parameters::default()
        };
        let camera = Camera::new(&parameters).ok()?;
        let chain = Chain::<Reference>::new(&parameters);
        let image = ImageSize { width: SIZE[0], height: SIZE[1] };
        let mut exact = Vec::new();
        for j in 0..SIZE[1] {
            for i in 0..SIZE[0] {
                let [eye, ray] = chain.ray(image, [i, j].map(i64::from));
                exact.push(hit(solid, &eye, &ray).map(|p| color_at(solid, &p, &eye)));
            }
            pause().await;
        }
        Some(Self { solid, parameters, camera, exact })
    }

    fn scene(&self, segments: u32) -> Scene {
        let objects = vec![object(self.solid.mesh(segments), COLOR)];
        Scene { objects, lights: vec![Light::directional(LIGHT)], ..Scene::default() }
    }

    fn painted(&self, segments: u32, method: Shaded, trial: &mut Trial, watch: &Watch) -> Vec<Rgba> {
        let scene = self.scene(segments);
        let (_, shading, vertex_format) = method;
        let style = Style { shading, vertex_format, antialias: Samples::One, ..Style::default() };
        let mut painter = Painter::default();
        let mut pixels = Vec::new();
        trial.time_whole(watch, self.exact.len(), || {
            pixels = painter.paint(&scene, &self.camera, SIZE, &style);
        });
        pixels
    }

    fn judge(&self, pixels: &[Rgba], color: &mut Trial, outline: &mut Trial) {
        let ground = super::painter::BLACK;
        let mut wrong = 0.0;
        for (pixel, exact) in pixels.iter().zip(&self.exact) {
            match exact {
                Some(exact) if *pixel != ground => {
                    for (computed, &exact) in [pixel.r, pixel.g, pixel.b].into_iter().zip(exact) {
                        let (computed, exact) = (f64::from(computed) / 255.0, exact / 255.0);
                        color.note(0, Off { error: (computed - exact).abs(), bits: bits_off(computed, exact) });
                    }
                }
                Some(_) => wrong += 1.0,
                None if *pixel != ground => wrong += 1.0,
                None => {}
            }
        }
        let covered = self.exact.iter().flatten().count().max(1);
        let error = wrong / covered as f64;
        outline.note(0, Off { error, bits: 64.0 * error.min(1.0) });
    }

    fn figure(&self, segments: u32) -> String {
        let solid = ObjectSpec::new(self.solid.cases()[0], self.solid.shape()).colored(COLOR).with_segments(segments);
        let lights = vec![Light::directional(LIGHT)];
        let scene = SceneSpec { preset: Preset::Empty, objects: vec![solid], lights };
        write::to_toml(&Figure { camera: self.parameters, scene, ..Figure::default() })
    }
}

/// Steps along the part of a ray that can meet a solid. Between two of them, a surface of the size of the tube can't be
/// skipped unless the ray grazes it, and there we search for the least value.
const STEPS: u32 = 256;

/// The first point of the solid on a ray.
fn hit(solid: Solid, eye: &Vector<Reference>, ray: &Vector<Reference>) -> Option<Vector<Reference>> {
    let (eye_near, ray_near) = (eye.to_f64(), ray.to_f64());
    let radius = TORUS_RADIUS + TORUS_TUBE + 0.01;
    let middle = -eye_near.dot(ray_near);
    let reach = radius * radius - (eye_near + ray_near * middle).length_squared();
    if reach <= 0.0 {
        return None;
    }
    let (start, length) = (middle - reach.sqrt(), 2.0 * reach.sqrt());
    let value = |t: f64| solid.value(&Vector::<f64>::of(eye_near + ray_near * t));
    let at = |k: u32| start + length * f64::from(k) / f64::from(STEPS);
    let (mut outside, mut inside) = (at(0), None);
    for k in 1..=STEPS {
        let t = at(k);
        if value(t) < 0.0 {
            inside = Some(t);
            break;
        }
        // A valley between three steps may reach below zero.
        if k < STEPS && value(t) < value(outside) && value(t) < value(at(k + 1)) {
            let low = least(&value, outside, at(k + 1));
            if value(low) < 0.0 {
                inside = Some(low);
                break;
            }
        }
        outside = t;
    }
    let mut inside = inside?;
    for _ in 0..60 {
        let middle = f64::midpoint(outside, inside);
        if value(middle) < 0.0 {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    // Newton's method doubles the digits with every step: 50, 100, 200, 400, 800 bits.
    let mut t = Reference::of(outside);
    for _ in 0..5 {
        let p = eye.plus(&ray.times(&t));
        let slope = match solid {
            Solid::Sphere => solid.normal(&p).dot(ray) * Reference::of(2.0),
            Solid::Torus => solid.normal(&p).dot(ray) * Reference::of(4.0),
        };
        t = t - solid.value(&p) / slope;
    }
    Some(eye.plus(&ray.times(&t)))
}

/// The minimum of a function that has one valley between two places.
fn least(value: &impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if value(a) < value(b) {
            high = b;
        } else {
            low = a;
        }
    }
    f64::midpoint(low, high)
}

/// The reflection model of the pictures ([`lighting`](crate::lighting)) at a point of the surface, rounded to a byte.
fn color_at(solid: Solid, p: &Vector<Reference>, eye: &Vector<Reference>) -> [f64; 3] {
    let n = solid.normal(p).unit();
    let to_light = Vector::<Reference>::of(-LIGHT).unit();
    let half = to_light.plus(&eye.minus(p).unit()).unit();
    let zero = Reference::zero;
    let cosine = n.dot(&to_light);
    let lit = cosine > zero();
    let diffuse = if lit { cosine } else { zero() };
    let shine = n.dot(&half);
    let shine = if lit && shine > zero() { shine } else { zero() };
    let shininess = f64::from(SHININESS);
    let mut power = Reference::one();
    let mut left = shininess;
    while left > 0.0 {
        power = power * shine.clone();
        left -= 1.0;
    }
    let share = Reference::of(AMBIENT.into()) + Reference::of(DIFFUSE.into()) * diffuse;
    let white = Reference::of(255.0 * f64::from(SPECULAR)) * power;
    [COLOR.r, COLOR.g, COLOR.b].map(|channel| {
        let value = Reference::of(channel.into()) * share.clone() + white.clone();
        value.to_f64().clamp(0.0, 255.0).round()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_meet_the_true_surfaces_in_all_digits() {
        let meet = |solid, eye: DVec3, ray: DVec3| hit(solid, &Vector::of(eye), &Vector::<Reference>::of(ray).unit());
        let tiny = Reference::of(2f64.powi(-400));
        // The sum of the two radii isn't an f64.
        let outer = Reference::of(TORUS_RADIUS) + Reference::of(TORUS_TUBE);
        for (solid, expected) in [(Solid::Sphere, Reference::one()), (Solid::Torus, outer)] {
            let p = meet(solid, DVec3::new(3.0, 0.0, 0.0), DVec3::NEG_X).expect("a hit");
            assert!(p.minus(&Vector::of(DVec3::X).times(&expected)).length() < tiny);
        }
        // Through the hole of the torus, and past the sphere.
        assert!(meet(Solid::Torus, DVec3::Y * 3.0, DVec3::NEG_Y).is_none());
        assert!(meet(Solid::Sphere, DVec3::new(1.000_001, 3.0, 0.0), DVec3::NEG_Y).is_none());
        assert!(meet(Solid::Sphere, DVec3::new(0.999_999, 3.0, 0.0), DVec3::NEG_Y).is_some());
        let skew = meet(Solid::Torus, DVec3::new(2.0, 1.5, 1.0), DVec3::new(-1.9, -1.4, -0.2)).expect("a hit");
        assert!(Solid::Torus.value(&skew).abs() < tiny);
    }
}
