//! A camera on its way.

use crate::camera::{Amount, Camera, Convention, Freedom, Operation};

/// A step on its way to its end.
#[derive(Clone, Debug)]
pub(in crate::gui) struct Motion {
    pub(in crate::gui) start: Camera,
    pub(in crate::gui) freedom: Freedom,
    pub(in crate::gui) amount: f64,
    pub(in crate::gui) convention: Convention,
    /// When it began, in seconds; `None` means with the next frame.
    pub(in crate::gui) began: Option<f64>,
}

impl Motion {
    /// The operation up to a share of the way: all of it at 1, exactly.
    pub(in crate::gui) fn at(&self, share: f64) -> Operation {
        self.freedom.by(match self.freedom.descriptor().amount {
            _ if share >= 1.0 => self.amount,
            Amount::Angle | Amount::Length => self.amount * share,
            Amount::Factor => self.amount.powf(share),
        })
    }
}
