//! The session of a window that didn't close. The figure is saved after every change, and restored at the next start,
//! or offered in a list.
//!
//! Each window has a slot of its own, marked by a lock on a file, which the system releases when the program ends,
//! however it ends. A restore is recorded before it begins, so a session that didn't survive it isn't restored
//! automatically again. An unreadable session is set aside, not deleted.

mod news;
mod session_file;
mod writer;

use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

pub use news::{Keeping, News, NewsList, NotKept};
pub use session_file::Restored;
use session_file::SessionFile;
pub use writer::Kept;
use writer::Writer;

use crate::document::{Document, Seen};
use crate::figure::Localized;
use crate::history::Revision;
use crate::limits::{MAX_SESSION_BYTES, MAX_SESSIONS};
use crate::{Wake, clock};
use camera_lab_files::disk::{self, Lock};
use camera_lab_files::{self as files, FileError, Overwrite};

/// If the window has shown a figure for this long, the figure doesn't keep the program from starting.
const SURVIVED: Duration = if cfg!(target_arch = "wasm32") {
    // A page is often reloaded, and it ends without notice.
    Duration::from_secs(2)
} else {
    Duration::from_secs(60)
};

/// After so long writing is tried again.
const RETRY: Duration = Duration::from_secs(5);

/// The session of a window that did not close.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOver {
    /// Its slot.
    pub slot: usize,
    /// The file of its figure, if it has one.
    pub path: Option<PathBuf>,
    /// The time of its last write.
    pub written: Option<SystemTime>,
    /// True if the program ended during the restore, or soon after.
    pub did_not_survive: bool,
}

/// The sessions of this user: that of this window, and those left by others.
#[derive(Debug, Default)]
pub struct Sessions {
    folder: PathBuf,
    own: Option<Writer>,
    /// The document in `own`.
    shown: Option<Revision>,
    /// The hidden documents that the window holds.
    others: Vec<(Revision, Writer)>,
    left: Vec<LeftOver>,
    news: Vec<News>,
    /// When the figure of this window was restored, until it has proved harmless.
    restored_at: Option<Duration>,
    /// When writing failed last.
    failed_at: Option<Duration>,
    /// True if the lack of a slot, or the failure of writing, has been reported.
    told: bool,
}

impl Sessions {
    /// Looks for sessions in `folder`. With `restore`, returns the latest that can be restored without a question.
    pub fn begin(folder: &Path, restore: bool) -> (Self, Option<Restored>) {
        let mut sessions = Self { folder: folder.to_owned(), ..Self::default() };
        files::remove_left_over(folder);
        sessions.look();
        let safe = sessions.left.iter().filter(|left| !left.did_not_survive);
        let latest = safe.max_by_key(|left| left.written).map(|left| left.slot).filter(|_| restore);
        let restored = latest.and_then(|slot| sessions.take_up(slot, false));
        if sessions.own.is_none() {
            sessions.own = sessions.free_slot();
        }
        (sessions, restored)
    }

    /// The sessions of other windows that are still undecided.
    pub fn left(&self) -> &[LeftOver] {
        &self.left
    }

    /// New messages, each once.
    pub fn news(&mut self) -> Vec<News> {
        std::mem::take(&mut self.news)
    }

    /// Restores the session of a slot, at the user's request.
    pub fn restore(&mut self, slot: usize) -> Option<Restored> {
        self.take_up(slot, true)
    }

    /// Deletes the session of a slot, at the user's request.
    pub fn discard(&mut self, slot: usize) {
        self.left.retain(|left| left.slot != slot);
        if let Ok(Some(_lock)) = self.lock(slot) {
            let _ = disk::remove(&self.file(slot));
        }
        // There may be a slot for this window now.
        if self.own.is_none() {
            self.failed_at = None;
        }
    }

    /// Saves the window's documents: the displayed one, if closing it would lose something, and each of the `others`,
    /// which all have changes. Deletes the stored session of a document that the window no longer holds. Call it when
    /// no pointer or key is held.
    pub fn keep(&mut self, window: &dyn Wake, shown: Kept<'_>, others: &[&Document]) {
        let now = clock::now();
        self.follow(shown.document.id(), others);
        let has_slot = |document: &&Document| self.others.iter().any(|(id, _)| *id == document.id());
        let all_have_slots = others.iter().all(has_slot);
        match self.own.as_mut().and_then(Writer::take) {
            Some(Ok(())) if all_have_slots => (self.failed_at, self.told) = (None, false),
            Some(Err(error)) => self.fail(error),
            Some(Ok(())) | None => {}
        }
        let due = self.failed_at.is_none_or(|failed| now.saturating_sub(failed) >= RETRY);
        // Once for each time that it's due. If it fails now, it waits again.
        let retries = due && self.failed_at.take_if(|_| due).is_some();
        if self.own.is_none() && due && shown.is_worth_keeping() {
            self.own = self.free_slot();
        }
        self.keep_others(window, others, due);
        if self.restored_at.is_some_and(|at| now.saturating_sub(at) >= SURVIVED) {
            self.restored_at = None;
        }
        let restoring = self.restored_at.is_some();
        if let Some(own) = &mut self.own
            && (!own.is_up_to_date(shown, restoring) || retries)
        {
            own.ask(window, shown, restoring);
        }
        // Nothing else may request the frame when the time comes.
        for (since, length) in [(self.restored_at, SURVIVED), (self.failed_at, RETRY)] {
            if let Some(since) = since.filter(|_| shown.is_worth_keeping()) {
                window.wake_after(length.saturating_sub(now.saturating_sub(since)));
            }
        }
    }

    /// Assigns each document that the window holds its own slot again. The slots of all others become free.
    fn follow(&mut self, shown: Revision, others: &[&Document]) {
        let is_held = |id: Revision| others.iter().any(|document| document.id() == id);
        if self.shown.is_some_and(|before| before != shown && is_held(before)) {
            self.others.extend(self.shown.zip(self.own.take()));
        }
        if let Some(index) = self.others.iter().position(|(id, _)| *id == shown) {
            let (_, writer) = self.others.swap_remove(index);
            self.own.replace(writer).into_iter().for_each(Writer::forget);
        }
        self.shown = Some(shown);
        self.others.extract_if(.., |(id, _)| !is_held(*id)).for_each(|(_, writer)| writer.forget());
    }

    /// Saves the hidden documents, each once for each change.
    fn keep_others(&mut self, window: &dyn Wake, others: &[&Document], due: bool) {
        for document in others {
            let index = self.others.iter().position(|(id, _)| *id == document.id());
            let writer = match index {
                Some(index) => self.others.swap_remove(index).1,
                // One refusal speaks for all.
                None if due && self.failed_at.is_none() => match self.free_slot() {
                    Some(writer) => writer,
                    None => continue,
                },
                None => continue,
            };
            self.others.push((document.id(), writer));
            let Some((_, writer)) = self.others.last_mut() else { continue };
            if let Some(Err(error)) = writer.take() {
                writer.ask_again();
                self.fail(error);
            } else if due && !writer.has(document) {
                let seen = Seen::of(document.figure());
                writer.ask(window, Kept { document, seen: &seen, is_work: true, text: None }, false);
            }
        }
    }

    /// Deletes the stored session of this window, because it has been saved, or discarded.
    pub fn forget(&mut self) {
        self.shown = None;
        let others = self.others.drain(..).map(|(_, writer)| writer);
        self.own.take().into_iter().chain(others).for_each(Writer::forget);
    }

    fn file(&self, slot: usize) -> PathBuf {
        self.folder.join(format!("session-{slot}.json"))
    }

    /// The lock of a slot, unless a window has it.
    fn lock(&self, slot: usize) -> io::Result<Option<Lock>> {
        disk::try_lock(&self.folder.join(format!("session-{slot}.lock")))
    }

    fn look(&mut self) {
        for slot in 0..MAX_SESSIONS {
            let file = self.file(slot);
            // Without a file the slot isn't even touched.
            if !disk::exists(&file) {
                continue;
            }
            // Held during the reading, so that no window that starts in between takes it for its own.
            let Ok(Some(_lock)) = self.lock(slot) else { continue };
            let written = disk::written(&file);
            let kept = match files::read_at_most(&file, MAX_SESSION_BYTES) {
                Ok(bytes) => SessionFile::read(&bytes),
                Err(FileError::TooLarge(_)) => None,
                Err(error) => {
                    self.news.push(News::Unusable(file, error));
                    continue;
                }
            };
            match kept {
                Some(kept) => {
                    let left = LeftOver { slot, path: kept.named(), written, did_not_survive: kept.restoring };
                    self.left.push(left);
                }
                None => self.put_aside(&file),
            }
        }
    }

    /// The first empty slot. If there is none, a message says so.
    fn free_slot(&mut self) -> Option<Writer> {
        if let Err(error) = disk::create_folder(&self.folder) {
            self.fail(FileError::Write(error));
            return None;
        }
        for slot in 0..MAX_SESSIONS {
            let file = self.file(slot);
            if disk::may_exist(&file) {
                continue;
            }
            match self.lock(slot) {
                Ok(Some(lock)) => return Some(Writer::new(file, lock)),
                Ok(None) => {}
                // The locks of the others would fail too.
                Err(error) => {
                    self.fail(FileError::Write(error));
                    return None;
                }
            }
        }
        self.failed_at = Some(clock::now());
        if !std::mem::replace(&mut self.told, true) {
            self.news.push(News::NoSlot);
        }
        None
    }

    fn fail(&mut self, error: FileError) {
        self.failed_at = Some(clock::now());
        if !std::mem::replace(&mut self.told, true) {
            self.news.push(News::not_kept(Keeping::Session, self.folder.clone(), error));
        }
    }

    /// True if the session of this window can't be stored.
    pub fn is_failing(&self) -> bool {
        self.told
    }

    /// Makes the session of a slot that of this window. Unless the user has `asked` for it, only if the restore can be
    /// recorded first.
    fn take_up(&mut self, slot: usize, asked: bool) -> Option<Restored> {
        let file = self.file(slot);
        let lock = self.lock(slot).ok().flatten().filter(|_| disk::exists(&file));
        let Some(lock) = lock else {
            self.left.retain(|left| left.slot != slot);
            self.news.push(News::Taken);
            return None;
        };
        let bytes = match files::read_at_most(&file, MAX_SESSION_BYTES) {
            Ok(bytes) => bytes,
            Err(error) => {
                self.news.push(News::Unusable(file, error));
                return None;
            }
        };
        if let Some(noted) = SessionFile::noted(&bytes)
            && let Err(error) = files::save(&file, &noted, Overwrite::Writable)
            && !asked
        {
            self.fail(error);
            return None;
        }
        self.left.retain(|left| left.slot != slot);
        let Some(restored) = SessionFile::read(&bytes).and_then(|kept| kept.restore()) else {
            self.put_aside(&file);
            return None;
        };
        let unknown = restored.unknown.clone();
        self.news.push(if unknown.is_empty() {
            News::Restored
        } else {
            let aside = aside(&file);
            match disk::write(&aside, &bytes) {
                Ok(()) => News::RestoredInPart(unknown, aside),
                Err(error) => News::Unusable(aside, FileError::Write(error)),
            }
        });
        if let Some(own) = self.own.take() {
            own.forget();
        }
        self.own = Some(Writer::new(file, lock));
        self.restored_at = Some(clock::now());
        Some(restored)
    }

    fn put_aside(&mut self, file: &Path) {
        let aside = aside(file);
        self.news.push(match disk::rename(file, &aside) {
            Ok(()) => News::Damaged(aside),
            Err(_) => News::Damaged(file.to_owned()),
        });
    }
}

/// The most files that are set aside under one name. A disk that doesn't answer may have each of them.
const MOST_ASIDE: u32 = 100;

/// The name under which a file is set aside, which no other file has.
pub fn aside(file: &Path) -> PathBuf {
    let first = file.with_extension("damaged");
    let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let others = (1..MOST_ASIDE).map(|number| file.with_file_name(format!("{stem}-{number}.damaged")));
    std::iter::once(first.clone()).chain(others).find(|path| !disk::may_exist(path)).unwrap_or(first)
}

/// The text of a lesson that isn't in its file. A session stores it, and a window continues with it after a crash.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnsavedText {
    /// The file.
    pub path: PathBuf,
    /// The step whose texts were written, from 0.
    pub step: usize,
    /// The text of the file as the window last read or wrote it.
    pub text: String,
    /// Title, text and notes of the step, then title, sentence and minutes of the lesson, as typed.
    pub words: [Localized; 6],
    /// The task of the step, as typed.
    pub task: crate::lessons::TaskText,
}

#[cfg(test)]
mod tests;
