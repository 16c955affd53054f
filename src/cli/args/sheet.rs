//! The arguments of `sheet`, and of every command that shows a family.

use std::path::PathBuf;

use clap::Args;

use super::words::one_of;
use crate::cli::Failure;
use crate::cli::args::figure::FigureArgs;
use crate::cli::args::output::OutputArgs;
use crate::figure::variation::Variation;
use crate::limits::MAX_FAMILY;
use crate::sanitize::escaped;
use crate::views::{View, Views};
use camera_lab_words::{Lang, families};

#[derive(Debug, Args)]
pub(in crate::cli) struct SheetArgs {
    /// Figure file, or an image that camera-lab wrote
    pub(in crate::cli) figure: PathBuf,
    #[command(flatten)]
    pub(in crate::cli) common: FigureArgs,
    #[command(flatten)]
    pub(in crate::cli) family: FamilyArgs,
    /// Which view. Several are below one another, a row for each
    #[arg(long, value_parser = one_of(Views::CHOICES, Views::name), default_value = View::Image.name())]
    pub(in crate::cli) view: Views,
    /// Number of images in a row; without it, as many as have room, at most 4, or with two --vary the values of the
    /// second
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    columns: Option<String>,
    /// Put letters before the captions: (a), (b) …
    #[arg(long)]
    pub(in crate::cli) parts: bool,
    /// Caption of an image in place of its value, the first one for the first image. An empty one leaves it out
    #[arg(long = "caption", value_name = "TEXT", allow_hyphen_values = true)]
    pub(in crate::cli) captions: Vec<String>,
    #[command(flatten)]
    pub(in crate::cli) out: OutputArgs,
}

/// The keys and operations that vary.
#[derive(Debug, Args)]
pub(in crate::cli) struct FamilyArgs {
    /// Key of the figure or operation with its values, one image for each: `camera.view_angle=20,40,60,90`;
    /// `style.visibility=painter,depth-buffer`; `show.step.at=0..4:5` (five numbers from 0 to 4); azimuth=0,30,60.
    /// Commas between brackets belong to a value. Given twice, the values of the first are rows and those of the
    /// second columns
    #[arg(long, value_name = "KEY=V1,V2,…", allow_hyphen_values = true)]
    pub(in crate::cli) vary: Vec<String>,
}

impl FamilyArgs {
    /// The variations. `frames` is the number of values of a range without one.
    pub(in crate::cli) fn variations(&self, frames: Option<usize>, lang: Lang) -> Result<Vec<Variation>, Failure> {
        let read = |text: &String| {
            Variation::parse(text, frames).map_err(|error| {
                Failure::BadInput(format!("--vary {}: {}", escaped(text), families::error(lang, &error)))
            })
        };
        self.vary.iter().map(read).collect()
    }
}

impl SheetArgs {
    /// The number of columns, if it's given.
    pub(in crate::cli) fn columns(&self, lang: Lang) -> Result<Option<usize>, Failure> {
        let Some(text) = &self.columns else { return Ok(None) };
        let columns = text.trim().parse().ok().filter(|columns| (1..=MAX_FAMILY).contains(columns));
        columns.map(Some).ok_or_else(|| Failure::BadInput(families::columns(lang, text)))
    }
}
