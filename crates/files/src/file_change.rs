//! Detection of changes of a file since it was read or saved.

use std::fs;
use std::path::Path;
use std::time::SystemTime;

use super::patience::in_time;
use super::read_file;
use crate::limits::MAX_FIGURE_BYTES;

/// Time and size of a file. While they stay the same, we take the file to be unchanged without reading it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stamp {
    modified: Option<SystemTime>,
    size: u64,
}

/// The state of a file compared with the `known` one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileChange {
    /// The same bytes.
    Same(Stamp),
    /// These bytes. `None` if they can't be read, or if there are more than any figure file has.
    Other(Option<Vec<u8>>),
    /// The file is gone.
    Gone,
}

/// Looks at a file that held `known`. Doesn't read it if its time and size are still `stamp`.
pub fn look(path: &Path, known: &[u8], stamp: Option<Stamp>) -> FileChange {
    let Ok(meta) = in_time(path, |path| fs::metadata(path)) else { return FileChange::Other(None) };
    let Ok(meta) = meta else { return FileChange::Gone };
    // Taken before the bytes are read, so that a later write has another one.
    let now = Stamp { modified: meta.modified().ok(), size: meta.len() };
    if stamp == Some(now) && now.modified.is_some() {
        return FileChange::Same(now);
    }
    if now.size > MAX_FIGURE_BYTES as u64 {
        return FileChange::Other(None);
    }
    match read_file(path) {
        Ok(bytes) if bytes == known => FileChange::Same(now),
        Ok(bytes) => FileChange::Other(Some(bytes)),
        Err(_) => FileChange::Other(None),
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::testing::Directory;

    #[test]
    fn changed_files_are_found_and_merely_touched_ones_are_not() {
        let directory = Directory::new("look");
        let path = directory.path().join("a.toml");
        assert_eq!(look(&path, b"mine", None), FileChange::Gone);
        fs::write(&path, "mine").unwrap();
        let FileChange::Same(stamp) = look(&path, b"mine", None) else { panic!("the same") };
        assert_eq!(look(&path, b"mine", Some(stamp)), FileChange::Same(stamp));
        let file = fs::File::options().write(true).open(&path).unwrap();
        file.set_modified(SystemTime::UNIX_EPOCH).unwrap();
        assert!(matches!(look(&path, b"mine", Some(stamp)), FileChange::Same(touched) if touched != stamp));
        fs::write(&path, "theirs").unwrap();
        assert_eq!(look(&path, b"mine", Some(stamp)), FileChange::Other(Some(b"theirs".to_vec())));
        // The size is the same, so only the content tells them apart.
        fs::write(&path, "ours").unwrap();
        assert_eq!(look(&path, b"mine", None), FileChange::Other(Some(b"ours".to_vec())));
        file.set_len(MAX_FIGURE_BYTES as u64 + 1).unwrap();
        assert_eq!(look(&path, b"mine", Some(stamp)), FileChange::Other(None));
        assert_eq!(look(directory.path(), b"mine", None), FileChange::Other(None));
    }
}
