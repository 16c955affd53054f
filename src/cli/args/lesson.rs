//! The arguments of `camera-lab lesson`.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::exercise::ListArgs;
use super::package::PackedArgs;
use super::words::{LangArg, TableFormat, one_of, word_of};
use crate::cli::Failure;
use crate::export::format::PictureFormat;
use crate::figure::words::Words;
use crate::views::Views;
use camera_lab_words::Lang;
use camera_lab_words::learn::lessons as texts;

#[derive(Debug, Args)]
pub(in crate::cli) struct LessonArgs {
    #[command(subcommand)]
    pub(in crate::cli) command: LessonCommand,
}

#[derive(Debug, Subcommand)]
pub(in crate::cli) enum LessonCommand {
    /// List the lessons of the program, and those of a folder
    List(ListArgs),
    /// Print a lesson: its steps, each with its text and its whole figure
    Show(ShowArgs),
    /// Check lesson files: every figure, number, question and goal, and the aims, the plan and the sentence to keep;
    /// reports faults by line and key
    Check(CheckArgs),
    /// Write the numbered images of a lesson's steps into a folder, or a handout as PDF
    Render(LessonRenderArgs),
    /// Open the window with a lesson
    Play(PlayArgs),
    /// Pack a lesson for a course platform, as a zip of SCORM 1.2
    Package(PackageArgs),
    /// Write the page in one file that opens with a lesson, for your students
    Page(PageArgs),
}

/// Which lesson.
#[derive(Debug, Args)]
pub(in crate::cli) struct WhichArgs {
    /// Identifier of a lesson, from `camera-lab lesson list`, or a lesson file
    pub(in crate::cli) id: String,
    /// Language of texts and messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(in crate::cli) lang: Option<LangArg>,
    /// Let the steps name meshes anywhere, and not only in the folder of the lesson and below
    #[arg(long)]
    pub(in crate::cli) allow_files: bool,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ShowArgs {
    #[command(flatten)]
    pub(in crate::cli) which: WhichArgs,
    /// Text to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: TableFormat,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct CheckArgs {
    /// Lesson files
    #[arg(required = true, value_name = "FILE")]
    pub(in crate::cli) files: Vec<PathBuf>,
    /// Let the steps name meshes anywhere, and not only in the folder of the lesson and below
    #[arg(long)]
    pub(in crate::cli) allow_files: bool,
    /// Language of messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(in crate::cli) lang: Option<LangArg>,
}

/// The formats of the images of steps.
const STEP_FORMATS: Words<PictureFormat> =
    &[("png", PictureFormat::Png), ("svg", PictureFormat::Svg), ("pdf", PictureFormat::Pdf)];

#[derive(Debug, Args)]
pub(in crate::cli) struct LessonRenderArgs {
    #[command(flatten)]
    pub(in crate::cli) which: WhichArgs,
    /// Which views; without it, those that the step shows on the screen
    #[arg(long, value_parser = one_of(Views::CHOICES, Views::name))]
    pub(in crate::cli) view: Option<Views>,
    /// Width and height of each image file in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(in crate::cli) size: Option<String>,
    /// Format of the images; PNG if not given
    #[arg(long, value_parser = word_of(STEP_FORMATS))]
    pub(in crate::cli) format: Option<PictureFormat>,
    /// Steps on a page of a handout: 2 (if not given) or 4
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    per_page: Option<String>,
    /// Put the solutions of the questions at the end of a handout
    #[arg(long)]
    pub(in crate::cli) answers: bool,
    /// Begin a handout with the plan for its lecturer
    #[arg(long)]
    pub(in crate::cli) plan: bool,
    /// Folder for the images, created if missing, or OUT.pdf for a handout with figure, text and questions of each
    /// step
    #[arg(short, long, value_name = "FOLDER|OUT.pdf")]
    pub(in crate::cli) output: PathBuf,
}

impl LessonRenderArgs {
    /// The number of steps on a page of a handout.
    pub(in crate::cli) fn per_page(&self, lang: Lang) -> Result<usize, Failure> {
        let Some(per_page) = &self.per_page else { return Ok(2) };
        let number = per_page.trim().parse().ok().filter(|number| [2, 4].contains(number));
        number.ok_or_else(|| Failure::BadInput(texts::per_page(lang, per_page)))
    }

    /// A given option that has no meaning for a handout, or for a folder of images.
    pub(in crate::cli) fn unused(&self, is_handout: bool) -> Option<&'static str> {
        let of_pictures =
            [("--size", self.size.is_some()), ("--view", self.view.is_some()), ("--format", self.format.is_some())];
        let of_handouts = [("--per-page", self.per_page.is_some()), ("--answers", self.answers), ("--plan", self.plan)];
        let unused: &[(&'static str, bool)] = if is_handout { &of_pictures } else { &of_handouts };
        unused.iter().find(|(_, is_given)| *is_given).map(|(option, _)| *option)
    }
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PackageArgs {
    #[command(flatten)]
    pub(in crate::cli) which: WhichArgs,
    #[command(flatten)]
    pub(in crate::cli) packed: PackedArgs,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PageArgs {
    #[command(flatten)]
    pub(in crate::cli) which: WhichArgs,
    /// The page in one file, camera-lab.html, of this version
    #[arg(long, value_name = "PAGE.html")]
    pub(in crate::cli) page: PathBuf,
    /// File to write: .html
    #[arg(short, long, value_name = "OUT.html")]
    pub(in crate::cli) output: PathBuf,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PlayArgs {
    #[command(flatten)]
    pub(in crate::cli) which: WhichArgs,
    /// Number of the step to begin with, from 1
    #[arg(long, value_name = "N", default_value = "1", allow_hyphen_values = true)]
    step: String,
}

impl PlayArgs {
    /// The step, from 0, of a lesson with `count` steps.
    pub(in crate::cli) fn step(&self, count: usize, lang: Lang) -> Result<usize, Failure> {
        let step = self.step.trim().parse().ok().filter(|step| (1..=count).contains(step));
        step.map(|step: usize| step - 1).ok_or_else(|| Failure::BadInput(texts::no_step(lang, &self.step, count)))
    }
}
