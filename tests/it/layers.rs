//! Who may use whom inside a crate. Between crates, Cargo says it.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Modules of the engine that anybody may use.
const LEAVES: &[&str] = &["appearance", "sanitize", "limits", "listed", "progress", "stage"];

/// A module, and the modules of its own crate that it may use, besides [`LEAVES`].
type Row = (&'static str, &'static [&'static str]);

/// The folder of each crate, with its modules.
const CRATES: [(&str, &[Row]); 7] = [
    (
        "crates/engine/src",
        &[
            ("geometry", &[]),
            ("numbers", &[]),
            // The sine of whole degrees is exact there.
            ("expression", &["geometry"]),
            ("camera", &["geometry", "numbers", "expression"]),
            ("chain", &["camera", "geometry", "numbers"]),
            ("scene", &["geometry", "text"]),
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
            ("explain", &["inspect"]),
            ("views", &["figure", "inspect"]),
            ("export", &["chart", "formula"]),
            ("picture", &["figure", "views", "export"]),
        ],
    ),
    (
        "crates/teaching/src",
        &[("clock", &[]), ("numerics", &["clock"]), ("exercises", &[]), ("lessons", &["exercises", "numerics"])],
    ),
    // Its files are one module.
    ("crates/files/src", &[]),
    (
        "crates/words/src",
        &[
            ("command_line", &["messages"]),
            ("handout", &["learn", "pictures", "why"]),
            ("learn", &["messages", "why", "window"]),
            ("class", &["handout", "learn", "messages"]),
            ("messages", &["window"]),
            ("pictures", &["why", "window"]),
            ("why", &["messages", "pictures", "window"]),
            ("window", &["messages", "why"]),
        ],
    ),
    // Its files are one module, too.
    ("crates/desk/src", &[]),
    ("src", &[("cli", &[]), ("gui", &[])]),
];

/// The rooms of the window that serve every feature, and those of them that each may use. `app` uses every room.
const SHARED_ROOMS: &[Row] = &[("kit", &[])];

/// The crate, and the modules of the program, that may open files.
const FILES: &str = "crates/files/src";
const SHELLS: &[&str] = &["cli", "gui"];

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
    let tests = ["#[cfg(test)]\nmod ", "#[cfg(all(test"].iter().filter_map(|start| text.find(start)).min();
    let end = tests.unwrap_or(text.len());
    let lines = text[..end].lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

fn word(text: &str) -> &str {
    let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    &text[..end]
}

/// A path as it is written: `super::a::{b, c}` is two. Only paths that begin with `crate`, `super` or `self`.
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

/// Reads one branch of a tree of paths. Returns how many bytes it takes.
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
                // Text that is neither name nor brace, such as `as other` or `*`, is passed over.
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

/// The module of a file: `scene/obj.rs` is scene, obj, and `scene/mod.rs` is scene.
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

/// An unused permission is a fault too.
#[test]
fn modules_use_only_the_imports_that_the_table_allows() {
    let mut faults = Vec::new();
    for (folder, table) in CRATES {
        let mut unused: BTreeSet<(&str, &str)> =
            table.iter().flat_map(|(module, allowed)| allowed.iter().map(|name| (*module, *name))).collect();
        let own = |name: &str| table.iter().any(|(module, _)| *module == name);
        for (path, code) in sources(folder) {
            let module = path.split('/').next().unwrap().trim_end_matches(".rs").to_owned();
            let row = table.iter().find(|(name, _)| *name == module);
            if row.is_none() && !table.is_empty() && !LEAVES.contains(&module.as_str()) {
                faults.push(format!("{folder}/{path}: the module {module} is not in the table"));
            }
            for import in imports(&code).into_iter().filter(|import| *import != module && own(import)) {
                unused.retain(|permission| *permission != (module.as_str(), import.as_str()));
                if !row.is_some_and(|(_, allowed)| allowed.contains(&import.as_str())) {
                    faults.push(format!("{folder}/{path} uses {import}"));
                }
            }
            if code.contains("std::fs") && folder != FILES && !SHELLS.contains(&module.as_str()) {
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

/// A feature of the window uses the modules that serve every feature, and never another feature or the whole window.
#[test]
fn features_of_the_window_do_not_use_each_other() {
    let mut faults = Vec::new();
    for (path, code) in sources("src") {
        let module = module_of(&path);
        let [gui, room, ..] = &module[..] else { continue };
        if gui != "gui" || room == "app" {
            continue;
        }
        let row = SHARED_ROOMS.iter().find(|(shared, _)| shared == room);
        let may_use = |other: &str| match row {
            Some((_, allowed)) => allowed.contains(&other),
            None => SHARED_ROOMS.iter().any(|(shared, _)| *shared == other),
        };
        for used in paths(&code).iter().map(|path| resolved(path, &module)) {
            let [root, other, ..] = &used[..] else { continue };
            let is_whole = used.iter().any(|name| name == "State");
            let is_room = other.chars().next().is_some_and(char::is_lowercase);
            if root == "gui" && (is_whole || is_room && other != room && !may_use(other)) {
                faults.push(format!("{path} uses {}", used.join("::")));
            }
        }
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

/// The groups of files of a module that lead to each other, over any number of files.
fn circles_in(sources: &[(String, String)]) -> Vec<Vec<String>> {
    let modules: BTreeSet<Names> = sources.iter().map(|(path, _)| module_of(path)).collect();
    let file_of =
        |path: &[String]| (1..=path.len()).rev().map(|end| path[..end].to_vec()).find(|m| modules.contains(m));
    // A module hands on names of the files below it: `pub use child::Name` makes Name a name of the child.
    let mut handed_on: BTreeMap<Names, Names> = BTreeMap::new();
    for (path, code) in sources {
        let module = module_of(path);
        for child in modules.iter().filter(|m| m.len() == module.len() + 1 && m.starts_with(&module)) {
            for (at, _) in code.match_indices(&format!("use {}::", child[module.len()])) {
                let mut found = Vec::new();
                tree(&code[at + 4..], &module, &mut found);
                for path in found {
                    let mut short = module.clone();
                    short.extend(path.last().cloned());
                    handed_on.extend(file_of(&path).map(|file| (short, file)));
                }
            }
        }
    }
    let mut arrows: BTreeMap<Names, BTreeSet<Names>> = BTreeMap::new();
    for (path, code) in sources {
        let module = module_of(path);
        for path in paths(code) {
            let target = resolved(&path, &module);
            let known = (1..=target.len()).rev().find_map(|end| handed_on.get(&target[..end]).cloned());
            let Some(file) = known.or_else(|| file_of(&target)) else { continue };
            // A module and the files below it are one thing. The state of the window names every feature, and `app`
            // takes it whole.
            let is_state = [&file, &module].iter().any(|names| names.join("::") == "gui::app::state");
            if !is_state && file[0] == module[0] && !file.starts_with(&module) && !module.starts_with(&file) {
                arrows.entry(module.clone()).or_default().insert(file);
            }
        }
    }
    circles(&arrows)
}

/// The names to which arrows lead.
fn reach<'a>(arrows: &'a BTreeMap<Names, BTreeSet<Names>>, from: &'a Names) -> BTreeSet<&'a Names> {
    let (mut reached, mut open) = (BTreeSet::new(), vec![from]);
    while let Some(at) = open.pop() {
        open.extend(arrows.get(at).into_iter().flatten().filter(|next| reached.insert(*next)));
    }
    reached
}

/// The groups of names that lead to each other.
fn circles(arrows: &BTreeMap<Names, BTreeSet<Names>>) -> Vec<Vec<String>> {
    let all: BTreeMap<&Names, BTreeSet<&Names>> = arrows.keys().map(|name| (name, reach(arrows, name))).collect();
    let back = |from: &Names, to: &Names| all.get(to).is_some_and(|reached| reached.contains(from));
    let group = |(name, reached): (&&Names, &BTreeSet<&Names>)| {
        let circle: Vec<String> =
            reached.iter().filter(|other| back(name, other)).map(|name| name.join("::")).collect();
        (circle.len() > 1).then_some(circle)
    };
    all.iter().filter_map(group).collect::<BTreeSet<_>>().into_iter().collect()
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
    let name = |name: &str| vec![name.to_owned()];
    let arrow = |(from, to): (&str, &[&str])| (name(from), to.iter().map(|to| name(to)).collect());
    let arrows = [("a", &["b"][..]), ("b", &["c"]), ("c", &["a", "d"]), ("e", &["a"])].map(arrow).into();
    assert_eq!(circles(&arrows), [["a", "b", "c"]]);
}
