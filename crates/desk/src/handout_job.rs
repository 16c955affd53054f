//! A handout to be written: its content, and its file.

use crate::export_error::ExportError;
use crate::lessons::OpenLesson;
use crate::picture::{Handout, PictureError};
use crate::progress::Progress;
use crate::sanitize;
use crate::views::{SharedScene, View, Views, scene_of};
use camera_lab_files::FigureFiles;
use camera_lab_words::handout::{self, HandoutOptions, NoPicture, Scenes, Solutions, Version, views_of};

/// A requested handout.
#[derive(Clone)]
pub struct Job {
    /// The lesson or the exercises.
    pub content: Content,
    /// The choices for the pages.
    pub options: HandoutOptions,
    /// The address of the course's page, for the foot of each page. Empty if it isn't known.
    pub address: String,
}

/// The content of a handout.
#[derive(Clone)]
pub enum Content {
    /// A lesson, with its file.
    Lesson(OpenLesson),
    /// Exercises with their numbers.
    Exercises(Vec<Version>),
}

impl From<NoPicture> for ExportError {
    fn from(error: NoPicture) -> Self {
        match error {
            NoPicture::Camera(error) => Self::Camera(error),
            NoPicture::Composite(error) => Self::Picture(PictureError::from(error)),
        }
    }
}

impl Job {
    /// The pages to write.
    ///
    /// # Errors
    /// [`ExportError`] if a picture can't be drawn.
    pub fn handout(&self, progress: &Progress) -> Result<Handout, ExportError> {
        let mut handout = self.without_address(progress)?;
        if !self.address.is_empty() {
            for part in &mut handout.parts {
                let own = if part.foot.is_empty() { String::new() } else { format!("{}  ·  ", part.foot) };
                // An underscore would begin a subscript.
                part.foot = format!("{own}{}", sanitize::escaped(&self.address).replace('_', "\\_"));
            }
        }
        Ok(handout)
    }

    fn without_address(&self, progress: &Progress) -> Result<Handout, ExportError> {
        let options = self.options;
        match &self.content {
            Content::Lesson(OpenLesson { lesson, path, .. }) => {
                let mut files = FigureFiles::of_lesson(path.as_deref(), false);
                let mut scenes = Scenes::default();
                handout::of_lesson(lesson, options, |(_, step), size| {
                    let build = || scene_of(&step.figure, &mut |wanted| files.read(wanted), progress);
                    let scene = scenes.of(&step.figure, build)?;
                    Ok(handout::picture(&step.figure, &scene, views_of(&step.figure), size, options.lang)?)
                })
            }
            Content::Exercises(sheet) => handout::of_exercises(sheet, options, |figure, size| {
                let scene = SharedScene::new(scene_of(figure, &mut crate::scene::no_files, progress)?);
                Ok(handout::picture(figure, &scene, Views::One(View::Image), size, options.lang)?)
            }),
        }
    }

    /// The handout as a PDF file. Solutions of several versions are a second one.
    ///
    /// # Errors
    /// [`ExportError`] if a picture can't be drawn.
    pub async fn pdfs(&self, progress: &Progress) -> Result<(Vec<u8>, Option<Vec<u8>>), ExportError> {
        let pdf = async |job: &Self| Ok::<_, ExportError>(job.handout(progress)?.pdf(progress).await?);
        let solutions = match self.solutions_apart() {
            Some(job) => Some(pdf(&job).await?),
            None => None,
        };
        Ok((pdf(&self.first_file()).await?, solutions))
    }

    /// The handout of the first file, without the solutions that stand in a second one.
    #[must_use]
    pub fn first_file(&self) -> Self {
        if self.solutions_apart().is_some() { self.with(Solutions::None) } else { self.clone() }
    }

    /// The solutions of several versions, which stand in a second file.
    fn solutions_apart(&self) -> Option<Self> {
        let has_versions = matches!(&self.content, Content::Exercises(versions) if versions.len() > 1);
        (has_versions && self.options.answers != Solutions::None).then(|| self.with(Solutions::Alone))
    }

    fn with(&self, answers: Solutions) -> Self {
        Self { options: HandoutOptions { answers, ..self.options }, ..self.clone() }
    }
}
