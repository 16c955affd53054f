//! The settings of the window.

use crate::explained::Conventions;
use crate::layout::{Panels, Tab, WindowPlace};

/// State of the window, and not of the figure.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// The language of the interface.
    pub lang: camera_lab_words::Lang,
    /// The zoom of the whole interface, without that of the presentation.
    pub zoom: f32,
    /// Large type and thick strokes, for a projector.
    pub presentation: bool,
    /// The panels at the sides.
    pub panels: Panels,
    /// The tab of the panel on the left.
    pub tab: Tab,
    /// The panels at the sides during a presentation.
    pub presentation_panels: Panels,
    /// A is kept at m / n.
    pub aspect_follows_image: bool,
    /// True if the inverse matrices replace the matrices.
    pub inverse: bool,
    /// True if the proved bounds of the numbers stand below them.
    pub bounds: bool,
    /// The display of matrices, and the convention of NDC.
    pub conventions: Conventions,
    /// Significant digits of the numbers, 2 … 17.
    pub digits: usize,
    /// The ground of the window and of its pictures. The theme that a figure file asks for counts in written pictures.
    pub theme: crate::appearance::Theme,
    /// The theme before that of the strongest contrast.
    pub theme_before: crate::appearance::Theme,
    /// Skip animations.
    pub reduce_motion: bool,
    /// True if the numbers below the operations are unfolded.
    pub numbers_open: bool,
    /// True if the first lesson and the gallery have been offered.
    pub welcomed: bool,
    /// True for the views alone, without menus, as for a figure in another page.
    pub bare: bool,
    /// The place of the window, once it's known. At first, that of the last one.
    pub window: Option<WindowPlace>,
}

impl Settings {
    /// The panels requested now.
    pub fn panels(&self) -> &Panels {
        if self.presentation { &self.presentation_panels } else { &self.panels }
    }

    /// The panels requested now.
    pub fn panels_mut(&mut self) -> &mut Panels {
        if self.presentation { &mut self.presentation_panels } else { &mut self.panels }
    }

    /// The factor of stroke widths and type sizes in the pictures, on top of the pixels per point of the window.
    pub fn stroke_scale(&self) -> f32 {
        match (self.presentation, self.theme) {
            (false, _) => 1.0,
            // For a weak projector.
            (true, crate::appearance::Theme::Print) => 1.7,
            (true, _) => 1.5,
        }
    }
}
