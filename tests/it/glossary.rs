//! The texts keep to the glossary: one name for one thing, in both languages.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// A term that is not written, in all texts or in those of one language.
struct Banned {
    term: String,
    only: Option<&'static str>,
}

/// A row of `docs/glossary.md`.
struct Row {
    terms: [String; 2],
    banned: Vec<Banned>,
}

fn banned(term: &str) -> Banned {
    let (only, term) = match term.split_once(": ") {
        Some(("en", term)) => (Some("en"), term),
        Some(("pt", term)) => (Some("pt"), term),
        _ => (None, term),
    };
    Banned { term: term.to_lowercase(), only }
}

fn rows() -> Vec<Row> {
    let text = fs::read_to_string(Path::new(ROOT).join("docs/glossary.md")).unwrap();
    let cells = text
        .lines()
        .filter(|line| line.starts_with("| "))
        .map(|line| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<String>>());
    let rows = cells.skip(2).map(|cells| {
        assert_eq!(cells.len(), 4, "{cells:?}");
        let terms = cells[3].split(',').map(str::trim).filter(|term| !term.is_empty());
        Row { terms: [cells[0].clone(), cells[1].clone()], banned: terms.map(banned).collect() }
    });
    rows.collect()
}

fn files(folder: &str, ends: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(Path::new(ROOT).join(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths.filter(|path| path.to_string_lossy().ends_with(ends)).collect()
}

/// The files of the folder, and of the folders in it.
fn files_below(folder: &str, ends: &str) -> Vec<PathBuf> {
    let root = Path::new(ROOT).join(folder);
    let inner = fs::read_dir(&root).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    let inner = inner.flat_map(|path| files_below(&path.to_string_lossy(), ends));
    files(folder, ends).into_iter().chain(inner).collect()
}

/// The language of a file, if it has one only.
fn language(path: &Path) -> Option<&'static str> {
    let name = path.file_name().unwrap().to_string_lossy();
    let is_below = |folder: &str| path.starts_with(Path::new(ROOT).join(folder));
    match () {
        () if name.ends_with("en.md")
            || is_below("src/cli/args")
            || is_below("assets/words/en")
            || name == "README.md" =>
        {
            Some("en")
        }
        () if name.ends_with("pt-BR.md") || is_below("assets/words/pt-BR") => Some("pt"),
        () => None,
    }
}

/// The title and the caption of a figure file. Its other lines are empty.
fn said_of_itself(text: &str) -> String {
    let said = |line: &&str| ["title ", "caption "].iter().any(|key| line.starts_with(key));
    text.lines().map(|line| Some(line).filter(said).unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

/// The texts of a lesson in one language, whose key is `lang`. The rest is blank, so lines keep their numbers.
fn in_lesson(text: &str, lang: &str) -> String {
    let blank = |text: &str| text.chars().map(|c| if c == '\n' { c } else { ' ' }).collect::<String>();
    let (begin, mut out, mut rest) = (format!("{lang} = "), String::new(), text);
    while let Some(at) = rest.find(&begin) {
        let (before, after) = rest.split_at(at + begin.len());
        out += &blank(before);
        let mark = if after.starts_with("'''") { "'''" } else { "\"" };
        let inner = after.strip_prefix(mark).unwrap_or_default();
        let end = inner.find(mark).unwrap_or(inner.len());
        out += &inner[..end];
        rest = &after[after.len() - inner.len() + end..];
    }
    out + &blank(rest)
}

/// The part of a line in one language: of `name: "English", "Português";` the first text is English, and of
/// `{ en = "English", pt-BR = "Português" }`.
fn in_language<'a>(line: &'a str, only: &str, of_file: Option<&str>) -> &'a str {
    let halves = line.split_once("\", pt-br = \"").or_else(|| line.split_once("\", \""));
    let halves = halves.filter(|_| of_file.is_none());
    match (of_file, halves, only) {
        (Some(language), ..) => {
            if language == only {
                line
            } else {
                ""
            }
        }
        (None, Some((english, _)), "en") => english,
        (None, Some((_, portuguese)), _) => portuguese,
        (None, None, "en") if line.contains("lang::en") => line,
        (None, None, "pt") if line.contains("lang::ptbr") => line,
        (None, None, _) => "",
    }
}

/// Whether a text has a term as words of their own.
fn has(text: &str, term: &str) -> bool {
    text.match_indices(term).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + term.len()..].chars().next();
        !before.is_some_and(char::is_alphanumeric) && !after.is_some_and(char::is_alphanumeric)
    })
}

#[test]
fn texts_use_the_terms_of_the_glossary() {
    let rows = rows();
    assert!(rows.len() >= 40, "{}", rows.len());
    let figures = ["assets/figures", "assets/figures/pipeline", "assets/figures/extreme", "docs/figures"]
        .into_iter()
        .flat_map(|folder| files(folder, ".toml"))
        .map(|path| (path.clone(), said_of_itself(&fs::read_to_string(path).unwrap().to_lowercase())));
    let lessons = files("assets/lessons", ".toml").into_iter().flat_map(|path| {
        let text = fs::read_to_string(&path).unwrap().to_lowercase();
        [("en", "en"), ("pt-br", "pt")].map(|(key, lang)| (path.clone(), Some(lang), in_lesson(&text, key)))
    });
    let texts: Vec<(PathBuf, Option<&str>, String)> = [("assets/notes", ".md"), ("assets/exercises", ".md")]
        .into_iter()
        .chain([
            ("docs", ".en.md"),
            ("docs", ".pt-BR.md"),
            ("src/cli/args", ".rs"),
            ("", "README.md"),
            ("", "README.pt-BR.md"),
        ])
        .flat_map(|(folder, ends)| files(folder, ends))
        .chain(files_below("crates/words/src", ".rs"))
        .chain(files_below("assets/words", ".toml"))
        // The words of other books are those that the search is for.
        .filter(|path| !path.ends_with("window/search.rs"))
        .map(|path| (path.clone(), fs::read_to_string(path).unwrap().to_lowercase()))
        .chain(figures)
        .map(|(path, text)| (path.clone(), language(&path), text))
        .chain(lessons)
        .collect();
    let mut wrong = Vec::new();
    for Row { terms, banned } in &rows {
        for term in terms {
            let is_used = texts.iter().any(|(_, _, text)| has(text, &term.to_lowercase()));
            assert!(is_used, "no text has \"{term}\"");
        }
        for (path, lang, text) in &texts {
            for (number, line) in text.lines().enumerate() {
                for Banned { term, only } in banned {
                    let words = only.map_or(line, |only| in_language(line, only, *lang));
                    if has(words, term) {
                        let place = format!("{}:{}", path.display(), number + 1);
                        wrong.push(format!("{place}: {term}; the glossary has {}", terms.join(", ")));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// In Portuguese a comma begins decimals, so the numbers of a tuple stand between semicolons.
#[test]
fn tuples_in_portuguese_have_semicolons() {
    let lessons = files("assets/lessons", ".toml");
    let lessons =
        lessons.into_iter().map(|path| (path.clone(), in_lesson(&fs::read_to_string(&path).unwrap(), "pt-BR")));
    let pages = [("assets/notes", "pt-BR.md"), ("assets/exercises", "pt-BR.md")];
    let pages = pages.into_iter().flat_map(|(folder, ends)| files(folder, ends));
    let pages = pages.map(|path| (path.clone(), fs::read_to_string(&path).unwrap()));
    let is_number = |text: &str| !text.is_empty() && text.chars().all(|c| "−-/".contains(c) || c.is_ascii_digit());
    let mut wrong = Vec::new();
    for (path, text) in lessons.chain(pages) {
        for (number, line) in text.lines().enumerate() {
            for inner in line.split('(').skip(1).filter_map(|part| part.split_once(')')).map(|(inner, _)| inner) {
                if inner.contains(", ") && inner.split(", ").all(is_number) {
                    wrong.push(format!("{}:{}: ({inner})", path.display(), number + 1));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn terms_are_found_as_words_in_their_language() {
    assert!(has("a z-buffer.", "z-buffer") && !has("o quadro mestre", "estre") && !has("destroços", "destro"));
    let line = "depth: \"depth buffer\", \"z-buffer\";";
    assert!(!has(in_language(line, "en", None), "z-buffer") && has(in_language(line, "pt", None), "z-buffer"));
    assert!(in_language("z-buffer", "en", Some("pt")).is_empty());
    let lesson =
        "text = { en = '''\nA depth\nbuffer.''', pt-br = '''\nUm z-buffer.''' }\nname = { en = \"a\", pt-br = \"b\" }";
    let [en, pt] = ["en", "pt-br"].map(|key| in_lesson(lesson, key));
    assert_eq!(en.split_whitespace().collect::<Vec<_>>(), ["A", "depth", "buffer.", "a"]);
    assert_eq!(pt.lines().nth(3).map(str::trim), Some("Um z-buffer."));
    let file = "# z-buffer\ntitle = { en = \"depth buffer\", pt-br = \"z-buffer\" }\nname = \"z-buffer\"";
    let said = said_of_itself(file);
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].is_empty() && !has(in_language(lines[1], "en", None), "z-buffer"));
    assert!(has(in_language(lines[1], "pt", None), "z-buffer") && lines.len() == 2, "{lines:?}");
}
