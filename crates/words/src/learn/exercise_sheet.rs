//! A sheet of exercises to hand out, as Markdown or LaTeX.

use super::{exercise_messages, exercises};
use crate::exercises::{Ask, Exercise, Expected, Kind, Worked};
use crate::explain::{Line, Notation, Style};
use crate::formula;

texts!("learn/exercise_sheet");

/// Digits of the numbers in worked steps.
const DIGITS: usize = 6;

/// The most versions of a sheet.
pub const MAX_VERSIONS: u32 = 200;

/// The solutions of a handout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solutions {
    /// It has none.
    None,
    /// On pages of their own at its end.
    AtEnd,
    /// It consists of them.
    Alone,
}

/// Exercises that belong together, with their numbers.
#[derive(Clone, Debug)]
pub struct Version {
    /// Its number, if there are several.
    pub number: Option<u64>,
    /// In the order of the sheet.
    pub exercises: Vec<Exercise>,
}

impl Version {
    /// "Version 7", or nothing if it has no number.
    pub fn name(&self, lang: Lang) -> String {
        self.number.map_or_else(String::new, |number| exercise_messages::version(lang, number))
    }
}

/// The name of the file with the picture of an exercise that has one, by its version and its number from 1.
pub type PictureOf<'a> = &'a dyn Fn(&Version, usize) -> String;

/// The versions of a sheet, each with its exercises in Markdown or LaTeX. With [`Solutions::Alone`], only the answers.
type Versions<'a> = (&'a [Version], Solutions);

/// A sheet in Markdown.
pub fn markdown(lang: Lang, (versions, solutions): Versions<'_>, picture: PictureOf<'_>) -> String {
    let t = exercise_messages::texts(lang);
    let alone = solutions == Solutions::Alone;
    let mut text = String::new();
    for version in versions {
        let (title, name) = (if alone { t.answers } else { t.exercises }, version.name(lang));
        let before = if text.is_empty() { "" } else { "\n---\n\n" };
        let dash = if name.is_empty() { "" } else { " – " };
        text.push_str(&format!("{before}# {title}{dash}{name}\n"));
        if !alone {
            text.push_str(&format!("\n{}: ____________________  {}: ____________\n", t.name, t.date));
        }
        for (number, exercise) in (1..).zip(&version.exercises) {
            text.push_str(&format!("\n## {number}. {}\n", of_words(exercises::exercise_title(lang, exercise))));
            if !alone {
                asked_in_markdown(&mut text, lang, exercise, &picture(version, number));
            }
            if solutions != Solutions::None {
                solved_in_markdown(&mut text, lang, exercise, alone);
            }
        }
    }
    text
}

fn asked_in_markdown(text: &mut String, lang: Lang, exercise: &Exercise, picture: &str) {
    let t = exercise_messages::texts(lang);
    text.push('\n');
    for paragraph in exercises::statement(lang, exercise) {
        text.push_str(&format!("{}\n\n", inert(&set(&paragraph))));
    }
    if exercise.figure_to_match().is_some() {
        text.push_str(&format!("![{}]({picture})\n\n", t.target));
    }
    for assumption in exercises::assumptions(lang, exercise) {
        text.push_str(&format!("> {}\n>\n", inert(&set(&assumption))));
    }
    for (letter, ask) in ('a'..).zip(&exercise.asks) {
        let (asked, kind) = (exercises::ask(lang, exercise, ask), exercises::kind(lang, ask));
        text.push_str(&format!("\n**{letter})** {} — *{}*\n", inert(&set(&asked)), of_words(&kind)));
    }
    text.push_str(&format!("\n<small>{}</small>\n", exercise_messages::source_of_numbers(lang, exercise)));
}

fn solved_in_markdown(text: &mut String, lang: Lang, exercise: &Exercise, alone: bool) {
    if !alone {
        text.push_str(&format!("\n### {}\n", exercise_messages::texts(lang).answers));
    }
    let style = Style { notation: Notation::Latex, mark: lang.mark(), digits: DIGITS };
    for ((letter, ask), steps) in ('a'..).zip(&exercise.asks).zip(exercise.new_steps()) {
        text.push_str(&format!("\n**{letter})** {}\n", of_words(&answer(lang, ask))));
        for step in &steps {
            text.push_str(&format!("\n{}\n", set(&exercises::step_heading(lang, exercise, step))));
            let lines = step.lines(style, true);
            if !lines.is_empty() {
                text.push_str(&format!("\n$$\n\\begin{{aligned}}\n{}\n\\end{{aligned}}\n$$\n", rows(&lines)));
            }
        }
    }
}

/// A sheet in LaTeX, which compiles with only amsmath and amssymb, and graphicx if it has pictures.
pub fn latex(lang: Lang, (versions, solutions): Versions<'_>, picture: PictureOf<'_>) -> String {
    let t = exercise_messages::texts(lang);
    let (babel, alone) = (text!(lang, latex), solutions == Solutions::Alone);
    let mut all = versions.iter().flat_map(|version| &version.exercises);
    let has_pictures = !alone && all.any(|exercise| exercise.figure_to_match().is_some());
    let graphics = if has_pictures { "\\usepackage{graphicx}\n" } else { "" };
    let mut text = format!(
        "\\documentclass[a4paper,11pt]{{article}}\n\\usepackage[T1]{{fontenc}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage[{babel}]{{babel}}\n\
         \\usepackage{{amsmath,amssymb}}\n{graphics}\\usepackage[margin=2cm]{{geometry}}\n\\allowdisplaybreaks\n\\begin{{document}}\n",
    );
    for version in versions {
        if version.number.is_some() {
            let foot = version.name(lang);
            text.push_str(&format!(
                "\n\\clearpage\\setcounter{{page}}{{1}}\n\\makeatletter\\def\\@oddfoot{{\\hfil {foot} $\\cdot$ \\thepage\\hfil}}\\makeatother\n"
            ));
        }
        text.push_str(&format!("\\section*{{{}}}\n", if alone { t.answers } else { t.exercises }));
        if !alone {
            text.push_str(&format!(
                "\\noindent {}: \\underline{{\\hspace{{6cm}}}}\\quad {}: \\underline{{\\hspace{{3cm}}}}\n",
                t.name, t.date
            ));
        }
        for (number, exercise) in (1..).zip(&version.exercises) {
            let title = formula::words(exercises::exercise_title(lang, exercise));
            text.push_str(&format!("\n\\subsection*{{{number}. {title}}}\n"));
            if !alone {
                asked_in_latex(&mut text, lang, exercise, &picture(version, number));
            }
            if solutions != Solutions::None {
                solved_in_latex(&mut text, lang, exercise, alone);
            }
        }
    }
    text.push_str("\\end{document}\n");
    text
}

fn asked_in_latex(text: &mut String, lang: Lang, exercise: &Exercise, picture: &str) {
    for paragraph in exercises::statement(lang, exercise) {
        text.push_str(&format!("{}\n\n", of_markdown(&paragraph)));
    }
    if exercise.figure_to_match().is_some() {
        text.push_str(&format!("\\begin{{center}}\\includegraphics[width=8cm]{{{picture}}}\\end{{center}}\n\n"));
    }
    let assumptions = exercises::assumptions(lang, exercise);
    if !assumptions.is_empty() {
        text.push_str("\\begin{quote}\\small\n");
        for assumption in assumptions {
            text.push_str(&format!("{}\n\n", of_markdown(&assumption)));
        }
        text.push_str("\\end{quote}\n");
    }
    text.push_str("\\begin{enumerate}\n");
    for ask in &exercise.asks {
        let (asked, kind) = (exercises::ask(lang, exercise, ask), exercises::kind(lang, ask));
        text.push_str(&format!("\n\\item {} \\emph{{({})}}\n", of_markdown(&asked), formula::words(&kind)));
    }
    text.push_str("\\end{enumerate}\n");
    let numbers = formula::words(&exercise_messages::source_of_numbers(lang, exercise));
    text.push_str(&format!("{{\\footnotesize {numbers}}}\n"));
}

fn solved_in_latex(text: &mut String, lang: Lang, exercise: &Exercise, alone: bool) {
    if !alone {
        text.push_str(&format!("\n\\paragraph{{{}}}", exercise_messages::texts(lang).answers));
    }
    text.push_str("\n\\begin{enumerate}\n");
    for (ask, steps) in exercise.asks.iter().zip(exercise.new_steps()) {
        text.push_str(&format!("\\item {}\n", latex_answer(lang, exercise, ask, &steps)));
    }
    text.push_str("\\end{enumerate}\n");
}

/// The right answer, in typed form.
pub fn answer(lang: Lang, ask: &Ask) -> String {
    let mark = lang.mark();
    match (ask.expected(), ask.expected().table(), &ask.kind) {
        (Expected::Choice(right, ..), _, Kind::Choice(choices)) => {
            choices.get(*right).map_or_else(String::new, |name| exercises::choice_of(lang, ask, name).to_owned())
        }
        (Expected::Camera(_, model, ..), ..) => {
            exercises::understood(lang, ask, &crate::exercises::Answer::Camera(model.clone()))
        }
        (_, Some(table), Kind::Matrix(..)) => exercises::matrix(mark, &table),
        (_, Some(table), Kind::Number) => exercises::number(mark, table.entries.first().copied().unwrap_or(f64::NAN)),
        (_, Some(table), _) => exercises::tuple(mark, &table.entries),
        _ => String::new(),
    }
}

fn latex_answer(lang: Lang, exercise: &Exercise, ask: &Ask, steps: &[Worked]) -> String {
    let style = Style { notation: Notation::Latex, mark: lang.mark(), digits: DIGITS };
    let mut text = match ask.expected().table() {
        Some(table) if ask.shape()[1] > 1 => {
            let entries: Vec<Option<f64>> = table.entries.iter().copied().map(Some).collect();
            format!("\\[{}\\]\n", exercises::table_latex(lang.mark(), ask.unit, table.columns, &entries))
        }
        _ => format!("{}\n", formula::words(&answer(lang, ask))),
    };
    for step in steps {
        let lines = step.lines(style, true);
        text.push_str(&format!("\n{}\n", of_markdown(&exercises::step_heading(lang, exercise, step))));
        if !lines.is_empty() {
            text.push_str(&format!("{{\\footnotesize\\begin{{align*}}\n{}\n\\end{{align*}}}}\n", rows(&lines)));
        }
    }
    text
}

/// Rows in LaTeX, aligned at their first equals signs. Short ones stay on one line.
fn rows(lines: &[Line]) -> String {
    let row = |Line { symbol, formula, numbers, value }: &Line| {
        let mut parts = vec![formula];
        for part in [numbers, value] {
            if !parts.contains(&part) {
                parts.push(part);
            }
        }
        let mut row = symbol.clone();
        let mut so_far = 0;
        for part in parts {
            so_far += width(part);
            let is_next = row != *symbol && so_far > ONE_LINE;
            if is_next {
                so_far = width(part);
            }
            row.push_str(match (is_next, row == *symbol) {
                (true, _) => " \\\\\n &= ",
                (false, true) => " &= ",
                (false, false) => " = ",
            });
            row.push_str(part);
        }
        row
    };
    lines.iter().map(row).collect::<Vec<_>>().join(" \\\\\n")
}

/// Letters of a formula that fit on a line.
const ONE_LINE: usize = 64;

/// Approximate number of letters of a formula. A fraction is as wide as both its halves.
fn width(latex: &str) -> usize {
    let (mut width, mut in_command) = (0, false);
    for c in latex.chars() {
        in_command = c == '\\' || (in_command && c.is_ascii_alphabetic());
        width += usize::from(!in_command && !matches!(c, '{' | '}' | ' ' | '_' | '^'));
    }
    width
}

/// Markdown whose names with subscripts, such as M_v, are set as mathematics.
fn set(markdown: &str) -> String {
    let mut set = String::new();
    for (k, part) in markdown.split('$').enumerate() {
        if k % 2 == 1 {
            set.push_str(&format!("${part}$"));
            continue;
        }
        let mut rest = part;
        while let Some(at) = rest.find('_') {
            let (before, after) = (&rest[..at], &rest[at + 1..]);
            let end = after.find(|c: char| !c.is_alphanumeric()).unwrap_or(after.len());
            let mut letters = before.chars().rev();
            let name = letters.next().filter(|c| c.is_alphabetic());
            let is_one_letter = letters.next().is_none_or(|c| !(c.is_alphanumeric() || c == '_'));
            let (under, next) = after.split_at(end);
            match name {
                Some(name) if is_one_letter && end > 0 && !next.starts_with('_') => {
                    set.push_str(&before[..at - name.len_utf8()]);
                    let under =
                        if under.chars().count() > 1 { format!("\\mathrm{{{under}}}") } else { under.to_owned() };
                    set.push_str(&format!("${name}_{{{under}}}$"));
                    rest = next;
                }
                _ => {
                    set.push_str(before);
                    set.push('_');
                    rest = after;
                }
            }
        }
        set.push_str(rest);
    }
    set
}

/// Markdown with bold words, code and mathematics between dollars, as LaTeX.
fn of_markdown(text: &str) -> String {
    let text = set(text);
    let mut latex = String::new();
    for (k, part) in text.split('$').enumerate() {
        if k % 2 == 1 {
            // Forbidden LaTeX is shown to the reader as words, because only mathematics leaves them.
            let is_mathematics = formula::check_one(part).is_ok();
            latex.push_str(&if is_mathematics { format!("${}$", formula::latex(part)) } else { formula::words(part) });
            continue;
        }
        for (k, part) in part.split("**").enumerate() {
            let part = formula::words(part);
            latex.push_str(&if k % 2 == 1 { format!("\\textbf{{{part}}}") } else { part });
        }
    }
    latex
}

/// Markdown that only shows its words. It has no HTML, no links or pictures, which may name files, and outside formulas
/// no commands of TeX, which some programs pass on.
fn inert(markdown: &str) -> String {
    let mut inert = String::with_capacity(markdown.len());
    for (k, part) in markdown.split('$').enumerate() {
        if k > 0 {
            inert.push('$');
        }
        let mut chars = part.chars().peekable();
        while let Some(c) = chars.next() {
            let next = chars.peek().copied();
            inert.push(if c.is_control() { ' ' } else { c });
            match (c, next) {
                ('<', Some(next)) if next.is_ascii_alphabetic() || "/!?".contains(next) => inert.push(' '),
                (']', Some('(' | ':')) | ('{', Some('=')) => inert.push(' '),
                // A backslash already.
                ('\\', Some('\\')) => inert.extend(chars.next()),
                ('\\', next) if k % 2 == 0 && next.is_none_or(|c| c.is_ascii_alphanumeric() || "([".contains(c)) => {
                    inert.push('\\');
                }
                _ => {}
            }
        }
    }
    inert
}

/// Words as inert Markdown, without any mathematics.
fn of_words(text: &str) -> String {
    text.split('$').map(|part| inert(&part.replace('\\', "\\\\"))).collect::<Vec<_>>().join("\\$")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markdown_of_a_stranger_shows_words_and_does_nothing() {
        for (text, shown) in [
            ("<script>alert(1)</script>", "< script>alert(1)< /script>"),
            ("<!-- x --> a < b, a<2", "< !-- x --> a < b, a<2"),
            ("![](/etc/passwd) [x](javascript:y)", "![] (/etc/passwd) [x] (javascript:y)"),
            ("[x]: /etc/passwd", "[x] : /etc/passwd"),
            ("\\input{/etc/passwd} \\* \\(x\\)", "\\\\input{/etc/passwd} \\* \\\\(x\\)"),
            ("`x`{=html}", "`x`{ =html}"),
            ("$\\frac{1}{2}$ and $a<b$", "$\\frac{1}{2}$ and $a< b$"),
            ("a\u{1b}b", "a b"),
        ] {
            assert_eq!(inert(text), shown);
        }
        assert_eq!(of_words("5 $ \\input"), "5 \\$ \\\\input");
    }

    #[test]
    fn text_that_is_no_mathematics_is_set_as_words() {
        assert_eq!(of_markdown("a $\\frac{1}{2}$ b_c"), "a $\\frac{1}{2}$ $b_{c}$");
        assert_eq!(
            of_markdown("$\\input{/etc/passwd}$ é “x”, 漢"),
            "\\textbackslash{}input\\{/etc/passwd\\} é ``x'', {[}U+6F22{]}"
        );
        assert_eq!(of_markdown("a\n\nb"), "a  b");
    }
}
