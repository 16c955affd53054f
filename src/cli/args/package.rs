//! The arguments of a page for students and of a package for a course platform, besides their lesson or exercises.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::cli::Failure;
use crate::cli::render::save;
use crate::lessons::Lesson;
use camera_lab_files::FileError;
use camera_lab_files::hand_out::{package, read_page};
use camera_lab_words::learn::exercise_messages as said;
use camera_lab_words::{Lang, messages, told};

/// The page, the mark to pass, and the file to write.
#[derive(Debug, Args)]
pub(in crate::cli) struct PackedArgs {
    /// The page in one file, camera-lab.html, of this version
    #[arg(long, value_name = "PAGE.html")]
    page: PathBuf,
    /// Percentage of the questions, right at the first try, with which it's passed: 0 to 100
    #[arg(long, value_name = "PERCENT", default_value = "50", allow_hyphen_values = true)]
    pass: String,
    /// File to write: .zip
    #[arg(short, long, value_name = "OUT.zip")]
    pub(in crate::cli) output: PathBuf,
}

impl PackedArgs {
    /// Packs a lesson. `opened` is what the page opens: the identifier of a built-in lesson, or the text of another
    /// one.
    pub(in crate::cli) fn write(
        &self,
        lesson: &Lesson,
        opened: &str,
        (written, lang): (Lang, Lang),
    ) -> Result<(), Failure> {
        let course = (told(written, &lesson.title), written.tag(), self.pass(lang)?);
        let page = page_of(&self.page, lang)?;
        let packed = package(page, lesson, opened, course).map_err(|error| of_file(&self.output, &error, lang))?;
        save(&self.output, &packed, None, lang)
    }

    fn pass(&self, lang: Lang) -> Result<f64, Failure> {
        let pass = self.pass.trim().trim_end_matches('%').parse().ok().filter(|pass| (0.0..=100.0).contains(pass));
        pass.ok_or_else(|| Failure::BadInput(said::pass(lang, &self.pass)))
    }
}

/// The page in a file.
pub(in crate::cli) fn page_of(path: &Path, lang: Lang) -> Result<String, Failure> {
    read_page(path).map_err(|error| of_file(path, &error, lang))
}

/// The fault of a file.
pub(in crate::cli) fn of_file(path: &Path, error: &FileError, lang: Lang) -> Failure {
    Failure::BadInput(messages::file(lang, &messages::opened(lang, path), error))
}
