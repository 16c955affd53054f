//! A figure that travels with its files: inside a picture, or in a folder beside a figure file.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

use super::carried::{Carried, packed};
use super::file_access::{FigureFiles, FileAccess};
use super::named_files::{Renamed, for_folder, rename};
use super::shipped::SHIPPED;
use super::{FileError, Overwrite, disk, sanitize};
use crate::export::format::PictureFormat;
use crate::figure::Figure;
use crate::lessons::Lesson;
use crate::limits::{MAX_CARRIED_BYTES, MAX_FIGURE_BYTES, MAX_HANDED_OUT_BYTES};
use crate::progress::{Progress, at_once};
use crate::scene::import::{import, read_texture};
use crate::scene::{FileUse, ObjectSpec, ReadError, Shape, Wanted};

/// The files of a figure that a picture doesn't carry, because they have more than [`MAX_CARRIED_BYTES`] together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut(pub Vec<String>);

/// The files that a figure names, if they have room in a picture.
fn carried(figure: &Figure, files: &mut FigureFiles) -> Result<Carried, LeftOut> {
    let (mut carried, mut left) = (BTreeMap::new(), MAX_CARRIED_BYTES);
    let mut put = |name: &str, bytes: &[u8]| {
        // Two meshes may share a library or a texture.
        if carried.contains_key(name) {
            return Some(());
        }
        let packed = packed(bytes, left)?;
        left -= packed.len();
        carried.insert(name.to_owned(), packed);
        Some(())
    };
    for (name, of) in own_files(figure) {
        let Ok(bytes) = files.read(Wanted { path: name, named_by: None }) else { continue };
        // Large files aren't even parsed.
        let Some(()) = packed(&bytes, MAX_CARRIED_BYTES).map(drop) else { return Err(LeftOut::of(figure)) };
        let Some(beside) = companions((name, of), &bytes, files) else { continue };
        for (name, bytes) in std::iter::once((name.to_owned(), bytes)).chain(beside) {
            put(&name, &bytes).ok_or_else(|| LeftOut::of(figure))?;
        }
    }
    Ok(Carried(carried.into()))
}

impl LeftOut {
    fn of(figure: &Figure) -> Self {
        Self(own_files(figure).into_keys().map(str::to_owned).collect())
    }
}

/// The names of the user's own files in a figure, each once.
pub fn own_files(figure: &Figure) -> BTreeMap<&str, FileUse> {
    figure.files().filter(|(name, _)| !(name.is_empty() || name.starts_with(SHIPPED))).collect()
}

/// The files that a file of a figure names, as it names them. `None` if the file itself can't be used: the picture
/// doesn't show it then, and it may be a secret to which a stranger's figure leads.
fn companions((name, of): (&str, FileUse), bytes: &[u8], files: &mut FigureFiles) -> Option<Vec<(String, Vec<u8>)>> {
    let mut beside = Vec::new();
    match of {
        FileUse::Image => drop(read_texture(name, &mut |_| Ok(bytes.to_owned())).ok()?),
        FileUse::Mesh => {
            let mut read = |wanted: Wanted<'_>| {
                let bytes = files.read(wanted)?;
                beside.push((wanted.path.to_owned(), bytes.clone()));
                Ok::<_, ReadError>(bytes)
            };
            at_once(import(name, bytes, &mut read, &Progress::default())).ok()?;
            beside.retain(|(name, _)| may_travel(name));
        }
    }
    Some(beside)
}

/// True for names of materials, buffers and textures, for the same reason.
fn may_travel(name: &str) -> bool {
    let ending = Path::new(name).extension().unwrap_or_default().to_string_lossy().to_lowercase();
    ["mtl", "bin", "png", "jpg", "jpeg", "webp"].contains(&&*ending)
}

/// The text of a figure for a picture at `path`, with the files of the figure, which `files` reads. If they have no
/// room, the text names them from the folder of the picture, and they are returned. `text` writes a figure.
pub fn text_in_picture(
    text: impl Fn(&Figure) -> String,
    figure: &Figure,
    mut files: FigureFiles,
    path: &Path,
) -> (String, Option<LeftOut>) {
    // A file of LaTeX has a PDF beside it, which carries the figure.
    let holds_figure =
        PictureFormat::of(path).is_some_and(|format| format.carries_figure() || format == PictureFormat::Tex);
    if !holds_figure || own_files(figure).is_empty() {
        return (text(figure), None);
    }
    let (moved, mut renamed) = for_folder(figure, Some(files.folder()), path.parent());
    let joined = carried(figure, &mut files).map(|carried| {
        // A file that isn't carried, because it can't be read now, is looked for again from the picture's folder.
        renamed.retain(|name, _| !carried.0.contains_key(name));
        let mut figure = figure.clone();
        rename(figure.files_mut(), &renamed);
        carried.join(&text(&figure))
    });
    match joined.map(|joined| Some(joined).filter(|joined| joined.len() <= MAX_FIGURE_BYTES)) {
        Ok(Some(joined)) => (joined, None),
        left_out => (text(&moved), Some(left_out.err().unwrap_or_else(|| LeftOut::of(figure)))),
    }
}

/// A mesh by its own name, with the files that it names, for a figure without a folder. `None` if it can't be read or
/// has no room.
pub fn carried_mesh(path: &Path) -> Option<(String, Carried)> {
    let name = path.file_name()?.to_str()?.to_owned();
    let mut figure = Figure::default();
    figure.scene.objects = vec![ObjectSpec::new(name.clone(), Shape::Mesh { path: name.clone() })];
    let folder = path.parent().unwrap_or(Path::new(""));
    let carried = carried(&figure, &mut FigureFiles::new(folder, FileAccess::Figure)).ok()?;
    carried.0.contains_key(&name).then_some((name, carried))
}

/// A text with the files that its figures name, for a link or a page. Without such files it's the text itself.
///
/// # Errors
/// [`FileError::OwnFile`] with the name of one that can't be read or has no room.
pub fn text_with_files<'a>(
    text: &str,
    figures: impl IntoIterator<Item = &'a Figure>,
    files: &FigureFiles,
) -> Result<String, FileError> {
    let no_room = |name: &str| FileError::OwnFile(sanitize::path_text(name));
    let mut all = BTreeMap::new();
    for figure in figures {
        let own = own_files(figure);
        let carried = carried(figure, &mut files.clone()).map_err(|left| no_room(&left.0.join(", ")))?.0;
        if let Some(missing) = own.keys().find(|name| !carried.contains_key(**name)) {
            return Err(no_room(missing));
        }
        all.extend(carried.iter().map(|(name, packed)| (name.clone(), packed.clone())));
        if let Some(name) = own.keys().find(|_| all.values().map(Vec::len).sum::<usize>() > MAX_HANDED_OUT_BYTES) {
            return Err(no_room(name));
        }
    }
    Ok(if all.is_empty() { text.to_owned() } else { Carried(all.into()).join(text) })
}

/// Writes the files that the figures of a link's lesson use into the folder of its copy. Returns the names of those
/// that aren't there afterwards. Links come from strangers, so only meshes, what they name, and images are written,
/// never over another file, and never outside the folder.
pub fn save_carried(link: &Path, lesson: &Lesson, folder: &Path) -> Option<LeftOut> {
    let mut files = FigureFiles::of_lesson(Some(link), false);
    let (mut all, mut left_out) = (BTreeMap::new(), BTreeSet::new());
    for (name, of) in lesson.steps.iter().flat_map(|step| own_files(&step.figure)) {
        let read = files.read(Wanted { path: name, named_by: None }).ok();
        match read.and_then(|bytes| Some((companions((name, of), &bytes, &mut files)?, bytes))) {
            Some((beside, bytes)) => {
                all.insert(name.to_owned(), bytes);
                all.extend(beside);
            }
            None => drop(left_out.insert(name.to_owned())),
        }
    }
    left_out.extend(all.into_iter().filter(|(name, bytes)| !is_beside(folder, name, bytes)).map(|(name, _)| name));
    (!left_out.is_empty()).then(|| LeftOut(left_out.into_iter().collect()))
}

/// Writes a file by its name into a folder or below. True if it's there now.
fn is_beside(folder: &Path, name: &str, bytes: &[u8]) -> bool {
    let (mut path, mut depth) = (folder.to_owned(), 0_usize);
    for part in Path::new(name).components() {
        match part {
            Component::Normal(part) => {
                path.push(part);
                depth += 1;
            }
            Component::CurDir => {}
            Component::ParentDir if depth > 0 => {
                path.pop();
                depth -= 1;
            }
            _ => return false,
        }
    }
    let above = path.parent().unwrap_or(folder);
    let known = above.ancestors().find(|folder| disk::may_exist(folder)).unwrap_or(above);
    let [Ok(known), Ok(whole)] = [known, folder].map(disk::canonical) else { return false };
    if !known.starts_with(whole) {
        return false;
    }
    match disk::canonical(&path) {
        Ok(there) => crate::read_at_most(&there, bytes.len() as u64).is_ok_and(|other| other == bytes),
        // A link that leads nowhere would be followed.
        Err(_) if path.is_symlink() => false,
        Err(_) => disk::create_folder(above).is_ok() && crate::save(&path, bytes, Overwrite::Writable).is_ok(),
    }
}

/// A figure as it's written to `path` with its files, in a new folder beside it: the figure, its new names, and the
/// files. Those that can't be read are left out and keep their names.
pub fn beside_figure(
    figure: &Figure,
    mut files: FigureFiles,
    path: &Path,
) -> (Figure, Renamed, Vec<(PathBuf, Vec<u8>)>) {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let folders = std::iter::once(format!("{stem}-files")).chain((2..1000).map(|k| format!("{stem}-files-{k}")));
    let is_free = |name: &String| !disk::may_exist(&path.with_file_name(name));
    let folder = folders.into_iter().find(is_free).unwrap_or_else(|| format!("{stem}-files"));
    let (mut renamed, mut written) = (Renamed::new(), Vec::new());
    for (k, (name, of)) in own_files(figure).into_iter().enumerate() {
        let Ok(bytes) = files.read(Wanted { path: name, named_by: None }) else { continue };
        let Some(beside) = companions((name, of), &bytes, &mut files) else { continue };
        let (above, own) = name.rsplit_once(['/', '\\']).map_or(("", name), |(above, own)| (above, own));
        // Files of one name from different folders, and what they name, must not meet.
        let new = |own: &str| format!("{folder}/{}/{own}", k + 1);
        renamed.insert(name.to_owned(), new(own));
        written.push((path.with_file_name(new(own)), bytes));
        for (name, bytes) in beside {
            // A file outside the folder of the mesh keeps its place.
            if let Some(inside) = name.strip_prefix(above).map(|rest| rest.trim_start_matches(['/', '\\']))
                && !Path::new(inside).components().any(|part| part == Component::ParentDir)
            {
                written.push((path.with_file_name(new(inside)), bytes));
            }
        }
    }
    let mut figure = figure.clone();
    rename(figure.files_mut(), &renamed);
    (figure, renamed, written)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::FileAccess;
    use crate::carried::MARK;
    use crate::figure::read::parse;
    use crate::share::{self, Held};
    use crate::testing::Directory;

    #[test]
    fn a_link_to_a_figure_or_a_lesson_carries_its_meshes() {
        let directory = Directory::new("travel-link");
        let mesh = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        std::fs::write(directory.path().join("m.obj"), mesh).unwrap();
        let object = "name = \"m\"\nshape = \"mesh\"\npath = \"m.obj\"\n";
        let text = format!("[[scene.objects]]\n{object}");
        let figure = parse(&text).unwrap();
        let files = FigureFiles::new(directory.path(), FileAccess::Figure);
        let read = |mut files: FigureFiles| files.read(Wanted { path: "m.obj", named_by: None }).ok();
        let link = |held, whole: &str| PathBuf::from(share::link("", held, whole).unwrap());
        let whole = link(Held::Figure, &text_with_files(&text, [&figure], &files).unwrap());
        let opened = crate::open_figure(&whole).unwrap();
        assert_eq!((opened.figure, opened.text, opened.from_picture), (figure.clone(), text.clone(), true));
        assert_eq!(read(FigureFiles::new(Path::new(""), FileAccess::Link).with(&opened.carried)), Some(mesh.to_vec()));
        // The same in a lesson, whose link the window keeps in place of a path.
        let lesson =
            format!("id = \"own\"\ntitle = \"Own\"\n[[step]]\ntitle = \"One\"\n[[step.scene.objects]]\n{object}");
        let parsed = crate::lessons::parse(&lesson).unwrap();
        let path = directory.path().join("own.toml");
        let whole = crate::hand_out::lesson_with_files(&lesson, &parsed, Some(&path)).unwrap();
        let whole = link(Held::Lesson, &whole);
        assert_eq!(crate::read_lesson(&whole).unwrap().1, lesson);
        assert_eq!(read(FigureFiles::of_lesson(Some(&whole), false)), Some(mesh.to_vec()));
        // A copy of the lesson has them beside it. Another file of the name stays, and is reported.
        let copy = directory.path().join("copy");
        std::fs::create_dir(&copy).unwrap();
        for _ in 0..2 {
            assert_eq!(save_carried(&whole, &parsed, &copy), None);
        }
        assert_eq!(std::fs::read(copy.join("m.obj")).unwrap(), mesh);
        std::fs::write(copy.join("m.obj"), "mine").unwrap();
        assert_eq!(save_carried(&whole, &parsed, &copy), Some(LeftOut(vec!["m.obj".to_owned()])));
        assert_eq!(std::fs::read(copy.join("m.obj")).unwrap(), b"mine");
        // Files for other places, and files that no figure uses, aren't written.
        let line = |name: &str| {
            Carried([(name.to_owned(), packed(mesh, 99).unwrap())].into_iter().collect::<BTreeMap<_, _>>().into())
        };
        let names = ["../out.obj", "/tmp/camera-lab-out.obj", "a/../../out.obj"];
        for name in names {
            let own = lesson.replace("m.obj", name);
            let link = link(Held::Lesson, &line(name).join(&own));
            let parsed = crate::lessons::parse(&own).unwrap();
            assert_eq!(save_carried(&link, &parsed, &copy), Some(LeftOut(vec![name.to_owned()])));
        }
        let unused = link(Held::Lesson, &line("unused.obj").join(&lesson));
        save_carried(&unused, &parsed, &copy);
        assert_eq!(std::fs::read_dir(&copy).unwrap().count(), 1);
        assert!(!directory.path().join("out.obj").exists() && !Path::new(names[1]).exists());
        // Places within the folder are found however they're written.
        let own = lesson.replace("m.obj", "./a/../b/m.obj");
        let whole = link(Held::Lesson, &line("./a/../b/m.obj").join(&own));
        assert_eq!(save_carried(&whole, &crate::lessons::parse(&own).unwrap(), &copy), None);
        assert_eq!(std::fs::read(copy.join("b/m.obj")).unwrap(), mesh);
        #[cfg(unix)]
        {
            let elsewhere = directory.path().join("elsewhere");
            std::fs::create_dir(&elsewhere).unwrap();
            std::os::unix::fs::symlink(&elsewhere, copy.join("up")).unwrap();
            std::os::unix::fs::symlink(elsewhere.join("new.obj"), copy.join("new.obj")).unwrap();
            for name in ["up/m.obj", "new.obj"] {
                let own = lesson.replace("m.obj", name);
                let link = link(Held::Lesson, &line(name).join(&own));
                assert!(save_carried(&link, &crate::lessons::parse(&own).unwrap(), &copy).is_some(), "{name}");
            }
            assert_eq!(std::fs::read_dir(&elsewhere).unwrap().count(), 0);
        }
        // One that can't be read is named, and a text without files stays as it is.
        std::fs::remove_file(directory.path().join("m.obj")).unwrap();
        assert!(matches!(text_with_files(&text, [&figure], &files), Err(FileError::OwnFile(name)) if name == "m.obj"));
        assert_eq!(text_with_files("x", [&Figure::default()], &files).unwrap(), "x");
    }

    #[test]
    fn only_the_files_of_the_figure_travel() {
        let directory = Directory::new("travel");
        let file = |name: &str, bytes: &[u8]| std::fs::write(directory.path().join(name), bytes).unwrap();
        file("m.obj", b"mtllib m.mtl\nmtllib secret.txt\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
        file("m.mtl", b"newmtl red\nKd 1 0 0\n");
        file("secret.txt", b"newmtl secret\n");
        file("secret.png", b"my password");
        let figure = parse(
            "[image]\nphotograph = \"secret.png\"\n[[scene.objects]]\nname = \"m\"\nshape = \"mesh\"\npath = \"m.obj\"\n\
             [[scene.objects]]\nname = \"t\"\nshape = \"mesh\"\npath = \"camera-lab:teapot.obj\"\n",
        )
        .unwrap();
        let files = || FigureFiles::new(directory.path(), FileAccess::Figure);
        let names: Vec<String> = carried(&figure, &mut files()).unwrap().0.keys().cloned().collect();
        assert_eq!(names, ["m.mtl", "m.obj"]);
        // In a picture elsewhere, only what it doesn't carry is looked for in the old folder.
        let picture = directory.path().join("sub").join("p.png");
        let (text, left_out) = text_in_picture(crate::figure::write::to_toml, &figure, files(), &picture);
        let secret = directory.path().join("secret.png").display().to_string();
        assert!(text.contains("\"m.obj\"") && text.contains(&format!("\"{secret}\"")) && left_out.is_none(), "{text}");
        // With its files, it's written to a folder of its own, which is new each time.
        let target = directory.path().join("new.toml");
        std::fs::create_dir(directory.path().join("new-files")).unwrap();
        let (moved, renamed, written) = beside_figure(&figure, files(), &target);
        let new = &renamed["m.obj"];
        assert!(new.starts_with("new-files-2/") && new.ends_with("/m.obj"), "{new}");
        assert_eq!(moved.scene.objects[0].shape.as_ref().unwrap().mesh_file(), Some(new.as_str()));
        assert_eq!(moved.photograph, figure.photograph, "it isn't there");
        let beside = directory.path().join(new).with_file_name("m.mtl");
        assert!(written.iter().any(|(path, bytes)| *path == beside && bytes == b"newmtl red\nKd 1 0 0\n"));
        assert_eq!(written.len(), 2);
    }

    #[test]
    fn too_many_bytes_are_left_out_and_named_from_the_folder_of_the_picture() {
        let directory = Directory::new("too-large");
        let mut mesh = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        let mut state = 1_u64;
        for _ in 0..120_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            mesh.push_str(&format!("v {} {} {}\n", state >> 20, state >> 30, state >> 40));
        }
        std::fs::write(directory.path().join("large.obj"), mesh).unwrap();
        let figure = parse("[[scene.objects]]\nname = \"m\"\nshape = \"mesh\"\npath = \"large.obj\"\n").unwrap();
        let files = FigureFiles::new(directory.path(), FileAccess::Figure);
        let to = |name: &str| {
            let path = directory.path().join(name);
            text_in_picture(crate::figure::write::to_toml, &figure, files.clone(), &path)
        };
        let (text, left_out) = to("sub/p.png");
        assert_eq!(left_out, Some(LeftOut(vec!["large.obj".to_owned()])));
        let whole = directory.path().join("large.obj").display().to_string();
        assert!(text.contains(&whole) && !text.contains(MARK), "{text}");
        assert!(to("p.svg").0.contains("\"large.obj\""));
        assert_eq!(to("p.webp").1, None, "it holds no figure");
    }
}
