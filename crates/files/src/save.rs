//! Saves a file as a whole. After an error, the file is as it was before. Permissions, links and owner stay.
//!
//! The new bytes go into a temporary file beside the old one, which is then renamed. That would cut hard links, and
//! give the file another owner if the user may write it without owning it. Such a file, and one in a folder where no
//! file can be created, is written in place.

use std::ffi::OsStr;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, Seek as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::patience::in_time;
use super::{FileError, Overwrite, check_path};
use crate::scene::system_kind;

/// Saves `bytes` under `path`.
///
/// *Guarantees*: after an error the file is as it was. A link stays a link, also one that leads nowhere yet.
/// Permissions stay, and hard links, owner and group as far as the system allows. Temporary files of an earlier run
/// that was killed are removed.
///
/// # Errors
/// [`FileError::Write`] if the system refuses, [`FileError::ReadOnly`] depending on `overwrite`, and
/// [`FileError::Directory`], [`FileError::NotRegular`] (a pipe or a socket), [`FileError::Network`] or
/// [`FileError::ReservedName`] for such paths.
pub fn save(path: &Path, bytes: &[u8], overwrite: Overwrite) -> Result<(), FileError> {
    check_path(path)?;
    let bytes = bytes.to_owned();
    in_time(path, move |path| save_now(path, &bytes, overwrite)).map_err(FileError::Write)?
}

fn save_now(path: &Path, bytes: &[u8], overwrite: Overwrite) -> Result<(), FileError> {
    let target = end_of_links(path).map_err(FileError::Write)?;
    let result = match fs::metadata(&target) {
        Ok(before) if before.is_dir() => return Err(FileError::Directory),
        // Opening a pipe would wait until another process reads from it.
        Ok(before) if is_pipe(&before) => return Err(FileError::NotRegular),
        // A device can't be replaced.
        Ok(before) if !before.is_file() => {
            return open_to_write(&target).and_then(|mut file| file.write_all(bytes)).map_err(FileError::Write);
        }
        Ok(before) => {
            let writable = open_to_write(&target);
            if may_not_be_written(&before, &writable) && overwrite == Overwrite::Writable {
                return Err(FileError::ReadOnly);
            }
            replace(&target, bytes, &before, writable)
        }
        Err(_) => Temporary::beside(&target).and_then(|temporary| temporary.fill(bytes)?.rename(&target)),
    };
    result.map_err(FileError::Write)?;
    if let Some(folder) = folder_of(&target) {
        remove_left_over_now(folder);
    }
    Ok(())
}

/// True for pipes and sockets.
#[cfg(unix)]
fn is_pipe(file: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    file.file_type().is_fifo() || file.file_type().is_socket()
}

#[cfg(not(unix))]
fn is_pipe(_: &Metadata) -> bool {
    false
}

/// True if [`save`] needs [`Overwrite::ReadOnlyToo`].
pub fn is_read_only(path: &Path) -> bool {
    let is_read_only = |path: &Path| {
        fs::metadata(path).is_ok_and(|meta| meta.is_file() && may_not_be_written(&meta, &open_to_write(path)))
    };
    // Saving itself says it if this takes too long.
    in_time(path, is_read_only).unwrap_or(false)
}

/// Root may write every file, so the owner's setting counts.
fn may_not_be_written(meta: &Metadata, opened: &io::Result<File>) -> bool {
    meta.permissions().readonly() || opened.as_ref().is_err_and(|error| error.kind() == io::ErrorKind::PermissionDenied)
}

fn open_to_write(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}

/// The end of a chain of links, even if no file is there.
fn end_of_links(path: &Path) -> io::Result<PathBuf> {
    // The limit of Linux.
    const MOST: usize = 40;
    let mut end = path.to_owned();
    for _ in 0..MOST {
        let Ok(next) = fs::read_link(&end) else { return Ok(end) };
        end = end.parent().unwrap_or(Path::new("")).join(next);
    }
    Err(io::Error::other("too many links, one after the other"))
}

/// Replaces a regular file. `writable` is the file itself if the system lets it be written.
fn replace(target: &Path, bytes: &[u8], before: &Metadata, writable: io::Result<File>) -> io::Result<()> {
    let mut temporary = match (Temporary::beside(target), writable.is_ok()) {
        (Ok(temporary), _) => temporary.fill(bytes)?,
        (Err(_), true) => return write_in_place(writable?, target, bytes),
        (Err(error), false) => return Err(error),
    };
    let same_owner = temporary.take_owner(before);
    match writable {
        // The copy beside it holds the new bytes until all of them are written.
        Ok(file) if has_other_names(before) || !same_owner => write_in_place(file, target, bytes),
        writable => {
            temporary.file.set_permissions(before.permissions())?;
            let Err(error) = take_the_place(&mut temporary, target, before) else { return Ok(()) };
            match writable {
                // A folder where users may not replace the files of others, or, on Windows, a program that has it open.
                Ok(file) => write_in_place(file, target, bytes),
                Err(why) if system_kind(why.kind(), why.raw_os_error()) == io::ErrorKind::ResourceBusy => Err(why),
                Err(_) => Err(error),
            }
        }
    }
}

/// Puts the new file in the place of the old one, which Windows requires to be writable for that.
fn take_the_place(temporary: &mut Temporary, target: &Path, before: &Metadata) -> io::Result<()> {
    #[cfg(windows)]
    if before.permissions().readonly() {
        let mut writable = before.permissions();
        writable.set_readonly(false);
        fs::set_permissions(target, writable)?;
        return temporary.rename(target).inspect_err(|_| {
            // The first error is the one reported.
            let _ = fs::set_permissions(target, before.permissions());
        });
    }
    #[cfg(not(windows))]
    let _ = before;
    temporary.rename(target)
}

/// Writes over the old bytes, and restores them if the new ones don't fit. Doesn't overwrite a file that can't be read.
fn write_in_place(mut file: File, path: &Path, bytes: &[u8]) -> io::Result<()> {
    let old = fs::read(path)?;
    let mut put = |bytes: &[u8]| {
        file.rewind()?;
        file.write_all(bytes)?;
        file.set_len(bytes.len() as u64)?;
        file.sync_all()
    };
    put(bytes).inspect_err(|_| {
        // The first error is the one reported.
        let _ = put(&old);
    })
}

/// True for a file with other names (hard links).
#[cfg(unix)]
fn has_other_names(file: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    file.nlink() > 1
}

#[cfg(not(unix))]
fn has_other_names(_: &Metadata) -> bool {
    false
}

/// A new file in the folder of another one, which it can replace in one step. Locked while its program lives. Removed
/// unless renamed.
struct Temporary {
    path: PathBuf,
    file: File,
    renamed: bool,
}

const PREFIX: &str = ".camera-lab-";
const ENDING: &str = ".tmp";

impl Temporary {
    fn beside(target: &Path) -> io::Result<Self> {
        if target.file_name().is_none() {
            return Err(io::ErrorKind::InvalidFilename.into());
        }
        let mut attempt = 0_u32;
        loop {
            // Short, however long the name of the file is.
            let path = target.with_file_name(format!("{PREFIX}{}-{attempt}{ENDING}", std::process::id()));
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => {
                    // Without locks, a left-over file is recognised by its age alone.
                    let _ = file.try_lock();
                    return Ok(Self { path, file, renamed: false });
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists && attempt < 100 => attempt += 1,
                Err(error) => return Err(error),
            }
        }
    }

    fn fill(mut self, bytes: &[u8]) -> io::Result<Self> {
        self.file.write_all(bytes)?;
        self.file.sync_all()?;
        Ok(self)
    }

    /// Takes over the owner and group of another file. Returns false if the system doesn't allow it.
    #[cfg(unix)]
    fn take_owner(&self, of: &Metadata) -> bool {
        use std::os::unix::fs::{MetadataExt as _, fchown};
        let Ok(own) = self.file.metadata() else { return false };
        (own.uid(), own.gid()) == (of.uid(), of.gid()) || fchown(&self.file, Some(of.uid()), Some(of.gid())).is_ok()
    }

    #[cfg(not(unix))]
    fn take_owner(&self, _: &Metadata) -> bool {
        true
    }

    fn rename(&mut self, target: &Path) -> io::Result<()> {
        fs::rename(&self.path, target)?;
        self.renamed = true;
        sync_folder_of(target);
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if !self.renamed {
            // If the temporary file can't be removed, it stays.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// The folder that a file is in. For a name alone, the current one.
fn folder_of(target: &Path) -> Option<&Path> {
    let folder = target.parent()?;
    Some(if folder.as_os_str().is_empty() { Path::new(".") } else { folder })
}

/// Makes a rename outlast a power cut, if the system can.
fn sync_folder_of(target: &Path) {
    if cfg!(unix)
        && let Some(folder) = folder_of(target).and_then(|folder| File::open(folder).ok())
    {
        // The file is whole either way. Some file systems refuse to sync a folder.
        let _ = folder.sync_all();
    }
}

/// Removes temporary files left by killed programs, which no process is writing any more.
pub fn remove_left_over(folder: &Path) {
    // A folder that takes too long is cleaned up meanwhile.
    let _ = in_time(folder, remove_left_over_now);
}

fn remove_left_over_now(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let Some(process) = process_of(&entry.file_name()) else { continue };
        // For a link this is the link itself. Opening anything but a regular file could block.
        let Some(meta) = entry.metadata().ok().filter(Metadata::is_file) else { continue };
        let path = entry.path();
        if is_older(&meta, settled_after(process)) && open_to_write(&path).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = fs::remove_file(&path);
        }
    }
}

/// There is a moment between creating a file and locking it. The process of a file may run where its number means
/// nothing: on another machine, or in a container of its own.
fn settled_after(process: u32) -> Duration {
    let is_gone = Path::new("/proc/self").exists() && !Path::new(&format!("/proc/{process}")).exists();
    Duration::from_secs(if is_gone { 2 } else { 60 })
}

/// A file written later than now was written by another clock, or before this one was set back.
fn is_older(meta: &Metadata, than: Duration) -> bool {
    let age = |time: SystemTime| time.elapsed().unwrap_or_else(|ahead| ahead.duration());
    meta.modified().is_ok_and(|time| age(time) > than)
}

/// The number of the process that created a temporary file. `None` for every other name.
fn process_of(name: &OsStr) -> Option<u32> {
    let (process, attempt) = name.to_str()?.strip_prefix(PREFIX)?.strip_suffix(ENDING)?.split_once('-')?;
    let number =
        |text: &str| text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse::<u32>().ok()).flatten();
    number(attempt).and(number(process))
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::read_file;
    use crate::testing::Directory;

    fn names_in(directory: &Directory) -> Vec<String> {
        fs::read_dir(directory.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
    }

    fn save_writable(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
        save(path, bytes, Overwrite::Writable)
    }

    #[test]
    fn saving_replaces_the_whole_file_and_leaves_nothing_else() {
        let directory = Directory::new("replace");
        let path = directory.path().join("figura ção.toml");
        save_writable(&path, b"a long first text").unwrap();
        save_writable(&path, b"short").unwrap();
        assert_eq!(read_file(&path).unwrap(), b"short");
        assert_eq!(names_in(&directory).len(), 1);
    }

    #[test]
    fn a_failed_save_leaves_nothing_behind() {
        let directory = Directory::new("refused");
        assert!(matches!(save_writable(directory.path(), b"x"), Err(FileError::Directory)));
        let nowhere = directory.path().join("no/such/place.toml");
        assert!(matches!(save_writable(&nowhere, b"x"), Err(FileError::Write(_))));
        assert!(matches!(save_writable(Path::new(""), b"x"), Err(FileError::Write(_))));
        assert!(matches!(save_writable(Path::new("//host/share/x"), b"x"), Err(FileError::Network)));
        assert!(names_in(&directory).is_empty());
    }

    #[test]
    fn a_read_only_file_is_replaced_only_when_that_was_asked_for() {
        let directory = Directory::new("read-only");
        let path = directory.path().join("notes.toml");
        fs::write(&path, "old").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        assert!(is_read_only(&path) && !is_read_only(directory.path()));
        assert!(matches!(save_writable(&path, b"new"), Err(FileError::ReadOnly)));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        save(&path, b"new", Overwrite::ReadOnlyToo).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert!(fs::metadata(&path).unwrap().permissions().readonly());
        assert_eq!(names_in(&directory).len(), 1);
    }

    #[test]
    fn leftovers_of_a_killed_program_go_and_files_being_written_stay() {
        let directory = Directory::new("left-over");
        let minutes_ago = SystemTime::now() - Duration::from_secs(600);
        let file = |name: &str, time| {
            let file = File::create(directory.path().join(name)).unwrap();
            file.set_modified(time).unwrap();
            file
        };
        drop(file(".camera-lab-1-0.tmp", minutes_ago));
        let being_written = file(".camera-lab-2-0.tmp", minutes_ago);
        being_written.lock().unwrap();
        drop(file(".camera-lab-3-0.tmp", SystemTime::now()));
        // Left by a clock that was set back by years.
        drop(file(".camera-lab-4-0.tmp", SystemTime::now() + Duration::from_secs(100_000_000)));
        let foreign =
            ["mine.tmp", ".camera-lab-x-0.tmp", ".camera-lab-1.tmp", ".camera-lab-1-0-0.tmp", ".camera-lab-+1-0.tmp"];
        foreign.iter().for_each(|name| drop(file(name, minutes_ago)));
        save_writable(&directory.path().join("a.toml"), b"x").unwrap();
        let mut names = names_in(&directory);
        names.retain(|name| !foreign.contains(&name.as_str()));
        names.sort();
        assert_eq!(names, [".camera-lab-2-0.tmp", ".camera-lab-3-0.tmp", "a.toml"]);
        assert_eq!(names_in(&directory).len(), names.len() + foreign.len());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn leftovers_of_a_process_that_is_gone_need_not_be_old() {
        let directory = Directory::new("gone");
        let mut gone = std::process::Command::new("true").spawn().unwrap();
        gone.wait().unwrap();
        let seconds_ago = SystemTime::now() - Duration::from_secs(5);
        for process in [gone.id(), std::process::id()] {
            let file = File::create(directory.path().join(format!(".camera-lab-{process}-0.tmp"))).unwrap();
            file.set_modified(seconds_ago).unwrap();
        }
        remove_left_over(directory.path());
        assert_eq!(names_in(&directory), [format!(".camera-lab-{}-0.tmp", std::process::id())]);
    }

    #[cfg(unix)]
    mod unix {
        use super::*;
        use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, chown, symlink};

        #[test]
        fn links_and_permissions_stay() {
            let directory = Directory::new("link");
            let (file, link) = (directory.path().join("file.toml"), directory.path().join("link.toml"));
            fs::write(&file, "old").unwrap();
            fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
            symlink("file.toml", &link).unwrap();
            save_writable(&link, b"new").unwrap();
            assert_eq!(fs::read(&file).unwrap(), b"new");
            assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
            assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
        }

        #[test]
        fn a_link_that_leads_nowhere_yet_stays_a_link() {
            let directory = Directory::new("dangling");
            let link = directory.path().join("link.toml");
            symlink("later.toml", &link).unwrap();
            save_writable(&link, b"new").unwrap();
            assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
            assert_eq!(fs::read(directory.path().join("later.toml")).unwrap(), b"new");
            let round = directory.path().join("round.toml");
            symlink("round.toml", &round).unwrap();
            assert!(matches!(save_writable(&round, b"x"), Err(FileError::Write(_))));
        }

        #[test]
        fn files_that_only_look_left_over_are_not_followed_or_waited_for() {
            let directory = Directory::new("looks-left-over");
            let place = |name: &str| directory.path().join(name);
            fs::write(place("mine"), "mine").unwrap();
            File::options().write(true).open(place("mine")).unwrap().set_modified(SystemTime::UNIX_EPOCH).unwrap();
            symlink("mine", place(".camera-lab-1-0.tmp")).unwrap();
            fs::create_dir(place(".camera-lab-1-1.tmp")).unwrap();
            let made = std::process::Command::new("mkfifo").arg(place(".camera-lab-1-2.tmp")).status();
            assert!(made.is_ok_and(|status| status.success()));
            let names = [".camera-lab-1-0.tmp", ".camera-lab-1-1.tmp", ".camera-lab-1-2.tmp"].map(place);
            let long_ago = std::process::Command::new("touch").args(["-h", "-d", "2001-01-01"]).args(names).status();
            assert!(long_ago.is_ok_and(|status| status.success()));
            // Would wait for ever if the pipe was opened.
            save_writable(&place("a.toml"), b"x").unwrap();
            assert_eq!(names_in(&directory).len(), 5);
            assert_eq!(fs::read(place("mine")).unwrap(), b"mine");
        }

        #[test]
        fn a_pipe_is_refused_and_not_waited_for() {
            let directory = Directory::new("fifo");
            let pipe = directory.path().join("pipe.png");
            let made = std::process::Command::new("mkfifo").arg(&pipe).status();
            assert!(made.is_ok_and(|status| status.success()));
            // Would wait for ever for a reader if it was opened.
            assert!(matches!(save_writable(&pipe, b"x"), Err(FileError::NotRegular)));
            save_writable(Path::new("/dev/null"), b"x").unwrap();
        }

        #[test]
        fn hard_links_are_not_cut() {
            let directory = Directory::new("hard-link");
            let (one, other) = (directory.path().join("one.toml"), directory.path().join("other.toml"));
            fs::write(&one, "an old and long text").unwrap();
            fs::hard_link(&one, &other).unwrap();
            save_writable(&one, b"new").unwrap();
            assert_eq!(fs::read(&other).unwrap(), b"new");
            assert_eq!(names_in(&directory).len(), 2);
        }

        #[test]
        fn the_owner_stays() {
            let directory = Directory::new("owner");
            let path = directory.path().join("theirs.toml");
            fs::write(&path, "old").unwrap();
            // Only root may give files away. For other users the owner doesn't change anyway.
            let given = chown(&path, Some(1), Some(1)).is_ok();
            let before = fs::metadata(&path).unwrap();
            save_writable(&path, b"new").unwrap();
            let after = fs::metadata(&path).unwrap();
            assert_eq!((after.uid(), after.gid()), (before.uid(), before.gid()));
            assert_eq!(after.uid() == 1, given);
        }

        #[test]
        fn the_longest_name_that_the_system_allows_can_be_saved() {
            let directory = Directory::new("long-name");
            let path = directory.path().join(format!("{}.toml", "n".repeat(250)));
            save_writable(&path, b"one").unwrap();
            save_writable(&path, b"two").unwrap();
            assert_eq!(fs::read(&path).unwrap(), b"two");
        }
    }
}
