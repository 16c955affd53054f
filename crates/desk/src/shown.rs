//! Explanations in the pictures: the `[show]` of the figure, its changes by panels, and the resulting shot.

use std::sync::Arc;

use crate::camera::Ndc;
use crate::document::Seen;
use crate::explained::steps;
use crate::figure::{
    Explanation, Figure, Measured, Observers, Screen, Show, ShownProbe, ShownStep, StagePicture, View,
};
use crate::history::Revision;
use crate::layout::Side;
use crate::layout::asked_layout::shown_entry;
use crate::model::Model;
use crate::stage::Stage;
use crate::views::observer::Viewpoint;
use crate::views::{Compared, Ghost, Look, Normalizing, Picture, Probe, Request, Shot, Size};
use camera_lab_words::pictures::labels;

/// The targets of panels in a frame. Each frame begins without any.
#[derive(Clone, Debug, Default)]
pub struct PanelHover {
    /// The operation being tried or pointed at, shown in the world.
    pub ghost: Option<Ghost>,
    /// The measures of the hover, shown in the world.
    pub measured: Vec<Measured>,
    /// The parameters pointed at in another panel.
    pub pointed: Vec<crate::explain::Symbol>,
}

/// The panels that explain something in the pictures. Closing one removes its explanation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OpenPanels {
    stages: bool,
    painting: bool,
    triangle: bool,
    steps: bool,
    order: bool,
}

/// The state that the observers of the screen depend on.
pub type SeenBy = ((Revision, [Observers; 2], [bool; View::COUNT], [[u32; 2]; View::COUNT]), Ndc);

impl Model {
    /// The content of `pictures` in this frame.
    pub fn shot(&self, pictures: Vec<Picture>) -> Shot {
        let figure = self.desk.shown.figure();
        let shot = Shot::of_one(figure, &figure.scene);
        let look = Look { style: self.style(), ..shot.look };
        let mut show = shot.show;
        show.step = self.step_as_shown();
        show.moved.extend_from_slice(&self.frame.placed);
        Shot {
            look,
            ndc: self.settings.conventions.ndc,
            pictures,
            answered: self.answered_camera().or(shot.answered),
            show,
            compared: self.compared().map(|mut compared| {
                compared.shot.asked = self.frame.asked.clone();
                Arc::new(compared)
            }),
            asked: self.frame.asked.clone(),
            ..shot
        }
    }

    /// The other side of the pictures of this frame. `None` if there is no comparison, or it's impossible.
    pub fn compared(&self) -> Option<Compared> {
        let figure = self.desk.shown.figure();
        figure.compare.as_ref()?;
        let shown = Figure { style: self.style(), show: self.show_as_saved(), ..figure.without_scene() };
        Compared::of(&shown, &figure.scene)
    }

    /// The reason why the other side of the comparison is impossible. `None` if it's possible, or there is no
    /// comparison.
    pub fn impossible_side(&self) -> Option<String> {
        let figure = self.desk.shown.figure();
        let error = figure.compare.as_ref()?.other_side(figure).err()?;
        Some(camera_lab_words::window::compare::impossible(self.settings.lang, &error))
    }

    /// The figure that shows the present screen in any program, with explanations, and with the observers.
    pub fn figure_as_shown(&self) -> Figure {
        let figure = Figure { observers: self.observers_as_shown(), ..self.figure_to_save() };
        if self.desk.shown.has_words_of_card() { Figure { title: None, caption: None, ..figure } } else { figure }
    }

    /// The figure as *Save* writes it, with its layout and its explanations. If you haven't turned a view, its observer
    /// isn't written, so the file opens with one that fits.
    pub fn figure_to_save(&self) -> Figure {
        Figure { show: self.show_as_saved(), screen: self.screen(), ..self.desk.shown.figure().clone() }
    }

    /// The parts of the window's layout that differ from that of a new window. In a presentation it's the layout that
    /// the figure had before, because a lecture hides and opens things for its audience.
    pub fn screen(&self) -> Screen {
        let saved = self.desk.shown.figure().screen;
        if self.settings.presentation {
            return saved;
        }
        let is_open = self.settings.panels().wanted[Side::Explain as usize];
        // A maximized view is so only for the moment.
        let shown = self.layout.shown;
        // If the file names a layout, it continues to do so.
        let keep = |was: bool, is_usual: bool| was || !is_usual;
        Screen {
            pictures: Some(shown).filter(|shown| keep(saved.pictures.is_some(), *shown == [true; View::COUNT])),
            arrangement: Some(self.layout.arrangement).filter(|own| keep(saved.arrangement.is_some(), own.is_none())),
            panel: Some(is_open.then(|| self.explained.shown()))
                .filter(|own| keep(saved.panel.is_some(), own.is_none())),
            entry: shown_entry(&self.explained.matrices)
                .filter(|_| is_open && self.explained.shown() == Explanation::Matrices),
        }
    }

    /// True if the views of a figure with a file, or their arrangement, differ from the file.
    pub fn is_rearranged(&self) -> bool {
        let saved = self.desk.shown.figure().screen;
        let is_other = self.layout.shown != saved.pictures.unwrap_or([true; View::COUNT])
            || saved.arrangement.is_some_and(|saved| saved != self.layout.arrangement);
        // Changes by a presentation or a lesson are temporary.
        let is_lasting = self.desk.shown.path().is_some() && !self.desk.plays_lesson() && !self.settings.presentation;
        is_lasting && is_other
    }

    /// Stores the layout in the figure before another one takes its place.
    pub fn settle_layout(&mut self) {
        if self.is_rearranged() {
            let screen = self.screen();
            self.desk.shown.edit(|figure| figure.screen = screen);
        }
    }

    /// Leaves the figure's own explanations alone: closing one doesn't remove it from the figure.
    pub fn keep_what_it_explains(&mut self) {
        let (before, now) = (self.frame.open_panels, self.panels_now());
        self.frame.open_panels = OpenPanels {
            stages: before.stages && now.stages,
            painting: before.painting && now.painting,
            triangle: before.triangle && now.triangle,
            steps: before.steps && now.steps,
            order: before.order && now.order,
        };
    }

    /// The observers of the pictures that aren't the default ones. An observer that the user hasn't turned stays in
    /// place while the camera moves.
    fn observers_as_shown(&self) -> Observers {
        let mut observers = self.desk.shown.figure().observers;
        let figure = self.desk.shown.figure();
        let shot = Shot {
            ndc: self.settings.conventions.ndc,
            compared: self.compared().map(Arc::new),
            ..Shot::of_one(figure, &figure.scene)
        };
        for (view, observer, seen) in [
            (View::World, &mut observers.world, self.frame.seen.world),
            (View::Canonical, &mut observers.canonical, self.frame.seen.canonical),
        ] {
            if observer.is_some() || !self.layout.is_shown(view) {
                continue;
            }
            let [width, height] = self.frame.picture_sizes[view.index()];
            let size = Size { width, height, scale: self.frame.screen_scale };
            let labels = labels(self.settings.lang);
            let (camera, scene) = (self.desk.shown.camera(), self.scene_cache.scene());
            let own = Request::new(&shot, view, camera, scene, labels, size).observer_from(Viewpoint::default());
            *observer = seen.filter(|seen| Some(*seen) != own);
        }
        observers
    }

    /// As [`figure_as_shown`](Self::figure_as_shown), without the figure.
    pub fn as_seen(&mut self) -> Seen {
        let (document, figure) = (&self.desk.shown, self.desk.shown.figure());
        let shown = View::ALL.map(|view| self.layout.is_shown(view));
        let key = (document.version(), [figure.observers, self.frame.seen], shown, self.frame.picture_sizes);
        // Framing a picture takes too long for each frame.
        let mut kept = std::mem::take(&mut self.observers_shown);
        let observers = *kept.of((key, self.settings.conventions.ndc), |_| self.observers_as_shown());
        self.observers_shown = kept;
        Seen { observers, show: self.show_as_saved(), screen: self.screen() }
    }

    /// The displayed step. If motion is to be reduced, whole steps play one after the other, with nothing between.
    fn step_as_shown(&self) -> Option<ShownStep> {
        let step = self.shown().step?;
        let jumps = self.settings.reduce_motion && self.explained.steps.plays();
        Some(ShownStep { at: step.at.map(|at| if jumps { at.floor() } else { at }), ..step })
    }

    fn show_as_saved(&self) -> Show {
        let show = &self.desk.shown.figure().show;
        let answered = self.answered_camera().map(|camera| *camera.parameters());
        let ndc = Some(self.settings.conventions.ndc).filter(|ndc| *ndc != Ndc::default());
        let moved = show.moved.iter().chain(&self.frame.placed).cloned().collect();
        Show { answer: answered.or(show.answer), ndc, moved, step: self.step_as_shown(), ..show.clone() }
    }

    /// Forgets a triangle that has gone from the scene, but not one of an object whose file can't be read now.
    pub fn forget_missing(&mut self) {
        let (scene, spec) = (self.scene_cache.scene(), &self.desk.shown.figure().scene);
        let is_of = |name: &str, owner: &str| {
            name.strip_prefix(owner).is_some_and(|part| part.is_empty() || part.starts_with('/'))
        };
        let is_there = |name: &str, index: u32| match scene.place_of(name) {
            Some(place) => (index as usize) < scene.objects[place].mesh.triangles.len(),
            None => spec.objects.iter().any(|object| is_of(name, &object.name)),
        };
        let triangle = self.shown().triangle.as_ref();
        if triangle.is_some_and(|triangle| !is_there(&triangle.object, triangle.index)) {
            self.desk.shown.show_mut().triangle = None;
        }
    }

    /// The explanations in the pictures.
    pub fn shown(&self) -> &Show {
        &self.desk.shown.figure().show
    }

    /// The progress of the canonical picture on its way. `None` if no way is shown, or the camera has none.
    pub fn normalizing(&self) -> Option<Normalizing> {
        self.shown().step.and_then(|step| Normalizing::of(step, self.desk.shown.camera()))
    }

    /// True while the canonical picture is on its way. Then points aren't in their places in the canonical volume, and
    /// can't be picked.
    pub fn is_on_the_way(&self) -> bool {
        let camera = self.desk.shown.camera();
        self.shown().step.is_some_and(|step| steps::time_of(step, camera) < steps::end_of(step.way, camera))
    }

    /// The painted share of the image, if it's not all.
    pub fn painted_share(&self) -> Option<f64> {
        self.shown().painted
    }

    /// Paints this share of the image.
    pub fn paint_share(&mut self, share: f64) {
        let show = self.desk.shown.show_mut();
        show.painted = Some(share.clamp(0.0, 1.0)).filter(|share| *share < 1.0);
        // A partly painted picture hasn't been through any stage.
        show.stage = None;
    }

    /// The stage whose input and output a picture shows.
    pub fn shown_stage(&self) -> Option<Stage> {
        self.shown().stage
    }

    /// Shows or hides the input and output of a stage, for the picture whose stages are listed.
    pub fn toggle_stage(&mut self, stage: Stage) {
        let of = StagePicture(self.layout.strip_of);
        let show = self.desk.shown.show_mut();
        (show.stage, show.stage_of) = match show.stage {
            Some(shown) if shown == stage => (None, StagePicture::default()),
            _ => (Some(stage), of),
        };
        show.painted = None;
    }

    /// Lists the stages of a picture. The selected stage appears there.
    pub fn list_stages_of(&mut self, view: View) {
        self.layout.strip_of = view;
        let show = self.desk.shown.show_mut();
        if show.stage.is_some() {
            show.stage_of = StagePicture(view);
        }
    }

    /// Removes the displayed stage.
    pub fn release_stage(&mut self) {
        let show = self.desk.shown.show_mut();
        (show.stage, show.stage_of) = (None, StagePicture::default());
    }

    /// `[show]` after Esc, which removes the first of these: its stage, its triangle, and then everything that no open
    /// panel shows, but a file or another window has brought.
    fn without_shown(&self) -> Option<Show> {
        let (show, open) = (self.shown(), self.frame.open_panels);
        if show.stage.is_some() {
            return Some(Show { stage: None, stage_of: StagePicture::default(), ..show.clone() });
        }
        if show.triangle.is_some() {
            return Some(Show { triangle: None, ..show.clone() });
        }
        if self.settings.presentation {
            // Esc ends it, but the explanations that a figure was made for stay.
            return None;
        }
        let rest = Show {
            painted: show.painted.filter(|_| open.painting),
            step: show.step.filter(|_| open.steps),
            moved: Vec::new(),
            measure: Vec::new(),
            measure_of: None,
            answer: None,
            ..show.clone()
        };
        (rest != *show).then_some(rest)
    }

    /// True if [`release_shown`](Self::release_shown) has an explanation to release.
    pub fn can_release_shown(&self) -> bool {
        self.without_shown().is_some()
    }

    /// Releases an explanation, as Esc does. Returns false if there is none.
    pub fn release_shown(&mut self) -> bool {
        let Some(rest) = self.without_shown() else { return false };
        *self.desk.shown.show_mut() = rest;
        true
    }

    /// The pinned probe.
    pub fn pinned(&self) -> Option<Probe> {
        let image = self.desk.shown.figure().image;
        self.shown().probe.map(|probe| Probe::of(probe, self.desk.shown.camera(), image))
    }

    /// Pins a probe, or none.
    pub fn pin(&mut self, probe: Option<Probe>) {
        self.desk.shown.show_mut().probe = probe.map(|probe| match probe {
            Probe::Point(p) => ShownProbe::World(p),
            Probe::Window(p) => ShownProbe::Window(p),
        });
    }

    /// True if the window shows the reports of stages.
    pub fn accounts_for_stages(&self) -> bool {
        self.layout.strip || self.shows_explanation(Explanation::Stages)
    }

    /// True while an explanation is at the side.
    pub fn shows_explanation(&self, explanation: Explanation) -> bool {
        self.settings.panels().is_shown(Side::Explain) && self.explained.shown() == explanation
    }

    /// The picture to show if there is room for one: the subject of the open explanation.
    pub fn main_picture(&self) -> View {
        let wanted = match self.explained.shown() {
            _ if !self.settings.panels().is_shown(Side::Explain) => View::World,
            Explanation::Steps | Explanation::Conventions => View::Canonical,
            Explanation::Stages => self.layout.strip_of,
            Explanation::Triangle | Explanation::HiddenSurfaces | Explanation::Depth => View::Image,
            Explanation::Matrices
            | Explanation::Point
            | Explanation::Homogeneous
            | Explanation::Order
            | Explanation::Clipping
            | Explanation::Dialects
            | Explanation::Code
            | Explanation::Exercises
            | Explanation::Notes => View::World,
        };
        let is_shown = |view: &View| self.layout.is_shown(*view);
        [wanted].into_iter().chain(View::ALL).find(is_shown).unwrap_or(wanted)
    }

    fn panels_now(&self) -> OpenPanels {
        OpenPanels {
            stages: self.accounts_for_stages(),
            painting: self.shows_explanation(Explanation::HiddenSurfaces),
            triangle: self.shows_explanation(Explanation::Triangle),
            steps: self.shows_explanation(Explanation::Steps),
            order: self.shows_explanation(Explanation::Order),
        }
    }

    /// Removes the explanation of a panel that has been closed since the last frame, and shows that of one that has
    /// been opened.
    pub fn follow_panels(&mut self) {
        if let Some(ndc) = self.desk.shown.show_mut().ndc.take() {
            // A file's convention becomes that of the window.
            self.settings.conventions.ndc = ndc;
        }
        let now = self.panels_now();
        let before = std::mem::replace(&mut self.frame.open_panels, now);
        if before.stages && !now.stages {
            self.release_stage();
        }
        let way = self.explained.steps.way;
        let show = self.desk.shown.show_mut();
        if before.painting && !now.painting {
            show.painted = None;
        }
        if before.triangle && !now.triangle {
            show.triangle = None;
        }
        if before.order && !now.order {
            self.frame.placed.clear();
        }
        match (before.steps, now.steps) {
            (true, false) => show.step = None,
            (false, true) => show.step = show.step.or(Some(ShownStep { way, at: None })),
            _ => {}
        }
        if let Some(step) = show.step {
            self.explained.steps.way = step.way;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Decomposition;
    use crate::model::tests::model;

    #[test]
    fn a_step_that_is_played_without_motion_is_the_same_on_the_screen_and_in_a_file() {
        let mut model = model();
        let step = ShownStep { way: Decomposition::Notes, at: Some(1.6) };
        let step = model.explained.steps.play_or_hold(step, 0.0);
        model.desk.shown.show_mut().step = Some(step);
        for (reduce_motion, at) in [(false, 1.6), (true, 1.0)] {
            model.settings.reduce_motion = reduce_motion;
            let shown = Some(ShownStep { at: Some(at), ..step });
            assert_eq!(model.shot(Vec::new()).show.step, shown);
            assert_eq!((model.figure_as_shown().show.step, model.figure_to_save().show.step), (shown, shown));
        }
    }
}
