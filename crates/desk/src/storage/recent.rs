//! The recent files.

use std::path::{Path, PathBuf};

/// The recent files.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Recent {
    /// All remembered files, the latest first.
    pub files: Vec<PathBuf>,
    /// The files of this window that haven't been saved yet, the latest first.
    pub new: Vec<PathBuf>,
}

/// Number of recent files.
const MOST_RECENT: usize = 16;

impl Recent {
    /// Remembers a file that has been opened or saved. A path that isn't text can't be remembered.
    pub fn add(&mut self, path: &Path) {
        if path.is_absolute() && path.to_str().is_some() {
            for list in [&mut self.files, &mut self.new] {
                *list = merged(&[path.to_owned()], list);
            }
        }
    }
}

/// A list with others before it, each once.
pub fn merged(first: &[PathBuf], then: &[PathBuf]) -> Vec<PathBuf> {
    let others = then.iter().filter(|path| !first.contains(path));
    first.iter().chain(others).take(MOST_RECENT).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_latest_file_comes_first_and_each_once() {
        let mut recent = Recent::default();
        for i in [1, 2, 3, 1] {
            recent.add(Path::new(&format!("/{i}.toml")));
        }
        recent.add(Path::new("relative.toml"));
        assert_eq!(recent.files, ["/1.toml", "/3.toml", "/2.toml"].map(PathBuf::from));
        (0..50).for_each(|i| recent.add(Path::new(&format!("/many/{i}"))));
        assert_eq!(recent.files.len(), MOST_RECENT);
    }
}
