//! The size in which the window opens: as large as the screen allows, where that is larger than a small screen.

use eframe::egui::{Context, Pos2, ViewportCommand, vec2};

/// Screens up to this size, in points, have the window in the size that suits them.
const SMALL: [f32; 2] = [1280.0, 720.0];
/// Time for which a window manager is waited for, in seconds.
const PATIENCE: f32 = 1.0;

/// The opening of the window, from its first frame on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::gui) enum Opening {
    /// The size of the screen is not known yet.
    #[default]
    Begins,
    /// The window manager has been asked, at a time in seconds.
    Asked(f64),
    /// The window has its size.
    Done,
}

impl Opening {
    /// Goes on, in each frame.
    pub(in crate::gui) fn go_on(&mut self, ctx: &Context) {
        let (now, screen, maximized, inner) = ctx.input(|input| {
            let viewport = input.viewport();
            (input.time, viewport.monitor_size, viewport.maximized, viewport.inner_rect)
        });
        match (*self, screen) {
            (Self::Begins, Some(screen)) if screen.x > SMALL[0] || screen.y > SMALL[1] => {
                ctx.send_viewport_cmd(ViewportCommand::Maximized(true));
                ctx.request_repaint_after_secs(PATIENCE + 0.1);
                *self = Self::Asked(now);
            }
            (Self::Begins, Some(_)) => *self = Self::Done,
            (Self::Asked(since), Some(screen)) if now - since > f64::from(PATIENCE) => {
                let is_large = inner.is_some_and(|inner| inner.width() > 0.9 * screen.x);
                if maximized != Some(true) && !is_large {
                    // There is no window manager, and so nothing else on the screen.
                    ctx.send_viewport_cmd(ViewportCommand::OuterPosition(Pos2::ZERO));
                    ctx.send_viewport_cmd(ViewportCommand::InnerSize(vec2(screen.x, screen.y)));
                    // Without a window manager the new size may come after the frame that it asks for.
                    ctx.request_repaint_after_secs(0.2);
                }
                *self = Self::Done;
            }
            _ => {}
        }
    }
}
