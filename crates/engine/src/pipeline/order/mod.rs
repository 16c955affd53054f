//! The order in which faces and strokes are painted if no depth buffer decides.

pub(crate) mod bsp;
pub(crate) mod painter;
pub(crate) mod pieces;
pub mod stroke_order;
pub mod stroke_runs;
