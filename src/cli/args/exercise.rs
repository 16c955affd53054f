//! The arguments of `camera-lab exercise`.

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::package::PackedArgs;
use super::words::{DataFormat, LangArg, TableFormat};
use crate::cli::Failure;
use crate::exercises::Free;
use crate::expression::{self, Dimension};
use camera_lab_words::handout::MAX_VERSIONS;
use camera_lab_words::learn::exercise_messages as said;
use camera_lab_words::{Lang, command_line as texts, messages};

#[derive(Debug, Args)]
pub(in crate::cli) struct ExerciseArgs {
    #[command(subcommand)]
    pub(in crate::cli) command: ExerciseCommand,
}

#[derive(Debug, Subcommand)]
pub(in crate::cli) enum ExerciseCommand {
    /// List the exercises: those of the notes, and families whose numbers come from a seed
    List(ListArgs),
    /// Print an exercise: statement, figure, questions
    Show(ShowArgs),
    /// Check answers, and report which known mistake explains a wrong one
    Check(CheckArgs),
    /// Write a sheet to hand out
    Sheet(SheetArgs),
    /// Pack exercises for a course platform, as a zip of SCORM 1.2
    Package(PackageArgs),
    /// Read the progress of students, and report what they solved and which mistakes how many of them made
    Report(ReportArgs),
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ListArgs {
    /// A table to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: TableFormat,
    /// A folder with files of your own, listed after the others
    #[arg(long, value_name = "DIR")]
    pub(in crate::cli) folder: Option<PathBuf>,
    /// Language of titles and messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(in crate::cli) lang: Option<LangArg>,
}

/// The source of the numbers of an exercise.
#[derive(Debug, Args)]
pub(in crate::cli) struct NumbersArgs {
    /// A whole number from 0. The same seed gives the same numbers. A sheet also takes a range, such as 1-30, and has a
    /// version for each seed then
    #[arg(long, value_name = "N", default_value = "0", allow_hyphen_values = true)]
    seed: String,
    /// A number that the exercise leaves open, such as F=3 or D=24
    #[arg(long = "with", value_name = "NAME=VALUE", allow_hyphen_values = true)]
    with: Vec<String>,
    /// The solution of a student with a mistake in it: which line is the first wrong one, and why. ID/fault does the
    /// same
    #[arg(long)]
    pub(in crate::cli) fault: bool,
    /// A folder with your own exercises
    #[arg(long, value_name = "DIR")]
    pub(in crate::cli) folder: Option<PathBuf>,
    /// Language of statements and messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(in crate::cli) lang: Option<LangArg>,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ShowArgs {
    /// Identifier of the exercise, from `camera-lab exercise list`
    pub(in crate::cli) id: String,
    #[command(flatten)]
    pub(in crate::cli) numbers: NumbersArgs,
    /// Include the answers and their solutions
    #[arg(long)]
    pub(in crate::cli) solution: bool,
    /// Text to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: TableFormat,
    /// File to write the image to match to, for an exercise that has one: .png
    #[arg(long, value_name = "OUT.png")]
    pub(in crate::cli) picture: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct CheckArgs {
    /// Identifier of the exercise, from `camera-lab exercise list`
    pub(in crate::cli) id: String,
    #[command(flatten)]
    pub(in crate::cli) numbers: NumbersArgs,
    /// An answer: a number or an expression (1/sqrt(3), 45°), [a, b, c], [[…], […]], a choice, or key=value; … of
    /// [camera]; ? for an unknown entry
    #[arg(long = "answer", value_name = "NAME=VALUE", allow_hyphen_values = true, required = true)]
    answers: Vec<String>,
    /// Number of hints in the text for a wrong answer, 0 to 9; JSON has all
    #[arg(long, value_name = "N", default_value = "1", allow_hyphen_values = true)]
    hints: String,
    /// Text to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: TableFormat,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct SheetArgs {
    /// Exercises of the sheet, in this order
    #[arg(long, value_name = "A,B,…", value_delimiter = ',', required = true)]
    pub(in crate::cli) ids: Vec<String>,
    #[command(flatten)]
    pub(in crate::cli) numbers: NumbersArgs,
    /// Include the answers and their solutions
    #[arg(long)]
    pub(in crate::cli) answers: bool,
    /// File to write the answers and their solutions to, in the order of the versions: .pdf, .md or .tex
    #[arg(long, value_name = "OUT2")]
    pub(in crate::cli) solutions: Option<PathBuf>,
    /// File to write: .pdf, .md or .tex; beside the last two go images to match, as OUT-1.png if the first exercise
    /// has one. With .xml, a bank of questions for Moodle, which marks the answers and names known mistakes
    #[arg(short, long, value_name = "OUT")]
    pub(in crate::cli) output: PathBuf,
}

#[derive(Debug, Args)]
pub(in crate::cli) struct PackageArgs {
    /// Exercises, in this order
    #[arg(long, value_name = "A,B,…", value_delimiter = ',', required = true)]
    pub(in crate::cli) ids: Vec<String>,
    /// A whole number from 0. The same seed gives the same numbers
    #[arg(long, value_name = "N", default_value = "0", allow_hyphen_values = true)]
    seed: String,
    /// Language of texts and messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(in crate::cli) lang: Option<LangArg>,
    #[command(flatten)]
    pub(in crate::cli) packed: PackedArgs,
}

impl PackageArgs {
    pub(in crate::cli) fn seed(&self, lang: Lang) -> Result<u64, Failure> {
        seed(&self.seed, lang)
    }
}

#[derive(Debug, Args)]
pub(in crate::cli) struct ReportArgs {
    /// Progress files (progress.toml) or the tables that the window exports, one for each student. A file without a
    /// student's name belongs to the student whom it's named after
    #[arg(required = true)]
    pub(in crate::cli) files: Vec<PathBuf>,
    /// Text to read, JSON for programs, or a table for spreadsheets
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: DataFormat,
    /// File to write a page to print to: .pdf. Without it, the report goes to standard output
    #[arg(short, long, value_name = "OUT.pdf")]
    pub(in crate::cli) output: Option<PathBuf>,
    /// Language of titles and messages
    #[arg(long, value_enum, ignore_case = true)]
    pub(in crate::cli) lang: Option<LangArg>,
}

fn seed(text: &str, lang: Lang) -> Result<u64, Failure> {
    text.trim().parse().map_err(|_| Failure::BadInput(texts::seed(lang, text)))
}

impl NumbersArgs {
    pub(in crate::cli) fn seed(&self, lang: Lang) -> Result<u64, Failure> {
        seed(&self.seed, lang)
    }

    /// The seeds of the versions of a sheet, and true if they're a range.
    pub(in crate::cli) fn seeds(&self, lang: Lang) -> Result<(RangeInclusive<u64>, bool), Failure> {
        let Some((first, last)) = self.seed.split_once(['-', '–']).filter(|(first, _)| !first.trim().is_empty())
        else {
            let bad = |_| Failure::BadInput(said::seeds(lang, &self.seed, MAX_VERSIONS));
            return self.seed.trim().parse().map(|seed| (seed..=seed, false)).map_err(bad);
        };
        let [first, last] = [first, last].map(|seed| seed.trim().parse::<u64>().ok());
        let range =
            first.zip(last).filter(|(first, last)| last.checked_sub(*first).is_some_and(|n| n < MAX_VERSIONS.into()));
        let (first, last) = range.ok_or_else(|| Failure::BadInput(said::seeds(lang, &self.seed, MAX_VERSIONS)))?;
        Ok((first..=last, true))
    }

    pub(in crate::cli) fn free(&self, lang: Lang) -> Result<Free, Failure> {
        let read = |text: &String| {
            let bad = |why: String| Failure::BadInput(said::with(lang, text, &why));
            let (name, value) = text.split_once('=').ok_or_else(|| bad(said::name_and_value(lang).to_owned()))?;
            let value = expression::evaluate(value, Dimension::Angle)
                .map_err(|error| bad(messages::expression(lang, &error.problem)))?;
            if value > 0.0 {
                // Statements write the letter, and its name is in the JSON.
                let name = if name.trim() == "θ" { "theta" } else { name.trim() };
                Ok((name.to_owned(), value))
            } else {
                Err(bad(said::greater_than_zero(lang).to_owned()))
            }
        };
        self.with.iter().map(read).collect()
    }
}

impl CheckArgs {
    pub(in crate::cli) fn hints(&self, lang: Lang) -> Result<usize, Failure> {
        let hints = self.hints.trim().parse().ok().filter(|hints| *hints <= 9);
        hints.ok_or_else(|| Failure::BadInput(said::hints_range(lang, &self.hints)))
    }

    /// Names and texts, in the order given.
    pub(in crate::cli) fn answers(&self, lang: Lang) -> Result<Vec<(&str, &str)>, Failure> {
        let read = |text: &'_ String| -> Result<(usize, usize), Failure> {
            let at = text.find('=').ok_or_else(|| Failure::BadInput(said::answer_form(lang, text)))?;
            Ok((at, at + 1))
        };
        self.answers.iter().map(|text| read(text).map(|(name, value)| (text[..name].trim(), &text[value..]))).collect()
    }
}
