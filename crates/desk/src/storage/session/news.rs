//! Messages about the storage of windows. Each one appears once, until the user has closed it or it no longer holds.

use std::io::ErrorKind;
use std::mem::{Discriminant, discriminant};
use std::path::PathBuf;

use camera_lab_files::FileError;

/// A message about the storage of windows. Each is shown once.
#[derive(Debug)]
pub enum News {
    /// The session was restored.
    Restored,
    /// The session was restored without these keys of the figure, which are unknown here. The whole is in this file.
    RestoredInPart(Vec<String>, PathBuf),
    /// The session can't be read, and is in this file.
    Damaged(PathBuf),
    /// This session file can't be opened or written.
    Unusable(PathBuf, FileError),
    /// Another window has taken it up, or removed it.
    Taken,
    /// Too many windows have left sessions, so this one has no slot.
    NoSlot,
    /// The preferences can't be read, and are in this file.
    PreferencesSetAside(PathBuf),
    /// The progress in exercises can't be read, and is in this file.
    ProgressSetAside(PathBuf),
    /// Some data can't be stored.
    NotKept(NotKept),
    /// Nothing can be stored, because the system names no folder for it.
    NoHome,
}

/// A kind of stored data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeping {
    /// The session of this window, against a crash.
    Session,
    /// The preferences.
    Preferences,
    /// The progress in exercises.
    Progress,
}

/// The kinds of data that can't be stored, all for one cause.
#[derive(Debug)]
pub struct NotKept {
    what: Vec<Keeping>,
    /// The first unusable file or folder.
    pub path: PathBuf,
    /// The reason why it's unusable.
    pub error: FileError,
}

/// The cause of a failure, in reading or writing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Cause {
    System(ErrorKind),
    Other(Discriminant<FileError>),
}

impl NotKept {
    fn cause(&self) -> Cause {
        match &self.error {
            FileError::Read(error) | FileError::Write(error) => {
                Cause::System(crate::scene::system_kind(error.kind(), error.raw_os_error()))
            }
            other => Cause::Other(discriminant(other)),
        }
    }

    /// True if this kind can't be stored.
    pub fn is_about(&self, what: Keeping) -> bool {
        self.what.contains(&what)
    }
}

impl News {
    /// A failure of this kind, with its reason.
    pub fn not_kept(what: Keeping, path: PathBuf, error: FileError) -> Self {
        Self::NotKept(NotKept { what: vec![what], path, error })
    }
}

/// The present messages.
#[derive(Debug, Default)]
pub struct NewsList {
    shown: Vec<News>,
    /// Causes that the user has closed, and true if the message named the session, whose loss is the gravest.
    closed: Vec<(Cause, bool)>,
}

impl NewsList {
    /// The messages, in the order of arrival.
    pub fn iter(&self) -> impl Iterator<Item = &News> {
        self.shown.iter()
    }

    /// True if there are no messages.
    pub fn is_empty(&self) -> bool {
        self.shown.is_empty()
    }

    /// Adds a message. A failure with a cause already shown joins that message. A closed one doesn't come back.
    pub fn tell(&mut self, news: News) {
        let News::NotKept(not_kept) = news else { return self.shown.push(news) };
        let cause = not_kept.cause();
        let session = not_kept.is_about(Keeping::Session);
        if self.closed.iter().any(|(closed, of_session)| *closed == cause && *of_session >= session) {
            return;
        }
        let same = |news: &&mut News| matches!(news, News::NotKept(shown) if shown.cause() == cause);
        match self.shown.iter_mut().find(same) {
            Some(News::NotKept(shown)) => {
                let new = not_kept.what.into_iter().filter(|what| !shown.what.contains(what));
                shown.what.extend(new.collect::<Vec<_>>());
            }
            _ => self.shown.push(News::NotKept(not_kept)),
        }
    }

    /// Closes a message for good, because the user has read it.
    pub fn close(&mut self, index: usize) {
        if index < self.shown.len()
            && let News::NotKept(closed) = self.shown.remove(index)
        {
            self.closed.push((closed.cause(), closed.is_about(Keeping::Session)));
        }
    }

    /// True if a message is that the session was restored.
    pub fn has_restored(&self) -> bool {
        self.shown.iter().any(|news| matches!(news, News::Restored))
    }

    /// Closes the message that the session was restored.
    pub fn forget_restored(&mut self) {
        self.shown.retain(|news| !matches!(news, News::Restored));
    }

    /// This kind is stored again. Its messages go, and later ones are new.
    pub fn is_kept(&mut self, what: Keeping) {
        for news in &mut self.shown {
            if let News::NotKept(shown) = news {
                shown.what.retain(|other| *other != what);
            }
        }
        self.shown.retain(|news| match news {
            News::NotKept(shown) => !shown.what.is_empty(),
            News::NoSlot => what != Keeping::Session,
            _ => true,
        });
        if what == Keeping::Session {
            self.closed.retain(|(_, of_session)| !of_session);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io;

    use super::*;

    fn not_kept(what: Keeping, kind: ErrorKind) -> News {
        News::not_kept(what, PathBuf::from("/home/me"), FileError::Write(kind.into()))
    }

    fn told(list: &NewsList) -> Vec<Vec<Keeping>> {
        let what = |news: &News| if let News::NotKept(not_kept) = news { not_kept.what.clone() } else { Vec::new() };
        list.iter().map(what).collect()
    }

    #[test]
    fn news_with_one_cause_is_one_line_and_does_not_come_back() {
        use Keeping::{Preferences, Progress, Session};
        let mut list = NewsList::default();
        list.tell(not_kept(Preferences, ErrorKind::PermissionDenied));
        list.tell(News::not_kept(Session, "x".into(), FileError::Read(ErrorKind::PermissionDenied.into())));
        list.tell(not_kept(Progress, ErrorKind::PermissionDenied));
        list.tell(not_kept(Session, ErrorKind::PermissionDenied));
        assert_eq!(told(&list), [[Preferences, Session, Progress]]);
        list.tell(not_kept(Preferences, ErrorKind::StorageFull));
        assert_eq!(list.iter().count(), 2);
        list.close(0);
        for what in [Preferences, Progress, Session] {
            list.tell(not_kept(what, ErrorKind::PermissionDenied));
        }
        assert_eq!(told(&list), [[Preferences]]);
        // A possible loss of work is shown, even if other messages were closed before.
        list.close(0);
        list.tell(not_kept(Session, ErrorKind::StorageFull));
        assert_eq!(told(&list), [[Session]]);
        list.close(7);
    }

    #[test]
    fn a_successful_save_clears_its_news_and_can_fail_again() {
        let mut list = NewsList::default();
        let full = || not_kept(Keeping::Session, ErrorKind::StorageFull);
        list.tell(full());
        list.tell(not_kept(Keeping::Preferences, ErrorKind::StorageFull));
        list.tell(News::NoSlot);
        list.tell(News::Restored);
        list.is_kept(Keeping::Session);
        assert_eq!(told(&list), [vec![Keeping::Preferences], vec![]]);
        list.is_kept(Keeping::Preferences);
        assert!(matches!(list.shown[..], [News::Restored]));
        list.tell(full());
        list.close(1);
        list.tell(full());
        assert_eq!(list.iter().count(), 1);
        list.is_kept(Keeping::Session);
        list.tell(full());
        assert_eq!(list.iter().count(), 2);
        let error = io::Error::other("?");
        list.tell(News::not_kept(Keeping::Session, "x".into(), FileError::Write(error)));
        assert_eq!(list.iter().count(), 3);
    }
}
