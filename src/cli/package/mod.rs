//! A lesson or a sheet of exercises for a course platform: a zip of SCORM 1.2, with the page in it.
//!
//! Source: ADL, *SCORM Version 1.2*, 2001: the content packaging and the run-time environment. `scorm.js` talks to the
//! platform, and to the page by its messages (`docs/web.md`).

mod zip;

use std::path::Path;

use serde_json::json;

use super::Failure;
use super::render::save;
use crate::cli::args::package::PackedArgs;
use crate::exercises::Exercise;
use crate::lessons::{Lesson, Task};
use crate::sanitize;
use camera_lab_files as files;
use camera_lab_words::learn::{exercise_messages as said, lessons as texts};
use camera_lab_words::{Lang, messages};

/// The most bytes of a page. This version's has less than half of that.
const MAX_PAGE_BYTES: u64 = 16 << 20;

const WRAPPER: &str = include_str!("index.html");
const SCRIPT: &str = include_str!("scorm.js");

/// Packs a lesson. `opened` is what the page opens: the identifier of a built-in lesson, or the text of another one.
pub(super) fn write(
    lesson: &Lesson,
    opened: &str,
    args: &PackedArgs,
    (written, lang): (Lang, Lang),
) -> Result<(), Failure> {
    let pass = args.pass(lang)?;
    let page = page(&args.page, lang)?;
    let own: Vec<String> = lesson
        .steps
        .iter()
        .flat_map(|step| files::own_files(&step.figure).into_keys())
        .map(sanitize::path_text)
        .collect();
    if let Some(own) = own.first() {
        return Err(Failure::BadInput(texts::own_file(lang, own)));
    }
    let title = texts::told(written, &lesson.title);
    let course = json!({
        "title": title,
        "lang": written.tag(),
        "pass": pass,
        "lesson": opened,
        "steps": lesson.steps.len(),
        "questions": questions(lesson),
    });
    let fill = |text: &str| text.replace("@LANG@", written.tag()).replace("@TITLE@", &escaped(title));
    let parts: [(&str, Vec<u8>); 5] = [
        ("imsmanifest.xml", manifest(&lesson.id, title).into_bytes()),
        ("index.html", fill(WRAPPER).into_bytes()),
        ("scorm.js", SCRIPT.as_bytes().to_vec()),
        ("lesson.js", format!("'use strict';\nconst cameraLabCourse = {course};\n").into_bytes()),
        ("camera-lab.html", page),
    ];
    let packed = zip::stored(&parts).ok_or_else(|| Failure::BadInput(said::package_too_large(lang)))?;
    save(&args.output, &packed, None, lang)
}

/// The page, if it's of this version, and holds everything.
fn page(path: &Path, lang: Lang) -> Result<Vec<u8>, Failure> {
    let name = sanitize::path(path);
    let bytes = files::read_at_most(path, MAX_PAGE_BYTES)
        .map_err(|error| Failure::BadInput(messages::file(lang, &name, &error)))?;
    let holds = |text: &str| bytes.windows(text.len()).any(|part| part == text.as_bytes());
    let is_of_version = holds(&format!("<meta name=\"camera-lab\" content=\"{}\">", env!("CARGO_PKG_VERSION")));
    // `index.html` needs the files beside it.
    if is_of_version && !holds("src=\"./camera-lab.js\"") {
        Ok(bytes)
    } else {
        Err(Failure::BadInput(said::not_this_page(lang, &name, env!("CARGO_PKG_VERSION"))))
    }
}

/// The questions of a lesson, in its order, as `ID:SEED/NAME`.
fn questions(lesson: &Lesson) -> Vec<String> {
    let mut all = Vec::new();
    for step in &lesson.steps {
        let (id, exercise): (&str, Exercise) = match &step.task {
            Some(Task::Question(entry)) => (&entry.id, entry.exercise(0, &Default::default())),
            Some(Task::Exercise { id, seed }) => match crate::exercises::entry(id) {
                Some(entry) => (id, entry.exercise(*seed, &Default::default())),
                None => continue,
            },
            Some(Task::Try(_)) | None => continue,
        };
        for ask in &exercise.asks {
            let question = format!("{id}:{}/{}", exercise.seed, ask.name);
            if !all.contains(&question) {
                all.push(question);
            }
        }
    }
    all
}

fn manifest(id: &str, title: &str) -> String {
    let title = escaped(title);
    format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<manifest identifier="camera-lab.{id}" version="1.0" xmlns="http://www.imsproject.org/xsd/imscp_rootv1p1p2" xmlns:adlcp="http://www.adlnet.org/xsd/adlcp_rootv1p2">
  <metadata>
    <schema>ADL SCORM</schema>
    <schemaversion>1.2</schemaversion>
  </metadata>
  <organizations default="course">
    <organization identifier="course">
      <title>{title}</title>
      <item identifier="item" identifierref="resource">
        <title>{title}</title>
      </item>
    </organization>
  </organizations>
  <resources>
    <resource identifier="resource" type="webcontent" adlcp:scormtype="sco" href="index.html">
      <file href="index.html"/>
      <file href="scorm.js"/>
      <file href="lesson.js"/>
      <file href="camera-lab.html"/>
    </resource>
  </resources>
</manifest>
"#
    )
}

/// As text of XML and HTML. Control characters, which XML can't hold, are left out.
fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;");
    text.chars().filter(|c| !c.is_control()).collect()
}
