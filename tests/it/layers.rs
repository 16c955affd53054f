//! Who may use whom inside a crate. Between crates, Cargo says it.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Modules of the engine that anybody may use.
const LEAVES: &[&str] = &["appearance", "sanitize", "limits", "progress", "stage"];

/// The modules of each crate, each with the modules of its own crate that it may use, besides [`LEAVES`].
const CRATES: [(&str, &[(&str, &[&str])]); 4] = [
    (
        "crates/engine/src",
        &[
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
        ],
    ),
    (
        "crates/figures/src",
        &[
            ("chart", &[]),
            ("formula", &[]),
            ("figure", &["formula"]),
            ("inspect", &["figure"]),
            ("explain", &["figure", "inspect"]),
            ("views", &["figure", "formula"]),
            ("export", &["chart", "formula", "inspect"]),
            ("picture", &["figure", "views", "export"]),
        ],
    ),
    (
        "crates/teaching/src",
        &[("clock", &[]), ("numerics", &["clock"]), ("exercises", &[]), ("lessons", &["exercises", "numerics"])],
    ),
    (
        "src",
        &[
            ("share", &[]),
            ("files", &["share"]),
            ("i18n", &["files", "share"]),
            ("cli", &["files", "i18n", "share"]),
            ("gui", &["files", "i18n", "share"]),
        ],
    ),
];

/// The modules that may open files.
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

/// Path and program text of every file of a crate.
fn sources(folder: &str) -> Vec<(String, String)> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files = Vec::new();
    rust_files(&source, &mut files);
    assert!(files.len() > 10, "the sources are not where they were");
    files.sort();
    let read = |file: PathBuf| {
        let path = file.strip_prefix(&source).unwrap().to_string_lossy().replace('\\', "/");
        (path, code(&fs::read_to_string(&file).unwrap()))
    };
    let mut sources: Vec<_> = files.into_iter().map(read).collect();
    // The root of a crate names everything.
    sources.retain(|(path, _)| !(path == "lib.rs" || path == "main.rs" || path.ends_with("tests.rs")));
    sources
}

/// What a permission is for is found in the code: one that nobody uses is a fault too.
#[test]
fn modules_use_what_the_table_allows_and_nothing_else() {
    let mut faults = Vec::new();
    for (folder, table) in CRATES {
        let mut unused: BTreeSet<(&str, &str)> =
            table.iter().flat_map(|(module, allowed)| allowed.iter().map(|name| (*module, *name))).collect();
        let own = |name: &str| table.iter().any(|(module, _)| *module == name);
        for (path, code) in sources(folder) {
            let module = path.split('/').next().unwrap().trim_end_matches(".rs").to_owned();
            let row = table.iter().find(|(name, _)| *name == module);
            if row.is_none() && !LEAVES.contains(&module.as_str()) {
                faults.push(format!("{folder}/{path}: the module {module} is not in the table"));
            }
            for import in imports(&code).into_iter().filter(|import| *import != module && own(import)) {
                unused.retain(|permission| *permission != (module.as_str(), import.as_str()));
                if !row.is_some_and(|(_, allowed)| allowed.contains(&import.as_str())) {
                    faults.push(format!("{folder}/{path} uses {import}"));
                }
            }
            if code.contains("std::fs") && !FILES.contains(&module.as_str()) {
                faults.push(format!("{folder}/{path} opens files"));
            }
            if code.contains("egui::") && module != "gui" {
                faults.push(format!("{folder}/{path} names egui"));
            }
        }
        faults.extend(unused.iter().map(|(module, name)| format!("{folder}: {module} does not use {name}")));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn files_of_a_module_do_not_name_each_other_in_circles() {
    for (folder, _) in CRATES {
        let found = circles_in(&sources(folder));
        assert!(found.is_empty(), "{folder}: files that name each other in a circle: {found:?}");
    }
}

/// The circles of each folder, with the folder.
fn circles_in(sources: &[(String, String)]) -> Vec<(String, Vec<String>)> {
    let modules: BTreeSet<Names> = sources.iter().map(|(path, _)| module_of(path)).collect();
    // What a module hands on: `pub use child::Name` makes Name a name for the child.
    let mut handed_on: BTreeMap<Names, Names> = BTreeMap::new();
    for (path, code) in sources {
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
    for (path, code) in sources {
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
    found
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

#[test]
fn imports_are_seen_in_every_form() {
    let text = "use crate::a::{B, c};\nuse crate::{d::{E, f}, g};\n// crate::no\nlet x = crate::h::i();\n#[cfg(test)]\nmod t { use crate::no; }";
    let found: Vec<String> = imports(&code(text)).into_iter().collect();
    assert_eq!(found, ["a", "d", "g", "h"]);
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
