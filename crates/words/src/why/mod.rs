//! The explanations: the texts about matrices, points, stages and studies.

pub mod code;
pub mod conventions;
pub mod dialects;
pub mod entry_reasons;
pub mod explain;
pub mod explain_point;
pub mod homogeneous;
pub mod notes;
pub mod numerics;
pub mod order;
pub mod photograph;
pub mod pipeline;
pub mod reasons;
pub mod sources;
pub mod stages;
pub mod this_figure;
pub mod triangle;
