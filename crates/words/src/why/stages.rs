//! Stages and hidden surfaces.

use crate::Lang;
use crate::stage::{Stage, WorksOn};

texts!("why/stages");

/// The display of a stage in a picture.
pub const fn in_and_out(t: &Texts, stage: Stage) -> &'static str {
    match stage.works_on() {
        WorksOn::Objects => t.boxes,
        WorksOn::Normals => t.normals,
        WorksOn::Vertices => t.vertices,
        WorksOn::Faces => t.faces,
        WorksOn::Pieces => t.pieces,
        WorksOn::Colors | WorksOn::Pixels => t.halves,
    }
}
