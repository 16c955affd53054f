//! Formulas on one line, for labels in pictures: LaTeX → signs, with `_{…}` for subscripts.

use super::{FormulaError, FormulaProblem, check_one};

/// Turns the formulas of a text, between dollar signs, into signs: `$\theta_c$` → `θ_c`, `$\frac{H}{2}$` → `H/2`, and
/// `\mathbf{u}` into the bold letter of Unicode. Superscripts are those of Unicode, so only few things can be raised.
///
/// # Errors
/// [`FormulaError`] for the first formula that isn't one, or needs more than one line.
pub fn set(text: &str) -> Result<String, FormulaError> {
    let mut set = String::with_capacity(text.len());
    for (i, part) in text.split('$').enumerate() {
        let error = |problem| FormulaError { formula: part.to_owned(), problem };
        if i % 2 == 0 {
            set.push_str(part);
            continue;
        }
        if text.split('$').count() == i + 1 {
            return Err(error(FormulaProblem::Open));
        }
        check_one(part).map_err(error)?;
        set.push_str(Setter { rest: part }.all(None).map_err(error)?.trim());
    }
    Ok(set)
}

/// LaTeX words that are one sign.
#[rustfmt::skip]
const SIGNS: &[(&str, &str)] = &[
    ("alpha", "α"), ("beta", "β"), ("gamma", "γ"), ("delta", "δ"), ("epsilon", "ϵ"), ("varepsilon", "ε"), ("zeta", "ζ"), ("eta", "η"),
    ("theta", "θ"), ("vartheta", "ϑ"), ("iota", "ι"), ("kappa", "κ"), ("lambda", "λ"), ("mu", "μ"), ("nu", "ν"), ("xi", "ξ"), ("pi", "π"),
    ("rho", "ρ"), ("sigma", "σ"), ("tau", "τ"), ("upsilon", "υ"), ("phi", "ϕ"), ("varphi", "φ"), ("chi", "χ"), ("psi", "ψ"), ("omega", "ω"),
    ("Gamma", "Γ"), ("Delta", "Δ"), ("Theta", "Θ"), ("Lambda", "Λ"), ("Xi", "Ξ"), ("Pi", "Π"), ("Sigma", "Σ"), ("Phi", "Φ"), ("Psi", "Ψ"),
    ("Omega", "Ω"), ("ell", "ℓ"), ("partial", "∂"), ("nabla", "∇"), ("infty", "∞"),
    ("cdot", "·"), ("circ", "∘"), ("ast", "∗"), ("prime", "′"), ("surd", "√"), ("angle", "∠"), ("triangle", "△"), ("square", "□"),
    ("ldots", "…"), ("dots", "…"), ("cdots", "⋯"), ("colon", ":"), ("langle", "⟨"), ("rangle", "⟩"), ("lfloor", "⌊"), ("rfloor", "⌋"),
    ("lceil", "⌈"), ("rceil", "⌉"), ("vert", "|"), ("lvert", "|"), ("rvert", "|"), ("Vert", "‖"), ("lVert", "‖"), ("rVert", "‖"),
    ("lbrack", "["), ("rbrack", "]"), ("lbrace", "{"), ("rbrace", "}"), ("quad", " "), ("qquad", "  "), ("enspace", " "), ("thinspace", " "),
];

/// LaTeX words that stand between two things, with space on both sides.
#[rustfmt::skip]
const BETWEEN: &[(&str, &str)] = &[
    ("times", "×"), ("div", "÷"), ("pm", "±"), ("mp", "∓"), ("le", "≤"), ("leq", "≤"), ("ge", "≥"), ("geq", "≥"), ("ne", "≠"), ("neq", "≠"),
    ("equiv", "≡"), ("sim", "∼"), ("approx", "≈"), ("propto", "∝"), ("perp", "⊥"), ("parallel", "∥"), ("in", "∈"), ("to", "→"),
    ("rightarrow", "→"), ("leftarrow", "←"), ("gets", "←"), ("leftrightarrow", "↔"), ("Rightarrow", "⇒"), ("implies", "⇒"), ("iff", "⇔"),
    ("mapsto", "↦"), ("cap", "∩"), ("cup", "∪"), ("subset", "⊂"), ("otimes", "⊗"), ("oplus", "⊕"), ("wedge", "∧"), ("vee", "∨"),
];

/// Functions, which are written under their own names.
const FUNCTIONS: &[&str] =
    &["sin", "cos", "tan", "cot", "arcsin", "arccos", "arctan", "exp", "log", "ln", "min", "max", "det", "arg", "lim"];

/// Words whose braces contain text shown unchanged.
const AS_IT_IS: &[&str] = &["mathrm", "mathit", "text", "textrm", "textit", "operatorname", "left", "right"];

/// Words that change sizes.
const SIZES: &[&str] = &["displaystyle", "textstyle", "big", "Big", "bigl", "bigr", "Bigl", "Bigr", "limits"];

/// Signs that Unicode has as superscripts.
const RAISED: [&str; 2] = ["0123456789+−=()ni", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿⁱ"];

/// The LaTeX word for a sign beyond ASCII, the first of several.
pub(super) fn word_for(sign: char) -> Option<String> {
    // The square needs a package, which pictures for LaTeX do without.
    if sign == '□' {
        return None;
    }
    let (word, _) = SIGNS.iter().chain(BETWEEN).find(|(_, written)| written.chars().eq([sign]))?;
    (!sign.is_ascii()).then(|| format!("\\{word}"))
}

/// The sign whose superscript form this is.
pub(super) fn raised_by(c: char) -> Option<char> {
    let at = RAISED[1].chars().position(|raised| raised == c)?;
    RAISED[0].chars().nth(at)
}

/// The bold mathematical letter for a letter or digit of ASCII. Others stay as they are.
pub fn bold(c: char) -> char {
    let at = |first: u32, from: char| char::from_u32(first + (u32::from(c) - u32::from(from))).unwrap_or(c);
    match c {
        'A'..='Z' => at(0x1d400, 'A'),
        'a'..='z' => at(0x1d41a, 'a'),
        '0'..='9' => at(0x1d7ce, '0'),
        c => c,
    }
}

/// The italic mathematical letter for a letter of ASCII. Others stay as they are.
pub fn italic(c: char) -> char {
    let at = |first: u32, from: char| char::from_u32(first + (u32::from(c) - u32::from(from))).unwrap_or(c);
    match c {
        'A'..='Z' => at(0x1d434, 'A'),
        // Unicode has it as the constant of Planck.
        'h' => 'ℎ',
        'a'..='z' => at(0x1d44e, 'a'),
        c => c,
    }
}

/// A text of the pictures in mathematical letters, with single letters as symbols, **u**, **v** and **n** as vectors.
pub fn symbols(text: &str) -> String {
    let mut set = String::with_capacity(2 * text.len());
    let letters: Vec<char> = text.chars().collect();
    for (i, &c) in letters.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|i| letters.get(i).copied());
        let is_letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
        let is_single = !is_letter(before) && !is_letter(letters.get(i + 1).copied());
        let is_lowered = before == Some('_');
        set.push(match c {
            'u' | 'v' | 'n' if is_single && !is_lowered => bold(c),
            c if is_single => italic(c),
            c => c,
        });
    }
    set
}

/// Reads a formula that [`check_one`] accepts.
struct Setter<'a> {
    rest: &'a str,
}

impl Setter<'_> {
    /// Everything up to the end, or up to a closing sign.
    fn all(&mut self, end: Option<char>) -> Result<String, FormulaProblem> {
        let mut line = String::new();
        while let Some(c) = self.rest.chars().next() {
            if Some(c) == end {
                self.rest = &self.rest[c.len_utf8()..];
                break;
            }
            match c {
                ' ' | '\n' | '\t' => self.rest = &self.rest[1..],
                '_' => {
                    self.rest = &self.rest[1..];
                    let lowered = self.one()?;
                    if lowered.contains(['_', '{', '}']) {
                        return Err(FormulaProblem::NotOnALine(format!("_{{{lowered}}}")));
                    }
                    line.push_str(&format!("_{{{}}}", lowered.trim()));
                }
                '^' => {
                    self.rest = &self.rest[1..];
                    line.push_str(&raised(&self.one()?)?);
                }
                '=' | '<' | '>' | '+' => {
                    self.rest = &self.rest[1..];
                    between(&mut line, &c.to_string());
                }
                '-' | '−' => {
                    self.rest = &self.rest[c.len_utf8()..];
                    between(&mut line, "−");
                }
                ',' => {
                    self.rest = &self.rest[1..];
                    line.push_str(", ");
                }
                _ => line.push_str(&self.one()?),
            }
        }
        Ok(line)
    }

    /// The next thing: a sign, a word with its arguments, or the content of braces.
    fn one(&mut self) -> Result<String, FormulaProblem> {
        self.rest = self.rest.trim_start_matches([' ', '\n', '\t']);
        let Some(c) = self.rest.chars().next() else { return Ok(String::new()) };
        self.rest = &self.rest[c.len_utf8()..];
        match c {
            '{' => self.all(Some('}')),
            '\\' => self.word(),
            '\'' => Ok("′".to_owned()),
            '&' | '~' => Ok(" ".to_owned()),
            c => Ok(italic(c).to_string()),
        }
    }

    fn word(&mut self) -> Result<String, FormulaProblem> {
        let end = self.rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        if word.is_empty() {
            let sign = rest.chars().next().unwrap_or(' ');
            self.rest = &rest[sign.len_utf8().min(rest.len())..];
            return match sign {
                '!' => Ok(String::new()),
                '|' => Ok("‖".to_owned()),
                '\\' => Err(FormulaProblem::NotOnALine("\\\\".to_owned())),
                '{' | '}' | '_' => Err(FormulaProblem::NotOnALine(format!("\\{sign}"))),
                ',' | ';' | ':' | '>' | ' ' => Ok(" ".to_owned()),
                sign => Ok(sign.to_string()),
            };
        }
        let named =
            |table: &[(&str, &'static str)]| table.iter().find(|(name, _)| *name == word).map(|(_, sign)| *sign);
        if let Some(sign) = named(SIGNS) {
            return if "{}".contains(sign) { Err(not_on_a_line(word)) } else { Ok(sign.to_owned()) };
        }
        if let Some(sign) = named(BETWEEN) {
            return Ok(format!(" {sign} "));
        }
        match word {
            word if FUNCTIONS.contains(&word) => Ok(format!("{word} ")),
            word if SIZES.contains(&word) => Ok(String::new()),
            "text" | "textrm" | "textit" | "textbf" => {
                // Spaces count in words.
                let inside = self.rest.trim_start_matches(' ').strip_prefix('{').unwrap_or_default();
                let (words, rest) = inside.split_once('}').unwrap_or((inside, ""));
                if words.contains(['{', '\\']) {
                    return Err(not_on_a_line(word));
                }
                let words = if word == "textbf" { words.chars().map(bold).collect() } else { words.to_owned() };
                self.rest = rest;
                Ok(words)
            }
            word if AS_IT_IS.contains(&word) => Ok(self.one()?.chars().map(upright).collect()),
            "mathbf" | "boldsymbol" => Ok(self.one()?.chars().map(upright).map(bold).collect()),
            "frac" | "dfrac" | "tfrac" => Ok(format!("{}/{}", together(&self.one()?), together(&self.one()?))),
            "sqrt" if !self.rest.trim_start().starts_with('[') => Ok(format!("√{}", together(&self.one()?))),
            word => Err(not_on_a_line(word)),
        }
    }
}

/// The letter of ASCII for an italic one. Others stay as they are.
fn upright(c: char) -> char {
    ('A'..='Z').chain('a'..='z').find(|letter| italic(*letter) == c).unwrap_or(c)
}

fn not_on_a_line(word: &str) -> FormulaProblem {
    FormulaProblem::NotOnALine(format!("\\{word}"))
}

/// A sum or a product in parentheses. A single thing stays as it is.
fn together(part: &str) -> String {
    if part.contains([' ', '/', '·', '(']) { format!("({part})") } else { part.to_owned() }
}

/// Adds a sign between the text so far and the following one. At the beginning, it's a sign of the following one.
fn between(line: &mut String, sign: &str) {
    let is_first = line.is_empty() || line.ends_with([' ', '(', '[', '|', '/']);
    if is_first && "+−".contains(sign) {
        line.push_str(sign);
    } else {
        line.push_str(&format!(" {sign} "));
    }
}

fn raised(text: &str) -> Result<String, FormulaProblem> {
    let text: String = text.chars().map(upright).collect();
    match text.trim() {
        "∘" => return Ok("°".to_owned()),
        "′" | "″" => return Ok(text.trim().to_owned()),
        "T" => return Ok("ᵀ".to_owned()),
        _ => {}
    }
    let [plain, high] = RAISED;
    let raise = |c: char| plain.chars().zip(high.chars()).find(|(p, _)| *p == c).map(|(_, high)| high);
    let signs: Option<String> = text.chars().filter(|c| *c != ' ').map(raise).collect();
    signs.ok_or_else(|| FormulaProblem::NotOnALine(format!("^{{{text}}}")))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn formulas_become_signs() {
        for (text, expected) in [
            ("window", "window"),
            (r"angle $\theta/2$ of view", "angle θ/2 of view"),
            (r"$\mathbf{u}$", "𝐮"),
            (r"$\frac{H}{2} = F\tan\frac{\theta}{2}$", "H/2 = Ftan θ/2"),
            (r"$\frac{a+b}{2}$", "(a + b)/2"),
            (r"$x_c^2 + y_{c}$", "x_{c}² + y_{c}"),
            (r"$-1 \le z_n \le 1$", "−1 ≤ z_{n} ≤ 1"),
            (r"$60^\circ$", "60°"),
            (r"$M_p^{-1}$", "M_{p}⁻¹"),
            (r"$\text{near face}, F$", "near face, F"),
            (r"$\sqrt{2}\,\sqrt{a-b}$", "√2 √(a − b)"),
            (r"$P'$ and $Q$", "P′ and Q"),
        ] {
            let upright: Result<String, _> = set(text).map(|line| line.chars().map(upright).collect());
            assert_eq!(upright.as_deref(), Ok(expected), "{text}");
        }
    }

    #[test]
    fn single_letters_are_symbols() {
        assert_eq!(symbols("u, x_n and PF"), "𝐮, 𝑥_𝑛 and PF");
        assert_eq!(symbols("window (F)"), "window (𝐹)");
        assert_eq!(set("$x + \\mathrm{h}$").as_deref(), Ok("𝑥 + h"));
    }

    #[test]
    fn formulas_that_need_more_than_a_line_are_named() {
        for text in [r"$\begin{matrix}a\end{matrix}$", r"$x^{k}$", r"$\hat x$", r"$x_{y_z}$", r"$a\\b$", r"$\{a\}$"] {
            let problem = set(text).map_err(|error| error.problem);
            assert!(matches!(problem, Err(FormulaProblem::NotOnALine(_))), "{text}: {problem:?}");
        }
        assert_eq!(set("5 $").map_err(|error| error.problem), Err(FormulaProblem::Open));
        assert_eq!(set(r"$\input{x}$").map_err(|error| error.problem), Err(FormulaProblem::Word(r"\input".to_owned())));
    }

    proptest! {
        #[test]
        fn any_text_is_set_or_refused(text in "[$\\\\_^{}a-c θ&'-]{0,24}|\\PC{0,30}") {
            if let Ok(line) = set(&text) {
                prop_assert!(!line.contains('\n') || text.contains('\n'));
            }
        }
    }
}
