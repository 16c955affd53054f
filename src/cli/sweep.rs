//! `camera-lab animate --vary` and `--to`: a family, or the way to another camera, one picture after the other.

use super::args::AnimateArgs;
use super::render::{no_picture, observer_of, open_other, save};
use super::sheet::members;
use super::{Failure, open, progress, scene, text_for_picture};
use crate::camera::{Camera, CameraPath, ImageSize};
use crate::cli::args::words::written;
use crate::figure::Figure;
use crate::figure::variation::Variant;
use crate::limits::MAX_FRAMES;
use crate::picture::{FilmFormat, Sweep};
use crate::progress::at_once;
use crate::sanitize;
use crate::views::{Request, SharedScene, Shot, Size, View, Views, with_observer};
use camera_lab_words::{Lang, command_line as texts, families, messages, pictures};

/// The number of pictures if none is given, for an animation and for a strip of stills.
const FRAMES: [usize; 2] = [40, 5];

pub(super) fn run(args: &AnimateArgs, format: FilmFormat, size: ImageSize, lang: Lang) -> Result<(), Failure> {
    let name = sanitize::path(&args.output);
    let views = args.view.unwrap_or(Views::One(View::Image));
    if matches!(format, FilmFormat::Strip(_)) && !matches!(views, Views::One(_)) {
        return Err(Failure::BadInput(format!("{name}: {}", texts::one_view_in_a_strip(lang))));
    }
    let seconds = args.seconds(lang)?;
    let frames = args.frames(lang)?.unwrap_or(FRAMES[usize::from(matches!(format, FilmFormat::Strip(_)))]);
    let variations = args.family.variations(Some(frames), lang)?;
    if variations.len() > 1 {
        return Err(Failure::BadInput(families::variations(lang, variations.len(), 1)));
    }
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let members = match &args.to {
        Some(other) => {
            let scene = SharedScene::new(scene(&args.figure, &opened, &args.common, lang)?);
            let figures = way(&opened.figure, &camera, &open_other(other, lang)?.1, frames);
            let figures =
                figures.map_err(|error| Failure::BadInput(format!("--to: {}", messages::camera(lang, &error))))?;
            figures.into_iter().map(|variant| (variant, scene.clone())).collect()
        }
        None => members(&args.figure, &opened, (&args.common, &camera), &variations, MAX_FRAMES, lang)?,
    };
    let labels = pictures::labels(written(args.common.lang));
    let ImageSize { width, height } = size;
    let size = Size { width, height, scale: 1.0 };
    let other = observer_of(args.observer_of.as_deref(), &args.common, lang)?;
    let series = |view: View| {
        let picture = |(variant, scene): &(Variant, SharedScene)| {
            Request::new(&Shot::of(&variant.figure), view, &variant.camera, scene, labels, size)
        };
        with_observer(members.iter().map(picture).collect(), other.as_ref())
    };
    let series: Vec<Vec<Request>> = views.views().map(series).collect();
    let frame = |k: usize| series.iter().filter_map(move |view| view.get(k).cloned());
    let requests = (0..members.len()).flat_map(frame).collect();
    let film = Sweep { requests, views: series.len(), seconds };
    let refused = |error| no_picture(lang, &name, error, [width, height].map(u64::from));
    let written = written(args.common.lang);
    let text = text_for_picture(&args.figure, &opened, &args.common, &args.output, lang);
    let told =
        pictures::told_of(written, &opened.figure, &film.stills().map_err(refused)?, text).for_file(&args.output);
    let made = progress::watched(lang, |progress| at_once(film.file(format, &told, progress)));
    let file = made.map_err(refused)?;
    save(&args.output, &file.bytes, file.beside, lang)
}

/// The figure with each camera on the way to another one. It begins and ends slowly.
fn way(figure: &Figure, from: &Camera, to: &Camera, frames: usize) -> Result<Vec<Variant>, crate::camera::CameraError> {
    let path = CameraPath::new(from, to)?;
    let last = frames.saturating_sub(1).max(1);
    let share = |k: usize| k as f64 / last as f64;
    let figure_at = |k: usize| {
        let t = share(k);
        let camera = path.at(t * t * (3.0 - 2.0 * t))?;
        let figure = Figure { camera: *camera.parameters(), ..figure.clone() };
        Ok(Variant { figure, camera, at: Vec::new() })
    };
    (0..frames).map(figure_at).collect()
}
