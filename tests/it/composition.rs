//! The composition of the pictures of every shipped figure, at the sizes that occur, read from their drawings.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::path::{Path, PathBuf};
use std::sync::Arc;

use camera_lab::appearance::{Dash, Texture};
use camera_lab::camera::{Camera, Convention, Operation, Projection};
use camera_lab::drawing::{Anchor, Base, Drawing, Label};
use camera_lab::figure::{Figure, Observer};
use camera_lab::figure::{Measure, Measured};
use camera_lab::geometry::Angle;
use camera_lab::progress::Progress;
use camera_lab::text::{measure, x_height};
use camera_lab::views::observer::Viewpoint;
use camera_lab::views::{self, Palette, Probe, Request, SharedScene, Size, TimedPipeline, View};
use camera_lab_files::{FigureFiles, FileAccess, open_figure};
use camera_lab_words::{Lang, pictures};
use glam::{DVec2, DVec3, DVec4};

use crate::views::draw;

/// The shapes of panes in the window, and of pictures on paper.
const SIZES: [(u32, u32); 4] = [(420, 500), (640, 360), (960, 540), (1024, 768)];

/// The shipped figures with their scenes.
fn shipped() -> Vec<(String, Figure, SharedScene)> {
    let mut paths: Vec<PathBuf> = ["assets/figures", "assets/figures/pipeline", "docs/figures"]
        .into_iter()
        .flat_map(|folder| std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap())
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .collect();
    paths.sort();
    assert!(paths.len() > 20);
    let open = |path: &PathBuf| {
        let figure = open_figure(path).unwrap().figure;
        let mut files = FigureFiles::new(path.parent().unwrap(), FileAccess::Figure);
        let scene = views::scene_of(&figure, &mut |wanted| files.read(wanted), &Progress::default()).unwrap();
        (path.file_stem().unwrap().to_string_lossy().into_owned(), figure, SharedScene::new(scene))
    };
    paths.iter().map(open).collect()
}

fn world(figure: &Figure, scene: &SharedScene, (width, height): (u32, u32)) -> Request {
    let camera = Camera::new(&figure.camera).unwrap();
    let size = Size { width, height, scale: 1.0 };
    Request::of(figure, View::World, &camera, scene, pictures::labels(Lang::En), size)
}

/// The place of a point in an observer's picture, by the observer's own matrix.
fn place(request: &Request, observer: &Observer, p: DVec3) -> DVec2 {
    let camera = observer.camera(None, request.size.aspect()).unwrap();
    let clip = camera.clip_from_world() * p.extend(1.0);
    let size = DVec2::new(f64::from(request.size.width), f64::from(request.size.height));
    size * DVec2::new(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w)
}

/// Polylines of a colour: their points in pixels.
fn polylines(drawing: &Drawing, color: camera_lab::appearance::Rgba, dash: Dash) -> Vec<Vec<DVec2>> {
    let of_color = drawing.strokes.iter().filter(|s| s.style.color == color && s.style.dash == dash);
    of_color
        .flat_map(|s| {
            s.polylines.iter().map(|range| {
                let points = &s.points[range.start as usize..range.end as usize];
                points.iter().map(|p| DVec2::new(f64::from(p[0]), f64::from(p[1]))).collect()
            })
        })
        .collect()
}

/// Asks that the picture holds camera, PF, the window and the whole far face, drawn and named.
fn assert_whole(name: &str, request: &Request) {
    let drawing = draw(request);
    let observer = request.seen_from().unwrap();
    let palette = Palette::of(request.shot.look.style.theme);
    let size = DVec2::new(f64::from(request.size.width), f64::from(request.size.height));
    let what = format!("{name}, {size}");
    let inside = |p: DVec2| p.cmpgt(DVec2::splat(8.0)).all() && p.cmplt(size - 8.0).all();
    let camera = &request.camera;
    for (of, p) in [("C", camera.position()), ("PF", camera.focal_point())] {
        assert!(inside(place(request, &observer, p)), "{what}: {of}");
        assert!(drawing.labels.iter().any(|l| l.text == of), "{what}: {of} has no name");
    }
    let edges: Vec<_> = polylines(&drawing, palette.volume_edge, Dash::Solid).concat();
    let frame: Vec<_> = polylines(&drawing, palette.ink, Dash::Solid).concat();
    let dashed = polylines(&drawing, palette.volume_edge, Dash::Dashed);
    let far: Vec<_> = dashed.iter().filter(|line| line.len() == 5 && line[0].distance(line[4]) < 1e-3).collect();
    assert_eq!(far.len(), 1, "{what}: one far face, uncut");
    assert!(far[0].iter().all(|p| inside(*p)), "{what}: {:?}", far[0]);
    let is_broken = drawing.labels.iter().any(|l| l.text.contains("(B = "));
    // By a numerical inverse of the matrices. The library has its own in closed form.
    let world_from_clip = camera.clip_from_world().inverse();
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        for z in [-1.0, 1.0] {
            let corner = world_from_clip * DVec4::new(x, y, z, 1.0);
            let px = place(request, &observer, corner.truncate() / corner.w);
            let drawn = |points: &[DVec2]| points.iter().any(|p| p.distance(px) < 0.1);
            if z < 0.0 {
                assert!(inside(px) && drawn(&frame) && drawn(&edges), "{what}: window at {px}");
            } else if is_broken {
                assert!(!drawn(&edges), "{what}: the far face is nearer");
            } else {
                assert!(inside(px) && drawn(far[0]) && drawn(&edges), "{what}: far face at {px}");
            }
        }
    }
}

#[test]
fn every_shipped_figure_shows_its_whole_volume_and_so_does_fit() {
    for (name, figure, scene) in shipped() {
        for size in SIZES {
            let automatic = world(&figure, &scene, size).seen_by(None);
            assert_whole(&name, &automatic);
            // From a side of one's own, far off.
            let turned = Observer {
                target: DVec3::splat(50.0),
                distance: 3.0,
                azimuth: automatic.seen_from().unwrap().azimuth - 25.0,
                elevation: 31.0,
                roll: 0.0,
                parallel: size.0 == 640,
            };
            let fitted = automatic.fitted(&turned);
            assert_eq!(fitted.map(|o| (o.azimuth, o.elevation)), Some((turned.azimuth, turned.elevation)));
            assert_whole(&format!("{name}, fitted"), &automatic.seen_by(fitted));
        }
    }
}

#[test]
fn a_far_plane_that_would_dwarf_the_scene_is_drawn_nearer_and_says_so() {
    let (_, figure, scene) = shipped().into_iter().find(|(name, ..)| name == "primitives").unwrap();
    let palette = Palette::of(figure.style.theme);
    let mut broken = Vec::new();
    for far in [12.0, 15.0, 40.0, 1000.0, 1e9] {
        let mut figure = figure.clone();
        figure.camera.far = far;
        let request = world(&figure, &scene, (640, 480));
        let drawing = draw(&request);
        let name = drawing.labels.iter().find(|l| l.text.starts_with("far")).unwrap();
        broken.push(name.text.clone());
        let observer = request.seen_from().unwrap();
        let [c, pf] = [request.camera.position(), request.camera.focal_point()].map(|p| place(&request, &observer, p));
        assert!(c.distance(pf) > 120.0, "B = {far}: C and PF are {} px apart", c.distance(pf));
        // Two strokes end each of the four long edges' parts. On the whole volume there are none.
        let short = polylines(&drawing, palette.volume_edge, Dash::Solid)
            .into_iter()
            .filter(|line| line.len() == 2 && line[0].distance(line[1]) < 16.0)
            .count();
        assert_eq!(short, if name.text.contains('=') { 8 } else { 0 }, "B = {far}");
    }
    assert_eq!(broken[0], "far (B)");
    assert_eq!(broken[2..], ["far (B = 40)", "far (B = 1000)", "far (B = 1000000000)"]);
}

#[test]
fn an_automatic_observer_keeps_clear_of_dop_u_v_and_n() {
    let (_, figure, scene) = shipped().into_iter().find(|(name, ..)| name == "primitives").unwrap();
    let mut request = world(&figure, &scene, (640, 480));
    for step in 1..=24 {
        let turn = Operation::Azimuth(Angle::from_degrees(15.0));
        request.camera = turn.apply(&request.camera, Convention::RightHand).unwrap();
        let observer = request.seen_from().unwrap();
        let request = request.clone().seen_by(Some(observer));
        let camera = &request.camera;
        let c = place(&request, &observer, camera.position());
        let pf = place(&request, &observer, camera.focal_point());
        assert!(c.distance(pf) > 40.0, "{step}: C and PF are {} px apart", c.distance(pf));
        let [_, _, back] = observer.axes();
        let basis = camera.basis();
        for axis in [basis.u, basis.v, basis.n] {
            assert!(axis.dot(back).abs() < 18_f64.to_radians().cos() + 1e-9, "{step}: {axis} {back}");
        }
    }
    let turned = Observer { azimuth: 10.0, ..request.seen_from().unwrap() };
    assert_eq!(request.fitted(&turned).unwrap().azimuth, 10.0, "what a hand has turned stays");
}

#[test]
fn along_u_is_the_side_figure_of_the_notes_and_along_n_what_the_camera_sees() {
    for (name, figure, scene) in shipped() {
        let request = world(&figure, &scene, (640, 480));
        let (camera, basis) = (&request.camera, request.camera.basis());
        let at = |viewpoint: Viewpoint, p: DVec3| {
            let observer = request.observer_from(viewpoint).unwrap();
            place(&request, &observer, p)
        };
        let (c, pf) = (camera.position(), camera.focal_point());
        for viewpoint in [Viewpoint::AlongU, Viewpoint::AlongV] {
            let way = at(viewpoint, pf) - at(viewpoint, c);
            assert!(way.x > 60.0 && way.y.abs() < 1e-6, "{name}: DOP goes to the right, {way}");
        }
        let up = at(Viewpoint::AlongU, c + basis.v) - at(Viewpoint::AlongU, c);
        assert!(up.y < 0.0 && up.x.abs() < 1e-6, "{name}: v goes up, {up}");
        let [u, v] = [basis.u, basis.v].map(|axis| at(Viewpoint::AlongN, c + axis) - at(Viewpoint::AlongN, c));
        assert!(u.x > 0.0 && u.y.abs() < 1e-6 && v.y < 0.0 && v.x.abs() < 1e-6, "{name}: {u} {v}");
        assert!(at(Viewpoint::AlongN, pf).distance(at(Viewpoint::AlongN, c)) < 1e-6);
        assert_whole(&format!("{name}, along u"), &request.clone().seen_by(request.observer_from(Viewpoint::AlongU)));
    }
}

/// Left, top, right, bottom of a text in pixels.
fn text_box(label: &Label) -> [f32; 4] {
    let extent = measure(&label.text, label.size, label.mathematical);
    let (x, y) = (label.position[0] + label.offset[0], label.position[1] + label.offset[1]);
    let left = if label.anchor == Anchor::Center { x - extent.width / 2.0 } else { x };
    let middle = x_height(label.size) / 2.0;
    [left, y - extent.above + middle, left + extent.width, y + extent.below + middle]
}

#[test]
fn texts_keep_clear_of_each_other_of_marks_and_of_the_frame_in_every_figure() {
    let sizes = [(420, 500, 1.0), (640, 360, 1.0), (422, 543, 1.8), (320, 240, 1.0)];
    for (name, figure, scene) in shipped() {
        for ((width, height, scale), lang) in
            sizes.into_iter().flat_map(|s| [Lang::En, Lang::PtBr].map(|lang| (s, lang)))
        {
            for view in [View::World, View::Canonical] {
                let size = Size { width, height, scale };
                let camera = Camera::new(&figure.camera).unwrap();
                let drawing = draw(&Request::of(&figure, view, &camera, &scene, pictures::labels(lang), size));
                let what = format!("{name}, {view:?}, {width} × {height}, {lang:?}");
                let boxes: Vec<_> = drawing.labels.iter().map(|l| (text_box(l), l)).collect();
                for (i, ([l, t, r, b], label)) in boxes.iter().enumerate() {
                    let text = &label.text;
                    let inside = *l >= -0.5 && *t >= -0.5 && *r <= width as f32 + 0.5 && *b <= height as f32 + 0.5;
                    assert!(inside, "{what}: {text} is cut off");
                    for ([ol, ot, or, ob], other) in &boxes[i + 1..] {
                        assert!(r <= ol || or <= l || b <= ot || ob <= t, "{what}: {text} and {}", other.text);
                    }
                    let [x, y, _] = label.position;
                    let covers = x > *l && x < *r && y > *t && y < *b && label.offset != [0.0; 2];
                    assert!(!covers, "{what}: {text} covers what it names");
                }
                if view == View::World {
                    for text in ["C", "PF"] {
                        assert!(drawing.labels.iter().any(|l| l.text == text), "{what}: {text} is missing");
                    }
                }
            }
        }
    }
}

/// The text that begins so, and the place of its middle.
fn text_at<'a>(drawing: &'a Drawing, start: &str) -> Option<(&'a str, DVec2)> {
    let label = drawing.labels.iter().find(|l| l.text.starts_with(start))?;
    let x = f64::from(label.position[0] + label.offset[0]);
    Some((&label.text, DVec2::new(x, f64::from(label.position[1] + label.offset[1]))))
}

#[test]
fn dimension_lines_are_as_long_as_they_say() {
    let (_, mut figure, scene) = shipped().into_iter().find(|(name, ..)| name == "primitives").unwrap();
    figure.world.dimensions = true;
    let request = world(&figure, &scene, (960, 720));
    let drawing = draw(&request);
    let observer = request.seen_from().unwrap();
    let (camera, palette) = (&request.camera, Palette::of(figure.style.theme));
    // By hand: W = A H, H = 2 F tan(θ/2), D = √50.
    for text in ["F = 3", "B = 12", "D = 7.071", "W = 3.071", "H = 2.303", "θ/2 = 21°"] {
        assert!(drawing.labels.iter().any(|l| l.text == text), "{text} is missing");
    }
    let tips: Vec<DVec2> =
        polylines(&drawing, palette.soft, Dash::Solid).into_iter().filter_map(|line| line.last().copied()).collect();
    // Each line along DOP ends as far from C as its number says, somewhere below the axis.
    for distance in [camera.near(), camera.far(), camera.distance()] {
        let found = (1..400).any(|i| {
            let below = camera.basis().v * (-0.01 * f64::from(i));
            let [a, b] = [0.0, distance].map(|d| {
                let p = camera.position() + camera.direction_of_projection() * d + below;
                place(&request, &observer, p)
            });
            [a, b].iter().all(|end| tips.iter().any(|tip| tip.distance(*end) < 0.6))
        });
        assert!(found, "no line of length {distance}");
    }
    figure.world.dimensions = false;
    let mut request = world(&figure, &scene, (960, 720));
    assert_eq!(text_at(&draw(&request), "F = "), None);
    request.hover.measured = vec![Measured::Dimension(Measure::Far)];
    let measured = draw(&request);
    assert_eq!(text_at(&measured, "B = ").unwrap().0, "B = 12");
    assert_eq!(text_at(&measured, "F = "), None);
}

#[test]
fn the_section_constructs_the_image_of_a_point_by_similar_triangles() {
    for (name, mut figure, scene) in shipped() {
        figure.world.section = true;
        figure.show.probe = None;
        // With an observer of its own, which a section does not heed.
        figure.observers.world = world(&figure, &scene, SIZES[0]).observer_from(Viewpoint::Top);
        for size in SIZES {
            let mut request = world(&figure, &scene, size);
            let camera = request.camera.clone();
            let depth = 0.5 * (camera.near() + camera.distance().max(camera.near() * 1.5));
            let p = camera.position() - camera.basis().n * depth
                + camera.basis().v * (0.3 * camera.window().height())
                + camera.basis().u * 0.1;
            request.hover.probe = Some(Probe::Point(p));
            let drawing = draw(&request);
            let what = format!("{name}, {size:?}");
            let color = Palette::of(figure.style.theme).probe;
            let marks: Vec<DVec2> = drawing
                .marks
                .iter()
                .filter(|m| m.color == color)
                .map(|m| DVec2::new(f64::from(m.position[0]), f64::from(m.position[1])))
                .collect();
            let [shown, image] = marks[..] else { panic!("{what}: {marks:?}") };
            let observer = request.seen_from().unwrap();
            let c = place(&request, &observer, camera.position());
            let ahead = place(&request, &observer, camera.position() + camera.direction_of_projection());
            let unit = ahead.x - c.x;
            assert!(unit > 0.0 && (ahead.y - c.y).abs() < 1e-6, "{what}: DOP goes to the right");
            let clip = camera.clip_from_world() * p.extend(1.0);
            let y_p =
                clip.y / clip.w * camera.window().height() / 2.0 + (camera.window().top + camera.window().bottom) / 2.0;
            assert!((shown - c - unit * DVec2::new(depth, -0.3 * camera.window().height())).length() < 0.1, "{what}");
            assert!((image - c - unit * DVec2::new(camera.near(), -y_p)).length() < 0.1, "{what}: y_p = {y_p}");
            let inside = |p: DVec2| p.cmpgt(DVec2::ZERO).all() && p.x < f64::from(size.0) && p.y < f64::from(size.1);
            assert!(inside(shown) && inside(image) && inside(c), "{what}");
            assert!(drawing.labels.iter().any(|l| l.text.starts_with("B = ")), "{what}");
            assert!(drawing.labels.iter().any(|l| l.text.starts_with("vertex (")), "{what}: which point it is");
        }
    }
}

#[test]
fn the_section_takes_the_scenes_p_if_it_has_an_image_else_a_vertex() {
    let mut figure = Figure::of_preset(camera_lab::scene::Preset::Exercise51);
    let scene =
        SharedScene::new(views::scene_of(&figure, &mut camera_lab::scene::no_files, &Progress::default()).unwrap());
    figure.world.section = true;
    let names = |scene: &SharedScene| -> Vec<String> {
        draw(&world(&figure, scene, (960, 540))).labels.into_iter().map(|label| label.text).collect()
    };
    let of_exercise = names(&scene);
    assert!(!of_exercise.iter().any(|text| text == "P"), "the P of the exercise is in the plane of the eye");
    assert!(of_exercise.iter().any(|text| text.starts_with("vertex (")), "{of_exercise:?}");
    let mut moved = camera_lab::scene::Scene::clone(&scene);
    moved.texts.iter_mut().find(|text| text.text == "P").unwrap().position = DVec3::new(0.5, 1.0, 0.0);
    let moved = names(&SharedScene::new(moved));
    assert!(moved.iter().any(|text| text == "P"), "{moved:?}");
    assert!(!moved.iter().any(|text| text.starts_with("vertex")), "{moved:?}");
}

#[test]
fn the_painted_window_fades_if_it_would_hide_the_scene() {
    let (_, figure, scene) = shipped().into_iter().find(|(name, ..)| name == "primitives").unwrap();
    let opacity = |figure: &Figure| {
        let request = world(figure, &scene, (480, 400));
        let image = Arc::new(Texture::flat(2, 1, vec![255, 255, 255, 255, 0, 0, 0, 255]));
        let frame = views::frame(&request, Some(&image), &mut TimedPipeline::default());
        frame.drawing.surfaces.iter().find_map(|s| match &s.base {
            Base::Texture { tint, .. } => Some(tint.a),
            _ => None,
        })
    };
    assert_eq!(opacity(&figure), Some(255), "it stands before little");
    let mut parallel = figure.clone();
    (parallel.camera.projection, parallel.camera.height) = (Projection::Parallel, 5.5);
    let faint = opacity(&parallel).unwrap();
    assert!(faint < 160, "{faint}");
    for (wanted, given) in [(Some(0.0), None), (Some(0.4), Some(102)), (Some(1.0), Some(255))] {
        parallel.world.window_opacity = wanted;
        assert_eq!(opacity(&parallel), given);
    }
}
