//! `[reveal]`: the pipeline's inner work in the pictures.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::appearance::{Shading, Style, Theme, Visibility};
use camera_lab::camera::{Parameters, Projection, Viewport};
use camera_lab::figure::{Depth, Figure, Reveal};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{ObjectSpec, Preset as ScenePreset, Shape};
use camera_lab::views::{self, Palette, depth};
use glam::{DVec2, DVec3};
use tiny_skia::Pixmap;

use crate::common::picture::assert_picture;
use crate::views::Pictured;

/// The house from its best side, with its volume close around it.
fn house(reveal: Reveal) -> Figure {
    preset(ScenePreset::House, reveal)
}

fn preset(preset: ScenePreset, reveal: Reveal) -> Figure {
    let mut figure = Figure { camera: preset.camera(), reveal, ..Figure::default() };
    figure.scene.preset = preset;
    figure
}

fn image(pictured: &Pictured) -> Pixmap {
    Rasterizer::default().paint(&views::image::draw(&pictured.setup())).unwrap()
}

fn stored() -> Reveal {
    Reveal { depth: Depth::Stored, ..Reveal::default() }
}

#[test]
fn the_house_as_depths() {
    assert_picture("reveal_depth", &image(&Pictured::of(house(stored()))));
}

#[test]
fn the_corridor_as_distances_in_the_dark_in_portuguese() {
    let mut figure = preset(ScenePreset::Corridor, Reveal { depth: Depth::Linear, ..Reveal::default() });
    figure.style.theme = Theme::Dark;
    assert_picture("reveal_distances_dark", &image(&Pictured::of(figure).in_portuguese()));
}

/// A glass box before the house, which leaves no depth.
fn with_glass(mut figure: Figure) -> Figure {
    figure.scene.objects.push(ObjectSpec {
        name: "glass".to_owned(),
        shape: Some(Shape::Box),
        parent: None,
        translate: DVec3::new(1.5, 1.0, 2.0),
        rotate: DVec3::ZERO,
        scale: DVec3::splat(0.5),
        color: Some("#4477aa80".parse().unwrap()),
        segments: 32,
    });
    figure
}

#[test]
fn the_greys_are_those_of_the_depth_buffer() {
    for (projection, depth) in [Projection::Perspective, Projection::Parallel]
        .into_iter()
        .flat_map(|projection| [(projection, Depth::Stored), (projection, Depth::Linear)])
    {
        let mut figure = with_glass(house(Reveal { depth, ..Reveal::default() }));
        figure.camera.projection = projection;
        figure.style.antialias = 1;
        let camera = figure.camera;
        let nothing = Palette::of(figure.style.theme).nothing;
        let greys = image(&Pictured::of(figure.clone()).bare());
        figure.reveal = Reveal::default();
        let mut rasterizer = Rasterizer::default();
        let colors = Pictured::of(figure).forced();
        rasterizer.paint(&views::image::draw(&colors.setup())).unwrap();
        let (mut levels, mut compared, mut worst) = ([false; 256], 0, 0.0_f64);
        for (i, p) in (0..).zip(greys.pixels()) {
            let found = rasterizer.depth().at(i % 320, i / 320);
            let Some(kept) = found else {
                assert_eq!([p.red(), p.green(), p.blue()], [nothing.r, nothing.g, nothing.b], "{i}");
                continue;
            };
            let z = 1.0 - f64::from(kept);
            let level = match (depth, projection) {
                // z_n = (B + F)/(B − F) − 2 F B/((B − F) d), solved for d.
                (Depth::Linear, Projection::Perspective) => {
                    let (f, b) = (camera.near, camera.far);
                    let d = 2.0 * f * b / ((b + f) - (2.0 * z - 1.0) * (b - f));
                    (d - f) / (b - f)
                }
                _ => z,
            };
            assert_eq!((p.red(), p.red()), (p.green(), p.blue()));
            worst = worst.max((f64::from(p.red()) - 255.0 * level).abs());
            levels[usize::from(p.red())] = true;
            compared += 1;
        }
        assert!(compared > 20_000 && levels.iter().filter(|l| **l).count() > 30);
        assert!(worst < 1.1, "{projection:?}, {depth:?}: {worst} levels");
    }
}

#[test]
fn the_numbers_of_a_pixel_are_those_of_the_notes() {
    let pictured = |projection, range: [f64; 2]| {
        let mut figure = preset(ScenePreset::Cube, stored());
        figure.camera = Parameters {
            position: DVec3::Z * 5.0,
            projection,
            near: 2.0,
            far: 8.0,
            height: 4.0,
            ..Parameters::default()
        };
        let [depth_near, depth_far] = range;
        figure.viewport = Some(Viewport { depth_near, depth_far, ..Viewport::whole(figure.image) });
        Pictured::of(figure)
    };
    // The cube's front face is z = 1, 4 units from C: 10/6 − 32/(6 · 4) = 1/3, or 2 · 2/6 − 1 = −1/3.
    for (projection, ndc_z) in [(Projection::Perspective, 1.0 / 3.0), (Projection::Parallel, -1.0 / 3.0)] {
        for [n, f] in [[0.0, 1.0], [0.2, 0.8], [1.0, 0.0]] {
            let pictured = pictured(projection, [n, f]);
            let reading = depth::reading(&pictured.setup(), DVec2::new(0.1, 0.05)).unwrap();
            assert!((reading.distance - 4.0).abs() < 1e-14, "{reading:?}");
            assert!((reading.ndc_z - ndc_z).abs() < 1e-14, "{reading:?}");
            assert!((reading.z - (n + (f - n) * (ndc_z + 1.0) / 2.0)).abs() < 1e-14, "{reading:?}");
        }
    }
    let window = pictured(Projection::Perspective, [0.0, 1.0]);
    assert_eq!(depth::reading(&window.setup(), DVec2::new(-1.0, 0.8)), None, "beside the cube");
}

#[test]
fn the_numbers_are_those_of_the_picture_and_glass_has_none() {
    let mut figure = with_glass(house(Reveal::default()));
    figure.style.antialias = 1;
    let pictured = Pictured::of(figure.clone()).forced();
    let mut rasterizer = Rasterizer::default();
    rasterizer.paint(&views::image::draw(&pictured.setup())).unwrap();
    let window = camera_lab::camera::Camera::new(&figure.camera).unwrap().window();
    let (mut same, mut all) = (0, 0);
    for (i, j) in (0..240).step_by(7).flat_map(|j| (0..320).step_by(7).map(move |i| (i, j))) {
        let share = (DVec2::new(f64::from(i), f64::from(j)) + 0.5) / DVec2::new(320.0, 240.0);
        let point = DVec2::new(window.left + share.x * window.width(), window.top - share.y * window.height());
        let reading = depth::reading(&pictured.setup(), point).map(|reading| reading.z);
        let kept = rasterizer.depth().at(i, j).map(|kept| 1.0 - f64::from(kept));
        all += 1;
        same += i32::from(match (reading, kept) {
            (None, None) => true,
            (Some(a), Some(b)) => (a - b).abs() < 1e-3,
            _ => false,
        });
    }
    // At silhouettes the picture's grid of subpixels decides.
    assert!(same > all - all / 100, "{same} of {all}");
}

/// Both ways, all three pictures give the same bytes.
#[track_caller]
fn assert_forced_is_the_same(figure: &Figure, what: &str) {
    use camera_lab::views::observer::Preset;
    let draw = |pictured: &Pictured| {
        [views::image::draw(&pictured.setup()), pictured.canonical(Preset::Iso), pictured.world(Preset::Iso)]
            .map(|drawing| Rasterizer::default().paint(&drawing).unwrap().take())
    };
    let pictured = || Pictured::of(figure.clone()).sized(160, 120);
    assert!(draw(&pictured()) == draw(&pictured().forced()), "{what}");
}

#[test]
fn whatever_is_revealed_the_plan_changes_no_pixel() {
    let reveals = [stored(), Reveal { depth: Depth::Linear, ..Reveal::default() }];
    let styles = [Shading::Wireframe, Shading::Flat, Shading::Gouraud, Shading::Phong];
    for reveal in reveals {
        for (scene, shading, visibility) in [
            (ScenePreset::Cube, styles[0], Visibility::DepthBuffer),
            (ScenePreset::Cube, styles[1], Visibility::DepthBuffer),
            (ScenePreset::House, styles[2], Visibility::Painter),
            (ScenePreset::Primitives, styles[3], Visibility::DepthBuffer),
            (ScenePreset::Corridor, styles[1], Visibility::Bsp),
        ] {
            let mut figure = preset(scene, reveal);
            figure.style = Style { shading, visibility, antialias: 1, ..Style::default() };
            assert_forced_is_the_same(&figure, &format!("{reveal:?}, {scene:?}, {shading:?}, {visibility:?}"));
        }
    }
}
