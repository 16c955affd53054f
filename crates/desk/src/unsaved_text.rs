//! Text of a lesson that its file doesn't have yet.

use std::path::PathBuf;

use crate::figure::Localized;
use crate::lessons::TaskText;

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
    pub task: TaskText,
}
