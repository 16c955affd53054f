//! The arguments of the commands that write pictures: size, paper, look, and the file.

use std::path::PathBuf;

use clap::Args;

use super::words::{one_of, word_of};
use crate::appearance::Theme;
use crate::cli::Failure;
use crate::cli::args::figure::option;
use crate::export::format::PictureFormat;
use crate::export::paper::PaperPreset;
use crate::export::vector::Letters;
use crate::figure::words::THEMES;
use crate::limits::{PAPER_CM, PAPER_DPI, PAPER_LETTERS, PAPER_LINES, SCALE};
use crate::picture::{ExportSpec, Faces, FileOptions, OnPaper, PER_INCH, SheetSize};
use crate::sanitize;
use crate::views::Views;
use camera_lab_words::{Lang, command_line as texts};

#[derive(Debug, Args)]
pub(in crate::cli) struct OutputArgs {
    /// Width and height in pixels; without it, the figure's image size (for several views: of each)
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(in crate::cli) size: Option<String>,
    /// Multiplies width, height, strokes and letters, 0.1 to 16. Without it and --letters, strokes and letters of an
    /// image larger than 1920x1080 grow with it, by the smaller of width/1920 and height/1080
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    scale: Option<String>,
    /// Width in centimetres on paper, in place of --size; without --height-cm, the height follows from the figure's
    /// image
    #[arg(long, value_name = "CM", allow_hyphen_values = true, conflicts_with_all = ["size", "scale"])]
    width_cm: Option<String>,
    /// Height in centimetres on paper; `all` then arranges the three views to be as large as the paper allows
    #[arg(long, value_name = "CM", allow_hyphen_values = true, requires = "width_cm")]
    height_cm: Option<String>,
    /// Width, height and letters for a column of a journal (8.8 cm, 8 pt), the text of a page of A4 (16 cm, 9 pt), a
    /// slide of 16 by 9 (18 pt) or a square
    #[arg(long, value_parser = one_of(PaperPreset::ALL, PaperPreset::name), conflicts_with_all = ["size", "scale", "width_cm", "height_cm"])]
    paper: Option<PaperPreset>,
    /// Pixels per inch on paper, 300 by default. Written into a PNG or JPEG if it or --width-cm is
    /// given
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    dpi: Option<String>,
    /// Height of the letters of names in points on paper, 9 if --width-cm is given. Strokes are in proportion. A
    /// sheet of all three leaves names out if an image has no room for them
    #[arg(long, value_name = "PT", allow_hyphen_values = true, conflicts_with = "scale")]
    letters: Option<String>,
    /// Width of the edges of solids in points on paper, other strokes in proportion; without it, in proportion to the
    /// letters
    #[arg(long, value_name = "PT", allow_hyphen_values = true)]
    lines: Option<String>,
    /// Transparent background. Not for JPEG, which has no transparency
    #[arg(long)]
    pub(in crate::cli) transparent: bool,
    /// Crop the empty background around each image
    #[arg(long)]
    crop: bool,
    /// Faces of an SVG or PDF: as areas (`vector`), as one image under the lines (`picture`), or as areas if they
    /// show the same as the pixels
    #[arg(long, value_parser = one_of(Faces::ALL, Faces::name), default_value = Faces::default().name())]
    faces: Faces,
    /// Letters of an SVG or PDF as outlines. No program needs the font, and none can search or edit them
    #[arg(long)]
    outlines: bool,
    /// Figure file whose observers see the world and the canonical volume. In a series of images the observer then
    /// stays, so every difference is a change of the figure
    #[arg(long, value_name = "FIGURE")]
    pub(in crate::cli) observer_of: Option<PathBuf>,
    /// Theme; without it, that of the figure
    #[arg(long, value_parser = word_of(THEMES))]
    pub(in crate::cli) theme: Option<Theme>,
    // The extensions are in `PictureFormat`.
    #[arg(short, long, value_name = "OUT", help = output_help())]
    pub(in crate::cli) output: PathBuf,
}

impl OutputArgs {
    /// The factor of width, height, strokes and letters, if it's given.
    pub(in crate::cli) fn scale(&self, lang: Lang) -> Result<Option<f32>, Failure> {
        #[expect(clippy::cast_possible_truncation, reason = "0.1 to 16")]
        let narrow = |scale: f64| scale as f32;
        Ok(option("--scale", &self.scale, (&SCALE, 2.0), lang)?.map(narrow))
    }
}

/// Default of pixels per inch: that of office printers.
const DPI: f64 = 300.0;
/// Height of the letters of names on paper in points, if it isn't given.
const LETTERS: f64 = 9.0;

impl OutputArgs {
    /// Width and height in centimetres, if they are given.
    pub(in crate::cli) fn centimetres(&self, lang: Lang) -> Result<[Option<f64>; 2], Failure> {
        let side = |name, text| option(name, text, (&PAPER_CM, 8.0), lang);
        if let Some((width, height)) = self.paper.map(PaperPreset::size) {
            return Ok([Some(width), height]);
        }
        Ok([side("--width-cm", &self.width_cm)?, side("--height-cm", &self.height_cm)?])
    }

    /// The arguments in units of paper. `None` if there are none.
    pub(in crate::cli) fn on_paper(&self, lang: Lang) -> Result<Option<OnPaper>, Failure> {
        let letters = option("--letters", &self.letters, (&PAPER_LETTERS, 9.0), lang)?;
        let lines = option("--lines", &self.lines, (&PAPER_LINES, 0.6), lang)?;
        let [width, height] = self.centimetres(lang)?;
        let dpi = option("--dpi", &self.dpi, (&PAPER_DPI, DPI), lang)?;
        let any = [letters, lines, width, dpi].iter().any(Option::is_some);
        // A size in pixels is in CSS pixels if no pixels per inch are printed.
        let is_vector = PictureFormat::of(&self.output).is_some_and(PictureFormat::is_vector);
        let usual = if is_vector && width.is_none() { PER_INCH } else { DPI };
        let letters = letters.or(self.paper.map(PaperPreset::letters)).or(width.map(|_| LETTERS));
        let paper = OnPaper { dpi: dpi.unwrap_or(usual), letters, lines, arranged: height.is_some() };
        for (name, side) in [("--width-cm", width), ("--height-cm", height)] {
            if let Some(side) = side.filter(|side| paper.pixels_across(*side) < 0.5) {
                return Err(Failure::BadInput(texts::no_pixel(lang, [name, &side.to_string()], paper.dpi)));
            }
        }
        Ok(any.then_some(paper))
    }

    /// How the letters of vectors are written.
    fn outlines(&self) -> Letters {
        if self.outlines { Letters::Outlines } else { Letters::Text }
    }

    /// The format of the file.
    pub(in crate::cli) fn format(&self, lang: Lang) -> Result<PictureFormat, Failure> {
        let format = PictureFormat::of(&self.output)
            .ok_or_else(|| Failure::BadInput(texts::ending(lang, &sanitize::path(&self.output))))?;
        if self.transparent && !format.has_transparency() {
            return Err(Failure::BadInput(texts::no_transparency(lang, format)));
        }
        Ok(format)
    }

    /// The requested file: these views, of this size.
    pub(in crate::cli) fn spec(
        &self,
        (views, size): (Views, SheetSize),
        (format, scale): (PictureFormat, Option<f32>),
        paper: Option<OnPaper>,
    ) -> ExportSpec {
        // Letters and lines in points have a resolution, too, by which vectors are measured.
        let dpi = paper.filter(|_| self.is_for_paper() || format.is_vector()).map(|paper| paper.dpi);
        let options = FileOptions { format, crop: self.crop, dpi, faces: self.faces, letters: self.outlines() };
        let keeps_width = self.width_cm.is_some() || self.paper.is_some();
        ExportSpec { views, size, scale, transparent: self.transparent, paper, keeps_width, options }
    }

    /// True if the number of pixels per inch is more than a guess, because it or a size on paper is given.
    fn is_for_paper(&self) -> bool {
        self.dpi.is_some() || self.width_cm.is_some() || self.paper.is_some()
    }
}

fn output_help() -> String {
    format!("File to write; its extension decides the format: {}", picture_endings())
}

/// The extensions of image files.
pub(in crate::cli) fn picture_endings() -> String {
    let endings = PictureFormat::ALL.iter().flat_map(|format| format.endings());
    endings.map(|ending| format!(".{ending}")).collect::<Vec<_>>().join(", ")
}
