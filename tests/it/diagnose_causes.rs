//! Why is my picture empty? Hundreds of random cameras for each cause: the first finding names it, and its repair shows
//! the object.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use camera_lab::appearance::{Samples, Style};
use camera_lab::camera::{Camera, ImageSize, Parameters, Projection, ViewWindow};
use camera_lab::figure::{Figure, Reveal};
use camera_lab::numbers::random::Random;
use camera_lab::numerics::diagnosis::{Cause, Diagnosis, ImageSpec};
use camera_lab::pipeline::{Target, draw};
use camera_lab::progress::{Progress, at_once};
use camera_lab::raster::Rasterizer;
use camera_lab::scene::{ObjectSpec, Preset, Scene, SceneSpec, Shape, build, no_files};
use camera_lab_words::Lang;
use camera_lab_words::window::coach;
use glam::DVec3;

const IMAGE: ImageSize = ImageSize { width: 160, height: 120 };
const CASES: u64 = 60;

/// A camera somewhere, and the place of a thing of this radius as it is seen from there: right, up, depth.
struct Case {
    random: Random,
    camera: Camera,
}

impl Case {
    fn new(seed: u64, change: impl FnOnce(&mut Parameters)) -> Self {
        let mut random = Random::new(20, seed);
        let far_out = [0.0, 1.0, 1e3, 1e6][(seed % 4) as usize];
        let position = random.direction() * far_out;
        let direction = random.direction();
        let mut p = Parameters {
            position,
            focal_point: position + direction * random.between(2.0, 20.0),
            view_up: loop {
                let up = random.direction();
                if up.cross(direction).length() > 0.1 {
                    break up;
                }
            },
            projection: if seed.is_multiple_of(2) { Projection::Perspective } else { Projection::Parallel },
            view_angle: random.between(20.0, 90.0),
            height: random.between(4.0, 12.0),
            aspect: IMAGE.aspect(),
            near: random.between(0.1, 1.0),
            far: random.between(60.0, 200.0),
            ..Parameters::default()
        };
        change(&mut p);
        if seed.is_multiple_of(5) {
            // The same window as such, or one beside the axis.
            let window = Camera::new(&p).unwrap().window();
            let aside = if seed.is_multiple_of(10) { 0.3 * window.width() } else { 0.0 };
            p.window = Some(ViewWindow { left: window.left + aside, right: window.right + aside, ..window });
        }
        Self { random, camera: Camera::new(&p).unwrap() }
    }

    /// Half the width and height of the view at a depth, and its middle.
    fn window_at(&self, depth: f64) -> ([f64; 2], [f64; 2]) {
        let w = self.camera.window();
        let scale = if self.camera.projection() == Projection::Perspective { depth / self.camera.near() } else { 1.0 };
        let half = [w.width() / 2.0 * scale, w.height() / 2.0 * scale];
        (half, [(w.left + w.right) / 2.0 * scale, (w.bottom + w.top) / 2.0 * scale])
    }

    fn world(&self, right: f64, up: f64, depth: f64) -> DVec3 {
        let b = self.camera.basis();
        self.camera.position() + b.u * right + b.v * up - b.n * depth
    }

    /// A thing whose points are no farther than `radius` from a place.
    fn thing(&mut self, solid: bool, at: DVec3, radius: f64) -> ObjectSpec {
        let shapes = if solid { 3 } else { 6 };
        let shape = match self.random.bits() % shapes {
            0 => Shape::Sphere,
            1 => Shape::Box,
            2 => Shape::Torus,
            3 => Shape::Grid,
            4 => Shape::Segments(vec![
                [DVec3::NEG_ONE, DVec3::ONE],
                [DVec3::new(1.0, -1.0, 0.0), DVec3::new(-1.0, 1.0, 0.0)],
            ]),
            _ => Shape::Ellipsoid,
        };
        // The corners of a box are √3 away.
        let scale =
            if matches!(shape, Shape::Box | Shape::Segments(_) | Shape::Grid) { radius / 3f64.sqrt() } else { radius };
        let [a, b, c] = [0, 1, 2].map(|_| self.random.between(-90.0, 90.0));
        ObjectSpec::new("thing", shape)
            .at(at.x, at.y, at.z)
            .turned(a, b, c)
            .scaled(scale, scale, scale)
            .with_segments(12)
    }
}

fn diagnose(scene: &Scene, camera: &Camera, style: &Style, image: ImageSize) -> Option<Diagnosis> {
    let spec = ImageSpec { scene, camera, style, reveal: &Reveal::default(), image, compared: u64::MAX };
    at_once(camera_lab::numerics::diagnosis::diagnose(&spec, &Progress::default())).ok()
}

fn scene(objects: Vec<ObjectSpec>) -> Scene {
    build(&SceneSpec { preset: Preset::Empty, objects, ..SceneSpec::default() }, &Style::default(), &mut no_files)
        .unwrap()
}

/// Pixels that differ from the ground.
fn pixels(scene: &Scene, camera: &Parameters, style: &Style) -> usize {
    let ground = camera_lab::appearance::Rgba::rgb(1, 2, 3);
    let target = Target { width: IMAGE.width, height: IMAGE.height, scale: 1.0, background: ground };
    let drawing = draw(scene, &Camera::new(camera).unwrap(), target, &Style { antialias: Samples::One, ..*style });
    let pixmap = Rasterizer::default().paint(&drawing).unwrap();
    pixmap.data().chunks_exact(4).filter(|pixel| pixel[..3] != [1, 2, 3]).count()
}

#[track_caller]
fn hold(seed: u64, cause: Cause, case: &Case, scene: &Scene) -> Diagnosis {
    let diagnosis = diagnose(scene, &case.camera, &Style::default(), IMAGE).unwrap();
    // An object that covers a pixel by less than a grey level does not change it.
    let changed = pixels(scene, case.camera.parameters(), &Style::default()) as u64;
    assert!((changed..=changed + 3 + changed / 50).contains(&diagnosis.visible), "{seed}: {changed} {diagnosis:?}");
    assert_eq!(diagnosis.covered, diagnosis.visible as f64 / (160.0 * 120.0));
    let Some(first) = diagnosis.findings.first() else { panic!("{seed}: no finding, {:?}", case.camera.parameters()) };
    assert_eq!(first.cause, cause, "{seed}: {:?}\n{:?}", diagnosis.findings, case.camera.parameters());
    assert_eq!(first.objects().collect::<Vec<_>>(), ["thing"], "{seed}");
    let repair = first.repair.unwrap_or_else(|| panic!("{seed}: no repair for {cause:?}"));
    assert!(!repair.changes(&Figure { camera: *case.camera.parameters(), ..Figure::default() }).is_empty());
    assert!(pixels(scene, &repair.camera, &repair.style) > 0, "{seed}: {repair:?}");
    let after = diagnose(scene, &Camera::new(&repair.camera).unwrap(), &repair.style, IMAGE).unwrap();
    assert!(after.findings.is_empty(), "{seed}: {cause:?} → {:?}\n{:?}", after.findings, repair.camera);
    diagnosis
}

#[test]
fn behind_the_camera() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |_| ());
        let (radius, depth) = (case.random.between(0.3, 2.0), case.random.between(3.0, 30.0));
        let at = case.world(case.random.clone().between(-3.0, 3.0), 0.0, -depth);
        let thing = case.thing(false, at, radius);
        assert_eq!(hold(seed, Cause::BehindCamera, &case, &scene(vec![thing])).visible, 0);
    }
}

#[test]
fn beyond_the_far_plane() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |_| ());
        let radius = case.random.between(0.5, 2.0);
        let depth = case.camera.far() + radius * case.random.between(1.1, 20.0);
        let (_, [x, y]) = case.window_at(depth);
        let at = case.world(x, y, depth);
        let thing = case.thing(true, at, radius);
        assert_eq!(hold(seed, Cause::BeyondFar, &case, &scene(vec![thing])).visible, 0);
    }
}

#[test]
fn before_the_near_plane() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |p| p.near = 10.0);
        let radius = case.random.between(0.3, 1.0);
        let depth = case.random.between(2.0, 8.5);
        let (_, [x, y]) = case.window_at(depth);
        let at = case.world(x, y, depth);
        let thing = case.thing(true, at, radius);
        assert_eq!(hold(seed, Cause::BeforeNear, &case, &scene(vec![thing])).visible, 0);
    }
}

#[test]
fn beside_the_window() {
    let sides = [
        (Cause::OutsideLeft, [-1.0, 0.0]),
        (Cause::OutsideRight, [1.0, 0.0]),
        (Cause::OutsideTop, [0.0, 1.0]),
        (Cause::OutsideBottom, [0.0, -1.0]),
    ];
    for seed in 0..2 * CASES {
        let mut case = Case::new(seed, |_| ());
        let (cause, way) = sides[(seed / 2 % 4) as usize];
        let (radius, depth) = (case.random.between(0.3, 2.0), case.random.between(5.0, 40.0));
        let (half, middle) = case.window_at(depth);
        // The planes of a perspective are aslant.
        let aside = case.random.between(2.5, 8.0) * radius + 0.05 * depth;
        let [x, y] = [0, 1].map(|i| middle[i] + way[i] * (half[i] + aside));
        let at = case.world(x, y, depth);
        let thing = case.thing(false, at, radius);
        assert_eq!(hold(seed, cause, &case, &scene(vec![thing])).visible, 0);
    }
}

#[test]
fn smaller_than_a_pixel() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |_| ());
        let depth = case.random.between(5.0, 40.0);
        let (half, [x, y]) = case.window_at(depth);
        let radius = case.random.between(0.01, 0.3) * 2.0 * half[1] / 120.0;
        let at = case.world(x, y, depth);
        // So far from the origin there is no sphere of that size.
        if at.length() > 1e5 {
            continue;
        }
        let thing = case.thing(true, at, radius);
        hold(seed, Cause::SmallerThanPixel, &case, &scene(vec![thing]));
    }
}

#[test]
fn on_few_pixels() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |_| ());
        let depth = case.random.between(5.0, 40.0);
        let (half, [x, y]) = case.window_at(depth);
        // A disc of at most 2.2 pixels, with its outline less than 0.1 % of 19 200.
        let radius = 1.1 * 2.0 * half[1] / 120.0;
        let at = case.world(x, y, depth);
        let [rx, ry, rz] = at.to_array();
        let thing = ObjectSpec::new("thing", Shape::Sphere).at(rx, ry, rz).scaled(radius, radius, radius);
        let visible = hold(seed, Cause::FewPixels, &case, &scene(vec![thing])).visible;
        assert!((1..20).contains(&visible), "{visible}");
    }
}

#[test]
fn inside_of_a_solid() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |_| ());
        let radius = case.random.between(3.0, 30.0);
        let off = case.random.direction() * (0.2 * radius);
        let [x, y, z] = (case.camera.position() + off).to_array();
        let shape = if seed.is_multiple_of(3) { Shape::Box } else { Shape::Sphere };
        let thing = ObjectSpec::new("thing", shape).at(x, y, z).scaled(radius, radius, -radius);
        hold(seed, Cause::CameraInsideObject, &case, &scene(vec![thing]));
    }
}

#[test]
fn opened_by_the_near_plane() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |p| p.near = 6.0);
        let radius = case.random.between(1.0, 3.0);
        let depth = 6.0 + radius * case.random.between(-0.3, 0.3);
        let (_, [x, y]) = case.window_at(depth);
        let [x, y, z] = case.world(x, y, depth).to_array();
        let thing = ObjectSpec::new("thing", Shape::Sphere).at(x, y, z).scaled(radius, radius, radius);
        hold(seed, Cause::HiddenByNearCut, &case, &scene(vec![thing]));
    }
}

#[test]
fn fully_transparent() {
    for seed in 0..20 {
        let mut case = Case::new(seed, |_| ());
        let (_, [x, y]) = case.window_at(10.0);
        let at = case.world(x, y, 10.0);
        let thing = case.thing(true, at, 1.0).colored(camera_lab::appearance::Rgba::rgba(20, 40, 60, 0));
        hold(seed, Cause::FullyTransparent, &case, &scene(vec![thing]));
    }
}

#[test]
fn a_thing_in_the_middle_of_the_picture_is_as_it_should_be() {
    for seed in 0..CASES {
        let mut case = Case::new(seed, |_| ());
        let depth = case.random.between(6.0, 40.0);
        let (half, [x, y]) = case.window_at(depth);
        let at = case.world(x, y, depth);
        let thing = case.thing(false, at, (0.7 * half[1]).min(4.5));
        let diagnosis = diagnose(&scene(vec![thing]), &case.camera, &Style::default(), IMAGE).unwrap();
        assert!(diagnosis.findings.is_empty(), "{seed}: {:?}", diagnosis.findings);
        assert!(diagnosis.visible > 19);
    }
}

/// Objects that no single plane keeps out: the floor around an eye that looks up.
#[test]
fn a_floor_around_an_eye_that_looks_up_is_not_in_the_picture() {
    let up = Parameters {
        position: DVec3::new(0.0, 1.0, 0.0),
        focal_point: DVec3::new(1.0, 2.5, 0.3),
        view_angle: 40.0,
        ..Parameters::default()
    };
    for shape in [Shape::Grid, Shape::Box] {
        let floor = ObjectSpec::new("floor", shape).scaled(30.0, 0.01, 30.0);
        let scene = scene(vec![floor]);
        let diagnosis = diagnose(&scene, &Camera::new(&up).unwrap(), &Style::default(), IMAGE).unwrap();
        assert_eq!(diagnosis.visible, 0);
        let first = &diagnosis.findings[0];
        assert!(matches!(first.cause, Cause::OutsideBottom | Cause::BehindCamera), "{first:?}");
        let repair = first.repair.unwrap();
        assert!(pixels(&scene, &repair.camera, &repair.style) > 19);
    }
}

/// Beyond B and to the left: neither repair alone would show it, and the one for the first cause does both.
#[test]
fn two_causes_are_both_named_and_undone_together() {
    let p = Parameters { position: DVec3::ZERO, focal_point: DVec3::NEG_Z, far: 20.0, ..Parameters::default() };
    let thing = ObjectSpec::new("thing", Shape::Sphere).at(-40.0, 0.0, -30.0);
    let scene = scene(vec![thing]);
    let diagnosis = diagnose(&scene, &Camera::new(&p).unwrap(), &Style::default(), IMAGE).unwrap();
    let causes: Vec<Cause> = diagnosis.findings.iter().map(|finding| finding.cause).collect();
    assert_eq!(causes, [Cause::BeyondFar, Cause::OutsideLeft]);
    let repair = diagnosis.findings[0].repair.unwrap();
    assert!(pixels(&scene, &repair.camera, &repair.style) > 19);
}

/// The cause that most objects have comes first, with their names.
#[test]
fn the_cause_of_most_objects_comes_first() {
    let p = Parameters { position: DVec3::ZERO, focal_point: DVec3::NEG_Z, ..Parameters::default() };
    let ball = |name: &str, x: f64, z: f64| ObjectSpec::new(name, Shape::Sphere).at(x, 0.0, z);
    let scene =
        scene(vec![ball("a", -50.0, -10.0), ball("b", 0.0, 10.0), ball("c", 4.0, 20.0), ball("d", 0.0, -200.0)]);
    let diagnosis = diagnose(&scene, &Camera::new(&p).unwrap(), &Style::default(), IMAGE).unwrap();
    let first = &diagnosis.findings[0];
    assert_eq!((first.cause, first.whole.join(" ")), (Cause::BehindCamera, "b c".to_owned()));
    assert_eq!(diagnosis.findings.len(), 3);
}

/// Objects lost whole and objects lost in part for the same reason are one finding, and its repair shows the former.
#[test]
fn a_cause_has_one_finding_with_whole_and_partial_losses() {
    let p = Parameters { position: DVec3::ZERO, focal_point: DVec3::NEG_Z, far: 20.0, ..Parameters::default() };
    let ball = |name: &str, z: f64| ObjectSpec::new(name, Shape::Sphere).at(0.0, 0.0, z).scaled(3.0, 3.0, 3.0);
    let scene = scene(vec![ball("seen", -12.0), ball("in part", -21.0), ball("lost", -40.0)]);
    let diagnosis = diagnose(&scene, &Camera::new(&p).unwrap(), &Style::default(), IMAGE).unwrap();
    let [finding] = &diagnosis.findings[..] else { panic!("{:?}", diagnosis.findings) };
    assert_eq!(finding.cause, Cause::BeyondFar);
    assert_eq!((finding.whole.join(" "), finding.partly.join(" ")), ("lost".to_owned(), "in part".to_owned()));
    assert_eq!(finding.objects().collect::<Vec<_>>(), ["lost", "in part"]);
    let far = finding.repair.unwrap().camera.far;
    assert!(far > 43.0, "{far}");
    let texts = [
        (
            Lang::En,
            "lost: farther than the back plane, −z_c > B: clipping removes what is there. in part: most of it is farther",
        ),
        (
            Lang::PtBr,
            "lost: mais longe que o plano de fundo, −z_c > B: o recorte elimina o que está ali. in part: a maior parte está",
        ),
    ];
    for (lang, text) in texts {
        let said = coach::finding(lang, finding, &diagnosis, &SceneSpec::default());
        assert!(said.starts_with(text), "{said}");
    }
}

#[test]
fn nothing_is_an_empty_scene() {
    let diagnosis =
        diagnose(&Scene::default(), &Camera::new(&Parameters::default()).unwrap(), &Style::default(), IMAGE);
    let diagnosis = diagnosis.unwrap();
    assert_eq!((diagnosis.visible, diagnosis.findings[0].cause), (0, Cause::EmptyScene));
    assert_eq!(diagnosis.findings[0].repair, None);
}
