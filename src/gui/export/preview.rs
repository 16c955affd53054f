//! The picture that the export dialog shows, and the one that it copies. They are drawn beside the window's thread, in
//! the same way as the exported one.

use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};

use super::family_choice::FamilyChoice;
use crate::export::format::PictureFormat;
use crate::gui::export::{Export, ExportSource};
use crate::gui::kit::frames;
use crate::picture::{self, Composite, Crowded, FileOptions, Renderer};
use crate::progress::Progress;
use crate::views::View;
use camera_lab_desk::{ExportError, Worker};

/// The preview is drawn at this multiple of its displayed size, so that thin strokes stay whole.
const FINENESS: f32 = 2.0;

const SHOWN: usize = 0;
const COPIED: usize = 1;

/// The preview of the export dialog as long as it's open.
pub struct Preview {
    worker: Worker<PreviewJob, Done, 2>,
    /// The last request.
    asked: Option<(Export, FamilyChoice)>,
    /// The picture, once there is one.
    pub texture: Option<TextureHandle>,
    /// The message if several pictures have little space on their paper.
    pub(in crate::gui) crowded: Option<Crowded>,
    /// The labels that have no room in the pictures.
    pub left_out: Vec<String>,
    /// Width and height of the export in pixels. A family may be far larger than the picture of its figure.
    pub size: Option<[u32; 2]>,
    /// The reason why there is no picture.
    pub(in crate::gui) fault: Option<ExportError>,
    /// The result of the last copy.
    pub(in crate::gui) copied: Option<Result<(), ExportError>>,
}

/// A requested picture.
struct PreviewJob {
    subject: ExportSource,
    export: Export,
    /// The pixels of the preview's place. `None` for the size of the export.
    room: Option<[f32; 2]>,
    /// Vectors as text in place of pixels.
    as_svg: bool,
}

/// The result of a job.
enum Drawn {
    /// An image, the message if several pictures have little space on their paper, the texts without room, and the size
    /// of the export.
    Picture(ColorImage, Option<Crowded>, Vec<String>, [u32; 2]),
    /// A picture of vectors as text.
    Svg(String),
}

type Done = Result<Drawn, ExportError>;

impl std::fmt::Debug for Preview {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Preview").field("asked", &self.asked).finish_non_exhaustive()
    }
}

impl Default for Preview {
    fn default() -> Self {
        let worker = Worker::new("preview", crate::clock::now, work);
        Self {
            worker,
            asked: None,
            texture: None,
            crowded: None,
            left_out: Vec::new(),
            size: None,
            fault: None,
            copied: None,
        }
    }
}

fn work() -> impl AsyncFnMut(PreviewJob, &Progress) -> Done {
    async |PreviewJob { subject, export, room, as_svg }, progress: &Progress| {
        let sheet = subject.sheet(&export, progress).await?;
        let size = sheet.size().unwrap_or([export.width, export.height]);
        let has_room = room.is_some();
        let sheet = sheet.reduced(room.map_or(1.0, |room| factor(size, room)));
        if as_svg {
            let form = FileOptions { format: PictureFormat::Svg, ..export.spec(false).options };
            let file = picture::file(&sheet, form, &subject.told(&sheet, String::new()), progress).await?;
            return Ok(Drawn::Svg(String::from_utf8_lossy(&file.bytes).into_owned()));
        }
        let (pixels, _) = picture::assembled(&sheet, export.crop, progress).await?;
        // A texture that's minified on the screen skips rows of pixels, and with them thin strokes. The mean keeps
        // them.
        let (size_drawn, rgba) = ([pixels.width(), pixels.height()], pixels.rgba());
        let room = room.map_or([f32::INFINITY; 2], |room| room.map(|side| side / FINENESS));
        let shown = reduced(size_drawn, rgba, room);
        // A family has captions, and names would be missing in many of its small pictures. The clipboard says nothing.
        let says = has_room && sheet.requests.len() <= View::ALL.len();
        let left_out = if says { left_out(&sheet) } else { Vec::new() };
        Ok(Drawn::Picture(shown, sheet.crowded, left_out, size))
    }
}

/// The labels that find no free place in the pictures, but would in larger ones.
fn left_out(sheet: &Composite) -> Vec<String> {
    let (mut renderer, mut missing) = (Renderer::default(), Vec::new());
    for own in &sheet.requests {
        let placed = renderer.labels(own);
        let is_placed = |name: &str| placed.iter().any(|label| label.name == name);
        for label in renderer.labels_with_room(own) {
            if !is_placed(&label.name) && !missing.contains(&label.text) {
                missing.push(label.text);
            }
        }
    }
    missing
}

impl Preview {
    /// Takes results, and requests a new preview if the settings have changed. `room` is the width and height in pixels
    /// of its place.
    pub(in crate::gui) fn follow(
        &mut self,
        ctx: &Context,
        (export, family): (&Export, &FamilyChoice),
        room: [f32; 2],
        subject: impl FnOnce() -> ExportSource,
    ) {
        let [shown, copied] = self.worker.take(std::time::Duration::ZERO);
        match shown.map(|done| done.outcome.unwrap_or(Err(ExportError::Panic))) {
            Some(Ok(Drawn::Picture(picture, crowded, left_out, size))) => {
                (self.crowded, self.left_out, self.size) = (crowded, left_out, Some(size));
                self.texture = Some(ctx.load_texture("export preview", picture, TextureOptions::LINEAR));
                self.fault = None;
            }
            Some(Err(error)) => {
                (self.texture, self.crowded, self.size, self.fault) = (None, None, None, Some(error));
                self.left_out.clear();
            }
            Some(Ok(Drawn::Svg(_))) | None => {}
        }
        if let Some(done) = copied {
            let outcome = done.outcome.unwrap_or(Err(ExportError::Panic));
            self.copied = Some(outcome.map(|drawn| match drawn {
                Drawn::Picture(picture, ..) => ctx.copy_image(picture),
                Drawn::Svg(text) => ctx.copy_text(text),
            }));
        }
        if self.asked.as_ref().is_none_or(|(asked, of)| asked != export || of != family) {
            self.asked = Some((*export, family.clone()));
            self.copied = None;
            let room = Some(room.map(|side| FINENESS * side));
            self.worker.ask(
                &frames(ctx),
                SHOWN,
                PreviewJob { subject: subject(), export: *export, room, as_svg: false },
            );
        }
    }

    /// Draws the picture at its size, and then puts it on the clipboard. Vectors go there as the text of an SVG file.
    pub(in crate::gui) fn copy(&mut self, ctx: &Context, export: &Export, subject: ExportSource) {
        self.copied = None;
        self.worker.ask(
            &frames(ctx),
            COPIED,
            PreviewJob { subject, export: *export, room: None, as_svg: export.format.is_vector() },
        );
    }

    /// True while the picture for the clipboard is drawn.
    pub(in crate::gui) fn is_copying(&self) -> bool {
        self.worker.is_pending(COPIED)
    }
}

/// True if an export of this size is small enough for the clipboard.
pub(in crate::gui) fn can_be_copied(export: &Export, [width, height]: [u32; 2]) -> bool {
    export.format.is_vector() || u64::from(width) * u64::from(height) <= crate::limits::MAX_COPIED_PIXELS
}

/// The picture at the size at which it fits into this number of pixels, each of them the mean of those that it
/// replaces.
fn reduced(size: [u32; 2], rgba: &[u8], room: [f32; 2]) -> ColorImage {
    let factor = factor(size, room);
    let whole = image::RgbaImage::from_raw(size[0], size[1], rgba.to_vec()).filter(|_| factor < 1.0);
    let Some(whole) = whole else {
        return ColorImage::from_rgba_premultiplied(size.map(|side| side as usize), rgba);
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "pixels")]
    let [width, height] = size.map(|side| (side as f32 * factor).round().max(1.0) as u32);
    let small = image::imageops::thumbnail(&whole, width, height);
    ColorImage::from_rgba_premultiplied([width as usize, height as usize], small.as_raw())
}

/// The reduction of a picture that fits into this number of pixels. 1 if it fits already.
fn factor([width, height]: [u32; 2], room: [f32; 2]) -> f32 {
    #[expect(clippy::cast_precision_loss, reason = "pixels")]
    let [width, height] = [width.max(1) as f32, height.max(1) as f32];
    (room[0] / width).min(room[1] / height).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::NamedPoint;

    #[test]
    fn labels_without_room_are_named() {
        let mut state = crate::gui::app::state::State::new(crate::gui::Start::default()).expect("a camera");
        // A crowd of followed points.
        for k in 0..24 {
            let position = glam::DVec3::new(0.02 * f64::from(k), 0.5, 0.0);
            state.model.desk.shown.edit(|figure| {
                figure.points.push(NamedPoint { name: format!("point {k}"), position });
            });
        }
        let missing = |size| {
            let what = crate::views::Views::One(View::World);
            let export = Export { what, scale: 1.0, ..Export::new([size; 3], 1.0) };
            let export = Export { width: size[0], height: size[1], times: None, ..export };
            let subject = ExportSource::of(&state.model, &FamilyChoice::default(), crate::appearance::Theme::Light);
            let sheet = crate::progress::at_once(subject.sheet(&export, &Progress::default())).expect("a sheet");
            left_out(&sheet)
        };
        let [small, large] = [[200, 150], [1600, 1200]].map(missing);
        assert!(
            small.iter().any(|name| name.starts_with("point")) && large.len() < small.len(),
            "{small:?}, {large:?}"
        );
    }

    #[test]
    fn a_thin_stroke_stays_visible_wherever_it_lies() {
        let (width, height) = (60, 401);
        for row in 100..140 {
            let mut rgba = vec![255; width * height * 4];
            let line = row * width * 4..(row + 1) * width * 4;
            rgba[line].chunks_exact_mut(4).for_each(|pixel| pixel[..3].fill(0));
            let small = reduced([60, 401], &rgba, [60.0, 173.0]);
            let darkest = small.pixels.iter().map(|pixel| pixel.r()).min();
            assert!(darkest.is_some_and(|r| r < 180), "row {row}: {darkest:?}");
        }
    }

    #[test]
    fn a_preview_larger_than_its_room_is_reduced() {
        for (size, expected) in [([6000, 3000], 0.12), ([960, 960], 0.5), ([64, 48], 1.0)] {
            assert_eq!(factor(size, [720.0, 480.0]), expected);
        }
    }
}
