//! The rules of depth and order of a drawing, frozen in small pictures.

use camera_lab_engine::appearance::{Dash, HiddenLines, LineStyle, Rgba, Samples};
use camera_lab_engine::drawing::{Anchor, Area, Drawing, Label, StrokeSet, Surface};
use camera_lab_engine::raster::Rasterizer;

use crate::common::picture::assert_picture;

const BLUE: Rgba = Rgba::rgb(0x44, 0x77, 0xaa);
const YELLOW: Rgba = Rgba::rgb(0xdd, 0xaa, 0x33);
const INK: Rgba = Rgba::rgb(0x22, 0x22, 0x22);
const WHITE: Rgba = Rgba::rgb(255, 255, 255);

fn drawing(width: u32, height: u32) -> Drawing {
    Drawing { antialias: Samples::Four, ..Drawing::new(width, height, WHITE) }
}

fn surface(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>, color: Rgba) -> Surface {
    Surface::solid(positions, triangles, color)
}

fn stroke(points: Vec<[f32; 3]>, hidden: HiddenLines, arrow: bool) -> StrokeSet {
    StrokeSet::line(points, LineStyle { color: INK, width: 2.0, dash: Dash::Solid, hidden, arrow })
}

fn label(position: [f32; 3], text: &str, fade_if_hidden: bool) -> Label {
    Label {
        name: text.to_owned(),
        anchor: Anchor::Center,
        fade_if_hidden,
        ..Label::new(position, text, 18.0, [INK, Rgba::rgba(255, 255, 255, 200)])
    }
}

/// Two triangles that pass through each other, and a translucent one before and behind them.
#[test]
fn crossing_triangles() {
    let mut d = drawing(120, 90);
    d.surfaces.push(surface(vec![[10.0, 10.0, 0.2], [110.0, 45.0, 0.8], [10.0, 80.0, 0.2]], vec![[0, 1, 2]], BLUE));
    d.surfaces.push(surface(vec![[110.0, 10.0, 0.2], [10.0, 45.0, 0.8], [110.0, 80.0, 0.2]], vec![[0, 1, 2]], YELLOW));
    let red = Rgba::rgba(0xcc, 0x33, 0x11, 0x80);
    d.surfaces.push(surface(vec![[30.0, 85.0, 0.45], [60.0, 2.0, 0.45], [90.0, 85.0, 0.45]], vec![[0, 1, 2]], red));
    assert_picture("crossing_triangles", &Rasterizer::default().paint(&d).expect("a picture"));
}

/// A line that enters a face, continues behind it and comes out again, in each of the three styles. The edge of the
/// face counts as visible.
#[test]
fn line_through_a_face() {
    let mut d = drawing(160, 120);
    let corners = vec![[40.0, 10.0, 0.5], [120.0, 10.0, 0.5], [120.0, 110.0, 0.5], [40.0, 110.0, 0.5]];
    d.surfaces.push(surface(corners.clone(), vec![[0, 1, 2], [0, 2, 3]], Rgba::rgb(0xbb, 0xcc, 0xee)));
    for (y, hidden) in [(30.0, HiddenLines::Dashed), (60.0, HiddenLines::Hidden), (90.0, HiddenLines::Shown)] {
        d.strokes.push(stroke(vec![[10.0, y, 0.7], [150.0, y + 8.0, 0.3]], hidden, true));
    }
    let mut edge = corners;
    edge.push(edge[0]);
    d.strokes.push(stroke(edge, HiddenLines::Hidden, false));
    assert_picture("line_through_a_face", &Rasterizer::default().paint(&d).expect("a picture"));
}

/// Texts before a face, behind it, and behind it but not to be faded.
#[test]
fn label_behind_a_face() {
    let mut d = drawing(160, 120);
    let corners = vec![[20.0, 10.0, 0.5], [140.0, 10.0, 0.5], [140.0, 110.0, 0.5], [20.0, 110.0, 0.5]];
    d.surfaces.push(surface(corners, vec![[0, 1, 2], [0, 2, 3]], BLUE));
    d.labels.push(label([80.0, 30.0, 0.6], "M_{prp}·p_c", true));
    d.labels.push(label([80.0, 60.0, 0.4], "visão θ", true));
    d.labels.push(label([80.0, 90.0, 0.4], "ção ½", false));
    assert_picture("label_behind_a_face", &Rasterizer::default().paint(&d).expect("a picture"));
}

#[test]
fn an_area_covers_its_rectangle_but_for_round_corners_and_hides_strokes() {
    let fill = Rgba::rgb(0, 0, 255);
    let area = |corner, size, radius| Area { corner, size, radius, fill };
    let paint = |strokes: &[StrokeSet], areas: Vec<Area>| {
        let drawing = Drawing { strokes: strokes.to_vec(), areas, ..drawing(64, 40) };
        Rasterizer::default().paint(&drawing).expect("a picture")
    };
    let strokes = [stroke(vec![[0.0, 20.0, 1.0], [64.0, 20.0, 1.0]], HiddenLines::Shown, false)];
    let (plain, square) = (paint(&strokes, Vec::new()), paint(&strokes, vec![area([10.0, 10.0], [30.0, 20.0], 0.0)]));
    for (x, y) in (0..64).flat_map(|x| (0..40).map(move |y| (x, y))) {
        let pixel = square.pixel(x, y).expect("inside");
        if (10..40).contains(&x) && (10..30).contains(&y) {
            assert_eq!((pixel.red(), pixel.green(), pixel.blue()), (0, 0, 255), "({x}, {y})");
        } else {
            assert_eq!(Some(pixel), plain.pixel(x, y), "({x}, {y})");
        }
    }
    // With corners as large as they can be a square is a circle: it covers π r², as exactly as paths are filled.
    let circle = paint(&[], vec![area([10.0, 12.0], [20.0, 20.0], 99.0)]);
    let covered = circle.pixels().iter().map(|p| f64::from(255 - p.red()) / 255.0).sum::<f64>();
    assert!((covered - 100.0 * std::f64::consts::PI).abs() < 3.0, "{covered}");
    for nonsense in [f32::NAN, f32::INFINITY, -1.0] {
        let wrong = area([10.0, 10.0], [nonsense, 20.0], 3.0);
        assert_eq!(paint(&strokes, vec![wrong]).data(), plain.data(), "{nonsense}");
    }
}
