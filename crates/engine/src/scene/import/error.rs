//! Faults of a mesh file.

use super::mesh_endings;
use crate::limits::MAX_OBJECTS;
use crate::scene::{ReadError, TextureError};

/// The reason why a mesh file can't be used.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The file couldn't be read.
    #[error(transparent)]
    Unreadable(Box<ReadError>),
    /// The extension of its name is unknown.
    #[error("the format is not known; allowed: a name that ends with one of these: {}", mesh_endings())]
    Format,
    /// Reading was cancelled.
    #[error("reading was cancelled")]
    Cancelled,
    /// The file has no faces.
    #[error("it has no faces")]
    Empty,
    /// The mesh has more than 2³¹ corners.
    #[error("it has too many vertices")]
    TooLarge,
    /// The mesh has more objects than a scene may.
    #[error("it has too many objects; allowed: at most {MAX_OBJECTS}")]
    TooManyObjects,
    /// A line of an OBJ, PLY or STL file.
    #[error("line {line}: {fault}")]
    Line {
        /// From 1.
        line: usize,
        /// The rule of the format that this line breaks.
        fault: MeshFault,
    },
    /// A place in a binary PLY or STL file.
    #[error("byte {byte}: {fault}")]
    Byte {
        /// From 0.
        byte: usize,
        /// The rule of the format that the file breaks here.
        fault: MeshFault,
    },
    /// The JSON of a glTF file doesn't parse.
    #[error("line {line}, column {column}: {fault}")]
    Json {
        /// From 1. Within the JSON part of a GLB file.
        line: usize,
        /// From 1.
        column: usize,
        /// The rule of JSON that the file breaks.
        fault: JsonFault,
    },
    /// A glTF file is faulty.
    #[error("{place}{}{fault}", if place.is_empty() { "" } else { ": " })]
    Gltf {
        /// Such as `accessors[3]`. Empty if it's the file as a whole.
        place: String,
        /// The rule of glTF that the file breaks.
        fault: GltfFault,
    },
}

impl MeshError {
    /// The text that follows the displayed path of the mesh, which isn't repeated.
    pub(crate) fn after(&self, path: &str) -> String {
        match self {
            Self::Unreadable(error) if error.file == path => format!(" {}", error.problem),
            error => format!(": {error}"),
        }
    }

    /// True if a file lies outside the folder that the figure may read from. The user can allow it.
    pub fn is_outside(&self) -> bool {
        match self {
            Self::Unreadable(error) | Self::Gltf { fault: GltfFault::File { error, .. }, .. } => error.is_outside(),
            _ => false,
        }
    }
}

/// A fault in an OBJ, PLY or STL file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFault {
    /// Not a finite number.
    #[error("\"{found}\" is not a finite number")]
    Number {
        /// The text found.
        found: String,
    },
    /// A point or normal has fewer than three coordinates.
    #[error("there are {found} coordinates; 3 are needed")]
    Coordinates {
        /// The number found.
        found: usize,
    },
    /// A corner isn't written as `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    #[error("\"{found}\" is not a corner of a face; it is written v, v/vt, v//vn or v/vt/vn with whole numbers")]
    Corner {
        /// The text found.
        found: String,
    },
    /// A word that the format doesn't have here.
    #[error("\"{found}\" cannot stand here; allowed: {allowed}")]
    Word {
        /// The text found.
        found: String,
        /// Words of the format.
        allowed: String,
    },
    /// A required word is missing.
    #[error("\"{word}\" is missing")]
    Missing {
        /// The word of the format.
        word: String,
    },
    /// The file ends too early.
    #[error("the file ends here, too early")]
    End,
    /// The length of a binary STL file isn't that of its triangles.
    #[error("{triangles} triangles need {needed} bytes, but the file has {found}")]
    Length {
        /// As the file states it.
        triangles: u32,
        /// Bytes.
        needed: u64,
        /// Bytes.
        found: u64,
    },
    /// A corner names a missing point.
    #[error("\"{found}\" names a point that does not exist; there are {points} points")]
    Index {
        /// The corner.
        found: String,
        /// Points in the file (for a relative index: so far).
        points: usize,
    },
}

/// A part of a mesh file that was left out, or read otherwise than written, because other programs write it so. The
/// surface is the same.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshNotice {
    /// Corners of faces name normals or texture coordinates that don't exist. One of them is reported.
    #[error(
        "line {line}: \"{found}\" names a normal or texture coordinate that does not exist; such indices are ignored"
    )]
    IndexIgnored {
        /// From 1.
        line: usize,
        /// The corner.
        found: String,
    },
    /// Entries that the program doesn't draw.
    #[error("left out, because this program doesn't use it: {entries}")]
    LeftOut {
        /// Their names in the file, each with their number.
        entries: String,
    },
    /// Materials that are in no library of the file.
    #[error(
        "no library of the file has {count} of its materials, such as \"{material}\"; their faces have the object's colour"
    )]
    NoMaterial {
        /// The first one's name.
        material: String,
        /// The number of such materials.
        count: usize,
    },
    /// Faces have fewer than three corners.
    #[error("line {line}: a face with {found} corners; {}", if *count == 1 { "it is left out".to_owned() } else { format!("it and {} others are left out", count - 1) })]
    FacesSkipped {
        /// The first one's, from 1.
        line: usize,
        /// Number of corners of the first one.
        found: usize,
        /// Number of such faces.
        count: usize,
    },
    /// Concave faces have so many corners that it would take too long to cut them right.
    #[error(
        "concave faces with too many corners: {count}; they are filled as if they were convex, which shows wrong areas"
    )]
    CutAsConvex {
        /// Number of such faces.
        count: usize,
    },
    /// A texture can't be used. The object's colour is shown in its place.
    #[error("the texture {0}; the object's colour is shown instead")]
    Texture(TextureError),
    /// The photograph under the image can't be used.
    #[error("the photograph {0}; the image is shown without it")]
    Photograph(TextureError),
    /// The figure asks for a texture, but the mesh has no texture coordinates.
    #[error("the mesh has no texture coordinates; its colour is shown instead of the texture")]
    NoCoordinates,
    /// A material would make its faces fully invisible.
    #[error("the material \"{material}\" is fully transparent (Tr 1 or d 0); it is drawn opaque")]
    Invisible {
        /// As the library of materials has it.
        material: String,
    },
}

/// A fault in the JSON of a glTF file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JsonFault {
    /// No JSON from here on.
    #[error("this is not JSON")]
    Syntax,
    /// The text ends before it is complete.
    #[error("the JSON ends early")]
    End,
    /// A required key is missing.
    #[error("the key \"{key}\" is missing in the object that ends here")]
    MissingKey {
        /// The key that is missing.
        key: String,
    },
    /// A value of another type than glTF wants.
    #[error("a value that glTF does not allow")]
    Value,
}

/// A fault in the frame of a GLB file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GlbFault {
    /// The twelve bytes at its start.
    #[error("its header is truncated or gives a wrong length")]
    Header,
    /// A chunk goes beyond the end.
    #[error("it ends early")]
    End,
    /// The JSON doesn't come first, or a part is of an unknown kind.
    #[error("its parts are not those of a GLB file")]
    Parts,
}

/// A fault in a glTF file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GltfFault {
    /// The frame of a GLB file is broken.
    #[error("not a valid GLB file: {fault}")]
    Container {
        /// The rule of the container that the file breaks.
        fault: GlbFault,
    },
    /// Another version of glTF.
    #[error("this is glTF {found}; allowed: 2.0")]
    Version {
        /// As the file states it, such as 1.0.
        found: String,
    },
    /// The file needs an extension that this program doesn't read.
    #[error("the file needs {found}, which this program does not read; save it without")]
    Extension {
        /// The name of the extension.
        found: String,
    },
    /// A value breaks a rule of glTF.
    #[error("a value that glTF does not allow")]
    Value,
    /// A required value is missing.
    #[error("it is missing")]
    Missing,
    /// A reference to something that doesn't exist.
    #[error("it names something that does not exist")]
    Reference,
    /// A feature that this program doesn't read.
    #[error("{what} cannot be read by this program")]
    Unsupported {
        /// The feature, in the words of glTF.
        what: String,
    },
    /// A buffer's bytes are missing.
    #[error("the buffer's bytes are missing")]
    NoBytes,
    /// A buffer's data URI is broken.
    #[error("the data URI is not valid base64")]
    DataUri,
    /// A file beside the glTF file can't be read.
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
    /// An index names a missing vertex.
    #[error("index {found} names a vertex that does not exist; there are {vertices}")]
    Index {
        /// The index of a vertex.
        found: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A sparse accessor names an item that is missing, or not in rising order.
    #[error("a sparse accessor's index {found} is not among its {count} items, or does not rise")]
    SparseIndex {
        /// The index of an item.
        found: u32,
        /// The number of items.
        count: usize,
    },
    /// Accessors that hold far more bytes than the file has.
    #[error("its accessors hold more than any mesh")]
    OverBudget,
    /// A coordinate or matrix is infinite or not a number.
    #[error("a number is not finite")]
    NotFinite,
    /// A node has two parents, or is its own descendant.
    #[error("a node has two parents")]
    Tree,
}
