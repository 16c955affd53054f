//! Everything the window knows: the model, and the state of each feature.

use std::sync::Arc;

use crate::camera::{CameraError, Freedom, Operation};
use crate::figure::{Explanation, Figure};
use crate::files::{SourceFile, figure_from};
use crate::gui::Start;
use crate::gui::app::annotations::Annotations;
use crate::gui::app::search_state::Search;
use crate::gui::background::memo::Memo;
use crate::gui::export::Export;
use crate::gui::export::family_choice::FamilyChoice;
use crate::gui::files::questions::FileFlow;
use crate::gui::gallery::{Gallery, Source};
use crate::gui::inspector::state::cameras::CameraList;
use crate::gui::inspector::state::coach::Coach;
use crate::gui::inspector::state::operations::Operations;
use crate::gui::inspector::state::predict::{About, Prediction};
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::{Mark, Placing};
use crate::gui::model::Model;
use crate::gui::model::document::Document;
use crate::gui::model::follow::Follow;
use crate::gui::model::layout::ObserverChange;
use crate::gui::model::scene_tree::SceneTree;
use crate::gui::pictures::labels::label_mode::LabelMode;
use crate::gui::pictures::photograph::tool::PhotographTool;
use crate::gui::storage::recent::Recent;
use crate::gui::why::state::explain::Explain;
use crate::gui::why::state::numerics::Numerics;
use crate::i18n::learn::exercise_window;
use crate::i18n::window::predict;
use crate::share::ShareError;
use crate::views::View;

/// Everything the window knows.
#[derive(Debug)]
pub struct State {
    /// What every feature may use.
    pub model: Model,
    /// The panel of operations.
    pub operations: Operations,
    /// Files and the questions about them.
    pub file_flow: FileFlow,
    /// The address of that page, where others can open it too.
    pub own_address: Option<String>,
    /// The address of a page with this program, for links, as entered by the user.
    pub page_address: String,
    /// The files that were opened or saved last.
    pub recent: Recent,
    /// The figures that one can begin with.
    pub gallery: Gallery,
    /// The search for anything.
    pub search: Search,
    /// Figures that were left with changes, by where they come from.
    pub kept: Vec<(Option<Source>, Document)>,
    /// Those of them that the user, closing the window, has decided not to save. Kept again where it is not closed.
    pub(in crate::gui) given_up: Vec<(Option<Source>, Document)>,
    /// The last export settings.
    pub export: Export,
    /// The family that is exported.
    pub family: FamilyChoice,
    /// The figure whose camera was kept as A.
    pub camera_a: Option<Arc<Figure>>,
    /// Annotations over the pictures.
    pub annotations: Annotations,
    /// The mode in which labels are the author's.
    pub label_mode: LabelMode,
    /// The lines on the photograph, which say where its camera was.
    pub photograph: PhotographTool,
    /// The studies of error against run time.
    pub numerics: Numerics,
    /// The side of explanations.
    pub explain: Explain,
    /// Exercises and lessons.
    pub learn: Learn,
    /// The list of cameras.
    pub cameras: CameraList,
    /// The link that a dialog shows.
    /// By the address, and whether it holds a whole lesson. Made when the dialog is opened, since nothing behind it
    /// changes.
    pub(in crate::gui) shown_link: Memo<(String, bool), Result<String, ShareError>>,
    /// The faults of the picture, and the health of the camera.
    pub coach: Coach,
}

/// The document at the start. Operations of the command line are a change of the figure in the file. They can be
/// undone, and closing the window asks about them.
fn begin(figure: Figure, file: Option<SourceFile>) -> Result<Document, CameraError> {
    let in_file = file.as_ref().and_then(|file| figure_from(file.text.as_bytes()).ok());
    let Some(in_file) = in_file.map(|opened| opened.figure).filter(|saved| *saved != figure) else {
        return Document::new(figure, file);
    };
    let mut document = Document::new(in_file, file)?;
    document.replace(figure)?;
    Ok(document)
}

impl State {
    /// The state in which the window opens.
    ///
    /// # Errors
    /// [`CameraError`] where the figure's camera is impossible.
    pub fn new(start: Start) -> Result<Self, CameraError> {
        let image = start.figure.image;
        let square = start.figure.camera.aspect == f64::from(image.width) / f64::from(image.height);
        let mut document = begin(start.figure, start.file)?;
        if start.allow_files {
            document.allow_files();
        }
        let screen = document.figure().screen;
        let mut state = Self {
            model: Model::new(document, start.lang, square),
            own_address: None,
            page_address: String::new(),
            operations: Operations::default(),
            file_flow: FileFlow::new(true),
            recent: Recent::default(),
            gallery: Gallery::default(),
            search: Search::default(),
            kept: Vec::new(),
            given_up: Vec::new(),
            export: Export::new([[640, 480]; View::COUNT], 1.0),
            family: FamilyChoice::default(),
            camera_a: None,
            annotations: Annotations::default(),
            label_mode: LabelMode::default(),
            photograph: PhotographTool::default(),
            numerics: Numerics::default(),
            explain: Explain::default(),
            learn: Learn::default(),
            cameras: CameraList::default(),
            shown_link: Memo::default(),
            coach: Coach::default(),
        };
        state.model.show_screen(screen);
        if let Some(open) = start.lesson {
            state.play(open);
        }
        Ok(state)
    }

    /// Goes on with another document. The one before is lost, unless the caller has it: ask first. Work behind it is
    /// kept.
    pub(in crate::gui) fn take_over(&mut self, document: Document) {
        self.keep_behind();
        let image = document.figure().image;
        self.model.settings.aspect_follows_image =
            document.draft().aspect == f64::from(image.width) / f64::from(image.height);
        self.operations.motion = None;
        self.close_lesson();
        self.model.document = document;
        self.file_flow.theirs = None;
        self.file_flow.decided = None;
        self.model.scene_cache.expect_another();
        self.model.tree = SceneTree::default();
        self.model.follow = Follow::default();
        self.cameras = CameraList::default();
        self.photograph = PhotographTool::default();
        self.model.views.reset(self.model.document.figure().observers);
        let screen = self.model.document.figure().screen;
        self.model.show_screen(screen);
        self.model.probe = None;
        self.model.message = None;
    }

    /// A figure that was left with changes.
    pub(in crate::gui) fn take_kept(&mut self, source: Option<&Source>) -> Option<Document> {
        let index = self.kept.iter().position(|(of, _)| of.as_ref() == source)?;
        Some(self.kept.remove(index).1)
    }

    /// Undoes a step. Objects that come back are selected. The figure on the screen comes first, then the lesson.
    pub fn undo(&mut self) {
        if !self.model.document.can_undo() && self.can_undo_lesson(true) {
            return self.undo_lesson(true);
        }
        let before = self.model.document.figure().scene.clone();
        self.model.document.undo();
        self.model.tree.follow(&before, &self.model.document.figure().scene);
    }

    /// Redoes a step. Objects that come back are selected.
    pub fn redo(&mut self) {
        if !self.model.document.can_redo() && self.can_undo_lesson(false) {
            return self.undo_lesson(false);
        }
        let before = self.model.document.figure().scene.clone();
        self.model.document.redo();
        self.model.tree.follow(&before, &self.model.document.figure().scene);
    }

    /// Does an operation to the camera, by the signs that are chosen; where it cannot be done, says why.
    pub fn operate(&mut self, operation: Operation) {
        let done = self.model.document.operate(operation, self.operations.convention);
        self.model.say_camera_error(done);
    }

    /// True while meshes are read or pictures written.
    pub(in crate::gui) fn runs(&self) -> bool {
        self.model.scene_cache.running().is_some() || self.file_flow.running().next().is_some()
    }

    /// The question for a place in the image that is asked now.
    pub fn placing(&mut self) -> Option<Placing> {
        let of_question = self.placing_of_question();
        of_question.or_else(|| self.placing_of_operation())
    }

    /// The question of an operation, where a point will go.
    fn placing_of_operation(&self) -> Option<Placing> {
        let asked =
            self.operations.predict.asked.as_ref().filter(|asked| asked.document == self.model.document.id())?;
        let About::Place { from, to, mark, .. } = asked.about else { return None };
        let done = |place| Some(place).filter(|_| asked.is_done);
        Some(Placing {
            from: Some(from).filter(|_| !asked.is_done),
            mark,
            guess: mark.and_then(done),
            right: done(to),
            is_open: !asked.is_done,
            hint: predict::texts(self.model.settings.lang).mark_here,
            of: Mark::Operation,
        })
    }

    /// Has an operation ask what it will do, where that is wanted. False if it's to be done at once.
    pub(in crate::gui) fn predict_first(&mut self, freedom: Freedom, amount: f64) -> bool {
        self.operations.predict.asked = None;
        if !self.operations.predict.on {
            return false;
        }
        let (camera, image) = (self.model.document.camera(), self.model.document.figure().image);
        let subject = (camera, image, &**self.model.scene_cache.scene());
        let about = About::of(subject, (freedom, amount), self.operations.convention);
        let document = self.model.document.id();
        let asked = about.map(|about| Prediction { freedom, amount, about, document, is_done: false });
        let asks = asked.is_some();
        self.model.layout.shown[View::Image.index()] |= asks;
        self.operations.predict.asked = asked;
        asks
    }

    fn placing_of_question(&mut self) -> Option<Placing> {
        let asks = self.learn.lesson.as_ref().is_some_and(|playing| playing.asks_question());
        if !(asks || self.model.shows_exercises()) || self.moves_to_step() {
            return None;
        }
        self.learn.exercises.placing(exercise_window::texts(self.model.settings.lang).place_in_image)
    }

    /// Puts the mark of a question for a place there.
    pub(in crate::gui) fn put_mark(&mut self, placing: &Placing, [x, y]: [f64; 2]) {
        match &placing.of {
            Mark::Operation => {
                let asked = self.operations.predict.asked.as_mut();
                if let Some(Prediction { about: About::Place { mark, .. }, .. }) = asked {
                    *mark = Some([x, y]);
                }
            }
            Mark::Ask(ask) => self.learn.exercises.type_into(ask, vec![format!("{x}"), format!("{y}")]),
        }
    }

    /// Puts the figure of an exercise into the pictures, in front of the user's own: undoing leads back to that.
    pub(in crate::gui) fn show_figure_of_exercise(&mut self, figure: Figure) {
        self.operations.motion = None;
        let image = figure.image;
        self.model.settings.aspect_follows_image =
            figure.camera.aspect == f64::from(image.width) / f64::from(image.height);
        let shown = self.model.document.show_in_front(figure);
        self.model.say_camera_error(shown);
        // Its objects are to be seen, without frames and handles.
        self.model.tree = SceneTree::default();
        self.model.observer_change = Some(ObserverChange::Fit);
    }

    /// Shows a note, which takes the keyboard in the list of notes.
    pub(in crate::gui) fn explain_by_note(&mut self, id: &'static str) {
        self.explain.notes.go_to(id);
        self.model.show_explanation(Explanation::Notes);
    }
}
