//! The built program, run as a user would.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::{env, fs};

/// A directory of one test's own in which the program runs. It's gone at the test's end.
pub(crate) struct Bench {
    directory: PathBuf,
}

/// The result of a run of the program.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) status: Option<i32>,
    pub(crate) out: Vec<u8>,
    pub(crate) err: String,
}

impl Bench {
    pub(crate) fn new(name: &str) -> Self {
        let directory = env::temp_dir().join(format!("camera-lab-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&directory);
        fs::create_dir_all(&directory).expect("a temporary directory");
        Self { directory }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.directory.join(name)
    }

    pub(crate) fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, bytes).expect("a file is written");
        path
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The names of the files, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let files = fs::read_dir(&self.directory).expect("the directory is there");
        let mut names: Vec<_> = files.flatten().filter_map(|file| file.file_name().into_string().ok()).collect();
        names.sort();
        names
    }

    /// The program in this directory, in English, without a display.
    pub(crate) fn command<A: AsRef<OsStr>>(&self, arguments: &[A]) -> Command {
        let mut command = Command::new(Path::new(env!("CARGO_BIN_EXE_camera-lab")));
        command.args(arguments).current_dir(&self.directory).stdin(Stdio::null()).env("LC_ALL", "en_US.UTF-8");
        for display in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET", "LANGUAGE"] {
            command.env_remove(display);
        }
        command
    }

    pub(crate) fn run<A: AsRef<OsStr>>(&self, arguments: &[A]) -> Run {
        Run::of(&mut self.command(arguments))
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.directory);
    }
}

impl Run {
    pub(crate) fn of(command: &mut Command) -> Self {
        let Output { status, stdout, stderr } = command.output().expect("the program runs");
        Self { status: status.code(), out: stdout, err: String::from_utf8(stderr).expect("UTF-8") }
    }

    /// Holds that the input was refused as the contract says, and gives the message.
    #[track_caller]
    pub(crate) fn refused(&self, status: i32) -> &str {
        assert_eq!(self.status, Some(status), "{}", self.err);
        assert!(self.out.is_empty(), "{:?}", String::from_utf8_lossy(&self.out));
        assert!(!self.err.contains("panicked"), "{}", self.err);
        let message = self.err.trim();
        assert!(!message.is_empty() && !message.contains("\n\n"), "{message:?}");
        message
    }

    /// Holds that all went well, quietly, and gives the standard output.
    #[track_caller]
    pub(crate) fn done(&self) -> &[u8] {
        assert_eq!((self.status, self.err.as_str()), (Some(0), ""));
        &self.out
    }

    /// The JSON on standard output.
    #[track_caller]
    pub(crate) fn json(&self) -> serde_json::Value {
        serde_json::from_slice(self.done()).expect("JSON")
    }
}
