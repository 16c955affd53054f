//! Time from a scene to its drawing and to its picture: `cargo bench --no-default-features --bench pipeline [-- WORDS…]`.
//!
//! One bumpy sphere fills most of the picture. Each row tells of many frames, with as many threads as there are: the least time of
//! each stage, of the pipeline and of the raster, and least and median of both together. Words choose rows (`1000000 gouraud`).

#![expect(clippy::print_stdout, reason = "a benchmark prints")]

use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

use camera_lab::appearance::{Rgba, Shading, Style};
use camera_lab::camera::{Camera, Parameters};
use camera_lab::pipeline::{Options, Pipeline, Stage, Target};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{Light, Mesh, Object, ObjectPaint, Scene};
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
        }
    }
    mesh
}

fn clock() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let timed = [Stage::Transform, Stage::CullFaces, Stage::Clip, Stage::Light];
    print!("{:>9} {:>8} {:>9}", "triangles", "shading", "view");
    timed.iter().for_each(|stage| print!(" {:>10}", stage.name()));
    println!(" {:>10} {:>10} {:>10} {:>10}", "pipeline", "raster", "both ms", "median");
    let target = Target { width: 640, height: 640, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
    for triangles in [1e3, 1e4, 1e5, 1e6] {
        let mesh = Arc::new(mesh(triangles));
        for (name, shading) in [("flat", Shading::Flat), ("gouraud", Shading::Gouraud)] {
            for (view, distance, near) in [("inside", 3.2, 0.5), ("crossing", 2.2, 1.4)] {
                let row = format!("{triangles} {name} {view}");
                if !words.iter().all(|w| row.contains(w.as_str())) {
                    continue;
                }
                let scene = Scene {
                    objects: vec![Object {
                        name: "sphere".into(),
                        mesh: mesh.clone(),
                        world_from_object: DMat4::from_rotation_x(0.4),
                        paint: ObjectPaint::Solid(Rgba::rgb(220, 150, 60)),
                        lit: true,
                        two_sided: false,
                        faces: true,
                        edges: None,
                    }],
                    lights: vec![Light::Directional { direction: DVec3::new(-1.0, -2.0, -1.5) }],
                    ..Scene::default()
                };
                let camera = Camera::new(&Parameters {
                    position: DVec3::new(0.6, 0.64, 0.48) * distance,
                    aspect: 1.0,
                    near,
                    view_angle: 40.0,
                    ..Parameters::default()
                });
                let Ok(camera) = camera else { continue };
                let style = Style { shading, antialias: 1, ..Style::default() };
                let options = Options { clock: Some(clock), ..Options::default() };
                let (mut pipeline, mut raster) = (Pipeline::default(), Rasterizer::default());
                let Some(mut pixmap) = Pixmap::new(target.width, target.height) else { continue };
                let frames = if triangles > 5e5 { 50 } else { 200 };
                let mut times = vec![Vec::new(); timed.len() + 3];
                for _ in 0..frames {
                    let start = Instant::now();
                    let frame = pipeline.frame(&scene, &camera, target, &style, options);
                    let middle = Instant::now();
                    raster.paint_into(&frame.drawing, &mut pixmap);
                    let end = Instant::now();
                    for (k, stage) in timed.iter().enumerate() {
                        let time = frame.report[*stage as usize].time.unwrap_or_default();
                        times[k].push(time.as_secs_f64() * 1e3);
                    }
                    for (k, time) in [middle - start, end - middle, end - start].into_iter().enumerate() {
                        times[timed.len() + k].push(time.as_secs_f64() * 1e3);
                    }
                    pipeline.recycle(frame.drawing);
                }
                print!("{triangles:>9} {name:>8} {view:>9}");
                times.iter_mut().for_each(|times| times.sort_by(f64::total_cmp));
                times.iter().for_each(|times| print!(" {:>10.3}", times[0]));
                println!(" {:>10.3}", times[timed.len() + 2][frames / 2]);
            }
        }
    }
}
