//! How figures name the files of their meshes.

use std::path::Path;

use super::document::Document;
use crate::figure::Figure;
use crate::files;
use crate::scene::Shape;

/// How a figure in this folder names a file: relative to the folder where the file lies in it, with slashes; else by its
/// whole path.
pub(super) fn named_in_figure(folder: Option<&Path>, path: &Path) -> String {
    let whole = files::whole(path);
    let folder = folder.map(files::whole);
    match folder.as_deref().and_then(|folder| whole.strip_prefix(folder).ok()) {
        Some(inside) => {
            let parts: Vec<_> = inside.components().map(|part| part.as_os_str().to_string_lossy()).collect();
            parts.join("/")
        }
        None => whole.to_string_lossy().into_owned(),
    }
}

/// The figure as it is written to `to`: in another folder it names its meshes anew, so that they are the same files.
pub(super) fn for_folder(document: &Document, to: &Path) -> Figure {
    let mut figure = document.figure().clone();
    let (from, to) = (document.folder(), to.parent());
    if from == to {
        return figure;
    }
    for object in &mut figure.scene.objects {
        if let Some(Shape::Mesh { path }) = &mut object.shape {
            let file = from.unwrap_or(Path::new("")).join(&path);
            // A foreign figure must not make the system look for another machine.
            if !files::is_network(&file) && file.exists() {
                *path = named_in_figure(to, &file);
            }
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
