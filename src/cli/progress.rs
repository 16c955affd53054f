//! Progress messages of long commands.

use std::io::{self, IsTerminal as _, Write};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use crate::progress::Progress;
use camera_lab_words::Lang;
use camera_lab_words::window::progress as words;

/// Delay before the first message.
const MAX_WAIT: Duration = Duration::from_millis(500);
/// Interval between messages.
const STEP: Duration = Duration::from_millis(100);

/// Does `work`. On a terminal, a line of standard error shows its progress if it takes longer than half a second.
pub(super) fn watched<T>(lang: Lang, work: impl FnOnce(&Progress) -> T) -> T {
    if io::stderr().is_terminal() { told(lang, &mut io::stderr(), MAX_WAIT, work) } else { work(&Progress::default()) }
}

fn told<T>(lang: Lang, out: &mut (impl Write + Send), patience: Duration, work: impl FnOnce(&Progress) -> T) -> T {
    let progress = Progress::default();
    let (done, waits) = mpsc::channel::<()>();
    thread::scope(|scope| {
        let seen = progress.clone();
        let teller = move || {
            let mut wait = patience;
            while waits.recv_timeout(wait) == Err(RecvTimeoutError::Timeout) {
                wait = STEP;
                if let Some((doing, share)) = seen.now() {
                    // Nothing depends on it, and a failure can't be reported anywhere.
                    let _ = write!(out, "\r\x1b[K{}", words::progress(lang, doing, share)).and_then(|()| out.flush());
                }
            }
            if wait == STEP {
                let _ = write!(out, "\r\x1b[K").and_then(|()| out.flush());
            }
        };
        scope.spawn(teller);
        let result = work(&progress);
        drop(done);
        result
    })
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::progress::Activity;

    #[test]
    fn progress_is_printed_only_if_work_is_long_and_is_cleared_afterwards() {
        let told_of = |patience, work: fn(&Progress)| {
            let mut out = Vec::new();
            told(Lang::En, &mut out, patience, work);
            String::from_utf8(out).unwrap()
        };
        assert_eq!(told_of(Duration::from_secs(60), |_| ()), "");
        let text = told_of(Duration::from_millis(1), |progress| {
            progress.begin(Activity::Painting, 4);
            progress.advance(1);
            thread::sleep(Duration::from_millis(300));
        });
        assert!(text.contains("\r\x1b[Kpainting… 25 %") && text.ends_with("\r\x1b[K"), "{text:?}");
    }
}
