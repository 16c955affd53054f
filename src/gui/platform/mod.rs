//! The system under the window: its file dialogs, and the size that a window can have.

pub mod native;
#[cfg(not(target_arch = "wasm32"))]
pub(super) mod window_size;
