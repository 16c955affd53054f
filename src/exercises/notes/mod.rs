//! The exercises of the notes: `[0]` 5.1 to 5.3, `[1]` I to III.

mod camera;
mod pyramid;

pub(super) use pyramid::whole as pyramid_of;

use super::{Entry, Free};

/// In the order of the notes.
pub static ENTRIES: &[Entry] = &[
    Entry { id: "0-5.1", source: "[0] 5.1", is_family: false, make: |seed, _| camera::rays(seed) },
    Entry { id: "0-5.2", source: "[0] 5.2", is_family: false, make: |_, free| camera::zoomed(free) },
    Entry { id: "0-5.3", source: "[0] 5.3", is_family: false, make: |_, _| camera::cube() },
    Entry { id: "1-I", source: "[1] I", is_family: false, make: |_, free| pyramid::vertices(free) },
    Entry { id: "1-II", source: "[1] II", is_family: false, make: |_, free| pyramid::model_and_view(free) },
    Entry { id: "1-III", source: "[1] III", is_family: false, make: |_, free| pyramid::projection(free) },
];

/// A number that the notes leave open, where it was chosen and can be used.
fn chosen(free: &Free, name: &str, otherwise: f64) -> f64 {
    free.get(name).copied().filter(|value| value.is_finite() && *value > 0.0).unwrap_or(otherwise)
}
