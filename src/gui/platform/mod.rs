//! Native and web shells.

pub mod native;
#[cfg(target_arch = "wasm32")]
pub mod web;
#[cfg(not(target_arch = "wasm32"))]
pub(super) mod window_size;
