//! Files read beside the window's thread, because one on a network may take seconds.

use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui;

use crate::gui::app::state::State;
use crate::gui::kit::frames;
use camera_lab_desk::{Model, Revision, Running, Worker};

/// Time that a frame waits for a file. Files on a disk of this machine are there by then.
const PATIENCE: Duration = Duration::from_millis(if cfg!(test) { 60_000 } else { 50 });

/// Goes on with a file that has been read. The last argument is true if the window's figure has changed since the file
/// was asked for.
pub(super) type Take = Box<dyn FnOnce(&egui::Context, &mut State, bool) + Send>;

/// Reads a file, beside the window's thread.
type Read = Box<dyn FnOnce() -> Take + Send>;

/// The file being read.
#[derive(Debug)]
pub struct Reading {
    worker: Worker<Read, Take>,
    /// Its path, and the document with its state when the file was requested. `None` if the user doesn't want it.
    asked: Option<(PathBuf, (Revision, Revision))>,
    /// Time that a frame waits for a file. Tests have more of it.
    pub patience: Duration,
}

impl Default for Reading {
    fn default() -> Self {
        let worker =
            Worker::new("file", crate::clock::now, || async |read: Read, _: &crate::progress::Progress| read());
        Self { worker, asked: None, patience: PATIENCE }
    }
}

/// The displayed document, and its state.
fn now(model: &Model) -> (Revision, Revision) {
    (model.desk.shown.id(), model.desk.shown.revision())
}

impl Reading {
    /// Starts reading a file. The one being read before isn't wanted any more.
    pub(super) fn begin(&mut self, ctx: &egui::Context, model: &Model, path: PathBuf, read: Read) {
        self.asked = Some((path, now(model)));
        if self.worker.is_pending(0) {
            // The file before may stall.
            self.worker = self.worker.restarted();
        }
        self.worker.ask(&frames(ctx), 0, read);
    }

    /// The way to go on with the file once it's there, and if the window's figure has changed since the request.
    /// `None` if the user has gone on to another figure.
    pub(super) fn take(&mut self, model: &Model, patience: Duration) -> Option<(Take, bool)> {
        let [done] = self.worker.take(patience);
        let take = done?.outcome?;
        let (_, before) = self.asked.take()?;
        let now = now(model);
        (before.0 == now.0).then_some((take, before != now))
    }

    /// The file being read, and the time that it has taken.
    pub(super) fn running(&self) -> Option<(&Path, Running)> {
        let (path, _) = self.asked.as_ref()?;
        Some((path, self.worker.running()?))
    }

    /// Gives it up. The system can't be stopped, but the window ignores the result.
    pub(super) fn cancel(&mut self) {
        self.asked = None;
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::gui::Start;
    use crate::gui::app::file_flow::questions::Dialog;
    use crate::gui::app::file_flow::{begin, poll};
    use crate::testing::{Directory, Stall};
    use camera_lab_desk::action::Intent;

    /// Opens a file that takes longer than a frame. Meanwhile the user does something else.
    fn opened_slowly(name: &str, meanwhile: fn(&egui::Context, &mut State)) -> (PathBuf, State) {
        let (ctx, mut state) = (egui::Context::default(), State::new(Start::default()).unwrap());
        let path = std::env::temp_dir().join(format!("camera-lab-slow-{name}-{}.toml", std::process::id()));
        std::fs::write(&path, "[camera]\nnear = 0.5\n").unwrap();
        state.file_flow.reading.patience = Duration::ZERO;
        let stall = Stall::of(&path);
        begin(&ctx, &mut state, Intent::OpenPath(path.clone()));
        assert_eq!(state.model.desk.shown.path(), None, "the window goes on while it's read");
        meanwhile(&ctx, &mut state);
        drop(stall);
        let since = std::time::Instant::now();
        while state.file_flow.reading.asked.is_some() {
            assert!(since.elapsed().as_secs() < 60);
            std::thread::sleep(Duration::from_millis(5));
            ctx.run_ui(egui::RawInput::default(), |ui| poll(ui.ctx(), &mut state)).textures_delta.clear();
        }
        std::fs::remove_file(&path).unwrap();
        (path, state)
    }

    #[test]
    fn a_slow_file_is_shown_once_it_is_there() {
        let (path, state) = opened_slowly("shown", |_, _| {});
        assert_eq!(state.model.desk.shown.path(), Some(&path));
    }

    #[test]
    fn changes_made_while_a_file_is_read_are_asked_about() {
        let change =
            |_: &egui::Context, state: &mut State| state.model.desk.shown.edit(|figure| figure.image.width = 300);
        let (path, state) = opened_slowly("changed", change);
        assert_eq!(state.model.desk.shown.figure().image.width, 300);
        assert_eq!(state.file_flow.dialog, Some(Dialog::Unsaved));
        assert_eq!(state.model.desk.errand(), Some(&Intent::OpenPath(path)));
    }

    #[test]
    fn a_file_that_stalls_does_not_keep_another_from_being_opened() {
        let directory = Directory::new("two-files");
        let [slow, quick] = ["slow.toml", "quick.toml"].map(|name| directory.path().join(name));
        for path in [&slow, &quick] {
            std::fs::write(path, "[camera]\nnear = 0.5\n").unwrap();
        }
        let (ctx, mut state) = (egui::Context::default(), State::new(Start::default()).unwrap());
        let stall = Stall::of(&slow);
        state.file_flow.reading.patience = Duration::ZERO;
        begin(&ctx, &mut state, Intent::OpenPath(slow));
        assert_eq!(state.model.desk.shown.path(), None);
        state.file_flow.reading.patience = Duration::from_secs(60);
        begin(&ctx, &mut state, Intent::OpenPath(quick.clone()));
        assert_eq!(state.model.desk.shown.path(), Some(&quick));
        drop(stall);
    }

    #[test]
    fn a_figure_opened_while_a_file_is_read_stays() {
        let (_, state) = opened_slowly("late", |ctx, state| begin(ctx, state, Intent::Shipped("house")));
        assert_eq!(state.model.desk.shown.shipped_name(), Some("house"));
    }
}
