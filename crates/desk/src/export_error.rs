//! The reasons why a picture wasn't written.

use crate::export::format::PictureFormat;
use crate::figure::variation::VariationError;
use crate::picture::{NoComposite, PictureError};
use camera_lab_words::{Lang, families, messages, window};

/// The reason why a picture wasn't written.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    #[error(transparent)]
    /// The camera is impossible.
    Camera(#[from] crate::camera::CameraError),
    #[error(transparent)]
    /// The scene can't be built.
    Scene(#[from] crate::scene::SceneError),
    #[error(transparent)]
    /// The picture can't be drawn.
    Picture(#[from] PictureError),
    #[error(transparent)]
    /// The file can't be read or written.
    File(#[from] camera_lab_files::FileError),
    #[error(transparent)]
    /// A member of the family is impossible.
    Family(#[from] VariationError),
    /// A picture without background, in a format that has no transparency.
    #[error("{} has no transparency", .0.name())]
    NoTransparency(PictureFormat),
    /// The user doesn't want it any more.
    #[error("cancelled")]
    Cancelled,
    /// The export panicked.
    #[error("a bug in this program")]
    Panic,
}

impl ExportError {
    /// The reason why the picture `name` wasn't written.
    pub fn text(&self, lang: Lang, name: &str) -> String {
        let t = window::texts(lang);
        match self {
            Self::Camera(error) => messages::camera(lang, error),
            Self::Scene(error) => messages::scene(lang, error),
            Self::Family(error) => families::error(lang, error),
            Self::Cancelled | Self::Picture(PictureError::Cancelled) => format!("{} {name}", t.export_cancelled),
            Self::Picture(PictureError::TooLarge | PictureError::Composite(NoComposite::TooLarge)) => {
                t.picture_too_large.to_owned()
            }
            Self::Picture(PictureError::Composite(NoComposite::UnevenRows { count, columns })) => {
                families::uneven_rows(lang, *count, *columns)
            }
            Self::Picture(PictureError::Composite(NoComposite::NoRoom { count, .. })) => {
                format!("{count} {}", t.picture_no_room)
            }
            Self::Picture(PictureError::Strokes) => messages::over_budget(lang, &crate::pipeline::OverBudget::Strokes),
            Self::Picture(error @ PictureError::Font) => error.to_string(),
            Self::Picture(PictureError::Png(error)) => messages::png(lang, error),
            Self::Picture(PictureError::Encode { format, why }) => messages::encoder(lang, format.name(), why),
            Self::Picture(PictureError::Animate { format, why }) => messages::encoder(lang, format.name(), why),
            Self::File(error) => messages::file(lang, name, error),
            Self::NoTransparency(format) => format!("{} {}", format.name(), t.export_no_transparency),
            Self::Panic => format!("{} {name}", t.picture_failed),
        }
    }
}
