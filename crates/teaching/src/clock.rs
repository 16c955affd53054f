//! The clock of the two shells. The library takes a clock as an argument and reads no time of its own.

use std::sync::OnceLock;
use std::time::Duration;

use web_time::{Instant, SystemTime, UNIX_EPOCH};

/// The seconds since the beginning of 1970 (UTC); 0 if the clock of the machine is before that.
pub fn seconds_since_1970() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs())
}

/// The time since the first call.
pub fn now() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed()
}

/// The shortest time that the clock distinguishes. It's some nanoseconds on a system, but up to a millisecond in a
/// browser, which keeps its clock coarse (W3C, *High Resolution Time*, "Clock resolution").
pub fn resolution() -> Duration {
    /// Number of readings after which a clock that hasn't moved has no better resolution.
    const LOOKS: u32 = 10_000_000;
    const COARSEST: Duration = Duration::from_millis(1);
    static RESOLUTION: OnceLock<Duration> = OnceLock::new();
    let step = |_| {
        let start = now();
        (0..LOOKS).map(|_| now().saturating_sub(start)).find(|time| !time.is_zero()).unwrap_or(COARSEST)
    };
    *RESOLUTION.get_or_init(|| (0..3).map(step).min().unwrap_or(COARSEST))
}
