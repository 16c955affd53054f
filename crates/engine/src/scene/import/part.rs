//! The result of importing a mesh file.

use std::sync::Arc;

use glam::DMat4;

use crate::appearance::{Rgba, Sampler, Texture};
use crate::progress::{Activity, Progress};
use crate::sanitize::escaped;
use crate::scene::texture::CornerUv;
use crate::scene::{Mesh, MeshError, MeshNotice, TextureError};

/// Bytes read between two checks whether the work was cancelled.
const STRETCH: usize = 1 << 16;

/// The most names of entries that a notice lists. A file of another kind may have any number.
const MOST_NAMES: usize = 8;

/// A mesh file that has been read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// One for each name and material.
    pub parts: Vec<Part>,
    /// Parts that were left out, or read otherwise than written.
    pub notices: Vec<MeshNotice>,
}

/// Reports how much of a file has been read.
pub(super) struct Stretches<'a> {
    progress: &'a Progress,
    done: usize,
}

impl<'a> Stretches<'a> {
    pub(super) fn begin(progress: &'a Progress, bytes: &[u8]) -> Self {
        progress.begin(Activity::Reading, bytes.len());
        Self { progress, done: 0 }
    }

    /// So many bytes are done. Pauses after each stretch.
    pub(super) async fn advance_to(&mut self, done: usize) -> Result<(), MeshError> {
        if done - self.done < STRETCH {
            return Ok(());
        }
        self.progress.advance_and_pause(done - self.done).await;
        self.done = done;
        if self.progress.is_cancelled() { Err(MeshError::Cancelled) } else { Ok(()) }
    }
}

/// The entries of a file that are left out: their names in it, and how many there are.
#[derive(Debug, Default)]
pub(super) struct LeftOut(Vec<(String, usize)>);

impl LeftOut {
    pub(super) fn add(&mut self, name: &str, count: usize) {
        if count == 0 {
            return;
        }
        let name = escaped(name);
        let known = self.0.iter().position(|(known, _)| *known == name);
        if known.is_none() && self.0.len() < MOST_NAMES {
            return self.0.push((name, count));
        }
        // The last one counts what isn't listed.
        let last = self.0.len() - 1;
        self.0[known.unwrap_or(last)].1 += count;
        if known.is_none() {
            self.0[last].0 = "…".to_owned();
        }
    }

    pub(super) fn notice(self) -> Option<MeshNotice> {
        let entries: Vec<String> = self.0.iter().map(|(name, count)| format!("{name} ({count})")).collect();
        (!entries.is_empty()).then(|| MeshNotice::LeftOut { entries: entries.join(", ") })
    }
}

/// Colours whose channels are shares, 0 … 1, or bytes, as other programs tell them apart: by the greatest one. An
/// infinite alpha is opaque.
pub(super) fn vertex_colors(colors: &[[f32; 4]]) -> Vec<Rgba> {
    let are_bytes = colors.iter().any(|[rgb @ .., _]| rgb.iter().any(|channel| *channel > 1.001));
    let share = |channel: f32| f64::from(channel) / if are_bytes { 255.0 } else { 1.0 };
    let color = |channels: &[f32; 4]| channels.map(|channel| byte(share(channel)));
    colors.iter().map(color).map(|[r, g, b, a]| Rgba { r, g, b, a }).collect()
}

/// A share, 0 … 1, as a byte.
pub(super) fn byte(share: f64) -> u8 {
    #[expect(clippy::cast_possible_truncation, reason = "0 … 255")]
    let byte = (share.clamp(0.0, 1.0) * 255.0).round() as u8;
    byte
}

/// Adds a notice once.
pub(super) fn note(notices: &mut Vec<MeshNotice>, notice: MeshNotice) {
    if !notices.contains(&notice) {
        notices.push(notice);
    }
}

/// The texture of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct PartTexture {
    /// Its texels, shared by all parts that use it.
    pub image: Arc<Texture>,
    /// How it's sampled.
    pub sampler: Sampler,
}

impl PartTexture {
    /// A picture that was read. If it can't be used, a notice says so, unless the reader of the
    /// files lists those that are missing.
    pub(super) fn new(
        image: Result<Arc<Texture>, TextureError>,
        sampler: Sampler,
        notices: &mut Vec<MeshNotice>,
    ) -> Option<Self> {
        match image {
            Ok(image) => return Some(Self { image, sampler }),
            Err(error) if error.is_unread() => {}
            Err(error) => note(notices, MeshNotice::Texture(error)),
        }
        None
    }
}

/// One object of a mesh file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Part {
    /// Its name in the file. May be empty, need not be unique.
    pub name: String,
    /// Triangles in the space of the file.
    pub mesh: Arc<Mesh>,
    /// The placement of the part in the file.
    pub file_from_part: DMat4,
    /// The base colour: that of its material, and of its vertices if they all have the same.
    pub color: Option<Rgba>,
    /// The base colour at each vertex of the mesh, that of the material in it. Empty if it's the same everywhere.
    pub colors: Arc<Vec<Rgba>>,
    /// Texture coordinates of the corners of each triangle. Empty means it has none.
    pub uv: Arc<Vec<CornerUv>>,
    /// The texture of its material.
    pub texture: Option<PartTexture>,
    /// The file wants both sides to be seen.
    pub two_sided: bool,
}
