//! Where the texts of a picture stand, so that none covers another, a mark or a strong line, and none is cut off.

use glam::DVec2;

use crate::appearance::Rgba;
use crate::drawing::{Anchor, Drawing, Label, StrokeSet};
use crate::text::{measure, x_height};

/// A rectangle in pixels: its middle and half its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Box2 {
    pub(super) center: DVec2,
    pub(super) half: DVec2,
}

impl Box2 {
    /// The area that both cover.
    fn overlap(&self, other: &Self) -> f64 {
        let d = (self.half + other.half - (self.center - other.center).abs()).max(DVec2::ZERO);
        (d.x * d.y).min(4.0 * self.half.x * self.half.y)
    }

    /// The length of a segment's part inside (Liang and Barsky 1984).
    fn length_inside(&self, a: DVec2, b: DVec2) -> f64 {
        let (from, d) = (a - self.center, b - a);
        let (mut t0, mut t1) = (0.0_f64, 1.0_f64);
        for (p, d, h) in [(from.x, d.x, self.half.x), (from.y, d.y, self.half.y)] {
            if d.abs() < 1e-12 {
                if p.abs() > h {
                    return 0.0;
                }
                continue;
            }
            let (s, e) = ((-h - p) / d, (h - p) / d);
            t0 = t0.max(s.min(e));
            t1 = t1.min(s.max(e));
        }
        (t1 - t0).max(0.0) * d.length()
    }
}

/// Places the labels of a drawing, larger ones first, equal ones in their order: the offset of each is the direction and
/// distance that it would like; one that finds no free place is left out. Lines in a color of `background` may be covered, but
/// not what is `reserved`.
pub(super) fn settle(drawing: &mut Drawing, background: &[Rgba], reserved: Option<Box2>) {
    let lines = lines(&drawing.strokes, background);
    let mut taken: Vec<Box2> = drawing
        .marks
        .iter()
        .map(|m| Box2 { center: point(m.position), half: DVec2::splat(f64::from(m.radius)) })
        .collect();
    let marks = taken.len();
    taken.extend(reserved);
    let picture = DVec2::new(f64::from(drawing.width), f64::from(drawing.height));
    let mut kept = Vec::with_capacity(drawing.labels.len());
    drawing.labels.sort_by(|a, b| b.size.total_cmp(&a.size));
    for mut label in std::mem::take(&mut drawing.labels) {
        let best = candidates(&label)
            .map(|(b, dislike)| (b, dislike + cost(&b, &taken, marks, &lines, picture, f64::from(label.size))))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((place, cost)) = best else { continue };
        if !cost.is_finite() {
            continue;
        }
        let offset = place.center - point(label.position);
        label.offset = [pixels(offset.x), pixels(offset.y)];
        label.anchor = Anchor::Center;
        taken.push(place);
        kept.push(label);
    }
    drawing.labels = kept;
}

#[expect(clippy::cast_possible_truncation, reason = "a place in pixels; f32 is what drawings hold")]
fn pixels(v: f64) -> f32 {
    v as f32
}

fn point(p: [f32; 3]) -> DVec2 {
    DVec2::new(f64::from(p[0]), f64::from(p[1]))
}

/// The segments that a text should not cover.
fn lines(strokes: &[StrokeSet], background: &[Rgba]) -> Vec<[DVec2; 2]> {
    /// Beyond this, a picture is a mesh of edges, and there is no place without them.
    const MOST: usize = 4000;
    let strong = strokes.iter().filter(|s| !background.contains(&s.style.color) && s.points.len() <= MOST);
    strong
        .flat_map(|s| {
            s.polylines.iter().flat_map(|range| {
                let points = s.points.get(range.start as usize..range.end as usize).unwrap_or_default();
                points.windows(2).map(|w| [point(w[0]), point(w[1])])
            })
        })
        .collect()
}

/// Places around a label's point and how little each is liked.
fn candidates(label: &Label) -> impl Iterator<Item = (Box2, f64)> + use<> {
    let half = half_size(&label.text, label.size);
    let offset = DVec2::new(f64::from(label.offset[0]), f64::from(label.offset[1]));
    let (direction, gap) = (offset.normalize_or(DVec2::X), offset.length());
    let (at, em) = (point(label.position), f64::from(label.size));
    let angles = [0.0_f64, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 110.0, -110.0, 145.0, -145.0, 180.0];
    let gaps = [0.0, 0.5, 1.1, 1.8];
    gaps.into_iter().flat_map(move |more| {
        angles.into_iter().map(move |angle| {
            let d = DVec2::from_angle(angle.to_radians()).rotate(direction);
            let reach = gap + more * em + (d.abs() * half).element_sum();
            (Box2 { center: at + d * reach, half }, angle.abs() / 90.0 + 1.5 * more)
        })
    })
}

/// How bad a place is; infinite where a text must not stand.
fn cost(b: &Box2, taken: &[Box2], marks: usize, lines: &[[DVec2; 2]], picture: DVec2, em: f64) -> f64 {
    let (low, high) = (b.center - b.half, b.center + b.half);
    if low.min_element() < 0.0 || (high - picture).max_element() > 0.0 {
        return f64::INFINITY;
    }
    let mut sum = 0.0;
    for (i, other) in taken.iter().enumerate() {
        let overlap = b.overlap(other);
        if overlap > 0.0 && i >= marks {
            return f64::INFINITY;
        }
        sum += 8.0 * overlap / (em * em);
    }
    let crossed: f64 = lines.iter().map(|[p, q]| b.length_inside(*p, *q)).sum();
    sum + 1.2 * crossed / em
}

/// Half the width and height in pixels of what a text takes around its middle, its halo included.
pub(super) fn half_size(text: &str, size: f32) -> DVec2 {
    /// The part of the halo that should stay free, in ems.
    const HALO: f64 = 0.08;
    let extent = measure(text, size);
    // A label's point is at half the height of an x.
    let middle = 0.5 * x_height(size);
    let half = DVec2::new(f64::from(0.5 * extent.width), f64::from((extent.above - middle).max(extent.below + middle)));
    half + HALO * f64::from(size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::appearance::LineStyle;

    fn label(x: f32, y: f32, text: &str) -> Label {
        Label {
            position: [x, y, 0.5],
            offset: [6.0, 0.0],
            text: text.to_owned(),
            size: 14.0,
            color: Rgba::rgb(0, 0, 0),
            halo: Rgba::rgb(255, 255, 255),
            anchor: Anchor::Left,
            fade_if_hidden: false,
        }
    }

    fn drawing(labels: Vec<Label>) -> Drawing {
        Drawing {
            width: 200,
            height: 100,
            background: Rgba::rgb(255, 255, 255),
            antialias: 1,
            painted_in_order: false,
            surfaces: Vec::new(),
            strokes: Vec::new(),
            areas: Vec::new(),
            marks: Vec::new(),
            labels,
        }
    }

    fn boxes(d: &Drawing) -> Vec<Box2> {
        let at = |l: &Label| point(l.position) + DVec2::new(f64::from(l.offset[0]), f64::from(l.offset[1]));
        d.labels.iter().map(|l| Box2 { center: at(l), half: half_size(&l.text, l.size) }).collect()
    }

    #[test]
    fn a_lone_text_stands_where_it_wishes() {
        let mut d = drawing(vec![label(50.0, 50.0, "PF")]);
        settle(&mut d, &[], None);
        let b = boxes(&d)[0];
        assert!((b.center.y - 50.0).abs() < 1e-3);
        assert!((b.center.x - b.half.x - 56.0).abs() < 1e-3, "its left end is 6 px to the right of its point");
    }

    #[test]
    fn texts_at_one_point_do_not_cover_each_other_and_the_last_gives_way() {
        let mut d = drawing((0..60).map(|_| label(50.0, 50.0, "window")).collect());
        settle(&mut d, &[], None);
        let b = boxes(&d);
        assert!((3..59).contains(&b.len()), "{}", b.len());
        for (i, a) in b.iter().enumerate() {
            assert!(b.iter().skip(i + 1).all(|o| a.overlap(o) < 1e-6));
        }
    }

    #[test]
    fn no_text_is_cut_off() {
        let corners = [(1.0, 1.0), (199.0, 1.0), (199.0, 99.0), (1.0, 99.0)];
        let mut d = drawing(corners.iter().map(|&(x, y)| label(x, y, "far")).collect());
        settle(&mut d, &[], None);
        assert_eq!(d.labels.len(), 4);
        for b in boxes(&d) {
            assert!((b.center - b.half).min_element() >= -1e-3);
            assert!((b.center + b.half - DVec2::new(200.0, 100.0)).max_element() <= 1e-3);
        }
    }

    #[test]
    fn a_text_steps_off_a_strong_line_but_not_off_the_grid() {
        let color = Rgba::rgb(10, 20, 30);
        let style = LineStyle { color, width: 1.0, dash: Default::default(), hidden: Default::default(), arrow: false };
        let line = StrokeSet {
            points: vec![[0.0, 50.0, 0.5], [200.0, 50.0, 0.5]],
            polylines: std::iter::once(0..2).collect(),
            style,
        };
        let mut d = drawing(vec![label(50.0, 50.0, "PF")]);
        d.strokes.push(line);
        let mut over_grid = d.clone();
        settle(&mut d, &[], None);
        settle(&mut over_grid, &[color], None);
        assert!(boxes(&d)[0].length_inside(DVec2::new(0.0, 50.0), DVec2::new(200.0, 50.0)) < 1e-6);
        assert!((boxes(&over_grid)[0].center.y - 50.0).abs() < 1e-3);
    }

    #[test]
    fn length_inside_a_box() {
        let b = Box2 { center: DVec2::new(5.0, 5.0), half: DVec2::new(2.0, 1.0) };
        assert!((b.length_inside(DVec2::new(0.0, 5.0), DVec2::new(10.0, 5.0)) - 4.0).abs() < 1e-12);
        assert!((b.length_inside(DVec2::new(5.0, 5.0), DVec2::new(5.0, 50.0)) - 1.0).abs() < 1e-12);
        assert_eq!(b.length_inside(DVec2::new(0.0, 7.0), DVec2::new(10.0, 7.0)), 0.0);
    }
}
