//! A requested picture file in one value, for the window, for the command line, and for families.

use super::exact_width::fitted;
use super::{Composite, Family, FileOptions, NoComposite, OnPaper, PictureError, SheetSize};
use crate::progress::Progress;
use crate::views::{Finish, ObserverOf, Request, Shot, Size, Views};

/// A requested picture file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExportSpec {
    /// One view, or several on a sheet.
    pub views: Views,
    /// Width and height in pixels. For a single figure, they're those of the whole sheet.
    pub size: SheetSize,
    /// The factor of strokes and letters; `None` means by the height of letters on paper, or else as on a screen.
    pub scale: Option<f32>,
    /// Without background.
    pub transparent: bool,
    /// The units of paper.
    pub paper: Option<OnPaper>,
    /// True if the width is that on paper. If the background is cropped, the rest has this width.
    pub keeps_width: bool,
    /// The format, and its options.
    pub options: FileOptions,
}

impl ExportSpec {
    /// Width and height in pixels, as far as they're known before the pictures are arranged.
    pub fn pixels(&self) -> [u32; 2] {
        match self.size {
            SheetSize::Whole(size) | SheetSize::Pictures(size) => size,
            SheetSize::Width(width) => [width, width],
        }
    }

    /// A size with the requested strokes and letters.
    fn sized(&self, [width, height]: [u32; 2]) -> Size {
        let letters = self.paper.and_then(|paper| Some(paper.pixels(paper.letters?)));
        #[expect(clippy::cast_possible_truncation, reason = "the height of letters")]
        match (self.scale, letters) {
            (Some(scale), _) => Size { width, height, scale },
            (None, Some(letters)) => Size::with_letters(width, height, letters as f32),
            (None, None) => Size::as_on_a_screen(width, height),
        }
    }

    fn finished(&self, request: &Request) -> Request {
        Request { finish: Finish { transparent: self.transparent, ..Finish::default() }, ..request.clone() }
    }

    /// The views of a figure. `request` has its camera, scene and words. If `observer_of` is given, its observers are
    /// used.
    ///
    /// # Errors
    /// [`PictureError`] if the size is impossible, or if it's cancelled.
    pub async fn sheet(
        &self,
        request: &Request,
        shot: &Shot,
        observer_of: Option<&ObserverOf>,
        progress: &Progress,
    ) -> Result<Composite, PictureError> {
        let sheet_of = |factor: f64| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "too large sizes are refused")]
            let size = self.pixels().map(|side| (f64::from(side) * factor).round() as u32);
            let request = Request { size: self.sized(size), ..self.finished(request) };
            let sheet = Composite::of(self.views, &request, shot, self.paper.as_ref())?;
            Ok::<_, PictureError>(observer_of.into_iter().fold(sheet, Composite::seen_by))
        };
        if self.keeps_width && self.options.crop {
            fitted(self.pixels(), sheet_of, progress).await
        } else {
            sheet_of(1.0)
        }
    }

    /// The views of a family. `request` has its words.
    ///
    /// # Errors
    /// [`NoComposite`] if there's no room for them.
    pub fn family(&self, family: &Family, request: &Request) -> Result<Composite, NoComposite> {
        family.sheet(&self.finished(request), self.size, self.scale, self.paper.as_ref())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::format::PictureFormat;

    #[test]
    fn letters_have_points_on_paper_and_grow_with_large_screens() {
        let spec = |scale, paper| ExportSpec {
            views: Views::All,
            size: SheetSize::Whole([3000, 2250]),
            scale,
            transparent: false,
            paper,
            keeps_width: false,
            options: FileOptions::of(PictureFormat::Png),
        };
        let paper = OnPaper { dpi: 300.0, letters: Some(9.0), lines: None, arranged: false };
        // 9 pt at 300 dpi.
        assert!((spec(None, Some(paper)).sized([945, 709]).letters() - 37.5).abs() < 0.1);
        assert_eq!(spec(None, None).sized([3000, 2250]).scale, 3000.0 / 1920.0);
        assert_eq!(spec(Some(1.0), None).sized([3000, 2250]).scale, 1.0);
    }
}
