//! Where the pictures lie in the room they have: side by side where each is wide enough, otherwise so that they are large.

use eframe::egui::{Pos2, Rect, Vec2, vec2};

use crate::gui::state::Arrangement;
use crate::views::View;

/// Room between two pictures, in points: the bar that is dragged.
pub(super) const GAP: f32 = 5.0;

/// Three pictures stand side by side where each gets this width, in points.
const SIDE_BY_SIDE: f32 = 360.0;

/// The share of the room that a picture keeps when a bar is dragged.
const LEAST_SHARE: f32 = 0.15;

/// Which way a bar moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    /// The bar stands, and moves to the left and to the right.
    X,
    /// The bar lies, and moves up and down.
    Y,
}

/// A bar between pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bar {
    /// Where it is.
    pub(super) rect: Rect,
    /// Which way it moves.
    pub(super) axis: Axis,
    /// What it divides.
    span: Rect,
    /// Its place in [`Shares`].
    index: (usize, usize),
}

/// The user's proportions, for each arrangement and number of pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shares([[f32; 2]; 8]);

impl Default for Shares {
    fn default() -> Self {
        let thirds = [1.0 / 3.0, 0.5];
        let halves = [0.5, 0.5];
        Self([halves, halves, halves, halves, thirds, thirds, [0.54, 0.5], [0.56, 0.5]])
    }
}

impl Shares {
    fn place(arrangement: Arrangement, count: usize) -> usize {
        let kind = match arrangement {
            Arrangement::Row => 0,
            Arrangement::Column => 1,
            Arrangement::Above => 2,
            Arrangement::Beside => 3,
        };
        kind + if count == 3 { 4 } else { 0 }
    }

    /// Moves a bar to the pointer.
    pub(super) fn drag(&mut self, bar: &Bar, pointer: Pos2) {
        let share = match bar.axis {
            Axis::X => (pointer.x - bar.span.left()) / bar.span.width(),
            Axis::Y => (pointer.y - bar.span.top()) / bar.span.height(),
        };
        if share.is_finite() {
            self.0[bar.index.0][bar.index.1] = share.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
        }
    }

    /// Puts a bar back where it was at first.
    pub(super) fn reset(&mut self, bar: &Bar) {
        self.0[bar.index.0][bar.index.1] = Self::default().0[bar.index.0][bar.index.1];
    }
}

/// The pictures' places and the bars between them.
pub(super) fn arrange(
    room: Rect,
    pictures: &[View],
    wanted: Option<Arrangement>,
    shares: &Shares,
) -> (Vec<(View, Rect)>, Vec<Bar>) {
    let arrangement = match (wanted, pictures.len()) {
        (None, count) => best(room.size(), count),
        (Some(Arrangement::Above), 0..=2) => Arrangement::Column,
        (Some(Arrangement::Beside), 0..=2) => Arrangement::Row,
        (Some(wanted), _) => wanted,
    };
    let place = Shares::place(arrangement, pictures.len());
    let [first, second] = shares.0[place];
    let cut = |span, axis, level, share| divide(span, axis, share, (place, level));
    match *pictures {
        [] => (Vec::new(), Vec::new()),
        [only] => (vec![(only, room)], Vec::new()),
        [a, b] => {
            let axis = if arrangement == Arrangement::Row { Axis::X } else { Axis::Y };
            let (ra, bar, rb) = cut(room, axis, 0, first);
            (vec![(a, ra), (b, rb)], vec![bar])
        }
        [a, b, c, ..] => {
            let (outer, inner) = match arrangement {
                Arrangement::Row => (Axis::X, Axis::X),
                Arrangement::Column => (Axis::Y, Axis::Y),
                Arrangement::Above => (Axis::Y, Axis::X),
                Arrangement::Beside => (Axis::X, Axis::Y),
            };
            let (ra, bar, rest) = cut(room, outer, 0, first);
            let (rb, bar_of_rest, rc) = cut(rest, inner, 1, second);
            (vec![(a, ra), (b, rb), (c, rc)], vec![bar, bar_of_rest])
        }
    }
}

/// The arrangement for so many pictures in a room.
pub(super) fn best(room: Vec2, count: usize) -> Arrangement {
    use Arrangement::{Above, Beside, Column, Row};
    if count < 3 {
        return if largest(room * vec2(0.5, 1.0)) >= largest(room * vec2(1.0, 0.5)) { Row } else { Column };
    }
    if room.x >= 3.0 * SIDE_BY_SIDE + 2.0 * GAP {
        return Row;
    }
    // The smallest of the three pictures decides; where it is about as large, the arrangement that is named first.
    let smallest = |arrangement| match arrangement {
        Row => largest(room * vec2(1.0 / 3.0, 1.0)),
        Column => largest(room * vec2(1.0, 1.0 / 3.0)),
        Above => largest(room * 0.5),
        Beside => largest(room * vec2(0.44, 0.5)),
    };
    [Above, Beside, Column].into_iter().fold(
        Row,
        |best, next| {
            if smallest(next) > 1.1 * smallest(best) { next } else { best }
        },
    )
}

/// The height of the largest 4:3 picture in a room.
fn largest(room: Vec2) -> f32 {
    (room.x * 0.75).min(room.y - 24.0)
}

fn divide(span: Rect, axis: Axis, share: f32, index: (usize, usize)) -> (Rect, Bar, Rect) {
    let (mut a, mut rect, mut b) = (span, span, span);
    match axis {
        Axis::X => {
            let middle = span.left() + (span.width() * share).round();
            (*a.right_mut(), *b.left_mut()) = (middle - GAP / 2.0, middle + GAP / 2.0);
            (*rect.left_mut(), *rect.right_mut()) = (a.right(), b.left());
        }
        Axis::Y => {
            let middle = span.top() + (span.height() * share).round();
            (*a.bottom_mut(), *b.top_mut()) = (middle - GAP / 2.0, middle + GAP / 2.0);
            (*rect.top_mut(), *rect.bottom_mut()) = (a.bottom(), b.top());
        }
    }
    (a, Bar { rect, axis, span, index }, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::pos2;

    fn room(width: f32, height: f32) -> Rect {
        Rect::from_min_size(pos2(10.0, 20.0), vec2(width, height))
    }

    #[test]
    fn wide_rooms_have_the_pictures_side_by_side_and_narrow_ones_do_not() {
        assert_eq!(best(vec2(1320.0, 950.0), 3), Arrangement::Row);
        assert_eq!(best(vec2(700.0, 600.0), 3), Arrangement::Above);
        assert_eq!(best(vec2(240.0, 800.0), 3), Arrangement::Column);
        assert_eq!(best(vec2(1000.0, 200.0), 3), Arrangement::Row);
    }

    #[test]
    fn pictures_fill_the_room_without_overlap() {
        for size in [(1320.0, 950.0), (700.0, 600.0), (240.0, 800.0), (600.0, 240.0)] {
            let wanted_ones = [None].into_iter().chain(Arrangement::ALL.map(Some));
            for (count, wanted) in wanted_ones.flat_map(|wanted| [1, 2, 3].map(|count| (count, wanted))) {
                let room = room(size.0, size.1);
                let (panes, bars) = arrange(room, &View::ALL[..count], wanted, &Shares::default());
                assert_eq!((panes.len(), bars.len()), (count, count - 1));
                let mut area = bars.iter().map(|b| b.rect.area()).sum::<f32>();
                for (i, (_, rect)) in panes.iter().enumerate() {
                    assert!(room.contains_rect(*rect) && rect.is_positive());
                    area += rect.area();
                    for (_, other) in &panes[..i] {
                        assert!(rect.intersect(*other).area() <= 0.0 || !rect.intersect(*other).is_positive());
                    }
                }
                assert!((area - room.area()).abs() < 1.0, "{area} of {}", room.area());
            }
        }
    }

    #[test]
    fn a_bar_follows_the_pointer_and_stops_before_a_picture_vanishes() {
        let room = room(1320.0, 950.0);
        let mut shares = Shares::default();
        let (_, bars) = arrange(room, &View::ALL, None, &shares);
        shares.drag(&bars[0], pos2(10.0 + 660.0, 100.0));
        let (panes, bars) = arrange(room, &View::ALL, None, &shares);
        assert_eq!(panes[0].1.right(), 10.0 + 660.0 - GAP / 2.0);
        shares.drag(&bars[0], pos2(-500.0, 100.0));
        let (panes, bars) = arrange(room, &View::ALL, None, &shares);
        assert!(panes[0].1.width() > 190.0);
        shares.reset(&bars[0]);
        assert_eq!(shares, Shares::default());
    }
}
