//! Work that takes longer than half a second, reported under the pictures, and cancelled with Esc.

use std::time::Duration;

use eframe::egui::{self, Key, Modifiers};

use super::Canvas;
use camera_lab_desk::{Model, Running};
use camera_lab_words::window::{canvas as words, progress, scenes};

/// Work shorter than this isn't reported.
const MAX_WAIT: Duration = Duration::from_millis(500);

/// Work that takes long.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LongWork {
    /// The activity, its purpose, and the way to cancel it.
    pub(super) text: String,
    /// The finished share, if known.
    pub(super) share: Option<f32>,
}

/// True if work is reported and can be cancelled.
pub(in crate::gui) fn is_long(running: Running) -> bool {
    running.time >= MAX_WAIT
}

impl LongWork {
    /// The longest-running long work.
    pub(super) fn of(canvas: &Canvas, model: &Model, of_files: &[(String, Running)]) -> Option<Self> {
        let lang = model.settings.lang;
        let mesh = model.scene_cache.running().map(|(path, running)| {
            (format!("{} {}", scenes::texts(lang).loading, crate::sanitize::escaped(path)), running)
        });
        let picture = canvas.rendering.running().and_then(|running| {
            let view = canvas.shot.pictures.get(running.slot)?.kind;
            Some((words::texts(lang).view(view).to_owned(), running))
        });
        let of_files = of_files.iter().map(|(text, running)| (text.clone(), *running));
        let all = of_files.chain(mesh).chain(picture).filter(|(_, running)| is_long(*running));
        let (what, Running { now, .. }) = all.max_by_key(|(_, running)| running.time)?;
        // The name, which may be long, comes last, so that it can be elided.
        let doing = now.map(|(doing, share)| format!("{} · ", progress::progress(lang, doing, share)));
        let text = format!("{}{} · {what}", doing.unwrap_or_default(), progress::texts(lang).cancel);
        Some(Self { text, share: now.and_then(|(_, share)| share) })
    }
}

impl Canvas {
    /// Cancels long work of the pictures if Esc is pressed and has no other meaning. Returns true if it's to cancel
    /// long work with files too.
    pub(in crate::gui) fn listen_for_cancel(
        &mut self,
        ctx: &egui::Context,
        model: &mut Model,
        of_files: &[(String, Running)],
    ) -> bool {
        let busy = ctx.text_edit_focused() || ctx.input(|input| input.pointer.any_down());
        if busy || LongWork::of(self, model, of_files).is_none() {
            return false;
        }
        let pressed = ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        if pressed {
            if self.rendering.running().is_some_and(is_long) {
                self.rendering.cancel();
            }
            if model.scene_cache.running().is_some_and(|(_, running)| is_long(running)) {
                model.scene_cache.cancel();
            }
        }
        pressed
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::expect_used, reason = "a test may fail by panicking")]

    use std::path::PathBuf;

    use super::*;
    use crate::gui::export::{Export, ExportKind, Exported, Exporting, Task};
    use crate::gui::{Start, State};
    use crate::progress::{Activity, Progress};
    use camera_lab_desk::export_error::ExportError;
    use camera_lab_files::Overwrite;
    use camera_lab_words::Lang;

    /// Paints, and doesn't end by itself.
    fn endless() -> impl AsyncFnMut(Task, &Progress) -> Exported {
        async |_, progress: &Progress| {
            progress.begin(Activity::Painting, 4);
            progress.advance(3);
            while !progress.is_cancelled() {
                std::thread::yield_now();
            }
            Err(ExportError::Cancelled)
        }
    }

    #[test]
    fn long_work_shows_after_half_a_second_and_escape_cancels_it() {
        let (ctx, mut state) = (egui::Context::default(), State::new(Start::default()).expect("a camera"));
        let mut canvas = Canvas::default();
        let path = PathBuf::from("a.png");
        let export = Export::new([[4, 3]; 3], 1.0);
        let (what, to) = (ExportKind::Pictures(export), (path.clone(), Overwrite::Writable));
        let task = Task::new(&state.model, &state.family, what, to);
        let exporting = Exporting::with(&ctx, task, endless);
        state.file_flow.exporting.push(exporting);
        let mut press = |state: &mut State| {
            let key = egui::Event::Key {
                key: Key::Escape,
                physical_key: None,
                pressed: true,
                repeat: false,
                modifiers: Modifiers::NONE,
            };
            let input = egui::RawInput { events: vec![key], ..egui::RawInput::default() };
            let mut output = ctx.run_ui(input, |ui| {
                let exporting = state.file_flow.running(Lang::En);
                if canvas.listen_for_cancel(ui.ctx(), &mut state.model, &exporting) {
                    state.file_flow.cancel(is_long);
                }
            });
            output.textures_delta.clear();
        };
        // It's too early, so nothing is reported, and Escape has another meaning.
        press(&mut state);
        std::thread::sleep(MAX_WAIT + Duration::from_millis(100));
        let told = LongWork::of(&Canvas::default(), &state.model, &state.file_flow.running(Lang::En)).expect("told");
        assert_eq!(told.share, Some(0.75));
        assert!(told.text.contains("a.png") && told.text.contains("painting… 75 %"), "{}", told.text);
        assert!(told.text.contains("Esc cancels"), "{}", told.text);
        press(&mut state);
        let since = std::time::Instant::now();
        let done = loop {
            if let Some(done) = state.file_flow.exported().pop() {
                break done;
            }
            assert!(since.elapsed().as_secs() < 60);
        };
        assert!(done.0 == path && matches!(done.1, Err(ExportError::Cancelled)));
        assert_eq!(LongWork::of(&Canvas::default(), &state.model, &state.file_flow.running(Lang::En)), None);
    }
}
