//! Handouts produced beside the window's thread: their pages for the preview, and the file.

use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};

use crate::export::vector::{Page, pixels};
use crate::gui::kit::frames;
use crate::picture::PictureError;
use crate::progress::Progress;
use camera_lab_desk::{ExportError, Job, Worker};
use camera_lab_words::handout::HandoutOptions;

/// The preview is drawn at this multiple of its displayed size, so that thin strokes stay whole.
const FINENESS: f32 = 1.5;

/// A requested page.
struct PageJob {
    choices: Choices,
    handout: Job,
    page: usize,
    /// The width of a page in pixels.
    width: f32,
}

/// The pixels of a page, and the number of pages.
type Done = Result<(ColorImage, usize), ExportError>;

/// The choices that the pages depend on.
pub(in crate::gui) type Choices = (Option<crate::lessons::OpenLesson>, Vec<String>, [u32; 2], HandoutOptions);

/// The pages of a handout as long as its dialog is open.
pub struct PagesPreview {
    worker: Worker<PageJob, Done>,
    asked: Option<(Choices, usize)>,
    /// The page, once there is one.
    pub(in crate::gui) texture: Option<TextureHandle>,
    /// The number of pages. 0 as long as it isn't known.
    pub count: usize,
    /// The reason why there are no pages.
    pub(in crate::gui) fault: Option<ExportError>,
}

impl std::fmt::Debug for PagesPreview {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PagesPreview").field("asked", &self.asked).finish_non_exhaustive()
    }
}

impl Default for PagesPreview {
    fn default() -> Self {
        let worker = Worker::new("handout", crate::clock::now, work);
        Self { worker, asked: None, texture: None, count: 0, fault: None }
    }
}

fn work() -> impl AsyncFnMut(PageJob, &Progress) -> Done {
    // Turning a page doesn't build the handout again.
    let mut made: Option<(Choices, Vec<Page>)> = None;
    async move |PageJob { choices, handout, page, width }, progress: &Progress| {
        let kept = made.take().filter(|(of, _)| *of == choices);
        let pages = match kept {
            Some((_, pages)) => pages,
            None => handout.handout(progress)?.pages(progress).await?,
        };
        let (_, pages) = made.insert((choices, pages));
        let count = pages.len();
        let page = pages.get(page.min(count.saturating_sub(1))).ok_or(PictureError::Font)?;
        let picture = pixels(page, FINENESS * width / page.size[0]).ok_or(PictureError::TooLarge)?;
        let size = [picture.width() as usize, picture.height() as usize];
        Ok((ColorImage::from_rgba_premultiplied(size, picture.data()), count))
    }
}

impl PagesPreview {
    /// Takes results, and requests pages if the choices or the page have changed. `width` is that of a page in pixels.
    pub(in crate::gui) fn follow(
        &mut self,
        ctx: &Context,
        choices: Choices,
        (page, width): (usize, f32),
        job: impl FnOnce() -> Job,
    ) {
        let [done] = self.worker.take(std::time::Duration::ZERO);
        match done.map(|done| done.outcome.unwrap_or(Err(ExportError::Panic))) {
            Some(Ok((image, count))) => {
                (self.count, self.fault) = (count, None);
                self.texture = Some(ctx.load_texture("page of a handout", image, TextureOptions::LINEAR));
            }
            Some(Err(error)) => (self.texture, self.fault) = (None, Some(error)),
            None => {}
        }
        if self.asked.as_ref().is_some_and(|(asked, shown)| *asked == choices && *shown == page) {
            return;
        }
        self.worker.ask(&frames(ctx), 0, PageJob { choices: choices.clone(), handout: job(), page, width });
        self.asked = Some((choices, page));
    }
}
