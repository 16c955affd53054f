//! Reveals the inner work of the pipeline. No picture of a scene needs any of it.

pub mod canonical;
pub mod clip_parts;
pub mod cull_result;
pub mod divide_before_clip;
pub mod one_triangle;
mod projected;
pub mod shadow_rays;
