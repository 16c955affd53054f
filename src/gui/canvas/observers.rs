//! The observers of the pictures in a frame: as requested by a button or a key, as in the figure, or fitted.

use eframe::egui::Ui;

use super::{Canvas, Pane, orbit};
use crate::figure::Observer;
use crate::gui::state::{ObserverChange, State};
use crate::views::{Request, View, observer_in};

impl Canvas {
    /// Decides from where the three-dimensional pictures are seen in this frame.
    pub(super) fn settle_observers(&mut self, ui: &Ui, state: &mut State, panes: &[Pane]) {
        let wanted = state.observer_change.take();
        let asked = self.asked.take();
        let steady = ui.input(|i| i.pointer.any_down());
        for pane in panes.iter().filter(|pane| pane.view != View::Image) {
            let (view, i) = (pane.view, pane.view.index());
            let request = self.request(state, view, pane.rect.size);
            let asked = asked.filter(|(of, _)| *of == view || state.layout.linked).map(|(_, change)| change);
            match wanted.or(asked) {
                Some(change) => self.change_observer(state, &request, change),
                None => self.fit_again(state, &request),
            }
            let written = observer_in(&state.document.figure().observers, view);
            let subject = state.scene_cache.subject();
            let seen = written.or_else(|| self.autos[i].observer(&request, subject, steady));
            orbit::set(&mut self.seen, view, seen);
        }
        self.shot.observers = self.seen;
    }

    fn change_observer(&mut self, state: &mut State, request: &Request, change: ObserverChange) {
        let (view, i) = (request.view, request.view.index());
        self.autos[i].forget();
        let observer = orbit::changed(request, change);
        self.framed[i] = observer.map(|observer| (observer, request.size));
        orbit::set(state.document.observers_mut(), view, observer);
        // A section has a side of its own: from another one, the world is seen in space.
        if view == View::World && matches!(change, ObserverChange::From(_)) && request.shot.look.world.section {
            state.document.edit(|figure| figure.world.section = false);
        }
    }

    /// What a button or a key has framed is framed again where the picture has another size; what was turned by hand
    /// stays.
    fn fit_again(&mut self, state: &mut State, request: &Request) {
        let (view, i) = (request.view, request.view.index());
        let Some((framed, _)) = self.framed[i].filter(|(_, size)| *size != request.size) else { return };
        let before = state.document.figure().observers;
        if observer_in(&before, view) != Some(framed) {
            return;
        }
        let fitted = request.fitted(&framed);
        self.framed[i] = fitted.map(|fitted| (fitted, request.size));
        orbit::set(state.document.observers_mut(), view, fitted);
        state.views.framed_again(before, state.document.figure().observers);
    }

    /// Looks at a picture from somewhere else.
    pub(super) fn turn(&mut self, state: &mut State, view: View, observer: Observer) {
        orbit::set(&mut self.seen, view, Some(observer));
        self.shot.observers = self.seen;
        orbit::set(state.document.observers_mut(), view, Some(observer));
    }
}
