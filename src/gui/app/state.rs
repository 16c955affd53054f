//! The whole state of the window: the model, and the state of each feature.

use crate::camera::CameraError;
use crate::gui::Start;
use crate::gui::app::file_flow::link_dialog::Sharing;
use crate::gui::app::file_flow::questions::{Dialog, FileFlow};
use crate::gui::app::search::Search;
use crate::gui::export::Export;
use crate::gui::export::family_choice::FamilyChoice;
use crate::gui::gallery::Gallery;
use crate::gui::inspector::numerics::state::Numerics;
use crate::gui::learn::Learn;
use crate::gui::views::annotations::Annotations;
use crate::gui::why::state::explain::Explain;
use crate::views::{View, Views};
use camera_lab_desk::{Desk, Document, Intent, Model, Recent};
use camera_lab_files::{SourceFile, figure_from};

/// Everything the window knows.
#[derive(Debug)]
pub struct State {
    /// The document, the layout and all other state for every feature.
    pub model: Model,
    /// Files and the questions about them.
    pub file_flow: FileFlow,
    /// Links to the screen.
    pub sharing: Sharing,
    /// The recent files.
    pub recent: Recent,
    /// The figures that one can begin with.
    pub gallery: Gallery,
    /// The search for anything.
    pub search: Search,
    /// The last export settings.
    pub export: Export,
    /// The displayed views when the export dialog last opened.
    pub(in crate::gui) exported_of: Option<Views>,
    /// The exported family.
    pub family: FamilyChoice,
    /// Annotations over the pictures.
    pub annotations: Annotations,
    /// The studies of error against run time.
    pub numerics: Numerics,
    /// The side of explanations.
    pub explain: Explain,
    /// Exercises and lessons.
    pub learn: Learn,
}

/// The documents at the start. Operations of the command line are a change of the figure in the file, so they can be
/// undone, and closing the window asks about them.
fn begin(figure: crate::figure::Figure, file: Option<SourceFile>) -> Result<Desk, CameraError> {
    let in_file = file.as_ref().and_then(|file| figure_from(file.text.as_bytes()).ok());
    let Some(in_file) = in_file.map(|opened| opened.figure).filter(|saved| *saved != figure) else {
        return Document::new(figure, file).map(Desk::new);
    };
    let mut desk = Desk::new(Document::new(in_file, file)?);
    desk.replace(figure)?;
    Ok(desk)
}

impl State {
    /// The state in which the window opens.
    ///
    /// # Errors
    /// [`CameraError`] if the figure's camera is impossible.
    pub fn new(start: Start) -> Result<Self, CameraError> {
        let image = start.figure.image;
        let square = start.figure.camera.aspect == f64::from(image.width) / f64::from(image.height);
        let mut desk = begin(start.figure, start.file)?;
        if start.allow_files {
            desk.shown.allow_files();
        }
        let screen = desk.shown.figure().screen;
        let mut state = Self {
            model: Model::new(desk, start.lang, square),
            sharing: Sharing::default(),
            file_flow: FileFlow::new(true),
            recent: Recent::default(),
            gallery: Gallery::default(),
            search: Search::default(),
            export: Export::new([[640, 480]; View::COUNT], 1.0),
            exported_of: None,
            family: FamilyChoice::default(),
            annotations: Annotations::default(),
            numerics: Numerics::default(),
            explain: Explain::default(),
            learn: Learn::default(),
        };
        state.model.show_screen(screen);
        if let Some(open) = start.lesson {
            state.learn.play(&mut state.model, open);
        }
        Ok(state)
    }

    /// True from the first question about closing the window, until the user answers one with *Cancel*.
    pub(in crate::gui) fn is_closing(&self) -> bool {
        let FileFlow { may_close, dialog, .. } = &self.file_flow;
        *may_close || *dialog == Some(Dialog::Closing) || self.model.desk.errand() == Some(&Intent::Quit)
    }

    /// True if closing the window would lose something.
    pub fn would_lose_something(&self) -> bool {
        self.model.is_unsaved()
            || self.learn.unsaved_text().is_some()
            || !self.model.desk.held().is_empty()
            || !self.file_flow.exporting.is_empty()
    }
}
