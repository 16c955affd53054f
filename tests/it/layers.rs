//! Who may import whom: the `crate::` paths of each file against the table of the design.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Leaves that everybody may import.
const LEAVES: &[&str] = &["appearance", "chart", "sanitize", "limits", "progress", "stage"];

/// Each module with the modules that it may import, besides [`LEAVES`].
const TABLE: &[(&str, &[&str])] = &[
    ("appearance", &[]),
    ("chart", &["numbers"]),
    ("sanitize", &[]),
    ("limits", &[]),
    ("progress", &[]),
    ("stage", &[]),
    ("formula", &[]),
    ("geometry", &[]),
    ("numbers", &[]),
    // The sine of whole degrees is exact there.
    ("expression", &["geometry"]),
    ("camera", &["geometry", "numbers", "expression"]),
    ("scene", &["geometry", "text"]),
    ("text", &[]),
    ("drawing", &[]),
    ("simd", &[]),
    ("lighting", &["drawing", "simd"]),
    ("pipeline", &["geometry", "camera", "scene", "drawing", "lighting", "simd"]),
    ("raster", &["drawing", "lighting", "simd", "text"]),
    ("figure", &["geometry", "camera", "scene", "expression", "formula", "numbers"]),
    ("inspect", &["camera", "figure"]),
    ("views", &["geometry", "camera", "scene", "figure", "pipeline", "drawing", "formula", "numbers", "text"]),
    ("export", &["drawing", "raster", "inspect", "text", "formula"]),
    ("share", &[]),
    ("files", &["camera", "figure", "export", "scene", "exercises", "lessons", "numbers", "share"]),
    ("clock", &[]),
    ("picture", &["camera", "scene", "drawing", "figure", "pipeline", "views", "raster", "export", "text"]),
    ("numerics", &["geometry", "numbers", "camera", "scene", "figure", "pipeline", "raster", "picture", "clock"]),
    ("explain", &["geometry", "camera", "scene", "figure", "inspect", "numbers"]),
    ("exercises", &["geometry", "camera", "scene", "figure", "inspect", "explain", "expression", "formula", "numbers"]),
    ("lessons", &["camera", "scene", "figure", "inspect", "exercises", "numerics", "numbers"]),
    // The enums of errors, warnings, labels and stages.
    (
        "i18n",
        &[
            "expression",
            "formula",
            "numbers",
            "camera",
            "scene",
            "figure",
            "inspect",
            "export",
            "files",
            "views",
            "pipeline",
            "picture",
            "numerics",
            "explain",
            "exercises",
            "lessons",
            "share",
        ],
    ),
    ("cli", EVERYTHING),
    ("gui", EVERYTHING),
];

const EVERYTHING: &[&str] = &[
    "exercises",
    "lessons",
    "explain",
    "numerics",
    "numbers",
    "expression",
    "formula",
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
    "clock",
    "picture",
    "share",
    "i18n",
];

/// Libraries that only some modules may name.
const LIBRARIES: &[(&str, &[&str])] = &[
    ("eframe", &["gui"]),
    ("egui", &["gui"]),
    ("rfd", &["gui"]),
    ("qrcode", &["gui"]),
    ("clap", &["cli", "i18n"]),
    ("dashu_float", &["numerics"]),
    ("egui_commonmark", &["gui"]),
    ("egui_plot", &["gui"]),
    ("ratex_layout", &["gui"]),
    ("ratex_parser", &["gui"]),
    ("ratex_types", &["gui"]),
    ("base64", &["export", "scene", "share"]),
    ("js_sys", &["gui"]),
    ("miniz_oxide", &["export", "share"]),
    ("pdf_writer", &["export"]),
    ("subsetter", &["export"]),
    ("xmlwriter", &["export"]),
    ("csv", &["exercises", "cli"]),
    ("toml_edit", &["exercises", "figure", "gui", "lessons"]),
    ("fearless_simd", &["simd"]),
    ("gif", &["export"]),
    ("skrifa", &["text"]),
    ("wasm_bindgen", &["gui"]),
    ("web_sys", &["gui"]),
    ("tiny_skia", &["raster", "export", "files", "picture"]),
];

/// What touches the file system.
const FILES: &[&str] = &["files", "cli", "gui"];

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

/// A path as it is written: `super::a::{b, c}` is two. Only those that begin with `crate`, `super` or `self`.
type Names = Vec<String>;

/// Every path of a program text that begins with `crate`, `super` or `self`, braces multiplied out.
fn paths(code: &str) -> Vec<Names> {
    let mut found = Vec::new();
    for start in ["crate", "super", "self"] {
        for (at, _) in code.match_indices(&format!("{start}::")) {
            let before = code[..at].chars().next_back();
            if !before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == ':' || c == '$') {
                tree(&code[at..], &Vec::new(), &mut found);
            }
        }
    }
    found
}

/// Reads one branch of a tree of paths; gives back how many bytes it takes.
fn tree(text: &str, above: &Names, found: &mut Vec<Names>) -> usize {
    let mut path = above.clone();
    let mut at = 0;
    loop {
        let name = word(&text[at..]);
        if !name.is_empty() {
            path.push(name.to_owned());
            at += name.len();
        }
        let Some(rest) = text[at..].strip_prefix("::") else { break };
        at += 2;
        if let Some(mut list) = rest.strip_prefix('{') {
            loop {
                list = list.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
                if list.is_empty() || list.starts_with('}') {
                    return text.len() - list.len() + 1;
                }
                let taken = tree(list, &path, found);
                // What is neither name nor brace, such as `as other` or `*`, is passed over.
                let rest = &list[taken..];
                list = &rest[rest.find([',', '}']).unwrap_or(rest.len())..];
            }
        }
        if word(rest).is_empty() {
            break;
        }
    }
    found.push(path);
    at
}

/// The module that a file is: `scene/obj.rs` is scene, obj; `scene/mod.rs` is scene.
fn module_of(path: &str) -> Names {
    let names = path.trim_end_matches(".rs").split('/').filter(|name| *name != "mod");
    names.map(str::to_owned).collect()
}

/// A path from the root of the crate, as it is meant in `module`.
fn resolved(path: &[String], module: &[String]) -> Names {
    let mut from: Names = if path[0] == "crate" { Vec::new() } else { module.to_vec() };
    for name in path {
        match name.as_str() {
            "crate" | "self" => {}
            "super" => {
                from.pop();
            }
            name => from.push(name.to_owned()),
        }
    }
    from
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

/// Path and program text of every file.
fn sources() -> Vec<(String, String)> {
    let mut sources = Vec::new();
    for source in ["src", "crates/engine/src"].map(|folder| Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)) {
        let mut files = Vec::new();
        rust_files(&source, &mut files);
        assert!(files.len() > 50, "the sources are not where they were");
        files.sort();
        let read = |file: PathBuf| {
            let path = file.strip_prefix(&source).unwrap().to_string_lossy().replace('\\', "/");
            (path, code(&fs::read_to_string(&file).unwrap()))
        };
        sources.extend(files.into_iter().map(read));
    }
    // The roots of the crates name everything.
    sources.retain(|(path, _)| !(path == "lib.rs" || path == "main.rs" || path.ends_with("tests.rs")));
    sources
}

#[test]
fn every_file_keeps_to_the_table_of_imports() {
    let mut faults = Vec::new();
    let sources = sources();
    for (path, code) in &sources {
        let module = path.split('/').next().unwrap().trim_end_matches(".rs").to_owned();
        let Some((_, allowed)) = TABLE.iter().find(|(name, _)| *name == module) else {
            faults.push(format!("{path}: the module {module} is not in the table"));
            continue;
        };
        for import in imports(code) {
            let own = import == module || LEAVES.contains(&import.as_str());
            if !own && !allowed.contains(&import.as_str()) {
                faults.push(format!("{path} imports crate::{import}"));
            }
        }
        for (library, _) in LIBRARIES.iter().filter(|(_, who)| !who.contains(&module.as_str())) {
            if names(code, library) {
                faults.push(format!("{path} names {library}"));
            }
        }
        if code.contains("std::fs") && !FILES.contains(&module.as_str()) {
            faults.push(format!("{path} touches the file system"));
        }
    }
    for (module, allowed) in TABLE {
        for name in allowed.iter().chain([module]) {
            let there = sources.iter().any(|(path, _)| module_of(path)[0] == *name);
            if !there {
                faults.push(format!("the row of {module} names {name}, which does not exist"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn files_of_a_module_do_not_name_each_other_in_circles() {
    let sources = sources();
    let modules: BTreeSet<Names> = sources.iter().map(|(path, _)| module_of(path)).collect();
    // What a module hands on: `pub use child::Name` makes Name a name for the child.
    let mut handed_on: BTreeMap<Names, Names> = BTreeMap::new();
    for (path, code) in &sources {
        let module = module_of(path);
        for child in modules.iter().filter(|m| m.len() == module.len() + 1 && m.starts_with(&module)) {
            let name = &child[module.len()];
            for (at, _) in code.match_indices(&format!("use {name}::")) {
                let mut found = Vec::new();
                tree(&code[at + 4..], &module, &mut found);
                for path in found {
                    let mut short = module.clone();
                    short.extend(path.last().cloned());
                    handed_on.insert(short, child.clone());
                }
            }
        }
    }
    // For each folder: which of its files names which other one.
    let mut arrows: BTreeMap<Names, BTreeSet<(String, String)>> = BTreeMap::new();
    for (path, code) in &sources {
        let module = module_of(path);
        for path in paths(code) {
            let mut target = resolved(&path, &module);
            for length in (1..=target.len()).rev() {
                if let Some(child) = handed_on.get(&target[..length]) {
                    target.splice(..length, child.iter().cloned());
                    break;
                }
            }
            let common = module.iter().zip(&target).take_while(|(a, b)| a == b).count();
            let is_file = target.len() > common && modules.contains(&target[..=common]);
            if common > 0 && common < module.len() && is_file {
                let arrow = (module[common].clone(), target[common].clone());
                arrows.entry(module[..common].to_vec()).or_default().insert(arrow);
            }
        }
    }
    let mut found: Vec<(String, Vec<String>)> = Vec::new();
    for (folder, arrows) in &arrows {
        found.extend(circles(arrows).into_iter().map(|circle| (folder.join("::"), circle)));
    }
    assert!(found.is_empty(), "files that name each other in a circle: {found:?}");
}

/// The names to which arrows lead.
fn reach<'a>(arrows: &'a BTreeSet<(String, String)>, from: &'a String) -> BTreeSet<&'a String> {
    let mut seen = BTreeSet::new();
    let mut open = vec![from];
    while let Some(at) = open.pop() {
        let next = arrows.iter().filter(|(a, _)| a == at).map(|(_, b)| b);
        open.extend(next.filter(|b| seen.insert(*b)));
    }
    seen
}

/// The groups of names that lead to each other.
fn circles(arrows: &BTreeSet<(String, String)>) -> Vec<Vec<String>> {
    let names: BTreeSet<&String> = arrows.iter().flat_map(|(a, b)| [a, b]).collect();
    let mut found: BTreeSet<Vec<String>> = BTreeSet::new();
    for name in names {
        let circle: Vec<String> =
            reach(arrows, name).into_iter().filter(|other| reach(arrows, other).contains(name)).cloned().collect();
        if circle.len() > 1 {
            found.insert(circle);
        }
    }
    found.into_iter().collect()
}

/// A method that a module adds to a type of another one makes that type seem to know what it must not know.
#[test]
fn no_module_adds_methods_to_the_types_of_another() {
    let mut found = Vec::new();
    for (path, code) in sources() {
        let module = module_of(&path);
        let foreign: BTreeSet<String> = paths(&code)
            .into_iter()
            .map(|path| resolved(&path, &module))
            .filter(|target| target.len() > 1 && target[0] != module[0])
            .filter_map(|target| target.last().cloned())
            .collect();
        for (at, _) in code.match_indices("\nimpl ") {
            let name = word(&code[at + 6..]);
            let rest = code[at + 6 + name.len()..].trim_start();
            if rest.starts_with('{') && foreign.contains(name) {
                found.push((path.clone(), name.to_owned()));
            }
        }
    }
    assert_eq!(found, []);
}

#[test]
fn imports_are_seen_in_every_form() {
    let text = "use crate::a::{B, c};\nuse crate::{d::{E, f}, g};\n// crate::no\nlet x = crate::h::i();\n#[cfg(test)]\nmod t { use crate::no; }";
    let found: Vec<String> = imports(&code(text)).into_iter().collect();
    assert_eq!(found, ["a", "d", "g", "h"]);
    assert!(names("use egui::Ui;", "egui") && !names("let x = my_egui::x;", "egui"));
}

#[test]
fn paths_and_circles_are_found() {
    let text =
        "use super::{a::{B, c as d}, e};\nlet x = crate::f::g(self::h::I);\nuse other::super_::x;\nuse super::j::*;";
    let found: Vec<String> = paths(text).into_iter().map(|path| path.join(" ")).collect();
    assert_eq!(found, ["crate f g", "super a B", "super a c", "super e", "super j", "self h I"]);
    let module = module_of("m/n.rs");
    assert_eq!(resolved(&["super".into(), "o".into()], &module), ["m", "o"]);
    let arrow = |a: &str, b: &str| (a.to_owned(), b.to_owned());
    let arrows = [arrow("a", "b"), arrow("b", "c"), arrow("c", "a"), arrow("c", "d"), arrow("e", "a")].into();
    assert_eq!(circles(&arrows), [["a", "b", "c"]]);
}
