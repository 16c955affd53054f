//! The three pictures: they agree with the matrices and with each other, and nothing in them covers a text.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::appearance::{Shading, Theme};
use camera_lab::camera::{Camera, Convention, Ndc, Operation, Parameters, Projection, ViewWindow};
use camera_lab::drawing::{Anchor, Drawing, Label};
use camera_lab::figure::{Figure, Observer};
use camera_lab::scene::Preset as ScenePreset;
use camera_lab::text::{measure, x_height};
use camera_lab::views::handles::handles;
use camera_lab::views::observer::Viewpoint;
use camera_lab::views::{self, Ghost, Palette, Probe, Request, SharedScene, Size, TimedPipeline, View};
use camera_lab_words::{Lang, pictures};
use glam::{DVec2, DVec3, DVec4};

/// Pictures of a figure, without the image on the view window.
pub(crate) struct Pictured {
    pub(crate) figure: Figure,
    pub(crate) request: Request,
}

impl Pictured {
    /// The picture of a figure at 320 × 240.
    pub(crate) fn of(figure: Figure) -> Self {
        let camera = Camera::new(&figure.camera).unwrap();
        let scene =
            views::scene_of(&figure, &mut camera_lab::scene::no_files, &camera_lab::progress::Progress::default())
                .unwrap();
        let size = Size { width: 320, height: 240, scale: 1.0 };
        let labels = pictures::labels(Lang::En);
        let request = Request::of(&figure, View::Image, &camera, &SharedScene::new(scene), labels, size);
        Self { figure, request }
    }

    pub(crate) fn sized(mut self, width: u32, height: u32) -> Self {
        self.request.size = Size { width, height, scale: 1.0 };
        self
    }

    pub(crate) fn probed(mut self, probe: Probe) -> Self {
        self.request.hover.probe = Some(probe);
        self
    }

    /// In the NDC of another convention.
    pub(crate) fn in_ndc(mut self, name: &str) -> Self {
        self.request = self
            .request
            .clone()
            .with_shot(|shot| shot.ndc = Ndc::ALL.into_iter().find(|ndc| ndc.name() == name).unwrap());
        self
    }

    /// While `operation` is tried.
    pub(crate) fn tried(mut self, operation: Operation) -> Self {
        let convention = Convention::RightHand;
        let after = operation.apply(&self.request.camera, convention).unwrap();
        let before = std::mem::replace(&mut self.request.camera, after);
        self.request.hover.ghost = Some(Ghost { before, operation, convention });
        self
    }

    /// Without legends.
    pub(crate) fn bare(mut self) -> Self {
        self.request.finish.bare = true;
        self
    }

    /// With every stage, needed or not.
    pub(crate) fn forced(mut self) -> Self {
        self.request.force_all_stages = true;
        self
    }

    pub(crate) fn in_portuguese(mut self) -> Self {
        self.request.labels = pictures::labels(Lang::PtBr);
        self
    }

    /// The image.
    pub(crate) fn request(&self) -> &Request {
        &self.request
    }

    /// A three-dimensional picture as an observer sees it.
    pub(crate) fn seen_by(&self, view: View, observer: Observer) -> Request {
        Request { view, ..self.request.clone() }.seen_by(Some(observer))
    }

    pub(crate) fn observer(&self, view: View, viewpoint: Viewpoint) -> Observer {
        Request { view, ..self.request.clone() }.observer_from(viewpoint).unwrap()
    }

    pub(crate) fn image(&self) -> Drawing {
        draw(&self.request)
    }

    pub(crate) fn world(&self, viewpoint: Viewpoint) -> Drawing {
        draw(&self.seen_by(View::World, self.observer(View::World, viewpoint)))
    }

    pub(crate) fn canonical(&self, viewpoint: Viewpoint) -> Drawing {
        draw(&self.seen_by(View::Canonical, self.observer(View::Canonical, viewpoint)))
    }

    /// The place of a point in an observer's picture, in pixels.
    fn place(&self, observer: &Observer, p: DVec3) -> DVec2 {
        let aspect = f64::from(self.request.size.width) / f64::from(self.request.size.height);
        let clip = observer.camera(None, aspect).unwrap().clip_from_world() * p.extend(1.0);
        self.pixel(clip)
    }

    fn pixel(&self, clip: DVec4) -> DVec2 {
        let (x, y) = (clip.x / clip.w, clip.y / clip.w);
        DVec2::new(
            f64::from(self.request.size.width) * (0.5 + 0.5 * x),
            f64::from(self.request.size.height) * (0.5 - 0.5 * y),
        )
    }
}

/// The drawing of a view, with a plain view window.
pub(crate) fn draw(request: &Request) -> Drawing {
    views::frame(request, None, &mut TimedPipeline::default()).drawing
}

pub(crate) fn figure(change: impl FnOnce(&mut Parameters)) -> Figure {
    let mut figure = Figure::default();
    change(&mut figure.camera);
    figure
}

/// The figure with a scene that is drawn fast.
fn simple(mut figure: Figure) -> Figure {
    figure.scene.preset = ScenePreset::Cube;
    figure
}

/// Cameras that a careless picture would spoil.
pub(crate) fn cameras() -> Vec<(&'static str, Figure)> {
    vec![
        ("default", figure(|_| {})),
        ("short", figure(|c| (c.near, c.far) = (2.0, 12.0))),
        ("parallel", figure(|c| (c.projection, c.height, c.near, c.far) = (Projection::Parallel, 4.0, 2.0, 10.0))),
        (
            "asymmetric",
            figure(|c| {
                (c.near, c.far) = (2.0, 12.0);
                c.window = Some(ViewWindow { left: -1.0, right: 0.2, bottom: -0.3, top: 1.2 });
            }),
        ),
        ("inside", figure(|c| (c.position, c.focal_point, c.near) = (DVec3::new(0.2, 0.6, 0.3), DVec3::X, 0.3))),
        ("far away", figure(|c| (c.near, c.far) = (1e-4, 1e6))),
        ("below", figure(|c| (c.position, c.near, c.far) = (DVec3::new(3.0, -3.0, 4.0), 1.5, 10.0))),
        ("straight down", figure(|c| (c.position, c.view_up, c.near) = (DVec3::Y * 6.0, DVec3::NEG_Z, 2.0))),
        ("narrow", figure(|c| (c.view_angle, c.near, c.far) = (3.0, 3.0, 20.0))),
        ("wide", figure(|c| (c.view_angle, c.near, c.far) = (160.0, 1.0, 20.0))),
        ("tall", figure(|c| (c.aspect, c.near, c.far) = (0.2, 2.0, 9.0))),
        ("focal point beyond all", figure(|c| c.focal_point = DVec3::new(-3e5, -4e5, -5e5))),
    ]
}

const VIEWPOINTS: [Viewpoint; 4] = [Viewpoint::Front, Viewpoint::Top, Viewpoint::Side, Viewpoint::Iso];

/// Left, top, right, bottom of a text in pixels.
fn text_box(label: &Label) -> [f32; 4] {
    let extent = measure(&label.text, label.size, label.mathematical);
    assert_eq!(label.anchor, Anchor::Center);
    let (x, y) = (label.position[0] + label.offset[0], label.position[1] + label.offset[1]);
    let (half, middle) = (extent.width / 2.0, x_height(label.size) / 2.0);
    [x - half, y - extent.above + middle, x + half, y + extent.below + middle]
}

#[test]
fn no_text_covers_another_and_none_is_cut_off() {
    for (name, figure) in cameras() {
        for (width, height) in [(320, 240), (640, 480), (300, 700)] {
            let pictured = Pictured::of(simple(figure.clone())).sized(width, height).probed(Probe::Point(DVec3::ONE));
            for viewpoint in VIEWPOINTS {
                for (view, drawing) in
                    [("world", pictured.world(viewpoint)), ("canonical", pictured.canonical(viewpoint))]
                {
                    let what = format!("{name}, {view}, {viewpoint:?}, {width} × {height}");
                    let boxes: Vec<_> = drawing.labels.iter().map(|l| (text_box(l), &l.text)).collect();
                    for (i, ([l, t, r, b], text)) in boxes.iter().enumerate() {
                        let inside = *l >= -1.0 && *t >= -1.0 && *r <= width as f32 + 1.0 && *b <= height as f32 + 1.0;
                        assert!(inside, "{what}: {text} is cut off");
                        for ([ol, ot, or, ob], other) in &boxes[i + 1..] {
                            let apart = r <= ol || or <= l || b <= ot || ob <= t;
                            assert!(apart, "{what}: {text} and {other} overlap");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn the_camera_has_its_names_in_every_world() {
    for (name, figure) in cameras() {
        let world = Pictured::of(figure).sized(640, 480).world(Viewpoint::Iso);
        for symbol in ["C", "u", "v", "n", "VUP"] {
            assert!(world.labels.iter().any(|l| l.text == symbol), "{name}: {symbol} is missing");
        }
    }
}

#[test]
fn the_volume_drawn_is_the_inverse_of_the_matrices() {
    for (name, figure) in cameras() {
        let pictured = Pictured::of(figure);
        let palette = Palette::of(pictured.figure.style.theme);
        let observer = pictured.observer(View::World, Viewpoint::Iso);
        let world = draw(&pictured.seen_by(View::World, observer));
        // Near corners by a numerical inverse. The library has its own in closed form.
        let world_from_clip = pictured.request.camera.clip_from_world().inverse();
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let corner = world_from_clip * DVec4::new(x, y, -1.0, 1.0);
            let place = pictured.place(&observer, corner.truncate() / corner.w);
            let in_picture = place.cmpgt(DVec2::ZERO).all() && place.cmplt(DVec2::new(320.0, 240.0)).all();
            let frames = world.strokes.iter().filter(|s| s.style.color == palette.ink);
            let drawn = frames
                .flat_map(|s| &s.points)
                .any(|p| DVec2::new(f64::from(p[0]), f64::from(p[1])).distance(place) < 0.05);
            assert!(drawn || !in_picture, "{name}: the window's corner ({x}, {y}) at {place}");
        }
    }
}

#[test]
fn camera_and_scene_are_in_the_picture_and_large_enough_to_be_read() {
    for scene in [ScenePreset::Primitives, ScenePreset::House, ScenePreset::Corridor, ScenePreset::NdcCube] {
        for (name, mut figure) in cameras() {
            figure.scene.preset = scene;
            let pictured = Pictured::of(figure).sized(640, 480);
            let bounds = pictured.request.scene.bounds().unwrap();
            for viewpoint in VIEWPOINTS {
                let observer = pictured.observer(View::World, viewpoint);
                let what = format!("{scene:?}, {name}, {viewpoint:?}");
                let c = pictured.place(&observer, pictured.request.camera.position());
                let corners = bounds.corners().map(|p| pictured.place(&observer, p));
                for place in corners.iter().chain([&c]) {
                    assert!(place.cmpge(DVec2::ZERO).all() && place.x <= 640.0 && place.y <= 480.0, "{what}: {place}");
                }
                let size = corners.iter().flat_map(|a| corners.iter().map(|b| a.distance(*b))).fold(0.0, f64::max);
                // The volume of a very wide angle is shown whole, and is far larger than the scene.
                let least = if name == "wide" { 6.0 } else { 40.0 };
                assert!(size > least, "{what}: the scene is {size:.0} px large");
            }
        }
    }
}

#[test]
fn the_whole_volume_is_in_the_picture_also_of_a_very_wide_angle() {
    for degrees in [42.0, 90.0, 120.0, 140.0, 160.0] {
        let pictured = Pictured::of(figure(|c| (c.view_angle, c.near, c.far) = (degrees, 3.0, 12.0))).sized(640, 480);
        let observer = pictured.observer(View::World, Viewpoint::Iso);
        for corner in pictured.request.camera.volume_corners() {
            let place = pictured.place(&observer, corner);
            let inside = place.cmpge(DVec2::ZERO).all() && place.x <= 640.0 && place.y <= 480.0;
            // A plane that is drawn nearer than it is has a break mark, and does not go beyond the frame either.
            let broken = pictured.world(Viewpoint::Iso).labels.iter().any(|l| l.text == "far (B = 12)");
            assert!(inside || broken, "{degrees}°: {place}");
        }
    }
}

#[test]
fn the_canonical_front_view_is_the_image() {
    // Seen from before its near face, the canonical volume looks like the image: M_p has turned every projection into
    // the parallel one along z_n.
    for (name, figure) in cameras() {
        let aspect = figure.camera.aspect;
        let pictured = Pictured::of(figure).sized(400, 300);
        let observer = pictured.observer(View::Canonical, Viewpoint::Front);
        let image = views::image_frame(
            pictured.request.size,
            pictured.request.shot.look.image_aspect(&pictured.request.camera),
        );
        let corner = |x, y| pictured.place(&observer, DVec3::new(x, y, 1.0));
        let (low, high) = (corner(-1.0, 1.0), corner(1.0, -1.0));
        for p in [DVec3::new(0.1, 0.2, 0.3), DVec3::new(-0.5, 0.4, 0.2), DVec3::new(0.6, 0.1, -0.7)] {
            let clip = pictured.request.camera.clip_from_world() * p.extend(1.0);
            let ndc = clip.truncate() / clip.w;
            let shown = pictured.place(&observer, DVec3::new(ndc.x, ndc.y, -ndc.z));
            let share = (shown - low) / (high - low);
            let in_image = DVec2::new(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y);
            assert!((share - in_image).length() < 1e-6, "{name}: {share} and {in_image}");
        }
        assert!(image.width <= 400 && image.height <= 300, "{name} {aspect}");
    }
}

#[test]
fn one_probe_marks_the_same_point_in_all_three() {
    let p = DVec3::new(0.4, 0.7, 0.2);
    let pictured = Pictured::of(figure(|c| (c.near, c.far, c.aspect) = (2.0, 12.0, 1.0))).probed(Probe::Point(p));
    let color = Palette::of(Theme::Light).probe;
    let has_mark = |drawing: &Drawing, place: DVec2| {
        let at = |m: &camera_lab::drawing::Mark| DVec2::new(f64::from(m.position[0]), f64::from(m.position[1]));
        drawing.marks.iter().any(|m| m.color == color && at(m).distance(place) < 0.01)
    };
    let clip = pictured.request.camera.clip_from_world() * p.extend(1.0);
    let ndc = clip.truncate() / clip.w;

    let observer = pictured.observer(View::World, Viewpoint::Iso);
    assert!(has_mark(&pictured.world(Viewpoint::Iso), pictured.place(&observer, p)));
    let observer = pictured.observer(View::Canonical, Viewpoint::Iso);
    let shown = DVec3::new(ndc.x, ndc.y, -ndc.z);
    assert!(has_mark(&pictured.canonical(Viewpoint::Iso), pictured.place(&observer, shown)));
    // The image of 1024 × 768 in 320 × 240, though the window is square.
    let place = DVec2::new(160.0 * (1.0 + ndc.x), 120.0 * (1.0 - ndc.y));
    assert!(has_mark(&pictured.image(), place));
    // The frame of a square window.
    let figure = figure(|c| (c.near, c.far, c.aspect) = (2.0, 12.0, 1.0));
    let undistorted = Pictured::of(Figure { undistorted: true, ..figure }).probed(Probe::Point(p));
    let place = DVec2::new(40.0 + 120.0 * (1.0 + ndc.x), 120.0 * (1.0 - ndc.y));
    assert!(has_mark(&undistorted.image(), place));
}

#[test]
fn a_pixels_ray_ends_on_the_surface_the_pixel_shows() {
    // The ray through the middle of the window is the axis of projection: both meet the cube about PF in the same
    // point.
    let mut figure = figure(|c| (c.position, c.near, c.far) = (DVec3::new(0.0, 0.0, 6.0), 2.0, 12.0));
    figure.scene.preset = ScenePreset::Cube;
    let pictured = Pictured::of(figure).probed(Probe::Window(DVec2::ZERO));
    let observer = pictured.observer(View::World, Viewpoint::Iso);
    let world = draw(&pictured.seen_by(View::World, observer));
    let color = Palette::of(Theme::Light).probe;
    let hit = pictured.place(&observer, DVec3::Z);
    let at = |m: &camera_lab::drawing::Mark| DVec2::new(f64::from(m.position[0]), f64::from(m.position[1]));
    assert!(world.marks.iter().any(|m| m.color == color && at(m).distance(hit) < 0.01));
}

#[test]
fn in_wireframe_the_scene_loses_its_faces_and_the_camera_keeps_its() {
    let mut figure = figure(|_| {});
    let faces = |figure: &Figure| Pictured::of(figure.clone()).world(Viewpoint::Iso).surfaces.len();
    let shaded = faces(&figure);
    figure.style.shading = Shading::Wireframe;
    let wired = faces(&figure);
    figure.scene.preset = ScenePreset::Empty;
    assert_eq!(wired, faces(&figure));
    assert!(0 < wired && wired < shaded);
}

#[test]
fn an_observer_that_is_not_a_camera_gives_an_empty_picture() {
    let pictured = Pictured::of(figure(|_| {}));
    let nowhere =
        Observer { target: DVec3::ZERO, distance: f64::NAN, azimuth: 0.0, elevation: 0.0, roll: 0.0, parallel: false };
    for drawing in [draw(&pictured.seen_by(View::World, nowhere)), draw(&pictured.seen_by(View::Canonical, nowhere))] {
        assert_eq!((drawing.width, drawing.height), (320, 240));
        assert!(drawing.surfaces.is_empty() && drawing.strokes.is_empty() && drawing.labels.is_empty());
    }
}

#[test]
fn cameras_of_any_size_make_finite_pictures() {
    let finite = |drawing: &Drawing| {
        let points = drawing.surfaces.iter().flat_map(|s| &s.positions);
        let points = points.chain(drawing.strokes.iter().flat_map(|s| &s.points));
        points.chain(drawing.labels.iter().map(|l| &l.position)).all(|p| p.iter().all(|v| v.is_finite()))
    };
    for exponent in [-150, -20, -6, 6, 12, 20, 150] {
        let unit = 10.0_f64.powi(exponent);
        for at in [DVec3::ZERO, DVec3::splat(1e12)] {
            for projection in [Projection::Perspective, Projection::Parallel] {
                let figure = figure(|c| {
                    c.position = c.position * unit + at;
                    c.focal_point = at;
                    c.projection = projection;
                    (c.height, c.near, c.far) = (4.0 * unit, 0.1 * unit, 1e6 * unit);
                });
                // Far from the origin C and PF may be one point: that is no camera, and no picture is asked for.
                if Camera::new(&figure.camera).is_err() {
                    continue;
                }
                let pictured = Pictured::of(simple(figure)).probed(Probe::Window(DVec2::ZERO));
                for viewpoint in VIEWPOINTS {
                    let what = format!("1e{exponent} at {at}, {projection:?}, {viewpoint:?}");
                    assert!(finite(&pictured.world(viewpoint)), "world, {what}");
                    assert!(finite(&pictured.canonical(viewpoint)), "canonical, {what}");
                    let _ = handles(&pictured.seen_by(View::World, pictured.observer(View::World, viewpoint)));
                }
                assert!(finite(&pictured.image()), "image, 1e{exponent} at {at}");
            }
        }
    }
}

#[test]
fn a_picture_at_twice_the_scale_is_the_same_picture_with_twice_the_pixels() {
    let one = Pictured::of(figure(|c| (c.near, c.far) = (2.0, 12.0)));
    let mut two = Pictured::of(one.figure.clone());
    two.request.size = Size { width: 640, height: 480, scale: 2.0 };
    let (one, two) = (one.world(Viewpoint::Iso), two.world(Viewpoint::Iso));
    assert_eq!(one.labels.len(), two.labels.len());
    for (a, b) in one.labels.iter().zip(&two.labels) {
        assert_eq!(a.text, b.text);
        let apart = (0..2).map(|k| (2.0 * (a.position[k] + a.offset[k]) - b.position[k] - b.offset[k]).abs());
        assert!(apart.fold(0.0, f32::max) < 0.1, "{}", a.text);
    }
}

/// `[show] operation` names the operation with its value in all three pictures. Each of several has its number, and the
/// world names the camera before them.
#[test]
fn the_operations_of_a_figure_are_drawn_in_every_picture() {
    let texts = |drawing: &Drawing| drawing.labels.iter().map(|label| label.text.clone()).collect::<Vec<_>>();
    let mut shown = figure(|_| {});
    shown.show.operations = vec!["azimuth=40".parse().unwrap()];
    let plain = Pictured::of(figure(|_| {})).sized(900, 600);
    let one = Pictured::of(shown.clone()).sized(900, 600);
    let draw = |of: &Pictured| [of.world(Viewpoint::Iso), of.canonical(Viewpoint::Iso), of.image()];
    for (with, without) in draw(&one).iter().zip(&draw(&plain)) {
        assert!(texts(with).iter().any(|text| text == "Azimuth 40°"), "{:?}", texts(with));
        assert!(!texts(without).iter().any(|text| text.contains("40°")));
        assert!(with.strokes.len() > without.strokes.len());
    }
    assert!(texts(&draw(&one)[0]).iter().any(|text| text == "before"));
    shown.show.operations.push("zoom=2".parse().unwrap());
    for drawing in draw(&Pictured::of(shown).sized(900, 600)) {
        for text in ["1. Azimuth 40°", "2. Zoom × 2"] {
            assert!(texts(&drawing).iter().any(|found| found == text), "{text}: {:?}", texts(&drawing));
        }
    }
}
