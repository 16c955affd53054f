//! Storage that outlives a window: sessions, recent files, and the files that several windows write.

pub mod recent;
pub mod session;
pub mod shared_file;
