//! Mathematics between dollar signs in texts from outside, with the allowed commands.
//!
//! LaTeX, which sets the texts on a sheet, is a language in which a text can read files and run programs. So only the
//! commands listed here are allowed: no others, and none that LaTeX may add later.

mod in_line;

use std::fmt::Write as _;

use crate::limits::MAX_FORMULA;
use crate::sanitize::escaped;
pub use in_line::{bold, italic, set, symbols};

/// A formula that isn't only mathematics.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the formula ${}$ has {problem}", escaped(formula))]
pub struct FormulaError {
    /// The text between the dollar signs.
    pub formula: String,
    /// The violated rule.
    pub problem: FormulaProblem,
}

/// A problem in a formula.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FormulaProblem {
    /// No dollar sign ends it.
    #[error("no closing dollar sign")]
    Open,
    /// No content.
    #[error("no content")]
    Empty,
    /// A control word that isn't mathematical.
    #[error("{}, which is not a mathematical command", escaped(.0))]
    Word(String),
    /// An environment that isn't mathematical.
    #[error("the environment {}", escaped(.0))]
    Environment(String),
    /// A character that isn't mathematical.
    #[error("{:?}, which is not a mathematical symbol", .0)]
    Character(char),
    /// A brace, a `\left` or a `\begin` without its other half.
    #[error("{} without a counterpart", escaped(.0))]
    Unbalanced(String),
    /// Mathematics that doesn't fit on one line of a label.
    #[error("{}, which a label on one line cannot show", escaped(.0))]
    NotOnALine(String),
    /// Too long, or nested too deeply, for any sensible formula.
    #[error("more than {} characters, or more than {} nested pairs", MAX_FORMULA.0, MAX_FORMULA.1)]
    TooLong,
}

/// The control words that a formula may have, besides `\begin` and `\end` with [`ENVIRONMENTS`].
#[rustfmt::skip]
const WORDS: &[&str] = &[
    // Letters.
    "alpha", "beta", "gamma", "delta", "epsilon", "varepsilon", "zeta", "eta", "theta", "vartheta", "iota", "kappa", "lambda", "mu", "nu", "xi",
    "pi", "varpi", "rho", "varrho", "sigma", "varsigma", "tau", "upsilon", "phi", "varphi", "chi", "psi", "omega", "Gamma", "Delta", "Theta",
    "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega", "ell", "hbar", "Re", "Im", "partial", "nabla", "infty", "imath", "jmath",
    // Functions.
    "sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "coth", "exp", "log", "ln", "lg", "min",
    "max", "sup", "inf", "lim", "limsup", "liminf", "det", "dim", "ker", "deg", "gcd", "arg", "Pr", "hom", "bmod", "pmod", "operatorname",
    // Operations.
    "cdot", "times", "div", "pm", "mp", "ast", "star", "circ", "bullet", "oplus", "ominus", "otimes", "oslash", "odot", "cap", "cup", "wedge",
    "vee", "setminus", "land", "lor", "neg", "lnot", "sum", "prod", "coprod", "int", "iint", "iiint", "oint", "bigcap", "bigcup", "bigoplus",
    "bigotimes", "limits", "nolimits", "prime", "dagger", "surd",
    // Relations and arrows.
    "le", "leq", "ge", "geq", "ne", "neq", "equiv", "sim", "simeq", "cong", "approx", "propto", "perp", "parallel", "mid", "nmid", "ll", "gg",
    "in", "ni", "notin", "subset", "subseteq", "supset", "supseteq", "prec", "succ", "not", "to", "gets", "mapsto", "rightarrow", "leftarrow",
    "leftrightarrow", "Rightarrow", "Leftarrow", "Leftrightarrow", "longrightarrow", "longleftarrow", "Longrightarrow", "Longleftarrow",
    "implies", "iff", "uparrow", "downarrow", "xrightarrow", "xleftarrow",
    // Signs.
    "forall", "exists", "emptyset", "varnothing", "angle", "triangle", "top", "bot", "ldots", "cdots", "vdots", "ddots", "dots", "colon",
    "square", "backslash",
    // Fractions, roots, accents above and below.
    "frac", "dfrac", "tfrac", "cfrac", "sqrt", "binom", "dbinom", "tbinom", "overline", "underline", "overrightarrow", "overleftarrow",
    "overbrace", "underbrace", "hat", "widehat", "bar", "vec", "dot", "ddot", "tilde", "widetilde", "acute", "grave", "check", "breve",
    "overset", "underset", "stackrel", "substack", "boxed",
    // Faces and sizes.
    "mathbf", "mathrm", "mathit", "mathsf", "mathtt", "mathcal", "mathbb", "mathfrak", "boldsymbol", "text", "textbf", "textit", "textrm",
    "displaystyle", "textstyle", "scriptstyle", "scriptscriptstyle",
    // Brackets.
    "left", "right", "middle", "big", "Big", "bigg", "Bigg", "bigl", "bigr", "Bigl", "Bigr", "biggl", "biggr", "Biggl", "Biggr", "lfloor",
    "rfloor", "lceil", "rceil", "langle", "rangle", "lvert", "rvert", "lVert", "rVert", "vert", "Vert", "lbrace", "rbrace", "lbrack", "rbrack",
    // Spaces, and lines of tables.
    "quad", "qquad", "enspace", "thinspace", "phantom", "hline",
];

/// Control signs: spaces, brackets, a new row, and signs that mean something else without the backslash.
const SIGNS: &[char] = &[',', ';', ':', '!', '>', ' ', '{', '}', '|', '\\', '%', '#', '_', '&'];

/// Words whose braces contain text.
const TEXTS: &[&str] = &["text", "textbf", "textit", "textrm"];

/// The environments that a formula may have.
const ENVIRONMENTS: &[&str] = &[
    "matrix",
    "pmatrix",
    "bmatrix",
    "Bmatrix",
    "vmatrix",
    "Vmatrix",
    "smallmatrix",
    "cases",
    "aligned",
    "gathered",
    "array",
];

/// LaTeX for a sign that people type directly in a formula.
pub fn sign(c: char) -> Option<String> {
    let own = match c {
        '−' => "-",
        '‖' => r"\|",
        '°' => r"{}^{\circ}",
        '⁻' => "{}^-",
        'ₙ' => "{}_n",
        '′' => r"{}^\prime",
        '…' => r"\dots",
        '<' => "<",
        '>' => ">",
        c => return in_line::raised_by(c).map(|raised| format!("{{}}^{raised}")).or_else(|| in_line::word_for(c)),
    };
    Some(own.to_owned())
}

/// Words in LaTeX, outside mathematics. A sign that LaTeX doesn't have becomes its number.
pub fn words(text: &str) -> String {
    let mut latex = String::new();
    for c in text.chars() {
        match c {
            '_' | '&' | '%' | '#' | '{' | '}' | '$' => {
                latex.push('\\');
                latex.push(c);
            }
            '\\' => latex.push_str("\\textbackslash{}"),
            '^' => latex.push_str("\\textasciicircum{}"),
            '~' => latex.push_str("\\textasciitilde{}"),
            // A command of its own in some languages of LaTeX.
            '"' => latex.push_str("\\textquotedbl{}"),
            '`' => latex.push('\''),
            '[' | ']' => {
                latex.push('{');
                latex.push(c);
                latex.push('}');
            }
            '…' => latex.push_str("\\dots{}"),
            '“' => latex.push_str("``"),
            '”' => latex.push_str("''"),
            '‘' => latex.push('`'),
            '’' => latex.push('\''),
            '–' => latex.push_str("--"),
            '—' => latex.push_str("---"),
            // A blank line would end a paragraph inside an argument.
            c if c.is_whitespace() || c.is_control() => latex.push(' '),
            c => match sign(c) {
                Some(symbol) => latex.push_str(&format!("${symbol}$")),
                None if c.is_ascii_graphic() || is_latin(c) => latex.push(c),
                // LaTeX would stop at the character itself.
                None => latex.push_str(&format!("{{[}}U+{:04X}{{]}}", u32::from(c))),
            },
        }
    }
    latex
}

/// Checks that the formulas of a text, between dollar signs, are mathematics.
///
/// # Errors
/// [`FormulaError`] for the first formula that isn't.
pub fn check(text: &str) -> Result<(), FormulaError> {
    let mut parts = text.split('$');
    // The text before the first dollar sign.
    parts.next();
    while let Some(mut formula) = parts.next() {
        // Between two dollar signs on each side, it's on a line of its own.
        let is_display = formula.is_empty() && parts.clone().next().is_some_and(|inner| !inner.trim().is_empty());
        let mut is_closed = true;
        if is_display {
            formula = parts.next().unwrap_or_default();
            is_closed = parts.next() == Some("");
        }
        let error = |problem| FormulaError { formula: formula.to_owned(), problem };
        parts.next().filter(|_| is_closed).ok_or_else(|| error(FormulaProblem::Open))?;
        check_one(formula).map_err(error)?;
    }
    Ok(())
}

/// Checks that a formula is mathematics. `latex` is the text between the dollar signs.
///
/// *Guarantees*: LaTeX that sets it between dollar signs with amsmath and amssymb reads no file, runs no program,
/// defines nothing, and is back in text mode at its end.
///
/// # Errors
/// The problem.
pub fn check_one(latex: &str) -> Result<(), FormulaProblem> {
    if latex.trim().is_empty() {
        return Err(FormulaProblem::Empty);
    }
    if latex.chars().count() > MAX_FORMULA.0 {
        return Err(FormulaProblem::TooLong);
    }
    let mut reader = Reader { rest: latex, open: Vec::new() };
    while reader.step()? {
        if reader.open.len() > MAX_FORMULA.1 {
            return Err(FormulaProblem::TooLong);
        }
    }
    reader.open.pop().map_or(Ok(()), |open| Err(FormulaProblem::Unbalanced(open.written())))
}

/// The formula for LaTeX, in which signs that people type directly become LaTeX words.
pub fn latex(formula: &str) -> String {
    let mut latex = String::with_capacity(formula.len());
    for c in formula.chars() {
        match sign(c).filter(|_| !c.is_ascii()) {
            // Writing to a String can't fail.
            Some(sign) => write!(latex, "{{{sign}}}").unwrap_or(()),
            None => latex.push(c),
        }
    }
    latex
}

/// True for the control words that a formula may have.
pub fn is_word(word: &str) -> bool {
    WORDS.contains(&word) || TEXTS.contains(&word)
}

/// An open group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Open<'a> {
    Brace { is_text: bool },
    Left,
    Environment(&'a str),
}

impl Open<'_> {
    fn written(self) -> String {
        match self {
            Self::Brace { .. } => "{".to_owned(),
            Self::Left => r"\left".to_owned(),
            Self::Environment(name) => format!(r"\begin{{{name}}}"),
        }
    }
}

struct Reader<'a> {
    rest: &'a str,
    open: Vec<Open<'a>>,
}

impl<'a> Reader<'a> {
    /// Reads on by a character or a control word. False at the end.
    fn step(&mut self) -> Result<bool, FormulaProblem> {
        let mut chars = self.rest.chars();
        let Some(c) = chars.next() else { return Ok(false) };
        self.rest = chars.as_str();
        match c {
            '\\' => self.control()?,
            '{' => self.open.push(Open::Brace { is_text: self.is_text() }),
            '}' => self.close("}", |open| matches!(open, Open::Brace { .. }))?,
            // TeX reads characters by their numbers in this form.
            '^' if self.rest.starts_with('^') => return Err(FormulaProblem::Word("^^".to_owned())),
            '&' if !self.open.iter().any(|open| matches!(open, Open::Environment(_))) => {
                return Err(FormulaProblem::Character(c));
            }
            // A blank line would end it.
            '\n' if self.rest.trim_start_matches([' ', '\t']).starts_with('\n') => {
                return Err(FormulaProblem::Character(c));
            }
            ' ' | '\n' | '\t' => {}
            '%' | '#' | '$' | '"' => return Err(FormulaProblem::Character(c)),
            c if c.is_ascii_graphic() => {}
            c if self.is_text() && is_latin(c) => {}
            c if !self.is_text() && sign(c).is_some() => {}
            c => return Err(FormulaProblem::Character(c)),
        }
        Ok(true)
    }

    /// True between the braces of words.
    fn is_text(&self) -> bool {
        matches!(self.open.last(), Some(Open::Brace { is_text: true }))
    }

    /// The command after a backslash.
    fn control(&mut self) -> Result<(), FormulaProblem> {
        let end = self.rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        if word.is_empty() {
            let c = rest.chars().next();
            let known = c.filter(|c| SIGNS.contains(c));
            let Some(c) = known else {
                return Err(FormulaProblem::Word(format!("\\{}", c.map_or_else(String::new, String::from))));
            };
            self.rest = &rest[c.len_utf8()..];
            return Ok(());
        }
        self.rest = rest;
        match word {
            "begin" => {
                let name = self.environment()?;
                self.open.push(Open::Environment(name));
            }
            "end" => {
                let name = self.environment()?;
                self.close(&format!(r"\end{{{name}}}"), |open| *open == Open::Environment(name))?;
            }
            "left" => self.open.push(Open::Left),
            "right" => self.close(r"\right", |open| *open == Open::Left)?,
            word if TEXTS.contains(&word) => {
                let braced = self.rest.trim_start_matches(' ').strip_prefix('{');
                self.rest = braced.ok_or_else(|| FormulaProblem::Unbalanced(format!("\\{word}")))?;
                self.open.push(Open::Brace { is_text: true });
            }
            word if WORDS.contains(&word) => {}
            word => return Err(FormulaProblem::Word(format!("\\{word}"))),
        }
        Ok(())
    }

    /// The name of an environment in braces, with the columns of an array.
    fn environment(&mut self) -> Result<&'a str, FormulaProblem> {
        let braced = |text: &'a str| text.strip_prefix('{')?.split_once('}');
        let (name, rest) =
            braced(self.rest).ok_or_else(|| FormulaProblem::Environment(self.rest.chars().take(20).collect()))?;
        if !ENVIRONMENTS.contains(&name) {
            return Err(FormulaProblem::Environment(name.to_owned()));
        }
        self.rest = rest;
        if name == "array" && rest.starts_with('{') {
            let columns = braced(rest).filter(|(columns, _)| columns.chars().all(|c| "lcr| ".contains(c)));
            (_, self.rest) = columns.ok_or_else(|| FormulaProblem::Environment(name.to_owned()))?;
        }
        Ok(name)
    }

    fn close(&mut self, written: &str, is_it: impl FnOnce(&Open<'_>) -> bool) -> Result<(), FormulaProblem> {
        match self.open.pop() {
            Some(open) if is_it(&open) => Ok(()),
            _ => Err(FormulaProblem::Unbalanced(written.to_owned())),
        }
    }
}

/// Accented letters that LaTeX has in text with its encoding T1.
pub fn is_latin(c: char) -> bool {
    ('\u{a1}'..='\u{17e}').contains(&c) && !"\u{ad}ĦħĸĿŀŉŦŧ".contains(c)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn mathematics_is_let_through() {
        for text in [
            "no mathematics at all, \\input{x} %",
            r"$\theta = 60^{\circ}$ and $a<b$",
            r"$\mathbf{n} = \frac{C - \mathrm{PF}}{\left\| C - \mathrm{PF} \right\|}$",
            r"$\begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}$",
            r"$\left\{ \begin{array}{l|c} a & b \\ \hline c & d \end{array} \right.$",
            r"$\text{não é } x'_i\,\mathbb{R}^3$",
            "$θ = 60°$, $a ≤ b$, $C − F$",
            "$a\nb$",
        ] {
            assert_eq!(check(text), Ok(()), "{text}");
        }
        assert_eq!(latex("θ^°<1"), r"{\theta}^{{}^{\circ}}<1");
    }

    #[test]
    fn commands_that_are_not_mathematics_are_named() {
        use FormulaProblem as P;
        let word = |text: &str| P::Word(text.to_owned());
        for (formula, problem) in [
            (r"\input{/etc/passwd}", word(r"\input")),
            (r"\input/etc/passwd ", word(r"\input")),
            (r"\InputIfFileExists{x}{}{}", word(r"\InputIfFileExists")),
            (r"\include{x}", word(r"\include")),
            (r"\@@input x", word(r"\@")),
            (r"\immediate\write18{id}", word(r"\immediate")),
            (r"\write18{id}", word(r"\write")),
            (r"\openin5=x \read5 to\x", word(r"\openin")),
            (r"\csname input\endcsname", word(r"\csname")),
            (r"\catcode`\%=12", word(r"\catcode")),
            (r"\def\x{\x}", word(r"\def")),
            (r"\let\x=\input", word(r"\let")),
            (r"\usepackage{shellesc}", word(r"\usepackage")),
            (r"\directlua{os.exit()}", word(r"\directlua")),
            (r"\lstinputlisting{x}", word(r"\lstinputlisting")),
            (r"\href{file:x}{y}", word(r"\href")),
            (r"\char92 input", word(r"\char")),
            (r"\verb|\input|", word(r"\verb")),
            (r"^^5cinput{x}", word("^^")),
            (r"x^^M", word("^^")),
            (r"\text{\input{x}}", word(r"\input")),
            (r"\sqrt[\input{x}]{2}", word(r"\input")),
            ("\\", word("\\")),
            ("\\\u{ff49}nput", word("\\\u{ff49}")),
            ("\u{ff3c}input", P::Character('\u{ff3c}')),
            ("a % b", P::Character('%')),
            ("#1", P::Character('#')),
            ("a & b", P::Character('&')),
            ("a\n \nb", P::Character('\n')),
            ("a\rb", P::Character('\r')),
            ("a\u{0}", P::Character('\u{0}')),
            (r"\begin{filecontents}{x}", P::Environment("filecontents".to_owned())),
            (r"\begin{document}", P::Environment("document".to_owned())),
            (r"\begin {verbatim}", P::Environment(" {verbatim}".to_owned())),
            (r"\begin{array}{@{\input{x}}c}\end{array}", P::Environment("array".to_owned())),
            (r"\end{document}", P::Environment("document".to_owned())),
            (r"\end{matrix}", P::Unbalanced(r"\end{matrix}".to_owned())),
            (r"\begin{matrix}{\end{matrix}}", P::Unbalanced(r"\end{matrix}".to_owned())),
            ("a}b{", P::Unbalanced("}".to_owned())),
            ("{a", P::Unbalanced("{".to_owned())),
            (r"\left( a", P::Unbalanced(r"\left".to_owned())),
            (r"\text a", P::Unbalanced(r"\text".to_owned())),
            (" ", P::Empty),
        ] {
            assert_eq!(check_one(formula), Err(problem), "{formula}");
        }
        assert_eq!(check_one(&"{".repeat(100_000)), Err(P::TooLong));
        assert_eq!(check_one(&format!("{}{}", "{".repeat(60), "}".repeat(60))), Err(P::TooLong));
        let open = check("costs 5 $ in all").map_err(|error| error.problem);
        assert_eq!((open, check("$$").map_err(|error| error.problem)), (Err(P::Open), Err(P::Empty)));
        // On a line of its own.
        assert_eq!(check("so $$x$$ and $y$"), Ok(()));
        for half in ["$$x$", "$$x$ $", "$$x"] {
            assert_eq!(check(half).map_err(|error| error.problem), Err(P::Open), "{half}");
        }
    }

    proptest! {
        /// Every accepted formula has only listed control words, and is balanced.
        #[test]
        fn accepted_formulas_hold_only_listed_words(
            parts in prop::collection::vec(prop_oneof![
                prop::sample::select(WORDS.to_vec()).prop_map(|word| format!("\\{word} ")),
                prop::sample::select(vec![
                    "\\input", "\\write18", "\\csname", "\\endcsname", "\\begin{matrix}", "\\end{matrix}", "\\begin{filecontents}", "{", "}", "%",
                    "#1", "$", "^^5c", "^", "_", "&", "\\\\", "\\", "\n", "\n\n", "\\text{", "x", "/etc/passwd", "é", "θ", "＼", "\u{202e}", " ",
                ]).prop_map(str::to_owned),
                "\\PC{0,4}",
            ], 0..12),
        ) {
            let formula = parts.concat();
            if check_one(&formula).is_ok() {
                let set = latex(&formula);
                let mut rest = set.as_str();
                let mut depth = 0_i32;
                while let Some(at) = rest.find(['\\', '{', '}', '%', '#', '$', '^', '\u{0}']) {
                    let found = rest.as_bytes()[at];
                    rest = &rest[at + 1..];
                    match found {
                        b'\\' => {
                            let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
                            let word = &rest[..end];
                            prop_assert!(word.is_empty() || WORDS.contains(&word) || ["begin", "end"].contains(&word), "{formula}");
                            // The sign after a backslash means itself.
                            rest = &rest[end.max(usize::from(end == 0))..];
                        }
                        b'{' => depth += 1,
                        b'}' => depth -= 1,
                        b'^' => prop_assert!(!rest.starts_with('^'), "{formula}"),
                        _ => prop_assert!(false, "{formula}"),
                    }
                    prop_assert!(depth >= 0, "{formula}");
                }
                prop_assert_eq!(depth, 0, "{}", formula);
            }
        }
    }
}
