//! A text → its numbers, under the names that stand before them.

use crate::camera::recovery::entries::Written;
use crate::camera::recovery::text::MatrixTextError;
use crate::expression::{self, Dimension};

/// The numbers that follow a name.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Segment {
    pub(crate) name: String,
    pub(crate) numbers: Vec<Written>,
    /// The counts of numbers between two ends of lines or brackets.
    pub(crate) lines: Vec<usize>,
}

impl Segment {
    /// The count of numbers in each line, if it's the same in several.
    pub(crate) fn in_line(&self) -> Option<usize> {
        let first = *self.lines.first()?;
        (self.lines.len() > 1 && first > 1 && self.lines.iter().all(|line| *line == first)).then_some(first)
    }
}

/// Names after which numbers aren't entries, such as the shape of an array.
const SHAPES: &str = "rows cols dt dtype shape size step channels device type version layout length prototype";

fn is_shape(name: &str) -> bool {
    let name = name.to_lowercase();
    SHAPES.split(' ').any(|shape| shape == name)
}

/// The numbers of a text, as people and programs print them: in any brackets and frames, with labels between them, and
/// each maybe an expression.
///
/// Beside them, the first word behind a number that names nothing: if their count is wrong, that's the reason.
///
/// # Errors
/// [`MatrixTextError::Part`] for a part that is neither a number nor a name.
pub(crate) fn segments(text: &str) -> Result<(Vec<Segment>, Option<String>), MatrixTextError> {
    let mut reader = Reader {
        segments: vec![Segment::default()],
        word: String::new(),
        line: 0,
        stray: None,
        factor: 1.0,
        has_numbers: false,
    };
    let text = without_indices(&without_comments(text));
    let plain: String = text.chars().map(|c| if is_separator(c) { ' ' } else { c }).collect();
    let decimal_commas = has_decimal_commas(&plain);
    // An odd one is an apostrophe.
    let pairs = ['"', '\''].map(|mark| text.matches(mark).count() % 2 == 0);
    let mut part = String::new();
    let mut quote = None;
    for c in text.chars().chain(['\n']) {
        let ends = c.is_whitespace() || is_separator(c) || c == ',' && !decimal_commas;
        if let Some(open) = quote {
            if c == open {
                reader.part(&part)?;
                part.clear();
                quote = None;
            } else if c == '\n' {
                quote = None;
            } else {
                part.push(c);
            }
            continue;
        }
        if !ends && c != '"' && c != '\'' {
            part.push(c);
            continue;
        }
        reader.part(&part)?;
        part.clear();
        if c == '"' && pairs[0] || c == '\'' && pairs[1] {
            quote = Some(c);
        } else if matches!(c, '\n' | ')' | ']' | '}' | ';' | '\\') {
            reader.end_line();
        }
    }
    reader.end_line();
    let Reader { mut segments, stray, .. } = reader;
    segments.retain(|segment| !segment.numbers.is_empty() && !is_shape(&segment.name));
    Ok((segments, stray))
}

/// The state of reading a text.
struct Reader {
    segments: Vec<Segment>,
    /// The word before, which a colon or an equals sign makes a name.
    word: String,
    /// Numbers since the last end of a line.
    line: usize,
    /// The first part that is neither a number nor a name.
    stray: Option<String>,
    /// A factor of all numbers that follow.
    factor: f64,
    /// A number came before.
    has_numbers: bool,
}

impl Reader {
    fn end_line(&mut self) {
        // There is always a last segment.
        if let Some(segment) = self.segments.last_mut().filter(|_| self.line > 0) {
            segment.lines.push(self.line);
        }
        self.line = 0;
    }

    /// Takes a part between two separators, which may be names and a number in one: `x=1`.
    fn part(&mut self, part: &str) -> Result<(), MatrixTextError> {
        let mut rest = part;
        loop {
            let bare = rest.trim_end_matches([':', '=']);
            let inner = bare.find([':', '=']).filter(|_| written(bare).is_none());
            let Some(at) = inner else { return self.simple(rest) };
            self.simple(&bare[..=at])?;
            rest = rest[at..].trim_start_matches([':', '=']);
        }
    }

    /// Takes a number, a word, or a word with the colon or equals sign that makes it a name.
    fn simple(&mut self, part: &str) -> Result<(), MatrixTextError> {
        let bare = part.trim_end_matches([':', '=']);
        let names = bare.len() < part.len();
        if self.has_numbers && matches!(part, "..." | "…") {
            return Err(MatrixTextError::Elided);
        }
        if part == "*" {
            self.scale();
        } else if bare.is_empty() {
            if names {
                self.begin();
            }
        } else if let Some(number) = written(bare) {
            // `0:` counts rows.
            if !names {
                self.number(number);
            }
        } else if !begins_number(bare)
            || !bare.contains(|c: char| c.is_ascii_digit())
            || bare.chars().any(char::is_alphabetic)
        {
            bare.clone_into(&mut self.word);
            if names {
                self.begin();
            } else if self.has_numbers {
                self.stray.get_or_insert_with(|| bare.to_owned());
            }
        } else {
            return Err(MatrixTextError::Part(part.to_owned()));
        }
        Ok(())
    }

    /// The last word names the numbers that follow.
    fn begin(&mut self) {
        self.end_line();
        let name = std::mem::take(&mut self.word);
        // OpenCV's `data:` is inside an entry that has a name of its own.
        if name == "data" {
            let parent = self.segments.iter().rev().find(|s| !s.name.is_empty() && !is_shape(&s.name));
            let name = parent.map_or(name, |parent| parent.name.clone());
            self.segments.push(Segment { name, ..Segment::default() });
        } else {
            self.segments.push(Segment { name, ..Segment::default() });
        }
    }

    /// `1.0e+03 *` of MATLAB, before the matrix.
    fn scale(&mut self) {
        if let Some(segment) = self.segments.last_mut()
            && let [factor] = segment.numbers[..]
        {
            self.factor = factor.value;
            segment.numbers.clear();
            self.line = 0;
        }
    }

    fn number(&mut self, number: Written) {
        self.line += 1;
        self.has_numbers = true;
        let number = Written { value: self.factor * number.value, error: self.factor * number.error };
        if let Some(segment) = self.segments.last_mut() {
            segment.numbers.push(number);
        }
    }
}

/// A number as programs write it; NaN and infinities are entries too, so that they can be named.
fn written(part: &str) -> Option<Written> {
    let lower = part.to_lowercase();
    let unsigned = lower.trim_start_matches(['+', '-', '−']).trim_start_matches("np.").trim_start_matches("math.");
    // `-1.#IND00` of C on Windows has digits behind it.
    let is_msvc = ["1.#ind", "1.#qnan", "1.#snan"].iter().any(|spelling| unsigned.starts_with(spelling));
    if unsigned == "nan" || is_msvc {
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
    let suffixes = ["_f32", "_f64", "f32", "f64", "f", "F", "d", "D", "L"];
    let bare = suffixes.iter().find_map(|suffix| part.strip_suffix(suffix)).unwrap_or(part);
    let value = expression::evaluate(bare.trim_start_matches('+'), Dimension::Number).ok()?;
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
fn is_separator(c: char) -> bool {
    "[](){}<>|;&\\".contains(c) || ('\u{2500}'..='\u{257f}').contains(&c) || ('\u{239b}'..='\u{23b1}').contains(&c)
}

/// The text without lines of comments.
pub(crate) fn without_comments(text: &str) -> String {
    let is_comment = |line: &&str| ["#", "//", "%"].iter().any(|mark| line.trim_start().starts_with(mark));
    text.lines().filter(|line| !is_comment(line)).collect::<Vec<_>>().join("\n")
}

/// The text without indices in brackets: `m[4][4] =`, and `[0]`, `[1]` … of debuggers.
fn without_indices(text: &str) -> String {
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

fn begins_number(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '−' | '.' | '+'))
}

/// True if commas stand inside the numbers, no more than one in each part, between digits.
fn has_decimal_commas(text: &str) -> bool {
    let is_decimal = |part: &str| {
        part.split_once(',').is_none_or(|(whole, decimals)| {
            !decimals.contains(',')
                && whole.ends_with(|c: char| c.is_ascii_digit())
                && decimals.starts_with(|c: char| c.is_ascii_digit())
        })
    };
    text.contains(',') && text.split_whitespace().all(is_decimal)
}
