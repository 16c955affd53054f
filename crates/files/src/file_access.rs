//! The files that a figure may make the program read, and their total size.

use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

use super::carried::Carried;
use super::shipped::shipped_file;
use super::{FileError, disk, is_network, read_at_most};
use crate::limits::MAX_SCENE_BYTES;
use crate::scene::{NamedBy, ReadError, ReadProblem, Wanted};
use crate::{sanitize, share};

/// The files that a figure may name, more from one to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum FileAccess {
    /// The reach of a figure that came without a folder, as in a link. It has the meshes of the program.
    Link,
    /// A step of a lesson file. Its meshes and textures, and the files they name, are in the lesson's folder or below.
    Lesson,
    /// A figure from a picture. Its meshes, and the files they name, are in the picture's folder or below.
    Picture,
    /// A figure file. Its meshes may be anywhere on this machine, but the files they name have to be in their folder or
    /// below.
    #[default]
    Figure,
    /// Any file of this machine, as allowed by the user.
    Anywhere,
}

impl FileAccess {
    /// The reach of a figure that came in a picture or in a file of its own with this path, or in a link. If `allowed`,
    /// the user lets it name any file.
    pub fn of(path: &Path, from_picture: bool, allowed: bool) -> Self {
        let has_folder = !path.as_os_str().is_empty() && share::link_of(path).is_none();
        match (allowed, from_picture) {
            (true, _) => Self::Anywhere,
            (false, true) if has_folder => Self::Picture,
            (false, true) => Self::Link,
            (false, false) => Self::Figure,
        }
    }

    /// The reach of the steps of a lesson in a file with this path or in a link, or of a built-in one (`None`). If
    /// `allowed`, the user lets it name any file.
    pub fn of_lesson(path: Option<&Path>, allowed: bool) -> Self {
        let in_file = path.filter(|path| share::link_of(path).is_none());
        match (allowed, in_file) {
            (true, _) => Self::Anywhere,
            (false, Some(_)) => Self::Lesson,
            (false, None) => Self::Link,
        }
    }
}

/// Reads the files that one figure names.
///
/// *Guarantees*: only regular files of this machine, within the allowed folders, and never more than
/// [`MAX_SCENE_BYTES`] of them in all. Files outside aren't even looked at. The message doesn't reveal whether they
/// exist.
#[derive(Clone, Debug)]
pub struct FigureFiles {
    folder: PathBuf,
    reach: FileAccess,
    carried: Carried,
    left: usize,
    unread: Vec<ReadError>,
}

impl FigureFiles {
    /// The files of a figure whose paths are relative to `folder`.
    pub fn new(folder: &Path, reach: FileAccess) -> Self {
        let carried = Carried::default();
        Self { folder: folder.to_owned(), reach, carried, left: MAX_SCENE_BYTES, unread: Vec::new() }
    }

    /// The files of a lesson's figures, in its folder or below, or in its link. `None` for a built-in lesson. If
    /// `allowed`, the user lets it name any file.
    pub fn of_lesson(path: Option<&Path>, allowed: bool) -> Self {
        let folder = path.filter(|path| share::link_of(path).is_none()).and_then(Path::parent);
        let files = Self::new(folder.unwrap_or(Path::new("")), FileAccess::of_lesson(path, allowed));
        files.with(&Carried::of_lesson(path))
    }

    /// The same, with the files that a picture or a link carries. They come before files of the same name on the disk.
    #[must_use]
    pub fn with(self, carried: &Carried) -> Self {
        Self { carried: carried.clone(), ..self }
    }

    /// The folder that names are relative to.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The same, with this number of bytes already read.
    #[must_use]
    pub fn after(self, spent: usize) -> Self {
        Self { left: self.left.saturating_sub(spent), ..self }
    }

    /// Number of bytes read.
    pub fn spent(&self) -> usize {
        MAX_SCENE_BYTES - self.left
    }

    /// The unreadable files that meshes name. A mesh without its material library is drawn all the same.
    pub fn unread(&self) -> &[ReadError] {
        &self.unread
    }

    /// The bytes of a file, or of a built-in one (`camera-lab:teapot.obj`).
    ///
    /// # Errors
    /// A refusal of the system, a file that isn't regular, one outside the allowed folders, and too many bytes.
    pub fn read(&mut self, wanted: Wanted<'_>) -> Result<Vec<u8>, ReadError> {
        if let Some(bytes) = shipped_file(wanted.path, wanted.named_by) {
            return Ok(bytes.to_vec());
        }
        let path = self.folder.join(wanted.path);
        // The folder of a link is none.
        let named = if self.reach == FileAccess::Link { Path::new(wanted.path) } else { &path };
        let file = sanitize::path(named);
        let read = self.read_problem(&path, wanted).map_err(|problem| ReadError { file, problem });
        if let (Err(error), Some(_)) = (&read, wanted.named_by) {
            self.unread.push(error.clone());
        }
        read
    }

    fn read_problem(&mut self, path: &Path, wanted: Wanted<'_>) -> Result<Vec<u8>, ReadProblem> {
        if let Some(carried) = self.carried.read(wanted.path, self.left) {
            let bytes = carried?;
            self.left = self.left.saturating_sub(bytes.len());
            return Ok(bytes);
        }
        if is_network(path) || is_network(Path::new(wanted.path)) {
            return Err(ReadProblem::Network);
        }
        if self.reach == FileAccess::Link {
            return Err(ReadProblem::NoFolder);
        }
        let path = match self.bound(wanted) {
            Some((folder, named_by)) => inside(&folder, path).map_err(|error| match error {
                Elsewhere::Outside => {
                    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { &folder };
                    ReadProblem::Outside { folder: sanitize::path(folder), named_by }
                }
                Elsewhere::System(error) => ReadProblem::system(&error),
            })?,
            None => path.to_owned(),
        };
        let bytes = read_at_most(&path, self.left as u64).map_err(|error| match error {
            FileError::Directory => ReadProblem::Directory,
            FileError::TooLarge(_) => ReadProblem::Budget,
            FileError::NotRegular => ReadProblem::NotRegular,
            FileError::Network => ReadProblem::Network,
            FileError::Read(error) | FileError::Write(error) => ReadProblem::system(&error),
            FileError::ReservedName => ReadProblem::system(&ErrorKind::InvalidFilename.into()),
            FileError::Png(_)
            | FileError::OtherPicture(_)
            | FileError::Latex
            | FileError::Mesh
            | FileError::Figure(_)
            | FileError::Link(_)
            | FileError::ReadOnly
            | FileError::OtherPage
            | FileError::OwnFile(_)
            | FileError::TooManyExercises => ReadProblem::system(&ErrorKind::InvalidData.into()),
        })?;
        self.left = self.left.saturating_sub(bytes.len());
        Ok(bytes)
    }

    /// The folder in which a file has to lie, if there is such a limit, and the file that names it.
    fn bound(&self, wanted: Wanted<'_>) -> Option<(PathBuf, NamedBy)> {
        match (self.reach, wanted.named_by) {
            (FileAccess::Anywhere, _) | (FileAccess::Figure, None) => None,
            (FileAccess::Figure, Some(mesh)) => {
                let folder = self.folder.join(mesh).parent().map(Path::to_owned).unwrap_or_default();
                Some((folder, NamedBy::Mesh))
            }
            (FileAccess::Lesson, _) => Some((self.folder.clone(), NamedBy::Lesson)),
            (FileAccess::Picture | FileAccess::Link, _) => Some((self.folder.clone(), NamedBy::Picture)),
        }
    }
}

enum Elsewhere {
    Outside,
    System(std::io::Error),
}

/// The path without links and `..`, if it lies in `folder` or below.
fn inside(folder: &Path, path: &Path) -> Result<PathBuf, Elsewhere> {
    // Checks its path first: for files outside, not even the existence is checked.
    if !lexically_inside(folder, path) {
        return Err(Elsewhere::Outside);
    }
    // `""` is the folder in which the program runs.
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let folder = disk::canonical(folder).map_err(Elsewhere::System)?;
    let path = disk::canonical(path).map_err(Elsewhere::System)?;
    if path.starts_with(&folder) { Ok(path) } else { Err(Elsewhere::Outside) }
}

/// True if the parts of `path` continue those of `folder` and never go above it.
fn lexically_inside(folder: &Path, path: &Path) -> bool {
    let Ok(rest) = path.strip_prefix(folder) else { return false };
    let mut depth = 0_usize;
    for component in rest.components() {
        match component {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir => match depth.checked_sub(1) {
                Some(above) => depth = above,
                None => return false,
            },
            Component::RootDir | Component::Prefix(_) => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use std::fs;

    use super::*;
    use crate::testing::Directory;

    fn of_mesh<'a>(path: &'a str, mesh: &'a str) -> Wanted<'a> {
        Wanted { path, named_by: Some(mesh) }
    }

    fn of_figure(path: &str) -> Wanted<'_> {
        Wanted { path, named_by: None }
    }

    fn is_outside(read: Result<Vec<u8>, ReadError>) -> bool {
        matches!(read, Err(ReadError { problem: ReadProblem::Outside { .. }, .. }))
    }

    #[test]
    fn files_of_a_mesh_come_from_its_folder_and_below() {
        let directory = Directory::new("reach");
        let root = directory.path();
        fs::create_dir_all(root.join("figure/meshes/deep")).unwrap();
        fs::write(root.join("secret"), "secret").unwrap();
        fs::write(root.join("figure/beside"), "beside").unwrap();
        fs::write(root.join("figure/meshes/a.bin"), "a").unwrap();
        fs::write(root.join("figure/meshes/deep/b.bin"), "b").unwrap();
        let folder = root.join("figure");
        let secret = root.join("secret");
        let absolute = secret.to_str().unwrap();
        let outside =
            ["meshes/../../secret", "meshes/../beside", "meshes/deep/../../beside", "meshes/../../nothing", absolute];

        let mut files = FigureFiles::new(&folder, FileAccess::Figure);
        for (path, bytes) in [("meshes/a.bin", "a"), ("meshes/deep/b.bin", "b"), ("meshes/deep/../a.bin", "a")] {
            assert_eq!(files.read(of_mesh(path, "meshes/m.obj")).unwrap(), bytes.as_bytes(), "{path}");
        }
        for path in outside {
            assert!(is_outside(files.read(of_mesh(path, "meshes/m.obj"))), "{path}");
        }
        // The figure's own paths reach further, and so do the user's.
        assert_eq!(files.read(of_figure("../secret")).unwrap(), b"secret");
        assert_eq!(files.read(of_figure(absolute)).unwrap(), b"secret");
        let mut files = FigureFiles::new(&folder, FileAccess::Anywhere);
        assert_eq!(files.read(of_mesh("meshes/../../secret", "meshes/m.obj")).unwrap(), b"secret");

        let mut files = FigureFiles::new(&folder, FileAccess::Picture);
        assert_eq!(files.read(of_figure("beside")).unwrap(), b"beside");
        assert_eq!(files.read(of_mesh("meshes/../beside", "meshes/m.obj")).unwrap(), b"beside");
        assert!(is_outside(files.read(of_figure("../secret"))));
        assert!(is_outside(files.read(of_figure(absolute))));
        assert!(is_outside(files.read(of_mesh("meshes/../../secret", "meshes/m.obj"))));
    }

    #[cfg(unix)]
    #[test]
    fn links_lead_out_no_more_than_paths_do() {
        let directory = Directory::new("links");
        let root = directory.path();
        fs::create_dir_all(root.join("figure/inner")).unwrap();
        fs::write(root.join("secret"), "secret").unwrap();
        fs::write(root.join("figure/inner/x"), "x").unwrap();
        std::os::unix::fs::symlink(root.join("secret"), root.join("figure/link")).unwrap();
        std::os::unix::fs::symlink(root, root.join("figure/up")).unwrap();
        std::os::unix::fs::symlink("inner/x", root.join("figure/within")).unwrap();
        let mut files = FigureFiles::new(&root.join("figure"), FileAccess::Picture);
        assert!(is_outside(files.read(of_figure("link"))));
        assert!(is_outside(files.read(of_figure("up/secret"))));
        assert_eq!(files.read(of_figure("within")).unwrap(), b"x");
        // The folder itself may be a link.
        std::os::unix::fs::symlink(root.join("figure"), root.join("linked")).unwrap();
        let mut files = FigureFiles::new(&root.join("linked"), FileAccess::Picture);
        assert_eq!(files.read(of_figure("inner/x")).unwrap(), b"x");
    }

    #[test]
    fn no_reach_leads_to_another_machine() {
        for reach in [FileAccess::Picture, FileAccess::Figure, FileAccess::Anywhere] {
            let mut files = FigureFiles::new(Path::new("folder"), reach);
            for path in [r"\\host\share\x.obj", "//host/share/x.obj"] {
                for wanted in [of_figure(path), of_mesh(path, "m.obj")] {
                    let problem = files.read(wanted).map_err(|error| error.problem);
                    assert_eq!(problem, Err(ReadProblem::Network), "{path}");
                }
            }
        }
    }

    #[test]
    fn all_files_of_a_figure_have_one_budget() {
        let directory = Directory::new("budget");
        // Sparse: it takes no room on the disk.
        for (name, bytes) in [("large", MAX_SCENE_BYTES as u64 + 1), ("small", 100), ("smaller", 50)] {
            fs::File::create(directory.path().join(name)).unwrap().set_len(bytes).unwrap();
        }
        let problem = |read: Result<Vec<u8>, ReadError>| read.map(|bytes| bytes.len()).map_err(|error| error.problem);
        let mut files = FigureFiles::new(directory.path(), FileAccess::Figure);
        assert_eq!(problem(files.read(of_figure("large"))), Err(ReadProblem::Budget));
        assert_eq!(files.spent(), 0);
        let mut files = files.after(MAX_SCENE_BYTES - 150);
        assert_eq!(problem(files.read(of_figure("small"))), Ok(100));
        assert_eq!(problem(files.read(of_mesh("small", "m.obj"))), Err(ReadProblem::Budget));
        assert_eq!(problem(files.read(of_mesh("smaller", "m.obj"))), Ok(50));
        assert_eq!(problem(files.read(of_figure("smaller"))), Err(ReadProblem::Budget));
        assert_eq!(files.spent(), MAX_SCENE_BYTES);
        assert_eq!(files.unread().len(), 1, "what a mesh names and lacks");
    }
}
