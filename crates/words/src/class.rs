//! The report about a class, as text, JSON and pages.

use std::fmt::Write as _;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::exercises::class::{Class, ClassError, Counts, to_discuss};
use crate::exercises::{Mistake, ProgressError, entries, entry};
use crate::learn::{exercise_messages, exercises};
use crate::limits::MAX_FIGURE_BYTES;
use camera_lab_engine::progress::{Progress, at_once};
use camera_lab_figures::picture::{Handout, HandoutEntry, HandoutPart, Paragraph};
use camera_lab_files::{self as files, FileError};

texts!("class");

/// The reason why a file adds no student.
pub fn error(lang: Lang, error: &ClassError) -> String {
    match error {
        ClassError::Foreign => text!(lang, foreign).to_owned(),
        ClassError::Cell { line, column, text } => {
            text!(lang, cell, line, column, text = crate::sanitize::escaped(text))
        }
        ClassError::Progress(ProgressError::Value(key)) => text!(lang, unreadable, key),
        ClassError::Progress(ProgressError::Toml(why)) | ClassError::Table(why) => crate::sanitize::escaped(why),
    }
}

/// A class, with the files that add nothing to it and the reasons why.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ClassReport {
    /// Its students.
    pub class: Class,
    /// The names of files and reasons.
    pub skipped: Vec<(String, String)>,
}

/// A file for the page to print whose ending isn't that of a PDF file.
pub fn ending(lang: Lang, path: &str) -> String {
    text!(lang, ending, path)
}

impl ClassReport {
    /// The report on files of progress or their tables. A file without a student's name belongs to the student whom
    /// it's named after.
    pub fn of_files(paths: &[PathBuf], lang: Lang) -> Self {
        let mut report = Self::default();
        paths.iter().for_each(|path| report.add(path, path.file_stem(), lang));
        report
    }

    fn add(&mut self, path: &Path, student: Option<&OsStr>, lang: Lang) {
        let name = crate::sanitize::path(path);
        let text = files::read_at_most(path, MAX_FIGURE_BYTES as u64).map(|bytes| {
            // Spreadsheets also save tables in Latin letters of one byte.
            let latin = |bytes: Vec<u8>| bytes.into_iter().map(char::from).collect();
            String::from_utf8(bytes).unwrap_or_else(|error| latin(error.into_bytes()))
        });
        let student = student.unwrap_or_default().to_string_lossy();
        let added = text.map_err(|fault| crate::messages::file(lang, &name, &fault));
        let added = added.and_then(|text| self.class.add(&student, &text).map_err(|fault| error(lang, &fault)));
        self.skipped.extend(added.err().map(|reason| (name, reason)));
    }

    /// The report on the files of a folder and of the folders in it. Course platforms hand out a folder for each
    /// student, with the student's name.
    ///
    /// # Errors
    /// [`FileError`] if the folder can't be read.
    pub fn of_folder(folder: &Path, lang: Lang) -> Result<Self, FileError> {
        let is_progress = |path: &PathBuf| {
            path.extension()
                .is_some_and(|ending| ["toml", "csv"].iter().any(|known| ending.eq_ignore_ascii_case(known)))
        };
        let mut report = Self::default();
        if cfg!(target_arch = "wasm32") {
            // A page has no folders, and needn't carry what reads them.
            return Ok(report);
        }
        let mut paths = files::entries(folder)?;
        paths.sort();
        for path in paths {
            if is_progress(&path) {
                report.add(&path, path.file_stem(), lang);
            } else {
                // Other files have nothing in them.
                let inside = files::entries(&path).unwrap_or_default();
                inside
                    .iter()
                    .filter(|path| is_progress(path))
                    .for_each(|inside| report.add(inside, path.file_name(), lang));
            }
        }
        Ok(report)
    }

    /// The report in the format given by the ending of a file: PDF, CSV or JSON. `None` for another ending.
    pub fn file(&self, path: &Path, lang: Lang) -> Option<Vec<u8>> {
        if cfg!(target_arch = "wasm32") {
            return None;
        }
        match path.extension()?.to_str()?.to_lowercase().as_str() {
            "pdf" => at_once(self.handout(lang).pdf(&Progress::default())).ok(),
            "csv" => Some(self.csv().into_bytes()),
            "json" => Some(camera_lab_figures::inspect::json_text(&self.json()).into_bytes()),
            _ => None,
        }
    }

    /// For spreadsheets.
    pub fn csv(&self) -> String {
        self.class.to_csv(entries().map(|entry| &*entry.id))
    }

    /// The exercises that someone tried, in the order of the program's list.
    pub fn exercises(&self) -> Vec<(String, Counts)> {
        self.class.exercises(entries().map(|entry| &*entry.id))
    }

    /// For programs.
    pub fn json(&self) -> Value {
        let counted = |mistakes: &[(String, usize)]| -> Vec<Value> {
            mistakes.iter().map(|(code, count)| json!({ "code": code, "count": count })).collect()
        };
        let exercise = |(id, counts): &(String, Counts)| {
            let Counts { tried, solved, alone, mistakes } = counts;
            let [without_help, with_help, not_yet] = self.class.who(id);
            let who = json!({ "without_help": without_help, "with_help": with_help, "not_yet": not_yet });
            let mistakes = counted(mistakes);
            json!({ "id": id, "solved": solved, "alone": alone, "tried": tried, "who": who, "mistakes": mistakes })
        };
        let all = self.class.mistakes();
        let skipped = self.skipped.iter().map(|(file, reason)| json!({ "file": file, "reason": reason }));
        json!({
            "students": self.class.students.len(),
            "exercises": self.exercises().iter().map(exercise).collect::<Vec<_>>(),
            "mistakes": counted(&all),
            "discuss": to_discuss(&all).iter().map(|mistake| mistake.code()).collect::<Vec<_>>(),
            "skipped": skipped.collect::<Vec<_>>(),
        })
    }

    /// To read: headings, and the lines below each.
    pub fn sections(&self, lang: Lang) -> Vec<(String, Vec<String>)> {
        if cfg!(target_arch = "wasm32") {
            return Vec::new();
        }
        let t = texts(lang);
        let count = self.class.students.len();
        let students =
            if count == 1 { text!(lang, students_one).to_owned() } else { text!(lang, students_many, count) };
        let mut sections = vec![(students, if count == 0 { vec![t.empty.to_owned()] } else { Vec::new() })];
        let all = self.class.mistakes();
        let counted = |(code, count): &(String, usize)| {
            let message = Mistake::of_code(code).map_or(code.as_str(), |made| exercises::mistake(lang, made)[0]);
            text!(lang, mistake, count, message)
        };
        let discussed = to_discuss(&all);
        let to_talk: Vec<String> = all
            .iter()
            .filter(|(code, _)| discussed.iter().any(|mistake| mistake.code() == code))
            .map(counted)
            .collect();
        if count > 0 {
            sections.push((
                t.discuss.to_owned(),
                if to_talk.is_empty() { vec![t.no_mistakes.to_owned()] } else { to_talk },
            ));
        }
        for (id, counts) in self.exercises() {
            let Counts { tried, solved, alone, mistakes } = &counts;
            let title = entry(&id).map_or(id.clone(), |entry| exercises::title(lang, entry).to_string());
            let mut lines = vec![text!(lang, counts, tried, solved, alone)];
            let names = [t.without_help, t.with_help, t.not_yet].into_iter().zip(self.class.who(&id));
            let names = names.filter(|(_, who)| !who.is_empty());
            lines.extend(names.map(|(label, who)| format!("{label}: {}", crate::sanitize::escaped(&who.join(", ")))));
            lines.extend(mistakes.iter().map(counted));
            sections.push((title, lines));
        }
        if !self.skipped.is_empty() {
            // Errors of the system begin with the name.
            let line = |(file, reason): &(String, String)| match reason.starts_with(file.as_str()) {
                true => reason.clone(),
                false => format!("{file}: {reason}"),
            };
            sections.push((t.skipped.to_owned(), self.skipped.iter().map(line).collect()));
        }
        sections
    }

    /// To read in a terminal.
    pub fn text(&self, lang: Lang) -> String {
        let mut text = String::new();
        for (heading, lines) in self.sections(lang) {
            // Writing to a String can't fail.
            let _ = writeln!(text, "{}{heading}", if text.is_empty() { "" } else { "\n" });
            for line in lines {
                let _ = writeln!(text, "  {}", exercise_messages::plain(&line));
            }
        }
        text
    }

    /// To print.
    pub fn handout(&self, lang: Lang) -> Handout {
        let entry = |(heading, lines): (String, Vec<String>)| {
            let lines = lines.iter().map(|line| Paragraph::Text(crate::handout::in_line(line)));
            HandoutEntry {
                picture: None,
                paragraphs: std::iter::once(Paragraph::Heading(heading)).chain(lines).collect(),
            }
        };
        let entries = self.sections(lang).into_iter().map(entry).collect();
        let part = HandoutPart { title: texts(lang).report.to_owned(), foot: String::new(), entries };
        Handout { language: lang.tag(), parts: vec![part], columns: 1 }
    }
}
