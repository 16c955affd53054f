//! Disks that are full, and folders that cannot be written.

use std::fs;
use std::path::PathBuf;

use camera_lab_files::{FileError, Overwrite, save};

use crate::Folder;

/// A small disk for tests, which `.ci/kill` mounts.
pub(crate) fn small_disk() -> Option<PathBuf> {
    let disk = std::env::var_os("CAMERA_LAB_SMALL_DISK").map(PathBuf::from);
    if disk.is_none() {
        eprintln!("left out: no small disk is mounted (.ci/kill does that)");
    }
    disk
}

/// Fills a disk to the last byte, and returns the file that does it.
pub(crate) fn fill(disk: &std::path::Path) -> PathBuf {
    use std::io::Write as _;
    let path = disk.join("filler");
    let mut file = fs::File::create(&path).expect("made");
    while file.write_all(&[0; 512]).is_ok() {}
    path
}

#[test]
fn a_full_disk_leaves_the_old_file_whole() {
    let Some(disk) = small_disk() else { return };
    let path = disk.join("a.toml");
    save(&path, b"old", Overwrite::Writable).expect("saved");
    let filler = fill(&disk);
    let large = vec![b'x'; 100_000];
    assert!(matches!(save(&path, &large, Overwrite::Writable), Err(FileError::Write(_))));
    assert_eq!(fs::read(&path).expect("there"), b"old");
    // In place too: the other name keeps the old bytes as well.
    fs::hard_link(&path, disk.join("b.toml")).expect("linked");
    assert!(matches!(save(&path, &large, Overwrite::Writable), Err(FileError::Write(_))));
    assert_eq!(fs::read(disk.join("b.toml")).expect("there"), b"old");
    fs::remove_file(filler).expect("removed");
    save(&path, &large, Overwrite::Writable).expect("there is room again");
    assert_eq!(fs::read(disk.join("b.toml")).expect("there"), large);
    let names = fs::read_dir(&disk).expect("a disk").count();
    assert_eq!(names, 2, "no temporary file is left");
    fs::remove_file(path).expect("removed");
    fs::remove_file(disk.join("b.toml")).expect("removed");
}

#[cfg(unix)]
#[test]
fn a_file_in_a_folder_that_cannot_be_written_is_saved_and_a_new_one_is_refused() {
    use std::os::unix::fs::PermissionsExt as _;
    let folder = Folder::new("read-only");
    let path = folder.file("a.toml");
    fs::write(&path, "old").expect("written");
    fs::set_permissions(&folder.0, fs::Permissions::from_mode(0o555)).expect("possible");
    if fs::write(folder.file("probe"), "").is_ok() {
        eprintln!("left out: to this user every folder can be written");
    } else {
        save(&path, b"new", Overwrite::Writable).expect("saved in place");
        assert_eq!(fs::read(&path).expect("there"), b"new");
        assert!(matches!(save(&folder.file("b.toml"), b"new", Overwrite::Writable), Err(FileError::Write(_))));
        let mut permissions = fs::metadata(&path).expect("there").permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).expect("possible");
        assert!(matches!(save(&path, b"newer", Overwrite::Writable), Err(FileError::ReadOnly)));
        assert_eq!(fs::read(&path).expect("there"), b"new");
    }
    fs::set_permissions(&folder.0, fs::Permissions::from_mode(0o755)).expect("possible");
}
