//! The arguments, and how their values are read.

pub(super) mod exercise;
pub(super) mod figure;
pub(super) mod lesson;
pub(super) mod matrix;
pub(super) mod output;
pub(super) mod package;
pub(super) mod photograph;
pub(super) mod sheet;
pub(super) mod words;

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use clap::{Args, CommandFactory as _, Parser, Subcommand, ValueEnum};
use glam::DVec3;

use super::Failure;
use crate::camera::{Decomposition, Ndc};
use crate::cli::args::exercise::ExerciseArgs;
use crate::cli::args::figure::{FigureArgs, number, option};
use crate::cli::args::lesson::LessonArgs;
use crate::cli::args::matrix::MatrixArgs;
use crate::cli::args::output::{OutputArgs, picture_endings};
use crate::cli::args::photograph::PhotographArgs;
use crate::cli::args::sheet::{FamilyArgs, SheetArgs};
use crate::cli::args::words::{DataFormat, Format, LangArg, TableFormat, one_of};
use crate::explain::code::CodeTarget;
use crate::export::format::PictureFormat;
use crate::expression::{self, Dimension};
use crate::limits::{MAX_FRAMES, MEASURED_SECONDS, STEP_SECONDS};
use crate::numerics::Study;
use crate::numerics::this_figure::WITHIN;
use crate::sanitize;
use crate::views::{View, Views};
use camera_lab_words::{Lang, command_line as texts, families};

/// An interactive laboratory for the virtual camera of computer graphics.
#[derive(Debug, Parser)]
#[command(
    name = "camera-lab",
    bin_name = "camera-lab",
    version,
    propagate_version = true,
    args_conflicts_with_subcommands = true
)]
pub(super) struct CommandLine {
    #[command(subcommand)]
    pub(super) command: Option<Command>,
    #[command(flatten)]
    pub(super) window: WindowArgs,
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Print every number of a figure's camera as JSON
    Inspect(InspectArgs),
    /// Write an image of a figure
    Render(RenderArgs),
    /// Write a sheet of small images: the same figure at several values of a key or an operation
    Sheet(SheetArgs),
    /// Report which stages of the pipeline an image needs, which are skipped, and why
    Explain(ExplainArgs),
    /// Redraw an image many times from scratch and report how long it takes
    Bench(BenchArgs),
    /// Measure error and run time of several ways to compute a camera's numbers
    Accuracy(AccuracyArgs),
    /// Report how close a camera is to numerical trouble, why an image is empty, and what would fix it
    Diagnose(DiagnoseArgs),
    /// Write an animation or a strip of stills of how the view volume becomes the canonical one, step by step; of a
    /// family; or of the way to another camera
    Animate(AnimateArgs),
    /// Print the camera as code for a library
    Code(CodeArgs),
    /// Give a figure the camera of a matrix from another program, and print it with what the matrix leaves open
    Matrix(MatrixArgs),
    /// Give a figure the camera of a photograph, from lines in it along the axes of the world
    Photograph(PhotographArgs),
    /// List and show exercises, check answers, write sheets
    Exercise(ExerciseArgs),
    /// List, show and check lessons, write their images, and play them in the window
    Lesson(LessonArgs),
    /// Write the manual pages, and completion scripts for bash, zsh, fish and PowerShell
    Manual(ManualArgs),
}

#[derive(Debug, Args)]
pub(super) struct ManualArgs {
    /// Folder to write them to. Created if missing
    #[arg(required_unless_present = "keys")]
    pub(super) folder: Option<PathBuf>,
    /// Print the keys of the window instead: as text, or with -o as a page of paper
    #[arg(long, conflicts_with = "folder")]
    pub(super) keys: bool,
    /// File for the page with the keys: .pdf
    #[arg(short, long, value_name = "OUT.pdf", requires = "keys")]
    pub(super) output: Option<PathBuf>,
    /// Language of messages
    #[arg(long, value_enum)]
    pub(super) lang: Option<LangArg>,
}

/// Without a command the window opens.
#[derive(Debug, Args)]
pub(super) struct WindowArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote; without it, the window shows the standard primitives
    pub(super) figure: Option<PathBuf>,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Address of the page of your course, https://…, which links, QR codes and handouts lead to. The window remembers it
    #[arg(long, value_name = "URL", value_parser = address)]
    pub(super) page_address: Option<String>,
}

/// An address of a page: of the web, or of a file.
fn address(text: &str) -> Result<String, String> {
    let is_one =
        ["https://", "http://", "file://"].iter().any(|scheme| text.len() > scheme.len() && text.starts_with(scheme));
    if is_one {
        Ok(text.split('#').next().unwrap_or_default().to_owned())
    } else {
        Err("allowed: https://…".to_owned())
    }
}

#[derive(Debug, Args)]
pub(super) struct InspectArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote
    pub(super) figure: PathBuf,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// A world point to follow through every space
    #[arg(long = "point", value_name = "X,Y,Z", allow_hyphen_values = true)]
    points: Vec<String>,
    /// Add the arithmetic of each point, step by step from the world to pixel and viewport
    #[arg(long, requires = "points")]
    pub(super) trace: bool,
    /// A pixel (column, row; 0,0 is the top left) to compute the ray of
    #[arg(long = "pixel", value_name = "I,J", allow_hyphen_values = true)]
    pixels: Vec<String>,
    /// A pixel with a depth Z of (5.25), to follow from its centre back to the world, step by step
    #[arg(long = "depth-pixel", value_name = "I,J,Z", allow_hyphen_values = true)]
    depth_pixels: Vec<String>,
    /// Convention of the normalised device coordinates: -reversed has near at 1 and far at 0 (for opengl too:
    /// glClipControl with zero to one), -infinite moves the back plane to infinity (in perspective). Vulkan's y points
    /// down. Pixels, window and viewport are the same in all
    #[arg(long, value_parser = one_of(Ndc::ALL, Ndc::name), value_name = "NAME", default_value = Ndc::default().name())]
    pub(super) ndc: Ndc,
    /// Add an interval that's proved to hold the exact number to each number, and how many times the questions
    /// themselves enlarge an error of the figure's numbers
    #[arg(long)]
    pub(super) bounds: bool,
    /// JSON for programs, or a list to read
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: Format,
}

#[derive(Debug, Args)]
pub(super) struct RenderArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote
    pub(super) figure: PathBuf,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Which view; `all` puts the three side by side, `world,image` two of them
    #[arg(long, value_parser = one_of(Views::CHOICES, Views::name), default_value = View::Image.name())]
    pub(super) view: Views,
    #[command(flatten)]
    pub(super) out: OutputArgs,
    /// Run every stage of the pipeline, needed or not. The image is the same
    #[arg(long)]
    pub(super) force_all_stages: bool,
}

#[derive(Debug, Args)]
pub(super) struct ExplainArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote
    pub(super) figure: PathBuf,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Which view
    #[arg(long, value_parser = one_of(View::ALL, View::name), default_value = View::Image.name())]
    pub(super) view: View,
    /// Width and height in pixels; without it, the figure's image size
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(super) size: Option<String>,
    /// Run every stage of the pipeline, needed or not. The image is the same
    #[arg(long)]
    pub(super) force_all_stages: bool,
    /// Add what each stage costs: operations on floating-point and on whole numbers, and accesses to memory, counted
    #[arg(long)]
    pub(super) cost: bool,
    /// Add the time that each stage left out would have cost this image, measured, and whether the bytes are the same
    #[arg(long, conflicts_with = "force_all_stages")]
    pub(super) saved: bool,
    /// A table to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TableFormat,
}

#[derive(Debug, Args)]
pub(super) struct BenchArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote
    pub(super) figure: PathBuf,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Which view; `all` draws the three, side by side in the given size
    #[arg(long, value_parser = one_of(Views::CHOICES, Views::name), default_value = View::Image.name())]
    pub(super) view: Views,
    /// Width and height in pixels; without it, the figure's image size
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(super) size: Option<String>,
    /// Number of frames to draw, 1 to 1000000
    #[arg(long, value_name = "N", default_value = "100", allow_hyphen_values = true)]
    frames: String,
    /// Run every stage of the pipeline, needed or not, to see what the plan saves
    #[arg(long)]
    pub(super) force_all_stages: bool,
    /// A line to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TableFormat,
}

#[derive(Debug, Args)]
pub(super) struct AccuracyArgs {
    /// Figure file to examine: error, time and memory of every choice that matters to it, against its exact image.
    /// Without it, the studies of random cameras
    pub(super) figure: Option<PathBuf>,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Size of the figure's image in pixels, by default that of the figure
    #[arg(long, value_name = "WxH", requires = "figure")]
    pub(super) size: Option<String>,
    /// The share of pixels, 0 to 1, by which a way may be worse than the best and still not be told from it
    #[arg(long, value_name = "SHARE", requires = "figure", default_value_t = WITHIN.to_string(), allow_hyphen_values = true)]
    within: String,
    /// PNG to write the exact image of the figure to
    #[arg(long, value_name = "OUT.png", requires = "figure")]
    pub(super) reference: Option<PathBuf>,
    /// Study to run, may be repeated; without it, all
    #[arg(long = "study", value_parser = one_of(Study::ALL, Study::name), value_name = "NAME", conflicts_with = "figure")]
    studies: Vec<Study>,
    /// Seconds to spend on measuring times, 0 to 3600, by default 20 over all studies, or 10 for a figure. Errors don't
    /// depend on it
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    seconds: Option<String>,
    /// A whole number. The same seed gives the same inputs, and so the same errors
    #[arg(long, value_name = "N", default_value = "1", allow_hyphen_values = true, conflicts_with = "figure")]
    seed: String,
    /// A table to read, JSON or CSV for programs
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: DataFormat,
    // The extensions are in `PictureFormat`.
    #[arg(long, value_name = "OUT", help = plot_help())]
    pub(super) plot: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(super) struct DiagnoseArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote
    pub(super) figure: PathBuf,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Sentences to read, or JSON for programs
    #[arg(long, value_enum, default_value_t)]
    pub(super) format: TableFormat,
    /// Write the figure, with its operations and the repair of the first finding applied, to the file of -o. Comments
    /// stay. Without a repair, report so and write the figure without one
    #[arg(long, requires = "output")]
    pub(super) repair: bool,
    /// The figure file to write
    #[arg(short, long, value_name = "OUT.toml", requires = "repair")]
    pub(super) output: Option<PathBuf>,
}

/// The arguments of `animate`.
#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("swept").args(["vary", "to"]).multiple(true)))]
pub(super) struct AnimateArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote
    pub(super) figure: PathBuf,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Source of the steps: `notes` [0] T, R, M_p, division; `box` [2] S T P; `scale` [1] M_xyscale M_pers;
    /// `normalised` [3] N_persp M_P, N_ort
    #[arg(long, value_parser = one_of(Decomposition::ALL, Decomposition::name), default_value = Decomposition::default().name())]
    pub(super) steps: Decomposition,
    #[command(flatten)]
    pub(super) family: FamilyArgs,
    /// Show the way to the camera of another figure instead of the steps, on arcs about the points that stay
    #[arg(long, value_name = "FIGURE", conflicts_with_all = ["vary", "steps"])]
    pub(super) to: Option<PathBuf>,
    /// Number of images of a range FROM..TO, or of the way of --to; without it, 40 in an animation and 5 in a strip
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    frames: Option<String>,
    /// The view that --vary and --to show, or several side by side in an animation; without it, the image
    #[arg(long, value_parser = one_of(Views::CHOICES, Views::name))]
    pub(super) view: Option<Views>,
    /// Figure file whose observers see the views of --vary and --to, as they see its own views; without it, one
    /// observer sees all of them
    #[arg(long, value_name = "FIGURE", requires = "swept")]
    pub(super) observer_of: Option<PathBuf>,
    /// Width and height of each image in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(super) size: Option<String>,
    /// Duration of a step in an animation, and of all of --vary or --to, in seconds, 0.1 to 60
    #[arg(long, value_name = "S", default_value = "2", allow_hyphen_values = true)]
    seconds: String,
    /// File to write. Its extension decides: .gif, .apng (animations), .png, .webp, .jpg (a strip of stills)
    #[arg(short, long, value_name = "OUT")]
    pub(super) output: PathBuf,
}

#[derive(Debug, Args)]
pub(super) struct CodeArgs {
    /// Figure file, or a PNG, SVG or PDF that camera-lab wrote
    pub(super) figure: PathBuf,
    #[command(flatten)]
    pub(super) common: FigureArgs,
    /// Library or language
    #[arg(long = "for", value_parser = one_of(CodeTarget::ALL, CodeTarget::word), value_name = "NAME")]
    pub(super) target: CodeTarget,
}

/// The language that the arguments ask for, even if they are wrong otherwise.
pub(super) fn written_lang(args: &[OsString]) -> Option<Lang> {
    let texts = || args.iter().skip(1).map(|arg| arg.to_str().unwrap_or_default());
    let after = texts().zip(texts().skip(1)).find(|(name, _)| *name == "--lang").map(|(_, value)| value);
    let value = after.or_else(|| texts().find_map(|arg| arg.strip_prefix("--lang=")))?;
    LangArg::from_str(value, true).ok().map(LangArg::lang)
}

/// The names of the commands.
pub(super) fn commands() -> Vec<String> {
    CommandLine::command().get_subcommands().map(|command| command.get_name().to_owned()).collect()
}

/// The first argument if it seems to be meant as a command but isn't one. (It may be a figure file too.)
pub(super) fn unknown_command(args: &[OsString]) -> Option<String> {
    let first = args.get(1)?.to_str()?;
    let plain = first.starts_with(|c: char| c.is_ascii_alphabetic()) && !first.contains(['.', '/', '\\']);
    let known = first == "help" || commands().iter().any(|command| command == first);
    (plain && !known && args.len() > 2 && !Path::new(first).exists()).then(|| first.to_owned())
}

impl InspectArgs {
    pub(super) fn points(&self, lang: Lang) -> Result<Vec<DVec3>, Failure> {
        let read = |text: &String| {
            let parts: Vec<&str> = expression::parts(text).collect();
            let [x, y, z] = parts[..] else { return Err(Failure::BadInput(texts::point(lang, text, None))) };
            let number = |part| {
                expression::evaluate(part, Dimension::Number)
                    .map_err(|error| Failure::BadInput(texts::point(lang, text, Some((part, &error)))))
            };
            Ok(DVec3::new(number(x)?, number(y)?, number(z)?))
        };
        self.points.iter().map(read).collect()
    }

    pub(super) fn pixels(&self, lang: Lang) -> Result<Vec<[i64; 2]>, Failure> {
        let read = |text: &String| {
            let numbers: Option<Vec<i64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
            match numbers.as_deref() {
                Some([i, j]) => Ok([*i, *j]),
                _ => Err(Failure::BadInput(texts::pixel(lang, text))),
            }
        };
        self.pixels.iter().map(read).collect()
    }

    /// Pixels with a depth: (i, j) and Z.
    pub(super) fn depth_pixels(&self, lang: Lang) -> Result<Vec<([i64; 2], f64)>, Failure> {
        let read = |text: &String| {
            let parts: Vec<&str> = expression::parts(text).map(str::trim).collect();
            let fault = || Failure::BadInput(texts::depth_pixel(lang, text));
            let [i, j, z] = parts[..] else { return Err(fault()) };
            let pixel = [i.parse().map_err(|_| fault())?, j.parse().map_err(|_| fault())?];
            Ok((pixel, expression::evaluate(z, Dimension::Number).map_err(|_| fault())?))
        };
        self.depth_pixels.iter().map(read).collect()
    }
}

impl BenchArgs {
    pub(super) fn frames(&self, lang: Lang) -> Result<usize, Failure> {
        let frames = self.frames.trim().parse().ok().filter(|frames| (1..=1_000_000).contains(frames));
        frames.ok_or_else(|| Failure::BadInput(texts::frames(lang, &self.frames)))
    }
}

impl AnimateArgs {
    pub(super) fn seconds(&self, lang: Lang) -> Result<f64, Failure> {
        number("--seconds", &self.seconds, (&STEP_SECONDS, 2.0), lang)
    }

    /// The number of images, if it's given.
    pub(super) fn frames(&self, lang: Lang) -> Result<Option<usize>, Failure> {
        let Some(text) = &self.frames else { return Ok(None) };
        let frames = text.trim().parse().ok().filter(|frames| (2..=MAX_FRAMES).contains(frames));
        frames.map(Some).ok_or_else(|| Failure::BadInput(families::frames(lang, text)))
    }
}

impl AccuracyArgs {
    /// The requested studies, in their order, each once.
    pub(super) fn studies(&self) -> Vec<Study> {
        let wanted = |study: &Study| self.studies.is_empty() || self.studies.contains(study);
        Study::ALL.into_iter().filter(wanted).collect()
    }

    /// The seconds for timing, by default these.
    pub(super) fn seconds(&self, usual: f64, lang: Lang) -> Result<f64, Failure> {
        Ok(option("--seconds", &self.seconds, (&MEASURED_SECONDS, 20.0), lang)?.unwrap_or(usual))
    }

    pub(super) fn within(&self, lang: Lang) -> Result<f64, Failure> {
        number("--within", &self.within, (&(0.0..=1.0), WITHIN), lang)
    }

    pub(super) fn seed(&self, lang: Lang) -> Result<u64, Failure> {
        self.seed.trim().parse().map_err(|_| Failure::BadInput(texts::seed(lang, &self.seed)))
    }

    /// The file of the plot, and its format.
    pub(super) fn plot(&self, lang: Lang) -> Result<Option<(&Path, PictureFormat)>, Failure> {
        let Some(path) = &self.plot else { return Ok(None) };
        let format = PictureFormat::of(path)
            .ok_or_else(|| Failure::BadInput(texts::plot_ending(lang, &sanitize::path(path))))?;
        Ok(Some((path, format)))
    }
}

fn plot_help() -> String {
    format!(
        "File to write charts to, of error against parameter and time; its extension decides the format: {}",
        picture_endings()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_consistent() {
        CommandLine::command().debug_assert();
    }

    #[test]
    fn the_language_is_found_in_any_arguments() {
        let lang = |args: &[&str]| written_lang(&args.iter().map(OsString::from).collect::<Vec<_>>());
        assert_eq!(lang(&["camera-lab", "render", "--bad", "--lang", "pt-BR"]), Some(Lang::PtBr));
        assert_eq!(lang(&["camera-lab", "--lang=EN"]), Some(Lang::En));
        assert_eq!(lang(&["camera-lab", "--lang"]), None);
        assert_eq!(lang(&["camera-lab", "inspect", "--lang", "fr"]), None);
    }
}
