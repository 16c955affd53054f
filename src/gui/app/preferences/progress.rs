//! Progress in exercises, and typed answers. They have a file of their own beside the preferences, which the user can
//! read and delete.
//!
//! A window merges its progress into the present content of the file, so two windows lose nothing of each other.

use std::collections::BTreeMap;
use std::time::Duration;

use eframe::egui;
use toml_edit::{DocumentMut, Value};

use crate::exercises::Progress;
use crate::gui::app::preferences::answers::{self, NOTHING};
use crate::gui::kit::frames;
use crate::gui::learn::Learn;
use crate::gui::learn::exercises::state::{Chosen, Done, Typed};
use camera_lab_desk::storage::shared_file::{Change, MAX_WAIT};
use camera_lab_desk::{Keeping, Message, Model, News, SharedFile};

/// The progress of one window.
#[derive(Clone, Debug)]
struct ProgressJob {
    /// Typed answers: keys with their values as TOML.
    changed: BTreeMap<String, String>,
    done: Vec<Done>,
}

impl Change for ProgressJob {
    /// As its two readers understand it.
    type Content = (DocumentMut, Progress);
    type Merged = Progress;

    fn understood(text: &str) -> Option<Self::Content> {
        Some((text.parse().ok()?, Progress::read(text).ok()?))
    }

    fn is_empty(&self) -> bool {
        self.changed.is_empty() && self.done.is_empty()
    }

    /// Progress only ever grows.
    fn is_same(&self, other: &Self) -> bool {
        self.changed == other.changed && self.done.len() == other.done.len()
    }

    fn merge(&self, (_, mut progress): Self::Content) -> (String, Progress) {
        self.done.iter().for_each(|done| done.note(&mut progress));
        let mut document: DocumentMut = progress.to_toml().parse().unwrap_or_default();
        for (key, value) in &self.changed {
            match value.parse::<Value>() {
                Ok(_) if value == NOTHING => drop(document.remove(key)),
                Ok(value) => document[key.as_str()] = value.into(),
                Err(_) => {}
            }
        }
        (document.to_string(), progress)
    }
}

/// The file of progress, and the part of this window in it.
pub(in crate::gui) struct KeptProgress {
    file: SharedFile<ProgressJob>,
    /// The answers typed in this window, as in the file.
    kept: BTreeMap<String, String>,
    /// The typed answers in the form of the file, with their sources. Most frames change none.
    values: (BTreeMap<Chosen, Typed>, BTreeMap<String, String>),
}

impl KeptProgress {
    /// Loads the file in `folder`, and the answers in `preferences` from before there was one.
    pub(in crate::gui) fn begin(folder: &std::path::Path, learn: &mut Learn, preferences: &DocumentMut) -> Self {
        let (file, content) =
            SharedFile::open(folder.join("progress.toml"), "progress", (Keeping::Progress, News::ProgressSetAside));
        if let Some((document, progress)) = content {
            learn.exercises.progress = progress;
            let typed = answers::read(&document).map(|(chosen, table)| (chosen, answers::typed(table)));
            learn.exercises.typed.extend(typed);
        }
        let kept: BTreeMap<_, _> = answers::values(learn).collect();
        let values = (learn.exercises.typed.clone(), kept.clone());
        for (chosen, table) in answers::read(preferences) {
            if answers::is_solved(table) {
                learn.exercises.note(Done::WasSolved(chosen.id.clone()));
            }
            learn.exercises.typed.entry(chosen).or_insert_with(|| answers::typed(table));
        }
        learn.exercises.file = Some(file.path.clone());
        Self { file, kept, values }
    }

    /// Saves the progress, beside the window's thread. A failed write is repeated with the next progress.
    pub(in crate::gui) fn keep(&mut self, ctx: &egui::Context, model: &mut Model, learn: &mut Learn) {
        self.take(learn, Duration::ZERO);
        if std::mem::take(&mut learn.exercises.forgets) {
            self.forget(model, learn);
            ctx.request_repaint();
        }
        let job = self.job(learn);
        self.file.ask(&frames(ctx), job);
    }

    /// Saves the rest, before the window closes.
    pub(in crate::gui) fn finish(&mut self, learn: &mut Learn) {
        self.take(learn, MAX_WAIT);
        let job = self.job(learn);
        if let Some(progress) = self.file.finish(&job) {
            self.took(learn, job, progress);
        }
    }

    /// True if all progress is in the file.
    pub(in crate::gui) fn is_written(&mut self, learn: &Learn) -> bool {
        self.job(learn).is_empty()
    }

    /// True if it can't be saved.
    pub(in crate::gui) fn is_failing(&self) -> bool {
        self.file.is_failing()
    }

    /// New messages about it, each once.
    pub(in crate::gui) fn news(&mut self) -> Vec<News> {
        self.file.news()
    }

    /// The part that isn't in the file yet.
    fn job(&mut self, learn: &Learn) -> ProgressJob {
        if self.values.0 != learn.exercises.typed {
            self.values = (learn.exercises.typed.clone(), answers::values(learn).collect());
        }
        let is_new = |(key, value): &(&String, &String)| self.kept.get(*key).map_or(NOTHING, String::as_str) != *value;
        let changed = self.values.1.iter().filter(is_new).map(|(key, value)| (key.clone(), value.clone())).collect();
        ProgressJob { changed, done: learn.exercises.unwritten.clone() }
    }

    /// Takes the result of a write.
    pub(in crate::gui) fn take(&mut self, learn: &mut Learn, patience: Duration) {
        if let Some((job, progress)) = self.file.take(patience) {
            self.took(learn, job, progress);
        }
    }

    fn took(&mut self, learn: &mut Learn, job: ProgressJob, progress: Progress) {
        self.kept.extend(job.changed);
        let exercises = &mut learn.exercises;
        exercises.unwritten.drain(..job.done.len().min(exercises.unwritten.len()));
        exercises.progress = progress;
        exercises.unwritten.iter().for_each(|done| done.note(&mut exercises.progress));
    }

    /// Forgets all of it. The file stays under another name until this is done once more.
    fn forget(&mut self, model: &mut Model, learn: &mut Learn) {
        self.take(learn, MAX_WAIT);
        let aside = self.file.path.with_extension("bak");
        match self.file.put_aside(&aside) {
            Err(error) => return model.say(Message::File(self.file.path.clone(), error)),
            Ok(true) => model.say(Message::ProgressDeleted(aside)),
            Ok(false) => {}
        }
        learn.exercises.forget();
        self.kept.clear();
    }
}
