//! The picture that the export dialog shows, and the one that it copies: drawn beside the window's thread, in the same way as the one
//! that is written.

use std::time::Duration;

use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};

use super::export::{Export, ExportError, Subject};
use super::worker::{Work, Worker};
use crate::clock;
use crate::limits::{MAX_COPIED_PIXELS, MAX_PIXELS};
use crate::picture::{self, Picture, PictureError};
use crate::views::Size;

/// The small picture is drawn so many times as large as it is shown: thin strokes stay whole.
const FINENESS: f32 = 2.0;

const SHOWN: usize = 0;
const COPIED: usize = 1;

/// What is drawn for the export dialog as long as it is open.
pub struct Preview {
    worker: Worker<Job, Drawn, 2>,
    /// What was asked for last.
    asked: Option<Export>,
    texture: Option<TextureHandle>,
    /// Why there is no picture.
    pub(super) fault: Option<ExportError>,
    /// What became of the last copy.
    pub(super) copied: Option<Result<(), ExportError>>,
}

/// A picture that is wanted.
struct Job {
    subject: Subject,
    export: Export,
    size: Size,
}

type Drawn = Result<Picture, ExportError>;

impl std::fmt::Debug for Preview {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Preview").field("asked", &self.asked).finish_non_exhaustive()
    }
}

impl Default for Preview {
    fn default() -> Self {
        let worker = Worker::new("preview", clock::now, work);
        Self { worker, asked: None, texture: None, fault: None, copied: None }
    }
}

fn work() -> Work<Job, Drawn> {
    Box::new(|Job { subject, export, size }, progress| {
        if u64::from(export.width) * u64::from(export.height) > MAX_PIXELS {
            return Err(PictureError::TooLarge.into());
        }
        let requests = subject.requests(&export, size, progress)?;
        Ok(picture::assembled(&requests, export.crop, progress)?.0)
    })
}

impl Preview {
    /// Takes what has been drawn, and has the picture drawn anew where it is to be another one; `room`: width and height in pixels
    /// of the place for it.
    pub(super) fn follow(&mut self, ctx: &Context, export: &Export, room: [f32; 2], subject: impl FnOnce() -> Subject) {
        let [shown, copied] = self.worker.take(Duration::ZERO);
        match shown.map(|done| done.outcome.unwrap_or(Err(ExportError::Panic))) {
            Some(Ok(picture)) => {
                self.texture = Some(ctx.load_texture("export preview", image(&picture), TextureOptions::LINEAR));
                self.fault = None;
            }
            Some(Err(error)) => (self.texture, self.fault) = (None, Some(error)),
            None => {}
        }
        if let Some(done) = copied {
            let outcome = done.outcome.unwrap_or(Err(ExportError::Panic));
            self.copied = Some(outcome.map(|picture| ctx.copy_image(image(&picture))));
        }
        if self.asked != Some(*export) {
            self.asked = Some(*export);
            self.copied = None;
            let size = reduced(export, room.map(|side| FINENESS * side));
            self.worker.ask(ctx, SHOWN, Job { subject: subject(), export: *export, size });
        }
    }

    /// The picture, once there is one.
    #[must_use]
    pub fn texture(&self) -> Option<&TextureHandle> {
        self.texture.as_ref()
    }

    /// Draws the picture at its size, and puts it on the clipboard then.
    pub(super) fn copy(&mut self, ctx: &Context, export: &Export, subject: Subject) {
        self.copied = None;
        self.worker.ask(ctx, COPIED, Job { subject, export: *export, size: export.size() });
    }

    /// True while the picture for the clipboard is drawn.
    pub(super) fn is_copying(&self) -> bool {
        self.worker.is_pending(COPIED)
    }
}

/// True for what is not too large for the clipboard.
pub(super) fn can_be_copied(export: &Export) -> bool {
    u64::from(export.width) * u64::from(export.height) <= MAX_COPIED_PIXELS
}

fn image(picture: &Picture) -> ColorImage {
    let size = [picture.width() as usize, picture.height() as usize];
    ColorImage::from_rgba_premultiplied(size, picture.rgba())
}

/// The size of the export where it has room in so many pixels, or else a smaller one with the same proportions: letters and strokes
/// are smaller by the same factor.
fn reduced(export: &Export, room: [f32; 2]) -> Size {
    let whole = export.size();
    #[expect(clippy::cast_precision_loss, reason = "pixels")]
    let sides = [whole.width.max(1) as f32, whole.height.max(1) as f32];
    let factor = (room[0] / sides[0]).min(room[1] / sides[1]).min(1.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "less than the room")]
    let [width, height] = sides.map(|side| (side * factor).round().max(1.0) as u32);
    Size { width, height, scale: whole.scale * factor }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smaller_picture_has_the_same_proportions_in_letters_too() {
        for [width, height] in [[6000, 3000], [945, 709], [400, 4000]] {
            let export = Export { width, height, scale: 3.0, ..Export::new([[640, 480]; 3], 1.0) };
            let (whole, small) = (export.size(), reduced(&export, [720.0, 480.0]));
            assert!(small.width <= 720 && small.height <= 480, "{small:?}");
            assert!((small.aspect() / whole.aspect() - 1.0).abs() < 0.02, "{small:?}");
            let letters = |size: Size| f64::from(size.letters()) / f64::from(size.height);
            assert!((letters(small) / letters(whole) - 1.0).abs() < 0.02, "{small:?}");
        }
        let export = Export { width: 64, height: 48, scale: 1.0, ..Export::new([[640, 480]; 3], 1.0) };
        assert_eq!(reduced(&export, [720.0, 480.0]), export.size(), "nothing is enlarged");
    }
}
