//! The clock of the two shells. The library is handed a clock, and takes no time of its own.

use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// The time since the first call.
#[must_use]
pub fn now() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}
