//! The clock of the two shells. The library is handed a clock, and takes no time of its own.

use std::sync::OnceLock;
use std::time::Duration;

use web_time::{Instant, SystemTime, UNIX_EPOCH};

/// The seconds since the beginning of 1970 (UTC); 0 where the clock of the machine is before that.
#[must_use]
pub fn seconds_since_1970() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs())
}

/// The time since the first call.
#[must_use]
pub fn now() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}
