//! The names in a figure that lead to files: meshes, textures, the photograph. Whatever writes a figure into another
//! folder takes them through [`for_folder`].

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::{disk, is_network, whole};
use crate::figure::Figure;

/// The new names of files in a figure, by the old ones.
pub type Renamed = BTreeMap<String, String>;

/// The name of a file in a figure of this folder: relative to the folder, with slashes, if the file is in it, otherwise
/// its whole path.
pub fn named_in_figure(folder: Option<&Path>, path: &Path) -> String {
    let file = whole(path);
    let folder = folder.map(whole_folder);
    match folder.as_deref().and_then(|folder| file.strip_prefix(folder).ok()) {
        Some(inside) => {
            let parts: Vec<_> = inside.components().map(|part| part.as_os_str().to_string_lossy()).collect();
            parts.join("/")
        }
        None => file.to_string_lossy().into_owned(),
    }
}

/// The folder of a file named without one is the current folder.
fn whole_folder(folder: &Path) -> PathBuf {
    whole(if folder.as_os_str().is_empty() { Path::new(".") } else { folder })
}

/// A figure that names files relative to the folder `from`, as it's written into the folder `to`, and its new names. In
/// another folder it gets new names for its meshes, textures and photograph, so that they are the same files. The files
/// that a mesh names stay beside the mesh. A figure without a folder names them relative to the folder in which the
/// program was started.
pub fn for_folder(figure: &Figure, from: Option<&Path>, to: Option<&Path>) -> (Figure, Renamed) {
    let (mut figure, mut renamed) = (figure.clone(), Renamed::new());
    if from.map(whole_folder) == to.map(whole_folder) {
        return (figure, renamed);
    }
    for name in figure.files_mut() {
        let file = from.unwrap_or(Path::new("")).join(&*name);
        // A figure from elsewhere must not make the system look for another machine. An empty name hasn't been typed.
        if !name.is_empty() && !is_network(&file) && disk::may_exist(&file) {
            let new = named_in_figure(to, &file);
            renamed.insert(std::mem::replace(name, new.clone()), new);
        }
    }
    (figure, renamed)
}

/// Gives new names to files.
pub fn rename<'a>(names: impl Iterator<Item = &'a mut String>, renamed: &Renamed) {
    for name in names {
        if let Some(new) = renamed.get(name) {
            new.clone_into(name);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_relative_to_their_figure() {
        let named = |folder: Option<&str>, path: &str| named_in_figure(folder.map(Path::new), Path::new(path));
        assert_eq!(named(Some("/lecture"), "/lecture/meshes/cow.obj"), "meshes/cow.obj");
        assert_eq!(named(Some("/lecture"), "/other/cow.obj"), "/other/cow.obj");
        assert_eq!(named(None, "/other/cow.obj"), "/other/cow.obj");
    }
}
