//! One triangle step by step: outcodes, cuts, the clipped polygon, its pixels and its depth tests, against numbers
//! reckoned by hand.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use camera_lab::appearance::Rgba;
use camera_lab::camera::{Camera, ImageSize, Parameters, ViewWindow, Viewport};
use camera_lab::figure::Figure;
use camera_lab::picture::TrianglePixels;
use camera_lab::pipeline::Target;
use camera_lab::pipeline::one_triangle::one_triangle;
use camera_lab::progress::at_once;
use camera_lab::scene::{Mesh, Object, ObjectPaint, Scene};
use camera_lab::views::{Request, SharedScene, Size, View};
use camera_lab_words::{Lang, pictures::labels};
use glam::{DMat4, DVec3};

/// At the origin, looking along −z. The window is ±1 on F = 1, and B = 9, so the planes are |x| = d, |y| = d.
fn eye() -> Camera {
    Camera::new(&Parameters {
        position: DVec3::ZERO,
        focal_point: DVec3::NEG_Z,
        near: 1.0,
        far: 9.0,
        window: Some(ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 }),
        ..Parameters::default()
    })
    .unwrap()
}

fn object(name: &str, triangles: &[[[f64; 3]; 3]], world_from_object: DMat4) -> Object {
    let positions: Vec<DVec3> = triangles.iter().flatten().map(|p| DVec3::from_array(*p)).collect();
    let triangles = (0..u32::try_from(triangles.len()).unwrap()).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Object {
        lit: false,
        two_sided: true,
        ..Object::new(
            name,
            Arc::new(Mesh { positions, triangles, ..Mesh::default() }),
            world_from_object,
            ObjectPaint::Solid(Rgba::rgb(200, 0, 0)),
        )
    }
}

const IMAGE: Target = Target { width: 64, height: 64, scale: 1.0, background: Rgba::rgb(0, 0, 0) };

#[test]
fn a_corner_behind_the_eye_is_cut_off_at_the_near_plane() {
    // Behind the eye at (0, 0, 1). The object is moved by 1 along x.
    let triangle = [[-2.0, 0.0, -2.0], [0.0, 0.0, -2.0], [-1.0, 0.0, 1.0]];
    let steps = one_triangle(&object("t", &[triangle], DMat4::from_translation(DVec3::X)), 0, &eye(), IMAGE).unwrap();
    assert_eq!(steps.corners.map(|c| c.local.to_array()), triangle);
    assert_eq!(steps.corners[2].world, DVec3::new(0.0, 0.0, 1.0));
    assert_eq!((steps.corners[0].clip.x, steps.corners[0].w), (-1.0, 2.0));
    assert_eq!(steps.corners[0].distances, [1.0, 3.0, 2.0, 2.0, 1.0, 7.0]);
    assert_eq!(steps.corners[0].outside, [false; 6]);
    // w = −1: outside of all but the far plane.
    assert_eq!(steps.corners[2].outside, [true, true, true, true, true, false]);
    assert!(!steps.is_outside);
    let near = &steps.cuts[0];
    assert_eq!((near.plane, near.left.as_str()), (4, "abde"));
    // From d = 2 to d = −1 the plane d = 1 is a third of the way.
    for (cut, inside) in near.made.iter().zip(['b', 'a']) {
        assert_eq!((cut.inside, cut.outside, cut.distances), (inside, 'c', [1.0, -2.0]));
        assert!((cut.t - 1.0 / 3.0).abs() < 1e-15);
    }
    let left: String = steps.left.iter().map(|corner| corner.name).collect();
    assert_eq!(left, "abde");
    assert!((steps.left[2].world - DVec3::new(2.0 / 3.0, 0.0, -1.0)).length() < 1e-15);
    assert!((steps.left[2].ndc.x - 2.0 / 3.0).abs() < 1e-15);
    assert!((f64::from(steps.left[2].image[0]) - (32.0 + 32.0 * 2.0 / 3.0)).abs() <= 0.5 / 256.0);
}

#[test]
fn triangles_outside_one_plane_are_dropped_uncut_and_inner_ones_stay() {
    let outside = [[10.0, 0.0, -2.0], [11.0, 0.0, -2.0], [10.0, 1.0, -2.0]];
    let inside = [[0.0, 0.0, -2.0], [1.0, 0.0, -2.0], [0.0, 1.0, -2.0]];
    let object = object("t", &[outside, inside], DMat4::IDENTITY);
    let steps = |i| one_triangle(&object, i, &eye(), IMAGE);
    let dropped = steps(0).unwrap();
    assert!(dropped.is_outside && dropped.cuts.is_empty() && dropped.left.is_empty());
    assert!(dropped.corners.iter().all(|corner| corner.outside[1]), "right");
    let kept = steps(1).unwrap();
    assert!(!kept.is_outside && kept.cuts.is_empty() && kept.left.len() == 3);
    assert!(kept.facing > 0.0, "counter-clockwise as the eye sees it");
    assert_eq!(steps(2), None);
}

fn request(objects: Vec<Object>) -> Request {
    let figure = Figure { image: ImageSize { width: 64, height: 64 }, ..Figure::default() };
    let scene = SharedScene::new(Scene { objects, ..Scene::default() });
    let size = Size { width: 1, height: 1, scale: 1.0 };
    Request::of(&figure, View::Image, &eye(), &scene, labels(Lang::En), size)
}

#[test]
fn it_covers_the_pixels_whose_centres_lie_in_it() {
    let triangle = [[-1.5, -1.2, -2.0], [1.3, -0.9, -2.0], [0.2, 1.7, -2.0]];
    let request = request(vec![object("t", &[triangle], DMat4::IDENTITY)]);
    let pixels = at_once(TrianglePixels::of(&request, 0, 0)).unwrap();
    let image = triangle.map(|[x, y, _]| [32.0 + 32.0 * x / 2.0, 32.0 - 32.0 * y / 2.0]);
    let side = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let mut count = 0;
    for j in 0..64 {
        for i in 0..64 {
            let p = [f64::from(i) + 0.5, f64::from(j) + 0.5];
            let sides = [(0, 1), (1, 2), (2, 0)].map(|(a, b)| side(image[a], image[b], p));
            let least = sides.iter().fold(f64::INFINITY, |least, s| least.min(-s));
            if least.abs() > 0.5 {
                assert_eq!(pixels.test([i, j]).is_some(), least > 0.0, "{i} {j}");
            }
            count += usize::from(pixels.test([i, j]).is_some());
        }
    }
    assert_eq!(pixels.count(), count);
    assert!(count > 300);
}

#[test]
fn the_nearer_one_is_kept_and_the_buffer_holds_earlier_objects() {
    let at = |d: f64| [[-d, -d, -d], [d, -d, -d], [0.0, d, -d]];
    let objects = [2.0, 4.0, 3.0].map(|d| object(&format!("at {d}"), &[at(d)], DMat4::IDENTITY));
    let request = request(objects.to_vec());
    let figure_viewport = Viewport::whole(ImageSize { width: 64, height: 64 });
    let [low, high] = [figure_viewport.depth_near, figure_viewport.depth_far];
    // (5.25) with F = 1, B = 9: z_n = (B + F)/(B − F) − 2FB/((B − F) d).
    let z = |d: f64| low + (high - low) * (10.0 / 8.0 - 18.0 / (8.0 * d) + 1.0) / 2.0;
    for (object, d, before) in [(0, 2.0, None), (1, 4.0, Some(2.0)), (2, 3.0, Some(2.0))] {
        let tested = at_once(TrianglePixels::of(&request, object, 0)).unwrap().test([32, 40]).unwrap();
        assert!((tested.z - z(d)).abs() < 1e-6, "{tested:?} {}", z(d));
        assert_eq!(tested.before.map(|z| (z * 1e5).round()), before.map(|d| (z(d) * 1e5).round()));
        assert_eq!(tested.kept, before.is_none(), "{d}");
    }
}

#[test]
fn within_an_object_the_triangles_before_it_count() {
    let at = |d: f64| [[-d, -d, -d], [d, -d, -d], [0.0, d, -d]];
    let both = object("both", &[at(4.0), at(2.0), at(3.0)], DMat4::IDENTITY);
    let request = request(vec![both]);
    let tested = |i| at_once(TrianglePixels::of(&request, 0, i)).unwrap().test([32, 40]).unwrap();
    assert_eq!(tested(0).before, None);
    assert!(tested(1).kept && tested(1).before == Some(tested(0).z));
    assert!(!tested(2).kept && tested(2).before == Some(tested(1).z));
}
