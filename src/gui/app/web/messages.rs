//! Messages between this page and the one around it. The script of the page checks them, and hands each over as three
//! texts. `docs/web.md` describes them.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use eframe::egui;
use serde_json::{Value, json};

use crate::camera::{Freedom, Operation};
use crate::export::format::PictureFormat;
use crate::figure::variation::varied_by;
use crate::gui::app::file_flow;
use crate::gui::app::web::{Page, WAKE, call, is_framed, read_link, reader, window};
use crate::gui::learn::exercises::state::Chosen;
use crate::lessons::{OpenLesson, numbers_of, shipped};
use crate::picture::{self, FileOptions, Metadata};
use crate::progress::{Progress, at_once};
use crate::views::{Size, View, Views};
use camera_lab_desk::{Document, Revision};
use camera_lab_files::share::{self, Held};
use camera_lab_files::{self as files, disk::page};
use camera_lab_words::{families, handout, messages as said};

/// The greatest side of an image in an answer, in pixels.
const MOST: u32 = 2048;

/// The state that the page around this one has heard of.
#[derive(Default)]
pub(super) struct Known {
    /// The figure, and the lesson with its step.
    shown: Option<(Revision, Option<(String, usize)>)>,
    /// The lesson is at its end.
    finished: bool,
    /// The questions that have been answered.
    tried: BTreeSet<(Chosen, String)>,
}

/// Does what a message asks for. The answer is a text: that of a figure, numbers as JSON, an image as an address.
/// Everything happens at once and without a question: the page around this one decides what it shows.
pub(super) fn asked(page: &mut Page, what: &str, one: String, two: &str) -> Result<String, String> {
    WAKE.with_borrow(|ctx| ctx.iter().for_each(egui::Context::request_repaint));
    let state = &mut page.app.state;
    let (model, learn) = (&mut state.model, &mut state.learn);
    let lang = model.settings.lang;
    match what {
        "open" => {
            let path = PathBuf::from("figure.toml");
            page::give(path.clone(), one.into_bytes());
            let (figure, file) = read_link(&path).map_err(|error| said::file(lang, "figure", &error))?;
            let document = Document::new(figure, Some(file)).map_err(|error| said::camera(lang, &error))?;
            learn.take_over(model, document);
        }
        "lesson" => {
            let (lesson, path) = match shipped().iter().find(|shipped| shipped.lesson.id == one) {
                Some(shipped) => (Arc::clone(&shipped.lesson), None),
                None => {
                    // A link carries the files of the lesson.
                    let path = PathBuf::from(share::fragment(Held::Lesson, &one));
                    let read = files::read_lesson(&path).map_err(|error| said::file(lang, "lesson", &error))?;
                    (Arc::new(read.0), Some(path))
                }
            };
            let step = step(two, lesson.steps.len())?;
            learn.play(model, OpenLesson { lesson, path, step });
        }
        "step" => {
            let count = learn.lesson.as_ref().map_or(0, |playing| playing.lesson.steps.len());
            learn.go_to_step(model, step(two, count)?);
        }
        "set" | "act" => {
            model.finish_motion();
            let (key, value) = if what == "set" { (&*one, two) } else { one.split_once('=').unwrap_or((&*one, "")) };
            let key = key.trim();
            if Operation::names().contains(&key) != (what == "act") {
                return Err(format!("{what}: {}", crate::sanitize::escaped(key)));
            }
            let convention = model.operations.convention;
            let varied = varied_by(model.desk.shown.figure(), model.desk.shown.camera(), &[(key, value)], convention)
                .map_err(|error| families::error(lang, &error))?;
            let moved = format!("{key}={value}").parse().ok().and_then(|operation| moved(&operation));
            match (moved, two.parse()) {
                (Some((freedom, amount)), Ok(seconds)) if what == "act" && seconds > 0.0 => {
                    model.begin_motion(freedom, amount);
                    model.motion.iter_mut().for_each(|motion| motion.seconds = seconds);
                }
                _ => model.desk.replace(varied.figure).map_err(|error| said::camera(lang, &error))?,
            }
        }
        "show" => {
            let views = Views::CHOICES.into_iter().find(|views| views.name() == one).ok_or("view")?;
            model.layout.shown = View::ALL.map(|view| views.contains(view));
            model.layout.maximized = None;
        }
        // Not of the page around this one, but of the script in it.
        "controls" => WAKE.with_borrow(|ctx| ctx.iter().for_each(egui::Context::enable_accesskit)),
        "click" | "focus" | "text" | "number" => reader::asked(what, &one, two).ok_or("control")?,
        "figure" => return Ok(file_flow::text_as_shown(model)),
        "numbers" => {
            let report = numbers_of(model.desk.shown.figure()).map_err(|error| said::inspect(lang, &error))?;
            return Ok(report.to_json());
        }
        "image" => {
            let figure = model.figure_as_shown();
            let [width, height] = [figure.image.width, figure.image.height].map(|side| side.min(MOST));
            let size = Size { width, height, scale: 1.0 };
            let made = handout::picture(&figure, model.scene_cache.scene(), Views::One(View::Image), size, lang);
            let made = made.map_err(|error| error.to_string())?;
            let options = FileOptions::of(PictureFormat::Png);
            let file = at_once(picture::file(&made, options, &Metadata::default(), &Progress::default()));
            let file = file.map_err(|error| error.to_string())?;
            return Ok(format!("data:image/png;base64,{}", STANDARD.encode(file.bytes)));
        }
        _ => return Err(what.to_owned()),
    }
    Ok(String::new())
}

/// A step from 0, of one from 1.
fn step(text: &str, count: usize) -> Result<usize, String> {
    let step = text.parse().ok().filter(|step| (1..=count).contains(step));
    step.map(|step: usize| step - 1).ok_or_else(|| format!("step: 1 … {count}"))
}

/// The one number that an operation moves, if it's one.
fn moved(operation: &Operation) -> Option<(Freedom, f64)> {
    let amount = match *operation {
        Operation::Elevation(by)
        | Operation::Azimuth(by)
        | Operation::Roll(by)
        | Operation::Yaw(by)
        | Operation::Pitch(by) => by.degrees(),
        Operation::Zoom(by) | Operation::Dolly(by) => by,
        Operation::Pan { .. } => return None,
    };
    Some((operation.freedom(), amount))
}

/// Tells the page around this one what has happened since the last frame.
pub(super) fn tell(page: &mut Page) {
    let (state, known) = (&mut page.app.state, &mut page.known);
    let answered = std::mem::take(&mut state.learn.exercises.answered);
    if !window().is_some_and(|window| is_framed(&window)) {
        return;
    }
    let say = |event: Value| drop(call("cameraLabTell", &event.to_string()));
    for (chosen, ask, right) in answered {
        let first = known.tried.insert((chosen.clone(), ask.clone()));
        let Chosen { id, seed } = chosen;
        say(json!({ "event": "answered", "question": id, "seed": seed, "ask": ask, "right": right, "first": first }));
    }
    let playing = state.learn.lesson.as_ref();
    let step = playing.map(|playing| (playing.lesson.id.clone(), playing.step));
    let shown = Some((state.model.desk.shown.version(), step));
    if known.shown != shown {
        let (id, step) = (playing.map(|playing| &playing.lesson.id), playing.map(|playing| playing.step + 1));
        let count = playing.map(|playing| playing.lesson.steps.len());
        say(json!({ "event": "changed", "lesson": id, "step": step, "count": count }));
        known.shown = shown;
    }
    let finished = playing.is_some_and(|playing| playing.is_last() && playing.may_go_on());
    if finished && !known.finished {
        say(json!({ "event": "finished", "lesson": playing.map(|playing| &playing.lesson.id) }));
    }
    known.finished = finished;
}
