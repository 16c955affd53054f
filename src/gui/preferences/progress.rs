//! Progress in exercises, and typed answers: a file of its own beside the preferences, which can be read and deleted.
//!
//! A window merges its progress into the present content of the file: nothing of two windows is lost.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui;
use toml_edit::{DocumentMut, Value};

use super::answers::{self, NOTHING};
use super::shared_file::{Change, PATIENCE, Writing, locked, read};
use crate::exercises::Progress;
use crate::files::{self, FileError, Overwrite, disk};
use crate::gui::session::{Keeping, News};
use crate::gui::state::{Done, Message, State};

/// The progress of one window.
#[derive(Clone, Debug)]
struct ProgressJob {
    file: PathBuf,
    /// Typed answers: keys with their values as TOML.
    changed: BTreeMap<String, String>,
    done: Vec<Done>,
}

/// The result of a write.
#[derive(Debug)]
struct ProgressWritten {
    /// The progress of all windows.
    progress: Progress,
    /// The new place of a file that could not be read.
    set_aside: Option<PathBuf>,
}

/// The file as its two readers understand it.
fn understood(text: &str) -> Option<(DocumentMut, Progress)> {
    Some((text.parse().ok()?, Progress::read(text).ok()?))
}

impl Change for ProgressJob {
    type Written = ProgressWritten;

    fn is_empty(&self) -> bool {
        self.changed.is_empty() && self.done.is_empty()
    }

    /// Progress only ever grows.
    fn is_same(&self, other: &Self) -> bool {
        self.changed == other.changed && self.done.len() == other.done.len()
    }

    fn write(&self) -> Result<ProgressWritten, FileError> {
        let _lock = locked(&self.file)?;
        let ((before, mut progress), set_aside) = read(&self.file, understood)?;
        self.done.iter().for_each(|done| done.note(&mut progress));
        let mut document: DocumentMut = progress.to_toml().parse().unwrap_or_default();
        for (key, value) in &self.changed {
            match value.parse::<Value>() {
                Ok(_) if value == NOTHING => drop(document.remove(key)),
                Ok(value) => document[key.as_str()] = value.into(),
                Err(_) => {}
            }
        }
        let text = document.to_string();
        if text != before.to_string() {
            files::save(&self.file, text.as_bytes(), Overwrite::Writable)?;
        }
        Ok(ProgressWritten { progress, set_aside })
    }
}

/// The file of progress, and the part of this window in it.
pub(super) struct KeptProgress {
    file: PathBuf,
    writing: Writing<ProgressJob>,
    /// The answers typed in this window, as they are in the file.
    kept: BTreeMap<String, String>,
    news: Vec<News>,
}

impl KeptProgress {
    /// Loads the file in `folder`, and the answers in `preferences` from before there was one.
    pub(super) fn begin(folder: &Path, state: &mut State, preferences: &DocumentMut) -> Self {
        let file = folder.join("progress.toml");
        let mut news = Vec::new();
        let result = read(&file, understood);
        let writing = Writing::new("progress", result.is_err());
        match result {
            Ok(((document, progress), set_aside)) => {
                state.exercises.progress = progress;
                let typed = answers::read(&document).map(|(chosen, table)| (chosen, answers::typed(table)));
                state.exercises.typed.extend(typed);
                news.extend(set_aside.map(News::ProgressSetAside));
            }
            Err(error) => news.push(News::not_kept(Keeping::Progress, file.clone(), error)),
        }
        let kept = answers::values(state).collect();
        for (chosen, table) in answers::read(preferences) {
            if answers::is_solved(table) {
                state.exercises.note(Done::WasSolved(chosen.id.clone()));
            }
            state.exercises.typed.entry(chosen).or_insert_with(|| answers::typed(table));
        }
        state.exercises.file = Some(file.clone());
        Self { file, writing, kept, news }
    }

    /// Saves the progress, beside the window's thread. A failed write is repeated with the next progress.
    pub(super) fn keep(&mut self, ctx: &egui::Context, state: &mut State) {
        self.take(state, Duration::ZERO);
        if std::mem::take(&mut state.exercises.forgets) {
            self.forget(state);
            ctx.request_repaint();
        }
        if !self.writing.is_busy() {
            self.writing.ask(ctx, self.job(state));
        }
    }

    /// Saves the rest, before the window closes.
    pub(super) fn finish(&mut self, state: &mut State) {
        self.take(state, PATIENCE);
        let job = self.job(state);
        if !job.is_empty()
            && let Ok(written) = job.write()
        {
            self.took(state, job, written);
        }
    }

    /// True where all that was done is in the file.
    pub(super) fn is_written(&self, state: &State) -> bool {
        self.job(state).is_empty()
    }

    /// Whether it cannot be saved.
    pub(super) fn is_failing(&self) -> bool {
        self.writing.is_failing()
    }

    /// New messages about it, each once.
    pub(super) fn news(&mut self) -> Vec<News> {
        std::mem::take(&mut self.news)
    }

    /// The part that is not in the file yet.
    fn job(&self, state: &State) -> ProgressJob {
        let mut changed: BTreeMap<String, String> = answers::values(state).collect();
        changed.retain(|key, value| self.kept.get(key).map_or(NOTHING, String::as_str) != value);
        ProgressJob { file: self.file.clone(), changed, done: state.exercises.unwritten.clone() }
    }

    /// Takes the result of a write.
    pub(super) fn take(&mut self, state: &mut State, patience: Duration) {
        match self.writing.take(patience) {
            Some(Ok((job, written))) => self.took(state, job, written),
            Some(Err(error)) => self.news.push(News::not_kept(Keeping::Progress, self.file.clone(), error)),
            None => {}
        }
    }

    fn took(&mut self, state: &mut State, job: ProgressJob, ProgressWritten { progress, set_aside }: ProgressWritten) {
        self.kept.extend(job.changed);
        let exercises = &mut state.exercises;
        exercises.unwritten.drain(..job.done.len().min(exercises.unwritten.len()));
        exercises.progress = progress;
        exercises.unwritten.iter().for_each(|done| done.note(&mut exercises.progress));
        self.news.extend(set_aside.map(News::ProgressSetAside));
    }

    /// Forgets all of it. The file stays under another name, until that is done once more.
    fn forget(&mut self, state: &mut State) {
        self.take(state, PATIENCE);
        let aside = self.file.with_extension("bak");
        let moved = locked(&self.file).and_then(|_lock| disk::rename(&self.file, &aside).map_err(FileError::Write));
        match moved {
            Err(FileError::Write(error)) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return state.say(Message::File(self.file.clone(), error)),
            Ok(()) => state.say(Message::ProgressDeleted(aside)),
        }
        state.exercises.forget();
        self.kept.clear();
        self.writing.forget();
    }
}
