//! The arguments of `photograph`.

use std::path::PathBuf;

use clap::Args;
use glam::DVec2;

use super::words::TableFormat;
use crate::camera::{PhotographLine, PhotographMarks, WorldAxis};
use crate::cli::Failure;
use crate::cli::args::figure::FigureArgs;
use camera_lab_words::Lang;
use camera_lab_words::why::photograph as texts;

#[derive(Debug, Args)]
pub(in crate::cli) struct PhotographArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote. Its camera has what the photograph leaves open, such as
    /// F and B
    pub(in crate::cli) figure: PathBuf,
    #[command(flatten)]
    pub(in crate::cli) common: FigureArgs,
    /// Lines along an axis of the world, from smaller to larger coordinates, in pixels from the top left: `x: 120,300
    /// 900,260; 130,700 910,740`. At least two lines each of at least two axes
    #[arg(long, value_name = "AXIS: I,J I,J", required = true, allow_hyphen_values = true)]
    lines: Vec<String>,
    /// The pixel of the origin of the world: the direction to C
    #[arg(long, value_name = "I,J", allow_hyphen_values = true)]
    origin: Option<String>,
    /// The pixel of a point on an axis through the origin, and its coordinate, which is its distance from the origin:
    /// the distance of C. `x: 900,260 2.5`
    #[arg(long, value_name = "AXIS: I,J LENGTH", allow_hyphen_values = true, requires = "origin")]
    length: Option<String>,
    /// The pixel in which the axis of the camera goes through the photograph, for one that is cropped; without it, the
    /// middle
    #[arg(long, value_name = "I,J", allow_hyphen_values = true)]
    middle: Option<String>,
    /// The size of the photograph in pixels; without it, the figure's image size
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(in crate::cli) size: Option<String>,
    /// A figure file, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(in crate::cli) format: TableFormat,
}

impl PhotographArgs {
    /// The lines and points that were marked.
    pub(in crate::cli) fn marks(&self, lang: Lang) -> Result<PhotographMarks, Failure> {
        let refused = |text: &str, example| Failure::BadInput(texts::unreadable(lang, text, example));
        let mut lines = Vec::new();
        for text in &self.lines {
            lines.extend(
                lines_of(text).ok_or_else(|| refused(text, "--lines \"x: 120,300 900,260; 130,700 910,740\""))?,
            );
        }
        let point = |text: &Option<String>, example| {
            text.as_deref().map(|text| pixel(text).ok_or_else(|| refused(text, example))).transpose()
        };
        let (origin, middle) = (point(&self.origin, "--origin 512,600")?, point(&self.middle, "--middle 512,384")?);
        let length = self.length.as_deref();
        let length = length.map(|text| length_of(text).ok_or_else(|| refused(text, "--length \"x: 900,260 2.5\"")));
        Ok(PhotographMarks { lines, origin, length: length.transpose()?, middle })
    }
}

fn axis(text: &str) -> Option<WorldAxis> {
    WorldAxis::ALL.into_iter().find(|axis| axis.name() == text.trim().to_lowercase())
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite())
}

fn pixel(text: &str) -> Option<DVec2> {
    let (i, j) = text.split_once(',')?;
    Some(DVec2::new(number(i)?, number(j)?))
}

/// `x: i,j i,j; i,j i,j`
fn lines_of(text: &str) -> Option<Vec<PhotographLine>> {
    let (name, lines) = text.split_once(':')?;
    let axis = axis(name)?;
    let line = |text: &str| {
        let ends: Option<Vec<DVec2>> = text.split_whitespace().map(pixel).collect();
        Some(PhotographLine { axis, ends: <[DVec2; 2]>::try_from(ends?).ok()? })
    };
    lines.split(';').filter(|text| !text.trim().is_empty()).map(line).collect()
}

/// `x: i,j length`
fn length_of(text: &str) -> Option<(WorldAxis, DVec2, f64)> {
    let (name, rest) = text.split_once(':')?;
    let [at, length] = <[&str; 2]>::try_from(rest.split_whitespace().collect::<Vec<_>>()).ok()?;
    Some((axis(name)?, pixel(at)?, number(length).filter(|length| *length != 0.0)?))
}
