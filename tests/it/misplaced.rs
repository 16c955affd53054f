//! A picture marks the vertices that rounding puts beside their places.

#![expect(clippy::unwrap_used, reason = "tests")]

use std::path::Path;

use camera_lab::camera::Camera;
use camera_lab::figure::read::parse;
use camera_lab::pipeline::{Frame, OverBudget};
use camera_lab::progress::Progress;
use camera_lab::views::{Request, SharedScene, Size, TimedPipeline, View, frame, scene_of};
use camera_lab_files::{FigureFiles, FileAccess, SHIPPED_FIGURES};
use camera_lab_words::{Lang, messages, pictures};

use crate::common::program::{Bench, Run};

/// Looks along −z at a box of which one edge is in the window, which is `width` wide. C is at x = 0.1, and the edge at
/// 1.1 − 1.
fn figure(width: f64) -> String {
    let half = width / 2.0;
    format!(
        "[camera]\nposition = [0.1, 0.0, 5.0]\nfocal_point = [0.1, 0.0, 0.0]\nprojection = \"parallel\"\nnear = 1.0\nfar = 20.0\n\
         window = {{ left = -{half}, right = {half}, bottom = -{half}, top = {half} }}\n\
         [image]\nwidth = 500\nheight = 500\n\
         [[scene.objects]]\nname = \"box\"\nshape = \"box\"\ntranslate = [1.1, 1.0, 0.0]\n"
    )
}

fn drawn(text: &str, view: View) -> Frame {
    let figure = parse(text).unwrap();
    let camera = Camera::new(&figure.camera).unwrap();
    let mut files = FigureFiles::new(Path::new("."), FileAccess::Figure);
    let scene = scene_of(&figure, &mut |wanted| files.read(wanted), &Progress::default()).unwrap();
    let scene = SharedScene::new(scene);
    let size = Size { width: 500, height: 500, scale: 1.0 };
    frame(
        &Request::of(&figure, view, &camera, &scene, pictures::labels(Lang::En), size),
        None,
        &mut TimedPipeline::default(),
    )
}

/// A number in units of 2⁻⁶⁰.
#[expect(clippy::cast_possible_truncation, reason = "asserted")]
fn whole(x: f64) -> i64 {
    let units = x * 2_f64.powi(60);
    assert!(units == units.trunc() && units.abs() < 2_f64.powi(62));
    units as i64
}

#[test]
fn a_vertex_that_is_drawn_beside_its_place_is_named() {
    let frame = drawn(&figure(1e-14), View::Image);
    // The place by whole numbers, and the place in the drawing: of the one corner that is not cut.
    let aside = whole(1.1) - whole(1.0) - whole(0.1);
    let exact = 250.0 + 250.0 * (aside as f64 / 2_f64.powi(60)) / 5e-15;
    let OverBudget::Rounding { vertices } = frame.over_budget.unwrap() else { panic!("rounding") };
    let [vertex] = &vertices[..] else { panic!("{vertices:?}") };
    let [x, y, _] = frame.drawing.surfaces[0].positions[vertex.vertex];
    let off = (f64::from(x) - exact).hypot(f64::from(y) - 250.0);
    assert!(off > 4.0 && (vertex.off - off).abs() < 1e-6, "{vertex:?} {off}");
    assert_eq!(vertex.object, "box");

    let said = OverBudget::Rounding { vertices };
    for (lang, words) in [(Lang::En, "is drawn 4.2 px off"), (Lang::PtBr, "é desenhado com desvio de 4,2 px")] {
        let text = messages::over_budget(lang, &said);
        assert!(text.contains(words) && text.contains("\"box\""), "{text}");
    }
}

#[test]
fn a_window_so_wide_that_nothing_is_lost_says_nothing() {
    // An error of 4.2 pixels in a window of 1e-14 is a fifth of a pixel in this one: examined, and allowed.
    assert!(drawn(&figure(2e-13), View::Image).over_budget.is_none());
    assert!(drawn(&figure(1e-11), View::Image).over_budget.is_none());
    // The other pictures are seen by other cameras.
    assert!(drawn(&figure(1e-14), View::World).over_budget.is_none());
}

#[test]
fn the_figures_that_come_with_the_program_lose_nothing() {
    for figure in SHIPPED_FIGURES {
        for view in View::ALL {
            assert_eq!(drawn(&figure.text(), view).over_budget, None, "{} {view:?}", figure.name);
        }
    }
}

#[test]
fn render_says_it_and_writes_the_picture() {
    let bench = Bench::new("misplaced");
    bench.write("narrow.toml", figure(1e-14));
    let run = Run::of(&mut bench.command(&["render", "narrow.toml", "--size", "100x100", "-o", "narrow.png"]));
    assert_eq!(run.status, Some(0));
    assert!(
        run.err.contains("narrow.toml: vertex") && run.err.contains("of \"box\" is drawn 0.8 px off"),
        "{}",
        run.err
    );
    assert!(!bench.read("narrow.png").is_empty());
}
