//! The texts of the sources themselves: how docs begin, and how comments wrap.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// The longest line of a comment, in characters, as of code.
const WIDTH: usize = 120;

fn rust_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("target") {
            rust_files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Path and text of every Rust file of some folders.
fn sources(folders: &[&str]) -> Vec<(String, String)> {
    let mut files = Vec::new();
    for folder in folders {
        rust_files(&Path::new(ROOT).join(folder), &mut files);
    }
    files.sort();
    let name = |file: &Path| file.strip_prefix(ROOT).unwrap().to_string_lossy().replace('\\', "/");
    files.into_iter().map(|file| (name(&file), fs::read_to_string(&file).unwrap())).collect()
}

/// A comment line that is too long. Tables and addresses cannot be wrapped, and code in docs is not either.
fn is_too_long(line: &str) -> bool {
    let comment = line.trim_start();
    let wraps = comment.starts_with("//") && !comment.trim_start_matches(['/', '!', ' ']).starts_with('|');
    wraps && line.chars().count() > WIDTH && !line.contains("://")
}

#[test]
fn comments_wrap_as_code_does() {
    let files = sources(&["src", "crates", "tests", "benches", "fuzz"]);
    assert!(files.len() > 300, "the sources are not where they were");
    let mut long = Vec::new();
    for (path, text) in &files {
        let mut is_code = false;
        for (number, line) in text.lines().enumerate() {
            is_code ^= line.trim_start().trim_start_matches(['/', '!', ' ']).starts_with("```");
            if !is_code && is_too_long(line) {
                long.push(format!("{path}:{}: {line}", number + 1));
            }
        }
    }
    assert!(long.is_empty(), "comment lines of more than {WIDTH} characters:\n{}", long.join("\n"));
    assert!(is_too_long(&format!("    /// {}", "x".repeat(WIDTH))) && !is_too_long(&"x".repeat(2 * WIDTH)));
    assert!(!is_too_long(&format!("/// | {} |", "x".repeat(WIDTH))));
}

/// Beginnings of docs that keep the reader waiting for the noun.
const VAGUE: &[&str] = &["What ", "Of what ", "In what ", "To what ", "By what ", "With what "];

/// The first lines of docs: those without a doc line before them.
fn doc_beginnings(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let docs = |line: &str| {
        let line = line.trim_start();
        line.starts_with("///") || line.starts_with("//!")
    };
    let mut was_doc = false;
    text.lines().enumerate().filter_map(move |(number, line)| {
        let begins = docs(line) && !was_doc;
        was_doc = docs(line);
        begins.then(|| (number + 1, line.trim_start().trim_start_matches(['/', '!']).trim_start()))
    })
}

fn is_vague(doc: &str) -> bool {
    VAGUE.iter().any(|beginning| doc.starts_with(beginning))
}

#[test]
fn docs_start_with_a_noun_or_a_verb() {
    let vague: Vec<String> = sources(&["src", "crates"])
        .iter()
        .flat_map(|(path, text)| {
            let found = doc_beginnings(text).filter(|(_, doc)| is_vague(doc));
            found.map(|(number, doc)| format!("{path}:{number}: {doc}")).collect::<Vec<_>>()
        })
        .collect();
    assert!(vague.is_empty(), "docs that begin with \"what\":\n{}", vague.join("\n"));
    let text = "/// What is drawn.\n/// What follows is no beginning.\nfn f() {}\n    //! Of what it is.\n";
    let found: Vec<usize> = doc_beginnings(text).filter(|(_, doc)| is_vague(doc)).map(|(number, _)| number).collect();
    assert_eq!(found, [1, 4]);
}

/// The files that a page names in backticks. A name without a root is one in the sources of a crate.
fn architecture_names(text: &str) -> Vec<&str> {
    let names = text.split('`').skip(1).step_by(2);
    names.filter(|name| name.ends_with(".rs") && !name.contains([' ', '*', '<']) && !name.contains("NAME")).collect()
}

#[test]
fn the_architecture_names_files_that_exist() {
    let text = fs::read_to_string(Path::new(ROOT).join("docs/architecture.md")).unwrap();
    let names = architecture_names(&text);
    assert!(names.len() > 20, "{}", names.len());
    let roots = ["", "src", "crates/engine/src", "crates/figures/src", "crates/teaching/src"];
    let there = |name: &str| roots.iter().any(|root| Path::new(ROOT).join(root).join(name).is_file());
    let gone: Vec<&&str> = names.iter().filter(|name| !there(name)).collect();
    assert!(gone.is_empty(), "docs/architecture.md names files that do not exist: {gone:?}");
}
