//! The arguments of every command that takes a figure, and how sizes and numbers are read.

use std::ops::RangeInclusive;

use clap::Args;

use super::words::{LangArg, word_of};
use crate::camera::{Amount, Convention, Framing, ImageSize, OPERATIONS, Operation};
use crate::cli::Failure;
use crate::figure::words::Words;
use crate::figure::{Show, show_with};
use crate::limits::MAX_SIDE;
use crate::sanitize::escaped;
use camera_lab_words::{Lang, command_line as texts, messages};

const CONVENTIONS: Words<Convention> = &[("right-hand", Convention::RightHand), ("vtk", Convention::Vtk)];

#[derive(Debug, Args)]
pub(in crate::cli) struct FigureArgs {
    // The words are in `OPERATIONS`.
    #[arg(long = "op", value_name = "NAME=VALUE", allow_hyphen_values = true, help = operations_help())]
    operations: Vec<String>,
    /// Explanation to show in the views, as a key of `[show]` of a figure file with a TOML value: `stage="clip"`,
    /// `step={way="notes",at=2.5}`, `measure=["F","theta"]`; an empty value removes it
    #[arg(long = "show", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    show: Vec<String>,
    /// Signs of the rotations: right-hand rule, or as in VTK (elevation and roll the other way)
    #[arg(long, value_parser = word_of(CONVENTIONS), default_value = CONVENTIONS[0].0)]
    pub(in crate::cli) convention: Convention,
    /// Let the figure name any file of this machine. Without it, files named by a mesh (materials, buffers) must lie in
    /// the mesh's folder or below, and those named by a figure inside an image in the image's. Nothing comes from
    /// another machine
    #[arg(long)]
    pub(in crate::cli) allow_files: bool,
    /// Language of the window, of messages, and of words in images
    #[arg(long, value_enum, ignore_case = true)]
    pub(in crate::cli) lang: Option<LangArg>,
}

/// A change of the camera by `--op`.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::cli) enum CameraStep {
    Operation(Operation),
    /// By the object with this name, or by all of them for `all`.
    Framing(Framing, String),
}

impl FigureArgs {
    /// True if they change nothing of the figure, and allow nothing.
    pub(in crate::cli) fn is_plain(&self) -> bool {
        self.operations.is_empty() && self.show.is_empty() && !self.allow_files
    }

    pub(in crate::cli) fn steps(&self, lang: Lang) -> Result<Vec<CameraStep>, Failure> {
        let read = |text: &String| {
            let framing = text.split_once('=').and_then(|(name, object)| {
                let framing = Framing::ALL.into_iter().find(|framing| framing.name() == name.trim())?;
                Some(CameraStep::Framing(framing, object.trim().to_owned()))
            });
            if let Some(framing) = framing {
                return Ok(framing);
            }
            text.parse()
                .map(CameraStep::Operation)
                .map_err(|e| Failure::BadInput(format!("--op {}: {}", escaped(text), messages::operation(lang, &e))))
        };
        self.operations.iter().map(read).collect()
    }

    /// The `[show]` section, with the keys that the arguments set.
    pub(in crate::cli) fn shown(&self, show: Show, lang: Lang) -> Result<Show, Failure> {
        self.show.iter().try_fold(show, |show, text| {
            let refused = |why: &str| Failure::BadInput(format!("--show {}: {why}", escaped(text)));
            let (key, value) = text.split_once('=').ok_or_else(|| refused(texts::show_without_value(lang)))?;
            show_with(&show, key.trim(), value).map_err(|error| refused(&messages::without_line(lang, &error)))
        })
    }
}

/// Width and height, if they are given.
pub(in crate::cli) fn size(text: Option<&str>, lang: Lang) -> Result<Option<ImageSize>, Failure> {
    let Some(text) = text else { return Ok(None) };
    let side = |text: &str| text.trim().parse().ok().filter(|side| (1..=MAX_SIDE).contains(side));
    text.split_once(['x', 'X', '×'])
        .and_then(|(width, height)| Some(Some(ImageSize { width: side(width)?, height: side(height)? })))
        .ok_or_else(|| Failure::BadInput(texts::size(lang, text)))
}

/// The number of an option if it's given, with the range that it takes and an example.
pub(in crate::cli) fn option(
    name: &str,
    text: &Option<String>,
    range: (&RangeInclusive<f64>, f64),
    lang: Lang,
) -> Result<Option<f64>, Failure> {
    text.as_ref().map(|text| number(name, text, range, lang)).transpose()
}

pub(in crate::cli) fn number(
    option: &str,
    text: &str,
    (range, example): (&RangeInclusive<f64>, f64),
    lang: Lang,
) -> Result<f64, Failure> {
    let number = text.trim().parse().ok().filter(|number| range.contains(number));
    number.ok_or_else(|| Failure::BadInput(texts::number(lang, option, text, range, example)))
}

fn operations_help() -> String {
    let words = |amount: Amount, unit: &str| {
        let mut words: Vec<_> = OPERATIONS.iter().filter(|row| row.amount == amount).map(|row| row.word).collect();
        words.dedup();
        format!("{} ({unit})", words.join(", "))
    };
    let [turns, factors, lengths] = [(Amount::Angle, "degrees"), (Amount::Factor, "factor"), (Amount::Length, "DX,DY")]
        .map(|(a, unit)| words(a, unit));
    format!(
        "An operation on the camera, in the order given: {turns}, {factors}, {lengths}; aim=OBJECT moves PF to the middle \
         of an object, fit=OBJECT and fit=all show it or all objects whole"
    )
}
