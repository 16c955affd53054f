//! Strokes against surfaces: a stroke on a face is seen, one behind a face is not.

#![expect(clippy::cast_possible_truncation, reason = "pictures are small")]

use std::ops::Range;

use camera_lab_engine::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba, Samples};
use camera_lab_engine::drawing::{Drawing, Mark, StrokeSet, Surface};
use camera_lab_engine::raster::Rasterizer;
use tiny_skia::Pixmap;

const INK: Rgba = Rgba::rgb(20, 20, 20);
const SIDE: u32 = 150;

/// A solid: its vertices and its faces, which run counter-clockwise seen from outside.
struct Solid {
    vertices: Vec<[f64; 3]>,
    faces: Vec<Vec<usize>>,
}

fn cube() -> Solid {
    let sign = |bit: usize, k: usize| if k >> bit & 1 == 0 { -1.0 } else { 1.0 };
    Solid {
        vertices: (0..8).map(|k| [sign(0, k), sign(1, k), sign(2, k)]).collect(),
        faces: vec![
            vec![0, 4, 6, 2],
            vec![1, 3, 7, 5],
            vec![0, 1, 5, 4],
            vec![2, 6, 7, 3],
            vec![0, 2, 3, 1],
            vec![4, 5, 7, 6],
        ],
    }
}

fn sphere(rows: usize, columns: usize) -> Solid {
    let mut vertices = vec![[0.0, 1.2, 0.0], [0.0, -1.2, 0.0]];
    for i in 1..rows {
        for j in 0..columns {
            let theta = std::f64::consts::PI * i as f64 / rows as f64;
            let phi = std::f64::consts::TAU * j as f64 / columns as f64;
            vertices.push([theta.sin() * phi.sin(), theta.cos(), theta.sin() * phi.cos()].map(|v| 1.2 * v));
        }
    }
    let at = |i: usize, j: usize| match i {
        0 => 0,
        i if i == rows => 1,
        i => 2 + (i - 1) * columns + j % columns,
    };
    let mut faces = Vec::new();
    for i in 0..rows {
        for j in 0..columns {
            let mut face = vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            face.dedup();
            if face.first() == face.last() {
                face.pop();
            }
            faces.push(face);
        }
    }
    Solid { vertices, faces }
}

/// Pixels and depth of a point after a turn, at a distance from the eye. Near plane at 1, far plane at infinity.
fn project(p: [f64; 3], (yaw, pitch): (f64, f64), distance: f64) -> [f32; 3] {
    let (s, c) = yaw.sin_cos();
    let p = [c * p[0] + s * p[2], p[1], c * p[2] - s * p[0]];
    let (s, c) = pitch.sin_cos();
    let p = [p[0], c * p[1] - s * p[2], c * p[2] + s * p[1]];
    let w = distance - p[2];
    let scale = 0.45 * f64::from(SIDE) * (distance * distance - 3.0).max(1.0).sqrt() / 1.8;
    let middle = f64::from(SIDE) / 2.0;
    [(middle + scale * p[0] / w) as f32, (middle - scale * p[1] / w) as f32, (1.0 / w) as f32]
}

/// Twice the area on the picture, positive if the face is seen from outside.
fn area(face: &[usize], points: &[[f32; 3]]) -> f64 {
    let turn = |a: [f32; 3], b: [f32; 3]| f64::from(a[0]) * f64::from(b[1]) - f64::from(a[1]) * f64::from(b[0]);
    -(0..face.len()).map(|k| turn(points[face[k]], points[face[(k + 1) % face.len()]])).sum::<f64>()
}

/// The drawing of a solid's faces (without strokes), and its edges: between faces of which at least one is seen from
/// outside, and the others. `inside` draws only the faces seen from inside.
fn draw(
    solid: &Solid,
    points: &[[f32; 3]],
    antialias: Samples,
    inside: bool,
) -> (Drawing, Vec<[usize; 2]>, Vec<[usize; 2]>) {
    let (mut triangles, mut front, mut all) = (Vec::new(), Vec::new(), Vec::new());
    for face in &solid.faces {
        let seen = (area(face, points) > 0.0) != inside;
        for k in 0..face.len() {
            let (a, b) = (face[k], face[(k + 1) % face.len()]);
            let edge = [a.min(b), a.max(b)];
            all.push(edge);
            if seen {
                front.push(edge);
            }
        }
        if seen {
            for k in 2..face.len() {
                triangles.push([face[0], face[k - 1], face[k]].map(|v| u32::try_from(v).expect("few vertices")));
            }
        }
    }
    for edges in [&mut front, &mut all] {
        edges.sort_unstable();
        edges.dedup();
    }
    all.retain(|e| !front.contains(e));
    let surface = Surface::solid(points.to_vec(), triangles, Rgba::rgb(180, 200, 230));
    let drawing = Drawing { antialias, surfaces: vec![surface], ..Drawing::new(SIDE, SIDE, Rgba::rgb(255, 255, 255)) };
    (drawing, front, all)
}

fn with_edges(drawing: &Drawing, points: &[[f32; 3]], edges: &[[usize; 2]], hidden: HiddenLines) -> Pixmap {
    let mut drawing = drawing.clone();
    let ends: Vec<_> = edges.iter().map(|e| [points[e[0]], points[e[1]]]).collect();
    let style = LineStyle { color: INK, width: 1.5, dash: Dash::Solid, hidden, arrow: false };
    drawing.strokes.push(StrokeSet::pairs(&ends, style));
    Rasterizer::default().paint(&drawing).expect("a picture")
}

/// Pixels that differ by more than `step`.
fn differing(a: &Pixmap, b: &Pixmap, step: u8) -> usize {
    a.data()
        .chunks(4)
        .zip(b.data().chunks(4))
        .filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > step))
        .count()
}

#[test]
fn edges_on_their_own_faces_are_seen_in_full_from_everywhere() {
    for (name, solid) in [("cube", cube()), ("sphere", sphere(8, 12)), ("fine sphere", sphere(40, 60))] {
        for antialias in [Samples::One, Samples::Four] {
            for k in 0..14 {
                // Also views along the axes and along the faces, and from very near and very far.
                let view = [(0.0, 0.0), (0.0, 0.01), (std::f64::consts::FRAC_PI_4, 0.0)].get(k).copied();
                let view = view.unwrap_or((0.9 * k as f64, 0.61 * k as f64 - 3.0));
                let distance = [4.0, 2.2, 40.0, 4000.0][k % 4];
                let points: Vec<_> = solid.vertices.iter().map(|&p| project(p, view, distance)).collect();
                let (drawing, front, _) = draw(&solid, &points, antialias, false);
                let shown = with_edges(&drawing, &points, &front, HiddenLines::Shown);
                let tested = with_edges(&drawing, &points, &front, HiddenLines::Hidden);
                let differ = differing(&shown, &tested, 0);
                // Faces of a pixel's width are too small to tell everywhere which of them a line lies on.
                let allowed = usize::from(name == "fine sphere");
                assert!(differ <= allowed, "{name} from {view:?} at {distance}, {antialias} samples: {differ}");
            }
        }
    }
}

#[test]
fn edges_in_the_corners_of_a_room_are_seen_in_full() {
    let solid = cube();
    for antialias in [Samples::One, Samples::Four] {
        for k in 0..12 {
            // From inside, looking along the room: walls as steep as they can be.
            let room = |p: [f64; 3]| [p[0], p[1], 20.0 * p[2] - 18.0];
            let view = (0.02 * f64::from(k) - 0.1, 0.015 * f64::from(k) - 0.08);
            let points: Vec<_> = solid.vertices.iter().map(|&p| room(p)).map(|p| project(p, view, 4.0)).collect();
            let (drawing, front, _) = draw(&solid, &points, antialias, true);
            assert!(drawing.surfaces[0].triangles.len() >= 6, "walls are seen");
            let shown = with_edges(&drawing, &points, &front, HiddenLines::Shown);
            let tested = with_edges(&drawing, &points, &front, HiddenLines::Hidden);
            assert_eq!(differing(&shown, &tested, 0), 0, "view {k}, {antialias} samples");
        }
    }
}

#[test]
fn edges_behind_the_faces_show_at_the_outline_alone() {
    for (name, solid) in [("cube", cube()), ("sphere", sphere(8, 12))] {
        for antialias in [Samples::One, Samples::Four] {
            for k in 0..12 {
                let view = (0.9 * f64::from(k) + 0.2, 0.61 * f64::from(k) - 3.0);
                let points: Vec<_> = solid.vertices.iter().map(|&p| project(p, view, 4.0)).collect();
                let (drawing, _, back) = draw(&solid, &points, antialias, false);
                assert!(back.len() >= 3);
                let none = with_edges(&drawing, &points, &[], HiddenLines::Hidden);
                let hidden = with_edges(&drawing, &points, &back, HiddenLines::Hidden);
                let deep = (0..SIDE * SIDE)
                    .map(|i| [i % SIDE, i / SIDE])
                    .filter(|&[x, y]| none.pixel(x, y) != hidden.pixel(x, y) && !near_the_background(&none, [x, y]));
                assert_eq!(deep.count(), 0, "{name} from {view:?}, {antialias} samples");
            }
        }
    }
}

/// True if a pixel of the background is no farther than three pixels: two in which a hidden line may show, and half
/// the width of the line.
fn near_the_background(pixmap: &Pixmap, [x, y]: [u32; 2]) -> bool {
    let range = |v: u32| v.saturating_sub(3)..(v + 4).min(SIDE);
    range(y).any(|j| {
        range(x).any(|i| pixmap.pixel(i, j).is_some_and(|p| (p.red(), p.green(), p.blue()) == (255, 255, 255)))
    })
}

#[test]
fn a_line_one_percent_behind_a_face_is_hidden_and_one_before_it_is_seen() {
    // A wall that runs away from the viewer: from distance 2 at the left to 12 at the right.
    let depth = |x: f64| 0.5 + (x - 10.0) / 130.0 * (1.0 / 12.0 - 0.5);
    let wall = |x: f64, y: f64, scale: f64| [x as f32, y as f32, (depth(x) * scale) as f32];
    let positions =
        vec![wall(10.0, 10.0, 1.0), wall(140.0, 10.0, 1.0), wall(140.0, 140.0, 1.0), wall(10.0, 140.0, 1.0)];
    for antialias in [Samples::One, Samples::Four, Samples::Sixteen] {
        let surface = Surface::solid(positions.clone(), vec![[0, 1, 2], [0, 2, 3]], Rgba::rgb(180, 200, 230));
        let drawing =
            Drawing { antialias, surfaces: vec![surface], ..Drawing::new(SIDE, SIDE, Rgba::rgb(255, 255, 255)) };
        for (from, to) in [((20.0, 30.0), (130.0, 30.0)), ((25.0, 20.0), (120.0, 130.0)), ((70.0, 15.0), (71.0, 135.0))]
        {
            // Depth is 1/distance here: one percent farther is one percent less.
            let line = |scale: f64| vec![wall(from.0, from.1, scale), wall(to.0, to.1, scale)];
            let picture = |points: &[[f32; 3]], hidden| with_edges(&drawing, points, &[[0, 1]], hidden);
            let shown = picture(&line(1.0), HiddenLines::Shown);
            let bare = with_edges(&drawing, &[], &[], HiddenLines::Shown);
            assert!(differing(&shown, &bare, 64) > 100);
            assert_eq!(
                differing(&picture(&line(0.99), HiddenLines::Hidden), &bare, 0),
                0,
                "behind, {antialias} samples"
            );
            assert_eq!(
                differing(&picture(&line(1.0), HiddenLines::Hidden), &shown, 0),
                0,
                "on it, {antialias} samples"
            );
            assert_eq!(
                differing(&picture(&line(1.01), HiddenLines::Hidden), &shown, 0),
                0,
                "before, {antialias} samples"
            );
        }
    }
}

#[test]
fn strokes_that_are_nonsense_are_left_out_without_harm() {
    let bad = [f32::NAN, f32::INFINITY, -1e30, 1e30, 1e9];
    for value in bad {
        for slot in 0..3 {
            for (width, dash) in
                [(1.5, Dash::DashDot), (value, Dash::Dashed), (0.0, Dash::Dotted), (1e-30, Dash::Dashed)]
            {
                let mut points = vec![[10.0, 10.0, 0.5], [50.0, 60.0, 0.4], [90.0, 20.0, 0.6]];
                points[1][slot] = value;
                let style = LineStyle { color: INK, width, dash, hidden: HiddenLines::Dashed, arrow: true };
                let polylines = vec![0..3, 1..2, 2..2, 2..99, Range { start: 7, end: 3 }];
                let square = vec![[20.0, 20.0, 0.5], [80.0, 20.0, 0.5], [80.0, 80.0, 0.5]];
                let surface = Surface::solid(square, vec![[0, 1, 2]], INK);
                let drawing = Drawing {
                    surfaces: vec![surface],
                    strokes: vec![StrokeSet { polylines, ..StrokeSet::line(points, style) }],
                    ..Drawing::new(100, 80, Rgba::rgb(255, 255, 255))
                };
                assert!(Rasterizer::default().paint(&drawing).is_some());
            }
        }
    }
}

#[test]
fn a_line_behind_a_tint_is_dimmed_and_so_is_a_mark() {
    let corners = [[10.0, 10.0, 0.5], [140.0, 10.0, 0.5], [140.0, 140.0, 0.5], [10.0, 140.0, 0.5]];
    let wall = |opacity: u8| {
        let color = Rgba::rgb(200, 60, 200).with_alpha(opacity);
        let surface = Surface::solid(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], color);
        Drawing {
            antialias: Samples::Four,
            surfaces: vec![surface],
            ..Drawing::new(SIDE, SIDE, Rgba::rgb(255, 255, 255))
        }
    };
    // How much darker a pixel of the line is than without it: in the middle of the wall, and beside it.
    let ink = |drawing: &Drawing, depth: f32, hidden| {
        let ends = [[2.0, 75.5, depth], [148.0, 75.5, depth]];
        let (with, bare) = (with_edges(drawing, &ends, &[[0, 1]], hidden), with_edges(drawing, &ends, &[], hidden));
        [75, 5].map(|x| {
            let green = |picture: &Pixmap| picture.pixel(x, 75).map_or(0, |pixel| pixel.green());
            i32::from(green(&bare)) - i32::from(green(&with))
        })
    };
    for hidden in [HiddenLines::Hidden, HiddenLines::Dashed] {
        let [on, beside] = ink(&wall(128), 0.5, hidden);
        assert_eq!(ink(&wall(128), 0.7, hidden), [on, beside], "before it");
        let [behind, outside] = ink(&wall(128), 0.3, hidden);
        assert!(5 * behind < 3 * on && behind > on / 5, "{hidden:?}: {behind} of {on}");
        assert_eq!(outside, beside, "where there is no wall");
        let [faint, _] = ink(&wall(40), 0.3, hidden);
        assert_eq!(faint, ink(&wall(40), 0.7, hidden)[0], "what is nearly clear dims nothing");
    }
    assert_eq!(ink(&wall(128), 0.3, HiddenLines::Shown), ink(&wall(128), 0.7, HiddenLines::Shown));
    let marked = |depth: f32| {
        let position = [75.0, 75.0, depth];
        let (shape, color) = (MarkShape::Disc, INK);
        let marks = vec![Mark { position, shape, radius: 5.0, color, outline: color, fade_if_hidden: true }];
        let picture = Rasterizer::default().paint(&Drawing { marks, ..wall(128) }).expect("a picture");
        picture.pixel(75, 75).expect("inside").green()
    };
    assert!(marked(0.3) > marked(0.7) + 40);
}
