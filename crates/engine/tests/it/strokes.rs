//! Strokes and marks, painted slowly: for each pixel, the distance to every piece of every stroke. The fast way gives
//! the same picture, but for the rounding of each layer.

#![expect(clippy::cast_possible_truncation, reason = "small numbers, and bytes of random ones")]

use std::f64::consts::SQRT_2;

use camera_lab_engine::appearance::{Dash, HiddenLines, LineStyle, MarkShape, Rgba, head_corners};
use camera_lab_engine::drawing::{Drawing, Mark, StrokeSet};
use camera_lab_engine::raster::Rasterizer;
use glam::DVec2;

use super::textbook::Random;

const SIZE: [u32; 2] = [61, 43];

/// Sets of strokes, each at a depth of its own. Some aren't hidden by anything, so they're over all others.
fn strokes(random: &mut Random) -> Vec<StrokeSet> {
    let count = 1 + random.next() % 7;
    let set = |k: u64| {
        let depth = 0.1 + 0.8 * ((5 * k + 3) % 8) as f32 / 8.0;
        let style = LineStyle {
            color: random.color(false),
            width: random.within(0.3, 6.0),
            dash: [Dash::Solid, Dash::Dashed, Dash::Dotted, Dash::DashDot][(random.next() % 4) as usize],
            hidden: [HiddenLines::Shown, HiddenLines::Hidden][(random.next() % 2) as usize],
            arrow: random.next().is_multiple_of(3),
        };
        let points = (0..2 + random.next() % 4).map(|_| random.position(SIZE, 20.0)).map(|[x, y, _]| [x, y, depth]);
        StrokeSet::line(points.collect(), style)
    };
    (0..count).map(set).collect()
}

/// The pieces of a polyline between two arc lengths.
fn between(points: &[DVec2], from: f64, to: f64) -> Vec<[DVec2; 2]> {
    let mut start = 0.0;
    let mut pieces = Vec::new();
    for pair in points.windows(2) {
        let end = start + pair[0].distance(pair[1]);
        let at = |arc: f64| pair[0].lerp(pair[1], ((arc - start) / (end - start).max(1e-9)).clamp(0.0, 1.0));
        if from <= end && to >= start {
            pieces.push([at(from), at(to)]);
        }
        start = end;
    }
    pieces
}

/// The middle lines of the dashes of a polyline, and the corners of its arrow head.
fn pieces(set: &StrokeSet) -> (Vec<[DVec2; 2]>, Option<[DVec2; 3]>) {
    let points: Vec<DVec2> = set.points.iter().map(|p| DVec2::new(f64::from(p[0]), f64::from(p[1]))).collect();
    let length: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    let head = f64::from(set.style.head_length(length as f32));
    // The shaft ends inside the head.
    let (shaft, width) = (length - 0.8 * head, f64::from(set.style.width));
    let mut dashes = vec![[0.0, shaft.max(0.0)]];
    if let pattern @ [_, ..] = set.style.dash.pattern() {
        dashes.clear();
        let mut start = 0.0;
        for on_off in pattern.chunks(2).cycle().take(1000) {
            let [on, off] = [0, 1].map(|k| f64::from(on_off[k]) * width);
            // Both ends are round.
            let first = start + 0.5 * width;
            dashes.push([first, (start + on - 0.5 * width).max(first).min(shaft)]);
            start += on + off;
        }
    }
    let lines = dashes.into_iter().filter(|[from, to]| from <= to).flat_map(|[from, to]| between(&points, from, to));
    let end = |arc: f64| between(&points, arc, length).first().map(|piece| piece[0].as_vec2().to_array());
    let corners = (head > 0.0).then(|| Some(head_corners([end(length)?, end(length - head)?]))).flatten();
    let corners = corners.map(|corners| corners.map(|[x, y]| DVec2::new(f64::from(x), f64::from(y))));
    (lines.collect(), corners)
}

/// The share of a pixel that a stroke covers: a band as wide as the stroke, at the distance of its middle line.
fn share(p: DVec2, (lines, head): &(Vec<[DVec2; 2]>, Option<[DVec2; 3]>), radius: f64) -> f64 {
    let of_line = |[a, b]: &[DVec2; 2]| {
        let along = (p - *a).dot(*b - *a) / (*b - *a).length_squared().max(1e-12);
        let distance = p.distance(a.lerp(*b, along.clamp(0.0, 1.0)));
        ((distance + 0.5).min(radius) - (distance - 0.5).max(-radius)).clamp(0.0, 1.0)
    };
    let of_head = |corners: &[DVec2; 3]| {
        let [a, b, c] = *corners;
        // Its point is acute, and ends with the box around it.
        if (a.min(b).min(c) - p).max(p - a.max(b).max(c)).max_element() > 0.5 {
            return 0.0;
        }
        let turn = (b - a).perp_dot(c - a).signum();
        let inside = |p0: DVec2, p1: DVec2| turn * (p1 - p0).normalize_or_zero().perp_dot(p - p0);
        (inside(a, b).min(inside(b, c)).min(inside(c, a)) + 0.5).clamp(0.0, 1.0)
    };
    lines.iter().map(of_line).chain(head.iter().map(of_head)).fold(0.0, f64::max)
}

/// A colour over a pixel, both as numbers from 0 to 255.
fn over(pixel: &mut [f64; 3], color: Rgba, share: f64) {
    let opacity = f64::from(color.a) / 255.0 * share;
    for (under, own) in pixel.iter_mut().zip([color.r, color.g, color.b]) {
        *under += (f64::from(own) - *under) * opacity;
    }
}

/// The picture, pixel by pixel: each set of strokes is one layer, in which a pixel keeps its greatest share. Nearer
/// layers are over farther ones, and those that nothing hides over all.
fn painted(drawing: &Drawing) -> Vec<[f64; 3]> {
    let is_shown = |set: &&StrokeSet| set.style.hidden == HiddenLines::Shown;
    let mut sets: Vec<&StrokeSet> = drawing.strokes.iter().filter(|set| !is_shown(set)).collect();
    sets.sort_by(|a, b| a.points[0][2].total_cmp(&b.points[0][2]));
    sets.extend(drawing.strokes.iter().filter(is_shown));
    let layers: Vec<_> = sets.into_iter().map(|set| (pieces(set), set.style)).collect();
    let pixel = |k: u32| {
        let p = DVec2::new(f64::from(k % SIZE[0]), f64::from(k / SIZE[0])) + 0.5;
        let mut pixel = [drawing.background.r, drawing.background.g, drawing.background.b].map(f64::from);
        for (pieces, style) in &layers {
            over(&mut pixel, style.color, share(p, pieces, 0.5 * f64::from(style.width)));
        }
        for mark in &drawing.marks {
            mark_over(&mut pixel, p, mark);
        }
        pixel
    };
    (0..SIZE[0] * SIZE[1]).map(pixel).collect()
}

/// The outline of a mark over a pixel, then its inside, by many points of the pixel.
fn mark_over(pixel: &mut [f64; 3], p: DVec2, mark: &Mark) {
    const FINE: u32 = 8;
    let (r, center) = (f64::from(mark.radius), DVec2::new(f64::from(mark.position[0]), f64::from(mark.position[1])));
    let line = (0.35 * r).max(1.0);
    // The distance from the outline of the shape, less than 0 inside.
    let beyond = |d: DVec2| match mark.shape {
        MarkShape::Disc => d.length() - r,
        MarkShape::Ring => (d.length() - 0.8 * r).abs() - line,
        MarkShape::Square => d.abs().max_element() - 0.9 * r,
        MarkShape::Diamond => (d.abs().element_sum() - 1.2 * r) / SQRT_2,
        MarkShape::Cross => {
            let along = DVec2::new(d.x + d.y, d.x - d.y).abs() / SQRT_2;
            // The ends of its bars are cut square, without an outline.
            let bar = |across: f64, along: f64| if along <= 0.8 * r * SQRT_2 { across - line } else { f64::INFINITY };
            bar(along.x, along.y).min(bar(along.y, along.x))
        }
    };
    let wider = if matches!(mark.shape, MarkShape::Ring | MarkShape::Cross) { 0.75 } else { 1.0 };
    for (color, reach) in [(mark.outline, wider), (mark.color, 0.0)] {
        let points = (0..FINE * FINE).map(|k| DVec2::new(f64::from(k % FINE), f64::from(k / FINE)));
        let inside = points.filter(|k| beyond(p + (*k + 0.5) / f64::from(FINE) - 0.5 - center) <= reach).count();
        over(pixel, color, inside as f64 / f64::from(FINE * FINE));
    }
}

/// The greatest difference from the fast picture, and the mean of all.
fn difference(drawing: &Drawing) -> [f64; 2] {
    let fast = Rasterizer::default().paint(drawing).expect("a picture");
    let slow = painted(drawing);
    let pairs = fast.pixels().iter().zip(&slow);
    let by = pairs.flat_map(|(p, q)| [p.red(), p.green(), p.blue()].into_iter().map(f64::from).zip(*q));
    let by: Vec<f64> = by.map(|(fast, slow)| (fast - slow).abs()).collect();
    [by.iter().copied().fold(0.0, f64::max), by.iter().sum::<f64>() / by.len() as f64]
}

#[test]
fn strokes_are_those_of_the_distance_to_their_middle_lines() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let strokes = strokes(&mut random);
        // Half a step for the share of each layer, and one for each blending.
        let most = 1.5 * strokes.len() as f64 + 0.5;
        let drawing = Drawing { strokes, ..Drawing::new(SIZE[0], SIZE[1], random.color(true)) };
        let [greatest, _] = difference(&drawing);
        assert!(greatest <= most, "seed {seed}: {greatest} of {most}: {:#?}", drawing.strokes);
    }
}

#[test]
fn marks_are_their_shapes() {
    let shapes = [MarkShape::Disc, MarkShape::Ring, MarkShape::Square, MarkShape::Diamond, MarkShape::Cross];
    for (seed, shape) in (0..).zip(shapes.into_iter().cycle().take(50)) {
        let mut random = Random::new(seed);
        let position = random.position(SIZE, -8.0);
        let colors = [random.color(true), random.color(true)];
        let marks = vec![Mark::new(position, shape, random.within(3.0, 9.0), colors)];
        let drawing = Drawing { marks, ..Drawing::new(SIZE[0], SIZE[1], random.color(true)) };
        // Paths have four rows of points in a pixel.
        let [greatest, mean] = difference(&drawing);
        assert!(greatest <= 64.0 && mean < 0.7, "seed {seed} {shape:?}: {greatest} {mean}");
    }
}
