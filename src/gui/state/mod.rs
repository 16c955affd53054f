//! State shared by the panels and the pictures.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui;
use glam::DVec3;

use crate::appearance::{Style, Theme};
use crate::camera::{Camera, CameraError, Freedom, Operation};
use crate::explain::Matrix;
use crate::figure::points::free_name;
use crate::figure::{Explanation, Figure, NamedPoint, Observers};
use crate::files::{SourceFile, figure_from};
pub use crate::gui::app::annotations::Annotations;
pub use crate::gui::app::search_state::Search;
pub(in crate::gui) use crate::gui::files::questions::Asking;
pub use crate::gui::files::questions::{
    AfterSave, Agreed, Changed, Dialog, FileFlow, MESH_ENDINGS, MeshFor, Purpose, TEXTURE_ENDINGS, Theirs,
};
pub use crate::gui::inspector::state::cameras::CameraList;
pub use crate::gui::inspector::state::coach::{Advice, Coach};
pub use crate::gui::inspector::state::compare::CompareForm;
pub(super) use crate::gui::inspector::state::insert::{free_place, rounded};
pub use crate::gui::inspector::state::operations::Operations;
pub(super) use crate::gui::inspector::state::operations::{DoneStep, Motion, Scrub};
pub use crate::gui::inspector::state::predict::{About, Change, Predict, Prediction};
pub(super) use crate::gui::inspector::state::scene_tree::{Draft, Typing, preset_objects};
pub use crate::gui::inspector::state::scene_tree::{SceneTree, Selected};
pub use crate::gui::learn::exercises::state::{
    Checked, Chosen, Described, Exercises, NotCamera, Opened, OwnFolder, Placing, Typed, is_whole, joined,
};
pub(in crate::gui) use crate::gui::learn::exercises::state::{Done, Mark};
pub(in crate::gui) use crate::gui::learn::lesson::state::FADE;
pub use crate::gui::learn::lesson::state::{Moving, Playing};
pub use crate::gui::learn::lesson::writing::{StepChange, Writing};
use crate::gui::model::asked_layout::AskedLayout;
pub use crate::gui::model::layout::{Layout, ObserverChange, Panels, Side, Tab, WindowPlace};
pub(in crate::gui) use crate::gui::model::message::about_session;
pub use crate::gui::model::message::{Message, NotExported};
pub use crate::gui::model::shown::PanelHover;
use crate::gui::model::shown::{OpenPanels, SeenBy};
pub use crate::gui::pictures::labels::label_mode::LabelMode;
pub use crate::gui::pictures::photograph::tool::{Drawn, PhotographTool};
pub use crate::gui::pictures::view_history::ViewHistory;
pub use crate::gui::storage::recent::Recent;
pub(super) use crate::gui::storage::recent::merged;
pub use crate::gui::why::state::conventions::Conventions;
pub use crate::gui::why::state::explain::{Explain, Question};
pub use crate::gui::why::state::follow::Follow;
pub(super) use crate::gui::why::state::follow::Space;
pub(in crate::gui) use crate::gui::why::state::matrices::symbols_of;
pub use crate::gui::why::state::matrices::{Matrices, Reading};
pub use crate::gui::why::state::notes::Notes;
pub use crate::gui::why::state::numerics::Numerics;
pub use crate::gui::why::state::order::{ListedCall, Order, Own};
pub use crate::gui::why::state::steps::{Steps, count, end_of, step_at, time_of};
pub(in crate::gui) use crate::gui::why::state::triangle::Covered;
pub use crate::gui::why::state::triangle::TriangleNumbers;
use crate::i18n::learn::exercise_window;
use crate::i18n::messages::faults;
use crate::i18n::window::predict;
use crate::i18n::{Lang, told, window};
use crate::lessons::Lesson;
use crate::limits::MAX_NAMED_POINTS;
use crate::share::ShareError;
use crate::views::Probe;
use crate::views::View;

use super::Start;
use super::export::Export;
use super::gallery::{Gallery, Source};
use crate::gui::background::memo::Memo;
use crate::gui::export::family_choice::FamilyChoice;
use crate::gui::model::document::Document;
use crate::gui::model::scene_cache::SceneCache;

/// Duration of news, in seconds: time to read two lines.
const NEWS_SECONDS: f64 = 10.0;

/// State of the window, and not of the figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The language of the interface.
    pub lang: Lang,
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
    /// The inverse matrices are shown instead of the matrices.
    pub inverse: bool,
    /// The display of matrices, and the convention of NDC.
    pub conventions: Conventions,
    /// Significant digits of the numbers, 2 … 17.
    pub digits: usize,
    /// The ground of the window and of its pictures. What a figure file asks for counts where pictures are written.
    pub theme: Theme,
    /// Skip animations.
    pub reduce_motion: bool,
    /// The numbers below the operations are unfolded.
    pub numbers_open: bool,
    /// The first lesson and the gallery have been offered.
    pub welcomed: bool,
    /// The pictures alone, without menus: a figure in somebody's page.
    pub bare: bool,
    /// The place of the window, once it's known; at first, that of the last one.
    pub window: Option<WindowPlace>,
}

impl Settings {
    /// The panels as they are wanted now.
    #[must_use]
    pub fn panels(&self) -> &Panels {
        if self.presentation { &self.presentation_panels } else { &self.panels }
    }

    /// The panels as they are wanted now.
    pub fn panels_mut(&mut self) -> &mut Panels {
        if self.presentation { &mut self.presentation_panels } else { &mut self.panels }
    }

    /// The factor of stroke widths and type sizes in the pictures, on top of the pixels per point of the window.
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
    /// The scene of the figure.
    pub scene_cache: SceneCache,
    /// The window.
    pub settings: Settings,
    /// The pictures.
    pub layout: Layout,
    /// Their earlier viewpoints.
    pub views: ViewHistory,
    /// The tree of the scene.
    pub tree: SceneTree,
    /// The panel of operations.
    pub operations: Operations,
    /// Files and the questions about them.
    pub file_flow: FileFlow,
    /// Width and height of each picture on the screen, in pixels, in the order of
    /// [`View::ALL`](crate::views::View::ALL); written by the pictures.
    pub picture_sizes: [[u32; 2]; View::COUNT],
    /// Pixels for one unit of stroke width in the pictures. Written by the pictures.
    pub screen_scale: f32,
    /// The window is a page in a browser. There are no folders, and no window to be closed.
    pub in_browser: bool,
    /// The corner of another screen, in points, for the speaker's notes; `None` means not looked for yet, inside: none.
    pub(in crate::gui) other_screen: Option<Option<egui::Pos2>>,
    /// The address of that page, where others can open it too.
    pub own_address: Option<String>,
    /// The address of a page with this program, for links, as entered by the user.
    pub page_address: String,
    /// The last message at the bottom of the window.
    pub message: Option<Message>,
    /// When the message was first shown, in seconds; `None` means not yet.
    shown_since: Option<f64>,
    /// Asks the pictures to look from somewhere. They take it (`take()`) in the next frame. For both three-dimensional
    /// pictures.
    pub observer_change: Option<ObserverChange>,
    /// No field on the screen shows the fault of the parameters (its section is closed).
    pub problem_out_of_sight: bool,
    /// The hover of the panels in this frame.
    pub hover: PanelHover,
    /// The last observers of the pictures; `None` means they have not been shown.
    pub seen: Observers,
    /// The observers that [`as_seen`](Self::as_seen) found last.
    pub(in crate::gui) observers_shown: Memo<SeenBy, Observers>,
    /// The panels that were open in the last frame, of those that explain something in the pictures.
    pub(in crate::gui) open_panels: OpenPanels,
    /// The layout that the figure asked for.
    pub(in crate::gui) asked_layout: Option<AskedLayout>,
    /// The target of the pointer. Written by the pictures, shown by the panel.
    pub probe: Option<Probe>,
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
    /// The exercises.
    pub exercises: Exercises,
    /// The lesson that is played.
    pub lesson: Option<Playing>,
    /// The lessons of a lecturer's folder, as they were when the list was opened.
    pub own_lessons: Vec<(PathBuf, Arc<Lesson>)>,
    /// The lesson of the user's own to which steps are added.
    pub lesson_file: Option<PathBuf>,
    /// The furthest step of each lesson that was taken, from 0, by the lesson's identifier.
    pub lessons_taken: BTreeMap<String, usize>,
    /// The steps of each lesson whose task was done, from 0: an answer of one's own, and not a way that was shown.
    pub lessons_done: BTreeMap<String, BTreeSet<usize>>,
    /// The way on from the last time is offered, in one line.
    pub goes_on: bool,
    /// The first lesson and the gallery are offered, in one line.
    pub welcome: bool,
    /// The list of cameras.
    pub cameras: CameraList,
    /// The followed point.
    pub follow: Follow,
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
            document,
            scene_cache: SceneCache::default(),
            settings: Settings {
                lang: start.lang,
                zoom: 1.0,
                presentation: false,
                panels: Panels { wanted: [true, true, false], ..Panels::default() },
                presentation_panels: Panels::default(),
                tab: Tab::default(),
                aspect_follows_image: square,
                inverse: false,
                conventions: Conventions::default(),
                digits: 5,
                theme: Theme::default(),
                reduce_motion: false,
                numbers_open: false,
                welcomed: false,
                bare: false,
                window: None,
            },
            in_browser: cfg!(target_arch = "wasm32"),
            other_screen: None,
            own_address: None,
            page_address: String::new(),
            layout: Layout::default(),
            views: ViewHistory::default(),
            tree: SceneTree::default(),
            operations: Operations::default(),
            file_flow: FileFlow::new(true),
            picture_sizes: [[640, 480]; View::COUNT],
            screen_scale: 1.0,
            message: None,
            shown_since: None,
            observer_change: None,
            problem_out_of_sight: false,
            hover: PanelHover::default(),
            seen: Observers::default(),
            observers_shown: Memo::default(),
            open_panels: OpenPanels::default(),
            asked_layout: None,
            probe: None,
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
            exercises: Exercises::default(),
            cameras: CameraList::default(),
            follow: Follow::default(),
            shown_link: Memo::default(),
            coach: Coach::default(),
            lesson: None,
            own_lessons: Vec::new(),
            lesson_file: None,
            lessons_taken: BTreeMap::new(),
            lessons_done: BTreeMap::new(),
            goes_on: false,
            welcome: false,
        };
        state.show_screen(screen);
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
        self.settings.aspect_follows_image =
            document.draft().aspect == f64::from(image.width) / f64::from(image.height);
        self.operations.motion = None;
        self.close_lesson();
        self.document = document;
        self.file_flow.theirs = None;
        self.file_flow.decided = None;
        self.scene_cache.expect_another();
        self.tree = SceneTree::default();
        self.follow = Follow::default();
        self.cameras = CameraList::default();
        self.photograph = PhotographTool::default();
        self.views.reset(self.document.figure().observers);
        let screen = self.document.figure().screen;
        self.show_screen(screen);
        self.probe = None;
        self.message = None;
    }

    /// A figure that was left with changes.
    pub(in crate::gui) fn take_kept(&mut self, source: Option<&Source>) -> Option<Document> {
        let index = self.kept.iter().position(|(of, _)| of.as_ref() == source)?;
        Some(self.kept.remove(index).1)
    }

    /// Selects a clicked object, or, with `beside`, adds it to the selection. Only objects of the figure are selected
    /// together, else that is reported.
    pub(in crate::gui) fn select(&mut self, what: Option<Selected>, beside: bool) {
        let scene = &self.document.figure().scene;
        let is_alone = |selected: &Selected| !matches!(selected, Selected::Object(_));
        let now = self.tree.selected(scene);
        let parts = |what: &Selected| now.is_some_and(|now| now != what && (is_alone(now) || is_alone(what)));
        let parted = beside && what.as_ref().is_some_and(parts);
        match &what {
            Some(Selected::Object(name)) if beside => self.tree.toggle(scene, name),
            _ => self.tree.select(what),
        }
        if parted {
            self.say(Message::SelectedAlone);
        }
    }

    /// The style of the pictures in the window: that of the figure, in the theme of the window.
    #[must_use]
    pub fn style(&self) -> Style {
        Style { theme: self.settings.theme, ..self.document.figure().style }
    }

    /// Shows an explanation at the side.
    pub(in crate::gui) fn show_explanation(&mut self, explanation: Explanation) {
        self.settings.panels_mut().show(Side::Explain);
        self.explain.show(explanation);
    }

    /// Adds a point of the world to the figure and follows it. One that is there already is only followed.
    pub(in crate::gui) fn follow_point(&mut self, position: DVec3) {
        let points = &self.document.figure().points;
        let name = match points.iter().find(|point| point.position == position) {
            Some(point) => point.name.clone(),
            None if points.len() >= MAX_NAMED_POINTS => return self.say(Message::TooManyPoints),
            None => {
                let name = free_name(points);
                let point = NamedPoint { name: name.clone(), position };
                self.document.edit(|figure| figure.points.push(point));
                name
            }
        };
        self.follow.choose(&name);
    }

    /// Undoes a step. Objects that come back are selected. The figure on the screen comes first, then the lesson.
    pub fn undo(&mut self) {
        if !self.document.can_undo() && self.can_undo_lesson(true) {
            return self.undo_lesson(true);
        }
        let before = self.document.figure().scene.clone();
        self.document.undo();
        self.tree.follow(&before, &self.document.figure().scene);
    }

    /// Redoes a step. Objects that come back are selected.
    pub fn redo(&mut self) {
        if !self.document.can_redo() && self.can_undo_lesson(false) {
            return self.undo_lesson(false);
        }
        let before = self.document.figure().scene.clone();
        self.document.redo();
        self.tree.follow(&before, &self.document.figure().scene);
    }

    /// The name of the figure in the window: that of its file, else its title.
    pub(in crate::gui) fn figure_name(&self) -> String {
        let title = || self.document.figure().title.as_ref().map(|title| told(self.settings.lang, title).to_owned());
        let name = self.document.name().or_else(title);
        name.unwrap_or_else(|| window::texts(self.settings.lang).untitled.to_owned())
    }

    /// Does an operation to the camera, by the signs that are chosen; where it cannot be done, says why.
    pub fn operate(&mut self, operation: Operation) {
        let done = self.document.operate(operation, self.operations.convention);
        self.say_camera_error(done);
    }

    /// Says at the bottom of the window why a camera is impossible.
    pub fn say_camera_error(&mut self, done: Result<(), CameraError>) {
        if let Err(error) = done {
            self.say(Message::Camera(error));
        }
    }

    /// True while meshes are read or pictures written.
    pub(in crate::gui) fn runs(&self) -> bool {
        self.scene_cache.running().is_some() || self.file_flow.running().next().is_some()
    }

    /// Explains an entry of a matrix. The entry takes the focus.
    pub(in crate::gui) fn explain_entry(&mut self, matrix: Matrix, entry: [usize; 2]) {
        self.explain.matrices.go_to(matrix, entry);
        self.show_explanation(Explanation::Matrices);
    }

    /// The question for a place in the image that is asked now.
    pub fn placing(&mut self) -> Option<Placing> {
        let of_question = self.placing_of_question();
        of_question.or_else(|| self.placing_of_operation())
    }

    /// The question of an operation, where a point will go.
    fn placing_of_operation(&self) -> Option<Placing> {
        let asked = self.operations.predict.asked.as_ref().filter(|asked| asked.document == self.document.id())?;
        let About::Place { from, to, mark, .. } = asked.about else { return None };
        let done = |place| Some(place).filter(|_| asked.is_done);
        Some(Placing {
            from: Some(from).filter(|_| !asked.is_done),
            mark,
            guess: mark.and_then(done),
            right: done(to),
            is_open: !asked.is_done,
            hint: predict::texts(self.settings.lang).mark_here,
            of: Mark::Operation,
        })
    }

    /// Has an operation ask what it will do, where that is wanted. False if it's to be done at once.
    pub(in crate::gui) fn predict_first(&mut self, freedom: Freedom, amount: f64) -> bool {
        self.operations.predict.asked = None;
        if !self.operations.predict.on {
            return false;
        }
        let (camera, image) = (self.document.camera(), self.document.figure().image);
        let subject = (camera, image, &**self.scene_cache.scene());
        let about = About::of(subject, (freedom, amount), self.operations.convention);
        let document = self.document.id();
        let asked = about.map(|about| Prediction { freedom, amount, about, document, is_done: false });
        let asks = asked.is_some();
        self.layout.shown[View::Image.index()] |= asks;
        self.operations.predict.asked = asked;
        asks
    }

    fn placing_of_question(&mut self) -> Option<Placing> {
        let asks = self.lesson.as_ref().is_some_and(|playing| playing.asks_question());
        if !(asks || self.shows_exercises()) || self.moves_to_step() {
            return None;
        }
        self.exercises.placing(exercise_window::texts(self.settings.lang).place_in_image)
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
            Mark::Ask(ask) => self.exercises.type_into(ask, vec![format!("{x}"), format!("{y}")]),
        }
    }

    /// True while the exercises are shown.
    #[must_use]
    pub fn shows_exercises(&self) -> bool {
        self.shows_explanation(Explanation::Exercises)
    }

    /// The camera that an answer describes, while it is shown; as a file can hold it.
    pub(in crate::gui) fn answered_camera(&self) -> Option<Camera> {
        let described = self.exercises.described.as_ref().filter(|_| self.shows_exercises())?;
        described.camera.as_deref().ok().map(Camera::rounded)
    }

    /// Puts the figure of an exercise into the pictures, in front of the user's own: undoing leads back to that.
    pub(in crate::gui) fn show_figure_of_exercise(&mut self, figure: Figure) {
        self.operations.motion = None;
        let image = figure.image;
        self.settings.aspect_follows_image = figure.camera.aspect == f64::from(image.width) / f64::from(image.height);
        let shown = self.document.show_in_front(figure);
        self.say_camera_error(shown);
        // Its objects are to be seen, without frames and handles.
        self.tree = SceneTree::default();
        self.observer_change = Some(ObserverChange::Fit);
    }

    /// Shows a note, which takes the keyboard in the list of notes.
    pub(in crate::gui) fn explain_by_note(&mut self, id: &'static str) {
        self.explain.notes.go_to(id);
        self.show_explanation(Explanation::Notes);
    }

    /// Says something at the bottom of the window.
    pub fn say(&mut self, message: Message) {
        self.message = Some(message);
        self.shown_since = None;
    }

    /// Removes news that have been shown long enough (`now` is a time in seconds). Returns the seconds left until then.
    /// Errors stay until they are closed, and lasting states as long as they hold.
    pub(in crate::gui) fn forget_old_news(&mut self, now: f64) -> Option<f64> {
        self.message.as_ref().filter(|message| message.passes())?;
        let left = *self.shown_since.get_or_insert(now) + NEWS_SECONDS - now;
        if left > 0.0 {
            return Some(left);
        }
        self.message = None;
        None
    }

    /// Warnings about the camera, in the language of the window.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let camera = self.document.camera();
        let warnings = camera.warnings().into_iter().chain(camera.aspect_warning(self.document.figure().image));
        warnings.map(|warning| faults::warning(self.settings.lang, &warning)).collect()
    }
}
