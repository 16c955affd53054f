//! The system under the window: its file dialogs, and the possible sizes of a window.

pub mod native;
#[cfg(not(target_arch = "wasm32"))]
pub(super) mod window_size;
