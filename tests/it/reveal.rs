//! `[reveal]`: the pipeline's inner work in the pictures.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::appearance::{MarkShape, Rgba, Samples, Shading, Style, Theme, Visibility};
use camera_lab::camera::{Camera, Ndc, Parameters, Projection, ViewWindow, Viewport};
use camera_lab::figure::{Depth, Figure, Observer, Outside, Reveal};
use camera_lab::pipeline::clip_parts;
use camera_lab::pipeline::cull_result::{CullResult, cull_result};
use camera_lab::pipeline::divide_before_clip::divided_first;
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{Mesh, Object, ObjectPaint, ObjectSpec, PointMark, Preset as ScenePreset, Scene, Shape};
use camera_lab::views::observer::Viewpoint;
use camera_lab::views::{Palette, View, depth, scene_of};
use glam::{DMat4, DVec2, DVec3};
use proptest::prelude::*;
use tiny_skia::Pixmap;

use crate::common::picture::assert_picture;
use crate::views::{Pictured, draw};

/// The house from its best side, with its volume close around it.
fn house(reveal: Reveal) -> Figure {
    preset(ScenePreset::House, reveal)
}

fn preset(preset: ScenePreset, reveal: Reveal) -> Figure {
    let mut figure = Figure { camera: camera_lab::figure::recommended_camera(preset), reveal, ..Figure::default() };
    figure.scene.preset = preset;
    figure
}

fn image(pictured: &Pictured) -> Pixmap {
    Rasterizer::default().paint(&pictured.image()).unwrap()
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
        translate: DVec3::new(1.5, 1.0, 2.0),
        scale: DVec3::splat(0.5),
        color: Some("#4477aa80".parse().unwrap()),
        segments: 32,
        ..ObjectSpec::new("glass", Shape::Box)
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
        figure.style.antialias = Samples::One;
        let camera = figure.camera;
        let nothing = Palette::of(figure.style.theme).nothing;
        let greys = image(&Pictured::of(figure.clone()).bare());
        figure.reveal = Reveal::default();
        let mut rasterizer = Rasterizer::default();
        let colors = Pictured::of(figure).forced();
        rasterizer.paint(&colors.image()).unwrap();
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
            let reading = depth::reading(pictured.request(), DVec2::new(0.1, 0.05)).unwrap();
            assert!((reading.distance - 4.0).abs() < 1e-14, "{reading:?}");
            assert!((reading.ndc_z - ndc_z).abs() < 1e-14, "{reading:?}");
            assert!((reading.z - (n + (f - n) * (ndc_z + 1.0) / 2.0)).abs() < 1e-14, "{reading:?}");
        }
    }
    let window = pictured(Projection::Perspective, [0.0, 1.0]);
    assert_eq!(depth::reading(window.request(), DVec2::new(-1.0, 0.8)), None, "beside the cube");
}

#[test]
fn the_numbers_are_those_of_the_picture_and_glass_has_none() {
    let mut figure = with_glass(house(Reveal::default()));
    figure.style.antialias = Samples::One;
    let pictured = Pictured::of(figure.clone()).forced();
    let mut rasterizer = Rasterizer::default();
    rasterizer.paint(&pictured.image()).unwrap();
    let window = Camera::new(&figure.camera).unwrap().window();
    let (mut same, mut all) = (0, 0);
    for (i, j) in (0..240).step_by(7).flat_map(|j| (0..320).step_by(7).map(move |i| (i, j))) {
        let share = (DVec2::new(f64::from(i), f64::from(j)) + 0.5) / DVec2::new(320.0, 240.0);
        let point = DVec2::new(window.left + share.x * window.width(), window.top - share.y * window.height());
        let reading = depth::reading(pictured.request(), point).map(|reading| reading.z);
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

/// The three pictures, painted.
fn painted(pictured: &Pictured) -> [Vec<u8>; 3] {
    [pictured.image(), pictured.canonical(Viewpoint::Iso), pictured.world(Viewpoint::Iso)]
        .map(|drawing| Rasterizer::default().paint(&drawing).unwrap().take())
}

const ALL: Reveal = Reveal {
    depth: Depth::Off,
    outside: Outside::Tinted,
    clipping: true,
    divide_first: true,
    culled: true,
    vanishing: true,
    single_precision: false,
    texture: None,
    shadows: None,
    cost: None,
};

#[test]
fn whatever_is_revealed_the_plan_changes_no_pixel() {
    let none = Reveal::default();
    let reveals = [
        stored(),
        Reveal { depth: Depth::Linear, ..none },
        Reveal { outside: Outside::Cut, clipping: true, ..none },
        Reveal { outside: Outside::Shown, culled: true, ..none },
        Reveal { divide_first: true, ..none },
        ALL,
        Reveal { depth: Depth::Stored, ..ALL },
    ];
    for reveal in reveals {
        for (scene, shading, visibility) in [
            (ScenePreset::Cube, Shading::Wireframe, Visibility::DepthBuffer),
            (ScenePreset::Cube, Shading::Flat, Visibility::DepthBuffer),
            (ScenePreset::House, Shading::Gouraud, Visibility::Painter),
            (ScenePreset::Primitives, Shading::Phong, Visibility::DepthBuffer),
            (ScenePreset::Corridor, Shading::Flat, Visibility::Bsp),
        ] {
            let mut figure = preset(scene, reveal);
            // Into the scene, so that some of it is cut, some lost, and some behind the eye.
            figure.camera.position *= 0.35;
            (figure.camera.near, figure.camera.far) = (0.4, 4.0);
            figure.style = Style { shading, visibility, antialias: Samples::One, ..Style::default() };
            let pictured = || Pictured::of(figure.clone()).sized(120, 90);
            let what = format!("{reveal:?}, {scene:?}, {shading:?}, {visibility:?}");
            assert!(painted(&pictured()) == painted(&pictured().forced()), "{what}");
        }
    }
}

#[test]
fn the_usual_treatment_of_outside_may_be_spelled_out() {
    let drawings = |outside| {
        let mut figure = house(Reveal { outside, ..Reveal::default() });
        (figure.camera.near, figure.camera.far) = (5.0, 7.0);
        painted(&Pictured::of(figure))
    };
    let [image, canonical, world] = drawings(Outside::Usual);
    let [cut_image, cut_canonical, cut_world] = drawings(Outside::Cut);
    let [shown_image, shown_canonical, shown_world] = drawings(Outside::Shown);
    assert!(image == cut_image && image == shown_image);
    assert!(canonical == cut_canonical && canonical != shown_canonical);
    assert!(world == shown_world && world != cut_world);
}

#[test]
fn cameras_that_a_careless_picture_would_spoil_spoil_none() {
    for (name, mut figure) in crate::views::cameras() {
        for (outside, depth) in
            [(Outside::Shown, Depth::Off), (Outside::Tinted, Depth::Stored), (Outside::Cut, Depth::Linear)]
        {
            figure.reveal = Reveal { outside, depth, ..ALL };
            figure.scene.preset = ScenePreset::House;
            let pictured = Pictured::of(figure.clone());
            let drawings = [pictured.image(), pictured.canonical(Viewpoint::Iso), pictured.world(Viewpoint::Iso)];
            for drawing in drawings {
                let surfaces = drawing.surfaces.iter().flat_map(|s| &s.positions);
                let all = surfaces.chain(drawing.strokes.iter().flat_map(|s| &s.points));
                assert!(all.flatten().all(|v| v.is_finite()), "{name}");
            }
        }
    }
}

/// Looks along −z from the origin. The window on F is ±1, so the planes are |x| = |z| and |y| = |z|.
fn eye(projection: Projection) -> Camera {
    Camera::new(&Parameters {
        position: DVec3::ZERO,
        focal_point: DVec3::NEG_Z,
        projection,
        near: 1.0,
        far: 3.0,
        window: Some(ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 }),
        ..Parameters::default()
    })
    .unwrap()
}

#[test]
fn outcodes_and_distances_are_those_of_clip_space() {
    let oblique = Parameters {
        window: Some(ViewWindow { left: -0.3, right: 1.2, bottom: -0.1, top: 0.4 }),
        near: 1.5,
        far: 9.0,
        ..Parameters::default()
    };
    let cameras = [eye(Projection::Perspective), eye(Projection::Parallel), Camera::new(&oblique).unwrap()];
    let (mut codes, mut tried) = (std::collections::BTreeSet::new(), 0);
    for camera in &cameras {
        for i in 0..1000_u32 {
            // Points all around, by the golden ratio and its like.
            let share = |step: f64| (f64::from(i) * step).fract() * 16.0 - 8.0;
            let p = DVec3::new(share(0.618_034), share(0.754_878), share(0.569_84));
            let c = camera.clip_from_world() * p.extend(1.0);
            let expected = [c.w + c.x, c.w - c.x, c.w + c.y, c.w - c.y, c.w + c.z, c.w - c.z];
            let found = clip_parts::homogeneous_distances(camera, p, Ndc::default());
            let code = clip_parts::outcode_of(camera, p).unwrap();
            for ((e, f), outside) in expected.iter().zip(found).zip(code) {
                assert!((e - f).abs() < 1e-12 * (1.0 + c.abs().max_element()), "{expected:?} {found:?}");
                assert!(outside == (*e < 0.0) || e.abs() < 1e-12);
                tried += 1;
            }
            codes.insert(code);
        }
    }
    assert!(tried == 18_000 && codes.len() > 25, "{}", codes.len());
    distances_follow_the_convention(&cameras);
    let eye = &cameras[0];
    assert_eq!(clip_parts::outcode_of(eye, DVec3::new(0.0, 0.0, -2.0)), Some([false; 6]));
    // By hand: left of x = −|z|, above y = |z|, beyond B = 3.
    let far_away = DVec3::new(-5.0, 6.0, -4.0);
    assert_eq!(clip_parts::outcode_of(eye, far_away), Some([true, false, false, true, false, true]));
    // w = 4, and z = (4 · 4 − 6)/2 = 5 by z_n = (B + F)/(B − F) − 2 F B/((B − F) d).
    assert_eq!(clip_parts::homogeneous_distances(eye, far_away, Ndc::default()), [-1.0, 9.0, 10.0, -2.0, 9.0, -1.0]);
    assert_eq!(clip_parts::outcode_of(eye, DVec3::NAN), None);
}

/// In each convention the distances are those of its own clip coordinates from its own planes.
fn distances_follow_the_convention(cameras: &[Camera]) {
    for camera in cameras {
        for space in Ndc::ALL.into_iter().filter_map(|ndc| camera.clip_space(ndc).ok()) {
            let p = DVec3::new(0.3, -0.7, -2.25);
            let c = space.clip_from_world() * p.extend(1.0);
            let [bottom, top] =
                if space.ndc().y_points_down() { [c.w - c.y, c.w + c.y] } else { [c.w + c.y, c.w - c.y] };
            let [near, far] = match space.ndc().depths() {
                [-1.0, _] => [c.w + c.z, c.w - c.z],
                [0.0, _] => [c.z, c.w - c.z],
                _ => [c.w - c.z, c.z],
            };
            let expected = [c.w + c.x, c.w - c.x, bottom, top, near, far];
            let found = clip_parts::homogeneous_distances(camera, p, space.ndc());
            for (e, f) in expected.into_iter().zip(found) {
                assert!(
                    (e - f).abs() < 1e-12 * (1.0 + c.abs().max_element()),
                    "{}: {expected:?} {found:?}",
                    space.ndc().name()
                );
            }
        }
    }
}

/// The area of all faces, in the world.
fn area(scene: &Scene) -> f64 {
    let corner = |o: &Object, i: u32| o.world_from_object.transform_point3(o.mesh.positions[i as usize]);
    let faces = scene.objects.iter().flat_map(|o| o.mesh.triangles.iter().map(move |t| t.map(|i| corner(o, i))));
    faces.map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum()
}

/// The length of all edges and lines, in the world.
fn length(scene: &Scene) -> f64 {
    let corner = |o: &Object, i: u32| o.world_from_object.transform_point3(o.mesh.positions[i as usize]);
    let edges = scene.objects.iter().flat_map(|o| o.mesh.edges.iter().map(move |e| e.map(|i| corner(o, i))));
    let lines = scene.lines.iter().flat_map(|l| l.points.windows(2).map(|ends| [ends[0], ends[1]]));
    edges.chain(lines).map(|[a, b]| a.distance(b)).sum()
}

#[test]
fn the_two_parts_are_the_whole_and_each_is_on_its_side() {
    let mut cut_open = 0;
    let scenes = [ScenePreset::Primitives, ScenePreset::House, ScenePreset::Corridor, ScenePreset::Exercise51];
    for (scene, projection) in
        scenes.into_iter().flat_map(|s| [(s, Projection::Perspective), (s, Projection::Parallel)])
    {
        let mut parameters =
            Parameters { projection, height: 1.5, view_angle: 20.0, ..camera_lab::figure::recommended_camera(scene) };
        (parameters.near, parameters.far) = (5.5, 7.5);
        let camera = Camera::new(&parameters).unwrap();
        let mut figure = Figure::default();
        figure.scene.preset = scene;
        let whole =
            scene_of(&figure, &mut camera_lab::scene::no_files, &camera_lab::progress::Progress::default()).unwrap();
        let parts = clip_parts::clip_parts(&whole, &camera, false);
        let (area_inside, area_outside) = (area(&parts.inside), area(&parts.outside));
        assert!(area_outside > 0.1, "{scene:?}");
        assert!((area_inside + area_outside - area(&whole)).abs() < 1e-9 * area(&whole), "{scene:?}");
        let lengths = length(&parts.inside) + length(&parts.outside);
        assert!((lengths - length(&whole)).abs() < 1e-9 * (1.0 + length(&whole)), "{scene:?}");
        assert_eq!(parts.inside.marks.len() + parts.outside.marks.len(), whole.marks.len());
        // By the six planes of the camera, which know nothing of clip space.
        let planes = camera.volume_planes();
        let outermost = |p: DVec3| planes.iter().map(|plane| plane.distance(p)).fold(f64::INFINITY, f64::min);
        // A cloud of points has nothing to cut. Its marks are all that is drawn of it.
        let mut drawn = parts.inside.clone();
        drawn.objects.retain(|o| !(o.mesh.triangles.is_empty() && o.mesh.edges.is_empty()));
        for v in drawn.vertices() {
            assert!(outermost(v.p_world) > -1e-9, "{scene:?}: {:?}", v.p_world);
        }
        for object in &parts.outside.objects {
            for t in &object.mesh.triangles {
                let middle = t.map(|i| object.mesh.positions[i as usize]).iter().sum::<DVec3>() / 3.0;
                assert!(outermost(object.world_from_object.transform_point3(middle)) < 0.0, "{scene:?}");
            }
        }
        let made = !parts.cuts.is_empty() && !parts.sides.is_empty();
        assert!(made || area_inside == 0.0, "{scene:?}");
        cut_open += u32::from(made);
        for &p in parts.cuts.iter().chain(parts.sides.as_flattened()) {
            assert!(outermost(p).abs() < 1e-9, "{scene:?}: {p}");
        }
        for (i, p) in parts.cuts.iter().enumerate() {
            assert!(parts.cuts[..i].iter().all(|q| p.distance(*q) > 1e-12), "{scene:?}: {p} is there twice");
        }
    }
    assert!(cut_open >= 5, "{cut_open} of 8");
}

fn marks(points: &[DVec3]) -> Vec<PointMark> {
    let mark = |&position| PointMark {
        position,
        shape: MarkShape::Disc,
        radius: 1.0,
        color: Rgba::rgb(0, 0, 0),
        fade_if_hidden: false,
    };
    points.iter().map(mark).collect()
}

#[test]
fn a_point_behind_the_eye_folds_over_to_the_front() {
    // `[2]`, "problema do clipping": (1, 1, −n) and (1, 1, n) both have a place, and the second is (−1, −1, …).
    let points = [DVec3::new(1.0, 1.0, -1.0), DVec3::new(1.0, 1.0, 1.0), DVec3::new(1.0, 1.0, 0.0)];
    let scene = Scene { marks: marks(&points), ..Scene::default() };
    let camera = eye(Projection::Perspective);
    let divided = divided_first(&scene, &camera, 10.0);
    let found: Vec<DVec3> = divided.wrong.marks.iter().map(|m| m.position).collect();
    // z_n = (B + F)/(B − F) − 2 F B/((B − F) d) = 2 + 3 for d = −1; shown as −z_n.
    assert_eq!(found, [DVec3::new(-1.0, -1.0, -5.0)], "w = 0 is nowhere");
    assert!(divided_first(&scene, &camera, 1.0).wrong.marks.is_empty(), "outside the cube");
    assert!(divided_first(&scene, &eye(Projection::Parallel), 10.0).wrong.marks.is_empty(), "w = 1");
}

#[test]
fn a_scene_wholly_before_the_eye_is_the_same_either_way() {
    let mut figure = house(Reveal { divide_first: true, ..Reveal::default() });
    let wrong = image(&Pictured::of(figure.clone()).bare());
    figure.reveal = Reveal::default();
    assert!(wrong.data() == image(&Pictured::of(figure)).data());
}

/// From (0, −1, −2), 2 before the eye, to (0, −1, 2), 2 behind it: it leads from below the middle to above it.
fn passing_the_eye(paint: ObjectPaint) -> Scene {
    let corners = [DVec3::new(-0.5, -1.0, -2.0), DVec3::new(0.5, -1.0, -2.0), DVec3::new(0.0, -1.0, 2.0)];
    let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]], ..Mesh::default() };
    let floor = Object {
        lit: false,
        two_sided: true,
        ..Object::new("floor", std::sync::Arc::new(mesh), DMat4::IDENTITY, paint)
    };
    Scene { objects: vec![floor], ..Scene::default() }
}

#[test]
fn a_face_that_passes_the_eye_is_where_its_divided_corners_are() {
    let scene = passing_the_eye(ObjectPaint::Solid(Rgba::rgb(9, 9, 9)));
    let divided = divided_first(&scene, &eye(Projection::Perspective), 4.0);
    assert!(divided.right.objects[0].mesh.triangles.is_empty());
    let mesh = &divided.wrong.objects[0].mesh;
    // By hand: z_n = 2 − 3/2 = 0.5 and 2 + 3/2 = 3.5.
    let expected = [[-0.25, -0.5, -0.5], [0.25, -0.5, -0.5], [0.0, 0.5, -3.5]].map(DVec3::from);
    assert_eq!(mesh.positions, expected);
    let in_cube = divided_first(&scene, &eye(Projection::Perspective), 1.0);
    // The cube ends at −z_n = −1, a sixth of the way: y = −1/2 + 1/6.
    let highest = in_cube.wrong.objects[0].mesh.positions.iter().map(|p| p.y).fold(f64::MIN, f64::max);
    assert!((highest + 1.0 / 3.0).abs() < 1e-15, "{highest}");
}

#[test]
fn surfaces_divided_first_interpolate_vertex_colours() {
    let [black, light] = [Rgba::rgb(0, 0, 0), Rgba::rgb(240, 60, 120)];
    let scene = passing_the_eye(ObjectPaint::Vertices(std::sync::Arc::new(vec![black, black, light])));
    let floor = divided_first(&scene, &eye(Projection::Perspective), 1.0).wrong.objects.remove(0);
    let ObjectPaint::Vertices(colors) = &floor.paint else { panic!("{:?}", floor.paint) };
    assert_eq!(colors.len(), 4);
    for (p, color) in floor.mesh.positions.iter().zip(colors.iter()) {
        // The cube ends a sixth of the way to the third corner.
        assert_eq!(*color, if p.z == -0.5 { black } else { Rgba::rgb(40, 10, 20) }, "{p}");
    }
}

#[test]
fn culling_says_what_it_drops_and_why() {
    let figure = preset(ScenePreset::Cube, Reveal::default());
    let scene =
        scene_of(&figure, &mut camera_lab::scene::no_files, &camera_lab::progress::Progress::default()).unwrap();
    let cube = scene.objects.iter().find(|o| o.mesh.convex).unwrap();
    let camera = |position: DVec3, focal_point: DVec3| {
        Camera::new(&Parameters { position, focal_point, near: 0.5, far: 20.0, ..Parameters::default() }).unwrap()
    };
    // From (5, 5, 5) three sides of a box are seen, and three are not.
    let corner = camera(DVec3::splat(5.0), DVec3::ZERO);
    let CullResult::BackFaces(back) = cull_result(cube, &corner) else { panic!("its back faces are culled") };
    let sees = |t: [u32; 3]| {
        let [a, b, c] = t.map(|i| cube.world_from_object.transform_point3(cube.mesh.positions[i as usize]));
        (b - a).cross(c - a).dot(DVec3::splat(5.0) - a) > 0.0
    };
    assert_eq!(back, cube.mesh.triangles.iter().map(|t| !sees(*t)).collect::<Vec<_>>());
    assert_eq!(back.iter().filter(|b| **b).count() * 2, back.len());
    // Turned away: everything is behind the eye, outside the near plane.
    let away = camera(DVec3::Z * 5.0, DVec3::Z * 9.0);
    let CullResult::Dropped(planes) = cull_result(cube, &away) else { panic!("it is dropped") };
    assert!(planes & 0b01_0000 != 0);
    // The eye inside: the near plane cuts it open, and its inside is seen.
    assert_eq!(cull_result(cube, &camera(DVec3::new(0.0, 0.2, 0.0), DVec3::X)), CullResult::Kept);
}

/// The house between two close planes, with a torus to the left and a cone behind the eye.
fn scattered(reveal: Reveal) -> Figure {
    let mut figure = house(reveal);
    figure.camera.view_angle = 30.0;
    (figure.camera.near, figure.camera.far) = (4.5, 8.0);
    for (name, shape, translate) in
        [("torus", Shape::Torus, DVec3::new(-4.0, 1.0, -1.0)), ("cone", Shape::Cone, DVec3::new(4.0, 1.5, 7.0))]
    {
        let spec = with_glass(Figure::default()).scene.objects.remove(0);
        figure.scene.objects.push(ObjectSpec {
            name: name.to_owned(),
            shape: Some(shape),
            translate,
            color: None,
            ..spec
        });
    }
    figure
}

/// Seen from behind the house.
fn from_behind(mut figure: Figure) -> Pixmap {
    figure.observers.world = Some(Observer {
        target: DVec3::new(0.5, 1.0, 1.5),
        distance: 15.0,
        azimuth: 160.0,
        elevation: 25.0,
        roll: 0.0,
        parallel: false,
    });
    let observer = figure.observers.world.unwrap();
    let pictured = Pictured::of(figure);
    Rasterizer::default().paint(&draw(&pictured.seen_by(View::World, observer))).unwrap()
}

fn canonical(figure: Figure) -> Pixmap {
    Rasterizer::default().paint(&Pictured::of(figure).canonical(Viewpoint::Iso)).unwrap()
}

#[test]
fn outside_parts_as_glass() {
    let tinted = Reveal { outside: Outside::Tinted, ..Reveal::default() };
    assert_picture("reveal_outside_world", &from_behind(scattered(tinted)));
    assert_picture("reveal_outside_canonical", &canonical(scattered(tinted)));
    let cut = Reveal { outside: Outside::Cut, ..Reveal::default() };
    assert_picture("reveal_outside_cut", &from_behind(scattered(cut)));
}

#[test]
fn culled_faces_in_the_dark_theme() {
    let mut figure = scattered(Reveal { culled: true, ..Reveal::default() });
    figure.style.theme = Theme::Dark;
    assert_picture("reveal_culled_dark", &from_behind(figure));
}

#[test]
fn new_vertices_on_paper() {
    let mut figure = scattered(Reveal { clipping: true, ..Reveal::default() });
    figure.style.theme = Theme::Print;
    figure.camera.far = 6.2;
    assert_picture("reveal_clipping_image", &image(&Pictured::of(figure.clone())));
    assert_picture("reveal_clipping_canonical", &canonical(figure));
}

/// A floor that passes under the eye, and a box on it.
fn floor(reveal: Reveal) -> Figure {
    let mut figure = Figure { reveal, ..Figure::default() };
    figure.camera = Parameters {
        position: DVec3::new(0.0, 1.2, 3.0),
        focal_point: DVec3::new(0.0, 0.6, 0.0),
        view_angle: 50.0,
        near: 1.0,
        far: 9.0,
        ..Parameters::default()
    };
    figure.scene.preset = ScenePreset::Empty;
    let spec = with_glass(Figure::default()).scene.objects.remove(0);
    for (name, translate, scale) in [
        ("floor", DVec3::new(0.0, -0.05, 1.5), DVec3::new(1.6, 0.05, 4.0)),
        ("box", DVec3::new(0.3, 0.4, 0.2), DVec3::splat(0.4)),
    ] {
        let (name, color) = (name.to_owned(), None);
        figure.scene.objects.push(ObjectSpec { name, translate, scale, color, ..spec.clone() });
    }
    figure
}

#[test]
fn divided_before_clipping() {
    let figure = floor(Reveal { divide_first: true, outside: Outside::Tinted, ..Reveal::default() });
    assert_picture("reveal_divided_first", &image(&Pictured::of(figure.clone()).in_portuguese()));
    assert_picture("reveal_divided_first_canonical", &canonical(figure));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..crate::common::any_scene::reproducible(1) })]

    #[test]
    fn from_anywhere_the_plan_changes_no_pixel(
        place in proptest::array::uniform6(-1.0..1.0),
        (near, depth, view_angle) in (0.02..3.0, 0.2..12.0, 10.0..140.0),
        parallel: bool,
        (depths, outside, switches) in (0..3_usize, 0..4_usize, any::<[bool; 3]>()),
        scene in proptest::sample::select(&[ScenePreset::Primitives, ScenePreset::House, ScenePreset::Corridor][..]),
        shading in proptest::sample::select(&[Shading::Wireframe, Shading::Flat, Shading::Gouraud][..]),
    ) {
        let [x, y, z, a, b, c] = place;
        let [clipping, divide_first, culled] = switches;
        let reveal = Reveal {
            depth: [Depth::Off, Depth::Stored, Depth::Linear][depths],
            outside: [Outside::Usual, Outside::Cut, Outside::Tinted, Outside::Shown][outside],
            clipping,
            divide_first,
            culled,
            vanishing: culled != clipping,
            single_precision: false,
            texture: None,
    shadows: None,
    cost: None,
        };
        let mut figure = preset(scene, reveal);
        figure.camera = Parameters {
            position: DVec3::new(x, y, z) * 4.0,
            focal_point: DVec3::new(a, b, c),
            projection: if parallel { Projection::Parallel } else { Projection::Perspective },
            near,
            far: near + depth,
            view_angle,
            ..figure.camera
        };
        figure.style = Style { shading, antialias: Samples::One, ..Style::default() };
        prop_assume!(Camera::new(&figure.camera).is_ok());
        let pictured = || Pictured::of(figure.clone()).sized(80, 60);
        prop_assert!(painted(&pictured()) == painted(&pictured().forced()));
    }
}
