//! The exercises of the notes: `[0]` 5.1 to 5.3, `[1]` I to III.

mod camera;
mod pyramid;

pub(super) use pyramid::whole as pyramid_of;

use super::{Entry, Free};
use crate::figure::{Figure, read};

/// In the order of the notes.
pub static ENTRIES: &[Entry] = &[
    Entry::of_notes("0-5.1", "[0] 5.1", 20, |seed, _| camera::rays(seed)),
    Entry::of_notes("0-5.2", "[0] 5.2", 50, |_, free| camera::zoomed(free)),
    Entry::of_notes("0-5.3", "[0] 5.3", 10, |_, _| camera::cube()),
    Entry::of_notes("1-I", "[1] I", 5, |_, free| pyramid::vertices(free)),
    Entry::of_notes("1-II", "[1] II", 20, |_, free| pyramid::model_and_view(free)),
    Entry::of_notes("1-III", "[1] III", 25, |_, free| pyramid::projection(free)),
];

/// The figure of an exercise, which the gallery shows too.
fn figure_of(text: &str) -> Figure {
    read::parse(text).unwrap_or_default()
}

/// A number that the notes leave open, if the answer chose one that can be used.
fn chosen(free: &Free, name: &str, otherwise: f64) -> f64 {
    free.get(name).copied().filter(|value| value.is_finite() && *value > 0.0).unwrap_or(otherwise)
}
