//! The held key. All its repeats are one step.
//!
//! egui's own list of keys is no help here. It removes a key by its logical name, but the same key goes down as `+` and
//! comes up as `=` if Shift is released first. Then `+` would be held until the window loses the focus.

use eframe::egui::{Context, Event, InputState, Key};

/// No system waits longer before a held key repeats, nor between two repeats.
const LONGEST_PAUSE: f64 = 1.0;

/// The held key, as far as its repeats reveal it.
#[derive(Debug, Default)]
pub(in crate::gui) struct HeldKey {
    /// The key, and the time of its last press or repeat, in seconds.
    key: Option<(Key, f64)>,
}

impl HeldKey {
    /// Follows the events before this frame. Returns true if another key than the held one was pressed, whose effect is
    /// then a step of its own.
    pub(in crate::gui) fn follow(&mut self, input: &InputState) -> bool {
        let mut another = false;
        for event in &input.raw.events {
            match event {
                Event::Key { key, pressed: true, .. } => {
                    another |= self.key.is_some_and(|(held, _)| held != *key);
                    self.key = Some((*key, input.time));
                }
                // Any key that comes up counts, because its name may have changed.
                Event::Key { pressed: false, .. } | Event::PointerButton { .. } | Event::WindowFocused(false) => {
                    self.key = None;
                }
                _ => {}
            }
        }
        another
    }

    /// True while a key is held that may still repeat. Wakes `ctx` when it no longer can.
    pub(in crate::gui) fn is_held(&self, ctx: &Context) -> bool {
        let now = ctx.input(|input| input.time);
        let left = self.key.map_or(0.0, |(_, at)| at + LONGEST_PAUSE - now);
        if left > 0.0 {
            ctx.request_repaint_after(std::time::Duration::from_secs_f64(left));
        }
        left > 0.0
    }
}
