//! Steps, signs and the slider that is held.

use crate::camera::{Camera, Convention, Freedom, OPERATIONS};
use crate::gui::motion::Motion;

/// What the panel of operations remembers from one frame to the next.
#[derive(Clone, Debug)]
pub struct Operations {
    /// What a button does: degrees, factor or scene units, in the order of [`OPERATIONS`].
    pub steps: [f64; OPERATIONS.len()],
    /// Whose signs.
    pub convention: Convention,
    pub(in crate::gui) scrub: Option<Scrub>,
    /// A step that is on its way.
    pub(in crate::gui) motion: Option<Motion>,
}

/// A slider that is being held.
#[derive(Clone, Debug)]
pub(in crate::gui) struct Scrub {
    pub(in crate::gui) freedom: Freedom,
    /// The camera when it was taken.
    pub(in crate::gui) start: Camera,
    /// How far it has been pulled.
    pub(in crate::gui) amount: f64,
}

impl Default for Operations {
    fn default() -> Self {
        Self {
            steps: OPERATIONS.map(|descriptor| descriptor.step),
            convention: Convention::default(),
            scrub: None,
            motion: None,
        }
    }
}
