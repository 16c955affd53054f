//! The inner work of the pipeline in the pictures: probes, stages, triangles, texels.

pub(super) mod operation_path;
pub(super) mod probe;
pub(super) mod revealed_scene;
pub(super) mod stage_overlay;
pub(super) mod texel;
pub(super) mod triangle_overlay;
