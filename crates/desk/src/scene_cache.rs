//! The scene in the pictures, rebuilt only when the figure's has changed. Mesh files are read beside the window's
//! thread. Until a file is there, or if it can't be read, the rest of the scene is shown without it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use super::document::Document;
use super::history::Revision;
use crate::appearance::{HiddenLines, Texture, Theme};
use crate::background::memo::Latest;
use crate::background::worker::Running;
use crate::progress::Progress;
use crate::scene::import::{Imported, read, read_texture};
use crate::scene::{
    self, FileUse, MeshError, MeshFiles, MeshNotice, Preset, ReadError, ReadProblem, Scene, SceneError, SceneSpec,
    Shape, TextureError, TextureFault, TextureSource, Wanted,
};
use crate::views::SharedScene;
use crate::{Wake, clock, sanitize};
use camera_lab_files::{Carried, FigureFiles, FileAccess};

/// More vertices and triangles than this take longer to look through than a frame has.
const HEAVY: usize = 60_000;

/// True if looking through a scene takes longer than a frame. Then such work is done beside the window's thread.
pub fn is_heavy(scene: &Scene) -> bool {
    scene.objects.iter().map(|o| o.mesh.positions.len() + o.mesh.triangles.len()).sum::<usize>() > HEAVY
}

/// The scene of the figure, or the last one that could be built.
#[derive(Debug, Default)]
pub struct SceneCache {
    made_from: Option<MadeFrom>,
    files: MeshFiles,
    /// Unreadable files. They aren't tried again automatically.
    broken: BTreeMap<String, MeshError>,
    /// Missing files that the mesh files name, and that they can be drawn without.
    unread: BTreeMap<String, Vec<ReadError>>,
    reader: Reader,
    scene: SharedScene,
    /// The reason why the photograph of the scene can't be used, and true if it hasn't been reported yet.
    lacks_photograph: (Option<MeshNotice>, bool),
    /// Counts the unrelated scenes.
    subject: u64,
}

#[derive(Clone, Debug)]
struct MadeFrom {
    spec: SceneSpec,
    /// The file of the photograph under the image.
    photograph: Option<String>,
    /// The revision of the document's scene.
    revision: Revision,
    theme: Theme,
    hidden_lines: HiddenLines,
    folder: Option<PathBuf>,
    reach: FileAccess,
    carried: Carried,
}

impl MadeFrom {
    fn is_of(&self, document: &Document, theme: Theme) -> bool {
        let figure = document.figure();
        self.theme == theme
            && self.hidden_lines == figure.style.hidden_lines
            && self.folder.as_deref() == document.folder()
            && self.reach == document.reach()
            && self.carried == *document.carried()
            && self.photograph.as_deref() == photograph_of(figure)
            && (self.revision == document.revision() || self.spec == figure.scene)
    }
}

/// The content of a file.
#[derive(Debug)]
enum Read {
    Mesh(Result<Arc<Imported>, MeshError>),
    Texture(Result<Arc<Texture>, TextureError>),
}

/// The result of reading a file.
#[derive(Debug)]
struct BuiltScene {
    read: Read,
    /// Bytes read for it and for the files it names.
    bytes: usize,
    /// The missing files that it names.
    unread: Vec<ReadError>,
}

/// A file to read.
#[derive(Clone, Debug, PartialEq)]
struct SceneFile {
    path: String,
    /// True for a texture, false for a mesh.
    is_texture: bool,
    folder: PathBuf,
    reach: FileAccess,
    carried: Carried,
    /// The bytes of the figure's other files.
    spent: usize,
}

impl SceneFile {
    async fn read(&self, progress: &Progress) -> BuiltScene {
        let mut files = FigureFiles::new(&self.folder, self.reach).with(&self.carried).after(self.spent);
        let mut read_file = |wanted: Wanted<'_>| files.read(wanted);
        let read = if self.is_texture {
            Read::Texture(read_texture(&self.path, &mut read_file))
        } else {
            Read::Mesh(read(&self.path, &mut read_file, progress).await)
        };
        BuiltScene { read, bytes: files.spent() - self.spent, unread: files.unread().to_vec() }
    }
}

/// Reads one file after the other.
#[derive(Debug)]
struct Reader {
    read: Latest<SceneFile, BuiltScene>,
    /// The files that come next.
    waiting: Vec<SceneFile>,
    /// Bytes read for each file in use.
    bytes: BTreeMap<String, usize>,
}

impl Default for Reader {
    fn default() -> Self {
        let read = Latest::new("meshes", || {
            // A file that stalls mustn't keep the others from being read.
            #[cfg(not(target_arch = "wasm32"))]
            camera_lab_files::limit_waiting(camera_lab_files::reader_wait());
            async |file: &SceneFile, progress: &Progress| file.read(progress).await
        });
        Self { read, waiting: Vec::new(), bytes: BTreeMap::new() }
    }
}

impl Reader {
    /// Has these files read, and no others.
    fn begin(&mut self, window: &dyn Wake, files: Vec<SceneFile>) {
        // A file of another scene may stall.
        self.read.leave();
        self.waiting = files;
        self.next(window);
    }

    fn next(&mut self, window: &dyn Wake) {
        if !self.is_busy() && !self.waiting.is_empty() {
            let mut file = self.waiting.remove(0);
            file.spent = self.bytes.values().sum();
            self.read.ask_again(window, file);
        }
    }

    /// The file being read.
    fn reading(&self) -> Option<&SceneFile> {
        self.read.waiting()
    }

    fn is_busy(&self) -> bool {
        self.reading().is_some()
    }

    /// The next file that has been read. Waits for it up to `patience`.
    fn take(&mut self, window: &dyn Wake, patience: Duration) -> Option<(String, BuiltScene)> {
        self.reading()?;
        let read = self.read.take(patience);
        if read.is_none() && self.is_busy() {
            return None;
        }
        if let Some((file, outcome)) = &read {
            self.bytes.insert(file.path.clone(), outcome.bytes);
        }
        self.next(window);
        match read {
            Some((file, outcome)) => Some((file.path, outcome)),
            // After a panic, missing files are requested again with the next change.
            None => self.take(window, patience),
        }
    }
}

impl SceneCache {
    /// The scene. It changes only after the figure's has changed.
    pub fn scene(&self) -> &SharedScene {
        &self.scene
    }

    /// True if the scene belongs to a document, and not to one before it.
    pub fn is_of(&self, document: &Document, theme: Theme) -> bool {
        self.loading().is_empty() && self.made_from.as_ref().is_some_and(|made| made.is_of(document, theme))
    }

    /// A number that stays the same while one scene is edited, and changes when another scene replaces it.
    pub fn subject(&self) -> u64 {
        self.subject
    }

    /// Announces another scene, even if it looks the same.
    pub fn expect_another(&mut self) {
        self.subject += 1;
    }

    /// The files that are being read.
    pub fn loading(&self) -> Vec<&str> {
        self.reader.reading().into_iter().chain(&self.reader.waiting).map(|file| file.path.as_str()).collect()
    }

    /// The file being read, and its progress.
    pub fn running(&self) -> Option<(&str, Running)> {
        Some((self.reader.reading()?.path.as_str(), self.reader.read.running()?))
    }

    /// Gives up reading. The files count as unreadable.
    pub fn cancel(&mut self) {
        self.reader.read.stop();
        self.broken.extend(self.reader.waiting.drain(..).map(|file| (file.path, MeshError::Cancelled)));
    }

    /// The reason why the file of an object can't be used.
    pub fn problem_of(&self, object: &str) -> Option<SceneError> {
        let spec = &self.made_from.as_ref()?.spec;
        let Some(Shape::Mesh { path }) = &spec.objects.iter().find(|o| o.name == object)?.shape else { return None };
        let error = self.broken.get(path)?.clone();
        Some(SceneError::Mesh { name: object.to_owned(), path: path.clone(), error })
    }

    /// The missing files that the mesh file of an object names, and that it can be drawn without.
    pub fn unread_of(&self, object: &str) -> &[ReadError] {
        let spec = self.made_from.as_ref().map(|made| &made.spec);
        let shape = spec.and_then(|spec| spec.objects.iter().find(|o| o.name == object)).and_then(|o| o.shape.as_ref());
        let Some(Shape::Mesh { path }) = shape else { return &[] };
        self.unread.get(path).map_or(&[], Vec::as_slice)
    }

    /// The names of the figure's files that can't be read, each with true if there is no such file.
    pub fn lost_files(&self) -> BTreeMap<String, bool> {
        let meshes = self.broken.iter().filter_map(|(path, error)| match error {
            MeshError::Unreadable(error) => Some((sanitize::path_text(path), &error.problem)),
            _ => None,
        });
        let notices = self.scene.notices.iter().filter_map(|(_, notice)| match notice {
            MeshNotice::Texture(TextureError { file, fault: TextureFault::Unreadable(error) })
            | MeshNotice::Photograph(TextureError { file, fault: TextureFault::Unreadable(error) }) => {
                Some((file.clone(), &error.problem))
            }
            _ => None,
        });
        let is_gone =
            |problem: &ReadProblem| matches!(problem, ReadProblem::System { kind: std::io::ErrorKind::NotFound, .. });
        meshes.chain(notices).map(|(name, problem)| (name, is_gone(problem))).collect()
    }

    /// The reason why the photograph under the image can't be used, once.
    pub fn take_notice(&mut self) -> Option<MeshNotice> {
        std::mem::take(&mut self.lacks_photograph.1).then(|| self.lacks_photograph.0.clone()).flatten()
    }

    /// Tries unreadable files again, and rereads the others.
    pub fn read_again(&mut self) {
        self.forget_files();
        self.made_from = None;
    }

    fn forget_files(&mut self) {
        self.files = MeshFiles::default();
        self.broken.clear();
        self.unread.clear();
        self.reader.bytes.clear();
    }

    /// Builds the scene, in the colours of `theme`, if the figure's has changed, or a mesh file has been read. Looks
    /// for meshes beside the figure file. Waits up to `patience` for a file that is being begun. Requests a frame of
    /// `window` when one is read.
    ///
    /// # Errors
    /// A failure to read or build. It's reported once, not in each frame.
    pub fn update(
        &mut self,
        window: &dyn Wake,
        document: &Document,
        theme: Theme,
        patience: Duration,
    ) -> Result<(), SceneError> {
        let figure = document.figure();
        let changed = !self.made_from.as_ref().is_some_and(|made| made.is_of(document, theme));
        if !changed && let Some(made) = &mut self.made_from {
            // Another number may have come to the same scene.
            made.revision = document.revision();
            if !self.reader.is_busy() {
                return Ok(());
            }
        }
        let wanted = MadeFrom {
            spec: figure.scene.clone(),
            photograph: photograph_of(figure).map(str::to_owned),
            revision: document.revision(),
            theme,
            hidden_lines: figure.style.hidden_lines,
            folder: document.folder().map(Path::to_owned),
            reach: document.reach(),
            carried: document.carried().clone(),
        };
        let mut said = Ok(());
        let before = self.made_from.take();
        let is_elsewhere = |before: &MadeFrom| {
            (&before.folder, before.reach, &before.carried) != (&wanted.folder, wanted.reach, &wanted.carried)
        };
        if before.as_ref().is_some_and(is_elsewhere) {
            // Another folder means other files under the same names. With another reach, other files may be read.
            self.forget_files();
            self.reader.begin(window, Vec::new());
        }
        if before
            .as_ref()
            .is_some_and(|before| before.spec.preset != wanted.spec.preset && wanted.spec.preset != Preset::Empty)
        {
            self.subject += 1;
        }
        self.made_from = before;
        let mut arrived = self.receive(window, Duration::ZERO, &wanted, &mut said);
        if changed || arrived {
            let used = paths(&wanted);
            let is_used = |path: &String| [true, false].into_iter().any(|kind| used.contains(&(path.clone(), kind)));
            self.broken.retain(|path, _| is_used(path));
            self.unread.retain(|path, _| is_used(path));
            self.reader.bytes.retain(|path, _| is_used(path));
            if self.begin_to_load(window, &wanted) {
                arrived |= self.receive(window, patience, &wanted, &mut said);
            }
        }
        if changed || arrived {
            said = said.and(self.build(wanted));
        }
        said
    }

    /// Takes over files that have been read. Returns true if there are any. Waits up to `patience` for all.
    fn receive(
        &mut self,
        window: &dyn Wake,
        patience: Duration,
        wanted: &MadeFrom,
        said: &mut Result<(), SceneError>,
    ) -> bool {
        let mut arrived = false;
        let end = clock::now() + patience;
        while let Some((path, BuiltScene { read, unread, .. })) =
            self.reader.take(window, end.saturating_sub(clock::now()))
        {
            arrived = true;
            self.unread.remove(&path);
            let imported = match read {
                Read::Texture(read) => {
                    self.files.insert_texture(&path, read);
                    continue;
                }
                Read::Mesh(imported) => imported,
            };
            if !unread.is_empty() && imported.is_ok() {
                self.unread.insert(path.clone(), unread);
            }
            match imported {
                Ok(imported) => self.files.insert(&path, imported),
                Err(error) => {
                    let shape = Some(Shape::Mesh { path: path.clone() });
                    if let Some(object) = wanted.spec.objects.iter().find(|o| o.shape == shape) {
                        let name = object.name.clone();
                        *said = Err(SceneError::Mesh { name, path: path.clone(), error: error.clone() });
                    }
                    self.broken.insert(path, error);
                }
            }
        }
        arrived
    }

    /// Starts reading unknown files, unless others are being read. Returns true if it has started.
    fn begin_to_load(&mut self, window: &dyn Wake, wanted: &MadeFrom) -> bool {
        if self.reader.is_busy() {
            return false;
        }
        let unknown = |(path, is_texture): &(String, bool)| {
            let is_known = if *is_texture { self.files.knows_texture(path) } else { self.files.knows(path) };
            !is_known && !self.broken.contains_key(path)
        };
        let folder = wanted.folder.clone().unwrap_or_default();
        let file = |(path, is_texture)| {
            let (folder, reach, carried) = (folder.clone(), wanted.reach, wanted.carried.clone());
            SceneFile { path, is_texture, folder, reach, carried, spent: 0 }
        };
        let missing: Vec<SceneFile> = paths(wanted).into_iter().filter(unknown).map(file).collect();
        if missing.is_empty() {
            return false;
        }
        self.reader.begin(window, missing);
        true
    }

    /// Builds the scene. Objects without their mesh are left out.
    fn build(&mut self, wanted: MadeFrom) -> Result<(), SceneError> {
        let mut spec = wanted.spec.clone();
        for object in &mut spec.objects {
            if matches!(&object.shape, Some(Shape::Mesh { path }) if !self.files.knows(path)) {
                object.shape = None;
            }
            // Its colour is shown until the texture is loaded.
            if matches!(&object.texture, Some(TextureSource::File(path)) if !self.files.knows_texture(path)) {
                object.texture = None;
            }
        }
        let style = crate::appearance::Style {
            theme: wanted.theme,
            hidden_lines: wanted.hidden_lines,
            ..crate::appearance::Style::default()
        };
        // Without it until it's there.
        let photograph = wanted.photograph.as_deref();
        self.files.show_photograph(photograph.filter(|path| self.files.knows_texture(path)));
        self.made_from = Some(wanted);
        let scene = scene::build_with(&spec, &style, &mut scene::no_files, &mut self.files)?;
        let mut notices = scene.notices.iter().map(|(_, notice)| notice);
        let lacks = notices.find(|notice| matches!(notice, MeshNotice::Photograph(_))).cloned();
        if lacks != self.lacks_photograph.0 {
            self.lacks_photograph = (lacks, true);
        }
        self.scene = SharedScene::new(scene);
        Ok(())
    }
}

fn photograph_of(figure: &crate::figure::Figure) -> Option<&str> {
    figure.photograph.as_ref().map(|photograph| photograph.file.as_str())
}

/// The mesh files of a scene, and its textures and photograph, for which the value is true.
fn paths(MadeFrom { spec, photograph, .. }: &MadeFrom) -> BTreeSet<(String, bool)> {
    let photograph = photograph.iter().map(|path| (path.as_str(), FileUse::Image));
    let all = spec.files().chain(photograph).map(|(path, of)| (path.to_owned(), of == FileUse::Image));
    // An empty name of an image hasn't been typed yet.
    all.filter(|(path, is_texture)| !(*is_texture && path.is_empty())).collect()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

    use super::*;
    use crate::testing::{Directory, Stall};
    use camera_lab_files::SourceFile;

    #[test]
    fn a_stalled_file_keeps_no_other_file_of_the_figure_from_being_read() {
        let directory = Directory::new("stalled-mesh");
        let mesh = |name: &str| {
            std::fs::write(directory.path().join(name), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
            format!("[[scene.objects]]\nname = \"{name}\"\nshape = \"mesh\"\npath = \"{name}\"\n")
        };
        let text = ["slow.obj", "there.obj"].map(mesh).concat();
        let figure = crate::figure::read::parse(&text).unwrap();
        let path = directory.path().join("figure.toml");
        let document = Document::new(figure, Some(SourceFile { path, text, ..SourceFile::default() })).unwrap();
        let mut cache = SceneCache::default();
        let stall = Stall::of(&directory.path().join("slow.obj"));
        let end = clock::now() + Duration::from_secs(60);
        let mut reported = Ok(());
        while !cache.is_of(&document, Theme::Light) {
            assert!(clock::now() < end);
            reported = reported.and(cache.update(&(), &document, Theme::Light, Duration::from_millis(20)));
        }
        drop(stall);
        let names: Vec<&str> = cache.scene().objects.iter().map(|object| object.name.as_str()).collect();
        assert_eq!(names, ["there.obj"]);
        assert!(cache.problem_of("slow.obj").is_some() && reported.is_err());
    }
}
