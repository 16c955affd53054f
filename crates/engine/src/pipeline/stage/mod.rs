//! The stages that run in the geometry half of the pipeline.

pub(crate) mod clip;
pub(crate) mod cull_faces;
pub(crate) mod cull_objects;
pub(crate) mod hidden_surfaces;
pub(crate) mod light;
pub(crate) mod lines;
pub(crate) mod pool;
pub mod reflection;
pub(crate) mod shadow_maps;
pub(crate) mod vertices;
