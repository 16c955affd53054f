//! Work next to the window's thread, and values computed once for each key.

pub mod memo;
pub mod worker;
