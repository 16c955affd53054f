//! Names of mesh files in figures.

use std::path::{Path, PathBuf};

use super::{is_network, whole};
use crate::figure::Figure;
use crate::scene::Shape;

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

/// A figure that names files relative to the folder `from`, as it's written into the folder `to`. In another folder it
/// gets new names for its meshes and its photograph, so that they are the same files. A figure without a folder names
/// them relative to the folder in which the program was started.
pub fn for_folder(figure: &Figure, from: Option<&Path>, to: Option<&Path>) -> Figure {
    let mut figure = figure.clone();
    if from.map(whole_folder) == to.map(whole_folder) {
        return figure;
    }
    let shapes = figure.scene.objects.iter_mut().filter_map(|object| object.shape.as_mut());
    let meshes = shapes.filter_map(|shape| match shape {
        Shape::Mesh { path } => Some(path),
        _ => None,
    });
    for path in meshes.chain(figure.photograph.as_mut().map(|photograph| &mut photograph.file)) {
        let file = from.unwrap_or(Path::new("")).join(&*path);
        // A figure from elsewhere must not make the system look for another machine.
        if !is_network(&file) && file.exists() {
            *path = named_in_figure(to, &file);
        }
    }
    figure
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_are_named_relative_to_their_figure() {
        let named = |folder: Option<&str>, path: &str| named_in_figure(folder.map(Path::new), Path::new(path));
        assert_eq!(named(Some("/lecture"), "/lecture/meshes/cow.obj"), "meshes/cow.obj");
        assert_eq!(named(Some("/lecture"), "/other/cow.obj"), "/other/cow.obj");
        assert_eq!(named(None, "/other/cow.obj"), "/other/cow.obj");
    }
}
