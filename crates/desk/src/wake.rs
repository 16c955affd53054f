//! The window, as the desk sees it.

use std::time::Duration;

/// A window that can be asked for another frame, from any thread.
pub trait Wake: Send + Sync {
    /// Asks for a frame after a time. Zero means at once.
    fn wake_after(&self, time: Duration);

    /// Another handle of the same window, for a thread.
    fn handle(&self) -> Box<dyn Wake>;

    /// Asks for a frame at once.
    fn wake(&self) {
        self.wake_after(Duration::ZERO);
    }
}

/// Nobody waits for an answer.
impl Wake for () {
    fn wake_after(&self, _: Duration) {}

    fn handle(&self) -> Box<dyn Wake> {
        Box::new(())
    }
}
