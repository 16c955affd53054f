//! The scene that the pictures show, made anew only when the figure's has changed.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::document::Document;
use crate::appearance::Theme;
use crate::files;
use crate::i18n::{Lang, messages};
use crate::scene::{Scene, SceneSpec};
use crate::views;

/// The scene of the figure, or the last one that could be made.
#[derive(Debug, Default)]
pub struct Scenery {
    made_from: Option<(SceneSpec, Theme, Option<PathBuf>)>,
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
        if let Some((spec, theme, beside)) = &self.made_from
            && *spec == figure.scene
            && *theme == figure.style.theme
            && beside.as_deref() == folder
        {
            return Ok(());
        }
        self.made_from = Some((figure.scene.clone(), figure.style.theme, folder.map(Path::to_owned)));
        let mut read_file = |mesh: &str| {
            let path = folder.unwrap_or(Path::new("")).join(mesh);
            files::read_file(&path).map_err(|error| messages::file(lang, &path.display().to_string(), &error))
        };
        let scene = views::scene_of(figure, &mut read_file).map_err(|error| messages::scene(lang, &error))?;
        self.scene = Arc::new(scene);
        Ok(())
    }
}
