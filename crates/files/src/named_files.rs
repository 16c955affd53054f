//! The names in a figure that lead to files: meshes, textures, the photograph. Whatever writes a figure into another
//! folder takes them through [`for_folder`].

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

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
    moved(figure, from, to, |file, _| named_in_figure(to, file))
}

/// As [`for_folder`], for a figure file, which may name files anywhere: a relative name stays relative, so that both
/// folders can move together.
pub fn for_figure_file(figure: &Figure, from: Option<&Path>, to: Option<&Path>) -> (Figure, Renamed) {
    moved(figure, from, to, |file, old| {
        let own = from.filter(|_| Path::new(old).is_relative());
        own.and_then(|_| relative(to?, file)).unwrap_or_else(|| named_in_figure(to, file))
    })
}

/// The name of an existing file relative to a folder, with slashes. `None` if there's none, as on another disk, or if
/// links of the system would lead elsewhere.
fn relative(folder: &Path, file: &Path) -> Option<String> {
    let (folder, whole) = (without_steps_up(&whole_folder(folder)), without_steps_up(&whole(file)));
    let common = folder.components().zip(whole.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(common).map(|_| "..".into());
    let down = whole.components().skip(common).map(|part| part.as_os_str().to_string_lossy());
    let name = up.chain(down).collect::<Vec<_>>().join("/");
    let same = |path: &Path| disk::canonical(path).ok();
    (common > 0 && same(&folder.join(&name)).is_some_and(|path| Some(path) == same(file))).then_some(name)
}

/// A whole path with each `..` taken together with the folder before it, as far as names go.
fn without_steps_up(path: &Path) -> PathBuf {
    let mut shorter = PathBuf::new();
    for part in path.components() {
        if part == Component::ParentDir {
            shorter.pop();
        } else {
            shorter.push(part);
        }
    }
    shorter
}

fn moved(
    figure: &Figure,
    from: Option<&Path>,
    to: Option<&Path>,
    name_of: impl Fn(&Path, &str) -> String,
) -> (Figure, Renamed) {
    let (mut figure, mut renamed) = (figure.clone(), Renamed::new());
    if from.map(whole_folder) == to.map(whole_folder) {
        return (figure, renamed);
    }
    for name in figure.files_mut() {
        let file = from.unwrap_or(Path::new("")).join(&*name);
        // A figure from elsewhere must not make the system look for another machine. An empty name hasn't been typed.
        if !name.is_empty() && !is_network(&file) && disk::may_exist(&file) {
            let new = name_of(&file, name);
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
    #![expect(clippy::expect_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::scene::{ObjectSpec, Shape};
    use crate::testing::Directory;

    #[test]
    fn files_are_named_relative_to_their_figure() {
        let named = |folder: Option<&str>, path: &str| named_in_figure(folder.map(Path::new), Path::new(path));
        assert_eq!(named(Some("/lecture"), "/lecture/meshes/cow.obj"), "meshes/cow.obj");
        assert_eq!(named(Some("/lecture"), "/other/cow.obj"), "/other/cow.obj");
        assert_eq!(named(None, "/other/cow.obj"), "/other/cow.obj");
    }

    #[test]
    fn relative_names_of_a_figure_file_stay_relative_in_another_folder() {
        let directory = Directory::new("relative");
        let path = |name: &str| directory.path().join(name);
        for folder in ["a/meshes", "b/c"] {
            std::fs::create_dir_all(path(folder)).expect("a folder");
        }
        std::fs::write(path("a/meshes/m.obj"), "v 0 0 0\n").expect("a file");
        let whole = path("a/meshes/m.obj").display().to_string();
        let mut figure = Figure::default();
        for name in ["meshes/m.obj", whole.as_str(), "missing.obj", "camera-lab:teapot.obj"] {
            figure.scene.objects.push(ObjectSpec::new(name.to_owned(), Shape::Mesh { path: name.to_owned() }));
        }
        let names = |figure: &mut Figure| figure.files_mut().map(|name| name.clone()).collect::<Vec<_>>();
        let (mut moved, _) = for_figure_file(&figure, Some(&path("a")), Some(&path("b/c")));
        assert_eq!(names(&mut moved), ["../../a/meshes/m.obj", &whole, "missing.obj", "camera-lab:teapot.obj"]);
        let (mut back, _) = for_figure_file(&moved, Some(&path("b/c")), Some(&path("a")));
        assert_eq!(names(&mut back)[0], "meshes/m.obj");
        // What a lesson or a picture names must be in its folder, so there the whole path says more.
        let (mut other, _) = for_folder(&figure, Some(&path("a")), Some(&path("b/c")));
        assert_eq!(names(&mut other)[0], whole);
    }
}
