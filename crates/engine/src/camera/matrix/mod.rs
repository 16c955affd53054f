//! The matrices of a camera, in every convention of NDC, and as a product of steps.

mod clip_space;
mod decomposition;
pub(crate) mod projection;

pub use clip_space::ClipSpace;
pub use decomposition::{Decomposition, Factor, Step};
