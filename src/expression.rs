//! Numbers as people write them, in fields of the window, on the command line and in figure files: `sqrt(2)/2`,
//! `45°`, `pi/3`, `1/3`, `12,5`, `−3`, `2e3`.
//!
//! ```text
//! whole   = sum [ "rad" ]
//! sum     = product { ("+" | "−") product }
//! product = sign { ("*" | "/" | nothing) sign }     2pi, 2√2 and 3(1+1) are products
//! sign    = { "−" | "+" } power
//! power   = unit [ "^" sign ]
//! unit    = atom { "°" }
//! atom    = number | "pi" | "(" sum ")" | function "(" sum ")" | "√" unit
//! ```
//!
//! A comma is a decimal point. An angle is a quantity of its own: degrees do not add to lengths, and `sin(30°)` is
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
    /// An angle; the result is in degrees.
    Angle,
}

/// Why a text is not a number, and where in the text that shows.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{problem}")]
pub struct ExpressionError {
    /// The problem.
    pub problem: ExpressionProblem,
    /// The bytes of the text that are at fault; empty, at its end, where something is missing.
    pub span: Range<usize>,
}

/// A problem in an expression.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ExpressionProblem {
    /// Nothing was typed.
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
    /// An angle where a number must stand, or the other way round.
    #[error("an angle and a number do not mix here")]
    MixedUnits,
    /// The result is infinite or undefined.
    #[error("the result is not a finite number")]
    NotFinite,
    /// Too long or too deeply nested.
    #[error("the expression is too long")]
    TooLong,
}

const MAX_LENGTH: usize = MAX_EXPRESSION.0;
const MAX_DEPTH: u32 = MAX_EXPRESSION.1;

/// The value of `text`; of an angle, its degrees.
///
/// ```
/// # use camera_lab::expression::{Dimension, evaluate};
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

/// As [`evaluate`], with numbers that have names: the F of an exercise in `2F/3`. Capitals do not matter.
///
/// ```
/// # use camera_lab::expression::{Dimension, evaluate_with};
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
        value = match value {
            Quantity::Number(radians) => Quantity::Degrees(radians.to_degrees()),
            degrees @ Quantity::Degrees(_) => degrees,
        };
    }
    if let Some(c) = parser.peek() {
        return Err(parser.unexpected(c));
    }
    let value = match (value, dimension) {
        (Quantity::Number(v) | Quantity::Degrees(v), Dimension::Angle) | (Quantity::Number(v), Dimension::Number) => v,
        (Quantity::Degrees(_), Dimension::Number) => return Err(parser.error(0, ExpressionProblem::MixedUnits)),
    };
    if value.is_finite() { Ok(value) } else { Err(parser.error(0, ExpressionProblem::NotFinite)) }
}

/// The parts of a list of expressions: between semicolons, where there are any, so that a comma can be a decimal point;
/// otherwise between the commas outside of parentheses.
///
/// ```
/// # use camera_lab::expression::parts;
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
#[must_use]
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

/// A number or an angle; an operation that has no meaning for them is `None`.
#[derive(Clone, Copy, Debug)]
enum Quantity {
    Number(f64),
    Degrees(f64),
}

impl Quantity {
    fn map(self, f: impl FnOnce(f64) -> f64) -> Self {
        match self {
            Self::Number(v) => Self::Number(f(v)),
            Self::Degrees(v) => Self::Degrees(f(v)),
        }
    }

    fn number(self) -> Option<f64> {
        match self {
            Self::Number(v) => Some(v),
            Self::Degrees(_) => None,
        }
    }

    fn add(self, other: Self, sign: f64) -> Option<Self> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Some(Self::Number(a + sign * b)),
            (Self::Degrees(a), Self::Degrees(b)) => Some(Self::Degrees(a + sign * b)),
            _ => None,
        }
    }

    fn times(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Some(Self::Number(a * b)),
            (Self::Number(a), Self::Degrees(b)) | (Self::Degrees(a), Self::Number(b)) => Some(Self::Degrees(a * b)),
            (Self::Degrees(_), Self::Degrees(_)) => None,
        }
    }

    fn over(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) | (Self::Degrees(a), Self::Degrees(b)) => Some(Self::Number(a / b)),
            (Self::Degrees(a), Self::Number(b)) => Some(Self::Degrees(a / b)),
            (Self::Number(_), Self::Degrees(_)) => None,
        }
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

    fn too_deep(&self) -> ExpressionError {
        self.error(0, ExpressionProblem::TooLong)
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

    fn sum(&mut self) -> Result<Quantity, ExpressionError> {
        let start = self.at();
        let mut value = self.product()?;
        while let Some(c) = self.eat(&['+', '-', '−', '–']) {
            let other = self.product()?;
            value = self.unmixed(start, value.add(other, if c == '+' { 1.0 } else { -1.0 }))?;
        }
        Ok(value)
    }

    fn product(&mut self) -> Result<Quantity, ExpressionError> {
        let start = self.at();
        let mut value = self.sign()?;
        loop {
            let next = if self.eat(&['*', '×', '·']).is_some() {
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

    /// True where a product goes on without a sign: `2pi`, `2(1 + 1)`; but `rad` ends an expression.
    fn starts_factor(&mut self) -> bool {
        matches!(self.peek(), Some(c) if c.is_alphabetic() || c == '(' || c == '√')
            && !self.word().eq_ignore_ascii_case("rad")
    }

    fn sign(&mut self) -> Result<Quantity, ExpressionError> {
        let mut sign = 1.0;
        while let Some(c) = self.eat(&['-', '−', '–', '+']) {
            if c != '+' {
                sign = -sign;
            }
        }
        Ok(self.power()?.map(|v| sign * v))
    }

    fn power(&mut self) -> Result<Quantity, ExpressionError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.too_deep());
        }
        let start = self.at();
        let mut value = self.unit()?;
        if self.eat(&['^']).is_some() {
            let exponent = self.sign()?.number();
            let power = value.number().zip(exponent).map(|(base, exponent)| base.powf(exponent));
            value = Quantity::Number(self.unmixed(start, power)?);
        }
        self.depth -= 1;
        Ok(value)
    }

    fn unit(&mut self) -> Result<Quantity, ExpressionError> {
        let start = self.at();
        let mut value = self.atom()?;
        while self.eat(&['°', 'º']).is_some() {
            value = Quantity::Degrees(self.unmixed(start, value.number())?);
        }
        Ok(value)
    }

    fn atom(&mut self) -> Result<Quantity, ExpressionError> {
        match self.peek() {
            None => Err(self.missing(ExpressionProblem::Unfinished)),
            Some('(') => self.parenthesis(self.dimension),
            Some('√') => {
                self.eat(&['√']);
                self.depth += 1;
                if self.depth > MAX_DEPTH {
                    return Err(self.too_deep());
                }
                let start = self.at();
                let value = self.unit()?.number();
                self.depth -= 1;
                Ok(Quantity::Number(self.unmixed(start, value)?.sqrt()))
            }
            Some(c) if c.is_ascii_digit() || c == '.' || c == ',' => self.literal(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some(c) => Err(self.unexpected(c)),
        }
    }

    fn parenthesis(&mut self, dimension: Dimension) -> Result<Quantity, ExpressionError> {
        match self.peek() {
            None => return Err(self.missing(ExpressionProblem::Unfinished)),
            Some('(') => self.eat(&['(']),
            Some(c) => return Err(self.unexpected(c)),
        };
        let outer = std::mem::replace(&mut self.dimension, dimension);
        let value = self.sum()?;
        self.dimension = outer;
        match self.peek() {
            None => Err(self.missing(ExpressionProblem::MissingParenthesis)),
            Some(')') => {
                self.eat(&[')']);
                Ok(value)
            }
            Some(c) => Err(self.unexpected(c)),
        }
    }

    fn literal(&mut self) -> Result<Quantity, ExpressionError> {
        let bytes = self.rest.as_bytes();
        let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
        let mut end = digits(0);
        if matches!(bytes.get(end), Some(b'.' | b',')) {
            end += 1 + digits(end + 1);
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let exponent = digits(end + 1 + sign);
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        let start = self.at();
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        // A point alone: digits are missing.
        let value: Result<f64, _> = text.replace(',', ".").parse();
        let value = value.map_err(|_| self.error(start, ExpressionProblem::Unfinished))?;
        if let Some(c @ ('.' | ',' | '0'..='9')) = self.peek() {
            return Err(self.unexpected(c));
        }
        Ok(Quantity::Number(value))
    }

    fn name(&mut self) -> Result<Quantity, ExpressionError> {
        let start = self.at();
        let word = self.word();
        self.rest = &self.rest[word.len()..];
        if let Some((_, value)) = self.names.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)) {
            return Ok(Quantity::Number(*value));
        }
        let name = word.to_lowercase();
        match name.as_str() {
            "pi" | "π" => Ok(match self.dimension {
                Dimension::Number => Quantity::Number(std::f64::consts::PI),
                Dimension::Angle => Quantity::Degrees(180.0),
            }),
            "sin" | "sen" | "cos" | "tan" | "tg" => {
                let (sin, cos) = match self.parenthesis(Dimension::Angle)? {
                    Quantity::Degrees(degrees) => Angle::from_degrees(degrees).sin_cos(),
                    Quantity::Number(radians) => radians.sin_cos(),
                };
                Ok(Quantity::Number(match name.as_str() {
                    "sin" | "sen" => sin,
                    "cos" => cos,
                    _ => sin / cos,
                }))
            }
            "asin" | "arcsin" | "arcsen" | "acos" | "arccos" | "atan" | "arctan" | "arctg" | "sqrt" | "raiz"
            | "abs" | "exp" | "ln" => {
                let inside = self.at();
                let v = self.parenthesis(Dimension::Number)?.number();
                let v = self.unmixed(inside, v)?;
                Ok(match name.as_str() {
                    "asin" | "arcsin" | "arcsen" => Quantity::Degrees(v.asin().to_degrees()),
                    "acos" | "arccos" => Quantity::Degrees(v.acos().to_degrees()),
                    "atan" | "arctan" | "arctg" => Quantity::Degrees(v.atan().to_degrees()),
                    "abs" => Quantity::Number(v.abs()),
                    "exp" => Quantity::Number(v.exp()),
                    "ln" => Quantity::Number(v.ln()),
                    _ => Quantity::Number(v.sqrt()),
                })
            }
            _ => Err(self.error(start, ExpressionProblem::UnknownName(word.to_owned()))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::ExpressionProblem as E;
    use super::*;

    fn number(text: &str) -> Result<f64, E> {
        evaluate(text, Dimension::Number).map_err(|error| error.problem)
    }

    fn angle(text: &str) -> Result<f64, E> {
        evaluate(text, Dimension::Angle).map_err(|error| error.problem)
    }

    #[test]
    fn what_people_type_is_understood() {
        for (text, value) in [
            ("7", 7.0),
            (" 12,5 ", 12.5),
            (".5", 0.5),
            ("5.", 5.0),
            ("−3", -3.0),
            ("--3", 3.0),
            ("2e3", 2000.0),
            ("1E-2", 0.01),
            ("1/3", 1.0 / 3.0),
            ("1/2/2", 0.25),
            ("2-3-4", -5.0),
            ("sqrt(2)/2", std::f64::consts::SQRT_2 / 2.0),
            ("2√2", 2.0 * std::f64::consts::SQRT_2),
            ("pi/3", std::f64::consts::PI / 3.0),
            ("2pi", std::f64::consts::TAU),
            ("-2^2", -4.0),
            ("2^3^2", 512.0),
            ("2^-1", 0.5),
            ("(1+2)(3+4)", 21.0),
            ("cos(60°)", 0.5),
            ("90°/45°", 2.0),
            ("1,25×2", 2.5),
            ("tan(45°)", 1.0),
        ] {
            let found = number(text).unwrap_or(f64::NAN);
            assert!((found - value).abs() <= 4.0 * f64::EPSILON * value.abs(), "{text}: {found}, not {value}");
        }
    }

    #[test]
    fn angles_come_out_in_degrees() {
        for (text, degrees) in [
            ("45°", 45.0),
            ("45", 45.0),
            ("pi/3", 60.0),
            ("π", 180.0),
            ("pi/3 rad", 60.0),
            ("-30°", -30.0),
            ("90°/2", 45.0),
            ("2·22,5°", 45.0),
        ] {
            assert_eq!(angle(text), Ok(degrees), "{text}");
        }
        assert!((angle("1 rad").unwrap_or(0.0) - 57.295_779_513_082_32).abs() < 1e-13);
        assert!((angle("2 atan(0,5)").unwrap_or(0.0) - 53.130_102_354_155_98).abs() < 1e-13);
    }

    #[test]
    fn nonsense_is_named() {
        for (text, error) in [
            ("", E::Empty),
            (" ", E::Empty),
            ("1 +", E::Unfinished),
            ("(1 + 2", E::MissingParenthesis),
            ("1)", E::Unexpected(')')),
            ("1.000,5", E::Unexpected(',')),
            ("1 2", E::Unexpected('2')),
            ("1;2", E::Unexpected(';')),
            ("abc", E::UnknownName("abc".into())),
            ("nan", E::UnknownName("nan".into())),
            ("2e", E::UnknownName("e".into())),
            ("1/0", E::NotFinite),
            ("1e400", E::NotFinite),
            ("sqrt(-1)", E::NotFinite),
            ("45°", E::MixedUnits),
            ("1 + 45°", E::MixedUnits),
            (".", E::Unfinished),
            ("sin 3", E::Unexpected('3')),
        ] {
            assert_eq!(number(text), Err(error), "{text:?}");
        }
    }

    #[test]
    fn faults_say_where_they_are() {
        for (text, dimension, at) in [
            ("2*atn(1/2)", Dimension::Angle, "atn"),
            ("1 + 45° + 2", Dimension::Number, "1 + 45°"),
            ("(2 · 45°²)", Dimension::Number, "²"),
            ("√(45°)", Dimension::Number, "(45°)"),
            (" 1/0 ", Dimension::Number, "1/0"),
            ("3 $ 4", Dimension::Number, "$"),
            ("2 − x", Dimension::Number, "x"),
            ("(1 + 2", Dimension::Number, ""),
            ("1 +", Dimension::Number, ""),
        ] {
            let error = evaluate(text, dimension).expect_err(text);
            assert_eq!(&text[error.span.clone()], at, "{text}");
            assert!(!at.is_empty() || error.span.start == text.len(), "{text}");
        }
    }

    #[test]
    fn a_fault_is_marked_on_one_line() {
        for (text, span, shown) in [
            ("2*atn(1/2)", 2..5, "2*▸atn◂(1/2)"),
            ("(1 + 2", 6..6, "(1 + 2▸◂"),
            ("", 0..0, "▸◂"),
            ("1\n°", 2..4, "1 ▸°◂"),
        ] {
            assert_eq!(marked(text, &span), shown);
        }
        let long = marked(&"1+".repeat(200), &(300..301));
        assert!(long.chars().count() < 50 && long.starts_with("…") && long.contains("▸1◂") && long.ends_with("…"));
    }

    #[test]
    fn lists_are_cut_at_commas_or_at_semicolons() {
        for (text, expected) in [
            ("1,2,3", &["1", "2", "3"][..]),
            ("sqrt(2)/2,0,0", &["sqrt(2)/2", "0", "0"]),
            ("max(1,2),(3", &["max(1,2)", "(3"]),
            ("0,5;1;", &["0,5", "1", ""]),
            ("", &[""]),
        ] {
            assert_eq!(parts(text).collect::<Vec<_>>(), expected, "{text}");
        }
    }

    #[test]
    fn depth_and_length_are_bounded() {
        for text in ["(".repeat(400), "√".repeat(400), "1".repeat(2000), "2^".repeat(200), "sqrt(".repeat(90)] {
            assert_eq!(number(&text), Err(E::TooLong), "{text}");
        }
        assert_eq!(number(&"-".repeat(499)), Err(E::Unfinished));
    }
}
