//! The observers of the pictures in a frame, as requested by a button or a key, as in the figure, or fitted.

use eframe::egui::Ui;

use super::auto_observer::Moment;
use super::orbit;
use crate::figure::Observer;
use crate::gui::views::{Canvas, Pane};
use crate::views::{View, observer_in};
use camera_lab_desk::{Message, Model, ObserverChange};

impl Canvas {
    /// Decides the observers of the three-dimensional pictures in this frame.
    pub(in crate::gui::views) fn settle_observers(&mut self, ui: &Ui, model: &mut Model, panes: &mut [Pane]) {
        let wanted = model.frame.observer_change.take();
        let asked = self.asked.take();
        let moment = Moment {
            now: ui.input(|input| input.time),
            on_the_way: ui.input(|input| input.pointer.any_down()),
            still: model.settings.reduce_motion,
            loading: !model.scene_cache.loading().is_empty(),
        };
        for pane in panes.iter_mut().filter(|pane| pane.view != View::Image) {
            let asked = asked.filter(|(of, _)| *of == pane.picture || model.layout.linked).map(|(_, change)| change);
            match wanted.or(asked) {
                Some(change) => self.change_observer(model, pane, change),
                None => self.fit_again(model, pane),
            }
            let written = observer_in(&model.desk.shown.figure().observers, pane.view);
            let subject = model.scene_cache.subject();
            let auto = &mut self.pictures[pane.picture].auto;
            let found = if written.is_none() { auto.observer(&pane.request, subject, moment) } else { None };
            if found.is_some_and(|found| found.glides) {
                ui.request_repaint();
            }
            if found.is_some_and(|found| found.goes_back) {
                model.say(Message::WentBack(pane.view));
            }
            let seen = written.or(found.map(|found| found.observer));
            self.shot.pictures[pane.picture].observer = seen;
            pane.request.observer = seen;
        }
    }

    /// The observer of a picture.
    pub(in crate::gui::views) fn seen(&self, picture: usize) -> Option<Observer> {
        self.shot.pictures.get(picture)?.observer
    }

    fn change_observer(&mut self, model: &mut Model, pane: &Pane, change: ObserverChange) {
        let (view, request, picture) = (pane.view, &pane.request, &mut self.pictures[pane.picture]);
        picture.auto.forget();
        let observer = orbit::changed(request, change);
        picture.framed = observer.map(|observer| (observer, request.size));
        orbit::set(model.desk.shown.observers_mut(), view, observer);
        // A section has a side of its own. From another one, the world is shown in space.
        if view == View::World && matches!(change, ObserverChange::From(_)) && request.shot.look.world.section {
            model.desk.shown.edit(|figure| figure.world.section = false);
        }
    }

    /// Repeats the framing by a button or a key when the picture changes its size. An observer turned by hand stays.
    fn fit_again(&mut self, model: &mut Model, pane: &Pane) {
        let (view, request, picture) = (pane.view, &pane.request, &mut self.pictures[pane.picture]);
        let Some((framed, _)) = picture.framed.filter(|(_, size)| *size != request.size) else { return };
        let before = model.desk.shown.figure().observers;
        if observer_in(&before, view) != Some(framed) {
            return;
        }
        let fitted = request.fitted(&framed);
        picture.framed = fitted.map(|fitted| (fitted, request.size));
        orbit::set(model.desk.shown.observers_mut(), view, fitted);
        model.views.framed_again(before, model.desk.shown.figure().observers);
    }

    /// Looks at a picture from somewhere else.
    pub(in crate::gui::views) fn turn(&mut self, model: &mut Model, picture: usize, observer: Observer) {
        let Some(turned) = self.shot.pictures.get_mut(picture) else { return };
        turned.observer = Some(observer);
        orbit::set(model.desk.shown.observers_mut(), turned.kind, Some(observer));
    }
}
