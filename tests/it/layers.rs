//! Who may import whom: the `crate::` paths of each file against the table of the design.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Leaves that everybody may import.
const LEAVES: &[&str] = &["appearance", "limits"];

/// Each module with the modules that it may import, besides [`LEAVES`].
const TABLE: &[(&str, &[&str])] = &[
    ("appearance", &[]),
    ("limits", &[]),
    ("geometry", &[]),
    ("numbers", &[]),
    // The sine of whole degrees is exact there.
    ("expression", &["geometry"]),
    ("camera", &["geometry", "numbers", "expression"]),
    ("scene", &["geometry"]),
    ("text", &[]),
    ("drawing", &[]),
    ("simd", &[]),
    ("lighting", &["drawing", "simd"]),
    ("pipeline", &["geometry", "camera", "scene", "drawing", "lighting", "simd"]),
    ("raster", &["drawing", "lighting", "simd", "text"]),
    ("figure", &["geometry", "camera", "scene", "expression", "numbers"]),
    ("inspect", &["camera", "figure"]),
    ("views", &["geometry", "camera", "scene", "figure", "pipeline", "drawing", "numbers", "text"]),
    ("export", &["drawing", "raster", "inspect"]),
    ("files", &["figure", "export", "scene"]),
    ("picture", &["camera", "scene", "drawing", "figure", "pipeline", "views", "raster", "export"]),
    ("numerics", &["camera", "geometry", "scene", "pipeline", "raster"]),
    // The enums of errors, warnings, labels and stages.
    (
        "i18n",
        &["expression", "camera", "scene", "figure", "inspect", "export", "files", "views", "numerics", "pipeline"],
    ),
    ("exercises", &["camera", "figure", "inspect", "numerics"]),
    ("cli", EVERYTHING),
    ("gui", EVERYTHING),
];

const EVERYTHING: &[&str] = &[
    "numbers",
    "expression",
    "text",
    "geometry",
    "camera",
    "scene",
    "drawing",
    "pipeline",
    "raster",
    "figure",
    "inspect",
    "views",
    "export",
    "files",
    "picture",
    "numerics",
    "i18n",
    "exercises",
];

/// Libraries that only some modules may name.
const LIBRARIES: &[(&str, &[&str])] = &[
    ("eframe", &["gui"]),
    ("egui", &["gui"]),
    ("rfd", &["gui"]),
    ("clap", &["cli", "i18n"]),
    ("toml_edit", &["figure"]),
    ("fearless_simd", &["simd"]),
    ("skrifa", &["text"]),
    ("tiny_skia", &["raster", "export", "files", "picture", "gui"]),
];

/// What touches the file system.
const FILES: &[&str] = &["files", "cli", "gui"];

/// The window is opened from here.
const WINDOW: &str = "cli/window.rs";

fn rust_files(directory: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(directory).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            rust_files(&entry, into);
        } else if entry.extension().is_some_and(|ending| ending == "rs") {
            into.push(entry);
        }
    }
}

/// The program text without comments and without the tests at its end.
fn code(text: &str) -> String {
    let end = text.find("#[cfg(test)]\nmod ").unwrap_or(text.len());
    let lines = text[..end].lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

fn word(text: &str) -> &str {
    let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    &text[..end]
}

/// The modules named after `crate::`, also those in braces.
fn imports(code: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (at, _) in code.match_indices("crate::") {
        if code[..at].ends_with("$") {
            continue;
        }
        let rest = &code[at + "crate::".len()..];
        let Some(list) = rest.strip_prefix('{') else {
            found.insert(word(rest).to_owned());
            continue;
        };
        let mut depth = 0;
        let mut start = true;
        for (i, c) in list.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => start = true,
                c if start && !c.is_whitespace() => {
                    found.insert(word(&list[i..]).to_owned());
                    start = false;
                }
                _ => {}
            }
        }
    }
    found
}

fn names(code: &str, library: &str) -> bool {
    let path = format!("{library}::");
    code.match_indices(&path).any(|(at, _)| !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))
}

#[test]
fn every_file_keeps_to_the_table_of_imports() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&source, &mut files);
    assert!(files.len() > 50, "the sources are not where they were");
    let mut faults = Vec::new();
    for file in files {
        let path = file.strip_prefix(&source).unwrap().to_string_lossy().replace('\\', "/");
        if path == "lib.rs" || path == "main.rs" || path.ends_with("tests.rs") {
            continue;
        }
        let module = path.split('/').next().unwrap().trim_end_matches(".rs").to_owned();
        let Some((_, allowed)) = TABLE.iter().find(|(name, _)| *name == module) else {
            faults.push(format!("{path}: the module {module} is not in the table"));
            continue;
        };
        let code = code(&fs::read_to_string(&file).unwrap());
        for import in imports(&code) {
            let own = import == module || LEAVES.contains(&import.as_str());
            let opens_the_window = path == WINDOW && import == "gui";
            if !own && !opens_the_window && !allowed.contains(&import.as_str()) {
                faults.push(format!("{path} imports crate::{import}"));
            }
        }
        for (library, _) in LIBRARIES.iter().filter(|(_, who)| !who.contains(&module.as_str())) {
            if names(&code, library) {
                faults.push(format!("{path} names {library}"));
            }
        }
        if code.contains("std::fs") && !FILES.contains(&module.as_str()) {
            faults.push(format!("{path} touches the file system"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn imports_are_seen_in_every_form() {
    let text = "use crate::a::{B, c};\nuse crate::{d::{E, f}, g};\n// crate::no\nlet x = crate::h::i();\n#[cfg(test)]\nmod t { use crate::no; }";
    let found: Vec<String> = imports(&code(text)).into_iter().collect();
    assert_eq!(found, ["a", "d", "g", "h"]);
    assert!(names("use egui::Ui;", "egui") && !names("let x = my_egui::x;", "egui"));
}
