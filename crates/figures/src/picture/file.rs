//! Pictures as files, in the requested format.

use std::path::{Path, PathBuf};

use super::error::PictureError;
use super::vectors::{Drawn, Faces, KnownPictures, NoAreas, page};
use super::{Composite, Pixels, Renderer};
use crate::camera::Ndc;
use crate::export::format::PictureFormat;
pub use crate::export::vector::Beside;
use crate::export::vector::{self, Letters, Page};
use crate::export::web;
use crate::pipeline::OverBudget;
use crate::progress::Progress;
use crate::views::View;

/// A picture as a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PictureFile {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// The file that belongs beside it.
    pub beside: Option<Beside>,
    /// A shortfall of the picture.
    pub over_budget: Option<OverBudget>,
    /// The reason why the faces of a page of vectors are a picture, although areas were requested.
    pub no_areas: Option<NoAreas>,
}

/// The words that go with a picture into its file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Metadata {
    /// The figure file. Empty means none.
    pub figure: String,
    /// Becomes the title of the file; empty if there is none.
    pub title: String,
    /// A sentence for readers who can't see it.
    pub description: String,
    /// The language of both, as a tag: `en`, `pt-BR`.
    pub language: &'static str,
    /// The name of the file without its extension, by which it refers to a file beside it.
    pub stem: String,
}

impl Metadata {
    /// The same for a file with this name.
    pub fn for_file(self, path: &Path) -> Self {
        Self { stem: vector::stem(path), ..self }
    }
}

/// The file written beside a picture at `path`: the PDF of a LaTeX file.
pub fn file_beside(path: &Path) -> Option<PathBuf> {
    let is_latex = PictureFormat::of(path) == Some(PictureFormat::Tex);
    is_latex.then(|| path.with_file_name(format!("{}.pdf", vector::art_of(&vector::stem(path)))))
}

/// Options of a picture file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileOptions {
    /// By the extension of the file.
    pub format: PictureFormat,
    /// Crop the empty background around each picture.
    pub crop: bool,
    /// Pixels per inch on paper. PNG and JPEG store them for printing, and vectors have their size by them; `None`
    /// means not for paper.
    pub dpi: Option<f64>,
    /// The form of the faces of vectors.
    pub faces: Faces,
    /// The form of the letters of vectors.
    pub letters: Letters,
}

impl FileOptions {
    /// The usual options of a format: the whole picture, not for paper.
    pub fn of(format: PictureFormat) -> Self {
        Self { format, crop: false, dpi: None, faces: Faces::default(), letters: Letters::default() }
    }
}

/// Pixels per inch if none are given, as in CSS.
pub const PER_INCH: f64 = 96.0;
/// The resolution of pictures of faces if none is given, in pixels per inch.
const FINE: f64 = 192.0;

/// The content of such a file: the pictures of `sheet`, and their shortfall. With `crop`, each is without the empty
/// background around it. Pauses after each band of a picture.
///
/// # Errors
/// [`PictureError::TooLarge`] and [`PictureError::Cancelled`].
pub async fn assembled(
    sheet: &Composite,
    crop: bool,
    progress: &Progress,
) -> Result<(Pixels, Option<OverBudget>), PictureError> {
    let or_cancelled = |error| if progress.is_cancelled() { PictureError::Cancelled } else { error };
    let mut renderer = Renderer::default();
    renderer.watch(progress);
    renderer.sheet(sheet, crop).await.ok_or(PictureError::TooLarge).map_err(or_cancelled)
}

/// The file with the pictures of `sheet`, and with a figure file in it if the format can carry one. It pauses after
/// each band of a picture and each row of a PNG, and after each picture of vectors. WebP and JPEG are encoded without a
/// pause.
///
/// If a PNG shows the canonical volume in another convention than the notes', it names that convention, even if the
/// picture is too small to do so.
///
/// *Guarantees*: the same sheet, form and text give the same bytes.
///
/// # Errors
/// [`PictureError`].
pub async fn file(
    sheet: &Composite,
    form: FileOptions,
    told: &Metadata,
    progress: &Progress,
) -> Result<PictureFile, PictureError> {
    let FileOptions { format, crop, dpi, letters, .. } = form;
    let or_cancelled = |error| if progress.is_cancelled() { PictureError::Cancelled } else { error };
    let encode = |bytes: Result<Vec<u8>, String>| bytes.map_err(|why| PictureError::Encode { format, why });
    let pixels = async || assembled(sheet, crop, progress).await;
    let pixmap = |picture: &mut Pixels| picture.take_pixmap().ok_or(PictureError::TooLarge);
    let mut beside = None;
    let (bytes, over_budget, no_areas) = match format {
        PictureFormat::Png => {
            let (picture, over_budget) = pixels().await?;
            let bytes = picture.into_png(&told.figure, convention(sheet).as_deref(), dpi, progress).await;
            (bytes.map_err(|error| or_cancelled(error.into()))?, over_budget, None)
        }
        PictureFormat::WebP => {
            let (mut picture, over_budget) = pixels().await?;
            (encode(web::webp(pixmap(&mut picture)?))?, over_budget, None)
        }
        PictureFormat::Jpeg => {
            let (mut picture, over_budget) = pixels().await?;
            (encode(web::jpeg(&pixmap(&mut picture)?, dpi))?, over_budget, None)
        }
        PictureFormat::Svg | PictureFormat::Pdf | PictureFormat::Tex => {
            let Drawn { page, over_budget, no_areas } = drawn(sheet, form, told, progress).await?;
            let (bytes, pdf) =
                vector::file(&page, format, letters, &told.figure, &told.stem).ok_or(PictureError::Font)?;
            beside = pdf;
            (bytes, over_budget, no_areas)
        }
    };
    Ok(PictureFile { bytes, beside, over_budget, no_areas })
}

/// The page of vectors with its words.
async fn drawn(
    sheet: &Composite,
    form: FileOptions,
    told: &Metadata,
    progress: &Progress,
) -> Result<Drawn, PictureError> {
    let resolution = [form.dpi.unwrap_or(PER_INCH), form.dpi.unwrap_or(FINE)];
    let drawn = page(sheet, (form.faces, &mut KnownPictures::new()), resolution, form.crop, progress).await?;
    let Metadata { title, description, language, .. } = told.clone();
    Ok(Drawn { page: Page { title, description, language, ..drawn.page }, ..drawn })
}

/// The convention of NDC of the canonical volume, if it isn't that of the notes.
fn convention(sheet: &Composite) -> Option<String> {
    let request = sheet.requests.iter().find(|request| request.view == View::Canonical)?;
    let ndc = request.camera.possible_clip_space(request.shot.ndc).ndc();
    (ndc != Ndc::default()).then(|| format!("NDC: {}", request.labels.ndc_title(ndc)))
}
