//! `camera-lab diagnose`: how near a camera is to trouble with numbers, and why a picture is empty.

use std::fmt::Write as _;

use serde::ser::SerializeMap as _;
use serde::{Serialize, Serializer};

use super::args::DiagnoseArgs;
use super::words::TableFormat;
use super::{Failure, OpenFigure, print, say};
use crate::figure::{Figure, update};
use crate::files::{self, Overwrite};
use crate::i18n::{Lang, coach, messages};
use crate::numerics::diagnosis::{Diagnosis, Repair, Value, diagnose};
use crate::numerics::health::{Health, health};
use crate::sanitize;

/// The JSON output.
#[derive(Serialize)]
struct Answer<'a> {
    visible: u64,
    covered: f64,
    health: Vec<HealthLine>,
    findings: Vec<FindingLine<'a>>,
}

#[derive(Serialize)]
struct HealthLine {
    code: &'static str,
    level: &'static str,
    value: f64,
    message: String,
}

#[derive(Serialize)]
struct FindingLine<'a> {
    code: &'static str,
    objects: Vec<&'a str>,
    message: String,
    repair: Option<Changes>,
}

/// Keys and the values that they get, in order.
struct Changes(Vec<(&'static str, Value)>);

impl Serialize for Changes {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        self.0.iter().try_for_each(|(key, value)| map.serialize_entry(key, value))?;
        map.end()
    }
}

pub(super) fn run(args: &DiagnoseArgs, lang: Lang) -> Result<(), Failure> {
    let subject = OpenFigure::open(&args.figure, &args.common, None, lang)?;
    let OpenFigure { opened, camera, scene, .. } = &subject;
    let figure = &opened.figure;
    let health = health(camera, figure.image, scene.bounds());
    let diagnosis = diagnose(scene, camera, &figure.style, figure.image).ok_or_else(|| subject.too_large())?;
    let written = subject.lang;
    let line = |line: &Health| HealthLine {
        code: line.quantity.code(),
        level: line.level.name(),
        value: line.value,
        message: coach::health(written, line, camera),
    };
    let changes = |repair: &Repair| Changes(repair.changes(&figure.camera, &figure.style));
    let answer = Answer {
        visible: diagnosis.visible,
        covered: diagnosis.covered,
        health: health.iter().map(line).collect(),
        findings: diagnosis
            .findings
            .iter()
            .map(|finding| FindingLine {
                code: finding.cause.code(),
                objects: finding.objects().collect(),
                message: coach::finding(written, finding, &diagnosis, &figure.scene),
                repair: finding.repair.as_ref().map(changes),
            })
            .collect(),
    };
    let text = match args.format {
        TableFormat::Json => {
            serde_json::to_string_pretty(&answer).map_err(|error| Failure::Failed(error.to_string()))? + "\n"
        }
        TableFormat::Text => sentences(&answer, &health, written),
    };
    if let Some(path) = args.output.as_ref().filter(|_| args.repair) {
        let (repaired, note) = repaired(figure, &diagnosis, lang);
        // The file may be for another folder than the one from which its meshes are named.
        let repaired = files::for_folder(&repaired, args.figure.parent(), path.parent());
        let name = sanitize::path(path);
        files::save(path, update(&opened.text, &repaired).as_bytes(), Overwrite::Writable)
            .map_err(|error| Failure::Failed(messages::file(lang, &name, &error)))?;
        if let Some(note) = note {
            say(&format!("{}: {note}", messages::opened(lang, &args.figure)));
        }
    }
    print(text.as_bytes(), lang)
}

/// The figure with the repair of the first finding, or the message in its place.
fn repaired(figure: &Figure, diagnosis: &Diagnosis, lang: Lang) -> (Figure, Option<&'static str>) {
    let t = coach::texts(lang);
    match diagnosis.findings.first().map(|finding| finding.repair) {
        Some(Some(Repair { camera, style })) => (Figure { camera, style, ..figure.clone() }, None),
        Some(None) => (figure.clone(), Some(t.cannot_repair)),
        None => (figure.clone(), Some(t.nothing_repaired)),
    }
}

/// The output as text.
fn sentences(answer: &Answer<'_>, health: &[Health], lang: Lang) -> String {
    let t = coach::texts(lang);
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", coach::seen(lang, answer.visible, answer.covered));
    let _ = writeln!(text, "\n{}", t.findings);
    for finding in &answer.findings {
        let _ = writeln!(text, "  {:<21} {}", finding.code, finding.message);
        let repair = finding.repair.as_ref().map_or_else(|| t.no_repair.to_owned(), |c| coach::changes(&c.0));
        let _ = writeln!(text, "  {:<21} {}: {repair}", "", t.repair);
    }
    if answer.findings.is_empty() {
        let _ = writeln!(text, "  {}", t.as_it_should_be);
    }
    let _ = writeln!(text, "\n{}", t.health);
    for (line, health) in answer.health.iter().zip(health) {
        let _ = writeln!(text, "  {:<21} {:<8} {}", line.code, coach::level(lang, health.level), line.message);
    }
    text
}
