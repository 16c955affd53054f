//! Reference pictures of the three views, each of one thing.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::appearance::Theme;
use camera_lab::camera::{Camera, Operation, Parameters, Projection, ViewWindow};
use camera_lab::drawing::Drawing;
use camera_lab::figure::{Figure, NamedPoint};
use camera_lab::geometry::Angle;
use camera_lab::picture::Renderer;
use camera_lab::raster::Rasterizer;
use camera_lab::scene::Preset as ScenePreset;
use camera_lab::views::observer::Viewpoint;
use camera_lab::views::{self, View};
use glam::{DVec2, DVec3};
use tiny_skia::Pixmap;

use crate::common::picture::assert_picture;
use crate::common::rendered::assert_rendered;
use crate::views::{Pictured, draw, figure};

fn paint(drawing: &Drawing) -> Pixmap {
    Rasterizer::default().paint(drawing).unwrap()
}

/// A figure with F and B such that the volume is seen whole.
fn short(theme: Theme, scene: ScenePreset, change: impl FnOnce(&mut Parameters)) -> Figure {
    let mut figure = figure(|c| {
        (c.near, c.far) = (2.0, 12.0);
        change(c);
    });
    figure.style.theme = theme;
    figure.scene.preset = scene;
    figure
}

#[test]
fn the_world_of_the_default_figure() {
    let pictured = Pictured::of(Figure::default());
    assert_picture("world_default", &paint(&pictured.world(Viewpoint::Iso)));
}

#[test]
fn a_world_with_the_image_on_the_window() {
    let pictured = Pictured::of(short(Theme::Light, ScenePreset::House, |_| {}));
    let world = pictured.seen_by(View::World, pictured.observer(View::World, Viewpoint::Iso));
    assert_rendered("world_painted_window", &Renderer::default().pixels(&world).unwrap());
}

#[test]
fn a_parallel_volume_in_the_dark() {
    let figure = short(Theme::Dark, ScenePreset::House, |c| {
        c.projection = Projection::Parallel;
        c.height = 3.0;
    });
    assert_picture("world_parallel_dark", &paint(&Pictured::of(figure).world(Viewpoint::Iso)));
}

#[test]
fn an_asymmetric_window_for_paper() {
    let figure = short(Theme::Print, ScenePreset::House, |c| {
        c.window = Some(ViewWindow { left: -1.0, right: 0.2, bottom: -0.3, top: 1.2 });
    });
    assert_picture("world_asymmetric_print", &paint(&Pictured::of(figure).world(Viewpoint::Side)));
}

#[test]
fn an_azimuth_while_it_is_tried() {
    let azimuth = Operation::Azimuth(Angle::from_degrees(-50.0));
    let pictured = Pictured::of(short(Theme::Light, ScenePreset::House, |_| {})).tried(azimuth);
    assert_picture("world_ghost_azimuth", &paint(&pictured.world(Viewpoint::Iso)));
}

#[test]
fn the_canonical_volume_and_the_ray_of_a_pixel() {
    let figure = short(Theme::Light, ScenePreset::House, |_| {});
    let pictured = Pictured::of(figure).probed(views::Probe::Window(DVec2::new(0.2, 0.15)));
    assert_picture("canonical_probe", &paint(&pictured.canonical(Viewpoint::Iso)));
}

#[test]
fn the_canonical_volume_from_above() {
    let pictured = Pictured::of(short(Theme::Print, ScenePreset::House, |_| {}));
    assert_picture("canonical_top_print", &paint(&pictured.canonical(Viewpoint::Top)));
}

#[test]
fn an_image_narrower_than_its_picture() {
    let figure = Figure { undistorted: true, ..short(Theme::Dark, ScenePreset::House, |c| c.aspect = 0.8) };
    let pictured = Pictured::of(figure).probed(views::Probe::Window(DVec2::new(0.2, 0.15)));
    assert_picture("image_letterboxed_dark", &paint(&pictured.image()));
}

/// As deep as the range of z_n, its origin on the near face, y_n downwards.
#[test]
fn the_canonical_volume_of_vulkan() {
    let figure = short(Theme::Light, ScenePreset::House, |_| {});
    let pictured = Pictured::of(figure).in_ndc("vulkan");
    let pictured = pictured.probed(views::Probe::Window(DVec2::new(0.2, 0.15)));
    assert_picture("canonical_vulkan", &paint(&pictured.canonical(Viewpoint::Iso)));
}

/// z_n towards the eye, from infinity to the near face.
#[test]
fn the_canonical_volume_reversed_and_without_a_far_plane() {
    let figure = short(Theme::Dark, ScenePreset::House, |_| {});
    let pictured = Pictured::of(figure).in_ndc("direct3d-reversed-infinite");
    assert_picture("canonical_reversed_infinite", &paint(&pictured.canonical(Viewpoint::Iso)));
}

/// Points in the volume, before the window, behind the eye, in its plane, and beyond all numbers.
fn followed(projection: Projection) -> Figure {
    let mut figure = short(Theme::Light, ScenePreset::House, |c| (c.projection, c.height) = (projection, 6.0));
    let camera = Camera::new(&figure.camera).unwrap();
    let (c, basis) = (camera.position(), camera.basis());
    let points = [
        ("P", DVec3::new(0.5, 1.0, 1.5)),
        ("near", c - basis.n * 1.2 + basis.u * 0.3 + basis.v * 0.4),
        ("behind", c + basis.n * 2.0 + basis.v),
        ("beside", c + basis.u * 2.5),
        ("nowhere", DVec3::splat(1e308)),
    ];
    figure.points = points.map(|(name, position)| NamedPoint { name: name.to_owned(), position }).into_iter().collect();
    figure
}

#[test]
fn points_are_in_all_three_pictures_with_their_rays() {
    for (projection, name) in [(Projection::Perspective, "perspective"), (Projection::Parallel, "parallel")] {
        let pictured = Pictured::of(followed(projection));
        assert_picture(&format!("points_world_{name}"), &paint(&pictured.world(Viewpoint::Iso)));
    }
    let pictured = Pictured::of(followed(Projection::Perspective));
    assert_picture("points_canonical", &paint(&pictured.canonical(Viewpoint::Iso)));
    assert_picture("points_image", &paint(&pictured.image()));
}

#[test]
fn the_image_on_the_window_has_no_points_of_its_own() {
    let pictured = Pictured::of(followed(Projection::Perspective));
    let without = Pictured::of(Figure { points: Vec::new(), ..followed(Projection::Perspective) });
    let on_window = |pictured: &Pictured| draw(&pictured.request.image_on_window());
    assert_eq!(on_window(&pictured), on_window(&without));
    assert_ne!(pictured.image(), without.image());
}
