//! The page in one file with something of the lecturer's: a page that opens with a lesson or figure, and a package for
//! a course platform, a zip of SCORM 1.2.
//!
//! Source: ADL, *SCORM Version 1.2*, 2001: the content packaging and the run-time environment. `scorm.js` talks to the
//! platform, and to the page by its messages (`docs/web.md`).

mod zip;

use std::path::Path;

use serde_json::json;

use crate::exercises::{self, Exercise};
use crate::lessons::{Lesson, Step, Task};
use crate::{FigureFiles, FileError, read_at_most, text_with_files};

/// The most bytes of a page. This version's has less than half of that.
const MAX_PAGE_BYTES: u64 = 16 << 20;
/// The longest zip without extensions.
const MAX_ZIP_BYTES: u64 = (1 << 32) - 1;

const WRAPPER: &str = include_str!("index.html");
const SCRIPT: &str = include_str!("scorm.js");

/// The mark of this version's page. What a page begins with stands behind it.
const VERSION: &str = concat!("<meta name=\"camera-lab\" content=\"", env!("CARGO_PKG_VERSION"), "\">");
/// The tags around the script that opens something.
const BEGINS: [&str; 2] = ["\n<script id=\"camera-lab-begins\">", "</script>"];

/// The name of the page in one file.
pub const PAGE_NAME: &str = "camera-lab.html";

/// The percentage of questions with which a package is passed, if its author doesn't choose another.
pub const USUAL_PASS: f64 = 50.0;

/// The terms of a package: its title, the tag of its language, and the percentage of questions with which it's passed.
pub type Course<'a> = (&'a str, &'a str, f64);

/// The end of the address with which a page opens a built-in lesson.
pub fn of_shipped(id: &str) -> String {
    format!("&lesson={id}")
}

/// Reads the page in one file, if it's of this version, and holds everything. What [`page_with`] put into it is left
/// out.
///
/// # Errors
/// [`FileError::OtherPage`] if it isn't, and as for [`read_at_most`].
pub fn read_page(path: &Path) -> Result<String, FileError> {
    let bytes = read_at_most(path, MAX_PAGE_BYTES)?;
    let page = String::from_utf8(bytes).map_err(|_| FileError::OtherPage)?;
    // `index.html` needs the files beside it.
    let is_whole = page.contains(VERSION) && !page.contains("src=\"./camera-lab.js\"");
    if is_whole { Ok(plain(&page)) } else { Err(FileError::OtherPage) }
}

/// A page without what it opens.
fn plain(page: &str) -> String {
    let [begin, end] = BEGINS;
    let parts = page.split_once(begin).and_then(|(head, own)| Some((head, own.split_once(end)?.1)));
    parts.map_or_else(|| page.to_owned(), |(head, rest)| [head, rest].concat())
}

/// The page that opens what the end of an address says, from [`of_shipped`] or [`fragment`](crate::share::fragment). A
/// link to something else in its address comes first.
pub fn page_with(page: &str, end_of_address: &str) -> String {
    let [begin, end] = BEGINS;
    let (head, rest) = page.split_once(VERSION).unwrap_or((page, ""));
    // There's no quote in it.
    let before = if end_of_address.starts_with('#') { "" } else { "(location.search || '?') + " };
    let address = format!("{before}'{end_of_address}'");
    let script = format!("if (!/(lesson|figure)=/.test(location.search + location.hash)) location.replace({address});");
    [head, VERSION, begin, &script, end, rest].concat()
}

/// The text of a lesson of the user's own with the files that its figures name.
///
/// # Errors
/// [`FileError::OwnFile`] with the name of one that can't be read or has no room.
pub fn lesson_with_files(text: &str, lesson: &Lesson, path: Option<&Path>) -> Result<String, FileError> {
    text_with_files(text, lesson.steps.iter().map(|step| &*step.figure), &FigureFiles::of_lesson(path, false))
}

/// A lesson in a package. `opened` is what its page opens: the identifier of a built-in lesson, or the text of another
/// one, as by [`lesson_with_files`].
///
/// # Errors
/// [`FileError::TooLarge`].
pub fn package(page: String, lesson: &Lesson, opened: &str, course: Course<'_>) -> Result<Vec<u8>, FileError> {
    let (title, lang, pass) = course;
    let (steps, questions) = (&lesson.steps, questions_of(&lesson.steps));
    let before = &steps[..steps.len().saturating_sub(1)];
    let json = json!({
        "title": title,
        "lang": lang,
        "pass": pass,
        "lesson": opened,
        "steps": lesson.steps.len(),
        "questions": questions,
        // The number of those in the last step.
        "last": questions.len() - questions_of(before).len(),
    });
    let fill = |text: &str| text.replace("@LANG@", lang).replace("@TITLE@", &escaped(title));
    let parts: [(&str, Vec<u8>); 5] = [
        ("imsmanifest.xml", manifest(&lesson.id, title).into_bytes()),
        ("index.html", fill(WRAPPER).into_bytes()),
        ("scorm.js", SCRIPT.as_bytes().to_vec()),
        ("lesson.js", format!("'use strict';\nconst cameraLabCourse = {json};\n").into_bytes()),
        (PAGE_NAME, page.into_bytes()),
    ];
    zip::stored(&parts).ok_or(FileError::TooLarge(MAX_ZIP_BYTES))
}

/// The questions of steps, in their order, as `ID:SEED/NAME`.
fn questions_of(steps: &[Step]) -> Vec<String> {
    let mut all = Vec::new();
    for step in steps {
        let (id, exercise): (&str, Exercise) = match &step.task {
            Some(Task::Question(entry)) => (&entry.id, entry.exercise(0, &Default::default())),
            Some(Task::Exercise { id, seed }) => match exercises::entry(id) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::share::{Held, fragment};

    #[test]
    fn a_page_opens_what_it_was_given_last() {
        let page = format!("<head>\n{VERSION}\n<title>Camera Lab</title>\n</head>");
        let made = page_with(&page, &fragment(Held::Lesson, "id = \"</script>\""));
        assert!(made.contains("location.replace('#lesson=") && made.matches("</script>").count() == 1, "{made}");
        assert!(made.ends_with("</script>\n<title>Camera Lab</title>\n</head>"));
        assert_eq!((plain(&made), plain(&page)), (page.clone(), page.clone()));
        let other = page_with(&page, &of_shipped("basis"));
        assert!(other.contains("'&lesson=basis'") && !other.contains('#'));
    }
}
