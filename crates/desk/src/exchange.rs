//! Values that the parts of the window exchange from frame to frame.

use std::sync::Arc;

use crate::action::Action;
use crate::figure::{Observers, TransformPreview};
use crate::inspect::Asked;
use crate::layout::ObserverChange;
use crate::numerics::this_figure::VISIBLE;
use crate::picture::Pixels;
use crate::shown::{OpenPanels, PanelHover};
use crate::views::{Probe, View};

/// Values of a frame. Nothing here is stored, and each could be found again from the rest of the model.
#[derive(Debug)]
pub struct Exchange {
    /// Width and height of each view on the screen, in pixels, in the order of [`View::ALL`].
    ///
    /// *Set by* the views. *Read by* the export dialog and the observers of a saved figure. *Lives* until it changes.
    pub picture_sizes: [[u32; 2]; View::COUNT],
    /// Pixels for one unit of stroke width in the views.
    ///
    /// *Set by* the views. *Read by* the same two. *Lives* until it changes.
    pub screen_scale: f32,
    /// An observer for both three-dimensional views.
    ///
    /// *Set by* commands, lessons and exercises. *Read by* the views, which take it. *Lives* until the next frame.
    pub observer_change: Option<ObserverChange>,
    /// True if no field on the screen shows the fault of the parameters, because its section is closed.
    ///
    /// *Set by* the parameters. *Read by* them in the next frame, for a line above. *Lives* until then.
    pub problem_out_of_sight: bool,
    /// The hover of the panels.
    ///
    /// *Set by* the panels. *Read by* the views. *Lives* for a frame.
    pub hover: PanelHover,
    /// The last observers of the views. `None` if they haven't been shown.
    ///
    /// *Set by* the views. *Read by* saving, sessions and lessons, which store the figure as seen. *Lives* until it
    /// changes.
    pub seen: Observers,
    /// The open panels, of those that explain something in the views.
    ///
    /// *Set and read by* the explanations. *Lives* until the next frame, which compares it with its own.
    pub open_panels: OpenPanels,
    /// The target of the pointer.
    ///
    /// *Set by* the views. *Read by* the explanations and the card. *Lives* until the pointer moves.
    pub probe: Option<Probe>,
    /// The camera that an answer describes.
    ///
    /// *Set by* the exercises. *Read by* the views. *Lives* for a frame.
    pub answered: Option<crate::camera::Camera>,
    /// The quantities that open questions ask for, which nothing prints.
    ///
    /// *Set by* the exercises. *Read by* whatever prints numbers of the figure. *Lives* for a frame.
    pub asked: Asked,
    /// Objects in the places where the explanation of order puts them.
    ///
    /// *Set by* the explanation of order. *Read by* the views. *Lives* for a frame.
    pub placed: Vec<TransformPreview>,
    /// The last requested action.
    ///
    /// *Set by* any feature. *Read by* the window, which performs it. *Lives* until the end of the frame.
    pub request: Option<Action>,
    /// The image of a way to draw the figure, beside the exact one.
    ///
    /// *Set by* the study of the figure. *Read by* the view of the image, which takes it. *Lives* for a frame.
    pub method_image: Option<Arc<MethodImage>>,
    /// The report of the strip's view, stage by stage.
    ///
    /// *Set by* the views while the stages are explained. *Read by* their explanation. *Lives* until it changes.
    pub reports: Vec<crate::pipeline::StageReport>,
    /// The request of the strip's view, without the pointer.
    ///
    /// *Set by* the views while the stages are explained. *Read by* their explanation. *Lives* until it changes.
    pub explained: Option<crate::views::Request>,
}

impl Default for Exchange {
    fn default() -> Self {
        Self {
            picture_sizes: [[640, 480]; View::COUNT],
            screen_scale: 1.0,
            observer_change: None,
            problem_out_of_sight: false,
            hover: PanelHover::default(),
            seen: Observers::default(),
            open_panels: OpenPanels::default(),
            probe: None,
            answered: None,
            asked: Asked::default(),
            placed: Vec::new(),
            request: None,
            method_image: None,
            reports: Vec::new(),
            explained: None,
        }
    }
}

/// The exact image of a figure, and the image of a way to draw it.
#[derive(Debug)]
pub struct MethodImage {
    /// The exact image.
    pub exact: Pixels,
    /// The image of the way, in which the pixels that differ visibly are tinted.
    pub drawn: Pixels,
}

impl MethodImage {
    /// Tints the pixels that differ. `None` if the images have different sizes.
    pub fn new(exact: &Pixels, drawn: &Pixels, tint: [u8; 3]) -> Option<Self> {
        let size = [drawn.width(), drawn.height()];
        let mut bytes = drawn.rgba().to_vec();
        for (pixel, exact) in bytes.chunks_exact_mut(4).zip(exact.rgba().chunks_exact(4)) {
            if pixel.iter().zip(exact).any(|(a, b)| a.abs_diff(*b) > VISIBLE) {
                pixel[..3].copy_from_slice(&tint);
            }
        }
        let drawn = Pixels::opaque(size, bytes).filter(|_| size == [exact.width(), exact.height()])?;
        Some(Self { exact: exact.clone(), drawn })
    }
}
