//! Measures how the texts read, per 1,000 words, against the texts of native writers.
//!
//! Habits of a translation come back sentence by sentence, and no list of words sees them. So the habits are counted:
//! in READMEs and docs of common crates, in lecture notes in Portuguese, and here. Each group of texts has the bounds
//! of native writers, or, as long as it's above them, a ceiling that may only become lower.

#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use camera_lab_words::Lang;

use crate::words::words;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Files below `folder` whose names end with `ends`.
fn files(folder: &str, ends: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(Path::new(ROOT).join(folder)).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let found = paths.flat_map(|path| {
        let inner = path.strip_prefix(ROOT).unwrap().to_string_lossy().into_owned();
        if path.is_dir() { files(&inner, ends) } else { vec![path] }
    });
    found.filter(|path| path.to_string_lossy().ends_with(ends)).collect()
}

/// Markdown without code, formulas and addresses.
fn prose(text: &str) -> String {
    let outside = |text: &str, mark: &str| text.split(mark).step_by(2).collect::<Vec<_>>().join(" X ");
    let lines = outside(&outside(text, "```"), "`");
    let lines = lines.lines().map(|line| outside(line, "$")).collect::<Vec<_>>().join("\n");
    lines
        .split("](")
        .enumerate()
        .map(|(k, part)| if k == 0 { part } else { part.split_once(')').map_or("", |p| p.1) })
        .collect::<Vec<_>>()
        .join("] ")
}

/// The texts of a page in Markdown.
fn page(path: &str) -> String {
    prose(&fs::read_to_string(Path::new(ROOT).join(path)).unwrap())
}

/// A page whose lines may begin with the key of a text, as in `- yes: yes` and `? H: the height`.
fn keyed_page(path: &str) -> String {
    let text = fs::read_to_string(Path::new(ROOT).join(path)).unwrap();
    let told = |line: &str| {
        let keyed = line.strip_prefix("- ").or_else(|| line.strip_prefix("? "));
        let keyed = keyed.and_then(|line| line.split_once(": ")).filter(|(key, _)| !key.contains(' '));
        keyed.map_or(line, |(_, text)| text).to_owned()
    };
    prose(&text.lines().map(told).collect::<Vec<_>>().join("\n"))
}

/// The texts of the window, the command line and messages.
fn window(lang: Lang) -> String {
    prose(&words(lang).join("\n\n"))
}

/// The texts of the lessons, in the order of their files.
fn lessons(lang: Lang) -> Vec<String> {
    fn texts(value: &toml_edit::Value, key: &str, found: &mut Vec<String>) {
        match value {
            toml_edit::Value::InlineTable(table) if table.contains_key("en") => {
                found.extend(table.get(key).and_then(|text| text.as_str()).map(str::to_owned));
            }
            toml_edit::Value::InlineTable(table) => table.iter().for_each(|(_, value)| texts(value, key, found)),
            toml_edit::Value::Array(array) => array.iter().for_each(|value| texts(value, key, found)),
            _ => {}
        }
    }
    fn tables(item: &toml_edit::Item, key: &str, found: &mut Vec<String>) {
        match item {
            toml_edit::Item::Value(value) => texts(value, key, found),
            toml_edit::Item::Table(table) => table.iter().for_each(|(_, item)| tables(item, key, found)),
            toml_edit::Item::ArrayOfTables(array) => {
                array.iter().flat_map(|table| table.iter()).for_each(|(_, item)| tables(item, key, found));
            }
            toml_edit::Item::None => {}
        }
    }
    let key = if lang == Lang::En { "en" } else { "pt-BR" };
    let mut found = Vec::new();
    let mut all = files("assets/lessons", ".toml");
    all.sort();
    for path in all {
        let document: toml_edit::DocumentMut = fs::read_to_string(path).unwrap().parse().unwrap();
        tables(document.as_item(), key, &mut found);
    }
    found
}

/// The doc comments of a crate.
fn docs(folder: &str) -> String {
    let sources = files(folder, ".rs").into_iter().map(|path| fs::read_to_string(path).unwrap());
    let line = |line: &str| {
        let line = line.trim_start();
        line.strip_prefix("///").or_else(|| line.strip_prefix("//!")).unwrap_or_default().to_owned()
    };
    prose(&sources.map(|source| source.lines().map(line).collect::<Vec<_>>().join("\n")).collect::<Vec<_>>().join("\n"))
}

fn words_of(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && !"'’-".contains(c)).filter(|word| !word.is_empty())
}

/// How often each habit occurs per 1,000 words.
#[derive(Debug)]
struct Habits {
    /// `;` or `:` before a small letter.
    chains: f64,
    /// *where*; *onde*.
    places: f64,
    /// *if*; *seu, sua*.
    other: f64,
    /// *What …* as a noun.
    what: f64,
    /// Phrases that native writers don't have.
    banned: f64,
    /// Contractions and *you*; *você*.
    person: f64,
}

const BANNED: [(Lang, &[&str]); 2] = [
    (
        Lang::En,
        &[
            "held against",
            "whoever",
            "anew",
            "askew",
            "is told",
            "are told",
            "is said",
            "are said",
            "be told of",
            "fares",
        ],
    ),
    (
        Lang::PtBr,
        &[
            "é dito",
            "é dita",
            "são ditos",
            "são ditas",
            "o diz",
            "diz isso",
            "tomado como",
            "tomada como",
            "tomados como",
            "tonalização",
        ],
    ),
];

fn habits(text: &str, lang: Lang) -> Habits {
    let lower = text.to_lowercase();
    let count = words_of(&lower).count() as f64;
    let rate = |n: usize| (n as f64 * 100_000.0 / count).round() / 100.0;
    let words = |wanted: &[&str]| words_of(&lower).filter(|word| wanted.contains(word)).count();
    let phrases = |wanted: &[&str]| {
        wanted
            .iter()
            .map(|phrase| {
                lower.match_indices(*phrase).filter(|(at, _)| !lower[..*at].ends_with(char::is_alphanumeric)).count()
            })
            .sum::<usize>()
    };
    let chains = text.match_indices([';', ':']).filter(|(at, _)| {
        let rest = &text[at + 1..];
        rest.starts_with(char::is_whitespace) && rest.trim_start().starts_with(char::is_lowercase)
    });
    let (_, banned) = BANNED.into_iter().find(|(of, _)| *of == lang).unwrap();
    let contracted = |word: &&str| ["'s", "'t", "'re", "'ve", "'ll", "’s", "’t"].iter().any(|end| word.ends_with(end));
    let person = match lang {
        Lang::En => words_of(&lower).filter(contracted).count() + words(&["you", "your", "yours", "yourself"]),
        _ => words(&["você", "vocês"]),
    };
    let [places, other]: [&[&str]; 2] = match lang {
        Lang::En => [&["where"], &["if"]],
        _ => [&["onde"], &["seu", "seus", "sua", "suas"]],
    };
    // Questions may ask for a place.
    let told =
        lower.split_inclusive(['.', '?', '!', '|']).filter(|sentence| !sentence.ends_with('?')).collect::<String>();
    let asked_places = words_of(&told).filter(|word| places.contains(word)).count();
    let what = [
        "with what",
        "of what",
        "for what",
        "as what",
        "by what",
        "from what",
        "says what",
        "shows what",
        "keeps what",
    ];
    Habits {
        chains: rate(chains.count()),
        places: rate(asked_places),
        other: rate(words(other)),
        what: if lang == Lang::En { rate(phrases(&what)) } else { 0.0 },
        banned: rate(phrases(banned)),
        person: rate(person),
    }
}

/// The most that a group may have of each habit, and the least of the words for persons.
struct Bounds {
    chains: f64,
    /// In English as a multiple of *if*, in Portuguese per 1,000 words.
    places: f64,
    /// *seu, sua*; no bound in English.
    possessives: f64,
    what: f64,
    banned: f64,
    person: f64,
}

/// The bounds of native writers.
const NATIVE: Bounds =
    Bounds { chains: 15.0, places: 3.0, possessives: f64::INFINITY, what: 0.6, banned: 0.4, person: 6.0 };
const NATIVE_PT: Bounds = Bounds { chains: 18.0, places: 2.0, possessives: 5.0, what: 0.0, banned: 0.4, person: 0.0 };

/// The habits that are above their bounds, in words.
fn faults(name: &str, text: &str, lang: Lang, most: &Bounds) -> Vec<String> {
    let found = habits(text, lang);
    let places = if lang == Lang::En { most.places * found.other } else { most.places };
    let possessives = if lang == Lang::En { 0.0 } else { found.other };
    let rows = [
        ("; or : before a small letter", found.chains, most.chains),
        ("where, onde", found.places, places),
        ("seu, sua", possessives, most.possessives),
        ("what as a noun", found.what, most.what),
        ("banned phrases", found.banned, most.banned),
        ("contractions and you, at least", most.person, found.person),
    ];
    let above = rows.into_iter().enumerate().filter(|(_, (_, found, most))| found > most);
    above
        .map(|(row, (habit, found, most))| {
            let lines = worst(text, lang, row).join("\n    ");
            format!("{name}: {habit}: {found:.2}, allowed {most:.2}; the worst lines:\n    {lines}")
        })
        .collect()
}

/// The ten lines of a text that have a habit most often, each with its place. `row` is the habit's place among those of
/// `faults`.
fn worst(text: &str, lang: Lang, row: usize) -> Vec<String> {
    let often = |line: &str| {
        let found = habits(line, lang);
        let rates = [found.chains, found.places, found.other, found.what, found.banned, 0.0];
        // How often, not how often for each word: a short line isn't worse than a long one.
        rates[row] * words_of(line).count() as f64
    };
    let mut lines: Vec<(f64, &str)> = text.lines().map(|line| (often(line), line)).filter(|(n, _)| *n > 0.0).collect();
    lines.sort_by(|one, other| other.0.total_cmp(&one.0));
    lines.iter().take(10).map(|(_, line)| format!("{}: {}", place(line), line.trim())).collect()
}

/// The file and the line of a text, by its longest part without code and formulas.
fn place(line: &str) -> String {
    static SOURCES: LazyLock<Vec<(PathBuf, String)>> = LazyLock::new(|| {
        let folders = ["docs", "assets", "src", "crates"].into_iter();
        let found =
            folders.flat_map(|folder| [".md", ".toml", ".rs"].into_iter().flat_map(move |ends| files(folder, ends)));
        let top =
            ["README.md", "README.pt-BR.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(|name| Path::new(ROOT).join(name));
        found.chain(top).map(|path| (path.clone(), fs::read_to_string(path).unwrap())).collect()
    });
    let part = line
        .split([']', '\\', '"'])
        .flat_map(|part| part.split(" X "))
        .max_by_key(|part| part.len())
        .unwrap_or(line)
        .trim();
    let found = SOURCES.iter().find_map(|(path, text)| Some((path, text[..text.find(part)?].lines().count().max(1))));
    found.map_or_else(
        || "?".to_owned(),
        |(path, at)| format!("{}:{at}", path.strip_prefix(ROOT).unwrap_or(path).display()),
    )
}

/// The groups of texts, each with its bounds. A bound that isn't the native one is a ceiling: today's value, to be
/// lowered.
fn groups(lang: Lang) -> Vec<(&'static str, String, Bounds)> {
    let pages = |names: &[&str]| names.iter().map(|name| page(name)).collect::<Vec<_>>().join("\n\n");
    let guides = ["student", "lecturer", "author", "command-line", "without-rust"];
    match lang {
        Lang::En => vec![
            ("README", page("README.md"), NATIVE),
            ("guides", pages(&guides.map(|name| format!("docs/{name}.en.md")).each_ref().map(String::as_str)), NATIVE),
            ("to join", pages(&["CONTRIBUTING.md", "CHANGELOG.md"]), NATIVE),
            (
                "other docs",
                pages(&[
                    "docs/architecture.md",
                    "docs/cameras.en.md",
                    "docs/equations.md",
                    "docs/limits.md",
                    "docs/numerics.en.md",
                    "docs/performance.md",
                    "docs/testing.md",
                    "docs/web.md",
                ]),
                NATIVE,
            ),
            ("window", window(lang), Bounds { chains: 23.0, ..NATIVE }),
            ("lessons", prose(&lessons(lang).join("\n\n")), NATIVE),
            (
                "exercises and reference pages",
                ["assets/exercises/en.md", "assets/notes/en.md"].map(keyed_page).join("\n\n"),
                Bounds { chains: 15.0, ..NATIVE },
            ),
            (
                "doc comments",
                [
                    "crates/engine/src",
                    "crates/figures/src",
                    "crates/teaching/src",
                    "crates/words/src",
                    "crates/files/src",
                    "src",
                ]
                .map(docs)
                .join("\n"),
                Bounds { person: 0.0, ..NATIVE },
            ),
        ],
        _ => vec![
            ("README", page("README.pt-BR.md"), NATIVE_PT),
            (
                "guides",
                pages(&guides.map(|name| format!("docs/{name}.pt-BR.md")).each_ref().map(String::as_str)),
                NATIVE_PT,
            ),
            ("other docs", pages(&["docs/cameras.pt-BR.md", "docs/numerics.pt-BR.md"]), NATIVE_PT),
            ("window", window(lang), Bounds { chains: 23.0, ..NATIVE_PT }),
            ("lessons", prose(&lessons(lang).join("\n\n")), NATIVE_PT),
            (
                "exercises and reference pages",
                ["assets/exercises/pt-BR.md", "assets/notes/pt-BR.md"].map(keyed_page).join("\n\n"),
                NATIVE_PT,
            ),
        ],
    }
}

#[test]
fn texts_read_as_native_ones_do() {
    for lang in [Lang::En, Lang::PtBr] {
        let groups = groups(lang);
        let faults: Vec<String> =
            groups.iter().flat_map(|(name, text, bounds)| faults(name, text, lang, bounds)).collect();
        let counts = groups.iter().map(|(name, text, _)| format!("{name}: {:.2?}", habits(text, lang)));
        assert!(faults.is_empty(), "{lang:?}\n{}\nall:\n{}", faults.join("\n"), counts.collect::<Vec<_>>().join("\n"));
    }
}

/// True if an English text says why: *because*, or *so* before a sentence.
fn tells_a_cause(text: &str) -> bool {
    // *And so does the depth* compares, and *so far* counts.
    const OTHERS: [&str; 20] = [
        "is", "are", "was", "were", "has", "have", "had", "does", "do", "did", "will", "would", "can", "could", "much",
        "many", "far", "that", "long", "as",
    ];
    let lower = text.to_lowercase();
    let after_so =
        |so: &str| lower.split(so).skip(1).filter_map(|rest| words_of(rest).next().map(str::to_owned)).collect();
    let after: Vec<String> = [", so ", ". so "].into_iter().flat_map(|so| -> Vec<String> { after_so(so) }).collect();
    lower.contains("because") || after.iter().any(|word| !OTHERS.contains(&word.as_str()))
}

/// True if a Portuguese text has a word for a cause.
fn has_connective(text: &str) -> bool {
    const CONNECTIVES: [&str; 16] = [
        "por isso",
        "por que",
        "por causa",
        "para que",
        "de modo que",
        "já que",
        "uma vez que",
        "ou seja",
        "isto é",
        "porque",
        "pois",
        "então",
        "logo",
        "portanto",
        "assim",
        "daí",
    ];
    let words: Vec<&str> = words_of(text).collect();
    let text = format!(" {} ", words.join(" ").to_lowercase());
    CONNECTIVES.iter().any(|word| text.contains(&format!(" {word} ")))
}

#[test]
fn a_cause_in_english_is_one_in_portuguese() {
    let lines = |path: &str| -> Vec<String> {
        fs::read_to_string(Path::new(ROOT).join(path)).unwrap().lines().map(str::to_owned).collect()
    };
    let of_language = |lang: Lang| {
        let pages = ["exercises", "notes"].map(|folder| lines(&format!("assets/{folder}/{}.md", lang.tag())));
        [words(lang), lessons(lang)].into_iter().chain(pages)
    };
    let mut lost = Vec::new();
    for (english, portuguese) in of_language(Lang::En).zip(of_language(Lang::PtBr)) {
        assert_eq!(english.len(), portuguese.len(), "a text in one language has its place in the other");
        let pairs = english.iter().zip(&portuguese);
        lost.extend(
            pairs.filter(|(en, pt)| tells_a_cause(en) && !has_connective(pt)).map(|(en, pt)| format!("{en}\n  {pt}")),
        );
    }
    assert!(lost.is_empty(), "without a connective such as *por isso* or *pois*:\n{}", lost.join("\n"));
    assert!(
        tells_a_cause("w is 0, so it has no image") && !tells_a_cause("It grows, and so does w. So far it's right.")
    );
    assert!(has_connective("w é 0, por isso não tem imagem.") && !has_connective("w é 0, e não tem imagem; logotipo"));
}

#[test]
fn habits_of_a_translation_are_found() {
    let strange =
        "Where nothing is typed, what is said is held against what was there; whoever reads it is told: so it is.";
    assert_eq!(faults("", strange, Lang::En, &NATIVE).len(), 4);
    let said = faults(
        "guides",
        &page("docs/student.en.md").replace("If ", "Where "),
        Lang::En,
        &Bounds { places: 0.0, ..NATIVE },
    );
    assert!(said[0].contains("docs/student.en.md:"), "{}", said[0]);
    let native = "If you don't type anything, the window keeps your last value. It's compared with the file.";
    assert_eq!(faults("", native, Lang::En, &NATIVE), [""; 0]);
    let strange = "Onde seu arquivo não existe, isso é dito; sua cópia fica em seu lugar.";
    assert_eq!(faults("", strange, Lang::PtBr, &NATIVE_PT).len(), 4);
    assert_eq!(prose("Read `where`, $if$ and [this](where.md)."), "Read  X ,  X  and [this] .");
}
