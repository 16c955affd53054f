//! The size and the place of the window, restored from the last window. At first, on a screen that isn't small, it
//! fills the screen.

use eframe::egui::{Context, Pos2, Vec2, ViewportCommand, pos2, vec2};

use camera_lab_desk::WindowPlace;

/// On screens up to this size, in points, the window has the size that suits them.
const SMALL: [f32; 2] = [1280.0, 720.0];
/// Time to wait for a window manager, in seconds.
const MAX_WAIT: f32 = 1.0;

/// Time for which a size or a place stays before it's remembered, in seconds, to leave out those on the way to it.
const SETTLED: f64 = 1.0;
/// The part of the window that has to be on the screen, in points, so that the user can grab and move it.
const IN_SIGHT: f32 = 100.0;

/// The opening of the window, from its first frame on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::gui) enum Opening {
    /// The size of the screen isn't known yet.
    #[default]
    Begins,
    /// The window manager has been asked, at a time in seconds.
    Asked(f64),
    /// The window has its size.
    Done,
}

impl Opening {
    /// Advances, in each frame. `last` is the place of the last window.
    pub(in crate::gui) fn go_on(&mut self, ctx: &Context, last: Option<WindowPlace>) {
        let (now, screen, maximized, inner) = ctx.input(|input| {
            let viewport = input.viewport();
            (input.time, viewport.monitor_size, viewport.maximized, viewport.inner_rect)
        });
        match (*self, screen) {
            (Self::Begins, Some(screen)) if last.is_some() => {
                last.into_iter().for_each(|last| open_at(ctx, last, screen));
                *self = Self::Done;
            }
            (Self::Begins, Some(screen)) if screen.x > SMALL[0] || screen.y > SMALL[1] => {
                ctx.send_viewport_cmd(ViewportCommand::Maximized(true));
                ctx.request_repaint_after_secs(MAX_WAIT + 0.1);
                *self = Self::Asked(now);
            }
            (Self::Begins, Some(_)) => *self = Self::Done,
            (Self::Asked(since), Some(screen)) if now - since > f64::from(MAX_WAIT) => {
                let is_large = inner.is_some_and(|inner| inner.width() > 0.9 * screen.x);
                if maximized != Some(true) && !is_large {
                    // There is no window manager, and so no other window on the screen.
                    ctx.send_viewport_cmd(ViewportCommand::OuterPosition(Pos2::ZERO));
                    ctx.send_viewport_cmd(ViewportCommand::InnerSize(vec2(screen.x, screen.y)));
                    // Without a window manager the new size may come after the frame that requests it.
                    ctx.request_repaint_after_secs(0.2);
                }
                *self = Self::Done;
            }
            _ => {}
        }
    }
}

/// Opens the window at the last one's place, as far as that is on this screen.
fn open_at(ctx: &Context, last: WindowPlace, screen: Vec2) {
    #[expect(clippy::cast_precision_loss, reason = "a window fits into its screen")]
    let [width, height] = last.size.map(|side| side as f32 / ctx.zoom_factor());
    ctx.send_viewport_cmd(ViewportCommand::InnerSize(vec2(width, height).min(screen)));
    #[expect(clippy::cast_precision_loss, reason = "it was on a screen")]
    let at = last.at.map(|[x, y]| pos2(x as f32, y as f32) / ctx.zoom_factor());
    let is_in_sight = |at: &Pos2| {
        let seen = (0.0..=screen.y - IN_SIGHT).contains(&at.y);
        seen && at.x + width >= IN_SIGHT && at.x <= screen.x - IN_SIGHT
    };
    if let Some(at) = at.filter(is_in_sight) {
        ctx.send_viewport_cmd(ViewportCommand::OuterPosition(at));
    }
    if last.maximized {
        ctx.send_viewport_cmd(ViewportCommand::Maximized(true));
    }
}

/// Watches the place of the window.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::gui) struct Whereabouts {
    now: Option<(WindowPlace, f64)>,
}

impl Whereabouts {
    /// Returns the place of the window once it has stayed there for a while. `None` if it hasn't, or if it fills the
    /// screen for a presentation.
    pub(in crate::gui) fn settled(&mut self, ctx: &Context, before: Option<WindowPlace>) -> Option<WindowPlace> {
        let (now, viewport) = ctx.input(|input| (input.time, input.viewport().clone()));
        if viewport.fullscreen == Some(true) || viewport.minimized == Some(true) {
            return None;
        }
        // The size of the interface is a setting of its own.
        let zoom = ctx.zoom_factor();
        let (maximized, size) = (viewport.maximized == Some(true), zoom * viewport.inner_rect?.size());
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a window fits into its screen")]
        let here = match before.filter(|_| maximized) {
            // The place that it returns to from there.
            Some(before) => WindowPlace { maximized, ..before },
            None => WindowPlace {
                at: viewport
                    .outer_rect
                    .map(|outer| (zoom * outer.min.to_vec2()).round())
                    .map(|at| [at.x as i32, at.y as i32]),
                size: [size.x.round() as u32, size.y.round() as u32],
                maximized,
            },
        };
        match self.now {
            Some((place, since)) if place == here => (now - since >= SETTLED).then_some(here),
            _ => {
                self.now = Some((here, now));
                if Some(here) != before {
                    ctx.request_repaint_after_secs(1.1);
                }
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use eframe::egui::{RawInput, Vec2, ViewportId};

    use super::*;

    /// The commands of the frames that follow one another, at these seconds, on a screen of this size.
    fn asked(screen: Option<Vec2>, times: &[f64]) -> Vec<ViewportCommand> {
        commands(None, screen, times)
    }

    /// The same if the last window had a place.
    fn commands(last: Option<WindowPlace>, screen: Option<Vec2>, times: &[f64]) -> Vec<ViewportCommand> {
        let ctx = Context::default();
        let mut opening = Opening::default();
        let frame = |&time: &f64| {
            let mut input = RawInput { time: Some(time), ..RawInput::default() };
            input.viewports.entry(ViewportId::ROOT).or_default().monitor_size = screen;
            let mut output = ctx.run_ui(input, |ui| opening.go_on(ui.ctx(), last));
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
        // There is no answer, so there is no window manager.
        let sides = ViewportCommand::InnerSize(vec2(1920.0, 1080.0));
        let alone = asked(Some(vec2(1920.0, 1080.0)), &[0.0, 0.5, 1.2, 3.0]);
        assert_eq!(alone, [maximized, ViewportCommand::OuterPosition(Pos2::ZERO), sides]);
    }

    #[test]
    fn a_window_opens_at_the_last_place_if_that_is_on_the_screen() {
        let screen = Some(vec2(1920.0, 1080.0));
        let last = |at, maximized| Some(WindowPlace { at, size: [1000, 700], maximized });
        let size = ViewportCommand::InnerSize(vec2(1000.0, 700.0));
        let place = ViewportCommand::OuterPosition(pos2(50.0, 60.0));
        assert_eq!(commands(last(Some([50, 60]), false), screen, &[0.0, 2.0]), [size.clone(), place.clone()]);
        // Wayland gives no place, and a second screen may be gone.
        assert_eq!(commands(last(None, false), screen, &[0.0, 2.0]), std::slice::from_ref(&size));
        assert_eq!(commands(last(Some([2500, 60]), false), screen, &[0.0, 2.0]), std::slice::from_ref(&size));
        let maximized = commands(last(Some([50, 60]), true), screen, &[0.0, 2.0]);
        assert_eq!(maximized, [size, place, ViewportCommand::Maximized(true)]);
    }
}
