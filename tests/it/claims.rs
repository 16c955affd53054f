//! Claims of the pages, compared with the program: numbers of things, names of buttons and menus, options, and paths.
//! Each failure names the file and the line.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use camera_lab::camera::Program;
use camera_lab::exercises::families;
use camera_lab::export::format::PictureFormat;
use camera_lab::lessons::shipped;
use camera_lab::numerics::Study;
use camera_lab_files::SHIPPED_FIGURES;
use camera_lab_words::{Lang, window};

use crate::common::program::Bench;
use crate::words::{files_below, words};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// A Markdown file that people read.
struct Page {
    /// From the project's folder.
    path: String,
    lang: Lang,
    text: String,
}

impl Page {
    fn place(&self, line: usize) -> String {
        format!("{}:{}", self.path, line + 1)
    }

    /// The lines outside of code, numbered from 0.
    fn prose(&self) -> impl Iterator<Item = (usize, &str)> {
        let mut in_code = false;
        self.text.lines().enumerate().filter(move |(_, line)| {
            let fence = line.trim_start().starts_with("```");
            in_code ^= fence;
            !in_code && !fence
        })
    }
}

static PAGES: LazyLock<Vec<Page>> = LazyLock::new(|| {
    let docs = std::fs::read_dir(Path::new(ROOT).join("docs")).expect("the folder of the guides exists");
    let docs = docs.flatten().map(|entry| format!("docs/{}", entry.file_name().to_string_lossy()));
    let docs = docs.filter(|path| path.ends_with(".md"));
    let first = ["README.md", "README.pt-BR.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(str::to_owned);
    let mut paths: Vec<String> = first.into_iter().chain(docs).collect();
    paths.sort();
    paths
        .into_iter()
        .map(|path| Page {
            text: std::fs::read_to_string(Path::new(ROOT).join(&path)).expect("a page can be read"),
            lang: if path.ends_with(".pt-BR.md") { Lang::PtBr } else { Lang::En },
            path,
        })
        .collect()
});

fn assert_none(faults: &[String]) {
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

/// The number that a word stands for.
fn number(word: &str, lang: Lang) -> Option<usize> {
    let words: &[&str] = match lang {
        Lang::En => &[
            "two",
            "three",
            "four",
            "five",
            "six",
            "seven",
            "eight",
            "nine",
            "ten",
            "eleven",
            "twelve",
            "thirteen",
            "fourteen",
            "fifteen",
            "sixteen",
            "seventeen",
            "eighteen",
            "nineteen",
            "twenty",
        ],
        _ => &[
            "duas",
            "três",
            "quatro",
            "cinco",
            "seis",
            "sete",
            "oito",
            "nove",
            "dez",
            "onze",
            "doze",
            "treze",
            "catorze",
            "quinze",
            "dezesseis",
            "dezessete",
            "dezoito",
            "dezenove",
            "vinte",
        ],
    };
    let word = word.to_lowercase();
    let word = if word == "dois" { "duas" } else { &word };
    words.iter().position(|one| *one == word).map(|at| at + 2).or_else(|| word.parse().ok().filter(|n| *n > 1))
}

#[test]
fn numbers_of_things_are_those_of_the_program() {
    let counts = [
        (["lessons", "lições"], shipped().len()),
        (["studies", "estudos"], Study::ALL.len()),
        (["choices of a graphics programmer", "escolhas de quem programa gráficos"], Study::ALL.len()),
        (["programs", "programas"], Program::ALL.len()),
        (["families of exercises", "famílias de exercícios"], families::ENTRIES.len()),
        (["figures of the gallery", "figuras da galeria"], SHIPPED_FIGURES.len()),
    ];
    let (mut faults, mut compared) = (Vec::new(), 0);
    for page in PAGES.iter() {
        for (at, line) in page.prose() {
            let words: Vec<&str> = line.split_whitespace().collect();
            for (k, claimed) in words.iter().enumerate().filter_map(|(k, word)| Some((k, number(word, page.lang)?))) {
                let rest = words[k + 1..].join(" ").to_lowercase();
                for ([en, pt], count) in counts {
                    let name = if page.lang == Lang::En { en } else { pt };
                    let follows = rest.strip_prefix(name).is_some_and(|rest| !rest.starts_with(char::is_alphabetic));
                    if follows && claimed != count {
                        faults.push(format!("{}: {claimed} {name}; the program has {count}", page.place(at)));
                    }
                    compared += usize::from(follows);
                }
            }
        }
    }
    assert_none(&faults);
    assert!(compared >= 8, "only {compared} numbers were compared");
}

/// Every text of the window, and every title of a lesson, an exercise, a figure or a reference page.
fn names(lang: Lang) -> BTreeSet<String> {
    let root = Path::new(ROOT);
    let read = |path: PathBuf| std::fs::read_to_string(path).expect("a source can be read");
    let (key, page) = if lang == Lang::En { ("en = ", "en.md") } else { ("pt-BR = ", "pt-BR.md") };
    let titles = files_below(&root.join("assets"), ".toml").into_iter().flat_map(|path| {
        let text = read(path);
        let titles = text.lines().filter(|line| line.starts_with("title"));
        titles.filter_map(|line| Some(line.split_once(key)?.1.split('"').nth(1)?.to_owned())).collect::<Vec<_>>()
    });
    let headings = ["assets/exercises", "assets/notes"].into_iter().flat_map(|folder| {
        let text = read(root.join(folder).join(page));
        let headings = text.lines().filter(|line| line.starts_with('#'));
        headings.filter_map(|line| Some(line.split_once(": ")?.1.to_owned())).collect::<Vec<_>>()
    });
    let known = words(lang).into_iter().chain(titles).chain(headings);
    known.map(|name| name.trim_end_matches(['…', ':', '▾']).trim().to_lowercase()).collect()
}

/// Names that a guide emphasizes and that belong to others: to systems, to Blender, to the lecture notes.
const OF_OTHERS: [&str; 15] = [
    "Question bank",
    "Import",
    "Moodle XML format",
    "Banco de questões",
    "Importar",
    "Formato Moodle XML",
    "Auto",
    "Fit",
    "Câmera Virtual",
    "Open with",
    "Abrir com",
    "More info",
    "Mais informações",
    "Run anyway",
    "Executar assim mesmo",
];

#[test]
fn names_of_buttons_and_menus_are_those_of_the_window() {
    let known = [Lang::En, Lang::PtBr].map(|lang| (lang, names(lang)));
    let (mut faults, mut compared) = (Vec::new(), 0);
    let guides = ["student", "lecturer", "author", "command-line", "cameras", "without-rust", "README"];
    for page in PAGES.iter().filter(|page| guides.iter().any(|guide| page.path.contains(guide))) {
        let (_, known) = known.iter().find(|(lang, _)| *lang == page.lang).expect("every language has its names");
        for (at, line) in page.prose() {
            let outside_code: String = line.split('`').step_by(2).collect::<Vec<_>>().join("`");
            let plain = outside_code.replace("**", "");
            for emphasized in plain.split('*').skip(1).step_by(2) {
                // Names begin with a capital letter. Others are emphasis, or letters of mathematics.
                let is_name = emphasized.chars().next().is_some_and(char::is_uppercase) && emphasized.len() > 1;
                for name in emphasized.split('▸').map(str::trim).filter(|_| is_name) {
                    let plain = name.trim_end_matches(['…', ':', '▾', '.', ',']).trim();
                    compared += 1;
                    if !known.contains(&plain.to_lowercase()) && !OF_OTHERS.contains(&plain) {
                        faults.push(format!("{}: *{name}* is no name in the window", page.place(at)));
                    }
                }
            }
        }
    }
    assert_none(&faults);
    assert!(compared > 200, "only {compared} names were compared");
}

/// The commands in a text of help: the words that begin a line of their section.
fn commands(help: &str) -> Vec<&str> {
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| line.starts_with("  "));
    lines.filter(|line| !line.starts_with("   ")).filter_map(|line| line.split_whitespace().next()).collect()
}

/// The text of `--help` after these words.
fn help(bench: &Bench, words: &str) -> String {
    let output = bench.command(&words.split_whitespace().chain(["--help"]).collect::<Vec<_>>()).output();
    String::from_utf8_lossy(&output.expect("the program runs").stdout).into_owned()
}

/// Every command with its help, and those below it: `lesson`, `lesson check`. The first one is the program.
fn all_commands(bench: &Bench) -> Vec<(String, String)> {
    let mut all = vec![(String::new(), help(bench, ""))];
    let mut at = 0;
    while let Some((name, text)) = all.get(at) {
        let below = commands(text).into_iter().filter(|below| *below != "help");
        let below: Vec<String> = below.map(|below| format!("{name} {below}").trim().to_owned()).collect();
        all.extend(below.into_iter().map(|name| (name.clone(), help(bench, &name))));
        at += 1;
    }
    all
}

/// The calls of the program in the code of a page, with their lines.
fn calls(page: &Page) -> Vec<(usize, String)> {
    let (mut calls, mut in_code, mut open) = (Vec::new(), false, false);
    for (at, line) in page.text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            in_code ^= true;
        } else if in_code {
            let code = line.split(" # ").next().unwrap_or_default().trim();
            match calls.last_mut() {
                Some((_, call)) if open => *call += code,
                _ if code.starts_with("camera-lab") => calls.push((at, code.to_owned())),
                _ => continue,
            }
            open = code.ends_with('\\');
        } else {
            let inline = line.split('`').skip(1).step_by(2).filter(|code| code.starts_with("camera-lab "));
            calls.extend(inline.map(|code| (at, code.to_owned())));
        }
    }
    calls
}

/// The words of a call as a shell splits them. `None` if some of them stand for others: `FILE`, `$(…)`.
fn shell_words(call: &str) -> Option<Vec<String>> {
    let (mut words, mut quote) = (vec![String::new()], None);
    for c in call.replace('\\', " ").chars() {
        match (c, quote) {
            ('"' | '\'', None) => quote = Some(c),
            _ if quote == Some(c) => quote = None,
            (' ', None) => words.push(String::new()),
            _ => words.last_mut()?.push(c),
        }
    }
    let stands_for = |word: &String| {
        word.contains(['$', '…', '<'])
            || word.split(['=', '.']).any(|part| part.chars().all(|c| c.is_ascii_uppercase()) && !part.is_empty())
    };
    (!words.iter().any(stands_for)).then(|| words.into_iter().filter(|word| !word.is_empty()).skip(1).collect())
}

/// Where no file is, a call of a page fails because of its files at most.
#[test]
fn calls_in_pages_are_understood() {
    let bench = Bench::new("claims-calls");
    let known: Vec<String> = all_commands(&bench).into_iter().map(|(name, _)| name).collect();
    let (mut faults, mut compared) = (Vec::new(), 0);
    for page in PAGES.iter() {
        for (at, call) in calls(page) {
            let Some(mut words) =
                shell_words(&call).filter(|words| words.first().is_some_and(|word| known.contains(word)))
            else {
                // The window, or a pattern.
                continue;
            };
            if words[0] == "accuracy" || words.iter().any(|word| word == "play") {
                // It measures for minutes, or opens the window.
                words.push("--help".to_owned());
            }
            let run = bench.run(&words.iter().map(String::as_str).collect::<Vec<_>>());
            compared += 1;
            // A sentence may name a command without its arguments.
            if run.err.contains("see --help") && !known.contains(&words.join(" ")) {
                faults.push(format!("{}: {call}: {}", page.place(at), run.err.trim()));
            }
        }
    }
    assert_none(&faults);
    assert!(compared > 40, "only {compared} calls were tried");
}

#[test]
fn every_command_is_in_its_guide() {
    let bench = Bench::new("claims-guide");
    let mut faults = Vec::new();
    for page in PAGES.iter().filter(|page| page.path.contains("command-line")) {
        for (name, _) in all_commands(&bench).into_iter().skip(1) {
            if !page.text.contains(&format!("camera-lab {name}")) && !page.text.contains(&format!("`{name}`")) {
                faults.push(format!("{}: `{name}` is missing", page.path));
            }
        }
    }
    assert_none(&faults);
}

#[cfg(feature = "gui")]
mod of_window {
    use camera_lab::gui::app::command::MENUS;
    use camera_lab::gui::kit::keys::Command;
    use camera_lab::gui::{Start, State};
    use eframe::egui::ModifierNames;

    use super::*;

    /// Keys that no menu has: they belong to the field, the list or the view that has the focus, or to a terminal.
    const OTHER_KEYS: [&str; 3] = ["Ctrl+Tab", "Ctrl+Enter", "Ctrl+C"];

    fn state() -> State {
        let (figure, file) = (camera_lab_desk::document::fresh(), None);
        let start = Start { figure, file, lang: Lang::En, allow_files: false, lesson: None, later: None };
        State::new(start).expect("a possible camera")
    }

    #[test]
    fn rows_of_menus_are_those_of_the_window() {
        let (state, mut faults, mut compared) = (state(), Vec::new(), 0);
        for page in PAGES.iter() {
            let t = window::texts(page.lang);
            for (at, line) in page.prose() {
                for path in line.split('*').filter(|part| part.contains('▸')) {
                    let (menu, row) = path.split_once('▸').expect("▸ is there");
                    let mut menus =
                        MENUS.iter().filter(|known| known.in_bar && (known.title)(t) == menu.trim()).peekable();
                    // Or a panel.
                    if menus.peek().is_none() {
                        continue;
                    }
                    compared += 1;
                    let plain = |text: &str| text.trim().trim_end_matches('…').to_owned();
                    if !menus
                        .flat_map(|menu| menu.groups(&state.model).flatten())
                        .any(|command| plain(command.label(t)) == plain(row))
                    {
                        faults.push(format!("{}: *{path}* is no row of a menu", page.place(at)));
                    }
                }
            }
        }
        assert_none(&faults);
        assert!(compared > 20, "only {compared} rows were compared");
    }

    /// The command of each key in a text, or the key that has none.
    fn keys(text: &str) -> impl Iterator<Item = (&str, Option<Command>)> {
        let model = state().model;
        let names = |command: Command| {
            command.keys(&model).map(|keys| keys.format(&ModifierNames::NAMES, false)).collect::<Vec<_>>()
        };
        let all: Vec<(Command, Vec<String>)> = Command::all().map(|command| (command, names(command))).collect();
        let words = text.split(|c: char| !c.is_alphanumeric() && !matches!(c, '+' | '←' | '→' | '−'));
        let is_key = |word: &&str| {
            let last = word.rsplit('+').next().unwrap_or_default();
            let is_function = last.strip_prefix('F').is_some_and(|number| number.parse::<u8>().is_ok());
            let is_one = last.chars().count() == 1 || last.starts_with(char::is_uppercase);
            is_function || (word.starts_with("Ctrl+") || word.starts_with("Alt+")) && is_one
        };
        words.filter(is_key).map(move |word| {
            let written = word.replace('←', "Left").replace('→', "Right");
            let found = all.iter().find(|(_, names)| names.contains(&written));
            (word, found.map(|(command, _)| *command))
        })
    }

    #[test]
    fn keys_in_pages_belong_to_commands() {
        let (mut faults, mut compared) = (Vec::new(), 0);
        for page in PAGES.iter() {
            for (at, line) in page.prose() {
                for (key, command) in keys(line) {
                    compared += 1;
                    if command.is_none() && !OTHER_KEYS.contains(&key) {
                        faults.push(format!("{}: {key} calls no command", page.place(at)));
                    }
                }
            }
        }
        assert_none(&faults);
        assert!(compared > 100, "only {compared} keys were compared");
    }

    /// The line of a key has a word of its command, or of the command's hint.
    #[test]
    fn keys_in_guides_do_what_the_line_says() {
        let stems = |text: &str| -> BTreeSet<String> {
            let text = text.to_lowercase();
            let words = text.split(|c: char| !c.is_alphabetic()).filter(|word| word.chars().count() > 3);
            words.map(|word| word.chars().take(4).collect()).collect()
        };
        let (mut faults, mut compared) = (Vec::new(), 0);
        // Other pages say which keys a browser keeps for itself.
        let guides = ["README", "student", "lecturer", "author", "command-line"];
        for page in PAGES.iter().filter(|page| guides.iter().any(|guide| page.path.contains(guide))) {
            let t = window::texts(page.lang);
            for (at, line) in page.prose() {
                for (key, command) in keys(line) {
                    let Some(command) = command else { continue };
                    compared += 1;
                    let said = stems(line);
                    if stems(command.label(t)).union(&stems(command.hint(t))).all(|stem| !said.contains(stem)) {
                        faults.push(format!("{}: {key} is *{}*: {line}", page.place(at), command.label(t)));
                    }
                }
            }
        }
        assert_none(&faults);
        assert!(compared > 100, "only {compared} keys were compared");
    }
}

#[test]
fn commands_and_options_in_pages_exist() {
    let bench = Bench::new("claims");
    let all = all_commands(&bench);
    let known: Vec<&str> = all.iter().filter_map(|(name, _)| name.split(' ').next()).collect();
    assert!(known.len() > 10, "{known:?}");
    let options = all.iter().flat_map(|(_, help)| help.split(|c: char| !c.is_alphanumeric() && c != '-'));
    let options: BTreeSet<&str> = options.filter(|word| word.starts_with("--")).collect();
    let mut faults = Vec::new();
    let ours =
        ["student", "lecturer", "author", "command-line", "cameras", "without-rust", "README", "numerics", "limits"];
    for page in PAGES.iter().filter(|page| ours.iter().any(|name| page.path.contains(name))) {
        for (at, line) in page.text.lines().enumerate() {
            for (start, _) in line.match_indices("camera-lab ") {
                let before = line[..start].chars().next_back();
                let word = line[start + 11..].split_whitespace().next().unwrap_or_default();
                let is_command = word.chars().all(|c| c.is_ascii_lowercase()) && !word.is_empty();
                // In prose the name of the program is followed by a verb.
                let in_code = before == Some('`') || before.is_none() || line.starts_with("camera-lab ");
                if in_code && is_command && !known.contains(&word) {
                    faults.push(format!("{}: camera-lab {word} is no command", page.place(at)));
                }
            }
            let is_other = ["cargo ", "pip ", "npm ", "apt"].iter().any(|name| line.contains(name));
            for word in line.split(|c: char| !c.is_alphanumeric() && c != '-').filter(|word| word.starts_with("--")) {
                let is_option =
                    word.len() > 3 && word.chars().all(|c| c == '-' || c.is_ascii_lowercase()) && !word.ends_with('-');
                if is_option && !is_other && !options.contains(word) {
                    faults.push(format!("{}: {word} is no option", page.place(at)));
                }
            }
        }
    }
    assert_none(&faults);
}

#[test]
fn formats_that_carry_their_figure_are_named_wherever_it_matters() {
    let bench = Bench::new("claims-formats");
    let help = help(&bench, "render");
    let figure = help.lines().find(|line| line.contains("camera-lab wrote")).expect("the help of FIGURE");
    let hints = [Lang::En, Lang::PtBr].map(|lang| window::texts(lang).export_hint);
    for text in hints.into_iter().chain([figure]) {
        for format in PictureFormat::ALL {
            assert_eq!(text.contains(format.name()), format.carries_figure(), "{}: {text}", format.name());
        }
    }
}

/// A file that people take for a figure gets its kind and the way out, and not a fault of TOML.
#[test]
fn a_file_of_another_kind_is_called_by_its_name() {
    let bench = Bench::new("other-kinds");
    bench.write("figure.toml", "");
    for (name, says) in [("a.jpg", "is a JPEG"), ("a.webp", "is a WebP")] {
        bench.run(&["render", "figure.toml", "--size", "64x48", "-o", name]).done();
        for command in ["inspect", "diagnose"] {
            let run = bench.run(&[command, name]);
            assert_eq!(run.status, Some(2), "{run:?}");
            let expected = format!("{name} {says}, which can't hold its figure. PNG, SVG and PDF can");
            assert!(run.err.contains(&expected), "{command} {name}: {}", run.err);
        }
    }
    // However large it is.
    let mut large = bench.read("a.jpg");
    large.resize(9 << 20, 0);
    bench.write("large.jpg", large);
    let run = bench.run(&["inspect", "large.jpg"]);
    assert!(run.status == Some(2) && run.err.contains("large.jpg is a JPEG"), "{run:?}");
    bench.run(&["render", "figure.toml", "--size", "64x48", "-o", "a.tex"]).done();
    let run = bench.run(&["inspect", "a.tex"]);
    assert!(run.status == Some(2) && run.err.contains("The PDF beside it does"), "{run:?}");
    bench.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let run = bench.run(&["inspect", "m.obj", "--lang", "pt-BR"]);
    assert!(run.status == Some(2) && run.err.contains("m.obj é uma malha"), "{run:?}");
    // A figure is one under any name.
    bench.write("figure.obj", "");
    bench.run(&["inspect", "figure.obj"]).done();
}

#[test]
fn every_fuzz_target_and_command_is_listed() {
    let read = |path: &str| std::fs::read_to_string(Path::new(ROOT).join(path)).expect("a file of the project");
    let script = read(".ci/fuzz");
    let targets = script.lines().find_map(|line| line.strip_prefix("targets=(")).expect("the targets");
    let table = read("docs/testing.md");
    let missing = |page: &str, name: &str| !page.contains(&format!("`{name}`"));
    let mut faults: Vec<String> = Vec::new();
    for target in targets.trim_end_matches(')').split_whitespace().filter(|target| missing(&table, target)) {
        faults.push(format!("docs/testing.md: `{target}` is missing"));
    }
    let bench = Bench::new("claims-commands");
    let help = help(&bench, "");
    let changes = read("CHANGELOG.md");
    for command in commands(&help).into_iter().filter(|name| *name != "help" && missing(&changes, name)) {
        faults.push(format!("CHANGELOG.md: `{command}` is missing"));
    }
    assert_none(&faults);
}

#[test]
fn paths_in_pages_exist() {
    let tops = [
        "src/",
        "crates/",
        "tests/",
        "docs/",
        "dist/",
        "assets/",
        "benches/",
        "examples/",
        "fuzz/",
        ".ci/",
        ".github/",
    ];
    let (mut faults, mut compared) = (Vec::new(), 0);
    for page in PAGES.iter() {
        for (at, line) in page.text.lines().enumerate() {
            for code in line.split('`').skip(1).step_by(2) {
                for word in code.split_whitespace().filter(|word| tops.iter().any(|top| word.starts_with(top))) {
                    // A pattern, or a place that a command fills.
                    if word.contains(['*', '{', '<', '…'])
                        || word.chars().any(char::is_uppercase) && !word.contains(".md")
                    {
                        continue;
                    }
                    compared += 1;
                    let path = word.split(['#', ':']).next().unwrap_or_default().trim_end_matches([',', '.', '/']);
                    if !Path::new(ROOT).join(path).exists() {
                        faults.push(format!("{}: {word} doesn't exist", page.place(at)));
                    }
                }
            }
        }
    }
    assert_none(&faults);
    assert!(compared > 20, "only {compared} paths were compared");
}

#[test]
fn a_claim_that_is_wrong_is_found() {
    assert_eq!(number("Eighteen", Lang::En), Some(18));
    assert_eq!(number("dezoito", Lang::PtBr), Some(18));
    assert_eq!(number("one", Lang::En), None);
}
