//! Numbers as people write them, in fields of the window, on the command line and in figure files: `sqrt(2)/2`,
//! `45°`, `pi/3`, `1/3`, `12,5`, `−3`, `2e3`.
//!
//! ```text
//! whole   = sum [ "rad" ]
//! sum     = product { ("+" | "−") product }
//! product = sign { ("*" | "/" | nothing) sign }     2pi, 2√2 and 3(1+1) are products
//! sign    = { "−" | "+" } power
//! power   = unit [ "^" ( sign | group ) ]
//! unit    = atom { "°" | "deg" | "graus" | "%" }
//! atom    = number | "pi" | "(" sum ")" | function ( "(" sum ")" | group | unit ) | "√" unit | "\\frac" group group
//! group   = "{" sum "}"
//! ```
//!
//! A word may have a backslash before it, as in LaTeX: `\sqrt{3}`, `\pi`, `\cdot`.
//!
//! A comma is a decimal point. An angle is a quantity of its own. Degrees don't add to lengths, and `sin(30°)` is
//! exactly ½. Where an angle is expected, `pi` is 180° and a plain number is in degrees.

use std::ops::Range;

use crate::geometry::Angle;
use crate::limits::MAX_EXPRESSION;
use crate::sanitize;

/// The quantity that the number measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// A length, a factor, a ratio, a count.
    Number,
    /// An angle. The result is in degrees.
    Angle,
}

/// The reason why a text isn't a number, and the place of the fault.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{problem}")]
pub struct ExpressionError {
    /// The rule that the text breaks.
    pub problem: ExpressionProblem,
    /// The bytes of the text that are at fault. Empty, at its end, if something is missing.
    pub span: Range<usize>,
}

/// A problem in an expression.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExpressionProblem {
    /// The text is empty.
    #[error("a number is missing")]
    Empty,
    /// A character that has no meaning there.
    #[error("unexpected “{}”", sanitize::escaped(&.0.to_string()))]
    Unexpected(char),
    /// The text ends where something must follow.
    #[error("the expression is not finished")]
    Unfinished,
    /// A word that is neither a function nor a constant.
    #[error("unknown name “{}”", sanitize::escaped(.0))]
    UnknownName(String),
    /// More opening than closing parentheses.
    #[error("a “)” is missing")]
    MissingParenthesis,
    /// An angle in the place of a number, or the other way round.
    #[error("an angle and a number do not mix here")]
    MixedUnits,
    /// An angle without parentheses and without its unit: this number.
    #[error("an angle needs its unit here: write ({}°)", sanitize::escaped(.0))]
    NoUnit(String),
    /// The result is infinite or undefined.
    #[error("the result is not a finite number")]
    NotFinite,
    /// Too long or too deeply nested.
    #[error("the expression is too long")]
    TooLong,
}

/// Words for °.
const DEGREES: [&str; 3] = ["deg", "degrees", "graus"];
const MAX_LENGTH: usize = MAX_EXPRESSION.0;
const MAX_DEPTH: u32 = MAX_EXPRESSION.1;

/// The value of `text`, in degrees for an angle.
///
/// ```
/// # use camera_lab_engine::expression::{Dimension, evaluate};
/// assert_eq!(evaluate("1,5 * 2", Dimension::Number), Ok(3.0));
/// assert_eq!(evaluate("pi/6", Dimension::Angle), Ok(30.0));
/// assert_eq!(evaluate("2 * (3 + x)", Dimension::Number).map_err(|error| error.span), Err(9..10));
/// ```
///
/// # Errors
/// [`ExpressionError`] names the problem and its place. The value is never infinite, never NaN.
pub fn evaluate(text: &str, dimension: Dimension) -> Result<f64, ExpressionError> {
    evaluate_with(text, dimension, &[])
}

/// Like [`evaluate`], with numbers that have names, such as the F of an exercise in `2F/3`. Capitals don't matter.
///
/// ```
/// # use camera_lab_engine::expression::{Dimension, evaluate_with};
/// assert_eq!(evaluate_with("7 − 2F/3", Dimension::Number, &[("F", 6.0)]), Ok(3.0));
/// ```
///
/// # Errors
/// As for [`evaluate`].
pub fn evaluate_with(text: &str, dimension: Dimension, names: &[(&str, f64)]) -> Result<f64, ExpressionError> {
    if text.trim().is_empty() {
        return Err(ExpressionError { problem: ExpressionProblem::Empty, span: text.len()..text.len() });
    }
    if text.chars().count() > MAX_LENGTH {
        return Err(ExpressionError { problem: ExpressionProblem::TooLong, span: 0..text.len() });
    }
    let mut parser = Parser { text, rest: text, dimension, depth: 0, names };
    let mut value = parser.sum()?;
    if parser.eat_word("rad") {
        value = if value.is_angle { value } else { NumberOrAngle::degrees(value.value.to_degrees()) };
    }
    if let Some(c) = parser.peek() {
        return Err(parser.unexpected(c));
    }
    if value.is_angle && dimension == Dimension::Number {
        return Err(parser.error(0, ExpressionProblem::MixedUnits));
    }
    if value.value.is_finite() { Ok(value.value) } else { Err(parser.error(0, ExpressionProblem::NotFinite)) }
}

/// The parts of a list of expressions, between semicolons if there are any, so that a comma can be a decimal point.
/// Otherwise between the commas outside parentheses.
///
/// ```
/// # use camera_lab_engine::expression::parts;
/// assert_eq!(parts("sqrt(2,5), 0, 1").collect::<Vec<_>>(), ["sqrt(2,5)", " 0", " 1"]);
/// assert_eq!(parts("0,5; 1").collect::<Vec<_>>(), ["0,5", " 1"]);
/// ```
pub fn parts(text: &str) -> impl Iterator<Item = &str> {
    let separator = if text.contains(';') { ';' } else { ',' };
    let mut open = 0_usize;
    text.split(move |c| {
        match c {
            '(' => open += 1,
            ')' => open = open.saturating_sub(1),
            _ => {}
        }
        c == separator && open == 0
    })
}

/// The text around a fault, on one line, with the fault between two marks: `2*▸atn◂(1/2)`.
pub fn marked(text: &str, span: &Range<usize>) -> String {
    const AROUND: usize = 20;
    let (before, rest) = text.split_at_checked(span.start).unwrap_or((text, ""));
    let (fault, after) = rest.split_at_checked(span.len()).unwrap_or((rest, ""));
    let skipped = before.chars().count().saturating_sub(AROUND);
    let dots = if skipped > 0 { "…" } else { "" };
    let before: String = before.chars().skip(skipped).collect();
    let start = |part: &str| -> String {
        let dots = if part.chars().count() > AROUND { "…" } else { "" };
        part.chars().take(AROUND).collect::<String>() + dots
    };
    let shown = format!("{dots}{before}▸{}◂{}", start(fault), start(after));
    sanitize::printable(&shown.replace(char::is_whitespace, " "))
}

/// A number, or an angle in degrees. An operation that has no meaning for them is `None`.
#[derive(Clone, Copy, Debug)]
struct NumberOrAngle {
    value: f64,
    is_angle: bool,
}

impl NumberOrAngle {
    fn plain(value: f64) -> Self {
        Self { value, is_angle: false }
    }

    fn degrees(value: f64) -> Self {
        Self { value, is_angle: true }
    }

    fn number(self) -> Option<f64> {
        (!self.is_angle).then_some(self.value)
    }

    fn add(self, other: Self, sign: f64) -> Option<Self> {
        (self.is_angle == other.is_angle).then_some(Self { value: self.value + sign * other.value, ..self })
    }

    fn times(self, other: Self) -> Option<Self> {
        let is_angle = self.is_angle || other.is_angle;
        (!(self.is_angle && other.is_angle)).then_some(Self { value: self.value * other.value, is_angle })
    }

    fn over(self, other: Self) -> Option<Self> {
        let is_angle = self.is_angle && !other.is_angle;
        (self.is_angle || !other.is_angle).then_some(Self { value: self.value / other.value, is_angle })
    }
}

struct Parser<'a> {
    text: &'a str,
    rest: &'a str,
    dimension: Dimension,
    depth: u32,
    names: &'a [(&'a str, f64)],
}

impl<'a> Parser<'a> {
    /// Number of bytes read so far.
    fn at(&self) -> usize {
        self.text.len() - self.rest.len()
    }

    /// A fault in the text read from `start` on.
    fn error(&self, start: usize, problem: ExpressionProblem) -> ExpressionError {
        let read = &self.text[start..self.at()];
        let start = start + (read.len() - read.trim_start().len());
        ExpressionError { problem, span: start..(start + read.trim().len()) }
    }

    /// A fault at the character that comes next.
    fn unexpected(&self, c: char) -> ExpressionError {
        let at = self.at();
        ExpressionError { problem: ExpressionProblem::Unexpected(c), span: at..at + c.len_utf8() }
    }

    /// A fault at the end of the text.
    fn missing(&self, problem: ExpressionProblem) -> ExpressionError {
        ExpressionError { problem, span: self.text.len()..self.text.len() }
    }

    /// Goes one level deeper, until the caller comes back.
    fn deepen(&mut self) -> Result<(), ExpressionError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH { Err(self.error(0, ExpressionProblem::TooLong)) } else { Ok(()) }
    }

    /// The value, or the fault that the text read from `start` on mixes angles and numbers.
    fn unmixed<T>(&self, start: usize, value: Option<T>) -> Result<T, ExpressionError> {
        value.ok_or_else(|| self.error(start, ExpressionProblem::MixedUnits))
    }

    fn peek(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    fn eat(&mut self, any: &[char]) -> Option<char> {
        let c = self.peek().filter(|c| any.contains(c))?;
        self.rest = &self.rest[c.len_utf8()..];
        Some(c)
    }

    /// Takes one of these texts if it comes next.
    fn eat_any(&mut self, texts: &[&str]) -> bool {
        self.peek();
        let rest = texts.iter().find_map(|text| self.rest.strip_prefix(text));
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    /// The word that comes next, without taking it.
    fn word(&mut self) -> &'a str {
        self.peek();
        let end = self.rest.find(|c: char| !c.is_alphabetic()).unwrap_or(self.rest.len());
        &self.rest[..end]
    }

    fn eat_word(&mut self, word: &str) -> bool {
        let found = self.word().eq_ignore_ascii_case(word);
        if found {
            self.rest = &self.rest[word.len()..];
        }
        found
    }

    fn sum(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        let start = self.at();
        let mut value = self.product()?;
        while let Some(c) = self.eat(&['+', '-', '−', '–']) {
            let other = self.product()?;
            value = self.unmixed(start, value.add(other, if c == '+' { 1.0 } else { -1.0 }))?;
        }
        Ok(value)
    }

    fn product(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        let start = self.at();
        let mut value = self.sign()?;
        loop {
            let next = if self.eat(&['*', '×', '·']).is_some() || self.eat_any(&["\\cdot", "\\times"]) {
                value.times(self.sign()?)
            } else if self.eat(&['/', '÷']).is_some() {
                value.over(self.sign()?)
            } else if self.starts_factor() {
                value.times(self.power()?)
            } else {
                return Ok(value);
            };
            value = self.unmixed(start, next)?;
        }
    }

    /// True if a product continues without a sign, as in `2pi` or `2(1 + 1)`. But `rad` ends an expression.
    fn starts_factor(&mut self) -> bool {
        matches!(self.peek(), Some(c) if c.is_alphabetic() || matches!(c, '(' | '√' | '\\'))
            && !self.word().eq_ignore_ascii_case("rad")
    }

    fn sign(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        let mut sign = 1.0;
        while let Some(c) = self.eat(&['-', '−', '–', '+']) {
            if c != '+' {
                sign = -sign;
            }
        }
        let power = self.power()?;
        Ok(NumberOrAngle { value: sign * power.value, ..power })
    }

    fn power(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        self.deepen()?;
        let start = self.at();
        let mut value = self.unit()?;
        if self.eat(&['^']).is_some() {
            let exponent = if self.peek() == Some('{') { self.group(self.dimension)? } else { self.sign()? }.number();
            let power = value.number().zip(exponent).map(|(base, exponent)| base.powf(exponent));
            value = NumberOrAngle::plain(self.unmixed(start, power)?);
        }
        self.depth -= 1;
        Ok(value)
    }

    fn unit(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        let start = self.at();
        let mut value = self.atom()?;
        loop {
            let is_degrees = DEGREES.contains(&self.word().to_lowercase().as_str()) && self.is_unit();
            value = if is_degrees || self.eat(&['°', 'º']).is_some() || self.eat_any(&["^\\circ", "^{\\circ}"]) {
                NumberOrAngle::degrees(self.unmixed(start, value.number())?)
            } else if self.eat(&['%']).is_some() {
                NumberOrAngle::plain(self.unmixed(start, value.number())? / 100.0)
            } else {
                return Ok(value);
            };
        }
    }

    /// Takes the word that comes next as a unit, unless it's a name of the exercise.
    fn is_unit(&mut self) -> bool {
        let word = self.word();
        if self.names.iter().any(|(name, _)| name.eq_ignore_ascii_case(word)) {
            return false;
        }
        self.rest = &self.rest[word.len()..];
        true
    }

    fn atom(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        match self.peek() {
            None => Err(self.missing(ExpressionProblem::Unfinished)),
            Some('(') => self.parenthesis(self.dimension),
            Some('√') => {
                self.eat(&['√']);
                self.deepen()?;
                let start = self.at();
                let value = self.unit()?.number();
                self.depth -= 1;
                Ok(NumberOrAngle::plain(self.unmixed(start, value)?.sqrt()))
            }
            Some(c) if c.is_ascii_digit() || c == '.' || c == ',' => self.literal(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some('\\') => {
                self.eat(&['\\']);
                if !self.eat_any(&["frac", "dfrac", "tfrac"]) {
                    return self.name();
                }
                let start = self.at();
                let (above, below) = (self.group(self.dimension)?, self.group(Dimension::Number)?);
                self.unmixed(start, above.over(below))
            }
            Some(c) => Err(self.unexpected(c)),
        }
    }

    /// The argument of a function: in parentheses, in braces, an angle in degrees, as in `tan 20°`, or a number if
    /// no angle is meant, as in `sqrt 2`.
    fn argument(&mut self, dimension: Dimension) -> Result<NumberOrAngle, ExpressionError> {
        match self.peek() {
            Some('{') => self.group(dimension),
            Some(c) if c.is_ascii_digit() && dimension == Dimension::Angle => {
                let start = self.at();
                let value = self.unit()?;
                if value.is_angle {
                    return Ok(value);
                }
                let number = self.text[start..self.at()].trim().to_owned();
                Err(self.error(start, ExpressionProblem::NoUnit(number)))
            }
            Some(c) if c.is_ascii_digit() => self.unit(),
            _ => self.parenthesis(dimension),
        }
    }

    /// A sum in parentheses.
    fn parenthesis(&mut self, dimension: Dimension) -> Result<NumberOrAngle, ExpressionError> {
        self.between(['(', ')'], dimension)
    }

    /// A sum in braces.
    fn group(&mut self, dimension: Dimension) -> Result<NumberOrAngle, ExpressionError> {
        self.between(['{', '}'], dimension)
    }

    fn between(&mut self, [open, close]: [char; 2], dimension: Dimension) -> Result<NumberOrAngle, ExpressionError> {
        match self.peek() {
            None => return Err(self.missing(ExpressionProblem::Unfinished)),
            Some(c) if c == open => self.eat(&[open]),
            Some(c) => return Err(self.unexpected(c)),
        };
        let outer = std::mem::replace(&mut self.dimension, dimension);
        let value = self.sum()?;
        self.dimension = outer;
        match self.peek() {
            None => Err(self.missing(ExpressionProblem::MissingParenthesis)),
            Some(c) if c == close => {
                self.eat(&[close]);
                Ok(value)
            }
            Some(c) => Err(self.unexpected(c)),
        }
    }

    fn literal(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        let bytes = self.rest.as_bytes();
        let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
        let mut end = digits(0);
        if matches!(bytes.get(end), Some(b'.' | b',')) {
            end += 1 + digits(end + 1);
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = self.rest[end + 1..].chars().next().filter(|c| matches!(c, '+' | '-' | '−'));
            let sign = sign.map_or(0, char::len_utf8);
            let exponent = digits(end + 1 + sign);
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        let start = self.at();
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        // A point alone lacks digits.
        let value: Result<f64, _> = text.replace(',', ".").replace('−', "-").parse();
        let value = value.map_err(|_| self.error(start, ExpressionProblem::Unfinished))?;
        if let Some(c @ ('.' | ',' | '0'..='9')) = self.peek() {
            return Err(self.unexpected(c));
        }
        Ok(NumberOrAngle::plain(value))
    }

    fn name(&mut self) -> Result<NumberOrAngle, ExpressionError> {
        let start = self.at();
        let word = self.word();
        self.rest = &self.rest[word.len()..];
        if let Some((_, value)) = self.names.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)) {
            return Ok(NumberOrAngle::plain(*value));
        }
        let name = word.to_lowercase();
        match name.as_str() {
            "pi" | "π" => Ok(match self.dimension {
                Dimension::Number => NumberOrAngle::plain(std::f64::consts::PI),
                Dimension::Angle => NumberOrAngle::degrees(180.0),
            }),
            "sin" | "sen" | "cos" | "tan" | "tg" | "cot" | "cotg" => {
                let NumberOrAngle { value, is_angle } = self.argument(Dimension::Angle)?;
                let (sin, cos) = if is_angle { Angle::from_degrees(value).sin_cos() } else { value.sin_cos() };
                Ok(NumberOrAngle::plain(match name.as_str() {
                    "sin" | "sen" => sin,
                    "cos" => cos,
                    "cot" | "cotg" => cos / sin,
                    _ => sin / cos,
                }))
            }
            "asin" | "arcsin" | "arcsen" | "acos" | "arccos" | "atan" | "arctan" | "arctg" | "sqrt" | "raiz"
            | "abs" | "exp" | "ln" => {
                let inside = self.at();
                let v = self.argument(Dimension::Number)?.number();
                let v = self.unmixed(inside, v)?;
                Ok(match name.as_str() {
                    "asin" | "arcsin" | "arcsen" => NumberOrAngle::degrees(v.asin().to_degrees()),
                    "acos" | "arccos" => NumberOrAngle::degrees(v.acos().to_degrees()),
                    "atan" | "arctan" | "arctg" => NumberOrAngle::degrees(v.atan().to_degrees()),
                    "abs" => NumberOrAngle::plain(v.abs()),
                    "exp" => NumberOrAngle::plain(v.exp()),
                    "ln" => NumberOrAngle::plain(v.ln()),
                    _ => NumberOrAngle::plain(v.sqrt()),
                })
            }
            _ => Err(self.error(start, ExpressionProblem::UnknownName(word.to_owned()))),
        }
    }
}

#[cfg(test)]
mod tests;
