//! Mesh files: which reader reads them, and what can be wrong with them.

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DMat4;

use super::soup::TooLarge;
use super::{Mesh, ReadError, ReadFile, gltf, obj};
use crate::appearance::Rgba;

/// One object of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Its name in the file; may be empty, need not be unique.
    pub name: String,
    /// Its surface.
    pub mesh: Arc<Mesh>,
    /// Where the file puts it.
    pub file_from_part: DMat4,
    /// The base colour of its material.
    pub color: Option<Rgba>,
    /// The file wants both sides to be seen.
    pub two_sided: bool,
}

/// Why a mesh file cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MeshError {
    /// It could not be read.
    #[error(transparent)]
    Unreadable(Box<ReadError>),
    /// The ending of its name says nothing.
    #[error("the format is not known; the name must end with .obj, .gltf or .glb")]
    Format,
    /// It has no faces.
    #[error("there is no face in it")]
    Empty,
    /// It has more than 2³¹ corners.
    #[error("it has too many vertices")]
    TooLarge,
    /// A line of an OBJ file.
    #[error("line {line}: {fault}")]
    Obj {
        /// From 1.
        line: usize,
        /// What is wrong there.
        fault: ObjFault,
    },
    /// The JSON of a glTF file does not parse.
    #[error("line {line}, column {column}: {detail}")]
    Json {
        /// From 1; within the JSON part of a GLB file.
        line: usize,
        /// From 1.
        column: usize,
        /// The parser's words.
        detail: String,
    },
    /// A glTF file is not as it should be.
    #[error("{place}: {fault}")]
    Gltf {
        /// Such as `accessors[3]`; empty when it is the file as a whole.
        place: String,
        /// What is wrong there.
        fault: GltfFault,
    },
}

impl From<TooLarge> for MeshError {
    fn from(_: TooLarge) -> Self {
        Self::TooLarge
    }
}

/// What is wrong with a line of an OBJ file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ObjFault {
    /// Not a finite number.
    #[error("\"{found}\" is not a finite number")]
    Number {
        /// What was found.
        found: String,
    },
    /// A point or normal has fewer than three coordinates.
    #[error("there are {found} coordinates; 3 are needed")]
    Coordinates {
        /// How many were found.
        found: usize,
    },
    /// A face has fewer than three corners.
    #[error("a face with {found} corners; it needs at least 3")]
    Corners {
        /// How many were found.
        found: usize,
    },
    /// A corner is not written as `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    #[error("\"{found}\" is not a corner of a face; it is written v, v/vt, v//vn or v/vt/vn with whole numbers")]
    Corner {
        /// What was found.
        found: String,
    },
    /// A corner names a point or normal that is not there.
    #[error("\"{found}\" names a point or normal that does not exist; there are {points} points and {normals} normals")]
    Index {
        /// The corner.
        found: String,
        /// Points in the file (for a relative index: so far).
        points: usize,
        /// Normals in the file (for a relative index: so far).
        normals: usize,
    },
}

/// What is wrong with a glTF file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GltfFault {
    /// The frame of a GLB file is broken.
    #[error("not a valid GLB file ({detail})")]
    Container {
        /// The reader's words.
        detail: String,
    },
    /// A value breaks a rule of glTF.
    #[error("a value that glTF does not allow")]
    Value,
    /// A value that must be there is not.
    #[error("it is missing")]
    Missing,
    /// A reference names what does not exist.
    #[error("it names something that does not exist")]
    Reference,
    /// Something that this program does not read.
    #[error("{what} cannot be read by this program")]
    Unsupported {
        /// What it is, in the words of glTF.
        what: String,
    },
    /// A buffer's bytes are not there.
    #[error("the buffer's bytes are missing")]
    NoBytes,
    /// A buffer's data URI is broken.
    #[error("the data URI is not valid base64")]
    DataUri,
    /// A file beside the glTF file cannot be read.
    #[error("\"{uri}\": {error}")]
    File {
        /// As the file names it.
        uri: String,
        /// Why.
        error: Box<ReadError>,
    },
    /// An accessor goes beyond its buffer.
    #[error("the data lies beyond the end of its buffer")]
    OutOfBuffer,
    /// An index names a vertex that is not there.
    #[error("index {found} names a vertex that does not exist; there are {vertices}")]
    Index {
        /// The index.
        found: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A coordinate or matrix is infinite or not a number.
    #[error("a number is not finite")]
    NotFinite,
    /// A node has two parents, or is its own descendant.
    #[error("a node has two parents")]
    Tree,
}

/// The parts of the mesh file with this path and these bytes. `read_file` gives the files beside it (MTL, BIN); a material
/// library that cannot be read is left out, its materials have no colour then.
///
/// # Errors
/// [`MeshError`].
pub fn import(path: &str, bytes: &[u8], read_file: &mut ReadFile<'_>) -> Result<Vec<Part>, MeshError> {
    let ending = path.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
    let mut beside = |name: &str| read_file(&companion(path, name));
    let parts = match ending.as_deref() {
        Some("obj") => obj::read(bytes, &mut beside)?,
        Some("gltf" | "glb") => gltf::read(bytes, &mut beside)?,
        _ => return Err(MeshError::Format),
    };
    if parts.iter().all(|p| p.mesh.triangles.is_empty()) { Err(MeshError::Empty) } else { Ok(parts) }
}

/// The path of a file that another one names: relative to the other one's folder.
fn companion(path: &str, name: &str) -> String {
    let name = name.replace('\\', "/");
    match path.rfind(['/', '\\']) {
        Some(slash) if !name.starts_with('/') => format!("{}{name}", &path[..=slash]),
        _ => name,
    }
}

/// Mesh files that have been read, and primitives that have been made, so that a scene that is built again and again does each
/// of this once. Whoever wants a file to be read anew starts with a new one.
#[derive(Clone, Debug, Default)]
pub struct MeshFiles {
    known: BTreeMap<String, Arc<Vec<Part>>>,
    /// By the name of the shape and its segments.
    pub(super) primitives: BTreeMap<(&'static str, u32), Arc<Mesh>>,
}

impl MeshFiles {
    /// The parts of a file. What could not be read is tried anew each time.
    ///
    /// # Errors
    /// [`MeshError`].
    pub(super) fn get(&mut self, path: &str, read_file: &mut ReadFile<'_>) -> Result<Arc<Vec<Part>>, MeshError> {
        if let Some(parts) = self.known.get(path) {
            return Ok(Arc::clone(parts));
        }
        let parts = read(path, read_file)?;
        self.insert(path, Arc::clone(&parts));
        Ok(parts)
    }

    /// True for a file that has been read.
    #[must_use]
    pub fn knows(&self, path: &str) -> bool {
        self.known.contains_key(path)
    }

    /// Takes a file over that [`read`] has read elsewhere.
    pub fn insert(&mut self, path: &str, parts: Arc<Vec<Part>>) {
        self.known.insert(path.to_owned(), parts);
    }

    /// Forgets the files that `is_used` says no to.
    pub(super) fn retain(&mut self, is_used: impl Fn(&str) -> bool) {
        self.known.retain(|path, _| is_used(path));
    }
}

/// Reads a mesh file: the part of building a scene that takes long, for those who want to do it beside other things.
///
/// # Errors
/// [`MeshError`].
pub fn read(path: &str, read_file: &mut ReadFile<'_>) -> Result<Arc<Vec<Part>>, MeshError> {
    let bytes = read_file(path).map_err(|error| MeshError::Unreadable(Box::new(error)))?;
    Ok(Arc::new(import(path, &bytes, read_file)?))
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
}
