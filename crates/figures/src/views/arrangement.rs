//! Arrangements of several pictures, on a screen or on a sheet.

use super::View;
use crate::camera::ImageSize;
pub use crate::figure::Arrangement;

/// The default share of the first of three pictures. The two others share the rest equally.
pub const fn share_of_first(arrangement: Arrangement) -> f32 {
    match arrangement {
        Arrangement::Row | Arrangement::Column => 1.0 / 3.0,
        Arrangement::Above => 0.54,
        Arrangement::Beside => 0.56,
    }
}

/// The arrangement in which `count` pictures use most of the space. If two are about as good, it's the first one.
/// `used` is the area that they use, in any unit.
pub fn best_arrangement(count: usize, used: impl Fn(Arrangement) -> f32) -> Arrangement {
    let candidates: &[Arrangement] = if count < 3 {
        &[Arrangement::Column]
    } else {
        &[Arrangement::Above, Arrangement::Beside, Arrangement::Column]
    };
    let better = |best, next: &Arrangement| if used(*next) > 1.05 * used(best) { *next } else { best };
    candidates.iter().fold(Arrangement::Row, better)
}

/// Width by height of a picture's content. The aspect of very long images is limited, because their place can't follow
/// it.
pub fn aspect_shown(view: View, image: ImageSize) -> f32 {
    match view {
        View::World => 4.0 / 3.0,
        View::Canonical => 1.1,
        #[expect(clippy::cast_possible_truncation, reason = "0.5 … 2")]
        View::Image => image.aspect().clamp(0.5, 2.0) as f32,
    }
}

/// The area of the largest picture of a shape (width by height) in a space.
pub fn used_area(width: f32, height: f32, aspect: f32) -> f32 {
    let width = width.min(height * aspect);
    width * width / aspect
}
