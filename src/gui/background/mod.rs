//! Work next to the window's thread, and values computed once for each key.

pub(super) mod memo;
pub(super) mod worker;
