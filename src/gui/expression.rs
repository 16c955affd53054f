//! What one may type into a number field: `sqrt(2)/2`, `45°`, `pi/3`, `1/3`, `12,5`, `−3`, `2e3`.
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
//! A comma is a decimal point. An angle is a quantity of its own: degrees do not add to lengths, and `sin(30°)` is exactly ½.
//! Where an angle is expected, `pi` is 180° and a plain number is in degrees.

use crate::geometry::Angle;
use crate::i18n::window::Texts;

/// What the field is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A length, a factor, a ratio, a count.
    Number,
    /// An angle; the result is in degrees.
    Angle,
}

/// Why a text is no number.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ExpressionError {
    /// Nothing was typed.
    #[error("a number is missing")]
    Empty,
    /// A character that has no meaning there.
    #[error("unexpected “{0}”")]
    Unexpected(char),
    /// The text ends where something must follow.
    #[error("the expression is not finished")]
    Unfinished,
    /// A word that is neither a function nor a constant.
    #[error("unknown name “{0}”")]
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

impl ExpressionError {
    /// The reason in the language of the window.
    #[must_use]
    pub fn text(&self, t: &Texts) -> String {
        match self {
            Self::Empty => t.missing_number.to_owned(),
            Self::Unexpected(c) => format!("{} “{c}”", t.unexpected),
            Self::Unfinished => t.unfinished.to_owned(),
            Self::UnknownName(name) => format!("{} “{name}”", t.unknown_name),
            Self::MissingParenthesis => t.missing_parenthesis.to_owned(),
            Self::MixedUnits => t.mixed_units.to_owned(),
            Self::NotFinite => t.not_finite.to_owned(),
            Self::TooLong => t.too_long.to_owned(),
        }
    }
}

/// The value of `text`; of an angle, its degrees.
///
/// # Errors
/// [`ExpressionError`] says what is wrong. Never infinite, never NaN.
pub fn evaluate(text: &str, kind: Kind) -> Result<f64, ExpressionError> {
    if text.trim().is_empty() {
        return Err(ExpressionError::Empty);
    }
    if text.chars().count() > 500 {
        return Err(ExpressionError::TooLong);
    }
    let mut parser = Parser { rest: text, kind, depth: 0 };
    let mut value = parser.sum()?;
    if parser.eat_word("rad") {
        value = match value {
            Quantity::Number(radians) => Quantity::Degrees(radians.to_degrees()),
            degrees @ Quantity::Degrees(_) => degrees,
        };
    }
    if let Some(c) = parser.peek() {
        return Err(ExpressionError::Unexpected(c));
    }
    let value = match (value, kind) {
        (Quantity::Number(v) | Quantity::Degrees(v), Kind::Angle) | (Quantity::Number(v), Kind::Number) => v,
        (Quantity::Degrees(_), Kind::Number) => return Err(ExpressionError::MixedUnits),
    };
    if value.is_finite() { Ok(value) } else { Err(ExpressionError::NotFinite) }
}

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

    fn number(self) -> Result<f64, ExpressionError> {
        match self {
            Self::Number(v) => Ok(v),
            Self::Degrees(_) => Err(ExpressionError::MixedUnits),
        }
    }

    fn add(self, other: Self, sign: f64) -> Result<Self, ExpressionError> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Ok(Self::Number(a + sign * b)),
            (Self::Degrees(a), Self::Degrees(b)) => Ok(Self::Degrees(a + sign * b)),
            _ => Err(ExpressionError::MixedUnits),
        }
    }

    fn times(self, other: Self) -> Result<Self, ExpressionError> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Ok(Self::Number(a * b)),
            (Self::Number(a), Self::Degrees(b)) | (Self::Degrees(a), Self::Number(b)) => Ok(Self::Degrees(a * b)),
            (Self::Degrees(_), Self::Degrees(_)) => Err(ExpressionError::MixedUnits),
        }
    }

    fn over(self, other: Self) -> Result<Self, ExpressionError> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) | (Self::Degrees(a), Self::Degrees(b)) => Ok(Self::Number(a / b)),
            (Self::Degrees(a), Self::Number(b)) => Ok(Self::Degrees(a / b)),
            (Self::Number(_), Self::Degrees(_)) => Err(ExpressionError::MixedUnits),
        }
    }
}

struct Parser<'a> {
    rest: &'a str,
    kind: Kind,
    depth: u32,
}

/// Nesting that nobody types by hand; keeps the stack small.
const MAX_DEPTH: u32 = 60;

impl<'a> Parser<'a> {
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
        let mut value = self.product()?;
        while let Some(c) = self.eat(&['+', '-', '−', '–']) {
            let other = self.product()?;
            value = value.add(other, if c == '+' { 1.0 } else { -1.0 })?;
        }
        Ok(value)
    }

    fn product(&mut self) -> Result<Quantity, ExpressionError> {
        let mut value = self.sign()?;
        loop {
            value = if self.eat(&['*', '×', '·']).is_some() {
                value.times(self.sign()?)?
            } else if self.eat(&['/', '÷']).is_some() {
                value.over(self.sign()?)?
            } else if self.starts_factor() {
                value.times(self.power()?)?
            } else {
                return Ok(value);
            };
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
            return Err(ExpressionError::TooLong);
        }
        let mut value = self.unit()?;
        if self.eat(&['^']).is_some() {
            let exponent = self.sign()?.number()?;
            value = Quantity::Number(value.number()?.powf(exponent));
        }
        self.depth -= 1;
        Ok(value)
    }

    fn unit(&mut self) -> Result<Quantity, ExpressionError> {
        let mut value = self.atom()?;
        while self.eat(&['°', 'º']).is_some() {
            value = Quantity::Degrees(value.number()?);
        }
        Ok(value)
    }

    fn atom(&mut self) -> Result<Quantity, ExpressionError> {
        match self.peek() {
            None => Err(ExpressionError::Unfinished),
            Some('(') => self.parenthesis(self.kind),
            Some('√') => {
                self.eat(&['√']);
                self.depth += 1;
                if self.depth > MAX_DEPTH {
                    return Err(ExpressionError::TooLong);
                }
                let value = self.unit()?.number()?.sqrt();
                self.depth -= 1;
                Ok(Quantity::Number(value))
            }
            Some(c) if c.is_ascii_digit() || c == '.' || c == ',' => self.literal(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some(c) => Err(ExpressionError::Unexpected(c)),
        }
    }

    fn parenthesis(&mut self, kind: Kind) -> Result<Quantity, ExpressionError> {
        match self.peek() {
            None => return Err(ExpressionError::Unfinished),
            Some('(') => self.eat(&['(']),
            Some(c) => return Err(ExpressionError::Unexpected(c)),
        };
        let outer = std::mem::replace(&mut self.kind, kind);
        let value = self.sum()?;
        self.kind = outer;
        match self.peek() {
            None => Err(ExpressionError::MissingParenthesis),
            Some(')') => {
                self.eat(&[')']);
                Ok(value)
            }
            Some(c) => Err(ExpressionError::Unexpected(c)),
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
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        let value: f64 = text.replace(',', ".").parse().map_err(|_| ExpressionError::Unfinished)?;
        if let Some(c @ ('.' | ',' | '0'..='9')) = self.peek() {
            return Err(ExpressionError::Unexpected(c));
        }
        Ok(Quantity::Number(value))
    }

    fn name(&mut self) -> Result<Quantity, ExpressionError> {
        let word = self.word();
        self.rest = &self.rest[word.len()..];
        let name = word.to_lowercase();
        match name.as_str() {
            "pi" | "π" => Ok(match self.kind {
                Kind::Number => Quantity::Number(std::f64::consts::PI),
                Kind::Angle => Quantity::Degrees(180.0),
            }),
            "sin" | "sen" | "cos" | "tan" | "tg" => {
                let (sin, cos) = match self.parenthesis(Kind::Angle)? {
                    Quantity::Degrees(degrees) => Angle::from_degrees(degrees).sin_cos(),
                    Quantity::Number(radians) => radians.sin_cos(),
                };
                Ok(Quantity::Number(match name.as_str() {
                    "sin" | "sen" => sin,
                    "cos" => cos,
                    _ => sin / cos,
                }))
            }
            "asin" | "acos" | "atan" | "sqrt" | "raiz" | "abs" | "exp" | "ln" => {
                let v = self.parenthesis(Kind::Number)?.number()?;
                Ok(match name.as_str() {
                    "asin" => Quantity::Degrees(v.asin().to_degrees()),
                    "acos" => Quantity::Degrees(v.acos().to_degrees()),
                    "atan" => Quantity::Degrees(v.atan().to_degrees()),
                    "abs" => Quantity::Number(v.abs()),
                    "exp" => Quantity::Number(v.exp()),
                    "ln" => Quantity::Number(v.ln()),
                    _ => Quantity::Number(v.sqrt()),
                })
            }
            _ => Err(ExpressionError::UnknownName(word.to_owned())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::ExpressionError as E;
    use super::*;

    fn number(text: &str) -> Result<f64, E> {
        evaluate(text, Kind::Number)
    }

    fn angle(text: &str) -> Result<f64, E> {
        evaluate(text, Kind::Angle)
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
    fn depth_and_length_are_bounded() {
        for text in ["(".repeat(400), "√".repeat(400), "1".repeat(2000), "2^".repeat(200), "sqrt(".repeat(90)] {
            assert_eq!(number(&text), Err(E::TooLong), "{text}");
        }
        assert_eq!(number(&"-".repeat(499)), Err(E::Unfinished));
    }
}
