//! The picture on the screen, the one that is exported and the one that `render` writes are the same, byte for byte.

use std::fs;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use camera_lab::camera::{Convention, Operation};
use camera_lab::figure::{Measure, Measured, ShownProbe, ShownStep, ShownTriangle, TriangleStep};
use camera_lab::geometry::Angle;
use camera_lab::gui::app::file_flow::questions::Dialog;
use camera_lab::gui::app::file_flow::text_as_shown;
use camera_lab::gui::export::Export;
use camera_lab::views::{View, Views};
use camera_lab_desk::layout::Panels;
use camera_lab_files::share;
use proptest::prelude::*;

use super::files::Folder;
use super::shot::{observers, operations, shows};
use super::window::{Window, opened};
use crate::words::en;

const FIGURE: &str = "[camera]\nposition = [2.5, 3, 5]\nnear = 2\nfar = 12\n[scene]\npreset = \"house\"\n\
                      [style]\ntheme = \"light\"\nantialias = 4\n";

/// The observers of the pictures, in a figure that gives them.
const OBSERVERS: &str = "[observers.world]\ntarget = [1, 1, 1]\ndistance = 20\nazimuth = 70\nelevation = 25\n\
                         [observers.canonical]\ntarget = [0, 0, 0]\ndistance = 7\nazimuth = 20\nelevation = 35\n";

/// The pixels of a PNG that has no alpha channel, as RGBA.
fn pixels(png: &[u8]) -> ([usize; 2], Vec<u8>) {
    let image = image::load_from_memory(png).expect("a PNG").to_rgba8();
    ([image.width() as usize, image.height() as usize], image.into_raw())
}

/// Changes made in the window before its picture is taken.
type Act = fn(&mut Window);

/// A window with a figure file of its own.
struct Opened {
    window: Window,
    folder: Folder,
    path: PathBuf,
    scale: f32,
}

impl Opened {
    fn new(view: View, scale: f32, figure: &str) -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let folder = Folder::new(&format!("same-{}", COUNT.fetch_add(1, Ordering::Relaxed)));
        let path = folder.file("figure.toml");
        fs::write(&path, figure).expect("written");
        let mut state = opened(&path, view);
        state.model.settings.panels = Panels::default();
        let window = Window::at_scale(state, [480.0, 400.0], scale);
        Self { window, folder, path, scale }
    }

    fn on_screen(&self, view: View) -> ([usize; 2], Vec<u8>) {
        let size = self.window.state().model.frame.picture_sizes[view.index()].map(|side| side as usize);
        (size, self.window.pixels(size))
    }

    /// The file that the window exports.
    fn exported(&mut self, view: View) -> Vec<u8> {
        let Self { window, folder, .. } = self;
        let path = folder.file(&format!("exported-{}.png", view.name()));
        let (sizes, unit) = (window.state().model.frame.picture_sizes, window.state().model.frame.screen_scale);
        let mut export = Export::new(sizes, unit);
        (export.what, export.times, export.theme) = (Views::One(view), Some(1), window.state().model.settings.theme);
        export.fit_screen(sizes, unit);
        window.app_mut().state.file_flow.dialog = Some(Dialog::Export(export));
        window.run();
        window.click(en::WINDOW.export_action);
        window.choose(&path);
        window.wait(|_| path.exists());
        fs::read(path).expect("exported")
    }

    /// The file that `render` writes of a figure file or of a link, in the size of the screen.
    fn rendered(&self, figure: &str, view: View) -> Vec<u8> {
        let ([width, height], _) = self.on_screen(view);
        let scale = self.scale as usize;
        assert_eq!((width % scale, height % scale), (0, 0), "a size that the command line can be asked for");
        let size = format!("{}x{}", width / scale, height / scale);
        let path = self.folder.file("rendered.png");
        let [out, scale] = [path.display().to_string(), scale.to_string()];
        let arguments =
            ["camera-lab", "render", figure, "--view", view.name(), "--size", &size, "--scale", &scale, "-o", &out];
        let _ = camera_lab::cli::run(arguments.into_iter().map(Into::into));
        let rendered = fs::read(&path).expect("rendered");
        fs::remove_file(path).expect("a new one each time");
        rendered
    }

    /// The screen, the export, `render` of the window's figure, and its link, followed.
    fn assert_same(&mut self, view: View) {
        let what = format!("{} at scale {}", view.name(), self.scale);
        self.window.harness.remove_cursor();
        self.window.run();
        let (size, on_screen) = self.on_screen(view);
        let exported = pixels(&self.exported(view));
        // The figure of the window is in no file but the picture that it exports, and in its link.
        let text = text_as_shown(&self.window.state().model);
        fs::write(&self.path, &text).expect("written");
        let (rendered_size, rendered) = pixels(&self.rendered(&self.path.display().to_string(), view));
        assert_eq!(rendered_size, size, "{what}");
        let differ = rendered.chunks(4).zip(on_screen.chunks(4)).filter(|(a, b)| a != b).count();
        assert_eq!(differ, 0, "{what}: pixels on the screen are not the rendered ones of\n{text}");
        assert!(exported == (size, rendered), "{what}: the exported picture is not the rendered one of\n{text}");
        let link = share::link("https://example.org/", share::Held::Figure, &text).expect("short enough");
        assert!(pixels(&self.rendered(&link, view)) == exported, "{what}: the link leads elsewhere: {link}");
    }
}

fn assert_same_after(view: View, figure: &str, act: Act) {
    let mut opened = Opened::new(view, 1.0, figure);
    act(&mut opened.window);
    opened.assert_same(view);
}

/// An untouched figure: also the files are the same, with the figures in them.
fn assert_same_untouched(view: View, scale: f32, figure: &str) {
    let mut opened = Opened::new(view, scale, figure);
    let exported = opened.exported(view);
    let rendered = opened.rendered(&opened.path.display().to_string(), view);
    assert!(exported == rendered, "{} at scale {scale}: the exported file is not the rendered one", view.name());
    opened.window.harness.remove_cursor();
    opened.window.run();
    assert!(opened.on_screen(view) == pixels(&rendered), "{} at scale {scale}", view.name());
}

/// At scale 1 the figure as it is, at scale 2 with `more` in it. Each is a window, and windows take their time.
fn assert_same_at_both_scales(view: View, more: &str) {
    assert_same_untouched(view, 1.0, FIGURE);
    assert_same_untouched(view, 2.0, &format!("{FIGURE}{more}"));
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

#[test]
fn they_agree_on_a_comparison() {
    let by = |keys: &str| format!("[compare]\n{keys}");
    let painter = by("with = { \"style.visibility\" = \"painter\" }\nwiper = 0.4\ndifferences = true\n");
    let angle = by("with = { \"camera.view_angle\" = 80 }\n");
    let convention = by("with = { \"show.ndc\" = \"direct3d\" }\nlayout = \"beside\"\n");
    for (view, scale, compare) in [
        (View::Image, 2.0, &painter),
        (View::World, 1.0, &angle),
        (View::Canonical, 1.0, &convention),
        (View::Canonical, 2.0, &angle),
    ] {
        assert_same_untouched(view, scale, &format!("{FIGURE}{compare}"));
    }
    // Also with options that no file holds: the convention of the window, and its explanation.
    let convention: Act = |window| {
        let state = &mut window.app_mut().state;
        state.model.settings.conventions.ndc =
            camera_lab::camera::Ndc::ALL.into_iter().find(|ndc| ndc.name() == "direct3d").expect("a convention");
        state.model.desk.shown.show_mut().stage = Some(camera_lab::stage::Stage::Clip);
        window.run();
    };
    assert_same_after(View::Canonical, &format!("{FIGURE}{angle}"), convention);
    assert_same_after(View::Image, &format!("{FIGURE}{painter}"), convention);
    assert_same_after(View::World, &format!("{FIGURE}{angle}"), turn);
}

/// Turns the camera in a hundred steps, which leave their rounding in it. The observers stay as long as all is in
/// sight.
fn turn(window: &mut Window) {
    for k in 0..100 {
        let turn = Angle::from_degrees(if k < 50 { 1.3 } else { -0.7 });
        let operation = if k % 2 == 0 { Operation::Azimuth(turn) } else { Operation::Elevation(turn) };
        window.app_mut().state.model.desk.shown.operate(operation, Convention::default()).expect("a camera");
    }
    window.run();
}

#[test]
fn after_a_hundred_operations_they_agree_too_from_where_the_window_shows_it() {
    for view in View::ALL {
        assert_same_after(view, FIGURE, turn);
    }
}

#[test]
fn they_agree_on_every_kind_of_explanation() {
    let stage: Act = |window| {
        window.app_mut().state.model.desk.shown.show_mut().stage = Some(camera_lab::stage::Stage::Clip);
        window.run();
    };
    let step: Act = |window| {
        let way = camera_lab::camera::Decomposition::Notes;
        window.app_mut().state.model.desk.shown.show_mut().step = Some(ShownStep { way, at: Some(1.6) });
        window.run();
    };
    let triangle: Act = |window| {
        let object = "walls".to_owned();
        let triangle = ShownTriangle { object, index: 2, step: TriangleStep::Pixels, pixel: None };
        window.app_mut().state.model.desk.shown.show_mut().triangle = Some(triangle);
        window.run();
    };
    let probe: Act = |window| {
        let show = window.app_mut().state.model.desk.shown.show_mut();
        (show.probe, show.painted) = (Some(ShownProbe::Pixel([500, 300])), Some(0.5));
        window.run();
    };
    let convention: Act = |window| {
        window.app_mut().state.model.settings.conventions.ndc =
            camera_lab::camera::Ndc::ALL.into_iter().find(|ndc| ndc.name() == "direct3d").expect("a convention");
        window.run();
    };
    let measures: Act = |window| {
        window.app_mut().state.model.desk.shown.show_mut().measure =
            vec![Measured::Dimension(Measure::Near), Measured::Dimension(Measure::HalfAngle)];
        window.run();
    };
    let stage_over_depths: Act = |window| {
        let document = &mut window.app_mut().state.model.desk.shown;
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
        assert_same_after(view, FIGURE, act);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { max_shrink_iters: 40, ..ProptestConfig::with_cases(12) })]

    /// Any figure, any observer, any operations: the camera of the window keeps digits that its parameters cannot hold.
    #[test]
    fn they_agree_on_every_shot(show in shows(), observers in observers(), operations in operations()) {
        let mut opened = Opened::new(View::World, 1.0, &FIGURE.replace("antialias = 4", "antialias = 1"));
        let document = &mut opened.window.app_mut().state.model.desk.shown;
        (*document.observers_mut(), *document.show_mut()) = (observers, show);
        let half = operations.len() / 2;
        for operations in [&operations[..half], &operations[half..]] {
            for operation in operations {
                // One that has no result changes nothing.
                let _ = opened.window.app_mut().state.model.desk.shown.operate(*operation, Convention::default());
            }
            opened.window.run();
        }
        for view in View::ALL {
            opened.window.app_mut().state.model.layout.maximized = Some(view);
            opened.assert_same(view);
        }
    }
}
