//! Shadows against rays: every pixel of a picture with shadow maps is compared with a ray to the light, in `f64`, on
//! the triangles of the scene.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;
use std::sync::Arc;

use camera_lab::appearance::{Rgba, Samples, Shading, Style, Texture, Theme, Visibility};
use camera_lab::camera::{Camera, ImageSize, Parameters, Projection, ViewWindow};
use camera_lab::drawing::{Area, ShadowMap, SurfaceLight};
use camera_lab::figure::Figure;
use camera_lab::figure::read::parse;
use camera_lab::picture::Renderer;
use camera_lab::pipeline::canonical::clipped_scene;
use camera_lab::pipeline::plan::{Options, Output, Reason, Stage};
use camera_lab::pipeline::reflection::{AMBIENT, DIFFUSE};
use camera_lab::pipeline::shadow_rays::{SeenPoint, Solids, to_light};
use camera_lab::pipeline::{Frame, Pipeline, Scenes, Target};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{Light, LightKind, ObjectPaint, Pictured, Scene, Shadows, build, no_files};
use camera_lab::views::{Palette, Request, ShadowTruth, SharedScene, Size, View};
use camera_lab_files::SHIPPED_FIGURES;
use camera_lab_words::{Lang, pictures};
use glam::DVec3;
use rayon::prelude::*;

const WHITE: Rgba = Rgba::rgb(255, 255, 255);

/// A floor with a box, a ball and a ring over it.
const TABLE: &str = r#"
[camera]
position = [4, 5, 6]
focal_point = [0, 0.5, 0]
view_angle = 40
[scene]
preset = "empty"
[[scene.objects]]
name = "floor"
shape = "box"
scale = [3, 0.1, 3]
translate = [0, -0.1, 0]
[[scene.objects]]
name = "cube"
shape = "box"
scale = [0.5, 0.5, 0.5]
translate = [-1, 0.5, 0.5]
[[scene.objects]]
name = "ball"
shape = "sphere"
scale = [0.6, 0.6, 0.6]
translate = [0.8, 0.6, 0.8]
[[scene.objects]]
name = "ring"
shape = "torus"
scale = [0.6, 0.6, 0.6]
translate = [0.3, 1.2, -1]
rotate = [60, 0, 20]
"#;

fn sun() -> Light {
    Light::directional(DVec3::new(-1.0, -2.0, -1.0)).with_shadows(Shadows::CAST)
}

fn lamp() -> Light {
    Light::point(DVec3::new(2.0, 3.0, 1.5)).with_shadows(Shadows::CAST)
}

/// A figure with one light, white and without lines, so that a pixel says how much light it gets.
fn white(figure: &Figure, light: Light) -> (Scene, Camera) {
    let style = Style { theme: Theme::Print, ..Style::default() };
    let mut scene = build(&figure.scene, &style, &mut no_files).unwrap();
    scene.objects.retain(|object| object.faces);
    for object in &mut scene.objects {
        object.paint = ObjectPaint::Solid(WHITE);
        (object.lit, object.edges, object.outline) = (true, None, None);
    }
    let scene = Scene { objects: scene.objects, lights: vec![light], ..Scene::default() };
    (scene, Camera::new(&figure.camera).unwrap())
}

const FLAT: Style = Style {
    shading: Shading::Flat,
    visibility: Visibility::DepthBuffer,
    hidden_lines: camera_lab::appearance::HiddenLines::Shown,
    antialias: Samples::One,
    theme: Theme::Light,
    depth_format: camera_lab::appearance::DepthFormat::Float,
    vertex_format: camera_lab::appearance::VertexFormat::F64,
    subpixel_bits: camera_lab::appearance::SubpixelBits::Eight,
    order: camera_lab::appearance::FaceOrder::AsListed,
};

fn target(size: ImageSize) -> Target {
    Target { width: size.width, height: size.height, scale: 1.0, background: Rgba::rgb(0, 0, 255) }
}

fn frame(scene: &Scene, camera: &Camera, style: &Style, size: ImageSize) -> Frame {
    Pipeline::default().frame(scene, camera, target(size), style, Options::default())
}

fn pixels(scene: &Scene, camera: &Camera, style: &Style, size: ImageSize) -> Vec<u8> {
    let frame = frame(scene, camera, style, size);
    Rasterizer::default().paint(&frame.drawing).unwrap().data().to_vec()
}

/// The triangles of a scene in the world, all tried one by one.
struct OneByOne(Vec<[DVec3; 3]>);

impl OneByOne {
    fn of(scene: &Scene) -> Self {
        let of_object = |object: &camera_lab::scene::Object| {
            let at = |i: u32| object.world_from_object.transform_point3(object.mesh.positions[i as usize]);
            object.mesh.triangles.iter().map(|t| t.map(at)).collect::<Vec<_>>()
        };
        Self(scene.objects.iter().flat_map(of_object).collect())
    }

    /// The first triangle that a ray meets after `from`, and the point of impact; [Möller, Trumbore 1997].
    fn hit(&self, origin: DVec3, ray: DVec3, without: usize, within: std::ops::Range<f64>) -> Option<(usize, f64)> {
        let mut best: Option<(usize, f64)> = None;
        for (k, &[a, b, c]) in self.0.iter().enumerate().filter(|(k, _)| *k != without) {
            let (ab, ac) = (b - a, c - a);
            let p = ray.cross(ac);
            let determinant = ab.dot(p);
            if determinant == 0.0 {
                continue;
            }
            let s = (origin - a) / determinant;
            let u = s.dot(p);
            let q = s.cross(ab);
            let (v, t) = (ray.dot(q), ac.dot(q));
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && within.contains(&t) && best.is_none_or(|(_, old)| t < old) {
                best = Some((k, t));
            }
        }
        best
    }
}

/// The length of a texel at a point.
fn texel(scene: &Scene, p: DVec3, light: &Light) -> f64 {
    let size = f64::from(light.shadows.map);
    match light.kind {
        LightKind::Directional => 2.0 * scene.bounds().unwrap().radius() / size,
        // A diagonal of the map is the longest.
        LightKind::Point => 2.0 * light.vector.distance(p) * 3_f64.sqrt() / size,
    }
}

/// Pixels that tell, wrong ones, and wrong ones farther than a texel from the edge of a shadow.
fn wrong(scene: &Scene, camera: &Camera, light: Light, size: ImageSize) -> [usize; 3] {
    let shadowed = pixels(scene, camera, &FLAT, size);
    let solids = Solids::of(scene);
    let rows: Vec<[usize; 3]> = (0..size.height)
        .into_par_iter()
        .map(|j| {
            let mut counts = [0; 3];
            for i in 0..size.width {
                let pixel = [f64::from(i) + 0.5, f64::from(j) + 0.5];
                let Some(SeenPoint { point: p, triangle, normal: towards, .. }) = solids.seen(camera, size, pixel)
                else {
                    continue;
                };
                let cosine = towards.dot(to_light(p, &light).0);
                if cosine < 0.1 {
                    continue;
                }
                let bright = f64::from(AMBIENT) + f64::from(DIFFUSE) * cosine;
                let value = f64::from(shadowed[4 * (j * size.width + i) as usize]) / 255.0;
                let arrives = (value - f64::from(AMBIENT)) / (bright - f64::from(AMBIENT));
                counts[0] += 1;
                let truth = solids.is_lit(p, triangle, &light);
                if (arrives > 0.5) == truth {
                    continue;
                }
                let beside = [[0.01, 0.0], [-0.01, 0.0], [0.0, 0.01], [0.0, -0.01]]
                    .map(|[x, y]| solids.seen(camera, size, [pixel[0] + x, pixel[1] + y]).map(|seen| seen.triangle));
                if beside.iter().any(|other| *other != Some(triangle)) {
                    // On an edge of the picture, at which another face is drawn.
                    continue;
                }
                counts[1] += 1;
                // Around the point, on its plane, within a texel on the way to the light.
                let to_light = to_light(p, &light).0;
                let (u, v) = to_light.any_orthonormal_pair();
                let step = texel(scene, p, &light);
                let around = (-4..=4).flat_map(|x| (-4..=4).map(move |y| [f64::from(x) / 4.0, f64::from(y) / 4.0]));
                let differs = around.into_iter().any(|[x, y]| {
                    let aside = (u * x + v * y) * step;
                    let q = p + aside - to_light * (aside.dot(towards) / cosine);
                    solids.is_lit(q, triangle, &light) != truth
                });
                if !differs {
                    counts[2] += 1;
                }
            }
            counts
        })
        .collect();
    rows.into_iter().fold([0; 3], |[a, b, c], [d, e, f]| [a + d, b + e, c + f])
}

/// The ray through a pixel: its points are origin + t · ray, at the distance t from the plane of the eye.
fn ray_of(camera: &Camera, size: ImageSize, [x, y]: [f64; 2]) -> (DVec3, DVec3) {
    let (window, basis) = (camera.window(), camera.basis());
    let across = |low: f64, high: f64, share: f64| low + (high - low) * share;
    let u = across(window.left, window.right, x / f64::from(size.width));
    let v = across(window.top, window.bottom, y / f64::from(size.height));
    let aside = basis.u * u + basis.v * v;
    match camera.projection() {
        Projection::Parallel => (camera.position() + aside, -basis.n),
        Projection::Perspective => (camera.position(), aside / camera.near() - basis.n),
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a few hundred")]
fn size_of(camera: &Camera) -> ImageSize {
    let height = (240.0 / camera.window_aspect().max(1.0)).round();
    ImageSize { width: (height * camera.window_aspect()).round() as u32, height: height as u32 }
}

#[test]
fn shadows_are_where_rays_to_the_light_are_stopped() {
    let table = parse(TABLE).unwrap();
    for light in [sun(), lamp()] {
        let (scene, camera) = white(&table, light);
        let [told, wrong, far] = wrong(&scene, &camera, light, size_of(&camera));
        assert!(told > 10_000 && 200 * wrong < told && far == 0, "{light:?}: {wrong} of {told} wrong, {far} far");
    }
}

/// Observers of the canonical volume: from its front, the side of the image, and from above.
fn canonical_observers() -> [Camera; 2] {
    let window = Some(ViewWindow { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0 });
    let front = Parameters {
        position: DVec3::Z * 2.0,
        focal_point: DVec3::ZERO,
        projection: Projection::Parallel,
        near: 1.0,
        far: 3.0,
        window,
        ..Parameters::default()
    };
    // So near that its front plane cuts through the volume.
    let above = Parameters {
        position: DVec3::new(1.0, 1.6, 1.8),
        focal_point: DVec3::ZERO,
        view_angle: 45.0,
        aspect: 1.5,
        near: 1.9,
        far: 6.0,
        ..Parameters::default()
    };
    [front, above].map(|parameters| Camera::new(&parameters).unwrap())
}

/// The points of a floor at y = 0 that a picture of the canonical volume shows: how many there are, how many of them
/// lie in the shadow, and how many are wrongly lit or dark by rays in the world, but within a texel of an edge.
fn wrong_in_canonical(scene: &Scene, camera: &Camera, light: Light, observer: &Camera, shading: Shading) -> [usize; 3] {
    let clipped = clipped_scene(scene, camera, shading);
    let size = ImageSize { width: 300, height: 200 };
    let style = Style { shading, ..FLAT };
    let scenes = Scenes::from(&clipped).in_shadows_of(scene).lit_by(&scene.lights);
    let drawing = Pipeline::default().frame(scenes, observer, target(size), &style, Options::default()).drawing;
    let picture = Rasterizer::default().paint(&drawing).unwrap();
    let (shown, solids) = (Solids::of(&clipped), Solids::of(scene));
    let world_from_ndc = camera.clip_from_world().inverse();
    let mut counts = [0; 3];
    for (j, i) in (0..size.height).step_by(2).flat_map(|j| (0..size.width).step_by(2).map(move |i| (j, i))) {
        let pixel = [f64::from(i) + 0.5, f64::from(j) + 0.5];
        let Some(seen) = shown.seen(observer, size, pixel) else { continue };
        // The display has z towards the viewer.
        let p = world_from_ndc.project_point3(seen.point * DVec3::new(1.0, 1.0, -1.0));
        let cosine = to_light(p, &light).0.y;
        if p.y.abs() > 1e-9 || cosine < 0.1 {
            continue;
        }
        let value = f64::from(picture.data()[4 * (j * size.width + i) as usize]) / 255.0;
        let arrives = (value - f64::from(AMBIENT)) / (f64::from(DIFFUSE) * cosine);
        let is_lit = |p: DVec3| solids.is_lit(p, usize::MAX, &light);
        let truth = is_lit(p);
        counts[0] += 1;
        counts[1] += usize::from(!truth);
        let step = texel(scene, p, &light) / cosine;
        let around = (-4..=4).flat_map(|x| (-4..=4).map(move |z| DVec3::new(f64::from(x), 0.0, f64::from(z)) / 4.0));
        if (arrives > 0.5) != truth && around.into_iter().all(|aside| is_lit(p + aside * step) == truth) {
            counts[2] += 1;
        }
    }
    counts
}

#[test]
fn shadows_fall_on_the_same_points_in_world_and_canonical_volume() {
    let figure = parse(TABLE).unwrap();
    let low_sun = Light::directional(DVec3::new(1.5, -1.0, -0.3)).with_shadows(Shadows::CAST);
    for light in [low_sun, lamp()] {
        for projection in [Projection::Perspective, Projection::Parallel] {
            let (scene, _) = white(&figure, light);
            let parameters = Parameters { projection, height: 5.0, near: 4.0, far: 14.0, ..figure.camera };
            let camera = Camera::new(&parameters).unwrap();
            for observer in canonical_observers() {
                for shading in [Shading::Flat, Shading::Phong] {
                    let [all, dark, wrong] = wrong_in_canonical(&scene, &camera, light, &observer, shading);
                    let what = format!("{projection:?} {:?} {shading:?}: {wrong} of {all}, {dark} dark", light.kind);
                    assert!(all > 500 && dark > 25 && 20 * wrong <= dark, "{what}");
                }
            }
        }
    }
}

/// Without shadows nothing is carried along, and the colours have their light in them.
#[test]
fn a_scene_without_shadows_keeps_nothing_of_the_world() {
    let (scene, camera) = white(&parse(TABLE).unwrap(), sun().with_shadows(Shadows::NONE));
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let clipped = clipped_scene(&scene, &camera, shading);
        assert!(!clipped.objects.is_empty());
        for object in &clipped.objects {
            assert!(object.in_world.is_none() && !matches!(object.paint, ObjectPaint::Solid(_)), "{shading:?}");
        }
    }
}

#[test]
fn shipped_figures_have_neither_acne_nor_detached_shadows() {
    let mut seen = Vec::new();
    for shipped in SHIPPED_FIGURES {
        let figure = parse(&shipped.text()).unwrap();
        if seen.contains(&figure.scene) {
            continue;
        }
        seen.push(figure.scene.clone());
        let style = Style::default();
        if build(&figure.scene, &style, &mut no_files).is_err() || Camera::new(&figure.camera).is_err() {
            // With a mesh from a file.
            continue;
        }
        let light = sun();
        let (scene, camera) = white(&figure, light);
        if scene.bounds().is_none() {
            continue;
        }
        let size = size_of(&camera);
        let size = ImageSize { width: size.width / 2, height: size.height / 2 };
        let [told, wrong, far] = wrong(&scene, &camera, light, size);
        assert!(200 * wrong <= told && far == 0, "{}: {wrong} of {told} wrong, {far} far", shipped.name);
    }
}

#[test]
fn without_bias_faces_shadow_themselves_and_with_too_much_shadows_shrink() {
    let figure = parse(TABLE).unwrap();
    let dark = |bias: f64, map: u32| {
        let light = sun().with_shadows(Shadows { bias, map, ..Shadows::CAST });
        let (scene, camera) = white(&figure, light);
        let size = size_of(&camera);
        let lit = Scene { lights: vec![light.with_shadows(Shadows::NONE)], ..scene.clone() };
        let (with, without) = (pixels(&scene, &camera, &FLAT, size), pixels(&lit, &camera, &FLAT, size));
        with.iter().zip(&without).filter(|(with, without)| **with < without.saturating_sub(8)).count()
    };
    let [acne, usual, detached] = [dark(0.0, 256), dark(1.0, 256), dark(40.0, 256)];
    assert!(acne > 2 * usual && 4 * detached < 3 * usual, "{acne} {usual} {detached}");
}

#[test]
fn every_shading_and_order_has_the_same_shadows() {
    let figure = parse(TABLE).unwrap();
    for light in [sun(), lamp()] {
        let (scene, camera) = white(&figure, light);
        let lit = Scene { lights: vec![light.with_shadows(Shadows::NONE)], ..scene.clone() };
        let size = ImageSize { width: 200, height: 150 };
        let dark = |style: Style| {
            let (with, without) = (pixels(&scene, &camera, &style, size), pixels(&lit, &camera, &style, size));
            let darker = |(with, without): (&u8, &u8)| *with < without.saturating_sub(40);
            with.iter().zip(&without).map(darker).collect::<Vec<_>>()
        };
        let flat = dark(FLAT);
        let count = flat.iter().filter(|dark| **dark).count();
        assert!(count > 600, "{light:?} {count}");
        for (shading, visibility) in [
            (Shading::Flat, Visibility::Bsp),
            (Shading::Gouraud, Visibility::DepthBuffer),
            (Shading::Gouraud, Visibility::Bsp),
            (Shading::Phong, Visibility::DepthBuffer),
            (Shading::Phong, Visibility::Bsp),
        ] {
            let other = dark(Style { shading, visibility, ..FLAT });
            let differ = flat.iter().zip(&other).filter(|(a, b)| a != b).count();
            assert!(4 * differ < count, "{shading:?} {visibility:?}: {differ} of {count}");
        }
    }
}

#[test]
fn shadows_do_not_depend_on_the_number_of_threads() {
    let figure = parse(TABLE).unwrap();
    let (scene, camera) = white(&figure, lamp());
    let size = ImageSize { width: 200, height: 150 };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| pixels(&scene, &camera, &Style { shading: Shading::Phong, ..FLAT }, size))
    };
    assert!(with(1) == with(4));
}

#[test]
fn the_light_of_an_only_lamp_with_its_ambient_share_is_that_of_both_found_together() {
    let figure = parse(TABLE).unwrap();
    let size = ImageSize { width: 200, height: 150 };
    for (light, near) in [(sun(), 0.1), (lamp(), 0.1), (lamp(), 7.0)] {
        let (mut scene, _) = white(&figure, light);
        let camera = Camera::new(&Parameters { near, ..figure.camera }).unwrap();
        // Under a picture light is kept apart from colours, with and without shadows.
        for object in &mut scene.objects {
            let texels = [255, 255, 255, 255, 0, 0, 0, 255].to_vec();
            let uv = vec![[0.0; 2]; object.mesh.positions.len()];
            object.paint = ObjectPaint::Texture(Pictured::plain(Arc::new(Texture::flat(2, 1, texels)), uv, 255));
        }
        let mut without = scene.clone();
        without.lights[0].shadows = Shadows::default();
        for shading in [Shading::Flat, Shading::Gouraud] {
            let style = Style { shading, ..FLAT };
            let [with, without] = [&scene, &without].map(|scene| frame(scene, &camera, &style, size).drawing);
            assert!(with.surfaces.iter().any(|surface| !surface.shadows.is_empty()));
            for (with, without) in with.surfaces.iter().zip(&without.surfaces) {
                match (&with.light, &without.light) {
                    (SurfaceLight::Faces(with), SurfaceLight::Faces(without)) => assert_eq!(with, without),
                    (SurfaceLight::Vertices(one), SurfaceLight::Vertices(other)) => {
                        let corners = with.triangles.iter().flatten().map(|&corner| corner as usize);
                        corners.for_each(|corner| assert_eq!(one[corner], other[corner]));
                    }
                    kinds => panic!("{kinds:?}"),
                }
            }
        }
    }
}

#[test]
fn a_map_is_kept_while_neither_light_nor_scene_changes() {
    let figure = parse(TABLE).unwrap();
    let (mut scene, camera) = white(&figure, sun());
    let size = ImageSize { width: 80, height: 60 };
    let mut pipeline = Pipeline::default();
    let mut map = |scene: &Scene, camera: &Camera| {
        let frame = pipeline.frame(scene, camera, target(size), &FLAT, Options::default());
        Arc::clone(&frame.drawing.surfaces[0].shadows.last().unwrap().map)
    };
    let same = |one: &Arc<ShadowMap>, other: &Arc<ShadowMap>| Arc::ptr_eq(one, other);
    let first = map(&scene, &camera);
    let mut moved = figure.camera;
    moved.position += DVec3::X;
    assert!(same(&map(&scene, &Camera::new(&moved).unwrap()), &first));
    scene.lights.insert(0, Light::point(DVec3::Y));
    assert!(same(&map(&scene, &camera), &first));
    scene.objects[2].world_from_object *= glam::DMat4::from_translation(DVec3::Y);
    let other = map(&scene, &camera);
    assert!(!same(&other, &first) && *other != *first);
    // The bias is that of the picture, the width of the edge that of the map.
    scene.lights[1].shadows.bias = 2.0;
    assert!(same(&map(&scene, &camera), &other));
    scene.lights[1].shadows.softness = 3.0;
    assert!(!same(&map(&scene, &camera), &other));
}

#[test]
fn the_stage_runs_only_if_a_shadow_may_fall() {
    let figure = parse(TABLE).unwrap();
    let (scene, camera) = white(&figure, sun());
    let size = ImageSize { width: 80, height: 60 };
    let forced = Options { force_all_stages: true, output: Output::Pixels, ..Options::default() };
    let told = |scene: &Scene, style: &Style| {
        let frame = frame(scene, &camera, style, size);
        let all = Pipeline::default().frame(scene, &camera, target(size), style, forced);
        let paint = |frame: &Frame| Rasterizer::default().paint(&frame.drawing).unwrap().data().to_vec();
        assert!(paint(&frame) == paint(&all), "forced is as planned");
        let planned = frame.plan.stage(Stage::Shadow);
        (planned.runs, planned.reason)
    };
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let style = Style { shading, ..FLAT };
        assert_eq!(told(&scene, &style), (true, Reason::Shadowed { objects: 4 }));
        let mut none = scene.clone();
        none.lights[0].shadows.cast = false;
        assert_eq!(told(&none, &style), (false, Reason::NoShadows));
        let mut unlit = scene.clone();
        unlit.objects.iter_mut().for_each(|object| object.lit = false);
        assert_eq!(told(&unlit, &style), (false, Reason::NothingShadowed));
        let mut glass = scene.clone();
        glass.objects.iter_mut().for_each(|object| object.paint = ObjectPaint::Solid(Rgba::rgba(9, 9, 9, 99)));
        assert_eq!(told(&glass, &style), (false, Reason::NoShadows));
    }
    assert_eq!(told(&scene, &Style { shading: Shading::Wireframe, ..FLAT }), (false, Reason::Wireframe));
}

#[test]
fn a_light_from_below_or_within_and_lights_of_nonsense_make_pictures() {
    let figure = parse(TABLE).unwrap();
    let size = ImageSize { width: 40, height: 30 };
    for vector in [DVec3::Y, DVec3::NEG_Y, DVec3::ZERO, DVec3::new(0.8, 0.6, 0.8), DVec3::splat(1e200), DVec3::NAN] {
        for kind in [LightKind::Directional, LightKind::Point] {
            for map in [0, 64] {
                let shadows = Shadows { map, bias: f64::NAN, ..Shadows::CAST };
                for shadows in [shadows, Shadows { map: 64, ..Shadows::CAST }] {
                    let (scene, camera) = white(&figure, Light { kind, vector, shadows });
                    assert_eq!(pixels(&scene, &camera, &FLAT, size).len(), 4800);
                }
            }
        }
    }
}

/// Width of a picture, in which a pixel of the image is a square.
const WIDE: u32 = 480;

/// A picture that holds its shadows against rays.
fn truth_of(text: &str, size: ImageSize, lang: Lang) -> (Request, Marked, Vec<String>) {
    let figure = parse(&format!(
        "{text}[image]\nwidth = {}\nheight = {}\n[reveal]\nshadows = \"truth\"\n",
        size.width, size.height
    ))
    .unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    let scene = SharedScene::new(build(&figure.scene, &Style::default(), &mut no_files).unwrap());
    let whole = Size { width: WIDE, height: WIDE * size.height / size.width, scale: 0.6 };
    let request = Request::of(&figure, View::Image, &camera, &scene, pictures::labels(lang), whole);
    let drawing = Renderer::default().drawing(&request).unwrap().drawing;
    let texts = drawing.labels.iter().map(|label| label.text.clone()).collect();
    let mark = Palette::of(Theme::Light).differing;
    #[expect(clippy::cast_precision_loss, reason = "a few")]
    let side = (WIDE / size.width) as f32;
    // The sample in the legend has another height.
    let marks = drawing.areas.iter().filter(|area| area.fill == mark && (area.size[1] - side).abs() < 1e-3);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "pixels")]
    let whole = |v: f32| (v / side).round() as u32;
    let of_run = |area: &Area| {
        let ([x, y], [w, _]) = (area.corner, area.size);
        (whole(x)..whole(x + w)).map(move |i| [i, whole(y)])
    };
    (request, marks.flat_map(of_run).collect(), texts)
}

/// Marked pixels: column, row.
type Marked = BTreeSet<[u32; 2]>;

/// Light with no bias, and with too much, so that many pixels are wrong, dark and lit. All of it or nothing.
const LIT: &str = r#"
[[scene.lights]]
kind = "directional"
direction = [-1, -2, -1]
shadows = true
shadow_map = 128
shadow_bias = BIAS
shadow_softness = 0
"#;

#[test]
fn marked_pixels_are_those_in_which_ray_and_map_disagree() {
    let size = ImageSize { width: 120, height: 90 };
    for bias in ["0", "100"] {
        let text = format!("{TABLE}{}", LIT.replace("BIAS", bias));
        let (request, marks, texts) = truth_of(&text, size, Lang::En);
        let (scene, camera) = (&request.scene, &request.camera);
        let light = scene.lights[0];
        // The map by its pixels, as white faces show it.
        let (white, _) = white(&parse(&text).unwrap(), light);
        let shadowed = pixels(&white, camera, &FLAT, size);
        let solids = OneByOne::of(&white);
        let (mut wrong, mut doubtful, mut of) = (0_usize, 0_usize, 0_usize);
        for j in 0..size.height {
            for i in 0..size.width {
                let (origin, ray) = ray_of(camera, size, [f64::from(i) + 0.5, f64::from(j) + 0.5]);
                let k = 4 * (j * size.width + i) as usize;
                let is_marked = marks.contains(&[i, j]);
                let hit = solids.hit(origin, ray, usize::MAX, camera.near()..camera.far());
                let Some((triangle, t)) = hit else {
                    assert!(!is_marked);
                    continue;
                };
                let p = origin + ray * t;
                let [a, b, c] = solids.0[triangle];
                let normal = (b - a).cross(c - a).normalize();
                let towards = if normal.dot(ray) > 0.0 { -normal } else { normal };
                let (to, until) = to_light(p, &light);
                let cosine = towards.dot(to);
                of += usize::from(cosine > 0.0);
                let all = f64::from(DIFFUSE) * cosine;
                let arrives = f64::from(shadowed[k]) / 255.0 - f64::from(AMBIENT);
                // If hardly any light could arrive, or about half of it does, bytes do not tell.
                if cosine < 0.1 || (arrives / all - 0.5).abs() < 0.1 {
                    doubtful += usize::from(is_marked);
                    continue;
                }
                let is_lit = solids.hit(p, to, triangle, 1e-9 * (1.0 + p.length())..until).is_none();
                wrong += usize::from((arrives > 0.5 * all) != is_lit);
                doubtful += usize::from(is_marked != ((arrives > 0.5 * all) != is_lit));
            }
        }
        let legend = texts.iter().find(|text| text.starts_with("the shadow map is wrong at ")).unwrap();
        let numbers: Vec<usize> = legend.split(' ').filter_map(|word| word.parse().ok()).collect();
        let [said, of_said] = numbers[..2] else { panic!("{legend}") };
        assert!(wrong > 60 && doubtful * 20 < wrong, "{bias}: {wrong} wrong, {doubtful} doubtful");
        assert_eq!(said, marks.len(), "{legend}");
        assert!(said.abs_diff(wrong) * 10 < wrong && of_said.abs_diff(of) * 50 < of, "{legend}: {wrong} of {of}");
    }
}

#[test]
fn the_count_of_wrong_pixels_is_that_of_the_marks_and_stands_in_both_languages() {
    let size = ImageSize { width: 60, height: 45 };
    let text = format!("{TABLE}{}", LIT.replace("BIAS", "0"));
    let (request, marks, english) = truth_of(&text, size, Lang::En);
    let marked = marks.len();
    let said = english.iter().find(|text| text.starts_with("the shadow map is wrong at ")).unwrap();
    assert!(marked > 100 && said.starts_with(&format!("the shadow map is wrong at {marked} of ")), "{said}: {marked}");
    let (_, _, portuguese) = truth_of(&text, size, Lang::PtBr);
    assert!(portuguese.iter().any(|text| text.starts_with(&format!("o mapa de sombras erra em {marked} de "))));
    // Without shadows there is nothing to report, and a picture that is too large is left alone.
    let (_, _, none) = truth_of(TABLE, size, Lang::En);
    assert!(none.iter().all(|text| !text.contains("wrong")), "{none:?}");
    let huge = ImageSize { width: 4096, height: 2048 };
    let looked = request.clone().with_shot(|shot| shot.look.image = huge);
    let texts = Renderer::default().drawing(&looked).unwrap().drawing.labels;
    assert!(texts.iter().any(|label| label.text == request.labels.too_much_for_rays));
    assert_eq!(ShadowTruth::TooMuch.wrong(), 0);
}
