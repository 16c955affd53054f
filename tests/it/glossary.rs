//! The texts keep to the glossary: one name for one thing, in both languages.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// A row of `docs/glossary.md`.
struct Row {
    terms: [String; 2],
    /// What is not written instead, in either language.
    not: Vec<String>,
}

fn rows() -> Vec<Row> {
    let text = fs::read_to_string(Path::new(ROOT).join("docs/glossary.md")).unwrap();
    let cells = text
        .lines()
        .filter(|line| line.starts_with("| "))
        .map(|line| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<String>>());
    let rows = cells.skip(2).map(|cells| {
        assert_eq!(cells.len(), 4, "{cells:?}");
        let not = cells[3].split(',').map(|term| term.trim().to_lowercase()).filter(|term| !term.is_empty());
        Row { terms: [cells[0].clone(), cells[1].clone()], not: not.collect() }
    });
    rows.collect()
}

fn files(folder: &str, ends: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(Path::new(ROOT).join(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths.filter(|path| path.to_string_lossy().ends_with(ends)).collect()
}

#[test]
fn texts_say_what_the_glossary_says() {
    let rows = rows();
    assert!(rows.len() >= 12, "{}", rows.len());
    let texts: Vec<(PathBuf, String)> = [("src/i18n", ".rs"), ("assets/notes", ".md"), ("assets/exercises", ".md")]
        .into_iter()
        .chain([("docs", ".en.md"), ("docs", ".pt-BR.md")])
        .flat_map(|(folder, ends)| files(folder, ends))
        .map(|path| (path.clone(), fs::read_to_string(path).unwrap().to_lowercase()))
        .collect();
    let mut wrong = Vec::new();
    for Row { terms, not } in &rows {
        for term in terms {
            let is_used = texts.iter().any(|(_, text)| text.contains(&term.to_lowercase()));
            assert!(is_used, "no text has \"{term}\"");
        }
        for (path, text) in &texts {
            for (line, words) in text.lines().enumerate() {
                for term in not.iter().filter(|term| words.contains(term.as_str())) {
                    wrong.push(format!(
                        "{}:{}: {term}; the glossary has {}",
                        path.display(),
                        line + 1,
                        terms.join(", ")
                    ));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}
