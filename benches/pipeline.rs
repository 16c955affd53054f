//! Time of each stage from a scene to its drawing: `cargo bench --no-default-features --bench pipeline [-- WORDS…]`.
//!
//! Each row is about many frames, one made in the memory of the one before, with as many threads as there are. It gives
//! the least time of each stage in milliseconds, of the pipeline, of the raster and of both. "transform" takes a vertex
//! through all spaces, the divide and the viewport included. The first rows draw one bumpy sphere that fills most of
//! the picture, wholly inside, across some planes, and for the most part out of the picture. Then come the same sphere
//! with a picture on it and in the shadow of itself, and its edges alone or with its faces. Others put faces in order,
//! of that sphere and of two tori that are linked, or draw many objects, of which few are in view. The last rows draw
//! the three pictures of the default figure, and of a sphere, and these three at the same time, beside a memory that is
//! cleared and copied. Words choose rows (`1000000 gouraud`).

#![expect(clippy::print_stdout, reason = "a benchmark prints")]

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use camera_lab::appearance::{
    Dash, HiddenLines, LineStyle, Rgba, Sampler, Samples, Shading, Style, Texture, Visibility,
};
use camera_lab::camera::{Camera, Parameters};
use camera_lab::clock;
use camera_lab::figure::Figure;
use camera_lab::picture::{Pixels, Renderer};
use camera_lab::pipeline::{Options, Pipeline, Scenes, Stage, Target};
use camera_lab::progress::{Progress, at_once};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{Light, Mesh, Object, ObjectPaint, Pictured, Scene, Shadows, primitives};
use camera_lab::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_words::{self as words, Lang};
use glam::{DMat4, DVec3};
use tiny_skia::Pixmap;

/// A closed bumpy sphere.
fn mesh(triangles: f64) -> Mesh {
    let mut rows = 2_u32;
    while f64::from(rows + 1) * f64::from(rows + 1) * 4.0 <= triangles {
        rows += 1;
    }
    let columns = 2 * rows;
    let mut mesh = Mesh { closed: true, ..Mesh::default() };
    for i in 0..=rows {
        for j in 0..columns {
            let theta = std::f64::consts::PI * f64::from(i) / f64::from(rows);
            let phi = std::f64::consts::TAU * f64::from(j) / f64::from(columns);
            let out = DVec3::new(theta.sin() * phi.cos(), theta.cos(), -theta.sin() * phi.sin());
            mesh.positions.push(out * (1.0 + 0.02 * (5.0 * theta).sin() * (7.0 * phi).cos()));
            mesh.normals.push(out);
        }
    }
    for i in 0..rows {
        for j in 0..columns {
            let [a, b] = [j, (j + 1) % columns].map(|j| i * columns + j);
            let [c, d] = [a + columns, b + columns];
            mesh.triangles.extend([[a, c, d], [a, d, b]]);
            // Each edge once. At the pole, i = 0, a and b are one point.
            mesh.edges.extend([[a, c], [a, d]].into_iter().chain((i > 0).then_some([a, b])));
        }
    }
    mesh
}

/// A picture of 1024² texels that goes around the sphere four times, with levels of detail.
fn around(mesh: &Mesh) -> Pictured {
    const SIDE: u32 = 1024;
    let channel = |v: u32| u8::try_from(v & 255).unwrap_or_default();
    let texel = |k: u32| [channel(k % SIDE), channel(k / SIDE), channel((k ^ (k / SIDE)) * 8), 255];
    let image = Texture::flat(SIDE, SIDE, (0..SIDE * SIDE).flat_map(texel).collect()).with_levels();
    #[expect(clippy::cast_possible_truncation, reason = "single precision is meant")]
    let turns = |angle: f64| (4.0 * angle / std::f64::consts::TAU) as f32;
    let uv = mesh.normals.iter().map(|n| [turns(n.z.atan2(n.x)), turns(n.y.clamp(-1.0, 1.0).acos())]);
    Pictured {
        image: Arc::new(image),
        sampler: Sampler::default(),
        uv: Arc::new(uv.collect()),
        tint: Rgba::rgb(255, 255, 255),
        tints: Arc::default(),
        translucent: false,
    }
}

/// The timed stages.
const STAGES: [Stage; 7] = [
    Stage::Traverse,
    Stage::Transform,
    Stage::CullFaces,
    Stage::Clip,
    Stage::Light,
    Stage::HiddenSurfaces,
    Stage::Lines,
];

fn object(mesh: Arc<Mesh>, world_from_object: DMat4) -> Object {
    Object::new("thing", mesh, world_from_object, ObjectPaint::Solid(Rgba::rgb(220, 150, 60)))
}

fn scene(objects: Vec<Object>) -> Scene {
    let light = Light::directional(DVec3::new(-1.0, -2.0, -1.5));
    Scene { objects, lights: vec![light], ..Scene::default() }
}

fn parameters(distance: f64, near: f64) -> Parameters {
    let position = DVec3::new(0.6, 0.64, 0.48) * distance;
    Parameters { position, aspect: 1.0, near, view_angle: 40.0, ..Parameters::default() }
}

/// The least of each number over many frames.
struct Least(Vec<f64>);

impl Least {
    fn row(name: &str, frames: usize, mut frame: impl FnMut() -> Vec<f64>) {
        let mut least = Self(frame());
        for _ in 1..frames {
            least.0.iter_mut().zip(frame()).for_each(|(least, time)| *least = least.min(time));
        }
        print!("{name:<38}");
        least.0.iter().for_each(|time| print!(" {:>15.3}", time * 1e3));
        println!();
    }
}

/// Times a scene, with its raster.
fn measure(name: &str, frames: usize, scene: &Scene, parameters: &Parameters, style: &Style) {
    let target = Target { width: 640, height: 640, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
    let (mut pipeline, mut raster) = (Pipeline::default(), Rasterizer::default());
    let (Ok(camera), Some(mut pixmap)) = (Camera::new(parameters), Pixmap::new(target.width, target.height)) else {
        return;
    };
    let options = Options { clock: Some(clock::now), ..Options::default() };
    let scenes = Scenes::from(scene);
    Least::row(name, frames, || {
        let start = Instant::now();
        let frame = pipeline.frame(scenes, &camera, target, style, options);
        let middle = Instant::now();
        at_once(raster.paint_into(&frame.drawing, &mut pixmap));
        let end = Instant::now();
        let stages = STAGES.iter().map(|&stage| frame.report[stage as usize].time.unwrap_or_default());
        stages.chain([middle - start, end - middle, end - start]).map(|time| time.as_secs_f64()).collect()
    });
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let wanted = |name: &str| words.iter().all(|word| name.contains(word.as_str()));
    let style = |shading| Style { shading, antialias: Samples::One, ..Style::default() };
    print!("{:<38}", "least ms");
    STAGES.iter().for_each(|stage| print!(" {:>15}", stage.name()));
    println!(" {:>15} {:>15} {:>15}", "pipeline", "raster", "both");

    for triangles in [1e3, 1e4, 1e5, 1e6] {
        let frames = if triangles > 5e5 { 50 } else { 200 };
        let ball = scene(vec![object(Arc::new(mesh(triangles)), DMat4::from_rotation_x(0.4))]);
        for (shading, name) in [
            (Shading::Wireframe, "wireframe"),
            (Shading::Flat, "flat"),
            (Shading::Gouraud, "gouraud"),
            (Shading::Phong, "phong"),
        ] {
            for (view, distance, near, angle) in
                [("inside", 3.2, 0.5, 40.0), ("crossing", 2.2, 1.4, 40.0), ("zoomed", 2.2, 0.5, 4.0)]
            {
                let name = format!("{triangles} {name} {view}");
                if wanted(&name) {
                    let camera = Parameters { view_angle: angle, ..parameters(distance, near) };
                    measure(&name, frames, &ball, &camera, &style(shading));
                }
            }
        }
    }
    for (shading, of) in [(Shading::Flat, "flat"), (Shading::Gouraud, "gouraud"), (Shading::Phong, "phong")] {
        let mut ball = scene(vec![object(Arc::new(mesh(1e5)), DMat4::from_rotation_x(0.4))]);
        let name = format!("100000 {of} inside, texture");
        if wanted(&name) {
            let mut textured = ball.clone();
            textured.objects[0].paint = ObjectPaint::Texture(around(&textured.objects[0].mesh));
            measure(&name, 200, &textured, &parameters(3.2, 0.5), &style(shading));
        }
        let name = format!("100000 {of} inside, shadows");
        if wanted(&name) {
            ball.lights[0].shadows = Shadows::CAST;
            measure(&name, 200, &ball, &parameters(3.2, 0.5), &style(shading));
        }
    }
    for (hidden, name) in [(HiddenLines::Hidden, "none"), (HiddenLines::Dashed, "dashes")] {
        let name = format!("100000 flat inside, edges, {name} behind");
        if wanted(&name) {
            let mut ball = scene(vec![object(Arc::new(mesh(1e5)), DMat4::from_rotation_x(0.4))]);
            let (color, dash) = (Rgba::rgb(20, 20, 20), Dash::Solid);
            ball.objects[0].edges = Some(LineStyle { color, width: 1.25, dash, hidden, arrow: false });
            measure(&name, 50, &ball, &parameters(3.2, 0.5), &style(Shading::Flat));
        }
    }
    for (visibility, name) in [(Visibility::Painter, "painter"), (Visibility::Bsp, "bsp")] {
        for triangles in [1e3, 1e4] {
            let name = format!("{triangles} {name}");
            if wanted(&name) {
                let ball = scene(vec![object(Arc::new(mesh(triangles)), DMat4::IDENTITY)]);
                measure(&name, 10, &ball, &parameters(3.2, 0.5), &Style { visibility, ..style(Shading::Flat) });
            }
        }
    }
    if wanted("63000 bsp, linked tori") {
        let torus = Arc::new(primitives::torus(178));
        let across = DMat4::from_translation(DVec3::X * 0.35) * DMat4::from_rotation_x(std::f64::consts::FRAC_PI_2);
        let linked =
            scene(vec![object(torus.clone(), DMat4::from_translation(DVec3::X * -0.35)), object(torus, across)]);
        let style = Style { visibility: Visibility::Bsp, ..style(Shading::Flat) };
        measure("63000 bsp, linked tori", 5, &linked, &parameters(4.0, 0.5), &style);
    }
    for side in [10_u32, 32, 100, 316] {
        let name = format!("{} objects, few in view", side * side);
        if wanted(&name) {
            let cube = Arc::new(primitives::cube());
            let place = |k: u32| DVec3::new(f64::from(k % side), 0.0, f64::from(k / side)) * 3.0;
            let objects = (0..side * side).map(|k| object(cube.clone(), DMat4::from_translation(place(k))));
            measure(&name, 50, &scene(objects.collect()), &parameters(8.0, 1.0), &style(Shading::Flat));
        }
    }
    let (mut spheres, figure) = (Figure::default(), Figure::default());
    spheres.camera = parameters(3.2, 0.5);
    spheres.style = style(Shading::Flat);
    let of_file = scene_of(&figure, &mut |_| Ok(Vec::new()), &Progress::default());
    let ball = |triangles| move || Some(scene(vec![object(Arc::new(mesh(triangles)), DMat4::from_rotation_x(0.4))]));
    pictures("default figure", 50, &figure, &wanted, || of_file.ok());
    pictures("100000 triangles", 50, &spheres, &wanted, ball(1e5));
    pictures("1000000 triangles", 20, &spheres, &wanted, ball(1e6));
    at_the_same_time(&figure, &wanted);
}

/// Times the three pictures of a figure side by side, 1920 × 1080 in all, and the time to clear and copy so many pixels
/// in memory.
fn at_the_same_time(figure: &Figure, wanted: &impl Fn(&str) -> bool) {
    let columns = |total: f64| [vec![0.0; STAGES.len() + 2], vec![total]].concat();
    let name = "clear and copy, 1920x1080";
    if wanted(name) {
        let [mut source, mut target] = [vec![0_u32; 1920 * 1080], vec![0_u32; 1920 * 1080]];
        Least::row(name, 200, || {
            let start = Instant::now();
            source.fill(black_box(u32::MAX));
            target.copy_from_slice(black_box(&source));
            black_box(&target);
            columns(start.elapsed().as_secs_f64())
        });
    }
    let name = "default figure, all, 1920x1080";
    let scene = scene_of(figure, &mut |_| Ok(Vec::new()), &Progress::default());
    let (true, Ok(camera), Ok(scene)) = (wanted(name), Camera::new(&figure.camera), scene) else { return };
    let (scene, labels) = (SharedScene::new(scene), words::pictures::labels(Lang::En));
    let size = Size { width: 640, height: 1080, scale: 1.0 };
    let requests = View::ALL.map(|view| Request::of(figure, view, &camera, &scene, labels, size));
    let (mut renderer, mut pictures) = (Renderer::default(), View::ALL.map(|_| Pixels::default()));
    Least::row(name, 100, || {
        let start = Instant::now();
        renderer.forget();
        at_once(renderer.all_into(&requests, &mut pictures));
        columns(start.elapsed().as_secs_f64())
    });
}

/// Times the three pictures of a figure that shows a scene.
fn pictures(
    name: &str,
    frames: usize,
    figure: &Figure,
    wanted: &impl Fn(&str) -> bool,
    scene: impl FnOnce() -> Option<Scene>,
) {
    let names = View::ALL.map(|view| (view, format!("{name}, {}", view.name())));
    if !names.iter().any(|(_, name)| wanted(name)) {
        return;
    }
    let (Ok(camera), Some(scene)) = (Camera::new(&figure.camera), scene()) else { return };
    let scene = SharedScene::new(scene);
    let labels = words::pictures::labels(Lang::En);
    for (view, name) in names.iter().filter(|(_, name)| wanted(name)) {
        let (mut renderer, mut picture) = (Renderer::default(), Pixels::default());
        renderer.measure(Some(clock::now));
        let size = Size { width: 640, height: 640, scale: 1.0 };
        let request = Request::of(figure, *view, &camera, &scene, labels, size);
        Least::row(name, frames, || {
            renderer.forget();
            let Some(account) = at_once(renderer.pixels_into(&request, &mut picture)) else { return Vec::new() };
            let time = |stage: Stage| account.stages[stage as usize].time.unwrap_or_default().as_secs_f64();
            let times = STAGES.map(time);
            let fill = time(Stage::Fill);
            let total = account.total.as_secs_f64();
            times.into_iter().chain([total - fill, fill, total]).collect()
        });
    }
}
