//! Clipping and rasterizing: any triangles before any camera give a picture.

use std::fmt::Write as _;

use camera_lab::appearance::{Rgba, Samples, Style, Visibility};
use camera_lab::camera::{Camera, Parameters, Projection};
use camera_lab::figure::Figure;
use camera_lab::pipeline::stroke_order::painted_runs;
use camera_lab::pipeline::{Options, Output, Pipeline, Target};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{ObjectSpec, Preset, SceneSpec, Shape, build};
use glam::DVec3;

/// Tries one input.
pub fn run(bytes: &[u8]) {
    let Some((choices, bytes)) = bytes.split_at_checked(2) else { return };
    let mut numbers = bytes.chunks_exact(4).map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])));
    let mut vector = || Some(DVec3::new(numbers.next()?, numbers.next()?, numbers.next()?));
    let (Some(position), Some(focal_point), Some(planes)) = (vector(), vector(), vector()) else { return };
    let parameters = Parameters {
        position,
        focal_point,
        near: planes.x.abs(),
        far: planes.x.abs() + planes.y.abs(),
        view_angle: planes.z.abs() % 180.0,
        projection: if choices[0] % 2 == 0 { Projection::Perspective } else { Projection::Parallel },
        ..Parameters::default()
    };
    let Ok(camera) = Camera::new(&parameters) else { return };
    let mut obj = String::new();
    let mut points = 0;
    while let Some(p) = vector() {
        let _ = writeln!(obj, "v {:?} {:?} {:?}", p.x, p.y, p.z);
        points += 1;
    }
    for i in 3..=points {
        let _ = writeln!(obj, "f {} {} {i}", i - 2, i - 1);
    }
    let mesh = ObjectSpec::new("m", Shape::Mesh { path: "m.obj".to_owned() });
    let spec = SceneSpec { preset: Preset::Empty, objects: vec![mesh], lights: Vec::new() };
    let visibility = [Visibility::DepthBuffer, Visibility::Painter, Visibility::Bsp][usize::from(choices[1] % 3)];
    let style = Style { visibility, antialias: Samples::One, ..Figure::default().style };
    let Ok(scene) = build(&spec, &style, &mut |_| Ok(obj.clone().into_bytes())) else { return };
    let target = Target { width: 64, height: 48, scale: 1.0, background: Rgba::rgb(255, 255, 255) };
    for output in [Output::Pixels, Output::Vectors] {
        let options = Options { output, ..Options::default() };
        let drawing = Pipeline::default().frame(&scene, &camera, target, &style, options).drawing;
        assert!(Rasterizer::default().paint(&drawing).is_some());
        for run in painted_runs(&drawing).into_iter().flatten() {
            assert!(run.points.len() >= 2 && run.points.iter().flatten().all(|v| v.is_finite()));
        }
    }
}
