//! A limit of time for threads that mustn't wait for a file, such as the window's. A network disk that has gone away
//! answers late or never, and no program can make it hurry.

use std::io;
use std::path::Path;
use std::time::Duration;
#[cfg(not(target_arch = "wasm32"))]
pub use threads::{before_each_file, limit_waiting, reader_wait};

/// The longest wait of a window's thread for a file.
pub const WINDOW_WAIT: Duration = Duration::from_secs(2);

/// Does `work` with the file of this path. A thread with a limit gives up after it, and the work ends on its own.
///
/// # Errors
/// [`io::ErrorKind::TimedOut`].
pub(crate) fn in_time<T: Send + 'static>(path: &Path, work: impl FnOnce(&Path) -> T + Send + 'static) -> io::Result<T> {
    #[cfg(target_arch = "wasm32")]
    return Ok(work(path));
    #[cfg(not(target_arch = "wasm32"))]
    threads::in_time(path, work)
}

#[cfg(not(target_arch = "wasm32"))]
mod threads {
    use std::cell::Cell;
    use std::collections::BTreeSet;
    use std::path::{Path, PathBuf};
    use std::sync::mpsc::{TryRecvError, channel};
    use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
    use std::time::Duration;
    use std::{io, thread};

    /// Called before any work with a file.
    static BEFORE: OnceLock<fn(&Path)> = OnceLock::new();

    /// Calls a function before any work with a file, so that a test can make one stall. The first one stays.
    pub fn before_each_file(before: fn(&Path)) {
        BEFORE.get_or_init(|| before);
    }

    /// The longest wait of a thread that reads the files of a figure one after the other, for one of them. A test that
    /// makes files stall has less time.
    pub fn reader_wait() -> Duration {
        Duration::from_millis(if BEFORE.get().is_some() { 200 } else { 10_000 })
    }

    thread_local! {
        /// The longest wait of this thread for a file.
        static LIMIT: Cell<Option<Duration>> = const { Cell::new(None) };
    }

    /// The files for which a thread has waited in vain, while the work with them goes on.
    static STALLED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

    /// While a file stalls, the part of the limit for others in its folder. They may stall too, and all the waits add
    /// up.
    const PART: u32 = 20;

    fn stalled() -> MutexGuard<'static, BTreeSet<PathBuf>> {
        // A set of paths is as good after a panic.
        STALLED.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Work with a file. When it ends, also with a panic, the file doesn't stall any more.
    struct WatchedWork(PathBuf);

    impl Drop for WatchedWork {
        fn drop(&mut self) {
            stalled().remove(&self.0);
        }
    }

    /// From now on this thread waits for a file at most so long, and not at all for one that has stalled and still
    /// does.
    pub fn limit_waiting(limit: Duration) {
        LIMIT.set(Some(limit));
    }

    pub(super) fn in_time<T: Send + 'static>(
        path: &Path,
        work: impl FnOnce(&Path) -> T + Send + 'static,
    ) -> io::Result<T> {
        let work = move |path: &Path| {
            BEFORE.get().iter().for_each(|before| before(path));
            work(path)
        };
        let Some(limit) = LIMIT.get() else { return Ok(work(path)) };
        let limit = {
            let stalled = stalled();
            if stalled.contains(path) {
                return Err(io::ErrorKind::TimedOut.into());
            }
            let is_beside = |other: &PathBuf| other.parent() == path.parent();
            if stalled.iter().any(is_beside) { limit / PART } else { limit }
        };
        let (sender, receiver) = channel();
        let own = WatchedWork(path.to_owned());
        thread::Builder::new().name("file".to_owned()).spawn(move || {
            // The thread that wanted it may have given up.
            let _ = sender.send(work(&own.0));
        })?;
        receiver.recv_timeout(limit).or_else(|_| {
            let mut stalled = stalled();
            // It may have come in this moment. Otherwise its thread removes the path later, since it needs the lock.
            receiver.try_recv().map_err(|error| match error {
                TryRecvError::Empty => {
                    stalled.insert(path.to_owned());
                    io::ErrorKind::TimedOut.into()
                }
                TryRecvError::Disconnected => io::Error::other("the work with the file has failed"),
            })
        })
    }
}
