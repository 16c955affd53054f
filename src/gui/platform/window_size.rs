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

#[cfg(test)]
mod tests {
    use eframe::egui::{RawInput, Vec2, ViewportId};

    use super::*;

    /// The commands of the frames that follow one another, at these seconds, on a screen of this size.
    fn asked(screen: Option<Vec2>, times: &[f64]) -> Vec<ViewportCommand> {
        let ctx = Context::default();
        let mut opening = Opening::default();
        let frame = |&time: &f64| {
            let mut input = RawInput { time: Some(time), ..RawInput::default() };
            input.viewports.entry(ViewportId::ROOT).or_default().monitor_size = screen;
            let mut output = ctx.run_ui(input, |ui| opening.go_on(ui.ctx()));
            output.textures_delta.clear();
            let commands = output.viewport_output.remove(&ViewportId::ROOT).map(|output| output.commands);
            // egui has one of its own.
            let own = |command: &ViewportCommand| !matches!(command, ViewportCommand::SetTheme(_));
            commands.into_iter().flatten().filter(own).collect::<Vec<_>>()
        };
        times.iter().flat_map(frame).collect()
    }

    #[test]
    fn a_screen_that_is_larger_than_a_small_one_is_filled() {
        let maximized = ViewportCommand::Maximized(true);
        for large in [vec2(1920.0, 1080.0), vec2(1280.0, 800.0), vec2(1366.0, 720.0)] {
            assert_eq!(asked(Some(large), &[0.0, 0.1, 0.2]), std::slice::from_ref(&maximized), "{large}, once");
        }
        for small in [vec2(1280.0, 720.0), vec2(1024.0, 600.0)] {
            assert_eq!(asked(Some(small), &[0.0, 0.1, 5.0]), [], "{small}");
        }
        assert_eq!(asked(None, &[0.0, 5.0]), [], "as long as the screen is not known");
        // Nobody answers: there is no window manager.
        let sides = ViewportCommand::InnerSize(vec2(1920.0, 1080.0));
        let alone = asked(Some(vec2(1920.0, 1080.0)), &[0.0, 0.5, 1.2, 3.0]);
        assert_eq!(alone, [maximized, ViewportCommand::OuterPosition(Pos2::ZERO), sides]);
    }
}
