//! The scene that the pictures show, made anew only when the figure's has changed.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::document::Document;
use crate::appearance::{HiddenLines, Theme};
use crate::files;
use crate::i18n::{Lang, messages};
use crate::scene::{self, MeshFiles, Scene, SceneSpec};

/// The scene of the figure, or the last one that could be made.
#[derive(Debug, Default)]
pub struct Scenery {
    made_from: Option<(SceneSpec, Theme, HiddenLines, Option<PathBuf>)>,
    files: MeshFiles,
    scene: Arc<Scene>,
}

impl Scenery {
    /// The scene. It is another one (for `Arc::ptr_eq`) only after the figure's has changed.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Makes the scene where the figure's has changed. Meshes are looked for beside the figure file.
    ///
    /// # Errors
    /// What cannot be read or built, as a sentence; the last scene stays. It is said once, not in each frame.
    pub fn update(&mut self, document: &Document, lang: Lang) -> Result<(), String> {
        let figure = document.figure();
        let folder = document.folder();
        let style = &figure.style;
        match &self.made_from {
            Some((spec, theme, hidden_lines, beside)) if beside.as_deref() == folder => {
                if *spec == figure.scene && *theme == style.theme && *hidden_lines == style.hidden_lines {
                    return Ok(());
                }
            }
            // Another folder: other files under the same names.
            _ => self.files = MeshFiles::default(),
        }
        self.made_from = Some((figure.scene.clone(), style.theme, style.hidden_lines, folder.map(Path::to_owned)));
        let mut read_file = |mesh: &str| {
            let path = folder.unwrap_or(Path::new("")).join(mesh);
            files::read_file(&path).map_err(|error| messages::file(lang, &path.display().to_string(), &error))
        };
        let scene = scene::build_with(&figure.scene, style, &mut read_file, &mut self.files)
            .map_err(|error| messages::scene(lang, &error))?;
        self.scene = Arc::new(scene);
        Ok(())
    }
}
