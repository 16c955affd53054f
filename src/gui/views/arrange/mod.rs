//! The layout of the pictures in their space: the one that uses most of it, or the user's.

pub(super) mod auto_observer;
pub(super) mod observers;
pub(super) mod orbit;
pub(super) mod title;

use eframe::egui::{Pos2, Rect, Vec2, vec2};

use crate::views::{Arrangement, best_arrangement, share_of_first, used_area};

/// Room between two pictures, in points, for the bar that the user drags.
pub(super) const GAP: f32 = 5.0;

/// About the height of a title, in points.
const TITLE: f32 = 26.0;

/// The share of the room that a picture keeps when a bar is dragged.
const LEAST_SHARE: f32 = 0.15;

/// The direction in which a bar moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    /// The bar is vertical, and moves to the left and to the right.
    X,
    /// The bar lies, and moves up and down.
    Y,
}

/// A bar between pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bar {
    /// Its place.
    pub(super) rect: Rect,
    /// The direction in which it moves.
    pub(super) axis: Axis,
    /// The area that it divides.
    span: Rect,
    /// Its place in [`Shares`].
    index: (usize, usize),
}

/// The user's proportions, for each arrangement and number of pictures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shares([[f32; 2]; 8]);

impl Default for Shares {
    fn default() -> Self {
        let mut shares = [[0.5, 0.5]; 8];
        for arrangement in Arrangement::ALL {
            shares[Self::place(arrangement, 3)][0] = share_of_first(arrangement);
        }
        Self(shares)
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

    /// Puts a bar back to its original place.
    pub(super) fn reset(&mut self, bar: &Bar) {
        self.0[bar.index.0][bar.index.1] = Self::default().0[bar.index.0][bar.index.1];
    }
}

/// A picture to lay out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Framed {
    /// Its place among the pictures of the shot.
    pub(super) picture: usize,
    /// Width by height of its picture.
    pub(super) aspect: f32,
}

/// The arrangement of `pictures` in a window of this size, in points. In it they use most of the room, next to as many
/// panels as a window of this size has at first. It depends on nothing else. So a panel that opens, a bar or a strip
/// below doesn't move the pictures to other places, and a window that is made small and large again looks as before.
pub(super) fn automatic(window: Vec2, panels: usize, pictures: &[Framed]) -> Arrangement {
    /// The initial width of a panel, and height of the lines above and below.
    const PANEL: f32 = 280.0;
    const LINES: f32 = 70.0;
    #[expect(clippy::cast_precision_loss, reason = "at most two")]
    let panels = panels as f32 * PANEL;
    let room = (window - vec2(panels, LINES)).max(Vec2::splat(1.0));
    best(Rect::from_min_size(Pos2::ZERO, room), pictures)
}

/// The pictures' places and the bars between them.
pub(super) fn arrange(
    room: Rect,
    pictures: &[Framed],
    wanted: Arrangement,
    shares: &Shares,
) -> (Vec<(usize, Rect)>, Vec<Bar>) {
    let arrangement = match (wanted, pictures.len()) {
        (Arrangement::Above, 0..=2) => Arrangement::Column,
        (Arrangement::Beside, 0..=2) => Arrangement::Row,
        (wanted, _) => wanted,
    };
    let (rects, bars) = lay_out(room, pictures.len(), arrangement, shares);
    (pictures.iter().map(|framed| framed.picture).zip(rects).collect(), bars)
}

/// The places of `count` pictures.
fn lay_out(room: Rect, count: usize, arrangement: Arrangement, shares: &Shares) -> (Vec<Rect>, Vec<Bar>) {
    let place = Shares::place(arrangement, count);
    let [first, second] = shares.0[place];
    let cut = |span, axis, level, share| divide(span, axis, share, (place, level));
    match count {
        0 => (Vec::new(), Vec::new()),
        1 => (vec![room], Vec::new()),
        2 => {
            let axis = if arrangement == Arrangement::Row { Axis::X } else { Axis::Y };
            let (a, bar, b) = cut(room, axis, 0, first);
            (vec![a, b], vec![bar])
        }
        _ => {
            let (outer, inner) = match arrangement {
                Arrangement::Row => (Axis::X, Axis::X),
                Arrangement::Column => (Axis::Y, Axis::Y),
                Arrangement::Above => (Axis::Y, Axis::X),
                Arrangement::Beside => (Axis::X, Axis::Y),
            };
            let (a, bar, rest) = cut(room, outer, 0, first);
            let (b, bar_of_rest, c) = cut(rest, inner, 1, second);
            (vec![a, b, c], vec![bar, bar_of_rest])
        }
    }
}

/// The arrangement in which the pictures use most of a room.
fn best(room: Rect, pictures: &[Framed]) -> Arrangement {
    best_arrangement(pictures.len(), |arrangement| used(room, pictures, arrangement))
}

/// The area that pictures use of a room in an arrangement. Points².
fn used(room: Rect, pictures: &[Framed], arrangement: Arrangement) -> f32 {
    let (panes, _) = lay_out(room, pictures.len(), arrangement, &Shares::default());
    pictures.iter().zip(panes).map(|(picture, pane)| used_of(pane.size(), picture.aspect)).sum()
}

/// The area of the largest picture of a shape (width by height) in a pane, below its title. Points².
fn used_of(pane: Vec2, aspect: f32) -> f32 {
    let room = vec2(pane.x, pane.y - TITLE).max(Vec2::ZERO);
    used_area(room.x, room.y, aspect)
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
    use eframe::egui::pos2;

    use super::*;

    fn room(width: f32, height: f32) -> Rect {
        Rect::from_min_size(pos2(10.0, 20.0), vec2(width, height))
    }

    fn framed(count: usize) -> Vec<Framed> {
        (0..count).map(|picture| Framed { picture, aspect: 4.0 / 3.0 }).collect()
    }

    #[test]
    fn the_arrangement_is_that_in_which_pictures_use_most_of_the_room() {
        let of = |width, height| best(room(width, height), &framed(3));
        // The room beside both panels on screens of 1920 × 1080 and 3840 × 2160, and of the first window.
        assert_eq!(of(1364.0, 1000.0), Arrangement::Beside);
        assert_eq!(of(3284.0, 2080.0), Arrangement::Beside);
        assert_eq!(of(684.0, 555.0), Arrangement::Above);
        assert_eq!(of(1364.0, 330.0), Arrangement::Row);
        assert_eq!(of(240.0, 800.0), Arrangement::Column);
        // Two pictures, and pictures that aren't 4 by 3.
        let two = |width, height, aspect| {
            let wide: Vec<Framed> = framed(2).into_iter().map(|picture| Framed { aspect, ..picture }).collect();
            best(room(width, height), &wide)
        };
        assert_eq!((two(800.0, 600.0, 0.5), two(800.0, 600.0, 3.0)), (Arrangement::Row, Arrangement::Column));
    }

    #[test]
    fn the_window_alone_decides_on_the_arrangement() {
        let of = |width, height, panels, count| automatic(vec2(width, height), panels, &framed(count));
        assert_eq!(of(1920.0, 1061.0, 2, 3), Arrangement::Beside);
        assert_eq!(of(1240.0, 650.0, 2, 3), Arrangement::Above);
        assert_eq!(of(1280.0, 720.0, 2, 3), Arrangement::Above);
        assert_eq!(of(1024.0, 560.0, 2, 2), Arrangement::Column);
        assert_eq!(of(1920.0, 1061.0, 2, 2), Arrangement::Row);
        // A presentation has no panels.
        assert_eq!(of(1280.0, 720.0, 0, 2), Arrangement::Row);
    }

    #[test]
    fn a_picture_fills_a_pane_as_far_as_its_shape_allows() {
        assert_eq!(used_of(vec2(400.0, 300.0 + TITLE), 4.0 / 3.0), 120_000.0);
        assert_eq!(used_of(vec2(400.0, 1000.0), 2.0), 80_000.0);
        assert_eq!(used_of(vec2(1000.0, 100.0 + TITLE), 2.0), 20_000.0);
        assert_eq!(used_of(vec2(1000.0, 10.0), 2.0), 0.0);
        // Three tall strips waste two thirds of a large screen.
        let area = |arrangement| -> f32 {
            let (panes, _) = lay_out(room(1364.0, 1000.0), 3, arrangement, &Shares::default());
            panes.into_iter().map(|pane| used_of(pane.size(), 4.0 / 3.0)).sum()
        };
        assert!(area(Arrangement::Beside) > 2.0 * area(Arrangement::Row));
        assert!(area(Arrangement::Beside) > 0.65 * 1364.0 * 1000.0);
    }

    #[test]
    fn pictures_fill_the_room_without_overlap() {
        for size in [(1320.0, 950.0), (700.0, 600.0), (240.0, 800.0), (600.0, 240.0)] {
            for (count, wanted) in
                Arrangement::ALL.into_iter().flat_map(|wanted| [1, 2, 3].map(|count| (count, wanted)))
            {
                let room = room(size.0, size.1);
                let (panes, bars) = arrange(room, &framed(count), wanted, &Shares::default());
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
        let (_, bars) = arrange(room, &framed(3), Arrangement::Row, &shares);
        shares.drag(&bars[0], pos2(10.0 + 660.0, 100.0));
        let (panes, bars) = arrange(room, &framed(3), Arrangement::Row, &shares);
        assert_eq!(panes[0].1.right(), 10.0 + 660.0 - GAP / 2.0);
        shares.drag(&bars[0], pos2(-500.0, 100.0));
        let (panes, bars) = arrange(room, &framed(3), Arrangement::Row, &shares);
        assert!(panes[0].1.width() > 190.0);
        shares.reset(&bars[0]);
        assert_eq!(shares, Shares::default());
    }
}
