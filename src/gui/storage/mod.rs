//! The lines about what outlives a window.

pub mod recovery;
pub mod session_news;
