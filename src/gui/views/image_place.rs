//! Places in the image on the screen.

use eframe::egui::{Pos2, Rect, pos2};
use glam::DVec2;

/// The place in which a pane shows the image.
#[derive(Clone, Copy, Debug)]
pub(super) struct ImagePlace {
    /// In points of the screen.
    frame: Rect,
    /// m and n.
    sides: DVec2,
}

impl ImagePlace {
    /// The place of the figure's own image, without a second one beside it.
    #[expect(clippy::cast_precision_loss, reason = "sides of a screen")]
    pub(super) fn of(pane: &super::Pane) -> Self {
        let request = &pane.request;
        let f = request.image_frame();
        let image = request.shot.look.image;
        Self {
            frame: pane.rect.rect_of(f.x as f32, f.y as f32, f.width as f32, f.height as f32),
            sides: DVec2::new(f64::from(image.width), f64::from(image.height)),
        }
    }

    /// The point of the screen at a place in the image, pixels from its upper left corner.
    #[expect(clippy::cast_possible_truncation, reason = "a place on the screen")]
    pub(super) fn on_screen(&self, place: DVec2) -> Pos2 {
        let [x, y] = (place / self.sides).to_array().map(|share| share as f32);
        pos2(self.frame.left() + x * self.frame.width(), self.frame.top() + y * self.frame.height())
    }

    /// The place in the image at a point of the screen, or the nearest one.
    pub(super) fn in_image(&self, point: Pos2) -> DVec2 {
        let share = (point - self.frame.min) / self.frame.size();
        (DVec2::new(f64::from(share.x), f64::from(share.y)) * self.sides).clamp(DVec2::ZERO, self.sides)
    }
}
