//! The one door to stored and chosen files: the file system of the machine, or, in a page of a browser, the files given
//! to the page and those it stores.

#[cfg(any(test, target_arch = "wasm32"))]
pub mod page;
#[cfg(not(target_arch = "wasm32"))]
mod system;

#[cfg(target_arch = "wasm32")]
pub use page::{
    Lock, canonical, create_folder, exists, is_read_only, is_whole, lock, may_exist, read_at_most, remove,
    remove_left_over, rename, save, try_lock, write, written,
};
#[cfg(not(target_arch = "wasm32"))]
pub use system::{
    Lock, canonical, create_folder, exists, is_whole, lock, may_exist, remove, rename, try_lock, write, written,
};
