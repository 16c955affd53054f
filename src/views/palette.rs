//! The colours of the pictures, one set for each theme.

use crate::appearance::{Rgba, Theme};

/// The colours of one theme. Hues are those of Okabe and Ito, which red-green blind people tell apart; letters, dashes and
/// shapes say the same once more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// Ground of the three pictures.
    pub paper: Rgba,
    /// Ground around the image where its aspect leaves room.
    pub surround: Rgba,
    /// Texts and strong lines.
    pub ink: Rgba,
}

impl Palette {
    /// The colours of a theme.
    #[must_use]
    pub fn of(theme: Theme) -> Self {
        match theme {
            Theme::Light => Self {
                paper: Rgba::rgb(0xfa, 0xfb, 0xfc),
                surround: Rgba::rgb(0xe4, 0xe7, 0xeb),
                ink: Rgba::rgb(0x1c, 0x21, 0x28),
            },
            Theme::Dark => Self {
                paper: Rgba::rgb(0x16, 0x1a, 0x20),
                surround: Rgba::rgb(0x0b, 0x0d, 0x10),
                ink: Rgba::rgb(0xe9, 0xec, 0xef),
            },
            Theme::Print => Self {
                paper: Rgba::rgb(0xff, 0xff, 0xff),
                surround: Rgba::rgb(0xff, 0xff, 0xff),
                ink: Rgba::rgb(0x00, 0x00, 0x00),
            },
        }
    }
}
