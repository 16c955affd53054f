//! Mesh files: the choice of their reader, and a cache of the read ones.

mod error;
#[cfg(feature = "import")]
mod gltf;
mod obj;
mod part;
mod ply;
mod soup;
mod stl;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::appearance::Texture;
use crate::progress::{Progress, at_once};
use crate::scene::texture::{Alpha, Textures, UvMesh};
use crate::scene::{Mesh, ReadFile, TextureError, Wanted};
pub use error::{GlbFault, GltfFault, JsonFault, MeshError, MeshFault, MeshNotice};
pub use part::{Imported, Part, PartTexture};

/// The extensions of mesh files.
pub const MESH_ENDINGS: &[&str] =
    if cfg!(feature = "import") { &["obj", "gltf", "glb", "stl", "ply"] } else { &["obj", "stl", "ply"] };

/// The extensions of mesh files, as a list in a sentence.
pub fn mesh_endings() -> String {
    MESH_ENDINGS.iter().map(|ending| format!(".{ending}")).collect::<Vec<_>>().join(", ")
}

/// Imports the mesh file with this path and these bytes. `read_file` returns the files beside it (MTL, BIN). A material
/// library that can't be read is left out, and its materials then have no colour. Pauses after each stretch of the
/// file.
///
/// # Errors
/// [`MeshError`].
pub async fn import(
    path: &str,
    bytes: &[u8],
    read_file: &mut ReadFile<'_>,
    progress: &Progress,
) -> Result<Imported, MeshError> {
    let ending = path.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    let mut beside = |name: &str| read_file(Wanted { path: &companion(path, name), named_by: Some(path) });
    let imported = match ending.as_deref() {
        Some("obj") => obj::read(bytes, &mut beside, progress).await?,
        Some("stl") => stl::read(bytes, progress).await?,
        Some("ply") => ply::read(bytes, progress).await?,
        #[cfg(feature = "import")]
        Some("gltf" | "glb") => gltf::read(bytes, &mut beside, progress).await?,
        _ => return Err(MeshError::Format),
    };
    let is_empty = imported.parts.iter().all(|p| p.mesh.triangles.is_empty());
    if is_empty { Err(MeshError::Empty) } else { Ok(imported) }
}

/// The path of a file that another one names: relative to the other one's folder.
fn companion(path: &str, name: &str) -> String {
    let name = name.replace('\\', "/");
    match path.rfind(['/', '\\']) {
        Some(slash) if !name.starts_with('/') => format!("{}{name}", &path[..=slash]),
        _ => name,
    }
}

/// A cache of read mesh files and finished primitives, so that a scene that is built again and again needs each only
/// once. To read a file again, start with a new cache.
#[derive(Clone, Debug, Default)]
pub struct MeshFiles {
    known: BTreeMap<String, Arc<Imported>>,
    /// By the name of the shape and its segments.
    pub(crate) primitives: BTreeMap<(&'static str, u32), Arc<Mesh>>,
    /// The same with texture coordinates.
    pub(crate) mapped: BTreeMap<(&'static str, u32), UvMesh>,
    /// Parts of mesh files with their texture coordinates, by the file and the place in it.
    pub(crate) textured: BTreeMap<(String, usize), UvMesh>,
    /// Parts of mesh files, by the same, without and with the adjacency for an outline.
    pub(crate) outlined: BTreeMap<(String, usize), (Arc<Mesh>, Arc<Mesh>)>,
    /// The pictures that figures name.
    pub(in crate::scene) textures: Textures,
    /// The file of the photograph under the image.
    pub(in crate::scene) photograph: Option<String>,
    progress: Progress,
}

impl MeshFiles {
    /// The contents of a file. A file that couldn't be read is tried again each time.
    ///
    /// # Errors
    /// [`MeshError`].
    pub(crate) fn get(&mut self, path: &str, read_file: &mut ReadFile<'_>) -> Result<Arc<Imported>, MeshError> {
        if let Some(imported) = self.known.get(path) {
            return Ok(Arc::clone(imported));
        }
        let imported = at_once(read(path, read_file, &self.progress))?;
        self.insert(path, Arc::clone(&imported));
        Ok(imported)
    }

    /// True for a file that has been read as a texture of a figure, with or without success.
    pub fn knows_texture(&self, path: &str) -> bool {
        self.textures.knows(path)
    }

    /// Takes over a texture of a figure that [`read_texture`] has read elsewhere.
    pub fn insert_texture(&mut self, path: &str, read: Result<Arc<Texture>, TextureError>) {
        self.textures.insert(path, read);
    }

    /// Has scenes show the photograph in a file under the image, or none.
    pub fn show_photograph(&mut self, path: Option<&str>) {
        self.photograph = path.map(str::to_owned);
    }

    /// An empty cache. `progress` follows the reading.
    pub fn watched(progress: &Progress) -> Self {
        Self { progress: progress.clone(), ..Self::default() }
    }

    /// True for a file that has been read.
    pub fn knows(&self, path: &str) -> bool {
        self.known.contains_key(path)
    }

    /// Takes a file over that [`read`] has read elsewhere.
    pub fn insert(&mut self, path: &str, imported: Arc<Imported>) {
        self.textured.retain(|(known, _), _| known != path);
        self.outlined.retain(|(known, _), _| known != path);
        self.known.insert(path.to_owned(), imported);
    }

    /// Forgets the files that `is_used` denies.
    pub(crate) fn retain(&mut self, is_used: impl Fn(&str) -> bool) {
        self.known.retain(|path, _| is_used(path));
        self.textured.retain(|(path, _), _| is_used(path));
        self.outlined.retain(|(path, _), _| is_used(path));
    }
}

/// Reads a mesh file, the slow part of building a scene, for callers that do it in the background. It pauses where
/// [`import`] does.
///
/// # Errors
/// [`MeshError`].
pub async fn read(path: &str, read_file: &mut ReadFile<'_>, progress: &Progress) -> Result<Arc<Imported>, MeshError> {
    let bytes = read_file(Wanted { path, named_by: None }).map_err(|error| MeshError::Unreadable(Box::new(error)))?;
    Ok(Arc::new(import(path, &bytes, read_file, progress).await?))
}

/// Reads a texture that a figure names, the other slow part of building a scene.
///
/// # Errors
/// [`TextureError`].
pub fn read_texture(path: &str, read_file: &mut ReadFile<'_>) -> Result<Arc<Texture>, TextureError> {
    let mut beside = |path: &str| read_file(Wanted { path, named_by: None });
    Textures::default().get(path, Alpha::Kept, &mut beside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn companions_are_looked_for_beside_the_file_that_names_them() {
        assert_eq!(companion("meshes/cow.obj", "cow.mtl"), "meshes/cow.mtl");
        assert_eq!(companion("cow.obj", "mtl\\cow.mtl"), "mtl/cow.mtl");
        assert_eq!(companion("C:\\x\\cow.obj", "cow.mtl"), "C:\\x\\cow.mtl");
        assert_eq!(companion("meshes/cow.obj", "/abs/cow.mtl"), "/abs/cow.mtl");
    }

    #[test]
    fn reading_that_is_cancelled_ends_early() {
        let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        let text = triangle.repeat(40_000);
        let progress = Progress::default();
        let read =
            |progress: &Progress| at_once(import("m.obj", text.as_bytes(), &mut crate::scene::no_files, progress));
        progress.cancel();
        assert_eq!(read(&progress).err(), Some(MeshError::Cancelled));
        let (_, share) = progress.now().unwrap_or((crate::progress::Activity::Encoding, None));
        assert!(share.is_some_and(|share| share > 0.0 && share < 0.2), "{share:?}");
        progress.begin_anew();
        assert!(read(&progress).is_ok());
    }
}
