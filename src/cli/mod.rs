//! The command line: one file per subcommand, and their shared parts.
//!
//! The exit status is 0 for success, 1 if the work couldn't be completed, and 2 for bad input. Errors go to standard
//! error, one paragraph, in the language of `--lang` or of the system. Standard output and pictures never depend on the
//! system.

mod accuracy;
mod accuracy_of_figure;
mod animate;
mod args;
mod argument_errors;
mod bench;
mod code;
mod diagnose;
mod exercise;
mod explain;
mod inspect;
mod lesson;
mod manual;
mod matrix;
mod opening;
mod photograph;
mod progress;
mod render;
mod sheet;
mod sweep;

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use args::figure::{CameraStep, FigureArgs};
use args::words::written;
use args::{Command, CommandLine};
use clap::Parser;
use serde::Serialize;

use crate::camera::{Camera, Convention, ImageSize};
use crate::figure::read::{self, line_of_object};
use crate::figure::{Figure, update};
use crate::inspect::{InspectError, camera_after, for_terminals};
use crate::lessons::OpenLesson;
use crate::progress::Progress;
use crate::sanitize;
use crate::scene::{Object, Scene};
use crate::views::{Request, SharedScene, Size, View, scene_of};
use camera_lab_files::{self as files, FigureFiles, FileAccess, FileError, LeftOut, Opened, SourceFile, share};
use camera_lab_words::{Lang, command_line as texts, messages, pictures};

/// The reason why a command ends early.
#[derive(Debug)]
enum Failure {
    /// Unusable arguments or files: status 2.
    BadInput(String),
    /// The work couldn't be completed: status 1.
    Failed(String),
    /// An answer is wrong, as already reported: status 1.
    NotRight,
    /// The reader of the output is gone, so the program ends quietly.
    ClosedPipe,
}

/// The task of the arguments.
#[derive(Debug)]
pub enum Asked {
    /// A finished action, or one that failed.
    Done(ExitCode),
    /// The window.
    Window(Box<Opening>),
    /// The keys of the window, on standard output or as a page of paper in a file.
    Keys {
        /// Their language.
        lang: Lang,
        /// The file.
        output: Option<PathBuf>,
    },
    /// The window, with a figure that can't be opened: the exit status and the message. Without a console, the user
    /// can't see a line on standard error.
    NoWindow {
        /// The exit status.
        status: u8,
        /// Why.
        message: String,
    },
}

/// The initial state of the window.
#[derive(Debug)]
pub struct Opening {
    /// The figure. Its camera is possible.
    pub figure: Figure,
    /// Its file. `None` for a new figure.
    pub file: Option<SourceFile>,
    /// The user allows the figure to name any file.
    pub allow_files: bool,
    /// The language of messages, and of the window if it remembers none.
    pub lang: Lang,
    /// The language that the arguments ask for.
    pub asked_lang: Option<Lang>,
    /// The lesson to play, the step to begin with (from 0), and the lesson's file.
    pub lesson: Option<OpenLesson>,
    /// A file that answers too late for the start. The window opens it once it's there.
    pub later: Option<PathBuf>,
    /// The address of the page of a course, for links.
    pub page_address: Option<String>,
}

/// Runs the program with the arguments of a process (the program's name first), up to the window.
pub fn run(args: impl IntoIterator<Item = OsString>) -> Asked {
    let args: Vec<OsString> = args.into_iter().collect();
    let lang = args::written_lang(&args).unwrap_or_else(system_lang);
    let result = match CommandLine::try_parse_from(&args) {
        Ok(line) => match line.command {
            Some(Command::Inspect(args)) => inspect::run(&args, lang),
            Some(Command::Render(args)) => render::run(&args, lang),
            Some(Command::Sheet(args)) => sheet::run(&args, lang),
            Some(Command::Explain(args)) => explain::run(&args, lang),
            Some(Command::Bench(args)) => bench::run(&args, lang),
            Some(Command::Accuracy(args)) => accuracy::run(&args, lang),
            Some(Command::Animate(args)) => animate::run(&args, lang),
            Some(Command::Code(args)) => code::run(&args, lang),
            Some(Command::Matrix(args)) => matrix::run(&args, lang),
            Some(Command::Photograph(args)) => photograph::run(&args, lang),
            Some(Command::Diagnose(args)) => diagnose::run(&args, lang),
            Some(Command::Exercise(args)) => exercise::run(&args, lang),
            Some(Command::Manual(args)) => match manual::run(&args, lang) {
                Ok(Some(keys)) => return keys,
                other => other.map(|_| ()),
            },
            Some(Command::Lesson(args)) => match lesson::run(&args, lang) {
                Ok(Some(opening)) => return Asked::Window(opening),
                other => other.map(|_| ()),
            },
            None => match opening::opening(&line.window, lang) {
                Ok(opening) => {
                    let page_address = line.window.page_address;
                    return Asked::Window(Box::new(Opening { page_address, ..opening }));
                }
                Err(Failure::BadInput(message)) => return Asked::NoWindow { status: 2, message },
                Err(Failure::Failed(message)) => return Asked::NoWindow { status: 1, message },
                Err(failure) => Err(failure),
            },
        },
        Err(error) if error.use_stderr() => Err(Failure::BadInput(match args::unknown_command(&args) {
            Some(name) => texts::unknown_command(lang, &name, &args::commands()),
            None => argument_errors::in_words(lang, &error),
        })),
        Err(help) => print(help.render().to_string().as_bytes(), lang),
    };
    Asked::Done(match result {
        Ok(()) | Err(Failure::ClosedPipe) => ExitCode::SUCCESS,
        Err(Failure::NotRight) => ExitCode::from(1),
        Err(Failure::Failed(message)) => fail(1, &message),
        Err(Failure::BadInput(message)) => fail(2, &message),
    })
}

/// Writes what another part of the program has made to a file, or to standard output.
pub fn deliver(bytes: &[u8], output: Option<&Path>, lang: Lang) -> ExitCode {
    let done = output.map_or_else(|| print(bytes, lang), |path| render::save(path, bytes, None, lang));
    match done {
        Ok(()) | Err(Failure::ClosedPipe | Failure::NotRight) => ExitCode::SUCCESS,
        Err(Failure::Failed(message)) => fail(1, &message),
        Err(Failure::BadInput(message)) => fail(2, &message),
    }
}

/// Writes to standard error why the program ends, and returns its exit status.
pub fn fail(status: u8, message: &str) -> ExitCode {
    say(message);
    ExitCode::from(status)
}

/// Writes a line to standard error. If even that is closed, the status has to do.
fn say(message: &str) {
    let _ = writeln!(io::stderr(), "camera-lab: {}", sanitize::printable(message));
}

/// The language of the system, if it's one of ours.
fn system_lang() -> Lang {
    sys_locale::get_locale().map_or(Lang::En, |locale| Lang::of_locale(&locale))
}

/// Writes to standard output.
fn print(bytes: &[u8], lang: Lang) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::Failed(messages::file(lang, texts::standard_output(lang), &FileError::Write(error))),
    })
}

/// The output for other programs.
fn json_of(answer: &impl Serialize) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(answer).map_err(|error| Failure::Failed(error.to_string()))?;
    Ok(for_terminals(&text) + "\n")
}

/// The nearest known name to an unknown one.
fn nearest<'a>(names: impl Iterator<Item = &'a str>, unknown: &str) -> Option<&'a str> {
    let likenesses = names.map(|name| (strsim::jaro_winkler(name, unknown), name));
    likenesses.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(likeness, _)| *likeness > 0.7).map(|(_, name)| name)
}

/// Opens the figure of the arguments and applies their operations. The figure has the parameters of the returned
/// camera, which knows more digits of them.
fn open(path: &Path, args: &FigureArgs, lang: Lang) -> Result<(Opened, Camera), Failure> {
    let name = messages::opened(lang, path);
    // Faults of the arguments are reported first because they don't depend on the file.
    let steps = args.steps(lang)?;
    let mut opened =
        files::open_figure(path).map_err(|error| Failure::BadInput(messages::file(lang, &name, &error)))?;
    opened.figure.show = args.shown(std::mem::take(&mut opened.figure.show), lang)?;
    let files = files_of(path, &opened, args);
    let camera = operate(&mut opened.figure, &steps, args.convention, files, lang)
        .map_err(|error| Failure::BadInput(format!("{name}: {error}")))?;
    Ok((opened, camera))
}

/// Reads the files that a figure names.
fn files_of(path: &Path, opened: &Opened, args: &FigureArgs) -> FigureFiles {
    let reach = FileAccess::of(path, opened.from_picture, args.allow_files);
    FigureFiles::new(path.parent().unwrap_or(Path::new("")), reach).with(&opened.carried)
}

/// The text of a figure for a picture, with the files of the figure. If they have no room, a message says so.
fn text_for_picture(path: &Path, opened: &Opened, args: &FigureArgs, output: &Path, lang: Lang) -> String {
    let text = |figure: &Figure| update(&opened.text, figure);
    let (text, left_out) = files::text_in_picture(text, &opened.figure, files_of(path, opened, args), output);
    say_left_out(left_out, output, lang);
    text
}

/// Says which files a picture doesn't carry.
fn say_left_out(left_out: Option<LeftOut>, output: &Path, lang: Lang) {
    if let Some(left_out) = left_out {
        say(&format!("{}: {}", sanitize::path(output), messages::left_out(lang, &left_out)));
    }
}

/// The text of a figure for a figure file in the folder `to`, made from that of `opened` at `path`. Its files are the
/// same from there.
///
/// # Errors
/// It's impossible, for example a camera or a comparison, so no command could open the file.
fn text_for_file(
    (path, opened): (&Path, &Opened),
    figure: &Figure,
    to: Option<&Path>,
    lang: Lang,
) -> Result<String, Failure> {
    // The folder of a link is none.
    let from = path.parent().filter(|_| share::link_of(path).is_none());
    let text = update(&opened.text, &files::for_figure_file(figure, from, to).0);
    read::parse_known(&text).map_err(|error| {
        let name = messages::opened(lang, path);
        Failure::BadInput(format!("{name}: {}", messages::without_line(lang, &error)))
    })?;
    Ok(text)
}

/// As [`text_for_file`], for standard output, which the user most likely sends into a file of this folder.
fn text_to_print(from: (&Path, &Opened), figure: &Figure, lang: Lang) -> Result<String, Failure> {
    let text = text_for_file(from, figure, Some(Path::new("")), lang)?;
    if !from.1.carried.is_empty() {
        let own = files::own_files(figure).into_keys().map(str::to_owned).collect();
        say(&messages::not_printed(lang, &LeftOut(own)));
    }
    Ok(text)
}

/// The scene of a figure. Looks for its meshes beside the figure file. Lists on standard error the missing files
/// without which the figure can still be drawn.
fn scene(path: &Path, opened: &Opened, args: &FigureArgs, lang: Lang) -> Result<Scene, Failure> {
    let mut files = files_of(path, opened, args);
    let read = |progress: &Progress| scene_of(&opened.figure, &mut |wanted| files.read(wanted), progress);
    let scene = progress::watched(lang, read).map_err(|error| {
        let line = error.object().and_then(|name| line_of_object(&opened.text, name, error.key()));
        Failure::BadInput(texts::in_file(lang, &messages::opened(lang, path), line, &messages::scene(lang, &error)))
    })?;
    if let Some(missing) = missing_triangle(&opened.figure, &scene, lang) {
        return Err(Failure::BadInput(format!("{}: {missing}", sanitize::path(path))));
    }
    for unread in files.unread() {
        say(&messages::without_file(lang, unread));
    }
    for (object, notice) in &scene.notices {
        say(&format!("{}: {}", sanitize::escaped(object), messages::mesh_notice(lang, notice)));
    }
    Ok(scene)
}

/// The reason why the triangle that a figure shows isn't in its scene. `None` if it is, or if the figure shows none.
fn missing_triangle(figure: &Figure, scene: &Scene, lang: Lang) -> Option<String> {
    let triangle = figure.show.triangle.as_ref()?;
    let Some(object) = scene.place_of(&triangle.object).map(|place| &scene.objects[place]) else {
        let names: Vec<&str> = scene.objects.iter().map(|object| object.name.as_str()).collect();
        return Some(texts::no_such_object(lang, "[show] triangle.object", &triangle.object, &names));
    };
    let count = object.mesh.triangles.len();
    (triangle.index as usize >= count).then(|| texts::no_such_triangle(lang, &triangle.object, triangle.index, count))
}

/// The input of `explain`, `bench` and `diagnose`.
struct OpenFigure {
    opened: Opened,
    camera: Camera,
    scene: SharedScene,
    size: Size,
    /// The output doesn't depend on the system's language.
    lang: Lang,
}

impl OpenFigure {
    fn open(path: &Path, args: &FigureArgs, size: Option<ImageSize>, lang: Lang) -> Result<Self, Failure> {
        let (opened, camera) = open(path, args, lang)?;
        let scene = SharedScene::new(scene(path, &opened, args, lang)?);
        let ImageSize { width, height } = size.unwrap_or(opened.figure.image);
        let size = Size { width, height, scale: 1.0 };
        Ok(Self { opened, camera, scene, size, lang: written(args.lang) })
    }

    /// A picture of it.
    fn request(&self, view: View, force_all_stages: bool) -> Request {
        let labels = pictures::labels(self.lang);
        let request = Request::of(&self.opened.figure, view, &self.camera, &self.scene, labels, self.size);
        Request { force_all_stages, ..request }
    }

    /// The reason why there is no picture of this size.
    fn too_large(&self) -> Failure {
        let [width, height] = self.pixels();
        Failure::BadInput(texts::too_large(self.lang, width, height))
    }

    /// Width and height of a picture.
    fn pixels(&self) -> [u64; 2] {
        [self.size.width, self.size.height].map(u64::from)
    }
}

/// Applies the steps of `--op` to the camera of a figure. `files` are those that it names.
fn operate(
    figure: &mut Figure,
    steps: &[CameraStep],
    convention: Convention,
    mut files: FigureFiles,
    lang: Lang,
) -> Result<Camera, String> {
    let failed = |error: InspectError| messages::inspect(lang, &error);
    let mut camera = camera_after(&figure.camera, &[], convention).map_err(failed)?;
    let mut built: Option<Scene> = None;
    for step in steps {
        camera = match step {
            CameraStep::Operation(operation) => operation
                .apply(&camera, convention)
                .map_err(|error| failed(InspectError::Operation { operation: *operation, error }))?,
            CameraStep::Framing(framing, object) => {
                let mut read = || scene_of(figure, &mut |wanted| files.read(wanted), &Progress::default());
                let scene = match built.take() {
                    Some(scene) => scene,
                    None => read().map_err(|error| messages::scene(lang, &error))?,
                };
                let one = Some(object.clone()).filter(|object| object != "all");
                let extent = scene.extent_of(&figure.scene, &one.into_iter().collect()).ok_or_else(|| {
                    let names: Vec<&str> = scene.objects.iter().map(Object::owner).collect();
                    texts::no_such_object(lang, &format!("--op {}", framing.name()), object, &names)
                })?;
                built = Some(scene);
                framing.of(&camera, &extent).map_err(|error| messages::camera(lang, &error))?
            }
        };
    }
    figure.camera = *camera.parameters();
    Ok(camera)
}
