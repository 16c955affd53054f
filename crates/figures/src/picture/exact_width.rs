//! Cropped sheets that have exactly the requested width.
//!
//! A crop leaves less than the paper has. So the pictures are drawn larger until their content fills it, with letters
//! as high as before, and the last pixels are background on both sides.

use super::error::PictureError;
use super::{Composite, assembled};
use crate::progress::Progress;

/// The most attempts to fill a paper.
const ROUNDS: usize = 5;
/// Content this close to the width of its paper, in pixels, is close enough. The rest becomes background.
const NEAR: f64 = 2.0;

/// The sheet whose cropped pictures are as wide as `asked`, in pixels, and no higher. `make` gives the sheet whose
/// sides are a multiple of these.
///
/// # Errors
/// The errors of `make` for the sheet itself, and of drawing it.
pub(super) async fn fitted<E: From<PictureError>>(
    asked: [u32; 2],
    make: impl Fn(f64) -> Result<Composite, E>,
    progress: &Progress,
) -> Result<Composite, E> {
    let mut factor = 1.0;
    let mut best = make(factor)?;
    let mut sheet = best.clone();
    for _ in 0..ROUNDS {
        let (pixels, _) = assembled(&sheet, true, progress).await?;
        let rest = [asked[0], asked[1]].map(f64::from);
        let content = [pixels.width(), pixels.height()].map(|side| f64::from(side.max(1)));
        let fit = (rest[0] / content[0]).min(rest[1] / content[1]);
        if fit >= 1.0 {
            best = sheet.clone();
        }
        if fit >= 1.0 && (fit - 1.0) * content[0] < NEAR {
            break;
        }
        // A little less than too much.
        factor *= if fit < 1.0 { fit * (1.0 - 0.5 / rest[0]) } else { fit };
        let Ok(next) = make(factor) else { break };
        sheet = next;
    }
    best.width = Some(asked[0]);
    Ok(best)
}

impl Composite {
    /// The parts of its pictures (left, top, width and height) that a crop keeps, widened so that the sheet has the
    /// requested width.
    pub(super) fn kept(&self, mut parts: Vec<[u32; 4]>) -> Vec<[u32; 4]> {
        let Some(wanted) = self.width else { return parts };
        let width_of = |parts: &[[u32; 4]]| {
            let sizes: Vec<[u32; 2]> = parts.iter().map(|part| [part[2], part[3]]).collect();
            self.layout(&sizes, true).map_or(u32::MAX, |layout| layout.size[0])
        };
        loop {
            let now = width_of(&parts);
            let Some(lack) = wanted.checked_sub(now).filter(|lack| *lack > 0) else { return parts };
            let share = lack.div_ceil(u32::try_from(parts.len()).unwrap_or(1).max(1));
            let wider = |places: std::ops::Range<usize>, by: u32| {
                let mut parts = parts.clone();
                for (place, part) in parts.iter_mut().enumerate().filter(|(place, _)| places.contains(place)) {
                    *part = widened(*part, by, self.requests.get(place).map_or(0, |request| request.size.width));
                }
                parts
            };
            // All pictures by their share or by one column, or else a single one by the share.
            let each = (0..parts.len()).map(|place| wider(place..place + 1, share));
            let all = [wider(0..parts.len(), share), wider(0..parts.len(), 1)];
            let grown = all.into_iter().chain(each).find(|parts| (now + 1..=wanted).contains(&width_of(parts)));
            match grown {
                Some(grown) => parts = grown,
                None => return parts,
            }
        }
    }
}

/// A part of a picture widened by this many columns, as far as the picture has them, half of them on each side.
fn widened([left, top, width, height]: [u32; 4], by: u32, whole: u32) -> [u32; 4] {
    let wide = (width + by).min(whole).max(width);
    let left = left.saturating_sub((wide - width) / 2).min(whole.saturating_sub(wide));
    [left, top, wide, height]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_grows_at_both_sides_within_its_picture() {
        assert_eq!(widened([20, 5, 40, 9], 10, 100), [15, 5, 50, 9]);
        assert_eq!(widened([2, 5, 40, 9], 10, 100), [0, 5, 50, 9]);
        assert_eq!(widened([58, 5, 40, 9], 10, 100), [50, 5, 50, 9]);
        assert_eq!(widened([2, 5, 40, 9], 90, 100), [0, 5, 100, 9]);
    }
}
