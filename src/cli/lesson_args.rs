//! The arguments of `camera-lab lesson`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use super::Failure;
use super::figure_args::size;
use super::words::{LangArg, TableFormat, one_of};
use crate::camera::ImageSize;
use crate::export::format::PictureFormat;
use crate::i18n::{Lang, lessons as texts};
use crate::views::Views;

#[derive(Debug, Args)]
pub(super) struct LessonArgs {
    #[command(subcommand)]
    pub(super) command: LessonCommand,
}

#[derive(Debug, Subcommand)]
pub(super) enum LessonCommand {
    /// List the lessons of the program, and those of a folder
    List(ListArgs),
    /// Print a lesson: its steps, each with its text and its whole figure
    Show(ShowArgs),
    /// Check lesson files: every figure, number, question and goal; reports faults by line and key
    Check(CheckArgs),
    /// Write the numbered pictures of a lesson's steps into a folder, or a handout as PDF
    Render(LessonRenderArgs),
    /// Open the window with a lesson
    Play(PlayArgs),
}

#[derive(Debug, Args)]
pub(super) struct ListArgs {
    /// A table to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TableFormat,
    /// A folder with your own lessons, listed after the others
    #[arg(long, value_name = "DIR")]
    pub(super) folder: Option<PathBuf>,
    /// Language of titles and messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(super) lang: Option<LangArg>,
}

/// Which lesson.
#[derive(Debug, Args)]
pub(super) struct WhichArgs {
    /// Identifier of a lesson, from `camera-lab lesson list`, or a lesson file
    pub(super) id: String,
    /// Language of texts and messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(super) lang: Option<LangArg>,
    /// Let the steps name meshes anywhere, and not only in the folder of the lesson and below
    #[arg(long)]
    pub(super) allow_files: bool,
}

#[derive(Debug, Args)]
pub(super) struct ShowArgs {
    #[command(flatten)]
    pub(super) which: WhichArgs,
    /// Text to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TableFormat,
}

#[derive(Debug, Args)]
pub(super) struct CheckArgs {
    /// Lesson files
    #[arg(required = true, value_name = "FILE")]
    pub(super) files: Vec<PathBuf>,
    /// Let the steps name meshes anywhere, and not only in the folder of the lesson and below
    #[arg(long)]
    pub(super) allow_files: bool,
    /// Language of messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(super) lang: Option<LangArg>,
}

/// The format of the pictures of steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum StepFormat {
    #[default]
    Png,
    Svg,
    Pdf,
}

impl StepFormat {
    pub(super) const fn format(self) -> PictureFormat {
        match self {
            Self::Png => PictureFormat::Png,
            Self::Svg => PictureFormat::Svg,
            Self::Pdf => PictureFormat::Pdf,
        }
    }

    pub(super) const fn ending(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Svg => "svg",
            Self::Pdf => "pdf",
        }
    }
}

#[derive(Debug, Args)]
pub(super) struct LessonRenderArgs {
    #[command(flatten)]
    pub(super) which: WhichArgs,
    /// Which pictures; without it, those that the step shows on the screen
    #[arg(long, value_parser = one_of(Views::CHOICES, Views::name))]
    pub(super) view: Option<Views>,
    /// Width and height of each picture file in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    size: Option<String>,
    /// Format of the pictures; PNG if not given
    #[arg(long, value_enum)]
    pub(super) format: Option<StepFormat>,
    /// Steps on a page of a handout: 2 (if not given) or 4
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    per_page: Option<String>,
    /// Put the solutions of the questions at the end of a handout
    #[arg(long)]
    pub(super) answers: bool,
    /// Folder for the pictures, created if missing; or OUT.pdf for a handout with figure, text and questions of each
    /// step
    #[arg(short, long, value_name = "FOLDER|OUT.pdf")]
    pub(super) output: PathBuf,
}

impl LessonRenderArgs {
    /// The number of steps on a page of a handout.
    pub(super) fn per_page(&self, lang: Lang) -> Result<usize, Failure> {
        let Some(per_page) = &self.per_page else { return Ok(2) };
        let number = per_page.trim().parse().ok().filter(|number| [2, 4].contains(number));
        number.ok_or_else(|| Failure::BadInput(texts::per_page(lang, per_page)))
    }

    /// A given option that says nothing of a handout, or of a folder of pictures.
    pub(super) fn unused(&self, is_handout: bool) -> Option<&'static str> {
        let of_pictures =
            [("--size", self.size.is_some()), ("--view", self.view.is_some()), ("--format", self.format.is_some())];
        let of_handouts = [("--per-page", self.per_page.is_some()), ("--answers", self.answers)];
        let unused: &[(&'static str, bool)] = if is_handout { &of_pictures } else { &of_handouts };
        unused.iter().find(|(_, is_given)| *is_given).map(|(option, _)| *option)
    }

    /// Width and height of each file, if they are given.
    pub(super) fn size(&self, lang: Lang) -> Result<Option<ImageSize>, Failure> {
        size(self.size.as_deref(), lang)
    }
}

#[derive(Debug, Args)]
pub(super) struct PlayArgs {
    #[command(flatten)]
    pub(super) which: WhichArgs,
    /// Number of the step to begin with, from 1
    #[arg(long, value_name = "N", default_value = "1", allow_hyphen_values = true)]
    step: String,
}

impl PlayArgs {
    /// The step, from 0, of a lesson with `count` steps.
    pub(super) fn step(&self, count: usize, lang: Lang) -> Result<usize, Failure> {
        let step = self.step.trim().parse().ok().filter(|step| (1..=count).contains(step));
        step.map(|step: usize| step - 1).ok_or_else(|| Failure::BadInput(texts::no_step(lang, &self.step, count)))
    }
}
