//! A text → its marks, words and numbers.

use crate::camera::recovery::reading::Written;
use crate::expression::{self, Dimension};

#[derive(Debug)]
pub(crate) enum Token {
    Word(String),
    Quoted(String),
    Number(Written),
    Open(char),
    Close(char),
    Comma,
    Semicolon,
    /// True for `: `.
    Assign(bool),
    /// A dash before an item of YAML.
    Dash,
    /// The end of a line: the indentation of the next one, and if an empty one lies between.
    Line(usize, bool),
    End,
}

/// A text on its way.
pub(crate) struct Reader<'a> {
    pub(crate) rest: &'a str,
    pub(crate) decimal_commas: bool,
    pub(crate) column: usize,
    /// The indentation of this line, or of this item.
    pub(crate) indent: usize,
    pub(crate) at_start: bool,
    pub(crate) after_space: bool,
    /// `1.0e+03 *` of MATLAB before a matrix.
    pub(crate) factor: f64,
    /// Tokens that were looked at, the next one last.
    pub(crate) ahead: Vec<Token>,
    pub(crate) has_numbers: bool,
    pub(crate) is_elided: bool,
}

impl Reader<'_> {
    fn skip(&mut self, bytes: usize) {
        self.column += bytes;
        self.rest = &self.rest[bytes..];
    }

    pub(crate) fn peek(&mut self) -> &Token {
        let token = self.token();
        self.ahead.push(token);
        // It was pushed.
        &self.ahead[self.ahead.len() - 1]
    }

    pub(crate) fn token(&mut self) -> Token {
        if let Some(token) = self.ahead.pop() {
            return token;
        }
        loop {
            let Some(c) = self.rest.chars().next() else { return Token::End };
            let (at_start, after_space) = (self.at_start, self.after_space);
            let after = &self.rest[c.len_utf8()..];
            if c == '\n' {
                let rest = self.rest.trim_start();
                let passed = &self.rest[..self.rest.len() - rest.len()];
                self.column = passed.rsplit('\n').next().map_or(0, str::len);
                self.rest = rest;
                (self.at_start, self.after_space) = (true, true);
                return Token::Line(self.column, passed.matches('\n').count() > 1);
            }
            if c == '#' && after_space || self.rest.starts_with("//") {
                self.skip(self.rest.find('\n').unwrap_or(self.rest.len()));
                continue;
            }
            self.after_space = c.is_whitespace();
            if c == '-' && at_start && after.starts_with([' ', '\n', '\r']) {
                self.skip(1);
                let rest = self.rest.trim_start_matches(' ');
                self.skip(self.rest.len() - rest.len());
                return Token::Dash;
            }
            self.at_start &= c.is_whitespace();
            if matches!(c, '"' | '\'') {
                self.skip(1);
                if let Some(text) = self.quoted(c) {
                    return Token::Quoted(text);
                }
                continue;
            }
            // A unit: `FOV (degrees): 35`.
            if let Some((unit, rest)) = after.split_once(')').filter(|_| c == '(')
                && unit.chars().all(char::is_alphabetic)
                && rest.trim_start_matches(' ').starts_with(':')
            {
                self.skip(unit.len() + 2);
                continue;
            }
            let is_bracket = c != '<' || after.starts_with(|c: char| c.is_alphanumeric() || "+-. ".contains(c));
            let token = match c {
                '[' | '(' | '{' | '<' if is_bracket => Token::Open(c),
                ']' | ')' | '}' | '>' => Token::Close(c),
                ',' if !self.decimal_commas => Token::Comma,
                ';' | '\\' => Token::Semicolon,
                ':' | '=' => Token::Assign(c == ':' && after.starts_with(char::is_whitespace)),
                _ if c.is_whitespace() || is_separator(c) => {
                    self.skip(c.len_utf8());
                    continue;
                }
                _ => return self.part(),
            };
            self.skip(1);
            return token;
        }
    }

    /// The text up to the other quote, which is on the same line.
    fn quoted(&mut self, mark: char) -> Option<String> {
        let mut is_escaped = false;
        let is_end = |(_, c): &(usize, char)| {
            let ends = *c == '\n' || *c == mark && !is_escaped;
            is_escaped = *c == '\\' && !is_escaped;
            ends
        };
        let (end, _) = self.rest.char_indices().find(is_end).filter(|(_, c)| *c == mark)?;
        let written = &self.rest[..end];
        // What JSON escapes, `\u00e9`. A path with backslashes that JSON doesn't know stays as it is.
        let unescaped = (mark == '"').then(|| serde_json::from_str(&format!("\"{written}\"")).ok()).flatten();
        let text = unescaped.unwrap_or_else(|| written.to_owned());
        self.skip(end + 1);
        Some(text)
    }

    /// A word or a number.
    fn part(&mut self) -> Token {
        let mut word = String::new();
        loop {
            let ends = |c: char| {
                c.is_whitespace() || is_separator(c) || "\"':=".contains(c) || c == ',' && !self.decimal_commas
            };
            let end = self.rest.find(ends).unwrap_or(self.rest.len());
            word.push_str(&self.rest[..end]);
            self.skip(end);
            // `a::b` and `a->b` are names with a point.
            if self.rest.starts_with("::") {
                word.push('.');
                self.skip(2);
            } else if self.rest.starts_with('>') && word.ends_with('-') && word.len() > 1 {
                word.pop();
                word.push('.');
                self.skip(1);
            } else {
                break;
            }
        }
        // `0:` counts rows.
        if !self.rest.starts_with([':', '='])
            && let Some(mut number) = written(&word)
        {
            number.value *= self.factor;
            number.error *= self.factor;
            self.has_numbers = true;
            return Token::Number(number);
        }
        self.is_elided |= self.has_numbers && matches!(word.as_str(), "..." | "…");
        Token::Word(word)
    }
}

/// A number as programs write it; NaN and infinities are entries too, so that they can be named.
pub(crate) fn written(part: &str) -> Option<Written> {
    let lower = part.to_lowercase();
    let unsigned = lower.trim_start_matches(['+', '-', '−']).trim_start_matches("np.").trim_start_matches("math.");
    // `-1.#IND00` of C on Windows has digits behind it.
    let is_msvc = ["1.#ind", "1.#qnan", "1.#snan"].iter().any(|spelling| unsigned.starts_with(spelling));
    // `null` is the NaN of JavaScript.
    if matches!(unsigned, "nan" | "null") || is_msvc {
        return Some(Written { value: f64::NAN, error: 0.0 });
    }
    if ["inf", "infinity", "∞"].contains(&unsigned) || unsigned.starts_with("1.#inf") {
        let value = if lower.starts_with(['-', '−']) { f64::NEG_INFINITY } else { f64::INFINITY };
        return Some(Written { value, error: 0.0 });
    }
    if !begins_number(part) {
        return None;
    }
    // Suffixes of C, C# and Rust.
    let suffixes = ["mm", "°", "deg", "_f32", "_f64", "f32", "f64", "f", "F", "d", "D", "L"];
    let bare = suffixes.iter().find_map(|suffix| part.strip_suffix(suffix)).unwrap_or(part);
    let quotient = bare.replace("f/", "/");
    let bare = if begins_number(bare) { quotient.as_str() } else { bare };
    let bare_value =
        bare.parse().ok().or_else(|| expression::evaluate(bare.trim_start_matches('+'), Dimension::Number).ok());
    let value: f64 = bare_value?;
    Some(Written { value, error: error(bare, value) })
}

/// Half of the last digit. Numbers with the digits of an `f32` have its rounding, shorter ones are what they say.
fn error(text: &str, value: f64) -> f64 {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let Some((_, decimals)) = mantissa.split_once(['.', ',']) else { return 0.0 };
    let digits = mantissa.chars().filter(char::is_ascii_digit).count();
    let exponent: i32 = exponent.trim_start_matches('+').parse().unwrap_or(0);
    let places = i32::try_from(decimals.len()).unwrap_or(i32::MAX);
    let last = 0.5 * 10.0_f64.powi(exponent.saturating_sub(places));
    if digits > 7 { last.max(6e-8 * value.abs()) } else { last }
}

/// Brackets and quotes, and the frames of matrices in consoles.
pub(crate) fn is_separator(c: char) -> bool {
    "[](){}<>|;&\\".contains(c) || ('\u{2500}'..='\u{257f}').contains(&c) || ('\u{239b}'..='\u{23b1}').contains(&c)
}

/// The text without lines of comments.
pub(crate) fn without_comments(text: &str) -> String {
    let is_comment = |line: &&str| ["#", "//", "%"].iter().any(|mark| line.trim_start().starts_with(mark));
    text.lines().filter(|line| !is_comment(line)).collect::<Vec<_>>().join("\n")
}

/// The text without indices in brackets: `m[4][4] =`, and `[0]`, `[1]` … of debuggers.
pub(crate) fn without_indices(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('[') {
        let inside = &rest[at + 1..];
        // `[1,]` and `[,1]` are those of R.
        let digits = inside.chars().take_while(|c| c.is_ascii_digit() || *c == ',').count();
        let is_of_r = inside[..digits].len() > 1 && inside[..digits].matches(',').count() == 1;
        let closes = inside[digits..].starts_with(']')
            && (is_of_r && inside[..digits].trim_matches(',').len() + 1 == digits
                || digits > 0 && !inside[..digits].contains(','));
        let after = inside.get(digits + 1..).unwrap_or_default().trim_start_matches(' ');
        let before = plain.chars().chain(rest[..at].chars()).next_back();
        let follows_name = before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '\u{1}');
        plain.push_str(&rest[..at]);
        if closes
            && (is_of_r || follows_name || after.starts_with(['=', ':', '{', '(', '\t', '[']) || begins_number(after))
        {
            // Remembers that a second index follows.
            plain.push('\u{1}');
            rest = &inside[digits + 1..];
        } else {
            plain.push('[');
            rest = inside;
        }
    }
    plain.push_str(rest);
    plain.replace('\u{1}', " ")
}

pub(crate) fn begins_number(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '−' | '.' | '+'))
}

/// True if commas stand inside the numbers, no more than one in each part, between digits.
pub(crate) fn has_decimal_commas(text: &str) -> bool {
    let is_decimal = |part: &str| {
        part.split_once(',').is_none_or(|(whole, decimals)| {
            !decimals.contains(',')
                && whole.ends_with(|c: char| c.is_ascii_digit())
                && decimals.starts_with(|c: char| c.is_ascii_digit())
        })
    };
    text.contains(',') && text.split_whitespace().all(is_decimal)
}

/// The vectors of POV-Ray that are written with its axes: `x*4/3`, `-1.5*z`.
pub(crate) fn pov(text: &str) -> String {
    let vector = |word: &str| {
        let (sign, own) = word.strip_prefix('-').map_or((1.0, word), |own| (-1.0, own));
        let axis = ["x", "y", "z"].map(|axis| own.split('*').any(|factor| factor == axis));
        let others: Vec<&str> = own.split('*').filter(|factor| !["x", "y", "z"].contains(factor)).collect();
        let factor = if others.is_empty() { 1.0 } else { written(&others.join("*"))?.value };
        let [x, y, z] = axis.map(|is_it| if is_it { sign * factor } else { 0.0 });
        axis.contains(&true).then(|| format!("<{x}, {y}, {z}>"))
    };
    let words = text.split_inclusive(char::is_whitespace);
    words
        .map(|word| {
            vector(word.trim_end()).map_or_else(|| word.to_owned(), |vector| vector + &word[word.trim_end().len()..])
        })
        .collect()
}
