//! The model of the window, without widgets, for all features: the document and its history, the scene, the layout, the
//! selection and the explanations, the shot of the pictures.

use glam::DVec3;

use crate::action::Action;
use crate::appearance::Style;
use crate::background::memo::Memo;
use crate::camera::{Camera, CameraError};
use crate::coach::Coach;
use crate::desk::Desk;
use crate::document::Document;
use crate::exchange::Exchange;
use crate::explained::Explained;
use crate::figure::points::free_name;
use crate::figure::{Explanation, Figure, NamedPoint, Observers, ShownProbe};
use crate::follow::Follow;
use crate::layout::asked_layout::AskedLayout;
use crate::layout::view_history::ViewHistory;
use crate::layout::{Layout, ObserverChange, Panels, Side};
use crate::message::Message;
use crate::operations::Operations;
use crate::operations::motion::Motion;
use crate::pixel_costs::PixelCosts;
use crate::scene_cache::SceneCache;
use crate::scene_tree::{SceneTree, Selected};
use crate::settings::Settings;
use crate::shown::SeenBy;
use crate::tools::{CameraList, LabelMode, PhotographTool};
use crate::views::View;
use camera_lab_words::messages::faults;
use camera_lab_words::{Lang, told, window};

/// Duration of news, in seconds: time to read two lines.
const NEWS_SECONDS: f64 = 10.0;

/// The document, the layout and all other state of the window for every feature.
#[derive(Debug)]
pub struct Model {
    /// The documents. The shown one has the figure.
    pub desk: Desk,
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
    /// True if the window is a page in a browser. There are no folders, and no window to close.
    pub in_browser: bool,
    /// The last message at the bottom of the window.
    pub message: Option<Message>,
    /// When the message was first shown, in seconds. `None` if not yet.
    shown_since: Option<f64>,
    /// The last observers found by [`as_seen`](Self::as_seen).
    pub observers_shown: Memo<SeenBy, Observers>,
    /// The layout that the figure asked for.
    pub asked_layout: Option<AskedLayout>,
    /// The faults of the picture, and the health of the camera.
    pub coach: Coach,
    /// The cost of the pixels of the picture whose stages are explained.
    pub costs: PixelCosts,
    /// The operations: their steps and signs, and the last ones done.
    pub operations: Operations,
    /// The followed point.
    pub follow: Follow,
    /// The part of the explanations that the views share.
    pub explained: Explained,
    /// The mode in which labels are the author's.
    pub label_mode: LabelMode,
    /// The lines on the photograph, which determine the position of its camera.
    pub photograph: PhotographTool,
    /// The list of cameras.
    pub cameras: CameraList,
    /// A running step.
    pub motion: Option<Motion>,
    /// Values that the parts of the window exchange from frame to frame.
    pub frame: Exchange,
}

impl Model {
    /// A model of these documents. `square` is true if the pixels of the shown one are.
    pub fn new(desk: Desk, lang: Lang, square: bool) -> Self {
        Self {
            desk,
            scene_cache: SceneCache::default(),
            settings: Settings {
                lang,
                zoom: 1.0,
                panels: Panels { wanted: [true, true, false], ..Panels::default() },
                aspect_follows_image: square,
                digits: 5,
                ..Settings::default()
            },
            in_browser: cfg!(target_arch = "wasm32"),
            layout: Layout::default(),
            views: ViewHistory::default(),
            tree: SceneTree::default(),
            message: None,
            shown_since: None,
            observers_shown: Memo::default(),
            asked_layout: None,
            coach: Coach::default(),
            costs: PixelCosts::default(),
            operations: Operations::default(),
            follow: Follow::default(),
            explained: Explained::default(),
            label_mode: LabelMode::default(),
            photograph: PhotographTool::default(),
            cameras: CameraList::default(),
            motion: None,
            frame: Exchange::default(),
        }
    }

    /// Selects a clicked object, or, with `beside`, adds it to the selection. Only objects of the figure can be
    /// selected together. Otherwise a message says so.
    pub fn select(&mut self, what: Option<Selected>, beside: bool) {
        let scene = &self.desk.shown.figure().scene;
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
    pub fn style(&self) -> Style {
        Style { theme: self.settings.theme, ..self.desk.shown.figure().style }
    }

    /// Shows an explanation at the side.
    pub fn show_explanation(&mut self, explanation: Explanation) {
        self.settings.panels_mut().show(Side::Explain);
        self.explained.show(explanation);
        // The panel explains the stage that's chosen in the strip.
        self.layout.strip |= explanation == Explanation::Stages;
    }

    /// Asks the window for an action, at the end of the frame.
    pub fn request(&mut self, action: Action) {
        self.frame.request = Some(action);
    }

    /// Adds a point of the world to the figure and follows it. If the point exists already, only follows it.
    pub fn follow_point(&mut self, position: DVec3) {
        let points = &self.desk.shown.figure().points;
        let name = match points.iter().find(|point| point.position == position) {
            Some(point) => point.name.clone(),
            None if points.len() >= crate::limits::MAX_NAMED_POINTS => return self.say(Message::TooManyPoints),
            None => {
                let name = free_name(points);
                let point = NamedPoint { name: name.clone(), position };
                self.desk.shown.edit(|figure| figure.points.push(point));
                name
            }
        };
        self.follow.choose(&name);
    }

    /// Moves a point of the figure. A probe that's pinned on it goes with it.
    pub fn move_point(&mut self, index: usize, position: DVec3) {
        self.desk.shown.edit(|figure| {
            let Some(point) = figure.points.get_mut(index) else { return };
            if figure.show.probe == Some(ShownProbe::World(point.position)) {
                figure.show.probe = Some(ShownProbe::World(position));
            }
            point.position = position;
        });
    }

    /// The name of the figure in the window: that of its file, else its title.
    pub fn figure_name(&self) -> String {
        let title = || self.desk.shown.figure().title.as_ref().map(|title| told(self.settings.lang, title).to_owned());
        let name = self.desk.shown.name().or_else(title);
        name.unwrap_or_else(|| window::texts(self.settings.lang).untitled.to_owned())
    }

    /// Shows at the bottom of the window why a camera is impossible.
    pub fn say_camera_error(&mut self, done: Result<(), CameraError>) {
        if let Err(error) = done {
            self.say(Message::Camera(error));
        }
    }

    /// Explains an entry of a matrix. The entry takes the focus.
    pub fn explain_entry(&mut self, matrix: crate::explain::Matrix, entry: [usize; 2]) {
        self.explained.matrices.go_to(matrix, entry);
        self.show_explanation(Explanation::Matrices);
    }

    /// True while the exercises are shown.
    pub fn shows_exercises(&self) -> bool {
        self.shows_explanation(Explanation::Exercises)
    }

    /// The camera that an answer describes, while it's shown, in the form of a file.
    pub fn answered_camera(&self) -> Option<Camera> {
        self.frame.answered.clone().filter(|_| self.shows_exercises())
    }

    /// Shows a message at the bottom of the window.
    pub fn say(&mut self, message: Message) {
        self.message = Some(message);
        self.shown_since = None;
    }

    /// Removes news that have been shown long enough (`now` is a time in seconds). Returns the seconds left until then.
    /// Errors stay until the user closes them, and lasting states as long as they hold.
    pub fn forget_old_news(&mut self, now: f64) -> Option<f64> {
        self.message.as_ref().filter(|message| message.passes())?;
        let left = *self.shown_since.get_or_insert(now) + NEWS_SECONDS - now;
        if left > 0.0 {
            return Some(left);
        }
        self.message = None;
        None
    }

    /// Warnings about the camera, in the language of the window.
    pub fn warnings(&self) -> Vec<String> {
        let camera = self.desk.shown.camera();
        let warnings = camera.warnings().into_iter().chain(camera.aspect_warning(self.desk.shown.figure().image));
        warnings.map(|warning| faults::warning(self.settings.lang, &warning)).collect()
    }
}

impl Model {
    /// Goes on with another document. The one before is lost, unless it was put away, so ask first. Work behind it is
    /// kept.
    pub fn take_over(&mut self, document: Document) {
        let image = document.figure().image;
        self.settings.aspect_follows_image =
            document.draft().aspect == f64::from(image.width) / f64::from(image.height);
        self.motion = None;
        self.desk.take_over(document);
        self.scene_cache.expect_another();
        self.tree = SceneTree::default();
        self.follow = Follow::default();
        let Figure { observers, screen, .. } = *self.desk.shown.figure();
        self.views.reset(observers);
        self.show_screen(screen);
        self.frame.probe = None;
        self.message = None;
        self.photograph = PhotographTool::default();
        self.cameras = CameraList::default();
    }

    /// True if the figure has changes that mustn't be lost.
    pub fn is_unsaved(&self) -> bool {
        self.desk.shows_work() || self.is_rearranged()
    }

    /// True if there is a step to undo (`back`), or to redo.
    pub fn can_undo(&self, back: bool) -> bool {
        self.can_undo_marks(back) || self.desk.can_undo(back)
    }

    /// True if that step is one of the marks on a photograph that's in sight.
    fn can_undo_marks(&self, back: bool) -> bool {
        let figure = self.desk.shown.figure();
        let is_beside = figure.compare.as_ref().is_some_and(|comparison| comparison.beside);
        self.layout.is_shown(View::Image) && !is_beside && self.photograph.can_undo(self.desk.shown.step(), back)
    }

    /// Undoes a step of the marks on the photograph or of the figure (`back`), or redoes it. Selects restored objects.
    pub fn undo(&mut self, back: bool) {
        self.desk.commit();
        if self.can_undo_marks(back) {
            return self.photograph.undo(back);
        }
        let before = self.desk.shown.figure().scene.clone();
        self.desk.undo(back);
        self.tree.follow(&before, &self.desk.shown.figure().scene);
    }

    /// Puts the figure of an exercise into the pictures, in front of the user's own. Undoing leads back to that.
    pub fn show_figure_of_exercise(&mut self, figure: Figure) {
        self.motion = None;
        let image = figure.image;
        self.settings.aspect_follows_image = figure.camera.aspect == f64::from(image.width) / f64::from(image.height);
        let shown = self.desk.show_in_front(figure);
        self.say_camera_error(shown);
        // Its objects are shown without frames and handles.
        self.tree = SceneTree::default();
        self.frame.observer_change = Some(ObserverChange::Fit);
    }
}

#[cfg(test)]
pub(crate) mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use glam::DVec2;

    use super::*;
    use crate::document::fresh;

    /// The model of a window that has just opened.
    pub(crate) fn model() -> Model {
        Model::new(Desk::new(Document::new(fresh(), None).unwrap()), Lang::En, true)
    }

    #[test]
    fn marks_on_a_photograph_are_undone_in_order_with_the_camera_taken_from_them() {
        let mut model = model();
        model.photograph.on = true;
        let before = *model.desk.shown.camera().parameters();
        for x in [1.0, 2.0] {
            model.photograph.begin(DVec2::splat(x));
            model.photograph.go_on(DVec2::splat(50.0 * x));
            model.photograph.end(true);
            model.photograph.settle(model.desk.shown.step());
            model.photograph.settle(model.desk.shown.step());
        }
        let mut after = before;
        after.position.x += 1.0;
        model.desk.commit();
        model.desk.shown.set_camera(Camera::new(&after).unwrap());
        model.desk.commit();
        let state =
            |model: &Model| (model.photograph.marks.lines.len(), *model.desk.shown.camera().parameters() == after);
        let states = [(2, true), (2, false), (1, false), (0, false)];
        for expected in states {
            assert_eq!(state(&model), expected);
            if model.can_undo(true) {
                model.undo(true);
            }
        }
        assert!(!model.can_undo(true));
        for expected in states.into_iter().rev() {
            assert_eq!(state(&model), expected);
            if model.can_undo(false) {
                model.undo(false);
            }
        }
        assert!(!model.can_undo(false));
    }
}
