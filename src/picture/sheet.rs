//! One picture, or all three side by side: which size each has, and how far apart they stand.

use crate::figure::Observers;
use crate::limits::MAX_PIXELS;
use crate::views::{Request, Size, View, Views, observer_in};

/// Room between two pictures on a sheet, in pixels at scale 1.
const GAP: f32 = 4.0;

/// What is drawn for `views`, from left to right: `request` for each of them, seen by its observer. All three together are as
/// large as `request` says. `None` where there is no room for three, or where they would have more
/// pixels than any picture.
#[must_use]
pub fn requests(views: Views, request: &Request, observers: &Observers) -> Option<Vec<Request>> {
    let of = |view, width| Request {
        view,
        observer: observer_in(observers, view),
        size: Size { width, ..request.size },
        ..request.clone()
    };
    // Each of the three may be as large as a picture can be; the sheet of them may not be larger.
    if u64::from(request.size.width) * u64::from(request.size.height) > MAX_PIXELS {
        return None;
    }
    Some(match views {
        Views::One(view) => vec![of(view, request.size.width)],
        Views::All => View::ALL.into_iter().zip(widths(request.size)?).map(|(view, width)| of(view, width)).collect(),
    })
}

/// The widths of three pictures side by side; `None` where there is no room for them. What does not divide by three goes to the
/// first ones, a pixel each.
#[must_use]
pub fn widths(sheet: Size) -> Option<[u32; 3]> {
    let room = sheet.width.checked_sub(2 * gap(sheet.scale))?;
    Some([room.div_ceil(3), (room + 1) / 3, room / 3])
}

/// Room between two pictures on a sheet, in pixels.
#[must_use]
pub fn gap(scale: f32) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let gap = (GAP * scale).round().clamp(1.0, 100.0) as u32;
    gap
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_widths_and_two_gaps_are_the_sheet() {
        for (width, scale) in [(200, 1.0), (201, 1.0), (202, 1.0), (9, 1.0), (1000, 2.5)] {
            let size = Size { width, height: 10, scale };
            let Some(widths) = widths(size) else { panic!("{width}") };
            assert_eq!(widths.iter().sum::<u32>() + 2 * gap(scale), width);
            assert!(widths[0] >= widths[1] && widths[1] >= widths[2] && widths[0] - widths[2] <= 1, "{widths:?}");
        }
        assert_eq!(widths(Size { width: 7, height: 10, scale: 1.0 }), None);
    }
}
