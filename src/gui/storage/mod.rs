//! Storage that outlives a window: sessions, recent files, and the files that several windows write.

pub(super) mod recent;
pub mod recovery;
pub mod session;
pub mod session_news;
pub(in crate::gui) mod shared_file;
