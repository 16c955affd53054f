//! The system's file dialogs, on a thread of their own, because they block.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::time::{Duration, Instant};

use eframe::egui;

/// Where no portal and no zenity runs, the answer comes at once (10 ms, on a busy machine some hundreds) and looks like a
/// cancellation. Nobody reads a dialog and closes it this fast; if somebody does, the question for a path does no harm.
const TOO_FAST: Duration = Duration::from_millis(600);

/// What to ask for.
#[derive(Clone, Debug)]
pub struct Question {
    /// True: a file that may not exist yet.
    pub save: bool,
    /// The title of the dialog.
    pub title: &'static str,
    /// What the files are called.
    pub filter: &'static str,
    /// Their endings.
    pub endings: &'static [&'static str],
    /// The name that is proposed.
    pub name: String,
    /// Where the dialog starts.
    pub folder: Option<PathBuf>,
}

/// What came back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// A path.
    Chosen(PathBuf),
    /// The dialog was closed.
    Cancelled,
    /// There is no dialog on this system.
    Unavailable,
}

/// A dialog that is open.
#[derive(Debug)]
pub struct Asking {
    answer: Receiver<(Option<PathBuf>, Duration)>,
}

impl Asking {
    /// Opens the dialog; `ctx` is woken when it is closed.
    #[must_use]
    pub fn start(ctx: &egui::Context, question: Question) -> Self {
        let (send, answer) = channel();
        let ctx = ctx.clone();
        let mut dialog = rfd::AsyncFileDialog::new()
            .set_title(question.title)
            .set_file_name(question.name)
            .add_filter(question.filter, question.endings);
        if let Some(folder) = question.folder {
            dialog = dialog.set_directory(folder);
        }
        // The future is made here: some systems insist on the main thread for that.
        type Chosen = std::pin::Pin<Box<dyn Future<Output = Option<rfd::FileHandle>> + Send>>;
        let chosen: Chosen = if question.save { Box::pin(dialog.save_file()) } else { Box::pin(dialog.pick_file()) };
        let since = Instant::now();
        std::thread::spawn(move || {
            let path = pollster::block_on(chosen).map(|file| file.path().to_owned());
            // Nobody waits any more when the window has been closed.
            let _ = send.send((path, since.elapsed()));
            ctx.request_repaint();
        });
        Self { answer }
    }

    /// The answer, once there is one.
    #[must_use]
    pub fn poll(&self) -> Option<Answer> {
        match self.answer.try_recv() {
            Ok((Some(path), _)) => Some(Answer::Chosen(path)),
            Ok((None, took)) if took < TOO_FAST => Some(Answer::Unavailable),
            Ok((None, _)) => Some(Answer::Cancelled),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Answer::Unavailable),
        }
    }
}
