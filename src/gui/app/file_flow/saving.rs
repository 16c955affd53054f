//! The figure is written beside the window's thread, because a disk on a network may take seconds, or stall.

use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui;

use crate::figure::{Figure, update};
use crate::gui::kit::frames;
use camera_lab_desk::background::worker;
use camera_lab_desk::{Model, Revision, Theirs, Worker};
use camera_lab_files::{self as files, FigureFiles, FileChange, FileError, Overwrite, Renamed, disk};

/// Time that a frame waits for the file. On a disk of this machine it's written by then.
const PATIENCE: Duration = Duration::from_millis(if cfg!(test) { 60_000 } else { 200 });

/// Overwrites that the user has agreed to.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Agreed {
    /// This content of another program in the figure's file.
    pub theirs: Option<Theirs>,
    /// A read-only file.
    pub read_only: bool,
}

impl Agreed {
    /// The files that saving may replace.
    pub fn overwrite(&self) -> Overwrite {
        if self.read_only { Overwrite::ReadOnlyToo } else { Overwrite::Writable }
    }
}

/// A figure to write into a file.
#[derive(Clone, Debug)]
struct ToSave {
    path: PathBuf,
    figure: Figure,
    /// The text that was read or saved last.
    source: String,
    /// The folder that the names of files in the figure are relative to.
    folder: Option<PathBuf>,
    /// The files of the figure, if they are to be written too.
    with_files: Option<FigureFiles>,
    /// True if the file is the figure's own, so another program may have changed it.
    is_own: bool,
    agreed: Agreed,
}

/// The result.
#[derive(Debug)]
pub(super) enum Saved {
    /// Written: the figure as in the file, the new names of its files, and the text.
    Done(Box<(Figure, Renamed, String)>),
    /// Another program has changed the file. It's as it was.
    Changed(Theirs),
    /// The file is read-only.
    ReadOnly,
    /// The reason why it isn't written.
    Failed(FileError),
}

impl ToSave {
    fn run(&self) -> Result<Saved, FileError> {
        let Self { path, figure, source, folder, with_files, is_own, agreed } = self;
        if *is_own
            && let FileChange::Other(theirs) = files::look(path, source.as_bytes(), None)
            && agreed.theirs.as_ref() != Some(&theirs)
        {
            return Ok(Saved::Changed(theirs));
        }
        if !agreed.read_only && files::is_read_only(path) {
            return Ok(Saved::ReadOnly);
        }
        let (figure, renamed) = match with_files {
            None => files::for_figure_file(figure, folder.as_deref(), path.parent()),
            Some(files) => {
                let (figure, renamed, beside) = files::beside_figure(figure, files.clone(), path);
                for (path, bytes) in beside {
                    disk::create_folder(path.parent().unwrap_or(Path::new(""))).map_err(FileError::Write)?;
                    files::save(&path, &bytes, agreed.overwrite())?;
                }
                (figure, renamed)
            }
        };
        let text = update(source, &figure);
        files::save(path, text.as_bytes(), agreed.overwrite())?;
        Ok(Saved::Done(Box::new((figure, renamed, text))))
    }
}

/// The purpose of a save.
#[derive(Clone, Debug)]
pub(super) struct Save {
    pub(super) path: PathBuf,
    pub(super) agreed: Agreed,
    /// True if the files of the figure are written too.
    pub(super) with_files: bool,
    /// True if an intent of the user waits for it.
    pub(super) for_errand: bool,
}

impl Save {
    /// The figure into this file.
    pub(super) fn of(model: &Model, path: PathBuf, agreed: Agreed) -> Self {
        Self { path, agreed, with_files: false, for_errand: model.desk.errand().is_some() }
    }
}

/// A save that is under way.
#[derive(Debug)]
struct RunningSave {
    worker: Worker<ToSave, Saved>,
    save: Save,
    /// The document in it; `None` if it has been saved elsewhere meanwhile.
    document: Option<Revision>,
}

/// The files being written. One that stalls keeps no other from being written.
#[derive(Debug)]
pub struct Saving {
    running: Vec<RunningSave>,
    /// Saves that wait for another one of the same file, each with its document.
    queued: Vec<(Save, Revision)>,
    /// Time that a frame waits for a file. Tests have more of it.
    pub patience: Duration,
}

impl Default for Saving {
    fn default() -> Self {
        Self { running: Vec::new(), queued: Vec::new(), patience: PATIENCE }
    }
}

impl Saving {
    /// Starts writing the figure of the window. The caller has made sure that the file isn't being written already.
    pub(super) fn begin(&mut self, ctx: &egui::Context, model: &Model, mut save: Save) {
        let document = &model.desk.shown;
        // Without its picture, the files that it carries would be lost. A browser has no folder for them, so there the
        // window keeps them.
        save.with_files |= !(document.carried().is_empty() || model.in_browser);
        let job = ToSave {
            path: save.path.clone(),
            figure: model.figure_to_save(),
            source: document.source().to_owned(),
            folder: document.folder().map(Path::to_owned),
            with_files: save.with_files.then(|| document.files()),
            is_own: document.path() == Some(&save.path),
            agreed: save.agreed.clone(),
        };
        let write = async |job: ToSave, _: &crate::progress::Progress| job.run().unwrap_or_else(Saved::Failed);
        let mut worker = Worker::new("save", crate::clock::now, move || write);
        worker.ask(&frames(ctx), 0, job);
        self.running.push(RunningSave { worker, save, document: Some(document.id()) });
    }

    /// Saves a document once the file isn't being written any more. The last request counts. An intent waits for it if
    /// one waited for any.
    pub(super) fn queue(&mut self, save: Save, document: Revision) {
        let before = self.queued.iter().position(|(other, of)| other.path == save.path && *of == document);
        let before = before.is_some_and(|place| self.queued.remove(place).0.for_errand);
        self.queued.push((Save { for_errand: save.for_errand || before, ..save }, document));
    }

    /// A queued save of this document whose file isn't being written any more.
    pub(super) fn queued(&mut self, document: Revision) -> Option<Save> {
        let is_next = |(save, of): &(Save, Revision)| *of == document && !self.writes(&save.path);
        let place = self.queued.iter().position(is_next)?;
        Some(self.queued.remove(place).0)
    }

    /// The number of files being written.
    #[cfg(test)]
    pub(super) fn count(&self) -> usize {
        self.running.len()
    }

    /// True while a file is being written.
    pub(super) fn writes(&self, path: &Path) -> bool {
        self.running.iter().any(|running| running.save.path == path)
    }

    /// True if an intent of the user waits for a file.
    pub(super) fn serves_errand(&self) -> bool {
        let queued = self.queued.iter().map(|(save, _)| save);
        self.running.iter().map(|running| &running.save).chain(queued).any(|save| save.for_errand)
    }

    /// A result with its purpose and its document, once it's there. `None` in place of the document if it has been
    /// saved elsewhere since. Waits up to `patience` for the last one.
    pub(super) fn take(&mut self, patience: Duration) -> Option<(Save, Option<Revision>, Saved)> {
        let last = self.running.len().checked_sub(1)?;
        let (k, outcome) = self.running.iter_mut().enumerate().find_map(|(k, running)| {
            let [done] = running.worker.take(if k == last { patience } else { Duration::ZERO });
            Some((k, done?.outcome))
        })?;
        let bug = || Saved::Failed(FileError::Write(std::io::Error::other("a bug in this program")));
        let RunningSave { save, document, .. } = self.running.remove(k);
        for before in self.running.iter_mut().take(k).filter(|before| before.document == document) {
            // Its file is no longer that of the document.
            before.document = None;
        }
        Some((save, document, outcome.unwrap_or_else(bug)))
    }

    /// The files being written, and the time that each has taken.
    pub(super) fn running(&self) -> impl Iterator<Item = (&Path, worker::Running)> {
        self.running.iter().filter_map(|running| Some((running.save.path.as_path(), running.worker.running()?)))
    }
}
