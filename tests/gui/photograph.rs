//! The photograph under the image: chosen, shown, removed, and its camera found from lines that are drawn on it.

use std::time::Duration;

use camera_lab::camera::{Camera, Viewport, WorldAxis};
use camera_lab::figure::write::to_toml;
use camera_lab::figure::{Figure, Photograph, read};
use camera_lab::gui::{Start, State};
use camera_lab::views::{Size, View, image_frame};
use camera_lab_desk::layout::Tab;
use camera_lab_words::Lang;
use camera_lab_words::why::photograph as steps;
use camera_lab_words::window::{coach, photograph as words};
use eframe::egui::{Key, Pos2, pos2};
use egui_kittest::kittest::Queryable as _;
use glam::{DVec2, DVec3};

use super::window::Window;

/// The photograph of the lesson with a camera that isn't its own.
const WRONG: &str = "[camera]\nposition = [5, 3, 8]\nview_angle = 30\n[image]\nwidth = 640\nheight = 480\n\
                     photograph = \"camera-lab:house.png\"\n[scene]\npreset = \"empty\"\n[style]\nantialias = 1\n";
/// Its own.
const RIGHT: &str = "[camera]\nposition = [7, 1.7, 5]\nfocal_point = [2, 1, -0.2]\nview_up = [-0.105, 0.994, -0.033]\n\
                     view_angle = 45\nnear = 2\nfar = 20\n[image]\nwidth = 640\nheight = 480\n";

fn window(lang: Lang, text: &str) -> Window {
    let figure = read::parse(text).expect("a figure");
    let mut state = State::new(Start { figure, file: None, lang, allow_files: false, lesson: None, later: None })
        .expect("a possible camera");
    state.model.layout.maximized = Some(View::Image);
    state.model.settings.tab = Tab::Camera;
    Window::with_state(state, [1280.0, 1500.0])
}

fn figure(window: &Window) -> &Figure {
    window.state().model.desk.shown.figure()
}

/// The place of a point of the world in the window, if the right camera took the image.
fn on_screen(window: &Window, p: [f64; 3]) -> Pos2 {
    let right = read::parse(RIGHT).expect("a figure");
    let camera = Camera::new(&right.camera).expect("a camera");
    let at = camera.stations(DVec3::from_array(p), right.image, &Viewport::whole(right.image));
    let (at, window_of_camera) = (at.projected.expect("in front").window, camera.window());
    let share = DVec2::new(
        (at.x - window_of_camera.left) / window_of_camera.width(),
        (window_of_camera.top - at.y) / window_of_camera.height(),
    );
    let app = window.harness.state().as_ref().expect("a window");
    let (_, rect) = app.canvas.places().find(|(view, _)| *view == View::Image).expect("the image");
    let size = Size { width: rect.width() as u32, height: rect.height() as u32, scale: 1.0 };
    let frame = image_frame(size, 640.0 / 480.0);
    let corner = rect.min + eframe::egui::vec2(frame.x as f32, frame.y as f32);
    pos2(corner.x + share.x as f32 * frame.width as f32, corner.y + share.y as f32 * frame.height as f32)
}

/// Draws a line between two points of the world.
fn draw(window: &mut Window, from: [f64; 3], to: [f64; 3]) {
    let [from, to] = [from, to].map(|p| on_screen(window, p));
    window.drag(from, to - from, |_| {});
}

#[test]
fn lines_drawn_on_a_photograph_give_its_camera_which_can_be_taken_and_undone() {
    for lang in [Lang::En, Lang::PtBr] {
        let t = words::texts(lang);
        let mut window = window(lang, WRONG);
        let before = figure(&window).clone();
        window.click(t.find);
        assert!(window.says(t.how));
        assert!(window.says(&steps::error(lang, &camera_lab::camera::PhotographError::TooFewLines)));
        draw(&mut window, [0.0, 0.0, 0.0], [4.0, 0.0, 0.0]);
        draw(&mut window, [0.0, 2.0, 0.0], [4.0, 2.0, 0.0]);
        window.click(&format!("{} z", t.line));
        draw(&mut window, [4.0, 0.0, -3.0], [4.0, 0.0, 0.0]);
        draw(&mut window, [4.0, 2.0, -3.0], [4.0, 2.0, 0.0]);
        assert_eq!(window.state().model.photograph.marks.lines.len(), 4);
        assert_eq!(figure(&window), &before, "a drag doesn't move the camera");
        window.click(t.origin);
        window.click_at(on_screen(&window, [0.0, 0.0, 0.0]) + eframe::egui::vec2(-12.0, 0.0));
        window.app_mut().state.model.photograph.marks.origin = Some(DVec2::new(210.3, 293.4));
        window.click(t.known);
        window.app_mut().state.model.photograph.length = (WorldAxis::X, 4.0);
        window.app_mut().state.model.photograph.marks.length = Some((WorldAxis::X, DVec2::new(443.5, 360.5), 4.0));
        window.run();
        let given = *window.state().model.desk.shown.camera().parameters();
        let found = window.state().model.photograph.camera(figure(&window).image, &given).expect("a camera");
        for step in steps::steps(lang, &found) {
            assert!(window.says(&step), "{step}");
        }
        window.click(t.take);
        let camera = figure(&window).camera;
        let cost = found.view_angle_per_pixel.expect("θ is known");
        assert!((camera.view_angle - 45.0).abs() < 3.0 * cost, "{} ± {cost}", camera.view_angle);
        assert!((found.roll() - 3.03).abs() < 1.0, "{}", found.roll());
        assert!(camera.position.distance(DVec3::new(7.0, 1.7, 5.0)) < 0.6, "{}", camera.position);
        window.command_key(Key::Z);
        assert_eq!(figure(&window), &before);
        window.key(Key::Escape);
        assert!(!window.state().model.photograph.on && !window.says(t.how));
    }
}

#[test]
fn each_mark_is_a_step_of_undo() {
    let t = words::texts(Lang::En);
    let mut window = window(Lang::En, WRONG);
    window.click(t.find);
    let lines = |window: &Window| window.state().model.photograph.marks.lines.len();
    for (count, y) in [(1, 0.0), (2, 2.0)] {
        draw(&mut window, [0.0, y, 0.0], [4.0, y, 0.0]);
        assert_eq!(lines(&window), count);
    }
    window.click(t.clear);
    for (key, count) in [(Key::Z, 2), (Key::Z, 1), (Key::Z, 0), (Key::Y, 1), (Key::Y, 2), (Key::Y, 0)] {
        window.command_key(key);
        assert_eq!(lines(&window), count, "{key:?}");
    }
}

#[test]
fn lines_nearly_parallel_in_the_image_leave_theta_open_and_the_card_says_so() {
    let t = words::texts(Lang::En);
    let mut window = window(Lang::En, WRONG);
    window.click(t.find);
    let line = |axis, a: [f64; 2], b: [f64; 2]| camera_lab::camera::PhotographLine {
        axis,
        ends: [a, b].map(DVec2::from_array),
    };
    window.app_mut().state.model.photograph.marks.lines = vec![
        line(WorldAxis::X, [100.0, 100.0], [500.0, 100.0]),
        line(WorldAxis::X, [100.0, 400.0], [500.0, 400.0]),
        line(WorldAxis::Y, [150.0, 400.0], [150.0, 100.0]),
        line(WorldAxis::Y, [450.0, 400.0], [450.0, 100.0]),
    ];
    window.run();
    assert!(window.says(steps::untold(Lang::En, camera_lab::camera::Untold::ViewAngle)));
    // The keys move an end by a pixel, and remove its line.
    window.harness.get_by_label(&words::end(Lang::En, (1, WorldAxis::X), true)).focus();
    window.run();
    window.key(Key::ArrowRight);
    assert_eq!(window.state().model.photograph.marks.lines[0].ends[0].x, 101.0);
    window.key(Key::Delete);
    assert_eq!(window.state().model.photograph.marks.lines.len(), 3);
    window.click(t.clear);
    assert!(window.state().model.photograph.marks.lines.is_empty());
}

#[test]
fn the_photograph_is_removed_and_its_opacity_set_undone_and_written() {
    let t = words::texts(Lang::En);
    let mut window = window(Lang::En, WRONG);
    let first = figure(&window).photograph.clone();
    window.enter(t.opacity, "0.25");
    let opacity = |window: &Window| figure(window).photograph.as_ref().map(|photograph| photograph.opacity);
    assert_eq!(opacity(&window), Some(0.25));
    let written = read::parse(&to_toml(figure(&window))).expect("a figure");
    assert_eq!(written.photograph, figure(&window).photograph);
    window.click(t.remove);
    assert_eq!(figure(&window).photograph, None);
    assert!(!to_toml(figure(&window)).contains("photograph"));
    window.command_key(Key::Z);
    assert_eq!(opacity(&window), Some(0.25));
    window.command_key(Key::Z);
    assert_eq!(figure(&window).photograph, first);
    assert_eq!(first.map(|photograph| photograph.opacity), Some(Photograph::USUAL_OPACITY));
}

#[test]
fn an_image_of_another_aspect_takes_the_size_of_the_photograph() {
    let t = words::texts(Lang::PtBr);
    let mut window = window(Lang::PtBr, &WRONG.replace("width = 640", "width = 900"));
    window.wait_for(&words::size(Lang::PtBr, [640, 480]));
    window.click(t.size);
    assert_eq!([figure(&window).image.width, figure(&window).image.height], [640, 480]);
    assert!(!window.says(&words::size(Lang::PtBr, [640, 480])));
}

#[test]
fn a_photograph_without_a_scene_is_no_empty_image() {
    let empty = coach::texts(Lang::En).image_empty;
    let mut window = window(Lang::En, WRONG);
    let is_empty = |window: &mut Window| {
        window.app_mut().state.model.coach.take(Duration::from_secs(60));
        window.run();
        window.says(empty)
    };
    window.run();
    assert!(!is_empty(&mut window));
    window.click(words::texts(Lang::En).remove);
    assert!(is_empty(&mut window), "without it, nothing is there");
}

#[test]
fn the_length_snaps_to_its_axis_and_a_drag_at_the_origin_leaves_it_there() {
    let t = words::texts(Lang::En);
    let mut window = window(Lang::En, WRONG);
    window.click(t.find);
    draw(&mut window, [0.0, 0.0, 0.0], [4.0, 0.0, 0.0]);
    draw(&mut window, [0.0, 2.0, 0.0], [4.0, 2.0, 0.0]);
    window.click(&format!("{} z", t.line));
    draw(&mut window, [4.0, 0.0, -3.0], [4.0, 0.0, 0.0]);
    draw(&mut window, [4.0, 2.0, -3.0], [4.0, 2.0, 0.0]);
    // A place without the end of a line.
    let origin = on_screen(&window, [2.0, 0.0, 0.0]);
    window.click(t.origin);
    window.click_at(origin);
    let marked = window.state().model.photograph.marks.origin.expect("an origin");
    window.click(t.known);
    let beside = eframe::egui::vec2(0.0, 5.0);
    window.drag(origin, on_screen(&window, [3.0, 0.0, 0.0]) + beside - origin, |_| {});
    let tool = &window.state().model.photograph;
    assert_eq!(tool.marks.origin, Some(marked), "it stays");
    let (axis, at, _) = tool.marks.length.expect("a length");
    assert_eq!(axis, WorldAxis::X);
    let given = *window.state().model.desk.shown.camera().parameters();
    let found = tool.camera(figure(&window).image, &given).expect("a camera");
    let way = found.way(WorldAxis::X, marked, figure(&window).image);
    assert!(way.perp_dot(at - marked).abs() < 1e-6 && way.dot(at - marked) > 20.0, "{at} {marked} {way}");
    // Far from the axis it isn't one of its points.
    let far = on_screen(&window, [3.0, 1.5, 0.0]);
    window.click_at(far);
    let tool = &window.state().model.photograph;
    let refused = tool.camera(figure(&window).image, &given).expect_err("a refusal");
    assert!(matches!(refused, camera_lab::camera::PhotographError::BesideAxis(WorldAxis::X, pixels) if pixels > 20.0));
    assert!(window.says(&steps::error(Lang::En, &refused)));
    // A line that begins at the origin leaves it there, too.
    window.click(&format!("{} y", t.line));
    draw(&mut window, [2.0, 0.0, 0.0], [2.0, 2.0, 0.0]);
    let tool = &window.state().model.photograph;
    assert_eq!((tool.marks.origin, tool.marks.lines.len()), (Some(marked), 5));
}

/// A row gives its control the width of another text when the text changes.
#[test]
fn a_button_is_as_wide_as_its_text_after_a_change_of_language() {
    let mut window = window(Lang::En, "[image]\nwidth = 640\nheight = 480\n");
    let width = |window: &Window, lang| window.harness.get_by_label(words::texts(lang).choose_title).rect().width();
    let first = width(&window, Lang::En);
    for lang in [Lang::PtBr, Lang::En] {
        window.app_mut().state.model.settings.lang = lang;
        window.run();
    }
    assert!((width(&window, Lang::En) - first).abs() < 0.5);
}

/// Nobody can draw along an edge that's behind a cylinder.
#[test]
fn lines_are_drawn_on_the_photograph_alone() {
    let text = "[image]\nwidth = 640\nheight = 480\nphotograph = \"camera-lab:house.png\"\nphotograph_opacity = 1\n";
    let mut window = window(Lang::En, text);
    let t = words::texts(Lang::En);
    let picture = |window: &mut Window| {
        window.run();
        let (_, rect) = window.app_mut().canvas.places().find(|(view, _)| *view == View::Image).expect("the image");
        window.pixels([rect.width(), rect.height()].map(|side| side as usize))
    };
    let with_scene = picture(&mut window);
    window.click(t.find);
    let alone = picture(&mut window);
    assert_ne!(alone, with_scene);
    window.click(t.with_scene);
    assert_eq!(picture(&mut window), with_scene);
    // The tool opens without it again.
    for _ in 0..2 {
        window.click(t.find);
    }
    assert_eq!(picture(&mut window), alone);
}
