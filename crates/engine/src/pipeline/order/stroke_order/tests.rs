#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use super::*;
use crate::appearance::{Dash, Rgba, Samples};
use crate::drawing::StrokeSet;

fn style(width: f32, hidden: HiddenLines) -> LineStyle {
    LineStyle { color: Rgba::rgb(0, 0, 0), width, dash: Dash::Solid, hidden, arrow: false }
}

fn tested(width: f32) -> LineStyle {
    style(width, HiddenLines::Hidden)
}

/// A drawing of 100 × 100 pixels with one set for each stroke.
fn drawing(strokes: &[(&[[f32; 3]], LineStyle)]) -> Drawing {
    let sets = strokes.iter().map(|&(points, style)| StrokeSet::line(points.to_vec(), style));
    Drawing {
        width: 100,
        height: 100,
        background: Rgba::rgb(255, 255, 255),
        antialias: Samples::One,
        painted_in_order: true,
        depth_format: Default::default(),
        fine_grid: false,
        order: Default::default(),
        surfaces: Vec::new(),
        strokes: sets.collect(),
        areas: Vec::new(),
        marks: Vec::new(),
        labels: Vec::new(),
    }
}

/// The sets of the runs in the order in which they are painted.
fn order(strokes: &[(&[[f32; 3]], LineStyle)]) -> Vec<usize> {
    painted_runs(&drawing(strokes)).unwrap().iter().map(|run| run.set).collect()
}

fn level(y: f32, depth: f32) -> [[f32; 3]; 2] {
    [[5.0, y, depth], [95.0, y, depth]]
}

fn upright(x: f32, depth: f32) -> [[f32; 3]; 2] {
    [[x, 5.0, depth], [x, 95.0, depth]]
}

#[test]
fn the_nearer_of_two_that_cross_comes_later_in_any_order_of_the_list() {
    let (near, far) = (level(50.0, 0.8), upright(50.0, 0.3));
    assert_eq!(order(&[(&near, tested(2.0)), (&far, tested(2.0))]), [1, 0]);
    assert_eq!(order(&[(&far, tested(2.0)), (&near, tested(2.0))]), [0, 1]);
    // Apart from one another they stay as they are listed.
    let beside = upright(50.0, 0.3).map(|[x, y, z]| [x, y * 0.4, z]);
    assert_eq!(order(&[(&near, tested(2.0)), (&beside, tested(2.0))]), [0, 1]);
}

#[test]
fn a_thin_one_and_a_thick_one_touch_beside_the_border_of_a_square_too() {
    // Squares end at x = 32: the point half way between the two lies in one that the thin stroke doesn't reach.
    for (thin, thick) in [(31.4, 34.5), (32.6, 29.5), (31.0, 33.0)] {
        let (thin, thick) = (upright(thin, 0.8), upright(thick, 0.3));
        assert_eq!(order(&[(&thin, tested(1.0)), (&thick, tested(8.0))]), [1, 0]);
        assert_eq!(order(&[(&thick, tested(8.0)), (&thin, tested(1.0))]), [0, 1]);
    }
}

#[test]
fn where_they_touch_the_wider_then_the_later_comes_later() {
    let (one, other) = (level(50.0, 0.5), upright(50.0, 0.5));
    assert_eq!(order(&[(&one, tested(2.0)), (&other, tested(2.0))]), [0, 1]);
    assert_eq!(order(&[(&one, tested(3.0)), (&other, tested(2.0))]), [1, 0]);
    // Side by side, and over one another, too.
    let beside = level(51.5, 0.2);
    assert_eq!(order(&[(&one, tested(2.0)), (&beside, tested(2.0))]), [1, 0]);
    assert_eq!(order(&[(&one, tested(2.0)), (&level(50.0, 0.2), tested(2.0))]), [1, 0]);
    assert_eq!(order(&[(&one, tested(2.0)), (&level(52.5, 0.2), tested(2.0))]), [0, 1]);
}

#[test]
fn what_nothing_hides_comes_last() {
    let shown = style(1.0, HiddenLines::Shown);
    assert_eq!(order(&[(&level(50.0, 0.1), shown), (&upright(50.0, 0.9), tested(2.0))]), [1, 0]);
}

#[test]
fn a_run_that_is_before_and_behind_another_is_split_between() {
    // It goes twice over an upright line that leans: behind it above, in front of it below.
    let leaning = [[50.0, 5.0, 0.9], [50.0, 95.0, 0.1]];
    let around = [[20.0, 20.0, 0.5], [80.0, 20.0, 0.5], [80.0, 80.0, 0.5], [20.0, 80.0, 0.5]];
    let drawing = drawing(&[(&around, tested(2.0)), (&leaning, tested(2.0))]);
    let runs = painted_runs(&drawing).unwrap();
    let at = |set: usize, y: f32| {
        let here = |run: &Run| run.points.windows(2).any(|p| p[0][1].min(p[1][1]) <= y && y <= p[0][1].max(p[1][1]));
        runs.iter().position(|run| run.set == set && here(run))
    };
    assert!(at(0, 20.0) < at(1, 20.0) && at(1, 80.0) < at(0, 80.0), "{runs:?}");
    // The parts make up the whole, and each knows its start along it.
    let mut parts: Vec<&Run> = runs.iter().filter(|run| run.set == 0).collect();
    parts.sort_by(|a, b| a.start.total_cmp(&b.start));
    assert_eq!(parts.iter().map(|run| (run.start, run.has_end)).collect::<Vec<_>>(), [(0.0, false), (90.0, true)]);
    assert_eq!(parts[0].points, [around[0], around[1], [80.0, 50.0, 0.5]]);
    assert_eq!(parts[1].points, [[80.0, 50.0, 0.5], around[2], around[3]]);
}

#[test]
fn three_in_a_cycle_are_each_over_the_next() {
    // The sides of a triangle, drawn out, each from near to far.
    let ends: [[f32; 2]; 3] = [[20.0, 80.0], [80.0, 80.0], [50.0, 20.0]];
    let side = |k: usize| {
        let (a, b) = (ends[k], ends[(k + 1) % 3]);
        let point = |t: f32, depth: f32| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), depth];
        [point(-0.2, 0.9), point(1.2, 0.1)]
    };
    let sides = [side(0), side(1), side(2)];
    let runs = painted_runs(&drawing(&[(&sides[0], tested(3.0)), (&sides[1], tested(3.0)), (&sides[2], tested(3.0))]))
        .unwrap();
    assert!(runs.len() > 3);
    // At the corner where side k begins it is over the side before.
    for (k, end) in ends.iter().enumerate() {
        let covers = |set: usize| {
            runs.iter().rposition(|run| {
                let [p, q] = [run.points[0], run.points[run.points.len() - 1]].map(|p| p.map(f64::from));
                let along: [f64; 3] = std::array::from_fn(|k| q[k] - p[k]);
                let length = along[0].hypot(along[1]);
                let part = Segment {
                    run: 0,
                    layer: (0, Occlusion::None),
                    from: p,
                    along,
                    arc: 0.0,
                    length,
                    radius: 0.0,
                    width: 0.0,
                };
                let corner = [f64::from(end[0]), f64::from(end[1]), 0.0];
                run.set == set && distance(part.at(part.nearest_to(corner)), corner) < 0.1
            })
        };
        let (over, below) = (covers(k), covers((k + 2) % 3));
        assert!(over.is_some() && below.is_some() && over > below, "{k}: {runs:?}");
    }
}

#[test]
fn an_arrow_head_touches_with_its_width() {
    let arrow = LineStyle { arrow: true, ..tested(2.0) };
    let near = [[5.0, 50.0, 0.9], [60.0, 50.0, 0.9]];
    // Its head is 12 long and 9 wide; the other stroke passes 3 pixels beside its middle line.
    let beside = [[52.0, 53.5, 0.2], [52.0, 90.0, 0.2]];
    assert_eq!(order(&[(&near, arrow), (&beside, tested(1.0))]), [1, 0]);
    assert_eq!(order(&[(&near, tested(2.0)), (&beside, tested(1.0))]), [0, 1]);
}

#[test]
fn two_that_go_along_each_other_and_change_their_order_are_cut_there() {
    // One leans away from the eye, the other doesn't. Their depths are equal at x = 50, and their ways nearly parallel.
    let level = [[5.0, 50.0, 0.5], [95.0, 50.0, 0.5]];
    let leaning = [[5.0, 49.5, 0.9], [95.0, 50.5, 0.1]];
    for (first, second) in [(&level, &leaning), (&leaning, &level)] {
        let runs = painted_runs(&drawing(&[(first, tested(2.0)), (second, tested(2.0))])).unwrap();
        let set_of = |line: &[[f32; 3]; 2]| usize::from(line != first);
        let painted = |set: usize, x: f32| {
            let here = |run: &Run| run.points[0][0] <= x && x <= run.points[run.points.len() - 1][0];
            runs.iter().rposition(|run| run.set == set && here(run))
        };
        for x in [10.0, 30.0, 44.0, 56.0, 70.0, 90.0] {
            let (flat, lean) = (painted(set_of(&level), x), painted(set_of(&leaning), x));
            assert!(flat.is_some() && lean.is_some());
            assert_eq!(lean > flat, x < 50.0, "{x}: {runs:?}");
        }
    }
}

#[test]
fn strokes_that_touch_too_often_are_given_up() {
    let (one, other) = (level(50.0, 0.8), upright(50.0, 0.3));
    let drawing = drawing(&[(&one, tested(2.0)), (&other, tested(2.0))]);
    let steps = |few| runs_in_order(&drawing, &mut WorkBudget::few(few)).map(|runs| runs.len());
    assert_eq!(steps(1000), Ok(2));
    assert_eq!([steps(64), steps(200)], [Err(OverBudget::Strokes), Err(OverBudget::Strokes)]);
}
