//! The scene that the pictures show, made anew only when the figure's has changed. Mesh files are read beside the window's
//! thread: until one is there, and where one cannot be read, the rest of the scene is shown without it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use eframe::egui;

use super::document::Document;
use crate::appearance::{HiddenLines, Theme};
use crate::files;
use crate::geometry::Aabb;
use crate::scene::import::{Part, read};
use crate::scene::{self, MeshError, MeshFiles, Preset, Scene, SceneError, SceneSpec, Shape};

/// The scene of the figure, or the last one that could be made.
#[derive(Debug, Default)]
pub struct Scenery {
    made_from: Option<MadeFrom>,
    files: MeshFiles,
    /// Files that could not be read; they are not tried again by themselves.
    broken: BTreeMap<String, MeshError>,
    loading: Option<Loading>,
    scene: Arc<Scene>,
    bounds: Option<Aabb>,
    /// Counts the scenes that have nothing to do with each other.
    subject: u64,
}

#[derive(Clone, Debug, PartialEq)]
struct MadeFrom {
    spec: SceneSpec,
    theme: Theme,
    hidden_lines: HiddenLines,
    folder: Option<PathBuf>,
}

impl MadeFrom {
    fn is_of(&self, document: &Document) -> bool {
        let figure = document.figure();
        self.spec == figure.scene
            && self.theme == figure.style.theme
            && self.hidden_lines == figure.style.hidden_lines
            && self.folder.as_deref() == document.folder()
    }
}

type Parts = Result<Arc<Vec<Part>>, MeshError>;

/// Files that are being read.
#[derive(Debug)]
struct Loading {
    paths: BTreeSet<String>,
    done: Receiver<(String, Parts)>,
}

/// What is done beside the window's thread.
#[derive(Clone)]
struct Task {
    paths: BTreeSet<String>,
    folder: PathBuf,
    ctx: egui::Context,
    send: Sender<(String, Parts)>,
}

impl Task {
    fn run(self) {
        let mut read_file = |name: &str| files::read_for_scene(&self.folder.join(name));
        for path in self.paths {
            let parts = read(&path, &mut read_file);
            // Nobody waits any more when another figure has been opened.
            if self.send.send((path, parts)).is_err() {
                return;
            }
            self.ctx.request_repaint();
        }
    }
}

impl Scenery {
    /// The scene. It is another one (for `Arc::ptr_eq`) only after the figure's has changed.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// The box around the scene.
    #[must_use]
    pub fn bounds(&self) -> Option<Aabb> {
        self.bounds
    }

    /// A number that stays while one and the same scene is changed, and is another one after another scene has come.
    #[must_use]
    pub fn subject(&self) -> u64 {
        self.subject
    }

    /// Says that what comes next is another scene, whatever it looks like.
    pub fn expect_another(&mut self) {
        self.subject += 1;
    }

    /// The files that are being read.
    #[must_use]
    pub fn loading(&self) -> Vec<&str> {
        self.loading.iter().flat_map(|loading| &loading.paths).map(String::as_str).collect()
    }

    /// Why the file of an object cannot be used.
    #[must_use]
    pub fn problem_of(&self, object: &str) -> Option<SceneError> {
        let spec = &self.made_from.as_ref()?.spec;
        let Some(Shape::Mesh { path }) = &spec.objects.iter().find(|o| o.name == object)?.shape else { return None };
        let error = self.broken.get(path)?.clone();
        Some(SceneError::Mesh { name: object.to_owned(), path: path.clone(), error })
    }

    /// Tries the files again that could not be read, and reads the others anew.
    pub fn read_again(&mut self) {
        self.files = MeshFiles::default();
        self.broken.clear();
        self.made_from = None;
    }

    /// Makes the scene where the figure's has changed, or a mesh file has been read. Meshes are looked for beside the figure file.
    /// Waits up to `patience` for a file that is being begun; `ctx` is asked for a frame when one is read.
    ///
    /// # Errors
    /// What cannot be read or built. It is said once, not in each frame.
    pub fn update(&mut self, ctx: &egui::Context, document: &Document, patience: Duration) -> Result<(), SceneError> {
        let figure = document.figure();
        if self.loading.is_none() && self.made_from.as_ref().is_some_and(|made| made.is_of(document)) {
            return Ok(());
        }
        let wanted = MadeFrom {
            spec: figure.scene.clone(),
            theme: figure.style.theme,
            hidden_lines: figure.style.hidden_lines,
            folder: document.folder().map(Path::to_owned),
        };
        let mut said = Ok(());
        let before = self.made_from.as_ref();
        let changed = before != Some(&wanted);
        if before.is_some_and(|before| before.folder != wanted.folder) {
            // Another folder: other files under the same names.
            self.files = MeshFiles::default();
            self.broken.clear();
            self.loading = None;
        }
        if before.is_some_and(|before| before.spec.preset != wanted.spec.preset && wanted.spec.preset != Preset::Empty)
        {
            self.subject += 1;
        }
        let mut arrived = self.receive(Duration::ZERO, &wanted, &mut said);
        if changed || arrived {
            if self.begin_to_load(ctx, &wanted) {
                arrived |= self.receive(patience, &wanted, &mut said);
            }
            self.broken.retain(|path, _| paths(&wanted.spec).contains(path));
        }
        if changed || arrived {
            said = said.and(self.build(wanted));
        }
        said
    }

    /// Takes over what has been read; true where something has. Waits up to `patience` until all is.
    fn receive(&mut self, patience: Duration, wanted: &MadeFrom, said: &mut Result<(), SceneError>) -> bool {
        let mut arrived = false;
        while let Some(loading) = &mut self.loading {
            match loading.done.recv_timeout(patience) {
                Ok((path, parts)) => {
                    arrived = true;
                    loading.paths.remove(&path);
                    if loading.paths.is_empty() {
                        self.loading = None;
                    }
                    match parts {
                        Ok(parts) => self.files.insert(&path, parts),
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
                Err(RecvTimeoutError::Timeout) => break,
                // Whoever read has been lost; what is missing is asked for again with the next change.
                Err(RecvTimeoutError::Disconnected) => self.loading = None,
            }
        }
        arrived
    }

    /// Has the files read that are not known, unless others are being read; true where that has begun.
    fn begin_to_load(&mut self, ctx: &egui::Context, wanted: &MadeFrom) -> bool {
        if self.loading.is_some() {
            return false;
        }
        let unknown = |path: &String| !self.files.knows(path) && !self.broken.contains_key(path);
        let missing: BTreeSet<String> = paths(&wanted.spec).into_iter().filter(unknown).collect();
        if missing.is_empty() {
            return false;
        }
        let (send, done) = channel();
        let task =
            Task { paths: missing.clone(), folder: wanted.folder.clone().unwrap_or_default(), ctx: ctx.clone(), send };
        let again = task.clone();
        // Where there are no threads it is done here.
        if std::thread::Builder::new().name("meshes".to_owned()).spawn(move || task.run()).is_err() {
            again.run();
        }
        self.loading = Some(Loading { paths: missing, done });
        true
    }

    /// Builds the scene; what has no mesh is left out of it.
    fn build(&mut self, wanted: MadeFrom) -> Result<(), SceneError> {
        let mut spec = wanted.spec.clone();
        for object in &mut spec.objects {
            if matches!(&object.shape, Some(Shape::Mesh { path }) if !self.files.knows(path)) {
                object.shape = None;
            }
        }
        let style = crate::appearance::Style {
            theme: wanted.theme,
            hidden_lines: wanted.hidden_lines,
            ..crate::appearance::Style::default()
        };
        self.made_from = Some(wanted);
        let scene = scene::build_with(&spec, &style, &mut scene::no_files, &mut self.files)?;
        self.bounds = scene.bounds();
        self.scene = Arc::new(scene);
        Ok(())
    }
}

/// The mesh files of a scene.
fn paths(spec: &SceneSpec) -> BTreeSet<String> {
    let path = |shape: &Option<Shape>| match shape {
        Some(Shape::Mesh { path }) => Some(path.clone()),
        _ => None,
    };
    spec.objects.iter().filter_map(|o| path(&o.shape)).collect()
}
