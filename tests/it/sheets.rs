//! Texts that go from a file to LaTeX or Markdown: words and mathematics, and nothing that reads a file or runs a
//! program.
#![expect(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::process::{Command, Stdio};
use std::sync::Arc;

use proptest::prelude::*;

use camera_lab::exercises::{Exercise, Free, OwnTexts, entries, own};
use camera_lab::figure::Localized;
use camera_lab::formula;
use camera_lab_words::Lang;
use camera_lab_words::handout::{Solutions, Version};
use camera_lab_words::learn::{exercise_sheet as sheet, exercises as texts};
use camera_lab_words::why::notes::{Piece, notes};

use crate::common::program::Bench;

const BOTH: [Lang; 2] = [Lang::En, Lang::PtBr];

/// Attacks in texts of strangers, by the name of a file.
fn attacks(file: &str) -> Vec<String> {
    let plain = [
        "\\input{FILE}",
        "\\input FILE ",
        "\\include{FILE}",
        "\\InputIfFileExists{FILE}{}{}",
        "\\openin5=FILE \\read5 to\\x \\x",
        "\\immediate\\write18{touch pwned}",
        "\\write18{touch pwned}",
        "\\immediate\\openout5=pwned ",
        "\\csname input\\endcsname FILE ",
        "^^5cinput FILE ",
        "^^5c^^69nput FILE ",
        "\\catcode`\\%=12",
        "\\def\\x{\\x}\\x",
        "\\let\\x=\\input \\x FILE ",
        "\\usepackage{shellesc}",
        "\\directlua{io.open('pwned','w')}",
        "\\begin{filecontents*}{pwned}x\\end{filecontents*}",
        "\\end{document}",
        "\\verbatiminput{FILE}",
        "\\lstinputlisting{FILE}",
        "\\verb|x|\\input{FILE}",
        "\\includegraphics{FILE}",
        "\u{ff3c}input{FILE}",
        "\\\u{ff49}nput{FILE}",
        "} \\input{FILE} {",
        "% \n\\input{FILE}",
        "\\\\input{FILE}",
        "\\text{\\input{FILE}}",
        "\\sqrt[\\input{FILE}]{2}",
        "\\begin{array}{@{\\input{FILE}}c}x\\end{array}",
        "\"`\\input{FILE}",
        "#1 & ~ _ ^ { } [ ] < > | \" ' \u{202e} \u{0} \u{1b} 漢 ﬁ é",
    ];
    let with_file = plain.iter().map(|text| text.replace("FILE", file));
    with_file
        .flat_map(|text| {
            let in_formula = format!("a ${text}$ b");
            let begun = format!("$x$ y $ {text}");
            let display = format!("$${text}$$");
            let bold = format!("**{text} $x^2$**");
            let code = format!("`{text}` ```{text}```");
            [text, in_formula, begun, display, bold, code]
        })
        .collect()
}

/// An exercise with these texts, which were not checked.
fn exercise(texts: &[String]) -> Exercise {
    let plain = "id = \"mine\"\ntitle = \"Mine\"\nstatement = \"Say it.\"\n";
    let asks = "[[ask]]\nname = \"a\"\ntext = \"A\"\nchoices = [\"x\", \"y\"]\nanswer = \"x\"\n[[ask]]\nname = \"b\"\ntext = \"B\"\nquantity = \"basis.u\"\n";
    let mut exercise = own::parse(&format!("{plain}{asks}")).unwrap().exercise(0, &Free::new());
    let told = |text: &String| Localized::from([text.clone(), text.clone()]);
    let any = |k: usize| told(&texts[k % texts.len()]);
    let statement = texts.join("\n\n");
    exercise.texts = Some(Arc::new(OwnTexts {
        title: any(0),
        statement: told(&statement),
        assumptions: texts.iter().map(told).collect(),
        asks: [("a".to_owned(), any(1)), ("b".to_owned(), any(2))].into(),
    }));
    exercise
}

/// The control words in LaTeX that are not those of mathematics and not those of the sheet itself.
fn foreign_words(latex: &str) -> Vec<String> {
    const OF_THE_SHEET: &str = "documentclass usepackage allowdisplaybreaks begin end section subsection paragraph noindent underline hspace \
        quad item emph footnotesize small textbf textbackslash textasciicircum textasciitilde textquotedbl dots";
    let mut found = Vec::new();
    let mut rest = latex;
    while let Some(at) = rest.find('\\') {
        rest = &rest[at + 1..];
        let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        let word = &rest[..end];
        if end == 0 {
            // The sign after a backslash means itself.
            rest = rest.get(1..).unwrap_or_default();
        } else if !formula::is_word(word) && !OF_THE_SHEET.split_whitespace().any(|known| known == word) {
            found.push(word.to_owned());
        }
    }
    found
}

/// Holds that a sheet with these texts commands nothing, in both formats.
fn is_inert(texts: &[String]) -> Result<(), TestCaseError> {
    let sheets = [Version { number: None, exercises: vec![exercise(texts)] }];
    let picture = |_: &Version, number: usize| format!("{number}.png");
    let latex = sheet::latex(Lang::En, (&sheets, Solutions::AtEnd), &picture);
    prop_assert_eq!(foreign_words(&latex), Vec::<String>::new(), "{}", latex);
    prop_assert!(!latex.contains("^^") && latex.matches("\\end{document}").count() == 1, "{latex}");
    // A percent sign stands after a backslash.
    prop_assert!(latex.split('%').rev().skip(1).all(|before| before.ends_with('\\')), "{latex}");
    let begun: Vec<&str> = latex.split("\\begin{").skip(1).filter_map(|rest| rest.split('}').next()).collect();
    let known = |name: &&str| ["document", "quote", "enumerate", "align*", "bmatrix", "matrix", "array"].contains(name);
    prop_assert!(begun.iter().all(known), "{begun:?}");
    let markdown = sheet::markdown(Lang::En, (&sheets, Solutions::AtEnd), &picture);
    for (at, _) in markdown.match_indices('<') {
        let rest = &markdown[at..];
        let is_tag = rest[1..].starts_with(|c: char| c.is_ascii_alphabetic() || "/!?".contains(c));
        prop_assert!(!is_tag || rest.starts_with("<small>") || rest.starts_with("</small>"), "{rest:.60}");
    }
    prop_assert!(!markdown.contains("](") && !markdown.contains("]:") && !markdown.contains("{="), "{markdown}");
    Ok(())
}

#[test]
fn attacks_of_all_kinds_become_words() {
    for text in attacks("secret.txt") {
        is_inert(std::slice::from_ref(&text)).unwrap_or_else(|error| panic!("{text}: {error}"));
    }
}

proptest! {
    /// Texts by a grammar of the words of TeX, Markdown and HTML.
    #[test]
    fn no_text_commands_anything(
        texts in prop::collection::vec(
            prop::collection::vec(
                prop_oneof![
                    4 => prop::sample::select(vec![
                        "\\", "$", "$$", "{", "}", "[", "]", "(", ")", "%", "#", "&", "^", "^^", "^^5c", "_", "~", "*", "**", "`", "```", "<", ">",
                        "!", "=", ":", "\n", "\n\n", "\r\n", " ", "\"", "'", "|", "\u{0}", "\u{1b}", "\u{202e}", "＼", "；",
                    ]),
                    3 => prop::sample::select(vec![
                        "\\input", "\\include", "\\write18", "\\immediate", "\\csname", "\\endcsname", "\\def", "\\catcode", "\\read", "\\openin",
                        "\\usepackage", "\\begin", "\\end", "\\text", "\\frac", "\\theta", "\\left", "\\right", "\\mathbf", "input", "{document}",
                        "{filecontents}", "{matrix}", "{array}", "{@{\\input x}}", "script", "/etc/passwd", "x_i", "x", "2", "é", "漢",
                        "javascript:", "http://x", "{=html}", "{=latex}", "---",
                    ]),
                    1 => prop::sample::select(vec!["$\\theta$", "$x_1^2$", "$\\begin{matrix} 1 & 2 \\end{matrix}$", "**bold**", "\\$5"]),
                ],
                0..14,
            ).prop_map(|parts| parts.concat()),
            1..4,
        ),
    ) {
        is_inert(&texts)?;
    }
}

#[test]
fn every_text_of_the_program_and_every_formula_of_its_notes_is_let_through() {
    for lang in BOTH {
        for entry in entries() {
            let exercise = entry.exercise(1, &Free::new());
            let mut all = texts::statement(lang, &exercise);
            all.extend(texts::assumptions(lang, &exercise));
            all.extend(exercise.asks.iter().map(|ask| texts::ask(lang, &exercise, ask)));
            let steps = exercise.new_steps();
            all.extend(steps.iter().flatten().map(|step| texts::step_heading(lang, &exercise, step)));
            for text in all {
                assert_eq!(formula::check(&text), Ok(()), "{}: {text}", entry.id);
            }
        }
        for note in notes(lang) {
            let inline = note.paragraphs.iter().chain(&note.errata).flatten().filter_map(|piece| match piece {
                Piece::Mathematics(latex) => Some(*latex),
                Piece::Words(_) => None,
            });
            for latex in inline.chain(note.equations.iter().copied()) {
                assert_eq!(formula::check_one(latex), Ok(()), "{}: {latex}", note.id);
            }
        }
    }
}

#[test]
fn an_exercise_with_more_than_mathematics_is_refused_by_file_line_key_and_word() {
    let bench = Bench::new("hostile-exercise");
    let asks = "[[ask]]\nname = \"a\"\ntext = \"What?\"\nanswer = 1\n";
    let with = |key: &str, text: &str| match key {
        "text" => format!("id = \"x\"\ntitle = \"T\"\nstatement = \"S\"\n{}", asks.replace("What?", text)),
        "message" => format!(
            "id = \"x\"\ntitle = \"T\"\nstatement = \"S\"\n{asks}[[ask.mistake]]\nanswer = 2\nmessage = \"{text}\"\nhint = \"{text}\"\n"
        ),
        "hint" => format!(
            "id = \"x\"\ntitle = \"T\"\nstatement = \"S\"\n{asks}[[ask.mistake]]\nanswer = 2\nmessage = \"m\"\nhint = [\"{text}\"]\n"
        ),
        "assumptions" => format!("id = \"x\"\ntitle = \"T\"\nstatement = \"S\"\nassumptions = [\"{text}\"]\n{asks}"),
        "pt" => format!("id = \"x\"\ntitle = \"T\"\nstatement = {{ en = \"S\", \"pt-BR\" = \"{text}\" }}\n{asks}"),
        _ => format!("id = \"x\"\ntitle = \"T\"\nstatement = \"{text}\"\n{asks}"),
    };
    let folder = bench.path("");
    for (key, line, text, word) in [
        ("statement", 3, "Say $\\\\input{/etc/passwd}$", "\\input"),
        ("pt", 3, "Diga $\\\\write18{id}$", "\\write"),
        ("assumptions", 4, "$^^5cinput$", "^^"),
        ("text", 6, "$a}$", "}"),
        ("message", 10, "costs 5 $", "$"),
        ("hint", 11, "$\\\\csname x$", "\\csname"),
    ] {
        bench.write("x.toml", with(key, text));
        let show = |lang: &str| {
            let folder = folder.to_str().unwrap();
            bench.run(&["exercise", "sheet", "--ids", "x", "--folder", folder, "-o", "o.tex", "--lang", lang])
        };
        for (lang, line) in [("en", format!("x.toml, line {line}: ")), ("pt-BR", format!("x.toml, linha {line}: "))] {
            let run = show(lang);
            let said = run.refused(2);
            let key = if key == "pt" { "statement" } else { key };
            assert!(said.contains(&line) && said.contains(key) && said.contains(word), "{said}");
        }
    }
    assert_eq!(bench.names(), ["x.toml"]);
    // Lines that end as on Windows, and mathematics, are no harm.
    bench.write("x.toml", with("statement", "$\\\\theta$").replace('\n', "\r\n"));
    let run = bench.run(&["exercise", "show", "x", "--folder", folder.to_str().unwrap()]);
    assert!(run.done().starts_with(b"T"), "{:?}", String::from_utf8_lossy(&run.out));
    // A terminal is not written to with escapes.
    bench.write("x.toml", with("statement", "\\u001b[31m"));
    bench.run(&["exercise", "show", "x", "--folder", folder.to_str().unwrap()]).refused(2);
}

#[test]
#[expect(clippy::print_stderr, reason = "what is left out is said")]
fn a_hostile_sheet_compiles_to_its_words_and_takes_nothing_of_the_machine() {
    let has = |program: &str| Command::new(program).arg("--version").output().is_ok();
    if !has("pdflatex") {
        eprintln!("pdflatex is not installed: the sheet was not compiled");
        return;
    }
    let bench = Bench::new("hostile-sheet");
    let secret = "SECRETOFTHISMACHINE";
    bench.write("secret.txt", secret);
    bench.write("secret.tex", secret);
    let mut texts = attacks("secret.txt");
    texts.extend(attacks(bench.path("secret.txt").to_str().unwrap()));
    let sheets = [Version { number: None, exercises: texts.chunks(24).map(exercise).collect() }];
    let latex = sheet::latex(Lang::En, (&sheets, Solutions::AtEnd), &|_, _| String::new());
    bench.write("sheet.tex", &latex);
    let mut pdflatex = Command::new("pdflatex");
    // With all that LaTeX may be allowed.
    pdflatex.args(["-interaction=nonstopmode", "-halt-on-error", "-shell-escape", "sheet.tex"]);
    let run = pdflatex.current_dir(bench.path("")).stdin(Stdio::null()).output().unwrap();
    let said = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success(), "{}", said.lines().rev().take(30).collect::<Vec<_>>().join("\n"));
    assert_eq!(bench.names(), ["secret.tex", "secret.txt", "sheet.aux", "sheet.log", "sheet.pdf", "sheet.tex"]);
    for name in ["sheet.tex", "sheet.log", "sheet.aux"] {
        assert!(!String::from_utf8_lossy(&bench.read(name)).contains(secret), "{name}");
    }
    if has("pdftotext") {
        let text = Command::new("pdftotext").args(["sheet.pdf", "-"]).current_dir(bench.path("")).output().unwrap();
        let text = String::from_utf8_lossy(&text.stdout);
        assert!(text.contains("input") && !text.contains(secret), "{text:.200}");
    }
}
