//! `camera-lab matrix`: the camera of a matrix or a file from another program.

use std::fmt::Write as _;
use std::path::Path;

use serde::Serialize;

use super::{Failure, json_of, open, print, text_to_print};
use crate::camera::{
    Candidate, LeftOut, Order, Pasted, Recognised, Stated, Unknown, Used, camera_names, read_cameras, recognise,
};
use crate::cli::args::figure::size;
use crate::cli::args::matrix::MatrixArgs;
use crate::cli::args::words::{TableFormat, written};
use crate::inspect::CameraReport;
use camera_lab_files::{self as files, FileError};
use camera_lab_words::why::dialects;
use camera_lab_words::{Lang, messages};

/// The JSON output.
#[derive(Serialize)]
struct Answer {
    #[serde(rename = "as")]
    kind: &'static str,
    axes: &'static str,
    by_columns: bool,
    evidence: &'static str,
    others: Vec<&'static str>,
    camera: CameraReport,
    image: [u32; 2],
    unknown: Vec<Open>,
    readings: Vec<OneReading>,
    assumed: Vec<String>,
    used: Vec<UsedEntry>,
    left_out: Vec<LeftOutEntry>,
    /// The names of the cameras of the file, if there are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    cameras: Vec<String>,
}

/// A quantity that the matrix leaves open, or another notice.
#[derive(Serialize)]
struct Open {
    code: &'static str,
    message: &'static str,
}

/// An entry of the text that is in the camera.
#[derive(Serialize)]
struct UsedEntry {
    name: String,
    value: String,
    #[serde(rename = "as")]
    meaning: &'static str,
}

/// An entry of the text that isn't in the camera.
#[derive(Serialize)]
struct LeftOutEntry {
    name: String,
    value: String,
    reason: String,
    changes_image: Option<bool>,
}

/// A reading that fits, with its camera.
#[derive(Serialize)]
struct OneReading {
    kind: &'static str,
    order: &'static str,
    axes: &'static str,
    ndc: Option<String>,
    handedness: &'static str,
    certainty: &'static str,
    reasons: Vec<String>,
    camera: CameraReport,
}

pub(super) fn run(args: &MatrixArgs, lang: Lang) -> Result<(), Failure> {
    // clap asks for one of the two.
    let source = match &args.from {
        Some(path) => crate::sanitize::path(path).to_string(),
        None => "--numbers".to_owned(),
    };
    let refused = |why: String| Failure::BadInput(format!("{source}: {why}"));
    let bytes = match &args.from {
        Some(path) => {
            let name = crate::sanitize::path(path).to_string();
            read(path).map_err(|error| Failure::BadInput(messages::file(lang, &name, &error)))?
        }
        None => args.numbers.clone().unwrap_or_default().into_bytes(),
    };
    let cameras = read_cameras(&bytes).map_err(|fault| refused(dialects::unreadable(lang, &fault)))?;
    let names = camera_names(&cameras);
    let wanted = args.camera.as_deref();
    let all = wanted == Some(ALL);
    let chosen = chosen(&cameras, wanted)
        .ok_or_else(|| refused(dialects::no_such_camera(lang, wanted.unwrap_or_default(), &names)))?;
    let size = size(args.size.as_deref(), lang)?;
    let (opened, camera) = open(&args.figure, &args.common, lang)?;
    let mut figure = opened.figure.clone();
    let stated = Stated {
        kind: args.kind,
        axes: args.axes,
        by_columns: args.columns,
        ndc: args.ndc.map(Into::into),
        image: size.unwrap_or(figure.image),
    };
    let is_list = all && cameras.len() > 1;
    let lost = if is_list { figure.take_cameras(&cameras, &stated, size) } else { Vec::new() };
    let taken = cameras.iter().zip(&names).find(|(_, name)| !lost.iter().any(|(lost, _)| lost == *name));
    let chosen = taken.filter(|_| is_list).map_or(chosen, |(camera, _)| camera);
    let stated = Stated { image: size.or(chosen.image).unwrap_or(opened.figure.image), ..stated };
    let found = recognise(chosen, &stated, camera.parameters())
        .map_err(|error| refused(dialects::recovery_error(lang, &error)))?;
    let best = found.best();
    if !is_list {
        (figure.camera, figure.lens) = (best.found.parameters, None);
        if best.reading.kind.has_pixels() || chosen.image.is_some() {
            figure.image = best.reading.image;
        }
    }
    let written = written(args.common.lang);
    let text = match args.format {
        TableFormat::Json => json_of(&Answer::new(&found, chosen, &cameras, all, written))?,
        TableFormat::Text => {
            let mut head = comments(&found, chosen, if all { &[] } else { &names }, written);
            if is_list {
                let line = dialects::taken(written, cameras.len() - lost.len(), cameras.len());
                // Writing to a String can't fail.
                let _ = writeln!(head, "# {line}");
                for (name, error) in &lost {
                    let _ = writeln!(head, "# {}", dialects::not_taken(written, name, error.as_ref()));
                }
                for camera in cameras.iter().filter(|camera| camera.name != chosen.name) {
                    left_out(&mut head, camera, &format!("{}: ", camera.name), written);
                }
            }
            head + "\n" + &text_to_print((&args.figure, &opened), &figure, lang)?
        }
    };
    print(text.as_bytes(), lang)
}

/// Reads a file. For `images.txt` of COLMAP, adds the lenses of `cameras.txt` beside it.
fn read(path: &Path) -> Result<Vec<u8>, FileError> {
    let bytes = files::read_camera_file(path)?;
    if path.file_name().is_some_and(|name| name == "images.txt")
        && let Ok(mut lenses) = files::read_camera_file(&path.with_file_name("cameras.txt"))
    {
        lenses.push(b'\n');
        lenses.extend(bytes);
        return Ok(lenses);
    }
    Ok(bytes)
}

/// The word that asks for all cameras of a file.
const ALL: &str = "all";

/// The camera with a number from 1 or with a name.
fn chosen<'a>(cameras: &'a [Pasted], wanted: Option<&str>) -> Option<&'a Pasted> {
    let Some(wanted) = wanted.filter(|wanted| *wanted != ALL) else { return cameras.first() };
    let by_name = cameras.iter().find(|camera| camera.name == wanted);
    by_name.or_else(|| cameras.get(wanted.parse::<usize>().ok()?.checked_sub(1)?))
}

impl Answer {
    fn new(found: &Recognised, chosen: &Pasted, cameras: &[Pasted], all: bool, lang: Lang) -> Self {
        let best = found.best();
        let reading = best.reading;
        let is_shown = |camera: &&Pasted| all || std::ptr::eq(*camera, chosen);
        let used =
            |used: &Used| UsedEntry { name: used.name.clone(), value: used.value.clone(), meaning: used.meaning };
        let left = |left: &LeftOut| LeftOutEntry {
            name: left.name.clone(),
            value: left.value.clone(),
            reason: dialects::left_out(lang, left),
            changes_image: left.why.changes_image(),
        };
        let others = camera_names(cameras).into_iter().zip(cameras).filter(|(_, camera)| !is_shown(camera));
        let others = others.map(|(name, camera)| LeftOutEntry {
            name,
            value: camera.used.iter().map(|used| used.value.as_str()).collect::<Vec<_>>().join(" "),
            reason: dialects::texts(lang).other_camera.to_owned(),
            changes_image: Some(false),
        });
        let open = |unknown: &Unknown| Open { code: unknown.code(), message: dialects::unknown(lang, *unknown) };
        Self {
            kind: reading.kind.name(),
            axes: reading.axes.name,
            by_columns: best.order == Order::Columns,
            evidence: found.evidence.name(),
            others: found.others.iter().map(|kind| kind.name()).collect(),
            camera: CameraReport::new(&best.found.parameters),
            image: [reading.image.width, reading.image.height],
            unknown: best.found.unknown.iter().map(open).collect(),
            readings: found.readings.iter().map(|candidate| OneReading::new(candidate, lang)).collect(),
            assumed: found.assumed.iter().map(|assumed| dialects::assumed(lang, found, *assumed)).collect(),
            used: cameras.iter().filter(is_shown).flat_map(|camera| &camera.used).map(used).collect(),
            left_out: cameras
                .iter()
                .filter(is_shown)
                .flat_map(|camera| &camera.left_out)
                .map(left)
                .chain(others)
                .collect(),
            cameras: camera_names(cameras),
        }
    }
}

impl OneReading {
    fn new(candidate: &Candidate, lang: Lang) -> Self {
        let reading = candidate.reading;
        Self {
            kind: reading.kind.name(),
            order: candidate.order.name(),
            axes: reading.axes.name,
            ndc: reading.kind.has_ndc().then(|| reading.ndc.name()),
            handedness: if reading.is_left_handed() { "left" } else { "right" },
            certainty: candidate.certainty.name(),
            reasons: candidate.reasons.iter().map(|reason| dialects::reason(lang, *reason)).collect(),
            camera: CameraReport::new(&candidate.found.parameters),
        }
    }
}

/// The reading of the matrix and the values that it leaves open, as comments of a figure file.
fn comments(found: &Recognised, chosen: &Pasted, cameras: &[String], lang: Lang) -> String {
    let best = found.best();
    let mut text = String::new();
    left_out(&mut text, chosen, "", lang);
    // Writing to a String can't fail.
    let _ = writeln!(text, "# {}", dialects::reading(lang, best, found.evidence));
    for reason in &best.reasons {
        let _ = writeln!(text, "# - {}", dialects::reason(lang, *reason));
    }
    for assumed in &found.assumed {
        let _ = writeln!(text, "# {}", dialects::assumed(lang, found, *assumed));
    }
    for kind in &found.others {
        let _ = writeln!(text, "# --as {}: {}", kind.name(), dialects::kind(lang, *kind));
    }
    for unknown in &best.found.unknown {
        let _ = writeln!(text, "# {}", dialects::unknown(lang, *unknown));
    }
    if !cameras.is_empty() {
        let _ = writeln!(text, "# --camera: {}", crate::sanitize::escaped(&cameras.join(", ")));
    }
    text
}

/// The entries that the image could show, and that aren't in the camera, as comments.
fn left_out(text: &mut String, camera: &Pasted, before: &str, lang: Lang) {
    for left in camera.left_out.iter().filter(|left| left.why.changes_image() != Some(false)) {
        let (before, name) = (crate::sanitize::escaped(before), crate::sanitize::escaped(&left.name));
        // Writing to a String can't fail.
        let _ = writeln!(text, "# {before}{name}: {}", dialects::left_out(lang, left));
    }
}
