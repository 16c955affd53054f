//! The number of a scene that does not change any more.

use std::sync::atomic::{AtomicU64, Ordering};

/// A number that stands for the content of one scene: whoever has seen it need not look at the scene again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SceneRevision(u64);

impl SceneRevision {
    /// One that no other scene has.
    pub fn next() -> Self {
        static LAST: AtomicU64 = AtomicU64::new(0);
        Self(LAST.fetch_add(1, Ordering::Relaxed))
    }
}
