//! Crates drawing the same mesh with the same camera: `compare FIGURE.toml CAMERA_LAB CRATE [FRAMES]`
//!
//! `euc` and `retrofire` draw its faces. A frame is: clear colour and depth, draw. `vello_cpu` and `tiny-skia` draw its
//! edges as smooth strokes, each singly or, with `-one` after the name, all as one path. The ends of the strokes are
//! computed beforehand. All draw on one thread into a buffer in memory, in which their users read the pixels. Prints
//! one JSON object in the form of `camera-lab bench`.

use std::process::Command;
use std::time::Instant;

use retrofire_core::geom::{Vertex, tri};
use retrofire_core::math::{Color3f, ProjVec3, rgb};
use retrofire_core::render::raster::Frag;
use retrofire_core::render::target::{Colorbuf, Framebuf};
use retrofire_core::render::{Context, render, shader};
use retrofire_core::util::Buf2;

const COLOR: [f32; 3] = [0x44 as f32 / 255.0, 0x77 as f32 / 255.0, 0xaa as f32 / 255.0];

/// The mesh and camera that both crates draw.
struct Job {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    triangles: Vec<[usize; 3]>,
    /// Rows of the matrix that takes world points to clip space.
    clip_from_world: [[f32; 4]; 4],
    to_light: [f32; 3],
    width: usize,
    height: usize,
}

impl Job {
    fn clip(&self, p: [f32; 3]) -> [f32; 4] {
        self.clip_from_world.map(|r| r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3])
    }

    fn light(&self, n: [f32; 3]) -> f32 {
        let dot = n[0] * self.to_light[0] + n[1] * self.to_light[1] + n[2] * self.to_light[2];
        0.3 + 0.7 * dot.max(0.0)
    }
}

fn read_job(figure_path: &str, binary: &str) -> Job {
    let text = std::fs::read_to_string(figure_path).expect("the figure can be read");
    let figure: toml::Value = toml::from_str(&text).expect("the figure is TOML");
    let object = &figure["scene"]["objects"][0];
    let folder = std::path::Path::new(figure_path).parent().expect("a figure lies in a folder");
    let obj =
        std::fs::read_to_string(folder.join(object["path"].as_str().expect("a path"))).expect("the mesh can be read");
    let (mut positions, mut normals, mut triangles) = (vec![], vec![], vec![]);
    for line in obj.lines() {
        let mut words = line.split_whitespace();
        let kind = words.next();
        if kind == Some("f") {
            let corners: Vec<usize> = words
                .map(|w| w.split('/').next().and_then(|i| i.parse::<usize>().ok()).expect("an index") - 1)
                .collect();
            triangles.push([corners[0], corners[1], corners[2]]);
        } else {
            let v: Vec<f32> = words.map(|w| w.parse().expect("a number")).collect();
            if kind == Some("v") { positions.push([v[0], v[1], v[2]]) } else { normals.push([v[0], v[1], v[2]]) }
        }
    }
    let out = Command::new(binary).args(["inspect", figure_path, "--format", "json"]).output().expect("inspect runs");
    let report: serde_json::Value = serde_json::from_slice(&out.stdout).expect("inspect prints JSON");
    let row =
        |i: usize| std::array::from_fn(|j| report["view_projection_matrix"][i][j].as_f64().expect("a number") as f32);
    let light = figure["scene"]["lights"][0]["direction"].as_array().expect("a light");
    let light: Vec<f32> = light.iter().map(|x| -x.as_float().expect("a number") as f32).collect();
    let length = light.iter().map(|x| x * x).sum::<f32>().sqrt();
    let side = |k: &str| usize::try_from(figure["image"][k].as_integer().expect("a size")).expect("a size");
    Job {
        positions,
        normals,
        triangles,
        clip_from_world: std::array::from_fn(row),
        to_light: [light[0] / length, light[1] / length, light[2] / length],
        width: side("width"),
        height: side("height"),
    }
}

impl Job {
    /// The two ends of each edge, in pixels.
    fn edges(&self) -> Vec<[f32; 4]> {
        let place = |i: usize| {
            let [x, y, _, w] = self.clip(self.positions[i]);
            [(1.0 + x / w) / 2.0 * self.width as f32, (1.0 - y / w) / 2.0 * self.height as f32]
        };
        let sides = self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let edges: std::collections::BTreeSet<[usize; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        edges
            .into_iter()
            .map(|[a, b]| {
                let ([x, y], [to_x, to_y]) = (place(a), place(b));
                [x, y, to_x, to_y]
            })
            .collect()
    }
}

const STROKE_WIDTH: f32 = 1.25;

/// Times, and how many pixels the strokes have touched.
fn vello_strokes(job: &Job, one: bool, frames: usize) -> (Vec<f64>, usize) {
    use vello_cpu::kurbo::{BezPath, Stroke};
    let edges = job.edges();
    let (width, height) = (job.width as u16, job.height as u16);
    let mut context = vello_cpu::RenderContext::new(width, height);
    let mut resources = vello_cpu::Resources::new();
    let mut target = vello_cpu::Pixmap::new(width, height);
    let times = measure(frames, || {
        context.reset();
        context.set_paint(vello_cpu::color::AlphaColor::<vello_cpu::color::Srgb>::new([COLOR[0], COLOR[1], COLOR[2], 1.0]));
        context.set_stroke(Stroke::new(STROKE_WIDTH.into()));
        let mut path = BezPath::new();
        for &[x, y, to_x, to_y] in &edges {
            path.move_to((f64::from(x), f64::from(y)));
            path.line_to((f64::from(to_x), f64::from(to_y)));
            if !one {
                context.stroke_path(&path);
                path.truncate(0);
            }
        }
        if one {
            context.stroke_path(&path);
        }
        context.flush();
        context.render(&mut target, &mut resources);
    });
    (times, target.data().iter().filter(|p| p.a != 0).count())
}

/// Times, and how many pixels the strokes have touched.
fn tiny_skia_strokes(job: &Job, one: bool, frames: usize) -> (Vec<f64>, usize) {
    use tiny_skia::{Color, Paint, PathBuilder, Pixmap, Stroke, Transform};
    let edges = job.edges();
    let mut target = Pixmap::new(job.width as u32, job.height as u32).expect("a size");
    let mut paint = Paint::default();
    paint.set_color(Color::from_rgba(COLOR[0], COLOR[1], COLOR[2], 1.0).expect("a colour"));
    let stroke = Stroke { width: STROKE_WIDTH, ..Stroke::default() };
    let times = measure(frames, || {
        target.fill(Color::TRANSPARENT);
        let mut builder = PathBuilder::new();
        for &[x, y, to_x, to_y] in &edges {
            builder.move_to(x, y);
            builder.line_to(to_x, to_y);
            if !one {
                let path = std::mem::take(&mut builder).finish();
                // An edge seen from its end has no extent, and no path.
                if let Some(path) = path {
                    target.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
                }
            }
        }
        if let Some(path) = builder.finish() {
            target.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
        }
    });
    (times, target.pixels().iter().filter(|p| p.alpha() != 0).count())
}

impl euc::Pipeline for &Job {
    type Vertex = usize;
    type VsOut = vek::Vec3<f32>;
    type Pixel = u32;

    fn vert(&self, &i: &usize) -> ([f32; 4], Self::VsOut) {
        (self.clip(self.positions[i]), vek::Vec3::from(COLOR) * self.light(self.normals[i]))
    }

    fn frag(&self, c: &Self::VsOut) -> u32 {
        u32::from_be_bytes([255, (c.x * 255.0) as u8, (c.y * 255.0) as u8, (c.z * 255.0) as u8])
    }
}

fn measure(frames: usize, mut frame: impl FnMut()) -> Vec<f64> {
    let mut times: Vec<f64> = (0..frames + 3)
        .map(|_| {
            let start = Instant::now();
            frame();
            1e3 * start.elapsed().as_secs_f64()
        })
        .skip(3)
        .collect();
    times.sort_by(f64::total_cmp);
    times
}

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let job = read_job(&args[1], &args[2]);
    let frames = args.get(4).map_or(60, |n| n.parse().expect("FRAMES is a number"));
    let size = [job.width, job.height];
    let (times, covered) = match args[3].as_str() {
        "euc" => {
            use euc::Pipeline as _;
            use euc::Target as _;
            let indices: Vec<usize> = job.triangles.iter().flatten().copied().collect();
            let mut color = euc::buffer::Buffer2d::new(size, 0u32);
            let mut depth = euc::buffer::Buffer2d::new(size, 1.0f32);
            let times = measure(frames, || {
                color.clear(0);
                depth.clear(1.0);
                (&job).draw::<euc::rasterizer::Triangles<_>, _>(&indices, &mut color, Some(&mut depth));
            });
            (times, color.as_ref().iter().filter(|&&p| p != 0).count())
        }
        "retrofire" => {
            let faces: Vec<_> = job.triangles.iter().map(|t| tri(t[0], t[1], t[2])).collect();
            let indices: Vec<usize> = (0..job.positions.len()).collect();
            let shader = shader::new(
                |i: usize, job: &Job| {
                    let l = job.light(job.normals[i]);
                    let v: Vertex<ProjVec3, Color3f> = Vertex {
                        pos: ProjVec3::from(job.clip(job.positions[i])),
                        attrib: rgb(COLOR[0] * l, COLOR[1] * l, COLOR[2] * l),
                    };
                    v
                },
                |frag: Frag<Color3f>, _: &Job| frag.var.to_color4(),
            );
            let (w, h) = (job.width as f32 / 2.0, job.height as f32 / 2.0);
            let to_screen = retrofire_core::math::Mat4::new([
                [w, 0.0, 0.0, w],
                [0.0, h, 0.0, h],
                [0.0, 0.0, 1.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
            ]);
            let dims = retrofire_core::util::Dims(job.width as u32, job.height as u32);
            let colors: Colorbuf<_, retrofire_core::util::pixfmt::Xrgb8888> = Colorbuf::new(Buf2::<u32>::new(dims));
            let mut target = Framebuf { color_buf: colors, depth_buf: Buf2::<f32>::new(dims) };
            let context = Context::default();
            let times = measure(frames, || {
                target.color_buf.buf.data_mut().fill(0);
                target.depth_buf.data_mut().fill(0.0);
                render(&faces, &indices, &shader, &job, to_screen, &mut target, &context);
            });
            (times, target.color_buf.buf.data().iter().filter(|&&p| p & 0x00ff_ffff != 0).count())
        }
        "vello_cpu" | "vello_cpu-one" => vello_strokes(&job, args[3].ends_with("-one"), frames),
        "tiny-skia" | "tiny-skia-one" => tiny_skia_strokes(&job, args[3].ends_with("-one"), frames),
        other => panic!("unknown crate {other}: euc, retrofire, vello_cpu or tiny-skia"),
    };
    println!(
        "{}",
        serde_json::json!({
            "renderer": args[3], "width": job.width, "height": job.height, "triangles": job.triangles.len(), "frames": frames,
            "median_ms": times[times.len() / 2], "min_ms": times[0], "p95_ms": times[(times.len() - 1) * 95 / 100],
            "covered_pixels": covered,
        })
    );
}
