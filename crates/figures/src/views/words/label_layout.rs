//! The layout of the texts of a picture, so that none covers another, a mark or a strong line, and none is cut off.
//!
//! Finding the best places for all labels together is an NP-hard problem (Marks and Shieber 1991), and a drag needs an
//! answer in every frame. So labels choose one after the other, the most important one first. Each tries places around
//! its point, beginning with the one it prefers, and takes the cheapest. A strong line below it costs in proportion to
//! the length it covers. Another text or a mark costs too much. If all places near the point cost too much, the text
//! stands farther off, with a line to its point. If that fails too, it's left out.

use glam::DVec2;

use crate::appearance::{HiddenLines, LineStyle, Rgba, Role};
use crate::drawing::{Anchor, Drawing, Label, StrokeSet, single};
use crate::figure::labels::{set_text, symbols};
use crate::figure::{LabelChange, Labels, Letters, View};
use crate::text::{measure, x_height};

use super::coverage_grid::Solids;
use super::label_obstacles::{Box2, lines, marked, point};
use crate::views::{Palette, Request};

/// The author's wishes for the labels of a picture.
#[derive(Clone, Copy)]
pub(in crate::views) struct Author<'a> {
    pub(in crate::views) labels: &'a Labels,
    pub(in crate::views) view: View,
    /// Colour and width of the lines from labels to their points.
    pub(in crate::views) leader: (Rgba, f32),
    /// The area that labels stay in, in the pixels of the drawing; `None` means all of it.
    pub(in crate::views) page: Option<Box2>,
    /// The height of the smallest letters, in pixels.
    pub(in crate::views) least: f32,
}

impl<'a> Author<'a> {
    pub(in crate::views) fn of(request: &'a Request, palette: Palette) -> Self {
        let leader = (palette.soft, 0.8 * request.size.scale);
        Self { labels: &request.shot.labels, view: request.view, leader, page: None, least: request.least_letters() }
    }

    /// The whole picture, in the pixels of a drawing that begins at `corner` of it.
    pub(in crate::views) fn page(request: &Request, corner: DVec2) -> Box2 {
        let half = 0.5 * DVec2::new(f64::from(request.size.width), f64::from(request.size.height));
        Box2 { center: half - corner, half }
    }

    /// True if letters are mathematical ones.
    pub(in crate::views) fn is_mathematical(&self) -> bool {
        self.labels.letters == Letters::Mathematics
    }

    /// Gives a label the author's text, size and colour.
    pub(in crate::views) fn apply(&self, change: LabelChange<'_>, label: &mut Label) {
        // Texts were checked at their source.
        let text = change.text.and_then(|text| set_text(text).ok());
        label.mathematical = self.is_mathematical();
        if let Some(text) = text {
            label.text = text;
        } else if label.mathematical {
            label.text = symbols(&label.text);
        }
        label.size = label.size.max(self.least);
        if let Some(size) = change.size {
            label.size *= single(size);
        }
        if let Some(color) = change.color {
            label.color = color;
        }
    }

    /// A label that has its own place in the picture, with the author's changes, and the place of its text; `None` if
    /// it's hidden.
    pub(in crate::views) fn finished(&self, mut label: Label, page: &Box2) -> Option<(Label, Box2)> {
        let change = self.labels.change(&label.name, self.view);
        if change.hidden {
            return None;
        }
        self.apply(change, &mut label);
        let place = match change.by {
            Some(by) => put(&mut label, by, page),
            None => Box2 { center: middle(&label), half: half_size(&label) },
        };
        Some((label, place))
    }
}

/// The middle of the text of a label.
pub(in crate::views) fn middle(label: &Label) -> DVec2 {
    let aside = match label.anchor {
        Anchor::Left => half_size(label).x,
        Anchor::Center => 0.0,
        Anchor::Right => -half_size(label).x,
    };
    point(label.position) + DVec2::new(f64::from(label.offset[0]) + aside, f64::from(label.offset[1]))
}

/// Puts a label where its author wants it, but not off the page, and returns the place of its text. `by` leads from its
/// point to its middle, to the right and upwards, in heights of its type.
fn put(label: &mut Label, by: DVec2, page: &Box2) -> Box2 {
    let (at, em, half) = (point(label.position), f64::from(label.size), half_size(label));
    let room = (page.half - half).max(DVec2::ZERO);
    let wanted = at + DVec2::new(by.x, -by.y) * em;
    let place = Box2 { center: wanted.clamp(page.center - room, page.center + room), half };
    let offset = place.center - at;
    label.offset = [single(offset.x), single(offset.y)];
    label.anchor = Anchor::Center;
    place
}

/// The rules by which labels give way to each other.
pub(in crate::views) struct Rules<'a> {
    /// The area that must stay free.
    pub(in crate::views) reserved: Option<Box2>,
    /// Colour and width of the lines that lead from a text to its point if there's no space beside it.
    pub(in crate::views) leader: Option<(Rgba, f32)>,
    /// The author's wishes.
    pub(in crate::views) author: Option<Author<'a>>,
}

/// Places the labels of a drawing. The offset of each is its preferred direction and distance. If a label finds no free
/// place, it's put farther off with a line that leads to its point. If that isn't free either, it's left out.
pub(in crate::views) fn settle(drawing: &mut Drawing, rules: &Rules<'_>) {
    if drawing.labels.is_empty() {
        return;
    }
    let mut taken = Taken::of(drawing, rules);
    let mut kept = Vec::with_capacity(drawing.labels.len());
    let mut of_author = Vec::new();
    if let Some(author) = rules.author {
        let page = author.page.unwrap_or(Box2 { center: 0.5 * taken.picture, half: 0.5 * taken.picture });
        for mut label in std::mem::take(&mut drawing.labels) {
            let change = author.labels.change(&label.name, author.view);
            if change.hidden {
                continue;
            }
            author.apply(change, &mut label);
            match change.by {
                Some(by) => kept.push(taken.put(label, by, &page)),
                None => {
                    if change.text.is_some() || change.size.is_some() {
                        of_author.push(label.name.clone());
                    }
                    drawing.labels.push(label);
                }
            }
        }
    }
    let is_authors = |label: &Label| of_author.contains(&label.name);
    // The texts that the author changed come first, then the principal ones in their order, then larger ones.
    let rank = |label: &Label| (!is_authors(label), label.role.min(Role::Content));
    drawing.labels.sort_by(|a, b| rank(a).cmp(&rank(b)).then(b.size.total_cmp(&a.size)));
    for mut label in std::mem::take(&mut drawing.labels) {
        let important = is_authors(&label) || label.role < Role::Content;
        taken.come_near(&label);
        let beside = label.role == Role::Aside;
        let on_a_body = taken.covered(&Box2 { center: point(label.position), half: DVec2::splat(1.0) }) > 0.5;
        // The first of the cheapest.
        let (mut best, mut least) = (None, f64::INFINITY);
        for candidate in candidates(&label, rules.leader.is_some(), on_a_body) {
            if beside && !important && taken.covered(&candidate.place) > 0.2 {
                continue;
            }
            let cost = candidate.dislike + taken.cost(&candidate, least - candidate.dislike);
            if cost < least {
                (best, least) = (Some(candidate), cost);
            }
        }
        let Some(best) = best.filter(|_| least <= COVERS || important) else { continue };
        let offset = best.place.center - best.at;
        label.offset = [single(offset.x), single(offset.y)];
        label.anchor = Anchor::Center;
        taken.texts.push(best.place);
        if let Some(leader) = best.leader() {
            taken.leaders.push(leader);
        }
        kept.push(label);
    }
    drawing.labels = kept;
    let leader = rules.leader.or(rules.author.map(|author| author.leader));
    if let (Some((color, width)), false) = (leader, taken.leaders.is_empty()) {
        // As around letters, because a body may be as dark as the line.
        let over_bodies: Vec<[DVec2; 2]> =
            taken.leaders.iter().copied().filter(|ends| taken.meets_body(*ends)).collect();
        if let Some(halo) = drawing.labels.first().map(|label| label.halo).filter(|_| !over_bodies.is_empty()) {
            drawing.strokes.push(leading(&over_bodies, halo, 3.0 * width));
        }
        drawing.strokes.push(leading(&taken.leaders, color, width));
    }
}

/// The areas that a text should avoid.
struct Taken {
    picture: DVec2,
    /// Marks, and the heads of arrows.
    marks: Vec<Box2>,
    /// Texts, and the reserved area.
    texts: Vec<Box2>,
    /// The lines from texts to their points.
    leaders: Vec<[DVec2; 2]>,
    /// The part of `lines` that a place of the present text may meet.
    near: Vec<([DVec2; 2], f64)>,
    /// Other lines, and the cost of covering a part of them as long as a letter is high.
    lines: Vec<([DVec2; 2], f64)>,
    solids: Solids,
}

impl Taken {
    fn of(drawing: &Drawing, rules: &Rules<'_>) -> Self {
        Self {
            picture: DVec2::new(f64::from(drawing.width), f64::from(drawing.height)),
            marks: marked(drawing),
            texts: rules.reserved.into_iter().collect(),
            leaders: Vec::new(),
            near: Vec::new(),
            lines: lines(&drawing.strokes),
            solids: Solids::of(drawing),
        }
    }

    /// Puts a text where its author wants it, with a line to its point if it's far from it.
    fn put(&mut self, mut label: Label, by: DVec2, page: &Box2) -> Label {
        /// The distance from the border of a text's box to its point from which on a line leads there, in heights of
        /// its type.
        const NEAR: f64 = 1.0;
        let (at, em) = (point(label.position), f64::from(label.size));
        let place = put(&mut label, by, page);
        let apart = (((place.center - at).abs() - place.half).max(DVec2::ZERO)).length();
        let candidate = LabelSpot { place, at, em, dislike: 0.0, leads: apart > NEAR * em };
        self.leaders.extend(candidate.leader());
        self.texts.push(place);
        label
    }

    /// Prepares for a text, because there are thousands of lines in a picture, and few near its places.
    fn come_near(&mut self, label: &Label) {
        let (at, half) = (point(label.position), half_size(label));
        let far = f64::from(label.size) * FARTHEST + f64::from(label.offset[0]).hypot(f64::from(label.offset[1]));
        let around = Box2 { center: at, half: 2.0 * half + (half.x + half.y + far) };
        self.near.clear();
        self.near.extend(self.lines.iter().filter(|([p, q], _)| {
            let middle = 0.5 * (*p + *q);
            around.overlaps(&Box2 { center: middle, half: (*q - middle).abs() })
        }));
    }

    /// True if a line runs over a body, judged at a few places of it.
    fn meets_body(&self, [from, to]: [DVec2; 2]) -> bool {
        const PLACES: u32 = 8;
        let at = |k: u32| from.lerp(to, f64::from(k) / f64::from(PLACES));
        (0..=PLACES).any(|k| self.covered(&Box2 { center: at(k), half: DVec2::splat(1.0) }) > 0.5)
    }

    /// The share of a place that bodies cover.
    fn covered(&self, place: &Box2) -> f64 {
        self.solids.share(place.center, place.half)
    }

    /// The cost of a place. Infinite if a text must not be there, or if it costs `most` or more.
    fn cost(&self, candidate: &LabelSpot, most: f64) -> f64 {
        /// Standing entirely in front of a body. Less than standing far off with a line.
        const BEFORE_A_BODY: f64 = 9.0;
        /// Smallest distance between texts, in ems.
        const APART: f64 = 0.18;
        let LabelSpot { place: b, em, .. } = *candidate;
        let (low, high) = (b.center - b.half, b.center + b.half);
        if most <= 0.0 || low.min_element() < 0.0 || (high - self.picture).max_element() > 0.0 {
            return f64::INFINITY;
        }
        let roomy = Box2 { half: b.half + APART * em, ..b };
        let leader = candidate.leader();
        let hides =
            |text: &Box2| roomy.overlap(text) > 0.0 || leader.is_some_and(|[p, q]| text.length_inside(p, q) > 0.0);
        if self.texts.iter().any(hides) || self.leaders.iter().any(|[p, q]| b.length_inside(*p, *q) > 0.0) {
            return f64::INFINITY;
        }
        let mut sum = 0.0;
        for mark in &self.marks {
            let overlap = b.overlap(mark);
            if overlap > 0.02 * em * em {
                sum += COVERS;
            }
            sum += 8.0 * overlap / (em * em);
        }
        let before_a_body = BEFORE_A_BODY * self.covered(&b);
        if sum + before_a_body >= most {
            return f64::INFINITY;
        }
        let mut crossed = 0.0;
        for ([p, q], weight) in &self.near {
            crossed += weight * b.length_inside(*p, *q);
            if crossed / em >= most {
                return f64::INFINITY;
            }
        }
        sum + crossed / em + before_a_body
    }
}

/// From this cost on, a text covers a mark or the head of an arrow.
const COVERS: f64 = 40.0;

/// The lines from texts to their points, over everything.
fn leading(ends: &[[DVec2; 2]], color: Rgba, width: f32) -> StrokeSet {
    let ends: Vec<_> = ends.iter().map(|ends| ends.map(|p| [single(p.x), single(p.y), 1.0])).collect();
    StrokeSet::pairs(&ends, LineStyle::solid(color, width, HiddenLines::Shown))
}

/// A place for a label.
#[derive(Clone, Copy, Debug)]
struct LabelSpot {
    place: Box2,
    /// The label's point.
    at: DVec2,
    /// The height of its type.
    em: f64,
    dislike: f64,
    /// True if it's so far from its point that a line must lead there.
    leads: bool,
}

impl LabelSpot {
    /// The line from the border of the text's box towards its point, if there must be one.
    fn leader(&self) -> Option<[DVec2; 2]> {
        let offset = self.place.center - self.at;
        let share = (self.place.half / offset.abs()).min_element().min(1.0);
        let stop = self.at + offset.normalize_or_zero() * (0.25 * self.em);
        self.leads.then_some([self.place.center - offset * share, stop])
    }
}

/// Greatest distance of a text, in heights of its type.
const FARTHEST: f64 = 6.0;

/// Places around a label's point and the dislike for each. Farther ones are included if a line may lead to the point,
/// which is harder to see on a body.
fn candidates(label: &Label, leaders: bool, on_a_body: bool) -> impl Iterator<Item = LabelSpot> + use<> {
    let half = half_size(label);
    let offset = DVec2::new(f64::from(label.offset[0]), f64::from(label.offset[1]));
    let (direction, gap) = (offset.normalize_or(DVec2::X), offset.length());
    let (at, em) = (point(label.position), f64::from(label.size));
    let angles = [0.0_f64, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 110.0, -110.0, 145.0, -145.0, 180.0];
    let gaps =
        [(0.0, false), (0.5, false), (1.0, true), (1.6, true), (2.4, true), (3.4, true), (4.6, true), (FARTHEST, true)];
    gaps.into_iter().filter(move |(_, leads)| leaders || !leads).flat_map(move |(more, leads)| {
        angles.into_iter().map(move |angle| {
            let d = DVec2::from_angle(angle.to_radians()).rotate(direction);
            let reach = gap + more * em + (d.abs() * half).element_sum();
            // On the other side of its point and not close to it, a text would seem to name something else.
            let dislike = angle.abs() / 90.0 + if more > 1.0 { 2.5 + more } else { 1.5 * more };
            let is_aside = angle.abs() > 80.0;
            let leads = leads || leaders && is_aside && (more > 0.0 || on_a_body);
            LabelSpot { place: Box2 { center: at + d * reach, half }, at, em, dislike, leads }
        })
    })
}

/// Half the width and height in pixels of a text around its middle, its halo included.
pub(in crate::views) fn half_size(label: &Label) -> DVec2 {
    half_size_of(&label.text, label.size, label.mathematical)
}

/// Like [`half_size`], for a text.
pub(in crate::views) fn half_size_of(text: &str, size: f32, mathematical: bool) -> DVec2 {
    /// The part of the halo that should stay free, in ems.
    const HALO: f64 = 0.08;
    let extent = measure(text, size, mathematical);
    // A label's point is at half the height of an x.
    let middle = 0.5 * x_height(size);
    let half = DVec2::new(f64::from(0.5 * extent.width), f64::from((extent.above - middle).max(extent.below + middle)));
    half + HALO * f64::from(size)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Surface;
    use crate::figure::StyledLabel;

    const RULES: Rules<'_> = Rules { reserved: None, leader: None, author: None };

    fn label(x: f32, y: f32, text: &str) -> Label {
        Label {
            name: text.to_owned(),
            offset: [6.0, 0.0],
            ..Label::new([x, y, 0.5], text, 14.0, [Rgba::rgb(0, 0, 0), Rgba::rgb(255, 255, 255)])
        }
    }

    fn drawing(labels: Vec<Label>) -> Drawing {
        Drawing { labels, ..Drawing::new(200, 100, Rgba::rgb(255, 255, 255)) }
    }

    fn boxes(d: &Drawing) -> Vec<Box2> {
        let at = |l: &Label| point(l.position) + DVec2::new(f64::from(l.offset[0]), f64::from(l.offset[1]));
        d.labels.iter().map(|l| Box2 { center: at(l), half: half_size(l) }).collect()
    }

    #[test]
    fn a_lone_text_stands_where_it_wishes() {
        let mut d = drawing(vec![label(50.0, 50.0, "PF")]);
        settle(&mut d, &RULES);
        let b = boxes(&d)[0];
        assert!((b.center.y - 50.0).abs() < 1e-3);
        assert!((b.center.x - b.half.x - 56.0).abs() < 1e-3, "its left end is 6 px to the right of its point");
    }

    #[test]
    fn texts_at_one_point_do_not_cover_each_other_and_the_last_gives_way() {
        let mut d = drawing((0..60).map(|_| label(50.0, 50.0, "window")).collect());
        settle(&mut d, &RULES);
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
        settle(&mut d, &RULES);
        assert_eq!(d.labels.len(), 4);
        for b in boxes(&d) {
            assert!((b.center - b.half).min_element() >= -1e-3);
            assert!((b.center + b.half - DVec2::new(200.0, 100.0)).max_element() <= 1e-3);
        }
    }

    #[test]
    fn a_text_steps_off_a_line_in_the_colour_of_the_grid_but_not_off_the_grid() {
        let style = LineStyle::solid(Rgba::rgb(10, 20, 30), 1.0, HiddenLines::default());
        let line = StrokeSet::line(vec![[0.0, 50.0, 0.5], [200.0, 50.0, 0.5]], style);
        let mut d = drawing(vec![label(50.0, 50.0, "PF")]);
        let mut over_grid = d.clone();
        over_grid.strokes.push(StrokeSet { role: Role::Ground, ..line.clone() });
        d.strokes.push(line);
        settle(&mut d, &RULES);
        settle(&mut over_grid, &RULES);
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

    #[test]
    fn the_first_label_has_the_choice_and_others_get_a_leader_line() {
        let points = (0..6_u8).map(|i| label(122.0, 10.0 + 16.0 * f32::from(i), "P"));
        let c = Label { role: Role::Center, ..label(170.0, 50.0, "C") };
        let mut d = drawing(points.chain([c]).collect());
        d.surfaces.push(body());
        let color = Rgba::rgb(1, 2, 3);
        settle(&mut d, &Rules { leader: Some((color, 1.0)), ..RULES });
        let all = boxes(&d);
        assert_eq!(d.labels[0].text, "C");
        assert!((all[0].center.y - 50.0).abs() < 1e-3 && all[0].center.x > 170.0, "where it wishes");
        let lines = &d.strokes[d.strokes.len() - 1];
        assert_eq!(lines.style.color, color);
        assert!(!lines.polylines.is_empty() && lines.polylines.len() < d.labels.len());
        for range in &lines.polylines {
            let [from, to] = [range.start, range.start + 1].map(|i| point(lines.points[i as usize]));
            assert!(d.labels.iter().any(|l| to.distance(point(l.position)) < 5.0), "ends at a point: {to}");
            assert!(all.iter().any(|b| b.length_inside(from, from + (from - to) * 1e-3) > 0.0), "begins at a text");
        }
    }

    #[test]
    fn a_text_covers_no_mark_and_no_head_of_an_arrow() {
        let color = Rgba::rgb(10, 20, 30);
        let style = LineStyle { color, width: 2.0, dash: Default::default(), hidden: Default::default(), arrow: true };
        let mut d = drawing(vec![label(50.0, 50.0, "PF")]);
        d.strokes.push(StrokeSet::line(vec![[65.0, 90.0, 0.5], [65.0, 50.0, 0.5]], style));
        settle(&mut d, &RULES);
        assert!(marked(&d).iter().all(|head| head.overlap(&boxes(&d)[0]) < 4.0));
    }

    /// A body that fills all but the right 60 px.
    fn body() -> Surface {
        let corners = vec![[0.0, 0.0, 0.5], [140.0, 0.0, 0.5], [140.0, 100.0, 0.5], [0.0, 100.0, 0.5]];
        Surface::solid(corners, vec![[0, 1, 2], [0, 2, 3]], Rgba::rgb(90, 90, 90))
    }

    #[test]
    fn a_text_stands_beside_a_body_with_a_line_to_its_point_on_it() {
        let mut d = drawing(vec![label(110.0, 50.0, "PF")]);
        d.labels[0].offset = [-6.0, 0.0];
        d.surfaces.push(body());
        settle(&mut d, &Rules { leader: Some((Rgba::rgb(1, 2, 3), 1.0)), ..RULES });
        let b = boxes(&d)[0];
        assert!(b.center.x - b.half.x >= 139.0, "{b:?}");
        let [halo, line] = d.strokes.as_slice() else { panic!("{} sets", d.strokes.len()) };
        assert_eq!((halo.polylines.len(), halo.style.color), (1, d.labels[0].halo), "a dark body hides no line");
        assert!(halo.style.width > 2.0 * line.style.width && halo.points == line.points);
    }

    #[test]
    fn a_recoloured_label_stays_where_it_was() {
        let soft = Rgba::rgb(120, 120, 120);
        let red = Rgba::rgb(255, 0, 0);
        let settled = |styled: Vec<StyledLabel>| {
            let labels = Labels { styled, ..Labels::default() };
            let leader = (soft, 1.0);
            let author = Some(Author { labels: &labels, view: View::World, leader, page: None, least: 0.0 });
            // Crowded, over a body, and one of them stands beside bodies.
            let mut d = drawing(["C", "PF", "near", "far"].map(|name| label(40.0, 50.0, name)).to_vec());
            d.labels[2].role = Role::Aside;
            d.surfaces.push(body());
            settle(&mut d, &Rules { author, ..RULES });
            d.labels
        };
        let before = settled(Vec::new());
        for name in ["C", "PF", "near", "far"] {
            let mut after = settled(vec![StyledLabel { name: name.to_owned(), size: None, color: Some(red) }]);
            for (now, was) in after.iter_mut().zip(&before) {
                assert_eq!(now.color, if now.name == name { red } else { was.color });
                now.color = was.color;
            }
            assert_eq!(after, before, "{name}");
        }
    }

    #[test]
    fn a_text_beside_bodies_is_left_out_if_there_is_no_other_place() {
        let with = |role| Label { role, ..label(40.0, 50.0, "(1, 1, 1)") };
        let mut d = drawing(vec![with(Role::Aside), with(Role::Content)]);
        d.surfaces.push(body());
        settle(&mut d, &RULES);
        assert_eq!(d.labels.iter().map(|l| l.role).collect::<Vec<_>>(), [Role::Content]);
    }

    #[test]
    fn a_line_to_a_point_crosses_no_text() {
        let points = (0..14_u8).map(|i| label(96.0 + 26.0 * f32::from(i % 2), 5.0 + 7.0 * f32::from(i), "P"));
        let mut d = drawing(points.collect());
        d.surfaces.push(body());
        settle(&mut d, &Rules { leader: Some((Rgba::rgb(1, 2, 3), 1.0)), ..RULES });
        let all = boxes(&d);
        let leaders = &d.strokes[d.strokes.len() - 1];
        assert!(leaders.polylines.len() > 5);
        for range in &leaders.polylines {
            let [from, to] = [range.start, range.start + 1].map(|i| point(leaders.points[i as usize]));
            let crossed = all.iter().filter(|b| b.length_inside(from, to) > 1e-3).count();
            assert_eq!(crossed, 0);
        }
    }
}
