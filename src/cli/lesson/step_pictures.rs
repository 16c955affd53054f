//! The scenes and pictures of the steps of a lesson.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::camera::ImageSize;
use crate::cli::args::lesson::LessonRenderArgs;
use crate::cli::args::words::written;
use crate::cli::render::no_picture;
use crate::cli::{Failure, say};
use crate::figure::Figure;
use crate::lessons::{Lesson, Step};
use crate::picture::{Composite, gap};
use crate::progress::Progress;
use crate::sanitize;
use crate::scene::Scene;
use crate::views::{Size, Views, scene_of};
use camera_lab_files::FigureFiles;
use camera_lab_words::handout::{NoPicture, Scenes, picture, views_of};
use camera_lab_words::learn::lessons as texts;
use camera_lab_words::{Lang, messages};

/// The size of a picture of a step if none is given, or of each of several.
const SIZE: ImageSize = ImageSize { width: 640, height: 480 };

/// A lesson and its origin.
pub(in crate::cli) struct Found {
    pub(in crate::cli) lesson: Arc<Lesson>,
    /// `None` means one of the program.
    pub(in crate::cli) path: Option<PathBuf>,
}

/// Reads the files that the figures of a lesson name.
pub(in crate::cli) fn files_of(path: Option<&Path>, allow_files: bool) -> FigureFiles {
    FigureFiles::of_lesson(path, allow_files)
}

/// The scene of a step, whose meshes and textures are in the folder of the lesson or below, and the reasons why files
/// are missing without which it can be drawn.
pub(in crate::cli) fn scene(
    figure: &Figure,
    path: Option<&PathBuf>,
    allow_files: bool,
    lang: Lang,
) -> Result<(Scene, Vec<String>), String> {
    let mut files = files_of(path.map(PathBuf::as_path), allow_files);
    let scene = scene_of(figure, &mut |wanted| files.read(wanted), &Progress::default())
        .map_err(|error| messages::scene(lang, &error))?;
    let missing = files.unread().iter().map(|unread| messages::without_file(lang, unread));
    let notices = scene
        .notices
        .iter()
        .map(|(object, notice)| format!("{}: {}", sanitize::escaped(object), messages::mesh_notice(lang, notice)));
    let missing = missing.chain(notices).collect();
    Ok((scene, missing))
}

/// The pictures of a step on a sheet.
pub(in crate::cli) fn composite(
    args: &LessonRenderArgs,
    (found, scenes): (&Found, &mut Scenes),
    (k, step): (usize, &Step),
    size: Size,
    lang: Lang,
) -> Result<Composite, Failure> {
    let written = written(args.which.lang);
    let of_step = |why: &str| {
        let name = found.path.as_ref().map_or_else(|| found.lesson.id.clone(), |path| messages::opened(lang, path));
        format!("{name}: {}", texts::of_step(lang, k + 1, why))
    };
    let failed = |why: String| Failure::BadInput(of_step(&why));
    let build = || {
        let (scene, missing) = scene(&step.figure, found.path.as_ref(), args.which.allow_files, lang)?;
        missing.iter().for_each(|why| say(&of_step(why)));
        Ok(scene)
    };
    let scene = scenes.of(&step.figure, build).map_err(failed)?;
    let views = args.view.unwrap_or_else(|| views_of(&step.figure));
    picture(&step.figure, &scene, views, size, written).map_err(|error| match error {
        NoPicture::Camera(error) => failed(messages::camera(lang, &error)),
        NoPicture::Composite(error) => {
            no_picture(lang, &sanitize::path(&args.output), error.into(), [size.width, size.height].map(u64::from))
        }
    })
}

/// The size of a file: as given, or for that many pictures.
pub(in crate::cli) fn size_of(given: Option<ImageSize>, views: Views) -> Size {
    let count = u32::try_from(views.views().count()).unwrap_or(1);
    let ImageSize { width, height } =
        given.unwrap_or(ImageSize { width: SIZE.width * count + gap(1.0) * (count - 1), height: SIZE.height });
    Size::as_on_a_screen(width, height)
}
