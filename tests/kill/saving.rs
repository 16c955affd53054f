//! Files that are saved while the program is killed.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime};

use camera_lab_files::{Overwrite, save};

use crate::{Folder, Victim, moments, no_program_starts, time_to_kill, wait_for};

/// Lines of a text: enough for several writes to the disk.
const LINES: usize = 20_000;

fn text(number: usize) -> String {
    format!("number {number}\n").repeat(LINES)
}

/// True for a text that was saved as a whole.
fn is_whole(bytes: &[u8]) -> bool {
    let Ok(all) = std::str::from_utf8(bytes) else { return false };
    let Some(first) = all.lines().next() else { return false };
    all.lines().count() == LINES && all.ends_with('\n') && all.lines().all(|line| line == first)
}

/// So many times, for a program that is not killed from outside.
pub(crate) const SOME: usize = 8;

pub(crate) fn save_repeatedly(folder: &Path, times: usize) {
    for number in 0..times {
        save(&folder.join("a.toml"), text(number).as_bytes(), Overwrite::Writable).expect("saved");
    }
}

/// The files that a kill has left: a whole file, or beside a file that is written in place a whole copy of its new
/// content.
/// The next save leaves nothing of it.
fn check(folder: &Folder, in_place: bool, how: &str) {
    let path = folder.file("a.toml");
    let others: Vec<_> = fs::read_dir(&folder.0)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "tmp"))
        .collect();
    let whole = is_whole(&fs::read(&path).expect("a file"));
    let copy = others.iter().any(|other| fs::read(other).is_ok_and(|bytes| is_whole(&bytes)));
    assert!(whole || (in_place && copy), "{how}: the file is torn");
    for other in others {
        // As if three seconds had passed: if its process is known to be gone, it need not be older.
        let file = File::options().write(true).open(other).expect("a file");
        let age = Duration::from_secs(if Path::new("/proc/self").exists() { 3 } else { 100 });
        file.set_modified(SystemTime::now() - age).expect("possible");
    }
    save(&path, text(0).as_bytes(), Overwrite::Writable).expect("saved");
    let mut names: Vec<_> =
        fs::read_dir(&folder.0).expect("a folder").map(|e| e.expect("an entry").file_name()).collect();
    names.retain(|name| name != "other name.toml");
    assert_eq!(names, ["a.toml"], "{how}");
}

#[test]
fn a_file_is_whole_whenever_the_program_is_killed() {
    let folder = Folder::new("save");
    let (since, mut kills) = (Instant::now(), 0);
    for moment in moments().take_while(|_| since.elapsed() < time_to_kill()) {
        let victim = Victim::start("save", &folder.0);
        wait_for(&folder.file("a.toml"));
        std::thread::sleep(moment);
        drop(victim);
        check(&folder, false, &format!("killed after {moment:?}"));
        kills += 1;
    }
    eprintln!("killed {kills} times while saving");
    assert!(kills > 0);
}

#[test]
fn a_file_with_two_names_is_whole_or_has_a_whole_copy_beside_it() {
    let folder = Folder::new("in-place");
    save(&folder.file("a.toml"), text(0).as_bytes(), Overwrite::Writable).expect("saved");
    if fs::hard_link(folder.file("a.toml"), folder.file("other name.toml")).is_err() {
        eprintln!("left out: there are no hard links here");
        return;
    }
    let since = Instant::now();
    for moment in moments().take_while(|_| since.elapsed() < time_to_kill()) {
        let victim = Victim::start("save", &folder.0);
        std::thread::sleep(Duration::from_millis(20) + moment);
        drop(victim);
        check(&folder, true, &format!("killed after {moment:?}"));
        assert_eq!(fs::read(folder.file("other name.toml")).expect("there"), text(0).as_bytes());
    }
}

/// True if `strace` can kill another program at a system call.
fn can_trace() -> bool {
    let _alone = no_program_starts();
    let traced = Command::new("strace")
        .args(["-f", "-qq", "-e", "trace=none", "-e", "inject=execve:signal=SIGUSR1:when=99", "true"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    traced.is_ok_and(|status| status.success())
}

#[test]
fn a_file_is_whole_after_a_kill_at_a_system_call() {
    if !can_trace() {
        eprintln!("left out: strace is not there, or may not trace");
        return;
    }
    let folder = Folder::new("calls");
    let mut killed = 0;
    for call in ["openat", "write", "fsync", "fchmod", "rename", "renameat", "renameat2", "unlink"] {
        for when in [1, 2, 3, 20, 40] {
            save(&folder.file("a.toml"), text(0).as_bytes(), Overwrite::Writable).expect("saved");
            let inject = format!("inject={call}:signal=SIGKILL:when={when}");
            let by = ["strace", "-f", "-qq", "-o", "/dev/null", "-e", &format!("trace={call}"), "-e", &inject];
            // Some calls are not made, or not so often: then it comes to its end.
            let status = Victim::start_with(&by, "save some", &folder.0).end();
            killed += usize::from(!status.success());
            check(&folder, false, &format!("killed at {call} {when}"));
        }
    }
    eprintln!("killed {killed} times at a system call");
    assert!(killed >= 10, "{killed}");
}
