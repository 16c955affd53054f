//! `camera-lab diagnose`: how near a camera is to trouble with numbers, and why a picture is empty.

use std::fmt::Write as _;
use std::path::Path;

use serde::ser::SerializeMap as _;
use serde::{Serialize, Serializer};

use super::args::DiagnoseArgs;
use super::render::save;
use super::{Failure, OpenFigure, files_of, json_of, print, progress, say, scene, text_for_file};
use crate::camera::{Camera, CameraError};
use crate::cli::args::words::{TableFormat, written};
use crate::figure::Figure;
use crate::numerics::diagnosis::{
    Cause, Diagnosis, Finding, ImageSpec, ImpossibleCamera, Repair, Value, WrongPixels, diagnose, impossible_camera,
};
use crate::numerics::health::{Health, health};
use crate::progress::at_once;
use crate::sanitize;
use camera_lab_files::{self as files, FileError, Opened};
use camera_lab_words::window::coach;
use camera_lab_words::{Lang, messages};

/// The JSON output.
#[derive(Serialize)]
struct Answer {
    visible: u64,
    covered: f64,
    placed_within: f64,
    health: Vec<HealthLine>,
    findings: Vec<FindingLine>,
}

#[derive(Serialize)]
struct HealthLine {
    code: &'static str,
    level: &'static str,
    value: f64,
    message: String,
}

#[derive(Serialize)]
struct FindingLine {
    code: &'static str,
    objects: Vec<String>,
    message: String,
    repair: Option<Changes>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wrong_pixels: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    wrong_share: Option<f64>,
    /// Faces that `vertex-rounding` leaves out.
    #[serde(skip_serializing_if = "Option::is_none")]
    infinite_faces: Option<usize>,
}

/// Keys and their new values, in order.
struct Changes(Vec<(&'static str, Value)>);

impl Serialize for Changes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        self.0.iter().try_for_each(|(key, value)| map.serialize_entry(key, value))?;
        map.end()
    }
}

/// A figure under examination: with a camera, or with the error of an impossible one.
struct Examined {
    opened: Opened,
    camera: Option<Camera>,
    diagnosis: Diagnosis,
    /// The wrong pixels on the other side of a comparison.
    other_side: Vec<Finding>,
    health: Vec<Health>,
    lang: Lang,
}

impl Examined {
    fn open(args: &DiagnoseArgs, lang: Lang) -> Result<Self, Failure> {
        let written = written(args.common.lang);
        if let Some((opened, error)) = impossible(args, lang)? {
            let scene = scene(&args.figure, &opened, &args.common, lang)?;
            let Figure { camera, style, reveal, image, .. } = opened.figure;
            let impossible = ImpossibleCamera { error, parameters: camera, style, reveal, image };
            let diagnosis = impossible_camera(&impossible, &scene);
            let (camera, health, other_side) = (None, Vec::new(), Vec::new());
            return Ok(Self { opened, camera, diagnosis, other_side, health, lang: written });
        }
        let subject = OpenFigure::open(&args.figure, &args.common, None, lang)?;
        let Figure { style, reveal, image, .. } = &subject.opened.figure;
        let spec = ImageSpec {
            scene: &subject.scene,
            camera: &subject.camera,
            style,
            reveal,
            image: *image,
            compared: u64::MAX,
        };
        let diagnosed = progress::watched(lang, |progress| at_once(diagnose(&spec, progress)));
        let diagnosis = diagnosed.map_err(|_| subject.too_large())?;
        let other_side = other_side(&subject, &diagnosis, lang)?;
        let health = health(&subject.camera, style.depth_format, *image, subject.scene.bounds());
        let OpenFigure { opened, camera, .. } = subject;
        Ok(Self { opened, camera: Some(camera), diagnosis, other_side, health, lang: written })
    }
}

/// The figure and its error, if its camera is impossible. Operations need a camera, so with any of them, the error is
/// reported as by every other command.
fn impossible(args: &DiagnoseArgs, lang: Lang) -> Result<Option<(Opened, CameraError)>, Failure> {
    if !args.common.steps(lang)?.is_empty() {
        return Ok(None);
    }
    // Other errors of the file are reported when it's opened as usual.
    let opened = files::open_figure_with_any_camera(&args.figure).ok();
    Ok(opened.and_then(|(opened, error)| Some((opened, error?))))
}

/// The wrong pixels on the other side of a comparison, except those of the figure itself. The keys of the figure can't
/// repair them.
fn other_side(subject: &OpenFigure, own: &Diagnosis, lang: Lang) -> Result<Vec<Finding>, Failure> {
    let figure = &subject.opened.figure;
    let Some(other) = figure.compare.as_ref().and_then(|compare| compare.other_side(figure).ok()) else {
        return Ok(Vec::new());
    };
    let camera = other.camera.as_ref().unwrap_or(&subject.camera);
    let Figure { style, reveal, image, .. } = &other.figure;
    let spec = ImageSpec { scene: &subject.scene, camera, style, reveal, image: *image, compared: u64::MAX };
    let diagnosed = progress::watched(lang, |progress| at_once(diagnose(&spec, progress)));
    let findings = diagnosed.map_err(|_| subject.too_large())?.findings.into_iter();
    let is_new = |finding: &Finding| own.findings.iter().all(|known| known.cause != finding.cause);
    Ok(findings
        .filter(|finding| finding.pixels.is_some() && is_new(finding))
        .map(|finding| Finding { repair: None, ..finding })
        .collect())
}

pub(super) fn run(args: &DiagnoseArgs, lang: Lang) -> Result<(), Failure> {
    let Examined { opened, camera, diagnosis, other_side, health, lang: written } = Examined::open(args, lang)?;
    let figure = &opened.figure;
    let line = |line: &Health| {
        let message = |camera| coach::health(written, line, camera, figure.style.depth_format);
        HealthLine {
            code: line.quantity.code(),
            level: line.level.name(),
            value: line.value,
            message: camera.as_ref().map_or_else(String::new, message),
        }
    };
    let changes = |repair: &Repair| Changes(repair.changes(figure));
    let finding = |finding: &Finding| FindingLine {
        code: finding.cause.code(),
        objects: finding.objects().map(str::to_owned).collect(),
        message: coach::finding(written, finding, &diagnosis, &figure.scene),
        repair: finding.repair.as_ref().map(changes),
        wrong_pixels: finding.pixels.map(|pixels| pixels.wrong),
        wrong_share: finding.pixels.map(WrongPixels::share),
        infinite_faces: (finding.cause == Cause::VertexRounding).then_some(diagnosis.infinite_faces),
    };
    let aside = coach::texts(written).on_the_other_side;
    let on_the_other_side = other_side.iter().map(|f| {
        let line = finding(f);
        FindingLine { message: format!("{aside} {}", line.message), ..line }
    });
    let answer = Answer {
        visible: diagnosis.visible,
        covered: diagnosis.covered,
        placed_within: diagnosis.placed_within,
        health: health.iter().map(line).collect(),
        findings: diagnosis.findings.iter().map(finding).chain(on_the_other_side).collect(),
    };
    let text = match args.format {
        TableFormat::Json => json_of(&answer)?,
        TableFormat::Text => sentences(&answer, &health, written),
    };
    if let Some(path) = args.output.as_ref().filter(|_| args.repair) {
        let (repaired, note) = repaired(figure, &diagnosis, lang);
        save_repaired(args, &opened, &repaired, path, lang)?;
        if let Some(note) = note {
            say(&format!("{}: {note}", messages::opened(lang, &args.figure)));
        }
    }
    print(text.as_bytes(), lang)
}

/// Writes a repaired figure, from a picture with the files that it carries.
fn save_repaired(
    args: &DiagnoseArgs,
    opened: &Opened,
    repaired: &Figure,
    path: &Path,
    lang: Lang,
) -> Result<(), Failure> {
    if opened.carried.is_empty() {
        let text = text_for_file((&args.figure, opened), repaired, path.parent(), lang)?;
        return save(path, text.as_bytes(), None, lang);
    }
    let files = files_of(&args.figure, opened, &args.common);
    let (moved, _, beside) = files::beside_figure(repaired, files, path);
    for (path, bytes) in beside {
        let folder = path.parent().unwrap_or(Path::new(""));
        let made = files::disk::create_folder(folder).map_err(FileError::Write);
        made.map_err(|error| Failure::Failed(messages::file(lang, &sanitize::path(folder), &error)))?;
        save(&path, &bytes, None, lang)?;
    }
    // Its names are relative to the new file already.
    let text = text_for_file((path, opened), &moved, path.parent(), lang)?;
    save(path, text.as_bytes(), None, lang)
}

/// The figure with the repair of the first finding, or the message that replaces it.
fn repaired(figure: &Figure, diagnosis: &Diagnosis, lang: Lang) -> (Figure, Option<&'static str>) {
    let t = coach::texts(lang);
    let mut figure = figure.clone();
    let note = match diagnosis.findings.first().map(|finding| finding.repair) {
        Some(Some(repair)) => {
            repair.apply(&mut figure);
            None
        }
        Some(None) => Some(t.cannot_repair),
        None => Some(t.nothing_repaired),
    };
    (figure, note)
}

/// The output as text.
fn sentences(answer: &Answer, health: &[Health], lang: Lang) -> String {
    let t = coach::texts(lang);
    let mut text = String::new();
    // Writing to a String can't fail.
    if !health.is_empty() {
        let _ = writeln!(text, "{}", coach::seen(lang, answer.visible, answer.covered));
        if let Some(placed) = coach::placed(lang, answer.placed_within) {
            let _ = writeln!(text, "{placed}");
        }
        text.push('\n');
    }
    let _ = writeln!(text, "{}", t.findings);
    for finding in &answer.findings {
        let _ = writeln!(text, "  {:<21} {}", finding.code, finding.message);
        let repair = finding.repair.as_ref().map_or_else(|| t.no_repair.to_owned(), |c| coach::changes(&c.0));
        let _ = writeln!(text, "  {:<21} {}: {repair}", "", t.repair);
    }
    if answer.findings.is_empty() {
        let _ = writeln!(text, "  {}", t.no_problems);
    }
    if health.is_empty() {
        return text;
    }
    let _ = writeln!(text, "\n{}", t.health);
    for (line, health) in answer.health.iter().zip(health) {
        let _ = writeln!(text, "  {:<21} {:<8} {}", line.code, coach::level(lang, health.level), line.message);
    }
    text
}
