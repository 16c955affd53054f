//! Kills programs that save, and examines the files they leave: short here, long with `.ci/kill SECONDS`.
//!
//! Each test starts this same binary again as the program that is killed ([`victim`]).
#![expect(clippy::expect_used, clippy::print_stderr, reason = "tests may fail, and say what they leave out")]

mod disk;
mod saving;
#[cfg(feature = "gui")]
mod sessions;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// The task of the victim.
const WORK: &str = "CAMERA_LAB_KILL_WORK";

/// The folder of the victim.
const FOLDER: &str = "CAMERA_LAB_KILL_FOLDER";

/// Does the task of the test that has started it, until it is killed.
#[test]
fn victim() {
    let (Ok(work), Ok(folder)) = (std::env::var(WORK), std::env::var(FOLDER)) else { return };
    let folder = PathBuf::from(folder);
    match work.as_str() {
        "save" => saving::save_repeatedly(&folder, usize::MAX),
        "save some" => saving::save_repeatedly(&folder, saving::SOME),
        #[cfg(feature = "gui")]
        "session" => sessions::keep_for_ever(&folder),
        other => panic!("no work is called {other}"),
    }
}

/// A folder that is there for one test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("camera-lab-kill-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder for temporary files");
        Self(path)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Held while a program starts, and while a test takes locks of files.
///
/// Between `fork` and `exec` a child shares the open files of this process, and so a lock that another test has just
/// released stays taken for a moment.
fn no_program_starts() -> MutexGuard<'static, ()> {
    static STARTS: Mutex<()> = Mutex::new(());
    STARTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A program that is killed when this goes.
struct Victim(Child);

impl Victim {
    fn start(work: &str, folder: &Path) -> Self {
        Self::start_with(&[], work, folder)
    }

    /// Started by another program, which may be `strace` with its arguments.
    fn start_with(by: &[&str], work: &str, folder: &Path) -> Self {
        let own = std::env::current_exe().expect("a test binary");
        let mut arguments = by.iter().map(std::ffi::OsString::from).chain([own.into()]);
        let mut command = Command::new(arguments.next().expect("a program"));
        command.args(arguments).args(["--exact", "victim", "--nocapture"]);
        command.env(WORK, work).env(FOLDER, folder).stdout(Stdio::null()).stderr(Stdio::null());
        let _alone = no_program_starts();
        Self(command.spawn().expect("started"))
    }

    /// Waits for its end.
    fn end(mut self) -> ExitStatus {
        self.0.wait().expect("a child")
    }
}

impl Drop for Victim {
    fn drop(&mut self) {
        // On Unix this is SIGKILL, which no program can catch.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Waits until there is something at `path`.
fn wait_for(path: &Path) {
    let since = Instant::now();
    while !path.exists() {
        assert!(since.elapsed() < Duration::from_secs(60), "{} does not come", path.display());
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// How long programs are killed at random, by each test.
fn time_to_kill() -> Duration {
    let seconds = std::env::var("CAMERA_LAB_KILL_SECONDS").ok().and_then(|text| text.parse().ok());
    Duration::from_secs(seconds.unwrap_or(2))
}

/// Moments that follow each other without a pattern. They are the same in every run, except for the machine's own
/// delays.
fn moments() -> impl Iterator<Item = Duration> {
    let mut state = 20_261_121_u64;
    std::iter::repeat_with(move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        Duration::from_micros((state >> 33) % 60_000)
    })
}
