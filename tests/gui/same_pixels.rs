//! The picture on the screen, the one that is exported and the one that `render` writes are the same, byte for byte.

use std::fs;
use std::time::{Duration, Instant};

use camera_lab::camera::{Convention, Operation};
use camera_lab::figure::{Measure, Measured, ShownProbe, ShownStep, ShownTriangle, TriangleStep};
use camera_lab::files::open_figure;
use camera_lab::geometry::Angle;
use camera_lab::gui::export::Export;
use camera_lab::gui::file_flow::text_as_shown;
use camera_lab::gui::state::{Dialog, Panels};
use camera_lab::gui::{Start, State};
use camera_lab::i18n::Lang;
use camera_lab::views::{View, Views};

use super::files::Folder;
use super::window::Window;

const FIGURE: &str = "[camera]\nposition = [2.5, 3, 5]\nnear = 2\nfar = 12\n[scene]\npreset = \"house\"\n\
                      [style]\ntheme = \"light\"\nantialias = 4\n";

/// From where the pictures are seen, in a figure that says it.
const OBSERVERS: &str = "[observers.world]\ntarget = [1, 1, 1]\ndistance = 20\nazimuth = 70\nelevation = 25\n\
                         [observers.canonical]\ntarget = [0, 0, 0]\ndistance = 7\nazimuth = 20\nelevation = 35\n";

/// The pixels of a PNG that has no alpha channel, as RGBA.
fn pixels(png: &[u8]) -> ([usize; 2], Vec<u8>) {
    let image = image::load_from_memory(png).expect("a PNG").to_rgba8();
    ([image.width() as usize, image.height() as usize], image.into_raw())
}

/// What is done in the window before its picture is taken.
type Act = fn(&mut Window);

fn assert_same_everywhere(view: View, scale: f32, figure: &str, act: Option<Act>) {
    let folder = Folder::new(&format!("same-{}-{scale}-{}-{}", view.name(), figure.len(), act.is_some()));
    let path = folder.file("figure.toml");
    fs::write(&path, figure).expect("written");
    let opened = open_figure(&path).expect("a figure");
    let (figure, file) = opened.at(&path);
    let mut state =
        State::new(Start { figure, file: Some(file), lang: Lang::En, allow_files: false }).expect("a possible camera");
    state.file_flow.native = false;
    state.layout.maximized = Some(view);
    state.settings.panels = Panels::default();
    let mut window = Window::at_scale(state, [480.0, 400.0], scale);
    if let Some(act) = act {
        act(&mut window);
        window.harness.remove_cursor();
        window.run();
        // What the window shows now is in no file but the picture that it exports, and in its link.
        fs::write(&path, text_as_shown(window.state())).expect("written");
    }
    let [width, height] = window.state().picture_sizes[view.index()];
    let on_screen = window.textures.only([width as usize, height as usize]);

    let exported = folder.file("exported.png");
    let (sizes, unit) = (window.state().picture_sizes, window.state().screen_scale);
    let mut export = Export::new(sizes, unit);
    (export.what, export.times, export.theme) = (Views::One(view), Some(1), window.state().settings.theme);
    export.fit_screen(sizes, unit);
    window.app_mut().state.file_flow.dialog = Some(Dialog::Export(export));
    window.run();
    window.click("Export…");
    window.choose(&exported);
    let since = Instant::now();
    while !exported.exists() {
        assert!(since.elapsed() < Duration::from_secs(60), "{:?}", window.state().message);
        std::thread::sleep(Duration::from_millis(20));
        window.run();
    }

    let rendered = folder.file("rendered.png");
    assert_eq!((width % scale as u32, height % scale as u32), (0, 0), "a size that the command line can be asked for");
    let size = format!("{}x{}", width / scale as u32, height / scale as u32);
    let [path, out, scale] = [path.display().to_string(), rendered.display().to_string(), scale.to_string()];
    let arguments =
        ["camera-lab", "render", &path, "--view", view.name(), "--size", &size, "--scale", &scale, "-o", &out];
    let _ = camera_lab::cli::run(arguments.into_iter().map(Into::into));

    let what = format!("{} at scale {scale}", view.name());
    let (exported, rendered) = (fs::read(exported).expect("exported"), fs::read(rendered).expect("rendered"));
    if act.is_none() {
        assert!(exported == rendered, "{what}: the exported file is not the rendered one");
    }
    assert!(pixels(&exported) == pixels(&rendered), "{what}: the exported picture is not the rendered one");
    let (size, pixels) = pixels(&rendered);
    assert_eq!(size, [width as usize, height as usize], "{what}");
    let differ = pixels.chunks(4).zip(on_screen.chunks(4)).filter(|(a, b)| a != b).count();
    assert_eq!(differ, 0, "{what}: pixels on the screen are not the rendered ones");
}

/// At scale 1 the figure as it is; at scale 2, with `more` in it: each is a window, and windows take their time.
fn assert_same_at_both_scales(view: View, more: &str) {
    assert_same_everywhere(view, 1.0, FIGURE, None);
    assert_same_everywhere(view, 2.0, &format!("{FIGURE}{more}"), None);
}

#[test]
fn the_screen_the_export_and_render_agree_on_the_world() {
    assert_same_at_both_scales(View::World, OBSERVERS);
}

#[test]
fn the_screen_the_export_and_render_agree_on_the_canonical_volume() {
    assert_same_at_both_scales(View::Canonical, OBSERVERS);
}

#[test]
fn the_screen_the_export_and_render_agree_on_the_image() {
    assert_same_at_both_scales(View::Image, "[reveal]\ndepth = \"linear\"\nclipping = true\n");
}

/// Turns the camera in a hundred steps, which leave their rests in it: the observers stay where they were as long as
/// all is in sight.
fn turn(window: &mut Window) {
    for k in 0..100 {
        let turn = Angle::from_degrees(if k < 50 { 1.3 } else { -0.7 });
        let operation = if k % 2 == 0 { Operation::Azimuth(turn) } else { Operation::Elevation(turn) };
        window.app_mut().state.document.operate(operation, Convention::default()).expect("a camera");
    }
    window.run();
}

#[test]
fn after_a_hundred_operations_they_agree_too_from_where_the_window_shows_it() {
    for view in View::ALL {
        assert_same_everywhere(view, 1.0, FIGURE, Some(turn));
    }
}

#[test]
fn they_agree_on_every_kind_of_explanation() {
    let stage: Act = |window| {
        window.app_mut().state.document.show_mut().stage = Some(camera_lab::stage::Stage::Clip);
        window.run();
    };
    let step: Act = |window| {
        let way = camera_lab::camera::Decomposition::Notes;
        window.app_mut().state.document.show_mut().step = Some(ShownStep { way, at: Some(1.6) });
        window.run();
    };
    let triangle: Act = |window| {
        let object = "walls".to_owned();
        let triangle = ShownTriangle { object, index: 2, step: TriangleStep::Pixels, pixel: None };
        window.app_mut().state.document.show_mut().triangle = Some(triangle);
        window.run();
    };
    let probe: Act = |window| {
        let show = window.app_mut().state.document.show_mut();
        (show.probe, show.painted) = (Some(ShownProbe::Pixel([500, 300])), Some(0.5));
        window.run();
    };
    let convention: Act = |window| {
        window.app_mut().state.settings.conventions.ndc =
            camera_lab::camera::Ndc::ALL.into_iter().find(|ndc| ndc.name() == "direct3d").expect("a convention");
        window.run();
    };
    let measures: Act = |window| {
        window.app_mut().state.document.show_mut().measure =
            vec![Measured::Dimension(Measure::Near), Measured::Dimension(Measure::HalfAngle)];
        window.run();
    };
    let stage_over_depths: Act = |window| {
        let document = &mut window.app_mut().state.document;
        document.edit(|figure| figure.reveal.depth = camera_lab::figure::Depth::Linear);
        document.show_mut().stage = Some(camera_lab::stage::Stage::Antialias);
        window.run();
    };
    for (view, act) in [
        (View::Canonical, convention),
        (View::World, measures),
        (View::Image, stage_over_depths),
        (View::Image, stage),
        (View::World, stage),
        (View::Canonical, step),
        (View::Image, triangle),
        (View::World, triangle),
        (View::Image, probe),
        (View::World, probe),
    ] {
        assert_same_everywhere(view, 1.0, FIGURE, Some(act));
    }
}
