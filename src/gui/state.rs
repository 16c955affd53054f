//! What the panels and the pictures share.

use crate::camera::CameraError;
use crate::i18n::Lang;
use crate::views::{Ghost, Probe};

use super::Start;
use super::document::Document;

/// One of the three pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Picture {
    /// The scene, the camera and its view volume.
    World,
    /// The canonical volume.
    Canonical,
    /// What the camera sees.
    Image,
}

impl Picture {
    /// All, from left to right.
    pub const ALL: [Self; 3] = [Self::World, Self::Canonical, Self::Image];
}

/// From where a three-dimensional picture is to be seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Look {
    /// From +z.
    Front,
    /// From +y.
    Top,
    /// From +x.
    Side,
    /// From a corner.
    Iso,
    /// As now, but with everything in the picture.
    Fit,
}

/// Which pictures are shown, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// False: the picture is hidden and not drawn. In the order of [`Picture::ALL`]; at least one is true.
    pub shown: [bool; 3],
    /// The picture that has all the room, whatever `shown` says.
    pub maximized: Option<Picture>,
    /// Orbiting one three-dimensional picture turns the other too.
    pub linked: bool,
}

impl Default for Layout {
    fn default() -> Self {
        Self { shown: [true; 3], maximized: None, linked: false }
    }
}

/// What belongs to the window and not to the figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The language of the interface.
    pub lang: Lang,
    /// Large type and thick strokes, for a projector.
    pub presentation: bool,
    /// The panel with the parameters.
    pub parameters_panel: bool,
    /// The panel with the operations and the numbers.
    pub numbers_panel: bool,
    /// Significant digits of the numbers, 2 … 17.
    pub digits: usize,
}

impl Settings {
    /// What stroke widths and type sizes in the pictures are multiplied by, on top of the pixels per point of the window.
    #[must_use]
    pub fn stroke_scale(&self) -> f32 {
        if self.presentation { 1.5 } else { 1.0 }
    }
}

/// Everything the window knows.
#[derive(Debug)]
pub struct State {
    /// The figure.
    pub document: Document,
    /// The window.
    pub settings: Settings,
    /// The pictures.
    pub layout: Layout,
    /// Asks the pictures to look from somewhere; they take it (`take()`) in the next frame. For both three-dimensional pictures.
    pub look: Option<Look>,
    /// The operation that is being tried or pointed at; written by the panel in each frame, shown in the world.
    pub ghost: Option<Ghost>,
    /// What is pointed at; written by the pictures, shown by the panel.
    pub probe: Option<Probe>,
}

impl State {
    /// The state in which the window opens.
    ///
    /// # Errors
    /// [`CameraError`] where the figure's camera is impossible.
    pub fn new(start: Start) -> Result<Self, CameraError> {
        Ok(Self {
            document: Document::new(start.figure, start.file)?,
            settings: Settings {
                lang: start.lang,
                presentation: false,
                parameters_panel: true,
                numbers_panel: true,
                digits: 6,
            },
            layout: Layout::default(),
            look: None,
            ghost: None,
            probe: None,
        })
    }
}
