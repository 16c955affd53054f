//! Faults of a scene.

use super::MeshError;
use crate::limits::{MAX_LIGHTS, MAX_OBJECTS, MAX_SEGMENTS, MAX_SHADOW_TEXELS, MIN_SEGMENTS};
use crate::sanitize::escaped;

/// A reason why a specification isn't a scene. Displayed, it is the fault of [`key`](Self::key) of
/// [`object`](Self::object), which come before it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// Two objects have one name.
    #[error("is \"{}\", like an earlier object; allowed: a unique name", escaped(name))]
    DuplicateName {
        /// The name that two objects have.
        name: String,
    },
    /// An object's parent doesn't exist.
    #[error("is \"{}\", which is not the name of an object; allowed: the name of an object", escaped(parent))]
    UnknownParent {
        /// The object whose parent is unknown.
        name: String,
        /// The name that was not found.
        parent: String,
    },
    /// An object is its own ancestor.
    #[error("forms a cycle ({}); allowed: parents that form a tree", chain_text(chain))]
    Cycle {
        /// From the object over its ancestors back to itself.
        chain: Vec<String>,
    },
    /// A number is infinite or not a number.
    #[error("leads to numbers that are not finite; allowed: transforms whose product stays below about 1e308")]
    NotFinite {
        /// The object whose numbers these are.
        name: String,
        /// `translate`, `rotate`, `scale`, `points`, `segments`, or `parent` when only the product with the ancestors'
        /// transforms overflows.
        key: &'static str,
    },
    /// A scale of zero makes a solid flat.
    #[error("is 0 along an axis; allowed: any other numbers")]
    ZeroScale {
        /// The object whose scale is 0.
        name: String,
    },
    /// `segments` is out of its range.
    #[error("is {found}; allowed: an integer from {MIN_SEGMENTS} to {MAX_SEGMENTS}")]
    Segments {
        /// The object whose segments these are.
        name: String,
        /// The number found.
        found: u32,
    },
    /// A mesh file can't be used.
    #[error("\"{}\"{}", escaped(path), error.after(&escaped(path)))]
    Mesh {
        /// The object whose texture this is.
        name: String,
        /// As the figure names it.
        path: String,
        /// Why.
        error: MeshError,
    },
    /// A light has no direction, or a number that isn't finite.
    #[error("must be three finite numbers, not all 0 for a direction")]
    Light {
        /// Its place in the list, from 0.
        index: usize,
        /// `direction` or `position`.
        key: &'static str,
    },
    /// Too many objects, those of meshes included.
    #[error("are too many, with those of its meshes; allowed: at most {MAX_OBJECTS}")]
    TooManyObjects,
    /// Too many lights.
    #[error("are {found}; allowed: at most {MAX_LIGHTS}")]
    TooManyLights {
        /// The number found.
        found: usize,
    },
    /// Too large shadow maps.
    #[error("have shadow maps of {texels} texels, six for a point light; allowed: at most {MAX_SHADOW_TEXELS}")]
    ShadowMaps {
        /// The texels of all maps together.
        texels: u64,
    },
}

/// The names of a chain of objects, or only those at its ends if it's long.
pub fn chain_text(chain: &[String]) -> String {
    const ENDS: usize = 3;
    let names = |part: &[String]| part.iter().map(|name| escaped(name)).collect::<Vec<_>>().join(" → ");
    match chain.len().checked_sub(2 * ENDS) {
        None | Some(0) => names(chain),
        Some(_) => format!("{} → … → {}", names(&chain[..ENDS]), names(&chain[chain.len() - ENDS..])),
    }
}

impl SceneError {
    /// The name of the object at fault, if it is one.
    pub fn object(&self) -> Option<&str> {
        match self {
            Self::DuplicateName { name }
            | Self::UnknownParent { name, .. }
            | Self::NotFinite { name, .. }
            | Self::ZeroScale { name }
            | Self::Segments { name, .. }
            | Self::Mesh { name, .. } => Some(name),
            Self::Cycle { chain } => chain.first().map(String::as_str),
            Self::Light { .. } | Self::TooManyLights { .. } | Self::ShadowMaps { .. } | Self::TooManyObjects => None,
        }
    }

    /// The key that is at fault.
    pub const fn key(&self) -> &'static str {
        match self {
            Self::DuplicateName { .. } => "name",
            Self::UnknownParent { .. } | Self::Cycle { .. } => "parent",
            Self::ZeroScale { .. } => "scale",
            Self::Segments { .. } => "segments",
            Self::Mesh { .. } => "path",
            Self::TooManyLights { .. } | Self::ShadowMaps { .. } => "lights",
            Self::TooManyObjects => "objects",
            Self::NotFinite { key, .. } | Self::Light { key, .. } => key,
        }
    }
}
