//! Painter and BSP against the depth buffer.

#![expect(clippy::unwrap_used, reason = "tests")]

use camera_lab_engine::appearance::{Dash, HiddenLines, LineStyle, Rgba, Samples, Shading, Style, Visibility};
use camera_lab_engine::camera::{Camera, Parameters, Projection};
use camera_lab_engine::drawing::Drawing;
use camera_lab_engine::pipeline::{Target, draw};
use camera_lab_engine::raster::Rasterizer;
use camera_lab_engine::scene::{Line, Object, ObjectPaint, Scene, primitives};
use glam::{DMat4, DVec3};
use proptest::prelude::*;
use tiny_skia::Pixmap;

use super::common::picture::assert_picture;
use crate::common::any_scene::{any_camera, any_object, reproducible};
use crate::common::scenes::{object, only};

const SMALL: Target = Target { width: 96, height: 72, scale: 1.0, background: Rgba::rgb(255, 255, 255) };

fn paint(drawing: &Drawing) -> Pixmap {
    Rasterizer::default().paint(drawing).unwrap()
}

fn style(visibility: Visibility) -> Style {
    Style { visibility, shading: Shading::Flat, antialias: Samples::One, ..Style::default() }
}

/// Pixels that differ, and how many of them do not touch a change of colour in the first picture.
fn difference(a: &Pixmap, b: &Pixmap) -> (usize, usize) {
    let (w, h) = (a.width() as usize, a.height() as usize);
    let (p, q) = (a.pixels(), b.pixels());
    let edge = |i: usize| {
        let (x, y) = (i % w, i / w);
        (y.saturating_sub(1)..=(y + 1).min(h - 1))
            .any(|y| (x.saturating_sub(1)..=(x + 1).min(w - 1)).any(|x| p[y * w + x] != p[i]))
    };
    let differ: Vec<usize> = (0..w * h).filter(|&i| p[i] != q[i]).collect();
    (differ.len(), differ.iter().filter(|&&i| !edge(i)).count())
}

/// Three bars, each over the next and under the one before.
fn knot() -> Scene {
    let bar = |k: u32| {
        let turn = DMat4::from_rotation_z(f64::from(k) * std::f64::consts::TAU / 3.0);
        let tilt = DMat4::from_rotation_y(0.35);
        let long = DMat4::from_scale(DVec3::new(1.6, 0.22, 0.05));
        let color = [Rgba::rgb(0, 114, 178), Rgba::rgb(230, 159, 0), Rgba::rgb(0, 158, 115)][k as usize];
        let place = turn * DMat4::from_translation(DVec3::new(0.0, 0.62, 0.0)) * tilt * long;
        Object { paint: ObjectPaint::Solid(color), ..object(primitives::cube(), place) }
    };
    Scene { objects: (0..3).map(bar).collect(), ..Scene::default() }
}

fn before() -> Camera {
    Camera::new(&Parameters {
        position: DVec3::new(0.4, 0.3, 6.0),
        focal_point: DVec3::ZERO,
        view_angle: 36.0,
        near: 1.0,
        far: 20.0,
        ..Parameters::default()
    })
    .unwrap()
}

#[test]
fn a_knot_is_painted_right_by_splitting_and_wrong_by_centroids() {
    let edge = LineStyle {
        color: Rgba::rgb(20, 20, 20),
        width: 1.0,
        dash: Dash::Solid,
        hidden: HiddenLines::Hidden,
        arrow: false,
    };
    let mut scene = knot();
    scene.objects.iter_mut().for_each(|bar| bar.edges = Some(edge));
    let target = Target { width: 160, height: 120, ..SMALL };
    let picture =
        |visibility| paint(&draw(&scene, &before(), target, &Style { antialias: Samples::Four, ..style(visibility) }));
    let (depth, bsp, painter) =
        (picture(Visibility::DepthBuffer), picture(Visibility::Bsp), picture(Visibility::Painter));
    assert_picture("pipeline_knot_bsp", &bsp);
    assert_picture("pipeline_knot_painter", &painter);
    assert_eq!(difference(&depth, &bsp).1, 0);
    assert!(difference(&depth, &painter).1 > 20, "the painter must fail here");
}

#[test]
fn one_convex_thing_is_not_sorted() {
    let scene = only(object(primitives::sphere(8), DMat4::IDENTITY));
    let drawing = draw(&scene, &before(), SMALL, &style(Visibility::Bsp));
    assert!(!drawing.painted_in_order && !drawing.surfaces[0].depth_test);
    let two = Scene { objects: [scene.objects.clone(), knot().objects].concat(), ..Scene::default() };
    assert!(draw(&two, &before(), SMALL, &style(Visibility::Bsp)).painted_in_order);
}

#[test]
fn a_line_behind_painted_faces_is_hidden() {
    let mut scene = knot();
    let hidden = LineStyle {
        color: Rgba::rgb(0, 0, 0),
        width: 2.0,
        dash: Dash::Solid,
        hidden: HiddenLines::Hidden,
        arrow: false,
    };
    scene.lines.push(Line::new(vec![DVec3::new(-2.0, 0.6, -1.0), DVec3::new(2.0, 0.6, -1.0)], hidden));
    let picture = |visibility| paint(&draw(&scene, &before(), SMALL, &style(visibility)));
    let (depth, bsp) = (picture(Visibility::DepthBuffer), picture(Visibility::Bsp));
    assert_eq!(difference(&depth, &bsp).1, 0);
}

proptest! {
    #![proptest_config(reproducible(1))]

    /// Except at edges: if two faces meet or cross, a pixel's centre may lie on either side of the line that they
    /// share. The depth buffer compares depths in single precision. A split has corners on the grid of a 256th of a
    /// pixel, so that its border strays from the line by as much. Such a pixel has a neighbour of another colour. No
    /// other may differ, and not 60 of the 6,912, because a line through the whole picture has 96 and can only go wrong
    /// if it passes a centre by 1/256. Narrow faces, which are all edge, bring some more.
    #[test]
    fn splitting_gives_the_picture_of_the_depth_buffer(
        objects in proptest::collection::vec(any_object(), 2..5),
        camera in any_camera(),
    ) {
        let colors = [Rgba::rgb(0, 114, 178), Rgba::rgb(230, 159, 0), Rgba::rgb(0, 158, 115), Rgba::rgb(204, 121, 167)];
        let apart = |k: usize| DMat4::from_translation(DVec3::new(0.3, 0.21, 0.13) * f64::from(u32::try_from(k).unwrap()));
        let objects = objects.into_iter().zip(colors).enumerate().map(|(k, (thing, color))| Object {
            paint: ObjectPaint::Solid(color),
            edges: None,
            outline: None,
            in_world: None,
            faces: true,
            // Nothing that is pressed flat: a face seen on edge is nothing but edge.
            world_from_object: match thing.world_from_object.determinant().abs() {
                1e-3.. => thing.world_from_object,
                _ => apart(k),
            },
            ..thing
        });
        let scene = Scene { objects: objects.collect(), ..Scene::default() };
        let depth = paint(&draw(&scene, &camera, SMALL, &style(Visibility::DepthBuffer)));
        let bsp = paint(&draw(&scene, &camera, SMALL, &style(Visibility::Bsp)));
        let (differ, inside) = difference(&depth, &bsp);
        prop_assert_eq!(inside, 0, "of {} pixels", differ);
        prop_assert!(differ < 60, "{} pixels differ", differ);
    }
}

#[test]
fn parallel_projection_is_ordered_too() {
    let camera =
        Camera::new(&Parameters { projection: Projection::Parallel, height: 4.0, ..*before().parameters() }).unwrap();
    let picture = |visibility| paint(&draw(&knot(), &camera, SMALL, &style(visibility)));
    assert_eq!(difference(&picture(Visibility::DepthBuffer), &picture(Visibility::Bsp)).1, 0);
}
