//! Storage that outlives a window: preferences, sessions, recent files, progress.

pub mod preferences;
pub(super) mod recent;
pub mod recovery;
pub mod session;
pub mod session_news;
