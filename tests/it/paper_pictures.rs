//! Pictures for paper: the parts of the world that may be left out, strokes of small scenes, the border of the image.
#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use camera_lab::drawing::{Drawing, StrokeSet};
use camera_lab::figure::{Figure, WorldPart, WorldParts, read::parse};
use camera_lab::scene::Preset;
use camera_lab::views::handles::handles;
use camera_lab::views::observer::Viewpoint;
use camera_lab::views::{Finish, Request, Size, View};

use crate::views::{Pictured, draw, figure};

fn house() -> Figure {
    let mut figure = figure(|c| (c.near, c.far) = (2.0, 12.0));
    figure.scene.preset = Preset::House;
    figure
}

fn texts(drawing: &Drawing) -> Vec<&str> {
    drawing.labels.iter().map(|label| label.text.as_str()).collect()
}

fn strokes(drawing: &Drawing) -> usize {
    drawing.strokes.iter().map(|set| set.polylines.len()).sum()
}

#[test]
fn each_part_of_the_world_can_be_left_out() {
    let world = |parts: WorldParts| {
        let mut figure = house();
        figure.world.parts = parts;
        Pictured::of(figure).sized(640, 480).world(Viewpoint::Iso)
    };
    let whole = world(WorldParts::default());
    for (part, key) in WorldPart::ALL {
        let read = parse(&format!("[world]\n{key} = false\n")).unwrap().world.parts;
        let mut without = WorldParts::default();
        without.set(part, false);
        assert_eq!(read, without, "{key}");
        let drawn = world(without);
        let names: &[&str] = match part {
            WorldPart::Grid | WorldPart::CameraBody | WorldPart::GroundMarks => &[],
            WorldPart::Axes => &["x", "y", "z"],
            WorldPart::Vrc => &["u", "v", "n"],
            WorldPart::ViewUp => &["VUP"],
            WorldPart::Dop => &["DOP"],
            WorldPart::FocalPoint => &["PF"],
            WorldPart::Volume => &["far (B)"],
            WorldPart::Window => &["window (F)"],
            WorldPart::Names => {
                assert!(drawn.labels.is_empty(), "{:?}", texts(&drawn));
                continue;
            }
        };
        assert!(strokes(&drawn) < strokes(&whole), "{key}");
        for name in ["C", "PF", "u", "v", "n", "VUP", "DOP", "x", "y", "z", "window (F)", "far (B)"] {
            assert_eq!(texts(&drawn).contains(&name), !names.contains(&name), "{key}: {name}");
        }
    }
}

#[test]
fn hidden_parts_have_no_handle() {
    let count = |parts: WorldParts| {
        let mut figure = house();
        figure.world.parts = parts;
        let pictured = Pictured::of(figure).sized(640, 480);
        handles(&pictured.seen_by(View::World, pictured.observer(View::World, Viewpoint::Iso))).len()
    };
    assert_eq!(count(WorldParts::default()), 5);
    let mut parts = WorldParts::default();
    for (part, left) in [(WorldPart::FocalPoint, 4), (WorldPart::ViewUp, 3), (WorldPart::Volume, 1)] {
        parts.set(part, false);
        assert_eq!(count(parts), left, "{part:?}");
    }
}

/// The strokes of a scene in its own colour: the edges of the house are the only ones of their width.
fn widths(request: &Request) -> Vec<f32> {
    let drawing = draw(request);
    let mut widths: Vec<f32> = drawing.strokes.iter().map(|set: &StrokeSet| set.style.width).collect();
    widths.sort_by(f32::total_cmp);
    widths
}

#[test]
fn edges_of_a_small_scene_are_finer_and_letters_as_large_as_ever() {
    let pictured = Pictured::of(house());
    let near = pictured.observer(View::World, Viewpoint::Iso);
    let of = |distance: f64, finish: Finish| {
        let size = Size { width: 640, height: 480, scale: 1.0 };
        let observer = camera_lab::figure::Observer { distance, ..near };
        Request { size, finish, ..pictured.seen_by(View::World, observer) }
    };
    let (large, small) = (of(near.distance, Finish::default()), of(8.0 * near.distance, Finish::default()));
    let letters = |request: &Request| draw(request).labels.iter().find(|label| label.text == "C").unwrap().size;
    assert_eq!(letters(&large), letters(&small));
    assert!(widths(&small)[0] < 0.6 * widths(&large)[0], "{:?} {:?}", widths(&small), widths(&large));
    // A width that is asked for is the width.
    let asked = Finish { stroke_factor: Some(1.0), ..Finish::default() };
    assert_eq!(widths(&of(8.0 * near.distance, asked))[0], widths(&large)[0]);
}

#[test]
fn a_framed_image_has_four_sides_and_whole_marks() {
    let mut figure = house();
    figure.reveal.clipping = true;
    figure.camera.view_angle = 12.0;
    let image = Pictured::of(figure).sized(400, 300).request().clone();
    let framed = Request { finish: Finish { framed: true, ..image.finish }, ..image.clone() };
    let inside = |drawing: &Drawing| {
        let fits = |at: f32, radius: f32, side: u32| at - radius >= 0.0 && at + radius <= side as f32;
        let whole =
            |m: &&camera_lab::drawing::Mark| fits(m.position[0], m.radius, 400) && fits(m.position[1], m.radius, 300);
        (drawing.marks.iter().filter(whole).count(), drawing.marks.len())
    };
    let (whole, all) = inside(&draw(&image));
    assert!(whole < all, "marks at the sides are cut: {whole} of {all}");
    let drawing = draw(&framed);
    let (whole, all) = inside(&drawing);
    assert!(all > 4 && whole == all, "{whole} of {all}");
    let border = drawing.strokes.last().unwrap();
    assert!(border.points.iter().all(|[x, y, _]| (1.0..399.0).contains(x) && (1.0..299.0).contains(y)));
    assert_eq!(border.points.len(), 5);
}

#[test]
fn a_frame_that_letters_leave_no_room_for_is_left_out() {
    let image = Pictured::of(house()).sized(64, 48).request().clone();
    for scale in [1e-30, 1e9, 1e30, f32::MAX] {
        let size = Size { scale, ..image.size };
        let bare = Request { size, finish: Finish { framed: false, ..image.finish }, ..image.clone() };
        let framed = Request { finish: Finish { framed: true, ..image.finish }, ..bare.clone() };
        let [bare, framed] = [&bare, &framed].map(|request| draw(request).strokes.len());
        assert_eq!(framed, if scale < 1.0 { bare + 1 } else { bare });
    }
}
